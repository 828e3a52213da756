(** * Cylinder: what the tracer computes of a cylinder in binary64 is within its bounds

    trace/shape/cylinder-inl.hpp computes, with q = p - centro, d = vector, a = v - (v·d)·d and b = q - (q·d)·d:
      A = a·a,  B = b·a,  C = b·b - r²,  F, H = r|a| ∓ |b × a|  (√A for |a|)
    with the bounds of a sphere of the same centre and radius. Formas.cilindro is this ([recorded]), and its bounds hold for
    ordinary numbers and an axis whose square is within a millionth of 1, as the text's is within 2^-50. *)
From Coq Require Import Reals ZArith Lra Lia Psatz.
From Flocq Require Import Core.
From Durero Require Import Rounding Vectors Across Decision Flotante.
From Durero Require Formas.
Local Open Scope R_scope.
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
Let E := extent q + r.
Notation q_fl := (q_fl p centro).
Notation V_fl := (V_fl v).
Notation E_fl := (E_fl p centro r).
Notation A_error := (A_error v).
Notation B_error := (B_error p v centro r).
Notation C_error := (C_error p centro r).

Let a_fl := across_fl v d.
Let b_fl := across_fl q_fl d.
Definition A_fl : R := dot_fl a_fl a_fl.
Definition B_fl : R := dot_fl b_fl a_fl.
Definition C_fl : R := rnd (dot_fl b_fl b_fl - rnd (r * r)).
Definition of_surface : R := rnd (r * norm_fl a_fl).
Definition of_line : R := norm_fl (cross_fl b_fl a_fl).

Theorem recorded : Formas.cilindro p v V_fl centro r d h =
  Formas.Quadratic A_fl B_fl C_fl (rnd (of_surface - of_line)) (rnd (of_surface + of_line)) A_error B_error C_error
    (dot_fl q_fl d) (dot_fl v d) h (rnd (extent_fl q_fl + h)) V_fl 0 0.
Proof. exact_no_check (eq_refl (Formas.cilindro p v V_fl centro r d h)). Qed. (* compared by Qed, once *)

(** ** The vectors across the axis, exact and computed *)

Lemma a_size : norm a <= V. Proof. exact (across_size v d (d_unit axis_fits)). Qed.
Lemma b_size : norm b <= extent q. Proof. exact (across_size q d (d_unit axis_fits)). Qed.

Lemma a_computed : on_grid (-456) a_fl /\ norm (minus a_fl a) <= 1006 / 100 * u * V.
Proof.
  destruct (across_computed 0 v v d ltac:(lia) (v_close v (v_ordinary ray_fits)) (ordinary_on_grid d (d_ordinary axis_fits))
    (unit_square d (d_unit axis_fits))) as [G N].
  split; [exact G|]; apply Rle_trans with (1 := N); simpl INR; pose proof u_bounds; pose proof (norm_le_extent v : _ <= V).
  assert (u * norm v <= u * V) by (apply Rmult_le_compat_l; lra).
  pose proof (Rmult_le_pos u V ltac:(lra) (extent_nonneg v)); lra.
Qed.

Lemma b_computed : on_grid (-456) b_fl /\ norm (minus b_fl b) <= 1207 / 100 * u * extent q.
Proof.
  destruct (across_computed 1 q_fl q d ltac:(lia) (q_close p centro (p_ordinary ray_fits) (centro_ordinary axis_fits))
    (ordinary_on_grid d (d_ordinary axis_fits)) (unit_square d (d_unit axis_fits))) as [G N].
  split; [exact G|]; apply Rle_trans with (1 := N); simpl INR; pose proof u_bounds; pose proof (norm_le_extent q).
  assert (u * norm q <= u * extent q) by (apply Rmult_le_compat_l; lra).
  pose proof (Rmult_le_pos u (extent q) ltac:(lra) (extent_nonneg q)); lra.
Qed.

Lemma a_fl_size : norm a_fl <= 1001 / 1000 * V.
Proof.
  destruct a_computed as [_ N]; pose proof (norm_between a_fl a); pose proof a_size; pose proof (extent_nonneg v : 0 <= V).
  pose proof u_bounds; assert (u * V <= / 1000000000000 * V) by (apply Rmult_le_compat_r; lra); lra.
Qed.

Lemma b_fl_size : norm b_fl <= 1001 / 1000 * extent q.
Proof.
  destruct b_computed as [_ N]; pose proof (norm_between b_fl b); pose proof b_size; pose proof (extent_nonneg q).
  pose proof u_bounds; assert (u * extent q <= / 1000000000000 * extent q) by (apply Rmult_le_compat_r; lra); lra.
Qed.

(** A product of two vectors that are off, and rounded: x and y are of size X and Y, and off by i and j units. *)
Lemma dot_off i j x x_fl y y_fl X Y : on_grid (-456) x_fl -> on_grid (-456) y_fl -> 0 <= i -> 0 <= j -> 0 <= X -> 0 <= Y ->
  norm x <= X -> norm y_fl <= 1001 / 1000 * Y -> norm x_fl <= 1001 / 1000 * X ->
  norm (minus x_fl x) <= i * u * X -> norm (minus y_fl y) <= j * u * Y ->
  Rabs (dot_fl x_fl y_fl - dot x y) <= (1001 / 1000 * i + j + 302 / 100) * u * (X * Y) /\
  Rabs (dot_fl x_fl y_fl) <= 3 * (X * Y) /\ grid (-912) (dot_fl x_fl y_fl).
Proof.
  intros Gx Gy Hi Hj HX HY Nx Ny Nx' Ox Oy; pose proof u_bounds as Hu.
  pose proof (dot_computed 0 0 (-456) (-456) _ _ _ _ ltac:(lia) (close_exact _ _ Gx) (close_exact _ _ Gy)) as Hc.
  assert (Hs : size_of_dot x_fl y_fl <= 1003 / 1000 * (X * Y)).
  { apply Rle_trans with (1 := size_le _ _); apply Rle_trans with (1001 / 1000 * X * (1001 / 1000 * Y)).
    - apply Rmult_le_compat; auto using norm_nonneg.
    - pose proof (Rmult_le_pos _ _ HX HY); lra. }
  pose proof (Rmult_le_pos _ _ HX HY) as HXY; pose proof (computed_error_near 3 _ _ _ _ ltac:(lia) Hc) as He; simpl INR in He.
  pose proof (computed_size 3 _ _ _ _ ltac:(lia) Hc) as Hz.
  assert (Hr : Rabs (dot_fl x_fl y_fl - dot x_fl y_fl) <= 302 / 100 * u * (X * Y)).
  { apply Rle_trans with (1 := He); assert (u * size_of_dot x_fl y_fl <= u * (1003 / 1000 * (X * Y))) by
      (apply Rmult_le_compat_l; lra); pose proof (Rmult_le_pos u (X * Y) ltac:(lra) HXY); lra. }
  assert (Ho : Rabs (dot x_fl y_fl - dot x y) <= (1001 / 1000 * i + j) * u * (X * Y)).
  { replace (dot x_fl y_fl - dot x y) with (dot (minus x_fl x) y_fl + dot x (minus y_fl y))
      by (unfold dot, minus; simpl; ring).
    apply Rle_trans with (1 := Rabs_triang _ _).
    assert (Rabs (dot (minus x_fl x) y_fl) <= i * u * X * (1001 / 1000 * Y)).
    { apply Rle_trans with (1 := dot_le _ _); apply Rmult_le_compat; auto using norm_nonneg. }
    assert (Rabs (dot x (minus y_fl y)) <= X * (j * u * Y)).
    { apply Rle_trans with (1 := dot_le _ _); apply Rmult_le_compat; auto using norm_nonneg. }
    lra. }
  split; [|split; [lra | exact (proj2 (proj2 Hc))]].
  replace (dot_fl x_fl y_fl - dot x y) with ((dot_fl x_fl y_fl - dot x_fl y_fl) + (dot x_fl y_fl - dot x y)) by ring.
  apply Rle_trans with (1 := Rabs_triang _ _); lra.
Qed.

(** ** The coefficients *)

Let HV : 0 < V := V_positive v (v_not_zero ray_fits).
Let HE : r <= E := E_positive p centro r.
Let HQ : 0 <= extent q := extent_nonneg q.

Lemma A_near : Rabs (A_fl - A) <= 24 * u * (V * V) /\ Rabs A_fl <= 3 * (V * V).
Proof.
  destruct a_computed as [G N]; destruct (dot_off (1006 / 100) (1006 / 100) a a_fl a a_fl V V G G ltac:(lra) ltac:(lra)
    ltac:(lra) ltac:(lra) a_size a_fl_size a_fl_size N N) as (He & Hs & _).
  split; [|exact Hs]; apply Rle_trans with (1 := He); pose proof u_bounds.
  pose proof (Rmult_le_pos u (V * V) ltac:(lra) ltac:(apply Rmult_le_pos; lra)); lra.
Qed.

Lemma B_near : Rabs (B_fl - B) <= 26 * u * (extent q * V) /\ Rabs B_fl <= 3 * (extent q * V) /\ grid (-912) B_fl.
Proof.
  destruct a_computed as [G N], b_computed as [G' N'].
  destruct (dot_off (1207 / 100) (1006 / 100) b b_fl a a_fl (extent q) V G' G ltac:(lra) ltac:(lra)
    HQ ltac:(lra) b_size a_fl_size b_fl_size N' N) as (He & Hs & Hg).
  split; [|split; assumption]; apply Rle_trans with (1 := He); pose proof u_bounds.
  pose proof (Rmult_le_pos u (extent q * V) ltac:(lra) ltac:(apply Rmult_le_pos; lra)); lra.
Qed.

Lemma C_near : Rabs (C_fl - C) <= 32 * u * (E * E).
Proof.
  destruct b_computed as [G N]; pose proof u_bounds as Hu.
  destruct (dot_off (1207 / 100) (1207 / 100) b b_fl b b_fl (extent q) (extent q) G G ltac:(lra) ltac:(lra)
    HQ HQ b_size b_fl_size b_fl_size N N) as (He & Hs & _).
  pose proof (computed_mult 0 0 (-152) (-152) _ _ _ _ _ _ ltac:(lia) (r_computed r r_ordinary r_positive)
    (r_computed r r_ordinary r_positive)) as Hr.
  pose proof (computed_error_near 1 _ _ _ _ ltac:(lia) Hr) as Hr1; simpl INR in Hr1.
  pose proof (rnd_plus (dot_fl b_fl b_fl) (- rnd (r * r)) (format_rnd _) (generic_format_opp _ _ _ (format_rnd _))) as Hm.
  fold (dot_fl b_fl b_fl - rnd (r * r)) in Hm; fold C_fl in Hm.
  set (X := extent q * extent q) in *; assert (HX : 0 <= X) by (apply Rmult_le_pos; lra).
  assert (HEE : X + r * r <= E * E).
  { unfold E; replace ((extent q + r) * (extent q + r)) with (X + r * r + 2 * (extent q * r)) by (unfold X; ring).
    pose proof (Rmult_le_pos (extent q) r HQ ltac:(lra)); lra. }
  assert (Hrr : 0 < r * r) by (apply Rmult_lt_0_compat; lra).
  assert (Hsum : u * X + u * (r * r) <= u * (E * E)) by (rewrite <- Rmult_plus_distr_l; apply Rmult_le_compat_l; lra).
  pose proof (Rmult_le_pos u X ltac:(lra) HX); pose proof (Rmult_le_pos u (r * r) ltac:(lra) ltac:(lra)).
  assert (u * (r * r) <= / 1000000000000 * (r * r)) by (apply Rmult_le_compat_r; lra).
  assert (Hz : Rabs (dot_fl b_fl b_fl - rnd (r * r)) <= 3 * X + 2 * (r * r)).
  { apply Rabs_le_inv in Hs, Hr1; apply Rabs_le; lra. }
  assert (u * Rabs (dot_fl b_fl b_fl - rnd (r * r)) <= u * (3 * X + 2 * (r * r))) by (apply Rmult_le_compat_l; lra).
  apply Rabs_le_inv in He, Hr1, Hm; unfold C; apply Rabs_le; lra.
Qed.

(** ** The distances of the surface and of the line *)

Let W := V * E.
Let W_sum : W = r * V + extent q * V.
Proof. unfold W, E; ring. Qed.

Lemma bounds_low : 63 * u * (V * V) <= A_error /\ 63 * u * W <= B_error /\ 63 * u * (E * E) <= C_error /\
  bpow radix2 (-360) <= A_error /\ bpow radix2 (-360) <= B_error /\ bpow radix2 (-360) <= C_error /\
  bpow radix2 (-360) <= u * W /\ format A_error /\ format B_error /\ format C_error.
Proof.
  pose proof u_bounds as Hu; assert (HE0 : 0 < E) by lra.
  pose proof (computed_more 2 4 _ _ _ _ ltac:(lia) (V_computed v (v_ordinary ray_fits))) as HVc.
  pose proof (E_computed p centro r (p_ordinary ray_fits) (centro_ordinary axis_fits) r_ordinary r_positive) as HEc.
  destruct (error_bound A_error (64 * u * V * V) V V_fl V V_fl) as (HA & _ & FA & GA); auto; try lra.
  destruct (error_bound B_error (64 * u * V * E) V V_fl E E_fl) as (HB & CB & FB & GB); auto; try lra.
  destruct (error_bound C_error (64 * u * E * E) E E_fl E E_fl) as (HC & _ & FC & GC); auto; try lra.
  assert (P : forall x y, 0 < x -> 0 < y -> 0 < 64 * u * x * y) by (intros; repeat apply Rmult_lt_0_compat; lra).
  pose proof (P V E HV HE0) as PB; pose proof (grid_at_least _ _ GB ltac:(lra)) as L.
  rewrite Rabs_pos_eq in L by lra; pose proof (computed_size 10 (-351) B_error (64 * u * V * E) (64 * u * V * E) ltac:(lia)
    (conj CB (conj FB GB))) as Hup; rewrite Rabs_pos_eq in Hup by lra.
  split; [lra|]; split; [unfold W; lra|]; split; [lra|].
  split; [exact (grid_least _ _ GA (P V V HV HV) HA)|]; split; [exact (grid_least _ _ GB PB HB)|].
  split; [exact (grid_least _ _ GC (P E E HE0 HE0) HC)|]; split; [|auto].
  apply Rmult_le_reg_l with 128; [lra|]; apply Rle_trans with (bpow radix2 (-351)).
  - replace 128 with (bpow radix2 7) by reflexivity; rewrite <- bpow_plus; apply bpow_le; lia.
  - unfold W; lra.
Qed.

(** What underflows in a square or a product is nothing beside the bounds. *)
Lemma least_of_bounds : bpow radix2 (-490) <= / 1000000 * (u * W) /\ r * bpow radix2 (-490) <= / 1000000 * (u * W).
Proof.
  destruct bounds_low as (_ & _ & _ & _ & _ & _ & L & _).
  assert (Hr : r <= bpow radix2 100) by (pose proof (ordinary_size r r_ordinary) as Hr; rewrite Rabs_pos_eq in Hr; lra).
  assert (Hs : bpow radix2 (-390) <= / 1000000 * (u * W)).
  { apply Rle_trans with (bpow radix2 (-30) * bpow radix2 (-360)); [rewrite <- bpow_plus; apply bpow_le; lia|].
    apply Rmult_le_compat; try apply bpow_ge_0; [|exact L].
    replace (bpow radix2 (-30)) with (/ 1073741824) by reflexivity; lra. }
  split; apply Rle_trans with (2 := Hs).
  - apply bpow_le; lia.
  - apply Rle_trans with (bpow radix2 100 * bpow radix2 (-490)); [apply Rmult_le_compat_r; [apply bpow_ge_0 | exact Hr]|].
    rewrite <- bpow_plus; apply bpow_le; lia.
Qed.

Lemma surface_near : Rabs (of_surface - r * norm a) <= 172 / 10 * u * (r * V) + / 100000 * (u * W).
Proof.
  destruct a_computed as [(Fx & Fy & Fz & _) N]; pose proof u_bounds as Hu; destruct least_of_bounds as [Hl1 Hl2].
  pose proof (norm_computed_any a_fl Fx Fy Fz) as Hn; pose proof (norm_between a_fl a); pose proof a_fl_size as Hs.
  pose proof (norm_between a a_fl) as Hb; replace (norm (minus a a_fl)) with (norm (minus a_fl a)) in Hb
    by (unfold norm, dot, minus; simpl; f_equal; ring).
  set (y := bpow radix2 (-490)) in *; set (n := norm_fl a_fl) in *.
  pose proof (Rmult_le_pos u V ltac:(lra) ltac:(lra)) as HuV.
  assert (u * norm a_fl <= u * (1001 / 1000 * V)) by (apply Rmult_le_compat_l; lra).
  assert (Hd : Rabs (n - norm a) <= 161 / 10 * u * V + y) by (apply Rabs_le_inv in Hn; apply Rabs_le; lra).
  assert (Hrd : Rabs (r * n - r * norm a) <= r * (161 / 10 * u * V + y)).
  { rewrite <- Rmult_minus_distr_l, Rabs_mult, (Rabs_pos_eq r) by lra; apply Rmult_le_compat_l; lra. }
  pose proof (rnd_any (r * n)) as Hr; change (rnd (r * n)) with of_surface in Hr.
  assert (Hn2 : Rabs n <= 1002 / 1000 * V + y).
  { pose proof a_size; pose proof (norm_nonneg a); assert (u * V <= / 1000000000000 * V) by (apply Rmult_le_compat_r; lra).
    apply Rabs_le_inv in Hd; apply Rabs_le; lra. }
  assert (Hrn : Rabs (r * n) <= r * (1002 / 1000 * V + y)).
  { rewrite Rabs_mult, (Rabs_pos_eq r) by lra; apply Rmult_le_compat_l; lra. }
  assert (u * Rabs (r * n) <= u * (r * (1002 / 1000 * V + y))) by (apply Rmult_le_compat_l; lra).
  assert (bpow radix2 (-1074) <= y) by (apply bpow_le; lia).
  assert (Hry : 0 <= r * y) by (apply Rmult_le_pos; [lra | apply bpow_ge_0]).
  assert (u * (r * y) <= / 1000000000000 * (r * y)) by (apply Rmult_le_compat_r; lra).
  assert (0 <= u * (r * V)) by (repeat apply Rmult_le_pos; lra).
  apply Rabs_le_inv in Hr, Hrd; apply Rabs_le; lra.
Qed.

Lemma line_near : Rabs (of_line - norm (cross b a)) <= 36 * u * (extent q * V) + / 100000 * (u * W).
Proof.
  destruct a_computed as [Ga Na], b_computed as [Gb Nb]; pose proof u_bounds as Hu; destruct least_of_bounds as [Hl1 _].
  pose proof a_fl_size as Sa; pose proof b_fl_size as Sb; pose proof b_size as Sb'; pose proof a_size as Sa'.
  set (Q := extent q) in *; assert (HQV : 0 <= Q * V) by (apply Rmult_le_pos; lra).
  assert (HuQV : 0 <= u * (Q * V)) by (apply Rmult_le_pos; lra).
  assert (HuQV1 : u * (Q * V) <= / 1000000000000 * (Q * V)) by (apply Rmult_le_compat_r; lra).
  set (x_fl := cross_fl b_fl a_fl); set (x := cross b_fl a_fl).
  assert (Hprod : norm b_fl * norm a_fl <= 1003 / 1000 * (Q * V)).
  { apply Rle_trans with (1001 / 1000 * Q * (1001 / 1000 * V)); [apply Rmult_le_compat; auto using norm_nonneg | lra]. }
  (* Each component of the product is rounded three times. *)
  assert (Hx : format (cx x_fl) /\ format (cy x_fl) /\ format (cz x_fl)) by (repeat split; apply format_rnd).
  assert (Hround : norm (minus x_fl x) <= 61 / 10 * u * (Q * V)).
  { pose proof (close_exact _ _ Ga) as (Ax & Ay & Az); pose proof (close_exact _ _ Gb) as (Bx & By & Bz).
    assert (Hone : forall s t s' t', computed 0 (-456) s s (Rabs s) -> computed 0 (-456) t t (Rabs t) ->
      computed 0 (-456) s' s' (Rabs s') -> computed 0 (-456) t' t' (Rabs t') ->
      Rabs s * Rabs t + Rabs s' * Rabs t' <= norm b_fl * norm a_fl ->
      Rabs (rnd (rnd (s * t) - rnd (s' * t')) - (s * t - s' * t')) <= 2002 / 1000 * u * (norm b_fl * norm a_fl)).
    { intros s t s' t' Cs Ct Cs' Ct' Hle.
      pose proof (computed_minus 1 (-912) _ _ _ _ _ _ ltac:(lia) (computed_mult 0 0 (-456) (-456) _ _ _ _ _ _ ltac:(lia) Cs Ct)
        (computed_mult 0 0 (-456) (-456) _ _ _ _ _ _ ltac:(lia) Cs' Ct')) as Hc.
      apply (computed_error_near 2 _ _ _ _ ltac:(lia)) in Hc; simpl INR in Hc; apply Rle_trans with (1 := Hc).
      replace (1001 / 1000 * (1 + 1)) with (2002 / 1000) by lra; apply Rmult_le_compat_l; [lra | exact Hle]. }
    pose proof (size_le b_fl a_fl) as Hsz; unfold size_of_dot in Hsz.
    assert (Hpair : forall i j k l m n, i * i + j * j + m * m <= dot b_fl b_fl -> k * k + l * l + n * n <= dot a_fl a_fl ->
      Rabs i * Rabs l + Rabs j * Rabs k <= norm b_fl * norm a_fl).
    { intros i j k l m n H1 H2.
      pose proof (size_le (Vec i j m) (Vec l k n)) as Hle; unfold size_of_dot in Hle; cbn in Hle.
      assert (norm (Vec i j m) <= norm b_fl) by (apply sqrt_le_1_alt; exact H1).
      assert (norm (Vec l k n) <= norm a_fl) by (apply sqrt_le_1_alt; change (l * l + k * k + n * n <= dot a_fl a_fl); lra).
      pose proof (Rmult_le_compat _ _ _ _ (norm_nonneg (Vec i j m)) (norm_nonneg (Vec l k n)) ltac:(eassumption) ltac:(eassumption)).
      pose proof (Rmult_le_pos _ _ (Rabs_pos m) (Rabs_pos n)); lra. }
    pose proof (Hone _ _ _ _ By Az Bz Ay (Hpair (cy b_fl) (cz b_fl) (cy a_fl) (cz a_fl) (cx b_fl) (cx a_fl)
      ltac:(unfold dot; lra) ltac:(unfold dot; lra))) as X.
    pose proof (Hone _ _ _ _ Bz Ax Bx Az (Hpair (cz b_fl) (cx b_fl) (cz a_fl) (cx a_fl) (cy b_fl) (cy a_fl)
      ltac:(unfold dot; lra) ltac:(unfold dot; lra))) as Y.
    pose proof (Hone _ _ _ _ Bx Ay By Ax (Hpair (cx b_fl) (cy b_fl) (cx a_fl) (cy a_fl) (cz b_fl) (cz a_fl)
      ltac:(unfold dot; lra) ltac:(unfold dot; lra))) as Z.
    assert (HX : Rabs (cx x_fl - cx x) <= 2002 / 1000 * u * (norm b_fl * norm a_fl)) by exact X.
    assert (HY : Rabs (cy x_fl - cy x) <= 2002 / 1000 * u * (norm b_fl * norm a_fl)) by exact Y.
    assert (HZ : Rabs (cz x_fl - cz x) <= 2002 / 1000 * u * (norm b_fl * norm a_fl)) by exact Z.
    apply Rle_trans with (1 := norm_le_extent _).
    change (extent (minus x_fl x)) with (Rabs (cx x_fl - cx x) + Rabs (cy x_fl - cy x) + Rabs (cz x_fl - cz x)).
    clear X Y Z; set (n := norm b_fl * norm a_fl) in *.
    assert (u * n <= u * (1003 / 1000 * (Q * V))) by (apply Rmult_le_compat_l; lra); lra. }
  (* What its operands bring. *)
  assert (Hoff : norm (minus x (cross b a)) <= 2217 / 100 * u * (Q * V)).
  { replace (minus x (cross b a)) with (plus (cross (minus b_fl b) a_fl) (cross b (minus a_fl a)))
      by (unfold x, plus, minus, cross; simpl; f_equal; ring).
    apply Rle_trans with (1 := norm_plus _ _).
    assert (norm (cross (minus b_fl b) a_fl) <= 1207 / 100 * u * Q * (1001 / 1000 * V)).
    { apply Rle_trans with (1 := cross_le _ _); apply Rmult_le_compat; auto using norm_nonneg. }
    assert (norm (cross b (minus a_fl a)) <= Q * (1006 / 100 * u * V)).
    { apply Rle_trans with (1 := cross_le _ _); apply Rmult_le_compat; auto using norm_nonneg. }
    lra. }
  destruct Hx as (Fx & Fy & Fz); pose proof (norm_computed_any x_fl Fx Fy Fz) as Hn; change (norm_fl x_fl) with of_line in Hn.
  assert (Hsym : forall s t, norm (minus s t) = norm (minus t s)) by (intros; unfold norm, dot, minus; simpl; f_equal; ring).
  pose proof (norm_between x_fl x); pose proof (norm_between x x_fl) as back1; rewrite Hsym in back1.
  pose proof (norm_between x (cross b a)); pose proof (norm_between (cross b a) x) as back2; rewrite Hsym in back2.
  assert (Hc : norm (cross b a) <= Q * V).
  { apply Rle_trans with (1 := cross_le _ _); apply Rmult_le_compat; auto using norm_nonneg. }
  assert (u * norm x_fl <= u * (101 / 100 * (Q * V))) by (apply Rmult_le_compat_l; lra).
  pose proof (bpow_gt_0 radix2 (-490)); apply Rabs_le_inv in Hn; apply Rabs_le; lra.
Qed.

(** ** All of it *)

Lemma F_times_H : B * B - A * C = F * H.
Proof.
  unfold F, H; replace ((r * norm a - norm (cross b a)) * (r * norm a + norm (cross b a)))
    with (r * r * (norm a * norm a) - norm (cross b a) * norm (cross b a)) by ring.
  rewrite !norm_square; pose proof (cross_and_dot b a); unfold B, A, C; lra.
Qed.

Theorem cylinder_sound : sound (Formas.cilindro p v V_fl centro r d h) A B C F H.
Proof.
  rewrite recorded; pose proof u_bounds as Hu; destruct A_near as [NA SA], B_near as (NB & SB & GB).
  destruct bounds_low as (LA & LB & LC & MA & MB & MC & _ & FA & FB & FC).
  pose proof surface_near as NS; pose proof line_near as NL; pose proof (norm_nonneg a) as Ha0.
  pose proof (norm_nonneg (cross b a)) as Hc0; pose proof a_size as Sa; pose proof b_size as Sb.
  destruct (products_size p v centro r (p_ordinary ray_fits) (v_ordinary ray_fits) (centro_ordinary axis_fits) r_ordinary
    r_positive (v_not_zero ray_fits)) as (PA & PB & PC).
  fold q V E in PA, PB, PC; fold W in PB.
  pose proof (Rmult_le_pos r V ltac:(lra) ltac:(lra)) as HrV; pose proof (Rmult_le_pos _ V HQ ltac:(lra)) as HQV.
  assert (Hra : 0 <= r * norm a <= r * V) by (split; [apply Rmult_le_pos | apply Rmult_le_compat_l]; lra).
  assert (Hcr : norm (cross b a) <= extent q * V).
  { apply Rle_trans with (1 := cross_le _ _); apply Rmult_le_compat; auto using norm_nonneg. }
  assert (HuW : 0 <= u * W <= / 1000000000000 * W).
  { assert (0 <= W) by (rewrite W_sum; lra); split; [apply Rmult_le_pos | apply Rmult_le_compat_r]; lra. }
  assert (Hd : u * W = u * (r * V) + u * (extent q * V)) by (rewrite W_sum; ring).
  pose proof (Rmult_le_pos u (r * V) ltac:(lra) HrV); pose proof (Rmult_le_pos u (extent q * V) ltac:(lra) HQV).
  assert (Hline : 0 <= of_line) by (apply rnd_nonneg, sqrt_pos).
  assert (Fs : format of_surface) by apply format_rnd; assert (Fl : format of_line) by apply format_rnd.
  pose proof (rnd_plus of_surface (- of_line) Fs (generic_format_opp _ _ _ Fl)) as RF; fold (of_surface - of_line) in RF.
  pose proof (rnd_plus of_surface of_line Fs Fl) as RH.
  apply Rabs_le_inv in NS, NL.
  assert (Hsize : forall t, - (2 * W) <= t <= 2 * W -> u * Rabs t <= 2 * (u * W)).
  { intros t Ht; replace (2 * (u * W)) with (u * (2 * W)) by ring; apply Rmult_le_compat_l; [lra | now apply Rabs_le]. }
  pose proof (Hsize (of_surface - of_line) ltac:(rewrite W_sum in *; lra)).
  pose proof (Hsize (of_surface + of_line) ltac:(rewrite W_sum in *; lra)).
  apply Rabs_le_inv in RF, RH.
  assert (NF : Rabs (rnd (of_surface - of_line) - F) <= 5 / 6 * B_error) by (unfold F; apply Rabs_le; lra).
  assert (NH : Rabs (rnd (of_surface + of_line) - H) <= 5 / 6 * B_error) by (unfold H; apply Rabs_le; lra).
  constructor; cbn [Formas.A Formas.B Formas.C Formas.F Formas.H Formas.A_error Formas.B_error Formas.C_error].
  - pose proof (Rmult_le_pos u (V * V) ltac:(lra) ltac:(apply Rmult_le_pos; lra)); apply Rle_trans with (1 := NA); lra.
  - apply Rle_trans with (1 := NB); lra.
  - pose proof (Rmult_le_pos u (E * E) ltac:(lra) ltac:(apply Rmult_le_pos; lra)); apply Rle_trans with (1 := C_near); lra.
  - exact NF.
  - exact NH.
  - exact F_times_H.
  - unfold F, H; apply Rabs_le; lra.
  - apply rnd_le; lra.
  - repeat split; assumption || apply format_rnd.
  - exact GB.
  - auto.
  - assert (Hlift : forall k e t, (k + 2 <= e)%Z -> t <= 3 * bpow radix2 k -> t <= bpow radix2 e).
    { intros k e t Hk Ht; apply Rle_trans with (bpow radix2 (k + 2)); [|now apply bpow_le].
      rewrite bpow_plus; replace (bpow radix2 2) with 4 by reflexivity; pose proof (bpow_gt_0 radix2 k); lra. }
    split; [|split].
    + apply (Hlift 204%Z); [lia | lra].
    + apply (Hlift 205%Z); [lia | rewrite W_sum in PB; lra].
    + apply (Hlift 205%Z); [lia | rewrite W_sum in *; lra].
  - exact (A_error_computed p v centro r (p_ordinary ray_fits) (v_ordinary ray_fits) (centro_ordinary axis_fits) r_ordinary
    r_positive (v_not_zero ray_fits)).
Qed.

End Cylinder.
