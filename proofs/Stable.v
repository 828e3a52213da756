(** * Stable: the second step's decision on a quadratic, over what Doubled.v has of pairs

    factors_near      == the difference and the sum of two distances, which are F and H
    sound2            == f is within its bounds of A, B, C, F and H, and of the magnitudes that the bounds ask for
    S, q, from_A, …   == what is computed on the way, by the names of closed_form-inl.hpp
    single, single_from, single_linear == the decisions for one ray, which are the recorded terms *)
From Coq Require Import Reals ZArith Lra Lia Psatz Bool.
From Flocq Require Import Core.
From Durero Require Import Trazador.
From Durero Require Import Rounding Quotient Roots Decision Twofold Sums Products Ratios Words Doubled.
From Durero Require Formas.
Import Formas.Pairs.
Local Open Scope R_scope.
Local Opaque bpow.

(** The sum and the difference of two computed distances, which lack d together. *)
Lemma factors_near S2 S L2 L d : double_word S2 -> double_word L2 -> 0 <= S -> 0 <= L -> 0 <= whole L2 ->
  Rabs (whole S2 - S) + Rabs (whole L2 - L) <= d ->
  let F2 := difference S2 L2 in let H2 := sum S2 L2 in
  double_word F2 /\ double_word H2 /\ Rabs (whole F2 - (S - L)) <= d + uu * (S + L + d) /\
  Rabs (whole H2 - (S + L)) <= d + uu * (S + L + d) /\ (0 < whole F2 -> whole F2 <= (1 + / 2000) * whole H2).
Proof.
  intros WS WL HS HL HL2 Hd; destruct (difference_near _ _ WS WL) as [WF HF], (sum_near _ _ WS WL) as [WH HH].
  apply six_in_uu in HF, HH; pose proof uu_bounds as Hu; split; [exact WF | split; [exact WH|]].
  set (F2 := difference S2 L2) in *; set (H2 := sum S2 L2) in *.
  pose proof (Rabs_pos (whole S2 - S)); pose proof (Rabs_pos (whole L2 - L)).
  pose proof (Rle_abs (whole S2 - S)); pose proof (Rle_abs (- (whole S2 - S))); rewrite Rabs_Ropp in *.
  pose proof (Rle_abs (whole L2 - L)); pose proof (Rle_abs (- (whole L2 - L))); rewrite Rabs_Ropp in *.
  assert (Size : forall t, - (S + L + d) <= t <= S + L + d -> uu * Rabs t <= uu * (S + L + d)).
  { intros t Ht; apply Rmult_le_compat_l; [lra | now apply Rabs_le]. }
  pose proof (Size (whole S2 - whole L2) ltac:(split; lra)); pose proof (Size (whole S2 + whole L2) ltac:(split; lra)).
  split; [|split].
  - apply Rabs_le_inv in HF; apply Rabs_le; lra.
  - apply Rabs_le_inv in HH; apply Rabs_le; lra.
  - intros Hpos; set (t := whole S2 - whole L2) in *; pose proof (Rabs_pos t) as Ht0.
    assert (Hut : uu * Rabs t <= e30 * Rabs t) by (apply Rmult_le_compat_r; lra); apply Rabs_le_inv in HF.
    assert (Ht : 0 < t) by (apply Rnot_le_lt; intros Hle; rewrite (Rabs_left1 t Hle) in *; lra).
    rewrite (Rabs_pos_eq t) in * by lra; set (s := whole S2 + whole L2) in *; assert (Hts : t <= s) by (unfold t, s; lra).
    assert (Hus : uu * Rabs s <= e30 * Rabs s) by (apply Rmult_le_compat_r; [apply Rabs_pos | lra]).
    rewrite (Rabs_pos_eq s) in * by lra; apply Rabs_le_inv in HH; lra.
Qed.

Section Stable.
Variable f : Formas.quadratic twofold.
Variables A B C F H : R.

Notation A_w := (Formas.A f).
Notation B_w := (Formas.B f).
Notation C_w := (Formas.C f).
Notation F_w := (Formas.F f).
Notation H_w := (Formas.H f).
Notation A_error := (Formas.A_error f).
Notation B_error := (Formas.B_error f).
Notation C_error := (Formas.C_error f).

Record sound2 : Prop := Sound2 {
  words : double_word A_w /\ double_word B_w /\ double_word C_w /\ double_word F_w /\ double_word H_w;
  A_near : Rabs (whole A_w - A) <= A_error;
  B_near : Rabs (whole B_w - B) <= 5 / 6 * B_error;
  C_near : Rabs (whole C_w - C) <= C_error;
  F_near : Rabs (whole F_w - F) <= 5 / 6 * B_error;
  H_near : Rabs (whole H_w - H) <= 5 / 6 * B_error;
  F_times_H : B * B - A * C = F * H;
  F_below : Rabs F <= H;
  F_w_below : 0 < whole F_w -> whole F_w <= (1 + / 2000) * whole H_w;
  errors_binary64 : format A_error /\ format B_error /\ format C_error;
  errors_least : bpow radix2 (-360) <= A_error <= bpow radix2 450 /\ bpow radix2 (-360) <= B_error /\
    bpow radix2 (-360) <= C_error;
  sizes : Rabs (hi A_w) <= bpow radix2 450 /\ Rabs (hi B_w) <= bpow radix2 440 /\ hi H_w <= bpow radix2 440;
  sizeable_B_C : sizeable B_w /\ sizeable C_w }.

Hypothesis f_sound : sound2.
Let D := B * B - A * C.
Notation is_root t := (A * t * t + 2 * B * t + C = 0).

Definition root_of_D : Formas.known twofold := root_of_discriminant f.
Definition total : Formas.stable twofold := stable_sum f root_of_D.
Notation S := (Formas.value root_of_D).
Notation S_error := (Formas.error root_of_D).
Notation q := (Formas.value (Formas.q total)).
Notation q_error := (Formas.error (Formas.q total)).
Notation signed := (Formas.signed_root total).
Notation plus := (Rle_bool 0 (hi B_w)).
Definition from_A : Formas.known twofold := quotient q q_error A_w A_error.
Definition from_C : Formas.known twofold := quotient C_w C_error q q_error.
Definition A_root_first : bool := eqb (Rlt_bool 0 (hi A_w)) plus.

Lemma no_root t : hi F_w < - B_error -> ~ is_root t.
Proof.
  intros HF Ht; destruct (words f_sound) as (_ & _ & _ & WF & _), (errors_binary64 f_sound) as (_ & FB & _).
  apply (word_below _ _ WF (generic_format_opp _ _ _ FB)) in HF.
  pose proof (F_near f_sound) as Hb; pose proof (F_below f_sound) as Hl.
  destruct (errors_least f_sound) as (_ & He & _); pose proof (bpow_gt_0 radix2 (-360)).
  apply Rabs_le_inv in Hb, Hl; assert (HF0 : F < 0) by lra; assert (HH : 0 < H) by lra.
  assert (D < 0).
  { unfold D; rewrite (F_times_H f_sound); pose proof (Rmult_lt_compat_r H F 0 HH HF0); lra. }
  pose proof (Rle_0_sqr (A * t + B)) as Hs; unfold Rsqr in Hs.
  replace ((A * t + B) * (A * t + B)) with (A * (A * t * t + 2 * B * t + C) + D) in Hs by (unfold D; ring).
  rewrite Ht in Hs; lra.
Qed.

(** A leading part beside its whole. *)
Lemma leading x : double_word x -> (1 - e12) * Rabs (whole x) <= Rabs (hi x) <= (1 + e12) * Rabs (whole x).
Proof.
  intros W; destruct (word_near x W) as [Hn _]; pose proof (u_part _ (Rabs_pos (whole x))).
  pose proof (size_least (hi x) (whole x)); pose proof (size_near _ _ _ _ Hn (Rle_refl _)); lra.
Qed.

Lemma leading_positive x a : double_word x -> 0 <= a -> a < whole x -> 0 <= hi x /\ (1 - e12) * whole x <= hi x <= (1 + e12) * whole x.
Proof.
  intros W Ha Hx; pose proof (leading x W) as L; rewrite (Rabs_pos_eq (whole x)) in L by lra.
  assert (Hh : 0 <= hi x) by (destruct W as (_ & _ & ->); apply rnd_nonneg; lra); rewrite Rabs_pos_eq in L by lra; tauto.
Qed.

Lemma meets : B_error < hi F_w ->
  0 < D /\ double_word S /\ bpow radix2 (-362) <= whole S /\ Rabs (whole S - sqrt D) <= 9 / 10 * S_error /\ 0 <= S_error /\
  whole S <= 3 * bpow radix2 440 /\ format S_error.
Proof.
  intros HF; destruct (words f_sound) as (_ & _ & _ & WF & WH), (errors_binary64 f_sound) as (_ & FB & _).
  apply (word_above _ _ WF FB) in HF as HF'; set (a := whole F_w) in *; set (h := whole H_w) in *.
  pose proof (F_near f_sound) as HbF; pose proof (H_near f_sound) as HbH; pose proof (F_below f_sound) as HFH; fold a in HbF; fold h in HbH.
  destruct (errors_least f_sound) as (_ & He360 & _), (sizes f_sound) as (_ & _ & HH440).
  pose proof u_bounds; pose proof uu_bounds as Huu; pose proof (bpow_gt_0 radix2 (-360)) as H360.
  pose proof (F_w_below f_sound ltac:(fold a; lra)) as Hfh; fold a h in Hfh.
  apply Rabs_le_inv in HbF, HbH, HFH.
  assert (HF0 : 0 < F) by lra; assert (HH0 : 0 < H) by lra.
  assert (HD : 0 < D) by (unfold D; rewrite (F_times_H f_sound); apply Rmult_lt_0_compat; lra); split; [assumption|].
  assert (HX : Rabs (a * h - D) <= 237 / 100 * (B_error * h)).
  { unfold D; rewrite (F_times_H f_sound).
    replace (a * h - F * H) with (a * (h - H) + H * (a - F)) by ring.
    assert (Hm : forall x b c, 0 <= x -> - c <= b <= c -> - (x * c) <= x * b <= x * c).
    { intros x b c Hx Hb; split; [replace (- (x * c)) with (x * - c) by ring|]; apply Rmult_le_compat_l; lra. }
    pose proof (Hm a (h - H) (5 / 6 * B_error) ltac:(lra) HbH).
    pose proof (Hm H (a - F) (5 / 6 * B_error) ltac:(lra) HbF).
    assert (a * (5 / 6 * B_error) <= (1 + / 2000) * h * (5 / 6 * B_error)) by (apply Rmult_le_compat_r; lra).
    assert (H * (5 / 6 * B_error) <= (11 / 6 + / 1000) * h * (5 / 6 * B_error)) by (apply Rmult_le_compat_r; lra).
    apply Rabs_le; split; lra. }
  destruct (leading_positive _ 0 WF ltac:(lra) ltac:(fold a; lra)) as [Fh0 Fh]; fold a in Fh.
  destruct (leading_positive _ 0 WH ltac:(lra) ltac:(fold h; lra)) as [Hh0 Hh]; fold h in Hh.
  assert (Hsq : forall x y, bpow radix2 (-360) <= 2 * x -> bpow radix2 (-360) <= 2 * y -> bpow radix2 (-722) <= x * y).
  { intros x y Hx Hy; change (-722)%Z with (-361 + -361)%Z; rewrite bpow_plus; change (-361)%Z with (-1 + -360)%Z.
    rewrite bpow_plus; replace (bpow radix2 (-1)) with (/ 2) by reflexivity; apply Rmult_le_compat; lra. }
  pose proof (Hsq a h ltac:(lra) ltac:(lra)) as Hah; pose proof (Hsq (hi F_w) (hi H_w) ltac:(lra) ltac:(lra)) as Hhh.
  assert (Wp : worthy (hi F_w * hi H_w)).
  { right; pose proof (bpow_gt_0 radix2 (-722)); rewrite Rabs_pos_eq by lra; apply Rle_trans with (2 := Hhh), bpow_le; lia. }
  destruct (product_near _ _ WF WH Wp) as [WP HP]; set (P := product F_w H_w) in *; fold a h in HP.
  pose proof (bpow_gt_0 radix2 (-722)) as H722; rewrite (Rabs_pos_eq (a * h)) in HP by lra.
  assert (Hux : uu * (a * h) <= e30 * (a * h)) by (apply Rmult_le_compat_r; lra).
  apply Rabs_le_inv in HP as HP'; destruct (leading_positive _ 0 WP ltac:(lra) ltac:(lra)) as [Ph0 Ph].
  assert (HPhi : bpow radix2 (-723) <= hi P).
  { change (-723)%Z with (-1 + -722)%Z; rewrite bpow_plus; replace (bpow radix2 (-1)) with (/ 2) by reflexivity; lra. }
  destruct (root_near P WP) as [WS HS]; [apply Rle_trans with (2 := HPhi), bpow_le; lia|].
  change (root_of P) with S in WS, HS; split; [exact WS|]; set (s := whole S) in *.
  destruct (root_of_product uu B_error a h D (a * h) (whole P) s) as (HS0 & HSh & Hb); auto; try lra.
  destruct (leading_positive _ 0 WS ltac:(lra) HS0) as [Sh0 Sh]; fold s in Sh.
  assert (Hs362 : bpow radix2 (-362) <= s).
  { apply Rabs_le_inv in HS; assert (Hr : bpow radix2 (-361) <= sqrt (a * h)).
    { rewrite <- (sqrt_square (bpow radix2 (-361))) by apply bpow_ge_0; apply sqrt_le_1_alt; now rewrite <- bpow_plus. }
    assert (Hr2 : (1 - / 1000) * sqrt (a * h) <= sqrt (whole P)).
    { rewrite <- (sqrt_square ((1 - / 1000) * sqrt (a * h))) by (pose proof (sqrt_pos (a * h)); lra); apply sqrt_le_1_alt.
      replace ((1 - / 1000) * sqrt (a * h) * ((1 - / 1000) * sqrt (a * h))) with ((1 - / 1000) * (1 - / 1000) * (sqrt (a * h) * sqrt (a * h))) by ring.
      rewrite sqrt_sqrt by lra; lra. }
    assert (uu * sqrt (whole P) <= e30 * sqrt (whole P)) by (apply Rmult_le_compat_r; [apply sqrt_pos | lra]).
    change (-362)%Z with (-1 + -361)%Z; rewrite bpow_plus; replace (bpow radix2 (-1)) with (/ 2) by reflexivity.
    pose proof (bpow_gt_0 radix2 (-361)); lra. }
  pose proof (bpow_gt_0 radix2 (-362)) as H362.
  change S_error with (rnd (rnd (rnd (rnd (3 * B_error) * hi H_w) / hi S) + rnd (bpow radix2 (-100) * hi S))).
  assert (Hlow : forall x, bpow radix2 (-724) <= x -> (1 - / 1000000) * x <= rnd x).
  { intros x Hx; pose proof (bpow_gt_0 radix2 (-724)).
    assert (N : normal x) by (apply (at_least_normal (-724)); [lia | rewrite Rabs_pos_eq; lra]).
    pose proof (rnd_low x ltac:(lra) N); lra. }
  assert (Hmore : forall x, bpow radix2 (-362) <= x -> bpow radix2 (-724) <= x).
  { intros x Hx; apply Rle_trans with (2 := Hx), bpow_le; lia. }
  assert (Hq : bpow radix2 (-362) <= / 4 * bpow radix2 (-360)).
  { change (-362)%Z with (-2 + -360)%Z; rewrite bpow_plus; replace (bpow radix2 (-2)) with (/ 4) by reflexivity; lra. }
  pose proof (Hlow (3 * B_error) (Hmore (3 * B_error) ltac:(lra))) as E1; set (e1 := rnd (3 * B_error)) in *.
  assert (Hbig : 2.99 * B_error <= e1) by lra.
  assert (Hsq' : forall x y, bpow radix2 (-362) <= x -> bpow radix2 (-362) <= y -> bpow radix2 (-724) <= x * y).
  { intros x y Hx Hy; change (-724)%Z with (-362 + -362)%Z; rewrite bpow_plus; apply Rmult_le_compat; lra. }
  pose proof (Hlow (e1 * hi H_w) (Hsq' e1 (hi H_w) ltac:(lra) ltac:(lra))) as E2; set (e2 := rnd (e1 * hi H_w)) in *.
  assert (HBh : 0 < B_error * h) by (apply Rmult_lt_0_compat; lra).
  assert (Hbig2 : 2.98 * (B_error * h) <= e2).
  { assert (2.99 * B_error * ((1 - e12) * h) <= e1 * hi H_w) by (apply Rmult_le_compat; lra); lra. }
  set (y := B_error * h / s) in *; assert (Hy0 : 0 < y) by (apply Rdiv_lt_0_compat; lra).
  assert (HeS : 2.97 * y <= e2 / hi S).
  { apply Rmult_le_reg_r with (hi S); [lra|]; replace (e2 / hi S * hi S) with e2 by (field; lra).
    apply Rle_trans with (2.97 * y * ((1 + e12) * s)); [apply Rmult_le_compat_l; lra|].
    replace (2.97 * y * ((1 + e12) * s)) with (2.97 * (1 + e12) * (B_error * h)) by (unfold y; field; lra); lra. }
  assert (Hquo : B_error <= 2 * y).
  { apply Rmult_le_reg_r with s; [assumption|]; replace (2 * y * s) with (B_error * (2 * h)) by (unfold y; field; lra).
    apply Rmult_le_compat_l; lra. }
  pose proof (Hlow (e2 / hi S) (Hmore (e2 / hi S) ltac:(lra))) as E3; set (e3 := rnd (e2 / hi S)) in *.
  replace (bpow radix2 (-100)) with (4 * uu) in * by (replace 4 with (bpow radix2 2) by reflexivity; now rewrite <- bpow_plus).
  assert (H4u : bpow radix2 (-724) <= 4 * uu * hi S).
  { apply Rle_trans with (uu * bpow radix2 (-362)); [rewrite <- bpow_plus; apply bpow_le; lia|].
    assert (uu * bpow radix2 (-362) <= uu * (2 * hi S)) by (apply Rmult_le_compat_l; lra).
    assert (0 <= uu * hi S) by (apply Rmult_le_pos; lra); lra. }
  pose proof (Hlow _ H4u) as E4; set (e4 := rnd (4 * uu * hi S)) in *.
  assert (Hus : 0 < uu * s) by (apply Rmult_lt_0_compat; lra).
  assert (Hush : uu * ((1 - e12) * s) <= uu * hi S) by (apply Rmult_le_compat_l; lra).
  assert (Hsum : 2.9 * y + 3.9 * (uu * s) <= e3 + e4) by lra.
  pose proof (Hlow (e3 + e4) (Hmore (e3 + e4) ltac:(lra))) as E5.
  split; [exact Hs362 | split; [apply Rle_trans with (1 := Hb); lra | split; [lra | split; [lra | apply format_rnd]]]].
Qed.

(** -(B ± √D), with the sign of the computed B. *)
Definition q_exact : R := - (B + if plus then sqrt D else - sqrt D).
Notation x := q_exact.

Lemma q_bound : B_error < hi F_w ->
  Rabs (whole q - x) <= q_error /\ bpow radix2 (-360) <= q_error /\ Rabs (hi q) <= bpow radix2 450 /\ double_word q /\
  format q_error /\ 98 / 100 * B_error <= q_error.
Proof.
  intros HF; destruct (meets HF) as (HD & WS & HS362 & HS & HS0 & HSH & FSe); pose proof (B_near f_sound) as HB.
  destruct (errors_least f_sound) as (_ & He360 & _), (errors_binary64 f_sound) as (_ & Fe & _), (words f_sound) as (_ & WB & _).
  destruct (sizes f_sound) as (_ & HB440 & _); pose proof uu_bounds as Huu; pose proof (bpow_gt_0 radix2 (-360)) as H360.
  pose proof (bpow_gt_0 radix2 (-362)) as H362.
  set (s2 := if plus then S else opposite S); change q with (opposite (sum B_w s2)).
  change q_error with (rnd (rnd (B_error + S_error) + rnd (bpow radix2 (-101) * Rabs (hi (opposite (sum B_w s2)))))).
  assert (Ws2 : double_word s2 /\ whole s2 = if plus then whole S else - whole S).
  { unfold s2; destruct plus; [split; [exact WS | reflexivity] | now apply opposite_word]. }
  destruct Ws2 as [Ws2 Es2]; destruct (sum_near _ _ WB Ws2) as [Wsum Hsum]; apply six_in_uu in Hsum.
  destruct (opposite_word _ Wsum) as [Wq Eq]; rewrite Eq; set (r := opposite (sum B_w s2)) in *.
  set (y := whole B_w + whole s2) in *.
  unfold q_exact; set (d := if plus then sqrt D else - sqrt D).
  assert (Hs : Rabs (whole s2 - d) <= 9 / 10 * S_error).
  { rewrite Es2; unfold d; destruct plus; [assumption|]; replace (- whole S - - sqrt D) with (- (whole S - sqrt D)) by ring.
    now rewrite Rabs_Ropp. }
  pose proof (leading r Wq) as Lq; rewrite Eq, Rabs_Ropp in Lq.
  assert (Hy : Rabs y <= (1 + / 100) * Rabs (hi r)).
  { pose proof (size_least (whole (sum B_w s2)) y) as Hl.
    assert (uu * Rabs y <= e30 * Rabs y) by (apply Rmult_le_compat_r; [apply Rabs_pos | lra]).
    pose proof (Rabs_pos y); lra. }
  pose proof (Rabs_pos (hi r)) as Hr0; assert (Huy : uu * Rabs y <= uu * ((1 + / 100) * Rabs (hi r))) by (apply Rmult_le_compat_l; lra).
  assert (Hur : 0 <= uu * Rabs (hi r)) by (apply Rmult_le_pos; lra).
  replace (bpow radix2 (-101)) with (2 * uu) by (replace 2 with (bpow radix2 1) by reflexivity; now rewrite <- bpow_plus).
  pose proof (rnd_low_any (2 * uu * Rabs (hi r)) ltac:(lra)) as E1.
  pose proof (rnd_nonneg (2 * uu * Rabs (hi r)) ltac:(lra)) as E10.
  pose proof (least_below (-360) B_error ltac:(lia) He360) as Hz.
  pose proof (rnd_low_sum B_error S_error Fe FSe ltac:(lra)) as E2.
  pose proof (rnd_low_sum _ _ (format_rnd (B_error + S_error)) (format_rnd (2 * uu * Rabs (hi r))) ltac:(lra)) as E3.
  assert (E20 : bpow radix2 (-360) <= rnd (B_error + S_error)) by (apply rnd_ge_bpow; [lia | lra]).
  split; [|split; [|split; [|split; [exact Wq | split; [apply format_rnd | lra]]]]].
  - apply Rabs_le_inv in HB, Hsum, Hs; apply Rabs_le; unfold y in *; lra.
  - apply rnd_ge_bpow; [lia | lra].
  - assert (Hby : Rabs y <= 5 * bpow radix2 440).
    { apply Rle_trans with (1 := Rabs_triang _ _); pose proof (leading _ WB) as LB; pose proof (bpow_gt_0 radix2 440).
      assert (Rabs (whole s2) = whole S).
      { rewrite Es2; destruct plus; [|rewrite Rabs_Ropp]; apply Rabs_pos_eq; lra. }
      lra. }
    pose proof (size_near _ _ _ _ Hsum (Rle_refl _)) as Hsz.
    assert (uu * Rabs y <= e30 * Rabs y) by (apply Rmult_le_compat_r; [apply Rabs_pos | lra]).
    apply Rle_trans with (bpow radix2 10 * bpow radix2 440); [|rewrite <- bpow_plus; apply bpow_le; lia].
    replace (bpow radix2 10) with 1024 by reflexivity; pose proof (bpow_gt_0 radix2 440); lra.
Qed.

Lemma q_exact_facts : B_error < hi F_w -> 2 * q_error < Rabs (hi q) -> x <> 0 /\ (if plus then x < 0 else 0 < x).
Proof.
  intros HF Hq; destruct (meets HF) as (HD & _), (q_bound HF) as (Hx & He & _ & Wq & _ & Hl).
  pose proof (sqrt_lt_R0 _ HD) as Hs; pose proof (B_near f_sound) as HB.
  destruct (errors_least f_sound) as (_ & He2 & _), (words f_sound) as (_ & WB & _); pose proof (bpow_gt_0 radix2 (-360)).
  assert (HB0 : if plus then 0 <= whole B_w else whole B_w < 0).
  { destruct (Rle_bool_spec 0 (hi B_w)) as [Hle|Hlt]; [|apply (word_below _ _ WB (generic_format_0 _ _) Hlt)].
    apply Rnot_lt_le; intros Hlt; pose proof (leading _ WB) as L; rewrite (Rabs_left (whole B_w)), (Rabs_pos_eq (hi B_w)) in L by lra.
    destruct WB as (_ & _ & E); pose proof (rnd_le _ _ (Rlt_le _ _ Hlt)) as Hr; rewrite rnd_0, <- E in Hr; lra. }
  pose proof (leading _ Wq) as Lq; pose proof (Rabs_pos (whole q)).
  unfold q_exact in *; set (r := sqrt D) in *; apply Rabs_le_inv in HB, Hx.
  assert (Hbig : whole q < - ((2 - / 1000) * q_error) \/ (2 - / 1000) * q_error < whole q).
  { assert (Hw : (2 - / 1000) * q_error < Rabs (whole q)) by lra; unfold Rabs in Hw; destruct Rcase_abs in Hw; lra. }
  destruct plus; split; lra.
Qed.

Lemma q_sizeable : bpow radix2 (-360) <= q_error -> 2 * q_error < Rabs (hi q) -> sizeable q.
Proof.
  intros He Hq; right; pose proof (bpow_gt_0 radix2 (-360)); apply Rle_trans with (bpow radix2 (-360)); [apply bpow_le; lia | lra].
Qed.

Lemma from_C_near : B_error < hi F_w -> 2 * q_error < Rabs (hi q) -> near_pair from_C (C / x).
Proof.
  intros HF Hq; destruct (q_bound HF) as (Hqb & _ & Hq450 & Wq & Fqe & _), (words f_sound) as (_ & _ & WC & _).
  destruct (errors_binary64 f_sound) as (_ & _ & FC), (errors_least f_sound) as (_ & _ & HC360), (sizeable_B_C f_sound) as [_ SC].
  apply quotient_near; auto; apply (C_near f_sound).
Qed.

Lemma A_known : 2 * A_error < Rabs (hi A_w) -> A <> 0 /\ Rlt_bool 0 (hi A_w) = Rlt_bool 0 A.
Proof.
  intros HA; pose proof (A_near f_sound) as HAn; destruct (words f_sound) as (WA & _), (errors_least f_sound) as ([He _] & _).
  pose proof (bpow_gt_0 radix2 (-360)); apply Rabs_le_inv in HAn; destruct (word_near _ WA) as [_ Hh].
  pose proof (u_part _ (Rabs_pos (hi A_w))) as Hu; apply Rabs_le_inv in Hh; unfold Rabs in HA, Hu, Hh.
  destruct (Rcase_abs (hi A_w)); (split; [lra|]); destruct (Rlt_bool_spec 0 (hi A_w)), (Rlt_bool_spec 0 A); trivial; lra.
Qed.

Lemma from_A_near : B_error < hi F_w -> 2 * q_error < Rabs (hi q) -> 2 * A_error < Rabs (hi A_w) -> near_pair from_A (x / A).
Proof.
  intros HF Hq HA; destruct (q_bound HF) as (Hqb & Hqe & _ & Wq & Fqe & _), (words f_sound) as (WA & _).
  destruct (errors_binary64 f_sound) as (FA & _), (sizes f_sound) as (HA450 & _).
  apply quotient_near; auto; [now apply q_sizeable | apply (A_near f_sound)].
Qed.

(** ** The decision for one ray *)

Definition least_of_A : R :=
  rnd (rnd ((9007198354021067 * bpow radix2 (-53)) * rnd (Rabs (hi q) - q_error)) / rnd (Rabs (hi A_w) + A_error)).

Section Deciding.
Variable place : Formas.known twofold -> Formas.placed.
Variable past : Formas.answer twofold -> Formas.answer twofold.
Variable limit : R.
Notation turn := (turn place limit (Formas.Known (hi A_w) A_error)).
Definition by_A (next : Formas.answer twofold) := turn from_A (Formas.Known (hi (opposite signed)) S_error) next.
Definition by_C (next : Formas.answer twofold) := turn from_C (Formas.Known (hi signed) S_error) next.
Definition single : Formas.answer twofold :=
  if Rlt_bool (hi F_w) (- B_error) then Formas.Miss
  else if Rlt_bool B_error (hi F_w) then
    if Rlt_bool (rnd (2 * q_error)) (Rabs (hi q)) then
      if Rlt_bool (rnd (2 * A_error)) (Rabs (hi A_w)) then
        if A_root_first then by_A (by_C Formas.Miss) else by_C (by_A Formas.Miss)
      else past (if A_root_first then by_C Formas.Miss else by_C Formas.Miss)
    else Formas.Undecided
  else Formas.Undecided.
End Deciding.

Definition past_limit (limit : R) (only : Formas.answer twofold) : Formas.answer twofold :=
  if Rlt_bool limit least_of_A then only else Formas.Undecided.

(** The recorded terms are these: operations on pairs are the same by their names. *)
Local Opaque round sum difference product ratio root_of opposite exactly.
Theorem single_is_recorded limit : first_of_curved f limit = single (place f) (past_limit limit) limit.
Proof. exact_no_check (eq_refl (single (place f) (past_limit limit) limit)). Qed.

Definition points_from (on : R -> Prop) (t : R) : Prop := A * t * t + 2 * B * t + 0 = 0 /\ on t.
Definition from_start : Formas.known twofold := quotient (opposite (sum B_w B_w)) (rnd (2 * B_error)) A_w A_error.
Definition single_from (place : Formas.known twofold -> Formas.placed) (limit : R) : Formas.answer twofold :=
  if Rlt_bool (rnd (2 * A_error)) (Rabs (hi A_w)) then
    turn place limit (Formas.Known (hi A_w) A_error) from_start (Formas.Known (hi (opposite B_w)) B_error) Formas.Miss
  else Formas.Undecided.
Theorem from_is_recorded limit : first_of_curved_on f limit = single_from (place f) limit.
Proof. exact_no_check (eq_refl (single_from (place f) limit)). Qed.
Local Transparent round sum difference product ratio root_of opposite exactly.

Definition points (on : R -> Prop) (t : R) : Prop := is_root t /\ on t.

Theorem single_right (on : R -> Prop) place past limit : format limit -> places on place -> (forall t, on t -> 0 < t) ->
  (B_error < hi F_w -> 2 * q_error < Rabs (hi q) -> forall only,
   past only = Formas.Undecided \/ past only = only /\ forall t, A * t = x -> on t -> limit < t) ->
  right_pair (points on) limit (single place past limit).
Proof.
  intros Fl Hplace Hon Hpast; unfold single.
  destruct (Rlt_bool_spec (hi F_w) (- B_error)) as [Hmiss|_]; [intros t [Ht _]; now elim (no_root t Hmiss)|].
  destruct (Rlt_bool_spec B_error (hi F_w)) as [HF|_]; [|exact I].
  destruct (meets HF) as (HD & _); pose proof (sqrt_lt_R0 _ HD) as Hs; pose proof (sqrt_sqrt _ (Rlt_le _ _ HD)) as Hss.
  destruct (q_bound HF) as (_ & _ & _ & _ & Fqe & _), (errors_binary64 f_sound) as (FAe & _); rewrite !rnd_double by assumption.
  destruct (Rlt_bool_spec (2 * q_error) (Rabs (hi q))) as [Hq|]; [|exact I].
  destruct (q_exact_facts HF Hq) as [Hx0 Hsign]; pose proof (from_C_near HF Hq) as NC; destruct (Hplace _ _ (proj1 NC)) as [OutC InC].
  destruct (Rlt_bool_spec (2 * A_error) (Rabs (hi A_w))) as [HA|_].
  - destruct (A_known HA) as [HA0 HAs]; pose proof (from_A_near HF Hq HA) as NA; destruct (Hplace _ _ (proj1 NA)) as [OutA InA].
    destruct (exact_roots A B C (sqrt D) x plus Hss Hs eq_refl Hx0 HA0) as [Hall Horder]; rewrite <- HAs in Horder.
    change (eqb (Rlt_bool 0 (hi A_w)) plus) with A_root_first in Horder.
    assert (Hturns : forall r0 t0 r1 t1 s0 s1, t0 < t1 -> (forall t, is_root t <-> t = t0 \/ t = t1) -> near_pair r0 t0 ->
      near_pair r1 t1 -> right_pair (points on) limit (turn place limit (Formas.Known (hi A_w) A_error) r0 s0
      (turn place limit (Formas.Known (hi A_w) A_error) r1 s1 Formas.Miss))).
    { intros r0 t0 r1 t1 s0 s1 Hlt Hboth N0 N1; destruct (Hplace _ _ (proj1 N0)) as [Out0 In0], (Hplace _ _ (proj1 N1)) as [Out1 In1].
      apply (turn_right place limit _ Fl (points on) on _ _ _ t0 N0 Out0 In0).
      - intros On; split; [split; [apply Hboth; tauto | exact On] | intros t' [Ht' _]; apply Hboth in Ht'; lra].
      - intros Hb t' [Ht' _]; apply Hboth in Ht'; lra.
      - intros Off0; assert (Honly : forall t', points on t' -> t' = t1).
        { intros t' [Ht' On]; destruct (proj1 (Hboth t') Ht') as [-> | ->]; [now elim Off0 | reflexivity]. }
        apply (turn_right place limit _ Fl (points on) on _ _ _ t1 N1 Out1 In1).
        + intros On; split; [split; [apply Hboth; tauto | exact On] | intros t' Ht'; rewrite (Honly t' Ht'); lra].
        + intros Hb t' Ht'; now rewrite (Honly t' Ht').
        + intros Off1 t' Ht'; pose proof (Honly t' Ht') as E; destruct Ht' as [_ On]; subst t'; now elim Off1. }
    unfold by_A, by_C; destruct A_root_first; eapply Hturns; eauto; intros t; rewrite Hall; tauto.
  - replace (if A_root_first then by_C place limit Formas.Miss else by_C place limit Formas.Miss)
      with (by_C place limit Formas.Miss) by now destruct A_root_first.
    destruct (Hpast HF Hq (by_C place limit Formas.Miss)) as [-> | [-> Hfar]]; [exact I|].
    assert (Hcase : forall t, points on t -> t = C / x \/ (A * t = x /\ on t)).
    { intros t [Ht On]; apply (roots_are A B C _ x plus Hss eq_refl Hx0) in Ht as [Ht|Ht]; auto. }
    apply (turn_right place limit _ Fl (points on) on _ _ _ (C / x) NC OutC InC).
    + intros On; split; [split; [apply (roots_are A B C _ x plus Hss eq_refl Hx0); now right | exact On]|].
      intros t' Ht'; destruct (Hcase t' Ht') as [-> | [HA On']]; [lra|].
      apply (root_of_C_first A B C _ x plus Hss Hs eq_refl Hx0 t'); auto.
    + intros Hb t' Ht'; destruct (Hcase t' Ht') as [-> | [HA On']]; [exact Hb | now apply Hfar].
    + intros Off t' Ht'; destruct (Hcase t' Ht') as [E | [HA On']]; [|now apply Hfar].
      destruct Ht' as [_ On]; rewrite E in On; now elim Off.
Qed.

Lemma least_of_A_right t : B_error < hi F_w -> 2 * q_error < Rabs (hi q) -> A * t = x -> 0 <= least_of_A <= Rabs t.
Proof.
  intros HF Hq Ht; pose proof (A_near f_sound) as HA.
  destruct (q_bound HF) as (Hx & He & _ & Wq & Fqe & _), (words f_sound) as (WA & _), (errors_binary64 f_sound) as (FAe & _).
  destruct (errors_least f_sound) as (HAe & _), (sizes f_sound) as (HA450 & _).
  apply (computed_least (hi q) q_error (hi A_w) A_error x A t); auto; try apply Wq; try apply WA.
  - pose proof (leading _ Wq) as Lq; pose proof (size_least x (whole q)) as Hs; rewrite Rabs_minus_sym in Hs.
    pose proof (bpow_gt_0 radix2 (-360)); lra.
  - pose proof (leading _ WA) as LA; pose proof (size_least (whole A_w) A) as Hs; pose proof (Rabs_pos (hi A_w)).
    pose proof (bpow_gt_0 radix2 (-360)); lra.
Qed.

Lemma past_limit_right (on : R -> Prop) limit : (forall t, on t -> 0 < t) -> B_error < hi F_w -> 2 * q_error < Rabs (hi q) ->
  forall only,
  past_limit limit only = Formas.Undecided \/ past_limit limit only = only /\ forall t, A * t = x -> on t -> limit < t.
Proof.
  intros Hon HF Hq only; unfold past_limit; destruct (Rlt_bool_spec limit least_of_A) as [Hl|]; [right | now left].
  split; [reflexivity|]; intros t Ht On; pose proof (Hon t On); destruct (least_of_A_right t HF Hq Ht) as [_ Hle].
  rewrite Rabs_pos_eq in Hle by lra; lra.
Qed.

(** ** The ray starts on the element: C is 0, and so is one root *)

Theorem single_from_right (on : R -> Prop) place limit : format limit -> places on place -> (forall t, on t -> 0 < t) ->
  right_pair (points_from on) limit (single_from place limit).
Proof.
  intros Fl Hplace Hon; unfold single_from; destruct (words f_sound) as (WA & WB & _), (errors_binary64 f_sound) as (FAe & FBe & _).
  rewrite (rnd_double _ FAe); destruct (Rlt_bool_spec (2 * A_error) (Rabs (hi A_w))) as [HA|]; [|exact I].
  destruct (A_known HA) as [HA0 _], (sizes f_sound) as (HA450 & _), (sizeable_B_C f_sound) as [SB _].
  destruct (errors_least f_sound) as (_ & HBe & _); pose proof (B_near f_sound) as NB; pose proof (bpow_gt_0 radix2 (-360)).
  destruct (sum_near _ _ WB WB) as [Wsum _]; destruct (opposite_word _ Wsum) as [Wq Eq].
  assert (N : near_pair from_start (- (2 * B) / A)).
  { pose proof (sum_of_self _ WB) as Es; apply quotient_near; auto using format_rnd.
    - rewrite (rnd_double _ FBe); lra.
    - rewrite Es; destruct SB as [Z0|SB]; [left; cbn; rewrite Z0; ring | right; cbn [hi opposite]].
      rewrite Rabs_Ropp, Rabs_mult, (Rabs_pos_eq 2) by lra; pose proof (Rabs_pos (hi B_w)); lra.
    - rewrite Eq, Es, (rnd_double _ FBe); unfold whole in *; cbn [hi lo]; apply Rabs_le_inv in NB; apply Rabs_le; lra.
    - apply (A_near f_sound). }
  destruct (Hplace _ _ (proj1 N)) as [Out In].
  assert (HT : forall t', points_from on t' <-> t' = - (2 * B) / A /\ on t').
  { intros t'; unfold points_from; split.
    - intros [Hr On]; split; [|exact On]; pose proof (Hon t' On).
      replace (A * t' * t' + 2 * B * t' + 0) with (t' * (A * t' + 2 * B)) in Hr by ring.
      apply Rmult_integral in Hr as [Hr|Hr]; [lra|]; apply Rmult_eq_reg_l with A; [field_simplify; lra | exact HA0].
    - intros [-> On]; split; [field; exact HA0 | exact On]. }
  apply (turn_right place limit _ Fl _ on _ _ _ _ N Out In).
  - intros On; split; [now apply HT | intros t' Ht'; apply HT in Ht' as [-> _]; lra].
  - intros Hb t' Ht'; apply HT in Ht' as [-> _]; exact Hb.
  - intros Off t' Ht'; apply HT in Ht' as [-> On]; now elim Off.
Qed.
End Stable.
