(** spec/historia.tex: what one operation with its inputs makes of scenes is a step, and what a transaction does can be
    undone and done again.

    transition_of P      == the scenes of which P says that the one leads to the other *)
From Coq Require Import Reals List Setoid Classical_Prop.
From Durero Require Import Toolkit Especificacion Escena Operaciones Edits Cambios Changes Inverses Historia History.
Import ListNotations.
Local Open Scope zed_scope.

Section Transactions.
Context {Elemento : Type}.
Notation Escena := (Especificacion.Escena Elemento).
Notation Paso := (rel Escena Escena).
Notation Operacion := (@Historia.Operacion Elemento).
Notation Historia := (@Historia.Historia Elemento).
Implicit Types (s u : Escena) (e : Elemento) (t : Tipo) (c : Punto) (rad h k : R) (d : Vector) (abc : Terna)
  (ops : list Paso) (H : Historia).

Definition transition_of (P : Escena -> Escena -> Respuesta -> Prop) : Paso := fun p =>
  exists r_out, P (fst p) (snd p) r_out.

(** An operation that has one after-state, of equal scenes an equal one, and leads from scene to scene as a transition. *)
Lemma step_of P (possible : Escena -> Prop) (after : Escena -> Escena) r :
  (forall s s' r_out, P s s' r_out <-> possible s /\ Escena_eq (after s) s' /\ r_out = r) ->
  (forall s s', Escena_eq s s' -> possible s -> possible s') ->
  (forall s s', Escena_eq s s' -> Escena_eq (after s) (after s')) ->
  (forall s s' r_out, P s s' r_out -> Escena_ok s /\ Escena_ok s') ->
  (forall s s' r_out, P s s' r_out -> transiciones (s, s')) -> Operacion (transition_of P).
Proof.
  intros C Q A Ok T. split; [split |].
  - intros s s' u u' E E' [r_out K]. exists r_out. cbn in *. apply C in K as [K [K' ->]]. apply C.
    split; [now apply (Q s) | split; [| reflexivity]].
    apply Escena_eq_trans with (after s); [now apply A, Escena_eq_sym | now apply Escena_eq_trans with u].
  - intros s u u' [r1 K1] [r2 K2]. cbn in *. apply C in K1 as [_ [K1 _]], K2 as [_ [K2 _]].
    apply Escena_eq_trans with (after s); [now apply Escena_eq_sym | exact K2].
  - intros s [u [r_out K]]. apply (Ok _ _ _ K).
  - intros u [s [r_out K]]. apply (Ok _ _ _ K).
  - intros [s u] [r_out K] R _ Has _. apply Has, (T _ _ _ K).
Qed.

Ltac changed computed := eapply step_of with (r := elemento_cambiado);
  [ intros s s' r_out; apply computed
  | intros s s' E C; cbn beta in *; decompose [and] C; pose proof (Escena_ok_eq _ _ _ E ltac:(assumption)); destruct E;
    repeat lazymatch goal with |- _ /\ _ => split end; try assumption;
    lazymatch goal with
    | K : ?f ≡ _ |- dom ?f _ => now apply (dom_proper _ _ K)
    | K : ?f ≡ _ |- ?f _ => now apply K
    end
  | intros s s' E; now apply scene_changed_eq
  | intros s s' r_out K; split; apply K
  | intros s s' r_out K; unfold transiciones; cbn ].

(** One operation with its inputs is a step of a history. *)
Theorem operations_are_steps e t c rad d h k abc :
  Operacion (transition_of (fun s s' => Elemento_Agregado s s' e t c rad d h k abc))
  /\ Operacion (transition_of (fun s s' => Elemento_Eliminado s s' e))
  /\ Operacion (transition_of (fun s s' r_out => Cambiar_Centro s s' e r_out c))
  /\ Operacion (transition_of (fun s s' r_out => Cambiar_Radio s s' e r_out rad))
  /\ Operacion (transition_of (fun s s' r_out => Cambiar_Vector s s' e r_out d))
  /\ Operacion (transition_of (fun s s' r_out => Cambiar_Altura s s' e r_out h))
  /\ Operacion (transition_of (fun s s' r_out => Cambiar_Proporcion s s' e r_out k))
  /\ Operacion (transition_of (fun s s' r_out => Cambiar_Vertices s s' e r_out abc)).
Proof.
  repeat match goal with |- _ /\ _ => split end.
  - eapply step_of with (r := elemento_agregado).
    + intros s s' r_out. apply Elemento_Agregado_computed.
    + intros s s' E. now apply addition_possible_eq.
    + intros s s' E. now apply scene_added_eq.
    + intros s s' r_out K. destruct (proj1 K) as [r0 K']. repeat destruct K' as [K' | K']; split; apply K'.
    + intros s s' r_out K. unfold transiciones; cbn. left. now exists e, t, c, rad, d, h, k, abc, r_out.
  - eapply step_of with (r := elemento_eliminado).
    + intros s s' r_out. apply Elemento_Eliminado_computed.
    + intros s s' E [ok He]. split; [now apply Escena_ok_eq with (1 := E) | now apply (Escena_eq_elementos E)].
    + intros s s' E. now apply scene_without_eq.
    + intros s s' r_out K. destruct (proj1 K) as [r0 K']. repeat destruct K' as [K' | K']; split; apply K'.
    + intros s s' r_out K. unfold transiciones; cbn. right; left. now exists e, r_out.
  - changed (@Cambiar_Centro_computed Elemento). do 2 right; left; now exists e, r_out, c.
  - changed (@Cambiar_Radio_computed Elemento). do 3 right; left; now exists e, r_out, rad.
  - changed (@Cambiar_Vector_computed Elemento). do 4 right; left; now exists e, r_out, d.
  - changed (@Cambiar_Altura_computed Elemento). do 5 right; left; now exists e, r_out, h.
  - changed (@Cambiar_Proporcion_computed Elemento). do 6 right; left; now exists e, r_out, k.
  - changed (@Cambiar_Vertices_computed Elemento). do 7 right; now exists e, r_out, abc.
Qed.

(** A transaction happens where its steps can; it is undone, which gives back the scene, and done again, which
    gives back the history. *)
Theorem a_transaction_is_undone_and_done_again H ops : Historia_ok H -> Forall Operacion ops ->
  historia_escena H ∈ dom (pliegue ops) ->
  exists H1 H2 H3, Transaccion H H1 ops hecho
  /\ Deshacer H1 H2 deshecho /\ Escena_eq (historia_escena H) (historia_escena H2)
  /\ Rehacer H2 H3 rehecho /\ Historia_eq H1 H3.
Proof.
  intros ok All [s Hs]. set (H1 := mk_Historia s (inicial H) (hechas H ++ [pliegue ops]) nil).
  assert (T : Transaccion H H1 ops hecho).
  { apply Transaccion_computed. split; [exact ok | split; [exact All | split; [| reflexivity]]].
    exists s. split; [exact Hs | apply Historia_eq_refl]. }
  destruct (a_transaction_is_undone _ _ _ _ T) as (H2 & r2 & D & E).
  destruct (to_do_again_gives_back_what_was_undone _ _ _ D) as [r3 B].
  exists H1, H2, H1. split; [exact T |]. rewrite <- (Deshacer_post_3 _ _ _ D), <- (Rehacer_post_3 _ _ _ B).
  auto using Historia_eq_refl.
Qed.
End Transactions.
