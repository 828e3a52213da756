(** * Certified: what the tracer decides is what the text says

    Flotante.v, Cylinder.v and Decision.v speak of a quadratic; here its roots are points of the ray on an element of the
    text: on a sphere, and on the unbounded surface of a cylinder. *)
From Coq Require Import Reals Lra.
From Durero Require Import Toolkit Especificacion Puntos Trazador Interseccion Vectors Across Quotient Decision Flotante.
From Durero Require Formas Tipos Cylinder.
Local Open Scope R_scope.
Local Open Scope zed_scope.

Section Sphere.
Variables (p v centro : vec) (r : R).
Hypothesis p_ordinary : ordinary_vec p.
Hypothesis v_ordinary : ordinary_vec v.
Hypothesis centro_ordinary : ordinary_vec centro.
Hypothesis r_ordinary : ordinary r.
Hypothesis r_positive : 0 < r.
Hypothesis v_not_zero : 0 < norm v.
Let point (a : vec) := mk_Punto (cx a) (cy a) (cz a).
Let direction (a : vec) := mk_Vector (cx a) (cy a) (cz a).
Let ray := mk_Rayo (point p) (direction v).
Let f := of_esfera ray (point centro) r.
Let recorded := Formas.esfera p v (extent_fl v) centro r.
Let q := minus p centro.
Let root := is_root (dot v v) (dot q v) (dot q q - r * r).

Let is_sound : sound recorded (dot v v) (dot q v) (dot q q - r * r) (r * norm v - norm (cross q v))
  (r * norm v + norm (cross q v)) := sphere_sound p v centro r p_ordinary v_ordinary centro_ordinary r_ordinary r_positive v_not_zero.

Lemma root_value t : root t <-> value f t = 0.
Proof.
  unfold root, is_root, value, f, of_esfera, q, Tipos.sq, Tipos.dot, from, dot, minus; cbn.
  split; intros H; rewrite <- H; ring.
Qed.

Lemma root_on_sphere t : root t <-> point_at ray t ∈ puntos_esfera (point centro) r.
Proof. rewrite root_value, esfera_along; reflexivity. Qed.

Lemma certified_miss t : Formas.F recorded < - Formas.B_error recorded -> point_at ray t ∉ puntos_esfera (point centro) r.
Proof. intros H V; apply root_on_sphere in V; exact (no_root _ _ _ _ _ _ is_sound t H V). Qed.

Lemma certified_discriminant : Formas.B_error recorded < Formas.F recorded ->
  let S := Formas.root_of_discriminant recorded in
  0 < discriminant f /\ Rabs (Formas.value S - sqrt (discriminant f)) <= Formas.error S.
Proof.
  cbv zeta; intros H; destruct (meets _ _ _ _ _ _ is_sound H) as (HD & _ & HS & H0 & _).
  assert (E : discriminant f = dot q v * dot q v - dot v v * (dot q q - r * r)).
  { unfold discriminant, f, of_esfera, q, Tipos.sq, Tipos.dot, from, dot, minus; cbn; ring. }
  unfold root_of_D in HS, H0; rewrite E; split; [exact HD | apply Rle_trans with (1 := HS); lra].
Qed.

Lemma certified_roots : has_roots recorded = true ->
  exists t0 t1, t0 < t1 /\ (forall t, value f t = 0 <-> t = t0 \/ t = t1)
  /\ Rabs (Formas.value (nearer recorded) - t0) <= Formas.error (nearer recorded)
  /\ Rabs (Formas.value (farther recorded) - t1) <= Formas.error (farther recorded).
Proof.
  intros H; destruct (two_roots _ _ _ _ _ _ is_sound H) as (t0 & t1 & Hlt & Hall & Hnear).
  exists t0, t1; split; [exact Hlt|]; split; [intros t; rewrite <- root_value; apply Hall|].
  split; apply near_within; [apply (Hnear (nearer recorded) t0) | apply (Hnear (farther recorded) t1)]; tauto.
Qed.

Lemma decision_in_lanes :
  let met t := 0 < t /\ point_at ray t ∈ puntos_esfera (point centro) r in
  let d := Formas.first_in_lanes recorded in
  (Formas.hit d = true ->
   exists t, is_least met t /\ Rabs (Formas.value (Formas.root d) - t) <= Formas.error (Formas.root d))
  /\ (Formas.hit d = false -> Formas.undecided d = false -> forall t, ~ met t).
Proof.
  cbv zeta; unfold recorded.
  destruct (sphere_in_lanes p v centro r p_ordinary v_ordinary centro_ordinary r_ordinary r_positive v_not_zero) as [Hh Hm].
  split.
  - intros H; destruct (Hh H) as (t & (Hr & H0 & Hl) & Hb); exists t; split; [|exact (near_within _ _ Hb)].
    split; [split; [exact H0 | apply root_on_sphere, Hr]|].
    intros t' [H0' H']; apply Hl; [apply root_on_sphere, H' | exact H0'].
  - intros H U t [H0 H']; apply (Hm H U t); [apply root_on_sphere, H' | exact H0].
Qed.
End Sphere.

Section Cylinder.
Variables (p v centro d : vec) (r h : R).
Hypothesis p_ordinary : ordinary_vec p.
Hypothesis v_ordinary : ordinary_vec v.
Hypothesis centro_ordinary : ordinary_vec centro.
Hypothesis d_ordinary : ordinary_vec d.
Hypothesis r_ordinary : ordinary r.
Hypothesis r_positive : 0 < r.
Hypothesis v_not_zero : 0 < norm v.
Let point (a : vec) := mk_Punto (cx a) (cy a) (cz a).
Let direction (a : vec) := mk_Vector (cx a) (cy a) (cz a).
Hypothesis d_unit : direction d ∈ Unitario.
Let ray := mk_Rayo (point p) (direction v).
Let f := of_cilindro ray (point centro) r (direction d) h.
Let recorded := Formas.cilindro p v (extent_fl v) centro r d h.
Let q := minus p centro.
Let a := across v d.
Let b := across q d.
Let root := is_root (dot a a) (dot b a) (dot b b - r * r).

Lemma axis_unit : Rabs (dot d d - 1) <= / 1000000.
Proof. destruct d_unit as [L H]; unfold tolerancia_unidad in *; cbn in L, H; unfold dot; apply Rabs_le; lra. Qed.

Let is_sound : sound recorded (dot a a) (dot b a) (dot b b - r * r) (r * norm a - norm (cross b a))
  (r * norm a + norm (cross b a)) := Cylinder.cylinder_sound p v centro d r h
  (Fit_ray p v (Ordinary_ray p v p_ordinary v_ordinary) v_not_zero)
  (Fit_axis centro d centro_ordinary d_ordinary axis_unit) r_ordinary r_positive.

Lemma cylinder_root_value t : root t <-> value f t = 0.
Proof.
  unfold root, is_root.
  replace (dot a a * t * t + 2 * dot b a * t + (dot b b - r * r)) with (value f t); [reflexivity|].
  unfold a, b, q; rewrite !across_dot.
  change (value f t) with (let n := dot d d in let s0 := dot q d in let s1 := dot v d in
    (dot v v - (2 - n) * (s1 * s1)) * (t * t) + 2 * (dot q v - (2 - n) * (s0 * s1)) * t
      + (dot q q - (2 - n) * (s0 * s0) - r * r)); unfold q; cbv zeta; ring.
Qed.

Lemma cylinder_miss t : Formas.F recorded < - Formas.B_error recorded ->
  potencia_cilindro (point_at ray t) (point centro) r (direction d) <> 0.
Proof.
  intros H V; rewrite (potencia_cilindro_along ray (point centro) r (direction d) h) in V; apply cylinder_root_value in V.
  exact (no_root _ _ _ _ _ _ is_sound t H V).
Qed.

Lemma cylinder_roots : has_roots recorded = true ->
  exists t0 t1, t0 < t1 /\ (forall t, value f t = 0 <-> t = t0 \/ t = t1)
  /\ Rabs (Formas.value (nearer recorded) - t0) <= Formas.error (nearer recorded)
  /\ Rabs (Formas.value (farther recorded) - t1) <= Formas.error (farther recorded).
Proof.
  intros H; destruct (two_roots _ _ _ _ _ _ is_sound H) as (t0 & t1 & Hlt & Hall & Hnear).
  exists t0, t1; split; [exact Hlt|]; split; [intros t; rewrite <- cylinder_root_value; apply Hall|].
  split; apply near_within; [apply (Hnear (nearer recorded) t0) | apply (Hnear (farther recorded) t1)]; tauto.
Qed.
End Cylinder.
