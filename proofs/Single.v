(** * Single: a calculus of error bounds for binary32 that allows for underflow

    fl x            == x rounded once to the nearest binary32 (overflow apart)
    u, eta          == half an ulp of 1, 2^-24; half the least positive binary32, 2^-150
    single x        == x is a binary32
    near n e a x m  == a is computed for x, |x| <= m, with at most n roundings: |a - x| <= ((1 + u)^n - 1) m + e
    fused a b c r   == r is a·b + c, rounded once, or rounded after the product and after the sum *)
From Coq Require Import Reals ZArith Lra Lia Psatz.
From Flocq Require Import Core Relative Plus_error.
Local Open Scope R_scope.

Notation single := (generic_format radix2 (FLT_exp (-149) 24)).
Notation fl := (round radix2 (FLT_exp (-149) 24) ZnearestE).
Notation u := (bpow radix2 (-24)).
Notation eta := (bpow radix2 (-150)).

Definition near (n : nat) (e a x m : R) : Prop := Rabs (a - x) <= ((1 + u) ^ n - 1) * m + e /\ Rabs x <= m /\ 0 <= e.
Definition fused (a b c r : R) : Prop := r = fl (a * b + c) \/ r = fl (fl (a * b) + c).

Local Instance prec24 : Prec_gt_0 24 := eq_refl.

Lemma u_value : u = / 16777216. Proof. reflexivity. Qed.
Lemma eta_bounds : 0 < eta <= / 1000000000000. Proof. split; [apply bpow_gt_0 |]. simpl. lra. Qed.
Lemma half_ulp : / 2 * bpow radix2 (- (24) + 1) = u. Proof. simpl; lra. Qed.
Lemma half_least : / 2 * bpow radix2 (-149) = eta.
Proof. replace (bpow radix2 (-149)) with (2 * eta); [field |]. change 2 with (bpow radix2 1). now rewrite <- bpow_plus. Qed.

Local Opaque bpow.

Lemma single_fl x : single (fl x). Proof. apply generic_format_round; auto with typeclass_instances. Qed.
Lemma single_abs x : single x -> single (Rabs x). Proof. apply generic_format_abs. Qed.
Lemma single_opp x : single x -> single (- x). Proof. apply generic_format_opp. Qed.

Lemma fl_near x : Rabs (fl x - x) <= u * Rabs x + eta.
Proof.
  destruct (error_N_FLT radix2 (-149) 24 eq_refl (fun n => negb (Z.even n)) x) as (e & h & He & Hh & _ & ->).
  rewrite half_ulp in He. rewrite half_least in Hh.
  replace (x * (1 + e) + h - x) with (e * x + h) by ring. apply Rle_trans with (1 := Rabs_triang _ _). rewrite Rabs_mult.
  pose proof (Rmult_le_compat_r (Rabs x) _ _ (Rabs_pos x) He). lra.
Qed.

(** A sum never underflows. *)
Lemma fl_plus x y : single x -> single y -> Rabs (fl (x + y) - (x + y)) <= u * Rabs (x + y).
Proof.
  intros Fx Fy. destruct (FLT_plus_error_N_ex radix2 (-149) 24 (fun n => negb (Z.even n)) x y Fx Fy) as (e & He & ->).
  replace ((x + y) * (1 + e) - (x + y)) with (e * (x + y)) by ring. rewrite Rabs_mult.
  apply Rmult_le_compat_r; [apply Rabs_pos |]. apply Rle_trans with (1 := He). unfold u_ro. rewrite half_ulp.
  assert (0 < u) by apply bpow_gt_0. apply Rmult_le_reg_r with (1 + u); [lra |]. unfold Rdiv.
  rewrite Rmult_assoc, Rinv_l by lra. apply Rmult_le_compat_l; lra.
Qed.

(** ** The calculus *)

Lemma power_at_least n : 1 <= (1 + u) ^ n.
Proof. apply Rle_trans with (1 ^ n); [rewrite pow1; lra |]. apply pow_incr. rewrite u_value. split; lra. Qed.

Lemma power_at_most n : (n <= 12)%nat -> (1 + u) ^ n - 1 <= (INR n + / 100) * u.
Proof. intros H. rewrite u_value. do 13 (destruct n as [| n]; [simpl; lra |]). lia. Qed.

Lemma near_positive n e a x m : near n e a x m -> 0 <= m.
Proof. intros [_ [H _]]. pose proof (Rabs_pos x). lra. Qed.

Lemma near_error n e a x m : (n <= 12)%nat -> near n e a x m -> Rabs (a - x) <= (INR n + / 100) * u * m + e.
Proof.
  intros Hn H. pose proof (near_positive _ _ _ _ _ H) as Hm. destruct H as [H _].
  pose proof (Rmult_le_compat_r m _ _ Hm (power_at_most n Hn)). lra.
Qed.

Lemma near_more n k e f m l a x : near n e a x m -> (n <= k)%nat -> e <= f -> m <= l -> near k f a x l.
Proof.
  intros [H [Hm Hp]] Hk He Hl. split; [| lra]. apply Rle_trans with (1 := H). pose proof (power_at_least n).
  assert (Hpow : (1 + u) ^ n <= (1 + u) ^ k) by (apply Rle_pow; [rewrite u_value; lra | exact Hk]).
  apply Rplus_le_compat; [| exact He]. pose proof (Rabs_pos x). apply Rmult_le_compat; lra.
Qed.

Lemma near_size n e a x m : near n e a x m -> Rabs a <= (1 + u) ^ n * m + e.
Proof.
  intros [H [Hx _]]. replace a with ((a - x) + x) by ring. apply Rle_trans with (1 := Rabs_triang _ _). lra.
Qed.

Lemma near_fl n e a x m : near n e a x m -> near (S n) (2 * e + eta) (fl a) x m.
Proof.
  intros H. pose proof (near_positive _ _ _ _ _ H) as Hm. pose proof (near_size _ _ _ _ _ H) as Ha. destruct H as [H [Hx He]].
  pose proof (fl_near a) as F. pose proof (power_at_least n) as P. pose proof eta_bounds as HE. split; [| lra].
  replace (fl a - x) with ((fl a - a) + (a - x)) by ring. apply Rle_trans with (1 := Rabs_triang _ _).
  apply Rle_trans with ((u * ((1 + u) ^ n * m + e) + eta) + (((1 + u) ^ n - 1) * m + e)).
  - assert (u * Rabs a <= u * ((1 + u) ^ n * m + e)) by (apply Rmult_le_compat_l; [apply bpow_ge_0 | exact Ha]). lra.
  - assert (u * e <= e) by (rewrite u_value; lra). cbn [pow]. lra.
Qed.

Lemma near_exact x : near 0 0 x x (Rabs x).
Proof. split; [| split; apply Rle_refl]. replace (x - x) with 0 by ring. rewrite Rabs_R0. cbn. lra. Qed.

Lemma near_opp n e a x m : near n e a x m -> near n e (- a) (- x) m.
Proof.
  intros [H H']. split; [| now rewrite Rabs_Ropp]. replace (- a - - x) with (- (a - x)) by ring. now rewrite Rabs_Ropp.
Qed.

Lemma near_plus n e f a b x y m l : near n e a x m -> near n f b y l -> near n (e + f) (a + b) (x + y) (m + l).
Proof.
  intros [A [Hx He]] [B [Hy Hf]]. repeat split; [| | lra].
  - replace (a + b - (x + y)) with ((a - x) + (b - y)) by ring. apply Rle_trans with (1 := Rabs_triang _ _). lra.
  - apply Rle_trans with (1 := Rabs_triang _ _). lra.
Qed.

(** The product of an input, which errs by units alone, and of what was computed. *)
Lemma near_mult n k f a b x y m l : near n 0 a x m -> near k f b y l -> (n <= 12)%nat ->
  near (n + k) (2 * m * f) (a * b) (x * y) (m * l).
Proof.
  intros HA HB Hn. pose proof (near_positive _ _ _ _ _ HA) as Hm. pose proof (near_positive _ _ _ _ _ HB) as Hl.
  destruct HA as [A [Hx _]], HB as [B [Hy Hf]]. pose proof (power_at_least n) as Pn. pose proof (power_at_least k) as Pk.
  pose proof (power_at_most n Hn) as Qn. unfold near. rewrite pow_add.
  set (p := (1 + u) ^ n) in *. set (q := (1 + u) ^ k) in *.
  assert (Hp : p <= 2). { assert (INR n <= 12) by (apply (le_INR n 12) in Hn; simpl in Hn; lra). rewrite u_value in Qn. lra. }
  pose proof (Rabs_pos x) as X. pose proof (Rabs_pos y) as Y.
  assert (Hmf : 0 <= m * f) by (now apply Rmult_le_pos).
  repeat split; [| rewrite Rabs_mult; apply Rmult_le_compat; assumption | lra].
  replace (a * b - x * y) with ((a - x) * (b - y) + (a - x) * y + x * (b - y)) by ring.
  apply Rle_trans with (((p - 1) * m) * ((q - 1) * l + f) + ((p - 1) * m) * l + m * ((q - 1) * l + f)).
  - apply Rle_trans with (1 := Rabs_triang _ _). rewrite (Rabs_mult x).
    apply Rplus_le_compat; [apply Rle_trans with (1 := Rabs_triang _ _); rewrite !Rabs_mult; apply Rplus_le_compat |];
      apply Rmult_le_compat; try apply Rabs_pos; lra.
  - assert ((p - 1) * (m * f) <= 1 * (m * f)) by (apply Rmult_le_compat_r; lra). lra.
Qed.

Lemma near_fused n e f a b c r x y m l : near n e (a * b) x m -> near (S n) f c y l -> fused a b c r ->
  near (S (S n)) (4 * (e + f) + 4 * eta) r (x + y) (m + l).
Proof.
  intros A B H. pose proof eta_bounds as HE. pose proof (proj2 (proj2 A)). pose proof (proj2 (proj2 B)).
  destruct H as [-> | ->].
  - apply near_more with (S (S n)) (2 * (e + f) + eta) (m + l); try lra; [| lia]. apply near_fl, near_plus; [| exact B].
    apply near_more with n e m; try lra; [exact A | lia].
  - apply near_more with (S (S n)) (2 * ((2 * e + eta) + f) + eta) (m + l); try lra; [| lia].
    apply near_fl, near_plus; [| exact B]. now apply near_fl.
Qed.

(** ** From below *)

Lemma fl_le x y : x <= y -> fl x <= fl y.
Proof. apply round_le; auto with typeclass_instances. Qed.
Lemma fl_0 : fl 0 = 0.
Proof. apply round_0; auto with typeclass_instances. Qed.
Lemma fl_opp x : fl (- x) = - fl x.
Proof. apply round_NE_opp. Qed.

Lemma fl_low x : 0 <= x -> (1 - u) * x - eta <= fl x.
Proof. intros H. pose proof (fl_near x) as N. rewrite (Rabs_pos_eq x H) in N. apply Rabs_le_inv in N. lra. Qed.

(** Where it does not underflow, it errs by a unit alone. *)
Lemma fl_ordinary x : x = 0 \/ bpow radix2 (-126) <= Rabs x -> Rabs (fl x - x) <= u * Rabs x.
Proof.
  intros [-> | H]; [rewrite fl_0, Rminus_0_r, Rabs_R0; lra |].
  rewrite <- half_ulp. now apply (relative_error_N_FLT radix2 (-149) 24).
Qed.

Lemma fl_below m x : 0 <= m -> - m <= x -> - (m * (1 + u) + eta) <= fl x.
Proof.
  intros Hm H. pose proof (fl_near x) as N. pose proof eta_bounds. apply Rabs_le_inv in N.
  assert (0 < u) by apply bpow_gt_0. assert (0 <= m * (1 + u)) by (apply Rmult_le_pos; lra).
  destruct (Rle_dec 0 x) as [P | P].
  - pose proof (fl_le 0 x P) as L. rewrite fl_0 in L. lra.
  - rewrite (Rabs_left x) in N by lra. assert (u * - x <= u * m) by (apply Rmult_le_compat_l; lra). lra.
Qed.

Lemma sum_low x y : single x -> single y -> 0 <= x -> 0 <= y -> (1 - u) * (x + y) <= fl (x + y).
Proof.
  intros Fx Fy Hx Hy. pose proof (fl_plus x y Fx Fy) as N. rewrite (Rabs_pos_eq (x + y)) in N by lra. apply Rabs_le_inv in N. lra.
Qed.

Lemma fused_low a b c r : 0 <= a * b -> 0 <= c -> fused a b c r -> (1 - 2 * u) * (a * b + c) - 2 * eta <= r.
Proof.
  intros Hab Hc H. pose proof eta_bounds as HE. pose proof u_value as U.
  assert (H0 : 0 <= fl (a * b)) by (rewrite <- fl_0; now apply fl_le).
  destruct H as [-> | ->].
  - apply Rle_trans with (2 := fl_low (a * b + c) ltac:(lra)). rewrite U. lra.
  - apply Rle_trans with (2 := fl_low (fl (a * b) + c) ltac:(lra)). pose proof (fl_low _ Hab).
    assert ((1 - u) * ((1 - u) * (a * b) - eta) <= (1 - u) * fl (a * b)) by (apply Rmult_le_compat_l; [rewrite U; lra | lra]).
    rewrite U in *. lra.
Qed.

(** The product of two lower bounds, which are off by units. *)
Lemma product_low i j x y a b : 0 <= i <= 100 -> 0 <= j <= 100 -> 0 <= x -> 0 <= y -> (1 - i * u) * x <= a ->
  (1 - j * u) * y <= b -> (1 - (i + j) * u) * (x * y) <= a * b.
Proof.
  intros Hi Hj Hx Hy Ha Hb. pose proof u_value as U. assert (Pi : 0 <= 1 - i * u) by (rewrite U; lra).
  assert (Pj : 0 <= 1 - j * u) by (rewrite U; lra).
  apply Rle_trans with (((1 - i * u) * x) * ((1 - j * u) * y)).
  - replace ((1 - i * u) * x * ((1 - j * u) * y)) with ((1 - (i + j) * u + i * u * (j * u)) * (x * y)) by ring.
    apply Rmult_le_compat_r; [now apply Rmult_le_pos |].
    assert (0 <= i * u * (j * u)) by (rewrite U; repeat apply Rmult_le_pos; lra). lra.
  - apply Rmult_le_compat; try assumption; now apply Rmult_le_pos.
Qed.
