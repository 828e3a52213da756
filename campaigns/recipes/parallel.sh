#!/bin/sh
# GNU parallel: the cores of this machine, or of those that its options name (--sshloginfile FILE).
#   parallel.sh CAMPAIGN DIR TASKS [OPTION of parallel]...
# Other machines need durero, this folder, CAMPAIGN and DIR under the same paths.
set -eu
here=$(CDPATH='' cd -- "$(dirname -- "$0")" && pwd)
campaign=$1 folder=$2 tasks=$3
shift 3
seq 0 $((tasks - 1)) | parallel --quote "$@" sh "$here/shards.sh" "$campaign" "$folder" "$tasks"
