(** * StablePlane: the second step on a plane is right

    trace/shape/plane-inl.hpp computes, in double-double, B = v·d / 2 and C = q·d, with q = p - centro and d = vector,
    within 3 uu V and 8 uu Q of the exact ones, where V and Q are the extents of v and q. A disc has the same two.

    along2 f == f has the plane's B and C and their bounds *)
From Coq Require Import Reals ZArith List Lra Lia Psatz.
From Flocq Require Import Core.
From Durero Require Import Toolkit Especificacion Puntos Trazador.
From Durero Require Tipos Formas.
From Durero Require Import Rounding Vectors Across Quotient Decision Flotante Verdict Advance Linear Plane Steps Twofold Sums Products
  Ratios Words Doubled StableVectors StableFlat.
Import Formas.Pairs.
Local Open Scope R_scope.
Local Open Scope zed_scope.
Local Opaque bpow.

Section Plane.
Variables p v centro d : vec.
Hypothesis ray_fits : fit_ray p v.
Hypothesis axis_fits : fit_axis centro d.
Let q := minus p centro.
Let Q := extent q.
Let V := extent v.
Let s0 := dot q d.
Let s1 := dot v d.
Let q2 := minus2 p centro.
Let v2 := exactly2 v.
Let d2 := exactly2 d.
Notation V_fl := (extent_fl v).
Notation Q_fl := (extent_fl (q_fl p centro)).
Definition half2 : twofold := product (dot2 v2 d2) (exactly (bpow radix2 (-1))).
Definition s0_2 : twofold := dot2 q2 d2.

Definition along2 (f : Formas.quadratic twofold) : Prop := Formas.B f = half2 /\ Formas.C f = s0_2 /\
  Formas.B_error f = rnd ((3 * bpow radix2 (-102)) * V_fl) /\ Formas.C_error f = rnd (bpow radix2 (-99) * Q_fl).

Lemma half_worded : worded 4 (-305) half2 (s1 * / 2) (size_of_dot v d * / 2).
Proof.
  apply (worded_mult 3 0 (-304) (-1)); [lia | |].
  - exact (worded_along d _ _ (d_ordinary axis_fits) (words_of v (v_ordinary ray_fits))).
  - replace (/ 2) with (bpow radix2 (-1)) by reflexivity.
    rewrite <- (Rabs_pos_eq (bpow radix2 (-1))) at 3 by apply bpow_ge_0.
    apply worded_exactly; [apply format_bpow; lia | exists 1%Z; ring].
Qed.

Lemma s0_worded : worded 3 (-304) s0_2 s0 (size_of_dot q d).
Proof. exact (worded_along d _ _ (d_ordinary axis_fits) (words_between p centro (p_ordinary ray_fits) (centro_ordinary
  axis_fits))). Qed.

Theorem plane_sound2 f : along2 f -> sound_flat2 f (s1 / 2) s0.
Proof.
  intros (EB & EC & EBe & ECe); pose proof u_bounds as Hu; pose proof uu_bounds as Huu.
  pose proof (V_positive v (v_not_zero ray_fits) : 0 < V) as HV; pose proof (extent_nonneg q : 0 <= Q) as HQ.
  pose proof (size_of_s1 p v centro d ray_fits axis_fits) as HS1; pose proof (size_of_s0 p centro d axis_fits) as HS0.
  pose proof half_worded as Hh; pose proof s0_worded as Hs.
  pose proof (Q_near p v centro d ray_fits axis_fits) as NQ; destruct (speed_near p v ray_fits) as [V1 V2].
  fold V in V1, V2, HS1; fold q Q in HS0, NQ.
  assert (HuV : 0 < uu * V) by (apply Rmult_lt_0_compat; lra); assert (HuQ : 0 <= uu * Q) by (apply Rmult_le_pos; lra).
  assert (HBe : 299 / 100 * (uu * V) <= rnd ((3 * bpow radix2 (-102)) * V_fl)).
  { assert (Hn : normal ((3 * bpow radix2 (-102)) * V_fl)).
    { apply (grid_normal (-102 + -152)); [lia | apply grid_mult; [exists 3%Z; ring | exact (proj2 (proj2 (V_computed v
        (v_ordinary ray_fits))))]]. }
    assert (uu * (999999 / 1000000 * V) <= uu * V_fl) by (apply Rmult_le_compat_l; lra).
    pose proof (rnd_low ((3 * bpow radix2 (-102)) * V_fl) ltac:(lra) Hn); lra. }
  assert (HCe : 799 / 100 * (uu * Q) <= rnd (bpow radix2 (-99) * Q_fl) /\
    (Q_fl = 0 \/ bpow radix2 (-251) <= rnd (bpow radix2 (-99) * Q_fl))).
  { assert (Hn : normal (bpow radix2 (-99) * Q_fl)).
    { apply (grid_normal (-99 + -152)); [lia | apply grid_mult; [exists 1%Z; ring|]].
      exact (proj2 (proj2 (Q_computed p v centro d ray_fits axis_fits))). }
    split.
    - replace (bpow radix2 (-99)) with (8 * uu) in * by (replace 8 with (bpow radix2 3) by reflexivity;
        now rewrite <- bpow_plus).
      assert (uu * (999999 / 1000000 * Q) <= uu * Q_fl) by (apply Rmult_le_compat_l; lra).
      pose proof (rnd_low (8 * uu * Q_fl) ltac:(lra) Hn); lra.
    - destruct (Req_dec Q_fl 0) as [Z0|N]; [now left | right].
      pose proof (grid_at_least _ _ (proj2 (proj2 (Q_computed p v centro d ray_fits axis_fits))) N) as H152.
      rewrite Rabs_pos_eq in H152 by lra; apply rnd_ge_bpow; [lia|]; change (-251)%Z with (-99 + -152)%Z; rewrite bpow_plus.
      apply Rmult_le_compat_l; [apply bpow_ge_0 | exact H152]. }
  assert (HB2 : Rabs (2 * hi half2) <= bpow radix2 104).
  { pose proof (worded_size 4 _ _ _ _ ltac:(lia) Hh) as Hz; rewrite Rabs_mult, (Rabs_pos_eq 2) by lra.
    pose proof (V_size v (v_ordinary ray_fits) : V <= _) as V102; change 104%Z with (2 + 102)%Z; rewrite bpow_plus.
    replace (bpow radix2 2) with 4 by reflexivity; lra. }
  assert (Hratio : bpow radix2 (-900) * Rabs (2 * hi half2) <= bpow radix2 (-304)).
  { apply Rle_trans with (bpow radix2 (-900) * bpow radix2 104); [apply Rmult_le_compat_l; [apply bpow_ge_0 | exact HB2]|].
    rewrite <- bpow_plus; apply bpow_le; lia. }
  constructor; rewrite ?EB, ?EC, ?EBe, ?ECe.
  - split; [apply Hh | apply Hs].
  - pose proof (worded_error 4 _ _ _ _ ltac:(lia) Hh) as He; simpl INR in He.
    assert (uu * size_of_dot v d <= uu * (1000001 / 1000000 * V)) by (apply Rmult_le_compat_l; lra).
    apply Rle_trans with (1 := He); lra.
  - pose proof (worded_error 3 _ _ _ _ ltac:(lia) Hs) as He; simpl INR in He.
    assert (uu * size_of_dot q d <= uu * (1000001 / 1000000 * Q)) by (apply Rmult_le_compat_l; lra).
    apply Rle_trans with (1 := He); lra.
  - split; apply format_rnd.
  - destruct HCe as [_ [Z0|HC]]; [left | right].
    + rewrite Z0, Rmult_0_r, rnd_0; split; [reflexivity|]; assert (ZQ : Q = 0) by lra.
      destruct Hs as ((_ & Hm) & _); rewrite ZQ, Rmult_0_r in HS0; pose proof (Rabs_pos s0).
      destruct (Req_dec s0 0) as [|N]; [assumption | pose proof (Rabs_pos_lt _ N); lra].
    + split; [apply Rle_trans with (2 := HC), bpow_le; lia|].
      apply Rle_trans with (1 := Hratio), Rle_trans with (2 := HC), bpow_le; lia.
  - destruct Hs as (_ & _ & G & _); destruct (Req_dec (hi s0_2) 0) as [Z0|N]; [now left | right].
    pose proof (grid_at_least _ _ G N) as Hl; split; [apply Rle_trans with (2 := Hl), bpow_le; lia | lra].
Qed.
End Plane.

Section Shapes.
Variables p v : vec.
Hypothesis ray_fits : fit_ray p v.
Notation ray := (ray_of p v).
Notation V := (extent_fl v).

Local Opaque sum difference product ratio root_of opposite exactly two_sum.
Lemma plane_along2 centro d : along2 p v centro d (plano p v V centro d).
Proof. repeat split. Qed.
Local Transparent sum difference product ratio root_of opposite exactly two_sum.

Theorem stable_plane_right centro d limit : fit_axis centro d -> format limit ->
  right_pair (reach (of_plano ray (point centro) (direction d))) limit (first_of_linear (plano p v V centro d) limit) /\
  right_pair (reach (launched (of_plano ray (point centro) (direction d)))) limit
    (first_of_linear_on (plano p v V centro d) limit).
Proof.
  intros Ha Fl; apply (flat_pair _ (dot v d / 2) (dot (minus p centro) d)); auto.
  - apply (plane_sound2 p v centro d); auto using plane_along2.
  - intros t; unfold ray_of, point, direction, value, of_plano, Tipos.dot, from, dot, minus; cbn; ring.
  - intros t; unfold ray_of, point, direction, value, launched, of_plano, Tipos.dot, from, dot, minus; cbn; ring.
  - constructor.
Qed.
End Shapes.
