#!/bin/sh
# How the results of simulated observers move with what is assumed of them: one study for each assumption, everything else
# the same, seeds included. Prints a table: a row for each assumption, a column for each task and condition, with the
# percentage of right answers (of tasks with a time limit: seconds, counted up to the limit). Run again, it goes on where
# it stopped.
#
#   scripts/observer_grid.sh [PROTOCOL [FOLDER [SUBJECTS [SEED]]]]
#
# OCELLI names the program, where it is not build/release/cli/ocelli. Needs the package sqlite3.
set -eu
here=$(cd "$(dirname "$0")/.." && pwd)
ocelli=${OCELLI:-$here/build/release/cli/ocelli}
protocol=${1:-$here/protocols/short.json}
folder=${2:-observer_grid}
subjects=${3:-12}
seed=${4:-1}
mkdir -p "$folder"

# One line an assumption: a name for the row, and the factors (docs/simulated_subjects.md) that differ from the usual ones.
grid() {
  cat <<'LINES'
usual|{}
place error x 0|{"place_error_degrees": 0}
place error x 1/2|{"place_error_degrees": 0.25}
place error x 2|{"place_error_degrees": 1}
place error x 4|{"place_error_degrees": 2}
turn error 0|{"turn_error_degrees": 0}
turn error 40 degrees|{"turn_error_degrees": 40}
memory of 2|{"working_memory_items": 2}
memory of 8|{"working_memory_items": 8}
eyes follow none|{"tracked_items": 0}
useful field of 8 degrees|{"useful_field_degrees": 8}
LINES
}

grid | while IFS='|' read -r name factors; do
  file="$folder/$(printf '%s' "$name" | tr -c 'a-z0-9' '_')"
  printf '%s\n' "$factors" >"$file.json"
  "$ocelli" study simulate "$protocol" --quiet --db "$file.sqlite" --subjects "$subjects" --seed "$seed" \
    --factors "$file.json" </dev/null
  sqlite3 -separator '|' "$file.sqlite" "
    SELECT '$name', task || CASE WHEN moving THEN ', moving' ELSE '' END || ', ' || view,
           CASE WHEN max(censored) IS NULL OR task <> 'find' THEN round(100.0 * avg(correct), 1)
                ELSE round(avg(response_s), 1) END
    FROM final_trial GROUP BY task, moving, view ORDER BY task, moving, view DESC;"
done | awk -F'|' '
  !($2 in seen) { seen[$2] = 1; columns[++count] = $2 }
  !($1 in known) { known[$1] = 1; rows[++lines] = $1 }
  { cell[$1, $2] = $3 }
  END {
    printf "| assumption |"; for (i = 1; i <= count; ++i) printf " %s |", columns[i]
    printf "\n| --- |"; for (i = 1; i <= count; ++i) printf " ---: |"
    printf "\n"
    for (r = 1; r <= lines; ++r) {
      printf "| %s |", rows[r]
      for (i = 1; i <= count; ++i) printf " %s |", cell[rows[r], columns[i]]
      printf "\n"
    }
  }'
