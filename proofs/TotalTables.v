(** The total operations on the compact tables of Retrieve.v: the two general ones, and those of one type.

    shape_of t c r d h k abc == the shape of the type t with those of the attributes that it has
    first_error t …        == the first clause of the type t that does not hold, in the order of the text
    add_total, remove_total == Agregar_Elemento_Total and Eliminar_Elemento_Total, as the program carries them out
    add_total_of t, remove_total_of t == the total operations of the type t; their t? is hidden, so that they have none *)
From Coq Require Import Reals List Lra.
From Durero Require Import Toolkit Especificacion Escena Operaciones Retrieve.
Import ListNotations.
Local Open Scope zed_scope.

Definition Rmas_dec (r : R) : {Rmas r} + {~ Rmas r} := Rgt_dec r 0.
Definition Unitario_dec d : {Unitario d} + {~ Unitario d}.
Proof.
  unfold Unitario. set (q := (Vector_x d * Vector_x d + Vector_y d * Vector_y d + Vector_z d * Vector_z d)%R).
  destruct (Rle_dec (1 - tolerancia_unidad) q), (Rle_dec q (1 + tolerancia_unidad)); [left | right | right | right]; tauto.
Defined.
Definition Vertices_dec abc : {Vertices abc} + {~ Vertices abc} :=
  not_dec (and_dec (Req_EM_T _ _) (and_dec (Req_EM_T _ _) (Req_EM_T _ _))).
Definition shape_of (t : Tipo) c r d h k abc : Shape :=
  match t with
  | soy_esfera => Sphere c r
  | soy_cilindro => Cylinder c r d h
  | soy_cono => Cone c k d h
  | soy_tronco => TruncatedCone c r k d h
  | soy_plano => Plane c d
  | soy_disco => Disc c r d
  | soy_triangulo => Triangle abc
  end.
(** The first clause of the type t that does not hold, in the order of the text. *)
Definition first_error (t : Tipo) (r : R) (d : Vector) (h k : R) (abc : Terna) : option Respuesta :=
  let axis_and_height := if Unitario_dec d then if Rmas_dec h then None else Some altura_no_positiva
                         else Some vector_no_unitario in
  match t with
  | soy_esfera => if Rmas_dec r then None else Some radio_no_positivo
  | soy_cilindro => if Rmas_dec r then axis_and_height else Some radio_no_positivo
  | soy_cono => if Rmas_dec k then axis_and_height else Some proporcion_no_positiva
  | soy_tronco => if Rmas_dec r then if Rmas_dec k then axis_and_height else Some proporcion_no_positiva
                  else Some radio_no_positivo
  | soy_plano => if Unitario_dec d then None else Some vector_no_unitario
  | soy_disco => if Rmas_dec r then if Unitario_dec d then None else Some vector_no_unitario
                 else Some radio_no_positivo
  | soy_triangulo => if Vertices_dec abc then None else Some vertices_alineados
  end.

Section TotalTables.
Variable Elemento : Type.
Hypothesis Elemento_dec : forall e e' : Elemento, {e = e'} + {e <> e'}.
Notation Tables := (Tables Elemento).
Notation tables_ok := (tables_ok Elemento).
Notation index := (index Elemento).
Notation retrieve := (retrieve Elemento).
Notation add := (add Elemento Elemento_dec).
Notation remove := (remove Elemento Elemento_dec).
Implicit Types T : Tables.

Definition add_total (T : Tables) e t c r d h k abc : Tables * Respuesta :=
  match index T e with
  | Some _ => (T, elemento_ya_existe)
  | None => match first_error t r d h k abc with
            | Some a => (T, a)
            | None => (add T e (shape_of t c r d h k abc), elemento_agregado)
            end
  end.
Definition remove_total (T : Tables) e : Tables * Respuesta :=
  match index T e with None => (T, elemento_no_existe) | Some _ => (remove T e, elemento_eliminado) end.

(** What holds of one type holds of one of them. *)
Ltac one_of H := first [exact H | left; exact H | right; one_of H].

(** The program's total addition on tables is a total addition of the Z text. *)
Theorem add_total_refines T e t c r d h k abc : tables_ok T ->
  tables_ok (fst (add_total T e t c r d h k abc)) /\
  Agregar_Elemento_Total (retrieve T) (retrieve (fst (add_total T e t c r d h k abc))) e t c r d h k abc
    (snd (add_total T e t c r d h k abc)).
Proof.
  intros ok. pose proof (Xi_refl _ _ (retrieve_ok _ T ok)) as X. unfold add_total, Agregar_Elemento_Total.
  destruct (index T e) as [p |] eqn:E.
  - split; [exact ok |]. right; left. cbn. split; [exact X | | reflexivity].
    apply (find_correct _ T e ok). congruence.
  - unfold first_error. cbn.
    assert (A : valid (shape_of t c r d h k abc) -> tables_ok (add T e (shape_of t c r d h k abc)) /\
      Elemento_Agregado (retrieve T) (retrieve (add T e (shape_of t c r d h k abc))) e t c r d h k abc elemento_agregado).
    { intros V. pose proof (add_commutes _ Elemento_dec T e _ ok E V) as [ok' H]. split; [exact ok' |]. split; [| reflexivity].
      destruct t; eexists; one_of H. }
    unfold Con_Radio, Con_Vector, Con_Altura, Con_Proporcion, Con_Vertices, union, single.
    destruct t; cbn in *; repeat match goal with |- context [if ?c then _ else _] => destruct c; cbn end;
      first [destruct A as [ok' A]; [now auto |]; split; [exact ok' | left; exact A] | split; [exact ok |]];
      right; right;
      first [ solve [left; split; [now split | auto]] | solve [right; left; split; [now split | auto]]
        | solve [do 2 right; left; split; [now split | auto]] | solve [do 3 right; left; split; [now split | auto]]
        | do 4 right; split; [now split | auto] ].
Qed.

(** The program's total removal on tables is a total removal of the Z text. *)
Theorem remove_total_refines T e : tables_ok T ->
  tables_ok (fst (remove_total T e)) /\
  Eliminar_Elemento_Total (retrieve T) (retrieve (fst (remove_total T e))) e (snd (remove_total T e)).
Proof.
  intros ok. unfold remove_total, Eliminar_Elemento_Total. destruct (index T e) as [[t i] |] eqn:E; cbn.
  - destruct (remove_commutes _ Elemento_dec T e t i ok E) as [ok' H]. split; [exact ok' |]. left. split; [| reflexivity].
    destruct t; eexists; one_of H.
  - split; [exact ok |]. right. split; [apply Xi_refl, retrieve_ok, ok | | reflexivity].
    rewrite (proj1 (find_correct _ T e ok)). tauto.
Qed.

Theorem general_operations_refine T e t c r d h k abc : tables_ok T ->
  (let (T', answer) := add_total T e t c r d h k abc in
   tables_ok T' /\ Agregar_Elemento_Total (retrieve T) (retrieve T') e t c r d h k abc answer)
  /\ (let (T', answer) := remove_total T e in
   tables_ok T' /\ Eliminar_Elemento_Total (retrieve T) (retrieve T') e answer).
Proof.
  intros ok. pose proof (add_total_refines T e t c r d h k abc ok) as A. pose proof (remove_total_refines T e ok) as R.
  destruct (add_total T e t c r d h k abc), (remove_total T e). exact (conj A R).
Qed.

(** ** Of one type *)

Definition added (t : Tipo) : Respuesta :=
  match t with
  | soy_esfera => esfera_agregada
  | soy_cilindro => cilindro_agregado
  | soy_cono => cono_agregado
  | soy_tronco => tronco_agregado
  | soy_plano => plano_agregado
  | soy_disco => disco_agregado
  | soy_triangulo => triangulo_agregado
  end.
Definition removed (t : Tipo) : Respuesta :=
  match t with
  | soy_esfera => esfera_eliminada
  | soy_cilindro => cilindro_eliminado
  | soy_cono => cono_eliminado
  | soy_tronco => tronco_eliminado
  | soy_plano => plano_eliminado
  | soy_disco => disco_eliminado
  | soy_triangulo => triangulo_eliminado
  end.

Definition add_total_of (t : Tipo) T e c r d h k abc : Tables * Respuesta :=
  match index T e with
  | Some _ => (T, elemento_ya_existe)
  | None => match first_error t r d h k abc with
            | Some a => (T, a)
            | None => (add T e (shape_of t c r d h k abc), added t)
            end
  end.
Definition remove_total_of (t : Tipo) T e : Tables * Respuesta :=
  match index T e with
  | None => (T, elemento_no_existe)
  | Some (t', _) => if Tipo_dec t' t then (remove T e, removed t) else (T, tipo_incorrecto)
  end.

(** The total operations of the text, of the type t. *)
Definition Agregar_Total (t : Tipo) (s s' : Escena Elemento) e answer c r d h k abc : Prop :=
  match t with
  | soy_esfera => Agregar_Esfera_Total s s' e answer c r
  | soy_cilindro => Agregar_Cilindro_Total s s' e answer c r d h
  | soy_cono => Agregar_Cono_Total s s' e answer c k d h
  | soy_tronco => Agregar_Tronco_Total s s' e answer c r k d h
  | soy_plano => Agregar_Plano_Total s s' e answer c d
  | soy_disco => Agregar_Disco_Total s s' e answer c r d
  | soy_triangulo => Agregar_Triangulo_Total s s' e answer abc
  end.
Definition Eliminar_Total (t : Tipo) (s s' : Escena Elemento) e answer : Prop :=
  match t with
  | soy_esfera => Eliminar_Esfera_Total s s' e answer
  | soy_cilindro => Eliminar_Cilindro_Total s s' e answer
  | soy_cono => Eliminar_Cono_Total s s' e answer
  | soy_tronco => Eliminar_Tronco_Total s s' e answer
  | soy_plano => Eliminar_Plano_Total s s' e answer
  | soy_disco => Eliminar_Disco_Total s s' e answer
  | soy_triangulo => Eliminar_Triangulo_Total s s' e answer
  end.

Theorem add_total_of_refines t T e c r d h k abc : tables_ok T ->
  let (T', answer) := add_total_of t T e c r d h k abc in
  tables_ok T' /\ Agregar_Total t (retrieve T) (retrieve T') e answer c r d h k abc.
Proof.
  intros ok. pose proof (Xi_refl _ _ (retrieve_ok _ T ok)) as X. unfold add_total_of.
  destruct (index T e) as [p |] eqn:E.
  - split; [exact ok |].
    assert (Y : Elemento_Ya_Existe (retrieve T) (retrieve T) e elemento_ya_existe).
    { split; [exact X | | reflexivity]. apply (find_correct _ T e ok). congruence. }
    destruct t; right; left; exact Y.
  - unfold first_error. destruct t; cbn;
      repeat match goal with |- context [if ?c then _ else _] => destruct c; cbn end;
      first
      [ match goal with |- tables_ok (add T e ?x) /\ _ =>
          destruct (add_commutes _ Elemento_dec T e x ok E) as [ok' H];
            [cbn; auto | split; [exact ok' | left; eexists; exact H]] end
      | split; [exact ok |]; right; right;
        first [ now split | left; now split | right; left; now split | right; right; left; now split
          | right; right; right; now split | right; now split | right; right; now split ] ].
Qed.

Theorem remove_total_of_refines t T e : tables_ok T ->
  let (T', answer) := remove_total_of t T e in
  tables_ok T' /\ Eliminar_Total t (retrieve T) (retrieve T') e answer.
Proof.
  intros ok. pose proof (Xi_refl _ _ (retrieve_ok _ T ok)) as X. unfold remove_total_of.
  destruct (index T e) as [[t' i] |] eqn:E.
  - destruct (Tipo_dec t' t) as [-> | N].
    + destruct (remove_commutes _ Elemento_dec T e t i ok E) as [ok' H]. split; [exact ok' |].
      destruct t; left; exact H.
    + split; [exact ok |].
      assert (Ht : (e, t') ∈ de_que_tipo (retrieve T)) by (apply (find_correct _ T e ok); now exists i).
      assert (He : e ∈ elementos (retrieve T)) by (apply (find_correct _ T e ok); congruence).
      destruct t; right; right; (split; [exact X | exact He | now exists t' | reflexivity]).
  - split; [exact ok |].
    assert (Y : Elemento_No_Existe (retrieve T) (retrieve T) e elemento_no_existe).
    { split; [exact X | | reflexivity]. rewrite (proj1 (find_correct _ T e ok)). tauto. }
    destruct t; right; left; exact Y.
Qed.
End TotalTables.
