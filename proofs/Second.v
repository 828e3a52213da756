(** * Second: the second step of the search on a shape of a scene

    second_of p v sh on == what the second step computes of the shape sh, for the ray from p along v *)
From Coq Require Import Reals Lra.
From Flocq Require Import Core.
From Durero Require Import Toolkit Especificacion Escena Puntos Trazador.
From Durero Require Interseccion Formas Once Chain.
From Durero Require Import Rounding Vectors Flotante Steps Triage Twofold Sums Doubled StableSphere StablePlane StableDisc
  StableTriangle StableCylinder StableCone.
Import Formas.Pairs.
Local Open Scope R_scope.
Local Open Scope zed_scope.

Definition second_of (p v : vec) (sh : shape) (on : bool) : R -> Formas.answer twofold :=
  let V := Formas.speed_of v in
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

(** A hit is within its error of the least of T, and is rounded right where that is certain. *)
Definition right_when_rounded (p v : vec) (T : R -> Prop) (limit : R) (a : Formas.answer twofold) : Prop :=
  match a with
  | Formas.Miss => forall t, T t -> limit < t
  | Formas.Undecided => True
  | Formas.Hit root _ _ => exists t, is_least T t /\ Rabs (t - whole (Formas.value root)) <= Formas.error root /\
      forall out, let once := round_point p v (Formas.value root) (Formas.error root) in
      all_certain once = true -> Once.stores out once -> Chain.rounds (ray_of p v) out t
  end.

Lemma right_and_rounded p v T limit a : ordinary_ray p v -> right_pair T limit a -> right_when_rounded p v T limit a.
Proof.
  intros [Hp Hv]; destruct a as [| | root slope curvature]; cbn [right_pair right_when_rounded]; auto.
  intros (t & Ht & (N & W & Fe & He) & _); exists t; split; [exact Ht|].
  pose proof (bpow_gt_0 radix2 (-900)); rewrite Rabs_minus_sym; split; [lra|]; intros out Hc Hs.
  apply (Once.certain_is_rounded_right p v (Formas.value root) (Formas.error root)); auto.
  - now apply double_word_is_pair.
  - rewrite Rabs_minus_sym; lra.
Qed.

Section Scene.
Variable Elemento : Type.
Variable s : Especificacion.Escena Elemento.
Variable en : set Elemento.
Variables p v : vec.
Hypothesis ok : Escena_ok s.
Hypothesis ray_ok : Rayo_ok (ray_of p v).
Hypothesis ray_ordinary : ordinary_ray p v.

Theorem second_pair e sh on limit : stands Elemento s e sh -> ordinary_shape sh -> (on = true <-> en e) ->
  format limit -> right_pair (Interseccion.met (ray_of p v) Elemento s en e) limit (second_of p v sh on limit).
Proof.
  intros Hs Ho Hon Fl; apply (right_pair_equal _ _ _ _ (met_of_shape Elemento s ok en p v e sh on Hs Hon)).
  pose proof (ray_fits p v ray_ok ray_ordinary) as Hray; pose proof (stands_fit Elemento s ok e sh Hs Ho) as Fit.
  assert (Right : right_pair (reach (text_of p v sh)) limit (second_of p v sh false limit) /\
    right_pair (reach (launched (text_of p v sh))) limit (second_of p v sh true limit)).
  { destruct sh; cbn in Fit; decompose [and] Fit; unfold second_of.
    - now apply stable_sphere_right.
    - now apply stable_cylinder_right.
    - now apply stable_cone_right.
    - now apply stable_truncated_right.
    - now apply stable_plane_right.
    - now apply stable_disc_right.
    - now apply stable_triangle_right. }
  destruct on; apply Right.
Qed.

Theorem second_right e sh on limit : stands Elemento s e sh -> ordinary_shape sh -> (on = true <-> en e) ->
  format limit -> right_when_rounded p v (Interseccion.met (ray_of p v) Elemento s en e) limit (second_of p v sh on limit).
Proof. intros; apply right_and_rounded; auto; now apply second_pair. Qed.
End Scene.
