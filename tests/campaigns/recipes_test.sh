#!/bin/sh
# Each recipe ends in the very call that a run by hand makes, and so in the same bytes: here as Slurm and Kubernetes make
# it in each of their tasks, with the task's number in the environment.
sources=$(cd "$(dirname "$0")/../.." && pwd)
. "$sources/tests/cli/harness.sh"
. "$sources/tests/campaigns/recipes.sh"
by_hand

# A Slurm array of three tasks, in the order in which they happen to run; one task of Kubernetes goes on where it ended.
for task in 2 0; do SLURM_ARRAY_TASK_ID=$task DURERO=$durero sh "$recipes/shards.sh" campaign.json slurm 3 || fail "task $task"; done
run 0 conform merge campaign.json slurm --output slurm.json
has out "missing: 1, 4, 7"
JOB_COMPLETION_INDEX=1 DURERO=$durero sh "$recipes/shards.sh" campaign.json slurm 3 || fail "task 1"
merges_alike slurm

# What is there is not computed again.
echo kept >slurm/shard-0000003.json
DURERO=false sh "$recipes/shards.sh" campaign.json slurm 1 0 || fail "a shard that is there was computed again"
# A shard that fails is left out, and the others are computed: here all but the fourth.
printf '#!/bin/sh\n[ "$4" != 3 ] || exit 2\nexec "%s" "$@"\n' "$durero" >fails-once
chmod +x fails-once
DURERO=./fails-once sh "$recipes/shards.sh" campaign.json others 1 0
[ $? = 2 ] || fail "a shard that failed goes unnoticed"
run 0 conform merge campaign.json others --output others.json
has out "missing: 3"

# Without a task, and of what is no campaign, there is nothing.
if sh "$recipes/shards.sh" campaign.json nothing 3 2>err; then fail "there was no task"; fi
echo '{}' >no.json
if sh "$recipes/shards.sh" no.json nothing 3 0 2>err; then fail "there was no campaign"; fi
has err "no.json: no campaign"
absent nothing

# The command of the Kubernetes job, as each of its tasks runs it, but for the folders that it mounts.
command=$(sed -n 's/^ *command: \[\(.*\)\]$/\1/p' "$recipes/kubernetes.yaml" | tr -d '",' |
  sed "s|/campaign/shards.sh|$recipes/shards.sh|; s|/campaign/campaign.json|campaign.json|; s| /shards| kubernetes|")
tasks=$(sed -n 's/^ *completions: //p' "$recipes/kubernetes.yaml")
case $command in *" kubernetes $tasks") ;; *) fail "the job has $tasks tasks, and tells them: $command" ;; esac
for task in 0 1 2 3 4 5 6 7; do JOB_COMPLETION_INDEX=$task DURERO=$durero $command || fail "task $task of Kubernetes"; done
merges_alike kubernetes
finish
