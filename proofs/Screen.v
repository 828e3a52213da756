(** * Screen: the test of triangles in binary32 is right

    src/trace/screen-inl.hpp computes, in binary32 with e1 = b - a, e2 = c - a and q = p - a,
      det = e1·(v × e2),  C = e2·(q × e1),  ca = q·(v × e2),  ab = v·(q × e1),  bc = det - ca - ab
    and for margin the least of ca, ab and bc, each turned by the sign of det. It says that a line misses the triangle, or
    that it meets it and where, only by the bounds that are proved here.

    terms, computed ray abc s == the numbers that it computes;  s has them of this ray and triangle
    in_range ray abc          == what it asks of them before
    placed s t t_error        == the parameter and its bound are computed so;  bounds t t_error t' == t' is within *)
From Coq Require Import Reals ZArith Lra Lia Psatz.
From Flocq Require Import Core.
From Durero Require Import Toolkit Especificacion Tipos Puntos Flat Single SingleTriangle.
Local Open Scope R_scope.
Local Open Scope zed_scope.
Local Opaque bpow.

(** The numbers that are computed, and how: extents of edges and of the way to p are of what was rounded; slack and rate,
    8u|p| + tiny and 12u|v|, come from binary64. *)
Record terms := Terms { v_e2 : Vector; q_e1 : Vector; det_fl : R; ca_fl : R; ab_fl : R; C_fl : R;
  slack : R; rate : R; middle : R; error : R; det_error : R; C_error : R }.

Definition edge1 (abc : Terna) : Vector := from_fl (Terna_a abc) (Terna_b abc).
Definition edge2 (abc : Terna) : Vector := from_fl (Terna_a abc) (Terna_c abc).
Definition way_of (ray : Rayo) (abc : Terna) : Vector := way_fl (Terna_a abc) (Rayo_p ray).
Definition way_extent (ray : Rayo) (abc : Terna) (s : terms) : R := fl (extent_fl (way_of ray abc) + slack s).
Definition area (abc : Terna) : R := fl (extent_fl (edge1 abc) * extent_fl (edge2 abc)).

Definition computed (ray : Rayo) (abc : Terna) (s : terms) : Prop :=
  let w := direction_fl (Rayo_v ray) in let q := way_of ray abc in let e1 := edge1 abc in let e2 := edge2 abc in
  outer w e2 (v_e2 s) /\ outer q e1 (q_e1 s) /\ inner e1 (v_e2 s) (det_fl s) /\ inner q (v_e2 s) (ca_fl s)
  /\ inner w (q_e1 s) (ab_fl s) /\ inner e2 (q_e1 s) (C_fl s)
  /\ single (slack s) /\ (1 - 2 * u) * (8 * u * size_of_point (Rayo_p ray) + tiny) <= slack s
  /\ (1 - 2 * u) * (12 * u * extent (Rayo_v ray)) <= rate s <= G
  /\ fused (way_extent ray abc s) (fl (extent_fl e1 + extent_fl e2)) (area abc) (middle s)
  /\ fused (rate s) (middle s) tiny (error s) /\ fused (rate s) (area abc) tiny (det_error s)
  /\ fused (fl (12 * u * way_extent ray abc s)) (area abc) tiny (C_error s).

(** What the program asks before it tests: the coordinates of triangles are numbers of binary32, and all numbers are in range,
    so that nothing overflows. *)
Definition in_range (ray : Rayo) (abc : Terna) : Prop :=
  single_point (Terna_a abc) /\ single_point (Terna_b abc) /\ single_point (Terna_c abc)
  /\ ordinary (Vector_x (Rayo_v ray)) /\ ordinary (Vector_y (Rayo_v ray)) /\ ordinary (Vector_z (Rayo_v ray))
  /\ extent (Rayo_v ray) <= G /\ extent (from (Terna_a abc) (Terna_b abc)) <= G
  /\ extent (from (Terna_a abc) (Terna_c abc)) <= G
  /\ extent (from (Terna_a abc) (Rayo_p ray)) + 8 * u * size_of_point (Rayo_p ray) + tiny <= G.

Section Screen.
Variables (ray : Rayo) (abc : Terna) (s : terms).
Hypothesis I : in_range ray abc.
Hypothesis K : computed ray abc s.

Let a := Terna_a abc.
Let v := Rayo_v ray.
Let E1 := from a (Terna_b abc).
Let E2 := from a (Terna_c abc).
Let T := from a (Rayo_p ray).
Let V := extent v.
Let L1 := extent E1.
Let L2 := extent E2.
Let sizes : Vector := mk_Vector (Rabs (Vector_x T) + room (Punto_x (Rayo_p ray)))
  (Rabs (Vector_y T) + room (Punto_y (Rayo_p ray))) (Rabs (Vector_z T) + room (Punto_z (Rayo_p ray))).
Let Q := total sizes.
Let det := dot E1 (cross v E2).
Let ca := dot T (cross v E2).
Let ab := dot v (cross T E1).
Let C := dot E2 (cross T E1).
Definition bc_fl : R := fl (fl (det_fl s - ca_fl s) - ab_fl s).

Lemma edge1_near : near3 1 (edge1 abc) E1 (magnitudes E1).
Proof. destruct I as (A & B & _). now apply edge_near. Qed.
Lemma edge2_near : near3 1 (edge2 abc) E2 (magnitudes E2).
Proof. destruct I as (A & _ & B & _). now apply edge_near. Qed.
Lemma way_near : near3 2 (way_of ray abc) T sizes.
Proof. destruct I as ((A1 & A2 & A3) & _). (split; [| split]); cbn; apply near_way; assumption. Qed.
Lemma direction_near : near3 1 (direction_fl v) v (magnitudes v).
Proof. destruct I as (_ & _ & _ & D1 & D2 & D3 & _). (split; [| split]); cbn; apply near_ordinary; assumption. Qed.

Lemma Q_value : Q = extent T + (8 * u * size_of_point (Rayo_p ray) + tiny).
Proof. unfold Q, sizes, total, extent, total, magnitudes, room, size_of_point. cbn. field. Qed.
Lemma ranges : 0 <= V <= G /\ 0 <= L1 <= G /\ 0 <= L2 <= G /\ tiny <= Q <= G.
Proof.
  destruct I as (_ & _ & _ & _ & _ & _ & H1 & H2 & H3 & H4). fold a v E1 E2 T in H1, H2, H3, H4. rewrite Q_value.
  pose proof (extent_positive v). pose proof (extent_positive E1). pose proof (extent_positive E2).
  pose proof (extent_positive T).
  assert (0 <= 8 * u * size_of_point (Rayo_p ray)) by (pose proof (size_of_point_positive (Rayo_p ray)); rewrite u_value; lra).
  unfold V, L1, L2. repeat split; lra.
Qed.

(** *** The triple products *)

Lemma det_near : near 8 (1024 * atom) (det_fl s) det (V * (L1 * L2)).
Proof.
  destruct K as (H1 & _ & H2 & _). destruct ranges as (_ & (_ & R) & _).
  replace (V * (L1 * L2)) with (size (magnitudes E1) (magnitudes v) (magnitudes E2)) by (unfold size, V, L1, L2, extent; ring).
  exact (triple_near 1 1 1 _ _ _ _ _ _ _ _ _ _ _ edge1_near direction_near edge2_near R ltac:(lia) ltac:(lia) H1 H2).
Qed.
Lemma ca_near : near 9 (1024 * atom) (ca_fl s) ca (V * (Q * L2)).
Proof.
  destruct K as (H1 & _ & _ & H2 & _). destruct ranges as (_ & _ & _ & (_ & R)).
  replace (V * (Q * L2)) with (size sizes (magnitudes v) (magnitudes E2)) by (unfold size, V, L2, extent; fold Q; ring).
  exact (triple_near 2 1 1 _ _ _ _ _ _ _ _ _ _ _ way_near direction_near edge2_near R ltac:(lia) ltac:(lia) H1 H2).
Qed.
Lemma ab_near : near 9 (1024 * atom) (ab_fl s) ab (V * (Q * L1)).
Proof.
  destruct K as (_ & H1 & _ & _ & H2 & _). destruct ranges as ((_ & R) & _).
  replace (V * (Q * L1)) with (size (magnitudes v) sizes (magnitudes E1)) by (unfold size, V, L1, extent; fold Q; ring).
  exact (triple_near 1 2 1 _ _ _ _ _ _ _ _ _ _ _ direction_near way_near edge1_near R ltac:(lia) ltac:(lia) H1 H2).
Qed.
Lemma C_near : near 9 (1024 * atom) (C_fl s) C (Q * (L1 * L2)).
Proof.
  destruct K as (_ & H1 & _ & _ & _ & H2 & _). destruct ranges as (_ & _ & (_ & R) & _).
  replace (Q * (L1 * L2)) with (size (magnitudes E2) sizes (magnitudes E1)) by (unfold size, L1, L2, extent; fold Q; ring).
  exact (triple_near 1 2 1 _ _ _ _ _ _ _ _ _ _ _ edge2_near way_near edge1_near R ltac:(lia) ltac:(lia) H1 H2).
Qed.
Let M := L1 * L2 + Q * (L1 + L2).
Lemma bc_near : near 11 (20000 * atom) bc_fl (det - ca - ab) (V * M).
Proof.
  destruct powers as (P0 & P1 & _).
  assert (N1 : near 10 (2 * (1024 * atom + 1024 * atom) + eta) (fl (det_fl s - ca_fl s)) (det - ca) (V * (L1 * L2) + V * (Q *
  L2))).
  { apply near_fl. unfold Rminus. apply near_plus; [| now apply near_opp, ca_near].
    apply near_more with (1 := det_near); [lia | lra | lra]. }
  assert (N2 : near 10 (1024 * atom) (- ab_fl s) (- ab) (V * (Q * L1))).
  { apply near_opp. apply near_more with (1 := ab_near); [lia | lra | lra]. }
  pose proof (near_fl _ _ _ _ _ (near_plus _ _ _ _ _ _ _ _ _ N1 N2)) as N.
  apply near_more with (1 := N); [lia | lra |]. unfold M. lra.
Qed.

(** *** The bounds *)

Lemma L1_low : (1 - 5 * u) * L1 <= extent_fl (edge1 abc).
Proof. destruct I as (A & B & _). now apply edge_low. Qed.
Lemma L2_low : (1 - 5 * u) * L2 <= extent_fl (edge2 abc).
Proof. destruct I as (A & _ & B & _). now apply edge_low. Qed.
Lemma Q_low : (1 - 7 * u) * Q <= way_extent ray abc s.
Proof.
  destruct K as (_ & _ & _ & _ & _ & _ & F & H & _). destruct ranges as (_ & _ & _ & R).
  destruct (extent_low (way_of ray abc)) as [N _]; try (cbn; apply single_fl).
  pose proof (near3_extent 2 _ _ _ ltac:(lia) way_near) as N'. fold Q in N'. pose proof Q_value as E.
  pose proof (bpow_gt_0 radix2 (-100)) as P1.
  assert (S0 : 0 <= slack s).
  { apply Rle_trans with (2 := H). pose proof (bpow_gt_0 radix2 (-100)). apply Rmult_le_pos; [rewrite u_value; lra |].
    pose proof (size_of_point_positive (Rayo_p ray)). rewrite u_value. lra. }
  pose proof (sum_low (extent_fl (way_of ray abc)) (slack s) (single_fl _) F (extent_fl_positive _) S0) as L.
  fold (way_extent ray abc s) in L.
  apply Rle_trans with (2 := L). set (W := extent_fl (way_of ray abc)) in *. set (X := extent (way_of ray abc)) in *.
  set (D := 8 * u * size_of_point (Rayo_p ray) + tiny) in *. clearbody W X D. rewrite u_value in *. lra.
Qed.
Lemma area_low : (1 - 11 * u) * (L1 * L2) - eta <= area abc /\ 0 <= area abc.
Proof.
  destruct ranges as (_ & R1 & R2 & _).
  pose proof (product_low 5 5 _ _ _ _ ltac:(lra) ltac:(lra) (proj1 R1) (proj1 R2) L1_low L2_low) as P.
  pose proof (Rmult_le_pos _ _ (extent_fl_positive (edge1 abc)) (extent_fl_positive (edge2 abc))) as P0.
  pose proof (fl_low _ P0) as F. fold (area abc) in F. pose proof (Rmult_le_pos _ _ (proj1 R1) (proj1 R2)) as P1.
  split; [rewrite u_value in *; lra |]. unfold area. rewrite <- fl_0. now apply fl_le.
Qed.
Lemma middle_low : (1 - 20 * u) * M - 4 * eta <= middle s /\ 0 <= M.
Proof.
  destruct K as (_ & _ & _ & _ & _ & _ & _ & _ & _ & H & _). destruct ranges as (_ & R1 & R2 & R3). destruct area_low as [A A0].
  pose proof (sum_low _ _ (single_fl _) (single_fl _) (extent_fl_positive (edge1 abc)) (extent_fl_positive (edge2 abc))) as S1.
  fold (extent_fl (edge1 abc)) (extent_fl (edge2 abc)) in S1.
  pose proof L1_low as X1. pose proof L2_low as X2. destruct powers as (P0 & _ & _ & P3 & _).
  pose proof (bpow_gt_0 radix2 (-117)) as P4.
  set (sum := fl (extent_fl (edge1 abc) + extent_fl (edge2 abc))) in *.
  assert (S2 : (1 - 6 * u) * (L1 + L2) <= sum) by (rewrite u_value in *; lra).
  pose proof (product_low 7 6 Q (L1 + L2) _ _ ltac:(lra) ltac:(lra) ltac:(lra) ltac:(lra) Q_low S2) as S3.
  assert (PQ : 0 <= Q * (L1 + L2)) by (apply Rmult_le_pos; lra). assert (PL : 0 <= L1 * L2) by (apply Rmult_le_pos; lra).
  assert (S4 : 0 <= way_extent ray abc s * sum) by (apply Rle_trans with (2 := S3); apply Rmult_le_pos; [rewrite u_value;
  lra | exact PQ]).
  pose proof (fused_low _ _ _ _ S4 A0 H) as F. unfold M. split; [| lra]. rewrite u_value in *. lra.
Qed.

Lemma bound_low x X r : 0 <= X -> (1 - 20 * u) * X - 4 * eta <= x -> 0 <= rate s * x -> fused (rate s) x tiny r ->
  119 / 10 * u * (V * X) + tiny / 2 <= r.
Proof.
  intros HX Hx H0 H. destruct K as (_ & _ & _ & _ & _ & _ & _ & _ & (Rl & Rh) & _). fold v V in Rl. destruct ranges as (RV & _).
  destruct powers as (P0 & P1 & P2 & P3 & _). pose proof (bpow_gt_0 radix2 (-100)) as P4.
  pose proof (fused_low _ _ _ _ H0 (Rlt_le _ _ P4) H) as F.
  assert (R0 : 0 <= rate s) by (apply Rle_trans with (2 := Rl); rewrite u_value; lra).
  assert (A1 : rate s * ((1 - 20 * u) * X - 4 * eta) <= rate s * x) by (apply Rmult_le_compat_l; assumption).
  assert (A2 : rate s * eta <= G * eta) by (apply Rmult_le_compat_r; lra).
  assert (A3 : (1 - 2 * u) * (12 * u * V) * X <= rate s * X) by (apply Rmult_le_compat_r; assumption).
  assert (A4 : 0 <= V * X) by (apply Rmult_le_pos; lra).
  replace ((1 - 2 * u) * (12 * u * V) * X) with ((1 - 2 * u) * (12 * u) * (V * X)) in A3 by ring.
  replace (rate s * ((1 - 20 * u) * X - 4 * eta)) with ((1 - 20 * u) * (rate s * X) - 4 * (rate s * eta)) in A1 by ring.
  rewrite u_value in *. lra.
Qed.
Lemma middle_positive : 0 <= middle s.
Proof.
  destruct K as (_ & _ & _ & _ & _ & _ & _ & _ & _ & H & _). destruct area_low as [_ A0].
  assert (S0 : 0 <= fl (extent_fl (edge1 abc) + extent_fl (edge2 abc))).
  { rewrite <- fl_0. apply fl_le. pose proof (extent_fl_positive (edge1 abc)). pose proof (extent_fl_positive (edge2 abc)). lra. }
  assert (W0 : 0 <= way_extent ray abc s).
  { apply Rle_trans with (2 := Q_low). destruct ranges as (_ & _ & _ & R). pose proof (bpow_gt_0 radix2 (-100)).
    apply Rmult_le_pos; [rewrite u_value; lra | lra]. }
  pose proof (Rmult_le_pos _ _ W0 S0) as P. rewrite <- fl_0. destruct H as [-> | ->]; apply fl_le; [lra |].
  pose proof (fl_le 0 _ P) as F. rewrite fl_0 in F. lra.
Qed.
Lemma rate_positive : 0 <= rate s.
Proof.
  destruct K as (_ & _ & _ & _ & _ & _ & _ & _ & (Rl & _) & _). destruct ranges as (RV & _). fold v V in Rl.
  apply Rle_trans with (2 := Rl). rewrite u_value. lra.
Qed.
Lemma error_low : 119 / 10 * u * (V * M) + tiny / 2 <= error s.
Proof.
  destruct K as (_ & _ & _ & _ & _ & _ & _ & _ & _ & _ & H & _). destruct middle_low as [L M0].
  exact (bound_low _ _ _ M0 L (Rmult_le_pos _ _ rate_positive middle_positive) H).
Qed.
Lemma det_error_low : 119 / 10 * u * (V * (L1 * L2)) + tiny / 2 <= det_error s.
Proof.
  destruct K as (_ & _ & _ & _ & _ & _ & _ & _ & _ & _ & _ & H & _). destruct area_low as [L A0].
  destruct ranges as (_ & R1 & R2 & _). pose proof (Rmult_le_pos _ _ (proj1 R1) (proj1 R2)) as P.
  apply (bound_low (area abc) _ _ P); [pose proof (proj1 powers); rewrite u_value in *; lra | | exact H].
  exact (Rmult_le_pos _ _ rate_positive A0).
Qed.
Lemma C_error_low : 119 / 10 * u * (Q * (L1 * L2)) + tiny / 2 <= C_error s.
Proof.
  destruct K as (_ & _ & _ & _ & _ & _ & _ & _ & _ & _ & _ & _ & H). destruct area_low as [L A0].
  destruct ranges as (_ & R1 & R2 & R3). destruct powers as (P0 & P1 & P2 & P3 & _). pose proof (bpow_gt_0 radix2 (-100)) as P4.
  pose proof Q_low as W. set (A := area abc) in *. set (k := fl (12 * u * way_extent ray abc s)) in *.
  assert (W0 : 0 <= way_extent ray abc s) by (apply Rle_trans with (2 := W); apply Rmult_le_pos; [rewrite u_value; lra | lra]).
  assert (k_low : (1 - 8 * u) * (12 * u) * Q <= k).
  { assert (O : bpow radix2 (-126) <= Rabs (12 * u * way_extent ray abc s)).
    { rewrite Rabs_pos_eq by (rewrite u_value; lra). apply Rle_trans with (bpow radix2 (-24) * bpow radix2 (-100)).
      - rewrite <- bpow_plus. apply bpow_le. lia.
      - rewrite u_value in *. lra. }
    pose proof (fl_ordinary _ (or_intror O)) as N. rewrite (Rabs_pos_eq (12 * u * way_extent ray abc s)) in N
    by (rewrite u_value; lra). fold k in N.
    apply Rabs_le_inv in N. rewrite u_value in *. lra. }
  assert (k0 : 0 <= k) by (apply Rle_trans with (2 := k_low); rewrite u_value; lra).
  pose proof (fused_low _ _ _ _ (Rmult_le_pos _ _ k0 A0) (Rlt_le _ _ P4) H) as F.
  assert (X1 : (1 - 8 * u) * (12 * u) * Q * A <= k * A) by (apply Rmult_le_compat_r; assumption).
  assert (X2 : Q * ((1 - 11 * u) * (L1 * L2) - eta) <= Q * A) by (apply Rmult_le_compat_l; lra).
  assert (X3 : Q * eta <= G * eta) by (apply Rmult_le_compat_r; lra).
  assert (X4 : 0 <= Q * (L1 * L2)) by (repeat apply Rmult_le_pos; lra).
  replace (Q * ((1 - 11 * u) * (L1 * L2) - eta)) with ((1 - 11 * u) * (Q * (L1 * L2)) - Q * eta) in X2 by ring.
  replace ((1 - 8 * u) * (12 * u) * Q * A) with ((1 - 8 * u) * (12 * u) * (Q * A)) in X1 by ring.
  rewrite u_value in *. lra.
Qed.

(** What the bounds are for. *)
Lemma det_off : Rabs (det_fl s - det) <= 801 / 100 * u * (V * (L1 * L2)) + 1024 * atom.
Proof. pose proof (near_error 8 _ _ _ _ ltac:(lia) det_near) as H. simpl INR in H. lra. Qed.
Lemma ca_off : Rabs (ca_fl s - ca) <= 901 / 100 * u * (V * (Q * L2)) + 1024 * atom.
Proof. pose proof (near_error 9 _ _ _ _ ltac:(lia) ca_near) as H. simpl INR in H. lra. Qed.
Lemma ab_off : Rabs (ab_fl s - ab) <= 901 / 100 * u * (V * (Q * L1)) + 1024 * atom.
Proof. pose proof (near_error 9 _ _ _ _ ltac:(lia) ab_near) as H. simpl INR in H. lra. Qed.
Lemma bc_off : Rabs (bc_fl - (det - ca - ab)) <= 1101 / 100 * u * (V * M) + 20000 * atom.
Proof. pose proof (near_error 11 _ _ _ _ ltac:(lia) bc_near) as H. simpl INR in H. lra. Qed.
Lemma C_off : Rabs (C_fl s - C) <= 901 / 100 * u * (Q * (L1 * L2)) + 1024 * atom.
Proof. pose proof (near_error 9 _ _ _ _ ltac:(lia) C_near) as H. simpl INR in H. lra. Qed.

Lemma parts : 0 <= V * (L1 * L2) /\ 0 <= V * (Q * L1) /\ 0 <= V * (Q * L2)
  /\ V * M = V * (L1 * L2) + V * (Q * L1) + V * (Q * L2) /\ 0 <= Q * (L1 * L2).
Proof.
  destruct ranges as (R0 & R1 & R2 & R3). pose proof (bpow_gt_0 radix2 (-100)) as P4.
  repeat split; try (repeat apply Rmult_le_pos; lra). unfold M. ring.
Qed.

(** *** What the test says *)

(** The sign that turns the numbers is that of the computed det, either where that is 0. *)
Variable is_turned : bool.
Hypothesis turn_right : if is_turned then det_fl s <= 0 else 0 <= det_fl s.
Definition turned (x : R) : R := if is_turned then - x else x.
Definition margin : R := Rmin (Rmin (turned (ca_fl s)) (turned (ab_fl s))) (turned bc_fl).

Lemma turned_off x y e : Rabs (x - y) <= e -> turned y - e <= turned x <= turned y + e.
Proof. intros H. apply Rabs_le_inv in H. unfold turned. destruct is_turned; lra. Qed.
Lemma turned_det : 0 <= turned (det_fl s).
Proof. unfold turned. destruct is_turned; lra. Qed.
Lemma turned_bc : turned bc_fl = fl (fl (turned (det_fl s) - turned (ca_fl s)) - turned (ab_fl s)).
Proof.
  unfold turned, bc_fl. destruct is_turned; [| reflexivity]. rewrite <- fl_opp.
  replace (- det_fl s - - ca_fl s) with (- (det_fl s - ca_fl s)) by ring. rewrite (fl_opp (det_fl s - ca_fl s)). f_equal. ring.
Qed.

(** Where a side is below the bound, no point of the line lies in the triangle. *)
Theorem a_miss_is_right t : 0 < sq (normal abc) -> margin < - error s -> ~ point_at ray t ∈ puntos_triangulo abc.
Proof.
  intros N Hm Hit. destruct (products_of_a_hit ray abc t N Hit) as (x & y & z & X & Y & Z & One & _ & Hab & Hbc & Hca).
  fold a v E1 E2 T in Hab, Hbc, Hca. fold det ca ab in Hab, Hbc, Hca.
  pose proof (turned_off _ _ _ det_off) as D. pose proof (turned_off _ _ _ ca_off) as A.
  pose proof (turned_off _ _ _ ab_off) as B.
  pose proof (turned_off _ _ _ bc_off) as BC. pose proof turned_det as D0. pose proof error_low as E.
  destruct parts as (P1 & P2 & P3 & P4 & _). destruct powers as (Q0 & Q1 & _ & Q3 & _).
  pose proof (bpow_gt_0 radix2 (-117)) as Q4.
  assert (Ta : turned ab = x * turned det) by (rewrite Hab; unfold turned; destruct is_turned; ring).
  assert (Tb : turned (det - ca - ab) = y * turned det) by (rewrite Hbc; unfold turned; destruct is_turned; ring).
  assert (Tc : turned ca = z * turned det) by (rewrite Hca; unfold turned; destruct is_turned; ring).
  set (d := turned det) in *.
  assert (Hs : turned (ca_fl s) < - error s \/ turned (ab_fl s) < - error s \/ turned bc_fl < - error s).
  { unfold margin, Rmin in Hm. destruct (Rle_dec _ _) as [_ | _] in Hm; [destruct (Rle_dec _ _) as [_ | _] in Hm |]; auto. }
  destruct (Rle_dec 0 d) as [Pd | Nd].
  - assert (0 <= x * d /\ 0 <= y * d /\ 0 <= z * d) as (U1 & U2 & U3) by (repeat split; now apply Rmult_le_pos).
    rewrite u_value in *. destruct Hs as [H | [H | H]]; lra.
  - assert (B1 : d <= x * d <= 0 /\ d <= z * d <= 0).
    { assert (Hone : forall f, 0 <= f <= 1 -> d <= f * d <= 0).
      { intros f Hf. assert (0 <= f * - d) by (apply Rmult_le_pos; lra). assert (0 <= (1 - f) * - d) by (apply Rmult_le_pos;
        lra). lra. }
      split; apply Hone; lra. }
    destruct Hs as [H | [H | H]]; [rewrite u_value in *; lra | rewrite u_value in *; lra |].
    rewrite turned_bc in H.
    set (m1 := 901 / 100 * u * (V * (Q * L2)) + 1024 * atom) in *. set (m2 := 901 / 100 * u * (V * (Q * L1)) + 1024 * atom) in *.
    assert (M1 : 0 <= m1) by (unfold m1; rewrite u_value; lra). assert (M2 : 0 <= m2) by (unfold m2; rewrite u_value; lra).
    pose proof (fl_below m1 (turned (det_fl s) - turned (ca_fl s)) M1 ltac:(lra)) as F1.
    assert (M3 : 0 <= m1 * (1 + u) + eta + m2) by (rewrite u_value in *; lra).
    pose proof (fl_below _ (fl (turned (det_fl s) - turned (ca_fl s)) - turned (ab_fl s)) M3 ltac:(lra)) as F2.
    unfold m1, m2 in *. rewrite u_value in *. lra.
Qed.

(** Where the margin is above the bound, the three sides have the sign of det, which is not 0. *)
Theorem a_hit_is_right : error s < margin ->
  det <> 0 /\ 0 < ab * det /\ 0 < (det - ca - ab) * det /\ 0 < ca * det.
Proof.
  intros Hm. pose proof (turned_off _ _ _ ca_off) as A. pose proof (turned_off _ _ _ ab_off) as B.
  pose proof (turned_off _ _ _ bc_off) as BC. pose proof error_low as E.
  destruct parts as (P1 & P2 & P3 & P4 & _). destruct powers as (Q0 & Q1 & _ & Q3 & _).
  pose proof (bpow_gt_0 radix2 (-117)) as Q4.
  assert (Hs : error s < turned (ca_fl s) /\ error s < turned (ab_fl s) /\ error s < turned bc_fl).
  { unfold margin in Hm. set (ca' := turned (ca_fl s)) in *. set (ab' := turned (ab_fl s)) in *. set (bc' := turned bc_fl) in *.
    pose proof (Rmin_l (Rmin ca' ab') bc'). pose proof (Rmin_r (Rmin ca' ab') bc'). pose proof (Rmin_l ca' ab').
    pose proof (Rmin_r ca' ab'). lra. }
  assert (Ta : 0 < turned ca) by (rewrite u_value in *; lra). assert (Tb : 0 < turned ab) by (rewrite u_value in *; lra).
  assert (Tc : 0 < turned (det - ca - ab)) by (rewrite u_value in *; lra).
  unfold turned in Ta, Tb, Tc. assert (Hone : forall x y, 0 < x -> 0 < y -> 0 < x * y) by (intros; now apply Rmult_lt_0_compat).
  destruct is_turned.
  - assert (D : 0 < - det) by lra. pose proof (Hone _ _ Ta D). pose proof (Hone _ _ Tb D). pose proof (Hone _ _ Tc D).
    repeat split; lra.
  - assert (D : 0 < det) by lra. pose proof (Hone _ _ Ta D). pose proof (Hone _ _ Tb D). pose proof (Hone _ _ Tc D).
    repeat split; lra.
Qed.

(** So the line crosses the plane in one point, which lies in the triangle. *)
Theorem a_hit_lies_in_the_triangle : error s < margin -> point_at ray (C / det) ∈ puntos_triangulo abc
  /\ forall t, point_at ray t ∈ puntos_triangulo abc -> t = C / det.
Proof.
  intros Hm. destruct (a_hit_is_right Hm) as (D & A & B & Z). destruct (program_of_a_triangle ray abc) as [_ H].
  specialize (H D). destruct H as (P & _ & _ & _ & H). split.
  - split; [| now apply P]. apply H. split; [| split]; now apply Rlt_le.
  - intros t [_ Hp]. now apply P.
Qed.

(** *** Where the line crosses the plane *)

(** The line is known to cross the plane; a parameter lies between the two bounds. *)
Definition known : Prop := fl (4 * det_error s) < Rabs (det_fl s).
Definition bounds (t t_error t' : R) : Prop := fl (t - t_error) <= t' <= fl (t + t_error).

(** The computed parameter and what it may err by: the quotient of C and det, by an inverse; 11744051/2^23 is 1.4. *)
Definition placed (t t_error : R) : Prop := exists inverse coarse rest, inverse = fl (1 / Rabs (det_fl s))
  /\ t = fl (turned (C_fl s) * inverse) /\ fused (Rabs t) (det_error s) (C_error s) coarse
  /\ fused (4 * u) (Rabs t) tiny rest /\ fused (fl (11744051 / 8388608 * inverse)) coarse rest t_error.

Theorem a_parameter_is_right t t_error : placed t t_error -> known -> det <> 0 /\ bounds t t_error (C / det).
Proof.
  intros (inverse & coarse & rest & inverse_is & t_is & coarse_is & rest_is & t_error_is) Known. unfold known, bounds in *.
  pose proof det_error_low as DE. pose proof C_error_low as CE. destruct parts as (P1 & _ & _ & _ & P2).
  destruct powers as (Q0 & Q1 & _ & Q3 & _). pose proof (bpow_gt_0 radix2 (-117)) as Q4.
  pose proof (turned_off _ _ _ det_off) as D. pose proof turned_det as D0. pose proof (turned_off _ _ _ C_off) as CC.
  assert (Sz : Rabs (det_fl s) = turned (det_fl s)).
  { unfold turned in *. destruct is_turned; [now apply Rabs_left1 | now apply Rabs_pos_eq]. }
  rewrite Sz in *. set (z := turned (det_fl s)) in *. set (d := turned det) in *. set (c := turned (C_fl s)) in *.
  set (c0 := turned C) in *. set (de := det_error s) in *. set (ce := C_error s) in *.
  pose proof (fl_low (4 * de) ltac:(rewrite u_value in *; lra)) as F4.
  assert (Zde : 399 / 100 * de <= z) by (rewrite u_value in *; lra).
  assert (Hd : Rabs (z - d) <= 68 / 100 * de) by (apply Rabs_le; rewrite u_value in *; lra).
  assert (Hc : Rabs (c0 - c) <= 76 / 100 * ce) by (apply Rabs_le; rewrite u_value in *; lra).
  assert (de0 : 0 < de) by (rewrite u_value in *; lra). assert (ce0 : 65536 * atom <= ce) by (rewrite u_value in *; lra).
  assert (z0 : 0 < z) by lra. assert (dz : 82 / 100 * z <= d) by (apply Rabs_le_inv in Hd; lra).
  assert (d0 : 0 < d) by lra.
  assert (T0 : C / det = c0 / d).
  { unfold c0, d, turned in *. destruct is_turned; [field; lra | reflexivity]. }
  assert (N : det <> 0) by (unfold d, turned in d0; destruct is_turned; lra). split; [exact N |]. rewrite T0.
  set (iz := / z) in *. assert (iz0 : 0 < iz) by now apply Rinv_0_lt_compat. assert (ziz : z * iz = 1) by (apply Rinv_r; lra).
  set (y := c * iz) in *. pose proof (Rabs_pos y) as Y0. pose proof (Rabs_pos t) as T1.
  assert (id : / d <= 122 / 100 * iz).
  { apply Rmult_le_reg_l with d; [exact d0 |]. rewrite Rinv_r by lra. assert (82 / 100 * z * iz <= d * iz)
    by (apply Rmult_le_compat_r; lra). lra. }
  assert (id0 : 0 < / d) by now apply Rinv_0_lt_compat.
  assert (Off1 : Rabs (c0 / d - y) <= 93 / 100 * (ce * iz) + 83 / 100 * (Rabs y * de * iz)).
  { replace (c0 / d - y) with ((c0 - c) * / d + y * (z - d) * / d).
    2: { unfold y. replace c with (c * (z * iz)) at 1 by (rewrite ziz; ring). field. lra. }
    apply Rle_trans with (1 := Rabs_triang _ _). rewrite !Rabs_mult, (Rabs_pos_eq (/ d)) by lra.
    assert (E1' : Rabs (c0 - c) * / d <= 76 / 100 * ce * (122 / 100 * iz)) by (apply Rmult_le_compat; try apply Rabs_pos; lra).
    assert (E2' : Rabs (z - d) * / d <= 68 / 100 * de * (122 / 100 * iz)) by (apply Rmult_le_compat; try apply Rabs_pos; lra).
    apply (Rmult_le_compat_l _ _ _ Y0) in E2'. assert (0 <= ce * iz) by (apply Rmult_le_pos; lra).
    assert (0 <= Rabs y * de * iz) by (repeat apply Rmult_le_pos; lra). lra. }
  assert (Zbig : z <= bpow radix2 101).
  { pose proof (near_size _ _ _ _ _ det_near) as B. rewrite <- Sz in *. apply Rle_trans with (1 := B).
    destruct ranges as (R0 & R1 & R2 & _).
    assert (B1 : V * (L1 * L2) <= G * (G * G)) by (repeat apply Rmult_le_compat; try apply Rmult_le_pos; lra).
    rewrite <- !bpow_plus in B1. change (33 + (33 + 33))%Z with 99%Z in B1. pose proof (power_at_most 8 ltac:(lia)) as B2.
    simpl INR in B2.
    assert (B3 : (1 + u) ^ 8 * (V * (L1 * L2)) <= 2 * bpow radix2 99) by (apply Rmult_le_compat; try lra;
    [| rewrite u_value in *; lra];
      pose proof (power_at_least 8); lra).
    assert (B4 : bpow radix2 (-117) <= bpow radix2 80) by (apply bpow_le; lia).
    replace (bpow radix2 101) with (4 * bpow radix2 99) by (change 4 with (bpow radix2 2); now rewrite <- bpow_plus).
    assert (B5 : 1024 * bpow radix2 80 <= bpow radix2 99).
    { change 1024 with (bpow radix2 10). rewrite <- bpow_plus. apply bpow_le. lia. }
    lra. }
  assert (izlow : bpow radix2 (-101) <= iz).
  { unfold iz. rewrite (bpow_opp radix2 101 : bpow radix2 (-101) = _). apply Rinv_le_contravar; assumption. }
  assert (Inv : Rabs (inverse - iz) <= u * iz).
  { rewrite inverse_is. unfold Rdiv. rewrite Rmult_1_l. fold iz. rewrite <- (Rabs_pos_eq iz) at 3 by lra. apply fl_ordinary.
    right. rewrite Rabs_pos_eq by lra. apply Rle_trans with (2 := izlow). apply bpow_le. lia. }
  apply Rabs_le_inv in Inv.
  assert (Off2 : Rabs (t - y) <= 201 / 100 * u * Rabs y + eta).
  { pose proof (fl_near (c * inverse)) as F. rewrite <- t_is in F.
    assert (F1 : Rabs (c * inverse - y) <= u * Rabs y).
    { unfold y. replace (c * inverse - c * iz) with (c * (inverse - iz)) by ring. rewrite !Rabs_mult, (Rabs_pos_eq iz) by lra.
      replace (u * (Rabs c * iz)) with (Rabs c * (u * iz)) by ring. apply Rmult_le_compat_l; [apply Rabs_pos |]. apply Rabs_le.
      lra. }
    assert (F2 : Rabs (c * inverse) <= Rabs y + u * Rabs y).
    { replace (c * inverse) with (y + (c * inverse - y)) by ring. apply Rle_trans with (1 := Rabs_triang _ _). lra. }
    replace (t - y) with ((t - c * inverse) + (c * inverse - y)) by ring. apply Rle_trans with (1 := Rabs_triang _ _).
    rewrite u_value in *. lra. }
  assert (Yt : Rabs y <= 10001 / 10000 * (Rabs t + eta)).
  { assert (Rabs y <= Rabs t + Rabs (t - y)).
    { replace y with (t - (t - y)) at 1 by ring. apply Rle_trans with (1 := Rabs_triang _ _). rewrite Rabs_Ropp. lra. }
    rewrite u_value in *. lra. }
  set (X := Rabs t * de * iz) in *. set (W := ce * iz) in *.
  assert (X0 : 0 <= X) by (unfold X; repeat apply Rmult_le_pos; lra). assert (W0 : 0 <= W) by (unfold W; apply Rmult_le_pos; lra).
  assert (deiz : 0 <= de * iz <= 26 / 100).
  { split; [apply Rmult_le_pos; lra |]. assert (399 / 100 * de * iz <= z * iz) by (apply Rmult_le_compat_r; lra). lra. }
  assert (YX : Rabs y * de * iz <= 10001 / 10000 * (X + eta)).
  { assert (E1' : Rabs y * (de * iz) <= 10001 / 10000 * (Rabs t + eta) * (de * iz)) by (apply Rmult_le_compat_r; lra).
    assert (E2' : eta * (de * iz) <= eta * 1) by (apply Rmult_le_compat_l; lra).
    replace (10001 / 10000 * (Rabs t + eta) * (de * iz)) with (10001 / 10000 * (X + eta * (de * iz))) in E1' by (unfold X; ring).
    replace (Rabs y * (de * iz)) with (Rabs y * de * iz) in E1' by ring. lra. }
  assert (Far : Rabs (c0 / d - t) <= 93 / 100 * W + 84 / 100 * X + 202 / 100 * u * Rabs t + 3 * eta).
  { replace (c0 / d - t) with ((c0 / d - y) - (t - y)) by ring. apply Rle_trans with (1 := Rabs_triang _ _). rewrite Rabs_Ropp.
    rewrite u_value in *. lra. }
  assert (Tde : 0 <= Rabs t * de) by (apply Rmult_le_pos; lra).
  assert (ce1 : 0 <= ce) by lra. pose proof (fused_low _ _ _ _ Tde ce1 coarse_is) as Co.
  assert (T4 : 0 <= 4 * u * Rabs t) by (rewrite u_value; lra).
  pose proof (fused_low _ _ _ _ T4 (bpow_ge_0 radix2 (-100)) rest_is) as Re.
  assert (Co' : 99 / 100 * (Rabs t * de + ce) <= coarse) by (rewrite u_value in *; lra).
  assert (Kf : 139 / 100 * iz <= fl (11744051 / 8388608 * inverse)).
  { assert (O : bpow radix2 (-126) <= Rabs (11744051 / 8388608 * inverse)).
    { rewrite Rabs_pos_eq by (rewrite u_value in *; lra). apply Rle_trans with (bpow radix2 (-101)); [apply bpow_le; lia |].
      rewrite u_value in *. lra. }
    pose proof (fl_ordinary _ (or_intror O)) as F. rewrite (Rabs_pos_eq (11744051 / 8388608 * inverse)) in F
    by (rewrite u_value in *; lra).
    apply Rabs_le_inv in F. rewrite u_value in *. lra. }
  set (k := fl (11744051 / 8388608 * inverse)) in *.
  assert (k0 : 0 <= k) by lra. assert (Co0 : 0 <= coarse) by lra.
  assert (Re0 : 0 <= rest) by (rewrite u_value in *; lra).
  pose proof (fused_low _ _ _ _ (Rmult_le_pos _ _ k0 Co0) Re0 t_error_is) as Te.
  assert (KC : 139 / 100 * (99 / 100) * (X + W) <= k * coarse).
  { replace (139 / 100 * (99 / 100) * (X + W)) with ((139 / 100 * iz) * (99 / 100 * (Rabs t * de + ce))) by (unfold X, W; ring).
    apply Rmult_le_compat; lra. }
  assert (Te' : 136 / 100 * (X + W) + 399 / 100 * u * Rabs t + 99 / 100 * tiny <= t_error) by (rewrite u_value in *; lra).
  assert (Ft : single t) by (rewrite t_is; apply single_fl).
  assert (Fe : single t_error) by (destruct t_error_is as [-> | ->]; apply single_fl).
  assert (Te0 : 0 <= t_error) by (rewrite u_value in *; lra).
  pose proof (fl_plus t t_error Ft Fe) as N1.
  pose proof (fl_plus t (- t_error) Ft (single_opp _ Fe) : Rabs (fl (t - t_error) - (t - t_error)) <= u * Rabs (t - t_error)) as
  N2.
  assert (S1 : Rabs (t + t_error) <= Rabs t + t_error).
  { apply Rle_trans with (1 := Rabs_triang _ _). rewrite (Rabs_pos_eq t_error) by exact Te0. lra. }
  assert (S2 : Rabs (t - t_error) <= Rabs t + t_error).
  { apply Rle_trans with (1 := Rabs_triang _ _). rewrite Rabs_Ropp, (Rabs_pos_eq t_error) by exact Te0. lra. }
  apply Rabs_le_inv in N1, N2, Far. rewrite u_value in *. lra.
Qed.
End Screen.

(** The test as a whole: a margin below the bound is a miss, a margin above it is a hit in one point, and whatever point of the
    line lies in the triangle's plane has its parameter between the two bounds. *)
Theorem the_screen_is_right ray abc s (is_turned : bool) : in_range ray abc -> computed ray abc s -> 0 < sq (normal abc) ->
  (if is_turned then det_fl s <= 0 else 0 <= det_fl s) ->
  (margin s is_turned < - error s -> forall t, ~ point_at ray t ∈ puntos_triangulo abc)
  /\ (error s < margin s is_turned -> exists t, forall t', point_at ray t' ∈ puntos_triangulo abc <-> t' = t)
  /\ (forall t t_error t', placed s is_turned t t_error -> known s -> potencia_triangulo (point_at ray t') abc = 0 ->
      bounds t t_error t').
Proof.
  intros I K N S. split; [| split].
  - intros H t. exact (a_miss_is_right ray abc s I K is_turned S t N H).
  - intros H. destruct (a_hit_lies_in_the_triangle ray abc s I K is_turned S H) as [A B]. eexists. intros t'. split; [apply B |].
    intros ->. exact A.
  - intros t t_error t' P Known Hp. destruct (a_parameter_is_right ray abc s I K is_turned S t t_error P Known) as [D B].
    destruct (program_of_a_triangle ray abc) as [_ H]. destruct (H D) as [E _]. now rewrite (proj1 (E t') Hp).
Qed.
