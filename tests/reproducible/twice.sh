#!/bin/sh
# twice.sh ROOT BUILD COMPILER: builds the program and the libraries twice, from copies of the sources in folders of
# different length, and compares every byte.
set -eu
root=$1 work=$2/twice compiler=$3
rm -rf "$work"
first=$work/a second=$work/another-folder/whose-name-is-longer
for folder in "$first" "$second"; do
  mkdir -p "$folder"
  (cd "$root" && tar --exclude-vcs --exclude=./build -cf - .) | tar -xf - -C "$folder"
  # Without ccache, which would hand the second build what the first has compiled.
  { CCACHE_DISABLE=1 cmake -S "$folder" -B "$folder/build" -G Ninja -DCMAKE_BUILD_TYPE=Release -DCMAKE_CXX_FLAGS_RELEASE=-O2 \
      -DCMAKE_CXX_COMPILER="$compiler" -DDURERO_TESTS=OFF -DDURERO_BENCH=OFF &&
      CCACHE_DISABLE=1 cmake --build "$folder/build"; } \
    >"$work/log" 2>&1 || { tail -n 30 "$work/log"; echo "twice: the build failed: $work/log"; exit 1; }
done
compared=0 differ=0
for file in "$first"/build/durero "$first"/build/libdurero_*; do
  compared=$((compared + 1))
  cmp "$file" "$second/build/${file##*/}" || differ=$((differ + 1))
done
echo "$compared files of two builds compared, $differ differ"
[ "$compared" -gt 10 ] && [ "$differ" = 0 ]
rm -rf "$work"
