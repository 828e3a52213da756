(** * StableConical: what the second step computes of a cone and of a truncated cone is within its bounds

    Conical.v over pairs: with a and b of StableAcross.v, g = altura - s0, rho = radio + k g and slope = k s1,
      A = a·a - slope²,  B = b·a + rho slope,  C = b·b - rho²,  F, H = |rho a + slope b| ∓ |b × a|
    within 64 κ units of V V, V E and E E, κ = 1 + k². What both share is shown here, of whatever is within what both
    compute of the parts that k and the radius make; S, G, P, K, E and W are those of Conical.v. *)
From Coq Require Import Reals ZArith Lra Lia Psatz.
From Flocq Require Import Core.
From Durero Require Import Rounding Vectors Across Flotante Twofold Sums Products Ratios Words Small Doubled Stable
  StableSphere StableAdvance StableAcross.
From Durero Require Conical Cone Triangle Formas.
Import Formas.Pairs.
Local Open Scope R_scope.
Local Opaque bpow.

Section Conical.
Variables p v centro d : vec.
Variables h k r : R.
Hypothesis ray_fits : fit_ray p v.
Hypothesis axis_fits : fit_axis centro d.
Hypothesis h_ordinary : ordinary h.
Hypothesis h_positive : 0 < h.
Hypothesis k_ordinary : ordinary k.
Hypothesis k_positive : 0 < k.
Hypothesis r_ordinary : ordinary r.
Hypothesis r_nonneg : 0 <= r.
Let q := minus p centro.
Let a := across v d.
Let b := across q d.
Let Q := extent q.
Let V := extent v.
Let S := size_of_dot v d.
Let G := h + size_of_dot q d.
Let P := r + k * G.
Let E := Q + h + r.
Let K := 1 + k * k.
Let W := V * (Q + h).
Let slope := Conical.slope v d k.
Let rho := Conical.rho p centro d h k r.
Let wall := Conical.wall p v centro d h k r.
Let A := Conical.A v d k.
Let B := Conical.B p v centro d h k r.
Let C := Conical.C p centro d h k r.
Let F := Conical.F p v centro d h k r.
Let H := Conical.H p v centro d h k r.
Notation a2 := (a2 v d).
Notation b2 := (b2 p centro d).
Notation line2 := (line2 p v centro d).
Notation V_fl := (extent_fl v).

Let HV : 0 < V := V_positive v (v_not_zero ray_fits).
Let HQ : 0 <= Q := extent_nonneg q.

(** What underflows is nothing beside the bounds. *)
Lemma W_least : bpow radix2 (-200) <= W /\ (1 + k) * bpow radix2 (-450) <= / 1000 * (uu * W) /\
  bpow radix2 (-957) <= / 1000 * (uu * W).
Proof.
  pose proof (V_range v (v_ordinary ray_fits) (v_not_zero ray_fits)) as SV; fold V in SV;
  pose proof (bpow_gt_0 radix2 (-100)) as H100.
  pose proof (r_least h h_ordinary h_positive) as Hh; assert (HW : bpow radix2 (-200) <= W).
  { change (-200)%Z with (-100 + -100)%Z; rewrite bpow_plus; unfold W; apply Rmult_le_compat; lra. }
  split; [exact HW | apply nothing_beside; [now apply ordinary_size | apply HW]].
Qed.

(** The length of what two computed numbers make of a and b: x and y of sizes M and N, off by i and j units. *)
Lemma combined2 i j x x2 y y2 M N : double_word x2 -> parts_on (-456) x2 -> double_word y2 -> parts_on (-456) y2 ->
  0 <= i <= 16 -> 0 <= j <= 16 -> 0 <= M -> 0 <= N -> Rabs (whole x2 - x) <= i * (uu * M) -> Rabs (whole y2 - y) <= j *
    (uu * N) ->
  Rabs x <= M -> Rabs y <= N ->
  let w2 := Vec2 (sum (product x2 (dx a2)) (product y2 (dx b2))) (sum (product x2 (dy a2)) (product y2 (dy b2)))
    (sum (product x2 (dz a2)) (product y2 (dz b2))) in
  let w := plus (scale x a) (scale y b) in
  double_word (norm2 w2) /\
  Rabs (whole (norm2 w2) - norm w) <= (i + 2008 / 100) * (uu * (M * V)) + (j + 2008 / 100) * (uu * (N * Q)) + bpow radix2
    (-450) /\
  norm w <= M * V + N * Q.
Proof.
  intros Wx Gx Wy Gy Hi Hj HM HN Hx Hy Sx Sy w2 w; pose proof uu_bounds as Hu.
  destruct (a_facts2 p v centro d ray_fits axis_fits) as (Oa & Na & Sa & Sa'); fold a in Na, Sa;
    fold V in Na, Sa, Sa'.
  destruct (b_facts2 p v centro d ray_fits axis_fits) as (Ob & Nb & Sb & Sb').
  fold q in Nb, Sb, Sb'; fold b in Nb, Sb; fold Q in Nb, Sb, Sb'.
  pose proof (uu_part M HM) as HuM; pose proof (uu_part N HN) as HuN.
  assert (HiM : i * (uu * M) <= 16 * (uu * M)) by (apply Rmult_le_compat_r; lra).
  assert (HjN : j * (uu * N) <= 16 * (uu * N)) by (apply Rmult_le_compat_r; lra).
  assert (Sx' : Rabs (whole x2) <= 10001 / 10000 * M) by (pose proof (size_near _ _ _ _ Hx Sx); lra).
  assert (Sy' : Rabs (whole y2) <= 10001 / 10000 * N) by (pose proof (size_near _ _ _ _ Hy Sy); lra).
  assert (HMV : 0 <= M * V) by (apply Rmult_le_pos; lra); assert (HNQ : 0 <= N * Q) by (apply Rmult_le_pos; lra).
  pose proof (uu_part _ HMV) as Hm; pose proof (uu_part _ HNQ) as Hn; set (m := uu * (M * V)) in *;
    set (n := uu * (N * Q)) in *.
  set (a' := wholes a2) in *; set (b' := wholes b2) in *; set (x' := whole x2) in *; set (y' := whole y2) in *.
  (* Each component loses two operations. *)
  set (t := plus (scale x' a') (scale y' b')); set (e := 2002 / 1000 * uu); assert (He : 0 <= e) by (unfold e; lra).
  pose proof (words_close_self _ _ Oa) as (Ax & Ay & Az); pose proof (words_close_self _ _ Ob) as (Bx & By & Bz).
  assert (Hone : forall s2 t2 s s', worded 0 (-456) s2 s (Rabs s) -> worded 0 (-456) t2 s' (Rabs s') ->
    worded 2 (-912) (sum (product x2 s2) (product y2 t2)) (x' * s + y' * s') (Rabs x' * Rabs s + Rabs y' * Rabs s')).
  { intros s2 t2 s s' Hs Hs'; apply (worded_plus 1 (-912)); [lia | |]; apply (worded_mult 0 0 (-456) (-456));
    try assumption; try lia.
    - exact (worded_self (-456) x2 Wx Gx).
    - exact (worded_self (-456) y2 Wy Gy). }
  pose proof (Hone _ _ _ _ Ax Bx) as X; pose proof (Hone _ _ _ _ Ay By) as Y; pose proof (Hone _ _ _ _ Az Bz) as Z0;
    clear Hone.
  destruct (norm2_any w2 (proj1 (proj2 X)) (proj1 (proj2 Y)) (proj1 (proj2 Z0))) as (WL & HL & _).
  apply (worded_error 2 _ _ _ _ ltac:(lia)) in X, Y, Z0; simpl INR in X, Y, Z0.
  replace (1001 / 1000 * (1 + 1) * uu) with e in X, Y, Z0 by (unfold e; field).
  assert (Hround : norm (minus (wholes w2) t) <= 201 / 100 * (m + n)).
  { apply Rle_trans with (norm (scale e (plus (scale (Rabs x') (magnitudes a')) (scale (Rabs y') (magnitudes b'))))).
    - apply norm_mono; assumption.
    - rewrite norm_scale, (Rabs_pos_eq e He); apply Rle_trans with (e * (Rabs x' * norm a' + Rabs y' * norm b')).
      + apply Rmult_le_compat_l; [exact He|]; apply Rle_trans with (1 := norm_plus _ _).
        rewrite !norm_scale, !norm_magnitudes, !Rabs_Rabsolu; lra.
      + assert (Rabs x' * norm a' <= 10001 / 10000 * M * (10001 / 10000 * V)) by (apply Rmult_le_compat;
        auto using Rabs_pos, norm_nonneg).
        assert (Rabs y' * norm b' <= 10001 / 10000 * N * (10001 / 10000 * Q)) by (apply Rmult_le_compat;
          auto using Rabs_pos, norm_nonneg).
        apply Rle_trans with (e * (1001 / 1000 * (M * V + N * Q))); [apply Rmult_le_compat_l; lra|]; unfold e, m, n in *;
          lra. }
  clear X Y Z0 Ax Ay Az Bx By Bz.
  (* What the operands bring. *)
  assert (Hoff : norm (minus t w) <= (i + 1003 / 100) * m + (j + 1003 / 100) * n).
  { replace (minus t w) with (plus (plus (scale (x' - x) a') (scale x (minus a' a))) (plus (scale (y' - y) b') (scale y
    (minus b' b))))
      by (unfold t, w, plus, scale, minus; cbn; f_equal; ring).
    apply Rle_trans with (1 := norm_plus _ _); pose proof (norm_plus (scale (x' - x) a') (scale x (minus a' a))) as H1.
    pose proof (norm_plus (scale (y' - y) b') (scale y (minus b' b))) as H2; rewrite !norm_scale in H1, H2.
    assert (Rabs (x' - x) * norm a' <= i * (uu * M) * (10001 / 10000 * V)) by (apply Rmult_le_compat;
      auto using Rabs_pos, norm_nonneg).
    assert (Rabs x * norm (minus a' a) <= M * (1002 / 100 * (uu * V))) by (apply Rmult_le_compat;
      auto using Rabs_pos, norm_nonneg).
    assert (Rabs (y' - y) * norm b' <= j * (uu * N) * (10001 / 10000 * Q)) by (apply Rmult_le_compat;
      auto using Rabs_pos, norm_nonneg).
    assert (Rabs y * norm (minus b' b) <= N * (1002 / 100 * (uu * Q))) by (apply Rmult_le_compat;
      auto using Rabs_pos, norm_nonneg).
    assert (i * m <= 16 * m) by (apply Rmult_le_compat_r; lra); assert (j * n <= 16 * n) by (apply Rmult_le_compat_r; lra).
    replace (i * (uu * M) * (10001 / 10000 * V)) with (10001 / 10000 * (i * m)) in * by (unfold m; field).
    replace (j * (uu * N) * (10001 / 10000 * Q)) with (10001 / 10000 * (j * n)) in * by (unfold n; field).
    replace (M * (1002 / 100 * (uu * V))) with (1002 / 100 * m) in * by (unfold m; field).
    replace (N * (1002 / 100 * (uu * Q))) with (1002 / 100 * n) in * by (unfold n; field); lra. }
  assert (Hw : norm w <= M * V + N * Q).
  { apply Rle_trans with (1 := norm_plus _ _); rewrite !norm_scale.
    assert (Rabs x * norm a <= M * V) by (apply Rmult_le_compat; auto using Rabs_pos, norm_nonneg).
    assert (Rabs y * norm b <= N * Q) by (apply Rmult_le_compat; auto using Rabs_pos, norm_nonneg); lra. }
  split; [exact WL | split; [|exact Hw]].
  pose proof (norm_between (wholes w2) t) as B1; pose proof (norm_between t (wholes w2)) as B2;
    rewrite norm_symmetric in B2.
  pose proof (norm_between t w) as B3; pose proof (norm_between w t) as B4; rewrite norm_symmetric in B4.
  assert (Him : i * m <= 16 * m) by (apply Rmult_le_compat_r; lra);
    assert (Hjn : j * n <= 16 * n) by (apply Rmult_le_compat_r; lra).
  assert (uu * norm (wholes w2) <= uu * (1001 / 1000 * (M * V + N * Q))) by (apply Rmult_le_compat_l; lra).
  apply Rabs_le_inv in HL; apply Rabs_le; unfold m, n in *; lra.
Qed.

(** What is left of the altura, in both. *)
Definition g2 : twofold := difference (exactly h) (s0_2 p centro d).

Lemma number_worded x : ordinary x -> 0 <= x -> worded 0 (-152) (exactly x) x x.
Proof.
  intros O Hx; destruct (ordinary_grid x O) as [Fx Gx]; rewrite <- (Rabs_pos_eq x) at 3 by exact Hx;
    now apply worded_exactly.
Qed.

Lemma g_worded : worded 4 (-304) g2 (h - dot q d) G.
Proof.
  apply (worded_minus 3); [lia | | exact (s0_worded p v centro d ray_fits axis_fits)].
  apply (worded_coarser _ _ (-152)); [lia|]; apply (worded_more 0); [lia | apply number_worded; [exact h_ordinary | lra]].
Qed.

(** ** The coefficients of both *)

Variables square2 product2 height2 wall2 : twofold.
Variable E_fl : R.
Hypothesis square_worded : worded 9 (-912) square2 (slope * slope) (k * S * (k * S)).
Hypothesis product_worded : worded 11 (-912) product2 (rho * slope) (P * (k * S)).
Hypothesis height_worded : worded 13 (-912) height2 (rho * rho) (P * P).
Hypothesis wall_word : double_word wall2.
Hypothesis wall_near : Rabs (whole wall2 - norm wall) <= 262 / 10 * (uu * (P * V)) + 242 / 10 * (uu * (k * S * Q)) + / 100 *
  (uu * W).
Hypothesis wall_size : norm wall <= P * V + k * S * Q.
Hypothesis E_computed : computed 5 (-152) E_fl E E.

Definition unit2 : R := rnd (bpow radix2 (-96) * Conical.kappa_fl k).
Definition A_error2 : R := rnd (rnd (unit2 * V_fl) * V_fl).
Definition B_error2 : R := rnd (rnd (unit2 * V_fl) * E_fl).
Definition C_error2 : R := rnd (rnd (unit2 * E_fl) * E_fl).

Lemma unit_computed2 : computed 3 (-400) unit2 (64 * uu * K) (64 * uu * K).
Proof.
  assert (H96 : bpow radix2 (-96) = 64 * uu) by (replace 64 with (bpow radix2 6) by reflexivity; now rewrite <- bpow_plus).
  rewrite <- H96; pose proof (Cone.k_computed k k_ordinary k_positive) as Ck.
  apply (computed_mult 0 2 (-96) (-304)); [lia | apply Triangle.power_computed; lia|].
  apply (computed_plus 1); [lia | | exact (computed_mult 0 0 (-152) (-152) _ _ _ _ _ _ ltac:(lia) Ck Ck)].
  apply (computed_coarser _ _ 0); [lia|]; apply (computed_more 0); [lia|].
  replace 1 with (bpow radix2 0) by reflexivity; apply Triangle.power_computed; lia.
Qed.

Let HK : 1 <= K /\ k * k <= K := Conical.HK k k_ordinary k_positive.
Let HE : h <= E /\ Q + h <= E /\ 0 < E := Conical.HE p centro h r h_positive r_nonneg.

Lemma errors_low2 : 6399 / 100 * (uu * (K * (V * V))) <= A_error2 /\ 6399 / 100 * (uu * (K * (V * E))) <= B_error2 /\
  6399 / 100 * (uu * (K * (E * E))) <= C_error2 /\ A_error2 <= 130 * (uu * (K * (V * V))).
Proof.
  destruct HE as (HE1 & HE2 & HE3), HK as [HK1 _];
    assert (CV : computed 2 (-152) V_fl V V) by exact (V_computed v (v_ordinary ray_fits)).
  pose proof (computed_mult 3 2 (-400) (-152) _ _ _ _ _ _ ltac:(lia) unit_computed2 CV) as HUV.
  pose proof (computed_mult 6 2 (-552) (-152) _ _ _ _ _ _ ltac:(lia) HUV CV) as HA.
  pose proof (computed_mult 6 5 (-552) (-152) _ _ _ _ _ _ ltac:(lia) HUV E_computed) as HB.
  pose proof (computed_mult 3 5 (-400) (-152) _ _ _ _ _ _ ltac:(lia) unit_computed2 E_computed) as HUE.
  pose proof (computed_mult 9 5 (-552) (-152) _ _ _ _ _ _ ltac:(lia) HUE E_computed) as HC.
  destruct (Triangle.bound_low 9 _ _ _ ltac:(lia) HA) as [LA _], (Triangle.bound_low 12 _ _ _ ltac:(lia) HB) as [LB _],
    (Triangle.bound_low 15 _ _ _ ltac:(lia) HC) as [LC _].
  pose proof (computed_size 9 _ _ _ _ ltac:(lia) HA) as SA; apply Rabs_le_inv in SA; fold A_error2 in LA, SA;
    fold B_error2 in LB; fold C_error2 in LC.
  destruct (uu_part (K * (V * V)) ltac:(repeat apply Rmult_le_pos; lra)) as [P1 _].
  destruct (uu_part (K * (V * E)) ltac:(repeat apply Rmult_le_pos; lra)) as [P2 _].
  destruct (uu_part (K * (E * E)) ltac:(repeat apply Rmult_le_pos; lra)) as [P3 _]; lra.
Qed.

Let X1 := V * Q.
Let X2 := V * h.
Let X3 := V * r.
Let X_parts : 0 <= X1 /\ 0 <= X2 /\ 0 <= X3 /\ K * (V * E) = X1 + X2 + X3 + k * k * (X1 + X2 + X3) :=
  Conical.VE_parts p v centro h k r ray_fits h_positive r_nonneg.
Let k_facts := Conical.k_facts k k_ordinary k_positive.
Let parts_small : 0 <= k * S <= 1000001 / 1000000 * (k * V) /\ 0 <= P <= 1000001 / 1000000 * (r + k * (h + Q)) :=
  Conical.parts_small p v centro d h k r ray_fits axis_fits h_positive k_positive r_nonneg.

(** A difference or a sum of two computed numbers, of sizes m and n, both within Y. *)
Lemma sum_of_near x2 x i m y2 y j n Y : double_word x2 -> double_word y2 -> Rabs (whole x2 - x) <= i * (uu * m) ->
  Rabs x <= m ->
  Rabs (whole y2 - y) <= j * (uu * n) -> Rabs y <= n -> 0 <= i <= 30 -> 0 <= j <= 30 ->
  0 <= m <= 101 / 100 * Y -> 0 <= n <= 101 / 100 * Y ->
  (double_word (sum x2 y2) /\ Rabs (whole (sum x2 y2) - (x + y)) <= (i + j + 3) * (101 / 100) * (uu * Y)) /\
  (double_word (difference x2 y2) /\ Rabs (whole (difference x2 y2) - (x - y)) <= (i + j + 3) * (101 / 100) * (uu * Y)).
Proof.
  intros Wx Wy Hx Sx Hy Sy Hi Hj Hm Hn; pose proof uu_bounds as Hu; pose proof (uu_part Y ltac:(lra)) as HY.
  assert (Him : i * (uu * m) <= i * (uu * (101 / 100 * Y))) by (apply Rmult_le_compat_l; [lra | apply Rmult_le_compat_l;
    lra]).
  assert (Hjn : j * (uu * n) <= j * (uu * (101 / 100 * Y))) by (apply Rmult_le_compat_l; [lra | apply Rmult_le_compat_l;
    lra]).
  assert (HiY : i * (uu * Y) <= 30 * (uu * Y)) by (apply Rmult_le_compat_r; lra).
  assert (HjY : j * (uu * Y) <= 30 * (uu * Y)) by (apply Rmult_le_compat_r; lra).
  assert (One : forall s, Rabs s <= Rabs (whole x2) + Rabs (whole y2) -> uu * Rabs s <= 203 / 100 * (uu * Y)).
  { intros s Hs; replace (203 / 100 * (uu * Y)) with (uu * (203 / 100 * Y)) by ring; apply Rmult_le_compat_l; [lra|].
    pose proof (size_near _ _ _ _ Hx Sx); pose proof (size_near _ _ _ _ Hy Sy); lra. }
  destruct (sum_near _ _ Wx Wy) as [Ws Hs], (difference_near _ _ Wx Wy) as [Wd Hd]; apply six_in_uu in Hs, Hd.
  pose proof (One _ (Rabs_triang _ _)) as E1; pose proof (One (whole x2 - whole y2)
    ltac:(unfold Rminus; apply Rle_trans with (1 := Rabs_triang _ _); rewrite Rabs_Ropp; lra)) as E2.
  apply Rabs_le_inv in Hx, Hy, Hs, Hd; split; (split; [assumption | apply Rabs_le; lra]).
Qed.

Let near3 := products_near p v centro d ray_fits axis_fits.

Lemma worded_near n k' w x m : (n <= 13)%nat -> worded n k' w x m -> Rabs (whole w - x) <= 1302 / 100 * (uu * m).
Proof.
  intros Hn Hw; pose proof (worded_error n _ _ _ _ ltac:(lia) Hw) as He; destruct Hw as ((_ & Hm) & _).
  assert (0 <= m) by (apply Rle_trans with (2 := Hm), Rabs_pos); destruct (uu_part m ltac:(assumption)) as [Hu0 _].
  assert (Hn13 : 0 <= INR n <= 13) by (split; [apply pos_INR | replace 13 with (INR 13) by (simpl; lra); now apply le_INR]).
  apply Rle_trans with (1 := He); replace (1001 / 1000 * INR n * uu * m) with (1001 / 1000 * (INR n * (uu * m))) by ring.
  assert (INR n * (uu * m) <= 13 * (uu * m)) by (apply Rmult_le_compat_r; lra); lra.
Qed.

Definition A_2 : twofold := difference (dot2 a2 a2) square2.
Definition B_2 : twofold := sum (dot2 b2 a2) product2.
Definition C_2 : twofold := difference (dot2 b2 b2) height2.

Lemma A_near2 : double_word A_2 /\ Rabs (whole A_2 - A) <= 40 * (uu * (K * (V * V))) /\ Rabs A <= 3 * (K * (V * V)).
Proof.
  destruct near3 as ((NA & WA & _ & SA) & _), parts_small as [[K0 K1] _], k_facts as (_ & Hkk & _), HK as [HK1 _].
  fold a in NA, SA; fold V in NA, SA; set (Y := K * (V * V)); assert (HVV : 0 <= V * V) by (apply Rmult_le_pos; lra).
  assert (EY : Y = V * V + k * k * (V * V)) by (unfold Y, K; ring);
    assert (Hk0 : 0 <= k * k * (V * V)) by (apply Rmult_le_pos; lra).
  assert (HS : k * S * (k * S) <= 101 / 100 * Y).
  { apply Rle_trans with (1000001 / 1000000 * (k * V) * (1000001 / 1000000 * (k * V))); [apply Rmult_le_compat; lra|].
    replace (1000001 / 1000000 * (k * V) * (1000001 / 1000000 * (k * V)))
      with (1000001 / 1000000 * (1000001 / 1000000) * (k * k * (V * V))) by ring; lra. }
  assert (HS0 : 0 <= k * S * (k * S)) by (apply Rmult_le_pos; lra);
    pose proof (worded_near 9 _ _ _ _ ltac:(lia) square_worded) as NS.
  destruct square_worded as ((_ & MS) & WS & _).
  destruct (sum_of_near _ _ _ _ _ _ _ _ Y WA WS NA SA NS MS ltac:(lra) ltac:(lra) ltac:(split; lra) ltac:(split;
    lra)) as (_ & W1 & N1).
  change (dot a a - slope * slope) with A in N1; destruct (uu_part Y ltac:(lra)) as [HuY _].
  split; [exact W1 | split; [unfold A_2; lra|]]; change A with (dot a a - slope * slope).
  apply Rabs_le_inv in SA, MS; apply Rabs_le; lra.
Qed.

Lemma B_near2 : double_word B_2 /\ Rabs (whole B_2 - B) <= 50 * (uu * (K * (V * E))) /\
  Rabs B <= 3 * (K * (V * E)) /\ parts_on (-912) B_2.
Proof.
  destruct near3 as (_ & (NB & WB & GB & SB) & _), parts_small as [[K0 K1] [P0 P1]], k_facts as (_ & Hkk & Hk).
  fold q in NB, SB; fold a b in NB, SB; fold Q V in NB, SB; replace (Q * V) with X1 in NB, SB by (unfold X1; ring).
  set (Y := K * (V * E)); destruct X_parts as (Y1 & Y2 & Y3 & EY); fold Y in EY.
  pose proof (Hk X3 Y3) as Hk3; assert (Hkk1 : 0 <= k * k * X1) by (apply Rmult_le_pos; lra).
  assert (Hkk2 : 0 <= k * k * X2) by (apply Rmult_le_pos; lra); assert (Hkk3 : 0 <= k * k * X3) by (apply Rmult_le_pos;
    lra).
  assert (Hp : P * (k * S) <= 101 / 100 * Y).
  { apply Rle_trans with (1000001 / 1000000 * (r + k * (h + Q)) * (1000001 / 1000000 * (k * V))); [apply Rmult_le_compat;
    lra|].
    replace (1000001 / 1000000 * (r + k * (h + Q)) * (1000001 / 1000000 * (k * V)))
      with (1000001 / 1000000 * (1000001 / 1000000) * (k * X3 + k * k * X2 + k * k * X1)) by (unfold X1, X2, X3; ring); lra.
      }
  assert (Hp0 : 0 <= P * (k * S)) by (apply Rmult_le_pos; lra);
    pose proof (worded_near 11 _ _ _ _ ltac:(lia) product_worded) as NP.
  destruct product_worded as ((_ & MP) & WP & GP).
  destruct (sum_of_near _ _ _ _ _ _ _ _ Y WB WP NB SB NP MP ltac:(lra) ltac:(lra) ltac:(split; lra) ltac:(split;
    lra)) as ((W1 & N1) & _).
  change (dot b a + rho * slope) with B in N1; destruct (uu_part Y ltac:(lra)) as [HuY _].
  split; [exact W1 | split; [unfold B_2; lra | split; [|now apply parts_sum; [lia|..]]]];
    change B with (dot b a + rho * slope).
  apply Rabs_le_inv in SB, MP; apply Rabs_le; lra.
Qed.

Lemma C_near2 : double_word C_2 /\ Rabs (whole C_2 - C) <= 50 * (uu * (K * (E * E))) /\ parts_on (-912) C_2.
Proof.
  destruct near3 as (_ & _ & (NC & WC & GC & SC)), parts_small as [_ [P0 P1]], k_facts as (_ & Hkk & _), HK as [HK1 _], HE
    as (HE1 & HE2 & HE3).
  fold q in NC, SC; fold b in NC, SC; fold Q in NC, SC; set (Y := K * (E * E));
    assert (HEE : 0 <= E * E) by (apply Rmult_le_pos; lra).
  assert (HY : E * E <= Y) by (unfold Y; rewrite <- (Rmult_1_l (E * E)) at 1; apply Rmult_le_compat_r; lra).
  assert (HQQ : 0 <= Q * Q <= E * E) by (split; [apply Rmult_le_pos | apply Rmult_le_compat]; lra).
  assert (HPP : P * P <= 101 / 100 * Y).
  { apply Rle_trans with (1000001 / 1000000 * (r + k * (h + Q)) * (1000001 / 1000000 * (r + k * (h + Q))));
    [apply Rmult_le_compat; lra|].
    assert (HPP1 : (r + k * (h + Q)) * (r + k * (h + Q)) <= Y).
    { pose proof (Rle_0_sqr (h + Q - k * r)) as Hs; unfold Rsqr in Hs.
      replace Y with ((r + k * (h + Q)) * (r + k * (h + Q)) + (h + Q - k * r) * (h + Q - k * r) + 2 * K * (r * (h + Q)))
        by (unfold Y, K, E; ring).
      assert (0 <= 2 * K * (r * (h + Q))) by (repeat apply Rmult_le_pos; lra); lra. }
    assert (0 <= (r + k * (h + Q)) * (r + k * (h + Q))) by apply Rle_0_sqr; lra. }
  assert (HP0 : 0 <= P * P) by (apply Rmult_le_pos; lra);
    pose proof (worded_near 13 _ _ _ _ ltac:(lia) height_worded) as NH.
  destruct height_worded as ((_ & MH) & WH & GH).
  destruct (sum_of_near _ _ _ _ _ _ _ _ Y WC WH NC SC NH MH ltac:(lra) ltac:(lra) ltac:(split; lra) ltac:(split;
    lra)) as (_ & W1 & N1).
  change (dot b b - rho * rho) with C in N1; destruct (uu_part Y ltac:(lra)) as [HuY _].
  split; [exact W1 | split; [unfold C_2; lra|]]; unfold C_2; rewrite difference_is.
  apply parts_sum; [lia | exact WC | apply (opposite_word _ WH) | exact GC | now apply parts_opposite].
Qed.

Lemma F_H_near2 : let F2 := difference wall2 line2 in let H2 := sum wall2 line2 in double_word F2 /\ double_word H2 /\
  Rabs (whole F2 - F) <= 5 / 6 * B_error2 /\ Rabs (whole H2 - H) <= 5 / 6 * B_error2 /\
  (0 < whole F2 -> whole F2 <= (1 + / 2000) * whole H2) /\ 0 <= norm (cross b a) /\
  Rabs H <= 3 * (K * (V * E)) /\ Rabs (whole H2 - H) <= K * (V * E).
Proof.
  destruct (line_near2 p v centro d ray_fits axis_fits) as
    (HL & WL & HL0 & HL1).
  fold q in HL, HL1; fold Q V a b in HL, HL1; replace (Q * V) with X1 in HL, HL1 by (unfold X1; ring).
  destruct errors_low2 as (_ & LB & _), W_least as (_ & L1 & _), X_parts as (Y1 & Y2 & Y3 & EY), k_facts as (_ & Hkk & Hk).
  destruct parts_small as [[K0 K1] [P0 P1]]; set (Y := K * (V * E)) in *; set (y := bpow radix2 (-450)) in *.
  pose proof (bpow_gt_0 radix2 (-450) : 0 < y) as Hy0; assert (Hky : 0 <= k * y) by (apply Rmult_le_pos; lra).
  pose proof (Hk X1 Y1) as Hk1; pose proof (Hk X2 Y2) as Hk2; assert (Z1 : 0 <= k * k * X1) by (apply Rmult_le_pos; lra).
  assert (Z2 : 0 <= k * k * X2) by (apply Rmult_le_pos; lra); assert (Z3 : 0 <= k * k * X3) by (apply Rmult_le_pos; lra).
  assert (HPV : 0 <= P * V <= 1000001 / 1000000 * (X3 + k * X2 + k * X1)).
  { split; [apply Rmult_le_pos; lra|].
    replace (1000001 / 1000000 * (X3 + k * X2 + k * X1)) with (1000001 / 1000000 * (r + k * (h + Q)) * V) by
      (unfold X1, X2, X3; ring).
    apply Rmult_le_compat_r; lra. }
  assert (HSQ : 0 <= k * S * Q <= 1000001 / 1000000 * (k * X1)).
  { split; [apply Rmult_le_pos; lra|].
    replace (1000001 / 1000000 * (k * X1)) with (1000001 / 1000000 * (k * V) * Q) by (unfold X1; ring);
      apply Rmult_le_compat_r; lra. }
  assert (EW : W = X1 + X2) by (unfold W, X1, X2; ring); set (PV := P * V) in *; set (SQ := k * S * Q) in *.
  pose proof wall_near as NW; pose proof wall_size as SW; fold PV SQ in NW, SW; pose proof (norm_nonneg wall) as HN0.
  pose proof (norm_nonneg (cross b a)) as HL2; pose proof uu_bounds as Hu; rewrite EW in NW, L1.
  set (t := 262 / 10 * PV + 242 / 10 * SQ + 345 / 10 * X1 + / 50 * (X1 + X2)).
  assert (Ht : uu * t = 262 / 10 * (uu * PV) + 242 / 10 * (uu * SQ) + 345 / 10 * (uu * X1) + / 50 * (uu * (X1 + X2))) by
    (unfold t; ring).
  assert (HuX : 0 <= uu * (X1 + X2)) by (apply Rmult_le_pos; lra).
  destruct (factors_near wall2 (norm wall) line2 (norm (cross b a)) (uu * t) wall_word WL HN0 HL2 HL0 ltac:(lra)) as
    (WF & WH & HF & HH & Hbelow).
  assert (Htt : t + (PV + SQ + X1 + / 1000 * t) <= 53 * Y) by (unfold t; lra).
  assert (Ht1 : 0 <= t <= 100 * Y) by (unfold t; split; lra).
  assert (Hs : uu * (norm wall + norm (cross b a) + uu * t) <= uu * (PV + SQ + X1 + / 1000 * t)).
  { apply Rmult_le_compat_l; [lra|]; destruct (uu_part t ltac:(lra)); lra. }
  assert (Hfin : uu * t + uu * (PV + SQ + X1 + / 1000 * t) <= uu * (53 * Y)) by (rewrite <- Rmult_plus_distr_l;
    apply Rmult_le_compat_l; lra).
  destruct (uu_part Y ltac:(lra)) as [HuY HuY'].
  assert (NF : Rabs (whole (difference wall2 line2) - F) <= uu * (53 * Y)) by (apply Rle_trans with (1 := HF); lra).
  assert (NH : Rabs (whole (sum wall2 line2) - H) <= uu * (53 * Y)) by (apply Rle_trans with (1 := HH); lra).
  cbv zeta; split; [exact WF | split; [exact WH|]]; split; [lra | split; [lra|]]; split; [exact Hbelow | split;
    [exact HL2|]].
  split; [|lra]; change H with (norm wall + norm (cross b a)); rewrite Rabs_pos_eq by lra; lra.
Qed.

Theorem conical_sound2 f : Formas.A f = A_2 -> Formas.B f = B_2 -> Formas.C f = C_2 ->
  Formas.F f = difference wall2 line2 -> Formas.H f = sum wall2 line2 ->
  Formas.A_error f = A_error2 -> Formas.B_error f = B_error2 -> Formas.C_error f = C_error2 ->
  sound2 f A B C F H.
Proof.
  intros EA EB EC EF EH EAe EBe ECe; destruct A_near2 as (WA & NA & SA), B_near2 as (WB & NB & SB & GB), C_near2 as
    (WC & NC & GC).
  destruct F_H_near2 as (WF & WH & NF & NH & Hbelow & HL & SH & NH'), errors_low2 as (LA & LB & LC & UA), W_least as
    (HW & _).
  destruct HE as (HE1 & HE2 & HE3), HK as [HK1 _]; pose proof uu_bounds as Hu; pose proof (norm_nonneg wall) as HN0.
  destruct (Conical.sizes_of_bounds p v centro d h k r ray_fits axis_fits h_ordinary h_positive k_ordinary k_positive
    r_ordinary r_nonneg) as (S405 & S407 & _); change (K * (V * V) <= bpow radix2 405) in S405;
      change (K * (V * E) <= bpow radix2 407) in S407.
  pose proof (V_range v (v_ordinary ray_fits) (v_not_zero ray_fits)) as [SV _]; fold V in SV;
  pose proof (r_least h h_ordinary h_positive) as Sh.
  pose proof (bpow_gt_0 radix2 (-100)) as H100.
  assert (Least : forall x y, bpow radix2 (-100) <= x -> bpow radix2 (-100) <= y -> bpow radix2 (-302) <= uu * (K *
    (x * y))).
  { intros x y Hx Hy; change (-302)%Z with (-102 + (-100 + -100))%Z; rewrite !bpow_plus; apply Rmult_le_compat_l; [lra|].
    rewrite <- (Rmult_1_l (bpow radix2 (-100) * bpow radix2 (-100))); apply Rmult_le_compat; try lra; [apply Rmult_le_pos;
      lra|].
    apply Rmult_le_compat; lra. }
  pose proof (Least V V SV SV) as L1; pose proof (Least V E SV ltac:(lra)) as L2;
    pose proof (Least E E ltac:(lra) ltac:(lra)) as L3.
  pose proof (bpow_gt_0 radix2 (-302)); assert (L360 : bpow radix2 (-360) <= bpow radix2 (-302)) by (apply bpow_le; lia).
  destruct (uu_part (K * (V * V)) ltac:(repeat apply Rmult_le_pos; lra)) as [_ U1].
  destruct (uu_part (K * (V * E)) ltac:(repeat apply Rmult_le_pos; lra)) as [_ U2].
  assert (Lift : forall e i X, (i + 3 <= e)%Z -> X <= bpow radix2 i -> 6 * X <= bpow radix2 e).
  { intros e i X Hi HX; apply Rle_trans with (bpow radix2 (i + 3)); [|now apply bpow_le].
    rewrite bpow_plus; replace (bpow radix2 3) with 8 by reflexivity; pose proof (bpow_gt_0 radix2 i); lra. }
  pose proof (Lift 450%Z 405%Z _ ltac:(lia) S405) as S450; pose proof (Lift 440%Z 407%Z _ ltac:(lia) S407) as S440.
  constructor; rewrite ?EA, ?EB, ?EC, ?EF, ?EH, ?EAe, ?EBe, ?ECe; try assumption.
  - tauto.
  - lra.
  - lra.
  - apply Rle_trans with (1 := NC); destruct (uu_part (K * (E * E)) ltac:(repeat apply Rmult_le_pos; lra)) as [U3 _]; lra.
  - exact (Conical.F_times_H p v centro d h k r).
  - change (Rabs (norm wall - norm (cross b a)) <= norm wall + norm (cross b a)); apply Rabs_le; lra.
  - repeat split; apply format_rnd.
  - repeat split; lra.
  - pose proof (leading _ WA); pose proof (leading _ WB); pose proof (leading _ WH); pose proof (size_near _ _ _ _ NA SA).
    pose proof (size_near _ _ _ _ NB SB); pose proof (size_near _ _ _ _ NH' SH).
    split; [lra | split; [lra|]]; apply Rle_trans with (1 := Rle_abs _); lra.
  - split; now apply (sizeable_on_grid (-912)).
Qed.
End Conical.
