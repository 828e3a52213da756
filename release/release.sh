#!/bin/sh
# release.sh ROOT [--tag]: every file of a release, of the commit at hand, in ROOT/build/release-VERSION; ./x release calls it.
#   durero-VERSION.tar.gz                the sources
#   durero-VERSION-CPYTHON-….whl         a wheel: the Python package and the command durero; one for each Python
#   durero-VERSION-x86_64                the program, one file that needs no library of the machine it runs on
#   durero_….deb, libdurero-dev_….deb    Debian's packages
#   durero-VERSION.spdx.json             which libraries are in them, of which version, under which licence (SPDX 2.3)
#   durero-VERSION-lgpl.tar              the sources of the libraries under the LGPL that a wheel carries
#   CHANGES-VERSION.md                   the section of CHANGELOG.md
#   SHA256SUMS                           the digests of all of these
# Two runs give the same bytes: every time in a file is the commit's, and no folder's name is in one. The folder appears
# whole or not at all. With --tag the commit gets the tag vVERSION here, which nobody else sees until it is pushed.
# DURERO_PYTHONS names the Pythons that get a wheel, /usr/bin/python3 if it is not set. pybind11 has no stable ABI, so a
# wheel is for one series of CPython.
set -eu
root=$(CDPATH='' cd -- "$1" && pwd)
shift
tag=''
for option in "$@"; do
  case $option in --tag) tag=yes ;; *) echo "durero: ./x release does not know $option; expected --tag" >&2; exit 2 ;; esac
done
here=$root/release
cd "$root"
say() { printf '%s\n' "$*" >&2; }
give_up() { say "durero: $*"; exit 2; }

version=$(sed -nE 's/^project\(durero VERSION ([0-9.]+).*/\1/p' CMakeLists.txt)
machine=$(uname -m)
work=$root/build/release-work
sources=$work/durero-$version
out=$work/out
log=$work/log

# What is asked is refused before hours are spent on it.
[ "$machine" = x86_64 ] || give_up "no release for $machine; expected x86_64"
git rev-parse -q --verify HEAD >/dev/null || give_up "no git history here; expected a clone"
changed=$(git status --porcelain | head -n 1)
[ -z "$changed" ] || give_up "${changed#???} is not committed; expected a release of a commit"
if [ -n "$tag" ]; then
  ! grep -q "^## \[$version\] - Unreleased" CHANGELOG.md || give_up "CHANGELOG.md: [$version] is unreleased; expected its date"
  ! git rev-parse -q --verify "refs/tags/v$version" >/dev/null || give_up "the tag v$version is there; expected a new version"
fi

SOURCE_DATE_EPOCH=$(git log -1 --format=%ct)
LC_ALL=C.UTF-8 TZ=UTC
export SOURCE_DATE_EPOCH LC_ALL TZ
umask 022
if command -v ccache >/dev/null 2>&1; then  # dpkg-buildpackage has another home
  CCACHE_DIR=$(ccache --get-config cache_dir)
  export CCACHE_DIR
fi
logged() { "$@" >"$log" 2>&1 || { tail -n 40 "$log" >&2; give_up "it fails: $*; the whole log is $log"; }; }

make_sources() {
  git archive --format=tar --prefix="durero-$version/" HEAD >"$work/sources.tar"
  gzip -9n <"$work/sources.tar" >"$out/durero-$version.tar.gz"
  tar -xf "$work/sources.tar" -C "$work"
  rm "$work/sources.tar"
}

# make_wheel PYTHON: builds without isolation, by tools of the versions of release/tools.txt at a path that is the same each
# time, so that objects compiled before are found by ccache.
make_wheel() {
  rm -rf "$work/venv" "$work/build" "$work/wheels"
  logged "$1" -m venv "$work/venv"
  logged "$work/venv/bin/pip" install --quiet --requirement "$here/tools.txt"
  logged env PATH="$work/venv/bin:$PATH" pip wheel --no-cache-dir --no-deps --no-build-isolation --wheel-dir "$work/wheels" \
    --config-settings=build-dir="$work/build" --config-settings=build.targets="durero_python;durero_command;durero" \
    --config-settings=cmake.define.DURERO_STATIC="$root/build/libraries/prefix" "$sources"
  logged env PATH="$work/venv/bin:$PATH" auditwheel repair --exclude "libdurero.so.$version" --wheel-dir "$out" "$work/wheels"/durero-*.whl
}

# make_program: linked of the objects of the last wheel.
make_program() {
  strip -o "$out/durero-$version-$machine" "$work/build/durero"
  [ "$("$out/durero-$version-$machine" --version)" = "durero $version" ] || give_up "the program has another version than $version"
}

make_packages() {
  logged "$sources/x" package
  cp "$sources"/build/package/*.deb "$out/"
}

# make_lgpl: the names in order, and no time or owner of its own.
make_lgpl() {
  tar --sort=name --mtime="@$SOURCE_DATE_EPOCH" --owner=0 --group=0 --numeric-owner --mode=u=rwX,go=rX \
    -C "$root/build/libraries" -cf "$out/durero-$version-lgpl.tar" lgpl
}

# make_sbom: of Debian's packages what dpkg says, and what was compiled of which sources.
make_sbom() {
  cat "$root/build/libraries/prefix/sources.txt" >"$work/compiled.txt"
  dpkg-query -W -f '${db:Status-Abbrev} ${Package} ${Version} ${source:Package} ${source:Version}\n' |
    sed -n 's/^ii *//p' | sort >"$work/installed.txt"
  "$work/venv/bin/pip" freeze | sed -n 's/^pybind11==/pybind11 /p' >>"$work/compiled.txt"
  /usr/bin/python3 "$here/sbom.py" --version "$version" --time "$SOURCE_DATE_EPOCH" --licences "$sources/docs/licences.md" \
    --compiled "$work/compiled.txt" --installed "$work/installed.txt" "$out" >"$work/sbom" || give_up "no list of libraries"
  mv "$work/sbom" "$out/durero-$version.spdx.json"
}

rm -rf "$work"
mkdir -p "$out"
make_sources
say "durero: the libraries that the wheel carries; a quarter of an hour the first time"
sh "$here/libraries.sh" "$root/build/libraries"
for python in ${DURERO_PYTHONS:-/usr/bin/python3}; do
  say "durero: the wheel for $("$python" --version)"
  make_wheel "$python"
done
make_program
say "durero: Debian's packages"
make_packages
make_lgpl
sh "$here/changes.sh" "$version" <CHANGELOG.md >"$out/CHANGES-$version.md"
make_sbom
(cd "$out" && sha256sum -- *) >"$work/sums"
mv "$work/sums" "$out/SHA256SUMS"
final=$root/build/release-$version
rm -rf "$final"
mv "$out" "$final"
if [ -n "$tag" ]; then
  git tag --annotate "v$version" --cleanup=verbatim --file "$final/CHANGES-$version.md"
  say "durero: the tag v$version; git push origin v$version publishes it"
fi
rm -rf "$work"
echo "$final"
