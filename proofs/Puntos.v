(** spec/puntos.tex: the surfaces as sets of points, and their equations along a ray.

    point_at ray t       == p + t·v
    from c p             == the vector p − c
    cross                == vector product
    normal abc           == (b − a) × (c − a), across the triangle
    bound                == A, B, C of a condition A·t² + 2B·t + C ≤ 0 on the parameter
    coefficients         == A, B, C of A·t² + 2B·t + C, and the bounds that clip it
    value f t, excess g t == A·t² + 2B·t + C, of coefficients and of a bound
    within f t           == every bound holds
    between a0 a1 h      == the bounds that say 0 ≤ a0 + t·a1 ≤ h
    side ray a b c       == the bound that says 0 ≤ lado of the point of the ray
    of_esfera, of_cilindro, of_cono, of_tronco, of_plano, of_disco, of_triangulo == the coefficients of each type, for any
                            axis, unit or not, and for any three points
    launched f           == f with C = 0: what a ray sees of an element that its origin is said to lie on *)
From Coq Require Import Reals List Lra.
From Durero Require Import Toolkit Especificacion Tipos.
Import ListNotations.
Local Open Scope R_scope.
Local Open Scope zed_scope.

(** The square root of the text is that of Coq's reals, and it is the only one. Discharges raizcuadrada.def.1. *)
Theorem raizcuadrada_exists_uniquely :
  raizcuadrada_decl raizcuadrada /\ raizcuadrada_def_1 raizcuadrada
  /\ forall f, raizcuadrada_decl f -> raizcuadrada_def_1 f -> forall r, r >= 0 -> f r = raizcuadrada r.
Proof.
  unfold raizcuadrada_decl, raizcuadrada_def_1, raizcuadrada. repeat split.
  - intros r _. apply Rle_ge, sqrt_pos.
  - intros r Hr. apply sqrt_sqrt. lra.
  - intros f H0 H r Hr. specialize (H0 r Hr). rewrite <- (H r Hr) at 2. symmetry. apply sqrt_square. lra.
Qed.

(** ** Points of a ray *)

Definition point_at (ray : Rayo) (t : R) : Punto :=
  mk_Punto (Punto_x (Rayo_p ray) + t * Vector_x (Rayo_v ray)) (Punto_y (Rayo_p ray) + t * Vector_y (Rayo_v ray))
           (Punto_z (Rayo_p ray) + t * Vector_z (Rayo_v ray)).

(** The points of a ray are those at a positive parameter. Discharges puntos_de_rayo.def.1. *)
Theorem puntos_de_rayo_parameter ray w : w ∈ puntos_de_rayo ray <-> exists t, t > 0 /\ w = point_at ray t.
Proof.
  split.
  - intros [t [Ht [Hx [Hy Hz]]]]. exists t. split; [exact Ht |]. destruct w; cbn in *. now subst.
  - intros [t [Ht ->]]. exists t. repeat split; assumption.
Qed.

Lemma point_at_0 ray : point_at ray 0 = Rayo_p ray.
Proof. destruct ray as [[x y z] v]; unfold point_at; cbn. f_equal; ring. Qed.

(** Two parameters of one ray give two points. *)
Lemma point_at_injective ray t t' : Rayo_ok ray -> point_at ray t = point_at ray t' -> t = t'.
Proof.
  intros [Hv] [= Hx Hy Hz]. destruct (Req_dec t t') as [E | N]; [exact E | destruct Hv].
  assert (D : forall a b, a + t * b = a + t' * b -> b = 0).
  { intros a b H. assert (P : (t - t') * b = 0) by lra. apply Rmult_integral in P as [P | P]; lra. }
  split; [exact (D _ _ Hx) | split; [exact (D _ _ Hy) | exact (D _ _ Hz)]].
Qed.

(** ** The equation of each surface along a ray *)

Definition from (c p : Punto) : Vector :=
  mk_Vector (Punto_x p - Punto_x c) (Punto_y p - Punto_y c) (Punto_z p - Punto_z c).

Definition cross (a b : Vector) : Vector :=
  mk_Vector (Vector_y a * Vector_z b - Vector_z a * Vector_y b) (Vector_z a * Vector_x b - Vector_x a * Vector_z b)
            (Vector_x a * Vector_y b - Vector_y a * Vector_x b).
Definition normal (abc : Terna) : Vector :=
  cross (from (Terna_a abc) (Terna_b abc)) (from (Terna_a abc) (Terna_c abc)).

Record bound := mk_bound { bA : R; bB : R; bC : R }.
Record coefficients := mk_coefficients { cA : R; cB : R; cC : R; clip : list bound }.
Definition value (f : coefficients) (t : R) : R := cA f * (t * t) + 2 * cB f * t + cC f.
Definition excess (g : bound) (t : R) : R := bA g * (t * t) + 2 * bB g * t + bC g.
Definition within (f : coefficients) (t : R) : Prop := Forall (fun g => excess g t <= 0) (clip f).
Definition launched (f : coefficients) : coefficients := mk_coefficients (cA f) (cB f) 0 (clip f).

Definition between (a0 a1 h : R) : list bound := [mk_bound 0 (- a1 / 2) (- a0); mk_bound 0 (a1 / 2) (a0 - h)].
Definition side ray a b c : bound :=
  let v := Rayo_v ray in let q := from a (Rayo_p ray) in let e1 := from a b in let e2 := from a c in
  mk_bound 0 (- (sq e1 * dot v e2 - dot e1 e2 * dot v e1) / 2) (- (sq e1 * dot q e2 - dot e1 e2 * dot q e1)).

Definition of_esfera ray c r : coefficients :=
  let v := Rayo_v ray in let q := from c (Rayo_p ray) in
  mk_coefficients (sq v) (dot q v) (sq q - r * r) [].
Definition of_cilindro ray c r d h : coefficients :=
  let v := Rayo_v ray in let q := from c (Rayo_p ray) in let n := sq d in let a0 := dot q d in let a1 := dot v d in
  mk_coefficients (sq v - (2 - n) * (a1 * a1)) (dot q v - (2 - n) * (a0 * a1))
                  (sq q - (2 - n) * (a0 * a0) - r * r) (between a0 a1 h).
Definition of_cono ray c k d h : coefficients :=
  let v := Rayo_v ray in let q := from c (Rayo_p ray) in let n := sq d in let a0 := dot q d in let a1 := dot v d in
  mk_coefficients (sq v - (2 - n + k * k) * (a1 * a1)) (dot q v - (2 - n) * (a0 * a1) + k * k * (h - a0) * a1)
                  (sq q - (2 - n) * (a0 * a0) - k * k * ((h - a0) * (h - a0))) (between a0 a1 h).
(** The radius at the ray's origin is ρ; along the ray it is ρ − k·s1·t. *)
Definition of_tronco ray c r k d h : coefficients :=
  let v := Rayo_v ray in let q := from c (Rayo_p ray) in let n := sq d in let a0 := dot q d in let a1 := dot v d in
  let rho := r + k * (h - a0) in
  mk_coefficients (sq v - (2 - n + k * k) * (a1 * a1)) (dot q v - (2 - n) * (a0 * a1) + rho * k * a1)
                  (sq q - (2 - n) * (a0 * a0) - rho * rho) (between a0 a1 h).
(** Linear: 2B is the slope v·d along the normal, and C the advance of the ray's origin. *)
Definition of_plano ray c d : coefficients :=
  mk_coefficients 0 (dot (Rayo_v ray) d / 2) (dot (from c (Rayo_p ray)) d) [].
(** The plane's, and the ball of the sphere of the same centre and radius for bound. *)
Definition of_disco ray c r d : coefficients :=
  let v := Rayo_v ray in let q := from c (Rayo_p ray) in
  mk_coefficients 0 (dot v d / 2) (dot q d) [mk_bound (sq v) (dot q v) (sq q - r * r)].
(** Linear as well, along the normal; each edge is a bound. *)
Definition of_triangulo ray abc : coefficients :=
  let a := Terna_a abc in let b := Terna_b abc in let c := Terna_c abc in
  mk_coefficients 0 (dot (Rayo_v ray) (normal abc) / 2) (dot (from a (Rayo_p ray)) (normal abc))
                  [side ray a b c; side ray b c a; side ray c a b].

Ltac coordinates := unfold potencia_esfera, potencia_cilindro, potencia_cono, potencia_tronco, potencia_plano,
  potencia_triangulo, alejamiento, avance, cuadrado, lado, escalar, value, excess, of_esfera, of_cilindro, of_cono,
  of_tronco, of_plano, of_disco, of_triangulo, side, normal, cross, from, sq, dot, point_at;
  cbn.

(** The advance of a point of the ray along an axis is s0 + t·s1. Discharges avance.def.1. *)
Lemma avance_along ray c d t : avance (point_at ray t) c d = dot (from c (Rayo_p ray)) d + t * dot (Rayo_v ray) d.
Proof. coordinates. ring. Qed.

(** The bounds between hold exactly where the advance is in the stretch. *)
Lemma between_holds a0 a1 h t : Forall (fun g => excess g t <= 0) (between a0 a1 h) <-> 0 <= a0 + t * a1 <= h.
Proof.
  unfold between, excess. rewrite !Forall_cons_iff. cbn. split; [intros [H1 [H2 _]]; lra |].
  intros H. split; [lra | split; [lra | constructor]].
Qed.

(** A cylinder is a truncated cone of proportion 0, and a cone is one of radius 0: as functions, since the text has
    neither number in Rmas. *)
Lemma potencia_cilindro_is_tronco w c r d h : potencia_cilindro w c r d = potencia_tronco w c r 0 d h.
Proof. coordinates. ring. Qed.
Lemma potencia_cono_is_tronco w c k d h : potencia_cono w c k d h = potencia_tronco w c 0 k d h.
Proof. coordinates. ring. Qed.
Lemma of_cilindro_is_tronco ray c r d h : of_cilindro ray c r d h = of_tronco ray c r 0 d h.
Proof. unfold of_cilindro, of_tronco; cbn; f_equal; ring. Qed.
Lemma of_cono_is_tronco ray c k d h : of_cono ray c k d h = of_tronco ray c 0 k d h.
Proof. unfold of_cono, of_tronco; cbn; f_equal; ring. Qed.

(** What lies across an axis, unit or not, of a point and of one of the ray, by products. *)
Lemma alejamiento_is w c d :
  alejamiento w c d = sq (from c w) - (2 - sq d) * (dot (from c w) d * dot (from c w) d).
Proof. coordinates. ring. Qed.
Lemma products_along ray c d t : let v := Rayo_v ray in let q := from c (Rayo_p ray) in
  sq (from c (point_at ray t)) = sq q + 2 * t * dot q v + t * t * sq v
  /\ dot (from c (point_at ray t)) d = dot q d + t * dot v d.
Proof. coordinates. split; ring. Qed.

(** The power of a point of the ray is A·t² + 2B·t + C, for every type and every axis.
    Discharges cuadrado.def.1, alejamiento.def.1, potencia_esfera.def.1, potencia_cilindro.def.1,
    potencia_cono.def.1, potencia_tronco.def.1, potencia_plano.def.1, potencia_triangulo.def.1. *)
Theorem potencia_esfera_along ray c r t : potencia_esfera (point_at ray t) c r = value (of_esfera ray c r) t.
Proof. coordinates. ring. Qed.
Theorem potencia_tronco_along ray c r k d h t :
  potencia_tronco (point_at ray t) c r k d h = value (of_tronco ray c r k d h) t.
Proof.
  unfold potencia_tronco, cuadrado, value, of_tronco. rewrite alejamiento_is, avance_along.
  destruct (products_along ray c d t) as [-> ->]. cbn. ring.
Qed.
Theorem potencia_cilindro_along ray c r d h t :
  potencia_cilindro (point_at ray t) c r d = value (of_cilindro ray c r d h) t.
Proof. rewrite of_cilindro_is_tronco, (potencia_cilindro_is_tronco _ c r d h). apply potencia_tronco_along. Qed.
Theorem potencia_cono_along ray c k d h t :
  potencia_cono (point_at ray t) c k d h = value (of_cono ray c k d h) t.
Proof. rewrite of_cono_is_tronco, potencia_cono_is_tronco. apply potencia_tronco_along. Qed.
Theorem potencia_plano_along ray c d t : potencia_plano (point_at ray t) c d = value (of_plano ray c d) t.
Proof. coordinates. field. Qed.
(** A disc has its plane's power. *)
Theorem potencia_disco_along ray c r d t : potencia_plano (point_at ray t) c d = value (of_disco ray c r d) t.
Proof. coordinates. field. Qed.
Theorem potencia_triangulo_along ray abc t : potencia_triangulo (point_at ray t) abc = value (of_triangulo ray abc) t.
Proof. coordinates. field. Qed.

(** The side of a point of the ray is linear in its parameter. Discharges escalar.def.1, lado.def.1. *)
Theorem lado_along ray a b c t : lado (point_at ray t) a b c = - excess (side ray a b c) t.
Proof. coordinates. field. Qed.

(** A point of the ray lies in the prism exactly where its parameter passes the clip. Discharges prisma.def.1. *)
Theorem prisma_along ray abc t : point_at ray t ∈ prisma abc <-> within (of_triangulo ray abc) t.
Proof.
  unfold prisma, within, of_triangulo. rewrite !lado_along. cbn [clip]. rewrite !Forall_cons_iff.
  split; [| lra]. intros [H1 [H2 H3]]. do 3 (split; [lra |]). constructor.
Qed.
(** A point of the ray lies in the ball exactly where its parameter passes the clip of the disc. *)
Theorem ball_along ray c r d t : potencia_esfera (point_at ray t) c r <= 0 <-> within (of_disco ray c r d) t.
Proof.
  rewrite potencia_esfera_along. unfold within; cbn [clip of_disco]. rewrite Forall_cons_iff.
  split; [intros H; split; [exact H | constructor] | now intros [H _]].
Qed.

(** A point of the ray lies on the sphere exactly at a root. Discharges puntos_esfera.def.1. *)
Theorem esfera_along ray c r t : point_at ray t ∈ puntos_esfera c r <-> value (of_esfera ray c r) t = 0.
Proof. unfold puntos_esfera. now rewrite potencia_esfera_along. Qed.

(** A point of the ray lies on the cylinder exactly at a root that passes the clip. Discharges puntos_cilindro.def.1. *)
Theorem cilindro_along ray c r d h t :
  point_at ray t ∈ puntos_cilindro c r d h <-> value (of_cilindro ray c r d h) t = 0 /\ within (of_cilindro ray c r d h) t.
Proof.
  unfold puntos_cilindro, within. rewrite (potencia_cilindro_along ray c r d h), avance_along. cbn [clip of_cilindro].
  now rewrite between_holds.
Qed.

(** A point of the ray lies on the cone exactly at a root that passes the clip. Discharges puntos_cono.def.1. *)
Theorem cono_along ray c k d h t :
  point_at ray t ∈ puntos_cono c k d h <-> value (of_cono ray c k d h) t = 0 /\ within (of_cono ray c k d h) t.
Proof.
  unfold puntos_cono, within. rewrite potencia_cono_along, avance_along. cbn [clip of_cono]. now rewrite between_holds.
Qed.

(** A point of the ray lies on the truncated cone exactly at a root that passes the clip. Discharges puntos_tronco.def.1. *)
Theorem tronco_along ray c r k d h t :
  point_at ray t ∈ puntos_tronco c r k d h <->
  value (of_tronco ray c r k d h) t = 0 /\ within (of_tronco ray c r k d h) t.
Proof.
  unfold puntos_tronco, within. rewrite potencia_tronco_along, avance_along. cbn [clip of_tronco].
  now rewrite between_holds.
Qed.

(** A point of the ray lies in the plane exactly at a root: nothing clips it. Discharges puntos_plano.def.1. *)
Theorem plano_along ray c d t : point_at ray t ∈ puntos_plano c d <-> value (of_plano ray c d) t = 0.
Proof. unfold puntos_plano. now rewrite potencia_plano_along. Qed.

(** A point of the ray lies on the disc exactly at a root that passes the clip. Discharges puntos_disco.def.1. *)
Theorem disco_along ray c r d t :
  point_at ray t ∈ puntos_disco c r d <-> value (of_disco ray c r d) t = 0 /\ within (of_disco ray c r d) t.
Proof. unfold puntos_disco. now rewrite (potencia_disco_along ray c r d), (ball_along ray c r d). Qed.

(** A point of the ray lies on the triangle exactly at a root that passes the clip. Discharges puntos_triangulo.def.1. *)
Theorem triangulo_along ray abc t :
  point_at ray t ∈ puntos_triangulo abc <-> value (of_triangulo ray abc) t = 0 /\ within (of_triangulo ray abc) t.
Proof. unfold puntos_triangulo. rewrite potencia_triangulo_along, prisma_along. tauto. Qed.

(** The clip of the cone keeps one nappe and its apex: the radius k·(h − s) is never negative there. *)
Theorem clip_keeps_one_nappe w c k d h : k > 0 -> w ∈ puntos_cono c k d h -> 0 <= k * (h - avance w c d).
Proof. intros Hk [_ H]. apply Rmult_le_pos; lra. Qed.
(** The clip of the truncated cone keeps one nappe without its apex: from rim to rim, its radius is at least that of the
    top. *)
Theorem clip_keeps_no_apex w c r k d h : r > 0 -> k > 0 -> w ∈ puntos_tronco c r k d h ->
  0 < r <= r + k * (h - avance w c d).
Proof. intros Hr Hk [_ H]. pose proof (Rmult_le_pos k (h - avance w c d)). lra. Qed.

(** ** The surfaces of radius and height one *)

(** Discharges potencia_esfera.conj.1. *)
Theorem every_sphere_is_that_of_one : potencia_esfera_conj_1.
Proof.
  intros [wx wy wz] [ux uy uz] [ox oy oz] [cx cy cz] r Hr Ox Oy Oz Hx Hy Hz.
  unfold puntos_esfera, potencia_esfera, cuadrado. cbn in *. subst ox oy oz. rewrite <- Hx, <- Hy, <- Hz.
  assert (E : r * ux * (r * ux) + r * uy * (r * uy) + r * uz * (r * uz) - r * r =
    r * r * ((ux - 0) * (ux - 0) + (uy - 0) * (uy - 0) + (uz - 0) * (uz - 0) - 1 * 1)) by ring.
  split; [ring | split; [exact E |]]. rewrite E. unfold Rmas in Hr.
  assert (0 < r * r) by (apply Rmult_lt_0_compat; lra).
  split; intros H0.
  - apply Rmult_integral in H0. destruct H0; lra.
  - rewrite H0. ring.
Qed.

Ltac of_one := unfold puntos_cilindro, puntos_cono, potencia_cilindro, potencia_cono, alejamiento, avance, cuadrado;
  cbn; repeat match goal with |- context [?a - 0] => replace (a - 0) with a by ring end.

(** Discharges potencia_cilindro.conj.1. *)
Theorem the_cylinder_of_one : potencia_cilindro_conj_1.
Proof.
  intros [x y z] [ox oy oz] [dx dy dz] _ Ox Oy Oz Dx Dy Dz. cbn in *. subst. of_one.
  replace (x * 0 + y * 0 + z * 1) with z by ring.
  replace ((x - (0 + z * 0)) * (x - (0 + z * 0)) + (y - (0 + z * 0)) * (y - (0 + z * 0))
           + (z - (0 + z * 1)) * (z - (0 + z * 1)) - 1 * 1) with (x * x + y * y - 1) by ring.
  tauto.
Qed.

(** Discharges potencia_cono.conj.1. *)
Theorem the_cone_of_one : potencia_cono_conj_1.
Proof.
  intros [x y z] [ox oy oz] [dx dy dz] _ Ox Oy Oz Dx Dy Dz. cbn in *. subst. of_one.
  replace (x * 0 + y * 0 + z * 1) with z by ring.
  replace ((x - (0 + z * 0)) * (x - (0 + z * 0)) + (y - (0 + z * 0)) * (y - (0 + z * 0))
           + (z - (0 + z * 1)) * (z - (0 + z * 1)) - (1 * z - 1 * 1) * (1 * z - 1 * 1))
    with (x * x + y * y - (1 - z) * (1 - z)) by ring.
  tauto.
Qed.
