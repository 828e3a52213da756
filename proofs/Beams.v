(** * Beams: boxes against the half-spaces that hold segments

    Segments that walk a tree together lie in a half-space along a plane of two axes, x - b*y >= A, where both ends of each
    do. A box of which no corner lies there holds no point of them. The numbers are those of finite operations, as in
    Bundles.v; X and Y bound what they are made of.

    side x b y            == x - b*y, both operations rounded, of real numbers
    near_corner b y0 y1   == where -b*y is greatest between y0 and y1; far_corner, where it is least *)
From Coq Require Import Reals ZArith Lra Lia.
From Flocq Require Import Core Relative.
Local Open Scope R_scope.

Section Beams.
Variables prec emax : Z.
Context (prec_gt_0 : Prec_gt_0 prec).
Notation emin := (3 - emax - prec)%Z.
Notation rnd := (round radix2 (FLT_exp emin prec) ZnearestE).
Notation u := (/ 2 * bpow radix2 (- prec + 1)).
Notation eta := (bpow radix2 emin).

Definition side (x b y : R) : R := rnd (x - rnd (b * y)).

Lemma u_bounds : 0 < u <= / 2.
Proof.
  unfold Prec_gt_0 in *; split; [apply Rmult_lt_0_compat; [lra | apply bpow_gt_0]|].
  replace (/ 2) with (/ 2 * bpow radix2 0) at 2 by (simpl; lra).
  apply Rmult_le_compat_l; [lra | apply bpow_le; lia].
Qed.

Lemma rnd_error z Z : Rabs z <= Z -> Rabs (rnd z - z) <= u * Z + eta.
Proof.
  intros Hz; destruct (error_N_FLT radix2 emin prec prec_gt_0 (fun n => negb (Z.even n)) z)
    as (e & n & He & Hn & _ & ->); pose proof (bpow_gt_0 radix2 emin); pose proof u_bounds.
  replace (z * (1 + e) + n - z) with (e * z + n) by ring.
  apply Rle_trans with (1 := Rabs_triang _ _), Rplus_le_compat; [|lra].
  rewrite Rabs_mult; apply Rmult_le_compat; auto using Rabs_pos.
Qed.

Lemma product_size b y Y : Rabs y <= Y -> Rabs (b * y) <= Rabs b * Y.
Proof. intros Hy; rewrite Rabs_mult; apply Rmult_le_compat_l; [apply Rabs_pos | assumption]. Qed.

(** What the two roundings of a side are less than. *)
Lemma side_error x b y X Y : Rabs x <= X -> Rabs y <= Y ->
  Rabs (side x b y - (x - b * y)) <= 3 * u * (X + Rabs b * Y) + 3 * eta.
Proof.
  intros Hx Hy; pose proof (product_size b y Y Hy) as Hby; set (P := Rabs b * Y) in *.
  pose proof u_bounds as Hu; pose proof (bpow_gt_0 radix2 emin) as Heta.
  pose proof (Rabs_pos x); pose proof (Rabs_pos (b * y)).
  pose proof (rnd_error _ P Hby) as H1.
  assert (Hr : Rabs (rnd (b * y)) <= P + (u * P + eta)).
  { replace (rnd (b * y)) with (b * y + (rnd (b * y) - b * y)) by ring.
    apply Rle_trans with (1 := Rabs_triang _ _); lra. }
  assert (Hd : Rabs (x - rnd (b * y)) <= X + (P + (u * P + eta))).
  { unfold Rminus; apply Rle_trans with (1 := Rabs_triang _ _); rewrite Rabs_Ropp; lra. }
  pose proof (rnd_error _ _ Hd) as H2; unfold side.
  replace (rnd (x - rnd (b * y)) - (x - b * y))
    with ((rnd (x - rnd (b * y)) - (x - rnd (b * y))) + - (rnd (b * y) - b * y)) by ring.
  apply Rle_trans with (1 := Rabs_triang _ _); rewrite Rabs_Ropp.
  assert (u * (u * P) <= / 2 * (u * P)) by (apply Rmult_le_compat_r; [apply Rmult_le_pos; lra | lra]).
  assert (u * eta <= / 2 * eta) by (apply Rmult_le_compat_r; lra).
  assert (0 <= u * X) by (apply Rmult_le_pos; lra).
  assert (0 <= u * P) by (apply Rmult_le_pos; lra).
  replace (u * (X + (P + (u * P + eta)))) with (u * X + u * P + u * (u * P) + u * eta) in H2 by ring.
  replace (3 * u * (X + P)) with (3 * (u * X) + 3 * (u * P)) by ring; lra.
Qed.

(** A point of a segment is between its ends, on either side of any line. *)
Lemma between f g t : 0 <= t <= 1 -> Rmin f g <= f + t * (g - f) <= Rmax f g.
Proof.
  intros Ht; unfold Rmin, Rmax; destruct (Rle_dec f g) as [H|H]; split;
    try (assert (0 <= t * (g - f)) by (apply Rmult_le_pos; lra));
    try (assert (t * (g - f) <= 1 * (g - f)) by (apply Rmult_le_compat_r; lra));
    try (assert (0 <= t * (f - g)) by (apply Rmult_le_pos; lra));
    try (assert (t * (f - g) <= 1 * (f - g)) by (apply Rmult_le_compat_r; lra)); lra.
Qed.

(** The greatest of -b*y. *)
Definition near_corner (b y0 y1 : R) : R := if Rle_dec 0 b then y0 else y1.
Definition far_corner (b y0 y1 : R) : R := if Rle_dec 0 b then y1 else y0.

Lemma corners b y0 y1 y : y0 <= y <= y1 -> b * near_corner b y0 y1 <= b * y <= b * far_corner b y0 y1.
Proof.
  intros Hy; unfold near_corner, far_corner; destruct (Rle_dec 0 b);
    [split; apply Rmult_le_compat_l; lra | split; apply Rmult_le_compat_neg_l; lra].
Qed.

Section Segment.
(** An end of a segment, the other and what is computed of that, and a box that holds a point between them. *)
Variables px py qx qy cx cy t x0 x1 y0 y1 b X Y : R.
Hypothesis ends : Rabs px <= X /\ Rabs py <= Y /\ Rabs cx <= X /\ Rabs cy <= Y.
Hypothesis computed : Rabs (cx - qx) <= 4 * u * X /\ Rabs (cy - qy) <= 4 * u * Y.
Hypothesis box : Rabs x0 <= X /\ Rabs x1 <= X /\ Rabs y0 <= Y /\ Rabs y1 <= Y.
Hypothesis held : 0 <= t <= 1 /\ x0 <= px + t * (qx - px) <= x1 /\ y0 <= py + t * (qy - py) <= y1.

Notation slack := (10 * u * (X + Rabs b * Y) + 6 * eta).

Lemma far_end : Rabs (side cx b cy - (qx - b * qy)) <= 7 * u * (X + Rabs b * Y) + 3 * eta.
Proof.
  destruct ends as (_ & _ & Hx & Hy), computed as [Cx Cy]; pose proof (side_error cx b cy X Y Hx Hy) as H.
  assert (Hb : Rabs (b * (cy - qy)) <= Rabs b * (4 * u * Y)) by now apply product_size.
  replace (side cx b cy - (qx - b * qy)) with ((side cx b cy - (cx - b * cy)) + ((cx - qx) + - (b * (cy - qy)))) by ring.
  apply Rle_trans with (1 := Rabs_triang _ _).
  apply Rle_trans with (1 := Rplus_le_compat _ _ _ _ H (Rabs_triang _ _)); rewrite Rabs_Ropp; lra.
Qed.

(** What a bound less than both ends by the slack keeps: a box with a point of the segment passes. A bound that is greater
    is one that is less, seen from the other side. *)
Theorem low_side_keeps A : A <= side px b py - slack -> A <= side cx b cy - slack ->
  A <= side x1 b (near_corner b y0 y1).
Proof.
  intros Hp Hc; destruct ends as (Px & Py & _), box as (_ & X1 & Y0 & Y1), held as (Ht & Hx & Hy).
  pose proof (Rabs_le_inv _ _ (side_error px b py X Y Px Py)); pose proof (Rabs_le_inv _ _ far_end).
  assert (Hcorner : Rabs (near_corner b y0 y1) <= Y) by (unfold near_corner; now destruct (Rle_dec 0 b)).
  pose proof (Rabs_le_inv _ _ (side_error x1 b _ X Y X1 Hcorner)).
  pose proof (proj1 (between (px - b * py) (qx - b * qy) t Ht)) as Hm.
  pose proof (corners b y0 y1 _ Hy) as [Hn _].
  pose proof (Rabs_pos b); pose proof (bpow_gt_0 radix2 emin).
  pose proof u_bounds; assert (0 <= X) by (apply Rle_trans with (2 := Px); apply Rabs_pos).
  assert (0 <= Y) by (apply Rle_trans with (2 := Py); apply Rabs_pos).
  assert (0 <= u * (X + Rabs b * Y)) by (apply Rmult_le_pos; [lra | assert (0 <= Rabs b * Y) by (apply Rmult_le_pos; lra); lra]).
  unfold Rmin in Hm; destruct (Rle_dec (px - b * py) (qx - b * qy)); lra.
Qed.

End Segment.

(** A side seen from the other: what is low there is high here. *)
Lemma side_opp x b y : side (- x) b (- y) = - side x b y.
Proof.
  unfold side; replace (b * - y) with (- (b * y)) by ring; rewrite round_NE_opp.
  replace (- x - - rnd (b * y)) with (- (x - rnd (b * y))) by ring; apply round_NE_opp.
Qed.
Lemma corner_opp b y0 y1 : near_corner b (- y1) (- y0) = - far_corner b y0 y1.
Proof. unfold near_corner, far_corner; now destruct (Rle_dec 0 b). Qed.
End Beams.

(** ** In binary64 *)

Definition prec64 : Prec_gt_0 53 := eq_refl.
Notation u64 := (bpow radix2 (-53)).
Definition slack64 (b X Y : R) : R := 10 * u64 * (X + Rabs b * Y) + 6 * bpow radix2 (-1074).

Lemma half_ulp : / 2 * bpow radix2 (- (53) + 1) = u64.
Proof. simpl; lra. Qed.

Theorem low_side64_keeps px py qx qy cx cy t x0 x1 y0 y1 b X Y A :
  Rabs px <= X /\ Rabs py <= Y /\ Rabs cx <= X /\ Rabs cy <= Y ->
  Rabs (cx - qx) <= 4 * u64 * X /\ Rabs (cy - qy) <= 4 * u64 * Y ->
  Rabs x0 <= X /\ Rabs x1 <= X /\ Rabs y0 <= Y /\ Rabs y1 <= Y ->
  0 <= t <= 1 /\ x0 <= px + t * (qx - px) <= x1 /\ y0 <= py + t * (qy - py) <= y1 ->
  A <= side 53 1024 px b py - slack64 b X Y -> A <= side 53 1024 cx b cy - slack64 b X Y ->
  A <= side 53 1024 x1 b (near_corner b y0 y1).
Proof.
  unfold slack64; rewrite <- half_ulp; intros He Hc Hb Hh H1 H2.
  now apply (low_side_keeps 53 1024 prec64 px py qx qy cx cy t x0 x1 y0 y1 b X Y).
Qed.

Theorem high_side64_keeps px py qx qy cx cy t x0 x1 y0 y1 b X Y C :
  Rabs px <= X /\ Rabs py <= Y /\ Rabs cx <= X /\ Rabs cy <= Y ->
  Rabs (cx - qx) <= 4 * u64 * X /\ Rabs (cy - qy) <= 4 * u64 * Y ->
  Rabs x0 <= X /\ Rabs x1 <= X /\ Rabs y0 <= Y /\ Rabs y1 <= Y ->
  0 <= t <= 1 /\ x0 <= px + t * (qx - px) <= x1 /\ y0 <= py + t * (qy - py) <= y1 ->
  side 53 1024 px b py + slack64 b X Y <= C -> side 53 1024 cx b cy + slack64 b X Y <= C ->
  side 53 1024 x0 b (far_corner b y0 y1) <= C.
Proof.
  intros He Hc Hb Hh H1 H2; assert (Opp : forall x x', - x - - x' = - (x - x')) by (intros; ring).
  enough (H : - C <= side 53 1024 (- x0) b (near_corner b (- y1) (- y0))) by (rewrite corner_opp, side_opp in H; lra).
  apply (low_side64_keeps (- px) (- py) (- qx) (- qy) (- cx) (- cy) t (- x1) (- x0) (- y1) (- y0) b X Y);
    rewrite ?Opp, ?Rabs_Ropp, ?side_opp; tauto || lra.
Qed.
