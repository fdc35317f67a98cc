#!/usr/bin/env bash
# clang-tidy over the product's sources.
#   scripts/tidy.sh          what has changed since the commit in .ci/tidy-base: a starting point, no proof for what is older
#   scripts/tidy.sh --all    all; once they pass, .ci/tidy-base names the current commit
# A changed header is checked through the source of its name, or else through one source that includes it. Changed checks
# (.clang-tidy), or a history that lacks the commit, mean all.
set -euo pipefail
cd "$(dirname "$0")/.."
folders=(base warp morph samples cli)
base=$(cat .ci/tidy-base)

check() {
  local pattern
  pattern=$(printf '|%s' "$@")
  # Its own compilation database: clang cannot read the headers that g++ has precompiled.
  mkdir -p build
  cmake --preset release -B build/tidy -D CMAKE_DISABLE_PRECOMPILE_HEADERS=ON > build/tidy.log || {
    cat build/tidy.log
    return 1
  }
  run-clang-tidy -quiet -p build/tidy -j "$(nproc)" "^$PWD/(${pattern:1})"
}

changed_sources() {
  local file
  git diff --name-only --diff-filter=d "$base" -- "${folders[@]/%//*.cpp}"
  git diff --name-only --diff-filter=d "$base" -- "${folders[@]/%//*.h}" | while read -r file; do
    if [[ -f ${file%.h}.cpp ]]; then
      echo "${file%.h}.cpp"
    else
      git grep -lF "#include \"$file\"" -- "${folders[@]/%//*.cpp}" | head -n 1 || true
    fi
  done
}

if [[ ${1-} == --all ]]; then
  check "${folders[@]/%//}"
  git rev-parse HEAD > .ci/tidy-base
elif ! git cat-file -e "$base^{commit}" 2> /dev/null || ! git diff --quiet "$base" -- .clang-tidy; then
  echo "All sources: $base is not in the history, or the checks have changed since"
  check "${folders[@]/%//}"
else
  mapfile -t sources < <(changed_sources | sort -u)
  echo "${#sources[@]} sources have changed since $base"
  ((${#sources[@]} == 0)) || check "${sources[@]/%/\$}"
fi
