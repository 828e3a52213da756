(** * AtRoot: the quadratic at a parameter is within its error

    Formas.Powers has potencia at the parameter t of a ray, in pairs, with a bound on its error; so that at a root a step of
    Newton's can begin. Here what the shapes share, and the sphere and the plane.

    powered f x     == f is computed for x, with room for one more operation
    at_origin       == the same, of a computed number less that at the ray's origin
    away c, reached == the pairs p - c, and the bound that the program computes of |p - c| + |t v| *)
From Coq Require Import Reals ZArith Lra Lia Psatz.
From Flocq Require Import Core.
From Durero Require Import Rounding Quotient Vectors Flotante Twofold Sums Loose.
From Durero Require Formas.
Import Formas.Pairs.
Local Open Scope R_scope.
Local Opaque bpow.

Definition powered (f : Formas.known twofold) (x : R) : Prop :=
  exists s, loose s 40 340 (Formas.value f) x /\ 480 * (u * (u * s)) <= Formas.error f /\ format (Formas.error f).
(** What a step of Newton's asks of it. *)
Definition within_error (f : Formas.known twofold) (x : R) : Prop :=
  Rabs (x - whole (Formas.value f)) <= Formas.error f /\
  (format (hi (Formas.value f)) /\ format (lo (Formas.value f)) /\ format (Formas.error f)).

Lemma powered_within f x : powered f x -> within_error f x.
Proof.
  intros (s & (Hs & Fh & Fl & _ & _ & He) & Hb & Fe); destruct (roomy_units s Hs) as (_ & W & _).
  split; [rewrite Rabs_minus_sym; lra | auto].
Qed.

(** The number there less that here, at the origin. *)
Lemma launched_within there here x y : powered there x -> powered here y ->
  within_error (Formas.Powers.launched there here) (x - y) /\ Formas.error there <= Formas.error (Formas.Powers.launched there here).
Proof.
  intros (s & Hx & Ex & Fx) (t & Hy & Ey & Fy).
  pose proof (loose_difference s t 40 340 _ _ x y Hx Hy ltac:(unfold few; lra)) as (Hst & Fh & Fl & _ & _ & He).
  destruct (roomy_units s (proj1 Hx)) as (_ & Ws & _), (roomy_units t (proj1 Hy)) as (_ & Wt & _).
  change (Formas.Powers.launched there here) with (Formas.Known (Formas.Powers.difference (Formas.value there) (Formas.value here))
    (rnd (Formas.error there + rnd (2 * Formas.error here)))).
  unfold within_error; cbn [Formas.value Formas.error]; rewrite (rnd_double _ Fy).
  set (E := Formas.error there) in *; set (D := Formas.error here) in *.
  assert (F2 : format (2 * D)) by (rewrite <- (rnd_double _ Fy); apply format_rnd).
  pose proof (rnd_low_sum E (2 * D) Fx F2 ltac:(lra)) as Hr; split; [split; [|split; [|split]]|]; auto using format_rnd.
  - rewrite Rabs_minus_sym; lra.
  - rewrite <- (rnd_format E Fx) at 1; apply rnd_le; lra.
Qed.

(** ** The place on the ray *)

Section Place.
Variables p v : vec.
Variable t : R.
Hypothesis ray_ordinary : ordinary_ray p v.
Hypothesis t_binary64 : format t.

Record offsets := Offsets { ox : twofold; oy : twofold; oz : twofold }.
Definition away (c : vec) : offsets :=
  Offsets (two_sum (cx p) (- cx c)) (two_sum (cy p) (- cy c)) (two_sum (cz p) (- cz c)).
Definition placed_at (c : vec) : offsets :=
  Offsets (Formas.Powers.sum (ox (away c)) (two_prod t (cx v))) (Formas.Powers.sum (oy (away c)) (two_prod t (cy v)))
    (Formas.Powers.sum (oz (away c)) (two_prod t (cz v))).
Definition reached (c : vec) : R :=
  rnd (rnd (rnd (Rabs (hi (ox (away c))) + Rabs (hi (oy (away c)))) + Rabs (hi (oz (away c)))) + rnd (Rabs t * extent_fl v)).
Definition exact_place (c : vec) : vec :=
  Vec (cx p - cx c + t * cx v) (cy p - cy c + t * cy v) (cz p - cz c + t * cz v).

Lemma formats_of a : ordinary_vec a -> format (cx a) /\ format (cy a) /\ format (cz a).
Proof. intros ([X _] & [Y _] & [Z0 _]); auto. Qed.

(** A difference, beside a size m. *)
Lemma offset_loose a c m : format a -> format c -> roomy m -> u * Rabs (hi (two_sum a (- c))) <= m ->
  loose (Rabs (hi (two_sum a (- c))) + m) 1 0 (two_sum a (- c)) (a - c).
Proof.
  intros Fa Fc Hm Hu; pose proof (generic_format_opp _ _ _ Fc) as Fc'; pose proof (Rabs_pos (hi (two_sum a (- c)))).
  apply loose_two_sum; auto; [unfold roomy in *; lra|].
  destruct (sum_lacks a (- c) Fa Fc') as [_ L]; change (hi (two_sum a (- c))) with (rnd (a + - c)) in *.
  replace (a + - c) with (a + - c - rnd (a + - c) + rnd (a + - c)) at 1 by ring.
  apply Rle_trans with (1 := Rabs_triang _ _); lra.
Qed.

(** One coordinate, beside a size m that all of them have: sizes add up to hardly more than what is reached. *)
Lemma coordinate_placed a c b m : format a -> format c -> format b -> roomy m -> u * Rabs (hi (two_sum a (- c))) <= m ->
  loose (Rabs (hi (two_sum a (- c))) + Rabs (t * b) + 2 * m) (2 + / 10) (4 + / 10)
    (Formas.Powers.sum (two_sum a (- c)) (two_prod t b)) (a - c + t * b).
Proof.
  intros Fa Fc Fb Hm Hu; set (d := two_sum a (- c)) in *.
  pose proof (roomy_positive m Hm); pose proof (Rabs_pos (hi d)); pose proof (Rabs_pos (t * b)).
  assert (Ha : loose (Rabs (hi d) + m) (1 + / 100) (1 + / 100) d (a - c)).
  { apply (loose_more _ 1 0); [now apply offset_loose | lra | lra]. }
  assert (Hb : loose (Rabs (t * b) + m) (1 + / 100) (1 + / 100) (two_prod t b) (t * b)).
  { apply loose_two_prod; auto; [unfold roomy in * |]; lra. }
  replace (Rabs (hi d) + Rabs (t * b) + 2 * m) with (Rabs (hi d) + m + (Rabs (t * b) + m)) by ring.
  apply (loose_more _ (1 + / 100 + 1 + / 100) (1 + / 100 + 2 * (1 + / 100) + 1 + / 100)); [|lra | lra].
  apply loose_sum; auto; unfold few; lra.
Qed.

Lemma reached_sizes c : ordinary_vec c -> let d := away c in let a := Rabs (hi (ox d)) + Rabs (hi (oy d)) + Rabs (hi (oz d)) in
  a + Rabs t * extent v <= (1 + / 100000000000) * reached c + 2 * tiny /\ 0 <= reached c.
Proof.
  intros Hc d a; destruct (formats_of v (v_ordinary ray_ordinary)) as (Vx & Vy & Vz).
  assert (Fd : format (hi (ox d)) /\ format (hi (oy d)) /\ format (hi (oz d))) by (repeat split; apply format_rnd).
  destruct Fd as (Dx & Dy & Dz); apply generic_format_abs in Dx, Dy, Dz, Vx, Vy, Vz.
  pose proof (Rabs_pos (hi (ox d))); pose proof (Rabs_pos (hi (oy d))); pose proof (Rabs_pos (hi (oz d))).
  pose proof (Rabs_pos (cx v)); pose proof (Rabs_pos (cy v)); pose proof (Rabs_pos (cz v)); pose proof (Rabs_pos t) as Ht.
  pose proof (rnd_low_sum _ _ Dx Dy ltac:(lra)) as E1; set (s1 := rnd (Rabs (hi (ox d)) + Rabs (hi (oy d)))) in *.
  pose proof (rnd_low_sum s1 _ (format_rnd _) Dz ltac:(lra)) as E2; set (s2 := rnd (s1 + Rabs (hi (oz d)))) in *.
  pose proof (rnd_low_sum _ _ Vx Vy ltac:(lra)) as E3; set (w1 := rnd (Rabs (cx v) + Rabs (cy v))) in *.
  pose proof (rnd_low_sum w1 _ (format_rnd _) Vz ltac:(lra)) as E4; change (rnd (w1 + Rabs (cz v))) with (extent_fl v) in E4.
  assert (HV : (1 - 2 * e12) * extent v <= extent_fl v) by (unfold extent in *; lra).
  assert (HtV : (1 - 2 * e12) * (Rabs t * extent v) <= Rabs t * extent_fl v).
  { replace ((1 - 2 * e12) * (Rabs t * extent v)) with (Rabs t * ((1 - 2 * e12) * extent v)) by ring.
    apply Rmult_le_compat_l; assumption. }
  assert (Ht0 : 0 <= Rabs t * extent v) by (apply Rmult_le_pos; [exact Ht | apply extent_nonneg]).
  pose proof (rnd_low_any (Rabs t * extent_fl v) ltac:(lra)) as E5; pose proof (rnd_nonneg (Rabs t * extent_fl v) ltac:(lra)) as E6.
  set (tV := rnd (Rabs t * extent_fl v)) in *; pose proof (bpow_gt_0 radix2 (-1074)).
  pose proof (rnd_low_sum s2 tV (format_rnd _) (format_rnd _) ltac:(lra)) as E7.
  change (reached c) with (rnd (s2 + tV)); split; [unfold a; lra | apply rnd_nonneg; lra].
Qed.

(** The three, beside any size M that is no less than what is reached. *)
Theorem placed_loose c M : ordinary_vec c -> bpow radix2 (-800) <= M -> reached c <= M -> exists x y z,
  let q := placed_at c in let e := exact_place c in
  loose x (2 + / 10) (4 + / 10) (ox q) (cx e) /\ loose y (2 + / 10) (4 + / 10) (oy q) (cy e) /\
  loose z (2 + / 10) (4 + / 10) (oz q) (cz e) /\ / 10000000 * M <= x /\ / 10000000 * M <= y /\ / 10000000 * M <= z /\
  x + y + z <= reached c + / 100000 * M.
Proof.
  intros Hc HM HW; destruct (reached_sizes c Hc) as [Hs H0]; destruct (formats_of p (p_ordinary ray_ordinary)) as (Px & Py &
    Pz).
  destruct (formats_of v (v_ordinary ray_ordinary)) as (Vx & Vy & Vz), (formats_of c Hc) as (Cx & Cy & Cz).
  assert (HM0 : 0 < M) by (apply Rlt_le_trans with (2 := HM), bpow_gt_0).
  assert (Hz : tiny <= / 1000000 * M).
  { apply Rle_trans with (/ 1000000 * bpow radix2 (-800)); [|apply Rmult_le_compat_l; lra].
    replace (-1074)%Z with (-274 + -800)%Z by reflexivity; rewrite bpow_plus; apply Rmult_le_compat_r; [apply bpow_ge_0|].
    apply Rle_trans with (bpow radix2 (-20)); [apply bpow_le; lia|]; replace (bpow radix2 (-20)) with (/ 1048576) by reflexivity; lra. }
  set (m := / 1000000 * M); assert (Hm : roomy m).
  { unfold roomy, m; apply Rle_trans with (/ 1000000 * bpow radix2 (-800)); [|apply Rmult_le_compat_l; lra].
    replace (-900)%Z with (-100 + -800)%Z by reflexivity; rewrite bpow_plus; apply Rmult_le_compat_r; [apply bpow_ge_0|].
    apply Rle_trans with (bpow radix2 (-20)); [apply bpow_le; lia|]; replace (bpow radix2 (-20)) with (/ 1048576) by reflexivity; lra. }
  cbv zeta in Hs; set (d := away c) in *; pose proof (Rabs_pos t) as Ht.
  pose proof (Rabs_pos (hi (ox d))); pose proof (Rabs_pos (hi (oy d))); pose proof (Rabs_pos (hi (oz d))).
  assert (Hext : Rabs t * extent v = Rabs (t * cx v) + Rabs (t * cy v) + Rabs (t * cz v)).
  { rewrite !Rabs_mult; unfold extent; ring. }
  rewrite Hext in Hs; pose proof (Rabs_pos (t * cx v)); pose proof (Rabs_pos (t * cy v)); pose proof (Rabs_pos (t * cz v)).
  assert (Small : forall h, 0 <= h <= 2 * M -> u * h <= m).
  { intros h Hh; pose proof (u_part h ltac:(lra)); unfold m; lra. }
  exists (Rabs (hi (ox d)) + Rabs (t * cx v) + 2 * m), (Rabs (hi (oy d)) + Rabs (t * cy v) + 2 * m),
    (Rabs (hi (oz d)) + Rabs (t * cz v) + 2 * m); cbv zeta.
  split; [apply coordinate_placed; auto; apply Small; fold (ox d); change (two_sum (cx p) (- cx c)) with (ox d); lra|].
  split; [apply coordinate_placed; auto; apply Small; change (two_sum (cy p) (- cy c)) with (oy d); lra|].
  split; [apply coordinate_placed; auto; apply Small; change (two_sum (cz p) (- cz c)) with (oz d); lra|].
  unfold m; lra.
Qed.
End Place.

(** ** What the shapes share *)

Lemma roomy_product a b : bpow radix2 (-450) <= a -> bpow radix2 (-450) <= b -> roomy (a * b).
Proof.
  intros Ha Hb; unfold roomy; replace (-900)%Z with (-450 + -450)%Z by reflexivity; rewrite bpow_plus.
  apply Rmult_le_compat; auto using bpow_ge_0.
Qed.

Definition squared (q : offsets) : twofold :=
  Formas.Powers.sum (Formas.Powers.sum (Formas.Powers.square (ox q)) (Formas.Powers.square (oy q))) (Formas.Powers.square (oz q)).
Definition along (q : offsets) (d : vec) : twofold :=
  Formas.Powers.sum (Formas.Powers.sum (Formas.Powers.product_by (ox q) (cx d)) (Formas.Powers.product_by (oy q) (cy d)))
    (Formas.Powers.product_by (oz q) (cz d)).

(** What is computed of a place, with its sizes. *)
Definition at_place (x y z : R) (q : offsets) (e : vec) : Prop :=
  loose x (2 + / 10) (4 + / 10) (ox q) (cx e) /\ loose y (2 + / 10) (4 + / 10) (oy q) (cy e) /\
  loose z (2 + / 10) (4 + / 10) (oz q) (cz e).

(** Counts that are lesser, of numbers. *)
Ltac counts := match goal with |- few _ _ => unfold few; lra | |- _ <= _ => lra end.
Ltac counted H := refine (loose_more _ _ _ _ _ _ _ H _ _); counts.
Ltac counted_sum A B := refine (loose_more _ _ _ _ _ _ _ (loose_sum _ _ _ _ _ _ _ _ A (loose_more _ _ _ _ _ _ _ B _ _) _) _ _); counts.

Lemma squared_loose x y z q e : at_place x y z q e -> bpow radix2 (-450) <= x -> bpow radix2 (-450) <= y ->
  bpow radix2 (-450) <= z -> loose (x * x + y * y + z * z) (7 + / 2) 49 (squared q) (dot e e).
Proof.
  intros (X & Y & Z0) Hx Hy Hz.
  assert (Sq : forall s a c, loose s (2 + / 10) (4 + / 10) a c -> bpow radix2 (-450) <= s ->
    loose (s * s) (5 + / 4) 23 (Formas.Powers.square a) (c * c)).
  { intros s a c H Hs; counted (loose_square s _ _ a c H (roomy_product _ _ Hs Hs) ltac:(counts)). }
  pose proof (loose_sum _ _ _ _ _ _ _ _ (Sq _ _ _ X Hx) (Sq _ _ _ Y Hy) ltac:(counts)) as XY.
  counted_sum XY (Sq _ _ _ Z0 Hz).
Qed.

(** The advance along an axis with components of at most b. *)
Lemma along_loose x y z q e d b : at_place x y z q e -> format (cx d) /\ format (cy d) /\ format (cz d) ->
  Rabs (cx d) <= b /\ Rabs (cy d) <= b /\ Rabs (cz d) <= b -> roomy (x * b) -> roomy (y * b) -> roomy (z * b) ->
  loose ((x + y + z) * b) (5 + / 5) 27 (along q d) (dot e d).
Proof.
  intros (X & Y & Z0) (Fx & Fy & Fz) (Bx & By & Bz) Rx Ry Rz; replace ((x + y + z) * b) with (x * b + y * b + z * b) by ring.
  pose proof (loose_product_by _ b _ _ _ _ _ X Fx Bx Rx ltac:(counts)) as Px.
  pose proof (loose_product_by _ b _ _ _ _ _ Y Fy By Ry ltac:(counts)) as Py.
  pose proof (loose_product_by _ b _ _ _ _ _ Z0 Fz Bz Rz ltac:(counts)) as Pz.
  pose proof (loose_sum _ _ _ _ _ _ _ _ Px Py ltac:(counts)) as Pxy.
  counted_sum Pxy Pz.
Qed.

Lemma power_error_units : bpow radix2 (-95) = 2048 * (u * u).
Proof. replace 2048 with (bpow radix2 11) by reflexivity; now rewrite <- !bpow_plus. Qed.

(** The computed bound: of a factor g and a size m, once and twice. *)
Lemma product_low g m : 0 <= g -> 0 <= m -> bpow radix2 (-1000) <= g * m -> (1 - e12) * (g * m) <= rnd (g * m).
Proof.
  intros Hg Hm H; pose proof (Rmult_le_pos g m Hg Hm); apply rnd_low; [assumption|]; apply (at_least_normal (-1000)); [lia|].
  now rewrite Rabs_pos_eq.
Qed.

Lemma bound_low g m : bpow radix2 (-300) <= g -> bpow radix2 (-300) <= m -> (1 - 3 * e12) * (g * (m * m)) <= rnd (rnd (g * m) * m).
Proof.
  intros Hg Hm; pose proof (bpow_gt_0 radix2 (-300)) as Hb.
  assert (H1 : bpow radix2 (-600) <= g * m).
  { replace (-600)%Z with (-300 + -300)%Z by reflexivity; rewrite bpow_plus; apply Rmult_le_compat; lra. }
  assert (L1 : bpow radix2 (-1000) <= g * m) by (apply Rle_trans with (2 := H1), bpow_le; lia).
  pose proof (product_low g m ltac:(lra) ltac:(lra) L1) as E1; pose proof (rnd_ge_bpow (-600) (g * m) ltac:(lia) H1) as G.
  pose proof (bpow_gt_0 radix2 (-600)) as Hb6.
  assert (H2 : bpow radix2 (-900) <= rnd (g * m) * m).
  { replace (-900)%Z with (-600 + -300)%Z by reflexivity; rewrite bpow_plus; apply Rmult_le_compat; lra. }
  assert (L2 : bpow radix2 (-1000) <= rnd (g * m) * m) by (apply Rle_trans with (2 := H2), bpow_le; lia).
  pose proof (product_low (rnd (g * m)) m ltac:(lra) ltac:(lra) L2) as E2.
  assert ((1 - e12) * (g * m) * m <= rnd (g * m) * m) by (apply Rmult_le_compat_r; lra).
  assert (0 <= g * m * m) by (apply Rmult_le_pos; lra); lra.
Qed.

Lemma squares_below a b c : 0 <= a -> 0 <= b -> 0 <= c -> a * a + b * b + c * c <= (a + b + c) * (a + b + c).
Proof.
  intros Ha Hb Hc; pose proof (Rmult_le_pos a b Ha Hb); pose proof (Rmult_le_pos b c Hb Hc); pose proof (Rmult_le_pos a c Ha Hc); lra.
Qed.

Lemma square_below a b : 0 <= a <= b -> a * a <= b * b.
Proof. intros [Ha Hb]; apply Rmult_le_compat; lra. Qed.

Lemma uu_positive : 0 < u * u.
Proof. apply Rmult_lt_0_compat; apply bpow_gt_0. Qed.

(** The bound of a shape that is computed of squares: of 2^-95 κ M² no more is asked than there is. *)
Lemma bound_suffices s kappa g M m : 1 <= kappa -> (1 - 4 * e12) * (2048 * (u * u) * kappa) <= g -> (1 - 4 * e12) * M <= m ->
  bpow radix2 (-100) <= M -> s <= (4 + / 8) * (kappa * (M * M)) ->
  480 * (u * (u * s)) <= rnd (rnd (g * m) * m) /\ kappa * bpow radix2 (-300) <= rnd (rnd (g * m) * m).
Proof.
  intros Hk Hg Hm HM Hs; pose proof uu_positive as Hu; pose proof (bpow_gt_0 radix2 (-100)) as H100.
  assert (H96 : bpow radix2 (-96) = 1024 * (u * u)).
  { replace 1024 with (bpow radix2 10) by reflexivity; now rewrite <- !bpow_plus. }
  assert (Lg0 : kappa * bpow radix2 (-96) <= g).
  { apply Rle_trans with (2 := Hg); rewrite H96; assert (u * u * 1 <= u * u * kappa) by (apply Rmult_le_compat_l; lra); lra. }
  assert (Lg : bpow radix2 (-96) <= g).
  { apply Rle_trans with (2 := Lg0); rewrite <- (Rmult_1_l (bpow _ _)) at 1; apply Rmult_le_compat_r; [apply bpow_ge_0 | exact Hk]. }
  assert (Lm : bpow radix2 (-101) <= m).
  { apply Rle_trans with (2 := Hm); replace (-101)%Z with (-1 + -100)%Z by reflexivity; rewrite bpow_plus.
    replace (bpow radix2 (-1)) with (/ 2) by reflexivity; lra. }
  assert (B : bpow radix2 (-300) <= g /\ bpow radix2 (-300) <= m).
  { split; [apply Rle_trans with (2 := Lg) | apply Rle_trans with (2 := Lm)]; apply bpow_le; lia. }
  pose proof (bound_low g m (proj1 B) (proj2 B)) as E; pose proof (bpow_gt_0 radix2 (-101)) as H101.
  assert (HMM : 0 < M * M) by (apply Rmult_lt_0_compat; lra).
  pose proof (square_below ((1 - 4 * e12) * M) m ltac:(split; [apply Rmult_le_pos; lra | exact Hm])) as Hmm.
  set (K := kappa * (M * M)) in *; assert (HK : 0 < K) by (apply Rmult_lt_0_compat; lra).
  assert (G : (1 - 4 * e12) * (2048 * (u * u) * kappa) * ((1 - 4 * e12) * M * ((1 - 4 * e12) * M)) <= g * (m * m)).
  { apply Rmult_le_compat; [|apply Rmult_le_pos; apply Rmult_le_pos; lra | exact Hg | exact Hmm].
    apply Rmult_le_pos; [lra | apply Rmult_le_pos; lra]. }
  replace ((1 - 4 * e12) * (2048 * (u * u) * kappa) * ((1 - 4 * e12) * M * ((1 - 4 * e12) * M)))
    with ((1 - 4 * e12) * (1 - 4 * e12) * (1 - 4 * e12) * 2048 * (u * u * K)) in G by (unfold K; ring).
  pose proof (Rmult_lt_0_compat _ _ Hu HK) as HuK.
  assert (Hsu : u * u * s <= u * u * ((4 + / 8) * K)) by (apply Rmult_le_compat_l; lra); split.
  - replace (u * (u * s)) with (u * u * s) by ring; lra.
  - assert (L2 : kappa * (bpow radix2 (-96) * (bpow radix2 (-101) * bpow radix2 (-101))) <= g * (m * m)).
    { rewrite <- Rmult_assoc; apply Rmult_le_compat; [apply Rmult_le_pos; [lra | apply bpow_ge_0] | | exact Lg0 |].
      - apply Rmult_le_pos; apply bpow_ge_0.
      - apply Rmult_le_compat; auto using bpow_ge_0. }
    rewrite <- !bpow_plus in L2; apply Rle_trans with (2 := E).
    replace (-300)%Z with (-2 + (-96 + (-101 + -101)))%Z by reflexivity; rewrite bpow_plus; replace (bpow radix2 (-2)) with (/ 4) by reflexivity.
    set (b := bpow radix2 (-96 + (-101 + -101))) in *; assert (0 < kappa * b) by (apply Rmult_lt_0_compat; [lra | apply bpow_gt_0]).
    lra.
Qed.

(** Two points that are not one are not near. *)
Lemma away_far p c : ordinary_vec p -> ordinary_vec c -> minus p c <> Vec 0 0 0 -> let d := away p c in
  bpow radix2 (-152) <= Rabs (hi (ox d)) + Rabs (hi (oy d)) + Rabs (hi (oz d)).
Proof.
  intros Hp Hc N d; destruct (ordinary_on_grid p Hp) as (_ & _ & _ & Gx & Gy & Gz).
  destruct (ordinary_on_grid c Hc) as (_ & _ & _ & Hx & Hy & Hz).
  assert (Far : forall a b, grid (-152) a -> grid (-152) b -> a - b <> 0 -> bpow radix2 (-152) <= Rabs (hi (two_sum a (- b)))).
  { intros a b Ga Gb Nab; change (hi (two_sum a (- b))) with (rnd (a - b)); pose proof (grid_plus _ _ _ Ga (grid_opp _ _ Gb)) as G.
    apply grid_at_least; [now apply grid_rnd|]; intros Z0; apply Nab; pose proof (grid_at_least (-152) (a - b) G Nab) as L.
    pose proof (rnd_rel (a - b) (grid_normal (-152) _ ltac:(lia) G)) as H; rewrite Z0, Rminus_0_l, Rabs_Ropp in H.
    pose proof u_bounds; pose proof (bpow_gt_0 radix2 (-152)); pose proof (u_part _ (Rabs_pos (a - b))); lra. }
  pose proof (Rabs_pos (hi (ox d))); pose proof (Rabs_pos (hi (oy d))); pose proof (Rabs_pos (hi (oz d))).
  destruct (Req_dec (cx p - cx c) 0) as [Zx|Nx]; [|pose proof (Far _ _ Gx Hx Nx) as L; change (two_sum (cx p) (- cx c)) with (ox d) in L; lra].
  destruct (Req_dec (cy p - cy c) 0) as [Zy|Ny]; [|pose proof (Far _ _ Gy Hy Ny) as L; change (two_sum (cy p) (- cy c)) with (oy d) in L; lra].
  destruct (Req_dec (cz p - cz c) 0) as [Zz|Nz]; [|pose proof (Far _ _ Gz Hz Nz) as L; change (two_sum (cz p) (- cz c)) with (oz d) in L; lra].
  exfalso; apply N; unfold minus; now rewrite Zx, Zy, Zz.
Qed.

(** ** The sphere and the plane *)

Section Shapes.
Variables p v : vec.
Variable t : R.
Hypothesis ray_ordinary : ordinary_ray p v.
Hypothesis t_binary64 : format t.
Variable c : vec.
Hypothesis c_ordinary : ordinary_vec c.
Let q := placed_at p v t c.
Let e := exact_place p v t c.
Let W := reached p v t c.

(** The place beside a size M that is at least W and not too small. *)
Lemma placed_beside M : bpow radix2 (-400) <= M -> W <= M -> exists x y z, at_place x y z q e /\
  bpow radix2 (-450) <= x /\ bpow radix2 (-450) <= y /\ bpow radix2 (-450) <= z /\ x + y + z <= W + / 100000 * M.
Proof.
  intros HM HW; destruct (placed_loose p v t ray_ordinary t_binary64 c M c_ordinary) as (x & y & z & X & Y & Z0 & Hx & Hy & Hz
    & S);
    [apply Rle_trans with (2 := HM), bpow_le; lia | exact HW|].
  assert (L : bpow radix2 (-450) <= / 10000000 * M).
  { apply Rle_trans with (/ 10000000 * bpow radix2 (-400)); [|apply Rmult_le_compat_l; lra].
    replace (-450)%Z with (-50 + -400)%Z by reflexivity; rewrite bpow_plus; apply Rmult_le_compat_r; [apply bpow_ge_0|].
    apply Rle_trans with (bpow radix2 (-24)); [apply bpow_le; lia|]; replace (bpow radix2 (-24)) with (/ 16777216) by reflexivity; lra. }
  exists x, y, z; split; [now split | split; [lra | split; [lra | split; [lra | exact S]]]].
Qed.

Lemma reached_nonneg : 0 <= W.
Proof. apply (reached_sizes p v t ray_ordinary c c_ordinary). Qed.

Theorem sphere_powered r : ordinary r -> 0 < r -> let f := Formas.Powers.esfera t p v (extent_fl v) c r in
  powered f (dot e e - r * r) /\ 1 * bpow radix2 (-300) <= Formas.error f.
Proof.
  intros Hr Hr0; pose proof (r_least r Hr Hr0) as Lr; pose proof (proj1 Hr) as Fr; pose proof reached_nonneg as HW.
  change (Formas.Powers.esfera t p v (extent_fl v) c r) with (let m := rnd (W + r) in
    Formas.Known (Formas.Powers.difference (squared q) (two_prod r r)) (rnd (rnd (bpow radix2 (-95) * m) * m))); cbv zeta.
  set (M := W + r); assert (EM : M = W + r) by reflexivity; set (m := rnd M).
  destruct (placed_beside M) as (x & y & z & P & Hx & Hy & Hz & S); 
    [apply Rle_trans with r; [apply Rle_trans with (2 := Lr), bpow_le; lia | lra] | lra|].
  pose proof (bpow_gt_0 radix2 (-450)) as B450; pose proof (squared_loose x y z q e P Hx Hy Hz) as Sq.
  pose proof (rnd_low_sum W r (format_rnd _) Fr ltac:(lra)) as Em; fold M m in Em.
  assert (Rr : roomy (r * r)) by (apply roomy_product; apply Rle_trans with (2 := Lr), bpow_le; lia).
  assert (Rt : loose (r * r) (7 + / 2) 49 (two_prod r r) (r * r)).
  { counted (loose_two_prod (r * r) r r Rr Fr Fr ltac:(rewrite Rabs_pos_eq; [lra | apply Rmult_le_pos; lra])). }
  pose proof (loose_difference _ _ _ _ _ _ _ _ Sq Rt ltac:(counts)) as D.
  assert (Hs : x * x + y * y + z * z + r * r <= (4 + / 8) * (1 * (M * M))).
  { pose proof (squares_below x y z ltac:(lra) ltac:(lra) ltac:(lra)).
    pose proof (squares_below (x + y + z) r 0 ltac:(lra) ltac:(lra) ltac:(lra)).
    pose proof (square_below (x + y + z + r) (2 * M) ltac:(lra)); pose proof (Rle_0_sqr M) as HM2; unfold Rsqr in HM2; lra. }
  destruct (bound_suffices _ 1 (bpow radix2 (-95)) M m (Rle_refl 1) ltac:(rewrite power_error_units; pose proof uu_positive; lra)
    ltac:(lra) ltac:(lra) Hs) as [H1 H2].
  split; [|exact H2]; exists (x * x + y * y + z * z + r * r); split; [counted D | split; [exact H1 | apply format_rnd]].
Qed.

(** An axis of the text: its components are hardly more than 1. *)
Lemma axis_components d : Rabs (dot d d - 1) <= / 1000000 ->
  Rabs (cx d) <= 1 + / 1000000 /\ Rabs (cy d) <= 1 + / 1000000 /\ Rabs (cz d) <= 1 + / 1000000.
Proof.
  intros Hd; apply Rabs_le_inv in Hd; unfold dot in Hd.
  assert (One : forall a b k, a * a + b * b + k * k <= 1 + / 1000000 -> Rabs a <= 1 + / 1000000).
  { intros a b k H; apply Rsqr_incr_0_var; [|lra]; rewrite <- Rsqr_abs; unfold Rsqr.
    pose proof (Rle_0_sqr b) as Hb; pose proof (Rle_0_sqr k) as Hk; unfold Rsqr in Hb, Hk; lra. }
  split; [|split]; [apply (One _ (cy d) (cz d)) | apply (One _ (cx d) (cz d)) | apply (One _ (cx d) (cy d))]; lra.
Qed.

Lemma reached_far : minus p c <> Vec 0 0 0 -> bpow radix2 (-153) <= W.
Proof.
  intros N; pose proof (away_far p c (p_ordinary ray_ordinary) c_ordinary N) as L;
  destruct (reached_sizes p v t ray_ordinary c c_ordinary) as [H _].
  pose proof (Rmult_le_pos _ _ (Rabs_pos t) (extent_nonneg v)); cbv zeta in H; fold W in H; pose proof reached_nonneg.
  pose proof (bpow_gt_0 radix2 (-153)); assert (Hz : tiny <= / 100 * bpow radix2 (-153)).
  { replace (-1074)%Z with (-921 + -153)%Z by reflexivity; rewrite bpow_plus; apply Rmult_le_compat_r; [lra|].
    apply Rle_trans with (bpow radix2 (-7)); [apply bpow_le; lia|]; replace (bpow radix2 (-7)) with (/ 128) by reflexivity; lra. }
  replace (-152)%Z with (1 + -153)%Z in L by reflexivity; rewrite bpow_plus in L; replace (bpow radix2 1) with 2 in L by reflexivity; lra.
Qed.

Theorem plane_powered d : ordinary_vec d -> Rabs (dot d d - 1) <= / 1000000 -> minus p c <> Vec 0 0 0 ->
  let f := Formas.Powers.plano t p v (extent_fl v) c d in powered f (dot e d) /\ bpow radix2 (-560) <= Formas.error f.
Proof.
  intros Hd Hdd N; pose proof (reached_far N) as HW; destruct (axis_components d Hdd) as (Bx & By & Bz).
  change (Formas.Powers.plano t p v (extent_fl v) c d) with (Formas.Known (along q d) (rnd (bpow radix2 (-95) * W))).
  destruct (placed_beside W) as (x & y & z & P & Hx & Hy & Hz & S); [apply Rle_trans with (2 := HW), bpow_le; lia | lra|].
  cbv zeta; unfold powered; cbn [Formas.value Formas.error]; pose proof (bpow_gt_0 radix2 (-450)); pose proof (bpow_gt_0 radix2 (-153)) as H153.
  assert (Room : forall s, bpow radix2 (-450) <= s -> roomy (s * (1 + / 1000000))).
  { intros s Hs; unfold roomy; pose proof (bpow_le radix2 (-900) (-450) ltac:(lia)); lra. }
  pose proof (along_loose x y z q e d _ P (formats_of d Hd) (conj Bx (conj By Bz)) (Room x Hx) (Room y Hy) (Room z Hz)) as A.
  assert (L1 : bpow radix2 (-248) <= bpow radix2 (-95) * W).
  { replace (-248)%Z with (-95 + -153)%Z by reflexivity; rewrite bpow_plus; apply Rmult_le_compat_l; [apply bpow_ge_0 | exact HW]. }
  assert (L2 : bpow radix2 (-1000) <= bpow radix2 (-95) * W) by (apply Rle_trans with (2 := L1), bpow_le; lia).
  pose proof (product_low (bpow radix2 (-95)) W (bpow_ge_0 _ _) ltac:(lra) L2) as E; split.
  - exists ((x + y + z) * (1 + / 1000000)); split; [counted A | split; [|apply format_rnd]].
    apply Rle_trans with (2 := E); rewrite power_error_units; pose proof uu_positive as Hu.
    assert (u * u * ((x + y + z) * (1 + / 1000000)) <= u * u * (2 * W)) by (apply Rmult_le_compat_l; lra).
    assert (0 < u * u * W) by (apply Rmult_lt_0_compat; lra); lra.
  - apply rnd_ge_bpow; [lia|]; apply Rle_trans with (2 := L1), bpow_le; lia.
Qed.
End Shapes.
