(** spec/historia.tex, by hand: groups and materials of elements, and the operations on them. The rules are those at the
    heads of Especificacion.v, Malla.v and Cambios.v, and further

    Nombre               == a Type, a section variable
    vista_escena V       == the components of V that are those of Escena
    x, g                 == material?, g? *)
From Coq Require Import Reals.
From Durero Require Import Toolkit Especificacion Malla Cambios.
Local Open Scope zed_scope.

Section Vista.
Context {Elemento Nombre : Type}.
Notation Escena := (Especificacion.Escena Elemento).
Implicit Types (s : Escena) (e : Elemento) (x g : Nombre) (c : Punto) (rad h k : R) (d : Vector) (abc : Terna)
  (r_out : Respuesta).

Record Vista := mk_Vista {
  vista_escena : Escena;
  grupos : set Nombre;
  materiales : set Nombre;
  mi_grupo : rel Elemento Nombre;
  mi_material : rel Elemento Nombre
}.
Implicit Types V : Vista.

Record Vista_ok V : Prop := {
  Vista_Escena : Escena_ok (vista_escena V);
  Vista_decl_grupos : grupos V ∈ 𝔽 univ;
  Vista_decl_materiales : materiales V ∈ 𝔽 univ;
  Vista_decl_mi_grupo : mi_grupo V ∈ (univ ⇸ univ);
  Vista_decl_mi_material : mi_material V ∈ (univ ⇸ univ);
  Vista_inv_1 : dom (mi_grupo V) ⊆ elementos (vista_escena V);
  Vista_inv_2 : ran (mi_grupo V) ⊆ grupos V;
  Vista_inv_3 : dom (mi_material V) ⊆ elementos (vista_escena V);
  Vista_inv_4 : ran (mi_material V) ⊆ materiales V
}.
Record Vista_eq V V' : Prop := {
  Vista_eq_Escena : Escena_eq (vista_escena V) (vista_escena V');
  Vista_eq_grupos : grupos V' ≡ grupos V;
  Vista_eq_materiales : materiales V' ≡ materiales V;
  Vista_eq_mi_grupo : mi_grupo V' ≡ mi_grupo V;
  Vista_eq_mi_material : mi_material V' ≡ mi_material V
}.
Record Delta_Vista V V' : Prop := {
  Delta_Vista_before : Vista_ok V;
  Delta_Vista_after : Vista_ok V'
}.
Record Xi_Vista V V' : Prop := {
  Xi_Vista_Delta : Delta_Vista V V';
  Xi_Vista_eq : Vista_eq V V'
}.

(** ** Operations on elements, in a scene with looks *)

Record Mismo_Aspecto V V' : Prop := {
  Mismo_Aspecto_Delta : Delta_Vista V V';
  Mismo_Aspecto_post_1 : grupos V' ≡ grupos V;
  Mismo_Aspecto_post_2 : materiales V' ≡ materiales V;
  Mismo_Aspecto_post_3 : mi_grupo V' ≡ dres (elementos (vista_escena V')) (mi_grupo V);
  Mismo_Aspecto_post_4 : mi_material V' ≡ dres (elementos (vista_escena V')) (mi_material V)
}.
Definition Agregar_Elemento_Vista V V' e t c rad d h k abc r_out : Prop :=
  Agregar_Elemento_Total (vista_escena V) (vista_escena V') e t c rad d h k abc r_out /\ Mismo_Aspecto V V'.
Definition Eliminar_Elemento_Vista V V' e r_out : Prop :=
  Eliminar_Elemento_Total (vista_escena V) (vista_escena V') e r_out /\ Mismo_Aspecto V V'.
Definition Cambio_Vista V V' e c rad d h k abc r_out : Prop :=
  Cambio_Total (vista_escena V) (vista_escena V') e c rad d h k abc r_out /\ Mismo_Aspecto V V'.

Definition Mismo_Aspecto_conj_1 : Prop := forall V V' e r_out,
  Mismo_Aspecto V V' -> Cambiar_Elemento (vista_escena V) (vista_escena V') e r_out ->
  mi_grupo V' ≡ mi_grupo V /\ mi_material V' ≡ mi_material V.

(** ** Materials and groups *)

Record Cambiar_Material V V' e x r_out : Prop := {
  Cambiar_Material_Delta : Delta_Vista V V';
  Cambiar_Material_Xi_Escena : Xi_Escena (vista_escena V) (vista_escena V');
  Cambiar_Material_pre_1 : e ∈ elementos (vista_escena V);
  Cambiar_Material_pre_2 : x ∈ materiales V;
  Cambiar_Material_post_1 : grupos V' ≡ grupos V;
  Cambiar_Material_post_2 : materiales V' ≡ materiales V;
  Cambiar_Material_post_3 : mi_grupo V' ≡ mi_grupo V;
  Cambiar_Material_post_4 : mi_material V' ≡ oplus (mi_material V) ⦃(e, x)⦄;
  Cambiar_Material_post_5 : r_out = elemento_cambiado
}.
Record Quitar_Material V V' e r_out : Prop := {
  Quitar_Material_Delta : Delta_Vista V V';
  Quitar_Material_Xi_Escena : Xi_Escena (vista_escena V) (vista_escena V');
  Quitar_Material_pre_1 : e ∈ elementos (vista_escena V);
  Quitar_Material_post_1 : grupos V' ≡ grupos V;
  Quitar_Material_post_2 : materiales V' ≡ materiales V;
  Quitar_Material_post_3 : mi_grupo V' ≡ mi_grupo V;
  Quitar_Material_post_4 : mi_material V' ≡ ndres ⦃e⦄ (mi_material V);
  Quitar_Material_post_5 : r_out = elemento_cambiado
}.
Record Cambiar_Grupo V V' e g r_out : Prop := {
  Cambiar_Grupo_Delta : Delta_Vista V V';
  Cambiar_Grupo_Xi_Escena : Xi_Escena (vista_escena V) (vista_escena V');
  Cambiar_Grupo_pre_1 : e ∈ elementos (vista_escena V);
  Cambiar_Grupo_pre_2 : g ∈ grupos V;
  Cambiar_Grupo_post_1 : grupos V' ≡ grupos V;
  Cambiar_Grupo_post_2 : materiales V' ≡ materiales V;
  Cambiar_Grupo_post_3 : mi_grupo V' ≡ oplus (mi_grupo V) ⦃(e, g)⦄;
  Cambiar_Grupo_post_4 : mi_material V' ≡ mi_material V;
  Cambiar_Grupo_post_5 : r_out = elemento_cambiado
}.
Record Quitar_Grupo V V' e r_out : Prop := {
  Quitar_Grupo_Delta : Delta_Vista V V';
  Quitar_Grupo_Xi_Escena : Xi_Escena (vista_escena V) (vista_escena V');
  Quitar_Grupo_pre_1 : e ∈ elementos (vista_escena V);
  Quitar_Grupo_post_1 : grupos V' ≡ grupos V;
  Quitar_Grupo_post_2 : materiales V' ≡ materiales V;
  Quitar_Grupo_post_3 : mi_grupo V' ≡ ndres ⦃e⦄ (mi_grupo V);
  Quitar_Grupo_post_4 : mi_material V' ≡ mi_material V;
  Quitar_Grupo_post_5 : r_out = elemento_cambiado
}.

Record Nadie_Se_Llama V V' e r_out : Prop := {
  Nadie_Se_Llama_Xi : Xi_Vista V V';
  Nadie_Se_Llama_pre_1 : e ∉ elementos (vista_escena V);
  Nadie_Se_Llama_post_1 : r_out = elemento_no_existe
}.
Record Material_No_Existe V V' x r_out : Prop := {
  Material_No_Existe_Xi : Xi_Vista V V';
  Material_No_Existe_pre_1 : x ∉ materiales V;
  Material_No_Existe_post_1 : r_out = material_no_existe
}.
Record Grupo_No_Existe V V' g r_out : Prop := {
  Grupo_No_Existe_Xi : Xi_Vista V V';
  Grupo_No_Existe_pre_1 : g ∉ grupos V;
  Grupo_No_Existe_post_1 : r_out = grupo_no_existe
}.

Definition Cambiar_Material_Total V V' e x r_out : Prop :=
  Cambiar_Material V V' e x r_out \/ Nadie_Se_Llama V V' e r_out \/ Material_No_Existe V V' x r_out.
Definition Quitar_Material_Total V V' e r_out : Prop := Quitar_Material V V' e r_out \/ Nadie_Se_Llama V V' e r_out.
Definition Cambiar_Grupo_Total V V' e g r_out : Prop :=
  Cambiar_Grupo V V' e g r_out \/ Nadie_Se_Llama V V' e r_out \/ Grupo_No_Existe V V' g r_out.
Definition Quitar_Grupo_Total V V' e r_out : Prop := Quitar_Grupo V V' e r_out \/ Nadie_Se_Llama V V' e r_out.

(** ** What the text claims *)

Definition Cambiar_Material_Total_conj_1 : Prop := forall V e x, Vista_ok V ->
  exists V' r_out, Cambiar_Material_Total V V' e x r_out.
Definition Quitar_Material_Total_conj_1 : Prop := forall V e, Vista_ok V ->
  exists V' r_out, Quitar_Material_Total V V' e r_out.
Definition Cambiar_Grupo_Total_conj_1 : Prop := forall V e g, Vista_ok V ->
  exists V' r_out, Cambiar_Grupo_Total V V' e g r_out.
Definition Quitar_Grupo_Total_conj_1 : Prop := forall V e, Vista_ok V ->
  exists V' r_out, Quitar_Grupo_Total V V' e r_out.

Definition Cambiar_Material_conj_1 : Prop := forall V V' e x r_out, Cambiar_Material V V' e x r_out ->
  e ∈ dom (mi_material V) -> exists y, (e, y) ∈ mi_material V /\ exists r_out, Cambiar_Material V' V e y r_out.
Definition Cambiar_Material_conj_2 : Prop := forall V V' e x r_out, Cambiar_Material V V' e x r_out ->
  e ∉ dom (mi_material V) -> exists r_out, Quitar_Material V' V e r_out.
Definition Quitar_Material_conj_1 : Prop := forall V V' e r_out, Quitar_Material V V' e r_out ->
  e ∈ dom (mi_material V) -> exists y, (e, y) ∈ mi_material V /\ exists r_out, Cambiar_Material V' V e y r_out.
Definition Cambiar_Grupo_conj_1 : Prop := forall V V' e g r_out, Cambiar_Grupo V V' e g r_out ->
  e ∈ dom (mi_grupo V) -> exists y, (e, y) ∈ mi_grupo V /\ exists r_out, Cambiar_Grupo V' V e y r_out.
Definition Cambiar_Grupo_conj_2 : Prop := forall V V' e g r_out, Cambiar_Grupo V V' e g r_out ->
  e ∉ dom (mi_grupo V) -> exists r_out, Quitar_Grupo V' V e r_out.
Definition Quitar_Grupo_conj_1 : Prop := forall V V' e r_out, Quitar_Grupo V V' e r_out ->
  e ∈ dom (mi_grupo V) -> exists y, (e, y) ∈ mi_grupo V /\ exists r_out, Cambiar_Grupo V' V e y r_out.
End Vista.
