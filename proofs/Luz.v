(** Light: what spec/luz.tex claims of the local model, of the depth of recursion and of the window.

    The power of the text is Coq's, and the only function with its laws. *)
From Coq Require Import Reals Lra Lia.
From Durero Require Import Toolkit Especificacion Tipos Puntos Iluminacion.
Local Open Scope R_scope.
Local Open Scope zed_scope.

(** ** The power *)

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

Lemma mayor_is_Rmax a b : mayor a b = Rmax a b.
Proof. reflexivity. Qed.

(** ** Refraction: the numbers of the source text *)

(** Discharges coseno_cuadrado.conj.1. *)
Theorem into_glass_at_45_degrees : coseno_cuadrado_conj_1.
Proof. intros i n k Hk _ Hc Hr. unfold coseno_cuadrado. unfold cuadrado in *. replace k with (2 / 3) by lra. nra. Qed.

(** Discharges reflexion_total.conj.2. *)
Theorem out_of_glass_and_out_of_water : reflexion_total_conj_2.
Proof.
  intros i n k Hk H. unfold reflexion_total, coseno_cuadrado. split; intros E; split.
  - intros [_ L]. unfold cuadrado in *. replace k with (3 / 2) in L by lra. lra.
  - intros L. split; [exact H |]. unfold cuadrado in *. replace k with (3 / 2) by lra. lra.
  - intros [_ L]. unfold cuadrado in *. replace k with (133 / 100) in L by lra. lra.
  - intros L. split; [exact H |]. unfold cuadrado in *. replace k with (133 / 100) by lra. lra.
Qed.

(** ** The local model *)

(** Discharges especular.def.1, especular.conj.1. *)
Theorem a_highlight_is_the_mirrored_light : especular_conj_1.
Proof.
  intros l n r v [_ [Hx [Hy Hz]]] Hn. rewrite Hn in Hx, Hy, Hz. unfold especular.
  replace (producto r v) with
    ((1 * (Vector_x r + Vector_x l)) * Vector_x v + (1 * (Vector_y r + Vector_y l)) * Vector_y v
     + (1 * (Vector_z r + Vector_z l)) * Vector_z v - producto l v) by (components; ring).
  rewrite Hx, Hy, Hz. components. ring.
Qed.

(** Discharges especular.conj.2. *)
Theorem either_may_be_mirrored : especular_conj_2.
Proof. intros l n v. unfold especular. components. ring. Qed.

Lemma producto_symmetric u v : producto u v = producto v u.
Proof. components. ring. Qed.

(** The terms of the local model, with the condition of the highlight decided. *)
Lemma directa_behind m n v l : producto n l <= 0 -> directa m n v l = Material_k_a m * Material_C m.
Proof.
  intros H. unfold directa. rewrite mayor_is_Rmax, Rmax_left by exact H. destruct (Rgt_dec _ _); [lra | ring].
Qed.

Lemma directa_before m n v l : producto n l > 0 ->
  directa m n v l = Material_k_a m * Material_C m + Material_k_d m * Material_C m * producto n l
                    + Material_k_s m * elevado (Rmax 0 (especular l n v)) (Material_e m).
Proof.
  intros H. unfold directa. rewrite !mayor_is_Rmax, Rmax_right by lra. destruct (Rgt_dec _ _); [reflexivity | contradiction].
Qed.

(** Discharges mayor.def.1, directa.conj.1. *)
Theorem behind_the_surface_the_first_term_is_left : directa_conj_1.
Proof. intros m n v l _ H. now apply directa_behind. Qed.

(** Discharges directa.conj.2. *)
Theorem without_a_highlight_it_is_Lamberts_law : directa_conj_2.
Proof.
  intros m n v l _ Hs [H | H].
  - rewrite directa_before, Hs by exact H. ring.
  - rewrite directa_behind by lra. rewrite H. ring.
Qed.

(** Discharges directa.conj.3. *)
Theorem a_highlight_has_no_colour_and_no_back : directa_conj_3.
Proof.
  intros m n v l _ HC H. rewrite directa_before, HC by exact H. split.
  - intros E. rewrite Rmax_right by lra. ring.
  - intros [E He]. rewrite Rmax_left by lra. unfold elevado. rewrite power_of_zero by lra. ring.
Qed.

(** Of unit vectors no product is above one: the square of the difference is not negative. *)
Lemma producto_below_one u v : producto u u = 1 -> producto v v = 1 -> producto u v <= 1.
Proof.
  intros Hu Hv.
  assert (0 <= (Vector_x u - Vector_x v) * (Vector_x u - Vector_x v)
    + (Vector_y u - Vector_y v) * (Vector_y u - Vector_y v) + (Vector_z u - Vector_z v) * (Vector_z u - Vector_z v)).
  { apply Rplus_le_le_0_compat; [apply Rplus_le_le_0_compat |]; apply Rle_0_sqr. }
  replace (producto u v) with ((producto u u + producto v v
    - ((Vector_x u - Vector_x v) * (Vector_x u - Vector_x v) + (Vector_y u - Vector_y v) * (Vector_y u - Vector_y v)
       + (Vector_z u - Vector_z v) * (Vector_z u - Vector_z v))) / 2) by (components; field).
  lra.
Qed.

(** The mirror image of a unit vector is one, so that the cosine of the highlight is not above one either. *)
Lemma especular_below_one l n v : producto n n = 1 -> producto v v = 1 -> producto l l = 1 -> especular l n v <= 1.
Proof.
  intros Hn Hv Hl.
  set (k := 2 * producto l n).
  set (r := mk_Vector (k * Vector_x n - Vector_x l) (k * Vector_y n - Vector_y l) (k * Vector_z n - Vector_z l)).
  replace (especular l n v) with (producto r v).
  - apply producto_below_one; [| exact Hv].
    replace (producto r r) with (k * (k * producto n n - 2 * producto l n) + producto l l)
      by (unfold r; clearbody k; components; ring).
    rewrite Hn, Hl. unfold k. ring.
  - unfold especular. fold k. unfold r. clearbody k. components. ring.
Qed.

(** Discharges directa.def.1, directa.conj.4, Material.inv.1, Material.inv.2, Material.inv.3, Material.inv.6,
    Material.inv.11. *)
Theorem a_light_is_sent_back_by_its_shares_at_most : directa_conj_4.
Proof.
  intros m n v l Hm Hn Hv Hl.
  destruct Hm as [[Ha0 Ha1] [Hd0 Hd1] [Hs0 Hs1] _ _ [HC0 HC1] _ _ _ _ He _].
  assert (P : 0 <= Material_k_a m * Material_C m) by now apply Rmult_le_pos.
  assert (Q : 0 <= Material_k_d m * Material_C m) by now apply Rmult_le_pos.
  destruct (Rgt_dec (producto n l) 0) as [H | H].
  - rewrite directa_before by exact H.
    set (t := elevado (Rmax 0 (especular l n v)) (Material_e m)).
    assert (T : 0 <= t <= 1).
    { split; [apply power_not_negative |]. apply no_power_of_a_share_is_above_one; [| exact He].
      split; [apply Rmax_l |]. apply Rmax_lub; [lra |]. now apply especular_below_one. }
    assert (N : producto n l <= 1) by now apply producto_below_one.
    assert (0 <= Material_k_d m * Material_C m * producto n l) by (apply Rmult_le_pos; lra).
    assert (Material_k_d m * Material_C m * producto n l <= Material_k_d m * Material_C m * 1)
      by (apply Rmult_le_compat_l; lra).
    assert (0 <= Material_k_s m * t) by (apply Rmult_le_pos; lra).
    assert (Material_k_s m * t <= Material_k_s m * 1) by (apply Rmult_le_compat_l; lra).
    lra.
  - rewrite directa_behind by lra. lra.
Qed.

(** What relates one number to another, where it is a function. *)
Lemma value_of {X Y} (A : set X) (B : set Y) f x : f ∈ A ⟶ B -> x ∈ A -> exists y, (x, y) ∈ f /\ y ∈ B.
Proof.
  intros [_ [Hdom Hran]] Hx. apply Hdom in Hx. destruct Hx as [y Hy]. exists y. split; [exact Hy |].
  apply Hran. now exists x.
Qed.

Lemma one_value {X Y} (A : set X) (B : set Y) f x y y' : f ∈ A ⟶ B -> (x, y) ∈ f -> (x, y') ∈ f -> y = y'.
Proof. intros [H _]. apply H. Qed.

Lemma integer z : IZR z ∈ integers.
Proof. now exists z. Qed.

(** Discharges acumulado.def.1, acumulado.conj.1. *)
Theorem a_sum_is_one : acumulado_conj_1.
Proof.
  intros dada suma otra i Hd Hs Ho [z ->] [S0 S1] [O0 O1] Hi.
  assert (Hz : (0 <= z)%Z) by (apply le_IZR; lra).
  clear Hi. revert z Hz. apply natlike_ind.
  - destruct S0 as [v1 [H1 ->]], O0 as [v2 [H2 ->]]. now exists 0, 0.
  - intros z Hz [u [w [Hu [Hw E]]]]. subst w. unfold Z.succ. rewrite plus_IZR.
    assert (P : IZR z >= 0) by (apply Rle_ge, IZR_le, Hz).
    destruct (S1 _ (integer z) P) as [a [b [c [Ha [Hb [Hc ->]]]]]].
    destruct (O1 _ (integer z) P) as [a' [b' [c' [Ha' [Hb' [Hc' ->]]]]]].
    exists (b + c), (b' + c'). repeat split; try assumption.
    rewrite (one_value _ _ _ _ _ _ Hs Hb Hu), (one_value _ _ _ _ _ _ Ho Hb' Hw), (one_value _ _ _ _ _ _ Hd Hc Hc').
    reflexivity.
Qed.

(** Discharges aportacion.def.1, radiancia.def.1, aportacion.conj.1, Fuente.inv.1, Fuente.inv.2, Material.inv.9,
    Material.inv.10. *)
Theorem the_first_term_counts_for_each_light : aportacion_conj_1.
Proof.
  intros m n v f g dada suma Hm Hf Hg Hd Hs Hkd Hks [[z [S0 ->]] S1] [a [Da ->]] [b [Db ->]].
  assert (D : forall l, directa m n v l = Material_k_a m * Material_C m).
  { intros l. destruct (Rgt_dec (producto n l) 0) as [H | H].
    - rewrite directa_before, Hkd, Hks by exact H. ring.
    - apply directa_behind. lra. }
  destruct (S1 0 (integer 0)) as [p [q [r [P [Q [R ->]]]]]]; [lra |].
  destruct (S1 1 (integer 1)) as [p' [q' [r' [P' [Q' [R' ->]]]]]]; [lra |].
  rewrite Rplus_0_l in P.
  replace (1 + 1) with 2 in P' by ring.
  exists (q' + r'). split; [exact P' |].
  rewrite (one_value _ _ _ _ _ _ Hs Q' P), (one_value _ _ _ _ _ _ Hs Q S0), (one_value _ _ _ _ _ _ Hd R Da),
    (one_value _ _ _ _ _ _ Hd R' Db).
  unfold radiancia, indirecta, aportacion. rewrite !D. ring.
Qed.

(** Discharges conserva.def.1, indirecta.def.1, conserva.conj.1, Material.inv.4, Material.inv.5, Material.inv.7,
    Material.inv.8. *)
Theorem what_conserves_shines_no_brighter : conserva_conj_1.
Proof.
  intros m r t [Hm H] Hr Ht. destruct Hm as [_ _ _ [Hp0 _] [Ht0 _] _ [Mp0 _] [Mt0 _] _ _ _ _].
  unfold indirecta. rewrite mayor_is_Rmax. unfold Cantidad in Hr, Ht.
  set (a := Material_k_ps m * Material_M_PS m) in *. set (b := Material_k_t m * Material_M_T m) in *.
  assert (0 <= a) by now apply Rmult_le_pos. assert (0 <= b) by now apply Rmult_le_pos.
  pose proof (Rmax_l r t). pose proof (Rmax_r r t). set (w := Rmax r t) in *.
  assert (a * r <= a * w) by (apply Rmult_le_compat_l; lra).
  assert (b * t <= b * w) by (apply Rmult_le_compat_l; lra).
  assert ((a + b) * w <= 1 * w) by (apply Rmult_le_compat_r; lra).
  lra.
Qed.

(** ** The recursion ends *)

Section Following.
Variable Camino : Type.
Implicit Types (t : Trazado Camino) (L M : rel (R * Camino) R) (c : Camino).

(** What a way brings that may still have so many in a row, itself the first. *)
Fixpoint brings t (left : nat) c : set R := fun y =>
  match left with
  | O => y = 0
  | S fewer =>
      (c ∉ Trazado_llega t /\ (c, y) ∈ Trazado_fondo t)
      \/ (c ∈ Trazado_llega t /\ exists m u r f yr yf, (c, m) ∈ Trazado_material t /\ (c, u) ∈ Trazado_de_luces t
          /\ (c, r) ∈ Trazado_reflejado t /\ (c, f) ∈ Trazado_refractado t /\ brings t fewer r yr
          /\ brings t fewer f yf /\ y = radiancia m u yr yf)
  end.

Lemma brings_something t left c : t ∈ @Trazado_ok Camino -> exists y, brings t left c y.
Proof.
  intros Ht. revert c. induction left as [| fewer IH]; intros c; [now exists 0 |].
  destruct Ht as [_ Hfondo Hmaterial Hluces Hr Hf].
  destruct (Classical_Prop.classic (c ∈ Trazado_llega t)) as [H | H].
  - destruct (value_of _ _ _ c Hmaterial I) as [m [Hm _]]. destruct (value_of _ _ _ c Hluces I) as [u [Hu _]].
    destruct (value_of _ _ _ c Hr I) as [r [Hrc _]]. destruct (value_of _ _ _ c Hf I) as [f [Hfc _]].
    destruct (IH r) as [yr Hyr]. destruct (IH f) as [yf Hyf].
    exists (radiancia m u yr yf). right. split; [exact H |]. exists m, u, r, f, yr, yf. repeat split; assumption.
  - destruct (value_of _ _ _ c Hfondo I) as [y [Hy _]]. exists y. now left.
Qed.

Lemma brings_one t left c y y' : t ∈ @Trazado_ok Camino -> brings t left c y -> brings t left c y' -> y = y'.
Proof.
  intros Ht. revert c y y'. induction left as [| fewer IH]; intros c y y'; [cbn; congruence |].
  destruct Ht as [_ Hfondo Hmaterial Hluces Hr Hf].
  intros [[H Hy] | [H [m [u [r [f [yr [yf [Hm [Hu [Hrc [Hfc [Hyr [Hyf ->]]]]]]]]]]]]]]
    [[H' Hy'] | [H' [m' [u' [r' [f' [yr' [yf' [Hm' [Hu' [Hrc' [Hfc' [Hyr' [Hyf' ->]]]]]]]]]]]]]]; try contradiction.
  - exact (one_value _ _ _ _ _ _ Hfondo Hy Hy').
  - pose proof (one_value _ _ _ _ _ _ Hr Hrc Hrc'). pose proof (one_value _ _ _ _ _ _ Hf Hfc Hfc'). subst r' f'.
    rewrite (one_value _ _ _ _ _ _ Hmaterial Hm Hm'), (one_value _ _ _ _ _ _ Hluces Hu Hu'), (IH _ _ _ Hyr Hyr'),
      (IH _ _ _ Hyf Hyf'). reflexivity.
Qed.

(** How many ways in a row are left at a depth. *)
Definition left_at (maximo n : Z) : nat := Z.to_nat (maximo - n + 1).

Lemma left_at_deeper maximo n : (n <= maximo)%Z -> left_at maximo n = S (left_at maximo (n + 1)).
Proof. intros H. unfold left_at. rewrite <- Z2Nat.inj_succ by lia. f_equal. lia. Qed.

(** Every tracer brings that. *)
Lemma a_tracer_brings t maximo L : t ∈ @Trazado_ok Camino -> L ∈ cartesian integers univ ⟶ univ ->
  trazador t (IZR maximo) L -> forall n c y, ((IZR n, c), y) ∈ L <-> brings t (left_at maximo n) c y.
Proof.
  intros Ht HL [Black [Out In]].
  assert (Into : forall left n c y, left = left_at maximo n -> ((IZR n, c), y) ∈ L -> brings t left c y).
  { induction left as [| fewer IH]; intros n c y E Hy.
    - assert (H : (n > maximo)%Z) by (unfold left_at in E; lia).
      destruct (Black (IZR n) c (integer n)) as [v [Hv ->]]; [apply IZR_lt in H || apply Rlt_gt, IZR_lt; lia |].
      cbn. exact (one_value _ _ _ _ _ _ HL Hy Hv).
    - assert (H : (n <= maximo)%Z) by (unfold left_at in E; lia).
      pose proof (left_at_deeper _ _ H) as E'. rewrite <- E in E'. injection E' as E'.
      destruct (Classical_Prop.classic (c ∈ Trazado_llega t)) as [Hc | Hc].
      + destruct (In (IZR n) c (integer n)) as [v1 [m [u [r [yr [f [yf [H1 [H2 [H3 [H4 [H5 [H6 [H7 ->]]]]]]]]]]]]]];
          [now apply IZR_le | exact Hc |].
        rewrite <- plus_IZR in H5, H7.
        right. split; [exact Hc |]. exists m, u, r, f, yr, yf.
        repeat split; try assumption; try (eapply IH; eassumption).
        exact (one_value _ _ _ _ _ _ HL Hy H1).
      + destruct (Out (IZR n) c (integer n)) as [v1 [v2 [H1 [H2 ->]]]]; [now apply IZR_le | exact Hc |].
        left. split; [exact Hc |]. now rewrite (one_value _ _ _ _ _ _ HL Hy H1). }
  intros n c y. split; [now apply Into |]. intros Hy.
  destruct (value_of _ _ _ (IZR n, c) HL) as [v [Hv _]]; [split; [apply integer | exact I] |].
  now rewrite (brings_one _ _ _ _ _ Ht Hy (Into _ _ _ _ eq_refl Hv)).
Qed.

(** Discharges trazador.conj.2. *)
Theorem there_is_one_answer : trazador_conj_2 Camino.
Proof.
  intros t maximo L M Ht [z ->] HL HM HtL HtM [[n c] y].
  destruct (Classical_Prop.classic (n ∈ integers)) as [[k ->] | Hn].
  - rewrite (a_tracer_brings _ _ _ Ht HL HtL), (a_tracer_brings _ _ _ Ht HM HtM). reflexivity.
  - split; intros H; exfalso; apply Hn.
    + destruct HL as [_ [Hdom _]]. apply (Hdom (n, c)). now exists y.
    + destruct HM as [_ [Hdom _]]. apply (Hdom (n, c)). now exists y.
Qed.

(** Discharges trazador.def.1, trazador.conj.1. *)
Theorem the_recursion_ends : trazador_conj_1 Camino.
Proof.
  intros t maximo Ht [z ->].
  exists (fun p => exists n, fst (fst p) = IZR n /\ brings t (left_at z n) (snd (fst p)) (snd p)).
  assert (At : forall n c y, brings t (left_at z n) c y ->
    (fun p : (R * Camino) * R => exists n, fst (fst p) = IZR n /\ brings t (left_at z n) (snd (fst p)) (snd p))
      ((IZR n, c), y)).
  { intros n c y H. exists n. now split. }
  split; [split; [| split] | split; [| split]].
  - intros [x c] y y' [n [E H]] [n' [E' H']]. cbn in *. subst x. apply eq_IZR in E'. subst n'.
    exact (brings_one _ _ _ _ _ Ht H H').
  - intros [x c]. split.
    + intros [y [n [E _]]]. cbn in E. split; [now exists n | exact I].
    + intros [[n E] _]. cbn in E. subst x. destruct (brings_something t (left_at z n) c Ht) as [y Hy].
      exists y. now apply At.
  - easy.
  - intros x c [n ->] H. exists 0. split; [| reflexivity]. apply At.
    unfold left_at. replace (Z.to_nat (z - n + 1)) with O; [reflexivity |].
    apply Rgt_lt, lt_IZR in H. lia.
  - intros x c [n ->] H Hc. apply le_IZR in H.
    destruct (value_of _ _ _ c (Trazado_decl_fondo Ht) I) as [y [Hy _]].
    exists y, y. repeat split; [| exact Hy]. apply At. rewrite left_at_deeper by exact H. now left.
  - intros x c [n ->] H Hc. apply le_IZR in H.
    destruct (brings_something t (left_at z n) c Ht) as [y Hy]. pose proof Hy as Hy'.
    rewrite left_at_deeper in Hy' by exact H.
    destruct Hy' as [[Hc' _] | [_ [m [u [r [f [yr [yf [Hm [Hu [Hr [Hf [Hyr [Hyf E]]]]]]]]]]]]]]; [contradiction |].
    exists y, m, u, r, yr, f, yf. rewrite <- plus_IZR. repeat split; try assumption; now apply At.
Qed.

(** Discharges trazador.conj.3. *)
Theorem no_depth_is_black_and_one_goes_not_on : trazador_conj_3 Camino.
Proof.
  intros t L M c Ht HL HM [Black _] [BlackM [_ In]] Hc. split.
  - apply (Black 1 c (integer 1)). lra.
  - destruct (In 1 c (integer 1)) as [v1 [m [u [r [yr [f [yf [H1 [H2 [H3 [H4 [H5 [H6 [H7 E]]]]]]]]]]]]]]; [lra | exact Hc |].
    exists v1, m, u. repeat split; try assumption. replace (1 + 1) with 2 in H5, H7 by ring.
    destruct (BlackM 2 r (integer 2)) as [z [Hz ->]]; [lra |].
    destruct (BlackM 2 f (integer 2)) as [z' [Hz' ->]]; [lra |].
    now rewrite E, (one_value _ _ _ _ _ _ HM H5 Hz), (one_value _ _ _ _ _ _ HM H7 Hz').
Qed.
End Following.

(** ** The window *)

(** Discharges centro_de_pixel.def.1, centro_de_pixel.conj.1, Ventana.inv.1, Ventana.inv.2. *)
Theorem opposite_pixels_lie_about_the_middle : centro_de_pixel_conj_1.
Proof.
  intros w x y j k p q [_ _ HH HV] _ _ _ _ [_ [_ [Px [Py Pz]]]] [_ [_ [Qx [Qy Qz]]]] Ex Ey.
  assert (P : 0 < 2 * Ventana_H w * Ventana_V w) by (repeat apply Rmult_lt_0_compat; lra).
  assert (Sum : forall a b s d e,
    2 * Ventana_H w * Ventana_V w * (a - s) = (2 * x + 1) * Ventana_V w * d + (2 * y + 1) * Ventana_H w * e ->
    2 * Ventana_H w * Ventana_V w * (b - s) = (2 * j + 1) * Ventana_V w * d + (2 * k + 1) * Ventana_H w * e ->
    a + b = 2 * s + d + e).
  { intros a b s d e A B. apply Rmult_eq_reg_l with (2 * Ventana_H w * Ventana_V w); [| lra].
    replace (2 * Ventana_H w * Ventana_V w * (a + b)) with
      (2 * Ventana_H w * Ventana_V w * (a - s) + 2 * Ventana_H w * Ventana_V w * (b - s)
       + 2 * Ventana_H w * Ventana_V w * (2 * s)) by ring.
    rewrite A, B, <- Ex, <- Ey. ring. }
  split; [| split]; eapply Sum; eassumption.
Qed.

(** Discharges rayo_de_pixel.def.1, rayo_de_pixel.conj.1. *)
Theorem every_pixel_has_its_ray : rayo_de_pixel_conj_1.
Proof.
  intros w x y q _ _ _ Hq Hne.
  set (o := Ventana_ojo w) in *.
  set (v := mk_Vector (Punto_x q - Punto_x o) (Punto_y q - Punto_y o) (Punto_z q - Punto_z o)).
  exists (mk_Rayo o v). split; [| split; [reflexivity |]].
  - split. intros [Hx [Hy Hz]]. apply Hne. destruct q, o; cbn in *. f_equal; lra.
  - exists q. split; [| exact Hq]. exists 1. split; [unfold Rmas; lra |]. cbn. repeat split; ring.
Qed.

(** ** Lights and media *)

(** Discharges Material.conj.1, Material.inv.12. *)
Theorem two_media_have_one_ratio : Material_conj_1.
Proof.
  intros m n Hm Hn. pose proof (Material_inv_12 Hm) as Pm. pose proof (Material_inv_12 Hn) as Pn. unfold Rmas in *.
  exists (Material_indice m / Material_indice n). split.
  - split; [now apply Rdiv_lt_0_compat | field; lra].
  - intros k [_ <-]. field. lra.
Qed.

(** Discharges visible.def.1, visible_lejos.def.1, visible.conj.1. *)
Theorem a_light_without_end_is_visible_nearer (Elemento : Type) : visible_conj_1 Elemento.
Proof.
  intros s p q l en _ Hx Hy Hz [rayo [Hok [Hp [Vx [Vy [Vz Hno]]]]]].
  refine (ex_intro _ rayo (conj Hok (conj Hp (conj _ (conj _ (conj _ _)))))); try congruence.
  intros [t [w [_ [Hw _]]]]. apply Hno. intros E. now apply (E w).
Qed.
