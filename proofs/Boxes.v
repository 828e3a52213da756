(** * Boxes: the slab test in the traversal that runs

    A tree of boxes, as the hierarchies of bounding volumes are: a node has a box, whose planes are binary64, and is
    passed over where one of the tests of Slab.v rejects it up to the limit. So is a box of which only the entry was
    kept. What a ray starts on is met outside its box, and is tested apart.

    box64                  == six planes
    holds b w              == the point w is in the box b
    beam                   == origin and direction of the ray, in binary64
    slabs b r              == the box and the ray along each axis
    rejects b r x          == a test of b rejects the ray r up to the limit x: of the box; of its stretch, computed
                              without limit and then cut off there; of its entry, kept since an earlier test
    boxed                  == a tree of boxes, elements in its leaves
    cell_of                == its cells, as Walk.v walks them
    under e a              == e is in a leaf of a, and its points in every box above
    prunable st c          == c is passed over: its box is rejected up to the limit of st *)
From Coq Require Import ZArith Reals List Bool Lra.
From Flocq Require Import Core BinarySingleNaN.
From Durero Require Import Toolkit Especificacion Puntos Interseccion Slab Walk Limits.
Import ListNotations.
Local Open Scope R_scope.
Local Open Scope zed_scope.

Record box64 := Box64 { low_x : binary64; high_x : binary64; low_y : binary64; high_y : binary64; low_z : binary64;
  high_z : binary64 }.
Record beam := Beam { p_x : binary64; p_y : binary64; p_z : binary64; v_x : binary64; v_y : binary64; v_z : binary64 }.

Definition holds (b : box64) (w : Punto) : Prop :=
  B2R (low_x b) <= Punto_x w <= B2R (high_x b) /\ B2R (low_y b) <= Punto_y w <= B2R (high_y b)
  /\ B2R (low_z b) <= Punto_z w <= B2R (high_z b).
Definition of_beam (r : beam) : Rayo :=
  mk_Rayo (mk_Punto (B2R (p_x r)) (B2R (p_y r)) (B2R (p_z r))) (mk_Vector (B2R (v_x r)) (B2R (v_y r)) (B2R (v_z r))).

Notation slab64 := (slab 53 1024).
Notation Slab64 := (Slab.Slab 53 1024).
Notation slab64_ok := (slab_ok 53 1024).
Notation visit64 := (Slab.visit 53 1024 prec64 less64 grow64 tiny64).
Notation entry64 := (Slab.entry 53 1024 prec64 less64).
Notation exit64 := (Slab.exit 53 1024 prec64 less64).
Notation passes64 := (Slab.passes 53 1024 prec64 less64 grow64 tiny64).

Definition slabs (b : box64) (r : beam) : list slab64 :=
  [Slab64 (low_x b) (high_x b) (p_x r) (v_x r); Slab64 (low_y b) (high_y b) (p_y r) (v_y r);
   Slab64 (low_z b) (high_z b) (p_z r) (v_z r)].

Definition rejects (b : box64) (r : beam) (x : binary64) : Prop :=
  visit64 (slabs b r) x = false
  \/ passes64 (entry64 (slabs b r)) (Slab.sooner 53 1024 x (exit64 (slabs b r) infinite)) = false
  \/ passes64 (entry64 (slabs b r)) x = false.

Lemma holds_covers b r t : holds b (point_at (of_beam r) t) -> Forall (fun a => covers 53 1024 a t) (slabs b r).
Proof.
  intros [Hx [Hy Hz]].
  apply Forall_cons; [exact Hx |]. apply Forall_cons; [exact Hy |]. apply Forall_cons; [exact Hz | apply Forall_nil].
Qed.

Local Instance prec53 : Prec_gt_0 53 := eq_refl.

(** A limit that is not before t is one for the tests. *)
Lemma at_least_not_before x t : at_least x t -> not_before 53 1024 x t.
Proof.
  intros [-> | [F H]]; [now left | right; split; [exact F |]].
  replace (B2R x) with (round radix2 (FLT_exp (3 - 1024 - 53) 53) ZnearestE (B2R x)).
  - now apply round_le; auto with typeclass_instances.
  - apply round_generic; [auto with typeclass_instances |]. apply generic_format_B2R.
Qed.

(** No test rejects a box in which the ray has a point up to the limit. *)
Theorem rejected_is_beyond b r x t : Forall slab64_ok (slabs b r) -> 0 < t -> holds b (point_at (of_beam r) t) ->
  rejects b r x -> ~ at_least x t.
Proof.
  intros Hok Ht Hb Hrej Hx. apply at_least_not_before in Hx. apply holds_covers in Hb. apply Rlt_le in Ht.
  destruct Hrej as [H | [H | H]].
  - now rewrite (slab64_never_rejects _ x t Hok Ht Hb Hx) in H.
  - unfold infinite in H. now rewrite (stretch64_never_rejects _ x t Hok Ht Hb Hx) in H.
  - now rewrite (entry64_never_rejects _ x t Hok Ht Hb Hx) in H.
Qed.

Section Boxes.
Variables E State : Type.
Variable limit_of : State -> binary64.
Variable r : beam.
Variable met : E -> set R.
Variable on_surface : E -> set Punto.

Inductive boxed := Leaf (es : list E) | Node (b : box64) (below : list boxed).

Fixpoint cell_of (a : boxed) : cell E :=
  match a with
  | Leaf es => Cell univ es []
  | Node b below => Cell (fun t => 0 < t /\ holds b (point_at (of_beam r) t)) [] (map cell_of below)
  end.

Inductive under (e : E) : boxed -> Prop :=
| under_leaf es : In e es -> under e (Leaf es)
| under_node b a below : In a below -> under e a -> (forall w, on_surface e w -> holds b w) -> under e (Node b below).

(** The rule, for the boxes that the test is for. *)
Definition prunable (st : State) (c : cell E) : Prop :=
  exists b below, c = cell_of (Node b below) /\ Forall slab64_ok (slabs b r) /\ rejects b r (limit_of st).

Lemma prunable_right st c : prunable st c -> forall e t, leads c e t -> met e t -> ~ at_least (limit_of st) t.
Proof.
  intros [b [below [-> [Hok Hrej]]]] e t Hl _. assert (H : stretch E (cell_of (Node b below)) t) by now destruct Hl.
  cbn [cell_of stretch] in H. destruct H as [Ht Hb]. now apply rejected_is_beyond with b r.
Qed.

(** A point of the element leads to it: not what is met of one that the ray starts on, which is met elsewhere. *)
Lemma under_leads e a t : under e a -> 0 < t -> on_surface e (point_at (of_beam r) t) -> leads (cell_of a) e t.
Proof.
  intros Hu Hpos Hw. induction Hu as [es He | b a below Ha _ IH Hb].
  - now apply leads_here.
  - apply leads_below with (cell_of a); [split; [exact Hpos | now apply Hb] | cbn; now apply in_map | exact IH].
Qed.

End Boxes.
