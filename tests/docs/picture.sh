#!/bin/sh
# picture.sh DURERO ROOT: docs/NAME.png is what `durero render demo/NAME.json` draws. The still life, README's picture, has
# nine rays a pixel.
set -eu
tmp=$(mktemp -d) && trap 'rm -rf "$tmp"' EXIT
stale=0
for name in still-life mirrors; do
  case $name in still-life) options='--samples 9' ;; *) options='' ;; esac
  # shellcheck disable=SC2086  # options are meant to split
  "$1" render "$2/demo/$name.json" -o "$tmp/$name.png" $options
  cmp "$tmp/$name.png" "$2/docs/$name.png" ||
    { stale=1; echo "docs/$name.png is stale; make it with: ./x render demo/$name.json -o docs/$name.png $options"; }
done
exit $stale
