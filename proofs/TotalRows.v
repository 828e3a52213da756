(** spec/tablas.tex, by hand as Tablas.v is: the total operations on the tables, what each of them refuses, and what is
    to be shown of them. RowsRefused.v proves it.

    Xi_Tablas            == Ξ Tablas
    S \ (x)              == exists x, S *)
From Coq Require Import Reals.
From Durero Require Import Toolkit Especificacion Escena Operaciones Tablas.
Local Open Scope zed_scope.

Section TotalRows.
Context {Elemento : Type}.
Notation Escena := (Especificacion.Escena Elemento).
Notation Tablas := (Tablas Elemento).
Implicit Types (s : Escena) (e : Elemento) (T : Tablas).

(** ** What is refused *)

Record Xi_Tablas T T' : Prop := {
  Xi_Tablas_before : Tablas_ok T;
  Xi_Tablas_after : Tablas_ok T';
  Xi_Tablas_eq : Tablas_eq T T'
}.

Definition Elemento_Ya_Existe_Tablas T T' e r_out : Prop :=
  Xi_Tablas T T' /\ e ∈ dom (lugar T) /\ r_out = elemento_ya_existe.
Definition Elemento_No_Existe_Tablas T T' e r_out : Prop :=
  Xi_Tablas T T' /\ e ∉ dom (lugar T) /\ r_out = elemento_no_existe.
Definition Radio_No_Positivo_Tablas T T' r r_out : Prop := Xi_Tablas T T' /\ r ∉ Rmas /\ r_out = radio_no_positivo.
Definition Vector_No_Unitario_Tablas T T' d r_out : Prop :=
  Xi_Tablas T T' /\ d ∉ Unitario /\ r_out = vector_no_unitario.
Definition Altura_No_Positiva_Tablas T T' h r_out : Prop := Xi_Tablas T T' /\ h ∉ Rmas /\ r_out = altura_no_positiva.
Definition Proporcion_No_Positiva_Tablas T T' k r_out : Prop :=
  Xi_Tablas T T' /\ k ∉ Rmas /\ r_out = proporcion_no_positiva.
Definition Vertices_Alineados_Tablas T T' abc r_out : Prop :=
  Xi_Tablas T T' /\ abc ∉ Vertices /\ r_out = vertices_alineados.
Definition De_Otra_Tabla T T' e t r_out : Prop :=
  Xi_Tablas T T' /\ e ∈ dom (lugar T) /\ (exists p, (e, p) ∈ lugar T /\ tabla p <> t) /\ r_out = tipo_incorrecto.

(** ** The total operations, and what is to be shown of each *)

Definition Agregar_Esfera_Total_Tablas T T' e r_out c r : Prop :=
(exists t, Agregar_Esfera_Tablas T T' e t r_out c r) \/ Elemento_Ya_Existe_Tablas T T' e r_out \/
  Radio_No_Positivo_Tablas T T' r r_out.
Definition Agregar_Esfera_Total_Tablas_conj_1 : Prop := forall T e c r, Tablas_ok T -> exists T' r_out,
  Agregar_Esfera_Total_Tablas T T' e r_out c r.
Definition Agregar_Esfera_Total_Tablas_conj_2 : Prop := forall s T T' e r_out c r, Retrieve s T ->
  Agregar_Esfera_Total_Tablas T T' e r_out c r -> exists s', Retrieve s' T' /\ Agregar_Esfera_Total s s' e r_out c r.

Definition Agregar_Cilindro_Total_Tablas T T' e r_out c r d h : Prop :=
(exists t, Agregar_Cilindro_Tablas T T' e t r_out c r d h) \/ Elemento_Ya_Existe_Tablas T T' e r_out \/
  Radio_No_Positivo_Tablas T T' r r_out \/ Vector_No_Unitario_Tablas T T' d r_out \/ Altura_No_Positiva_Tablas T T' h
  r_out.
Definition Agregar_Cilindro_Total_Tablas_conj_1 : Prop := forall T e c r d h, Tablas_ok T -> exists T' r_out,
  Agregar_Cilindro_Total_Tablas T T' e r_out c r d h.
Definition Agregar_Cilindro_Total_Tablas_conj_2 : Prop := forall s T T' e r_out c r d h, Retrieve s T ->
  Agregar_Cilindro_Total_Tablas T T' e r_out c r d h -> exists s', Retrieve s' T' /\ Agregar_Cilindro_Total s s' e
  r_out c r d h.

Definition Agregar_Cono_Total_Tablas T T' e r_out c k d h : Prop :=
(exists t, Agregar_Cono_Tablas T T' e t r_out c k d h) \/ Elemento_Ya_Existe_Tablas T T' e r_out \/
  Proporcion_No_Positiva_Tablas T T' k r_out \/ Vector_No_Unitario_Tablas T T' d r_out \/ Altura_No_Positiva_Tablas T
  T' h r_out.
Definition Agregar_Cono_Total_Tablas_conj_1 : Prop := forall T e c k d h, Tablas_ok T -> exists T' r_out,
  Agregar_Cono_Total_Tablas T T' e r_out c k d h.
Definition Agregar_Cono_Total_Tablas_conj_2 : Prop := forall s T T' e r_out c k d h, Retrieve s T ->
  Agregar_Cono_Total_Tablas T T' e r_out c k d h -> exists s', Retrieve s' T' /\ Agregar_Cono_Total s s' e r_out c k d
  h.

Definition Agregar_Tronco_Total_Tablas T T' e r_out c r k d h : Prop :=
(exists t, Agregar_Tronco_Tablas T T' e t r_out c r k d h) \/ Elemento_Ya_Existe_Tablas T T' e r_out \/
  Radio_No_Positivo_Tablas T T' r r_out \/ Proporcion_No_Positiva_Tablas T T' k r_out \/ Vector_No_Unitario_Tablas T
  T' d r_out \/ Altura_No_Positiva_Tablas T T' h r_out.
Definition Agregar_Tronco_Total_Tablas_conj_1 : Prop := forall T e c r k d h, Tablas_ok T -> exists T' r_out,
  Agregar_Tronco_Total_Tablas T T' e r_out c r k d h.
Definition Agregar_Tronco_Total_Tablas_conj_2 : Prop := forall s T T' e r_out c r k d h, Retrieve s T ->
  Agregar_Tronco_Total_Tablas T T' e r_out c r k d h -> exists s', Retrieve s' T' /\ Agregar_Tronco_Total s s' e r_out
  c r k d h.

Definition Agregar_Plano_Total_Tablas T T' e r_out c d : Prop :=
(exists t, Agregar_Plano_Tablas T T' e t r_out c d) \/ Elemento_Ya_Existe_Tablas T T' e r_out \/
  Vector_No_Unitario_Tablas T T' d r_out.
Definition Agregar_Plano_Total_Tablas_conj_1 : Prop := forall T e c d, Tablas_ok T -> exists T' r_out,
  Agregar_Plano_Total_Tablas T T' e r_out c d.
Definition Agregar_Plano_Total_Tablas_conj_2 : Prop := forall s T T' e r_out c d, Retrieve s T ->
  Agregar_Plano_Total_Tablas T T' e r_out c d -> exists s', Retrieve s' T' /\ Agregar_Plano_Total s s' e r_out c d.

Definition Agregar_Disco_Total_Tablas T T' e r_out c r d : Prop :=
(exists t, Agregar_Disco_Tablas T T' e t r_out c r d) \/ Elemento_Ya_Existe_Tablas T T' e r_out \/
  Radio_No_Positivo_Tablas T T' r r_out \/ Vector_No_Unitario_Tablas T T' d r_out.
Definition Agregar_Disco_Total_Tablas_conj_1 : Prop := forall T e c r d, Tablas_ok T -> exists T' r_out,
  Agregar_Disco_Total_Tablas T T' e r_out c r d.
Definition Agregar_Disco_Total_Tablas_conj_2 : Prop := forall s T T' e r_out c r d, Retrieve s T ->
  Agregar_Disco_Total_Tablas T T' e r_out c r d -> exists s', Retrieve s' T' /\ Agregar_Disco_Total s s' e r_out c r
  d.

Definition Agregar_Triangulo_Total_Tablas T T' e r_out abc : Prop :=
(exists t, Agregar_Triangulo_Tablas T T' e t r_out abc) \/ Elemento_Ya_Existe_Tablas T T' e r_out \/
  Vertices_Alineados_Tablas T T' abc r_out.
Definition Agregar_Triangulo_Total_Tablas_conj_1 : Prop := forall T e abc, Tablas_ok T -> exists T' r_out,
  Agregar_Triangulo_Total_Tablas T T' e r_out abc.
Definition Agregar_Triangulo_Total_Tablas_conj_2 : Prop := forall s T T' e r_out abc, Retrieve s T ->
  Agregar_Triangulo_Total_Tablas T T' e r_out abc -> exists s', Retrieve s' T' /\ Agregar_Triangulo_Total s s' e r_out
  abc.

Definition Eliminar_Esfera_Total_Tablas T T' e r_out : Prop :=
Eliminar_Esfera_Tablas T T' e r_out \/ Elemento_No_Existe_Tablas T T' e r_out \/ (exists t, De_Otra_Tabla T T' e t
  r_out /\ t = soy_esfera).
Definition Eliminar_Esfera_Total_Tablas_conj_1 : Prop := forall T e, Tablas_ok T -> exists T' r_out,
  Eliminar_Esfera_Total_Tablas T T' e r_out.
Definition Eliminar_Esfera_Total_Tablas_conj_2 : Prop := forall s T T' e r_out, Retrieve s T ->
  Eliminar_Esfera_Total_Tablas T T' e r_out -> exists s', Retrieve s' T' /\ Eliminar_Esfera_Total s s' e r_out.

Definition Eliminar_Cilindro_Total_Tablas T T' e r_out : Prop :=
Eliminar_Cilindro_Tablas T T' e r_out \/ Elemento_No_Existe_Tablas T T' e r_out \/ (exists t, De_Otra_Tabla T T' e t
  r_out /\ t = soy_cilindro).
Definition Eliminar_Cilindro_Total_Tablas_conj_1 : Prop := forall T e, Tablas_ok T -> exists T' r_out,
  Eliminar_Cilindro_Total_Tablas T T' e r_out.
Definition Eliminar_Cilindro_Total_Tablas_conj_2 : Prop := forall s T T' e r_out, Retrieve s T ->
  Eliminar_Cilindro_Total_Tablas T T' e r_out -> exists s', Retrieve s' T' /\ Eliminar_Cilindro_Total s s' e r_out.

Definition Eliminar_Cono_Total_Tablas T T' e r_out : Prop :=
Eliminar_Cono_Tablas T T' e r_out \/ Elemento_No_Existe_Tablas T T' e r_out \/ (exists t, De_Otra_Tabla T T' e t r_out
  /\ t = soy_cono).
Definition Eliminar_Cono_Total_Tablas_conj_1 : Prop := forall T e, Tablas_ok T -> exists T' r_out,
  Eliminar_Cono_Total_Tablas T T' e r_out.
Definition Eliminar_Cono_Total_Tablas_conj_2 : Prop := forall s T T' e r_out, Retrieve s T ->
  Eliminar_Cono_Total_Tablas T T' e r_out -> exists s', Retrieve s' T' /\ Eliminar_Cono_Total s s' e r_out.

Definition Eliminar_Tronco_Total_Tablas T T' e r_out : Prop :=
Eliminar_Tronco_Tablas T T' e r_out \/ Elemento_No_Existe_Tablas T T' e r_out \/ (exists t, De_Otra_Tabla T T' e t
  r_out /\ t = soy_tronco).
Definition Eliminar_Tronco_Total_Tablas_conj_1 : Prop := forall T e, Tablas_ok T -> exists T' r_out,
  Eliminar_Tronco_Total_Tablas T T' e r_out.
Definition Eliminar_Tronco_Total_Tablas_conj_2 : Prop := forall s T T' e r_out, Retrieve s T ->
  Eliminar_Tronco_Total_Tablas T T' e r_out -> exists s', Retrieve s' T' /\ Eliminar_Tronco_Total s s' e r_out.

Definition Eliminar_Plano_Total_Tablas T T' e r_out : Prop :=
Eliminar_Plano_Tablas T T' e r_out \/ Elemento_No_Existe_Tablas T T' e r_out \/ (exists t, De_Otra_Tabla T T' e t
  r_out /\ t = soy_plano).
Definition Eliminar_Plano_Total_Tablas_conj_1 : Prop := forall T e, Tablas_ok T -> exists T' r_out,
  Eliminar_Plano_Total_Tablas T T' e r_out.
Definition Eliminar_Plano_Total_Tablas_conj_2 : Prop := forall s T T' e r_out, Retrieve s T ->
  Eliminar_Plano_Total_Tablas T T' e r_out -> exists s', Retrieve s' T' /\ Eliminar_Plano_Total s s' e r_out.

Definition Eliminar_Disco_Total_Tablas T T' e r_out : Prop :=
Eliminar_Disco_Tablas T T' e r_out \/ Elemento_No_Existe_Tablas T T' e r_out \/ (exists t, De_Otra_Tabla T T' e t
  r_out /\ t = soy_disco).
Definition Eliminar_Disco_Total_Tablas_conj_1 : Prop := forall T e, Tablas_ok T -> exists T' r_out,
  Eliminar_Disco_Total_Tablas T T' e r_out.
Definition Eliminar_Disco_Total_Tablas_conj_2 : Prop := forall s T T' e r_out, Retrieve s T ->
  Eliminar_Disco_Total_Tablas T T' e r_out -> exists s', Retrieve s' T' /\ Eliminar_Disco_Total s s' e r_out.

Definition Eliminar_Triangulo_Total_Tablas T T' e r_out : Prop :=
Eliminar_Triangulo_Tablas T T' e r_out \/ Elemento_No_Existe_Tablas T T' e r_out \/ (exists t, De_Otra_Tabla T T' e t
  r_out /\ t = soy_triangulo).
Definition Eliminar_Triangulo_Total_Tablas_conj_1 : Prop := forall T e, Tablas_ok T -> exists T' r_out,
  Eliminar_Triangulo_Total_Tablas T T' e r_out.
Definition Eliminar_Triangulo_Total_Tablas_conj_2 : Prop := forall s T T' e r_out, Retrieve s T ->
  Eliminar_Triangulo_Total_Tablas T T' e r_out -> exists s', Retrieve s' T' /\ Eliminar_Triangulo_Total s s' e r_out.

Definition Elemento_Agregado_Tablas T T' e t c r d h k abc r_out : Prop :=
  (exists r_out, Agregar_Esfera_Tablas T T' e t r_out c r
  \/ Agregar_Cilindro_Tablas T T' e t r_out c r d h
  \/ Agregar_Cono_Tablas T T' e t r_out c k d h
  \/ Agregar_Tronco_Tablas T T' e t r_out c r k d h
  \/ Agregar_Plano_Tablas T T' e t r_out c d
  \/ Agregar_Disco_Tablas T T' e t r_out c r d
  \/ Agregar_Triangulo_Tablas T T' e t r_out abc) /\ r_out = elemento_agregado.
Definition Agregar_Elemento_Total_Tablas T T' e t c r d h k abc r_out : Prop :=
  Elemento_Agregado_Tablas T T' e t c r d h k abc r_out \/ Elemento_Ya_Existe_Tablas T T' e r_out
  \/ Radio_No_Positivo_Tablas T T' r r_out /\ Con_Radio t
  \/ Proporcion_No_Positiva_Tablas T T' k r_out /\ Con_Proporcion t
  \/ Vector_No_Unitario_Tablas T T' d r_out /\ Con_Vector t
  \/ Altura_No_Positiva_Tablas T T' h r_out /\ Con_Altura t
  \/ Vertices_Alineados_Tablas T T' abc r_out /\ Con_Vertices t.
Definition Agregar_Elemento_Total_Tablas_conj_1 : Prop := forall T e t c r d h k abc, Tablas_ok T -> exists T' r_out,
  Agregar_Elemento_Total_Tablas T T' e t c r d h k abc r_out.
Definition Agregar_Elemento_Total_Tablas_conj_2 : Prop := forall s T T' e t c r d h k abc r_out, Retrieve s T ->
  Agregar_Elemento_Total_Tablas T T' e t c r d h k abc r_out -> exists s', Retrieve s' T' /\ Agregar_Elemento_Total s
  s' e t c r d h k abc r_out.

Definition Elemento_Eliminado_Tablas T T' e r_out : Prop :=
(exists r_out, Eliminar_Esfera_Tablas T T' e r_out \/ Eliminar_Cilindro_Tablas T T' e r_out \/ Eliminar_Cono_Tablas T
  T' e r_out \/ Eliminar_Tronco_Tablas T T' e r_out \/ Eliminar_Plano_Tablas T T' e r_out \/ Eliminar_Disco_Tablas T
  T' e r_out \/ Eliminar_Triangulo_Tablas T T' e r_out) /\ r_out = elemento_eliminado.
Definition Eliminar_Elemento_Total_Tablas T T' e r_out : Prop :=
  Elemento_Eliminado_Tablas T T' e r_out \/ Elemento_No_Existe_Tablas T T' e r_out.
Definition Eliminar_Elemento_Total_Tablas_conj_1 : Prop := forall T e, Tablas_ok T -> exists T' r_out,
  Eliminar_Elemento_Total_Tablas T T' e r_out.
Definition Eliminar_Elemento_Total_Tablas_conj_2 : Prop := forall s T T' e r_out, Retrieve s T ->
  Eliminar_Elemento_Total_Tablas T T' e r_out -> exists s', Retrieve s' T' /\ Eliminar_Elemento_Total s s' e r_out.
End TotalRows.
