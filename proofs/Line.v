(** * Line: crossings as a program computes and compares them, and the way of a ray into a box and out of it

    The model of accel/line.hpp and accel/lattice.cpp, branch by branch, over any crossings that are compared in the order
    of their events (Moments.v); Crossings.v has those of binary64.

    line p v               == what is computed of crossings of the ray from p along v:
      crossing, coordinate == their types;  value x, usable x == the plane's number, and that it is in range
      stands c a           == c is computed of the event a
      order, crosses       == Line::order, Line::crossing;  begin == Line::start
      still, backwards     == how the ray goes along an axis
    passed a c             == order(a, c) <= 0;  above i x c == Line::above
    way_in, way_out        == of the half-open box between low and high;  first_of == the first of three *)
From Coq Require Import Reals List Bool Lra.
From Durero Require Import Acceleration Moments.
Import ListNotations.
Local Open Scope R_scope.

Definition axes : list axis := [X; Y; Z].
Lemma all_axes i : In i axes.
Proof. destruct i; cbn; tauto. Qed.

Record line (p v : axis -> R) := Line {
  crossing : Type;
  coordinate : Type;
  value : coordinate -> R;
  usable : coordinate -> Prop;
  stands : crossing -> event -> Prop;
  order : crossing -> crossing -> comparison;
  order_right : forall a b A B, stands a A -> stands b B ->
    match order a b with Lt => sooner A B | Eq => A ≼ B /\ B ≼ A | Gt => sooner B A end;
  crosses : axis -> coordinate -> crossing;
  crosses_right : forall i x, usable x -> stands (crosses i x) (event_of p v i (value x));
  begin : crossing;
  begin_right : stands begin (At start);
  still : axis -> bool;
  still_right : forall i, still i = true <-> v i = 0;
  backwards : axis -> bool;
  backwards_right : forall i, backwards i = true <-> v i < 0
}.
Arguments crossing {p v}. Arguments coordinate {p v}. Arguments value {p v l}. Arguments usable {p v l}.
Arguments stands {p v l}. Arguments order {p v l}. Arguments order_right {p v l}. Arguments crosses {p v l}.
Arguments crosses_right {p v l}. Arguments begin {p v}. Arguments begin_right {p v l}. Arguments still {p v}.
Arguments still_right {p v l}. Arguments backwards {p v}. Arguments backwards_right {p v l}.

Section Line.
Variables p v : axis -> R.
Variable l : line p v.
Notation C := (crossing l).
Notation Coordinate := (coordinate l).
Notation above := (Moments.above p v).
Notation event_of := (Moments.event_of p v).
Notation begin := (begin l).
Notation still := (still l).
Notation backwards := (backwards l).

Definition passed (a c : C) : bool := match order a c with Gt => false | _ => true end.
Definition above64 (i : axis) (x : Coordinate) (c : C) : bool := xorb (passed (crosses i x) c) (backwards i).

Lemma passed_right a c A B : stands a A -> stands c B -> if passed a c then A ≼ B else sooner B A.
Proof.
  intros Ha Hc. pose proof (order_right a c A B Ha Hc) as H. unfold passed. destruct (order a c); [tauto | | exact H].
  now apply sooner_not_later.
Qed.
(** Of a plane that is crossed by then, or after: the ray is above it, or below. *)
Lemma above_is i x (gone : bool) m : (if gone then event_of i x ≼ At m else sooner (At m) (event_of i x)) ->
  (above i x m <-> xorb gone (backwards i) = true).
Proof.
  intros H. rewrite above_event. pose proof (backwards_right (l := l) i) as Hb.
  destruct (Rlt_dec (v i) 0) as [Hv | Hv], (backwards i); try (exfalso; now apply Hv, Hb);
    try (apply Hb in Hv; discriminate); destruct gone; cbn [xorb]; split; intros K;
    first [reflexivity | discriminate | exact H | contradiction].
Qed.
Lemma above_right i x c m : usable x -> stands c (At m) -> above64 i x c = true <-> above i (value x) m.
Proof.
  intros Hx Hc. symmetry. apply above_is. exact (passed_right _ _ _ _ (crosses_right i x Hx) Hc).
Qed.

(** ** The box of all *)
Section Box.
Variables low high : axis -> Coordinate.
Hypothesis low_usable : forall i, usable (low i).
Hypothesis high_usable : forall i, usable (high i).

Definition comes_in (s : option C) (i : axis) : option C :=
  match s with
  | None => None
  | Some c =>
      let below := negb (above64 i (low i) begin) in
      let beyond := above64 i (high i) begin in
      if negb below && negb beyond then Some c
      else if still i || eqb below (backwards i) then None
      else let d := crosses i (if below then low i else high i) in
           Some (match order d c with Gt => d | _ => c end)
  end.
Definition within (c : C) (i : axis) : bool := above64 i (low i) c && negb (above64 i (high i) c).
Definition way_in : option C :=
  match fold_left comes_in axes (Some begin) with
  | Some c => if forallb (within c) axes then Some c else None
  | None => None
  end.

Definition first_of (crossings : axis -> C) : C :=
  fold_left (fun c i => match order (crossings i) c with Lt => crossings i | _ => c end) [Y; Z] (crossings X).
Definition way_out : C := first_of (fun i => crosses i (if backwards i then low i else high i)).

Notation in_box := (Moments.in_box p v (fun i => value (low i)) (fun i => value (high i))).
Notation between := (Moments.between p v (fun i => value (low i)) (fun i => value (high i))).
Notation enters := (Moments.enters p v (fun i => value (low i)) (fun i => value (high i))).

Lemma start_first t : 0 <= t -> start ⊑ (t, false).
Proof. intros Ht [N | [_ [_ N]]]; cbn in N; [lra | discriminate]. Qed.

(** A plane that the ray is on different sides of at the start and later, it crosses. *)
Lemma crosses_between i x m m' : (above i x m /\ ~ above i x m') \/ (~ above i x m /\ above i x m') ->
  exists o, Moments.crossing p v i x = Some o.
Proof.
  unfold Moments.crossing, Moments.above, at_. destruct (Req_EM_T (v i) 0) as [E | E]; [| eauto]. rewrite E.
  destruct (Rlt_dec 0 0); lra.
Qed.
Lemma event_of_crossing i x o : Moments.crossing p v i x = Some o -> event_of i x = At o.
Proof. unfold Moments.event_of. now intros ->. Qed.

Lemma comes_in_right t js : 0 <= t -> in_box (t, false) -> forall c m, stands c (At m) -> start ⊑ m ->
  m = start \/ (exists i, enters i m) ->
  exists c' m', fold_left comes_in js (Some c) = Some c' /\ stands c' (At m') /\ m ⊑ m'
    /\ (m' = start \/ exists i, enters i m') /\ forall i, In i js -> exists e, enters i e /\ e ⊑ m'.
Proof.
  intros Ht Hbox. assert (Same : forall a : moment, a ⊑ a) by (intros a; exact (same_event (At a))).
  pose proof (start_first t Ht) as St.
  induction js as [| i js IH]; intros c m Hc Hs Hm.
  { exists c, m. repeat split; auto. intros i []. }
  assert (Step : exists c1 m1, comes_in (Some c) i = Some c1 /\ stands c1 (At m1) /\ m ⊑ m1
    /\ (m1 = start \/ exists j, enters j m1) /\ exists e, enters i e /\ e ⊑ m1).
  { destruct (Hbox i) as [Hlo Hhi].
    pose proof (above_right i (low i) begin start (low_usable i) begin_right) as Alo.
    pose proof (above_right i (high i) begin start (high_usable i) begin_right) as Ahi.
    assert (Cross : forall x, usable x -> (exists o, Moments.crossing p v i (value x) = Some o) ->
      (forall o, Moments.crossing p v i (value x) = Some o -> enters i o) ->
      exists c1 m1, Some (match order (crosses i x) c with Gt => crosses i x | _ => c end) = Some c1
        /\ stands c1 (At m1) /\ m ⊑ m1 /\ (m1 = start \/ exists j, enters j m1) /\ exists e, enters i e /\ e ⊑ m1).
    { intros x Hx [o Ho] He. pose proof (crosses_right i x Hx) as Hso. rewrite (event_of_crossing i _ o Ho) in Hso.
      pose proof (order_right _ _ _ _ Hso Hc) as Hord. specialize (He o Ho). destruct (order (crosses i x) c).
      - exists c, m. repeat split; auto. exists o. split; [exact He | apply Hord].
      - exists c, m. repeat split; auto. exists o. split; [exact He | exact (before_not_later _ _ Hord)].
      - exists (crosses i x), o. split; [reflexivity | split; [exact Hso | split; [exact (before_not_later _ _ Hord) |]]].
        split; [right; now exists i | exists o; split; [exact He | apply Same]]. }
    assert (Still : forall x b, (b = true <-> above i x start) -> (b = true <-> above i x (t, false)) \/ still i = false).
    { intros x b Hb. destruct (still i) eqn:E; [left | now right]. apply (still_right (l := l)) in E. rewrite Hb.
      unfold Moments.above, at_. rewrite E. destruct (Rlt_dec 0 0); cbn; lra. }
    unfold comes_in. destruct (above64 i (low i) begin) eqn:Elo; cbn [negb andb].
    - destruct (above64 i (high i) begin) eqn:Ehi; cbn [negb andb].
      + (* beyond *)
        destruct (Still _ _ Ahi) as [K | ->]; [now destruct Hhi; apply K |]. cbn [orb eqb].
        destruct (backwards i) eqn:Eb; cbn [eqb].
        * apply (Cross (high i)); [apply high_usable | |].
          -- apply (crosses_between i _ start (t, false)). left. split; [now apply Ahi | exact Hhi].
          -- intros o Ho. right. right. split; [now apply Ahi | exact Ho].
        * destruct Hhi. apply above_stays with start; [| exact St | now apply Ahi].
          apply Rnot_lt_le. intros N. apply (backwards_right (l := l)) in N. congruence.
      + exists c, m. repeat split; auto. exists start. split; [| exact Hs]. left. split; [| reflexivity].
        split; [now apply Alo | intros N; apply Ahi in N; discriminate].
    - (* below *)
      assert (Nlo : ~ above i (value (low i)) start) by (intros N; apply Alo in N; discriminate).
      destruct (Still _ _ Alo) as [K | ->]; [apply K in Hlo; discriminate |]. cbn [orb].
      destruct (backwards i) eqn:Eb; cbn [eqb].
      + destruct (below_stays p v i (value (low i)) start (t, false)); auto.
        apply (backwards_right (l := l)) in Eb. lra.
      + apply (Cross (low i)); [apply low_usable | |].
        * apply (crosses_between i _ start (t, false)). right. now split.
        * intros o Ho. right. left. now split. }
  destruct Step as [c1 [m1 [E [H1 [H2 [H3 [e [He Hem]]]]]]]]. cbn [fold_left]. rewrite E.
  destruct (IH c1 m1 H1 (not_later_trans _ _ _ Hs H2) H3) as [c' [m' [E' [K1 [K2 [K3 K4]]]]]].
  exists c', m'. split; [exact E' | split; [exact K1 | split; [now apply not_later_trans with m1 | split; [exact K3 |]]]].
  intros j [<- | Hj]; [exists e; split; [exact He | now apply not_later_trans with m1] | now apply K4].
Qed.

(** Wherever the ray is in the box, it has come in by then and not yet left. *)
Theorem way_in_right t : 0 <= t -> in_box (t, false) ->
  exists c m, way_in = Some c /\ stands c (At m) /\ m ⊑ (t, false).
Proof.
  intros Ht Hbox. assert (Same : forall a : moment, a ⊑ a) by (intros a; exact (same_event (At a))).
  destruct (comes_in_right t axes Ht Hbox begin start begin_right (Same start) (or_introl eq_refl))
    as [c [m [E [Hc [Hs [Hm Hall]]]]]].
  assert (W : Moments.way_in p v (fun i => value (low i)) (fun i => value (high i)) m).
  { split; [intros i; apply Hall, all_axes | split; [exact Hm | exact Hs]]. }
  destruct (way_in_is_in p v _ _ m t W Ht Hbox) as [Hmt Hin].
  exists c, m. unfold way_in. rewrite E. split; [| now split].
  replace (forallb (within c) axes) with true; [reflexivity |]. symmetry. apply forallb_forall. intros i _.
  destruct (Hin i) as [H1 H2]. unfold within. rewrite (proj2 (above_right i (low i) c m (low_usable i) Hc) H1).
  destruct (above64 i (high i) c) eqn:E2; [| reflexivity].
  apply (above_right i (high i) c m (high_usable i) Hc) in E2. contradiction.
Qed.
Theorem way_in_known c : way_in = Some c -> exists m, stands c (At m) /\ start ⊑ m /\ in_box m.
Proof.
  assert (K : forall js s c, (s = None \/ exists c0 m, s = Some c0 /\ stands c0 (At m) /\ start ⊑ m) ->
    fold_left comes_in js s = Some c -> exists m, stands c (At m) /\ start ⊑ m).
  { induction js as [| i js IH]; intros s c0 Hs E; cbn in E.
    - destruct Hs as [-> | [c1 [m [-> H]]]]; [discriminate | injection E as <-; eauto].
    - revert E. apply IH. destruct Hs as [-> | [c1 [m [-> [H Hs]]]]]; [now left |]. cbn.
      destruct (negb (negb _) && _); [right; eauto |]. destruct (still i || _) eqn:Es; [now left |]. right.
      set (x := if negb (above64 i (low i) begin) then low i else high i).
      assert (Hx : usable x) by (unfold x; destruct (negb _); auto).
      pose proof (crosses_right i x Hx) as Hso. unfold Moments.event_of, Moments.crossing in Hso.
      apply orb_false_iff in Es as [Es _]. destruct (Req_EM_T (v i) 0) as [N | N]; [apply (still_right (l := l)) in N; congruence |].
      pose proof (order_right _ _ _ _ Hso H) as Hord. destruct (order (crosses i x) c1); eauto.
      eexists _, _. split; [reflexivity | split; [exact Hso |]]. apply (not_later_trans _ m); [exact Hs | now apply before_not_later]. }
  unfold way_in. destruct (fold_left comes_in axes (Some begin)) as [d |] eqn:E; [| discriminate].
  destruct (forallb (within d) axes) eqn:W; [| discriminate]. intros [= <-].
  destruct (K axes (Some begin) d) as [m [Hm Hs]]; [| exact E |].
  { right. exists begin, start. split; [reflexivity | split; [exact begin_right | exact (same_event (At start))]]. }
  exists m. split; [exact Hm | split; [exact Hs |]]. intros i.
  rewrite forallb_forall in W. specialize (W i (all_axes i)). apply andb_prop in W as [W1 W2].
  split; [now apply (above_right i (low i) d m (low_usable i) Hm) |]. intros N.
  apply (above_right i (high i) d m (high_usable i) Hm) in N. now rewrite N in W2.
Qed.

Lemma first_of_one crossings : exists i, first_of crossings = crossings i.
Proof.
  unfold first_of. cbn. destruct (order (crossings Y) (crossings X));
    match goal with |- context [order ?a ?b] => destruct (order a b) end; eauto.
Qed.
Theorem way_out_right m : in_box m -> exists A, stands way_out A /\ sooner (At m) A.
Proof.
  intros Hbox. unfold way_out. destruct (first_of_one (fun i => crosses i (if backwards i then low i else high i))) as [i ->].
  exists (event_of i (value (if backwards i then low i else high i))).
  split; [apply crosses_right; destruct (backwards i); auto |].
  destruct (Hbox i) as [Hlo Hhi]. rewrite above_event in Hlo, Hhi. pose proof (backwards_right (l := l) i) as Hb.
  destruct (backwards i), (Rlt_dec (v i) 0) as [Hv | Hv]; try (exfalso; now apply Hv, Hb);
    try (apply Hb in Hv; discriminate); [exact Hlo |].
  destruct (sooner_or_not (At m) (event_of i (value (high i)))) as [H | H]; [exact H | contradiction].
Qed.
End Box.

End Line.
