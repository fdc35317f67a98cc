#!/usr/bin/env bash
# Builds morphkit and renders the sample morphs.
#   scripts/demo.sh [DIRECTORY]    default: out/demo
set -euo pipefail
cd "$(dirname "$0")/.."

scripts/deps.sh
cmake --preset release
cmake --build --preset release --target morphkit_cli
build/release/bin/morphkit demo -o "${1-out/demo}"
