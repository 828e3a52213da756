#!/bin/sh
# library.sh DURERO ROOT: the programs that docs/library.md shows are those that tests/consume builds, and the commands by
# which README and docs/*.md install something are found by install_lines.sh, whose lines the long tests run.
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
sh tests/docs/install_lines.sh . >"$shown/lines"
for line in './x build' 'cmake --install build/release --prefix /opt/durero' 'pip install .'; do
  grep -qxF -e "$line" "$shown/lines" || { echo "no page installs by: $line"; exit 1; }
done
