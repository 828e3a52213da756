#!/bin/sh
# install.sh PYTHON ROOT BUILD: makes the sdist (sdist.sh) and from it the wheel, as pip does of a clone, and uses what is
# installed in a fresh environment. The wheel is small.
set -eu
python=$1 root=$2 work=$3/python-install
sh "$2/tests/python/sdist.sh" "$python" "$root" "$work"
bin=$work/venv/bin
fail() { tail -n 30 "$work/log"; echo "install: $*"; exit 1; }

"$bin/pip" wheel --quiet --no-deps --wheel-dir "$work" "$work"/durero-*.tar.gz >"$work/log" 2>&1 || fail "no wheel"
size=$(wc -c <"$(echo "$work"/durero-*.whl)")
echo "the wheel has $size bytes"
[ "$size" -le 10000000 ] || fail "expected at most 10 MB"

"$bin/pip" install --quiet "$work"/durero-*.whl >"$work/log" 2>&1 || fail "the wheel does not install"
# The command knows its systems and its labels as that of the build tree does.
[ "$("$bin/durero" --version)" = "$("$3/durero" --version)" ] || fail "the wheel brings another command"
for words in 'spec show reduccion' 'spec show Agregar_Elemento'; do
  # shellcheck disable=SC2086  # words are meant to split
  "$3/durero" $words >"$work/shown"
  # shellcheck disable=SC2086
  "$bin/durero" $words 2>>"$work/log" | cmp "$work/shown" - >>"$work/log" || fail "durero $words says other things than that of the tree"
done
env -u DURERO_SYSTEMS "$bin/durero" conform setup nothing 2>&1 | grep -q 'embree' || fail "the command does not find its systems"
module=$(echo "$work"/venv/lib/python3*/site-packages/durero/_durero.*.so)
sh "$root/tests/python/exports.sh" "$module" || fail "the module shows the layers to others"
# The examples of the pages and of the docstrings, by the NumPy of PyPI: the tests of the build tree have Debian's, which
# is of another series.
"$bin/pip" install --quiet pytest 'numpy>=2' >"$work/log" 2>&1 || fail "no NumPy 2"
DURERO=$root/x DURERO_ROOT=$root sh "$root/tests/python/run.sh" "$bin/python" "$root/tests/python/docs_test.py" >"$work/log" 2>&1 ||
  fail "an example that is not so by NumPy 2"
"$bin/python" -c 'import numpy; print("examples by NumPy", numpy.__version__)'
cd "$work"
"$bin/python" -c 'import doctest, durero, durero.scene, sys; print(durero.__version__)
sys.exit(sum(doctest.testmod(m).failed for m in (durero, durero.scene, durero.spec, durero.conform)))'
