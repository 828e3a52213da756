#!/bin/sh
# The recipe of GNU parallel, where it is installed.
command -v parallel >/dev/null 2>&1 || { echo "absent: GNU parallel"; exit 77; }
sources=$(cd "$(dirname "$0")/../.." && pwd)
. "$sources/tests/cli/harness.sh"
. "$sources/tests/campaigns/recipes.sh"
by_hand
DURERO=$durero sh "$recipes/parallel.sh" campaign.json "a folder" 3 --jobs 2 >out 2>err || fail "parallel.sh"
merges_alike "a folder"
DURERO=false sh "$recipes/parallel.sh" campaign.json empty 3 --jobs 2 >out 2>err && fail "jobs that failed went unnoticed"
finish
