(** spec/historia.tex, by hand: what leads from scene to scene, the fold of a sequence of steps, and a history of
    transactions that are undone and done again. The rules are those at the heads of Especificacion.v, Malla.v and
    Cambios.v, and further

    =, of scenes         == Escena_eq; of sets of pairs of scenes, ≡
    seq X                == lists;  s = t == same_steps s t, member by member; ⟨x⟩ ⌢ s == x :: s
    Escena ⇸ Escena      == steps: one scene at most follows one, and each stands for those that equal it
    id Escena, f ⨟ g, R* == same_scene, followed_by f g, closure R: the least of the kind that has R and the identity
    front, last, head, tail == functions of lists that are not empty: sets of pairs
    historia_escena H    == the components of H that are those of Escena *)
From Coq Require Import Reals List.
From Durero Require Import Toolkit Especificacion Cambios.
Local Open Scope zed_scope.

Section Historia.
Context {Elemento : Type}.
Notation Escena := (Especificacion.Escena Elemento).
Notation Paso := (rel Escena Escena).
Implicit Types (s t u : Escena) (f g op : Paso) (ops : list Paso) (r_out : Respuesta).

(** ** Steps *)

Definition transiciones : Paso := fun p => let s := fst p in let s' := snd p in
  (exists e tipo c rad d h k abc r_out, Elemento_Agregado s s' e tipo c rad d h k abc r_out)
  \/ (exists e r_out, Elemento_Eliminado s s' e r_out)
  \/ (exists e r_out c, Cambiar_Centro s s' e r_out c)
  \/ (exists e r_out rad, Cambiar_Radio s s' e r_out rad)
  \/ (exists e r_out d, Cambiar_Vector s s' e r_out d)
  \/ (exists e r_out h, Cambiar_Altura s s' e r_out h)
  \/ (exists e r_out k, Cambiar_Proporcion s s' e r_out k)
  \/ (exists e r_out abc, Cambiar_Vertices s s' e r_out abc).
Definition transiciones_conj_1 : Prop := inverse transiciones ≡ transiciones.

Definition same_scene : Paso := fun p => Escena_ok (fst p) /\ Escena_eq (fst p) (snd p).
Definition followed_by f g : Paso := fun p => exists t, (fst p, t) ∈ f /\ (t, snd p) ∈ g.
Definition closure (R : Paso) : Paso := fun p => forall Q : Paso,
  (forall s s', Escena_eq s s' -> (s, s') ∈ Q) -> R ⊆ Q -> followed_by Q Q ⊆ Q -> p ∈ Q.
Record steps f : Prop := {
  steps_respect : forall s s' t t', Escena_eq s s' -> Escena_eq t t' -> (s, t) ∈ f -> (s', t') ∈ f;
  steps_functional : forall s t t', (s, t) ∈ f -> (s, t') ∈ f -> Escena_eq t t';
  steps_dom : dom f ⊆ @Escena_ok Elemento;
  steps_ran : ran f ⊆ @Escena_ok Elemento
}.

Definition Operacion : set Paso := fun f => f ∈ steps /\ f ⊆ closure transiciones.

(** ** The fold *)

Definition pliegue_decl (fold : list Paso -> Paso) : Prop := forall ops, Forall Operacion ops -> fold ops ∈ steps.
Definition pliegue_def_1 (fold : list Paso -> Paso) : Prop := fold nil ≡ same_scene.
Definition pliegue_def_2 (fold : list Paso -> Paso) : Prop := forall ops op, Forall Operacion ops -> op ∈ Operacion ->
  fold (op :: ops) ≡ followed_by op (fold ops).
Fixpoint pliegue ops : Paso :=
  match ops with
  | nil => same_scene
  | op :: ops => followed_by op (pliegue ops)
  end.
Definition pliegue_conj_1 : Prop := forall ops, Forall Operacion ops -> pliegue ops ∈ Operacion.

(** ** A history *)

Definition same_steps : list Paso -> list Paso -> Prop := Forall2 seteq.
Definition front : rel (list Paso) (list Paso) := fun p => exists f, fst p = snd p ++ f :: nil.
Definition last : rel (list Paso) Paso := fun p => exists l, fst p = l ++ snd p :: nil.
Definition head : rel (list Paso) Paso := fun p => exists l, fst p = snd p :: l.
Definition tail : rel (list Paso) (list Paso) := fun p => exists f, fst p = f :: snd p.

Record Historia := mk_Historia {
  historia_escena : Escena;
  inicial : Escena;
  hechas : list Paso;
  deshechas : list Paso
}.
Implicit Types H : Historia.

Record Historia_ok H : Prop := {
  Historia_Escena : Escena_ok (historia_escena H);
  Historia_decl_inicial : Escena_ok (inicial H);
  Historia_decl_hechas : Forall Operacion (hechas H);
  Historia_decl_deshechas : Forall Operacion (deshechas H);
  Historia_inv_1 : (inicial H, historia_escena H) ∈ pliegue (hechas H);
  Historia_inv_2 : historia_escena H ∈ dom (pliegue (deshechas H))
}.
Record Historia_eq H H' : Prop := {
  Historia_eq_Escena : Escena_eq (historia_escena H) (historia_escena H');
  Historia_eq_inicial : Escena_eq (inicial H) (inicial H');
  Historia_eq_hechas : same_steps (hechas H') (hechas H);
  Historia_eq_deshechas : same_steps (deshechas H') (deshechas H)
}.
Record Delta_Historia H H' : Prop := {
  Delta_Historia_before : Historia_ok H;
  Delta_Historia_after : Historia_ok H'
}.
Record Xi_Historia H H' : Prop := {
  Xi_Historia_Delta : Delta_Historia H H';
  Xi_Historia_eq : Historia_eq H H'
}.

Record Init_Historia H' : Prop := {
  Init_Historia_Historia : Historia_ok H';
  Init_Historia_post_1 : Escena_eq (inicial H') (historia_escena H');
  Init_Historia_post_2 : hechas H' = nil;
  Init_Historia_post_3 : deshechas H' = nil
}.
Definition Init_Historia_conj_1 : Prop := forall s', Escena_ok s' ->
  exists H', Escena_eq s' (historia_escena H') /\ Init_Historia H'.

Record Seguir H H' r_out : Prop := {
  Seguir_Delta : Delta_Historia H H';
  Seguir_post_1 : Escena_eq (inicial H) (inicial H');
  Seguir_post_2 : exists s, (inicial H, s) ∈ pliegue (hechas H') /\ Escena_eq (historia_escena H') s
}.
Record Transaccion H H' ops r_out : Prop := {
  Transaccion_Seguir : Seguir H H' r_out;
  Transaccion_decl_ops : Forall Operacion ops;
  Transaccion_pre_1 : historia_escena H ∈ dom (pliegue ops);
  Transaccion_post_1 : same_steps (hechas H') (hechas H ++ pliegue ops :: nil);
  Transaccion_post_2 : deshechas H' = nil;
  Transaccion_post_3 : r_out = hecho
}.
Record Deshacer H H' r_out : Prop := {
  Deshacer_Seguir : Seguir H H' r_out;
  Deshacer_pre_1 : hechas H <> nil;
  Deshacer_post_1 : exists l, (hechas H, l) ∈ front /\ same_steps (hechas H') l;
  Deshacer_post_2 : exists f, (hechas H, f) ∈ last /\ same_steps (deshechas H') (f :: deshechas H);
  Deshacer_post_3 : r_out = deshecho
}.
Record Rehacer H H' r_out : Prop := {
  Rehacer_Seguir : Seguir H H' r_out;
  Rehacer_pre_1 : deshechas H <> nil;
  Rehacer_post_1 : exists f, (deshechas H, f) ∈ head /\ same_steps (hechas H') (hechas H ++ f :: nil);
  Rehacer_post_2 : exists l, (deshechas H, l) ∈ tail /\ same_steps (deshechas H') l;
  Rehacer_post_3 : r_out = rehecho
}.

(** ** What can go wrong, and the total operations *)

Record Transaccion_Rechazada H H' ops r_out : Prop := {
  Transaccion_Rechazada_Xi : Xi_Historia H H';
  Transaccion_Rechazada_decl_ops : Forall Operacion ops;
  Transaccion_Rechazada_pre_1 : historia_escena H ∉ dom (pliegue ops);
  Transaccion_Rechazada_post_1 : r_out = transaccion_rechazada
}.
Record Nada_Que_Deshacer H H' r_out : Prop := {
  Nada_Que_Deshacer_Xi : Xi_Historia H H';
  Nada_Que_Deshacer_pre_1 : hechas H = nil;
  Nada_Que_Deshacer_post_1 : r_out = nada_que_deshacer
}.
Record Nada_Que_Rehacer H H' r_out : Prop := {
  Nada_Que_Rehacer_Xi : Xi_Historia H H';
  Nada_Que_Rehacer_pre_1 : deshechas H = nil;
  Nada_Que_Rehacer_post_1 : r_out = nada_que_rehacer
}.

Definition Transaccion_Total H H' ops r_out : Prop :=
  Transaccion H H' ops r_out \/ Transaccion_Rechazada H H' ops r_out.
Definition Deshacer_Total H H' r_out : Prop := Deshacer H H' r_out \/ Nada_Que_Deshacer H H' r_out.
Definition Rehacer_Total H H' r_out : Prop := Rehacer H H' r_out \/ Nada_Que_Rehacer H H' r_out.

(** ** What the text claims *)

Definition Transaccion_Total_conj_1 : Prop := forall H ops, Historia_ok H -> Forall Operacion ops ->
  exists H' r_out, Transaccion_Total H H' ops r_out.
Definition Deshacer_Total_conj_1 : Prop := forall H, Historia_ok H -> exists H' r_out, Deshacer_Total H H' r_out.
Definition Rehacer_Total_conj_1 : Prop := forall H, Historia_ok H -> exists H' r_out, Rehacer_Total H H' r_out.

Definition Transaccion_conj_1 : Prop := forall H H' ops r_out, Transaccion H H' ops r_out ->
  exists H2 r_out, Deshacer H' H2 r_out /\ Escena_eq (historia_escena H) (historia_escena H2).
Definition Deshacer_conj_1 : Prop := forall H H' r_out, Deshacer H H' r_out -> exists r_out, Rehacer H' H r_out.
Definition Rehacer_conj_1 : Prop := forall H H' r_out, Rehacer H H' r_out -> exists r_out, Deshacer H' H r_out.
End Historia.
