#!/bin/sh
# Makes the pictures of docs/experimenters.md anew, in docs/images: a session on a virtual screen, driven by keys. Build
# the program first. Needs xvfb, xauth and xdotool.
set -eu
cd "$(dirname "$0")/.."

ocelli="${OCELLI:-build/release/cli/ocelli}"
size=1024x640
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

xvfb-run -a -s "-screen 0 ${size}x24 -noreset" python3 tests/study_screen/session_test.py "$ocelli" \
  tests/study_screen/tiny.json keyboard "$folder/session" "$size"

# picture NAME NUMBER: the screen with that number in the order in which they came
picture() {
  cp "$folder/session/screens/$2"-*.png "docs/images/study_$1.png"
}
picture consent 000
picture form 001
picture controls 002
picture bent_view 004
picture ready 005
picture pause 006
picture find 008
picture feedback 009
picture break 013
