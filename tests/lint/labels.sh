#!/bin/sh
# Labels are the index of everything. Each predicate of spec/ has a label; the clause that evaluates it (or, for a
# definition, the function that carries it out), the test that names it and the theorem that uses it are found by it.
# A label on one side that the others lack fails, both ways.
kinds='pre|post|inv|def'
label="[A-Za-z_]+\.($kinds)\.[0-9]+"
tmp=$(mktemp -d) && trap 'rm -rf "$tmp"' EXIT
grep -ohE "% $label" spec/*.tex | cut -c3- | sort >"$tmp/all"
sort -u "$tmp/all" >"$tmp/spec"
grep -ohE "\"$label\"" include/durero/model/*.hpp src/model/*.cpp | tr -d '"' | sort >"$tmp/clauses.all"
sort -u "$tmp/clauses.all" >"$tmp/clauses"
# A clause has two lines in model: where it is stated, and where it is handed over with what holds.
constants() { sed -E 's/^(.*)_(pre|post|inv)_([0-9]+)$/\1.\2.\3/' | sort -u; }
grep -ohE "\bclause [A-Za-z_]+_(pre|post|inv)_[0-9]+" -r include/durero/model | cut -d' ' -f2 | constants >"$tmp/stated"
cat include/durero/model/*.hpp src/model/*.cpp | grep -v '^inline constexpr ' |
  grep -ohE "\b[A-Za-z_]+_(pre|post|inv)_[0-9]+\b" | constants >"$tmp/evaluated"
# The tables have clauses of their own for what an operation requires and does.
grep -ohE "\bmodel::[A-Za-z_]+_(pre|post)_[0-9]+\b" src/scene/clauses.hpp | cut -d: -f3 | constants >"$tmp/tables"
grep -E '^(Agregar|Eliminar)_' "$tmp/spec" >"$tmp/operations"
grep -ohE "\b[A-Za-z_]+\.def\.[0-9]+" include/durero/model/*.hpp | sort -u >"$tmp/defs"
grep -ohE "\b$label" -r tests --include=*.cpp | sort -u >"$tmp/tests"
grep -vE '^(#|$)' tests/lint/labels-without-clause.txt | cut -d' ' -f1 | sort >"$tmp/excluded"

missing() { comm -23 "$1" "$2" | sed "s|\$|: $3|"; }
{
  uniq -d "$tmp/all" | sed 's/$/: stands twice in spec/'
  uniq -d "$tmp/clauses.all" | sed 's/$/: has two clauses/'
  grep '\.def\.' "$tmp/spec" >"$tmp/spec.def"
  grep -v '\.def\.' "$tmp/spec" >"$tmp/spec.clause"
  comm -23 "$tmp/spec.clause" "$tmp/clauses" | comm -23 - "$tmp/excluded" | sed 's/$/: has no clause in model/'
  comm -12 "$tmp/excluded" "$tmp/clauses" | sed 's/$/: has a clause, so its line in labels-without-clause.txt must go/'
  missing "$tmp/excluded" "$tmp/spec.clause" 'stands in labels-without-clause.txt but not in spec'
  missing "$tmp/clauses" "$tmp/spec" 'is a clause of model, but no predicate of spec'
  missing "$tmp/stated" "$tmp/clauses" 'is stated under another label than its name'
  missing "$tmp/clauses" "$tmp/stated" 'is stated under another name than its label'
  missing "$tmp/stated" "$tmp/evaluated" 'is a clause of model that nothing evaluates'
  missing "$tmp/operations" "$tmp/tables" 'is no clause of the tables (src/scene/clauses.hpp)'
  missing "$tmp/tables" "$tmp/operations" 'is a clause of the tables, but no predicate of an operation in spec'
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
  fi
  # every line of a paragraph that states a predicate carries a label
  awk '/^\\begin\{schema\}|^\\begin\{axdef\}/{in_box=1; where=0; next} /^\\end\{/{in_box=0} /^\\where/{where=1; next}
       in_box && where && !/^\\also/ && NF && !/% [A-Za-z_]+\.(pre|post|inv|def|axiom)\.[0-9]+$/ {print FILENAME ":" FNR ": a predicate without a label"}' spec/*.tex
} | { ! grep .; }
