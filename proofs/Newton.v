(** * Newton: a root improved by one step, and its error

    Formas.Pairs.newton, of src/trace/rounding-inl.hpp. With δ = T - t the way from the computed t to the root T, σ = A·T + B
    and P the value of the quadratic at t, P = -2σδ + Aδ²: so δ is the quotient -P/(2σ - Aδ), whose divisor is known as
    |δ| is within the error of t. The step adds the quotient to t, exactly. *)
From Coq Require Import Reals ZArith Lra Lia Psatz.
From Flocq Require Import Core.
From Durero Require Import Rounding Quotient Twofold Once.
From Durero Require Formas.
Import Formas.Pairs.
Local Open Scope R_scope.
Local Opaque bpow.

(** Where the slope is known not to be 0, it is more than twice its error. *)
Lemma known_slope_steep t slope a at_t : format (Formas.value slope) -> format (Formas.error slope) ->
  bpow radix2 (-900) <= Formas.error slope -> 0 <= Formas.error a -> 0 <= Formas.error t ->
  known_slope (newton t slope a at_t) = true -> 2 * Formas.error slope < Rabs (Formas.value slope).
Proof.
  intros Fs Fe He Ha Ht; set (E := Formas.error slope) in *; pose proof (bpow_gt_0 radix2 (-900)).
  change (known_slope (newton t slope a at_t)) with (Rlt_bool (rnd (2 * rnd (4503600077730459 * bpow radix2 (-52) *
    rnd (rnd (2 * E) + rnd (rnd (Rabs (Formas.value a) + Formas.error a) * Formas.error t))))) (Rabs (rnd (2 * Formas.value slope)))).
  rewrite !(rnd_double _ Fs), (rnd_double _ Fe), (rnd_double (rnd _)) by apply format_rnd; rewrite Rabs_mult, (Rabs_pos_eq 2) by lra.
  set (w := rnd (rnd (Rabs (Formas.value a) + Formas.error a) * Formas.error t)).
  assert (Hw : 0 <= w).
  { apply rnd_nonneg, Rmult_le_pos; [apply rnd_nonneg; pose proof (Rabs_pos (Formas.value a)); lra | exact Ht]. }
  assert (F2 : format (2 * E)) by (rewrite <- (rnd_double E Fe); apply format_rnd).
  assert (H1 : 2 * E <= rnd (2 * E + w)) by (rewrite <- (rnd_format _ F2) at 1; apply rnd_le; lra).
  pose proof widening as Hc; set (c := 4503600077730459 * _) in *.
  assert (H2 : 2 * E <= rnd (c * rnd (2 * E + w))).
  { rewrite <- (rnd_format _ F2) at 1; apply rnd_le; assert (1 * rnd (2 * E + w) <= c * rnd (2 * E + w)) by (apply Rmult_le_compat_r; lra); lra. }
  destruct (Rlt_bool_spec (2 * rnd (c * rnd (2 * E + w))) (2 * Rabs (Formas.value slope))); [intros _; lra | discriminate].
Qed.

Section Newton.
Variables t slope a : Formas.known R.
Variable at_t : Formas.known twofold.
Notation T_fl := (Formas.value t).
Notation T_error := (Formas.error t).

Record binary64s : Prop := {
  t_binary64 : format T_fl;
  slope_binary64 : format (Formas.value slope) /\ format (Formas.error slope);
  a_binary64 : format (Formas.value a) /\ format (Formas.error a);
  at_binary64 : format (hi (Formas.value at_t)) /\ format (lo (Formas.value at_t)) /\ format (Formas.error at_t);
  errors_least : bpow radix2 (-900) <= Formas.error slope /\ bpow radix2 (-900) <= Formas.error at_t /\
    bpow radix2 (-900) * Rabs (2 * Formas.value slope) <= Formas.error at_t /\ 0 <= Formas.error a }.
Hypothesis binary : binary64s.

(** The quadratic, its root T, and what is known of them. *)
Variables A B C T : R.
Hypothesis root : A * T * T + 2 * B * T + C = 0.
Hypothesis t_near : Rabs (T - T_fl) <= T_error.
Hypothesis slope_near : Rabs (A * T + B - Formas.value slope) <= Formas.error slope.
Hypothesis a_near : Rabs (A - Formas.value a) <= Formas.error a.
Hypothesis at_near : Rabs (A * T_fl * T_fl + 2 * B * T_fl + C - whole (Formas.value at_t)) <= Formas.error at_t.

Let delta := T - T_fl.
Let divisor := 2 * (A * T + B) - A * delta.
Let divisor_fl := rnd (2 * Formas.value slope).
Let divisor_error := rnd (4503600077730459 * bpow radix2 (-52) * rnd (rnd (2 * Formas.error slope) +
  rnd (rnd (Rabs (Formas.value a) + Formas.error a) * T_error))).
Let value_fl := rnd (hi (Formas.value at_t) + lo (Formas.value at_t)).
Let value_error := rnd (Formas.error at_t + rnd (bpow radix2 (-52) * Rabs value_fl)).
Let step := Formas.quotient (- value_fl) value_error divisor_fl divisor_error.

Local Opaque round.
Lemma newton_is : newton t slope a at_t =
  Improved (Rlt_bool (rnd (2 * divisor_error)) (Rabs divisor_fl)) (two_sum T_fl (Formas.value step)) (Formas.error step).
Proof. reflexivity. Qed.
Local Transparent round.

Lemma divisor_near : Rabs (divisor_fl - divisor) <= divisor_error.
Proof.
  destruct (slope_binary64 binary) as [Fs Fse], (a_binary64 binary) as [Fa Fae], (errors_least binary) as (Hs & _ & _ & Ha).
  pose proof widening as Hc; unfold divisor_error; set (c := 4503600077730459 * _) in *.
  unfold divisor_fl; rewrite !rnd_double by assumption; set (S := Formas.error slope) in *.
  pose proof (bpow_gt_0 radix2 (-900)); assert (HS : bpow radix2 (-1000) <= S) by (apply Rle_trans with (2 := Hs), bpow_le; lia).
  pose proof (least_below (-1000) S ltac:(lia) HS) as Hz; pose proof (bpow_gt_0 radix2 (-1074)); set (z := tiny) in *.
  assert (HT : 0 <= T_error) by (apply Rle_trans with (2 := t_near), Rabs_pos).
  set (V := Rabs (Formas.value a) + Formas.error a) in *.
  assert (HV : 0 <= V) by (unfold V; pose proof (Rabs_pos (Formas.value a)); lra).
  pose proof (rnd_low_sum (Rabs (Formas.value a)) (Formas.error a) (generic_format_abs _ _ _ Fa) Fae HV) as E1; fold V in E1.
  pose proof (rnd_nonneg V HV) as HV'; pose proof (Rmult_le_pos _ _ HV' HT) as HVT'.
  pose proof (rnd_low_any _ HVT') as E2; fold z in E2; pose proof (rnd_nonneg _ HVT') as H2.
  assert (E1' : (1 - e12) * (V * T_error) <= rnd V * T_error).
  { rewrite <- Rmult_assoc; apply Rmult_le_compat_r; [exact HT | exact E1]. }
  pose proof (Rmult_le_pos _ _ HV HT) as HVT; set (VT := V * T_error) in *; set (VT' := rnd V * T_error) in *.
  pose proof (rnd_low_sum (2 * S) (rnd VT') (eq_ind _ (fun x => generic_format radix2 _ x) (format_rnd (2 * S)) _
    (rnd_double S Fse)) (format_rnd _) ltac:(lra)) as E3.
  set (s := rnd (2 * S + rnd VT')) in *; assert (Hs0 : 0 <= s) by lra.
  assert (Hcs : (1 + / 16777216) * s <= c * s) by (apply Rmult_le_compat_r; lra).
  pose proof (rnd_low_any (c * s) ltac:(lra)) as E4; fold z in E4.
  assert (Hdelta : Rabs (A * delta) <= VT).
  { unfold VT; rewrite Rabs_mult; apply Rmult_le_compat; [apply Rabs_pos | apply Rabs_pos | | exact t_near].
    unfold V; replace A with ((A - Formas.value a) + Formas.value a) by ring; apply Rle_trans with (1 := Rabs_triang _ _); lra. }
  apply Rle_trans with (2 * S + VT); [|lra].
  unfold divisor; replace (2 * Formas.value slope - (2 * (A * T + B) - A * delta))
    with (A * delta - 2 * (A * T + B - Formas.value slope)) by ring.
  apply Rabs_le_inv in Hdelta; pose proof slope_near as Hn; apply Rabs_le_inv in Hn; apply Rabs_le; fold S in Hn; lra.
Qed.

Lemma value_near : Rabs (- value_fl - - (A * T_fl * T_fl + 2 * B * T_fl + C)) <= slack * value_error
  /\ bpow radix2 (-900) <= value_error /\ bpow radix2 (-900) * Rabs divisor_fl <= value_error.
Proof.
  destruct (at_binary64 binary) as (Fh & Fl & Fe), (errors_least binary) as (_ & He & Hr' & _), (slope_binary64 binary) as [Fs _].
  destruct (sum_lacks _ _ Fh Fl) as [_ Hlost]; fold value_fl in Hlost; unfold value_error; set (E := Formas.error at_t) in *.
  set (r := Rabs value_fl) in *; assert (Hr : 0 <= r) by apply Rabs_pos; pose proof (u_part r Hr) as Hur.
  pose proof (u_part _ (proj1 Hur)) as Huur.
  pose proof (bpow_gt_0 radix2 (-900)); pose proof (least_below (-900) E ltac:(lia) He) as Hz; set (z := tiny) in *.
  pose proof (rnd_low_any (bpow radix2 (-52) * r) ltac:(rewrite two_u; lra)) as E1; rewrite two_u in E1 at 1; fold z in E1.
  pose proof (rnd_nonneg (bpow radix2 (-52) * r) ltac:(rewrite two_u; lra)) as H1.
  pose proof (rnd_low_sum E (rnd (bpow radix2 (-52) * r)) Fe (format_rnd _) ltac:(lra)) as E2; split.
  - pose proof at_near as Hn; unfold whole in Hn; fold E in Hn; apply Rabs_le_inv in Hn, Hlost; apply Rabs_le; lra.
  - assert (HE : E <= rnd (E + rnd (bpow radix2 (-52) * r))).
    { rewrite <- (rnd_format E Fe) at 1; apply rnd_le; lra. }
    split; [lra|]; unfold divisor_fl; rewrite (rnd_double _ Fs); lra.
Qed.

(** The pair is within its error of the root. *)
Theorem newton_near : let n := newton t slope a at_t in known_slope n = true ->
  Rabs (T - whole (better n)) <= better_error n /\ pair (better n) /\ format (better_error n)
  /\ bpow radix2 (-900) <= better_error n.
Proof.
  rewrite newton_is; cbn [known_slope better better_error]; intros Hk.
  assert (Hknown : 2 * divisor_error < Rabs divisor_fl).
  { rewrite <- (rnd_double divisor_error) by apply format_rnd.
    destruct (Rlt_bool_spec (rnd (2 * divisor_error)) (Rabs divisor_fl)); [assumption | discriminate]. }
  destruct (slope_binary64 binary) as [Fs _].
  destruct value_near as (Hv & Hleast & Hratio).
  destruct (quotient_bound_any_with_slack _ _ value_error divisor divisor_fl divisor_error (format_rnd _) (format_rnd _) (format_rnd _)
    Hleast Hratio Hv divisor_near Hknown) as (Hq & Hq0 & Fq & Fqe); fold step in Hq, Hq0, Fq, Fqe.
  destruct (two_sum_exact _ _ (t_binary64 binary) Fq) as [Hp Hw]; split; [|now split].
  assert (Hd : divisor <> 0).
  { intros Z0; pose proof divisor_near as Hn; rewrite Z0, Rminus_0_r in Hn.
    pose proof (Rabs_pos divisor_fl); assert (0 <= divisor_error) by (apply Rle_trans with (2 := Hn), Rabs_pos); lra. }
  rewrite Hw; replace (T - (T_fl + Formas.value step)) with (- (Formas.value step - delta)) by (unfold delta; ring).
  rewrite Rabs_Ropp; replace delta with (- (A * T_fl * T_fl + 2 * B * T_fl + C) / divisor); [exact (near_within _ _ Hq)|].
  apply Rmult_eq_reg_r with divisor; [|exact Hd]; unfold Rdiv; rewrite Rmult_assoc, Rinv_l, Rmult_1_r by exact Hd.
  unfold divisor, delta; replace C with (- (A * T * T + 2 * B * T)) by lra; ring.
Qed.
End Newton.
