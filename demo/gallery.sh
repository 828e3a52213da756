#!/bin/sh
# gallery.sh DURERO FOLDER OUT: draws each picture that FOLDER/pictures.tsv names into OUT, and says whether it is the one that
# lies in FOLDER, byte for byte. Status 1 where one is not. The Standard Procedural Databases, which are not part of the
# project, are drawn where they lie: in the folder DURERO_SPD, or else beside the sources.
set -eu
durero=$1 folder=$2 out=$3
mkdir -p "$out"
out=$(cd "$out" && pwd)
tab=$(printf '\t')
status=0
spd=${DURERO_SPD:-$folder/../../../shared/data/spd}
while IFS=$tab read -r picture when call; do
  case $picture in \#*) continue ;; esac
  if [ "$when" = spd ]; then
    name=${call#render } name=${name%%.nff*}
    if [ ! -f "$spd/$name.nff" ]; then
      echo "absent: $spd/$name.nff"
      continue
    fi
    "$durero" import "$spd/$name.nff" -o "$out/$name.json"
    call="render $out/$name.json ${call#*.nff }"
  fi
  # shellcheck disable=SC2086 # the words of a call hold no blanks
  (cd "$folder" && "$durero" $call -o "$out/$picture")
  if cmp -s "$out/$picture" "$folder/$picture"; then echo "$out/$picture"
  else
    echo "$out/$picture: not the bytes of $folder/$picture"
    status=1
  fi
done <"$folder/pictures.tsv"
exit $status
