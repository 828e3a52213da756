(** spec/malla.tex, by hand: meshes, a scene with them, its operations and what the text claims. The export covers one state
    only, so what is stated here is this file's reading of the text; its rules are those at the head of Especificacion.v,
    and further

    Red                  == two lists: numbered_is_a_list has each function that the invariants of the text allow as one
    numbered l           == the function from the numbers 0 .. #l − 1 that a list is
    terna r c t          == t = terna(r, c);  familia m r == the relation;  nameable m r == (m, r) ∈ dom familia
    nombre_cara          == a variable, of which nombre_cara_def_1 is asked
    escena S             == the components of S that are those of Escena
    replace n x l        == l ⊕ { n ↦ x }
    a label A.kind.n     == the field A_kind_n; of a definition, the definition A *)
From Coq Require Import Reals List Lia Lra Arith Setoid Morphisms Classical_Prop.
From Durero Require Import Toolkit Especificacion Escena.
Local Open Scope zed_scope.

(** ** Points and faces *)

Record Cara := mk_Cara { Cara_i : nat; Cara_j : nat; Cara_k : nat }.
Record Red := mk_Red { puntos : list Punto; caras : list Cara }.

Definition numbered {X} (l : list X) : rel nat X := fun p => nth_error l (fst p) = Some (snd p).
Definition below (n : nat) : set nat := fun i => (i < n)%nat.
Definition oplus {X Y} (f g : rel X Y) : rel X Y := fun p => g p \/ (fst p ∉ dom g /\ f p).

Lemma numbered_functional {X} (l : list X) : functional (numbered l).
Proof. intros i x y Hx Hy. unfold numbered in *. cbn in *. congruence. Qed.
Lemma dom_numbered {X} (l : list X) : dom (numbered l) ≡ below (length l).
Proof.
  intros i. unfold dom, numbered, below. cbn. rewrite <- nth_error_Some. split.
  - intros [x ->]. discriminate.
  - intros H. destruct (nth_error l i) as [x |]; [now exists x | easy].
Qed.

(** A function whose domain is 0 .. n − 1 is a list of that length, and one only; a list is such a function. So the two
    invariants of Red leave lists, and nothing else. Discharges Red.inv.1, Red.inv.2. *)
Theorem numbered_is_a_list {X} (f : rel nat X) n : functional f -> dom f ≡ below n ->
  exists l, length l = n /\ f ≡ numbered l /\ forall l', f ≡ numbered l' -> l' = l.
Proof.
  intros Ff Df.
  assert (E : exists l, length l = n /\ forall i, (i < n)%nat -> exists x, nth_error l i = Some x /\ f (i, x)).
  { clear Ff. induction n as [| n IH] in f, Df |- *.
    - exists nil. split; [reflexivity | intros i Hi; lia].
    - destruct (IH (fun p => f p /\ (fst p < n)%nat)) as [l [Ll Hl]].
      { intros i. split; [now intros [x [_ Hi]] |]. intros Hi. cbn in Hi. unfold below in Hi.
        destruct (proj2 (Df i)) as [x Hx]; [unfold below; lia | now exists x]. }
      destruct (proj2 (Df n)) as [x Hx]; [unfold below; lia |]. exists (l ++ x :: nil). split.
      + rewrite app_length. cbn. lia.
      + intros i Hi. destruct (Nat.eq_dec i n) as [-> | Ni].
        * exists x. rewrite nth_error_app2 by lia. rewrite Ll, Nat.sub_diag. now split.
        * destruct (Hl i) as [y [Hy [Fy _]]]; [lia |]. exists y. rewrite nth_error_app1 by lia. now split. }
  destruct E as [l [Ll Hl]]. exists l. split; [exact Ll |].
  assert (F : f ≡ numbered l).
  { intros [i x]. unfold numbered; cbn. split.
    - intros H. assert (Hi : (i < n)%nat) by (apply Df; now exists x). destruct (Hl i Hi) as [y [Hy Fy]].
      now rewrite (Ff _ _ _ H Fy).
    - intros H. assert (Hi : (i < n)%nat) by (rewrite <- Ll, <- nth_error_Some; congruence).
      destruct (Hl i Hi) as [y [Hy Fy]]. congruence. }
  split; [exact F |]. intros l' F'.
  assert (Same : forall i, nth_error l' i = nth_error l i).
  { intros i. destruct (nth_error l i) as [x |] eqn:E.
    - apply (F' (i, x)). now apply (F (i, x)).
    - destruct (nth_error l' i) as [y |] eqn:E'; [| reflexivity].
      assert (numbered l (i, y)) by now apply F, F'. unfold numbered in *; cbn in *; congruence. }
  clear - Same. revert l Same. induction l' as [| x l' IH]; intros [| y l] Same; [reflexivity | | |].
  - now specialize (Same 0%nat).
  - now specialize (Same 0%nat).
  - f_equal; [specialize (Same 0%nat); cbn in Same; congruence |].
    apply IH. intros i. exact (Same (S i)).
Qed.

Fixpoint replace {X} (n : nat) (x : X) (l : list X) : list X :=
  match l, n with
  | nil, _ => nil
  | _ :: l, 0%nat => x :: l
  | y :: l, S n => y :: replace n x l
  end.
Lemma length_replace {X} n (x : X) l : length (replace n x l) = length l.
Proof. revert n; induction l as [| y l IH]; intros [| n]; cbn; [easy | easy | easy | now rewrite IH]. Qed.
Lemma nth_replace {X} n (x : X) l i : (n < length l)%nat ->
  nth_error (replace n x l) i = if (i =? n)%nat then Some x else nth_error l i.
Proof.
  revert n i; induction l as [| y l IH]; intros [| n] [| i] H; cbn in *; try lia; try reflexivity.
  - now rewrite IH by lia.
Qed.
(** What the text overrides is what is replaced in the list. *)
Lemma numbered_replace {X} n (x : X) l : n ∈ dom (numbered l) ->
  numbered (replace n x l) ≡ oplus (numbered l) ⦃(n, x)⦄.
Proof.
  intros H. apply dom_numbered in H. intros [i y]. unfold numbered, oplus, single; cbn.
  rewrite nth_replace by exact H. destruct (Nat.eqb_spec i n) as [-> | N].
  - split; [intros [= ->]; now left | intros [[= ->] | [ND _]]; [reflexivity |]].
    destruct ND. exists x. reflexivity.
  - split; [intros E; right; split; [intros [z [= E' _]]; contradiction | exact E] | ].
    intros [[= E' _] | [_ E]]; [contradiction | exact E].
Qed.

Definition terna (r : Red) (c : Cara) (t : Terna) : Prop :=
  (Cara_i c, Terna_a t) ∈ numbered (puntos r) /\ (Cara_j c, Terna_b t) ∈ numbered (puntos r)
  /\ (Cara_k c, Terna_c t) ∈ numbered (puntos r).
Definition corners_of (c : Cara) : set nat := ⦃Cara_i c⦄ ∪ ⦃Cara_j c⦄ ∪ ⦃Cara_k c⦄.

Definition Completa : set Red := fun r => forall c, c ∈ ran (numbered (caras r)) -> corners_of c ⊆ dom (numbered (puntos r)).
Definition Malla : set Red := fun r =>
  r ∈ Completa /\ forall c, c ∈ ran (numbered (caras r)) -> exists t, terna r c t /\ t ∈ Vertices.

Definition movida (r : Red) (n : nat) (p : Punto) : Red := mk_Red (replace n p (puntos r)) (caras r).

(** A face has one triple at most, and one exactly where its numbers are those of points. Discharges terna.def.1. *)
Theorem a_face_has_one_triple r c :
  (forall t t', terna r c t -> terna r c t' -> t = t') /\ ((exists t, terna r c t) <-> corners_of c ⊆ dom (numbered (puntos r))).
Proof.
  split.
  - intros [a b d] [a' b' d'] [Ha [Hb Hd]] [Ha' [Hb' Hd']]. cbn in *.
    pose proof (numbered_functional (puntos r)) as F.
    now rewrite (F _ _ _ Ha Ha'), (F _ _ _ Hb Hb'), (F _ _ _ Hd Hd').
  - split.
    + intros [t [Ha [Hb Hd]]] i [[-> | ->] | ->]; eexists; eassumption.
    + intros H. destruct (H (Cara_i c)) as [a Ha]; [now left; left |].
      destruct (H (Cara_j c)) as [b Hb]; [now left; right |]. destruct (H (Cara_k c)) as [d Hd]; [now right |].
      exists (mk_Terna a b d). now split.
Qed.

Section Malla.
Variable Elemento : Type.
Notation Escena := (Especificacion.Escena Elemento).
Variable nombre_cara : rel (Elemento * nat) Elemento.
Definition nombre_cara_def_1 : Prop := functional nombre_cara /\ functional (inverse nombre_cara).
Implicit Types (s : Escena) (e m w : Elemento) (r : Red).

Definition nameable m r : Prop := r ∈ Malla /\ forall n, n ∈ dom (numbered (caras r)) -> (m, n) ∈ dom nombre_cara.
Definition familia m r : rel Elemento Terna := fun p => exists n c,
  (n, c) ∈ numbered (caras r) /\ ((m, n), fst p) ∈ nombre_cara /\ terna r c (snd p).

(** ** A scene with meshes *)

Record Mallas := mk_Mallas { escena : Escena; mallas : rel Elemento Red }.
Implicit Types S : Mallas.

Record Mallas_ok S : Prop := {
  Mallas_Escena : Escena_ok (escena S);
  Mallas_decl_mallas : mallas S ∈ (univ ⇸ Malla);
  Mallas_decl_finite : dom (mallas S) ∈ 𝔽 univ;
  Mallas_inv_1 : forall m r, (m, r) ∈ mallas S -> nameable m r;
  Mallas_inv_2 : forall m r, (m, r) ∈ mallas S -> familia m r ⊆ mi_vertices (escena S)
}.
Record Mallas_eq S S' : Prop := {
  Mallas_eq_Escena : Escena_eq (escena S) (escena S');
  Mallas_eq_mallas : mallas S' ≡ mallas S
}.
Record Xi_Mallas S S' : Prop := {
  Xi_Mallas_before : Mallas_ok S;
  Xi_Mallas_after : Mallas_ok S';
  Xi_Mallas_eq : Mallas_eq S S'
}.

Definition suyos S m : set Elemento := fun e => exists r, (m, r) ∈ mallas S /\ e ∈ dom (familia m r).
Definition de_malla S : set Elemento := fun e => exists m, m ∈ dom (mallas S) /\ e ∈ suyos S m.

Record Init_Mallas S' : Prop := {
  Init_Mallas_Init : Init (escena S');
  Init_Mallas_Mallas : Mallas_ok S';
  Init_Mallas_post_1 : mallas S' ≡ ∅
}.

(** ** The operations on meshes *)

Record Solo_Triangulos S S' : Prop := {
  Solo_Triangulos_before : Mallas_ok S;
  Solo_Triangulos_after : Mallas_ok S';
  Solo_Triangulos_post_1 : mi_centro (escena S') ≡ mi_centro (escena S);
  Solo_Triangulos_post_2 : mi_radio (escena S') ≡ mi_radio (escena S);
  Solo_Triangulos_post_3 : mi_vector (escena S') ≡ mi_vector (escena S);
  Solo_Triangulos_post_4 : mi_altura (escena S') ≡ mi_altura (escena S);
  Solo_Triangulos_post_5 : mi_proporcion (escena S') ≡ mi_proporcion (escena S)
}.

Record Agregar_Malla S S' m r (r_out : Respuesta) : Prop := {
  Agregar_Malla_Solo_Triangulos : Solo_Triangulos S S';
  Agregar_Malla_pre_1 : m ∉ dom (mallas S);
  Agregar_Malla_pre_2 : r ∈ Completa;
  Agregar_Malla_pre_3 : r ∈ Malla;
  Agregar_Malla_pre_4 : nameable m r;
  Agregar_Malla_pre_5 : dom (familia m r) ∩ elementos (escena S) ≡ ∅;
  Agregar_Malla_post_1 : elementos (escena S') ≡ elementos (escena S) ∪ dom (familia m r);
  Agregar_Malla_post_2 : de_que_tipo (escena S') ≡
    de_que_tipo (escena S) ∪ cartesian (dom (familia m r)) ⦃soy_triangulo⦄;
  Agregar_Malla_post_3 : mi_vertices (escena S') ≡ mi_vertices (escena S) ∪ familia m r;
  Agregar_Malla_post_4 : mallas S' ≡ mallas S ∪ ⦃(m, r)⦄;
  Agregar_Malla_post_5 : r_out = malla_agregada
}.

Record Eliminar_Malla S S' m (r_out : Respuesta) : Prop := {
  Eliminar_Malla_Solo_Triangulos : Solo_Triangulos S S';
  Eliminar_Malla_pre_1 : m ∈ dom (mallas S);
  Eliminar_Malla_post_1 : elementos (escena S') ≡ elementos (escena S) ∖ suyos S m;
  Eliminar_Malla_post_2 : de_que_tipo (escena S') ≡ ndres (suyos S m) (de_que_tipo (escena S));
  Eliminar_Malla_post_3 : mi_vertices (escena S') ≡ ndres (suyos S m) (mi_vertices (escena S));
  Eliminar_Malla_post_4 : mallas S' ≡ ndres ⦃m⦄ (mallas S);
  Eliminar_Malla_post_5 : r_out = malla_eliminada
}.

Record Reemplazar_Malla S S' m r (r_out : Respuesta) : Prop := {
  Reemplazar_Malla_Solo_Triangulos : Solo_Triangulos S S';
  Reemplazar_Malla_pre_1 : m ∈ dom (mallas S);
  Reemplazar_Malla_pre_2 : r ∈ Completa;
  Reemplazar_Malla_pre_3 : r ∈ Malla;
  Reemplazar_Malla_pre_4 : nameable m r;
  Reemplazar_Malla_pre_5 :
    dom (familia m r) ∩ (elementos (escena S) ∖ suyos S m) ≡ ∅;
  Reemplazar_Malla_post_1 : elementos (escena S') ≡
    elementos (escena S) ∖ suyos S m ∪ dom (familia m r);
  Reemplazar_Malla_post_2 : de_que_tipo (escena S') ≡
    ndres (suyos S m) (de_que_tipo (escena S))
    ∪ cartesian (dom (familia m r)) ⦃soy_triangulo⦄;
  Reemplazar_Malla_post_3 : mi_vertices (escena S') ≡
    ndres (suyos S m) (mi_vertices (escena S)) ∪ familia m r;
  Reemplazar_Malla_post_4 : mallas S' ≡ oplus (mallas S) ⦃(m, r)⦄;
  Reemplazar_Malla_post_5 : r_out = malla_reemplazada
}.

(** What is said of mallas(m) is said of some r, and m has that. *)
Record Mover_Vertice S S' m (n : nat) (p : Punto) (r_out : Respuesta) : Prop := {
  Mover_Vertice_Solo_Triangulos : Solo_Triangulos S S';
  Mover_Vertice_pre_1 : m ∈ dom (mallas S);
  Mover_Vertice_pre_2 : exists r, (m, r) ∈ mallas S /\ n ∈ dom (numbered (puntos r));
  Mover_Vertice_pre_3 : exists r, (m, r) ∈ mallas S /\ n ∈ dom (numbered (puntos r))
    /\ movida r n p ∈ Malla;
  Mover_Vertice_post_1 : elementos (escena S') ≡ elementos (escena S);
  Mover_Vertice_post_2 : de_que_tipo (escena S') ≡ de_que_tipo (escena S);
  Mover_Vertice_post_3 : exists r, (m, r) ∈ mallas S
    /\ mi_vertices (escena S') ≡ oplus (mi_vertices (escena S)) (familia m (movida r n p));
  Mover_Vertice_post_4 : exists r, (m, r) ∈ mallas S
    /\ mallas S' ≡ oplus (mallas S) ⦃(m, movida r n p)⦄;
  Mover_Vertice_post_5 : r_out = vertice_movido
}.

(** ** What can go wrong, and the total operations *)

Record Malla_Ya_Existe S S' m (r_out : Respuesta) : Prop := {
  Malla_Ya_Existe_Xi : Xi_Mallas S S';
  Malla_Ya_Existe_pre_1 : m ∈ dom (mallas S);
  Malla_Ya_Existe_post_1 : r_out = malla_ya_existe
}.
Record Malla_No_Existe S S' m (r_out : Respuesta) : Prop := {
  Malla_No_Existe_Xi : Xi_Mallas S S';
  Malla_No_Existe_pre_1 : m ∉ dom (mallas S);
  Malla_No_Existe_post_1 : r_out = malla_no_existe
}.
Record Cara_Incompleta S S' r (r_out : Respuesta) : Prop := {
  Cara_Incompleta_Xi : Xi_Mallas S S';
  Cara_Incompleta_pre_1 : r ∉ Completa;
  Cara_Incompleta_post_1 : r_out = cara_incompleta
}.
Record Caras_Alineadas S S' r (r_out : Respuesta) : Prop := {
  Caras_Alineadas_Xi : Xi_Mallas S S';
  Caras_Alineadas_pre_1 : r ∈ Completa;
  Caras_Alineadas_pre_2 : r ∉ Malla;
  Caras_Alineadas_post_1 : r_out = vertices_alineados
}.
Record Cara_Sin_Nombre S S' m r (r_out : Respuesta) : Prop := {
  Cara_Sin_Nombre_Xi : Xi_Mallas S S';
  Cara_Sin_Nombre_pre_1 : r ∈ Malla;
  Cara_Sin_Nombre_pre_2 : ~ nameable m r;
  Cara_Sin_Nombre_post_1 : r_out = cara_sin_nombre
}.
Record Cara_Ya_Existe S S' m r (r_out : Respuesta) : Prop := {
  Cara_Ya_Existe_Xi : Xi_Mallas S S';
  Cara_Ya_Existe_pre_1 : nameable m r;
  Cara_Ya_Existe_pre_2 :
    ~ dom (familia m r) ∩ (elementos (escena S) ∖ suyos S m) ≡ ∅;
  Cara_Ya_Existe_post_1 : r_out = elemento_ya_existe
}.
Record Vertice_No_Existe S S' m (n : nat) (r_out : Respuesta) : Prop := {
  Vertice_No_Existe_Xi : Xi_Mallas S S';
  Vertice_No_Existe_pre_1 : m ∈ dom (mallas S);
  Vertice_No_Existe_pre_2 : exists r, (m, r) ∈ mallas S /\ n ∉ dom (numbered (puntos r));
  Vertice_No_Existe_post_1 : r_out = vertice_no_existe
}.
Record Vertice_Alineado S S' m (n : nat) (p : Punto) (r_out : Respuesta) : Prop := {
  Vertice_Alineado_Xi : Xi_Mallas S S';
  Vertice_Alineado_pre_1 : m ∈ dom (mallas S);
  Vertice_Alineado_pre_2 : exists r, (m, r) ∈ mallas S /\ n ∈ dom (numbered (puntos r));
  Vertice_Alineado_pre_3 : exists r, (m, r) ∈ mallas S /\ n ∈ dom (numbered (puntos r))
    /\ movida r n p ∉ Malla;
  Vertice_Alineado_post_1 : r_out = vertices_alineados
}.

Definition Agregar_Malla_Total S S' m r r_out : Prop :=
  Agregar_Malla S S' m r r_out \/ Malla_Ya_Existe S S' m r_out \/ Cara_Incompleta S S' r r_out
  \/ Caras_Alineadas S S' r r_out \/ Cara_Sin_Nombre S S' m r r_out \/ Cara_Ya_Existe S S' m r r_out.
Definition Eliminar_Malla_Total S S' m r_out : Prop :=
  Eliminar_Malla S S' m r_out \/ Malla_No_Existe S S' m r_out.
Definition Reemplazar_Malla_Total S S' m r r_out : Prop :=
  Reemplazar_Malla S S' m r r_out \/ Malla_No_Existe S S' m r_out \/ Cara_Incompleta S S' r r_out
  \/ Caras_Alineadas S S' r r_out \/ Cara_Sin_Nombre S S' m r r_out \/ Cara_Ya_Existe S S' m r r_out.
Definition Mover_Vertice_Total S S' m n p r_out : Prop :=
  Mover_Vertice S S' m n p r_out \/ Malla_No_Existe S S' m r_out \/ Vertice_No_Existe S S' m n r_out
  \/ Vertice_Alineado S S' m n p r_out.

(** ** The operations of single elements *)

Record Mismas_Mallas S S' : Prop := {
  Mismas_Mallas_before : Mallas_ok S;
  Mismas_Mallas_after : Mallas_ok S';
  Mismas_Mallas_post_1 : mallas S' ≡ mallas S
}.
Record Fuera_De_Malla S e : Prop := {
  Fuera_De_Malla_Mallas : Mallas_ok S;
  Fuera_De_Malla_pre_1 : e ∉ de_malla S
}.
Record Es_De_Malla S S' e (r_out : Respuesta) : Prop := {
  Es_De_Malla_Xi : Xi_Mallas S S';
  Es_De_Malla_pre_1 : e ∈ de_malla S;
  Es_De_Malla_post_1 : r_out = es_de_malla
}.

Definition Agregar_Esfera_Mallas S S' e (r_out : Respuesta) c rad : Prop :=
  Agregar_Esfera_Total (escena S) (escena S') e r_out c rad /\ Mismas_Mallas S S'.
Definition Agregar_Cilindro_Mallas S S' e (r_out : Respuesta) c rad d h : Prop :=
  Agregar_Cilindro_Total (escena S) (escena S') e r_out c rad d h /\ Mismas_Mallas S S'.
Definition Agregar_Cono_Mallas S S' e (r_out : Respuesta) c k d h : Prop :=
  Agregar_Cono_Total (escena S) (escena S') e r_out c k d h /\ Mismas_Mallas S S'.
Definition Agregar_Tronco_Mallas S S' e (r_out : Respuesta) c rad k d h : Prop :=
  Agregar_Tronco_Total (escena S) (escena S') e r_out c rad k d h /\ Mismas_Mallas S S'.
Definition Agregar_Plano_Mallas S S' e (r_out : Respuesta) c d : Prop :=
  Agregar_Plano_Total (escena S) (escena S') e r_out c d /\ Mismas_Mallas S S'.
Definition Agregar_Disco_Mallas S S' e (r_out : Respuesta) c rad d : Prop :=
  Agregar_Disco_Total (escena S) (escena S') e r_out c rad d /\ Mismas_Mallas S S'.
Definition Agregar_Triangulo_Mallas S S' e (r_out : Respuesta) abc : Prop :=
  Agregar_Triangulo_Total (escena S) (escena S') e r_out abc /\ Mismas_Mallas S S'.
Definition Agregar_Elemento_Mallas S S' e t c rad d h k abc (r_out : Respuesta) : Prop :=
  Agregar_Elemento_Total (escena S) (escena S') e t c rad d h k abc r_out /\ Mismas_Mallas S S'.
Definition Eliminar_Esfera_Mallas S S' e (r_out : Respuesta) : Prop :=
  (Eliminar_Esfera_Total (escena S) (escena S') e r_out /\ Mismas_Mallas S S' /\ Fuera_De_Malla S e)
  \/ Es_De_Malla S S' e r_out.
Definition Eliminar_Cilindro_Mallas S S' e (r_out : Respuesta) : Prop :=
  (Eliminar_Cilindro_Total (escena S) (escena S') e r_out /\ Mismas_Mallas S S' /\ Fuera_De_Malla S e)
  \/ Es_De_Malla S S' e r_out.
Definition Eliminar_Cono_Mallas S S' e (r_out : Respuesta) : Prop :=
  (Eliminar_Cono_Total (escena S) (escena S') e r_out /\ Mismas_Mallas S S' /\ Fuera_De_Malla S e)
  \/ Es_De_Malla S S' e r_out.
Definition Eliminar_Tronco_Mallas S S' e (r_out : Respuesta) : Prop :=
  (Eliminar_Tronco_Total (escena S) (escena S') e r_out /\ Mismas_Mallas S S' /\ Fuera_De_Malla S e)
  \/ Es_De_Malla S S' e r_out.
Definition Eliminar_Plano_Mallas S S' e (r_out : Respuesta) : Prop :=
  (Eliminar_Plano_Total (escena S) (escena S') e r_out /\ Mismas_Mallas S S' /\ Fuera_De_Malla S e)
  \/ Es_De_Malla S S' e r_out.
Definition Eliminar_Disco_Mallas S S' e (r_out : Respuesta) : Prop :=
  (Eliminar_Disco_Total (escena S) (escena S') e r_out /\ Mismas_Mallas S S' /\ Fuera_De_Malla S e)
  \/ Es_De_Malla S S' e r_out.
Definition Eliminar_Triangulo_Mallas S S' e (r_out : Respuesta) : Prop :=
  (Eliminar_Triangulo_Total (escena S) (escena S') e r_out /\ Mismas_Mallas S S' /\ Fuera_De_Malla S e)
  \/ Es_De_Malla S S' e r_out.
Definition Eliminar_Elemento_Mallas S S' e (r_out : Respuesta) : Prop :=
  (Eliminar_Elemento_Total (escena S) (escena S') e r_out /\ Mismas_Mallas S S' /\ Fuera_De_Malla S e)
  \/ Es_De_Malla S S' e r_out.

(** ** What is of no mesh *)

Definition sueltas S : Escena := {|
  elementos := elementos (escena S) ∖ de_malla S;
  tipos := ran (ndres (de_malla S) (de_que_tipo (escena S)));
  de_que_tipo := ndres (de_malla S) (de_que_tipo (escena S));
  mi_centro := mi_centro (escena S);
  mi_radio := mi_radio (escena S);
  mi_vector := mi_vector (escena S);
  mi_altura := mi_altura (escena S);
  mi_proporcion := mi_proporcion (escena S);
  mi_vertices := ndres (de_malla S) (mi_vertices (escena S))
|}.

(** ** What the text claims *)

Definition sueltas_conj_1 : Prop := forall S, Mallas_ok S -> Escena_ok (sueltas S).
Definition sueltas_conj_2 : Prop := forall S S', Mallas_ok S -> Mallas_ok S' ->
  Escena_eq (sueltas S) (sueltas S') /\ mallas S' ≡ mallas S -> Mallas_eq S S'.
Definition sueltas_conj_3 : Prop := forall s (f : rel Elemento Red),
  Escena_ok s -> f ∈ (univ ⇸ Malla) -> dom f ∈ 𝔽 univ ->
  (forall m r, (m, r) ∈ f -> nameable m r) /\ (forall m r, (m, r) ∈ f -> dom (familia m r) ∩ elementos s ≡ ∅) ->
  exists S, Mallas_ok S /\ Escena_eq s (sueltas S) /\ mallas S ≡ f.
Definition sueltas_conj_4 : Prop := forall S S' m r r_out, Agregar_Malla S S' m r r_out -> Escena_eq (sueltas S) (sueltas S').
Definition sueltas_conj_5 : Prop := forall S S' m r_out, Eliminar_Malla S S' m r_out -> Escena_eq (sueltas S) (sueltas S').
Definition sueltas_conj_6 : Prop := forall S S' m r r_out,
  Reemplazar_Malla S S' m r r_out -> Escena_eq (sueltas S) (sueltas S').
Definition sueltas_conj_7 : Prop := forall S S' m n p r_out,
  Mover_Vertice S S' m n p r_out -> Escena_eq (sueltas S) (sueltas S').
Definition sueltas_conj_8 : Prop := forall S S', Mismas_Mallas S S' ->
  dres (de_malla S') (mi_vertices (escena S')) ≡ dres (de_malla S) (mi_vertices (escena S)).

Definition Init_Mallas_conj_1 : Prop := exists S', Init_Mallas S'.
Definition suyos_conj_1 : Prop := forall S m w, Mallas_ok S -> m <> w -> suyos S m ∩ suyos S w ≡ ∅.
Definition de_malla_conj_1 : Prop := forall S, Mallas_ok S ->
  de_malla S ⊆ image (inverse (de_que_tipo (escena S))) ⦃soy_triangulo⦄.

Definition Agregar_Malla_Total_conj_1 : Prop := forall S m r, Mallas_ok S ->
  exists S' r_out, Agregar_Malla_Total S S' m r r_out.
Definition Eliminar_Malla_Total_conj_1 : Prop := forall S m, Mallas_ok S ->
  exists S' r_out, Eliminar_Malla_Total S S' m r_out.
Definition Reemplazar_Malla_Total_conj_1 : Prop := forall S m r, Mallas_ok S ->
  exists S' r_out, Reemplazar_Malla_Total S S' m r r_out.
Definition Mover_Vertice_Total_conj_1 : Prop := forall S m n p, Mallas_ok S ->
  exists S' r_out, Mover_Vertice_Total S S' m n p r_out.

Definition Eliminar_Malla_conj_1 : Prop := forall S S' m r, Mallas_ok S -> Mallas_ok S' ->
  (exists T r_out, Agregar_Malla S T m r r_out) ->
  ((exists T, (exists r_out, Agregar_Malla S T m r r_out) /\ exists r_out, Eliminar_Malla T S' m r_out) <->
   Mallas_eq S S').
Definition Reemplazar_Malla_conj_1 : Prop := forall S S' m r, Mallas_ok S -> Mallas_ok S' ->
  ((exists r_out, Reemplazar_Malla S S' m r r_out) <->
   exists T, (exists r_out, Eliminar_Malla S T m r_out) /\ exists r_out, Agregar_Malla T S' m r r_out).
Definition Mover_Vertice_conj_1 : Prop := forall S S' m n p r, Mallas_ok S -> Mallas_ok S' ->
  m ∈ dom (mallas S) /\ (exists q, (m, q) ∈ mallas S /\ n ∈ dom (numbered (puntos q)))
  /\ (exists q, (m, q) ∈ mallas S /\ n ∈ dom (numbered (puntos q)) /\ r = movida q n p) ->
  ((exists r_out, Mover_Vertice S S' m n p r_out) <-> exists r_out, Reemplazar_Malla S S' m r r_out).

Definition Agregar_Esfera_Mallas_conj_1 : Prop := forall S e c rad, Mallas_ok S ->
  exists S' r_out, Agregar_Esfera_Mallas S S' e r_out c rad.
Definition Agregar_Cilindro_Mallas_conj_1 : Prop := forall S e c rad d h, Mallas_ok S ->
  exists S' r_out, Agregar_Cilindro_Mallas S S' e r_out c rad d h.
Definition Agregar_Cono_Mallas_conj_1 : Prop := forall S e c k d h, Mallas_ok S ->
  exists S' r_out, Agregar_Cono_Mallas S S' e r_out c k d h.
Definition Agregar_Tronco_Mallas_conj_1 : Prop := forall S e c rad k d h, Mallas_ok S ->
  exists S' r_out, Agregar_Tronco_Mallas S S' e r_out c rad k d h.
Definition Agregar_Plano_Mallas_conj_1 : Prop := forall S e c d, Mallas_ok S ->
  exists S' r_out, Agregar_Plano_Mallas S S' e r_out c d.
Definition Agregar_Disco_Mallas_conj_1 : Prop := forall S e c rad d, Mallas_ok S ->
  exists S' r_out, Agregar_Disco_Mallas S S' e r_out c rad d.
Definition Agregar_Triangulo_Mallas_conj_1 : Prop := forall S e abc, Mallas_ok S ->
  exists S' r_out, Agregar_Triangulo_Mallas S S' e r_out abc.
Definition Agregar_Elemento_Mallas_conj_1 : Prop := forall S e t c rad d h k abc, Mallas_ok S ->
  exists S' r_out, Agregar_Elemento_Mallas S S' e t c rad d h k abc r_out.
Definition Eliminar_Esfera_Mallas_conj_1 : Prop := forall S e, Mallas_ok S ->
  exists S' r_out, Eliminar_Esfera_Mallas S S' e r_out.
Definition Eliminar_Cilindro_Mallas_conj_1 : Prop := forall S e, Mallas_ok S ->
  exists S' r_out, Eliminar_Cilindro_Mallas S S' e r_out.
Definition Eliminar_Cono_Mallas_conj_1 : Prop := forall S e, Mallas_ok S ->
  exists S' r_out, Eliminar_Cono_Mallas S S' e r_out.
Definition Eliminar_Tronco_Mallas_conj_1 : Prop := forall S e, Mallas_ok S ->
  exists S' r_out, Eliminar_Tronco_Mallas S S' e r_out.
Definition Eliminar_Plano_Mallas_conj_1 : Prop := forall S e, Mallas_ok S ->
  exists S' r_out, Eliminar_Plano_Mallas S S' e r_out.
Definition Eliminar_Disco_Mallas_conj_1 : Prop := forall S e, Mallas_ok S ->
  exists S' r_out, Eliminar_Disco_Mallas S S' e r_out.
Definition Eliminar_Triangulo_Mallas_conj_1 : Prop := forall S e, Mallas_ok S ->
  exists S' r_out, Eliminar_Triangulo_Mallas S S' e r_out.
Definition Eliminar_Elemento_Mallas_conj_1 : Prop := forall S e, Mallas_ok S ->
  exists S' r_out, Eliminar_Elemento_Mallas S S' e r_out.
End Malla.

(** ** The edges of triangles, and the line of a ray *)
Local Open Scope R_scope.
Local Open Scope zed_scope.

Definition giro (ray : Rayo) (a b : Punto) : R :=
  let p := Rayo_p ray in let v := Rayo_v ray in
  Vector_x v * ((Punto_y a - Punto_y p) * (Punto_z b - Punto_z p) - (Punto_z a - Punto_z p) * (Punto_y b - Punto_y p))
  + Vector_y v * ((Punto_z a - Punto_z p) * (Punto_x b - Punto_x p) - (Punto_x a - Punto_x p) * (Punto_z b - Punto_z p))
  + Vector_z v * ((Punto_x a - Punto_x p) * (Punto_y b - Punto_y p) - (Punto_y a - Punto_y p) * (Punto_x b - Punto_x p)).
Definition cruce (ray : Rayo) (v : Terna) : R :=
  giro ray (Terna_a v) (Terna_b v) + giro ray (Terna_b v) (Terna_c v) + giro ray (Terna_c v) (Terna_a v).
Definition recta (ray : Rayo) : set Punto := fun w => exists t,
  Punto_x w = Punto_x (Rayo_p ray) + t * Vector_x (Rayo_v ray)
  /\ Punto_y w = Punto_y (Rayo_p ray) + t * Vector_y (Rayo_v ray)
  /\ Punto_z w = Punto_z (Rayo_p ray) + t * Vector_z (Rayo_v ray).

Definition giro_conj_1 : Prop := forall ray a b, ray ∈ Rayo_ok -> giro ray a b + giro ray b a = 0.
Definition giro_conj_2 : Prop := forall ray v, ray ∈ Rayo_ok -> v ∈ Vertices -> cruce ray v <> 0 ->
  (~ recta ray ∩ puntos_triangulo v ≡ ∅ <->
   (giro ray (Terna_a v) (Terna_b v) >= 0 /\ giro ray (Terna_b v) (Terna_c v) >= 0
    /\ giro ray (Terna_c v) (Terna_a v) >= 0)
   \/ (giro ray (Terna_a v) (Terna_b v) <= 0 /\ giro ray (Terna_b v) (Terna_c v) <= 0
    /\ giro ray (Terna_c v) (Terna_a v) <= 0)).
Definition Vecinos (v w : Terna) : Prop :=
  v ∈ Vertices /\ w ∈ Vertices /\ Terna_a w = Terna_b v /\ Terna_b w = Terna_a v.
Definition giro_conj_3 : Prop := forall ray v w, ray ∈ Rayo_ok -> Vecinos v w ->
  cruce ray v <> 0 /\ cruce ray w <> 0
  /\ ((giro ray (Terna_b v) (Terna_c v) >= 0 /\ giro ray (Terna_c v) (Terna_a v) >= 0
       /\ giro ray (Terna_b w) (Terna_c w) >= 0 /\ giro ray (Terna_c w) (Terna_a w) >= 0)
      \/ (giro ray (Terna_b v) (Terna_c v) <= 0 /\ giro ray (Terna_c v) (Terna_a v) <= 0
       /\ giro ray (Terna_b w) (Terna_c w) <= 0 /\ giro ray (Terna_c w) (Terna_a w) <= 0)) ->
  ~ recta ray ∩ (puntos_triangulo v ∪ puntos_triangulo w) ≡ ∅.
Definition giro_conj_4 : Prop := forall ray v w, ray ∈ Rayo_ok -> Vecinos v w ->
  cruce ray v <> 0 /\ giro ray (Terna_a v) (Terna_b v) = 0 ->
  recta ray ∩ puntos_triangulo v ⊆ puntos_triangulo w.
