(** spec/tablas.tex, by hand: the tables as the text has them, what scene they stand for, and the obligations of the
    refinement. The export covers one state only, so what is stated here is this file's reading of the text; its rules are
    those at the head of Especificacion.v, and further

    Lugar, tabla p       == Tipo × ℕ, with Coq's nat for ℕ, and the first of p
    cuantos              == a total function on a whole type is a function
    comp f g             == f ⨾ g;  f ⊕ g == override
    places n             == ⋃ { t : Tipo • { t } × (0 .. n(t) − 1) }
    a label A.kind.n      == the field A_kind_n; of a definition, the definition A
    Ξ Centros            == centros' = centros; likewise of the other columns
    grown T' e v f f'    == f' = f ∪ { lugar'(e) ↦ v }
    raices a b c         == the closed form: the solutions of a·t² + 2b·t + c = 0 *)
From Coq Require Import Reals List Lia Lra Arith Setoid Morphisms.
From Durero Require Import Toolkit Especificacion Escena Operaciones Tipos Puntos Trazador Interseccion.
From Durero Require Retrieve.
Local Open Scope zed_scope.

Definition comp {X Y Z} (f : rel X Y) (g : rel Y Z) : rel X Z := fun p => exists y, f (fst p, y) /\ g (y, snd p).
Definition oplus {X Y} (f g : rel X Y) : rel X Y := fun p => g p \/ (fst p ∉ dom g /\ f p).
Definition id_on {X} (A : set X) : rel X X := fun p => fst p ∈ A /\ snd p = fst p.

Definition Lugar : Type := Tipo * nat.
Definition tabla (p : Lugar) : Tipo := fst p.
Definition places (n : Tipo -> nat) : set Lugar := fun p => (snd p < n (tabla p))%nat.

Lemma pair_eq {X Y} (a a' : X) (b b' : Y) : (a, b) = (a', b') -> a = a' /\ b = b'.
Proof. now intros [= -> ->]. Qed.

Global Instance comp_proper {X Y Z} : Proper (seteq ==> seteq ==> seteq) (@comp X Y Z).
Proof. intros f f' H g g' H' p. unfold comp. setoid_rewrite (H _). now setoid_rewrite (H' _). Qed.

Section Tablas.
Context {Elemento : Type}.
Notation Escena := (Especificacion.Escena Elemento).
Implicit Types (s : Escena) (e : Elemento).

(** ** The state *)

Record Tablas := mk_Tablas {
  lugar : rel Elemento Lugar;
  cuantos : Tipo -> nat;
  nombres : rel Lugar Elemento;
  centros : rel Lugar Punto;
  radios : rel Lugar R;
  vectores : rel Lugar Vector;
  alturas : rel Lugar R;
  proporciones : rel Lugar R;
  ternas : rel Lugar Terna
}.
Implicit Types T : Tablas.

Record Tablas_ok T : Prop := {
  Tablas_decl_lugar : lugar T ∈ (univ ⇸ univ);
  Tablas_decl_finite : dom (lugar T) ∈ 𝔽 univ;
  Tablas_decl_nombres : nombres T ∈ (univ ⇸ univ);
  Tablas_decl_centros : centros T ∈ (univ ⇸ univ);
  Tablas_decl_radios : radios T ∈ (univ ⇸ Rmas);
  Tablas_decl_vectores : vectores T ∈ (univ ⇸ Unitario);
  Tablas_decl_alturas : alturas T ∈ (univ ⇸ Rmas);
  Tablas_decl_proporciones : proporciones T ∈ (univ ⇸ Rmas);
  Tablas_decl_ternas : ternas T ∈ (univ ⇸ Vertices);
  Tablas_inv_1 : ran (lugar T) ≡ places (cuantos T);
  Tablas_inv_2 : nombres T ≡ inverse (lugar T);
  Tablas_inv_3 : dom (centros T) ≡ dres centro_types (ran (lugar T));
  Tablas_inv_4 : dom (radios T) ≡ dres radio_types (ran (lugar T));
  Tablas_inv_5 : dom (vectores T) ≡ dres vector_types (ran (lugar T));
  Tablas_inv_6 : dom (alturas T) ≡ dres altura_types (ran (lugar T));
  Tablas_inv_7 : dom (proporciones T) ≡ dres proporcion_types (ran (lugar T));
  Tablas_inv_8 : dom (ternas T) ≡ dres vertices_types (ran (lugar T))
}.

Record Tablas_eq T T' : Prop := {
  Tablas_eq_lugar : lugar T' ≡ lugar T;
  Tablas_eq_cuantos : forall t, cuantos T' t = cuantos T t;
  Tablas_eq_nombres : nombres T' ≡ nombres T;
  Tablas_eq_centros : centros T' ≡ centros T;
  Tablas_eq_radios : radios T' ≡ radios T;
  Tablas_eq_vectores : vectores T' ≡ vectores T;
  Tablas_eq_alturas : alturas T' ≡ alturas T;
  Tablas_eq_proporciones : proporciones T' ≡ proporciones T;
  Tablas_eq_ternas : ternas T' ≡ ternas T
}.

Record Init_Tablas T' : Prop := {
  Init_Tablas_Tablas : Tablas_ok T';
  Init_Tablas_post_1 : lugar T' ≡ ∅
}.

Definition tabla_of : rel Lugar Tipo := fun p => snd p = tabla (fst p).
Record Retrieve s T : Prop := {
  Retrieve_Escena : Escena_ok s;
  Retrieve_Tablas : Tablas_ok T;
  Retrieve_inv_1 : de_que_tipo s ≡ comp (lugar T) tabla_of;
  Retrieve_inv_2 : mi_centro s ≡ comp (lugar T) (centros T);
  Retrieve_inv_3 : mi_radio s ≡ comp (lugar T) (radios T);
  Retrieve_inv_4 : mi_vector s ≡ comp (lugar T) (vectores T);
  Retrieve_inv_5 : mi_altura s ≡ comp (lugar T) (alturas T);
  Retrieve_inv_6 : mi_proporcion s ≡ comp (lugar T) (proporciones T);
  Retrieve_inv_7 : mi_vertices s ≡ comp (lugar T) (ternas T)
}.

Definition Retrieve_conj_1 : Prop := forall T, Tablas_ok T ->
  exists s, Retrieve s T /\ forall s', Retrieve s' T -> Escena_eq s s'.
Definition Init_Tablas_conj_1 : Prop := forall T', Init_Tablas T' -> exists s', Retrieve s' T' /\ Init s'.
Definition Init_Tablas_conj_2 : Prop := exists T', Init_Tablas T'.
Definition Retrieve_conj_2 : Prop := forall s T s' T', Retrieve s T -> Retrieve s' T' -> Tablas_eq T T' -> Xi_Escena s s'.
Definition Retrieve_conj_3 : Prop := forall s T, Retrieve s T -> elementos s ≡ dom (lugar T).

(** ** The operations *)

Record Agregar_Fila T T' e t : Prop := {
  Agregar_Fila_before : Tablas_ok T;
  Agregar_Fila_after : Tablas_ok T';
  Agregar_Fila_pre_1 : e ∉ dom (lugar T);
  Agregar_Fila_post_1 : lugar T' ≡ lugar T ∪ ⦃(e, (t, cuantos T t))⦄;
  Agregar_Fila_post_2 : cuantos T' t = (cuantos T t + 1)%nat /\ forall u, u <> t -> cuantos T' u = cuantos T u
}.
Definition grown {V} T' e (v : V) (f f' : rel Lugar V) : Prop := exists p, (e, p) ∈ lugar T' /\ f' ≡ f ∪ ⦃(p, v)⦄.

Definition Agregar_Esfera_Tablas T T' e t r_out c r : Prop :=
  Agregar_Fila T T' e t /\ t = soy_esfera /\ r ∈ Rmas
  /\ grown T' e c (centros T) (centros T') /\ grown T' e r (radios T) (radios T') /\ vectores T' ≡ vectores T
  /\ alturas T' ≡ alturas T /\ proporciones T' ≡ proporciones T /\ ternas T' ≡ ternas T
  /\ r_out = esfera_agregada.

Definition Agregar_Esfera_Tablas_conj_1 : Prop := forall s T e t c r, Retrieve s T ->
  (exists s' r_out, Agregar_Esfera s s' e t r_out c r) -> exists T' r_out,
    Agregar_Esfera_Tablas T T' e t r_out c r.

Definition Agregar_Esfera_Tablas_conj_2 : Prop := forall s T T' e t r_out c r, Retrieve s T ->
  Agregar_Esfera_Tablas T T' e t r_out c r -> exists s', Retrieve s' T' /\ Agregar_Esfera s s' e t r_out c r.

Definition Agregar_Cilindro_Tablas T T' e t r_out c r d h : Prop :=
  Agregar_Fila T T' e t /\ t = soy_cilindro /\ r ∈ Rmas /\ d ∈ Unitario /\ h ∈ Rmas
  /\ grown T' e c (centros T) (centros T') /\ grown T' e r (radios T) (radios T') /\ grown T' e d (vectores T) (vectores T')
  /\ grown T' e h (alturas T) (alturas T') /\ proporciones T' ≡ proporciones T /\ ternas T' ≡ ternas T
  /\ r_out = cilindro_agregado.

Definition Agregar_Cilindro_Tablas_conj_1 : Prop := forall s T e t c r d h, Retrieve s T ->
  (exists s' r_out, Agregar_Cilindro s s' e t r_out c r d h) -> exists T' r_out,
    Agregar_Cilindro_Tablas T T' e t r_out c r d h.

Definition Agregar_Cilindro_Tablas_conj_2 : Prop := forall s T T' e t r_out c r d h, Retrieve s T ->
  Agregar_Cilindro_Tablas T T' e t r_out c r d h -> exists s', Retrieve s' T' /\ Agregar_Cilindro s s' e t r_out c r d h.

Definition Agregar_Cono_Tablas T T' e t r_out c k d h : Prop :=
  Agregar_Fila T T' e t /\ t = soy_cono /\ k ∈ Rmas /\ d ∈ Unitario /\ h ∈ Rmas
  /\ grown T' e c (centros T) (centros T') /\ radios T' ≡ radios T /\ grown T' e d (vectores T) (vectores T')
  /\ grown T' e h (alturas T) (alturas T') /\ grown T' e k (proporciones T) (proporciones T') /\ ternas T' ≡ ternas T
  /\ r_out = cono_agregado.

Definition Agregar_Cono_Tablas_conj_1 : Prop := forall s T e t c k d h, Retrieve s T ->
  (exists s' r_out, Agregar_Cono s s' e t r_out c k d h) -> exists T' r_out,
    Agregar_Cono_Tablas T T' e t r_out c k d h.

Definition Agregar_Cono_Tablas_conj_2 : Prop := forall s T T' e t r_out c k d h, Retrieve s T ->
  Agregar_Cono_Tablas T T' e t r_out c k d h -> exists s', Retrieve s' T' /\ Agregar_Cono s s' e t r_out c k d h.

Definition Agregar_Tronco_Tablas T T' e t r_out c r k d h : Prop :=
  Agregar_Fila T T' e t /\ t = soy_tronco /\ r ∈ Rmas /\ k ∈ Rmas /\ d ∈ Unitario /\ h ∈ Rmas
  /\ grown T' e c (centros T) (centros T') /\ grown T' e r (radios T) (radios T') /\ grown T' e d (vectores T) (vectores T')
  /\ grown T' e h (alturas T) (alturas T') /\ grown T' e k (proporciones T) (proporciones T') /\ ternas T' ≡ ternas T
  /\ r_out = tronco_agregado.

Definition Agregar_Tronco_Tablas_conj_1 : Prop := forall s T e t c r k d h, Retrieve s T ->
  (exists s' r_out, Agregar_Tronco s s' e t r_out c r k d h) -> exists T' r_out,
    Agregar_Tronco_Tablas T T' e t r_out c r k d h.

Definition Agregar_Tronco_Tablas_conj_2 : Prop := forall s T T' e t r_out c r k d h, Retrieve s T ->
  Agregar_Tronco_Tablas T T' e t r_out c r k d h -> exists s', Retrieve s' T' /\ Agregar_Tronco s s' e t r_out c r k d h.

Definition Agregar_Plano_Tablas T T' e t r_out c d : Prop :=
  Agregar_Fila T T' e t /\ t = soy_plano /\ d ∈ Unitario
  /\ grown T' e c (centros T) (centros T') /\ radios T' ≡ radios T /\ grown T' e d (vectores T) (vectores T')
  /\ alturas T' ≡ alturas T /\ proporciones T' ≡ proporciones T /\ ternas T' ≡ ternas T
  /\ r_out = plano_agregado.

Definition Agregar_Plano_Tablas_conj_1 : Prop := forall s T e t c d, Retrieve s T ->
  (exists s' r_out, Agregar_Plano s s' e t r_out c d) -> exists T' r_out,
    Agregar_Plano_Tablas T T' e t r_out c d.

Definition Agregar_Plano_Tablas_conj_2 : Prop := forall s T T' e t r_out c d, Retrieve s T ->
  Agregar_Plano_Tablas T T' e t r_out c d -> exists s', Retrieve s' T' /\ Agregar_Plano s s' e t r_out c d.

Definition Agregar_Disco_Tablas T T' e t r_out c r d : Prop :=
  Agregar_Fila T T' e t /\ t = soy_disco /\ r ∈ Rmas /\ d ∈ Unitario
  /\ grown T' e c (centros T) (centros T') /\ grown T' e r (radios T) (radios T') /\ grown T' e d (vectores T) (vectores T')
  /\ alturas T' ≡ alturas T /\ proporciones T' ≡ proporciones T /\ ternas T' ≡ ternas T
  /\ r_out = disco_agregado.

Definition Agregar_Disco_Tablas_conj_1 : Prop := forall s T e t c r d, Retrieve s T ->
  (exists s' r_out, Agregar_Disco s s' e t r_out c r d) -> exists T' r_out,
    Agregar_Disco_Tablas T T' e t r_out c r d.

Definition Agregar_Disco_Tablas_conj_2 : Prop := forall s T T' e t r_out c r d, Retrieve s T ->
  Agregar_Disco_Tablas T T' e t r_out c r d -> exists s', Retrieve s' T' /\ Agregar_Disco s s' e t r_out c r d.

Definition Agregar_Triangulo_Tablas T T' e t r_out abc : Prop :=
  Agregar_Fila T T' e t /\ t = soy_triangulo /\ abc ∈ Vertices
  /\ centros T' ≡ centros T /\ radios T' ≡ radios T /\ vectores T' ≡ vectores T
  /\ alturas T' ≡ alturas T /\ proporciones T' ≡ proporciones T /\ grown T' e abc (ternas T) (ternas T')
  /\ r_out = triangulo_agregado.

Definition Agregar_Triangulo_Tablas_conj_1 : Prop := forall s T e t abc, Retrieve s T ->
  (exists s' r_out, Agregar_Triangulo s s' e t r_out abc) -> exists T' r_out,
    Agregar_Triangulo_Tablas T T' e t r_out abc.

Definition Agregar_Triangulo_Tablas_conj_2 : Prop := forall s T T' e t r_out abc, Retrieve s T ->
  Agregar_Triangulo_Tablas T T' e t r_out abc -> exists s', Retrieve s' T' /\ Agregar_Triangulo s s' e t r_out abc.

Definition mudanza T e : rel Lugar Lugar := fun pq => exists p, (e, p) ∈ lugar T /\
  ndres ⦃p⦄ (oplus (id_on (ran (lugar T))) ⦃((tabla p, (cuantos T (tabla p) - 1)%nat), p)⦄) pq.

Record Quitar_Fila T T' e : Prop := {
  Quitar_Fila_before : Tablas_ok T;
  Quitar_Fila_after : Tablas_ok T';
  Quitar_Fila_pre_1 : e ∈ dom (lugar T);
  Quitar_Fila_post_1 : lugar T' ≡ comp (lugar T) (mudanza T e);
  Quitar_Fila_post_2 : exists p, (e, p) ∈ lugar T /\ cuantos T' (tabla p) = (cuantos T (tabla p) - 1)%nat
    /\ forall u, u <> tabla p -> cuantos T' u = cuantos T u;
  Quitar_Fila_post_3 : centros T' ≡ comp (inverse (mudanza T e)) (centros T);
  Quitar_Fila_post_4 : radios T' ≡ comp (inverse (mudanza T e)) (radios T);
  Quitar_Fila_post_5 : vectores T' ≡ comp (inverse (mudanza T e)) (vectores T);
  Quitar_Fila_post_6 : alturas T' ≡ comp (inverse (mudanza T e)) (alturas T);
  Quitar_Fila_post_7 : proporciones T' ≡ comp (inverse (mudanza T e)) (proporciones T);
  Quitar_Fila_post_8 : ternas T' ≡ comp (inverse (mudanza T e)) (ternas T)
}.

Definition Eliminar_Esfera_Tablas T T' e r_out : Prop :=
  Quitar_Fila T T' e /\ (exists p, (e, p) ∈ lugar T /\ tabla p = soy_esfera)
  /\ r_out = esfera_eliminada.

Definition Eliminar_Esfera_Tablas_conj_1 : Prop := forall s T e, Retrieve s T ->
  (exists s' r_out, Eliminar_Esfera s s' e r_out) -> exists T' r_out, Eliminar_Esfera_Tablas T T' e r_out.

Definition Eliminar_Esfera_Tablas_conj_2 : Prop := forall s T T' e r_out, Retrieve s T ->
  Eliminar_Esfera_Tablas T T' e r_out -> exists s', Retrieve s' T' /\ Eliminar_Esfera s s' e r_out.

Definition Eliminar_Cilindro_Tablas T T' e r_out : Prop :=
  Quitar_Fila T T' e /\ (exists p, (e, p) ∈ lugar T /\ tabla p = soy_cilindro)
  /\ r_out = cilindro_eliminado.

Definition Eliminar_Cilindro_Tablas_conj_1 : Prop := forall s T e, Retrieve s T ->
  (exists s' r_out, Eliminar_Cilindro s s' e r_out) -> exists T' r_out, Eliminar_Cilindro_Tablas T T' e r_out.

Definition Eliminar_Cilindro_Tablas_conj_2 : Prop := forall s T T' e r_out, Retrieve s T ->
  Eliminar_Cilindro_Tablas T T' e r_out -> exists s', Retrieve s' T' /\ Eliminar_Cilindro s s' e r_out.

Definition Eliminar_Cono_Tablas T T' e r_out : Prop :=
  Quitar_Fila T T' e /\ (exists p, (e, p) ∈ lugar T /\ tabla p = soy_cono)
  /\ r_out = cono_eliminado.

Definition Eliminar_Cono_Tablas_conj_1 : Prop := forall s T e, Retrieve s T ->
  (exists s' r_out, Eliminar_Cono s s' e r_out) -> exists T' r_out, Eliminar_Cono_Tablas T T' e r_out.

Definition Eliminar_Cono_Tablas_conj_2 : Prop := forall s T T' e r_out, Retrieve s T ->
  Eliminar_Cono_Tablas T T' e r_out -> exists s', Retrieve s' T' /\ Eliminar_Cono s s' e r_out.

Definition Eliminar_Tronco_Tablas T T' e r_out : Prop :=
  Quitar_Fila T T' e /\ (exists p, (e, p) ∈ lugar T /\ tabla p = soy_tronco)
  /\ r_out = tronco_eliminado.

Definition Eliminar_Tronco_Tablas_conj_1 : Prop := forall s T e, Retrieve s T ->
  (exists s' r_out, Eliminar_Tronco s s' e r_out) -> exists T' r_out, Eliminar_Tronco_Tablas T T' e r_out.

Definition Eliminar_Tronco_Tablas_conj_2 : Prop := forall s T T' e r_out, Retrieve s T ->
  Eliminar_Tronco_Tablas T T' e r_out -> exists s', Retrieve s' T' /\ Eliminar_Tronco s s' e r_out.

Definition Eliminar_Plano_Tablas T T' e r_out : Prop :=
  Quitar_Fila T T' e /\ (exists p, (e, p) ∈ lugar T /\ tabla p = soy_plano)
  /\ r_out = plano_eliminado.

Definition Eliminar_Plano_Tablas_conj_1 : Prop := forall s T e, Retrieve s T ->
  (exists s' r_out, Eliminar_Plano s s' e r_out) -> exists T' r_out, Eliminar_Plano_Tablas T T' e r_out.

Definition Eliminar_Plano_Tablas_conj_2 : Prop := forall s T T' e r_out, Retrieve s T ->
  Eliminar_Plano_Tablas T T' e r_out -> exists s', Retrieve s' T' /\ Eliminar_Plano s s' e r_out.

Definition Eliminar_Disco_Tablas T T' e r_out : Prop :=
  Quitar_Fila T T' e /\ (exists p, (e, p) ∈ lugar T /\ tabla p = soy_disco)
  /\ r_out = disco_eliminado.

Definition Eliminar_Disco_Tablas_conj_1 : Prop := forall s T e, Retrieve s T ->
  (exists s' r_out, Eliminar_Disco s s' e r_out) -> exists T' r_out, Eliminar_Disco_Tablas T T' e r_out.

Definition Eliminar_Disco_Tablas_conj_2 : Prop := forall s T T' e r_out, Retrieve s T ->
  Eliminar_Disco_Tablas T T' e r_out -> exists s', Retrieve s' T' /\ Eliminar_Disco s s' e r_out.

Definition Eliminar_Triangulo_Tablas T T' e r_out : Prop :=
  Quitar_Fila T T' e /\ (exists p, (e, p) ∈ lugar T /\ tabla p = soy_triangulo)
  /\ r_out = triangulo_eliminado.

Definition Eliminar_Triangulo_Tablas_conj_1 : Prop := forall s T e, Retrieve s T ->
  (exists s' r_out, Eliminar_Triangulo s s' e r_out) -> exists T' r_out, Eliminar_Triangulo_Tablas T T' e r_out.

Definition Eliminar_Triangulo_Tablas_conj_2 : Prop := forall s T T' e r_out, Retrieve s T ->
  Eliminar_Triangulo_Tablas T T' e r_out -> exists s', Retrieve s' T' /\ Eliminar_Triangulo s s' e r_out.
End Tablas.
Arguments Tablas : clear implicits.

(** ** The tracer: the closed form with its clip *)
Local Open Scope R_scope.
Local Open Scope zed_scope.

Definition desde (c p : Punto) : Vector :=
  mk_Vector (Punto_x p - Punto_x c) (Punto_y p - Punto_y c) (Punto_z p - Punto_z c).
Record Cuadratica := mk_Cuadratica { Cuadratica_a : R; Cuadratica_b : R; Cuadratica_c : R }.

Definition cuadratica_esfera ray c r : Cuadratica :=
  mk_Cuadratica (producto (Rayo_v ray) (Rayo_v ray)) (producto (desde c (Rayo_p ray)) (Rayo_v ray))
    (producto (desde c (Rayo_p ray)) (desde c (Rayo_p ray)) - cuadrado r).
Definition cuadratica_tronco ray c r k d h : Cuadratica :=
  let p := Rayo_p ray in let v := Rayo_v ray in
  mk_Cuadratica (producto v v - (2 - producto d d + k * k) * cuadrado (producto v d))
    (producto (desde c p) v - (2 - producto d d) * avance p c d * producto v d
      + (r + k * (h - avance p c d)) * k * producto v d)
    (producto (desde c p) (desde c p) - (2 - producto d d) * cuadrado (avance p c d)
      - cuadrado (r + k * (h - avance p c d))).

Definition raices (f : Cuadratica) : set R := fun t =>
  let a := Cuadratica_a f in let b := Cuadratica_b f in let c := Cuadratica_c f in
  (a <> 0 /\ b * b - a * c >= 0 /\
    (a * t + b = raizcuadrada (b * b - a * c) \/ a * t + b + raizcuadrada (b * b - a * c) = 0))
  \/ (a = 0 /\ b <> 0 /\ 2 * b * t + c = 0) \/ (a = 0 /\ b = 0 /\ c = 0).
Definition punto_en ray t : Punto :=
  mk_Punto (Punto_x (Rayo_p ray) + t * Vector_x (Rayo_v ray)) (Punto_y (Rayo_p ray) + t * Vector_y (Rayo_v ray))
    (Punto_z (Rayo_p ray) + t * Vector_z (Rayo_v ray)).
Definition recorte ray c d h : set R := fun t => 0 <= avance (Rayo_p ray) c d + t * producto (Rayo_v ray) d <= h.

Section Trace.
Variable Elemento : Type.
Notation Escena := (Especificacion.Escena Elemento).

Definition raices_conj_1 : Prop := forall (s : Escena) ray t e, Escena_ok s -> ray ∈ Rayo_ok -> t ∈ Rmas ->
  e ∈ elementos s /\ (e, soy_esfera) ∈ de_que_tipo s ->
  (punto_en ray t ∈ alcance s ray ∅ e <->
   exists c r, (e, c) ∈ mi_centro s /\ (e, r) ∈ mi_radio s /\ t ∈ raices (cuadratica_esfera ray c r)).
Definition raices_conj_2 : Prop := forall (s : Escena) ray t e, Escena_ok s -> ray ∈ Rayo_ok -> t ∈ Rmas ->
  e ∈ elementos s /\ (e, soy_cilindro) ∈ de_que_tipo s ->
  (punto_en ray t ∈ alcance s ray ∅ e <->
   exists c r d h, (e, c) ∈ mi_centro s /\ (e, r) ∈ mi_radio s /\ (e, d) ∈ mi_vector s /\ (e, h) ∈ mi_altura s
     /\ t ∈ raices (cuadratica_tronco ray c r 0 d h) ∩ recorte ray c d h).
Definition raices_conj_3 : Prop := forall (s : Escena) ray t e, Escena_ok s -> ray ∈ Rayo_ok -> t ∈ Rmas ->
  e ∈ elementos s /\ (e, soy_cono) ∈ de_que_tipo s ->
  (punto_en ray t ∈ alcance s ray ∅ e <->
   exists c k d h, (e, c) ∈ mi_centro s /\ (e, k) ∈ mi_proporcion s /\ (e, d) ∈ mi_vector s /\ (e, h) ∈ mi_altura s
     /\ t ∈ raices (cuadratica_tronco ray c 0 k d h) ∩ recorte ray c d h).
Definition raices_conj_4 : Prop := forall (s : Escena) ray t e, Escena_ok s -> ray ∈ Rayo_ok -> t ∈ Rmas ->
  e ∈ elementos s /\ (e, soy_tronco) ∈ de_que_tipo s ->
  (punto_en ray t ∈ alcance s ray ∅ e <->
   exists c r k d h, (e, c) ∈ mi_centro s /\ (e, r) ∈ mi_radio s /\ (e, k) ∈ mi_proporcion s
     /\ (e, d) ∈ mi_vector s /\ (e, h) ∈ mi_altura s
     /\ t ∈ raices (cuadratica_tronco ray c r k d h) ∩ recorte ray c d h).
End Trace.
