#!/bin/sh
# by_pkg_config.sh ROOT PREFIX WORK: the calls of the compiler that docs/library.md shows build programs against what is
# installed in PREFIX, without a word, and these print what expected.txt says. The flags for C++ build one in C, too.
set -eu
root=$1 prefix=$2 work=$3
here=$root/tests/consume
mkdir -p "$work"
cp "$here"/programs/*.c "$here"/programs/*.cpp "$work/"
cd "$work"
export PKG_CONFIG_PATH="$prefix/lib/pkgconfig"
fail() { cat "$work/log"; echo "consume: $*"; exit 1; }
right() { # right PROGRAM: ./a.out prints what it should
  ./a.out >said || fail "$1: status $?"
  awk -v program="==> ./$1.said <==" '/^==> / { is_here = $0 == program; next } is_here && NF' "$here/expected.txt" | diff - said ||
    fail "$1: another answer"
}

sh "$root/tests/docs/install_lines.sh" "$root" | grep '^eval c' >calls
grep -q '^eval c++ .*\.cpp ' calls && grep -q '^eval cc .*\.c ' calls || fail "docs/library.md shows no call for C++ or none for C"
while IFS= read -r call; do
  rm -f a.out
  sh -c "$call" >log 2>&1 || fail "$call: status $?"
  [ ! -s log ] || fail "$call: a warning"
  program=${call#eval c* }
  program=${program%% *}
  right "${program%.*}"
done <calls
# A compiler of C by another name, which refuses what is no flag of C.
if command -v clang-16 >/dev/null; then
  eval "clang-16 -Werror first_hit.c $(pkg-config --cflags --libs durero-c)" >log 2>&1 || fail "no program in C by Clang"
  right first_hit
fi
if cc --version | grep -q 'Free Software Foundation'; then  # GCC warns of a flag of C++ and goes on
  eval "cc first_hit.c $(pkg-config --cflags --libs durero)" >log 2>&1 || fail "no program in C by the flags for C++"
  right first_hit
fi
echo "programs built by pkg-config: $(wc -l <calls) documented calls"
