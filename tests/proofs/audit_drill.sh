#!/bin/sh
# An audit that cannot fail is no audit: this plants the faults that it should see, and fails where it says nothing, or
# says it of another check.
#   audit_drill.sh PROOFS BUILD_DIRECTORY      the build directory holds the proofs, built
# What the text shows and what Main.v states is planted in a copy of the proofs; what needs every file compiled again,
# or all of them checked by coqchk, in small proofs of the same form.
set -u
here=$(CDPATH='' cd -- "$(dirname -- "$0")" && pwd)
original=$1 built=$2
tmp=$(mktemp -d) && trap 'rm -rf "$tmp"' EXIT
proofs=$tmp/proofs build=$tmp/build
drills=0 missed=0

miss() { echo "drill: $1"; missed=$((missed + 1)); }

# saw CHECK WHAT WORDS: the check fails, and says WORDS.
saw() {
  drills=$((drills + 1))
  if sh "$here/audit.sh" "$1" "$proofs" "$build" >"$tmp/log" 2>&1; then miss "audit.sh $1 does not see: $2"
  elif ! grep -q -e "$3" "$tmp/log"; then miss "audit.sh $1 fails, but not for: $2"; tail -n 20 "$tmp/log"
  fi
}

builds() {
  "$proofs/build.sh" "$build" >"$tmp/log" 2>&1 || { miss "the proofs do not build with the fault: $1"; tail -n 5 "$tmp/log"; }
}

# unbuilt WHAT FILE: the proofs do not build with the fault, and stop at that file.
unbuilt() {
  drills=$((drills + 1))
  if "$proofs/build.sh" "$build" >"$tmp/log" 2>&1; then miss "the proofs build with: $1"
  elif ! grep -q "^File \"./$2\"" "$tmp/log"; then miss "the proofs do not build, but not at $2, with: $1"; tail -n 5 "$tmp/log"
  fi
}

# The copy; times are kept, so that only what depends on a fault is compiled again.
copy() {
  rm -rf "$proofs" "$build"
  cp -a "$original" "$proofs" && cp -a "$built" "$build"
}

# text FILE WHAT WORDS: what stands on standard input, at the end of a file of the copy, is seen by reading it.
text() {
  cat >>"$proofs/$1"
  saw text "$2" "$3"
  cp "$original/$1" "$proofs/$1" 2>/dev/null || rm "$proofs/$1"
}

copy
sh "$here/audit.sh" text "$proofs" || miss "the audit fails before any fault is planted"

text Escena.v "an Admitted" 'Admitted.*left open' <<'V'
Lemma open_end : 0 = 1.
Proof. Admitted.
V
text Escena.v "an admit" 'admit.*left open' <<'V'
Lemma open_end : 0 = 1.
Proof. intros; admit. (* Qed. *)
V
text Puntos.v "an Axiom" 'Axiom choice.*does not know' <<'V'
Axiom choice : False.
V
text Puntos.v "a Parameter outside a module type" 'Parameter choice.*outside a module type' <<'V'
(* Module Type T. *)
Parameter choice : False.
V
text Puntos.v "a Parameter after a module type" 'Parameter choice.*outside a module type' <<'V'
Module Type Given. Parameter t : Type. End Given. Module M. Parameter choice : False. End M.
V
text Puntos.v "a Declare Module" 'Declare Module Gift.*does not know' <<'V'
Module Type Given. Parameter choice : False. End Given.
Declare Module Gift : Given.
V
text Puntos.v "a module type included in a module" 'Include Given.*does not know' <<'V'
Module Type Given. Parameter choice : False. End Given.
Module Gift. Include Given. End Gift.
V
text Puntos.v "a Load" 'Load.*does not know' <<'V'
Load "/tmp/elsewhere".
V
for sentence in 'Variable choice : False.' 'Hypothesis choice : False.' 'Context (choice : False).' \
  'Global Hypotheses (choice : False).' 'Section A. End A. Variables (choice : False).'; do
  text Puntos.v "outside a section: $sentence" 'choice.*outside a section' <<V
$sentence
V
done
text Classical_Prop.v "a file with the name of one of Coq's, and a Variable" 'classic.*outside a section' <<'V'
Variable classic : forall P : Prop, P.
V
for sentence in 'Unset Guard Checking.' 'Local Unset Guard Checking.' '#[local] Unset Universe Checking.' \
  '#[bypass_check(guard)] Fixpoint f (n : nat) : False := f n.' 'Time Unset Positivity Checking.'; do
  text Puntos.v "a check of Coq's switched off: $sentence" 'Checking\|bypass_check.*does not know' <<V
$sentence
V
done
text Puntos.v "a check of Coq's switched off, in two lines" 'Unset Guard Checking.*does not know' <<'V'
Unset
  Guard Checking.
V
for sentence in 'Module Classical_Prop. Variable classic : forall P : Prop, P. End Classical_Prop.' \
  'Lemma planted : 0 = 1. Proof. apply Classical_Prop.classic. Qed.' \
  'Definition is_first (reach : R -> Prop) (x : R) := x = x.' '  #[local] Theorem planted : True. Proof. exact I. Qed.' \
  'Theorem planted : True. Proof. Definition sneaked := I. exact I. Qed.' 'Local Definition sneaked := I.'; do
  text Main.v "in Main.v: $sentence" 'no sentence for Main.v' <<V
$sentence
V
done
cat >>"$proofs/Puntos.v" <<'V'
(* An Axiom in a comment, and Admitted. *)
Module Type Given.
  Parameter t : Type.
End Given.
Section Admitted_here. Context (t : Type). Local Definition admitted (x : t) := "Admitted. Axiom "%string. End Admitted_here.
V
sh "$here/audit.sh" text "$proofs" || miss "the audit refuses a comment, a string, or what a module type or a section assumes"
cp "$original/Puntos.v" "$proofs"
for option in '-arg -type-in-type' '-arg -impredicative-set'; do
  echo "$option" >>"$proofs/_CoqProject"
  saw text "in _CoqProject: $option" "$option"
  cp "$original/_CoqProject" "$proofs"
done

# Main.v with another meaning under the same names: a premise that is false, a hypothesis that no scene satisfies, and a
# definition.
sed -i 's/^\(Theorem a_certified_miss_is_a_miss t :\) Formas/\1 False -> Formas/
  /^Theorem a_certified_miss_is_a_miss/,/^Proof/ s/^Proof\. /Proof. intros _. /
  s/^Hypothesis ray_ok : .*/& Hypothesis ray_still : Rayo_v ray = mk_Vector 0 0 0./
  /^Theorem the_segment_is_of_a_generator/,/^Proof/ s/^Proof\./& pose proof ray_still./
  s/^Theorem first_hit_of_an_element/Let proper f : Prop := or (Trazador.proper f) False.\n&/
  s/^Proof\. exact (first_correct f)\. Qed\./Proof. intros [H | []]. now apply first_correct. Qed./' "$proofs"/Main*.v
printf 'Lemma alone : True.\nProof. exact I. Qed.\n' >"$proofs/Alone.v"
rm "$proofs"/Instance*.v  # of which some would not compile
builds "three statements with another meaning, and a file beside the point"
saw statements "a premise that is false" '^+Theorem a_certified_miss_is_a_miss t : False ->'
saw statements "a hypothesis that nothing satisfies" '^+.* rests on .*ray_still'
saw statements "another notion under a name of a statement" '^+Let proper f : Prop := or'
saw reachable "a file that Main.v does not depend on" 'Alone.v'

# What nothing satisfies, planted where the theorems of the whole rest on it: a field of a record, a range that no element has,
# and a pair of premises of which each alone can hold. Recorded.v or the instances do not compile.
copy
sed -i 's/^Record steps_run : Prop := {/&\n  never : False;/' "$proofs/Running.v"
unbuilt "a field of steps_run that nothing satisfies" Recorded.v
# premise TEXT NAMES: a premise of the theorem of the whole, which its proof leaves aside by these names.
premise() {
  copy
  sed -i "/^Theorem the_search_that_runs_publishes_the_texts_hit/,/^Proof/ {
    s/ apart cs taken st :\$/&\n  $1 ->/; s/^Proof\./& intros $2./; }" "$proofs/Main.v"
  unbuilt "premises that nothing satisfies: $1" InstanceSearch.v
}
premise '(forall e, In e elements -> in_range e = true -> 2 < 1)' _
premise 'S = 1%Z -> S = 2%Z' '_ _'

# small: proofs of three files that pass the audit. The theorem names two definitions, and the second of them a third.
small() {
  rm -rf "$proofs" "$build"
  mkdir -p "$proofs"
  cp "$original/build.sh" "$original/_CoqProject" "$proofs"
  cat >"$proofs/Base.v" <<'V'
Definition agree (m n : nat) := m = n.
Definition sum (m n : nat) := m + n.
Definition double (n : nat) := sum n n.
V
  cat >"$proofs/Main.v" <<'V'
From Durero Require Import Base.
Section Numbers.
Variable n : nat.
Hypothesis zero : n = 0.
Theorem doubled : agree (double n) 0.
Proof. unfold agree; now rewrite zero. Qed.
End Numbers.
V
  cat >"$proofs/Instances.v" <<'V'
From Durero Require Main.
Definition instance_of_doubled := Main.doubled 0 eq_refl.
V
  builds "none"
  sh "$here/audit.sh" update "$proofs" "$build" || miss "the small proofs are not read"
}

# rebuilt CHECK WHAT WORDS: the small proofs are built with their fault, and the check sees it.
rebuilt() {
  builds "$2"
  saw "$1" "$2" "$3"
}

small
sh "$here/audit.sh" all "$proofs" "$build" || miss "the audit fails on the small proofs before any fault is planted"
printf 'Theorem planted : True.\nProof. exact I. Qed.\n' >>"$proofs/Main.v"
rebuilt assumptions "a theorem that assumptions.txt does not know" '^+planted: none'
small
printf 'Variable choice : False.\nTheorem planted : 0 = 1.\nProof. destruct choice. Qed.\n' >>"$proofs/Main.v"
rebuilt assumptions "a Variable outside a section" 'choice'
small
cat >>"$proofs/Main.v" <<'V'
Module Classical_Prop. Variable classic : forall P : Prop, P. End Classical_Prop.
Lemma planted : 0 = 1. Proof. apply Classical_Prop.classic. Qed.
V
rebuilt kernel "an axiom with the last names of one of Coq's" 'Durero.Main.Classical_Prop.classic'
small
echo 'Variable classic : forall P : Prop, P.' >"$proofs/Classical_Prop.v"
echo 'From Durero Require Main.' >"$proofs/Instances.v"  # the theorem has no premise left
sed -i 's/^From Durero Require/& Classical_Prop. &/; s/now rewrite zero/apply Classical_Prop.classic/' "$proofs/Main.v"
rebuilt kernel "an axiom in a file with the name of one of Coq's" 'Durero.Classical_Prop.classic'
small
printf 'Module Type Given. Parameter choice : False. End Given.\nDeclare Module Gift : Given.\n' >>"$proofs/Base.v"
rebuilt kernel "a module declared, and used by no theorem" 'Durero.Base.Gift.choice'
small
printf 'Unset\n Guard Checking.\nFixpoint loop (n : nat) : False := loop n.\n' >>"$proofs/Base.v"
rebuilt kernel "a function that does not end" 'loop'
small
echo 'From Durero Require Main.' >"$proofs/Instances.v"
rebuilt instances "a theorem without an instance" '^doubled: a theorem with premises and no instance'
small
cp "$proofs/Instances.v" "$proofs/InstancesMore.v"
rebuilt instances "two instances of one theorem" '^doubled: twice'
small
sed -i 's/:= Main.doubled 0 eq_refl/(n : nat) (zero : n = 0) := Main.doubled n zero/' "$proofs/Instances.v"
rebuilt instances "an instance with a premise" 'instance_of_doubled: an instance with a premise'
small
echo 'From Durero Require Main.' >"$proofs/Instances.v"
printf 'From Durero Require Main.\nDefinition instance_of_doubled n (zero : n = 0) := Main.doubled n zero.\n' >"$proofs/InstancesMore.v"
rebuilt instances "an instance with a premise in another file" 'InstancesMore.instance_of_doubled: an instance with a premise'
printf 'From Durero Require Main.\nVariable choice : False.\n' >"$proofs/InstancesMore.v"
rebuilt kernel "what another file of instances assumes" 'Durero.InstancesMore.choice'
small
sed -i 's/^Definition instance_of_doubled.*/Variable zero : 0 = 0.\nDefinition instance_of_doubled := Main.doubled 0 zero./' "$proofs/Instances.v"
rebuilt instances "an instance that rests on what its file assumes" '^Instances.instance_of_doubled: Instances.zero: an instance rests'
small
sed -i 's/^Definition instance_of_doubled.*/Theorem instance_of_doubled : 0 = 0.\nProof. reflexivity. Qed./' "$proofs/Instances.v"
rebuilt instances "an instance that does not rest on its theorem" 'instance_of_doubled: does not rest on Main.doubled'
small
sed -i 's/^Theorem doubled : /&n = 1 -> /; s/^Proof\. unfold/Proof. intros _; unfold/' "$proofs/Main.v"
rebuilt instances "a premise that contradicts another" 'instance_of_doubled: an instance with a premise'
small
sed -i 's/:= sum n n/& + 0/' "$proofs/Base.v"
rebuilt statements "another definition" '^+Definition double (n : nat) := sum n n + 0\.'
small
sed -i 's/:= m + n/& + 0/' "$proofs/Base.v"
rebuilt statements "another definition below the definitions that a theorem names" \
  '^+Definition sum (m n : nat) := m + n + 0\.'
small
sed -i '1i Local Notation "m + n" := (Nat.mul m n) : nat_scope.' "$proofs/Base.v"
rebuilt statements "another meaning of the same text" '^+Definition sum (m n : nat) := m + n\.  (\* [0-9a-f]* \*)$'
small
echo '-arg -type-in-type' >>"$proofs/_CoqProject"
rebuilt kernel "every file compiled with -type-in-type, by a change of _CoqProject alone" 'type-in-type: *[^<]*$'

echo "drill: $((drills - missed)) of $drills faults seen"
[ "$missed" = 0 ]
