#!/bin/sh
# Each public name has a sentence in the reference, and Doxygen finds nothing wrong in any (docs/Doxyfile).
command -v doxygen >/dev/null 2>&1 || { echo "reference.sh: skipped, doxygen is absent"; exit 0; }
tmp=$(mktemp -d) && trap 'rm -rf "$tmp"' EXIT
{ cat docs/Doxyfile; printf '%s\n' 'GENERATE_HTML = NO' 'GENERATE_XML = YES' "OUTPUT_DIRECTORY = $tmp"; } >"$tmp/Doxyfile"
doxygen "$tmp/Doxyfile" 2>&1 >/dev/null | sed "s:^$(pwd -P)/::" >"$tmp/said"
{
  [ -f "$tmp/xml/index.xml" ] || echo "docs/Doxyfile:1: no reference is written"
  cat "$tmp/said"
} | { ! grep .; }
