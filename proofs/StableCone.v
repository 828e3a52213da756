(** * StableCone: the second step on a cone

    Formas.Pairs.cono computes the parts that StableConical.v asks for as those of a truncated cone of radius 0,
      with k² s1²,
    k² g s1, k² g² and k |g a + s1 b|: so its quadratic is sound, and the decision over it right. *)
From Coq Require Import Reals ZArith Lra Lia Psatz.
From Flocq Require Import Core.
From Durero Require Import Toolkit Especificacion Puntos Trazador.
From Durero Require Conical Cone Formas.
From Durero Require Import Rounding Vectors Across Flotante Steps Twofold Sums Products Ratios Words Small Doubled Stable
  StableAdvance StableAcross StableConical.
Import Formas.Pairs.
Local Open Scope R_scope.
Local Opaque bpow.

(** ** The cone *)

Section Cone.
Variables p v centro d : vec.
Variables h k : R.
Hypothesis ray_fits : fit_ray p v.
Hypothesis axis_fits : fit_axis centro d.
Hypothesis h_ordinary : ordinary h.
Hypothesis h_positive : 0 < h.
Hypothesis k_ordinary : ordinary k.
Hypothesis k_positive : 0 < k.
Let q := minus p centro.
Let a := across v d.
Let b := across q d.
Let Q := extent q.
Let V := extent v.
Let S := size_of_dot v d.
Let G := h + size_of_dot q d.
Let W := V * (Q + h).
Notation a2 := (a2 v d).
Notation b2 := (b2 p centro d).
Notation line2 := (line2 p v centro d).
Notation g2 := (g2 p centro d h).
Notation s1_2 := (s1_2 v d).
Notation V_fl := (extent_fl v).
Notation reach_fl := (rnd (extent_fl (q_fl p centro) + h)).

Definition wall_of_cone2 : vec2 := Vec2 (sum (product g2 (dx a2)) (product s1_2 (dx b2)))
  (sum (product g2 (dy a2)) (product s1_2 (dy b2))) (sum (product g2 (dz a2)) (product s1_2 (dz b2))).
Definition height2 : twofold := product (exactly k) (norm2 wall_of_cone2).
Definition k_square2 : twofold := product (exactly k) (exactly k).

Local Opaque sum difference product ratio root_of opposite exactly two_sum.
Lemma cone_recorded2 : cono p v V_fl centro k d h =
  Formas.Quadratic (A_2 v d (product k_square2 (product s1_2 s1_2))) (B_2 p v centro d (product k_square2
    (product g2 s1_2)))
    (C_2 p centro d (product k_square2 (product g2 g2))) (difference height2 line2) (sum height2 line2)
    (A_error2 v k) (B_error2 v k reach_fl) (C_error2 k reach_fl) (s0_2 p centro d) s1_2 h reach_fl V_fl 0 0.
Proof. reflexivity. Qed.
Local Transparent sum difference product ratio root_of opposite exactly two_sum.

Lemma wall_of_cone_near2 : double_word height2 /\
  Rabs (whole height2 - norm (Conical.wall p v centro d h k 0)) <=
    262 / 10 * (uu * ((0 + k * G) * V)) + 242 / 10 * (uu * (k * S * Q)) + / 100 * (uu * W) /\
  norm (Conical.wall p v centro d h k 0) <= (0 + k * G) * V + k * S * Q.
Proof.
  pose proof (g_worded p v centro d h ray_fits axis_fits h_ordinary h_positive) as Cg; fold q in Cg;
    fold G in Cg.
  pose proof (s1_worded p v centro d ray_fits axis_fits) as C1; fold S in C1; pose proof uu_bounds as Hu.
  pose proof (worded_error 4 _ _ _ _ ltac:(lia) Cg) as Ng; simpl INR in Ng;
    pose proof (worded_error 3 _ _ _ _ ltac:(lia) C1) as N1.
  simpl INR in N1; destruct Cg as ((_ & Mg) & Wg & Gg & Gg'), C1 as ((_ & M1) & W1 & G1 & G1').
  assert (HG0 : 0 <= G) by (apply Rle_trans with (2 := Mg), Rabs_pos);
    assert (HS0 : 0 <= S) by (apply Rle_trans with (2 := M1), Rabs_pos).
  destruct (uu_part G HG0) as [HuG _], (uu_part S HS0) as [HuS _].
  destruct (combined2 p v centro d ray_fits axis_fits (401 / 100)
    (301 / 100)
    (h - dot q d) g2 (dot v d) s1_2 G S Wg) as (WN & HN & HW); auto; try lra; try (split;
      apply (grid_coarser (-456) (-304)); lia || assumption).
  fold wall_of_cone2 in WN, HN; fold q in HN, HW; fold a b in HN, HW; fold V Q in HN, HW.
  set (w := plus (scale (h - dot q d) a) (scale (dot v d) b)) in *.
  assert (EW : norm (Conical.wall p v centro d h k 0) = k * norm w).
  { replace (Conical.wall p v centro d h k 0) with (scale k w); [rewrite norm_scale, Rabs_pos_eq; lra|].
    unfold w, Conical.wall, Conical.rho, Conical.slope, plus, scale, a, b, q; cbn; f_equal; ring. }
  destruct (W_least p v centro h k ray_fits h_ordinary h_positive k_ordinary) as (_ & L1 & L2).
  fold q in L1, L2; fold V Q in L1, L2; change (V * (Q + h)) with W in L1, L2; set (y := bpow radix2 (-450)) in *.
  pose proof (bpow_gt_0 radix2 (-450) : 0 < y) as Hy0; pose proof (bpow_gt_0 radix2 (-957)) as Hz0.
  destruct (ordinary_grid k k_ordinary) as [Fk _], (exactly_word k Fk) as [Wk Ek], (product_any _ _ Wk WN) as [WH HH].
  fold height2 in WH, HH; rewrite Ek in HH; rewrite EW; set (n := whole (norm2 wall_of_cone2)) in *;
    pose proof (norm_nonneg w) as Hw0.
  pose proof (extent_nonneg v : 0 <= V) as HV0; pose proof (extent_nonneg q : 0 <= Q) as HQ0.
  assert (HGV : 0 <= G * V) by (apply Rmult_le_pos; lra); assert (HSQ : 0 <= S * Q) by (apply Rmult_le_pos; lra).
  pose proof (uu_part _ HGV) as Hm1; pose proof (uu_part _ HSQ) as Hm2; set (m1 := uu * (G * V)) in *;
    set (m2 := uu * (S * Q)) in *.
  assert (HN' : Rabs (n - norm w) <= 241 / 10 * m1 + 231 / 10 * m2 + y) by (apply Rle_trans with (1 := HN); lra).
  assert (Hn : Rabs n <= 1001 / 1000 * (G * V + S * Q) + y).
  { assert (Sw : Rabs (norm w) <= G * V + S * Q) by (now rewrite Rabs_pos_eq); pose proof (size_near _ _ _ _ HN' Sw); lra. }
  assert (Hd : Rabs (k * n - k * norm w) <= k * (241 / 10 * m1 + 231 / 10 * m2 + y)).
  { rewrite <- Rmult_minus_distr_l, Rabs_mult, (Rabs_pos_eq k) by lra; apply Rmult_le_compat_l; lra. }
  assert (Hkn : Rabs (k * n) <= k * (1001 / 1000 * (G * V + S * Q) + y)).
  { rewrite Rabs_mult, (Rabs_pos_eq k) by lra; apply Rmult_le_compat_l; lra. }
  assert (Hukn : uu * Rabs (k * n) <= uu * (k * (1001 / 1000 * (G * V + S * Q) + y))) by (apply Rmult_le_compat_l; lra).
  replace (uu * (k * (1001 / 1000 * (G * V + S * Q) + y))) with (1001 / 1000 * (k * m1 + k * m2) + uu * (k * y)) in Hukn
    by (unfold m1, m2; ring).
  assert (Hky : 0 <= k * y) by (apply Rmult_le_pos; lra); destruct (uu_part _ Hky) as [_ Huky].
  assert (Hkm1 : 0 <= k * m1) by (apply Rmult_le_pos; lra); assert (Hkm2 : 0 <= k * m2) by (apply Rmult_le_pos; lra).
  split; [exact WH | split].
  - replace (uu * ((0 + k * G) * V)) with (k * m1) by (unfold m1; ring);
    replace (uu * (k * S * Q)) with (k * m2) by (unfold m2; ring).
    apply Rabs_le_inv in HH, Hd; apply Rabs_le; lra.
  - replace ((0 + k * G) * V + k * S * Q) with (k * (G * V + S * Q)) by ring; apply Rmult_le_compat_l; lra.
Qed.

Theorem stable_cone_sound : sound2 (cono p v V_fl centro k d h) (Conical.A v d k) (Conical.B p v centro d h k 0)
  (Conical.C p centro d h k 0) (Conical.F p v centro d h k 0) (Conical.H p v centro d h k 0).
Proof.
  rewrite cone_recorded2; destruct wall_of_cone_near2 as (WH & HN & HW);
    pose proof (number_worded k k_ordinary (Rlt_le _ _ k_positive)) as Ck.
  pose proof (worded_mult 0 0 (-152) (-152) _ _ _ _ _ _ ltac:(lia) Ck Ck) as K2; fold k_square2 in K2.
  pose proof (g_worded p v centro d h ray_fits axis_fits h_ordinary h_positive) as Cg; fold q in Cg;
    fold G in Cg.
  pose proof (s1_worded p v centro d ray_fits axis_fits) as C1; fold S in C1.
  pose proof (worded_mult 1 7 (-304) (-608) _ _ _ _ _ _ ltac:(lia) K2 (worded_mult 3 3 (-304) (-304) _ _ _ _ _ _
    ltac:(lia) C1 C1)) as HA.
  pose proof (worded_mult 1 8 (-304) (-608) _ _ _ _ _ _ ltac:(lia) K2 (worded_mult 4 3 (-304) (-304) _ _ _ _ _ _
    ltac:(lia) Cg C1)) as HB.
  pose proof (worded_mult 1 9 (-304) (-608) _ _ _ _ _ _ ltac:(lia) K2 (worded_mult 4 4 (-304) (-304) _ _ _ _ _ _
    ltac:(lia) Cg Cg)) as HC.
  apply (conical_sound2 p v centro d h k 0 ray_fits axis_fits h_ordinary h_positive k_ordinary k_positive Cone.no_radius
    (Rle_refl 0) (product k_square2 (product s1_2 s1_2))
    (product k_square2 (product g2 s1_2)) (product k_square2 (product g2 g2)) height2 reach_fl); try reflexivity.
  - replace (Conical.slope v d k * Conical.slope v d k) with (k * k * (dot v d * dot v d)) by (unfold Conical.slope; ring).
    fold S; replace (k * S * (k * S)) with (k * k * (S * S)) by ring; exact HA.
  - replace (Conical.rho p centro d h k 0 * Conical.slope v d k) with (k * k * ((h - dot q d) * dot v d))
      by (unfold Conical.rho, Conical.slope, q; ring).
    fold q S G; replace ((0 + k * G) * (k * S)) with (k * k * (G * S)) by ring; apply (worded_more 10); [lia | exact HB].
  - replace (Conical.rho p centro d h k 0 * Conical.rho p centro d h k 0) with (k * k * ((h - dot q d) * (h - dot q d)))
      by (unfold Conical.rho, q; ring).
    fold q G; replace ((0 + k * G) * (0 + k * G)) with (k * k * (G * G)) by ring; apply (worded_more 11); [lia | exact HC].
  - exact WH.
  - exact HN.
  - exact HW.
  - fold q Q; replace (Q + h + 0) with (Q + h) by ring; apply (computed_more 4); [lia|].
    exact (Cone.reach_computed p v centro d h ray_fits axis_fits h_ordinary h_positive).
Qed.

(** ** What the text says *)

Notation text := (of_cono (ray_of p v) (point centro) k (direction d) h).

Theorem stable_cone_right limit : format limit ->
  right_pair (reach text) limit (first_of_curved_axial (cono p v V_fl centro k d h) limit) /\
  right_pair (reach (launched text)) limit (first_of_curved_on_axial (cono p v V_fl centro k d h) limit).
Proof.
  apply (axial_pair p v centro d h ray_fits axis_fits h_ordinary h_positive
    _ _ _ _ _ _ stable_cone_sound).
  - repeat split.
  - exact (cone_same p v centro k d h).
  - intros t; apply within_stretch.
Qed.
End Cone.

(** ** The truncated cone *)

Section Truncated.
Variables p v centro d : vec.
Variables h k r : R.
Hypothesis ray_fits : fit_ray p v.
Hypothesis axis_fits : fit_axis centro d.
Hypothesis h_ordinary : ordinary h.
Hypothesis h_positive : 0 < h.
Hypothesis k_ordinary : ordinary k.
Hypothesis k_positive : 0 < k.
Hypothesis r_ordinary : ordinary r.
Hypothesis r_positive : 0 < r.
Let q := minus p centro.
Let Q := extent q.
Let V := extent v.
Let S := size_of_dot v d.
Let G := h + size_of_dot q d.
Let P := r + k * G.
Let W := V * (Q + h).
Notation a2 := (a2 v d).
Notation b2 := (b2 p centro d).
Notation line2 := (line2 p v centro d).
Notation g2 := (g2 p centro d h).
Notation s1_2 := (s1_2 v d).
Notation V_fl := (extent_fl v).
Notation reach_fl := (rnd (extent_fl (q_fl p centro) + h)).

Definition slope2 : twofold := product (exactly k) s1_2.
Definition rho2 : twofold := sum (exactly r) (product (exactly k) g2).
Definition wall2 : vec2 := Vec2 (sum (product rho2 (dx a2)) (product slope2 (dx b2)))
  (sum (product rho2 (dy a2)) (product slope2 (dy b2))) (sum (product rho2 (dz a2)) (product slope2 (dz b2))).

Local Opaque sum difference product ratio root_of opposite exactly two_sum.
Lemma truncated_recorded2 : tronco p v V_fl centro r k d h =
  Formas.Quadratic (A_2 v d (product slope2 slope2)) (B_2 p v centro d (product rho2 slope2)) (C_2 p centro d
    (product rho2 rho2))
    (difference (norm2 wall2) line2) (sum (norm2 wall2) line2) (A_error2 v k) (B_error2 v k (rnd (reach_fl + r)))
    (C_error2 k (rnd (reach_fl + r))) (s0_2 p centro d) s1_2 h reach_fl V_fl 0 0.
Proof. reflexivity. Qed.
Local Transparent sum difference product ratio root_of opposite exactly two_sum.

Lemma slope_worded : worded 4 (-456) slope2 (Conical.slope v d k) (k * S).
Proof.
  exact (worded_mult 0 3 (-152) (-304) _ _ _ _ _ _ ltac:(lia) (number_worded k k_ordinary (Rlt_le _ _ k_positive))
    (s1_worded p v centro d ray_fits axis_fits)).
Qed.

Lemma rho_worded : worded 6 (-456) rho2 (Conical.rho p centro d h k r) P.
Proof.
  apply (worded_plus 5); [lia | |].
  - apply (worded_coarser _ _ (-152)); [lia|]; apply (worded_more 0); [lia | apply number_worded; [exact r_ordinary | lra]].
  - exact (worded_mult 0 4 (-152) (-304) _ _ _ _ _ _ ltac:(lia) (number_worded k k_ordinary (Rlt_le _ _ k_positive))
      (g_worded p v centro d h ray_fits axis_fits h_ordinary h_positive)).
Qed.

Lemma wall_of_truncated2 : double_word (norm2 wall2) /\
  Rabs (whole (norm2 wall2) - norm (Conical.wall p v centro d h k r)) <=
    262 / 10 * (uu * (P * V)) + 242 / 10 * (uu * (k * S * Q)) + / 100 * (uu * W) /\
  norm (Conical.wall p v centro d h k r) <= P * V + k * S * Q.
Proof.
  pose proof slope_worded as CS; pose proof rho_worded as CR; pose proof (worded_error 4 _ _ _ _ ltac:(lia) CS) as NS;
    simpl INR in NS.
  pose proof (worded_error 6 _ _ _ _ ltac:(lia) CR) as NR; simpl INR in NR;
    destruct CS as ((_ & MS) & WS & GS), CR as ((_ & MR) & WR & GR).
  assert (HkS : 0 <= k * S) by (apply Rle_trans with (2 := MS), Rabs_pos);
    assert (HP : 0 <= P) by (apply Rle_trans with (2 := MR), Rabs_pos).
  destruct (uu_part _ HkS) as [HuS _], (uu_part P HP) as [HuP _].
  destruct (combined2 p v centro d ray_fits axis_fits (601 / 100)
    (401 / 100)
    (Conical.rho p centro d h k r) rho2 (Conical.slope v d k) slope2 P (k * S) WR GR WS GS) as (WN & HN & HW);
      try assumption; try lra.
  fold wall2 in WN, HN; fold q in HN, HW; fold V Q in HN, HW.
  destruct (W_least p v centro h k ray_fits h_ordinary h_positive k_ordinary) as (_ & L1 & _).
  fold q in L1; fold V Q in L1; change (V * (Q + h)) with W in L1; pose proof (bpow_gt_0 radix2 (-450)) as Hy0.
  assert (0 <= k * bpow radix2 (-450)) by (apply Rmult_le_pos; lra).
  pose proof (extent_nonneg v : 0 <= V) as HV0; pose proof (extent_nonneg q : 0 <= Q) as HQ0.
  destruct (uu_part (P * V) ltac:(now apply Rmult_le_pos)) as [Hu1 _], (uu_part (k * S * Q) ltac:(now apply Rmult_le_pos))
    as [Hu2 _].
  split; [exact WN | split; [|exact HW]]; apply Rle_trans with (1 := HN); lra.
Qed.

Theorem stable_truncated_sound : sound2 (tronco p v V_fl centro r k d h) (Conical.A v d k) (Conical.B p v centro d h k r)
  (Conical.C p centro d h k r) (Conical.F p v centro d h k r) (Conical.H p v centro d h k r).
Proof.
  rewrite truncated_recorded2; destruct wall_of_truncated2 as (WN & HN & HW).
  apply (conical_sound2 p v centro d h k r ray_fits axis_fits h_ordinary h_positive k_ordinary k_positive r_ordinary (Rlt_le _
    _ r_positive) (product slope2 slope2) (product rho2 slope2)
      (product rho2 rho2)
    (norm2 wall2) (rnd (reach_fl + r))); try reflexivity.
  - exact (worded_mult 4 4 (-456) (-456) _ _ _ _ _ _ ltac:(lia) slope_worded slope_worded).
  - exact (worded_mult 6 4 (-456) (-456) _ _ _ _ _ _ ltac:(lia) rho_worded slope_worded).
  - exact (worded_mult 6 6 (-456) (-456) _ _ _ _ _ _ ltac:(lia) rho_worded rho_worded).
  - exact WN.
  - exact HN.
  - exact HW.
  - apply (computed_plus 4); [lia | exact (Cone.reach_computed p v centro d h ray_fits axis_fits h_ordinary h_positive)|].
    apply (computed_more 0); [lia | apply Cone.exact_number; [exact r_ordinary | lra]].
Qed.

(** ** What the text says *)

Notation text := (of_tronco (ray_of p v) (point centro) r k (direction d) h).

Theorem stable_truncated_right limit : format limit ->
  right_pair (reach text) limit (first_of_curved_axial (tronco p v V_fl centro r k d h) limit) /\
  right_pair (reach (launched text)) limit (first_of_curved_on_axial (tronco p v V_fl centro r k d h) limit).
Proof.
  apply (axial_pair p v centro d h ray_fits axis_fits h_ordinary h_positive
    _ _ _ _ _ _ stable_truncated_sound).
  - repeat split.
  - exact (truncated_same p v centro r k d h).
  - intros t; apply within_stretch.
Qed.
End Truncated.
