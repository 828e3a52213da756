(** * Conical: what the tracer computes of a cone and of a truncated cone in binary64 is within its bounds

    trace/shape/truncated_cone-inl.hpp computes, with q, a and b as for a cylinder, g = altura - s0, rho = radio + k g and
    slope = k s1 (k = proporcion):
      A = a·a - slope²,  B = b·a + rho slope,  C = b·b - rho²,  F, H = |rho a + slope b| ∓ |b × a|
    and trace/shape/cone-inl.hpp the same with radio = 0, as k |g a + s1 b|, k² s1² and so on. With κ = 1 + k² and E the
    extent of q with altura and radio, the bounds are 64 κ units of V V, V E and E E. What both share is shown first, of
    whatever is within what both compute of the parts that k and the radius make.

    S, G, P == the sizes of s1, of g and of rho, as their products and sums are bounded *)
From Coq Require Import Reals ZArith Lra Lia Psatz.
From Flocq Require Import Core.
From Durero Require Import Rounding Vectors Across Decision Flotante.
From Durero Require Cylinder Triangle Advance Formas.
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

Notation q_fl := (q_fl p centro).
Notation V_fl := (extent_fl v).
Let q := minus p centro.
Let a := across v d.
Let b := across q d.
Let a_fl := across_fl v d.
Let b_fl := across_fl q_fl d.
Let Q := extent q.
Let V := extent v.
Let S := size_of_dot v d.
Let G := h + size_of_dot q d.
Let P := r + k * G.
Let E := Q + h + r.
Let K := 1 + k * k.
Definition slope : R := k * dot v d.
Definition rho : R := r + k * (h - dot q d).
Definition wall : vec := plus (scale rho a) (scale slope b).
Definition A : R := dot a a - slope * slope.
Definition B : R := dot b a + rho * slope.
Definition C : R := dot b b - rho * rho.
Definition F : R := norm wall - norm (cross b a).
Definition H : R := norm wall + norm (cross b a).
Let W := V * (Q + h).

Let HV : 0 < V := V_positive v (v_not_zero ray_fits).
Let HQ : 0 <= Q := extent_nonneg q.

Lemma a_facts : on_grid (-456) a_fl /\ norm (minus a_fl a) <= 1006 / 100 * u * V /\ norm a <= V /\ norm a_fl <= 1001 /
  1000 * V.
Proof.
  destruct (Cylinder.a_computed p v centro d ray_fits axis_fits) as [G0 N0]; split; [exact G0|]; split; [exact N0|].
  split; [exact (Cylinder.a_size v centro d axis_fits) | exact (Cylinder.a_fl_size p v centro d ray_fits axis_fits)].
Qed.

Lemma b_facts : on_grid (-456) b_fl /\ norm (minus b_fl b) <= 1207 / 100 * u * Q /\ norm b <= Q /\ norm b_fl <= 1001 /
  1000 * Q.
Proof.
  destruct (Cylinder.b_computed p v centro d ray_fits axis_fits) as [G0 N0]; split; [exact G0|].
  split; [exact N0|]; split; [exact (Cylinder.b_size p centro d axis_fits)|].
  exact (Cylinder.b_fl_size p v centro d ray_fits axis_fits).
Qed.

Lemma sizes_of_axis : 0 <= S <= 1000001 / 1000000 * V /\ h <= G <= 1000001 / 1000000 * (h + Q).
Proof.
  pose proof (size_nonneg v d : 0 <= S) as S0; pose proof (size_nonneg q d) as G0.
  pose proof (size_along v d V (d_unit axis_fits) (norm_le_extent v) (Rlt_le _ _ HV)) as S1; fold S in S1.
  pose proof (size_along q d Q (d_unit axis_fits) (norm_le_extent q) HQ) as G1; unfold G; lra.
Qed.

Lemma uW_least : bpow radix2 (-360) <= u * W /\ bpow radix2 (-390) <= / 1000000 * (u * W).
Proof.
  destruct (Cylinder.bounds_low p v centro d h ray_fits axis_fits h_ordinary h_positive)
    as (_ & _ & _ & _ & _ & _ & L & _); fold q in L; fold V Q in L; fold W in L; split; [exact L|].
  apply Rle_trans with (bpow radix2 (-30) * bpow radix2 (-360)); [rewrite <- bpow_plus; apply bpow_le; lia|].
  apply Rmult_le_compat; try apply bpow_ge_0; [|exact L].
  replace (bpow radix2 (-30)) with (/ 1073741824) by reflexivity; lra.
Qed.

(** The length of what two computed numbers make of a and b: x and y of sizes M and N, off by i and j units. *)
Lemma combined i j x x_fl y y_fl M N : format x_fl -> grid (-456) x_fl -> format y_fl -> grid (-456) y_fl ->
  0 <= i -> 0 <= j -> 0 <= M -> 0 <= N -> Rabs (x_fl - x) <= i * (u * M) -> Rabs (y_fl - y) <= j * (u * N) ->
  Rabs x <= M -> Rabs y <= N -> i <= 16 -> j <= 16 ->
  let w_fl := Vec (rnd (rnd (x_fl * cx a_fl) + rnd (y_fl * cx b_fl))) (rnd (rnd (x_fl * cy a_fl) + rnd (y_fl * cy b_fl)))
    (rnd (rnd (x_fl * cz a_fl) + rnd (y_fl * cz b_fl))) in
  let w := plus (scale x a) (scale y b) in
  Rabs (norm_fl w_fl - norm w) <= (1001 / 1000 * i + 181 / 10) * (u * (M * V)) + (1001 / 1000 * j + 202 / 10) * (u * (N * Q))
    + bpow radix2 (-490) /\
  norm w <= M * V + N * Q.
Proof.
  intros Fx Gx Fy Gy Hi Hj HM HN Hx Hy Sx Sy Hi16 Hj16 w_fl w; pose proof u_bounds as Hu.
  destruct a_facts as (Ga & Na & Sa & Sa'), b_facts as (Gb & Nb & Sb & Sb').
  assert (HuM : 0 <= u * M <= / 1000000000000 * M) by (split; [apply Rmult_le_pos | apply Rmult_le_compat_r]; lra).
  assert (HuN : 0 <= u * N <= / 1000000000000 * N) by (split; [apply Rmult_le_pos | apply Rmult_le_compat_r]; lra).
  assert (HiM : i * (u * M) <= 16 * (u * M)) by (apply Rmult_le_compat_r; lra).
  assert (HjN : j * (u * N) <= 16 * (u * N)) by (apply Rmult_le_compat_r; lra).
  assert (Sx' : Rabs x_fl <= 10001 / 10000 * M) by (apply Rabs_le_inv in Hx, Sx; apply Rabs_le; lra).
  assert (Sy' : Rabs y_fl <= 10001 / 10000 * N) by (apply Rabs_le_inv in Hy, Sy; apply Rabs_le; lra).
  assert (HMV : 0 <= M * V) by (apply Rmult_le_pos; lra); assert (HNQ : 0 <= N * Q) by (apply Rmult_le_pos; lra).
  set (m := u * (M * V)) in *; set (n := u * (N * Q)) in *.
  assert (Hm : 0 <= m <= / 1000000 * (M * V)) by (split; [apply Rmult_le_pos | apply Rmult_le_compat_r]; lra).
  assert (Hn : 0 <= n <= / 1000000 * (N * Q)) by (split; [apply Rmult_le_pos | apply Rmult_le_compat_r]; lra).
  (* Each component is rounded three times. *)
  set (t := plus (scale x_fl a_fl) (scale y_fl b_fl)).
  assert (Hround : norm (minus w_fl t) <= 201 / 100 * (m + n)).
  { pose proof (close_exact _ _ Ga) as (Ax & Ay & Az); pose proof (close_exact _ _ Gb) as (Bx & By & Bz).
    pose proof (computed_exact (-456) _ Fx Gx) as Cx; pose proof (computed_exact (-456) _ Fy Gy) as Cy.
    set (e := 2002 / 1000 * u); assert (He : 0 <= e) by (unfold e; lra).
    assert (Hone : forall s s', computed 0 (-456) s s (Rabs s) -> computed 0 (-456) s' s' (Rabs s') ->
      Rabs (rnd (rnd (x_fl * s) + rnd (y_fl * s')) - (x_fl * s + y_fl * s')) <= e * (Rabs x_fl * Rabs s + Rabs y_fl *
        Rabs s')).
    { intros s s' Hs Hs'.
      pose proof (computed_plus 1 (-912) _ _ _ _ _ _ ltac:(lia) (computed_mult 0 0 (-456) (-456) _ _ _ _ _ _ ltac:(lia)
        Cx Hs)
        (computed_mult 0 0 (-456) (-456) _ _ _ _ _ _ ltac:(lia) Cy Hs')) as Hc.
      pose proof (computed_error_near 2 _ _ _ _ ltac:(lia) Hc) as He2; simpl INR in He2; apply Rle_trans with (1 := He2).
      apply Rmult_le_compat_r; [|unfold e; lra].
      pose proof (Rmult_le_pos _ _ (Rabs_pos x_fl) (Rabs_pos s));
        pose proof (Rmult_le_pos _ _ (Rabs_pos y_fl) (Rabs_pos s')); lra. }
    apply Rle_trans with (norm (scale e (plus (scale (Rabs x_fl) (magnitudes a_fl)) (scale (Rabs y_fl) (magnitudes b_fl))))).
    - apply norm_mono; cbn; apply Hone; assumption.
    - rewrite norm_scale, (Rabs_pos_eq e He); apply Rle_trans with (e * (Rabs x_fl * norm a_fl + Rabs y_fl * norm b_fl)).
      + apply Rmult_le_compat_l; [exact He|]; apply Rle_trans with (1 := norm_plus _ _).
        rewrite !norm_scale, !norm_magnitudes, !Rabs_Rabsolu; lra.
      + assert (Rabs x_fl * norm a_fl <= 10001 / 10000 * M * (1001 / 1000 * V)) by
          (apply Rmult_le_compat; auto using Rabs_pos, norm_nonneg).
        assert (Rabs y_fl * norm b_fl <= 10001 / 10000 * N * (1001 / 1000 * Q)) by
          (apply Rmult_le_compat; auto using Rabs_pos, norm_nonneg).
        apply Rle_trans with (e * (10012 / 10000 * (M * V + N * Q))); [apply Rmult_le_compat_l; lra|].
        unfold e, m, n in *; lra. }
  (* What the operands bring. *)
  assert (Hoff : norm (minus t w) <= (1001 / 1000 * i + 1006 / 100) * m + (1001 / 1000 * j + 1207 / 100) * n).
  { replace (minus t w) with (plus (plus (scale (x_fl - x) a_fl) (scale x (minus a_fl a))) (plus (scale (y_fl - y) b_fl)
      (scale y (minus b_fl b)))) by (unfold t, w, plus, scale, minus; cbn; f_equal; ring).
    apply Rle_trans with (1 := norm_plus _ _); pose proof (norm_plus (scale (x_fl - x) a_fl) (scale x (minus a_fl a))) as H1.
    pose proof (norm_plus (scale (y_fl - y) b_fl) (scale y (minus b_fl b))) as H2; rewrite !norm_scale in H1, H2.
    assert (Rabs (x_fl - x) * norm a_fl <= i * (u * M) * (1001 / 1000 * V)) by (apply Rmult_le_compat;
      auto using Rabs_pos, norm_nonneg).
    assert (Rabs x * norm (minus a_fl a) <= M * (1006 / 100 * u * V)) by (apply Rmult_le_compat;
      auto using Rabs_pos, norm_nonneg).
    assert (Rabs (y_fl - y) * norm b_fl <= j * (u * N) * (1001 / 1000 * Q)) by (apply Rmult_le_compat;
      auto using Rabs_pos, norm_nonneg).
    assert (Rabs y * norm (minus b_fl b) <= N * (1207 / 100 * u * Q)) by (apply Rmult_le_compat;
      auto using Rabs_pos, norm_nonneg).
    unfold m, n in *; lra. }
  assert (Hw : norm w <= M * V + N * Q).
  { apply Rle_trans with (1 := norm_plus _ _); rewrite !norm_scale.
    assert (Rabs x * norm a <= M * V) by (apply Rmult_le_compat; auto using Rabs_pos, norm_nonneg).
    assert (Rabs y * norm b <= N * Q) by (apply Rmult_le_compat; auto using Rabs_pos, norm_nonneg); lra. }
  split; [|exact Hw].
  assert (Hsym : forall s s', norm (minus s s') = norm (minus s' s)) by (intros; unfold norm, dot, minus; cbn; f_equal;
    ring).
  pose proof (norm_between w_fl t) as B1; pose proof (norm_between t w_fl) as B2; rewrite Hsym in B2.
  pose proof (norm_between t w) as B3; pose proof (norm_between w t) as B4; rewrite Hsym in B4.
  pose proof (norm_computed_any w_fl (format_rnd _) (format_rnd _) (format_rnd _)) as Hr.
  assert (Him : i * m <= 16 * m) by (apply Rmult_le_compat_r; lra);
    assert (Hjn : j * n <= 16 * n) by (apply Rmult_le_compat_r; lra).
  assert (u * norm w_fl <= u * (1001 / 1000 * (M * V + N * Q))) by (apply Rmult_le_compat_l; lra).
  apply Rabs_le_inv in Hr; apply Rabs_le; unfold m, n in *; lra.
Qed.

(** ** The coefficients of both *)

Variables square_fl product_fl height_fl wall_fl E_fl : R.
Hypothesis square_computed : computed 9 (-912) square_fl (slope * slope) (k * S * (k * S)).
Hypothesis product_computed : computed 12 (-912) product_fl (rho * slope) (P * (k * S)).
Hypothesis height_computed : computed 15 (-912) height_fl (rho * rho) (P * P).
Hypothesis wall_near : Rabs (wall_fl - norm wall) <=
  254 / 10 * (u * (P * V)) + 244 / 10 * (u * (k * S * Q)) + / 100000 * (u * W).
Hypothesis wall_size : norm wall <= P * V + k * S * Q.
Hypothesis wall_binary64 : format wall_fl.
Hypothesis E_computed : computed 5 (-152) E_fl E E.

Definition kappa_fl : R := rnd (1 + rnd (k * k)).
Definition unit_fl : R := rnd (bpow radix2 (-47) * kappa_fl).
Definition line_fl : R := norm_fl (cross_fl b_fl a_fl).
Definition A_fl : R := rnd (dot_fl a_fl a_fl - square_fl).
Definition B_fl : R := rnd (dot_fl b_fl a_fl + product_fl).
Definition C_fl : R := rnd (dot_fl b_fl b_fl - height_fl).
Definition A_error : R := rnd (rnd (unit_fl * V_fl) * V_fl).
Definition B_error : R := rnd (rnd (unit_fl * V_fl) * E_fl).
Definition C_error : R := rnd (rnd (unit_fl * E_fl) * E_fl).

Lemma k_facts : bpow radix2 (-100) <= k <= bpow radix2 100 /\ 0 < k * k /\ (forall X, 0 <= X -> k * X <= k * k * X + / 4
  * X).
Proof.
  destruct k_ordinary as [_ [Z0|Hk]]; [lra|]; rewrite Rabs_pos_eq in Hk by lra; split; [exact Hk|].
  split; [apply Rmult_lt_0_compat; lra|]; intros X HX; pose proof (Rle_0_sqr (k - / 2)) as Hs; unfold Rsqr in Hs.
  pose proof (Rmult_le_pos _ X Hs HX); lra.
Qed.

Lemma unit_computed : computed 3 (-351) unit_fl (64 * u * K) (64 * u * K).
Proof.
  assert (H47 : bpow radix2 (-47) = 64 * u) by apply multiples_of_u.
  rewrite <- H47; destruct (ordinary_grid k k_ordinary) as [Fk Gk]; pose proof (computed_exact (-152) k Fk Gk) as Ck.
  rewrite (Rabs_pos_eq k) in Ck by lra.
  apply (computed_mult 0 2 (-47) (-304)); [lia | apply Triangle.power_computed; lia|].
  apply (computed_plus 1); [lia | | exact (computed_mult 0 0 (-152) (-152) _ _ _ _ _ _ ltac:(lia) Ck Ck)].
  apply (computed_coarser _ _ 0); [lia|]; apply (computed_more 0); [lia|].
  replace 1 with (bpow radix2 0) by reflexivity; apply Triangle.power_computed; lia.
Qed.

Lemma V_fl_computed : computed 2 (-152) V_fl V V. Proof. exact (V_computed v (v_ordinary ray_fits)). Qed.

Lemma HE : h <= E /\ Q + h <= E /\ 0 < E. Proof. unfold E; lra. Qed.
Lemma HK : 1 <= K /\ k * k <= K. Proof. destruct k_facts as (_ & Hk & _); unfold K; lra. Qed.

Lemma B_error_computed : computed 12 (-655) B_error (64 * u * K * V * E) (64 * u * K * V * E).
Proof.
  exact (computed_mult 6 5 (-503) (-152) _ _ _ _ _ _ ltac:(lia) (computed_mult 3 2 (-351) (-152) _ _ _ _ _ _ ltac:(lia)
    unit_computed
    V_fl_computed) E_computed).
Qed.

Lemma errors_low : 6399 / 100 * (u * (K * (V * V))) <= A_error /\ 6399 / 100 * (u * (K * (V * E))) <= B_error /\
  6399 / 100 * (u * (K * (E * E))) <= C_error /\ A_error <= 130 * (u * (K * (V * V))).
Proof.
  pose proof u_bounds as Hu; pose proof HE as (HE1 & HE2 & HE3); pose proof HK as [HK1 _].
  pose proof (computed_mult 3 2 (-351) (-152) _ _ _ _ _ _ ltac:(lia) unit_computed V_fl_computed) as HUV.
  pose proof (computed_mult 6 2 (-503) (-152) _ _ _ _ _ _ ltac:(lia) HUV V_fl_computed) as HA.
  pose proof (computed_mult 6 5 (-503) (-152) _ _ _ _ _ _ ltac:(lia) HUV E_computed) as HB.
  pose proof (computed_mult 3 5 (-351) (-152) _ _ _ _ _ _ ltac:(lia) unit_computed E_computed) as HUE.
  pose proof (computed_mult 9 5 (-503) (-152) _ _ _ _ _ _ ltac:(lia) HUE E_computed) as HC.
  destruct (Triangle.bound_low 9 _ _ _ ltac:(lia) HA) as [LA _], (Triangle.bound_low 12 _ _ _ ltac:(lia) HB) as [LB _],
    (Triangle.bound_low 15 _ _ _ ltac:(lia) HC) as [LC _]; fold A_error in LA; fold B_error in LB; fold C_error in LC.
  pose proof (computed_size 9 _ _ _ _ ltac:(lia) HA) as SA; fold A_error in SA; apply Rabs_le_inv in SA.
  assert (P1 : 0 <= u * (K * (V * V))) by (repeat apply Rmult_le_pos; lra).
  assert (P2 : 0 <= u * (K * (V * E))) by (repeat apply Rmult_le_pos; lra).
  assert (P3 : 0 <= u * (K * (E * E))) by (repeat apply Rmult_le_pos; lra); lra.
Qed.

Lemma parts_small : 0 <= k * S <= 1000001 / 1000000 * (k * V) /\ 0 <= P <= 1000001 / 1000000 * (r + k * (h + Q)).
Proof.
  destruct sizes_of_axis as [[S0 S1] [G0 G1]]; split; [split; [apply Rmult_le_pos; lra|]|split].
  - replace (1000001 / 1000000 * (k * V)) with (k * (1000001 / 1000000 * V)) by ring; apply Rmult_le_compat_l; lra.
  - unfold P; pose proof (Rmult_le_pos k G ltac:(lra) ltac:(lra)); lra.
  - unfold P; assert (k * G <= k * (1000001 / 1000000 * (h + Q))) by (apply Rmult_le_compat_l; lra); lra.
Qed.

Lemma A_near : Rabs (A_fl - A) <= 40 * (u * (K * (V * V))) /\ Rabs A_fl <= 6 * (K * (V * V)).
Proof.
  pose proof u_bounds as Hu; destruct (Cylinder.A_near p v centro d ray_fits axis_fits) as [N0 S0].
  change (Cylinder.A_fl v d) with (dot_fl a_fl a_fl) in N0, S0; fold V in N0, S0;
    change (dot (across v d) (across v d)) with (dot a a) in N0.
  pose proof (computed_error_near 9 _ _ _ _ ltac:(lia) square_computed) as N1; simpl INR in N1.
  pose proof (computed_size 9 _ _ _ _ ltac:(lia) square_computed) as S1; destruct parts_small as [[K0 K1] _].
  assert (Hkk : k * S * (k * S) <= 100001 / 100000 * (k * k * (V * V))).
  { apply Rle_trans with (1000001 / 1000000 * (k * V) * (1000001 / 1000000 * (k * V))); [apply Rmult_le_compat; lra|].
    assert (0 <= k * k * (V * V)) by (repeat apply Rmult_le_pos; lra); lra. }
  assert (HVV : 0 <= V * V) by (apply Rmult_le_pos; lra); assert (HkV : 0 <= k * k * (V * V)) by (repeat apply
    Rmult_le_pos; lra).
  assert (u * (k * S * (k * S)) <= u * (100001 / 100000 * (k * k * (V * V)))) by (apply Rmult_le_compat_l; lra).
  assert (HuV : 0 <= u * (V * V) <= / 1000000 * (V * V)) by (split; [apply Rmult_le_pos | apply Rmult_le_compat_r]; lra).
  assert (HukV : 0 <= u * (k * k * (V * V)) <= / 1000000 * (k * k * (V * V))) by (split;
    [apply Rmult_le_pos | apply Rmult_le_compat_r]; lra).
  pose proof (rnd_plus (dot_fl a_fl a_fl) (- square_fl) (format_rnd _) (generic_format_opp _ _ _ (proj1 (proj2
    square_computed)))) as Hr.
  fold (dot_fl a_fl a_fl - square_fl) in Hr; fold A_fl in Hr.
  assert (Hs : Rabs (dot_fl a_fl a_fl - square_fl) <= 3 * (V * V) + 21 / 10 * (k * k * (V * V))).
  { unfold Rminus; apply Rle_trans with (1 := Rabs_triang _ _); rewrite Rabs_Ropp; lra. }
  assert (u * Rabs (dot_fl a_fl a_fl - square_fl) <= u * (3 * (V * V) + 21 / 10 * (k * k * (V * V)))) by (apply
    Rmult_le_compat_l; lra).
  assert (EK : K * (V * V) = V * V + k * k * (V * V)) by (unfold K; ring); rewrite EK.
  apply Rabs_le_inv in Hr, N0, N1, Hs; unfold A; split; apply Rabs_le; lra.
Qed.

Let X1 := V * Q.
Let X2 := V * h.
Let X3 := V * r.
Lemma VE_parts : 0 <= X1 /\ 0 <= X2 /\ 0 <= X3 /\ K * (V * E) = X1 + X2 + X3 + k * k * (X1 + X2 + X3).
Proof.
  unfold X1, X2, X3, K, E; split; [apply Rmult_le_pos; lra|]; split; [apply Rmult_le_pos; lra|].
  split; [apply Rmult_le_pos; lra | ring].
Qed.

Lemma B_near : Rabs (B_fl - B) <= 50 * (u * (K * (V * E))) /\ Rabs B_fl <= 6 * (K * (V * E)) /\ grid (-912) B_fl.
Proof.
  pose proof u_bounds as Hu.
  destruct (Cylinder.B_near p v centro d ray_fits axis_fits) as (N0 & S0
    & G0).
  change (Cylinder.B_fl p v centro d) with (dot_fl b_fl a_fl) in N0, S0, G0; fold q in N0, S0; fold V Q in N0, S0.
  change (dot (across q d) (across v d)) with (dot b a) in N0; replace (Q * V) with X1 in N0, S0 by (unfold X1; ring).
  pose proof (computed_error_near 12 _ _ _ _ ltac:(lia) product_computed) as N1; simpl INR in N1.
  pose proof (computed_size 12 _ _ _ _ ltac:(lia) product_computed) as S1; destruct parts_small as [[K0 K1] [P0 P1]].
  destruct VE_parts as (Y1 & Y2 & Y3 & ->), k_facts as (_ & Hkk & Hk).
  pose proof (Hk X3 Y3) as Hk3; assert (Hkk1 : 0 <= k * k * X1) by (apply Rmult_le_pos; lra).
  assert (Hkk2 : 0 <= k * k * X2) by (apply Rmult_le_pos; lra); assert (Hkk3 : 0 <= k * k * X3) by (apply Rmult_le_pos; lra).
  set (Y := X1 + X2 + X3 + k * k * (X1 + X2 + X3)); assert (HY : 0 <= Y) by (unfold Y; lra).
  assert (Hp : P * (k * S) <= 100001 / 100000 * Y).
  { apply Rle_trans with (1000001 / 1000000 * (r + k * (h + Q)) * (1000001 / 1000000 * (k * V))); [apply Rmult_le_compat;
    lra|].
    replace (1000001 / 1000000 * (r + k * (h + Q)) * (1000001 / 1000000 * (k * V)))
      with (1000001 / 1000000 * (1000001 / 1000000) * (k * X3 + k * k * X2 + k * k * X1)) by (unfold X1, X2, X3; ring).
    unfold Y; lra. }
  assert (HX : X1 <= Y) by (unfold Y; lra).
  assert (HuX : u * X1 <= u * Y) by (apply Rmult_le_compat_l; lra); assert (HuX0 : 0 <= u * X1) by (apply Rmult_le_pos; lra).
  assert (HuY : u * Y <= / 1000000 * Y) by (apply Rmult_le_compat_r; lra).
  assert (u * (P * (k * S)) <= u * (100001 / 100000 * Y)) by (apply Rmult_le_compat_l; lra).
  pose proof (rnd_plus (dot_fl b_fl a_fl) product_fl (format_rnd _) (proj1 (proj2 product_computed))) as Hr; fold B_fl in Hr.
  assert (Hs : Rabs (dot_fl b_fl a_fl + product_fl) <= 3 * X1 + 201 / 100 * Y) by (apply Rle_trans with (1 :=
    Rabs_triang _ _); lra).
  assert (u * Rabs (dot_fl b_fl a_fl + product_fl) <= u * (3 * X1 + 201 / 100 * Y)) by (apply Rmult_le_compat_l; lra).
  split; [|split].
  - apply Rabs_le_inv in Hr, N0, N1; unfold B; apply Rabs_le; lra.
  - apply Rabs_le_inv in Hr, Hs; apply Rabs_le; lra.
  - apply grid_rnd; [lia|]; apply grid_plus; [exact G0 | exact (proj2 (proj2 product_computed))].
Qed.

Lemma C_near : Rabs (C_fl - C) <= 60 * (u * (K * (E * E))).
Proof.
  pose proof u_bounds as Hu; destruct b_facts as (Gb & Nb & Sb & Sb').
  destruct (Cylinder.dot_off (1207 / 100) (1207 / 100) b b_fl b b_fl Q Q Gb Gb ltac:(lra) ltac:(lra) HQ HQ Sb Sb' Sb' Nb Nb)
    as (N0 & S0 & _).
  pose proof (computed_error_near 15 _ _ _ _ ltac:(lia) height_computed) as N1; simpl INR in N1.
  pose proof (computed_size 15 _ _ _ _ ltac:(lia) height_computed) as S1; destruct parts_small as [_ [P0 P1]].
  destruct k_facts as (_ & Hkk & _); pose proof HK as [HK1 _]; pose proof HE as (HE1 & HE2 & HE3).
  set (Y := K * (E * E)); assert (HEE : 0 <= E * E) by (apply Rmult_le_pos; lra).
  assert (HY : E * E <= Y) by (unfold Y; rewrite <- (Rmult_1_l (E * E)) at 1; apply Rmult_le_compat_r; lra).
  assert (HQQ : Q * Q <= E * E) by (apply Rmult_le_compat; lra).
  assert (HPP : P * P <= 100001 / 100000 * Y).
  { apply Rle_trans with (1000001 / 1000000 * (r + k * (h + Q)) * (1000001 / 1000000 * (r + k * (h + Q))));
    [apply Rmult_le_compat; lra|].
    assert (HPP1 : (r + k * (h + Q)) * (r + k * (h + Q)) <= Y).
    { pose proof (Rle_0_sqr (h + Q - k * r)) as Hs; unfold Rsqr in Hs.
      replace Y with ((r + k * (h + Q)) * (r + k * (h + Q)) + (h + Q - k * r) * (h + Q - k * r) + 2 * K * (r * (h + Q)))
        by (unfold Y, K, E; ring).
      assert (0 <= 2 * K * (r * (h + Q))) by (repeat apply Rmult_le_pos; lra); lra. }
    assert (0 <= (r + k * (h + Q)) * (r + k * (h + Q))) by apply Rle_0_sqr; lra. }
  assert (HuQ : u * (Q * Q) <= u * Y) by (apply Rmult_le_compat_l; lra).
  assert (HuP : u * (P * P) <= u * (100001 / 100000 * Y)) by (apply Rmult_le_compat_l; lra).
  assert (HuY : 0 <= u * Y) by (apply Rmult_le_pos; lra).
  pose proof (rnd_plus (dot_fl b_fl b_fl) (- height_fl) (format_rnd _) (generic_format_opp _ _ _ (proj1 (proj2
    height_computed)))) as Hr.
  fold (dot_fl b_fl b_fl - height_fl) in Hr; fold C_fl in Hr.
  assert (Hs : Rabs (dot_fl b_fl b_fl - height_fl) <= 3 * Y + 201 / 100 * Y).
  { unfold Rminus; apply Rle_trans with (1 := Rabs_triang _ _); rewrite Rabs_Ropp; lra. }
  assert (u * Rabs (dot_fl b_fl b_fl - height_fl) <= u * (3 * Y + 201 / 100 * Y)) by (apply Rmult_le_compat_l; lra).
  apply Rabs_le_inv in Hr, N0, N1; unfold C; apply Rabs_le; lra.
Qed.

(** What the distances of the surface and of the line are at most, and what they err by, of V E. *)
Lemma walls_of_VE : 254 / 10 * (P * V) + 244 / 10 * (k * S * Q) + 38 * X1 + 101 / 100 * (P * V + k * S * Q) + / 500 * W
  <= 5325 / 100 * (K * (V * E))
  /\ P * V + k * S * Q + X1 <= 21 / 10 * (K * (V * E)) /\ 0 <= P * V /\ 0 <= k * S * Q.
Proof.
  destruct parts_small as [[K0 K1] [P0 P1]], VE_parts as (Y1 & Y2 & Y3 & ->), k_facts as (_ & Hkk & Hk).
  pose proof (Hk X1 Y1); pose proof (Hk X2 Y2); assert (0 <= k * k * X1) by (apply Rmult_le_pos; lra).
  assert (0 <= k * k * X2) by (apply Rmult_le_pos; lra); assert (0 <= k * k * X3) by (apply Rmult_le_pos; lra).
  assert (HPV : P * V <= 1000001 / 1000000 * (X3 + k * X2 + k * X1)).
  { replace (1000001 / 1000000 * (X3 + k * X2 + k * X1)) with (1000001 / 1000000 * (r + k * (h + Q)) * V) by (unfold X1,
    X2, X3; ring).
    apply Rmult_le_compat_r; lra. }
  assert (HSQ : k * S * Q <= 1000001 / 1000000 * (k * X1)).
  { replace (1000001 / 1000000 * (k * X1)) with (1000001 / 1000000 * (k * V) * Q) by (unfold X1; ring);
    apply Rmult_le_compat_r; lra. }
  assert (EW : W = X1 + X2) by (unfold W, X1, X2; ring); rewrite EW.
  split; [lra|]; split; [lra|]; split; apply Rmult_le_pos; lra.
Qed.

Lemma F_H_near : Rabs (rnd (wall_fl - line_fl) - F) <= 5 / 6 * B_error /\ Rabs (rnd (wall_fl + line_fl) - H) <= 5 / 6 *
  B_error /\
  0 <= norm (cross b a) <= X1.
Proof.
  pose proof u_bounds as Hu; destruct walls_of_VE as (Hall & Hsmall & PV0 & SQ0), errors_low as (_ & LB & _ & _).
  assert (NL : Rabs (line_fl - norm (cross b a)) <= 36 * (u * X1) + / 100000 * (u * W)).
  { apply Rle_trans with (1 := Cylinder.line_near p v centro d h ray_fits axis_fits h_ordinary h_positive).
    change (36 * u * (Q * V) + / 100000 * (u * W) <= 36 * (u * X1) + / 100000 * (u * W)); unfold X1; lra. }
  destruct a_facts as (_ & _ & Sa & _), b_facts as (_ & _ & Sb & _), VE_parts as (Y1 & Y2 & Y3 & EY).
  pose proof wall_near as NW; pose proof wall_size as SW.
  assert (HL : 0 <= norm (cross b a) <= X1).
  { split; [apply norm_nonneg|]; apply Rle_trans with (1 := cross_le _ _); replace X1 with (Q * V) by (unfold X1; ring).
    apply Rmult_le_compat; auto using norm_nonneg. }
  pose proof (norm_nonneg wall) as HN0; set (Y := K * (V * E)) in *; set (PV := P * V) in *; set (SQ := k * S * Q) in *.
  assert (EW : W = X1 + X2) by (unfold W, X1, X2; ring).
  assert (Hsmallu : forall X, 0 <= X -> 0 <= u * X <= / 1000000 * X) by (intros; split;
    [apply Rmult_le_pos | apply Rmult_le_compat_r]; lra).
  pose proof (Hsmallu PV PV0); pose proof (Hsmallu SQ SQ0); pose proof (Hsmallu X1 Y1);
    pose proof (Hsmallu W ltac:(lra)) as HuW.
  assert (Hu1 : u * (254 / 10 * PV + 244 / 10 * SQ + 38 * X1 + 101 / 100 * (PV + SQ) + / 500 * W) <= u * (5325 / 100 *
    Y)) by (apply Rmult_le_compat_l; lra).
  assert (Hs : forall s, s = wall_fl - line_fl \/ s = wall_fl + line_fl -> u * Rabs s <= u * (1001 / 1000 * (PV + SQ +
    X1) + / 1000 * W)).
  { intros s Hs; apply Rmult_le_compat_l; [lra|]; apply Rabs_le_inv in NW, NL; apply Rabs_le; destruct Hs as [-> | ->];
    lra. }
  pose proof (Hs _ (or_introl eq_refl)) as Hs1; pose proof (Hs _ (or_intror eq_refl)) as Hs2.
  pose proof (rnd_plus wall_fl (- line_fl) wall_binary64 (generic_format_opp _ _ _ (format_rnd _))) as RF;
    fold (wall_fl - line_fl) in RF.
  pose proof (rnd_plus wall_fl line_fl wall_binary64 (format_rnd _)) as RH.
  assert (HuY : 0 <= u * Y) by (apply Rmult_le_pos; lra).
  assert (Hfin : u * (5325 / 100 * Y) <= 5 / 6 * B_error) by lra.
  apply Rabs_le_inv in RF, RH, NL, NW.
  split; [|split; [|exact HL]]; apply Rle_trans with (2 := Hfin); unfold F, H; apply Rabs_le; lra.
Qed.

Lemma F_times_H : B * B - A * C = F * H.
Proof.
  unfold F, H; replace ((norm wall - norm (cross b a)) * (norm wall + norm (cross b a)))
    with (norm wall * norm wall - norm (cross b a) * norm (cross b a)) by ring.
  rewrite !norm_square; pose proof (cross_and_dot b a) as L; replace (dot wall wall)
    with (rho * rho * dot a a + 2 * rho * slope * dot b a + slope * slope * dot b b)
    by (unfold wall, plus, scale, dot; cbn; ring).
  unfold B, A, C; lra.
Qed.

Lemma sizes_of_bounds : K * (V * V) <= bpow radix2 405 /\ K * (V * E) <= bpow radix2 407 /\
  bpow radix2 (-360) <= u * (V * V) /\ bpow radix2 (-360) <= u * (E * E).
Proof.
  destruct k_facts as ([_ Hk] & Hkk & _); pose proof (V_size v (v_ordinary ray_fits) : V <= _) as HV102;
    pose proof HE as (HE1 & HE2 & HE3).
  pose proof (proj2 (extent_of_difference p centro (p_ordinary ray_fits) (centro_ordinary axis_fits)) : Q <= _) as HQ103;
    pose proof HK as [HK1 _].
  pose proof (ordinary_size h h_ordinary) as Hh; rewrite Rabs_pos_eq in Hh by lra.
  pose proof (ordinary_size r r_ordinary) as Hr; rewrite Rabs_pos_eq in Hr by lra.
  assert (HK201 : K <= bpow radix2 201).
  { change 201%Z with (1 + (100 + 100))%Z; rewrite !bpow_plus; replace (bpow radix2 1) with 2 by reflexivity.
    assert (k * k <= bpow radix2 100 * bpow radix2 100) by (apply Rmult_le_compat; lra).
    assert (1 <= bpow radix2 100 * bpow radix2 100) by (rewrite <- bpow_plus;
      replace 1 with (bpow radix2 0) by reflexivity; apply bpow_le; lia).
    unfold K; lra. }
  assert (HE104 : E <= bpow radix2 104).
  { replace (bpow radix2 103) with (8 * bpow radix2 100) in HQ103 by (replace 8 with (bpow radix2 3) by reflexivity;
    now rewrite <- bpow_plus).
    replace (bpow radix2 104) with (16 * bpow radix2 100) by (replace 16 with (bpow radix2 4) by reflexivity;
      now rewrite <- bpow_plus).
    pose proof (bpow_gt_0 radix2 100); unfold E; lra. }
  split; [|split; [|split]].
  - change 405%Z with (201 + (102 + 102))%Z; rewrite !bpow_plus; repeat apply Rmult_le_compat; try apply Rmult_le_pos; lra.
  - change 407%Z with (201 + (102 + 104))%Z; rewrite !bpow_plus; repeat apply Rmult_le_compat; try apply Rmult_le_pos; lra.
  - destruct (Advance.speed_near p v ray_fits) as [V1 V2]; fold V in V1, V2.
    pose proof (grid_at_least _ _ (proj2 (proj2 V_fl_computed)) ltac:(lra)) as L; rewrite Rabs_pos_eq in L by lra.
    assert (L153 : bpow radix2 (-153) <= V).
    { change (-153)%Z with (-1 + -152)%Z; rewrite bpow_plus; replace (bpow radix2 (-1)) with (/ 2) by reflexivity; lra. }
    apply Rle_trans with (u * (bpow radix2 (-153) * bpow radix2 (-153))); [rewrite <- !bpow_plus; apply bpow_le; lia|].
    apply Rmult_le_compat_l; [apply bpow_ge_0|]; apply Rmult_le_compat; auto using bpow_ge_0.
  - pose proof (r_least h h_ordinary h_positive) as L.
    apply Rle_trans with (u * (bpow radix2 (-100) * bpow radix2 (-100))); [rewrite <- !bpow_plus; apply bpow_le; lia|].
    apply Rmult_le_compat_l; [apply bpow_ge_0|]; apply Rmult_le_compat; try apply bpow_ge_0; lra.
Qed.

Theorem conical_sound f : Formas.A f = A_fl -> Formas.B f = B_fl -> Formas.C f = C_fl -> Formas.F f = rnd (wall_fl -
  line_fl) ->
  Formas.H f = rnd (wall_fl + line_fl) -> Formas.A_error f = A_error -> Formas.B_error f = B_error -> Formas.C_error f =
    C_error ->
  sound f A B C F H.
Proof.
  intros EA EB EC EF EH EAe EBe ECe; pose proof u_bounds as Hu; pose proof HK as [HK1 _]; pose proof HE as (HE1 & HE2 & HE3).
  destruct A_near as [NA SA], B_near as (NB & SB & GB), F_H_near as (NF & NH & HL), errors_low as (LA & LB & LC & UA).
  destruct sizes_of_bounds as (S405 & S407 & L1 & L2), uW_least as [L3 _], walls_of_VE as (_ & Hsmall & PV0 & SQ0).
  assert (HVV : 0 <= V * V) by (apply Rmult_le_pos; lra); assert (HVE : 0 <= V * E) by (apply Rmult_le_pos; lra).
  assert (HEE : 0 <= E * E) by (apply Rmult_le_pos; lra).
  assert (Hunit : forall X, 0 <= X -> u * X <= u * (K * X) /\ u * (K * X) <= / 1000 * (K * X) /\ 0 <= u * (K * X)).
  { intros X HX; assert (0 <= K * X) by (apply Rmult_le_pos; lra); split; [apply Rmult_le_compat_l; [lra|] | split].
    - rewrite <- (Rmult_1_l X) at 1; apply Rmult_le_compat_r; lra.
    - apply Rmult_le_compat_r; lra.
    - apply Rmult_le_pos; lra. }
  destruct (Hunit _ HVV) as (U1 & U2 & U3), (Hunit _ HVE) as (U4 & U5 & U6), (Hunit _ HEE) as (U7 & _ & U9).
  assert (HuW : u * W <= u * (V * E)).
  { apply Rmult_le_compat_l; [lra|]; unfold W; apply Rmult_le_compat_l; lra. }
  pose proof wall_size as SW; pose proof (norm_nonneg wall) as HN0;
    assert (Hline : 0 <= line_fl) by (apply rnd_nonneg, sqrt_pos).
  constructor; rewrite ?EA, ?EB, ?EC, ?EF, ?EH, ?EAe, ?EBe, ?ECe.
  - apply Rle_trans with (1 := NA); lra.
  - apply Rle_trans with (1 := NB); lra.
  - apply Rle_trans with (1 := C_near); lra.
  - exact NF.
  - exact NH.
  - exact F_times_H.
  - unfold F, H; apply Rabs_le; lra.
  - apply rnd_le; lra.
  - repeat split; apply format_rnd.
  - exact GB.
  - split; [lra | split; lra].
  - assert (Hlift : forall e i X, (i + 3 <= e)%Z -> X <= bpow radix2 i -> 6 * X <= bpow radix2 e).
    { intros e i X Hi HX; apply Rle_trans with (bpow radix2 (i + 3)); [|now apply bpow_le].
      rewrite bpow_plus; replace (bpow radix2 3) with 8 by reflexivity; pose proof (bpow_gt_0 radix2 i); lra. }
    split; [|split].
    + apply Rle_trans with (1 := SA), (Hlift 450%Z 405%Z); [lia | exact S405].
    + apply Rle_trans with (1 := SB), (Hlift 440%Z 407%Z); [lia | exact S407].
    + apply Rle_trans with (6 * (K * (V * E))); [|apply (Hlift 440%Z 407%Z); [lia | exact S407]].
      pose proof (computed_size 12 _ _ _ _ ltac:(lia) B_error_computed) as Hs; apply Rabs_le_inv in NH, Hs;
        unfold H in NH; lra.
  - apply Rle_trans with (1 := UA); apply Rle_trans with (bpow radix2 405); [lra | apply bpow_le; lia].
Qed.

End Conical.
