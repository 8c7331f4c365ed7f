#!/bin/sh
# Runs the shell script on standard input, as root, in a Debian 12 that has nothing installed but what it must have.
# Usage: scripts/in_debian.sh ROOT [FILE...]      as root; needs debootstrap
# ROOT is a folder, which is made where it is not there, and kept. The files lie in /given there. What this machine knows of
# names and proxies is taken over. OCELLI_DEBIAN_MIRROR names another mirror than deb.debian.org.
set -eu

fail() {
  echo "in_debian: $1" >&2
  exit 1
}
[ $# -ge 1 ] || fail "usage: $0 ROOT [FILE...] <SCRIPT"
[ "$(id -u)" = 0 ] || fail "only root can enter another root: start this with sudo"
command -v debootstrap >/dev/null || fail "debootstrap is missing: apt-get install debootstrap"
[ -e "$1/var/lib/apt" ] || debootstrap --variant=minbase bookworm "$1" "${OCELLI_DEBIAN_MIRROR-http://deb.debian.org/debian}" >&2
root=$(cd "$1" && pwd -P)
[ "$root" != / ] || fail "the root of this machine is not empty: name another folder"
shift

cp /etc/resolv.conf "$root/etc/resolv.conf"
if [ -d /etc/apt/apt.conf.d ]; then
  cp -r /etc/apt/apt.conf.d "$root/etc/apt/"
fi
rm -rf "$root/given"
mkdir "$root/given"
[ $# = 0 ] || cp "$@" "$root/given"

# Nothing of this machine may be left in it when somebody removes it.
leave() {
  for place in proc dev; do
    if mountpoint -q "$root/$place"; then
      umount "$root/$place"
    fi
  done
}
trap leave EXIT
trap 'exit 130' INT TERM
mountpoint -q "$root/proc" || mount -t proc proc "$root/proc"
mountpoint -q "$root/dev" || mount --bind /dev "$root/dev"
cat >"$root/given/script.sh"
env -i PATH=/usr/local/sbin:/usr/local/bin:/usr/sbin:/usr/bin:/sbin:/bin HOME=/root LC_ALL=C.UTF-8 DEBIAN_FRONTEND=noninteractive \
  chroot "$root" sh -eu /given/script.sh </dev/null
