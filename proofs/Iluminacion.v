(** Mirrors and refraction: what spec/iluminacion.tex claims of its two directions.

    dot v w, sq v         == the scalar product, and that of a vector with itself (Tipos.v); `producto` is the text's *)
From Coq Require Import Reals Lra.
From Durero Require Import Toolkit Especificacion Tipos Puntos.
Local Open Scope R_scope.
Local Open Scope zed_scope.

(** The scalar product of the text is the usual one. Discharges producto.def.1. *)
Lemma producto_is_dot u v : producto u v = dot u v.
Proof. reflexivity. Qed.

Ltac components := repeat match goal with v : Vector |- _ => destruct v as [? ? ?] end;
  unfold producto, cuadrado in *; cbn [Vector_x Vector_y Vector_z] in *.

(** ** Mirrors *)

(** Discharges reflexion.def.1, reflexion.conj.1. *)
Theorem a_mirror_keeps_length_and_angle : reflexion_conj_1.
Proof.
  intros v n r H. pose proof H as [Hn [Hx [Hy Hz]]].
  assert (A : producto n n * producto r n = producto n n * producto v n).
  { replace (producto n n * producto r n) with
      ((producto n n * (Vector_x r + Vector_x v)) * Vector_x n + (producto n n * (Vector_y r + Vector_y v)) * Vector_y n
       + (producto n n * (Vector_z r + Vector_z v)) * Vector_z n - producto n n * producto v n)
      by (components; ring).
    rewrite Hx, Hy, Hz. components. ring. }
  apply Rmult_eq_reg_l in A; [|lra].
  assert (B : producto n n * producto r r = producto n n * producto v v).
  { replace (producto n n * producto r r) with
      ((producto n n * (Vector_x r + Vector_x v)) * (Vector_x r - Vector_x v)
       + (producto n n * (Vector_y r + Vector_y v)) * (Vector_y r - Vector_y v)
       + (producto n n * (Vector_z r + Vector_z v)) * (Vector_z r - Vector_z v) + producto n n * producto v v)
      by (components; ring).
    rewrite Hx, Hy, Hz.
    replace (2 * producto v n * Vector_x n * (Vector_x r - Vector_x v)
             + 2 * producto v n * Vector_y n * (Vector_y r - Vector_y v)
             + 2 * producto v n * Vector_z n * (Vector_z r - Vector_z v))
      with (2 * producto v n * (producto r n - producto v n)) by (components; ring).
    rewrite A. ring. }
  apply Rmult_eq_reg_l in B; [|lra].
  split; [exact B | split; [exact A |]]. unfold reflexion. rewrite A. repeat split; lra.
Qed.

(** ** Refraction *)

(** The direction is a combination of the normal and of that to where the light is seen from; the root is the cosine on
    the far side. *)
Lemma refraccion_cosines i n k t : refraccion i n k t ->
  let c := producto i n in let s := sqrt (coseno_cuadrado i n k) in
  producto i i = 1 /\ producto n n = 1 /\ 0 <= c /\ 0 <= s /\ s * s = 1 - k * k * (1 - c * c)
  /\ producto t n = - s /\ producto t t = 1 /\ producto t i = (k * c - s) * c - k.
Proof.
  intros [[Hi [Hn Hc]] [Hs [Hx [Hy Hz]]]] c s. fold c in Hx, Hy, Hz, Hc.
  change (raizcuadrada (coseno_cuadrado i n k)) with s in *.
  assert (Es : s * s = 1 - k * k * (1 - c * c)).
  { unfold s. rewrite sqrt_sqrt by lra. reflexivity. }
  assert (Hs0 : 0 <= s) by apply sqrt_pos.
  assert (Tn : producto t n = (k * c - s) * producto n n - k * c).
  { unfold producto at 1. rewrite Hx, Hy, Hz. unfold c. components. ring. }
  assert (Ti : producto t i = (k * c - s) * c - k * producto i i).
  { unfold producto at 1. rewrite Hx, Hy, Hz. unfold c. components. ring. }
  assert (Tt : producto t t = (k * c - s) * producto t n - k * producto t i).
  { unfold producto at 1. rewrite Hx at 1. rewrite Hy at 1. rewrite Hz at 1. components. ring. }
  rewrite Hn in Tn. rewrite Hi in Ti.
  repeat split; try lra. rewrite Tt, Tn, Ti.
  replace ((k * c - s) * ((k * c - s) * 1 - k * c) - k * ((k * c - s) * c - k * 1))
    with (s * s + k * k * (1 - c * c)) by ring.
  lra.
Qed.

(** Discharges refraccion.conj.1. *)
Theorem the_refracted_direction_is_a_unit_vector_beyond : refraccion_conj_1.
Proof.
  intros i n k t Hk H. apply refraccion_cosines in H as [_ [_ [_ [Hs [_ [Hn [Ht _]]]]]]]. split; [exact Ht | lra].
Qed.

(** Discharges refraccion.def.1, coseno_cuadrado.def.1, refraccion.conj.2. *)
Theorem the_refracted_direction_obeys_Snell : refraccion_conj_2.
Proof.
  intros i n k t Hk H. pose proof H as [_ [_ [Hx [Hy Hz]]]].
  apply refraccion_cosines in H as [_ [_ [_ [_ [Es [Hn _]]]]]]. split.
  - unfold cuadrado. rewrite Hn. lra.
  - exists (k * producto i n - sqrt (coseno_cuadrado i n k)), (- k). repeat split; rewrite ?Hx, ?Hy, ?Hz;
      unfold raizcuadrada; ring.
Qed.

(** Discharges incidencia.def.1, reflexion_total.def.1, reflexion_total.conj.1. *)
Theorem refraction_exists_but_in_total_reflection : reflexion_total_conj_1.
Proof.
  intros i n k Hk Hin. split; [split |].
  - intros [t [_ [Hs _]]] [_ Hneg]. lra.
  - intros Hno. assert (Hs : coseno_cuadrado i n k >= 0).
    { apply Rnot_lt_ge. intros Hneg. apply Hno. now split. }
    set (a := k * producto i n - raizcuadrada (coseno_cuadrado i n k)).
    exists (mk_Vector (a * Vector_x n - k * Vector_x i) (a * Vector_y n - k * Vector_y i) (a * Vector_z n - k * Vector_z i)).
    split; [exact Hin | split; [exact Hs | repeat split; reflexivity]].
  - intros [_ Hneg]. destruct Hin as [Hi [Hn Hc]]. unfold coseno_cuadrado, cuadrado in Hneg.
    apply Rnot_le_lt. intros Hle.
    assert (k * k <= 1) by (apply Rle_trans with (1 * 1); [apply Rmult_le_compat |]; unfold Rmas in *; lra).
    assert (0 <= producto i n * producto i n) by apply Rle_0_sqr.
    assert (0 <= k * k) by apply Rle_0_sqr.
    assert (0 <= k * k * (producto i n * producto i n)) by now apply Rmult_le_pos.
    lra.
Qed.

(** Discharges refraccion.conj.3. *)
Theorem equal_indices_leave_the_direction : refraccion_conj_3.
Proof.
  intros i n t H. pose proof H as [_ [_ [Hx [Hy Hz]]]].
  apply refraccion_cosines in H as [_ [_ [Hc [Hs [Es _]]]]].
  change (raizcuadrada (coseno_cuadrado i n 1)) with (sqrt (coseno_cuadrado i n 1)) in *.
  assert (E : sqrt (coseno_cuadrado i n 1) = producto i n) by (apply Rsqr_inj; unfold Rsqr; lra).
  rewrite E in Hx, Hy, Hz. repeat split; lra.
Qed.

(** Discharges refraccion.conj.4. *)
Theorem light_goes_back_the_way_it_came : refraccion_conj_4.
Proof.
  intros i n m t k k' Hk Hk' H Hkk Mx My Mz. pose proof H as [_ [_ [Hx [Hy Hz]]]].
  apply refraccion_cosines in H as [Hi [Hn [Hc [Hs [Es [Tn [Tt Ti]]]]]]].
  change (raizcuadrada (coseno_cuadrado i n k)) with (sqrt (coseno_cuadrado i n k)) in *.
  set (s := sqrt (coseno_cuadrado i n k)) in *. set (c := producto i n) in *.
  assert (Ex : Vector_x m = - Vector_x n) by lra. assert (Ey : Vector_y m = - Vector_y n) by lra.
  assert (Ez : Vector_z m = - Vector_z n) by lra.
  assert (Tm : producto t m = s).
  { transitivity (- producto t n); [unfold producto; rewrite Ex, Ey, Ez; ring | lra]. }
  assert (Mm : producto m m = 1).
  { transitivity (producto n n); [unfold producto; rewrite Ex, Ey, Ez; ring | exact Hn]. }
  assert (Ec : coseno_cuadrado t m k' = c * c).
  { unfold coseno_cuadrado, cuadrado. rewrite Tm, Es.
    replace (1 - k' * k' * (1 - (1 - k * k * (1 - c * c)))) with (1 - (k * k') * (k * k') * (1 - c * c)) by ring.
    rewrite Hkk. ring. }
  assert (Er : raizcuadrada (coseno_cuadrado t m k') = c).
  { rewrite Ec. unfold raizcuadrada. now apply sqrt_square. }
  split; [split; [exact Tt | split; [exact Mm | lra]] |].
  split; [rewrite Ec; apply Rle_ge, Rle_0_sqr |].
  rewrite Er, Tm, Ex, Ey, Ez, Hx, Hy, Hz.
  assert (Back : forall a b, b = (k' * s - c) * - a - k' * ((k * c - s) * a - k * b)).
  { intros a b. replace ((k' * s - c) * - a - k' * ((k * c - s) * a - k * b))
      with (c * a * (1 - k * k') + (k * k') * b) by ring. rewrite Hkk. ring. }
  repeat split; apply Back.
Qed.
