# SPDX-License-Identifier: LGPL-2.1-or-later
# Sourced after common.sh by scripts that use chroots of other Debian releases, as root. About 3 GB each; they
# stay in build-matrix/ and are used again. SWEPT_MIRROR names another mirror of Debian.
[ "$(id -u)" = 0 ] || { echo "chroots can only be made as root" >&2; exit 1; }
# What is mounted here is seen by this run alone and gone with it, however it ends: whoever deletes a
# chroot with /dev mounted into it deletes /dev.
[ -n "${SWEPT_OWN_MOUNTS:-}" ] || SWEPT_OWN_MOUNTS=1 exec unshare --mount "$root/.ci/$(basename "$0")" "$@"
mirror=${SWEPT_MIRROR:-} # empty: the default of debootstrap

inside() { chroot "$chroot_folder" env HOME=/root LC_ALL=C.UTF-8 DEBIAN_FRONTEND=noninteractive "$@"; }

# open_chroot SUITE FOLDER: makes the chroot unless it is there, and mounts what programs in it need.
open_chroot() {
  local place suite=$1 script=/usr/share/debootstrap/scripts/$1
  chroot_folder=$2
  mkdir -p "$chroot_folder"
  [ -e "$chroot_folder.made" ] || {
    command -v debootstrap >/dev/null || as_root apt-get install -q -y debootstrap
    [ -e "$script" ] || script=/usr/share/debootstrap/scripts/sid
    debootstrap --variant=minbase "$suite" "$chroot_folder" "$mirror" "$script" >"$chroot_folder.log" ||
      { tail "$chroot_folder.log"; return 1; }
    # Stored copies of a testing release may be past their date.
    echo 'Acquire::Check-Valid-Until "false";' >"$chroot_folder/etc/apt/apt.conf.d/99-stored"
    touch "$chroot_folder.made"
  }
  mount --bind "$chroot_folder" "$chroot_folder" # a root that can be mounted over, as one test does
  for place in proc dev dev/pts sys; do mount --bind "/$place" "$chroot_folder/$place"; done
}

# make_system SUITE TARGETS: a chroot with all packages and the built targets, in $folder (relative). The
# working tree stands in /opt/repository there.
make_system() {
  local suite=$1 targets=$2 wanted=() launcher=-DCMAKE_CXX_COMPILER_LAUNCHER= # not this system's
  step "$suite: chroot"
  open_chroot "$suite" "$root/build-matrix/$suite"
  mkdir -p "$chroot_folder"/opt/repository "$chroot_folder"/opt/shared
  mount --bind "$root" "$chroot_folder/opt/repository"
  [ ! -d "$root/../shared" ] || mount --bind "$root/../shared" "$chroot_folder/opt/shared"
  step "$suite: packages"
  # Formatters and compilers of Debian 12 are not needed here.
  mapfile -t wanted < <(grep -v -e '^#' -e clang -e black -e flake8 .ci/packages.txt)
  [ "$suite" = trixie ] || wanted+=(qt6-svg-plugins) # check marks of FreeCAD's themes
  inside apt-get update -q
  inside apt-get install -q -y --no-install-recommends "${wanted[@]}"
  step "$suite: build"
  folder=build-matrix/build-$suite
  ! inside which ccache >/dev/null || launcher+=ccache
  inside bash -c "cd /opt/repository &&
    cmake -S . -B $folder -G Ninja -DCMAKE_BUILD_TYPE=Release $launcher &&
    cmake --build $folder --parallel $jobs --target $targets"
}
