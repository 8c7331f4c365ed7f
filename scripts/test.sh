#!/bin/sh
# Installs what is missing, builds the `release` preset and runs every test, the fast ones first.
# OCELLI_DATA_DIR, where set, names a folder with meshes that some tests need; they are skipped without it.
set -eu
cd "$(dirname "$0")/.."

scripts/install_dependencies.sh
cmake --preset release
cmake --build --preset release
ctest --preset release --label-regex '^fast$' --parallel "$(nproc)"
ctest --preset release --label-exclude '^fast$' --parallel "$(nproc)"
