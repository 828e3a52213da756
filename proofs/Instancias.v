(** spec/instancias.tex: affine maps, the copies that they make of sets of points, and instances of elements.

    point_at ray t == as in Puntos.v
    det m          == how much larger the map makes volumes
    put m u        == where the map puts a point; led m u, what it makes of a direction *)
From Coq Require Import Reals Lra.
From Durero Require Import Toolkit Especificacion Tipos Escena Puntos Interseccion Proyeccion.
Local Open Scope R_scope.
Local Open Scope zed_scope.

Definition det (m : Mapa) : R := mixto (Mapa_x m) (Mapa_y m) (Mapa_z m).

Definition led (m : Mapa) (u : Vector) : Vector :=
  mk_Vector (Vector_x u * Vector_x (Mapa_x m) + Vector_y u * Vector_x (Mapa_y m) + Vector_z u * Vector_x (Mapa_z m))
    (Vector_x u * Vector_y (Mapa_x m) + Vector_y u * Vector_y (Mapa_y m) + Vector_z u * Vector_y (Mapa_z m))
    (Vector_x u * Vector_z (Mapa_x m) + Vector_y u * Vector_z (Mapa_y m) + Vector_z u * Vector_z (Mapa_z m)).

Definition put (m : Mapa) (u : Punto) : Punto :=
  let l := led m (mk_Vector (Punto_x u) (Punto_y u) (Punto_z u)) in
  mk_Punto (Punto_x (Mapa_centro m) + Vector_x l) (Punto_y (Mapa_centro m) + Vector_y l)
    (Punto_z (Mapa_centro m) + Vector_z l).

Lemma puesto_put m u w : puesto m u w <-> w = put m u.
Proof.
  unfold puesto, put, led. destruct w as [x y z]; cbn. split.
  - intros [-> [-> ->]]. f_equal; ring.
  - intros E. injection E as -> -> ->. repeat split; ring.
Qed.

Lemma dirigido_led m u w : dirigido m u w <-> w = led m u.
Proof.
  unfold dirigido, led. destruct w as [x y z]; cbn. split.
  - intros [-> [-> ->]]. reflexivity.
  - intros E. injection E as -> -> ->. repeat split.
Qed.

Lemma det_not_0 m : m ∈ Mapa_ok -> det m <> 0.
Proof. intros [H]. exact H. Qed.

(** ** The point that is put at a point *)

(** Discharges mixto.def.1, Mapa.inv.1, puesto.def.1, visto.def.1, visto.conj.1. *)
Theorem what_is_put_at_a_point_is_found_by_cramers_rule : visto_conj_1.
Proof.
  intros [[cx cy cz] [ax ay az] [bx by_ bz] [dx dy dz]] [wx wy wz] [ux uy uz] ok. apply det_not_0 in ok.
  unfold det, puesto, visto, mixto in *; cbn in *. split.
  - intros [-> [-> ->]].
    exists (mk_Vector (ux * ax + uy * bx + uz * dx) (ux * ay + uy * by_ + uz * dy) (ux * az + uy * bz + uz * dz)).
    cbn. repeat split; ring.
  - intros [[qx qy qz] [Qx [Qy [Qz [Ux [Uy Uz]]]]]]; cbn in *.
    assert (E : forall D c w i j k : R, D <> 0 ->
      D * w = D * c + D * ux * i + D * uy * j + D * uz * k -> w = c + ux * i + uy * j + uz * k).
    { intros D c w i j k HD H. apply Rmult_eq_reg_l with D; [rewrite H; ring | exact HD]. }
    repeat split; (eapply E; [exact ok |]); rewrite Ux, Uy, Uz; subst qx qy qz; ring.
Qed.

(** Every direction is made of one. *)
Lemma led_onto m w : m ∈ Mapa_ok -> exists u, w = led m u.
Proof.
  intros ok. apply det_not_0 in ok. set (D := det m) in *.
  exists (mk_Vector (mixto w (Mapa_y m) (Mapa_z m) / D) (mixto (Mapa_x m) w (Mapa_z m) / D)
    (mixto (Mapa_x m) (Mapa_y m) w / D)).
  destruct m as [c [ax ay az] [bx by_ bz] [dx dy dz]], w as [x y z].
  unfold led, D, det, mixto in *; cbn in *. f_equal; field; exact ok.
Qed.

Lemma put_onto m w : m ∈ Mapa_ok -> exists u, w = put m u.
Proof.
  intros ok. set (c := Mapa_centro m).
  destruct (led_onto m (mk_Vector (Punto_x w - Punto_x c) (Punto_y w - Punto_y c) (Punto_z w - Punto_z c)) ok)
    as [[x y z] E].
  exists (mk_Punto x y z). unfold put. cbn [Punto_x Punto_y Punto_z]. rewrite <- E. cbn. fold c.
  destruct w; cbn. f_equal; ring.
Qed.

Lemma put_injective m u v : m ∈ Mapa_ok -> put m u = put m v -> u = v.
Proof.
  intros ok E. set (w := put m u) in *.
  assert (U : visto m w u) by (apply what_is_put_at_a_point_is_found_by_cramers_rule; [exact ok | now apply puesto_put]).
  assert (V : visto m w v) by (apply what_is_put_at_a_point_is_found_by_cramers_rule; [exact ok | now apply puesto_put]).
  apply det_not_0 in ok. unfold det in ok.
  destruct U as [q [Qx [Qy [Qz [Ux [Uy Uz]]]]]], V as [r [Rx [Ry [Rz [Vx [Vy Vz]]]]]].
  assert (q = r) as -> by (destruct q, r; cbn in *; f_equal; congruence).
  destruct u, v; cbn in *. f_equal; eapply Rmult_eq_reg_l; try exact ok; congruence.
Qed.

(** ** Copies *)

(** Discharges copia.def.1, copia.conj.1. *)
Theorem a_copy_has_the_points_whose_originals_are_in_the_set : copia_conj_1.
Proof.
  intros m ps u w ok H. apply puesto_put in H. subst w. split.
  - intros [v [Hv E]]. apply puesto_put, put_injective in E; [now subst | exact ok].
  - intros Hu. exists u. split; [exact Hu | now apply puesto_put].
Qed.

(** Discharges copia.conj.3. *)
Theorem the_copy_of_a_union_is_the_union_of_the_copies : copia_conj_3.
Proof.
  intros m ps qs _ w. split.
  - intros [u [[H | H] E]]; [left | right]; now exists u.
  - intros [[u [H E]] | [u [H E]]]; exists u; (split; [| exact E]); [now left | now right].
Qed.

(** ** Rays *)

(** Discharges dirigido.def.1, movido.def.1, movido.conj.1. *)
Theorem every_ray_is_the_copy_of_one : movido_conj_1.
Proof.
  intros m [p v] ok [Hv]. cbn in Hv. destruct (put_onto m p ok) as [o Eo], (led_onto m v ok) as [d Ed].
  exists (mk_Rayo o d). split.
  - split. cbn. intros [Z1 [Z2 Z3]]. apply Hv. rewrite Ed. unfold led. cbn. rewrite Z1, Z2, Z3. repeat split; ring.
  - split; cbn; [now apply puesto_put | now apply dirigido_led].
Qed.

Lemma put_along m rayo otro t : movido m rayo otro -> point_at rayo t = put m (point_at otro t).
Proof.
  intros [P V]. apply puesto_put in P. apply dirigido_led in V. destruct rayo as [p v]. cbn in P, V. subst p v.
  unfold point_at, put, led; cbn. f_equal; ring.
Qed.

(** Discharges movido.conj.2. *)
Theorem a_map_keeps_the_parameter : movido_conj_2.
Proof.
  intros m rayo otro u w t _ _ _ M Ux Uy Uz Wx Wy Wz. apply puesto_put.
  replace w with (point_at rayo t) by (unfold point_at; destruct w; cbn in *; now subst).
  replace u with (point_at otro t) by (unfold point_at; destruct u; cbn in *; now subst).
  now apply put_along.
Qed.

Lemma put_on_ray m rayo otro u : m ∈ Mapa_ok -> movido m rayo otro ->
  put m u ∈ puntos_de_rayo rayo <-> u ∈ puntos_de_rayo otro.
Proof.
  intros ok M. rewrite !puntos_de_rayo_parameter. split; intros [t [Ht E]]; exists t; (split; [exact Ht |]).
  - apply (put_injective m _ _ ok). rewrite E. now apply put_along.
  - rewrite E. symmetry. now apply put_along.
Qed.

(** What is nearer along a ray is nearer along its copy. *)
Lemma nearer_is_nearer m rayo otro u v : m ∈ Mapa_ok -> rayo ∈ Rayo_ok -> otro ∈ Rayo_ok -> movido m rayo otro ->
  u ∈ puntos_de_rayo otro -> v ∈ puntos_de_rayo otro ->
  distancia (put m u) (Rayo_p rayo) <= distancia (put m v) (Rayo_p rayo) <->
  distancia u (Rayo_p otro) <= distancia v (Rayo_p otro).
Proof.
  intros ok okr oko M Hu Hv. apply puntos_de_rayo_parameter in Hu as [s [Hs ->]].
  apply puntos_de_rayo_parameter in Hv as [t [Ht ->]]. rewrite <- !(put_along m rayo otro) by exact M.
  pose proof (nearer_comes_before rayo t s okr Ht Hs) as A. pose proof (nearer_comes_before otro t s oko Ht Hs) as B.
  split; intros H; apply Rnot_lt_le; intros L; [apply B, A in L | apply A, B in L]; lra.
Qed.

(** Discharges copia.conj.2. *)
Theorem the_nearest_of_the_copy_is_where_the_nearest_is_put : copia_conj_2.
Proof.
  intros m ps rayo otro u w ok okr oko M E. apply puesto_put in E. subst w.
  assert (In : forall v, put m v ∈ interseccion (copia m ps) (puntos_de_rayo rayo) <->
    v ∈ interseccion ps (puntos_de_rayo otro)).
  { intros v. unfold interseccion, inter. rewrite (put_on_ray m rayo otro v ok M).
    rewrite (a_copy_has_the_points_whose_originals_are_in_the_set m ps v (put m v) ok) by now apply puesto_put.
    reflexivity. }
  assert (Ray : forall v, v ∈ interseccion ps (puntos_de_rayo otro) -> v ∈ puntos_de_rayo otro) by (intros v [_ H]; exact H).
  unfold cercanos. rewrite In. split; intros [Hu H]; (split; [exact Hu |]).
  - intros v Hv. apply (nearer_is_nearer m rayo otro); auto. apply H. now apply In.
  - intros x Hx. destruct (put_onto m x ok) as [v ->]. apply In in Hx. apply (nearer_is_nearer m rayo otro); auto.
Qed.

(** ** One map after another *)

Lemma put_twice m n k u : compuesto m n k -> put k u = put m (put n u).
Proof.
  intros [C [X [Y Z]]]. apply puesto_put in C. apply dirigido_led in X, Y, Z.
  destruct k as [c x y z]. cbn in *. subst c x y z. unfold put, led; cbn. f_equal; ring.
Qed.

(** Discharges compuesto.def.1, compuesto.conj.1. *)
Theorem a_copy_of_a_copy_is_one_copy : compuesto_conj_1.
Proof.
  intros m n k ps _ _ _ C w. split.
  - intros [u [Hu E]]. apply puesto_put in E. exists (put n u). split.
    + exists u. split; [exact Hu | now apply puesto_put].
    + apply puesto_put. now rewrite E, (put_twice m n k).
  - intros [v [[u [Hu Ev]] Ew]]. apply puesto_put in Ev, Ew. exists u. split; [exact Hu |].
    apply puesto_put. now rewrite Ew, Ev, (put_twice m n k).
Qed.

(** Discharges compuesto.conj.2. *)
Theorem two_maps_make_one : compuesto_conj_2.
Proof.
  intros m n okm okn.
  set (k := mk_Mapa (put m (Mapa_centro n)) (led m (Mapa_x n)) (led m (Mapa_y n)) (led m (Mapa_z n))).
  assert (D : det k = det m * det n).
  { unfold k, det, mixto, led; destruct m as [c [ax ay az] [bx by_ bz] [dx dy dz]], n as [c' [a1 a2 a3] [b1 b2 b3] [d1 d2 d3]];
      cbn. ring. }
  exists k. split; [| split; [| exact D]].
  - split. fold (det k). rewrite D. apply det_not_0 in okm, okn. now apply Rmult_integral_contrapositive_currified.
  - repeat split; apply puesto_put || apply dirigido_led; reflexivity.
Qed.

(** Discharges identidad.def.1, identidad.conj.1. *)
Theorem the_identity_makes_no_other_set : identidad_conj_1.
Proof.
  intros m ps ok [_ I]. decompose [and] I.
  assert (P : forall u, put m u = u).
  { intros [x y z]. unfold put, led; cbn. f_equal; repeat match goal with H : _ = _ :> R |- _ => rewrite H end; ring. }
  intros w. split.
  - intros [u [Hu E]]. apply puesto_put in E. now rewrite E, P.
  - intros Hw. exists w. split; [exact Hw |]. apply puesto_put. now rewrite P.
Qed.

(** ** The surfaces of one *)

(** A copy is the set of the points whose originals, by their coordinates, lie in the set. *)
Lemma copia_seteq m ps qs : m ∈ Mapa_ok -> (forall u, u ∈ ps <-> put m u ∈ qs) -> copia m ps ≡ qs.
Proof.
  intros ok H w. split.
  - intros [u [Hu E]]. apply puesto_put in E. subst w. now apply H.
  - intros Hw. destruct (put_onto m w ok) as [u ->]. exists u. split; [now apply H | now apply puesto_put].
Qed.

Lemma put_estirado m r h u : estirado m r h ->
  put m u = mk_Punto (Punto_x (Mapa_centro m) + r * Punto_x u) (Punto_y (Mapa_centro m) + r * Punto_y u)
    (Punto_z (Mapa_centro m) + h * Punto_z u).
Proof.
  intros E. unfold estirado in E. decompose [and] E. unfold put, led; cbn.
  f_equal; repeat match goal with H : _ = _ :> R |- _ => rewrite H end; ring.
Qed.

(** A factor that is not 0 changes no zero. *)
Lemma zero_times k a b : k <> 0 -> b = k * a -> a = 0 <-> b = 0.
Proof.
  intros Hk ->. split; [intros ->; ring |]. intros H. apply Rmult_integral in H as [H | H]; [contradiction | exact H].
Qed.

Lemma within_stretch h z : 0 < h -> 0 <= z <= 1 <-> 0 <= h * z <= h.
Proof.
  intros Hh. split; intros [H0 H1].
  - split; [apply Rmult_le_pos; lra |]. rewrite <- (Rmult_1_r h) at 2. apply Rmult_le_compat_l; lra.
  - split; apply Rmult_le_reg_l with h; lra.
Qed.

(** Discharges estirado.def.1, estirado.conj.1. *)
Theorem every_sphere_is_a_copy_of_that_of_one : estirado_conj_1.
Proof.
  intros m o r ok Hr E Ox Oy Oz. apply copia_seteq; [exact ok |]. intros u. unfold Rmas in Hr.
  unfold puntos_esfera. apply zero_times with (r * r); [intros Z; apply Rmult_integral in Z as [Z | Z]; lra |].
  rewrite (put_estirado m r r u E). unfold potencia_esfera, cuadrado; cbn. rewrite Ox, Oy, Oz. ring.
Qed.

(** Discharges estirado.conj.2. *)
Theorem every_upright_cylinder_is_a_copy_of_that_of_one : estirado_conj_2.
Proof.
  intros m o [dx dy dz] r h ok _ Hr Hh E Ox Oy Oz. cbn. intros -> -> ->. apply copia_seteq; [exact ok |]. intros u.
  unfold Rmas in Hr, Hh. rewrite (put_estirado m r h u E). unfold puntos_cilindro.
  assert (P : potencia_cilindro u o 1 (mk_Vector 0 0 1) = 0 <->
    potencia_cilindro (put m u) (Mapa_centro m) r (mk_Vector 0 0 1) = 0).
  { apply zero_times with (r * r); [intros Z; apply Rmult_integral in Z as [Z | Z]; lra |].
    rewrite (put_estirado m r h u E). unfold potencia_cilindro, alejamiento, avance, cuadrado; cbn.
    rewrite Ox, Oy, Oz. ring. }
  rewrite (put_estirado m r h u E) in P. rewrite P. pose proof (within_stretch h (Punto_z u) Hh) as W.
  unfold avance in *; cbn in *. rewrite Ox, Oy, Oz.
  replace (_ + _ + (Punto_z u - 0) * 1) with (Punto_z u) by ring.
  replace (_ + _ + (_ + h * Punto_z u - _) * 1) with (h * Punto_z u) by ring. now rewrite W.
Qed.

(** Discharges estirado.conj.3. *)
Theorem every_upright_cone_is_a_copy_of_that_of_one : estirado_conj_3.
Proof.
  intros m o [dx dy dz] r h k ok _ Hr Hh Hk E Ox Oy Oz. cbn. intros -> -> -> K. apply copia_seteq; [exact ok |]. intros u.
  unfold Rmas in Hr, Hh, Hk. rewrite (put_estirado m r h u E). unfold puntos_cono.
  assert (P : potencia_cono u o 1 (mk_Vector 0 0 1) 1 = 0 <->
    potencia_cono (put m u) (Mapa_centro m) k (mk_Vector 0 0 1) h = 0).
  { apply zero_times with (r * r); [intros Z; apply Rmult_integral in Z as [Z | Z]; lra |].
    rewrite (put_estirado m r h u E). unfold potencia_cono, alejamiento, avance, cuadrado; cbn.
    rewrite Ox, Oy, Oz, <- K. ring. }
  rewrite (put_estirado m r h u E) in P. rewrite P. pose proof (within_stretch h (Punto_z u) Hh) as W.
  unfold avance in *; cbn in *. rewrite Ox, Oy, Oz.
  replace (_ + _ + (Punto_z u - 0) * 1) with (Punto_z u) by ring.
  replace (_ + _ + (_ + h * Punto_z u - _) * 1) with (h * Punto_z u) by ring. now rewrite W.
Qed.

(** ** Instances *)

Section Scene.
Variable Elemento : Type.

(** Discharges puntos_de_instancia.def.1, instancia_desde.def.1, instancia_desde.conj.1. *)
Theorem an_instance_is_asked_by_the_original_and_the_moved_ray : instancia_desde_conj_1 Elemento.
Proof.
  intros s m e rayo otro u w _ ok okr oko He M E. pose proof E as Ew. apply puesto_put in Ew. subst w.
  pose proof (put_on_ray m rayo otro u ok M) as Ray. pose proof (proj1 M) as Origin. split; split.
  - intros [Hr [_ [o [v [Po [Pv Hv]]]]]]. split; [exact He |]. split; [now apply Ray |]. left. split; [reflexivity |].
    apply puesto_put in Po, Pv, Origin. rewrite Origin in Po. apply put_injective in Po, Pv; try exact ok. now subst.
  - intros [_ [Hr [[_ Hu] | [Hne _]]]]; [| exfalso; apply Hne; reflexivity]. split; [now apply Ray |]. split; [exact He |].
    exists (Rayo_p otro), u. exact (conj Origin (conj E Hu)).
  - intros [Hr [_ Hw]]. split; [exact He |]. split; [now apply Ray |]. right. split; [now intros [] |].
    now apply (a_copy_has_the_points_whose_originals_are_in_the_set m _ u (put m u) ok E).
  - intros [_ [Hr [[[] _] | [_ Hu]]]]. split; [now apply Ray |]. split; [exact He |].
    now apply (a_copy_has_the_points_whose_originals_are_in_the_set m _ u (put m u) ok E).
Qed.
End Scene.

(** All of them. *)
Theorem the_conjectures_hold (Elemento : Type) :
  visto_conj_1 /\ copia_conj_1 /\ movido_conj_1 /\ movido_conj_2 /\ copia_conj_2 /\ copia_conj_3 /\ compuesto_conj_1
  /\ compuesto_conj_2 /\ identidad_conj_1 /\ estirado_conj_1 /\ estirado_conj_2 /\ estirado_conj_3
  /\ instancia_desde_conj_1 Elemento.
Proof.
  exact (conj what_is_put_at_a_point_is_found_by_cramers_rule (conj
    a_copy_has_the_points_whose_originals_are_in_the_set (conj
    every_ray_is_the_copy_of_one (conj
    a_map_keeps_the_parameter (conj
    the_nearest_of_the_copy_is_where_the_nearest_is_put (conj
    the_copy_of_a_union_is_the_union_of_the_copies (conj
    a_copy_of_a_copy_is_one_copy (conj
    two_maps_make_one (conj
    the_identity_makes_no_other_set (conj
    every_sphere_is_a_copy_of_that_of_one (conj
    every_upright_cylinder_is_a_copy_of_that_of_one (conj
    every_upright_cone_is_a_copy_of_that_of_one
    (an_instance_is_asked_by_the_original_and_the_moved_ray Elemento))))))))))))).
Qed.

(** There are such maps: one that leans and mirrors, and a ray with the ray that it is the copy of. *)
Definition leaning : Mapa := mk_Mapa (mk_Punto 1 2 3) (mk_Vector 1 1 0) (mk_Vector 0 (-2) 0) (mk_Vector 0 0 5).

Theorem a_map_may_mirror : leaning ∈ Mapa_ok /\ det leaning < 0.
Proof.
  assert (D : det leaning = -10) by (unfold det, mixto, leaning; cbn; ring).
  split; [split; fold (det leaning); rewrite D; intros E; lra | lra].
Qed.

Theorem a_ray_is_the_copy_of_a_ray :
  movido leaning (mk_Rayo (mk_Punto 1 2 3) (mk_Vector 1 1 5)) (mk_Rayo (mk_Punto 0 0 0) (mk_Vector 1 0 1)).
Proof. unfold movido, puesto, dirigido, leaning; cbn. repeat split; lra. Qed.
