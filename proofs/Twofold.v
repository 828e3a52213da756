(** * Twofold: what double-double keeps exactly

    Formas.Pairs has the operations of src/trace/double_double-inl.hpp. A sum, and a product that does not underflow, is
    kept whole by its two parts; the second is at most half a unit in the last place of the first, so that in what is
    computed of pairs the roundings are of second parts.

    whole x     == the number that a pair stands for
    pair x      == x is a pair of binary64 whose second part is small, u of the first *)
From Coq Require Import Reals ZArith Lra Lia Psatz.
From Flocq Require Import Core Relative Plus_error Mult_error Pff2Flocq.
From Durero Require Import Rounding.
From Durero Require Formas.
Import Formas.Pairs.
Local Open Scope R_scope.
Local Opaque bpow.

Definition whole (x : twofold) : R := hi x + lo x.
Definition pair (x : twofold) : Prop := format (hi x) /\ format (lo x) /\ Rabs (lo x) <= u * Rabs (hi x).

Local Instance prec53 : Prec_gt_0 53 := eq_refl.

Lemma even_of_opposite n : negb (Z.even n) = negb (negb (Z.even (- (n + 1)))).
Proof. rewrite Z.even_opp, Z.even_add; now destruct (Z.even n). Qed.

Lemma rnd_opp x : rnd (- x) = - rnd x.
Proof. apply (round_N_opp_sym (-1074) 53); exact even_of_opposite. Qed.

(** What a rounded sum lacks is a binary64, and small beside it. *)
Lemma sum_lacks a b : format a -> format b ->
  format (a + b - rnd (a + b)) /\ Rabs (a + b - rnd (a + b)) <= u * Rabs (rnd (a + b)).
Proof.
  intros Fa Fb; split.
  - replace (a + b - rnd (a + b)) with (- (rnd (a + b) - (a + b))) by ring; apply generic_format_opp.
    now apply plus_error; auto with typeclass_instances.
  - destruct (FLT_plus_error_N_round_ex radix2 (-1074) 53 (fun n => negb (Z.even n)) a b Fa Fb) as (e & He & E).
    rewrite E at 1; replace (rnd (a + b) * (1 + e) - rnd (a + b)) with (e * rnd (a + b)) by ring.
    rewrite Rabs_mult; apply Rmult_le_compat_r; [apply Rabs_pos | rewrite <- half_ulp; exact He].
Qed.

Lemma pair_of_sum a b l : format a -> format b -> rnd (a + b) + l = a + b ->
  pair (Twofold (rnd (a + b)) l) /\ whole (Twofold (rnd (a + b)) l) = a + b.
Proof.
  intros Fa Fb E; destruct (sum_lacks a b Fa Fb) as [F L]; replace (a + b - rnd (a + b)) with l in * by lra.
  split; [split; [apply format_rnd | now split] | exact E].
Qed.

(** Knuth's sum of any two, and Dekker's of two in the order of their sizes. *)
Theorem two_sum_exact a b : format a -> format b -> pair (two_sum a b) /\ whole (two_sum a b) = a + b.
Proof.
  intros Fa Fb; apply pair_of_sum; auto.
  exact (TwoSum_correct (-1074) 53 _ ltac:(lia) ltac:(lia) even_of_opposite a b Fa Fb).
Qed.

Theorem fast_two_sum_exact a b : format a -> format b -> a = 0 \/ Rabs b <= Rabs a ->
  pair (fast_two_sum a b) /\ whole (fast_two_sum a b) = a + b.
Proof.
  intros Fa Fb H; apply pair_of_sum; auto; destruct H as [-> | H].
  - rewrite Rplus_0_l, Rminus_0_r, (rnd_format (rnd b)), Rminus_diag_eq, rnd_0 by
      (apply format_rnd || now rewrite (rnd_format b)); now rewrite rnd_format, Rplus_0_r.
  - pose proof (Fast2Sum_correct (-1074) 53 _ ltac:(lia) ltac:(lia) even_of_opposite a b Fa Fb H) as E.
    replace (a - rnd (a + b)) with (- (rnd (a + b) - a)) in E by ring; rewrite rnd_opp in E; exact E.
Qed.

(** ** Products *)

(** A product that is an integer times 2^-969 lacks a binary64 when it is rounded. *)
Lemma product_lacks a b : format a -> format b -> grid (-969) (a * b) ->
  format (a * b - rnd (a * b)) /\ Rabs (a * b - rnd (a * b)) <= u * Rabs (rnd (a * b)).
Proof.
  intros Fa Fb G; split.
  - replace (a * b - rnd (a * b)) with (- (rnd (a * b) - a * b)) by ring; apply generic_format_opp.
    apply mult_error_FLT; auto with typeclass_instances; intros N.
    change (-1074 + 2 * 53 - 1)%Z with (-969)%Z; now apply grid_at_least.
  - destruct (Req_dec (a * b) 0) as [->|N]; [rewrite rnd_0, Rminus_0_r, Rabs_R0; lra|].
    rewrite Rabs_minus_sym, <- half_ulp.
    apply (relative_error_N_FLT_round radix2 (-1074) 53); [exact eq_refl|].
    apply Rle_trans with (2 := grid_at_least _ _ G N); apply bpow_le; lia.
Qed.

Theorem two_prod_exact a b : format a -> format b -> grid (-969) (a * b) ->
  pair (two_prod a b) /\ whole (two_prod a b) = a * b.
Proof.
  intros Fa Fb G; destruct (product_lacks a b Fa Fb G) as [F L]; unfold two_prod, pair, whole; cbn [hi lo].
  rewrite (rnd_format (a * b - rnd (a * b))) by assumption; split; [split; [apply format_rnd | now split] | ring].
Qed.

(** Without a fused operation: the same two numbers. *)
Theorem two_prod_of_halves_is_two_prod a b : format a -> format b -> grid (-969) (a * b) ->
  two_prod_of_halves a b = two_prod a b.
Proof.
  intros Fa Fb G.
  assert (Hb : a * b = 0 \/ bpow radix2 (-1074 + 2 * 53 - 1) <= Rabs (a * b)).
  { destruct (Req_dec (a * b) 0) as [Z0|N]; [now left | right; now apply grid_at_least]. }
  destruct (Dekker radix2 (-1074) 53 (fun n => negb (Z.even n)) ltac:(lia) ltac:(lia) a b Fa Fb (or_introl eq_refl))
    as [E _]; specialize (E Hb); change (53 - Z.div2 53)%Z with 27%Z in E.
  replace (bpow radix2 27 + 1) with (134217729 * bpow radix2 0) in E by
    (replace (bpow radix2 27) with 134217728 by reflexivity; replace (bpow radix2 0) with 1 by reflexivity; ring).
  assert (Hs : forall x, rnd (x - rnd (x * (134217729 * bpow radix2 0))) + rnd (x * (134217729 * bpow radix2 0)) =
    rnd (134217729 * bpow radix2 0 * x) - rnd (rnd (134217729 * bpow radix2 0 * x) - x)).
  { intros x; rewrite (Rmult_comm x); set (p := rnd (134217729 * bpow radix2 0 * x)); replace (x - p) with (- (p - x)) by ring; rewrite rnd_opp; ring. }
  rewrite !Hs in E; unfold two_prod_of_halves, two_prod; f_equal.
  rewrite (rnd_format (a * b - rnd (a * b))) by (now apply product_lacks).
  match type of E with _ = _ + ?l => replace (a * b - rnd (a * b)) with l by lra end.
  set (x := rnd (rnd (134217729 * bpow radix2 0 * a) - rnd (rnd (134217729 * bpow radix2 0 * a) - a))).
  set (y := rnd (rnd (134217729 * bpow radix2 0 * b) - rnd (rnd (134217729 * bpow radix2 0 * b) - b))).
  now rewrite (Rplus_comm (- rnd (a * b))).
Qed.

Theorem sums_and_products_whole a b : format a -> format b -> whole (two_sum a b) = a + b
  /\ (a = 0 \/ Rabs b <= Rabs a -> whole (fast_two_sum a b) = a + b)
  /\ (grid (-969) (a * b) -> whole (two_prod a b) = a * b /\ two_prod_of_halves a b = two_prod a b).
Proof.
  intros Fa Fb; split; [now apply two_sum_exact | split; [intros H; now apply fast_two_sum_exact|]].
  intros G; split; [now apply two_prod_exact | now apply two_prod_of_halves_is_two_prod].
Qed.
