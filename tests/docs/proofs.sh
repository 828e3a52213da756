#!/bin/sh
# proofs.sh SOURCES: each arrow of docs/proofs.md is held by a theorem of proofs/Main.v, or says that it is tested, and
# where, or trusted; each theorem and each file that the page names is there; and a page of which this is not so is seen.
set -eu
cd "$1"
missing() { # missing PAGE: what it names and nobody has
  page=$1
  grep -oE '`(spec|include|src|tests|proofs|docs)/[A-Za-z0-9_/.]+`' "$page" | tr -d '\140' | sort -u | while read -r file; do
    [ -e "$file" ] || echo "$page: $file is not there"
  done
  awk -F ' *[|] *' -v page="$page" '/^\| from / { getline; next } /^\|/ {
      if (NF != 6) { print page ":" FNR ": a row of " NF - 2 " cells"; next }
      theorem = $4 ~ /`[a-z_0-9A-Z]+`/; tested = $4 ~ /\*tested\*: `tests\/[^`]+`/; trusted = $4 ~ /\*trusted\*/
      if (!theorem && !tested && !trusted) print page ":" FNR ": an arrow that nothing holds"
      if (($4 $5) ~ /\*tested\*/ && ($4 $5) !~ /`tests\/[^`]+`/) print page ":" FNR ": tested, but not where" }' "$page"
  awk -F ' *[|] *' '/^\|/ && NF == 6 { print $4 }' "$page" | grep -oE '`[A-Za-z0-9]+_[A-Za-z_0-9]+`' | tr -d '\140' | sort -u |
    while read -r theorem; do
      grep -qE "^Theorem $theorem( |:|\$)" proofs/Main*.v || echo "$page: $theorem is no theorem of proofs/Main.v"
    done
}
missing docs/proofs.md | { ! grep .; }
tmp=$(mktemp) && trap 'rm -f "$tmp"' EXIT
for fault in 's/the_printed_hit_is_the_texts_hit/the_printed_hit_is_right/' 's/quick_round_test/quick_rounding_test/' \
  's/`grids_as_they_run`/obvious/' 's/\*tested\*: `tests\/trace\/batch_test.cpp`.*|/*tested* |/'; do
  sed "$fault" docs/proofs.md >"$tmp"
  if cmp -s docs/proofs.md "$tmp"; then echo "no fault any more: $fault"; exit 1; fi
  [ -n "$(missing "$tmp")" ] || { echo "not seen: $fault"; exit 1; }
done
