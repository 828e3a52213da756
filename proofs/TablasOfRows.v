(** The lists of rows of Retrieve.v are the tables of spec/tablas.tex, and their operations the operations of that text.

    column T A           == what the rows have of an attribute, by their places
    tablas_of T          == the tables, as the text has them, that the lists and the index are
    texts_addition x     == what the text says of the addition of the row x;  texts_removal t likewise, of the type t *)
From Coq Require Import Reals List Lia Arith.
From Durero Require Import Toolkit Especificacion Escena Operaciones Tablas RowsAdded RowsRemoved.
From Durero Require Retrieve.
Import ListNotations.
Local Open Scope zed_scope.

Section TablasOfRows.
Variable Elemento : Type.
Hypothesis Elemento_dec : forall e e' : Elemento, {e = e'} + {e <> e'}.
Notation Tables := (Retrieve.Tables Elemento).
Notation tables_ok := (Retrieve.tables_ok Elemento).
Notation rows := (Retrieve.rows Elemento).
Notation index := (Retrieve.index Elemento).
Notation retrieve := (Retrieve.retrieve Elemento).
Notation add := (Retrieve.add Elemento Elemento_dec).
Notation remove := (Retrieve.remove Elemento Elemento_dec).
Notation row_at T p e x := (nth_error (rows T (fst p)) (snd p) = Some (e, x)).
Implicit Types (T : Tables) (e : Elemento) (x : Retrieve.Shape) (p q : Lugar).

Definition column {V} T (A : Retrieve.Shape -> set V) : rel Lugar V :=
  fun pv => exists e x, row_at T (fst pv) e x /\ A x (snd pv).
Definition tablas_of T : Tablas Elemento := {|
  lugar := fun ep => index T (fst ep) = Some (snd ep);
  cuantos := fun t => length (rows T t);
  nombres := fun pe => exists x, row_at T (fst pe) (snd pe) x;
  centros := column T Retrieve.centres;
  radios := column T Retrieve.radii;
  vectores := column T Retrieve.axes;
  alturas := column T Retrieve.heights;
  proporciones := column T Retrieve.proportions;
  ternas := column T Retrieve.vertices
|}.

(** ** The state *)
Section State.
Variable T : Tables.
Hypothesis ok : tables_ok T.

Lemma at_its_place e p : index T e = Some p <-> exists x, row_at T p e x.
Proof. destruct p as [t i]. exact (Retrieve.index_exact _ _ ok e t i). Qed.
Lemma type_at_place e x p : row_at T p e x -> Retrieve.type_of x = fst p.
Proof. apply (Retrieve.rows_typed _ _ ok). Qed.

Lemma column_pfun {V} (A : Retrieve.Shape -> set V) (B : set V) : (forall x, at_most_one (A x)) ->
  (forall x, Retrieve.valid x -> A x ⊆ B) -> column T A ∈ (univ ⇸ B).
Proof.
  intros H1 HB. split; [| split; [easy |]].
  - intros p v v' [e [x [Hx Hv]]] [e' [x' [Hx' Hv']]]. cbn in *. rewrite Hx in Hx'. injection Hx' as <- <-.
    exact (H1 x _ _ Hv Hv').
  - intros v [p [e [x [Hx Hv]]]]. exact (HB x (Retrieve.rows_valid _ _ ok _ _ _ _ Hx) v Hv).
Qed.
Lemma column_dom {V} (A : Retrieve.Shape -> set V) (S : set Tipo) :
  (forall x, (exists v, A x v) <-> S (Retrieve.type_of x)) -> dom (column T A) ≡ dres S (ran (lugar (tablas_of T))).
Proof.
  intros H p. unfold dres, ran. cbn. setoid_rewrite at_its_place. split.
  - intros [v [e [x [Hx Hv]]]]. cbn in *. split; [| exists e, x; exact Hx].
    rewrite <- (type_at_place _ _ _ Hx). apply H. now exists v.
  - intros [Ht [e [x Hx]]]. rewrite <- (type_at_place _ _ _ Hx) in Ht. apply H in Ht as [v Hv]. exists v, e, x. now split.
Qed.
Lemma attribute_of_column {V} (A : Retrieve.Shape -> set V) :
  Retrieve.attribute Elemento T A ≡ comp (lugar (tablas_of T)) (column T A).
Proof.
  intros [e v]. unfold comp, column, Retrieve.attribute, Retrieve.row. cbn. setoid_rewrite at_its_place. split.
  - intros [x [[t [i H]] Hv]]. exists (t, i). split; [exists x; exact H | exists e, x; now split].
  - intros [p [[x H] [e' [x' [H' Hv]]]]]. rewrite H in H'. injection H' as <- <-. exists x. split; [| exact Hv].
    now exists (fst p), (snd p).
Qed.

Ltac column_of_types := apply column_dom; let x := fresh in intros x;
  destruct x; cbn; unfold centro_types, radio_types, vector_types, altura_types, proporcion_types, vertices_types;
  unfold union, single, empty;
  (split; [let H := fresh in intros [? H]; auto 8; easy | let H := fresh in intros H; repeat destruct H as [H | H];
    try discriminate H; eauto]).

Lemma tablas_of_ok : Tablas_ok (tablas_of T).
Proof.
  assert (S1 : forall V (v : V), at_most_one ⦃v⦄) by (intros V v a b -> ->; reflexivity).
  assert (S0 : forall V, at_most_one (∅ : set V)) by (intros V a b []).
  assert (E0 : forall V (B : set V), ∅ ⊆ B) by (intros V B v []).
  assert (S2 : forall V (v : V) (B : set V), B v -> ⦃v⦄ ⊆ B) by (now intros V v B H w ->).
  split; cbn.
  - split; [| easy]. intros e p p' H H'. cbn in *. congruence.
  - split; [easy |]. destruct (Escena_decl_elementos (Retrieve.retrieve_ok Elemento T ok)) as [_ [l Hl]].
    exists l. intros e. rewrite <- (Hl e). cbn. unfold Retrieve.row. split.
    + intros [p H]. apply at_its_place in H as [x H]. now exists x, (fst p), (snd p).
    + intros [x [t [i H]]]. exists (t, i). apply at_its_place. now exists x.
  - split; [| easy]. intros p e e' [x H] [x' H']. cbn in *. congruence.
  - apply column_pfun; [intros []; cbn; auto | easy].
  - apply column_pfun; intros []; cbn; auto; intros H; apply S2; tauto.
  - apply column_pfun; intros []; cbn; auto; intros H; apply S2; tauto.
  - apply column_pfun; intros []; cbn; auto; intros H; apply S2; tauto.
  - apply column_pfun; intros []; cbn; auto; intros H; apply S2; tauto.
  - apply column_pfun; intros []; cbn; auto; intros H; apply S2; tauto.
  - intros p. unfold ran, places, tabla. rewrite <- nth_error_Some. setoid_rewrite at_its_place. split.
    + intros [e [x H]] N. cbn in H, N. congruence.
    + intros N. destruct (nth_error (rows T (fst p)) (snd p)) as [[e x] |] eqn:H; [now exists e, x | easy].
  - intros [p e]. unfold inverse. cbn. now rewrite at_its_place.
  - column_of_types.
  - column_of_types.
  - column_of_types.
  - column_of_types.
  - column_of_types.
  - column_of_types.
Qed.

(** The lists stand for the scene that the text says their tables stand for. *)
Theorem rows_retrieve_as_the_text : Tablas.Retrieve (retrieve T) (tablas_of T).
Proof.
  split; [exact (Retrieve.retrieve_ok _ _ ok) | exact tablas_of_ok | | apply attribute_of_column ..].
  intros [e t]. cbn. rewrite (proj2 (Retrieve.find_correct Elemento T e ok) t). unfold comp, tabla_of. cbn. split.
  - intros [i H]. now exists (t, i).
  - intros [[t' i] [H ->]]. now exists i.
Qed.
End State.

Theorem empty_rows_are_the_first_tables : Init_Tablas (tablas_of (Retrieve.empty_tables Elemento)).
Proof.
  split; [apply tablas_of_ok, Retrieve.empty_tables_Init |]. intros [e p]. cbn. split; [discriminate | intros []].
Qed.

(** ** A row added *)
Section Addition.
Variables (T : Tables) (e : Elemento) (x : Retrieve.Shape).
Hypothesis ok : tables_ok T.
Hypothesis new : index T e = None.
Hypothesis good : Retrieve.valid x.
Let t := Retrieve.type_of x.
Let p : Lugar := (t, length (rows T t)).

Lemma added_ok : tables_ok (add T e x).
Proof. now apply Retrieve.add_ok. Qed.
Lemma place_added : index (add T e x) e = Some p.
Proof. cbn. now destruct (Elemento_dec e e). Qed.
Lemma lugar_added : lugar (tablas_of (add T e x)) ≡ lugar (tablas_of T) ∪ ⦃(e, p)⦄.
Proof.
  intros [k q]. unfold union, single. cbn. fold t p. destruct (Elemento_dec k e) as [-> | N].
  - rewrite new. split; [intros [= <-]; now right | intros [E | [= ->]]; [discriminate | reflexivity]].
  - split; [now left | intros [E | [= E _]]; [exact E | now destruct N]].
Qed.
Lemma cuantos_added : cuantos (tablas_of (add T e x)) t = (cuantos (tablas_of T) t + 1)%nat
  /\ forall u, u <> t -> cuantos (tablas_of (add T e x)) u = cuantos (tablas_of T) u.
Proof.
  unfold Retrieve.add, Retrieve.change. cbn. fold t. split.
  - destruct (Retrieve.Tipo_dec t t); [| easy]. now rewrite app_length.
  - intros u N. now destruct (Retrieve.Tipo_dec u t).
Qed.
Lemma column_added {V} (A : Retrieve.Shape -> set V) : column (add T e x) A ≡ column T A ∪ at_one p (A x).
Proof.
  intros [q v]. unfold column, union, at_one. cbn. setoid_rewrite (Retrieve.rows_add Elemento Elemento_dec). fold t. split.
  - intros [k [y [[H | [E1 [E2 [= -> ->]]]] Hv]]]; [left; now exists k, y | right]. split; [| exact Hv].
    destruct q as [u i]. cbn in *. subst u i. reflexivity.
  - intros [[k [y [H Hv]]] | [-> Hv]]; [exists k, y; auto |]. exists e, x. split; [right | exact Hv]. now repeat split.
Qed.
Lemma row_added : Agregar_Fila (tablas_of T) (tablas_of (add T e x)) e t.
Proof.
  split; [now apply tablas_of_ok | apply tablas_of_ok, added_ok | | exact lugar_added | exact cuantos_added].
  intros [q H]. cbn in H. congruence.
Qed.
Lemma column_grown {V} (A : Retrieve.Shape -> set V) v : A x = ⦃v⦄ ->
  grown (tablas_of (add T e x)) e v (column T A) (column (add T e x) A).
Proof. intros E. exists p. split; [exact place_added |]. rewrite column_added, E. apply at_one_single. Qed.
Lemma column_same {V} (A : Retrieve.Shape -> set V) : A x = ∅ -> column (add T e x) A ≡ column T A.
Proof. intros E. rewrite column_added, E. apply at_one_empty. Qed.
End Addition.

(** What the text says of the addition of a row. *)
Definition texts_addition (x : Retrieve.Shape) (U U' : Tablas Elemento) e : Prop :=
  match x with
  | Retrieve.Sphere c r => Agregar_Esfera_Tablas U U' e soy_esfera esfera_agregada c r
  | Retrieve.Cylinder c r d h => Agregar_Cilindro_Tablas U U' e soy_cilindro cilindro_agregado c r d h
  | Retrieve.Cone c k d h => Agregar_Cono_Tablas U U' e soy_cono cono_agregado c k d h
  | Retrieve.TruncatedCone c r k d h => Agregar_Tronco_Tablas U U' e soy_tronco tronco_agregado c r k d h
  | Retrieve.Plane c d => Agregar_Plano_Tablas U U' e soy_plano plano_agregado c d
  | Retrieve.Disc c r d => Agregar_Disco_Tablas U U' e soy_disco disco_agregado c r d
  | Retrieve.Triangle abc => Agregar_Triangulo_Tablas U U' e soy_triangulo triangulo_agregado abc
  end.

Lemma nombres_follow (U U' : Tablas Elemento) : Tablas_ok U -> Tablas_ok U' -> lugar U' ≡ lugar U ->
  nombres U' ≡ nombres U.
Proof.
  intros ok ok' L [p e]. rewrite (Tablas_inv_2 _ ok (p, e)), (Tablas_inv_2 _ ok' (p, e)). exact (L (e, p)).
Qed.
Lemma same_twice {X} (A A' A'' : set X) : A' ≡ A -> A'' ≡ A -> A'' ≡ A'.
Proof. intros H H'. rewrite H. exact H'. Qed.
Lemma grown_twice {V} (U' U'' : Tablas Elemento) e (v : V) f f' f'' : Tablas_ok U' -> lugar U'' ≡ lugar U' ->
  grown U' e v f f' -> grown U'' e v f f'' -> f'' ≡ f'.
Proof.
  intros ok L [p [H F]] [p' [H' F']]. apply (L (e, p')) in H'.
  rewrite (place_unique U' ok _ _ _ H' H) in F'. exact (same_twice _ _ _ F F').
Qed.
(** It is true of one next state. *)
Theorem an_addition_has_one_outcome x (U U' U'' : Tablas Elemento) e :
  texts_addition x U U' e -> texts_addition x U U'' e -> Tablas_eq U' U''.
Proof.
  assert (K : forall t, Agregar_Fila U U' e t -> Agregar_Fila U U'' e t ->
    Tablas_ok U' /\ Tablas_ok U'' /\ lugar U'' ≡ lugar U' /\ forall u, cuantos U'' u = cuantos U' u).
  { intros t [_ ok' _ L [C Co]] [_ ok'' _ L' [C' Co']]. split; [exact ok' | split; [exact ok'' |]].
    split; [exact (same_twice _ _ _ L L') |]. intros u. destruct (Retrieve.Tipo_dec u t) as [-> | N]; [congruence |].
    now rewrite Co, Co' by exact N. }
  destruct x; cbn; intros [F H] [F' H']; destruct (K _ F F') as [ok' [ok'' [L C]]];
    decompose [and] H; decompose [and] H'; split;
    first [ exact L | exact C | now apply nombres_follow | eapply same_twice; eassumption
          | eapply (grown_twice U' U''); eassumption ].
Qed.

(** To append a row is what the text says of the addition of its type. *)
Theorem add_is_the_texts T e x : tables_ok T -> index T e = None -> Retrieve.valid x ->
  texts_addition x (tablas_of T) (tablas_of (add T e x)) e.
Proof.
  intros ok new good. pose proof (row_added T e x ok new good) as F.
  destruct x; cbn [Retrieve.valid Retrieve.type_of texts_addition] in *; hnf;
    repeat match goal with |- _ /\ _ => split end;
    first [ exact F | reflexivity | tauto | now apply column_grown | now apply column_same ].
Qed.

(** ** A row removed *)
Section Removal.
Variables (T : Tables) (e : Elemento) (t : Tipo) (i : nat).
Hypothesis ok : tables_ok T.
Hypothesis found : index T e = Some (t, i).
Notation U := (tablas_of T).

Lemma removed_ok : tables_ok (remove T e).
Proof. exact (Retrieve.remove_ok _ _ _ _ _ _ ok found). Qed.
Lemma found_in_text : (e, (t, i)) ∈ lugar U.
Proof. exact found. Qed.

(** Where a row goes is the same by the lists and by the text. *)
Lemma moves_as_the_text k y q q' : k <> e -> row_at T q k y ->
  (mudanza U e (q, q') <-> Retrieve.moved Elemento T t i (fst q) (snd q) = q').
Proof.
  intros N H. rewrite (moved_spec U e (t, i) (tablas_of_ok T ok) found_in_text).
  assert (G : q <> (t, i)).
  { intros ->. apply N. apply (Retrieve.index_exact _ _ ok) in found as [y' H']. cbn in H. congruence. }
  assert (R : q ∈ ran (lugar U)) by (exists k; apply (at_its_place T ok); now exists y).
  unfold Retrieve.moved. destruct q as [u j]. cbn [fst snd tabla cuantos tablas_of]. unfold tabla. cbn [fst].
  destruct (Retrieve.Tipo_dec u t) as [-> | Nu].
  - destruct (Nat.eq_dec j (length (rows T t) - 1)) as [-> | Nj].
    + split; [intros [_ [[_ ->] | [F _]]]; [reflexivity | easy] | intros <-; split; [exact G | now left]].
    + split; [intros [_ [[E _] | [_ [_ ->]]]]; [congruence | reflexivity] |].
      intros <-. split; [exact G | right]. repeat split; [congruence | exact R].
  - split; [intros [_ [[E _] | [_ [_ ->]]]]; [congruence | reflexivity] |].
    intros <-. split; [exact G | right]. repeat split; [congruence | exact R].
Qed.
Lemma the_gap_goes_nowhere q : ~ mudanza U e ((t, i), q).
Proof. rewrite (moved_spec U e (t, i) (tablas_of_ok T ok) found_in_text). tauto. Qed.
Lemma row_of_e y q : row_at T q e y -> q = (t, i).
Proof. intros H. assert (E : index T e = Some q) by (apply (at_its_place T ok); now exists y). congruence. Qed.

Lemma row_after q k y : row_at (remove T e) q k y <-> exists q0, mudanza U e (q0, q) /\ row_at T q0 k y.
Proof.
  rewrite (Retrieve.rows_remove _ _ _ _ _ _ ok found). split.
  - intros [N [t0 [j0 [H M]]]]. exists (t0, j0). split; [| exact H]. apply (moves_as_the_text k y); auto.
    cbn. rewrite M. now destruct q.
  - intros [q0 [M H]]. assert (N : k <> e).
    { intros ->. rewrite (row_of_e _ _ H) in M. exact (the_gap_goes_nowhere _ M). }
    split; [exact N |]. exists (fst q0), (snd q0). split; [exact H |].
    apply (moves_as_the_text k y q0 q N H) in M. rewrite M. now destruct q.
Qed.
Lemma column_after {V} (A : Retrieve.Shape -> set V) :
  column (remove T e) A ≡ comp (inverse (mudanza U e)) (column T A).
Proof.
  intros [q v]. unfold column, comp, inverse. cbn. setoid_rewrite row_after. split.
  - intros [k [y [[q0 [M H]] Hv]]]. exists q0. split; [exact M |]. now exists k, y.
  - intros [q0 [M [k [y [H Hv]]]]]. exists k, y. split; [now exists q0 | exact Hv].
Qed.
Lemma lugar_after : lugar (tablas_of (remove T e)) ≡ comp (lugar U) (mudanza U e).
Proof.
  intros [k q]. unfold comp. cbn [lugar tablas_of fst snd]. rewrite (at_its_place _ removed_ok). setoid_rewrite row_after.
  split.
  - intros [y [q0 [M H]]]. exists q0. split; [| exact M]. apply (at_its_place T ok). now exists y.
  - intros [q0 [H M]]. apply (at_its_place T ok) in H as [y H]. exists y, q0. now split.
Qed.
Lemma cuantos_after : cuantos (tablas_of (remove T e)) t = (cuantos U t - 1)%nat
  /\ forall u, u <> t -> cuantos (tablas_of (remove T e)) u = cuantos U u.
Proof.
  assert (L : i < length (rows T t)) by
    (apply (Retrieve.index_exact _ _ ok) in found as [y H]; apply nth_error_Some; congruence).
  cbn. unfold Retrieve.remove. rewrite found. cbn. unfold Retrieve.change. split.
  - destruct (Retrieve.Tipo_dec t t); [| easy]. unfold Retrieve.swap_remove.
    destruct (nth_error (rows T t) (length (rows T t) - 1)) as [y |] eqn:E; [| apply nth_error_None in E; lia].
    unfold Retrieve.pop. rewrite firstn_length, Retrieve.length_set_nth by exact L. lia.
  - intros u N. now destruct (Retrieve.Tipo_dec u t).
Qed.
Lemma row_removed : Quitar_Fila U (tablas_of (remove T e)) e.
Proof.
  split; try apply column_after; [now apply tablas_of_ok | apply tablas_of_ok, removed_ok | now exists (t, i) |
    exact lugar_after |].
  exists (t, i). split; [exact found | exact cuantos_after].
Qed.
End Removal.

(** What the text says of the removal of an element of a type. *)
Definition texts_removal (t : Tipo) (U U' : Tablas Elemento) e : Prop :=
  match t with
  | soy_esfera => Eliminar_Esfera_Tablas U U' e esfera_eliminada
  | soy_cilindro => Eliminar_Cilindro_Tablas U U' e cilindro_eliminado
  | soy_cono => Eliminar_Cono_Tablas U U' e cono_eliminado
  | soy_tronco => Eliminar_Tronco_Tablas U U' e tronco_eliminado
  | soy_plano => Eliminar_Plano_Tablas U U' e plano_eliminado
  | soy_disco => Eliminar_Disco_Tablas U U' e disco_eliminado
  | soy_triangulo => Eliminar_Triangulo_Tablas U U' e triangulo_eliminado
  end.

(** It is true of one next state. *)
Theorem a_removal_has_one_outcome t (U U' U'' : Tablas Elemento) e :
  texts_removal t U U' e -> texts_removal t U U'' e -> Tablas_eq U' U''.
Proof.
  intros H H'. assert (Q : Quitar_Fila U U' e /\ Quitar_Fila U U'' e) by (destruct t; split; (apply H || apply H')).
  destruct Q as [[ok ok' _ L [p [E [C Co]]] A1 A2 A3 A4 A5 A6] [_ ok'' _ L' [p' [E' [C' Co']]] B1 B2 B3 B4 B5 B6]].
  assert (S : lugar U'' ≡ lugar U') by exact (same_twice _ _ _ L L').
  assert (p' = p) as -> by exact (place_unique U ok _ _ _ E' E).
  split; first [ exact S | now apply nombres_follow | eapply same_twice; eassumption | idtac ].
  intros u. destruct (Retrieve.Tipo_dec u (tabla p)) as [-> | N]; [congruence |]. now rewrite Co, Co' by exact N.
Qed.

(** To move the last row into the gap is what the text says of the removal of the type that the index tells. *)
Theorem remove_is_the_texts T e t i : tables_ok T -> index T e = Some (t, i) ->
  texts_removal t (tablas_of T) (tablas_of (remove T e)) e.
Proof.
  intros ok found. pose proof (row_removed T e t i ok found) as Q.
  destruct t; (split; [exact Q | split; [| reflexivity]]); eexists; (split; [exact found | reflexivity]).
Qed.
End TablasOfRows.
