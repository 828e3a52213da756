#!/bin/sh
# demo.sh DURERO FOLDER OUT: the main job from a scene to a picture: check it, edit it under contract, hold the tracer
# against the set-of-points oracle, render it. DURERO is the program, FOLDER this folder, OUT where the picture goes.
set -eu
durero=$1 folder=$2 out=$3
tmp=$(mktemp -d)
trap 'rm -rf "$tmp"' EXIT

echo "Durero: a still life behind Dürer's frame (demo/still-life.json)"
"$durero" check "$folder/still-life.json" >"$tmp/check"
echo "1. Check: $(head -n 1 "$tmp/check" | sed 's/.*: \([0-9]* elementos\)/\1/')"
echo "   $(grep -c '^Escena.inv.* ok: ' "$tmp/check") of $(grep -c '^Escena.inv' "$tmp/check") invariants of the Z schema Escena hold"
echo "2. Edit under contract: demo/edits.txt"
status=0
"$durero" edit "$folder/still-life.json" --script "$folder/edits.txt" --audit -o "$tmp/scene.json" >"$tmp/answers" || status=$?
[ "$status" -le 1 ] || exit "$status"  # 1: some edits were refused, as the script means them to be
while IFS= read -r answer; do
  line=$(printf '%s' "$answer" | sed -E 's/.*"line":([0-9]+).*/\1/')
  operation=$(sed -n "${line}p" "$folder/edits.txt" | cut -d' ' -f1,2)
  case $answer in
    *'"ok":true'*) printf '%s' "$answer" | sed -E 's/.*"r":"([a-z_]+)".*/\1/' | xargs printf '   %-34s done     %s\n' "$operation" ;;
    *) why=$(printf '%s' "$answer" | sed -E 's/.*"violated":"([^"]+)","predicate":"([^"]+)".*/\1: \2/')
       printf '   %-34s refused  %s\n' "$operation" "$why" ;;
  esac
done <"$tmp/answers"
echo "3. The tracer against the set-of-points oracle, on 100000 rays"
"$durero" agree "$tmp/scene.json" --rays 100000 | sed 's/^/   /'
echo "4. Render, 1280 x 720, nine rays a pixel"
"$durero" render "$tmp/scene.json" -o "$out/durero-demo.png" --samples 9
echo "   $out/durero-demo.png"
