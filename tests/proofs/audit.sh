#!/bin/sh
# The audit of the proofs: what could make a theorem of proofs/Main.v mean less than it says.
#   audit.sh CHECK PROOFS [BUILD_DIRECTORY]
#     text         no proof is left open, and nothing is assumed outside a module type
#     reachable    Main.v depends on every file, so that none is proved beside the point
#     assumptions  each theorem of Main.v rests on the axioms that assumptions.txt says, and those are of classical reals
#     kernel       coqchk, which shares no code with the tactics, accepts Main.v and all below it
#     all          each of these
# Except for `text` the build directory holds the proofs, built.
set -eu
export LC_ALL=C
check=$1 proofs=$2 build=${3-}
tmp=$(mktemp -d) && trap 'rm -rf "$tmp"' EXIT

# The axioms of Coq's classical real numbers, and no others.
allowed='ClassicalDedekindReals.sig_forall_dec
ClassicalDedekindReals.sig_not_dec
FunctionalExtensionality.functional_extensionality_dep
Classical_Prop.classic
functional_extensionality_dep
classic'

# The files without comments and strings, each line as FILE:LINE:TEXT.
without_comments() {
  awk 'FNR == 1 { depth = 0; string = 0 }
    { text = $0; out = ""
      while (text != "") {
        two = substr(text, 1, 2); one = substr(text, 1, 1); step = 1
        if (string) { if (one == "\"") string = 0 }
        else if (two == "(*") { depth++; step = 2 }
        else if (depth && two == "*)") { depth--; step = 2 }
        else if (one == "\"") string = 1
        else if (!depth) out = out one
        text = substr(text, step + 1)
      }
      print FILENAME ":" FNR ":" out }' "$@"
}

audit_text() {
  words='Admitted|admit|give_up|Abort|Admit|Axioms?|Conjectures?|Parameters?|bypass_check|Unset +(Guard|Positivity|Universe) +Checking'
  without_comments $(find "$proofs" -name '*.v' | sort) | awk -v words="(^|[^A-Za-z0-9_'.])($words)([^A-Za-z0-9_']|\$)" '
    { file = $0; sub(/:.*/, "", file); if (file != last) { module_type = 0; last = file } }
    /:[ \t]*Module +Type[ \t]/ { module_type = 1 }
    { line = $0; sub(/^[^:]*:[0-9]*:/, "", line) }
    line ~ words && !(module_type && line ~ /Parameter/) { print $0 "  <- left open, or assumed"; bad = 1 }
    /:[ \t]*End[ \t]/ { module_type = 0 }
    END { exit bad }'
}

audit_reachable() {
  (cd "$build" && coqdep -Q . Durero ./*.v 2>/dev/null) | tr -d '\r' | awk '
    { split($0, sides, ": "); n = split(sides[1], target, " "); from = ""
      for (i = 1; i <= n; i++) if (target[i] ~ /\.vo$/) { from = target[i]; all[from] = 1 }
      if (from == "") next
      m = split(sides[2], need, " ")
      for (i = 1; i <= m; i++) if (need[i] ~ /\.vo$/) edges[from] = edges[from] " " need[i] }
    END { todo = "./Main.vo"; if (!(todo in all)) todo = "Main.vo"
      while (todo != "") {
        n = split(todo, queue, " "); todo = ""
        for (i = 1; i <= n; i++) if (!(queue[i] in seen)) { seen[queue[i]] = 1; todo = todo " " edges[queue[i]] }
      }
      for (file in all) if (!(file in seen)) { sub(/^\.\//, "", file); sub(/\.vo$/, ".v", file)
        print "proofs/" file ": Main.v does not depend on it"; bad = 1 }
      exit bad }'
}

# One line a theorem of Main.v: its name and the axioms that it rests on, sorted.
assumptions() {
  theorems=$(without_comments "$proofs/Main.v" | sed -n 's/^[^:]*:[0-9]*:Theorem \([A-Za-z0-9_]*\).*/\1/p')
  { echo 'From Durero Require Main.'
    for theorem in $theorems; do echo "Redirect \"$tmp/$theorem\" Print Assumptions Main.$theorem."; done
  } >"$tmp/audit.v"
  (cd "$build" && coqc -q -Q . Durero "$tmp/audit.v") >&2
  for theorem in $theorems; do  # an axiom begins its line; its type is indented, or follows a colon
    found=$(sed -n 's/^Closed under the global context$/none/; /^Axioms:$/d; s/ *:.*//; /^[^ ]/p' \
      "$tmp/$theorem.out" | sort -u | tr '\n' ' ')
    [ -n "$found" ] || { echo "Main.v: no assumptions found of $theorem" >&2; return 1; }
    echo "$theorem: ${found% }"
  done
}

audit_assumptions() {
  assumptions >"$tmp/now"
  [ -s "$tmp/now" ] || { echo "Main.v states no theorem"; return 1; }
  cut -d: -f2- "$tmp/now" | tr ' ' '\n' | grep -v '^$' | sort -u | grep -vxF 'none' >"$tmp/axioms" || true
  if printf '%s\n' "$allowed" | grep -vxFf - "$tmp/axioms"; then echo 'these are not axioms of the classical reals'; return 1; fi
  diff -u "$proofs/assumptions.txt" "$tmp/now" || { echo 'assumptions.txt does not say what Main.v rests on'; return 1; }
}

audit_kernel() {
  coqchk -silent -o -Q "$build" Durero Durero.Main >"$tmp/chk" 2>&1 || { cat "$tmp/chk"; return 1; }
  sed -n '/^\* Axioms:/,/^\* Constants/p' "$tmp/chk" | sed -n 's/^    *//p' | sed 's/.*\.\([^.]*\.[^.]*\)$/\1/' >"$tmp/axioms"
  if printf '%s\n' "$allowed" | grep -vxFf - "$tmp/axioms"; then echo 'coqchk finds these other axioms'; return 1; fi
  [ "$(grep -c ': <none>$' "$tmp/chk")" = 3 ] || { cat "$tmp/chk"; return 1; }
}

case $check in
  text | reachable | assumptions | kernel) "audit_$check" ;;
  print) assumptions ;;  # what assumptions.txt should hold
  all) audit_text && audit_reachable && audit_assumptions && audit_kernel ;;
  *) echo "audit.sh does not know $check"; exit 2 ;;
esac
