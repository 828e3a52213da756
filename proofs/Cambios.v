(** spec/historia.tex, by hand: the changes of elements, alone and beside meshes, and what undoes an operation. The
    rules are those at the heads of Especificacion.v and Malla.v, and further

    f ⊕ { e ↦ v }        == oplus f ⦃(e, v)⦄
    a ∈ { S • E }        == there are an after-state and outputs of S of which E is a; as all that is said of scenes is said
                            of their components, a scene stands for each that Escena_eq says is the same
    e, c, rad, d, h, k, abc == e?, centro?, radio?, vector?, altura?, proporcion?, vertices? *)
From Coq Require Import Reals.
From Durero Require Import Toolkit Especificacion Malla.
Local Open Scope zed_scope.

(** ** The changes *)
Section Cambios.
Context {Elemento : Type}.
Notation Escena := (Especificacion.Escena Elemento).
Implicit Types (s : Escena) (e m : Elemento) (c : Punto) (rad h k : R) (d : Vector) (abc : Terna) (r_out : Respuesta).

Record Cambiar_Elemento s s' e r_out : Prop := {
  Cambiar_Elemento_Delta : Delta_Escena s s';
  Cambiar_Elemento_pre_1 : e ∈ elementos s;
  Cambiar_Elemento_post_1 : elementos s' ≡ elementos s;
  Cambiar_Elemento_post_2 : de_que_tipo s' ≡ de_que_tipo s;
  Cambiar_Elemento_post_3 : r_out = elemento_cambiado
}.
Record Cambiar_Centro s s' e r_out c : Prop := {
  Cambiar_Centro_Cambiar_Elemento : Cambiar_Elemento s s' e r_out;
  Cambiar_Centro_pre_1 : e ∈ dom (mi_centro s);
  Cambiar_Centro_post_1 : mi_centro s' ≡ oplus (mi_centro s) ⦃(e, c)⦄;
  Cambiar_Centro_post_2 : mi_radio s' ≡ mi_radio s;
  Cambiar_Centro_post_3 : mi_vector s' ≡ mi_vector s;
  Cambiar_Centro_post_4 : mi_altura s' ≡ mi_altura s;
  Cambiar_Centro_post_5 : mi_proporcion s' ≡ mi_proporcion s;
  Cambiar_Centro_post_6 : mi_vertices s' ≡ mi_vertices s
}.
Record Cambiar_Radio s s' e r_out rad : Prop := {
  Cambiar_Radio_Cambiar_Elemento : Cambiar_Elemento s s' e r_out;
  Cambiar_Radio_pre_1 : e ∈ dom (mi_radio s);
  Cambiar_Radio_pre_2 : rad ∈ Rmas;
  Cambiar_Radio_post_1 : mi_radio s' ≡ oplus (mi_radio s) ⦃(e, rad)⦄;
  Cambiar_Radio_post_2 : mi_centro s' ≡ mi_centro s;
  Cambiar_Radio_post_3 : mi_vector s' ≡ mi_vector s;
  Cambiar_Radio_post_4 : mi_altura s' ≡ mi_altura s;
  Cambiar_Radio_post_5 : mi_proporcion s' ≡ mi_proporcion s;
  Cambiar_Radio_post_6 : mi_vertices s' ≡ mi_vertices s
}.
Record Cambiar_Vector s s' e r_out d : Prop := {
  Cambiar_Vector_Cambiar_Elemento : Cambiar_Elemento s s' e r_out;
  Cambiar_Vector_pre_1 : e ∈ dom (mi_vector s);
  Cambiar_Vector_pre_2 : d ∈ Unitario;
  Cambiar_Vector_post_1 : mi_vector s' ≡ oplus (mi_vector s) ⦃(e, d)⦄;
  Cambiar_Vector_post_2 : mi_centro s' ≡ mi_centro s;
  Cambiar_Vector_post_3 : mi_radio s' ≡ mi_radio s;
  Cambiar_Vector_post_4 : mi_altura s' ≡ mi_altura s;
  Cambiar_Vector_post_5 : mi_proporcion s' ≡ mi_proporcion s;
  Cambiar_Vector_post_6 : mi_vertices s' ≡ mi_vertices s
}.
Record Cambiar_Altura s s' e r_out h : Prop := {
  Cambiar_Altura_Cambiar_Elemento : Cambiar_Elemento s s' e r_out;
  Cambiar_Altura_pre_1 : e ∈ dom (mi_altura s);
  Cambiar_Altura_pre_2 : h ∈ Rmas;
  Cambiar_Altura_post_1 : mi_altura s' ≡ oplus (mi_altura s) ⦃(e, h)⦄;
  Cambiar_Altura_post_2 : mi_centro s' ≡ mi_centro s;
  Cambiar_Altura_post_3 : mi_radio s' ≡ mi_radio s;
  Cambiar_Altura_post_4 : mi_vector s' ≡ mi_vector s;
  Cambiar_Altura_post_5 : mi_proporcion s' ≡ mi_proporcion s;
  Cambiar_Altura_post_6 : mi_vertices s' ≡ mi_vertices s
}.
Record Cambiar_Proporcion s s' e r_out k : Prop := {
  Cambiar_Proporcion_Cambiar_Elemento : Cambiar_Elemento s s' e r_out;
  Cambiar_Proporcion_pre_1 : e ∈ dom (mi_proporcion s);
  Cambiar_Proporcion_pre_2 : k ∈ Rmas;
  Cambiar_Proporcion_post_1 : mi_proporcion s' ≡ oplus (mi_proporcion s) ⦃(e, k)⦄;
  Cambiar_Proporcion_post_2 : mi_centro s' ≡ mi_centro s;
  Cambiar_Proporcion_post_3 : mi_radio s' ≡ mi_radio s;
  Cambiar_Proporcion_post_4 : mi_vector s' ≡ mi_vector s;
  Cambiar_Proporcion_post_5 : mi_altura s' ≡ mi_altura s;
  Cambiar_Proporcion_post_6 : mi_vertices s' ≡ mi_vertices s
}.
Record Cambiar_Vertices s s' e r_out abc : Prop := {
  Cambiar_Vertices_Cambiar_Elemento : Cambiar_Elemento s s' e r_out;
  Cambiar_Vertices_pre_1 : e ∈ dom (mi_vertices s);
  Cambiar_Vertices_pre_2 : abc ∈ Vertices;
  Cambiar_Vertices_post_1 : mi_vertices s' ≡ oplus (mi_vertices s) ⦃(e, abc)⦄;
  Cambiar_Vertices_post_2 : mi_centro s' ≡ mi_centro s;
  Cambiar_Vertices_post_3 : mi_radio s' ≡ mi_radio s;
  Cambiar_Vertices_post_4 : mi_vector s' ≡ mi_vector s;
  Cambiar_Vertices_post_5 : mi_altura s' ≡ mi_altura s;
  Cambiar_Vertices_post_6 : mi_proporcion s' ≡ mi_proporcion s
}.

(** ** The type of an element, where an operation names it *)

Record Es_Esfera s e : Prop := {
  Es_Esfera_Escena : Escena_ok s;
  Es_Esfera_pre_1 : (e, soy_esfera) ∈ de_que_tipo s
}.
Record Es_Cilindro s e : Prop := {
  Es_Cilindro_Escena : Escena_ok s;
  Es_Cilindro_pre_1 : (e, soy_cilindro) ∈ de_que_tipo s
}.
Record Es_Cono s e : Prop := {
  Es_Cono_Escena : Escena_ok s;
  Es_Cono_pre_1 : (e, soy_cono) ∈ de_que_tipo s
}.
Record Es_Tronco s e : Prop := {
  Es_Tronco_Escena : Escena_ok s;
  Es_Tronco_pre_1 : (e, soy_tronco) ∈ de_que_tipo s
}.
Record Es_Plano s e : Prop := {
  Es_Plano_Escena : Escena_ok s;
  Es_Plano_pre_1 : (e, soy_plano) ∈ de_que_tipo s
}.
Record Es_Disco s e : Prop := {
  Es_Disco_Escena : Escena_ok s;
  Es_Disco_pre_1 : (e, soy_disco) ∈ de_que_tipo s
}.
Record Es_Triangulo s e : Prop := {
  Es_Triangulo_Escena : Escena_ok s;
  Es_Triangulo_pre_1 : (e, soy_triangulo) ∈ de_que_tipo s
}.

Definition Cambiar_Centro_Esfera s s' e r_out c : Prop := Cambiar_Centro s s' e r_out c /\ Es_Esfera s e.
Definition Cambiar_Radio_Esfera s s' e r_out rad : Prop := Cambiar_Radio s s' e r_out rad /\ Es_Esfera s e.
Definition Cambiar_Centro_Cilindro s s' e r_out c : Prop := Cambiar_Centro s s' e r_out c /\ Es_Cilindro s e.
Definition Cambiar_Radio_Cilindro s s' e r_out rad : Prop := Cambiar_Radio s s' e r_out rad /\ Es_Cilindro s e.
Definition Cambiar_Vector_Cilindro s s' e r_out d : Prop := Cambiar_Vector s s' e r_out d /\ Es_Cilindro s e.
Definition Cambiar_Altura_Cilindro s s' e r_out h : Prop := Cambiar_Altura s s' e r_out h /\ Es_Cilindro s e.
Definition Cambiar_Centro_Cono s s' e r_out c : Prop := Cambiar_Centro s s' e r_out c /\ Es_Cono s e.
Definition Cambiar_Vector_Cono s s' e r_out d : Prop := Cambiar_Vector s s' e r_out d /\ Es_Cono s e.
Definition Cambiar_Altura_Cono s s' e r_out h : Prop := Cambiar_Altura s s' e r_out h /\ Es_Cono s e.
Definition Cambiar_Proporcion_Cono s s' e r_out k : Prop := Cambiar_Proporcion s s' e r_out k /\ Es_Cono s e.
Definition Cambiar_Centro_Tronco s s' e r_out c : Prop := Cambiar_Centro s s' e r_out c /\ Es_Tronco s e.
Definition Cambiar_Radio_Tronco s s' e r_out rad : Prop := Cambiar_Radio s s' e r_out rad /\ Es_Tronco s e.
Definition Cambiar_Vector_Tronco s s' e r_out d : Prop := Cambiar_Vector s s' e r_out d /\ Es_Tronco s e.
Definition Cambiar_Altura_Tronco s s' e r_out h : Prop := Cambiar_Altura s s' e r_out h /\ Es_Tronco s e.
Definition Cambiar_Proporcion_Tronco s s' e r_out k : Prop := Cambiar_Proporcion s s' e r_out k /\ Es_Tronco s e.
Definition Cambiar_Centro_Plano s s' e r_out c : Prop := Cambiar_Centro s s' e r_out c /\ Es_Plano s e.
Definition Cambiar_Vector_Plano s s' e r_out d : Prop := Cambiar_Vector s s' e r_out d /\ Es_Plano s e.
Definition Cambiar_Centro_Disco s s' e r_out c : Prop := Cambiar_Centro s s' e r_out c /\ Es_Disco s e.
Definition Cambiar_Radio_Disco s s' e r_out rad : Prop := Cambiar_Radio s s' e r_out rad /\ Es_Disco s e.
Definition Cambiar_Vector_Disco s s' e r_out d : Prop := Cambiar_Vector s s' e r_out d /\ Es_Disco s e.
Definition Cambiar_Vertices_Triangulo s s' e r_out abc : Prop := Cambiar_Vertices s s' e r_out abc /\ Es_Triangulo s e.

(** ** What can go wrong, and the total changes *)

Record Sin_Centro s s' e r_out : Prop := {
  Sin_Centro_Xi : Xi_Escena s s';
  Sin_Centro_pre_1 : e ∈ elementos s;
  Sin_Centro_pre_2 : e ∉ dom (mi_centro s);
  Sin_Centro_post_1 : r_out = tipo_incorrecto
}.
Record Sin_Radio s s' e r_out : Prop := {
  Sin_Radio_Xi : Xi_Escena s s';
  Sin_Radio_pre_1 : e ∈ elementos s;
  Sin_Radio_pre_2 : e ∉ dom (mi_radio s);
  Sin_Radio_post_1 : r_out = tipo_incorrecto
}.
Record Sin_Vector s s' e r_out : Prop := {
  Sin_Vector_Xi : Xi_Escena s s';
  Sin_Vector_pre_1 : e ∈ elementos s;
  Sin_Vector_pre_2 : e ∉ dom (mi_vector s);
  Sin_Vector_post_1 : r_out = tipo_incorrecto
}.
Record Sin_Altura s s' e r_out : Prop := {
  Sin_Altura_Xi : Xi_Escena s s';
  Sin_Altura_pre_1 : e ∈ elementos s;
  Sin_Altura_pre_2 : e ∉ dom (mi_altura s);
  Sin_Altura_post_1 : r_out = tipo_incorrecto
}.
Record Sin_Proporcion s s' e r_out : Prop := {
  Sin_Proporcion_Xi : Xi_Escena s s';
  Sin_Proporcion_pre_1 : e ∈ elementos s;
  Sin_Proporcion_pre_2 : e ∉ dom (mi_proporcion s);
  Sin_Proporcion_post_1 : r_out = tipo_incorrecto
}.
Record Sin_Vertices s s' e r_out : Prop := {
  Sin_Vertices_Xi : Xi_Escena s s';
  Sin_Vertices_pre_1 : e ∈ elementos s;
  Sin_Vertices_pre_2 : e ∉ dom (mi_vertices s);
  Sin_Vertices_post_1 : r_out = tipo_incorrecto
}.

Definition Cambiar_Centro_Total s s' e r_out c : Prop :=
  Cambiar_Centro s s' e r_out c \/ Elemento_No_Existe s s' e r_out \/ Sin_Centro s s' e r_out.
Definition Cambiar_Radio_Total s s' e r_out rad : Prop :=
  Cambiar_Radio s s' e r_out rad \/ Elemento_No_Existe s s' e r_out \/ Sin_Radio s s' e r_out
  \/ Radio_No_Positivo s s' rad r_out.
Definition Cambiar_Vector_Total s s' e r_out d : Prop :=
  Cambiar_Vector s s' e r_out d \/ Elemento_No_Existe s s' e r_out \/ Sin_Vector s s' e r_out
  \/ Vector_No_Unitario s s' d r_out.
Definition Cambiar_Altura_Total s s' e r_out h : Prop :=
  Cambiar_Altura s s' e r_out h \/ Elemento_No_Existe s s' e r_out \/ Sin_Altura s s' e r_out
  \/ Altura_No_Positiva s s' h r_out.
Definition Cambiar_Proporcion_Total s s' e r_out k : Prop :=
  Cambiar_Proporcion s s' e r_out k \/ Elemento_No_Existe s s' e r_out \/ Sin_Proporcion s s' e r_out
  \/ Proporcion_No_Positiva s s' k r_out.
Definition Cambiar_Vertices_Total s s' e r_out abc : Prop :=
  Cambiar_Vertices s s' e r_out abc \/ Elemento_No_Existe s s' e r_out \/ Sin_Vertices s s' e r_out
  \/ Vertices_Alineados s s' abc r_out.
Definition Cambiar_Centro_Esfera_Total s s' e r_out c : Prop :=
  Cambiar_Centro_Esfera s s' e r_out c \/ Elemento_No_Existe s s' e r_out \/ No_Es_Esfera s s' e r_out.
Definition Cambiar_Radio_Esfera_Total s s' e r_out rad : Prop :=
  Cambiar_Radio_Esfera s s' e r_out rad \/ Elemento_No_Existe s s' e r_out \/ No_Es_Esfera s s' e r_out
  \/ Radio_No_Positivo s s' rad r_out.
Definition Cambiar_Centro_Cilindro_Total s s' e r_out c : Prop :=
  Cambiar_Centro_Cilindro s s' e r_out c \/ Elemento_No_Existe s s' e r_out \/ No_Es_Cilindro s s' e r_out.
Definition Cambiar_Radio_Cilindro_Total s s' e r_out rad : Prop :=
  Cambiar_Radio_Cilindro s s' e r_out rad \/ Elemento_No_Existe s s' e r_out \/ No_Es_Cilindro s s' e r_out
  \/ Radio_No_Positivo s s' rad r_out.
Definition Cambiar_Vector_Cilindro_Total s s' e r_out d : Prop :=
  Cambiar_Vector_Cilindro s s' e r_out d \/ Elemento_No_Existe s s' e r_out \/ No_Es_Cilindro s s' e r_out
  \/ Vector_No_Unitario s s' d r_out.
Definition Cambiar_Altura_Cilindro_Total s s' e r_out h : Prop :=
  Cambiar_Altura_Cilindro s s' e r_out h \/ Elemento_No_Existe s s' e r_out \/ No_Es_Cilindro s s' e r_out
  \/ Altura_No_Positiva s s' h r_out.
Definition Cambiar_Centro_Cono_Total s s' e r_out c : Prop :=
  Cambiar_Centro_Cono s s' e r_out c \/ Elemento_No_Existe s s' e r_out \/ No_Es_Cono s s' e r_out.
Definition Cambiar_Vector_Cono_Total s s' e r_out d : Prop :=
  Cambiar_Vector_Cono s s' e r_out d \/ Elemento_No_Existe s s' e r_out \/ No_Es_Cono s s' e r_out
  \/ Vector_No_Unitario s s' d r_out.
Definition Cambiar_Altura_Cono_Total s s' e r_out h : Prop :=
  Cambiar_Altura_Cono s s' e r_out h \/ Elemento_No_Existe s s' e r_out \/ No_Es_Cono s s' e r_out
  \/ Altura_No_Positiva s s' h r_out.
Definition Cambiar_Proporcion_Cono_Total s s' e r_out k : Prop :=
  Cambiar_Proporcion_Cono s s' e r_out k \/ Elemento_No_Existe s s' e r_out \/ No_Es_Cono s s' e r_out
  \/ Proporcion_No_Positiva s s' k r_out.
Definition Cambiar_Centro_Tronco_Total s s' e r_out c : Prop :=
  Cambiar_Centro_Tronco s s' e r_out c \/ Elemento_No_Existe s s' e r_out \/ No_Es_Tronco s s' e r_out.
Definition Cambiar_Radio_Tronco_Total s s' e r_out rad : Prop :=
  Cambiar_Radio_Tronco s s' e r_out rad \/ Elemento_No_Existe s s' e r_out \/ No_Es_Tronco s s' e r_out
  \/ Radio_No_Positivo s s' rad r_out.
Definition Cambiar_Vector_Tronco_Total s s' e r_out d : Prop :=
  Cambiar_Vector_Tronco s s' e r_out d \/ Elemento_No_Existe s s' e r_out \/ No_Es_Tronco s s' e r_out
  \/ Vector_No_Unitario s s' d r_out.
Definition Cambiar_Altura_Tronco_Total s s' e r_out h : Prop :=
  Cambiar_Altura_Tronco s s' e r_out h \/ Elemento_No_Existe s s' e r_out \/ No_Es_Tronco s s' e r_out
  \/ Altura_No_Positiva s s' h r_out.
Definition Cambiar_Proporcion_Tronco_Total s s' e r_out k : Prop :=
  Cambiar_Proporcion_Tronco s s' e r_out k \/ Elemento_No_Existe s s' e r_out \/ No_Es_Tronco s s' e r_out
  \/ Proporcion_No_Positiva s s' k r_out.
Definition Cambiar_Centro_Plano_Total s s' e r_out c : Prop :=
  Cambiar_Centro_Plano s s' e r_out c \/ Elemento_No_Existe s s' e r_out \/ No_Es_Plano s s' e r_out.
Definition Cambiar_Vector_Plano_Total s s' e r_out d : Prop :=
  Cambiar_Vector_Plano s s' e r_out d \/ Elemento_No_Existe s s' e r_out \/ No_Es_Plano s s' e r_out
  \/ Vector_No_Unitario s s' d r_out.
Definition Cambiar_Centro_Disco_Total s s' e r_out c : Prop :=
  Cambiar_Centro_Disco s s' e r_out c \/ Elemento_No_Existe s s' e r_out \/ No_Es_Disco s s' e r_out.
Definition Cambiar_Radio_Disco_Total s s' e r_out rad : Prop :=
  Cambiar_Radio_Disco s s' e r_out rad \/ Elemento_No_Existe s s' e r_out \/ No_Es_Disco s s' e r_out
  \/ Radio_No_Positivo s s' rad r_out.
Definition Cambiar_Vector_Disco_Total s s' e r_out d : Prop :=
  Cambiar_Vector_Disco s s' e r_out d \/ Elemento_No_Existe s s' e r_out \/ No_Es_Disco s s' e r_out
  \/ Vector_No_Unitario s s' d r_out.
Definition Cambiar_Vertices_Triangulo_Total s s' e r_out abc : Prop :=
  Cambiar_Vertices_Triangulo s s' e r_out abc \/ Elemento_No_Existe s s' e r_out \/ No_Es_Triangulo s s' e r_out
  \/ Vertices_Alineados s s' abc r_out.

Definition Cambiar_Centro_Total_conj_1 : Prop := forall s e c, Escena_ok s ->
  exists s' r_out, Cambiar_Centro_Total s s' e r_out c.
Definition Cambiar_Radio_Total_conj_1 : Prop := forall s e rad, Escena_ok s ->
  exists s' r_out, Cambiar_Radio_Total s s' e r_out rad.
Definition Cambiar_Vector_Total_conj_1 : Prop := forall s e d, Escena_ok s ->
  exists s' r_out, Cambiar_Vector_Total s s' e r_out d.
Definition Cambiar_Altura_Total_conj_1 : Prop := forall s e h, Escena_ok s ->
  exists s' r_out, Cambiar_Altura_Total s s' e r_out h.
Definition Cambiar_Proporcion_Total_conj_1 : Prop := forall s e k, Escena_ok s ->
  exists s' r_out, Cambiar_Proporcion_Total s s' e r_out k.
Definition Cambiar_Vertices_Total_conj_1 : Prop := forall s e abc, Escena_ok s ->
  exists s' r_out, Cambiar_Vertices_Total s s' e r_out abc.
Definition Cambiar_Centro_Esfera_Total_conj_1 : Prop := forall s e c, Escena_ok s ->
  exists s' r_out, Cambiar_Centro_Esfera_Total s s' e r_out c.
Definition Cambiar_Radio_Esfera_Total_conj_1 : Prop := forall s e rad, Escena_ok s ->
  exists s' r_out, Cambiar_Radio_Esfera_Total s s' e r_out rad.
Definition Cambiar_Centro_Cilindro_Total_conj_1 : Prop := forall s e c, Escena_ok s ->
  exists s' r_out, Cambiar_Centro_Cilindro_Total s s' e r_out c.
Definition Cambiar_Radio_Cilindro_Total_conj_1 : Prop := forall s e rad, Escena_ok s ->
  exists s' r_out, Cambiar_Radio_Cilindro_Total s s' e r_out rad.
Definition Cambiar_Vector_Cilindro_Total_conj_1 : Prop := forall s e d, Escena_ok s ->
  exists s' r_out, Cambiar_Vector_Cilindro_Total s s' e r_out d.
Definition Cambiar_Altura_Cilindro_Total_conj_1 : Prop := forall s e h, Escena_ok s ->
  exists s' r_out, Cambiar_Altura_Cilindro_Total s s' e r_out h.
Definition Cambiar_Centro_Cono_Total_conj_1 : Prop := forall s e c, Escena_ok s ->
  exists s' r_out, Cambiar_Centro_Cono_Total s s' e r_out c.
Definition Cambiar_Vector_Cono_Total_conj_1 : Prop := forall s e d, Escena_ok s ->
  exists s' r_out, Cambiar_Vector_Cono_Total s s' e r_out d.
Definition Cambiar_Altura_Cono_Total_conj_1 : Prop := forall s e h, Escena_ok s ->
  exists s' r_out, Cambiar_Altura_Cono_Total s s' e r_out h.
Definition Cambiar_Proporcion_Cono_Total_conj_1 : Prop := forall s e k, Escena_ok s ->
  exists s' r_out, Cambiar_Proporcion_Cono_Total s s' e r_out k.
Definition Cambiar_Centro_Tronco_Total_conj_1 : Prop := forall s e c, Escena_ok s ->
  exists s' r_out, Cambiar_Centro_Tronco_Total s s' e r_out c.
Definition Cambiar_Radio_Tronco_Total_conj_1 : Prop := forall s e rad, Escena_ok s ->
  exists s' r_out, Cambiar_Radio_Tronco_Total s s' e r_out rad.
Definition Cambiar_Vector_Tronco_Total_conj_1 : Prop := forall s e d, Escena_ok s ->
  exists s' r_out, Cambiar_Vector_Tronco_Total s s' e r_out d.
Definition Cambiar_Altura_Tronco_Total_conj_1 : Prop := forall s e h, Escena_ok s ->
  exists s' r_out, Cambiar_Altura_Tronco_Total s s' e r_out h.
Definition Cambiar_Proporcion_Tronco_Total_conj_1 : Prop := forall s e k, Escena_ok s ->
  exists s' r_out, Cambiar_Proporcion_Tronco_Total s s' e r_out k.
Definition Cambiar_Centro_Plano_Total_conj_1 : Prop := forall s e c, Escena_ok s ->
  exists s' r_out, Cambiar_Centro_Plano_Total s s' e r_out c.
Definition Cambiar_Vector_Plano_Total_conj_1 : Prop := forall s e d, Escena_ok s ->
  exists s' r_out, Cambiar_Vector_Plano_Total s s' e r_out d.
Definition Cambiar_Centro_Disco_Total_conj_1 : Prop := forall s e c, Escena_ok s ->
  exists s' r_out, Cambiar_Centro_Disco_Total s s' e r_out c.
Definition Cambiar_Radio_Disco_Total_conj_1 : Prop := forall s e rad, Escena_ok s ->
  exists s' r_out, Cambiar_Radio_Disco_Total s s' e r_out rad.
Definition Cambiar_Vector_Disco_Total_conj_1 : Prop := forall s e d, Escena_ok s ->
  exists s' r_out, Cambiar_Vector_Disco_Total s s' e r_out d.
Definition Cambiar_Vertices_Triangulo_Total_conj_1 : Prop := forall s e abc, Escena_ok s ->
  exists s' r_out, Cambiar_Vertices_Triangulo_Total s s' e r_out abc.

(** ** What undoes an operation *)

Definition Elemento_Agregado_conj_1 : Prop := forall s s' e t c rad d h k abc r_out,
  Elemento_Agregado s s' e t c rad d h k abc r_out -> exists r_out, Elemento_Eliminado s' s e r_out.
Definition Elemento_Eliminado_conj_1 : Prop := forall s s' e r_out, Elemento_Eliminado s s' e r_out ->
  exists t, (e, t) ∈ de_que_tipo s /\ exists c rad d h k abc r_out, Elemento_Agregado s' s e t c rad d h k abc r_out.
Definition Eliminar_Esfera_conj_1 : Prop := forall s s' e r_out, Eliminar_Esfera s s' e r_out ->
  exists c rad, (e, c) ∈ mi_centro s /\ (e, rad) ∈ mi_radio s
  /\ exists t r_out, Agregar_Esfera s' s e t r_out c rad.
Definition Cambiar_Centro_conj_1 : Prop := forall s s' e r_out c, Cambiar_Centro s s' e r_out c ->
  exists c, (e, c) ∈ mi_centro s /\ exists r_out, Cambiar_Centro s' s e r_out c.
Definition Cambiar_Radio_conj_1 : Prop := forall s s' e r_out rad, Cambiar_Radio s s' e r_out rad ->
  exists rad, (e, rad) ∈ mi_radio s /\ exists r_out, Cambiar_Radio s' s e r_out rad.
Definition Cambiar_Vector_conj_1 : Prop := forall s s' e r_out d, Cambiar_Vector s s' e r_out d ->
  exists d, (e, d) ∈ mi_vector s /\ exists r_out, Cambiar_Vector s' s e r_out d.
Definition Cambiar_Altura_conj_1 : Prop := forall s s' e r_out h, Cambiar_Altura s s' e r_out h ->
  exists h, (e, h) ∈ mi_altura s /\ exists r_out, Cambiar_Altura s' s e r_out h.
Definition Cambiar_Proporcion_conj_1 : Prop := forall s s' e r_out k, Cambiar_Proporcion s s' e r_out k ->
  exists k, (e, k) ∈ mi_proporcion s /\ exists r_out, Cambiar_Proporcion s' s e r_out k.
Definition Cambiar_Vertices_conj_1 : Prop := forall s s' e r_out abc, Cambiar_Vertices s s' e r_out abc ->
  exists abc, (e, abc) ∈ mi_vertices s /\ exists r_out, Cambiar_Vertices s' s e r_out abc.

(** ** Beside meshes *)

Definition Cambio_Total s s' e c rad d h k abc r_out : Prop :=
  Cambiar_Centro_Total s s' e r_out c \/ Cambiar_Radio_Total s s' e r_out rad \/ Cambiar_Vector_Total s s' e r_out d
  \/ Cambiar_Altura_Total s s' e r_out h \/ Cambiar_Proporcion_Total s s' e r_out k
  \/ Cambiar_Vertices_Total s s' e r_out abc.

Variable nombre_cara : rel (Elemento * nat) Elemento.
Notation Mallas := (Malla.Mallas Elemento).
Notation escena := (Malla.escena Elemento).
Notation mallas := (Malla.mallas Elemento).
Implicit Types (S : Mallas) (r : Red).

Definition Cambio_Mallas S S' e c rad d h k abc r_out : Prop :=
  (Cambio_Total (escena S) (escena S') e c rad d h k abc r_out /\ Mismas_Mallas Elemento nombre_cara S S'
   /\ Fuera_De_Malla Elemento nombre_cara S e)
  \/ Es_De_Malla Elemento nombre_cara S S' e r_out.

Definition Cambio_Mallas_conj_1 : Prop := forall S e c rad d h k abc, Mallas_ok Elemento nombre_cara S ->
  exists S' r_out, Cambio_Mallas S S' e c rad d h k abc r_out.

Definition Agregar_Malla_conj_1 : Prop := forall S S' m r r_out, Agregar_Malla Elemento nombre_cara S S' m r r_out ->
  exists r_out, Eliminar_Malla Elemento nombre_cara S' S m r_out.
Definition Eliminar_Malla_conj_2 : Prop := forall S S' m r_out, Eliminar_Malla Elemento nombre_cara S S' m r_out ->
  exists r, (m, r) ∈ mallas S /\ exists r_out, Agregar_Malla Elemento nombre_cara S' S m r r_out.
Definition Reemplazar_Malla_conj_2 : Prop := forall S S' m r r_out,
  Reemplazar_Malla Elemento nombre_cara S S' m r r_out ->
  exists r, (m, r) ∈ mallas S /\ exists r_out, Reemplazar_Malla Elemento nombre_cara S' S m r r_out.
Definition Mover_Vertice_conj_2 : Prop := forall S S' m n p r_out,
  Mover_Vertice Elemento nombre_cara S S' m n p r_out ->
  exists r p, (m, r) ∈ mallas S /\ (n, p) ∈ numbered (puntos r)
  /\ exists r_out, Mover_Vertice Elemento nombre_cara S' S m n p r_out.
End Cambios.
