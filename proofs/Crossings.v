(** * Crossings: binary64 compares them in the order of their events

    The model of accel/line.hpp, operation by operation: a crossing's parameter is (plane - p) * (1 / v), three roundings;
    two that are far enough apart are in the order of the computed ones, and exact numbers decide the rest.

    crossing64             == Crossing: the parameter, the plane, its axis, and whether the ray goes backwards there
    never64                == 2^300, greater than every parameter
    crosses64, order64     == Line::crossing, Line::order;  exactly64 == Line::order_exactly, over the reals
    start64, beyond64      == Line::start, Line::beyond
    usable64 x             == the plane x is 0 or of magnitude 2^-150 … 2^150
    ordinary p v           == so is p, and v is 0 or of magnitude 2^-100 … 2^100
    value_of c A           == what the parameter of c is, where c is computed of the event A
    line64                 == so the line of binary64 is one (Line.v) *)
From Durero Require Import Acceleration Moments Line Limits.
From Durero Require Slab.
From Coq Require Import ZArith Reals Bool Lra Lia.
From Flocq Require Import Core Relative BinarySingleNaN.
Local Open Scope R_scope.

Local Instance prec53 : Prec_gt_0 53 := eq_refl.
Notation NE := mode_NE.
Notation u := (bpow radix2 (-53)).
Notation format64 := (generic_format radix2 (FLT_exp (-1074) 53)).

Definition never64 : binary64 := @B754_finite 53 1024 false (2 ^ 52) 248 eq_refl. (* 2^300 *)
Definition apart64 : binary64 := @B754_finite 53 1024 false (2 ^ 52) (-101) eq_refl. (* 2^-49 *)
Definition less64 : binary64 := @B754_finite 53 1024 false (2 ^ 53 - 8) (-53) eq_refl. (* 1 - 2^-50 *)

Notation Bplus64 := (@Bplus 53 1024 Slab.prec64 Slab.less64 NE).
Notation Bminus64 := (@Bminus 53 1024 Slab.prec64 Slab.less64 NE).
Notation Bmult64 := (@Bmult 53 1024 Slab.prec64 Slab.less64 NE).
Notation crossing_at := (Slab.crossing 53 1024 Slab.prec64 Slab.less64).

Record crossing64 := Crossing64 { parameter : binary64; plane_of : binary64; across : axis; goes_back : bool }.

Definition in_range (low high : Z) (x : binary64) : Prop :=
  is_finite x = true /\ (B2R x = 0 \/ bpow radix2 low <= Rabs (B2R x) <= bpow radix2 high).
Definition usable64 : binary64 -> Prop := in_range (-150) 150.
Definition ordinary (p v : axis -> binary64) : Prop := forall i, in_range (-150) 150 (p i) /\ in_range (-100) 100 (v i).

Lemma half_ulp : / 2 * bpow radix2 (- (53) + 1) = u.
Proof. change (- (53) + 1)%Z with (-53 + 1)%Z. rewrite bpow_plus_1. cbn [radix_val radix2]. lra. Qed.
Lemma twice e : bpow radix2 (e + 1) = 2 * bpow radix2 e.
Proof. exact (bpow_plus_1 radix2 e). Qed.

Section Crossings.
Variables p v : axis -> binary64.
Hypothesis in_order : ordinary p v.
Notation pr := (fun i => B2R (p i)).
Notation vr := (fun i => B2R (v i)).
Notation event_of := (Moments.event_of pr vr).

Definition still64 (i : axis) : bool := Beqb (v i) zero.
Definition backwards64 (i : axis) : bool := Bltb (v i) zero.
Definition start64 : crossing64 := Crossing64 zero (p X) X false.
Definition crosses64 (i : axis) (x : binary64) : crossing64 :=
  if still64 i then Crossing64 (if Bleb x (p i) then Bopp never64 else never64) x i false
  else Crossing64 (crossing_at x (p i) (v i)) x i (backwards64 i).

(** By exact numbers: (a - p)/v < (b - q)/w, times |v||w|. *)
Definition way (c : crossing64) : R :=
  let whole := B2R (plane_of c) - B2R (p (across c)) in if backwards64 (across c) then - whole else whole.
Definition speed (c : crossing64) : R := Rabs (B2R (v (across c))).
Definition exactly64 (a b : crossing64) : comparison :=
  if Bleb never64 (Babs (parameter a)) then Eq
  else
    let of_a := if Beqb (parameter a) zero then 0 else way a * speed b in
    let of_b := if Beqb (parameter b) zero then 0 else way b * speed a in
    match Rcompare of_a of_b with
    | Eq => match goes_back a, goes_back b with false, true => Lt | true, false => Gt | _, _ => Eq end
    | c => c
    end.
Definition order64 (a b : crossing64) : comparison :=
  let apart := Bminus64 (parameter a) (parameter b) in
  if Bltb (Bmult64 apart64 (Bplus64 (Babs (parameter a)) (Babs (parameter b)))) (Babs apart)
  then if Bltb apart zero then Lt else Gt
  else exactly64 a b.

Definition beyond64 (c : crossing64) (limit : binary64) : bool := Bltb limit (Bmult64 (parameter c) less64).

Definition stands64 (c : crossing64) (A : event) : Prop :=
  (c = start64 /\ A = At start) \/ exists i x, usable64 x /\ c = crosses64 i x /\ A = event_of i (B2R x).

(** ** The parameter of a crossing *)

Lemma finite_range low high x : in_range low high x -> is_finite x = true.
Proof. now intros [H _]. Qed.
Lemma still_is i : still64 i = true <-> B2R (v i) = 0.
Proof.
  unfold still64. rewrite Beqb_correct; [| apply (finite_range _ _ _ (proj2 (in_order i))) | reflexivity].
  cbn [zero B2R]. destruct (Req_bool_spec (B2R (v i)) 0); split; intros; (assumption || reflexivity || discriminate || contradiction).
Qed.
Lemma backwards_is i : backwards64 i = true <-> B2R (v i) < 0.
Proof.
  unfold backwards64. rewrite Bltb_correct; [| apply (finite_range _ _ _ (proj2 (in_order i))) | reflexivity].
  cbn [zero B2R]. destruct (Rlt_bool_spec (B2R (v i)) 0); split; intros; (assumption || reflexivity || discriminate || lra).
Qed.

(** Numbers in range are multiples of 2^-202, so that two of them are equal or so far apart. *)
Lemma multiple x : usable64 x -> exists n, B2R x = IZR n * bpow radix2 (-202).
Proof.
  intros [_ [-> | [Hx _]]]; [exists 0%Z; ring |]. pose proof (generic_format_B2R 53 1024 x) as F.
  assert (E : (-202 <= cexp radix2 (FLT_exp (3 - 1024 - 53) 53) (B2R x))%Z).
  { unfold cexp, FLT_exp. pose proof (mag_ge_bpow radix2 (B2R x) (-149) Hx). lia. }
  unfold generic_format in F. rewrite (F2R_change_exp radix2 (-202) _ _ E) in F. eexists. exact F.
Qed.
Lemma far_apart x y : usable64 x -> usable64 y -> B2R x <> B2R y -> bpow radix2 (-202) <= Rabs (B2R x - B2R y).
Proof.
  intros Hx Hy. destruct (multiple x Hx) as [m ->], (multiple y Hy) as [n ->]. intros H.
  replace (IZR m * bpow radix2 (-202) - IZR n * bpow radix2 (-202)) with (IZR (m - n) * bpow radix2 (-202))
    by (rewrite minus_IZR; ring).
  rewrite Rabs_mult, (Rabs_pos_eq (bpow radix2 (-202))) by apply bpow_ge_0. rewrite <- (Rmult_1_l (bpow radix2 (-202))) at 1.
  apply Rmult_le_compat_r; [apply bpow_ge_0 |]. rewrite <- abs_IZR. apply IZR_le.
  assert (m <> n) by (intros ->; now apply H). lia.
Qed.

Lemma moderate_in_range low high x : (high <= 1022)%Z -> in_range low high x -> Slab.moderate 53 1024 x.
Proof.
  intros Hh [F [H | [_ H]]]; (split; [exact F |]); [rewrite H, Rabs_R0; apply bpow_ge_0 |].
  apply Rle_trans with (1 := H). now apply bpow_le.
Qed.

(** Three roundings: within 4u of itself, zero where the exact one is, and neither tiny nor huge. *)
Lemma parameter_near i x : usable64 x -> B2R (v i) <> 0 ->
  let t := (B2R x - B2R (p i)) / B2R (v i) in let c := crossing_at x (p i) (v i) in
  is_finite c = true /\ Rabs (B2R c - t) <= 4 * u * Rabs (B2R c)
  /\ (t = 0 /\ B2R c = 0 \/ bpow radix2 (-400) <= Rabs (B2R c) <= bpow radix2 260).
Proof.
  intros Hx Hv t c. destruct (in_order i) as [Hp [Fv [N | [Vlow Vhigh]]]]; [contradiction |].
  destruct (Slab.crossing_value 53 1024 Slab.prec64 Slab.less64 ltac:(lia) _ _ Slab.grow64_value Slab.tiny64_value x (p i) (v i)) as [k [Hk Hc]].
  { now apply (moderate_in_range (-150) 150). }
  { now apply (moderate_in_range (-150) 150). }
  { now apply (moderate_in_range (-100) 100); [| split; [| right]]. }
  { apply Rle_trans with (2 := Vlow). now apply bpow_le. }
  fold t c in Hc. rewrite half_ulp in Hk.
  assert (Hu : 0 < u <= / 1024) by (split; [apply bpow_gt_0 | apply Rle_trans with (bpow radix2 (-10)); [now apply bpow_le | cbn; lra]]).
  assert (Huu : 0 <= u * u <= / 1024 * u) by (split; [apply Rmult_le_pos; lra | apply Rmult_le_compat_r; lra]).
  assert (Huuu : 0 <= u * u * u <= u * u)
    by (split; [apply Rmult_le_pos; lra | rewrite <- (Rmult_1_r (u * u)) at 2; apply Rmult_le_compat_l; lra]).
  assert (K : - (2 * u) <= k - 1 <= 2 * u + u * u) by lra.
  destruct (Req_dec t 0) as [T | T].
  { rewrite T, Rmult_0_l, round_0 in Hc by auto with typeclass_instances.
    destruct Hc as [[F V] | [_ N]]; [| rewrite Rabs_R0 in N; pose proof (bpow_gt_0 radix2 1024); lra].
    rewrite V, T, Rminus_0_r, Rabs_R0. repeat split; [exact F | lra | now left]. }
  assert (Hd : bpow radix2 (-202) <= Rabs (B2R x - B2R (p i)) <= bpow radix2 151).
  { split; [apply far_apart; [exact Hx | exact Hp |]; intros E; apply T; unfold t; rewrite E; unfold Rdiv; ring |].
    assert (M : forall y, usable64 y -> Rabs (B2R y) <= bpow radix2 150)
      by (intros y [_ [-> | [_ H]]]; [rewrite Rabs_R0; apply bpow_ge_0 | exact H]).
    apply Rle_trans with (1 := Rabs_triang _ _). rewrite Rabs_Ropp. pose proof (M _ Hx). pose proof (M _ Hp).
    pose proof (twice 150). change (150 + 1)%Z with 151%Z in *. lra. }
  assert (Ht : bpow radix2 (-302) <= Rabs t <= bpow radix2 251).
  { unfold t, Rdiv. rewrite Rabs_mult, Rabs_inv. pose proof (bpow_gt_0 radix2 (-100)).
    split; [change (-302)%Z with (-202 + -(100))%Z | change 251%Z with (151 + -(-100))%Z];
      rewrite bpow_plus, bpow_opp; apply Rmult_le_compat; try apply bpow_ge_0; try apply Rabs_pos; try tauto;
      try (left; apply Rinv_0_lt_compat; (apply bpow_gt_0 || lra)); apply Rinv_le; (lra || tauto). }
  assert (Htk : / 2 * Rabs t <= Rabs (t * k) <= 2 * Rabs t).
  { rewrite Rabs_mult, (Rabs_pos_eq k) by lra. rewrite (Rmult_comm (Rabs t)).
    split; apply Rmult_le_compat_r; try apply Rabs_pos; lra. }
  destruct Hc as [[F V] | [_ N]].
  2:{ exfalso. apply (Rlt_irrefl (bpow radix2 1024)). apply Rle_lt_trans with (1 := N).
      apply (Slab.no_overflow 53 1024 Slab.prec64 ltac:(lia) _ 252); [lia | lia |].
      change 252%Z with (251 + 1)%Z. rewrite twice. lra. }
  destruct (relative_error_N_FLT_ex radix2 (-1074) 53 prec53 (fun n => negb (Z.even n)) (t * k)) as [e [He Ve]].
  { apply Rle_trans with (bpow radix2 (-303)); [now apply bpow_le |]. change (-302)%Z with (-303 + 1)%Z in Ht. rewrite twice in Ht. lra. }
  rewrite half_ulp in He.
  change (FLT_exp (3 - 1024 - 53) 53) with (FLT_exp (-1074) 53) in V. rewrite Ve in V.
  assert (Hke : Rabs (k * e) <= (1 + 2 * u + u * u) * u).
  { rewrite Rabs_mult, (Rabs_pos_eq k) by lra. apply Rmult_le_compat; try apply Rabs_pos; lra. }
  apply Rabs_le_inv in Hke. assert (Q : u * / 2 - 4 * u <= k - 1 + k * e <= 4 * u - u * / 2) by lra.
  assert (Hc : Rabs (B2R c) = Rabs t * (1 + (k - 1 + k * e))).
  { rewrite V. replace (t * k * (1 + e)) with (t * (1 + (k - 1 + k * e))) by ring. rewrite Rabs_mult.
    f_equal. apply Rabs_pos_eq. lra. }
  split; [exact F | split; [| right; rewrite Hc; split]].
  - rewrite Hc. replace (B2R c - t) with (t * (k - 1 + k * e)) by (rewrite V; ring). rewrite Rabs_mult.
    replace (4 * u * (Rabs t * (1 + (k - 1 + k * e)))) with (Rabs t * (4 * u * (1 + (k - 1 + k * e)))) by ring.
    apply Rmult_le_compat_l; [apply Rabs_pos |].
    assert (4 * u * (- (4 * u)) <= 4 * u * (k - 1 + k * e)) by (apply Rmult_le_compat_l; lra). apply Rabs_le. lra.
  - apply Rle_trans with (bpow radix2 (-303)); [now apply bpow_le |]. change (-302)%Z with (-303 + 1)%Z in Ht. rewrite twice in Ht.
    apply Rle_trans with (Rabs t * / 2); [lra | apply Rmult_le_compat_l; [apply Rabs_pos | lra]].
  - apply Rle_trans with (bpow radix2 252); [| now apply bpow_le]. change 252%Z with (251 + 1)%Z. rewrite twice, (Rmult_comm 2).
    apply Rmult_le_compat; try apply Rabs_pos; lra.
Qed.

(** What is known of a crossing's parameter. A zero stands for zero only. *)
Definition value_of (c : crossing64) (A : event) : Prop :=
  is_finite (parameter c) = true /\
  match A with
  | Since_ever => parameter c = Bopp never64
  | Never => parameter c = never64
  | At (t, b) =>
      Rabs (B2R (parameter c) - t) <= 4 * u * Rabs (B2R (parameter c)) /\ goes_back c = b
      /\ (t = 0 /\ B2R (parameter c) = 0
          \/ bpow radix2 (-400) <= Rabs (B2R (parameter c)) <= bpow radix2 260
             /\ B2R (v (across c)) <> 0 /\ t = (B2R (plane_of c) - B2R (p (across c))) / B2R (v (across c)))
  end.

Lemma stands_value c A : stands64 c A -> value_of c A.
Proof.
  intros [[-> ->] | [i [x [Hx [-> ->]]]]].
  - split; [reflexivity |]. unfold start64, start. cbn [parameter goes_back zero]. change (B2R zero) with 0.
    rewrite Rminus_0_r, Rabs_R0. repeat split; [lra | now left].
  - unfold crosses64, Moments.event_of, Moments.crossing. cbn. destruct (Req_EM_T (B2R (v i)) 0) as [E | E].
    + rewrite (proj2 (still_is i) E). destruct Hx as [Fx _]. destruct (in_order i) as [[Fp _] _].
      rewrite Bleb_correct by assumption. unfold value_of.
      destruct (Rle_dec (B2R x) (B2R (p i))); [rewrite Rle_bool_true by assumption | rewrite Rle_bool_false by lra];
        now split.
    + destruct (still64 i) eqn:Es; [now apply still_is in Es |].
      destruct (parameter_near i x Hx E) as [F [Near Size]]. split; [exact F |]. cbn [parameter goes_back plane_of across].
      split; [exact Near | split].
      * pose proof (backwards_is i) as Hb. destruct (Rlt_dec (B2R (v i)) 0) as [L | L], (backwards64 i); try reflexivity;
          [now apply Hb in L | now destruct L; apply Hb].
      * destruct Size as [Size | Size]; [now left | right]. now repeat split.
Qed.

(** A crossing is computed of one moment only. *)
Lemma stands_one c m m' : stands64 c (At m) -> stands64 c (At m') -> m = m'.
Proof.
  intros H H'. apply stands_value in H, H'. destruct m as [t b], m' as [t' b'].
  destruct H as [_ [_ [<- H]]], H' as [_ [_ [<- H']]]. f_equal. pose proof (bpow_gt_0 radix2 (-400)).
  destruct H as [[-> N] | [[N _] [_ ->]]], H' as [[-> N'] | [[N' _] [_ ->]]]; try reflexivity;
    rewrite ?N, ?N', Rabs_R0 in *; lra.
Qed.

(** ** The comparison *)

Lemma never_is : B2R never64 = bpow radix2 300.
Proof. unfold never64, B2R, F2R. cbn [Fnum Fexp cond_Zopp]. change (IZR (Z.pos (2 ^ 52))) with (bpow radix2 52). now rewrite <- bpow_plus. Qed.
Lemma apart_is : B2R apart64 = bpow radix2 (-49).
Proof. unfold apart64, B2R, F2R. cbn [Fnum Fexp cond_Zopp]. change (IZR (Z.pos (2 ^ 52))) with (bpow radix2 52). now rewrite <- bpow_plus. Qed.
Lemma less_is : B2R less64 = 1 - 8 * u.
Proof.
  unfold less64, B2R, F2R. cbn [Fnum Fexp cond_Zopp]. change (IZR (Z.pos (2 ^ 53 - 8))) with (IZR (2 ^ 53 - 8)).
  rewrite minus_IZR. change (IZR (2 ^ 53)) with (bpow radix2 53). rewrite Rmult_minus_distr_r, <- bpow_plus.
  change (bpow radix2 (53 + -53)) with 1. ring.
Qed.

Lemma fits y : Rabs y <= bpow radix2 302 -> Rlt_bool (Rabs (rnd64 y)) (bpow radix2 1024) = true.
Proof. intros H. apply Rlt_bool_true. exact (Slab.no_overflow 53 1024 Slab.prec64 ltac:(lia) y 302 ltac:(lia) ltac:(lia) H). Qed.

(** Two that the first test parts are farther apart than all their errors; two that it does not are near. *)
Lemma compare_fast x y : is_finite x = true -> is_finite y = true -> Rabs (B2R x) <= bpow radix2 300 ->
  Rabs (B2R y) <= bpow radix2 300 -> let S := Rabs (B2R x) + Rabs (B2R y) in let d := B2R x - B2R y in
  if Bltb (Bmult64 apart64 (Bplus64 (Babs x) (Babs y))) (Babs (Bminus64 x y))
  then 8 * u * S < Rabs d /\ (Bltb (Bminus64 x y) zero = true <-> B2R x < B2R y)
  else Rabs d <= bpow radix2 (-40) * S + bpow radix2 (-1000).
Proof.
  intros Fx Fy Hx Hy S d. pose proof (Rabs_pos (B2R x)) as Px. pose proof (Rabs_pos (B2R y)) as Py.
  pose proof (twice 300) as T1. pose proof (twice 301) as T2. change (300 + 1)%Z with 301%Z in T1. change (301 + 1)%Z with 302%Z in T2.
  assert (HS : 0 <= S <= bpow radix2 301) by (unfold S; lra).
  assert (Mono : forall a b, a <= b -> rnd64 a <= rnd64 b) by (intros a b; now apply round_le; auto with typeclass_instances).
  assert (Zero : rnd64 0 = 0) by (apply round_0; auto with typeclass_instances).
  assert (Hd : Rabs d <= S) by (unfold d, S, Rminus; apply Rle_trans with (1 := Rabs_triang _ _); rewrite Rabs_Ropp; lra).
  pose proof (Bminus_correct 53 1024 Slab.prec64 Slab.less64 NE x y Fx Fy) as Hm.
  change (round radix2 (SpecFloat.fexp 53 1024) (round_mode NE) (B2R x - B2R y)) with (rnd64 d) in Hm.
  rewrite fits in Hm by lra. destruct Hm as [Vm [Fm _]].
  assert (Fax : is_finite (Babs x) = true) by now rewrite is_finite_Babs.
  assert (Fay : is_finite (Babs y) = true) by now rewrite is_finite_Babs.
  pose proof (Bplus_correct 53 1024 Slab.prec64 Slab.less64 NE (Babs x) (Babs y) Fax Fay) as Hp.
  rewrite !B2R_Babs in Hp.
  change (round radix2 (SpecFloat.fexp 53 1024) (round_mode NE) (Rabs (B2R x) + Rabs (B2R y))) with (rnd64 S) in Hp.
  rewrite fits in Hp by (rewrite Rabs_pos_eq by lra; lra). destruct Hp as [Vp [Fp _]].
  assert (Hr : / 2 * S <= rnd64 S <= 2 * S + bpow radix2 (-1074)).
  { split.
    - assert (rnd64 S >= Rabs (B2R x) /\ rnd64 S >= Rabs (B2R y)) as [Rx Ry]; [| unfold S in *; lra].
      split; apply Rle_ge, round_ge_generic; auto with typeclass_instances; try apply generic_format_abs;
        try apply generic_format_B2R; unfold S; lra.
    - apply Rle_trans with (1 := Slab.rnd_upper 53 1024 Slab.prec64 S (proj1 HS)). rewrite half_ulp.
      change (3 - 1024 - 53)%Z with (-1074)%Z. assert (u <= 1) by (apply (bpow_le radix2 (-53) 0); lia).
      pose proof (Rmult_le_compat_l S _ _ (proj1 HS) H). lra. }
  pose proof (Bmult_correct 53 1024 Slab.prec64 Slab.less64 NE apart64 (Bplus64 (Babs x) (Babs y))) as Hq.
  rewrite Vp, apart_is in Hq.
  change (round radix2 (SpecFloat.fexp 53 1024) (round_mode NE) (bpow radix2 (-49) * rnd64 S))
    with (rnd64 (bpow radix2 (-49) * rnd64 S)) in Hq.
  assert (E49 : bpow radix2 (-49) = 16 * u) by (change (-49)%Z with (-53 + 1 + 1 + 1 + 1)%Z; rewrite !twice; lra).
  pose proof (bpow_gt_0 radix2 (-53)) as Pu. assert (Hu : u <= / 64) by (apply (bpow_le radix2 (-53) (-6)); lia).
  assert (Eta : 0 < bpow radix2 (-1074) <= / 64 * bpow radix2 (-1000)).
  { split; [apply bpow_gt_0 |]. apply Rle_trans with (bpow radix2 (-6 + -1000)); [now apply bpow_le |].
    rewrite bpow_plus. right. reflexivity. }
  assert (Small : bpow radix2 (-1000) <= 1) by (apply (bpow_le radix2 (-1000) 0); lia).
  assert (Big : 1 <= bpow radix2 300) by (apply (bpow_le radix2 0 300); lia).
  set (w := bpow radix2 (-49) * rnd64 S) in *.
  assert (Hw : 8 * u * S <= w <= 32 * u * S + bpow radix2 (-1074)).
  { unfold w. rewrite E49. assert (16 * u * (/ 2 * S) <= 16 * u * rnd64 S) by (apply Rmult_le_compat_l; lra).
    assert (16 * u * rnd64 S <= 16 * u * (2 * S + bpow radix2 (-1074))) by (apply Rmult_le_compat_l; lra).
    assert (16 * u * bpow radix2 (-1074) <= 1 * bpow radix2 (-1074)) by (apply Rmult_le_compat_r; lra). lra. }
  assert (Pus : 0 <= u * S <= / 64 * S) by (split; [apply Rmult_le_pos; lra | apply Rmult_le_compat_r; lra]).
  rewrite fits in Hq by (rewrite Rabs_pos_eq; lra). destruct Hq as [Vq [Fq _]]. rewrite Fp in Fq.
  change (is_finite (Bmult64 apart64 (Bplus64 (Babs x) (Babs y))) = true) in Fq.
  rewrite Bltb_correct by (try rewrite is_finite_Babs; assumption). rewrite Vq, B2R_Babs, Vm.
  assert (Hw0 : 0 <= rnd64 w) by (rewrite <- Zero; apply Mono; lra).
  destruct (Rlt_bool_spec (rnd64 w) (Rabs (rnd64 d))) as [L | L].
  - split.
    + apply Rnot_le_lt. intros N. apply (Rlt_not_le _ _ L). rewrite <- round_NE_abs by auto with typeclass_instances.
      apply Mono. lra.
    + rewrite Bltb_correct by (assumption || reflexivity). rewrite Vm. cbn [zero B2R].
      destruct (Rlt_bool_spec (rnd64 d) 0) as [M | M]; split; intros H; try reflexivity; try discriminate.
      * apply Rnot_le_lt. intros N. apply (Rlt_not_le _ _ M). rewrite <- Zero. apply Mono. unfold d. lra.
      * exfalso. assert (rnd64 d <= 0) by (rewrite <- Zero; apply Mono; unfold d; lra).
        rewrite Rabs_pos_eq in L by assumption. lra.
  - rewrite <- round_NE_abs in L by auto with typeclass_instances.
    pose proof (Slab.rnd_lower 53 1024 Slab.prec64 (Rabs d) (Rabs_pos d)) as K1.
    pose proof (Slab.rnd_upper 53 1024 Slab.prec64 w ltac:(lra)) as K2. rewrite half_ulp in K1, K2.
    change (3 - 1024 - 53)%Z with (-1074)%Z in *.
    assert (Rabs d * u <= Rabs d * / 64) by (apply Rmult_le_compat_l; [apply Rabs_pos | lra]).
    assert (w * u <= w * / 64) by (apply Rmult_le_compat_l; lra).
    assert (E40 : bpow radix2 (-40) = 8192 * u).
    { change (-40)%Z with (13 + -53)%Z. rewrite bpow_plus. reflexivity. }
    rewrite E40. lra.
Qed.

Lemma value_small c A : value_of c A -> is_finite (parameter c) = true /\ Rabs (B2R (parameter c)) <= bpow radix2 300.
Proof.
  intros [F H]. split; [exact F |]. destruct A as [| [t b] |]; [rewrite H, B2R_Bopp, Rabs_Ropp | | rewrite H].
  1, 3: rewrite never_is, Rabs_pos_eq by apply bpow_ge_0; lra.
  destruct H as [_ [_ [[_ ->] | [[_ H] _]]]]; [rewrite Rabs_R0; apply bpow_ge_0 |].
  apply Rle_trans with (1 := H). now apply bpow_le.
Qed.

(** Far from a crossing that is none. *)
Lemma far_from_never : bpow radix2 260 <= / 1024 * bpow radix2 300 /\ 1024 <= bpow radix2 300.
Proof.
  split; [| apply (bpow_le radix2 10 300); lia].
  apply Rle_trans with (bpow radix2 (-10 + 300)); [now apply bpow_le | rewrite bpow_plus; right; reflexivity].
Qed.
Lemma at_far c t b : value_of c (At (t, b)) -> Rabs (B2R (parameter c)) <= / 1024 * bpow radix2 300.
Proof.
  intros [_ [_ [_ [[_ ->] | [[_ H] _]]]]]; pose proof far_from_never; [rewrite Rabs_R0; lra | lra].
Qed.

Lemma apart_in_order a b A B : value_of a A -> value_of b B ->
  8 * u * (Rabs (B2R (parameter a)) + Rabs (B2R (parameter b))) < Rabs (B2R (parameter a) - B2R (parameter b)) ->
  B2R (parameter a) < B2R (parameter b) -> sooner A B.
Proof.
  intros Ha Hb Hd Hless. pose proof far_from_never as Far. rewrite Rabs_minus_sym, (Rabs_pos_eq (_ - _)) in Hd by lra.
  destruct A as [| [t s] |], B as [| [t' s'] |]; try exact I.
  - destruct Ha as [_ Ha], Hb as [_ Hb]. rewrite Ha, Hb in Hless. lra.
  - pose proof (at_far a t s Ha) as Fa. destruct Hb as [_ Hb]. rewrite Hb, B2R_Bopp, never_is in Hless.
    apply Rabs_le_inv in Fa. lra.
  - destruct Ha as [_ [Ha _]], Hb as [_ [Hb _]]. apply Rabs_le_inv in Ha, Hb. left. cbn.
    pose proof (Rmult_le_pos u _ (bpow_ge_0 radix2 (-53)) (Rabs_pos (B2R (parameter a)))).
    pose proof (Rmult_le_pos u _ (bpow_ge_0 radix2 (-53)) (Rabs_pos (B2R (parameter b)))). lra.
  - destruct Ha as [_ Ha], Hb as [_ Hb]. rewrite Ha, Hb, B2R_Bopp, never_is in Hless. lra.
  - pose proof (at_far b t' s' Hb) as Fb. destruct Ha as [_ Ha]. rewrite Ha, never_is in Hless.
    apply Rabs_le_inv in Fb. lra.
  - destruct Ha as [_ Ha], Hb as [_ Hb]. rewrite Ha, Hb in Hless. lra.
Qed.

Lemma way_is c t : B2R (v (across c)) <> 0 -> t = (B2R (plane_of c) - B2R (p (across c))) / B2R (v (across c)) ->
  way c = t * speed c /\ 0 < speed c.
Proof.
  intros Hv ->. unfold way, speed. split; [| now apply Rabs_pos_lt]. pose proof (backwards_is (across c)) as Hb.
  destruct (backwards64 (across c)).
  - rewrite Rabs_left by (now apply Hb). now field.
  - rewrite Rabs_pos_eq by (apply Rnot_lt_le; intros N; apply Hb in N; discriminate). now field.
Qed.

Lemma tie t (b b' : bool) :
  match (match b, b' with false, true => Lt | true, false => Gt | _, _ => Eq end) with
  | Lt => sooner (At (t, b)) (At (t, b'))
  | Eq => At (t, b) ≼ At (t, b') /\ At (t, b') ≼ At (t, b)
  | Gt => sooner (At (t, b')) (At (t, b))
  end.
Proof. destruct b, b'; cbv iota; try (split; apply same_event); cbn [sooner]; unfold before; cbn; tauto. Qed.

Lemma exactly_right a b t s t' s' : value_of a (At (t, s)) -> value_of b (At (t', s')) ->
  Rabs (B2R (parameter a) - B2R (parameter b))
    <= bpow radix2 (-40) * (Rabs (B2R (parameter a)) + Rabs (B2R (parameter b))) + bpow radix2 (-1000) ->
  match exactly64 a b with
  | Lt => sooner (At (t, s)) (At (t', s'))
  | Eq => At (t, s) ≼ At (t', s') /\ At (t', s') ≼ At (t, s)
  | Gt => sooner (At (t', s')) (At (t, s))
  end.
Proof.
  intros Ha Hb Near. pose proof (at_far a t s Ha) as Fa. pose proof far_from_never as Far.
  destruct Ha as [Fina [_ [Sa Va]]], Hb as [Finb [_ [Sb Vb]]]. unfold exactly64.
  rewrite Bleb_correct by (try rewrite is_finite_Babs; (exact Fina || reflexivity)). rewrite B2R_Babs, never_is.
  rewrite Rle_bool_false by lra. rewrite !Beqb_correct by (assumption || reflexivity). cbn [zero B2R].
  assert (One : bpow radix2 (-40) <= / 4) by (apply (bpow_le radix2 (-40) (-2)); lia).
  assert (Tiny : bpow radix2 (-1000) <= / 4 * bpow radix2 (-400)).
  { apply Rle_trans with (bpow radix2 (-2 + -400)); [now apply bpow_le | rewrite bpow_plus; right; reflexivity]. }
  pose proof (bpow_gt_0 radix2 (-400)) as P400. rewrite Sa, Sb.
  destruct Va as [[Ta Za] | [[La _] [Na Ea]]], Vb as [[Tb Zb] | [[Lb _] [Nb Eb]]].
  - rewrite Za, Zb, !Req_bool_true by reflexivity. rewrite Rcompare_Eq by reflexivity. subst t t'. apply tie.
  - exfalso. rewrite Za, Rabs_R0, Rminus_0_l, Rabs_Ropp, Rplus_0_l in Near.
    pose proof (Rmult_le_compat_r _ _ _ (Rabs_pos (B2R (parameter b))) One). lra.
  - exfalso. rewrite Zb, Rabs_R0, Rminus_0_r, Rplus_0_r in Near.
    pose proof (Rmult_le_compat_r _ _ _ (Rabs_pos (B2R (parameter a))) One). lra.
  - rewrite !Req_bool_false by (intros E; rewrite E, Rabs_R0 in *; lra).
    destruct (way_is a t Na Ea) as [-> Pa], (way_is b t' Nb Eb) as [-> Pb].
    replace (t' * speed b * speed a) with (t' * (speed a * speed b)) by ring. rewrite Rmult_assoc.
    rewrite Rcompare_mult_r by now apply Rmult_lt_0_compat.
    destruct (Rcompare_spec t t') as [L | -> | L]; [now left | apply tie | now left].
Qed.

Theorem order64_right a b A B : stands64 a A -> stands64 b B ->
  match order64 a b with Lt => sooner A B | Eq => A ≼ B /\ B ≼ A | Gt => sooner B A end.
Proof.
  intros Ha Hb. apply stands_value in Ha, Hb. destruct (value_small a A Ha) as [Fa Sa], (value_small b B Hb) as [Fb Sb].
  pose proof (compare_fast (parameter a) (parameter b) Fa Fb Sa Sb) as H. cbv zeta in H. unfold order64.
  destruct (Bltb (Bmult64 _ _) _).
  - destruct H as [Hd Hs]. destruct (Bltb (Bminus64 _ _) zero).
    + apply (apart_in_order a b); auto. now apply Hs.
    + apply (apart_in_order b a); auto; [rewrite Rplus_comm, Rabs_minus_sym; exact Hd |].
      destruct (Rtotal_order (B2R (parameter a)) (B2R (parameter b))) as [K | [K | K]]; [now apply Hs in K | | exact K].
      exfalso. rewrite K, Rminus_eq_0, Rabs_R0 in Hd. pose proof (Rabs_pos (B2R (parameter b))) as P.
      pose proof (Rmult_le_pos u _ (bpow_ge_0 radix2 (-53)) P). lra.
  - pose proof far_from_never as Far.
    assert (One : bpow radix2 (-40) <= / 4) by (apply (bpow_le radix2 (-40) (-2)); lia).
    assert (Small : bpow radix2 (-1000) <= 1) by (apply (bpow_le radix2 (-1000) 0); lia).
    assert (Same : forall x, parameter a = x -> parameter b = x -> B2R (Babs x) = bpow radix2 300 -> exactly64 a b = Eq).
    { intros x Ea Eb Hx. unfold exactly64. rewrite Ea. rewrite Bleb_correct; [| reflexivity |].
      - rewrite Hx, never_is, Rle_bool_true by lra. reflexivity.
      - rewrite is_finite_Babs, <- Ea. exact Fa. }
    pose proof (Rabs_pos (B2R (parameter a))) as Pa. pose proof (Rabs_pos (B2R (parameter b))) as Pb.
    assert (Near : Rabs (B2R (parameter a) - B2R (parameter b))
      <= / 4 * (Rabs (B2R (parameter a)) + Rabs (B2R (parameter b))) + 1).
    { apply Rle_trans with (1 := H). apply Rplus_le_compat; [apply Rmult_le_compat_r; lra | lra]. }
    apply Rabs_le_inv in Near.
    destruct A as [| [t s] |], B as [| [t' s'] |]; try now apply exactly_right.
    + rewrite (Same (Bopp never64)); [split; apply same_event | apply Ha | apply Hb |].
      now rewrite B2R_Babs, B2R_Bopp, Rabs_Ropp, never_is, Rabs_pos_eq by apply bpow_ge_0.
    + exfalso. pose proof (at_far b _ _ Hb) as K. destruct Ha as [_ Ea]. rewrite Ea, B2R_Bopp, Rabs_Ropp, never_is in Near.
      rewrite (Rabs_pos_eq (bpow _ _)) in Near by apply bpow_ge_0. pose proof (Rabs_le_inv _ _ K). lra.
    + exfalso. destruct Ha as [_ Ea], Hb as [_ Eb]. rewrite Ea, Eb, B2R_Bopp, Rabs_Ropp, never_is in Near.
      rewrite (Rabs_pos_eq (bpow _ _)) in Near by apply bpow_ge_0. lra.
    + exfalso. pose proof (at_far a _ _ Ha) as K. destruct Hb as [_ Eb]. rewrite Eb, B2R_Bopp, Rabs_Ropp, never_is in Near.
      rewrite (Rabs_pos_eq (bpow _ _)) in Near by apply bpow_ge_0. pose proof (Rabs_le_inv _ _ K). lra.
    + exfalso. pose proof (at_far a _ _ Ha) as K. destruct Hb as [_ Eb]. rewrite Eb, never_is in Near.
      rewrite (Rabs_pos_eq (bpow _ _)) in Near by apply bpow_ge_0. pose proof (Rabs_le_inv _ _ K). lra.
    + exfalso. destruct Ha as [_ Ea], Hb as [_ Eb]. rewrite Ea, Eb, B2R_Bopp, Rabs_Ropp, never_is in Near.
      rewrite (Rabs_pos_eq (bpow _ _)) in Near by apply bpow_ge_0. lra.
    + exfalso. pose proof (at_far b _ _ Hb) as K. destruct Ha as [_ Ea]. rewrite Ea, never_is in Near.
      rewrite (Rabs_pos_eq (bpow _ _)) in Near by apply bpow_ge_0. pose proof (Rabs_le_inv _ _ K). lra.
    + rewrite (Same never64); [split; apply same_event | apply Ha | apply Hb |].
      now rewrite B2R_Babs, never_is, Rabs_pos_eq by apply bpow_ge_0.
Qed.

(** ** Beyond the limit *)

Theorem beyond64_right c m limit t : stands64 c (At m) -> 0 <= fst m -> beyond64 c limit = true -> fst m <= t ->
  ~ at_least limit t.
Proof.
  intros Hc Hm Hb Ht. apply stands_value in Hc. destruct m as [s b]. pose proof (at_far c s b Hc) as Far.
  destruct Hc as [F [Near [_ Size]]]. cbn [fst] in *. pose proof far_from_never as Big.
  assert (Product : is_finite (Bmult64 (parameter c) less64) = true /\ B2R (Bmult64 (parameter c) less64) <= s).
  { pose proof (Bmult_correct 53 1024 Slab.prec64 Slab.less64 NE (parameter c) less64) as H. rewrite less_is in H.
    change (round radix2 (SpecFloat.fexp 53 1024) (round_mode NE) (B2R (parameter c) * (1 - 8 * u)))
      with (rnd64 (B2R (parameter c) * (1 - 8 * u))) in H.
    assert (Hu : 0 < u <= / 1024) by (split; [apply bpow_gt_0 | apply (bpow_le radix2 (-53) (-10)); lia]).
    assert (Hle : Rabs (B2R (parameter c) * (1 - 8 * u)) <= Rabs (B2R (parameter c)) * 1).
    { rewrite Rabs_mult. apply Rmult_le_compat_l; [apply Rabs_pos |]. apply Rabs_le. lra. }
    rewrite fits in H.
    2:{ apply Rle_trans with (1 := Hle). assert (bpow radix2 300 <= bpow radix2 302) by now apply bpow_le. lra. }
    destruct H as [V [F' _]]. rewrite F in F'. split; [exact F' |]. rewrite V.
    destruct Size as [[Hs Z0] | [[Hlow _] _]].
    { rewrite Z0, Rmult_0_l, round_0 by auto with typeclass_instances. lra. }
    assert (Pos : 0 < B2R (parameter c)).
    { apply Rnot_le_lt. intros N. rewrite (Rabs_left1 (B2R (parameter c))) in Near, Hlow by exact N. apply Rabs_le_inv in Near.
      pose proof (bpow_gt_0 radix2 (-400)). assert (4 * u * - B2R (parameter c) <= / 2 * - B2R (parameter c))
        by (apply Rmult_le_compat_r; lra). lra. }
    rewrite (Rabs_pos_eq (B2R (parameter c))) in Near, Hlow by lra. apply Rabs_le_inv in Near. set (x := B2R (parameter c)) in *.
    assert (Hx : 0 <= x * (1 - 8 * u)) by (apply Rmult_le_pos; lra).
    apply Rle_trans with (1 := Slab.rnd_upper 53 1024 Slab.prec64 _ Hx). rewrite half_ulp.
    change (3 - 1024 - 53)%Z with (-1074)%Z.
    assert (Eta : bpow radix2 (-1074) <= u * x).
    { apply Rle_trans with (u * bpow radix2 (-400)); [| apply Rmult_le_compat_l; lra].
      rewrite <- bpow_plus. now apply bpow_le. }
    assert (0 <= u * u * x) by (repeat apply Rmult_le_pos; lra). lra. }
  destruct Product as [Fp Hp]. unfold beyond64 in Hb. intros Hl.
  apply (less_excludes _ _ t Hb); [| exact Hl]. right. split; [exact Fp | lra].
Qed.

(** ** The line of binary64 *)

Definition line64 : Line.line pr vr := {|
  Line.crossing := crossing64;
  Line.coordinate := binary64;
  Line.value := B2R;
  Line.usable := usable64;
  Line.stands := stands64;
  Line.order := order64;
  Line.order_right := order64_right;
  Line.crosses := crosses64;
  Line.crosses_right := fun i x Hx => or_intror (ex_intro _ i (ex_intro _ x (conj Hx (conj eq_refl eq_refl))));
  Line.begin := start64;
  Line.begin_right := or_introl (conj eq_refl eq_refl);
  Line.still := still64;
  Line.still_right := still_is;
  Line.backwards := backwards64;
  Line.backwards_right := backwards_is
|}.
End Crossings.
