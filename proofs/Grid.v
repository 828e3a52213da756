(** * Grid: the walk through equal cubes in the traversal that runs

    Each cube lists the elements that have a point in it, closed. The walk passes over what is left where it can tell that
    nothing there matters: the next cube is entered beyond the limit, or the box of all elements is not met up to it.

    whole t                == at the parameter t the ray is in the box of all elements
    in_cube c t            == it is in the closed cube c
    cell_of lists k        == the cell of the walk, entered at a moment
    prunable st k          == k is passed over, since from its entry on nothing in the box of all lies up to the limit *)
From Durero Require Import Acceleration Moments Lattice.
From Coq Require Import Reals ZArith List Lra.
From Durero Require Import Toolkit Walk Limits.
Import ListNotations.
Local Open Scope R_scope.

Section Grid.
Variables (p v low : axis -> R) (h : R) (count : axis -> Z).
Hypothesis h_positive : 0 < h.
Variables E State : Type.
Variable limit_of : State -> binary64.
Variable met : E -> set R.
Variable whole : set R.
Variable lists : Lattice.cell -> list E.

Definition in_cube (c : Lattice.cell) (t : R) : Prop :=
  forall i, plane low h i (c i) <= Moments.at_ p v i t <= plane low h i (c i + 1).
Definition cell_of (k : moment * Lattice.cell) : Walk.cell E :=
  Cell (fun t => fst (fst k) <= t /\ in_cube (snd k) t /\ whole t) (lists (snd k)) [].
Definition prunable (st : State) (k : Walk.cell E) : Prop :=
  exists e c, k = cell_of (e, c) /\ forall t, fst e <= t -> whole t -> ~ at_least (limit_of st) t.

Lemma prunable_right st k : prunable st k -> forall e t, leads k e t -> met e t -> ~ at_least (limit_of st) t.
Proof.
  intros [m [c [-> Hrule]]] e t Hl _. assert (H : stretch E (cell_of (m, c)) t) by now destruct Hl.
  destruct H as [Hm [_ Hw]]. now apply Hrule.
Qed.

(** What a cube is entered beyond, so are those after it. *)
Lemma late_stays m c l st : path p v low h count m c l -> in_cell p v low h c m ->
  (forall t, fst m <= t -> whole t -> ~ at_least (limit_of st) t) -> forall k, In k l -> prunable st (cell_of k).
Proof.
  intros Hp Hc Hlate [e d] Hin. exists e, d. split; [reflexivity |]. intros t Ht. apply Hlate.
  apply Rle_trans with (fst e); [| exact Ht]. apply not_later_le.
  now apply (path_in_order p v low h count h_positive m c l Hp Hc e d).
Qed.

(** Each point of an element that lies in the box of all, and that the cubes list, is led to. *)
Theorem walk_leads m c l e t : way_in p v low h count m -> in_cell p v low h c m -> in_range count c ->
  path p v low h count m c l -> 0 < t -> in_box p v low h count (t, false) -> whole t ->
  (forall d, in_range count d -> in_cube d t -> In e (lists d)) ->
  exists k, In k (map cell_of l) /\ leads k e t.
Proof.
  intros Hw Hc Hr Hp Ht Hbox Hwhole Hlists.
  destruct (walk_covers p v low h count h_positive m c l t Hw Hc Hr Hp (Rlt_le _ _ Ht) Hbox) as [m' [d [Hin [Hd [Hm Hcube]]]]].
  exists (cell_of (m', d)). split; [now apply in_map |]. apply leads_here; [now split | now apply Hlists].
Qed.
End Grid.
