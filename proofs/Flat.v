(** What discs and triangles close and share, and the form in which the program clips a ray by a triangle.

    on_rim c r d w       == w is on the disc, and its distance from the centre is the radius
    top c d h            == the point c + h·d
    combination abc β γ  == the point a + β·(b − a) + γ·(c − a)
    toward p q λ         == the point p + λ·(q − p)
    vertex abc p         == p is a, b or c *)
From Coq Require Import Reals Lra.
From Durero Require Import Toolkit Especificacion Tipos Puntos.
Local Open Scope R_scope.
Local Open Scope zed_scope.

(** ** The rim of a disc *)

Definition on_rim (c : Punto) (r : R) (d : Vector) (w : Punto) : Prop :=
  w ∈ puntos_disco c r d /\ potencia_esfera w c r = 0.
Definition top (c : Punto) (d : Vector) (h : R) : Punto :=
  mk_Punto (Punto_x c + h * Vector_x d) (Punto_y c + h * Vector_y d) (Punto_z c + h * Vector_z d).

(** On the plane through the centre the advance is 0, and what lies across any axis is the whole distance from the centre:
    the rim of a disc is that of the truncated cone of the same centre and axis whose radius there is the disc's, though
    the axis be a unit vector up to the tolerance only. *)
Theorem rim_of_the_base w c r k d h : 0 <= h ->
  (on_rim c (r + k * h) d w <-> w ∈ puntos_tronco c r k d h /\ avance w c d = 0).
Proof.
  intros Hh. unfold on_rim, puntos_disco, puntos_tronco, potencia_plano.
  assert (E : avance w c d = 0 -> potencia_tronco w c r k d h = potencia_esfera w c (r + k * h)).
  { intros A. unfold potencia_tronco, alejamiento. rewrite A. unfold potencia_esfera, cuadrado. ring. }
  split; intros [[H1 H2] H3]; specialize (E ltac:(assumption)); rewrite E in *; repeat split; lra.
Qed.
(** At the other end the disc's centre is c + h·d, and its plane is at the advance h·|d|²: the axis must be a unit vector
    exactly. *)
Theorem rim_of_the_top w c r k d h : 0 <= h -> sq d = 1 ->
  (on_rim (top c d h) r d w <-> w ∈ puntos_tronco c r k d h /\ avance w c d = h).
Proof.
  intros Hh Hd. unfold on_rim, puntos_disco, puntos_tronco, potencia_plano.
  assert (A : avance w (top c d h) d = avance w c d - h * sq d) by (unfold avance, top, sq, dot; cbn; ring).
  assert (E : avance w c d = h -> potencia_tronco w c r k d h = potencia_esfera w (top c d h) r).
  { intros B. unfold potencia_tronco, alejamiento. rewrite B. unfold potencia_esfera, cuadrado, top; cbn. ring. }
  rewrite A, Hd. split; intros [[H1 H2] H3]; specialize (E ltac:(lra)); rewrite E in *; repeat split; lra.
Qed.

Lemma cilindro_is_tronco w c r d h : puntos_cilindro c r d h w <-> puntos_tronco c r 0 d h w.
Proof. unfold puntos_cilindro, puntos_tronco. now rewrite (potencia_cilindro_is_tronco w c r d h). Qed.
Lemma cono_is_tronco w c k d h : puntos_cono c k d h w <-> puntos_tronco c 0 k d h w.
Proof. unfold puntos_cono, puntos_tronco. now rewrite potencia_cono_is_tronco. Qed.

(** A disc at the base of a cylinder, a cone or a truncated cone closes it without a gap, for every axis; and one at the
    top, where the axis is a unit vector exactly. *)
Theorem discs_close w c r k d h : 0 <= h ->
  (on_rim c r d w <-> w ∈ puntos_cilindro c r d h /\ avance w c d = 0)
  /\ (on_rim c (k * h) d w <-> w ∈ puntos_cono c k d h /\ avance w c d = 0)
  /\ (on_rim c (r + k * h) d w <-> w ∈ puntos_tronco c r k d h /\ avance w c d = 0)
  /\ (sq d = 1 ->
      (on_rim (top c d h) r d w <-> w ∈ puntos_cilindro c r d h /\ avance w c d = h)
      /\ (on_rim (top c d h) r d w <-> w ∈ puntos_tronco c r k d h /\ avance w c d = h)).
Proof.
  intros Hh. rewrite cilindro_is_tronco, cono_is_tronco.
  split; [| split; [| split; [now apply rim_of_the_base | intros Hd; split; now apply rim_of_the_top]]].
  - rewrite <- rim_of_the_base by exact Hh. now replace (r + 0 * h) with r by ring.
  - rewrite <- rim_of_the_base by exact Hh. now replace (0 + k * h) with (k * h) by ring.
Qed.

(** ** The points of a triangle *)

(** The vertices that are not on one line are those whose normal is not null. Discharges Vertices.inv.1. *)
Theorem vertices_have_a_normal abc : abc ∈ Vertices <-> 0 < sq (normal abc).
Proof.
  unfold Vertices. split.
  - intros N. destruct (sq_nonneg (normal abc)) as [H | H]; [exact H |]. symmetry in H. apply sq_zero in H.
    unfold normal, cross, from in H; cbn in H. destruct N. lra.
  - intros H [Hx [Hy Hz]]. unfold sq, dot, normal, cross, from in H; cbn in H. rewrite Hx, Hy, Hz in H. lra.
Qed.

Definition combination (abc : Terna) (beta gamma : R) : Punto :=
  let a := Terna_a abc in let b := Terna_b abc in let c := Terna_c abc in
  mk_Punto (Punto_x a + beta * (Punto_x b - Punto_x a) + gamma * (Punto_x c - Punto_x a))
           (Punto_y a + beta * (Punto_y b - Punto_y a) + gamma * (Punto_y c - Punto_y a))
           (Punto_z a + beta * (Punto_z b - Punto_z a) + gamma * (Punto_z c - Punto_z a)).
Definition vertex (abc : Terna) (p : Punto) : Prop := p = Terna_a abc \/ p = Terna_b abc \/ p = Terna_c abc.

Ltac in_edges := unfold potencia_triangulo, lado, escalar, combination, normal, cross, from, sq, dot; cbn.

(** In its plane, the sides of a point are its weights, times the squared length of the normal. *)
Lemma sides_of_a_combination abc beta gamma :
  let a := Terna_a abc in let b := Terna_b abc in let c := Terna_c abc in let w := combination abc beta gamma in
  potencia_triangulo w abc = 0 /\ lado w a b c = gamma * sq (normal abc) /\ lado w c a b = beta * sq (normal abc)
  /\ lado w b c a = (1 - beta - gamma) * sq (normal abc).
Proof. destruct abc as [[ax ay az] [bx b_y bz] [cx cy cz]]. repeat split; in_edges; ring. Qed.
(** And every point is a combination, with its sides for weights, and its power along the normal. *)
Lemma point_by_sides w abc : let a := Terna_a abc in let b := Terna_b abc in let c := Terna_c abc in
  let n := sq (normal abc) in let beta := lado w c a b in let gamma := lado w a b c in
  let k := potencia_triangulo w abc in
  n * (Punto_x w - Punto_x a)
    = beta * (Punto_x b - Punto_x a) + gamma * (Punto_x c - Punto_x a) + k * Vector_x (normal abc)
  /\ n * (Punto_y w - Punto_y a)
    = beta * (Punto_y b - Punto_y a) + gamma * (Punto_y c - Punto_y a) + k * Vector_y (normal abc)
  /\ n * (Punto_z w - Punto_z a)
    = beta * (Punto_z b - Punto_z a) + gamma * (Punto_z c - Punto_z a) + k * Vector_z (normal abc).
Proof.
  cbv zeta. destruct w as [x y z], abc as [[ax ay az] [bx b_y bz] [cx cy cz]]. repeat split; in_edges; ring.
Qed.
Lemma combination_of_the_sides abc w : let n := sq (normal abc) in 0 < n -> potencia_triangulo w abc = 0 ->
  w = combination abc (lado w (Terna_c abc) (Terna_a abc) (Terna_b abc) / n)
                      (lado w (Terna_a abc) (Terna_b abc) (Terna_c abc) / n).
Proof.
  intros n HN P. destruct (point_by_sides w abc) as [Hx [Hy Hz]]. fold n in Hx, Hy, Hz. rewrite P in Hx, Hy, Hz.
  assert (E : forall beta gamma x u v k x0, n * (x - x0) = beta * u + gamma * v + 0 * k ->
    x = x0 + beta / n * u + gamma / n * v).
  { intros beta gamma x u v k x0 H. apply Rmult_eq_reg_l with n; [| lra].
    transitivity (n * x0 + (beta * u + gamma * v)); [lra | field; lra]. }
  destruct w as [x y z]. unfold combination; cbv zeta.
  f_equal; [exact (E _ _ _ _ _ _ _ Hx) | exact (E _ _ _ _ _ _ _ Hy) | exact (E _ _ _ _ _ _ _ Hz)].
Qed.

Lemma weights_make_a_point abc beta gamma : 0 <= beta -> 0 <= gamma -> beta + gamma <= 1 ->
  combination abc beta gamma ∈ puntos_triangulo abc.
Proof.
  intros Hb Hg Hs. destruct (sides_of_a_combination abc beta gamma) as [P [H1 [H2 H3]]].
  pose proof (sq_nonneg (normal abc)).
  split; [split; [| split] | exact P]; rewrite ?H1, ?H2, ?H3; apply Rmult_le_pos; lra.
Qed.

(** The points of a triangle are the convex combinations of its vertices. *)
Theorem triangle_is_the_convex_combinations abc w : abc ∈ Vertices ->
  (w ∈ puntos_triangulo abc <->
   exists beta gamma, 0 <= beta /\ 0 <= gamma /\ beta + gamma <= 1 /\ w = combination abc beta gamma).
Proof.
  intros HV. apply vertices_have_a_normal in HV as HN. split.
  - intros [[H1 [H2 H3]] P]. pose proof (combination_of_the_sides abc w HN P) as E.
    set (beta := lado w (Terna_c abc) (Terna_a abc) (Terna_b abc) / _) in *.
    set (gamma := lado w (Terna_a abc) (Terna_b abc) (Terna_c abc) / _) in *. exists beta, gamma.
    destruct (sides_of_a_combination abc beta gamma) as [_ [_ [_ H]]]. cbv zeta in H. rewrite <- E in H. rewrite H in H2.
    assert (0 <= 1 - beta - gamma).
    { apply Rmult_le_reg_r with (sq (normal abc)); [exact HN | lra]. }
    assert (0 < / sq (normal abc)) by now apply Rinv_0_lt_compat.
    split; [apply Rmult_le_pos; lra | split; [apply Rmult_le_pos; lra | split; [lra | exact E]]].
  - intros [beta [gamma [Hb [Hg [Hs ->]]]]]. now apply weights_make_a_point.
Qed.

Definition toward (p q : Punto) (l : R) : Punto :=
  mk_Punto (Punto_x p + l * (Punto_x q - Punto_x p)) (Punto_y p + l * (Punto_y q - Punto_y p))
           (Punto_z p + l * (Punto_z q - Punto_z p)).

(** The whole edge between two vertices of a triangle is in it, in whichever places they are: two triangles that have two
    vertices in common share that edge. *)
Theorem triangle_contains_its_edges abc p q l : vertex abc p -> vertex abc q -> 0 <= l <= 1 ->
  toward p q l ∈ puntos_triangulo abc.
Proof.
  intros Hp Hq Hl.
  assert (C : forall beta gamma, 0 <= beta -> 0 <= gamma -> beta + gamma <= 1 ->
    toward p q l = combination abc beta gamma -> toward p q l ∈ puntos_triangulo abc) by (intros beta gamma H1 H2 H3 ->; now apply weights_make_a_point).
  destruct Hp as [-> | [-> | ->]], Hq as [-> | [-> | ->]];
    [apply (C 0 0) | apply (C l 0) | apply (C 0 l) | apply (C (1 - l) 0) | apply (C 1 0) | apply (C (1 - l) l)
    | apply (C 0 (1 - l)) | apply (C l (1 - l)) | apply (C 0 1)];
    try lra; unfold toward, combination; f_equal; ring.
Qed.
Theorem triangles_share_their_edge abc abc' p q l : vertex abc p -> vertex abc q -> vertex abc' p -> vertex abc' q ->
  0 <= l <= 1 -> toward p q l ∈ puntos_triangulo abc ∩ puntos_triangulo abc'.
Proof. intros. split; now apply triangle_contains_its_edges. Qed.

(** ** The clip of a triangle as the program computes it *)

(** What the side of a point at T + t·v from the vertex is, where the ray crosses the plane: polynomial identities. *)
Lemma side_identity T v e1 e2 t :
  (sq e1 * (dot T e2 + t * dot v e2) - dot e1 e2 * (dot T e1 + t * dot v e1)) * dot e1 (cross v e2)
  = sq (cross e1 e2) * dot v (cross T e1)
    - (dot e2 (cross T e1) - t * dot e1 (cross v e2)) * dot v (cross (cross e1 e2) e1).
Proof.
  destruct T as [tx ty tz], v as [vx vy vz], e1 as [x1 y1 z1], e2 as [x2 y2 z2].
  unfold cross, sq, dot; cbn. ring.
Qed.
(** The sides by the edges that begin at a; their sum is |n|², everywhere. *)
Lemma sides_by_edges w abc : let a := Terna_a abc in let b := Terna_b abc in let c := Terna_c abc in
  let e1 := from a b in let e2 := from a c in let q := from a w in
  lado w a b c = sq e1 * dot q e2 - dot e1 e2 * dot q e1
  /\ lado w c a b = sq e2 * dot q e1 - dot e2 e1 * dot q e2
  /\ lado w a b c + lado w b c a + lado w c a b = sq (normal abc).
Proof.
  cbv zeta. destruct w as [x y z], abc as [[ax ay az] [bx b_y bz] [cx cy cz]].
  unfold lado, escalar, normal, cross, from, sq, dot; cbn. repeat split; ring.
Qed.

(** With T = p − a, E1 = b − a, E2 = c − a, P = v × E2, Q = T × E1 and det = E1·P, as Möller and Trumbore have it. *)
Section Program.
Variables (ray : Rayo) (abc : Terna).
Let a := Terna_a abc.
Let b := Terna_b abc.
Let c := Terna_c abc.
Let v := Rayo_v ray.
Let T := from a (Rayo_p ray).
Let E1 := from a b.
Let E2 := from a c.
Let P := cross v E2.
Let Q := cross T E1.
Let det := dot E1 P.
Let n := normal abc.

(** The power along the ray is linear, with the slope −det = v·n. *)
Lemma power_of_the_program t : potencia_triangulo (point_at ray t) abc = dot E2 Q - t * det /\ det = - dot v n.
Proof.
  unfold n, det, Q, P, E2, E1, T, v, c, b, a. clear.
  destruct ray as [[px py pz] [vx vy vz]], abc as [[ax ay az] [bx b_y bz] [cx cy cz]].
  unfold potencia_triangulo, normal, cross, from, sq, dot, point_at; cbn. split; ring.
Qed.
Lemma from_point_at t e : dot (from a (point_at ray t)) e = dot T e + t * dot v e.
Proof. unfold T, v, dot, from, point_at; cbn. ring. Qed.
Lemma det_swapped : dot E2 (cross v E1) = - det /\ dot v (cross T E2) = - dot T P
  /\ dot E1 (cross T E2) = - dot E2 Q /\ sq (cross E2 E1) = sq n.
Proof.
  unfold n, normal, det, Q, P. fold a b c. fold E1 E2. clearbody E1 E2 v T. clear.
  unfold cross, sq, dot; cbn. repeat split; ring.
Qed.

(** Where the ray crosses the plane of the triangle, it does so at one parameter, E2·Q/det; and there the three sides
    times det are |n|² times v·Q, T·P and det − T·P − v·Q. *)
Theorem sides_of_the_program : det <> 0 -> let t := dot E2 Q / det in let w := point_at ray t in
  (forall t', potencia_triangulo (point_at ray t') abc = 0 <-> t' = t)
  /\ lado w a b c * det = sq n * dot v Q
  /\ lado w c a b * det = sq n * dot T P
  /\ lado w b c a * det = sq n * (det - dot T P - dot v Q).
Proof.
  intros HD t w. assert (Ht : dot E2 Q - t * det = 0) by (unfold t; field; exact HD).
  destruct det_swapped as [S1 [S2 [S3 S4]]]. destruct (sides_by_edges w abc) as [L1 [L2 L3]].
  fold a b c in L1, L2, L3. fold E1 E2 n in L1, L2, L3.
  unfold w in L1, L2. rewrite !from_point_at in L1, L2. fold w in L1, L2.
  assert (H1 : lado w a b c * det = sq n * dot v Q).
  { rewrite L1. pose proof (side_identity T v E1 E2 t) as I. fold P Q in I. fold det in I. rewrite Ht in I.
    transitivity (sq (cross E1 E2) * dot v Q); [rewrite I; ring | reflexivity]. }
  assert (H2 : lado w c a b * det = sq n * dot T P).
  { rewrite L2. pose proof (side_identity T v E2 E1 t) as I. rewrite S1, S2, S3, S4 in I.
    replace (- dot E2 Q - t * - det) with 0 in I by lra. lra. }
  split; [| split; [exact H1 | split; [exact H2 |]]].
  - intros t'. rewrite (proj1 (power_of_the_program t')). split; [| intros ->; exact Ht].
    intros H. apply Rmult_eq_reg_r with det; [lra | exact HD].
  - replace (lado w b c a) with (sq n - lado w a b c - lado w c a b) by lra.
    rewrite !Rmult_minus_distr_r, H1, H2. ring.
Qed.

(** So the program clips as the text does: by the signs of three products. *)
Theorem clip_of_the_program : det <> 0 ->
  (point_at ray (dot E2 Q / det) ∈ prisma abc <->
   0 <= dot v Q * det /\ 0 <= (det - dot T P - dot v Q) * det /\ 0 <= dot T P * det).
Proof.
  intros HD. destruct (sides_of_the_program HD) as [_ [H1 [H2 H3]]].
  assert (HN : 0 < sq n).
  { destruct (sq_nonneg n) as [H | H]; [exact H | destruct HD]. symmetry in H. apply sq_zero in H as [Hx [Hy Hz]].
    rewrite (proj2 (power_of_the_program 0)). unfold dot. rewrite Hx, Hy, Hz. ring. }
  assert (HDD : 0 < det * det) by now apply Rsqr_pos_lt.
  assert (C : forall l x, l * det = sq n * x -> (0 <= l <-> 0 <= x * det)).
  { intros l x H. assert (E : det * det * l = sq n * (x * det)) by (rewrite <- Rmult_assoc, <- H; ring).
    split; intros L.
    - apply Rmult_le_reg_l with (sq n); [exact HN |]. rewrite Rmult_0_r, <- E. apply Rmult_le_pos; lra.
    - apply Rmult_le_reg_l with (det * det); [exact HDD |]. rewrite Rmult_0_r, E. apply Rmult_le_pos; lra. }
  unfold prisma. fold a b c. now rewrite (C _ _ H1), (C _ _ H2), (C _ _ H3).
Qed.

Theorem program_of_a_triangle : let w := point_at ray (dot E2 Q / det) in
  (forall t, potencia_triangulo (point_at ray t) abc = dot E2 Q - t * det)
  /\ (det <> 0 ->
      (forall t, potencia_triangulo (point_at ray t) abc = 0 <-> t = dot E2 Q / det)
      /\ lado w a b c * det = sq n * dot v Q
      /\ lado w c a b * det = sq n * dot T P
      /\ lado w b c a * det = sq n * (det - dot T P - dot v Q)
      /\ (w ∈ prisma abc <->
          0 <= dot v Q * det /\ 0 <= (det - dot T P - dot v Q) * det /\ 0 <= dot T P * det)).
Proof.
  split; [intros t; apply power_of_the_program |]. intros HD. destruct (sides_of_the_program HD) as [H0 [H1 [H2 H3]]].
  do 4 (split; [assumption |]). exact (clip_of_the_program HD).
Qed.
End Program.
