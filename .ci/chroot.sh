# SPDX-License-Identifier: LGPL-2.1-or-later
# Functions for scripts that use chroots of other Debian releases, as root; source it after common.sh. Each
# chroot takes about 3 GB. It stays in build-matrix/ and is used again. SWEPT_MIRROR: another mirror of Debian.
[ "$(id -u)" = 0 ] || { echo "chroots can only be made as root" >&2; exit 1; }
# Only this run sees its mounts, and they end with it even if it is killed. Otherwise /dev could
# stay mounted in a chroot, and deleting the chroot would delete the files of /dev.
[ -n "${SWEPT_OWN_MOUNTS:-}" ] || SWEPT_OWN_MOUNTS=1 exec unshare --mount "$root/.ci/$(basename "$0")" "$@"
mirror=${SWEPT_MIRROR:-} # empty: the default of debootstrap

inside() { chroot "$chroot_folder" env HOME=/root LC_ALL=C.UTF-8 DEBIAN_FRONTEND=noninteractive "$@"; }

# open_chroot SUITE FOLDER: makes the chroot if there is none yet, and mounts what programs in it need.
open_chroot() {
  local place suite=$1 script=/usr/share/debootstrap/scripts/$1
  chroot_folder=$2
  mkdir -p "$chroot_folder"
  [ -e "$chroot_folder.made" ] || {
    command -v debootstrap >/dev/null || as_root apt-get install -q -y debootstrap
    [ -e "$script" ] || script=/usr/share/debootstrap/scripts/sid
    debootstrap --variant=minbase "$suite" "$chroot_folder" "$mirror" "$script" >"$chroot_folder.log" ||
      { tail "$chroot_folder.log"; return 1; }
    # Package lists of a testing release expire soon; a mirror with stored copies may have only expired ones.
    echo 'Acquire::Check-Valid-Until "false";' >"$chroot_folder/etc/apt/apt.conf.d/99-stored"
    touch "$chroot_folder.made"
  }
  mount --bind "$chroot_folder" "$chroot_folder" # `unshare --mount`, in a test, needs a mount point as root
  for place in proc dev dev/pts sys; do mount --bind "/$place" "$chroot_folder/$place"; done
}

# make_system SUITE TARGETS: makes a chroot with all packages, and builds TARGETS there into $folder, which is
# relative to the working tree. In the chroot, the working tree is /opt/repository.
make_system() {
  local suite=$1 targets=$2 wanted=() launcher=-DCMAKE_CXX_COMPILER_LAUNCHER= # no ccache, unless the chroot has it
  step "$suite: chroot"
  open_chroot "$suite" "$root/build-matrix/$suite"
  mkdir -p "$chroot_folder"/opt/repository "$chroot_folder"/opt/shared
  mount --bind "$root" "$chroot_folder/opt/repository"
  [ ! -d "$root/../shared" ] || mount --bind "$root/../shared" "$chroot_folder/opt/shared"
  step "$suite: packages"
  # Formatters and compilers of Debian 12 are not needed here.
  mapfile -t wanted < <(grep -v -e '^#' -e clang -e black -e flake8 .ci/packages.txt)
  [ "$suite" != forky ] || wanted+=(qt6-svg-plugins) # FreeCAD 1.1: check marks of its themes
  inside apt-get update -q
  inside apt-get install -q -y --no-install-recommends "${wanted[@]}"
  step "$suite: build"
  folder=build-matrix/build-$suite
  ! inside which ccache >/dev/null || launcher+=ccache
  inside bash -c "cd /opt/repository &&
    cmake -S . -B $folder -G Ninja -DCMAKE_BUILD_TYPE=Release -DCMAKE_UNITY_BUILD=ON $launcher &&
    cmake --build $folder --parallel $jobs --target $targets"
}
