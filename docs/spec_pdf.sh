#!/bin/sh
# The Z text as a PDF, by LaTeX's zed-csp: spec_pdf.sh SOURCES BUILD [texts]. The document is BUILD/spec.pdf, what LaTeX said
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
  # Behind the sentence before a box of the paper a margin note says what changed it.
  awk -v origins="$sources/spec/origin.md" '
    BEGIN { FS = " *[|] *"; while ((getline <origins) > 0) if ($4 == "the paper\047s") { gsub(/`/, "", $2); of[$2] = $5 }
            FS = " " }
    function plain(name) { gsub(/[\\ ]/, "", name); return name }
    function declares(name,   shown) {
      gsub(/ /, "", name); shown = name; gsub(/\\_/, "\\protect\\_", shown)
      printf "\\zname{%s}{%s}", shown, plain(name)
    }
    function found_name(   name) {  # what the line declares, if anything
      if (/^\\begin\{schema\}/) { name = $0; sub(/^\\begin\{schema\}\{/, "", name); sub(/\}.*/, "", name) }
      else if (axdef && match($0, /^  [A-Za-z\\_]+ :/)) name = substr($0, 3, RLENGTH - 4)
      else if (zed && match($0, /^  [A-Za-z\\_]+ (==|::=)/)) { name = substr($0, 3); sub(/ .*/, "", name) }
      else if (zed && match($0, /^  \[ [A-Za-z\\_]+ \]/)) name = substr($0, 5, RLENGTH - 6)
      return name
    }
    function note(name) {
      if (!(name in of)) return
      notes[begin] = notes[begin] (notes[begin] == "" ? "" : "; ") "\\ensuremath{" shown_name "}: " of[name]
    }
    /^\\begin\{/ { begin = FNR }
    /^\\begin\{axdef\}/ { axdef = 1 } /^\\where/ { axdef = 0 } /^\\end\{/ { axdef = 0; zed = 0 } /^\\begin\{zed\}/ { zed = 1 }
    NR == FNR { shown_name = found_name(); note(plain(shown_name)); next }
    NF == 0 { empty = 1; next }
    empty { if (!/^\\begin\{(schema|axdef|zed)\}/) { print ""; if (!heading) print "\\filbreak" } empty = 0 }
    { heading = /^\\end\{zsection\}/ }
    /^\\begin\{/ && notes[FNR] != "" { printf "\\zorigin{%s}%%\n", notes[FNR] }
    /^\\begin\{schema\}/ { declares(found_name()); printf "%%\n" }
    { line = $0; found = /^\\begin/ ? "" : found_name()
      if (match(line, /  % [A-Za-z_]+\.(pre|post|inv|def|axiom|conj)\.[0-9]+$/)) {
        label = substr(line, RSTART + 4); line = substr(line, 1, RSTART - 1)
        shown = label; gsub(/_/, "\\protect\\_", shown)
        line = line "\\zlabel{" shown "}{" label "}"
      }
      if (line ~ /([-+*]|\\oplus|\\cap) *\\\\$/) { sub(/ *\\\\$/, "", line); line = line "{} \\\\" }  # spaced as between two terms
      print line
      if (found != "") { declares(found); printf "%%\n" } }' "$text" "$text" >"$(basename "$text")"
done
cp "$sources/docs/spec.tex" .
[ "${3-}" = texts ] && exit  # as far as it goes without LaTeX
for pass in 1 2 3; do
  pdflatex -interaction=nonstopmode -halt-on-error spec.tex >said.txt 2>&1 || { tail -n 30 said.txt >&2; exit 1; }
  makeindex -q spec.idx 2>index.txt || { cat index.txt >&2; exit 1; }
done
if grep -nE '^(Overfull|LaTeX Warning|! )|undefined' spec.log >&2; then exit 1; fi
