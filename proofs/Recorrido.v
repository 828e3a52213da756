(** * Recorrido: a traversal with pruning finds what the scan of all elements finds

    The first hit of a ray, ties included, does not depend on the acceleration structure, on the order in which its
    cells are visited, nor on the cells that are skipped. What it needs is stated once ([reachable]): on the way to
    each hit, no cell's entry lies beyond the hit.

    le a b (a <= b)        == the total order of the parameters T: exact numbers, or these with a least value that
                              stands for "no minimum" (Firsts.v). Binary64 is no instance: its comparison is neither
                              total, for NaN, nor antisymmetric, for the zeros. What runs compares binary64 limits: Walk.v
    hit_of e               == the parameter of the nearest hit of the element e, if it has one
    best_so_far            == nothing, or a parameter and the elements that attain it
    add best e             == the best once e has been tested
    scan es                == every element of es tested
    first_hit es best      == best is the first hit of es: the least parameter, and the set of elements that attain it
    cell                   == an entry bound (none: the ray misses the cell), elements listed in it, cells below it
    leads c e t            == a path from c to a cell that lists e, on which every entry is <= t
    reachable es cs        == each hit of each element of es is led to from one of the cells cs
    prunable best c        == c may be skipped: any rule that skips only what leads to no hit up to the best
    entered_beyond best c  == such a rule: the ray misses c, or enters it strictly beyond the best
    step (cs, b) (cs', b') == one cell of cs, any of them, is skipped or opened
    walks                  == any number of steps *)
From Coq Require Import List Bool Arith Lia Relations Permutation.
Import ListNotations.

Section Recorrido.

Variable T : Type.
Variable le : T -> T -> bool.
Local Notation "a <=? b" := (le a b).
Local Notation "a <= b" := (le a b = true) : type_scope.
Local Notation "a < b" := (le b a = false) : type_scope.
Hypothesis le_total : forall a b, a <= b \/ b <= a.
Hypothesis le_trans : forall a b c, a <= b -> b <= c -> a <= c.
Hypothesis le_antisym : forall a b, a <= b -> b <= a -> a = b.

Variable E : Type.
Variable hit_of : E -> option T.

Definition best_so_far := option (T * list E).

Definition add (best : best_so_far) (e : E) : best_so_far :=
  match hit_of e, best with
  | None, _ => best
  | Some t, None => Some (t, [e])
  | Some t, Some (b, es) => if t <=? b then if b <=? t then Some (b, e :: es) else Some (t, [e]) else best
  end.

Definition scan (es : list E) : best_so_far := fold_left add es None.

Definition first_hit (es : list E) (best : best_so_far) : Prop :=
  match best with
  | None => forall e, In e es -> hit_of e = None
  | Some (b, winners) =>
      winners <> [] /\
      (forall e, In e winners <-> In e es /\ hit_of e = Some b) /\
      (forall e t, In e es -> hit_of e = Some t -> b <= t)
  end.

(** ** The two halves of "first hit": what is in the best was hit, and what was tested is counted. *)

Definition sound (es : list E) (best : best_so_far) : Prop :=
  forall b winners, best = Some (b, winners) ->
  winners <> [] /\ forall e, In e winners -> In e es /\ hit_of e = Some b.

(** A hit at [t] is counted: the best is nearer, or as near and names [e]. *)
Definition counted (best : best_so_far) (e : E) (t : T) : Prop :=
  exists b winners, best = Some (b, winners) /\ b <= t /\ (t <= b -> In e winners).

Lemma le_refl a : a <= a.
Proof. destruct (le_total a a); assumption. Qed.

Lemma lt_le a b : a < b -> a <= b.
Proof. intros H; destruct (le_total a b); congruence. Qed.

Lemma first_hit_iff es best :
  first_hit es best <-> sound es best /\ forall e t, In e es -> hit_of e = Some t -> counted best e t.
Proof.
  unfold sound, counted; destruct best as [[b gs]|]; simpl; split.
  - intros (Hne & Hin & Hle); split.
    + intros b' gs' [= <- <-]; split; [assumption | intros e He; now apply Hin].
    + intros e t He Ht; exists b, gs; repeat split; eauto.
      intros Htb; apply Hin; split; [assumption|].
      rewrite Ht; f_equal; apply le_antisym; eauto.
  - intros (Hv & Hc); destruct (Hv b gs eq_refl) as [Hne Hin]; repeat split; try assumption; try (now apply Hin).
    + intros (He & Ht); destruct (Hc e b He Ht) as (b' & gs' & [= <- <-] & _ & H); apply H, le_refl.
    + intros e t He Ht; destruct (Hc e t He Ht) as (b' & gs' & [= <- <-] & H & _); exact H.
  - intros H; split; [discriminate | intros e t He Ht; rewrite (H e He) in Ht; discriminate].
  - intros (_ & Hc) e He; destruct (hit_of e) as [t|] eqn:Ht; [|reflexivity].
    destruct (Hc e t He Ht) as (? & ? & ? & _); discriminate.
Qed.

Lemma add_sound es best e : In e es -> sound es best -> sound es (add best e).
Proof.
  unfold sound, add; intros He Hv b gs; destruct (hit_of e) as [t|] eqn:Ht; [|apply Hv].
  assert (Hsolo : forall b' gs', Some (t, [e]) = Some (b', gs') ->
    gs' <> [] /\ forall e', In e' gs' -> In e' es /\ hit_of e' = Some b').
  { intros b' gs' [= <- <-]; split; [discriminate | intros e' [<-|[]]; auto]. }
  destruct best as [[b0 gs0]|]; [|apply Hsolo].
  destruct (t <=? b0) eqn:H1; [|apply Hv].
  destruct (b0 <=? t) eqn:H2; [|apply Hsolo].
  intros [= <- <-]; split; [discriminate|]; intros e' [<-|He']; [|now apply (Hv _ _ eq_refl)].
  split; [assumption | rewrite Ht; f_equal; now apply le_antisym].
Qed.

Lemma add_keeps best e e' t' : counted best e' t' -> counted (add best e) e' t'.
Proof.
  intros (b & gs & -> & Hle & Hin); unfold counted, add; destruct (hit_of e) as [t|]; [|now exists b, gs].
  destruct (t <=? b) eqn:H1; [|now exists b, gs].
  destruct (b <=? t) eqn:H2.
  - exists b, (e :: gs); repeat split; auto; intros; right; auto.
  - exists t, [e]; repeat split; [now apply (le_trans _ b)|].
    intros H; rewrite (le_trans b t' t) in H2; congruence.
Qed.

Lemma add_counts best e t : hit_of e = Some t -> counted (add best e) e t.
Proof.
  intros Ht; unfold counted, add; rewrite Ht; destruct best as [[b gs]|].
  - destruct (t <=? b) eqn:H1.
    + destruct (b <=? t) eqn:H2; eexists _, _; repeat split; auto using le_refl; now left.
    + exists b, gs; repeat split; [now apply lt_le | congruence].
  - exists t, [e]; repeat split; auto using le_refl; now left.
Qed.

Lemma add_all es es_l : incl es_l es -> forall best, sound es best ->
  sound es (fold_left add es_l best) /\
  (forall e t, counted best e t -> counted (fold_left add es_l best) e t) /\
  (forall e t, In e es_l -> hit_of e = Some t -> counted (fold_left add es_l best) e t).
Proof.
  induction es_l as [|x l IH]; intros Hincl best Hv; simpl; [now intuition|].
  destruct (IH (fun e He => Hincl e (or_intror He)) (add best x)) as (H1 & H2 & H3).
  { apply add_sound; [apply Hincl; now left | assumption]. }
  split; [assumption | split; [intros; now apply H2, add_keeps|]].
  intros e t [<-|He] Ht; [now apply H2, add_counts | now apply H3].
Qed.

(** The scan of all elements computes the first hit. *)
Theorem scan_first_hit es : first_hit es (scan es).
Proof.
  apply first_hit_iff; destruct (add_all es es (incl_refl _) None) as (H1 & _ & H3); [|now split].
  intros b gs H; discriminate.
Qed.

(** The first hit is one: two bests that are it have the same parameter and the same set of elements. Testing an
    element twice, or in another order, changes nothing: elements that span cells need no mailbox. *)
Theorem first_hit_unique es es' r r' : (forall e, In e es <-> In e es') -> first_hit es r -> first_hit es' r' ->
  match r, r' with
  | None, None => True
  | Some (b, gs), Some (b', gs') => b = b' /\ forall e, In e gs <-> In e gs'
  | _, _ => False
  end.
Proof.
  intros Hes; destruct r as [[b [|g gs]]|], r' as [[b' [|g' gs']]|]; simpl; try tauto.
  - intros (_ & Hin & Hle) (_ & Hin' & Hle').
    destruct (proj1 (Hin g) (or_introl eq_refl)) as [Hg Hgt].
    destruct (proj1 (Hin' g') (or_introl eq_refl)) as [Hg' Hgt'].
    assert (b = b') as <-.
    { apply le_antisym; [apply (Hle g') | apply (Hle' g)]; try assumption; now apply Hes. }
    split; [reflexivity | intros e; rewrite Hin, Hin'; now rewrite Hes].
  - intros (_ & Hin & _) Hno; destruct (proj1 (Hin g) (or_introl eq_refl)) as [Hg Hgt].
    rewrite (Hno g) in Hgt; [discriminate | now apply Hes].
  - intros Hno (_ & Hin & _); destruct (proj1 (Hin g') (or_introl eq_refl)) as [Hg Hgt].
    rewrite (Hno g') in Hgt; [discriminate | now apply Hes].
Qed.

(** ** Cells *)

Inductive cell := Cell (entry : option T) (elements : list E) (children : list cell).

Definition entry c := let 'Cell a _ _ := c in a.
Definition elements c := let 'Cell _ es _ := c in es.
Definition children c := let 'Cell _ _ cs := c in cs.

Inductive leads : cell -> E -> T -> Prop :=
| leads_here c a e t : entry c = Some a -> a <= t -> In e (elements c) -> leads c e t
| leads_below c a c' e t : entry c = Some a -> a <= t -> In c' (children c) -> leads c' e t -> leads c e t.

Definition reachable (es : list E) (cs : list cell) : Prop :=
  forall e t, In e es -> hit_of e = Some t -> exists c, In c cs /\ leads c e t.

(** No cell lists what is not in the scene. *)
Inductive lists_from (es : list E) : cell -> Prop :=
| lists_from_cell c : incl (elements c) es -> (forall c', In c' (children c) -> lists_from es c') -> lists_from es c.

(** A rule that skips cells; a tie is kept. *)
Variable prunable : best_so_far -> cell -> Prop.
Hypothesis prunable_right : forall best c, prunable best c ->
  forall e t, leads c e t -> hit_of e = Some t -> exists b gs, best = Some (b, gs) /\ b < t.

Inductive step : list cell * best_so_far -> list cell * best_so_far -> Prop :=
| prune cs c cs' best : prunable best c -> step (cs ++ c :: cs', best) (cs ++ cs', best)
| open cs c cs' best : step (cs ++ c :: cs', best) (cs ++ children c ++ cs', fold_left add (elements c) best).

Definition walks := clos_refl_trans_1n _ step.

(** The invariant of every traversal: each hit is counted, or a waiting cell leads to it. *)
Definition invariant (es : list E) (state : list cell * best_so_far) : Prop :=
  let (cs, best) := state in
  sound es best /\ Forall (lists_from es) cs /\
  forall e t, In e es -> hit_of e = Some t -> counted best e t \/ exists c, In c cs /\ leads c e t.

Lemma prunable_counted c best e t : prunable best c -> leads c e t -> hit_of e = Some t -> counted best e t.
Proof.
  intros Hp Hc Ht; destruct (prunable_right best c Hp e t Hc Ht) as (b & gs & -> & Hlt).
  exists b, gs; repeat split; [now apply lt_le | congruence].
Qed.

Lemma step_invariant es s s' : step s s' -> invariant es s -> invariant es s'.
Proof.
  intros []; intros (Hv & Hl & Hc); pose proof Hl as Hl'; apply Forall_app in Hl' as [Hl1 Hl2];
    inversion_clear Hl2 as [|? ? Hlc Hl3].
  - split; [assumption | split; [now apply Forall_app|]]; intros e t He Ht.
    destruct (Hc e t He Ht) as [H'|(c' & Hin & Hcon)]; [now left|].
    apply in_elt_inv in Hin as [<-|Hin]; [left; eapply prunable_counted; eauto | right; now exists c'].
  - inversion_clear Hlc as [? Hincl Hhij]; destruct (add_all es (elements c) Hincl best Hv) as (H1 & H2 & H3).
    split; [assumption | split].
    { rewrite !Forall_app; repeat split; auto; now apply Forall_forall. }
    intros e t He Ht; destruct (Hc e t He Ht) as [H'|(c' & Hin & Hcon)]; [left; now apply H2|].
    apply in_elt_inv in Hin as [<-|Hin].
    + inversion_clear Hcon as [? ? ? ? _ _ He'|? ? d ? ? _ _ Hin' Hcon']; [left; now apply H3|].
      right; exists d; split; [rewrite !in_app_iff; auto | assumption].
    + right; exists c'; split; [apply in_app_iff in Hin; rewrite !in_app_iff; tauto | assumption].
Qed.

(** The main theorem: whatever cells are skipped by the rule and in whatever order the rest are opened, once no cell
    waits the best is the first hit of all elements. *)
Theorem traversal_first_hit es cs best : Forall (lists_from es) cs -> reachable es cs ->
  walks (cs, None) ([], best) -> first_hit es best.
Proof.
  intros Hl Ha Hr; apply first_hit_iff.
  assert (Hinv : invariant es ([], best)).
  { assert (H0 : invariant es (cs, None)).
    { split; [discriminate | split; [assumption | intros; right; now apply Ha]]. }
    revert H0; induction Hr; [auto | intros; eauto using step_invariant]. }
  destruct Hinv as (Hv & _ & Hc); split; [assumption|]; intros e t He Ht.
  destruct (Hc e t He Ht) as [?|(? & [] & _)]; assumption.
Qed.

(** Every strategy ends: a step lessens the number of cells that can still be visited, and a state with a waiting
    cell has a step. *)
Fixpoint weight (c : cell) : nat := let 'Cell _ _ cs := c in S (list_sum (map weight cs)).
Definition weights (cs : list cell) : nat := list_sum (map weight cs).

Theorem step_terminates s s' : step s s' -> (weights (fst s') < weights (fst s))%nat.
Proof.
  intros [cs [a es hs] cs' best _|cs [a es hs] cs' best]; simpl; unfold weights;
    rewrite !map_app, !list_sum_app; simpl; rewrite ?map_app, ?list_sum_app; lia.
Qed.

Theorem walk_exists cs best : exists best', walks (cs, best) ([], best').
Proof.
  remember (weights cs) as n eqn:Hn; revert cs best Hn; induction n as [n IH] using lt_wf_ind; intros cs best ->.
  destruct cs as [|c cs]; [exists best; constructor|].
  pose proof (open [] c cs best) as Hp.
  destruct (IH _ (step_terminates _ _ Hp) _ (fold_left add (elements c) best) eq_refl) as (b' & Hb').
  exists b'; eapply Relation_Operators.rt1n_trans; [exact Hp | exact Hb'].
Qed.

(** A cell whose entry equals the best is not skipped; one that is entered beyond it is, and one that is missed. *)
Definition entered_beyond (best : best_so_far) (c : cell) : Prop :=
  match entry c, best with
  | None, _ => True
  | Some a, Some (b, _) => b < a
  | Some _, None => False
  end.

Lemma entered_beyond_right best c : entered_beyond best c ->
  forall e t, leads c e t -> hit_of e = Some t -> exists b gs, best = Some (b, gs) /\ b < t.
Proof.
  intros Hp e t Hc _.
  assert (exists a, entry c = Some a /\ a <= t) as (a & Ha & Hat) by (destruct Hc; eauto).
  unfold entered_beyond in Hp; rewrite Ha in Hp; destruct best as [[b gs]|]; [|contradiction].
  exists b, gs; split; [reflexivity|]; destruct (t <=? b) eqn:Htb; [|reflexivity].
  rewrite (le_trans a t b) in Hp; congruence.
Qed.

(** ** Cells met in order along the ray: grids, and trees read front to back

    A walk through cells in the order of the ray may stop early. [stretch] is a cell's stretch of the ray.  An element
    that spans cells is listed in several; its hit may lie in a later cell than the one being looked at, so a hit
    ends the walk only when it is before the end of the cell ([front_to_back]). With [<] no tie is lost in any case;
    with [<=] none is lost when an element is listed in the first cell whose closed stretch holds its hit. *)

Record stretch := Stretch { t_in : T; t_out : T; listed : list E }.

Definition stops (strict : bool) (best : best_so_far) (s : T) : bool :=
  match best with
  | None => false
  | Some (b, _) => if strict then negb (s <=? b) else b <=? s
  end.

Fixpoint front_to_back (strict : bool) (cs : list stretch) (best : best_so_far) : best_so_far :=
  match cs with
  | [] => best
  | c :: cs' =>
      let best' := fold_left add (listed c) best in
      if stops strict best' (t_out c) then best' else front_to_back strict cs' best'
  end.

(** The stretches follow one another. *)
Fixpoint in_order (cs : list stretch) : Prop :=
  match cs with
  | [] => True
  | c :: cs' => t_in c <= t_out c /\ (forall c', In c' cs' -> t_out c <= t_in c') /\ in_order cs'
  end.

(** Each hit is listed by a cell whose stretch holds it; or (second rule) by the first such cell. *)
Definition listed_somewhere (es : list E) (cs : list stretch) : Prop :=
  forall e t, In e es -> hit_of e = Some t -> exists c, In c cs /\ t_in c <= t /\ t <= t_out c /\ In e (listed c).

Definition listed_early (es : list E) (cs : list stretch) : Prop :=
  forall e t, In e es -> hit_of e = Some t ->
  exists before c after, cs = before ++ c :: after /\ In e (listed c) /\ t <= t_out c /\
  forall c', In c' before -> t_out c' < t.

Lemma front_to_back_general (strict : bool) es cs : forall best,
  Forall (fun c => incl (listed c) es) cs -> sound es best ->
  (forall e t, In e es -> hit_of e = Some t -> counted best e t \/
     exists before c after, cs = before ++ c :: after /\ In e (listed c) /\
     forall c', In c' before -> if strict then t_out c' <= t else t_out c' < t) ->
  first_hit es (front_to_back strict cs best).
Proof.
  induction cs as [|c cs IH]; intros best Hl Hv Hc; simpl.
  - apply first_hit_iff; split; [assumption|]; intros e t He Ht.
    destruct (Hc e t He Ht) as [?|(a & ? & ? & Habs & _)]; [assumption | destruct a; discriminate].
  - inversion_clear Hl as [|? ? Hlc Hl']; destruct (add_all es _ Hlc best Hv) as (H1 & H2 & H3).
    set (best' := fold_left add (listed c) best) in *.
    assert (Hsig : forall e t, In e es -> hit_of e = Some t -> counted best' e t \/
      (if strict then t_out c <= t else t_out c < t) /\
      exists before c0 after, cs = before ++ c0 :: after /\ In e (listed c0) /\
      forall c', In c' before -> if strict then t_out c' <= t else t_out c' < t).
    { intros e t He Ht; destruct (Hc e t He Ht) as [H|(before & c0 & des & Heq & Hin & Hant)]; [left; auto|].
      destruct before as [|x before]; injection Heq as -> ->; [left; auto|].
      right; split; [apply Hant; now left | exists before, c0, des; repeat split; auto].
      intros c' Hc'; apply Hant; now right. }
    destruct (stops strict best' (t_out c)) eqn:Hs.
    + apply first_hit_iff; split; [assumption|]; intros e t He Ht.
      destruct (Hsig e t He Ht) as [?|[Hsal _]]; [assumption|].
      unfold stops in Hs; destruct best' as [[b gs]|] eqn:Eb; [|discriminate]; exists b, gs.
      destruct strict.
      * apply negb_true_iff in Hs; repeat split; [now apply (le_trans _ (t_out c)); [apply lt_le|]|].
        intros Htb; rewrite (le_trans (t_out c) t b) in Hs; congruence.
      * repeat split; [now apply (le_trans _ (t_out c)); [|apply lt_le]|].
        intros Htb; rewrite (le_trans t b (t_out c)) in Hsal; congruence.
    + apply IH; auto; intros e t He Ht; destruct (Hsig e t He Ht) as [?|[_ ?]]; auto.
Qed.

(** Stop when the best lies strictly before the cell's end: right for every listing. *)
Theorem front_to_back_strict es cs : Forall (fun c => incl (listed c) es) cs -> in_order cs -> listed_somewhere es cs ->
  first_hit es (front_to_back true cs None).
Proof.
  intros Hl Ho Hc; apply front_to_back_general; [assumption | discriminate|].
  intros e t He Ht; right; destruct (Hc e t He Ht) as (c & Hin & Hent & _ & Hlis).
  apply in_split in Hin as (before & after & ->); exists before, c, after; repeat split; auto.
  clear Hl Hc; induction before as [|x before IH]; [contradiction|]; intros c' [<-|Hc'];
    destruct Ho as (_ & H & Ho); auto.
  apply (le_trans _ (t_in c)); [apply H; rewrite in_app_iff; simpl; auto | assumption].
Qed.

(** Stop when the best lies before or at the cell's end: right when the first cell that holds a hit lists it. *)
Theorem front_to_back_not_strict es cs : Forall (fun c => incl (listed c) es) cs -> listed_early es cs ->
  first_hit es (front_to_back false cs None).
Proof.
  intros Hl Hc; apply front_to_back_general; [assumption | discriminate|].
  intros e t He Ht; right; destruct (Hc e t He Ht) as (a & c & d & Heq & Hin & _ & Hant); exists a, c, d; auto.
Qed.

End Recorrido.
