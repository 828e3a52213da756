#!/bin/sh
# library.sh DURERO ROOT: the programs that docs/library.md shows are those that tests/consume builds.
set -eu
cd "$2"
shown=$(mktemp -d)
trap 'rm -rf "$shown"' EXIT
awk -v folder="$shown" '
  /^<!-- .* -->$/ { file = folder "/" $2 }
  /^```$/ && inside { inside = 0; file = "" }
  inside { print >file }
  /^```c/ && file { inside = 1 }' docs/library.md
diff -r tests/consume/programs "$shown" -x CMakeLists.txt
