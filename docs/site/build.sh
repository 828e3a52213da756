#!/bin/sh
# build.sh DURERO ROOT OUT: all documents as a site of plain files in OUT, which needs no server and no other host. The page that
# runs Durero in a browser is in it where build/page has it.
set -eu
durero=$1 root=$(CDPATH='' cd -- "$2" && pwd)
mkdir -p "$3"
out=$(CDPATH='' cd -- "$3" && pwd)
tree=$out.tree
log=$out.log
here=$root/docs/site
PYTHONDONTWRITEBYTECODE=1
export PYTHONDONTWRITEBYTECODE
# Debian's packages are those of Debian's Python, where another stands before it.
python=python3
"$python" -c 'import sphinx, myst_parser, furo' 2>/dev/null || python=/usr/bin/python3

rm -rf "$out" "$tree" "$tree.doctrees" "$tree.reference"
mkdir -p "$tree.reference"
failed() { tail -n 40 "$log" >&2; echo "site: $1; the whole log is $log" >&2; exit 1; }
(cd "$root" && { cat docs/Doxyfile; echo "OUTPUT_DIRECTORY = $tree.reference"; } | doxygen -) >"$log" 2>&1 || failed 'no reference'
"$python" "$here/tree.py" "$durero" "$root" "$tree"
"$python" -m sphinx -q -W --keep-going -E -b html -d "$tree.doctrees" -c "$here" "$tree" "$out" >>"$log" 2>&1 || failed 'not built'

mv "$tree.reference/html" "$out/cpp"
"$python" "$here/repairs.py" "$out"
[ ! -f "$root/build/page/index.html" ] || cp -R "$root/build/page" "$out/page"
rm -rf "$tree" "$tree.doctrees" "$tree.reference" "$out/.buildinfo" "$out/objects.inv"
echo "$out/index.html"
