(** spec/auditoria.tex: what the audit finds in sets of faces. Pieces divide the faces; a point is singular where its faces are
    no fan; what has neither open nor multiple edges bounds something; a face that stands twice shares all its edges.

    face r n c   == the face c stands at the number n;  touch r n m == the faces n and m have a point in common
    step r v n m == the faces n and m have the point v and another
    fan r v      == by such steps each face that has v is reached from each *)
From Coq Require Import Reals Lia Lra List Classical Relations.
From Durero Require Import Toolkit Especificacion Malla Auditoria VolumeOfMesh.
Import ListNotations.
Local Open Scope zed_scope.

Definition face (r : Red) (n : nat) (c : Cara) : Prop := (n, c) ∈ numbered (caras r).
Definition faces (r : Red) : set nat := dom (numbered (caras r)).
Definition touch (r : Red) (n m : nat) : Prop :=
  exists c d v, face r n c /\ face r m d /\ v ∈ esquinas c /\ v ∈ esquinas d.
Definition cerradas (r : Red) : set (set nat) := fun s =>
  (exists n, n ∈ s) /\ s ⊆ faces r /\ forall n m, n ∈ s -> m ∈ faces r -> touch r n m -> m ∈ s.
Definition piezas (r : Red) : set (set nat) := fun s => s ∈ cerradas r /\ forall t, t ∈ cerradas r -> t ⊆ s -> t ≡ s.

Lemma one_face r n c d : face r n c -> face r n d -> c = d.
Proof. exact (numbered_functional (caras r) n c d). Qed.
Lemma touch_back r n m : touch r n m -> touch r m n.
Proof. intros (c & d & v & C & D & V & W). now exists d, c, v. Qed.

(** What a closed set leaves of another is closed, where it leaves something. *)
Lemma rest_is_closed r s t : s ∈ cerradas r -> t ∈ cerradas r -> (exists n, n ∈ s /\ n ∉ t) -> (fun n => n ∈ s /\ n ∉ t) ∈ cerradas r.
Proof.
  intros (_ & Ss & Sc) (_ & _ & Tc) N. split; [exact N |]. split; [intros n [H _]; now apply Ss |].
  intros n m [Hs Ht] Hm H. split; [exact (Sc n m Hs Hm H) |]. intros Mt. apply Ht.
  exact (Tc m n Mt (Ss n Hs) (touch_back _ _ _ H)).
Qed.

(** Each face is in a piece, and pieces that have a face in common are one. Discharges cerradas.def.1, piezas.def.1. *)
Theorem pieces_divide_the_faces r :
  (forall n, n ∈ faces r -> exists s, s ∈ piezas r /\ n ∈ s)
  /\ (forall s t n, s ∈ piezas r -> t ∈ piezas r -> n ∈ s -> n ∈ t -> s ≡ t).
Proof.
  assert (Part : forall s t n, s ∈ piezas r -> t ∈ cerradas r -> n ∈ s -> n ∈ t -> s ⊆ t).
  { intros s t n [S Least] T Hs Ht m Ms. destruct (classic (m ∈ t)) as [H | H]; [exact H | exfalso].
    pose proof (rest_is_closed r s t S T (ex_intro _ m (conj Ms H))) as R.
    destruct (proj2 (Least _ R (fun k K => proj1 K) n) Hs) as [_ K]. contradiction. }
  split.
  - intros n Hn. exists (fun m => forall t, t ∈ cerradas r -> n ∈ t -> m ∈ t).
    assert (All : faces r ∈ cerradas r) by (split; [now exists n | split; [now intros k K | auto]]).
    assert (Own : (fun m => forall t, t ∈ cerradas r -> n ∈ t -> m ∈ t) ∈ cerradas r).
    { split; [now exists n |]. split; [intros m H; exact (H _ All Hn) |].
      intros a b A B H t T N. exact (proj2 (proj2 T) a b (A t T N) B H). }
    split; [| auto]. split; [exact Own |]. intros t T Sub m. split; [apply Sub |]. intros H.
    destruct (classic (n ∈ t)) as [N | N]; [exact (H t T N) | exfalso].
    pose proof (rest_is_closed r _ t Own T (ex_intro _ n (conj (fun u _ K => K) N))) as R.
    destruct T as ((k & K) & _). destruct (Sub k K _ R (conj (fun u _ J => J) N)) as [_ J]. contradiction.
  - intros s t n S T Hs Ht m. split; [exact (Part s t n S (proj1 T) Hs Ht m) | exact (Part t s n T (proj1 S) Ht Hs m)].
Qed.

(** ** The faces about a point *)

Definition de_punto (r : Red) (v : nat) : set nat := fun n => exists c, face r n c /\ v ∈ esquinas c.
Definition singulares (r : Red) : set nat := fun v => exists s : set nat, (exists n, n ∈ s) /\ s ⊆ de_punto r v /\ ~ s ≡ de_punto r v
  /\ forall n m c d, n ∈ s -> m ∈ de_punto r v -> m ∉ s -> face r n c -> face r m d -> esquinas c ∩ esquinas d ≡ ⦃v⦄.
Definition step (r : Red) (v n m : nat) : Prop :=
  exists c d w, face r n c /\ face r m d /\ v ∈ esquinas c /\ v ∈ esquinas d /\ w <> v /\ w ∈ esquinas c /\ w ∈ esquinas d.
Definition fan (r : Red) (v : nat) : Prop := forall n m, n ∈ de_punto r v -> m ∈ de_punto r v -> clos_refl_trans nat (step r v) n m.

(** A point is singular exactly where its faces are no fan. Discharges de_punto.def.1, singulares.def.1. *)
Theorem a_point_without_a_fan_is_singular r v : v ∈ singulares r <-> ~ fan r v.
Proof.
  split.
  - intros (s & (n & Hn) & Sub & Less & Apart) F. apply Less. intros m. split; [apply Sub |]. intros Hm.
    pose proof (F n m (Sub n Hn) Hm) as Way. apply clos_rt_rt1n in Way.
    assert (P : forall a b, clos_refl_trans_1n nat (step r v) a b -> a ∈ s -> b ∈ s).
    { induction 1 as [a | a b d (c & e & w & C & E & Vc & Ve & W & Wc & We) _ IH]; [auto |]. intros A. apply IH.
      destruct (classic (b ∈ s)) as [B | B]; [exact B | exfalso].
      destruct (proj1 (Apart a b c e A (ex_intro _ e (conj E Ve)) B C E w) (conj Wc We)). now apply W. }
    exact (P n m Way Hn).
  - intros N. apply not_all_ex_not in N as [n N]. apply not_all_ex_not in N as [m N]. apply imply_to_and in N as [Hn N].
    apply imply_to_and in N as [Hm N]. exists (fun k => k ∈ de_punto r v /\ clos_refl_trans nat (step r v) n k).
    split; [exists n; split; [exact Hn | apply rt_refl] |]. split; [now intros k [K _] |].
    split; [intros E; destruct (proj2 (E m) Hm); contradiction |].
    intros a b c d [A W] B Out C D w. split; [| intros ->; split].
    + intros [Wc Wd]. destruct (Nat.eq_dec w v) as [-> | Nw]; [reflexivity | exfalso]. apply Out. split; [exact B |].
      apply rt_trans with a; [exact W |]. apply rt_step. destruct A as (c' & C' & Vc), B as (d' & D' & Vd).
      rewrite (one_face r a c' c C' C) in Vc. rewrite (one_face r b d' d D' D) in Vd. now exists c, d, w.
    + destruct A as (c' & C' & Vc). now rewrite (one_face r a c' c C' C) in Vc.
    + destruct B as (d' & D' & Vd). now rewrite (one_face r b d' d D' D) in Vd.
Qed.

(** ** Edges *)

Definition multiples (r : Red) : set (nat * nat) := fun e => (fst e < snd e)%nat /\ exists l m n, l <> m /\ m <> n /\ n <> l
  /\ de_arista r (fst e) (snd e) l /\ de_arista r (fst e) (snd e) m /\ de_arista r (fst e) (snd e) n.
(** A set has so many members. *)
Definition counts (s : set nat) (k : nat) : Prop := exists l, NoDup l /\ length l = k /\ forall n, In n l <-> n ∈ s.
Definition pares (r : Red) : Prop := r ∈ Malla /\ forall i j, exists k, counts (de_arista r i j) (2 * k).

Lemma corners_differ r n c : r ∈ Malla -> face r n c -> Cara_i c <> Cara_j c /\ Cara_j c <> Cara_k c /\ Cara_k c <> Cara_i c.
Proof.
  intros [_ M] C. destruct (M c (ex_intro _ n C)) as (t & (I & J & K) & V).
  assert (E : forall a b p q, (a, p) ∈ numbered (puntos r) -> (b, q) ∈ numbered (puntos r) -> a = b -> p = q)
    by (intros a b p q P Q ->; exact (numbered_functional _ _ _ _ P Q)).
  repeat split; intros H; apply V; [rewrite (E _ _ _ _ I J H) | rewrite (E _ _ _ _ J K H) | rewrite (E _ _ _ _ K I H)];
    repeat split; ring.
Qed.
Lemma edge_of_two r n i j : r ∈ Malla -> walks r n i j -> i <> j.
Proof.
  intros M (c & C & A). destruct (corners_differ r n c M C) as (X & Y & Z).
  destruct A as [A | [A | A]]; injection A as -> ->; assumption.
Qed.
Lemma either_way r i j n : n ∈ de_arista r i j <-> n ∈ de_arista r j i.
Proof. unfold de_arista. tauto. Qed.

(** A mesh whose edges are neither open nor multiple bounds something. Discharges multiples.def.1, pares.def.1. *)
Theorem what_has_neither_open_nor_multiple_edges_bounds r : r ∈ Malla -> abiertas r ≡ ∅ -> multiples r ≡ ∅ -> pares r.
Proof.
  intros M Open Many. split; [exact M |].
  assert (Less : forall i j, (i < j)%nat -> exists k, counts (de_arista r i j) (2 * k)).
  { intros i j L. destruct (classic (exists n, n ∈ de_arista r i j)) as [[n N] | No].
    - destruct (classic (exists m, m <> n /\ m ∈ de_arista r i j)) as [[m [D Hm]] | One].
      + exists 1%nat, [n; m]. split; [repeat constructor; cbn; intuition congruence |]. split; [reflexivity |]. intros o. cbn.
        split; [intros [<- | [<- | []]]; assumption |]. intros O. destruct (Nat.eq_dec o n) as [-> | On]; [now left |].
        destruct (Nat.eq_dec o m) as [-> | Om]; [right; now left | exfalso].
        apply (proj1 (Many (i, j))). split; [exact L |]. exists n, m, o. repeat split; auto.
      + exfalso. apply (proj1 (Open (i, j))). split; [exact L |]. exists n. intros m. split; [| now intros ->].
        intros Hm. destruct (Nat.eq_dec m n) as [E | E]; [exact E |]. destruct One. now exists m.
    - exists 0%nat, []. split; [constructor | split; [reflexivity |]]. intros o. split; [intros [] |]. intros O. destruct No. now exists o. }
  intros i j. destruct (Nat.lt_trichotomy i j) as [L | [<- | L]]; [now apply Less | |].
  - exists 0%nat, []. split; [constructor | split; [reflexivity |]]. intros o. split; [intros [] |].
    intros [W | W]; exact (False_ind _ (edge_of_two r o i i M W eq_refl)).
  - destruct (Less j i L) as (k & l & U & K & S). exists k, l. split; [exact U | split; [exact K |]]. intros n. rewrite S. apply either_way.
Qed.

Definition repetidas (r : Red) : set nat := fun n => exists m c d, (m < n)%nat /\ face r n c /\ face r m d /\ esquinas c ≡ esquinas d.

Lemma edge_of_corners r n c i j : face r n c -> i <> j -> i ∈ esquinas c -> j ∈ esquinas c -> n ∈ de_arista r i j.
Proof.
  intros C D I J. assert (H : (i, j) ∈ aristas c \/ (j, i) ∈ aristas c).
  { unfold aristas. destruct I as [[I | I] | I], J as [[J | J] | J]; rewrite I, J in *; intuition. }
  destruct H as [H | H]; [left | right]; now exists c.
Qed.
Lemma corners_of_an_edge c i j : (i, j) ∈ aristas c -> i ∈ esquinas c /\ j ∈ esquinas c.
Proof.
  unfold esquinas, corners_of, union, single. intros [H | [H | H]]; injection H as -> ->; intuition.
Qed.

(** In a mesh a face that stands twice shares each of its edges with the one before it. Discharges repetidas.def.1. *)
Theorem a_face_that_stands_twice_shares_its_edges r n : r ∈ Malla -> n ∈ repetidas r -> exists m, (m < n)%nat
  /\ forall i j, n ∈ de_arista r i j <-> m ∈ de_arista r i j.
Proof.
  intros M (m & c & d & L & C & D & E). exists m. split; [exact L |].
  assert (P : forall a b e f, face r a e -> face r b f -> esquinas e ≡ esquinas f -> forall i j, a ∈ de_arista r i j -> b ∈ de_arista r i j).
  { intros a b e f A B S i j H. assert (N : i <> j).
    { destruct H as [W | W]; [| apply not_eq_sym]; exact (edge_of_two r a _ _ M W). }
    assert (K : i ∈ esquinas e /\ j ∈ esquinas e).
    { destruct H as [(g & G & W) | (g & G & W)]; rewrite (one_face r a g e G A) in W; apply corners_of_an_edge in W; tauto. }
    apply (edge_of_corners r b f); [exact B | exact N | apply S, K | apply S, K]. }
  intros i j. split; [exact (P n m c d C D E i j) | apply (P m n d c D C)]. intros x. symmetry. apply E.
Qed.

(** ** Faces without area *)

Definition degeneradas (r : Red) : set nat := fun n => exists c, face r n c /\ ~ exists t, terna r c t /\ t ∈ Vertices.

(** Faces of points are a mesh exactly where none of them is degenerate. Discharges degeneradas.def.1. *)
Theorem a_mesh_has_no_degenerate_face r : r ∈ Completa -> (r ∈ Malla <-> degeneradas r ≡ ∅).
Proof.
  intros F. split.
  - intros [_ M] n. split; [| intros []]. intros (c & C & N). destruct N. apply M. now exists n.
  - intros N. split; [exact F |]. intros c [n C]. apply NNPP. intros K. apply (proj1 (N n)). now exists c.
Qed.

(** ** Points of the skin *)

Definition piel (r : Red) : set Punto := fun w => exists n c, face r n c /\ w ∈ envolvente r (esquinas c).
Definition uniones_en_t (r : Red) : set (nat * nat * nat) := fun e => let '(v, i, j) := e in
  (i < j)%nat /\ (exists n, n ∈ de_arista r i j) /\ (exists n c, face r n c /\ v ∈ esquinas c)
  /\ exists p q w, (i, p) ∈ numbered (puntos r) /\ (j, q) ∈ numbered (puntos r) /\ (v, w) ∈ numbered (puntos r)
    /\ p <> q /\ entre p q w.

(** The point at which faces meet without a vertex in common lies on the skin: on a face that has the edge. Discharges
    piel.def.1, uniones_en_t.def.1. *)
Theorem a_junction_lies_on_a_face_of_its_edge r v i j : (v, i, j) ∈ uniones_en_t r -> exists n c w, n ∈ de_arista r i j
  /\ face r n c /\ (v, w) ∈ numbered (puntos r) /\ w ∈ envolvente r (esquinas c) /\ w ∈ piel r.
Proof.
  intros (_ & (n & N) & _ & p & q & w & P & Q & W & _ & s & S & S1 & X & Y & Z). unfold Rmas in S. cbn in S.
  assert (H : exists c, face r n c /\ i ∈ esquinas c /\ j ∈ esquinas c).
  { destruct N as [(c & C & A) | (c & C & A)]; apply corners_of_an_edge in A; exists c; tauto. }
  destruct H as (c & C & I & J). exists n, c, w.
  assert (E : w ∈ envolvente r (esquinas c)).
  { exists i, j, j, p, q, q, (1 - s)%R, s, 0%R. repeat split; auto; try lra; rewrite ?X, ?Y, ?Z; ring. }
  repeat split; auto. now exists n, c.
Qed.
