(** spec/operaciones.tex: what an edit leaves as it was.

    same_at x s s'       == the element x has the same type and attributes in s and s' *)
From Coq Require Import Reals Setoid Classical_Prop.
From Durero Require Import Toolkit Especificacion Escena Operaciones.
Local Open Scope zed_scope.

Section Edits.
Variable Elemento : Type.
Notation Escena := (Especificacion.Escena Elemento).
Implicit Types (s : Escena) (e : Elemento) (c : Punto) (d : Vector) (abc : Terna).
Notation scene_with := (scene_with Elemento).
Notation scene_without := (scene_without Elemento).
Notation with_esfera_ok := (with_esfera_ok Elemento).
Notation with_cilindro_ok := (with_cilindro_ok Elemento).
Notation with_cono_ok := (with_cono_ok Elemento).
Notation with_tronco_ok := (with_tronco_ok Elemento).
Notation with_plano_ok := (with_plano_ok Elemento).
Notation with_disco_ok := (with_disco_ok Elemento).
Notation with_triangulo_ok := (with_triangulo_ok Elemento).
Notation scene_added := (scene_added Elemento).
Notation Elemento_Agregado_computed := (Elemento_Agregado_computed Elemento).
Notation Elemento_Eliminado_computed := (Elemento_Eliminado_computed Elemento).

(** ** To add and then remove is the identity *)

Lemma scene_without_eq s s' e : Escena_eq s s' -> Escena_eq (scene_without s e) (scene_without s' e).
Proof. intros [H1 H2 H3 H4 H5 H6 H7 H8 H9]. split; cbn; now rewrite ?H1, ?H3, ?H4, ?H5, ?H6, ?H7, ?H8, ?H9. Qed.

Lemma scene_with_without s e t cs rs ds hs ks vs : Escena_ok s -> e ∉ elementos s ->
  Escena_eq (scene_without (scene_with s e t cs rs ds hs ks vs) e) s.
Proof.
  intros ok He.
  assert (T : ndres ⦃e⦄ (de_que_tipo s ∪ ⦃(e, t)⦄) ≡ de_que_tipo s).
  { rewrite <- at_one_single. apply ndres_union_at_one. now rewrite <- (Escena_inv_1 ok e). }
  split; cbn; rewrite ?T; symmetry; try (apply ndres_union_at_one); auto.
  - intros x. unfold diff, union, single. split; [tauto | intros H; split; [auto | congruence]].
  - symmetry. apply (Escena_inv_7 ok).
  - reflexivity.
  - intros H. now apply He, (element_of_centro _ _ ok).
  - intros H. now apply He, (element_of_radio _ _ ok).
  - intros H. now apply He, (element_of_vector _ _ ok).
  - intros H. now apply He, (element_of_altura _ _ ok).
  - intros H. now apply He, (element_of_proporcion _ _ ok).
  - intros H. now apply He, (element_of_vertices _ _ ok).
Qed.

(** An element that was added can be removed, and removing it gives the scene before. *)
Theorem add_then_remove s s1 e t c r d h k abc r1 : Elemento_Agregado s s1 e t c r d h k abc r1 ->
  (exists s2 r2, Elemento_Eliminado s1 s2 e r2)
  /\ forall s2 r2, Elemento_Eliminado s1 s2 e r2 -> Escena_eq s s2.
Proof.
  intros H. apply Elemento_Agregado_computed in H as [[ok [He H]] [E _]].
  assert (Ew : Escena_eq (scene_without s1 e) s).
  { apply Escena_eq_trans with (scene_without (scene_added s e t c r d h k abc) e).
    - now apply scene_without_eq, Escena_eq_sym.
    - destruct t; now apply scene_with_without. }
  split.
  - exists (scene_without s1 e), elemento_eliminado. apply Elemento_Eliminado_computed.
    split; [split | auto using Escena_eq_refl].
    + apply Escena_ok_eq with (1 := E). destruct t; cbn;
        [apply with_esfera_ok | apply with_cilindro_ok | apply with_cono_ok | apply with_tronco_ok
        | apply with_plano_ok | apply with_disco_ok | apply with_triangulo_ok]; tauto.
    + apply (Escena_eq_elementos E). destruct t; now right.
  - intros s2 r2 H2. apply Elemento_Eliminado_computed in H2 as [_ [E2 _]].
    eauto using Escena_eq_trans, Escena_eq_sym.
Qed.

(** ** An edit of one element leaves every other as it was *)

Definition same_at (x : Elemento) s s' : Prop :=
  (x ∈ elementos s <-> x ∈ elementos s')
  /\ (forall v, (x, v) ∈ de_que_tipo s <-> (x, v) ∈ de_que_tipo s')
  /\ (forall v, (x, v) ∈ mi_centro s <-> (x, v) ∈ mi_centro s')
  /\ (forall v, (x, v) ∈ mi_radio s <-> (x, v) ∈ mi_radio s')
  /\ (forall v, (x, v) ∈ mi_vector s <-> (x, v) ∈ mi_vector s')
  /\ (forall v, (x, v) ∈ mi_altura s <-> (x, v) ∈ mi_altura s')
  /\ (forall v, (x, v) ∈ mi_proporcion s <-> (x, v) ∈ mi_proporcion s')
  /\ (forall v, (x, v) ∈ mi_vertices s <-> (x, v) ∈ mi_vertices s').

Lemma same_at_eq x s s' s'' : same_at x s s' -> Escena_eq s' s'' -> same_at x s s''.
Proof.
  intros [H1 [H2 [H3 [H4 [H5 [H6 [H7 H8]]]]]]] [E1 _ E2 E3 E4 E5 E6 E7 E8].
  split; [now rewrite H1, (E1 x) |]. split; [intros v; now rewrite H2, (E2 (x, v)) |].
  split; [intros v; now rewrite H3, (E3 (x, v)) |]. split; [intros v; now rewrite H4, (E4 (x, v)) |].
  split; [intros v; now rewrite H5, (E5 (x, v)) |]. split; [intros v; now rewrite H6, (E6 (x, v)) |].
  split; [intros v; now rewrite H7, (E7 (x, v)) |]. intros v; now rewrite H8, (E8 (x, v)).
Qed.

Lemma scene_with_same x s e t cs rs ds hs ks vs : x <> e -> same_at x s (scene_with s e t cs rs ds hs ks vs).
Proof.
  intros Hx. unfold same_at; cbn; unfold union, single, at_one; cbn.
  repeat match goal with |- _ /\ _ => split end; intuition congruence.
Qed.
Lemma scene_without_same x s e : x <> e -> same_at x s (scene_without s e).
Proof.
  intros Hx. unfold same_at; cbn; unfold diff, ndres, single; cbn.
  repeat match goal with |- _ /\ _ => split end; intuition congruence.
Qed.

(** Adding or removing e changes neither the presence, nor the type, nor any attribute of another element x. *)
Theorem others_untouched x s s' e t c r d h k abc r_out : x <> e ->
  Elemento_Agregado s s' e t c r d h k abc r_out \/ Elemento_Eliminado s s' e r_out -> same_at x s s'.
Proof.
  intros Hx [H | H].
  - apply Elemento_Agregado_computed in H as [_ [E _]]. apply same_at_eq with (2 := E).
    destruct t; now apply scene_with_same.
  - apply Elemento_Eliminado_computed in H as [_ [E _]]. apply same_at_eq with (2 := E). now apply scene_without_same.
Qed.
End Edits.
