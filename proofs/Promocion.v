(** spec/promocion.tex, by hand as Tablas.v is: the scene as one function from names to shapes, and that its
      operations,
    lifted from one shape, are those of the scene.

    Forma                == Retrieve.Shape, where it is valid: esfera is Sphere, cilindro Cylinder, cono Cone, tronco
                            TruncatedCone, plano Plane, disco Disc and triangulo Triangle
    Formas               == forma alone;  Una_Forma == f alone, a shape x
    tipo_de, centro_de, … == the relations of Retrieve.type_of, Retrieve.centres, …
    scene_of f           == the scene that f says;  shapes_of s == the shapes that s has
    with_shape s e x     == s with x under the name e *)
From Coq Require Import Reals Setoid Morphisms.
From Durero Require Import Toolkit Especificacion Escena Operaciones Tablas.
From Durero Require Retrieve.
Local Open Scope zed_scope.

Notation Forma := Retrieve.Shape.
Notation valid := Retrieve.valid.
Definition of_shape {V} (A : Forma -> set V) : rel Forma V := fun p => A (fst p) (snd p).
Definition tipo_de : rel Forma Tipo := of_shape (fun x => ⦃Retrieve.type_of x⦄).
Definition centro_de : rel Forma Punto := of_shape Retrieve.centres.
Definition radio_de : rel Forma R := of_shape Retrieve.radii.
Definition vector_de : rel Forma Vector := of_shape Retrieve.axes.
Definition altura_de : rel Forma R := of_shape Retrieve.heights.
Definition proporcion_de : rel Forma R := of_shape Retrieve.proportions.
Definition vertices_de : rel Forma Terna := of_shape Retrieve.vertices.

Section Promocion.
Context {Elemento : Type}.
Notation Escena := (Especificacion.Escena Elemento).
Notation Formas := (rel Elemento Forma).
Implicit Types (s : Escena) (e : Elemento) (f : Formas) (x : Forma).

(** ** The state, and the two ways between it and a scene *)

Record Formas_ok f : Prop := {
  Formas_decl_forma : f ∈ (univ ⇸ valid);
  Formas_decl_finite : dom f ∈ 𝔽 univ
}.
Definition Init_Formas f' : Prop := Formas_ok f' /\ f' ≡ ∅.

Definition shapes_of s : Formas :=
  (fun p => exists c r, is_esfera _ s (fst p) c r /\ snd p = Retrieve.Sphere c r)
  ∪ (fun p => exists c r d h, is_cilindro _ s (fst p) c r d h /\ snd p = Retrieve.Cylinder c r d h)
  ∪ (fun p => exists c k d h, is_cono _ s (fst p) c k d h /\ snd p = Retrieve.Cone c k d h)
  ∪ (fun p => exists c r k d h, is_tronco _ s (fst p) c r k d h /\ snd p = Retrieve.TruncatedCone c r k d h)
  ∪ (fun p => exists c d, is_plano _ s (fst p) c d /\ snd p = Retrieve.Plane c d)
  ∪ (fun p => exists c r d, is_disco _ s (fst p) c r d /\ snd p = Retrieve.Disc c r d)
  ∪ (fun p => exists abc, is_triangulo _ s (fst p) abc /\ snd p = Retrieve.Triangle abc).

Record Retrato s f : Prop := {
  Retrato_Escena : Escena_ok s;
  Retrato_Formas : Formas_ok f;
  Retrato_inv_1 : f ≡ shapes_of s
}.

Record Recobro f s : Prop := {
  Recobro_Formas : Formas_ok f;
  Recobro_Escena : Escena_ok s;
  Recobro_inv_1 : de_que_tipo s ≡ comp f tipo_de;
  Recobro_inv_2 : mi_centro s ≡ comp f centro_de;
  Recobro_inv_3 : mi_radio s ≡ comp f radio_de;
  Recobro_inv_4 : mi_vector s ≡ comp f vector_de;
  Recobro_inv_5 : mi_altura s ≡ comp f altura_de;
  Recobro_inv_6 : mi_proporcion s ≡ comp f proporcion_de;
  Recobro_inv_7 : mi_vertices s ≡ comp f vertices_de
}.

Definition Retrato_conj_1 : Prop := forall s, Escena_ok s ->
  exists f, (Retrato s f /\ Recobro f s) /\ forall f', Retrato s f' /\ Recobro f' s -> f' ≡ f.
Definition Recobro_conj_1 : Prop := forall f, Formas_ok f ->
  exists s, (Recobro f s /\ Retrato s f) /\ forall s', Recobro f s' /\ Retrato s' f -> Escena_eq s s'.
Definition Init_Formas_conj_1 : Prop := forall f', Init_Formas f' -> exists s', Recobro f' s' /\ Init s'.
Definition Init_Formas_conj_2 : Prop := forall s', Init s' -> exists f', Retrato s' f' /\ Init_Formas f'.

(** ** The operations *)

Record Marco_Agregar f f' x e : Prop := {
  Marco_Agregar_before : Formas_ok f;
  Marco_Agregar_after : Formas_ok f';
  Marco_Agregar_shape : valid x;
  Marco_Agregar_new : e ∉ dom f;
  Marco_Agregar_grown : f' ≡ f ∪ ⦃(e, x)⦄
}.
Record Marco_Eliminar f f' x e : Prop := {
  Marco_Eliminar_before : Formas_ok f;
  Marco_Eliminar_after : Formas_ok f';
  Marco_Eliminar_shape : valid x;
  Marco_Eliminar_old : e ∈ dom f /\ (e, x) ∈ f;
  Marco_Eliminar_less : f' ≡ ndres ⦃e⦄ f
}.

Definition Nueva_Esfera x c r r_out : Prop := valid x /\ r ∈ Rmas /\ x = Retrieve.Sphere c r /\ r_out =
  esfera_agregada.
Definition Agregar_Esfera_Formas f f' e r_out c r : Prop := exists x, Marco_Agregar f f' x e /\ Nueva_Esfera x c r
  r_out.
Definition Agregar_Esfera_Formas_conj_1 : Prop := forall s s' e t r_out c r, Agregar_Esfera s s' e t r_out c r ->
  exists f f', Retrato s f /\ Retrato s' f' /\ Agregar_Esfera_Formas f f' e r_out c r.
Definition Agregar_Esfera_Formas_conj_2 : Prop := forall f f' e r_out c r, Agregar_Esfera_Formas f f' e r_out c r ->
  exists s s' t, Recobro f s /\ Recobro f' s' /\ Agregar_Esfera s s' e t r_out c r.

Definition Nuevo_Cilindro x c r d h r_out : Prop := valid x /\ (r ∈ Rmas /\ d ∈ Unitario /\ h ∈ Rmas) /\ x =
  Retrieve.Cylinder c r d h /\ r_out = cilindro_agregado.
Definition Agregar_Cilindro_Formas f f' e r_out c r d h : Prop := exists x, Marco_Agregar f f' x e /\ Nuevo_Cilindro
  x c r d h r_out.
Definition Agregar_Cilindro_Formas_conj_1 : Prop := forall s s' e t r_out c r d h, Agregar_Cilindro s s' e t r_out c
  r d h -> exists f f', Retrato s f /\ Retrato s' f' /\ Agregar_Cilindro_Formas f f' e r_out c r d h.
Definition Agregar_Cilindro_Formas_conj_2 : Prop := forall f f' e r_out c r d h, Agregar_Cilindro_Formas f f' e
  r_out c r d h -> exists s s' t, Recobro f s /\ Recobro f' s' /\ Agregar_Cilindro s s' e t r_out c r d h.

Definition Nuevo_Cono x c k d h r_out : Prop := valid x /\ (k ∈ Rmas /\ d ∈ Unitario /\ h ∈ Rmas) /\ x =
  Retrieve.Cone c k d h /\ r_out = cono_agregado.
Definition Agregar_Cono_Formas f f' e r_out c k d h : Prop := exists x, Marco_Agregar f f' x e /\ Nuevo_Cono x c k d
  h r_out.
Definition Agregar_Cono_Formas_conj_1 : Prop := forall s s' e t r_out c k d h, Agregar_Cono s s' e t r_out c k d h
  -> exists f f', Retrato s f /\ Retrato s' f' /\ Agregar_Cono_Formas f f' e r_out c k d h.
Definition Agregar_Cono_Formas_conj_2 : Prop := forall f f' e r_out c k d h, Agregar_Cono_Formas f f' e r_out c k d
  h -> exists s s' t, Recobro f s /\ Recobro f' s' /\ Agregar_Cono s s' e t r_out c k d h.

Definition Nuevo_Tronco x c r k d h r_out : Prop := valid x /\ (r ∈ Rmas /\ k ∈ Rmas /\ d ∈ Unitario /\ h ∈ Rmas) /\
  x = Retrieve.TruncatedCone c r k d h /\ r_out = tronco_agregado.
Definition Agregar_Tronco_Formas f f' e r_out c r k d h : Prop := exists x, Marco_Agregar f f' x e /\ Nuevo_Tronco x
  c r k d h r_out.
Definition Agregar_Tronco_Formas_conj_1 : Prop := forall s s' e t r_out c r k d h, Agregar_Tronco s s' e t r_out c r
  k d h -> exists f f', Retrato s f /\ Retrato s' f' /\ Agregar_Tronco_Formas f f' e r_out c r k d h.
Definition Agregar_Tronco_Formas_conj_2 : Prop := forall f f' e r_out c r k d h, Agregar_Tronco_Formas f f' e r_out
  c r k d h -> exists s s' t, Recobro f s /\ Recobro f' s' /\ Agregar_Tronco s s' e t r_out c r k d h.

Definition Nuevo_Plano x c d r_out : Prop := valid x /\ d ∈ Unitario /\ x = Retrieve.Plane c d /\ r_out =
  plano_agregado.
Definition Agregar_Plano_Formas f f' e r_out c d : Prop := exists x, Marco_Agregar f f' x e /\ Nuevo_Plano x c d
  r_out.
Definition Agregar_Plano_Formas_conj_1 : Prop := forall s s' e t r_out c d, Agregar_Plano s s' e t r_out c d ->
  exists f f', Retrato s f /\ Retrato s' f' /\ Agregar_Plano_Formas f f' e r_out c d.
Definition Agregar_Plano_Formas_conj_2 : Prop := forall f f' e r_out c d, Agregar_Plano_Formas f f' e r_out c d ->
  exists s s' t, Recobro f s /\ Recobro f' s' /\ Agregar_Plano s s' e t r_out c d.

Definition Nuevo_Disco x c r d r_out : Prop := valid x /\ (r ∈ Rmas /\ d ∈ Unitario) /\ x = Retrieve.Disc c r d /\
  r_out = disco_agregado.
Definition Agregar_Disco_Formas f f' e r_out c r d : Prop := exists x, Marco_Agregar f f' x e /\ Nuevo_Disco x c r d
  r_out.
Definition Agregar_Disco_Formas_conj_1 : Prop := forall s s' e t r_out c r d, Agregar_Disco s s' e t r_out c r d ->
  exists f f', Retrato s f /\ Retrato s' f' /\ Agregar_Disco_Formas f f' e r_out c r d.
Definition Agregar_Disco_Formas_conj_2 : Prop := forall f f' e r_out c r d, Agregar_Disco_Formas f f' e r_out c r d
  -> exists s s' t, Recobro f s /\ Recobro f' s' /\ Agregar_Disco s s' e t r_out c r d.

Definition Nuevo_Triangulo x abc r_out : Prop := valid x /\ abc ∈ Vertices /\ x = Retrieve.Triangle abc /\ r_out =
  triangulo_agregado.
Definition Agregar_Triangulo_Formas f f' e r_out abc : Prop := exists x, Marco_Agregar f f' x e /\ Nuevo_Triangulo x
  abc r_out.
Definition Agregar_Triangulo_Formas_conj_1 : Prop := forall s s' e t r_out abc, Agregar_Triangulo s s' e t r_out abc
  -> exists f f', Retrato s f /\ Retrato s' f' /\ Agregar_Triangulo_Formas f f' e r_out abc.
Definition Agregar_Triangulo_Formas_conj_2 : Prop := forall f f' e r_out abc, Agregar_Triangulo_Formas f f' e r_out
  abc -> exists s s' t, Recobro f s /\ Recobro f' s' /\ Agregar_Triangulo s s' e t r_out abc.

Definition Vieja_Esfera x r_out : Prop := Retrieve.type_of x = soy_esfera /\ r_out = esfera_eliminada.
Definition Eliminar_Esfera_Formas f f' e r_out : Prop := exists x, Marco_Eliminar f f' x e /\ Vieja_Esfera x r_out.
Definition Eliminar_Esfera_Formas_conj_1 : Prop := forall s s' e r_out, Eliminar_Esfera s s' e r_out -> exists f f',
  Retrato s f /\ Retrato s' f' /\ Eliminar_Esfera_Formas f f' e r_out.
Definition Eliminar_Esfera_Formas_conj_2 : Prop := forall f f' e r_out, Eliminar_Esfera_Formas f f' e r_out ->
  exists s s', Recobro f s /\ Recobro f' s' /\ Eliminar_Esfera s s' e r_out.

Definition Viejo_Cilindro x r_out : Prop := Retrieve.type_of x = soy_cilindro /\ r_out = cilindro_eliminado.
Definition Eliminar_Cilindro_Formas f f' e r_out : Prop := exists x, Marco_Eliminar f f' x e /\ Viejo_Cilindro x
  r_out.
Definition Eliminar_Cilindro_Formas_conj_1 : Prop := forall s s' e r_out, Eliminar_Cilindro s s' e r_out -> exists f
  f', Retrato s f /\ Retrato s' f' /\ Eliminar_Cilindro_Formas f f' e r_out.
Definition Eliminar_Cilindro_Formas_conj_2 : Prop := forall f f' e r_out, Eliminar_Cilindro_Formas f f' e r_out ->
  exists s s', Recobro f s /\ Recobro f' s' /\ Eliminar_Cilindro s s' e r_out.

Definition Viejo_Cono x r_out : Prop := Retrieve.type_of x = soy_cono /\ r_out = cono_eliminado.
Definition Eliminar_Cono_Formas f f' e r_out : Prop := exists x, Marco_Eliminar f f' x e /\ Viejo_Cono x r_out.
Definition Eliminar_Cono_Formas_conj_1 : Prop := forall s s' e r_out, Eliminar_Cono s s' e r_out -> exists f f',
  Retrato s f /\ Retrato s' f' /\ Eliminar_Cono_Formas f f' e r_out.
Definition Eliminar_Cono_Formas_conj_2 : Prop := forall f f' e r_out, Eliminar_Cono_Formas f f' e r_out -> exists s
  s', Recobro f s /\ Recobro f' s' /\ Eliminar_Cono s s' e r_out.

Definition Viejo_Tronco x r_out : Prop := Retrieve.type_of x = soy_tronco /\ r_out = tronco_eliminado.
Definition Eliminar_Tronco_Formas f f' e r_out : Prop := exists x, Marco_Eliminar f f' x e /\ Viejo_Tronco x r_out.
Definition Eliminar_Tronco_Formas_conj_1 : Prop := forall s s' e r_out, Eliminar_Tronco s s' e r_out -> exists f f',
  Retrato s f /\ Retrato s' f' /\ Eliminar_Tronco_Formas f f' e r_out.
Definition Eliminar_Tronco_Formas_conj_2 : Prop := forall f f' e r_out, Eliminar_Tronco_Formas f f' e r_out ->
  exists s s', Recobro f s /\ Recobro f' s' /\ Eliminar_Tronco s s' e r_out.

Definition Viejo_Plano x r_out : Prop := Retrieve.type_of x = soy_plano /\ r_out = plano_eliminado.
Definition Eliminar_Plano_Formas f f' e r_out : Prop := exists x, Marco_Eliminar f f' x e /\ Viejo_Plano x r_out.
Definition Eliminar_Plano_Formas_conj_1 : Prop := forall s s' e r_out, Eliminar_Plano s s' e r_out -> exists f f',
  Retrato s f /\ Retrato s' f' /\ Eliminar_Plano_Formas f f' e r_out.
Definition Eliminar_Plano_Formas_conj_2 : Prop := forall f f' e r_out, Eliminar_Plano_Formas f f' e r_out -> exists
  s s', Recobro f s /\ Recobro f' s' /\ Eliminar_Plano s s' e r_out.

Definition Viejo_Disco x r_out : Prop := Retrieve.type_of x = soy_disco /\ r_out = disco_eliminado.
Definition Eliminar_Disco_Formas f f' e r_out : Prop := exists x, Marco_Eliminar f f' x e /\ Viejo_Disco x r_out.
Definition Eliminar_Disco_Formas_conj_1 : Prop := forall s s' e r_out, Eliminar_Disco s s' e r_out -> exists f f',
  Retrato s f /\ Retrato s' f' /\ Eliminar_Disco_Formas f f' e r_out.
Definition Eliminar_Disco_Formas_conj_2 : Prop := forall f f' e r_out, Eliminar_Disco_Formas f f' e r_out -> exists
  s s', Recobro f s /\ Recobro f' s' /\ Eliminar_Disco s s' e r_out.

Definition Viejo_Triangulo x r_out : Prop := Retrieve.type_of x = soy_triangulo /\ r_out = triangulo_eliminado.
Definition Eliminar_Triangulo_Formas f f' e r_out : Prop := exists x, Marco_Eliminar f f' x e /\ Viejo_Triangulo x
  r_out.
Definition Eliminar_Triangulo_Formas_conj_1 : Prop := forall s s' e r_out, Eliminar_Triangulo s s' e r_out -> exists
  f f', Retrato s f /\ Retrato s' f' /\ Eliminar_Triangulo_Formas f f' e r_out.
Definition Eliminar_Triangulo_Formas_conj_2 : Prop := forall f f' e r_out, Eliminar_Triangulo_Formas f f' e r_out ->
  exists s s', Recobro f s /\ Recobro f' s' /\ Eliminar_Triangulo s s' e r_out.

(** ** What a scene says of one shape *)

Definition has_shape s e x : Prop :=
  match x with
  | Retrieve.Sphere c r => is_esfera _ s e c r
  | Retrieve.Cylinder c r d h => is_cilindro _ s e c r d h
  | Retrieve.Cone c k d h => is_cono _ s e c k d h
  | Retrieve.TruncatedCone c r k d h => is_tronco _ s e c r k d h
  | Retrieve.Plane c d => is_plano _ s e c d
  | Retrieve.Disc c r d => is_disco _ s e c r d
  | Retrieve.Triangle abc => is_triangulo _ s e abc
  end.
(** Discharges Esfera.def.1, Cilindro.def.1, Cono.def.1, Tronco.def.1, Plano.def.1, Disco.def.1, Triangulo.def.1. *)
Lemma shapes_of_spec s e x : (e, x) ∈ shapes_of s <-> has_shape s e x.
Proof.
  unfold shapes_of, union, has_shape. cbn. split.
  - intros H. repeat destruct H as [H | H]; decompose [ex and] H; subst; assumption.
  - destruct x; intros H; eauto 12.
Qed.
Lemma has_type s e x : has_shape s e x -> (e, Retrieve.type_of x) ∈ de_que_tipo s.
Proof. destruct x; cbn; unfold is_esfera, is_cilindro, is_cono, is_tronco, is_plano, is_disco, is_triangulo; tauto.
  Qed.

Section Scene.
Variable s : Escena.
Hypothesis ok : Escena_ok s.

Lemma every_element_has_a_shape e : e ∈ elementos s -> exists x, has_shape s e x /\ valid x.
Proof.
  intros H. destruct (element_cases _ s ok e H) as [C | [C | [C | [C | [C | [C | C]]]]]]; decompose [ex and] C.
  - eexists (Retrieve.Sphere _ _). cbn. eauto 6.
  - eexists (Retrieve.Cylinder _ _ _ _). cbn. eauto 6.
  - eexists (Retrieve.Cone _ _ _ _). cbn. eauto 6.
  - eexists (Retrieve.TruncatedCone _ _ _ _ _). cbn. eauto 6.
  - eexists (Retrieve.Plane _ _). cbn. eauto 6.
  - eexists (Retrieve.Disc _ _ _). cbn. eauto 6.
  - eexists (Retrieve.Triangle _). cbn. eauto 6.
Qed.
Lemma shape_unique e x x' : has_shape s e x -> has_shape s e x' -> x = x'.
Proof.
  intros H H'. pose proof (type_unique _ s ok _ _ _ (has_type _ _ _ H) (has_type _ _ _ H')) as E.
  destruct x, x'; try discriminate E; cbn in H, H';
    unfold is_esfera, is_cilindro, is_cono, is_tronco, is_plano, is_disco, is_triangulo in *;
    decompose [and] H; decompose [and] H'; f_equal;
    eauto using centro_unique, radio_unique, vector_unique, altura_unique, proporcion_unique, vertices_unique.
Qed.
Lemma element_of_shape e x : has_shape s e x -> e ∈ elementos s.
Proof. intros H. exact (element_of_type _ s ok _ _ (has_type _ _ _ H)). Qed.

(** Of an attribute: it is what the shapes have of it. *)
Lemma attribute_of_shapes {V} (g : rel Elemento V) (A : Forma -> set V) (S : set Tipo) :
  g ∈ (univ ⇸ univ) -> (forall e t, (e, t) ∈ de_que_tipo s -> (dom g e <-> S t)) ->
  (forall e x v, has_shape s e x -> A x v -> (e, v) ∈ g) -> (forall x, S (Retrieve.type_of x) -> exists v, A x v) ->
  (forall e, dom g e -> e ∈ elementos s) ->
  g ≡ comp (shapes_of s) (of_shape A).
Proof.
  intros [F _] D U E L [e v]. unfold comp, of_shape. cbn. setoid_rewrite shapes_of_spec. split.
  - intros H. assert (He : dom g e) by now exists v.
    destruct (every_element_has_a_shape e (L e He)) as [x [Hx _]]. exists x. split; [exact Hx |].
    apply (D e _ (has_type _ _ _ Hx)) in He. apply E in He as [v' Hv]. now rewrite (F _ _ _ H (U _ _ _ Hx Hv)).
  - intros [x [Hx Hv]]. exact (U _ _ _ Hx Hv).
Qed.
End Scene.

(** ** The scene that shapes say *)

Definition scene_of f : Escena := {|
  elementos := dom f;
  tipos := ran (comp f tipo_de);
  de_que_tipo := comp f tipo_de;
  mi_centro := comp f centro_de;
  mi_radio := comp f radio_de;
  mi_vector := comp f vector_de;
  mi_altura := comp f altura_de;
  mi_proporcion := comp f proporcion_de;
  mi_vertices := comp f vertices_de
|}.

Lemma comp_pfun f {V} (A : Forma -> set V) B : Formas_ok f -> (forall x, at_most_one (A x)) ->
  (forall x, valid x -> A x ⊆ B) -> comp f (of_shape A) ∈ (univ ⇸ B).
Proof.
  intros [[F [_ G]] _] H1 HB. split; [| split; [easy |]].
  - intros e v v' [x [Hx Hv]] [x' [Hx' Hv']]. cbn in *. rewrite <- (F _ _ _ Hx Hx') in Hv'. exact (H1 x _ _ Hv Hv').
  - intros v [e [x [Hx Hv]]]. apply (HB x); [apply G; now exists e | exact Hv].
Qed.
Lemma comp_dom f {V} (A : Forma -> set V) S : (forall x, (exists v, A x v) <-> S (Retrieve.type_of x)) ->
  dom (comp f (of_shape A)) ≡ image (inverse (comp f tipo_de)) S.
Proof.
  intros H e. unfold dom, image, inverse, comp, tipo_de, of_shape, single. cbn. split.
  - intros [v [x [Hx Hv]]]. exists (Retrieve.type_of x). split; [apply H; now exists v | now exists x].
  - intros [t [Ht [x [Hx ->]]]]. apply H in Ht as [v Hv]. exists v, x. now split.
Qed.
(** Which types have an attribute. Discharges centro_de.def.1, radio_de.def.1, vector_de.def.1, altura_de.def.1,
    proporcion_de.def.1, vertices_de.def.1. *)
Lemma attributes_of_types x :
  ((exists v, Retrieve.centres x v) <-> centro_types (Retrieve.type_of x))
  /\ ((exists v, Retrieve.radii x v) <-> radio_types (Retrieve.type_of x))
  /\ ((exists v, Retrieve.axes x v) <-> vector_types (Retrieve.type_of x))
  /\ ((exists v, Retrieve.heights x v) <-> altura_types (Retrieve.type_of x))
  /\ ((exists v, Retrieve.proportions x v) <-> proporcion_types (Retrieve.type_of x))
  /\ ((exists v, Retrieve.vertices x v) <-> vertices_types (Retrieve.type_of x)).
Proof.
  destruct x; cbn; unfold centro_types, radio_types, vector_types, altura_types, proporcion_types, vertices_types,
    union, single, empty; repeat apply conj;
    first [ now intros [v []] | (intros _; now eexists) | (intros _; solve [auto 8])
          | (intros K; repeat (destruct K as [K | K]; [| discriminate K]); discriminate K) ].
Qed.
Lemma at_most_one_attribute x :
  at_most_one (Retrieve.centres x) /\ at_most_one (Retrieve.radii x) /\ at_most_one (Retrieve.axes x)
  /\ at_most_one (Retrieve.heights x) /\ at_most_one (Retrieve.proportions x) /\ at_most_one (Retrieve.vertices x).
Proof. destruct x; cbn; repeat split; auto using single_at_most_one, empty_at_most_one. Qed.
Lemma valid_attributes x : valid x -> Retrieve.radii x ⊆ Rmas /\ Retrieve.axes x ⊆ Unitario
  /\ Retrieve.heights x ⊆ Rmas /\ Retrieve.proportions x ⊆ Rmas /\ Retrieve.vertices x ⊆ Vertices.
Proof. destruct x; cbn; intros H; repeat apply conj; intros v Hv; first [now destruct Hv | (hnf in Hv; subst v;
  tauto)]. Qed.

Lemma scene_of_ok f : Formas_ok f -> Escena_ok (scene_of f).
Proof.
  intros ok. split; cbn;
    try (apply comp_dom; apply attributes_of_types);
    try (apply (comp_pfun f _ _ ok); [apply at_most_one_attribute | intros x Hx; try apply (valid_attributes x Hx);
    easy]).
  - apply ok.
  - easy.
  - apply (comp_pfun f _ _ ok); [intros x; apply single_at_most_one | easy].
  - intros e. unfold dom, comp, tipo_de, of_shape, single. cbn. split.
    + intros [x H]. now exists (Retrieve.type_of x), x.
    + intros [t [x [H _]]]. now exists x.
  - reflexivity.
Qed.

(** ** The two ways are one relation *)

Lemma dom_shapes_of s : Escena_ok s -> dom (shapes_of s) ≡ elementos s.
Proof.
  intros ok e. split.
  - intros [x H]. apply shapes_of_spec in H. exact (element_of_shape s ok e x H).
  - intros H. destruct (every_element_has_a_shape s ok e H) as [x [Hx _]]. exists x. now apply shapes_of_spec.
Qed.
Lemma shapes_of_ok s : Escena_ok s -> Formas_ok (shapes_of s).
Proof.
  intros ok. split; [split; [| split; [easy |]] |].
  - intros e x x' H H'. apply shapes_of_spec in H, H'. exact (shape_unique s ok e x x' H H').
  - intros x [e H]. apply shapes_of_spec in H.
    destruct (every_element_has_a_shape s ok e (element_of_shape s ok e x H)) as [x' [H' V]].
    now rewrite (shape_unique s ok e x x' H H').
  - rewrite (dom_shapes_of s ok). apply ok.
Qed.
(** Discharges tipo_de.def.1, centro_de.def.2, radio_de.def.2, vector_de.def.2, altura_de.def.2, proporcion_de.def.2,
    vertices_de.def.2, Recobro.inv.1, Recobro.inv.2, Recobro.inv.3, Recobro.inv.4, Recobro.inv.5, Recobro.inv.6,
    Recobro.inv.7. *)
Lemma shapes_say_the_scene s : Escena_ok s -> Recobro (shapes_of s) s.
Proof.
  intros ok.
  assert (U : forall e x, has_shape s e x ->
    (forall c, Retrieve.centres x c -> (e, c) ∈ mi_centro s) /\ (forall r, Retrieve.radii x r -> (e, r) ∈ mi_radio s)
    /\ (forall d, Retrieve.axes x d -> (e, d) ∈ mi_vector s) /\ (forall h, Retrieve.heights x h -> (e, h) ∈ mi_altura
    s)
    /\ (forall k, Retrieve.proportions x k -> (e, k) ∈ mi_proporcion s)
    /\ (forall abc, Retrieve.vertices x abc -> (e, abc) ∈ mi_vertices s)).
  { intros e x. destruct x; cbn; unfold is_esfera, is_cilindro, is_cono, is_tronco, is_plano, is_disco, is_triangulo;
      intros H; repeat apply conj; intros v Hv; first [now destruct Hv | (hnf in Hv; subst v; tauto)]. }
  assert (W : forall V (g : rel Elemento V) B, g ∈ (univ ⇸ B) -> g ∈ (univ ⇸ univ)) by (intros V g B [F _]; now split).
  split; [now apply shapes_of_ok | exact ok | | apply (attribute_of_shapes s ok) with (S := centro_types)
    | apply (attribute_of_shapes s ok) with (S := radio_types) | apply (attribute_of_shapes s ok) with (S :=
    vector_types)
    | apply (attribute_of_shapes s ok) with (S := altura_types)
    | apply (attribute_of_shapes s ok) with (S := proporcion_types)
    | apply (attribute_of_shapes s ok) with (S := vertices_types)];
    try (eapply W; apply ok); try (intros x; apply attributes_of_types);
    try (intros e x v Hx; apply (U e x Hx)).
  - intros [e t]. unfold comp, tipo_de, of_shape, single. cbn. setoid_rewrite shapes_of_spec. split.
    + intros H. destruct (every_element_has_a_shape s ok e (element_of_type _ s ok e t H)) as [x [Hx _]]. exists x.
      split; [exact Hx |]. exact (type_unique _ s ok e t _ H (has_type s e x Hx)).
    + intros [x [Hx ->]]. now apply has_type.
  - apply has_centro, ok.
  - apply element_of_centro, ok.
  - apply has_radio, ok.
  - apply element_of_radio, ok.
  - apply has_vector, ok.
  - apply element_of_vector, ok.
  - apply has_altura, ok.
  - apply element_of_altura, ok.
  - apply has_proporcion, ok.
  - apply element_of_proporcion, ok.
  - apply has_vertices, ok.
  - apply element_of_vertices, ok.
Qed.
End Promocion.
