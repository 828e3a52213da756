(** * Trees: the walks of a ray through an octree and a tree of planes pass over no leaf that holds a point of it

    The model of accel/bsp.hpp and accel/octree.hpp, branch by branch, over any crossings that are compared in the order
    of their events (Line.v).

    halved, walk_halves    == a tree of planes, and Bsp::Walk: the leaves in their order, each with its entry
    eighths, walk_eighths  == an octree, and Octree::Walk;  next_of == the loop over the three middle planes
    in_half m n a          == at the moment m the ray is in the leaf n of the tree a;  in_eighth: of an octree
    entered k e            == the leaf k is entered at the moment e
    covers inside m A w    == the walk w, from the moment m to the event A, is in order, and leaves nothing out *)
From Coq Require Import Reals List Bool Lra Lia Sorted.
From Durero Require Import Acceleration Moments Line.
Import ListNotations.
Local Open Scope R_scope.

Section Trees.
Variables p v : axis -> R.
Variable line : line p v.
Variable Leaf : Type.
Notation C := (crossing line).
Notation Coordinate := (coordinate line).
Notation above := (Moments.above p v).
Notation event_of := (Moments.event_of p v).
Notation backwards := (Line.backwards line).
Notation passed := (passed p v line).
Notation passed_right := (passed_right p v line).
Notation above_is := (above_is p v line).

(** ** Trees of planes *)

Inductive halved := Whole (n : Leaf) | Halved (i : axis) (x : Coordinate) (below beyond : halved).

Fixpoint planes_usable (a : halved) : Prop :=
  match a with Whole _ => True | Halved _ x lo hi => usable x /\ planes_usable lo /\ planes_usable hi end.

Inductive in_half (m : moment) (n : Leaf) : halved -> Prop :=
| in_whole : in_half m n (Whole n)
| in_below i x lo hi : ~ above i (value x) m -> in_half m n lo -> in_half m n (Halved i x lo hi)
| in_beyond i x lo hi : above i (value x) m -> in_half m n hi -> in_half m n (Halved i x lo hi).

Fixpoint walk_halves (a : halved) (enter leave : C) : list (C * Leaf) :=
  match a with
  | Whole n => [(enter, n)]
  | Halved i x lo hi =>
      let middle := crosses i x in
      let gone := passed middle enter in
      let up := xorb gone (backwards i) in
      if gone || match order middle leave with Lt => false | _ => true end then
        walk_halves (if up then hi else lo) enter leave
      else walk_halves (if up then hi else lo) enter middle ++ walk_halves (if up then lo else hi) middle leave
  end.

(** A walk from the moment m to the event A: its entries come one after the other, and each moment between is in the leaf
    of one that was entered by then. *)
Definition entered (k : C * Leaf) (e : moment) : Prop := stands (fst k) (At e).
Definition not_after (k k' : C * Leaf) : Prop := exists e e', entered k e /\ entered k' e' /\ e ⊑ e'.
Definition covers (inside : moment -> Leaf -> Prop) (m : moment) (A : event) (l : list (C * Leaf)) : Prop :=
  Forall (fun k => exists e, entered k e /\ m ⊑ e /\ At e ≼ A) l
  /\ StronglySorted not_after l
  /\ forall m', m ⊑ m' -> sooner (At m') A -> exists k e, In k l /\ entered k e /\ e ⊑ m' /\ inside m' (snd k).

Lemma same (a : moment) : a ⊑ a.
Proof. exact (same_event (At a)). Qed.

Lemma covers_one (inside : moment -> Leaf -> Prop) m A c n : stands c (At m) -> At m ≼ A ->
  (forall m', inside m' n) -> covers inside m A [(c, n)].
Proof.
  intros Hc Hm Hn. split; [constructor; [exists m; split; [exact Hc | split; [apply same | exact Hm]] | constructor] |].
  split; [constructor; constructor |]. intros m' Hm' _. exists (c, n), m. split; [now left | split; [exact Hc |]].
  split; [exact Hm' | apply Hn].
Qed.
Lemma covers_weaker (inside inside' : moment -> Leaf -> Prop) m A l : covers inside m A l ->
  (forall m' n, m ⊑ m' -> sooner (At m') A -> inside m' n -> inside' m' n) -> covers inside' m A l.
Proof.
  intros [H1 [H2 H3]] Hi. split; [exact H1 | split; [exact H2 |]]. intros m' Hm HA.
  destruct (H3 m' Hm HA) as [k [e [Hk [He [Hem Hin]]]]]. exists k, e. repeat split; auto.
Qed.
Lemma covers_both inside m o A l l' : covers inside m (At o) l -> covers inside o A l' -> m ⊑ o -> At o ≼ A ->
  covers inside m A (l ++ l').
Proof.
  intros [F [S K]] [F' [S' K']] Hm HA. split; [| split].
  - apply Forall_app. split.
    + revert F. apply Forall_impl. intros k [e [He [H1 H2]]]. exists e. split; [exact He | split; [exact H1 |]].
      exact (event_trans (At e) (At o) A H2 HA).
    + revert F'. apply Forall_impl. intros k [e [He [H1 H2]]]. exists e. split; [exact He | split; [| exact H2]].
      exact (not_later_trans m o e Hm H1).
  - clear K K'. induction l as [| k l IH]; [exact S' |]. inversion_clear S as [| ? ? Sl Sk]. inversion_clear F as [| ? ? Fk Fl].
    cbn. constructor; [now apply IH |]. apply Forall_app. split; [exact Sk |].
    destruct Fk as [e [He [_ H2]]]. revert F'. apply Forall_impl. intros k' [e' [He' [H1 _]]]. exists e, e'.
    split; [exact He | split; [exact He' |]]. exact (not_later_trans e o e' H2 H1).
  - intros m' Hm' HA'. destruct (before_or_not m' o) as [H | H].
    + destruct (K m' Hm' H) as [k [e [Hk Hrest]]]. exists k, e. split; [apply in_app_iff; now left | exact Hrest].
    + destruct (K' m' H HA') as [k [e [Hk Hrest]]]. exists k, e. split; [apply in_app_iff; now right | exact Hrest].
Qed.

(** An event between two moments is one. *)
Lemma between_events m M A : sooner (At m) M -> sooner M A -> exists o, M = At o.
Proof. destruct M as [| o |]; [contradiction | eauto | contradiction]. Qed.

Lemma in_side i x lo hi up m n : (above i (value x) m <-> up = true) -> in_half m n (if up then hi else lo) ->
  in_half m n (Halved i x lo hi).
Proof.
  intros H Hn. destruct up; [apply in_beyond; [now apply H | exact Hn] |].
  apply in_below; [intros N; apply H in N; discriminate | exact Hn].
Qed.

Theorem halves_are_covered a : planes_usable a -> forall enter leave m A, stands enter (At m) -> stands leave A ->
  At m ≼ A -> covers (fun m' n => in_half m' n a) m A (walk_halves a enter leave).
Proof.
  induction a as [n | i x lo IHlo hi IHhi]; intros Hu enter leave m A Hm HA Hle.
  { apply covers_one; auto. intros m'. constructor. }
  destruct Hu as [Hx [Hlo Hhi]]. pose proof (crosses_right (l := line) i x Hx) as Hmid. set (M := event_of i (value x)) in *.
  assert (Side : forall (up : bool) enter leave m A, stands enter (At m) -> stands leave A -> At m ≼ A ->
    covers (fun m' n => in_half m' n (if up then hi else lo)) m A (walk_halves (if up then hi else lo) enter leave)).
  { intros [|]; [apply IHhi | apply IHlo]; assumption. }
  cbn [walk_halves]. pose proof (passed_right _ _ _ _ Hmid Hm) as Hgone.
  pose proof (order_right _ _ _ _ Hmid HA) as Hord. set (gone := passed (crosses (l := line) i x) enter) in *.
  assert (Alone : (forall m', m ⊑ m' -> sooner (At m') A -> if gone then M ≼ At m' else sooner (At m') M) ->
    covers (fun m' n => in_half m' n (Halved i x lo hi)) m A
      (walk_halves (if xorb gone (backwards i) then hi else lo) enter leave)).
  { intros H. apply covers_weaker with (1 := Side (xorb gone (backwards i)) enter leave m A Hm HA Hle).
    intros m' n Hm' HA'. apply in_side, above_is. now apply H. }
  destruct gone.
  { cbn [orb]. apply Alone. intros m' Hm' _. exact (event_trans M (At m) (At m') Hgone Hm'). }
  cbn [orb]. assert (Later : A ≼ M -> covers (fun m' n => in_half m' n (Halved i x lo hi)) m A
      (walk_halves (if xorb false (backwards i) then hi else lo) enter leave)).
  { intros H. apply Alone. intros m' _ HA'. exact (sooner_then _ _ _ HA' H). }
  destruct (order (crosses i x) leave); [apply Later; tauto | | apply Later; now apply sooner_not_later].
  clear Alone Later. destruct (between_events m M A Hgone Hord) as [o Eo].
  rewrite Eo in *. pose proof (sooner_not_later _ _ Hgone) as Hmo. pose proof (sooner_not_later _ _ Hord) as HoA.
  apply covers_both with o; [| | exact Hmo | exact HoA].
  - apply covers_weaker with (1 := Side (xorb false (backwards i)) enter (crosses i x) m (At o) Hm Hmid Hmo).
    intros m' n _ Ho. apply in_side, above_is. fold M. now rewrite Eo.
  - replace (if xorb false (backwards i) then lo else hi) with (if xorb true (backwards i) then hi else lo)
      by (now destruct (backwards i)).
    apply covers_weaker with (1 := Side (xorb true (backwards i)) (crosses i x) leave o A Hmid HA HoA).
    intros m' n Ho _. apply in_side, above_is. fold M. now rewrite Eo.
Qed.

(** ** Octrees *)

Inductive eighths := Eighth (n : Leaf) | Node (x : axis -> Coordinate) (children : bool -> bool -> bool -> eighths).
Definition child (h : bool -> bool -> bool -> eighths) (at_ : axis -> bool) : eighths := h (at_ X) (at_ Y) (at_ Z).

Fixpoint middles_usable (a : eighths) : Prop :=
  match a with Eighth _ => True | Node x h => (forall i, usable (x i)) /\ forall a b c, middles_usable (h a b c) end.

Inductive in_eighth (m : moment) (n : Leaf) : eighths -> Prop :=
| in_leaf : in_eighth m n (Eighth n)
| in_child x h at_ : (forall i, above i (value (x i)) m <-> at_ i = true) -> in_eighth m n (child h at_) ->
    in_eighth m n (Node x h).

Definition same_axis (i j : axis) : bool := match i, j with X, X | Y, Y | Z, Z => true | _, _ => false end.
Definition some (b : axis -> bool) : bool := existsb b axes.

(** The next crossing, and the axes that it is across; none, where the node is left. *)
Definition next_step (middle : axis -> C) (gone : axis -> bool) (s : C * (axis -> bool)) (i : axis) : C * (axis -> bool) :=
  if gone i then s
  else match order (middle i) (fst s) with
       | Lt => (middle i, same_axis i)
       | Eq => if some (snd s) then (fst s, fun j => same_axis i j || snd s j) else s
       | Gt => s
       end.
Definition next_of middle gone leave : C * (axis -> bool) := fold_left (next_step middle gone) axes (leave, fun _ => false).

(** The children in their order. At most three steps lead from one to another, since each crosses a plane. *)
Fixpoint siblings (visit : (axis -> bool) -> C -> C -> list (C * Leaf)) (middle : axis -> C) (leave : C) (steps : nat)
  (gone at_ : axis -> bool) (enter : C) : list (C * Leaf) :=
  let (next, across) := next_of middle gone leave in
  visit at_ enter next ++
  match some across, steps with
  | true, S n => siblings visit middle leave n (fun i => gone i || across i) (fun i => xorb (at_ i) (across i)) next
  | _, _ => []
  end.

Fixpoint walk_eighths (a : eighths) (enter leave : C) : list (C * Leaf) :=
  match a with
  | Eighth n => [(enter, n)]
  | Node x h =>
      let middle i := crosses i (x i) in
      let gone i := passed (middle i) enter in
      siblings (fun at_ => walk_eighths (h (at_ X) (at_ Y) (at_ Z))) middle leave 3 gone
        (fun i => xorb (gone i) (backwards i)) enter
  end.

Lemma some_true b : some b = true <-> exists i, b i = true.
Proof.
  unfold some. rewrite existsb_exists. split; intros [i H]; exists i; [tauto | split; [apply all_axes | exact H]].
Qed.
Lemma same_axis_true i j : same_axis i j = true <-> i = j.
Proof. destruct i, j; cbn; split; congruence. Qed.

Section Node.
Variable x : axis -> Coordinate.
Hypothesis x_usable : forall i, usable (x i).
Notation M i := (event_of i (value (x i))).
Notation middle := (fun i => crosses (l := line) i (x i)).
Variables (leave : C) (A : event).
Hypothesis leave_right : stands leave A.

(** What is known of the next crossing when the axes of l have been looked at. *)
Definition next_right (gone : axis -> bool) (l : list axis) (s : C * (axis -> bool)) : Prop :=
  exists N, stands (fst s) N
  /\ ((some (snd s) = false /\ N = A /\ forall i, In i l -> gone i = false -> A ≼ M i)
      \/ (some (snd s) = true /\ sooner N A /\ (exists i, gone i = false /\ N = M i)
          /\ forall i, (snd s i = true -> gone i = false /\ M i ≼ N /\ N ≼ M i)
                        /\ (In i l -> gone i = false -> snd s i = false -> sooner N (M i)))).

Lemma next_step_right gone l s i : next_right gone l s -> next_right gone (i :: l) (next_step middle gone s i).
Proof.
  intros [N [HN H]]. unfold next_step. destruct (gone i) eqn:Ei.
  { exists N. split; [exact HN |]. destruct H as [[H1 [H2 H3]] | [H1 [H2 [H3 H4]]]].
    - left. repeat split; auto. intros j [<- | Hj] Hg; [congruence | now apply H3].
    - right. split; [exact H1 | split; [exact H2 | split; [exact H3 |]]]. intros j. split; [apply H4 |].
      intros [<- | Hj] Hg; [congruence | now apply H4]. }
  pose proof (order_right _ _ _ _ (crosses_right (l := line) i (x i) (x_usable i)) HN) as Hord.
  destruct (order (crosses i (x i)) (fst s)).
  - destruct H as [[H1 [H2 H3]] | [H1 [H2 [H3 H4]]]]; rewrite H1.
    + exists N. split; [exact HN |]. left. repeat split; auto. intros j [<- | Hj] Hg; [rewrite <- H2; tauto | now apply H3].
    + exists N. split; [exact HN |]. right. cbn [snd]. split; [| split; [exact H2 | split; [exact H3 |]]].
      { apply some_true. exists i. now rewrite (proj2 (same_axis_true i i) eq_refl). }
      intros j. destruct (same_axis i j) eqn:Ej; cbn [orb].
      * apply same_axis_true in Ej as <-. split; [intros _; tauto | discriminate].
      * split; [apply H4 |]. intros [<- | Hj]; [| now apply H4].
        now rewrite (proj2 (same_axis_true i i) eq_refl) in Ej.
  - exists (M i). split; [exact (crosses_right (l := line) i (x i) (x_usable i)) |]. right. cbn [snd fst]. split.
    { apply some_true. exists i. now apply same_axis_true. }
    split; [destruct H as [[_ [<- _]] | [_ [H2 _]]]; [exact Hord | exact (sooner_then _ _ _ Hord (sooner_not_later _ _ H2))] |].
    split; [now exists i |]. intros j. split.
    + intros Ej. apply same_axis_true in Ej as <-. split; [exact Ei | split; apply same_event].
    + intros [<- | Hj] Hg Ej; [now rewrite (proj2 (same_axis_true i i) eq_refl) in Ej |].
      apply (sooner_then _ N); [exact Hord |]. destruct H as [[_ [-> H3]] | [_ [_ [_ H4]]]]; [now apply H3 |].
      destruct (H4 j) as [K1 K2]. destruct (snd s j); [now apply K1 | now apply sooner_not_later, K2].
  - exists N. split; [exact HN |]. destruct H as [[H1 [H2 H3]] | [H1 [H2 [H3 H4]]]].
    + left. repeat split; auto. intros j [<- | Hj] Hg; [rewrite <- H2; now apply sooner_not_later | now apply H3].
    + right. split; [exact H1 | split; [exact H2 | split; [exact H3 |]]]. intros j. split; [apply H4 |].
      intros [<- | Hj] Hg Es; [exact Hord | now apply H4].
Qed.
Lemma next_of_right gone : next_right gone [Z; Y; X] (next_of middle gone leave).
Proof.
  unfold next_of, axes. cbn [fold_left]. do 3 apply next_step_right. exists A. split; [exact leave_right |]. left.
  repeat split. intros i [].
Qed.

Definition to_go (gone : axis -> bool) : nat := length (filter (fun i => negb (gone i)) axes).
Lemma fewer_to_go gone across : (forall i, across i = true -> gone i = false) -> some across = true ->
  (to_go (fun i => gone i || across i) < to_go gone)%nat.
Proof.
  intros H Hs. apply some_true in Hs as [i Hi]. pose proof (H i Hi) as Hg. unfold to_go, axes. cbn.
  pose proof (H X) as HX. pose proof (H Y) as HY. pose proof (H Z) as HZ.
  destruct (gone X), (gone Y), (gone Z), (across X) eqn:EX, (across Y) eqn:EY, (across Z) eqn:EZ; cbn;
    try lia; try (now specialize (HX eq_refl)); try (now specialize (HY eq_refl)); try (now specialize (HZ eq_refl));
    destruct i; congruence.
Qed.
Lemma none_to_go gone i : (to_go gone <= 0)%nat -> gone i = true.
Proof. unfold to_go, axes. cbn. destruct i, (gone X), (gone Y), (gone Z); cbn; (reflexivity || lia). Qed.

Variable h : bool -> bool -> bool -> eighths.
Variable visit : (axis -> bool) -> C -> C -> list (C * Leaf).
Hypothesis visit_right : forall (at_ : axis -> bool) (enter leave : C) m A, stands enter (At m) -> stands leave A -> At m ≼ A ->
  covers (fun m' n => in_eighth m' n (child h at_)) m A (visit at_ enter leave).

Lemma siblings_cover steps : forall (gone at_ : axis -> bool) (enter : C) m, stands enter (At m) -> At m ≼ A ->
  (forall i, if gone i then M i ≼ At m else sooner (At m) (M i)) -> (forall i, at_ i = xorb (gone i) (backwards i)) ->
  (to_go gone <= steps)%nat ->
  covers (fun m' n => in_eighth m' n (Node x h)) m A (siblings visit middle leave steps gone at_ enter).
Proof.
  induction steps as [| steps IH]; intros gone at_ enter m Hm HA Hgone Hat Hsteps;
    cbn [siblings]; destruct (next_of_right gone) as [N [HN H]]; destruct (next_of middle gone leave) as [next across];
    cbn [fst snd] in *.
  all: assert (NM : forall i, gone i = false -> N ≼ M i)
    by (intros i Hi; assert (Hin : In i [Z; Y; X]) by (destruct i; cbn; tauto);
        destruct H as [[_ [-> H3]] | [_ [_ [_ H4]]]]; [now apply H3 |]; destruct (H4 i) as [K1 K2];
        destruct (across i); [now apply K1 | now apply sooner_not_later, K2]).
  all: assert (MN : At m ≼ N)
    by (destruct H as [[_ [-> _]] | [_ [_ [[i [Hi ->]] _]]]]; [exact HA |]; pose proof (Hgone i) as K; rewrite Hi in K;
        now apply sooner_not_later).
  all: assert (First : covers (fun m' n => in_eighth m' n (Node x h)) m N (visit at_ enter next))
    by (apply covers_weaker with (1 := visit_right at_ enter next m N Hm HN MN); intros m' n Hm' HN' Hin;
        apply in_child with at_; [| exact Hin]; intros i; rewrite (Hat i); apply above_is; pose proof (Hgone i) as K;
        destruct (gone i) eqn:Ei; [exact (event_trans _ (At m) (At m') K Hm') | exact (sooner_then _ _ _ HN' (NM i Ei))]).
  all: destruct H as [[-> [-> _]] | [Hs [HNA [[i [Hi Ei]] H4]]]]; [now rewrite app_nil_r |]; rewrite Hs.
  - apply some_true in Hs as [j Hj]. destruct (H4 j) as [K _]. specialize (K Hj). destruct K as [K _].
    now rewrite (none_to_go gone j Hsteps) in K.
  - destruct (between_events m N A) as [o ->]; [rewrite Ei; pose proof (Hgone i) as K; now rewrite Hi in K | exact HNA |].
    apply covers_both with o; [exact First | | exact MN | now apply sooner_not_later].
    apply IH; [exact HN | now apply sooner_not_later | | |].
    + intros j. destruct (H4 j) as [K1 K2]. pose proof (Hgone j) as Kj. destruct (gone j) eqn:Ej; cbn [orb].
      * exact (event_trans _ _ _ Kj MN).
      * assert (Hin : In j [Z; Y; X]) by (destruct j; cbn; tauto).
        destruct (across j); [now apply K1 | now apply K2].
    + intros j. rewrite (Hat j). destruct (H4 j) as [K1 _]. destruct (across j), (gone j), (backwards j); try reflexivity;
        now destruct (K1 eq_refl).
    + assert (to_go (fun j => gone j || across j) < to_go gone)%nat; [| lia].
      apply fewer_to_go; [intros j Hj; now apply (H4 j) | exact Hs].
Qed.
End Node.

Theorem eighths_are_covered a : middles_usable a -> forall enter leave m A, stands enter (At m) -> stands leave A ->
  At m ≼ A -> covers (fun m' n => in_eighth m' n a) m A (walk_eighths a enter leave).
Proof.
  induction a as [n | x h IH]; intros Hu enter leave m A Hm HA Hle.
  { apply covers_one; auto. intros m'. constructor. }
  destruct Hu as [Hx Hh]. cbn [walk_eighths]. apply siblings_cover; auto.
  - intros at_ enter' leave' m' A'. apply IH, Hh.
  - intros i. exact (passed_right _ _ _ _ (crosses_right (l := line) i (x i) (Hx i)) Hm).
  - unfold to_go, axes. cbn. repeat (destruct (passed _ _)); cbn; lia.
Qed.
End Trees.
