#!/bin/sh
# What each recipe calls: task TASK of TASKS computes the shards TASK, TASK + TASKS, TASK + 2·TASKS, … that DIR lacks.
#   shards.sh CAMPAIGN DIR TASKS [TASK]
# Without TASK it is that of the Slurm array or the indexed Kubernetes job that runs this. Call it again, for the same
# TASKS or other, and it goes on. A shard that fails is left out; the status is then that of the last that failed.
set -u
campaign=$1 folder=$2 tasks=$3
shard=${4:-${SLURM_ARRAY_TASK_ID:-${JOB_COMPLETION_INDEX:?there is no TASK}}}
shards=$(tr -d '[:space:]' <"$campaign" | sed -n 's/.*"shards":\([0-9]*\).*/\1/p')
[ -n "$shards" ] || { echo "shards.sh: $campaign: no campaign; expected a JSON object with shards" >&2; exit 2; }
mkdir -p "$folder" || exit 2
status=0
while [ "$shard" -lt "$shards" ]; do
  file=$folder/shard-$(printf '%07d' "$shard").json
  [ -e "$file" ] || "${DURERO:-durero}" conform shard "$campaign" "$shard" --jobs 1 --output "$file" || status=$?
  shard=$((shard + tasks))
done
exit "$status"
