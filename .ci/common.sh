# SPDX-License-Identifier: LGPL-2.1-or-later
# Functions for the other scripts here, which source it: timed steps, packages, build. For root, or with sudo.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
cd "$root"
export LC_ALL=C.UTF-8
# FreeCAD and its modules need the Python of the system, even if PATH has another one first.
python=/usr/bin/python3
jobs=$(nproc)
step_name="start"
step_start=$SECONDS
trap 'echo "FAILED in step: $step_name" >&2' ERR

step() {
  [ "$step_name" = start ] || echo "=== $step_name: $((SECONDS - step_start)) s"
  step_name=$1
  step_start=$SECONDS
  echo "=== $step_name"
}

finish() {
  echo "=== $step_name: $((SECONDS - step_start)) s"
  echo "=== all done in $SECONDS s"
}

as_root() {
  if [ "$(id -u)" = 0 ]; then "$@"; else sudo "$@"; fi
}

is_installed() {
  dpkg-query -W -f '${Status}' "$1" 2>/dev/null | grep -q '^install ok installed$'
}

install_packages() {
  command -v dpkg-query >/dev/null || {
    echo "This is no Debian: install what .ci/packages.txt names by hand, then build with" >&2
    echo "cmake --preset release && cmake --build build" >&2
    return 1
  }
  local wanted=() missing=() name
  mapfile -t wanted < <(grep -v '^#' .ci/packages.txt)
  for name in "${wanted[@]}"; do
    is_installed "$name" || missing+=("$name")
  done
  if [ ${#missing[@]} = 0 ]; then
    echo "nothing to install"
    return 0
  fi
  echo "installing: ${missing[*]}"
  as_root apt-get update -q
  as_root env DEBIAN_FRONTEND=noninteractive \
    apt-get install -q -y --no-install-recommends "${missing[@]}"
}

# check_sizes FOLDER: fails if a wheel there is larger than the size that the workbench shows before it installs one.
check_sizes() {
  local most large
  most=$(sed -n 's/^PACKAGE, SIZE = .*, \([0-9]*\)$/\1/p' workbench/sweptvolume/core_install.py)
  large=$(find "$1" -name '*.whl' -size +"${most}000000c")
  [ -n "$most" ] && [ -z "$large" ] || { echo "larger than SIZE in core_install.py ($most MB), which has to be raised: $large" >&2; return 1; }
}

# build PRESET FOLDER [TARGET...]: configures with a preset of CMake, and builds; goes on after an error.
build() {
  local preset=$1 folder=$2
  shift 2
  cmake --preset "$preset" >"$folder.configure.log" 2>&1 ||
    { cat "$folder.configure.log"; return 1; }
  rm -f "$folder.configure.log"
  cmake --build "$folder" --parallel "$jobs" ${1:+--target "$@"} -- -k 0
}
