(** * AtRootText: the quadratic of the text at a parameter is within the error that is computed

    AtRoot.v, AtRootAxial.v and AtRootTriangle.v, of an element of a scene: at a root of which the slope is not 0, what the
    tracer computes of the quadratic is within its bound, and the bound is not so small that anything underflows beside it.

    power_of p v sh t  == potencia at the parameter t, and a bound on its error, of the element with the numbers sh
    at_root p v sh on t == the same of what the ray is asked: less that at the origin where it starts on the element *)
From Coq Require Import Reals ZArith Lra Lia Psatz List.
From Flocq Require Import Core.
From Durero Require Import Toolkit Especificacion Escena Puntos Trazador Interseccion.
From Durero Require Tipos Formas.
From Durero Require Import Rounding Vectors Flotante Steps Triage Twofold Loose AtRoot AtRootAxial AtRootTriangle.
Local Open Scope R_scope.
Local Open Scope zed_scope.
Local Opaque bpow.

Definition power_of (p v : vec) (sh : shape) (t : R) : Formas.known Formas.Pairs.twofold :=
  let V := Formas.speed_of v in
  match sh with
  | Sphere c r => Formas.Powers.esfera t p v V c r
  | Cylinder c r d h => Formas.Powers.cilindro t p v V c r d h
  | Cone c k d h => Formas.Powers.cono t p v V c k d h
  | Truncated c r k d h => Formas.Powers.tronco t p v V c r k d h
  | Plane c d => Formas.Powers.plano t p v V c d
  | Disc c r d => Formas.Powers.disco t p v V c r d
  | Triangle a b c => Formas.Powers.triangulo t p v V a b c
  end.
Definition at_root (p v : vec) (sh : shape) (on : bool) (t : R) : Formas.known Formas.Pairs.twofold :=
  if on then Formas.Powers.launched (power_of p v sh t) (power_of p v sh 0) else power_of p v sh t.

(** ** How steep a quadratic can be at a root *)

Lemma root_slope A B C T : A * (T * T) + 2 * B * T + C = 0 -> (A * T + B) * (A * T + B) = B * B - A * C.
Proof. intros H; replace C with (- (A * (T * T) + 2 * B * T)) by lra; ring. Qed.

Lemma steepness A B C T kappa b : 1 <= kappa -> 0 <= b -> Rabs A <= 3 * kappa * b -> Rabs B <= 7 * kappa * b -> Rabs C <= 11 * kappa * b ->
  A * (T * T) + 2 * B * T + C = 0 -> Rabs (A * T + B) <= 10 * kappa * b.
Proof.
  intros Hk Hb HA HB HC Hroot; pose proof (root_slope A B C T Hroot) as E; set (s := A * T + B) in *.
  assert (Hkb : 0 <= kappa * b) by (apply Rmult_le_pos; lra).
  apply Rsqr_incr_0_var; [|lra]; rewrite <- Rsqr_abs; unfold Rsqr; rewrite E.
  assert (HBB : B * B <= 7 * kappa * b * (7 * kappa * b)).
  { pose proof (Rsqr_abs B) as Q; unfold Rsqr in Q; rewrite Q; apply Rmult_le_compat; auto using Rabs_pos. }
  assert (HAC : Rabs (A * C) <= 3 * kappa * b * (11 * kappa * b)) by (rewrite Rabs_mult; apply Rmult_le_compat; auto using Rabs_pos).
  apply Rabs_le_inv in HAC; pose proof (Rle_0_sqr (kappa * b)) as Q; unfold Rsqr in Q.
  replace (10 * kappa * b * (10 * kappa * b)) with (100 * (kappa * b * (kappa * b))) by ring.
  replace (7 * kappa * b * (7 * kappa * b)) with (49 * (kappa * b * (kappa * b))) in HBB by ring.
  replace (3 * kappa * b * (11 * kappa * b)) with (33 * (kappa * b * (kappa * b))) in HAC by ring; lra.
Qed.

Lemma dot_size a b m n : Rabs (cx a) <= m -> Rabs (cy a) <= m -> Rabs (cz a) <= m -> Rabs (cx b) <= n -> Rabs (cy b) <= n ->
  Rabs (cz b) <= n -> Rabs (dot a b) <= 3 * (m * n).
Proof.
  intros Ax Ay Az Bx By Bz; unfold dot.
  assert (P : forall x y, Rabs x <= m -> Rabs y <= n -> Rabs (x * y) <= m * n).
  { intros x y Hx Hy; rewrite Rabs_mult; apply Rmult_le_compat; auto using Rabs_pos. }
  pose proof (P _ _ Ax Bx) as H1; pose proof (P _ _ Ay By) as H2; pose proof (P _ _ Az Bz) as H3.
  apply Rabs_le_inv in H1, H2, H3; apply Rabs_le; lra.
Qed.

Section Text.
Variables p v : vec.
Hypothesis ray_ordinary : ordinary_ray p v.
Notation ray := (ray_of p v).
Notation big := (bpow radix2 100).

Lemma sizes_of a : ordinary_vec a -> Rabs (cx a) <= big /\ Rabs (cy a) <= big /\ Rabs (cz a) <= big.
Proof. intros (X & Y & Z0); split; [|split]; now apply ordinary_size. Qed.

Lemma big_size : 1 <= big.
Proof. exact (bpow_le radix2 0 100 ltac:(lia)). Qed.

(** The coefficients of what has an axis, in units of κ and of the square of a length that all numbers are below. *)
Lemma axial_sizes c r k d h : ordinary_vec c -> ordinary_vec d -> Rabs (dot d d - 1) <= / 1000000 -> 0 <= r <= big -> 0 <= k -> 0 <= h <= big ->
  let f := of_tronco ray (point c) r k (direction d) h in let b := 64 * (big * big) in
  Rabs (cA f) <= 3 * (1 + k * k) * b /\ Rabs (cB f) <= 7 * (1 + k * k) * b /\ Rabs (cC f) <= 11 * (1 + k * k) * b.
Proof.
  intros Hc Hd Hdd Hr Hk Hh f b; destruct (sizes_of p (p_ordinary ray_ordinary)) as (Px & Py & Pz), (sizes_of v (v_ordinary
    ray_ordinary)) as (Vx & Vy & Vz).
  destruct (sizes_of c Hc) as (Cx & Cy & Cz), (axis_components d Hdd) as (Dx & Dy & Dz); pose proof big_size as HG; set (G := big) in *.
  assert (Two : forall x y, Rabs x <= G -> Rabs y <= G -> Rabs (x - y) <= 2 * G).
  { intros x y Hx Hy; apply Rabs_le_inv in Hx, Hy; apply Rabs_le; lra. }
  set (q := minus p c); pose proof (Two _ _ Px Cx : Rabs (cx q) <= 2 * G) as Qx.
  pose proof (Two _ _ Py Cy : Rabs (cy q) <= 2 * G) as Qy; pose proof (Two _ _ Pz Cz : Rabs (cz q) <= 2 * G) as Qz.
  pose proof (dot_size v v G G Vx Vy Vz Vx Vy Vz) as Hvv; pose proof (dot_size q v _ _ Qx Qy Qz Vx Vy Vz) as Hqv.
  pose proof (dot_size q q _ _ Qx Qy Qz Qx Qy Qz) as Hqq; pose proof (dot_size v d _ _ Vx Vy Vz Dx Dy Dz) as Hvd.
  pose proof (dot_size q d _ _ Qx Qy Qz Dx Dy Dz) as Hqd.
  assert (EA : cA f = dot v v - (2 - dot d d + k * k) * (dot v d * dot v d)) by reflexivity.
  assert (EB : cB f = dot q v - (2 - dot d d) * (dot q d * dot v d) + (r + k * (h - dot q d)) * k * dot v d) by reflexivity.
  assert (EC : cC f = dot q q - (2 - dot d d) * (dot q d * dot q d) - (r + k * (h - dot q d)) * (r + k * (h - dot q d))) by reflexivity.
  rewrite EA, EB, EC; clear EA EB EC f; set (vv := dot v v) in *; set (qv := dot q v) in *; set (qq := dot q q) in *.
  set (a1 := dot v d) in *; set (a0 := dot q d) in *; set (n := 2 - dot d d).
  assert (Hn : 0 <= n <= 2) by (apply Rabs_le_inv in Hdd; unfold n; lra).
  assert (H1 : Rabs a1 <= 4 * G) by lra; assert (H0 : Rabs a0 <= 8 * G) by lra.
  set (K := k * k); assert (HK : 0 <= K) by (apply Rmult_le_pos; assumption).
  assert (Hk2 : k <= (1 + K) / 2) by (pose proof (Rle_0_sqr (k - 1)) as Q; unfold Rsqr, K in *; lra).
  set (w := h - a0); assert (Hw : Rabs w <= 9 * G) by (apply Rabs_le_inv in H0; unfold w; apply Rabs_le; lra).
  assert (Prod : forall x y m l, Rabs x <= m -> Rabs y <= l -> Rabs (x * y) <= m * l).
  { intros x y m l Hx Hy; rewrite Rabs_mult; apply Rmult_le_compat; auto using Rabs_pos. }
  assert (Kp : Rabs k <= k) by (rewrite Rabs_pos_eq; lra); assert (Np : Rabs n <= 2) by (rewrite Rabs_pos_eq; lra).
  assert (NKp : Rabs (n + K) <= 2 + K) by (rewrite Rabs_pos_eq; lra).
  pose proof (Prod _ _ _ _ H1 H1) as H11; pose proof (Prod _ _ _ _ H0 H1) as H01; pose proof (Prod _ _ _ _ H0 H0) as H00.
  pose proof (Prod _ _ _ _ NKp H11) as TA; pose proof (Prod _ _ _ _ Np H01) as TB; pose proof (Prod _ _ _ _ Np H00) as TC.
  assert (Hrho : Rabs (r + k * w) <= 9 * (1 + k) * G).
  { pose proof (Prod _ _ _ _ Kp Hw) as Hkw; apply Rabs_le_inv in Hkw; pose proof (Rmult_le_pos k G Hk ltac:(lra)); apply Rabs_le; lra. }
  set (rho := r + k * w) in *; pose proof (Prod _ _ _ _ Hrho Kp) as T1; pose proof (Prod _ _ _ _ T1 H1) as T2.
  pose proof (Prod _ _ _ _ Hrho Hrho) as T3; set (G2 := G * G) in *; assert (HG2 : 0 < G2) by (apply Rmult_lt_0_compat; lra).
  assert (HkG : k * G2 <= (1 + K) / 2 * G2) by (apply Rmult_le_compat_r; lra).
  assert (HKG : 0 <= K * G2) by (apply Rmult_le_pos; lra).
  replace (9 * (1 + k) * G * k * (4 * G)) with (36 * (k * G2 + K * G2)) in T2 by (unfold G2, K; ring).
  replace (9 * (1 + k) * G * (9 * (1 + k) * G)) with (81 * (G2 + 2 * (k * G2) + K * G2)) in T3 by (unfold G2, K; ring).
  replace (4 * G * (4 * G)) with (16 * G2) in * by (unfold G2; ring); replace (8 * G * (4 * G)) with (32 * G2) in * by (unfold G2; ring).
  replace (8 * G * (8 * G)) with (64 * G2) in * by (unfold G2; ring); replace (2 * G * G) with (2 * G2) in Hqv by (unfold G2; ring).
  replace (2 * G * (2 * G)) with (4 * G2) in Hqq by (unfold G2; ring).
  apply Rabs_le_inv in Hvv, Hqv, Hqq, TA, TB, TC, T2, T3; unfold b; fold G2.
  split; [|split]; apply Rabs_le; split; lra.
Qed.

Lemma sphere_sizes c r : ordinary_vec c -> 0 <= r <= big -> let f := of_esfera ray (point c) r in let b := 64 * (big * big) in
  Rabs (cA f) <= 3 * 1 * b /\ Rabs (cB f) <= 7 * 1 * b /\ Rabs (cC f) <= 11 * 1 * b.
Proof.
  intros Hc Hr f b; destruct (sizes_of p (p_ordinary ray_ordinary)) as (Px & Py & Pz), (sizes_of v (v_ordinary ray_ordinary))
    as (Vx & Vy & Vz).
  destruct (sizes_of c Hc) as (Cx & Cy & Cz); pose proof big_size as HG; set (G := big) in *.
  assert (Two : forall x y, Rabs x <= G -> Rabs y <= G -> Rabs (x - y) <= 2 * G).
  { intros x y Hx Hy; apply Rabs_le_inv in Hx, Hy; apply Rabs_le; lra. }
  set (q := minus p c); pose proof (Two _ _ Px Cx : Rabs (cx q) <= 2 * G) as Qx.
  pose proof (Two _ _ Py Cy : Rabs (cy q) <= 2 * G) as Qy; pose proof (Two _ _ Pz Cz : Rabs (cz q) <= 2 * G) as Qz.
  pose proof (dot_size v v G G Vx Vy Vz Vx Vy Vz) as Hvv; pose proof (dot_size q v _ _ Qx Qy Qz Vx Vy Vz) as Hqv.
  pose proof (dot_size q q _ _ Qx Qy Qz Qx Qy Qz) as Hqq.
  change (cA f) with (dot v v); change (cB f) with (dot q v); change (cC f) with (dot q q - r * r).
  assert (Hrr : 0 <= r * r <= G * G) by (split; [apply Rmult_le_pos | apply Rmult_le_compat]; lra).
  assert (0 < G * G) by (apply Rmult_lt_0_compat; lra); unfold b; replace (2 * G * G) with (2 * (G * G)) in Hqv by ring.
  replace (2 * G * (2 * G)) with (4 * (G * G)) in Hqq by ring; apply Rabs_le_inv in Hvv, Hqv, Hqq.
  split; [|split]; apply Rabs_le; lra.
Qed.

(** ** Of each shape, at any parameter *)

(** At every parameter the quadratic is within its error, which is at least so much, and steeper at T than that no quotient
    with it underflows. *)
Definition sure (sh : shape) (f : coefficients) (T : R) : Prop := exists least, bpow radix2 (-900) <= least /\
  bpow radix2 (-900) * (4 * Rabs (cA f * T + cB f)) <= least /\
  forall t, format t -> powered (power_of p v sh t) (value (text_of p v sh) t) /\ least <= Formas.error (power_of p v sh t).

Lemma steep_enough A B C T kappa : 1 <= kappa -> let b := 64 * (big * big) in Rabs A <= 3 * kappa * b -> Rabs B <= 7 * kappa * b ->
  Rabs C <= 11 * kappa * b -> A * (T * T) + 2 * B * T + C = 0 ->
  bpow radix2 (-900) <= kappa * bpow radix2 (-300) /\ bpow radix2 (-900) * (4 * Rabs (A * T + B)) <= kappa * bpow radix2 (-300).
Proof.
  intros Hk b HA HB HC Hroot; pose proof big_size as HG; assert (Hb : 0 <= b) by (unfold b; pose proof (Rmult_le_pos big big); lra).
  pose proof (steepness A B C T kappa b Hk Hb HA HB HC Hroot) as H; pose proof (bpow_gt_0 radix2 (-300)); split.
  - pose proof (bpow_le radix2 (-900) (-300) ltac:(lia)); assert (1 * bpow radix2 (-300) <= kappa * bpow radix2 (-300)) by (apply Rmult_le_compat_r; lra); lra.
  - assert (E : 40 * (bpow radix2 (-900) * b) <= bpow radix2 (-300)).
    { unfold b; replace (40 * (bpow radix2 (-900) * (64 * (big * big)))) with (40 * 64 * (bpow radix2 (-900) * (big * big))) by ring.
      rewrite <- !bpow_plus; replace (-300)%Z with (400 + (-900 + (100 + 100)))%Z by reflexivity; rewrite (bpow_plus radix2 400).
      apply Rmult_le_compat_r; [apply bpow_ge_0|]; apply Rle_trans with (bpow radix2 12); [|apply bpow_le; lia].
      replace (bpow radix2 12) with 4096 by reflexivity; lra. }
    pose proof (bpow_ge_0 radix2 (-900)) as H900.
    assert (bpow radix2 (-900) * (4 * Rabs (A * T + B)) <= bpow radix2 (-900) * (4 * (10 * kappa * b))) by (apply Rmult_le_compat_l; lra).
    assert (kappa * (40 * (bpow radix2 (-900) * b)) <= kappa * bpow radix2 (-300)) by (apply Rmult_le_compat_l; lra); lra.
Qed.

Lemma curved_sure sh f T kappa : 1 <= kappa -> let b := 64 * (big * big) in let g := text_of p v sh in
  Rabs (cA g) <= 3 * kappa * b /\ Rabs (cB g) <= 7 * kappa * b /\ Rabs (cC g) <= 11 * kappa * b -> (f = g \/ f = launched g) ->
  (forall t, format t -> powered (power_of p v sh t) (value g t) /\ kappa * bpow radix2 (-300) <= Formas.error (power_of p v sh t)) ->
  value f T = 0 -> sure sh f T.
Proof.
  intros Hk b g (HA & HB & HC) Hf All Hroot; pose proof big_size; assert (Hb : 0 <= b) by (unfold b; pose proof (Rmult_le_pos big big); lra).
  exists (kappa * bpow radix2 (-300)).
  assert (Z0 : Rabs 0 <= 11 * kappa * b) by (rewrite Rabs_R0; apply Rmult_le_pos; lra).
  destruct Hf as [-> | ->]; unfold value in Hroot; cbn [launched cA cB cC] in *.
  - destruct (steep_enough _ _ _ T kappa Hk HA HB HC Hroot) as [H1 H2]; auto.
  - destruct (steep_enough _ _ 0 T kappa Hk HA HB Z0 Hroot) as [H1 H2]; auto.
Qed.

Lemma axis_exact d : direction d ∈ Unitario -> Rabs (dot d d - 1) <= 8 * u.
Proof.
  intros [L H]; destruct multiples_of_u as (_ & _ & <- & _); unfold tolerancia_unidad in *; cbn in L, H.
  replace (bpow radix2 (-50)) with (/ 1125899906842624) by reflexivity; unfold dot; apply Rabs_le; lra.
Qed.

(** Where the line is flat against the surface's plane, or its origin is in it. *)
Lemma flat_sure sh f T B : cA f = 0 -> cB f = B -> Rabs B <= bpow radix2 320 ->
  (forall t, format t -> powered (power_of p v sh t) (value (text_of p v sh) t) /\ bpow radix2 (-560) <= Formas.error (power_of p v sh t)) ->
  sure sh f T.
Proof.
  intros EA EB HB All; exists (bpow radix2 (-560)); split; [apply bpow_le; lia | split; [|exact All]].
  rewrite EA, EB, Rmult_0_l, Rplus_0_l; replace (-560)%Z with (20 + (-900 + 320))%Z by reflexivity; rewrite (bpow_plus radix2 20), (bpow_plus radix2 (-900)).
  replace (bpow radix2 20) with 1048576 by reflexivity; pose proof (bpow_ge_0 radix2 (-900)).
  assert (bpow radix2 (-900) * Rabs B <= bpow radix2 (-900) * bpow radix2 320) by (apply Rmult_le_compat_l; assumption).
  pose proof (Rmult_le_pos _ _ H (bpow_ge_0 radix2 320)); lra.
Qed.
End Text.

Section Scene.
Variable Elemento : Type.
Variable s : Especificacion.Escena Elemento.
Hypothesis ok : Escena_ok s.
Variables p v : vec.
Hypothesis ray_ordinary : ordinary_ray p v.
Notation ray := (ray_of p v).

Lemma text_value_curved sh t : match sh with Plane _ _ | Disc _ _ _ | Triangle _ _ _ => True | _ => 
  value (text_of p v sh) t = match sh with
  | Sphere c r => let e := exact_place p v t c in dot e e - r * r
  | Cylinder c r d h => let e := exact_place p v t c in dot e e - (2 - dot d d) * (dot e d * dot e d) - r * r
  | Cone c k d h => let e := exact_place p v t c in
      dot e e - (2 - dot d d) * (dot e d * dot e d) - (h - dot e d) * k * ((h - dot e d) * k)
  | Truncated c r k d h => let e := exact_place p v t c in let rho := (h - dot e d) * k + r in
      dot e e - (2 - dot d d) * (dot e d * dot e d) - rho * rho
  | _ => 0
  end end.
Proof.
  destruct sh; auto; unfold value, text_of, of_esfera, of_cilindro, of_cono, of_tronco, ray_of, point, direction, exact_place, Tipos.sq,
    Tipos.dot, from, dot; cbn; ring.
Qed.

(** Of what is flat, with the normal n at the point c. *)
Lemma flat_value sh c n t : cA (text_of p v sh) = 0 -> cB (text_of p v sh) = dot v n / 2 -> cC (text_of p v sh) = dot (minus p c) n ->
  value (text_of p v sh) t = dot (exact_place p v t c) n.
Proof. intros EA EB EC; unfold value; rewrite EA, EB, EC; unfold dot, exact_place, minus; cbn; field. Qed.

Lemma flat_of sh c n f T : cA (text_of p v sh) = 0 -> cB (text_of p v sh) = dot v n / 2 -> cC (text_of p v sh) = dot (minus p c) n ->
  f = text_of p v sh \/ f = launched (text_of p v sh) -> 0 < T -> value f T = 0 -> cA f * T + cB f <> 0 ->
  cA f = 0 /\ cB f = dot v n / 2 /\ minus p c <> Vec 0 0 0 /\ n <> Vec 0 0 0.
Proof.
  intros EA EB EC Hf HT Hroot Hs.
  assert (E : cA f = 0 /\ cB f = dot v n / 2 /\ (cC f = dot (minus p c) n \/ cC f = 0)).
  { destruct Hf as [-> | ->]; cbn [launched cA cB cC]; auto. }
  destruct E as (A0 & B0 & C0); split; [exact A0 | split; [exact B0|]]; rewrite A0, B0 in Hs; unfold value in Hroot; rewrite A0, B0 in Hroot.
  assert (NC : cC f <> 0).
  { intros Z0; rewrite Z0 in Hroot; apply Hs; assert (dot v n * T = 0) by lra; apply Rmult_integral in H as [H|H]; [rewrite H; field | lra]. }
  split; intros Z0; apply Hs || apply NC; destruct C0 as [C0|C0]; try contradiction; rewrite C0 in *; rewrite Z0 in *; unfold dot in *; cbn in *.
  - exfalso; apply NC; ring.
  - field.
Qed.

Lemma slope_of_axis d : Rabs (dot d d - 1) <= / 1000000 -> Rabs (dot v d / 2) <= bpow radix2 320.
Proof.
  intros Hd; destruct (sizes_of v (v_ordinary ray_ordinary)) as (Vx & Vy & Vz), (axis_components d Hd) as (Dx & Dy & Dz).
  pose proof (dot_size v d _ _ Vx Vy Vz Dx Dy Dz) as H; unfold Rdiv; rewrite Rabs_mult, (Rabs_pos_eq (/ 2)) by lra.
  replace 320%Z with (220 + 100)%Z by reflexivity; rewrite bpow_plus; pose proof (bpow_le radix2 2 220 ltac:(lia)) as H2.
  replace (bpow radix2 2) with 4 in H2 by reflexivity; pose proof (bpow_gt_0 radix2 100).
  assert (4 * bpow radix2 100 <= bpow radix2 220 * bpow radix2 100) by (apply Rmult_le_compat_r; lra); lra.
Qed.

Lemma slope_of_normal a b c : ordinary_vec a -> ordinary_vec b -> ordinary_vec c ->
  Rabs (dot v (cross (minus b a) (minus c a)) / 2) <= bpow radix2 320.
Proof.
  intros Ha Hb Hc; destruct (sizes_of v (v_ordinary ray_ordinary)) as (Vx & Vy & Vz), (sizes_of a Ha) as (Ax & Ay & Az).
  destruct (sizes_of b Hb) as (Bx & By & Bz), (sizes_of c Hc) as (Cx & Cy & Cz); set (G := bpow radix2 100) in *.
  assert (HG : 1 <= G) by exact (bpow_le radix2 0 100 ltac:(lia)).
  assert (Two : forall x y, Rabs x <= G -> Rabs y <= G -> Rabs (x - y) <= 2 * G).
  { intros x y Hx Hy; apply Rabs_le_inv in Hx, Hy; apply Rabs_le; lra. }
  assert (Part : forall x y x' y', Rabs x <= 2 * G -> Rabs y <= 2 * G -> Rabs x' <= 2 * G -> Rabs y' <= 2 * G ->
    Rabs (x * y - x' * y') <= 8 * (G * G)).
  { intros x y x' y' X Y X' Y'.
    assert (P : forall i j, Rabs i <= 2 * G -> Rabs j <= 2 * G -> Rabs (i * j) <= 4 * (G * G)).
    { intros i j I J; rewrite Rabs_mult; replace (4 * (G * G)) with (2 * G * (2 * G)) by ring; apply Rmult_le_compat; auto using Rabs_pos. }
    pose proof (P _ _ X Y) as H1; pose proof (P _ _ X' Y') as H2; apply Rabs_le_inv in H1, H2; apply Rabs_le; lra. }
  pose proof (dot_size v (cross (minus b a) (minus c a)) G (8 * (G * G)) Vx Vy Vz) as H.
  unfold cross in H at 1 2 3; cbn [cx cy cz minus] in H.
  specialize (H ltac:(apply Part; apply Two; assumption) ltac:(apply Part; apply Two; assumption) ltac:(apply Part; apply Two; assumption)).
  unfold Rdiv; rewrite Rabs_mult, (Rabs_pos_eq (/ 2)) by lra.
  replace 320%Z with (20 + (100 + (100 + 100)))%Z by reflexivity; rewrite !bpow_plus; fold G; replace (bpow radix2 20) with 1048576 by reflexivity.
  assert (0 <= G * (G * G)) by (repeat apply Rmult_le_pos; lra); lra.
Qed.

Theorem sure_of_element e sh (on : bool) T : stands Elemento s e sh -> ordinary_shape sh ->
  let f := if on then launched (text_of p v sh) else text_of p v sh in
  0 < T -> value f T = 0 -> cA f * T + cB f <> 0 -> sure p v sh f T.
Proof.
  intros Hs Ho f HT Hroot Hsteep.
  assert (HR : forall r, (e, r) ∈ mi_radio s -> 0 < r) by (intros; apply (Escena_decl_mi_radio ok); now exists e).
  assert (HH : forall r, (e, r) ∈ mi_altura s -> 0 < r) by (intros; apply (Escena_decl_mi_altura ok); now exists e).
  assert (HK : forall r, (e, r) ∈ mi_proporcion s -> 0 < r) by (intros; apply (Escena_decl_mi_proporcion ok); now exists e).
  assert (HD : forall d, (e, d) ∈ mi_vector s -> d ∈ Unitario) by (intros; apply (Escena_inv_8 ok); now exists e).
  assert (Ef : f = text_of p v sh \/ f = launched (text_of p v sh)) by (unfold f; destruct on; auto).
  assert (Size : forall r, ordinary r -> 0 < r -> 0 <= r <= bpow radix2 100).
  { intros r Hr Hr0; pose proof (ordinary_size r Hr) as H; rewrite Rabs_pos_eq in H; lra. }
  pose proof (text_value_curved sh) as V.
  destruct sh as [c r | c r d h | c k d h | c r k d h | c d | c r d | a b c]; cbn [ordinary_shape] in Ho.
  - destruct Hs as (_ & _ & Hr), Ho as [Oc Or]; apply HR in Hr.
    apply (curved_sure p v (Sphere c r) f T 1 (Rle_refl 1) (sphere_sizes p v ray_ordinary c r Oc (Size r Or Hr)) Ef);
    [|exact Hroot].
    intros t Ft; rewrite V; now apply sphere_powered.
  - destruct Hs as (_ & _ & Hr & Hd & Hh), Ho as (Oc & Or & Od & Oh); apply HR in Hr; apply HH in Hh; apply HD, axis_exact in Hd.
    pose proof (axial_sizes p v ray_ordinary c r 0 d h Oc Od (unit_enough d Hd) (Size r Or Hr) (Rle_refl 0) (Size h Oh Hh)) as
      Sz.
    cbv zeta in Sz; rewrite <- of_cilindro_is_tronco, Rmult_0_l, Rplus_0_r in Sz.
    apply (curved_sure p v (Cylinder c r d h) f T 1 (Rle_refl 1) Sz Ef); [|exact Hroot].
    intros t Ft; rewrite V; now apply cylinder_powered.
  - destruct Hs as (_ & _ & Hk & Hd & Hh), Ho as (Oc & Ok & Od & Oh); apply HK in Hk; apply HH in Hh; apply HD, axis_exact in Hd.
    assert (Z0 : 0 <= 0 <= bpow radix2 100) by (split; [lra | apply bpow_ge_0]).
    pose proof (axial_sizes p v ray_ordinary c 0 k d h Oc Od (unit_enough d Hd) Z0 (Rlt_le _ _ Hk) (Size h Oh Hh)) as Sz.
    cbv zeta in Sz; rewrite <- of_cono_is_tronco in Sz; pose proof (Rmult_lt_0_compat k k Hk Hk).
    apply (curved_sure p v (Cone c k d h) f T (1 + k * k) ltac:(lra) Sz Ef); [|exact Hroot].
    intros t Ft; rewrite V; now apply cone_powered.
  - destruct Hs as (_ & _ & Hr & Hk & Hd & Hh), Ho as (Oc & Or & Ok & Od & Oh); apply HR in Hr; apply HK in Hk; apply HH in Hh.
    apply HD, axis_exact in Hd; pose proof (Rmult_lt_0_compat k k Hk Hk).
    pose proof (axial_sizes p v ray_ordinary c r k d h Oc Od (unit_enough d Hd) (Size r Or Hr) (Rlt_le _ _ Hk) (Size h Oh Hh))
      as Sz.
    apply (curved_sure p v (Truncated c r k d h) f T (1 + k * k) ltac:(lra) Sz Ef); [|exact Hroot].
    intros t Ft; rewrite V; now apply truncated_powered.
  - destruct Hs as (_ & _ & Hd), Ho as [Oc Od]; apply HD, axis_exact, unit_enough in Hd.
    destruct (flat_of (Plane c d) c d f T) as (EA & EB & Np & _); [reflexivity | reflexivity | reflexivity | exact Ef | exact HT | exact Hroot | exact Hsteep|].
    apply (flat_sure p v (Plane c d) f T (dot v d / 2) EA EB (slope_of_axis d Hd)); intros t Ft.
    rewrite (flat_value (Plane c d) c d t) by reflexivity; now apply plane_powered.
  - destruct Hs as (_ & _ & _ & Hd), Ho as (Oc & _ & Od); apply HD, axis_exact, unit_enough in Hd.
    destruct (flat_of (Disc c r d) c d f T) as (EA & EB & Np & _); [reflexivity | reflexivity | reflexivity | exact Ef | exact HT | exact Hroot | exact Hsteep|].
    apply (flat_sure p v (Disc c r d) f T (dot v d / 2) EA EB (slope_of_axis d Hd)); intros t Ft.
    rewrite (flat_value (Disc c r d) c d t) by reflexivity; now apply (plane_powered p v t).
  - destruct Ho as (Oa & Ob & Oc); set (n := cross (minus b a) (minus c a)).
    destruct (flat_of (Triangle a b c) a n f T) as (EA & EB & Np & Nn); [reflexivity | reflexivity | reflexivity | exact Ef | exact HT | exact Hroot | exact Hsteep|].
    apply (flat_sure p v (Triangle a b c) f T (dot v n / 2) EA EB (slope_of_normal a b c Oa Ob Oc)); intros t Ft.
    rewrite (flat_value (Triangle a b c) a n t) by reflexivity; apply triangle_powered; auto.
    + intros Z0; apply Nn; unfold n; rewrite Z0; unfold cross; cbn; f_equal; ring.
    + intros Z0; apply Nn; unfold n; rewrite Z0; unfold cross; cbn; f_equal; ring.
Qed.

(** So what a step of Newton's asks of the quadratic is so. *)
Theorem at_root_right e sh (on : bool) t T : stands Elemento s e sh -> ordinary_shape sh -> format t ->
  let f := if on then launched (text_of p v sh) else text_of p v sh in
  0 < T -> value f T = 0 -> cA f * T + cB f <> 0 -> let q := at_root p v sh on t in
  within_error q (value f t) /\ bpow radix2 (-900) <= Formas.error q /\
  bpow radix2 (-900) * (4 * Rabs (cA f * T + cB f)) <= Formas.error q.
Proof.
  intros Hs Ho Ft f HT Hroot Hsteep q; destruct (sure_of_element e sh on T Hs Ho HT Hroot Hsteep) as (least & L & St & All).
  destruct (All t Ft) as [P E]; fold f in St.
  enough (H : within_error q (value f t) /\ Formas.error (power_of p v sh t) <= Formas.error q).
  { destruct H as [H1 H2]; split; [exact H1 | split; lra]. }
  unfold q, f, at_root; destruct on; [|split; [now apply powered_within | apply Rle_refl]].
  destruct (All 0 (generic_format_0 _ _)) as [P0 _].
  replace (value (launched (text_of p v sh)) t) with (value (text_of p v sh) t - value (text_of p v sh) 0)
    by (unfold value, launched; cbn; ring); now apply launched_within.
Qed.
End Scene.
