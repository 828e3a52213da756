(** * InstancesHistory: the theorems about changes and histories, on the seven shapes

    The scene is that of InstanceScene.v, in which 1 is a sphere, 2 a cylinder, 4 a truncated cone and 7 a triangle.

    ball, beside        == a scene of one sphere, and the mesh of two triangles beside it
    dressed             == the seven; the sphere is in the only group and has the only material
    begun, edits        == a history that begins with the seven; a cone named 8 is added and the cylinder removed *)
From Coq Require Import Reals List Lia Lra.
From Durero Require Import Toolkit Especificacion Escena Operaciones Exacto InstanceScene InstanceSearch InstancesText.
From Durero Require Retrieve Malla Meshes Cambios Changes Vista Historia Transactions InstancesMeshes MainText MainHistory.
Import ListNotations.
Local Open Scope R_scope.
Local Open Scope zed_scope.

(** ** Changes *)

Lemma is_of_type e sh : In (e, sh) seven -> (e, Retrieve.type_of (row_of 2 sh)) ∈ de_que_tipo s.
Proof. intros H. exists (row_of 2 sh). split; [apply rows_of; now exists sh | reflexivity]. Qed.
Lemma four_is_a_truncated_cone : (4%nat, soy_tronco) ∈ de_que_tipo s.
Proof. apply (is_of_type 4 (shape_at 4)). cbn. tauto. Qed.
Lemma seven_is_a_triangle : (7%nat, soy_triangulo) ∈ de_que_tipo s.
Proof. apply (is_of_type 7 (shape_at 7)). cbn. tauto. Qed.

(** Each attribute of the truncated cone is changed, and the vertices of the triangle: six scenes. *)
Theorem instance_of_changes_preserve_the_invariant :
  Escena_ok (Changes.with_centro s 4%nat origin) /\ Escena_ok (Changes.with_radio s 4%nat 1)
  /\ Escena_ok (Changes.with_vector s 4%nat up) /\ Escena_ok (Changes.with_altura s 4%nat 1)
  /\ Escena_ok (Changes.with_proporcion s 4%nat 1) /\ Escena_ok (Changes.with_vertices s 7%nat corner).
Proof.
  assert (P : 1 ∈ Rmas) by (apply positive; lra). pose proof four_is_a_truncated_cone as Four.
  destruct (MainHistory.changes_preserve_the_invariant nat s 4%nat origin 1 up 1 1 corner ok) as (A & B & C & D & E & _).
  destruct (MainHistory.changes_preserve_the_invariant nat s 7%nat origin 1 up 1 1 corner ok) as (_ & _ & _ & _ & _ & F).
  split; [apply A, (has_centro _ _ ok _ _ Four); cbv; tauto |].
  split; [apply B; [apply (has_radio _ _ ok _ _ Four); cbv; tauto | exact P] |].
  split; [apply C; [apply (has_vector _ _ ok _ _ Four); cbv; tauto | exact up_is_unit] |].
  split; [apply D; [apply (has_altura _ _ ok _ _ Four); cbv; tauto | exact P] |].
  split; [apply E; [apply (has_proporcion _ _ ok _ _ Four); cbv; tauto | exact P] |].
  apply F; [apply (has_vertices _ _ ok _ _ seven_is_a_triangle); cbv; tauto | exact corner_is_proper].
Qed.

(** The sphere is as it was when the truncated cone has another radius. *)
Lemma a_radius_is_changed : Cambios.Cambiar_Radio s (Changes.with_radio s 4%nat 1) 4%nat elemento_cambiado 1.
Proof.
  pose proof four_is_a_truncated_cone as Four. apply Changes.Cambiar_Radio_computed.
  split; [| split; [apply Escena_eq_refl | reflexivity]]. split; [exact ok |].
  split; [now apply (element_of_type _ _ ok _ soy_tronco) |].
  split; [apply (has_radio _ _ ok _ _ Four); cbv; tauto | apply positive; lra].
Qed.
Lemma one_is_not_four : 1%nat <> 4%nat.
Proof. discriminate. Qed.
Definition instance_of_changes_touch_one_element :=
  MainHistory.changes_touch_one_element nat _ _ _ _ origin 1 up 1 1 corner _ one_is_not_four
    (or_intror (or_introl a_radius_is_changed)).

(** ** Beside meshes *)

(** The mesh of two triangles is added, and removed again. *)
Theorem instance_of_operations_on_meshes_are_undone : exists S S', Malla.Init_Mallas (list nat) InstancesMeshes.names S
  /\ Malla.Agregar_Malla (list nat) InstancesMeshes.names S S' [] InstancesMeshes.two_faces malla_agregada
  /\ exists r_out, Malla.Eliminar_Malla (list nat) InstancesMeshes.names S' S [] r_out.
Proof.
  destruct InstancesMeshes.two_faces_are_added as (S & S' & I & A & _).
  destruct (MainHistory.operations_on_meshes_are_undone _ _ InstancesMeshes.names_are_of_one_face) as (_ & undone & _).
  exists S, S'. split; [exact I | split; [exact A | exact (undone _ _ _ _ _ A)]].
Qed.

Definition ball : Escena (list nat) := with_esfera _ (empty_scene _) [] origin 1.
Lemma ball_is_a_scene : Escena_ok ball.
Proof. apply with_esfera_ok; [apply empty_scene_Init | intros [] | apply positive; lra]. Qed.
Definition beside : Malla.Mallas (list nat) :=
  Meshes.replaced _ InstancesMeshes.names (Malla.mk_Mallas _ ball ∅) [] InstancesMeshes.two_faces.
Lemma beside_is_right : Malla.Mallas_ok _ InstancesMeshes.names beside.
Proof.
  apply (Meshes.replaced_ok _ _ InstancesMeshes.names_are_of_one_face).
  - split; cbn; [exact ball_is_a_scene | | | now intros m r [] | now intros m r []].
    + split; [now intros m r q [] | split; [easy | now intros r [m []]]].
    + split; [easy | exists nil]. intros m. split; [now intros [r []] | intros []].
  - exact InstancesMeshes.two_faces_have_names.
  - intros e. split; [| intros []]. intros [[t [n [c [_ [N _]]]]] [He _]]. cbn in He, N.
    unfold InstancesMeshes.names, union, single in *. cbn in *. destruct He as [[] | ->]. discriminate.
Qed.
Lemma the_ball_is_of_no_mesh : ~ Malla.de_malla _ InstancesMeshes.names beside [].
Proof. intros [m [_ [r [_ [t [n [c [_ [N _]]]]]]]]]. unfold InstancesMeshes.names in N. cbn in N. discriminate. Qed.
Lemma the_ball_grows : Cambios.Cambio_Total (Malla.escena _ beside) (Changes.with_radio (Malla.escena _ beside) [] 2) []
  origin 2 up 1 1 corner elemento_cambiado.
Proof.
  right; left; left. apply Changes.Cambiar_Radio_computed. split; [| split; [apply Escena_eq_refl | reflexivity]].
  split; [apply beside_is_right |]. split.
  - cbn. left. split; [now right |]. intros [r [_ [t [n [c [_ [N _]]]]]]]. unfold InstancesMeshes.names in N. cbn in N. discriminate.
  - split; [exists 1; cbn; right; now split | apply positive; lra].
Qed.
Definition instance_of_changes_leave_meshes :=
  MainHistory.changes_leave_meshes _ _ _ _ _ _ _ _ _ _ _ _ beside_is_right the_ball_is_of_no_mesh the_ball_grows.

(** ** Groups and materials *)

Definition dressed : @Vista.Vista nat nat :=
  Vista.mk_Vista s ⦃0%nat⦄ ⦃1%nat⦄ ⦃(1%nat, 0%nat)⦄ ⦃(1%nat, 1%nat)⦄.
Lemma dressed_is_right : Vista.Vista_ok dressed.
Proof.
  assert (One : 1%nat ∈ elementos s).
  { apply (element_of_type _ _ ok 1%nat soy_esfera), (is_of_type 1 (shape_at 1)). now left. }
  split; cbn; [exact ok | | | | | | | |].
  - split; [easy | exists [0%nat]]. intros x. unfold single. cbn. intuition congruence.
  - split; [easy | exists [1%nat]]. intros x. unfold single. cbn. intuition congruence.
  - split; [| now split]. intros e x y Hx Hy. unfold single in *. congruence.
  - split; [| now split]. intros e x y Hx Hy. unfold single in *. congruence.
  - intros e [x Hx]. unfold single in Hx. now injection Hx as -> _.
  - intros x [e Hx]. unfold single in *. now injection Hx as _ ->.
  - intros e [x Hx]. unfold single in Hx. now injection Hx as -> _.
  - intros x [e Hx]. unfold single in *. now injection Hx as _ ->.
Qed.
Definition instance_of_edits_of_elements_with_looks_are_total :=
  fun e t c rad d h k abc => MainHistory.edits_of_elements_with_looks_are_total nat nat dressed e t c rad d h k abc
    dressed_is_right.

(** ** Histories *)

Definition begun : @Historia.Historia nat := Historia.mk_Historia s s nil nil.
Lemma begun_is_right : Historia.Historia_ok begun.
Proof.
  assert (Same : Historia.same_scene (s, s)) by (split; [exact ok | apply Escena_eq_refl]).
  split; cbn; auto using ok. now exists s.
Qed.
Definition instance_of_the_scene_is_the_fold_of_what_is_done :=
  MainHistory.the_scene_is_the_fold_of_what_is_done nat begun s begun_is_right.

Definition edits : list (rel (Escena nat) (Escena nat)) := [
  Transactions.transition_of (fun s s' => Elemento_Agregado s s' 8%nat soy_cono origin 1 up 1 1 corner);
  Transactions.transition_of (fun s s' => Elemento_Eliminado s s' 2%nat) ].
Lemma edits_are_steps : Forall (@Historia.Operacion nat) edits.
Proof.
  destruct (MainHistory.operations_are_steps nat 8%nat soy_cono origin 1 up 1 1 corner) as (Added & _).
  destruct (MainHistory.operations_are_steps nat 2%nat soy_cono origin 1 up 1 1 corner) as (_ & Removed & _).
  constructor; [exact Added | constructor; [exact Removed | constructor]].
Qed.
Lemma edits_can_happen : dom (Historia.pliegue edits) (Historia.historia_escena begun).
Proof.
  destruct instance_of_operations_preserve_the_invariant as (_ & _ & okc & _).
  exists (scene_without _ (with_cono _ s 8%nat origin 1 up 1) 2%nat), (with_cono _ s 8%nat origin 1 up 1). split.
  - exists elemento_agregado. exact a_cone_is_added.
  - exists (scene_without _ (with_cono _ s 8%nat origin 1 up 1) 2%nat). split.
    + exists elemento_eliminado. apply Elemento_Eliminado_computed. split; [| split; [apply Escena_eq_refl | reflexivity]].
      split; [exact okc | left]. apply (element_of_type _ _ ok 2%nat soy_cilindro), (is_of_type 2 (shape_at 2)). right; now left.
    + split; [now apply scene_without_ok | apply Escena_eq_refl].
Qed.
Definition instance_of_a_transaction_is_undone_and_done_again :=
  MainHistory.a_transaction_is_undone_and_done_again nat begun edits begun_is_right edits_are_steps edits_can_happen.
