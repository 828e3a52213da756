(** * Triage: the first step of the search is right on a scene

    The first step computes, of an element and the ray, the quadratic of Formas.v and the decision over it: for a ray in a
    batch without a limit, for one ray up to the limit that it is asked. Both say nothing false of what the ray meets of
    the element, whether it starts on it or not: which is the first sentence of [Search.steps_right].

    shape                  == the numbers of an element, in binary64; stands s e sh == e has them in the scene s
    fit_shape sh           == its numbers are ordinary, its sizes positive, its axis a unit vector but for rounding
    in_bounds p v sh       == its numbers and the ray's are ordinary: the tracer computes in floating point with no others
    binary64s p v sh       == they are binary64;  asked_in_range p v sh == the program's test of their range, as recorded
    decisions_of p v sh    == the four decisions on it, for the ray from p along v
    answered step x a      == a is the answer of the step up to x; up to infinity, that of every limit large enough
    verdict_of a           == the answer a, as the search takes it: a finding is a root with its error *)
From Coq Require Import Reals List Bool Lra.
From Flocq Require Import Core BinarySingleNaN.
From Durero Require Import Toolkit Especificacion Escena Puntos Trazador Interseccion.
From Durero Require Tipos Certified Search Limits Formas.
From Durero Require Import Rounding Vectors Quotient Flotante Verdict Steps.
Local Open Scope R_scope.
Local Open Scope zed_scope.

Inductive shape :=
  | Sphere (centro : vec) (radio : R)
  | Cylinder (centro : vec) (radio : R) (vector : vec) (altura : R)
  | Cone (centro : vec) (proporcion : R) (vector : vec) (altura : R)
  | Truncated (centro : vec) (radio proporcion : R) (vector : vec) (altura : R)
  | Plane (centro vector : vec)
  | Disc (centro : vec) (radio : R) (vector : vec)
  | Triangle (a b c : vec).

Definition ordinary_shape (sh : shape) : Prop :=
  match sh with
  | Sphere c r => ordinary_vec c /\ ordinary r
  | Cylinder c r d h => ordinary_vec c /\ ordinary r /\ ordinary_vec d /\ ordinary h
  | Cone c k d h => ordinary_vec c /\ ordinary k /\ ordinary_vec d /\ ordinary h
  | Truncated c r k d h => ordinary_vec c /\ ordinary r /\ ordinary k /\ ordinary_vec d /\ ordinary h
  | Plane c d => ordinary_vec c /\ ordinary_vec d
  | Disc c r d => ordinary_vec c /\ ordinary r /\ ordinary_vec d
  | Triangle a b c => ordinary_vec a /\ ordinary_vec b /\ ordinary_vec c
  end.

Definition fit_shape (sh : shape) : Prop :=
  match sh with
  | Sphere c r => ordinary_vec c /\ ordinary r /\ 0 < r
  | Cylinder c r d h => fit_axis c d /\ ordinary r /\ 0 < r /\ ordinary h /\ 0 < h
  | Cone c k d h => fit_axis c d /\ ordinary k /\ 0 < k /\ ordinary h /\ 0 < h
  | Truncated c r k d h => fit_axis c d /\ ordinary r /\ 0 < r /\ ordinary k /\ 0 < k /\ ordinary h /\ 0 < h
  | Plane c d => fit_axis c d
  | Disc c r d => fit_axis c d /\ ordinary r /\ 0 < r
  | Triangle a b c => ordinary_vec a /\ ordinary_vec b /\ ordinary_vec c
  end.
Definition in_bounds (p v : vec) (sh : shape) : Prop := ordinary_ray p v /\ ordinary_shape sh.

Definition binary64_vec (a : vec) : Prop := format (cx a) /\ format (cy a) /\ format (cz a).
Definition binary64_shape (sh : shape) : Prop :=
  match sh with
  | Sphere c r => binary64_vec c /\ format r
  | Cylinder c r d h => binary64_vec c /\ format r /\ binary64_vec d /\ format h
  | Cone c k d h => binary64_vec c /\ format k /\ binary64_vec d /\ format h
  | Truncated c r k d h => binary64_vec c /\ format r /\ format k /\ binary64_vec d /\ format h
  | Plane c d => binary64_vec c /\ binary64_vec d
  | Disc c r d => binary64_vec c /\ format r /\ binary64_vec d
  | Triangle a b c => binary64_vec a /\ binary64_vec b /\ binary64_vec c
  end.
Definition binary64s (p v : vec) (sh : shape) : Prop := binary64_vec p /\ binary64_vec v /\ binary64_shape sh.

Definition shape_in_range (sh : shape) : bool :=
  match sh with
  | Sphere c r => Formas.esfera_in_range c r
  | Cylinder c r d h => Formas.cilindro_in_range c r d h
  | Cone c k d h => Formas.cono_in_range c k d h
  | Truncated c r k d h => Formas.tronco_in_range c r k d h
  | Plane c d => Formas.plano_in_range c d
  | Disc c r d => Formas.disco_in_range c r d
  | Triangle a b c => Formas.triangulo_in_range a b c
  end.
Definition asked_in_range (p v : vec) (sh : shape) : bool := Formas.ray_in_range p v && shape_in_range sh.

(** Of numbers that are binary64, the test that the program asks holds of those that are in bounds, and of no others. *)
Lemma shape_in_range_ordinary sh : binary64_shape sh -> shape_in_range sh = true <-> ordinary_shape sh.
Proof.
  assert (If : forall a b : bool, (if a then b else false) = true <-> a = true /\ b = true).
  { intros [] b; split; [now split | tauto | easy | now intros []]. }
  unfold binary64_shape, binary64_vec, ordinary_shape, ordinary_vec.
  destruct sh; cbn [shape_in_range]; intros H; repeat match goal with K : _ /\ _ |- _ => destruct K end;
    unfold Formas.esfera_in_range, Formas.cilindro_in_range, Formas.cono_in_range, Formas.tronco_in_range,
      Formas.plano_in_range, Formas.disco_in_range, Formas.triangulo_in_range; cbv zeta;
    rewrite !If, !andb_true_iff, !in_range_ordinary by assumption; tauto.
Qed.
Theorem asked_in_range_in_bounds p v sh : binary64s p v sh -> asked_in_range p v sh = true <-> in_bounds p v sh.
Proof.
  intros ((Px & Py & Pz) & (Vx & Vy & Vz) & Hs); unfold asked_in_range, in_bounds.
  now rewrite andb_true_iff, ray_in_range_ordinary, shape_in_range_ordinary.
Qed.

Lemma ordinary_vec_binary64 a : ordinary_vec a -> binary64_vec a.
Proof. intros ([X _] & [Y _] & [Z _]); now repeat split. Qed.
Lemma bounds_are_of_binary64 p v sh : in_bounds p v sh -> binary64s p v sh.
Proof.
  intros [[Hp Hv] Hs]; split; [now apply ordinary_vec_binary64 | split; [now apply ordinary_vec_binary64|]].
  destruct sh; cbn in *; repeat match goal with H : _ /\ _ |- _ => destruct H end; repeat split;
    try (now apply ordinary_vec_binary64); match goal with H : ordinary ?x |- format ?x => exact (proj1 H) end.
Qed.

Definition decisions_of (p v : vec) (sh : shape) : decisions :=
  let V := Formas.speed_of v in
  match sh with
  | Sphere c r => unbounded (Formas.esfera p v V c r)
  | Cylinder c r d h => axial (Formas.cilindro p v V c r d h)
  | Cone c k d h => axial (Formas.cono p v V c k d h)
  | Truncated c r k d h => axial (Formas.tronco p v V c r k d h)
  | Plane c d => flat (Formas.plano p v V c d)
  | Disc c r d => edged (Formas.disco p v V c r d)
  | Triangle a b c => edged (Formas.triangulo p v V a b c)
  end.

Definition lanes_of (p v : vec) (sh : shape) (on : bool) : Formas.in_lanes :=
  let d := decisions_of p v sh in if on then in_lanes_from d else in_lanes d.
Definition alone_of (p v : vec) (sh : shape) (on : bool) : R -> Formas.answer R :=
  let d := decisions_of p v sh in if on then alone_from d else alone d.

Definition answered (step : R -> Formas.answer R) (x : Limits.binary64) (a : Formas.answer R) : Prop :=
  if is_finite x then a = step (B2R x) else exists low, forall limit, low <= limit -> a = step limit.
Definition verdict_of (a : Formas.answer R) : Search.verdict (Formas.known R) :=
  match a with
  | Formas.Miss => Search.Miss _
  | Formas.Undecided => Search.Undecided _
  | Formas.Hit root _ _ => Search.Hit _ root
  end.

Section Scene.
Variable Elemento : Type.
Notation Escena := (Especificacion.Escena Elemento).
Variable s : Escena.
Hypothesis ok : Escena_ok s.
Variable en : set Elemento.
Variables p v : vec.
Notation ray := (ray_of p v).
Hypothesis ray_ok : Rayo_ok ray.
Hypothesis ray_ordinary : ordinary_ray p v.
Notation met := (met ray Elemento s en).

Definition stands (e : Elemento) (sh : shape) : Prop :=
  match sh with
  | Sphere c r => is_esfera _ s e (point c) r
  | Cylinder c r d h => is_cilindro _ s e (point c) r (direction d) h
  | Cone c k d h => is_cono _ s e (point c) k (direction d) h
  | Truncated c r k d h => is_tronco _ s e (point c) r k (direction d) h
  | Plane c d => is_plano _ s e (point c) (direction d)
  | Disc c r d => is_disco _ s e (point c) r (direction d)
  | Triangle a b c => is_triangulo _ s e (vertices a b c)
  end.

Definition text_of (sh : shape) : coefficients :=
  match sh with
  | Sphere c r => of_esfera ray (point c) r
  | Cylinder c r d h => of_cilindro ray (point c) r (direction d) h
  | Cone c k d h => of_cono ray (point c) k (direction d) h
  | Truncated c r k d h => of_tronco ray (point c) r k (direction d) h
  | Plane c d => of_plano ray (point c) (direction d)
  | Disc c r d => of_disco ray (point c) r (direction d)
  | Triangle a b c => of_triangulo ray (vertices a b c)
  end.

Lemma direction_not_zero : 0 < norm v.
Proof.
  pose proof (Tipos.ray_direction_positive ray ray_ok) as H.
  apply sqrt_lt_R0; unfold dot; cbn in H; exact H.
Qed.
Lemma ray_fits : fit_ray p v.
Proof. exact (Fit_ray p v ray_ordinary direction_not_zero). Qed.

Lemma stands_equation e sh : stands e sh -> e ∈ elementos s /\ equation ray Elemento s e (text_of sh).
Proof.
  intros H; split; [destruct sh; exact (element_of_type _ _ ok _ _ (proj1 H))|]; unfold equation; destruct sh; cbn in *.
  - left; eauto.
  - right; left; eauto 6.
  - do 2 right; left; eauto 6.
  - do 3 right; left; eauto 7.
  - do 4 right; left; eauto.
  - do 5 right; left; eauto 6.
  - do 6 right; eauto.
Qed.

(** What an element that stands in the scene has besides: its sizes are positive, and its axis is one. *)
Lemma stands_fit e sh : stands e sh -> ordinary_shape sh -> fit_shape sh.
Proof.
  assert (HR : forall r, (e, r) ∈ mi_radio s -> 0 < r) by (intros; apply (Escena_decl_mi_radio ok); now exists e).
  assert (HH : forall r, (e, r) ∈ mi_altura s -> 0 < r) by (intros; apply (Escena_decl_mi_altura ok); now exists e).
  assert (HK : forall r, (e, r) ∈ mi_proporcion s -> 0 < r)
    by (intros; apply (Escena_decl_mi_proporcion ok); now exists e).
  assert (HD : forall d, (e, d) ∈ mi_vector s -> d ∈ Unitario) by (intros; apply (Escena_inv_8 ok); now exists e).
  destruct sh; cbn [stands ordinary_shape fit_shape]; unfold is_esfera, is_cilindro, is_cono, is_tronco, is_plano, is_disco;
    intros H O; decompose [and] H; decompose [and] O;
    repeat match goal with |- _ /\ _ => split | |- fit_axis _ _ => constructor end; auto; apply Certified.axis_unit; auto.
Qed.

Theorem decisions_are_right e sh : stands e sh -> ordinary_shape sh -> decisions_right (text_of sh) (decisions_of p v sh).
Proof.
  intros H O; pose proof (stands_fit e sh H O) as Fit; pose proof ray_fits as Hray; destruct sh; cbn in Fit;
  decompose [and] Fit.
  - now apply sphere_right.
  - now apply cylinder_right.
  - now apply cone_right.
  - now apply truncated_right.
  - now apply plane_right.
  - now apply disc_right.
  - now apply triangle_right.
Qed.

Lemma met_of_shape e sh on : stands e sh -> (on = true <-> en e) ->
  forall t, reach (if on then launched (text_of sh) else text_of sh) t <-> met e t.
Proof.
  intros H Hon t; destruct (stands_equation e sh H) as [He Hq].
  destruct (met_is_reach ray Elemento s ok en e He) as (f & g & Hf & Hseen & _ & Hmet).
  rewrite (equation_unique ray Elemento s ok e _ _ Hf Hq) in Hseen; rewrite (Hmet t).
  destruct Hseen as [[Hen ->]|[Hen ->]], on; try tauto.
  assert (false = true) by tauto; discriminate.
Qed.

Theorem lanes_are_right e sh on : stands e sh -> ordinary_shape sh -> (on = true <-> en e) ->
  right_in_lanes (met e) (lanes_of p v sh on).
Proof.
  intros H O Hon; apply (right_in_lanes_equal _ _ _ (met_of_shape e sh on H Hon)).
  destruct (decisions_are_right e sh H O) as (L & Lf & _); unfold lanes_of; destruct on; assumption.
Qed.

Theorem alone_is_right e sh on limit : stands e sh -> ordinary_shape sh -> (on = true <-> en e) ->
  right_up_to (cA (text_of sh)) (cB (text_of sh)) (met e) limit (alone_of p v sh on limit).
Proof.
  intros H O Hon; apply (right_up_to_equal _ _ _ _ _ _ (met_of_shape e sh on H Hon)).
  destruct (decisions_are_right e sh H O) as (_ & _ & A); destruct (A limit); unfold alone_of; destruct on; assumption.
Qed.

(** The same, where the room beside the error does not matter. *)
Corollary lanes_within e sh on : stands e sh -> ordinary_shape sh -> (on = true <-> en e) -> let d := lanes_of p v sh on in
  (Formas.hit d = true ->
   exists t, is_least (met e) t /\ Rabs (Formas.value (Formas.root d) - t) <= Formas.error (Formas.root d))
  /\ (Formas.hit d = false -> Formas.undecided d = false -> forall t, ~ met e t).
Proof.
  intros H O Hon; destruct (lanes_are_right e sh on H O Hon) as [Hh Hm]; split; [|exact Hm].
  intros E; destruct (Hh E) as (t & Ht & N); exists t; split; [exact Ht | now apply near_within].
Qed.

Corollary alone_within e sh on limit : stands e sh -> ordinary_shape sh -> (on = true <-> en e) ->
  match alone_of p v sh on limit with
  | Formas.Miss => forall t, met e t -> limit < t
  | Formas.Undecided => True
  | Formas.Hit root _ _ => exists t, is_least (met e) t /\ Rabs (Formas.value root - t) <= Formas.error root
  end.
Proof.
  intros H O Hon; pose proof (alone_is_right e sh on limit H O Hon) as R1; destruct (alone_of p v sh on limit); auto.
  destruct R1 as (t & Ht & N & _); exists t; split; [exact Ht | now apply near_within].
Qed.

End Scene.

(** ** The first sentence of what the search asks of its steps *)
Section Search.
Variable Elemento : Type.
Variable s : Especificacion.Escena Elemento.
Hypothesis ok : Escena_ok s.
Variable en : set Elemento.
Variables p v : vec.
Notation ray := (ray_of p v).
Hypothesis ray_ok : Rayo_ok ray.
Notation met := (met ray Elemento s en).

Variable elements : list Elemento.
Variables (shape_of : Elemento -> shape) (on in_range : Elemento -> bool).
Hypothesis described : forall e, In e elements -> stands Elemento s e (shape_of e) /\ (on e = true <-> en e).
Hypothesis range : forall e, In e elements -> in_range e = true -> in_bounds p v (shape_of e).
Variable triage : Elemento -> Limits.binary64 -> Search.verdict (Formas.known R).
Hypothesis computed : forall e x, In e elements -> in_range e = true ->
  exists a, answered (alone_of p v (shape_of e) (on e)) x a /\ triage e x = verdict_of a.

Theorem triage_decides : Search.decides Elemento (Formas.known R) met elements in_range is_near triage.
Proof.
  intros e x He Hr; destruct (described e He) as [Hs Hon], (range e He Hr) as [Ray Ho], (computed e x He Hr) as (a & Ha & ->).
  pose proof (fun limit => alone_is_right Elemento s ok en p v ray_ok Ray e (shape_of e) (on e) limit Hs Ho Hon) as R1;
  unfold answered in Ha.
  destruct (is_finite x) eqn:Fx.
  - specialize (R1 (B2R x)); rewrite <- Ha in R1; destruct a; cbn in *; [|exact I | destruct R1 as (t & Ht & N & _); now exists t].
    intros t Ht [-> | [_ Hle]]; [discriminate Fx | specialize (R1 t Ht); lra].
  - destruct Ha as (low & Ha); pose proof (R1 low) as R0; rewrite <- (Ha low) in R0 by lra; destruct a; cbn in *;
    [|exact I | destruct R0 as (t & Ht & N & _); now exists t].
    intros t Ht _; specialize (R1 (Rmax low t)); rewrite <- (Ha (Rmax low t)) in R1 by apply Rmax_l; cbn in R1.
    specialize (R1 t Ht); pose proof (Rmax_r low t); lra.
Qed.
End Search.
