#!/bin/sh
# gallery.sh DURERO FOLDER OUT: draws each scene of FOLDER into OUT, and says whether it is the picture that lies beside
# the scene, byte for byte. Status 1 where one is not. Then the Standard Procedural Databases, which are not part of the
# project, where they lie: in the folder DURERO_SPD, or else beside the sources.
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
spd=${DURERO_SPD:-$folder/../../../shared/data/spd}
for name in balls jacks lattice rings tree; do
  if [ -f "$spd/$name.nff" ]; then
    "$durero" import "$spd/$name.nff" -o "$out/$name.json"
    "$durero" render "$out/$name.json" -o "$out/$name.png"
    echo "$out/$name.png"
  else echo "absent: $spd/$name.nff"
  fi
done
exit $status
