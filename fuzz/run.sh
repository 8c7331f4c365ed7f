#!/bin/sh
# fuzz/run.sh [SECONDS]: builds the fuzz targets (preset asan, which needs clang) and runs each for so long (60 by
# default; continuous integration gives each 10), starting from the seed corpora in tests/. A finding ends it with an error
# and leaves the bytes in build/asan/fuzz/.
set -eu
seconds=${1:-60}
root=$(cd "$(dirname "$0")/.." && pwd)
build="$root/build/asan/fuzz"
cd "$root"
cmake --preset asan >/dev/null
cmake --build --preset asan --target fuzzers
cd "$build"

# Damaged scene files of many formats, with the process that Assimp runs in, beside the others. Each run takes another seed.
./scene_files_campaign "$seconds" "$(date +%s)" "$build/scene_files_found" &
campaign=$!

# Those of optional components.
volumes=""
if [ -e meta_image_fuzzer ]; then
  volumes="vti volume_import/samples $seconds
meta_image volume_import/samples $seconds"
fi

# A line a target: NAME CORPUS SECONDS. The decoder of what comes over a cable has twice as many. As many run at a time as
# there are cores.
status=0
xargs -L 1 -P "$(nproc)" sh -c '
  mkdir -p "${1}_found"
  "./${1}_fuzzer" -max_total_time="$3" -max_len=4096 -rss_limit_mb=4096 -timeout=10 -verbosity=0 \
    -print_final_stats=1 "${1}_found" "$0/tests/$2"
' "$root" <<END || status=1
wire display_driver_wire/corpus $((2 * seconds))
svol display_sim_frames/corpus $seconds
kv6 display_sim_exports/kv6_corpus $seconds
opack pack/corpus $seconds
views_file depth_views/corpus $seconds
maze worlds/maze_corpus $seconds
walk_map walkable/corpus $seconds
transfer volume/transfer_corpus $seconds
camera constructor/corpus $seconds
drawing frustum_editor/corpus $seconds
protocol study_protocol/corpus $seconds
plan analysis_dataset/plan_corpus $seconds
gaze study_gaze/corpus $seconds
device_log display_driver_pacing/corpus $seconds
wire_host display_driver_wire/host_corpus $seconds
serial display_driver_serial/corpus $seconds
ply scene/ply_corpus $seconds
scene_record scene/record_corpus $seconds
volume_record volume/record_corpus $seconds
material scene/image_corpus $seconds
shade shade/corpus $seconds
remote_message remote/message_corpus $seconds
image_codecs image_codecs/corpus $seconds
sea sea/corpus $seconds
feed_setup feeds/corpus $seconds
$volumes
END
wait "$campaign" || status=1
exit "$status"
