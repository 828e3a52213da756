#!/bin/sh
# An audit that cannot fail is no audit: this plants, in a copy of the proofs, the faults that it should see, and fails
# where it says nothing, or says it of another check.
#   audit_drill.sh PROOFS BUILD_DIRECTORY      the build directory holds the proofs, built
set -u
here=$(CDPATH='' cd -- "$(dirname -- "$0")" && pwd)
original=$1 built=$2
tmp=$(mktemp -d) && trap 'rm -rf "$tmp"' EXIT
proofs=$tmp/proofs build=$tmp/build
drills=0 missed=0

fresh() {  # times are kept, so that only what depends on the fault is compiled again
  rm -rf "$proofs" "$build"
  cp -a "$original" "$proofs" && cp -a "$built" "$build"
}

# sees CHECK WHAT WORDS: the check fails, and says WORDS.
sees() {
  drills=$((drills + 1))
  if [ "$1" != text ] && ! "$proofs/build.sh" "$build" >"$tmp/log" 2>&1; then
    echo "drill: the copy does not build with its fault: $2"; tail -n 5 "$tmp/log"; missed=$((missed + 1))
  elif sh "$here/audit.sh" "$1" "$proofs" "$build" >"$tmp/log" 2>&1; then
    echo "drill: audit.sh $1 does not see: $2"; missed=$((missed + 1))
  elif ! grep -q -e "$3" "$tmp/log"; then
    echo "drill: audit.sh $1 fails, but not for: $2"; cat "$tmp/log"; missed=$((missed + 1))
  fi
  fresh
}

fresh
sh "$here/audit.sh" text "$proofs" || { echo "drill: the audit fails before any fault is planted"; missed=1; }

printf 'Lemma open_end : 0 = 1.\nProof. Admitted.\n' >>"$proofs/Escena.v"
sees text "an Admitted" 'Admitted.*left open'
sed -i '0,/^Proof\. /s/^Proof\. .*/Proof. admit. (* Qed. *)/' "$proofs/Operaciones.v"
sees text "an admit" 'admit.*left open'
printf 'Axiom choice : False.\n' >>"$proofs/Puntos.v"
sees text "an Axiom" 'Axiom.*assumed'
printf '(* Module Type T. *)\nParameter choice : False.\n' >>"$proofs/Puntos.v"
sees text "a Parameter outside a module type" 'Parameter.*assumed'
printf '(* An Axiom in a comment, and Admitted. *)\nModule Type Given.\n  Parameter t : Type.\nEnd Given.\n' >>"$proofs/Puntos.v"
if ! sh "$here/audit.sh" text "$proofs" >/dev/null; then
  echo "drill: the audit refuses a comment, or a Parameter of a module type"; missed=$((missed + 1))
fi
fresh

printf 'Variable choice : False.\nTheorem planted : 0 = 1.\nProof. destruct choice. Qed.\n' >>"$proofs/Main.v"
sees assumptions "a Variable outside a section" 'choice'
printf 'Theorem planted : True.\nProof. exact I. Qed.\n' >>"$proofs/Main.v"
sees assumptions "a theorem that assumptions.txt does not know" 'planted'
printf 'Lemma alone : True.\nProof. exact I. Qed.\n' >"$proofs/Alone.v"
sees reachable "a file that Main.v does not depend on" 'Alone.v'

echo "drill: $((drills - missed)) of $drills faults seen"
[ "$missed" = 0 ]
