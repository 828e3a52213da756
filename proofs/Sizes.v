(** * Sizes: what the steps find is far below 2^1024

    The rounding of the proofs knows no infinity, so that the ends of what a step finds are binary64 only where they are
    below 2^1024. They are: of numbers in range each coefficient is below a power of two that is read off its term, and what
    is divided by is larger than its error, which is larger than another.

    below e x             == |x| is 2^e at most, and e is not negative
    below2 e x            == so are both parts of the pair x
    size                  == the tactic that finds e: the powers of what a term is made of, added up
    modest a b f          == what is divided in f is below 2^a, what it is divided by errs by 2^-b or more
    sized, sized2 root    == the root and its error are below 2^1010 *)
From Coq Require Import Reals ZArith Lra Lia.
From Flocq Require Import Core Mult_error.
From Durero Require Import Rounding Vectors Quotient Flotante Twofold Sums.
From Durero Require Formas Verdict Doubled.
Import Formas.Pairs.
Local Open Scope R_scope.
Local Opaque bpow.
Local Instance prec53 : Prec_gt_0 53 := eq_refl.

(** ** Powers of two above a term *)

Definition below (e : Z) (x : R) : Prop := (0 <= e)%Z /\ Rabs x <= bpow radix2 e.
Definition below2 (e : Z) (x : twofold) : Prop := below e (hi x) /\ below e (lo x).

Lemma below_more e e' x : below e x -> (e <= e')%Z -> below e' x.
Proof. intros [H0 H] He; split; [lia | apply Rle_trans with (1 := H), bpow_le, He]. Qed.

Lemma below_rnd e x : below e x -> below e (rnd x).
Proof.
  intros [H0 H]; split; [exact H0|]; apply abs_round_le_generic; auto with typeclass_instances; apply format_bpow; lia.
Qed.

Lemma below_opp e x : below e x -> below e (- x).
Proof. unfold below; now rewrite Rabs_Ropp. Qed.

Lemma below_abs e x : below e x -> below e (Rabs x).
Proof. unfold below; now rewrite Rabs_Rabsolu. Qed.

Lemma below_plus a b x y : below a x -> below b y -> below (Z.max a b + 1) (x + y).
Proof.
  intros [A0 A] [B0 B]; split; [lia|]; rewrite bpow_plus; replace (bpow radix2 1) with 2 by reflexivity.
  pose proof (bpow_le radix2 a (Z.max a b) ltac:(lia)); pose proof (bpow_le radix2 b (Z.max a b) ltac:(lia)).
  pose proof (Rabs_triang x y); lra.
Qed.

Lemma below_minus a b x y : below a x -> below b y -> below (Z.max a b + 1) (x - y).
Proof. intros A B; apply below_plus; [exact A | now apply below_opp]. Qed.

Lemma below_mult a b x y : below a x -> below b y -> below (a + b) (x * y).
Proof.
  intros [A0 A] [B0 B]; split; [lia|]; rewrite Rabs_mult, bpow_plus; apply Rmult_le_compat; auto using Rabs_pos.
Qed.

Lemma below_sqrt e x : below e x -> below e (sqrt x).
Proof.
  intros [H0 H]; split; [exact H0|]; rewrite Rabs_pos_eq by apply sqrt_pos.
  assert (H1 : 1 <= bpow radix2 e) by (change 1 with (bpow radix2 0); now apply bpow_le).
  rewrite <- (sqrt_square (bpow radix2 e)) by lra; apply sqrt_le_1_alt, Rle_trans with (1 := Rle_abs x).
  apply Rle_trans with (1 := H); rewrite <- (Rmult_1_l (bpow radix2 e)) at 1; apply Rmult_le_compat_r; lra.
Qed.

Lemma below_bpow k : below (Z.max 0 k) (bpow radix2 k).
Proof. split; [lia|]; rewrite Rabs_pos_eq by apply bpow_ge_0; apply bpow_le; lia. Qed.

Lemma below_IZR n : below (Z.log2 (Z.abs n) + 1) (IZR n).
Proof.
  pose proof (Z.log2_nonneg (Z.abs n)); split; [lia|]; rewrite <- abs_IZR, <- (IZR_Zpower radix2) by lia; apply IZR_le.
  destruct (Z.eq_dec n 0) as [-> | N]; [apply (Z.pow_nonneg 2); lia|].
  pose proof (Z.log2_spec (Z.abs n) ltac:(lia)) as [_ H']; rewrite <- Z.add_1_r in H'; apply Z.lt_le_incl; exact H'.
Qed.

Lemma below_if (c : bool) a b x y : below a x -> below b y -> below (Z.max a b) (if c then x else y).
Proof. intros A B; destruct c; eapply below_more; eauto; lia. Qed.

Lemma below_ordinary x : ordinary x -> below 100 x.
Proof.
  intros [_ [-> | [_ H]]]; (split; [lia|]); [rewrite Rabs_R0; apply bpow_ge_0 | exact H].
Qed.

(** ** The same of pairs *)

Lemma below2_hi e x : below2 e x -> below e (hi x).
Proof. now intros [H _]. Qed.

Lemma below2_more e e' x : below2 e x -> (e <= e')%Z -> below2 e' x.
Proof. intros [A B] H; split; eapply below_more; eauto. Qed.

Lemma below2_exactly e a : below e a -> below2 e (exactly a).
Proof. intros A; split; [exact A|]; destruct A as [H0 _]; split; [exact H0 | cbn; rewrite Rabs_R0; apply bpow_ge_0]. Qed.

Lemma below2_opposite e x : below2 e x -> below2 e (opposite x).
Proof. intros [A B]; split; now apply below_opp. Qed.

(** Of a sum of which the power is known both may have one less. *)
Lemma below_plus_at e x y : below (e - 1) x -> below (e - 1) y -> below e (x + y).
Proof. intros A B; eapply below_more; [apply below_plus; eassumption | lia]. Qed.

Ltac plain :=
  match goal with
  | |- below _ (round _ _ _ _) => apply below_rnd; plain
  | |- below _ (_ + _) => apply below_plus_at; plain
  | |- below _ (_ - _) => apply below_plus_at; [plain | apply below_opp; plain]
  | |- below _ (- _) => apply below_opp; plain
  | |- below _ (_ * _) => eapply below_more; [eapply below_mult; eassumption | lia]
  | |- below _ _ => eapply below_more; [eassumption | lia]
  end.
Ltac bound := cbv zeta; split; cbn [hi lo]; plain.

Lemma below2_two_sum a b x y : below a x -> below b y -> below2 (Z.max a b + 6) (two_sum x y).
Proof. intros A B; unfold two_sum; bound. Qed.

Lemma below2_sum a b x y : below2 a x -> below2 b y -> below2 (Z.max a b + 13) (sum x y).
Proof. destruct x, y; intros [A B] [C D]; cbn [hi lo] in *; unfold sum; bound. Qed.

Lemma below2_difference a b x y : below2 a x -> below2 b y -> below2 (Z.max a b + 13) (difference x y).
Proof. destruct x, y; intros [A B] [C D]; cbn [hi lo] in *; unfold difference; bound. Qed.

Lemma below2_product a b x y : below2 a x -> below2 b y -> below2 (a + b + 8) (product x y).
Proof. destruct x, y; intros [A B] [C D]; pose proof (proj1 A); pose proof (proj1 C); cbn [hi lo] in *; unfold product; bound. Qed.

Ltac size :=
  lazymatch goal with
  | |- below _ (round _ _ _ _) => apply below_rnd; size
  | |- below _ (_ + _) => eapply below_plus; [size | size]
  | |- below _ (_ - _) => eapply below_minus; [size | size]
  | |- below _ (- _) => apply below_opp; size
  | |- below _ (Rabs _) => apply below_abs; size
  | |- below _ (sqrt _) => apply below_sqrt; size
  | |- below _ (bpow _ _) => apply below_bpow
  | |- below _ (IZR _) => apply below_IZR
  | |- below _ (_ * _) => eapply below_mult; [size | size]
  | |- below _ (if _ then _ else _) => eapply below_if; [size | size]
  | |- below _ (hi _) => eapply below2_hi; size2
  | |- below _ _ => eassumption
  end
with size2 :=
  lazymatch goal with
  | |- below2 _ (exactly _) => eapply below2_exactly; size
  | |- below2 _ (two_sum _ _) => eapply below2_two_sum; [size | size]
  | |- below2 _ (opposite _) => eapply below2_opposite; size2
  | |- below2 _ (sum _ _) => eapply below2_sum; [size2 | size2]
  | |- below2 _ (difference _ _) => eapply below2_difference; [size2 | size2]
  | |- below2 _ (product _ _) => eapply below2_product; [size2 | size2]
  | |- below2 _ _ => eassumption
  end.

(** ** A quotient and its error *)

Lemma format_scaled m x : (0 <= m)%Z -> format x -> format (bpow radix2 m * x).
Proof. intros Hm Fx; rewrite Rmult_comm; now apply mult_bpow_pos_exact_FLT. Qed.

Lemma quotient_error_below m k v x_error y y_error : (0 <= m)%Z -> (k <= 0)%Z -> Rabs v <= bpow radix2 m -> format y_error ->
  0 <= x_error <= bpow radix2 m * y_error -> 0 < y_error -> 2 * y_error < Rabs y ->
  below (m + 3) (rnd (rnd (rnd (rnd (x_error + rnd (Rabs v * y_error)) / rnd (Rabs y - y_error)) * (4503600077730459 * bpow
    radix2 (-52))) + rnd (bpow radix2 k * Rabs v))).
Proof.
  intros Hm Hk Hv Fe [Hx0 Hx] He Hy; set (P := bpow radix2 m * y_error) in *; pose proof (bpow_gt_0 radix2 m) as Pm.
  assert (FP : format P) by now apply format_scaled.
  assert (Hprod : 0 <= rnd (Rabs v * y_error) <= P).
  { split; [apply rnd_nonneg, Rmult_le_pos; [apply Rabs_pos | lra]|]; rewrite <- (rnd_format P FP); apply rnd_le.
    apply Rmult_le_compat_r; [lra | exact Hv]. }
  assert (Hup : 0 <= rnd (x_error + rnd (Rabs v * y_error)) <= 2 * P).
  { split; [apply rnd_nonneg; lra|]; rewrite <- (rnd_double P FP); apply rnd_le; lra. }
  assert (Hdown : y_error <= rnd (Rabs y - y_error)) by (rewrite <- (rnd_format y_error Fe) at 1; apply rnd_le; lra).
  assert (E1 : bpow radix2 (m + 1) = 2 * bpow radix2 m) by (rewrite bpow_plus; replace (bpow radix2 1) with 2 by reflexivity; ring).
  assert (Hratio : below (m + 1) (rnd (x_error + rnd (Rabs v * y_error)) / rnd (Rabs y - y_error))).
  { split; [lia|]; rewrite Rabs_pos_eq by (apply Rmult_le_pos; [lra | apply Rlt_le, Rinv_0_lt_compat; lra]).
    apply Rmult_le_reg_r with (rnd (Rabs y - y_error)); [lra|]; unfold Rdiv; rewrite Rmult_assoc, Rinv_l, Rmult_1_r, E1 by lra.
    apply Rle_trans with (2 * P); [lra|]; unfold P; rewrite <- Rmult_assoc; apply Rmult_le_compat_l; lra. }
  assert (Hwiden : below 1 (4503600077730459 * bpow radix2 (-52))).
  { split; [lia|]; replace (bpow radix2 (-52)) with (/ 4503599627370496) by reflexivity; replace (bpow radix2 1) with 2 by reflexivity.
    rewrite Rabs_pos_eq; lra. }
  assert (Hv' : below m v) by now split.
  assert (Hk' : below 0 (bpow radix2 k)) by (eapply below_more; [apply below_bpow | lia]).
  eapply below_more; [apply below_rnd, below_plus; apply below_rnd; apply below_mult;
    [apply below_rnd, Hratio | exact Hwiden | exact Hk' | apply below_abs, Hv'] | lia].
Qed.

Definition sized (root : Formas.known R) : Prop := below 1010 (Formas.value root) /\ below 1010 (Formas.error root).
Definition sized2 (root : Formas.known twofold) : Prop := below 1010 (hi (Formas.value root)) /\ below 1010 (Formas.error root).

Lemma divided a b x y : (0 <= b)%Z -> below a x -> bpow radix2 (- b) <= Rabs y -> below (a + b) (x / y).
Proof.
  intros Hb [H0 H] Hy; split; [lia|]; unfold Rdiv; rewrite Rabs_mult, bpow_plus; apply Rmult_le_compat; auto using Rabs_pos.
  rewrite Rabs_inv; replace b with (- - b)%Z by lia; rewrite bpow_opp; pose proof (bpow_gt_0 radix2 (- b)).
  apply Rinv_le; lra.
Qed.

Lemma between_powers a b x_error y_error : below a x_error -> bpow radix2 (- b) <= y_error -> 0 <= x_error ->
  0 <= x_error <= bpow radix2 (a + b) * y_error.
Proof.
  intros [_ H] Hy H0; split; [exact H0|]; apply Rle_trans with (bpow radix2 (a + b) * bpow radix2 (- b)).
  - rewrite <- bpow_plus; replace (a + b + - b)%Z with a by ring; apply Rle_trans with (2 := H), Rle_abs.
  - apply Rmult_le_compat_l; [apply bpow_ge_0 | exact Hy].
Qed.

Theorem quotient_sized a b x x_error y y_error : (0 <= b)%Z -> (a + b <= 1000)%Z -> below a x -> below a x_error -> 0 <= x_error ->
  format y_error -> bpow radix2 (- b) <= y_error -> 2 * y_error < Rabs y ->
  sized (Formas.quotient x x_error y y_error).
Proof.
  intros Hb Hab Hx Hxe Hx0 Fe Hye Hy; pose proof (bpow_gt_0 radix2 (- b)) as Pb; pose proof (proj1 Hx).
  assert (Hq : below (a + b) (x / y)) by (apply divided; auto; lra); apply below_rnd in Hq.
  unfold sized, Formas.quotient; cbn [Formas.value Formas.error]; split; [apply (below_more _ _ _ Hq); lia|].
  eapply below_more; [apply quotient_error_below with (m := (a + b)%Z); auto; try lia; try lra | lia].
  - apply Hq.
  - now apply between_powers.
Qed.

(** The first part of a quotient of pairs: what is left of the first division is not above what is divided. *)
Lemma ratio_below a b x y : (0 <= b)%Z -> below2 a x -> double_word y -> bpow radix2 (- b) <= Rabs (hi y) <= bpow radix2 1000 ->
  below (a + b + 30) (hi (ratio x y)).
Proof.
  intros Hb [Hx Hxl] Wy [Hy Hbig]; destruct (double_word_is_pair _ Wy) as (_ & _ & Hl); pose proof (bpow_gt_0 radix2 (- b)) as Pb.
  pose proof (divided a b _ _ Hb Hx Hy) as Hq; apply below_rnd in Hq; pose proof (proj1 Hx) as Ha.
  assert (Hy0 : hi y <> 0) by (intros Z0; rewrite Z0, Rabs_R0 in Hy; lra).
  assert (Hback : below (a + 2) (hi y * rnd (hi x / hi y))).
  { split; [lia|]; rewrite Rabs_mult; pose proof (rnd_any (hi x / hi y)) as Hr; pose proof u_bounds as Hu.
    set (q := hi x / hi y) in *; assert (Hqx : Rabs (hi y) * Rabs q = Rabs (hi x)).
    { unfold q; rewrite <- Rabs_mult; f_equal; field; exact Hy0. }
    assert (Rabs (rnd q) <= 2 * Rabs q + tiny).
    { pose proof (Rabs_triang_inv (rnd q) q); pose proof (Rabs_pos q).
      assert (u * Rabs q <= 1 * Rabs q) by (apply Rmult_le_compat_r; lra); lra. }
    apply Rle_trans with (Rabs (hi y) * (2 * Rabs q + tiny)); [apply Rmult_le_compat_l; [apply Rabs_pos | assumption]|].
    assert (Rabs (hi y) * tiny <= 1).
    { apply Rle_trans with (bpow radix2 1000 * tiny); [apply Rmult_le_compat_r; [apply bpow_ge_0 | exact Hbig]|].
      rewrite <- bpow_plus; change 1 with (bpow radix2 0); apply bpow_le; lia. }
    assert (1 <= bpow radix2 a) by (change 1 with (bpow radix2 0); now apply bpow_le).
    rewrite bpow_plus; replace (bpow radix2 2) with 4 by reflexivity; destruct Hx as [_ Hx]; lra. }
  assert (Hback2 : below (a + 2) (lo y * rnd (hi x / hi y))).
  { split; [lia|]; rewrite Rabs_mult; apply Rle_trans with (2 := proj2 Hback); rewrite Rabs_mult.
    apply Rmult_le_compat_r; [apply Rabs_pos|]; pose proof u_bounds; pose proof (Rabs_pos (hi y)).
    apply Rle_trans with (1 := Hl); rewrite <- (Rmult_1_l (Rabs (hi y))) at 2; apply Rmult_le_compat_r; lra. }
  unfold ratio; cbv zeta; cbn [hi]; set (first := rnd (hi x / hi y)) in *.
  set (p := hi y * first) in *; set (p' := lo y * first) in *; clearbody p p' first.
  eapply below_more; [apply below_rnd, below_plus; [exact Hq|]; apply below_rnd; apply (divided (a + 28) b); [exact Hb | | exact Hy] | lia].
  plain.
Qed.

Theorem quotient_sized2 a b x x_error y y_error : (0 <= b)%Z -> (a + b <= 970)%Z -> below2 a x -> below a x_error -> 0 <= x_error ->
  double_word y -> Rabs (hi y) <= bpow radix2 1000 -> format y_error -> bpow radix2 (- b) <= y_error -> 2 * y_error < Rabs (hi y) ->
  sized2 (quotient x x_error y y_error).
Proof.
  intros Hb Hab Hx Hxe Hx0 Wy Hbig Fe Hye Hy; pose proof (bpow_gt_0 radix2 (- b)) as Pb; pose proof (proj1 (proj1 Hx)) as Ha.
  assert (Hq : below (a + b + 30) (hi (ratio x y))) by (apply ratio_below; auto; lra).
  unfold sized2, quotient; cbn [Formas.value Formas.error]; split; [apply (below_more _ _ _ Hq); lia|].
  eapply below_more; [apply quotient_error_below with (m := (a + b + 30)%Z); auto; try lia; try lra | lia].
  - apply Hq.
  - apply (below_more _ (a + 30)) in Hxe; [|lia]; replace (a + b + 30)%Z with (a + 30 + b)%Z by ring; now apply between_powers.
Qed.
