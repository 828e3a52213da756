(** Rays made wide: what spec/haces.tex claims of cones, beams and pencils.

    image a n p           == the mirror image of p in the plane through a across n
    dot v w, sq v         == the scalar product, and that of a vector with itself (Tipos.v); `producto` is the text's *)
From Coq Require Import Reals Lra.
From Durero Require Import Toolkit Especificacion Tipos Puntos.
Local Open Scope R_scope.
Local Open Scope zed_scope.

Ltac components := repeat match goal with v : Vector |- _ => destruct v as [? ? ?] end;
  repeat match goal with p : Punto |- _ => destruct p as [? ? ?] end;
  unfold producto, cuadrado, avance in *; cbn [Vector_x Vector_y Vector_z Punto_x Punto_y Punto_z] in *.

(** ** Cones *)

(** A ray whose direction is a positive multiple of another's has its points. *)
Lemma same_points (r r' : Rayo) k : 0 < k -> Rayo_p r = Rayo_p r' ->
  Vector_x (Rayo_v r) = k * Vector_x (Rayo_v r') -> Vector_y (Rayo_v r) = k * Vector_y (Rayo_v r') ->
  Vector_z (Rayo_v r) = k * Vector_z (Rayo_v r') -> puntos_de_rayo r ⊆ puntos_de_rayo r'.
Proof.
  intros Hk Hp Hx Hy Hz q [t [Ht [Qx [Qy Qz]]]]. unfold Rmas in *.
  exists (t * k). split; [unfold Rmas; now apply Rmult_lt_0_compat |].
  rewrite <- Hp, Qx, Qy, Qz, Hx, Hy, Hz. repeat split; ring.
Qed.

(** Discharges cono_de_rayos.def.1, cono_de_rayos.conj.1. *)
Theorem a_cone_of_no_angle_is_its_axis : cono_de_rayos_conj_1.
Proof.
  intros e r He Hr [Hp [Hpos Hc]]. apply ray_direction_positive in He, Hr. unfold cuadrado in Hc.
  change (producto (Rayo_v e) (Rayo_v r)) with (dot (Rayo_v e) (Rayo_v r)) in *.
  change (producto (Rayo_v e) (Rayo_v e)) with (sq (Rayo_v e)) in *.
  change (producto (Rayo_v r) (Rayo_v r)) with (sq (Rayo_v r)) in *.
  set (v := Rayo_v e) in *. set (w := Rayo_v r) in *. set (a := dot v w) in *.
  (* The vector a·v − (v·v)·w has the square (v·v)·((v·v)(w·w) − a²), which is not above zero. *)
  set (d := mk_Vector (a * Vector_x v - sq v * Vector_x w) (a * Vector_y v - sq v * Vector_y w)
                      (a * Vector_z v - sq v * Vector_z w)).
  assert (Hd : sq d = sq v * (sq v * sq w - a * a)).
  { unfold d, sq at 1, dot at 1. cbn [Vector_x Vector_y Vector_z].
    replace (sq w) with (dot w w) by reflexivity. unfold a, sq, dot. ring. }
  assert (Zero : sq d = 0).
  { apply Rle_antisym; [| apply sq_nonneg]. rewrite Hd.
    rewrite <- (Rmult_0_r (sq v)). apply Rmult_le_compat_l; lra. }
  apply sq_zero in Zero as [Zx [Zy Zz]]. unfold d in Zx, Zy, Zz. cbn in Zx, Zy, Zz.
  assert (Pa : 0 < a) by lra.
  assert (Scale : forall x y, a * x - sq v * y = 0 -> y = a / sq v * x /\ x = sq v / a * y).
  { intros x y E. assert (E' : a * x = sq v * y) by lra. split.
    - apply Rmult_eq_reg_l with (sq v); [| lra]. rewrite <- E'. field. lra.
    - apply Rmult_eq_reg_l with a; [| lra]. rewrite E'. field. lra. }
  apply Scale in Zx as [Wx Vx], Zy as [Wy Vy], Zz as [Wz Vz].
  intros q. split.
  - apply (same_points r e (a / sq v)); try assumption. now apply Rdiv_lt_0_compat.
  - apply (same_points e r (sq v / a)); try assumption; [now apply Rdiv_lt_0_compat | now symmetry].
Qed.

(** Discharges cono_de_rayos.conj.2. *)
Theorem a_wider_cone_holds_a_narrower : cono_de_rayos_conj_2.
Proof.
  intros e r c d He Hr _ _ [Hp [Hpos Hc]] Hle. split; [exact Hp | split; [exact Hpos |]].
  apply Rge_trans with (1 := Hc). apply Rle_ge. rewrite !Rmult_assoc. apply Rmult_le_compat_r; [| exact Hle].
  apply Rmult_le_pos; change (0 <= sq (Rayo_v e)) || change (0 <= sq (Rayo_v r)); apply sq_nonneg.
Qed.

(** What a cone covers, a wider one covers. Discharges cubierto.def.1. *)
Theorem a_wider_cone_covers_what_a_narrower_covers (Elemento : Type) (s : Escena Elemento) axis ray c d e :
  Rayo_ok axis -> Rayo_ok ray -> c ∈ Parte -> d ∈ Parte -> d <= c -> cubierto s axis ray c e -> cubierto s axis ray d e.
Proof.
  intros Ha Hr Hc Hd Hle [H [He Hne]]. split; [| now split].
  now apply (a_wider_cone_holds_a_narrower axis ray c d).
Qed.

(** ** Beams *)

Definition image (a : Punto) (n : Vector) (p : Punto) : Punto :=
  let k := 2 * avance p a n / producto n n in
  mk_Punto (Punto_x p - k * Vector_x n) (Punto_y p - k * Vector_y n) (Punto_z p - k * Vector_z n).

Lemma every_point_has_its_image a n p : producto n n > 0 -> imagen a n p (image a n p).
Proof. intros H. unfold imagen, image. cbn. repeat split; [exact H | field | field | field]; lra. Qed.

(** How far the image is before the mirror, where the point is behind it. *)
Lemma the_image_is_on_the_other_side a n p q : imagen a n p q -> avance q a n = - avance p a n.
Proof.
  intros [Hn [Hx [Hy Hz]]]. apply Rmult_eq_reg_l with (producto n n); [| lra].
  replace (producto n n * avance q a n) with
    (producto n n * (Punto_x q - Punto_x p) * Vector_x n + producto n n * (Punto_y q - Punto_y p) * Vector_y n
     + producto n n * (Punto_z q - Punto_z p) * Vector_z n + producto n n * avance p a n)
    by (components; ring).
  replace (producto n n * (Punto_x q - Punto_x p)) with (- (2 * avance p a n * Vector_x n)) by lra.
  replace (producto n n * (Punto_y q - Punto_y p)) with (- (2 * avance p a n * Vector_y n)) by lra.
  replace (producto n n * (Punto_z q - Punto_z p)) with (- (2 * avance p a n * Vector_z n)) by lra.
  clear Hx Hy Hz Hn. components. ring.
Qed.

(** Discharges imagen.def.1, imagen.conj.1. *)
Theorem an_image_of_an_image_is_what_there_was : imagen_conj_1.
Proof.
  intros a p q n H. pose proof (the_image_is_on_the_other_side _ _ _ _ H) as E. destruct H as [Hn [Hx [Hy Hz]]].
  unfold imagen. rewrite E. repeat split; lra.
Qed.

(** Discharges imagen.conj.2. *)
Theorem what_is_mirrored_comes_from_the_image : imagen_conj_2.
Proof.
  intros a o i q n v r [Hn [Hx [Hy Hz]]] Hq Vx Vy Vz Rx Ry Rz.
  assert (E : producto v n = avance o a n).
  { replace (avance o a n) with (avance o a n - avance q a n) by lra.
    unfold producto, avance. rewrite Vx, Vy, Vz. ring. }
  unfold reflexion. rewrite E, Rx, Ry, Rz, Vx, Vy, Vz. split; [exact Hn |].
  replace (Punto_x q - Punto_x i + (Punto_x o - Punto_x q)) with (- (Punto_x i - Punto_x o)) by ring.
  replace (Punto_y q - Punto_y i + (Punto_y o - Punto_y q)) with (- (Punto_y i - Punto_y o)) by ring.
  replace (Punto_z q - Punto_z i + (Punto_z o - Punto_z q)) with (- (Punto_z i - Punto_z o)) by ring.
  rewrite !Ropp_mult_distr_r_reverse. repeat split; lra.
Qed.

(** Discharges haz.def.1, haz.conj.1. *)
Theorem the_image_of_a_beam_is_the_beam_of_the_image : haz_conj_1.
Proof.
  intros a o i n base ray other _ _ [Hn _] [_ [q [Hb Hq]]] Hp Hall. split; [exact Hp |].
  exists (image a n q). pose proof (every_point_has_its_image a n q Hn) as H. split.
  - now exists q.
  - exact (Hall q (image a n q) Hq H).
Qed.

(** On which side of a plane through its origin a ray goes, all its points are. *)
Lemma a_side_is_of_the_whole_ray o n ray p q : Rayo_p ray = o -> p ∈ puntos_de_rayo ray -> q ∈ puntos_de_rayo ray ->
  avance p o n >= 0 -> avance q o n < 0 -> False.
Proof.
  intros Ho [t [Ht [Px [Py Pz]]]] [u [Hu [Qx [Qy Qz]]]]. unfold Rmas in *. subst o.
  set (s := producto (Rayo_v ray) n).
  replace (avance p (Rayo_p ray) n) with (t * s) by (unfold avance, s, producto; rewrite Px, Py, Pz; ring).
  replace (avance q (Rayo_p ray) n) with (u * s) by (unfold avance, s, producto; rewrite Qx, Qy, Qz; ring).
  intros A B. destruct (Rle_or_lt 0 s) as [Hs | Hs].
  - assert (0 <= u * s) by (apply Rmult_le_pos; lra). lra.
  - assert (t * s < 0) by (rewrite <- (Rmult_0_r t); apply Rmult_lt_compat_l; lra). lra.
Qed.

(** Discharges haz.conj.2. *)
Theorem a_plane_through_its_origin_divides_a_beam : haz_conj_2.
Proof.
  intros o n base ray _ [Hp [q [Hb Hq]]]. intros [Over Under].
  destruct (Rlt_le_dec (avance q o n) 0) as [H | H].
  - destruct Under as [_ [w [[_ Hw] Hin]]].
    + split; [exact Hp |]. exists q. repeat split; assumption.
    + exact (a_side_is_of_the_whole_ray o n ray w q Hp Hin Hq Hw H).
  - apply Rle_ge in H. destruct Over as [_ [w [[_ Hw] Hin]]].
    + split; [exact Hp |]. exists q. repeat split; assumption.
    + exact (a_side_is_of_the_whole_ray o n ray q w Hp Hq Hin H Hw).
Qed.

(** The direction of a ray, mirrored. *)
Definition mirrored (n v : Vector) : Vector :=
  let k := 2 * producto v n / producto n n in
  mk_Vector (Vector_x v - k * Vector_x n) (Vector_y v - k * Vector_y n) (Vector_z v - k * Vector_z n).

Lemma mirrored_keeps_length n v : producto n n > 0 -> sq (mirrored n v) = sq v.
Proof.
  intros H. set (k := 2 * producto v n / producto n n).
  replace (sq (mirrored n v)) with (sq v + k * (k * producto n n - 2 * producto v n))
    by (unfold mirrored, sq, dot; fold k; unfold producto; cbn; ring).
  unfold k. field. lra.
Qed.

Lemma the_mirrored_ray_is_one n ray i : producto n n > 0 -> Rayo_ok ray -> Rayo_ok (mk_Rayo i (mirrored n (Rayo_v ray))).
Proof.
  intros Hn Hr. apply ray_direction_positive in Hr. rewrite <- (mirrored_keeps_length n _ Hn) in Hr.
  split. intros [Hx [Hy Hz]]. cbn [Rayo_v] in *. unfold sq, dot in Hr. rewrite Hx, Hy, Hz in Hr. lra.
Qed.

Lemma image_component N i o p q v t a s n : N > 0 -> N * (i - o) + 2 * a * n = 0 -> p = o + t * v ->
  N * (q - p) + 2 * (a + t * s) * n = 0 -> q = i + t * (v - 2 * s / N * n).
Proof.
  intros HN Hi -> Hq. apply Rmult_eq_reg_l with N; [| lra].
  replace (N * (i + t * (v - 2 * s / N * n))) with (N * i + t * N * v - 2 * t * s * n) by (field; lra).
  lra.
Qed.

(** The points of the mirrored ray are the images of those of the ray. *)
Lemma images_along a n ray i p q : imagen a n (Rayo_p ray) i -> p ∈ puntos_de_rayo ray -> imagen a n p q ->
  q ∈ puntos_de_rayo (mk_Rayo i (mirrored n (Rayo_v ray))).
Proof.
  intros [Hn [Ix [Iy Iz]]] [t [Ht [Px [Py Pz]]]] [_ [Qx [Qy Qz]]]. exists t. split; [exact Ht |]. cbn.
  set (o := Rayo_p ray) in *. set (v := Rayo_v ray) in *.
  assert (E : avance p a n = avance o a n + t * producto v n) by (unfold avance, producto; rewrite Px, Py, Pz; ring).
  rewrite E in Qx, Qy, Qz.
  repeat split; eapply image_component; eassumption.
Qed.

(** A beam and that of its image have one part on the mirror. Discharges seccion.def.1. *)
Theorem on_the_mirror_a_beam_is_that_of_its_image a n o i base w : imagen a n o i -> seccion o base a n w ->
  seccion i (fun q => exists p, p ∈ base /\ imagen a n p q) a n w.
Proof.
  intros H [Hw [ray [Hr [Hbeam Hin]]]]. split; [exact Hw |]. pose proof H as [Hn _]. destruct Hbeam as [Ho Hb].
  exists (mk_Rayo i (mirrored n (Rayo_v ray))). rewrite <- Ho in H.
  pose proof (the_mirrored_ray_is_one n ray i Hn Hr) as Hok. split; [exact Hok | split].
  - apply (the_image_of_a_beam_is_the_beam_of_the_image a (Rayo_p ray) i n base ray); try assumption; try reflexivity.
    + now split.
    + intros p q. now apply images_along.
  - apply (images_along a n ray i w w H Hin). unfold imagen. rewrite Hw. repeat split; lra.
Qed.

(** ** Pencils *)

(** Discharges aplicado.def.1, aplicado.conj.1. *)
Theorem matrices_compose : aplicado_conj_1.
Proof.
  intros m n.
  set (row := fun r : Desvio => mk_Desvio
    (Desvio_x r * Desvio_x (Matriz_x m) + Desvio_y r * Desvio_x (Matriz_y m) + Desvio_u r * Desvio_x (Matriz_u m)
     + Desvio_v r * Desvio_x (Matriz_v m))
    (Desvio_x r * Desvio_y (Matriz_x m) + Desvio_y r * Desvio_y (Matriz_y m) + Desvio_u r * Desvio_y (Matriz_u m)
     + Desvio_v r * Desvio_y (Matriz_v m))
    (Desvio_x r * Desvio_u (Matriz_x m) + Desvio_y r * Desvio_u (Matriz_y m) + Desvio_u r * Desvio_u (Matriz_u m)
     + Desvio_v r * Desvio_u (Matriz_v m))
    (Desvio_x r * Desvio_v (Matriz_x m) + Desvio_y r * Desvio_v (Matriz_y m) + Desvio_u r * Desvio_v (Matriz_u m)
     + Desvio_v r * Desvio_v (Matriz_v m))).
  exists (mk_Matriz (row (Matriz_x n)) (row (Matriz_y n)) (row (Matriz_u n)) (row (Matriz_v n))).
  intros d e f [Ex [Ey [Eu Ev]]] [Fx [Fy [Fu Fv]]]. unfold aplicado, row. cbn.
  rewrite Fx, Fy, Fu, Fv, Ex, Ey, Eu, Ev. repeat split; ring.
Qed.

(** Discharges traslado.def.1, traslado.conj.1. *)
Theorem the_way_along_the_axis_is_a_matrix : traslado_conj_1.
Proof.
  intros t. exists (mk_Matriz (mk_Desvio 1 0 t 0) (mk_Desvio 0 1 0 t) (mk_Desvio 0 0 1 0) (mk_Desvio 0 0 0 1)).
  intros d e. unfold traslado, aplicado. cbn. split; intros [Hx [Hy [Hu Hv]]]; rewrite Hx, Hy, Hu, Hv; repeat split; ring.
Qed.

(** Discharges traslado.conj.2. *)
Theorem two_ways_are_the_way_of_their_sum : traslado_conj_2.
Proof.
  intros s t d e f [Ex [Ey [Eu Ev]]] [Fx [Fy [Fu Fv]]]. unfold traslado.
  rewrite Fx, Fy, Fu, Fv, Ex, Ey, Eu, Ev. repeat split; ring.
Qed.

(** What a ball does to a ray that comes along its axis at the distance x, in either of the two directions. *)
Lemma through_a_ball r n k s x x1 x2 x3 u u1 u2 : 0 < r -> n > 1 -> n * k = 1 -> 2 * (n - 1) * (s + r) = n * r -> u = 0 ->
  x1 = x -> r * (u1 - k * u) = (k - 1) * x -> x2 = x1 + 2 * r * u1 -> (0 - r) * (u2 - n * u1) = (n - 1) * x2 ->
  x3 = x2 + s * u2 -> x3 = 0.
Proof.
  intros Hr Hn Hk Hs -> -> H1 -> H2 ->.
  assert (U1 : u1 = (k - 1) * x / r) by (apply Rmult_eq_reg_l with r; [field_simplify; lra | lra]).
  assert (K : k = 1 / n) by (apply Rmult_eq_reg_l with n; [field_simplify; lra | lra]).
  assert (S : s = n * r / (2 * (n - 1)) - r).
  { apply Rmult_eq_reg_l with (2 * (n - 1)); [| lra].
    replace (2 * (n - 1) * (n * r / (2 * (n - 1)) - r)) with (n * r - 2 * (n - 1) * r) by (field; lra). lra. }
  assert (U2 : u2 = n * u1 - (n - 1) * (x + 2 * r * u1) / r).
  { apply Rmult_eq_reg_l with (0 - r); [| lra].
    replace ((0 - r) * (n * u1 - (n - 1) * (x + 2 * r * u1) / r))
      with ((0 - r) * n * u1 + (n - 1) * (x + 2 * r * u1)) by (field; lra). lra. }
  rewrite U2, S, U1, K. field. lra.
Qed.

(** Discharges refraccion_paraxial.def.1, refraccion_paraxial.conj.1. *)
Theorem a_ball_unites_what_comes_along_its_axis : refraccion_paraxial_conj_1.
Proof.
  intros r n k s a b c d e Hr _ _ Hn Hk Hs Au Av [Bx [By [Bu Bv]]] [Cx [Cy [Cu Cv]]] [Dx [Dy [Du Dv]]] [Ex [Ey _]].
  unfold Rmas in Hr. rewrite Dx in Ex. rewrite Dy in Ey. rewrite Cu in Du. rewrite Cv in Dv. split.
  - now apply (through_a_ball r n k s (Desvio_x a) (Desvio_x b) (Desvio_x c) (Desvio_x e) (Desvio_u a) (Desvio_u b)
      (Desvio_u d)).
  - now apply (through_a_ball r n k s (Desvio_y a) (Desvio_y b) (Desvio_y c) (Desvio_y e) (Desvio_v a) (Desvio_v b)
      (Desvio_v d)).
Qed.

(** ** Instances: each premise above holds of something *)

Notation "'at_z' z" := (mk_Punto 0 0 z) (at level 10).
Definition up : Vector := mk_Vector 0 0 1.

(** The floor as a mirror, and a ray straight down on it through the one point of a base. *)
Theorem a_beam_on_the_floor_is_mirrored :
  imagen (at_z 0) up (at_z 1) (at_z (-1)) /\ haz (at_z 1) (single (at_z 0)) (mk_Rayo (at_z 1) (mk_Vector 0 0 (-1)))
  /\ seccion (at_z 1) (single (at_z 0)) (at_z 0) up (at_z 0) /\ avance (at_z 0) (at_z 0) up = 0.
Proof.
  assert (Beam : haz (at_z 1) (single (at_z 0)) (mk_Rayo (at_z 1) (mk_Vector 0 0 (-1)))).
  { split; [reflexivity |]. exists (at_z 0). split; [reflexivity |]. exists 1. unfold Rmas. cbn. lra. }
  assert (Flat : avance (at_z 0) (at_z 0) up = 0) by (unfold avance, up; cbn; lra).
  split; [unfold imagen, avance, producto, up; cbn; lra | split; [exact Beam | split; [| exact Flat]]].
  split; [exact Flat |]. exists (mk_Rayo (at_z 1) (mk_Vector 0 0 (-1))). split; [split; cbn; lra | split; [exact Beam |]].
  exists 1. unfold Rmas. cbn. lra.
Qed.

(** A cone of no angle with a ray of another length, and a ball of glass of the index 3/2, half a radius behind which a ray at
    the distance 1 meets the axis. *)
Theorem a_cone_and_a_ball_of_glass :
  cono_de_rayos (mk_Rayo (at_z 0) up) (mk_Rayo (at_z 0) (mk_Vector 0 0 2)) 1
  /\ refraccion_paraxial 1 (2 / 3) (mk_Desvio 1 0 0 0) (mk_Desvio 1 0 (-1 / 3) 0)
  /\ traslado (2 * 1) (mk_Desvio 1 0 (-1 / 3) 0) (mk_Desvio (1 / 3) 0 (-1 / 3) 0)
  /\ refraccion_paraxial (0 - 1) (3 / 2) (mk_Desvio (1 / 3) 0 (-1 / 3) 0) (mk_Desvio (1 / 3) 0 (-2 / 3) 0)
  /\ traslado (1 / 2) (mk_Desvio (1 / 3) 0 (-2 / 3) 0) (mk_Desvio 0 0 (-2 / 3) 0)
  /\ 2 * (3 / 2 - 1) * (1 / 2 + 1) = 3 / 2 * 1.
Proof.
  unfold cono_de_rayos, refraccion_paraxial, traslado, producto, cuadrado, up. cbn. repeat split; lra.
Qed.
