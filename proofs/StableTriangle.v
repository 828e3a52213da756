(** * StableTriangle: the second step on a triangle is right

    trace/shape/triangle-inl.hpp computes over pairs what Triangle.v has over binary64. The edges and the way from a are
    kept whole by two parts, so that a triple product takes five operations, and with the extents L1, L2, Q and V
      B = -det/2 is within 8 uu V L1 L2,  C within 16 uu Q L1 L2,  and ab, ca and the rest of det within margin_error2.
    The margin is the least of three leading parts; each has the sign of its pair, and so of what the pair is near.

    tells m e x == the leading part m is below -e, or above e, only where x is below 0, or above 0 *)
From Coq Require Import Reals ZArith List Lra Lia Psatz Bool.
From Flocq Require Import Core.
From Durero Require Import Toolkit Especificacion Puntos Trazador.
From Durero Require Tipos Formas Flat.
From Durero Require Import Rounding Vectors Across Quotient Decision Flotante Verdict Linear Triangle Steps Twofold Sums
  Products Ratios Words Doubled StableVectors StableFlat.
Import Formas.Pairs.
Local Open Scope R_scope.
Local Open Scope zed_scope.
Local Opaque bpow.

(** ** Triple products of pairs *)

Lemma triple_worded x2 x y2 y w2 w : words_close 0 (-152) x2 x -> words_close 0 (-152) y2 y -> words_close 0 (-152) w2 w ->
  worded 5 (-456) (dot2 x2 (cross2 y2 w2)) (dot x (cross y w)) (triple_size x y w).
Proof.
  intros (X1 & X2 & X3) (Y1 & Y2 & Y3) (W1 & W2 & W3).
  assert (Hcross : forall a a' b b' s s' t t', worded 0 (-152) a s (Rabs s) -> worded 0 (-152) b t (Rabs t) ->
    worded 0 (-152) a' s' (Rabs s') -> worded 0 (-152) b' t' (Rabs t') ->
    worded 2 (-304) (difference (product a b) (product a' b')) (s * t - s' * t') (Rabs s * Rabs t + Rabs s' * Rabs t')).
  { intros; apply worded_minus; [lia | |]; apply (worded_mult 0 0 (-152) (-152)); auto; lia. }
  pose proof (Hcross _ _ _ _ _ _ _ _ Y2 W3 Y3 W2) as C1; pose proof (Hcross _ _ _ _ _ _ _ _ Y3 W1 Y1 W3) as C2;
    pose proof (Hcross _ _ _ _ _ _ _ _ Y1 W2 Y2 W1) as C3.
  assert (Hone : forall a s b t m, worded 0 (-152) a s (Rabs s) -> worded 2 (-304) b t m ->
    worded 3 (-456) (product a b) (s * t) (Rabs s * m)).
  { intros a s b t m Ha Hb; apply (worded_mult 0 2 (-152) (-304)); auto; lia. }
  unfold dot2, dot, triple_size; apply worded_plus; [lia | apply worded_plus; [lia | |] |
    apply (worded_more 3); [lia|]]; apply Hone; assumption.
Qed.

Definition tells (m e x : R) : Prop := (m < - e -> x < 0) /\ (e < m -> 0 < x).

Lemma word_tells w x e : double_word w -> format e -> Rabs (whole w - x) <= e -> tells (hi w) e x.
Proof.
  intros W Fe N; apply Rabs_le_inv in N; split; intros H.
  - apply (word_below _ _ W (generic_format_opp _ _ _ Fe)) in H; lra.
  - apply (word_above _ _ W Fe) in H; lra.
Qed.

Lemma tells_opposite m e x : tells m e x -> tells (- m) e (- x).
Proof. intros [L H]; split; intros; [specialize (H ltac:(lra)) | specialize (L ltac:(lra))]; lra. Qed.

Lemma tells_least m n e x y : tells m e x -> tells n e y -> tells (least m n) e (Rmin x y).
Proof.
  intros [Lx Hx] [Ly Hy]; unfold least, Rmin; destruct (Rlt_bool_spec m n), (Rle_dec x y); split; intros;
    try (specialize (Lx ltac:(lra))); try (specialize (Ly ltac:(lra))); try (specialize (Hx ltac:(lra)));
    try (specialize (Hy ltac:(lra))); lra.
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
Notation V_fl := (extent_fl v).
Notation L1_fl := (extent_fl (minus_fl b a)).
Notation L2_fl := (extent_fl (minus_fl c a)).
Notation Q_fl := (extent_fl (minus_fl p a)).
Notation det := (det v a b c).
Notation ab := (ab p v a b).
Notation ca := (ca p v a c).
Notation crossing := (crossing p a b c).

Definition det2 : twofold := dot2 (minus2 b a) (cross2 (exactly2 v) (minus2 c a)).
Definition ab2 : twofold := dot2 (exactly2 v) (cross2 (minus2 p a) (minus2 b a)).
Definition ca2 : twofold := dot2 (minus2 p a) (cross2 (exactly2 v) (minus2 c a)).
Definition bc2 : twofold := difference (difference det2 ca2) ab2.
Definition crossing2 : twofold := dot2 (minus2 c a) (cross2 (minus2 p a) (minus2 b a)).
Definition half_det2 : twofold := product det2 (exactly (- bpow radix2 (-1))).
Definition turned2 (x : R) : R := if Rlt_bool (hi det2) 0 then - x else x.

Definition B_error2 : R := rnd (rnd (rnd (bpow radix2 (-99) * V_fl) * L1_fl) * L2_fl).
Definition C_error2 : R := rnd (rnd (rnd (bpow radix2 (-98) * Q_fl) * L1_fl) * L2_fl).
Definition margin_error2 : R := rnd (rnd ((9 * bpow radix2 (-101)) * V_fl) *
  rnd (rnd (L1_fl * L2_fl) + rnd (Q_fl * rnd (L1_fl + L2_fl)))).
Let f := triangulo p v V_fl a b c.

Local Opaque sum difference product ratio root_of opposite exactly.
Theorem recorded2 : Formas.B f = half_det2 /\ Formas.C f = crossing2 /\ Formas.B_error f = B_error2 /\
  Formas.C_error f = C_error2 /\ Formas.margin_error f = margin_error2 /\
  Formas.margin f = least (least (turned2 (hi ab2)) (turned2 (hi bc2))) (turned2 (hi ca2)).
Proof. repeat split. Qed.
Local Transparent sum difference product ratio root_of opposite exactly.

Let HV : 0 < V := V_positive v (v_not_zero ray_fits).
Let H1 : 0 <= L1 := extent_nonneg e1.
Let H2 : 0 <= L2 := extent_nonneg e2.
Let HQ : 0 <= Q := extent_nonneg q.
Let HVL : 0 <= V * (L1 * L2) := Rmult_le_pos _ _ (Rlt_le _ _ HV) (Rmult_le_pos _ _ H1 H2).
Let HQL : 0 <= Q * (L1 * L2) := Rmult_le_pos _ _ HQ (Rmult_le_pos _ _ H1 H2).

Let way_words x (Hx : ordinary_vec x) : words_close 0 (-152) (minus2 x a) (minus x a) := words_between x a Hx a_ordinary.
Let ray_words : words_close 0 (-152) (exactly2 v) v := words_of v (v_ordinary ray_fits).

Lemma det_worded : worded 5 (-456) det2 det (triple_size e1 v e2).
Proof. exact (triple_worded _ _ _ _ _ _ (way_words b b_ordinary) ray_words (way_words c c_ordinary)). Qed.
Lemma ab_worded : worded 5 (-456) ab2 ab (triple_size v q e1).
Proof. exact (triple_worded _ _ _ _ _ _ ray_words (way_words p (p_ordinary ray_fits)) (way_words b b_ordinary)). Qed.
Lemma ca_worded : worded 5 (-456) ca2 ca (triple_size q v e2).
Proof. exact (triple_worded _ _ _ _ _ _ (way_words p (p_ordinary ray_fits)) ray_words (way_words c c_ordinary)). Qed.
Lemma crossing_worded : worded 5 (-456) crossing2 crossing (triple_size e2 q e1).
Proof. exact (triple_worded _ _ _ _ _ _ (way_words c c_ordinary) (way_words p (p_ordinary ray_fits)) (way_words b
  b_ordinary)). Qed.
Lemma bc_worded : worded 7 (-456) bc2 (det - ca - ab) (triple_size e1 v e2 + triple_size q v e2 + triple_size v q e1).
Proof.
  apply (worded_minus 6); [lia | apply (worded_minus 5); [lia | exact det_worded | exact ca_worded]|].
  apply (worded_more 5); [lia | exact ab_worded].
Qed.

Lemma half_worded : worded 6 (-457) half_det2 (- det / 2) (triple_size e1 v e2 * / 2).
Proof.
  replace (- det / 2) with (det * - / 2) by field.
  apply (worded_mult 5 0 (-456) (-1)); [lia | exact det_worded|].
  replace (/ 2) with (bpow radix2 (-1)) by reflexivity.
  rewrite <- (Rabs_pos_eq (bpow radix2 (-1))) at 3 by apply bpow_ge_0; rewrite <- (Rabs_Ropp (bpow radix2 (-1))).
  apply worded_exactly; [apply generic_format_opp, format_bpow; lia | exists (-1)%Z; ring].
Qed.

Lemma B_error_low2 : 799 / 100 * (uu * (V * (L1 * L2))) <= B_error2.
Proof.
  pose proof (computed_mult 3 3 (-251) (-152) _ _ _ _ _ _ ltac:(lia) (computed_mult 0 2 (-99) (-152) _ _ _ _ _ _ ltac:(lia)
    (power_computed (-99) ltac:(lia)) (V_fl_computed p v ray_fits)) (L1_computed a b a_ordinary b_ordinary)) as Hc.
  pose proof (computed_mult 7 3 (-403) (-152) _ _ _ _ _ _ ltac:(lia) Hc (L2_computed a c a_ordinary c_ordinary)) as Hm.
  destruct (bound_low 11 _ _ _ ltac:(lia) Hm) as [Hl _]; fold B_error2 e1 e2 V L1 L2 in Hl.
  replace (bpow radix2 (-99)) with (8 * uu) in Hl by (replace 8 with (bpow radix2 3) by reflexivity; now rewrite <- bpow_plus).
  assert (0 <= uu * (V * (L1 * L2))) by (apply Rmult_le_pos; [apply bpow_ge_0 | exact HVL]); lra.
Qed.

Lemma C_error_low2 : 159 / 10 * (uu * (Q * (L1 * L2))) <= C_error2 /\ (C_error2 = 0 -> Q * (L1 * L2) = 0) /\
  (C_error2 <> 0 -> bpow radix2 (-554) <= C_error2).
Proof.
  pose proof (computed_mult 4 3 (-250) (-152) _ _ _ _ _ _ ltac:(lia) (computed_mult 0 3 (-98) (-152) _ _ _ _ _ _ ltac:(lia)
    (power_computed (-98) ltac:(lia)) (Q_computed p v a ray_fits a_ordinary)) (L1_computed a b a_ordinary b_ordinary)) as Hc.
  pose proof (computed_mult 8 3 (-402) (-152) _ _ _ _ _ _ ltac:(lia) Hc (L2_computed a c a_ordinary c_ordinary)) as Hm.
  destruct (bound_low 12 _ _ _ ltac:(lia) Hm) as (Hl & Hz & Hn); fold C_error2 e1 e2 q Q L1 L2 in Hl, Hz, Hn.
  pose proof uu_bounds as Hu.
  replace (bpow radix2 (-98)) with (16 * uu) in Hl, Hz by (replace 16 with (bpow radix2 4) by reflexivity;
    now rewrite <- bpow_plus).
  assert (0 <= uu * (Q * (L1 * L2))) by (apply Rmult_le_pos; [apply bpow_ge_0 | exact HQL]).
  split; [lra | split; [|exact Hn]]; intros Z0; specialize (Hz Z0); apply Rmult_eq_reg_l with (16 * uu); lra.
Qed.

Let M := L1 * L2 + Q * (L1 + L2).
Let HM : 0 <= M.
Proof. unfold M; pose proof (Rmult_le_pos _ _ H1 H2); pose proof (Rmult_le_pos Q (L1 + L2) HQ ltac:(lra)); lra. Qed.

Lemma margin_error_low2 : 179 / 10 * (uu * (V * M)) <= margin_error2.
Proof.
  assert (F9 : format (9 * bpow radix2 (-101))).
  { apply (generic_format_F2R radix2 _ 9 (-101)); intros _; unfold cexp, FLT_exp.
    rewrite (mag_unique_pos radix2 _ (-97)); [lia|]; unfold F2R; cbn [Fnum Fexp].
    pose proof (bpow_gt_0 radix2 (-101)); change (-97)%Z with (4 + -101)%Z; change (4 + -101 - 1)%Z with (3 + -101)%Z.
    rewrite !bpow_plus; replace (bpow radix2 3) with 8 by reflexivity; replace (bpow radix2 4) with 16 by reflexivity; lra. }
  pose proof (L1_computed a b a_ordinary b_ordinary) as C1; pose proof (L2_computed a c a_ordinary c_ordinary) as C2.
  pose proof (computed_mult 0 2 (-101) (-152) _ _ _ _ _ _ ltac:(lia) (constant_computed 9 (-101) ltac:(lia) F9 ltac:(lia))
    (V_fl_computed p v ray_fits)) as HU.
  pose proof (computed_mult 3 3 (-152) (-152) _ _ _ _ _ _ ltac:(lia) C1 C2) as HLL.
  pose proof (computed_mult 3 4 (-152) (-152) _ _ _ _ _ _ ltac:(lia) (Q_computed p v a ray_fits a_ordinary)
    (computed_plus 3 (-152) _ _ _ _ _ _ ltac:(lia) C1 C2)) as HQL'.
  pose proof (computed_plus 8 (-304) _ _ _ _ _ _ ltac:(lia) (computed_more 7 8 _ _ _ _ ltac:(lia) HLL) HQL') as HM'.
  pose proof (computed_mult 3 9 (-253) (-304) _ _ _ _ _ _ ltac:(lia) HU HM') as Hm.
  destruct (bound_low 13 _ _ _ ltac:(lia) Hm) as [Hl _]; fold margin_error2 e1 e2 q V L1 L2 Q in Hl; fold M in Hl.
  replace (9 * bpow radix2 (-101)) with (18 * uu) in Hl by (replace (bpow radix2 (-101)) with (2 * uu); [ring |
    replace 2 with (bpow radix2 1) by reflexivity; now rewrite <- bpow_plus]).
  assert (0 <= uu * (V * M)) by (apply Rmult_le_pos; [apply bpow_ge_0 | apply Rmult_le_pos; lra]); lra.
Qed.

Lemma half_near : Rabs (whole half_det2 - - det / 2) <= / 2 * B_error2.
Proof.
  pose proof (worded_error 6 _ _ _ _ ltac:(lia) half_worded) as He; simpl INR in He; pose proof B_error_low2 as LB.
  pose proof (triple_size_le e1 v e2 : _ <= L1 * (V * L2)) as S1; pose proof uu_bounds.
  assert (uu * triple_size e1 v e2 <= uu * (L1 * (V * L2))) by (apply Rmult_le_compat_l; lra).
  assert (0 <= uu * (V * (L1 * L2))) by (apply Rmult_le_pos; lra).
  apply Rle_trans with (1 := He); lra.
Qed.

Lemma half_det_size : Rabs (2 * hi half_det2) <= bpow radix2 310.
Proof.
  pose proof (worded_size 6 _ _ _ _ ltac:(lia) half_worded) as Hs; rewrite Rabs_mult, (Rabs_pos_eq 2) by lra.
  pose proof (triple_size_le e1 v e2 : _ <= L1 * (V * L2)) as S1; pose proof (V_size v (v_ordinary ray_fits) : V <= _) as V102.
  pose proof (proj2 (extent_of_difference b a b_ordinary a_ordinary) : L1 <= _) as L103.
  pose proof (proj2 (extent_of_difference c a c_ordinary a_ordinary) : L2 <= _) as L103'.
  assert (Hprod : L1 * (V * L2) <= bpow radix2 308).
  { change 308%Z with (103 + (102 + 103))%Z; rewrite !bpow_plus; repeat apply Rmult_le_compat; try apply Rmult_le_pos; lra. }
  change 310%Z with (2 + 308)%Z; rewrite bpow_plus; replace (bpow radix2 2) with 4 by reflexivity.
  pose proof (bpow_gt_0 radix2 308); lra.
Qed.

Theorem triangle_sound2 : sound_flat2 f (- det / 2) crossing.
Proof.
  destruct recorded2 as (EB & EC & EBe & ECe & _); pose proof uu_bounds as Hu; destruct C_error_low2 as (LC & ZC & NC).
  pose proof (triple_size_le e2 q e1 : _ <= L2 * (Q * L1)) as S2.
  assert (Hratio : bpow radix2 (-900) * Rabs (2 * hi half_det2) <= bpow radix2 (-554)).
  { apply Rle_trans with (bpow radix2 (-900) * bpow radix2 310); [apply Rmult_le_compat_l; [apply bpow_ge_0 |
      exact half_det_size]|]; rewrite <- bpow_plus; apply bpow_le; lia. }
  constructor; rewrite ?EB, ?EC, ?EBe, ?ECe.
  - split; [apply half_worded | apply crossing_worded].
  - pose proof half_near; assert (0 <= B_error2) by (apply Rle_trans with (2 := B_error_low2), Rmult_le_pos; [lra|];
      apply Rmult_le_pos; lra); lra.
  - pose proof (worded_error 5 _ _ _ _ ltac:(lia) crossing_worded) as He; simpl INR in He.
    assert (uu * triple_size e2 q e1 <= uu * (L2 * (Q * L1))) by (apply Rmult_le_compat_l; lra).
    assert (0 <= uu * (Q * (L1 * L2))) by (apply Rmult_le_pos; lra).
    apply Rle_trans with (2 := LC), Rle_trans with (1 := He); lra.
  - split; apply format_rnd.
  - destruct (Req_dec C_error2 0) as [Z0|N]; [left | right].
    + split; [exact Z0|]; specialize (ZC Z0); destruct crossing_worded as ((_ & Hm) & _).
      pose proof (Rabs_pos crossing); destruct (Req_dec crossing 0) as [|Nz]; [assumption | pose proof (Rabs_pos_lt _ Nz); lra].
    + specialize (NC N); split; [apply Rle_trans with (2 := NC), bpow_le; lia | lra].
  - destruct crossing_worded as (_ & _ & G & _); destruct (Req_dec (hi crossing2) 0) as [Z0|N]; [now left | right].
    pose proof (grid_at_least _ _ G N) as Hl; split; [apply Rle_trans with (2 := Hl), bpow_le; lia|].
    apply Rle_trans with (1 := Hratio), Rle_trans with (2 := Hl), bpow_le; lia.
Qed.

(** ** The margin *)

Definition margin2 : R := Rmin (Rmin (turned2 ab) (turned2 (det - ca - ab))) (turned2 ca).

Lemma sides_near : Rabs (whole ab2 - ab) <= margin_error2 /\ Rabs (whole bc2 - (det - ca - ab)) <= margin_error2 /\
  Rabs (whole ca2 - ca) <= margin_error2.
Proof.
  pose proof uu_bounds as Hu; pose proof margin_error_low2 as LM.
  pose proof (triple_size_le e1 v e2 : _ <= L1 * (V * L2)) as S1; pose proof (triple_size_le q v e2 : _ <= Q * (V * L2)) as S2.
  pose proof (triple_size_le v q e1 : _ <= V * (Q * L1)) as S3.
  assert (HVQ2 : 0 <= V * (Q * L2)) by (repeat apply Rmult_le_pos; lra).
  assert (HVQ1 : 0 <= V * (Q * L1)) by (repeat apply Rmult_le_pos; lra).
  assert (EM : V * M = V * (L1 * L2) + V * (Q * L1) + V * (Q * L2)) by (unfold M; ring).
  assert (Hone : forall n x2 x s, (n <= 7)%nat -> worded n (-456) x2 x s -> s <= V * M -> Rabs (whole x2 - x) <= margin_error2).
  { intros n x2 x s Hn Hc Hs; pose proof (worded_error 7 _ _ _ _ ltac:(lia) (worded_more n 7 _ _ _ _ Hn Hc)) as He.
    simpl INR in He; apply Rle_trans with (1 := He), Rle_trans with (2 := LM).
    assert (uu * s <= uu * (V * M)) by (apply Rmult_le_compat_l; lra).
    assert (0 <= uu * (V * M)) by (apply Rmult_le_pos; lra); lra. }
  split; [|split].
  - apply (Hone 5%nat _ _ _ ltac:(lia) ab_worded); lra.
  - apply (Hone 7%nat _ _ _ ltac:(lia) bc_worded); lra.
  - apply (Hone 5%nat _ _ _ ltac:(lia) ca_worded); lra.
Qed.

Lemma turned_tells w x : double_word w -> Rabs (whole w - x) <= margin_error2 -> tells (turned2 (hi w)) margin_error2 (turned2 x).
Proof.
  intros W N; pose proof (word_tells w x margin_error2 W (format_rnd _) N) as T; unfold turned2.
  destruct (Rlt_bool (hi det2) 0); [now apply tells_opposite | exact T].
Qed.

Theorem margin_signs2 : tells (Formas.margin f) (Formas.margin_error f) margin2.
Proof.
  destruct recorded2 as (_ & _ & _ & _ & -> & ->), sides_near as (Nab & Nbc & Nca).
  apply tells_least; [apply tells_least|]; apply turned_tells; auto; [apply ab_worded | apply bc_worded | apply ca_worded].
Qed.

(** Where B is known not to be 0, the leading part of det has the sign of det. *)
Lemma det_signs2 : flat_known f = true -> det <> 0 /\ (hi det2 < 0 -> det < 0) /\ (0 <= hi det2 -> 0 < det).
Proof.
  intros K; destruct (known_means f _ _ triangle_sound2 K) as [Hbig HB]; destruct recorded2 as (EB & _ & EBe & _).
  rewrite EB, EBe in Hbig; pose proof half_near as NH; pose proof B_error_low2 as LB; pose proof uu_bounds as Hu.
  destruct half_worded as (_ & WH & _), det_worded as (_ & WD & _).
  pose proof (worded_error 5 _ _ _ _ ltac:(lia) det_worded) as He; simpl INR in He.
  pose proof (triple_size_le e1 v e2 : _ <= L1 * (V * L2)) as S1.
  assert (uu * triple_size e1 v e2 <= uu * (L1 * (V * L2))) by (apply Rmult_le_compat_l; lra).
  assert (0 <= uu * (V * (L1 * L2))) by (apply Rmult_le_pos; lra).
  assert (Hd : Rabs (whole det2 - det) <= 7 / 10 * B_error2) by (apply Rle_trans with (1 := He); lra).
  assert (Hbig' : 19 / 10 * B_error2 <= Rabs (whole half_det2)).
  { destruct (word_near _ WH) as [_ Hh]; pose proof (u_part _ (Rabs_pos (hi half_det2))).
    pose proof (size_least (whole half_det2) (hi half_det2)) as Hs; rewrite Rabs_minus_sym in Hs; lra. }
  assert (Hdet : 28 / 10 * B_error2 <= Rabs det /\ det <> 0).
  { split; [|lra]; pose proof (size_least (- det / 2) (whole half_det2)) as Hs; rewrite Rabs_minus_sym in Hs.
    replace (Rabs det) with (2 * Rabs (- det / 2)); [lra|].
    unfold Rdiv; rewrite Rabs_mult, Rabs_Ropp, (Rabs_pos_eq (/ 2)) by lra; field. }
  destruct Hdet as [Hdet N]; apply Rabs_le_inv in Hd; split; [exact N | split; intros S].
  - apply (word_below _ _ WD (generic_format_0 _ _)) in S; apply Rnot_le_lt; intros P; rewrite Rabs_pos_eq in Hdet by exact P; lra.
  - assert (S' : 0 <= whole det2).
    { destruct (word_near _ WD) as [_ Hn]; pose proof (u_part _ S); rewrite (Rabs_pos_eq (hi det2)) in Hn by exact S.
      apply Rabs_le_inv in Hn; lra. }
    apply Rnot_le_lt; intros P; rewrite Rabs_left1 in Hdet by exact P; lra.
Qed.

Lemma margin_tells2 : flat_known f = true ->
  det <> 0 /\ (0 <= margin2 <-> 0 <= ab * det /\ 0 <= (det - ca - ab) * det /\ 0 <= ca * det).
Proof.
  intros K; destruct (det_signs2 K) as (N & Low & High); split; [exact N|].
  assert (Hsign : forall x y, 0 < y -> (0 <= x <-> 0 <= x * y)).
  { intros x y Hy; split; intros Hx; [apply Rmult_le_pos; lra|]; apply Rmult_le_reg_r with y; lra. }
  assert (Hmin : forall x y z, 0 <= Rmin (Rmin x y) z <-> 0 <= x /\ 0 <= y /\ 0 <= z).
  { intros x y z; unfold Rmin; destruct (Rle_dec x y), (Rle_dec _ z); lra. }
  unfold margin2, turned2; rewrite Hmin; destruct (Rlt_bool_spec (hi det2) 0) as [S|S].
  - assert (Hd : 0 < - det) by (specialize (Low S); lra).
    rewrite (Hsign (- ab) _ Hd), (Hsign (- (det - ca - ab)) _ Hd), (Hsign (- ca) _ Hd); rewrite !Rmult_opp_opp; tauto.
  - pose proof (High S) as Hd; rewrite (Hsign ab _ Hd), (Hsign (det - ca - ab) _ Hd), (Hsign ca _ Hd); tauto.
Qed.
End Triangle.

Theorem stable_triangle_right p v a b c limit : fit_ray p v -> ordinary_vec a -> ordinary_vec b -> ordinary_vec c ->
  format limit ->
  let f := triangulo p v (extent_fl v) a b c in let text := of_triangulo (ray_of p v) (vertices a b c) in
  right_pair (reach text) limit (first_of_linear_edged f limit) /\
  right_pair (reach (launched text)) limit (first_of_linear_on f limit).
Proof.
  intros Hray Ha Hb Hc Fl f text; pose proof (triangle_sound2 p v a b c Hray Ha Hb Hc) as S.
  destruct (margin_signs2 p v a b c Hray Ha Hb Hc) as [Low High].
  apply (edged_pair _ (- det v a b c / 2) (crossing p a b c) S) with (m := margin2 p v a b c); auto.
  - intros t; unfold text, det, crossing, vertices, ray_of, point, direction, value, of_triangulo, normal, Puntos.cross,
      Tipos.dot, from, dot, cross, minus; cbn; field.
  - intros t; unfold text, det, vertices, ray_of, point, direction, value, launched, of_triangulo, normal, Puntos.cross,
      Tipos.dot, from, dot, cross, minus; cbn; field.
  - intros K t Ht; destruct (margin_tells2 p v a b c Hray Ha Hb Hc K) as [Hd ->].
    unfold text; rewrite <- (prisma_along (ray_of p v) (vertices a b c) t).
    assert (E : t = crossing p a b c / det v a b c).
    { apply Rmult_eq_reg_l with (det v a b c); [field_simplify; lra | exact Hd]. }
    pose proof (Flat.clip_of_the_program (ray_of p v) (vertices a b c) Hd) as Hclip; symmetry in Hclip; rewrite E; exact Hclip.
Qed.
