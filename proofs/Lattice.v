(** * Lattice: the walk of a ray through equal cubes passes over none that holds a point of it

    The model of accel/line.hpp and accel/lattice.hpp. Space is divided by the half-open rule: of a plane, the points at
    or beyond it are above. A ray that goes backwards along an axis is still above where it crosses, and below right
    after; so what is walked in order are moments: a parameter, and right after it.

    p i, v i               == origin and direction of the ray along the axis i;  at i t == its coordinate at t
    low i, h, count i      == the least planes, the side of a cube, how many cubes;  plane i n == the plane below the cube n
    moment, a ⊑ b, a ⊏ b    == a parameter t, or right after it; their order
    start                  == the origin
    above i x m            == at the moment m the ray is above the plane x of the axis i
    crossing i x           == when it crosses that plane, if it ever does
    in_place i n m         == at m it is between the planes of the place n;  in_cell c m: along each axis
    out i n, on i n        == when it leaves that place; the place that it then comes to
    first_out c m          == m is the first moment at which the ray leaves the cell c along some axis
    path m c l             == the walk from the cell c, entered at m: the cells of l, each with the moment of its entry
    way_in m               == m is the moment at which the ray has come between the outer planes of every axis *)
From Durero Require Import Acceleration.
From Coq Require Import Reals ZArith List Lra Lia.
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

Section Lattice.
Variables (p v low : axis -> R) (h : R) (count : axis -> Z).
Hypothesis h_positive : 0 < h.
Definition at_ (i : axis) (t : R) : R := p i + t * v i.
Definition plane (i : axis) (n : Z) : R := low i + IZR n * h.
Definition start : moment := (0, false).

Definition above (i : axis) (x : R) (m : moment) : Prop :=
  if Rlt_dec (v i) 0 then if snd m then x < at_ i (fst m) else x <= at_ i (fst m) else x <= at_ i (fst m).
Definition crossing (i : axis) (x : R) : option moment :=
  if Req_EM_T (v i) 0 then None else Some ((x - p i) / v i, if Rlt_dec (v i) 0 then true else false).

Lemma plane_next i n : plane i (n + 1) = plane i n + h.
Proof. unfold plane. rewrite plus_IZR. ring. Qed.
Lemma plane_le i m n : (m <= n)%Z -> plane i m <= plane i n.
Proof. intros H. unfold plane. apply Rplus_le_compat_l, Rmult_le_compat_r; [lra | now apply IZR_le]. Qed.

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

(** ** One axis *)

Definition in_place (i : axis) (n : Z) (m : moment) : Prop := above i (plane i n) m /\ ~ above i (plane i (n + 1)) m.
Definition backwards (i : axis) : bool := if Rlt_dec (v i) 0 then true else false.
Definition out (i : axis) (n : Z) : option moment := crossing i (plane i (if backwards i then n else n + 1)).
Definition on (i : axis) (n : Z) : Z := if backwards i then (n - 1)%Z else (n + 1)%Z.

(** The ray is in a place until it leaves it. *)
Lemma stays_in_place i n m m' : in_place i n m -> m ⊑ m' -> (forall o, out i n = Some o -> m' ⊏ o) -> in_place i n m'.
Proof.
  unfold in_place, out, backwards. intros [Ha Hb] Hm Ho. destruct (Rtotal_order (v i) 0) as [Hv | [Hv | Hv]].
  - destruct (Rlt_dec (v i) 0); [| lra]. split; [| apply below_stays with m; [lra | exact Hm | exact Hb]].
    destruct (crossing i (plane i n)) as [o |] eqn:E; [| apply crossing_never in E; lra].
    apply (crossing_backwards i _ o Hv E). now apply Ho.
  - split; [apply above_stays with m; [lra | exact Hm | exact Ha] | apply below_stays with m; [lra | exact Hm | exact Hb]].
  - destruct (Rlt_dec (v i) 0); [lra |]. split; [apply above_stays with m; [lra | exact Hm | exact Ha] |].
    destruct (crossing i (plane i (n + 1))) as [o |] eqn:E; [| apply crossing_never in E; lra].
    intros N. apply (crossing_forwards i _ o Hv E) in N. now apply N, Ho.
Qed.

(** It leaves it later than it was there, and is then in the next. *)
Lemma leaves_later i n m o : in_place i n m -> out i n = Some o -> m ⊏ o.
Proof.
  unfold in_place, out, backwards. intros [Ha Hb] Ho. destruct (Rtotal_order (v i) 0) as [Hv | [Hv | Hv]].
  - destruct (Rlt_dec (v i) 0); [| lra]. now apply (crossing_backwards i _ o Hv Ho).
  - unfold crossing in Ho. destruct (Req_EM_T (v i) 0); [discriminate | contradiction].
  - destruct (Rlt_dec (v i) 0); [lra |]. destruct (before_or_not m o) as [H | H]; [exact H |].
    destruct Hb. now apply (crossing_forwards i _ o Hv Ho).
Qed.
Lemma comes_to_next i n o : out i n = Some o -> in_place i (on i n) o.
Proof.
  unfold in_place, out, on, backwards. intros Ho. destruct (Rtotal_order (v i) 0) as [Hv | [Hv | Hv]].
  - destruct (Rlt_dec (v i) 0); [| lra]. replace (n - 1 + 1)%Z with n by ring. split.
    + unfold above. destruct (Rlt_dec (v i) 0); [| lra]. unfold crossing in Ho.
      destruct (Req_EM_T (v i) 0); [lra |]. destruct (Rlt_dec (v i) 0); [| lra]. injection Ho as <-. cbn.
      rewrite crossing_at by lra. replace n with (n - 1 + 1)%Z at 2 by ring. rewrite plane_next. lra.
    + intros N. apply (crossing_backwards i _ o Hv Ho) in N. destruct o as [t [|]]; unfold before in N; cbn in N;
        destruct N as [N | [_ [? ?]]]; try lra; discriminate.
  - unfold crossing in Ho. destruct (Req_EM_T (v i) 0); [discriminate | contradiction].
  - destruct (Rlt_dec (v i) 0); [lra |]. split.
    + apply (crossing_forwards i _ o Hv Ho). intros [N | [_ [A B]]]; [lra | congruence].
    + unfold above. destruct (Rlt_dec (v i) 0); [lra |]. unfold crossing in Ho.
      destruct (Req_EM_T (v i) 0); [lra |]. destruct (Rlt_dec (v i) 0); [lra |]. injection Ho as <-. cbn.
      rewrite crossing_at by lra. rewrite (plane_next i (n + 1)). lra.
Qed.

(** ** The three axes *)

Definition cell := axis -> Z.
Definition in_cell (c : cell) (m : moment) : Prop := forall i, in_place i (c i) m.
Definition in_range (c : cell) : Prop := forall i, (0 <= c i < count i)%Z.
(** The ray is between the outer planes of an axis; in the half-open box. *)
Definition between (i : axis) (m : moment) : Prop := above i (plane i 0) m /\ ~ above i (plane i (count i)) m.
Definition in_box (m : moment) : Prop := forall i, between i m.

Definition first_out (c : cell) (m : moment) : Prop :=
  (exists i, out i (c i) = Some m) /\ forall i o, out i (c i) = Some o -> m ⊑ o.

(** The cell that comes next: along every axis that is left at that moment. *)
Definition next_cell (c : cell) (m : moment) (c' : cell) : Prop :=
  forall i, (out i (c i) = Some m /\ c' i = on i (c i)) \/ ((forall o, out i (c i) = Some o -> m ⊏ o) /\ c' i = c i).

Inductive path : moment -> cell -> list (moment * cell) -> Prop :=
| path_ends m c o i : first_out c o -> out i (c i) = Some o -> ~ (0 <= on i (c i) < count i)%Z -> path m c [(m, c)]
| path_goes m c o c' l : first_out c o -> next_cell c o c' -> in_range c' -> path o c' l -> path m c ((m, c) :: l).

Lemma next_in_cell c m o c' : in_cell c m -> first_out c o -> next_cell c o c' -> in_cell c' o.
Proof.
  intros Hc [[i Hi] _] Hn j. destruct (Hn j) as [[Hj ->] | [Hj ->]]; [now apply comes_to_next |].
  apply stays_in_place with m; [apply Hc | | exact Hj]. apply before_not_later. now apply leaves_later with i (c i).
Qed.

(** Beyond the outer planes the ray does not come back. *)
Lemma gone i n m m' : in_place i n m -> out i n <> None -> ~ (0 <= on i n < count i)%Z -> (0 <= n < count i)%Z ->
  forall o, out i n = Some o -> o ⊑ m' -> ~ between i m'.
Proof.
  intros Hp _ Hr Hn o Ho Hm [Ha Hb]. destruct (comes_to_next i n o Ho) as [Na Nb]. unfold on, out, backwards in *.
  destruct (Rlt_dec (v i) 0) as [Hv | Hv].
  - assert (n = 0)%Z as -> by lia. apply (below_stays i (plane i 0) o m'); [lra | exact Hm | exact Nb | exact Ha].
  - assert (n + 1 = count i)%Z as E by lia. rewrite E in *. apply Hb. apply above_stays with o; [lra | exact Hm | exact Na].
Qed.

(** Every moment in the box from the entry on is in a cell of the path that was entered by then. *)
Theorem path_covers m c l : path m c l -> in_range c -> in_cell c m ->
  forall m', m ⊑ m' -> in_box m' -> exists e d, In (e, d) l /\ in_range d /\ e ⊑ m' /\ in_cell d m'.
Proof.
  assert (Here : forall m c o m', in_range c -> in_cell c m -> m ⊑ m' -> first_out c o -> m' ⊏ o -> in_cell c m').
  { intros m0 c0 o m' _ Hc Hm [_ Hfirst] Ho i. apply stays_in_place with m0; [apply Hc | exact Hm |].
    intros o' Ho'. destruct (before_or_not m' o') as [H | H]; [exact H |]. exfalso.
    now apply (not_later_trans o o' m' (Hfirst i o' Ho') H). }
  induction 1 as [m c o i Hf Ho Hr | m c o c' l Hf Hn Hr' _ IH]; intros Hr0 Hc m' Hm Hbox.
  - destruct (before_or_not m' o) as [H | H].
    + exists m, c. split; [now left | split; [exact Hr0 | split; [exact Hm |]]]. now apply Here with m o.
    + exfalso. apply (gone i (c i) m m' (Hc i)) with o; try assumption; [congruence | apply Hr0 | apply Hbox].
  - destruct (before_or_not m' o) as [H | H].
    + exists m, c. split; [now left | split; [exact Hr0 | split; [exact Hm |]]]. now apply Here with m o.
    + destruct (IH Hr' (next_in_cell c m o c' Hc Hf Hn) m' H Hbox) as [e [d [Hin Hd]]].
      exists e, d. split; [now right | exact Hd].
Qed.

(** The cells are walked in the order of their entries. *)
Theorem path_in_order m c l : path m c l -> in_cell c m -> forall e d, In (e, d) l -> m ⊑ e.
Proof.
  assert (Same : forall e : moment, e ⊑ e) by (intros [t [|]] [N | [_ [A B]]]; cbn in *; (lra || discriminate)).
  induction 1 as [m c o i Hf Ho Hr | m c o c' l Hf Hn Hr' _ IH]; intros Hc e d Hin.
  - destruct Hin as [[= <- <-] | []]. apply Same.
  - destruct Hin as [[= <- <-] | Hin]; [apply Same |]. pose proof Hf as [[i Hi] _].
    apply not_later_trans with o; [apply before_not_later; now apply leaves_later with i (c i) |].
    now apply (IH (next_in_cell c m o c' Hc Hf Hn) e d).
Qed.

(** ** The way in *)

(** Along one axis: when the ray comes between the outer planes, if it is not there at the start. *)
Definition enters (i : axis) (m : moment) : Prop :=
  (between i start /\ m = start)
  \/ (~ above i (plane i 0) start /\ crossing i (plane i 0) = Some m)
  \/ (above i (plane i (count i)) start /\ crossing i (plane i (count i)) = Some m).
Definition way_in (m : moment) : Prop :=
  (forall i, exists e, enters i e /\ e ⊑ m) /\ (m = start \/ exists i, enters i m) /\ start ⊑ m.

(** A ray that is in the box at some moment has come in by then, and is in it at the moment of the way in. *)
Lemma way_in_is_in m t : way_in m -> 0 <= t -> in_box (t, false) -> m ⊑ (t, false) /\ in_box m.
Proof.
  intros [Hall [Hone Hstart]] Ht Hbox.
  assert (S : start ⊑ (t, false)) by (intros [N | [_ [_ N]]]; cbn in N; [lra | discriminate]).
  assert (A : forall i e, enters i e -> e ⊑ (t, false) /\ forall m', e ⊑ m' -> m' ⊑ (t, false) -> between i m').
  { intros i e He. destruct (Hbox i) as [Ha Hb]. destruct (Rtotal_order (v i) 0) as [Hv | [Hv | Hv]].
    - assert (In : forall m', m' ⊑ (t, false) -> above i (plane i 0) m').
      { intros m' Hm'. destruct (crossing i (plane i 0)) as [o |] eqn:E; [| apply crossing_never in E; lra].
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
    - assert (In : forall m', m' ⊑ (t, false) -> ~ above i (plane i (count i)) m').
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

(** The walk covers the ray: wherever it is in the half-open box, it is in the closed cube of a cell of the path, which was
    entered by then. *)
Theorem walk_covers m c l t : way_in m -> in_cell c m -> in_range c -> path m c l -> 0 <= t -> in_box (t, false) ->
  exists e d, In (e, d) l /\ in_range d /\ fst e <= t /\ forall i, plane i (d i) <= at_ i t <= plane i (d i + 1).
Proof.
  intros Hw Hc Hr Hp Ht Hbox. destruct (way_in_is_in m t Hw Ht Hbox) as [Hm _].
  destruct (path_covers m c l Hp Hr Hc (t, false) Hm Hbox) as [e [d [Hin [Hd [He Hcell]]]]].
  exists e, d. split; [exact Hin | split; [exact Hd | split; [now apply not_later_le in He |]]]. intros i.
  destruct (Hcell i) as [Ha Hb]. unfold above in Ha, Hb. cbn in Ha, Hb. destruct (Rlt_dec (v i) 0); lra.
Qed.

(** And a ray that is in the box at no moment of the way in is in it nowhere: then nothing is walked. *)
Theorem no_way_in m t : way_in m -> ~ in_box m -> 0 <= t -> ~ in_box (t, false).
Proof. intros Hw Hn Ht Hbox. now destruct (way_in_is_in m t Hw Ht Hbox). Qed.
End Lattice.
