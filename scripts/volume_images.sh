#!/bin/sh
# Makes the images of docs/volumes.md anew that `ocelli render` draws, in docs/images. Build the program first.
set -eu
cd "$(dirname "$0")/.."

ocelli="${OCELLI:-build/release/cli/ocelli} -q"
examples=docs/cameras/examples
images=docs/images

# skull NAME VIEW [OPTION ...]: the made skull, open above, by the transfer function that tells vessels and metal
skull() {
  name=$1 view=$2
  shift 2
  # shellcheck disable=SC2086  # the program and an option
  $ocelli render builtin:volume,name=skull --clip 'y<0.2' --transfer $examples/skull_transfer.json \
    --view "$examples/$view.json" --size 480x440 "$@" -o "$images/volume-skull-$name.png"
}
skull pinhole skull_view
skull above skull_above_view
skull curved skull_view --camera $examples/skull_curved.json

# engine NAME [OPTION ...]
engine() {
  name=$1
  shift
  # shellcheck disable=SC2086
  $ocelli render builtin:volume,name=engine --view $examples/engine_view.json --size 480x400 "$@" \
    -o "$images/volume-engine-$name.png"
}
engine pinhole
engine curved --camera $examples/engine_curved.json
engine curved-more --camera $examples/engine_curved_more.json
