#!/bin/sh
# pdf.sh SOURCES: the Z text is typeset, and nothing of it is too wide; a line that is too wide is seen. Skipped where
# LaTeX or its zed-csp is absent; that each stem has its section and the paper's paragraphs their note is tried before.
set -eu
sources=$(CDPATH='' cd -- "$1" && pwd)
tmp=$(mktemp -d) && trap 'rm -rf "$tmp"' EXIT
sh "$sources/docs/spec_pdf.sh" "$sources" "$tmp/texts" texts
for note in 'Escena}: E07, E12,' 'Punto}: as printed' 'raizcuadrada}: E03,'; do
  cat "$tmp"/texts/*.tex | grep '^.zorigin' | grep -qF "$note" || { echo "no note has $note"; exit 1; }
done
cat "$tmp"/texts/*.tex | grep '^.zorigin' | grep -q 'Init\|Tronco' && { echo 'a paragraph of ours has a note'; exit 1; }
for tool in pdflatex makeindex kpsewhich; do
  command -v $tool >/dev/null 2>&1 || { echo "skipped: $tool is absent"; exit 77; }
done
kpsewhich zed-csp.sty >/dev/null || { echo 'skipped: zed-csp.sty is absent'; exit 77; }
sh "$sources/docs/spec_pdf.sh" "$sources" "$tmp/build"
head -c 5 "$tmp/build/spec.pdf" | grep -q '^%PDF-'
for entry in 'Escena' 'Agregar_Esfera_Total' 'Escena.inv.9' 'alcances.conj.1' 'real.axiom.1'; do
  sed 's/\\//g' "$tmp/build/spec.ind" | grep -qF "$entry" || { echo "the index lacks $entry"; exit 1; }
done
grep -q 'The first intersection' "$tmp/build/spec.toc" || { echo 'the contents lack the last section'; exit 1; }

mkdir -p "$tmp/wide/spec" "$tmp/wide/docs"
cp "$sources"/spec/*.tex "$sources/spec/origin.md" "$tmp/wide/spec/"
cp "$sources/docs/spec.tex" "$sources/docs/spec_pdf.sh" "$tmp/wide/docs/"
sed -i 's/elementos = .dom de._que._tipo/& \\land elementos = \\dom mi\\_centro \\land elementos = \\dom mi\\_radio \\land elementos = \\emptyset \\land tipos = \\emptyset/' \
  "$tmp/wide/spec/escena.tex"
cmp -s "$sources/spec/escena.tex" "$tmp/wide/spec/escena.tex" && { echo 'no line was made too wide'; exit 1; }
if sh "$tmp/wide/docs/spec_pdf.sh" "$tmp/wide" "$tmp/wide/build" 2>"$tmp/said"; then echo 'a line too wide is not seen'; exit 1; fi
grep -q 'Overfull' "$tmp/said" || { cat "$tmp/said"; exit 1; }
