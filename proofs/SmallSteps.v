(** The sign of a polynomial of degree two after a place, for a while.

    same_sign x y   == x and y are both below 0, both above it, or both 0
    quadratic f     == f is such a polynomial *)
From Coq Require Import Reals Lra List.
From Durero Require Import Toolkit Allotments.
Local Open Scope R_scope.

(** A polynomial of degree two keeps its sign for a while after each place, and there the sign of the place if it has
    one. *)
Definition same_sign (x y : R) : Prop := (x < 0 <-> y < 0) /\ (x > 0 <-> y > 0).
Definition quadratic (f : R -> R) : Prop := exists A B C, forall t, f t = A * t * t + B * t + C.

Lemma same_sign_of s x y : s > 0 -> same_sign (s * x) (s * y) -> same_sign x y.
Proof.
  intros Hs. unfold same_sign.
  assert (N : forall z, s * z < 0 <-> z < 0).
  { intros z. pose proof (Rmult_lt_0_compat s z). pose proof (Rmult_lt_0_compat s (- z)).
    destruct (Rtotal_order z 0) as [? | [-> | ?]]; split; lra. }
  assert (P : forall z, s * z > 0 <-> z > 0).
  { intros z. pose proof (Rmult_lt_0_compat s z). pose proof (Rmult_lt_0_compat s (- z)).
    destruct (Rtotal_order z 0) as [? | [-> | ?]]; split; lra. }
  now rewrite !N, !P.
Qed.

(** c + b·s + a·s² has the sign of its first coefficient other than 0, for all small s > 0. *)
Lemma small_steps a b c : exists e, e > 0 /\ (forall s, 0 < s < e -> same_sign (first_of c (first_of b a)) (c + b * s + a * s * s)).
Proof.
  pose proof (Rabs_pos a) as Pa. pose proof (Rabs_pos b) as Pb.
  assert (Bound : forall x s, 0 <= s -> - (Rabs x * s) <= x * s <= Rabs x * s).
  { intros x s Hs. pose proof (Rle_abs x). pose proof (Rle_abs (- x)). rewrite Rabs_Ropp in *.
    split; [| now apply Rmult_le_compat_r].
    replace (- (Rabs x * s)) with ((- Rabs x) * s) by ring. apply Rmult_le_compat_r; lra. }
  unfold first_of. destruct (Req_EM_T c 0) as [-> | Nc].
  - destruct (Req_EM_T b 0) as [-> | Nb].
    + exists 1. split; [lra |]. intros s Hs. assert (0 < s * s) by (apply Rmult_lt_0_compat; lra).
      apply same_sign_of with (/ (s * s)); [now apply Rinv_0_lt_compat |]. unfold same_sign.
      replace (/ (s * s) * (0 + 0 * s + a * s * s)) with a by (field; lra).
      assert (0 < / (s * s)) by now apply Rinv_0_lt_compat.
      pose proof (Rmult_lt_0_compat (/ (s * s)) a). pose proof (Rmult_lt_0_compat (/ (s * s)) (- a)).
      destruct (Rtotal_order a 0) as [? | [-> | ?]]; split; split; lra.
    + pose proof (Rabs_pos_lt b Nb) as Hb. exists (Rabs b / (Rabs a + 1)).
      split; [apply Rdiv_lt_0_compat; lra |]. intros s [Hs Hlt].
      apply (Rmult_lt_compat_r (Rabs a + 1)) in Hlt; [| lra].
      replace (Rabs b / (Rabs a + 1) * (Rabs a + 1)) with (Rabs b) in Hlt by (field; lra).
      pose proof (Bound a s ltac:(lra)) as Ba.
      replace (0 + b * s + a * s * s) with (s * (b + a * s)) by ring.
      apply same_sign_of with (/ s); [now apply Rinv_0_lt_compat |].
      replace (/ s * (s * (b + a * s))) with (b + a * s) by (field; lra).
      assert (0 < / s) by now apply Rinv_0_lt_compat.
      pose proof (Rmult_lt_0_compat (/ s) b). pose proof (Rmult_lt_0_compat (/ s) (- b)).
      unfold same_sign. unfold Rabs in Hlt at 2. unfold Rabs in Hb. destruct (Rcase_abs b); split; split; lra.
  - pose proof (Rabs_pos_lt c Nc) as Hc. exists (Rmin 1 (Rabs c / (Rabs a + Rabs b + 1))).
    assert (Q : Rabs c / (Rabs a + Rabs b + 1) > 0) by (apply Rdiv_lt_0_compat; lra).
    split; [apply Rmin_glb_lt; lra |]. intros s [Hs Hlt].
    assert (S1 : s < 1) by (eapply Rlt_le_trans; [exact Hlt | apply Rmin_l]).
    assert (S2 : s < Rabs c / (Rabs a + Rabs b + 1)) by (eapply Rlt_le_trans; [exact Hlt | apply Rmin_r]).
    apply (Rmult_lt_compat_r (Rabs a + Rabs b + 1)) in S2; [| lra].
    replace (Rabs c / (Rabs a + Rabs b + 1) * (Rabs a + Rabs b + 1)) with (Rabs c) in S2 by (field; lra).
    pose proof (Bound a (s * s) ltac:(apply Rmult_le_pos; lra)) as Ba. pose proof (Bound b s ltac:(lra)) as Bb.
    assert (SS : Rabs a * (s * s) <= Rabs a * s).
    { apply Rmult_le_compat_l; [exact Pa |]. rewrite <- (Rmult_1_r s) at 3. apply Rmult_le_compat_l; lra. }
    replace (a * s * s) with (a * (s * s)) by ring. unfold same_sign.
    unfold Rabs in S2 at 3. unfold Rabs in Hc. destruct (Rcase_abs c); split; split; lra.
Qed.

Lemma sign_after f m : quadratic f -> exists e x, e > 0 /\ (f m < 0 -> x < 0) /\ (f m > 0 -> x > 0) /\
  forall s, m < s < m + e -> same_sign x (f s).
Proof.
  intros [A [B [C Hf]]]. destruct (small_steps A (2 * A * m + B) (f m)) as [e [He H]].
  exists e, (first_of (f m) (first_of (2 * A * m + B) A)). split; [exact He |].
  split; [| split]; [unfold first_of; destruct (Req_EM_T (f m) 0); lra .. |].
  intros s Hs. replace (f s) with (f m + (2 * A * m + B) * (s - m) + A * (s - m) * (s - m)); [apply H; lra |].
  rewrite !Hf. ring.
Qed.

(** The same for finitely many. *)
Lemma signs_after {I : Type} (F : I -> R -> R) (l : list I) m : (forall i, quadratic (F i)) ->
  exists e, e > 0 /\ forall i s u, In i l -> m < s < m + e -> m < u < m + e ->
    same_sign (F i s) (F i u) /\ (F i m < 0 -> F i s < 0) /\ (F i m > 0 -> F i s > 0).
Proof.
  intros HF. induction l as [| i l [e [He IH]]]; [exists 1; split; [lra | easy] |].
  destruct (sign_after (F i) m (HF i)) as [e' [x [He' [Hn [Hp H]]]]].
  exists (Rmin e e'). split; [now apply Rmin_glb_lt |]. intros j s u Hj Hs Hu.
  pose proof (Rmin_l e e'). pose proof (Rmin_r e e'). destruct Hj as [<- | Hj]; [| apply IH; [exact Hj | lra | lra]].
  pose proof (H s ltac:(lra)) as Ss. pose proof (H u ltac:(lra)) as Su. unfold same_sign in *. tauto.
Qed.
