#!/bin/sh
# Runs the study of chapter 7 with simulated subjects who see: 45 of them, 25 with three sessions and 20 with one, and
# prints what they did beside what the text reports. Run again, it goes on where it stopped.
#
#   scripts/simulate_rosen2010.sh [DATABASE [SEED]]
#
# OCELLI names the program, where it is not build/release/cli/ocelli. Needs the package sqlite3 for the tables.
set -eu
here=$(cd "$(dirname "$0")/.." && pwd)
ocelli=${OCELLI:-$here/build/release/cli/ocelli}
database=${1:-rosen2010_simulated.sqlite}
seed=${2:-2010}
"$ocelli" study simulate "$here/protocols/rosen2010.json" --db "$database" --subjects 45 --seed "$seed" --sessions 3x25,1x20
sqlite3 "$database" < "$here/scripts/rosen2010_tables.sql"
