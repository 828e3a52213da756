(** * Exacto: the first hit of a scene of rational numbers, decided by integer arithmetic

    Any finite set of rationals has a common denominator, so a scene and a ray are integers over one S > 0. Every
    decision is then the sign of an integer, of x + y√a, or of x + y√a + z√b, and those are found with products only.
    oracle/Extract.v extracts [first_hit] to OCaml, where it is an oracle that shares no code with the C++ one.

    vec3, shape           == a triple of integers, and an element: each integer n stands for n/S
    quadratic             == A t² + 2 B t + C = 0 with the bounds that clip it
    between a0 a1 h       == the bounds that say 0 <= a0 + t a1 <= h
    ball c r p v          == the bound that says that the ray's point is in the ball
    side p v a b c        == the bound that says 0 <= lado of the ray's point
    profile S c r k d l on p v == that of the surface of radius r at the advance l and of proportion k: r = 0 for a cone,
                            k = 0 for a cylinder
    quad S sh on p v      == the quadratic of the shape sh and of the ray p + t v; on: the ray starts on it, so C = 0
    answer, first_hit     == the outcome for a list of (identifier, shape, on)
    coordinate S p v t    == p + t v
    meets S sh on p v t   == the point of the ray at t > 0 is a point of the shape (Especificacion's puntos_esfera, …)
    is_first_hit S p v es a == the answer a is the first hit of the elements es *)
From Coq Require Import ZArith Reals List Lia Lra Bool.
From Durero Require Import Especificacion Surd Quadratic.
From Durero Require Puntos.
Import ListNotations.
Local Open Scope Z_scope.

(** ** The procedure *)

Record vec3 := Vec { vx : Z; vy : Z; vz : Z }.

Definition dot (a b : vec3) : Z := vx a * vx b + vy a * vy b + vz a * vz b.
Definition minus (a b : vec3) : vec3 := Vec (vx a - vx b) (vy a - vy b) (vz a - vz b).
Definition cross (a b : vec3) : vec3 :=
  Vec (vy a * vz b - vz a * vy b) (vz a * vx b - vx a * vz b) (vx a * vy b - vy a * vx b).

Inductive shape :=
| Sphere (centro : vec3) (radio : Z)
| Cylinder (centro : vec3) (radio : Z) (vector : vec3) (altura : Z)
| Cone (centro : vec3) (proporcion : Z) (vector : vec3) (altura : Z)
| TruncatedCone (centro : vec3) (radio proporcion : Z) (vector : vec3) (altura : Z)
| Plane (centro : vec3) (vector : vec3)
| Disc (centro : vec3) (radio : Z) (vector : vec3)
| Triangle (a b c : vec3).

(** The bounds of a stretch, times 2S²; of a ball, times S²; of an edge, times 2S⁴. *)
Definition between (a0 a1 h : Z) : list bound := [Bound 0 (- a1) (- (2 * a0)); Bound 0 a1 (2 * (a0 - h))].
Definition ball (c : vec3) (r : Z) (p v : vec3) : bound :=
  let q := minus p c in
  Bound (dot v v) (dot q v) (dot q q - r * r).
Definition side (p v a b c : vec3) : bound :=
  let q := minus p a in
  let e1 := minus b a in
  let e2 := minus c a in
  Bound 0 (- (dot e1 e1 * dot v e2 - dot e1 e2 * dot v e1)) (- (2 * (dot e1 e1 * dot q e2 - dot e1 e2 * dot q e1))).

(** The closed forms, times S² for the sphere, 2S² for the plane and the disc, 2S³ for the triangle and S⁶ for the others.
    The radius at the ray's origin is g, times S³. *)
Definition profile (S : Z) (c : vec3) (r k : Z) (d : vec3) (l : Z) (on : bool) (p v : vec3) : quadratic :=
  let q := minus p c in
  let s0 := dot q d in
  let s1 := dot v d in
  let S2 := S * S in
  let S4 := S2 * S2 in
  let m := 2 * S2 - dot d d in
  let g := S2 * r + k * (S * l - s0) in
  Quadratic (S4 * dot v v - (m + k * k) * (s1 * s1)) (S4 * dot q v - m * (s0 * s1) + g * k * s1)
    (if on then 0 else S4 * dot q q - m * (s0 * s0) - g * g) (between s0 s1 (S * l)).
Definition quad (S : Z) (sh : shape) (on : bool) (p v : vec3) : quadratic :=
  match sh with
  | Sphere c r =>
      let q := minus p c in
      Quadratic (dot v v) (dot q v) (if on then 0 else dot q q - r * r) []
  | Cylinder c r d l => profile S c r 0 d l on p v
  | Cone c k d l => profile S c 0 k d l on p v
  | TruncatedCone c r k d l => profile S c r k d l on p v
  | Plane c d => Quadratic 0 (dot v d) (if on then 0 else 2 * dot (minus p c) d) []
  | Disc c r d => Quadratic 0 (dot v d) (if on then 0 else 2 * dot (minus p c) d) [ball c r p v]
  | Triangle a b c =>
      let n := cross (minus b a) (minus c a) in
      Quadratic 0 (dot v n) (if on then 0 else 2 * dot (minus p a) n) [side p v a b c; side p v b c a; side p v c a b]
  end.

Inductive answer (I : Type) := Miss | Hit (t : surd) (elements : list I) | NoMin (elements : list I).
Arguments Miss {I}.
Arguments Hit {I}.
Arguments NoMin {I}.

Definition consider {I} (best : answer I) (i : I) (r : reach) : answer I :=
  match r, best with
  | Nothing, _ => best
  | NoMinimum, NoMin l => NoMin (i :: l)
  | NoMinimum, _ => NoMin [i]
  | At _, NoMin _ => best
  | At t, Miss => Hit t [i]
  | At t, Hit b l =>
      let c := cmp t b in
      if c <? 0 then Hit t [i] else if c =? 0 then Hit b (i :: l) else best
  end.

Fixpoint first_hit {I} (S : Z) (p v : vec3) (es : list (I * shape * bool)) : answer I :=
  match es with
  | [] => Miss
  | (i, sh, on) :: es' => consider (first_hit S p v es') i (first (quad S sh on p v))
  end.

(** The coordinate p + t v of a hit, for a coordinate p of the origin and v of the direction. *)
Definition coordinate (S p v : Z) (t : surd) : surd :=
  Surd (p * den t + v * num t) (v * coef t) (rad t) (S * den t).

(** ** What it means, over R *)

Local Open Scope R_scope.

Definition over (S n : Z) : R := IZR n / IZR S.
Definition point (S : Z) (a : vec3) : Punto := mk_Punto (over S (vx a)) (over S (vy a)) (over S (vz a)).
Definition direction (S : Z) (a : vec3) : Vector := mk_Vector (over S (vx a)) (over S (vy a)) (over S (vz a)).
Definition vertices (S : Z) (a b c : vec3) : Terna := mk_Terna (point S a) (point S b) (point S c).
Definition ray_at (S : Z) (p v : vec3) (t : R) : Punto :=
  mk_Punto (over S (vx p) + t * over S (vx v)) (over S (vy p) + t * over S (vy v)) (over S (vz p) + t * over S (vz v)).

Definition power (S : Z) (sh : shape) (w : Punto) : R :=
  match sh with
  | Sphere c r => potencia_esfera w (point S c) (over S r)
  | Cylinder c r d _ => potencia_cilindro w (point S c) (over S r) (direction S d)
  | Cone c k d l => potencia_cono w (point S c) (over S k) (direction S d) (over S l)
  | TruncatedCone c r k d l => potencia_tronco w (point S c) (over S r) (over S k) (direction S d) (over S l)
  | Plane c d | Disc c _ d => potencia_plano w (point S c) (direction S d)
  | Triangle a b c => potencia_triangulo w (vertices S a b c)
  end.

Definition clip (S : Z) (sh : shape) (w : Punto) : Prop :=
  match sh with
  | Sphere _ _ | Plane _ _ => True
  | Cylinder c _ d l | Cone c _ d l | TruncatedCone c _ _ d l => 0 <= avance w (point S c) (direction S d) <= over S l
  | Disc c r _ => potencia_esfera w (point S c) (over S r) <= 0
  | Triangle a b c => prisma (vertices S a b c) w
  end.

(** The points of the shape: of its surface, or (on) of the surface of the same equation through the ray's origin. *)
Definition points (S : Z) (sh : shape) (on : bool) (p : vec3) (w : Punto) : Prop :=
  power S sh w = (if on then power S sh (point S p) else 0) /\ clip S sh w.

Definition meets (S : Z) (sh : shape) (on : bool) (p v : vec3) (t : R) : Prop :=
  0 < t /\ points S sh on p (ray_at S p v t).

(** l names the elements of es that have the property P. *)
Definition lists {I} (P : shape -> bool -> Prop) (l : list I) (es : list (I * shape * bool)) : Prop :=
  forall i, In i l <-> exists sh on, In (i, sh, on) es /\ P sh on.

Definition is_first_hit {I} (S : Z) (p v : vec3) (es : list (I * shape * bool)) (a : answer I) : Prop :=
  match a with
  | Miss => forall i sh on t, In (i, sh, on) es -> ~ meets S sh on p v t
  | Hit x l =>
      valid x /\ l <> [] /\ (forall i sh on t, In (i, sh, on) es -> meets S sh on p v t -> val x <= t) /\
      lists (fun sh on => meets S sh on p v (val x)) l es
  | NoMin l => l <> [] /\ lists (fun sh on => from_origin (meets S sh on p v)) l es
  end.

Theorem coordinate_correct S p v t : (0 < S)%Z -> valid t ->
  valid (coordinate S p v t) /\ val (coordinate S p v t) = over S p + val t * over S v.
Proof.
  intros HS Ht; pose proof (den_pos t Ht); pose proof (IZR_lt _ _ HS); destruct Ht as [H1 H2].
  split; [split; simpl; lia|]; unfold val, over; simpl; rewrite plus_IZR, !mult_IZR; field; lra.
Qed.

(** ** One element *)

Lemma IZR_over S n : (0 < S)%Z -> IZR n = IZR S * over S n.
Proof. intros HS; apply IZR_lt in HS; unfold over; field; lra. Qed.
Lemma over_0 S : over S 0 = 0.
Proof. apply Rmult_0_l. Qed.

(** An integer n stands for S times what n is over S. *)
Local Ltac in_units S HS :=
  cbn [point direction Punto_x Punto_y Punto_z Vector_x Vector_y Vector_z vx vy vz];
  repeat rewrite ?plus_IZR, ?minus_IZR, ?mult_IZR;
  repeat match goal with |- context [IZR ?n] => is_var n; tryif constr_eq n S then fail else rewrite (IZR_over S n HS) end;
  ring.

(** So products of integer vectors are those of the vectors that they stand for, but for powers of S. *)
Definition ray_from S p v : Rayo := mk_Rayo (point S p) (direction S v).

Lemma dot_over S a b : (0 < S)%Z -> IZR (dot a b) = IZR S ^ 2 * Tipos.dot (direction S a) (direction S b).
Proof. intros HS; destruct a, b; unfold dot, Tipos.dot; in_units S HS. Qed.
Lemma triple_over S a b c : (0 < S)%Z ->
  IZR (dot a (cross b c)) = IZR S ^ 3 * Tipos.dot (direction S a) (Puntos.cross (direction S b) (direction S c)).
Proof. intros HS; destruct a, b, c; unfold dot, cross, Tipos.dot, Puntos.cross; in_units S HS. Qed.
Lemma minus_over S a b : direction S (minus a b) = Puntos.from (point S b) (point S a).
Proof.
  unfold direction, minus, Puntos.from, point; cbn; unfold over; f_equal; rewrite minus_IZR; unfold Rdiv; ring.
Qed.
Lemma at_start S p v : ray_at S p v 0 = point S p.
Proof. unfold ray_at, point; f_equal; ring. Qed.

(** A quadratic over the integers is that over the reals: dots, and the numbers r, k, l, are over S. *)
Local Ltac by_dots S HS :=
  repeat rewrite ?plus_IZR, ?minus_IZR, ?mult_IZR, ?opp_IZR;
  rewrite ?(triple_over S _ _ _ HS), ?(dot_over S _ _ HS), ?minus_over;
  repeat match goal with |- context [IZR ?n] => is_var n; tryif constr_eq n S then fail else rewrite (IZR_over S n HS) end.

Lemma profile_power S c r k d l on p v t : (0 < S)%Z ->
  let q := profile S c r k d l on p v in
  let power w := potencia_tronco w (point S c) (over S r) (over S k) (direction S d) (over S l) in
  IZR (qA q) * t * t + 2 * IZR (qB q) * t + IZR (qC q)
  = IZR S ^ 6 * (power (ray_at S p v t) - if on then power (point S p) else 0).
Proof.
  intros HS q power; unfold q, power; rewrite <- (at_start S p v).
  change (ray_at S p v) with (Puntos.point_at (ray_from S p v)); rewrite !Puntos.potencia_tronco_along.
  unfold Puntos.value, Puntos.of_tronco; cbn [profile qA qB qC Puntos.cA Puntos.cB Puntos.cC ray_from Rayo_p Rayo_v].
  destruct on; by_dots S HS; unfold Tipos.sq; ring.
Qed.

(** The quadratic is the power of the ray's point, times S² for a sphere, 2S² for a plane and a disc, 2S³ for a triangle
    and S⁶ for the others. *)
Definition scale (S : Z) (sh : shape) : R :=
  match sh with
  | Sphere _ _ => IZR S ^ 2
  | Plane _ _ | Disc _ _ _ => 2 * IZR S ^ 2
  | Triangle _ _ _ => 2 * IZR S ^ 3
  | _ => IZR S ^ 6
  end.

Lemma quad_power S sh on p v t : (0 < S)%Z ->
  let q := quad S sh on p v in
  IZR (qA q) * t * t + 2 * IZR (qB q) * t + IZR (qC q)
  = scale S sh * (power S sh (ray_at S p v t) - if on then power S sh (point S p) else 0).
Proof.
  intros HS; destruct sh as [c r|c r d l|c k d l|c r k d l|c d|c r d|a b c]; cbn [quad scale power];
    [| rewrite !(Puntos.potencia_cilindro_is_tronco _ _ _ _ (over S l)) | rewrite !Puntos.potencia_cono_is_tronco
      | | | |].
  2-4: etransitivity; [now apply profile_power | rewrite ?over_0; reflexivity].
  all: cbv zeta; rewrite <- (at_start S p v); change (ray_at S p v) with (Puntos.point_at (ray_from S p v)).
  - rewrite !Puntos.potencia_esfera_along; unfold Puntos.value, Puntos.of_esfera;
      cbn [qA qB qC Puntos.cA Puntos.cB Puntos.cC ray_from Rayo_p Rayo_v].
    destruct on; by_dots S HS; unfold Tipos.sq; ring.
  - rewrite !Puntos.potencia_plano_along; unfold Puntos.value, Puntos.of_plano;
      cbn [qA qB qC Puntos.cA Puntos.cB Puntos.cC ray_from Rayo_p Rayo_v].
    destruct on; by_dots S HS; field.
  - rewrite !Puntos.potencia_plano_along; unfold Puntos.value, Puntos.of_plano;
      cbn [qA qB qC Puntos.cA Puntos.cB Puntos.cC ray_from Rayo_p Rayo_v].
    destruct on; by_dots S HS; field.
  - rewrite !Puntos.potencia_triangulo_along; unfold Puntos.value, Puntos.of_triangulo, Puntos.normal;
      cbn [qA qB qC Puntos.cA Puntos.cB Puntos.cC ray_from Rayo_p Rayo_v vertices Terna_a Terna_b Terna_c].
    destruct on; by_dots S HS; field.
Qed.

(** The bounds of the clip. *)
Lemma between_over S c d l p v t : (0 < S)%Z ->
  let q := minus p c in
  inside (between (dot q d) (dot v d) (S * l)) t <->
  0 <= avance (ray_at S p v t) (point S c) (direction S d) <= over S l.
Proof.
  intros HS q; apply IZR_lt in HS as HR; assert (HS2 : 0 < IZR S ^ 2) by now apply pow_lt.
  assert (IZR (dot q d) + t * IZR (dot v d) = IZR S ^ 2 * avance (ray_at S p v t) (point S c) (direction S d)) as E.
  { change (ray_at S p v) with (Puntos.point_at (ray_from S p v)); rewrite Puntos.avance_along; unfold q.
    by_dots S HS; cbn [ray_from Rayo_p Rayo_v]; ring. }
  assert (IZR (S * l) = IZR S ^ 2 * over S l) as El by (rewrite mult_IZR, (IZR_over S l HS); ring).
  unfold inside, between, Puntos.excess; cbn [map]; rewrite !Forall_cons_iff; unfold over_R;
    cbn [Puntos.bA Puntos.bB Puntos.bC gA gB gC]; rewrite !opp_IZR, !mult_IZR, !minus_IZR, El.
  set (a := avance _ _ _) in *; split.
  - intros (H1 & H2 & _); split; apply Rmult_le_reg_l with (1 := HS2); lra.
  - intros [H1 H2]; apply (Rmult_le_compat_l _ _ _ (Rlt_le _ _ HS2)) in H1, H2.
    split; [lra | split; [lra | constructor]].
Qed.

Lemma ball_over S c r p v t : (0 < S)%Z ->
  (Puntos.excess (over_R (ball c r p v)) t <= 0 <-> potencia_esfera (ray_at S p v t) (point S c) (over S r) <= 0).
Proof.
  intros HS; apply IZR_lt in HS as HR; assert (HS2 : 0 < IZR S ^ 2) by now apply pow_lt.
  assert (Puntos.excess (over_R (ball c r p v)) t
    = IZR S ^ 2 * potencia_esfera (ray_at S p v t) (point S c) (over S r)) as ->.
  { change (ray_at S p v) with (Puntos.point_at (ray_from S p v)); rewrite Puntos.potencia_esfera_along.
    unfold Puntos.excess, over_R, ball, Puntos.value, Puntos.of_esfera;
      cbn [Puntos.bA Puntos.bB Puntos.bC gA gB gC Puntos.cA Puntos.cB Puntos.cC ray_from Rayo_p Rayo_v].
    by_dots S HS; unfold Tipos.sq; ring. }
  split; intros H; [apply Rmult_le_reg_l with (1 := HS2) | apply (Rmult_le_compat_l _ _ _ (Rlt_le _ _ HS2)) in H]; lra.
Qed.

Lemma side_over S a b c p v t : (0 < S)%Z ->
  (Puntos.excess (over_R (side p v a b c)) t <= 0 <-> 0 <= lado (ray_at S p v t) (point S a) (point S b) (point S c)).
Proof.
  intros HS; apply IZR_lt in HS as HR; assert (HS4 : 0 < IZR S ^ 4) by now apply pow_lt.
  assert (Puntos.excess (over_R (side p v a b c)) t
    = - (2 * (IZR S ^ 4 * lado (ray_at S p v t) (point S a) (point S b) (point S c)))) as ->.
  { change (ray_at S p v) with (Puntos.point_at (ray_from S p v)); rewrite Puntos.lado_along.
    unfold Puntos.excess, over_R, side, Puntos.side;
      cbn [Puntos.bA Puntos.bB Puntos.bC gA gB gC ray_from Rayo_p Rayo_v].
    by_dots S HS; unfold Tipos.sq; field. }
  split; intros H; [apply Rmult_le_reg_l with (1 := HS4) | apply (Rmult_le_compat_l _ _ _ (Rlt_le _ _ HS4)) in H]; lra.
Qed.

Lemma quad_clip S sh on p v t : (0 < S)%Z -> (inside (bounds (quad S sh on p v)) t <-> clip S sh (ray_at S p v t)).
Proof.
  intros HS; destruct sh as [c r|c r d l|c k d l|c r k d l|c d|c r d|a b c]; cbn [quad bounds clip];
    try (apply between_over; assumption); try solve [split; [trivial | constructor]]; unfold inside; cbn [map].
  - rewrite Forall_cons_iff, (ball_over S c r p v t HS); split; [tauto | intros H; split; [exact H | constructor]].
  - unfold prisma; cbn [vertices Terna_a Terna_b Terna_c].
    rewrite !Forall_cons_iff, !(side_over S _ _ _ p v t HS); split; [tauto|].
    intros (H1 & H2 & H3); repeat split; try assumption; constructor.
Qed.

Lemma dot_nonneg v : (0 <= dot v v)%Z.
Proof.
  unfold dot; pose proof (Z.square_nonneg (vx v)); pose proof (Z.square_nonneg (vy v)); pose proof (Z.square_nonneg (vz v)).
  lia.
Qed.
Lemma quad_proper S sh on p v : proper (quad S sh on p v).
Proof.
  destruct sh; repeat apply Forall_cons; try apply Forall_nil; first [apply dot_nonneg | apply Z.le_refl].
Qed.

(** The closed form of each shape is sound and complete: its solutions are the parameters of the shape's points. *)
Theorem quad_meets S sh on p v t : (0 < S)%Z -> meets S sh on p v t <-> solves (quad S sh on p v) t.
Proof.
  intros HS; unfold meets, points, solves; rewrite (quad_clip S sh on p v t HS), (quad_power S sh on p v t HS).
  assert (0 < scale S sh).
  { apply IZR_lt in HS; destruct sh; cbn [scale]; auto using pow_lt, Rmult_lt_0_compat, Rlt_0_2. }
  split; (intros (Ht & Hp & Hc); repeat split; try assumption).
  - rewrite Hp; ring.
  - apply Rmult_integral in Hp; lra.
Qed.

(** What a ray has of one element, as a set of points, is what [first] answers. *)
Corollary first_of_shape S sh on p v : (0 < S)%Z -> reaches (meets S sh on p v) (first (quad S sh on p v)).
Proof.
  intros HS; apply (reaches_ext (solves (quad S sh on p v)));
    [intros t; now rewrite quad_meets | apply first_reaches, quad_proper].
Qed.

(** ** The scene *)

Lemma first_hit_positive {I} S p v (es : list (I * shape * bool)) x l :
  is_first_hit S p v es (Hit x l) -> 0 < val x.
Proof.
  intros (_ & Hl & _ & Hin); destruct l as [|i l]; [contradiction|].
  destruct (proj1 (Hin i) (or_introl eq_refl)) as (sh & on & _ & H & _); exact H.
Qed.

Section Lists.
Context {I : Type} (P : shape -> bool -> Prop) (i : I) (sh : shape) (on : bool) (es : list (I * shape * bool)).

Lemma lists_none : (forall i sh on, In (i, sh, on) es -> ~ P sh on) -> lists P [] es.
Proof. intros H j; split; [intros [] | intros (sh' & on' & Hin & HP); now apply (H j sh' on')]. Qed.

Lemma lists_yes l : P sh on -> lists P l es -> lists P (i :: l) ((i, sh, on) :: es).
Proof.
  intros HP Hl j; split.
  - intros [<-|Hj]; [exists sh, on; split; [now left | assumption]|].
    apply Hl in Hj as (sh' & on' & Hin & HP'); exists sh', on'; split; [now right | assumption].
  - intros (sh' & on' & [[= -> -> ->]|Hin] & HP'); [now left | right; apply Hl; now exists sh', on'].
Qed.

Lemma lists_no l : ~ P sh on -> lists P l es -> lists P l ((i, sh, on) :: es).
Proof.
  intros HP Hl j; split.
  - intros Hj; apply Hl in Hj as (sh' & on' & Hin & HP'); exists sh', on'; split; [now right | assumption].
  - intros (sh' & on' & [[= -> -> ->]|Hin] & HP'); [contradiction | apply Hl; now exists sh', on'].
Qed.
End Lists.

Local Ltac hit_goals := split; [assumption | split; [assumption || discriminate | split]].

(** Algorithm II.2: the least of the elements' first hits, the elements that share it, or those without minimum. *)
Lemma consider_correct {I} S p v i sh on (es : list (I * shape * bool)) best r :
  reaches (meets S sh on p v) r -> is_first_hit S p v es best ->
  is_first_hit S p v ((i, sh, on) :: es) (consider best i r).
Proof.
  intros Hr Hbest; assert (Hpos : forall sh on t, meets S sh on p v t -> 0 < t) by (intros ? ? ? [H _]; exact H).
  pose proof (reaches_from_origin _ r (Hpos sh on) Hr) as Hor.
  destruct r as [|t|], best as [|b l|l]; cbn [consider reaches is_first_hit] in *.
  - intros j sh' on' t [[= -> -> ->]|Hj]; [apply Hr | eapply Hbest; eauto].
  - destruct Hbest as (Hv & Hl & Hmin & Hin); hit_goals; [|now apply lists_no].
    intros j sh' on' t [[= -> -> ->]|Hj] Ht; [now destruct (Hr t) | eauto].
  - destruct Hbest as (Hl & Hin); split; [assumption | apply lists_no; [rewrite Hor; discriminate | assumption]].
  - destruct Hr as (Hv & Ht & Hmin); hit_goals.
    + intros j sh' on' t' [[= -> -> ->]|Hj] Ht'; [auto | destruct (Hbest _ _ _ _ Hj Ht')].
    + apply lists_yes; [assumption | apply lists_none; intros; eauto].
  - destruct Hr as (Hvt & Ht & Hmint), Hbest as (Hvb & Hl & Hminb & Hin).
    pose proof (cmp_correct t b Hvt Hvb) as Hc.
    destruct (Z.ltb_spec (cmp t b) 0); [|destruct (Z.eqb_spec (cmp t b) 0)];
      destruct Hc as [[Ec Hc]|[[Ec Hc]|[Ec Hc]]]; try lia; cbn [is_first_hit].
    + hit_goals.
      * intros j sh' on' t' [[= -> -> ->]|Hj] Ht'; [auto | specialize (Hminb _ _ _ _ Hj Ht'); lra].
      * apply lists_yes; [assumption | apply lists_none; intros j sh' on' Hj Ht'].
        specialize (Hminb _ _ _ _ Hj Ht'); lra.
    + replace (val t) with (val b) in * by lra; hit_goals; [|now apply lists_yes].
      intros j sh' on' t' [[= -> -> ->]|Hj] Ht'; eauto.
    + hit_goals.
      * intros j sh' on' t' [[= -> -> ->]|Hj] Ht'; [specialize (Hmint _ Ht'); lra | eauto].
      * apply lists_no; [intros Hb; specialize (Hmint _ Hb); lra | assumption].
  - destruct Hbest as (Hl & Hin); split; [assumption | apply lists_no; [rewrite Hor; discriminate | assumption]].
  - split; [discriminate | apply lists_yes; [assumption|]]; apply lists_none; intros j sh' on' Hj (e & He & HP).
    apply (Hbest _ _ _ e Hj), HP; lra.
  - split; [discriminate | apply lists_yes; [assumption|]]; apply lists_none; intros j sh' on' Hj Ho.
    pose proof (first_hit_positive _ _ _ _ _ _ Hbest) as Hx0.
    destruct (from_origin_no_least _ _ Ho Hx0) as (t & Ht & Hlt), Hbest as (_ & _ & Hmin & _).
    specialize (Hmin _ _ _ _ Hj Ht); lra.
  - destruct Hbest as (Hl & Hin); split; [discriminate | now apply lists_yes].
Qed.

(** The procedure is right: outcome, parameter and set of elements are those of the sets of points over R. *)
Theorem first_hit_correct {I} S p v (es : list (I * shape * bool)) : (0 < S)%Z ->
  is_first_hit S p v es (first_hit S p v es).
Proof.
  intros HS; induction es as [|[[i sh] on] es IH]; cbn [first_hit].
  - intros i sh on t [].
  - apply consider_correct; [now apply first_of_shape | exact IH].
Qed.
