#!/bin/sh
# Packs the program, with the libraries it needs, into one archive that runs on other x86-64 Linux systems (glibc 2.36 or
# newer) with nothing installed.
#
#   scripts/portable_archive.sh [--measure] [ARCHIVE]      default: build/ocelli-portable.tar.xz
#
# Needs the `release` preset, built, and patchelf. There:
#
#   tar xf ocelli-portable.tar.xz && ocelli-portable/ocelli
#
# --measure adds all that tests and times OpenGL, for a machine with a GPU: ocelli-portable/measure FOLDER
set -eu
cd "$(dirname "$0")/.."
measure=
if [ "${1-}" = --measure ]; then
  measure=1
  shift
fi
archive=${1:-build/ocelli-portable.tar.xz}
release=build/release
max_bytes=60000000
command -v patchelf >/dev/null || { echo "patchelf is missing: apt-get install patchelf" >&2; exit 1; }
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
packed=$folder/ocelli-portable
mkdir -p "$packed/bin" "$packed/libexec/ocelli" "$packed/lib" "$packed/fallback" "$packed/licenses" "$packed/zsh"

# pack FOLDER FILE: a program, which finds its libraries beside it. Programs that it starts get none of them.
pack() {
  [ -x "$release/$2" ] || { echo "$release/$2 is missing: cmake --build --preset release --target all bench/all" >&2; exit 1; }
  strip -o "$packed/$1/$(basename "$2")" "$release/$2"
  # shellcheck disable=SC2016  # for the loader
  patchelf --force-rpath --set-rpath '$ORIGIN/../lib:$ORIGIN/../../lib' "$packed/$1/$(basename "$2")"
}
pack bin cli/ocelli
for reader in ocelli-read-scene ocelli-read-volume; do
  if [ -e "$release/libexec/ocelli/$reader" ]; then
    pack libexec/ocelli "libexec/ocelli/$reader"
  fi
done
if [ -n "$measure" ]; then
  for program in bench/gl_render_bench bench/gl_display_bench bench/gl_rays_bench bench/gl_volume_bench \
    bench/multiperspective_bench bench/viewer_frames_bench \
    tests/gl/gl_arithmetic_test tests/gl/gl_context_test tests/gl/gl_renderer_test tests/gl/gl_bent_ray_test \
    tests/gl/gl_failure_test tests/gl_rays/gl_ray_walk_test tests/gl_rays/gl_ray_caster_test \
    tests/gl_rays/gl_reflection_test tests/gl_rays/gl_refraction_test tests/gl_rays/gl_stepped_image_test \
    tests/volume_gl/gl_volume_test tests/window/gui_test tests/viewer/viewer_test tests/study_screen/study_screen_test \
    tests/display_sim_gl/display_sim_gl_volume_test tests/display_sim_gl/display_sim_gl_slicer_test \
    tests/display_sim_gl/display_sim_gl_slicer_scan_test tests/display_sim_gl/display_sim_gl_observer_test tests/explore_window/explore_window_test \
    tests/sea_window/sea_window_test; do
    pack bin "$program"
  done
  cp scripts/portable/measure "$packed/"
  cp oc_core/explore_window/examples/tour.json "$packed/explore_tour.json"
fi

# The machine's own libraries stay there; those that its driver may bring in a newer version, and EGL's dispatcher, which comes with
# most drivers, are only for a machine that has none: each in a folder of its own (scripts/portable/environment.sh).
libraries() { ldd "$@" | awk '$2 == "=>" && $3 ~ /^\// { print $1, $3 }' | sort -u; }
keep_for_none() {
  mkdir -p "$packed/fallback/$2"
  cp -L "$1" "$packed/fallback/$2/$2"
}
license() {
  # Packages know some libraries by the path that they had before /lib became /usr/lib.
  path=$(readlink -f "$1")
  package=$({ dpkg-query --search "$path" || dpkg-query --search "${path#/usr}"; } 2>/dev/null | head -n 1 | cut -d : -f 1)
  [ -n "$package" ] || { echo "no package of Debian has $path, so its license is unknown" >&2; exit 1; }
  cp -L "/usr/share/doc/$package/copyright" "$packed/licenses/$package"
}
for program in $release/cli/ocelli $release/libexec/ocelli/ocelli-read-*; do
  libraries "$program"
done >"$folder/libraries"
[ -z "$measure" ] || for program in "$packed"/bin/*_test "$packed"/bin/*_bench; do libraries "$program"; done >>"$folder/libraries"
sort -u "$folder/libraries" | while read -r name file; do
  case $name in
    libc.so.* | libm.so.* | libdl.so.* | librt.so.* | libpthread.so.* | libresolv.so.* | ld-linux*) continue ;;
    libstdc++.so.* | libgcc_s.so.* | libz.so.* | libzstd.so.* | libX*.so.* | libx*.so.* | libexpat.so.* | libffi.so.* | \
      libdrm*.so.*) keep_for_none "$file" "$name" ;;
    *) cp -L "$file" "$packed/lib/$name" ;;
  esac
  license "$file"
done
for name in libEGL.so.1 libGLdispatch.so.0; do
  file=$(ldconfig -p | awk -v name="$name" '$1 == name { print $NF; exit }')
  [ -n "$file" ] || { echo "$name is missing: install libegl1" >&2; exit 1; }
  keep_for_none "$file" "$name"
  license "$file"
done
strip --strip-unneeded "$packed"/lib/* "$packed"/fallback/*/*
# Those that name a folder of this machine do not look where the program says.
# shellcheck disable=SC2016  # for the loader
patchelf --force-rpath --set-rpath '$ORIGIN' "$packed"/lib/*

mkdir "$packed/fonts"
cp /usr/share/fonts/truetype/dejavu/DejaVuSans.ttf /usr/share/fonts/truetype/dejavu/DejaVuSans-Bold.ttf "$packed/fonts/"
license /usr/share/fonts/truetype/dejavu/DejaVuSans.ttf
cp scripts/portable/fonts.conf "$packed/fonts/"
cp scripts/portable/ocelli scripts/portable/environment.sh scripts/portable/README.txt "$packed/"
cp LICENSE "$packed/licenses/Ocelli"
cp -r protocols display_sim/viewer/examples/tour.json "$packed/"
cp -r $release/manual/man1 "$packed/man"
cp $release/manual/ocelli.bash "$packed/completion.bash"
cp $release/manual/_ocelli "$packed/zsh/"

# One dictionary over all programs, which have the same libraries in them: half the size.
tar -C "$folder" --owner=0 --group=0 -c ocelli-portable | xz --lzma2=preset=6,dict=128MiB >"$archive"
bytes=$(stat -c %s "$archive")
echo "$archive: $bytes bytes"
[ "$bytes" -le $max_bytes ] || { echo "more than $max_bytes bytes" >&2; exit 1; }
