(** * Instances: what the theorems of Main*.v speak of is there

    A theorem whose premises nothing satisfies says nothing. For each theorem of Main*.v that has premises, what is called
    instance_of_ and its name here is that theorem with all of them discharged, for one scene, one ray, one list or a few
    numbers; tests/proofs/audit.sh sees that it is there, that it has no premise of its own and that it rests on the theorem.
    [without_instance.txt] lists those that have none yet; that list only gets shorter.

    The scene of all seven shapes (InstanceScene.v) is asked three times: by a ray from outside, by one that starts on the
    sphere, and by shadow rays. tests/proofs/instances.sh compares what is stated here with what durero trace prints. *)
From Coq Require Import ZArith Reals List Bool Lia Lra.
From Durero Require Import Toolkit Exacto InstanceScene InstanceSearch.
From Durero Require Whole Triage Surd Search Chain Main MainModels MainText.
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
