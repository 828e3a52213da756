(** spec/tipos.tex: the reals of the text are Coq's, and its constants exist.

    Rmas                 == the positive reals
    Unitario             == the vectors d with |d·d − 1| ≤ tolerancia_unidad
    dot v w, sq v        == v·w and v·v *)
From Coq Require Import Reals Lra Lia.
From Durero Require Import Toolkit Especificacion.
Local Open Scope R_scope.

Definition dot (v w : Vector) : R :=
  Vector_x v * Vector_x w + Vector_y v * Vector_y w + Vector_z v * Vector_z w.
Definition sq (v : Vector) : R := dot v v.

(** The integers are reals. Discharges real.axiom.1. *)
Theorem reals_contain_integers : real_axiom_1.
Proof. easy. Qed.

(** A sum, a difference and a product of reals exist, are one and are real. Discharges real.axiom.2. *)
Theorem reals_closed : real_axiom_2.
Proof.
  assert (total : forall f : R -> R -> R, (dres univ (graph f) ∈ univ ⟶ univ)%zed).
  { intros f. split; [| split; [| easy]].
    - intros x y y' [_ H] [_ H']. unfold graph in *. cbn in *. congruence.
    - intros [a b]. split; [easy |]. intros _. now exists (f a b). }
  exact (conj (total Rplus) (conj (total Rminus) (total Rmult))).
Qed.

(** A real other than 0 has exactly one inverse. Discharges real.axiom.3. *)
Theorem reals_inverse : real_axiom_3.
Proof.
  intros a Ha. exists (/ a). split; [now apply Rinv_r | intros b Hb].
  apply Rmult_eq_reg_l with a; [rewrite Rinv_r; auto | assumption].
Qed.

(** A non-empty set of reals that is bounded above has exactly one least upper bound. Discharges real.axiom.4. *)
Theorem reals_complete : real_axiom_4.
Proof.
  intros S Hne [c Hc]. destruct (completeness S) as [m [Hm Hleast]]; [now exists c | assumption |].
  exists m. split; [split; [exact Hm | exact Hleast] |].
  intros m' [Hm' Hleast']. apply Rle_antisym; [now apply Hleast | now apply Hleast'].
Qed.

(** The laws of an ordered field. Discharges real.axiom.5, real.axiom.6, real.axiom.7, real.axiom.8. *)
Theorem reals_ordered_field : real_axiom_5 /\ real_axiom_6 /\ real_axiom_7 /\ real_axiom_8.
Proof.
  repeat split; intros; try ring; try lra. now apply Rmult_le_pos.
Qed.

(** Coq's own <, > and >= on the reals are what the text says of them by <=. Discharges real.axiom.9. *)
Theorem reals_strict_order : real_axiom_9.
Proof. intros a b. repeat split; intros; lra. Qed.

(** All that the text assumes of the reals. *)
Theorem reals_of_the_text :
  real_axiom_1 /\ real_axiom_2 /\ real_axiom_3 /\ real_axiom_4 /\ real_axiom_5 /\ real_axiom_6 /\ real_axiom_7
  /\ real_axiom_8 /\ real_axiom_9.
Proof.
  destruct reals_ordered_field as [H5 [H6 [H7 H8]]].
  exact (conj reals_contain_integers (conj reals_closed (conj reals_inverse (conj reals_complete
    (conj H5 (conj H6 (conj H7 (conj H8 reals_strict_order)))))))).
Qed.

(** The text's axioms leave no choice: any <, > and ≥ that satisfy real.axiom.9 are Coq's. *)
Theorem strict_order_is_determined (lt gt ge : R -> R -> Prop) :
  (forall a b, (lt a b <-> a <= b /\ a <> b) /\ (gt a b <-> lt b a) /\ (ge a b <-> b <= a)) ->
  forall a b, (lt a b <-> a < b) /\ (gt a b <-> a > b) /\ (ge a b <-> a >= b).
Proof.
  intros H a b. destruct (H a b) as [L [G E]]. destruct (H b a) as [L' _]. rewrite G, L, L', E.
  repeat split; intros; lra.
Qed.

(** The tolerance of the text is the one real that its axiom describes, and it is positive.
    Discharges Rmas.inv.1, tolerancia_unidad.def.1. *)
Theorem tolerancia_unidad_exists_uniquely :
  tolerancia_unidad_decl tolerancia_unidad /\ tolerancia_unidad_def_1 tolerancia_unidad
  /\ forall t, tolerancia_unidad_def_1 t -> t = tolerancia_unidad.
Proof. unfold tolerancia_unidad_decl, Rmas, tolerancia_unidad_def_1, tolerancia_unidad. repeat split; intros; lra. Qed.

Lemma sq_nonneg v : 0 <= sq v.
Proof. unfold sq, dot. generalize (Rle_0_sqr (Vector_x v)) (Rle_0_sqr (Vector_y v)) (Rle_0_sqr (Vector_z v)).
  unfold Rsqr. lra. Qed.

Lemma sq_zero v : sq v = 0 -> Vector_x v = 0 /\ Vector_y v = 0 /\ Vector_z v = 0.
Proof.
  generalize (Rle_0_sqr (Vector_x v)) (Rle_0_sqr (Vector_y v)) (Rle_0_sqr (Vector_z v)).
  unfold sq, dot, Rsqr. intros. repeat split; apply Rsqr_0_uniq; unfold Rsqr; lra.
Qed.

(** The direction of a ray has a positive square. Discharges Rayo.inv.1. *)
Theorem ray_direction_positive ray : Rayo_ok ray -> 0 < sq (Rayo_v ray).
Proof.
  intros [H]. destruct (sq_nonneg (Rayo_v ray)) as [Hlt | Heq]; [exact Hlt |].
  now destruct H; apply sq_zero.
Qed.

(** A stored axis has a square between 1/2 and 2, so it is not null. Discharges Unitario.inv.1. *)
Theorem axis_square_bounds d : Unitario d -> 1 / 2 < sq d < 2.
Proof. unfold Unitario, tolerancia_unidad, sq, dot. lra. Qed.
