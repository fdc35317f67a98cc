#!/usr/bin/env bash
# Renders all golden pictures anew and prints what changed. Look at them before you commit them.
set -euo pipefail
cd "$(dirname "$0")/.."
cmake --preset release >/dev/null
cmake --build --preset release --target test_golden
mkdir -p tests/golden/expected
MORPHKIT_RENEW_GOLDENS=1 build/release/tests/golden/test_golden --gtest_filter='*Golden*' --gtest_brief=1
git status --short tests/golden/expected
