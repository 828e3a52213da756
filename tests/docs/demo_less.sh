#!/bin/sh
# demo_less.sh DEMO ROOT: the demonstration's program reads no Z text and audits no mesh, and says so in one line.
set -eu
demo=$1 root=$2
tmp=$(mktemp -d) && trap 'rm -rf "$tmp"' EXIT
scene=$root/demo/still-life.json
printf 'Eliminar_Esfera e?=s\n' >"$tmp/script"
for call in "check $scene --with $root/spec/puntos.tex" "edit $scene --script $tmp/script --by-spec" \
  "edit $scene --script $tmp/script --with $root/spec/puntos.tex" "edit $scene --for-each elementos --op group" "agree $scene --with $root/spec/puntos.tex" \
  "render $scene --with $root/spec/puntos.tex -o $tmp/picture.png" "check --mesh $scene --picture $tmp/picture.png"; do
  status=0
  # shellcheck disable=SC2086
  "$demo" $call >"$tmp/out" 2>"$tmp/err" || status=$?
  [ "$status" = 2 ] || { echo "$call: status $status, expected 2"; exit 1; }
  [ ! -s "$tmp/out" ] || { echo "$call: it printed something"; exit 1; }
  grep -q -e "reads no Z text; expected the whole program" -e "audits no mesh; expected the whole program" "$tmp/err" || { cat "$tmp/err"; echo "$call: another message"; exit 1; }
done
[ ! -e "$tmp/picture.png" ] || { echo "a picture was left"; exit 1; }
