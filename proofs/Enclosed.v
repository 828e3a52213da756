(** spec/auditoria.tex: the points that faces enclose. A convex mesh, each face of which has a plane of its own with all other
    points on one side, encloses what lies on that side of all its planes. *)
From Coq Require Import Reals Lia Lra List Classical.
From Durero Require Import Toolkit Especificacion Malla Auditoria VolumeOfMesh Pieces.
Import ListNotations.
Local Open Scope R_scope.
Local Open Scope zed_scope.

Definition meets (r : Red) (ray : Rayo) (s : set nat) : Prop := exists x, x ∈ puntos_de_rayo ray /\ x ∈ envolvente r s.
Definition encerrados (r : Red) : set Punto := fun w => pares r /\ w ∉ piel r /\ exists ray k, Rayo_ok ray /\ Rayo_p ray = w
  /\ (forall n c i j, face r n c -> (i, j) ∈ aristas c -> ~ meets r ray (⦃i⦄ ∪ ⦃j⦄))
  /\ counts (fun n => exists c, face r n c /\ meets r ray (esquinas c)) (2 * k + 1).

(** The plane along d at this level has the corners of a face, and all other points before it. *)
Definition bears (r : Red) (n : nat) (d : Punto) (level : R) : Prop := exists c, face r n c /\
  forall i p, (i, p) ∈ numbered (puntos r) -> (i ∈ esquinas c -> along d p = level) /\ (i ∉ esquinas c -> along d p < level).

Lemma along_hull r (s : set nat) d level x : (forall i p, i ∈ s -> (i, p) ∈ numbered (puntos r) -> along d p = level) ->
  x ∈ envolvente r s -> along d x = level.
Proof.
  intros H (i & j & k & p & q & t & f & g & h & (I & P) & (J & Q) & (K & T) & M).
  rewrite (along_mean d _ _ _ _ _ _ _ M), (H i p I P), (H j q J Q), (H k t K T). destruct M as [(_ & _ & _ & E) _ _ _].
  rewrite <- !Rmult_plus_distr_r, E. ring.
Qed.
Lemma before_hull r (s : set nat) d level x : (forall i p, (i, p) ∈ numbered (puntos r) -> along d p <= level) ->
  x ∈ envolvente r s -> along d x <= level.
Proof.
  intros H (i & j & k & p & q & t & f & g & h & (_ & P) & (_ & Q) & (_ & T) & M).
  rewrite (along_mean d _ _ _ _ _ _ _ M). destruct M as [(F & G & L & E) _ _ _].
  replace level with (f * level + g * level + h * level) by (rewrite <- !Rmult_plus_distr_r, E; ring).
  repeat apply Rplus_le_compat; apply Rmult_le_compat_l; auto; eapply H; eassumption.
Qed.

(** Two faces of a mesh, of which none stands twice, differ in a corner. *)
Lemma a_corner_apart r n m c e : r ∈ Malla -> repetidas r ≡ ∅ -> n <> m -> face r n c -> face r m e ->
  exists i, i ∈ esquinas c /\ i ∉ esquinas e.
Proof.
  intros M Once D C E. apply NNPP. intros N.
  assert (S : forall i, i ∈ esquinas c -> i ∈ esquinas e) by (intros i I; apply NNPP; intros K; apply N; now exists i).
  assert (Same : esquinas c ≡ esquinas e).
  { destruct (corners_differ r n c M C) as (X & Y & Z), (corners_differ r m e M E) as (X' & Y' & Z').
    pose proof (S (Cara_i c) (or_introl (or_introl eq_refl))) as I.
    pose proof (S (Cara_j c) (or_introl (or_intror eq_refl))) as J.
    pose proof (S (Cara_k c) (or_intror eq_refl)) as K.
    intros i. split; [apply S |]. unfold esquinas, corners_of, union, single in *.
    destruct I as [[I | I] | I], J as [[J | J] | J], K as [[K | K] | K]; rewrite I, J, K in *; intuition congruence. }
  destruct (Nat.lt_trichotomy n m) as [L | [L | L]]; [| contradiction |].
  - apply (proj1 (Once m)). exists n, e, c. repeat split; auto; apply Same.
  - apply (proj1 (Once n)). exists m, c, e. repeat split; auto; apply Same.
Qed.

Section Convex.
Variables (r : Red) (w : Punto).
Hypothesis bounds : pares r.
Hypothesis once : repetidas r ≡ ∅.
Hypothesis within : forall n, n ∈ faces r -> exists d level, bears r n d level /\ along d w < level.

Lemma before_each d level n : bears r n d level -> forall i p, (i, p) ∈ numbered (puntos r) -> along d p <= level.
Proof.
  intros (c & _ & B) i p P. destruct (B i p P) as [On Off], (classic (i ∈ esquinas c)) as [I | I];
    [rewrite (On I); lra | specialize (Off I); lra].
Qed.
Lemma on_own d level n c s x : bears r n d level -> face r n c -> s ⊆ esquinas c -> x ∈ envolvente r s -> along d x = level.
Proof.
  intros (c' & C' & B) C Sub. rewrite (one_face r n c' c C' C) in B. apply along_hull. intros i p I P. apply (B i p P), Sub, I.
Qed.

Lemma not_on_the_skin : w ∉ piel r.
Proof.
  intros (n & c & C & W). destruct (within n (ex_intro _ c C)) as (d & level & B & L).
  pose proof (on_own d level n c (esquinas c) w B C (fun i I => I) W). lra.
Qed.

(** The ray goes through the middle of a face. *)
Variables (n : nat) (c : Cara) (t : Terna) (d : Punto) (level : R).
Hypothesis c_there : face r n c.
Hypothesis t_there : terna r c t.
Hypothesis d_bears : bears r n d level.
Hypothesis w_before : along d w < level.
Definition middle : Punto :=
  mk_Punto ((Punto_x (Terna_a t) + Punto_x (Terna_b t) + Punto_x (Terna_c t)) / 3)
    ((Punto_y (Terna_a t) + Punto_y (Terna_b t) + Punto_y (Terna_c t)) / 3)
    ((Punto_z (Terna_a t) + Punto_z (Terna_b t) + Punto_z (Terna_c t)) / 3).
Definition to_middle : Rayo :=
  mk_Rayo w (mk_Vector (Punto_x middle - Punto_x w) (Punto_y middle - Punto_y w) (Punto_z middle - Punto_z w)).

Lemma along_middle e : along e middle = (along e (Terna_a t) + along e (Terna_b t) + along e (Terna_c t)) / 3.
Proof. unfold along, middle. cbn. field. Qed.
Lemma along_ray x : x ∈ puntos_de_rayo to_middle -> exists s, 0 < s
  /\ (forall e, along e x = (1 - s) * along e w + s * along e middle) /\ (s = 1 -> x = middle).
Proof.
  intros (s & S & X & Y & Z). exists s. split; [exact S |]. cbn in X, Y, Z.
  split; [intros e; unfold along; rewrite X, Y, Z; cbn; ring |].
  intros ->. destruct x as [a b g]. cbn in *. unfold middle. f_equal; rewrite ?X, ?Y, ?Z; field.
Qed.
Lemma middle_on : middle ∈ envolvente r (esquinas c).
Proof.
  destruct t_there as (I & J & K). exists (Cara_i c), (Cara_j c), (Cara_k c), (Terna_a t), (Terna_b t), (Terna_c t), (1 / 3), (1 / 3), (1 / 3).
  unfold esquinas, corners_of, union, single. repeat split; auto; cbn; try lra; unfold middle; cbn; field.
Qed.
Lemma middle_at : along d middle = level.
Proof. exact (on_own d level n c (esquinas c) middle d_bears c_there (fun i I => I) middle_on). Qed.

(** The middle lies before the plane of each other face. *)
Lemma middle_before m e level' : m <> n -> bears r m e level' -> along e middle < level'.
Proof.
  intros D (c' & C' & B).
  destruct (a_corner_apart r n m c c' (proj1 bounds) once (not_eq_sym D) c_there C') as (i & I & Not).
  destruct t_there as (P & Q & T). rewrite along_middle.
  assert (Le : forall i p, (i, p) ∈ numbered (puntos r) -> along e p <= level') by (apply (before_each e level' m); now exists c').
  pose proof (Le _ _ P). pose proof (Le _ _ Q). pose proof (Le _ _ T).
  destruct I as [[I | I] | I]; unfold single in I; subst i;
    [pose proof (proj2 (B _ _ P) Not) | pose proof (proj2 (B _ _ Q) Not) | pose proof (proj2 (B _ _ T) Not)]; lra.
Qed.

(** No other face has a point of the ray. *)
Lemma others_missed m e s : m <> n -> face r m e -> s ⊆ esquinas e -> ~ meets r to_middle s.
Proof.
  intros D E Sub (x & X & Hx). destruct (within m (ex_intro _ e E)) as (d' & level' & B & L).
  pose proof (on_own d' level' m e s x B E Sub Hx) as At. pose proof (middle_before m d' level' D B) as Before.
  pose proof (before_hull r s d level x (before_each d level n d_bears) Hx) as Most.
  destruct (along_ray x X) as (u & U & A & _). rewrite A in At, Most. rewrite middle_at in Most.
  destruct (Rle_or_lt u 1) as [One | One].
  - pose proof (Rmult_le_pos (1 - u) (level' - along d' w) ltac:(lra) ltac:(lra)).
    pose proof (Rmult_lt_0_compat u (level' - along d' middle) U ltac:(lra)). lra.
  - pose proof (Rmult_lt_0_compat (u - 1) (level - along d w) ltac:(lra) ltac:(lra)). lra.
Qed.
(** The face itself has the middle alone. *)
Lemma own_met_once s x : s ⊆ esquinas c -> x ∈ puntos_de_rayo to_middle -> x ∈ envolvente r s -> x = middle.
Proof.
  intros Sub X Hx. pose proof (on_own d level n c s x d_bears c_there Sub Hx) as At.
  destruct (along_ray x X) as (u & U & A & One). rewrite A, middle_at in At. apply One.
  destruct (Rtotal_order u 1) as [H | [H | H]]; [| exact H |]; exfalso.
  - pose proof (Rmult_lt_0_compat (1 - u) (level - along d w) ltac:(lra) ltac:(lra)). lra.
  - pose proof (Rmult_lt_0_compat (u - 1) (level - along d w) ltac:(lra) ltac:(lra)). lra.
Qed.

(** No edge has a point of the ray: each edge of the face is one of another face too, which has not the middle. *)
Lemma edges_missed m e i j : face r m e -> (i, j) ∈ aristas e -> ~ meets r to_middle (⦃i⦄ ∪ ⦃j⦄).
Proof.
  intros E A Met.
  assert (Other : exists o f, o <> n /\ face r o f /\ (⦃i⦄ ∪ ⦃j⦄) ⊆ esquinas f).
  { destruct (proj2 bounds i j) as (k & l & Once & K & Each).
    assert (M : m ∈ de_arista r i j) by (left; now exists e).
    assert (O : exists o, o <> n /\ o ∈ de_arista r i j).
    { destruct l as [| a [| b l]]; cbn in K; [apply Each in M; destruct M | exfalso; lia |].
      destruct (Nat.eq_dec a n) as [-> | N]; [exists b | exists a; split; [exact N | apply Each; now left]].
      split; [intros ->; inversion Once as [| ? ? Not]; apply Not; now left | apply Each; right; now left]. }
    destruct O as (o & N & [(f & F & W) | (f & F & W)]); exists o, f; apply corners_of_an_edge in W as [I J];
      (split; [exact N | split; [exact F |]]); intros v [-> | ->]; assumption. }
  destruct Other as (o & f & N & F & Sub). exact (others_missed o f _ N F Sub Met).
Qed.

Lemma ray_to_middle : Rayo_ok to_middle.
Proof.
  constructor. intros (X & Y & Z). cbn [Rayo_v to_middle Vector_x Vector_y Vector_z] in X, Y, Z.
  pose proof middle_at as A. unfold along in A, w_before.
  replace (Punto_x middle) with (Punto_x w) in A by lra. replace (Punto_y middle) with (Punto_y w) in A by lra.
  replace (Punto_z middle) with (Punto_z w) in A by lra. lra.
Qed.

Lemma enclosed_by_a_convex_mesh : w ∈ encerrados r.
Proof.
  split; [exact bounds | split; [exact not_on_the_skin |]]. exists to_middle, 0%nat.
  split; [exact ray_to_middle | split; [reflexivity | split; [intros m e i j; apply edges_missed |]]].
  exists [n]. split; [constructor; [intros [] | constructor] | split; [reflexivity |]]. intros m. split.
  - intros [<- | []]. exists c. split; [exact c_there |]. exists middle. split; [| exact middle_on].
    exists 1. split; [unfold Rmas; cbn; lra |]. cbn. repeat split; ring.
  - intros (e & E & Met). destruct (Nat.eq_dec m n) as [-> | N]; [now left | exfalso].
    exact (others_missed m e _ N E (fun i I => I) Met).
Qed.

End Convex.

(** A convex mesh encloses what lies within. Discharges encerrados.def.1. *)
Theorem a_convex_mesh_encloses_what_lies_within r w : pares r -> repetidas r ≡ ∅ -> (exists n, n ∈ faces r) ->
  (forall n, n ∈ faces r -> exists d level, bears r n d level /\ along d w < level) -> w ∈ encerrados r.
Proof.
  intros P Once (n & c & C) Within. destruct (proj2 (proj1 P) c (ex_intro _ n C)) as (t & T & _).
  destruct (Within n (ex_intro _ c C)) as (d & level & B & L).
  exact (enclosed_by_a_convex_mesh r w P Once Within n c t d level C T B L).
Qed.
