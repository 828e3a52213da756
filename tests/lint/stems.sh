#!/bin/sh
# Five folders, one stem: what spec/STEM.tex says is carried out, tested and proved under the same name.
capital() { printf '%s' "$1" | cut -c1 | tr '[:lower:]' '[:upper:]' | tr -d '\n'; printf '%s' "$1" | cut -c2-; }
for text in spec/*.tex; do
  stem=$(basename "$text" .tex)
  for file in "spec/impresa/$stem.tex" "include/durero/model/$stem.hpp" "src/model/$stem.cpp" \
    "tests/model/${stem}_test.cpp" "proofs/$(capital "$stem").v"; do
    [ -f "$file" ] || echo "$text:1: its counterpart $file is missing"
  done
done | { ! grep .; }
