#!/bin/sh
# requirements.sh: README names the packages that ./x installs, row by row, for Debian.
set -eu
# row WORD: the packages of the row that begins so.
row() { awk -F ' *[|] *' -v row="$1" '/^## Requirements/ { here = 1 } here && $2 == row { print $3 }' README.md; }
# list NAME: the packages of a list in x.
list() { awk -v name="$1" 'index($0, name "=\"") == 1 { here = 1; sub(/^[^"]*"/, "") }
  here { ends = /"/; sub(/".*/, ""); print; if (ends) exit }' x; }
words() { tr -s ' \n' '\n' | sed '/^$/d' | sort -u; }
bad=0
same() {  # same ROWS LISTS
  for word in $1; do row "$(printf %s "$word" | tr _ ' ')"; done | words >"$tmp/readme"
  for name in $2; do list "$name"; done | words >"$tmp/x"
  [ -s "$tmp/x" ] || { echo "x has no packages in $2"; bad=1; }
  diff "$tmp/readme" "$tmp/x" || { echo "README's rows $1 (<) are not the packages of $2 in x (>)"; bad=1; }
}
tmp=$(mktemp -d)
trap 'rm -rf "$tmp"' EXIT
same 'to_build libraries' build_packages
same tests test_packages
same figures bench_packages
same proofs proof_packages
same '`--systems`,_`--long`' 'systems_packages long_packages'
same reference reference_packages
same site site_packages
same document spec_packages
same packages package_packages
same page page_packages
same releases release_packages
exit "$bad"
