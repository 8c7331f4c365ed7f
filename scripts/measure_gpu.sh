#!/bin/sh
# Packs all that draws with OpenGL, with the libraries it needs, into one archive for a machine with a GPU.
#
#   scripts/measure_gpu.sh [ARCHIVE]      default: build/ocelli-gpu.tar.xz
#
# Needs the `release` preset, built. There, with nothing installed but the GPU's driver (glibc 2.36 or newer):
#
#   tar xf ocelli-gpu.tar.xz && ocelli-gpu/measure FOLDER
set -eu
cd "$(dirname "$0")/.."
archive=${1:-build/ocelli-gpu.tar.xz}
release=build/release
most_bytes=60000000
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
packed=$folder/ocelli-gpu
mkdir -p "$packed/bin" "$packed/lib" "$packed/fallback"

programs="cli/ocelli bench/gl_render_bench bench/gl_display_bench bench/gl_rays_bench bench/gl_volume_bench
  bench/multiperspective_bench bench/viewer_frames_bench
  tests/gl/gl_arithmetic_test tests/gl/gl_context_test tests/gl/gl_renderer_test tests/gl/gl_bent_ray_test tests/gl/gl_failure_test
  tests/gl_rays/gl_ray_walk_test tests/gl_rays/gl_ray_caster_test tests/gl_rays/gl_reflection_test
  tests/gl_rays/gl_refraction_test tests/gl_rays/gl_stepped_image_test tests/volume_gl/gl_volume_test
  tests/window/gui_test tests/viewer/viewer_test tests/study_screen/study_screen_test
  tests/display_sim_gl/display_sim_gl_volume_test tests/display_sim_gl/display_sim_gl_slicer_test
  tests/display_sim_gl/display_sim_gl_slicer_scan_test tests/display_sim_gl/display_sim_gl_observer_test"
for program in $programs; do
  [ -x "$release/$program" ] || { echo "$release/$program is missing: cmake --build --preset release" >&2; exit 1; }
  strip -o "$packed/bin/$(basename "$program")" "$release/$program"
done

mkdir -p "$packed/libexec/ocelli"
strip -o "$packed/libexec/ocelli/ocelli-read-scene" "$release/libexec/ocelli/ocelli-read-scene"

# Libraries of the programs. Those that belong to the machine stay there; those that its driver may bring in a newer
# version, and EGL's dispatcher, which comes with most drivers, are only there for a machine that has none.
libraries() { ldd "$@" | awk '$2 == "=>" && $3 ~ /^\// { print $1, $3 }' | sort -u; }
keep() { cp -L "$2" "$packed/$1/$(basename "$3")"; }
libraries "$packed"/bin/* "$packed"/libexec/ocelli/* | while read -r name file; do
  case $name in
    libc.so.* | libm.so.* | libdl.so.* | librt.so.* | libpthread.so.* | libresolv.so.* | ld-linux*) ;;
    libstdc++.so.* | libgcc_s.so.* | libz.so.* | libzstd.so.* | libX*.so.* | libx*.so.* | libexpat.so.* | libffi.so.* | \
      libdrm*.so.*) keep fallback "$file" "$name" ;;
    *) keep lib "$file" "$name" ;;
  esac
done
for name in libEGL.so.1 libGLdispatch.so.0; do
  file=$(ldconfig -p | awk -v name="$name" '$1 == name { print $NF; exit }')
  [ -n "$file" ] || { echo "$name is missing: install libegl1" >&2; exit 1; }
  keep fallback "$file" "$name"
done
strip --strip-unneeded "$packed"/lib/* "$packed"/fallback/*
# Text looks the same everywhere.
mkdir "$packed/fonts"
cp /usr/share/fonts/truetype/dejavu/DejaVuSans.ttf /usr/share/fonts/truetype/dejavu/DejaVuSans-Bold.ttf "$packed/fonts/"
cp scripts/gpu_figures.sh "$packed/measure"
cp display_sim/viewer/examples/tour.json "$packed/"

tar -C "$folder" -c ocelli-gpu | xz -T0 -6 >"$archive"
bytes=$(stat -c %s "$archive")
echo "$archive: $bytes bytes"
[ "$bytes" -le $most_bytes ] || { echo "more than $most_bytes bytes" >&2; exit 1; }
