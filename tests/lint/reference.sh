#!/bin/sh
# Each public name has a sentence in the reference, and Doxygen finds nothing wrong in any (docs/Doxyfile). The layers
# in `later` still have names without one; a layer that has none any more leaves that list.
later='io zed'
command -v doxygen >/dev/null 2>&1 || { echo "reference.sh: skipped, doxygen is absent"; exit 0; }
tmp=$(mktemp -d) && trap 'rm -rf "$tmp"' EXIT
{ cat docs/Doxyfile; printf '%s\n' 'GENERATE_HTML = NO' 'GENERATE_XML = YES' "OUTPUT_DIRECTORY = $tmp"; } >"$tmp/Doxyfile"
doxygen "$tmp/Doxyfile" 2>&1 >/dev/null | sed "s:^$(pwd -P)/::" >"$tmp/said"
{
  [ -f "$tmp/xml/index.xml" ] || echo "docs/Doxyfile:1: no reference is written"
  for layer in $later; do
    grep -q "^include/durero/$layer/.* is not documented" "$tmp/said" ||
      echo "tests/lint/reference.sh:4: each name of $layer has its sentence; expected it to leave the list"
  done
  grep -vE "^include/durero/($(echo "$later" | tr ' ' '|'))/.* is not documented" "$tmp/said"
} | { ! grep .; }
