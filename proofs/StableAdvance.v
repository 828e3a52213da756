(** * StableAdvance: the second step within the stretch of an axis

    Advance.v over pairs: the advance s0 + t·s1 along the axis at a computed root, with the bound of 16 units that pays for
    it, tells which roots lie on a cylinder, a cone or a truncated cone; and a root that is so far away that the advance
    there has left the stretch is none. With Stable.v, the decision on whatever quadratic is within its bounds.

    ends2 f == f has s0, s1, altura, reach and speed as axial() of quadratic-inl.hpp computes them of pairs
    past_stretch, … == the decision's terms, as Stable.single asks for them *)
From Coq Require Import Reals ZArith Lra Lia Psatz Bool.
From Flocq Require Import Core.
From Durero Require Import Toolkit Especificacion Puntos Trazador.
From Durero Require Import Rounding Vectors Across Quotient Flotante Advance Steps Twofold Sums Products Ratios Words Small
  Doubled Stable StableVectors.
From Durero Require Formas.
Import Formas.Pairs.
Local Open Scope R_scope.
Local Opaque bpow.

Section Advance.
Variables p v centro d : vec.
Variable h : R.
Hypothesis ray_fits : fit_ray p v.
Hypothesis axis_fits : fit_axis centro d.
Hypothesis h_ordinary : ordinary h.
Hypothesis h_positive : 0 < h.
Let q := minus p centro.
Let Q := extent q.
Let V := extent v.
Let s0 := dot q d.
Let s1 := dot v d.
Definition s0_2 : twofold := dot2 (minus2 p centro) (exactly2 d).
Definition s1_2 : twofold := dot2 (exactly2 v) (exactly2 d).
Notation V_fl := (extent_fl v).
Notation reach_fl := (rnd (extent_fl (q_fl p centro) + h)).
Notation on_stretch := (on_stretch p v centro d h).

Variable f : Formas.quadratic twofold.
Definition ends2 : Prop := Formas.s0 f = s0_2 /\ Formas.s1 f = s1_2 /\ Formas.altura f = h /\ Formas.reach f = reach_fl /\
  Formas.speed f = V_fl.

Let HQ : 0 <= Q := extent_nonneg q.
Let HV : 0 < V := V_positive v (v_not_zero ray_fits).

Lemma s0_worded : worded 3 (-304) s0_2 s0 (size_of_dot q d).
Proof. exact (worded_along d _ _ (d_ordinary axis_fits) (words_between p centro (p_ordinary ray_fits) (centro_ordinary
  axis_fits))). Qed.
Lemma s1_worded : worded 3 (-304) s1_2 s1 (size_of_dot v d).
Proof. exact (worded_along d _ _ (d_ordinary axis_fits) (words_of v (v_ordinary ray_fits))). Qed.

Lemma near_along x w y X : worded 3 (-304) w y (size_of_dot x d) -> norm x <= X -> 0 <= X ->
  Rabs (whole w - y) <= 302 / 100 * (uu * X) /\ Rabs y <= 1000001 / 1000000 * X /\ Rabs (whole w) <= 1001 / 1000 * X.
Proof.
  intros Hw Hx HX; pose proof (size_along x d X (d_unit axis_fits) Hx HX) as Hs; pose proof uu_bounds as Hu.
  pose proof (worded_error 3 _ _ _ _ ltac:(lia) Hw) as He; simpl INR in He; destruct Hw as ((_ & Hm) & _).
  assert (Hus : uu * size_of_dot x d <= uu * ((1 + / 1000000) * X)) by (apply Rmult_le_compat_l; lra).
  assert (HuX : 0 <= uu * X <= e30 * X) by (split; [apply Rmult_le_pos | apply Rmult_le_compat_r]; lra).
  assert (He' : Rabs (whole w - y) <= 302 / 100 * (uu * X)) by (apply Rle_trans with (1 := He); lra).
  split; [exact He'|]; split; [lra|]; pose proof (size_near _ _ _ _ He' Hm); lra.
Qed.

Lemma nothing_beside_h : 0 <= bpow radix2 (-957) /\ bpow radix2 (-957) + 4 * bpow radix2 (-1074) <= uu * h.
Proof.
  split; [apply bpow_ge_0|]; pose proof (r_least h h_ordinary h_positive) as Hh.
  apply Rle_trans with (uu * bpow radix2 (-100)); [|apply Rmult_le_compat_l; [apply bpow_ge_0 | exact Hh]].
  rewrite <- bpow_plus; apply Rle_trans with (8 * bpow radix2 (-957)).
  - pose proof (bpow_gt_0 radix2 (-1074)); pose proof (bpow_le radix2 (-1074) (-957) ltac:(lia)); lra.
  - replace 8 with (bpow radix2 3) by reflexivity; rewrite <- bpow_plus; apply bpow_le; lia.
Qed.

Lemma advance_near2 root t : near_word root t ->
  let x := sum s0_2 (product (Formas.value root) s1_2) in
  Rabs (whole x - (s0 + t * s1)) + uu * Rabs (h - whole x) <=
    advance_error_of p v centro h (-98) (Rabs (hi s1_2)) (hi (Formas.value root)) (Formas.error root) /\ double_word x.
Proof.
  destruct root as [tw e]; cbn [Formas.value Formas.error]; intros (N & Wt & Fe & He900);
    cbn [Formas.value Formas.error] in *.
  pose proof (bpow_gt_0 radix2 (-900)) as H900; pose proof s0_worded as C0; pose proof s1_worded as C1; cbv zeta.
  destruct (near_along q _ _ Q C0 (norm_le_extent q) HQ) as (N0 & S0 & S0').
  destruct (near_along v _ _ V C1 (norm_le_extent v) (Rlt_le _ _ HV)) as (N1 & S1 & S1').
  destruct C0 as (_ & W0 & _), C1 as (_ & W1 & G1 & _), nothing_beside_h as [Hl0 Hl].
  pose proof (error_low_of p v centro d h ray_fits axis_fits h_ordinary h_positive (-98)
    (Rabs (hi s1_2)) (hi tw) e ltac:(lia) (Rabs_pos _) (grid_abs _ _ G1) (proj1 Wt) Fe ltac:(lra)) as Hlow.
  fold q in Hlow; fold Q V in Hlow; pose proof uu_bounds as Hu.
  replace (bpow radix2 (-98)) with (16 * uu) in Hlow by (replace 16 with (bpow radix2 4) by reflexivity;
    now rewrite <- bpow_plus).
  set (T := Rabs (hi tw) + e) in *; pose proof (Rabs_pos (hi tw)) as Ht0; assert (HT : 0 <= T) by (unfold T; lra).
  destruct (word_near tw Wt) as [_ Ntw], (word_near s1_2 W1) as [_ Ns1]; rewrite Rabs_minus_sym in Ntw, Ns1.
  pose proof (u_part _ Ht0) as Hut; pose proof (size_near _ _ _ _ Ntw (Rle_refl _)) as Stw.
  pose proof (u_part _ (Rabs_pos (hi s1_2))) as Hus; pose proof (size_near _ _ _ _ Ns1 (Rle_refl _)) as Ss1.
  assert (HtT : Rabs t <= 1001 / 1000 * T).
  { rewrite Rabs_minus_sym in N; pose proof (size_near _ _ _ _ N Stw); unfold T; lra. }
  set (M := T * V) in *; assert (HM : 0 <= M) by (apply Rmult_le_pos; lra).
  set (y := whole tw * whole s1_2); assert (Hy : Rabs y <= 1003 / 1000 * M).
  { unfold y; rewrite Rabs_mult; apply Rle_trans with (1001 / 1000 * T * (1001 / 1000 * V)); [|unfold M in *; lra].
    apply Rmult_le_compat; auto using Rabs_pos; unfold T; lra. }
  assert (Hyt : Rabs (y - t * s1) <= Rabs (hi s1_2) * e + 303 / 100 * (uu * M)).
  { replace (y - t * s1) with ((whole tw - t) * whole s1_2 + t * (whole s1_2 - s1)) by (unfold y; ring).
    apply Rle_trans with (1 := Rabs_triang _ _); rewrite !Rabs_mult.
    assert (Rabs (whole tw - t) * Rabs (whole s1_2) <= (1 - e12) * e * ((1 + e12) * Rabs (hi s1_2))).
    { apply Rmult_le_compat; auto using Rabs_pos; lra. }
    assert (0 <= e * Rabs (hi s1_2)) by (apply Rmult_le_pos; [lra | apply Rabs_pos]).
    assert (Rabs t * Rabs (whole s1_2 - s1) <= 1001 / 1000 * T * (302 / 100 * (uu * V))).
    { apply Rmult_le_compat; auto using Rabs_pos. }
    assert (0 <= uu * M) by (apply Rmult_le_pos; lra); unfold M in *; lra. }
  destruct (product_any tw s1_2 Wt W1) as [WP HP]; set (P := product tw s1_2) in *; fold y in HP.
  assert (Huy : uu * Rabs y <= uu * (1003 / 1000 * M)) by (apply Rmult_le_compat_l; lra).
  assert (HuM : 0 <= uu * M <= e30 * M) by (split; [apply Rmult_le_pos | apply Rmult_le_compat_r]; lra).
  assert (HuQ : 0 <= uu * Q <= e30 * Q) by (split; [apply Rmult_le_pos | apply Rmult_le_compat_r]; lra).
  assert (Huh : 0 <= uu * h <= e30 * h) by (split; [apply Rmult_le_pos | apply Rmult_le_compat_r]; lra).
  pose proof (size_near _ _ _ _ HP Hy) as SP.
  destruct (sum_near s0_2 P W0 WP) as [Wx Hx]; apply six_in_uu in Hx; set (x := sum s0_2 P) in *.
  assert (Hsum : Rabs (whole s0_2 + whole P) <= 1001 / 1000 * Q + 1004 / 1000 * M + h).
  { apply Rle_trans with (1 := Rabs_triang _ _); pose proof (bpow_gt_0 radix2 (-1074)); lra. }
  assert (Hus' : uu * Rabs (whole s0_2 + whole P) <= uu * (1001 / 1000 * Q + 1004 / 1000 * M + h)).
  { apply Rmult_le_compat_l; lra. }
  pose proof (size_near _ _ _ _ Hx Hsum) as Sx.
  assert (Hhx : Rabs (h - whole x) <= 21 / 10 * h + 1002 / 1000 * Q + 1005 / 1000 * M).
  { unfold Rminus; apply Rle_trans with (1 := Rabs_triang _ _); rewrite Rabs_Ropp, (Rabs_pos_eq h) by lra; lra. }
  assert (Huhx : uu * Rabs (h - whole x) <= uu * (21 / 10 * h + 1002 / 1000 * Q + 1005 / 1000 * M)).
  { apply Rmult_le_compat_l; lra. }
  split; [|exact Wx]; apply Rle_trans with (2 := Hlow); pose proof (bpow_gt_0 radix2 (-1074)).
  assert (Hall : Rabs (whole x - (s0 + t * s1)) <= Rabs (hi s1_2) * e + 404 / 100 * (uu * Q) + 505 / 100 * (uu * M) +
    uu * h + bpow radix2 (-957)).
  { apply Rabs_le_inv in Hx, HP, Hyt, N0; apply Rabs_le; lra. }
  unfold M in *; lra.
Qed.

Theorem axial_places2 : ends2 -> places on_stretch (place_axial f).
Proof.
  intros (E0 & E1 & Eh & Er & Es) root t N; destruct (advance_near2 root t N) as [Hx Wx]; cbv zeta in Hx, Wx.
  unfold place_axial; rewrite E0, E1, Eh, Er, Es; cbn [Formas.outside Formas.inside].
  set (x := sum s0_2 (product (Formas.value root) s1_2)) in *.
  fold (advance_error_of p v centro h (-98) (Rabs (hi s1_2)) (hi (Formas.value root)) (Formas.error root)).
  set (e := advance_error_of _ _ _ _ _ _ _ _) in *; assert (Fe : format e) by apply format_rnd.
  destruct (ordinary_grid h h_ordinary) as [Fh _]; destruct (exactly_word h Fh) as [Wh Eh'].
  destruct (difference_near _ x Wh Wx) as [Wr Hr]; apply six_in_uu in Hr; rewrite Eh' in Hr.
  set (rest := difference (exactly h) x) in *; destruct N as (N & Wt & Fr & Hr900); pose proof (bpow_gt_0 radix2 (-900)).
  pose proof uu_bounds; assert (0 <= uu * Rabs (h - whole x)) by (apply Rmult_le_pos; [lra | apply Rabs_pos]).
  assert (Hs : Rabs (whole x - (s0 + t * s1)) <= e) by lra; assert (Hh : Rabs (whole rest - (h - (s0 + t * s1))) <= e).
  { replace (whole rest - (h - (s0 + t * s1))) with ((whole rest - (h - whole x)) + - (whole x - (s0 + t * s1))) by ring.
    apply Rle_trans with (1 := Rabs_triang _ _); rewrite Rabs_Ropp; lra. }
  assert (Below : forall w b, double_word w -> format b -> Rlt_bool (hi w) b = true -> whole w < b).
  { intros w b Ww Fb; destruct (Rlt_bool_spec (hi w) b); [intros _; now apply word_below | discriminate]. }
  assert (Above : forall w b, double_word w -> format b -> Rlt_bool b (hi w) = true -> b < whole w).
  { intros w b Ww Fb; destruct (Rlt_bool_spec b (hi w)); [intros _; now apply word_above | discriminate]. }
  apply Rabs_le_inv in N, Hs, Hh; unfold Advance.on_stretch; fold q s0 s1; split.
  - rewrite !orb_true_iff; intros [[Ho|Ho]|Ho]; apply Below in Ho; auto using generic_format_opp; lra.
  - rewrite !andb_true_iff; intros [[I1 I2] I3]; apply Above in I1, I2, I3; auto; lra.
Qed.

(** ** The decision *)

Notation least := (least_of_A f).
Definition past_stretch (limit : R) (only : Formas.answer twofold) : Formas.answer twofold :=
  if Rlt_bool limit least then only
  else if Rlt_bool (rnd (2 * Formas.reach f)) (rnd (least * rnd (Rabs (hi (Formas.s1 f)) - rnd (bpow radix2
    (-100) * Formas.speed f))))
    then only else Formas.Undecided.

Local Opaque round sum difference product ratio root_of opposite exactly.
Theorem axial_is_recorded limit :
  first_of_curved_axial f limit = single f (place_axial f) (past_stretch limit) limit.
Proof. exact_no_check (eq_refl (single f (place_axial f) (past_stretch limit) limit)). Qed.

Theorem axial_from_is_recorded limit : first_of_curved_on_axial f limit = single_from f (place_axial f) limit.
Proof. exact_no_check (eq_refl (single_from f (place_axial f) limit)). Qed.
Local Transparent round sum difference product ratio root_of opposite exactly.

Variables A B C F H : R.
Hypothesis f_sound : sound2 f A B C F H.
Hypothesis f_ends : ends2.

Lemma past_stretch_right limit : Formas.B_error f < hi (Formas.F f) ->
  2 * Formas.error (Formas.q (total f)) < Rabs (hi (Formas.value (Formas.q (total f)))) -> forall only,
  past_stretch limit only = Formas.Undecided \/
  past_stretch limit only = only /\ forall t, A * t = q_exact f A B C -> on_stretch t -> limit < t.
Proof.
  intros HF Hq only; pose proof (fun t => least_of_A_right f A B C F H f_sound t HF Hq) as Hleast.
  destruct f_ends as (_ & E1 & _ & Er & Es); unfold past_stretch; rewrite E1, Er, Es.
  destruct (Rlt_bool_spec limit least) as [Hl|_].
  - right; split; [reflexivity|]; intros t Ht [Ht0 _]; destruct (Hleast t Ht) as [_ Hle].
    rewrite Rabs_pos_eq in Hle by lra; lra.
  - destruct (Rlt_bool _ _) eqn:Hfar; [right | now left]; split; [reflexivity|]; intros t Ht On.
    pose proof s1_worded as C1; destruct (near_along v _ _ V C1 (norm_le_extent v) (Rlt_le _ _ HV)) as (N1 & _ & _).
    destruct C1 as (_ & W1 & _); assert (S1 : Rabs (hi s1_2) <= (1 + / 10000000) * Rabs s1 + 7 / 8 * (bpow radix2
      (-100) * V)).
    { destruct (word_near s1_2 W1) as [Nh _]; pose proof (u_part _ (Rabs_pos (whole s1_2))); pose proof (Rabs_pos s1).
      pose proof (size_near _ _ _ _ Nh (Rle_refl _)); pose proof (size_near _ _ _ _ N1 (Rle_refl _)); pose proof uu_bounds.
      assert (0 <= uu * V) by (apply Rmult_le_pos; lra).
      replace (bpow radix2 (-100)) with (4 * uu) by (replace 4 with (bpow radix2 2) by reflexivity;
        now rewrite <- bpow_plus).
      lra. }
    exfalso; exact (far_from_stretch_of p v centro d h ray_fits axis_fits h_ordinary h_positive (-100) (hi s1_2) least t
      ltac:(lia) (proj1 W1) S1 (Hleast t Ht) Hfar On).
Qed.

(** ** What the text says *)

Variable text : coefficients.
Hypothesis same : same_quadratic A B C text.
Hypothesis stretch : forall t, within text t <-> 0 <= s0 + t * s1 <= h.

Theorem axial_pair limit : format limit ->
  right_pair (reach text) limit (first_of_curved_axial f limit) /\
  right_pair (reach (launched text)) limit (first_of_curved_on_axial f limit).
Proof.
  intros Fl; rewrite axial_is_recorded, axial_from_is_recorded; pose proof (axial_places2 f_ends) as P.
  assert (Pos : forall t, on_stretch t -> 0 < t) by (intros t [Ht _]; exact Ht); split.
  - apply (right_pair_equal (points A B C on_stretch)).
    + intros t; unfold points, reach; destruct (same_values A B C text t same) as [-> _]; rewrite stretch.
      unfold Advance.on_stretch; fold q s0 s1; tauto.
    + apply (single_right _ _ _ _ _ _ f_sound); auto; intros HF Hq; exact (past_stretch_right limit HF Hq).
  - apply (right_pair_equal (points_from A B on_stretch)).
    + intros t; unfold points_from, reach; destruct (same_values A B C text t same) as [_ ->].
      change (within (launched text) t) with (within text t); rewrite stretch; unfold Advance.on_stretch; fold q s0 s1; tauto.
    + apply (single_from_right _ _ _ _ _ _ f_sound); auto.
Qed.
End Advance.
