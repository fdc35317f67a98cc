#!/usr/bin/env bash
# The whole of what .ci/run limits: clang-tidy over every source, all tests with sanitizers, a longer fuzz run.
# Takes about an hour and a half on two cores. Commit .ci/tidy-base afterwards: .ci/run starts from there.
set -euo pipefail
cd "$(dirname "$0")/.."
source scripts/stages.sh
export CCACHE_BASEDIR=$PWD CCACHE_NOHASHDIR=1

stage "dependencies"
scripts/deps.sh --ci

stage "tests (release)"
scripts/test.sh release

stage "clang-tidy"
scripts/tidy.sh --all

stage "fuzzing"
scripts/fuzz.sh 600

stage "tests (address and undefined-behaviour sanitizers)"
scripts/test.sh asan-ubsan

finish
