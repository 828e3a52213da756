(** * StableCylinder: the second step on a cylinder

    Formas.Pairs.cilindro is what is computed in double-double of a ray and a cylinder: with a and b of StableAcross.v,
      A = a·a,  B = b·a,  C = b·b - r²,  F, H = r|a| ∓ |b × a|
    with the bounds of a sphere of the same centre and radius. It is sound in the sense of Stable.v, and its advance is
    that of StableAdvance.v, so that the decision over it is right. *)
From Coq Require Import Reals ZArith Lra Lia Psatz.
From Flocq Require Import Core.
From Durero Require Import Toolkit Especificacion Puntos Trazador.
From Durero Require Cylinder Formas.
From Durero Require Import Rounding Vectors Across Flotante Steps Twofold Sums Products Ratios Words Small Doubled Stable
  StableVectors StableSphere StableAdvance StableAcross.
Import Formas.Pairs.
Local Open Scope R_scope.
Local Open Scope zed_scope.
Local Opaque bpow.

Section Cylinder.
Variables p v centro d : vec.
Variables r h : R.
Hypothesis ray_fits : fit_ray p v.
Hypothesis axis_fits : fit_axis centro d.
Hypothesis r_ordinary : ordinary r.
Hypothesis r_positive : 0 < r.
Let q := minus p centro.
Let a := across v d.
Let b := across q d.
Let A := dot a a.
Let B := dot b a.
Let C := dot b b - r * r.
Let F := r * norm a - norm (cross b a).
Let H := r * norm a + norm (cross b a).
Let V := extent v.
Let Q := extent q.
Let E := Q + r.
Let W := V * E.

Notation a2 := (a2 v d).
Notation b2 := (b2 p centro d).
Notation line2 := (line2 p v centro d).
Let surface2 := product (exactly r) (norm2 a2).
Let V_fl := extent_fl v.
Let Q_fl := rnd (rnd (Rabs (hi (dx (minus2 p centro))) + Rabs (hi (dy (minus2 p centro)))) + Rabs (hi (dz
  (minus2 p centro)))).
Let E_fl := rnd (Q_fl + r).
Let error x y := rnd (rnd (bpow radix2 (-96) * x) * y).

Local Opaque sum difference product ratio root_of opposite exactly two_sum.
Lemma recorded : cilindro p v V_fl centro r d h =
  Formas.Quadratic (dot2 a2 a2) (dot2 b2 a2) (difference (dot2 b2 b2) (product (exactly r) (exactly r)))
    (difference surface2 line2) (sum surface2 line2) (error V_fl V_fl) (error V_fl E_fl) (error E_fl E_fl)
    (s0_2 p centro d) (s1_2 v d) h (rnd (Q_fl + h)) V_fl 0 0.
Proof. reflexivity. Qed.
Local Transparent sum difference product ratio root_of opposite exactly two_sum.

Let HV : 0 < V := V_positive v (v_not_zero ray_fits).
Let HQ : 0 <= Q := extent_nonneg q.

Lemma W_parts : W = Q * V + r * V /\ 0 <= Q * V /\ 0 < r * V /\ bpow radix2 (-200) <= W <= bpow radix2 206.
Proof.
  pose proof (V_range v (v_ordinary ray_fits) (v_not_zero ray_fits)) as SV;
    pose proof (E_range p centro r (p_ordinary ray_fits) (centro_ordinary axis_fits) r_ordinary r_positive) as SE.
  change (bpow radix2 (-100) <= V <= bpow radix2 103) in SV; change (bpow radix2 (-100) <= E <= bpow radix2 103) in SE.
  pose proof (bpow_gt_0 radix2 (-100)); split; [unfold W, E; ring|]; split; [apply Rmult_le_pos; lra|].
  split; [apply Rmult_lt_0_compat; lra|]; change (-200)%Z with (-100 + -100)%Z; change 206%Z with (103 + 103)%Z.
  rewrite !bpow_plus; unfold W; split; apply Rmult_le_compat; lra.
Qed.

Lemma W_least : (1 + r) * bpow radix2 (-450) <= / 1000 * (uu * W) /\ bpow radix2 (-957) <= / 1000 * (uu * W).
Proof. destruct W_parts as (_ & _ & _ & [HW _]); apply nothing_beside; [exact (ordinary_size r r_ordinary) | exact HW]. Qed.

Lemma surface_near2 : double_word surface2 /\ Rabs (whole surface2 - r * norm a) <= 192 / 10 * (uu * (r * V)) + / 400 *
  (uu * W) /\
  0 <= r * norm a <= r * V.
Proof.
  destruct (a_facts2 p v centro d ray_fits axis_fits) as (Oa & Na & Sa & Sa'); fold a in Na, Sa;
    fold V in Na, Sa, Sa'.
  destruct (on_words _ _ Oa) as (Wx & Wy & Wz), (norm2_any _ Wx Wy Wz) as (Wn & Hn & _), (ordinary_grid r r_ordinary)
    as [Fr _].
  destruct (exactly_word r Fr) as [Wr Er], (product_any _ _ Wr Wn) as [WS HS]; fold surface2 in WS, HS; rewrite Er in HS.
  destruct W_least as [L1 L2]; pose proof uu_bounds as Hu; set (y := bpow radix2 (-450)) in *;
    set (n := whole (norm2 a2)) in *.
  pose proof (norm_between (wholes a2) a) as B1; pose proof (norm_between a (wholes a2)) as B2;
    rewrite norm_symmetric in B2.
  pose proof (norm_nonneg a) as Ha0; pose proof (bpow_gt_0 radix2 (-450) : 0 < y) as Hy0.
  assert (HuV : 0 < uu * V <= e30 * V) by (split; [apply Rmult_lt_0_compat | apply Rmult_le_compat_r]; lra).
  assert (Hun : uu * norm (wholes a2) <= uu * (10001 / 10000 * V)) by (apply Rmult_le_compat_l; lra).
  assert (Hd : Rabs (n - norm a) <= 181 / 10 * (uu * V) + y) by (apply Rabs_le_inv in Hn; apply Rabs_le; lra).
  assert (Hrd : Rabs (r * n - r * norm a) <= r * (181 / 10 * (uu * V) + y)).
  { rewrite <- Rmult_minus_distr_l, Rabs_mult, (Rabs_pos_eq r) by lra; apply Rmult_le_compat_l; lra. }
  assert (Hra : 0 <= r * norm a <= r * V) by (split; [apply Rmult_le_pos | apply Rmult_le_compat_l]; lra).
  assert (HurV : 0 < uu * (r * V) <= e30 * (r * V)).
  { assert (0 < r * V) by (apply Rmult_lt_0_compat; lra); split; [apply Rmult_lt_0_compat | apply Rmult_le_compat_r]; lra. }
  assert (Hry : 0 <= r * y) by (apply Rmult_le_pos; lra).
  assert (Hrn : Rabs (r * n) <= 1001 / 1000 * (r * V) + r * y) by (apply Rabs_le_inv in Hrd; apply Rabs_le; lra).
  assert (Hurn : uu * Rabs (r * n) <= uu * (1001 / 1000 * (r * V) + r * y)) by (apply Rmult_le_compat_l; lra).
  assert (uu * (r * y) <= e30 * (r * y)) by (apply Rmult_le_compat_r; lra).
  split; [exact WS | split; [|exact Hra]]; apply Rabs_le_inv in HS, Hrd; apply Rabs_le; lra.
Qed.

Lemma F_H_near2 : let F2 := difference surface2 line2 in let H2 := sum surface2 line2 in double_word F2 /\ double_word H2 /\
  Rabs (whole F2 - F) <= 40 * (uu * W) /\ Rabs (whole H2 - H) <= 40 * (uu * W) /\
  (0 < whole F2 -> whole F2 <= (1 + / 2000) * whole H2) /\ 0 <= r * norm a /\ 0 <= norm (cross b a) /\ H <= 2 * W.
Proof.
  destruct surface_near2 as (WS & HS & Hra), (line_near2 p v centro d ray_fits axis_fits) as (HL & WL & HL0 & HL1);
  fold q in HL, HL1; fold Q V a b in HL, HL1; pose proof (norm_nonneg (cross b a)) as HL2.
  destruct W_parts as (EW & HQV & HrV & _), W_least as [L1 _]; pose proof uu_bounds as Hu;
    pose proof (bpow_gt_0 radix2 (-450)).
  assert (0 <= r * bpow radix2 (-450)) by (apply Rmult_le_pos; lra).
  assert (HuW : 0 <= uu * W <= e30 * W) by (split; [apply Rmult_le_pos | apply Rmult_le_compat_r]; lra).
  assert (HuWs : uu * W = uu * (Q * V) + uu * (r * V)) by (rewrite EW; ring).
  assert (0 <= uu * (Q * V)) by (apply Rmult_le_pos; lra); assert (0 <= uu * (r * V)) by (apply Rmult_le_pos; lra).
  destruct (factors_near surface2 (r * norm a) line2 (norm (cross b a)) (35 * (uu * W)) WS WL (proj1 Hra) HL2 HL0
    ltac:(lra))
    as (WF & WH & HF & HH & Hbelow).
  assert (Hsum : uu * (r * norm a + norm (cross b a) + 35 * (uu * W)) <= uu * (2 * W)) by (apply Rmult_le_compat_l; lra).
  cbv zeta; split; [exact WF | split; [exact WH|]]; split; [unfold F; lra | split; [unfold H; lra|]].
  split; [exact Hbelow | split; [apply Hra | split; [exact HL2 | unfold H; lra]]].
Qed.

Theorem stable_cylinder_sound : sound2 (cilindro p v V_fl centro r d h) A B C F H.
Proof.
  rewrite recorded; destruct F_H_near2 as (WF & WH & HF & HH & Hbelow & Hra & Hcr & Hsize); pose proof uu_bounds as Hu.
  destruct (products_near p v centro d ray_fits axis_fits) as ((NA & WA & GA & SA) & (NB & WB & GB & SB) & (NC & WC & GC & SC)).
  fold q in NB, SB, NC, SC; fold a in NA, SA; fold a b in NB, SB; fold b in NC, SC; fold V in NA, SA; fold Q V in NB, SB;
    fold Q in NC, SC.
  pose proof (V_range v (v_ordinary ray_fits) (v_not_zero ray_fits)) as SV;
    pose proof (E_range p centro r (p_ordinary ray_fits) (centro_ordinary axis_fits) r_ordinary r_positive) as SE.
  change (bpow radix2 (-100) <= V <= bpow radix2 103) in SV; change (bpow radix2 (-100) <= E <= bpow radix2 103) in SE.
  pose proof (bpow_gt_0 radix2 (-100)); pose proof (V_computed2 p v ray_fits) as CV;
    pose proof (E_computed2 p v centro r ray_fits (centro_ordinary axis_fits) r_ordinary r_positive) as CE.
  destruct (error_bound2 V V_fl V V_fl CV CV SV SV) as (MA & LA & UA).
  destruct (error_bound2 V V_fl E E_fl CV CE SV SE) as (MB & LB & UB);
    destruct (error_bound2 E E_fl E E_fl CE CE SE SE) as (MC & LC & UC).
  destruct W_parts as (EW & HQV & HrV & HW); fold W in MB.
  pose proof (worded_mult 0 0 (-152) (-152) _ _ _ _ _ _ ltac:(lia) (word_of r r_ordinary r_positive)
    (word_of r r_ordinary r_positive)) as Rc.
  pose proof (worded_error 1 _ _ _ _ ltac:(lia) Rc) as ER; simpl INR in ER; destruct Rc as (_ & WR & GR & GR').
  destruct (difference_near _ _ WC WR) as [WD HD]; apply six_in_uu in HD; set (C2 := difference _ _) in *.
  assert (Hsmall : forall X, 0 <= X -> 0 <= uu * X <= e30 * X) by (intros; split;
    [apply Rmult_le_pos | apply Rmult_le_compat_r]; lra).
  pose proof (Hsmall (V * V) ltac:(apply Rmult_le_pos; lra)) as HuVV; pose proof (Hsmall W ltac:(lra)) as HuW.
  pose proof (Hsmall (Q * V) HQV) as HuQV; assert (HuQVW : uu * (Q * V) <= uu * W) by (apply Rmult_le_compat_l; lra).
  pose proof (Rmult_le_pos Q Q HQ HQ) as HQQ; assert (Hrr : 0 < r * r) by (apply Rmult_lt_0_compat; lra).
  assert (HEE : Q * Q + r * r <= E * E) by (pose proof (Rmult_le_pos Q r HQ ltac:(lra)); unfold E; lra).
  pose proof (Hsmall _ HQQ) as HuQQ; pose proof (Hsmall (r * r) ltac:(lra)) as Hurr.
  assert (HuEE : uu * (Q * Q) + uu * (r * r) <= uu * (E * E)) by (rewrite <- Rmult_plus_distr_l; apply Rmult_le_compat_l;
    lra).
  set (R2 := product (exactly r) (exactly r)) in *; set (bb := dot2 b2 b2) in *.
  assert (Hbb : Rabs (whole bb - whole R2) <= 2 * (Q * Q) + 2 * (r * r)) by (apply Rabs_le_inv in NC, SC, ER; apply Rabs_le;
    lra).
  assert (Hubb : uu * Rabs (whole bb - whole R2) <= uu * (2 * (Q * Q) + 2 * (r * r))) by (apply Rmult_le_compat_l; lra).
  assert (H440 : 8 * bpow radix2 206 <= bpow radix2 440).
  { replace 8 with (bpow radix2 3) by reflexivity; rewrite <- bpow_plus; apply bpow_le; lia. }
  assert (HVV : V * V <= bpow radix2 206).
  { change 206%Z with (103 + 103)%Z; rewrite bpow_plus; apply Rmult_le_compat; lra. }
  constructor; cbn [Formas.A Formas.B Formas.C Formas.F Formas.H Formas.A_error Formas.B_error Formas.C_error].
  - auto.
  - unfold A, error; lra.
  - unfold B, error; lra.
  - apply Rabs_le_inv in HD, NC, ER; unfold C, error; apply Rabs_le; lra.
  - unfold error; lra.
  - unfold error; lra.
  - exact (Cylinder.F_times_H p v centro d r).
  - unfold F, H; apply Rabs_le; lra.
  - exact Hbelow.
  - repeat split; apply format_rnd.
  - unfold error; tauto.
  - assert (H450 : bpow radix2 440 <= bpow radix2 450) by (apply bpow_le; lia).
    pose proof (leading _ WA); pose proof (leading _ WB); pose proof (leading _ WH); pose proof (size_near _ _ _ _ NA SA).
    pose proof (size_near _ _ _ _ NB SB); assert (SH : Rabs H <= 2 * W) by (unfold H in *; rewrite Rabs_pos_eq; lra).
    pose proof (size_near _ _ _ _ HH SH); split; [lra | split; [lra|]]; apply Rle_trans with (1 := Rle_abs _); lra.
  - split; [now apply (sizeable_on_grid (-912))|]; apply (sizeable_on_grid (-912)); [lia|].
    unfold C2; rewrite difference_is; apply parts_sum;
      [lia | exact WC | apply (opposite_word _ WR) | exact GC | apply parts_opposite].
    split; apply (grid_coarser (-912) (-304)); lia || assumption.
Qed.

(** ** What the text says *)

Hypothesis h_ordinary : ordinary h.
Hypothesis h_positive : 0 < h.
Notation text := (of_cilindro (ray_of p v) (point centro) r (direction d) h).

Theorem stable_cylinder_right limit : format limit ->
  right_pair (reach text) limit (first_of_curved_axial (cilindro p v V_fl centro r d h) limit) /\
  right_pair (reach (launched text)) limit (first_of_curved_on_axial (cilindro p v V_fl centro r d h) limit).
Proof.
  apply (axial_pair p v centro d h ray_fits axis_fits h_ordinary h_positive
    _ A B C F H stable_cylinder_sound).
  - repeat split.
  - exact (cylinder_same p v centro r d h).
  - intros t; apply within_stretch.
Qed.
End Cylinder.
