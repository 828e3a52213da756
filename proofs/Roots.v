(** * Roots: those of a quadratic A t² + 2B t + C by x = -(B ± √D), over the reals

    They are x/A and C/x. Which of them comes first is told by the sign that was taken before the root of D, and that of A;
    and where A may be 0 the root x/A, if it is ahead, is behind C/x. *)
From Coq Require Import Reals Lra Bool.
From Flocq Require Import Core.
Local Open Scope R_scope.

Section Roots.
Variables A B C r x : R.
Variable plus : bool.
Hypothesis r_square : r * r = B * B - A * C.
Hypothesis r_positive : 0 < r.
Hypothesis x_is : x = - (B + if plus then r else - r).
Hypothesis x_not_zero : x <> 0.

Lemma x_solves : x * x + 2 * B * x + A * C = 0.
Proof. rewrite x_is; destruct plus; lra. Qed.

Theorem exact_roots : A <> 0 -> (forall t, A * t * t + 2 * B * t + C = 0 <-> t = x / A \/ t = C / x) /\
  if eqb (Rlt_bool 0 A) plus then x / A < C / x else C / x < x / A.
Proof.
  intros HA0; pose proof x_solves as Hx; set (a := x / A); set (c := C / x).
  assert (Hac : a * c = C / A) by (unfold a, c; field; auto).
  assert (Hsum : a + c = - (2 * B) / A).
  { unfold a, c; replace (- (2 * B) / A) with ((x * x + A * C) / (A * x)).
    - field; auto.
    - replace (x * x + A * C) with (- (2 * B) * x) by lra; field; auto. }
  split.
  - intros t; replace (A * t * t + 2 * B * t + C) with (A * ((t - a) * (t - c))).
    + split; [|intros [-> | ->]; ring]; intros Ht; apply Rmult_integral in Ht as [Ht|Ht]; [contradiction|].
      apply Rmult_integral in Ht as [Ht|Ht]; [left | right]; lra.
    + replace ((t - a) * (t - c)) with (t * t - (a + c) * t + a * c) by ring; rewrite Hac, Hsum; field; auto.
  - assert (Hdiff : A * (c - a) = 2 * (if plus then r else - r)).
    { replace (A * (c - a)) with (A * (a + c) - 2 * (A * a)) by ring; rewrite Hsum.
      replace (A * (- (2 * B) / A)) with (- (2 * B)) by (field; auto).
      replace (A * a) with x by (unfold a; field; auto); rewrite x_is; destruct plus; lra. }
    destruct (Rlt_bool_spec 0 A), plus; cbn [eqb]; apply Rnot_le_lt; intros Hle.
    + pose proof (Rmult_le_compat_l A (c - a) 0 ltac:(lra) ltac:(lra)); lra.
    + pose proof (Rmult_le_compat_l A 0 (c - a) ltac:(lra) ltac:(lra)); lra.
    + pose proof (Rmult_le_compat_neg_l A 0 (c - a) ltac:(lra) ltac:(lra)); lra.
    + pose proof (Rmult_le_compat_neg_l A (c - a) 0 ltac:(lra) ltac:(lra)); lra.
Qed.

(** The roots are x/A, where A is not 0, and C/x. *)
Theorem roots_are t : A * t * t + 2 * B * t + C = 0 <-> A * t = x \/ t = C / x.
Proof.
  pose proof x_solves as E; assert (P : (A * t - x) * (x * t - C) = x * (A * t * t + 2 * B * t + C)).
  { replace ((A * t - x) * (x * t - C)) with (x * (A * t * t) - (x * x + A * C) * t + x * C) by ring.
    replace (x * x + A * C) with (- (2 * B * x)) by lra; ring. }
  split.
  - intros R0; rewrite R0, Rmult_0_r in P; apply Rmult_integral in P as [P|P]; [left; lra | right].
    apply Rmult_eq_reg_l with x; [field_simplify; lra | exact x_not_zero].
  - intros R0; assert (Z0 : (A * t - x) * (x * t - C) = 0).
    { destruct R0 as [R0| ->]; [rewrite R0; ring|]; replace (x * (C / x)) with C by (field; exact x_not_zero); ring. }
    rewrite Z0 in P; apply Rmult_eq_reg_l with x; [lra | exact x_not_zero].
Qed.

Theorem root_of_C_first t : (if plus then x < 0 else 0 < x) -> A * t = x -> 0 < t -> C / x <= t.
Proof.
  intros Hsign HA Hpos; pose proof x_solves as E; assert (HAC : A * (C / x) = - x - 2 * B).
  { replace (A * (C / x)) with (A * C / x) by (unfold Rdiv; ring); replace (A * C) with ((- x - 2 * B) * x) by lra.
    field; exact x_not_zero. }
  assert (Hd : A * (t - C / x) = 2 * (x + B)) by (rewrite Rmult_minus_distr_l, HA, HAC; ring).
  apply Rnot_lt_le; intros Hlt; destruct plus.
  - assert (HA0 : A < 0) by (apply Rnot_le_lt; intros Hle; pose proof (Rmult_le_pos A t Hle ltac:(lra)); lra).
    pose proof (Rmult_le_compat_neg_l A (t - C / x) 0 ltac:(lra) ltac:(lra)); lra.
  - assert (HA0 : 0 < A) by (apply Rnot_le_lt; intros Hle; pose proof (Rmult_le_compat_neg_l A 0 t Hle ltac:(lra)); lra).
    pose proof (Rmult_le_compat_l A (t - C / x) 0 ltac:(lra) ltac:(lra)); lra.
Qed.
End Roots.
