(** spec/tablas.tex: what scene the tables stand for, and that a row added is an element added.

    scene_of T           == the scene that T stands for
    tables_with          == the after-state of an addition *)
From Coq Require Import Reals List Lia Lra Arith Setoid Morphisms.
From Durero Require Import Toolkit Especificacion Escena Operaciones Tablas.
Local Open Scope zed_scope.

Section RowsAdded.
Context {Elemento : Type}.
Notation Escena := (Especificacion.Escena Elemento).
Notation Tablas := (Tablas Elemento).
Implicit Types (s : Escena) (e : Elemento) (T : Tablas).

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

(** Discharges Tablas.inv.2, Tablas.inv.3, Tablas.inv.4, Tablas.inv.5, Tablas.inv.6, Tablas.inv.7, Tablas.inv.8,
    Centros.def.1, Radios.def.1, Vectores.def.1, Alturas.def.1, Proporciones.def.1, Ternas.def.1. *)
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
Theorem the_index_knows_the_elements : @Retrieve_conj_3 Elemento.
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
Theorem tables_stand_for_one_scene : @Retrieve_conj_1 Elemento.
Proof.
  intros T ok. exists (scene_of T).
  assert (R : Retrieve (scene_of T) T) by (split; [now apply scene_of_ok | exact ok | reflexivity ..]).
  split; [exact R |]. intros s' R'. now apply (retrieved_equal _ T _ T).
Qed.
(** Discharges Retrieve.conj.2. *)
Theorem tables_that_stay_stand_for_a_scene_that_stays : @Retrieve_conj_2 Elemento.
Proof.
  intros s T s' T' R R' []. split; [split; [apply R | apply R'] |]. now apply (retrieved_equal _ T _ T').
Qed.

(** Discharges Init_Tablas.post.1, Init_Tablas.conj.1. *)
Theorem first_tables_stand_for_the_first_scene : @Init_Tablas_conj_1 Elemento.
Proof.
  intros T' [ok E]. destruct (tables_stand_for_one_scene T' ok) as [s [R _]]. exists s. split; [exact R |].
  split; [apply R |]. rewrite (the_index_knows_the_elements _ _ R), E. intros x. split; [now intros [p []] | intros []].
Qed.
(** Discharges Init_Tablas.conj.2. *)
Theorem first_tables_exist : @Init_Tablas_conj_2 Elemento.
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
    (apply tables_with_ok;
     lazymatch goal with
     | |- Tablas_ok _ => exact (Retrieve_Tablas _ _ R)
     | |- at_most_one _ => first [apply single_at_most_one | apply empty_at_most_one]
     | |- _ ⊆ _ => let v := fresh in intros v; first [now intros -> | now intros []]
     | |- _ <-> _ => first [apply exists_single; cbv; tauto | apply exists_empty; cbv; intuition discriminate]
     | |- _ => exact new
     end);
  exists after; eexists; hnf; repeat match goal with |- _ /\ _ => split end;
  lazymatch goal with
  | |- Agregar_Fila _ _ _ _ => exact (tables_with_Agregar_Fila T e _ (Retrieve_Tablas _ _ R) new _ _ _ _ _ _ K)
  | |- grown _ _ _ _ _ => apply row_grows
  | |- _ ≡ _ => apply at_one_empty
  | |- _ => first [assumption | reflexivity]
  end.
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
Theorem Agregar_Esfera_Tablas_applicable : @Agregar_Esfera_Tablas_conj_1 Elemento.
Proof.
  intros s T e t c r R H.
  applicable R H e T Agregar_Esfera_computed (tables_with T e soy_esfera ⦃c⦄ ⦃r⦄ ∅ ∅ ∅ ∅).
Qed.
(** Discharges Agregar_Esfera_Tablas.def.1, Agregar_Esfera_Tablas.conj.2. *)
Theorem Agregar_Esfera_Tablas_correct : @Agregar_Esfera_Tablas_conj_2 Elemento.
Proof.
  intros s T T' e t r_out c r R H.
  correct R H s e T (with_esfera _ s e c r) with_esfera_ok Agregar_Esfera_computed.
Qed.
(** Discharges Agregar_Cilindro_Tablas.conj.1. *)
Theorem Agregar_Cilindro_Tablas_applicable : @Agregar_Cilindro_Tablas_conj_1 Elemento.
Proof.
  intros s T e t c r d h R H.
  applicable R H e T Agregar_Cilindro_computed (tables_with T e soy_cilindro ⦃c⦄ ⦃r⦄ ⦃d⦄ ⦃h⦄ ∅ ∅).
Qed.
(** Discharges Agregar_Cilindro_Tablas.def.1, Agregar_Cilindro_Tablas.conj.2. *)
Theorem Agregar_Cilindro_Tablas_correct : @Agregar_Cilindro_Tablas_conj_2 Elemento.
Proof.
  intros s T T' e t r_out c r d h R H.
  correct R H s e T (with_cilindro _ s e c r d h) with_cilindro_ok Agregar_Cilindro_computed.
Qed.
(** Discharges Agregar_Cono_Tablas.conj.1. *)
Theorem Agregar_Cono_Tablas_applicable : @Agregar_Cono_Tablas_conj_1 Elemento.
Proof.
  intros s T e t c k d h R H.
  applicable R H e T Agregar_Cono_computed (tables_with T e soy_cono ⦃c⦄ ∅ ⦃d⦄ ⦃h⦄ ⦃k⦄ ∅).
Qed.
(** Discharges Agregar_Cono_Tablas.def.1, Agregar_Cono_Tablas.conj.2. *)
Theorem Agregar_Cono_Tablas_correct : @Agregar_Cono_Tablas_conj_2 Elemento.
Proof.
  intros s T T' e t r_out c k d h R H.
  correct R H s e T (with_cono _ s e c k d h) with_cono_ok Agregar_Cono_computed.
Qed.
(** Discharges Agregar_Tronco_Tablas.conj.1. *)
Theorem Agregar_Tronco_Tablas_applicable : @Agregar_Tronco_Tablas_conj_1 Elemento.
Proof.
  intros s T e t c r k d h R H.
  applicable R H e T Agregar_Tronco_computed (tables_with T e soy_tronco ⦃c⦄ ⦃r⦄ ⦃d⦄ ⦃h⦄ ⦃k⦄ ∅).
Qed.
(** Discharges Agregar_Tronco_Tablas.def.1, Agregar_Tronco_Tablas.conj.2. *)
Theorem Agregar_Tronco_Tablas_correct : @Agregar_Tronco_Tablas_conj_2 Elemento.
Proof.
  intros s T T' e t r_out c r k d h R H.
  correct R H s e T (with_tronco _ s e c r k d h) with_tronco_ok Agregar_Tronco_computed.
Qed.
(** Discharges Agregar_Plano_Tablas.conj.1. *)
Theorem Agregar_Plano_Tablas_applicable : @Agregar_Plano_Tablas_conj_1 Elemento.
Proof.
  intros s T e t c d R H.
  applicable R H e T Agregar_Plano_computed (tables_with T e soy_plano ⦃c⦄ ∅ ⦃d⦄ ∅ ∅ ∅).
Qed.
(** Discharges Agregar_Plano_Tablas.def.1, Agregar_Plano_Tablas.conj.2. *)
Theorem Agregar_Plano_Tablas_correct : @Agregar_Plano_Tablas_conj_2 Elemento.
Proof.
  intros s T T' e t r_out c d R H.
  correct R H s e T (with_plano _ s e c d) with_plano_ok Agregar_Plano_computed.
Qed.
(** Discharges Agregar_Disco_Tablas.conj.1. *)
Theorem Agregar_Disco_Tablas_applicable : @Agregar_Disco_Tablas_conj_1 Elemento.
Proof.
  intros s T e t c r d R H.
  applicable R H e T Agregar_Disco_computed (tables_with T e soy_disco ⦃c⦄ ⦃r⦄ ⦃d⦄ ∅ ∅ ∅).
Qed.
(** Discharges Agregar_Disco_Tablas.def.1, Agregar_Disco_Tablas.conj.2. *)
Theorem Agregar_Disco_Tablas_correct : @Agregar_Disco_Tablas_conj_2 Elemento.
Proof.
  intros s T T' e t r_out c r d R H.
  correct R H s e T (with_disco _ s e c r d) with_disco_ok Agregar_Disco_computed.
Qed.
(** Discharges Agregar_Triangulo_Tablas.conj.1. *)
Theorem Agregar_Triangulo_Tablas_applicable : @Agregar_Triangulo_Tablas_conj_1 Elemento.
Proof.
  intros s T e t abc R H.
  applicable R H e T Agregar_Triangulo_computed (tables_with T e soy_triangulo ∅ ∅ ∅ ∅ ∅ ⦃abc⦄).
Qed.
(** Discharges Agregar_Triangulo_Tablas.def.1, Agregar_Triangulo_Tablas.conj.2. *)
Theorem Agregar_Triangulo_Tablas_correct : @Agregar_Triangulo_Tablas_conj_2 Elemento.
Proof.
  intros s T T' e t r_out abc R H.
  correct R H s e T (with_triangulo _ s e abc) with_triangulo_ok Agregar_Triangulo_computed.
Qed.
End RowsAdded.
