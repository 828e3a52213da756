(** * Moments: when a ray crosses planes across the axes, in order

    The model of accel/line.hpp. Space is divided by the half-open rule: of a plane, the points at or beyond it are
    above. A ray that goes backwards along an axis is still above where it crosses, and below right after; so what is
    walked in order are moments: a parameter, and right after it.

    p i, v i               == origin and direction of the ray along the axis i;  at i t == its coordinate at t
    moment, a ⊑ b, a ⊏ b    == a parameter t, or right after it; their order
    start                  == the origin
    above i x m            == at the moment m the ray is above the plane x of the axis i
    crossing i x           == when it crosses that plane, if it ever does
    event                  == the same with words for a ray along the plane: above it since ever, or never
    event_of i x           == that of a plane;  sooner a b, a ≼ b == their order
    low i, high i          == the outer planes of a box
    way_in m               == m is the moment at which the ray has come between the outer planes of every axis *)
From Durero Require Import Acceleration.
From Coq Require Import Reals List Lra.
Import ListNotations.
Local Open Scope R_scope.

(** ** Moments *)

Definition moment := (R * bool)%type.
Definition before (a b : moment) : Prop := fst a < fst b \/ fst a = fst b /\ snd a = false /\ snd b = true.
Notation "a ⊏ b" := (before a b) (at level 70).
Notation "a ⊑ b" := (~ before b a) (at level 70).

Lemma before_or_not a b : a ⊏ b \/ b ⊑ a.
Proof. destruct a as [s [|]], b as [t [|]]; unfold before; cbn; destruct (Rtotal_order s t) as [H | [H | H]];
  try (left; lra); (left; right; repeat split; assumption) || (right; intros [N | [N [B C]]]; (lra || discriminate)).
Qed.
Lemma not_later_trans a b c : a ⊑ b -> b ⊑ c -> a ⊑ c.
Proof.
  destruct a as [r [|]], b as [s [|]], c as [t [|]]; unfold before; cbn; intros H H' [N | [N [B C]]];
    try discriminate; destruct (Rtotal_order r s) as [K | [K | K]]; destruct (Rtotal_order s t) as [L | [L | L]];
    try lra; try (apply H; lra); try (apply H'; lra); try (apply H; right; repeat split; lra);
    try (apply H'; right; repeat split; lra).
Qed.
Lemma before_not_later a b : a ⊏ b -> a ⊑ b.
Proof. intros H N. destruct a as [s [|]], b as [t [|]]; unfold before in *; cbn in *; destruct H as [H | [H [? ?]]], N as [N | [N [? ?]]];
  try discriminate; lra. Qed.
(** Of an earlier moment, the parameter is not greater. *)
Lemma not_later_le a b : a ⊑ b -> fst a <= fst b.
Proof. intros H. apply Rnot_lt_le. intros N. apply H. now left. Qed.
Lemma not_later_same a b : a ⊑ b -> fst a = fst b -> snd a = true -> snd b = true.
Proof.
  destruct a as [s a], b as [t b]. cbn. intros H -> ->. destruct b; [reflexivity |]. destruct H. right. now split.
Qed.

(** ** Events *)

Inductive event := Since_ever | At (m : moment) | Never.
Definition sooner (a b : event) : Prop :=
  match a, b with
  | At m, At n => m ⊏ n
  | Since_ever, Since_ever | Never, _ | _, Since_ever => False
  | _, _ => True
  end.
Notation "a ≼ b" := (~ sooner b a) (at level 70).

Lemma sooner_or_not a b : sooner a b \/ b ≼ a.
Proof. destruct a as [| m |], b as [| n |]; cbn; tauto. Qed.
Lemma sooner_not_later a b : sooner a b -> a ≼ b.
Proof. destruct a as [| m |], b as [| n |]; try (cbn; tauto). exact (before_not_later m n). Qed.
Lemma event_trans a b c : a ≼ b -> b ≼ c -> a ≼ c.
Proof. destruct a as [| m |], b as [| n |], c as [| o |]; try (cbn; tauto). exact (not_later_trans m n o). Qed.
Lemma sooner_then a b c : sooner a b -> b ≼ c -> sooner a c.
Proof. intros H K. destruct (sooner_or_not a c) as [L | L]; [exact L | destruct (event_trans _ _ _ K L H)]. Qed.
Lemma then_sooner a b c : a ≼ b -> sooner b c -> sooner a c.
Proof. intros H K. destruct (sooner_or_not a c) as [L | L]; [exact L | destruct (event_trans _ _ _ L H K)]. Qed.
Lemma same_event a : a ≼ a.
Proof. intros H. exact (sooner_not_later a a H H). Qed.

Section Moments.
Variables p v : axis -> R.
Definition at_ (i : axis) (t : R) : R := p i + t * v i.
Definition start : moment := (0, false).

Definition above (i : axis) (x : R) (m : moment) : Prop :=
  if Rlt_dec (v i) 0 then if snd m then x < at_ i (fst m) else x <= at_ i (fst m) else x <= at_ i (fst m).
Definition crossing (i : axis) (x : R) : option moment :=
  if Req_EM_T (v i) 0 then None else Some ((x - p i) / v i, if Rlt_dec (v i) 0 then true else false).

(** What the ray does along one axis, forwards, backwards or not at all. *)
Lemma at_forwards i s t : 0 < v i -> s <= t -> at_ i s <= at_ i t.
Proof. intros Hv Ht. unfold at_. apply Rplus_le_compat_l, Rmult_le_compat_r; lra. Qed.
Lemma at_backwards i s t : v i < 0 -> s < t -> at_ i t < at_ i s.
Proof.
  intros Hv Ht. unfold at_. apply Rplus_lt_compat_l. apply Ropp_lt_cancel. rewrite <- !Ropp_mult_distr_r_reverse.
  apply Rmult_lt_compat_r; lra.
Qed.
Lemma crossing_at i x : v i <> 0 -> at_ i ((x - p i) / v i) = x.
Proof. intros Hv. unfold at_. now field. Qed.

(** Once above, always above, if the ray does not go backwards; once below, always below, if it does. *)
Lemma above_stays i x m m' : 0 <= v i -> m ⊑ m' -> above i x m -> above i x m'.
Proof.
  unfold above. intros Hv Hm H. destruct (Rlt_dec (v i) 0); [lra |]. apply not_later_le in Hm.
  apply Rle_trans with (1 := H). destruct Hv as [Hv | Hv]; [now apply at_forwards |]. unfold at_. rewrite <- Hv. lra.
Qed.
Lemma below_stays i x m m' : v i <= 0 -> m ⊑ m' -> ~ above i x m -> ~ above i x m'.
Proof.
  unfold above. intros Hv Hm H. destruct (Rlt_dec (v i) 0) as [Hn | Hn].
  - intros N. apply H. pose proof (not_later_le _ _ Hm) as [Hlt | Heq].
    + pose proof (at_backwards i _ _ Hn Hlt). destruct (snd m), (snd m'); lra.
    + rewrite Heq. destruct (snd m) eqn:B; [rewrite (not_later_same _ _ Hm Heq B) in N; exact N |].
      destruct (snd m'); lra.
  - assert (Z : v i = 0) by lra. intros N. apply H. unfold at_ in *. rewrite Z in *. lra.
Qed.

(** When the ray crosses a plane it comes above it, or below it if it goes backwards; and it is not before. *)
Lemma crossing_forwards i x m : 0 < v i -> crossing i x = Some m -> forall m', above i x m' <-> m ⊑ m'.
Proof.
  unfold crossing, above. intros Hv. destruct (Req_EM_T (v i) 0); [lra |]. destruct (Rlt_dec (v i) 0); [lra |].
  intros [= <-] m'. pose proof (crossing_at i x n) as E. split.
  - intros H [N | [N [B C]]]; cbn in *; [| discriminate]. set (t := (x - p i) / v i) in *.
    assert (at_ i (fst m') < at_ i t); [| lra]. unfold at_. apply Rplus_lt_compat_l, Rmult_lt_compat_r; lra.
  - intros H. apply not_later_le in H. cbn in H. rewrite <- E. now apply at_forwards.
Qed.
Lemma crossing_backwards i x m : v i < 0 -> crossing i x = Some m -> forall m', above i x m' <-> m' ⊏ m.
Proof.
  unfold crossing, above. intros Hv. destruct (Req_EM_T (v i) 0); [lra |]. destruct (Rlt_dec (v i) 0); [| lra].
  intros [= <-] m'. pose proof (crossing_at i x n) as E. set (t := (x - p i) / v i) in *. unfold before. cbn.
  destruct (Rtotal_order (fst m') t) as [H | [H | H]].
  - pose proof (at_backwards i _ _ Hv H). split; [intros _; now left |]. intros _. destruct (snd m'); lra.
  - rewrite H, E. destruct (snd m').
    + split; [intros K; lra | intros [K | [_ [K _]]]; [lra | discriminate]].
    + split; [intros _; right; now repeat split | intros _; lra].
  - pose proof (at_backwards i _ _ Hv H). split; [intros K; destruct (snd m'); lra |].
    intros [K | [K _]]; lra.
Qed.
Lemma crossing_never i x : crossing i x = None -> v i = 0.
Proof. unfold crossing. destruct (Req_EM_T (v i) 0); [easy | discriminate]. Qed.

Definition event_of (i : axis) (x : R) : event :=
  match crossing i x with Some m => At m | None => if Rle_dec x (p i) then Since_ever else Never end.

(** Above is what has been crossed forwards, or is yet to be crossed backwards. *)
Lemma above_event i x m : above i x m <-> if Rlt_dec (v i) 0 then sooner (At m) (event_of i x) else event_of i x ≼ At m.
Proof.
  unfold event_of. destruct (Rtotal_order (v i) 0) as [Hv | [Hv | Hv]]; destruct (Rlt_dec (v i) 0); try lra.
  - destruct (crossing i x) as [o |] eqn:E; [| apply crossing_never in E; lra]. exact (crossing_backwards i x o Hv E m).
  - assert (C : crossing i x = None) by (unfold crossing; now destruct (Req_EM_T (v i) 0)). rewrite C. unfold above, at_.
    rewrite Hv. destruct (Rlt_dec 0 0); [lra |]. destruct (Rle_dec x (p i)); cbn; split; intros; (lra || tauto).
  - destruct (crossing i x) as [o |] eqn:E; [| apply crossing_never in E; lra]. exact (crossing_forwards i x o Hv E m).
Qed.

(** ** A box *)
Section Box.
Variables low high : axis -> R.

(** The ray is between the outer planes of an axis; in the half-open box. *)
Definition between (i : axis) (m : moment) : Prop := above i (low i) m /\ ~ above i (high i) m.
Definition in_box (m : moment) : Prop := forall i, between i m.

(** Along one axis: when the ray comes between the outer planes, if it is not there at the start. *)
Definition enters (i : axis) (m : moment) : Prop :=
  (between i start /\ m = start)
  \/ (~ above i (low i) start /\ crossing i (low i) = Some m)
  \/ (above i (high i) start /\ crossing i (high i) = Some m).
Definition way_in (m : moment) : Prop :=
  (forall i, exists e, enters i e /\ e ⊑ m) /\ (m = start \/ exists i, enters i m) /\ start ⊑ m.

(** A ray that is in the box at some moment has come in by then, and is in it at the moment of the way in. *)
Lemma way_in_is_in m t : way_in m -> 0 <= t -> in_box (t, false) -> m ⊑ (t, false) /\ in_box m.
Proof.
  intros [Hall [Hone Hstart]] Ht Hbox.
  assert (S : start ⊑ (t, false)) by (intros [N | [_ [_ N]]]; cbn in N; [lra | discriminate]).
  assert (A : forall i e, enters i e -> e ⊑ (t, false) /\ forall m', e ⊑ m' -> m' ⊑ (t, false) -> between i m').
  { intros i e He. destruct (Hbox i) as [Ha Hb]. destruct (Rtotal_order (v i) 0) as [Hv | [Hv | Hv]].
    - assert (In : forall m', m' ⊑ (t, false) -> above i (low i) m').
      { intros m' Hm'. destruct (crossing i (low i)) as [o |] eqn:E; [| apply crossing_never in E; lra].
        apply (crossing_backwards i _ o Hv E) in Ha. apply (crossing_backwards i _ o Hv E).
        destruct (before_or_not m' o) as [H | H]; [exact H |].
        exact (False_ind _ (not_later_trans o m' (t, false) H Hm' Ha)). }
      destruct He as [[[_ H2] ->] | [[H1 H2] | [H1 H2]]].
      + split; [exact S |]. intros m' Hm Hm'. split; [now apply In | apply below_stays with start; [lra | exact Hm | exact H2]].
      + destruct H1. now apply In.
      + split.
        * intros N. apply Hb. now apply (crossing_backwards i _ e Hv H2).
        * intros m' Hm Hm'. split; [now apply In |]. intros N. now apply (crossing_backwards i _ e Hv H2) in N.
    - assert (P : forall x m', above i x m' <-> above i x start).
      { intros x m'. unfold above. destruct (Rlt_dec (v i) 0); [lra |]. unfold at_. rewrite Hv. split; lra. }
      assert (C : forall x, crossing i x = None) by (intros x; unfold crossing; destruct (Req_EM_T (v i) 0); [easy | contradiction]).
      destruct He as [[H ->] | [[_ H] | [_ H]]]; [| rewrite C in H; discriminate..].
      split; [exact S |]. intros m' _ _. split.
      + apply P, (P _ (t, false)), Ha.
      + intros N. apply Hb, P, (P _ m'), N.
    - assert (In : forall m', m' ⊑ (t, false) -> ~ above i (high i) m').
      { intros m' Hm' N. apply Hb. apply above_stays with m'; [lra | exact Hm' | exact N]. }
      destruct He as [[[H1 _] ->] | [[H1 H2] | [H1 H2]]].
      + split; [exact S |]. intros m' Hm Hm'. split; [apply above_stays with start; [lra | exact Hm | exact H1] | now apply In].
      + split.
        * now apply (crossing_forwards i _ e Hv H2).
        * intros m' Hm Hm'. split; [now apply (crossing_forwards i _ e Hv H2) | now apply In].
      + now destruct (In start S). }
  assert (M : m ⊑ (t, false)) by (destruct Hone as [-> | [i Hi]]; [exact S | now apply (A i)]).
  split; [exact M |]. intros i. destruct (Hall i) as [e [He Hem]]. now apply (A i e He).
Qed.

(** And a ray that is in the box at no moment of the way in is in it nowhere: then nothing is walked. *)
Theorem no_way_in m t : way_in m -> ~ in_box m -> 0 <= t -> ~ in_box (t, false).
Proof. intros Hw Hn Ht Hbox. now destruct (way_in_is_in m t Hw Ht Hbox). Qed.
End Box.
End Moments.
