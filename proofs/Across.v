(** * Across: what is left of a vector across an axis, computed

    across x d     == x - (x·d)·d, for any d, unit or not;  X_fl == the same, each operation rounded once *)
From Coq Require Import Reals ZArith Lra Lia Psatz.
From Flocq Require Import Core.
From Durero Require Import Rounding Vectors.
Local Open Scope R_scope.
Local Opaque bpow.

Definition across (x d : vec) : vec := minus x (scale (dot x d) d).
Definition across_fl (x d : vec) : vec :=
  let s := dot_fl x d in
  Vec (rnd (cx x - rnd (s * cx d))) (rnd (cy x - rnd (s * cy d))) (rnd (cz x - rnd (s * cz d))).

(** A product of two parts across is that of the wholes less that along: for any axis, unit or not. *)
Lemma across_dot a b d : dot (across a d) (across b d) = dot a b - (2 - dot d d) * (dot a d * dot b d).
Proof. unfold across, scale, minus, dot; cbn; ring. Qed.

(** What lies across an axis is no longer than the whole, unless the axis is longer than √2. *)
Lemma across_le x d : dot d d <= 2 -> norm (across x d) <= norm x.
Proof.
  intros Hd; apply norm_of_square; [apply norm_nonneg|]; rewrite norm_square.
  replace (dot (across x d) (across x d)) with (dot x x - (2 - dot d d) * (dot x d * dot x d))
    by (unfold across, dot, minus, scale; simpl; ring).
  pose proof (Rle_0_sqr (dot x d)) as H; unfold Rsqr in H.
  pose proof (Rmult_le_pos (2 - dot d d) (dot x d * dot x d) ltac:(lra) H); lra.
Qed.

(** A direction that is a unit vector but for what rounding it leaves. *)
Lemma unit_square d : Rabs (dot d d - 1) <= / 1000000 -> dot d d <= 1 + / 1000000.
Proof. intros Hd; apply Rabs_le_inv in Hd; lra. Qed.
Lemma norm_of_unit d : Rabs (dot d d - 1) <= / 1000000 -> norm d <= 1 + / 1000000.
Proof. intros Hd; apply norm_of_square; [lra|]; pose proof (unit_square d Hd); lra. Qed.
Lemma size_along x d X : Rabs (dot d d - 1) <= / 1000000 -> norm x <= X -> 0 <= X -> size_of_dot x d <= (1 + / 1000000) * X.
Proof.
  intros Hd Hx HX; apply Rle_trans with (1 := size_le _ _); rewrite (Rmult_comm (norm x)).
  apply Rmult_le_compat; try apply norm_nonneg; [exact (norm_of_unit d Hd) | exact Hx].
Qed.
Lemma across_size x d : Rabs (dot d d - 1) <= / 1000000 -> norm (across x d) <= extent x.
Proof.
  intros Hd; apply Rle_trans with (norm x); [apply across_le; pose proof (unit_square d Hd); lra | apply norm_le_extent].
Qed.

(** ** Computed *)

(** A computed length, whatever underflows in its square. *)
Lemma norm_computed_any a : format (cx a) -> format (cy a) -> format (cz a) ->
  Rabs (norm_fl a - norm a) <= 6 * u * norm a + bpow radix2 (-490).
Proof.
  intros Fx Fy Fz; pose proof u_bounds as Hu; pose proof (norm_nonneg a) as Hn; pose proof (norm_square a) as Hsq.
  set (z := bpow radix2 (-1074)); pose proof (bpow_gt_0 radix2 (-1074) : 0 < z) as Hz.
  unfold norm_fl, dot_fl; set (X := rnd (cx a * cx a)); set (Y := rnd (cy a * cy a)); set (Z := rnd (cz a * cz a)).
  assert (Hp : forall t, (1 - u) * (t * t) - z <= rnd (t * t) <= (1 + u) * (t * t) + z).
  { intros t; pose proof (rnd_any (t * t)) as H; rewrite (Rabs_pos_eq (t * t)) in H by apply Rle_0_sqr; fold z in H.
    apply Rabs_le_inv in H; lra. }
  assert (Hs : forall s t, format s -> format t -> 0 <= s -> 0 <= t -> (1 - u) * (s + t) <= rnd (s + t) <= (1 + u) * (s + t)).
  { intros s t Fs Ft Hs Ht; pose proof (rnd_plus s t Fs Ft) as H; rewrite (Rabs_pos_eq (s + t)) in H by lra.
    apply Rabs_le_inv in H; lra. }
  assert (H0 : forall t, 0 <= rnd (t * t)) by (intros; apply rnd_nonneg, Rle_0_sqr).
  pose proof (Hp (cx a)) as HX; pose proof (Hp (cy a)) as HY; pose proof (Hp (cz a)) as HZ; fold X in HX; fold Y in HY;
    fold Z in HZ.
  pose proof (H0 (cx a) : 0 <= X) as X0; pose proof (H0 (cy a) : 0 <= Y) as Y0; pose proof (H0 (cz a) : 0 <= Z) as Z0.
  pose proof (Hs X Y (format_rnd _) (format_rnd _) X0 Y0) as HXY; set (P := rnd (X + Y)) in *.
  assert (P0 : 0 <= P) by (apply rnd_nonneg; lra).
  pose proof (Hs P Z (format_rnd _) (format_rnd _) P0 Z0) as HG; set (G := rnd (P + Z)) in *.
  assert (G0 : 0 <= G) by (apply rnd_nonneg; lra).
  set (N := norm a) in *.
  assert (HN : N * N = cx a * cx a + cy a * cy a + cz a * cz a) by (rewrite Hsq; reflexivity).
  assert (Hsum : (1 - u) * (N * N) - 3 * z <= X + Y + Z <= (1 + u) * (N * N) + 3 * z) by (rewrite HN; lra).
  assert (HN0 : 0 <= N * N) by apply Rle_0_sqr.
  assert (E1 : forall t, 0 <= t -> 0 <= u * t <= / 1000000000000 * t).
  { intros t Ht; split; [apply Rmult_le_pos | apply Rmult_le_compat_r]; lra. }
  assert (HGs : (1 - 3 * u) * (X + Y + Z) <= G <= (1 + 21 / 10 * u) * (X + Y + Z)).
  { pose proof (E1 _ X0); pose proof (E1 _ Y0); pose proof (E1 _ Z0); pose proof (E1 _ P0).
    assert (u * P <= u * ((1 + u) * (X + Y))) by (apply Rmult_le_compat_l; lra).
    assert (u * ((1 - u) * (X + Y)) <= u * P) by (apply Rmult_le_compat_l; lra).
    assert (0 <= u * (u * (X + Y)) <= / 1000000000000 * (u * (X + Y))).
    { split; [repeat apply Rmult_le_pos; lra | apply Rmult_le_compat_r; [apply Rmult_le_pos|]; lra]. }
    lra. }
  assert (HGd : Rabs (N * N - G) <= 42 / 10 * u * (N * N) + 4 * z).
  { pose proof (E1 _ HN0); set (T := X + Y + Z) in *; assert (T0 : 0 <= T) by (unfold T; lra).
    assert (u * T <= u * ((1 + u) * (N * N) + 3 * z)) by (apply Rmult_le_compat_l; lra).
    assert (0 <= u * T) by (apply Rmult_le_pos; lra).
    assert (u * (u * (N * N)) <= / 1000000000000 * (u * (N * N))) by (apply Rmult_le_compat_r; lra).
    assert (u * z <= / 1000000000000 * z) by (apply Rmult_le_compat_r; lra).
    apply Rabs_le; lra. }
  set (y := bpow radix2 (-500)); pose proof (bpow_gt_0 radix2 (-500) : 0 < y) as Hy0.
  assert (Hzy : z <= / 1000000 * (y * y)).
  { unfold z, y; rewrite <- bpow_plus; apply Rle_trans with (bpow radix2 (-20) * bpow radix2 (-500 + -500)).
    - rewrite <- bpow_plus; apply bpow_le; lia.
    - apply Rmult_le_compat_r; [apply bpow_ge_0|].
      replace (bpow radix2 (-20)) with (/ 1048576) by reflexivity; lra. }
  assert (Hlarge : bpow radix2 (-490) = 1024 * y).
  { unfold y; replace 1024 with (bpow radix2 10) by reflexivity; now rewrite <- bpow_plus. }
  assert (Hroot : Rabs (sqrt G - N) <= 43 / 10 * u * N + 4 * y).
  { rewrite Rabs_minus_sym; destruct (Rle_lt_dec N y) as [Hsmall|Hbig].
    - assert (HGy : G <= 4 * y * (4 * y)).
      { assert (N * N <= y * y) by (apply Rmult_le_compat; lra).
        apply Rabs_le_inv in HGd; pose proof (E1 _ HN0); lra. }
      assert (sqrt G <= 4 * y) by (rewrite <- (sqrt_square (4 * y)) by lra; now apply sqrt_le_1_alt).
      pose proof (sqrt_pos G); assert (0 <= u * N) by (apply Rmult_le_pos; lra); apply Rabs_le; lra.
    - assert (HNN : 0 < N * N) by (apply Rmult_lt_0_compat; lra).
      assert (HsN : sqrt (N * N) = N) by (apply sqrt_square; lra).
      pose proof (sqrt_distance (N * N) G HNN G0) as Hd; rewrite HsN in Hd.
      apply Rle_trans with (1 := Hd); apply Rmult_le_reg_r with N; [lra|].
      unfold Rdiv; rewrite Rmult_assoc, Rinv_l, Rmult_1_r by lra; apply Rle_trans with (1 := HGd).
      assert (y * y <= N * y) by (apply Rmult_le_compat_r; lra).
      assert (0 <= u * (N * N)) by (apply Rmult_le_pos; lra); lra. }
  pose proof (rnd_any (sqrt G)) as Hr; fold z in Hr; rewrite (Rabs_pos_eq (sqrt G)) in Hr by apply sqrt_pos.
  assert (z <= y).
  { unfold z, y; apply bpow_le; lia. }
  apply Rabs_le_inv in Hroot, Hr; pose proof (sqrt_pos G).
  assert (u * sqrt G <= u * ((1 + 43 / 10 * u) * N + 4 * y)) by (apply Rmult_le_compat_l; lra).
  pose proof (E1 N Hn); assert (u * (u * N) <= / 1000000000000 * (u * N)) by (apply Rmult_le_compat_r; lra).
  assert (u * y <= / 1000000000000 * y) by (apply Rmult_le_compat_r; lra).
  rewrite Hlarge; apply Rabs_le; lra.
Qed.

(** x is computed with n roundings a component; what is left of it is off by 2 (n + 5) units of x, to first order. *)
Lemma across_computed n x_fl x d : (n <= 8)%nat -> close n (-152) x_fl x -> on_grid (-152) d -> dot d d <= 1 + / 1000000 ->
  on_grid (-456) (across_fl x_fl d) /\
  norm (minus (across_fl x_fl d) (across x d)) <= 201 / 100 * (INR n + 5) * u * norm x.
Proof.
  intros Hn Hx Hd Hdd; pose proof (close_exact _ _ Hd) as (Dx & Dy & Dz).
  pose proof (dot_computed n 0 (-152) (-152) x_fl d x d ltac:(lia) Hx (close_exact _ _ Hd)) as Hs.
  change (-152 + -152)%Z with (-304)%Z in Hs; replace (S (S (S (n + 0)))) with (n + 3)%nat in Hs by lia.
  destruct Hx as (X & Y & Z); set (s := size_of_dot x d) in *.
  assert (Hone : forall a b y e, computed n (-152) a y (Rabs y) -> computed 0 (-152) b e (Rabs e) ->
    computed (n + 5) (-456) (rnd (a - rnd (dot_fl x_fl d * b))) (y - dot x d * e) (Rabs y + s * Rabs e)).
  { intros a b y e Ha Hb; replace (n + 5)%nat with (S (n + 4)) by lia; apply computed_minus; [lia | |].
    - apply (computed_coarser _ (-456) (-152)); [lia|]; now apply (computed_more n); [lia|].
    - replace (n + 4)%nat with (S (n + 3 + 0)) by lia; apply (computed_mult _ _ (-304) (-152)); [lia | exact Hs | exact Hb]. }
  pose proof (Hone _ _ _ _ X Dx) as CX; pose proof (Hone _ _ _ _ Y Dy) as CY; pose proof (Hone _ _ _ _ Z Dz) as CZ.
  split; [destruct CX as (_ & ? & ?), CY as (_ & ? & ?), CZ as (_ & ? & ?); repeat split; assumption|].
  pose proof u_bounds as Hu; set (k := 1001 / 1000 * INR (n + 5) * u).
  assert (Hk : 0 <= k) by (unfold k; repeat apply Rmult_le_pos; try lra; apply pos_INR).
  apply (computed_error_near (n + 5) _ _ _ _ ltac:(lia)) in CX, CY, CZ; fold k in CX, CY, CZ.
  apply Rle_trans with (norm (scale k (plus (magnitudes x) (scale s (magnitudes d))))).
  - apply norm_mono; cbn; assumption.
  - rewrite norm_scale, (Rabs_pos_eq k Hk); pose proof (norm_plus (magnitudes x) (scale s (magnitudes d))) as Hp.
    rewrite norm_scale, !norm_magnitudes, (Rabs_pos_eq s) in Hp by apply size_nonneg.
    pose proof (norm_nonneg x) as Hx0; pose proof (norm_nonneg d) as Hd0; pose proof (size_le x d : s <= _) as Hs1.
    assert (s * norm d <= norm x * dot d d).
    { rewrite <- norm_square, <- Rmult_assoc; apply Rmult_le_compat_r; assumption. }
    assert (norm x * dot d d <= norm x * (1 + / 1000000)) by (apply Rmult_le_compat_l; lra).
    apply Rle_trans with (k * ((2 + / 1000000) * norm x)); [apply Rmult_le_compat_l; lra|].
    unfold k; rewrite plus_INR; replace (INR 5) with 5 by (simpl; lra).
    assert (0 <= (INR n + 5) * u * norm x) by (repeat apply Rmult_le_pos; try lra; pose proof (pos_INR n); lra); lra.
Qed.
