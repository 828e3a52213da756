#!/bin/sh
# folders.sh ROOT BUILD FILE...: no FILE names the folder of the sources or of the build.
set -eu
root=$1 build=$2
shift 2
bad=0
for file in "$@"; do
  for folder in "$root/" "$build/"; do
    ! grep -qaF -e "$folder" "$file" || { echo "$file names $folder"; bad=$((bad + 1)); }
  done
done
echo "$# files, $bad name a folder"
[ "$bad" = 0 ]
