#!/usr/bin/env bash
# Installs with apt what building and running morphkit needs and the machine lacks.
#   scripts/deps.sh [--ci]      --ci: also the compilers, the checkers and the desktop that .ci/run uses
set -euo pipefail

packages=(
  g++ cmake ninja-build ccache pkg-config git
  libopencv-dev libopenimageio-dev openimageio-tools libwebp-dev liblcms2-dev zlib1g-dev libtbb-dev libhwy-dev
  libcli11-dev nlohmann-json3-dev libfmt-dev
  libgtest-dev libgmock-dev libbenchmark-dev
  ffmpeg # at run time: video goes through the program
  fonts-dejavu-core # at run time: the type of the preview tool
)
case "${1-}" in
  "") ;;
  --ci)
    packages+=(clang clang-format clang-tidy libclang-rt-14-dev xvfb openbox xdotool imagemagick)
    packages+=(dpkg-dev file desktop-file-utils man-db) # the Debian package and what is in it
    ;;
  *) echo "usage: scripts/deps.sh [--ci]" >&2; exit 2 ;;
esac

command -v dpkg-query > /dev/null && command -v apt-get > /dev/null || {
  echo "scripts/deps.sh: this needs Debian 12 or a relative with apt-get. Elsewhere, install the equivalents of:" >&2
  echo "  ${packages[*]}" >&2
  exit 1
}

missing=()
for package in "${packages[@]}"; do
  status=$(dpkg-query -W -f '${db:Status-Status}' "$package" 2> /dev/null || true)
  [[ $status == installed ]] || missing+=("$package")
done
((${#missing[@]})) || exit 0

as_root=()
if ((EUID != 0)); then
  command -v sudo > /dev/null || {
    echo "scripts/deps.sh: no sudo here. As root, run:" >&2
    echo "  apt-get update && apt-get install --no-install-recommends ${missing[*]}" >&2
    exit 1
  }
  as_root=(sudo)
fi

echo "Installing ${missing[*]}"
"${as_root[@]}" apt-get update
"${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get install -y --no-install-recommends "${missing[@]}"
