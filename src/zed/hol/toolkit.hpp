#pragma once
/// The part of the standard toolkit that exported texts use, under the same names in both languages.

namespace durero::zed::hol {

inline constexpr const char* coq_toolkit = R"z(
(** Z in Coq, written by `durero spec refine --coq`. A set is a predicate, a function its set of pairs, and numbers are
    integers. z_app f x y == f has a value at x, and it is y. Equality of sets is Coq's =, so that proofs take functional
    and propositional extensionality. Nothing is proved here. *)
From Coq Require Import ZArith List.
Open Scope Z_scope.

Definition set (X : Type) := X -> Prop.
Definition z_in {X} (x : X) (A : set X) : Prop := A x.
Definition z_collect {X} (P : X -> Prop) : set X := P.
Definition z_all (X : Type) : set X := fun _ => True.
Definition z_empty {X} : set X := fun _ => False.
Definition z_insert {X} (x : X) (A : set X) : set X := fun y => y = x \/ A y.
Definition z_union {X} (A B : set X) : set X := fun x => A x \/ B x.
Definition z_inter {X} (A B : set X) : set X := fun x => A x /\ B x.
Definition z_diff {X} (A B : set X) : set X := fun x => A x /\ ~ B x.
Definition z_subset {X} (A B : set X) : Prop := forall x, A x -> B x.
Definition z_psubset {X} (A B : set X) : Prop := z_subset A B /\ A <> B.
Definition z_finite {X} (A : set X) : Prop := exists l, forall x, A x -> In x l.
Definition z_power {X} (A : set X) : set (set X) := fun B => z_subset B A.
Definition z_power1 {X} (A : set X) : set (set X) := fun B => z_subset B A /\ exists x, B x.
Definition z_finset {X} (A : set X) : set (set X) := fun B => z_subset B A /\ z_finite B.
Definition z_finset1 {X} (A : set X) : set (set X) := fun B => z_subset B A /\ z_finite B /\ exists x, B x.
Definition z_cross {X Y} (A : set X) (B : set Y) : set (X * Y) := fun p => A (fst p) /\ B (snd p).
Definition z_dom {X Y} (f : set (X * Y)) : set X := fun x => exists y, f (x, y).
Definition z_ran {X Y} (f : set (X * Y)) : set Y := fun y => exists x, f (x, y).
Definition z_inverse {X Y} (f : set (X * Y)) : set (Y * X) := fun p => f (snd p, fst p).
Definition z_image {X Y} (f : set (X * Y)) (A : set X) : set Y := fun y => exists x, A x /\ f (x, y).
Definition z_dres {X Y} (A : set X) (f : set (X * Y)) : set (X * Y) := fun p => A (fst p) /\ f p.
Definition z_ndres {X Y} (A : set X) (f : set (X * Y)) : set (X * Y) := fun p => ~ A (fst p) /\ f p.
Definition z_rres {X Y} (f : set (X * Y)) (A : set Y) : set (X * Y) := fun p => A (snd p) /\ f p.
Definition z_nrres {X Y} (f : set (X * Y)) (A : set Y) : set (X * Y) := fun p => ~ A (snd p) /\ f p.
Definition z_override {X Y} (f g : set (X * Y)) : set (X * Y) := z_union (z_ndres (z_dom g) f) g.
Definition z_compose {X Y V} (f : set (X * Y)) (g : set (Y * V)) : set (X * V) :=
  fun p => exists y, f (fst p, y) /\ g (y, snd p).
Definition z_after {X Y V} (g : set (Y * V)) (f : set (X * Y)) : set (X * V) := z_compose f g.
Definition z_id {X} (A : set X) : set (X * X) := fun p => A (fst p) /\ fst p = snd p.
Definition z_functional {X Y} (f : set (X * Y)) : Prop := forall x y w, f (x, y) -> f (x, w) -> y = w.
Definition z_rel {X Y} (A : set X) (B : set Y) : set (set (X * Y)) := z_power (z_cross A B).
Definition z_pfun {X Y} (A : set X) (B : set Y) : set (set (X * Y)) := fun f => z_rel A B f /\ z_functional f.
Definition z_tfun {X Y} (A : set X) (B : set Y) : set (set (X * Y)) := fun f => z_pfun A B f /\ z_dom f = A.
Definition z_pinj {X Y} (A : set X) (B : set Y) : set (set (X * Y)) :=
  fun f => z_pfun A B f /\ z_functional (z_inverse f).
Definition z_tinj {X Y} (A : set X) (B : set Y) : set (set (X * Y)) := fun f => z_pinj A B f /\ z_dom f = A.
Definition z_psurj {X Y} (A : set X) (B : set Y) : set (set (X * Y)) := fun f => z_pfun A B f /\ z_ran f = B.
Definition z_tsurj {X Y} (A : set X) (B : set Y) : set (set (X * Y)) := fun f => z_tfun A B f /\ z_ran f = B.
Definition z_bij {X Y} (A : set X) (B : set Y) : set (set (X * Y)) := fun f => z_tinj A B f /\ z_ran f = B.
Definition z_ffun {X Y} (A : set X) (B : set Y) : set (set (X * Y)) := fun f => z_pfun A B f /\ z_finite f.
Definition z_finj {X Y} (A : set X) (B : set Y) : set (set (X * Y)) := fun f => z_pinj A B f /\ z_finite f.
Definition z_app {X Y} (f : set (X * Y)) (x : X) (y : Y) : Prop := f (x, y) /\ forall w, f (x, w) -> w = y.
Definition z_int : set Z := fun _ => True.
Definition z_nat : set Z := fun n => 0 <= n.
Definition z_nat1 : set Z := fun n => 0 < n.
Definition z_upto (a b : Z) : set Z := fun n => a <= n <= b.
Definition z_plus (a b : Z) : Z := a + b.
Definition z_minus (a b : Z) : Z := a - b.
Definition z_times (a b : Z) : Z := a * b.
Definition z_less (a b : Z) : Prop := a < b.
Definition z_at_most (a b : Z) : Prop := a <= b.
Definition z_card {X} : set (set X * Z) :=
  fun p => exists l, NoDup l /\ (forall x, In x l <-> fst p x) /\ snd p = Z.of_nat (length l).
Definition z_min : set (set Z * Z) := fun p => fst p (snd p) /\ forall n, fst p n -> snd p <= n.
Definition z_max : set (set Z * Z) := fun p => fst p (snd p) /\ forall n, fst p n -> n <= snd p.
Definition z_seq {X} (A : set X) : set (set (Z * X)) := fun f => exists n, 0 <= n /\ z_tfun (z_upto 1 n) A f.
)z";

inline constexpr const char* isabelle_toolkit =
    R"z((* Z in Isabelle/HOL, written by `durero spec refine --isabelle`. A function is its set of pairs, and numbers are
   integers. z_app f x y == f has a value at x, and it is y. Nothing is proved here. *)
definition z_in :: "'a \<Rightarrow> 'a set \<Rightarrow> bool" where "z_in x A = (x \<in> A)"
definition z_collect :: "('a \<Rightarrow> bool) \<Rightarrow> 'a set" where "z_collect P = Collect P"
definition z_empty :: "'a set" where "z_empty = {}"
definition z_insert :: "'a \<Rightarrow> 'a set \<Rightarrow> 'a set" where "z_insert x A = insert x A"
definition z_union :: "'a set \<Rightarrow> 'a set \<Rightarrow> 'a set" where "z_union A B = A \<union> B"
definition z_inter :: "'a set \<Rightarrow> 'a set \<Rightarrow> 'a set" where "z_inter A B = A \<inter> B"
definition z_diff :: "'a set \<Rightarrow> 'a set \<Rightarrow> 'a set" where "z_diff A B = A - B"
definition z_subset :: "'a set \<Rightarrow> 'a set \<Rightarrow> bool" where "z_subset A B = (A \<subseteq> B)"
definition z_psubset :: "'a set \<Rightarrow> 'a set \<Rightarrow> bool" where "z_psubset A B = (A \<subset> B)"
definition z_power :: "'a set \<Rightarrow> 'a set set" where "z_power A = Pow A"
definition z_power1 :: "'a set \<Rightarrow> 'a set set" where "z_power1 A = Pow A - {{}}"
definition z_finset :: "'a set \<Rightarrow> 'a set set" where "z_finset A = {B. B \<subseteq> A \<and> finite B}"
definition z_finset1 :: "'a set \<Rightarrow> 'a set set" where "z_finset1 A = z_finset A - {{}}"
definition z_cross :: "'a set \<Rightarrow> 'b set \<Rightarrow> ('a \<times> 'b) set" where "z_cross A B = A \<times> B"
definition z_dom :: "('a \<times> 'b) set \<Rightarrow> 'a set" where "z_dom f = Domain f"
definition z_ran :: "('a \<times> 'b) set \<Rightarrow> 'b set" where "z_ran f = Range f"
definition z_inverse :: "('a \<times> 'b) set \<Rightarrow> ('b \<times> 'a) set" where "z_inverse f = converse f"
definition z_image :: "('a \<times> 'b) set \<Rightarrow> 'a set \<Rightarrow> 'b set" where "z_image f A = f `` A"
definition z_dres :: "'a set \<Rightarrow> ('a \<times> 'b) set \<Rightarrow> ('a \<times> 'b) set" where "z_dres A f = {p \<in> f. fst p \<in> A}"
definition z_ndres :: "'a set \<Rightarrow> ('a \<times> 'b) set \<Rightarrow> ('a \<times> 'b) set" where "z_ndres A f = {p \<in> f. fst p \<notin> A}"
definition z_rres :: "('a \<times> 'b) set \<Rightarrow> 'b set \<Rightarrow> ('a \<times> 'b) set" where "z_rres f A = {p \<in> f. snd p \<in> A}"
definition z_nrres :: "('a \<times> 'b) set \<Rightarrow> 'b set \<Rightarrow> ('a \<times> 'b) set" where "z_nrres f A = {p \<in> f. snd p \<notin> A}"
definition z_override :: "('a \<times> 'b) set \<Rightarrow> ('a \<times> 'b) set \<Rightarrow> ('a \<times> 'b) set" where "z_override f g = z_ndres (Domain g) f \<union> g"
definition z_compose :: "('a \<times> 'b) set \<Rightarrow> ('b \<times> 'c) set \<Rightarrow> ('a \<times> 'c) set" where "z_compose f g = f O g"
definition z_after :: "('b \<times> 'c) set \<Rightarrow> ('a \<times> 'b) set \<Rightarrow> ('a \<times> 'c) set" where "z_after g f = f O g"
definition z_id :: "'a set \<Rightarrow> ('a \<times> 'a) set" where "z_id A = Id_on A"
definition z_rel :: "'a set \<Rightarrow> 'b set \<Rightarrow> ('a \<times> 'b) set set" where "z_rel A B = Pow (A \<times> B)"
definition z_pfun :: "'a set \<Rightarrow> 'b set \<Rightarrow> ('a \<times> 'b) set set" where "z_pfun A B = {f \<in> z_rel A B. single_valued f}"
definition z_tfun :: "'a set \<Rightarrow> 'b set \<Rightarrow> ('a \<times> 'b) set set" where "z_tfun A B = {f \<in> z_pfun A B. Domain f = A}"
definition z_pinj :: "'a set \<Rightarrow> 'b set \<Rightarrow> ('a \<times> 'b) set set" where "z_pinj A B = {f \<in> z_pfun A B. single_valued (converse f)}"
definition z_tinj :: "'a set \<Rightarrow> 'b set \<Rightarrow> ('a \<times> 'b) set set" where "z_tinj A B = {f \<in> z_pinj A B. Domain f = A}"
definition z_psurj :: "'a set \<Rightarrow> 'b set \<Rightarrow> ('a \<times> 'b) set set" where "z_psurj A B = {f \<in> z_pfun A B. Range f = B}"
definition z_tsurj :: "'a set \<Rightarrow> 'b set \<Rightarrow> ('a \<times> 'b) set set" where "z_tsurj A B = {f \<in> z_tfun A B. Range f = B}"
definition z_bij :: "'a set \<Rightarrow> 'b set \<Rightarrow> ('a \<times> 'b) set set" where "z_bij A B = {f \<in> z_tinj A B. Range f = B}"
definition z_ffun :: "'a set \<Rightarrow> 'b set \<Rightarrow> ('a \<times> 'b) set set" where "z_ffun A B = {f \<in> z_pfun A B. finite f}"
definition z_finj :: "'a set \<Rightarrow> 'b set \<Rightarrow> ('a \<times> 'b) set set" where "z_finj A B = {f \<in> z_pinj A B. finite f}"
definition z_app :: "('a \<times> 'b) set \<Rightarrow> 'a \<Rightarrow> 'b \<Rightarrow> bool" where "z_app f x y = ((x, y) \<in> f \<and> (\<forall>w. (x, w) \<in> f \<longrightarrow> w = y))"
definition z_int :: "int set" where "z_int = UNIV"
definition z_nat :: "int set" where "z_nat = {n. 0 \<le> n}"
definition z_nat1 :: "int set" where "z_nat1 = {n. 0 < n}"
definition z_upto :: "int \<Rightarrow> int \<Rightarrow> int set" where "z_upto a b = {a..b}"
definition z_plus :: "int \<Rightarrow> int \<Rightarrow> int" where "z_plus a b = a + b"
definition z_minus :: "int \<Rightarrow> int \<Rightarrow> int" where "z_minus a b = a - b"
definition z_times :: "int \<Rightarrow> int \<Rightarrow> int" where "z_times a b = a * b"
definition z_less :: "int \<Rightarrow> int \<Rightarrow> bool" where "z_less a b = (a < b)"
definition z_at_most :: "int \<Rightarrow> int \<Rightarrow> bool" where "z_at_most a b = (a \<le> b)"
definition z_card :: "('a set \<times> int) set" where "z_card = {p. finite (fst p) \<and> snd p = int (card (fst p))}"
definition z_min :: "(int set \<times> int) set" where "z_min = {p. snd p \<in> fst p \<and> (\<forall>n \<in> fst p. snd p \<le> n)}"
definition z_max :: "(int set \<times> int) set" where "z_max = {p. snd p \<in> fst p \<and> (\<forall>n \<in> fst p. n \<le> snd p)}"
definition z_seq :: "'a set \<Rightarrow> (int \<times> 'a) set set" where "z_seq A = {f. \<exists>n. 0 \<le> n \<and> f \<in> z_tfun {1..n} A}"
)z";

}  // namespace durero::zed::hol
