(** * Modest: what is computed of numbers in range is far below 2^1024

    The powers of two above the coefficients of each surface with two roots, read off its terms (Sizes.v).

    all_below e a        == |x| is 2^e at most for each component of a
    powers               == the tactic that has the powers above a ray and an element in range *)
From Coq Require Import Reals ZArith Lra Lia.
From Flocq Require Import Core.
From Durero Require Import Rounding Vectors Flotante Twofold Sizes Settled StableSettled.
From Durero Require Formas.
Import Formas.Pairs.
Local Open Scope R_scope.
Local Opaque bpow.

(** ** The powers of the ray and of an element *)

Definition all_below (e : Z) (a : vec) : Prop := below e (cx a) /\ below e (cy a) /\ below e (cz a).

Lemma ordinary_below a : ordinary_vec a -> all_below 100 a.
Proof. intros (X & Y & Z0); split; [|split]; now apply below_ordinary. Qed.

Lemma axis_below centro d : fit_axis centro d -> all_below 1 d.
Proof.
  intros [_ _ U]; apply Rabs_le_inv in U; unfold dot in U; pose proof (square_nonneg (cx d)); pose proof (square_nonneg (cy d)).
  pose proof (square_nonneg (cz d)).
  assert (One : forall x, x * x <= 2 -> below 1 x).
  { intros x Hx; split; [lia|]; replace (bpow radix2 1) with 2 by reflexivity; apply square_le; [lra|].
    rewrite <- Rabs_mult, Rabs_pos_eq by apply square_nonneg; lra. }
  split; [|split]; apply One; lra.
Qed.

Ltac powers :=
  repeat match goal with
  | H : fit_axis _ _ |- _ => pose proof (centro_ordinary H); destruct (axis_below _ _ H) as (? & ? & ?); clear H
  | H : fit_ray _ _ |- _ => pose proof (p_ordinary H); pose proof (v_ordinary H); clear H
  | H : ordinary_vec _ |- _ => destruct (ordinary_below _ H) as (? & ? & ?); clear H
  | H : ordinary _ |- _ => pose proof (below_ordinary _ H); clear H
  end.

Section Range.
Variables p v : vec.
Hypothesis ray_fits : fit_ray p v.
Notation V := (extent_fl v).

Lemma V_below : below 104 V.
Proof.
  destruct (ordinary_below _ (v_ordinary ray_fits)) as (X & Y & Z0); unfold extent_fl; eapply below_more; [size | vm_compute; discriminate].
Qed.

Lemma V_least : bpow radix2 (-101) <= V.
Proof.
  pose proof (V_range v (v_ordinary ray_fits) (v_not_zero ray_fits)) as [L _]; unfold extent_fl.
  destruct (ordinary_below _ (v_ordinary ray_fits)) as (X & Y & Z0).
  assert (Low : forall x y, format x -> format y -> 0 <= x -> 0 <= y -> x + y - u * (x + y) <= rnd (x + y)).
  { intros x y Fx Fy Hx Hy; pose proof (rnd_plus x y Fx Fy) as H; rewrite (Rabs_pos_eq (x + y)) in H by lra; apply Rabs_le_inv in H; lra. }
  destruct (v_ordinary ray_fits) as ((Fx & _) & (Fy & _) & (Fz & _)); unfold extent in L.
  pose proof (Rabs_pos (cx v)); pose proof (Rabs_pos (cy v)); pose proof (Rabs_pos (cz v)); pose proof u_bounds.
  pose proof (Low _ _ (generic_format_abs _ _ _ Fx) (generic_format_abs _ _ _ Fy) ltac:(lra) ltac:(lra)) as L1.
  pose proof (rnd_nonneg (Rabs (cx v) + Rabs (cy v)) ltac:(lra)).
  pose proof (Low _ _ (format_rnd (Rabs (cx v) + Rabs (cy v))) (generic_format_abs _ _ _ Fz) ltac:(lra) ltac:(lra)) as L2.
  assert (0 <= Rabs (cx v) + Rabs (cy v)) by lra; set (s := Rabs (cx v) + Rabs (cy v)) in *; set (r := rnd s) in *.
  assert (u * s <= / 100 * s) by (apply Rmult_le_compat_r; lra).
  assert (u * (r + Rabs (cz v)) <= / 100 * (r + Rabs (cz v))) by (apply Rmult_le_compat_r; lra).
  change (-101)%Z with (-1 + -100)%Z; rewrite bpow_plus; replace (bpow radix2 (-1)) with (/ 2) by reflexivity; lra.
Qed.

Ltac modest_of surface :=
  pose proof V_below; powers; constructor; cbv beta iota zeta delta [surface Formas.B Formas.C Formas.B_error Formas.C_error];
  (eapply below_more; [size | vm_compute; discriminate]).
Ltac modest2_of surface :=
  pose proof V_below; powers; constructor; cbv beta iota zeta delta [surface Formas.B Formas.C Formas.B_error Formas.C_error];
  [eapply below2_more; [size2 | vm_compute; discriminate] | eapply below_more; [size | vm_compute; discriminate]
  | eapply below2_more; [size2 | vm_compute; discriminate] | eapply below_more; [size | vm_compute; discriminate]].

(** ** What curves *)

Lemma sphere_modest centro r : ordinary_vec centro -> ordinary r ->
  modest (Formas.esfera p v V centro r) /\ modest2 (esfera p v V centro r).
Proof. intros Hc Hr; split; [modest_of Formas.esfera | modest2_of esfera]. Qed.

Lemma cylinder_modest centro d r h : fit_axis centro d -> ordinary r -> ordinary h ->
  modest (Formas.cilindro p v V centro r d h) /\ modest2 (cilindro p v V centro r d h).
Proof. intros Ha Hr Hh; split; [modest_of Formas.cilindro | modest2_of cilindro]. Qed.

Lemma cone_modest centro d k h : fit_axis centro d -> ordinary k -> ordinary h ->
  modest (Formas.cono p v V centro k d h) /\ modest2 (cono p v V centro k d h).
Proof. intros Ha Hk Hh; split; [modest_of Formas.cono | modest2_of cono]. Qed.

Lemma truncated_modest centro d r k h : fit_axis centro d -> ordinary r -> ordinary k -> ordinary h ->
  modest (Formas.tronco p v V centro r k d h) /\ modest2 (tronco p v V centro r k d h).
Proof. intros Ha Hr Hk Hh; split; [modest_of Formas.tronco | modest2_of tronco]. Qed.
End Range.
