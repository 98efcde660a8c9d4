# SPDX-License-Identifier: LGPL-2.1-or-later
# Sourced after common.sh by scripts that use chroots of other Debian releases, as root.
[ "$(id -u)" = 0 ] || { echo "chroots can only be made as root" >&2; exit 1; }
# What is mounted here is seen by this run alone and gone with it, however it ends: whoever deletes a
# chroot with /dev mounted into it deletes /dev.
[ -n "${SWEPT_OWN_MOUNTS:-}" ] || SWEPT_OWN_MOUNTS=1 exec unshare --mount "$root/.ci/$(basename "$0")" "$@"
mirror=${SWEPT_MIRROR:-} # empty: the default of debootstrap

inside() { chroot "$chroot_folder" env HOME=/root LC_ALL=C.UTF-8 DEBIAN_FRONTEND=noninteractive "$@"; }

# open_chroot SUITE FOLDER: makes the chroot unless it is there, and mounts what programs in it need.
open_chroot() {
  local suite=$1 script=/usr/share/debootstrap/scripts/$1
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
