#!/bin/sh
# stand_in.sh ROOT BUILD COMPILER: compiles each source of the program that takes more of TBB than its version, with loops.hpp
# in TBB's place, and makes no code of it. So it is seen every day where a source uses what loops.hpp lacks, of which
# tsan/races cannot be built.
set -eu
root=$1 work=$2/tsan-stand-in compiler=$3
rm -rf "$work"
mkdir -p "$work"
cd "$root"
with_tbb='^#include <(oneapi/)?tbb/([^v]|v[^e])'
grep -rhE "$with_tbb" include src --include='*pp' | sed 's/.*<\(.*\)>.*/\1/' | sort -u | while read -r header; do
  mkdir -p "$work/${header%/*}"
  echo "#include \"$root/tests/tsan/loops.hpp\"" >"$work/$header"
done
grep -rlE "$with_tbb" include src --include='*pp' | sort | sed "s|.*|#include \"$root/&\"|" >"$work/all.cpp"
"$compiler" -std=c++20 -fsyntax-only -w -I"$work" -Iinclude -Isrc "$work/all.cpp"
echo "$(wc -l <"$work/all.cpp") sources include TBB"
