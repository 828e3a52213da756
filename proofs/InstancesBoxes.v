(** * InstancesBoxes: instances of the theorems about boxes, half-spaces and crossings, in floating point

    It goes on from InstancesRunning.v, and tests/proofs/audit.sh reads it in the same way.

    half n      == the number n/2, in a format;  slabs == a box and a ray, which is inside at the parameter 4, the best so far
    crosses i n == the crossing of the plane at n/2 across the axis i, by the ray from (-8, 1, 0.5) along (4, 0.5, -0.5) *)
From Coq Require Import ZArith Reals List Bool Lia Lra.
From Flocq Require Import Core BinarySingleNaN.
From Durero Require Slab Beams Acceleration Moments Crossings Leaves Exacto InstanceSearch InstancesRunning MainModels Main.
Import ListNotations.
Local Open Scope R_scope.
Local Instance prec53 : Prec_gt_0 53 := eq_refl.

(** ** The slab test: from (-2, 0, 3) along (1, 0, -1/2), the box from (1, -1, 0) to (3, 1, 2) *)

Section Slabs.
Variables prec emax : Z.
Context (prec_gt_0 : Prec_gt_0 prec) (prec_lt_emax : Prec_lt_emax prec emax).
Hypothesis prec_ge_8 : (8 <= prec)%Z.
Notation float := (binary_float prec emax).
Definition half (n : Z) : float := binary_normalize prec emax _ _ mode_NE n (-1) false.

Lemma half_is n : (Z.abs n <= 16)%Z -> is_finite (half n) = true /\ B2R (half n) = IZR n / 2.
Proof.
  intros H; pose proof (binary_normalize_correct prec emax _ _ mode_NE n (-1) false) as C; cbv zeta in C.
  unfold Prec_gt_0, Prec_lt_emax in *; pose proof (abs_IZR n) as A; apply IZR_le in H as H'; rewrite A in H'.
  assert (E : F2R (Float radix2 n (-1)) = IZR n / 2) by (unfold F2R; cbn; lra); rewrite E in C.
  change (round_mode mode_NE) with ZnearestE in C; rewrite round_generic in C; auto with typeclass_instances.
  - rewrite Rlt_bool_true in C; [destruct C as (V & F & _); now split|].
    apply Rle_lt_trans with (bpow radix2 3); [|apply bpow_lt; lia].
    unfold Rdiv; rewrite Rabs_mult, (Rabs_pos_eq (/ 2)) by lra; cbn; lra.
  - rewrite <- E; change (SpecFloat.fexp prec emax) with (FLT_exp (SpecFloat.emin prec emax) prec).
    apply generic_format_FLT; exists (Float radix2 n (-1)); [reflexivity | cbn [Fnum] | cbn [Fexp]; unfold SpecFloat.emin; lia].
    apply Z.le_lt_trans with (1 := H); apply Z.lt_le_trans with (radix2 ^ 8)%Z; [reflexivity|].
    apply (Zpower_le radix2); exact prec_ge_8.
Qed.

Definition slabs : list (Slab.slab prec emax) :=
  [Slab.Slab _ _ (half 2) (half 6) (half (-4)) (half 2); Slab.Slab _ _ (half (-2)) (half 2) (half 0) (half 0);
   Slab.Slab _ _ (half 0) (half 4) (half 6) (half (-1))].
Lemma half_moderate n : (Z.abs n <= 16)%Z -> Slab.moderate prec emax (half n).
Proof.
  intros H; destruct (half_is n H) as [F V]; split; [exact F | rewrite V]; unfold Prec_gt_0, Prec_lt_emax in *.
  apply IZR_le in H; rewrite abs_IZR in H; apply Rle_trans with (bpow radix2 3); [|apply bpow_le; lia].
  unfold Rdiv; rewrite Rabs_mult, (Rabs_pos_eq (/ 2)) by lra; cbn; lra.
Qed.
Lemma slabs_ok : Forall (Slab.slab_ok prec emax) slabs.
Proof.
  unfold Prec_gt_0, Prec_lt_emax in *; assert (T : bpow radix2 (2 - emax) <= / 2) by (apply (bpow_le radix2 _ (-1)); lia).
  repeat (apply Forall_cons || apply Forall_nil); (repeat split; try (apply half_moderate; cbn; lia));
    cbn [Slab.dir]; rewrite (fun n H => proj2 (half_is n H)) by (cbn; lia); [right | left | right]; try lra;
    [rewrite Rabs_pos_eq | rewrite Rabs_left]; lra.
Qed.
Lemma slabs_cover : Forall (fun a => Slab.covers prec emax a 4) slabs.
Proof.
  repeat (apply Forall_cons || apply Forall_nil); unfold Slab.covers; cbn [Slab.lo Slab.hi Slab.origin Slab.dir];
    rewrite !(fun n H => proj2 (half_is n H)) by (cbn; lia); lra.
Qed.
Lemma best_is_there : Slab.not_before prec emax (half 8) 4.
Proof.
  right; destruct (half_is 8 ltac:(cbn; lia)) as [F V]; split; [exact F|].
  replace 4 with (B2R (half 8)) by (rewrite V; lra); apply Req_le, round_generic; [auto with typeclass_instances|].
  exact (generic_format_B2R prec emax (half 8)).
Qed.
End Slabs.

Notation of_slabs theorem prec emax is_positive is_less := (theorem _ _ 4 (slabs_ok prec emax is_positive is_less (Zle_bool_imp_le 8 prec eq_refl))
  (IZR_le 0 4 (Zle_bool_imp_le 0 4 eq_refl)) (slabs_cover prec emax is_positive is_less (Zle_bool_imp_le 8 prec eq_refl))
  (best_is_there prec emax is_positive is_less (Zle_bool_imp_le 8 prec eq_refl))) (only parsing).
Definition instance_of_the_slab_test_never_rejects_in_binary64 :=
  of_slabs MainModels.the_slab_test_never_rejects_in_binary64 53%Z 1024%Z Slab.prec64 Slab.less64.
Definition instance_of_the_slab_test_never_rejects_in_binary32 :=
  of_slabs MainModels.the_slab_test_never_rejects_in_binary32 24%Z 128%Z Slab.prec32 Slab.less32.

(** ** Half-spaces: the segment from (0, 0) to (2, 2) along x - y, and the box from (1/2, 1/2) to (3/2, 3/2) *)

Lemma no_side_of_the_diagonal n : InstanceSearch.small n = true -> Beams.side 53 1024 (Exacto.over 2 n) 1 (Exacto.over 2 n) = 0.
Proof.
  intros H; unfold Beams.side; rewrite Rmult_1_l, (round_generic _ _ _ (Exacto.over 2 n)), Rminus_eq_0;
    auto with typeclass_instances; [apply round_0; auto with typeclass_instances|].
  exact (proj1 (InstanceSearch.small_is_ordinary n H)).
Qed.
Notation half_of := (Exacto.over 2).
Notation slack := (Beams.slack64 1 2 2).
Ltac magnitudes := unfold half_of; repeat split; try (apply Rabs_le; lra); lra.
Lemma ends_are_small : Rabs (half_of 0) <= 2 /\ Rabs (half_of 0) <= 2 /\ Rabs (half_of 4) <= 2 /\ Rabs (half_of 4) <= 2.
Proof. magnitudes. Qed.
Lemma end_is_computed : Rabs (half_of 4 - half_of 4) <= 4 * bpow radix2 (-53) * 2 /\ Rabs (half_of 4 - half_of 4) <= 4 * bpow radix2 (-53) * 2.
Proof. rewrite Rminus_eq_0, Rabs_R0; pose proof (bpow_gt_0 radix2 (-53)); lra. Qed.
Lemma box_is_small : Rabs (half_of 1) <= 2 /\ Rabs (half_of 3) <= 2 /\ Rabs (half_of 1) <= 2 /\ Rabs (half_of 3) <= 2.
Proof. magnitudes. Qed.
Lemma box_holds_the_middle : 0 <= / 2 <= 1 /\ half_of 1 <= half_of 0 + / 2 * (half_of 4 - half_of 0) <= half_of 3 /\
  half_of 1 <= half_of 0 + / 2 * (half_of 4 - half_of 0) <= half_of 3.
Proof. magnitudes. Qed.
Lemma low_at n : InstanceSearch.small n = true -> - slack <= Beams.side 53 1024 (half_of n) 1 (half_of n) - slack.
Proof. intros H; rewrite no_side_of_the_diagonal by exact H; lra. Qed.
Lemma high_at n : InstanceSearch.small n = true -> Beams.side 53 1024 (half_of n) 1 (half_of n) + slack <= slack.
Proof. intros H; rewrite no_side_of_the_diagonal by exact H; lra. Qed.
Definition instance_of_a_beam_keeps_what_its_low_side_holds := MainModels.a_beam_keeps_what_its_low_side_holds _ _ _ _ _ _ _ _ _ _ _ 1 _ _ _
  ends_are_small end_is_computed box_is_small box_holds_the_middle (low_at 0 eq_refl) (low_at 4 eq_refl).
Definition instance_of_a_beam_keeps_what_its_high_side_holds := MainModels.a_beam_keeps_what_its_high_side_holds _ _ _ _ _ _ _ _ _ _ _ 1 _ _ _
  ends_are_small end_is_computed box_is_small box_holds_the_middle (high_at 0 eq_refl) (high_at 4 eq_refl).

(** ** Crossings of the ray: of the plane x = -3 at 5/4, and at 2 of x = 0 and, backwards, of z = -1/2 *)

Notation half64 := InstancesRunning.half.
Notation small := InstanceSearch.small.
Notation p := (Leaves.p_of InstancesRunning.beam).
Notation v := (Leaves.v_of InstancesRunning.beam).
Notation crosses i n := (Crossings.crosses64 p v i (half64 n)).
Notation in_order := InstancesRunning.beam_in_order.
Lemma stands_at i a b n t : p i = half64 a -> v i = half64 b -> small a && small b && small n && negb (b =? 0)%Z = true ->
  IZR (n - a) = t * IZR b -> Crossings.stands64 p v (crosses i n) (Moments.At (t, (b <? 0)%Z)).
Proof.
  rewrite !andb_true_iff, negb_true_iff, Z.eqb_neq; intros P V [[[A B] N] B0] T.
  right; exists i, (half64 n); split; [now apply InstancesRunning.half_usable | split; [reflexivity|]].
  unfold Moments.event_of, Moments.crossing; rewrite P, V, !(fun m H => proj2 (InstancesRunning.half_is m H)) by assumption.
  assert (B1 : IZR b <> 0) by now apply not_0_IZR.
  assert (B2 : IZR b / 2 <> 0) by (intros E; apply B1; lra).
  unfold Exacto.over; change (IZR 2) with 2; destruct (Req_EM_T (IZR b / 2) 0) as [E | _]; [contradiction|].
  rewrite minus_IZR in T; do 2 f_equal.
  - apply Rmult_eq_reg_r with (IZR b / 2); [|exact B2]; unfold Rdiv at 2; rewrite Rmult_assoc, Rinv_l by exact B2; lra.
  - destruct (Z.ltb_spec b 0) as [L | L], (Rlt_dec (IZR b / 2) 0) as [K | K]; try reflexivity; exfalso.
    + apply IZR_lt in L; lra.
    + apply IZR_le in L; lra.
Qed.
Lemma ahead : Crossings.stands64 p v (crosses Acceleration.X (-6)) (Moments.At (5 / 4, false)).
Proof. apply (stands_at _ (-16) 8); (reflexivity || cbn; lra). Qed.
Lemma forwards : Crossings.stands64 p v (crosses Acceleration.X 0) (Moments.At (2, false)).
Proof. apply (stands_at _ (-16) 8); (reflexivity || cbn; lra). Qed.
Lemma backwards : Crossings.stands64 p v (crosses Acceleration.Z (-1)) (Moments.At (2, true)).
Proof. apply (stands_at _ 1 (-1)); (reflexivity || cbn; lra). Qed.

(** The computed parameters tell which is first; or, where they are one, exact numbers do, and then the sides. *)
Lemma computed_apart : Crossings.order64 p v (crosses Acceleration.X (-6)) (crosses Acceleration.X 0) = Lt.
Proof. vm_compute; reflexivity. Qed.
Lemma computed_alike : Crossings.order64 p v (crosses Acceleration.X 0) (crosses Acceleration.Z (-1)) = Lt.
Proof.
  unfold Crossings.order64, Crossings.exactly64; repeat match goal with
  | |- context [if ?b then _ else _] => let c := eval vm_compute in b in replace b with c by (vm_compute; reflexivity) end.
  rewrite Rcompare_Eq; [reflexivity|]; unfold Crossings.way, Crossings.speed.
  change (Crossings.plane_of (crosses Acceleration.X 0)) with (half64 0).
  change (Crossings.plane_of (crosses Acceleration.Z (-1))) with (half64 (-1)).
  change (Crossings.across (crosses Acceleration.X 0)) with Acceleration.X.
  change (Crossings.across (crosses Acceleration.Z (-1))) with Acceleration.Z.
  change (Crossings.backwards64 v Acceleration.X) with false; change (Crossings.backwards64 v Acceleration.Z) with true.
  change (p Acceleration.X) with (half64 (-16)); change (p Acceleration.Z) with (half64 1).
  change (v Acceleration.X) with (half64 8); change (v Acceleration.Z) with (half64 (-1)).
  rewrite !(fun m H => proj2 (InstancesRunning.half_is m H)) by reflexivity; unfold Exacto.over.
  rewrite Rabs_left, Rabs_pos_eq by lra; lra.
Qed.
Notation in_their_order := (Main.crossings_are_in_the_order_of_their_moments p v in_order).
Theorem instance_of_crossings_are_in_the_order_of_their_moments :
  Moments.sooner (Moments.At (5 / 4, false)) (Moments.At (2, false)) /\ Moments.sooner (Moments.At (2, false)) (Moments.At (2, true)).
Proof.
  pose proof (in_their_order _ _ _ _ ahead forwards) as A; rewrite computed_apart in A.
  pose proof (in_their_order _ _ _ _ forwards backwards) as B; rewrite computed_alike in B; exact (conj A B).
Qed.

(** The crossing at 2 is beyond a hit at 1, and so is all that lies behind it. *)
Lemma one_is_passed : Crossings.beyond64 (crosses Acceleration.X 0) (half64 2) = true.
Proof. vm_compute; reflexivity. Qed.
Definition instance_of_what_is_entered_beyond_the_limit_lies_beyond :=
  Main.what_is_entered_beyond_the_limit_lies_beyond p v in_order _ _ (half64 2) 3 forwards (IZR_le 0 2 (Zle_bool_imp_le 0 2 eq_refl))
    one_is_passed (IZR_le 2 3 (Zle_bool_imp_le 2 3 eq_refl)).
