(** The distance of a point from a set of points: what spec/distancias.tex claims of it.

    gap a b == the vector from a point to another *)
From Coq Require Import Reals Lra.
From Durero Require Import Toolkit Especificacion Tipos Escena Puntos Trazador Interseccion.
Local Open Scope R_scope.
Local Open Scope zed_scope.

Definition gap (a b : Punto) : Vector :=
  mk_Vector (Punto_x a - Punto_x b) (Punto_y a - Punto_y b) (Punto_z a - Punto_z b).

Lemma distancia_of_gap a b : distancia a b = sqrt (sq (gap a b)).
Proof. unfold distancia, raizcuadrada, cuadrado, sq, dot, gap. reflexivity. Qed.

Lemma sq_nonneg v : 0 <= sq v.
Proof.
  destruct v as [x y z]. unfold sq, dot. cbn. pose proof (Rle_0_sqr x). pose proof (Rle_0_sqr y).
  pose proof (Rle_0_sqr z). unfold Rsqr in *. lra.
Qed.

Lemma distancia_nonneg a b : 0 <= distancia a b.
Proof. rewrite distancia_of_gap. apply sqrt_pos. Qed.

Lemma distancia_squared a b : distancia a b * distancia a b = sq (gap a b).
Proof. rewrite distancia_of_gap. apply sqrt_sqrt, sq_nonneg. Qed.

Lemma distancia_symmetric a b : distancia a b = distancia b a.
Proof. rewrite !distancia_of_gap. f_equal. unfold sq, dot, gap. cbn. ring. Qed.

(** Of two numbers that are not negative the lesser has the lesser square. *)
Lemma by_squares x y : 0 <= y -> x * x <= y * y -> x <= y.
Proof. intros Hy H. now apply Rsqr_incr_0_var. Qed.

(** The inequality of Cauchy and Schwarz, with the two lengths as numbers. *)
Lemma dot_at_most u v a b : 0 <= a -> 0 <= b -> a * a = sq u -> b * b = sq v -> dot u v <= a * b.
Proof.
  intros Ha Hb Ea Eb. apply by_squares; [now apply Rmult_le_pos |].
  replace (a * b * (a * b)) with (a * a * (b * b)) by ring. rewrite Ea, Eb.
  destruct u as [x y z], v as [x' y' z']. unfold sq, dot. cbn.
  pose proof (Rle_0_sqr (x * y' - y * x')). pose proof (Rle_0_sqr (y * z' - z * y')).
  pose proof (Rle_0_sqr (z * x' - x * z')). unfold Rsqr in *. lra.
Qed.

(** The inequality of the triangle. *)
Lemma distancia_triangle a b c : distancia a c <= distancia a b + distancia b c.
Proof.
  pose proof (distancia_nonneg a b) as Pab. pose proof (distancia_nonneg b c) as Pbc.
  apply by_squares; [lra |]. rewrite distancia_squared.
  pose proof (dot_at_most (gap a b) (gap b c) _ _ Pab Pbc (distancia_squared a b) (distancia_squared b c)) as D.
  replace ((distancia a b + distancia b c) * (distancia a b + distancia b c))
    with (distancia a b * distancia a b + distancia b c * distancia b c + 2 * (distancia a b * distancia b c)) by ring.
  rewrite !distancia_squared.
  replace (sq (gap a c)) with (sq (gap a b) + sq (gap b c) + 2 * dot (gap a b) (gap b c)); [lra |].
  unfold sq, dot, gap. cbn. ring.
Qed.

(** ** Sets *)

(** No point of the set is nearer than its distance. *)
Lemma none_is_nearer ps p r w : a_distancia ps p r -> w ∈ ps -> r <= distancia w p.
Proof. intros [v [[_ H] ->]] Hw. now apply H. Qed.

(** Discharges a_distancia.def.1, cercanos.def.1, a_distancia.conj.1. *)
Theorem a_set_has_one_distance : a_distancia_conj_1.
Proof.
  intros ps p r s Hr Hs. pose proof Hr as [v [[Hv _] E]]. pose proof Hs as [w [[Hw _] F]].
  apply Rle_antisym; [rewrite F | rewrite E]; eapply none_is_nearer; eassumption.
Qed.

(** Discharges a_distancia.conj.2. *)
Theorem the_ball_of_the_distance_is_empty : a_distancia_conj_2.
Proof. intros ps p w r H Hlt Hw. pose proof (none_is_nearer _ _ _ _ H Hw). lra. Qed.

(** Discharges a_distancia.conj.3. *)
Theorem the_distance_changes_no_faster_than_the_point_moves : a_distancia_conj_3.
Proof.
  intros ps p q r s Hr [w [[Hw _] ->]]. pose proof (none_is_nearer _ _ _ _ Hr Hw).
  pose proof (distancia_triangle w q p). rewrite (distancia_symmetric q p) in *. lra.
Qed.

(** Discharges a_distancia.conj.4. *)
Theorem a_step_of_sphere_tracing_passes_nothing : a_distancia_conj_4.
Proof.
  intros ps rayo q w r t u _ Qx Qy Qz Wx Wy Wz H Htu Hlt Hw.
  pose proof (none_is_nearer _ _ _ _ H Hw) as N.
  assert (E : distancia w q = (u - t) * sqrt (sq (Rayo_v rayo))).
  { rewrite distancia_of_gap. rewrite <- (sqrt_square (u - t)) at 1 by lra.
    rewrite <- sqrt_mult_alt by apply Rle_0_sqr. f_equal. unfold gap. rewrite Qx, Qy, Qz, Wx, Wy, Wz.
    unfold sq, dot. cbn. ring. }
  unfold raizcuadrada in Hlt. change (producto (Rayo_v rayo) (Rayo_v rayo)) with (sq (Rayo_v rayo)) in Hlt. lra.
Qed.

(** ** A sphere *)

(** A point on the way from a centre to another point, or anywhere where the two are one. *)
Lemma point_of_sphere c p r : 0 <= r -> exists w, distancia w c = r /\ distancia w p = Rabs (distancia p c - r).
Proof.
  intros Hr. pose proof (distancia_nonneg p c) as P. pose proof (distancia_squared p c) as S.
  destruct (Req_dec (distancia p c) 0) as [Z | Z].
  - exists (mk_Punto (Punto_x c + r) (Punto_y c) (Punto_z c)).
    assert (G : sq (gap p c) = 0) by (rewrite <- S, Z; ring).
    assert (E : gap p c = mk_Vector 0 0 0).
    { unfold sq, dot, gap in *. cbn in G. pose proof (Rle_0_sqr (Punto_x p - Punto_x c)).
      pose proof (Rle_0_sqr (Punto_y p - Punto_y c)). pose proof (Rle_0_sqr (Punto_z p - Punto_z c)).
      unfold Rsqr in *. f_equal; apply Rsqr_0_uniq; unfold Rsqr; lra. }
    unfold gap in E. injection E as Ex Ey Ez. rewrite Z, !distancia_of_gap. unfold gap, sq, dot. cbn. split.
    + replace (_ + _ + _) with (r * r) by ring. now apply sqrt_square.
    + replace (_ + _ + _) with (r * r).
      * rewrite sqrt_square by exact Hr. rewrite Rabs_left1 by lra. ring.
      * replace (Punto_x p) with (Punto_x c) by lra. replace (Punto_y p) with (Punto_y c) by lra.
        replace (Punto_z p) with (Punto_z c) by lra. ring.
  - set (d := distancia p c) in *. set (k := r / d).
    assert (K : k * d = r) by (unfold k; field; lra).
    exists (mk_Punto (Punto_x c + k * (Punto_x p - Punto_x c)) (Punto_y c + k * (Punto_y p - Punto_y c))
      (Punto_z c + k * (Punto_z p - Punto_z c))).
    rewrite !distancia_of_gap. split.
    + replace (sq _) with (r * r); [now apply sqrt_square |].
      rewrite <- K. replace (k * d * (k * d)) with (k * k * (d * d)) by ring. rewrite S.
      unfold gap, sq, dot. cbn. ring.
    + replace (sq _) with ((d - r) * (d - r)); [apply sqrt_Rsqr_abs |].
      rewrite <- K. replace ((d - k * d) * (d - k * d)) with ((1 - k) * (1 - k) * (d * d)) by ring. rewrite S.
      unfold gap, sq, dot. cbn. ring.
Qed.

Lemma power_of_sphere p c r : potencia_esfera p c r = distancia p c * distancia p c - r * r.
Proof. rewrite distancia_squared. unfold potencia_esfera, cuadrado, gap, sq, dot. reflexivity. Qed.

Lemma on_sphere w c r : 0 < r -> w ∈ puntos_esfera c r <-> distancia w c = r.
Proof.
  intros Hr. change (w ∈ puntos_esfera c r) with (potencia_esfera w c r = 0). rewrite power_of_sphere. pose proof (distancia_nonneg w c).
  split; intros H1; [apply Rsqr_inj; unfold Rsqr; lra | rewrite H1; ring].
Qed.

Lemma distance_of_sphere c r p : 0 < r -> a_distancia (puntos_esfera c r) p (Rabs (distancia p c - r)).
Proof.
  intros Hr. destruct (point_of_sphere c p r) as [w [Hc Hp]]; [lra |].
  exists w. split; [split | now symmetry].
  - now apply on_sphere.
  - intros otro Ho. apply on_sphere in Ho; [| exact Hr]. rewrite Hp. apply Rabs_le.
    pose proof (distancia_triangle p otro c). pose proof (distancia_triangle otro p c).
    rewrite (distancia_symmetric p otro) in *. lra.
Qed.

(** What is not negative and is a distance or its opposite, by the sign of a power. *)
Lemma signed d r a b : 0 < a -> 0 <= b -> d = Rabs (b - a) ->
  (b * b - a * a < 0 /\ r + d = 0) \/ (b * b - a * a >= 0 /\ r = d) <-> r = b - a.
Proof.
  intros Ha Hb ->. unfold Rabs. destruct (Rcase_abs (b - a)) as [H | H].
  - pose proof (Rmult_lt_0_compat (a - b) (a + b)). assert (b * b - a * a < 0) by lra. split; [intros [[_ E] | [N _]]; lra | intros ->; left; lra].
  - pose proof (Rmult_le_pos (b - a) (b + a)). assert (b * b - a * a >= 0) by lra. split; [intros [[N _] | [_ E]]; lra | intros ->; right; lra].
Qed.

Section Scene.
Variable Elemento : Type.
Implicit Types (s : Escena Elemento) (e : Elemento) (p : Punto).

(** Discharges con_signo.def.1, con_signo.conj.1. *)
Theorem a_sphere_is_as_far_as_its_centre_less_the_radius : con_signo_conj_1 Elemento.
Proof.
  intros s e p r ok He [t [Ht ->]].
  pose proof (element_cases _ _ ok _ He) as Cases.
  assert (S : exists c k, is_esfera _ s e c k).
  { unfold is_esfera, is_cilindro, is_cono, is_tronco, is_plano, is_disco, is_triangulo in *.
    decompose [ex and or] Cases; try (match goal with K : (_, _) ∈ de_que_tipo _ |- _ =>
      discriminate (type_unique _ _ ok _ _ _ Ht K) end). eauto. }
  destruct S as [c [k S]]. pose proof S as [_ [Hc Hk]].
  destruct (esfera_of_scene _ _ ok e c k S) as [Points [Power _]].
  assert (K : 0 < k) by (pose proof (Escena_decl_mi_radio ok) as D; destruct D as [_ [_ D]]; apply D; now exists e).
  assert (Same : forall d, a_distancia (puntos_de_elemento s e) p d <-> a_distancia (puntos_esfera c k) p d).
  { intros d. split; intros [w [[Hw Hn] E]]; exists w; (split; [split |]); try exact E; try (now apply Points);
      intros otro Ho; apply Hn; now apply Points. }
  pose proof (distance_of_sphere c k p K) as D. rewrite <- Same in D.
  pose proof (signed _ r k (distancia p c) K (distancia_nonneg p c) eq_refl) as G. rewrite <- power_of_sphere in G.
  split.
  - intros [_ [_ [d [Hd H]]]]. exists c, k. split; [exact Hc | split; [exact Hk |]]. apply G.
    rewrite (a_set_has_one_distance _ _ _ _ D Hd).
    destruct H as [[[v [Hv N]] E] | [[v [Hv N]] E]]; apply Power in Hv; subst v; auto.
  - intros [c' [k' [Hc' [Hk' E]]]].
    rewrite (centro_unique _ _ ok _ _ _ Hc' Hc), (radio_unique _ _ ok _ _ _ Hk' Hk) in E. apply G in E.
    split; [exact He | split; [now exists soy_esfera |]]. exists (Rabs (distancia p c - k)). split; [exact D |].
    destruct E as [[N E] | [N E]]; [left | right]; (split; [| exact E]); exists (potencia_esfera p c k);
      (split; [now apply Power | exact N]).
Qed.

(** Discharges mas_cercano.def.1, mas_cercano.conj.1, antes.def.1. *)
Theorem a_scene_is_as_far_as_its_nearest_element : mas_cercano_conj_1 Elemento.
Proof.
  intros s p w d r en e _ [[Hw Hn] [-> [_ Hen]]] He Hr. split; [| split].
  - destruct Hr as [v [[Hv _] ->]]. apply Hn. exists e. now split.
  - intros Ha. apply Hen in Ha as [_ Ha]. exact (a_set_has_one_distance _ _ _ _ Hr Ha).
  - intros ->. apply Hen. now split.
Qed.
End Scene.

(** There are such distances: that of the sphere of radius one about the origin and a point at three times its radius. *)
Theorem a_sphere_has_a_distance :
  a_distancia (puntos_esfera (mk_Punto 0 0 0) 1) (mk_Punto 3 0 0) 2.
Proof.
  pose proof (distance_of_sphere (mk_Punto 0 0 0) 1 (mk_Punto 3 0 0) Rlt_0_1) as H.
  replace (Rabs _) with 2 in H; [exact H |].
  rewrite distancia_of_gap. unfold gap, sq, dot. cbn. replace (_ + _ + _) with (3 * 3) by ring.
  rewrite sqrt_square by lra. rewrite Rabs_right; lra.
Qed.
