(** The closed forms of the tracer: the roots of A·t² + 2B·t + C in every case, the discriminants without cancellation,
    and the first hit of one element.

    roots f              == every t solves it, or the list of the solutions
    solves R t           == t is among them
    nearest f l          == the least t > 0 of the list l that passes the clip
    first f              == the first hit of an element: First_hit t, First_miss or First_no_minimum
    reach f              == the parameters t > 0 of the points of the ray on the element
    is_first T x         == x is the first hit of the set T of parameters
    starts_in T          == T contains every parameter from 0 to some ε > 0
    cross                == vector product *)
From Coq Require Import Reals List Lra.
From Durero Require Import Toolkit Especificacion Tipos Puntos.
Import ListNotations.
Local Open Scope R_scope.
Local Open Scope zed_scope.

(** ** The roots *)

Inductive solutions := every | these (l : list R).
Definition solves (S : solutions) (t : R) : Prop := match S with every => True | these l => In t l end.

Definition discriminant (f : coefficients) : R := cB f * cB f - cA f * cC f.
Definition sgn (x : R) : R := if Rlt_dec x 0 then -1 else 1.
(** −(B + sgn(B)·√D): a sum of two terms of one sign. *)
Definition stable_sum (f : coefficients) : R := - (cB f + sgn (cB f) * sqrt (discriminant f)).

Definition roots (f : coefficients) : solutions :=
  if Req_EM_T (cA f) 0 then
    if Req_EM_T (cB f) 0 then if Req_EM_T (cC f) 0 then every else these []
    else these [- cC f / (2 * cB f)]
  else if Rlt_dec (discriminant f) 0 then these []
  else if Req_EM_T (stable_sum f) 0 then these [0]
  else these [stable_sum f / cA f; cC f / stable_sum f].

Lemma sgn_square x : sgn x * sgn x = 1.
Proof. unfold sgn. destruct (Rlt_dec x 0); ring. Qed.

(** A·value = (A·t + B)² − D. *)
Lemma complete_square f t : cA f * value f t = (cA f * t + cB f) * (cA f * t + cB f) - discriminant f.
Proof. unfold value, discriminant. ring. Qed.

Lemma no_root f t : discriminant f < 0 -> value f t <> 0.
Proof.
  intros HD H. pose proof (complete_square f t) as E. rewrite H in E.
  pose proof (Rle_0_sqr (cA f * t + cB f)) as Q. unfold Rsqr in Q. lra.
Qed.

(** With A ≠ 0 and Z the stable sum, A·value factors into (A·t − Z)·(A·t + 2B + Z), and Z·(2B + Z) = −A·C. *)
Lemma stable_factors f t : 0 <= discriminant f ->
  cA f * value f t = (cA f * t - stable_sum f) * (cA f * t + 2 * cB f + stable_sum f)
  /\ stable_sum f * (2 * cB f + stable_sum f) = - (cA f * cC f).
Proof.
  intros HD. pose proof (sqrt_sqrt _ HD) as Hs. pose proof (sgn_square (cB f)) as Hg.
  assert (E : (stable_sum f + cB f) * (stable_sum f + cB f) = discriminant f).
  { unfold stable_sum. transitivity ((sgn (cB f) * sgn (cB f)) * (sqrt (discriminant f) * sqrt (discriminant f)));
      [ring | rewrite Hg, Hs; ring]. }
  rewrite complete_square. unfold discriminant in *. split; lra.
Qed.

(** The roots computed are exactly the solutions, in every case: A > 0, A < 0, A = 0 ≠ B, A = B = 0. *)
Theorem roots_correct f t : value f t = 0 <-> solves (roots f) t.
Proof.
  unfold roots. destruct (Req_EM_T (cA f) 0) as [HA | HA].
  - assert (L : value f t = 2 * cB f * t + cC f) by (unfold value; rewrite HA; ring). rewrite L.
    destruct (Req_EM_T (cB f) 0) as [HB | HB].
    + rewrite HB. destruct (Req_EM_T (cC f) 0) as [HC | HC]; cbn; split; intros; lra.
    + cbn. split; [intros H; left | intros [<- | []]; field; assumption].
      apply Rmult_eq_reg_l with (2 * cB f); [field_simplify; lra | lra].
  - destruct (Rlt_dec (discriminant f) 0) as [HD | HD]; cbn; [split; [now apply no_root | tauto] |].
    apply Rnot_lt_le in HD. destruct (stable_factors f t HD) as [F P]. set (Z := stable_sum f) in *.
    assert (V : value f t = 0 <-> (cA f * t - Z) * (cA f * t + 2 * cB f + Z) = 0).
    { rewrite <- F. split; [intros ->; ring | intros H; apply Rmult_integral in H; tauto]. }
    rewrite V. destruct (Req_EM_T Z 0) as [HZ | HZ].
    + assert (HB : cB f = 0).
      { assert (HC : sgn (cB f) * sqrt (discriminant f) = - cB f) by (unfold Z, stable_sum in HZ; lra).
        pose proof (sqrt_pos (discriminant f)). unfold sgn in HC. destruct (Rlt_dec (cB f) 0); lra. }
      rewrite HZ, HB. cbn. split; [intros H; left | intros [<- | []]; ring].
      apply Rmult_integral in H as [H | H]; (assert (cA f * t = 0) by lra; apply Rmult_integral in H0; lra).
    + assert (E : cC f / Z = - (2 * cB f + Z) / cA f).
      { apply Rmult_eq_reg_l with (Z * cA f); [field_simplify; [lra | assumption ..] |].
        intros H. apply Rmult_integral in H. tauto. }
      cbn. rewrite E. split.
      * intros H. apply Rmult_integral in H as [H | H]; [left | right; left];
          (apply Rmult_eq_reg_l with (cA f); [field_simplify; [lra | assumption] | assumption]).
      * intros [<- | [<- | []]]; field; assumption.
Qed.

(** The stable forms are the textbook ones, (−B ± √D)/A, in one order or the other. *)
Theorem stable_roots_are_textbook f : cA f <> 0 -> 0 <= discriminant f -> stable_sum f <> 0 ->
  let plus := (- cB f + sqrt (discriminant f)) / cA f in
  let minus := (- cB f - sqrt (discriminant f)) / cA f in
  (stable_sum f / cA f = plus /\ cC f / stable_sum f = minus)
  \/ (stable_sum f / cA f = minus /\ cC f / stable_sum f = plus).
Proof.
  intros HA HD HZ plus minus. destruct (stable_factors f 0 HD) as [_ P].
  assert (E : cC f / stable_sum f = - (2 * cB f + stable_sum f) / cA f).
  { apply Rmult_eq_reg_l with (stable_sum f * cA f); [field_simplify; [lra | assumption ..] |].
    intros H. apply Rmult_integral in H. tauto. }
  rewrite E. unfold plus, minus, stable_sum, sgn.
  destruct (Rlt_dec (cB f) 0); [left | right]; split; f_equal; lra.
Qed.

(** ** The discriminants without cancellation: differences of squared lengths, by Lagrange's identity *)

Definition cross (a b : Vector) : Vector :=
  mk_Vector (Vector_y a * Vector_z b - Vector_z a * Vector_y b) (Vector_z a * Vector_x b - Vector_x a * Vector_z b)
            (Vector_x a * Vector_y b - Vector_y a * Vector_x b).
Definition combine (x : R) (a : Vector) (y : R) (b : Vector) : Vector :=
  mk_Vector (x * Vector_x a + y * Vector_x b) (x * Vector_y a + y * Vector_y b) (x * Vector_z a + y * Vector_z b).
(** a − (a·d)·d: the part of a across the axis. *)
Definition across (d a : Vector) : Vector := combine 1 a (- dot a d) d.

Lemma lagrange a b : dot a b * dot a b - sq a * sq b = - sq (cross a b).
Proof. unfold sq, dot, cross; cbn. ring. Qed.
Lemma dot_across d a b : dot (across d a) (across d b) = dot a b - (2 - sq d) * (dot a d * dot b d).
Proof. unfold across, sq, dot, combine; cbn. ring. Qed.
Lemma sq_combine x a y b : sq (combine x a y b) = x * x * sq a + 2 * x * y * dot a b + y * y * sq b.
Proof. unfold sq, dot, combine; cbn. ring. Qed.
Lemma dot_sym a b : dot a b = dot b a.
Proof. unfold dot. ring. Qed.

(** Sphere: D = r²·A − |q0 × v|². *)
Theorem discriminant_esfera ray c r : let v := Rayo_v ray in let q := from c (Rayo_p ray) in
  discriminant (of_esfera ray c r) = r * r * sq v - sq (cross q v).
Proof. cbn. unfold discriminant; cbn. pose proof (lagrange (from c (Rayo_p ray)) (Rayo_v ray)). lra. Qed.

(** Truncated cone: with a and b the parts of v and q0 across the axis, and ρ = r + k·(h − s0) the radius at the ray's
    origin, D = |ρ·a + k·s1·b|² − |b × a|². For at t the point is at b + t·a from the axis, where the radius is
    ρ − k·s1·t. *)
Theorem discriminant_tronco ray c r k d h : let a := across d (Rayo_v ray) in let b := across d (from c (Rayo_p ray)) in
  let rho := r + k * (h - dot (from c (Rayo_p ray)) d) in
  discriminant (of_tronco ray c r k d h) = sq (combine rho a (k * dot (Rayo_v ray) d) b) - sq (cross b a).
Proof.
  intros a b rho. rewrite sq_combine, (dot_sym a b). pose proof (lagrange b a) as L.
  pose proof (dot_across d (Rayo_v ray) (Rayo_v ray) : sq a = _) as Haa.
  pose proof (dot_across d (from c (Rayo_p ray)) (from c (Rayo_p ray)) : sq b = _) as Hbb.
  pose proof (dot_across d (from c (Rayo_p ray)) (Rayo_v ray) : dot b a = _) as Hba.
  unfold discriminant; cbn. fold rho. set (a1 := dot (Rayo_v ray) d) in *. fold (sq (Rayo_v ray)) in Haa.
  fold (sq (from c (Rayo_p ray))) in Hbb. rewrite <- Hbb, <- Hba.
  replace (sq (Rayo_v ray) - (2 - sq d + k * k) * (a1 * a1)) with (sq a - k * k * (a1 * a1)) by (rewrite Haa; ring).
  transitivity (rho * rho * sq a + 2 * rho * (k * a1) * dot b a + k * a1 * (k * a1) * sq b
    + (dot b a * dot b a - sq b * sq a)); [ring | lra].
Qed.

(** Cylinder, of proportion 0: D = r²·|a|² − |b × a|². *)
Theorem discriminant_cilindro ray c r d h : let a := across d (Rayo_v ray) in let b := across d (from c (Rayo_p ray)) in
  discriminant (of_cilindro ray c r d h) = r * r * sq a - sq (cross b a).
Proof.
  intros a b. rewrite of_cilindro_is_tronco, discriminant_tronco, sq_combine. fold a b. ring.
Qed.

(** Cone, of radius 0: with g = h − s0, D = k²·|g·a + s1·b|² − |b × a|². *)
Theorem discriminant_cono ray c k d h : let a := across d (Rayo_v ray) in let b := across d (from c (Rayo_p ray)) in
  let g := h - dot (from c (Rayo_p ray)) d in
  discriminant (of_cono ray c k d h) = k * k * sq (combine g a (dot (Rayo_v ray) d) b) - sq (cross b a).
Proof.
  intros a b g. rewrite of_cono_is_tronco, discriminant_tronco, !sq_combine. fold a b g. ring.
Qed.

(** Plane: D = B², and B is half of v·d. *)
Theorem discriminant_plano ray c d : let a1 := dot (Rayo_v ray) d in
  discriminant (of_plano ray c d) = a1 / 2 * (a1 / 2).
Proof. unfold discriminant; cbn. ring. Qed.

(** In a plane that the ray is not parallel to, the one root is −C/2B; in one that it is parallel to, there is none, or
    the whole line lies in it. *)
Theorem roots_plano ray c d : let a0 := dot (from c (Rayo_p ray)) d in let a1 := dot (Rayo_v ray) d in
  (a1 <> 0 -> roots (of_plano ray c d) = these [- a0 / a1])
  /\ (a1 = 0 -> a0 <> 0 -> roots (of_plano ray c d) = these [])
  /\ (a1 = 0 -> a0 = 0 -> roots (of_plano ray c d) = every).
Proof.
  intros a0 a1. unfold roots, of_plano; cbn. fold a0 a1. destruct (Req_EM_T 0 0) as [_ | N]; [| easy].
  split; [intros H | split; intros H H0]; destruct (Req_EM_T (a1 / 2) 0); try lra.
  - do 2 f_equal. now field.
  - now destruct (Req_EM_T a0 0).
  - now destruct (Req_EM_T a0 0).
Qed.

(** ** The first hit of one element *)

Inductive First := First_hit (t : R) | First_miss | First_no_minimum.

Definition reach (f : coefficients) : set R := fun t => 0 < t /\ value f t = 0 /\ within f t.
Definition starts_in (T : set R) : Prop := exists eps, 0 < eps /\ forall t, 0 < t < eps -> T t.
Definition is_least (T : set R) (t : R) : Prop := T t /\ forall t', T t' -> t <= t'.
Definition is_first (T : set R) (x : First) : Prop :=
  match x with
  | First_hit t => is_least T t
  | First_miss => forall t, ~ T t
  | First_no_minimum => starts_in T
  end.

Lemma passes_dec f t : {0 < t /\ within f t} + {~ (0 < t /\ within f t)}.
Proof.
  unfold within. destruct (Rlt_dec 0 t); [| right; tauto]. destruct (clip f) as [h |]; [| left; tauto].
  destruct (Rle_dec 0 (s0 f + t * s1 f)), (Rle_dec (s0 f + t * s1 f) h); [left | right | right | right]; tauto.
Defined.
Fixpoint nearest (f : coefficients) (l : list R) : option R :=
  match l with
  | [] => None
  | t :: l' => if passes_dec f t then Some (match nearest f l' with None => t | Some t' => Rmin t t' end)
               else nearest f l'
  end.
(** Where the whole line lies in the surface: the stretch between the rims. *)
Definition first_in_surface (f : coefficients) : First :=
  match clip f with
  | None => First_no_minimum
  | Some h =>
    if Rlt_dec 0 (s1 f) then
      if Rlt_dec (s0 f) 0 then First_hit (- s0 f / s1 f) else if Rlt_dec (s0 f) h then First_no_minimum else First_miss
    else if Rlt_dec (s1 f) 0 then
      if Rlt_dec h (s0 f) then First_hit ((h - s0 f) / s1 f)
      else if Rlt_dec 0 (s0 f) then First_no_minimum else First_miss
    else if Rle_dec 0 (s0 f) then if Rle_dec (s0 f) h then First_no_minimum else First_miss else First_miss
  end.
Definition first (f : coefficients) : First :=
  match roots f with
  | every => first_in_surface f
  | these l => match nearest f l with None => First_miss | Some t => First_hit t end
  end.
Definition proper (f : coefficients) : Prop := match clip f with None => True | Some h => 0 < h end.

Lemma nearest_correct f l :
  match nearest f l with
  | None => forall t, In t l -> ~ (0 < t /\ within f t)
  | Some t => (In t l /\ 0 < t /\ within f t) /\ forall t', In t' l -> 0 < t' /\ within f t' -> t <= t'
  end.
Proof.
  induction l as [| a l IH]; cbn; [easy |]. destruct (passes_dec f a) as [Ha | Ha].
  - destruct (nearest f l) as [m |]; [destruct IH as [[Hm Hp] Hleast] |].
    + split.
      * destruct (Rle_dec a m); [rewrite Rmin_left | rewrite Rmin_right]; try lra; tauto.
      * intros t' [<- | Ht] Hp'; [apply Rmin_l |]. apply Rle_trans with m; [apply Rmin_r | now apply Hleast].
    + split; [tauto |]. intros t' [<- | Ht] Hp'; [lra |]. now destruct (IH t').
  - destruct (nearest f l) as [m |]; [destruct IH as [[Hm Hp] Hleast] |].
    + split; [tauto |]. intros t' [<- | Ht] Hp'; [tauto | now apply Hleast].
    + intros t [<- | Ht]; [exact Ha | now apply IH].
Qed.

Lemma positive_below t eps x : 0 < t < x / eps -> 0 < eps -> t * eps < x.
Proof.
  intros [_ H] He. apply Rmult_lt_compat_r with (r := eps) in H; [| exact He].
  unfold Rdiv in H. rewrite Rmult_assoc, Rinv_l, Rmult_1_r in H; lra.
Qed.

Lemma first_in_surface_correct f : proper f -> is_first (fun t => 0 < t /\ within f t) (first_in_surface f).
Proof.
  unfold proper, first_in_surface, within. destruct (clip f) as [h |].
  2: { intros _. exists 1. split; [lra | tauto]. }
  intros Hh. destruct (Rlt_dec 0 (s1 f)) as [S | S]; [| destruct (Rlt_dec (s1 f) 0) as [S' | S']].
  - destruct (Rlt_dec (s0 f) 0) as [L | L]; [| destruct (Rlt_dec (s0 f) h) as [H | H]]; cbn.
    + assert (E : - s0 f / s1 f * s1 f = - s0 f) by (field; lra). split.
      * split; [apply Rdiv_lt_0_compat; lra | rewrite E; lra].
      * intros t' [Ht [H1 _]]. apply Rmult_le_reg_r with (s1 f); lra.
    + exists ((h - s0 f) / s1 f). split; [apply Rdiv_lt_0_compat; lra |]. intros t Ht. split; [lra |].
      pose proof (positive_below _ _ _ Ht S). pose proof (Rmult_lt_0_compat t (s1 f)). lra.
    + intros t [Ht [_ H2]]. pose proof (Rmult_lt_0_compat t (s1 f) Ht S). lra.
  - destruct (Rlt_dec h (s0 f)) as [L | L]; [| destruct (Rlt_dec 0 (s0 f)) as [H | H]]; cbn.
    + assert (E : (h - s0 f) / s1 f * s1 f = h - s0 f) by (field; lra). split.
      * split; [| rewrite E; lra]. replace ((h - s0 f) / s1 f) with ((s0 f - h) / (- s1 f)) by (field; lra).
        apply Rdiv_lt_0_compat; lra.
      * intros t' [Ht [_ H2]]. apply Rmult_le_reg_r with (- s1 f); lra.
    + exists (s0 f / (- s1 f)). split; [apply Rdiv_lt_0_compat; lra |]. intros t Ht. split; [lra |].
      pose proof (positive_below t (- s1 f) (s0 f) Ht). pose proof (Rmult_lt_0_compat t (- s1 f)). lra.
    + intros t [Ht [H1 _]]. pose proof (Rmult_lt_0_compat t (- s1 f) Ht). lra.
  - assert (Z : s1 f = 0) by lra. rewrite Z.
    destruct (Rle_dec 0 (s0 f)) as [L | L]; [destruct (Rle_dec (s0 f) h) as [H | H] |]; cbn.
    + exists 1. split; [lra |]. intros t Ht. rewrite Rmult_0_r. lra.
    + intros t Ht. rewrite Rmult_0_r in Ht. lra.
    + intros t Ht. rewrite Rmult_0_r in Ht. lra.
Qed.

(** The first hit computed for one element is right: the least of its parameters, none, or no minimum because the ray
    starts in a segment of the surface. *)
Theorem first_correct f : proper f -> is_first (reach f) (first f).
Proof.
  intros Hf. unfold first, reach. pose proof (roots_correct f) as C. destruct (roots f) as [| l]; cbn in C.
  - pose proof (first_in_surface_correct f Hf) as H. destruct (first_in_surface f) as [t | |]; cbn in *.
    + destruct H as [[Hp Hw] Hleast]. split; [rewrite C; tauto |]. intros t' Ht. apply Hleast. tauto.
    + intros t Ht. apply (H t). tauto.
    + destruct H as [eps [He H]]. exists eps. split; [exact He |]. intros t Ht. specialize (H t Ht). rewrite C. tauto.
  - pose proof (nearest_correct f l) as N. destruct (nearest f l) as [t |]; cbn.
    + destruct N as [[Hl [Hp Hw]] Hleast]. split; [rewrite C; tauto |]. intros t' Ht. rewrite C in Ht. apply Hleast; tauto.
    + intros t Ht. rewrite C in Ht. apply (N t); tauto.
Qed.

(** A ray meets an element in at most two points, or the whole line lies in the unbounded surface and what the clip
    leaves of the ray is one segment. *)
Theorem two_points_or_a_segment f :
  (exists t1 t2, forall t, reach f t -> t = t1 \/ t = t2)
  \/ ((forall t, value f t = 0)
      /\ forall a b t, reach f a -> reach f b -> a <= t <= b -> reach f t).
Proof.
  pose proof (roots_correct f) as C. unfold roots in C.
  destruct (Req_EM_T (cA f) 0); [destruct (Req_EM_T (cB f) 0); [destruct (Req_EM_T (cC f) 0) |] |
    destruct (Rlt_dec (discriminant f) 0); [| destruct (Req_EM_T (stable_sum f) 0)]]; cbn in C.
  1: { right. split; [intros t; now apply C |]. intros a b t [Ha [_ Wa]] [Hb [_ Wb]] Ht.
       split; [lra |]. split; [now apply C |]. unfold within in *. destruct (clip f) as [h |]; [| exact I].
       destruct (Rle_dec 0 (s1 f)) as [S | S].
       - pose proof (Rmult_le_compat_r (s1 f) a t). pose proof (Rmult_le_compat_r (s1 f) t b). lra.
       - pose proof (Rmult_le_compat_r (- s1 f) a t). pose proof (Rmult_le_compat_r (- s1 f) t b). lra. }
  all: left; do 2 eexists; intros t [_ [H _]]; apply C in H; cbn in H.
  - destruct H.
  - destruct H as [<- | []]. now left.
  - destruct H.
  - destruct H as [<- | []]. now left.
  - destruct H as [<- | [<- | []]]; [now left | now right].
  Unshelve. all: exact 0.
Qed.

(** A ray never lies in a sphere: it meets it in at most two points. *)
Theorem esfera_at_most_two ray c r : Rayo_ok ray ->
  exists t1 t2, forall t, reach (of_esfera ray c r) t -> t = t1 \/ t = t2.
Proof.
  intros ok. destruct (two_points_or_a_segment (of_esfera ray c r)) as [H | [H _]]; [exact H | exfalso].
  pose proof (ray_direction_positive ray ok). generalize (H 0) (H 1) (H (-1)).
  clear H.
  unfold value; cbn. lra.
Qed.
