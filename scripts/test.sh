#!/usr/bin/env bash
# Builds morphkit and runs all its tests.
#   scripts/test.sh [PRESET]    PRESET: release (default), dev, asan-ubsan or tsan
set -euo pipefail
cd "$(dirname "$0")/.."
preset=${1-release}

scripts/deps.sh
cmake --preset "$preset"
cmake --build --preset "$preset"
ctest --preset "$preset"
