(** spec/auditoria.tex: the volume of faces that the audit finds closed, and of one mind which side is outside, is theirs and not
    the origin's: it stays where all points are moved.

    moved o r == the mesh r, each of its points moved by o *)
From Coq Require Import Reals Lra List Lia Classical_Prop Permutation.
From Durero Require Import Toolkit Especificacion Malla Auditoria.
Import ListNotations.
Local Open Scope R_scope.
Local Open Scope zed_scope.

Definition walks (r : Red) (n i j : nat) : Prop := exists c, (n, c) ∈ numbered (caras r) /\ (i, j) ∈ aristas c.
Definition de_arista (r : Red) (i j : nat) : set nat := fun n => walks r n i j \/ walks r n j i.
Definition abiertas (r : Red) : set (nat * nat) := fun e =>
  (fst e < snd e)%nat /\ exists n, forall m, m ∈ de_arista r (fst e) (snd e) <-> m = n.
Definition discordes (r : Red) : set (nat * nat) := fun e =>
  fst e <> snd e /\ exists m n, m <> n /\ walks r m (fst e) (snd e) /\ walks r n (fst e) (snd e).
Definition volumen (r : Red) (m : R) : Prop := r ∈ Completa /\ exists suma : nat -> R, suma 0%nat = 0 /\
  (forall n c t, (n, c) ∈ numbered (caras r) -> terna r c t -> suma (S n) = suma n + determinante t) /\
  6 * m = suma (length (caras r)).

Definition shifted (o p : Punto) : Punto :=
  mk_Punto (Punto_x p + Punto_x o) (Punto_y p + Punto_y o) (Punto_z p + Punto_z o).
Definition moved (o : Punto) (r : Red) : Red := mk_Red (map (shifted o) (puntos r)) (caras r).

(** ** Sums over edges *)

Definition edges (c : Cara) : list (nat * nat) := [(Cara_i c, Cara_j c); (Cara_j c, Cara_k c); (Cara_k c, Cara_i c)].
Definition proper (e : nat * nat) : bool := negb (Nat.eqb (fst e) (snd e)).
Definition back (e : nat * nat) : nat * nat := (snd e, fst e).
Fixpoint total {X} (f : X -> R) (l : list X) : R := match l with [] => 0 | x :: l => f x + total f l end.

Lemma total_app {X} (f : X -> R) l l' : total f (l ++ l') = total f l + total f l'.
Proof. induction l as [| x l IH]; cbn; [ring | rewrite IH; ring]. Qed.
Lemma total_permuted {X} (f : X -> R) l l' : Permutation l l' -> total f l = total f l'.
Proof. induction 1; cbn; lra. Qed.

(** Of edges that are each there once, and each with the one back, what changes its sign on the way back adds up to 0. *)
Lemma total_of_pairs (f : nat * nat -> R) l : (forall e, f (back e) = - f e) -> NoDup l ->
  (forall e, In e l -> In (back e) l) -> total f l = 0.
Proof.
  intros F N C.
  assert (P : Permutation l (map back l)).
  { apply NoDup_Permutation; [exact N | |].
    - apply FinFun.Injective_map_NoDup; [| exact N]. intros [a b] [c d] [= -> ->]. reflexivity.
    - intros e. rewrite in_map_iff. split.
      + intros H. exists (back e). split; [now destruct e | now apply C].
      + intros [d [<- H]]. now apply C. }
  pose proof (total_permuted f _ _ P) as T.
  assert (M : total f (map back l) = - total f l).
  { clear -F. induction l as [| e l IH]; cbn; [ring | rewrite F, IH; ring]. }
  lra.
Qed.

Lemma total_of_proper (f : nat * nat -> R) l : (forall i, f (i, i) = 0) -> total f (filter proper l) = total f l.
Proof.
  intros F. induction l as [| [i j] l IH]; cbn; [reflexivity |]. unfold proper at 1; cbn.
  destruct (Nat.eqb_spec i j) as [-> | N]; cbn; rewrite IH; [rewrite F; ring | reflexivity].
Qed.

Lemma proper_edges_once c : NoDup (filter proper (edges c)).
Proof.
  destruct c as [i j k]. unfold edges, proper; cbn.
  destruct (Nat.eqb_spec i j), (Nat.eqb_spec j k), (Nat.eqb_spec k i); cbn; subst;
    repeat (constructor; cbn; [intuition congruence |]); constructor.
Qed.

Lemma in_edges c i j : In (i, j) (edges c) <-> (i, j) ∈ aristas c.
Proof. unfold edges, aristas. cbn. intuition congruence. Qed.

Lemma once_app {X} (l l' : list X) : NoDup l -> NoDup l' -> (forall x, In x l -> ~ In x l') -> NoDup (l ++ l').
Proof.
  induction 1 as [| x l Nx N IH]; cbn; intros N' D; [exact N' |].
  constructor; [rewrite in_app_iff; intros [H | H]; [contradiction | exact (D x (or_introl eq_refl) H)] |].
  apply IH; [exact N' | intros y Hy; apply D; now right].
Qed.

(** Edges of faces at different places are different, and so each is there once. *)
Lemma edges_once l :
  (forall m n c d e, nth_error l m = Some c -> nth_error l n = Some d ->
    In e (filter proper (edges c)) -> In e (filter proper (edges d)) -> m = n) ->
  NoDup (flat_map (fun c => filter proper (edges c)) l).
Proof.
  induction l as [| c l IH]; cbn; intros D; [constructor |].
  apply once_app; [apply proper_edges_once | |].
  - apply IH. intros m n c' d e Hm Hn Hc Hd. specialize (D (S m) (S n) c' d e Hm Hn Hc Hd). lia.
  - intros e Hc He. apply in_flat_map in He as [d [Hd He]]. apply In_nth_error in Hd as [n Hn].
    specialize (D 0%nat (S n) c d e eq_refl Hn Hc He). discriminate.
Qed.

(** ** The edges of a closed mesh *)

Section Closed.
Variables (r : Red).
Hypothesis closed : abiertas r ≡ ∅.
Hypothesis agreed : discordes r ≡ ∅.

Notation all := (flat_map (fun c => filter proper (edges c)) (caras r)).

Lemma in_all i j : In (i, j) all <-> i <> j /\ exists n, walks r n i j.
Proof.
  rewrite in_flat_map. split.
  - intros [c [Hc He]]. apply filter_In in He as [He P]. apply In_nth_error in Hc as [n Hn]. split.
    + unfold proper in P; cbn in P. destruct (Nat.eqb_spec i j); [discriminate | assumption].
    + exists n, c. split; [exact Hn | now apply in_edges].
  - intros [N [n [c [Hn He]]]]. exists c. split; [now apply (nth_error_In _ n) |].
    apply filter_In. split; [now apply in_edges |]. unfold proper; cbn. destruct (Nat.eqb_spec i j); [contradiction | reflexivity].
Qed.

Lemma all_once : NoDup all.
Proof.
  apply edges_once. intros m n c d [i j] Hm Hn Hc Hd.
  apply filter_In in Hc as [Hc P]. apply filter_In in Hd as [Hd _].
  destruct (Nat.eq_dec m n) as [E | N]; [exact E |]. exfalso.
  apply (proj1 (agreed (i, j))). split; cbn.
  - unfold proper in P; cbn in P. destruct (Nat.eqb_spec i j); [discriminate | assumption].
  - exists m, n. split; [exact N |]. split; [exists c | exists d]; (split; [assumption | now apply in_edges]).
Qed.

(** No face alone has an edge, and no two walk it the same way: another walks it back. *)
Lemma walked_back i j n : i <> j -> walks r n i j -> exists m, walks r m j i.
Proof.
  intros N W. destruct (classic (exists m, walks r m j i)) as [Y | No]; [exact Y |]. exfalso.
  assert (One : forall m, (walks r m i j \/ walks r m j i) <-> m = n).
  { intros m. split.
    - intros [H | H]; [| destruct No; now exists m].
      destruct (Nat.eq_dec m n) as [E | D]; [exact E |]. exfalso. apply (proj1 (agreed (i, j))).
      split; [exact N | exists m, n; now split].
    - intros ->. now left. }
  destruct (Nat.lt_trichotomy i j) as [L | [E | L]]; [| contradiction |].
  - apply (proj1 (closed (i, j))). split; [exact L | exists n; exact One].
  - apply (proj1 (closed (j, i))). split; [exact L |]. exists n. intros m. unfold de_arista; cbn. rewrite <- One. tauto.
Qed.

Lemma total_of_edges (f : nat * nat -> R) : (forall i j, f (j, i) = - f (i, j)) -> total f (flat_map edges (caras r)) = 0.
Proof.
  intros F.
  assert (D : forall i, f (i, i) = 0) by (intros i; specialize (F i i); lra).
  assert (E : total f all = total f (flat_map edges (caras r))).
  { induction (caras r) as [| c l IH]; cbn [flat_map]; [reflexivity |]. now rewrite !total_app, total_of_proper, IH. }
  rewrite <- E. apply total_of_pairs; [intros [i j]; apply F | exact all_once |].
  intros [i j] H. unfold back; cbn. apply in_all in H as [N [n W]]. apply in_all. split; [congruence |].
  now apply (walked_back i j n).
Qed.
End Closed.

(** ** The volume *)

Definition det (a b c : Punto) : R := determinante (mk_Terna a b c).

Lemma det_shifted o a b c : det (shifted o a) (shifted o b) (shifted o c) = det a b c + det o a b + det o b c + det o c a.
Proof. unfold det, determinante, shifted; cbn. ring. Qed.
Lemma det_back o a b : det o b a = - det o a b.
Proof. unfold det, determinante; cbn. ring. Qed.

Definition origin : Punto := mk_Punto 0 0 0.
Definition point (l : list Punto) (i : nat) : Punto := nth i l origin.
Definition det_of (l : list Punto) (c : Cara) : R := det (point l (Cara_i c)) (point l (Cara_j c)) (point l (Cara_k c)).

Lemma point_of l i p : (i, p) ∈ numbered l -> point l i = p.
Proof. intros H. exact (nth_error_nth l i origin H). Qed.

Lemma det_of_terna r c t : terna r c t -> determinante t = det_of (puntos r) c.
Proof. intros [A [B C]]. unfold det_of. rewrite (point_of _ _ _ A), (point_of _ _ _ B), (point_of _ _ _ C). now destruct t. Qed.

Lemma firstn_next {X} (l : list X) n x : nth_error l n = Some x -> firstn (S n) l = firstn n l ++ [x].
Proof.
  revert n. induction l as [| y l IH]; intros [| n]; cbn; intros H; try discriminate; [now injection H as -> |].
  now rewrite <- (IH n H).
Qed.

Lemma terna_there r c n : r ∈ Completa -> (n, c) ∈ numbered (caras r) -> exists t, terna r c t.
Proof. intros C N. apply a_face_has_one_triple, C. now exists n. Qed.

Lemma volumen_is_total r m : volumen r m <-> r ∈ Completa /\ 6 * m = total (det_of (puntos r)) (caras r).
Proof.
  split; intros [C V]; (split; [exact C |]).
  - destruct V as [s [Z [N ->]]].
    assert (S : forall n, (n <= length (caras r))%nat -> s n = total (det_of (puntos r)) (firstn n (caras r))).
    { induction n as [| n IH]; intros L; [exact Z |].
      destruct (nth_error (caras r) n) as [c |] eqn:E; [| apply nth_error_None in E; lia].
      destruct (terna_there r c n C E) as [t T]. rewrite (N n c t E T), (IH ltac:(lia)), (firstn_next _ _ _ E), total_app.
      cbn. rewrite (det_of_terna _ _ _ T). ring. }
    rewrite S by lia. now rewrite firstn_all.
  - exists (fun n => total (det_of (puntos r)) (firstn n (caras r))). split; [reflexivity |]. split.
    + intros n c t E T. change (nth_error (caras r) n = Some c) in E. rewrite (firstn_next _ _ _ E), total_app. cbn. rewrite (det_of_terna _ _ _ T). ring.
    + now rewrite firstn_all.
Qed.

Lemma completa_moved o r : r ∈ Completa -> moved o r ∈ Completa.
Proof.
  intros C c Hc i Hi. specialize (C c Hc i Hi). apply dom_numbered in C. apply dom_numbered.
  unfold moved, below in *; cbn. now rewrite map_length.
Qed.

Lemma point_moved o r c i : r ∈ Completa -> In c (caras r) -> i ∈ corners_of c ->
  point (puntos (moved o r)) i = shifted o (point (puntos r) i).
Proof.
  intros C Hc Hi. apply In_nth_error in Hc as [n Hn].
  assert (Rc : ran (numbered (caras r)) c) by now exists n.
  destruct (C c Rc i Hi) as [p Hp]. rewrite (point_of _ _ _ Hp). apply point_of.
  unfold numbered in *; cbn in *. now rewrite nth_error_map, Hp.
Qed.

(** What is closed, and agrees which side is outside, has one volume, from wherever it is seen. Discharges de_arista.def.1,
    abiertas.def.1, discordes.def.1, volumen.def.1. *)
Theorem a_closed_mesh_has_one_volume o r m : abiertas r ≡ ∅ -> discordes r ≡ ∅ -> volumen r m -> volumen (moved o r) m.
Proof.
  intros A D V. apply volumen_is_total in V as [C V]. apply volumen_is_total. split; [now apply completa_moved |].
  rewrite V. cbn [caras moved]. set (f := fun e => det o (point (puntos r) (fst e)) (point (puntos r) (snd e))).
  pose proof (total_of_edges r A D f (fun i j => det_back o _ _)) as Z.
  assert (E : forall l, incl l (caras r) ->
    total (det_of (puntos (moved o r))) l = total (det_of (puntos r)) l + total f (flat_map edges l)).
  { induction l as [| c l IH]; intros L; cbn [total flat_map]; [cbn; ring |].
    rewrite total_app, IH by (intros x Hx; apply L; now right). unfold det_of at 1.
    rewrite !(point_moved o r c) by first [exact C | apply L; now left | now left; left | now left; right | now right].
    rewrite det_shifted. unfold edges, f, det_of; cbn. ring. }
  rewrite (E (caras r) (incl_refl _)), Z. ring.
Qed.
