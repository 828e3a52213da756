(** The part of Z's standard toolkit that spec/*.tex uses, sets being predicates.

    set X          == sets of X: X -> Prop
    x ∈ S, A ≡ B   == membership; extensional equality, which is Z's equality of sets
    rel X Y        == sets of pairs; a partial function of Z is a rel that is functional
    X ⇸ Y, X ⟶ Y    == the sets of partial and of total functions from X to Y
    𝔽 X, ℙ X        == the sets of finite subsets, of subsets
    graph f         == the pairs ((x, y), f x y) of a function of two arguments
    cartesian A B       == the pairs of an element of A and one of B
    integers        == the reals that are integers
    power_of x a    == x to the a, for x and a that are not negative, and 1 where both are zero
    ndres S f      == S ⩤ f, domain subtraction;  dres S f == S ◁ f
    ⋃[S] F         == the union of F i over i ∈ S
    is_mu S x      == x = μ S: x is the only element of S *)
From Coq Require Import List Reals.

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
Definition tfun {X Y} (A : set X) (B : set Y) : set (rel X Y) :=
  fun f => functional f /\ seteq (dom f) A /\ subset (ran f) B.
Definition graph {X Y Z} (f : X -> Y -> Z) : rel (X * Y) Z := fun p => snd p = f (fst (fst p)) (snd (fst p)).
Definition cartesian {X Y} (A : set X) (B : set Y) : set (X * Y) := fun p => A (fst p) /\ B (snd p).
Definition integers : set R := fun x => exists z, x = IZR z.
Definition power_of (x a : R) : R := if Req_EM_T a 0 then 1%R else if Rle_dec x 0 then 0%R else Rpower x a.
Notation "'𝔽' A" := (finset A) (at level 30) : zed_scope.
Notation "'ℙ' A" := (power A) (at level 30) : zed_scope.
Notation "A ⇸ B" := (pfun A B) (at level 55) : zed_scope.
Notation "A ⟶ B" := (tfun A B) (at level 55) : zed_scope.

Definition is_mu {X} (S : set X) : set X := fun x => S x /\ forall y, S y -> y = x.

(** ** Equality of sets is an equivalence that every operation respects *)
From Coq Require Import Setoid Morphisms Classical_Prop.
Local Open Scope zed_scope.

Global Instance seteq_equivalence {X} : Equivalence (@seteq X).
Proof.
  split; [intros A x; tauto | intros A B H x; symmetry; apply H |].
  intros A B C H H' x. rewrite (H x). apply H'.
Qed.
Lemma seteq_refl {X} (A : set X) : A ≡ A.
Proof. reflexivity. Qed.
Lemma seteq_sym {X} (A B : set X) : A ≡ B -> B ≡ A.
Proof. now symmetry. Qed.
Lemma seteq_trans {X} (A B C : set X) : A ≡ B -> B ≡ C -> A ≡ C.
Proof. now intros ->. Qed.

Global Instance union_proper {X} : Proper (seteq ==> seteq ==> seteq) (@union X).
Proof. intros A A' H B B' H' x. unfold union. now rewrite (H x), (H' x). Qed.
Global Instance diff_proper {X} : Proper (seteq ==> seteq ==> seteq) (@diff X).
Proof. intros A A' H B B' H' x. unfold diff. now rewrite (H x), (H' x). Qed.
Global Instance inter_proper {X} : Proper (seteq ==> seteq ==> seteq) (@inter X).
Proof. intros A A' H B B' H' x. unfold inter. now rewrite (H x), (H' x). Qed.
Global Instance dom_proper {X Y} : Proper (seteq ==> seteq) (@dom X Y).
Proof. intros f f' H x. unfold dom. now setoid_rewrite (H _). Qed.
Global Instance ran_proper {X Y} : Proper (seteq ==> seteq) (@ran X Y).
Proof. intros f f' H x. unfold ran. now setoid_rewrite (H _). Qed.
Global Instance inverse_proper {X Y} : Proper (seteq ==> seteq) (@inverse X Y).
Proof. intros f f' H x. apply H. Qed.
Global Instance image_proper {X Y} : Proper (seteq ==> seteq ==> seteq) (@image X Y).
Proof. intros f f' H A A' H' y. unfold image. setoid_rewrite (H _). now setoid_rewrite (H' _). Qed.
Global Instance ndres_proper {X Y} : Proper (seteq ==> seteq ==> seteq) (@ndres X Y).
Proof. intros A A' H f f' H' y. unfold ndres. now rewrite (H _), (H' _). Qed.
Global Instance subset_proper {X} : Proper (seteq ==> seteq ==> iff) (@subset X).
Proof. intros A A' H B B' H'. unfold subset. setoid_rewrite (H _). now setoid_rewrite (H' _). Qed.
Global Instance functional_proper {X Y} : Proper (seteq ==> iff) (@functional X Y).
Proof. intros f f' H. unfold functional. now setoid_rewrite (H _). Qed.
Global Instance pfun_proper {X Y} (A : set X) (B : set Y) : Proper (seteq ==> iff) (pfun A B).
Proof. intros f f' H. unfold pfun. now rewrite H. Qed.
Global Instance finset_proper {X} (A : set X) : Proper (seteq ==> iff) (finset A).
Proof. intros S S' H. unfold finset. rewrite H. now setoid_rewrite (H _). Qed.
Global Instance power_proper {X} (A : set X) : Proper (seteq ==> iff) (power A).
Proof. intros S S' H. unfold power. now rewrite H. Qed.

(** ** Finite sets: a subset of a finite set is finite, and so is a finite set with one element more *)
Lemma list_filter_classically {X} (P : X -> Prop) l : exists l', forall x, In x l' <-> In x l /\ P x.
Proof.
  induction l as [| a l [l' IH]]; [exists nil; cbn; tauto |].
  destruct (classic (P a)) as [Ha | Ha]; [exists (a :: l') | exists l']; intros x; cbn; rewrite IH;
    intuition (subst; tauto).
Qed.
Lemma finset_subset {X} (S S' : set X) : S ∈ 𝔽 univ -> S' ⊆ S -> S' ∈ 𝔽 univ.
Proof.
  intros [_ [l Hl]] H. split; [easy |]. destruct (list_filter_classically S' l) as [l' Hl'].
  exists l'. intros x. rewrite Hl', <- Hl. specialize (H x). tauto.
Qed.
Lemma finset_add {X} (S : set X) x : S ∈ 𝔽 univ -> S ∪ ⦃x⦄ ∈ 𝔽 univ.
Proof.
  intros [_ [l Hl]]. split; [easy |]. exists (x :: l). intros y. unfold union, single. cbn. rewrite <- Hl.
  intuition congruence.
Qed.

(** ** One element added to, or taken from, a function. at_one e vs == the function of e alone, with the value in vs *)
Definition at_one {X Y} (e : X) (vs : set Y) : rel X Y := fun p => fst p = e /\ snd p ∈ vs.
Definition at_most_one {Y} (vs : set Y) : Prop := forall v v', v ∈ vs -> v' ∈ vs -> v = v'.

Lemma at_one_single {X Y} (f : rel X Y) e v : f ∪ at_one e ⦃v⦄ ≡ f ∪ ⦃(e, v)⦄.
Proof. intros [x y]. unfold union, at_one, single. cbn. intuition congruence. Qed.
Lemma at_one_empty {X Y} (f : rel X Y) e : f ∪ at_one e ∅ ≡ f.
Proof. intros [x y]. unfold union, at_one, empty. cbn. tauto. Qed.
Lemma dom_union_at_one {X Y} (f : rel X Y) e vs x : dom (f ∪ at_one e vs) x <-> dom f x \/ (x = e /\ exists v, vs v).
Proof.
  unfold dom, union, at_one. cbn. split.
  - intros [y [H | [-> H]]]; eauto.
  - intros [[y H] | [-> [v H]]]; eauto.
Qed.
Lemma dom_union_single {X Y} (f : rel X Y) e v x : dom (f ∪ ⦃(e, v)⦄) x <-> dom f x \/ x = e.
Proof.
  rewrite (dom_proper _ _ (seteq_sym _ _ (at_one_single f e v)) x), dom_union_at_one.
  split; [tauto |]. intros [H | H]; [now left | right; split; [exact H | now exists v]].
Qed.
Lemma image_inverse_union {X Y} (f : rel X Y) e t T x :
  image (inverse (f ∪ ⦃(e, t)⦄)) T x <-> image (inverse f) T x \/ (x = e /\ T t).
Proof.
  unfold image, inverse, union, single. cbn. split.
  - intros [y [HT [H | [= -> ->]]]]; eauto.
  - intros [[y [HT H]] | [-> H]]; eauto.
Qed.
Lemma pfun_union {X Y} (f : rel X Y) (B : set Y) e vs :
  f ∈ (univ ⇸ B) -> e ∉ dom f -> at_most_one vs -> vs ⊆ B -> f ∪ at_one e vs ∈ (univ ⇸ B).
Proof.
  intros [Hf [_ HB]] He H1 Hvs. split; [| split; [easy |]].
  - intros x y y' [H | [E H]] [H' | [E' H']]; cbn in *; subst.
    + exact (Hf _ _ _ H H').
    + destruct He. now exists y.
    + destruct He. now exists y'.
    + exact (H1 _ _ H H').
  - intros y [x [H | [_ H]]]; [apply HB; now exists x | now apply Hvs].
Qed.
Lemma dom_ndres {X Y} (f : rel X Y) e x : dom (ndres ⦃e⦄ f) x <-> dom f x /\ x <> e.
Proof. unfold dom, ndres, single. cbn. firstorder. Qed.
Lemma image_inverse_ndres {X Y} (f : rel X Y) e T x :
  image (inverse (ndres ⦃e⦄ f)) T x <-> image (inverse f) T x /\ x <> e.
Proof. unfold image, inverse, ndres, single. cbn. firstorder. Qed.
Lemma pfun_ndres {X Y} (f : rel X Y) (B : set Y) e : f ∈ (univ ⇸ B) -> ndres ⦃e⦄ f ∈ (univ ⇸ B).
Proof.
  intros [Hf [_ HB]]. split; [| split; [easy |]].
  - intros x y y' [_ H] [_ H']. exact (Hf _ _ _ H H').
  - intros y [x [_ H]]. apply HB. now exists x.
Qed.
Lemma ndres_outside {X Y} (f : rel X Y) e : e ∉ dom f -> ndres ⦃e⦄ f ≡ f.
Proof.
  intros He [x y]. unfold ndres, single. cbn. split; [tauto |]. intros H. split; [| exact H].
  intros ->. apply He. now exists y.
Qed.
Lemma ndres_union_at_one {X Y} (f : rel X Y) e vs : e ∉ dom f -> ndres ⦃e⦄ (f ∪ at_one e vs) ≡ f.
Proof.
  intros He [x y]. unfold ndres, union, at_one, single. cbn. split; [tauto |]. intros H. split; [| now left].
  intros ->. apply He. now exists y.
Qed.

(** ** Decisions of what is put together of what is decided *)
Lemma not_dec {P : Prop} : {P} + {~ P} -> {~ P} + {~ ~ P}.
Proof. intros [HP | NP]; [right; intros N; exact (N HP) | left; exact NP]. Defined.
Lemma and_dec {P Q : Prop} : {P} + {~ P} -> {Q} + {~ Q} -> {P /\ Q} + {~ (P /\ Q)}.
Proof.
  intros [HP | NP] [HQ | NQ]; [left; exact (conj HP HQ) | right; intros [_ H]; exact (NQ H)
    | right; intros [H _]; exact (NP H) ..].
Defined.
Lemma or_dec {P Q : Prop} : {P} + {~ P} -> {Q} + {~ Q} -> {P \/ Q} + {~ (P \/ Q)}.
Proof.
  intros [HP | NP] [HQ | NQ]; [left; exact (or_introl HP) .. | left; exact (or_intror HQ) |].
  right; intros [H | H]; [exact (NP H) | exact (NQ H)].
Defined.
