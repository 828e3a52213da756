#!/bin/sh
# demo.sh DURERO ROOT: the demonstration ends well, says what it should, fits one screen and leaves its picture.
set -eu
durero=$1 root=$2
tmp=$(mktemp -d) && trap 'rm -rf "$tmp"' EXIT
sh "$root/demo/demo.sh" "$durero" "$root/demo" "$tmp" >"$tmp/said"
cat "$tmp/said"
for wanted in 'done     esfera_agregada' 'refused  Agregar_Elemento.pre.1: e? ∉ elementos' 'unexplained: 0' '9 of 9'; do
  grep -qF "$wanted" "$tmp/said" || { echo "the demonstration does not say: $wanted"; exit 1; }
done
[ "$(wc -l <"$tmp/said")" -le 24 ] || { echo "the summary does not fit 24 lines"; exit 1; }
file=$tmp/durero-demo.png
[ "$(head -c 8 "$file" | od -An -tx1 | tr -d ' ')" = 89504e470d0a1a0a ] || { echo "no PNG"; exit 1; }
[ "$(wc -c <"$file")" -gt 50000 ] || { echo "the picture is empty"; exit 1; }
