(** The closed forms of the tracer: the roots of A·t² + 2B·t + C in every case, the discriminants without cancellation,
    and the first hit of one element.

    roots f              == every t solves it, or the list of the solutions
    solves R t           == t is among them
    nearest f l          == the least t > 0 of the list l that passes the clip
    first f              == the first hit of an element: First_hit t, First_miss or First_no_minimum
    reach f              == the parameters t > 0 of the points of the ray on the element
    is_first T x         == x is the first hit of the set T of parameters
    starts_in T          == T contains every parameter from 0 to some ε > 0
    proper f             == the bounds of f are convex: what they leave of a line is one segment, or nothing
    starts g             == the bound g holds from 0 to some ε > 0
    entry g              == where g begins to hold, if it does so at a t > 0
    linear_roots a0 a1 S == S are the solutions of a0 + a1·t = 0 *)
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

(** Plane, disc and triangle: D = B², and B is half of v·d, or of v·n where n is the triangle's normal. *)
Theorem discriminant_plano ray c d : let a1 := dot (Rayo_v ray) d in
  discriminant (of_plano ray c d) = a1 / 2 * (a1 / 2).
Proof. unfold discriminant; cbn. ring. Qed.
Theorem discriminant_disco ray c r d : let a1 := dot (Rayo_v ray) d in
  discriminant (of_disco ray c r d) = a1 / 2 * (a1 / 2).
Proof. unfold discriminant; cbn. ring. Qed.
Theorem discriminant_triangulo ray abc : let a1 := dot (Rayo_v ray) (normal abc) in
  discriminant (of_triangulo ray abc) = a1 / 2 * (a1 / 2).
Proof. unfold discriminant; cbn -[normal]. ring. Qed.

(** In a plane that the ray is not parallel to, the one root is −C/2B; in one that it is parallel to, there is none, or
    the whole line lies in it. *)
Definition linear_roots (a0 a1 : R) (S : solutions) : Prop :=
  (a1 <> 0 -> S = these [- a0 / a1]) /\ (a1 = 0 -> a0 <> 0 -> S = these []) /\ (a1 = 0 -> a0 = 0 -> S = every).
Lemma roots_linear a0 a1 gs : linear_roots a0 a1 (roots (mk_coefficients 0 (a1 / 2) a0 gs)).
Proof.
  unfold linear_roots, roots; cbn. destruct (Req_EM_T 0 0) as [_ | N]; [| easy].
  split; [intros H | split; intros H H0]; destruct (Req_EM_T (a1 / 2) 0); try lra.
  - do 2 f_equal. now field.
  - now destruct (Req_EM_T a0 0).
  - now destruct (Req_EM_T a0 0).
Qed.
Theorem roots_plano ray c d : linear_roots (dot (from c (Rayo_p ray)) d) (dot (Rayo_v ray) d) (roots (of_plano ray c d)).
Proof. apply roots_linear. Qed.
Theorem roots_disco ray c r d :
  linear_roots (dot (from c (Rayo_p ray)) d) (dot (Rayo_v ray) d) (roots (of_disco ray c r d)).
Proof. apply roots_linear. Qed.
Theorem roots_triangulo ray abc :
  linear_roots (dot (from (Terna_a abc) (Rayo_p ray)) (normal abc)) (dot (Rayo_v ray) (normal abc))
    (roots (of_triangulo ray abc)).
Proof. apply roots_linear. Qed.

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

Definition passes_dec f t : {0 < t /\ within f t} + {~ (0 < t /\ within f t)} :=
  and_dec (Rlt_dec 0 t) (Forall_dec (fun g => excess g t <= 0) (fun g => Rle_dec (excess g t) 0) (clip f)).
Fixpoint nearest (f : coefficients) (l : list R) : option R :=
  match l with
  | [] => None
  | t :: l' => if passes_dec f t then Some (match nearest f l' with None => t | Some t' => Rmin t t' end)
               else nearest f l'
  end.
(** Whether a convex bound holds on a stretch that begins at the ray's origin. *)
Definition starts (g : bound) : Prop := bC g < 0 \/ bC g = 0 /\ (bB g < 0 \/ bB g = 0 /\ bA g = 0).
Definition starts_dec g : {starts g} + {~ starts g} :=
  or_dec (Rlt_dec (bC g) 0) (and_dec (Req_EM_T (bC g) 0)
    (or_dec (Rlt_dec (bB g) 0) (and_dec (Req_EM_T (bB g) 0) (Req_EM_T (bA g) 0)))).
(** The lesser root of A·t² + 2B·t + C where C > 0 > B, stable, and right for A = 0 as well. *)
Definition entry (g : bound) : R := bC g / (sqrt (bB g * bB g - bA g * bC g) - bB g).
(** Where the whole line lies in the surface: what the bounds leave of it begins at 0, or where one of them begins. *)
Definition first_in_surface (f : coefficients) : First :=
  if Forall_dec starts starts_dec (clip f) then First_no_minimum
  else match nearest f (map entry (clip f)) with None => First_miss | Some t => First_hit t end.
Definition first (f : coefficients) : First :=
  match roots f with
  | every => first_in_surface f
  | these l => match nearest f l with None => First_miss | Some t => First_hit t end
  end.
Definition proper (f : coefficients) : Prop := Forall (fun g => 0 <= bA g) (clip f).

(** The bounds of every type are convex: those of a stretch and of a triangle are linear, that of a disc is a ball's. *)
Lemma proper_esfera ray c r : proper (of_esfera ray c r).
Proof. constructor. Qed.
Lemma proper_plano ray c d : proper (of_plano ray c d).
Proof. constructor. Qed.
Lemma proper_tronco ray c r k d h : proper (of_tronco ray c r k d h).
Proof.
  unfold proper, of_tronco, between; cbn [clip]. rewrite !Forall_cons_iff; cbn. do 2 (split; [lra |]). constructor.
Qed.
Lemma proper_cilindro ray c r d h : proper (of_cilindro ray c r d h).
Proof. rewrite of_cilindro_is_tronco. apply proper_tronco. Qed.
Lemma proper_cono ray c k d h : proper (of_cono ray c k d h).
Proof. rewrite of_cono_is_tronco. apply proper_tronco. Qed.
Lemma proper_disco ray c r d : proper (of_disco ray c r d).
Proof. unfold proper; cbn. rewrite Forall_cons_iff. split; [apply sq_nonneg | constructor]. Qed.
Lemma proper_triangulo ray abc : proper (of_triangulo ray abc).
Proof.
  unfold proper, of_triangulo; cbn [clip]. rewrite !Forall_cons_iff; cbn. do 3 (split; [lra |]). constructor.
Qed.

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

(** ** What convex bounds leave of a line *)

Lemma nonpositive_product x y : 0 <= x -> y <= 0 -> x * y <= 0.
Proof. intros Hx Hy. pose proof (Rmult_le_pos x (- y)). lra. Qed.

(** A convex bound holds between two parameters at which it holds. *)
Lemma excess_between g a b t : 0 <= bA g -> excess g a <= 0 -> excess g b <= 0 -> a <= t <= b -> excess g t <= 0.
Proof.
  unfold excess. intros HA Ha Hb Ht. destruct (Req_dec a b) as [<- | N]; [now replace t with a by lra |].
  assert (E : (b - a) * (bA g * (t * t) + 2 * bB g * t + bC g)
    = (b - t) * (bA g * (a * a) + 2 * bB g * a + bC g) + (t - a) * (bA g * (b * b) + 2 * bB g * b + bC g)
      - bA g * ((b - a) * ((t - a) * (b - t)))) by ring.
  assert (0 <= (b - a) * ((t - a) * (b - t))) as P by (repeat apply Rmult_le_pos; lra).
  pose proof (Rmult_le_pos _ _ HA P).
  assert ((b - t) * (bA g * (a * a) + 2 * bB g * a + bC g) <= 0) by (apply nonpositive_product; lra).
  assert ((t - a) * (bA g * (b * b) + 2 * bB g * b + bC g) <= 0) by (apply nonpositive_product; lra).
  apply Rmult_le_reg_l with (b - a); lra.
Qed.
Lemma bounds_between gs a b t : Forall (fun g => 0 <= bA g) gs -> Forall (fun g => excess g a <= 0) gs ->
  Forall (fun g => excess g b <= 0) gs -> a <= t <= b -> Forall (fun g => excess g t <= 0) gs.
Proof.
  rewrite !Forall_forall. intros HA Ha Hb Ht g Hg. apply (excess_between g a b t); auto.
Qed.

Lemma starts_correct g : starts g -> 0 <= bA g -> exists eps, 0 < eps /\ forall t, 0 < t < eps -> excess g t <= 0.
Proof.
  unfold starts, excess. intros S HA. destruct S as [HC | [HC [HB | [HB HA0]]]].
  - set (k := bA g + Rabs (2 * bB g) + 1). pose proof (Rabs_pos (2 * bB g)). pose proof (Rle_abs (2 * bB g)).
    exists (Rmin 1 (- bC g / k)). split; [apply Rmin_glb_lt; [lra | apply Rdiv_lt_0_compat; unfold k; lra] |].
    intros t [Ht H1]. assert (t < 1) by (apply Rlt_le_trans with (1 := H1), Rmin_l).
    assert (L : t < - bC g / k) by (apply Rlt_le_trans with (1 := H1), Rmin_r).
    apply Rmult_lt_compat_r with (r := k) in L; [| unfold k; lra].
    unfold Rdiv in L. rewrite Rmult_assoc, Rinv_l, Rmult_1_r in L by (unfold k; lra). unfold k in L.
    pose proof (Rmult_le_compat_l t (2 * bB g) (Rabs (2 * bB g))).
    assert (bA g * (t * t) <= bA g * t) by (apply Rmult_le_compat_l; [lra |]; rewrite <- (Rmult_1_r t) at 3;
      apply Rmult_le_compat_l; lra).
    lra.
  - set (k := bA g + 1). exists (- 2 * bB g / k). split; [apply Rdiv_lt_0_compat; unfold k; lra |].
    intros t [Ht H]. apply Rmult_lt_compat_r with (r := k) in H; [| unfold k; lra].
    unfold Rdiv in H. rewrite Rmult_assoc, Rinv_l, Rmult_1_r in H by (unfold k; lra). unfold k in H.
    assert (E : bA g * (t * t) + 2 * bB g * t + bC g = t * (bA g * t + 2 * bB g)) by (rewrite HC; ring).
    rewrite E. apply nonpositive_product; lra.
  - exists 1. split; [lra |]. intros t _. rewrite HC, HB, HA0. lra.
Qed.
(** A bound that starts and holds at b > 0 holds all the way there. *)
Lemma starts_until g b t : starts g -> 0 <= bA g -> excess g b <= 0 -> 0 < t <= b -> excess g t <= 0.
Proof.
  intros S HA Hb Ht. destruct (starts_correct g S HA) as [eps [Heps H]].
  assert (Hm : 0 < Rmin t eps / 2 < eps).
  { pose proof (Rmin_r t eps). pose proof (Rmin_glb_lt t eps 0). lra. }
  apply (excess_between g (Rmin t eps / 2) b t HA); [now apply H | exact Hb |]. pose proof (Rmin_l t eps). lra.
Qed.
(** A bound that does not start, and yet holds at some b > 0, begins to hold at its entry. *)
Lemma entry_correct g b : ~ starts g -> 0 <= bA g -> 0 < b -> excess g b <= 0 ->
  0 < entry g <= b /\ excess g (entry g) <= 0 /\ bB g < 0 /\ 0 <= bB g * bB g - bA g * bC g.
Proof.
  unfold starts. intros N HA Hb He. pose proof He as He'. unfold excess in He'.
  pose proof (Rmult_le_pos _ _ HA (Rle_0_sqr b)) as HAb. unfold Rsqr in HAb.
  assert (HC : 0 < bC g).
  { destruct (Rtotal_order (bC g) 0) as [H | [H | H]]; [tauto | | exact H].
    destruct (Rtotal_order (bB g) 0) as [H' | [H' | H']]; [tauto | |].
    - destruct HA as [HA | HA]; [| symmetry in HA; tauto]. rewrite H, H' in He'.
      pose proof (Rmult_lt_0_compat _ _ HA (Rmult_lt_0_compat _ _ Hb Hb)). lra.
    - pose proof (Rmult_lt_0_compat _ _ H' Hb). lra. }
  assert (HB : bB g < 0).
  { apply Rnot_le_lt. intros HB. pose proof (Rmult_le_pos _ _ HB (Rlt_le _ _ Hb)). lra. }
  assert (HD : 0 <= bB g * bB g - bA g * bC g).
  { pose proof (Rmult_le_compat_l _ _ _ HA He') as H. rewrite Rmult_0_r in H.
    pose proof (Rle_0_sqr (bA g * b + bB g)) as Q. unfold Rsqr in Q. lra. }
  unfold entry. set (r := sqrt _). assert (Hr : r * r = bB g * bB g - bA g * bC g) by now apply sqrt_sqrt.
  assert (Hr0 : 0 <= r) by apply sqrt_pos. set (z := r - bB g). assert (Hz : 0 < z) by (unfold z; lra).
  assert (Ez : z * (z + 2 * bB g) = - (bA g * bC g)) by (unfold z; lra).
  assert (Root : excess g (bC g / z) = 0).
  { unfold excess. apply Rmult_eq_reg_l with (z * z); [| now apply Rgt_not_eq, Rmult_lt_0_compat].
    transitivity (bC g * (z * (z + 2 * bB g) + bA g * bC g)); [field; lra | rewrite Ez; ring]. }
  split; [split; [now apply Rdiv_lt_0_compat |] | split; [lra | now split]]. set (e := bC g / z) in *.
  apply Rnot_lt_le. intros L. assert (S : bA g * e + bB g = - r).
  { apply Rmult_eq_reg_r with z; [| lra]. unfold e. transitivity (bA g * bC g + bB g * z); [field; lra |].
    unfold z in *. lra. }
  assert (E : excess g b - excess g e = bA g * ((e - b) * (e - b)) + 2 * (r * (e - b))).
  { unfold excess. replace r with (- (bA g * e + bB g)) by lra. ring. }
  assert (0 < (e - b) * (e - b)) by (apply Rmult_lt_0_compat; lra).
  destruct HA as [HA | HA].
  - pose proof (Rmult_lt_0_compat _ _ HA H). pose proof (Rmult_le_pos r (e - b)). lra.
  - rewrite <- HA in *. assert (r = - bB g) by lra. pose proof (Rmult_lt_0_compat r (e - b)). lra.
Qed.

(** Where convex bounds hold at a t > 0, they all start; or they begin to hold at one of their entries, and never
    before. *)
Lemma bounds_begin gs t : Forall (fun g => 0 <= bA g) gs -> 0 < t -> Forall (fun g => excess g t <= 0) gs ->
  Forall starts gs
  \/ exists g, In g gs /\ ~ starts g /\ let e := entry g in 0 < e <= t /\ Forall (fun g => excess g e <= 0) gs
     /\ forall t', 0 < t' -> Forall (fun g => excess g t' <= 0) gs -> e <= t'.
Proof.
  intros HA Ht H. induction gs as [| g gs IH]; [now left |].
  inversion_clear HA as [| ? ? HAg HAs]. inversion_clear H as [| ? ? Hg Hs]. specialize (IH HAs Hs).
  destruct (starts_dec g) as [S | S].
  - destruct IH as [IH | [g' [Hin [S' [He [Hall Hleast]]]]]]; [left; now constructor | right]. exists g'.
    split; [now right | split; [exact S' | split; [exact He | split]]].
    + constructor; [now apply (starts_until g t) | exact Hall].
    + intros t' Ht' H'. inversion_clear H'. now apply Hleast.
  - right. destruct (entry_correct g t S HAg Ht Hg) as [Hl [He _]].
    assert (Least : forall t', 0 < t' -> excess g t' <= 0 -> entry g <= t').
    { intros t' Ht' H'. now apply (entry_correct g t' S HAg). }
    destruct IH as [IH | [g' [Hin [S' [Hle [Hall Hleast]]]]]].
    + exists g. split; [now left | split; [exact S | split; [exact Hl | split]]].
      * constructor; [exact He |]. rewrite Forall_forall in *. intros g' Hg'. apply (starts_until g' t); auto.
      * intros t' Ht' H'. inversion_clear H'. now apply Least.
    + destruct (Rle_dec (entry g') (entry g)) as [L | L].
      * exists g. split; [now left | split; [exact S | split; [exact Hl | split]]].
        -- constructor; [exact He |]. apply (bounds_between gs (entry g') t); auto; lra.
        -- intros t' Ht' H'. inversion_clear H'. now apply Least.
      * exists g'. split; [now right | split; [exact S' | split; [exact Hle | split]]].
        -- constructor; [apply (excess_between g (entry g) t); auto; lra | exact Hall].
        -- intros t' Ht' H'. inversion_clear H'. now apply Hleast.
Qed.
Lemma bounds_start gs : Forall (fun g => 0 <= bA g) gs -> Forall starts gs ->
  starts_in (fun t => 0 < t /\ Forall (fun g => excess g t <= 0) gs).
Proof.
  induction gs as [| g gs IH]; intros HA S; [exists 1; split; [lra | intros t Ht; split; [lra | constructor]] |].
  inversion_clear HA as [| ? ? HAg HAs]. inversion_clear S as [| ? ? Sg Ss].
  destruct (starts_correct g Sg HAg) as [eg [Heg Hg]], (IH HAs Ss) as [es [Hes Hs]]. exists (Rmin eg es).
  split; [now apply Rmin_glb_lt |]. intros t Ht. pose proof (Rmin_l eg es). pose proof (Rmin_r eg es).
  split; [lra |]. constructor; [apply Hg | apply Hs]; lra.
Qed.

Lemma first_in_surface_correct f : proper f -> is_first (fun t => 0 < t /\ within f t) (first_in_surface f).
Proof.
  unfold proper, first_in_surface. intros HA. destruct (Forall_dec starts starts_dec (clip f)) as [S | S].
  - exact (bounds_start _ HA S).
  - assert (B : forall t, 0 < t -> within f t ->
      exists e, In e (map entry (clip f)) /\ (0 < e /\ within f e) /\ e <= t).
    { intros t Ht H. destruct (bounds_begin _ t HA Ht H) as [S' | [g [Hin [_ [He [Hall _]]]]]]; [easy |].
      exists (entry g). split; [now apply in_map | split; [split; [apply He | exact Hall] | apply He]]. }
    pose proof (nearest_correct f (map entry (clip f))) as N. destruct (nearest f _) as [m |]; cbn.
    + destruct N as [[_ Hm] Hleast]. split; [exact Hm |]. intros t [Ht H].
      destruct (B t Ht H) as [e [Hin [He Hle]]]. apply Rle_trans with e; [now apply Hleast | exact Hle].
    + intros t [Ht H]. destruct (B t Ht H) as [e [Hin [He _]]]. now apply (N e).
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
Theorem two_points_or_a_segment f : proper f ->
  (exists t1 t2, forall t, reach f t -> t = t1 \/ t = t2)
  \/ ((forall t, value f t = 0)
      /\ forall a b t, reach f a -> reach f b -> a <= t <= b -> reach f t).
Proof.
  intros Hp. pose proof (roots_correct f) as C. unfold roots in C.
  destruct (Req_EM_T (cA f) 0); [destruct (Req_EM_T (cB f) 0); [destruct (Req_EM_T (cC f) 0) |] |
    destruct (Rlt_dec (discriminant f) 0); [| destruct (Req_EM_T (stable_sum f) 0)]]; cbn in C.
  1: { right. split; [intros t; now apply C |]. intros a b t [Ha [_ Wa]] [Hb [_ Wb]] Ht.
       split; [lra |]. split; [now apply C |]. exact (bounds_between _ a b t Hp Wa Wb Ht). }
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
  intros ok. destruct (two_points_or_a_segment (of_esfera ray c r) ltac:(constructor)) as [H | [H _]];
    [exact H | exfalso].
  pose proof (ray_direction_positive ray ok). generalize (H 0) (H 1) (H (-1)).
  clear H.
  unfold value; cbn. lra.
Qed.
