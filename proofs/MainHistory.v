(** The final statements about changes, what undoes an operation, groups and materials, and histories, and nothing else. As
    in MainText.v, which has the names, each proof is a reference. *)
From Coq Require Import Reals List.
From Durero Require Import Toolkit Especificacion.
From Durero Require Escena Edits Malla Cambios Changes Inverses MeshInverses Vista Looks Historia History Transactions.
Local Open Scope zed_scope.

(** * Changes *)

Section Changes.
Variable Elemento : Type.
Notation Escena := (Especificacion.Escena Elemento).
Implicit Types (s : Escena) (e : Elemento) (c : Punto) (rad h k : R) (d : Vector) (abc : Terna).

(** From spec/historia.tex: a change of each attribute happens exactly where its stated clauses hold; the scene after it has the
    other value, and is the scene before in all else. *)
Theorem changes_are_as_stated s s' e c rad d h k abc r_out :
  (Cambios.Cambiar_Centro s s' e r_out c <->
      (Escena_ok s /\ e ∈ elementos s /\ e ∈ dom (mi_centro s))
      /\ Escena_eq (Changes.with_centro s e c) s' /\ r_out = elemento_cambiado)
  /\ (Cambios.Cambiar_Radio s s' e r_out rad <->
      (Escena_ok s /\ e ∈ elementos s /\ e ∈ dom (mi_radio s) /\ rad ∈ Rmas)
      /\ Escena_eq (Changes.with_radio s e rad) s' /\ r_out = elemento_cambiado)
  /\ (Cambios.Cambiar_Vector s s' e r_out d <->
      (Escena_ok s /\ e ∈ elementos s /\ e ∈ dom (mi_vector s) /\ d ∈ Unitario)
      /\ Escena_eq (Changes.with_vector s e d) s' /\ r_out = elemento_cambiado)
  /\ (Cambios.Cambiar_Altura s s' e r_out h <->
      (Escena_ok s /\ e ∈ elementos s /\ e ∈ dom (mi_altura s) /\ h ∈ Rmas)
      /\ Escena_eq (Changes.with_altura s e h) s' /\ r_out = elemento_cambiado)
  /\ (Cambios.Cambiar_Proporcion s s' e r_out k <->
      (Escena_ok s /\ e ∈ elementos s /\ e ∈ dom (mi_proporcion s) /\ k ∈ Rmas)
      /\ Escena_eq (Changes.with_proporcion s e k) s' /\ r_out = elemento_cambiado)
  /\ (Cambios.Cambiar_Vertices s s' e r_out abc <->
      (Escena_ok s /\ e ∈ elementos s /\ e ∈ dom (mi_vertices s) /\ abc ∈ Vertices)
      /\ Escena_eq (Changes.with_vertices s e abc) s' /\ r_out = elemento_cambiado).
Proof.
  exact (conj (Changes.Cambiar_Centro_computed s s' e r_out c) (conj (Changes.Cambiar_Radio_computed s s' e r_out rad)
    (conj (Changes.Cambiar_Vector_computed s s' e r_out d) (conj (Changes.Cambiar_Altura_computed s s' e r_out h)
    (conj (Changes.Cambiar_Proporcion_computed s s' e r_out k)
    (Changes.Cambiar_Vertices_computed s s' e r_out abc)))))).
Qed.

(** The clauses that state the after-state already give the invariant. *)
Theorem changes_preserve_the_invariant s e c rad d h k abc : Escena_ok s ->
  (e ∈ dom (mi_centro s) -> Escena_ok (Changes.with_centro s e c))
  /\ (e ∈ dom (mi_radio s) -> rad ∈ Rmas -> Escena_ok (Changes.with_radio s e rad))
  /\ (e ∈ dom (mi_vector s) -> d ∈ Unitario -> Escena_ok (Changes.with_vector s e d))
  /\ (e ∈ dom (mi_altura s) -> h ∈ Rmas -> Escena_ok (Changes.with_altura s e h))
  /\ (e ∈ dom (mi_proporcion s) -> k ∈ Rmas -> Escena_ok (Changes.with_proporcion s e k))
  /\ (e ∈ dom (mi_vertices s) -> abc ∈ Vertices -> Escena_ok (Changes.with_vertices s e abc)).
Proof.
  intros ok.
  exact (conj (Changes.with_centro_ok s e c ok) (conj (Changes.with_radio_ok s e rad ok)
    (conj (Changes.with_vector_ok s e d ok) (conj (Changes.with_altura_ok s e h ok)
    (conj (Changes.with_proporcion_ok s e k ok) (Changes.with_vertices_ok s e abc ok)))))).
Qed.

(** An operation that names the type of the element happens exactly on an element of that type. *)
Theorem preconditions_of_changes_of_one_type s e c rad d h k abc :
  ((exists s' r_out, Cambios.Cambiar_Centro_Esfera s s' e r_out c) <->
      Escena_ok s /\ (e, soy_esfera) ∈ de_que_tipo s)
  /\ ((exists s' r_out, Cambios.Cambiar_Radio_Esfera s s' e r_out rad) <->
      Escena_ok s /\ (e, soy_esfera) ∈ de_que_tipo s /\ rad ∈ Rmas)
  /\ ((exists s' r_out, Cambios.Cambiar_Centro_Cilindro s s' e r_out c) <->
      Escena_ok s /\ (e, soy_cilindro) ∈ de_que_tipo s)
  /\ ((exists s' r_out, Cambios.Cambiar_Radio_Cilindro s s' e r_out rad) <->
      Escena_ok s /\ (e, soy_cilindro) ∈ de_que_tipo s /\ rad ∈ Rmas)
  /\ ((exists s' r_out, Cambios.Cambiar_Vector_Cilindro s s' e r_out d) <->
      Escena_ok s /\ (e, soy_cilindro) ∈ de_que_tipo s /\ d ∈ Unitario)
  /\ ((exists s' r_out, Cambios.Cambiar_Altura_Cilindro s s' e r_out h) <->
      Escena_ok s /\ (e, soy_cilindro) ∈ de_que_tipo s /\ h ∈ Rmas)
  /\ ((exists s' r_out, Cambios.Cambiar_Centro_Cono s s' e r_out c) <->
      Escena_ok s /\ (e, soy_cono) ∈ de_que_tipo s)
  /\ ((exists s' r_out, Cambios.Cambiar_Vector_Cono s s' e r_out d) <->
      Escena_ok s /\ (e, soy_cono) ∈ de_que_tipo s /\ d ∈ Unitario)
  /\ ((exists s' r_out, Cambios.Cambiar_Altura_Cono s s' e r_out h) <->
      Escena_ok s /\ (e, soy_cono) ∈ de_que_tipo s /\ h ∈ Rmas)
  /\ ((exists s' r_out, Cambios.Cambiar_Proporcion_Cono s s' e r_out k) <->
      Escena_ok s /\ (e, soy_cono) ∈ de_que_tipo s /\ k ∈ Rmas)
  /\ ((exists s' r_out, Cambios.Cambiar_Centro_Tronco s s' e r_out c) <->
      Escena_ok s /\ (e, soy_tronco) ∈ de_que_tipo s)
  /\ ((exists s' r_out, Cambios.Cambiar_Radio_Tronco s s' e r_out rad) <->
      Escena_ok s /\ (e, soy_tronco) ∈ de_que_tipo s /\ rad ∈ Rmas)
  /\ ((exists s' r_out, Cambios.Cambiar_Vector_Tronco s s' e r_out d) <->
      Escena_ok s /\ (e, soy_tronco) ∈ de_que_tipo s /\ d ∈ Unitario)
  /\ ((exists s' r_out, Cambios.Cambiar_Altura_Tronco s s' e r_out h) <->
      Escena_ok s /\ (e, soy_tronco) ∈ de_que_tipo s /\ h ∈ Rmas)
  /\ ((exists s' r_out, Cambios.Cambiar_Proporcion_Tronco s s' e r_out k) <->
      Escena_ok s /\ (e, soy_tronco) ∈ de_que_tipo s /\ k ∈ Rmas)
  /\ ((exists s' r_out, Cambios.Cambiar_Centro_Plano s s' e r_out c) <->
      Escena_ok s /\ (e, soy_plano) ∈ de_que_tipo s)
  /\ ((exists s' r_out, Cambios.Cambiar_Vector_Plano s s' e r_out d) <->
      Escena_ok s /\ (e, soy_plano) ∈ de_que_tipo s /\ d ∈ Unitario)
  /\ ((exists s' r_out, Cambios.Cambiar_Centro_Disco s s' e r_out c) <->
      Escena_ok s /\ (e, soy_disco) ∈ de_que_tipo s)
  /\ ((exists s' r_out, Cambios.Cambiar_Radio_Disco s s' e r_out rad) <->
      Escena_ok s /\ (e, soy_disco) ∈ de_que_tipo s /\ rad ∈ Rmas)
  /\ ((exists s' r_out, Cambios.Cambiar_Vector_Disco s s' e r_out d) <->
      Escena_ok s /\ (e, soy_disco) ∈ de_que_tipo s /\ d ∈ Unitario)
  /\ ((exists s' r_out, Cambios.Cambiar_Vertices_Triangulo s s' e r_out abc) <->
      Escena_ok s /\ (e, soy_triangulo) ∈ de_que_tipo s /\ abc ∈ Vertices).
Proof. exact (Changes.pre_of_changes_of_a_type s e c rad d h k abc). Qed.

(** A change of one element changes neither the presence, the type nor an attribute of another. *)
Theorem changes_touch_one_element x s s' e c rad d h k abc r_out : x <> e ->
  Cambios.Cambiar_Centro s s' e r_out c \/ Cambios.Cambiar_Radio s s' e r_out rad
  \/ Cambios.Cambiar_Vector s s' e r_out d \/ Cambios.Cambiar_Altura s s' e r_out h
  \/ Cambios.Cambiar_Proporcion s s' e r_out k \/ Cambios.Cambiar_Vertices s s' e r_out abc ->
  Edits.same_at _ x s s'.
Proof. exact (Changes.changes_touch_one_element x s s' e c rad d h k abc r_out). Qed.

(** Every total change has an answer for every call. *)
Theorem the_conjectures_of_changes_hold :
  @Cambios.Cambiar_Centro_Total_conj_1 Elemento
  /\ @Cambios.Cambiar_Radio_Total_conj_1 Elemento
  /\ @Cambios.Cambiar_Vector_Total_conj_1 Elemento
  /\ @Cambios.Cambiar_Altura_Total_conj_1 Elemento
  /\ @Cambios.Cambiar_Proporcion_Total_conj_1 Elemento
  /\ @Cambios.Cambiar_Vertices_Total_conj_1 Elemento
  /\ @Cambios.Cambiar_Centro_Esfera_Total_conj_1 Elemento
  /\ @Cambios.Cambiar_Radio_Esfera_Total_conj_1 Elemento
  /\ @Cambios.Cambiar_Centro_Cilindro_Total_conj_1 Elemento
  /\ @Cambios.Cambiar_Radio_Cilindro_Total_conj_1 Elemento
  /\ @Cambios.Cambiar_Vector_Cilindro_Total_conj_1 Elemento
  /\ @Cambios.Cambiar_Altura_Cilindro_Total_conj_1 Elemento
  /\ @Cambios.Cambiar_Centro_Cono_Total_conj_1 Elemento
  /\ @Cambios.Cambiar_Vector_Cono_Total_conj_1 Elemento
  /\ @Cambios.Cambiar_Altura_Cono_Total_conj_1 Elemento
  /\ @Cambios.Cambiar_Proporcion_Cono_Total_conj_1 Elemento
  /\ @Cambios.Cambiar_Centro_Tronco_Total_conj_1 Elemento
  /\ @Cambios.Cambiar_Radio_Tronco_Total_conj_1 Elemento
  /\ @Cambios.Cambiar_Vector_Tronco_Total_conj_1 Elemento
  /\ @Cambios.Cambiar_Altura_Tronco_Total_conj_1 Elemento
  /\ @Cambios.Cambiar_Proporcion_Tronco_Total_conj_1 Elemento
  /\ @Cambios.Cambiar_Centro_Plano_Total_conj_1 Elemento
  /\ @Cambios.Cambiar_Vector_Plano_Total_conj_1 Elemento
  /\ @Cambios.Cambiar_Centro_Disco_Total_conj_1 Elemento
  /\ @Cambios.Cambiar_Radio_Disco_Total_conj_1 Elemento
  /\ @Cambios.Cambiar_Vector_Disco_Total_conj_1 Elemento
  /\ @Cambios.Cambiar_Vertices_Triangulo_Total_conj_1 Elemento.
Proof.
  exact (conj (@Changes.Cambiar_Centro_Total_is_total Elemento) (conj (@Changes.Cambiar_Radio_Total_is_total Elemento)
    (conj (@Changes.Cambiar_Vector_Total_is_total Elemento) (conj (@Changes.Cambiar_Altura_Total_is_total Elemento)
    (conj (@Changes.Cambiar_Proporcion_Total_is_total Elemento)
    (conj (@Changes.Cambiar_Vertices_Total_is_total Elemento)
    (conj (@Changes.Cambiar_Centro_Esfera_Total_is_total Elemento)
    (conj (@Changes.Cambiar_Radio_Esfera_Total_is_total Elemento)
    (conj (@Changes.Cambiar_Centro_Cilindro_Total_is_total Elemento)
    (conj (@Changes.Cambiar_Radio_Cilindro_Total_is_total Elemento)
    (conj (@Changes.Cambiar_Vector_Cilindro_Total_is_total Elemento)
    (conj (@Changes.Cambiar_Altura_Cilindro_Total_is_total Elemento)
    (conj (@Changes.Cambiar_Centro_Cono_Total_is_total Elemento)
    (conj (@Changes.Cambiar_Vector_Cono_Total_is_total Elemento)
    (conj (@Changes.Cambiar_Altura_Cono_Total_is_total Elemento)
    (conj (@Changes.Cambiar_Proporcion_Cono_Total_is_total Elemento)
    (conj (@Changes.Cambiar_Centro_Tronco_Total_is_total Elemento)
    (conj (@Changes.Cambiar_Radio_Tronco_Total_is_total Elemento)
    (conj (@Changes.Cambiar_Vector_Tronco_Total_is_total Elemento)
    (conj (@Changes.Cambiar_Altura_Tronco_Total_is_total Elemento)
    (conj (@Changes.Cambiar_Proporcion_Tronco_Total_is_total Elemento)
    (conj (@Changes.Cambiar_Centro_Plano_Total_is_total Elemento)
    (conj (@Changes.Cambiar_Vector_Plano_Total_is_total Elemento)
    (conj (@Changes.Cambiar_Centro_Disco_Total_is_total Elemento)
    (conj (@Changes.Cambiar_Radio_Disco_Total_is_total Elemento)
    (conj (@Changes.Cambiar_Vector_Disco_Total_is_total Elemento)
    (@Changes.Cambiar_Vertices_Triangulo_Total_is_total Elemento))))))))))))))))))))))))))).
Qed.

(** Every operation on elements has one that undoes it, and so each transition is led back by one. *)
Theorem operations_on_elements_are_undone :
  @Cambios.Elemento_Agregado_conj_1 Elemento
  /\ @Cambios.Elemento_Eliminado_conj_1 Elemento
  /\ @Cambios.Eliminar_Esfera_conj_1 Elemento
  /\ @Cambios.Cambiar_Centro_conj_1 Elemento
  /\ @Cambios.Cambiar_Radio_conj_1 Elemento
  /\ @Cambios.Cambiar_Vector_conj_1 Elemento
  /\ @Cambios.Cambiar_Altura_conj_1 Elemento
  /\ @Cambios.Cambiar_Proporcion_conj_1 Elemento
  /\ @Cambios.Cambiar_Vertices_conj_1 Elemento
  /\ @Historia.transiciones_conj_1 Elemento.
Proof.
  exact (conj (@Inverses.an_addition_is_undone_by_a_removal Elemento)
    (conj (@Inverses.a_removal_is_undone_by_an_addition Elemento)
    (conj (@Inverses.a_sphere_is_put_back_as_it_was Elemento) (conj (@Inverses.a_change_of_centre_is_undone Elemento)
    (conj (@Inverses.a_change_of_radius_is_undone Elemento) (conj (@Inverses.a_change_of_axis_is_undone Elemento)
    (conj (@Inverses.a_change_of_height_is_undone Elemento)
    (conj (@Inverses.a_change_of_proportion_is_undone Elemento)
    (conj (@Inverses.a_change_of_vertices_is_undone Elemento) (@History.each_transition_is_led_back Elemento)))))))))).
Qed.
End Changes.

(** * Beside meshes *)

Section Meshes.
Variables (Elemento : Type) (nombre_cara : rel (Elemento * nat) Elemento).
Hypothesis named : Malla.nombre_cara_def_1 Elemento nombre_cara.

(** Changes beside meshes have an answer for every call, and every operation on meshes has one that undoes it, under any names
    of faces that are of one face each. *)
Theorem operations_on_meshes_are_undone :
  Cambios.Cambio_Mallas_conj_1 nombre_cara
  /\ Cambios.Agregar_Malla_conj_1 nombre_cara
  /\ Cambios.Eliminar_Malla_conj_2 nombre_cara
  /\ Cambios.Reemplazar_Malla_conj_2 nombre_cara
  /\ Cambios.Mover_Vertice_conj_2 nombre_cara.
Proof.
  exact (conj (MeshInverses.changes_beside_meshes_are_total Elemento nombre_cara) (conj
    (MeshInverses.adding_a_mesh_is_undone Elemento nombre_cara named) (conj
    (MeshInverses.removing_a_mesh_is_undone Elemento nombre_cara named) (conj
    (MeshInverses.replacing_a_mesh_is_undone Elemento nombre_cara named)
    (MeshInverses.moving_a_vertex_is_undone Elemento nombre_cara named))))).
Qed.

(** Meshes are as they were, whatever a change does to an element beside them. *)
Theorem changes_leave_meshes S s' e c rad d h k abc r_out : Malla.Mallas_ok Elemento nombre_cara S ->
  ~ Malla.de_malla Elemento nombre_cara S e -> Cambios.Cambio_Total (Malla.escena _ S) s' e c rad d h k abc r_out ->
  Cambios.Cambio_Mallas nombre_cara S (Malla.mk_Mallas _ s' (Malla.mallas _ S)) e c rad d h k abc r_out.
Proof. exact (MeshInverses.changes_leave_meshes Elemento nombre_cara S s' e c rad d h k abc r_out). Qed.
End Meshes.

(** * Groups and materials *)

Section Looks.
Variables Elemento Nombre : Type.

(** Groups and materials survive every change; the operations on them have an answer for every call, and each has one that undoes it. *)
Theorem the_conjectures_of_looks_hold :
  @Vista.Mismo_Aspecto_conj_1 Elemento Nombre
  /\ @Vista.Cambiar_Material_Total_conj_1 Elemento Nombre
  /\ @Vista.Quitar_Material_Total_conj_1 Elemento Nombre
  /\ @Vista.Cambiar_Grupo_Total_conj_1 Elemento Nombre
  /\ @Vista.Quitar_Grupo_Total_conj_1 Elemento Nombre
  /\ @Vista.Cambiar_Material_conj_1 Elemento Nombre
  /\ @Vista.Cambiar_Material_conj_2 Elemento Nombre
  /\ @Vista.Quitar_Material_conj_1 Elemento Nombre
  /\ @Vista.Cambiar_Grupo_conj_1 Elemento Nombre
  /\ @Vista.Cambiar_Grupo_conj_2 Elemento Nombre
  /\ @Vista.Quitar_Grupo_conj_1 Elemento Nombre.
Proof.
  exact (conj (@Looks.looks_survive_a_change Elemento Nombre)
    (conj (@Looks.changing_a_material_is_total Elemento Nombre)
    (conj (@Looks.taking_a_material_away_is_total Elemento Nombre)
    (conj (@Looks.changing_a_group_is_total Elemento Nombre)
    (conj (@Looks.taking_a_group_away_is_total Elemento Nombre)
    (conj (@Looks.a_new_material_is_undone Elemento Nombre) (conj (@Looks.a_first_material_is_undone Elemento Nombre)
    (conj (@Looks.a_material_taken_away_is_given_back Elemento Nombre)
    (conj (@Looks.a_new_group_is_undone Elemento Nombre) (conj (@Looks.a_first_group_is_undone Elemento Nombre)
    (@Looks.a_group_taken_away_is_given_back Elemento Nombre))))))))))).
Qed.

(** Elements are added, removed and changed in a scene with looks as in one without. *)
Theorem edits_of_elements_with_looks_are_total (V : @Vista.Vista Elemento Nombre) e t c rad d h k abc : Vista.Vista_ok V ->
  (exists V' r_out, Vista.Agregar_Elemento_Vista V V' e t c rad d h k abc r_out)
  /\ (exists V' r_out, Vista.Eliminar_Elemento_Vista V V' e r_out)
  /\ exists V' r_out, Vista.Cambio_Vista V V' e c rad d h k abc r_out.
Proof. exact (Looks.edits_of_elements_with_looks_are_total V e t c rad d h k abc). Qed.
End Looks.

(** * Histories *)

Section Histories.
Variable Elemento : Type.
Notation Operacion := (@Historia.Operacion Elemento).
Notation pliegue := (@Historia.pliegue Elemento).

(** One operation with its inputs is a step. *)
Theorem operations_are_steps e t c rad d h k abc :
  Operacion (Transactions.transition_of (fun s s' => Elemento_Agregado s s' e t c rad d h k abc))
  /\ Operacion (Transactions.transition_of (fun s s' => Elemento_Eliminado s s' e))
  /\ Operacion (Transactions.transition_of (fun s s' r_out => Cambios.Cambiar_Centro s s' e r_out c))
  /\ Operacion (Transactions.transition_of (fun s s' r_out => Cambios.Cambiar_Radio s s' e r_out rad))
  /\ Operacion (Transactions.transition_of (fun s s' r_out => Cambios.Cambiar_Vector s s' e r_out d))
  /\ Operacion (Transactions.transition_of (fun s s' r_out => Cambios.Cambiar_Altura s s' e r_out h))
  /\ Operacion (Transactions.transition_of (fun s s' r_out => Cambios.Cambiar_Proporcion s s' e r_out k))
  /\ Operacion (Transactions.transition_of (fun s s' r_out => Cambios.Cambiar_Vertices s s' e r_out abc)).
Proof. exact (Transactions.operations_are_steps e t c rad d h k abc). Qed.

(** Sequences of steps have one fold as the text describes it. *)
Theorem there_is_one_fold :
  (Historia.pliegue_decl pliegue /\ Historia.pliegue_def_1 pliegue /\ Historia.pliegue_def_2 pliegue)
  /\ forall fold, Historia.pliegue_def_1 fold -> Historia.pliegue_def_2 fold ->
     forall ops, Forall Operacion ops -> fold ops ≡ pliegue ops.
Proof. exact (@History.there_is_one_fold Elemento). Qed.

(** A transaction is one step; every scene begins a history; the three total operations have an answer for every call; to undo
    a transaction gives back the scene before it, to do again what was undone the whole history, and to undo that as well. *)
Theorem the_conjectures_of_history_hold :
  @Historia.pliegue_conj_1 Elemento
  /\ @Historia.Init_Historia_conj_1 Elemento
  /\ @Historia.Transaccion_Total_conj_1 Elemento
  /\ @Historia.Deshacer_Total_conj_1 Elemento
  /\ @Historia.Rehacer_Total_conj_1 Elemento
  /\ @Historia.Transaccion_conj_1 Elemento
  /\ @Historia.Deshacer_conj_1 Elemento
  /\ @Historia.Rehacer_conj_1 Elemento.
Proof.
  exact (conj (@History.a_fold_is_a_step Elemento) (conj (@History.every_scene_begins_a_history Elemento)
    (conj (@History.transactions_are_total Elemento) (conj (@History.undoing_is_total Elemento)
    (conj (@History.doing_again_is_total Elemento) (conj (@History.a_transaction_is_undone Elemento)
    (conj (@History.to_do_again_gives_back_what_was_undone Elemento)
    (@History.to_undo_gives_back_what_was_done_again Elemento)))))))).
Qed.

(** The scene of a history is the only one that its steps lead to from its beginning, and what was undone can follow it. *)
Theorem the_scene_is_the_fold_of_what_is_done (H : @Historia.Historia Elemento) s : Historia.Historia_ok H ->
  ((Historia.inicial H, s) ∈ pliegue (Historia.hechas H) <-> Escena_eq (Historia.historia_escena H) s)
  /\ exists u, (Historia.historia_escena H, u) ∈ pliegue (Historia.deshechas H)
     /\ (Historia.inicial H, u) ∈ pliegue (Historia.hechas H ++ Historia.deshechas H).
Proof. exact (History.the_scene_is_the_fold_of_what_is_done H s). Qed.

(** A transaction happens where its steps can; it is undone, which gives back the scene, and done again, which gives back the
    history. *)
Theorem a_transaction_is_undone_and_done_again (H : @Historia.Historia Elemento) ops :
  Historia.Historia_ok H -> Forall Operacion ops -> Historia.historia_escena H ∈ dom (pliegue ops) ->
  exists H1 H2 H3, Historia.Transaccion H H1 ops hecho
  /\ Historia.Deshacer H1 H2 deshecho /\ Escena_eq (Historia.historia_escena H) (Historia.historia_escena H2)
  /\ Historia.Rehacer H2 H3 rehecho /\ Historia.Historia_eq H1 H3.
Proof. exact (Transactions.a_transaction_is_undone_and_done_again H ops). Qed.
End Histories.
