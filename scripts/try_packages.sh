#!/bin/sh
# Tries the packages of scripts/make_packages.sh on a Debian 12 that has nothing else: installs them there with apt, and
# uses the program, its manual pages and completion, builds and runs the C++ examples, and runs some in Python.
# Usage: scripts/try_packages.sh ROOT [PACKAGES]      as root; needs debootstrap
# ROOT, a folder of 3 GB, is made where it is not there, and kept: a second time takes less. PACKAGES is
# build/release/packages unless given. What apt of this machine knows of proxies is taken over.
# OCELLI_DEBIAN_MIRROR names another mirror than deb.debian.org.
set -eu
top=$(cd "$(dirname "$0")/.." && pwd)

fail() {
  echo "try_packages: $1" >&2
  exit 1
}
[ $# -ge 1 ] && [ $# -le 2 ] || fail "usage: $0 ROOT [PACKAGES]"
[ "$(id -u)" = 0 ] || fail "a root can only be made by root: start this with sudo"
command -v debootstrap >/dev/null || fail "debootstrap is missing: apt-get install debootstrap"
packages=${2-$top/build/release/packages}
ls "$packages"/ocelli_*.deb >/dev/null 2>&1 || fail "no packages in $packages: make them with scripts/make_packages.sh"

if [ ! -e "$1/var/lib/apt" ]; then
  debootstrap --variant=minbase bookworm "$1" "${OCELLI_DEBIAN_MIRROR-http://deb.debian.org/debian}"
fi
root=$(cd "$1" && pwd)
[ "$root" != / ] || fail "the root of this machine is not empty: name another folder"
cp /etc/resolv.conf "$root/etc/resolv.conf"
cp -r /etc/apt/apt.conf.d "$root/etc/apt/"
rm -rf "$root/packages"
mkdir "$root/packages"
cp "$packages"/*.deb "$root/packages"

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

cat >"$root/packages/try.sh" <<'INSIDE'
set -eu
export DEBIAN_FRONTEND=noninteractive LC_ALL=C.UTF-8 HOME=/root
say() {
  printf '\n== %s\n' "$1"
}
apt_install() {
  apt-get install -qq -y --no-install-recommends "$@" </dev/null >/packages/apt.log 2>&1 || {
    tail -n 20 /packages/apt.log >&2
    exit 1
  }
}
# Of a run before.
apt-get purge -qq -y ocelli libocelli-dev python3-ocelli ocelli-doc >/dev/null 2>&1 || true
rm -rf /try
mkdir /try
cd /try
apt-get update -qq

say "The program alone"
apt_install /packages/ocelli_*.deb
ocelli --version
ocelli --help | head -n 5
ocelli doctor || true  # tells what is missing: here windows, and OpenGL where there is no driver
ocelli demo --quiet --only --size 360x240 -o /try/demo builtin:statues
ls -s /try/demo/index.html

say "Its menu entry, icon and rule for displays on USB"
apt_install desktop-file-utils
desktop-file-validate /usr/share/applications/ocelli.desktop
ls /usr/share/icons/hicolor/scalable/apps/ocelli.svg /lib/udev/rules.d/*ocelli.rules

say "Manual pages"
apt_install man-db
for page in /usr/share/man/man1/ocelli*.1.gz; do
  warnings=$(MANWIDTH=100 man --warnings -l "$page" 2>&1 >/packages/page)
  [ -s /packages/page ] && [ -z "$warnings" ] || { echo "$page: $warnings" >&2; exit 1; }
done
MANWIDTH=100 man ocelli-render | head -n 6

say "Completion"
apt_install bash-completion zsh
bash -c '
  . /usr/share/bash-completion/bash_completion
  _completion_loader ocelli
  COMP_WORDS=(ocelli ocri bu) COMP_CWORD=2
  _ocelli
  echo "bash: ocelli ocri bu... ${COMPREPLY[*]}"
  [ "${COMPREPLY[*]}" = build ]'
zsh -f -c 'autoload -U compinit && compinit -u && echo "zsh: ${_comps[ocelli]}" && [ "${_comps[ocelli]}" = _ocelli ]'

say "The C++ examples"
apt_install /packages/libocelli-dev_*.deb /packages/ocelli-doc_*.deb g++ cmake ninja-build
for project in /usr/share/doc/ocelli-doc/examples/*/CMakeLists.txt; do
  folder=$(dirname "$project")
  name=$(basename "$folder")
  grep find_package "$project"
  cmake -S "$folder" -B "/try/$name" -G Ninja -DCMAKE_BUILD_TYPE=Release >/packages/cmake.log 2>&1 \
    && cmake --build "/try/$name" >>/packages/cmake.log 2>&1 || { tail -n 30 /packages/cmake.log >&2; exit 1; }
  argument=""
  if [ -e "$folder/react.json" ]; then
    argument="$folder/react.json"
  fi
  # shellcheck disable=SC2086  # no argument, or one
  (cd "/try/$name" && "./$name" $argument | tail -n 3)
done

say "The examples in Python"
apt_install /packages/python3-ocelli_*.deb python3-matplotlib
for example in beyond_the_pinhole a_volumetric_display your_own_camera; do
  python3 "/usr/share/doc/ocelli-doc/examples/python/$example.py" /try/python
done

say "The documentation"
ls /usr/share/doc/ocelli-doc
[ -s /usr/share/doc/ocelli-doc/html/index.html ] || { echo "there is no reference of the API: make it before the packages" >&2; exit 1; }

say "Away with them again"
apt-get purge -qq -y ocelli libocelli-dev python3-ocelli ocelli-doc >/dev/null
left=$(find / -xdev -iname '*ocelli*' -not -path '/packages/*' -not -path '/try/*' -not -path '/proc/*' -not -path '/var/*' -not -path '/dev/*')
[ -z "$left" ] || { echo "left behind: $left" >&2; exit 1; }
echo "All of it works."
INSIDE
chroot "$root" sh /packages/try.sh
