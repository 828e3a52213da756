(** * Slab: a box test in floating point that never rejects a ray that meets the box

    After Ize 2013: one multiplication widens the exit, so that the rounding of three operations on each side cannot
    put the exit before the entry. Two things are added to his argument. The comparison is proved for IEEE 754
    operations with their infinities, NaN and signed zeros (a direction parallel to a slab has 1/v = ±∞, and 0·∞ is a
    NaN that must change nothing), and one addition covers the underflow of the products. Any precision: binary32 and
    binary64 are instances.

    What is proved, of these operations, each rounded once to nearest (u is half an ulp of 1):
      near_i = ((signbit(v_i) ? hi_i : lo_i) - p_i) * (1 / v_i)
      far_i  = ((signbit(v_i) ? lo_i : hi_i) - p_i) * (1 / v_i)
      entry  = 0;     for each i: entry = near_i > entry ? near_i : entry
      exit   = best;  for each i: exit  = far_i  < exit  ? far_i  : exit
      visit the box when  entry <= exit * grow + tiny,  grow = 1 + 16u, tiny the least normal number
                  binary64: grow = 1 + 2^-49, tiny = 2^-1022;  binary32: grow = 1 + 2^-20, tiny = 2^-126
    under these conditions:
      every v_i is 0, of either sign, or 2^(2-emax) <= |v_i| <= 2^(emax-2)   (2^-1022 … 2^1022; 2^-126 … 2^126)
      the box and the origin are finite, at most 2^(emax-2) in magnitude
      best is +∞, or the parameter of the best hit so far rounded to nearest, or more.

    float                 == an IEEE 754 number of prec bits, below 2^emax
    crossing plane p v    == (plane - p) * (1 / v), computed
    slab                  == lo, hi, p, v along one axis
    entry, exit, visit    == as above;  later, sooner == one step of entry, of exit
    slab_ok a             == the conditions above, along one axis
    covers a t            == lo <= p + t v <= hi, exactly
    not_before best t     == best is +∞, or at least t rounded *)
From Coq Require Import Reals ZArith List Bool Lra Lia Psatz.
From Flocq Require Import Core Relative Plus_error BinarySingleNaN.
Import ListNotations.
Local Open Scope R_scope.

(** Each power is far less than the one before. *)
Lemma powers x : 0 < x <= / 256 -> 0 <= x * x <= / 256 * x /\ 0 <= x * x * x <= / 256 * (x * x)
  /\ 0 <= x * x * x * x <= / 256 * (x * x * x) /\ 0 <= x * x * x * x * x <= / 256 * (x * x * x * x)
  /\ 0 <= x * x * x * x * x * x <= / 256 * (x * x * x * x * x).
Proof.
  intros Hx; assert (H : forall y, 0 <= y -> 0 <= y * x <= / 256 * y).
  { intros y Hy; split; [apply Rmult_le_pos; lra | rewrite Rmult_comm; apply Rmult_le_compat_r; lra]. }
  assert (0 <= x) by lra; repeat split; repeat (apply H || apply Rmult_le_pos; try assumption).
Qed.

Lemma sign_of_product x y : x * y <> 0 -> xorb (Rlt_bool x 0) (Rlt_bool y 0) = Rlt_bool (x * y) 0.
Proof.
  intros H; destruct (Rtotal_order x 0) as [X|[Z0|X]], (Rtotal_order y 0) as [Y|[Z0'|Y]];
    try (exfalso; rewrite ?Z0, ?Z0' in H; apply H; ring);
    [assert (0 < - x * - y) | assert (0 < - x * y) | assert (0 < x * - y) | assert (0 < x * y)];
    try (apply Rmult_lt_0_compat; lra); repeat first [rewrite Rlt_bool_true by lra | rewrite Rlt_bool_false by lra]; easy.
Qed.

(** The three roundings of each side and the two of the last line are within 1 + 16u; the errors n of underflow, within
    the least normal number. *)
Lemma slack u n t f m g : 0 < u <= / 256 -> 0 < n -> 0 <= t -> 0 <= f ->
  t * ((1 - u) * (1 - u) * (1 - u)) - n <= f -> 128 * n <= m -> f * (1 + 16 * u) * (1 - u) - n <= g -> 0 <= g ->
  t * ((1 + u) * (1 + u) * (1 + u)) + n <= (g + m) * (1 - u) - n.
Proof.
  intros Hu Hn Ht Hf Hlow Hm Hg Hg0; destruct (powers u Hu) as (P2 & P3 & P4 & P5 & P6).
  set (c := (1 + 16 * u) * (1 - u) * (1 - u)).
  assert (Hc2 : 0 <= c <= 2) by (unfold c; lra).
  assert (Hc : (1 + u) * (1 + u) * (1 + u) <= (1 - u) * (1 - u) * (1 - u) * c) by (unfold c; lra).
  apply (Rmult_le_compat_l t _ _ Ht) in Hc.
  assert (Hmid : (t * ((1 - u) * (1 - u) * (1 - u)) - n) * c <= f * c) by (apply Rmult_le_compat_r; lra).
  assert (n * c <= n * 2) by (apply Rmult_le_compat_l; lra).
  assert ((f * (1 + 16 * u) * (1 - u) - n) * (1 - u) <= g * (1 - u)) by (apply Rmult_le_compat_r; lra).
  replace (f * c) with (f * (1 + 16 * u) * (1 - u) * (1 - u)) in Hmid by (unfold c; ring).
  assert (0 <= u * n) by (apply Rmult_le_pos; lra); assert (u * m <= / 256 * m) by (apply Rmult_le_compat_r; lra).
  lra.
Qed.

Section Slab.

Variables prec emax : Z.
Context (prec_gt_0 : Prec_gt_0 prec) (prec_lt_emax : Prec_lt_emax prec emax).
Hypothesis prec_ge_8 : (8 <= prec)%Z.

Notation float := (binary_float prec emax).
Notation emin := (3 - emax - prec)%Z.
Notation rnd := (round radix2 (FLT_exp emin prec) ZnearestE).
Notation NE := mode_NE.
Notation u := (/ 2 * bpow radix2 (- prec + 1)).
Notation eta := (bpow radix2 emin).
Notation big := (bpow radix2 (emax - 2)).

Definition crossing (plane p v : float) : float := Bmult NE (Bminus NE plane p) (Bdiv NE Bone v).

Record slab := Slab { lo : float; hi : float; origin : float; dir : float }.

Definition near (a : slab) : float := crossing (if Bsign (dir a) then hi a else lo a) (origin a) (dir a).
Definition far (a : slab) : float := crossing (if Bsign (dir a) then lo a else hi a) (origin a) (dir a).

Definition later (x y : float) : float := if Bltb x y then y else x.
Definition sooner (x y : float) : float := if Bltb y x then y else x.

Definition entry (box : list slab) : float := fold_left later (map near box) (B754_zero false).
Definition exit (box : list slab) (best : float) : float := fold_left sooner (map far box) best.

(** The two constants: 1 + 16u and the least normal number. *)
Variables grow tiny : float.
Hypothesis grow_value : is_finite grow = true /\ B2R grow = 1 + 16 * u.
Hypothesis tiny_value : is_finite tiny = true /\ B2R tiny = bpow radix2 (emin + prec - 1).

(** The comparison; and the whole test. *)
Definition passes (enter leave : float) : bool := Bleb enter (Bplus NE (Bmult NE leave grow) tiny).
Definition visit (box : list slab) (best : float) : bool := passes (entry box) (exit box best).

Definition moderate (x : float) : Prop := is_finite x = true /\ Rabs (B2R x) <= big.
Definition slab_ok (a : slab) : Prop :=
  moderate (lo a) /\ moderate (hi a) /\ moderate (origin a) /\ moderate (dir a) /\
  (B2R (dir a) = 0 \/ bpow radix2 (2 - emax) <= Rabs (B2R (dir a))).

Definition covers (a : slab) (t : R) : Prop :=
  B2R (lo a) <= B2R (origin a) + t * B2R (dir a) <= B2R (hi a).

(** ** Rounding *)

Lemma u_bounds : 0 < u <= / 256.
Proof.
  split; [apply Rmult_lt_0_compat; [lra | apply bpow_gt_0]|].
  replace (/ 256) with (/ 2 * bpow radix2 (-7)) by (simpl; lra).
  apply Rmult_le_compat_l; [lra | apply bpow_le; lia].
Qed.

Lemma eta_pos : 0 < eta. Proof. apply bpow_gt_0. Qed.

Lemma rnd_le x y : x <= y -> rnd x <= rnd y.
Proof. apply round_le; auto with typeclass_instances. Qed.

Lemma rnd_0 : rnd 0 = 0.
Proof. apply round_0; auto with typeclass_instances. Qed.

Lemma rnd_upper y : 0 <= y -> rnd y <= y * (1 + u) + eta.
Proof.
  intros Hy; destruct (error_N_FLT radix2 emin prec prec_gt_0 (fun n => negb (Z.even n)) y)
    as (e & n & He & Hn & _ & ->).
  apply Rabs_le_inv in He, Hn; pose proof eta_pos; pose proof (Rmult_le_compat_l y e u Hy (proj2 He)); lra.
Qed.

Lemma rnd_lower y : 0 <= y -> y * (1 - u) - eta <= rnd y.
Proof.
  intros Hy; destruct (error_N_FLT radix2 emin prec prec_gt_0 (fun n => negb (Z.even n)) y)
    as (e & n & He & Hn & _ & ->).
  apply Rabs_le_inv in He, Hn; pose proof eta_pos; pose proof (Rmult_le_compat_l y (- u) e Hy (proj1 He)); lra.
Qed.

(** A bound of an operation's exact result keeps it from overflow. *)
Lemma no_overflow y e : (e < emax)%Z -> (emin <= e)%Z -> Rabs y <= bpow radix2 e -> Rabs (rnd y) < bpow radix2 emax.
Proof.
  intros He Hm Hy; apply Rle_lt_trans with (bpow radix2 e); [|now apply bpow_lt].
  apply abs_round_le_generic; auto with typeclass_instances.
  apply generic_format_bpow; unfold FLT_exp; lia.
Qed.

Lemma finite_sign (x : float) : is_finite x = true -> B2R x <> 0 -> Bsign x = Rlt_bool (B2R x) 0.
Proof.
  destruct x as [s| | |s m e H]; simpl; try discriminate; [tauto|]; intros _ _.
  destruct s; [rewrite Rlt_bool_true | rewrite Rlt_bool_false]; auto.
  - now apply F2R_lt_0.
  - now apply F2R_ge_0.
Qed.

(** ** One crossing *)

(** plane - p loses at most one rounding, and never underflows; 1/v loses one. *)
Lemma minus_value x p : moderate x -> moderate p -> exists e, Rabs e <= u /\
  is_finite (Bminus NE x p) = true /\ B2R (Bminus NE x p) = (B2R x - B2R p) * (1 + e).
Proof.
  intros [Fx Hx] [Fp Hp]; pose proof (Bminus_correct prec emax _ _ NE x p Fx Fp) as H.
  rewrite Rlt_bool_true in H.
  - destruct H as (H1 & H2 & _).
    destruct (FLT_plus_error_N_ex radix2 emin prec (fun n => negb (Z.even n)) (B2R x) (- B2R p))
      as (e & He & Heq); [apply generic_format_B2R | apply generic_format_opp, generic_format_B2R |].
    exists e; repeat split; auto; [|rewrite H1; exact Heq].
    apply Rle_trans with (1 := He); unfold u_ro; pose proof u_bounds.
    destruct (powers u u_bounds) as [P2 _]; apply Rmult_le_reg_r with (1 + u); [lra|]; unfold Rdiv.
    rewrite Rmult_assoc, Rinv_l; lra.
  - apply (no_overflow _ (emax - 1)); [lia | |]; [unfold Prec_gt_0, Prec_lt_emax in *; lia|].
    apply Rle_trans with (big + big).
    + unfold Rminus; apply Rle_trans with (1 := Rabs_triang _ _); rewrite Rabs_Ropp; lra.
    + replace (emax - 1)%Z with (emax - 2 + 1)%Z by ring; rewrite bpow_plus_1; simpl; lra.
Qed.

Lemma inverse_value v : moderate v -> bpow radix2 (2 - emax) <= Rabs (B2R v) -> exists e, Rabs e <= u /\
  is_finite (Bdiv NE Bone v) = true /\ B2R (Bdiv NE Bone v) = / B2R v * (1 + e).
Proof.
  intros [Fv Hv] Hlow; pose proof (bpow_gt_0 radix2 (2 - emax)) as Hpos.
  assert (Hv0 : B2R v <> 0) by (intros E; rewrite E, Rabs_R0 in Hlow; lra).
  pose proof (Bdiv_correct prec emax _ _ NE Bone v Hv0) as H; rewrite Bone_correct, is_finite_Bone in H.
  unfold Rdiv in H; rewrite Rmult_1_l in H.
  assert (Hinv : Rabs (/ B2R v) = / Rabs (B2R v)) by now apply Rabs_inv.
  rewrite Rlt_bool_true in H.
  - destruct H as (H1 & H2 & _); rewrite H1, H2.
    destruct (relative_error_N_FLT_ex radix2 emin prec prec_gt_0 (fun n => negb (Z.even n)) (/ B2R v))
      as (e & He & Heq); [|exists e; auto].
    rewrite Hinv; replace (emin + prec - 1)%Z with (- (emax - 2))%Z by ring; rewrite bpow_opp.
    apply Rinv_le; [lra | assumption].
  - apply (no_overflow _ (emax - 2)); [lia | unfold Prec_gt_0, Prec_lt_emax in *; lia |].
    rewrite Hinv; replace (emax - 2)%Z with (- (2 - emax))%Z by ring; rewrite bpow_opp; now apply Rinv_le.
Qed.

(** A crossing of a plane that is not parallel: the exact quotient with three roundings, or an infinity. *)
Lemma crossing_value plane p v : moderate plane -> moderate p -> moderate v ->
  bpow radix2 (2 - emax) <= Rabs (B2R v) ->
  let q := (B2R plane - B2R p) / B2R v in
  exists k, (1 - u) * (1 - u) <= k <= (1 + u) * (1 + u) /\
  (is_finite (crossing plane p v) = true /\ B2R (crossing plane p v) = rnd (q * k)
   \/ crossing plane p v = B754_infinity (Rlt_bool (q * k) 0) /\ bpow radix2 emax <= Rabs (rnd (q * k))).
Proof.
  intros Hplane Hp Hv Hlow q; destruct (minus_value plane p Hplane Hp) as (e1 & He1 & F1 & V1).
  destruct (inverse_value v Hv Hlow) as (e2 & He2 & F2 & V2).
  pose proof (Bmult_correct prec emax _ _ NE (Bminus NE plane p) (Bdiv NE Bone v)) as H; fold (crossing plane p v) in H.
  assert (Hprod : B2R (Bminus NE plane p) * B2R (Bdiv NE Bone v) = q * ((1 + e1) * (1 + e2))).
  { rewrite V1, V2; unfold q, Rdiv; ring. }
  exists ((1 + e1) * (1 + e2)); apply Rabs_le_inv in He1, He2; pose proof u_bounds; split; [split; apply Rmult_le_compat; lra|].
  rewrite Hprod in H; match type of H with if Rlt_bool ?a ?b then _ else _ => destruct (Rlt_bool_spec a b) as [E|E] end.
  - left; destruct H as (H1 & H2 & _); rewrite H1, H2, F1, F2; auto.
  - right; split; [|exact E].
    assert (Hne : q * ((1 + e1) * (1 + e2)) <> 0).
    { intros Z0; rewrite Z0 in E; change (bpow radix2 emax <= Rabs (rnd 0)) in E.
      rewrite rnd_0, Rabs_R0 in E; pose proof (bpow_gt_0 radix2 emax); lra. }
    assert (Hs : xorb (Bsign (Bminus NE plane p)) (Bsign (Bdiv NE Bone v)) = Rlt_bool (q * ((1 + e1) * (1 + e2))) 0).
    { rewrite <- Hprod in *; rewrite !finite_sign by (auto; intros Z0; rewrite Z0 in Hne; apply Hne; ring).
      now apply sign_of_product. }
    rewrite Hs in H; unfold binary_overflow in H; cbn in H.
    destruct (crossing plane p v); cbn in H; try discriminate; congruence.
Qed.

(** ** Entry and exit against the exact parameter *)

(** x does not come after r, as an entry may; NaN and -∞ ask nothing. *)
Definition upper (x : float) (r : R) : Prop :=
  x = B754_nan \/ x = B754_infinity true \/ (is_finite x = true /\ B2R x <= r) \/
  (x = B754_infinity false /\ bpow radix2 emax <= r).
(** x does not come before r, nor before 0, as an exit may; NaN and +∞ ask nothing. *)
Definition lower (x : float) (r : R) : Prop :=
  x = B754_nan \/ x = B754_infinity false \/ (is_finite x = true /\ r <= B2R x /\ 0 <= B2R x).

Lemma parallel s : Bdiv NE Bone (B754_zero s : float) = B754_infinity s.
Proof.
  pose proof (Bone_correct prec emax _ _) as H1; pose proof (Bsign_Bone prec emax _ _) as H2.
  destruct (Bone : float) as [z| | |z m e He]; simpl in H1, H2; try lra; subst z; now destruct s.
Qed.

(** A ray parallel to the slab: an infinity on the right side, or NaN where it lies in the plane. *)
Lemma crossing_parallel plane p s (side : bool) : moderate plane -> moderate p ->
  (if side then B2R plane - B2R p <= 0 else 0 <= B2R plane - B2R p) ->
  crossing plane p (B754_zero s) = B754_nan \/ crossing plane p (B754_zero s) = B754_infinity (xorb side s).
Proof.
  intros Hplane Hp Hside; unfold crossing; rewrite parallel.
  destruct (minus_value plane p Hplane Hp) as (e & He & F & V); apply Rabs_le_inv in He; pose proof u_bounds.
  destruct (Bminus NE plane p) as [| | |z m k Hk]; try discriminate; [now left | right].
  enough (z = side) as -> by reflexivity.
  assert (Hz : if z then B2R (B754_finite z m k Hk) < 0 else 0 < B2R (B754_finite z m k Hk)).
  { destruct z; simpl; [now apply F2R_lt_0 | now apply F2R_gt_0]. }
  rewrite V in Hz; destruct z, side; auto; exfalso.
  - pose proof (Rmult_le_pos (B2R plane - B2R p) (1 + e) Hside ltac:(lra)); lra.
  - pose proof (Rmult_le_pos (- (B2R plane - B2R p)) (1 + e) ltac:(lra) ltac:(lra)); lra.
Qed.

Lemma zero_value (v : float) : moderate v -> B2R v = 0 -> exists s, v = B754_zero s.
Proof.
  intros [F _] H; destruct v as [s| | |s m e Hb]; try discriminate; [now exists s|].
  apply eq_0_F2R in H; destruct s; discriminate.
Qed.

(** Where the ray meets the planes of a slab that it is not parallel to: the near one first. *)
Lemma planes a t : slab_ok a -> bpow radix2 (2 - emax) <= Rabs (B2R (dir a)) -> covers a t ->
  let quotient plane := (B2R plane - B2R (origin a)) / B2R (dir a) in
  quotient (if Bsign (dir a) then hi a else lo a) <= t <= quotient (if Bsign (dir a) then lo a else hi a).
Proof.
  intros (_ & _ & _ & [F _] & _) Hlow [H1 H2] quotient; pose proof (bpow_gt_0 radix2 (2 - emax)).
  assert (Hv0 : B2R (dir a) <> 0) by (intros E; rewrite E, Rabs_R0 in Hlow; lra).
  assert (Hm : forall plane, quotient plane * B2R (dir a) = B2R plane - B2R (origin a)).
  { intros plane; unfold quotient; field; exact Hv0. }
  pose proof (Hm (lo a)); pose proof (Hm (hi a)).
  rewrite (finite_sign _ F Hv0); destruct (Rlt_bool_spec (B2R (dir a)) 0) as [L|L].
  - split; apply Rmult_le_reg_r with (- B2R (dir a)); lra.
  - rewrite Rabs_pos_eq in Hlow by exact L; split; apply Rmult_le_reg_r with (B2R (dir a)); lra.
Qed.

Lemma near_upper a t : slab_ok a -> 0 <= t -> covers a t -> upper (near a) (t * ((1 + u) * (1 + u) * (1 + u)) + eta).
Proof.
  intros Hok Ht Hc; pose proof Hok as (Hlo & Hhi & Hp & Hv & [Hv0|Hlow]); unfold upper, near.
  - destruct Hc as [H1 H2]; rewrite Hv0 in *; destruct (zero_value _ Hv Hv0) as [s ->]; destruct s; simpl Bsign;
      [destruct (crossing_parallel (hi a) (origin a) true false) as [->| ->]
      |destruct (crossing_parallel (lo a) (origin a) false true) as [->| ->]]; simpl; auto; lra.
  - destruct (planes a t Hok Hlow Hc) as [Hq _]; pose proof u_bounds; pose proof eta_pos.
    set (plane := if Bsign (dir a) then hi a else lo a) in *.
    destruct (crossing_value plane (origin a) (dir a)) as (k & Hk & H'); auto; [unfold plane; now destruct Bsign|].
    set (q := (B2R plane - B2R (origin a)) / B2R (dir a)) in *.
    assert (0 < k) by (pose proof (Rmult_lt_0_compat (1 - u) (1 - u) ltac:(lra) ltac:(lra)); lra).
    assert (0 <= t * ((1 + u) * (1 + u) * (1 + u))) by (repeat apply Rmult_le_pos; lra).
    assert (Hr : rnd (q * k) <= t * ((1 + u) * (1 + u) * (1 + u)) + eta).
    { destruct (Rle_or_lt q 0) as [Hq0|Hq0].
      - apply Rle_trans with 0; [rewrite <- rnd_0; apply rnd_le | lra].
        pose proof (Rmult_le_pos (- q) k ltac:(lra) ltac:(lra)); lra.
      - apply Rle_trans with (1 := rnd_upper (q * k) ltac:(apply Rmult_le_pos; lra)).
        assert (q * k <= t * ((1 + u) * (1 + u))) as Hqk by (apply Rmult_le_compat; lra).
        pose proof (Rmult_le_compat_r (1 + u) _ _ ltac:(lra) Hqk); lra. }
    destruct H' as [[F V]|[-> Hbig]]; [right; right; left; rewrite V; auto|].
    destruct (Rlt_bool_spec (q * k) 0) as [L|L]; [auto | right; right; right; split; auto].
    rewrite Rabs_pos_eq in Hbig; [lra | rewrite <- rnd_0; now apply rnd_le].
Qed.

Lemma far_lower a t : slab_ok a -> 0 <= t -> covers a t -> lower (far a) (t * ((1 - u) * (1 - u) * (1 - u)) - eta).
Proof.
  intros Hok Ht Hc; pose proof Hok as (Hlo & Hhi & Hp & Hv & [Hv0|Hlow]); unfold lower, far.
  - destruct Hc as [H1 H2]; rewrite Hv0 in *; destruct (zero_value _ Hv Hv0) as [s ->]; destruct s; simpl Bsign;
      [destruct (crossing_parallel (lo a) (origin a) true true) as [->| ->]
      |destruct (crossing_parallel (hi a) (origin a) false false) as [->| ->]]; simpl; auto; lra.
  - destruct (planes a t Hok Hlow Hc) as [_ Hq]; pose proof u_bounds; pose proof eta_pos.
    set (plane := if Bsign (dir a) then lo a else hi a) in *.
    destruct (crossing_value plane (origin a) (dir a)) as (k & Hk & H'); auto; [unfold plane; now destruct Bsign|].
    set (q := (B2R plane - B2R (origin a)) / B2R (dir a)) in *.
    pose proof (Rmult_lt_0_compat (1 - u) (1 - u) ltac:(lra) ltac:(lra)).
    assert (Hqk : t * ((1 - u) * (1 - u)) <= q * k) by (apply Rmult_le_compat; lra).
    pose proof (Rmult_le_compat_r (1 - u) _ _ ltac:(lra) Hqk).
    assert (0 <= q * k) by (apply Rmult_le_pos; lra); assert (0 <= rnd (q * k)) by (rewrite <- rnd_0; now apply rnd_le).
    destruct H' as [[F V]|[-> Hbig]]; right; [right | left; now rewrite Rlt_bool_false].
    rewrite V; repeat split; auto; apply Rle_trans with (2 := rnd_lower (q * k) ltac:(assumption)); lra.
Qed.

(** ** All axes *)

Lemma less_not_nan (x y : float) : Bltb x y = true -> x <> B754_nan /\ y <> B754_nan.
Proof. destruct x as [| []| |[]], y as [| []| |[]]; simpl; split; discriminate. Qed.

Lemma entry_upper box r : 0 <= r -> Forall (fun a => upper (near a) r) box ->
  entry box <> B754_nan /\ upper (entry box) r.
Proof.
  intros Hr Hbox; unfold entry.
  assert (Hacc : forall acc, acc <> B754_nan /\ upper acc r ->
    fold_left later (map near box) acc <> B754_nan /\ upper (fold_left later (map near box) acc) r).
  { induction Hbox as [|a box Ha _ IH]; intros acc Hacc; simpl; [exact Hacc|]; apply IH.
    unfold later; destruct (Bltb acc (near a)) eqn:E; [|exact Hacc]; apply less_not_nan in E; tauto. }
  apply Hacc; split; [discriminate | right; right; left; auto].
Qed.

Lemma exit_lower box best r : best <> B754_nan -> lower best r -> Forall (fun a => lower (far a) r) box ->
  exit box best <> B754_nan /\ lower (exit box best) r.
Proof.
  intros Hnan Hbest Hbox; unfold exit; assert (Hacc : best <> B754_nan /\ lower best r) by auto.
  clear Hnan Hbest; revert best Hacc; induction Hbox as [|a box Ha _ IH]; intros acc Hacc; simpl; [exact Hacc|].
  apply IH; unfold sooner; destruct (Bltb (far a) acc) eqn:E; [|exact Hacc]; apply less_not_nan in E; tauto.
Qed.

Lemma absorbed t f : 0 <= t -> 0 <= f -> t * ((1 - u) * (1 - u) * (1 - u)) - eta <= f ->
  t * ((1 + u) * (1 + u) * (1 + u)) + eta <= rnd (rnd (f * B2R grow) + B2R tiny).
Proof.
  destruct grow_value as [_ ->], tiny_value as [_ ->]; intros Ht Hf Hlow; pose proof u_bounds; pose proof eta_pos.
  assert (Htiny : 128 * eta <= bpow radix2 (emin + prec - 1)).
  { replace (emin + prec - 1)%Z with ((prec - 1) + emin)%Z by ring; rewrite bpow_plus.
    apply Rmult_le_compat_r; [apply bpow_ge_0|].
    apply Rle_trans with (bpow radix2 7); [simpl; lra | apply bpow_le; lia]. }
  assert (Hwide : 0 <= f * (1 + 16 * u)) by (apply Rmult_le_pos; lra); pose proof (rnd_lower _ Hwide).
  assert (0 <= rnd (f * (1 + 16 * u))) by (rewrite <- rnd_0; apply rnd_le; lra).
  apply Rle_trans with (2 := rnd_lower (rnd (f * (1 + 16 * u)) + bpow radix2 (emin + prec - 1)) ltac:(lra)).
  now apply (slack _ _ t f).
Qed.

(** The right side of the comparison: +∞, or at least the widened exact parameter. *)
Lemma widened f : is_finite f = true -> 0 <= B2R f ->
  let y := Bplus NE (Bmult NE f grow) tiny in
  y = B754_infinity false \/ (is_finite y = true /\ B2R y = rnd (rnd (B2R f * B2R grow) + B2R tiny)).
Proof.
  intros F Hf y; destruct grow_value as [Fg Vg], tiny_value as [Ft Vt]; pose proof u_bounds.
  pose proof (bpow_gt_0 radix2 (emin + prec - 1)) as Hm.
  assert (St : Bsign tiny = false) by (rewrite finite_sign by (auto; lra); apply Rlt_bool_false; lra).
  assert (Sg : Bsign grow = false) by (rewrite finite_sign by (auto; lra); apply Rlt_bool_false; lra).
  pose proof (Bmult_correct prec emax _ _ NE f grow) as H1.
  match type of H1 with if Rlt_bool ?a ?b then _ else _ => destruct (Rlt_bool_spec a b) as [L|L] end.
  - destruct H1 as (V1 & F1 & _); rewrite F, Fg in F1.
    pose proof (Bplus_correct prec emax _ _ NE (Bmult NE f grow) tiny F1 Ft) as H2.
    match type of H2 with if Rlt_bool ?a ?b then _ else _ => destruct (Rlt_bool_spec a b) as [L2|L2] end.
    + right; destruct H2 as (V2 & F2 & _); rewrite V1 in V2; auto.
    + left; destruct H2 as [H2 H3]; fold y in H2; rewrite H3, St in H2; destruct y; cbn in H2; congruence.
  - left; assert (Hf0 : B2R f <> 0).
    { intros Z0; rewrite Z0, Rmult_0_l in L; change (bpow radix2 emax <= Rabs (rnd 0)) in L.
      rewrite rnd_0, Rabs_R0 in L; pose proof (bpow_gt_0 radix2 emax); lra. }
    rewrite Sg, (finite_sign f F Hf0), Rlt_bool_false in H1 by assumption; unfold y.
    destruct (Bmult NE f grow); cbn in H1; try discriminate; injection H1 as ->.
    destruct tiny; try discriminate; reflexivity.
Qed.

(** What [upper] and [lower] are for. *)
Lemma in_order e x t : 0 <= t ->
  e <> B754_nan /\ upper e (t * ((1 + u) * (1 + u) * (1 + u)) + eta) ->
  x <> B754_nan /\ lower x (t * ((1 - u) * (1 - u) * (1 - u)) - eta) -> Bleb e (Bplus NE (Bmult NE x grow) tiny) = true.
Proof.
  intros Ht [Ne He] [Nx [?|[->|(F & Hr & Hf)]]]; [contradiction | |]; pose proof u_bounds.
  - destruct grow_value as [Fg Vg], tiny_value as [Ft _].
    assert (Bsign grow = false) by (rewrite finite_sign by (auto; lra); apply Rlt_bool_false; lra).
    destruct grow as [| | |[]]; try discriminate; simpl in Vg; try lra.
    destruct tiny; try discriminate; destruct e as [| []| |[]]; try contradiction; reflexivity.
  - destruct (widened _ F Hf) as [->|[Fy Vy]].
    { destruct e as [| []| |[]]; try contradiction; reflexivity. }
    pose proof (absorbed t _ Ht Hf Hr) as Habs; rewrite <- Vy in Habs.
    destruct He as [?|[->|[[Fe Ve]|[-> Hbig]]]]; [contradiction | | |].
    + destruct (Bplus NE _ _) as [| | |[]]; try discriminate; reflexivity.
    + rewrite Bleb_correct by assumption; apply Rle_bool_true; lra.
    + pose proof (abs_B2R_lt_emax _ _ (Bplus NE (Bmult NE x grow) tiny)) as Hlt; apply Rabs_lt_inv in Hlt; lra.
Qed.

(** best is +∞, or at least the parameter t rounded. *)
Definition not_before (best : float) (t : R) : Prop :=
  best = B754_infinity false \/ (is_finite best = true /\ rnd t <= B2R best).

Lemma best_lower best t : 0 <= t -> not_before best t ->
  best <> B754_nan /\ lower best (t * ((1 - u) * (1 - u) * (1 - u)) - eta).
Proof.
  intros Ht [->|[F Hle]]; [split; [discriminate | right; now left]|]; pose proof u_bounds; pose proof eta_pos.
  split; [intros ->; discriminate | right; right; split; [assumption|]].
  assert (0 <= rnd t) by (rewrite <- rnd_0; now apply rnd_le).
  pose proof (rnd_lower t Ht); destruct (powers u u_bounds) as (P2 & P3 & _).
  assert (Hless : (1 - u) * (1 - u) * (1 - u) <= 1 - u) by lra; pose proof (Rmult_le_compat_l t _ _ Ht Hless); split; lra.
Qed.

Lemma entry_before box t : Forall slab_ok box -> 0 <= t -> Forall (fun a => covers a t) box ->
  entry box <> B754_nan /\ upper (entry box) (t * ((1 + u) * (1 + u) * (1 + u)) + eta).
Proof.
  intros Hok Ht Hcov; pose proof u_bounds; pose proof eta_pos; apply entry_upper.
  - assert (0 <= t * ((1 + u) * (1 + u) * (1 + u))) by (repeat apply Rmult_le_pos; lra); lra.
  - rewrite Forall_forall in *; intros a Ha; apply near_upper; auto.
Qed.

(** The test never rejects a box that holds the ray's point at some parameter t >= 0 that is not beyond the best. *)
Theorem slab_never_rejects box best t : Forall slab_ok box -> 0 <= t -> Forall (fun a => covers a t) box ->
  not_before best t -> visit box best = true.
Proof.
  intros Hok Ht Hcov Hbest; apply (in_order _ _ t Ht); [now apply entry_before|].
  destruct (best_lower best t Ht Hbest) as [Hnan Hlow]; apply exit_lower; auto.
  rewrite Forall_forall in *; intros a Ha; apply far_lower; auto.
Qed.

(** A box that waits may be tested again by its stored entry, once the best is nearer. *)
Theorem entry_never_rejects box best t : Forall slab_ok box -> 0 <= t -> Forall (fun a => covers a t) box ->
  not_before best t -> passes (entry box) best = true.
Proof. intros Hok Ht Hcov Hbest; apply (in_order _ _ t Ht); [now apply entry_before | now apply best_lower]. Qed.

(** So may its stretch, computed without a best, and then cut off at it. *)
Theorem stretch_never_rejects box best t : Forall slab_ok box -> 0 <= t -> Forall (fun a => covers a t) box ->
  not_before best t -> passes (entry box) (sooner best (exit box (B754_infinity false))) = true.
Proof.
  intros Hok Ht Hcov Hbest; apply (in_order _ _ t Ht); [now apply entry_before|].
  destruct (best_lower best t Ht Hbest) as [Hnan Hlow].
  destruct (exit_lower box (B754_infinity false) (t * ((1 - u) * (1 - u) * (1 - u)) - eta)) as [Hnan' Hlow'].
  - discriminate.
  - right; now left.
  - rewrite Forall_forall in *; intros a Ha; apply far_lower; auto.
  - unfold sooner; destruct (Bltb _ best); now split.
Qed.

End Slab.

(** ** The two formats *)

Definition prec64 : Prec_gt_0 53 := eq_refl. Definition less64 : Prec_lt_emax 53 1024 := eq_refl.
Definition grow64 : binary_float 53 1024 := @B754_finite 53 1024 false (2 ^ 52 + 8) (-52) eq_refl. (* 1 + 2^-49 *)
Definition tiny64 : binary_float 53 1024 := @B754_finite 53 1024 false (2 ^ 52) (-1074) eq_refl. (* 2^-1022 *)

Definition prec32 : Prec_gt_0 24 := eq_refl. Definition less32 : Prec_lt_emax 24 128 := eq_refl.
Definition grow32 : binary_float 24 128 := @B754_finite 24 128 false (2 ^ 23 + 8) (-23) eq_refl. (* 1 + 2^-20 *)
Definition tiny32 : binary_float 24 128 := @B754_finite 24 128 false (2 ^ 23) (-149) eq_refl. (* 2^-126 *)

Lemma grow64_value : is_finite grow64 = true /\ B2R grow64 = 1 + 16 * (/ 2 * bpow radix2 (- (53) + 1)).
Proof. split; [reflexivity|]; unfold grow64, B2R, F2R; simpl; lra. Qed.
Lemma tiny64_value : is_finite tiny64 = true /\ B2R tiny64 = bpow radix2 (3 - 1024 - 53 + 53 - 1).
Proof.
  split; [reflexivity|]; unfold tiny64, B2R, F2R; cbn [Fnum Fexp cond_Zopp].
  replace (IZR (Z.pos (2 ^ 52))) with (bpow radix2 52) by reflexivity; now rewrite <- bpow_plus.
Qed.

Theorem slab64_never_rejects box best t :
  Forall (slab_ok 53 1024) box -> 0 <= t -> Forall (fun a => covers 53 1024 a t) box ->
  not_before 53 1024 best t ->
  visit 53 1024 prec64 less64 grow64 tiny64 box best = true.
Proof. exact (slab_never_rejects 53 1024 prec64 less64 ltac:(lia) grow64 tiny64 grow64_value tiny64_value box best t). Qed.

Theorem stretch64_never_rejects box best t :
  Forall (slab_ok 53 1024) box -> 0 <= t -> Forall (fun a => covers 53 1024 a t) box ->
  not_before 53 1024 best t ->
  passes 53 1024 prec64 less64 grow64 tiny64 (entry 53 1024 prec64 less64 box)
    (sooner 53 1024 best (exit 53 1024 prec64 less64 box (B754_infinity false))) = true.
Proof. exact (stretch_never_rejects 53 1024 prec64 less64 ltac:(lia) grow64 tiny64 grow64_value tiny64_value box best t). Qed.

Theorem entry64_never_rejects box best t :
  Forall (slab_ok 53 1024) box -> 0 <= t -> Forall (fun a => covers 53 1024 a t) box ->
  not_before 53 1024 best t ->
  passes 53 1024 prec64 less64 grow64 tiny64 (entry 53 1024 prec64 less64 box) best = true.
Proof. exact (entry_never_rejects 53 1024 prec64 less64 ltac:(lia) grow64 tiny64 grow64_value tiny64_value box best t). Qed.

Theorem slab32_never_rejects box best t :
  Forall (slab_ok 24 128) box -> 0 <= t -> Forall (fun a => covers 24 128 a t) box ->
  not_before 24 128 best t ->
  visit 24 128 prec32 less32 grow32 tiny32 box best = true.
Proof.
  apply slab_never_rejects; [lia | split; [reflexivity|] | split; [reflexivity|]].
  - unfold grow32, B2R, F2R; simpl; lra.
  - unfold tiny32, B2R, F2R; cbn [Fnum Fexp cond_Zopp].
    replace (IZR (Z.pos (2 ^ 23))) with (bpow radix2 23) by reflexivity; now rewrite <- bpow_plus.
Qed.
