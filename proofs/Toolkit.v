(** The part of Z's standard toolkit that spec/*.tex uses, sets being predicates.

    set X          == sets of X: X -> Prop
    x ∈ S, A ≡ B   == membership; extensional equality, which is Z's equality of sets
    rel X Y        == sets of pairs; a partial function of Z is a rel that is functional
    X ⇸ Y, 𝔽 X, ℙ X == the sets of partial functions, of finite subsets, of subsets
    ndres S f      == S ⩤ f, domain subtraction;  dres S f == S ◁ f
    ⋃[S] F         == the union of F i over i ∈ S
    is_mu S x      == x = μ S: x is the only element of S *)
From Coq Require Import List.

Declare Scope zed_scope.
Delimit Scope zed_scope with zed.

Definition set (X : Type) := X -> Prop.
Notation "x ∈ S" := (S x) (at level 70, no associativity, only parsing) : zed_scope.
Notation "x ∉ S" := (~ S x) (at level 70, no associativity, only parsing) : zed_scope.

Definition seteq {X} (A B : set X) : Prop := forall x, A x <-> B x.
Definition subset {X} (A B : set X) : Prop := forall x, A x -> B x.
Notation "A ≡ B" := (seteq A B) (at level 70, no associativity) : zed_scope.
Notation "A ⊆ B" := (subset A B) (at level 70, no associativity) : zed_scope.

Definition univ {X} : set X := fun _ => True.
Definition empty {X} : set X := fun _ => False.
Definition single {X} (x : X) : set X := fun y => y = x.
Definition union {X} (A B : set X) : set X := fun x => A x \/ B x.
Definition inter {X} (A B : set X) : set X := fun x => A x /\ B x.
Definition diff {X} (A B : set X) : set X := fun x => A x /\ ~ B x.
Notation "∅" := empty : zed_scope.
Notation "⦃ x ⦄" := (single x) (at level 0) : zed_scope.
Notation "A ∪ B" := (union A B) (at level 50, left associativity) : zed_scope.
Notation "A ∩ B" := (inter A B) (at level 40, left associativity) : zed_scope.
Notation "A ∖ B" := (diff A B) (at level 50, left associativity) : zed_scope.

Definition bigcup {I X} (S : set I) (F : I -> set X) : set X := fun x => exists i, S i /\ F i x.
Notation "⋃[ S ] F" := (bigcup S F) (at level 50) : zed_scope.

Definition rel (X Y : Type) := set (X * Y).
Definition dom {X Y} (f : rel X Y) : set X := fun x => exists y, f (x, y).
Definition ran {X Y} (f : rel X Y) : set Y := fun y => exists x, f (x, y).
Definition inverse {X Y} (f : rel X Y) : rel Y X := fun p => f (snd p, fst p).
Definition image {X Y} (f : rel X Y) (A : set X) : set Y := fun y => exists x, A x /\ f (x, y).
Definition dres {X Y} (A : set X) (f : rel X Y) : rel X Y := fun p => A (fst p) /\ f p.
Definition ndres {X Y} (A : set X) (f : rel X Y) : rel X Y := fun p => ~ A (fst p) /\ f p.

Definition functional {X Y} (f : rel X Y) : Prop := forall x y y', f (x, y) -> f (x, y') -> y = y'.
Definition power {X} (A : set X) : set (set X) := fun S => subset S A.
Definition finset {X} (A : set X) : set (set X) := fun S => subset S A /\ exists l, forall x, S x <-> In x l.
Definition pfun {X Y} (A : set X) (B : set Y) : set (rel X Y) :=
  fun f => functional f /\ subset (dom f) A /\ subset (ran f) B.
Notation "'𝔽' A" := (finset A) (at level 30) : zed_scope.
Notation "'ℙ' A" := (power A) (at level 30) : zed_scope.
Notation "A ⇸ B" := (pfun A B) (at level 55) : zed_scope.

Definition is_mu {X} (S : set X) : set X := fun x => S x /\ forall y, S y -> y = x.
