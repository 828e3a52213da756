(** * AtRootTriangle: the quadratic at a parameter is within its error, of a triangle

    As AtRoot.v: the product of the place with the normal, of which the edges are exact as sums of two. *)
From Coq Require Import Reals ZArith Lra Lia Psatz.
From Flocq Require Import Core.
From Durero Require Import Rounding Quotient Vectors Flotante Twofold Sums Loose AtRoot.
From Durero Require Formas.
Import Formas.Pairs.
Local Open Scope R_scope.
Local Opaque bpow.

Definition normal_fl (a b : offsets) : offsets :=
  Offsets (Formas.Powers.difference (Formas.Powers.product (oy a) (oz b)) (Formas.Powers.product (oz a) (oy b)))
    (Formas.Powers.difference (Formas.Powers.product (oz a) (ox b)) (Formas.Powers.product (ox a) (oz b)))
    (Formas.Powers.difference (Formas.Powers.product (ox a) (oy b)) (Formas.Powers.product (oy a) (ox b))).
Definition dot_fl (q n : offsets) : twofold :=
  Formas.Powers.sum (Formas.Powers.sum (Formas.Powers.product (ox q) (ox n)) (Formas.Powers.product (oy q) (oy n)))
    (Formas.Powers.product (oz q) (oz n)).
Definition size_fl (a : offsets) : R := rnd (rnd (Rabs (hi (ox a)) + Rabs (hi (oy a))) + Rabs (hi (oz a))).

(** An edge: its components, with sizes that add up to hardly more than what is computed of them. *)
Definition edged (x y z : R) (a : offsets) (e : vec) : Prop :=
  loose x 1 0 (ox a) (cx e) /\ loose y 1 0 (oy a) (cy e) /\ loose z 1 0 (oz a) (cz e) /\
  bpow radix2 (-180) <= x /\ bpow radix2 (-180) <= y /\ bpow radix2 (-180) <= z /\
  x + y + z <= (1 + / 100000) * size_fl a /\ bpow radix2 (-153) <= size_fl a.

Lemma edge_loose a b : ordinary_vec a -> ordinary_vec b -> minus b a <> Vec 0 0 0 -> exists x y z, edged x y z (away b a) (minus b a).
Proof.
  intros Ha Hb N; pose proof (away_far b a Hb Ha N) as L; cbv zeta in L; set (d := away b a) in *.
  destruct (formats_of a Ha) as (Ax & Ay & Az), (formats_of b Hb) as (Bx & By & Bz).
  pose proof (Rabs_pos (hi (ox d))); pose proof (Rabs_pos (hi (oy d))); pose proof (Rabs_pos (hi (oz d))).
  assert (Fx : format (Rabs (hi (ox d))) /\ format (Rabs (hi (oy d))) /\ format (Rabs (hi (oz d))))
    by (repeat split; apply generic_format_abs, format_rnd); destruct Fx as (Fx & Fy & Fz).
  pose proof (rnd_low_sum _ _ Fx Fy ltac:(lra)) as E1; set (s1 := rnd (Rabs (hi (ox d)) + Rabs (hi (oy d)))) in *.
  pose proof (rnd_low_sum s1 _ (format_rnd _) Fz ltac:(lra)) as E2; change (rnd (s1 + Rabs (hi (oz d)))) with (size_fl d) in E2.
  set (s := Rabs (hi (ox d)) + Rabs (hi (oy d)) + Rabs (hi (oz d))) in *; set (m := / 1000000 * s).
  pose proof (bpow_gt_0 radix2 (-152)) as H152.
  assert (Hm : bpow radix2 (-180) <= m).
  { unfold m; apply Rle_trans with (/ 1000000 * bpow radix2 (-152)); [|apply Rmult_le_compat_l; lra].
    replace (-180)%Z with (-28 + -152)%Z by reflexivity; rewrite bpow_plus; apply Rmult_le_compat_r; [lra|].
    apply Rle_trans with (bpow radix2 (-20)); [apply bpow_le; lia|]; replace (bpow radix2 (-20)) with (/ 1048576) by reflexivity; lra. }
  assert (Room : roomy m) by (apply Rle_trans with (2 := Hm), bpow_le; lia).
  assert (Small : forall h, 0 <= h <= s -> u * h <= m) by (intros h Hh; pose proof (u_part h ltac:(lra)); unfold m; lra).
  exists (Rabs (hi (ox d)) + m), (Rabs (hi (oy d)) + m), (Rabs (hi (oz d)) + m); unfold edged.
  split; [apply offset_loose; auto; apply Small; change (two_sum (cx b) (- cx a)) with (ox d); unfold s; lra|].
  split; [apply offset_loose; auto; apply Small; change (two_sum (cy b) (- cy a)) with (oy d); unfold s; lra|].
  split; [apply offset_loose; auto; apply Small; change (two_sum (cz b) (- cz a)) with (oz d); unfold s; lra|].
  pose proof (bpow_gt_0 radix2 (-180)); split; [lra | split; [lra | split; [lra | split]]].
  - unfold m, s in *; lra.
  - replace (-152)%Z with (1 + -153)%Z in L by reflexivity; rewrite bpow_plus in L; replace (bpow radix2 1) with 2 in L by reflexivity.
    pose proof (bpow_gt_0 radix2 (-153)); unfold s in *; lra.
Qed.

Lemma normal_component s t s' t' a b a' b' x y x' y' : loose s 1 0 a x -> loose t 1 0 b y -> loose s' 1 0 a' x' -> loose t' 1 0 b' y' ->
  bpow radix2 (-450) <= s -> bpow radix2 (-450) <= t -> bpow radix2 (-450) <= s' -> bpow radix2 (-450) <= t' ->
  loose (s * t + s' * t') (4 + / 10) (16 + / 2) (Formas.Powers.difference (Formas.Powers.product a b) (Formas.Powers.product a' b')) (x * y - x' * y').
Proof.
  intros A B A' B' Hs Ht Hs' Ht'.
  pose proof (loose_product _ _ _ _ _ _ _ _ _ _ A B (roomy_product _ _ Hs Ht) ltac:(counts) ltac:(counts)) as P.
  pose proof (loose_product _ _ _ _ _ _ _ _ _ _ A' B' (roomy_product _ _ Hs' Ht') ltac:(counts) ltac:(counts)) as P'.
  counted (loose_difference _ _ _ _ _ _ _ _ P P' ltac:(counts)).
Qed.

Section Triangle.
Variables p v : vec.
Variable t : R.
Hypothesis ray_ordinary : ordinary_ray p v.
Hypothesis t_binary64 : format t.
Variables a b c : vec.
Hypothesis a_ordinary : ordinary_vec a.
Hypothesis b_ordinary : ordinary_vec b.
Hypothesis c_ordinary : ordinary_vec c.
Let q := placed_at p v t a.
Let e := exact_place p v t a.
Let W := reached p v t a.

Theorem triangle_powered : minus p a <> Vec 0 0 0 -> minus b a <> Vec 0 0 0 -> minus c a <> Vec 0 0 0 ->
  let f := Formas.Powers.triangulo t p v (extent_fl v) a b c in
  powered f (dot e (cross (minus b a) (minus c a))) /\ bpow radix2 (-560) <= Formas.error f.
Proof.
  intros Np Nb Nc; pose proof (reached_far p v t ray_ordinary a a_ordinary Np) as HW; fold W in HW.
  destruct (edge_loose a b a_ordinary b_ordinary Nb) as (x1 & y1 & z1 & X1 & Y1 & Z1 & Hx1 & Hy1 & Hz1 & S1 & L1).
  destruct (edge_loose a c a_ordinary c_ordinary Nc) as (x2 & y2 & z2 & X2 & Y2 & Z2 & Hx2 & Hy2 & Hz2 & S2 & L2).
  destruct (placed_beside p v t ray_ordinary t_binary64 a a_ordinary W) as (x & y & z & (X & Y & Z0) & Hx & Hy & Hz & S);
    [apply Rle_trans with (2 := HW), bpow_le; lia | unfold W; lra|]; fold W in S.
  change (Formas.Powers.triangulo t p v (extent_fl v) a b c) with (Formas.Known (dot_fl q (normal_fl (away b a) (away c a)))
    (rnd (rnd (rnd (bpow radix2 (-95) * W) * size_fl (away b a)) * size_fl (away c a)))).
  cbv zeta; unfold powered; cbn [Formas.value Formas.error].
  set (l1 := size_fl (away b a)) in *; set (l2 := size_fl (away c a)) in *.
  assert (Lower : forall s, bpow radix2 (-180) <= s -> bpow radix2 (-450) <= s)
    by (intros s Hs; apply Rle_trans with (2 := Hs), bpow_le; lia).
  pose proof (normal_component _ _ _ _ _ _ _ _ _ _ _ _ Y1 Z2 Z1 Y2 ltac:(auto) ltac:(auto) ltac:(auto) ltac:(auto)) as Nx.
  pose proof (normal_component _ _ _ _ _ _ _ _ _ _ _ _ Z1 X2 X1 Z2 ltac:(auto) ltac:(auto) ltac:(auto) ltac:(auto)) as Ny.
  pose proof (normal_component _ _ _ _ _ _ _ _ _ _ _ _ X1 Y2 Y1 X2 ltac:(auto) ltac:(auto) ltac:(auto) ltac:(auto)) as Nz.
  pose proof (bpow_gt_0 radix2 (-180)) as H180; pose proof (bpow_gt_0 radix2 (-450)); pose proof (bpow_gt_0 radix2 (-153)) as H153.
  assert (Two : forall s k s' k', bpow radix2 (-180) <= s -> bpow radix2 (-180) <= k -> bpow radix2 (-180) <= s' -> bpow radix2 (-180) <= k' ->
    bpow radix2 (-450) <= s * k + s' * k').
  { intros s k s' k' A B A' B'; apply Rle_trans with (s * k).
    - apply Rle_trans with (bpow radix2 (-180) * bpow radix2 (-180)); [rewrite <- bpow_plus; apply bpow_le; lia | apply Rmult_le_compat; lra].
    - pose proof (Rmult_le_pos s' k' ltac:(lra) ltac:(lra)); lra. }
  pose proof (loose_product _ _ _ _ _ _ _ _ _ _ X Nx (roomy_product _ _ Hx (Two y1 z2 z1 y2 Hy1 Hz2 Hz1 Hy2)) ltac:(counts) ltac:(counts)) as Px.
  pose proof (loose_product _ _ _ _ _ _ _ _ _ _ Y Ny (roomy_product _ _ Hy (Two z1 x2 x1 z2 Hz1 Hx2 Hx1 Hz2)) ltac:(counts) ltac:(counts)) as Py.
  pose proof (loose_product _ _ _ _ _ _ _ _ _ _ Z0 Nz (roomy_product _ _ Hz (Two x1 y2 y1 x2 Hx1 Hy2 Hy1 Hx2)) ltac:(counts) ltac:(counts)) as Pz.
  pose proof (loose_sum _ _ _ _ _ _ _ _ Px Py ltac:(counts)) as Pxy.
  set (s := x * (y1 * z2 + z1 * y2) + y * (z1 * x2 + x1 * z2) + z * (x1 * y2 + y1 * x2)).
  assert (D : loose s 40 340 (dot_fl q (normal_fl (away b a) (away c a))) (dot e (cross (minus b a) (minus c a)))) by counted_sum Pxy Pz.
  (* What is computed of the bound. *)
  assert (G1 : bpow radix2 (-248) <= bpow radix2 (-95) * W).
  { replace (-248)%Z with (-95 + -153)%Z by reflexivity; rewrite bpow_plus; apply Rmult_le_compat_l; [apply bpow_ge_0 | exact HW]. }
  pose proof (product_low (bpow radix2 (-95)) W (bpow_ge_0 _ _) ltac:(lra) (Rle_trans _ _ _ (bpow_le radix2 (-1000) (-248) ltac:(lia)) G1)) as E1.
  pose proof (rnd_ge_bpow (-248) _ ltac:(lia) G1) as K1; set (g1 := rnd (bpow radix2 (-95) * W)) in *; pose proof (bpow_gt_0 radix2 (-248)).
  assert (G2 : bpow radix2 (-401) <= g1 * l1).
  { replace (-401)%Z with (-248 + -153)%Z by reflexivity; rewrite bpow_plus; apply Rmult_le_compat; lra. }
  pose proof (product_low g1 l1 ltac:(lra) ltac:(lra) (Rle_trans _ _ _ (bpow_le radix2 (-1000) (-401) ltac:(lia)) G2)) as E2.
  pose proof (rnd_ge_bpow (-401) _ ltac:(lia) G2) as K2; set (g2 := rnd (g1 * l1)) in *; pose proof (bpow_gt_0 radix2 (-401)).
  assert (G3 : bpow radix2 (-554) <= g2 * l2).
  { replace (-554)%Z with (-401 + -153)%Z by reflexivity; rewrite bpow_plus; apply Rmult_le_compat; lra. }
  pose proof (product_low g2 l2 ltac:(lra) ltac:(lra) (Rle_trans _ _ _ (bpow_le radix2 (-1000) (-554) ltac:(lia)) G3)) as E3.
  split; [|apply rnd_ge_bpow; [lia|]; apply Rle_trans with (2 := G3), bpow_le; lia].
  exists s; split; [exact D | split; [|apply format_rnd]]; apply Rle_trans with (2 := E3).
  assert (Hs : s <= 2 * (W * (l1 * l2))).
  { apply Rle_trans with ((x + y + z) * ((x1 + y1 + z1) * (x2 + y2 + z2))).
    - assert (P0 : forall i j k, 0 <= i -> 0 <= j -> 0 <= k -> 0 <= i * (j * k)) by (intros; repeat apply Rmult_le_pos; assumption).
      unfold s; pose proof (P0 x x1 x2 ltac:(lra) ltac:(lra) ltac:(lra)); pose proof (P0 x y1 y2 ltac:(lra) ltac:(lra) ltac:(lra)).
      pose proof (P0 x z1 z2 ltac:(lra) ltac:(lra) ltac:(lra)); pose proof (P0 x x1 y2 ltac:(lra) ltac:(lra) ltac:(lra)).
      pose proof (P0 x x1 z2 ltac:(lra) ltac:(lra) ltac:(lra)); pose proof (P0 x y1 x2 ltac:(lra) ltac:(lra) ltac:(lra)).
      pose proof (P0 x z1 x2 ltac:(lra) ltac:(lra) ltac:(lra)); pose proof (P0 y x1 x2 ltac:(lra) ltac:(lra) ltac:(lra)).
      pose proof (P0 y y1 y2 ltac:(lra) ltac:(lra) ltac:(lra)); pose proof (P0 y z1 z2 ltac:(lra) ltac:(lra) ltac:(lra)).
      pose proof (P0 y x1 y2 ltac:(lra) ltac:(lra) ltac:(lra)); pose proof (P0 y y1 x2 ltac:(lra) ltac:(lra) ltac:(lra)).
      pose proof (P0 y y1 z2 ltac:(lra) ltac:(lra) ltac:(lra)); pose proof (P0 y z1 y2 ltac:(lra) ltac:(lra) ltac:(lra)).
      pose proof (P0 z x1 x2 ltac:(lra) ltac:(lra) ltac:(lra)); pose proof (P0 z y1 y2 ltac:(lra) ltac:(lra) ltac:(lra)).
      pose proof (P0 z z1 z2 ltac:(lra) ltac:(lra) ltac:(lra)); pose proof (P0 z x1 z2 ltac:(lra) ltac:(lra) ltac:(lra)).
      pose proof (P0 z z1 x2 ltac:(lra) ltac:(lra) ltac:(lra)); pose proof (P0 z y1 z2 ltac:(lra) ltac:(lra) ltac:(lra)).
      pose proof (P0 z z1 y2 ltac:(lra) ltac:(lra) ltac:(lra)); lra.
    - assert (H12 : (x1 + y1 + z1) * (x2 + y2 + z2) <= (1 + / 100000) * l1 * ((1 + / 100000) * l2)) by (apply Rmult_le_compat; lra).
      assert (H3 : (x + y + z) * ((x1 + y1 + z1) * (x2 + y2 + z2)) <= (1 + / 100000) * W * ((1 + / 100000) * l1 * ((1 + / 100000) * l2))).
      { apply Rmult_le_compat; [lra | apply Rmult_le_pos; lra | lra | exact H12]. }
      assert (0 < W * (l1 * l2)) by (apply Rmult_lt_0_compat; [lra | apply Rmult_lt_0_compat; lra]); lra. }
  pose proof uu_positive as Hu; rewrite power_error_units in *.
  assert (E12 : (1 - e12) * ((1 - e12) * (2048 * (u * u) * W) * l1) <= g2).
  { apply Rle_trans with (2 := E2), Rmult_le_compat_l; [lra|]; apply Rmult_le_compat_r; lra. }
  assert (E123 : (1 - e12) * ((1 - e12) * (2048 * (u * u) * W) * l1) * l2 <= g2 * l2) by (apply Rmult_le_compat_r; lra).
  assert (HK : 0 < u * u * (W * (l1 * l2))) by (apply Rmult_lt_0_compat; [exact Hu | apply Rmult_lt_0_compat; [lra | apply Rmult_lt_0_compat; lra]]).
  assert (u * u * s <= u * u * (2 * (W * (l1 * l2)))) by (apply Rmult_le_compat_l; lra); lra.
Qed.
End Triangle.
