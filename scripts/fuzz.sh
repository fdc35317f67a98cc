#!/usr/bin/env bash
# Builds all fuzzers and runs them side by side, from their seeds. Finds are left in build/fuzz.
#   scripts/fuzz.sh [SECONDS]    for each; default: 60
set -euo pipefail
cd "$(dirname "$0")/.."
seconds=${1-60}

mapfile -t targets < <(basename -s .cpp tests/fuzz/fuzz_*.cpp)
cmake --preset fuzz
cmake --build --preset fuzz --target "${targets[@]}"

# One fuzzer; its corpus is a copy, for libFuzzer adds what it finds.
run() {
  local target=$1 corpus=build/fuzz/corpus/$1
  rm -rf "$corpus"
  mkdir -p build/fuzz/corpus
  cp -r "tests/fuzz/corpus/$target" "$corpus"
  ASAN_OPTIONS=detect_leaks=0 "build/fuzz/bin/$target" -max_total_time="$seconds" -malloc_limit_mb=512 \
    -print_final_stats=1 -artifact_prefix="build/fuzz/$target-" "$corpus" > "build/fuzz/$target.log" 2>&1
}

jobs=()
for target in "${targets[@]}"; do
  run "$target" &
  jobs+=($!)
done
failed=0
for i in "${!targets[@]}"; do
  if wait "${jobs[i]}"; then
    echo "${targets[i]}: $(grep -E 'stat::number_of_executed_units' "build/fuzz/${targets[i]}.log")"
  else
    echo "${targets[i]} found something:"
    tail -n 60 "build/fuzz/${targets[i]}.log"
    failed=1
  fi
done
exit "$failed"
