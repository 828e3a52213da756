(** Power: that of the text, elevado, is Coq's, and the only function with its laws. *)
From Coq Require Import Reals Lra Lia.
From Durero Require Import Toolkit Especificacion Tipos.
Local Open Scope R_scope.
Local Open Scope zed_scope.

Lemma power_zero x : power_of x 0 = 1.
Proof. unfold power_of. destruct (Req_EM_T 0 0); [reflexivity | contradiction]. Qed.

Lemma power_of_zero a : 0 < a -> power_of 0 a = 0.
Proof. intros H. unfold power_of. destruct (Req_EM_T a 0); [lra |]. destruct (Rle_dec 0 0); lra. Qed.

Lemma power_positive x a : 0 < x -> power_of x a = Rpower x a.
Proof.
  intros H. unfold power_of. destruct (Req_EM_T a 0) as [-> |].
  - now rewrite Rpower_O.
  - destruct (Rle_dec x 0); [lra | reflexivity].
Qed.

Lemma power_not_negative x a : 0 <= power_of x a.
Proof.
  unfold power_of. destruct (Req_EM_T a 0); [lra |]. destruct (Rle_dec x 0); [lra |].
  unfold Rpower. apply Rlt_le, exp_pos.
Qed.

Lemma power_one x : 0 <= x -> power_of x 1 = x.
Proof.
  intros [H | <-].
  - rewrite power_positive by assumption. now apply Rpower_1.
  - apply power_of_zero. lra.
Qed.

Lemma power_adds x a b : 0 <= x -> 0 <= a -> 0 <= b -> power_of x (a + b) = power_of x a * power_of x b.
Proof.
  intros [H | <-] Ha Hb.
  - rewrite !power_positive by assumption. apply Rpower_plus.
  - destruct Ha as [Ha | <-].
    + rewrite (power_of_zero a) by assumption. rewrite power_of_zero by lra. ring.
    + rewrite power_zero. rewrite Rplus_0_l. ring.
Qed.

Lemma power_monotone x y a : 0 <= x -> x <= y -> 0 <= a -> power_of x a <= power_of y a.
Proof.
  intros Hx Hxy [Ha | <-].
  - destruct Hx as [Hx | <-].
    + rewrite !power_positive by lra. apply Rle_Rpower_l; lra.
    + rewrite power_of_zero by assumption. apply power_not_negative.
  - rewrite !power_zero. lra.
Qed.

(** Discharges elevado.def.1, elevado.def.2, elevado.def.3, Cantidad.inv.1. *)
Theorem the_power_has_the_laws :
  elevado_decl elevado /\ elevado_def_1 elevado /\ elevado_def_2 elevado /\ elevado_def_3 elevado.
Proof.
  unfold elevado. repeat split.
  - intros x1 x2 _ _. apply Rle_ge, power_not_negative.
  - apply power_zero.
  - apply power_one. now apply Rge_le.
  - rewrite power_positive by lra. unfold Rpower. rewrite ln_1, Rmult_0_r. apply exp_0.
  - intros x a b Hx Ha Hb. apply power_adds; now apply Rge_le.
  - intros x y a Hx Hy Ha Hxy. apply power_monotone; auto using Rge_le.
Qed.

(** A power of a sum of equal exponents. *)
Lemma power_of_multiple f x a n : elevado_def_1 f -> elevado_def_2 f -> 0 <= x -> 0 <= a -> f x (INR n * a) = f x a ^ n.
Proof.
  intros H1 H2 Hx Ha. induction n as [| n IH].
  - rewrite Rmult_0_l. destruct (H1 x) as [E _]; [unfold Cantidad; lra | exact E].
  - rewrite S_INR. replace ((INR n + 1) * a) with (INR n * a + a) by ring.
    rewrite H2; unfold Cantidad; try lra.
    + rewrite IH. cbn. ring.
    + apply Rle_ge, Rmult_le_pos; [apply pos_INR | assumption].
Qed.

Lemma power_of_whole f x n : elevado_def_1 f -> elevado_def_2 f -> 0 <= x -> f x (INR n) = x ^ n.
Proof.
  intros H1 H2 Hx. rewrite <- (Rmult_1_r (INR n)), power_of_multiple by (auto; lra).
  destruct (H1 x) as [_ [E _]]; [unfold Cantidad; lra | now rewrite E].
Qed.

(** With the exponent a power rises from a base of one on, and falls below it. *)
Section Rising.
Variable f : R -> R -> R.
Hypothesis f_not_negative : elevado_decl f.
Hypothesis f_values : elevado_def_1 f.
Hypothesis f_adds : elevado_def_2 f.
Hypothesis f_monotone : elevado_def_3 f.

Lemma power_of_the_rest x a b : 0 <= x -> 0 <= a <= b ->
  f x a >= 0 /\ f 1 (b - a) = 1 /\ f x b = f x a * f x (b - a).
Proof.
  intros Hx Hab. repeat split.
  - apply f_not_negative; unfold Cantidad; lra.
  - apply f_values; unfold Cantidad; lra.
  - rewrite <- f_adds; unfold Cantidad; try lra. f_equal. ring.
Qed.

Lemma power_rises x a b : 1 <= x -> 0 <= a <= b -> f x a <= f x b.
Proof.
  intros Hx Hab. destruct (power_of_the_rest x a b) as [P [One E]]; [lra | exact Hab |].
  assert (1 <= f x (b - a)) by (rewrite <- One; apply f_monotone; unfold Cantidad; lra).
  rewrite E. rewrite <- (Rmult_1_r (f x a)) at 1. apply Rmult_le_compat_l; lra.
Qed.

Lemma power_falls x a b : 0 <= x <= 1 -> 0 <= a <= b -> f x b <= f x a.
Proof.
  intros Hx Hab. destruct (power_of_the_rest x a b) as [P [One E]]; [lra | exact Hab |].
  assert (f x (b - a) <= 1) by (rewrite <- One; apply f_monotone; unfold Cantidad; lra).
  rewrite E. rewrite <- (Rmult_1_r (f x a)) at 2. apply Rmult_le_compat_l; lra.
Qed.
End Rising.

Lemma whole_part r : 0 <= r -> exists k, INR k <= r <= INR (S k).
Proof.
  intros H. destruct (archimed r) as [A B]. exists (Z.to_nat (up r - 1)).
  assert (P : (1 <= up r)%Z).
  { apply Z.lt_pred_le. cbn. apply lt_IZR. lra. }
  rewrite S_INR, INR_IZR_INZ, Z2Nat.id by lia. rewrite minus_IZR. lra.
Qed.

(** What is bounded by another, at every power up to one factor, is no greater. *)
Lemma powers_decide u w K : 0 <= u -> 0 <= w -> (forall n, u ^ n <= K * w ^ n) -> u <= w.
Proof.
  intros Hu Hw H. apply Rnot_lt_le. intros Hlt. destruct Hw as [Hw | <-].
  - set (h := u / w - 1).
    assert (Hh : 0 < h).
    { unfold h. apply Rlt_Rminus. apply Rmult_lt_reg_r with w; [assumption |].
      unfold Rdiv. rewrite Rmult_assoc, Rinv_l by lra. lra. }
    destruct (whole_part (Rabs K / h)) as [k [_ Hk]].
    { apply Rmult_le_pos; [apply Rabs_pos | apply Rlt_le, Rinv_0_lt_compat, Hh]. }
    pose proof (poly (S k) h Hh) as Hp. pose proof (H (S k)) as Hn.
    assert (E : (1 + h) ^ S k * w ^ S k = u ^ S k).
    { rewrite <- Rpow_mult_distr. f_equal. unfold h. field. lra. }
    assert (W : 0 < w ^ S k) by now apply pow_lt.
    assert ((1 + h) ^ S k <= K).
    { apply Rmult_le_reg_r with (w ^ S k); [assumption | now rewrite E]. }
    assert (Rabs K <= INR (S k) * h).
    { apply Rmult_le_reg_r with (/ h); [now apply Rinv_0_lt_compat |].
      rewrite Rmult_assoc, Rinv_r, Rmult_1_r by lra. exact Hk. }
    pose proof (Rle_abs K). lra.
  - specialize (H 1%nat). cbn in H. lra.
Qed.

Lemma power_below f g x a : elevado_decl f -> elevado_def_1 f -> elevado_def_2 f -> elevado_def_3 f ->
  elevado_decl g -> elevado_def_1 g -> elevado_def_2 g -> elevado_def_3 g ->
  0 < x -> 0 <= a -> f x a <= g x a.
Proof.
  intros F0 F1 F2 F3 G0 G1 G2 G3 Hx Ha.
  assert (Pf : f x a >= 0) by (apply F0; unfold Cantidad; lra).
  assert (Pg : g x a >= 0) by (apply G0; unfold Cantidad; lra).
  apply powers_decide with (Rmax x (/ x)); [lra | lra |]. intros n.
  rewrite <- !power_of_multiple by (auto; lra).
  assert (Hna : 0 <= INR n * a) by (apply Rmult_le_pos; [apply pos_INR | assumption]).
  destruct (whole_part (INR n * a) Hna) as [k [L U]].
  assert (Hk : 0 <= INR k) by apply pos_INR.
  assert (Hp : 0 < x ^ k) by now apply pow_lt.
  assert (Pn : g x (INR n * a) >= 0) by (apply G0; unfold Cantidad; lra).
  destruct (Rle_or_lt 1 x) as [H1 | H1].
  - assert (A : f x (INR n * a) <= f x (INR (S k))) by (apply (power_rises f); auto; lra).
    assert (B : g x (INR k) <= g x (INR n * a)) by (apply (power_rises g); auto; lra).
    rewrite power_of_whole in A, B by (auto; lra). cbn in A.
    apply Rle_trans with (1 := A). apply Rmult_le_compat; [lra | lra | apply Rmax_l | exact B].
  - assert (A : f x (INR n * a) <= f x (INR k)) by (apply (power_falls f); auto; lra).
    assert (B : g x (INR (S k)) <= g x (INR n * a)) by (apply (power_falls g); auto; lra).
    rewrite power_of_whole in A, B by (auto; lra). cbn in B.
    apply Rle_trans with (1 := A).
    assert (I : 0 < / x) by now apply Rinv_0_lt_compat.
    apply Rle_trans with (/ x * g x (INR n * a)).
    + apply Rmult_le_reg_l with x; [assumption |]. rewrite <- Rmult_assoc, Rinv_r by lra. lra.
    + apply Rmult_le_compat_r; [lra | apply Rmax_r].
Qed.

Lemma no_power_of_zero f a : elevado_decl f -> elevado_def_1 f -> elevado_def_2 f -> 0 < a -> f 0 a = 0.
Proof.
  intros F0 F1 F2 Ha.
  destruct (whole_part (/ a)) as [k [_ Hk]]; [now apply Rlt_le, Rinv_0_lt_compat |].
  assert (Hn : 1 <= INR (S k) * a).
  { apply Rmult_le_reg_r with (/ a); [now apply Rinv_0_lt_compat |]. rewrite Rmult_assoc, Rinv_r, Rmult_1_r by lra. lra. }
  destruct (Req_dec (f 0 a) 0) as [E | E]; [exact E | exfalso].
  apply (pow_nonzero _ (S k)) in E. apply E. rewrite <- power_of_multiple by (auto; lra).
  replace (INR (S k) * a) with (1 + (INR (S k) * a - 1)) by ring.
  rewrite F2; unfold Cantidad; try lra. destruct (F1 0) as [_ [-> _]]; [unfold Cantidad; lra | ring].
Qed.

(** The laws leave no choice: whatever has them is the power of the text. *)
Theorem the_power_is_one f : elevado_decl f -> elevado_def_1 f -> elevado_def_2 f -> elevado_def_3 f ->
  forall x a, x ∈ Cantidad -> a ∈ Cantidad -> f x a = elevado x a.
Proof.
  intros F0 F1 F2 F3 x a Hx Ha. unfold Cantidad in Hx, Ha.
  destruct the_power_has_the_laws as [G0 [G1 [G2 G3]]].
  destruct (Rlt_or_le 0 x) as [Px | Px].
  - apply Rle_antisym; apply power_below; auto; lra.
  - replace x with 0 by lra. destruct (Rlt_or_le 0 a) as [Pa | Pa].
    + rewrite no_power_of_zero, (no_power_of_zero elevado) by assumption. reflexivity.
    + replace a with 0 by lra. destruct (F1 0) as [-> _]; [unfold Cantidad; lra |].
      destruct (G1 0) as [-> _]; [unfold Cantidad; lra | reflexivity].
Qed.

(** The power of a whole exponent is the product. *)
Lemma elevado_whole x n : 0 <= x -> elevado x (INR n) = x ^ n.
Proof. intros H. destruct the_power_has_the_laws as [_ [H1 [H2 _]]]. now apply power_of_whole. Qed.

(** Discharges elevado.conj.1. *)
Theorem half_five_times_is_below_a_twentieth : elevado_conj_1.
Proof.
  intros m H. replace m with (/ 2) by lra.
  replace 5 with (INR 5) by (cbn; ring). replace 4 with (INR 4) by (cbn; ring).
  rewrite !elevado_whole by lra. cbn. lra.
Qed.

(** Discharges elevado.conj.2, Parte.inv.1. *)
Theorem no_power_of_a_share_is_above_one : elevado_conj_2.
Proof.
  intros c a [H0 H1] Ha. destruct the_power_has_the_laws as [_ [One [_ Rises]]].
  destruct (One a Ha) as [_ [_ E]]. rewrite <- E. apply Rises; unfold Cantidad in *; lra.
Qed.
