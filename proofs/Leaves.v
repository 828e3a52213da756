(** * Leaves: octrees and trees of planes in the traversal that runs

    Each leaf lists the elements that have a point in it, closed. What is walked is passed over where nothing is found of
    the box of all elements up to the limit, and from the first leaf on that is entered beyond it, all in binary64.

    p_of r, v_of r         == origin and direction of the ray r along the axes
    tree_walk low high walk == the walk from the way in to the way out of the root's box, if there is one
    cell_of k              == the leaf k, with its entry, as Walk.v visits it
    passed_over st c       == c is passed over in the state st
    half_holds w n a       == the point w is in the closed leaf n of the tree a;  eighth_holds: of an octree
    listed_by holds e      == each point of e is in the box of all, and in leaves that list e *)
From Durero Require Import Acceleration Moments Line Crossings Trees.
From Coq Require Import ZArith Reals List Bool Lra Sorted.
From Flocq Require Import Core BinarySingleNaN.
From Durero Require Import Toolkit Especificacion Puntos Interseccion Walk Limits Boxes Chain.
Import ListNotations.
Local Open Scope R_scope.
Local Open Scope zed_scope.

Definition p_of (r : beam) (i : axis) : binary64 :=
  match i with Acceleration.X => p_x r | Acceleration.Y => p_y r | Acceleration.Z => p_z r end.
Definition v_of (r : beam) (i : axis) : binary64 :=
  match i with Acceleration.X => v_x r | Acceleration.Y => v_y r | Acceleration.Z => v_z r end.

Section Leaves.
Variable r : beam.
Hypothesis ordinary_ray : ordinary (p_of r) (v_of r).
Notation pr := (fun i => B2R (p_of r i)).
Notation vr := (fun i => B2R (v_of r i)).
Notation line := (line64 (p_of r) (v_of r) ordinary_ray).
Notation stands := (stands64 (p_of r) (v_of r)).
Notation position t := (along (point_at (of_beam r) t)).

Variable Leaf : Type.
Notation entry := (crossing64 * Leaf)%type.

Definition tree_walk (low high : axis -> binary64) (walk : crossing64 -> crossing64 -> list entry) : list entry :=
  match way_in pr vr line low high with
  | Some c => walk c (way_out pr vr line low high)
  | None => []
  end.

(** ** Where the leaves are *)

Inductive half_holds (w : axis -> R) (n : Leaf) : halved pr vr line Leaf -> Prop :=
| holds_whole : half_holds w n (Whole _ _ _ _ n)
| holds_below i x lo hi : w i <= B2R x -> half_holds w n lo -> half_holds w n (Halved _ _ line _ i x lo hi)
| holds_beyond i x lo hi : B2R x <= w i -> half_holds w n hi -> half_holds w n (Halved _ _ line _ i x lo hi).
Inductive eighth_holds (w : axis -> R) (n : Leaf) : eighths pr vr line Leaf -> Prop :=
| holds_leaf : eighth_holds w n (Eighth _ _ _ _ n)
| holds_child x h (at_ : axis -> bool) : (forall i, if at_ i then B2R (x i) <= w i else w i <= B2R (x i)) ->
    eighth_holds w n (child _ _ _ _ h at_) -> eighth_holds w n (Trees.Node _ _ line _ x h).

Lemma position_is t i : position t i = at_ pr vr i t.
Proof. destruct i; reflexivity. Qed.
Lemma above_now i x t : above pr vr i x (t, false) <-> x <= position t i.
Proof. rewrite position_is. unfold above. cbn [fst snd]. destruct (Rlt_dec _ 0); reflexivity. Qed.

Lemma in_half_holds t n a : in_half pr vr line Leaf (t, false) n a -> half_holds (position t) n a.
Proof.
  induction 1 as [| i x lo hi H _ IH | i x lo hi H _ IH]; [constructor | |].
  - apply holds_below; [| exact IH]. apply Rnot_lt_le. intros N. apply H, above_now. now apply Rlt_le.
  - apply holds_beyond; [now apply above_now | exact IH].
Qed.
Lemma in_eighth_holds t n a : in_eighth pr vr line Leaf (t, false) n a -> eighth_holds (position t) n a.
Proof.
  induction 1 as [| x h at_ H _ IH]; [constructor |]. apply holds_child with at_; [| exact IH]. intros i.
  specialize (H i). rewrite above_now in H. destruct (at_ i); [now apply H |].
  apply Rnot_lt_le. intros N. apply Rlt_le, H in N. discriminate.
Qed.

(** ** The walk as Walk.v has it *)

Variables E State : Type.
Variable limit_of : State -> binary64.
Variable lists : Leaf -> list E.
Variable all : box64.
Definition whole (t : R) : Prop := 0 < t /\ holds all (point_at (of_beam r) t).
Definition cell_of (k : entry) : Walk.cell E :=
  Cell (fun t => (exists m, stands (fst k) (At m) /\ start ⊑ m /\ fst m <= t) /\ whole t) (lists (snd k)) [].

Section Walked.
Variable walked : list entry.

(** What search_cells does not look at. *)
Definition passed_over (st : State) (c : Walk.cell E) : Prop :=
  (Forall slab64_ok (slabs all r) /\ rejects all r (limit_of st) /\ exists k, c = cell_of k)
  \/ exists before k after, walked = before ++ k :: after /\ beyond64 (fst k) (limit_of st) = true
     /\ exists k', In k' (k :: after) /\ c = cell_of k'.

Lemma passed_over_right inside m A st c : covers pr vr line Leaf inside m A walked -> start ⊑ m -> passed_over st c ->
  forall e t, leads c e t -> ~ at_least (limit_of st) t.
Proof.
  intros [Hf [Hs _]] Hm Hrule e t Hl.
  assert (Stretch : forall k, c = cell_of k -> stretch E (cell_of k) t) by (intros k <-; now destruct Hl).
  destruct Hrule as [[Hok [Hrej [k Hk]]] | [bef [k [aft [Hw [Hb [k' [Hin Hk']]]]]]]].
  - destruct (Stretch k Hk) as [_ [Ht Hbox]]. now apply rejected_is_beyond with all r.
  - destruct (Stretch k' Hk') as [[m' [Hm' [_ Hle]]] _].
    assert (K : exists mk, stands (fst k) (At mk) /\ start ⊑ mk /\ fst mk <= t).
    { rewrite Hw in Hf, Hs. apply Forall_app in Hf as [_ Hf]. inversion_clear Hf as [| ? ? [mk [Hk [Hmk _]]] _].
      exists mk. split; [exact Hk | split; [exact (not_later_trans _ _ _ Hm Hmk) |]].
      assert (S : StronglySorted (not_after pr vr line Leaf) (k :: aft)).
      { clear - Hs. induction bef as [| x bef IH]; [exact Hs | inversion_clear Hs; now apply IH]. }
      destruct Hin as [<- | Hin]; [now rewrite (stands_one _ _ ordinary_ray _ _ _ Hk Hm') |].
      inversion_clear S as [| ? ? _ F]. rewrite Forall_forall in F. destruct (F k' Hin) as [e1 [e2 [H1 [H2 H12]]]].
      rewrite (stands_one _ _ ordinary_ray _ _ _ Hk H1). apply Rle_trans with (2 := Hle).
      rewrite (stands_one _ _ ordinary_ray _ _ _ Hm' H2). now apply not_later_le. }
    destruct K as [mk [Hk [H0 Hle']]]. apply (beyond64_right _ _ ordinary_ray (fst k) mk); auto.
    exact (not_later_le _ _ H0).
Qed.
End Walked.

(** ** Any tree whose walk covers its root *)

Variables low high : axis -> binary64.
Hypothesis low_usable : forall i, usable64 (low i).
Hypothesis high_usable : forall i, usable64 (high i).
Variable walk : crossing64 -> crossing64 -> list entry.
Variable inside : moment -> Leaf -> Prop.
Hypothesis walk_covers : forall enter leave m A, stands enter (At m) -> stands leave A -> At m ≼ A ->
  covers pr vr line Leaf inside m A (walk enter leave).
Variable met : E -> set R.

Theorem tree_is_walked : let walked := tree_walk low high walk in
  (forall st c, passed_over walked st c -> forall e t, leads c e t -> met e t -> ~ at_least (limit_of st) t)
  /\ forall e t, whole t -> (forall i, B2R (low i) <= position t i < B2R (high i)) ->
     (forall n, inside (t, false) n -> In e (lists n)) -> exists k, In k (map cell_of walked) /\ leads k e t.
Proof.
  intros walked. unfold walked, tree_walk.
  assert (Out : forall m, in_box pr vr (fun i => B2R (low i)) (fun i => B2R (high i)) m ->
    exists A, stands (way_out pr vr line low high) A /\ sooner (At m) A)
    by exact (way_out_right pr vr line low high low_usable high_usable).
  split.
  - intros st c Hc e t Hl _. destruct (way_in pr vr line low high) as [enter |] eqn:Hin.
    + destruct (way_in_known pr vr line low high low_usable high_usable enter Hin) as [m [Hm [Hs Hbox]]].
      destruct (Out m Hbox) as [A [HA HmA]].
      exact (passed_over_right _ inside m A st c (walk_covers _ _ m A Hm HA (sooner_not_later _ _ HmA)) Hs Hc e t Hl).
    + destruct Hc as [[Hok [Hrej [k ->]]] | [bef [k [aft [Hw _]]]]]; [| now destruct bef].
      assert (H : stretch E (cell_of k) t) by now destruct Hl. destruct H as [_ [Ht Hbox]].
      now apply rejected_is_beyond with all r.
  - intros e t Hwhole Hbox Hlists.
    assert (B : in_box pr vr (fun i => B2R (low i)) (fun i => B2R (high i)) (t, false)).
    { intros i. destruct (Hbox i) as [H1 H2]. split; [now apply above_now |]. intros N. apply above_now in N. lra. }
    assert (Ht : 0 <= t) by (destruct Hwhole; lra).
    destruct (way_in_right pr vr line low high low_usable high_usable t Ht B) as [enter [m [Hin [Hm Hmt]]]].
    destruct (way_in_known pr vr line low high low_usable high_usable enter Hin) as [m1 [Hm1 [Hs Hbox1]]].
    rewrite (stands_one _ _ ordinary_ray _ _ _ Hm1 Hm) in *. rewrite Hin.
    destruct (Out m Hbox1) as [A [HA HmA]]. destruct (Out (t, false) B) as [A' [HA' HtA]].
    destruct (walk_covers _ _ m A' Hm HA') as [Hf [_ Hc]].
    { intros N. exact (Hmt (sooner_then _ _ _ HtA (sooner_not_later _ _ N))). }
    destruct (Hc (t, false) Hmt HtA) as [k [mk [Hk [Hmk [Hle Hn]]]]].
    exists (cell_of k). split; [now apply in_map |]. apply leads_here; [| now apply Hlists].
    split; [| exact Hwhole]. exists mk. split; [exact Hmk | split; [| now apply not_later_le in Hle]].
    rewrite Forall_forall in Hf. destruct (Hf k Hk) as [mk' [Hmk' [H1 _]]].
    rewrite (stands_one _ _ ordinary_ray _ _ _ Hmk Hmk'). exact (not_later_trans _ _ _ Hs H1).
Qed.
End Leaves.

(** ** Joined to the text *)
Section Text.
Variable Elemento : Type.
Variable s : Especificacion.Escena Elemento.
Variable en : set Elemento.
Variables (elements apart : list Elemento) (State Leaf : Type) (limit_of : State -> binary64) (lists : Leaf -> list Elemento).
Variable r : beam.
Hypothesis ordinary_ray : ordinary (p_of r) (v_of r).
Variables (all : box64) (low high : axis -> binary64).
Hypothesis low_usable : forall i, usable64 (low i).
Hypothesis high_usable : forall i, usable64 (high i).
Notation met := (met (of_beam r) Elemento s en).

Definition listed_by (holds : (axis -> R) -> Leaf -> Prop) (e : Elemento) : Prop :=
  forall w, puntos_de_elemento s e w -> Boxes.holds all w /\ (forall i, B2R (low i) <= along w i < B2R (high i))
    /\ forall n, holds (along w) n -> In e (lists n).
Hypothesis starts_apart : forall e, In e elements -> en e -> In e apart.

(** What is passed over does not matter, and what is met is led to. *)
Definition well_walked (walked : list (crossing64 * Leaf)) : Prop :=
  (forall st c, passed_over r Leaf Elemento State limit_of lists all walked st c ->
   forall e t, leads c e t -> met e t -> ~ at_least (limit_of st) t)
  /\ forall e t, In e elements -> ~ In e apart -> met e t ->
     exists k, In k (map (cell_of r Leaf Elemento lists all) walked) /\ leads k e t.

Theorem a_covered_walk_is_well_walked walk inside (holds : (axis -> R) -> Leaf -> Prop) :
  (forall enter leave m A, stands64 (p_of r) (v_of r) enter (At m) -> stands64 (p_of r) (v_of r) leave A -> At m ≼ A ->
   covers _ _ (line64 (p_of r) (v_of r) ordinary_ray) Leaf inside m A (walk enter leave)) ->
  (forall t n, inside (t, false) n -> holds (along (point_at (of_beam r) t)) n) ->
  (forall e, In e elements -> ~ In e apart -> listed_by holds e) ->
  well_walked (tree_walk r ordinary_ray Leaf low high walk).
Proof.
  intros covered in_holds listed.
  destruct (tree_is_walked r ordinary_ray Leaf Elemento State limit_of lists all low high low_usable high_usable
    walk inside covered met) as [H1 H2].
  split; [exact H1 |]. intros e t He Hn Ht.
  destruct (met_of_another _ _ _ _ _ _ (fun N => Hn (starts_apart e He N)) Ht) as [Hpos Hpoint].
  destruct (listed e He Hn _ Hpoint) as [Hall [Hbox Hlists]].
  apply H2; [now split | exact Hbox |]. intros n Hin. now apply Hlists, in_holds.
Qed.

Theorem halves_are_well_walked a : planes_usable _ _ _ _ a ->
  (forall e, In e elements -> ~ In e apart -> listed_by (fun w n => half_holds r ordinary_ray Leaf w n a) e) ->
  well_walked (tree_walk r ordinary_ray Leaf low high (walk_halves _ _ _ Leaf a)).
Proof.
  intros Ha. apply a_covered_walk_is_well_walked with (1 := halves_are_covered _ _ _ Leaf a Ha).
  intros t n. apply in_half_holds.
Qed.
Theorem eighths_are_well_walked a : middles_usable _ _ _ _ a ->
  (forall e, In e elements -> ~ In e apart -> listed_by (fun w n => eighth_holds r ordinary_ray Leaf w n a) e) ->
  well_walked (tree_walk r ordinary_ray Leaf low high (walk_eighths _ _ _ Leaf a)).
Proof.
  intros Ha. apply a_covered_walk_is_well_walked with (1 := eighths_are_covered _ _ _ Leaf a Ha).
  intros t n. apply in_eighth_holds.
Qed.
End Text.
