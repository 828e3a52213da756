(** * Cone: the recorded quadratics of a cone and of a truncated cone are within their bounds

    Conical.v shows it of whatever is within what both compute of g = altura - s0, of the radius and of the slope; here are
    these parts of Formas.tronco and of Formas.cono. *)
From Coq Require Import Reals ZArith Lra Lia Psatz.
From Flocq Require Import Core.
From Durero Require Import Rounding Vectors Across Decision Flotante Conical.
From Durero Require Formas.
Local Open Scope R_scope.
Local Opaque bpow.

Section Cone.
Variables p v centro d : vec.
Variables h k : R.
Hypothesis ray_fits : fit_ray p v.
Hypothesis axis_fits : fit_axis centro d.
Hypothesis h_ordinary : ordinary h.
Hypothesis h_positive : 0 < h.
Hypothesis k_ordinary : ordinary k.
Hypothesis k_positive : 0 < k.
Notation q_fl := (q_fl p centro).
Notation V_fl := (extent_fl v).
Let q := minus p centro.
Let Q := extent q.
Let V := extent v.
Let S := size_of_dot v d.
Let G := h + size_of_dot q d.
Let W := V * (Q + h).
Let g := h - dot q d.
Let s1 := dot v d.
Let a_fl := across_fl v d.
Let b_fl := across_fl q_fl d.
Definition g_fl : R := rnd (h - dot_fl q_fl d).

Lemma exact_number x : ordinary x -> 0 <= x -> computed 0 (-152) x x x.
Proof.
  intros O Hx; destruct (ordinary_grid x O) as [F0 G0]; rewrite <- (Rabs_pos_eq x Hx) at 3; now apply computed_exact.
Qed.

Lemma g_computed : computed 5 (-304) g_fl g G.
Proof.
  apply (computed_minus 4); [lia | |].
  - apply (computed_coarser _ _ (-152)); [lia|]; apply (computed_more 0); [lia | apply exact_number;
    [exact h_ordinary | lra]].
  - exact (dot_computed 1 0 (-152) (-152) q_fl d q d ltac:(lia) (q_close p centro (p_ordinary ray_fits) (centro_ordinary
    axis_fits))
      (close_exact _ _ (ordinary_on_grid d (d_ordinary axis_fits)))).
Qed.

Lemma s1_computed : computed 3 (-304) (dot_fl v d) s1 S.
Proof.
  exact (dot_computed 0 0 (-152) (-152) v d v d ltac:(lia) (v_close v (v_ordinary ray_fits)) (close_exact _ _
    (ordinary_on_grid d
    (d_ordinary axis_fits)))).
Qed.

Lemma k_computed : computed 0 (-152) k k k.
Proof. apply exact_number; [exact k_ordinary | lra]. Qed.

Lemma reach_computed : computed 4 (-152) (rnd (extent_fl q_fl + h)) (Q + h) (Q + h).
Proof.
  apply (computed_plus 3); [lia | exact (extent_computed 1 (-152) q_fl q ltac:(lia) (q_close p centro (p_ordinary ray_fits)
    (centro_ordinary axis_fits)))|].
  apply (computed_more 0); [lia | apply exact_number; [exact h_ordinary | lra]].
Qed.

(** ** The truncated cone *)
Section Truncated.
Variable r : R.
Hypothesis r_ordinary : ordinary r.
Hypothesis r_positive : 0 < r.
Let P := r + k * G.
Definition slope_fl : R := rnd (k * dot_fl v d).
Definition rho_fl : R := rnd (r + rnd (k * g_fl)).
Definition wall_fl : vec := Vec (rnd (rnd (rho_fl * cx a_fl) + rnd (slope_fl * cx b_fl)))
  (rnd (rnd (rho_fl * cy a_fl) + rnd (slope_fl * cy b_fl))) (rnd (rnd (rho_fl * cz a_fl) + rnd (slope_fl * cz b_fl))).
Definition E_fl : R := rnd (rnd (extent_fl q_fl + h) + r).

Lemma slope_computed : computed 4 (-456) slope_fl (slope v d k) (k * S).
Proof. exact (computed_mult 0 3 (-152) (-304) _ _ _ _ _ _ ltac:(lia) k_computed s1_computed). Qed.

Lemma rho_computed : computed 7 (-456) rho_fl (rho p centro d h k r) P.
Proof.
  apply (computed_plus 6); [lia | |].
  - apply (computed_coarser _ _ (-152)); [lia|]; apply (computed_more 0); [lia | apply exact_number;
    [exact r_ordinary | lra]].
  - exact (computed_mult 0 5 (-152) (-304) _ _ _ _ _ _ ltac:(lia) k_computed g_computed).
Qed.

Lemma wall_of_truncated : Rabs (norm_fl wall_fl - norm (wall p v centro d h k r)) <=
    254 / 10 * (u * (P * V)) + 244 / 10 * (u * (k * S * Q)) + / 100000 * (u * W) /\
  norm (wall p v centro d h k r) <= P * V + k * S * Q.
Proof.
  destruct slope_computed as ((NS & MS) & FS & GS) eqn:ES, rho_computed as ((NR & MR) & FR & GR) eqn:ER; clear ES ER.
  pose proof (computed_error_near 4 _ _ _ _ ltac:(lia) slope_computed) as HS; simpl INR in HS.
  pose proof (computed_error_near 7 _ _ _ _ ltac:(lia) rho_computed) as HR; simpl INR in HR.
  assert (HkS : 0 <= k * S) by (apply Rle_trans with (2 := MS), Rabs_pos);
    assert (HP : 0 <= P) by (apply Rle_trans with (2 := MR), Rabs_pos).
  destruct (combined p v centro d ray_fits axis_fits (701 / 100) (401 / 100)
    (rho p centro d h k r) rho_fl (slope v d k) slope_fl P (k * S) FR GR FS GS) as [HN HW]; try lra.
  - assert (0 <= u * P) by (apply Rmult_le_pos; [apply bpow_ge_0 | exact HP]); apply Rle_trans with (1 := HR); lra.
  - assert (0 <= u * (k * S)) by (apply Rmult_le_pos; [apply bpow_ge_0 | exact HkS]); apply Rle_trans with (1 := HS); lra.
  - split; [|exact HW]; destruct (uW_least p v centro d h ray_fits axis_fits h_ordinary h_positive) as [_ L].
    change (bpow radix2 (-390) <= / 1000000 * (u * W)) in L;
      assert (bpow radix2 (-490) <= bpow radix2 (-390)) by (apply bpow_le; lia).
    assert (0 <= u * (P * V)) by (repeat apply Rmult_le_pos; try apply bpow_ge_0; try exact HP; apply extent_nonneg).
    assert (0 <= u * (k * S * Q)) by (apply Rmult_le_pos; [apply bpow_ge_0 | apply Rmult_le_pos;
      [exact HkS | apply extent_nonneg]]).
    apply Rle_trans with (1 := HN); fold q; fold V Q; pose proof (bpow_gt_0 radix2 (-490)); lra.
Qed.

Theorem recorded_truncated : Formas.tronco p v V_fl centro r k d h =
  Formas.Quadratic (A_fl v d (rnd (slope_fl * slope_fl))) (B_fl p v centro d (rnd (rho_fl * slope_fl)))
    (C_fl p centro d (rnd (rho_fl * rho_fl))) (rnd (norm_fl wall_fl - line_fl p v centro d))
    (rnd (norm_fl wall_fl + line_fl p v centro d)) (A_error v k) (B_error v k E_fl) (C_error k E_fl)
    (dot_fl q_fl d) (dot_fl v d) h (rnd (extent_fl q_fl + h)) V_fl 0 0.
Proof.
  cbv beta iota zeta delta [Formas.tronco Conical.A_fl Conical.B_fl Conical.C_fl Conical.A_error Conical.B_error
    Conical.C_error
    unit_fl kappa_fl line_fl E_fl rho_fl slope_fl wall_fl g_fl a_fl b_fl norm_fl cross_fl dot_fl
    across_fl Flotante.q_fl minus_fl extent_fl cx cy cz].
  reflexivity.
Qed.

Theorem truncated_sound : sound (Formas.tronco p v V_fl centro r k d h) (A v d k) (B p v centro d h k r) (C p centro d h k r)
  (F p v centro d h k r) (H p v centro d h k r).
Proof.
  rewrite recorded_truncated; destruct wall_of_truncated as [Hn Hs].
  apply (conical_sound p v centro d h k r ray_fits axis_fits h_ordinary h_positive k_ordinary k_positive r_ordinary
    (Rlt_le _ _ r_positive) (rnd (slope_fl * slope_fl)) (rnd (rho_fl * slope_fl))
    (rnd (rho_fl * rho_fl)) (norm_fl wall_fl) E_fl); try reflexivity.
  - exact (computed_mult 4 4 (-456) (-456) _ _ _ _ _ _ ltac:(lia) slope_computed slope_computed).
  - exact (computed_mult 7 4 (-456) (-456) _ _ _ _ _ _ ltac:(lia) rho_computed slope_computed).
  - exact (computed_mult 7 7 (-456) (-456) _ _ _ _ _ _ ltac:(lia) rho_computed rho_computed).
  - exact Hn.
  - exact Hs.
  - apply format_rnd.
  - apply (computed_plus 4); [lia | exact reach_computed | apply (computed_more 0); [lia | apply exact_number;
    [exact r_ordinary | lra]]].
Qed.
End Truncated.

(** ** The cone: a truncated one of radius 0 at the top *)

Definition wall_of_cone : vec := Vec (rnd (rnd (g_fl * cx a_fl) + rnd (dot_fl v d * cx b_fl)))
  (rnd (rnd (g_fl * cy a_fl) + rnd (dot_fl v d * cy b_fl))) (rnd (rnd (g_fl * cz a_fl) + rnd (dot_fl v d * cz b_fl))).
Definition height_fl : R := rnd (k * norm_fl wall_of_cone).

Lemma no_radius : ordinary 0.
Proof. split; [apply generic_format_0 | now left]. Qed.

Lemma wall_of_cone_near : Rabs (height_fl - norm (wall p v centro d h k 0)) <=
    254 / 10 * (u * ((0 + k * G) * V)) + 244 / 10 * (u * (k * S * Q)) + / 100000 * (u * W) /\
  norm (wall p v centro d h k 0) <= (0 + k * G) * V + k * S * Q.
Proof.
  destruct g_computed as ((NG & MG) & FG & GG) eqn:EG, s1_computed as ((N1 & M1) & F1 & G1) eqn:E1; clear EG E1.
  pose proof (computed_error_near 5 _ _ _ _ ltac:(lia) g_computed) as HG; simpl INR in HG.
  pose proof (computed_error_near 3 _ _ _ _ ltac:(lia) s1_computed) as H1; simpl INR in H1; pose proof u_bounds as Hu.
  assert (HG0 : 0 <= G) by (apply Rle_trans with (2 := MG), Rabs_pos);
    assert (HS0 : 0 <= S) by (apply Rle_trans with (2 := M1), Rabs_pos).
  pose proof (extent_nonneg v : 0 <= V) as HV0; pose proof (extent_nonneg q : 0 <= Q) as HQ0.
  assert (HGV : 0 <= G * V) by (apply Rmult_le_pos; lra); assert (HSQ : 0 <= S * Q) by (apply Rmult_le_pos; lra).
  assert (HuG : 0 <= u * G) by (apply Rmult_le_pos; lra); assert (HuS : 0 <= u * S) by (apply Rmult_le_pos; lra).
  destruct (combined p v centro d ray_fits axis_fits (501 / 100) (301 / 100)
    g g_fl s1 (dot_fl v d) G S FG (grid_coarser (-456) (-304) _ ltac:(lia) GG) F1 (grid_coarser (-456) (-304) _
      ltac:(lia) G1))
    as [HN HW]; try lra.
  fold a_fl b_fl wall_of_cone in HN; fold q in HN, HW; fold V Q in HN, HW;
    set (w := plus (scale g (across v d)) (scale s1 (across q d))) in *.
  assert (EW : norm (wall p v centro d h k 0) = k * norm w).
  { replace (wall p v centro d h k 0) with (scale k w); [rewrite norm_scale, Rabs_pos_eq; lra|].
    unfold w, wall, rho, slope, plus, scale, g, s1, q; cbn; f_equal; ring. }
  rewrite EW; set (n := norm_fl wall_of_cone) in *; pose proof (norm_nonneg w) as Hw0.
  destruct (uW_least p v centro d h ray_fits axis_fits h_ordinary h_positive) as [_ L].
  change (bpow radix2 (-390) <= / 1000000 * (u * W)) in L; destruct (k_facts k k_ordinary k_positive) as ([_ Hk] & _).
  set (y := bpow radix2 (-490)) in *; pose proof (bpow_gt_0 radix2 (-490) : 0 < y) as Hy0.
  assert (Hky : k * y <= bpow radix2 (-390)).
  { change (-390)%Z with (100 + -490)%Z; rewrite bpow_plus; apply Rmult_le_compat_r; [apply bpow_ge_0 | exact Hk]. }
  assert (Hz : 0 < bpow radix2 (-1074) <= bpow radix2 (-390)) by (split; [apply bpow_gt_0 | apply bpow_le; lia]).
  set (m1 := u * (G * V)) in *; set (m2 := u * (S * Q)) in *.
  assert (Hm1 : 0 <= m1 <= / 1000000 * (G * V)) by (split; [apply Rmult_le_pos | apply Rmult_le_compat_r]; lra).
  assert (Hm2 : 0 <= m2 <= / 1000000 * (S * Q)) by (split; [apply Rmult_le_pos | apply Rmult_le_compat_r]; lra).
  assert (HN' : Rabs (n - norm w) <= 232 / 10 * m1 + 233 / 10 * m2 + y) by (apply Rle_trans with (1 := HN); lra).
  assert (Hn0 : 0 <= n) by (apply rnd_nonneg, sqrt_pos).
  assert (Hn : n <= 1001 / 1000 * (G * V + S * Q) + y) by (apply Rabs_le_inv in HN'; lra).
  assert (Hd : Rabs (k * n - k * norm w) <= k * (232 / 10 * m1 + 233 / 10 * m2 + y)).
  { rewrite <- Rmult_minus_distr_l, Rabs_mult, (Rabs_pos_eq k) by lra; apply Rmult_le_compat_l; lra. }
  pose proof (rnd_any (k * n)) as Hr; change (rnd (k * n)) with height_fl in Hr;
    rewrite (Rabs_pos_eq (k * n)) in Hr by (apply Rmult_le_pos; lra).
  assert (Hkn : k * n <= k * (1001 / 1000 * (G * V + S * Q) + y)) by (apply Rmult_le_compat_l; lra).
  assert (Hukn : u * (k * n) <= u * (k * (1001 / 1000 * (G * V + S * Q) + y))) by (apply Rmult_le_compat_l; lra).
  assert (Huky : u * (k * y) <= 1 * (k * y)) by (apply Rmult_le_compat_r; [apply Rmult_le_pos|]; lra).
  assert (Hkm1 : 0 <= k * m1) by (apply Rmult_le_pos; lra); assert (Hkm2 : 0 <= k * m2) by (apply Rmult_le_pos; lra).
  split.
  - replace (u * ((0 + k * G) * V)) with (k * m1) by (unfold m1; ring);
    replace (u * (k * S * Q)) with (k * m2) by (unfold m2; ring).
    replace (u * (k * (1001 / 1000 * (G * V + S * Q) + y))) with (1001 / 1000 * (k * m1 + k * m2) + u * (k * y)) in Hukn
      by (unfold m1, m2; ring).
    apply Rabs_le_inv in Hr, Hd; apply Rabs_le; lra.
  - replace ((0 + k * G) * V + k * S * Q) with (k * (G * V + S * Q)) by ring; apply Rmult_le_compat_l; lra.
Qed.

Theorem recorded_cone : Formas.cono p v V_fl centro k d h =
  Formas.Quadratic (A_fl v d (rnd (rnd (k * k) * rnd (dot_fl v d * dot_fl v d))))
    (B_fl p v centro d (rnd (rnd (k * k) * rnd (g_fl * dot_fl v d)))) (C_fl p centro d (rnd (rnd (k * k) * rnd (g_fl *
      g_fl))))
    (rnd (height_fl - line_fl p v centro d)) (rnd (height_fl + line_fl p v centro d)) (A_error v k)
    (B_error v k (rnd (extent_fl q_fl + h))) (C_error k (rnd (extent_fl q_fl + h)))
    (dot_fl q_fl d) (dot_fl v d) h (rnd (extent_fl q_fl + h)) V_fl 0 0.
Proof.
  cbv beta iota zeta delta [Formas.cono Conical.A_fl Conical.B_fl Conical.C_fl Conical.A_error Conical.B_error
    Conical.C_error
    unit_fl kappa_fl line_fl wall_of_cone height_fl g_fl a_fl b_fl norm_fl cross_fl dot_fl
    across_fl Flotante.q_fl minus_fl extent_fl cx cy cz].
  reflexivity.
Qed.

Theorem cone_sound : sound (Formas.cono p v V_fl centro k d h) (A v d k) (B p v centro d h k 0) (C p centro d h k 0)
  (F p v centro d h k 0) (H p v centro d h k 0).
Proof.
  rewrite recorded_cone; destruct wall_of_cone_near as [Hn Hs].
  pose proof (computed_mult 0 0 (-152) (-152) _ _ _ _ _ _ ltac:(lia) k_computed k_computed) as K2.
  pose proof g_computed as Cg; pose proof s1_computed as C1.
  pose proof (computed_mult 1 7 (-304) (-608) _ _ _ _ _ _ ltac:(lia) K2 (computed_mult 3 3 (-304) (-304) _ _ _ _ _ _
    ltac:(lia) C1 C1)) as HA.
  pose proof (computed_mult 1 9 (-304) (-608) _ _ _ _ _ _ ltac:(lia) K2 (computed_mult 5 3 (-304) (-304) _ _ _ _ _ _
    ltac:(lia) Cg C1)) as HB.
  pose proof (computed_mult 1 11 (-304) (-608) _ _ _ _ _ _ ltac:(lia) K2 (computed_mult 5 5 (-304) (-304) _ _ _ _ _ _
    ltac:(lia) Cg Cg)) as HC.
  apply (conical_sound p v centro d h k 0 ray_fits axis_fits h_ordinary h_positive k_ordinary k_positive no_radius
    (Rle_refl 0) (rnd (rnd (k * k) * rnd (dot_fl v d * dot_fl v d)))
    (rnd (rnd (k * k) * rnd (g_fl * dot_fl v d))) (rnd (rnd (k * k) * rnd (g_fl * g_fl))) height_fl
    (rnd (extent_fl q_fl + h))); try reflexivity.
  - replace (slope v d k * slope v d k) with (k * k * (s1 * s1)) by (unfold slope, s1; ring).
    fold S; replace (k * S * (k * S)) with (k * k * (S * S)) by ring; exact HA.
  - replace (rho p centro d h k 0 * slope v d k) with (k * k * (g * s1)) by (unfold rho, slope, g, s1, q; ring).
    fold q S G; replace ((0 + k * G) * (k * S)) with (k * k * (G * S)) by ring; apply (computed_more 11); [lia | exact HB].
  - replace (rho p centro d h k 0 * rho p centro d h k 0) with (k * k * (g * g)) by (unfold rho, g, q; ring).
    fold q G; replace ((0 + k * G) * (0 + k * G)) with (k * k * (G * G)) by ring; apply (computed_more 13); [lia | exact HC].
  - exact Hn.
  - exact Hs.
  - apply format_rnd.
  - fold q Q; replace (Q + h + 0) with (Q + h) by ring; apply (computed_more 4); [lia | exact reach_computed].
Qed.
End Cone.
