#!/bin/sh
# Takes every figure of OpenGL on this machine, in 8 minutes at most, and writes them to FOLDER/figures.json.
#
#   ./measure FOLDER [SECONDS]
#
# Part of the archive of scripts/measure_gpu.sh. What fails or takes too long is named in the file, and does not stop
# the rest. Nothing is written outside of FOLDER.
set -eu
[ $# -ge 1 ] || { sed -n '2,7s/^# \{0,1\}//p' "$0" >&2; exit 2; }
mkdir -p "$1"
rm -f "$1"/*.json
out=$(cd "$1" && pwd)
here=$(cd "$(dirname "$0")" && pwd)
end=$(($(date +%s) + ${2:-480}))

# What this machine has is newer than ours, and what its driver was made for.
known=$(ldconfig -p 2>/dev/null || /sbin/ldconfig -p 2>/dev/null || true)
mkdir -p "$out/lib"
for file in "$here"/fallback/*; do
  case $known in
    *"$(basename "$file") "*) ;;
    *) ln -sf "$file" "$out/lib/" ;;
  esac
done
printf '<fontconfig><dir>%s/fonts</dir><cachedir>%s/lib</cachedir></fontconfig>' "$here" "$out" >"$out/lib/fonts.conf"
export FONTCONFIG_FILE="$out/lib/fonts.conf"
export LD_LIBRARY_PATH="$here/lib:$out/lib${LD_LIBRARY_PATH:+:$LD_LIBRARY_PATH}"

# run NAME SECONDS COMMAND...: its output to FOLDER/NAME.log, how it ended to the list of steps.
steps=""
run() {
  name=$1
  left=$((end - $(date +%s)))
  seconds=$(($2 < left ? $2 : left))
  shift 2
  began=$(date +%s)
  code=124
  if [ "$seconds" -gt 0 ]; then
    code=0
    timeout "$seconds" "$@" >"$out/$name.log" 2>&1 || code=$?
  fi
  took=$(($(date +%s) - began))
  echo "$name: exit code $code, $took s"
  steps="$steps${steps:+,
  }{\"step\": \"$name\", \"exitCode\": $code, \"seconds\": $took}"
}

# shellcheck disable=SC2016  # its own arguments
run doctor 30 sh -c '"$0" doctor --json >"$1"' "$here/bin/ocelli" "$out/doctor.json"
# OSMesa is no part of the archive: it draws on the CPU.
without="*OSMesa*:*osMesa*:*OsMesa*:*providersDrawTheSame*:*providersAgree*:*providersTakeTurns*"
without="$without:GuiLayerProvidersTest.*:GuiLayerDeathTest.*:GlEnvironmentDeathTest.*:GlReportTest.*"
# The archive has letters of the West alone.
without="$without:ForeignText.*"
for test in "$here"/bin/*_test; do
  name=$(basename "$test")
  run "$name" 120 "$test" --gtest_filter="-$without" --gtest_output="json:$out/$name.json"
done
run viewer_frames 60 "$here/bin/viewer_frames_bench" --json "$out/viewer_frames.json"
run render 150 "$here/bin/gl_render_bench" --runs 4 --triangles 150000,1000000,4600000,10000000 --json "$out/render.json"
run display 150 "$here/bin/gl_display_bench" --benchmark_out="$out/display.json" --benchmark_out_format=json \
  --benchmark_min_time=0.2
run rays 90 "$here/bin/gl_rays_bench" --runs 5 --json "$out/rays.json"
run volumes 60 "$here/bin/gl_volume_bench" --runs 4 --width 1280 --height 720 --json "$out/volumes.json" \
  --scene "builtin:volume,name=engine" "builtin:volume,name=marschner-lobb,size=256"
run multiperspective 60 "$here/bin/multiperspective_bench" --runs 4 --json "$out/multiperspective.json"
run tour 60 "$here/bin/ocelli" view builtin:statues --offscreen "$here/tour.json" --gl egl -o "$out/tour"

{
  printf '{"steps": [\n  %s\n]' "$steps"
  for file in "$out"/*.json; do
    # A program that was stopped leaves half a file, or none.
    case $(tail -c 2 "$file") in
      *"}"*) printf ',\n"%s": ' "$(basename "$file" .json)"; cat "$file" ;;
    esac
  done
  printf '}\n'
} >"$out/figures.part"
mv "$out/figures.part" "$out/figures.json"
rm -r "${out:?}/lib"
echo "$out/figures.json"
