(** * Nearest: the binary64 that is nearest to (x + y√a)/w, by integers only

    What is printed of a number is its value rounded once; here that rounding is a function over integers, proved to be
    Flocq's, and extracted: the bits of an answer are compared with it. A number is cut to an integer times a power of
    two with 54 bits or more, and with what is lost known to be nothing, below a half, a half, or above; Flocq's own
    rounding of such does the rest, with underflow and overflow.

    guess, place         == hints: a root of an integer, and an exponent to cut at. They are checked, and change no result
    root guess n         == ⌊√n⌋
    root_times guess c r == ⌊c·√r⌋
    magnitude x          == |x|;  over_power x e == x/2^e
    mantissa guess x     == ⌊x⌋, for x >= 0;  rest x m == where x lies between m and m + 1
    cut guess place x    == the mantissa and the exponent that x is cut to
    nearest guess place x == the nearest binary64 to x, ties to even;  bits f == its 64 bits *)
From Coq Require Import ZArith Reals Bool Lra Lia.
From Flocq Require Import Core Bracket BinarySingleNaN.
From Flocq Require Binary Bits.
From Durero Require Import Surd Limits.
Local Open Scope Z_scope.

Definition root (guess : Z -> Z) (n : Z) : Z :=
  let s := guess n in if (0 <=? s) && (s * s <=? n) && (n <? (s + 1) * (s + 1)) then s else Z.sqrt n.

Definition root_times (guess : Z -> Z) (c r : Z) : Z :=
  let n := c * c * r in
  let s := root guess n in
  if 0 <=? c then s else if s * s =? n then - s else - s - 1.

Definition negative (x : surd) : bool := sign1 (num x) (coef x) (rad x) <? 0.
Definition magnitude (x : surd) : surd :=
  if negative x then Surd (- num x) (- coef x) (rad x) (den x) else x.

Definition over_power (x : surd) (e : Z) : surd :=
  if 0 <=? e then Surd (num x) (coef x) (rad x) (Z.shiftl (den x) e)
  else Surd (Z.shiftl (num x) (- e)) (Z.shiftl (coef x) (- e)) (rad x) (den x).

Definition mantissa (guess : Z -> Z) (x : surd) : Z := (num x + root_times guess (coef x) (rad x)) / den x.

Definition rest (x : surd) (m : Z) : location :=
  if sign1 (num x - den x * m) (coef x) (rad x) =? 0 then loc_Exact
  else loc_Inexact (sign1 (2 * num x - den x * (2 * m + 1)) (2 * coef x) (rad x) ?= 0).

Definition cut (guess : Z -> Z) (place : Z) (x : surd) : Z * Z :=
  let m := mantissa guess (over_power x place) in
  if 2 ^ 53 <=? m then (m, place) else (mantissa guess (over_power x (-1074)), -1074).

Definition nearest (guess : Z -> Z) (place : Z) (x : surd) : binary64 :=
  if sign1 (num x) (coef x) (rad x) =? 0 then B754_zero false
  else
    let y := magnitude x in
    let (m, e) := cut guess place y in
    let z := binary_round_aux 53 1024 mode_NE (negative x) m e (rest (over_power y e) m) in
    match Sumbool.sumbool_of_bool (SpecFloat.valid_binary 53 1024 z) with left H => SF2B z H | right _ => B754_nan end.

Definition bits (f : binary64) : Z := Bits.bits_of_b64 (Binary.BSN2B 53 1024 Bits.default_nan_pl64 f).

(** ** The integer below a root *)

Lemma root_bounds guess n : 0 <= n -> 0 <= root guess n /\ root guess n * root guess n <= n < (root guess n + 1) * (root guess n + 1).
Proof.
  intros Hn; unfold root; set (s := guess n); destruct (0 <=? s) eqn:E1, (s * s <=? n) eqn:E2, (n <? (s + 1) * (s + 1)) eqn:E3;
    cbn [andb]; try (rewrite Z.leb_le in E1; rewrite Z.leb_le in E2; rewrite Z.ltb_lt in E3; lia);
    (split; [apply Z.sqrt_nonneg | pose proof (Z.sqrt_spec n Hn); unfold Z.succ in *; lia]).
Qed.

Local Open Scope R_scope.

Lemma sqrt_between n s : (0 <= s)%Z -> (s * s <= n < (s + 1) * (s + 1))%Z -> IZR s <= sqrt (IZR n) < IZR s + 1.
Proof.
  intros Hs [Hl Hu]; apply IZR_le in Hs, Hl; apply IZR_lt in Hu; rewrite !mult_IZR, ?plus_IZR in *; split.
  - rewrite <- (R_sqrt.sqrt_square (IZR s)) by assumption; now apply sqrt_le_1_alt.
  - rewrite <- (R_sqrt.sqrt_square (IZR s + 1)) by lra; apply sqrt_lt_1_alt; split; [|exact Hu].
    apply Rle_trans with (2 := Hl), Rle_0_sqr.
Qed.

Lemma coefficient_in_root c r : (0 <= r)%Z -> Rabs (IZR c) * sqrt (IZR r) = sqrt (IZR (c * c * r)).
Proof.
  intros Hr; apply IZR_le in Hr; rewrite !mult_IZR, sqrt_mult; [|apply Rle_0_sqr | assumption].
  now rewrite <- (sqrt_Rsqr_abs (IZR c)).
Qed.

Lemma root_times_bounds guess c r : (0 <= r)%Z ->
  IZR (root_times guess c r) <= IZR c * sqrt (IZR r) < IZR (root_times guess c r) + 1.
Proof.
  intros Hr; unfold root_times; set (n := (c * c * r)%Z); set (s := root guess n).
  assert (Hn : (0 <= n)%Z) by (apply Z.mul_nonneg_nonneg; [apply Z.square_nonneg | assumption]).
  destruct (root_bounds guess n Hn) as [Hs Hb]; pose proof (sqrt_between n s Hs Hb) as Hroot.
  pose proof (coefficient_in_root c r Hr) as Hc; fold n in Hc.
  destruct (Z.leb_spec 0 c) as [Hp|Hneg].
  - rewrite Rabs_pos_eq in Hc by (now apply IZR_le); lra.
  - rewrite Rabs_left in Hc by (now apply IZR_lt).
    destruct (Z.eqb_spec (s * s) n) as [He|He].
    + rewrite <- He, mult_IZR, R_sqrt.sqrt_square in Hc by (now apply IZR_le); rewrite opp_IZR; lra.
    + assert (IZR s <> sqrt (IZR n)).
      { intros E; apply He, eq_IZR; rewrite mult_IZR, E; apply sqrt_sqrt; now apply IZR_le. }
      rewrite minus_IZR, opp_IZR; lra.
Qed.

(** ** Cutting a number to an integer *)

Lemma mantissa_bounds guess x : valid x -> IZR (mantissa guess x) <= val x < IZR (mantissa guess x) + 1.
Proof.
  intros Hx; pose proof (den_pos x Hx) as Hd; pose proof (val_den x Hx) as Hv.
  pose proof (root_times_bounds guess (coef x) (rad x) (proj1 Hx)) as Hr; unfold mantissa.
  set (s := root_times guess (coef x) (rad x)) in *; set (m := ((num x + s) / den x)%Z).
  assert (Hm : (den x * m <= num x + s < den x * (m + 1))%Z).
  { unfold m; pose proof (Z.mul_div_le (num x + s) (den x) (proj2 Hx)).
    pose proof (Z.mul_succ_div_gt (num x + s) (den x) (proj2 Hx)); unfold Z.succ in *; lia. }
  destruct Hm as [Hl Hu]; assert (Hu' : (num x + s + 1 <= den x * (m + 1))%Z) by lia.
  apply IZR_le in Hl, Hu'; rewrite !plus_IZR, !mult_IZR, ?plus_IZR in *.
  split; [apply Rmult_le_reg_l with (IZR (den x)) | apply Rmult_lt_reg_l with (IZR (den x))]; lra.
Qed.

Lemma sign_of_compare s r : is_sign s r -> (s ?= 0)%Z = Rcompare r 0.
Proof.
  intros [[-> H]|[[-> H]|[-> H]]]; symmetry; [now apply Rcompare_Gt | now apply Rcompare_Eq | now apply Rcompare_Lt].
Qed.

Lemma is_sign_zero s r : is_sign s r -> (s = 0%Z <-> r = 0).
Proof. intros [[-> H]|[[-> H]|[-> H]]]; split; intros; try discriminate; try reflexivity; lra || (exfalso; lra). Qed.

(** What is left of x, between the integer below it and the next. *)
Lemma rest_right guess x : valid x -> 0 <= val x ->
  inbetween (IZR (mantissa guess x)) (IZR (mantissa guess x) + 1) (val x) (rest x (mantissa guess x)).
Proof.
  intros Hx H0; pose proof (mantissa_bounds guess x Hx) as Hb; set (m := mantissa guess x) in *.
  pose proof (den_pos x Hx) as Hd; pose proof (val_den x Hx) as Hv; unfold rest.
  pose proof (sign1_correct (num x - den x * m) (coef x) (rad x) (proj1 Hx)) as H1.
  rewrite minus_IZR, mult_IZR in H1.
  pose proof (sign1_correct (2 * num x - den x * (2 * m + 1)) (2 * coef x) (rad x) (proj1 Hx)) as H2.
  rewrite minus_IZR, !mult_IZR, plus_IZR, mult_IZR in H2.
  destruct (Z.eqb_spec (sign1 (num x - den x * m) (coef x) (rad x)) 0) as [E|E].
  - apply (is_sign_zero _ _ H1) in E; apply inbetween_Exact.
    apply Rmult_eq_reg_l with (IZR (den x)); lra.
  - assert (N : val x <> IZR m).
    { intros Em; apply E, (is_sign_zero _ _ H1); rewrite <- Em; lra. }
    apply inbetween_Inexact; [lra|]; rewrite (sign_of_compare _ _ H2); clear H1 H2 E.
    replace (2 * IZR (num x) - IZR (den x) * (2 * IZR m + 1) + 2 * IZR (coef x) * sqrt (IZR (rad x)))
      with (2 * IZR (den x) * (val x - (IZR m + (IZR m + 1)) / 2)) by lra.
    replace 0 with (2 * IZR (den x) * 0) by ring; rewrite Rcompare_mult_l by lra.
    destruct (Rcompare_spec (val x) ((IZR m + (IZR m + 1)) / 2)); symmetry;
      [apply Rcompare_Lt | apply Rcompare_Eq | apply Rcompare_Gt]; lra.
Qed.

Lemma over_power_value x e : valid x -> valid (over_power x e) /\ val (over_power x e) * bpow radix2 e = val x.
Proof.
  intros [Hr Hd]; pose proof (IZR_lt _ _ Hd) as HdR; unfold over_power, valid; destruct (Z.leb_spec 0 e) as [He|He].
  - rewrite Z.shiftl_mul_pow2 by assumption; cbn [rad den]; split.
    + split; [assumption | apply Z.mul_pos_pos; [assumption | now apply Z.pow_pos_nonneg]].
    + unfold val; cbn [num coef rad den]; rewrite mult_IZR, (IZR_Zpower radix2) by assumption.
      pose proof (bpow_gt_0 radix2 e); field; lra.
  - rewrite !Z.shiftl_mul_pow2 by lia; cbn [rad den]; split; [now split|].
    unfold val; cbn [num coef rad den]; rewrite !mult_IZR, (IZR_Zpower radix2), bpow_opp by lia.
    pose proof (bpow_gt_0 radix2 e); field; lra.
Qed.

Lemma magnitude_value x : valid x -> valid (magnitude x) /\ val (magnitude x) = Rabs (val x).
Proof.
  intros Hx; pose proof (den_pos x Hx) as Hd; pose proof (sign1_correct (num x) (coef x) (rad x) (proj1 Hx)) as H.
  rewrite <- val_den in H by assumption; unfold magnitude, negative.
  destruct (Z.ltb_spec (sign1 (num x) (coef x) (rad x)) 0) as [L|L]; (split; [exact Hx|]).
  - assert (Hneg : IZR (den x) * val x < 0) by (destruct H as [[E H]|[[E H]|[E H]]]; lia || lra).
    rewrite Rabs_left; [|apply Rmult_lt_reg_l with (IZR (den x)); lra].
    unfold val; cbn [num coef rad den]; rewrite !opp_IZR; field; lra.
  - assert (Hpos : 0 <= IZR (den x) * val x) by (destruct H as [[E H]|[[E H]|[E H]]]; lia || lra).
    rewrite Rabs_pos_eq; [reflexivity | apply Rmult_le_reg_l with (IZR (den x)); lra].
Qed.

Lemma negative_right x : valid x -> negative x = Rlt_bool (val x) 0.
Proof.
  intros Hx; pose proof (den_pos x Hx) as Hd; pose proof (sign1_correct (num x) (coef x) (rad x) (proj1 Hx)) as H.
  rewrite <- val_den in H by assumption; unfold negative; symmetry.
  destruct (Z.ltb_spec (sign1 (num x) (coef x) (rad x)) 0) as [L|L]; [apply Rlt_bool_true | apply Rlt_bool_false];
    [apply Rmult_lt_reg_l with (IZR (den x)) | apply Rmult_le_reg_l with (IZR (den x))];
    destruct H as [[E H]|[[E H]|[E H]]]; lia || lra.
Qed.

(** ** The cut is fine enough to round at *)

Local Open Scope Z_scope.

Lemma cut_right guess place x : valid x -> (0 < val x)%R -> let (m, e) := cut guess place x in
  inbetween_float radix2 m e (val x) (rest (over_power x e) m) /\ e <= cexp radix2 (FLT_exp (-1074) 53) (val x).
Proof.
  intros Hx Hpos.
  assert (Hat : forall e, let y := over_power x e in let m := mantissa guess y in
    inbetween_float radix2 m e (val x) (rest y m) /\ (IZR m * bpow radix2 e <= val x)%R).
  { intros e y m; destruct (over_power_value x e Hx) as [Hy Hv]; fold y in Hy, Hv.
    pose proof (bpow_gt_0 radix2 e) as Hb; assert (H0 : (0 <= val y)%R).
    { apply Rmult_le_reg_r with (bpow radix2 e); lra. }
    pose proof (rest_right guess y Hy H0) as H; fold m in H; split.
    - unfold inbetween_float, F2R; cbn [Fnum Fexp]; rewrite plus_IZR, <- Hv; now apply inbetween_mult_compat.
    - rewrite <- Hv; apply Rmult_le_compat_r; [lra | apply (mantissa_bounds guess y Hy)]. }
  unfold cut; destruct (Z.leb_spec (2 ^ 53) (mantissa guess (over_power x place))) as [L|L];
    (split; [apply Hat|]); unfold cexp, FLT_exp; [|lia].
  enough (place + 54 <= mag radix2 (val x)) by lia; apply mag_ge_bpow; rewrite Rabs_pos_eq by lra.
  apply Rle_trans with (2 := proj2 (Hat place)); replace (place + 54 - 1) with (53 + place) by ring; rewrite bpow_plus.
  apply Rmult_le_compat_r; [apply bpow_ge_0|]; rewrite <- (IZR_Zpower radix2 53) by lia; now apply IZR_le.
Qed.

Local Open Scope R_scope.

(** The binary64 is the rounding of the number, and has its sign where it is a zero. *)
Theorem nearest_is_rounded_once guess place x : valid x ->
  let f := nearest guess place x in
  rounded_once f (val x) /\ is_nan f = false /\ Bsign f = Rlt_bool (val x) 0.
Proof.
  intros Hx f; unfold f, nearest.
  pose proof (den_pos x Hx) as Hd; pose proof (sign1_correct (num x) (coef x) (rad x) (proj1 Hx)) as Hs.
  rewrite <- val_den in Hs by assumption.
  destruct (Z.eqb_spec (sign1 (num x) (coef x) (rad x)) 0) as [E|E].
  - apply (is_sign_zero _ _ Hs) in E; assert (val x = 0) as -> by (apply Rmult_eq_reg_l with (IZR (den x)); lra).
    rewrite Rlt_bool_false by lra; split; [|now split]; unfold rounded_once.
    rewrite round_0, Rabs_R0 by auto with typeclass_instances; rewrite Rlt_bool_true by apply bpow_gt_0; now split.
  - assert (N : val x <> 0) by (intros Z0; apply E, (is_sign_zero _ _ Hs); rewrite Z0; ring).
    destruct (magnitude_value x Hx) as [Hy Hv]; pose proof (cut_right guess place (magnitude x) Hy) as Hc.
    rewrite Hv in Hc; specialize (Hc (Rabs_pos_lt _ N)); destruct (cut guess place (magnitude x)) as [m e].
    destruct Hc as [Hin He]; rewrite cexp_abs in He.
    destruct (binary_round_aux_correct' 53 1024 eq_refl eq_refl mode_NE (val x) m e _ N Hin He) as [Hz H].
    rewrite <- negative_right in Hz, H by assumption; set (z := binary_round_aux _ _ _ _ _ _ _) in *.
    destruct (Sumbool.sumbool_of_bool (SpecFloat.valid_binary 53 1024 z)) as [V|V]; [|congruence].
    change (round_mode mode_NE) with ZnearestE in H; change (SpecFloat.fexp 53 1024) with (FLT_exp (-1074) 53) in H.
    unfold rounded_once; rewrite <- !negative_right by assumption.
    destruct (Rlt_bool (Rabs (rnd64 (val x))) (bpow radix2 1024)).
    + destruct H as (Hr & Hf & Hsign); rewrite is_finite_SF2B, B2R_SF2B, Hf, Hr, is_nan_SF2B; split; [now split|].
      destruct z; try discriminate; now split.
    + destruct z; try discriminate H; injection H as ->; cbn; rewrite negative_right by assumption; now split.
Qed.

(** Its bits are those that Flocq's binary64 of these bits has. *)
Theorem bits_are_of f : is_nan f = false -> Binary.B2BSN 53 1024 (Bits.b64_of_bits (bits f)) = f.
Proof.
  intros Hf; unfold bits, Bits.b64_of_bits, Bits.bits_of_b64; rewrite Bits.binary_float_of_bits_of_binary_float.
  now rewrite Binary.B2BSN_BSN2B.
Qed.

Theorem nearest_right guess place x : valid x -> let f := nearest guess place x in
  rounded_once f (val x) /\ is_nan f = false /\ Bsign f = Rlt_bool (val x) 0
  /\ Binary.B2BSN 53 1024 (Bits.b64_of_bits (bits f)) = f.
Proof.
  intros Hx f; destruct (nearest_is_rounded_once guess place x Hx) as (Hr & Hn & Hs).
  exact (conj Hr (conj Hn (conj Hs (bits_are_of f Hn)))).
Qed.
