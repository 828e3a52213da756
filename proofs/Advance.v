(** * Advance: which roots lie within the stretch of an axis

    A cylinder, a cone and a truncated cone reach from advance 0 to altura along their axis; at a root t the advance is
    s0 + t·s1. trace/closed_form-inl.hpp computes it of the computed root, with a bound that pays for what the root and
    the two coefficients bring, for three roundings, and for a fourth where it computes altura - advance. Formas.place_axial
    is its decision: it is right for whatever root it is asked, and so is the test that passes over a root at infinity.

    ends f              == f has s0, s1, altura, reach and speed as axial() of quadratic-inl.hpp computes them
    on_stretch t        == t > 0, and the advance there is from 0 to altura *)
From Coq Require Import Reals ZArith Lra Lia Psatz Bool.
From Flocq Require Import Core.
From Durero Require Import Rounding Vectors Across Quotient Decision Flotante Verdict.
From Durero Require Formas.
Local Open Scope R_scope.
Local Opaque bpow.

Section Advance.
Variables p v centro d : vec.
Variable h : R.
Hypothesis ray_fits : fit_ray p v.
Hypothesis axis_fits : fit_axis centro d.
Hypothesis h_ordinary : ordinary h.
Hypothesis h_positive : 0 < h.
Notation q_fl := (q_fl p centro).
Let q := minus p centro.
Let Q := extent q.
Let V := extent v.
Let s0 := dot q d.
Let s1 := dot v d.

Variable f : Formas.quadratic R.
Notation s0_fl := (dot_fl q_fl d).
Notation s1_fl := (dot_fl v d).
Notation V_fl := (extent_fl v).
Notation reach_fl := (rnd (extent_fl q_fl + h)).
Definition ends : Prop := Formas.s0 f = s0_fl /\ Formas.s1 f = s1_fl /\ Formas.altura f = h /\ Formas.reach f = reach_fl /\
  Formas.speed f = V_fl.
Definition on_stretch (t : R) : Prop := 0 < t /\ 0 <= s0 + t * s1 <= h.

Let z := bpow radix2 (-1074).

(** ** What is computed on the way *)

Lemma HQ : 0 <= Q. Proof. apply extent_nonneg. Qed.
Lemma HV : 0 < V. Proof. exact (V_positive v (v_not_zero ray_fits)). Qed.

Lemma s0_near : Rabs (s0_fl - s0) <= 402 / 100 * (u * Q) /\ Rabs s0_fl <= 1001 / 1000 * Q.
Proof.
  pose proof (dot_computed 1 0 (-152) (-152) q_fl d q d ltac:(lia) (q_close p centro (p_ordinary ray_fits) (centro_ordinary
    axis_fits))
    (close_exact _ _ (ordinary_on_grid d (d_ordinary axis_fits)))) as Hc.
  pose proof (size_along q d Q (d_unit axis_fits) (norm_le_extent q) HQ) as Hs; pose proof u_bounds as Hu; pose proof HQ as HQ0.
  pose proof (computed_error_near 4 _ _ _ _ ltac:(lia) Hc) as He; simpl INR in He.
  assert (Hus : u * size_of_dot q d <= u * ((1 + / 1000000) * Q)) by (apply Rmult_le_compat_l; lra).
  assert (HuQ : 0 <= u * Q <= / 1000000 * Q) by (split; [apply Rmult_le_pos | apply Rmult_le_compat_r]; lra).
  assert (He' : Rabs (s0_fl - s0) <= 402 / 100 * (u * Q)) by (apply Rle_trans with (1 := He); lra).
  assert (Hs0 : Rabs s0 <= (1 + / 1000000) * Q).
  { destruct Hc as ((_ & Hm) & _); apply Rle_trans with (1 := Hm), Hs. }
  split; [exact He'|]; apply Rabs_le_inv in He', Hs0; apply Rabs_le; lra.
Qed.

Lemma s1_near : Rabs (s1_fl - s1) <= 301 / 100 * (u * V) /\ Rabs s1_fl <= 1001 / 1000 * V /\ grid (-304) s1_fl.
Proof.
  pose proof (dot_computed 0 0 (-152) (-152) v d v d ltac:(lia) (v_close v (v_ordinary ray_fits))
    (close_exact _ _ (ordinary_on_grid d (d_ordinary axis_fits)))) as Hc; pose proof HV as HV0.
  pose proof (size_along v d V (d_unit axis_fits) (norm_le_extent v) (Rlt_le _ _ HV)) as Hs; pose proof u_bounds as Hu.
  pose proof (computed_error_near 3 _ _ _ _ ltac:(lia) Hc) as He; simpl INR in He.
  assert (Hus : u * size_of_dot v d <= u * ((1 + / 1000000) * V)) by (apply Rmult_le_compat_l; lra).
  assert (HuV : 0 <= u * V <= / 1000000 * V) by (split; [apply Rmult_le_pos | apply Rmult_le_compat_r]; lra).
  assert (He' : Rabs (s1_fl - s1) <= 301 / 100 * (u * V)) by (apply Rle_trans with (1 := He); lra).
  assert (Hs1 : Rabs s1 <= (1 + / 1000000) * V).
  { destruct Hc as ((_ & Hm) & _); apply Rle_trans with (1 := Hm), Hs. }
  split; [exact He'|]; split; [apply Rabs_le_inv in He', Hs1; apply Rabs_le; lra | exact (proj2 (proj2 Hc))].
Qed.

Lemma reach_near : 999 / 1000 * (Q + h) <= reach_fl /\ 0 < reach_fl /\ format reach_fl.
Proof.
  pose proof (extent_computed 1 (-152) q_fl q ltac:(lia) (q_close p centro (p_ordinary ray_fits) (centro_ordinary axis_fits)))
    as Hc.
  destruct (ordinary_grid h h_ordinary) as [Fh Gh]; pose proof (computed_exact (-152) h Fh Gh) as Hh.
  rewrite (Rabs_pos_eq h) in Hh by lra.
  pose proof (computed_plus 3 (-152) _ _ _ _ _ _ ltac:(lia) Hc (computed_more 0 3 _ _ _ _ ltac:(lia) Hh)) as Hr.
  pose proof (computed_error_near 4 _ _ _ _ ltac:(lia) Hr) as He; simpl INR in He; fold Q in He; pose proof HQ as HQ0.
  pose proof u_bounds as Hu; assert (u * (Q + h) <= / 1000000 * (Q + h)) by (apply Rmult_le_compat_r; lra).
  apply Rabs_le_inv in He; split; [|split; [|apply format_rnd]]; lra.
Qed.

Lemma speed_near : 999999 / 1000000 * V <= V_fl <= 1000001 / 1000000 * V.
Proof.
  pose proof (computed_error_near 2 _ _ _ _ ltac:(lia) (V_computed v (v_ordinary ray_fits))) as He; simpl INR in He;
  fold V in He.
  change (Flotante.V_fl v) with V_fl in He; pose proof HV as HV0.
  pose proof u_bounds as Hu; assert (u * V <= / 1000000000000 * V) by (apply Rmult_le_compat_r; lra).
  apply Rabs_le_inv in He; lra.
Qed.

Lemma z_small : 0 < z <= u * h.
Proof.
  split; [apply bpow_gt_0|]; pose proof (r_least h h_ordinary h_positive) as Hh.
  apply Rle_trans with (u * bpow radix2 (-100)); [unfold z; rewrite <- bpow_plus; apply bpow_le; lia|].
  apply Rmult_le_compat_l; [apply bpow_ge_0 | exact Hh].
Qed.

(** ** The bound pays *)

Definition advance_fl (t : R) : R := rnd (s0_fl + rnd (t * s1_fl)).
Definition advance_error (t e : R) : R :=
  rnd (rnd (bpow radix2 (-49) * rnd (reach_fl + rnd (rnd (Rabs t + e) * V_fl))) +
    rnd (rnd (Rabs s1_fl * (4503600077730459 * bpow radix2 (-52))) * e)).

(** The bound as it is computed with 16 units 2^j, of a rate a of the advance. *)
Definition advance_error_of (j : Z) (a t e : R) : R :=
  rnd (rnd (bpow radix2 j * rnd (reach_fl + rnd (rnd (Rabs t + e) * V_fl))) +
    rnd (rnd (a * (4503600077730459 * bpow radix2 (-52))) * e)).

Lemma error_low_of j a t e : (j <= -49)%Z -> 0 <= a -> grid (-304) a -> format t -> format e -> 0 <= e ->
  157 / 160 * (bpow radix2 j * (Q + h)) + 157 / 160 * (bpow radix2 j * ((Rabs t + e) * V)) + a * e - 4 * z <=
    advance_error_of j a t e.
Proof.
  intros Hj Ha G1 Ft Fe He; destruct reach_near as (R1 & R2 & R3), speed_near as [V1 _].
  pose proof HQ as HQ0; pose proof HV as HV0; destruct z_small as [Z0 _]; set (c := / 1000000000000) in *.
  assert (Hc : 0 < c <= / 1000000) by (unfold c; lra); set (m := bpow radix2 j).
  assert (Hm : 0 < m <= c).
  { split; [apply bpow_gt_0|]; apply Rle_trans with (bpow radix2 (-49)); [now apply bpow_le|].
    replace (bpow radix2 (-49)) with (/ 562949953421312) by reflexivity; unfold c; lra. }
  set (T := Rabs t + e); pose proof (Rabs_pos t) as Ht0; assert (HT : 0 <= T) by (unfold T; lra).
  pose proof (rnd_low_sum (Rabs t) e (generic_format_abs _ _ _ Ft) Fe HT) as E1; fold c T in E1.
  assert (HTV : 0 <= T * V) by (apply Rmult_le_pos; lra).
  assert (E2 : (1 - c) * T * (999999 / 1000000 * V) <= rnd T * V_fl).
  { apply Rmult_le_compat; [apply Rmult_le_pos | | |]; lra. }
  assert (HcTV : 0 <= c * (T * V) <= / 1000000 * (T * V)) by (split; [apply Rmult_le_pos | apply Rmult_le_compat_r]; lra).
  assert (E2' : 99999 / 100000 * (T * V) <= rnd T * V_fl) by lra.
  pose proof (rnd_low_any (rnd T * V_fl) ltac:(lra)) as E3; fold c z in E3.
  assert (E3' : 9999 / 10000 * (T * V) - z <= rnd (rnd T * V_fl)).
  { assert (c * (rnd T * V_fl) <= / 1000000 * (rnd T * V_fl)) by (apply Rmult_le_compat_r; lra); lra. }
  pose proof (rnd_nonneg (rnd T * V_fl) ltac:(lra)) as N3; set (M := rnd (rnd T * V_fl)) in *.
  pose proof (rnd_low_sum reach_fl M R3 (format_rnd _) ltac:(lra)) as E4; fold c in E4.
  assert (E4' : 998 / 1000 * (Q + h + T * V) - z <= rnd (reach_fl + M)).
  { assert (c * (reach_fl + M) <= / 1000000 * (reach_fl + M)) by (apply Rmult_le_compat_r; lra); lra. }
  unfold advance_error_of; fold T M m; set (g := rnd (reach_fl + M)) in *.
  assert (N4 : 0 <= g) by (apply rnd_nonneg; lra).
  assert (Hmg : 0 <= m * g <= c * g) by (split; [apply Rmult_le_pos | apply Rmult_le_compat_r]; lra).
  pose proof (rnd_low_any (m * g) ltac:(lra)) as E5; fold c z in E5.
  assert (E5' : 158 / 160 * (m * (Q + h + T * V)) - 2 * z <= rnd (m * g)).
  { assert (m * (998 / 1000 * (Q + h + T * V) - z) <= m * g) by (apply Rmult_le_compat_l; lra).
    assert (c * (m * g) <= / 1000000 * (m * g)) by (apply Rmult_le_compat_r; lra).
    assert (m * z <= / 1000000 * z) by (apply Rmult_le_compat_r; lra).
    assert (0 <= m * (Q + h + T * V)) by (apply Rmult_le_pos; lra); lra. }
  pose proof (rnd_nonneg (m * g) ltac:(lra)) as N5; set (first := rnd (m * g)) in *.
  assert (Hw : 1 + / 16777216 <= 4503600077730459 * bpow radix2 (-52)).
  { replace (bpow radix2 (-52)) with (/ 4503599627370496) by reflexivity; lra. }
  set (w := 4503600077730459 * bpow radix2 (-52)) in *.
  assert (Haw : (1 + / 16777216) * a <= a * w) by (rewrite Rmult_comm; apply Rmult_le_compat_l; lra).
  assert (Naw : normal (a * w)).
  { destruct (Req_dec a 0) as [Z1|N1]; [left; rewrite Z1; ring|].
    pose proof (grid_at_least _ _ G1 N1) as Hl; rewrite Rabs_pos_eq in Hl by exact Ha; apply (at_least_normal (-304)); [lia|].
    rewrite Rabs_pos_eq by lra; lra. }
  pose proof (rnd_low (a * w) ltac:(lra) Naw) as E6; fold c in E6.
  assert (E6' : (1 + / 18000000) * a <= rnd (a * w)) by (unfold c in *; lra).
  assert (Hae : 0 <= a * e) by (apply Rmult_le_pos; lra).
  assert (E7 : (1 + / 18000000) * (a * e) <= rnd (a * w) * e).
  { rewrite <- Rmult_assoc; apply Rmult_le_compat_r; assumption. }
  pose proof (rnd_low_any (rnd (a * w) * e) ltac:(lra)) as E8; fold c z in E8.
  assert (E8' : (1 + / 19000000) * (a * e) - z <= rnd (rnd (a * w) * e)).
  { assert ((1 - c) * ((1 + / 18000000) * (a * e)) <= (1 - c) * (rnd (a * w) * e)) by (apply Rmult_le_compat_l; lra).
    unfold c in *; lra. }
  pose proof (rnd_nonneg (rnd (a * w) * e) ltac:(lra)) as N8; set (second := rnd (rnd (a * w) * e)) in *.
  pose proof (rnd_low_sum first second (format_rnd _) (format_rnd _) ltac:(lra)) as E9; fold c in E9.
  apply Rle_trans with (2 := E9).
  apply Rle_trans with ((1 - c) * (158 / 160 * (m * (Q + h + T * V)) - 2 * z + ((1 + / 19000000) * (a * e) - z)));
    [|apply Rmult_le_compat_l; lra].
  assert (0 <= m * (Q + h + T * V)) by (apply Rmult_le_pos; lra); unfold c in *; lra.
Qed.

Lemma error_low t e : format t -> format e -> 0 <= e ->
  157 / 10 * (u * (Q + h)) + 157 / 10 * (u * ((Rabs t + e) * V)) + Rabs s1_fl * e - 4 * z <= advance_error t e.
Proof.
  intros Ft Fe He; destruct s1_near as (_ & _ & G1).
  pose proof (error_low_of (-49) (Rabs s1_fl) t e ltac:(lia) (Rabs_pos _) (grid_abs _ _ G1) Ft Fe He) as H.
  replace (bpow radix2 (-49)) with (16 * u) in H by (replace 16 with (bpow radix2 4) by reflexivity; now rewrite <- bpow_plus).
  apply Rle_trans with (2 := H); lra.
Qed.

Lemma advance_near root t : Rabs (Formas.value root - t) <= Formas.error root -> format (Formas.value root) -> format (Formas.error root) ->
  let x := advance_fl (Formas.value root) in
  Rabs (x - (s0 + t * s1)) + u * Rabs (h - x) <= advance_error (Formas.value root) (Formas.error root) /\ format x.
Proof.
  destruct root as [t_fl e]; cbn [Formas.value Formas.error]; intros N Ft Fe; cbv zeta; split;
    [|apply format_rnd].
  assert (He : 0 <= e) by (apply Rle_trans with (2 := N), Rabs_pos); pose proof (error_low t_fl e Ft Fe He) as Hlow.
  destruct s0_near as [N0 S0], s1_near as (N1 & S1 & _), z_small as [Z0 Z1]; pose proof u_bounds as Hu;
    pose proof HQ as HQ0; pose proof HV as HV0.
  set (T := Rabs t_fl + e) in *; pose proof (Rabs_pos t_fl) as Ht0; assert (HT : 0 <= T) by (unfold T; lra).
  assert (HtT : Rabs t <= T).
  { pose proof (Rabs_triang t_fl (- (t_fl - t))) as Htr; rewrite Rabs_Ropp in Htr.
    replace (t_fl + - (t_fl - t)) with t in Htr by ring; unfold T; lra. }
  set (M := T * V) in *; assert (HM : 0 <= M) by (apply Rmult_le_pos; lra).
  set (y := t_fl * s1_fl); assert (Hy : Rabs y <= 1001 / 1000 * M).
  { unfold y; rewrite Rabs_mult; apply Rle_trans with (T * (1001 / 1000 * V)); [|unfold M; lra].
    apply Rmult_le_compat; auto using Rabs_pos; unfold T; lra. }
  assert (Hyt : Rabs (y - t * s1) <= Rabs s1_fl * e + 301 / 100 * (u * M)).
  { replace (y - t * s1) with ((t_fl - t) * s1_fl + t * (s1_fl - s1)) by (unfold y; ring).
    apply Rle_trans with (1 := Rabs_triang _ _); rewrite !Rabs_mult.
    assert (Rabs (t_fl - t) * Rabs s1_fl <= e * Rabs s1_fl) by (apply Rmult_le_compat_r; [apply Rabs_pos | exact N]).
    assert (Rabs t * Rabs (s1_fl - s1) <= T * (301 / 100 * (u * V))) by (apply Rmult_le_compat; auto using Rabs_pos).
    unfold M; lra. }
  pose proof (rnd_any y) as Hr; fold z in Hr; set (P := rnd y) in *.
  assert (Huy : u * Rabs y <= u * (1001 / 1000 * M)) by (apply Rmult_le_compat_l; lra).
  assert (HuM : 0 <= u * M <= / 1000000 * M) by (split; [apply Rmult_le_pos | apply Rmult_le_compat_r]; lra).
  assert (HuQ : 0 <= u * Q <= / 1000000 * Q) by (split; [apply Rmult_le_pos | apply Rmult_le_compat_r]; lra).
  assert (Huh : 0 <= u * h) by (apply Rmult_le_pos; lra).
  assert (Huz : u * z <= / 1000000 * z) by (apply Rmult_le_compat_r; lra).
  assert (HP : Rabs P <= 1002 / 1000 * M + z) by (apply Rabs_le_inv in Hr, Hy; apply Rabs_le; lra).
  pose proof (rnd_plus s0_fl P (format_rnd _) (format_rnd _)) as Hs.
  change (rnd (s0_fl + P)) with (advance_fl t_fl) in Hs; set (x := advance_fl t_fl) in *.
  assert (Hsum : Rabs (s0_fl + P) <= 1001 / 1000 * Q + (1002 / 1000 * M + z)).
  { apply Rle_trans with (1 := Rabs_triang _ _); lra. }
  assert (Hus : u * Rabs (s0_fl + P) <= u * (1001 / 1000 * Q + (1002 / 1000 * M + z))) by (apply Rmult_le_compat_l; lra).
  assert (Hx : Rabs x <= 1002 / 1000 * Q + 1003 / 1000 * M + 2 * z).
  { apply Rabs_le_inv in Hs, Hsum; apply Rabs_le; lra. }
  assert (Hhx : Rabs (h - x) <= h + (1002 / 1000 * Q + 1003 / 1000 * M + 2 * z)).
  { unfold Rminus; apply Rle_trans with (1 := Rabs_triang _ _); rewrite Rabs_Ropp, (Rabs_pos_eq h) by lra; lra. }
  assert (Huhx : u * Rabs (h - x) <= u * (h + (1002 / 1000 * Q + 1003 / 1000 * M + 2 * z))) by (apply Rmult_le_compat_l;
    lra).
  assert (Hall : Rabs (x - (s0 + t * s1)) <= Rabs s1_fl * e + 61 / 10 * (u * Q) + 61 / 10 * (u * M) + 2 * z).
  { apply Rabs_le_inv in Hs, Hr, Hyt, N0; apply Rabs_le; lra. }
  unfold M in *; lra.
Qed.

Theorem axial_places : ends -> places on_stretch (Formas.place_axial f).
Proof.
  intros (E0 & E1 & Eh & Er & Es) root t N Ft Fe _; unfold Formas.place_axial; rewrite E0, E1, Eh, Er, Es.
  destruct (advance_near root t N Ft Fe) as [Hx Fx]; cbv zeta in Hx, Fx; cbn [Formas.outside Formas.inside].
  change (rnd (s0_fl + rnd (Formas.value root * s1_fl))) with (advance_fl (Formas.value root)).
  set (x := advance_fl (Formas.value root)) in *; fold (advance_error (Formas.value root) (Formas.error root)).
  set (e := advance_error (Formas.value root) (Formas.error root)) in *.
  destruct (ordinary_grid h h_ordinary) as [Fh _].
  pose proof (rnd_plus h (- x) Fh (generic_format_opp _ _ _ Fx)) as Hr; fold (h - x) in Hr; set (rest := rnd (h - x)) in *.
  pose proof (Rabs_pos (h - x)); pose proof u_bounds; assert (0 <= u * Rabs (h - x)) by (apply Rmult_le_pos; lra).
  assert (Hs : Rabs (x - (s0 + t * s1)) <= e) by lra; assert (Hh : Rabs (rest - (h - (s0 + t * s1))) <= e).
  { replace (rest - (h - (s0 + t * s1))) with ((rest - (h - x)) + - (x - (s0 + t * s1))) by ring.
    apply Rle_trans with (1 := Rabs_triang _ _); rewrite Rabs_Ropp; lra. }
  apply Rabs_le_inv in N, Hs, Hh; unfold on_stretch; split.
  - rewrite !orb_true_iff; intros [[Ho|Ho]|Ho];
      match type of Ho with Rlt_bool ?a ?b = true => destruct (Rlt_bool_spec a b); [lra | discriminate] end.
  - rewrite !andb_true_iff; intros [[I1 I2] I3].
    destruct (Rlt_bool_spec (Formas.error root) (Formas.value root)); [|discriminate].
    destruct (Rlt_bool_spec e x); [|discriminate]; destruct (Rlt_bool_spec e rest); [lra | discriminate].
Qed.

(** ** A root at least so far away is not within the stretch *)

Lemma far_from_stretch_of j s1_hi least t : (-500 <= j <= -51)%Z -> format s1_hi ->
  Rabs s1_hi <= (1 + / 10000000) * Rabs s1 + 7 / 8 * (bpow radix2 j * V) -> 0 <= least <= Rabs t ->
  Rlt_bool (rnd (2 * reach_fl)) (rnd (least * rnd (Rabs s1_hi - rnd (bpow radix2 j * V_fl)))) = true -> ~ on_stretch t.
Proof.
  intros Hj F1 S1 [L0 Lt]; destruct reach_near as (R1 & R2 & R3); rewrite (rnd_double _ R3).
  destruct speed_near as [V1 _], z_small as [Z0 Z1]; pose proof u_bounds as Hu; pose proof HQ as HQ0; pose proof HV as HV0.
  set (m := bpow radix2 j) in *; pose proof (bpow_gt_0 radix2 j : 0 < m) as Hm.
  assert (HmV : m * (999999 / 1000000 * V) <= m * V_fl) by (apply Rmult_le_compat_l; lra).
  assert (HmVV : 0 < m * V) by (apply Rmult_lt_0_compat; lra).
  assert (Huh : 0 <= u * h <= / 1000000 * h) by (split; [apply Rmult_le_pos | apply Rmult_le_compat_r]; lra).
  set (w := rnd (m * V_fl)); assert (Hw : 37 / 40 * (m * V) <= w).
  { assert (Hn : normal (m * V_fl)).
    { destruct (V_computed v (v_ordinary ray_fits)) as (_ & _ & G); change (Flotante.V_fl v) with V_fl in G.
      apply (grid_normal (j + -152)); [lia | apply grid_mult; [exists 1%Z; unfold m; ring | exact G]]. }
    pose proof (rnd_low (m * V_fl) ltac:(lra) Hn) as Hl; fold w in Hl; lra. }
  set (rate := rnd (Rabs s1_hi - w)).
  intros Hlt; destruct (Rlt_bool_spec (2 * reach_fl) (rnd (least * rate))) as [Hfar|]; [clear Hlt | discriminate].
  assert (Hrate : rate <= (1 + / 1000000) * Rabs s1).
  { pose proof (rnd_plus (Rabs s1_hi) (- w) (generic_format_abs _ _ _ F1) (generic_format_opp _ _ _ (format_rnd _))) as Hr.
    fold (Rabs s1_hi - w) in Hr; fold rate in Hr.
    pose proof (Rabs_pos s1); destruct (Rle_lt_dec (Rabs s1_hi - w) 0) as [Hneg|Hpos].
    - apply rnd_le in Hneg; rewrite rnd_0 in Hneg; fold rate in Hneg; lra.
    - rewrite (Rabs_pos_eq (Rabs s1_hi - w)) in Hr by lra; apply Rabs_le_inv in Hr.
      assert (u * (Rabs s1_hi - w) <= / 10000000 * (Rabs s1_hi - w)) by (apply Rmult_le_compat_r; lra); lra. }
  assert (Hprod : least * rate <= (1 + / 1000000) * Rabs (t * s1)).
  { rewrite Rabs_mult; apply Rle_trans with (least * ((1 + / 1000000) * Rabs s1)); [apply Rmult_le_compat_l; assumption|].
    replace ((1 + / 1000000) * (Rabs t * Rabs s1)) with (Rabs t * ((1 + / 1000000) * Rabs s1)) by ring.
    apply Rmult_le_compat_r; [pose proof (Rabs_pos s1) | exact Lt]; lra. }
  assert (Hbig : 199 / 100 * (Q + h) <= Rabs (t * s1)).
  { pose proof (rnd_any (least * rate)) as Hr; fold z in Hr; apply Rabs_le_inv in Hr.
    assert (Hpos : 0 < least * rate).
    { apply Rnot_le_lt; intros Hle; apply rnd_le in Hle; rewrite rnd_0 in Hle; lra. }
    rewrite (Rabs_pos_eq (least * rate)) in Hr by lra.
    assert (u * (least * rate) <= / 1000000 * (least * rate)) by (apply Rmult_le_compat_r; lra); lra. }
  assert (Hs0 : Rabs s0 <= 1002 / 1000 * Q).
  { pose proof (dot_le q d) as Hd; pose proof (norm_of_unit d (d_unit axis_fits)) as Nd;
  pose proof (norm_le_extent q : _ <= Q) as Nq.
    pose proof (Rmult_le_compat _ _ _ _ (norm_nonneg q) (norm_nonneg d) Nq Nd); unfold s0; lra. }
  unfold on_stretch; intros [_ [A1 A2]]; apply Rabs_le_inv in Hs0.
  unfold Rabs in Hbig; destruct (Rcase_abs (t * s1)); lra.
Qed.

Lemma far_from_stretch least t : ends -> 0 <= least <= Rabs t ->
  Rlt_bool (rnd (2 * Formas.reach f)) (rnd (least * rnd (Rabs (Formas.s1 f) - rnd (bpow radix2 (-51) * Formas.speed
    f)))) = true ->
  ~ on_stretch t.
Proof.
  intros (E0 & E1 & Eh & Er & Es) Hleast; rewrite E1, Er, Es; apply (far_from_stretch_of (-51)); auto; [lia | apply format_rnd|].
  destruct s1_near as (N1 & _ & _); pose proof HV as HV0; pose proof u_bounds as Hu; pose proof (Rabs_pos s1).
  replace (bpow radix2 (-51)) with (4 * u) by (replace 4 with (bpow radix2 2) by reflexivity; now rewrite <- bpow_plus).
  pose proof (Rmult_le_pos u V ltac:(lra) ltac:(lra)); pose proof (Rabs_triang s1 (s1_fl - s1)) as Htr.
  replace (s1 + (s1_fl - s1)) with s1_fl in Htr by ring; lra.
Qed.

Lemma past_stretch_right A B C F H limit : sound f A B C F H -> ends -> Formas.B_error f < Formas.F f ->
  2 * Formas.error (Formas.q (total f)) < Rabs (Formas.value (Formas.q (total f))) -> forall only,
  past_stretch f limit only = Formas.Undecided \/
  past_stretch f limit only = only /\ forall t, A * t = q_exact f A B C -> on_stretch t -> limit < t.
Proof.
  intros S E HF Hq only; unfold past_stretch; pose proof (fun t => least_of_A_right f A B C F H S t HF Hq) as Hleast.
  destruct (Rlt_bool_spec limit (least_of_A f)) as [Hl|_].
  - right; split; [reflexivity|]; intros t Ht [Ht0 _]; destruct (Hleast t Ht) as [_ Hle];
    rewrite Rabs_pos_eq in Hle by lra; lra.
  - match goal with |- context [if ?b then _ else _] => destruct b eqn:Hfar end; [right | now left].
    split; [reflexivity|]; intros t Ht On; elim (far_from_stretch (least_of_A f) t E (Hleast t Ht) Hfar On).
Qed.

End Advance.
