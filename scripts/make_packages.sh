#!/bin/sh
# Builds the `release` preset and makes Debian packages of it (cmake/OcelliPackage.cmake), in build/release/packages. Fails
# where lintian, Debian's checker, finds an error in them.
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

ignored=""
if grep -q '^OCELLI_PACKAGE_MAINTAINER:.*@localhost' build/release/CMakeCache.txt; then
  echo "make_packages: nobody can write to the maintainer that they name: say one before you give them to others (docs/install.md)" >&2
  ignored="--suppress-tags bogus-mail-host,bogus-mail-host-in-debian-changelog"
fi
# shellcheck disable=SC2086  # no option, or one with its value
lintian --allow-root $ignored build/release/packages/*.deb
