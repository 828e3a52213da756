(** The compact scene refines the model: dense tables by type and an index from names to rows, whose operations commute
    with those of the Z text through retrieve.

    Shape                == the row of an element of each type, without its name
    Tables               == one list of named shapes for each type, and the place of each name
    tables_ok            == the invariant of the tables: the index gives exactly the places of the rows, each row lies in the
                            table of its type, its attributes are in their ranges
    row T e x            == some table of T holds the shape x under the name e
    retrieve T           == the scene of the Z text that T represents
    add T e x            == append a row;  remove T e == move the last row of the table into the gap *)
From Coq Require Import Reals List Lia Arith.
From Durero Require Import Toolkit Especificacion Escena Operaciones.
Import ListNotations.
Local Open Scope zed_scope.

(** ** Lists as tables *)
Section Lists.
Context {X : Type}.

Definition set_nth (i : nat) (x : X) (l : list X) : list X := firstn i l ++ x :: skipn (S i) l.
Definition pop (l : list X) : list X := firstn (length l - 1) l.

Lemma nth_error_set_nth i x l j : i < length l ->
  nth_error (set_nth i x l) j = if Nat.eq_dec j i then Some x else nth_error l j.
Proof.
  intros Hi. unfold set_nth. assert (Li : length (firstn i l) = i) by (rewrite firstn_length; lia).
  destruct (Nat.eq_dec j i) as [-> | N].
  - rewrite nth_error_app2, Li, Nat.sub_diag by lia. reflexivity.
  - destruct (lt_dec j i) as [L | L].
    + rewrite nth_error_app1 by lia. rewrite <- (firstn_skipn i l) at 2. now rewrite nth_error_app1 by lia.
    + rewrite nth_error_app2, Li by lia. rewrite <- (firstn_skipn (S i) l) at 2.
      assert (LS : length (firstn (S i) l) = S i) by (rewrite firstn_length; lia).
      rewrite (nth_error_app2 (firstn (S i) l)), LS by lia. replace (j - i) with (S (j - S i)) by lia. reflexivity.
Qed.
Lemma length_set_nth i x l : i < length l -> length (set_nth i x l) = length l.
Proof. intros Hi. unfold set_nth. rewrite app_length, firstn_length. cbn [length]. rewrite skipn_length. lia. Qed.
Lemma nth_error_pop l j : nth_error (pop l) j = if lt_dec j (length l - 1) then nth_error l j else None.
Proof.
  unfold pop. destruct (lt_dec j (length l - 1)) as [L | L].
  - rewrite <- (firstn_skipn (length l - 1) l) at 3. rewrite nth_error_app1; [reflexivity |].
    rewrite firstn_length. lia.
  - apply nth_error_None. rewrite firstn_length. lia.
Qed.

(** The last element into the gap at i, then one element fewer. *)
Definition swap_remove (i : nat) (l : list X) : list X :=
  match nth_error l (length l - 1) with Some x => pop (set_nth i x l) | None => l end.
Lemma nth_error_swap_remove i l j : i < length l ->
  nth_error (swap_remove i l) j =
  if lt_dec j (length l - 1) then nth_error l (if Nat.eq_dec j i then length l - 1 else j) else None.
Proof.
  intros Hi. unfold swap_remove. destruct (nth_error l (length l - 1)) as [x |] eqn:E.
  - rewrite nth_error_pop, length_set_nth, nth_error_set_nth by assumption.
    destruct (lt_dec j (length l - 1)), (Nat.eq_dec j i); congruence.
  - apply nth_error_None in E. lia.
Qed.
End Lists.

Inductive Shape :=
  | Sphere (centro : Punto) (radio : R)
  | Cylinder (centro : Punto) (radio : R) (vector : Vector) (altura : R)
  | Cone (centro : Punto) (proporcion : R) (vector : Vector) (altura : R)
  | TruncatedCone (centro : Punto) (radio proporcion : R) (vector : Vector) (altura : R)
  | Plane (centro : Punto) (vector : Vector)
  | Disc (centro : Punto) (radio : R) (vector : Vector)
  | Triangle (vertices : Terna).

Definition type_of x :=
  match x with
  | Sphere _ _ => soy_esfera
  | Cylinder _ _ _ _ => soy_cilindro
  | Cone _ _ _ _ => soy_cono
  | TruncatedCone _ _ _ _ _ => soy_tronco
  | Plane _ _ => soy_plano
  | Disc _ _ _ => soy_disco
  | Triangle _ => soy_triangulo
  end.
Definition centres x : set Punto :=
  match x with
  | Sphere c _ | Cylinder c _ _ _ | Cone c _ _ _ | TruncatedCone c _ _ _ _ | Plane c _ | Disc c _ _ => ⦃c⦄
  | _ => ∅
  end.
Definition radii x : set R :=
  match x with Sphere _ r | Cylinder _ r _ _ | TruncatedCone _ r _ _ _ | Disc _ r _ => ⦃r⦄ | _ => ∅ end.
Definition axes x : set Vector :=
  match x with Cylinder _ _ d _ | Cone _ _ d _ | TruncatedCone _ _ _ d _ | Plane _ d | Disc _ _ d => ⦃d⦄ | _ => ∅ end.
Definition heights x : set R :=
  match x with Cylinder _ _ _ h | Cone _ _ _ h | TruncatedCone _ _ _ _ h => ⦃h⦄ | _ => ∅ end.
Definition proportions x : set R := match x with Cone _ k _ _ | TruncatedCone _ _ k _ _ => ⦃k⦄ | _ => ∅ end.
Definition vertices x : set Terna := match x with Triangle abc => ⦃abc⦄ | _ => ∅ end.
Definition valid x : Prop :=
  match x with
  | Sphere _ r => r ∈ Rmas
  | Cylinder _ r d h => r ∈ Rmas /\ d ∈ Unitario /\ h ∈ Rmas
  | Cone _ k d h => k ∈ Rmas /\ d ∈ Unitario /\ h ∈ Rmas
  | TruncatedCone _ r k d h => r ∈ Rmas /\ k ∈ Rmas /\ d ∈ Unitario /\ h ∈ Rmas
  | Plane _ d => d ∈ Unitario
  | Disc _ r d => r ∈ Rmas /\ d ∈ Unitario
  | Triangle abc => abc ∈ Vertices
  end.

Lemma Tipo_dec (t t' : Tipo) : {t = t'} + {t <> t'}.
Proof. decide equality. Defined.

Section Retrieve.
Variable Elemento : Type.
Hypothesis Elemento_dec : forall e e' : Elemento, {e = e'} + {e <> e'}.
Notation Escena := (Especificacion.Escena Elemento).

Record Tables := mk_Tables {
  rows : Tipo -> list (Elemento * Shape);
  index : Elemento -> option (Tipo * nat)
}.
Record tables_ok (T : Tables) : Prop := {
  index_exact : forall e t i, index T e = Some (t, i) <-> exists x, nth_error (rows T t) i = Some (e, x);
  rows_typed : forall e x t i, nth_error (rows T t) i = Some (e, x) -> type_of x = t;
  rows_valid : forall e x t i, nth_error (rows T t) i = Some (e, x) -> valid x
}.
Definition row (T : Tables) (e : Elemento) (x : Shape) : Prop := exists t i, nth_error (rows T t) i = Some (e, x).

Definition attribute {V} (T : Tables) (A : Shape -> set V) : rel Elemento V :=
  fun p => exists x, row T (fst p) x /\ A x (snd p).
Definition retrieve (T : Tables) : Escena := {|
  elementos := fun e => exists x, row T e x;
  tipos := fun t => exists e x, row T e x /\ t = type_of x;
  de_que_tipo := attribute T (fun x => ⦃type_of x⦄);
  mi_centro := attribute T centres;
  mi_radio := attribute T radii;
  mi_vector := attribute T axes;
  mi_altura := attribute T heights;
  mi_proporcion := attribute T proportions;
  mi_vertices := attribute T vertices
|}.

Definition empty_tables : Tables := mk_Tables (fun _ => []) (fun _ => None).
Definition change {V} (t : Tipo) (v : V) (f : Tipo -> V) : Tipo -> V := fun t' => if Tipo_dec t' t then v else f t'.
Definition add (T : Tables) (e : Elemento) (x : Shape) : Tables :=
  let t := type_of x in let l := rows T t in
  mk_Tables (change t (l ++ [(e, x)]) (rows T))
            (fun k => if Elemento_dec k e then Some (t, length l) else index T k).
Definition remove (T : Tables) (e : Elemento) : Tables :=
  match index T e with
  | None => T
  | Some (t, i) =>
    let l := rows T t in
    mk_Tables (change t (swap_remove i l) (rows T))
      (fun k => if Elemento_dec k e then None
                else match index T k with
                     | Some (t', j) => if Tipo_dec t' t then if Nat.eq_dec j (length l - 1) then Some (t, i)
                                                             else Some (t', j) else Some (t', j)
                     | None => None
                     end)
  end.

(** ** What the tables hold *)

Lemma row_unique T e x x' : tables_ok T -> row T e x -> row T e x' -> x = x'.
Proof.
  intros ok [t [i H]] [t' [i' H']].
  assert (E : index T e = Some (t, i)) by (apply (index_exact _ ok); eauto).
  assert (E' : index T e = Some (t', i')) by (apply (index_exact _ ok); eauto).
  rewrite E in E'. injection E' as <- <-. congruence.
Qed.
Lemma row_valid T e x : tables_ok T -> row T e x -> valid x.
Proof. intros ok [t [i H]]. exact (rows_valid _ ok _ _ _ _ H). Qed.

(** The index finds exactly the elements of the scene, and their type. *)
Theorem find_correct T e : tables_ok T ->
  (e ∈ elementos (retrieve T) <-> index T e <> None)
  /\ forall t, (e, t) ∈ de_que_tipo (retrieve T) <-> exists i, index T e = Some (t, i).
Proof.
  intros ok.
  assert (A : forall t, (e, t) ∈ de_que_tipo (retrieve T) <-> exists i, index T e = Some (t, i)).
  { intros t. split.
    - intros [x [[t' [i H]] E]]. cbn in *. unfold single in E. rewrite (rows_typed _ ok _ _ _ _ H) in E. subst t'.
      exists i. apply (index_exact _ ok). eauto.
    - intros [i H]. apply (index_exact _ ok) in H as [x H]. exists x. split; [now exists t, i |].
      cbn. unfold single. symmetry. exact (rows_typed _ ok _ _ _ _ H). }
  split; [| exact A]. split.
  - intros [x [t [i H]]]. assert (E : index T e = Some (t, i)) by (apply (index_exact _ ok); eauto). congruence.
  - destruct (index T e) as [[t i] |] eqn:E; [intros _ | easy]. apply (index_exact _ ok) in E as [x H].
    exists x, t, i. exact H.
Qed.

Lemma attribute_pfun {V} T (A : Shape -> set V) (B : set V) : tables_ok T ->
  (forall x, at_most_one (A x)) -> (forall x, valid x -> A x ⊆ B) -> attribute T A ∈ (univ ⇸ B).
Proof.
  intros ok H1 HB. split; [| split; [easy |]].
  - intros e v v' [x [Hx Hv]] [x' [Hx' Hv']]. cbn in *. rewrite <- (row_unique T e x x' ok Hx Hx') in Hv'.
    exact (H1 x _ _ Hv Hv').
  - intros v [e [x [Hx Hv]]]. exact (HB x (row_valid _ _ _ ok Hx) v Hv).
Qed.
Lemma attribute_dom {V} T (A : Shape -> set V) (S : set Tipo) : tables_ok T ->
  (forall x, (exists v, A x v) <-> S (type_of x)) ->
  dom (attribute T A) ≡ image (inverse (attribute T (fun x => ⦃type_of x⦄))) S.
Proof.
  intros ok H e. split.
  - intros [v [x [Hx Hv]]]. exists (type_of x). split; [apply H; now exists v | exists x; now split].
  - intros [t [Ht [x [Hx E]]]]. cbn in *. unfold single in E. subst t. apply H in Ht as [v Hv].
    exists v, x. now split.
Qed.
Lemma single_subset {V} (v : V) (B : set V) : B v -> ⦃v⦄ ⊆ B.
Proof. now intros H w ->. Qed.

(** A shape has a value of an attribute exactly where its type is among those that have it. *)
Ltac attribute_of_types ok := apply attribute_dom; [exact ok |]; let x := fresh in intros x;
  destruct x; cbn; unfold union, single, empty;
  (split; [let H := fresh in intros [? H]; auto 8; easy | let H := fresh in intros H; repeat destruct H as [H | H];
    try discriminate H; eauto]).

(** Tables that satisfy their invariant represent a scene that satisfies its own. *)
Theorem retrieve_ok T : tables_ok T -> Escena_ok (retrieve T).
Proof.
  intros ok.
  assert (S1 : forall V (v : V), at_most_one ⦃v⦄) by (intros V v a b -> ->; reflexivity).
  assert (S0 : forall V, at_most_one (∅ : set V)) by (intros V a b []).
  assert (E0 : forall V (B : set V), ∅ ⊆ B) by (intros V B v []).
  split; cbn.
  - split; [easy |].
    exists (map fst (concat (map (rows T)
      [soy_esfera; soy_cilindro; soy_cono; soy_tronco; soy_plano; soy_disco; soy_triangulo]))). intros e.
    rewrite in_map_iff. setoid_rewrite in_concat. setoid_rewrite in_map_iff. split.
    + intros [x [t [i H]]]. apply nth_error_In in H. exists (e, x). split; [reflexivity |]. exists (rows T t).
      split; [| exact H]. exists t. split; [reflexivity |]. destruct t; cbn; auto 8.
    + intros [[e' x] [<- [l [[t [<- _]] H]]]]. apply In_nth_error in H as [i H]. now exists x, t, i.
  - easy.
  - apply attribute_pfun; auto; easy.
  - apply attribute_pfun; auto; [intros []; cbn; auto | easy].
  - apply attribute_pfun; auto; intros []; cbn; auto; intros H; apply single_subset; tauto.
  - apply attribute_pfun; auto; [intros []; cbn; auto | easy].
  - apply attribute_pfun; auto; intros []; cbn; auto; intros H; apply single_subset; tauto.
  - apply attribute_pfun; auto; intros []; cbn; auto; intros H; apply single_subset; tauto.
  - apply attribute_pfun; auto; intros []; cbn; auto; intros H; apply single_subset; tauto.
  - intros e. split; [intros [x H]; exists (type_of x), x; now split | intros [t [x [H _]]]; now exists x].
  - attribute_of_types ok.
  - attribute_of_types ok.
  - attribute_of_types ok.
  - attribute_of_types ok.
  - attribute_of_types ok.
  - intros t. split; [intros [e [x [H ->]]]; exists e, x; now split | intros [e [x [H E]]]; now exists e, x].
  - intros d [e [x [H Hd]]]. cbn in *. pose proof (row_valid _ _ _ ok H) as Hv.
    destruct x; cbn in *; try contradiction; unfold single in Hd; subst; tauto.
  - attribute_of_types ok.
Qed.

(** The first tables are empty, and represent the first scene. *)
Theorem empty_tables_Init : tables_ok empty_tables /\ Init (retrieve empty_tables).
Proof.
  assert (N : forall i, nth_error ([] : list (Elemento * Shape)) i = None) by now intros [].
  assert (ok : tables_ok empty_tables).
  { split; cbn; [intros e t i; split; [easy |]; intros [x H] | intros e x t i H | intros e x t i H];
      rewrite N in H; discriminate. }
  split; [exact ok | split; [now apply retrieve_ok |]]. intros e. split; [| intros []].
  intros [x [t [i H]]]. cbn in H. rewrite N in H. discriminate.
Qed.

(** ** Adding *)

Lemma nth_error_snoc {X} (l : list X) a i b :
  nth_error (l ++ [a]) i = Some b <-> nth_error l i = Some b \/ (i = length l /\ a = b).
Proof.
  destruct (lt_eq_lt_dec i (length l)) as [[L | ->] | L].
  - rewrite nth_error_app1 by exact L. split; [auto | intros [H | [H _]]; [exact H | lia]].
  - rewrite nth_error_app2, Nat.sub_diag by lia. cbn. rewrite (proj2 (nth_error_None l (length l))) by lia.
    split; [intros [= ->]; auto | intros [H | [_ ->]]; [discriminate | reflexivity]].
  - rewrite (proj2 (nth_error_None (l ++ [a]) i)) by (rewrite app_length; cbn; lia).
    rewrite (proj2 (nth_error_None l i)) by lia. split; [discriminate | intros [H | [H _]]; [discriminate | lia]].
Qed.

Lemma rows_add T e x t i y : nth_error (rows (add T e x) t) i = Some y <->
  nth_error (rows T t) i = Some y \/ (t = type_of x /\ i = length (rows T t) /\ y = (e, x)).
Proof.
  unfold add, change; cbn. destruct (Tipo_dec t (type_of x)) as [-> | N].
  - rewrite nth_error_snoc. intuition congruence.
  - tauto.
Qed.
Lemma row_add T e x k y : row (add T e x) k y <-> row T k y \/ (k = e /\ y = x).
Proof.
  unfold row. setoid_rewrite rows_add. split.
  - intros [t [i [H | [_ [_ [= -> ->]]]]]]; eauto.
  - intros [[t [i H]] | [-> ->]]; [eauto |]. exists (type_of x), (length (rows T (type_of x))). auto.
Qed.

Lemma add_ok T e x : tables_ok T -> index T e = None -> valid x -> tables_ok (add T e x).
Proof.
  intros ok He Hx. split.
  - intros k t i. setoid_rewrite rows_add. unfold add at 1; cbn. destruct (Elemento_dec k e) as [-> | N].
    + split; [intros [= <- <-]; exists x; auto |]. intros [y [H | [-> [-> _]]]]; [| reflexivity].
      assert (E : index T e = Some (t, i)) by (apply (index_exact _ ok); eauto). congruence.
    + rewrite (index_exact _ ok). split; [intros [y H]; eauto |]. intros [y [H | [_ [_ [= H _]]]]]; [eauto | easy].
  - intros k y t i H. apply rows_add in H as [H | [-> [_ [= _ ->]]]]; [exact (rows_typed _ ok _ _ _ _ H) | reflexivity].
  - intros k y t i H. apply rows_add in H as [H | [_ [_ [= _ ->]]]]; [exact (rows_valid _ ok _ _ _ _ H) | exact Hx].
Qed.

Lemma attribute_add {V} T e x (A : Shape -> set V) : attribute (add T e x) A ≡ attribute T A ∪ at_one e (A x).
Proof.
  intros [k v]. unfold attribute, union, at_one; cbn. setoid_rewrite row_add. split.
  - intros [y [[H | [-> ->]] Hv]]; eauto.
  - intros [[y [H Hv]] | [-> Hv]]; eauto.
Qed.
Lemma retrieve_add T e x : Escena_eq
  (scene_with _ (retrieve T) e (type_of x) (centres x) (radii x) (axes x) (heights x) (proportions x) (vertices x))
  (retrieve (add T e x)).
Proof.
  assert (D : attribute (add T e x) (fun y => ⦃type_of y⦄)
    ≡ attribute T (fun y => ⦃type_of y⦄) ∪ ⦃(e, type_of x)⦄).
  { rewrite attribute_add. apply at_one_single. }
  split; cbn; try exact (attribute_add T e x _); [| | exact D].
  - intros k. unfold union, single. setoid_rewrite row_add. split.
    + intros [y [H | [-> ->]]]; eauto.
    + intros [[y H] | ->]; eauto.
  - rewrite <- D. intros t. split; [intros [k [y [H ->]]]; exists k, y; now split |].
    intros [k [y [H E]]]. now exists k, y.
Qed.

(** To append a row is to add the element: on the scenes represented, it is the addition of the type of the row. *)
Theorem add_commutes T e x : tables_ok T -> index T e = None -> valid x ->
  tables_ok (add T e x) /\
  match x with
  | Sphere c r => Agregar_Esfera (retrieve T) (retrieve (add T e x)) e soy_esfera esfera_agregada c r
  | Cylinder c r d h =>
      Agregar_Cilindro (retrieve T) (retrieve (add T e x)) e soy_cilindro cilindro_agregado c r d h
  | Cone c k d h => Agregar_Cono (retrieve T) (retrieve (add T e x)) e soy_cono cono_agregado c k d h
  | TruncatedCone c r k d h =>
      Agregar_Tronco (retrieve T) (retrieve (add T e x)) e soy_tronco tronco_agregado c r k d h
  | Plane c d => Agregar_Plano (retrieve T) (retrieve (add T e x)) e soy_plano plano_agregado c d
  | Disc c r d => Agregar_Disco (retrieve T) (retrieve (add T e x)) e soy_disco disco_agregado c r d
  | Triangle abc =>
      Agregar_Triangulo (retrieve T) (retrieve (add T e x)) e soy_triangulo triangulo_agregado abc
  end.
Proof.
  intros ok He Hx. split; [now apply add_ok |]. pose proof (retrieve_ok T ok) as okr.
  assert (N : e ∉ elementos (retrieve T)) by (rewrite (proj1 (find_correct T e ok)); tauto).
  pose proof (retrieve_add T e x) as E. destruct x; cbn in Hx.
  - apply Agregar_Esfera_computed. auto.
  - apply Agregar_Cilindro_computed. split; [tauto | now split].
  - apply Agregar_Cono_computed. split; [tauto | now split].
  - apply Agregar_Tronco_computed. split; [tauto | now split].
  - apply Agregar_Plano_computed. auto.
  - apply Agregar_Disco_computed. split; [tauto | now split].
  - apply Agregar_Triangulo_computed. auto.
Qed.

(** ** Removing *)

Lemma nth_error_swap {X} i (l : list X) j y : i < length l ->
  (nth_error (swap_remove i l) j = Some y <->
   j < length l - 1 /\ nth_error l (if Nat.eq_dec j i then length l - 1 else j) = Some y).
Proof.
  intros Hi. rewrite nth_error_swap_remove by exact Hi. destruct (lt_dec j (length l - 1)); intuition discriminate.
Qed.

Section Removal.
Variables (T : Tables) (e : Elemento) (t : Tipo) (i : nat).
Hypothesis ok : tables_ok T.
Hypothesis found : index T e = Some (t, i).

Let l := rows T t.
Lemma place_valid : i < length l /\ exists x, nth_error l i = Some (e, x).
Proof.
  apply (index_exact _ ok) in found as [x H]. split; [| now exists x]. apply nth_error_Some. fold l in H. congruence.
Qed.
(** One name has one place. *)
Lemma places_equal k t1 i1 x1 t2 i2 x2 : nth_error (rows T t1) i1 = Some (k, x1) ->
  nth_error (rows T t2) i2 = Some (k, x2) -> t1 = t2 /\ i1 = i2 /\ x1 = x2.
Proof.
  intros H1 H2. assert (E1 : index T k = Some (t1, i1)) by (apply (index_exact _ ok); eauto).
  assert (E2 : index T k = Some (t2, i2)) by (apply (index_exact _ ok); eauto).
  rewrite E1 in E2. injection E2 as <- <-. repeat split. congruence.
Qed.
(** The place of the row at (t', j) after the removal. *)
Definition moved (t' : Tipo) (j : nat) : Tipo * nat :=
  if Tipo_dec t' t then if Nat.eq_dec j (length l - 1) then (t, i) else (t', j) else (t', j).

(** A row lies at a place afterwards exactly where another than e's lay at a place that moved there. *)
Lemma rows_remove t' j k y : nth_error (rows (remove T e) t') j = Some (k, y) <->
  k <> e /\ exists t0 j0, nth_error (rows T t0) j0 = Some (k, y) /\ moved t0 j0 = (t', j).
Proof.
  destruct place_valid as [Hi [x Hx]]. unfold remove. rewrite found. cbn. unfold change, moved. fold l.
  destruct (Tipo_dec t' t) as [-> | N].
  - rewrite nth_error_swap by exact Hi. split.
    + intros [Hj H]. split.
      * intros ->. destruct (places_equal e t _ _ t _ _ Hx H) as [_ [E _]]. destruct (Nat.eq_dec j i); lia.
      * exists t. destruct (Nat.eq_dec j i) as [-> | Nj].
        -- exists (length l - 1). split; [exact H |]. destruct (Tipo_dec t t); [| easy].
           destruct (Nat.eq_dec (length l - 1) (length l - 1)); easy.
        -- exists j. split; [exact H |]. destruct (Tipo_dec t t); [| easy].
           destruct (Nat.eq_dec j (length l - 1)); [lia | reflexivity].
    + intros [Hk [t0 [j0 [H M]]]]. destruct (Tipo_dec t0 t) as [-> | N0]; [| congruence].
      assert (L0 : j0 < length l) by (apply nth_error_Some; unfold l; congruence).
      assert (Ni : j0 <> i) by (intros ->; unfold l in Hx; congruence).
      destruct (Nat.eq_dec j0 (length l - 1)) as [-> | N0]; injection M as <-.
      * split; [lia |]. destruct (Nat.eq_dec i i); [exact H | easy].
      * split; [lia |]. destruct (Nat.eq_dec j0 i); [easy | exact H].
  - split.
    + intros H. split.
      * intros ->. destruct (places_equal e t _ _ t' _ _ Hx H). congruence.
      * exists t', j. split; [exact H |]. destruct (Tipo_dec t' t); [easy | reflexivity].
    + intros [_ [t0 [j0 [H M]]]]. destruct (Tipo_dec t0 t) as [-> | N0]; [| now injection M as <- <-].
      destruct (Nat.eq_dec j0 (length l - 1)); injection M as <- <-; easy.
Qed.
Lemma row_remove k y : row (remove T e) k y <-> row T k y /\ k <> e.
Proof.
  unfold row. setoid_rewrite rows_remove. split.
  - intros [t' [j [Hk [t0 [j0 [H _]]]]]]. eauto.
  - intros [[t0 [j0 H]] Hk]. exists (fst (moved t0 j0)), (snd (moved t0 j0)). split; [exact Hk |].
    exists t0, j0. split; [exact H |]. now destruct (moved t0 j0).
Qed.

Lemma remove_ok : tables_ok (remove T e).
Proof.
  split.
  - intros k t' j. setoid_rewrite rows_remove. unfold remove at 1. rewrite found. cbn. fold l.
    destruct (Elemento_dec k e) as [-> | N]; [split; [discriminate | intros [y [H _]]; easy] |].
    destruct (index T k) as [[t0 j0] |] eqn:E.
    + apply (index_exact _ ok) in E as [y Hy].
      replace (if Tipo_dec t0 t then if Nat.eq_dec j0 (length l - 1) then Some (t, i) else Some (t0, j0) else Some (t0, j0))
        with (Some (moved t0 j0)) by (unfold moved; destruct (Tipo_dec t0 t), (Nat.eq_dec j0 (length l - 1)); reflexivity).
      split.
      * intros [= M]. exists y. split; [exact N |]. exists t0, j0. now rewrite M.
      * intros [y' [_ [t1 [j1 [H M]]]]]. destruct (places_equal k _ _ _ _ _ _ Hy H) as [<- [<- _]]. now rewrite M.
    + split; [discriminate |]. intros [y [_ [t0 [j0 [H _]]]]].
      assert (E' : index T k = Some (t0, j0)) by (apply (index_exact _ ok); eauto). congruence.
  - intros k y t' j H. apply rows_remove in H as [_ [t0 [j0 [H M]]]].
    assert (t0 = t') as <-.
    { unfold moved in M. destruct (Tipo_dec t0 t); [destruct (Nat.eq_dec j0 (length l - 1)) |]; congruence. }
    exact (rows_typed _ ok _ _ _ _ H).
  - intros k y t' j H. apply rows_remove in H as [_ [t0 [j0 [H _]]]]. exact (rows_valid _ ok _ _ _ _ H).
Qed.

Lemma attribute_remove {V} (A : Shape -> set V) : attribute (remove T e) A ≡ ndres ⦃e⦄ (attribute T A).
Proof.
  intros [k v]. unfold attribute, ndres, single; cbn. setoid_rewrite row_remove. split.
  - intros [y [[H N] Hv]]. eauto.
  - intros [N [y [H Hv]]]. eauto.
Qed.
Lemma retrieve_remove : Escena_eq (scene_without _ (retrieve T) e) (retrieve (remove T e)).
Proof.
  split; cbn; try apply attribute_remove.
  - intros k. unfold diff, single. setoid_rewrite row_remove. split.
    + intros [y [H N]]. eauto.
    + intros [[y H] N]. eauto.
  - rewrite <- attribute_remove. intros t'. split; [intros [k [y [H ->]]]; exists k, y; now split |].
    intros [k [y [H E]]]. now exists k, y.
Qed.
End Removal.

(** To move the last row into the gap is to remove the element: on the scenes represented, it is the removal of the type
    that the index tells. *)
Theorem remove_commutes T e t i : tables_ok T -> index T e = Some (t, i) ->
  tables_ok (remove T e) /\
  match t with
  | soy_esfera => Eliminar_Esfera (retrieve T) (retrieve (remove T e)) e esfera_eliminada
  | soy_cilindro => Eliminar_Cilindro (retrieve T) (retrieve (remove T e)) e cilindro_eliminado
  | soy_cono => Eliminar_Cono (retrieve T) (retrieve (remove T e)) e cono_eliminado
  | soy_tronco => Eliminar_Tronco (retrieve T) (retrieve (remove T e)) e tronco_eliminado
  | soy_plano => Eliminar_Plano (retrieve T) (retrieve (remove T e)) e plano_eliminado
  | soy_disco => Eliminar_Disco (retrieve T) (retrieve (remove T e)) e disco_eliminado
  | soy_triangulo => Eliminar_Triangulo (retrieve T) (retrieve (remove T e)) e triangulo_eliminado
  end.
Proof.
  intros ok H. split; [now apply (remove_ok T e t i) |]. pose proof (retrieve_ok T ok) as okr.
  pose proof (retrieve_remove T e t i ok H) as E.
  assert (Ht : (e, t) ∈ de_que_tipo (retrieve T)) by (apply (find_correct T e ok); now exists i).
  destruct t; [apply Eliminar_Esfera_computed | apply Eliminar_Cilindro_computed | apply Eliminar_Cono_computed |
    apply Eliminar_Tronco_computed | apply Eliminar_Plano_computed | apply Eliminar_Disco_computed |
    apply Eliminar_Triangulo_computed]; auto.
Qed.
End Retrieve.
