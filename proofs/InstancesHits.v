(** * InstancesHits: the theorems of the scan, on the seven shapes

    The parameters are those of Firsts.v, and the ray is the one from outside. What acceleration is about is there for
    InstancesCells.v: the first hit of each element, and the boxes that hold some of them.

    hit_of e, surface e w == the first hit of the element e, as the oracle finds it; the point w is on e
    the_point t           == the point at t; where there is no minimum, the ray's origin
    found_first best      == best is the sphere alone, at the parameter that the oracle finds
    bounded, flat         == three elements that a box holds; these and the plane *)
From Coq Require Import ZArith Reals List Bool Lia Lra.
From Durero Require Import Toolkit Especificacion Exacto InstanceScene InstanceSearch.
From Durero Require Surd Quadratic Trazador Interseccion ExactoEscena Recorrido Firsts Acceleration MainModels MainText InstancesText.
Import ListNotations.
Import Acceleration(axis, X, Y, Z).
Local Open Scope R_scope.

Notation p := (v3 (-16) 2 1).
Notation v := (v3 8 1 (-1)).
Notation s := (scene_of 2 seven).
Notation first := Firsts.first.
Notation le := Firsts.le.

Definition found (e : nat) : Quadratic.reach := Quadratic.first (quad 2 (shape_at e) false p v).
Definition hit_of (e : nat) : option first :=
  match found e with
  | Quadratic.Nothing => None
  | Quadratic.At x => Some (Some (Surd.val x))
  | Quadratic.NoMinimum => Some None
  end.
Definition coordinates (w : Punto) : Acceleration.point :=
  fun i => match i with X => Punto_x w | Y => Punto_y w | Z => Punto_z w end.
Definition the_point (t : first) : Acceleration.point :=
  coordinates (match t with Some t => ray_at 2 p v t | None => point 2 p end).
Definition surface (e : nat) (w : Acceleration.point) : Prop :=
  points 2 (shape_at e) false p (mk_Punto (w X) (w Y) (w Z)).

Lemma it_starts_in_none e : found e <> Quadratic.NoMinimum.
Proof. do 8 (destruct e as [| e]; [vm_compute; discriminate|]); vm_compute; discriminate. Qed.

Lemma a_hit e t : hit_of e = Some t -> exists x, t = Some x /\ 0 < x /\ surface e (the_point t).
Proof.
  unfold hit_of; pose proof (first_of_shape 2 (shape_at e) false p v eq_refl) as H; fold (found e) in H.
  pose proof (it_starts_in_none e) as N; destruct (found e) as [|x|]; [discriminate | intros [= <-] | now destruct N].
  destruct H as (_ & [Hpos Hon] & _); exists (Surd.val x); split; [reflexivity | split; [exact Hpos | exact Hon]].
Qed.
Lemma hits_on_surface e t : hit_of e = Some t -> surface e (the_point t).
Proof. intros H; now destruct (a_hit e t H) as (x & _ & _ & On). Qed.

(** ** The scan, and what is found *)

Definition total := proj1 MainModels.those_parameters_are_totally_ordered.
Definition trans := proj1 (proj2 MainModels.those_parameters_are_totally_ordered).
Definition antisym := proj2 (proj2 MainModels.those_parameters_are_totally_ordered).
Notation scan := (Recorrido.scan first le nat hit_of).

Definition instance_of_the_scan_finds_the_first_hit :=
  MainModels.the_scan_finds_the_first_hit first le total trans antisym nat hit_of elements.
Definition backwards := MainModels.the_scan_finds_the_first_hit first le total trans antisym nat hit_of (rev elements).
Definition instance_of_the_first_hit_is_one :=
  MainModels.the_first_hit_is_one first le antisym nat hit_of elements (rev elements) (scan elements) (scan (rev elements))
    (in_rev elements) instance_of_the_scan_finds_the_first_hit backwards.

Lemma in_the_list e : In e elements ->
  In (e, shape_at e, false) (map (fun a => (fst a, snd a, InstancesText.nowhere (fst a))) seven).
Proof.
  intros He; change elements with [1; 2; 3; 4; 5; 6; 7]%nat in He; cbn in He; decompose [or] He; subst; try contradiction;
    cbn; tauto.
Qed.
Lemma firsts e : In e elements ->
  Firsts.is_first_of (Interseccion.met InstancesText.from_outside nat s empty e) (hit_of e).
Proof.
  intros He; pose proof (fun t => ExactoEscena.meets_met nat 2 s the_seven_are_a_scene empty p v _
    (described 2 seven empty InstancesText.nowhere InstancesText.no_element_is_on) e _ false t (in_the_list e He)) as M.
  unfold hit_of; pose proof (first_of_shape 2 (shape_at e) false p v eq_refl) as H; fold (found e) in H.
  pose proof (it_starts_in_none e) as N; destruct (found e) as [|x|]; cbn in *.
  - intros t Ht; apply M in Ht; now destruct (H t).
  - destruct H as (_ & Hit & Least); split; [now apply M | intros t Ht; apply M in Ht; now apply Least].
  - now destruct N.
Qed.
Lemma all_elements e : In e elements <-> elementos s e.
Proof.
  split.
  - intros He; apply in_map_iff in He as ([e' sh] & <- & Hin); exists (row_of 2 sh); apply rows_of; now exists sh.
  - intros [x Hx]; apply rows_of in Hx as (sh & Hin & _); apply (in_map fst) in Hin; exact Hin.
Qed.
Definition instance_of_the_first_hit_of_a_traversal_is_Primera_Interseccion :=
  MainModels.the_first_hit_of_a_traversal_is_Primera_Interseccion nat s s _ _ elements hit_of (scan elements) the_seven_are_a_scene
    (is_ray _ _ _ InstancesText.ray_from_outside) same_scene InstancesText.none_is_known all_elements firsts
    instance_of_the_scan_finds_the_first_hit.

(** Whatever elements there are besides, the first hit is that of the sphere. *)
Definition found_first (best : Recorrido.best_so_far first nat) : Prop :=
  exists l, best = Some (Some (Surd.val InstancesText.the_first), l) /\ forall e, In e l <-> e = 1%nat.
Theorem the_sphere_is_first es best : incl es elements -> In 1%nat es -> Recorrido.first_hit first le nat hit_of es best ->
  found_first best.
Proof.
  intros All One H; pose proof InstancesText.the_sphere_is_hit as Hit.
  apply Interseccion.hit_computed in Hit as (Least & _ & Els & _);
    [|exact (is_ray _ _ _ InstancesText.ray_from_outside) | exact same_scene | exact InstancesText.none_is_known].
  assert (Of : forall e, In e es -> (hit_of e = Some (Some (Surd.val InstancesText.the_first)) <-> e = 1%nat)).
  { intros e He; rewrite (Firsts.first_of_least nat s _ _ elements hit_of firsts e _ (All e He)); split.
    - intros L; destruct (proj2 (Els e) (conj (proj1 (all_elements e) (All e He)) L)) as [<- | []]; reflexivity.
    - intros ->; exact (proj2 (proj1 (Els 1%nat) (or_introl eq_refl))). }
  destruct best as [[b l] |]; cbn in H; [|pose proof (proj2 (Of 1%nat One) eq_refl) as K; now rewrite (H _ One) in K].
  destruct H as (Some_ & In_ & Min); assert (E : b = Some (Surd.val InstancesText.the_first)).
  { destruct l as [| e l]; [now destruct Some_|]; destruct (proj1 (In_ e) (or_introl eq_refl)) as [He Hb].
    destruct (a_hit e b Hb) as (x & -> & _ & _); f_equal; apply Rle_antisym.
    - apply Firsts.le_some, (Min 1%nat); [exact One | now apply Of].
    - apply Least, Interseccion.met_scene_is_union; exists e; split; [now apply all_elements, All|].
      exact (proj1 (proj1 (Firsts.first_of_least nat s _ _ elements hit_of firsts e x (All e He)) Hb)). }
  subst b; exists l; split; [reflexivity | intros e; rewrite In_; split; [intros [He Hb]; now apply (Of e) | intros ->]].
  split; [exact One | now apply Of].
Qed.

(** ** Where the elements are *)

Notation bounded := [1; 2; 6]%nat.
Notation flat := [1; 2; 5; 6]%nat.
Notation Box := Acceleration.Box.
Notation box a b c d e f := (Box (coordinates (mk_Punto a c e)) (coordinates (mk_Punto b d f))).
Notation around_the_sphere := (box (-3) 3 (-3) 3 (-3) 3).
Notation around_the_cylinder := (box 6 10 (-2) 2 (-2) 2).
Notation around_the_disc := (box 32 32 (-4) 4 (-4) 4).
Notation beyond := (box 6 32 (-4) 4 (-4) 4).
Notation around_all := (box (-3) 32 (-4) 4 (-4) 4).

Lemma between x r : 0 <= r -> x * x <= r * r -> - r <= x <= r.
Proof. intros Hr H; split; [now apply Rsqr_neg_pos_le_0 | now apply Rsqr_incr_0_var]. Qed.

Ltac unfolded H := cbn in H; unfold potencia_esfera, potencia_cilindro, potencia_plano, alejamiento, avance, cuadrado in H; cbn in H;
  unfold over in H; cbn in H.
Lemma sphere_there w : surface 1 w -> Acceleration.inside around_the_sphere w.
Proof.
  unfold surface; intros [H _]; unfolded H.
  assert (E : w X * w X + w Y * w Y + w Z * w Z = 3 * 3) by lra.
  pose proof (Rle_0_sqr (w X)); pose proof (Rle_0_sqr (w Y)); pose proof (Rle_0_sqr (w Z)); unfold Rsqr in *.
  intros []; cbn; apply between; lra.
Qed.
Lemma cylinder_there w : surface 2 w -> Acceleration.inside around_the_cylinder w.
Proof.
  unfold surface; intros [H Clip]; unfolded H; unfolded Clip.
  assert (E : (w X - 8) * (w X - 8) + w Y * w Y = 2 * 2) by lra.
  pose proof (Rle_0_sqr (w X - 8)); pose proof (Rle_0_sqr (w Y)); unfold Rsqr in *.
  pose proof (between (w X - 8) 2); pose proof (between (w Y) 2).
  intros []; cbn; lra.
Qed.
Lemma disc_there w : surface 6 w -> Acceleration.inside around_the_disc w.
Proof.
  unfold surface; intros [H Clip]; unfolded H; unfolded Clip.
  pose proof (Rle_0_sqr (w X - 32)); pose proof (Rle_0_sqr (w Y)); pose proof (Rle_0_sqr (w Z)); unfold Rsqr in *.
  pose proof (between (w Y) 4); pose proof (between (w Z) 4).
  intros []; cbn; lra.
Qed.
Lemma plane_there w : surface 5 w -> w X = 40.
Proof. unfold surface; intros [H _]; unfolded H; lra. Qed.

(** The sphere is before x = 5, the others are beyond. *)
Lemma split_at_five e w : In e flat -> surface e w -> if Nat.eqb e 1 then w X <= 3 else 6 <= w X <= 40.
Proof.
  intros He H; cbn in He; decompose [or] He; subst; try contradiction; cbn.
  - exact (proj2 (sphere_there w H X)).
  - pose proof (cylinder_there w H X) as K; cbn in K; lra.
  - rewrite (plane_there w H); lra.
  - pose proof (disc_there w H X) as K; cbn in K; lra.
Qed.
Lemma inside_all e w : In e bounded -> surface e w -> Acceleration.inside around_all w.
Proof.
  intros He H i; cbn in He; decompose [or] He; subst; try contradiction.
  - pose proof (sphere_there w H i); destruct i; cbn in *; lra.
  - pose proof (cylinder_there w H i); destruct i; cbn in *; lra.
  - pose proof (disc_there w H i); destruct i; cbn in *; lra.
Qed.
