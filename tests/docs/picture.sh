#!/bin/sh
# picture.sh DURERO ROOT: docs/still-life.png is what `durero render demo/still-life.json` draws.
set -eu
tmp=$(mktemp -d) && trap 'rm -rf "$tmp"' EXIT
"$1" render "$2/demo/still-life.json" -o "$tmp/still-life.png"
cmp "$tmp/still-life.png" "$2/docs/still-life.png" ||
  { echo "docs/still-life.png is stale; make it with: ./x render demo/still-life.json -o docs/still-life.png"; exit 1; }
