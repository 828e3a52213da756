(** * InstancesScreen: the theorem about the test in binary32 speaks of something

    A ray from (1, 1, -1) along z, and the triangle of the origin and of the points at 4 on two axes. Every number that is
    computed but for the bounds is a whole one. *)
From Coq Require Import Reals ZArith Lra Lia Bool.
From Flocq Require Import Core.
From Durero Require Import Toolkit Especificacion Tipos Puntos Flat Single SingleTriangle Screen.
From Durero Require MainMeshes.
Local Open Scope R_scope.
Local Open Scope zed_scope.
Local Opaque bpow.

Lemma single_whole n : (Z.abs n < 2 ^ 24)%Z -> single (IZR n).
Proof.
  intros H. apply generic_format_FLT. exists (Float radix2 n 0); [| exact H | cbn; lia]. unfold F2R. cbn.
  change (bpow radix2 0) with 1. ring.
Qed.
Lemma fl_whole n : (Z.abs n < 2 ^ 24)%Z -> fl (IZR n) = IZR n.
Proof. intros H. apply round_generic; [auto with typeclass_instances |]. now apply single_whole. Qed.

Definition ray : Rayo := mk_Rayo (mk_Punto 1 1 (-1)) (mk_Vector 0 0 1).
Definition abc : Terna := mk_Terna (mk_Punto 0 0 0) (mk_Punto 4 0 0) (mk_Punto 0 4 0).

Definition its_rate : R := / 1048576.
Definition computed_terms : terms := {| v_e2 := mk_Vector (-4) 0 0; q_e1 := mk_Vector 0 (-4) (-4); det_fl := -16; ca_fl := -4;
  ab_fl := -4; C_fl := -16; slack := 1; rate := its_rate; middle := 48; error := fl (its_rate * 48 + tiny);
  det_error := fl (its_rate * 16 + tiny); C_error := fl (fl (12 * u * 4) * 16 + tiny) |}.

Ltac whole := repeat first [rewrite <- mult_IZR | rewrite <- plus_IZR | rewrite <- minus_IZR | rewrite <- opp_IZR
  | rewrite <- abs_IZR | rewrite fl_whole by reflexivity].

Lemma tiny_is_small : 0 < tiny <= / 1048576.
Proof. split; [apply bpow_gt_0 |]. replace (/ 1048576) with (bpow radix2 (-20)) by reflexivity. apply bpow_le. lia. Qed.
Lemma extent_of_4 x : x = mk_Vector 4 0 0 \/ x = mk_Vector 0 4 0 -> extent_fl x = 4.
Proof. intros [-> | ->]; unfold extent_fl; cbn; whole; reflexivity. Qed.
Lemma edges : edge1 abc = mk_Vector 4 0 0 /\ edge2 abc = mk_Vector 0 4 0.
Proof. split; unfold edge1, edge2, from_fl; cbn; whole; reflexivity. Qed.
Lemma way_is_whole : way_of ray abc = mk_Vector 1 1 (-1).
Proof. unfold way_of, way_fl, way; cbn. whole. reflexivity. Qed.
Lemma way_extent_is_4 : way_extent ray abc computed_terms = 4.
Proof. unfold way_extent. rewrite way_is_whole. unfold extent_fl; cbn. whole. reflexivity. Qed.
Lemma area_is_16 : area abc = 16.
Proof. unfold area. destruct edges as [-> ->]. rewrite !extent_of_4 by tauto. whole. reflexivity. Qed.

Lemma it_is_in_range : in_range ray abc.
Proof.
  assert (P : forall x y z, (Z.abs x < 2 ^ 24)%Z -> (Z.abs y < 2 ^ 24)%Z -> (Z.abs z < 2 ^ 24)%Z ->
    single_point (mk_Punto (IZR x) (IZR y) (IZR z))) by (intros; repeat split; now apply single_whole).
  assert (G8 : 8 <= bpow radix2 33) by (change 8 with (bpow radix2 3); apply bpow_le; lia).
  pose proof tiny_is_small as Ti. unfold in_range, extent, total, magnitudes, from, size_of_point, ordinary. cbn.
  assert (O : bpow radix2 (-126) <= Rabs 1) by (rewrite Rabs_R1; change 1 with (bpow radix2 0); apply bpow_le; lia).
  repeat split; try (apply single_whole; reflexivity); try (now left); try (now right); whole; rewrite ?u_value; cbn; lra.
Qed.
Lemma it_is_computed : computed ray abc computed_terms.
Proof.
  pose proof tiny_is_small as Ti. unfold computed. rewrite way_extent_is_4, area_is_16, way_is_whole. destruct edges as [-> ->].
  rewrite !extent_of_4 by tauto. unfold direction_fl; cbn.
  assert (G8 : 8 <= bpow radix2 33) by (change 8 with (bpow radix2 3); apply bpow_le; lia).
  split; [repeat split; left; cbn; whole; reflexivity |]. split; [repeat split; left; cbn; whole; reflexivity |].
  split; [exists (-16); split; left; cbn; whole; reflexivity |]. split; [exists (-4); split; left; cbn; whole; reflexivity |].
  split; [exists 0; split; left; cbn; whole; reflexivity |]. split; [exists (-16); split; left; cbn; whole; reflexivity |].
  split; [now apply single_whole |].
  split; [unfold size_of_point; cbn; whole; rewrite u_value; cbn; lra |].
  split; [unfold extent, total, magnitudes, its_rate; cbn; whole; rewrite u_value; cbn; lra |].
  split; [left; whole; reflexivity |]. repeat split; now left.
Qed.

(** The ray meets the triangle in one point, as the test says: its margin of 4 is above the bound. *)
Theorem instance_of_the_screen_of_triangles_is_right : exists t, forall t', point_at ray t' ∈ puntos_triangulo abc <-> t' = t.
Proof.
  assert (N : 0 < sq (normal abc)) by (unfold sq, normal, cross, from, dot; cbn; lra).
  destruct (MainMeshes.the_screen_of_triangles_is_right ray abc computed_terms true it_is_in_range it_is_computed N ltac:(cbn;
  lra))
    as [_ [H _]]. apply H. pose proof tiny_is_small as Ti. pose proof eta_bounds as Eta.
  assert (E : error computed_terms <= 1).
  { cbn. pose proof (fl_near (its_rate * 48 + tiny)) as F. rewrite Rabs_pos_eq with (x := its_rate * 48 + tiny) in F
    by (unfold its_rate; lra).
    apply Rabs_le_inv in F. unfold its_rate in *. rewrite u_value in F. lra. }
  assert (M : margin computed_terms true = 4).
  { unfold margin, turned, bc_fl; cbn. whole. cbn. unfold Rmin. destruct (Rle_dec 4 4); destruct (Rle_dec _ _); lra. }
  rewrite M. lra.
Qed.
