(** spec/historia.tex: each transition is led back by one; folds are steps; the operations on a history keep its
    invariant, the total ones answer every call, and to undo and to do again are the inverses of each other. *)
From Coq Require Import Reals List Setoid Morphisms Classical_Prop.
From Durero Require Import Toolkit Especificacion Escena Operaciones Cambios Inverses Historia.
Import ListNotations.
Local Open Scope zed_scope.

Lemma list_eq_nil {X} (l : list X) : l = nil \/ exists m x, l = m ++ [x].
Proof.
  destruct (rev l) as [| x m] eqn:E; [left | right; exists (rev m), x]; rewrite <- (rev_involutive l), E; reflexivity.
Qed.

Section History.
Context {Elemento : Type}.
Notation Escena := (Especificacion.Escena Elemento).
Notation Paso := (rel Escena Escena).
Notation transiciones := (@Historia.transiciones Elemento).
Notation Operacion := (@Historia.Operacion Elemento).
Notation Historia := (@Historia.Historia Elemento).
Implicit Types (s t u : Escena) (f g op : Paso) (ops l : list Paso) (r_out : Respuesta) (H : Historia).

(** ** Transitions *)

Lemma transitions_lead_back s s' : transiciones (s, s') -> transiciones (s', s).
Proof.
  unfold Historia.transiciones. cbn. intros [T | [T | [T | [T | [T | [T | [T | T]]]]]]].
  - destruct T as (e & t & c & rad & d & h & k & abc & r_out & T). right; left. exists e.
    now apply (an_addition_is_undone_by_a_removal) in T.
  - destruct T as (e & r_out & T). apply a_removal_is_undone_by_an_addition in T as (t & _ & B). left. now exists e, t.
  - destruct T as (e & r_out & c & T). apply a_change_of_centre_is_undone in T as (v & _ & r & B).
    do 2 right; left. now exists e, r, v.
  - destruct T as (e & r_out & c & T). apply a_change_of_radius_is_undone in T as (v & _ & r & B).
    do 3 right; left. now exists e, r, v.
  - destruct T as (e & r_out & c & T). apply a_change_of_axis_is_undone in T as (v & _ & r & B).
    do 4 right; left. now exists e, r, v.
  - destruct T as (e & r_out & c & T). apply a_change_of_height_is_undone in T as (v & _ & r & B).
    do 5 right; left. now exists e, r, v.
  - destruct T as (e & r_out & c & T). apply a_change_of_proportion_is_undone in T as (v & _ & r & B).
    do 6 right; left. now exists e, r, v.
  - destruct T as (e & r_out & c & T). apply a_change_of_vertices_is_undone in T as (v & _ & r & B).
    do 7 right. now exists e, r, v.
Qed.

(** Discharges transiciones.def.1, transiciones.conj.1. *)
Theorem each_transition_is_led_back : @transiciones_conj_1 Elemento.
Proof. intros [s s']. split; apply transitions_lead_back. Qed.

(** ** Steps *)

Lemma closure_same (R : Paso) s s' : Escena_eq s s' -> closure R (s, s').
Proof. intros E Q Same _ _. now apply Same. Qed.
Lemma closure_followed (R : Paso) : followed_by (closure R) (closure R) ⊆ closure R.
Proof.
  intros [s u] [t [A B]] Q Same Has Trans. apply Trans. exists t. split; [now apply A | now apply B].
Qed.

Lemma same_scene_steps : @same_scene Elemento ∈ steps.
Proof.
  split.
  - intros s s' t t' E E' [ok B]. cbn in *. split; [now apply Escena_ok_eq with (1 := E) |].
    apply Escena_eq_trans with s; [now apply Escena_eq_sym | now apply Escena_eq_trans with t].
  - intros s t t' [_ A] [_ B]. cbn in *. apply Escena_eq_trans with s; [now apply Escena_eq_sym | exact B].
  - now intros s [t [ok _]].
  - intros t [s [ok B]]. now apply Escena_ok_eq with (1 := B).
Qed.
Lemma followed_steps f g : f ∈ steps -> g ∈ steps -> followed_by f g ∈ steps.
Proof.
  intros F G. split.
  - intros s s' t t' E E' [u [A B]]. exists u. cbn in *. split.
    + now apply (steps_respect _ F s s' u u E (Escena_eq_refl _ u)).
    + now apply (steps_respect _ G u u t t' (Escena_eq_refl _ u) E').
  - intros s t t' [u [A B]] [u' [A' B']]. cbn in *. pose proof (steps_functional _ F _ _ _ A A') as E.
    apply (steps_functional _ G u'); [| exact B']. now apply (steps_respect _ G u u' t t E (Escena_eq_refl _ t)).
  - intros s [t [u [A _]]]. apply (steps_dom _ F). now exists u.
  - intros t [s [u [_ B]]]. apply (steps_ran _ G). now exists u.
Qed.

Lemma same_scene_operation : Operacion same_scene.
Proof. split; [exact same_scene_steps | intros [s s'] [_ E]; now apply closure_same]. Qed.
Lemma followed_operation f g : Operacion f -> Operacion g -> Operacion (followed_by f g).
Proof.
  intros [F TF] [G TG]. split; [now apply followed_steps |]. intros [s u] [t [A B]]. apply closure_followed.
  exists t. split; [now apply TF | now apply TG].
Qed.

(** A step is the same for each set of pairs that equals it. *)
Lemma steps_eq f g : f ≡ g -> f ∈ steps -> g ∈ steps.
Proof.
  intros E F. split.
  - intros s s' t t' Es Et G. apply E, (steps_respect _ F s s' t t' Es Et), E, G.
  - intros s t t' G G'. apply (steps_functional _ F s); now apply E.
  - intros s [t G]. apply (steps_dom _ F). exists t. now apply E.
  - intros t [s G]. apply (steps_ran _ F). exists s. now apply E.
Qed.

(** ** Folds *)

(** The fold is a step again: what one transaction does is one step. Discharges Operacion.def.1, pliegue.conj.1. *)
Theorem a_fold_is_a_step : @pliegue_conj_1 Elemento.
Proof.
  intros ops All. induction All as [| op ops Hop _ IH]; [exact same_scene_operation |].
  now apply followed_operation.
Qed.

Lemma followed_eq f f' g g' : f ≡ f' -> g ≡ g' -> followed_by f g ≡ followed_by f' g'.
Proof.
  intros F G [s u]. unfold followed_by. cbn. split; intros [t [A B]]; exists t; (split; [now apply F | now apply G]).
Qed.

(** There is one function that is what the text says of the fold, and it is pliegue. Discharges pliegue.def.1,
    pliegue.def.2. *)
Theorem there_is_one_fold :
  (pliegue_decl (@pliegue Elemento) /\ pliegue_def_1 (@pliegue Elemento) /\ pliegue_def_2 (@pliegue Elemento))
  /\ forall fold, pliegue_def_1 fold -> pliegue_def_2 fold ->
     forall ops, Forall Operacion ops -> fold ops ≡ pliegue ops.
Proof.
  split; [split; [| split]|].
  - intros ops All. now apply a_fold_is_a_step.
  - apply seteq_refl.
  - intros ops op _ _. apply seteq_refl.
  - intros fold D1 D2 ops All. induction All as [| op ops Hop All IH]; [exact D1 |].
    apply seteq_trans with (1 := D2 ops op All Hop). now apply followed_eq.
Qed.

Lemma fold_eq ops ops' : same_steps ops ops' -> pliegue ops ≡ pliegue ops'.
Proof. intros E. induction E as [| f f' l l' E _ IH]; [reflexivity | now apply followed_eq]. Qed.

(** Steps after steps are folded one after the other. *)
Lemma fold_app ops ops' : Forall Operacion (ops ++ ops') ->
  pliegue (ops ++ ops') ≡ followed_by (pliegue ops) (pliegue ops').
Proof.
  intros All. apply Forall_app in All as [A B]. pose proof (proj1 (a_fold_is_a_step ops' B)) as G.
  induction A as [| f l Hf _ IH]; cbn [app pliegue].
  - intros [s u]. unfold followed_by. cbn. split.
    + intros K. exists s. split; [split; [| apply Escena_eq_refl] | exact K]. apply (steps_dom _ G). now exists u.
    + intros [t [[_ E] K]]. cbn in E. apply (steps_respect _ G t s u u);
        [now apply Escena_eq_sym | apply Escena_eq_refl | exact K].
  - intros [s u]. transitivity (followed_by f (followed_by (pliegue l) (pliegue ops')) (s, u)).
    + apply followed_eq; [reflexivity | exact IH].
    + unfold followed_by. cbn. split.
      * intros [t [A' [v [C D]]]]. exists v. split; [now exists t | exact D].
      * intros [v [[t [A' C]] D]]. exists t. split; [exact A' | now exists v].
Qed.
Lemma fold_last ops f s u : Forall Operacion (ops ++ [f]) ->
  (pliegue (ops ++ [f]) (s, u) <-> exists t, pliegue ops (s, t) /\ f (t, u)).
Proof.
  intros All. rewrite (fold_app ops [f] All (s, u)).
  apply Forall_app in All as [_ B]. inversion B as [| ? ? [F _] _]. subst. unfold followed_by. cbn. split; intros [t [A C]]; exists t; (split; [exact A |]).
  - destruct C as [v [C [_ E]]]. cbn in E. now apply (steps_respect _ F t t v u (Escena_eq_refl _ t) E).
  - exists u. split; [exact C | split; [| apply Escena_eq_refl]]. apply (steps_ran _ F). now exists t.
Qed.

(** ** Histories *)

Lemma same_steps_refl l : same_steps l l.
Proof. induction l as [| f l IH]; [constructor | constructor; [reflexivity | exact IH]]. Qed.
Lemma same_steps_sym l l' : same_steps l l' -> same_steps l' l.
Proof. intros E. induction E as [| f f' l l' E _ IH]; [constructor | constructor; [now symmetry | exact IH]]. Qed.
Lemma same_steps_trans l l' l2 : same_steps l l' -> same_steps l' l2 -> same_steps l l2.
Proof.
  intros E. revert l2. induction E as [| f f' l l' E _ IH]; intros l2 E2; inversion E2; subst; constructor.
  - now apply seteq_trans with f'.
  - now apply IH.
Qed.
Lemma same_steps_nil l : same_steps l nil -> l = nil.
Proof. intros E. now inversion E. Qed.
Lemma same_steps_app l l' m m' : same_steps l l' -> same_steps m m' -> same_steps (l ++ m) (l' ++ m').
Proof. intros E E'. now apply Forall2_app. Qed.
Lemma operations_eq l l' : same_steps l l' -> Forall Operacion l -> Forall Operacion l'.
Proof.
  intros E. induction E as [| f f' l l' E _ IH]; intros All; [constructor |]. inversion All as [| ? ? [F T] Rest]. subst.
  constructor; [| now apply IH]. split; [now apply steps_eq with f | intros p Hp; now apply T, E].
Qed.

Lemma Historia_eq_refl H : Historia_eq H H.
Proof. split; [apply Escena_eq_refl .. | apply same_steps_refl | apply same_steps_refl]. Qed.
Lemma Historia_eq_sym H H' : Historia_eq H H' -> Historia_eq H' H.
Proof. intros []. split; [now apply Escena_eq_sym .. | now apply same_steps_sym | now apply same_steps_sym]. Qed.

Lemma fold_steps l : Forall Operacion l -> pliegue l ∈ steps.
Proof. intros All. apply (a_fold_is_a_step l All). Qed.

(** Equal histories keep the invariant together. *)
Lemma Historia_ok_eq H H' : Historia_eq H H' -> Historia_ok H -> Historia_ok H'.
Proof.
  intros [E I A B] [ok oki A1 B1 P1 P2].
  pose proof (operations_eq _ _ (same_steps_sym _ _ A) A1) as A2.
  pose proof (operations_eq _ _ (same_steps_sym _ _ B) B1) as B2.
  split; auto; [exact (Escena_ok_eq _ _ _ E ok) | exact (Escena_ok_eq _ _ _ I oki) | |].
  - apply (fold_eq _ _ A), (steps_respect _ (fold_steps _ A1) _ _ _ _ I E), P1.
  - destruct P2 as [u P2]. exists u.
    apply (fold_eq _ _ B), (steps_respect _ (fold_steps _ B1) _ _ _ _ E (Escena_eq_refl _ u)), P2.
Qed.
Lemma Xi_Historia_refl H : Historia_ok H -> Xi_Historia H H.
Proof. intros ok. split; [now split | apply Historia_eq_refl]. Qed.

(** The scene of a history is the only one that its steps lead to from its beginning. Discharges Historia.inv.1,
    Historia.inv.2. *)
Theorem the_scene_is_the_fold_of_what_is_done H s : Historia_ok H ->
  ((inicial H, s) ∈ pliegue (hechas H) <-> Escena_eq (historia_escena H) s)
  /\ exists u, (historia_escena H, u) ∈ pliegue (deshechas H)
     /\ (inicial H, u) ∈ pliegue (hechas H ++ deshechas H).
Proof.
  intros [ok oki A B P1 [u P2]]. split; [split |].
  - intros P. exact (steps_functional _ (fold_steps _ A) _ _ _ P1 P).
  - intros E. exact (steps_respect _ (fold_steps _ A) _ _ _ _ (Escena_eq_refl _ _) E P1).
  - exists u. split; [exact P2 |]. apply fold_app; [now apply Forall_app |]. now exists (historia_escena H).
Qed.

(** Discharges Init_Historia.post.1, Init_Historia.post.2, Init_Historia.post.3, Init_Historia.conj.1. *)
Theorem every_scene_begins_a_history : @Init_Historia_conj_1 Elemento.
Proof.
  intros s ok. exists (mk_Historia s s nil nil). split; [apply Escena_eq_refl |].
  assert (Same : (s, s) ∈ same_scene) by (split; [exact ok | apply Escena_eq_refl]).
  split; cbn; try reflexivity; [| apply Escena_eq_refl]. split; cbn; auto. now exists s.
Qed.

(** A step more is done, and the scene is the one that it leads to. *)
Lemma goes_on H f s l : Historia_ok H -> Operacion f -> (historia_escena H, s) ∈ f -> Forall Operacion l ->
  s ∈ dom (pliegue l) -> Historia_ok (mk_Historia s (inicial H) (hechas H ++ [f]) l).
Proof.
  intros [ok oki A B P1 P2] Hf Hs Hl Hd. assert (A' : Forall Operacion (hechas H ++ [f])) by (apply Forall_app; auto).
  split; cbn; auto.
  - apply (steps_ran _ (proj1 Hf)). now exists (historia_escena H).
  - apply fold_last; [exact A' | now exists (historia_escena H)].
Qed.
(** The scene after an operation is the fold of its steps, as the invariant says already. *)
Lemma goes H H' r_out : Historia_ok H -> Historia_ok H' -> Escena_eq (inicial H) (inicial H') -> Seguir H H' r_out.
Proof.
  intros ok ok' I. split; [now split | exact I |]. exists (historia_escena H'). split; [| apply Escena_eq_refl].
  apply (steps_respect _ (fold_steps _ (Historia_decl_hechas _ ok')) (inicial H') _ (historia_escena H') _);
    [now apply Escena_eq_sym | apply Escena_eq_refl | apply ok'].
Qed.

(** A transaction happens exactly where its steps can, one after the other; its scene is the one that they lead to, and it
    is one step. Discharges Seguir.post.1, Seguir.post.2, Transaccion.pre.1, Transaccion.post.1, Transaccion.post.2,
    Transaccion.post.3. *)
Theorem Transaccion_computed H H' ops r_out : Transaccion H H' ops r_out <->
  Historia_ok H /\ Forall Operacion ops
  /\ (exists s, (historia_escena H, s) ∈ pliegue ops
      /\ Historia_eq (mk_Historia s (inicial H) (hechas H ++ [pliegue ops]) nil) H')
  /\ r_out = hecho.
Proof.
  split.
  - intros [[[ok ok'] I _] All [s Hs] Q1 Q2 ->]. split; [exact ok | split; [exact All | split; [| reflexivity]]].
    exists s. split; [exact Hs |]. pose proof (a_fold_is_a_step ops All) as Op.
    assert (okn : Historia_ok (mk_Historia s (inicial H) (hechas H ++ [pliegue ops]) nil)).
    { apply goes_on; auto. exists s. split; [| apply Escena_eq_refl].
      apply (steps_ran _ (proj1 Op)). now exists (historia_escena H). }
    split; cbn; auto; [| rewrite Q2; constructor].
    pose proof (Historia_inv_1 _ okn) as P. pose proof (Historia_inv_1 _ ok') as P'. cbn in P.
    apply (steps_functional _ (fold_steps _ (Historia_decl_hechas _ ok')) (inicial H')); [| exact P'].
    apply (fold_eq _ _ Q1), (steps_respect _ (fold_steps _ (Historia_decl_hechas _ okn)) _ _ s s I).
    + apply Escena_eq_refl.
    + exact P.
  - intros (ok & All & (s & Hs & E) & ->). pose proof (a_fold_is_a_step ops All) as Op.
    assert (ok' : Historia_ok H').
    { apply (Historia_ok_eq _ _ E), goes_on; auto. exists s. split; [| apply Escena_eq_refl].
      apply (steps_ran _ (proj1 Op)). now exists (historia_escena H). }
    destruct E as [E I A B]. cbn in *. split; auto; [now apply goes | now exists s |]. now apply same_steps_nil.
Qed.

(** The last step can be undone, and leads back to the scene before it. *)
Lemma goes_back H l f : Historia_ok H -> hechas H = l ++ [f] ->
  Operacion f /\ (exists s, (inicial H, s) ∈ pliegue l)
  /\ forall s, (inicial H, s) ∈ pliegue l ->
     (s, historia_escena H) ∈ f /\ Historia_ok (mk_Historia s (inicial H) l (f :: deshechas H)).
Proof.
  intros [ok oki A B P1 [u P2]] Last. rewrite Last in A, P1. destruct (proj1 (Forall_app _ _ _) A) as [A1 A2].
  inversion A2 as [| ? ? Hf _]. subst. apply fold_last in P1 as [t [Pt Ft]]; [| exact A].
  split; [exact Hf | split; [now exists t |]]. intros s Ps.
  pose proof (steps_functional _ (fold_steps _ A1) _ _ _ Pt Ps) as E.
  assert (Fs : (s, historia_escena H) ∈ f) by exact (steps_respect _ (proj1 Hf) _ _ _ _ E (Escena_eq_refl _ _) Ft).
  split; [exact Fs |]. split; cbn; auto.
  - apply (steps_dom _ (proj1 Hf)). now exists (historia_escena H).
  - exists u, (historia_escena H). now split.
Qed.
(** The first of what was undone can be done again. *)
Lemma goes_again H f l : Historia_ok H -> deshechas H = f :: l ->
  Operacion f /\ (exists s, (historia_escena H, s) ∈ f)
  /\ forall s, (historia_escena H, s) ∈ f -> Historia_ok (mk_Historia s (inicial H) (hechas H ++ [f]) l).
Proof.
  intros ok First. pose proof ok as [_ _ _ B _ [u P2]]. rewrite First in B, P2. inversion B as [| ? ? Hf Hl]. subst.
  destruct P2 as [t [Ft Pt]]. cbn in *. split; [exact Hf | split; [now exists t |]]. intros s Fs.
  apply goes_on; auto. exists u. pose proof (steps_functional _ (proj1 Hf) _ _ _ Ft Fs) as E.
  exact (steps_respect _ (fold_steps _ Hl) _ _ _ _ E (Escena_eq_refl _ u) Pt).
Qed.
(** The scene after an operation is that of its steps, whichever equal ones they are. *)
Lemma scene_after H H' l : Historia_ok H' -> Escena_eq (inicial H) (inicial H') -> same_steps (hechas H') l ->
  (inicial H, historia_escena H') ∈ pliegue l.
Proof.
  intros ok' I A. apply (fold_eq _ _ A).
  apply (steps_respect _ (fold_steps _ (Historia_decl_hechas _ ok')) (inicial H') _ (historia_escena H') _);
    [now apply Escena_eq_sym | apply Escena_eq_refl | apply ok'].
Qed.

(** Something is undone exactly where a step is done; the scene is then the fold of the steps before the last. Discharges
    Deshacer.pre.1, Deshacer.post.1, Deshacer.post.2, Deshacer.post.3. *)
Theorem Deshacer_computed H H' r_out : Deshacer H H' r_out <->
  Historia_ok H
  /\ (exists l f s, hechas H = l ++ [f] /\ (inicial H, s) ∈ pliegue l
      /\ Historia_eq (mk_Historia s (inicial H) l (f :: deshechas H)) H')
  /\ r_out = deshecho.
Proof.
  split.
  - intros [[[ok ok'] I _] _ [l [[f0 L] Q1]] [f [[l0 L'] Q2]] ->]. cbn in *. split; [exact ok | split; [| reflexivity]].
    rewrite L in L'. apply app_inj_tail in L' as [<- <-]. exists l, f0, (historia_escena H').
    split; [exact L | split; [now apply scene_after |]]. split; cbn; auto. apply Escena_eq_refl.
  - intros (ok & (l & f & s & L & Ps & E) & ->). destruct (goes_back H l f ok L) as [Hf [_ Back]].
    destruct (Back s Ps) as [_ okn]. pose proof (Historia_ok_eq _ _ E okn) as ok'. destruct E as [E I A B]. cbn in *.
    split; [now apply goes | rewrite L; now destruct l | | | reflexivity].
    + exists l. split; [now exists f | exact A].
    + exists f. split; [now exists l | exact B].
Qed.
(** Something is done again exactly where a step was undone. Discharges Rehacer.pre.1, Rehacer.post.1, Rehacer.post.2,
    Rehacer.post.3. *)
Theorem Rehacer_computed H H' r_out : Rehacer H H' r_out <->
  Historia_ok H
  /\ (exists f l s, deshechas H = f :: l /\ (historia_escena H, s) ∈ f
      /\ Historia_eq (mk_Historia s (inicial H) (hechas H ++ [f]) l) H')
  /\ r_out = rehecho.
Proof.
  split.
  - intros [[[ok ok'] I _] _ [f [[l0 L'] Q1]] [l [[f0 L] Q2]] ->]. cbn in *. split; [exact ok | split; [| reflexivity]].
    rewrite L in L'. injection L' as <- <-. exists f0, l, (historia_escena H'). split; [exact L |]. split.
    + pose proof (scene_after H H' _ ok' I Q1) as P. destruct (goes_again H f0 l ok L) as [Hf _].
      apply fold_last in P as [t [Pt Ft]]; [| apply Forall_app; split; [apply ok | auto]].
      apply (the_scene_is_the_fold_of_what_is_done H t ok) in Pt.
      apply (steps_respect _ (proj1 Hf) t _ (historia_escena H') _);
        [now apply Escena_eq_sym | apply Escena_eq_refl | exact Ft].
    + split; cbn; auto. apply Escena_eq_refl.
  - intros (ok & (f & l & s & L & Fs & E) & ->). destruct (goes_again H f l ok L) as [Hf [_ Again]].
    pose proof (Historia_ok_eq _ _ E (Again s Fs)) as ok'. destruct E as [E I A B]. cbn in *.
    split; [now apply goes | now rewrite L | | | reflexivity].
    + exists f. split; [now exists l | exact A].
    + exists l. split; [now exists f | exact B].
Qed.

(** ** Every call has an answer *)

(** Discharges Transaccion_Total.def.1, Transaccion_Total.conj.1, Transaccion_Rechazada.pre.1,
    Transaccion_Rechazada.post.1. *)
Theorem transactions_are_total : @Transaccion_Total_conj_1 Elemento.
Proof.
  intros H ops ok All. destruct (classic (historia_escena H ∈ dom (pliegue ops))) as [[s Hs] | N].
  - exists (mk_Historia s (inicial H) (hechas H ++ [pliegue ops]) nil), hecho. left. apply Transaccion_computed.
    split; [exact ok | split; [exact All | split; [| reflexivity]]]. exists s. split; [exact Hs | apply Historia_eq_refl].
  - exists H, transaccion_rechazada. right. split; auto. now apply Xi_Historia_refl.
Qed.
(** Discharges Deshacer_Total.def.1, Deshacer_Total.conj.1, Nada_Que_Deshacer.pre.1, Nada_Que_Deshacer.post.1. *)
Theorem undoing_is_total : @Deshacer_Total_conj_1 Elemento.
Proof.
  intros H ok. destruct (list_eq_nil (hechas H)) as [N | (l & f & L)].
  - exists H, nada_que_deshacer. right. split; auto. now apply Xi_Historia_refl.
  - destruct (goes_back H l f ok L) as [_ [[s Ps] _]]. exists (mk_Historia s (inicial H) l (f :: deshechas H)), deshecho.
    left. apply Deshacer_computed. split; [exact ok | split; [| reflexivity]]. exists l, f, s.
    auto using Historia_eq_refl.
Qed.
(** Discharges Rehacer_Total.def.1, Rehacer_Total.conj.1, Nada_Que_Rehacer.pre.1, Nada_Que_Rehacer.post.1. *)
Theorem doing_again_is_total : @Rehacer_Total_conj_1 Elemento.
Proof.
  intros H ok. destruct (deshechas H) as [| f l] eqn:L.
  - exists H, nada_que_rehacer. right. split; auto. now apply Xi_Historia_refl.
  - destruct (goes_again H f l ok L) as [_ [[s Fs] _]]. exists (mk_Historia s (inicial H) (hechas H ++ [f]) l), rehecho.
    left. apply Rehacer_computed. split; [exact ok | split; [| reflexivity]]. exists f, l, s. auto using Historia_eq_refl.
Qed.

(** ** To undo, and to do again *)

(** To undo a transaction gives back the scene before it, whatever it did. Discharges Transaccion.conj.1. *)
Theorem a_transaction_is_undone : @Transaccion_conj_1 Elemento.
Proof.
  intros H H' ops r_out T. pose proof (Seguir_Delta _ _ _ (Transaccion_Seguir _ _ _ _ T)) as [ok ok'].
  destruct T as [[_ I _] _ _ Q1 Q2 _].
  destruct (list_eq_nil (hechas H')) as [N | (l & f & L)].
  { rewrite N in Q1. inversion Q1 as [X |]. now destruct (hechas H). }
  destruct (goes_back H' l f ok' L) as [_ [[s Ps] _]].
  exists (mk_Historia s (inicial H') l (f :: deshechas H')), deshecho. split.
  - apply Deshacer_computed. split; [exact ok' | split; [| reflexivity]]. exists l, f, s. auto using Historia_eq_refl.
  - cbn. rewrite L in Q1. apply Forall2_app_inv_l in Q1 as (m & m' & Q & Q' & M).
    inversion Q' as [| ? g ? ? _ Q3]. subst. inversion Q3. subst. apply app_inj_tail in M as [M _]. subst m.
    apply (the_scene_is_the_fold_of_what_is_done H s ok), (fold_eq _ _ Q).
    assert (A : Forall Operacion l).
    { pose proof (Historia_decl_hechas _ ok') as A. rewrite L in A. now apply Forall_app in A. }
    apply (steps_respect _ (fold_steps _ A) (inicial H') _ s _);
      [now apply Escena_eq_sym | apply Escena_eq_refl | exact Ps].
Qed.

(** To do again what was undone gives back the whole history. Discharges Deshacer.conj.1. *)
Theorem to_do_again_gives_back_what_was_undone : @Deshacer_conj_1 Elemento.
Proof.
  intros H H' r_out D. apply Deshacer_computed in D as (ok & (l & f & s & L & Ps & E) & _).
  destruct (goes_back H l f ok L) as [Hf [_ Back]]. destruct (Back s Ps) as [Fs okn].
  pose proof (Historia_ok_eq _ _ E okn) as ok'. destruct E as [E I A B]. cbn in *. exists rehecho.
  split; [now apply goes; auto using Escena_eq_sym | intros N; rewrite N in B; inversion B | | | reflexivity].
  - destruct (deshechas H') as [| f' m] eqn:M; inversion B as [| ? ? ? ? Ef Em]. subst. exists f'.
    split; [now exists m |]. rewrite L. apply same_steps_app; [now apply same_steps_sym | constructor; [now symmetry | constructor]].
  - destruct (deshechas H') as [| f' m] eqn:M; inversion B as [| ? ? ? ? Ef Em]. subst. exists m.
    split; [now exists f' | now apply same_steps_sym].
Qed.
(** And to undo what was done again does. Discharges Rehacer.conj.1. *)
Theorem to_undo_gives_back_what_was_done_again : @Rehacer_conj_1 Elemento.
Proof.
  intros H H' r_out D. apply Rehacer_computed in D as (ok & (f & l & s & L & Fs & E) & _).
  destruct (goes_again H f l ok L) as [Hf [_ Again]].
  pose proof (Historia_ok_eq _ _ E (Again s Fs)) as ok'. destruct E as [E I A B]. cbn in *. exists deshecho.
  apply Forall2_app_inv_r in A as (m & m' & A & A' & M). inversion A' as [| f' ? ? ? Ef N]. subst. inversion N. subst.
  split; [now apply goes; auto using Escena_eq_sym | rewrite M; now destruct m | | | reflexivity].
  - exists m. split; [now exists f' | now apply same_steps_sym].
  - exists f'. split; [now exists m |]. rewrite L. constructor; [now symmetry | now apply same_steps_sym].
Qed.
End History.
