#!/bin/sh
# documented.sh ROOT BUILD: the commands by which docs/library.md builds and installs the library, literally, in a copy of
# the sources that holds no build. They install below DESTDIR, so that /opt stays as it is. A program in C and one in C++
# are then built by the page's calls of pkg-config.
set -eu
root=$1 work=$2/consume/documented
here=$root/tests/consume
rm -rf "$work"
mkdir -p "$work/tree"
fail() { tail -n 30 "$work/log"; echo "consume: $*"; exit 1; }
(cd "$root" && tar --exclude-vcs --exclude=./build -cf - .) | tar -xf - -C "$work/tree"
sh "$root/tests/docs/install_lines.sh" "$root" |
  awk '/^# / { is_here = /^# docs\/library.md:/; next } is_here; is_here && /^cmake --install/ { exit }' >"$work/install"
grep -qx './x build' "$work/install" && grep -q '^cmake --install' "$work/install" || fail "docs/library.md does not build and install"
(cd "$work/tree" && DESTDIR=$work/installed sh -e "$work/install") >"$work/log" 2>&1 || fail "the documented lines do not install"
prefix=$work/installed$(sed -n 's/^cmake --install.* --prefix //p' "$work/install")
sh "$here/by_pkg_config.sh" "$root" "$prefix" "$work/programs"
rm -rf "$work/tree"
