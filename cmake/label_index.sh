#!/bin/sh
# label_index.sh: where each label of the Z text stands, one place a line:
#   LABEL<tab>KIND<tab>FILE:LINE[<tab>NAME]    KIND one of text, clause, function, test, theorem
# and of each type of model, under its name in place of a label, KIND type.
# Run at the root. A clause is a quoted label in model; a function names the definition that it carries out; a theorem
# names, in the comment before it, the labels that it discharges. What spec/tablas.tex and spec/promocion.tex say of the
# program's own states is no clause: the functions of scene and surface that carry it out name it.
LC_ALL=C
export LC_ALL
label='[A-Za-z_]+\.(pre|post|inv|def|conj)\.[0-9]+'
places() { # places KIND: `FILE:LINE:LABEL` to index lines
  sed -E "s/^([^:]+:[0-9]+):[^A-Za-z_]*($label).*/\2	$1	\1/"
}
{
  grep -onHE "% $label$" spec/*.tex | places text
  grep -onHE "\"$label\"" -r include/durero/model src/model | places clause
  grep -onHE "\b[A-Za-z_]+\.def\.[0-9]+" -r include/durero/model | places function
  grep -onHE "\b$label\b" -r include/durero/scene src/scene include/durero/surface src/surface |
    while IFS= read -r place; do
      grep -qE "% ${place##*:}\$" spec/tablas.tex spec/promocion.tex && printf '%s\n' "$place"
    done | places function
  grep -nHE "^(struct|class|enum class) [A-Za-z_]+( .*\{.*)?$" -r include/durero/model |
    sed -E 's/^([^:]+:[0-9]+):(struct|class|enum class) ([A-Za-z_]+).*/\3	type	\1/'
  find tests -name '*.cpp' -exec grep -onHE "\b$label\b" {} + | places test
  find proofs -name '*.v' ! -name Especificacion.v | sort | while read -r file; do
    awk -v file="$file" '
      { line = $0
        while (match(line, /[A-Za-z_]+\.(pre|post|inv|def|conj)\.[0-9]+/)) {
          named[++count] = substr(line, RSTART, RLENGTH); line = substr(line, RSTART + RLENGTH) } }
      count && /^ *(Theorem|Lemma|Corollary|Proposition|Fact|Remark|Example) / {
        name = $2; sub(/[:({[].*/, "", name)
        for (i = 1; i <= count; ++i) print named[i] "\ttheorem\t" file ":" NR "\t" name
        count = 0 }' "$file"
  done
} | sort -u -t '	' -k1,1 -k2,2 -k3,3
