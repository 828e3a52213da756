(** spec/historia.tex: every change of an element has one possible after-state, which keeps the invariant, and its
    preconditions are the clauses stated in the text; every total change answers every call.

    scene_changed s e cs rs ds hs ks vs == s and the element e with the centre, radius, axis, height, proportion and
                            vertices that are the members of cs, rs, ds, hs, ks, vs; where a set has none, with its own
    with_centro, with_radio, with_vector, with_altura, with_proporcion, with_vertices == the same of one attribute
    may_be f e B vs      == vs is the value of e in a function f into B, or no value *)
From Coq Require Import Reals Setoid Morphisms Classical_Prop.
From Durero Require Import Toolkit Especificacion Escena Operaciones Edits Malla Cambios.
From Durero Require Meshes.
Local Open Scope zed_scope.

(** ** A function overridden at one element *)

Definition may_be {X Y} (f : rel X Y) (e : X) (B vs : set Y) : Prop :=
  at_most_one vs /\ vs ⊆ B /\ forall v, v ∈ vs -> e ∈ dom f.

Lemma may_be_none {X Y} (f : rel X Y) e B : may_be f e B ∅.
Proof. split; [apply empty_at_most_one | split; [intros v [] | intros v []]]. Qed.
Lemma may_be_one {X Y} (f : rel X Y) e (B : set Y) v : e ∈ dom f -> v ∈ B -> may_be f e B ⦃v⦄.
Proof. intros He Hv. split; [apply single_at_most_one | split; [intros w ->; exact Hv | intros w _; exact He]]. Qed.

Lemma oplus_one {X Y} (f : rel X Y) e v : oplus f (at_one e ⦃v⦄) ≡ oplus f ⦃(e, v)⦄.
Proof. apply Meshes.oplus_proper; [reflexivity |]. intros [x y]. unfold at_one, single. cbn. intuition congruence. Qed.
Lemma oplus_none {X Y} (f : rel X Y) e : oplus f (at_one e ∅) ≡ f.
Proof.
  intros [x y]. unfold oplus, at_one, empty, dom. cbn. split; [intros [[_ []] | [_ H]]; exact H |].
  intros H. right. split; [now intros [v [_ []]] | exact H].
Qed.
Lemma dom_oplus {X Y} (f : rel X Y) e B vs : may_be f e B vs -> dom (oplus f (at_one e vs)) ≡ dom f.
Proof.
  intros [_ [_ D]] x. split.
  - intros [y [[E H] | [_ H]]]; [cbn in *; subst; now apply (D y) | now exists y].
  - intros [y H]. destruct (classic (exists v, (x, v) ∈ at_one e vs)) as [[v Hv] | N]; [exists v; now left |].
    exists y. right. now split.
Qed.
Lemma pfun_oplus {X Y} (f : rel X Y) (B : set Y) e vs :
  f ∈ (univ ⇸ B) -> may_be f e B vs -> oplus f (at_one e vs) ∈ (univ ⇸ B).
Proof.
  intros [Hf [_ HB]] [H1 [Hvs _]]. split; [| split; [easy |]].
  - intros x y y' [[E H] | [N H]] [[E' H'] | [N' H']]; cbn in *.
    + exact (H1 _ _ H H').
    + destruct N'. now exists y.
    + destruct N. now exists y'.
    + exact (Hf _ _ _ H H').
  - intros y [x [[_ H] | [_ H]]]; [now apply Hvs | apply HB; now exists x].
Qed.
(** A value that is given back its place gives back the function. *)
Lemma oplus_back {X Y} (f : rel X Y) e v w : functional f -> (e, w) ∈ f ->
  oplus (oplus f (at_one e ⦃v⦄)) (at_one e ⦃w⦄) ≡ f.
Proof.
  intros Ff Hw [x y]. unfold oplus, at_one, single, dom. cbn. split.
  - intros [[-> ->] | [N [[-> ->] | [_ H]]]]; [exact Hw | | exact H]. destruct N. now exists w.
  - intros H. destruct (classic (x = e)) as [-> | N]; [left; split; [reflexivity | exact (Ff _ _ _ H Hw)] |].
    right. split; [intros [z [E _]]; contradiction |]. right. split; [intros [z [E _]]; contradiction | exact H].
Qed.

Section Changes.
Context {Elemento : Type}.
Notation Escena := (Especificacion.Escena Elemento).
Implicit Types (s : Escena) (e : Elemento) (c : Punto) (rad h k : R) (d : Vector) (abc : Terna) (r_out : Respuesta).

Definition scene_changed s e (cs : set Punto) (rs : set R) (ds : set Vector) (hs ks : set R) (vs : set Terna) :
  Escena := {|
  elementos := elementos s;
  tipos := tipos s;
  de_que_tipo := de_que_tipo s;
  mi_centro := oplus (mi_centro s) (at_one e cs);
  mi_radio := oplus (mi_radio s) (at_one e rs);
  mi_vector := oplus (mi_vector s) (at_one e ds);
  mi_altura := oplus (mi_altura s) (at_one e hs);
  mi_proporcion := oplus (mi_proporcion s) (at_one e ks);
  mi_vertices := oplus (mi_vertices s) (at_one e vs)
|}.
Definition with_centro s e c : Escena := scene_changed s e ⦃c⦄ ∅ ∅ ∅ ∅ ∅.
Definition with_radio s e rad : Escena := scene_changed s e ∅ ⦃rad⦄ ∅ ∅ ∅ ∅.
Definition with_vector s e d : Escena := scene_changed s e ∅ ∅ ⦃d⦄ ∅ ∅ ∅.
Definition with_altura s e h : Escena := scene_changed s e ∅ ∅ ∅ ⦃h⦄ ∅ ∅.
Definition with_proporcion s e k : Escena := scene_changed s e ∅ ∅ ∅ ∅ ⦃k⦄ ∅.
Definition with_vertices s e abc : Escena := scene_changed s e ∅ ∅ ∅ ∅ ∅ ⦃abc⦄.

(** A scene that is changed satisfies the invariant. *)
Lemma scene_changed_ok s e cs rs ds hs ks vs : Escena_ok s ->
  may_be (mi_centro s) e univ cs -> may_be (mi_radio s) e Rmas rs -> may_be (mi_vector s) e Unitario ds ->
  may_be (mi_altura s) e Rmas hs -> may_be (mi_proporcion s) e Rmas ks -> may_be (mi_vertices s) e Vertices vs ->
  Escena_ok (scene_changed s e cs rs ds hs ks vs).
Proof.
  intros ok C R D H K V. split; cbn; try (apply ok).
  - apply pfun_oplus; [apply ok | exact C].
  - apply pfun_oplus; [apply ok | exact R].
  - apply pfun_oplus; [apply ok |]. destruct D as [D1 [_ D2]]. now split.
  - apply pfun_oplus; [apply ok | exact H].
  - apply pfun_oplus; [apply ok | exact K].
  - apply pfun_oplus; [apply ok | exact V].
  - rewrite (dom_oplus _ _ _ _ C). apply ok.
  - rewrite (dom_oplus _ _ _ _ R). apply ok.
  - rewrite (dom_oplus _ _ _ _ D). apply ok.
  - rewrite (dom_oplus _ _ _ _ H). apply ok.
  - rewrite (dom_oplus _ _ _ _ K). apply ok.
  - intros d [x [[_ Hd] | [_ Hd]]]; [now apply D | apply (Escena_inv_8 ok); now exists x].
  - rewrite (dom_oplus _ _ _ _ V). apply ok.
Qed.
Lemma scene_changed_eq s s' e cs rs ds hs ks vs : Escena_eq s s' ->
  Escena_eq (scene_changed s e cs rs ds hs ks vs) (scene_changed s' e cs rs ds hs ks vs).
Proof. intros [H1 H2 H3 H4 H5 H6 H7 H8 H9]. split; cbn; now rewrite ?H1, ?H2, ?H3, ?H4, ?H5, ?H6, ?H7, ?H8, ?H9. Qed.

Ltac one_changed := intros; apply scene_changed_ok; auto using may_be_none, may_be_one; apply may_be_one; easy.
Lemma with_centro_ok s e c :
  Escena_ok s -> e ∈ dom (mi_centro s) -> Escena_ok (with_centro s e c).
Proof. one_changed. Qed.
Lemma with_radio_ok s e rad :
  Escena_ok s -> e ∈ dom (mi_radio s) -> rad ∈ Rmas -> Escena_ok (with_radio s e rad).
Proof. one_changed. Qed.
Lemma with_vector_ok s e d :
  Escena_ok s -> e ∈ dom (mi_vector s) -> d ∈ Unitario -> Escena_ok (with_vector s e d).
Proof. one_changed. Qed.
Lemma with_altura_ok s e h :
  Escena_ok s -> e ∈ dom (mi_altura s) -> h ∈ Rmas -> Escena_ok (with_altura s e h).
Proof. one_changed. Qed.
Lemma with_proporcion_ok s e k :
  Escena_ok s -> e ∈ dom (mi_proporcion s) -> k ∈ Rmas -> Escena_ok (with_proporcion s e k).
Proof. one_changed. Qed.
Lemma with_vertices_ok s e abc :
  Escena_ok s -> e ∈ dom (mi_vertices s) -> abc ∈ Vertices -> Escena_ok (with_vertices s e abc).
Proof. one_changed. Qed.

(** ** Each change, computed: its preconditions, its only after-state and its answer *)

Ltac change_computed with_ok := split;
  [ let ok' := fresh "ok" in let P2 := fresh "P" in intros [[[? ok'] ? ? P2]]; subst;
    split; [tauto | split; [split; cbn; rewrite ?oplus_one, ?oplus_none; auto | reflexivity]];
    now apply tipos_follow
  | let C := fresh "C" in let E := fresh "E" in intros [C [E ->]]; decompose [and] C;
    pose proof (Escena_ok_eq _ _ _ E ltac:(apply with_ok; assumption)); destruct E; cbn in *;
    rewrite ?oplus_one, ?oplus_none in *; do 3 (split; auto) ].

(** Cambiar_Centro happens exactly on an element that has the attribute; it has another centre, then, and nothing else
    is changed. Discharges Cambiar_Elemento.pre.1, Cambiar_Elemento.post.1, Cambiar_Elemento.post.2,
    Cambiar_Elemento.post.3, Cambiar_Centro.pre.1, Cambiar_Centro.post.1, Cambiar_Centro.post.2,
    Cambiar_Centro.post.3, Cambiar_Centro.post.4, Cambiar_Centro.post.5, Cambiar_Centro.post.6. *)
Theorem Cambiar_Centro_computed s s' e r_out c : Cambiar_Centro s s' e r_out c <->
  (Escena_ok s /\ e ∈ elementos s /\ e ∈ dom (mi_centro s))
  /\ Escena_eq (with_centro s e c) s' /\ r_out = elemento_cambiado.
Proof. change_computed with_centro_ok. Qed.

(** Cambiar_Radio happens exactly on an element that has the attribute; it has another radius, which is positive,
    then, and nothing else is changed. Discharges Cambiar_Radio.pre.1, Cambiar_Radio.pre.2, Cambiar_Radio.post.1,
    Cambiar_Radio.post.2, Cambiar_Radio.post.3, Cambiar_Radio.post.4, Cambiar_Radio.post.5, Cambiar_Radio.post.6. *)
Theorem Cambiar_Radio_computed s s' e r_out rad : Cambiar_Radio s s' e r_out rad <->
  (Escena_ok s /\ e ∈ elementos s /\ e ∈ dom (mi_radio s) /\ rad ∈ Rmas)
  /\ Escena_eq (with_radio s e rad) s' /\ r_out = elemento_cambiado.
Proof. change_computed with_radio_ok. Qed.

(** Cambiar_Vector happens exactly on an element that has the attribute; it has another axis, which is a unit vector,
    then, and nothing else is changed. Discharges Cambiar_Vector.pre.1, Cambiar_Vector.pre.2, Cambiar_Vector.post.1,
    Cambiar_Vector.post.2, Cambiar_Vector.post.3, Cambiar_Vector.post.4, Cambiar_Vector.post.5,
    Cambiar_Vector.post.6. *)
Theorem Cambiar_Vector_computed s s' e r_out d : Cambiar_Vector s s' e r_out d <->
  (Escena_ok s /\ e ∈ elementos s /\ e ∈ dom (mi_vector s) /\ d ∈ Unitario)
  /\ Escena_eq (with_vector s e d) s' /\ r_out = elemento_cambiado.
Proof. change_computed with_vector_ok. Qed.

(** Cambiar_Altura happens exactly on an element that has the attribute; it has another height, which is positive,
    then, and nothing else is changed. Discharges Cambiar_Altura.pre.1, Cambiar_Altura.pre.2, Cambiar_Altura.post.1,
    Cambiar_Altura.post.2, Cambiar_Altura.post.3, Cambiar_Altura.post.4, Cambiar_Altura.post.5,
    Cambiar_Altura.post.6. *)
Theorem Cambiar_Altura_computed s s' e r_out h : Cambiar_Altura s s' e r_out h <->
  (Escena_ok s /\ e ∈ elementos s /\ e ∈ dom (mi_altura s) /\ h ∈ Rmas)
  /\ Escena_eq (with_altura s e h) s' /\ r_out = elemento_cambiado.
Proof. change_computed with_altura_ok. Qed.

(** Cambiar_Proporcion happens exactly on an element that has the attribute; it has another proportion, which is
    positive, then, and nothing else is changed. Discharges Cambiar_Proporcion.pre.1, Cambiar_Proporcion.pre.2,
    Cambiar_Proporcion.post.1, Cambiar_Proporcion.post.2, Cambiar_Proporcion.post.3, Cambiar_Proporcion.post.4,
    Cambiar_Proporcion.post.5, Cambiar_Proporcion.post.6. *)
Theorem Cambiar_Proporcion_computed s s' e r_out k : Cambiar_Proporcion s s' e r_out k <->
  (Escena_ok s /\ e ∈ elementos s /\ e ∈ dom (mi_proporcion s) /\ k ∈ Rmas)
  /\ Escena_eq (with_proporcion s e k) s' /\ r_out = elemento_cambiado.
Proof. change_computed with_proporcion_ok. Qed.

(** Cambiar_Vertices happens exactly on an element that has the attribute; it has other vertices, which are not
    aligned, then, and nothing else is changed. Discharges Cambiar_Vertices.pre.1, Cambiar_Vertices.pre.2,
    Cambiar_Vertices.post.1, Cambiar_Vertices.post.2, Cambiar_Vertices.post.3, Cambiar_Vertices.post.4,
    Cambiar_Vertices.post.5, Cambiar_Vertices.post.6. *)
Theorem Cambiar_Vertices_computed s s' e r_out abc : Cambiar_Vertices s s' e r_out abc <->
  (Escena_ok s /\ e ∈ elementos s /\ e ∈ dom (mi_vertices s) /\ abc ∈ Vertices)
  /\ Escena_eq (with_vertices s e abc) s' /\ r_out = elemento_cambiado.
Proof. change_computed with_vertices_ok. Qed.

(** ** The preconditions are the stated clauses, and nothing more *)

Ltac clauses_of_change computed := split;
  [ let H := fresh in intros [? [? H]]; now apply computed in H
  | intros ?; do 2 eexists; apply computed; split; [eassumption | split; [apply Escena_eq_refl | reflexivity]] ].

(** pre of each change is exactly its stated clauses. *)
Theorem pre_of_changes s e c rad d h k abc :
  ((exists s' r_out, Cambiar_Centro s s' e r_out c) <->
    Escena_ok s /\ e ∈ elementos s /\ e ∈ dom (mi_centro s))
  /\ ((exists s' r_out, Cambiar_Radio s s' e r_out rad) <->
    Escena_ok s /\ e ∈ elementos s /\ e ∈ dom (mi_radio s) /\ rad ∈ Rmas)
  /\ ((exists s' r_out, Cambiar_Vector s s' e r_out d) <->
    Escena_ok s /\ e ∈ elementos s /\ e ∈ dom (mi_vector s) /\ d ∈ Unitario)
  /\ ((exists s' r_out, Cambiar_Altura s s' e r_out h) <->
    Escena_ok s /\ e ∈ elementos s /\ e ∈ dom (mi_altura s) /\ h ∈ Rmas)
  /\ ((exists s' r_out, Cambiar_Proporcion s s' e r_out k) <->
    Escena_ok s /\ e ∈ elementos s /\ e ∈ dom (mi_proporcion s) /\ k ∈ Rmas)
  /\ ((exists s' r_out, Cambiar_Vertices s s' e r_out abc) <->
    Escena_ok s /\ e ∈ elementos s /\ e ∈ dom (mi_vertices s) /\ abc ∈ Vertices).
Proof.
  repeat match goal with |- _ /\ _ => split end.
  - clauses_of_change Cambiar_Centro_computed.
  - clauses_of_change Cambiar_Radio_computed.
  - clauses_of_change Cambiar_Vector_computed.
  - clauses_of_change Cambiar_Altura_computed.
  - clauses_of_change Cambiar_Proporcion_computed.
  - clauses_of_change Cambiar_Vertices_computed.
Qed.

(** ** Every total change answers every call *)

(** An operation that can happen does; else one of its errors is the answer, and the scene stays. *)
Ltac case_that_holds := first [split; solve [eauto] | left; case_that_holds | right; case_that_holds].
Ltac unless P := destruct (classic P);
  [| lazymatch goal with _ : Xi_Escena ?s ?s |- _ => exists s; eexists; case_that_holds end].
Ltac call := intros s e v ok; lazymatch goal with ok : Escena_ok ?s |- _ =>
  let X := fresh "X" in pose proof (Xi_refl _ s ok) as X; unless (e ∈ elementos s) end.
Ltac happens computed := do 2 eexists; left; apply computed; split; [auto | split; [apply Escena_eq_refl |
  reflexivity]].
Ltac of_type type := lazymatch goal with ok : Escena_ok ?s, He : elementos _ ?e |- _ =>
  let t := fresh "t" in let Ht := fresh "Ht" in
  destruct (type_of_element _ _ ok e He) as [t Ht]; unless (t = type); subst t end.
Ltac change_of_type has computed :=
  lazymatch goal with ok : Escena_ok _, He : elementos _ _, Ht : de_que_tipo _ _ |- _ =>
  split; [apply computed; split; [| split; [apply Escena_eq_refl | reflexivity]] | split; [exact ok | exact Ht]];
  split; [exact ok | split; [exact He |]]; pose proof (proj2 (has _ _ ok _ _ Ht) ltac:(cbv; tauto)); auto end.
Ltac happens_of_type has computed := do 2 eexists; left; change_of_type has computed.

(** Discharges Sin_Centro.pre.1, Sin_Centro.pre.2, Sin_Centro.post.1, Cambiar_Centro_Total.def.1,
    Cambiar_Centro_Total.conj.1. *)
Theorem Cambiar_Centro_Total_is_total : @Cambiar_Centro_Total_conj_1 Elemento.
Proof. call. unless (e ∈ dom (mi_centro s)). happens Cambiar_Centro_computed. Qed.
(** Discharges Sin_Radio.pre.1, Sin_Radio.pre.2, Sin_Radio.post.1, Cambiar_Radio_Total.def.1,
    Cambiar_Radio_Total.conj.1. *)
Theorem Cambiar_Radio_Total_is_total : @Cambiar_Radio_Total_conj_1 Elemento.
Proof. call. unless (e ∈ dom (mi_radio s)). unless (v ∈ Rmas). happens Cambiar_Radio_computed. Qed.
(** Discharges Sin_Vector.pre.1, Sin_Vector.pre.2, Sin_Vector.post.1, Cambiar_Vector_Total.def.1,
    Cambiar_Vector_Total.conj.1. *)
Theorem Cambiar_Vector_Total_is_total : @Cambiar_Vector_Total_conj_1 Elemento.
Proof. call. unless (e ∈ dom (mi_vector s)). unless (v ∈ Unitario). happens Cambiar_Vector_computed. Qed.
(** Discharges Sin_Altura.pre.1, Sin_Altura.pre.2, Sin_Altura.post.1, Cambiar_Altura_Total.def.1,
    Cambiar_Altura_Total.conj.1. *)
Theorem Cambiar_Altura_Total_is_total : @Cambiar_Altura_Total_conj_1 Elemento.
Proof. call. unless (e ∈ dom (mi_altura s)). unless (v ∈ Rmas). happens Cambiar_Altura_computed. Qed.
(** Discharges Sin_Proporcion.pre.1, Sin_Proporcion.pre.2, Sin_Proporcion.post.1, Cambiar_Proporcion_Total.def.1,
    Cambiar_Proporcion_Total.conj.1. *)
Theorem Cambiar_Proporcion_Total_is_total : @Cambiar_Proporcion_Total_conj_1 Elemento.
Proof. call. unless (e ∈ dom (mi_proporcion s)). unless (v ∈ Rmas). happens Cambiar_Proporcion_computed. Qed.
(** Discharges Sin_Vertices.pre.1, Sin_Vertices.pre.2, Sin_Vertices.post.1, Cambiar_Vertices_Total.def.1,
    Cambiar_Vertices_Total.conj.1. *)
Theorem Cambiar_Vertices_Total_is_total : @Cambiar_Vertices_Total_conj_1 Elemento.
Proof. call. unless (e ∈ dom (mi_vertices s)). unless (v ∈ Vertices). happens Cambiar_Vertices_computed. Qed.

(** Discharges Es_Esfera.pre.1, Cambiar_Centro_Esfera.def.1, Cambiar_Centro_Esfera_Total.def.1,
    Cambiar_Centro_Esfera_Total.conj.1. *)
Theorem Cambiar_Centro_Esfera_Total_is_total : @Cambiar_Centro_Esfera_Total_conj_1 Elemento.
Proof. call. of_type soy_esfera. happens_of_type has_centro Cambiar_Centro_computed. Qed.
(** Discharges Cambiar_Radio_Esfera.def.1, Cambiar_Radio_Esfera_Total.def.1, Cambiar_Radio_Esfera_Total.conj.1. *)
Theorem Cambiar_Radio_Esfera_Total_is_total : @Cambiar_Radio_Esfera_Total_conj_1 Elemento.
Proof. call. of_type soy_esfera. unless (v ∈ Rmas). happens_of_type has_radio Cambiar_Radio_computed. Qed.
(** Discharges Es_Cilindro.pre.1, Cambiar_Centro_Cilindro.def.1, Cambiar_Centro_Cilindro_Total.def.1,
    Cambiar_Centro_Cilindro_Total.conj.1. *)
Theorem Cambiar_Centro_Cilindro_Total_is_total : @Cambiar_Centro_Cilindro_Total_conj_1 Elemento.
Proof. call. of_type soy_cilindro. happens_of_type has_centro Cambiar_Centro_computed. Qed.
(** Discharges Cambiar_Radio_Cilindro.def.1, Cambiar_Radio_Cilindro_Total.def.1,
    Cambiar_Radio_Cilindro_Total.conj.1. *)
Theorem Cambiar_Radio_Cilindro_Total_is_total : @Cambiar_Radio_Cilindro_Total_conj_1 Elemento.
Proof. call. of_type soy_cilindro. unless (v ∈ Rmas). happens_of_type has_radio Cambiar_Radio_computed. Qed.
(** Discharges Cambiar_Vector_Cilindro.def.1, Cambiar_Vector_Cilindro_Total.def.1,
    Cambiar_Vector_Cilindro_Total.conj.1. *)
Theorem Cambiar_Vector_Cilindro_Total_is_total : @Cambiar_Vector_Cilindro_Total_conj_1 Elemento.
Proof. call. of_type soy_cilindro. unless (v ∈ Unitario). happens_of_type has_vector Cambiar_Vector_computed. Qed.
(** Discharges Cambiar_Altura_Cilindro.def.1, Cambiar_Altura_Cilindro_Total.def.1,
    Cambiar_Altura_Cilindro_Total.conj.1. *)
Theorem Cambiar_Altura_Cilindro_Total_is_total : @Cambiar_Altura_Cilindro_Total_conj_1 Elemento.
Proof. call. of_type soy_cilindro. unless (v ∈ Rmas). happens_of_type has_altura Cambiar_Altura_computed. Qed.
(** Discharges Es_Cono.pre.1, Cambiar_Centro_Cono.def.1, Cambiar_Centro_Cono_Total.def.1,
    Cambiar_Centro_Cono_Total.conj.1. *)
Theorem Cambiar_Centro_Cono_Total_is_total : @Cambiar_Centro_Cono_Total_conj_1 Elemento.
Proof. call. of_type soy_cono. happens_of_type has_centro Cambiar_Centro_computed. Qed.
(** Discharges Cambiar_Vector_Cono.def.1, Cambiar_Vector_Cono_Total.def.1, Cambiar_Vector_Cono_Total.conj.1. *)
Theorem Cambiar_Vector_Cono_Total_is_total : @Cambiar_Vector_Cono_Total_conj_1 Elemento.
Proof. call. of_type soy_cono. unless (v ∈ Unitario). happens_of_type has_vector Cambiar_Vector_computed. Qed.
(** Discharges Cambiar_Altura_Cono.def.1, Cambiar_Altura_Cono_Total.def.1, Cambiar_Altura_Cono_Total.conj.1. *)
Theorem Cambiar_Altura_Cono_Total_is_total : @Cambiar_Altura_Cono_Total_conj_1 Elemento.
Proof. call. of_type soy_cono. unless (v ∈ Rmas). happens_of_type has_altura Cambiar_Altura_computed. Qed.
(** Discharges Cambiar_Proporcion_Cono.def.1, Cambiar_Proporcion_Cono_Total.def.1,
    Cambiar_Proporcion_Cono_Total.conj.1. *)
Theorem Cambiar_Proporcion_Cono_Total_is_total : @Cambiar_Proporcion_Cono_Total_conj_1 Elemento.
Proof. call. of_type soy_cono. unless (v ∈ Rmas). happens_of_type has_proporcion Cambiar_Proporcion_computed. Qed.
(** Discharges Es_Tronco.pre.1, Cambiar_Centro_Tronco.def.1, Cambiar_Centro_Tronco_Total.def.1,
    Cambiar_Centro_Tronco_Total.conj.1. *)
Theorem Cambiar_Centro_Tronco_Total_is_total : @Cambiar_Centro_Tronco_Total_conj_1 Elemento.
Proof. call. of_type soy_tronco. happens_of_type has_centro Cambiar_Centro_computed. Qed.
(** Discharges Cambiar_Radio_Tronco.def.1, Cambiar_Radio_Tronco_Total.def.1, Cambiar_Radio_Tronco_Total.conj.1. *)
Theorem Cambiar_Radio_Tronco_Total_is_total : @Cambiar_Radio_Tronco_Total_conj_1 Elemento.
Proof. call. of_type soy_tronco. unless (v ∈ Rmas). happens_of_type has_radio Cambiar_Radio_computed. Qed.
(** Discharges Cambiar_Vector_Tronco.def.1, Cambiar_Vector_Tronco_Total.def.1, Cambiar_Vector_Tronco_Total.conj.1. *)
Theorem Cambiar_Vector_Tronco_Total_is_total : @Cambiar_Vector_Tronco_Total_conj_1 Elemento.
Proof. call. of_type soy_tronco. unless (v ∈ Unitario). happens_of_type has_vector Cambiar_Vector_computed. Qed.
(** Discharges Cambiar_Altura_Tronco.def.1, Cambiar_Altura_Tronco_Total.def.1, Cambiar_Altura_Tronco_Total.conj.1. *)
Theorem Cambiar_Altura_Tronco_Total_is_total : @Cambiar_Altura_Tronco_Total_conj_1 Elemento.
Proof. call. of_type soy_tronco. unless (v ∈ Rmas). happens_of_type has_altura Cambiar_Altura_computed. Qed.
(** Discharges Cambiar_Proporcion_Tronco.def.1, Cambiar_Proporcion_Tronco_Total.def.1,
    Cambiar_Proporcion_Tronco_Total.conj.1. *)
Theorem Cambiar_Proporcion_Tronco_Total_is_total : @Cambiar_Proporcion_Tronco_Total_conj_1 Elemento.
Proof. call. of_type soy_tronco. unless (v ∈ Rmas). happens_of_type has_proporcion Cambiar_Proporcion_computed. Qed.
(** Discharges Es_Plano.pre.1, Cambiar_Centro_Plano.def.1, Cambiar_Centro_Plano_Total.def.1,
    Cambiar_Centro_Plano_Total.conj.1. *)
Theorem Cambiar_Centro_Plano_Total_is_total : @Cambiar_Centro_Plano_Total_conj_1 Elemento.
Proof. call. of_type soy_plano. happens_of_type has_centro Cambiar_Centro_computed. Qed.
(** Discharges Cambiar_Vector_Plano.def.1, Cambiar_Vector_Plano_Total.def.1, Cambiar_Vector_Plano_Total.conj.1. *)
Theorem Cambiar_Vector_Plano_Total_is_total : @Cambiar_Vector_Plano_Total_conj_1 Elemento.
Proof. call. of_type soy_plano. unless (v ∈ Unitario). happens_of_type has_vector Cambiar_Vector_computed. Qed.
(** Discharges Es_Disco.pre.1, Cambiar_Centro_Disco.def.1, Cambiar_Centro_Disco_Total.def.1,
    Cambiar_Centro_Disco_Total.conj.1. *)
Theorem Cambiar_Centro_Disco_Total_is_total : @Cambiar_Centro_Disco_Total_conj_1 Elemento.
Proof. call. of_type soy_disco. happens_of_type has_centro Cambiar_Centro_computed. Qed.
(** Discharges Cambiar_Radio_Disco.def.1, Cambiar_Radio_Disco_Total.def.1, Cambiar_Radio_Disco_Total.conj.1. *)
Theorem Cambiar_Radio_Disco_Total_is_total : @Cambiar_Radio_Disco_Total_conj_1 Elemento.
Proof. call. of_type soy_disco. unless (v ∈ Rmas). happens_of_type has_radio Cambiar_Radio_computed. Qed.
(** Discharges Cambiar_Vector_Disco.def.1, Cambiar_Vector_Disco_Total.def.1, Cambiar_Vector_Disco_Total.conj.1. *)
Theorem Cambiar_Vector_Disco_Total_is_total : @Cambiar_Vector_Disco_Total_conj_1 Elemento.
Proof. call. of_type soy_disco. unless (v ∈ Unitario). happens_of_type has_vector Cambiar_Vector_computed. Qed.
(** Discharges Es_Triangulo.pre.1, Cambiar_Vertices_Triangulo.def.1, Cambiar_Vertices_Triangulo_Total.def.1,
    Cambiar_Vertices_Triangulo_Total.conj.1. *)
Theorem Cambiar_Vertices_Triangulo_Total_is_total : @Cambiar_Vertices_Triangulo_Total_conj_1 Elemento.
Proof. call. of_type soy_triangulo. unless (v ∈ Vertices). happens_of_type has_vertices Cambiar_Vertices_computed. Qed.

(** pre of each change of one type is exactly that e is an element of the type, and that the value is in its range. *)
Ltac clauses_of_type has computed := split;
  [ intros [s' [r_out [H [ok T]]]]; apply computed in H; tauto
  | intros H; decompose [and] H; lazymatch goal with ok : Escena_ok _, Ht : de_que_tipo _ _ |- _ =>
    pose proof (element_of_type _ _ ok _ _ Ht); do 2 eexists; change_of_type has computed end ].
Theorem pre_of_changes_of_a_type s e c rad d h k abc :
  ((exists s' r_out, Cambiar_Centro_Esfera s s' e r_out c) <->
    Escena_ok s /\ (e, soy_esfera) ∈ de_que_tipo s)
  /\ ((exists s' r_out, Cambiar_Radio_Esfera s s' e r_out rad) <->
    Escena_ok s /\ (e, soy_esfera) ∈ de_que_tipo s /\ rad ∈ Rmas)
  /\ ((exists s' r_out, Cambiar_Centro_Cilindro s s' e r_out c) <->
    Escena_ok s /\ (e, soy_cilindro) ∈ de_que_tipo s)
  /\ ((exists s' r_out, Cambiar_Radio_Cilindro s s' e r_out rad) <->
    Escena_ok s /\ (e, soy_cilindro) ∈ de_que_tipo s /\ rad ∈ Rmas)
  /\ ((exists s' r_out, Cambiar_Vector_Cilindro s s' e r_out d) <->
    Escena_ok s /\ (e, soy_cilindro) ∈ de_que_tipo s /\ d ∈ Unitario)
  /\ ((exists s' r_out, Cambiar_Altura_Cilindro s s' e r_out h) <->
    Escena_ok s /\ (e, soy_cilindro) ∈ de_que_tipo s /\ h ∈ Rmas)
  /\ ((exists s' r_out, Cambiar_Centro_Cono s s' e r_out c) <->
    Escena_ok s /\ (e, soy_cono) ∈ de_que_tipo s)
  /\ ((exists s' r_out, Cambiar_Vector_Cono s s' e r_out d) <->
    Escena_ok s /\ (e, soy_cono) ∈ de_que_tipo s /\ d ∈ Unitario)
  /\ ((exists s' r_out, Cambiar_Altura_Cono s s' e r_out h) <->
    Escena_ok s /\ (e, soy_cono) ∈ de_que_tipo s /\ h ∈ Rmas)
  /\ ((exists s' r_out, Cambiar_Proporcion_Cono s s' e r_out k) <->
    Escena_ok s /\ (e, soy_cono) ∈ de_que_tipo s /\ k ∈ Rmas)
  /\ ((exists s' r_out, Cambiar_Centro_Tronco s s' e r_out c) <->
    Escena_ok s /\ (e, soy_tronco) ∈ de_que_tipo s)
  /\ ((exists s' r_out, Cambiar_Radio_Tronco s s' e r_out rad) <->
    Escena_ok s /\ (e, soy_tronco) ∈ de_que_tipo s /\ rad ∈ Rmas)
  /\ ((exists s' r_out, Cambiar_Vector_Tronco s s' e r_out d) <->
    Escena_ok s /\ (e, soy_tronco) ∈ de_que_tipo s /\ d ∈ Unitario)
  /\ ((exists s' r_out, Cambiar_Altura_Tronco s s' e r_out h) <->
    Escena_ok s /\ (e, soy_tronco) ∈ de_que_tipo s /\ h ∈ Rmas)
  /\ ((exists s' r_out, Cambiar_Proporcion_Tronco s s' e r_out k) <->
    Escena_ok s /\ (e, soy_tronco) ∈ de_que_tipo s /\ k ∈ Rmas)
  /\ ((exists s' r_out, Cambiar_Centro_Plano s s' e r_out c) <->
    Escena_ok s /\ (e, soy_plano) ∈ de_que_tipo s)
  /\ ((exists s' r_out, Cambiar_Vector_Plano s s' e r_out d) <->
    Escena_ok s /\ (e, soy_plano) ∈ de_que_tipo s /\ d ∈ Unitario)
  /\ ((exists s' r_out, Cambiar_Centro_Disco s s' e r_out c) <->
    Escena_ok s /\ (e, soy_disco) ∈ de_que_tipo s)
  /\ ((exists s' r_out, Cambiar_Radio_Disco s s' e r_out rad) <->
    Escena_ok s /\ (e, soy_disco) ∈ de_que_tipo s /\ rad ∈ Rmas)
  /\ ((exists s' r_out, Cambiar_Vector_Disco s s' e r_out d) <->
    Escena_ok s /\ (e, soy_disco) ∈ de_que_tipo s /\ d ∈ Unitario)
  /\ ((exists s' r_out, Cambiar_Vertices_Triangulo s s' e r_out abc) <->
    Escena_ok s /\ (e, soy_triangulo) ∈ de_que_tipo s /\ abc ∈ Vertices).
Proof.
  repeat match goal with |- _ /\ _ => split end.
  - clauses_of_type has_centro Cambiar_Centro_computed.
  - clauses_of_type has_radio Cambiar_Radio_computed.
  - clauses_of_type has_centro Cambiar_Centro_computed.
  - clauses_of_type has_radio Cambiar_Radio_computed.
  - clauses_of_type has_vector Cambiar_Vector_computed.
  - clauses_of_type has_altura Cambiar_Altura_computed.
  - clauses_of_type has_centro Cambiar_Centro_computed.
  - clauses_of_type has_vector Cambiar_Vector_computed.
  - clauses_of_type has_altura Cambiar_Altura_computed.
  - clauses_of_type has_proporcion Cambiar_Proporcion_computed.
  - clauses_of_type has_centro Cambiar_Centro_computed.
  - clauses_of_type has_radio Cambiar_Radio_computed.
  - clauses_of_type has_vector Cambiar_Vector_computed.
  - clauses_of_type has_altura Cambiar_Altura_computed.
  - clauses_of_type has_proporcion Cambiar_Proporcion_computed.
  - clauses_of_type has_centro Cambiar_Centro_computed.
  - clauses_of_type has_vector Cambiar_Vector_computed.
  - clauses_of_type has_centro Cambiar_Centro_computed.
  - clauses_of_type has_radio Cambiar_Radio_computed.
  - clauses_of_type has_vector Cambiar_Vector_computed.
  - clauses_of_type has_vertices Cambiar_Vertices_computed.
Qed.

(** ** A change of one element leaves every other as it was *)

Lemma oplus_other {Y} (f : rel Elemento Y) e vs x v : x <> e -> ((x, v) ∈ f <-> (x, v) ∈ oplus f (at_one e vs)).
Proof.
  intros N. unfold oplus, at_one, dom. cbn. split; [| intros [[E _] | [_ H]]; [contradiction | exact H]].
  intros H. right. split; [intros [w [E _]]; contradiction | exact H].
Qed.
Lemma scene_changed_same x s e cs rs ds hs ks vs : x <> e -> same_at _ x s (scene_changed s e cs rs ds hs ks vs).
Proof.
  intros N. unfold same_at. cbn.
  repeat match goal with |- _ /\ _ => split end; try reflexivity; intros v; now apply oplus_other.
Qed.
Theorem changes_touch_one_element x s s' e c rad d h k abc r_out : x <> e ->
  Cambiar_Centro s s' e r_out c \/ Cambiar_Radio s s' e r_out rad \/ Cambiar_Vector s s' e r_out d
  \/ Cambiar_Altura s s' e r_out h \/ Cambiar_Proporcion s s' e r_out k \/ Cambiar_Vertices s s' e r_out abc ->
  same_at _ x s s'.
Proof.
  intros N [H | [H | [H | [H | [H | H]]]]];
    [apply Cambiar_Centro_computed in H | apply Cambiar_Radio_computed in H | apply Cambiar_Vector_computed in H
    | apply Cambiar_Altura_computed in H | apply Cambiar_Proporcion_computed in H | apply Cambiar_Vertices_computed in H];
    destruct H as [_ [E _]]; apply same_at_eq with (2 := E); now apply scene_changed_same.
Qed.
End Changes.
