#!/bin/sh
# Tries the archive of scripts/portable_archive.sh on a Debian 12 that has nothing else, first without installing anything,
# then its viewer with an OpenGL driver of that system.
# Usage: scripts/try_portable.sh ROOT [ARCHIVE]      as root; needs debootstrap
# ROOT: see scripts/in_debian.sh. Take a new one: what was installed there before could stand in for what the archive lacks.
set -eu
top=$(cd "$(dirname "$0")/.." && pwd)

[ $# -ge 1 ] && [ $# -le 2 ] || { echo "usage: $0 ROOT [ARCHIVE]" >&2; exit 2; }
archive=${2-$top/build/ocelli-portable.tar.xz}
[ -e "$archive" ] || { echo "try_portable: no $archive: make it with scripts/portable_archive.sh" >&2; exit 1; }
tar=$(mktemp -d)
trap 'rm -rf "$tar"' EXIT
# A system with nothing in it cannot unpack .xz.
xz -dc "$archive" >"$tar/archive.tar"

"$top/scripts/in_debian.sh" "$1" "$tar/archive.tar" <<'INSIDE'
say() {
  printf '\n== %s\n' "$1"
}
rm -rf /try
mkdir /try
cd /try
tar xf /given/archive.tar
before=$(dpkg-query --show | sha256sum)
here=/try/ocelli-portable

say "The program"
$here/ocelli --version
ln -s $here/ocelli /try/link
/try/link doctor || true  # tells what is missing: OpenGL here
printf 'v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n' >triangle.obj
$here/ocelli scene info triangle.obj
$here/ocelli demo --quiet --only --size 360x240 -o demo builtin:statues
ls -s demo/index.html

say "A study, with simulated subjects, and its report"
$here/ocelli study simulate --quiet $here/protocols/short.json --db trial.sqlite --subjects 2 --seed 1
$here/ocelli analyse --quiet trial.sqlite -o report
ls report
[ "$before" = "$(dpkg-query --show | sha256sum)" ]

say "The viewer, with Mesa's driver"
apt-get update -qq
apt-get install -qq -y --no-install-recommends libegl1 libgl1-mesa-dri >/given/apt.log 2>&1 || { tail -n 20 /given/apt.log >&2; exit 1; }
$here/ocelli doctor | grep -A 1 EGL
cat >look.json <<'JSON'
{"size": [640, 400], "steps": [{"wait": "idle"}, {"save": "all.png"}]}
JSON
$here/ocelli view builtin:statues --offscreen look.json --gl egl -o frames
ls -s frames
echo "All of it works."
INSIDE
