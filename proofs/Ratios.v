(** * Ratios: what a quotient and a square root of double-doubles lose

    Formas.Pairs.ratio and root_of, of src/trace/double_double-inl.hpp. Both are one step from a binary64: the rest is
    about 3u of what is divided and is known to 3u² of it; dividing its leading part loses as much again for each rounding.
    Here a quotient is shown to lose 14u² at most, a square root 8u². *)
From Coq Require Import Reals ZArith Lra Lia Psatz.
From Flocq Require Import Core.
From Durero Require Import Rounding Twofold Sums Products.
From Durero Require Formas.
Import Formas.Pairs.
Local Open Scope R_scope.
Local Opaque bpow.

(** A number within e of another: its size. *)
Lemma size_near a b e m : Rabs (a - b) <= e -> Rabs b <= m -> Rabs a <= m + e.
Proof. intros Ha Hb; replace a with (b + (a - b)) by ring; apply Rle_trans with (1 := Rabs_triang _ _); lra. Qed.

Lemma size_least a b : Rabs b <= Rabs a + Rabs (a - b).
Proof.
  pose proof (Rabs_triang a (- (a - b))) as H; rewrite Rabs_Ropp in H; replace (a + - (a - b)) with b in H by ring; exact H.
Qed.

(** The leading part of a rest, where the rest is within e of r, and r within m. *)
Lemma leading_of_rest a b r alpha : double_word a -> double_word b -> 0 <= alpha ->
  Rabs (whole a - whole b - r) <= (3 + / 5) * (u * (u * alpha)) -> Rabs r <= (3 + / 100) * (u * alpha) ->
  Rabs (hi (difference a b) - r) <= 7 * (u * (u * alpha)) /\ Rabs (hi (difference a b)) <= (3 + / 50) * (u * alpha).
Proof.
  intros Wa Wb Ha Hr Hsize; destruct (difference_near a b Wa Wb) as [Wd Hd]; set (d := difference a b) in *.
  pose proof (u_part _ Ha) as HU; pose proof (u_part _ (proj1 HU)) as HUU; pose proof (u_part _ (proj1 HUU)) as HUUU.
  pose proof (size_near _ _ _ _ Hr Hsize) as S1; set (rest := whole a - whole b) in *.
  assert (Hu2 : u * (u * Rabs rest) <= u * (u * ((3 + / 50) * (u * alpha)))).
  { pose proof u_bounds; do 2 (apply Rmult_le_compat_l; [lra|]); lra. }
  assert (S2 : Rabs (whole d) <= (3 + / 60) * (u * alpha)).
  { replace (whole d) with (rest + (whole d - rest)) by ring; apply Rle_trans with (1 := Rabs_triang _ _); lra. }
  destruct (word_near d Wd) as [Hh _].
  assert (Hu1 : u * Rabs (whole d) <= u * ((3 + / 60) * (u * alpha))) by (pose proof u_bounds; apply Rmult_le_compat_l; lra).
  split.
  - replace (hi d - r) with ((hi d - whole d) + ((whole d - rest) + (rest - r))) by ring.
    apply Rle_trans with (1 := Rabs_triang _ _); apply Rle_trans with (1 := Rplus_le_compat_l _ _ _ (Rabs_triang _ _)); lra.
  - replace (hi d) with (whole d + (hi d - whole d)) by ring; apply Rle_trans with (1 := Rabs_triang _ _); lra.
Qed.

(** ** Quotients *)

Section Ratio.
Variables x y : twofold.
Hypothesis x_word : double_word x.
Hypothesis y_word : double_word y.
Hypothesis x_size : bpow radix2 (-900) <= Rabs (hi x).
Hypothesis y_not_zero : hi y <> 0.
Hypothesis quotient_size : bpow radix2 (-900) <= Rabs (hi x / hi y).

Let high := rnd (hi x / hi y).
Let rest := difference x (product_by y high).
Let low := rnd (hi rest / hi y).
Let alpha := Rabs (hi x).
Let Q := Rabs (hi x / hi y).
Let P := hi y * high.

(** Qed compares them, with rounding folded. *)
Local Opaque round.
Lemma ratio_is : ratio x y = fast_two_sum high low.
Proof. exact_no_check (eq_refl (fast_two_sum high low)). Qed.
Local Transparent round.

Lemma high_near : Rabs (high - hi x / hi y) <= u * Q /\ Rabs (P - hi x) <= u * alpha.
Proof.
  assert (Hh : Rabs (high - hi x / hi y) <= u * Q).
  { apply rnd_rel; right; apply Rle_trans with (2 := quotient_size), bpow_le; lia. }
  split; [exact Hh|]; unfold P; replace (hi y * high - hi x) with (hi y * (high - hi x / hi y)) by (field; exact y_not_zero).
  rewrite Rabs_mult; apply Rle_trans with (Rabs (hi y) * (u * Q)); [apply Rmult_le_compat_l; [apply Rabs_pos | exact Hh]|].
  replace (Rabs (hi y) * (u * Q)) with (u * (Rabs (hi y) * Q)) by ring; apply Rmult_le_compat_l; [apply bpow_ge_0|].
  unfold Q, alpha; rewrite <- Rabs_mult; replace (hi y * (hi x / hi y)) with (hi x) by (field; exact y_not_zero); apply Rle_refl.
Qed.

(** The exact rest is what is left to divide. *)
Let r := whole x - whole y * high.

Lemma rest_near : Rabs (hi rest - r) <= 7 * (u * (u * alpha)) /\ Rabs (hi rest) <= (3 + / 50) * (u * alpha) /\
  Rabs r <= (3 + / 100) * (u * alpha).
Proof.
  destruct high_near as [Hh HP]; destruct (double_word_is_pair x x_word) as (_ & _ & Lx).
  destruct (double_word_is_pair y y_word) as (_ & _ & Ly); fold alpha in Lx.
  assert (Ha : 0 <= alpha) by apply Rabs_pos; pose proof (u_part _ Ha) as HU; pose proof (u_part _ (proj1 HU)) as HUU.
  assert (Hlarge : bpow radix2 (-960) <= (1 - / 1000) * alpha).
  { apply Rle_trans with (/ 2 * bpow radix2 (-900)); [|unfold alpha; pose proof (bpow_gt_0 radix2 (-900)); lra].
    replace (/ 2) with (bpow radix2 (-1)) by reflexivity; rewrite <- bpow_plus; apply bpow_le; lia. }
  assert (HPa : (1 - / 1000) * alpha <= Rabs P <= (1 + / 1000) * alpha).
  { split.
    - pose proof (size_least P (hi x)) as Hl; fold alpha in Hl; lra.
    - replace P with (hi x + (P - hi x)) by ring; apply Rle_trans with (1 := Rabs_triang _ _); fold alpha; lra. }
  destruct (product_by_near y high y_word (format_rnd _) ltac:(fold P; lra)) as [Wm Hm]; fold P in Hm.
  assert (Huu : u * (u * Rabs P) <= u * (u * ((1 + / 1000) * alpha))).
  { pose proof u_bounds; do 2 (apply Rmult_le_compat_l; [lra|]); lra. }
  assert (Hlow : Rabs (lo y * high) <= (1 + / 1000) * (u * alpha)).
  { rewrite Rabs_mult; apply Rle_trans with (u * Rabs (hi y) * Rabs high); [apply Rmult_le_compat_r; [apply Rabs_pos | exact Ly]|].
    rewrite Rmult_assoc, <- Rabs_mult; fold P; assert (u * Rabs P <= u * ((1 + / 1000) * alpha)); [|lra].
    pose proof u_bounds; apply Rmult_le_compat_l; lra. }
  assert (Hr : Rabs r <= (3 + / 100) * (u * alpha)).
  { unfold r, whole; replace (hi x + lo x - (hi y + lo y) * high) with ((lo x - lo y * high) - (P - hi x)) by (unfold P; ring).
    apply Rabs_le_inv in Hlow, Lx, HP; apply Rabs_le; lra. }
  enough (H : Rabs (hi rest - r) <= 7 * (u * (u * alpha)) /\ Rabs (hi rest) <= (3 + / 50) * (u * alpha)) by tauto.
  apply leading_of_rest; auto.
  replace (whole x - whole (product_by y high) - r) with (- (whole (product_by y high) - whole y * high)) by (unfold r; ring).
  rewrite Rabs_Ropp; lra.
Qed.

Lemma Q_is z : Rabs (z / hi y) * alpha = Rabs z * Q.
Proof.
  unfold alpha, Q; rewrite <- !Rabs_mult; f_equal; field; exact y_not_zero.
Qed.

Lemma by_Q z k : Rabs z <= k * alpha -> Rabs (z / hi y) <= k * Q.
Proof.
  intros Hz; pose proof (bpow_gt_0 radix2 (-900)); assert (Ha : 0 < alpha) by (unfold alpha; lra).
  apply Rmult_le_reg_r with alpha; [exact Ha|]; rewrite Q_is; replace (k * Q * alpha) with (k * alpha * Q) by ring.
  apply Rmult_le_compat_r; [apply Rabs_pos | exact Hz].
Qed.

Theorem ratio_kept : double_word (ratio x y) /\
  Rabs (whole (ratio x y) - whole x / whole y) <= 14 * (u * (u * Rabs (whole x / whole y))).
Proof.
  destruct high_near as [Hh _], rest_near as (Hrest & Srest & Sr), (double_word_is_pair y y_word) as (_ & _ & Ly).
  destruct (double_word_is_pair x x_word) as (_ & _ & Lx); fold alpha in Lx; pose proof u_bounds as Hu.
  assert (HQ : 0 <= Q) by apply Rabs_pos; pose proof (u_part _ HQ) as HU; pose proof (u_part _ (proj1 HU)) as HUU.
  pose proof (u_part _ (proj1 HUU)) as HUUU.
  pose proof (tiny_part Q ltac:(apply Rle_trans with (2 := quotient_size), bpow_le; lia)) as Hz.
  pose proof (by_Q (hi rest) ((3 + / 50) * u) ltac:(lra)) as S1; pose proof (by_Q r ((3 + / 100) * u) ltac:(lra)) as S2.
  pose proof (by_Q (hi rest - r) (7 * (u * u)) ltac:(lra)) as E1.
  pose proof (rnd_any (hi rest / hi y)) as E2; fold low in E2.
  assert (Hu1 : u * Rabs (hi rest / hi y) <= u * ((3 + / 50) * u * Q)) by (apply Rmult_le_compat_l; lra).
  assert (Slow : Rabs low <= 4 * (u * Q)).
  { replace low with (hi rest / hi y + (low - hi rest / hi y)) by ring; apply Rle_trans with (1 := Rabs_triang _ _); lra. }
  assert (Shigh : (1 - / 1000) * Q <= Rabs high).
  { pose proof (size_least high (hi x / hi y)) as Hl; fold Q in Hl; lra. }
  assert (Hroom_low : Rabs low <= Rabs high) by lra.
  destruct (fast_two_sum_exact high low (format_rnd _) (format_rnd _) (or_intror Hroom_low)) as [_ Hw].
  rewrite ratio_is, Hw; split; [apply fast_two_sum_word; [apply format_rnd | apply format_rnd | exact Hw]|].
  assert (Hy0 : (1 - / 1000) * Rabs (hi y) <= Rabs (whole y)).
  { pose proof (u_part _ (Rabs_pos (hi y))); pose proof (size_least (whole y) (hi y)) as Hl.
    replace (whole y - hi y) with (lo y) in Hl by (unfold whole; ring); lra. }
  pose proof (Rabs_pos_lt _ y_not_zero) as Hy1.
  assert (Hy2 : whole y <> 0) by (intros Z0; rewrite Z0, Rabs_R0 in Hy0; lra).
  (* Dividing by the leading part alone. *)
  assert (E3 : Rabs (r / hi y - r / whole y) <= (3 + / 50) * (u * (u * Q))).
  { replace (r / hi y - r / whole y) with (r / hi y * (lo y / whole y)) by (unfold whole in *; field; auto).
    rewrite Rabs_mult; apply Rle_trans with ((3 + / 100) * u * Q * ((1 + / 500) * u)).
    - apply Rmult_le_compat; [apply Rabs_pos | apply Rabs_pos | exact S2|]; unfold Rdiv; rewrite Rabs_mult, Rabs_inv.
      apply Rmult_le_reg_r with (Rabs (whole y)); [lra|]; rewrite Rmult_assoc, Rinv_l, Rmult_1_r by lra.
      apply Rle_trans with (1 := Ly); rewrite Rmult_comm, (Rmult_comm ((1 + / 500) * u)), <- Rmult_assoc.
      apply Rmult_le_compat_r; lra.
    - replace ((3 + / 100) * u * Q * ((1 + / 500) * u)) with ((3 + / 100) * (1 + / 500) * (u * (u * Q))) by ring; lra. }
  assert (Hexact : (1 - / 100) * Q <= Rabs (whole x / whole y)).
  { replace (whole x / whole y) with (high + r / whole y) by (unfold r; field; exact Hy2).
    pose proof (size_least (high + r / whole y) high) as Hl; replace (high + r / whole y - high) with (r / whole y) in Hl by ring.
    pose proof (size_least (r / hi y) (r / whole y)); lra. }
  assert (Huu : u * (u * ((1 - / 100) * Q)) <= u * (u * Rabs (whole x / whole y))).
  { apply Rmult_le_compat_l; [lra|]; apply Rmult_le_compat_l; lra. }
  replace (high + low - whole x / whole y) with ((low - hi rest / hi y) + (((hi rest - r) / hi y) + (r / hi y - r / whole y)))
    by (unfold r; field; auto).
  apply Rle_trans with (1 := Rabs_triang _ _); apply Rle_trans with (1 := Rplus_le_compat_l _ _ _ (Rabs_triang _ _)); lra.
Qed.
End Ratio.

(** A quotient of 0 is 0. *)
Lemma fast_of_zeros : fast_two_sum 0 0 = Twofold 0 0.
Proof. unfold fast_two_sum; repeat (rewrite ?Rplus_0_r, ?Rminus_0_r, ?rnd_0); reflexivity. Qed.

Lemma ratio_of_zero x y : double_word x -> hi x = 0 -> ratio x y = Twofold 0 0.
Proof.
  intros Wx Z0; destruct (double_word_is_pair x Wx) as (_ & _ & L); rewrite Z0, Rabs_R0, Rmult_0_r in L.
  assert (Zl : lo x = 0).
  { pose proof (Rabs_pos (lo x)); destruct (Req_dec (lo x) 0) as [|N]; [assumption | pose proof (Rabs_pos_lt _ N); lra]. }
  rewrite ratio_is; replace (rnd (hi x / hi y)) with 0 by (rewrite Z0; unfold Rdiv; now rewrite Rmult_0_l, rnd_0).
  assert (Em : product_by y 0 = Twofold 0 0).
  { unfold product_by, two_prod; cbn [hi lo]; repeat (rewrite ?Rmult_0_r, ?Rplus_0_r, ?Rminus_0_r, ?rnd_0); exact fast_of_zeros. }
  assert (Ed : hi (difference x (product_by y 0)) = 0).
  { rewrite Em; pose proof (difference_near x (Twofold 0 0) Wx) as Hd.
    assert (Ww : double_word (Twofold 0 0)).
    { unfold double_word, whole; cbn [hi lo]; rewrite Rplus_0_r, rnd_0; repeat split; apply generic_format_0. }
    destruct (Hd Ww) as [(_ & _ & ->) Hn]; unfold whole in Hn at 2 3 4 5; cbn [hi lo] in Hn; rewrite Z0, Zl in Hn.
    replace (0 + 0 - (0 + 0)) with 0 in Hn by ring; rewrite Rminus_0_r, Rabs_R0, !Rmult_0_r in Hn.
    set (d := whole _) in *; replace d with 0; [apply rnd_0|]; pose proof (Rabs_pos d).
    destruct (Req_dec d 0) as [|N]; [auto | pose proof (Rabs_pos_lt _ N); lra]. }
  rewrite Ed; unfold Rdiv; rewrite Rmult_0_l, rnd_0; exact fast_of_zeros.
Qed.

(** ** Square roots *)

Section Root.
Variable x : twofold.
Hypothesis x_word : double_word x.
Hypothesis x_size : bpow radix2 (-920) <= hi x.

Let high := rnd (sqrt (hi x)).
Let rest := difference x (two_prod high high).
Let low := rnd (hi rest / rnd (2 * high)).
Let alpha := hi x.
Let s := sqrt (hi x).

Lemma root_is : root_of x = fast_two_sum high low.
Proof.
  pose proof (bpow_gt_0 radix2 (-920)).
  change (root_of x) with (if Rle_bool (hi x) 0 then Twofold 0 0 else fast_two_sum high low).
  destruct (Rle_bool_spec (hi x) 0); [lra | reflexivity].
Qed.

Theorem root_kept : double_word (root_of x) /\ Rabs (whole (root_of x) - sqrt (whole x)) <= 8 * (u * (u * sqrt (whole x)))
  /\ / 2 * sqrt (hi x) <= hi (root_of x).
Proof.
  pose proof (bpow_gt_0 radix2 (-920)) as H920; pose proof u_bounds as Hu; assert (Ha : 0 < alpha) by (unfold alpha; lra).
  destruct (double_word_is_pair x x_word) as (_ & _ & Lx); rewrite (Rabs_pos_eq (hi x)) in Lx by lra; fold alpha in Lx.
  assert (Hs0 : bpow radix2 (-460) <= s).
  { unfold s; rewrite <- (sqrt_square (bpow radix2 (-460))) by apply bpow_ge_0; apply sqrt_le_1_alt; rewrite <- bpow_plus.
    exact x_size. }
  pose proof (bpow_gt_0 radix2 (-460)) as H460; assert (Hss : s * s = alpha) by (apply sqrt_sqrt; lra).
  assert (Hh : Rabs (high - s) <= u * s).
  { rewrite <- (Rabs_pos_eq s) at 2 by lra; apply rnd_rel; right; rewrite Rabs_pos_eq by (fold s; lra).
    apply Rle_trans with (2 := Hs0), bpow_le; lia. }
  pose proof (u_part s ltac:(lra)) as HU; pose proof (u_part _ (proj1 HU)) as HUU; pose proof (u_part _ (proj1 HUU)) as HUUU.
  pose proof (u_part alpha ltac:(lra)) as HA; pose proof (u_part _ (proj1 HA)) as HAA.
  apply Rabs_le_inv in Hh; assert (Hh0 : 0 < high) by lra.
  assert (HP : Rabs (high * high - alpha) <= (2 + / 1000) * (u * alpha)).
  { rewrite <- Hss; replace (high * high - s * s) with ((high - s) * (high + s)) by ring.
    rewrite Rabs_mult, (Rabs_pos_eq (high + s)) by lra.
    apply Rle_trans with (u * s * ((2 + / 1000) * s)); [|right; ring].
    apply Rmult_le_compat; [apply Rabs_pos | lra | apply Rabs_le; lra | lra]. }
  assert (HPw : bpow radix2 (-960) <= Rabs (high * high)).
  { apply Rabs_le_inv in HP; rewrite Rabs_pos_eq by (apply Rmult_le_pos; lra).
    apply Rle_trans with (/ 2 * bpow radix2 (-920)); [|unfold alpha in *; lra].
    replace (/ 2) with (bpow radix2 (-1)) by reflexivity; rewrite <- bpow_plus; apply bpow_le; lia. }
  destruct (worthy_kept high high (format_rnd _) (format_rnd _) (or_intror HPw)) as (Fe & _ & Ee).
  assert (Wm : double_word (two_prod high high) /\ whole (two_prod high high) = high * high).
  { assert (Ew : whole (two_prod high high) = high * high) by (unfold whole, two_prod; cbn [hi lo]; rewrite Ee; ring).
    split; [|exact Ew]; split; [apply format_rnd | split; [apply format_rnd | rewrite Ew; reflexivity]]. }
  destruct Wm as [Wm Ew]; set (r := whole x - high * high).
  assert (Sr : Rabs r <= (3 + / 100) * (u * alpha)).
  { unfold r, whole; fold alpha; replace (alpha + lo x - high * high) with (lo x - (high * high - alpha)) by ring.
    apply Rabs_le_inv in HP, Lx; apply Rabs_le; lra. }
  destruct (leading_of_rest x (two_prod high high) r alpha x_word Wm ltac:(lra)
    ltac:(rewrite Ew; unfold r; rewrite Rminus_diag_eq, Rabs_R0 by reflexivity; lra) Sr) as [Hrest Srest]; fold rest in Hrest, Srest.
  (* Divided by numbers near s. *)
  assert (Hby : forall z d k, (1 + 9 / 10) * s <= d -> Rabs z <= k * alpha -> 0 <= k -> Rabs (z / d) <= k * (10 / 19) * s).
  { intros z d k Hd Hz Hk; unfold Rdiv; rewrite Rabs_mult, Rabs_inv, (Rabs_pos_eq d) by lra.
    apply Rmult_le_reg_r with d; [lra|]; rewrite Rmult_assoc, Rinv_l, Rmult_1_r by lra; apply Rle_trans with (1 := Hz).
    rewrite <- Hss; replace (k * (s * s)) with (k * (10 / 19) * s * ((1 + 9 / 10) * s)) by field.
    apply Rmult_le_compat_l; [|exact Hd]; repeat apply Rmult_le_pos; lra. }
  assert (Hwx : (1 - / 1000) * alpha <= whole x) by (unfold whole; fold alpha; apply Rabs_le_inv in Lx; lra).
  set (root := sqrt (whole x)) in *; assert (Hrr : root * root = whole x) by (apply sqrt_sqrt; lra).
  assert (Hroot0 : 0 <= root) by apply sqrt_pos.
  assert (Hroot : Rabs (root - s) <= u * s).
  { pose proof (sqrt_distance alpha (whole x) Ha ltac:(lra)) as Hd; fold s root in Hd; rewrite Rabs_minus_sym in Hd.
    apply Rle_trans with (1 := Hd); apply Rmult_le_reg_r with s; [lra|]; unfold Rdiv; change (sqrt alpha) with s.
    rewrite Rmult_assoc, Rinv_l, Rmult_1_r, Rmult_assoc, Hss by lra.
    unfold whole; fold alpha; replace (alpha - (alpha + lo x)) with (- lo x) by ring; now rewrite Rabs_Ropp. }
  apply Rabs_le_inv in Hroot; unfold low in *.
  assert (E2h : rnd (2 * high) = 2 * high) by apply rnd_double, format_rnd.
  pose proof (Hby (hi rest) (2 * high) ((3 + / 50) * u) ltac:(lra) ltac:(lra) ltac:(lra)) as S1.
  pose proof (Hby (hi rest - r) (2 * high) (7 * (u * u)) ltac:(lra) ltac:(lra) ltac:(pose proof (Rmult_le_pos u u); lra)) as E1.
  pose proof (Hby r (2 * high) ((3 + / 100) * u) ltac:(lra) ltac:(lra) ltac:(lra)) as S2.
  rewrite root_is; unfold low; rewrite E2h; pose proof (rnd_any (hi rest / (2 * high))) as E2; set (l := rnd (hi rest / (2 * high))) in *.
  assert (Hz : 0 <= tiny <= / 200 * (u * (u * s))).
  { apply tiny_part; apply Rle_trans with (2 := Hs0), bpow_le; lia. }
  assert (Hu1 : u * Rabs (hi rest / (2 * high)) <= u * ((3 + / 50) * u * (10 / 19) * s)) by (apply Rmult_le_compat_l; lra).
  assert (Sl : Rabs l <= 2 * (u * s)).
  { replace l with (hi rest / (2 * high) + (l - hi rest / (2 * high))) by ring; apply Rle_trans with (1 := Rabs_triang _ _); lra. }
  assert (Hroom : Rabs l <= Rabs high) by (rewrite (Rabs_pos_eq high) by lra; lra).
  destruct (fast_two_sum_exact high l (format_rnd _) (format_rnd _) (or_intror Hroom)) as [_ Hw].
  assert (W : double_word (fast_two_sum high l)) by (apply fast_two_sum_word; [apply format_rnd | apply format_rnd | exact Hw]).
  split; [exact W | split].
  - rewrite Hw; assert (Hsum : (1 + 9 / 10) * s <= root + high) by lra.
    assert (E3 : Rabs (r / (2 * high) - r / (root + high)) <= (2 * (u * (u * s)))).
    { replace (r / (2 * high) - r / (root + high)) with (r / (2 * high) * ((root - high) / (root + high))) by (field; lra).
      rewrite Rabs_mult; apply Rle_trans with ((3 + / 100) * u * (10 / 19) * s * ((1 + / 10) * u)).
      - apply Rmult_le_compat; [apply Rabs_pos | apply Rabs_pos | exact S2|].
        unfold Rdiv; rewrite Rabs_mult, Rabs_inv, (Rabs_pos_eq (root + high)) by lra.
        apply Rmult_le_reg_r with (root + high); [lra|]; rewrite Rmult_assoc, Rinv_l, Rmult_1_r by lra.
        apply Rle_trans with (2 * (u * s)); [apply Rabs_le; lra|].
        replace ((1 + / 10) * u * (root + high)) with ((1 + / 10) * (u * (root + high))) by ring.
        assert (u * ((1 + 9 / 10) * s) <= u * (root + high)) by (apply Rmult_le_compat_l; lra); lra.
      - replace ((3 + / 100) * u * (10 / 19) * s * ((1 + / 10) * u)) with ((3 + / 100) * (10 / 19) * (1 + / 10) * (u * (u * s))) by ring; lra. }
    replace (high + l - root) with ((l - hi rest / (2 * high)) + (((hi rest - r) / (2 * high)) + (r / (2 * high) - r / (root + high)))).
    2: { unfold r; rewrite <- Hrr; field; lra. }
    apply Rle_trans with (1 := Rabs_triang _ _); apply Rle_trans with (1 := Rplus_le_compat_l _ _ _ (Rabs_triang _ _)).
    assert (u * (u * ((1 - / 1000) * s)) <= u * (u * root)).
    { apply Rmult_le_compat_l; [lra|]; apply Rmult_le_compat_l; lra. }
    lra.
  - destruct (word_near _ W) as [_ Hn]; pose proof (u_part _ (Rabs_pos (hi (fast_two_sum high l)))) as Hp; rewrite Hw in Hn.
    apply Rabs_le_inv in Hn, Sl; fold s; unfold Rabs in Hn, Hp; destruct Rcase_abs in Hn; destruct Rcase_abs in Hp; lra.
Qed.
End Root.

(** Where nothing underflows, each is within the bound beside its definition. *)
Theorem ratio_near x y : double_word x -> double_word y -> bpow radix2 (-900) <= Rabs (hi x) -> hi y <> 0 ->
  bpow radix2 (-900) <= Rabs (hi x / hi y) -> double_word (ratio x y) /\
  Rabs (whole (ratio x y) - whole x / whole y) <= bpow radix2 (-102) * Rabs (whole x / whole y).
Proof.
  intros Wx Wy Hx Hy Hq; destruct (ratio_kept x y Wx Wy Hx Hy Hq) as [W H]; split; [exact W|]; rewrite sixteen_u_u, Rmult_assoc.
  pose proof (u_part _ (Rabs_pos (whole x / whole y))) as HU; pose proof (u_part _ (proj1 HU)); lra.
Qed.

Theorem root_near x : double_word x -> bpow radix2 (-920) <= hi x -> double_word (root_of x) /\
  Rabs (whole (root_of x) - sqrt (whole x)) <= bpow radix2 (-102) * sqrt (whole x).
Proof.
  intros Wx Hx; destruct (root_kept x Wx Hx) as (W & H & _); split; [exact W|]; rewrite sixteen_u_u, Rmult_assoc.
  pose proof (u_part _ (sqrt_pos (whole x))) as HU; pose proof (u_part _ (proj1 HU)); lra.
Qed.
