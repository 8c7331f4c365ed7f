#!/bin/sh
# Makes the images of docs/experimenters.md anew, in docs/images: a session on a virtual screen, driven by keys. Build
# the program first. Needs xvfb, xauth and xdotool.
set -eu
cd "$(dirname "$0")/.."

ocelli="${OCELLI:-build/release/cli/ocelli}"
size=1024x640
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

xvfb-run -a -s "-screen 0 ${size}x24 -noreset" python3 tests/study_screen/session_test.py "$ocelli" \
  tests/study_screen/tiny.json keyboard "$folder/session" "$size"

# image NAME NUMBER: the screen with that number in the order in which they came
image() {
  cp "$folder/session/screens/$2"-*.png "docs/images/study_$1.png"
}
image consent 000
image form 001
image controls 002
image bent_view 004
image ready 005
image pause 006
image find 008
image feedback 009
image break 013
