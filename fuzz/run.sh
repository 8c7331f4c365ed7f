#!/bin/sh
# fuzz/run.sh [SECONDS]: builds the fuzz targets (preset asan, which needs clang) and runs each for so long (60 by
# default), starting from the seed corpora in tests/. A finding ends it with an error and leaves the bytes in
# build/asan/fuzz/.
set -eu
seconds=${1:-60}
root=$(cd "$(dirname "$0")/.." && pwd)
build="$root/build/asan/fuzz"
cd "$root"
cmake --preset asan >/dev/null
cmake --build --preset asan --target fuzzers
cd "$build"

# A line a target: NAME CORPUS SECONDS. The decoder of what comes over a cable has a minute at least. As many run at a time
# as there are cores.
xargs -L 1 -P "$(nproc)" sh -c '
  mkdir -p "${1}_found"
  "./${1}_fuzzer" -max_total_time="$3" -max_len=4096 -rss_limit_mb=4096 -timeout=10 -verbosity=0 \
    -print_final_stats=1 "${1}_found" "$0/tests/$2"
' "$root" <<END
wire display_driver_wire/corpus $([ "$seconds" -gt 60 ] && echo "$seconds" || echo 60)
svol display_sim_frames/corpus $seconds
opack pack/corpus $seconds
maze worlds/maze_corpus $seconds
camera constructor/corpus $seconds
protocol study_protocol/corpus $seconds
plan analysis_dataset/plan_corpus $seconds
device_log display_driver_pacing/corpus $seconds
wire_host display_driver_wire/host_corpus $seconds
ply scene/ply_corpus $seconds
scene_record scene/record_corpus $seconds
material scene/image_corpus $seconds
END
# Damaged scene files of many formats, with the process that Assimp runs in. Each run takes another seed.
./scene_files_campaign "$seconds" "$(date +%s)" "$build/scene_files_found"
