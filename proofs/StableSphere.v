(** * StableSphere: the second step on a sphere

    Formas.Pairs.esfera is what is computed in double-double of a ray and a sphere: it is sound in the sense of Stable.v,
    so that the decision over it is right. *)
From Coq Require Import Reals ZArith List Lra Lia Psatz.
From Flocq Require Import Core.
From Durero Require Import Toolkit Especificacion Puntos Trazador.
From Durero Require Tipos Certified Formas Chain.
From Durero Require Import Rounding Quotient Vectors Decision Flotante Verdict Steps Triage Twofold Sums Products Ratios Words
  Small Doubled Stable StableVectors.
From Durero Require Escena.
Import Formas.Pairs.
Local Open Scope R_scope.
Local Opaque bpow.

(** The computed bounds, in units of uu: 2^-96 is 64 of them. *)
Lemma error_bound2 x x_fl y y_fl : computed 4 (-152) x_fl x x -> computed 4 (-152) y_fl y y ->
  bpow radix2 (-100) <= x <= bpow radix2 103 -> bpow radix2 (-100) <= y <= bpow radix2 103 ->
  let m := rnd (rnd (bpow radix2 (-96) * x_fl) * y_fl) in
  63 * (uu * (x * y)) <= m /\ bpow radix2 (-360) <= m <= bpow radix2 450.
Proof.
  intros Cx Cy Hx Hy m; pose proof uu_bounds as Hu; pose proof (bpow_gt_0 radix2 (-100)) as H100; set (k := 64 * uu * x * y).
  assert (E96 : bpow radix2 (-96) = 64 * uu) by (replace 64 with (bpow radix2 6) by reflexivity; now rewrite <- bpow_plus).
  assert (Cu : computed 0 (-96) (bpow radix2 (-96)) (64 * uu) (64 * uu)).
  { rewrite <- E96; rewrite <- (Rabs_pos_eq (bpow radix2 (-96))) at 3 by apply bpow_ge_0; apply computed_exact; [apply format_bpow; lia|].
    exists 1%Z; ring. }
  assert (Hc : computed 10 (-400) m k k).
  { apply (computed_mult 5 4 (-248) (-152)); [lia | | assumption].
    apply (computed_mult 0 4 (-96) (-152)); [lia | exact Cu | assumption]. }
  pose proof (computed_error 10 _ _ _ _ ltac:(lia) Hc) as He; simpl INR in He; apply Rabs_le_inv in He; pose proof u_bounds.
  assert (Hlow : bpow radix2 (-200) <= x * y).
  { change (-200)%Z with (-100 + -100)%Z; rewrite bpow_plus; apply Rmult_le_compat; lra. }
  assert (Hhigh : x * y <= bpow radix2 206).
  { change 206%Z with (103 + 103)%Z; rewrite bpow_plus; apply Rmult_le_compat; lra. }
  pose proof (bpow_gt_0 radix2 (-200)); assert (Hk : k = 64 * (uu * (x * y))) by (unfold k; ring).
  assert (Hk0 : bpow radix2 (-302) <= uu * (x * y)).
  { change (-302)%Z with (-102 + -200)%Z; rewrite bpow_plus; apply Rmult_le_compat_l; lra. }
  pose proof (bpow_gt_0 radix2 (-302)); assert (Huk : u * k <= / 1000000000000 * k) by (apply Rmult_le_compat_r; lra).
  split; [lra | split].
  - apply Rle_trans with (bpow radix2 (-302)); [apply bpow_le; lia | lra].
  - apply Rle_trans with (bpow radix2 206); [|apply bpow_le; lia].
    assert (uu * (x * y) <= e30 * (x * y)) by (apply Rmult_le_compat_r; lra); lra.
Qed.

Section Sphere.
Variables p v centro : vec.
Variable r : R.
Hypothesis ray_fits : fit_ray p v.
Hypothesis centro_ordinary : ordinary_vec centro.
Hypothesis r_ordinary : ordinary r.
Hypothesis r_positive : 0 < r.

Let qv := minus p centro.
Let A := dot v v.
Let B := dot qv v.
Let C := dot qv qv - r * r.
Let F := r * norm v - norm (cross qv v).
Let H := r * norm v + norm (cross qv v).
Let V := extent v.
Let E := extent qv + r.
Let Q := extent qv.

Let q2 := minus2 p centro.
Let v2 := exactly2 v.
Let r2 := exactly r.
Let S2 := product r2 (norm2 v2).
Let L2 := norm2 (cross2 q2 v2).
Let V_fl := extent_fl v.
Let E_fl := rnd (rnd (rnd (Rabs (hi (dx q2)) + Rabs (hi (dy q2))) + Rabs (hi (dz q2))) + r).
Let error x y := rnd (rnd (bpow radix2 (-96) * x) * y).

Local Opaque sum difference product ratio root_of opposite exactly two_sum.
Lemma recorded : esfera p v V_fl centro r =
  Formas.Quadratic (dot2 v2 v2) (dot2 q2 v2) (difference (dot2 q2 q2) (product r2 r2)) (difference S2 L2) (sum S2 L2)
    (error V_fl V_fl) (error V_fl E_fl) (error E_fl E_fl) (exactly 0) (exactly 0) 0 0 0 0 0.
Proof. reflexivity. Qed.
Local Transparent sum difference product ratio root_of opposite exactly two_sum.

Let q_close2 : words_close 0 (-152) q2 qv := words_between p centro (p_ordinary ray_fits) centro_ordinary.
Let v_close2 : words_close 0 (-152) v2 v := words_of v (v_ordinary ray_fits).
Let r_word : worded 0 (-152) r2 r r := word_of r r_ordinary r_positive.
Let V_size2 : bpow radix2 (-100) <= V <= bpow radix2 103 := V_range v (v_ordinary ray_fits) (v_not_zero ray_fits).
Let E_size2 : bpow radix2 (-100) <= E <= bpow radix2 103 := E_range p centro r (p_ordinary ray_fits) centro_ordinary
  r_ordinary r_positive.

Lemma V_computed2 : computed 4 (-152) V_fl V V.
Proof. apply (computed_more 2); [lia | exact (V_computed v (v_ordinary ray_fits))]. Qed.

Lemma E_computed2 : computed 4 (-152) E_fl E E.
Proof. exact (E_computed p centro r (p_ordinary ray_fits) centro_ordinary r_ordinary r_positive). Qed.

(** ** The distances of the surface and of the line, times |v| *)

(** What underflows is nothing beside them. *)
Let nothing : (1 + r) * bpow radix2 (-450) <= / 1000 * (uu * (r * V)) /\ bpow radix2 (-957) <= / 1000 * (uu * (r * V)).
Proof.
  apply nothing_beside; [exact (ordinary_size r r_ordinary)|]; change (-200)%Z with (-100 + -100)%Z; rewrite bpow_plus.
  apply Rmult_le_compat; try apply bpow_ge_0; [exact (r_least r r_ordinary r_positive) | apply V_size2].
Qed.

Lemma of_surface_near : double_word S2 /\ Rabs (whole S2 - r * norm v) <= 10 * uu * (r * V).
Proof.
  pose proof uu_bounds as Hu; destruct v_close2 as ((Nx & Wx & _) & (Ny & Wy & _) & (Nz & Wz & _)).
  destruct (norm2_any v2 Wx Wy Wz) as (Wn & Hn & Hn0); assert (Ew : wholes v2 = v).
  { assert (Ex : forall a x m, near2 0 a x m -> whole a = x).
    { intros a x m [Hx _]; simpl in Hx; replace ((1 - 1) * m) with 0 in Hx by ring.
      pose proof (Rabs_pos (whole a - x)); destruct (Req_dec (whole a - x) 0) as [|N]; [lra | pose proof (Rabs_pos_lt _ N); lra]. }
    unfold wholes; rewrite (Ex _ _ _ Nx), (Ex _ _ _ Ny), (Ex _ _ _ Nz); now destruct v. }
  rewrite Ew in Hn; destruct r_word as (_ & Wr & _), (ordinary_grid r r_ordinary) as [Fr _], (exactly_word r Fr) as [_ Er].
  pose proof (r_least r r_ordinary r_positive) as Hr.
  destruct (product_any r2 (norm2 v2) Wr Wn) as [WS HS]; destruct nothing as [N450 N957]; pose proof (bpow_gt_0 radix2 (-450)) as Hy.
  set (y := bpow radix2 (-450)) in *.
  split; [exact WS|]; fold S2 in HS; change (whole r2 = r) in Er; rewrite Er in HS; set (n := whole (norm2 v2)) in *.
  pose proof (norm_nonneg v) as Hv0; pose proof (norm_le_extent v : _ <= V) as Hv; apply Rabs_le_inv in Hn.
  rewrite (Rabs_pos_eq (r * n)) in HS by (apply Rmult_le_pos; lra).
  assert (Hrn : r * (norm v - 8 * uu * norm v - y) <= r * n <= r * (norm v + 8 * uu * norm v + y))
    by (split; apply Rmult_le_compat_l; lra).
  assert (Hrv : 0 <= r * norm v <= r * V) by (split; [apply Rmult_le_pos | apply Rmult_le_compat_l]; lra).
  pose proof (uu_part _ (proj1 Hrv)); pose proof (uu_part (r * V) ltac:(lra)).
  assert (Hu1 : uu * (r * norm v) <= uu * (r * V)) by (apply Rmult_le_compat_l; lra).
  assert (Hu2 : uu * (r * n) <= uu * (3 / 2 * (r * V))) by (apply Rmult_le_compat_l; lra).
  apply Rabs_le_inv in HS; apply Rabs_le; lra.
Qed.

Lemma cross_near : words_on (-304) (cross2 q2 v2) /\
  extent (minus (wholes (cross2 q2 v2)) (cross qv v)) <= 3 * uu * (Q * V).
Proof.
  destruct q_close2 as (Qx & Qy & Qz), v_close2 as (Vx & Vy & Vz); pose proof uu_bounds.
  assert (Hone : forall a b a' b' x y x' y' m n m' n',
    worded 0 (-152) a x m -> worded 0 (-152) b y n -> worded 0 (-152) a' x' m' -> worded 0 (-152) b' y' n' ->
    worded 2 (-304) (difference (product a b) (product a' b')) (x * y - x' * y') (m * n + m' * n')).
  { intros; apply (worded_minus 1 (-304)); [lia | |]; apply (worded_mult 0 0 (-152) (-152)); auto; lia. }
  pose proof (Hone _ _ _ _ _ _ _ _ _ _ _ _ Qy Vz Qz Vy) as X.
  pose proof (Hone _ _ _ _ _ _ _ _ _ _ _ _ Qz Vx Qx Vz) as Y.
  pose proof (Hone _ _ _ _ _ _ _ _ _ _ _ _ Qx Vy Qy Vx) as Z.
  split; [destruct X as (_ & ? & ?), Y as (_ & ? & ?), Z as (_ & ? & ?); unfold words_on; cbn [dx dy dz cross2]; tauto|].
  apply (worded_error 2 _ _ _ _ ltac:(lia)) in X, Y, Z; simpl INR in X, Y, Z.
  unfold extent at 1, minus, wholes, cross2, cross; cbn [cx cy cz dx dy dz].
  apply Rle_trans with (1 := Rplus_le_compat _ _ _ _ (Rplus_le_compat _ _ _ _ X Y) Z).
  unfold Q, V, extent; pose proof (Rabs_pos (cx qv)); pose proof (Rabs_pos (cy qv)); pose proof (Rabs_pos (cz qv)).
  pose proof (Rabs_pos (cx v)); pose proof (Rabs_pos (cy v)); pose proof (Rabs_pos (cz v)).
  set (s := Rabs (cy qv) * Rabs (cz v) + Rabs (cz qv) * Rabs (cy v) + (Rabs (cz qv) * Rabs (cx v) + Rabs (cx qv) * Rabs (cz v))
    + (Rabs (cx qv) * Rabs (cy v) + Rabs (cy qv) * Rabs (cx v))).
  set (whole_s := (Rabs (cx qv) + Rabs (cy qv) + Rabs (cz qv)) * (Rabs (cx v) + Rabs (cy v) + Rabs (cz v))).
  assert (Hs : 0 <= s <= whole_s).
  { assert (P : forall a b, 0 <= a -> 0 <= b -> 0 <= a * b) by (intros; now apply Rmult_le_pos).
    pose proof (P (Rabs (cx qv)) (Rabs (cx v))); pose proof (P (Rabs (cy qv)) (Rabs (cy v))); pose proof (P (Rabs (cz qv)) (Rabs (cz v))).
    pose proof (P (Rabs (cy qv)) (Rabs (cz v))); pose proof (P (Rabs (cz qv)) (Rabs (cy v))); pose proof (P (Rabs (cz qv)) (Rabs (cx v))).
    pose proof (P (Rabs (cx qv)) (Rabs (cz v))); pose proof (P (Rabs (cx qv)) (Rabs (cy v))); pose proof (P (Rabs (cy qv)) (Rabs (cx v))).
    unfold s, whole_s; split; lra. }
  assert (Hus : 0 <= uu * s <= uu * whole_s) by (split; [apply Rmult_le_pos | apply Rmult_le_compat_l]; lra).
  unfold s in *; lra.
Qed.

Lemma of_line_near : double_word L2 /\ Rabs (whole L2 - norm (cross qv v)) <= 12 * uu * (Q * V) + bpow radix2 (-450) /\ 0 <= whole L2.
Proof.
  destruct cross_near as [On He]; pose proof uu_bounds as Hu; pose proof (cross_norm p v centro : _ <= Q * V) as Hn.
  fold qv in Hn; destruct On as ((Wx & _) & (Wy & _) & (Wz & _)), (norm2_any _ Wx Wy Wz) as (WL & Hl & HL0).
  fold L2 in Hl, WL, HL0.
  pose proof (norm_lipschitz (wholes (cross2 q2 v2)) (cross qv v)) as Hd; pose proof (norm_nonneg (wholes (cross2 q2 v2))) as Hn0.
  set (n := norm (wholes (cross2 q2 v2))) in *; pose proof V_size2; pose proof (bpow_gt_0 radix2 (-100)).
  pose proof (Rmult_le_pos Q V (extent_nonneg qv) ltac:(lra)) as HQV.
  assert (Hu1 : 0 <= uu * (Q * V) <= e30 * (Q * V)) by (split; [apply Rmult_le_pos | apply Rmult_le_compat_r]; lra).
  apply Rabs_le_inv in Hd, Hl; assert (Hn1 : n <= (1 + / 1000) * (Q * V)) by lra.
  assert (Hu2 : 0 <= uu * n <= uu * ((1 + / 1000) * (Q * V))) by (split; [apply Rmult_le_pos | apply Rmult_le_compat_l]; lra).
  assert (Hu3 : uu * n <= e30 * n) by (apply Rmult_le_compat_r; lra).
  split; [exact WL | split; [apply Rabs_le; lra | exact HL0]].
Qed.

Lemma F_H_near : let F2 := difference S2 L2 in let H2 := sum S2 L2 in double_word F2 /\ double_word H2 /\
  Rabs (whole F2 - F) <= 20 * (uu * (V * E)) /\ Rabs (whole H2 - H) <= 20 * (uu * (V * E)) /\
  (0 < whole F2 -> whole F2 <= (1 + / 2000) * whole H2) /\ Rabs H <= 2 * (V * E).
Proof.
  destruct of_line_near as (WL & Hl & HL0), of_surface_near as [WS Hs], nothing as [N450 _]; pose proof (bpow_gt_0 radix2 (-450)) as Hy.
  set (y := bpow radix2 (-450)) in *; pose proof uu_bounds as Hu; pose proof (Rmult_le_pos r y ltac:(lra) ltac:(lra)).
  pose proof V_size2; pose proof (bpow_gt_0 radix2 (-100)); pose proof (extent_nonneg qv : 0 <= Q) as HQ.
  pose proof (cross_norm p v centro : _ <= Q * V) as Hn; fold qv in Hn; pose proof (norm_nonneg (cross qv v)) as Hn0.
  pose proof (Rmult_le_compat_l r _ _ (Rlt_le _ _ r_positive) (norm_le_extent v : _ <= V)) as Hrv.
  pose proof (Rmult_le_pos r (norm v) ltac:(lra) (norm_nonneg v)) as Hrv0.
  assert (HVE : V * E = r * V + Q * V) by (unfold E, Q; ring); set (W := V * E) in *.
  pose proof (Rmult_le_pos r V ltac:(lra) ltac:(lra)) as HrV; pose proof (Rmult_le_pos Q V HQ ltac:(lra)) as HQV.
  pose proof (uu_part W ltac:(lra)) as HuW; assert (HuWW : uu * W = uu * (r * V) + uu * (Q * V)) by (rewrite HVE; ring).
  pose proof (uu_part _ HrV); pose proof (uu_part _ HQV).
  destruct (factors_near S2 (r * norm v) L2 (norm (cross qv v)) (16 * (uu * W)) WS WL Hrv0 Hn0 HL0 ltac:(lra))
    as (WF & WH & HF & HH & Hbelow).
  assert (Hsum : uu * (r * norm v + norm (cross qv v) + 16 * (uu * W)) <= uu * (2 * W)) by (apply Rmult_le_compat_l; lra).
  cbv zeta; split; [exact WF | split; [exact WH|]]; split; [unfold F; lra | split; [unfold H; lra|]].
  split; [exact Hbelow | unfold H; rewrite Rabs_pos_eq; lra].
Qed.

Theorem stable_sphere_sound : sound2 (esfera p v V_fl centro r) A B C F H.
Proof.
  rewrite recorded; destruct F_H_near as (WF & WH & HF & HH & Hbelow & HHsize); pose proof uu_bounds as Hu.
  destruct (error_bound2 V V_fl V V_fl V_computed2 V_computed2 V_size2 V_size2) as (MA & LA & UA).
  destruct (error_bound2 V V_fl E E_fl V_computed2 E_computed2 V_size2 E_size2) as (MB & LB & UB).
  destruct (error_bound2 E E_fl E E_fl E_computed2 E_computed2 E_size2 E_size2) as (MC & LC & UC).
  pose proof (dot2_worded 0 0 (-152) (-152) v2 v2 v v ltac:(lia) v_close2 v_close2) as Ac.
  pose proof (dot2_worded 0 0 (-152) (-152) q2 v2 qv v ltac:(lia) q_close2 v_close2) as Bc.
  pose proof (dot2_worded 0 0 (-152) (-152) q2 q2 qv qv ltac:(lia) q_close2 q_close2) as Qc.
  pose proof (worded_mult 0 0 (-152) (-152) _ _ _ _ _ _ ltac:(lia) r_word r_word) as Rc.
  pose proof (worded_minus 3 (-304) _ _ _ _ _ _ ltac:(lia) Qc (worded_more 1 3 (-304) _ _ _ ltac:(lia) Rc)) as Cc.
  pose proof (worded_error 3 _ _ _ _ ltac:(lia) Ac) as EA; pose proof (worded_error 3 _ _ _ _ ltac:(lia) Bc) as EB.
  pose proof (worded_error 4 _ _ _ _ ltac:(lia) Cc) as EC; simpl INR in EA, EB, EC.
  pose proof (size_of_dot_le v v : _ <= V * V) as SA; pose proof (size_of_dot_le qv v : _ <= Q * V) as SB.
  pose proof (size_of_dot_le qv qv : _ <= Q * Q) as SC; pose proof V_size2 as SV; pose proof E_size2 as SE.
  pose proof (bpow_gt_0 radix2 (-100)); pose proof (extent_nonneg qv : 0 <= Q) as HQ.
  assert (HQV : Q * V <= V * E) by (unfold E; fold Q; pose proof (Rmult_le_pos V r); lra).
  assert (HQE : Q * Q + r * r <= E * E).
  { unfold E; fold Q; pose proof (Rmult_le_pos Q r HQ ltac:(lra)); lra. }
  assert (P : forall x y, x <= y -> uu * x <= uu * y) by (intros; apply Rmult_le_compat_l; lra).
  pose proof (P _ _ SA) as PA; pose proof (P (size_of_dot qv v) (V * E) ltac:(lra)) as PB.
  pose proof (P (size_of_dot qv qv + r * r) (E * E) ltac:(lra)) as PC.
  assert (HVE : 0 <= V * E <= bpow radix2 206).
  { split; [apply Rmult_le_pos; lra|]; change 206%Z with (103 + 103)%Z; rewrite bpow_plus; apply Rmult_le_compat; lra. }
  assert (HVV : V * V <= bpow radix2 206).
  { change 206%Z with (103 + 103)%Z; rewrite bpow_plus; apply Rmult_le_compat; lra. }
  assert (H440 : 8 * bpow radix2 206 <= bpow radix2 440).
  { replace 8 with (bpow radix2 3) by reflexivity; rewrite <- bpow_plus; apply bpow_le; lia. }
  assert (HuVE : 0 <= uu * (V * E) <= e30 * (V * E)) by (split; [apply Rmult_le_pos | apply Rmult_le_compat_r]; lra).
  assert (HuVV : 0 <= uu * (V * V)) by (repeat apply Rmult_le_pos; lra).
  assert (HuEE : 0 <= uu * (E * E)) by (repeat apply Rmult_le_pos; lra).
  assert (G304 : forall w, parts_on (-304) w -> sizeable w).
  { intros w [G _]; destruct (Req_dec (hi w) 0) as [Z0|N]; [now left | right].
    apply Rle_trans with (2 := grid_at_least _ _ G N), bpow_le; lia. }
  constructor; cbn [Formas.A Formas.B Formas.C Formas.F Formas.H Formas.A_error Formas.B_error Formas.C_error].
  - split; [apply Ac | split; [apply Bc | split; [apply Cc | now split]]].
  - unfold A, error; lra.
  - unfold B, error; lra.
  - unfold C, error; lra.
  - unfold error; lra.
  - unfold error; lra.
  - exact (D_product p v centro r).
  - unfold F, H; pose proof (norm_nonneg (cross qv v)); pose proof (Rmult_le_pos r (norm v) ltac:(lra) (norm_nonneg v)).
    apply Rabs_le; lra.
  - exact Hbelow.
  - repeat split; apply format_rnd.
  - unfold error; tauto.
  - assert (H450 : bpow radix2 440 <= bpow radix2 450) by (apply bpow_le; lia).
    pose proof (worded_size 3 _ _ _ _ ltac:(lia) Ac); pose proof (worded_size 3 _ _ _ _ ltac:(lia) Bc).
    split; [lra | split; [lra|]]; apply Rle_trans with (1 := Rle_abs _).
    pose proof (leading _ WH) as LH; pose proof (size_near _ _ _ _ HH HHsize); lra.
  - split; apply G304; [apply Bc | apply Cc].
Qed.

(** ** What the text says *)

Notation ray := (ray_of p v).
Notation text := (of_esfera ray (point centro) r).

Theorem stable_sphere_right limit : format limit ->
  right_pair (reach text) limit (first_of_curved (esfera p v V_fl centro r) limit) /\
  right_pair (reach (launched text)) limit (first_of_curved_on (esfera p v V_fl centro r) limit).
Proof.
  intros Fl; assert (Pos : forall t : R, 0 < t -> 0 < t) by auto; split.
  - rewrite single_is_recorded; apply (right_pair_equal (points A B C (fun t => 0 < t))).
    + intros t; unfold points, reach, within; rewrite <- (Certified.root_value p v centro r t : is_root A B C t <-> _).
      cbn [clip of_esfera]; unfold is_root; split; [intros [? ?]; repeat split; auto | tauto].
    + apply (single_right _ _ _ _ _ _ stable_sphere_sound); auto using place_right.
      intros HF Hq only; exact (past_limit_right _ _ _ _ _ _ stable_sphere_sound _ limit Pos HF Hq only).
  - rewrite from_is_recorded; apply (right_pair_equal (points_from A B (fun t => 0 < t))).
    + intros t; unfold points_from, reach, within; replace (A * t * t + 2 * B * t + 0) with (value (launched text) t).
      * cbn [clip of_esfera launched]; split; [intros [? ?]; repeat split; auto | tauto].
      * unfold A, B, qv, ray_of, point, direction, value, launched, of_esfera, Tipos.sq, Tipos.dot, from, dot, minus; cbn; ring.
    + apply (single_from_right _ _ _ _ _ _ stable_sphere_sound); auto using place_right.
Qed.
End Sphere.
