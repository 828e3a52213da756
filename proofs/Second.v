(** * Second: the second step of the search on a shape of a scene

    second_of p v sh on == what the second step computes of the shape sh, for the ray from p along v *)
From Coq Require Import Reals Lra.
From Flocq Require Import Core.
From Durero Require Import Toolkit Especificacion Escena Puntos Trazador.
From Durero Require Certified Interseccion Formas.
From Durero Require Import Rounding Vectors Flotante Steps Triage Twofold Doubled StableSphere StablePlane StableDisc
  StableTriangle StableCylinder StableCone.
Import Formas.Pairs.
Local Open Scope R_scope.
Local Open Scope zed_scope.

Definition second_of (p v : vec) (sh : shape) (on : bool) : R -> Formas.answer twofold :=
  let V := extent_fl v in
  let curved f := if on then first_of_curved_on f else first_of_curved f in
  let axial f := if on then first_of_curved_on_axial f else first_of_curved_axial f in
  let edged f := if on then first_of_linear_on f else first_of_linear_edged f in
  match sh with
  | Sphere c r => curved (esfera p v V c r)
  | Cylinder c r d h => axial (cilindro p v V c r d h)
  | Cone c k d h => axial (cono p v V c k d h)
  | Truncated c r k d h => axial (tronco p v V c r k d h)
  | Plane c d => if on then first_of_linear_on (plano p v V c d) else first_of_linear (plano p v V c d)
  | Disc c r d => edged (disco p v V c r d)
  | Triangle a b c => edged (triangulo p v V a b c)
  end.

Section Scene.
Variable Elemento : Type.
Variable s : Especificacion.Escena Elemento.
Variable en : set Elemento.
Variables p v : vec.
Hypothesis ok : Escena_ok s.
Hypothesis ray_ok : Rayo_ok (ray_of p v).
Hypothesis p_ordinary : ordinary_vec p.
Hypothesis v_ordinary : ordinary_vec v.

Let v_not_zero : 0 < norm v := direction_not_zero p v ray_ok.

Theorem second_pair e sh on limit : stands Elemento s e sh -> ordinary_shape sh -> (on = true <-> en e) ->
  format limit -> right_pair (Interseccion.met (ray_of p v) Elemento s en e) limit (second_of p v sh on limit).
Proof.
  intros Hs Ho Hon Fl; destruct sh.
  - exact (stable_of_sphere_pair Elemento s en p v e _ _ on limit ok ray_ok p_ordinary v_ordinary Hs Ho Hon Fl).
  - apply (right_pair_equal _ _ _ _ (met_of_shape Elemento s ok en p v e _ on Hs Hon)).
    destruct Ho as (Hc & Hr & Hd & Hh), Hs as (_ & _ & Hrad & Hv & Halt).
    assert (Hu : direction vector ∈ Unitario) by (apply (Escena_inv_8 ok); now exists e).
    assert (Hr0 : 0 < radio) by (apply (Escena_decl_mi_radio ok); now exists e).
    assert (Hh0 : 0 < altura) by (apply (Escena_decl_mi_altura ok); now exists e).
    destruct (stable_cylinder_right p v _ _ _ _ p_ordinary v_ordinary Hc Hd Hr Hr0 v_not_zero (Certified.axis_unit _ Hu) Hh Hh0
      limit Fl); unfold second_of; destruct on; assumption.
  - apply (right_pair_equal _ _ _ _ (met_of_shape Elemento s ok en p v e _ on Hs Hon)).
    destruct Ho as (Hc & Hk & Hd & Hh), Hs as (_ & _ & Hprop & Hv & Halt).
    assert (Hu : direction vector ∈ Unitario) by (apply (Escena_inv_8 ok); now exists e).
    assert (Hk0 : 0 < proporcion) by (apply (Escena_decl_mi_proporcion ok); now exists e).
    assert (Hh0 : 0 < altura) by (apply (Escena_decl_mi_altura ok); now exists e).
    destruct (stable_cone_right p v _ _ _ _ p_ordinary v_ordinary Hc Hd Hh Hh0 Hk Hk0 v_not_zero (Certified.axis_unit _ Hu) limit Fl).
    unfold second_of; destruct on; assumption.
  - apply (right_pair_equal _ _ _ _ (met_of_shape Elemento s ok en p v e _ on Hs Hon)).
    destruct Ho as (Hc & Hr & Hk & Hd & Hh), Hs as (_ & _ & Hrad & Hprop & Hv & Halt).
    assert (Hu : direction vector ∈ Unitario) by (apply (Escena_inv_8 ok); now exists e).
    assert (Hr0 : 0 < radio) by (apply (Escena_decl_mi_radio ok); now exists e).
    assert (Hk0 : 0 < proporcion) by (apply (Escena_decl_mi_proporcion ok); now exists e).
    assert (Hh0 : 0 < altura) by (apply (Escena_decl_mi_altura ok); now exists e).
    destruct (stable_truncated_right p v _ _ _ _ _ p_ordinary v_ordinary Hc Hd Hh Hh0 Hk Hk0 v_not_zero (Certified.axis_unit _ Hu)
      Hr Hr0 limit Fl); unfold second_of; destruct on; assumption.
  - apply (right_pair_equal _ _ _ _ (met_of_shape Elemento s ok en p v e _ on Hs Hon)).
    destruct Ho as [Hc Hd]; assert (Hu : direction vector ∈ Unitario).
    { destruct Hs as [_ [_ Hv]]; apply (Escena_inv_8 ok); now exists e. }
    destruct (stable_plane_right p v p_ordinary v_ordinary (direction_not_zero p v ray_ok) _ _ limit Hc Hd Hu Fl).
    unfold second_of; destruct on; assumption.
  - apply (right_pair_equal _ _ _ _ (met_of_shape Elemento s ok en p v e _ on Hs Hon)).
    destruct Ho as (Hc & Hr & Hd), Hs as (_ & _ & Hrad & Hv).
    assert (Hu : direction vector ∈ Unitario) by (apply (Escena_inv_8 ok); now exists e).
    assert (Hr0 : 0 < radio) by (apply (Escena_decl_mi_radio ok); now exists e).
    destruct (stable_disc_right p v _ _ _ limit p_ordinary v_ordinary (direction_not_zero p v ray_ok) Hc Hr Hr0 Hd Hu Fl).
    unfold second_of; destruct on; assumption.
  - apply (right_pair_equal _ _ _ _ (met_of_shape Elemento s ok en p v e _ on Hs Hon)); destruct Ho as (Ha & Hb & Hc).
    destruct (stable_triangle_right p v _ _ _ limit p_ordinary v_ordinary (direction_not_zero p v ray_ok) Ha Hb Hc Fl).
    unfold second_of; destruct on; assumption.
Qed.

Theorem second_right e sh on limit : stands Elemento s e sh -> ordinary_shape sh -> (on = true <-> en e) ->
  format limit -> right_when_rounded p v (Interseccion.met (ray_of p v) Elemento s en e) limit (second_of p v sh on limit).
Proof. intros; apply right_and_rounded; auto; now apply second_pair. Qed.
End Scene.
