(** * Plane: what the tracer computes of a plane and of a disc in binary64 is within its bounds

    trace/shape/plane-inl.hpp computes, with q = p - centro and d = vector, B = v·d / 2 and C = q·d, within 3 u V and 8 u Q
    of the exact ones, where V and Q are the extents of v and q; trace/shape/disc-inl.hpp the same, and
      margin = r|s1| - |s1 q - s0 v|,  s1 = 2 B,  s0 = C,  within 32 u V (Q + r)
    which is |s1| times how far within the rim the line crosses the plane.

    along f == f has the plane's B and C and their bounds *)
From Coq Require Import Reals ZArith Lra Lia Psatz Bool.
From Flocq Require Import Core.
From Durero Require Import Rounding Vectors Across Quotient Decision Flotante Verdict Advance Linear.
From Durero Require Formas.
Local Open Scope R_scope.
Local Opaque bpow.

Section Plane.
Variables p v centro d : vec.
Hypothesis ray_fits : fit_ray p v.
Hypothesis axis_fits : fit_axis centro d.
Notation q_fl := (q_fl p centro).
Let q := minus p centro.
Let Q := extent q.
Let V := extent v.
Let s0 := dot q d.
Let s1 := dot v d.
Notation V_fl := (extent_fl v).
Notation Q_fl := (extent_fl q_fl).
Notation s0_fl := (dot_fl q_fl d).
Definition half_fl : R := rnd (dot_fl v d * bpow radix2 (-1)).

Definition along (f : Formas.quadratic R) : Prop := Formas.B f = half_fl /\ Formas.C f = s0_fl /\
  Formas.B_error f = rnd ((3 * bpow radix2 (-53)) * V_fl) /\ Formas.C_error f = rnd (bpow radix2 (-50) * Q_fl) /\
  Formas.A f = 0 /\ Formas.A_error f = 0.

Let HQ : 0 <= Q := extent_nonneg q.
Let HV : 0 < V := V_positive v (v_not_zero ray_fits).

Lemma Q_computed : computed 3 (-152) Q_fl Q Q.
Proof. exact (proj1 (extent_of_difference p centro (p_ordinary ray_fits) (centro_ordinary axis_fits))). Qed.

Lemma Q_near : 999999 / 1000000 * Q <= Q_fl <= 1000001 / 1000000 * Q.
Proof.
  pose proof (computed_error_near 3 _ _ _ _ ltac:(lia) Q_computed) as He; simpl INR in He.
  pose proof u_bounds as Hu; assert (u * Q <= / 1000000000000 * Q) by (apply Rmult_le_compat_r; lra).
  apply Rabs_le_inv in He; lra.
Qed.

Lemma half_computed : computed 4 (-305) half_fl (s1 * / 2) (size_of_dot v d * / 2).
Proof.
  apply (computed_mult 3 0 (-304) (-1)); [lia | |].
  - exact (dot_computed 0 0 (-152) (-152) v d v d ltac:(lia) (v_close v (v_ordinary ray_fits)) (close_exact _ _
    (ordinary_on_grid d
    (d_ordinary axis_fits)))).
  - replace (/ 2) with (bpow radix2 (-1)) by reflexivity; rewrite <- (Rabs_pos_eq (bpow radix2 (-1))) at 3 by apply
    bpow_ge_0.
    apply computed_exact; [apply format_bpow; lia | exists 1%Z; ring].
Qed.

Lemma size_of_s1 : 0 <= size_of_dot v d <= 1000001 / 1000000 * V.
Proof.
  split; [apply size_nonneg|]; apply Rle_trans with (1 := size_along v d V (d_unit axis_fits) (norm_le_extent v) (Rlt_le _ _
    HV)); lra.
Qed.

Lemma size_of_s0 : 0 <= size_of_dot q d <= 1000001 / 1000000 * Q.
Proof. split; [apply size_nonneg|]; apply Rle_trans with (1 := size_along q d Q (d_unit axis_fits) (norm_le_extent q) HQ);
lra. Qed.

Lemma uV_small : 0 < u * V <= / 1000000 * V.
Proof. pose proof u_bounds; split; [apply Rmult_lt_0_compat | apply Rmult_le_compat_r]; lra. Qed.

Theorem plane_sound f : along f -> sound_flat f (s1 / 2) s0.
Proof.
  intros (EB & EC & EBe & ECe & EA & EAe); pose proof u_bounds as Hu; pose proof uV_small as HuV; pose proof size_of_s1 as HS1.
  pose proof half_computed as Hh; pose proof Q_near as NQ; destruct (s0_near p v centro d ray_fits axis_fits) as [N0 S0].
  destruct (speed_near p v ray_fits) as [V1 V2]; fold V in V1, V2;
    change (extent (minus p centro)) with Q in N0, S0;
    change (dot (minus p centro) d) with s0 in N0.
  assert (HB : Rabs (half_fl - s1 / 2) <= 201 / 100 * (u * V)).
  { pose proof (computed_error_near 4 _ _ _ _ ltac:(lia) Hh) as He; simpl INR in He; apply Rle_trans with (1 := He).
    assert (u * size_of_dot v d <= u * (1000001 / 1000000 * V)) by (apply Rmult_le_compat_l; lra); lra. }
  assert (GV : grid (-152) V_fl) by exact (proj2 (proj2 (V_computed v (v_ordinary ray_fits)))).
  assert (HBe : 299 / 100 * (u * V) <= rnd ((3 * bpow radix2 (-53)) * V_fl)).
  { assert (Hn : normal ((3 * bpow radix2 (-53)) * V_fl)).
    { apply (grid_normal (-53 + -152)); [lia | apply grid_mult; [exists 3%Z; ring | exact GV]]. }
    assert (u * (999999 / 1000000 * V) <= u * V_fl) by (apply Rmult_le_compat_l; lra).
    pose proof (rnd_low ((3 * bpow radix2 (-53)) * V_fl) ltac:(lra) Hn); lra. }
  constructor; rewrite ?EB, ?EC, ?EBe, ?ECe.
  - lra.
  - destruct (Req_dec Q_fl 0) as [Z0|N].
    + assert (Q = 0) as ZQ by lra; rewrite Z0, Rmult_0_r, rnd_0; rewrite ZQ, Rmult_0_r, Rmult_0_r in N0; exact N0.
    + assert (Hn : normal (bpow radix2 (-50) * Q_fl)).
      { apply (grid_normal (-50 + -152)); [lia | apply grid_mult; [exists 1%Z; ring | exact (proj2 (proj2 Q_computed))]]. }
      assert (H50 : bpow radix2 (-50) = 8 * u) by apply multiples_of_u.
      rewrite H50 in *; assert (HuQ : u * (999999 / 1000000 * Q) <= u * Q_fl) by (apply Rmult_le_compat_l; lra).
      assert (0 <= u * Q) by (apply Rmult_le_pos; lra).
      assert (Hpos : 0 <= 8 * u * Q_fl) by lra; pose proof (rnd_low _ Hpos Hn); lra.
  - repeat split; apply format_rnd.
  - split; [exact EA | split; [exact EAe | right]].
    assert (N : V_fl <> 0) by lra; pose proof (grid_at_least _ _ GV N) as Hl; rewrite Rabs_pos_eq in Hl by lra.
    apply Rle_trans with (bpow radix2 (-205)); [apply bpow_le; lia|]; apply rnd_ge_bpow; [lia|].
    change (-205)%Z with (-53 + -152)%Z; rewrite bpow_plus; pose proof (bpow_gt_0 radix2 (-53)).
    apply Rmult_le_compat; try apply bpow_ge_0; lra.
  - destruct (Req_dec Q_fl 0) as [Z0|N]; [left | right].
    + assert (Q = 0) as ZQ by lra; rewrite Z0, Rmult_0_r, rnd_0; split; [reflexivity|].
      rewrite ZQ, Rmult_0_r in S0; pose proof (Rabs_pos s0_fl); apply Rabs_le_inv in S0; lra.
    + pose proof (grid_at_least _ _ (proj2 (proj2 Q_computed)) N) as HQ152; rewrite Rabs_pos_eq in HQ152 by lra.
      assert (HC : bpow radix2 (-202) <= rnd (bpow radix2 (-50) * Q_fl)).
      { apply rnd_ge_bpow; [lia|]; change (-202)%Z with (-50 + -152)%Z; rewrite bpow_plus.
        apply Rmult_le_compat_l; [apply bpow_ge_0 | exact HQ152]. }
      assert (HB2 : Rabs (2 * half_fl) <= bpow radix2 104).
      { pose proof (computed_size 4 _ _ _ _ ltac:(lia) Hh) as Hs; rewrite Rabs_mult, (Rabs_pos_eq 2) by lra.
        pose proof (V_size v (v_ordinary ray_fits)) as HV102; fold V in HV102.
        change 104%Z with (2 + 102)%Z; rewrite bpow_plus; replace (bpow radix2 2) with 4 by reflexivity; lra. }
      split; [apply Rle_trans with (2 := HC), bpow_le; lia|]; apply Rle_trans with (2 := HC).
      apply Rle_trans with (bpow radix2 (-900) * bpow radix2 104).
      * apply Rmult_le_compat_l; [apply bpow_ge_0 | exact HB2].
      * rewrite <- bpow_plus; apply bpow_le; lia.
Qed.

(** ** The disc *)

Variable r : R.
Hypothesis r_ordinary : ordinary r.
Hypothesis r_positive : 0 < r.
Let S_fl := rnd (half_fl + half_fl).
Let out_fl : vec := Vec (rnd (rnd (S_fl * cx q_fl) + rnd (- s0_fl * cx v))) (rnd (rnd (S_fl * cy q_fl) + rnd (- s0_fl *
  cy v)))
  (rnd (rnd (S_fl * cz q_fl) + rnd (- s0_fl * cz v))).
Definition margin_fl : R := rnd ((if Rlt_bool S_fl 0 then - rnd (r * S_fl) else rnd (r * S_fl)) - norm_fl out_fl).
Definition margin_error : R := rnd (rnd (bpow radix2 (-48) * V_fl) * rnd (Q_fl + r)).
Let out : vec := minus (scale s1 q) (scale s0 v).
Definition margin : R := r * Rabs s1 - norm out.

Local Opaque round.
Theorem disc_recorded : along (Formas.disco p v V_fl centro r d) /\
  Formas.margin (Formas.disco p v V_fl centro r d) = margin_fl /\
  Formas.margin_error (Formas.disco p v V_fl centro r d) = margin_error.
Proof. (* compared by Qed, once, with rounding folded *)
  unfold along. repeat apply conj; match goal with |- _ = ?b => exact_no_check (eq_refl b) end.
Qed.
Local Transparent round.

Lemma S_computed : computed 5 (-305) S_fl s1 (size_of_dot v d).
Proof.
  pose proof (computed_plus 4 (-305) _ _ _ _ _ _ ltac:(lia) half_computed half_computed) as Hc.
  replace (s1 * / 2 + s1 * / 2) with s1 in Hc by field.
  now replace (size_of_dot v d * / 2 + size_of_dot v d * / 2) with (size_of_dot v d) in Hc by field.
Qed.

Lemma radius_near : Rabs ((if Rlt_bool S_fl 0 then - rnd (r * S_fl) else rnd (r * S_fl)) - r * Rabs s1) <= 61 / 10 * (u
  * (r * V)) /\
  Rabs s1 <= 1000001 / 1000000 * V.
Proof.
  pose proof S_computed as Hc; pose proof size_of_s1 as HS; pose proof u_bounds as Hu; pose proof uV_small as HuV.
  pose proof (computed_error_near 5 _ _ _ _ ltac:(lia) Hc) as He; simpl INR in He.
  assert (Hsu : u * size_of_dot v d <= u * (1000001 / 1000000 * V)) by (apply Rmult_le_compat_l; lra).
  assert (Hs : Rabs (S_fl - s1) <= 502 / 100 * (u * V)) by (apply Rle_trans with (1 := He); lra).
  assert (H1 : Rabs s1 <= 1000001 / 1000000 * V) by (destruct Hc as ((_ & Hm) & _); lra).
  split; [|exact H1].
  assert (Hrr : Rabs (rnd (r * S_fl) - r * S_fl) <= u * Rabs (r * S_fl)).
  { apply rnd_rel, (grid_normal (-152 + -305)); [lia|]; apply grid_mult; [exact (proj2 (ordinary_grid r r_ordinary))|].
    exact (proj2 (proj2 Hc)). }
  rewrite Rabs_mult, (Rabs_pos_eq r) in Hrr by lra.
  assert (HS1 : Rabs S_fl <= 1001 / 1000 * V).
  { apply Rabs_le_inv in Hs, H1; apply Rabs_le; lra. }
  assert (HrV : 0 < r * V) by (apply Rmult_lt_0_compat; lra).
  assert (u * (r * Rabs S_fl) <= u * (1001 / 1000 * (r * V))).
  { apply Rmult_le_compat_l; [lra|]; replace (1001 / 1000 * (r * V)) with (r * (1001 / 1000 * V)) by ring.
    apply Rmult_le_compat_l; lra. }
  assert (Hd : Rabs (r * Rabs S_fl - r * Rabs s1) <= 502 / 100 * (u * (r * V))).
  { rewrite <- Rmult_minus_distr_l, Rabs_mult, (Rabs_pos_eq r) by lra.
    replace (502 / 100 * (u * (r * V))) with (r * (502 / 100 * (u * V))) by ring; apply Rmult_le_compat_l; [lra|].
    apply Rle_trans with (2 := Hs), Rabs_triang_inv2. }
  assert (Hsel : Rabs ((if Rlt_bool S_fl 0 then - rnd (r * S_fl) else rnd (r * S_fl)) - r * Rabs S_fl) <= u * (r * Rabs
    S_fl)).
  { destruct (Rlt_bool_spec S_fl 0).
    - rewrite (Rabs_left S_fl) at 1 by lra; replace (- rnd (r * S_fl) - r * - S_fl) with (- (rnd (r * S_fl) - r * S_fl))
      by ring.
      rewrite Rabs_Ropp; exact Hrr.
    - rewrite (Rabs_pos_eq S_fl) at 1 by lra; exact Hrr. }
  assert (0 <= u * (r * V)) by (apply Rmult_le_pos; lra).
  apply Rabs_le_inv in Hd, Hsel; apply Rabs_le; lra.
Qed.

Lemma out_near : Rabs (norm_fl out_fl - norm out) <= 281 / 10 * (u * (Q * V)) + bpow radix2 (-490) /\
  0 <= norm out <= 2001 / 1000 * (Q * V).
Proof.
  pose proof S_computed as Hc; pose proof size_of_s1 as HS; pose proof size_of_s0 as HS0; pose proof u_bounds as Hu.
  pose proof (dot_computed 1 0 (-152) (-152) q_fl d q d ltac:(lia) (q_close p centro (p_ordinary ray_fits) (centro_ordinary
    axis_fits))
    (close_exact _ _ (ordinary_on_grid d (d_ordinary axis_fits)))) as H0.
  destruct (q_close p centro (p_ordinary ray_fits) (centro_ordinary axis_fits)) as (QX & QY & QZ), (v_close v (v_ordinary
    ray_fits)) as (VX & VY & VZ).
  set (i := size_of_dot v d) in *; set (j := size_of_dot q d) in *.
  assert (Hone : forall a x b, computed 1 (-152) a x (Rabs x) -> computed 0 (-152) b b (Rabs b) ->
    computed 8 (-457) (rnd (rnd (S_fl * a) + rnd (- s0_fl * b))) (s1 * x + - s0 * b) (i * Rabs x + j * Rabs b)).
  { intros a x b Ha Hb; apply (computed_plus 7); [lia | |].
    - exact (computed_mult 5 1 (-305) (-152) _ _ _ _ _ _ ltac:(lia) Hc Ha).
    - apply (computed_coarser _ _ (-456)); [lia|]; apply (computed_more 5); [lia|].
      exact (computed_mult 4 0 (-304) (-152) _ _ _ _ _ _ ltac:(lia) (computed_opp _ _ _ _ _ H0) Hb). }
  pose proof (Hone _ _ _ QX VX) as CX; pose proof (Hone _ _ _ QY VY) as CY; pose proof (Hone _ _ _ QZ VZ) as CZ.
  pose proof (computed_error_near 8 _ _ _ _ ltac:(lia) CX) as EX;
    pose proof (computed_error_near 8 _ _ _ _ ltac:(lia) CY) as EY;
    pose proof (computed_error_near 8 _ _ _ _ ltac:(lia) CZ) as EZ; simpl INR in EX, EY, EZ.
  pose proof (norm_le_extent q : _ <= Q) as NQ; pose proof (norm_le_extent v : _ <= V) as NV.
  pose proof (norm_nonneg q); pose proof (norm_nonneg v); assert (HQV : 0 <= Q * V) by (apply Rmult_le_pos; lra).
  assert (Hsum : i * norm q + j * norm v <= 2000002 / 1000000 * (Q * V)).
  { assert (i * norm q <= 1000001 / 1000000 * V * Q) by (apply Rmult_le_compat; lra).
    assert (j * norm v <= 1000001 / 1000000 * Q * V) by (apply Rmult_le_compat; lra); lra. }
  set (k := 801 / 100 * u); assert (Hk : 0 <= k) by (unfold k; lra).
  assert (Hoff : norm (minus out_fl out) <= 1603 / 100 * (u * (Q * V))).
  { apply Rle_trans with (norm (scale k (plus (scale i (magnitudes q)) (scale j (magnitudes v))))).
    - assert (Hone' : forall a x b e, Rabs (a - (s1 * x + - s0 * b)) <= 1001 / 1000 * e * u * (i * Rabs x + j * Rabs b)
      -> e = 8 ->
        0 <= i * Rabs x + j * Rabs b -> Rabs (a - (s1 * x - s0 * b)) <= k * (i * Rabs x + j * Rabs b)).
      { intros a x b e He -> Hp; replace (s1 * x - s0 * b) with (s1 * x + - s0 * b) by ring; apply Rle_trans with (1 := He).
        apply Rmult_le_compat_r; [exact Hp | unfold k; lra]. }
      assert (Hp : forall x b, 0 <= i * Rabs x + j * Rabs b).
      { intros x b; pose proof (Rmult_le_pos i (Rabs x) ltac:(lra) (Rabs_pos x));
        pose proof (Rmult_le_pos j (Rabs b) ltac:(lra) (Rabs_pos b)); lra. }
      apply norm_mono; cbn; (eapply Hone'; [eassumption | lra | apply Hp]).
    - rewrite norm_scale, (Rabs_pos_eq k Hk); apply Rle_trans with (k * (i * norm q + j * norm v)).
      + apply Rmult_le_compat_l; [exact Hk|]; apply Rle_trans with (1 := norm_plus _ _).
        rewrite !norm_scale, !norm_magnitudes, (Rabs_pos_eq i), (Rabs_pos_eq j) by lra; lra.
      + apply Rle_trans with (k * (2000002 / 1000000 * (Q * V))); [apply Rmult_le_compat_l; lra|].
        assert (0 <= u * (Q * V)) by (apply Rmult_le_pos; lra); unfold k; lra. }
  assert (Hout : norm out <= 2000002 / 1000000 * (Q * V)).
  { apply Rle_trans with (2 := Hsum); unfold out; replace (minus (scale s1 q) (scale s0 v)) with (plus (scale s1 q)
    (scale (- s0) v))
      by (unfold minus, plus, scale; cbn; f_equal; ring).
    apply Rle_trans with (1 := norm_plus _ _); rewrite !norm_scale, Rabs_Ropp.
    assert (Rabs s1 <= i) by exact (proj2 (proj1 Hc)); assert (Rabs s0 <= j) by exact (proj2 (proj1 H0)).
    assert (Rabs s1 * norm q <= i * norm q) by (apply Rmult_le_compat_r; lra).
    assert (Rabs s0 * norm v <= j * norm v) by (apply Rmult_le_compat_r; lra); lra. }
  split; [|split; [apply norm_nonneg | lra]].
  pose proof (norm_computed_any out_fl (format_rnd _) (format_rnd _) (format_rnd _)) as Hn.
  pose proof (norm_between out_fl out) as B1; pose proof (norm_between out out_fl) as B2.
  replace (norm (minus out out_fl)) with (norm (minus out_fl out)) in B2 by (unfold norm, dot, minus; cbn; f_equal; ring).
  assert (HuQV : 0 <= u * (Q * V) <= / 1000000 * (Q * V)) by (split; [apply Rmult_le_pos | apply Rmult_le_compat_r]; lra).
  assert (u * norm out_fl <= u * (2001 / 1000 * (Q * V))) by (apply Rmult_le_compat_l; lra).
  apply Rabs_le_inv in Hn; apply Rabs_le; lra.
Qed.

Theorem margin_near : Rabs (margin_fl - margin) <= margin_error.
Proof.
  destruct radius_near as [NR S1], out_near as [NO SO]; pose proof u_bounds as Hu; pose proof uV_small as HuV.
  set (R1 := if Rlt_bool S_fl 0 then - rnd (r * S_fl) else rnd (r * S_fl)) in *; unfold margin_fl, margin; fold R1.
  assert (FR : format R1) by (unfold R1; destruct Rlt_bool; [apply generic_format_opp|]; apply format_rnd).
  pose proof (rnd_plus R1 (- norm_fl out_fl) FR (generic_format_opp _ _ _ (format_rnd _))) as Hr.
  fold (R1 - norm_fl out_fl) in Hr; set (W := Q * V) in *; assert (HW : 0 <= W) by (apply Rmult_le_pos; lra).
  assert (HuW : 0 <= u * W <= / 1000000 * W) by (split; [apply Rmult_le_pos | apply Rmult_le_compat_r]; lra).
  set (X := r * V) in *; assert (HX : 0 < X) by (apply Rmult_lt_0_compat; lra).
  assert (HuX : 0 < u * X <= / 1000000 * X) by (split; [apply Rmult_lt_0_compat | apply Rmult_le_compat_r]; lra).
  assert (H490 : bpow radix2 (-490) <= / 1000000 * (u * X)).
  { pose proof (r_least r r_ordinary r_positive) as Hr100; destruct (speed_near p v ray_fits) as [V1 V2]; fold V in V1, V2.
    pose proof (grid_at_least _ _ (proj2 (proj2 (V_computed v (v_ordinary ray_fits))))) as HV152;
      change (Flotante.V_fl v) with V_fl in HV152.
    specialize (HV152 ltac:(lra)); rewrite Rabs_pos_eq in HV152 by lra.
    assert (HV153 : bpow radix2 (-153) <= V).
    { change (-153)%Z with (-1 + -152)%Z; rewrite bpow_plus; replace (bpow radix2 (-1)) with (/ 2) by reflexivity; lra. }
    apply Rle_trans with (bpow radix2 (-30) * (u * (bpow radix2 (-100) * bpow radix2 (-153)))).
    - rewrite <- !bpow_plus; apply bpow_le; lia.
    - apply Rmult_le_compat; [apply bpow_ge_0 | repeat apply Rmult_le_pos; apply bpow_ge_0 | |].
      + replace (bpow radix2 (-30)) with (/ 1073741824) by reflexivity; lra.
      + apply Rmult_le_compat_l; [lra|]; unfold X; apply Rmult_le_compat; auto using bpow_ge_0. }
  assert (Herr : 319 / 10 * (u * (X + W)) <= margin_error).
  { assert (H48 : computed 0 (-48) (bpow radix2 (-48)) (bpow radix2 (-48)) (bpow radix2 (-48))).
    { rewrite <- (Rabs_pos_eq (bpow radix2 (-48))) at 3 by apply bpow_ge_0; apply computed_exact; [apply format_bpow;
      lia | exists 1%Z; ring]. }
    pose proof (computed_plus 3 (-152) _ _ _ _ _ _ ltac:(lia) Q_computed (computed_more 0 3 _ _ _ _ ltac:(lia)
      (r_computed r r_ordinary r_positive))) as HE.
    pose proof (computed_mult 3 4 (-200) (-152) _ _ _ _ _ _ ltac:(lia) (computed_mult 0 2 (-48) (-152) _ _ _ _ _ _
      ltac:(lia) H48
      (V_computed v (v_ordinary ray_fits))) HE) as Hm; change (Flotante.V_fl v) with V_fl in Hm; fold V in Hm.
    pose proof (computed_error_near 8 _ _ _ _ ltac:(lia) Hm) as He; simpl INR in He; fold margin_error in He.
    replace (bpow radix2 (-48)) with (32 * u) in He by (replace 32 with (bpow radix2 5) by reflexivity;
      now rewrite <- bpow_plus).
    replace (32 * u * V * (Q + r)) with (32 * (u * (X + W))) in He by (unfold X, W; ring).
    assert (H0 : 0 <= u * (X + W)) by (apply Rmult_le_pos; lra).
    assert (u * (u * (X + W)) <= / 1000000 * (u * (X + W))) by (apply Rmult_le_compat_r; lra).
    apply Rabs_le_inv in He; lra. }
  assert (HR1 : Rabs R1 <= 1001 / 1000 * X).
  { assert (0 <= r * Rabs s1 <= 1000001 / 1000000 * X).
    { split; [apply Rmult_le_pos; [lra | apply Rabs_pos] | unfold X; apply Rle_trans with (r * (1000001 / 1000000 * V));
      [apply Rmult_le_compat_l; lra | lra]]. }
    apply Rabs_le_inv in NR; apply Rabs_le; lra. }
  assert (Hn : Rabs (norm_fl out_fl) <= 2002 / 1000 * W + bpow radix2 (-490)) by (apply Rabs_le_inv in NO; apply Rabs_le;
    lra).
  assert (Hd : Rabs (R1 - norm_fl out_fl) <= 1001 / 1000 * X + (2002 / 1000 * W + bpow radix2 (-490))).
  { unfold Rminus; apply Rle_trans with (1 := Rabs_triang _ _); rewrite Rabs_Ropp; lra. }
  assert (u * Rabs (R1 - norm_fl out_fl) <= u * (1001 / 1000 * X + (2002 / 1000 * W + bpow radix2 (-490)))) by (apply
    Rmult_le_compat_l; lra).
  assert (u * bpow radix2 (-490) <= 1 * bpow radix2 (-490)) by (apply Rmult_le_compat_r; [apply bpow_ge_0 | lra]).
  apply Rle_trans with (2 := Herr); apply Rabs_le_inv in Hr, NR, NO; apply Rabs_le; lra.
Qed.

(** Where the line crosses the plane, the margin tells whether it does so within the rim. *)
Lemma margin_tells t : s1 <> 0 -> s0 + t * s1 = 0 ->
  (0 <= margin <-> dot v v * (t * t) + 2 * dot q v * t + (dot q q - r * r) <= 0).
Proof.
  intros H1 H0; assert (E0 : s0 = - (t * s1)) by lra; pose proof (Rabs_pos_lt s1 H1) as Hp.
  set (w := plus q (scale t v)); assert (Ew : out = scale s1 w).
  { unfold out; rewrite E0; unfold w, minus, plus, scale; cbn; f_equal; ring. }
  unfold margin; rewrite Ew, norm_scale; replace (r * Rabs s1 - Rabs s1 * norm w) with (Rabs s1 * (r - norm w)) by ring.
  replace (dot v v * (t * t) + 2 * dot q v * t + (dot q q - r * r)) with (dot w w - r * r)
    by (unfold w, dot, plus, scale; cbn; ring).
  rewrite <- norm_square; pose proof (norm_nonneg w) as Hn; split; intros Hle.
  - assert (0 <= r - norm w) by (apply Rmult_le_reg_l with (Rabs s1); lra).
    pose proof (Rmult_le_compat (norm w) r (norm w) r Hn Hn ltac:(lra) ltac:(lra)); lra.
  - apply Rmult_le_pos; [lra|]; assert (norm w <= r) by (apply square_le; lra); lra.
Qed.
End Plane.
