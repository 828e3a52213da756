(** * Bundles: the slab test of many rays at once

    Rays that walk a tree together are tested at once, by the ends between which their origins and the inverses of their
    directions lie, all of one sign along an axis: rounding is monotonic, so no entry that is computed so is later, and no
    exit earlier, than that of any of them. The numbers are those of finite operations: where nothing overflows, each is
    the exact result rounded.

    crossed plane p i     == (plane - p) * i, each operation rounded, of real numbers *)
From Coq Require Import Reals ZArith Lra.
From Flocq Require Import Core.
Local Open Scope R_scope.

Section Bundles.
Variables prec emax : Z.
Context (prec_gt_0 : Prec_gt_0 prec).
Notation rnd := (round radix2 (FLT_exp (3 - emax - prec) prec) ZnearestE).

Lemma rnd_le x y : x <= y -> rnd x <= rnd y.
Proof. apply round_le; auto with typeclass_instances. Qed.

Definition crossed (plane p i : R) : R := rnd (rnd (plane - p) * i).

(** What a product loses where one factor does, of the other's sign. *)
Lemma left_le d e i : 0 <= i -> d <= e -> d * i <= e * i.
Proof. intros Hi H; now apply Rmult_le_compat_r. Qed.
Lemma left_ge d e i : i <= 0 -> e <= d -> d * i <= e * i.
Proof. intros Hi H; rewrite !(Rmult_comm _ i); now apply Rmult_le_compat_neg_l. Qed.
Lemma right_le d i j : 0 <= d -> i <= j -> d * i <= d * j.
Proof. intros Hd H; now apply Rmult_le_compat_l. Qed.
Lemma right_ge d i j : d <= 0 -> j <= i -> d * i <= d * j.
Proof. intros Hd H; now apply Rmult_le_compat_neg_l. Qed.

Lemma product_below d e a b i : 0 < a -> a <= i <= b -> d <= e -> Rmin (rnd (d * a)) (rnd (d * b)) <= rnd (e * i).
Proof.
  intros Ha Hi Hd; assert (Hleft : d * i <= e * i) by (apply left_le; lra); destruct (Rle_or_lt 0 d).
  - apply Rle_trans with (1 := Rmin_l _ _), rnd_le, Rle_trans with (2 := Hleft), right_le; lra.
  - apply Rle_trans with (1 := Rmin_r _ _), rnd_le, Rle_trans with (2 := Hleft), right_ge; lra.
Qed.

Lemma product_above d e a b i : 0 < a -> a <= i <= b -> e <= d -> rnd (e * i) <= Rmax (rnd (d * a)) (rnd (d * b)).
Proof.
  intros Ha Hi Hd; assert (Hleft : e * i <= d * i) by (apply left_le; lra); destruct (Rle_or_lt 0 d).
  - apply Rle_trans with (2 := Rmax_r _ _), rnd_le, Rle_trans with (1 := Hleft), right_le; lra.
  - apply Rle_trans with (2 := Rmax_l _ _), rnd_le, Rle_trans with (1 := Hleft), right_ge; lra.
Qed.

Lemma product_below_backwards d e a b i : b < 0 -> a <= i <= b -> e <= d ->
  Rmin (rnd (d * a)) (rnd (d * b)) <= rnd (e * i).
Proof.
  intros Hb Hi Hd; assert (Hleft : d * i <= e * i) by (apply left_ge; lra); destruct (Rle_or_lt 0 d).
  - apply Rle_trans with (1 := Rmin_l _ _), rnd_le, Rle_trans with (2 := Hleft), right_le; lra.
  - apply Rle_trans with (1 := Rmin_r _ _), rnd_le, Rle_trans with (2 := Hleft), right_ge; lra.
Qed.

Lemma product_above_backwards d e a b i : b < 0 -> a <= i <= b -> d <= e ->
  rnd (e * i) <= Rmax (rnd (d * a)) (rnd (d * b)).
Proof.
  intros Hb Hi Hd; assert (Hleft : e * i <= d * i) by (apply left_ge; lra); destruct (Rle_or_lt 0 d).
  - apply Rle_trans with (2 := Rmax_r _ _), rnd_le, Rle_trans with (1 := Hleft), right_le; lra.
  - apply Rle_trans with (2 := Rmax_l _ _), rnd_le, Rle_trans with (1 := Hleft), right_ge; lra.
Qed.

(** Along an axis: origins between p0 and p1, inverses between a and b. *)
Theorem bundle_entry plane p0 p1 a b p i : p0 <= p <= p1 -> a <= i <= b ->
  (0 < a -> Rmin (crossed plane p1 a) (crossed plane p1 b) <= crossed plane p i) /\
  (b < 0 -> Rmin (crossed plane p0 a) (crossed plane p0 b) <= crossed plane p i).
Proof.
  intros Hp Hi; split; intros Hs.
  - apply product_below; [assumption.. | apply rnd_le; lra].
  - apply product_below_backwards; [assumption.. | apply rnd_le; lra].
Qed.

Theorem bundle_exit plane p0 p1 a b p i : p0 <= p <= p1 -> a <= i <= b ->
  (0 < a -> crossed plane p i <= Rmax (crossed plane p0 a) (crossed plane p0 b)) /\
  (b < 0 -> crossed plane p i <= Rmax (crossed plane p1 a) (crossed plane p1 b)).
Proof.
  intros Hp Hi; split; intros Hs.
  - apply product_above; [assumption.. | apply rnd_le; lra].
  - apply product_above_backwards; [assumption.. | apply rnd_le; lra].
Qed.

(** And the comparison: what passes with a later entry and an earlier exit passes. *)
Theorem bundle_visit entry0 entry1 exit0 exit1 g n : entry0 <= entry1 -> exit1 <= exit0 -> 0 <= g ->
  entry1 <= rnd (rnd (exit1 * g) + n) -> entry0 <= rnd (rnd (exit0 * g) + n).
Proof.
  intros He Hx Hg H; apply Rle_trans with (1 := He), Rle_trans with (1 := H), rnd_le, Rplus_le_compat_r, rnd_le.
  now apply Rmult_le_compat_r.
Qed.
End Bundles.
