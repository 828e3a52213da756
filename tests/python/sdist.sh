#!/bin/sh
# sdist.sh PYTHON ROOT FOLDER: makes FOLDER/durero-….tar.gz, the sources that PyPI gets, by FOLDER/venv. A wheel is built of
# the same files in them as in ROOT, and they have none that it does not need. Status 77: no venv or no PyPI here.
set -eu
python=$1 root=$2 work=$3
rm -rf "$work"
mkdir -p "$work/sources"
"$python" -m venv "$work/venv" 2>/dev/null || { echo "absent: venv (python3-venv of Debian)"; exit 77; }
bin=$work/venv/bin
"$bin/pip" install --quiet build pybind11 >"$work/log" 2>&1 || { echo "absent: PyPI"; exit 77; }
fail() { tail -n 30 "$work/log"; echo "sdist: $*"; exit 1; }

"$bin/python" -m build --sdist --outdir "$work" "$root" >"$work/log" 2>&1 || fail "no sdist"
tar -xzf "$work"/durero-*.tar.gz -C "$work/sources" --strip-components 1
: >"$work/log"
(cd "$work/sources" && find . -type f | sed 's|^\./||' | sort) >"$work/files"
! grep -E '^(campaigns|ci|demo|debian|editors|notebooks|release|web|docs/[^p]|\.ci|x$)' "$work/files" || fail "the sdist has these too"
# Of the tests and the proofs, the sources in which the command finds the labels of the Z text, and what it carries.
! grep -E '^(tests|proofs)/' "$work/files" | grep -vE '^(tests/.*\.cpp|proofs/.*\.v|proofs/assumptions\.txt)$' ||
  fail "the sdist has these too"

# inputs_of SOURCES NAME: the files of a folder of sources that a wheel is built of.
inputs_of() {
  cmake -S "$1" -B "$work/$2" -G Ninja -DSKBUILD=ON -DCMAKE_BUILD_TYPE=Release -DDURERO_PYTHON=ON -DDURERO_TESTS=OFF -DDURERO_BENCH=OFF \
    -DPython_EXECUTABLE="$bin/python" -Dpybind11_DIR="$("$bin/python" -m pybind11 --cmakedir)" >"$work/log" 2>&1 ||
    fail "CMake does not take $1"
  ninja -C "$work/$2" -t inputs durero_python durero_command | grep -vF "$work/$2/" | grep -F "$1/" | sed "s|^$1/||" | sort
}
inputs_of "$root" whole >"$work/inputs"
inputs_of "$work/sources" unpacked >"$work/inputs_unpacked"
diff "$work/inputs" "$work/inputs_unpacked" >"$work/log" || fail "a wheel of the sdist is not built of the same files"
comm -23 "$work/inputs" "$work/files" >"$work/log"
[ ! -s "$work/log" ] || fail "the sdist lacks these files"
echo "$(wc -l <"$work/files") files, of which $(wc -l <"$work/inputs") are compiled or carried"
