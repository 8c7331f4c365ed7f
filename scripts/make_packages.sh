#!/bin/sh
# Builds the `release` preset and makes Debian packages of it (cmake/OcelliPackage.cmake), in build/release/packages.
set -eu
cd "$(dirname "$0")/.."

scripts/install_dependencies.sh --packages
# Where Debian's Python looks below /usr.
cmake --preset release -DOCELLI_PYTHON_INSTALL_DIR=lib/python3/dist-packages
cmake --build --preset release
cmake --build --preset release --target api_reference
rm -rf build/release/packages
(cd build/release && cpack -G DEB -B packages)
rm -rf build/release/packages/_CPack_Packages
ls -l build/release/packages
