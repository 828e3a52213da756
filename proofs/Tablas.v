(** spec/tablas.tex, by hand: the tables as the text has them, what scene they stand for, and the obligations of the
    refinement. The export covers one state only, so what is stated here is this file's reading of the text; its rules are
    those at the head of Especificacion.v, and further

    Lugar, tabla p       == Tipo × ℕ, with Coq's nat for ℕ, and the first of p
    cuantos              == a total function on a whole type is a function
    comp f g             == f ⨾ g;  f ⊕ g == override
    places n             == ⋃ { t : Tipo • { t } × (0 .. n(t) − 1) }
    a label A.kind.n      == the field A_kind_n; of a definition, the definition A
    grown T' e v f f'    == f' = f ∪ { lugar'(e) ↦ v }
    scene_of T           == the scene that T stands for
    tables_with, tables_without == the after-states of an addition and of a removal
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
Variable Elemento : Type.
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

(** ** What the tables stand for *)
Section State.
Variable T : Tablas.
Hypothesis ok : Tablas_ok T.

Lemma place_unique e p p' : (e, p) ∈ lugar T -> (e, p') ∈ lugar T -> p = p'.
Proof. apply (Tablas_decl_lugar _ ok). Qed.
Lemma name_unique e e' p : (e, p) ∈ lugar T -> (e', p) ∈ lugar T -> e = e'.
Proof.
  intros H H'. apply (proj1 (Tablas_decl_nombres _ ok) p); apply (Tablas_inv_2 _ ok); assumption.
Qed.
Lemma attribute_pfun {V} (f : rel Lugar V) B : f ∈ (univ ⇸ B) -> comp (lugar T) f ∈ (univ ⇸ B).
Proof.
  intros [F [_ HB]]. split; [| split; [easy |]].
  - intros e v v' [p [Hp Hv]] [p' [Hp' Hv']]. cbn in *. rewrite <- (place_unique _ _ _ Hp Hp') in Hv'.
    exact (F _ _ _ Hv Hv').
  - intros v [e [p [_ H]]]. apply HB. now exists p.
Qed.
Lemma attribute_dom {V} (f : rel Lugar V) (S : set Tipo) : dom f ≡ dres S (ran (lugar T)) ->
  dom (comp (lugar T) f) ≡ image (inverse (comp (lugar T) tabla_of)) S.
Proof.
  intros D e. split.
  - intros [v [p [Hp Hv]]]. cbn in *. exists (tabla p). split; [| now exists p].
    apply (D p). now exists v.
  - intros [t [Ht [p [Hp E]]]]. cbn in *. unfold tabla_of in E; cbn in E. subst t.
    destruct (proj2 (D p)) as [v Hv]; [split; [exact Ht | now exists e] |]. exists v, p. now split.
Qed.

Definition scene_of : Escena := {|
  elementos := dom (lugar T);
  tipos := ran (comp (lugar T) tabla_of);
  de_que_tipo := comp (lugar T) tabla_of;
  mi_centro := comp (lugar T) (centros T);
  mi_radio := comp (lugar T) (radios T);
  mi_vector := comp (lugar T) (vectores T);
  mi_altura := comp (lugar T) (alturas T);
  mi_proporcion := comp (lugar T) (proporciones T);
  mi_vertices := comp (lugar T) (ternas T)
|}.

(** Discharges Tablas.inv.2, Tablas.inv.3, Tablas.inv.4, Tablas.inv.5, Tablas.inv.6, Tablas.inv.7, Tablas.inv.8. *)
Lemma scene_of_ok : Escena_ok scene_of.
Proof.
  split; cbn; try (apply attribute_pfun, ok); try (apply attribute_dom, ok).
  - apply ok.
  - easy.
  - apply attribute_pfun. split; [now intros p t t' -> -> | easy].
  - apply attribute_pfun. destruct (Tablas_decl_vectores _ ok) as [F _]. now split.
  - intros e. split; [intros [p H]; exists (tabla p), p; now split | intros [t [p [H _]]]; now exists p].
  - reflexivity.
Qed.
End State.

(** The names in use are those that the index knows. Discharges Retrieve.conj.3. *)
Theorem the_index_knows_the_elements : Retrieve_conj_3.
Proof.
  intros s T [ok _ E _ _ _ _ _ _] e. rewrite (Escena_inv_1 ok e), (dom_proper _ _ E e).
  split; [intros [t [p [H _]]]; now exists p | intros [p H]; exists (tabla p), p; now split].
Qed.

(** Equal tables stand for equal scenes. *)
Lemma retrieved_equal s T s' T' : Retrieve s T -> Retrieve s' T' -> lugar T' ≡ lugar T -> centros T' ≡ centros T ->
  radios T' ≡ radios T -> vectores T' ≡ vectores T -> alturas T' ≡ alturas T -> proporciones T' ≡ proporciones T ->
  ternas T' ≡ ternas T -> Escena_eq s s'.
Proof.
  intros R R' L C1 C2 C3 C4 C5 C6. pose proof (the_index_knows_the_elements _ _ R) as E.
  pose proof (the_index_knows_the_elements _ _ R') as E'.
  destruct R as [ok _ D A1 A2 A3 A4 A5 A6], R' as [ok' _ D' A1' A2' A3' A4' A5' A6'].
  assert (T0 : de_que_tipo s' ≡ de_que_tipo s) by now rewrite D, D', L.
  split; [now rewrite E, E', L | now apply tipos_follow | exact T0 | now rewrite A1, A1', L, C1 |
    now rewrite A2, A2', L, C2 | now rewrite A3, A3', L, C3 | now rewrite A4, A4', L, C4 |
    now rewrite A5, A5', L, C5 | now rewrite A6, A6', L, C6].
Qed.

(** Discharges Retrieve.inv.1, Retrieve.inv.2, Retrieve.inv.3, Retrieve.inv.4, Retrieve.inv.5, Retrieve.inv.6,
    Retrieve.inv.7, Lugar.def.1, tabla.def.1, Retrieve.conj.1. *)
Theorem tables_stand_for_one_scene : Retrieve_conj_1.
Proof.
  intros T ok. exists (scene_of T).
  assert (R : Retrieve (scene_of T) T) by (split; [now apply scene_of_ok | exact ok | reflexivity ..]).
  split; [exact R |]. intros s' R'. now apply (retrieved_equal _ T _ T).
Qed.
(** Discharges Retrieve.conj.2. *)
Theorem tables_that_stay_stand_for_a_scene_that_stays : Retrieve_conj_2.
Proof.
  intros s T s' T' R R' []. split; [split; [apply R | apply R'] |]. now apply (retrieved_equal _ T _ T').
Qed.

(** Discharges Init_Tablas.post.1, Init_Tablas.conj.1. *)
Theorem first_tables_stand_for_the_first_scene : Init_Tablas_conj_1.
Proof.
  intros T' [ok E]. destruct (tables_stand_for_one_scene T' ok) as [s [R _]]. exists s. split; [exact R |].
  split; [apply R |]. rewrite (the_index_knows_the_elements _ _ R), E. intros x. split; [now intros [p []] | intros []].
Qed.
(** Discharges Init_Tablas.conj.2. *)
Theorem first_tables_exist : Init_Tablas_conj_2.
Proof.
  assert (P : forall X Y (B : set Y), (∅ : rel X Y) ∈ (univ ⇸ B)).
  { intros X Y B. repeat split; [now intros x y y' [] | now intros y [x []]]. }
  exists (mk_Tablas ∅ (fun _ => 0%nat) ∅ ∅ ∅ ∅ ∅ ∅ ∅). split; [| reflexivity].
  split; cbn; try apply P; try (intros p; split; [now intros [v []] | now intros [_ [x []]]]).
  - split; [easy |]. exists nil. intros x. split; [now intros [p []] | intros []].
  - intros p. split; [now intros [e []] | unfold places; cbn; lia].
  - reflexivity.
Qed.

(** ** Adding a row *)
Section Addition.
Variables (T : Tablas) (e : Elemento) (t : Tipo).
Hypothesis ok : Tablas_ok T.
Hypothesis new : e ∉ dom (lugar T).
Let p : Lugar := (t, cuantos T t).

Lemma place_is_new : p ∉ ran (lugar T).
Proof. intros H. apply (Tablas_inv_1 _ ok) in H. unfold places, p in H; cbn in H. lia. Qed.
Lemma no_row_yet {V} (f : rel Lugar V) S : dom f ≡ dres S (ran (lugar T)) -> p ∉ dom f.
Proof. intros D H. apply D in H as [_ H]. exact (place_is_new H). Qed.

(** A row that is appended adds its element, with what the column has in the row. *)
Lemma comp_grown {V} (f : rel Lugar V) S vs : dom f ≡ dres S (ran (lugar T)) ->
  comp (lugar T ∪ ⦃(e, p)⦄) (f ∪ at_one p vs) ≡ comp (lugar T) f ∪ at_one e vs.
Proof.
  intros D [x v]. unfold comp, union, single, at_one; cbn. split.
  - intros [q [[H | E] [Hv | [-> Hv]]]]; [eauto | | | apply pair_eq in E as [-> _]; auto].
    + destruct place_is_new. now exists x.
    + apply pair_eq in E as [-> ->]. destruct (no_row_yet f S D). now exists v.
  - intros [[q [H Hv]] | [-> Hv]]; [eauto |]. exists p. auto.
Qed.
Lemma comp_grown_tabla : comp (lugar T ∪ ⦃(e, p)⦄) tabla_of ≡ comp (lugar T) tabla_of ∪ ⦃(e, t)⦄.
Proof.
  intros [x u]. unfold comp, union, single, tabla_of; cbn. split.
  - intros [q [[H | E] ->]]; [left; eauto | right]. apply pair_eq in E as [-> ->]. reflexivity.
  - intros [[q [H E]] | E]; [eauto | apply pair_eq in E as [-> ->]; exists p; auto].
Qed.

Definition tables_with cs rs ds hs ks vs : Tablas := {|
  lugar := lugar T ∪ ⦃(e, p)⦄;
  cuantos := fun u => if Retrieve.Tipo_dec u t then (cuantos T t + 1)%nat else cuantos T u;
  nombres := inverse (lugar T ∪ ⦃(e, p)⦄);
  centros := centros T ∪ at_one p cs;
  radios := radios T ∪ at_one p rs;
  vectores := vectores T ∪ at_one p ds;
  alturas := alturas T ∪ at_one p hs;
  proporciones := proporciones T ∪ at_one p ks;
  ternas := ternas T ∪ at_one p vs
|}.

Lemma dom_grown {V} (f : rel Lugar V) S vs : dom f ≡ dres S (ran (lugar T)) -> ((exists v, vs v) <-> S t) ->
  dom (f ∪ at_one p vs) ≡ dres S (ran (lugar T ∪ ⦃(e, p)⦄)).
Proof.
  intros D HS q. rewrite dom_union_at_one, (D q), HS. unfold dres, ran, union, single. split.
  - intros [[Hq [x Hx]] | [-> Hs]]; [split; [exact Hq |]; eauto | split; [exact Hs | eauto]].
  - intros [Hq [x [Hx | E]]]; [left; split; [exact Hq | eauto] | right]. apply pair_eq in E as [_ ->]. now split.
Qed.

(** Discharges Tablas.inv.1. *)
Lemma tables_with_ok cs rs ds hs ks vs :
  at_most_one cs -> ((exists c, cs c) <-> centro_types t) ->
  at_most_one rs -> rs ⊆ Rmas -> ((exists r, rs r) <-> radio_types t) ->
  at_most_one ds -> ds ⊆ Unitario -> ((exists d, ds d) <-> vector_types t) ->
  at_most_one hs -> hs ⊆ Rmas -> ((exists h, hs h) <-> altura_types t) ->
  at_most_one ks -> ks ⊆ Rmas -> ((exists k, ks k) <-> proporcion_types t) ->
  at_most_one vs -> vs ⊆ Vertices -> ((exists abc, vs abc) <-> vertices_types t) ->
  Tablas_ok (tables_with cs rs ds hs ks vs).
Proof.
  intros C1 C3 R1 R2 R3 D1 D2 D3 H1 H2 H3 K1 K2 K3 V1 V2 V3. split; cbn.
  - rewrite <- at_one_single. apply pfun_union; [apply ok | exact new | apply single_at_most_one | easy].
  - assert (D : dom (lugar T ∪ ⦃(e, p)⦄) ≡ dom (lugar T) ∪ ⦃e⦄) by (intros x; apply dom_union_single).
    rewrite D. apply finset_add, ok.
  - split; [| easy]. intros q x x'. unfold inverse, union, single; cbn.
    intros [H | E] [H' | E'].
    + exact (name_unique T ok _ _ _ H H').
    + apply pair_eq in E' as [_ ->]. destruct place_is_new. now exists x.
    + apply pair_eq in E as [_ ->]. destruct place_is_new. now exists x'.
    + apply pair_eq in E as [-> _], E' as [-> _]. reflexivity.
  - apply pfun_union; auto; [apply ok | exact (no_row_yet _ _ (Tablas_inv_3 _ ok)) | easy].
  - apply pfun_union; auto; [apply ok | exact (no_row_yet _ _ (Tablas_inv_4 _ ok))].
  - apply pfun_union; auto; [apply ok | exact (no_row_yet _ _ (Tablas_inv_5 _ ok))].
  - apply pfun_union; auto; [apply ok | exact (no_row_yet _ _ (Tablas_inv_6 _ ok))].
  - apply pfun_union; auto; [apply ok | exact (no_row_yet _ _ (Tablas_inv_7 _ ok))].
  - apply pfun_union; auto; [apply ok | exact (no_row_yet _ _ (Tablas_inv_8 _ ok))].
  - intros [u i]. pose proof (Tablas_inv_1 _ ok (u, i)) as E. unfold places, tabla in *; cbn in *.
    unfold ran, union, single. destruct (Retrieve.Tipo_dec u t) as [-> | N].
    + split; [intros [x [H | [= _ ->]]]; [assert (i < cuantos T t)%nat by (apply E; now exists x) |]; lia |]. intros H.
      destruct (lt_dec i (cuantos T t)) as [L | L]; [apply E in L as [x Hx]; eauto |]. exists e. right.
      unfold p. do 2 f_equal. lia.
    + rewrite <- E. split; [intros [x [H | [= _ ? _]]]; [now exists x | easy] | intros [x H]; eauto].
  - reflexivity.
  - exact (dom_grown _ _ _ (Tablas_inv_3 _ ok) C3).
  - exact (dom_grown _ _ _ (Tablas_inv_4 _ ok) R3).
  - exact (dom_grown _ _ _ (Tablas_inv_5 _ ok) D3).
  - exact (dom_grown _ _ _ (Tablas_inv_6 _ ok) H3).
  - exact (dom_grown _ _ _ (Tablas_inv_7 _ ok) K3).
  - exact (dom_grown _ _ _ (Tablas_inv_8 _ ok) V3).
Qed.

(** Where T stands for s, and the tables grow by a row, they stand for s with the element. *)
Lemma grown_retrieves s T' cs rs ds hs ks vs : Retrieve s T -> Tablas_ok T' -> lugar T' ≡ lugar T ∪ ⦃(e, p)⦄ ->
  centros T' ≡ centros T ∪ at_one p cs -> radios T' ≡ radios T ∪ at_one p rs ->
  vectores T' ≡ vectores T ∪ at_one p ds -> alturas T' ≡ alturas T ∪ at_one p hs ->
  proporciones T' ≡ proporciones T ∪ at_one p ks -> ternas T' ≡ ternas T ∪ at_one p vs ->
  Escena_ok (scene_with _ s e t cs rs ds hs ks vs) -> Retrieve (scene_with _ s e t cs rs ds hs ks vs) T'.
Proof.
  intros [_ _ D A1 A2 A3 A4 A5 A6] ok' L C1 C2 C3 C4 C5 C6 oks. split; [exact oks | exact ok' | cbn .. ]; rewrite L.
  - now rewrite comp_grown_tabla, D.
  - now rewrite C1, (comp_grown _ _ _ (Tablas_inv_3 _ ok)), A1.
  - now rewrite C2, (comp_grown _ _ _ (Tablas_inv_4 _ ok)), A2.
  - now rewrite C3, (comp_grown _ _ _ (Tablas_inv_5 _ ok)), A3.
  - now rewrite C4, (comp_grown _ _ _ (Tablas_inv_6 _ ok)), A4.
  - now rewrite C5, (comp_grown _ _ _ (Tablas_inv_7 _ ok)), A5.
  - now rewrite C6, (comp_grown _ _ _ (Tablas_inv_8 _ ok)), A6.
Qed.

(** Discharges Agregar_Fila.pre.1, Agregar_Fila.post.1, Agregar_Fila.post.2. *)
Lemma tables_with_Agregar_Fila cs rs ds hs ks vs : Tablas_ok (tables_with cs rs ds hs ks vs) ->
  Agregar_Fila T (tables_with cs rs ds hs ks vs) e t.
Proof.
  intros ok'. split; [exact ok | exact ok' | exact new | reflexivity |]. cbn. split.
  - now destruct (Retrieve.Tipo_dec t t).
  - intros u N. now destruct (Retrieve.Tipo_dec u t).
Qed.
Lemma row_grows {V} cs rs ds hs ks vs (v : V) (f : rel Lugar V) :
  grown (tables_with cs rs ds hs ks vs) e v f (f ∪ at_one p ⦃v⦄).
Proof. exists p. split; [now right | apply at_one_single]. Qed.
End Addition.

(** What grew has the new row at the place that the index learnt. *)
Lemma grown_at T T' e t {V} (v : V) f f' : Agregar_Fila T T' e t -> grown T' e v f f' ->
  f' ≡ f ∪ at_one (t, cuantos T t) ⦃v⦄.
Proof.
  intros A [q [Hq E]]. rewrite at_one_single, E.
  apply (Agregar_Fila_post_1 _ _ _ _ A) in Hq as [H | [= ->]]; [| reflexivity].
  destruct (Agregar_Fila_pre_1 _ _ _ _ A). now exists q.
Qed.
Lemma same_at T t {V} (f f' : rel Lugar V) : f' ≡ f -> f' ≡ f ∪ at_one (t, cuantos T t) ∅.
Proof. intros ->. symmetry. apply at_one_empty. Qed.

(** The tables grow by the row wherever the scene by the element. *)
Ltac applicable R H e T computed after :=
  let new := fresh "new" in let K := fresh "K" in
  destruct H as [? [? H]]; apply computed in H as [H _];
  assert (new : ~ dom (lugar T) e) by (let N := fresh in intros N; apply (the_index_knows_the_elements _ _ R) in N; tauto);
  decompose [and] H; subst;
  assert (K : Tablas_ok after) by
    (apply tables_with_ok; auto using single_at_most_one, empty_at_most_one; try apply R; try easy;
     try (let v := fresh in now intros v ->);
     first [apply exists_single; cbv; tauto | apply exists_empty; cbv; intuition discriminate]);
  exists after; eexists; hnf; repeat match goal with |- _ /\ _ => split end;
  first [ now apply tables_with_Agregar_Fila; [apply R | ..] | apply row_grows | apply at_one_empty | assumption
        | reflexivity ].
(** What the grown tables stand for is the scene with the element. *)
Ltac correct R H s e T after with_ok computed :=
  let A := fresh "A" in let new := fresh "new" in let oks := fresh "ok" in
  destruct H as [A H]; decompose [and] H; subst;
  assert (new : ~ elementos s e) by
    (let N := fresh in intros N; apply (the_index_knows_the_elements _ _ R) in N; exact (Agregar_Fila_pre_1 _ _ _ _ A N));
  pose proof (Retrieve_Escena _ _ R) as oks;
  exists after; split; [| apply computed; split; [tauto | split; [apply Escena_eq_refl | reflexivity]]];
  apply (grown_retrieves T e _ (Retrieve_Tablas _ _ R));
  first [ exact R | exact (Agregar_Fila_after _ _ _ _ A) | exact (Agregar_Fila_post_1 _ _ _ _ A)
        | now apply (grown_at _ _ _ _ _ _ _ A) | now apply same_at | now apply with_ok ].

(** Discharges Agregar_Esfera_Tablas.conj.1. *)
Theorem Agregar_Esfera_Tablas_applicable : Agregar_Esfera_Tablas_conj_1.
Proof.
  intros s T e t c r R H.
  applicable R H e T Agregar_Esfera_computed (tables_with T e soy_esfera ⦃c⦄ ⦃r⦄ ∅ ∅ ∅ ∅).
Qed.
(** Discharges Agregar_Esfera_Tablas.def.1, Agregar_Esfera_Tablas.conj.2. *)
Theorem Agregar_Esfera_Tablas_correct : Agregar_Esfera_Tablas_conj_2.
Proof.
  intros s T T' e t r_out c r R H.
  correct R H s e T (with_esfera _ s e c r) with_esfera_ok Agregar_Esfera_computed.
Qed.
(** Discharges Agregar_Cilindro_Tablas.conj.1. *)
Theorem Agregar_Cilindro_Tablas_applicable : Agregar_Cilindro_Tablas_conj_1.
Proof.
  intros s T e t c r d h R H.
  applicable R H e T Agregar_Cilindro_computed (tables_with T e soy_cilindro ⦃c⦄ ⦃r⦄ ⦃d⦄ ⦃h⦄ ∅ ∅).
Qed.
(** Discharges Agregar_Cilindro_Tablas.def.1, Agregar_Cilindro_Tablas.conj.2. *)
Theorem Agregar_Cilindro_Tablas_correct : Agregar_Cilindro_Tablas_conj_2.
Proof.
  intros s T T' e t r_out c r d h R H.
  correct R H s e T (with_cilindro _ s e c r d h) with_cilindro_ok Agregar_Cilindro_computed.
Qed.
(** Discharges Agregar_Cono_Tablas.conj.1. *)
Theorem Agregar_Cono_Tablas_applicable : Agregar_Cono_Tablas_conj_1.
Proof.
  intros s T e t c k d h R H.
  applicable R H e T Agregar_Cono_computed (tables_with T e soy_cono ⦃c⦄ ∅ ⦃d⦄ ⦃h⦄ ⦃k⦄ ∅).
Qed.
(** Discharges Agregar_Cono_Tablas.def.1, Agregar_Cono_Tablas.conj.2. *)
Theorem Agregar_Cono_Tablas_correct : Agregar_Cono_Tablas_conj_2.
Proof.
  intros s T T' e t r_out c k d h R H.
  correct R H s e T (with_cono _ s e c k d h) with_cono_ok Agregar_Cono_computed.
Qed.
(** Discharges Agregar_Tronco_Tablas.conj.1. *)
Theorem Agregar_Tronco_Tablas_applicable : Agregar_Tronco_Tablas_conj_1.
Proof.
  intros s T e t c r k d h R H.
  applicable R H e T Agregar_Tronco_computed (tables_with T e soy_tronco ⦃c⦄ ⦃r⦄ ⦃d⦄ ⦃h⦄ ⦃k⦄ ∅).
Qed.
(** Discharges Agregar_Tronco_Tablas.def.1, Agregar_Tronco_Tablas.conj.2. *)
Theorem Agregar_Tronco_Tablas_correct : Agregar_Tronco_Tablas_conj_2.
Proof.
  intros s T T' e t r_out c r k d h R H.
  correct R H s e T (with_tronco _ s e c r k d h) with_tronco_ok Agregar_Tronco_computed.
Qed.
(** Discharges Agregar_Plano_Tablas.conj.1. *)
Theorem Agregar_Plano_Tablas_applicable : Agregar_Plano_Tablas_conj_1.
Proof.
  intros s T e t c d R H.
  applicable R H e T Agregar_Plano_computed (tables_with T e soy_plano ⦃c⦄ ∅ ⦃d⦄ ∅ ∅ ∅).
Qed.
(** Discharges Agregar_Plano_Tablas.def.1, Agregar_Plano_Tablas.conj.2. *)
Theorem Agregar_Plano_Tablas_correct : Agregar_Plano_Tablas_conj_2.
Proof.
  intros s T T' e t r_out c d R H.
  correct R H s e T (with_plano _ s e c d) with_plano_ok Agregar_Plano_computed.
Qed.
(** Discharges Agregar_Disco_Tablas.conj.1. *)
Theorem Agregar_Disco_Tablas_applicable : Agregar_Disco_Tablas_conj_1.
Proof.
  intros s T e t c r d R H.
  applicable R H e T Agregar_Disco_computed (tables_with T e soy_disco ⦃c⦄ ⦃r⦄ ⦃d⦄ ∅ ∅ ∅).
Qed.
(** Discharges Agregar_Disco_Tablas.def.1, Agregar_Disco_Tablas.conj.2. *)
Theorem Agregar_Disco_Tablas_correct : Agregar_Disco_Tablas_conj_2.
Proof.
  intros s T T' e t r_out c r d R H.
  correct R H s e T (with_disco _ s e c r d) with_disco_ok Agregar_Disco_computed.
Qed.
(** Discharges Agregar_Triangulo_Tablas.conj.1. *)
Theorem Agregar_Triangulo_Tablas_applicable : Agregar_Triangulo_Tablas_conj_1.
Proof.
  intros s T e t abc R H.
  applicable R H e T Agregar_Triangulo_computed (tables_with T e soy_triangulo ∅ ∅ ∅ ∅ ∅ ⦃abc⦄).
Qed.
(** Discharges Agregar_Triangulo_Tablas.def.1, Agregar_Triangulo_Tablas.conj.2. *)
Theorem Agregar_Triangulo_Tablas_correct : Agregar_Triangulo_Tablas_conj_2.
Proof.
  intros s T T' e t r_out abc R H.
  correct R H s e T (with_triangulo _ s e abc) with_triangulo_ok Agregar_Triangulo_computed.
Qed.

(** ** Removing a row *)
Section Removal.
Variables (T : Tablas) (e : Elemento) (gap : Lugar).
Hypothesis ok : Tablas_ok T.
Hypothesis found : (e, gap) ∈ lugar T.
Let last : Lugar := (tabla gap, (cuantos T (tabla gap) - 1)%nat).
Notation moved := (mudanza T e).

Lemma gap_is_counted : (snd gap < cuantos T (tabla gap))%nat.
Proof. apply (Tablas_inv_1 _ ok gap). now exists e. Qed.
Lemma last_is_a_row : last ∈ ran (lugar T).
Proof. apply (Tablas_inv_1 _ ok). pose proof gap_is_counted. unfold places, last, tabla in *; cbn. lia. Qed.

(** The last row goes into the gap, and every other but the element's stays. Discharges mudanza.def.1. *)
Lemma moved_spec p q :
  moved (p, q) <-> p <> gap /\ ((p = last /\ q = gap) \/ (p <> last /\ p ∈ ran (lugar T) /\ q = p)).
Proof.
  assert (L : dom ⦃(last, gap)⦄ p <-> p = last).
  { unfold dom, single. split; [now intros [y [= -> _]] | intros ->; now exists gap]. }
  unfold mudanza, ndres, oplus, id_on; cbn. split.
  - intros [g [Hg [N H]]]. rewrite (place_unique T ok e g gap Hg found) in *. fold last in H. rewrite L in H.
    split; [exact N |]. destruct H as [E | [H1 [H2 H3]]]; [| auto].
    apply pair_eq in E. auto.
  - intros [N H]. exists gap. split; [exact found | split; [exact N |]]. fold last. rewrite L.
    destruct H as [[-> ->] | [H1 [H2 H3]]]; [now left | right; auto].
Qed.
Lemma moved_in_its_table p q : moved (p, q) -> tabla q = tabla p.
Proof. intros H. apply moved_spec in H as [_ [[-> ->] | [_ [_ ->]]]]; reflexivity. Qed.
Lemma moved_is_a_row p q : moved (p, q) -> p ∈ ran (lugar T).
Proof. intros H. apply moved_spec in H as [_ [[-> _] | [_ [H _]]]]; [exact last_is_a_row | exact H]. Qed.
Lemma moved_functional p q q' : moved (p, q) -> moved (p, q') -> q = q'.
Proof.
  intros H H'. apply moved_spec in H as [_ H], H' as [_ H'].
  destruct H as [[E ->] | [N [_ ->]]], H' as [[E' ->] | [N' [_ ->]]]; easy.
Qed.
Lemma moved_injective p p' q : moved (p, q) -> moved (p', q) -> p = p'.
Proof.
  intros H H'. apply moved_spec in H as [G H], H' as [G' H'].
  destruct H as [[-> ->] | [N [_ ->]]], H' as [[-> E'] | [N' [_ E']]]; congruence.
Qed.
Lemma others_move x p : x <> e -> (x, p) ∈ lugar T -> exists q, moved (p, q).
Proof.
  intros N H. assert (G : p <> gap) by (intros ->; apply N; exact (name_unique T ok _ _ _ H found)).
  assert (D : {p = last} + {p <> last}) by (repeat decide equality). destruct D as [E | E].
  - exists gap. apply moved_spec. auto.
  - exists p. apply moved_spec. split; [exact G | right]. repeat split; [exact E | now exists x].
Qed.
Lemma moved_of_another x p q : (x, p) ∈ lugar T -> moved (p, q) -> x <> e.
Proof. intros H M ->. apply moved_spec in M as [G _]. apply G. exact (place_unique T ok _ _ _ H found). Qed.

(** When each column follows the rows, every element but e keeps what it had. *)
Lemma comp_moved {V} (f : rel Lugar V) :
  comp (comp (lugar T) moved) (comp (inverse moved) f) ≡ ndres ⦃e⦄ (comp (lugar T) f).
Proof.
  intros [x v]. unfold comp, inverse, ndres, single; cbn. split.
  - intros [q [[p [Hp M]] [p' [M' Hv]]]]. rewrite <- (moved_injective _ _ _ M M') in Hv.
    split; [exact (moved_of_another _ _ _ Hp M) | eauto].
  - intros [N [p [Hp Hv]]]. destruct (others_move x p N Hp) as [q M]. exists q. split; exists p; auto.
Qed.
Lemma comp_moved_tabla : comp (comp (lugar T) moved) tabla_of ≡ ndres ⦃e⦄ (comp (lugar T) tabla_of).
Proof.
  intros [x u]. unfold comp, ndres, single, tabla_of; cbn. split.
  - intros [q [[p [Hp M]] ->]]. split; [exact (moved_of_another _ _ _ Hp M) |]. exists p. split; [exact Hp |].
    exact (moved_in_its_table _ _ M).
  - intros [N [p [Hp ->]]]. destruct (others_move x p N Hp) as [q M]. exists q. split; [now exists p |].
    symmetry. exact (moved_in_its_table _ _ M).
Qed.

Definition tables_without : Tablas := {|
  lugar := comp (lugar T) moved;
  cuantos := fun u => if Retrieve.Tipo_dec u (tabla gap) then (cuantos T (tabla gap) - 1)%nat else cuantos T u;
  nombres := inverse (comp (lugar T) moved);
  centros := comp (inverse moved) (centros T);
  radios := comp (inverse moved) (radios T);
  vectores := comp (inverse moved) (vectores T);
  alturas := comp (inverse moved) (alturas T);
  proporciones := comp (inverse moved) (proporciones T);
  ternas := comp (inverse moved) (ternas T)
|}.

Lemma pfun_moved {V} (f : rel Lugar V) B : f ∈ (univ ⇸ B) -> comp (inverse moved) f ∈ (univ ⇸ B).
Proof.
  intros [F [_ HB]]. split; [| split; [easy |]].
  - intros q v v' [p [M Hv]] [p' [M' Hv']]. unfold inverse in *; cbn in *.
    rewrite <- (moved_injective _ _ _ M M') in Hv'. exact (F _ _ _ Hv Hv').
  - intros v [q [p [_ H]]]. apply HB. now exists p.
Qed.
Lemma dom_moved {V} (f : rel Lugar V) S : dom f ≡ dres S (ran (lugar T)) ->
  dom (comp (inverse moved) f) ≡ dres S (ran (comp (lugar T) moved)).
Proof.
  intros D q. unfold dres, ran, comp, inverse; cbn. split.
  - intros [v [p [M Hv]]]. cbn in *. destruct (proj1 (D p)) as [Hs [x Hx]]; [now exists v |].
    pose proof (moved_in_its_table _ _ M) as E. unfold tabla in E. rewrite E. split; [exact Hs |]. exists x, p. now split.
  - intros [Hs [x [p [Hx M]]]]. pose proof (moved_in_its_table _ _ M) as E. unfold tabla in E. rewrite E in Hs.
    destruct (proj2 (D p)) as [v Hv]; [split; [exact Hs | now exists x] |]. exists v, p. now split.
Qed.

Lemma tables_without_ok : Tablas_ok tables_without.
Proof.
  split; cbn; try (apply pfun_moved, ok).
  - split; [| easy]. intros x q q' [p [H M]] [p' [H' M']]. cbn in *.
    rewrite <- (place_unique T ok _ _ _ H H') in M'. exact (moved_functional _ _ _ M M').
  - apply finset_subset with (dom (lugar T)); [apply ok |]. intros x [q [p [H _]]]. now exists p.
  - split; [| easy]. intros q x x' [p [H M]] [p' [H' M']]. cbn in *.
    rewrite <- (moved_injective _ _ _ M M') in H'. exact (name_unique T ok _ _ _ H H').
  - intros [u i]. pose proof gap_is_counted as G. pose proof (Tablas_inv_1 _ ok) as I.
    transitivity ((u, i) ∈ ran (lugar T) /\ (u, i) <> last).
    + split.
      * intros [x [p [H M]]]. cbn in *. apply moved_spec in M as [N [[-> ->] | [N' [Hr ->]]]]; [| now split].
        split; [now exists e | congruence].
      * intros [[x H] N]. assert (D : {(u, i) = gap} + {(u, i) <> gap}) by (repeat decide equality).
        destruct D as [E | E].
        -- destruct last_is_a_row as [y Hy]. exists y, last. cbn. split; [exact Hy |]. apply moved_spec.
           split; [congruence |]. left. now split.
        -- exists x, (u, i). cbn. split; [exact H |]. apply moved_spec. split; [exact E | right]. repeat split; auto.
           now exists x.
    + rewrite (I (u, i)). unfold places, last, tabla in *; cbn in *.
      destruct (Retrieve.Tipo_dec u (fst gap)) as [-> | N]; [| split; [tauto | intros H; split; [exact H | congruence]]].
      split; [| intros H; split; [lia | intros [= E]; lia]]. intros [H N].
      assert (i <> cuantos T (fst gap) - 1)%nat by congruence. lia.
  - reflexivity.
  - exact (dom_moved _ _ (Tablas_inv_3 _ ok)).
  - exact (dom_moved _ _ (Tablas_inv_4 _ ok)).
  - exact (dom_moved _ _ (Tablas_inv_5 _ ok)).
  - exact (dom_moved _ _ (Tablas_inv_6 _ ok)).
  - exact (dom_moved _ _ (Tablas_inv_7 _ ok)).
  - exact (dom_moved _ _ (Tablas_inv_8 _ ok)).
Qed.
(** Discharges Quitar_Fila.pre.1, Quitar_Fila.post.1, Quitar_Fila.post.2, Quitar_Fila.post.3, Quitar_Fila.post.4,
    Quitar_Fila.post.5, Quitar_Fila.post.6, Quitar_Fila.post.7, Quitar_Fila.post.8. *)
Lemma tables_without_Quitar_Fila : Quitar_Fila T tables_without e.
Proof.
  split; try reflexivity; [exact ok | exact tables_without_ok | now exists gap |]. exists gap. cbn.
  split; [exact found | split].
  - now destruct (Retrieve.Tipo_dec (tabla gap) (tabla gap)).
  - intros u N. now destruct (Retrieve.Tipo_dec u (tabla gap)).
Qed.
Lemma moved_retrieves s T' : Retrieve s T -> Quitar_Fila T T' e -> Retrieve (scene_without _ s e) T'.
Proof.
  intros [oks _ D A1 A2 A3 A4 A5 A6] [_ ok' _ L _ C1 C2 C3 C4 C5 C6].
  split; [now apply scene_without_ok | exact ok' | cbn ..]; rewrite L.
  - now rewrite comp_moved_tabla, D.
  - now rewrite C1, comp_moved, A1.
  - now rewrite C2, comp_moved, A2.
  - now rewrite C3, comp_moved, A3.
  - now rewrite C4, comp_moved, A4.
  - now rewrite C5, comp_moved, A5.
  - now rewrite C6, comp_moved, A6.
Qed.
End Removal.

(** The type of an element is the table that its row is in. *)
Lemma type_is_table s T e t : Retrieve s T -> ((e, t) ∈ de_que_tipo s <-> exists p, (e, p) ∈ lugar T /\ tabla p = t).
Proof.
  intros R. rewrite (Retrieve_inv_1 _ _ R (e, t)). unfold comp, tabla_of; cbn.
  split; intros [p [H E]]; exists p; auto.
Qed.

Ltac removable computed :=
  let s := fresh "s" in let T := fresh "T" in let e := fresh "e" in let R := fresh "R" in let H := fresh "H" in
  let p := fresh "p" in let E := fresh "E" in
  intros s T e R [? [? H]]; apply computed in H as [[_ H] _]; apply (type_is_table _ _ _ _ R) in H as [p [H E]];
  exists (tables_without T e p); eexists; split;
  [ exact (tables_without_Quitar_Fila T e p (Retrieve_Tablas _ _ R) H) | split; [now exists p | reflexivity] ].
Ltac removed computed :=
  let s := fresh "s" in let T := fresh "T" in let e := fresh "e" in let R := fresh "R" in let Q := fresh "Q" in
  let H := fresh "H" in let p := fresh "p" in let E := fresh "E" in
  intros s T ? e ? R [Q [[p [H E]] ->]]; exists (scene_without _ s e); split;
  [ exact (moved_retrieves T e p (Retrieve_Tablas _ _ R) H s _ R Q)
  | apply computed; split; [split; [apply R | apply (type_is_table _ _ _ _ R); now exists p] |
      split; [apply Escena_eq_refl | reflexivity]] ].

(** Discharges Eliminar_Esfera_Tablas.conj.1. *)
Theorem Eliminar_Esfera_Tablas_applicable : Eliminar_Esfera_Tablas_conj_1.
Proof. removable Eliminar_Esfera_computed. Qed.
(** Discharges Eliminar_Esfera_Tablas.def.1, Eliminar_Esfera_Tablas.conj.2. *)
Theorem Eliminar_Esfera_Tablas_correct : Eliminar_Esfera_Tablas_conj_2.
Proof. removed Eliminar_Esfera_computed. Qed.
(** Discharges Eliminar_Cilindro_Tablas.conj.1. *)
Theorem Eliminar_Cilindro_Tablas_applicable : Eliminar_Cilindro_Tablas_conj_1.
Proof. removable Eliminar_Cilindro_computed. Qed.
(** Discharges Eliminar_Cilindro_Tablas.def.1, Eliminar_Cilindro_Tablas.conj.2. *)
Theorem Eliminar_Cilindro_Tablas_correct : Eliminar_Cilindro_Tablas_conj_2.
Proof. removed Eliminar_Cilindro_computed. Qed.
(** Discharges Eliminar_Cono_Tablas.conj.1. *)
Theorem Eliminar_Cono_Tablas_applicable : Eliminar_Cono_Tablas_conj_1.
Proof. removable Eliminar_Cono_computed. Qed.
(** Discharges Eliminar_Cono_Tablas.def.1, Eliminar_Cono_Tablas.conj.2. *)
Theorem Eliminar_Cono_Tablas_correct : Eliminar_Cono_Tablas_conj_2.
Proof. removed Eliminar_Cono_computed. Qed.
(** Discharges Eliminar_Tronco_Tablas.conj.1. *)
Theorem Eliminar_Tronco_Tablas_applicable : Eliminar_Tronco_Tablas_conj_1.
Proof. removable Eliminar_Tronco_computed. Qed.
(** Discharges Eliminar_Tronco_Tablas.def.1, Eliminar_Tronco_Tablas.conj.2. *)
Theorem Eliminar_Tronco_Tablas_correct : Eliminar_Tronco_Tablas_conj_2.
Proof. removed Eliminar_Tronco_computed. Qed.
(** Discharges Eliminar_Plano_Tablas.conj.1. *)
Theorem Eliminar_Plano_Tablas_applicable : Eliminar_Plano_Tablas_conj_1.
Proof. removable Eliminar_Plano_computed. Qed.
(** Discharges Eliminar_Plano_Tablas.def.1, Eliminar_Plano_Tablas.conj.2. *)
Theorem Eliminar_Plano_Tablas_correct : Eliminar_Plano_Tablas_conj_2.
Proof. removed Eliminar_Plano_computed. Qed.
(** Discharges Eliminar_Disco_Tablas.conj.1. *)
Theorem Eliminar_Disco_Tablas_applicable : Eliminar_Disco_Tablas_conj_1.
Proof. removable Eliminar_Disco_computed. Qed.
(** Discharges Eliminar_Disco_Tablas.def.1, Eliminar_Disco_Tablas.conj.2. *)
Theorem Eliminar_Disco_Tablas_correct : Eliminar_Disco_Tablas_conj_2.
Proof. removed Eliminar_Disco_computed. Qed.
(** Discharges Eliminar_Triangulo_Tablas.conj.1. *)
Theorem Eliminar_Triangulo_Tablas_applicable : Eliminar_Triangulo_Tablas_conj_1.
Proof. removable Eliminar_Triangulo_computed. Qed.
(** Discharges Eliminar_Triangulo_Tablas.def.1, Eliminar_Triangulo_Tablas.conj.2. *)
Theorem Eliminar_Triangulo_Tablas_correct : Eliminar_Triangulo_Tablas_conj_2.
Proof. removed Eliminar_Triangulo_computed. Qed.
End Tablas.

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

(** The closed form has the solutions, all of them and no other, in every case. Discharges raices.def.1. *)
Lemma raices_are_solutions f t : t ∈ raices f <->
  Cuadratica_a f * (t * t) + 2 * Cuadratica_b f * t + Cuadratica_c f = 0.
Proof.
  destruct f as [a b c]. unfold raices; cbn. unfold raizcuadrada. set (D := b * b - a * c).
  assert (S : a * (a * (t * t) + 2 * b * t + c) = (a * t + b) * (a * t + b) - D) by (unfold D; ring). split.
  - intros [[Ha [HD H]] | [[-> [Hb H]] | [-> [-> ->]]]]; [| lra | lra]. pose proof (sqrt_sqrt D (Rge_le _ _ HD)) as Q.
    assert (Z : a * (a * (t * t) + 2 * b * t + c) = 0).
    { rewrite S. destruct H as [-> | H]; [rewrite Q; ring |]. replace (a * t + b) with (- sqrt D) by lra. lra. }
    apply Rmult_integral in Z. tauto.
  - intros H. rewrite H, Rmult_0_r in S. destruct (Req_EM_T a 0) as [-> | Ha].
    + right. destruct (Req_EM_T b 0) as [-> | Hb]; [right | left]; repeat split; try assumption; lra.
    + left. assert (HD : D >= 0) by (pose proof (Rle_0_sqr (a * t + b)) as Q; unfold Rsqr in Q; lra).
      split; [exact Ha | split; [exact HD |]]. pose proof (sqrt_sqrt D (Rge_le _ _ HD)) as Q.
      assert (P : (a * t + b - sqrt D) * (a * t + b + sqrt D) = 0) by lra.
      apply Rmult_integral in P as [P | P]; [left | right]; lra.
Qed.

(** The coefficients are those of the tracer's, as Puntos.v has them. Discharges producto.def.1, desde.def.1,
    cuadratica_esfera.def.1. *)
Lemma raices_esfera ray c r t : t ∈ raices (cuadratica_esfera ray c r) <-> value (of_esfera ray c r) t = 0.
Proof. rewrite raices_are_solutions. unfold cuadratica_esfera, cuadrado, desde, producto. coordinates. reflexivity. Qed.
(** Discharges cuadratica_tronco.def.1. *)
Lemma raices_tronco ray c r k d h t :
  t ∈ raices (cuadratica_tronco ray c r k d h) <-> value (of_tronco ray c r k d h) t = 0.
Proof.
  rewrite raices_are_solutions. unfold cuadratica_tronco, desde, producto. coordinates.
  match goal with |- ?x = 0 <-> ?y = 0 => replace x with y by ring end. reflexivity.
Qed.
(** Discharges recorte.def.1. *)
Lemma recorte_is_within ray c r k d h t : t ∈ recorte ray c d h <-> within (of_tronco ray c r k d h) t.
Proof. unfold within, of_tronco; cbn [clip]. rewrite between_holds. reflexivity. Qed.

(** Of a ray that starts on no element, what it reaches of an element are its points. Discharges punto_en.def.1. *)
Lemma reached_at s ray t e : t ∈ Rmas -> e ∈ elementos s ->
  (punto_en ray t ∈ alcance (s : Escena) ray ∅ e <-> puntos_de_elemento s e (point_at ray t)).
Proof.
  intros Ht He. change (punto_en ray t) with (point_at ray t). unfold alcance, interseccion, inter. split.
  - intros [_ [_ [[[] _] | [_ H]]]]. exact H.
  - intros H. split; [exact He | split; [apply puntos_de_rayo_parameter; now exists t | right]]. split; [easy | exact H].
Qed.

(** What is of one type has its attributes. *)
Ltac attributes_of ok He Ht := let H := fresh in
  pose proof (element_cases _ _ ok _ He) as H;
  unfold is_esfera, is_cilindro, is_cono, is_tronco, is_plano, is_disco, is_triangulo in H;
  decompose [ex and or] H; clear H;
  try (match goal with K : (_, _) ∈ de_que_tipo _ |- _ => discriminate (type_unique _ _ ok _ _ _ Ht K) end).

(** Discharges raices.conj.1. *)
Theorem the_closed_form_of_a_sphere_is_alcance : raices_conj_1.
Proof.
  intros s ray t e ok _ Ht [He Hs]. rewrite (reached_at s ray t e Ht He).
  assert (E : forall c r, (e, c) ∈ mi_centro s -> (e, r) ∈ mi_radio s ->
    (puntos_de_elemento s e (point_at ray t) <-> t ∈ raices (cuadratica_esfera ray c r))).
  { intros c r Hc Hr. rewrite raices_esfera, <- esfera_along. apply (esfera_of_scene _ _ ok). now split. }
  split; [intros H; attributes_of ok He Hs; do 2 eexists; repeat split; eauto; now apply E |].
  intros [c [r [Hc [Hr H]]]]. now apply (E c r).
Qed.
(** Discharges raices.conj.2. *)
Theorem the_closed_form_of_a_cylinder_is_alcance : raices_conj_2.
Proof.
  intros s ray t e ok _ Ht [He Hs]. rewrite (reached_at s ray t e Ht He).
  assert (E : forall c r d h, (e, c) ∈ mi_centro s -> (e, r) ∈ mi_radio s -> (e, d) ∈ mi_vector s -> (e, h) ∈ mi_altura s ->
    (puntos_de_elemento s e (point_at ray t) <-> t ∈ raices (cuadratica_tronco ray c r 0 d h) ∩ recorte ray c d h)).
  { intros c r d h Hc Hr Hd Hh. unfold inter. rewrite raices_tronco, (recorte_is_within ray c r 0 d h), <- of_cilindro_is_tronco, <- cilindro_along.
    apply (cilindro_of_scene _ _ ok). now repeat split. }
  split; [intros H; attributes_of ok He Hs; do 4 eexists; repeat (split; [eassumption |]); apply E; assumption |].
  intros [c [r [d [h [Hc [Hr [Hd [Hh H]]]]]]]]. now apply (E c r d h).
Qed.
(** Discharges raices.conj.3. *)
Theorem the_closed_form_of_a_cone_is_alcance : raices_conj_3.
Proof.
  intros s ray t e ok _ Ht [He Hs]. rewrite (reached_at s ray t e Ht He).
  assert (E : forall c k d h, (e, c) ∈ mi_centro s -> (e, k) ∈ mi_proporcion s -> (e, d) ∈ mi_vector s -> (e, h) ∈ mi_altura s ->
    (puntos_de_elemento s e (point_at ray t) <-> t ∈ raices (cuadratica_tronco ray c 0 k d h) ∩ recorte ray c d h)).
  { intros c k d h Hc Hk Hd Hh. unfold inter. rewrite raices_tronco, (recorte_is_within ray c 0 k d h), <- of_cono_is_tronco, <- cono_along.
    apply (cono_of_scene _ _ ok). now repeat split. }
  split; [intros H; attributes_of ok He Hs; do 4 eexists; repeat (split; [eassumption |]); apply E; assumption |].
  intros [c [k [d [h [Hc [Hk [Hd [Hh H]]]]]]]]. now apply (E c k d h).
Qed.
(** Discharges raices.conj.4. *)
Theorem the_closed_form_of_a_truncated_cone_is_alcance : raices_conj_4.
Proof.
  intros s ray t e ok _ Ht [He Hs]. rewrite (reached_at s ray t e Ht He).
  assert (E : forall c r k d h, (e, c) ∈ mi_centro s -> (e, r) ∈ mi_radio s -> (e, k) ∈ mi_proporcion s -> (e, d) ∈ mi_vector s -> (e, h) ∈ mi_altura s ->
    (puntos_de_elemento s e (point_at ray t) <-> t ∈ raices (cuadratica_tronco ray c r k d h) ∩ recorte ray c d h)).
  { intros c r k d h Hc Hr Hk Hd Hh. unfold inter. rewrite raices_tronco, (recorte_is_within ray c r k d h), <- tronco_along.
    apply (tronco_of_scene _ _ ok). now repeat split. }
  split; [intros H; attributes_of ok He Hs; do 5 eexists; repeat (split; [eassumption |]); apply E; assumption |].
  intros [c [r [k [d [h [Hc [Hr [Hk [Hd [Hh H]]]]]]]]]]. now apply (E c r k d h).
Qed.

End Trace.
