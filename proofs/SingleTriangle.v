(** * SingleTriangle: what is computed of a triangle in binary32, and what it may err by

    src/trace/screen-inl.hpp takes the edges e1 = b - a and e2 = c - a, and q = p - a, where p is rounded in two parts, and
    makes triple products of them, fused or not. Where the line of a ray meets a triangle, three of these products have one
    sign.

    near3 n a x m  == each component of a is computed for x's, of the size of m's at most, and no error is absolute
    total m        == the sum of the components
    outer a b r    == r is computed for a × b, fused or not;  inner a b r == for a·b
    size m l h     == total m times total l times total h: the bound of a triple product
    X_fl           == X, computed;  room p == what the rounding of p in two parts takes *)
From Coq Require Import Reals ZArith Lra Lia Psatz.
From Flocq Require Import Core.
From Durero Require Import Toolkit Especificacion Tipos Puntos Flat Single.
Local Open Scope R_scope.
Local Open Scope zed_scope.
Local Opaque bpow.

Notation G := (bpow radix2 33).
Notation tiny := (bpow radix2 (-100)).

Definition near3 (n : nat) (a x m : Vector) : Prop :=
  near n 0 (Vector_x a) (Vector_x x) (Vector_x m) /\ near n 0 (Vector_y a) (Vector_y x) (Vector_y m)
  /\ near n 0 (Vector_z a) (Vector_z x) (Vector_z m).
Definition total (m : Vector) : R := Vector_x m + Vector_y m + Vector_z m.
Definition size (m l h : Vector) : R := total m * (total l * total h).
Definition outer (a b r : Vector) : Prop :=
  fused (Vector_y a) (Vector_z b) (- fl (Vector_z a * Vector_y b)) (Vector_x r)
  /\ fused (Vector_z a) (Vector_x b) (- fl (Vector_x a * Vector_z b)) (Vector_y r)
  /\ fused (Vector_x a) (Vector_y b) (- fl (Vector_y a * Vector_x b)) (Vector_z r).
Definition inner (a b : Vector) (r : R) : Prop := exists s,
  fused (Vector_y a) (Vector_y b) (fl (Vector_x a * Vector_x b)) s /\ fused (Vector_z a) (Vector_z b) s r.

Lemma powers : 0 < eta /\ 1000000 * eta <= bpow radix2 (-117) /\ G * eta = bpow radix2 (-117)
  /\ tiny = 131072 * bpow radix2 (-117) /\ u = 16777216 * (u * u).
Proof.
  repeat split.
  - apply bpow_gt_0.
  - replace (bpow radix2 (-117)) with (8589934592 * eta); [pose proof (bpow_gt_0 radix2 (-150)); lra |].
    change 8589934592 with (bpow radix2 33). now rewrite <- bpow_plus.
  - now rewrite <- bpow_plus.
  - change 131072 with (bpow radix2 17). now rewrite <- bpow_plus.
  - change 16777216 with (bpow radix2 24). now rewrite <- !bpow_plus.
Qed.
Notation atom := (bpow radix2 (-117)).

(** ** Triple products *)

Lemma product_of_inputs j k b c y z l h : near j 0 b y l -> near k 0 c z h -> (j <= 12)%nat -> near (j + k) 0 (b * c) (y * z) (l
  * h).
Proof. intros B C Hj. replace 0 with (2 * l * 0) by ring. now apply near_mult. Qed.

Lemma difference_of_products j k b c d e y z y' z' l h l' h' r : near j 0 b y l -> near k 0 c z h -> near j 0 d y' l' ->
  near k 0 e z' h' -> (j <= 12)%nat -> fused b c (- fl (d * e)) r ->
  near (S (S (j + k))) (8 * eta) r (y * z - y' * z') (l * h + l' * h').
Proof.
  intros B C D E Hj H. apply near_more with (S (S (j + k))) (4 * (0 + (2 * 0 + eta)) + 4 * eta) (l * h + l' * h'); try lra;
  [| lia].
  unfold Rminus. apply (near_fused _ 0 (2 * 0 + eta) b c (- fl (d * e))); [now apply product_of_inputs | | exact H].
  now apply near_opp, near_fl, product_of_inputs.
Qed.

Lemma sum_of_products i n a x m d w s r : near3 i a x m -> total m <= G -> (i <= 12)%nat ->
  near n (8 * eta) (Vector_x d) (Vector_x w) (Vector_x s) -> near n (8 * eta) (Vector_y d) (Vector_y w) (Vector_y s) ->
  near n (8 * eta) (Vector_z d) (Vector_z w) (Vector_z s) -> inner a d r ->
  near (i + n + 3) (1024 * atom) r (dot x w)
    (Vector_x m * Vector_x s + Vector_y m * Vector_y s + Vector_z m * Vector_z s).
Proof.
  intros (X & Y & Z) Hm Hi DX DY DZ (t & H1 & H2). destruct powers as (P0 & P1 & P2 & _).
  pose proof (near_positive _ _ _ _ _ X) as MX. pose proof (near_positive _ _ _ _ _ Y) as MY.
  pose proof (near_positive _ _ _ _ _ Z) as MZ. unfold total in Hm.
  assert (Hone : forall a0 x0 m0 d0 w0 s0, near i 0 a0 x0 m0 -> near n (8 * eta) d0 w0 s0 -> m0 <= G ->
    near (i + n) (16 * atom) (a0 * d0) (x0 * w0) (m0 * s0)).
  { intros a0 x0 m0 d0 w0 s0 A D L. pose proof (near_positive _ _ _ _ _ A).
    apply near_more with (i + n)%nat (2 * m0 * (8 * eta)) (m0 * s0); [now apply near_mult | lia | | lra].
    assert (m0 * eta <= G * eta) by (apply Rmult_le_compat_r; lra). lra. }
  pose proof (near_fl _ _ _ _ _ (Hone _ _ _ _ _ _ X DX ltac:(lra))) as F1.
  pose proof (near_fused _ _ _ _ _ _ _ _ _ _ _ (Hone _ _ _ _ _ _ Y DY ltac:(lra)) F1 H1) as F2.
  pose proof (near_more _ (S (i + n)) _ (16 * atom) _ _ _ _ (Hone _ _ _ _ _ _ Z DZ ltac:(lra)) ltac:(lia) ltac:(lra)
    (Rle_refl _)) as F3.
  pose proof (near_fused _ _ _ _ _ _ _ _ _ _ _ F3 F2 H2) as F4.
  replace (dot x w) with (Vector_z x * Vector_z w + (Vector_y x * Vector_y w + Vector_x x * Vector_x w)) by (unfold dot; ring).
  apply near_more with (1 := F4); [lia | lra | lra].
Qed.

Lemma triple_near i j k a x m b y l c z h d r : near3 i a x m -> near3 j b y l -> near3 k c z h -> total m <= G ->
  (i <= 12)%nat -> (j <= 12)%nat -> outer b c d -> inner a d r ->
  near (i + j + k + 5) (1024 * atom) r (dot x (cross y z)) (size m l h).
Proof.
  intros A (BX & BY & BZ) (CX & CY & CZ) Hm Hi Hj (H1 & H2 & H3) H.
  pose proof (difference_of_products _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ BY CZ BZ CY Hj H1) as DX.
  pose proof (difference_of_products _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ BZ CX BX CZ Hj H2) as DY.
  pose proof (difference_of_products _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ BX CY BY CX Hj H3) as DZ.
  pose proof (sum_of_products i _ a x m d (cross y z) (mk_Vector _ _ _) r A Hm Hi DX DY DZ H) as N.
  apply near_more with (1 := N); [lia | lra |]. unfold size, total. cbn.
  destruct A as (AX & AY & AZ).
  pose proof (near_positive _ _ _ _ _ AX). pose proof (near_positive _ _ _ _ _ AY). pose proof (near_positive _ _ _ _ _ AZ).
  pose proof (near_positive _ _ _ _ _ BX). pose proof (near_positive _ _ _ _ _ BY). pose proof (near_positive _ _ _ _ _ BZ).
  pose proof (near_positive _ _ _ _ _ CX). pose proof (near_positive _ _ _ _ _ CY). pose proof (near_positive _ _ _ _ _ CZ).
  assert (P : forall f g e, 0 <= f -> 0 <= g -> 0 <= e -> 0 <= f * (g * e)) by (intros; repeat apply Rmult_le_pos; assumption).
  destruct m as [m1 m2 m3], l as [l1 l2 l3], h as [h1 h2 h3]. cbn in *.
  pose proof (P m1 l1 h1). pose proof (P m1 l1 h2). pose proof (P m1 l1 h3). pose proof (P m1 l2 h1). pose proof (P m1 l2 h2).
  pose proof (P m1 l3 h1). pose proof (P m1 l3 h3). pose proof (P m2 l1 h1). pose proof (P m2 l1 h2). pose proof (P m2 l2 h1).
  pose proof (P m2 l2 h2). pose proof (P m2 l2 h3). pose proof (P m2 l3 h2). pose proof (P m2 l3 h3). pose proof (P m3 l1 h1).
  pose proof (P m3 l1 h3). pose proof (P m3 l2 h2). pose proof (P m3 l2 h3). pose proof (P m3 l3 h1). pose proof (P m3 l3 h2).
  pose proof (P m3 l3 h3). lra.
Qed.
(** ** The three products where the line meets the triangle *)

Lemma products_of_a_hit ray abc t : 0 < sq (normal abc) -> point_at ray t ∈ puntos_triangulo abc ->
  let E1 := from (Terna_a abc) (Terna_b abc) in let E2 := from (Terna_a abc) (Terna_c abc) in
  let T := from (Terna_a abc) (Rayo_p ray) in let v := Rayo_v ray in let det := dot E1 (cross v E2) in
  exists x y z, 0 <= x /\ 0 <= y /\ 0 <= z /\ x + y + z = 1 /\ dot E2 (cross T E1) = t * det
  /\ dot v (cross T E1) = x * det /\ det - dot T (cross v E2) - dot v (cross T E1) = y * det
  /\ dot T (cross v E2) = z * det.
Proof.
  intros N [[L1 [L2 L3]] H] E1 E2 T v det. set (n := sq (normal abc)) in *. set (w := point_at ray t) in *.
  assert (Ht : dot E2 (cross T E1) - t * det = 0) by (transitivity (potencia_triangulo w abc); [symmetry;
  exact (proj1 (power_of_the_program ray abc t)) | exact H]).
  destruct (det_swapped ray abc) as [S1 [S2 [S3 S4]]]. destruct (sides_by_edges w abc) as [K1 [K2 K3]]. cbv zeta in *.
  unfold w in K1, K2. rewrite !from_point_at in K1, K2. fold w in K1, K2. fold E1 E2 T v in S1, S2, S3, S4, K1, K2.
  fold det in S1. fold n in S4, K3.
  assert (H1 : lado w (Terna_a abc) (Terna_b abc) (Terna_c abc) * det = n * dot v (cross T E1)).
  { rewrite K1. pose proof (side_identity T v E1 E2 t) as I. fold det in I. rewrite Ht in I.
    replace n with (sq (cross E1 E2)) by reflexivity. rewrite I. ring. }
  assert (H2 : lado w (Terna_c abc) (Terna_a abc) (Terna_b abc) * det = n * dot T (cross v E2)).
  { rewrite K2. pose proof (side_identity T v E2 E1 t) as I. rewrite S1, S2, S3, S4 in I.
    replace (- dot E2 (cross T E1) - t * - det) with 0 in I by lra. lra. }
  set (l1 := lado w (Terna_a abc) (Terna_b abc) (Terna_c abc)) in *.
  set (l2 := lado w (Terna_b abc) (Terna_c abc) (Terna_a abc)) in *.
  set (l3 := lado w (Terna_c abc) (Terna_a abc) (Terna_b abc)) in *.
  assert (P : forall l, 0 <= l -> 0 <= l / n) by (intros; apply Rmult_le_pos; [assumption | now apply Rlt_le, Rinv_0_lt_compat]).
  exists (l1 / n), (l2 / n), (l3 / n). repeat split; auto.
  - transitivity ((l1 + l2 + l3) / n); [field; lra |]. rewrite K3. field. lra.
  - lra.
  - transitivity (l1 * det / n); [rewrite H1; field; lra | field; lra].
  - transitivity ((n - l1 - l3) * det / n); [| rewrite <- K3; field; lra].
    replace ((n - l1 - l3) * det) with (n * det - l1 * det - l3 * det) by ring. rewrite H1, H2. field. lra.
  - transitivity (l3 * det / n); [rewrite H2; field; lra | field; lra].
Qed.

(** ** What is computed of a ray and a triangle *)

Definition magnitudes (a : Vector) : Vector := mk_Vector (Rabs (Vector_x a)) (Rabs (Vector_y a)) (Rabs (Vector_z a)).
Definition extent (a : Vector) : R := total (magnitudes a).
Definition extent_fl (a : Vector) : R :=
  fl (fl (Rabs (Vector_x a) + Rabs (Vector_y a)) + Rabs (Vector_z a)).
Definition single_point (p : Punto) : Prop := single (Punto_x p) /\ single (Punto_y p) /\ single (Punto_z p).
Definition from_fl (a b : Punto) : Vector :=
  mk_Vector (fl (Punto_x b - Punto_x a)) (fl (Punto_y b - Punto_y a)) (fl (Punto_z b - Punto_z a)).
(** The way from a vertex to p, which is rounded in two parts. *)
Definition way (a p : R) : R := fl (fl (fl p - a) + fl (p - fl p)).
Definition way_fl (a p : Punto) : Vector :=
  mk_Vector (way (Punto_x a) (Punto_x p)) (way (Punto_y a) (Punto_y p)) (way (Punto_z a) (Punto_z p)).
Definition direction_fl (v : Vector) : Vector := mk_Vector (fl (Vector_x v)) (fl (Vector_y v)) (fl (Vector_z v)).
(** No component of a direction underflows. *)
Definition ordinary (x : R) : Prop := x = 0 \/ bpow radix2 (-126) <= Rabs x.

Lemma near_ordinary x : ordinary x -> near 1 0 (fl x) x (Rabs x).
Proof. intros H. pose proof (fl_ordinary x H). repeat split; cbn; lra. Qed.

Lemma near_difference a b : single a -> single b -> near 1 0 (fl (b - a)) (b - a) (Rabs (b - a)).
Proof.
  intros Fa Fb. pose proof (fl_plus b (- a) Fb (single_opp _ Fa) : Rabs (fl (b - a) - (b - a)) <= u * Rabs (b - a)).
  repeat split; cbn; lra.
Qed.

Definition room (p : R) : R := 8 * u * Rabs p + tiny / 3.

Lemma near_way a p : single a -> near 2 0 (way a p) (p - a) (Rabs (p - a) + room p).
Proof.
  intros Fa. unfold way, room. set (P := fl p). pose proof (fl_near p : Rabs (P - p) <= _) as N0.
  pose proof (fl_near (p - P)) as N1.
  pose proof (fl_plus P (- a) (single_fl p) (single_opp _ Fa) : Rabs (fl (P - a) - (P - a)) <= _) as N2.
  pose proof (fl_plus _ _ (single_fl (P - a)) (single_fl (p - P))) as N3.
  set (s := fl (P - a)) in *. set (r := fl (p - P)) in *.
  pose proof (Rabs_pos (p - a)) as X. pose proof (Rabs_pos p) as Y. pose proof powers as (P0 & _). pose proof u_value as U.
  destruct powers as (_ & P1 & _ & P3 & _).
  assert (A0 : Rabs (p - P) <= u * Rabs p + eta) by (rewrite Rabs_minus_sym; exact N0).
  assert (A1 : Rabs (r - (p - P)) <= u * (u * Rabs p + eta) + eta).
  { apply Rle_trans with (1 := N1). assert (u * Rabs (p - P) <= u * (u * Rabs p + eta)) by (apply Rmult_le_compat_l;
    [apply bpow_ge_0 | exact A0]). lra. }
  assert (A2 : Rabs (P - a) <= Rabs (p - a) + (u * Rabs p + eta)).
  { replace (P - a) with ((p - a) + (P - p)) by ring. apply Rle_trans with (1 := Rabs_triang _ _). lra. }
  assert (A3 : Rabs (s + r - (p - a)) <= u * (Rabs (p - a) + (u * Rabs p + eta)) + (u * (u * Rabs p + eta) + eta)).
  { replace (s + r - (p - a)) with ((s - (P - a)) + (r - (p - P))) by ring. apply Rle_trans with (1 := Rabs_triang _ _).
    change (P + - a) with (P - a) in N2. assert (u * Rabs (P - a) <= u * (Rabs (p - a) + (u * Rabs p + eta)))
      by (apply Rmult_le_compat_l; [apply bpow_ge_0 | exact A2]). lra. }
  assert (A4 : Rabs (s + r) <= Rabs (p - a) + Rabs (s + r - (p - a))).
  { replace (s + r) with ((p - a) + (s + r - (p - a))) at 1 by ring. apply Rabs_triang. }
  assert (A5 : Rabs (fl (s + r) - (p - a)) <= u * Rabs (s + r) + Rabs (s + r - (p - a))).
  { replace (fl (s + r) - (p - a)) with ((fl (s + r) - (s + r)) + (s + r - (p - a))) by ring.
    apply Rle_trans with (1 := Rabs_triang _ _). lra. }
  repeat split; [| rewrite U in *; lra | lra]. apply Rle_trans with (1 := A5). cbn. rewrite U in *. lra.
Qed.

Lemma extent_positive a : 0 <= extent a.
Proof.
  unfold extent, total, magnitudes. cbn. pose proof (Rabs_pos (Vector_x a)). pose proof (Rabs_pos (Vector_y a)).
  pose proof (Rabs_pos (Vector_z a)). lra.
Qed.
Lemma extent_low a : single (Vector_x a) -> single (Vector_y a) -> single (Vector_z a) ->
  (1 - 2 * u) * extent a <= extent_fl a /\ 0 <= extent a.
Proof.
  intros FX FY FZ. unfold extent, total, extent_fl, magnitudes. cbn.
  pose proof (Rabs_pos (Vector_x a)). pose proof (Rabs_pos (Vector_y a)). pose proof (Rabs_pos (Vector_z a)).
  pose proof (sum_low _ _ (single_abs _ FX) (single_abs _ FY) ltac:(assumption) ltac:(assumption)) as S1.
  assert (P : 0 <= fl (Rabs (Vector_x a) + Rabs (Vector_y a))) by (rewrite <- fl_0; apply fl_le; lra).
  pose proof (sum_low _ _ (single_fl (Rabs (Vector_x a) + Rabs (Vector_y a))) (single_abs _ FZ) P ltac:(assumption)) as S2.
  rewrite u_value in *. lra.
Qed.

Lemma near3_extent n a x m : (n <= 2)%nat -> near3 n a x m -> extent x - (201 / 100) * u * total m <= extent a.
Proof.
  intros Hn (X & Y & Z).
  assert (Hone : forall f g e, near n 0 f g e -> Rabs g - (201 / 100) * u * e <= Rabs f).
  { intros f g e H. pose proof (near_error n 0 f g e ltac:(lia) H) as N. pose proof (near_positive _ _ _ _ _ H).
    assert (I : INR n <= 2) by (apply (le_INR n 2) in Hn; simpl in Hn; lra).
    assert (Rabs g <= Rabs f + Rabs (f - g)).
    { replace g with (f - (f - g)) at 1 by ring. apply Rle_trans with (1 := Rabs_triang _ _). rewrite Rabs_Ropp. lra. }
    assert ((INR n + / 100) * u * e <= (201 / 100) * u * e).
    { apply Rmult_le_compat_r; [assumption |]. apply Rmult_le_compat_r; [apply bpow_ge_0 | lra]. }
    lra. }
  pose proof (Hone _ _ _ X). pose proof (Hone _ _ _ Y). pose proof (Hone _ _ _ Z). unfold extent, total, magnitudes in *. cbn.
  lra.
Qed.

Lemma extent_fl_positive x : 0 <= extent_fl x.
Proof.
  unfold extent_fl. rewrite <- fl_0. apply fl_le.
  assert (0 <= fl (Rabs (Vector_x x) + Rabs (Vector_y x))).
  { rewrite <- fl_0. apply fl_le. pose proof (Rabs_pos (Vector_x x)). pose proof (Rabs_pos (Vector_y x)). lra. }
  pose proof (Rabs_pos (Vector_z x)). lra.
Qed.
Definition size_of_point (p : Punto) : R := Rabs (Punto_x p) + Rabs (Punto_y p) + Rabs (Punto_z p).
Lemma size_of_point_positive p : 0 <= size_of_point p.
Proof.
  unfold size_of_point. pose proof (Rabs_pos (Punto_x p)). pose proof (Rabs_pos (Punto_y p)). pose proof (Rabs_pos (Punto_z p)).
  lra.
Qed.

(** The edge between two points of binary32, and what its extent is computed to be. *)
Lemma edge_near a b : single_point a -> single_point b -> near3 1 (from_fl a b) (from a b) (magnitudes (from a b)).
Proof. intros (A1 & A2 & A3) (B1 & B2 & B3). (split; [| split]); cbn; apply near_difference; assumption. Qed.
Lemma edge_low a b : single_point a -> single_point b -> (1 - 5 * u) * extent (from a b) <= extent_fl (from_fl a b).
Proof.
  intros A B. destruct (extent_low (from_fl a b)) as [H _]; try (cbn; apply single_fl).
  pose proof (near3_extent 1 _ _ _ ltac:(lia) (edge_near a b A B)) as N.
  pose proof (extent_positive (from a b)) as P.
  change (total (magnitudes (from a b))) with (extent (from a b)) in N. rewrite u_value in *. lra.
Qed.
