#!/bin/sh
# One layout for the Z text: no line beyond 100 columns, and before each box a sentence of prose of its own.
awk '
  FNR == 1 { told = 0 }
  length($0) > 100 { print FILENAME ":" FNR ": a line of " length($0) " columns; 100 are allowed" }
  /^\\begin\{zsection\}/ { told = 1 }
  /^\\begin\{(zed|axdef|gendef|schema)\}/ { if (!told) print FILENAME ":" FNR ": a box without a sentence before it"; inside = 1 }
  /^\\end\{/ { inside = 0; told = 0; next }
  !inside && !/^%/ && NF { told = 1 }' spec/*.tex | { ! grep .; }
