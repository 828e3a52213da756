(** spec/tablas.tex: the last row moved into the gap is an element removed.

    tables_without       == the after-state of a removal *)
From Coq Require Import Reals List Lia Lra Arith Setoid Morphisms.
From Durero Require Import Toolkit Especificacion Escena Operaciones Tablas RowsAdded.
Local Open Scope zed_scope.

Section RowsRemoved.
Context {Elemento : Type}.
Notation Escena := (Especificacion.Escena Elemento).
Notation Tablas := (Tablas Elemento).
Implicit Types (s : Escena) (e : Elemento) (T : Tablas).

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
Theorem Eliminar_Esfera_Tablas_applicable : @Eliminar_Esfera_Tablas_conj_1 Elemento.
Proof. removable Eliminar_Esfera_computed. Qed.
(** Discharges Eliminar_Esfera_Tablas.def.1, Eliminar_Esfera_Tablas.conj.2. *)
Theorem Eliminar_Esfera_Tablas_correct : @Eliminar_Esfera_Tablas_conj_2 Elemento.
Proof. removed Eliminar_Esfera_computed. Qed.
(** Discharges Eliminar_Cilindro_Tablas.conj.1. *)
Theorem Eliminar_Cilindro_Tablas_applicable : @Eliminar_Cilindro_Tablas_conj_1 Elemento.
Proof. removable Eliminar_Cilindro_computed. Qed.
(** Discharges Eliminar_Cilindro_Tablas.def.1, Eliminar_Cilindro_Tablas.conj.2. *)
Theorem Eliminar_Cilindro_Tablas_correct : @Eliminar_Cilindro_Tablas_conj_2 Elemento.
Proof. removed Eliminar_Cilindro_computed. Qed.
(** Discharges Eliminar_Cono_Tablas.conj.1. *)
Theorem Eliminar_Cono_Tablas_applicable : @Eliminar_Cono_Tablas_conj_1 Elemento.
Proof. removable Eliminar_Cono_computed. Qed.
(** Discharges Eliminar_Cono_Tablas.def.1, Eliminar_Cono_Tablas.conj.2. *)
Theorem Eliminar_Cono_Tablas_correct : @Eliminar_Cono_Tablas_conj_2 Elemento.
Proof. removed Eliminar_Cono_computed. Qed.
(** Discharges Eliminar_Tronco_Tablas.conj.1. *)
Theorem Eliminar_Tronco_Tablas_applicable : @Eliminar_Tronco_Tablas_conj_1 Elemento.
Proof. removable Eliminar_Tronco_computed. Qed.
(** Discharges Eliminar_Tronco_Tablas.def.1, Eliminar_Tronco_Tablas.conj.2. *)
Theorem Eliminar_Tronco_Tablas_correct : @Eliminar_Tronco_Tablas_conj_2 Elemento.
Proof. removed Eliminar_Tronco_computed. Qed.
(** Discharges Eliminar_Plano_Tablas.conj.1. *)
Theorem Eliminar_Plano_Tablas_applicable : @Eliminar_Plano_Tablas_conj_1 Elemento.
Proof. removable Eliminar_Plano_computed. Qed.
(** Discharges Eliminar_Plano_Tablas.def.1, Eliminar_Plano_Tablas.conj.2. *)
Theorem Eliminar_Plano_Tablas_correct : @Eliminar_Plano_Tablas_conj_2 Elemento.
Proof. removed Eliminar_Plano_computed. Qed.
(** Discharges Eliminar_Disco_Tablas.conj.1. *)
Theorem Eliminar_Disco_Tablas_applicable : @Eliminar_Disco_Tablas_conj_1 Elemento.
Proof. removable Eliminar_Disco_computed. Qed.
(** Discharges Eliminar_Disco_Tablas.def.1, Eliminar_Disco_Tablas.conj.2. *)
Theorem Eliminar_Disco_Tablas_correct : @Eliminar_Disco_Tablas_conj_2 Elemento.
Proof. removed Eliminar_Disco_computed. Qed.
(** Discharges Eliminar_Triangulo_Tablas.conj.1. *)
Theorem Eliminar_Triangulo_Tablas_applicable : @Eliminar_Triangulo_Tablas_conj_1 Elemento.
Proof. removable Eliminar_Triangulo_computed. Qed.
(** Discharges Eliminar_Triangulo_Tablas.def.1, Eliminar_Triangulo_Tablas.conj.2. *)
Theorem Eliminar_Triangulo_Tablas_correct : @Eliminar_Triangulo_Tablas_conj_2 Elemento.
Proof. removed Eliminar_Triangulo_computed. Qed.
End RowsRemoved.
