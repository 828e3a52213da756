(** * Steps: what the tracer decides of a ray and an element in binary64 is what the text says

    Of each shape, the four decisions of trace/closed_form-inl.hpp: in lanes and for one ray up to a limit, of a ray that
    starts elsewhere and of one that starts on the element. Trazador.reach has the parameters of the text's points, of
    the coefficients of Puntos.v, and of those with the constant term 0 where the ray starts on the element.

    Decisions, decisions_right f == the four, and that they are right for the coefficients f *)
From Coq Require Import Reals List Lra.
From Durero Require Import Toolkit Especificacion Puntos Trazador.
From Durero Require Tipos Cylinder Formas Flat Triangle Conical Cone.
From Durero Require Import Vectors Across Quotient Decision Flotante Verdict Advance Linear Plane.
Local Open Scope R_scope.
Local Open Scope zed_scope.

Record decisions := Decisions {
  in_lanes : Formas.in_lanes;
  in_lanes_from : Formas.in_lanes;
  alone : R -> Formas.answer R;
  alone_from : R -> Formas.answer R }.

(** The decisions on a quadratic that nothing bounds, and on one that a stretch of its axis does. *)
Definition unbounded (f : Formas.quadratic R) : decisions :=
  Decisions (Formas.first_in_lanes f) (Formas.first_in_lanes_on f) (Formas.first_of_curved f) (Formas.first_of_curved_on f).
Definition axial (f : Formas.quadratic R) : decisions :=
  Decisions (Formas.first_in_lanes_axial f) (Formas.first_in_lanes_on_axial f) (Formas.first_of_curved_axial f)
    (Formas.first_of_curved_on_axial f).

(** Of what is flat, without an edge and with one. *)
Definition flat (f : Formas.quadratic R) : decisions :=
  Decisions (Formas.linear_in_lanes f) (Formas.linear_in_lanes_on f) (Formas.first_of_linear f)
    (Formas.first_of_linear_on f).
Definition edged (f : Formas.quadratic R) : decisions :=
  Decisions (Formas.linear_in_lanes_edged f) (Formas.linear_in_lanes_on f) (Formas.first_of_linear_edged f)
    (Formas.first_of_linear_on f).

Definition decisions_right (f : coefficients) (d : decisions) : Prop :=
  right_in_lanes (reach f) (in_lanes d) /\ right_in_lanes (reach (launched f)) (in_lanes_from d) /\
  forall limit, right_up_to (cA f) (cB f) (reach f) limit (alone d limit) /\
    right_up_to (cA f) (cB f) (reach (launched f)) limit (alone_from d limit).

(** The quadratic of the text, coefficient by coefficient. *)
Definition same_quadratic (A B C : R) (f : coefficients) : Prop := A = cA f /\ B = cB f /\ C = cC f.

Lemma same_values A B C f t : same_quadratic A B C f ->
  A * t * t + 2 * B * t + C = value f t /\ A * t * t + 2 * B * t + 0 = value (launched f) t.
Proof. intros (-> & -> & ->); unfold value, launched; cbn; split; ring. Qed.

Section Curved.
Variable f : Formas.quadratic R.
Variables A B C F H : R.
Hypothesis f_sound : sound f A B C F H.
Variable text : coefficients.
Hypothesis same : same_quadratic A B C text.

Lemma same_slope : cA text = A /\ cB text = B.
Proof. destruct same as (EA & EB & _); now split. Qed.

Lemma points_are_reached (on : R -> Prop) t : (on t <-> 0 < t /\ within text t) -> (points A B C on t <-> reach text t).
Proof.
  intros E; unfold points, reach, is_root; destruct (same_values A B C text t same) as [-> _]; rewrite E; tauto.
Qed.

Lemma points_from_are_reached (on : R -> Prop) t : (on t <-> 0 < t /\ within text t) ->
  (points_from A B on t <-> reach (launched text) t).
Proof.
  intros E; unfold points_from, reach, is_root; destruct (same_values A B C text t same) as [_ ->]; rewrite E.
  unfold within, launched; cbn; tauto.
Qed.

Lemma unbounded_right : (forall t, within text t) -> decisions_right text (unbounded f).
Proof.
  intros W; pose proof (place_right f) as P; assert (On : forall t, 0 < t <-> 0 < t /\ within text t) by (intros t;
    pose proof (W t); tauto).
  pose proof (fun t => points_are_reached (fun t => 0 < t) t (On t)) as E.
  pose proof (fun t => points_from_are_reached (fun t => 0 < t) t (On t)) as E0.
  destruct same_slope as [EA EB].
  split; [|split; [|intros limit; split; rewrite EA, EB]]; cbn [in_lanes in_lanes_from alone alone_from unbounded].
  - rewrite free_is_recorded; exact (right_in_lanes_equal _ _ _ E (lanes_right f A B C F H f_sound _ _ P)).
  - destruct (from_is_recorded f 0) as (_ & _ & -> & _).
    exact (right_in_lanes_equal _ _ _ E0 (lanes_from_right f A B C F H f_sound _ _ P (fun t Ht => Ht))).
  - rewrite single_is_recorded; apply (right_up_to_equal _ _ _ _ limit _ E).
    apply (single_right f A B C F H f_sound _ _ _ limit P (fun t Ht => Ht)).
    intros HF Hq; exact (past_limit_right f A B C F H f_sound _ limit (fun t Ht => Ht) HF Hq).
  - destruct (from_is_recorded f limit) as (-> & _); apply (right_up_to_equal _ _ _ _ limit _ E0).
    exact (single_from_right f A B C F H f_sound _ _ limit P (fun t Ht => Ht)).
Qed.

Variables p v centro d : vec.
Variable h : R.
Hypothesis ray_fits : fit_ray p v.
Hypothesis axis_fits : fit_axis centro d.
Hypothesis h_ordinary : ordinary h.
Hypothesis h_positive : 0 < h.

Lemma axial_right : ends p v centro d h f ->
  (forall t, within text t <-> 0 <= dot (minus p centro) d + t * dot v d <= h) -> decisions_right text (axial f).
Proof.
  intros Ends W.
  pose proof (axial_places p v centro d h ray_fits axis_fits h_ordinary h_positive f Ends) as P.
  assert (On : forall t, on_stretch p v centro d h t <-> 0 < t /\ within text t) by (intros t; rewrite W; reflexivity).
  assert (Pos : forall t, on_stretch p v centro d h t -> 0 < t) by (intros t [Ht _]; exact Ht).
  pose proof (fun t => points_are_reached (on_stretch p v centro d h) t (On t)) as E.
  pose proof (fun t => points_from_are_reached (on_stretch p v centro d h) t (On t)) as E0.
  destruct same_slope as [EA EB].
  split; [|split; [|intros limit; split; rewrite EA, EB]]; cbn [in_lanes in_lanes_from alone alone_from axial].
  - rewrite axial_is_recorded; exact (right_in_lanes_equal _ _ _ E (lanes_right f A B C F H f_sound _ _ P)).
  - destruct (from_is_recorded f 0) as (_ & _ & _ & ->).
    exact (right_in_lanes_equal _ _ _ E0 (lanes_from_right f A B C F H f_sound _ _ P Pos)).
  - rewrite single_axial_is_recorded; apply (right_up_to_equal _ _ _ _ limit _ E).
    apply (single_right f A B C F H f_sound _ _ _ limit P Pos); intros HF Hq.
    exact (past_stretch_right p v centro d h ray_fits axis_fits h_ordinary h_positive f A B C F H limit f_sound Ends HF Hq).
  - destruct (from_is_recorded f limit) as (_ & -> & _); apply (right_up_to_equal _ _ _ _ limit _ E0).
    exact (single_from_right f A B C F H f_sound _ _ limit P Pos).
Qed.
End Curved.

Section Flat.
Variable f : Formas.quadratic R.
Variables B C : R.
Hypothesis f_sound : sound_flat f B C.
Variable text : coefficients.
Hypothesis same : forall t, 2 * B * t + C = value text t.
Hypothesis same_from : forall t, 2 * B * t + 0 = value (launched text) t.

Lemma flat_is_reached t : flat_points B C (fun t => 0 < t /\ within text t) t <-> reach text t.
Proof. unfold flat_points, reach; rewrite same; tauto. Qed.

Lemma flat_from_is_reached t : flat_points_from B (fun t => 0 < t /\ within text t) t <-> reach (launched text) t.
Proof. unfold flat_points_from, reach; rewrite same_from; unfold within, launched; cbn; tauto. Qed.

Lemma flat_slope_same : cA text = 0 /\ cB text = B.
Proof. pose proof (same 0) as E0; pose proof (same 1) as E1; pose proof (same (-1)) as E2; unfold value in *; lra. Qed.

Lemma of_placed lanes from alone_one place : (forall t, flat_known f = true -> 2 * B * t + C = 0 -> is_near (only_root
  f) t ->
   (Formas.outside (place (only_root f)) = true -> ~ (0 < t /\ within text t)) /\
   (Formas.inside (place (only_root f)) = true -> 0 < t /\ within text t)) ->
  lanes = flat_in_lanes f place -> from = Formas.linear_in_lanes_on f -> (forall limit, alone_one limit = flat_alone f
    place limit) ->
  decisions_right text (Decisions lanes from alone_one (Formas.first_of_linear_on f)).
Proof.
  intros P El Ef Ea; pose proof (fun t (On : 0 < t /\ within text t) => proj1 On) as Pos.
  destruct flat_slope_same as [EA EB].
  split; [|split; [|intros limit; split; rewrite EA, EB]]; cbn [in_lanes in_lanes_from alone alone_from].
  - rewrite El; exact (right_in_lanes_equal _ _ _ flat_is_reached (flat_in_lanes_right f B C f_sound _ _ P)).
  - rewrite Ef; apply (right_in_lanes_equal _ _ _ flat_from_is_reached), (flat_from_right f B C f_sound _ 0 Pos).
  - rewrite Ea; exact (right_up_to_equal _ _ _ _ _ _ flat_is_reached (flat_alone_right f B C f_sound _ _ P limit)).
  - apply (right_up_to_equal _ _ _ _ _ _ flat_from_is_reached), (flat_from_right f B C f_sound _ limit Pos).
Qed.

Lemma flat_right : (forall t, within text t) -> decisions_right text (flat f).
Proof.
  intros W; apply (of_placed _ _ _ (Formas.place f)).
  - intros t _ _ N; destruct (free_placed f t N) as [Out In]; split; [intros O [Ht _]; now apply Out | auto].
  - apply (flat_is_recorded f 0).
  - reflexivity.
  - intros limit; apply (flat_is_recorded f limit).
Qed.

Lemma edged_right : (flat_known f = true -> exists m, Rabs (Formas.margin f - m) <= Formas.margin_error f /\
  forall t, 2 * B * t + C = 0 -> (0 <= m <-> within text t)) -> decisions_right text (edged f).
Proof.
  intros Hm; apply (of_placed _ _ _ (Formas.place_edged f)).
  - intros t K E N; destruct (Hm K) as (m & Nm & Tells); exact (edged_placed f _ m t Nm (Tells t E) N).
  - apply (flat_is_recorded f 0).
  - reflexivity.
  - intros limit; apply (flat_is_recorded f limit).
Qed.
End Flat.

(** ** The shapes *)

Definition point (a : vec) : Punto := mk_Punto (cx a) (cy a) (cz a).
Definition direction (a : vec) : Vector := mk_Vector (cx a) (cy a) (cz a).
Definition ray_of (p v : vec) : Rayo := mk_Rayo (point p) (direction v).

Section Shapes.
Variables p v : vec.
Hypothesis ray_fits : fit_ray p v.
Notation ray := (ray_of p v).
Notation V := (extent_fl v).

Lemma sphere_same centro r : let q := minus p centro in
  same_quadratic (dot v v) (dot q v) (dot q q - r * r) (of_esfera ray (point centro) r).
Proof.
  unfold same_quadratic, ray_of, point, direction, of_esfera, Tipos.sq, Tipos.dot, from, dot, minus; cbn.
  repeat apply conj; ring.
Qed.

Theorem sphere_right centro r : ordinary_vec centro -> ordinary r -> 0 < r ->
  decisions_right (of_esfera ray (point centro) r) (unbounded (Formas.esfera p v V centro r)).
Proof.
  intros Hc Hr Hr0.
  apply (unbounded_right _ _ _ _ _ _ (sphere_sound p v centro r (p_ordinary ray_fits) (v_ordinary ray_fits) Hc Hr Hr0
    (v_not_zero ray_fits))).
  - apply sphere_same.
  - constructor.
Qed.

Lemma cylinder_same centro r d h : let a := Across.across v d in let b := Across.across (minus p centro) d in
  same_quadratic (dot a a) (dot b a) (dot b b - r * r) (of_cilindro ray (point centro) r (direction d) h).
Proof.
  unfold same_quadratic, ray_of, point, direction, of_cilindro, Across.across, Vectors.scale, Tipos.sq, Tipos.dot, from, dot,
    minus; cbn; repeat apply conj; ring.
Qed.

Lemma truncated_same centro r k d h : same_quadratic (Conical.A v d k) (Conical.B p v centro d h k r)
  (Conical.C p centro d h k r) (of_tronco ray (point centro) r k (direction d) h).
Proof.
  unfold same_quadratic, Conical.A, Conical.B, Conical.C, Conical.rho, Conical.slope, ray_of, point, direction, of_tronco,
    Across.across, Vectors.scale, Tipos.sq, Tipos.dot, from, dot, minus; cbn; repeat apply conj; ring.
Qed.

Lemma cone_same centro k d h : same_quadratic (Conical.A v d k) (Conical.B p v centro d h k 0)
  (Conical.C p centro d h k 0) (of_cono ray (point centro) k (direction d) h).
Proof.
  unfold same_quadratic, Conical.A, Conical.B, Conical.C, Conical.rho, Conical.slope, ray_of, point, direction, of_cono,
    Across.across, Vectors.scale, Tipos.sq, Tipos.dot, from, dot, minus; cbn; repeat apply conj; ring.
Qed.

Lemma within_stretch centro d h t :
  Forall (fun g => excess g t <= 0) (between (Tipos.dot (from (point centro) (point p)) (direction d))
    (Tipos.dot (direction v) (direction d)) h) <-> 0 <= dot (minus p centro) d + t * dot v d <= h.
Proof. rewrite between_holds; reflexivity. Qed.

Theorem cylinder_right centro r d h : fit_axis centro d -> ordinary r -> 0 < r -> ordinary h -> 0 < h ->
  decisions_right (of_cilindro ray (point centro) r (direction d) h) (axial (Formas.cilindro p v V centro r d h)).
Proof.
  intros Ha Hr Hr0 Hh Hh0; apply (axial_right _ _ _ _ _ _ (Cylinder.cylinder_sound p v centro d r h ray_fits Ha Hr Hr0) _
    (cylinder_same centro r d h)) with (p := p) (v := v) (centro := centro) (d := d) (h := h); auto.
  - repeat split.
  - intros t; apply within_stretch.
Qed.

Theorem plane_right centro d : fit_axis centro d ->
  decisions_right (of_plano ray (point centro) (direction d)) (flat (Formas.plano p v V centro d)).
Proof.
  intros Ha; apply (flat_right _ (dot v d / 2) (dot (minus p centro) d)).
  - apply (plane_sound p v centro d ray_fits Ha); repeat split.
  - intros t; unfold ray_of, point, direction, value, of_plano, Tipos.dot, from, dot, minus; cbn; ring.
  - intros t; unfold ray_of, point, direction, value, launched, of_plano, Tipos.dot, from, dot, minus; cbn; ring.
  - constructor.
Qed.

Theorem disc_right centro r d : fit_axis centro d -> ordinary r -> 0 < r ->
  decisions_right (of_disco ray (point centro) r (direction d)) (edged (Formas.disco p v V centro r d)).
Proof.
  intros Ha Hr Hr0; destruct (disc_recorded p v centro d r) as (Along & Em & Ee).
  pose proof (plane_sound p v centro d ray_fits Ha _ Along) as S.
  apply (edged_right _ (dot v d / 2) (dot (minus p centro) d) S).
  - intros t; unfold ray_of, point, direction, value, of_disco, Tipos.dot, from, dot, minus; cbn; ring.
  - intros t; unfold ray_of, point, direction, value, launched, of_disco, Tipos.dot, from, dot, minus; cbn; ring.
  - intros K; destruct (known_means _ _ _ S K) as [_ HB]; exists (margin p v centro d r); rewrite Em, Ee.
    split; [exact (margin_near p v centro d ray_fits Ha r Hr Hr0)|]; intros t Ht.
    rewrite (margin_tells p v centro d r Hr0 t) by lra.
    unfold within; cbn [clip of_disco]; rewrite Forall_cons_iff.
    unfold excess, ray_of, point, direction, Tipos.sq, Tipos.dot, from, dot, minus; cbn.
    split; [intros Hle; split; [exact Hle | constructor] | intros [Hle _]; exact Hle].
Qed.

Theorem truncated_right centro r k d h : fit_axis centro d -> ordinary r -> 0 < r -> ordinary k -> 0 < k ->
  ordinary h -> 0 < h ->
  decisions_right (of_tronco ray (point centro) r k (direction d) h) (axial (Formas.tronco p v V centro r k d h)).
Proof.
  intros Ha Hr Hr0 Hk Hk0 Hh Hh0; pose proof (Cone.truncated_sound p v centro d h k ray_fits Ha Hh Hh0 Hk Hk0 r Hr Hr0) as S.
  refine (axial_right _ _ _ _ _ _ S _ (truncated_same centro r k d h) p v centro d h ray_fits Ha Hh Hh0 _ _).
  - repeat split.
  - intros t; apply within_stretch.
Qed.

Theorem cone_right centro k d h : fit_axis centro d -> ordinary k -> 0 < k -> ordinary h -> 0 < h ->
  decisions_right (of_cono ray (point centro) k (direction d) h) (axial (Formas.cono p v V centro k d h)).
Proof.
  intros Ha Hk Hk0 Hh Hh0; pose proof (Cone.cone_sound p v centro d h k ray_fits Ha Hh Hh0 Hk Hk0) as S.
  refine (axial_right _ _ _ _ _ _ S _ (cone_same centro k d h) p v centro d h ray_fits Ha Hh Hh0 _ _).
  - repeat split.
  - intros t; apply within_stretch.
Qed.

Definition vertices (a b c : vec) : Terna := mk_Terna (point a) (point b) (point c).

Theorem triangle_right a b c : ordinary_vec a -> ordinary_vec b -> ordinary_vec c ->
  decisions_right (of_triangulo ray (vertices a b c)) (edged (Formas.triangulo p v V a b c)).
Proof.
  intros Ha Hb Hc; pose proof (Triangle.triangle_sound p v a b c ray_fits Ha Hb Hc) as S.
  apply (edged_right _ _ _ S).
  - intros t; unfold Triangle.det, Triangle.crossing, vertices, ray_of, point, direction, value, of_triangulo, normal,
      Puntos.cross, Tipos.dot, from, dot, cross, minus; cbn; field.
  - intros t; unfold Triangle.det, vertices, ray_of, point, direction, value, launched, of_triangulo, normal,
      Puntos.cross, Tipos.dot, from, dot, cross, minus; cbn; field.
  - intros K; exists (Triangle.margin p v a b c).
    split; [exact (Triangle.margin_near p v a b c ray_fits Ha Hb Hc)|]; intros t Ht.
    destruct (Triangle.margin_tells p v a b c ray_fits Ha Hb Hc K) as [Hd ->].
    rewrite <- (prisma_along ray (vertices a b c) t).
    assert (E : t = Triangle.crossing p a b c / Triangle.det v a b c).
    { apply Rmult_eq_reg_l with (Triangle.det v a b c); [field_simplify; lra | exact Hd]. }
    pose proof (Flat.clip_of_the_program ray (vertices a b c) Hd) as Hclip; symmetry in Hclip; rewrite E; exact Hclip.
Qed.
End Shapes.
