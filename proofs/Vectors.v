(** * Vectors: of real numbers, exact and computed, with bounds on what is computed of them

    vec, minus, dot, cross, norm == exact vectors;  extent == the sum of the components' sizes
    plus, scale, magnitudes      == the sum of two, a multiple of one, the magnitudes of the components
    X_fl                         == the same, each operation rounded once, as src/trace/numbers-inl.hpp computes it
    on_grid k a                  == each component is a binary64 and an integer times 2^k
    close n k a x                == each component of a is computed for x's, with at most n roundings *)
From Coq Require Import Reals ZArith Lra Lia Psatz.
From Flocq Require Import Core.
From Durero Require Import Rounding.
Local Open Scope R_scope.
Local Opaque bpow.

Record vec := Vec { cx : R; cy : R; cz : R }.

Definition dot (a b : vec) : R := cx a * cx b + cy a * cy b + cz a * cz b.
Definition cross (a b : vec) : vec :=
  Vec (cy a * cz b - cz a * cy b) (cz a * cx b - cx a * cz b) (cx a * cy b - cy a * cx b).
Definition norm (a : vec) : R := sqrt (dot a a).
Definition extent (a : vec) : R := Rabs (cx a) + Rabs (cy a) + Rabs (cz a).
Definition minus (a b : vec) : vec := Vec (cx a - cx b) (cy a - cy b) (cz a - cz b).
Definition plus (a b : vec) : vec := Vec (cx a + cx b) (cy a + cy b) (cz a + cz b).
Definition scale (s : R) (a : vec) : vec := Vec (s * cx a) (s * cy a) (s * cz a).
Definition magnitudes (a : vec) : vec := Vec (Rabs (cx a)) (Rabs (cy a)) (Rabs (cz a)).

Definition dot_fl (a b : vec) : R := rnd (rnd (rnd (cx a * cx b) + rnd (cy a * cy b)) + rnd (cz a * cz b)).
Definition cross_fl (a b : vec) : vec :=
  Vec (rnd (rnd (cy a * cz b) - rnd (cz a * cy b))) (rnd (rnd (cz a * cx b) - rnd (cx a * cz b)))
    (rnd (rnd (cx a * cy b) - rnd (cy a * cx b))).
Definition norm_fl (a : vec) : R := rnd (sqrt (dot_fl a a)).
Definition extent_fl (a : vec) : R := rnd (rnd (Rabs (cx a) + Rabs (cy a)) + Rabs (cz a)).
Definition minus_fl (a b : vec) : vec := Vec (rnd (cx a - cx b)) (rnd (cy a - cy b)) (rnd (cz a - cz b)).

(** ** Vectors *)

Definition on_grid (k : Z) (a : vec) : Prop :=
  format (cx a) /\ format (cy a) /\ format (cz a) /\ grid k (cx a) /\ grid k (cy a) /\ grid k (cz a).

(** Each component is computed, relative to the exact one's size. *)
Definition close (n : nat) (k : Z) (a x : vec) : Prop :=
  computed n k (cx a) (cx x) (Rabs (cx x)) /\ computed n k (cy a) (cy x) (Rabs (cy x)) /\
  computed n k (cz a) (cz x) (Rabs (cz x)).

Lemma close_exact k a : on_grid k a -> close 0 k a a.
Proof. intros (? & ? & ? & ? & ? & ?); repeat split; try assumption; apply near_exact. Qed.

(** The dot product of the magnitudes. *)
Definition size_of_dot (a b : vec) : R :=
  Rabs (cx a) * Rabs (cx b) + Rabs (cy a) * Rabs (cy b) + Rabs (cz a) * Rabs (cz b).

Lemma dot_computed i j k l a b x y : (-1022 <= k + l)%Z -> close i k a x -> close j l b y ->
  computed (S (S (S (i + j)))) (k + l) (dot_fl a b) (dot x y) (size_of_dot x y).
Proof.
  intros Hk (Ax & Ay & Az) (Bx & By & Bz); apply computed_plus; [assumption | |].
  - apply computed_plus; [assumption | |]; now apply computed_mult.
  - apply (computed_more (S (i + j))); [lia|]; now apply computed_mult.
Qed.

Lemma extent_computed n k a x : (-1022 <= k)%Z -> close n k a x ->
  computed (S (S n)) k (extent_fl a) (extent x) (extent x).
Proof.
  intros Hk (Ax & Ay & Az); apply computed_plus; [assumption | |].
  - apply computed_plus; [assumption | |]; now apply computed_abs.
  - apply (computed_more n); [lia|]; now apply computed_abs.
Qed.

Lemma square_nonneg x : 0 <= x * x.
Proof. exact (Rle_0_sqr x). Qed.
Lemma sum_squares_nonneg x y : 0 <= x * x + y * y.
Proof. apply Rplus_le_le_0_compat; apply square_nonneg. Qed.
Lemma abs_sum_squares x y z : 0 <= x * x + y * y + z * z.
Proof. apply Rplus_le_le_0_compat; [apply sum_squares_nonneg | apply square_nonneg]. Qed.

Lemma norm_nonneg a : 0 <= norm a. Proof. apply sqrt_pos. Qed.
Lemma norm_square a : norm a * norm a = dot a a. Proof. apply sqrt_sqrt, abs_sum_squares. Qed.

Lemma extent_nonneg a : 0 <= extent a.
Proof. unfold extent; pose proof (Rabs_pos (cx a)); pose proof (Rabs_pos (cy a)); pose proof (Rabs_pos (cz a));
  lra. Qed.

(** The norm moves no more than the components do. *)
Lemma norm_lipschitz a b : Rabs (norm a - norm b) <= extent (minus a b).
Proof.
  destruct a as [x y z], b as [x' y' z']; unfold norm, dot, extent, minus; simpl.
  pose proof (sqrt_lipschitz x x' (y * y + z * z) (sum_squares_nonneg y z)) as H1.
  pose proof (sqrt_lipschitz y y' (x' * x' + z * z) (sum_squares_nonneg x' z)) as H2.
  pose proof (sqrt_lipschitz z z' (x' * x' + y' * y') (sum_squares_nonneg x' y')) as H3.
  replace (x * x + (y * y + z * z)) with (x * x + y * y + z * z) in H1 by ring.
  replace (y * y + (x' * x' + z * z)) with (x' * x' + (y * y + z * z)) in H2 by ring.
  replace (y' * y' + (x' * x' + z * z)) with (z * z + (x' * x' + y' * y')) in H2 by ring.
  replace (z' * z' + (x' * x' + y' * y')) with (x' * x' + y' * y' + z' * z') in H3 by ring.
  apply Rabs_le_inv in H1, H2, H3; apply Rabs_le; lra.
Qed.

Lemma norm_le_extent a : norm a <= extent a.
Proof.
  pose proof (norm_lipschitz a (Vec 0 0 0)) as H; unfold norm at 2, dot in H; simpl in H.
  replace (0 * 0 + 0 * 0 + 0 * 0) with 0 in H by ring; rewrite sqrt_0 in H.
  unfold extent, minus in *; simpl in H; rewrite !Rminus_0_r in H; apply Rabs_le_inv in H; lra.
Qed.

Lemma size_of_dot_le a b : size_of_dot a b <= extent a * extent b.
Proof.
  unfold size_of_dot, extent; assert (P : forall x y, 0 <= Rabs x * Rabs y) by (intros; apply Rmult_le_pos; apply Rabs_pos).
  pose proof (P (cx a) (cy b)); pose proof (P (cx a) (cz b)); pose proof (P (cy a) (cx b)); pose proof (P (cy a) (cz b)).
  pose proof (P (cz a) (cx b)); pose proof (P (cz a) (cy b)); lra.
Qed.

(** ** Lengths *)

Lemma square_le a b : 0 <= b -> a * a <= b * b -> a <= b.
Proof. intros Hb H; apply Rnot_lt_le; intros Hlt; pose proof (Rmult_le_0_lt_compat b a b a Hb Hb Hlt Hlt); lra. Qed.

Lemma norm_of_square a m : 0 <= m -> dot a a <= m * m -> norm a <= m.
Proof. intros Hm H; apply square_le; [assumption | now rewrite norm_square]. Qed.

(** Lagrange's identity, for products and their lengths. *)
Lemma cross_and_dot a b : dot (cross a b) (cross a b) + dot a b * dot a b = dot a a * dot b b.
Proof. unfold dot, cross; simpl; ring. Qed.

Lemma norms_square a b : norm a * norm b * (norm a * norm b) = dot a a * dot b b.
Proof. rewrite <- !norm_square; ring. Qed.

Lemma norms_nonneg a b : 0 <= norm a * norm b.
Proof. apply Rmult_le_pos; apply norm_nonneg. Qed.

Lemma dot_le a b : Rabs (dot a b) <= norm a * norm b.
Proof.
  apply square_le; [apply norms_nonneg|]; rewrite norms_square, <- cross_and_dot.
  pose proof (abs_sum_squares (cx (cross a b)) (cy (cross a b)) (cz (cross a b)) : 0 <= dot (cross a b) (cross a b)).
  rewrite <- Rabs_mult, Rabs_pos_eq by apply Rle_0_sqr; lra.
Qed.

Lemma cross_le a b : norm (cross a b) <= norm a * norm b.
Proof.
  apply norm_of_square; [apply norms_nonneg|]; rewrite norms_square, <- cross_and_dot.
  pose proof (Rle_0_sqr (dot a b)) as H; unfold Rsqr in H; lra.
Qed.

Lemma norm_plus a b : norm (plus a b) <= norm a + norm b.
Proof.
  pose proof (norm_nonneg a); pose proof (norm_nonneg b); apply norm_of_square; [lra|].
  pose proof (dot_le a b) as H1; apply Rabs_le_inv in H1.
  replace (dot (plus a b) (plus a b)) with (dot a a + dot b b + 2 * dot a b) by (unfold dot, plus; simpl; ring).
  rewrite <- !norm_square; lra.
Qed.

Lemma norm_scale s a : norm (scale s a) = Rabs s * norm a.
Proof.
  unfold norm; replace (dot (scale s a) (scale s a)) with (s * s * dot a a) by (unfold dot, scale; simpl; ring).
  rewrite sqrt_mult; [|apply Rle_0_sqr | apply abs_sum_squares]; f_equal; apply sqrt_Rsqr_abs.
Qed.

Lemma norm_magnitudes a : norm (magnitudes a) = norm a.
Proof. unfold norm, dot, magnitudes; simpl; f_equal; rewrite <- !Rabs_mult, !Rabs_pos_eq by apply Rle_0_sqr; ring. Qed.

Lemma size_le a b : size_of_dot a b <= norm a * norm b.
Proof.
  rewrite <- (norm_magnitudes a), <- (norm_magnitudes b); apply Rle_trans with (2 := dot_le _ _), Rle_abs.
Qed.

Lemma size_nonneg a b : 0 <= size_of_dot a b.
Proof.
  unfold size_of_dot; pose proof (Rmult_le_pos _ _ (Rabs_pos (cx a)) (Rabs_pos (cx b)));
    pose proof (Rmult_le_pos _ _ (Rabs_pos (cy a)) (Rabs_pos (cy b)));
    pose proof (Rmult_le_pos _ _ (Rabs_pos (cz a)) (Rabs_pos (cz b))); lra.
Qed.

Lemma norm_mono a b : Rabs (cx a) <= cx b -> Rabs (cy a) <= cy b -> Rabs (cz a) <= cz b -> norm a <= norm b.
Proof.
  intros X Y Z; apply sqrt_le_1_alt; unfold dot.
  assert (S : forall s t, Rabs s <= t -> s * s <= t * t).
  { intros s t H; replace (s * s) with (Rabs s * Rabs s) by (rewrite <- Rabs_mult; apply Rabs_pos_eq, Rle_0_sqr).
    apply Rmult_le_compat; auto using Rabs_pos. }
  pose proof (S _ _ X); pose proof (S _ _ Y); pose proof (S _ _ Z); lra.
Qed.

Lemma norm_between a b : norm a <= norm b + norm (minus a b).
Proof.
  replace a with (plus b (minus a b)) at 1 by (destruct a, b; unfold plus, minus; simpl; f_equal; ring).
  apply norm_plus.
Qed.

Lemma norm_symmetric s t : norm (minus s t) = norm (minus t s).
Proof. unfold norm, dot, minus; cbn; f_equal; ring. Qed.

(** ** Lengths as they are computed *)

(** Eight units for a computed length: six for the square's three roundings, one for the root's, one to spare. *)
Lemma norm_computed k a : (-511 <= k)%Z -> on_grid k a ->
  Rabs (norm_fl a - norm a) <= 8 * u * norm a /\ (norm_fl a = 0 \/ bpow radix2 k <= norm_fl a).
Proof.
  intros Hk Ha; pose proof u_bounds; pose proof (norm_nonneg a) as Hn.
  pose proof (dot_computed 0 0 k k a a a a ltac:(lia) (close_exact k a Ha) (close_exact k a Ha)) as Hc.
  replace (size_of_dot a a) with (norm a * norm a) in Hc.
  2: { rewrite norm_square; unfold size_of_dot, dot; rewrite <- !Rabs_mult, !Rabs_pos_eq;
         [reflexivity | apply square_nonneg ..]. }
  pose proof (computed_error 3 _ _ _ _ ltac:(lia) Hc) as He; rewrite <- norm_square in He; simpl INR in He.
  destruct Hc as (_ & _ & HG); unfold norm_fl; set (G := dot_fl a a) in *.
  pose proof (square_nonneg (norm a)) as Hnn.
  assert (Hunn : u * (norm a * norm a) <= / 1000000000000 * (norm a * norm a)) by (apply Rmult_le_compat_r; lra).
  assert (HG0 : 0 <= G) by (apply Rabs_le_inv in He; lra).
  assert (HGk : G = 0 \/ bpow radix2 k * bpow radix2 k <= G).
  { destruct HG as [m Hm]; rewrite <- bpow_plus; destruct (Z_lt_le_dec 0 m) as [Hp|Hp]; [right | left].
    - rewrite Hm; rewrite <- (Rmult_1_l (bpow radix2 (k + k))) at 1.
      apply Rmult_le_compat_r; [apply bpow_ge_0 | apply IZR_le; lia].
    - apply IZR_le in Hp; pose proof (Rmult_le_compat_r _ _ _ (bpow_ge_0 radix2 (k + k)) Hp); lra. }
  assert (Hroot : sqrt G = 0 \/ bpow radix2 k <= sqrt G).
  { destruct HGk as [->|HGk]; [left; apply sqrt_0 | right].
    rewrite <- (sqrt_square (bpow radix2 k)) by apply bpow_ge_0; now apply sqrt_le_1_alt. }
  split.
  - assert (Hd : Rabs (sqrt G - norm a) <= 6 * u * norm a).
    { destruct (Req_dec (norm a) 0) as [Z0|N0].
      - rewrite Z0 in *; assert (G = 0) as -> by (apply Rabs_le_inv in He; lra).
        rewrite sqrt_0, Rminus_0_r, Rabs_R0; lra.
      - rewrite Rabs_minus_sym; unfold norm at 1.
        apply Rle_trans with (1 := sqrt_distance (dot a a) G ltac:(rewrite <- norm_square; apply Rmult_lt_0_compat; lra) HG0).
        fold (norm a); rewrite Rabs_minus_sym, <- norm_square; apply Rmult_le_reg_r with (norm a); [lra|].
        unfold Rdiv; rewrite Rmult_assoc, Rinv_l by lra; lra. }
    assert (Hr : Rabs (rnd (sqrt G) - sqrt G) <= u * Rabs (sqrt G)).
    { apply rnd_rel; destruct Hroot as [->|Hroot]; [now left | right].
      rewrite Rabs_pos_eq by apply sqrt_pos; apply Rle_trans with (2 := Hroot), bpow_le; lia. }
    rewrite (Rabs_pos_eq (sqrt G)) in Hr by apply sqrt_pos.
    apply Rabs_le_inv in Hd, Hr; assert (0 <= u * norm a <= / 1000000000000 * norm a).
    { split; [apply Rmult_le_pos | apply Rmult_le_compat_r]; lra. }
    assert (u * sqrt G <= u * (norm a + 6 * u * norm a)) by (apply Rmult_le_compat_l; lra).
    assert (u * (u * norm a) <= / 1000000000000 * (u * norm a)) by (apply Rmult_le_compat_r; lra).
    apply Rabs_le; lra.
  - destruct Hroot as [->|Hroot]; [left; apply rnd_0 | right].
    replace (bpow radix2 k) with (rnd (bpow radix2 k)); [now apply rnd_le|].
    apply round_generic; [auto with typeclass_instances | apply generic_format_bpow; unfold FLT_exp; lia].
Qed.
