#!/bin/sh
# Checks formatting and runs clang-tidy over every source file. Needs a configured `release` preset.
# Usage: scripts/lint.sh [PATH_REGEX]     only files whose path matches
set -eu
cd "$(dirname "$0")/.."

scripts/install_dependencies.sh --developer
python3 -B tests/house/check_format.py .
cmake --preset release
top=$(pwd)
rooms="$top/(oc_core|display_sim|cli|tests|bench|fuzz)/.*${1-}"
run-clang-tidy -quiet -p build/release "$rooms"
