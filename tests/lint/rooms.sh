#!/bin/sh
# docs/adding-a-surface.md names every room that a new surface has something to do in: each file of include, src and python
# whose code names a shape, by its type, its enumerator or its operations, is in the table of its rooms, or stands in a
# folder that is; and whatever the table names has such a file.
page=docs/adding-a-surface.md
shapes=$(sed -n 's/^using Shapes = std::tuple<\(.*\)>;$/\1/p' include/durero/scene/shapes.hpp | tr -d ' ' | tr ',' '\n' | paste -sd'|')
[ -n "$shapes" ] || { echo "include/durero/scene/shapes.hpp:1: no line that names all Shapes"; exit 1; }
types=$(git ls-files 'include/durero/model/tipo/*.hpp' | sed 's/.*\///; s/\.hpp$//' | sort | tr '\n' '|' | sed 's/|$//')
named=$(mktemp) && listed=$(mktemp) && trap 'rm -f "$named" "$listed"' EXIT
operations=$(printf '%s' "$types" | sed 's/\(^\||\)\(.\)/\1\U\2/g')
git ls-files 'include/*.hpp' 'include/*.h' 'src/*.hpp' 'src/*.cpp' 'python/*.cpp' 'python/*.hpp' 'python/*.py' |
  xargs awk -v shape="$shapes|soy_($types)|((Agregar|Eliminar)_)?($operations)" '
    BEGIN { shape = "(^|[^A-Za-z0-9_])(" shape ")([^A-Za-z0-9_]|$)" }
    FILENAME == found || /^ *#/ || /^ *>>>/ { next }
    { sub(/^ *(\/\/|\*|\/\*).*/, ""); sub(/ \/\/.*/, "") }
    $0 ~ shape { print found = FILENAME }' | sort >"$named"
sed -n '/^| room /,/^$/s/^| \(`[^|]*`\) |.*/\1/p' "$page" | grep -o '`[^`]*`' | tr -d '`' | sort >"$listed"
{
  while read -r file; do
    while read -r room; do
      case $file in "$room" | "${room%/}/"*) continue 2 ;; esac
    done <"$listed"
    echo "$file:1: its code names a shape, and $page does not name it"
  done <"$named"
  while read -r room; do
    grep -q "^${room%/}\(/.*\)\{0,1\}$" "$named" || echo "$page:1: $room names no shape"
  done <"$listed"
} | { ! grep .; }
