#!/bin/sh
# gallery.sh DURERO FOLDER OUT: draws each picture that FOLDER/pictures.tsv names into OUT, and says whether it is the one that
# lies in FOLDER, byte for byte. Status 1 where one is not. Then the Standard Procedural Databases, which are not part of
# the project, where they lie: in the folder DURERO_SPD, or else beside the sources.
set -eu
durero=$1 folder=$2 out=$3
mkdir -p "$out"
out=$(cd "$out" && pwd)
tab=$(printf '\t')
status=0
while IFS=$tab read -r picture _ call; do
  case $picture in \#*) continue ;; esac
  # shellcheck disable=SC2086 # the words of a call hold no blanks
  (cd "$folder" && "$durero" $call -o "$out/$picture")
  if cmp -s "$out/$picture" "$folder/$picture"; then echo "$out/$picture"
  else
    echo "$out/$picture: not the bytes of $folder/$picture"
    status=1
  fi
done <"$folder/pictures.tsv"
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
