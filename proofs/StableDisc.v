(** * StableDisc: the second step on a disc is right

    trace/shape/disc-inl.hpp computes, in double-double, the plane's B and C, and
      margin = r|s1| - |s1 q - s0 v|,  s1 = 2 B,  s0 = C,  within 32 uu V (Q + r)
    which is |s1| times how far within the rim the line crosses the plane. *)
From Coq Require Import Reals ZArith List Lra Lia Psatz.
From Flocq Require Import Core.
From Durero Require Import Toolkit Especificacion Puntos Trazador.
From Durero Require Tipos Formas.
From Durero Require Import Rounding Vectors Across Quotient Decision Flotante Verdict Advance Linear Plane Steps Twofold Sums
  Products Ratios Words Small Doubled StableVectors StableFlat StablePlane.
Import Formas.Pairs.
Local Open Scope R_scope.
Local Open Scope zed_scope.
Local Opaque bpow.

Section Disc.
Variables p v centro d : vec.
Variable r : R.
Hypothesis ray_fits : fit_ray p v.
Hypothesis axis_fits : fit_axis centro d.
Hypothesis r_ordinary : ordinary r.
Hypothesis r_positive : 0 < r.
Let q := minus p centro.
Let Q := extent q.
Let V := extent v.
Let s0 := dot q d.
Let s1 := dot v d.
Let q2 := minus2 p centro.
Let v2 := exactly2 v.
Notation V_fl := (extent_fl v).
Notation Q_fl := (extent_fl (q_fl p centro)).
Notation half := (half2 v d).
Let S2 := sum half half.
Let back := opposite (s0_2 p centro d).
Let turned := product (exactly r) S2.
Let rim := if Rlt_bool (hi S2) 0 then opposite turned else turned.
Let out2 := Vec2 (sum (product S2 (dx q2)) (product back (dx v2))) (sum (product S2 (dy q2)) (product back (dy v2)))
  (sum (product S2 (dz q2)) (product back (dz v2))).
Let margin2 := difference rim (norm2 out2).
Let out : vec := minus (scale s1 q) (scale s0 v).
Let error := rnd (rnd (bpow radix2 (-97) * V_fl) * rnd (Q_fl + r)).

Local Opaque sum difference product ratio root_of opposite exactly two_sum.
Lemma disc_recorded2 : along2 p v centro d (disco p v V_fl centro r d) /\
  Formas.margin (disco p v V_fl centro r d) = hi margin2 /\ Formas.margin_error (disco p v V_fl centro r d) = error.
Proof. repeat split. Qed.
Local Transparent sum difference product ratio root_of opposite exactly two_sum.

Let HQ : 0 <= Q := extent_nonneg q.
Let HV : 0 < V := V_positive v (v_not_zero ray_fits).

Lemma S_worded : worded 5 (-305) S2 s1 (size_of_dot v d).
Proof.
  pose proof (half_worded p v centro d ray_fits axis_fits) as H.
  pose proof (worded_plus 4 (-305) _ _ _ _ _ _ ltac:(lia) H H) as Hc.
  replace (dot v d * / 2 + dot v d * / 2) with s1 in Hc by (unfold s1; field).
  now replace (size_of_dot v d * / 2 + size_of_dot v d * / 2) with (size_of_dot v d) in Hc by field.
Qed.

Lemma rim_near : double_word rim /\ Rabs (whole rim - r * Rabs s1) <= 61 / 10 * (uu * (r * V)) /\
  Rabs s1 <= 1000001 / 1000000 * V.
Proof.
  pose proof S_worded as Hc; pose proof (size_of_s1 p v centro d ray_fits axis_fits) as HS; pose proof uu_bounds as Hu;
  fold V in HS.
  pose proof (worded_error 5 _ _ _ _ ltac:(lia) Hc) as He; simpl INR in He.
  assert (HuV : 0 < uu * V <= e30 * V) by (split; [apply Rmult_lt_0_compat | apply Rmult_le_compat_r]; lra).
  assert (Hsu : uu * size_of_dot v d <= uu * (1000001 / 1000000 * V)) by (apply Rmult_le_compat_l; lra).
  assert (Hs : Rabs (whole S2 - s1) <= 502 / 100 * (uu * V)) by (apply Rle_trans with (1 := He); lra).
  destruct Hc as ((_ & Hm) & WS & GS & _); assert (H1 : Rabs s1 <= 1000001 / 1000000 * V) by lra.
  destruct (ordinary_grid r r_ordinary) as [Fr Gr]; destruct (exactly_word r Fr) as [Wr Er].
  destruct (product_near (exactly r) S2 Wr WS) as [WT HT].
  { apply (grid_worthy (-152 + -305)); [lia | now apply grid_mult]. }
  fold turned in WT, HT; rewrite Er in HT; destruct (opposite_word turned WT) as [Wo Eo].
  split; [unfold rim; destruct (Rlt_bool (hi S2) 0); assumption | split; [|exact H1]].
  set (S := whole S2) in *; rewrite Rabs_mult, (Rabs_pos_eq r) in HT by lra.
  assert (Hrim : Rabs (whole rim - r * Rabs S) <= uu * (r * Rabs S)).
  { unfold rim; destruct (Rlt_bool_spec (hi S2) 0) as [Hneg|Hpos].
    - apply (word_below _ _ WS (generic_format_0 _ _)) in Hneg; fold S in Hneg; rewrite Eo, (Rabs_left S) in * by lra.
      replace (- whole turned - r * - S) with (- (whole turned - r * S)) by ring; rewrite Rabs_Ropp; exact HT.
    - assert (HS0 : 0 <= S).
      { destruct (word_near _ WS) as [_ Hn]; pose proof (u_part _ (Rabs_pos (hi S2))) as Hp; fold S in Hn.
        rewrite (Rabs_pos_eq (hi S2)) in * by lra; apply Rabs_le_inv in Hn; lra. }
      rewrite (Rabs_pos_eq S) in * by lra; exact HT. }
  assert (Hd : Rabs (r * Rabs S - r * Rabs s1) <= 502 / 100 * (uu * (r * V))).
  { rewrite <- Rmult_minus_distr_l, Rabs_mult, (Rabs_pos_eq r) by lra.
    replace (502 / 100 * (uu * (r * V))) with (r * (502 / 100 * (uu * V))) by ring; apply Rmult_le_compat_l; [lra|].
    apply Rle_trans with (2 := Hs), Rabs_triang_inv2. }
  assert (HSV : Rabs S <= 1001 / 1000 * V) by (apply Rabs_le_inv in Hs, H1; apply Rabs_le; lra).
  assert (uu * (r * Rabs S) <= uu * (1001 / 1000 * (r * V))).
  { apply Rmult_le_compat_l; [lra|]; replace (1001 / 1000 * (r * V)) with (r * (1001 / 1000 * V)) by ring.
    apply Rmult_le_compat_l; lra. }
  assert (0 <= uu * (r * V)) by (repeat apply Rmult_le_pos; lra).
  apply Rabs_le_inv in Hd, Hrim; apply Rabs_le; lra.
Qed.

Lemma out_near2 : double_word (norm2 out2) /\ Rabs (whole (norm2 out2) - norm out) <= 301 / 10 * (uu * (Q * V)) + bpow radix2 (-450) /\
  0 <= norm out <= 2001 / 1000 * (Q * V).
Proof.
  pose proof S_worded as Hc; pose proof (size_of_s1 p v centro d ray_fits axis_fits) as HS; pose proof uu_bounds as Hu.
  pose proof (size_of_s0 p centro d axis_fits) as HS0; fold V in HS; fold q Q in HS0.
  pose proof (worded_opposite _ _ _ _ _ (s0_worded p v centro d ray_fits axis_fits)) as H0; fold back q s0 in H0.
  destruct (words_between p centro (p_ordinary ray_fits) (centro_ordinary axis_fits)) as (QX & QY & QZ), (words_of v
    (v_ordinary ray_fits)) as (VX & VY & VZ).
  fold q2 q in QX, QY, QZ; fold v2 in VX, VY, VZ; set (i := size_of_dot v d) in *; set (j := size_of_dot q d) in *.
  assert (Hone : forall a x b y, worded 0 (-152) a x (Rabs x) -> worded 0 (-152) b y (Rabs y) ->
    worded 7 (-457) (sum (product S2 a) (product back b)) (s1 * x + - s0 * y) (i * Rabs x + j * Rabs y)).
  { intros a x b y Ha Hb; apply (worded_plus 6); [lia | |].
    - exact (worded_mult 5 0 (-305) (-152) _ _ _ _ _ _ ltac:(lia) Hc Ha).
    - apply (worded_coarser _ _ (-456)); [lia|]; apply (worded_more 4); [lia|].
      exact (worded_mult 3 0 (-304) (-152) _ _ _ _ _ _ ltac:(lia) H0 Hb). }
  pose proof (Hone _ _ _ _ QX VX) as CX; pose proof (Hone _ _ _ _ QY VY) as CY; pose proof (Hone _ _ _ _ QZ VZ) as CZ.
  destruct (norm2_any out2 (proj1 (proj2 CX)) (proj1 (proj2 CY)) (proj1 (proj2 CZ))) as (Wn & Hn & _); split; [exact Wn|].
  pose proof (worded_error 7 _ _ _ _ ltac:(lia) CX) as EX; pose proof (worded_error 7 _ _ _ _ ltac:(lia) CY) as EY;
    pose proof (worded_error 7 _ _ _ _ ltac:(lia) CZ) as EZ; simpl INR in EX, EY, EZ.
  pose proof (norm_le_extent q : _ <= Q) as NQ; pose proof (norm_le_extent v : _ <= V) as NV.
  pose proof (norm_nonneg q); pose proof (norm_nonneg v); assert (HQV : 0 <= Q * V) by (apply Rmult_le_pos; lra).
  assert (Hsum : i * norm q + j * norm v <= 2000002 / 1000000 * (Q * V)).
  { assert (i * norm q <= 1000001 / 1000000 * V * Q) by (apply Rmult_le_compat; lra).
    assert (j * norm v <= 1000001 / 1000000 * Q * V) by (apply Rmult_le_compat; lra); lra. }
  set (k := 701 / 100 * uu); assert (Hk : 0 <= k) by (unfold k; lra); set (w := wholes out2) in *.
  assert (Hoff : norm (minus w out) <= 1403 / 100 * (uu * (Q * V))).
  { apply Rle_trans with (norm (scale k (plus (scale i (magnitudes q)) (scale j (magnitudes v))))).
    - assert (Hone' : forall a x b, Rabs (a - (s1 * x + - s0 * b)) <= 1001 / 1000 * (1 + 1 + 1 + 1 + 1 + 1 + 1) * uu *
        (i * Rabs x + j * Rabs b) -> Rabs (a - (s1 * x - s0 * b)) <= k * (i * Rabs x + j * Rabs b)).
      { intros a x b He; replace (s1 * x - s0 * b) with (s1 * x + - s0 * b) by ring; apply Rle_trans with (1 := He).
        apply Rmult_le_compat_r; [|unfold k; lra].
        pose proof (Rmult_le_pos i (Rabs x) ltac:(lra) (Rabs_pos x)).
        pose proof (Rmult_le_pos j (Rabs b) ltac:(lra) (Rabs_pos b)); lra. }
      apply norm_mono; cbn [cx cy cz minus scale plus magnitudes]; apply Hone'; assumption.
    - rewrite norm_scale, (Rabs_pos_eq k Hk); apply Rle_trans with (k * (i * norm q + j * norm v)).
      + apply Rmult_le_compat_l; [exact Hk|]; apply Rle_trans with (1 := norm_plus _ _).
        rewrite !norm_scale, !norm_magnitudes, (Rabs_pos_eq i), (Rabs_pos_eq j) by lra; lra.
      + apply Rle_trans with (k * (2000002 / 1000000 * (Q * V))); [apply Rmult_le_compat_l; lra|].
        assert (0 <= uu * (Q * V)) by (apply Rmult_le_pos; lra); unfold k; lra. }
  assert (Hout : norm out <= 2000002 / 1000000 * (Q * V)).
  { apply Rle_trans with (2 := Hsum); unfold out.
    replace (minus (scale s1 q) (scale s0 v)) with (plus (scale s1 q) (scale (- s0) v))
      by (unfold minus, plus, scale; cbn; f_equal; ring).
    apply Rle_trans with (1 := norm_plus _ _); rewrite !norm_scale.
    assert (Rabs s1 <= i) by exact (proj2 (proj1 Hc)); assert (Rabs (- s0) <= j) by exact (proj2 (proj1 H0)).
    assert (Rabs s1 * norm q <= i * norm q) by (apply Rmult_le_compat_r; lra).
    assert (Rabs (- s0) * norm v <= j * norm v) by (apply Rmult_le_compat_r; lra); lra. }
  split; [|split; [apply norm_nonneg | lra]].
  pose proof (norm_between w out) as B1; pose proof (norm_between out w) as B2.
  rewrite norm_symmetric in B2.
  assert (HuQV : 0 <= uu * (Q * V) <= e30 * (Q * V)) by (split; [apply Rmult_le_pos | apply Rmult_le_compat_r]; lra).
  assert (uu * norm w <= uu * (2001 / 1000 * (Q * V))) by (apply Rmult_le_compat_l; lra).
  apply Rabs_le_inv in Hn; apply Rabs_le; lra.
Qed.

Theorem margin_near2 : double_word margin2 /\ Rabs (whole margin2 - margin p v centro d r) <= error.
Proof.
  destruct rim_near as (WR & NR & S1), out_near2 as (WN & NO & SO); pose proof uu_bounds as Hu; pose proof u_bounds as Hu1.
  destruct (difference_near _ _ WR WN) as [WM HM]; fold margin2 in WM, HM; split; [exact WM|]; apply six_in_uu in HM.
  change (margin p v centro d r) with (r * Rabs s1 - norm out).
  set (W := Q * V) in *; assert (HW : 0 <= W) by (apply Rmult_le_pos; lra).
  set (X := r * V) in *; assert (HX : 0 < X) by (apply Rmult_lt_0_compat; lra).
  assert (HuW : 0 <= uu * W <= e30 * W) by (split; [apply Rmult_le_pos | apply Rmult_le_compat_r]; lra).
  assert (HuX : 0 < uu * X <= e30 * X) by (split; [apply Rmult_lt_0_compat | apply Rmult_le_compat_r]; lra).
  assert (HX200 : bpow radix2 (-200) <= X).
  { change (-200)%Z with (-100 + -100)%Z; rewrite bpow_plus; apply Rmult_le_compat; try apply bpow_ge_0.
    - exact (r_least r r_ordinary r_positive).
    - exact (proj1 (V_range v (v_ordinary ray_fits) (v_not_zero ray_fits))). }
  destruct (nothing_beside r X (ordinary_size r r_ordinary) HX200) as [Ny _]; pose proof (bpow_gt_0 radix2 (-450)) as Hy.
  set (y := bpow radix2 (-450)) in *; pose proof (Rmult_le_pos r y ltac:(lra) ltac:(lra)).
  assert (Herr : 319 / 10 * (uu * (X + W)) <= error).
  { assert (H97 : computed 0 (-97) (bpow radix2 (-97)) (bpow radix2 (-97)) (bpow radix2 (-97))).
    { rewrite <- (Rabs_pos_eq (bpow radix2 (-97))) at 3 by apply bpow_ge_0; apply computed_exact; [apply format_bpow; lia|].
      exists 1%Z; ring. }
    pose proof (computed_plus 3 (-152) _ _ _ _ _ _ ltac:(lia) (Q_computed p v centro d ray_fits axis_fits)
      (computed_more 0 3 _ _ _ _ ltac:(lia) (r_computed r r_ordinary r_positive))) as HE.
    pose proof (computed_mult 3 4 (-249) (-152) _ _ _ _ _ _ ltac:(lia) (computed_mult 0 2 (-97) (-152) _ _ _ _ _ _
      ltac:(lia) H97 (V_computed v (v_ordinary ray_fits))) HE) as Hm.
    change (Flotante.V_fl v) with V_fl in Hm; fold V q Q in Hm.
    pose proof (computed_error_near 8 _ _ _ _ ltac:(lia) Hm) as He; simpl INR in He; fold error in He.
    replace (bpow radix2 (-97)) with (32 * uu) in He by (replace 32 with (bpow radix2 5) by reflexivity;
      now rewrite <- bpow_plus).
    replace (32 * uu * V * (Q + r)) with (32 * (uu * (X + W))) in He by (unfold X, W; ring).
    assert (H0 : 0 <= uu * (X + W)) by (apply Rmult_le_pos; lra).
    assert (u * (uu * (X + W)) <= / 1000000000000 * (uu * (X + W))) by (apply Rmult_le_compat_r; lra).
    apply Rabs_le_inv in He; lra. }
  assert (HR1 : 0 <= r * Rabs s1 <= 1000001 / 1000000 * X).
  { split; [apply Rmult_le_pos; [lra | apply Rabs_pos]|]; apply Rle_trans with (r * (1000001 / 1000000 * V));
      [apply Rmult_le_compat_l; lra | unfold X; lra]. }
  assert (Hd : Rabs (whole rim - whole (norm2 out2)) <= 1001 / 1000 * X + 2002 / 1000 * W).
  { apply Rabs_le_inv in NR, NO; apply Rabs_le; lra. }
  assert (Hud : 3 / 8 * (uu * Rabs (whole rim - whole (norm2 out2))) <= 3 / 8 * (uu * (1001 / 1000 * X + 2002 / 1000 * W))).
  { apply Rmult_le_compat_l; [lra|]; apply Rmult_le_compat_l; lra. }
  destruct (difference_near _ _ WR WN) as [_ H6]; fold margin2 in H6; rewrite (in_uu 6) in H6 by apply Rabs_pos.
  apply Rle_trans with (2 := Herr); apply Rabs_le_inv in H6, NR, NO; apply Rabs_le; lra.
Qed.

Lemma margin_signs : (hi margin2 < - error -> margin p v centro d r < 0) /\ (error < hi margin2 -> 0 < margin p v centro d r).
Proof.
  destruct margin_near2 as [W N]; apply Rabs_le_inv in N; assert (Fe : format error) by apply format_rnd; split; intros H.
  - apply (word_below _ _ W (generic_format_opp _ _ _ Fe)) in H; lra.
  - apply (word_above _ _ W Fe) in H; lra.
Qed.
End Disc.

Theorem stable_disc_right p v centro r d limit : fit_ray p v -> fit_axis centro d -> ordinary r -> 0 < r -> format limit ->
  let f := disco p v (extent_fl v) centro r d in let text := of_disco (ray_of p v) (point centro) r (direction d) in
  right_pair (reach text) limit (first_of_linear_edged f limit) /\
  right_pair (reach (launched text)) limit (first_of_linear_on f limit).
Proof.
  intros Hray Haxis Hr Hr0 Fl f text; destruct (disc_recorded2 p v centro d r) as (Ha & Em & Ee).
  pose proof (plane_sound2 p v centro d Hray Haxis _ Ha) as S;
  destruct (margin_signs p v centro d r Hray Haxis Hr Hr0) as [Low High].
  apply (edged_pair _ (dot v d / 2) (dot (minus p centro) d) S) with (m := margin p v centro d r);
    [| | exact Fl | | |].
  - intros t; unfold text, ray_of, point, direction, value, of_disco, Tipos.dot, from, dot, minus; cbn; ring.
  - intros t; unfold text, ray_of, point, direction, value, launched, of_disco, Tipos.dot, from, dot, minus; cbn; ring.
  - unfold f; rewrite Em, Ee; exact Low.
  - unfold f; rewrite Em, Ee; exact High.
  - intros K t Ht; destruct (known_means _ _ _ S K) as [_ HB]; rewrite (margin_tells p v centro d r Hr0 t) by lra.
    unfold within, text; cbn [clip of_disco]; rewrite Forall_cons_iff.
    unfold excess, ray_of, point, direction, Tipos.sq, Tipos.dot, from, dot, minus; cbn.
    split; [intros Hle; split; [exact Hle | constructor] | intros [Hle _]; exact Hle].
Qed.
