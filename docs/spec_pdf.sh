#!/bin/sh
# The Z text as a PDF, by LaTeX's zed-csp: spec_pdf.sh SOURCES BUILD. The document is BUILD/spec.pdf, what LaTeX said
# BUILD/spec.log. A line that is too wide, a name that LaTeX does not know and any other warning of its fail.
set -eu
sources=$(CDPATH='' cd -- "$1" && pwd)
mkdir -p "$2"
cd "$2"
for text in "$sources"/spec/*.tex; do
  grep -qF "\\input{$(basename "$text" .tex)}" "$sources/docs/spec.tex" ||
    { echo "docs/spec.tex has no section of $(basename "$text")" >&2; exit 1; }
  # The label in the comment that ends a line becomes one that is seen; what a box declares goes into the index. A box is
  # of the paragraph before it, so that no page ends between the two; where a box does not fit, its paragraph starts a page.
  awk '
    function plain(name) { gsub(/\\/, "", name); return name }
    function declares(name,   shown) {
      gsub(/ /, "", name); shown = name; gsub(/\\_/, "\\protect\\_", shown)
      printf "\\zname{%s}{%s}", shown, plain(name)
    }
    NF == 0 { empty = 1; next }
    empty { if (!/^\\begin\{(schema|axdef|zed)\}/) { print ""; if (!heading) print "\\filbreak" } empty = 0 }
    { heading = /^\\end\{zsection\}/ }
    /^\\begin\{schema\}/ { name = $0; sub(/^\\begin\{schema\}\{/, "", name); sub(/\}.*/, "", name); declares(name); printf "%%\n" }
    /^\\begin\{axdef\}/ { axdef = 1 } /^\\where/ { axdef = 0 } /^\\end\{/ { axdef = 0; zed = 0 } /^\\begin\{zed\}/ { zed = 1 }
    { line = $0; found = ""
      if (match(line, /  % [A-Za-z_]+\.(pre|post|inv|def|axiom|conj)\.[0-9]+$/)) {
        label = substr(line, RSTART + 4); line = substr(line, 1, RSTART - 1)
        shown = label; gsub(/_/, "\\protect\\_", shown)
        line = line "\\zlabel{" shown "}{" label "}"
      }
      if (line ~ /([-+*]|\\oplus|\\cap) *\\\\$/) { sub(/ *\\\\$/, "", line); line = line "{} \\\\" }  # spaced as between two terms
      if (axdef && match(line, /^  [A-Za-z\\_]+ :/)) found = substr(line, 3, RLENGTH - 4)
      if (zed && match(line, /^  [A-Za-z\\_]+ (==|::=)/)) { found = substr(line, 3); sub(/ .*/, "", found) }
      print line
      if (found != "") { declares(found); printf "%%\n" } }' "$text" >"$(basename "$text")"
done
cp "$sources/docs/spec.tex" .
for pass in 1 2 3; do
  pdflatex -interaction=nonstopmode -halt-on-error spec.tex >said.txt 2>&1 || { tail -n 30 said.txt >&2; exit 1; }
  makeindex -q spec.idx 2>index.txt || { cat index.txt >&2; exit 1; }
done
if grep -nE '^(Overfull|LaTeX Warning|! )|undefined' spec.log >&2; then exit 1; fi
