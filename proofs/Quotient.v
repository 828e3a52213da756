(** * Quotient: the bound that the tracer computes for a quotient of two computed numbers

    Formas.quotient x x_error y y_error is what src/trace/closed_form-inl.hpp computes of x/y, with its bound. Nothing is
    asked of the quotient itself: where it, or a product of it, underflows, the bound is larger than what is lost, as x's
    error is not below 2^-900, nor below as much of y. *)
From Coq Require Import Reals ZArith Lra Lia Psatz.
From Flocq Require Import Core.
From Durero Require Import Rounding.
From Durero Require Formas.
Local Open Scope R_scope.
Local Opaque bpow.

(** What a rounded number is at least, if it does not underflow, and if it may. *)
Lemma rnd_low x : 0 <= x -> normal x -> (1 - / 1000000000000) * x <= rnd x.
Proof.
  intros Hx N; pose proof (rnd_rel x N) as Hr; rewrite (Rabs_pos_eq x Hx) in Hr; apply Rabs_le_inv in Hr.
  pose proof u_bounds; assert (u * x <= / 1000000000000 * x) by (apply Rmult_le_compat_r; lra); lra.
Qed.

Lemma rnd_low_any x : 0 <= x -> (1 - / 1000000000000) * x - bpow radix2 (-1074) <= rnd x.
Proof.
  intros Hx; pose proof (rnd_any x) as Hr; rewrite (Rabs_pos_eq x Hx) in Hr; apply Rabs_le_inv in Hr.
  pose proof u_bounds; assert (u * x <= / 1000000000000 * x) by (apply Rmult_le_compat_r; lra); lra.
Qed.

Lemma rnd_low_sum x y : format x -> format y -> 0 <= x + y -> (1 - / 1000000000000) * (x + y) <= rnd (x + y).
Proof.
  intros Fx Fy H; pose proof (rnd_plus x y Fx Fy) as Hr; rewrite (Rabs_pos_eq _ H) in Hr; apply Rabs_le_inv in Hr.
  pose proof u_bounds; assert (u * (x + y) <= / 1000000000000 * (x + y)) by (apply Rmult_le_compat_r; lra); lra.
Qed.

(** The smallest binary64 is far less than any error. *)
Lemma least_below e x : (-1000 <= e)%Z -> bpow radix2 e <= x -> bpow radix2 (-1074) <= / 1000000000000 * x.
Proof.
  intros He Hx; assert (H74 : bpow radix2 (-74) <= / 1000000000000) by
    (replace (bpow radix2 (-74)) with (/ 18889465931478580854784) by reflexivity; lra).
  apply Rle_trans with (bpow radix2 (-74) * bpow radix2 e).
  - rewrite <- bpow_plus; apply bpow_le; lia.
  - apply Rmult_le_compat; auto using bpow_ge_0.
Qed.

(** What is lost in computing the error of x may be a little part of it. *)
Theorem quotient_bound_any_with_slack x x_fl x_error y y_fl y_error :
  format x_error -> format y_fl -> format y_error -> bpow radix2 (-900) <= x_error -> bpow radix2 (-900) * Rabs y_fl <= x_error ->
  Rabs (x_fl - x) <= (1 + / 1000000000) * x_error -> Rabs (y_fl - y) <= y_error -> 2 * y_error < Rabs y_fl ->
  let t := Formas.quotient x_fl x_error y_fl y_error in
  Rabs (Formas.value t - x / y) <= Formas.error t /\ bpow radix2 (-900) <= Formas.error t /\ format (Formas.value t) /\
  format (Formas.error t).
Proof.
  intros Fx Fy Fye Hleast Hratio Hx Hy Hbig; unfold Formas.quotient; set (widen := 4503600077730459 * _).
  cbn [Formas.value Formas.error]; set (t := rnd (x_fl / y_fl)).
  set (top := rnd (x_error + rnd (Rabs t * y_error))); set (bottom := rnd (Rabs y_fl - y_error)).
  pose proof u_bounds as Hu; pose proof (bpow_gt_0 radix2 (-900)) as H900; pose proof (bpow_gt_0 radix2 (-1074)) as Hz.
  set (z := bpow radix2 (-1074)) in *; set (e := / 1000000000000) in *.
  assert (He : 0 < e < / 1000000) by (unfold e; lra).
  assert (Hwiden : 1 + / 16777216 <= widen).
  { unfold widen; replace (bpow radix2 (-52)) with (/ 4503599627370496) by reflexivity; lra. }
  assert (Hy0 : 0 <= y_error) by (apply Rle_trans with (2 := Hy), Rabs_pos).
  set (T := x_fl / y_fl) in *; set (g := Rabs y_fl - y_error) in *; pose proof (Rabs_pos t); pose proof (Rabs_pos T).
  assert (Hy_fl : y_fl <> 0) by (intros Z0; rewrite Z0, Rabs_R0 in Hbig; lra).
  assert (Hgy : g <= Rabs y).
  { unfold g; pose proof (Rabs_triang_inv y_fl (y_fl - y)) as Ht; replace (y_fl - (y_fl - y)) with y in Ht by ring; lra. }
  assert (Hg : 0 < g) by (unfold g; lra); assert (Hyg : y_error <= g) by (unfold g; lra).
  assert (Hy1 : y <> 0) by (intros Z0; rewrite Z0, Rabs_R0 in Hgy; lra).
  (* The rounded quotient. *)
  pose proof (rnd_any T) as Ht; fold t z in Ht.
  assert (HuT : u * Rabs T <= e * Rabs T) by (apply Rmult_le_compat_r; [lra | exact (proj2 Hu)]).
  assert (HT : Rabs T <= (1 + 2 * e) * Rabs t + 2 * z).
  { pose proof (Rabs_triang t (- (t - T))) as Htr; rewrite Rabs_Ropp in Htr; replace (t + - (t - T)) with T in Htr by ring.
    assert (0 <= e * (1 - 2 * e) * Rabs t) by (repeat apply Rmult_le_pos; lra).
    assert (0 <= (1 - 2 * e) * z) by (apply Rmult_le_pos; lra).
    apply Rmult_le_reg_l with (1 - e); lra. }
  (* The exact error of the quotient, and that of the computed one. *)
  set (W := (x_error + Rabs t * y_error) / g).
  assert (HWg : W * g = x_error + Rabs t * y_error) by (unfold W; field; lra).
  pose proof (Rmult_le_pos (Rabs t) y_error ltac:(lra) Hy0) as Hty.
  assert (HW : bpow radix2 (-900) <= W).
  { apply Rmult_le_reg_r with g; [assumption|]; rewrite HWg; apply Rle_trans with (bpow radix2 (-900) * Rabs y_fl); [|lra].
    apply Rmult_le_compat_l; [apply bpow_ge_0 | unfold g; lra]. }
  pose proof (least_below (-900) W ltac:(lia) HW) as HzW; fold z e in HzW.
  assert (HW0 : 0 < W) by (pose proof (bpow_gt_0 radix2 (-900)); lra).
  assert (Hexact : Rabs (T - x / y) <= (1 + 2 * e + / 1000000000) * W + 2 * z).
  { apply Rmult_le_reg_r with g; [assumption|].
    apply Rle_trans with (Rabs (T - x / y) * Rabs y); [apply Rmult_le_compat_l; [apply Rabs_pos | assumption]|].
    rewrite <- Rabs_mult; replace ((T - x / y) * y) with ((x_fl - x) + T * (y - y_fl)) by (unfold T; field; auto).
    apply Rle_trans with (1 := Rabs_triang _ _); rewrite Rabs_mult, (Rabs_minus_sym y y_fl).
    assert (Rabs T * Rabs (y_fl - y) <= ((1 + 2 * e) * Rabs t + 2 * z) * y_error)
      by (apply Rmult_le_compat; auto using Rabs_pos).
    assert (z * y_error <= z * g) by (apply Rmult_le_compat_l; lra).
    replace (((1 + 2 * e + / 1000000000) * W + 2 * z) * g)
      with ((1 + 2 * e + / 1000000000) * (W * g) + 2 * (z * g)) by ring; rewrite HWg.
    assert (0 <= e * x_error) by (apply Rmult_le_pos; lra); lra. }
  (* The computed bound is no less. *)
  pose proof (rnd_low_any _ Hty) as E1; fold e z in E1.
  pose proof (rnd_nonneg _ Hty) as E0.
  pose proof (rnd_low_sum x_error _ Fx (format_rnd (Rabs t * y_error)) ltac:(lra)) as E2; fold e top in E2.
  pose proof (least_below (-900) x_error ltac:(lia) Hleast) as Hzx; fold z e in Hzx.
  assert (Htop : (1 - 3 * e) * (x_error + Rabs t * y_error) <= top).
  { assert (0 <= e * e) by nra; assert (0 <= e * (Rabs t * y_error)) by (apply Rmult_le_pos; lra).
    assert (0 <= e * x_error) by (apply Rmult_le_pos; lra).
    assert ((1 - e) * ((1 - e) * (Rabs t * y_error) - z + x_error) <= top) by
      (apply Rle_trans with (2 := E2); apply Rmult_le_compat_l; lra).
    assert (e * (e * x_error) <= 1 * (e * x_error)) by (apply Rmult_le_compat_r; lra).
    assert (0 <= e * (e * (Rabs t * y_error))) by (apply Rmult_le_pos; lra).
    assert (0 <= e * z) by (apply Rmult_le_pos; lra).
    lra. }
  pose proof (rnd_plus (Rabs y_fl) (- y_error) (generic_format_abs _ _ _ Fy) (generic_format_opp _ _ _ Fye)) as E3.
  fold (Rabs y_fl - y_error) in E3; fold g in E3; fold bottom in E3; rewrite (Rabs_pos_eq g) in E3 by lra.
  apply Rabs_le_inv in E3.
  assert (Hug : u * g <= e * g) by (apply Rmult_le_compat_r; [lra | exact (proj2 Hu)]).
  assert (0 < (1 - e) * g) by (apply Rmult_lt_0_compat; lra).
  assert (Hbottom : 0 < bottom <= (1 + e) * g) by lra.
  assert (HeW : 0 <= e * W <= / 1000000 * W) by (split; [apply Rmult_le_pos | apply Rmult_le_compat_r]; lra).
  assert (Hee : 0 <= e * (e * W) <= e * W) by (split; [apply Rmult_le_pos | rewrite <- (Rmult_1_l (e * W)) at 2;
    apply Rmult_le_compat_r]; lra).
  assert (0 <= e * e) by (apply Rmult_le_pos; lra).
  assert (Hdiv : (1 - 5 * e) * W <= top / bottom).
  { apply Rmult_le_reg_r with bottom; [lra|]; replace (top / bottom * bottom) with top by (field; lra).
    apply Rle_trans with (2 := Htop); apply Rle_trans with ((1 - 5 * e) * W * ((1 + e) * g)).
    - apply Rmult_le_compat_l; lra.
    - replace ((1 - 5 * e) * W * ((1 + e) * g)) with ((1 - 5 * e) * (1 + e) * (W * g)) by ring; rewrite HWg.
      apply Rmult_le_compat_r; lra. }
  assert (Hnormal : forall a, / 2 * W <= a -> normal a).
  { intros a Ha; apply (at_least_normal (-901)); [lia|]; rewrite Rabs_pos_eq by lra.
    apply Rle_trans with (2 := Ha); change (-901)%Z with (-1 + -900)%Z; rewrite bpow_plus.
    replace (bpow radix2 (-1)) with (/ 2) by reflexivity; lra. }
  pose proof (rnd_low (top / bottom) ltac:(lra) (Hnormal (top / bottom) ltac:(lra))) as E4; fold e in E4.
  assert ((1 - e) * ((1 - 5 * e) * W) <= (1 - e) * (top / bottom)) by (apply Rmult_le_compat_l; lra).
  set (w := rnd (top / bottom)) in *; assert (Hw : (1 - 6 * e) * W <= w) by lra.
  assert (Hwide : (1 + / 16777216) * ((1 - 6 * e) * W) <= w * widen).
  { rewrite (Rmult_comm w); apply Rmult_le_compat; lra. }
  set (P := w * widen) in *; pose proof (rnd_low P ltac:(lra) (Hnormal P ltac:(lra))) as E5; fold e in E5.
  assert (H51 : bpow radix2 (-51) = 4 * u) by (replace 4 with (bpow radix2 2) by reflexivity; now rewrite <- bpow_plus).
  assert (Hut : 0 <= u * Rabs t) by (apply Rmult_le_pos; lra).
  pose proof (rnd_low_any (bpow radix2 (-51) * Rabs t) ltac:(rewrite H51; lra)) as E6; rewrite H51 in E6 at 1; fold e z in E6.
  pose proof (rnd_nonneg (bpow radix2 (-51) * Rabs t) ltac:(rewrite H51; lra)) as E60.
  assert (Hwpos : 0 <= rnd (P)) by (apply rnd_nonneg; lra).
  pose proof (rnd_low_sum (rnd (P)) (rnd (bpow radix2 (-51) * Rabs t)) (format_rnd _) (format_rnd _) ltac:(lra)) as E7;
    fold e in E7.
  assert (Hbound : (1 + / 33554432) * W + 3 * (u * Rabs t) <=
    rnd (rnd (P) + rnd (bpow radix2 (-51) * Rabs t))).
  { apply Rle_trans with (2 := E7).
    assert (0 <= e * (u * Rabs t)) by (apply Rmult_le_pos; lra).
    assert (Hww : (1 + / 20000000) * W <= rnd (P)) by (unfold e in *; lra).
    assert (3.5 * (u * Rabs t) - z <= rnd (bpow radix2 (-51) * Rabs t)) by (unfold e in *; lra).
    unfold e in *; lra. }
  split; [|split; [|split; apply format_rnd]].
  - apply Rle_trans with (2 := Hbound); replace (t - x / y) with ((t - T) + (T - x / y)) by ring.
    apply Rle_trans with (1 := Rabs_triang _ _).
    assert (u * Rabs T <= u * ((1 + 2 * e) * Rabs t + 2 * z)) by (apply Rmult_le_compat_l; lra).
    assert (u * z <= 1 * z) by (apply Rmult_le_compat_r; lra).
    assert (e * (u * Rabs t) <= 1 * (u * Rabs t)) by (apply Rmult_le_compat_r; lra).
    unfold e in *; lra.
  - apply Rle_trans with (1 := HW), Rle_trans with (2 := Hbound); lra.
Qed.

(** Nothing is lost there. *)
Corollary quotient_bound_any x x_fl x_error y y_fl y_error :
  format x_error -> format y_fl -> format y_error -> bpow radix2 (-900) <= x_error -> bpow radix2 (-900) * Rabs y_fl <= x_error ->
  Rabs (x_fl - x) <= x_error -> Rabs (y_fl - y) <= y_error -> 2 * y_error < Rabs y_fl ->
  let t := Formas.quotient x_fl x_error y_fl y_error in
  Rabs (Formas.value t - x / y) <= Formas.error t /\ bpow radix2 (-900) <= Formas.error t /\ format (Formas.value t) /\
  format (Formas.error t).
Proof.
  intros Fx Fy Fye Hleast Hratio Hx; apply quotient_bound_any_with_slack; auto.
  pose proof (bpow_gt_0 radix2 (-900)); lra.
Qed.

(** As the curved shapes need it. *)
Corollary quotient_bound_with_slack x x_fl x_error y y_fl y_error :
  format x_error -> format y_fl -> format y_error -> bpow radix2 (-360) <= x_error ->
  Rabs (x_fl - x) <= (1 + / 1000000000) * x_error -> Rabs (y_fl - y) <= y_error -> 2 * y_error < Rabs y_fl <= bpow radix2 450 ->
  let t := Formas.quotient x_fl x_error y_fl y_error in
  Rabs (Formas.value t - x / y) <= Formas.error t /\ bpow radix2 (-900) <= Formas.error t /\ format (Formas.value t) /\
  format (Formas.error t).
Proof.
  intros Fx Fy Fye Hleast Hx Hy [Hbig Hlarge]; apply quotient_bound_any_with_slack; auto.
  - apply Rle_trans with (2 := Hleast), bpow_le; lia.
  - apply Rle_trans with (bpow radix2 (-900) * bpow radix2 450).
    + apply Rmult_le_compat_l; [apply bpow_ge_0 | assumption].
    + rewrite <- bpow_plus; apply Rle_trans with (2 := Hleast), bpow_le; lia.
Qed.

Corollary quotient_bound x x_fl x_error y y_fl y_error :
  format x_error -> format y_fl -> format y_error -> bpow radix2 (-360) <= x_error ->
  Rabs (x_fl - x) <= x_error -> Rabs (y_fl - y) <= y_error -> 2 * y_error < Rabs y_fl <= bpow radix2 450 ->
  let t := Formas.quotient x_fl x_error y_fl y_error in
  Rabs (Formas.value t - x / y) <= Formas.error t /\ bpow radix2 (-900) <= Formas.error t /\ format (Formas.value t) /\
  format (Formas.error t).
Proof.
  intros Fx Fy Fye Hleast Hx; apply quotient_bound_with_slack; auto.
  pose proof (bpow_gt_0 radix2 (-360)); lra.
Qed.
