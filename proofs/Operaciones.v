(** spec/operaciones.tex: every operation has one possible after-state, which keeps the invariant, and its
    preconditions are the clauses stated in the text.

    scene_with s e t cs rs ds hs ks vs == s and the element e of type t with a centre, radius, axis, height, proportion
                            and vertices that are the members of cs, rs, ds, hs, ks, vs: none or one each
    with_esfera, with_cilindro, with_cono, with_tronco, with_plano, with_disco, with_triangulo == the same for each type
    scene_without s e    == s without e in every component *)
From Coq Require Import Reals Setoid Classical_Prop.
From Durero Require Import Toolkit Especificacion Escena.
Local Open Scope zed_scope.

Section Operaciones.
Variable Elemento : Type.
Notation Escena := (Especificacion.Escena Elemento).
Implicit Types (s : Escena) (e : Elemento) (c : Punto) (d : Vector) (abc : Terna).

Definition scene_with s e t (cs : set Punto) (rs : set R) (ds : set Vector) (hs ks : set R) (vs : set Terna) :
  Escena := {|
  elementos := elementos s ∪ ⦃e⦄;
  tipos := ran (de_que_tipo s ∪ ⦃(e, t)⦄);
  de_que_tipo := de_que_tipo s ∪ ⦃(e, t)⦄;
  mi_centro := mi_centro s ∪ at_one e cs;
  mi_radio := mi_radio s ∪ at_one e rs;
  mi_vector := mi_vector s ∪ at_one e ds;
  mi_altura := mi_altura s ∪ at_one e hs;
  mi_proporcion := mi_proporcion s ∪ at_one e ks;
  mi_vertices := mi_vertices s ∪ at_one e vs
|}.
Definition with_esfera s e c r : Escena := scene_with s e soy_esfera ⦃c⦄ ⦃r⦄ ∅ ∅ ∅ ∅.
Definition with_cilindro s e c r d h : Escena := scene_with s e soy_cilindro ⦃c⦄ ⦃r⦄ ⦃d⦄ ⦃h⦄ ∅ ∅.
Definition with_cono s e c k d h : Escena := scene_with s e soy_cono ⦃c⦄ ∅ ⦃d⦄ ⦃h⦄ ⦃k⦄ ∅.
Definition with_tronco s e c r k d h : Escena := scene_with s e soy_tronco ⦃c⦄ ⦃r⦄ ⦃d⦄ ⦃h⦄ ⦃k⦄ ∅.
Definition with_plano s e c d : Escena := scene_with s e soy_plano ⦃c⦄ ∅ ⦃d⦄ ∅ ∅ ∅.
Definition with_disco s e c r d : Escena := scene_with s e soy_disco ⦃c⦄ ⦃r⦄ ⦃d⦄ ∅ ∅ ∅.
Definition with_triangulo s e abc : Escena := scene_with s e soy_triangulo ∅ ∅ ∅ ∅ ∅ ⦃abc⦄.

Definition scene_without s e : Escena := {|
  elementos := elementos s ∖ ⦃e⦄;
  tipos := ran (ndres ⦃e⦄ (de_que_tipo s));
  de_que_tipo := ndres ⦃e⦄ (de_que_tipo s);
  mi_centro := ndres ⦃e⦄ (mi_centro s);
  mi_radio := ndres ⦃e⦄ (mi_radio s);
  mi_vector := ndres ⦃e⦄ (mi_vector s);
  mi_altura := ndres ⦃e⦄ (mi_altura s);
  mi_proporcion := ndres ⦃e⦄ (mi_proporcion s);
  mi_vertices := ndres ⦃e⦄ (mi_vertices s)
|}.

(** ** The after-states satisfy the invariant *)

Lemma single_at_most_one {X} (x : X) : at_most_one ⦃x⦄.
Proof. now intros v v' -> ->. Qed.
Lemma empty_at_most_one {X} : at_most_one (∅ : set X).
Proof. now intros v v' []. Qed.
Lemma exists_single {X} (x : X) (P : Prop) : P -> (exists v, ⦃x⦄ v) <-> P.
Proof. intros HP. split; [easy | intros _; now exists x]. Qed.
Lemma exists_empty {X} (P : Prop) : ~ P -> (exists v, (∅ : set X) v) <-> P.
Proof. intros HP. split; [now intros [v []] | easy]. Qed.

Lemma scene_with_ok s e t cs rs ds hs ks vs :
  Escena_ok s -> e ∉ elementos s ->
  at_most_one cs -> ((exists c, cs c) <-> centro_types t) ->
  at_most_one rs -> rs ⊆ Rmas -> ((exists r, rs r) <-> radio_types t) ->
  at_most_one ds -> ds ⊆ Unitario -> ((exists d, ds d) <-> vector_types t) ->
  at_most_one hs -> hs ⊆ Rmas -> ((exists h, hs h) <-> altura_types t) ->
  at_most_one ks -> ks ⊆ Rmas -> ((exists k, ks k) <-> proporcion_types t) ->
  at_most_one vs -> vs ⊆ Vertices -> ((exists abc, vs abc) <-> vertices_types t) ->
  Escena_ok (scene_with s e t cs rs ds hs ks vs).
Proof.
  intros ok He C1 C3 R1 R2 R3 D1 D2 D3 H1 H2 H3 K1 K2 K3 V1 V2 V3. split; cbn.
  - apply finset_add, ok.
  - easy.
  - rewrite <- at_one_single. apply pfun_union; [apply ok | | apply single_at_most_one | easy].
    intros [t' Ht]. now apply He, (element_of_type _ _ ok e t').
  - apply pfun_union; auto; [apply ok | | easy]. intros H. now apply He, (element_of_centro _ _ ok).
  - apply pfun_union; auto; [apply ok |]. intros H. now apply He, (element_of_radio _ _ ok).
  - apply pfun_union; auto; [apply ok | | easy]. intros H. now apply He, (element_of_vector _ _ ok).
  - apply pfun_union; auto; [apply ok |]. intros H. now apply He, (element_of_altura _ _ ok).
  - apply pfun_union; auto; [apply ok |]. intros H. now apply He, (element_of_proporcion _ _ ok).
  - apply pfun_union; auto; [apply ok |]. intros H. now apply He, (element_of_vertices _ _ ok).
  - intros x. rewrite dom_union_single, <- (Escena_inv_1 ok x). reflexivity.
  - intros x. now rewrite dom_union_at_one, image_inverse_union, (Escena_inv_2 ok x), C3.
  - intros x. now rewrite dom_union_at_one, image_inverse_union, (Escena_inv_3 ok x), R3.
  - intros x. now rewrite dom_union_at_one, image_inverse_union, (Escena_inv_4 ok x), D3.
  - intros x. now rewrite dom_union_at_one, image_inverse_union, (Escena_inv_5 ok x), H3.
  - intros x. now rewrite dom_union_at_one, image_inverse_union, (Escena_inv_6 ok x), K3.
  - reflexivity.
  - intros d [x [H | [_ H]]]; [apply (Escena_inv_8 ok); now exists x | now apply D2].
  - intros x. now rewrite dom_union_at_one, image_inverse_union, (Escena_inv_9 ok x), V3.
Qed.

(** Each type has one value, or none, in the range of each attribute, and a value exactly of those that it has. *)
Ltac type_added := intros; apply scene_with_ok; auto using single_at_most_one, empty_at_most_one; try easy;
  try (now intros x ->); first [apply exists_single; cbv; tauto | apply exists_empty; cbv; intuition discriminate].

Lemma with_esfera_ok s e c r : Escena_ok s -> e ∉ elementos s -> r ∈ Rmas -> Escena_ok (with_esfera s e c r).
Proof. type_added. Qed.
Lemma with_cilindro_ok s e c r d h : Escena_ok s -> e ∉ elementos s -> r ∈ Rmas -> d ∈ Unitario -> h ∈ Rmas ->
  Escena_ok (with_cilindro s e c r d h).
Proof. type_added. Qed.
Lemma with_cono_ok s e c k d h : Escena_ok s -> e ∉ elementos s -> k ∈ Rmas -> d ∈ Unitario -> h ∈ Rmas ->
  Escena_ok (with_cono s e c k d h).
Proof. type_added. Qed.
Lemma with_tronco_ok s e c r k d h : Escena_ok s -> e ∉ elementos s -> r ∈ Rmas -> k ∈ Rmas -> d ∈ Unitario ->
  h ∈ Rmas -> Escena_ok (with_tronco s e c r k d h).
Proof. type_added. Qed.
Lemma with_plano_ok s e c d : Escena_ok s -> e ∉ elementos s -> d ∈ Unitario -> Escena_ok (with_plano s e c d).
Proof. type_added. Qed.
Lemma with_disco_ok s e c r d : Escena_ok s -> e ∉ elementos s -> r ∈ Rmas -> d ∈ Unitario ->
  Escena_ok (with_disco s e c r d).
Proof. type_added. Qed.
Lemma with_triangulo_ok s e abc : Escena_ok s -> e ∉ elementos s -> abc ∈ Vertices ->
  Escena_ok (with_triangulo s e abc).
Proof. type_added. Qed.

Lemma scene_without_ok s e : Escena_ok s -> Escena_ok (scene_without s e).
Proof.
  intros ok. split; cbn; try (apply pfun_ndres, ok).
  - apply finset_subset with (elementos s); [apply ok | now intros x []].
  - intros x. rewrite dom_ndres, <- (Escena_inv_1 ok x). reflexivity.
  - intros x. now rewrite dom_ndres, image_inverse_ndres, (Escena_inv_2 ok x).
  - intros x. now rewrite dom_ndres, image_inverse_ndres, (Escena_inv_3 ok x).
  - intros x. now rewrite dom_ndres, image_inverse_ndres, (Escena_inv_4 ok x).
  - intros x. now rewrite dom_ndres, image_inverse_ndres, (Escena_inv_5 ok x).
  - intros x. now rewrite dom_ndres, image_inverse_ndres, (Escena_inv_6 ok x).
  - reflexivity.
  - intros d [x [_ H]]. apply (Escena_inv_8 ok). now exists x.
  - intros x. now rewrite dom_ndres, image_inverse_ndres, (Escena_inv_9 ok x).
Qed.

(** ** Each operation, computed: its preconditions, its only after-state and its answer *)

(** What an addition says of each component is what the scene with the element says of it. *)
Ltac addition_computed with_ok := split;
  [ let ok' := fresh "ok" in let P2 := fresh "P" in intros [[[? ok'] ? ? P2]]; subst;
    split; [tauto | split; [split; cbn; rewrite ?at_one_single, ?at_one_empty; auto | reflexivity]];
    now rewrite (Escena_inv_7 ok'), P2
  | let C := fresh "C" in let E := fresh "E" in intros [C [E ->]]; decompose [and] C; subst;
    pose proof (Escena_ok_eq _ _ _ E ltac:(apply with_ok; assumption)); destruct E; cbn in *;
    rewrite ?at_one_single, ?at_one_empty in *; do 3 (split; auto) ].

(** Agregar_Esfera happens exactly from a scene without e, with t = soy_esfera and a positive radius; the scene then
    gains that sphere and nothing else. Discharges Agregar_Elemento.pre.1, Agregar_Elemento.post.1,
    Agregar_Elemento.post.2, Agregar_Esfera.pre.1, Agregar_Esfera.pre.2, Agregar_Esfera.post.1, Agregar_Esfera.post.2,
    Agregar_Esfera.post.3, Agregar_Esfera.post.4, Agregar_Esfera.post.5, Agregar_Esfera.post.6, Agregar_Esfera.post.7. *)
Theorem Agregar_Esfera_computed s s' e t r_out c r :
  Agregar_Esfera s s' e t r_out c r <->
  (Escena_ok s /\ e ∉ elementos s /\ t = soy_esfera /\ r ∈ Rmas)
  /\ Escena_eq (with_esfera s e c r) s' /\ r_out = esfera_agregada.
Proof. addition_computed with_esfera_ok. Qed.

(** Agregar_Cilindro happens exactly when its clauses hold; the scene then gains that cylinder and nothing else.
    Discharges Agregar_Cilindro.pre.1, Agregar_Cilindro.pre.2, Agregar_Cilindro.pre.3, Agregar_Cilindro.pre.4,
    Agregar_Cilindro.post.1, Agregar_Cilindro.post.2, Agregar_Cilindro.post.3, Agregar_Cilindro.post.4,
    Agregar_Cilindro.post.5, Agregar_Cilindro.post.6, Agregar_Cilindro.post.7. *)
Theorem Agregar_Cilindro_computed s s' e t r_out c r d h :
  Agregar_Cilindro s s' e t r_out c r d h <->
  (Escena_ok s /\ e ∉ elementos s /\ t = soy_cilindro /\ r ∈ Rmas /\ d ∈ Unitario /\ h ∈ Rmas)
  /\ Escena_eq (with_cilindro s e c r d h) s' /\ r_out = cilindro_agregado.
Proof. addition_computed with_cilindro_ok. Qed.

(** Agregar_Cono happens exactly when its clauses hold; the scene then gains that cone and nothing else.
    Discharges Agregar_Cono.pre.1, Agregar_Cono.pre.2, Agregar_Cono.pre.3, Agregar_Cono.pre.4, Agregar_Cono.post.1,
    Agregar_Cono.post.2, Agregar_Cono.post.3, Agregar_Cono.post.4, Agregar_Cono.post.5, Agregar_Cono.post.6,
    Agregar_Cono.post.7. *)
Theorem Agregar_Cono_computed s s' e t r_out c k d h :
  Agregar_Cono s s' e t r_out c k d h <->
  (Escena_ok s /\ e ∉ elementos s /\ t = soy_cono /\ k ∈ Rmas /\ d ∈ Unitario /\ h ∈ Rmas)
  /\ Escena_eq (with_cono s e c k d h) s' /\ r_out = cono_agregado.
Proof. addition_computed with_cono_ok. Qed.

(** Agregar_Tronco happens exactly when its clauses hold; the scene then gains that truncated cone and nothing else.
    Discharges Agregar_Tronco.pre.1, Agregar_Tronco.pre.2, Agregar_Tronco.pre.3, Agregar_Tronco.pre.4,
    Agregar_Tronco.pre.5, Agregar_Tronco.post.1, Agregar_Tronco.post.2, Agregar_Tronco.post.3, Agregar_Tronco.post.4,
    Agregar_Tronco.post.5, Agregar_Tronco.post.6, Agregar_Tronco.post.7. *)
Theorem Agregar_Tronco_computed s s' e t r_out c r k d h :
  Agregar_Tronco s s' e t r_out c r k d h <->
  (Escena_ok s /\ e ∉ elementos s /\ t = soy_tronco /\ r ∈ Rmas /\ k ∈ Rmas /\ d ∈ Unitario /\ h ∈ Rmas)
  /\ Escena_eq (with_tronco s e c r k d h) s' /\ r_out = tronco_agregado.
Proof. addition_computed with_tronco_ok. Qed.

(** Agregar_Plano happens exactly when its clauses hold; the scene then gains that plane and nothing else.
    Discharges Agregar_Plano.pre.1, Agregar_Plano.pre.2, Agregar_Plano.post.1, Agregar_Plano.post.2,
    Agregar_Plano.post.3, Agregar_Plano.post.4, Agregar_Plano.post.5, Agregar_Plano.post.6, Agregar_Plano.post.7. *)
Theorem Agregar_Plano_computed s s' e t r_out c d :
  Agregar_Plano s s' e t r_out c d <->
  (Escena_ok s /\ e ∉ elementos s /\ t = soy_plano /\ d ∈ Unitario)
  /\ Escena_eq (with_plano s e c d) s' /\ r_out = plano_agregado.
Proof. addition_computed with_plano_ok. Qed.

(** Agregar_Disco happens exactly when its clauses hold; the scene then gains that disc and nothing else.
    Discharges Agregar_Disco.pre.1, Agregar_Disco.pre.2, Agregar_Disco.pre.3, Agregar_Disco.post.1, Agregar_Disco.post.2,
    Agregar_Disco.post.3, Agregar_Disco.post.4, Agregar_Disco.post.5, Agregar_Disco.post.6, Agregar_Disco.post.7. *)
Theorem Agregar_Disco_computed s s' e t r_out c r d :
  Agregar_Disco s s' e t r_out c r d <->
  (Escena_ok s /\ e ∉ elementos s /\ t = soy_disco /\ r ∈ Rmas /\ d ∈ Unitario)
  /\ Escena_eq (with_disco s e c r d) s' /\ r_out = disco_agregado.
Proof. addition_computed with_disco_ok. Qed.

(** Agregar_Triangulo happens exactly when its clauses hold; the scene then gains that triangle and nothing else.
    Discharges Agregar_Triangulo.pre.1, Agregar_Triangulo.pre.2, Agregar_Triangulo.post.1, Agregar_Triangulo.post.2,
    Agregar_Triangulo.post.3, Agregar_Triangulo.post.4, Agregar_Triangulo.post.5, Agregar_Triangulo.post.6,
    Agregar_Triangulo.post.7. *)
Theorem Agregar_Triangulo_computed s s' e t r_out abc :
  Agregar_Triangulo s s' e t r_out abc <->
  (Escena_ok s /\ e ∉ elementos s /\ t = soy_triangulo /\ abc ∈ Vertices)
  /\ Escena_eq (with_triangulo s e abc) s' /\ r_out = triangulo_agregado.
Proof. addition_computed with_triangulo_ok. Qed.

(** An attribute that the type of e does not have is untouched by removing e. *)
Lemma no_attribute s e t : Escena_ok s -> (e, t) ∈ de_que_tipo s ->
  (t ∉ centro_types -> ndres ⦃e⦄ (mi_centro s) ≡ mi_centro s)
  /\ (t ∉ radio_types -> ndres ⦃e⦄ (mi_radio s) ≡ mi_radio s)
  /\ (t ∉ vector_types -> ndres ⦃e⦄ (mi_vector s) ≡ mi_vector s)
  /\ (t ∉ altura_types -> ndres ⦃e⦄ (mi_altura s) ≡ mi_altura s)
  /\ (t ∉ proporcion_types -> ndres ⦃e⦄ (mi_proporcion s) ≡ mi_proporcion s)
  /\ (t ∉ vertices_types -> ndres ⦃e⦄ (mi_vertices s) ≡ mi_vertices s).
Proof.
  intros ok Ht. split; [| split; [| split; [| split; [| split]]]]; intros N; apply ndres_outside;
    rewrite ?(has_centro _ _ ok e t Ht), ?(has_radio _ _ ok e t Ht), ?(has_vector _ _ ok e t Ht),
      ?(has_altura _ _ ok e t Ht), ?(has_proporcion _ _ ok e t Ht), ?(has_vertices _ _ ok e t Ht); exact N.
Qed.

(** What a removal says of each component is that the element is without it: where its type lacks the attribute, that
    the attribute stays as it is. *)
Ltac untouched ok Ht := let N := fresh "N" in
  pose proof (no_attribute _ _ _ ok Ht) as N;
  unfold centro_types, radio_types, vector_types, altura_types, proporcion_types, vertices_types, union, single in N;
  decompose [and] N; clear N;
  repeat match goal with H : ~ _ -> ndres _ _ ≡ _ |- _ =>
    first [specialize (H ltac:(let T := fresh in intros T; repeat destruct T as [T | T]; discriminate T)) | clear H] end.
Ltac removal_computed := split;
  [ let ok := fresh "ok" in let ok' := fresh "ok" in let P2 := fresh "P" in let Ht := fresh "Ht" in
    intros [[[ok ok'] ? ? P2] [? [Ht ->]]]; subst; split; [tauto | split; [split; cbn | reflexivity]]; untouched ok Ht;
    repeat match goal with N : ndres _ ?f ≡ ?f |- _ ≡ ndres _ ?f => rewrite N end; auto;
    now rewrite (Escena_inv_7 ok'), P2
  | let ok := fresh "ok" in let Ht := fresh "Ht" in let E := fresh "E" in intros [[ok Ht] [E ->]];
    pose proof (Escena_ok_eq _ _ _ E (scene_without_ok _ _ ok)); pose proof (element_of_type _ _ ok _ _ Ht);
    destruct E; cbn in *; untouched ok Ht; split; eauto; [do 2 (split; auto) | ..];
    match goal with N : ndres _ ?f ≡ ?f |- _ ≡ ?f => now rewrite <- N end ].

(** Eliminar_Esfera happens exactly on a sphere of the scene; the scene then loses it and nothing else.
    Discharges Eliminar_Elemento.pre.1, Eliminar_Elemento.post.1, Eliminar_Elemento.post.2, Eliminar_Esfera.pre.1,
    Eliminar_Esfera.post.1, Eliminar_Esfera.post.2, Eliminar_Esfera.post.3, Eliminar_Esfera.post.4,
    Eliminar_Esfera.post.5, Eliminar_Esfera.post.6, Eliminar_Esfera.post.7. *)
Theorem Eliminar_Esfera_computed s s' e r_out :
  Eliminar_Esfera s s' e r_out <->
  (Escena_ok s /\ (e, soy_esfera) ∈ de_que_tipo s) /\ Escena_eq (scene_without s e) s' /\ r_out = esfera_eliminada.
Proof. removal_computed. Qed.

(** Eliminar_Cilindro happens exactly on a cylinder of the scene; the scene then loses it and nothing else.
    Discharges Eliminar_Cilindro.pre.1, Eliminar_Cilindro.post.1, Eliminar_Cilindro.post.2, Eliminar_Cilindro.post.3,
    Eliminar_Cilindro.post.4, Eliminar_Cilindro.post.5, Eliminar_Cilindro.post.6, Eliminar_Cilindro.post.7. *)
Theorem Eliminar_Cilindro_computed s s' e r_out :
  Eliminar_Cilindro s s' e r_out <->
  (Escena_ok s /\ (e, soy_cilindro) ∈ de_que_tipo s) /\ Escena_eq (scene_without s e) s' /\ r_out = cilindro_eliminado.
Proof. removal_computed. Qed.

(** Eliminar_Cono happens exactly on a cone of the scene; the scene then loses it and nothing else.
    Discharges Eliminar_Cono.pre.1, Eliminar_Cono.post.1, Eliminar_Cono.post.2, Eliminar_Cono.post.3,
    Eliminar_Cono.post.4, Eliminar_Cono.post.5, Eliminar_Cono.post.6, Eliminar_Cono.post.7. *)
Theorem Eliminar_Cono_computed s s' e r_out :
  Eliminar_Cono s s' e r_out <->
  (Escena_ok s /\ (e, soy_cono) ∈ de_que_tipo s) /\ Escena_eq (scene_without s e) s' /\ r_out = cono_eliminado.
Proof. removal_computed. Qed.

(** Eliminar_Tronco happens exactly on a truncated cone of the scene; the scene then loses it and nothing else.
    Discharges Eliminar_Tronco.pre.1, Eliminar_Tronco.post.1, Eliminar_Tronco.post.2, Eliminar_Tronco.post.3,
    Eliminar_Tronco.post.4, Eliminar_Tronco.post.5, Eliminar_Tronco.post.6, Eliminar_Tronco.post.7. *)
Theorem Eliminar_Tronco_computed s s' e r_out :
  Eliminar_Tronco s s' e r_out <->
  (Escena_ok s /\ (e, soy_tronco) ∈ de_que_tipo s) /\ Escena_eq (scene_without s e) s' /\ r_out = tronco_eliminado.
Proof. removal_computed. Qed.

(** Eliminar_Plano happens exactly on a plane of the scene; the scene then loses it and nothing else.
    Discharges Eliminar_Plano.pre.1, Eliminar_Plano.post.1, Eliminar_Plano.post.2, Eliminar_Plano.post.3,
    Eliminar_Plano.post.4, Eliminar_Plano.post.5, Eliminar_Plano.post.6, Eliminar_Plano.post.7. *)
Theorem Eliminar_Plano_computed s s' e r_out :
  Eliminar_Plano s s' e r_out <->
  (Escena_ok s /\ (e, soy_plano) ∈ de_que_tipo s) /\ Escena_eq (scene_without s e) s' /\ r_out = plano_eliminado.
Proof. removal_computed. Qed.

(** Eliminar_Disco happens exactly on a disc of the scene; the scene then loses it and nothing else.
    Discharges Eliminar_Disco.pre.1, Eliminar_Disco.post.1, Eliminar_Disco.post.2, Eliminar_Disco.post.3,
    Eliminar_Disco.post.4, Eliminar_Disco.post.5, Eliminar_Disco.post.6, Eliminar_Disco.post.7. *)
Theorem Eliminar_Disco_computed s s' e r_out :
  Eliminar_Disco s s' e r_out <->
  (Escena_ok s /\ (e, soy_disco) ∈ de_que_tipo s) /\ Escena_eq (scene_without s e) s' /\ r_out = disco_eliminado.
Proof. removal_computed. Qed.

(** Eliminar_Triangulo happens exactly on a triangle of the scene; the scene then loses it and nothing else.
    Discharges Eliminar_Triangulo.pre.1, Eliminar_Triangulo.post.1, Eliminar_Triangulo.post.2, Eliminar_Triangulo.post.3,
    Eliminar_Triangulo.post.4, Eliminar_Triangulo.post.5, Eliminar_Triangulo.post.6, Eliminar_Triangulo.post.7. *)
Theorem Eliminar_Triangulo_computed s s' e r_out :
  Eliminar_Triangulo s s' e r_out <->
  (Escena_ok s /\ (e, soy_triangulo) ∈ de_que_tipo s) /\ Escena_eq (scene_without s e) s'
  /\ r_out = triangulo_eliminado.
Proof. removal_computed. Qed.

(** ** The preconditions are the stated clauses, and nothing more *)

(** Where the clauses hold, the operation gives the scene that was computed, and its answer. *)
Ltac clauses_suffice computed := split;
  [ let H := fresh in intros [? [? H]]; now apply computed in H
  | intros ?; do 2 eexists; apply computed; split; [eassumption | split; [apply Escena_eq_refl | reflexivity]] ].

(** pre Agregar_Esfera is exactly its stated clauses. *)
Theorem pre_Agregar_Esfera s e t c r :
  (exists s' r_out, Agregar_Esfera s s' e t r_out c r) <->
  Escena_ok s /\ e ∉ elementos s /\ t = soy_esfera /\ r ∈ Rmas.
Proof. clauses_suffice Agregar_Esfera_computed. Qed.
(** pre Agregar_Cilindro is exactly its stated clauses. *)
Theorem pre_Agregar_Cilindro s e t c r d h :
  (exists s' r_out, Agregar_Cilindro s s' e t r_out c r d h) <->
  Escena_ok s /\ e ∉ elementos s /\ t = soy_cilindro /\ r ∈ Rmas /\ d ∈ Unitario /\ h ∈ Rmas.
Proof. clauses_suffice Agregar_Cilindro_computed. Qed.
(** pre Agregar_Cono is exactly its stated clauses. *)
Theorem pre_Agregar_Cono s e t c k d h :
  (exists s' r_out, Agregar_Cono s s' e t r_out c k d h) <->
  Escena_ok s /\ e ∉ elementos s /\ t = soy_cono /\ k ∈ Rmas /\ d ∈ Unitario /\ h ∈ Rmas.
Proof. clauses_suffice Agregar_Cono_computed. Qed.
(** pre Agregar_Tronco is exactly its stated clauses. *)
Theorem pre_Agregar_Tronco s e t c r k d h :
  (exists s' r_out, Agregar_Tronco s s' e t r_out c r k d h) <->
  Escena_ok s /\ e ∉ elementos s /\ t = soy_tronco /\ r ∈ Rmas /\ k ∈ Rmas /\ d ∈ Unitario /\ h ∈ Rmas.
Proof. clauses_suffice Agregar_Tronco_computed. Qed.
(** pre Agregar_Plano is exactly its stated clauses. *)
Theorem pre_Agregar_Plano s e t c d :
  (exists s' r_out, Agregar_Plano s s' e t r_out c d) <->
  Escena_ok s /\ e ∉ elementos s /\ t = soy_plano /\ d ∈ Unitario.
Proof. clauses_suffice Agregar_Plano_computed. Qed.
(** pre Agregar_Disco is exactly its stated clauses. *)
Theorem pre_Agregar_Disco s e t c r d :
  (exists s' r_out, Agregar_Disco s s' e t r_out c r d) <->
  Escena_ok s /\ e ∉ elementos s /\ t = soy_disco /\ r ∈ Rmas /\ d ∈ Unitario.
Proof. clauses_suffice Agregar_Disco_computed. Qed.
(** pre Agregar_Triangulo is exactly its stated clauses. *)
Theorem pre_Agregar_Triangulo s e t abc :
  (exists s' r_out, Agregar_Triangulo s s' e t r_out abc) <->
  Escena_ok s /\ e ∉ elementos s /\ t = soy_triangulo /\ abc ∈ Vertices.
Proof. clauses_suffice Agregar_Triangulo_computed. Qed.
(** pre of each removal is exactly that e is an element of its type. *)
Theorem pre_Eliminar s e :
  ((exists s' r_out, Eliminar_Esfera s s' e r_out) <-> Escena_ok s /\ (e, soy_esfera) ∈ de_que_tipo s)
  /\ ((exists s' r_out, Eliminar_Cilindro s s' e r_out) <-> Escena_ok s /\ (e, soy_cilindro) ∈ de_que_tipo s)
  /\ ((exists s' r_out, Eliminar_Cono s s' e r_out) <-> Escena_ok s /\ (e, soy_cono) ∈ de_que_tipo s)
  /\ ((exists s' r_out, Eliminar_Tronco s s' e r_out) <-> Escena_ok s /\ (e, soy_tronco) ∈ de_que_tipo s)
  /\ ((exists s' r_out, Eliminar_Plano s s' e r_out) <-> Escena_ok s /\ (e, soy_plano) ∈ de_que_tipo s)
  /\ ((exists s' r_out, Eliminar_Disco s s' e r_out) <-> Escena_ok s /\ (e, soy_disco) ∈ de_que_tipo s)
  /\ ((exists s' r_out, Eliminar_Triangulo s s' e r_out) <-> Escena_ok s /\ (e, soy_triangulo) ∈ de_que_tipo s).
Proof.
  split; [| split; [| split; [| split; [| split; [| split]]]]].
  - clauses_suffice Eliminar_Esfera_computed.
  - clauses_suffice Eliminar_Cilindro_computed.
  - clauses_suffice Eliminar_Cono_computed.
  - clauses_suffice Eliminar_Tronco_computed.
  - clauses_suffice Eliminar_Plano_computed.
  - clauses_suffice Eliminar_Disco_computed.
  - clauses_suffice Eliminar_Triangulo_computed.
Qed.

(** ** The promoted operations *)

(** What an addition of e, t, c, r, d, h, k, abc asks for is possible: the clauses of the type t hold. *)
Definition addition_possible s e t (r : R) d (h k : R) abc : Prop :=
  Escena_ok s /\ e ∉ elementos s /\
  match t with
  | soy_esfera => r ∈ Rmas
  | soy_cilindro => r ∈ Rmas /\ d ∈ Unitario /\ h ∈ Rmas
  | soy_cono => k ∈ Rmas /\ d ∈ Unitario /\ h ∈ Rmas
  | soy_tronco => r ∈ Rmas /\ k ∈ Rmas /\ d ∈ Unitario /\ h ∈ Rmas
  | soy_plano => d ∈ Unitario
  | soy_disco => r ∈ Rmas /\ d ∈ Unitario
  | soy_triangulo => abc ∈ Vertices
  end.
Definition scene_added s e t c r d h k abc : Escena :=
  match t with
  | soy_esfera => with_esfera s e c r
  | soy_cilindro => with_cilindro s e c r d h
  | soy_cono => with_cono s e c k d h
  | soy_tronco => with_tronco s e c r k d h
  | soy_plano => with_plano s e c d
  | soy_disco => with_disco s e c r d
  | soy_triangulo => with_triangulo s e abc
  end.

(** The general addition is that of the type given, with the general answer. Discharges Elemento_Agregado.post.1. *)
Theorem Elemento_Agregado_computed s s' e t c r d h k abc r_out :
  Elemento_Agregado s s' e t c r d h k abc r_out <->
  addition_possible s e t r d h k abc /\ Escena_eq (scene_added s e t c r d h k abc) s' /\ r_out = elemento_agregado.
Proof.
  unfold Elemento_Agregado, addition_possible, scene_added. split.
  - intros [[r0 [H | [H | [H | [H | [H | [H | H]]]]]]] ->].
    + apply Agregar_Esfera_computed in H as [[? [? [-> ?]]] [? _]]. auto.
    + apply Agregar_Cilindro_computed in H as [[? [? [-> ?]]] [? _]]. auto.
    + apply Agregar_Cono_computed in H as [[? [? [-> ?]]] [? _]]. auto.
    + apply Agregar_Tronco_computed in H as [[? [? [-> ?]]] [? _]]. auto.
    + apply Agregar_Plano_computed in H as [[? [? [-> ?]]] [? _]]. auto.
    + apply Agregar_Disco_computed in H as [[? [? [-> ?]]] [? _]]. auto.
    + apply Agregar_Triangulo_computed in H as [[? [? [-> ?]]] [? _]]. auto.
  - intros [[ok [He H]] [E ->]]. split; [| reflexivity]. destruct t.
    + exists esfera_agregada. left. apply Agregar_Esfera_computed. auto.
    + exists cilindro_agregado. right; left. apply Agregar_Cilindro_computed. auto.
    + exists cono_agregado. right; right; left. apply Agregar_Cono_computed. auto.
    + exists tronco_agregado. right; right; right; left. apply Agregar_Tronco_computed. auto.
    + exists plano_agregado. do 4 right; left. apply Agregar_Plano_computed. auto.
    + exists disco_agregado. do 5 right; left. apply Agregar_Disco_computed. auto.
    + exists triangulo_agregado. do 6 right. apply Agregar_Triangulo_computed. auto.
Qed.

(** The general removal happens exactly on an element of the scene. Discharges Elemento_Eliminado.post.1. *)
Theorem Elemento_Eliminado_computed s s' e r_out :
  Elemento_Eliminado s s' e r_out <->
  (Escena_ok s /\ e ∈ elementos s) /\ Escena_eq (scene_without s e) s' /\ r_out = elemento_eliminado.
Proof.
  unfold Elemento_Eliminado. split.
  - intros [[r0 [H | [H | [H | [H | [H | [H | H]]]]]]] ->].
    + apply Eliminar_Esfera_computed in H as [[ok H] [? _]]. eauto 6 using (element_of_type _ _ ok).
    + apply Eliminar_Cilindro_computed in H as [[ok H] [? _]]. eauto 6 using (element_of_type _ _ ok).
    + apply Eliminar_Cono_computed in H as [[ok H] [? _]]. eauto 6 using (element_of_type _ _ ok).
    + apply Eliminar_Tronco_computed in H as [[ok H] [? _]]. eauto 6 using (element_of_type _ _ ok).
    + apply Eliminar_Plano_computed in H as [[ok H] [? _]]. eauto 6 using (element_of_type _ _ ok).
    + apply Eliminar_Disco_computed in H as [[ok H] [? _]]. eauto 6 using (element_of_type _ _ ok).
    + apply Eliminar_Triangulo_computed in H as [[ok H] [? _]]. eauto 6 using (element_of_type _ _ ok).
  - intros [[ok He] [E ->]]. split; [| reflexivity]. destruct (type_of_element _ _ ok e He) as [[] Ht].
    + exists esfera_eliminada. left. apply Eliminar_Esfera_computed. auto.
    + exists cilindro_eliminado. right; left. apply Eliminar_Cilindro_computed. auto.
    + exists cono_eliminado. right; right; left. apply Eliminar_Cono_computed. auto.
    + exists tronco_eliminado. right; right; right; left. apply Eliminar_Tronco_computed. auto.
    + exists plano_eliminado. do 4 right; left. apply Eliminar_Plano_computed. auto.
    + exists disco_eliminado. do 5 right; left. apply Eliminar_Disco_computed. auto.
    + exists triangulo_eliminado. do 6 right. apply Eliminar_Triangulo_computed. auto.
Qed.

(** Each operation of one type is an instance of the general one, up to the answer. *)
Theorem specific_is_general s s' e t r_out c r d h k abc :
  (Agregar_Esfera s s' e t r_out c r \/ Agregar_Cilindro s s' e t r_out c r d h
   \/ Agregar_Cono s s' e t r_out c k d h \/ Agregar_Tronco s s' e t r_out c r k d h
   \/ Agregar_Plano s s' e t r_out c d \/ Agregar_Disco s s' e t r_out c r d
   \/ Agregar_Triangulo s s' e t r_out abc ->
   Elemento_Agregado s s' e t c r d h k abc elemento_agregado)
  /\ (Eliminar_Esfera s s' e r_out \/ Eliminar_Cilindro s s' e r_out \/ Eliminar_Cono s s' e r_out
      \/ Eliminar_Tronco s s' e r_out \/ Eliminar_Plano s s' e r_out \/ Eliminar_Disco s s' e r_out
      \/ Eliminar_Triangulo s s' e r_out -> Elemento_Eliminado s s' e elemento_eliminado).
Proof. split; intros H; (split; [now exists r_out | reflexivity]). Qed.

(** The general operations determine the scene: two after-states are equal. *)
Theorem operations_deterministic s s1 s2 e t c r d h k abc r1 r2 :
  (Elemento_Agregado s s1 e t c r d h k abc r1 -> Elemento_Agregado s s2 e t c r d h k abc r2 -> Escena_eq s1 s2)
  /\ (Elemento_Eliminado s s1 e r1 -> Elemento_Eliminado s s2 e r2 -> Escena_eq s1 s2).
Proof.
  split; intros H1 H2.
  - apply Elemento_Agregado_computed in H1 as [_ [H1 _]], H2 as [_ [H2 _]]. eauto using Escena_eq_trans, Escena_eq_sym.
  - apply Elemento_Eliminado_computed in H1 as [_ [H1 _]], H2 as [_ [H2 _]]. eauto using Escena_eq_trans, Escena_eq_sym.
Qed.

(** What stays is as it was. *)
Lemma Xi_refl s : Escena_ok s -> Xi_Escena s s.
Proof. intros ok. split; [now split | apply Escena_eq_refl]. Qed.
End Operaciones.
