(** * InstancesNewton: instances of the theorems about Newton's step

    It goes on from Instances.v, and tests/proofs/audit.sh reads it in the same way. *)
From Coq Require Import ZArith Reals List Bool Lra.
From Flocq Require Import Core.
From Durero Require Import Rounding Vectors Exacto InstanceScene InstanceSearch InstanceDyadic.
From Durero Require Twofold Formas Newton Puntos Tipos Steps Triage Whole Main Instances.
Local Open Scope R_scope.

(** ** A step from 3/2 towards the root √2 of t² - 2: the root and the slope are known within 1/8, the value 1/4 within 2^-80 *)

Notation about n e error := (Formas.Known (D n e) error).
Notation eighth := (D 1 (-3)).
Definition start : Formas.known R := about 3 (-1) eighth.
Definition slope : Formas.known R := about 3 (-1) eighth.
Definition leading : Formas.known R := about 1 0 (D 0 0).
Definition at_start : Formas.known Formas.Pairs.twofold := Formas.Known (Formas.Pairs.Twofold (D 1 (-2)) (D 0 0)) (D 1 (-80)).

Lemma they_are_binary64 : Newton.binary64s start slope leading at_start.
Proof.
  constructor; unfold start, slope, leading, at_start; projected; repeat split; try (now apply exact_format);
    apply at_most; computes.
Qed.
Lemma the_root_of_two : 1 * sqrt 2 * sqrt 2 + 2 * 0 * sqrt 2 + -2 = 0.
Proof. pose proof (sqrt_sqrt 2 ltac:(lra)); lra. Qed.
Lemma the_root_is_near : Rabs (sqrt 2 - D 3 (-1)) <= eighth.
Proof.
  assert (L : 11 / 8 <= sqrt 2) by (rewrite <- (sqrt_square (11 / 8)) by lra; apply sqrt_le_1_alt; lra).
  assert (H : sqrt 2 <= 13 / 8) by (rewrite <- (sqrt_square (13 / 8)) by lra; apply sqrt_le_1_alt; lra).
  unfold D; cbn; apply Rabs_le; lra.
Qed.
Lemma the_slope_is_near : Rabs (1 * sqrt 2 + 0 - D 3 (-1)) <= eighth.
Proof. replace (1 * sqrt 2 + 0) with (sqrt 2) by ring; exact the_root_is_near. Qed.
Lemma the_leading_is_near : Rabs (1 - D 1 0) <= D 0 0.
Proof. apply at_most; computes. Qed.
Lemma the_value_is_near :
  Rabs (1 * D 3 (-1) * D 3 (-1) + 2 * 0 * D 3 (-1) + -2 - Twofold.whole (Formas.Pairs.Twofold (D 1 (-2)) (D 0 0))) <= D 1 (-80).
Proof. unfold Twofold.whole; projected; apply at_most; computes. Qed.
Lemma the_slope_is_known : Formas.Pairs.known_slope (Formas.Pairs.newton start slope leading at_start) = true.
Proof.
  cbv beta delta [Formas.Pairs.newton start slope leading at_start]; projected.
  cbv beta iota zeta delta [Formas.Pairs.known_slope]; computes.
Qed.
Definition instance_of_an_improved_root_is_within_its_error := Main.an_improved_root_is_within_its_error start slope leading at_start 1 0 (-2)
  (sqrt 2) they_are_binary64 the_root_of_two the_root_is_near the_slope_is_near the_leading_is_near the_value_is_near the_slope_is_known.

(** ** The quadratic of the sphere of the seven shapes and of the ray from (-8, 0, 0) along x, at 11/2: its root is 5 *)

Notation p := (v3 (-16) 0 0).
Notation v := (v3 2 0 0).
Notation nowhere := Instances.nowhere.
Lemma along_the_axis : asked p v nowhere.
Proof. split; [reflexivity | cbn; intros (N & _); discriminate N | discriminate]. Qed.
Notation the_sphere := (Whole.shape_over 2 (shape_at 1)).
Notation quadratic := (Triage.text_of (Whole.vec_over 2 p) (Whole.vec_over 2 v) the_sphere).
Lemma five_is_a_root : Puntos.value quadratic 5 = 0 /\ Puntos.cA quadratic * 5 + Puntos.cB quadratic = -3.
Proof. unfold Puntos.value; cbn; unfold Tipos.sq, Tipos.dot; cbn; unfold over; split; lra. Qed.
Lemma it_is_not_touched : Puntos.cA quadratic * 5 + Puntos.cB quadratic <> 0.
Proof. rewrite (proj2 five_is_a_root); lra. Qed.
Definition at_it := all_in_range p v nowhere along_the_axis 1 (or_introl eq_refl) eq_refl.
Definition instance_of_the_quadratic_at_a_root_is_within_its_error :=
  Main.the_quadratic_at_a_root_is_within_its_error nat (scene_of 2 seven) (Whole.vec_over 2 p) (Whole.vec_over 2 v) the_seven_are_a_scene
    (proj1 at_it) 1%nat the_sphere false (D 11 (-1)) 5 (proj1 (over_two nowhere 1 (or_introl eq_refl)))
    (seven_are_ordinary 1 (or_introl eq_refl)) (exact_format 11 (-1) eq_refl) (IZR_lt 0 5 eq_refl) (proj1 five_is_a_root) it_is_not_touched.
