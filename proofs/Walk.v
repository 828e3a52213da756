(** * Walk: a traversal as it runs, with elements taken one by one, a limit that falls, and cells that are passed over

    Recorrido.v prunes by an exact best. What runs has only a limit, a binary64 that is not less than the first
    parameter so far, and many tests that may pass over a cell: of a box, of a stored entry, of a crossing. So here a
    state is anything, and the rule that passes over cells any that passes over nothing which still matters.

    met e t               == the ray meets the element e at the parameter t
    beyond st t           == in the state st, nothing at the parameter t matters any more
    take e st             == the state once the element e has been tested
    cell                  == the parameters of the ray in it, the elements that it lists, and the cells below it
    leads c e t           == a path from c to a cell that lists e, in cells that all hold the parameter t
    prunable st c         == a rule by which c may be passed over: any that is [prunable_right]
    visit (taken, st) e   == e is tested, unless it was: an element in many cells is tested once (the mailbox)
    walks                 == any number of steps: some cell, whichever, is passed over or opened
    plan apart cs         == the cells cs, and a cell of the elements that are tested whatever the rule says *)
From Coq Require Import Reals List Relations.
From Durero Require Import Toolkit.
Import ListNotations.
Local Open Scope R_scope.

Section Walk.
Variables E State : Type.
Hypothesis E_dec : forall e e' : E, {e = e'} + {e <> e'}.
Variable met : E -> set R.
Variable take : E -> State -> State.
Variable beyond : State -> set R.
Hypothesis beyond_stays : forall st e t, beyond st t -> beyond (take e st) t.

Inductive cell := Cell (stretch : set R) (elements : list E) (children : list cell).
Definition stretch c := let 'Cell T _ _ := c in T.
Definition elements c := let 'Cell _ es _ := c in es.
Definition children c := let 'Cell _ _ cs := c in cs.

Inductive leads : cell -> E -> R -> Prop :=
| leads_here c e t : stretch c t -> In e (elements c) -> leads c e t
| leads_below c c' e t : stretch c t -> In c' (children c) -> leads c' e t -> leads c e t.

Variable prunable : State -> cell -> Prop.
Hypothesis prunable_right : forall st c, prunable st c -> forall e t, leads c e t -> met e t -> beyond st t.

(** What was taken, the last one first, and the state after that. *)
Definition progress := (list E * State)%type.
Definition visit (s : progress) (e : E) : progress :=
  let (taken, st) := s in if in_dec E_dec e taken then s else (e :: taken, take e st).

Inductive step : list cell * progress -> list cell * progress -> Prop :=
| pass cs c cs' s : prunable (snd s) c -> step (cs ++ c :: cs', s) (cs ++ cs', s)
| open cs c cs' s : step (cs ++ c :: cs', s) (cs ++ children c ++ cs', fold_left visit (elements c) s).

Definition walks := clos_refl_trans_1n _ step.

(** Each point of each element is led to from a cell. *)
Definition reachable (es : list E) (cs : list cell) : Prop :=
  forall e t, In e es -> met e t -> exists c, In c cs /\ leads c e t.
Inductive lists_from (es : list E) : cell -> Prop :=
| lists_from_cell c : incl (elements c) es -> (forall c', In c' (children c) -> lists_from es c') -> lists_from es c.

Section Whole.
Variables (es : list E) (start : State).

(** The state is that of what was taken, in that order, each once. *)
Definition sound (s : progress) : Prop :=
  let (taken, st) := s in st = fold_right take start taken /\ NoDup taken /\ incl taken es.
Definition settled (s : progress) (e : E) (t : R) : Prop := In e (fst s) \/ beyond (snd s) t.

Lemma visit_sound s e : In e es -> sound s -> sound (visit s e).
Proof.
  destruct s as [taken st]. intros He [Hst [Hdup Hincl]]. cbn. destruct (in_dec E_dec e taken) as [H | H]; [now split |].
  split; [cbn; now rewrite Hst | split; [now constructor |]]. intros x [<- | Hx]; auto.
Qed.
Lemma visit_settles s e e' t : settled s e' t -> settled (visit s e) e' t.
Proof.
  destruct s as [taken st]. unfold settled, visit. destruct (in_dec E_dec e taken); [auto |]. cbn.
  intros [H | H]; [left; now right | right; now apply beyond_stays].
Qed.
Lemma visit_takes s e : In e (fst (visit s e)).
Proof. destruct s as [taken st]. cbn. destruct (in_dec E_dec e taken); [assumption | now left]. Qed.

Lemma visit_all l : incl l es -> forall s, sound s ->
  sound (fold_left visit l s)
  /\ (forall e t, settled s e t -> settled (fold_left visit l s) e t)
  /\ (forall e, In e l -> In e (fst (fold_left visit l s))).
Proof.
  induction l as [| x l IH]; intros Hl s Hs; [now repeat split |]. cbn [fold_left].
  destruct (IH (fun e H => Hl e (or_intror H)) (visit s x)) as [H1 [H2 H3]].
  { apply visit_sound; [apply Hl; now left | assumption]. }
  split; [assumption | split; [intros e t H; now apply H2, visit_settles |]].
  intros e [<- | He]; [| now apply H3].
  assert (K : forall l s, In x (fst s) -> In x (fst (fold_left visit l s))).
  { clear. induction l as [| y l IH]; intros s H; [exact H |]. apply IH. destruct s as [taken st]. cbn.
    destruct (in_dec E_dec y taken); [exact H | now right]. }
  apply K, visit_takes.
Qed.

(** The invariant: each point is settled, or a waiting cell leads to it. *)
Definition invariant (state : list cell * progress) : Prop :=
  let (cs, s) := state in
  sound s /\ Forall (lists_from es) cs
  /\ forall e t, In e es -> met e t -> settled s e t \/ exists c, In c cs /\ leads c e t.

Lemma step_invariant x y : step x y -> invariant x -> invariant y.
Proof.
  intros [cs c cs' s Hp | cs c cs' s] [Hs [Hl Hc]]; pose proof Hl as Hl'; apply Forall_app in Hl' as [Hl1 Hl2];
    inversion_clear Hl2 as [| ? ? Hlc Hl3].
  - split; [exact Hs | split; [now apply Forall_app |]]. intros e t He Ht.
    destruct (Hc e t He Ht) as [H | [c' [Hin Hlead]]]; [now left |].
    apply in_elt_inv in Hin as [<- | Hin]; [left; right; exact (prunable_right _ _ Hp e t Hlead Ht) | right; now exists c'].
  - inversion_clear Hlc as [? Hincl Hbelow]. destruct (visit_all (elements c) Hincl s Hs) as [H1 [H2 H3]].
    split; [exact H1 | split].
    { rewrite !Forall_app. repeat split; auto. now apply Forall_forall. }
    intros e t He Ht. destruct (Hc e t He Ht) as [H | [c' [Hin Hlead]]]; [left; now apply H2 |].
    apply in_elt_inv in Hin as [<- | Hin].
    + inversion_clear Hlead as [? ? ? _ He' | ? d ? ? _ Hin' Hlead']; [left; left; now apply H3 |].
      right. exists d. split; [rewrite !in_app_iff; auto | exact Hlead'].
    + right. exists c'. split; [apply in_app_iff in Hin; rewrite !in_app_iff; tauto | exact Hlead].
Qed.

(** Once no cell waits, whatever was passed over and in whatever order: the state is that of some elements of the
    scene, each taken once, and no point of another still matters. *)
Theorem walk_settles cs taken st : Forall (lists_from es) cs -> reachable es cs ->
  walks (cs, ([], start)) ([], (taken, st)) ->
  st = fold_right take start taken /\ NoDup taken /\ incl taken es
  /\ forall e t, In e es -> met e t -> In e taken \/ beyond st t.
Proof.
  intros Hl Hr Hw. assert (H : invariant ([], (taken, st))).
  { assert (H0 : invariant (cs, ([], start))).
    { split; [split; [reflexivity | split; [constructor | intros e []]] | split; [exact Hl |]].
      intros e t He Ht. right. now apply Hr. }
    revert H0. remember ([] : list cell, (taken, st)) as z eqn:Ez. clear Ez.
    induction Hw as [| x y z Hxy _ IH]; [auto |]. intros H. apply IH. now apply step_invariant with x. }
  destruct H as [[Hst [Hdup Hincl]] [_ Hc]]. repeat split; try assumption. intros e t He Ht.
  destruct (Hc e t He Ht) as [H | [c [[] _]]]. exact H.
Qed.

(** What is tested apart stands in a cell that holds everything: the elements that the ray starts on, since they are met
    outside their boxes, and those that the structure does not know. *)
Definition plan (apart : list E) (cs : list cell) : list cell := Cell univ apart [] :: cs.

Lemma plan_reachable apart cs : (forall e t, In e es -> ~ In e apart -> met e t -> exists c, In c cs /\ leads c e t) ->
  reachable es (plan apart cs).
Proof.
  intros H e t He Ht. destruct (in_dec E_dec e apart) as [Ha | Ha].
  - exists (Cell univ apart []). split; [now left | now apply leads_here].
  - destruct (H e t He Ha Ht) as [c [Hc Hlead]]. exists c. split; [now right | exact Hlead].
Qed.
Lemma plan_lists apart cs : incl apart es -> Forall (lists_from es) cs -> Forall (lists_from es) (plan apart cs).
Proof. intros Ha Hcs. constructor; [constructor; [exact Ha | intros c' []] | exact Hcs]. Qed.
End Whole.
End Walk.

Arguments Cell {E}.
Arguments leads {E}.
Arguments plan {E}.
Arguments lists_from {E}.
