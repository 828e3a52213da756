(** spec/historia.tex: each operation on elements has an operation that undoes it.

    values f e           == the values of e in f: one, or none *)
From Coq Require Import Reals Setoid Classical_Prop.
From Durero Require Import Toolkit Especificacion Escena Operaciones Edits Malla Cambios Changes.
From Durero Require Meshes.
Local Open Scope zed_scope.

Definition values {X Y} (f : rel X Y) (e : X) : set Y := fun v => f (e, v).
Lemma values_one {X Y} (f : rel X Y) e v : functional f -> (e, v) ∈ f -> values f e ≡ ⦃v⦄.
Proof. intros Ff H w. split; [intros Hw; exact (Ff _ _ _ Hw H) | now intros ->]. Qed.
Lemma values_none {X Y} (f : rel X Y) e : e ∉ dom f -> values f e ≡ ∅.
Proof. intros N v. split; [intros H; destruct N; now exists v | intros []]. Qed.
(** The values of an element that were taken from a function are put back. *)
Lemma taken_and_back {X Y} (f : rel X Y) e vs : values f e ≡ vs -> ndres ⦃e⦄ f ∪ at_one e vs ≡ f.
Proof.
  intros E [x y]. unfold union, ndres, at_one, single. cbn. split.
  - intros [[_ H] | [-> H]]; [exact H | now apply E].
  - intros H. destruct (classic (x = e)) as [-> | N]; [right | left]; (split; [easy |]); [now apply E | exact H].
Qed.

Section Inverses.
Context {Elemento : Type}.
Notation Escena := (Especificacion.Escena Elemento).
Implicit Types (s : Escena) (e : Elemento) (c : Punto) (rad h k : R) (d : Vector) (abc : Terna) (r_out : Respuesta).
Notation scene_with := (Operaciones.scene_with Elemento).
Notation scene_without := (Operaciones.scene_without Elemento).
Notation scene_added := (Operaciones.scene_added Elemento).
Notation addition_possible := (Operaciones.addition_possible Elemento).
Notation Elemento_Agregado_computed := (Operaciones.Elemento_Agregado_computed Elemento).
Notation Elemento_Eliminado_computed := (Operaciones.Elemento_Eliminado_computed Elemento).

(** ** An addition and a removal *)

(** Discharges Elemento_Agregado.conj.1. *)
Theorem an_addition_is_undone_by_a_removal : @Elemento_Agregado_conj_1 Elemento.
Proof.
  intros s s' e t c rad d h k abc r_out H. destruct (add_then_remove _ _ _ _ _ _ _ _ _ _ _ _ H) as [[s2 [r2 H2]] Same].
  exists elemento_eliminado. pose proof (Same _ _ H2) as E. apply Elemento_Eliminado_computed in H2 as [P [E2 _]].
  apply Elemento_Eliminado_computed. split; [exact P | split; [| reflexivity]].
  apply Escena_eq_trans with (1 := E2). now apply Escena_eq_sym.
Qed.

Lemma scene_with_eq s s' e t cs rs ds hs ks vs : Escena_eq s s' ->
  Escena_eq (scene_with s e t cs rs ds hs ks vs) (scene_with s' e t cs rs ds hs ks vs).
Proof. intros [H1 H2 H3 H4 H5 H6 H7 H8 H9]. split; cbn; now rewrite ?H1, ?H3, ?H4, ?H5, ?H6, ?H7, ?H8, ?H9. Qed.

(** An element that is taken away is put back with the values that it had. *)
Lemma scene_without_with s e t cs rs ds hs ks vs : Escena_ok s -> (e, t) ∈ de_que_tipo s ->
  values (mi_centro s) e ≡ cs -> values (mi_radio s) e ≡ rs -> values (mi_vector s) e ≡ ds ->
  values (mi_altura s) e ≡ hs -> values (mi_proporcion s) e ≡ ks -> values (mi_vertices s) e ≡ vs ->
  Escena_eq (scene_with (scene_without s e) e t cs rs ds hs ks vs) s.
Proof.
  intros ok Ht C R D H K V.
  assert (T : ndres ⦃e⦄ (de_que_tipo s) ∪ ⦃(e, t)⦄ ≡ de_que_tipo s).
  { rewrite <- at_one_single. apply taken_and_back, values_one; [apply (Escena_decl_de_que_tipo ok) | exact Ht]. }
  split; cbn; rewrite ?T; symmetry; try (now apply taken_and_back).
  - intros x. unfold union, diff, single. split.
    + intros [[Hx _] | ->]; [exact Hx | now apply (element_of_type _ _ ok e t)].
    + intros Hx. destruct (classic (x = e)); [now right | now left].
  - symmetry. apply (Escena_inv_7 ok).
  - reflexivity.
Qed.

(** An attribute of e: its value, where one is known, or that its type has none. *)
Ltac attribute ok Ht := first [apply values_one; [apply ok | assumption] | apply values_none; first
  [rewrite (has_centro _ _ ok _ _ Ht) | rewrite (has_radio _ _ ok _ _ Ht) | rewrite (has_vector _ _ ok _ _ Ht)
  | rewrite (has_altura _ _ ok _ _ Ht) | rewrite (has_proporcion _ _ ok _ _ Ht) | rewrite (has_vertices _ _ ok _ _ Ht)];
  cbv; intuition discriminate].
Ltac put_back ok Ht := split; [exact Ht |];
  split; [repeat (split; try assumption) | apply scene_without_with; auto; attribute ok Ht].

(** An element of whichever type is put back by an addition. *)
Lemma scene_without_added s e : Escena_ok s -> e ∈ elementos s -> exists t c rad d h k abc,
  (e, t) ∈ de_que_tipo s /\ addition_possible (scene_without s e) e t rad d h k abc
  /\ Escena_eq (scene_added (scene_without s e) e t c rad d h k abc) s.
Proof.
  intros ok He. pose proof (scene_without_ok _ s e ok) as ok'.
  assert (Gone : e ∉ elementos (scene_without s e)) by (intros [_ N]; now apply N).
  set (p := mk_Punto 0 0 0). set (n := mk_Vector 0 0 0). set (w := mk_Terna p p p).
  destruct (element_cases _ _ ok e He) as [H | [H | [H | [H | [H | [H | H]]]]]].
  - destruct H as (c & r & (Ht & Hc & Hr) & R). exists soy_esfera, c, r, n, 0%R, 0%R, w. put_back ok Ht.
  - destruct H as (c & r & d & h & (Ht & Hc & Hr & Hd & Hh) & R & D & Hx).
    exists soy_cilindro, c, r, d, h, 0%R, w. put_back ok Ht.
  - destruct H as (c & k & d & h & (Ht & Hc & Hk & Hd & Hh) & K & D & Hx).
    exists soy_cono, c, 0%R, d, h, k, w. put_back ok Ht.
  - destruct H as (c & r & k & d & h & (Ht & Hc & Hr & Hk & Hd & Hh) & R & K & D & Hx).
    exists soy_tronco, c, r, d, h, k, w. put_back ok Ht.
  - destruct H as (c & d & (Ht & Hc & Hd) & D). exists soy_plano, c, 0%R, d, 0%R, 0%R, w. put_back ok Ht.
  - destruct H as (c & r & d & (Ht & Hc & Hr & Hd) & R & D). exists soy_disco, c, r, d, 0%R, 0%R, w. put_back ok Ht.
  - destruct H as (abc & (Ht & Hv) & V). exists soy_triangulo, p, 0%R, n, 0%R, 0%R, abc. put_back ok Ht.
Qed.

Lemma scene_added_eq s s' e t c rad d h k abc : Escena_eq s s' ->
  Escena_eq (scene_added s e t c rad d h k abc) (scene_added s' e t c rad d h k abc).
Proof. intros E. destruct t; now apply scene_with_eq. Qed.
Lemma addition_possible_eq s s' e t rad d h k abc : Escena_eq s s' ->
  addition_possible s e t rad d h k abc -> addition_possible s' e t rad d h k abc.
Proof.
  intros E [ok [He H]]. split; [now apply Escena_ok_eq with (1 := E) | split; [| exact H]].
  intros H'. now apply He, (Escena_eq_elementos E).
Qed.

(** Discharges Elemento_Eliminado.conj.1. *)
Theorem a_removal_is_undone_by_an_addition : @Elemento_Eliminado_conj_1 Elemento.
Proof.
  intros s s' e r_out H. apply Elemento_Eliminado_computed in H as [[ok He] [E _]].
  destruct (scene_without_added s e ok He) as (t & c & rad & d & h & k & abc & Ht & P & Back).
  exists t. split; [exact Ht |]. exists c, rad, d, h, k, abc, elemento_agregado. apply Elemento_Agregado_computed.
  split; [now apply addition_possible_eq with (1 := E) | split; [| reflexivity]].
  apply Escena_eq_trans with (2 := Back). now apply scene_added_eq, Escena_eq_sym.
Qed.

(** Discharges Eliminar_Esfera.conj.1. *)
Theorem a_sphere_is_put_back_as_it_was : @Eliminar_Esfera_conj_1 Elemento.
Proof.
  intros s s' e r_out H. apply Eliminar_Esfera_computed in H as [[ok Ht] [E _]].
  destruct (proj2 (has_centro _ _ ok _ _ Ht) ltac:(cbv; tauto)) as [c Hc].
  destruct (proj2 (has_radio _ _ ok _ _ Ht) ltac:(cbv; tauto)) as [rad Hr].
  exists c, rad. split; [exact Hc | split; [exact Hr |]]. exists soy_esfera, esfera_agregada.
  apply Agregar_Esfera_computed. split; [| split; [| reflexivity]].
  - split; [now apply Escena_ok_eq with (1 := E), scene_without_ok |]. split; [| split; [reflexivity |]].
    + intros H. apply (Escena_eq_elementos E) in H. now apply H.
    + apply (Escena_decl_mi_radio ok). now exists e.
  - apply Escena_eq_trans with (with_esfera Elemento (scene_without s e) e c rad).
    + now apply scene_with_eq, Escena_eq_sym.
    + apply scene_without_with; auto; attribute ok Ht.
Qed.

(** ** The changes *)

(** A change gives the element another value; the change to the one before gives that back. *)
Ltac changed_domain E w := exists w; destruct E; cbn in *;
  lazymatch goal with Q : ?f ≡ _ |- ?f _ => apply Q; left; now split end.
Ltac changed_back E ok Hv := eapply Escena_eq_trans; [apply scene_changed_eq, Escena_eq_sym, E |];
  split; cbn; rewrite ?oplus_none; try reflexivity; symmetry; apply oplus_back; [apply ok | exact Hv].

(** Discharges Cambiar_Centro.conj.1. *)
Theorem a_change_of_centre_is_undone : @Cambiar_Centro_conj_1 Elemento.
Proof.
  intros s s' e r_out w H. pose proof H as P. apply Cambiar_Centro_computed in P as [[ok [He C]] [E _]].
  destruct C as [v Hv]. exists v. split; [exact Hv |]. exists elemento_cambiado.
  apply Cambiar_Centro_computed. split; [| split; [| reflexivity]].
  - split; [apply H | split; [now apply (Escena_eq_elementos E) |]].
    changed_domain E w.
  - changed_back E ok Hv.
Qed.
(** Discharges Cambiar_Radio.conj.1. *)
Theorem a_change_of_radius_is_undone : @Cambiar_Radio_conj_1 Elemento.
Proof.
  intros s s' e r_out w H. pose proof H as P. apply Cambiar_Radio_computed in P as [[ok [He C]] [E _]].
  destruct (proj1 C) as [v Hv]. exists v. split; [exact Hv |]. exists elemento_cambiado.
  apply Cambiar_Radio_computed. split; [| split; [| reflexivity]].
  - split; [apply H | split; [now apply (Escena_eq_elementos E) |]].
    split; [changed_domain E w | apply (Escena_decl_mi_radio ok); now exists e].
  - changed_back E ok Hv.
Qed.
(** Discharges Cambiar_Vector.conj.1. *)
Theorem a_change_of_axis_is_undone : @Cambiar_Vector_conj_1 Elemento.
Proof.
  intros s s' e r_out w H. pose proof H as P. apply Cambiar_Vector_computed in P as [[ok [He C]] [E _]].
  destruct (proj1 C) as [v Hv]. exists v. split; [exact Hv |]. exists elemento_cambiado.
  apply Cambiar_Vector_computed. split; [| split; [| reflexivity]].
  - split; [apply H | split; [now apply (Escena_eq_elementos E) |]].
    split; [changed_domain E w | apply (Escena_inv_8 ok); now exists e].
  - changed_back E ok Hv.
Qed.
(** Discharges Cambiar_Altura.conj.1. *)
Theorem a_change_of_height_is_undone : @Cambiar_Altura_conj_1 Elemento.
Proof.
  intros s s' e r_out w H. pose proof H as P. apply Cambiar_Altura_computed in P as [[ok [He C]] [E _]].
  destruct (proj1 C) as [v Hv]. exists v. split; [exact Hv |]. exists elemento_cambiado.
  apply Cambiar_Altura_computed. split; [| split; [| reflexivity]].
  - split; [apply H | split; [now apply (Escena_eq_elementos E) |]].
    split; [changed_domain E w | apply (Escena_decl_mi_altura ok); now exists e].
  - changed_back E ok Hv.
Qed.
(** Discharges Cambiar_Proporcion.conj.1. *)
Theorem a_change_of_proportion_is_undone : @Cambiar_Proporcion_conj_1 Elemento.
Proof.
  intros s s' e r_out w H. pose proof H as P. apply Cambiar_Proporcion_computed in P as [[ok [He C]] [E _]].
  destruct (proj1 C) as [v Hv]. exists v. split; [exact Hv |]. exists elemento_cambiado.
  apply Cambiar_Proporcion_computed. split; [| split; [| reflexivity]].
  - split; [apply H | split; [now apply (Escena_eq_elementos E) |]].
    split; [changed_domain E w | apply (Escena_decl_mi_proporcion ok); now exists e].
  - changed_back E ok Hv.
Qed.
(** Discharges Cambiar_Vertices.conj.1. *)
Theorem a_change_of_vertices_is_undone : @Cambiar_Vertices_conj_1 Elemento.
Proof.
  intros s s' e r_out w H. pose proof H as P. apply Cambiar_Vertices_computed in P as [[ok [He C]] [E _]].
  destruct (proj1 C) as [v Hv]. exists v. split; [exact Hv |]. exists elemento_cambiado.
  apply Cambiar_Vertices_computed. split; [| split; [| reflexivity]].
  - split; [apply H | split; [now apply (Escena_eq_elementos E) |]].
    split; [changed_domain E w | apply (Escena_decl_mi_vertices ok); now exists e].
  - changed_back E ok Hv.
Qed.
End Inverses.
