(** * StableAcross: what is left across an axis, in double-double

    Across.v over pairs, and what a cylinder and a cone share of their quadratics: with q = p - centro, a = v - (v·d)·d and
    b = q - (q·d)·d, the products a·a, b·a and b·b, and the distance |b × a| of the line.

    across2, a2, b2, line2 == the vectors, and that distance, as they are computed
    near_by i w x m        == w is a pair within i units of x, and x at most m *)
From Coq Require Import Reals ZArith Lra Lia Psatz.
From Flocq Require Import Core.
From Durero Require Import Rounding Vectors Across Flotante Twofold Sums Products Ratios Words Small Stable StableVectors
  StableAdvance.
From Durero Require Formas.
Import Formas.Pairs.
Local Open Scope R_scope.
Local Opaque bpow.

Definition across2 (x : vec2) (s : twofold) (d : vec2) : vec2 :=
  Vec2 (difference (dx x) (product s (dx d))) (difference (dy x) (product s (dy d))) (difference (dz x) (product s (dz d))).

(** x is exact; what is left of it is off by 10 units of x, to first order. *)
Lemma across2_computed x2 x d : words_close 0 (-152) x2 x -> on_grid (-152) d -> dot d d <= 1 + / 1000000 ->
  let y := across2 x2 (dot2 x2 (exactly2 d)) (exactly2 d) in
  words_on (-456) y /\ norm (minus (wholes y) (across x d)) <= 1002 / 100 * (uu * norm x).
Proof.
  intros Hx Hd Hdd y; pose proof (words_exactly _ _ Hd) as (Dx & Dy & Dz).
  pose proof (dot2_worded 0 0 (-152) (-152) x2 (exactly2 d) x d ltac:(lia) Hx (words_exactly _ _ Hd)) as Hs.
  destruct Hx as (X & Y & Z0); set (s := size_of_dot x d) in *; set (s2 := dot2 x2 (exactly2 d)) in *.
  assert (Hone : forall a b z e, worded 0 (-152) a z (Rabs z) -> worded 0 (-152) b e (Rabs e) ->
    worded 5 (-456) (difference a (product s2 b)) (z - dot x d * e) (Rabs z + s * Rabs e)).
  { intros a b z e (Na & Wa & Ga) Hb; apply (worded_minus 4);
    [lia | | exact (worded_mult 3 0 (-304) (-152) _ _ _ _ _ _ ltac:(lia) Hs Hb)].
    apply (worded_more 0); [lia|]; split; [exact Na | split; [exact Wa|]]; destruct Ga as [Gh Gl].
    split; now apply (grid_coarser (-456) (-152)). }
  pose proof (Hone _ _ _ _ X Dx) as CX; pose proof (Hone _ _ _ _ Y Dy) as CY; pose proof (Hone _ _ _ _ Z0 Dz) as CZ.
  split; [destruct CX as (_ & ? & ?), CY as (_ & ? & ?), CZ as (_ & ? & ?); unfold words_on, y, across2; cbn [dx dy dz];
    tauto|].
  pose proof uu_bounds as Hu; set (k := 1001 / 1000 * INR 5 * uu).
  assert (Hk : k = 5005 / 1000 * uu) by (unfold k; simpl INR; field).
  apply (worded_error 5 _ _ _ _ ltac:(lia)) in CX, CY, CZ; fold k in CX, CY, CZ.
  apply Rle_trans with (norm (scale k (plus (magnitudes x) (scale s (magnitudes d))))).
  - apply norm_mono; cbn; assumption.
  - rewrite norm_scale, (Rabs_pos_eq k) by lra; pose proof (norm_plus (magnitudes x) (scale s (magnitudes d))) as Hp.
    rewrite norm_scale, !norm_magnitudes, (Rabs_pos_eq s) in Hp by apply size_nonneg.
    pose proof (norm_nonneg x) as Hx0; pose proof (norm_nonneg d) as Hd0; pose proof (size_le x d : s <= _) as Hs1.
    assert (s * norm d <= norm x * dot d d).
    { rewrite <- norm_square, <- Rmult_assoc; apply Rmult_le_compat_r; assumption. }
    assert (norm x * dot d d <= norm x * (1 + / 1000000)) by (apply Rmult_le_compat_l; lra).
    apply Rle_trans with (k * ((2 + / 1000000) * norm x)); [apply Rmult_le_compat_l; lra|].
    rewrite Hk; assert (0 <= uu * norm x) by (apply Rmult_le_pos; lra); lra.
Qed.

(** A product of two vectors that are off, and rounded: x and y are of sizes X and Y, and off by i and j units. *)
Lemma dot_off2 i j x x2 y y2 X Y : words_on (-456) x2 -> words_on (-456) y2 -> 0 <= i <= 16 -> 0 <= j <= 16 ->
  0 <= X -> 0 <= Y ->
  norm x <= X -> norm y <= Y -> norm (minus (wholes x2) x) <= i * (uu * X) -> norm (minus (wholes y2) y) <= j * (uu * Y) ->
  Rabs (whole (dot2 x2 y2) - dot x y) <= (i + j + 302 / 100) * (uu * (X * Y)) /\ double_word (dot2 x2 y2) /\
  parts_on (-912) (dot2 x2 y2) /\ Rabs (dot x y) <= X * Y.
Proof.
  intros Ox Oy Hi Hj HX HY Nx Ny Dx Dy; pose proof uu_bounds as Hu.
  assert (Hsmall : forall Z, 0 <= Z -> 0 <= uu * Z <= e30 * Z) by (intros Z HZ; split;
    [apply Rmult_le_pos | apply Rmult_le_compat_r]; lra).
  pose proof (Hsmall X HX) as HuX; pose proof (Hsmall Y HY) as HuY; pose proof (Rmult_le_pos _ _ HX HY) as HXY.
  assert (HiX : i * (uu * X) <= 16 * (uu * X)) by (apply Rmult_le_compat_r; lra).
  assert (HjY : j * (uu * Y) <= 16 * (uu * Y)) by (apply Rmult_le_compat_r; lra).
  pose proof (norm_between (wholes x2) x) as Bx; pose proof (norm_between (wholes y2) y) as By.
  pose proof (dot2_worded 0 0 (-456) (-456) _ _ _ _ ltac:(lia) (words_close_self _ _ Ox) (words_close_self _ _ Oy)) as Hc.
  set (x' := wholes x2) in *; set (y' := wholes y2) in *.
  assert (Hs : size_of_dot x' y' <= 1001 / 1000 * (X * Y)).
  { apply Rle_trans with (1 := size_le _ _); apply Rle_trans with (10001 / 10000 * X * (10001 / 10000 * Y)); [|lra].
    apply Rmult_le_compat; auto using norm_nonneg; lra. }
  pose proof (worded_error 3 _ _ _ _ ltac:(lia) Hc) as He; simpl INR in He; destruct Hc as (_ & W & G).
  pose proof (Hsmall _ HXY) as HuXY.
  assert (uu * size_of_dot x' y' <= uu * (1001 / 1000 * (X * Y))) by (apply Rmult_le_compat_l; lra).
  assert (Ho : Rabs (dot x' y' - dot x y) <= (i + j + / 500) * (uu * (X * Y))).
  { replace (dot x' y' - dot x y) with (dot (minus x' x) y' + dot x (minus y' y)) by (unfold dot, minus; cbn; ring).
    apply Rle_trans with (1 := Rabs_triang _ _).
    assert (Rabs (dot (minus x' x) y') <= i * (uu * X) * (10001 / 10000 * Y)).
    { apply Rle_trans with (1 := dot_le _ _); apply Rmult_le_compat; auto using norm_nonneg; lra. }
    assert (Rabs (dot x (minus y' y)) <= X * (j * (uu * Y))).
    { apply Rle_trans with (1 := dot_le _ _); apply Rmult_le_compat; auto using norm_nonneg. }
    assert (i * (uu * (X * Y)) <= 16 * (uu * (X * Y))) by (apply Rmult_le_compat_r; lra).
    assert (i * (uu * X) * (10001 / 10000 * Y) = 10001 / 10000 * (i * (uu * (X * Y)))) by field.
    assert (X * (j * (uu * Y)) = j * (uu * (X * Y))) by ring; lra. }
  split; [|split; [exact W | split; [exact G|]]].
  - replace (whole (dot2 x2 y2) - dot x y) with ((whole (dot2 x2 y2) - dot x' y') + (dot x' y' - dot x y)) by ring.
    apply Rle_trans with (1 := Rabs_triang _ _); lra.
  - apply Rle_trans with (1 := dot_le _ _); apply Rmult_le_compat; auto using norm_nonneg.
Qed.

Section Across.
Variables p v centro d : vec.
Hypothesis ray_fits : fit_ray p v.
Hypothesis axis_fits : fit_axis centro d.
Let q := minus p centro.
Let a := across v d.
Let b := across q d.
Let Q := extent q.
Let V := extent v.
Definition a2 : vec2 := across2 (exactly2 v) (s1_2 v d) (exactly2 d).
Definition b2 : vec2 := across2 (minus2 p centro) (s0_2 p centro d) (exactly2 d).
Definition line2 : twofold := norm2 (cross2 b2 a2).

Let HV : 0 < V := V_positive v (v_not_zero ray_fits).
Let HQ : 0 <= Q := extent_nonneg q.

Lemma facts2 x2 x : words_close 0 (-152) x2 x -> let y := across2 x2 (dot2 x2 (exactly2 d)) (exactly2 d) in
  words_on (-456) y /\ norm (minus (wholes y) (across x d)) <= 1002 / 100 * (uu * extent x) /\ norm (across x d) <= extent x /\
  norm (wholes y) <= 10001 / 10000 * extent x.
Proof.
  intros Hx y; pose proof (unit_square d (d_unit axis_fits)) as Hdd; pose proof (across_size x d (d_unit axis_fits)) as Sa.
  destruct (across2_computed x2 x d Hx (ordinary_on_grid d (d_ordinary axis_fits)) Hdd) as [On N]; fold y in On, N.
  pose proof uu_bounds; pose proof (extent_nonneg x); pose proof (norm_between (wholes y) (across x d)).
  assert (uu * norm x <= uu * extent x) by (apply Rmult_le_compat_l; [lra | apply norm_le_extent]).
  assert (uu * extent x <= e30 * extent x) by (apply Rmult_le_compat_r; lra).
  split; [exact On|]; split; [lra|]; split; [exact Sa | lra].
Qed.
Lemma a_facts2 : words_on (-456) a2 /\ norm (minus (wholes a2) a) <= 1002 / 100 * (uu * V) /\ norm a <= V /\
  norm (wholes a2) <= 10001 / 10000 * V.
Proof. exact (facts2 _ v (words_of v (v_ordinary ray_fits))). Qed.
Lemma b_facts2 : words_on (-456) b2 /\ norm (minus (wholes b2) b) <= 1002 / 100 * (uu * Q) /\ norm b <= Q /\
  norm (wholes b2) <= 10001 / 10000 * Q.
Proof. exact (facts2 _ q (words_between p centro (p_ordinary ray_fits) (centro_ordinary axis_fits))). Qed.

Definition near_by (i : R) (w : twofold) (x m : R) : Prop :=
  Rabs (whole w - x) <= i * (uu * m) /\ double_word w /\ parts_on (-912) w /\ Rabs x <= m.

Lemma products_near : near_by (2307 / 100) (dot2 a2 a2) (dot a a) (V * V) /\ near_by (2307 / 100) (dot2 b2 a2) (dot b a)
  (Q * V) /\
  near_by (2307 / 100) (dot2 b2 b2) (dot b b) (Q * Q).
Proof.
  destruct a_facts2 as (Oa & Na & Sa & _), b_facts2 as (Ob & Nb & Sb & _); unfold near_by.
  replace (2307 / 100) with (1002 / 100 + 1002 / 100 + 302 / 100 + / 100) by lra; pose proof uu_bounds as Hu.
  assert (More : forall X Y i w, 0 <= X -> 0 <= Y -> w <= i * (uu * (X * Y)) -> w <= (i + / 100) * (uu * (X * Y))).
  { intros X Y i w HX HY Hw; assert (0 <= uu * (X * Y)) by (repeat apply Rmult_le_pos; lra); lra. }
  pose proof (dot_off2 (1002 / 100) (1002 / 100) a a2 a a2 V V Oa Oa ltac:(lra) ltac:(lra) ltac:(lra)
    ltac:(lra) Sa Sa Na Na) as (A1 & A2 & A3 & A4).
  pose proof (dot_off2 (1002 / 100) (1002 / 100) b b2 a a2 Q V Ob Oa ltac:(lra) ltac:(lra) HQ ltac:(lra) Sb Sa Nb Na) as
    (B1 & B2 & B3 & B4).
  pose proof (dot_off2 (1002 / 100) (1002 / 100) b b2 b b2 Q Q Ob Ob ltac:(lra) ltac:(lra) HQ HQ Sb Sb Nb Nb) as
    (C1 & C2 & C3 & C4).
  apply (More _ _ _ _ (Rlt_le _ _ HV) (Rlt_le _ _ HV)) in A1; apply (More _ _ _ _ HQ (Rlt_le _ _ HV)) in B1.
  apply (More _ _ _ _ HQ HQ) in C1.
  exact (conj (conj A1 (conj A2 (conj A3 A4))) (conj (conj B1 (conj B2 (conj B3 B4))) (conj C1 (conj C2 (conj C3 C4))))).
Qed.

Lemma line_near2 : Rabs (whole line2 - norm (cross b a)) <= 345 / 10 * (uu * (Q * V)) + bpow radix2 (-450) /\
  double_word line2 /\ 0 <= whole line2 /\ norm (cross b a) <= Q * V.
Proof.
  destruct a_facts2 as (Oa & Na & Sa & Sa'), b_facts2 as (Ob & Nb & Sb & Sb'); pose proof uu_bounds as Hu.
  assert (HQV : 0 <= Q * V) by (apply Rmult_le_pos; lra); set (m := uu * (Q * V)).
  assert (Hm : 0 <= m <= e30 * (Q * V)) by (split; [apply Rmult_le_pos | apply Rmult_le_compat_r]; lra).
  set (x := cross2 b2 a2); set (a' := wholes a2) in *; set (b' := wholes b2) in *; set (y := cross b' a').
  assert (Hprod : norm b' * norm a' <= 1001 / 1000 * (Q * V)).
  { apply Rle_trans with (10001 / 10000 * Q * (10001 / 10000 * V)); [apply Rmult_le_compat; auto using norm_nonneg | lra]. }
  (* Each component of the product loses two operations; of the magnitudes, too, there is such a product. *)
  pose proof (words_close_self _ _ Oa) as (Ax & Ay & Az); pose proof (words_close_self _ _ Ob) as (Bx & By & Bz).
  assert (Hone : forall s2 t2 s2' t2' s t s' t', worded 0 (-456) s2 s (Rabs s) -> worded 0 (-456) t2 t (Rabs t) ->
    worded 0 (-456) s2' s' (Rabs s') -> worded 0 (-456) t2' t' (Rabs t') ->
    worded 2 (-912) (difference (product s2 t2) (product s2' t2')) (s * t - s' * t') (Rabs s * Rabs t + Rabs s' * Rabs t')).
  { intros; apply (worded_minus 1 (-912)); [lia | |]; apply (worded_mult 0 0 (-456) (-456)); auto; lia. }
  pose proof (Hone _ _ _ _ _ _ _ _ By Az Bz Ay) as X; pose proof (Hone _ _ _ _ _ _ _ _ Bz Ax Bx Az) as Y.
  pose proof (Hone _ _ _ _ _ _ _ _ Bx Ay By Ax) as Z0; clear Hone Ax Ay Az Bx By Bz.
  assert (Wx : double_word (dx x) /\ double_word (dy x) /\ double_word (dz x)) by (split; [apply X | split;
    [apply Y | apply Z0]]).
  apply (worded_error 2 _ _ _ _ ltac:(lia)) in X, Y, Z0; simpl INR in X, Y, Z0.
  assert (Hround : norm (minus (wholes x) y) <= 61 / 10 * m).
  { assert (Hpair : forall i j k l s t, i * i + j * j + s * s <= dot b' b' -> k * k + l * l + t * t <= dot a' a' ->
      Rabs i * Rabs l + Rabs j * Rabs k <= norm b' * norm a').
    { intros i j k l s t H1 H2.
      pose proof (size_le (Vec i j s) (Vec l k t)) as Hle; unfold size_of_dot in Hle; cbn in Hle.
      assert (norm (Vec i j s) <= norm b') by (apply sqrt_le_1_alt; exact H1).
      assert (norm (Vec l k t) <= norm a') by (apply sqrt_le_1_alt; change (l * l + k * k + t * t <= dot a' a'); lra).
      pose proof (Rmult_le_compat _ _ _ _ (norm_nonneg (Vec i j s)) (norm_nonneg (Vec l k t)) ltac:(eassumption)
        ltac:(eassumption)).
      pose proof (Rmult_le_pos _ _ (Rabs_pos s) (Rabs_pos t)); lra. }
    pose proof (Hpair (cy b') (cz b') (cy a') (cz a') (cx b') (cx a') ltac:(unfold dot; lra) ltac:(unfold dot; lra)) as HX.
    pose proof (Hpair (cz b') (cx b') (cz a') (cx a') (cy b') (cy a') ltac:(unfold dot; lra) ltac:(unfold dot; lra)) as HY.
    pose proof (Hpair (cx b') (cy b') (cx a') (cy a') (cz b') (cz a') ltac:(unfold dot; lra) ltac:(unfold dot; lra)) as HZ.
    apply Rle_trans with (1 := norm_le_extent _);
      apply Rle_trans with (1 := Rplus_le_compat _ _ _ _ (Rplus_le_compat _ _ _ _ X Y) Z0).
    set (n := norm b' * norm a') in *; assert (Hun : uu * n <= uu * (1001 / 1000 * (Q * V))) by (apply Rmult_le_compat_l;
      lra).
    assert (Up : forall t, t <= n -> 1001 / 1000 * (1 + 1) * uu * t <= 2002 / 1000 * (uu * n)).
    { intros t Ht; assert (uu * t <= uu * n) by (apply Rmult_le_compat_l; lra); lra. }
    apply Rle_trans with (1 := Rplus_le_compat _ _ _ _ (Rplus_le_compat _ _ _ _ (Up _ HX) (Up _ HY)) (Up _ HZ));
      unfold m in *; lra. }
  clear X Y Z0.
  assert (Hoff : norm (minus y (cross b a)) <= 2005 / 100 * m).
  { replace (minus y (cross b a)) with (plus (cross (minus b' b) a') (cross b (minus a' a)))
      by (unfold y, plus, minus, cross; cbn; f_equal; ring).
    apply Rle_trans with (1 := norm_plus _ _).
    assert (norm (cross (minus b' b) a') <= 1002 / 100 * (uu * Q) * (10001 / 10000 * V)).
    { apply Rle_trans with (1 := cross_le _ _); apply Rmult_le_compat; auto using norm_nonneg. }
    assert (norm (cross b (minus a' a)) <= Q * (1002 / 100 * (uu * V))).
    { apply Rle_trans with (1 := cross_le _ _); apply Rmult_le_compat; auto using norm_nonneg. }
    unfold m in *; lra. }
  destruct (norm2_any x (proj1 Wx) (proj1 (proj2 Wx)) (proj2 (proj2 Wx))) as (WL & Hn & HL0);
    change (norm2 x) with line2 in *.
  pose proof (norm_between (wholes x) y); pose proof (norm_between y (wholes x)) as Bk1; rewrite norm_symmetric in Bk1.
  pose proof (norm_between y (cross b a)); pose proof (norm_between (cross b a) y) as Bk2; rewrite norm_symmetric in Bk2.
  assert (Hc : norm (cross b a) <= Q * V) by (apply Rle_trans with (1 := cross_le _ _); apply Rmult_le_compat;
    auto using norm_nonneg).
  assert (uu * norm (wholes x) <= uu * (101 / 100 * (Q * V))) by (apply Rmult_le_compat_l; lra).
  split; [|auto]; apply Rabs_le_inv in Hn; apply Rabs_le; unfold m in *; lra.
Qed.
End Across.
