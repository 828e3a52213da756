(** * InstancesText: the theorems of the text and of the models beside it, on the seven shapes

    The instances of MainText.v, and those of MainModels.v about tables and acceleration, as Instances.v has them: each is a
    theorem with all its premises discharged. The scene is that of InstanceScene.v; what is added to it is named 8.

    not_there e         == e is no element of the seven *)
From Coq Require Import ZArith Reals List Bool Lia Lra.
From Durero Require Import Toolkit Especificacion Escena Operaciones Exacto InstanceScene InstanceSearch.
From Durero Require Tipos Surd Puntos Trazador Interseccion Printed ExactoEscena Retrieve Errata Distancias Instancias MainModels MainMeshes MainText.
Import ListNotations.
Local Open Scope R_scope.
Local Open Scope zed_scope.

Notation s := (scene_of 2 seven).
Notation ok := the_seven_are_a_scene.

(** ** The scene and its operations *)

Definition instance_of_operations_of_one_type_commute :=
  fun e t c r d h k abc => MainModels.operations_of_one_type_commute nat Nat.eq_dec (tables_of 2 seven) e t c r d h k abc
    (tables_are_right 2 seven seven_once seven_valid).
Definition instance_of_total_operations_are_total :=
  fun e t c r d h k abc => MainText.total_operations_are_total nat s e t c r d h k abc ok.

Lemma not_there e : (7 < e)%nat -> e ∉ elementos s.
Proof.
  intros N [x Hx]; apply rows_of in Hx as (sh & Hin & _); cbn in Hin.
  repeat destruct Hin as [[= <- _] | Hin]; lia || contradiction.
Qed.

Notation origin := (mk_Punto 0 0 0).
Notation up := (mk_Vector 0 0 1).
Notation corner := (mk_Terna origin (mk_Punto 1 0 0) (mk_Punto 0 1 0)).
Lemma up_is_unit : up ∈ Unitario.
Proof. unfold Unitario, tolerancia_unidad; cbn; lra. Qed.
Lemma positive x : 0 < x -> x ∈ Rmas.
Proof. intros H; exact H. Qed.
Lemma corner_is_proper : corner ∈ Vertices.
Proof. unfold Vertices; cbn; intros (? & ? & ?); lra. Qed.

(** A shape of each type is added, and the cylinder is removed: eight scenes. *)
Theorem instance_of_operations_preserve_the_invariant :
  Escena_ok (with_esfera _ s 8%nat origin 1) /\ Escena_ok (with_cilindro _ s 8%nat origin 1 up 1)
  /\ Escena_ok (with_cono _ s 8%nat origin 1 up 1) /\ Escena_ok (with_tronco _ s 8%nat origin 1 1 up 1)
  /\ Escena_ok (with_plano _ s 8%nat origin up) /\ Escena_ok (with_disco _ s 8%nat origin 1 up)
  /\ Escena_ok (with_triangulo _ s 8%nat corner) /\ Escena_ok (scene_without _ s 2%nat).
Proof.
  assert (N : 8%nat ∉ elementos s) by (apply not_there; lia).
  assert (P : 1 ∈ Rmas) by (apply positive; lra). pose proof up_is_unit as U. pose proof corner_is_proper as V.
  destruct (MainText.operations_preserve_the_invariant nat s 8%nat origin 1 up 1 1 corner ok) as (A & B & C & D & E & F & G & _).
  pose proof (MainText.operations_preserve_the_invariant nat s 2%nat origin 1 up 1 1 corner ok) as R.
  exact (conj (A N P) (conj (B N P U P) (conj (C N P U P) (conj (D N P P U P) (conj (E N U) (conj (F N P U) (conj (G N V)
    (proj2 (proj2 (proj2 (proj2 (proj2 (proj2 (proj2 R)))))))))))))).
Qed.

Lemma a_cone_is_added : Elemento_Agregado s (with_cono _ s 8%nat origin 1 up 1) 8%nat soy_cono origin 1 up 1 1 corner elemento_agregado.
Proof.
  apply Elemento_Agregado_computed; split; [|split; [apply Escena_eq_refl | reflexivity]].
  split; [exact ok | split; [apply not_there; lia|]].
  split; [apply positive; lra | split; [exact up_is_unit | apply positive; lra]].
Qed.
Definition instance_of_adding_then_removing_is_the_identity :=
  MainText.adding_then_removing_is_the_identity nat _ _ _ _ _ _ _ _ _ _ _ a_cone_is_added.

(** The sphere is as it was, when a cone is added and when the cylinder is removed. *)
Lemma the_cylinder_is_removed : Elemento_Eliminado s (scene_without _ s 2%nat) 2%nat elemento_eliminado.
Proof.
  apply Elemento_Eliminado_computed; split; [|split; [apply Escena_eq_refl | reflexivity]].
  split; [exact ok|]; exists (row_of 2 (shape_at 2)); apply rows_of; exists (shape_at 2); split; [right; now left | reflexivity].
Qed.
Lemma one_is_not_eight : 1%nat <> 8%nat.
Proof. discriminate. Qed.
Lemma one_is_not_two : 1%nat <> 2%nat.
Proof. discriminate. Qed.
Definition instance_of_an_edit_touches_one_element :=
  conj (MainText.an_edit_touches_one_element nat _ _ _ _ _ _ _ _ _ _ _ _ one_is_not_eight (or_introl a_cone_is_added))
    (MainText.an_edit_touches_one_element nat _ _ _ _ soy_cilindro origin 1 up 1 1 corner _ one_is_not_two
      (or_intror the_cylinder_is_removed)).

(** ** Defects of the printed text *)

Definition instance_of_E06_another_element_changes :=
  MainText.E06_another_element_changes nat 1%nat 8%nat origin one_is_not_eight.

(** The cylinder of the seven, removed as a sphere: its centre and its radius go. *)
Definition removed_as_a_sphere : Escena nat :=
  let w := scene_without _ s 2%nat in
  mk_Escena (elementos w) (tipos w) (de_que_tipo w) (mi_centro w) (mi_radio w) (mi_vector s) (mi_altura s) (mi_proporcion s)
    (mi_vertices s).
Definition instance_of_E09_wrong_type_leaves_attributes :=
  MainText.E09_wrong_type_leaves_attributes nat s removed_as_a_sphere 2%nat _ _ _ _ ok
    (shape_in_scene 2 seven 2%nat _ (or_intror (or_introl eq_refl))) (seteq_refl _) (seteq_refl _) (seteq_refl _).

(** The printed cylinder of radius 4 is that of radius 2, which has points, and none of them is of the one of radius 4. *)
Theorem instance_of_E10_other_surface :
  Errata.printed_puntos_cilindro origin 4 up 1 ≡ puntos_cilindro origin (sqrt 4) up 1
  /\ (forall w, w ∈ Errata.printed_puntos_cilindro origin 4 up 1 -> w ∉ puntos_cilindro origin 4 up 1)
  /\ exists w, w ∈ puntos_cilindro origin 4 Errata.axis_z 1.
Proof.
  assert (P : 4 > 0) by lra. destruct (MainText.E10_other_surface origin 4 up 1 P) as (A & B & C).
  split; [exact A | split; [apply B; lra | apply C; lra]].
Qed.

Lemma one_is_positive : 1 > 0.
Proof. lra. Qed.
Definition instance_of_E11_plane := MainText.E11_plane origin 1 up 1 one_is_positive one_is_positive.

Theorem instance_of_E14_no_description :
  ~ exists w, Toolkit.is_mu (fun temp => (temp = mk_Punto 1 0 0 \/ temp = mk_Punto 2 0 0) /\
    exists t, t ∈ Rmas /\ Trazador.is_least ⦃distancia temp origin⦄ t) w.
Proof.
  assert (D : forall x, 0 < x -> 0 < distancia (mk_Punto x 0 0) origin).
  { intros x Hx; unfold distancia, cuadrado; cbn; apply sqrt_lt_R0.
    pose proof (Rmult_lt_0_compat _ _ Hx Hx); lra. }
  refine (MainText.E14_no_description (fun w => w = mk_Punto 1 0 0 \/ w = mk_Punto 2 0 0) origin (mk_Punto 1 0 0) (mk_Punto 2 0 0)
    _ (or_introl eq_refl) (or_intror eq_refl) (D 1 _) (D 2 _)); try lra.
  intros [= H]; lra.
Qed.

(** ** The closed forms *)

Notation from_outside := (ExactoEscena.the_ray 2 (v3 (-16) 2 1) (v3 8 1 (-1))).
Notation the_sphere := (Puntos.of_esfera from_outside (point 2 (v3 0 0 0)) (over 2 6)).
Ltac numbers := cbn; unfold Tipos.sq, Tipos.dot; cbn; unfold over; lra.
Theorem instance_of_stable_roots_are_the_textbook_ones :
  let plus := (- Puntos.cB the_sphere + sqrt (Trazador.discriminant the_sphere)) / Puntos.cA the_sphere in
  let minus := (- Puntos.cB the_sphere - sqrt (Trazador.discriminant the_sphere)) / Puntos.cA the_sphere in
  (Trazador.stable_sum the_sphere / Puntos.cA the_sphere = plus /\ Puntos.cC the_sphere / Trazador.stable_sum the_sphere = minus)
  \/ (Trazador.stable_sum the_sphere / Puntos.cA the_sphere = minus /\ Puntos.cC the_sphere / Trazador.stable_sum the_sphere = plus).
Proof.
  assert (A : Puntos.cA the_sphere = 33 / 2) by numbers.
  assert (B : Puntos.cB the_sphere = - (127 / 4)) by numbers.
  assert (C : Puntos.cC the_sphere = 225 / 4) by numbers.
  assert (D : 0 <= Trazador.discriminant the_sphere) by (unfold Trazador.discriminant; rewrite A, B, C; lra).
  apply MainText.stable_roots_are_the_textbook_ones; [rewrite A; lra | exact D|].
  pose proof (sqrt_pos (Trazador.discriminant the_sphere)); unfold Trazador.stable_sum, Trazador.sgn; rewrite B.
  destruct Rlt_dec; lra.
Qed.

Definition instance_of_a_triangle_is_the_convex_combinations_of_its_vertices :=
  fun w => MainText.a_triangle_is_the_convex_combinations_of_its_vertices corner w corner_is_proper.

(** Two halves of a square, whose vertices are told in other orders. *)
Notation other_half := (mk_Terna (mk_Punto 0 1 0) (mk_Punto 1 1 0) (mk_Punto 1 0 0)).
Lemma a_half : 0 <= 1 / 2 <= 1.
Proof. lra. Qed.
Definition instance_of_triangles_share_the_edge_between_common_vertices :=
  MainText.triangles_share_the_edge_between_common_vertices corner other_half (mk_Punto 1 0 0) (mk_Punto 0 1 0) (1 / 2)
    (or_intror (or_introl eq_refl)) (or_intror (or_intror eq_refl)) (or_intror (or_intror eq_refl)) (or_introl eq_refl) a_half.

(** ** The first hit of the seven *)

Notation none := (∅ : set nat).
Definition nowhere (e : nat) : bool := false.
Lemma ray_from_outside : asked (v3 (-16) 2 1) (v3 8 1 (-1)) nowhere.
Proof. split; [reflexivity | cbn; lia | discriminate]. Qed.
Notation is_a_ray := (is_ray _ _ _ ray_from_outside).
Lemma of_the_ray : alcances s from_outside none ⊆ puntos_de_rayo from_outside.
Proof. intros w (e & _ & _ & Hw & _); exact Hw. Qed.
Definition instance_of_nearest_point_exists_iff_infimum_attained :=
  MainText.nearest_point_exists_iff_infimum_attained from_outside is_a_ray _ of_the_ray.

Lemma no_element_is_on (e : nat) (sh : shape) : In (e, sh) seven -> (nowhere e = true <-> none e).
Proof. intros _; split; [discriminate | intros []]. Qed.
Notation as_described := (described 2 seven none nowhere no_element_is_on).
Lemma none_is_known : none ⊆ elementos s.
Proof. intros e []. Qed.
Notation the_first := (Surd.Surd 127 (-1) 1279 66).
Lemma the_sphere_is_hit : Hay_Interseccion s s from_outside none hit (fun e => In e [1%nat]) (Surd.val the_first)
  (Puntos.point_at from_outside (Surd.val the_first)).
Proof.
  pose proof (MainModels.executable_first_hit_is_Primera_Interseccion nat s s 2 none _ _ _ eq_refl ok is_a_ray as_described
    same_scene none_is_known) as H.
  replace (first_hit 2 _ _ _) with (Hit the_first [1%nat]) in H by (vm_compute; reflexivity); exact H.
Qed.
Definition instance_of_the_elements_of_a_hit_are_de_que_elemento :=
  MainText.the_elements_of_a_hit_are_de_que_elemento _ _ _ _ _ _ _ _ the_sphere_is_hit.

(** From (10, 0, 0) along the axis of the cylinder, which has the radius 2 about (8, 0): along a generator of it. *)
Notation inside_p := (v3 20 0 0).
Notation along_the_cylinder := (ExactoEscena.the_ray 2 inside_p along_z).
Lemma ray_along_the_cylinder : asked inside_p along_z nowhere.
Proof. split; [reflexivity | cbn; lia | discriminate]. Qed.
Lemma it_starts_in_the_cylinder : Trazador.starts_in (Interseccion.met along_the_cylinder nat s none 2%nat).
Proof.
  pose proof (MainModels.executable_first_hit_is_right nat 2 inside_p along_z
    (map (fun a => (fst a, snd a, nowhere (fst a))) seven) eq_refl) as H.
  replace (first_hit 2 _ _ _) with (NoMin [2%nat]) in H by (vm_compute; reflexivity).
  destruct H as [_ H]; destruct (proj1 (H 2%nat) (or_introl eq_refl)) as (sh & on & Hin & Starts).
  apply (ExactoEscena.starts_from_origin _ _ (fun t => ExactoEscena.meets_met nat 2 s ok none _ _ _ as_described 2%nat sh on t Hin)).
  exact Starts.
Qed.
Lemma the_cylinder_is_there : 2%nat ∈ elementos s.
Proof. exists (row_of 2 (shape_at 2)); apply rows_of; exists (shape_at 2); split; [right; now left | reflexivity]. Qed.
Definition instance_of_the_segment_is_of_a_generator :=
  MainText.the_segment_is_of_a_generator along_the_cylinder (is_ray _ _ _ ray_along_the_cylinder) nat s none ok 2%nat
    the_cylinder_is_there it_starts_in_the_cylinder.

(** ** Distances *)

(** About (3, 0, 0) the ball of radius two holds no point of the sphere of radius one at the origin. *)
Theorem no_point_of_a_sphere_lies_in_a_ball_before_it w : distancia w (mk_Punto 3 0 0) < 2 -> w ∉ puntos_esfera origin 1.
Proof.
  destruct (MainText.the_conjectures_of_distance_hold nat) as (_ & Ball & _).
  exact (Ball _ _ w _ Distancias.a_sphere_has_a_distance).
Qed.

(** ** What a raster answers *)

(** The middle of the triangle's height, and a light at the origin, off its plane: all that is asked of the two. *)
Theorem the_triangle_of_the_seven_and_a_light :
  let p := mk_Punto 36 0 0 in let light := mk_Punto 0 0 0 in
  visible s p light ⦃7%nat⦄ <-> p ∈ iluminada light (puntos_de_elemento s 7%nat) (fun ps => exists o, o ∈ elementos s
    /\ o <> 7%nat /\ ps ≡ puntos_de_elemento s o).
Proof.
  intros p light.
  assert (T : is_triangulo nat s 7%nat (vertices 2 (v3 72 (-8) (-8)) (v3 72 8 (-8)) (v3 72 0 8))).
  { apply (shape_in_scene 2 seven 7%nat (Triangle _ _ _)). cbn. tauto. }
  destruct (Interseccion.triangulo_of_scene nat s ok 7%nat _ T) as [Points [Power _]].
  destruct (MainText.the_conjectures_of_projection_hold nat) as [Lit _]. apply Lit.
  - exact ok.
  - exists (vertices 2 (v3 72 (-8) (-8)) (v3 72 8 (-8)) (v3 72 0 8)). apply T.
  - apply Points. unfold p. split; [unfold prisma, lado, escalar | unfold potencia_triangulo]; cbn; unfold over; lra.
  - eexists. split; [apply Power; reflexivity |]. unfold light, potencia_triangulo. cbn. unfold over. lra.
Qed.

(** ** Instances of elements *)

(** The map that leans and mirrors: what it puts where the point (1, 0, 1) of a ray goes is that point, at the same t. *)
Theorem a_point_of_a_ray_is_put_by_the_map_that_mirrors :
  puesto Instancias.leaning (mk_Punto 1 0 1) (mk_Punto 2 3 8).
Proof.
  destruct (MainMeshes.the_conjectures_of_instances_hold nat) as (_ & _ & _ & Kept & _).
  destruct Instancias.a_ray_is_the_copy_of_a_ray as [Origin Direction].
  eapply (Kept _ _ _ _ _ 1 (proj1 Instancias.a_map_may_mirror)); [| | exact (conj Origin Direction) | ..];
    try (split; cbn; lra); cbn; lra.
Qed.
