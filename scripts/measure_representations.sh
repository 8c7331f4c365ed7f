#!/bin/sh
# Measures every representation on the scenes of docs/choosing.md, and prints its tables.
#
#   scripts/measure_representations.sh FOLDER [options of `ocelli evaluate`]
#
# Scans are found through OCELLI_DATA_DIR. What FOLDER already holds is not measured again. Some 40 minutes on two cores.
set -eu
cd "$(dirname "$0")/.."
[ $# -ge 1 ] || { sed -n '2,6s/^# \{0,1\}//p' "$0" >&2; exit 2; }
folder=$1
shift
ocelli=${OCELLI:-build/release/cli/ocelli}
cameras=di,di-wide,corners-4,corners-8,ldi-4,rppc,spoc,di+spoc,ddoc-constant,ddoc
cameras=$cameras,eoc-h,eoc-v,eoc-hv,eoc-hv+ddoc,cell,simplified,simplified-sloppy,geometry
mkdir -p "$folder"

measure() { # NAME SCENE CELL
  [ ! -e "$folder/$1-$3.json" ] || return 0
  echo "measuring $1, cell $3" >&2
  # shellcheck disable=SC2086  # options are words
  "$ocelli" evaluate "$2" --cameras "$cameras" --cell "$3" --directions 0 --json "$folder/$1-$3.json" $options >/dev/null
}

options=$*
for cell in 8in 4in; do
  for scan in bunny.obj dragon.obj armadillo.ply; do
    measure "${scan%.*}" "builtin:room,mesh=$scan" $cell
  done
  measure buddhas "builtin:statues,mesh=buddha.obj" $cell
  for name in teapot doors boxes; do
    measure $name builtin:$name $cell
  done
  measure fence-4 builtin:fence,gap=4 $cell
  measure fence-1 builtin:fence,gap=1 $cell
done
python3 scripts/representation_table.py "$folder"
