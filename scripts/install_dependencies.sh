#!/bin/sh
# Installs what building and testing Ocelli needs and this Debian 12 machine lacks.
# Usage: scripts/install_dependencies.sh [--developer|--packages|--benchmarks]
#   --developer    also the tools for fuzzing, formatting and linting, for the reference of the API and for the site of the guide
#   --packages     also those for Debian packages: for the reference of the API, and Debian's checker
#   --benchmarks   also the libraries that the slicer is measured against: some hundred megabytes
set -eu

packages="cmake ninja-build g++ ccache pkg-config python3 git
  libglm-dev libtbb-dev libpng-dev zlib1g-dev libassimp-dev libembree-dev libopenexr-dev libimath-dev
  nlohmann-json3-dev libzstd-dev libmeshoptimizer-dev libhwy-dev libstb-dev libisal-dev libcairo2-dev libfmt-dev libcli11-dev libssl-dev libsqlitecpp-dev libsqlite3-dev
  libeigen3-dev libnlopt-cxx-dev libboost-dev
  libopenmpi-dev openmpi-bin
  libusb-1.0-0-dev libumockdev-dev umockdev
  libmicrohttpd-dev libwebsockets-dev
  libteem-dev libnifti2-dev libgdcm-dev libpugixml-dev
  libopenvdb-dev
  librecast-dev
  libopencv-core-dev libopencv-imgproc-dev libopencv-video-dev
  libavdevice-dev libavformat-dev libavcodec-dev libavutil-dev libswscale-dev
  pybind11-dev python3-dev python3-numpy python3-matplotlib python3-pandas
  libjpeg62-turbo-dev libwebp-dev libjxl-dev
  libgtest-dev libgmock-dev libbenchmark-dev libosmesa6-dev libosmesa6 libegl-dev libegl1
  libgl1-mesa-dri libglfw3-dev libimgui-dev libfontconfig-dev libfribidi-dev fonts-dejavu-core fonts-droid-fallback python3-glad xvfb xauth libxtst6 xdotool
  libopencv-calib3d-dev libopencv-stitching-dev libopencv-contrib-dev libapriltag-dev
  chromium ffmpeg"

case "${1-}" in
  "") ;;
  --developer)
    packages="$packages clang-16 lld libclang-rt-16-dev llvm-16 clang-format clang-tidy doxygen mkdocs mkdocs-material"
    ;;
  --packages) packages="$packages doxygen lintian" ;;
  --benchmarks) packages="$packages libvtk9-dev" ;;
  *)
    echo "usage: $0 [--developer|--packages|--benchmarks]" >&2
    exit 2
    ;;
esac

# The state of each package is asked for by name: a package that apt knows but has removed counts as missing.
missing=""
for package in $packages; do
  state=$(dpkg-query --show --showformat='${db:Status-Status}' "$package" 2>/dev/null || true)
  [ "$state" = installed ] || missing="$missing $package"
done
[ -n "$missing" ] || exit 0

if ! command -v apt-get >/dev/null; then
  echo "install_dependencies: this is not Debian. Install the equivalents of these packages yourself:$missing" >&2
  exit 1
fi
if [ "$(id -u)" = 0 ]; then
  as_root=""
elif command -v sudo >/dev/null; then
  as_root="sudo"
else
  echo "install_dependencies: no rights to install packages. Run this as root:" >&2
  echo "  apt-get install --no-install-recommends$missing" >&2
  exit 1
fi

echo "install_dependencies: installing$missing"
export DEBIAN_FRONTEND=noninteractive
$as_root apt-get update -qq
# shellcheck disable=SC2086  # one word a package
$as_root apt-get install -qq -y --no-install-recommends $missing </dev/null
