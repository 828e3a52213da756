#!/bin/sh
# picture.sh DURERO ROOT: docs/NAME.png is what `durero render demo/NAME.json` draws.
set -eu
tmp=$(mktemp -d) && trap 'rm -rf "$tmp"' EXIT
stale=0
for name in still-life mirrors; do
  "$1" render "$2/demo/$name.json" -o "$tmp/$name.png"
  cmp "$tmp/$name.png" "$2/docs/$name.png" ||
    { stale=1; echo "docs/$name.png is stale; make it with: ./x render demo/$name.json -o docs/$name.png"; }
done
exit $stale
