(** * Rounding: a calculus of error bounds for binary64 sums, products, quotients and roots

    rnd x           == x rounded once to the nearest binary64 (overflow apart)
    u               == half an ulp of 1, 2^-53
    normal x        == x is 0 or at least the least normal number: its rounding does not underflow
    grid k x        == x is an integer times 2^k: so is what is computed from such numbers, and 0 or at least 2^k
    near n a x m    == a is computed for x, |x| <= m, with at most n roundings: |a - x| <= ((1 + u)^n - 1) m *)
From Coq Require Import Reals ZArith Lra Lia Psatz.
From Flocq Require Import Core Relative Plus_error Mult_error.
Local Open Scope R_scope.

Notation fexp := (FLT_exp (-1074) 53).
Notation rnd := (round radix2 fexp ZnearestE).
Notation format := (generic_format radix2 fexp).
Notation u := (bpow radix2 (-53)).
Notation tiny := (bpow radix2 (-1074)). (* the least positive binary64 *)

Definition normal (x : R) : Prop := x = 0 \/ bpow radix2 (-1022) <= Rabs x.
Definition grid (k : Z) (x : R) : Prop := exists n : Z, x = IZR n * bpow radix2 k.
Definition near (n : nat) (a x m : R) : Prop := Rabs (a - x) <= ((1 + u) ^ n - 1) * m /\ Rabs x <= m.

Lemma u_bounds : 0 < u <= / 1000000000000.
Proof. split; [apply bpow_gt_0 | simpl; lra]. Qed.

Local Instance prec53 : Prec_gt_0 53 := eq_refl.

Lemma format_rnd x : format (rnd x).
Proof. apply generic_format_round; auto with typeclass_instances. Qed.

Lemma rnd_le x y : x <= y -> rnd x <= rnd y.
Proof. apply round_le; auto with typeclass_instances. Qed.

Lemma rnd_0 : rnd 0 = 0.
Proof. apply round_0; auto with typeclass_instances. Qed.

Lemma half_ulp : / 2 * bpow radix2 (- (53) + 1) = u.
Proof. simpl; lra. Qed.

Local Opaque bpow.

Lemma rnd_rel x : normal x -> Rabs (rnd x - x) <= u * Rabs x.
Proof.
  intros [->|Hx]; [rewrite rnd_0, Rminus_0_r, Rabs_R0; lra|].
  rewrite <- half_ulp; now apply (relative_error_N_FLT radix2 (-1074) 53).
Qed.

(** A sum never underflows. *)
Lemma rnd_plus x y : format x -> format y -> Rabs (rnd (x + y) - (x + y)) <= u * Rabs (x + y).
Proof.
  intros Fx Fy; destruct (FLT_plus_error_N_ex radix2 (-1074) 53 (fun n => negb (Z.even n)) x y Fx Fy) as (e & He & ->).
  replace ((x + y) * (1 + e) - (x + y)) with (e * (x + y)) by ring; rewrite Rabs_mult.
  apply Rmult_le_compat_r; [apply Rabs_pos|]; apply Rle_trans with (1 := He).
  unfold u_ro; rewrite half_ulp; pose proof u_bounds.
  apply Rmult_le_reg_r with (1 + u); [lra|]; unfold Rdiv; rewrite Rmult_assoc, Rinv_l by lra; apply Rmult_le_compat_l; lra.
Qed.

(** ** Grids: what is computed from multiples of 2^k does not underflow *)

Lemma grid_mult j k x y : grid j x -> grid k y -> grid (j + k) (x * y).
Proof. intros [m ->] [n ->]; exists (m * n)%Z; rewrite mult_IZR, bpow_plus; ring. Qed.

Lemma grid_plus k x y : grid k x -> grid k y -> grid k (x + y).
Proof. intros [m ->] [n ->]; exists (m + n)%Z; rewrite plus_IZR; ring. Qed.

Lemma grid_opp k x : grid k x -> grid k (- x).
Proof. intros [m ->]; exists (- m)%Z; rewrite opp_IZR; ring. Qed.

Lemma grid_abs k x : grid k x -> grid k (Rabs x).
Proof. intros Hx; unfold Rabs; destruct Rcase_abs; [now apply grid_opp | assumption]. Qed.

Lemma grid_coarser j k x : (j <= k)%Z -> grid k x -> grid j x.
Proof.
  intros H [m ->]; exists (m * 2 ^ (k - j))%Z; rewrite mult_IZR, (IZR_Zpower radix2) by lia.
  rewrite Rmult_assoc, <- bpow_plus; do 2 f_equal; ring.
Qed.

Lemma grid_rnd k x : (-1074 <= k)%Z -> grid k x -> grid k (rnd x).
Proof.
  intros Hk [m Hx]; destruct (Z_le_gt_dec (cexp radix2 fexp x) k) as [Hc|Hc].
  - rewrite round_generic; [now exists m | auto with typeclass_instances|].
    rewrite Hx; apply (generic_format_F2R radix2 fexp m k); intros _; unfold F2R; simpl; now rewrite <- Hx.
  - apply (grid_coarser k (cexp radix2 fexp x)); [lia|].
    exists (ZnearestE (scaled_mantissa radix2 fexp x)); reflexivity.
Qed.

Lemma grid_normal k x : (-1022 <= k)%Z -> grid k x -> normal x.
Proof.
  intros Hk [m ->]; destruct (Z.eq_dec m 0) as [->|Hm]; [left; ring | right].
  rewrite Rabs_mult, (Rabs_pos_eq (bpow _ _)) by apply bpow_ge_0.
  apply Rle_trans with (1 * bpow radix2 k); [rewrite Rmult_1_l; now apply bpow_le|].
  apply Rmult_le_compat_r; [apply bpow_ge_0|]; rewrite <- abs_IZR; apply IZR_le; lia.
Qed.

(** ** Counting roundings *)

(** The powers of two that are a few u. *)
Lemma multiples_of_u : bpow radix2 (-52) = 2 * u /\ bpow radix2 (-51) = 4 * u /\ bpow radix2 (-50) = 8 * u /\
  bpow radix2 (-49) = 16 * u /\ bpow radix2 (-47) = 64 * u.
Proof.
  assert (H : forall k e, (e + -53 = k)%Z -> bpow radix2 k = bpow radix2 e * u) by (intros k e <-; apply bpow_plus).
  repeat split; [apply (H _ 1%Z) | apply (H _ 2%Z) | apply (H _ 3%Z) | apply (H _ 4%Z) | apply (H _ 6%Z)]; reflexivity.
Qed.

Lemma pow_ge_1 n : 1 <= (1 + u) ^ n.
Proof. apply pow_R1_Rle; pose proof u_bounds; lra. Qed.

Lemma pow_bound n : (n <= 64)%nat -> (1 + u) ^ n - 1 <= 2 * INR n * u.
Proof.
  pose proof u_bounds; induction n as [|n IH]; intros Hn; [simpl; lra|].
  rewrite S_INR; simpl pow; specialize (IH ltac:(lia)); assert (0 <= INR n <= 64).
  { split; [apply pos_INR | replace 64 with (INR 64) by (simpl; lra); apply le_INR; lia]. }
  assert (INR n * u <= 64 * / 1000000) by (apply Rmult_le_compat; lra).
  assert (2 * (INR n * u) * u <= 1 * u) by (apply Rmult_le_compat_r; lra).
  assert ((1 + u) * (1 + u) ^ n <= (1 + u) * (1 + 2 * INR n * u)) by (apply Rmult_le_compat_l; lra); lra.
Qed.

Lemma near_exact x : near 0 x x (Rabs x).
Proof. unfold near; simpl; rewrite Rminus_diag_eq, Rabs_R0 by reflexivity; split; [lra | apply Rle_refl]. Qed.

Lemma near_more n n' a x m : (n <= n')%nat -> near n a x m -> near n' a x m.
Proof.
  intros Hn [H Hm]; split; [|assumption]; apply Rle_trans with (1 := H); apply Rmult_le_compat_r.
  - apply Rle_trans with (2 := Hm), Rabs_pos.
  - pose proof u_bounds; assert ((1 + u) ^ n <= (1 + u) ^ n') by (apply Rle_pow; lra || lia); lra.
Qed.

Lemma near_size n a x m : near n a x m -> Rabs a <= (1 + u) ^ n * m.
Proof.
  intros [H Hm]; replace a with ((a - x) + x) by ring; apply Rle_trans with (1 := Rabs_triang _ _); lra.
Qed.

(** One more rounding of a computed value. *)
Lemma near_round n a x m : near n a x m -> Rabs (rnd a - a) <= u * Rabs a -> near (S n) (rnd a) x m.
Proof.
  intros Hn Hr; pose proof (near_size _ _ _ _ Hn) as Hs; destruct Hn as [H Hm]; split; [|assumption].
  replace (rnd a - x) with ((rnd a - a) + (a - x)) by ring; apply Rle_trans with (1 := Rabs_triang _ _).
  pose proof u_bounds; assert (u * Rabs a <= u * ((1 + u) ^ n * m)) by (apply Rmult_le_compat_l; lra); simpl pow; lra.
Qed.

Lemma near_mult j k a b x y m l : near j a x m -> near k b y l -> normal (a * b) ->
  near (S (j + k)) (rnd (a * b)) (x * y) (m * l).
Proof.
  intros Ha Hb Hn; apply near_round; [|now apply rnd_rel].
  pose proof (near_size _ _ _ _ Hb) as Hbs; destruct Ha as [Ha Hm], Hb as [Hb Hl]; split.
  - replace (a * b - x * y) with ((a - x) * b + x * (b - y)) by ring; apply Rle_trans with (1 := Rabs_triang _ _).
    rewrite !Rabs_mult, pow_add; pose proof (pow_ge_1 j); pose proof (pow_ge_1 k).
    pose proof (Rabs_pos x); pose proof (Rabs_pos y).
    assert (Rabs (a - x) * Rabs b <= ((1 + u) ^ j - 1) * m * ((1 + u) ^ k * l))
      by (apply Rmult_le_compat; auto using Rabs_pos).
    assert (Rabs x * Rabs (b - y) <= m * (((1 + u) ^ k - 1) * l)) by (apply Rmult_le_compat; auto using Rabs_pos).
    lra.
  - rewrite Rabs_mult; apply Rmult_le_compat; auto using Rabs_pos.
Qed.

Lemma near_plus n a b x y m l : near n a x m -> near n b y l -> format a -> format b ->
  near (S n) (rnd (a + b)) (x + y) (m + l).
Proof.
  intros [Ha Hm] [Hb Hl] Fa Fb; apply near_round; [|now apply rnd_plus]; split.
  - replace (a + b - (x + y)) with ((a - x) + (b - y)) by ring; apply Rle_trans with (1 := Rabs_triang _ _); lra.
  - apply Rle_trans with (1 := Rabs_triang _ _); lra.
Qed.

Lemma near_opp n a x m : near n a x m -> near n (- a) (- x) m.
Proof.
  intros [H Hm]; split; [|now rewrite Rabs_Ropp].
  replace (- a - - x) with (- (a - x)) by ring; now rewrite Rabs_Ropp.
Qed.

Lemma near_abs n a x m : near n a x m -> near n (Rabs a) (Rabs x) m.
Proof. intros [H Hm]; split; [apply Rle_trans with (2 := H), Rabs_triang_inv2 | now rewrite Rabs_Rabsolu]. Qed.

(** ** Roots *)

Lemma sqrt_distance a b : 0 < a -> 0 <= b -> Rabs (sqrt a - sqrt b) <= Rabs (a - b) / sqrt a.
Proof.
  intros Ha Hb; pose proof (sqrt_lt_R0 a Ha); pose proof (sqrt_pos b).
  apply Rmult_le_reg_r with (sqrt a); [assumption|]; unfold Rdiv; rewrite Rmult_assoc, Rinv_l, Rmult_1_r by lra.
  rewrite <- (Rabs_pos_eq (sqrt a)) at 2 by lra; rewrite <- Rabs_mult.
  rewrite <- (sqrt_sqrt a) at 3 by lra; rewrite <- (sqrt_sqrt b) at 2 by lra.
  replace (sqrt a * sqrt a - sqrt b * sqrt b) with ((sqrt a - sqrt b) * (sqrt a + sqrt b)) by ring.
  rewrite !Rabs_mult; apply Rmult_le_compat_l; [apply Rabs_pos|]; rewrite !Rabs_pos_eq; lra.
Qed.

(** sqrt (x² + b) moves no more than x. *)
Lemma sqrt_lipschitz x y b : 0 <= b -> Rabs (sqrt (x * x + b) - sqrt (y * y + b)) <= Rabs (x - y).
Proof.
  intros Hb.
  assert (Hone : forall x y, sqrt (x * x + b) <= Rabs (x - y) + sqrt (y * y + b)).
  { clear x y; intros x y; pose proof (Rabs_pos (x - y)); pose proof (sqrt_pos (y * y + b)).
    rewrite <- (sqrt_square (Rabs (x - y) + sqrt (y * y + b))) by lra; apply sqrt_le_1_alt.
    assert (Hs : sqrt (y * y + b) * sqrt (y * y + b) = y * y + b) by (apply sqrt_sqrt, Rplus_le_le_0_compat; [apply Rle_0_sqr | exact Hb]).
    assert (Hy : Rabs y <= sqrt (y * y + b)).
    { rewrite <- (sqrt_square (Rabs y)) by apply Rabs_pos; apply sqrt_le_1_alt.
      rewrite <- Rabs_mult, Rabs_pos_eq by apply Rle_0_sqr; lra. }
    assert (Rabs (x - y) * Rabs (x - y) = (x - y) * (x - y)) by (rewrite <- Rabs_mult; apply Rabs_pos_eq, Rle_0_sqr).
    assert ((x - y) * y <= Rabs (x - y) * Rabs y) by (rewrite <- Rabs_mult; apply Rle_abs).
    assert (Rabs (x - y) * Rabs y <= Rabs (x - y) * sqrt (y * y + b)) by (apply Rmult_le_compat_l; lra); lra. }
  pose proof (Hone x y); pose proof (Hone y x) as Hyx; rewrite (Rabs_minus_sym y x) in Hyx; apply Rabs_le; lra.
Qed.

(** ** Everything at once: a computed value is near an exact one, is a binary64 and lies on a grid *)

Definition computed (n : nat) (k : Z) (a x m : R) : Prop := near n a x m /\ format a /\ grid k a.

Lemma computed_exact k x : format x -> grid k x -> computed 0 k x x (Rabs x).
Proof. intros; split; [apply near_exact | now split]. Qed.

Lemma computed_more n n' k a x m : (n <= n')%nat -> computed n k a x m -> computed n' k a x m.
Proof. intros Hn (H & F & G); split; [now apply (near_more n) | now split]. Qed.

Lemma computed_mult i j k l a b x y m m' : (-1022 <= k + l)%Z -> computed i k a x m -> computed j l b y m' ->
  computed (S (i + j)) (k + l) (rnd (a * b)) (x * y) (m * m').
Proof.
  intros Hk (Ha & Fa & Ga) (Hb & Fb & Gb); pose proof (grid_mult _ _ _ _ Ga Gb) as G; split; [|split].
  - apply near_mult; auto; now apply (grid_normal (k + l)).
  - apply format_rnd.
  - apply grid_rnd; [lia | assumption].
Qed.

Lemma computed_plus n k a b x y m m' : (-1022 <= k)%Z -> computed n k a x m -> computed n k b y m' ->
  computed (S n) k (rnd (a + b)) (x + y) (m + m').
Proof.
  intros Hk (Ha & Fa & Ga) (Hb & Fb & Gb); split; [now apply near_plus | split; [apply format_rnd|]].
  apply grid_rnd; [lia | now apply grid_plus].
Qed.

Lemma computed_opp n k a x m : computed n k a x m -> computed n k (- a) (- x) m.
Proof. intros (H & F & G); split; [now apply near_opp | split;
  [now apply generic_format_opp | now apply grid_opp]]. Qed.

Lemma computed_minus n k a b x y m m' : (-1022 <= k)%Z -> computed n k a x m -> computed n k b y m' ->
  computed (S n) k (rnd (a - b)) (x - y) (m + m').
Proof. intros Hk Ha Hb; now apply computed_plus, computed_opp. Qed.

Lemma computed_abs n k a x m : computed n k a x m -> computed n k (Rabs a) (Rabs x) m.
Proof. intros (H & F & G); split; [now apply near_abs | split;
  [now apply generic_format_abs | now apply grid_abs]]. Qed.

(** One subtraction of inputs, relative to its result. *)
Lemma computed_difference k a b : (-1022 <= k)%Z -> format a -> format b -> grid k a -> grid k b ->
  computed 1 k (rnd (a - b)) (a - b) (Rabs (a - b)).
Proof.
  intros Hk Fa Fb Ga Gb; split; [|split; [apply format_rnd | apply grid_rnd; [lia | now apply grid_plus, grid_opp]]].
  apply near_round; [apply near_exact | now apply rnd_plus, generic_format_opp].
Qed.

Lemma computed_error n k a x m : (n <= 64)%nat -> computed n k a x m -> Rabs (a - x) <= 2 * INR n * u * m.
Proof.
  intros Hn ((H & Hm) & _); apply Rle_trans with (1 := H); apply Rmult_le_compat_r; [|now apply pow_bound].
  apply Rle_trans with (2 := Hm), Rabs_pos.
Qed.

Lemma computed_size n k a x m : (n <= 64)%nat -> computed n k a x m -> Rabs a <= 2 * m.
Proof.
  intros Hn (H & _); pose proof (near_size _ _ _ _ H) as Hs; destruct H as [_ Hm].
  pose proof (pow_bound n Hn) as Hp; pose proof u_bounds; assert (INR n <= 64).
  { replace 64 with (INR 64) by (simpl; lra); now apply le_INR. }
  assert (INR n * u <= 64 * / 1000000000000) by (apply Rmult_le_compat; lra || apply pos_INR).
  apply Rle_trans with (1 := Hs), Rmult_le_compat_r; [apply Rle_trans with (2 := Hm), Rabs_pos | lra].
Qed.

(** A binary64 that is not small lies on a grid. *)
Lemma format_grid k x : (-1022 <= k)%Z -> format x -> x = 0 \/ bpow radix2 k <= Rabs x -> grid (k - 52) x.
Proof.
  intros Hk F [->|Hx]; [exists 0%Z; ring|].
  apply (grid_coarser _ (cexp radix2 fexp x)).
  - unfold cexp, FLT_exp; pose proof (mag_ge_bpow radix2 x (k + 1)) as Hm.
    replace (k + 1 - 1)%Z with k in Hm by ring; specialize (Hm Hx); lia.
  - exists (Ztrunc (scaled_mantissa radix2 fexp x)); exact F.
Qed.

(** ** Sizes: how small, and how large, what is computed can be *)

Lemma rnd_format x : format x -> rnd x = x.
Proof. intros; apply round_generic; auto with typeclass_instances. Qed.

Lemma format_bpow e : (-1074 <= e)%Z -> format (bpow radix2 e).
Proof. intros He; apply generic_format_bpow; unfold FLT_exp; lia. Qed.

Lemma rnd_ge_bpow e x : (-1074 <= e)%Z -> bpow radix2 e <= x -> bpow radix2 e <= rnd x.
Proof. intros He Hx; rewrite <- (rnd_format _ (format_bpow e He)); now apply rnd_le. Qed.

Lemma rnd_nonneg x : 0 <= x -> 0 <= rnd x.
Proof. intros; rewrite <- rnd_0; now apply rnd_le. Qed.

Lemma at_least_normal e x : (-1022 <= e)%Z -> bpow radix2 e <= Rabs x -> normal x.
Proof. intros He Hx; right; apply Rle_trans with (2 := Hx); now apply bpow_le. Qed.

Lemma grid_at_least k x : grid k x -> x <> 0 -> bpow radix2 k <= Rabs x.
Proof.
  intros [m ->] H; rewrite Rabs_mult, (Rabs_pos_eq (bpow _ _)) by apply bpow_ge_0.
  rewrite <- (Rmult_1_l (bpow radix2 k)) at 1; apply Rmult_le_compat_r; [apply bpow_ge_0|].
  rewrite <- abs_IZR; apply IZR_le; enough (m <> 0)%Z by lia; intros ->; apply H; ring.
Qed.

(** Whatever underflows: the least of all binary64 is added. *)
Lemma rnd_any x : Rabs (rnd x - x) <= u * Rabs x + bpow radix2 (-1074).
Proof.
  destruct (error_N_FLT radix2 (-1074) 53 eq_refl (fun n => negb (Z.even n)) x) as (e & d & He & Hd & _ & ->).
  replace (x * (1 + e) + d - x) with (e * x + d) by ring; apply Rle_trans with (1 := Rabs_triang _ _).
  apply Rplus_le_compat.
  - rewrite Rabs_mult; apply Rmult_le_compat_r; [apply Rabs_pos|]; apply Rle_trans with (1 := He).
    rewrite half_ulp; lra.
  - apply Rle_trans with (1 := Hd); pose proof (bpow_gt_0 radix2 (-1074)); lra.
Qed.

(** Doubling is exact. *)
Lemma rnd_double x : format x -> rnd (2 * x) = 2 * x.
Proof.
  intros Fx; apply rnd_format; replace (2 * x) with (x * bpow radix2 1) by (replace (bpow radix2 1) with 2 by
    reflexivity; ring).
  now apply mult_bpow_pos_exact_FLT.
Qed.

(** ** Counting roundings, without the factor of two *)

Lemma pow_bound_near n : (n <= 64)%nat -> (1 + u) ^ n - 1 <= 1001 / 1000 * INR n * u.
Proof.
  pose proof u_bounds; induction n as [|n IH]; intros Hn; [simpl; lra|].
  rewrite S_INR; simpl pow; specialize (IH ltac:(lia)); assert (0 <= INR n <= 64).
  { split; [apply pos_INR | replace 64 with (INR 64) by (simpl; lra); apply le_INR; lia]. }
  assert (INR n * u <= 64 * / 1000000000000) by (apply Rmult_le_compat; lra).
  assert (1001 / 1000 * (INR n * u) * u <= / 1000 * u) by (apply Rmult_le_compat_r; lra).
  assert ((1 + u) * (1 + u) ^ n <= (1 + u) * (1 + 1001 / 1000 * INR n * u)) by (apply Rmult_le_compat_l; lra); lra.
Qed.

Lemma computed_error_near n k a x m : (n <= 64)%nat -> computed n k a x m -> Rabs (a - x) <= 1001 / 1000 * INR n * u * m.
Proof.
  intros Hn ((H & Hm) & _); apply Rle_trans with (1 := H); apply Rmult_le_compat_r; [|now apply pow_bound_near].
  apply Rle_trans with (2 := Hm), Rabs_pos.
Qed.

Lemma computed_coarser n j k a x m : (j <= k)%Z -> computed n k a x m -> computed n j a x m.
Proof. intros Hj (N & F & G); split; [exact N | split; [exact F | now apply (grid_coarser j k)]]. Qed.
