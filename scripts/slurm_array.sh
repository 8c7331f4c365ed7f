#!/bin/sh
# Evaluates cameras of one scene on a cluster with Slurm: a job array whose tasks are independent, each a job of MPI ranks
# that share the work of one camera. Copy it, change the lines below, and submit it:
#
#   sbatch scripts/slurm_array.sh
#
# Each task writes a file of its own, CAMERA.json. A task that was stopped goes on where it stopped when it is submitted
# again (`sbatch --array=3 scripts/slurm_array.sh`): what is finished stands in CAMERA.json.work.
#SBATCH --job-name=ocelli
#SBATCH --array=0-5
#SBATCH --ntasks=8
#SBATCH --cpus-per-task=4
#SBATCH --time=02:00:00
#SBATCH --output=ocelli-%A-%a.log
set -eu

scene=${OCELLI_SCENE:-builtin:statues}
results=${OCELLI_RESULTS:-.}
cameras="di spoc ddoc eoc-h eoc-hv cell"

# The camera of this task: word number SLURM_ARRAY_TASK_ID.
# shellcheck disable=SC2086  # one word a camera
set -- $cameras
shift "${SLURM_ARRAY_TASK_ID:?submit this with sbatch}"
camera=$1

# mpirun of Open MPI asks Slurm for the machines of this task. One rank gets so many cores, and as many threads.
exec mpirun -n "${SLURM_NTASKS:-1}" --map-by "slot:PE=${SLURM_CPUS_PER_TASK:-1}" \
  ocelli evaluate "$scene" --cameras "$camera" --threads "${SLURM_CPUS_PER_TASK:-1}" --json "$results/$camera.json" --quiet
