(** * Flotante: what the tracer computes of a sphere in binary64 is within its bounds

    trace/quadratic-inl.hpp computes, each operation rounded once, with q = p - centro:
      A = v·v,  B = q·v,  C = q·q - r²,  F, H = r|v| ∓ |q × v|  (√(v·v) for |v|)
      V = |v.x| + |v.y| + |v.z|,  E = |q.x| + |q.y| + |q.z| + r
      A_error = 2^-47·V·V,  B_error = 2^-47·V·E,  C_error = 2^-47·E·E
    The recorded term Formas.esfera is this ([recorded]), and its bounds hold for numbers that are ordinary, as the tracer
    takes no others ([sphere_sound]): then nothing underflows or overflows, and [rnd] is the rounding. What is decided of
    them is Decision.v's, and the slab test is in Slab.v.

    ordinary x    == x is a binary64, 0 or of magnitude 2^-100 to 2^100
    fit_ray p v   == what is asked of a ray by what is proved of any surface; ordinary_ray, by what needs no direction
    fit_axis c d  == what is asked of an axis from c along d, or of a normal d at c
    X_fl, X_error == the computed X and its computed bound, for the names above *)
From Coq Require Import Reals ZArith Lra Lia Psatz.
From Flocq Require Import Core.
From Durero Require Import Rounding Vectors Quotient Decision.
From Durero Require Formas.
Local Open Scope R_scope.
Local Opaque bpow.

(** ** What is asked of numbers *)

Definition ordinary (x : R) : Prop :=
  format x /\ (x = 0 \/ bpow radix2 (-100) <= Rabs x <= bpow radix2 100).
Definition ordinary_vec (a : vec) : Prop := ordinary (cx a) /\ ordinary (cy a) /\ ordinary (cz a).

Record ordinary_ray (p v : vec) : Prop := Ordinary_ray { p_ordinary : ordinary_vec p; v_ordinary : ordinary_vec v }.
Record fit_ray (p v : vec) : Prop := Fit_ray { ray_ordinary :> ordinary_ray p v; v_not_zero : 0 < norm v }.
Record fit_axis (centro d : vec) : Prop := Fit_axis {
  centro_ordinary : ordinary_vec centro; d_ordinary : ordinary_vec d; d_unit : Rabs (dot d d - 1) <= / 1000000 }.
Arguments p_ordinary {p v}.
Arguments v_ordinary {p v}.
Arguments v_not_zero {p v}.
Arguments centro_ordinary {centro d}.
Arguments d_ordinary {centro d}.
Arguments d_unit {centro d}.

(** The recorded test of a number's range asks just that. *)
Lemma in_range_ordinary x : format x -> Formas.in_range x = true <-> ordinary x.
Proof.
  intros Fx; unfold Formas.in_range, ordinary; cbv zeta; rewrite Bool.orb_true_iff, Bool.andb_true_iff.
  assert (Zero : Req_bool (Rabs x) 0 = true <-> x = 0).
  { destruct (Req_bool_spec (Rabs x) 0) as [E|E]; split; intros H; try easy.
    - destruct (Req_dec x 0) as [X|X]; [exact X | now apply Rabs_no_R0 in X].
    - now rewrite H, Rabs_R0 in E. }
  assert (Le : forall a b, Rle_bool a b = true <-> a <= b).
  { intros a b; destruct (Rle_bool_spec a b); split; intros; (easy || lra). }
  rewrite Zero, !Le; tauto.
Qed.
Lemma ray_in_range_ordinary p v : format (cx p) -> format (cy p) -> format (cz p) ->
  format (cx v) -> format (cy v) -> format (cz v) -> Formas.ray_in_range p v = true <-> ordinary_ray p v.
Proof.
  intros Px Py Pz Vx Vy Vz; unfold Formas.ray_in_range; rewrite !Bool.andb_true_iff, !in_range_ordinary by assumption.
  split; [intros (((? & ?) & ?) & (? & ?) & ?); now constructor | intros [(? & ? & ?) (? & ? & ?)]; tauto].
Qed.

(** ** The sphere *)

Section Sphere.

Variables p v centro : vec.
Variable r : R.
Hypothesis p_ordinary : ordinary_vec p.
Hypothesis v_ordinary : ordinary_vec v.
Hypothesis centro_ordinary : ordinary_vec centro.
Hypothesis r_ordinary : ordinary r.
Hypothesis r_positive : 0 < r.
Hypothesis v_not_zero : 0 < norm v.

Let q := minus p centro.
Let A := dot v v.
Let B := dot q v.
Let C := dot q q - r * r.
Let D := B * B - A * C.
Let F := r * norm v - norm (cross q v).
Let H := r * norm v + norm (cross q v).
Let V := extent v.
Let E := extent q + r.

Definition q_fl : vec := minus_fl p centro.
Definition A_fl : R := dot_fl v v.
Definition B_fl : R := dot_fl q_fl v.
Definition C_fl : R := rnd (dot_fl q_fl q_fl - rnd (r * r)).
Definition of_surface : R := rnd (r * norm_fl v).
Definition of_line : R := norm_fl (cross_fl q_fl v).
Definition F_fl : R := rnd (of_surface - of_line).
Definition H_fl : R := rnd (of_surface + of_line).
Definition V_fl : R := extent_fl v.
Definition E_fl : R := rnd (extent_fl q_fl + r).
Definition A_error : R := rnd (rnd (bpow radix2 (-47) * V_fl) * V_fl).
Definition B_error : R := rnd (rnd (bpow radix2 (-47) * V_fl) * E_fl).
Definition C_error : R := rnd (rnd (bpow radix2 (-47) * E_fl) * E_fl).

Lemma ordinary_grid x : ordinary x -> format x /\ grid (-152) x.
Proof. intros [Fx Hx]; split; [assumption | apply (format_grid (-100)); [lia | assumption | tauto]]. Qed.

Lemma ordinary_on_grid a : ordinary_vec a -> on_grid (-152) a.
Proof. intros (X & Y & Z); apply ordinary_grid in X, Y, Z; unfold on_grid; tauto. Qed.

Lemma q_close : close 1 (-152) q_fl q.
Proof.
  pose proof (ordinary_on_grid _ p_ordinary) as (? & ? & ? & ? & ? & ?).
  pose proof (ordinary_on_grid _ centro_ordinary) as (? & ? & ? & ? & ? & ?).
  split; [|split]; apply computed_difference; auto; lia.
Qed.

Lemma v_close : close 0 (-152) v v.
Proof. now apply close_exact, ordinary_on_grid. Qed.

Lemma r_computed : computed 0 (-152) r r r.
Proof.
  destruct (ordinary_grid r r_ordinary) as [Fr Gr]; rewrite <- (Rabs_pos_eq r) at 3 by lra; now apply computed_exact.
Qed.

Lemma V_positive : 0 < V.
Proof. apply Rlt_le_trans with (1 := v_not_zero), norm_le_extent. Qed.

Lemma E_positive : r <= E.
Proof. unfold E; pose proof (extent_nonneg q); lra. Qed.

Lemma V_computed : computed 2 (-152) V_fl V V.
Proof. apply (extent_computed 0); [lia | exact v_close]. Qed.

Lemma E_computed : computed 4 (-152) E_fl E E.
Proof.
  apply computed_plus; [lia | apply (extent_computed 1); [lia | exact q_close] | apply (computed_more 0);
    [lia | exact r_computed]].
Qed.

Lemma unit_computed : computed 0 (-47) (bpow radix2 (-47)) (64 * u) (64 * u).
Proof.
  replace (64 * u) with (bpow radix2 (-47)) by (replace 64 with (bpow radix2 6) by reflexivity;
    now rewrite <- bpow_plus).
  rewrite <- (Rabs_pos_eq (bpow radix2 (-47))) at 3 by apply bpow_ge_0; apply computed_exact.
  - apply generic_format_bpow; unfold FLT_exp; lia.
  - exists 1%Z; ring.
Qed.

(** The computed bounds are at least 63 of their 64 units. *)
Lemma error_bound m k x x_fl y y_fl : computed 4 (-152) x_fl x x -> computed 4 (-152) y_fl y y -> 0 <= x -> 0 <= y ->
  m = rnd (rnd (bpow radix2 (-47) * x_fl) * y_fl) -> k = 64 * u * x * y ->
  63 / 64 * k <= m /\ computed 10 (-351) m k k.
Proof.
  intros Hx Hy Hx0 Hy0 -> ->.
  assert (Hc : computed 10 (-351) (rnd (rnd (bpow radix2 (-47) * x_fl) * y_fl)) (64 * u * x * y) (64 * u * x * y)).
  { apply (computed_mult 5 4 (-199) (-152)); [lia | | assumption].
    apply (computed_mult 0 4 (-47) (-152)); [lia | exact unit_computed | assumption]. }
  split; [|exact Hc]; pose proof (computed_error 10 _ _ _ _ ltac:(lia) Hc) as He; simpl INR in He.
  apply Rabs_le_inv in He; pose proof u_bounds.
  assert (0 <= 64 * u * x * y) by (repeat apply Rmult_le_pos; lra).
  assert (20 * u * (64 * u * x * y) <= / 64 * (64 * u * x * y)) by (apply Rmult_le_compat_r; lra); lra.
Qed.

(** ** A, B and C *)

Theorem A_bound : Rabs (A_fl - A) <= A_error.
Proof.
  pose proof V_positive; pose proof u_bounds.
  destruct (error_bound A_error (64 * u * V * V) V V_fl V V_fl) as [Hm _]; auto; try lra;
    try (apply (computed_more 2); [lia | exact V_computed]).
  pose proof (dot_computed 0 0 (-152) (-152) v v v v ltac:(lia) v_close v_close) as Hc.
  pose proof (computed_error 3 _ _ _ _ ltac:(lia) Hc) as He; simpl INR in He.
  apply Rle_trans with (1 := He); pose proof (size_of_dot_le v v : _ <= V * V).
  assert (0 <= u * (V * V)) by (repeat apply Rmult_le_pos; lra).
  assert (u * size_of_dot v v <= u * (V * V)) by (apply Rmult_le_compat_l; lra); lra.
Qed.

Theorem B_bound : Rabs (B_fl - B) <= 8 * u * (V * E) <= B_error.
Proof.
  pose proof V_positive; pose proof E_positive; pose proof u_bounds; pose proof (extent_nonneg q).
  destruct (error_bound B_error (64 * u * V * E) V V_fl E E_fl) as [Hm _]; auto; try lra;
    try (apply (computed_more 2); [lia | exact V_computed]); try exact E_computed.
  pose proof (dot_computed 1 0 (-152) (-152) q_fl v q v ltac:(lia) q_close v_close) as Hc.
  pose proof (computed_error 4 _ _ _ _ ltac:(lia) Hc) as He; simpl INR in He;
    pose proof (size_of_dot_le q v : _ <= extent q * V).
  assert (size_of_dot q v <= V * E) by (pose proof (Rmult_le_pos V r ltac:(lra) ltac:(lra)); unfold E; lra).
  assert (0 <= u * (V * E)) by (repeat apply Rmult_le_pos; lra).
  assert (u * size_of_dot q v <= u * (V * E)) by (apply Rmult_le_compat_l; lra).
  split; [apply Rle_trans with (1 := He) |]; lra.
Qed.

Theorem C_bound : Rabs (C_fl - C) <= C_error.
Proof.
  pose proof E_positive; pose proof u_bounds; pose proof (extent_nonneg q).
  destruct (error_bound C_error (64 * u * E * E) E E_fl E E_fl) as [Hm _]; auto; try lra; try exact E_computed.
  pose proof (dot_computed 1 1 (-152) (-152) q_fl q_fl q q ltac:(lia) q_close q_close) as Hc.
  pose proof (computed_mult 0 0 (-152) (-152) _ _ _ _ _ _ ltac:(lia) r_computed r_computed) as Hr.
  pose proof (computed_minus 5 (-304) _ _ _ _ _ _ ltac:(lia) Hc (computed_more 1 5 (-304) _ _ _ ltac:(lia) Hr)) as Hd.
  pose proof (computed_error 6 _ _ _ _ ltac:(lia) Hd) as He; simpl INR in He.
  apply Rle_trans with (1 := He); pose proof (size_of_dot_le q q).
  assert (size_of_dot q q + r * r <= E * E) by (pose proof (Rmult_le_pos (extent q) r ltac:(lra) ltac:(lra)); unfold E; lra).
  assert (0 <= u * (E * E)) by (repeat apply Rmult_le_pos; lra).
  assert (u * (size_of_dot q q + r * r) <= u * (E * E)) by (apply Rmult_le_compat_l; lra); lra.
Qed.

(** ** The discriminant *)

Lemma cross_computed : on_grid (-304) (cross_fl q_fl v) /\
  extent (minus (cross_fl q_fl v) (cross q v)) <= 6 * u * (extent q * V).
Proof.
  destruct q_close as (Qx & Qy & Qz), v_close as (Vx & Vy & Vz); pose proof u_bounds.
  assert (Hone : forall a b a' b' x y x' y' m n m' n',
    computed 1 (-152) a x m -> computed 0 (-152) b y n -> computed 1 (-152) a' x' m' -> computed 0 (-152) b' y' n' ->
    computed 3 (-304) (rnd (rnd (a * b) - rnd (a' * b'))) (x * y - x' * y') (m * n + m' * n')).
  { intros; apply (computed_minus 2 (-304)); [lia | |]; apply (computed_mult 1 0 (-152) (-152)); auto; lia. }
  pose proof (Hone _ _ _ _ _ _ _ _ _ _ _ _ Qy Vz Qz Vy) as X.
  pose proof (Hone _ _ _ _ _ _ _ _ _ _ _ _ Qz Vx Qx Vz) as Y.
  pose proof (Hone _ _ _ _ _ _ _ _ _ _ _ _ Qx Vy Qy Vx) as Z.
  split; [destruct X as (_ & ? & ?), Y as (_ & ? & ?), Z as (_ & ? & ?); repeat split; assumption|].
  apply (computed_error 3 _ _ _ _ ltac:(lia)) in X, Y, Z; simpl INR in X, Y, Z.
  unfold extent at 1, minus; simpl; apply Rle_trans with (1 := Rplus_le_compat _ _ _ _ (Rplus_le_compat _ _ _ _ X Y) Z).
  assert (P : forall x y, 0 <= Rabs x * Rabs y) by (intros; apply Rmult_le_pos; apply Rabs_pos); unfold V, extent.
  match goal with |- ?a <= 6 * u * ?b => replace a with (6 * u * (b - Rabs (cx q) * Rabs (cx v)
    - Rabs (cy q) * Rabs (cy v) - Rabs (cz q) * Rabs (cz v))) by ring end.
  pose proof (P (cx q) (cx v)); pose proof (P (cy q) (cy v)); pose proof (P (cz q) (cz v)); apply Rmult_le_compat_l; lra.
Qed.

Lemma cross_norm : norm (cross q v) <= extent q * V.
Proof.
  assert (norm (cross q v) * norm (cross q v) <= (norm q * norm v) * (norm q * norm v)).
  { replace (norm q * norm v * (norm q * norm v)) with (norm q * norm q * (norm v * norm v)) by ring.
    rewrite !norm_square; replace (dot q q * dot v v) with (dot (cross q v) (cross q v) + dot q v * dot q v)
      by (unfold dot, cross; simpl; ring).
    pose proof (Rle_0_sqr (dot q v)) as Hs; unfold Rsqr in Hs; lra. }
  apply Rle_trans with (norm q * norm v).
  - apply Rnot_lt_le; intros Hlt.
    pose proof (Rmult_le_pos _ _ (norm_nonneg q) (norm_nonneg v)) as Hn.
    pose proof (Rmult_le_0_lt_compat _ _ _ _ Hn Hn Hlt Hlt); lra.
  - apply Rmult_le_compat; try apply norm_nonneg; apply norm_le_extent.
Qed.

(** What F and H are the difference and the sum of: the distances of the surface and of the line, times |v|. *)
Lemma of_line_bound : Rabs (of_line - norm (cross q v)) <= 15 * u * (extent q * V) /\
  (of_line = 0 \/ bpow radix2 (-304) <= of_line).
Proof.
  destruct cross_computed as [HG He]; pose proof u_bounds; pose proof cross_norm as Hn.
  destruct (norm_computed (-304) _ ltac:(lia) HG) as [Hl Hlow]; fold of_line in *; split; [|assumption].
  pose proof (norm_lipschitz (cross_fl q_fl v) (cross q v)) as Hd; pose proof (norm_nonneg (cross_fl q_fl v)).
  pose proof (Rmult_le_pos _ _ (extent_nonneg q) (Rlt_le _ _ V_positive)) as HQV.
  assert (u * (extent q * V) <= / 1000000 * (extent q * V)) by (apply Rmult_le_compat_r; lra).
  apply Rabs_le_inv in Hd; assert (norm (cross_fl q_fl v) <= (1 + 6 * / 1000000) * (extent q * V)) by lra.
  assert (u * norm (cross_fl q_fl v) <= u * ((1 + 6 * / 1000000) * (extent q * V))) by (apply Rmult_le_compat_l; lra).
  apply Rabs_le_inv in Hl; apply Rabs_le; lra.
Qed.

Lemma r_least : bpow radix2 (-100) <= r.
Proof. destruct r_ordinary as [_ [H0|[H0 _]]]; [lra | now rewrite Rabs_pos_eq in H0 by lra]. Qed.

Lemma of_surface_bound : Rabs (of_surface - r * norm v) <= 10 * u * (r * V) /\
  (of_surface = 0 \/ bpow radix2 (-404) <= of_surface) /\ 0 < of_surface.
Proof.
  pose proof u_bounds; pose proof r_least as Hr; pose proof (norm_le_extent v : _ <= V) as Hv.
  destruct (norm_computed (-152) v ltac:(lia) (ordinary_on_grid v v_ordinary)) as [Hl Hlow].
  assert (Hpos : bpow radix2 (-152) <= norm_fl v).
  { destruct Hlow as [Z0|?]; [exfalso; rewrite Z0 in Hl; apply Rabs_le_inv in Hl | assumption].
    assert (8 * u * norm v <= / 2 * norm v) by (apply Rmult_le_compat_r; lra); lra. }
  pose proof (bpow_gt_0 radix2 (-152)); pose proof (bpow_gt_0 radix2 (-100)).
  assert (Hprod : bpow radix2 (-252) <= r * norm_fl v).
  { change (-252)%Z with (-100 + -152)%Z; rewrite bpow_plus; apply Rmult_le_compat; lra. }
  pose proof (bpow_gt_0 radix2 (-252)).
  assert (Hrnd : Rabs (of_surface - r * norm_fl v) <= u * (r * norm_fl v)).
  { rewrite <- (Rabs_pos_eq (r * norm_fl v)) at 2 by lra; apply rnd_rel; right; rewrite Rabs_pos_eq by lra.
    apply Rle_trans with (2 := Hprod), bpow_le; lia. }
  assert (Hlow404 : bpow radix2 (-404) <= of_surface).
  { replace (bpow radix2 (-404)) with (rnd (bpow radix2 (-404))).
    - apply rnd_le, Rle_trans with (2 := Hprod), bpow_le; lia.
    - apply round_generic; [auto with typeclass_instances | apply generic_format_bpow; unfold FLT_exp; lia]. }
  split; [|split; [now right | pose proof (bpow_gt_0 radix2 (-404)); lra]].
  assert (Hl2 : Rabs (r * norm_fl v - r * norm v) <= r * (8 * u * norm v)).
  { rewrite <- Rmult_minus_distr_l, Rabs_mult, (Rabs_pos_eq r) by lra; apply Rmult_le_compat_l; lra. }
  pose proof (Rmult_le_compat_l r _ _ (Rlt_le _ _ r_positive) Hv) as Hrv; pose proof V_positive.
  apply Rabs_le_inv in Hrnd, Hl2; pose proof (Rmult_le_pos r (norm v) ltac:(lra) (norm_nonneg v)).
  assert (8 * u * (r * norm v) <= 8 * u * (r * V)) by (apply Rmult_le_compat_l; lra).
  assert (u * (r * norm_fl v) <= u * (2 * (r * V))) by (apply Rmult_le_compat_l; [lra|];
    assert (8 * u * (r * norm v) <= 1 * (r * norm v)) by (apply Rmult_le_compat_r; lra); lra).
  apply Rabs_le; lra.
Qed.

Lemma F_H_bound : Rabs (F_fl - F) <= 18 * u * (V * E) /\ Rabs (H_fl - H) <= 18 * u * (V * E).
Proof.
  destruct of_line_bound as [Hl _], of_surface_bound as [Hs _]; pose proof u_bounds; pose proof V_positive.
  pose proof (extent_nonneg q); pose proof cross_norm; pose proof (norm_nonneg (cross q v)).
  pose proof (Rmult_le_compat_l r _ _ (Rlt_le _ _ r_positive) (norm_le_extent v : _ <= V)) as Hrv.
  assert (0 <= r * norm v) by (apply Rmult_le_pos; lra).
  assert (HVE : V * E = r * V + extent q * V) by (unfold E; ring); set (W := V * E) in *.
  assert (0 <= r * V) by (apply Rmult_le_pos; lra); assert (0 <= extent q * V) by (apply Rmult_le_pos; lra).
  assert (u * W <= / 1000000 * W) by (apply Rmult_le_compat_r; lra).
  assert (HuW : u * W = u * (r * V) + u * (extent q * V)) by (rewrite HVE; ring).
  assert (0 <= u * (r * V)) by (apply Rmult_le_pos; lra); assert (0 <= u * (extent q * V)) by (apply Rmult_le_pos; lra).
  assert (Hf1 : format of_surface) by apply format_rnd; assert (Hf2 : format of_line) by apply format_rnd.
  pose proof (rnd_plus of_surface (- of_line) Hf1 (generic_format_opp _ _ _ Hf2)) as HF.
  pose proof (rnd_plus of_surface of_line Hf1 Hf2) as HH; fold H_fl in HH; fold (of_surface - of_line) in HF;
    fold F_fl in HF.
  assert (Hsize : forall x, - (2 * W) <= x <= 2 * W -> u * Rabs x <= 2 * u * W).
  { intros x Hx; replace (2 * u * W) with (u * (2 * W)) by ring; apply Rmult_le_compat_l; [lra | now apply Rabs_le]. }
  apply Rabs_le_inv in Hl, Hs.
  pose proof (Hsize (of_surface - of_line) ltac:(split; lra)); pose proof (Hsize (of_surface + of_line) ltac:(split; lra)).
  apply Rabs_le_inv in HF, HH; unfold F, H; split; apply Rabs_le; lra.
Qed.

(** Lagrange's identity. *)
Lemma D_product : D = F * H.
Proof.
  unfold D, F, H, A, B, C; replace ((r * norm v - norm (cross q v)) * (r * norm v + norm (cross q v)))
    with (r * r * (norm v * norm v) - norm (cross q v) * norm (cross q v)) by ring.
  rewrite !norm_square; unfold dot, cross; simpl; ring.
Qed.

(** ** The recorded term *)

Local Opaque round.
Theorem recorded : Formas.esfera p v V_fl centro r =
  Formas.Quadratic A_fl B_fl C_fl F_fl H_fl A_error B_error C_error 0 0 0 0 0 0 0.
Proof. match goal with |- _ = ?b => exact_no_check (eq_refl b) end. Qed.
Local Transparent round.

Lemma ordinary_size x : ordinary x -> Rabs x <= bpow radix2 100.
Proof. intros [_ [->|[_ H0]]]; [rewrite Rabs_R0; apply bpow_ge_0 | assumption]. Qed.

Lemma V_size : V <= bpow radix2 102.
Proof.
  destruct v_ordinary as (X & Y & Z); apply ordinary_size in X, Y, Z; unfold V, extent.
  replace (bpow radix2 102) with (4 * bpow radix2 100) by (replace 4 with (bpow radix2 2) by reflexivity;
    now rewrite <- bpow_plus); pose proof (bpow_gt_0 radix2 100); lra.
Qed.

Lemma E_size : E <= bpow radix2 103.
Proof.
  destruct p_ordinary as (X & Y & Z), centro_ordinary as (X' & Y' & Z'); apply ordinary_size in X, Y, Z, X', Y', Z'.
  pose proof (ordinary_size r r_ordinary) as Hr; rewrite Rabs_pos_eq in Hr by lra.
  assert (Hd : forall a b, Rabs (a - b) <= Rabs a + Rabs b).
  { intros; unfold Rminus; apply Rle_trans with (1 := Rabs_triang _ _); rewrite Rabs_Ropp; lra. }
  unfold E, q, extent, minus; simpl.
  pose proof (Hd (cx p) (cx centro)); pose proof (Hd (cy p) (cy centro)); pose proof (Hd (cz p) (cz centro)).
  replace (bpow radix2 103) with (8 * bpow radix2 100) by (replace 8 with (bpow radix2 3) by reflexivity;
    now rewrite <- bpow_plus); pose proof (bpow_gt_0 radix2 100); lra.
Qed.

Lemma V_range : bpow radix2 (-100) <= V <= bpow radix2 103.
Proof.
  split; [|apply Rle_trans with (1 := V_size), bpow_le; lia].
  destruct v_ordinary as ((_ & X) & (_ & Y) & (_ & Z)); unfold V, extent.
  pose proof (Rabs_pos (cx v)); pose proof (Rabs_pos (cy v)); pose proof (Rabs_pos (cz v)).
  destruct X as [X|X], Y as [Y|Y], Z as [Z|Z]; try lra.
  exfalso; unfold norm, dot in v_not_zero; rewrite X, Y, Z in v_not_zero.
  replace (0 * 0 + 0 * 0 + 0 * 0) with 0 in v_not_zero by ring; rewrite sqrt_0 in v_not_zero; lra.
Qed.

Lemma E_range : bpow radix2 (-100) <= E <= bpow radix2 103.
Proof. split; [pose proof r_least; pose proof E_positive; lra | exact E_size]. Qed.

Lemma products_size : V * V <= bpow radix2 204 /\ V * E <= bpow radix2 205 /\ E * E <= bpow radix2 206.
Proof.
  pose proof V_size; pose proof E_size; pose proof V_positive; pose proof E_positive.
  change 204%Z with (102 + 102)%Z; change 205%Z with (102 + 103)%Z; change 206%Z with (103 + 103)%Z; rewrite !bpow_plus.
  split; [|split]; apply Rmult_le_compat; lra.
Qed.

Lemma grid_least m k : grid (-351) m -> 0 < k -> 63 / 64 * k <= m -> bpow radix2 (-360) <= m.
Proof.
  intros G Hk Hm; pose proof (grid_at_least _ _ G ltac:(lra)) as Hl; rewrite Rabs_pos_eq in Hl by lra.
  apply Rle_trans with (2 := Hl), bpow_le; lia.
Qed.

Lemma A_error_computed : A_error <= bpow radix2 450.
Proof.
  pose proof V_positive as HV; pose proof u_bounds as Hu; pose proof (computed_more 2 4 _ _ _ _ ltac:(lia) V_computed) as HVc.
  destruct (error_bound A_error (64 * u * V * V) V V_fl V V_fl) as (_ & Hc); auto; try lra.
  pose proof (computed_size 10 _ _ _ _ ltac:(lia) Hc) as Hs; apply Rle_trans with (1 := Rle_abs _), Rle_trans with (1 := Hs).
  destruct products_size as (SA & _); assert (HVV : 0 <= V * V) by (apply Rmult_le_pos; lra).
  assert (u * (V * V) <= / 1000000000000 * (V * V)) by (apply Rmult_le_compat_r; lra).
  apply Rle_trans with (bpow radix2 204); [lra | apply bpow_le; lia].
Qed.

Theorem sphere_sound : sound (Formas.esfera p v V_fl centro r) A B C F H.
Proof.
  rewrite recorded; pose proof V_positive as HV; pose proof E_positive as HE; pose proof u_bounds as Hu.
  pose proof (computed_more 2 4 _ _ _ _ ltac:(lia) V_computed) as HVc; pose proof E_computed as HEc.
  pose proof A_error_computed as Aec.
  destruct (error_bound A_error (64 * u * V * V) V V_fl V V_fl) as (HA & _ & FA & GA); auto; try lra.
  destruct (error_bound B_error (64 * u * V * E) V V_fl E E_fl) as (HB & _ & FB & GB); auto; try lra.
  destruct (error_bound C_error (64 * u * E * E) E E_fl E E_fl) as (HC & _ & FC & GC); auto; try lra.
  assert (P : forall x y, 0 < x -> 0 < y -> 0 < 64 * u * x * y) by (intros; repeat apply Rmult_lt_0_compat; lra).
  destruct F_H_bound as [HF HH], B_bound as [HBb _], products_size as (SA & SB & SC).
  pose proof (dot_computed 0 0 (-152) (-152) v v v v ltac:(lia) v_close v_close) as Ac.
  pose proof (dot_computed 1 0 (-152) (-152) q_fl v q v ltac:(lia) q_close v_close) as Bc.
  pose proof cross_norm as Hn; pose proof (norm_nonneg (cross q v)) as Hn0; pose proof (norm_nonneg v) as Hv0.
  pose proof (norm_le_extent v : _ <= V) as Hv; pose proof (extent_nonneg q) as Hq0.
  pose proof (Rmult_le_compat_l r _ _ (Rlt_le _ _ r_positive) Hv) as Hrv.
  pose proof (Rmult_le_pos r (norm v) ltac:(lra) Hv0) as Hrv0.
  assert (HVE : V * E = r * V + extent q * V) by (unfold E; ring).
  assert (HW : 0 < u * (V * E) <= / 1000000 * (V * E)).
  { split; [|apply Rmult_le_compat_r; [|lra]]; [apply Rmult_lt_0_compat; [lra|]|apply Rlt_le];
      apply Rmult_lt_0_compat; lra. }
  assert (Hline : 0 <= of_line) by (apply rnd_nonneg, sqrt_pos).
  constructor; cbn [Formas.A Formas.B Formas.C Formas.F Formas.H Formas.A_error Formas.B_error Formas.C_error].
  - exact A_bound.
  - lra.
  - exact C_bound.
  - lra.
  - lra.
  - exact D_product.
  - unfold F, H; apply Rabs_le; lra.
  - apply rnd_le; lra.
  - repeat split; assumption || apply format_rnd.
  - apply (grid_coarser _ (-152 + -152)); [lia | apply Bc].
  - assert (HE0 : 0 < E) by lra.
    exact (conj (grid_least _ _ GA (P V V HV HV) HA) (conj (grid_least _ _ GB (P V E HV HE0) HB)
      (grid_least _ _ GC (P E E HE0 HE0) HC))).
  - split; [|split].
    + apply Rle_trans with (1 := computed_size 3 _ _ _ _ ltac:(lia) Ac).
      assert (size_of_dot v v <= V * V) by apply size_of_dot_le; apply Rle_trans with (2 * bpow radix2 204); [lra|].
      rewrite <- (bpow_plus radix2 1); apply bpow_le; lia.
    + apply Rle_trans with (1 := computed_size 4 _ _ _ _ ltac:(lia) Bc).
      assert (size_of_dot q v <= extent q * V) by apply size_of_dot_le; assert (0 <= r * V) by (apply Rmult_le_pos; lra).
      apply Rle_trans with (2 * bpow radix2 205); [lra|]; rewrite <- (bpow_plus radix2 1); apply bpow_le; lia.
    + apply Rabs_le_inv in HH; unfold H in HH.
      apply Rle_trans with (2 * bpow radix2 205); [lra|]; rewrite <- (bpow_plus radix2 1); apply bpow_le; lia.
  - exact Aec.
Qed.

(** The decision in lanes on a sphere: a hit is within its error of the first point, and a miss is one. *)
Theorem sphere_in_lanes : let d := Formas.first_in_lanes (Formas.esfera p v V_fl centro r) in
  (Formas.hit d = true -> exists t, first_of A B C (fun t => 0 < t) t /\ is_near (Formas.root d) t) /\
  (Formas.hit d = false -> Formas.undecided d = false -> forall t, is_root A B C t -> ~ 0 < t).
Proof. rewrite free_is_recorded; exact (the_decision_is_right _ _ _ _ _ _ sphere_sound _ _ (place_right _)). Qed.

End Sphere.

(** How far apart two points are, as it is computed. *)
Lemma extent_of_difference x y : ordinary_vec x -> ordinary_vec y ->
  computed 3 (-152) (extent_fl (minus_fl x y)) (extent (minus x y)) (extent (minus x y)) /\ extent (minus x y) <= bpow
    radix2 103.
Proof.
  intros Hx Hy; split; [apply (extent_computed 1); [lia | now apply q_close]|].
  destruct Hx as (X1 & X2 & X3), Hy as (Y1 & Y2 & Y3); apply ordinary_size in X1, X2, X3, Y1, Y2, Y3.
  assert (Hd : forall s t, Rabs (s - t) <= Rabs s + Rabs t).
  { intros; unfold Rminus; apply Rle_trans with (1 := Rabs_triang _ _); rewrite Rabs_Ropp; lra. }
  unfold extent, minus; cbn; pose proof (Hd (cx x) (cx y)); pose proof (Hd (cy x) (cy y)); pose proof (Hd (cz x) (cz y)).
  change 103%Z with (3 + 100)%Z; rewrite bpow_plus; replace (bpow radix2 3) with 8 by reflexivity;
    pose proof (bpow_gt_0 radix2 100); lra.
Qed.
