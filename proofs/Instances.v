(** * Instances: what the theorems of Main*.v speak of is there

    A theorem whose premises nothing satisfies says nothing. For each theorem of Main*.v that has premises, what is called
    instance_of_ and its name here is that theorem with all of them discharged, for one scene, one ray, one list or a few
    numbers; tests/proofs/audit.sh sees that it is there, that it has no premise of its own and that it rests on the theorem.

    The scene of all seven shapes (InstanceScene.v) is asked three times: by a ray from outside, by one that starts on the
    sphere, and by shadow rays. tests/proofs/instances.sh compares what is stated here with what durero trace prints. *)
From Coq Require Import ZArith Reals List Bool Lia Lra.
From Flocq Require Generic_fmt FLT Zaux.
From Durero Require Import Toolkit Exacto InstanceScene InstanceSearch.
From Durero Require Whole Triage Surd Search Chain Puntos Trazador ExactoEscena Main MainModels MainText.
Import ListNotations.
Local Open Scope R_scope.

(** ** The search that runs *)

Definition nowhere (e : nat) : bool := false.
Definition on_the_sphere (e : nat) : bool := Nat.eqb e 1.

Lemma from_outside : asked (v3 (-16) 2 1) (v3 8 1 (-1)) nowhere.
Proof. split; [reflexivity | cbn; lia | discriminate]. Qed.
Lemma from_the_sphere : asked (v3 6 0 0) (v3 4 1 1) on_the_sphere.
Proof. split; [reflexivity | cbn; lia | intros e He; apply Nat.eqb_eq in He; subst e; now left]. Qed.
Lemma over_the_sphere : asked (v3 (-16) 2 1) (v3 32 1 (-1)) nowhere.
Proof. split; [reflexivity | cbn; lia | discriminate]. Qed.

(** From (-8, 1, 0.5) along (4, 0.5, -0.5): the sphere is hit, at t and at a point of these bits. *)
Theorem a_ray_from_outside : exists out,
  publishes (v3 (-16) 2 1) (v3 8 1 (-1)) nowhere (Search.Published_hit _ _ (Some out) [1%nat]) /\
  bits_of out = [4608904492295799481; 13836117507917970062; 4610295255361593693; 13819428351128439524]%Z.
Proof.
  eexists; split; [apply (the_search_publishes _ _ _ from_outside); [vm_compute; reflexivity | vm_compute; reflexivity]|].
  vm_compute; reflexivity.
Qed.

(** From (3, 0, 0), which is on the sphere, along (2, 0.5, 0.5): the cylinder. *)
Theorem a_ray_from_the_sphere : exists out,
  publishes (v3 6 0 0) (v3 4 1 1) on_the_sphere (Search.Published_hit _ _ (Some out) [2%nat]) /\
  bits_of out = [4609801162096512617; 4618624889609848629; 4605297562469142121; 4605297562469142121]%Z.
Proof.
  eexists; split; [apply (the_search_publishes _ _ _ from_the_sphere); [vm_compute; reflexivity | vm_compute; reflexivity]|].
  vm_compute; reflexivity.
Qed.

(** The segment from (-8, 1, 0.5) over (16, 0.5, -0.5) is blocked by the sphere; the one over (4, 0.5, -0.5) ends before it,
    and the ray that goes on is blocked. *)
Theorem a_segment_that_is_blocked : blocked (v3 (-16) 2 1) (v3 32 1 (-1)) nowhere true true.
Proof. eapply (the_search_answers _ _ _ over_the_sphere); [vm_compute | ]; reflexivity. Qed.
Theorem a_segment_that_is_not_blocked : blocked (v3 (-16) 2 1) (v3 8 1 (-1)) nowhere true false.
Proof. eapply (the_search_answers _ _ _ from_outside); [vm_compute | ]; reflexivity. Qed.

(** ** The range that is asked for *)

Theorem instance_of_the_range_that_is_asked_is_that_of_the_bounds :
  let p := Whole.vec_over 2 (v3 (-16) 2 1) in let v := Whole.vec_over 2 (v3 8 1 (-1)) in
  let sphere := Whole.shape_over 2 (shape_at 1) in
  Triage.asked_in_range p v sphere = true <-> Triage.in_bounds p v sphere.
Proof. exact (Main.the_range_that_is_asked_is_that_of_the_bounds _ _ _ (all_are_binary64 _ _ _ from_outside 1%nat (or_introl eq_refl))). Qed.

(** ** The steps, and what they answer *)

Definition instance_of_the_recorded_terms_are_steps_that_run := they_run _ _ _ from_outside.
Definition instance_of_the_steps_that_run_are_right := they_are_right _ _ _ from_outside.
Definition instance_of_the_printed_hit_is_the_texts_hit := the_search_of_right_steps_is_right _ _ _ from_the_sphere.
Definition instance_of_the_search_that_runs_publishes_the_texts_hit := the_search_is_right _ _ _ from_the_sphere.
Definition instance_of_the_search_that_runs_answers_shadow_rays_as_the_text := a_segment_that_is_blocked.

(** ** One ray on the scene: the text's answer, the oracle, the steps and the search over a walk *)

Notation s := (scene_of 2 seven).
Notation p := (v3 (-16) 2 1).
Notation v := (v3 8 1 (-1)).
Notation ray := (ExactoEscena.the_ray 2 p v).
Notation none := (fun e => nowhere e = true).
Definition is_there : In 1%nat elements := or_introl eq_refl.
Definition is_a_ray := is_ray _ _ _ from_outside.
Definition are_known := is_known _ _ _ from_outside.
Definition as_described := is_described nowhere.
Definition as_it_stands := proj1 (over_two nowhere 1 is_there).
Definition in_bounds := all_in_range _ _ _ from_outside 1 is_there eq_refl.
Definition is_ordinary := seven_are_ordinary 1 is_there.
Definition as_it_starts := proj2 (over_two nowhere 1 is_there).
Definition the_number := Surd.Surd 1 1 2 3.
Definition is_valid : Surd.valid the_number := conj (Zle_bool_imp_le 0 2 eq_refl) eq_refl.

Definition instance_of_every_question_has_one_answer :=
  MainText.every_question_has_one_answer ray is_a_ray nat s s none the_seven_are_a_scene same_scene are_known.
Definition instance_of_a_hit_names_the_elements_that_attain_it :=
  MainText.a_hit_names_the_elements_that_attain_it ray is_a_ray nat s s none same_scene are_known.
Definition instance_of_no_minimum_iff_the_ray_starts_in_a_segment :=
  MainText.no_minimum_iff_the_ray_starts_in_a_segment ray is_a_ray nat s none the_seven_are_a_scene.
Definition instance_of_first_hit_is_the_least_of_first_hits :=
  MainText.first_hit_is_the_least_of_first_hits ray nat s none the_seven_are_a_scene.
Definition instance_of_executable_first_hit_is_right := MainModels.executable_first_hit_is_right nat 2 p v (asked_of nowhere) eq_refl.
Definition instance_of_executable_first_hit_is_Primera_Interseccion :=
  MainModels.executable_first_hit_is_Primera_Interseccion nat s s 2 none p v (asked_of nowhere) eq_refl the_seven_are_a_scene is_a_ray
    as_described same_scene are_known.
Lemma first_from_outside : first_hit 2 p v (asked_of nowhere) = Exacto.Hit (Surd.Surd 127 (-1) 1279 66) [1%nat].
Proof. vm_compute; reflexivity. Qed.
Definition instance_of_the_judged_bytes_are_the_texts_rounded_once :=
  MainModels.the_judged_bytes_are_the_texts_rounded_once nat s s 2 none p v (asked_of nowhere) Z.sqrt 0 0 0 0 eq_refl the_seven_are_a_scene
    is_a_ray as_described same_scene are_known _ _ first_from_outside.
Definition instance_of_the_executable_rounding_is_that_of_binary64 :=
  MainModels.the_executable_rounding_is_that_of_binary64 Z.sqrt 0 the_number is_valid.
Definition instance_of_the_exact_rounding_ends :=
  MainModels.the_exact_rounding_ends 1 0 1 0 2 0 3 0 (Zle_bool_imp_le 0 2 eq_refl) (fun H => ltac:(discriminate H)).

Definition instance_of_the_decisions_in_lanes_are_right :=
  Main.the_decisions_in_lanes_are_right nat s none (real p) (real v) the_seven_are_a_scene is_a_ray (proj1 in_bounds) 1%nat (real_shape 1%nat) false
    as_it_stands is_ordinary as_it_starts.
Definition instance_of_the_decisions_up_to_a_limit_are_right :=
  Main.the_decisions_up_to_a_limit_are_right nat s none (real p) (real v) the_seven_are_a_scene is_a_ray (proj1 in_bounds) 1%nat (real_shape 1%nat)
    false 5 as_it_stands is_ordinary as_it_starts.

(** ** Numbers *)

Lemma five_is_binary64 : Generic_fmt.generic_format Zaux.radix2 (FLT.FLT_exp (-1074) 53) 5.
Proof.
  replace 5 with (over 2 10) by (unfold over; lra); exact (proj1 (small_is_ordinary 10 eq_refl)).
Qed.

Definition instance_of_the_second_step_is_right :=
  Main.the_second_step_is_right nat s none (real p) (real v) the_seven_are_a_scene is_a_ray (proj1 in_bounds) 1%nat (real_shape 1%nat) false 5
    as_it_stands is_ordinary as_it_starts five_is_binary64.
Definition instance_of_double_double_keeps_sums_and_products_whole :=
  Main.double_double_keeps_sums_and_products_whole 5 5 five_is_binary64 five_is_binary64.

Definition instance_of_a_bundle_is_entered_no_later := MainModels.a_bundle_is_entered_no_later 2 (1 / 4) (1 / 4) (1 / 4) (1 / 4) (1 / 4) (1 / 4)
  (conj (Rle_refl _) (Rle_refl _)) (conj (Rle_refl _) (Rle_refl _)).
Definition instance_of_a_bundle_is_left_no_earlier := MainModels.a_bundle_is_left_no_earlier 2 (1 / 4) (1 / 4) (1 / 4) (1 / 4) (1 / 4) (1 / 4)
  (conj (Rle_refl _) (Rle_refl _)) (conj (Rle_refl _) (Rle_refl _)).

Definition a_sphere := Puntos.of_esfera ray (point 2 (v3 0 0 0)) 3.
Definition instance_of_at_most_two_points_or_a_segment :=
  MainText.at_most_two_points_or_a_segment a_sphere (Trazador.proper_esfera ray (point 2 (v3 0 0 0)) 3).
Definition instance_of_first_hit_of_an_element :=
  MainText.first_hit_of_an_element a_sphere (Trazador.proper_esfera ray (point 2 (v3 0 0 0)) 3).
Definition instance_of_discs_close_cylinders_and_cones :=
  MainText.discs_close_cylinders_and_cones (point 2 (v3 2 0 0)) (point 2 (v3 0 0 0)) 1 1 (direction 2 along_z) 0 (Rle_refl 0).
Definition instance_of_operations_on_tables_commute :=
  fun e t c r d h k abc => MainModels.operations_on_tables_commute nat Nat.eq_dec (tables_of 2 seven) e t c r d h k abc
    (tables_are_right 2 seven seven_once seven_valid).
