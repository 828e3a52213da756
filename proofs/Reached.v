(** * Reached: on every element in range the steps settle, and what they find is far below 2^1024

    Settled.v and StableSettled.v hold of the steps of the search: of what curves by Modest.v, of what is flat as here, where
    what is divided by errs by a power of two or more. *)
From Coq Require Import Reals ZArith Lra Lia.
From Flocq Require Import Core.
From Durero Require Import Rounding Vectors Flotante Steps Triage Second Twofold Sums Words Sizes Settled StableSettled Modest.
From Durero Require Formas Linear Plane Triangle Cylinder Cone StableFlat StableSphere StableCylinder StableCone StablePlane
  StableTriangle.
Import Formas.Pairs.
Local Open Scope R_scope.
Local Opaque bpow.

Section Range.
Variables p v : vec.
Hypothesis ray_fits : fit_ray p v.
Notation V := (extent_fl v).

(** ** What is flat *)

Ltac power_of surface := pose proof (V_below p v ray_fits); powers;
  cbv beta iota zeta delta [surface Formas.B Formas.C Formas.B_error Formas.C_error];
  first [eapply below2_more; [size2 | vm_compute; discriminate] | eapply below_more; [size | vm_compute; discriminate]].

Lemma plane_error k m : (-900 <= k)%Z -> (m <= k - 101)%Z -> bpow radix2 m <= rnd (3 * bpow radix2 k * V).
Proof.
  intros Hk Hm; apply Rle_trans with (bpow radix2 (k - 101)); [now apply bpow_le|]; apply rnd_ge_bpow; [lia|].
  change (k - 101)%Z with (k + -101)%Z; rewrite bpow_plus; pose proof (V_least p v ray_fits); pose proof (bpow_gt_0 radix2 k).
  pose proof (bpow_gt_0 radix2 (-101)); apply Rmult_le_compat; lra.
Qed.

Lemma plane_settles centro d : fit_axis centro d ->
  settles (Formas.first_of_linear (Formas.plano p v V centro d)) /\ settles2 (first_of_linear (plano p v V centro d)).
Proof.
  intros Ha; split.
  - assert (Along : Plane.along p v centro d (Formas.plano p v V centro d)) by (repeat split).
    apply (linear_settles _ _ _ (Plane.plane_sound p v centro d ray_fits Ha _ Along)).
    + power_of Formas.plano.
    + power_of Formas.plano.
    + intros _; now apply (plane_error (-53)).
  - pose proof (StablePlane.plane_along2 p v centro d) as Along.
    apply (linear_settles2 _ _ _ (StablePlane.plane_sound2 p v centro d ray_fits Ha _ Along)).
    + power_of plano.
    + power_of plano.
    + power_of plano.
    + intros _; now apply (plane_error (-102)).
Qed.

Lemma disc_settles centro r d : fit_axis centro d ->
  settles (Formas.first_of_linear_edged (Formas.disco p v V centro r d)) /\ settles2 (first_of_linear_edged (disco p v V centro r d)).
Proof.
  intros Ha; split.
  - apply (linear_settles _ _ _ (Plane.plane_sound p v centro d ray_fits Ha _ (proj1 (Plane.disc_recorded p v centro d r)))).
    + power_of Formas.disco.
    + power_of Formas.disco.
    + intros _; now apply (plane_error (-53)).
  - assert (Along : StablePlane.along2 p v centro d (disco p v V centro r d)) by (repeat split).
    apply (linear_settles2 _ _ _ (StablePlane.plane_sound2 p v centro d ray_fits Ha _ Along)).
    + power_of disco.
    + power_of disco.
    + power_of disco.
    + intros _; now apply (plane_error (-102)).
Qed.

(** Where a triangle's determinant is known, none of its edges is nothing. *)
Lemma triangle_error2 a b c : ordinary_vec a -> ordinary_vec b -> ordinary_vec c -> Triangle.det v a b c <> 0 ->
  bpow radix2 (-560) <= StableTriangle.B_error2 v a b c.
Proof.
  intros Ha Hb Hc Hd; pose proof (StableTriangle.B_error_low2 p v a b c ray_fits Ha Hb Hc) as Low.
  destruct (StableTriangle.det_worded p v a b c ray_fits Ha Hb Hc) as [(_ & Hs) _].
  pose proof (Rabs_pos_lt _ Hd); pose proof (Triangle.triple_size_le (minus b a) v (minus c a)) as Le.
  set (L1 := extent (minus b a)) in *; set (L2 := extent (minus c a)) in *; set (W := extent v) in *.
  assert (Pos : 0 < W * (L1 * L2)) by (replace (W * (L1 * L2)) with (L1 * (W * L2)) by ring; lra).
  assert (0 < bpow radix2 (-102) * (W * (L1 * L2))) by (apply Rmult_lt_0_compat; [apply bpow_gt_0 | exact Pos]).
  pose proof (computed_mult 3 3 (-251) (-152) _ _ _ _ _ _ ltac:(lia) (computed_mult 0 2 (-99) (-152) _ _ _ _ _ _ ltac:(lia)
    (Triangle.power_computed (-99) ltac:(lia)) (Triangle.V_fl_computed p v ray_fits)) (Triangle.L1_computed a b Ha Hb)) as Hc1.
  pose proof (computed_mult 7 3 (-403) (-152) _ _ _ _ _ _ ltac:(lia) Hc1 (Triangle.L2_computed a c Ha Hc)) as (_ & _ & G).
  apply grid_at_least in G; [|change (StableTriangle.B_error2 v a b c <> 0); lra].
  change (bpow radix2 (-403 + -152) <= Rabs (StableTriangle.B_error2 v a b c)) in G; rewrite Rabs_pos_eq in G by lra.
  apply Rle_trans with (2 := G), bpow_le; lia.
Qed.

Lemma triangle_settles a b c : ordinary_vec a -> ordinary_vec b -> ordinary_vec c ->
  settles (Formas.first_of_linear_edged (Formas.triangulo p v V a b c)) /\ settles2 (first_of_linear_edged (triangulo p v V a b c)).
Proof.
  intros Ha Hb Hc; pose proof (Triangle.triangle_sound p v a b c ray_fits Ha Hb Hc) as S.
  pose proof (StableTriangle.triangle_sound2 p v a b c ray_fits Ha Hb Hc) as S2; split.
  - apply (linear_settles _ _ _ S).
    + power_of Formas.triangulo.
    + power_of Formas.triangulo.
    + intros K; destruct (Linear.known_means _ _ _ S K) as [Hbig _], (Triangle.B_error_low p v a b c ray_fits Ha Hb Hc) as (_ & _ & Low).
      apply Rle_trans with (bpow radix2 (-506)); [apply bpow_le; lia|]; apply Low; intros Z0.
      destruct (Linear.flat_slope _ _ _ S) as (_ & _ & [B0|B0]).
      * rewrite B0, Rabs_R0 in Hbig; pose proof (Linear.flat_B_near _ _ _ S); pose proof (Rabs_pos (Formas.B (Formas.triangulo p v V a b c) -
          - Triangle.det v a b c / 2)); lra.
      * change (bpow radix2 (-900) <= Triangle.B_error v a b c) in B0; pose proof (bpow_gt_0 radix2 (-900)); lra.
  - apply (linear_settles2 _ _ _ S2).
    + power_of triangulo.
    + power_of triangulo.
    + power_of triangulo.
    + intros K; destruct (StableFlat.known_means _ _ _ S2 K) as [_ HB]; apply triangle_error2; auto; intros Z0; apply HB; rewrite Z0; field.
Qed.

(** ** The steps of the search *)

Theorem steps_settle sh on : fit_shape sh -> settles (alone_of p v sh on) /\ settles2 (second_of p v sh on).
Proof.
  destruct sh as [c r | c r d h | c k d h | c r k d h | c d | c r d | a b c]; cbn [fit_shape]; intros Fit.
  - destruct Fit as (Hc & Hr & Pr), (sphere_modest p v ray_fits c r Hc Hr) as [M M2].
    pose proof (sphere_sound p v c r (p_ordinary ray_fits) (v_ordinary ray_fits) Hc Hr Pr (v_not_zero ray_fits)) as S.
    pose proof (StableSphere.stable_sphere_sound p v c r ray_fits Hc Hr Pr) as S2.
    destruct (curved_settles _ _ _ _ _ _ S M), (curved_settles2 _ _ _ _ _ _ S2 M2); destruct on; now split.
  - destruct Fit as (Ha & Hr & Pr & Hh & Ph), (cylinder_modest p v ray_fits c d r h Ha Hr Hh) as [M M2].
    pose proof (Cylinder.cylinder_sound p v c d r h ray_fits Ha Hr Pr) as S.
    pose proof (StableCylinder.stable_cylinder_sound p v c d r h ray_fits Ha Hr Pr) as S2.
    destruct (axial_settles _ _ _ _ _ _ S M), (axial_settles2 _ _ _ _ _ _ S2 M2); destruct on; now split.
  - destruct Fit as (Ha & Hk & Pk & Hh & Ph), (cone_modest p v ray_fits c d k h Ha Hk Hh) as [M M2].
    pose proof (Cone.cone_sound p v c d h k ray_fits Ha Hh Ph Hk Pk) as S.
    pose proof (StableCone.stable_cone_sound p v c d h k ray_fits Ha Hh Ph Hk Pk) as S2.
    destruct (axial_settles _ _ _ _ _ _ S M), (axial_settles2 _ _ _ _ _ _ S2 M2); destruct on; now split.
  - destruct Fit as (Ha & Hr & Pr & Hk & Pk & Hh & Ph), (truncated_modest p v ray_fits c d r k h Ha Hr Hk Hh) as [M M2].
    pose proof (Cone.truncated_sound p v c d h k ray_fits Ha Hh Ph Hk Pk r Hr Pr) as S.
    pose proof (StableCone.stable_truncated_sound p v c d h k r ray_fits Ha Hh Ph Hk Pk Hr Pr) as S2.
    destruct (axial_settles _ _ _ _ _ _ S M), (axial_settles2 _ _ _ _ _ _ S2 M2); destruct on; now split.
  - destruct (plane_settles c d Fit) as [S S2]; destruct on; split; auto; [apply linear_on_settles | apply linear_on_settles2].
  - destruct Fit as (Ha & _), (disc_settles c r d Ha) as [S S2].
    destruct on; split; auto; [apply linear_on_settles | apply linear_on_settles2].
  - destruct Fit as (Ha & Hb & Hc), (triangle_settles a b c Ha Hb Hc) as [S S2].
    destruct on; split; auto; [apply linear_on_settles | apply linear_on_settles2].
Qed.
End Range.
