#!/bin/sh
# The edges of the build are the true ones: a target of CMakeLists.txt names the layers that its files include, and no
# others. (What a layer sees through another it includes all the same, and names.)
# The commands are two targets of the one folder src/cli; a part is a second target of its layer's folder.
tmp=$(mktemp -d) && trap 'rm -rf "$tmp"' EXIT

# LAYER USED, one a line: from the includes, and from CMakeLists.txt.
git ls-files 'include/durero/*.hpp' 'src/*.cpp' 'src/*.hpp' | xargs grep -HoE '^#include "durero/[a-z]+/' |
  sed -E 's#^(include/durero|src)/([a-z]+)/.*"durero/([a-z]+)/#\2 \3#' | awk '$1 != $2' | sort -u >"$tmp/included"
sed 's/#.*//' CMakeLists.txt | tr '\n' ' ' | sed 's/)/)\n/g' |
  awk '/(^| )durero_layer\(/ {
         sub(/.*durero_layer\(/, ""); sub(/\).*/, ""); listed = 0
         for (i = 2; i <= NF; ++i) if ($i == "DEPENDS") listed = 1; else if ($i == "LIBRARIES") listed = 0
           else if (listed) print $1, $i }
       /(^| )durero_part\(/ {
         sub(/.*durero_part\(/, ""); sub(/\).*/, ""); listed = 0
         for (i = 2; i <= NF; ++i) if ($i == "OF") layer[$1] = $(i + 1); else if ($i == "DEPENDS") listed = 1
           else if (listed) print layer[$1], $i }
       /(^| )target_link_libraries\(durero_(commands|cli) / {
         for (i = 1; i <= NF; ++i) if (sub(/^durero::/, "", $i)) { sub(/\)/, "", $i); print "cli", $i in layer ? layer[$i] : $i } }' |
  sort -u >"$tmp/named"
{
  comm -23 "$tmp/included" "$tmp/named" | sed -E 's/^(.*) (.*)$/CMakeLists.txt:1: \1 includes \2; expected \2 among what it names/'
  comm -13 "$tmp/included" "$tmp/named" | sed -E 's/^(.*) (.*)$/CMakeLists.txt:1: \1 names \2; expected an include of it/'
} | { ! grep .; }
