#!/bin/sh
# Labels are the index of everything. Each predicate of spec/ has a label; the clause that evaluates it (or, for a
# definition, the function that carries it out), the test that names it and the theorem that uses it are found by it.
# A label on one side that the others lack fails, both ways. An axiom is evaluated by nobody; that it is true of the numbers
# of the proofs is a theorem. Nor is a conjecture, which `spec check` tries; the theorem that it leads to states it. Both
# stand as statements in Especificacion.v, which exports them, and Main.v proves them by that name. Those of
# spec/malla.tex stand in Malla.v, by hand, and those of spec/historia.tex in Cambios.v, Vista.v and Historia.v; those of
# spec/tablas.tex and spec/promocion.tex, which speak of the program's own states, stand in Tablas.v, TotalRows.v and
# Promocion.v; what these say is no clause of model, and the functions of scene and surface that carry it out name it.
kinds='pre|post|inv|def'
label="[A-Za-z_]+\.($kinds)\.[0-9]+"
tmp=$(mktemp -d) && trap 'rm -rf "$tmp"' EXIT
grep -ohE "% $label" spec/*.tex | cut -c3- | sort >"$tmp/all"
sort -u "$tmp/all" >"$tmp/spec"
grep -ohE "\"$label\"" -r include/durero/model src/model | tr -d '"' | sort >"$tmp/clauses.all"
sort -u "$tmp/clauses.all" >"$tmp/clauses"
# A clause has two lines in model: where it is stated, and where it is handed over with what holds.
constants() { sed -E 's/^(.*)_(pre|post|inv)_([0-9]+)$/\1.\2.\3/' | sort -u; }
grep -ohE "\bclause [A-Za-z_]+_(pre|post|inv)_[0-9]+" -r include/durero/model | cut -d' ' -f2 | constants >"$tmp/stated"
grep -rh '' include/durero/model src/model | grep -v '^inline constexpr ' |
  grep -ohE "\b[A-Za-z_]+_(pre|post|inv)_[0-9]+\b" | constants >"$tmp/evaluated"
grep -ohE "\b[A-Za-z_]+\.def\.[0-9]+" -r include/durero/model | sort -u >"$tmp/defs"
grep -ohE "% $label" spec/tablas.tex spec/promocion.tex | cut -c3- | sort -u >"$tmp/refined"
grep -ohE "\b$label" -r include/durero/scene src/scene include/durero/surface src/surface | sort -u |
  comm -12 - "$tmp/refined" >"$tmp/carried"
grep -ohE "\b$label" -r tests --include=*.cpp | sort -u >"$tmp/tests"
grep -vE '^(#|$)' tests/lint/labels-without-clause.txt | cut -d' ' -f1 | sort >"$tmp/excluded"

missing() { comm -23 "$1" "$2" | sed "s|\$|: $3|"; }
{
  uniq -d "$tmp/all" | sed 's/$/: stands twice in spec/'
  uniq -d "$tmp/clauses.all" | sed 's/$/: has two clauses/'
  comm -23 "$tmp/spec" "$tmp/refined" >"$tmp/spec.model"
  grep '\.def\.' "$tmp/spec.model" >"$tmp/spec.def"
  grep -v '\.def\.' "$tmp/spec.model" >"$tmp/spec.clause"
  missing "$tmp/refined" "$tmp/carried" 'is named by no function of scene or surface'
  comm -23 "$tmp/spec.clause" "$tmp/clauses" | comm -23 - "$tmp/excluded" | sed 's/$/: has no clause in model/'
  comm -12 "$tmp/excluded" "$tmp/clauses" | sed 's/$/: has a clause, so its line in labels-without-clause.txt must go/'
  missing "$tmp/excluded" "$tmp/spec.clause" 'stands in labels-without-clause.txt but not in spec'
  missing "$tmp/clauses" "$tmp/spec" 'is a clause of model, but no predicate of spec'
  missing "$tmp/stated" "$tmp/clauses" 'is stated under another label than its name'
  missing "$tmp/clauses" "$tmp/stated" 'is stated under another name than its label'
  missing "$tmp/stated" "$tmp/evaluated" 'is a clause of model that nothing evaluates'
  missing "$tmp/spec.def" "$tmp/defs" 'is named by no function of model'
  missing "$tmp/defs" "$tmp/spec" 'is named in model, but not in spec'
  missing "$tmp/spec" "$tmp/tests" 'is named by no test'
  if [ -f proofs/Main.v ]; then
    # Especificacion.v is the text itself, in Coq: to be named there is not to be used by a theorem.
    find proofs -name "*.v" ! -name Especificacion.v -exec grep -ohE "\b$label" {} + | sort -u >"$tmp/proofs"
    grep -vE '^(#|$)' tests/lint/labels-without-theorem.txt | cut -d' ' -f1 | sort >"$tmp/unproved"
    comm -23 "$tmp/spec" "$tmp/proofs" | comm -23 - "$tmp/unproved" | sed 's/$/: is named by no theorem/'
    comm -12 "$tmp/unproved" "$tmp/proofs" | sed 's/$/: has a theorem, so its line in labels-without-theorem.txt must go/'
    missing "$tmp/proofs" "$tmp/spec" 'is named in proofs, but not in spec'
    grep -ohE '% [A-Za-z_]+\.axiom\.[0-9]+$' spec/*.tex | cut -c3- | sort >"$tmp/axioms"
    uniq -d "$tmp/axioms" | sed 's/$/: stands twice in spec/'
    find proofs -name "*.v" ! -name Especificacion.v -exec grep -ohE '\b[A-Za-z_]+\.axiom\.[0-9]+' {} + | sort -u >"$tmp/axioms.proved"
    missing "$tmp/axioms" "$tmp/axioms.proved" 'is an axiom that no theorem shows of the numbers of the proofs'
    missing "$tmp/axioms.proved" "$tmp/axioms" 'is named in proofs, but is no axiom of spec'
    grep -ohE '% [A-Za-z_]+\.conj\.[0-9]+$' spec/*.tex | cut -c3- | sort >"$tmp/conjectures"
    uniq -d "$tmp/conjectures" | sed 's/$/: stands twice in spec/'
    sh cmake/label_index.sh | awk -F '\t' '$1 ~ /\.conj\./ && $2 == "theorem"' >"$tmp/conjectures.index"
    cut -f1 "$tmp/conjectures.index" | sort -u >"$tmp/conjectures.proved"
    missing "$tmp/conjectures" "$tmp/conjectures.proved" 'is a conjecture that no theorem discharges'
    missing "$tmp/conjectures.proved" "$tmp/conjectures" 'is discharged in proofs, but is no conjecture of spec'
    while IFS='	' read -r named _ place theorem; do
      statement=$(echo "$named" | tr . _)
      sed -n "${place##*:}p" "${place%:*}" | grep -qw "$statement" ||
        echo "$place: $theorem is to prove $named, and does not state $statement"
    done <"$tmp/conjectures.index"
    sed 's/(\*.*\*)//' proofs/Main*.v >"$tmp/main"
    cat "$tmp/axioms" "$tmp/conjectures" | while read -r named; do
      statement=$(echo "$named" | tr . _)
      grep -q "^Definition $statement : Prop :=" proofs/Especificacion.v proofs/Tablas.v proofs/TotalRows.v proofs/Promocion.v proofs/Malla.v \
        proofs/Cambios.v proofs/Vista.v proofs/Historia.v ||
        echo "$named: none of Especificacion.v, Tablas.v, TotalRows.v, Promocion.v, Malla.v, Cambios.v, Vista.v and Historia.v states it"
      grep -qw "$statement" "$tmp/main" || echo "$named: no theorem of Main.v states $statement"
    done
    by_hand='proofs/Cambios.v proofs/Vista.v proofs/Historia.v'
    grep -ohE "% $label$" spec/historia.tex | cut -c3- | while read -r named; do
      field=$(echo "$named" | tr . _)
      # shellcheck disable=SC2086  # a word a file
      grep -qE "^  $field :|^Definition ($field|${named%%.*})\b" $by_hand || echo "$named: no field or definition of $by_hand has its name"
    done
  fi
  # every predicate of a box, and every definition by ==, ends in a label, and has no other
  awk 'function end_of(what) {
         if (last && !labelled) print FILENAME ":" last ": a " what " without a label"
         last = labelled = 0
       }
       /^\\begin\{(schema|axdef|zed)\}/ { zed = /zed/; stated = last = labelled = 0; next }
       /^\\where/ { stated = 1; next }
       /^\\also/ { end_of("predicate"); next }
       /^\\end\{/ { end_of(zed ? "definition" : "predicate"); zed = stated = 0; next }
       zed && (/ == / || /\\vdash\?/) { stated = 1 }
       stated && NF {
         if (labelled) print FILENAME ":" FNR ": a label in the middle of a predicate, or a predicate without a label"
         last = FNR
         labelled = /% [A-Za-z_]+\.(pre|post|inv|def|axiom|conj)\.[0-9]+$/ }' spec/*.tex
} >"$tmp/found"
cat "$tmp/found"
[ ! -s "$tmp/found" ]
