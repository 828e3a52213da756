(** spec/tablas.tex: the closed form of the text, with its clip, is what the ray meets. *)
From Coq Require Import Reals List Lra.
From Durero Require Import Toolkit Especificacion Escena Operaciones Tipos Puntos Trazador Interseccion Tablas.
Local Open Scope R_scope.
Local Open Scope zed_scope.

Section Trace.
Variable Elemento : Type.
Notation Escena := (Especificacion.Escena Elemento).

(** The closed form has the solutions, all of them and no other, in every case. Discharges raices.def.1. *)
Lemma raices_are_solutions f t : t ∈ raices f <->
  Cuadratica_a f * (t * t) + 2 * Cuadratica_b f * t + Cuadratica_c f = 0.
Proof.
  destruct f as [a b c]. unfold raices; cbn. unfold raizcuadrada. set (D := b * b - a * c).
  assert (S : a * (a * (t * t) + 2 * b * t + c) = (a * t + b) * (a * t + b) - D) by (unfold D; ring). split.
  - intros [[Ha [HD H]] | [[-> [Hb H]] | [-> [-> ->]]]]; [| lra | lra]. pose proof (sqrt_sqrt D (Rge_le _ _ HD)) as Q.
    assert (Z : a * (a * (t * t) + 2 * b * t + c) = 0).
    { rewrite S. destruct H as [-> | H]; [rewrite Q; ring |]. replace (a * t + b) with (- sqrt D) by lra. lra. }
    apply Rmult_integral in Z. tauto.
  - intros H. rewrite H, Rmult_0_r in S. destruct (Req_EM_T a 0) as [-> | Ha].
    + right. destruct (Req_EM_T b 0) as [-> | Hb]; [right | left]; repeat split; try assumption; lra.
    + left. assert (HD : D >= 0) by (pose proof (Rle_0_sqr (a * t + b)) as Q; unfold Rsqr in Q; lra).
      split; [exact Ha | split; [exact HD |]]. pose proof (sqrt_sqrt D (Rge_le _ _ HD)) as Q.
      assert (P : (a * t + b - sqrt D) * (a * t + b + sqrt D) = 0) by lra.
      apply Rmult_integral in P as [P | P]; [left | right]; lra.
Qed.

(** The coefficients are those of the tracer's, as Puntos.v has them. Discharges producto.def.1, desde.def.1,
    cuadratica_esfera.def.1. *)
Lemma raices_esfera ray c r t : t ∈ raices (cuadratica_esfera ray c r) <-> value (of_esfera ray c r) t = 0.
Proof. rewrite raices_are_solutions. unfold cuadratica_esfera, cuadrado, desde, producto. coordinates. reflexivity. Qed.
(** Discharges cuadratica_tronco.def.1. *)
Lemma raices_tronco ray c r k d h t :
  t ∈ raices (cuadratica_tronco ray c r k d h) <-> value (of_tronco ray c r k d h) t = 0.
Proof.
  rewrite raices_are_solutions. unfold cuadratica_tronco, desde, producto. coordinates.
  match goal with |- ?x = 0 <-> ?y = 0 => replace x with y by ring end. reflexivity.
Qed.
(** Discharges recorte.def.1. *)
Lemma recorte_is_within ray c r k d h t : t ∈ recorte ray c d h <-> within (of_tronco ray c r k d h) t.
Proof. unfold within, of_tronco; cbn [clip]. rewrite between_holds. reflexivity. Qed.

(** Of a ray that starts on no element, what it reaches of an element are its points. Discharges punto_en.def.1. *)
Lemma reached_at s ray t e : t ∈ Rmas -> e ∈ elementos s ->
  (punto_en ray t ∈ alcance (s : Escena) ray ∅ e <-> puntos_de_elemento s e (point_at ray t)).
Proof.
  intros Ht He. change (punto_en ray t) with (point_at ray t). unfold alcance, interseccion, inter. split.
  - intros [_ [_ [[[] _] | [_ H]]]]. exact H.
  - intros H. split; [exact He | split; [apply puntos_de_rayo_parameter; now exists t | right]]. split; [easy | exact H].
Qed.

(** What is of one type has its attributes. *)
Ltac attributes_of ok He Ht := let H := fresh in
  pose proof (element_cases _ _ ok _ He) as H;
  unfold is_esfera, is_cilindro, is_cono, is_tronco, is_plano, is_disco, is_triangulo in H;
  decompose [ex and or] H; clear H;
  try (match goal with K : (_, _) ∈ de_que_tipo _ |- _ => discriminate (type_unique _ _ ok _ _ _ Ht K) end).

(** Discharges raices.conj.1. *)
Theorem the_closed_form_of_a_sphere_is_alcance : raices_conj_1 Elemento.
Proof.
  intros s ray t e ok _ Ht [He Hs]. rewrite (reached_at s ray t e Ht He).
  assert (E : forall c r, (e, c) ∈ mi_centro s -> (e, r) ∈ mi_radio s ->
    (puntos_de_elemento s e (point_at ray t) <-> t ∈ raices (cuadratica_esfera ray c r))).
  { intros c r Hc Hr. rewrite raices_esfera, <- esfera_along. apply (esfera_of_scene _ _ ok). now split. }
  split; [intros H; attributes_of ok He Hs; do 2 eexists; repeat split; eauto; now apply E |].
  intros [c [r [Hc [Hr H]]]]. now apply (E c r).
Qed.
(** Discharges raices.conj.2. *)
Theorem the_closed_form_of_a_cylinder_is_alcance : raices_conj_2 Elemento.
Proof.
  intros s ray t e ok _ Ht [He Hs]. rewrite (reached_at s ray t e Ht He).
  assert (E : forall c r d h, (e, c) ∈ mi_centro s -> (e, r) ∈ mi_radio s -> (e, d) ∈ mi_vector s -> (e, h) ∈ mi_altura s ->
    (puntos_de_elemento s e (point_at ray t) <-> t ∈ raices (cuadratica_tronco ray c r 0 d h) ∩ recorte ray c d h)).
  { intros c r d h Hc Hr Hd Hh. unfold inter. rewrite raices_tronco, (recorte_is_within ray c r 0 d h), <- of_cilindro_is_tronco, <- cilindro_along.
    apply (cilindro_of_scene _ _ ok). now repeat split. }
  split; [intros H; attributes_of ok He Hs; do 4 eexists; repeat (split; [eassumption |]); apply E; assumption |].
  intros [c [r [d [h [Hc [Hr [Hd [Hh H]]]]]]]]. now apply (E c r d h).
Qed.
(** Discharges raices.conj.3. *)
Theorem the_closed_form_of_a_cone_is_alcance : raices_conj_3 Elemento.
Proof.
  intros s ray t e ok _ Ht [He Hs]. rewrite (reached_at s ray t e Ht He).
  assert (E : forall c k d h, (e, c) ∈ mi_centro s -> (e, k) ∈ mi_proporcion s -> (e, d) ∈ mi_vector s -> (e, h) ∈ mi_altura s ->
    (puntos_de_elemento s e (point_at ray t) <-> t ∈ raices (cuadratica_tronco ray c 0 k d h) ∩ recorte ray c d h)).
  { intros c k d h Hc Hk Hd Hh. unfold inter. rewrite raices_tronco, (recorte_is_within ray c 0 k d h), <- of_cono_is_tronco, <- cono_along.
    apply (cono_of_scene _ _ ok). now repeat split. }
  split; [intros H; attributes_of ok He Hs; do 4 eexists; repeat (split; [eassumption |]); apply E; assumption |].
  intros [c [k [d [h [Hc [Hk [Hd [Hh H]]]]]]]]. now apply (E c k d h).
Qed.
(** Discharges raices.conj.4. *)
Theorem the_closed_form_of_a_truncated_cone_is_alcance : raices_conj_4 Elemento.
Proof.
  intros s ray t e ok _ Ht [He Hs]. rewrite (reached_at s ray t e Ht He).
  assert (E : forall c r k d h, (e, c) ∈ mi_centro s -> (e, r) ∈ mi_radio s -> (e, k) ∈ mi_proporcion s -> (e, d) ∈ mi_vector s -> (e, h) ∈ mi_altura s ->
    (puntos_de_elemento s e (point_at ray t) <-> t ∈ raices (cuadratica_tronco ray c r k d h) ∩ recorte ray c d h)).
  { intros c r k d h Hc Hr Hk Hd Hh. unfold inter. rewrite raices_tronco, (recorte_is_within ray c r k d h), <- tronco_along.
    apply (tronco_of_scene _ _ ok). now repeat split. }
  split; [intros H; attributes_of ok He Hs; do 5 eexists; repeat (split; [eassumption |]); apply E; assumption |].
  intros [c [r [k [d [h [Hc [Hr [Hk [Hd [Hh H]]]]]]]]]]. now apply (E c r k d h).
Qed.

End Trace.
