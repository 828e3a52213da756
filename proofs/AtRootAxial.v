(** * AtRootAxial: the quadratic at a parameter is within its error, of what has an axis

    As AtRoot.v, for the cylinder, the cone and the truncated cone. The square of the distance from an axis that is not
    quite of length 1 is |q|² - s² + (d·d - 1)s², with s the advance along it.

    excess_fl d   == d·d - 1, as the program computes it
    apart_fl q d  == that square *)
From Coq Require Import Reals ZArith Lra Lia Psatz.
From Flocq Require Import Core.
From Durero Require Import Rounding Quotient Vectors Flotante Twofold Sums Loose AtRoot.
From Durero Require Formas.
Import Formas.Pairs.
Local Open Scope R_scope.
Local Opaque bpow.

Notation share := (1 + / 1000000).
Definition excess_fl (d : vec) : R :=
  let n := Formas.Powers.sum (Formas.Powers.sum (two_prod (cx d) (cx d)) (two_prod (cy d) (cy d))) (two_prod (cz d) (cz d)) in
  rnd (rnd (hi n - 1) + lo n).
Definition apart_fl (q : offsets) (d : vec) : twofold :=
  let s := along q d in let w := Formas.Powers.difference (squared q) (Formas.Powers.square s) in
  Twofold (hi w) (rnd (lo w + rnd (excess_fl d * rnd (hi s * hi s)))).

Section Axis.
Variable d : vec.
Hypothesis d_ordinary : ordinary_vec d.
Hypothesis d_unit : Rabs (dot d d - 1) <= 8 * u.

Lemma unit_enough : Rabs (dot d d - 1) <= / 1000000.
Proof. apply Rle_trans with (1 := d_unit); pose proof u_bounds; lra. Qed.

Lemma excess_near : Rabs (excess_fl d - (dot d d - 1)) <= 31 * (u * u) /\ Rabs (excess_fl d) <= (8 + / 10) * u.
Proof.
  destruct (formats_of d d_ordinary) as (Fx & Fy & Fz), (axis_components d unit_enough) as (Bx & By & Bz).
  assert (Sq : forall a, format a -> loose (a * a + / 1000) (1 + / 100) (1 + / 100) (two_prod a a) (a * a)).
  { intros a Fa; pose proof (Rle_0_sqr a) as Ha; unfold Rsqr in Ha; apply loose_two_prod; auto; [|rewrite Rabs_pos_eq; lra].
    apply Rle_trans with (/ 1000); [|lra]; apply Rle_trans with (bpow radix2 (-10)); [apply bpow_le; lia|].
    replace (bpow radix2 (-10)) with (/ 1024) by reflexivity; lra. }
  pose proof (loose_sum _ _ _ _ _ _ _ _ (Sq _ Fx) (Sq _ Fy) ltac:(counts)) as Sxy.
  assert (S : loose (cx d * cx d + / 1000 + (cy d * cy d + / 1000) + (cz d * cz d + / 1000)) (3 + / 20) (9 + / 8)
    (Formas.Powers.sum (Formas.Powers.sum (two_prod (cx d) (cx d)) (two_prod (cy d) (cy d))) (two_prod (cz d) (cz d)))
    (cx d * cx d + cy d * cy d + cz d * cz d)) by counted_sum Sxy (Sq _ Fz).
  unfold excess_fl; set (n := Formas.Powers.sum (Formas.Powers.sum _ _) _) in *; destruct S as (Hs & Fh & Fl & _ & Ll & Ee).
  replace (cx d * cx d + / 1000 + (cy d * cy d + / 1000) + (cz d * cz d + / 1000)) with (dot d d + 3 / 1000) in * by (unfold dot; field).
  replace (cx d * cx d + cy d * cy d + cz d * cz d) with (dot d d) in * by reflexivity.
  pose proof u_bounds as Hu; pose proof (u_part u ltac:(lra)) as Huu; pose proof d_unit as Hd; apply Rabs_le_inv in Hd.
  assert (HT : u * (dot d d + 3 / 1000) <= (1 + / 200) * u) by (replace ((1 + / 200) * u) with (u * (1 + / 200)) by ring; apply Rmult_le_compat_l; lra).
  assert (HT2 : u * (u * (dot d d + 3 / 1000)) <= (1 + / 200) * (u * u)).
  { replace ((1 + / 200) * (u * u)) with (u * ((1 + / 200) * u)) by ring; apply Rmult_le_compat_l; lra. }
  assert (L : Rabs (lo n) <= (3 + / 10) * u) by lra.
  assert (E : Rabs (whole n - dot d d) <= (9 + / 4) * (u * u)) by lra.
  unfold whole in E; apply Rabs_le_inv in L, E.
  assert (F1 : format (- (1))) by (apply generic_format_opp; exact (format_bpow 0 ltac:(lia))).
  assert (B1 : Rabs (hi n - 1) <= (12 - / 2) * u) by (apply Rabs_le; lra).
  pose proof (lost_of_sum (hi n) (- (1)) _ Fh F1 B1) as R1; replace (u * ((12 - / 2) * u)) with ((12 - / 2) * (u * u)) in R1 by ring.
  fold (hi n - 1) in R1; set (m := rnd (hi n - 1)) in *; apply Rabs_le_inv in R1.
  assert (B2 : Rabs (m + lo n) <= (8 + / 20) * u) by (apply Rabs_le; lra).
  pose proof (lost_of_sum _ _ _ (format_rnd _) Fl B2) as R2; fold m in R2; set (k := rnd (m + lo n)) in *.
  replace (u * ((8 + / 20) * u)) with ((8 + / 20) * (u * u)) in R2 by ring; apply Rabs_le_inv in R2, B2.
  split; apply Rabs_le; lra.
Qed.

Lemma apart_loose x y z q e : at_place x y z q e -> bpow radix2 (-440) <= x -> bpow radix2 (-440) <= y -> bpow radix2 (-440) <= z ->
  let N := (x + y + z) * share in
  loose N (5 + / 5) 27 (along q d) (dot e d) /\
  loose (x * x + y * y + z * z + share * (N * N)) 21 272 (apart_fl q d) (dot e e - (2 - dot d d) * (dot e d * dot e d)).
Proof.
  intros P Hx Hy Hz N; pose proof (bpow_gt_0 radix2 (-440)) as H440.
  assert (Room : forall s, bpow radix2 (-440) <= s -> bpow radix2 (-450) <= s /\ roomy (s * share)).
  { intros s Hs; pose proof (bpow_le radix2 (-450) (-440) ltac:(lia)); unfold roomy.
    pose proof (bpow_le radix2 (-900) (-440) ltac:(lia)); split; lra. }
  destruct (Room x Hx) as [X1 X2], (Room y Hy) as [Y1 Y2], (Room z Hz) as [Z1 Z2].
  pose proof (along_loose x y z q e d share P (formats_of d d_ordinary) (axis_components d unit_enough) X2 Y2 Z2) as A; fold N in A.
  split; [exact A|]; pose proof (squared_loose x y z q e P X1 Y1 Z1) as Sq.
  assert (HN : bpow radix2 (-450) <= N) by (unfold N; lra).
  pose proof (loose_square _ _ _ _ _ A (roomy_product _ _ HN HN) ltac:(counts)) as Ss.
  assert (Ss0 : loose (N * N) (5 + / 5 + (5 + / 5) + 1 + / 100) (2 * 27 + 6 * (5 + / 5) + 2 + / 10) (Formas.Powers.square (along q d))
    (dot e d * dot e d)) by counted Ss.
  pose proof (loose_difference _ _ _ _ _ _ _ _ (loose_more _ _ _ (5 + / 5 + (5 + / 5) + 1 + / 100) (2 * 27 + 6 * (5 + / 5) + 2 + / 10) _ _ Sq ltac:(lra) ltac:(lra)) Ss0 ltac:(counts)) as Df.
  set (w := Formas.Powers.difference (squared q) (Formas.Powers.square (along q d))) in *; set (s := along q d) in *.
  destruct excess_near as [Ex Es]; set (k := excess_fl d) in *; destruct A as (Ra & Fh & Fl & Hed & Ls & Ee).
  pose proof (roomy_product _ _ HN HN) as RN; destruct (roomy_units _ RN) as (UN & WN & ZN), (roomy_units _ Ra) as (Ua & Wa & _).
  set (D := x * x + y * y + z * z + share * (N * N)); pose proof u_bounds as Hu; assert (HN0 : 0 < N) by (now apply roomy_positive).
  assert (HD : N * N <= D).
  { pose proof (Rle_0_sqr x) as Qx; pose proof (Rle_0_sqr y) as Qy; pose proof (Rle_0_sqr z) as Qz; unfold Rsqr in *; unfold D; lra. }
  set (P2 := N * N) in *; assert (RD : roomy D) by (unfold roomy in *; lra); destruct (roomy_units _ RD) as (UD & WD & _).
  assert (HU : u * P2 <= u * D) by (apply Rmult_le_compat_l; lra).
  assert (HW : u * (u * P2) <= u * (u * D)) by (apply Rmult_le_compat_l; lra).
  (* The square of the advance. *)
  assert (Hs1 : Rabs (hi s - dot e d) <= (5 + / 4) * (u * N)).
  { replace (hi s - dot e d) with ((whole s - dot e d) - lo s) by (unfold whole; ring).
    apply Rle_trans with (1 := Rabs_triang _ _); rewrite Rabs_Ropp; lra. }
  assert (Hs2 : Rabs (hi s) <= (1 + / 100000000) * N).
  { replace (hi s) with (hi s - dot e d + dot e d) by ring; apply Rle_trans with (1 := Rabs_triang _ _); lra. }
  assert (Hs3 : Rabs (hi s * hi s) <= (1 + / 10000000) * P2).
  { rewrite Rabs_mult; apply Rle_trans with ((1 + / 100000000) * N * ((1 + / 100000000) * N));
      [apply Rmult_le_compat; auto using Rabs_pos | unfold P2; pose proof (Rmult_lt_0_compat N N HN0 HN0); lra]. }
  set (g := rnd (hi s * hi s)).
  assert (Hg1 : Rabs (g - hi s * hi s) <= (1 + / 1000000) * (u * P2)).
  { apply Rle_trans with (1 := rnd_any _); assert (u * Rabs (hi s * hi s) <= u * ((1 + / 10000000) * P2)) by (apply Rmult_le_compat_l; lra).
    lra. }
  assert (Hg2 : Rabs (hi s * hi s - dot e d * dot e d) <= (11 - / 4) * (u * P2)).
  { replace (hi s * hi s - dot e d * dot e d) with ((hi s - dot e d) * (hi s + dot e d)) by ring; rewrite Rabs_mult.
    assert (Rabs (hi s + dot e d) <= (2 + / 100000000) * N) by (apply Rle_trans with (1 := Rabs_triang _ _); lra).
    apply Rle_trans with ((5 + / 4) * (u * N) * ((2 + / 100000000) * N)); [apply Rmult_le_compat; auto using Rabs_pos|].
    unfold P2 in *; lra. }
  assert (Hg3 : Rabs (g - dot e d * dot e d) <= 12 * (u * P2)).
  { replace (g - dot e d * dot e d) with ((g - hi s * hi s) + (hi s * hi s - dot e d * dot e d)) by ring.
    apply Rle_trans with (1 := Rabs_triang _ _); lra. }
  assert (Hee : Rabs (dot e d * dot e d) <= P2) by (rewrite Rabs_mult; unfold P2; apply Rmult_le_compat; auto using Rabs_pos).
  assert (Hg4 : Rabs g <= (1 + / 1000000) * P2).
  { replace g with (g - dot e d * dot e d + dot e d * dot e d) by ring; apply Rle_trans with (1 := Rabs_triang _ _); lra. }
  (* The term of the excess. *)
  assert (Ht1 : Rabs (k * g - (dot d d - 1) * (dot e d * dot e d)) <= 129 * (u * (u * P2))).
  { replace (k * g - (dot d d - 1) * (dot e d * dot e d)) with (k * (g - dot e d * dot e d) + (k - (dot d d - 1)) * (dot e d * dot e d)) by ring.
    apply Rle_trans with (1 := Rabs_triang _ _); rewrite !(Rabs_mult _ (_ - _)), !(Rabs_mult (_ - _)).
    assert (Rabs k * Rabs (g - dot e d * dot e d) <= (8 + / 10) * u * (12 * (u * P2))) by (apply Rmult_le_compat; auto using Rabs_pos).
    assert (Rabs (k - (dot d d - 1)) * Rabs (dot e d * dot e d) <= 31 * (u * u) * P2) by (apply Rmult_le_compat; auto using Rabs_pos).
    lra. }
  assert (Ht2 : Rabs (k * g) <= (8 + / 8) * (u * P2)).
  { rewrite Rabs_mult; apply Rle_trans with ((8 + / 10) * u * ((1 + / 1000000) * P2)); [apply Rmult_le_compat; auto using Rabs_pos | lra]. }
  set (m := rnd (k * g)); assert (Hm : Rabs (m - k * g) <= 9 * (u * (u * P2))).
  { apply Rle_trans with (1 := rnd_any _); assert (u * Rabs (k * g) <= u * ((8 + / 8) * (u * P2))) by (apply Rmult_le_compat_l; lra); lra. }
  assert (Hm2 : Rabs m <= (8 + / 5) * (u * P2)).
  { replace m with (m - k * g + k * g) by ring; apply Rle_trans with (1 := Rabs_triang _ _); lra. }
  assert (HS : x * x + y * y + z * z + P2 <= D) by (unfold D; fold P2; lra).
  apply (loose_larger _ D) in Df; [|exact HS | lra | lra]; destruct Df as (_ & Fwh & Fwl & Hx2 & Lw & Ew).
  destruct (sum_of_rounded (lo w) m _ _ Fwl (format_rnd _) Lw Hm2) as [S1 S2].
  change (apart_fl q d) with (Twofold (hi w) (rnd (lo w + m))); set (low := rnd (lo w + m)) in *.
  unfold loose; unfold whole in Ew |- *; cbn [hi lo].
  split; [exact RD | split; [exact Fwh | split; [apply format_rnd | split; [|split]]]].
  - assert (Rabs (2 - dot d d) <= share) by (pose proof d_unit as Hd; apply Rabs_le_inv in Hd; apply Rabs_le; lra).
    assert (Rabs ((2 - dot d d) * (dot e d * dot e d)) <= share * P2) by (rewrite Rabs_mult; apply Rmult_le_compat; auto using Rabs_pos).
    destruct Sq as (_ & _ & _ & Hq & _); set (turned := (2 - dot d d) * (dot e d * dot e d)) in *.
    unfold Rminus; apply Rle_trans with (1 := Rabs_triang _ _); rewrite Rabs_Ropp; unfold D; fold P2; lra.
  - replace low with (low - (lo w + m) + (lo w + m)) by ring; apply Rle_trans with (1 := Rabs_triang _ _); lra.
  - replace (hi w + low - (dot e e - (2 - dot d d) * (dot e d * dot e d))) with ((hi w + lo w - (dot e e - dot e d * dot e d))
      + (m - k * g) + (k * g - (dot d d - 1) * (dot e d * dot e d)) + (low - (lo w + m))) by ring.
    apply Rabs_le_inv in Ew, Hm, Ht1, S1; apply Rabs_le; lra.
Qed.
End Axis.

(** ** The shapes *)

Lemma kappa_low k : ordinary k -> 0 < k ->
  (1 - 4 * e12) * (2048 * (u * u) * (1 + k * k)) <= rnd (bpow radix2 (-95) * rnd (1 + rnd (k * k))).
Proof.
  intros Hk Hk0; pose proof (r_least k Hk Hk0) as Lk; pose proof (bpow_gt_0 radix2 (-100)).
  assert (L1 : bpow radix2 (-1000) <= k * k).
  { apply Rle_trans with (bpow radix2 (-100) * bpow radix2 (-100)); [rewrite <- bpow_plus; apply bpow_le; lia|].
    apply Rmult_le_compat; lra. }
  assert (Hkk : 0 < k * k) by (apply Rmult_lt_0_compat; lra).
  pose proof (product_low k k ltac:(lra) ltac:(lra) L1) as E1; set (k2 := rnd (k * k)) in *.
  pose proof (rnd_low_sum 1 k2 (format_bpow 0 ltac:(lia)) (format_rnd _) ltac:(lra)) as E2; set (kappa := rnd (1 + k2)) in *.
  pose proof uu_positive; assert (Hg : 1 - e12 <= kappa) by lra.
  assert (L2 : bpow radix2 (-1000) <= bpow radix2 (-95) * kappa).
  { apply Rle_trans with (bpow radix2 (-95) * bpow radix2 (-1)); [rewrite <- bpow_plus; apply bpow_le; lia|].
    apply Rmult_le_compat_l; [apply bpow_ge_0|]; replace (bpow radix2 (-1)) with (/ 2) by reflexivity; lra. }
  pose proof (product_low (bpow radix2 (-95)) kappa (bpow_ge_0 _ _) ltac:(lra) L2) as E3; rewrite power_error_units in *.
  assert (2048 * (u * u) * ((1 - 2 * e12) * (1 + k * k)) <= 2048 * (u * u) * kappa) by (apply Rmult_le_compat_l; lra).
  assert (0 < u * u * (k * k)) by (now apply Rmult_lt_0_compat); lra.
Qed.

Section Shapes.
Variables p v : vec.
Variable t : R.
Hypothesis ray_ordinary : ordinary_ray p v.
Hypothesis t_binary64 : format t.
Variables c d : vec.
Hypothesis c_ordinary : ordinary_vec c.
Hypothesis d_ordinary : ordinary_vec d.
Hypothesis d_unit : Rabs (dot d d - 1) <= 8 * u.
Let q := placed_at p v t c.
Let e := exact_place p v t c.
Let W := reached p v t c.
Let apart2 := dot e e - (2 - dot d d) * (dot e d * dot e d).

Lemma apart_beside M : bpow radix2 (-100) <= M -> W <= M -> exists N D, 0 < N /\ N <= W + / 50000 * M /\ D <= (2 + / 1000) * ((W + / 50000 * M) * (W + / 50000 * M)) /\
  loose N (5 + / 5) 27 (along q d) (dot e d) /\ loose D 21 272 (apart_fl q d) apart2.
Proof.
  intros HM HW; destruct (placed_loose p v t ray_ordinary t_binary64 c M c_ordinary) as (x & y & z & X & Y & Z0 & Hx & Hy & Hz
    & S);
    [apply Rle_trans with (2 := HM), bpow_le; lia | exact HW|].
  pose proof (reached_nonneg p v t ray_ordinary c c_ordinary) as HW0; fold W in HW0, S; pose proof (bpow_gt_0 radix2 (-100)).
  assert (L : bpow radix2 (-440) <= / 10000000 * M).
  { apply Rle_trans with (/ 10000000 * bpow radix2 (-100)); [|apply Rmult_le_compat_l; lra].
    replace (-440)%Z with (-340 + -100)%Z by reflexivity; rewrite bpow_plus; apply Rmult_le_compat_r; [apply bpow_ge_0|].
    apply Rle_trans with (bpow radix2 (-24)); [apply bpow_le; lia|]; replace (bpow radix2 (-24)) with (/ 16777216) by reflexivity; lra. }
  destruct (apart_loose d d_ordinary d_unit x y z q e (conj X (conj Y Z0)) ltac:(lra) ltac:(lra) ltac:(lra)) as [A B].
  exists ((x + y + z) * share), (x * x + y * y + z * z + share * ((x + y + z) * share * ((x + y + z) * share))).
  assert (Hs : 0 < x + y + z) by lra; split; [lra | split; [lra | split; [|now split]]].
  pose proof (squares_below x y z ltac:(lra) ltac:(lra) ltac:(lra)).
  pose proof (square_below (x + y + z) (W + / 50000 * M) ltac:(lra)).
  pose proof (Rmult_lt_0_compat _ _ Hs Hs); lra.
Qed.

Theorem cylinder_powered r h : ordinary r -> 0 < r -> let f := Formas.Powers.cilindro t p v (extent_fl v) c r d h in
  powered f (apart2 - r * r) /\ 1 * bpow radix2 (-300) <= Formas.error f.
Proof.
  intros Hr Hr0; pose proof (r_least r Hr Hr0) as Lr; pose proof (proj1 Hr) as Fr.
  pose proof (reached_nonneg p v t ray_ordinary c c_ordinary) as HW; fold W in HW.
  change (Formas.Powers.cilindro t p v (extent_fl v) c r d h) with (let m := rnd (W + r) in
    Formas.Known (Formas.Powers.difference (apart_fl q d) (two_prod r r)) (rnd (rnd (bpow radix2 (-95) * m) * m))); cbv zeta.
  set (M := W + r); assert (EM : M = W + r) by reflexivity; set (m := rnd M); pose proof (bpow_gt_0 radix2 (-100)).
  destruct (apart_beside M) as (N & D & HN0 & HN & HD & _ & A); [lra | lra|].
  pose proof (rnd_low_sum W r (format_rnd _) Fr ltac:(lra)) as Em; fold M m in Em.
  assert (Rr : roomy (r * r)) by (apply roomy_product; apply Rle_trans with (2 := Lr), bpow_le; lia).
  assert (Rt : loose (r * r) 21 272 (two_prod r r) (r * r)).
  { counted (loose_two_prod (r * r) r r Rr Fr Fr ltac:(rewrite Rabs_pos_eq; [lra | apply Rmult_le_pos; lra])). }
  pose proof (loose_difference _ _ _ _ _ _ _ _ A Rt ltac:(counts)) as Df.
  assert (Hs : D + r * r <= (4 + / 8) * (1 * (M * M))).
  { pose proof (squares_below (W + / 50000 * M) r 0 ltac:(lra) ltac:(lra) ltac:(lra)) as H1.
    pose proof (square_below (W + / 50000 * M + r) ((1 + / 50000) * M) ltac:(lra)) as H2.
    pose proof (Rle_0_sqr (W + / 50000 * M)) as H3; pose proof (Rle_0_sqr M) as H4; pose proof (Rle_0_sqr r) as H5; unfold Rsqr in *.
    replace ((W + / 50000 * M + r + 0) * (W + / 50000 * M + r + 0)) with ((W + / 50000 * M + r) * (W + / 50000 * M + r)) in H1 by ring.
    set (a := (W + / 50000 * M) * (W + / 50000 * M)) in *; set (b := (W + / 50000 * M + r) * (W + / 50000 * M + r)) in *; lra. }
  destruct (bound_suffices _ 1 (bpow radix2 (-95)) M m (Rle_refl 1) ltac:(rewrite power_error_units; pose proof uu_positive; lra)
    ltac:(lra) ltac:(lra) Hs) as [H1 H2].
  split; [|exact H2]; exists (D + r * r); split; [counted Df | split; [exact H1 | apply format_rnd]].
Qed.

(** The radius at the place, of a cone and of a truncated one, with the size s of what is squared. *)
Lemma squared_radius_loose s rho_fl rho l x D : loose s l x rho_fl rho -> few l x -> bpow radix2 (-450) <= s -> 2 * l + 1 + / 100 <= 21 ->
  2 * x + 6 * l + 2 + / 10 <= 272 -> loose D 21 272 (apart_fl q d) apart2 ->
  loose (D + s * s) 40 340 (Formas.Powers.difference (apart_fl q d) (Formas.Powers.square rho_fl)) (apart2 - rho * rho).
Proof.
  intros H Few Hs Hl Hx A; pose proof (loose_square _ _ _ _ _ H (roomy_product _ _ Hs Hs) Few) as Sq.
  counted (loose_difference _ _ _ _ _ _ _ _ A (loose_more _ _ _ 21 272 _ _ Sq Hl Hx) ltac:(counts)).
Qed.

Lemma height_loose h N k : ordinary h -> 0 < h -> ordinary k -> 0 < k -> 0 < N -> loose N (5 + / 5) 27 (along q d) (dot e d) ->
  loose ((h + N) * k) (7 + / 4) 54 (Formas.Powers.product_by (Formas.Powers.difference (Twofold h 0) (along q d)) k) ((h - dot e d) * k)
  /\ bpow radix2 (-200) <= (h + N) * k.
Proof.
  intros Hh Hh0 Hk Hk0 HN A; pose proof (r_least h Hh Hh0) as Lh; pose proof (r_least k Hk Hk0) as Lk.
  assert (L : bpow radix2 (-200) <= (h + N) * k).
  { replace (-200)%Z with (-100 + -100)%Z by reflexivity; rewrite bpow_plus; apply Rmult_le_compat; auto using bpow_ge_0; lra. }
  split; [|exact L].
  assert (Rh : roomy h) by (apply Rle_trans with (2 := Lh), bpow_le; lia).
  assert (Hw : loose h (5 + / 5) 27 (Twofold h 0) h) by counted (loose_whole h h Rh (proj1 Hh) ltac:(rewrite Rabs_pos_eq; lra)).
  pose proof (loose_difference _ _ _ _ _ _ _ _ Hw A ltac:(counts)) as Df.
  assert (Room : roomy ((h + N) * k)) by (apply Rle_trans with (2 := L), bpow_le; lia).
  counted (loose_product_by _ k _ _ _ _ k Df (proj1 Hk) ltac:(rewrite Rabs_pos_eq; lra) Room ltac:(counts)).
Qed.

Theorem cone_powered k h : ordinary k -> 0 < k -> ordinary h -> 0 < h -> let f := Formas.Powers.cono t p v (extent_fl v) c k d h in
  powered f (apart2 - (h - dot e d) * k * ((h - dot e d) * k)) /\ (1 + k * k) * bpow radix2 (-300) <= Formas.error f.
Proof.
  intros Hk Hk0 Hh Hh0; pose proof (r_least h Hh Hh0) as Lh; pose proof (proj1 Hh) as Fh.
  pose proof (reached_nonneg p v t ray_ordinary c c_ordinary) as HW; fold W in HW.
  change (Formas.Powers.cono t p v (extent_fl v) c k d h) with (let m := rnd (W + h) in Formas.Known (Formas.Powers.difference (apart_fl q d)
    (Formas.Powers.square (Formas.Powers.product_by (Formas.Powers.difference (Twofold h 0) (along q d)) k)))
    (rnd (rnd (rnd (bpow radix2 (-95) * rnd (1 + rnd (k * k))) * m) * m))); cbv zeta.
  set (M := W + h); assert (EM : M = W + h) by reflexivity; set (m := rnd M); pose proof (bpow_gt_0 radix2 (-100)).
  destruct (apart_beside M) as (N & D & HN0 & HN & HD & Al & A); [lra | lra|].
  pose proof (rnd_low_sum W h (format_rnd _) Fh ltac:(lra)) as Em; fold M m in Em.
  destruct (height_loose h N k Hh Hh0 Hk Hk0 HN0 Al) as [Hl L]; set (s := (h + N) * k) in *.
  pose proof (squared_radius_loose s _ _ _ _ D Hl ltac:(counts) (Rle_trans _ _ _ (bpow_le radix2 (-450) (-200) ltac:(lia)) L) ltac:(lra) ltac:(lra) A) as P.
  assert (Hkk : 0 < k * k) by (apply Rmult_lt_0_compat; lra).
  assert (HMM : 0 < M * M) by (apply Rmult_lt_0_compat; lra).
  assert (Hs : D + s * s <= (4 + / 8) * ((1 + k * k) * (M * M))).
  { pose proof (square_below (W + / 50000 * M) ((1 + / 50000) * M) ltac:(lra)) as H1.
    pose proof (square_below (h + N) ((1 + / 50000) * M) ltac:(lra)) as H2.
    assert (H3 : k * k * ((h + N) * (h + N)) <= k * k * ((1 + / 50000) * M * ((1 + / 50000) * M))) by (apply Rmult_le_compat_l; lra).
    pose proof (Rmult_lt_0_compat _ _ Hkk HMM); set (a := (W + / 50000 * M) * (W + / 50000 * M)) in *.
    replace (s * s) with (k * k * ((h + N) * (h + N))) by (unfold s; ring); lra. }
  destruct (bound_suffices _ (1 + k * k) _ M m ltac:(lra) (kappa_low k Hk Hk0) ltac:(lra) ltac:(lra) Hs) as [H1 H2].
  split; [|exact H2]; exists (D + s * s); split; [exact P | split; [exact H1 | apply format_rnd]].
Qed.

Theorem truncated_powered r k h : ordinary r -> 0 < r -> ordinary k -> 0 < k -> ordinary h -> 0 < h ->
  let f := Formas.Powers.tronco t p v (extent_fl v) c r k d h in let rho := (h - dot e d) * k + r in
  powered f (apart2 - rho * rho) /\ (1 + k * k) * bpow radix2 (-300) <= Formas.error f.
Proof.
  intros Hr Hr0 Hk Hk0 Hh Hh0; pose proof (r_least h Hh Hh0) as Lh; pose proof (proj1 Hh) as Fh.
  pose proof (r_least r Hr Hr0) as Lr; pose proof (proj1 Hr) as Fr.
  pose proof (reached_nonneg p v t ray_ordinary c c_ordinary) as HW; fold W in HW.
  change (Formas.Powers.tronco t p v (extent_fl v) c r k d h) with (let m := rnd (rnd (W + h) + r) in
    Formas.Known (Formas.Powers.difference (apart_fl q d) (Formas.Powers.square (Formas.Powers.sum
      (Formas.Powers.product_by (Formas.Powers.difference (Twofold h 0) (along q d)) k) (Twofold r 0))))
    (rnd (rnd (rnd (bpow radix2 (-95) * rnd (1 + rnd (k * k))) * m) * m))); cbv zeta.
  set (M := W + h + r); assert (EM : M = W + h + r) by reflexivity; pose proof (bpow_gt_0 radix2 (-100)).
  destruct (apart_beside M) as (N & D & HN0 & HN & HD & Al & A); [lra | lra|].
  pose proof (rnd_low_sum W h (format_rnd _) Fh ltac:(lra)) as E1; set (m1 := rnd (W + h)) in *.
  pose proof (rnd_low_sum m1 r (format_rnd _) Fr ltac:(lra)) as Em; set (m := rnd (m1 + r)) in *.
  destruct (height_loose h N k Hh Hh0 Hk Hk0 HN0 Al) as [Hl L].
  assert (Rr : roomy r) by (apply Rle_trans with (2 := Lr), bpow_le; lia).
  assert (Hw : loose r (7 + / 4) 54 (Twofold r 0) r) by counted (loose_whole r r Rr Fr ltac:(rewrite Rabs_pos_eq; lra)).
  pose proof (loose_sum _ _ _ _ _ _ _ _ Hl Hw ltac:(counts)) as Rho; set (s := (h + N) * k + r) in *.
  assert (Ls : bpow radix2 (-450) <= s).
  { pose proof (bpow_le radix2 (-450) (-200) ltac:(lia)); unfold s; lra. }
  pose proof (squared_radius_loose s _ _ _ _ D Rho ltac:(counts) Ls ltac:(lra) ltac:(lra) A) as P.
  assert (Hkk : 0 < k * k) by (apply Rmult_lt_0_compat; lra).
  assert (HMM : 0 < M * M) by (apply Rmult_lt_0_compat; lra).
  assert (Hs : D + s * s <= (4 + / 8) * ((1 + k * k) * (M * M))).
  { pose proof (square_below (W + / 50000 * M) ((1 + / 50000) * M) ltac:(lra)) as H1.
    pose proof (squares_below (h + N) r 0 ltac:(lra) ltac:(lra) ltac:(lra)) as H2.
    pose proof (square_below (h + N + r + 0) ((1 + / 50000) * M) ltac:(lra)) as H3.
    (* The square of k·a + b is at most (k² + 1)(a² + b²). *)
    pose proof (Rle_0_sqr (h + N - k * r)) as H4; unfold Rsqr in H4.
    set (a2 := (h + N) * (h + N)) in *; set (b2 := (h + N + r + 0) * (h + N + r + 0)) in *.
    assert (H5 : s * s <= (1 + k * k) * (a2 + r * r)) by (unfold s, a2; lra).
    assert (H6 : (1 + k * k) * (a2 + r * r) <= (1 + k * k) * ((1 + / 50000) * M * ((1 + / 50000) * M))) by (apply Rmult_le_compat_l; lra).
    pose proof (Rmult_lt_0_compat _ _ Hkk HMM); set (a := (W + / 50000 * M) * (W + / 50000 * M)) in *; lra. }
  destruct (bound_suffices _ (1 + k * k) _ M m ltac:(lra) (kappa_low k Hk Hk0) ltac:(lra) ltac:(lra) Hs) as [H1 H2].
  split; [|exact H2]; exists (D + s * s); split; [exact P | split; [exact H1 | apply format_rnd]].
Qed.
End Shapes.
