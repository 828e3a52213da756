(** spec/interseccion.tex: reduccion, the nearest point of a set of points of a ray, and when there is one.

    parameters ray ps    == the parameters t > 0 of the points of the ray in ps
    is_infimum T m       == m is the greatest lower bound of T
    is_least, starts_in  == as in Trazador.v *)
From Coq Require Import Reals List Lra.
From Durero Require Import Toolkit Especificacion Tipos Puntos Trazador.
Local Open Scope R_scope.
Local Open Scope zed_scope.

(** reduccion is the partial function that the text describes: defined where there is exactly one nearest point, which
    is then its value. Discharges reduccion.def.1, reduccion.def.2. *)
Theorem reduccion_well_defined :
  functional reduccion
  /\ (forall ps ojo, (ps, ojo) ∈ dom reduccion <->
      exists! temp, temp ∈ ps /\ forall otro, otro ∈ ps -> distancia temp ojo <= distancia otro ojo)
  /\ (forall ps ojo p, ((ps, ojo), p) ∈ reduccion ->
      p ∈ ps /\ forall otro, otro ∈ ps -> distancia p ojo <= distancia otro ojo).
Proof.
  split; [| split].
  - intros [ps ojo] p p' [_ [H U]] [_ [H' U']]. now apply U'.
  - intros ps ojo. split; [now intros [p [H _]] |]. intros H. pose proof H as [p [Hp U]]. exists p.
    split; [exact H | split; [exact Hp |]]. intros y Hy. symmetry. now apply U.
  - intros ps ojo p [_ [H _]]. exact H.
Qed.

(** A point of a ray is at distance t·|v| from the origin. Discharges distancia.def.1. *)
Lemma distancia_along ray t : 0 <= t -> distancia (point_at ray t) (Rayo_p ray) = t * sqrt (sq (Rayo_v ray)).
Proof.
  intros Ht. unfold distancia, raizcuadrada. rewrite <- (sqrt_square t Ht) at 4. rewrite <- sqrt_mult_alt.
  - f_equal. unfold cuadrado, sq, dot; cbn. ring.
  - now apply Rmult_le_pos.
Qed.

Definition is_infimum (T : set R) (m : R) : Prop :=
  (forall t, T t -> m <= t) /\ forall m', (forall t, T t -> m' <= t) -> m' <= m.

Lemma least_unique T t t' : is_least T t -> is_least T t' -> t = t'.
Proof. intros [H L] [H' L']. apply Rle_antisym; auto. Qed.

Section Ray.
Variable ray : Rayo.
Hypothesis ray_ok : Rayo_ok ray.
Let p := Rayo_p ray.

Definition parameters (ps : set Punto) : set R := fun t => 0 < t /\ ps (point_at ray t).

Lemma nearest_is_least ps t : ps ⊆ puntos_de_rayo ray -> 0 < t ->
  ((ps (point_at ray t) /\ forall otro, ps otro -> distancia (point_at ray t) p <= distancia otro p)
   <-> is_least (parameters ps) t).
Proof.
  intros Hps Ht. pose proof (sqrt_lt_R0 _ (ray_direction_positive ray ray_ok)) as Hv. split.
  - intros [H L]. split; [now split |]. intros t' [Ht' H']. specialize (L _ H'). unfold p in L.
    rewrite !distancia_along in L by lra. now apply Rmult_le_reg_r in L.
  - intros [[_ H] L]. split; [exact H |]. intros otro Ho. destruct (proj1 (puntos_de_rayo_parameter _ _) (Hps _ Ho))
      as [t' [Ht' ->]]. unfold p. rewrite !distancia_along by lra. apply Rmult_le_compat_r; [lra |]. apply L. now split.
Qed.

(** On a ray, reduccion of a set of its points is the point of the least parameter: two points at one distance are one. *)
Theorem reduccion_on_ray ps w : ps ⊆ puntos_de_rayo ray ->
  (((ps, p), w) ∈ reduccion <-> exists t, w = point_at ray t /\ is_least (parameters ps) t).
Proof.
  intros Hps. split.
  - intros [_ [[H L] _]]. destruct (proj1 (puntos_de_rayo_parameter _ _) (Hps _ H)) as [t [Ht ->]].
    exists t. split; [reflexivity |]. now apply nearest_is_least.
  - intros [t [-> Hl]]. pose proof Hl as [[Ht _] _]. apply (proj2 (nearest_is_least ps t Hps Ht)) in Hl as Hn.
    assert (U : forall y, ps y /\ (forall otro, ps otro -> distancia y p <= distancia otro p) -> y = point_at ray t).
    { intros y [Hy Ly]. destruct (proj1 (puntos_de_rayo_parameter _ _) (Hps _ Hy)) as [t' [Ht' ->]].
      f_equal. apply least_unique with (parameters ps); [now apply nearest_is_least | exact Hl]. }
    split; [| now split]. exists (point_at ray t). split; [exact Hn |]. intros y Hy. symmetry. now apply U.
Qed.

(** On a ray the nearest point exists, and is then unique, exactly when the infimum of the parameters is attained. *)
Theorem reduccion_exists_iff_infimum_attained ps : ps ⊆ puntos_de_rayo ray ->
  ((ps, p) ∈ dom reduccion <-> (exists w, w ∈ ps) /\ exists m, is_infimum (parameters ps) m /\ parameters ps m).
Proof.
  intros Hps. split.
  - intros [w H]. apply reduccion_on_ray in H as [t [-> [[Ht H] L]]]; [| exact Hps].
    split; [now exists (point_at ray t) |]. exists t. split; [| now split]. split; [exact L |].
    intros m' Hm. apply Hm. now split.
  - intros [_ [m [[L _] Hm]]]. exists (point_at ray m). apply reduccion_on_ray; [exact Hps |].
    exists m. split; [reflexivity | now split].
Qed.

Lemma starts_in_no_least T : starts_in T -> (forall t, T t -> 0 < t) -> ~ exists t, is_least T t.
Proof.
  intros [eps [He H]] Hpos [t [Ht L]]. pose proof (Hpos t Ht).
  assert (Hm : 0 < Rmin t eps / 2 < eps).
  { pose proof (Rmin_r t eps). pose proof (Rmin_glb_lt t eps 0). lra. }
  pose proof (L _ (H _ Hm)). pose proof (Rmin_l t eps). lra.
Qed.
End Ray.
