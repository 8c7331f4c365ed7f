#!/bin/sh
# Kills running sessions with SIGKILL at random moments and checks that no acknowledged trial is lost.
# Usage: scripts/kill_study.sh [KILLS [SEED]]     1000 kills by default: about ten minutes
set -eu
cd "$(dirname "$0")/.."
cmake --preset release
cmake --build --preset release --target study_store_kill_program
exec build/release/tests/study_store/study_store_kill_program "${1-1000}" "${2-1}"
