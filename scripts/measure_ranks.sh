#!/bin/sh
# Takes the figures of docs/many_machines.md with bench/ranks_bench: strong and weak scaling with 1 and 2 ranks of one
# thread each, taken in turn since other programs use the machine too, and the bytes that 2 to 64 ranks send.
# Usage: scripts/measure_ranks.sh FILE [ROUNDS]. Appends a line of JSON a figure; needs 16 GB of memory; a round takes a minute.
set -eu
cd "$(dirname "$0")/.."
file=${1:?usage: scripts/measure_ranks.sh FILE [ROUNDS]}
rounds=${2:-5}
bench=build/release/bench/ranks_bench

# measure KIND RANKS SCENE OPTIONS...
measure() {
  kind=$1 ranks=$2 scene=$3
  shift 3
  mpirun --allow-run-as-root --oversubscribe --bind-to none --mca btl self,vader -n "$ranks" "$bench" --scene "$scene" "$@" |
    sed "s/^{/{\"kind\":\"$kind\",/" >>"$file"
}

for ranks in 2 3 4 6 8 12 16 32 64; do
  for compositing in direct swap; do
    measure sent "$ranks" "builtin:statues,triangles=200000" --runs 1 --compositing "$compositing"
  done
done
# The least time of many rounds counts.
for round in $(seq "$rounds"); do
  for ranks in 1 2; do
    for triangles in 1000000 10000000; do
      measure strong "$ranks" "builtin:statues,triangles=$triangles" --runs 4
    done
    measure weak "$ranks" "builtin:statues,triangles=$((ranks * 5000000))" --runs 4
  done
done
