(** * Triangle: what the tracer computes of a triangle in binary64 is within its bounds

    trace/shape/triangle-inl.hpp computes, with e1 = b - a, e2 = c - a and q = p - a,
      det = e1·(v × e2),  B = -det/2,  C = e2·(q × e1),  ab = v·(q × e1),  ca = q·(v × e2),  bc = det - ca - ab
    and for margin the least of ab, bc and ca, each turned by the sign of det. The products of three extents bound what
    each triple product errs by: 8 units for B, 16 for C, and 18 for the margin.

    triple_size x y w == the sum of the sizes of the six products of x·(y × w) *)
From Coq Require Import Reals ZArith Lra Lia Psatz Bool.
From Flocq Require Import Core.
From Durero Require Import Rounding Vectors Across Quotient Decision Flotante Verdict Advance Linear.
From Durero Require Formas.
Local Open Scope R_scope.
Local Opaque bpow.

(** ** Triple products *)

Definition triple_size (x y w : vec) : R :=
  Rabs (cx x) * (Rabs (cy y) * Rabs (cz w) + Rabs (cz y) * Rabs (cy w)) +
  Rabs (cy x) * (Rabs (cz y) * Rabs (cx w) + Rabs (cx y) * Rabs (cz w)) +
  Rabs (cz x) * (Rabs (cx y) * Rabs (cy w) + Rabs (cy y) * Rabs (cx w)).

Lemma triple_size_le x y w : triple_size x y w <= extent x * (extent y * extent w).
Proof.
  assert (Hp : forall i j k i' j' k', 0 <= i -> 0 <= j -> 0 <= k -> 0 <= i' -> 0 <= j' -> 0 <= k' ->
    i * j' + j * i' <= (i + j + k) * (i' + j' + k')).
  { intros i j k i' j' k' H1 H2 H3 H4 H5 H6; pose proof (Rmult_le_pos _ _ H1 H4); pose proof (Rmult_le_pos _ _ H1 H6).
    pose proof (Rmult_le_pos _ _ H2 H5); pose proof (Rmult_le_pos _ _ H2 H6); pose proof (Rmult_le_pos _ _ H3 H4).
    pose proof (Rmult_le_pos _ _ H3 H5); pose proof (Rmult_le_pos _ _ H3 H6); lra. }
  unfold triple_size, extent.
  pose proof (Hp _ _ _ _ _ _ (Rabs_pos (cy y)) (Rabs_pos (cz y)) (Rabs_pos (cx y)) (Rabs_pos (cy w)) (Rabs_pos (cz w))
    (Rabs_pos (cx w))) as X.
  pose proof (Hp _ _ _ _ _ _ (Rabs_pos (cz y)) (Rabs_pos (cx y)) (Rabs_pos (cy y)) (Rabs_pos (cz w)) (Rabs_pos (cx w))
    (Rabs_pos (cy w))) as Y.
  pose proof (Hp _ _ _ _ _ _ (Rabs_pos (cx y)) (Rabs_pos (cy y)) (Rabs_pos (cz y)) (Rabs_pos (cx w)) (Rabs_pos (cy w))
    (Rabs_pos (cz w))) as Z.
  apply (Rmult_le_compat_l (Rabs (cx x)) _ _ (Rabs_pos _)) in X;
    apply (Rmult_le_compat_l (Rabs (cy x)) _ _ (Rabs_pos _)) in Y;
    apply (Rmult_le_compat_l (Rabs (cz x)) _ _ (Rabs_pos _)) in Z; lra.
Qed.

Lemma triple_computed i j k x_fl x y_fl y w_fl w : close i (-152) x_fl x -> close j (-152) y_fl y -> close k (-152) w_fl w ->
  computed (i + j + k + 5) (-456) (dot_fl x_fl (cross_fl y_fl w_fl)) (dot x (cross y w)) (triple_size x y w).
Proof.
  intros (X1 & X2 & X3) (Y1 & Y2 & Y3) (W1 & W2 & W3).
  assert (Hcross : forall a a' b b' s s' t t', computed j (-152) a s (Rabs s) -> computed k (-152) b t (Rabs t) ->
    computed j (-152) a' s' (Rabs s') -> computed k (-152) b' t' (Rabs t') ->
    computed (j + k + 2) (-304) (rnd (rnd (a * b) - rnd (a' * b'))) (s * t - s' * t') (Rabs s * Rabs t + Rabs s' * Rabs t')).
  { intros; replace (j + k + 2)%nat with (S (S (j + k))) by lia; apply computed_minus; [lia | |];
      apply (computed_mult j k (-152) (-152)); auto; lia. }
  pose proof (Hcross _ _ _ _ _ _ _ _ Y2 W3 Y3 W2) as C1; pose proof (Hcross _ _ _ _ _ _ _ _ Y3 W1 Y1 W3) as C2;
    pose proof (Hcross _ _ _ _ _ _ _ _ Y1 W2 Y2 W1) as C3.
  assert (Hone : forall a s b t m, computed i (-152) a s (Rabs s) -> computed (j + k + 2) (-304) b t m ->
    computed (i + j + k + 3) (-456) (rnd (a * b)) (s * t) (Rabs s * m)).
  { intros a s b t m Ha Hb; replace (i + j + k + 3)%nat with (S (i + (j + k + 2))) by lia.
    apply (computed_mult _ _ (-152) (-304)); auto; lia. }
  replace (i + j + k + 5)%nat with (S (S (i + j + k + 3))) by lia; unfold dot_fl, dot, triple_size.
  apply computed_plus; [lia | apply computed_plus; [lia | |] | apply (computed_more (i + j + k + 3)); [lia|]];
    apply Hone; assumption.
Qed.

Section Triangle.
Variables p v a b c : vec.
Hypothesis ray_fits : fit_ray p v.
Hypothesis a_ordinary : ordinary_vec a.
Hypothesis b_ordinary : ordinary_vec b.
Hypothesis c_ordinary : ordinary_vec c.

Let e1 := minus b a.
Let e2 := minus c a.
Let q := minus p a.
Let V := extent v.
Let L1 := extent e1.
Let L2 := extent e2.
Let Q := extent q.
Notation e1_fl := (minus_fl b a).
Notation e2_fl := (minus_fl c a).
Notation q_fl := (minus_fl p a).
Notation V_fl := (extent_fl v).

Definition det : R := dot e1 (cross v e2).
Definition ab : R := dot v (cross q e1).
Definition ca : R := dot q (cross v e2).
Definition crossing : R := dot e2 (cross q e1).
Definition det_fl : R := dot_fl e1_fl (cross_fl v e2_fl).
Definition ab_fl : R := dot_fl v (cross_fl q_fl e1_fl).
Definition ca_fl : R := dot_fl q_fl (cross_fl v e2_fl).
Definition bc_fl : R := rnd (rnd (det_fl - ca_fl) - ab_fl).
Definition crossing_fl : R := dot_fl e2_fl (cross_fl q_fl e1_fl).
Definition turn_fl (x : R) : R := if Rlt_bool det_fl 0 then - x else x.
Definition least (x y : R) : R := if Rlt_bool x y then x else y.

Definition B_error : R := rnd (rnd (rnd (bpow radix2 (-50) * V_fl) * extent_fl e1_fl) * extent_fl e2_fl).
Definition C_error : R := rnd (rnd (rnd (bpow radix2 (-49) * extent_fl q_fl) * extent_fl e1_fl) * extent_fl e2_fl).
Definition margin_error : R := rnd (rnd ((9 * bpow radix2 (-52)) * V_fl) *
  rnd (rnd (extent_fl e1_fl * extent_fl e2_fl) + rnd (extent_fl q_fl * rnd (extent_fl e1_fl + extent_fl e2_fl)))).
Let f := Formas.triangulo p v V_fl a b c.

Local Opaque round.
Theorem recorded : Formas.B f = rnd (det_fl * (- bpow radix2 (-1))) /\ Formas.C f = crossing_fl /\
  Formas.B_error f = B_error /\ Formas.C_error f = C_error /\
  Formas.margin f = least (least (turn_fl ab_fl) (turn_fl bc_fl)) (turn_fl ca_fl) /\ Formas.margin_error f = margin_error.
Proof. (* compared by Qed, once, with rounding folded *)
  repeat apply conj; match goal with |- _ = ?b => exact_no_check (eq_refl b) end.
Qed.
Local Transparent round.

Let HV : 0 < V := V_positive v (v_not_zero ray_fits).
Let H1 : 0 <= L1 := extent_nonneg e1.
Let H2 : 0 <= L2 := extent_nonneg e2.
Let HQ : 0 <= Q := extent_nonneg q.

Lemma L1_computed : computed 3 (-152) (extent_fl e1_fl) L1 L1. Proof.
  exact (proj1 (extent_of_difference b a b_ordinary a_ordinary)). Qed.
Lemma L2_computed : computed 3 (-152) (extent_fl e2_fl) L2 L2. Proof.
  exact (proj1 (extent_of_difference c a c_ordinary a_ordinary)). Qed.
Lemma Q_computed : computed 3 (-152) (extent_fl q_fl) Q Q. Proof.
  exact (proj1 (extent_of_difference p a (p_ordinary ray_fits) a_ordinary)). Qed.
Lemma V_fl_computed : computed 2 (-152) V_fl V V. Proof. exact (V_computed v (v_ordinary ray_fits)). Qed.

Lemma constant_computed m k : (-1074 <= k)%Z -> format (IZR m * bpow radix2 k) -> (0 <= m)%Z ->
  computed 0 k (IZR m * bpow radix2 k) (IZR m * bpow radix2 k) (IZR m * bpow radix2 k).
Proof.
  intros Hk F Hm; rewrite <- (Rabs_pos_eq (IZR m * bpow radix2 k)) at 3.
  - apply computed_exact; [exact F | now exists m].
  - apply Rmult_le_pos; [now apply IZR_le | apply bpow_ge_0].
Qed.

Lemma power_computed k : (-1074 <= k)%Z -> computed 0 k (bpow radix2 k) (bpow radix2 k) (bpow radix2 k).
Proof.
  intros Hk; replace (bpow radix2 k) with (1 * bpow radix2 k) by ring; apply constant_computed; [exact Hk | | lia].
  rewrite Rmult_1_l; now apply format_bpow.
Qed.

(** A product of bounds is what it should be, up to a millionth. *)
Lemma bound_low n k m x : (n <= 64)%nat -> computed n k m x x -> 999999 / 1000000 * x <= m /\ (m = 0 -> x = 0) /\
  (m <> 0 -> bpow radix2 k <= m).
Proof.
  intros Hn Hc; pose proof (computed_error_near n _ _ _ _ Hn Hc) as He; pose proof u_bounds as Hu.
  destruct Hc as ((_ & Hm) & _ & G); pose proof (Rabs_pos x) as Hx.
  assert (Hn64 : INR n <= 64) by (replace 64 with (INR 64) by (simpl; lra); now apply le_INR).
  assert (Hx0 : 0 <= x) by lra; assert (Hux : 0 <= u * x <= / 1000000000000 * x) by (split;
    [apply Rmult_le_pos | apply Rmult_le_compat_r]; lra).
  assert (Hk : 1001 / 1000 * INR n * u * x <= 1001 / 1000 * 64 * (u * x)).
  { replace (1001 / 1000 * INR n * u * x) with (1001 / 1000 * INR n * (u * x)) by ring; apply Rmult_le_compat_r; lra. }
  apply Rabs_le_inv in He; split; [lra|]; split; [intros Z0; lra|]; intros N.
  pose proof (grid_at_least _ _ G N) as Hl; rewrite Rabs_pos_eq in Hl by lra; exact Hl.
Qed.

Lemma B_error_low : 799 / 100 * (u * (V * (L1 * L2))) <= B_error /\ (B_error = 0 -> V * (L1 * L2) = 0) /\
  (B_error <> 0 -> bpow radix2 (-506) <= B_error).
Proof.
  pose proof (computed_mult 3 3 (-202) (-152) _ _ _ _ _ _ ltac:(lia) (computed_mult 0 2 (-50) (-152) _ _ _ _ _ _ ltac:(lia)
    (power_computed (-50) ltac:(lia)) V_fl_computed) L1_computed) as Hc.
  pose proof (computed_mult 7 3 (-354) (-152) _ _ _ _ _ _ ltac:(lia) Hc L2_computed) as Hm;
    destruct (bound_low 11 _ _ _ ltac:(lia) Hm) as (Hl & Hz & Hn).
  fold B_error in Hl, Hz, Hn; replace (bpow radix2 (-50)) with (8 * u) in Hl, Hz by (replace 8 with (bpow radix2 3) by reflexivity;
    now rewrite <- bpow_plus).
  assert (0 <= u * (V * (L1 * L2))) by (pose proof u_bounds; repeat apply Rmult_le_pos; lra); pose proof u_bounds.
  split; [lra|]; split; [|exact Hn]; intros Z0; specialize (Hz Z0); apply Rmult_eq_reg_l with (8 * u); lra.
Qed.

Lemma C_error_low : 159 / 10 * (u * (Q * (L1 * L2))) <= C_error /\ (C_error = 0 -> Q * (L1 * L2) = 0) /\
  (C_error <> 0 -> bpow radix2 (-505) <= C_error).
Proof.
  pose proof (computed_mult 4 3 (-201) (-152) _ _ _ _ _ _ ltac:(lia) (computed_mult 0 3 (-49) (-152) _ _ _ _ _ _ ltac:(lia)
    (power_computed (-49) ltac:(lia)) Q_computed) L1_computed) as Hc.
  pose proof (computed_mult 8 3 (-353) (-152) _ _ _ _ _ _ ltac:(lia) Hc L2_computed) as Hm;
    destruct (bound_low 12 _ _ _ ltac:(lia) Hm) as (Hl & Hz & Hn).
  fold C_error in Hl, Hz, Hn; pose proof u_bounds.
  replace (bpow radix2 (-49)) with (16 * u) in Hl, Hz by (replace 16 with (bpow radix2 4) by reflexivity;
    now rewrite <- bpow_plus).
  assert (H0 : 0 <= Q * (L1 * L2)) by (repeat apply Rmult_le_pos; lra);
    assert (0 <= u * (Q * (L1 * L2))) by (apply Rmult_le_pos; lra).
  split; [lra|]; split; [|exact Hn]; intros Z0; specialize (Hz Z0).
  apply Rmult_eq_reg_l with (16 * u); lra.
Qed.

Let M := L1 * L2 + Q * (L1 + L2).

Lemma margin_error_low : 179 / 10 * (u * (V * M)) <= margin_error.
Proof.
  assert (F9 : format (9 * bpow radix2 (-52))).
  { apply (generic_format_F2R radix2 _ 9 (-52)); intros _; unfold cexp, FLT_exp.
    rewrite (mag_unique_pos radix2 _ (-48)); [lia|]; unfold F2R; cbn; change (bpow radix2 (-52)) with (/ 4503599627370496);
    change (bpow radix2 (-49)) with (/ 562949953421312); change (bpow radix2 (-48)) with (/ 281474976710656); lra. }
  pose proof (computed_mult 0 2 (-52) (-152) _ _ _ _ _ _ ltac:(lia) (constant_computed 9 (-52) ltac:(lia) F9 ltac:(lia))
    V_fl_computed) as HU.
  pose proof (computed_mult 3 3 (-152) (-152) _ _ _ _ _ _ ltac:(lia) L1_computed L2_computed) as HLL.
  pose proof (computed_plus 3 (-152) _ _ _ _ _ _ ltac:(lia) L1_computed L2_computed) as HL.
  pose proof (computed_mult 3 4 (-152) (-152) _ _ _ _ _ _ ltac:(lia) Q_computed HL) as HQL.
  pose proof (computed_plus 8 (-304) _ _ _ _ _ _ ltac:(lia) (computed_more 7 8 _ _ _ _ ltac:(lia) HLL) HQL) as HM.
  pose proof (computed_mult 3 9 (-204) (-304) _ _ _ _ _ _ ltac:(lia) HU HM) as Hm;
    destruct (bound_low 13 _ _ _ ltac:(lia) Hm) as [Hl _].
  fold margin_error M in Hl; replace (9 * bpow radix2 (-52)) with (18 * u) in Hl
    by (replace (bpow radix2 (-52)) with (2 * u); [ring | replace 2 with (bpow radix2 1) by reflexivity;
      now rewrite <- bpow_plus]).
  assert (0 <= M) by (unfold M; pose proof (Rmult_le_pos _ _ H1 H2); pose proof (Rmult_le_pos Q (L1 + L2) HQ ltac:(lra));
    lra).
  assert (0 <= u * (V * M)) by (pose proof u_bounds; repeat apply Rmult_le_pos; lra); lra.
Qed.

Lemma det_computed : computed 7 (-456) det_fl det (triple_size e1 v e2).
Proof. exact (triple_computed 1 0 1 _ _ _ _ _ _ (q_close b a b_ordinary a_ordinary) (v_close v (v_ordinary ray_fits))
  (q_close c a c_ordinary a_ordinary)). Qed.
Lemma ab_computed : computed 7 (-456) ab_fl ab (triple_size v q e1).
Proof. exact (triple_computed 0 1 1 _ _ _ _ _ _ (v_close v (v_ordinary ray_fits)) (q_close p a (p_ordinary ray_fits) a_ordinary)
  (q_close b a b_ordinary a_ordinary)). Qed.
Lemma ca_computed : computed 7 (-456) ca_fl ca (triple_size q v e2).
Proof. exact (triple_computed 1 0 1 _ _ _ _ _ _ (q_close p a (p_ordinary ray_fits) a_ordinary) (v_close v (v_ordinary ray_fits))
  (q_close c a c_ordinary a_ordinary)). Qed.
Lemma crossing_computed : computed 8 (-456) crossing_fl crossing (triple_size e2 q e1).
Proof. exact (triple_computed 1 1 1 _ _ _ _ _ _ (q_close c a c_ordinary a_ordinary) (q_close p a
  (p_ordinary ray_fits) a_ordinary) (q_close b a b_ordinary a_ordinary)). Qed.
Lemma bc_computed : computed 9 (-456) bc_fl (det - ca - ab) (triple_size e1 v e2 + triple_size q v e2 + triple_size v q e1).
Proof.
  apply (computed_minus 8); [lia | |]; [|apply (computed_more 7); [lia | exact ab_computed]].
  apply (computed_minus 7); [lia | exact det_computed | exact ca_computed].
Qed.

Theorem triangle_sound : sound_flat f (- det / 2) crossing.
Proof.
  destruct recorded as (EB & EC & EBe & ECe & _); pose proof u_bounds as Hu; destruct B_error_low as (LB & ZB & NB),
    C_error_low as (LC & ZC & NC).
  pose proof (triple_size_le e1 v e2 : _ <= L1 * (V * L2)) as S1;
    pose proof (triple_size_le e2 q e1 : _ <= L2 * (Q * L1)) as S2.
  assert (Hh : computed 8 (-457) (rnd (det_fl * - bpow radix2 (-1))) (- det * / 2) (triple_size e1 v e2 * / 2)).
  { replace (det_fl * - bpow radix2 (-1)) with (- det_fl * bpow radix2 (-1)) by ring.
    replace (/ 2) with (bpow radix2 (-1)) by reflexivity; apply (computed_mult 7 0 (-456) (-1));
      [lia | apply computed_opp, det_computed|].
    apply power_computed; lia. }
  assert (HVL : 0 <= V * (L1 * L2)) by (repeat apply Rmult_le_pos; lra);
    assert (HQL : 0 <= Q * (L1 * L2)) by (repeat apply Rmult_le_pos; lra).
  pose proof (computed_size 8 _ _ _ _ ltac:(lia) Hh) as Hs.
  constructor; rewrite ?EB, ?EC, ?EBe, ?ECe.
  - pose proof (computed_error_near 8 _ _ _ _ ltac:(lia) Hh) as He; simpl INR in He.
    assert (u * triple_size e1 v e2 <= u * (L1 * (V * L2))) by (apply Rmult_le_compat_l; lra).
    assert (0 <= u * (V * (L1 * L2))) by (apply Rmult_le_pos; lra).
    apply Rle_trans with (2 := LB); unfold Rdiv; apply Rle_trans with (1 := He); lra.
  - pose proof (computed_error_near 8 _ _ _ _ ltac:(lia) crossing_computed) as He; simpl INR in He.
    assert (u * triple_size e2 q e1 <= u * (L2 * (Q * L1))) by (apply Rmult_le_compat_l; lra).
    assert (0 <= u * (Q * (L1 * L2))) by (apply Rmult_le_pos; lra).
    apply Rle_trans with (2 := LC); apply Rle_trans with (1 := He); lra.
  - repeat split; apply format_rnd.
  - split; [reflexivity | split; [reflexivity|]].
    destruct (Req_dec B_error 0) as [Z0|N]; [left | right; apply Rle_trans with (2 := NB N), bpow_le; lia].
    specialize (ZB Z0); set (half := rnd (det_fl * - bpow radix2 (-1))) in *; pose proof (Rabs_pos half).
    destruct (Req_dec half 0) as [|N]; [assumption | pose proof (Rabs_pos_lt _ N); lra].
  - destruct (Req_dec C_error 0) as [Z0|N]; [left | right].
    + split; [exact Z0|]; specialize (ZC Z0); pose proof (computed_size 8 _ _ _ _ ltac:(lia) crossing_computed) as Hsc.
      pose proof (Rabs_pos crossing_fl); assert (Hz : Rabs crossing_fl <= 0) by lra; apply Rabs_le_inv in Hz; lra.
    + specialize (NC N); split; [apply Rle_trans with (2 := NC), bpow_le; lia|]; apply Rle_trans with (2 := NC).
      rewrite Rabs_mult, (Rabs_pos_eq 2) by lra.
      pose proof (V_size v (v_ordinary ray_fits) : V <= _) as V102; pose proof (proj2 (extent_of_difference b a b_ordinary
        a_ordinary) : L1 <= _) as L103.
      pose proof (proj2 (extent_of_difference c a c_ordinary a_ordinary) : L2 <= _) as L103'.
      assert (Hprod : L1 * (V * L2) <= bpow radix2 308).
      { change 308%Z with (103 + (102 + 103))%Z; rewrite !bpow_plus; repeat apply Rmult_le_compat;
        try apply Rmult_le_pos; lra. }
      apply Rle_trans with (bpow radix2 (-900) * (2 * bpow radix2 308)).
      * apply Rmult_le_compat_l; [apply bpow_ge_0 | lra].
      * replace 2 with (bpow radix2 1) by reflexivity; rewrite <- !bpow_plus; apply bpow_le; lia.
Qed.

(** ** The margin *)

Definition turned (x : R) : R := if Rlt_bool det_fl 0 then - x else x.
Definition margin : R := Rmin (Rmin (turned ab) (turned (det - ca - ab))) (turned ca).

Lemma least_near x x_fl y y_fl e : Rabs (x_fl - x) <= e -> Rabs (y_fl - y) <= e -> Rabs (least x_fl y_fl - Rmin x y) <= e.
Proof.
  intros Hx Hy; apply Rabs_le_inv in Hx, Hy; unfold least, Rmin; apply Rabs_le.
  destruct (Rlt_bool_spec x_fl y_fl), (Rle_dec x y); lra.
Qed.

Lemma turn_near x x_fl e : Rabs (x_fl - x) <= e -> Rabs (turn_fl x_fl - turned x) <= e.
Proof.
  unfold turn_fl, turned; destruct (Rlt_bool det_fl 0); [|trivial]; replace (- x_fl - - x) with (- (x_fl - x)) by ring.
  now rewrite Rabs_Ropp.
Qed.

Theorem margin_near : Rabs (Formas.margin f - margin) <= Formas.margin_error f.
Proof.
  destruct recorded as (_ & _ & _ & _ & -> & ->); pose proof u_bounds as Hu; pose proof margin_error_low as LM.
  pose proof (triple_size_le e1 v e2 : _ <= L1 * (V * L2)) as S1;
    pose proof (triple_size_le q v e2 : _ <= Q * (V * L2)) as S2.
  pose proof (triple_size_le v q e1 : _ <= V * (Q * L1)) as S3.
  assert (HVL : 0 <= V * (L1 * L2)) by (repeat apply Rmult_le_pos; lra);
    assert (HVQ2 : 0 <= V * (Q * L2)) by (repeat apply Rmult_le_pos; lra).
  assert (HVQ1 : 0 <= V * (Q * L1)) by (repeat apply Rmult_le_pos; lra).
  assert (EM : V * M = V * (L1 * L2) + V * (Q * L1) + V * (Q * L2)) by (unfold M; ring).
  assert (Hone : forall n x_fl x s, (n <= 9)%nat -> computed n (-456) x_fl x s -> s <= V * M -> Rabs (x_fl - x) <=
    margin_error).
  { intros n x_fl x s Hn Hc Hs; pose proof (computed_error_near 9 _ _ _ _ ltac:(lia) (computed_more n 9 _ _ _ _ Hn Hc))
    as He.
    simpl INR in He; apply Rle_trans with (1 := He); apply Rle_trans with (2 := LM).
    assert (u * s <= u * (V * M)) by (apply Rmult_le_compat_l; lra); assert (0 <= u * (V * M)) by (apply Rmult_le_pos;
      lra); lra. }
  apply least_near; [apply least_near|]; apply turn_near.
  - apply (Hone 7%nat _ _ _ ltac:(lia) ab_computed); lra.
  - apply (Hone 9%nat _ _ _ ltac:(lia) bc_computed); lra.
  - apply (Hone 7%nat _ _ _ ltac:(lia) ca_computed); lra.
Qed.

(** Where det is known to be positive or negative, the margin has the signs of the three products times det. *)
Lemma margin_tells : flat_known f = true ->
  det <> 0 /\ (0 <= margin <-> 0 <= ab * det /\ 0 <= (det - ca - ab) * det /\ 0 <= ca * det).
Proof.
  intros K; destruct (known_means f _ _ triangle_sound K) as [Hbig HB]; destruct recorded as (EB & _ & EBe & _).
  pose proof (flat_B_near f _ _ triangle_sound) as NB; split; [lra|]; rewrite EB in Hbig, NB.
  assert (Hsign : forall x y, 0 < y -> (0 <= x <-> 0 <= x * y)).
  { intros x y Hy; split; intros Hx; [apply Rmult_le_pos; lra|]; apply Rmult_le_reg_r with y; lra. }
  assert (Hmin : forall x y z, 0 <= Rmin (Rmin x y) z <-> 0 <= x /\ 0 <= y /\ 0 <= z).
  { intros x y z; unfold Rmin; destruct (Rle_dec x y), (Rle_dec _ z); lra. }
  unfold margin, turned; rewrite Hmin; pose proof (bpow_gt_0 radix2 (-1)) as Hh; set (h := bpow radix2 (-1)) in *.
  assert (Hmul : forall x, 0 <= x -> 0 <= x * h) by (intros; apply Rmult_le_pos; lra).
  destruct (Rlt_bool_spec det_fl 0) as [Hneg|Hpos].
  - assert (Hr : 0 <= rnd (det_fl * - h)) by (apply rnd_nonneg; specialize (Hmul (- det_fl) ltac:(lra)); lra).
    rewrite Rabs_pos_eq in Hbig by exact Hr; apply Rabs_le_inv in NB; assert (Hd : 0 < - det) by lra.
    rewrite (Hsign (- ab) _ Hd), (Hsign (- (det - ca - ab)) _ Hd), (Hsign (- ca) _ Hd); rewrite !Rmult_opp_opp; tauto.
  - assert (Hr : rnd (det_fl * - h) <= 0).
    { rewrite <- rnd_0; apply rnd_le; specialize (Hmul det_fl Hpos); lra. }
    rewrite (Rabs_left1 _ Hr) in Hbig; apply Rabs_le_inv in NB; assert (Hd : 0 < det) by lra.
    rewrite (Hsign ab _ Hd), (Hsign (det - ca - ab) _ Hd), (Hsign ca _ Hd); tauto.
Qed.
End Triangle.
