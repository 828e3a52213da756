#!/bin/sh
# gallery.sh DURERO FOLDER OUT: draws each scene of FOLDER into OUT, and says whether it is the picture that lies beside
# the scene, byte for byte. Status 1 where one is not.
set -eu
durero=$1 folder=$2 out=$3
mkdir -p "$out"
status=0
for scene in "$folder"/*.json; do
  name=$(basename "$scene" .json)
  "$durero" render "$scene" -o "$out/$name.png"
  if cmp -s "$out/$name.png" "$folder/$name.png"; then echo "$out/$name.png"
  else
    echo "$out/$name.png: not the bytes of $folder/$name.png"
    status=1
  fi
done
exit $status
