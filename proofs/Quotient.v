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

(** The bound that is computed of a quotient of size s: more than W, the exact one, and most of what is added for the
    roundings of the quotient. *)
Lemma computed_quotient_error s c x_error y_fl y_error : format x_error -> format y_fl -> format y_error -> 0 <= s -> 0 <= c ->
  bpow radix2 (-900) <= x_error -> bpow radix2 (-900) * Rabs y_fl <= x_error -> 0 <= y_error -> 2 * y_error < Rabs y_fl ->
  let W := (x_error + s * y_error) / (Rabs y_fl - y_error) in
  bpow radix2 (-900) <= W /\ (1 + / 33554432) * W + 3 / 4 * (c * s) <=
    rnd (rnd (rnd (rnd (x_error + rnd (s * y_error)) / rnd (Rabs y_fl - y_error)) * (4503600077730459 * bpow radix2 (-52)))
      + rnd (c * s)).
Proof.
  intros Fx Fy Fye Hs Hc Hleast Hratio Hy0 Hbig W; set (widen := 4503600077730459 * _).
  set (top := rnd (x_error + rnd (s * y_error))); set (bottom := rnd (Rabs y_fl - y_error)).
  pose proof u_bounds as Hu; pose proof (bpow_gt_0 radix2 (-900)) as H900; pose proof (bpow_gt_0 radix2 (-1074)) as Hz.
  set (z := bpow radix2 (-1074)) in *; set (e := / 1000000000000) in *.
  assert (He : 0 < e < / 1000000) by (unfold e; lra).
  assert (Hwiden : 1 + / 16777216 <= widen).
  { unfold widen; replace (bpow radix2 (-52)) with (/ 4503599627370496) by reflexivity; lra. }
  set (g := Rabs y_fl - y_error) in *; assert (Hg : 0 < g) by (unfold g; lra).
  assert (HWg : W * g = x_error + s * y_error) by (unfold W; field; lra).
  pose proof (Rmult_le_pos s y_error Hs Hy0) as Hty.
  assert (HW : bpow radix2 (-900) <= W).
  { apply Rmult_le_reg_r with g; [assumption|]; rewrite HWg; apply Rle_trans with (bpow radix2 (-900) * Rabs y_fl); [|lra].
    apply Rmult_le_compat_l; [apply bpow_ge_0 | unfold g; lra]. }
  split; [exact HW|]; pose proof (least_below (-900) W ltac:(lia) HW) as HzW; fold z e in HzW.
  assert (HW0 : 0 < W) by lra.
  pose proof (rnd_low_any _ Hty) as E1; fold e z in E1.
  pose proof (rnd_nonneg _ Hty) as E0.
  pose proof (rnd_low_sum x_error _ Fx (format_rnd (s * y_error)) ltac:(lra)) as E2; fold e top in E2.
  pose proof (least_below (-900) x_error ltac:(lia) Hleast) as Hzx; fold z e in Hzx.
  assert (Htop : (1 - 3 * e) * (x_error + s * y_error) <= top).
  { assert (0 <= e * e) by (apply Rmult_le_pos; lra); assert (0 <= e * (s * y_error)) by (apply Rmult_le_pos; lra).
    assert (0 <= e * x_error) by (apply Rmult_le_pos; lra).
    assert ((1 - e) * ((1 - e) * (s * y_error) - z + x_error) <= top) by
      (apply Rle_trans with (2 := E2); apply Rmult_le_compat_l; lra).
    assert (e * (e * x_error) <= 1 * (e * x_error)) by (apply Rmult_le_compat_r; lra).
    assert (0 <= e * (e * (s * y_error))) by (apply Rmult_le_pos; lra).
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
  pose proof (Rmult_le_pos c s Hc Hs) as Hcs; pose proof (rnd_low_any (c * s) Hcs) as E6; fold e z in E6.
  pose proof (rnd_nonneg (c * s) Hcs) as E60; assert (Hwpos : 0 <= rnd (P)) by (apply rnd_nonneg; lra).
  pose proof (rnd_low_sum (rnd (P)) (rnd (c * s)) (format_rnd _) (format_rnd _) ltac:(lra)) as E7; fold e in E7.
  apply Rle_trans with (2 := E7).
  assert (0 <= e * (c * s)) by (apply Rmult_le_pos; lra).
  assert (Hww : (1 + / 20000000) * W <= rnd (P)) by (unfold e in *; lra).
  assert (7 / 8 * (c * s) - z <= rnd (c * s)) by (unfold e in *; lra).
  unfold e in *; lra.
Qed.

(** A root within its error of t, both binary64, with room to round the ends: the root less the error, and more. *)
Definition is_near (root : Formas.known R) (t : R) : Prop := format (Formas.value root) /\ format (Formas.error root) /\
  Rabs (Formas.value root - t) + u * (Rabs (Formas.value root) + Formas.error root) <= Formas.error root.

Lemma near_within root t : is_near root t -> Rabs (Formas.value root - t) <= Formas.error root.
Proof.
  intros (_ & _ & N); revert N; pose proof u_bounds; pose proof (Rabs_pos (Formas.value root)) as Hr; pose proof (Rabs_pos (Formas.value root - t)).
  set (r := Rabs (Formas.value root)) in *; set (e := Formas.error root); intros N; pose proof (Rmult_le_pos u r ltac:(lra) Hr).
  destruct (Rle_or_lt 0 e) as [He|He]; [pose proof (Rmult_le_pos u e ltac:(lra) He); lra|].
  pose proof (Rmult_lt_compat_r (- e) u 1 ltac:(lra) ltac:(lra)); lra.
Qed.

(** What is lost in computing the error of x may be a little part of it. *)
Theorem quotient_bound_any_with_slack x x_fl x_error y y_fl y_error :
  format x_error -> format y_fl -> format y_error -> bpow radix2 (-900) <= x_error -> bpow radix2 (-900) * Rabs y_fl <= x_error ->
  Rabs (x_fl - x) <= (1 + / 1000000000) * x_error -> Rabs (y_fl - y) <= y_error -> 2 * y_error < Rabs y_fl ->
  let t := Formas.quotient x_fl x_error y_fl y_error in
  is_near t (x / y) /\ bpow radix2 (-900) <= Formas.error t /\ format (Formas.value t) /\
  format (Formas.error t).
Proof.
  intros Fx Fy Fye Hleast Hratio Hx Hy Hbig; unfold Formas.quotient, is_near; cbn [Formas.value Formas.error]; set (t := rnd (x_fl / y_fl)).
  assert (Hy0 : 0 <= y_error) by (apply Rle_trans with (2 := Hy), Rabs_pos).
  destruct (computed_quotient_error (Rabs t) (bpow radix2 (-51)) x_error y_fl y_error Fx Fy Fye (Rabs_pos t) (bpow_ge_0 _ _)
    Hleast Hratio Hy0 Hbig) as [HW Hbound]; set (W := (x_error + Rabs t * y_error) / _) in *.
  pose proof u_bounds as Hu; pose proof (bpow_gt_0 radix2 (-900)) as H900; pose proof (bpow_gt_0 radix2 (-1074)) as Hz.
  set (z := bpow radix2 (-1074)) in *; set (e := / 1000000000000) in *.
  assert (He : 0 < e < / 1000000) by (unfold e; lra).
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
  (* The exact error of the quotient. *)
  assert (HWg : W * g = x_error + Rabs t * y_error) by (unfold W; field; lra).
  pose proof (Rmult_le_pos (Rabs t) y_error ltac:(lra) Hy0) as Hty.
  pose proof (least_below (-900) W ltac:(lia) HW) as HzW; fold z e in HzW; assert (HW0 : 0 < W) by lra.
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
  assert (H51 : bpow radix2 (-51) = 4 * u) by apply multiples_of_u.
  rewrite H51 in Hbound at 1; assert (Hut : 0 <= u * Rabs t) by (apply Rmult_le_pos; lra).
  split; [split; [apply format_rnd | split; [apply format_rnd|]]|split; [|split; apply format_rnd]].
  - set (error := rnd (_ + rnd (bpow radix2 (-51) * Rabs t))) in *.
    enough (Rabs (t - x / y) + u * Rabs t <= (1 - e) * error).
    { assert (0 <= error) by (pose proof (Rabs_pos (t - x / y)); apply Rmult_le_reg_l with (1 - e); lra).
      assert (u * error <= e * error) by (apply Rmult_le_compat_r; [assumption | exact (proj2 Hu)]); lra. }
    apply Rle_trans with ((1 - e) * ((1 + / 33554432) * W + 3 / 4 * (4 * u * Rabs t))); [|apply Rmult_le_compat_l; lra].
    replace (t - x / y) with ((t - T) + (T - x / y)) by ring; pose proof (Rabs_triang (t - T) (T - x / y)).
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
  is_near t (x / y) /\ bpow radix2 (-900) <= Formas.error t /\ format (Formas.value t) /\
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
  is_near t (x / y) /\ bpow radix2 (-900) <= Formas.error t /\ format (Formas.value t) /\
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
  is_near t (x / y) /\ bpow radix2 (-900) <= Formas.error t /\ format (Formas.value t) /\
  format (Formas.error t).
Proof.
  intros Fx Fy Fye Hleast Hx; apply quotient_bound_with_slack; auto.
  pose proof (bpow_gt_0 radix2 (-360)); lra.
Qed.

(** Where the divisor may be 0: the least that a quotient's size can be, as it is computed; what is known of both may lack
    some parts of their errors. *)
Lemma computed_least q_fl q_error A_fl A_error x A t : format q_fl -> format q_error -> format A_fl -> format A_error ->
  bpow radix2 (-360) <= q_error -> 2 * q_error < Rabs q_fl -> bpow radix2 (-360) <= A_error <= bpow radix2 450 ->
  Rabs A_fl <= bpow radix2 450 -> (1 - / 1000000000) * (Rabs q_fl - q_error) <= Rabs x ->
  Rabs A <= (1 + / 1000000000) * (Rabs A_fl + A_error) -> A * t = x ->
  let least := rnd (rnd ((9007198354021067 * bpow radix2 (-53)) * rnd (Rabs q_fl - q_error)) / rnd (Rabs A_fl + A_error)) in
  0 <= least <= Rabs t.
Proof.
  intros Fq Fqe FA FAe He Hq [HAe HAe450] HA450 Hx Ha Ht least; pose proof u_bounds as Hu.
  pose proof (bpow_gt_0 radix2 (-360)) as H360; set (e := / 1000000000000) in *.
  assert (Hw : 1 - / 8388608 <= 9007198354021067 * bpow radix2 (-53) <= 1 - / 16777216).
  { replace (bpow radix2 (-53)) with (/ 9007199254740992) by reflexivity; lra. }
  set (w := 9007198354021067 * bpow radix2 (-53)) in *; unfold least; fold w.
  set (g := Rabs q_fl - q_error); assert (Hg : bpow radix2 (-360) <= g) by (unfold g; lra).
  pose proof (rnd_plus (Rabs q_fl) (- q_error) (generic_format_abs _ _ _ Fq) (generic_format_opp _ _ _ Fqe)) as E1.
  fold (Rabs q_fl - q_error) in E1; fold g in E1; rewrite (Rabs_pos_eq g) in E1 by lra; apply Rabs_le_inv in E1.
  assert (Hug : u * g <= e * g) by (apply Rmult_le_compat_r; lra); set (g' := rnd g) in *.
  set (l := Rabs A_fl + A_error); pose proof (Rabs_pos A_fl) as HA0; assert (Hl : 0 < l) by (unfold l; lra).
  pose proof (rnd_plus (Rabs A_fl) A_error (generic_format_abs _ _ _ FA) FAe) as E2; fold l in E2.
  rewrite (Rabs_pos_eq l) in E2 by lra; apply Rabs_le_inv in E2.
  assert (Hul : u * l <= e * l) by (apply Rmult_le_compat_r; lra); set (l' := rnd l) in *.
  assert (Hg' : 0 < g' <= (1 + e) * g) by (unfold e in *; lra); assert (Hl' : (1 - e) * l <= l') by lra.
  assert (Hl'0 : 0 < l') by (unfold e in *; lra).
  assert (Hwg : bpow radix2 (-361) <= w * g').
  { change (-361)%Z with (-1 + -360)%Z; rewrite bpow_plus; replace (bpow radix2 (-1)) with (/ 2) by reflexivity.
    apply Rle_trans with (/ 2 * (101 / 100 * g')); [unfold e in *; lra|].
    assert (51 / 100 * g' <= w * g') by (apply Rmult_le_compat_r; lra); lra. }
  pose proof (bpow_gt_0 radix2 (-361)) as H361.
  assert (E3 : Rabs (rnd (w * g') - w * g') <= u * (w * g')).
  { rewrite <- (Rabs_pos_eq (w * g')) at 3 by lra; apply rnd_rel, (at_least_normal (-361)); [lia | rewrite Rabs_pos_eq;
    lra]. }
  apply Rabs_le_inv in E3; assert (u * (w * g') <= e * (w * g')) by (apply Rmult_le_compat_r; lra).
  set (top := rnd (w * g')) in *; assert (Hwg2 : w * g' <= (1 - / 16777216) * ((1 + e) * g)).
  { apply Rmult_le_compat; lra. }
  assert (Htop : 0 < top <= (1 - / 20000000) * g) by (unfold e in *; lra).
  assert (Hdiv : top / l' <= (1 - / 30000000) * (g / l)).
  { apply Rmult_le_reg_r with l'; [assumption|]; replace (top / l' * l') with top by (field; lra).
    apply Rle_trans with (1 := proj2 Htop); apply Rle_trans with ((1 - / 30000000) * (g / l) * ((1 - e) * l)).
    - replace ((1 - / 30000000) * (g / l) * ((1 - e) * l)) with ((1 - / 30000000) * (1 - e) * g) by (field; lra).
      apply Rmult_le_compat_r; unfold e; lra.
    - apply Rmult_le_compat_l; [|assumption]; apply Rmult_le_pos; [lra|]; apply Rlt_le, Rdiv_lt_0_compat; lra. }
  assert (Hgl : (1 - / 400000000) * (g / l) <= Rabs t).
  { apply Rmult_le_reg_r with ((1 + / 1000000000) * l); [apply Rmult_lt_0_compat; lra|].
    apply Rle_trans with (Rabs t * Rabs A); [|apply Rmult_le_compat_l; [apply Rabs_pos | exact Ha]].
    rewrite <- Rabs_mult, (Rmult_comm t), Ht; apply Rle_trans with (2 := Hx); fold g.
    replace ((1 - / 400000000) * (g / l) * ((1 + / 1000000000) * l)) with ((1 - / 400000000) * (1 + / 1000000000) * g)
      by (field; lra); apply Rmult_le_compat_r; lra. }
  assert (Hd0 : 0 < top / l') by (apply Rdiv_lt_0_compat; lra).
  assert (Hl452 : l' <= bpow radix2 452).
  { change 452%Z with (2 + 450)%Z; rewrite bpow_plus; replace (bpow radix2 2) with 4 by reflexivity; unfold l, e in *; lra. }
  assert (Htop362 : bpow radix2 (-362) <= top).
  { change (-362)%Z with (-1 + -361)%Z; rewrite bpow_plus; replace (bpow radix2 (-1)) with (/ 2) by reflexivity.
    unfold e in *; lra. }
  assert (Hdn : bpow radix2 (-814) <= top / l').
  { apply Rmult_le_reg_r with l'; [assumption|]; replace (top / l' * l') with top by (field; lra).
    apply Rle_trans with (2 := Htop362); apply Rle_trans with (bpow radix2 (-814) * bpow radix2 452).
    - apply Rmult_le_compat_l; [apply bpow_ge_0 | assumption].
    - rewrite <- bpow_plus; apply bpow_le; lia. }
  assert (E4 : Rabs (rnd (top / l') - top / l') <= u * (top / l')).
  { rewrite <- (Rabs_pos_eq (top / l')) at 3 by lra; apply rnd_rel, (at_least_normal (-814)); [lia | rewrite Rabs_pos_eq;
    lra]. }
  apply Rabs_le_inv in E4; assert (u * (top / l') <= e * (top / l')) by (apply Rmult_le_compat_r; lra).
  split; [apply rnd_nonneg; lra|].
  apply Rle_trans with (2 := Hgl); assert (0 < g / l) by (apply Rdiv_lt_0_compat; lra); unfold e in *; lra.
Qed.
