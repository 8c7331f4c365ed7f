#!/bin/sh
# Tries the packages of scripts/make_packages.sh on a Debian 12 that has nothing else: installs them there with apt, and
# uses the program, its manual pages and completion, builds and runs the C++ examples, and runs some in Python.
# Usage: scripts/try_packages.sh ROOT [PACKAGES]      as root; needs debootstrap
# ROOT, a folder of 3 GB, is made where it is not there, and kept: a second time takes less (scripts/in_debian.sh).
# PACKAGES is build/release/packages unless given.
set -eu
top=$(cd "$(dirname "$0")/.." && pwd)

[ $# -ge 1 ] && [ $# -le 2 ] || { echo "usage: $0 ROOT [PACKAGES]" >&2; exit 2; }
packages=${2-$top/build/release/packages}
if ! ls "$packages"/ocelli_*.deb >/dev/null 2>&1; then
  echo "try_packages: no packages in $packages: make them with scripts/make_packages.sh" >&2
  exit 1
fi

"$top/scripts/in_debian.sh" "$1" "$packages"/*.deb <<'INSIDE'
say() {
  printf '\n== %s\n' "$1"
}
apt_install() {
  apt-get install -qq -y --no-install-recommends "$@" </dev/null >/given/apt.log 2>&1 || {
    tail -n 20 /given/apt.log >&2
    exit 1
  }
}
# Of a run before.
apt-get purge -qq -y ocelli ocelli-feeds libocelli-dev python3-ocelli ocelli-doc >/dev/null 2>&1 || true
rm -rf /try
mkdir /try
cd /try
apt-get update -qq

say "The program alone"
apt_install /given/ocelli_*.deb
ocelli --version
ocelli --help | head -n 5
ocelli doctor || true  # tells what is missing: here windows, and OpenGL where there is no driver
ocelli demo --quiet --only --size 360x240 -o /try/demo builtin:statues
ls -s /try/demo/index.html

say "Graph cameras from video"
apt_install /given/ocelli-feeds_*.deb
ocelli feeds simulate builtin:corridor_t,texel=0.15 --seconds 1 --quiet -o /try/corridor
ocelli feeds run /try/corridor/setup.json -o /try/corridor.mp4

say "Its protocols, menu entry, icon and rule for displays on USB"
apt_install desktop-file-utils
desktop-file-validate /usr/share/applications/ocelli.desktop
ocelli study check /usr/share/ocelli/protocols/short.json | head -n 3
ls /usr/share/icons/hicolor/scalable/apps/ocelli.svg /lib/udev/rules.d/*ocelli.rules

say "Manual pages"
apt_install man-db
for page in /usr/share/man/man1/ocelli*.1.gz; do
  warnings=$(MANWIDTH=100 man --warnings -l "$page" 2>&1 >/given/page)
  [ -s /given/page ] && [ -z "$warnings" ] || { echo "$page: $warnings" >&2; exit 1; }
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
apt_install /given/libocelli-dev_*.deb /given/ocelli-doc_*.deb g++ cmake ninja-build
for project in /usr/share/doc/ocelli-doc/examples/*/CMakeLists.txt; do
  folder=$(dirname "$project")
  name=$(basename "$folder")
  grep find_package "$project"
  cmake -S "$folder" -B "/try/$name" -G Ninja -DCMAKE_BUILD_TYPE=Release >/given/cmake.log 2>&1 \
    && cmake --build "/try/$name" >>/given/cmake.log 2>&1 || { tail -n 30 /given/cmake.log >&2; exit 1; }
  argument=""
  if [ -e "$folder/react.json" ]; then
    argument="$folder/react.json"
  fi
  # shellcheck disable=SC2086  # no argument, or one
  (cd "/try/$name" && "./$name" $argument | tail -n 3)
done

say "The examples in Python"
apt_install /given/python3-ocelli_*.deb python3-matplotlib
cp -r /usr/share/doc/ocelli-doc/examples/python /try/examples
for example in beyond_the_pinhole a_volumetric_display your_own_camera; do
  python3 "/try/examples/$example.py" /try/python
done

say "The documentation"
ls /usr/share/doc/ocelli-doc
[ -s /usr/share/doc/ocelli-doc/html/index.html ] || { echo "there is no reference of the API: make it before the packages" >&2; exit 1; }

say "Away with them again"
apt-get purge -qq -y ocelli ocelli-feeds libocelli-dev python3-ocelli ocelli-doc >/given/apt.log 2>&1
left=$(find / -xdev -iname '*ocelli*' -not -path '/given/*' -not -path '/try/*' -not -path '/proc/*' -not -path '/var/*' -not -path '/dev/*')
[ -z "$left" ] || { echo "left behind: $left" >&2; exit 1; }
echo "All of it works."
INSIDE
