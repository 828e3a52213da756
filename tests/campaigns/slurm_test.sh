#!/bin/sh
# The recipe of Slurm, in a cluster of this machine alone that the test starts and ends. It takes root, as slurmd does.
for program in munged slurmctld slurmd sbatch; do
  PATH=$PATH:/usr/sbin
  command -v $program >/dev/null 2>&1 || { echo "absent: $program (Debian: slurm-wlm munge)"; exit 77; }
done
[ "$(id -u)" = 0 ] || { echo "not root, so no Slurm"; exit 77; }
sources=$(cd "$(dirname "$0")/../.." && pwd)
. "$sources/tests/cli/harness.sh"
. "$sources/tests/campaigns/recipes.sh"

daemons=
end_cluster() {
  # shellcheck disable=SC2086  # words are meant to split
  [ -z "$daemons" ] || kill $daemons 2>/dev/null
  wait
  rm -rf "$directory"
}
trap end_cluster EXIT

start_cluster() {
  mkdir state spool
  dd if=/dev/urandom of=munge.key bs=1024 count=1 2>/dev/null
  chmod 400 munge.key
  sed "s|FOLDER|$PWD|g; s|HOST|$(hostname)|; s|CORES|$(nproc)|" "$sources/tests/campaigns/slurm.conf" >slurm.conf
  SLURM_CONF=$PWD/slurm.conf
  export SLURM_CONF
  munged --foreground --force --key-file="$PWD/munge.key" --socket="$PWD/munge.socket" --pid-file="$PWD/munge.pid" \
    --log-file="$PWD/munge.log" --seed-file="$PWD/munge.seed" >munge.out 2>&1 &
  daemons=$!
  slurmctld -D >controller.out 2>&1 &
  daemons="$daemons $!"
  slurmd -D >node.out 2>&1 &
  daemons="$daemons $!"
  for _ in 1 2 3 4 5 6 7 8 9 10 11 12 13 14 15; do
    case $(sinfo --noheader --format=%t 2>/dev/null) in idle*) return ;; esac
    sleep 2
  done
  cat controller.out node.out
  echo "absent: Slurm did not start here"
  exit 77
}

by_hand
start_cluster
DURERO=$durero sh "$recipes/slurm.sh" campaign.json array 3 --wait --output="$PWD/task-%a.log" >out 2>err ||
  fail "slurm.sh: $(cat out err task-*.log)"
[ "$(find . -name 'task-*.log' | wc -l)" -eq 3 ] || fail "there were not three tasks"
merges_alike array
finish
