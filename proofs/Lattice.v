(** * Lattice: the walk of a ray through equal cubes passes over none that holds a point of it

    The model of accel/lattice.hpp, which walks by the moments of accel/line.hpp.

    p i, v i               == origin and direction of the ray along the axis i
    low i, h, count i      == the least planes, the side of a cube, how many cubes;  plane i n == the plane below the cube n
    in_place i n m         == at m it is between the planes of the place n;  in_cell c m: along each axis
    out i n, on i n        == when it leaves that place; the place that it then comes to
    first_out c m          == m is the first moment at which the ray leaves the cell c along some axis
    path m c l             == the walk from the cell c, entered at m: the cells of l, each with the moment of its entry *)
From Durero Require Import Acceleration Moments.
From Coq Require Import Reals ZArith List Lra Lia.
Import ListNotations.
Local Open Scope R_scope.

Section Lattice.
Variables (p v low : axis -> R) (h : R) (count : axis -> Z).
Hypothesis h_positive : 0 < h.
Definition plane (i : axis) (n : Z) : R := low i + IZR n * h.
Notation at_ := (Moments.at_ p v).
Notation above := (Moments.above p v).
Notation crossing := (Moments.crossing p v).
Notation above_stays := (Moments.above_stays p v).
Notation below_stays := (Moments.below_stays p v).
Notation crossing_forwards := (Moments.crossing_forwards p v).
Notation crossing_backwards := (Moments.crossing_backwards p v).
Notation crossing_never := (Moments.crossing_never p v).
Notation crossing_at := (Moments.crossing_at p v).

Lemma plane_next i n : plane i (n + 1) = plane i n + h.
Proof. unfold plane. rewrite plus_IZR. ring. Qed.
Lemma plane_le i m n : (m <= n)%Z -> plane i m <= plane i n.
Proof. intros H. unfold plane. apply Rplus_le_compat_l, Rmult_le_compat_r; [lra | now apply IZR_le]. Qed.

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
(** The half-open box, and the way in. *)
Definition in_box : moment -> Prop := Moments.in_box p v (fun i => plane i 0) (fun i => plane i (count i)).
Definition way_in : moment -> Prop := Moments.way_in p v (fun i => plane i 0) (fun i => plane i (count i)).
Notation between := (Moments.between p v (fun i => plane i 0) (fun i => plane i (count i))).

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

(** The walk covers the ray: wherever it is in the half-open box, it is in the closed cube of a cell of the path, which was
    entered by then. *)
Theorem walk_covers m c l t : way_in m -> in_cell c m -> in_range c -> path m c l -> 0 <= t -> in_box (t, false) ->
  exists e d, In (e, d) l /\ in_range d /\ fst e <= t /\ forall i, plane i (d i) <= at_ i t <= plane i (d i + 1).
Proof.
  intros Hw Hc Hr Hp Ht Hbox. destruct (way_in_is_in p v _ _ m t Hw Ht Hbox) as [Hm _].
  destruct (path_covers m c l Hp Hr Hc (t, false) Hm Hbox) as [e [d [Hin [Hd [He Hcell]]]]].
  exists e, d. split; [exact Hin | split; [exact Hd | split; [now apply not_later_le in He |]]]. intros i.
  destruct (Hcell i) as [Ha Hb]. unfold above in Ha, Hb. cbn in Ha, Hb. destruct (Rlt_dec (v i) 0); lra.
Qed.

End Lattice.
