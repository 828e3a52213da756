#!/bin/sh
# compilers.sh ROOT BUILD clang|avx2|debug COMPILER: builds the program again, by Clang, by COMPILER for machines with AVX2
# and fused multiply-add, or by COMPILER without optimisation, and checks that it prints the bytes of tests/conform/bytes.txt. Where it does not, prints the first
# line in which each file of BUILD and of the other build differ. Status 77: this machine cannot make or run that build.
set -eu
root=$1 build=$2 name=$3 compiler=$4 flags='' type=Release
other=$build/compilers/$name
mkdir -p "$other"
case $name in
  clang)
    compiler=$(command -v clang++-16 || command -v clang++) || { echo "compilers: no clang++ here"; exit 77; } ;;
  avx2)
    flags=-march=x86-64-v3
    printf 'int main() { return !(__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma")); }\n' >"$other/has.cpp"
    "$compiler" "$other/has.cpp" -o "$other/has" && "$other/has" || { echo "compilers: no AVX2 here"; exit 77; } ;;
  debug)
    type=Debug ;;
esac
{
  cmake -S "$root" -B "$other" -G Ninja -DCMAKE_BUILD_TYPE="$type" -DCMAKE_CXX_FLAGS_RELEASE=-O2 \
    -DCMAKE_CXX_COMPILER="$compiler" -DCMAKE_CXX_FLAGS="$flags" -DDURERO_TESTS=ON -DDURERO_PCH=OFF &&
    cmake --build "$other" --target conform_tests
} >"$other/log" 2>&1 || { tail -n 40 "$other/log"; echo "compilers: the build failed: $other/log"; exit 1; }

test='[#bytes_test]'
if "$other/tests/conform_tests" --warn NoTests --filenames-as-tags "$test"; then exit 0; fi
for one in "$build" "$other"; do
  mkdir -p "$one/bytes"
  BYTES_DIR=$one/bytes "$one/tests/conform_tests" --filenames-as-tags "$test" >/dev/null || true
done
for file in "$other"/bytes/*.rays "$other"/bytes/*.hits; do
  diff "$build/bytes/${file##*/}" "$file" >"$other/differences" || { echo "${file##*/}:"; head -n 4 "$other/differences"; }
done
exit 1
