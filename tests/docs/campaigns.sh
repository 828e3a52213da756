#!/bin/sh
# campaigns.sh DURERO ROOT: the example of docs/campaigns.md, up to the part on many machines, is a campaign; its
# commands end well, and the last prints what the document says.
set -eu
durero=$1 root=$2
tmp=$(mktemp -d) && trap 'rm -rf "$tmp"' EXIT
cd "$tmp"
# The first three blocks: the campaign, the commands, what they print.
awk '/^```/ { inside = !inside; if (inside) ++block; next } inside { print >("block" block) } block == 3 && !inside { exit }' \
  "$root/docs/campaigns.md"
mv block1 campaign.json
ran=0
while IFS= read -r command; do
  case $command in 'durero conform '*) ;; *) echo "a command that nothing runs: $command"; exit 1 ;; esac
  eval "\"$durero\" ${command#durero }" >said || { echo "$command: status $?"; exit 1; }
  ran=$((ran + 1))
done <block2
[ "$ran" -ge 3 ] || { echo "only $ran commands were run"; exit 1; }
diff block3 said || { echo "docs/campaigns.md shows another output (<) than the program's (>)"; exit 1; }
