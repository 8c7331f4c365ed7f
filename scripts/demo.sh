#!/bin/sh
# Builds Ocelli and runs the whole way from scene to display on built-in scenes, and on the given mesh files.
# Usage: scripts/demo.sh [MESH...]
# Leaves demo/index.html.
set -eu
top=$(cd "$(dirname "$0")/.." && pwd)

"$top/scripts/install_dependencies.sh"
# On a terminal, a line that counts on.
export NINJA_STATUS="[%f of %t, %p, %es] "
(cd "$top" && cmake --preset release && cmake --build --preset release --target ocelli)
# Paths of meshes are relative to where the user stands, so the folder does not change.
"$top/build/release/cli/ocelli" demo -o "$top/demo" "$@"
echo "Open this page in a browser: $top/demo/index.html"
