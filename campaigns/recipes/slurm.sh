#!/bin/sh
# Slurm: an array of TASKS jobs of one core each, on a file system that the nodes share.
#   slurm.sh CAMPAIGN DIR TASKS [OPTION of sbatch]...
# TASKS is at most the cluster's MaxArraySize (1001 where nobody said otherwise).
set -eu
here=$(CDPATH='' cd -- "$(dirname -- "$0")" && pwd)
campaign=$1 folder=$2 tasks=$3
shift 3
exec sbatch --job-name=durero --array=0-$((tasks - 1)) --cpus-per-task=1 --requeue "$@" \
  "$here/shards.sh" "$campaign" "$folder" "$tasks"
