(** spec/proyeccion.tex: shadows as sets of points, projections, the test of a depth map, and what is drawn over what.

    point_at ray t, is_triangulo s e abc == as in Puntos.v and Escena.v *)
From Coq Require Import Reals Lra Classical_Prop.
From Durero Require Import Toolkit Especificacion Tipos Escena Puntos Interseccion.
Local Open Scope R_scope.
Local Open Scope zed_scope.

(** ** Shadows *)

(** The ray from one point to another, and what stands between the two. *)
Definition towards (x y : Punto) : Rayo :=
  mk_Rayo x (mk_Vector (Punto_x y - Punto_x x) (Punto_y y - Punto_y x) (Punto_z y - Punto_z x)).

Lemma entre_is_before_the_end x y q : entre x y q <-> exists t, 0 < t < 1 /\ q = point_at (towards x y) t.
Proof.
  split.
  - intros [t [Ht [H1 [Hx [Hy Hz]]]]]. exists t. unfold Rmas in Ht. split; [lra |]. destruct q; cbn in *. now subst.
  - intros [t [Ht ->]]. exists t. unfold Rmas. repeat split; lra.
Qed.

(** The power of a triangle grows evenly along a ray. *)
Lemma potencia_triangulo_towards p q abc t :
  potencia_triangulo (point_at (towards p q) t) abc = (1 - t) * potencia_triangulo p abc + t * potencia_triangulo q abc.
Proof. unfold potencia_triangulo, point_at, towards; cbn. ring. Qed.

Section Scene.
Variable Elemento : Type.
Notation Escena := (Especificacion.Escena Elemento).

Lemma triangle_of_the_scene (s : Escena) e : Escena_ok s -> e ∈ dom (mi_vertices s) -> exists abc, is_triangulo _ s e abc.
Proof.
  intros ok Hv. destruct (type_of_element _ _ ok e (element_of_vertices _ _ ok e Hv)) as [t Ht].
  pose proof (proj1 (has_vertices _ _ ok e t Ht) Hv) as Et. destruct Hv as [abc Habc]. exists abc.
  unfold vertices_types, single in Et. subst t. split; assumption.
Qed.

(** A segment from a triangle to a point off its plane is occluded where another element stands between. *)
Lemma occluded_between (s : Escena) e abc p q : Escena_ok s -> is_triangulo _ s e abc -> puntos_de_elemento s e p ->
  potencia_triangulo q abc <> 0 ->
  occluded_segment s (towards p q) ⦃e⦄ <-> exists o, o ∈ elementos s /\ o <> e /\ p ∈ sombra q (puntos_de_elemento s o).
Proof.
  intros ok He Hp Hq. destruct (triangulo_of_scene _ s ok e abc He) as [Points [Power _]].
  assert (P0 : potencia_triangulo p abc = 0) by (apply Points in Hp; apply Hp).
  split.
  - intros [t [w [Ht [[o [Ho [_ [_ Hw]]]] [H1 [Hx [Hy Hz]]]]]]].
    assert (E : w = point_at (towards p q) t) by (destruct w; unfold point_at; cbn in *; now subst).
    destruct Hw as [[Hoe Hw] | [Hoe Hw]].
    + unfold single in Hoe. subst o. exfalso. destruct Hw as [_ [_ [a [b [Ha [Hb Hab]]]]]].
      apply Power in Ha. apply Power in Hb. cbn in Hb. rewrite E, potencia_triangulo_towards, P0 in Ha.
      assert (Z : t * potencia_triangulo q abc = 0) by lra.
      apply Rmult_integral in Z as [Z | Z]; [unfold Rmas in Ht; lra | contradiction].
    + exists o. repeat split; [exact Ho | exact Hoe |]. exists w. split; [exact Hw |].
      apply entre_is_before_the_end. exists t. split; [unfold Rmas in Ht; lra | exact E].
  - intros [o [Ho [Hoe [w [Hw B]]]]]. apply entre_is_before_the_end in B as [t [Ht ->]].
    exists t, (point_at (towards p q) t). split; [unfold Rmas; lra |]. split; [| repeat split; lra].
    exists o. split; [exact Ho |]. split; [exact Ho |]. split; [| now right].
    apply puntos_de_rayo_parameter. exists t. split; [lra | reflexivity].
Qed.

(** Discharges entre.def.1, sombra.def.1, iluminada.def.1, iluminada.conj.1. *)
Theorem clipping_by_shadows_is_sending_rays : iluminada_conj_1 Elemento.
Proof.
  intros s e p q ok Hv Hp [w [Hw Hne]]. destruct (triangle_of_the_scene s e ok Hv) as [abc He].
  destruct (triangulo_of_scene _ s ok e abc He) as [Points [Power _]]. apply Power in Hw. subst w.
  assert (P0 : potencia_triangulo p abc = 0) by (apply Points in Hp; apply Hp).
  pose proof (occluded_between s e abc p q ok He Hp Hne) as Occluded. split.
  - intros [[p' [vx vy vz]] [_ [Ep [Ex [Ey [Ez Hno]]]]]]. cbn in *. subst p' vx vy vz.
    change (~ occluded_segment s (towards p q) ⦃e⦄) in Hno. split; [exact Hp |].
    intros qs [o [Ho [Hoe Eq]]] [x [Hx B]]. apply Hno, Occluded. exists o. repeat split; [exact Ho | exact Hoe |].
    exists x. split; [now apply Eq | exact B].
  - intros [_ Lit]. exists (towards p q). split; [| do 4 (split; [reflexivity |])].
    + split. cbn. intros [Hx [Hy Hz]]. apply Hne. rewrite <- P0. f_equal. destruct p, q; cbn in *. f_equal; lra.
    + intros H. apply Occluded in H as [o [Ho [Hoe Hs]]]. apply (Lit (puntos_de_elemento s o)); [| exact Hs].
      exists o. split; [exact Ho |]. split; [exact Hoe | reflexivity].
Qed.
End Scene.

(** ** Projections *)

(** Discharges proyectado.def.1, proyectado.conj.1. *)
Theorem a_parallel_shadow_is_larger_by_the_heights : proyectado_conj_1.
Proof.
  intros y a b u v c n h d Hn [Hu [s [_ [Ux [Uy Uz]]]]] [Hv [t [_ [Vx [Vy Vz]]]]] Eh Ea Eb.
  unfold puntos_plano, potencia_plano, avance in Hu, Hv. unfold avance in Eh, Ea, Eb.
  rewrite Ux, Uy, Uz in Hu. rewrite Vx, Vy, Vz in Hv.
  assert (S : s * (h - d) = h).
  { rewrite Ea at 1. rewrite Eh. lra. }
  assert (T : t * (h - d) = h).
  { rewrite Eb at 1. rewrite Eh. lra. }
  rewrite Ux, Uy, Uz, Vx, Vy, Vz.
  assert (E : forall o i j, (h - d) * (o + t * (j - o) - (o + s * (i - o))) = h * (j - i)).
  { intros o i j. replace ((h - d) * (o + t * (j - o) - (o + s * (i - o)))) with
      (t * (h - d) * (j - o) - s * (h - d) * (i - o)) by ring. rewrite S, T. ring. }
  repeat split; apply E.
Qed.

(** ** The depth map *)

Lemma distancia_along ray t : 0 <= t -> distancia (point_at ray t) (Rayo_p ray) = t * sqrt (sq (Rayo_v ray)).
Proof.
  intros Ht. unfold distancia, raizcuadrada, cuadrado. cbn.
  replace (_ + _) with (t * t * sq (Rayo_v ray)) by (unfold sq, dot; ring).
  rewrite sqrt_mult, sqrt_square by (try apply Rle_0_sqr; try apply sq_nonneg; exact Ht). reflexivity.
Qed.

(** On a ray, what is nearer to its start comes before. *)
Lemma nearer_comes_before ray t t' : Rayo_ok ray -> 0 < t -> 0 < t' ->
  distancia (point_at ray t) (Rayo_p ray) < distancia (point_at ray t') (Rayo_p ray) <-> t < t'.
Proof.
  intros ok Ht Ht'. rewrite !distancia_along by lra.
  pose proof (sqrt_lt_R0 _ (ray_direction_positive ray ok)) as P. split; intros H.
  - now apply Rmult_lt_reg_r in H.
  - now apply Rmult_lt_compat_r.
Qed.

(** Of two points of a ray the former stands between the latter and the start. *)
Lemma between_start_and_point ray t t' : Rayo_ok ray -> 0 < t -> 0 < t' ->
  entre (point_at ray t') (Rayo_p ray) (point_at ray t) <-> t < t'.
Proof.
  intros ok Ht Ht'. rewrite entre_is_before_the_end. split.
  - intros [k [Hk E]].
    assert (E' : point_at ray t = point_at ray ((1 - k) * t')).
    { rewrite E. unfold point_at, towards; cbn. f_equal; ring. }
    apply point_at_injective in E'; [| exact ok]. subst t.
    assert (0 < k * t') by (apply Rmult_lt_0_compat; lra). lra.
  - intros H. exists (1 - t / t'). split.
    + assert (0 < t / t' < 1); [| lra]. split; [now apply Rdiv_lt_0_compat |].
      apply Rmult_lt_reg_r with t'; [exact Ht' |]. unfold Rdiv. rewrite Rmult_assoc, Rinv_l; lra.
    + unfold point_at, towards; cbn. f_equal; field; lra.
Qed.

(** Discharges profundidad.def.1, oscura.def.1, oscura.conj.1. *)
Theorem in_its_very_direction_a_depth_map_is_right : oscura_conj_1.
Proof.
  intros ray ps d q ok Hq Hr [w [[Hwr Hw] [-> Least]]].
  apply puntos_de_rayo_parameter in Hr as [t [Ht ->]]. apply puntos_de_rayo_parameter in Hwr as [k [Hk ->]].
  unfold oscura. split.
  - intros H. exists (point_at ray k). split; [exact Hw |]. apply between_start_and_point; try assumption; try lra.
    now apply nearer_comes_before in H.
  - intros [x [Hx B]].
    assert (Hxr : exists j, 0 < j /\ x = point_at ray j).
    { apply entre_is_before_the_end in B as [j [Hj ->]]. exists ((1 - j) * t).
      split; [apply Rmult_lt_0_compat; lra |].
      unfold point_at, towards; cbn. f_equal; ring. }
    destruct Hxr as [j [Hj ->]]. apply between_start_and_point in B; try assumption; try lra.
    eapply Rle_lt_trans; [apply (Least (point_at ray j)) | now apply nearer_comes_before].
    split; [apply puntos_de_rayo_parameter; now exists j | exact Hx].
Qed.

(** A plane one before the light, a pixel that looks straight at it, and a point of the plane one aside: nothing stands
    between, and the point is farther than the pixel's depth. Discharges oscura.conj.2. *)
Theorem asked_beside_it_finds_a_plane_to_shadow_itself : oscura_conj_2.
Proof.
  pose (ray := mk_Rayo (mk_Punto 0 0 0) (mk_Vector 0 0 1)).
  assert (ok : Rayo_ok ray) by (split; cbn; lra).
  exists ray, (fun w => Punto_z w = 1), 1, (mk_Punto 1 0 1).
  assert (At : forall w, puntos_de_rayo ray w -> Punto_z w = 1 -> w = point_at ray 1).
  { intros w Hw Hz. apply puntos_de_rayo_parameter in Hw as [t [_ ->]]. cbn in Hz. f_equal. lra. }
  assert (One : distancia (point_at ray 1) (Rayo_p ray) = 1).
  { rewrite distancia_along by lra. cbn. replace (sq _) with 1 by (unfold sq, dot; cbn; ring). rewrite sqrt_1. ring. }
  split; [exact ok |]. split; [reflexivity |]. split; [| split].
  - exists (point_at ray 1). split; [split; [apply puntos_de_rayo_parameter; exists 1; split; [lra | reflexivity] | cbn; ring] |].
    split; [now rewrite One |]. intros w [Hw Hz]. rewrite (At w Hw Hz), One. lra.
  - unfold oscura, distancia, raizcuadrada, cuadrado. cbn. rewrite <- sqrt_1 at 1. apply sqrt_lt_1_alt. lra.
  - intros [x [Hx B]]. apply entre_is_before_the_end in B as [t [Ht ->]]. cbn in Hx. lra.
Qed.

(** ** What is drawn over what *)

(** Discharges mezcla.def.1, mezcla.conj.1. *)
Theorem drawing_over_is_following_the_ray_straight_on : mezcla_conj_1.
Proof. intros m suma r t _ H. unfold radiancia, indirecta, mezcla. rewrite H. ring. Qed.

(** Discharges mezcla.conj.2. *)
Theorem without_own_colours_the_order_is_free : mezcla_conj_2.
Proof. intros m o I _ _. unfold mezcla. ring. Qed.

(** Discharges mezcla.conj.3. *)
Theorem with_own_colours_the_order_counts : mezcla_conj_3.
Proof.
  intros m o x y z _ _ Hm Ho Hx Hy Hz. unfold mezcla.
  set (a := Material_k_t m * Material_M_T m) in *. set (b := Material_k_t o * Material_M_T o) in *.
  replace a with (1 / 2) by lra. replace b with (1 / 4) by lra. replace x with (8 / 10) by lra.
  replace y with (2 / 10) by lra. replace z with (1 / 10) by lra. lra.
Qed.
