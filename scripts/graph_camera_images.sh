#!/bin/sh
# Makes the images of docs/graph_cameras.md and docs/drawing_cameras.md anew, in docs/images. Build the program first.
set -eu
cd "$(dirname "$0")/.."

ocelli="${OCELLI:-build/release/cli/ocelli} -q"
examples=docs/cameras/examples
images=docs/images

# images NAME SCENE SIZE CUT [OPTION ...]: the camera's image and its plan, and what a pinhole sees where a view is given
images() {
  name=$1 scene=$2 size=$3 cut=$4
  shift 4
  # shellcheck disable=SC2086  # the program and an option
  $ocelli render "$scene" "$@" --camera "$examples/$name.json" --size "$size" -o "$images/graph-$name.png"
  # shellcheck disable=SC2086
  $ocelli camera show "$scene" "$@" --camera "$examples/$name.json" --size "$size" $cut --pixels 700 \
    -o "$images/graph-$name-plan.png"
}
# pinhole NAME SCENE SIZE [OPTION ...]
pinhole() {
  name=$1 scene=$2 size=$3
  shift 3
  # shellcheck disable=SC2086
  $ocelli render "$scene" "$@" --camera "$examples/pinhole.json" --size "$size" -o "$images/graph-$name-pinhole.png"
}

images portal builtin:maze 800x450 "" --no-fit --view $examples/portal_maze_view.json
pinhole portal builtin:maze 800x450 --no-fit --view $examples/portal_maze_view.json
corridor="builtin:maze,file=$examples/corridor_maze.json"
pinhole portal_beyond "$corridor" 800x450 --no-fit --view $examples/corridor_view.json
for curve in beyond band; do
  # shellcheck disable=SC2086  # the program and an option
  $ocelli render "$corridor" --no-fit --view $examples/corridor_view.json --camera "$examples/portal_$curve.json" \
    --size 800x450 -o "$images/graph-portal_$curve.png"
done
images occluder builtin:town 800x450 "" --no-fit --view $examples/occluder_view.json
pinhole occluder builtin:town 800x450 --no-fit --view $examples/occluder_view.json
images target builtin:boxes,count=700,floor=1 800x450 "" --view $examples/target_view.json
pinhole target builtin:boxes,count=700,floor=1 800x450 --view $examples/target_view.json
images path builtin:canyon 800x450 "--cut 400" --no-fit --view $examples/path_view.json
# A preview so short that nothing turns in it.
$ocelli render builtin:canyon --no-fit --view $examples/path_view.json --camera $examples/path_pinhole.json \
  --size 800x450 -o $images/graph-path-pinhole.png
images maze_forward "builtin:maze,file=$examples/street_maze.json" 800x500 "" --no-fit
images maze_backward "builtin:maze,file=$examples/street_maze.json" 800x500 "" --no-fit
images comprehensive builtin:maze 1200x750 ""

# What is drawn by hand (docs/drawing_cameras.md): the scripts write the images beside the camera.
drawn=$(mktemp -d)
trap 'rm -r "$drawn"' EXIT
for name in town street; do
  $ocelli camera draw builtin:town --no-fit --script "$examples/draw_$name.json" -o "$drawn/$name.json"
done
cp "$drawn"/draw-*.png "$images"
