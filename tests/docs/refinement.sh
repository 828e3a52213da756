#!/bin/sh
# refinement.sh SOURCES: each theorem that docs/refinement.md names as proof is one of proofs/Main.v, each file that it
# names is there, each row has both, and a name that is not there is seen.
set -eu
cd "$1"
missing() { # missing PAGE: what it names and nobody has
  page=$1
  grep -oE '`(spec|include|src|tests|proofs)/[A-Za-z0-9_/.]+`' "$page" | tr -d '\140' | sort -u | while read -r file; do
    [ -f "$file" ] || echo "$page: $file is not there"
  done
  awk -F ' *[|] *' -v page="$page" '/^\| step / { getline; next } /^\|/ {
      if (NF != 6) print page ":" FNR ": a row of " NF - 2 " cells"
      if ($4 !~ /`[A-Za-z_0-9]+`/) print page ":" FNR ": a step without a theorem"
      if ($5 !~ /`tests\/[^`]+`/) print page ":" FNR ": a step without a test" }' "$page"
  awk -F ' *[|] *' '/^\|/ && NF == 6 { print $4 }' "$page" | grep -oE '`[A-Za-z_0-9]+`' | tr -d '\140' | sort -u |
    while read -r theorem; do
      grep -qE "^Theorem $theorem( |:|\$)" proofs/Main*.v || echo "$page: $theorem is no theorem of proofs/Main.v"
    done
}
missing docs/refinement.md | { ! grep .; }
tmp=$(mktemp) && trap 'rm -f "$tmp"' EXIT
for fault in 's/total_operations_are_total/all_operations_are_total/' 's/retrieve_test/retrieved_test/' 's/| `certified_roots` |/| |/; s/, `certified_roots`//; s/`a_certified_miss_is_a_miss`//; s/, `the_decision_on_a_sphere_is_right`//; s/, `certified_roots_of_a_cylinder`//; s/, `the_decisions_up_to_a_limit_are_right`//'; do
  sed "$fault" docs/refinement.md >"$tmp"
  [ -n "$(missing "$tmp")" ] || { echo "not seen: $fault"; exit 1; }
done
