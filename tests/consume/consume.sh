#!/bin/sh
# consume.sh ROOT BUILD installed|targets|subdirectory|shared|headers: whether others can use the library. `installed`
# installs BUILD into a prefix with a space in its name and builds programs/ against it by CMake, some of them by
# pkg-config too; `targets` asks whether ./x build builds each file that is installed; `subdirectory` builds programs/ with
# the sources as a part of their project; `shared` as `installed`, with shared libraries built anew; `headers` compiles
# each installed header alone.
set -eu
root=$1 build=$2 way=$3
here=$root/tests/consume
work=$build/consume/$way
rm -rf "$work"
mkdir -p "$work"
prefix=$work/"a prefix"

fail() { tail -n 30 "$work/log"; echo "consume: $*"; exit 1; }
installed() { cmake --install "$1" --prefix "$prefix" >"$work/log" 2>&1 || fail "cannot install $1"; }
programs() { # programs OPTION...: builds and runs them
  { cmake -S "$here/programs" -B "$work/programs" -G Ninja -DCMAKE_BUILD_TYPE=Release "$@" && cmake --build "$work/programs"; } \
    >"$work/log" 2>&1 || fail "the programs do not build"
  for program in $(sed -n 's/^==> .\/\(.*\)\.said <==$/\1/p' "$here/expected.txt"); do
    (cd "$work" && "programs/$program" >"$program.said")  # one of them keeps a store where it runs
  done
  (cd "$work" && head -n 9 ./*.said) | diff "$here/expected.txt" -
}

case $way in
  installed)
    installed "$build"
    programs -DCMAKE_PREFIX_PATH="$prefix"
    sh "$here/by_pkg_config.sh" "$root" "$prefix" "$work/by_pkg_config"
    # The installed program has the systems that were installed with it.
    (cd "$work" && "$prefix/bin/durero" conform setup nothing) >"$work/log" 2>&1 || true
    grep -q 'expected one of .*embree' "$work/log" || fail "no systems installed"
    # Its manual, and what completes its calls.
    for file in man/man1/durero.1 man/man1/durero-conform-run.1 bash-completion/completions/durero \
      zsh/site-functions/_durero fish/vendor_completions.d/durero.fish; do
      grep -q durero "$prefix/share/$file" || fail "no $file installed"
    done ;;
  targets)
    sed -nE 's/.*TYPE (STATIC_LIBRARY|SHARED_LIBRARY|EXECUTABLE) FILES "([^"]*)".*/\2/p' "$build/cmake_install.cmake" |
      sed 's/.*\///' | sort >"$work/installed"
    ninja -C "$build" -t query durero_installation | sed -n 's/^    //p' | sort >"$work/built"
    [ "$(wc -l <"$work/installed")" -ge 10 ] || { echo "consume: nearly nothing is installed"; exit 1; }
    comm -23 "$work/installed" "$work/built" | sed 's/$/: it is installed, and .\/x build does not build it/' | { ! grep .; } ;;
  subdirectory) programs -DDURERO_SOURCE="$root" ;;
  shared)
    { cmake -S "$root" -B "$work/build" -G Ninja -DCMAKE_BUILD_TYPE=Release -DBUILD_SHARED_LIBS=ON -DDURERO_TESTS=OFF \
        -DDURERO_BENCH=OFF && cmake --build "$work/build"; } >"$work/log" 2>&1 || fail "no shared libraries"
    installed "$work/build"
    programs -DCMAKE_PREFIX_PATH="$prefix" ;;
  headers)
    installed "$build"
    for compiler in g++ clang++-16; do
      command -v $compiler >/dev/null || { echo "consume: no $compiler here"; continue; }
      (cd "$prefix/include" && find durero -name '*.h*') | sort | xargs -P "$(nproc)" -I {} sh -c "printf '%s\n' \
        '#include <{}>' '#include <{}>' | $compiler -x c++ -std=c++20 -Wall -Wextra -Wconversion -Werror \
        -fsyntax-only -I '$prefix/include' - || echo '{}'" >"$work/log" 2>&1
      [ ! -s "$work/log" ] || fail "$compiler: headers that do not compile alone"
    done ;;
esac
