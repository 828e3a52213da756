(** * Loose: what the operations of power-inl.hpp lose

    Formas.Powers computes with pairs that need not be normalised: leading parts are added and multiplied exactly, and what
    that leaves is added up in binary64. So what is lost are roundings of lower parts, and a lower part is a few u of the
    size that is computed with; both are counted here, beside a bound of that size.

    roomy s          == s is so large that nothing which underflows matters beside u² s
    loose s l e a x  == the pair a is computed for x, |x| <= s, its lower part at most l u s, the whole within e u² s *)
From Coq Require Import Reals ZArith Lra Lia Psatz.
From Flocq Require Import Core.
From Durero Require Import Rounding Twofold Sums.
From Durero Require Formas.
Import Formas.Pairs.
Local Open Scope R_scope.
Local Opaque bpow.

Definition roomy (s : R) : Prop := bpow radix2 (-900) <= s.
Definition loose (s l e : R) (a : twofold) (x : R) : Prop :=
  roomy s /\ format (hi a) /\ format (lo a) /\ Rabs x <= s /\ Rabs (lo a) <= l * (u * s) /\
  Rabs (whole a - x) <= e * (u * (u * s)).

Lemma roomy_positive s : roomy s -> 0 < s.
Proof. intros H; apply Rlt_le_trans with (2 := H), bpow_gt_0. Qed.

Lemma roomy_units s : roomy s -> 0 < u * s <= e12 * s /\ 0 < u * (u * s) <= e12 * (u * s) /\
  0 < tiny <= e12 * (u * (u * s)).
Proof.
  intros H; pose proof (roomy_positive s H) as H0; pose proof u_bounds as Hu; pose proof (u_part s ltac:(lra)) as H1.
  pose proof (u_part (u * s) (proj1 H1)) as H2; assert (0 < u * s) by (apply Rmult_lt_0_compat; lra).
  assert (0 < u * (u * s)) by (apply Rmult_lt_0_compat; lra); split; [lra | split; [lra | split; [apply bpow_gt_0|]]].
  apply Rle_trans with (e12 * (u * (u * bpow radix2 (-900)))).
  - rewrite <- !bpow_plus; replace (-1074)%Z with (-68 + (-53 + (-53 + -900)))%Z by reflexivity; rewrite bpow_plus.
    apply Rmult_le_compat_r; [apply bpow_ge_0|]; apply Rle_trans with (bpow radix2 (-40)); [apply bpow_le; lia|].
    replace (bpow radix2 (-40)) with (/ 1099511627776) by reflexivity; lra.
  - apply Rmult_le_compat_l; [lra|]; do 2 (apply Rmult_le_compat_l; [lra|]); exact H.
Qed.

(** Counts that the roundings of counts do not notice. *)
Definition few (l e : R) : Prop := 0 <= l <= 100 /\ 0 <= e <= 10000.

Lemma loose_more s l e l' e' a x : loose s l e a x -> l <= l' -> e <= e' -> loose s l' e' a x.
Proof.
  intros (Hs & Fh & Fl & Hx & Ll & Ee) Hl He; destruct (roomy_units s Hs) as (U & W & _).
  split; [exact Hs | split; [exact Fh | split; [exact Fl | split; [exact Hx | split]]]].
  - apply Rle_trans with (1 := Ll), Rmult_le_compat_r; lra.
  - apply Rle_trans with (1 := Ee), Rmult_le_compat_r; lra.
Qed.

Lemma loose_larger s s' l e a x : s <= s' -> 0 <= l -> 0 <= e -> loose s l e a x -> loose s' l e a x.
Proof.
  intros H Hl He (Hs & Fh & Fl & Hx & Ll & Ee); pose proof u_bounds as Hu.
  assert (HU : u * s <= u * s') by (apply Rmult_le_compat_l; lra).
  split; [unfold roomy in *; lra | split; [exact Fh | split; [exact Fl | split; [lra | split]]]].
  - apply Rle_trans with (1 := Ll), Rmult_le_compat_l; lra.
  - apply Rle_trans with (1 := Ee), Rmult_le_compat_l; [lra|]; apply Rmult_le_compat_l; lra.
Qed.

(** What the counts are of: the lower part and what is lost, and that they are small. *)
Lemma loose_parts s l e a x : few l e -> loose s l e a x ->
  0 <= l * (u * s) <= / 1000000000 * s /\ 0 <= u * (l * (u * s)) <= e12 * (l * (u * s)) /\
  0 <= e * (u * (u * s)) <= / 100000000 * (u * s) /\ Rabs (hi a) <= (1 + / 100000000) * s /\
  Rabs (whole a) <= (1 + / 100000000) * s.
Proof.
  intros [Hl He] (Hs & _ & _ & Hx & Ll & Ee); destruct (roomy_units s Hs) as (U & W & _).
  assert (0 <= l * (u * s)) by (apply Rmult_le_pos; lra); assert (0 <= e * (u * (u * s))) by (apply Rmult_le_pos; lra).
  assert (l * (u * s) <= 100 * (u * s)) by (apply Rmult_le_compat_r; lra).
  assert (e * (u * (u * s)) <= 10000 * (u * (u * s))) by (apply Rmult_le_compat_r; lra).
  assert (Hw : Rabs (whole a) <= s + e * (u * (u * s))).
  { replace (whole a) with (x + (whole a - x)) by ring; apply Rle_trans with (1 := Rabs_triang _ _); lra. }
  split; [lra | split; [apply u_part; assumption | split; [lra | split; [|lra]]]].
  replace (hi a) with (whole a - lo a) by (unfold whole; ring); apply Rle_trans with (1 := Rabs_triang _ _).
  rewrite Rabs_Ropp; lra.
Qed.

Lemma few_units s l e : few l e -> roomy s -> l * (u * s) <= 100 * (u * s) /\ u * (l * (u * s)) <= 100 * (u * (u * s)).
Proof.
  intros [Hl _] Hs; destruct (roomy_units s Hs) as (U & W & _); split; [apply Rmult_le_compat_r; lra|].
  replace (u * (l * (u * s))) with (l * (u * (u * s))) by ring; apply Rmult_le_compat_r; lra.
Qed.

(** ** The operations *)

Lemma loose_whole s a : roomy s -> format a -> Rabs a <= s -> loose s 0 0 (Twofold a 0) a.
Proof.
  intros Hs Fa Ha; unfold loose, whole; cbn [hi lo]; rewrite Rplus_0_r, Rminus_diag_eq, Rabs_R0 by reflexivity.
  split; [exact Hs | split; [exact Fa | split; [apply generic_format_0 | split; [exact Ha | split; lra]]]].
Qed.

Lemma loose_two_sum s a b : roomy s -> format a -> format b -> Rabs (a + b) <= s -> loose s 1 0 (two_sum a b) (a + b).
Proof.
  intros Hs Fa Fb Ha; destruct (two_sum_exact a b Fa Fb) as [(Fh & Fl & _) E]; unfold loose; rewrite E.
  split; [exact Hs | split; [exact Fh | split; [exact Fl | split; [exact Ha | split]]]].
  - rewrite (two_sum_is a b Fa Fb); cbn [lo]; rewrite Rabs_minus_sym, Rmult_1_l; now apply lost_of_sum.
  - rewrite Rminus_diag_eq, Rabs_R0 by reflexivity; lra.
Qed.

(** What a rounded product lacks, rounded: it is a u of the product, and known to a u of that. *)
Lemma lacking s a b : roomy s -> Rabs (a * b) <= s -> let r := rnd (a * b - rnd (a * b)) in
  Rabs r <= (1 + / 1000000) * (u * s) /\ Rabs (rnd (a * b) + r - a * b) <= (1 + / 1000000) * (u * (u * s)).
Proof.
  intros Hs Hab r; destruct (roomy_units s Hs) as (U & W & Z); pose proof (rnd_any (a * b)) as H1.
  assert (H2 : Rabs (a * b - rnd (a * b)) <= u * s + tiny).
  { rewrite Rabs_minus_sym; apply Rle_trans with (1 := H1), Rplus_le_compat_r, Rmult_le_compat_l; [apply bpow_ge_0 | exact Hab]. }
  pose proof (rnd_any (a * b - rnd (a * b))) as H3; fold r in H3.
  assert (H4 : u * Rabs (a * b - rnd (a * b)) <= u * (u * s) + u * tiny).
  { rewrite <- Rmult_plus_distr_l; apply Rmult_le_compat_l; [apply bpow_ge_0 | exact H2]. }
  pose proof (u_part tiny ltac:(lra)) as Hz; split.
  - replace r with (r - (a * b - rnd (a * b)) + (a * b - rnd (a * b))) by ring; apply Rle_trans with (1 := Rabs_triang _ _); lra.
  - replace (rnd (a * b) + r - a * b) with (r - (a * b - rnd (a * b))) by ring; lra.
Qed.

Lemma loose_two_prod s a b : roomy s -> format a -> format b -> Rabs (a * b) <= s ->
  loose s (1 + / 100) (1 + / 100) (two_prod a b) (a * b).
Proof.
  intros Hs Fa Fb Hab; destruct (lacking s a b Hs Hab) as [Hl He]; destruct (roomy_units s Hs) as (U & W & _).
  unfold two_prod, loose, whole; cbn [hi lo]; split; [exact Hs | split; [apply format_rnd | split; [apply format_rnd | split; [exact Hab|]]]].
  split; lra.
Qed.

Lemma loose_opposite s l e a x : loose s l e a x -> loose s l e (Twofold (- hi a) (- lo a)) (- x).
Proof.
  intros (Hs & Fh & Fl & Hx & Ll & Ee); unfold loose, whole in *; cbn [hi lo]; rewrite !Rabs_Ropp.
  replace (- hi a + - lo a - - x) with (- (hi a + lo a - x)) by ring; rewrite Rabs_Ropp.
  repeat split; auto; now apply generic_format_opp.
Qed.

Lemma sum_is a b : Formas.Powers.sum a b = let high := two_sum (hi a) (hi b) in
  Twofold (hi high) (rnd (lo high + rnd (lo a + lo b))).
Proof. reflexivity. Qed.

Theorem loose_sum s t l e a b x y : loose s l e a x -> loose t l e b y -> few l e ->
  loose (s + t) (l + 1 + / 100) (e + 2 * l + 1 + / 100) (Formas.Powers.sum a b) (x + y).
Proof.
  intros Ha Hb Few; pose proof (loose_parts s l e a x Few Ha) as (A1 & A2 & A3 & A4 & _).
  pose proof (loose_parts t l e b y Few Hb) as (B1 & B2 & B3 & B4 & _).
  destruct Ha as (Hs & Fha & Fla & Hx & La & Ea), Hb as (Ht & Fhb & Flb & Hy & Lb & Eb).
  destruct (roomy_units s Hs) as (Us & Ws & _), (roomy_units t Ht) as (Ut & Wt & _); rewrite sum_is; cbv zeta.
  pose proof (few_units s l e Few Hs); pose proof (few_units t l e Few Ht).
  destruct (two_sum_exact (hi a) (hi b) Fha Fhb) as [(_ & Fr & _) E]; set (high := two_sum (hi a) (hi b)) in *.
  assert (Hr : Rabs (lo high) <= (1 + / 100000000) * (u * s + u * t)).
  { unfold high; rewrite two_sum_is by assumption; cbn [lo]; rewrite Rabs_minus_sym.
    replace ((1 + / 100000000) * (u * s + u * t)) with (u * ((1 + / 100000000) * s + (1 + / 100000000) * t)) by ring.
    apply lost_of_sum; auto; apply Rle_trans with (1 := Rabs_triang _ _); lra. }
  set (c := rnd (lo a + lo b)).
  assert (Hc : Rabs (c - (lo a + lo b)) <= u * (l * (u * s) + l * (u * t))).
  { apply lost_of_sum; auto; apply Rle_trans with (1 := Rabs_triang _ _); lra. }
  pose proof (u_part (l * (u * s) + l * (u * t)) ltac:(lra)) as Hlu.
  assert (Hc' : Rabs c <= (1 + e12) * (l * (u * s) + l * (u * t))).
  { replace c with (c - (lo a + lo b) + (lo a + lo b)) by ring; apply Rle_trans with (1 := Rabs_triang _ _).
    pose proof (Rabs_triang (lo a) (lo b)); lra. }
  set (size := (1 + / 100000000) * (u * s + u * t) + (1 + e12) * (l * (u * s) + l * (u * t))).
  assert (Hrc : Rabs (lo high + c) <= size) by (unfold size; apply Rle_trans with (1 := Rabs_triang _ _); lra).
  pose proof (lost_of_sum _ _ _ Fr (format_rnd _) Hrc) as Hlow; fold c in Hlow; set (low := rnd (lo high + c)) in *.
  assert (Eu : u * size = (1 + / 100000000) * (u * (u * s) + u * (u * t)) + (1 + e12) * (u * (l * (u * s)) + u * (l * (u * t))))
    by (unfold size; ring); rewrite Eu in Hlow.
  unfold loose, whole in *; cbn [hi lo].
  split; [unfold roomy in *; pose proof (roomy_positive t Ht); lra | split; [apply format_rnd | split; [apply format_rnd|]]].
  split; [apply Rle_trans with (1 := Rabs_triang _ _); lra|]; split.
  - replace low with (low - (lo high + c) + (lo high + c)) by ring; apply Rle_trans with (1 := Rabs_triang _ _).
    unfold size in Hrc; lra.
  - replace (hi high + low - (x + y)) with ((hi a + lo a - x) + (hi b + lo b - y) + (c - (lo a + lo b)) + (low - (lo high + c)))
      by lra.
    apply Rabs_le_inv in Ea, Eb, Hc, Hlow; apply Rabs_le; lra.
Qed.

Theorem loose_difference s t l e a b x y : loose s l e a x -> loose t l e b y -> few l e ->
  loose (s + t) (l + 1 + / 100) (e + 2 * l + 1 + / 100) (Formas.Powers.difference a b) (x - y).
Proof.
  intros Ha Hb; exact (loose_sum s t l e a (Twofold (- hi b) (- lo b)) x (- y) Ha (loose_opposite _ _ _ _ _ Hb)).
Qed.

Theorem loose_product_by s m l e a x b : loose s l e a x -> format b -> Rabs b <= m -> roomy (s * m) -> few l e ->
  loose (s * m) (l + 1 + / 100) (e + 2 * l + 2 + / 100) (Formas.Powers.product_by a b) (x * b).
Proof.
  intros Ha Fb Hb Hsm Few; pose proof (loose_parts s l e a x Few Ha) as (A1 & A2 & A3 & A4 & _).
  destruct Ha as (Hs & Fha & Fla & Hx & La & Ea), Few as [Hl He]; pose proof (roomy_positive s Hs) as Hs0.
  destruct (roomy_units s Hs) as (Us & Ws & _), (roomy_units _ Hsm) as (U & W & Z).
  assert (Hm : 0 <= m) by (apply Rle_trans with (2 := Hb), Rabs_pos).
  assert (Hab : Rabs (hi a * b) <= (1 + / 100000000) * (s * m)).
  { rewrite Rabs_mult; replace ((1 + / 100000000) * (s * m)) with ((1 + / 100000000) * s * m) by ring.
    apply Rmult_le_compat; auto using Rabs_pos. }
  assert (Hroom : roomy ((1 + / 100000000) * (s * m))) by (unfold roomy in *; pose proof (roomy_positive _ Hsm); lra).
  destruct (lacking _ (hi a) b Hroom Hab) as [Hr Er].
  replace (u * ((1 + / 100000000) * (s * m))) with ((1 + / 100000000) * (u * (s * m))) in * by ring.
  replace (u * ((1 + / 100000000) * (u * (s * m)))) with ((1 + / 100000000) * (u * (u * (s * m)))) in * by ring.
  set (top := rnd (hi a * b)) in *; set (r := rnd (hi a * b - top)) in *.
  set (lU := l * (u * (s * m))); set (lW := l * (u * (u * (s * m)))); set (c := rnd (lo a * b)).
  destruct (few_units (s * m) l e (conj Hl He) Hsm) as [F1 F2]; fold lU in F1, F2.
  assert (HlU : 0 <= lU) by (apply Rmult_le_pos; lra); pose proof (u_part lU HlU) as HlW.
  replace (u * lU) with lW in * by (unfold lW, lU; ring).
  assert (Hlb : Rabs (lo a * b) <= lU).
  { rewrite Rabs_mult; unfold lU; replace (l * (u * (s * m))) with (l * (u * s) * m) by ring.
    apply Rmult_le_compat; auto using Rabs_pos. }
  assert (Hc : Rabs (c - lo a * b) <= lW + tiny).
  { apply Rle_trans with (1 := rnd_any _), Rplus_le_compat_r; replace lW with (u * lU) by (unfold lW, lU; ring).
    apply Rmult_le_compat_l; [apply bpow_ge_0 | exact Hlb]. }
  assert (Hc' : Rabs c <= (1 + / 1000000) * lU + tiny).
  { replace c with (c - lo a * b + lo a * b) by ring; apply Rle_trans with (1 := Rabs_triang _ _); lra. }
  set (size := (1 + / 10000) * (u * (s * m)) + (1 + / 1000000) * lU).
  assert (Hrc : Rabs (r + c) <= size) by (unfold size; apply Rle_trans with (1 := Rabs_triang _ _); lra).
  pose proof (lost_of_sum r c size (format_rnd _) (format_rnd _) Hrc) as Hlow.
  assert (Eu : u * size = (1 + / 10000) * (u * (u * (s * m))) + (1 + / 1000000) * lW) by (unfold size, lU, lW; ring); rewrite Eu in Hlow.
  change (Formas.Powers.product_by a b) with (Twofold top (rnd (r + c))); set (low := rnd (r + c)) in *.
  assert (Hprop : Rabs ((whole a - x) * b) <= e * (u * (u * (s * m)))).
  { rewrite Rabs_mult; replace (e * (u * (u * (s * m)))) with (e * (u * (u * s)) * m) by ring.
    apply Rmult_le_compat; auto using Rabs_pos. }
  unfold loose; unfold whole in *; cbn [hi lo].
  split; [exact Hsm | split; [apply format_rnd | split; [apply format_rnd | split]]].
  - rewrite Rabs_mult; apply Rmult_le_compat; auto using Rabs_pos.
  - split.
    + replace low with (low - (r + c) + (r + c)) by ring; apply Rle_trans with (1 := Rabs_triang _ _).
      unfold size in Hrc; fold lU; replace ((l + 1 + / 100) * (u * (s * m))) with (lU + (1 + / 100) * (u * (s * m))) by (unfold lU; ring).
      lra.
    + replace ((e + 2 * l + 2 + / 100) * (u * (u * (s * m)))) with (e * (u * (u * (s * m))) + 2 * lW + (2 + / 100) * (u * (u * (s * m))))
        by (unfold lW; ring).
      replace (top + low - x * b) with ((hi a + lo a - x) * b + (top + r - hi a * b) + (c - lo a * b) + (low - (r + c))) by ring.
      replace (u * lU) with lW in F2 by (unfold lW, lU; ring).
      apply Rabs_le_inv in Hprop, Er, Hc, Hlow; apply Rabs_le; lra.
Qed.

(** A product of a size with what a pair lacks, and its rounding. *)
Lemma lesser_product s t l a b : roomy s -> roomy (s * t) -> 0 <= l <= 100 -> Rabs a <= (1 + / 100000000) * t ->
  Rabs b <= l * (u * s) -> let lU := l * (u * (s * t)) in
  Rabs (a * b) <= (1 + / 100000000) * lU /\ Rabs (rnd (a * b) - a * b) <= (1 + / 100000000) * (u * lU) + tiny /\
  0 <= lU <= 100 * (u * (s * t)) /\ 0 <= u * lU <= e12 * lU /\ u * lU <= 100 * (u * (u * (s * t))).
Proof.
  intros Hs Hst Hl Ha Hb lU; destruct (roomy_units _ Hst) as (U & W & Z).
  assert (HlU : 0 <= lU <= 100 * (u * (s * t))) by (unfold lU; split; [apply Rmult_le_pos | apply Rmult_le_compat_r]; lra).
  assert (Hab : Rabs (a * b) <= (1 + / 100000000) * lU).
  { rewrite Rabs_mult; unfold lU; replace ((1 + / 100000000) * (l * (u * (s * t)))) with ((1 + / 100000000) * t * (l * (u * s))) by ring.
    apply Rmult_le_compat; auto using Rabs_pos. }
  split; [exact Hab | split; [|split; [exact HlU | split; [apply u_part; lra|]]]].
  - apply Rle_trans with (1 := rnd_any _), Rplus_le_compat_r.
    replace ((1 + / 100000000) * (u * lU)) with (u * ((1 + / 100000000) * lU)) by ring.
    apply Rmult_le_compat_l; [apply bpow_ge_0 | exact Hab].
  - replace (100 * (u * (u * (s * t)))) with (u * (100 * (u * (s * t)))) by ring.
    apply Rmult_le_compat_l; [apply bpow_ge_0 | lra].
Qed.

Lemma sum_of_rounded x y a b : format x -> format y -> Rabs x <= a -> Rabs y <= b ->
  Rabs (rnd (x + y) - (x + y)) <= u * a + u * b /\ Rabs (x + y) <= a + b.
Proof.
  intros Fx Fy Hx Hy; assert (H : Rabs (x + y) <= a + b) by (apply Rle_trans with (1 := Rabs_triang _ _); lra).
  split; [|exact H]; rewrite <- Rmult_plus_distr_l; now apply lost_of_sum.
Qed.

Theorem loose_product s t l k e f a b x y : loose s l e a x -> loose t k f b y -> roomy (s * t) ->
  few l e -> few k f ->
  loose (s * t) (l + k + 1 + / 100) (e + f + l * k + 3 * (l + k) + 2 + / 10) (Formas.Powers.product a b) (x * y).
Proof.
  intros Ha Hb Hst Fa Fb; pose proof (loose_parts s l e a x Fa Ha) as (A1 & A2 & A3 & A4 & A5).
  pose proof (loose_parts t k f b y Fb Hb) as (B1 & B2 & B3 & B4 & B5).
  destruct Ha as (Hs & Fha & Fla & Hx & La & Ea), Hb as (Ht & Fhb & Flb & Hy & Lb & Eb), Fa as [Hl He], Fb as [Hk Hf].
  destruct (roomy_units _ Hst) as (U & W & Z); pose proof (roomy_positive s Hs); pose proof (roomy_positive t Ht).
  assert (Hab : Rabs (hi a * hi b) <= (1 + / 10000000) * (s * t)).
  { rewrite Rabs_mult; apply Rle_trans with ((1 + / 100000000) * s * ((1 + / 100000000) * t));
      [apply Rmult_le_compat; auto using Rabs_pos | pose proof (roomy_positive _ Hst); lra]. }
  assert (Hroom : roomy ((1 + / 10000000) * (s * t))) by (unfold roomy in *; pose proof (roomy_positive _ Hst); lra).
  destruct (lacking _ (hi a) (hi b) Hroom Hab) as [Hr Er].
  replace (u * ((1 + / 10000000) * (s * t))) with ((1 + / 10000000) * (u * (s * t))) in * by ring.
  replace (u * ((1 + / 10000000) * (u * (s * t)))) with ((1 + / 10000000) * (u * (u * (s * t)))) in * by ring.
  set (top := rnd (hi a * hi b)) in *; set (r := rnd (hi a * hi b - top)) in *.
  destruct (lesser_product s t l (hi b) (lo a) Hs Hst Hl B4 La) as (P1 & P2 & P3 & P4 & P5).
  assert (Hts : t * s = s * t) by ring; assert (Hst' : roomy (t * s)) by (now rewrite Hts).
  destruct (lesser_product t s k (hi a) (lo b) Ht Hst' Hk A4 Lb) as (Q1 & Q2 & Q3 & Q4 & Q5); rewrite Hts in *.
  rewrite (Rmult_comm (hi b)) in P1, P2; set (lU := l * (u * (s * t))) in *; set (kU := k * (u * (s * t))) in *.
  set (c1 := rnd (hi a * lo b)) in *; set (c2 := rnd (lo a * hi b)) in *.
  assert (C1 : Rabs c1 <= (1 + / 10000000) * kU + tiny).
  { replace c1 with (c1 - hi a * lo b + hi a * lo b) by ring; apply Rle_trans with (1 := Rabs_triang _ _); lra. }
  assert (C2 : Rabs c2 <= (1 + / 10000000) * lU + tiny).
  { replace c2 with (c2 - lo a * hi b + lo a * hi b) by ring; apply Rle_trans with (1 := Rabs_triang _ _); lra. }
  destruct (sum_of_rounded c1 c2 _ _ (format_rnd _) (format_rnd _) C1 C2) as [S1 S2]; set (c := rnd (c1 + c2)) in *.
  pose proof (u_part tiny ltac:(lra)) as Hz.
  assert (C : Rabs c <= (1 + / 1000000) * (kU + lU) + 3 * tiny).
  { replace c with (c - (c1 + c2) + (c1 + c2)) by ring; apply Rle_trans with (1 := Rabs_triang _ _); lra. }
  destruct (sum_of_rounded r c _ _ (format_rnd _) (format_rnd _) Hr C) as [S3 S4].
  change (Formas.Powers.product a b) with (Twofold top (rnd (r + c))); set (low := rnd (r + c)) in *.
  assert (Hcross : Rabs (lo a * lo b) <= l * k * (u * (u * (s * t)))).
  { rewrite Rabs_mult; replace (l * k * (u * (u * (s * t)))) with (l * (u * s) * (k * (u * t))) by ring.
    apply Rmult_le_compat; auto using Rabs_pos. }
  assert (Hprop : Rabs (whole a * whole b - x * y) <= (e + f + / 100) * (u * (u * (s * t)))).
  { replace (whole a * whole b - x * y) with ((whole a - x) * whole b + x * (whole b - y)) by ring.
    apply Rle_trans with (1 := Rabs_triang _ _); rewrite !Rabs_mult.
    assert (Rabs (whole a - x) * Rabs (whole b) <= e * (u * (u * s)) * ((1 + / 100000000) * t)).
    { apply Rmult_le_compat; auto using Rabs_pos. }
    assert (Rabs x * Rabs (whole b - y) <= s * (f * (u * (u * t)))) by (apply Rmult_le_compat; auto using Rabs_pos).
    assert (e * (u * (u * (s * t))) <= 10000 * (u * (u * (s * t)))) by (apply Rmult_le_compat_r; lra); lra. }
  unfold loose; unfold whole in Hprop |- *; cbn [hi lo].
  split; [exact Hst | split; [apply format_rnd | split; [apply format_rnd | split; [|split]]]].
  - rewrite Rabs_mult; apply Rmult_le_compat; auto using Rabs_pos.
  - replace low with (low - (r + c) + (r + c)) by ring; apply Rle_trans with (1 := Rabs_triang _ _).
    replace ((l + k + 1 + / 100) * (u * (s * t))) with (lU + kU + (1 + / 100) * (u * (s * t))) by (unfold lU, kU; ring); lra.
  - replace ((e + f + l * k + 3 * (l + k) + 2 + / 10) * (u * (u * (s * t)))) with ((e + f) * (u * (u * (s * t)))
      + l * k * (u * (u * (s * t))) + 3 * (u * lU + u * kU) + (2 + / 10) * (u * (u * (s * t)))) by (unfold lU, kU; ring).
    replace (top + low - x * y) with (((hi a + lo a) * (hi b + lo b) - x * y) - lo a * lo b + (top + r - hi a * hi b)
      + (c1 - hi a * lo b) + (c2 - lo a * hi b) + (c - (c1 + c2)) + (low - (r + c))) by ring.
    apply Rabs_le_inv in Hprop, Hcross, Er, P2, Q2, S1, S3; apply Rabs_le; lra.
Qed.

Theorem loose_square s l e a x : loose s l e a x -> roomy (s * s) -> few l e ->
  loose (s * s) (2 * l + 1 + / 100) (2 * e + 6 * l + 2 + / 10) (Formas.Powers.square a) (x * x).
Proof.
  intros Ha Hst Fa; pose proof (loose_parts s l e a x Fa Ha) as (A1 & A2 & A3 & A4 & A5).
  destruct Ha as (Hs & Fh & Fl & Hx & La & Ea), Fa as [Hl He]; destruct (roomy_units _ Hst) as (U & W & Z).
  pose proof (roomy_positive s Hs) as H0.
  assert (Hab : Rabs (hi a * hi a) <= (1 + / 10000000) * (s * s)).
  { rewrite Rabs_mult; apply Rle_trans with ((1 + / 100000000) * s * ((1 + / 100000000) * s));
      [apply Rmult_le_compat; auto using Rabs_pos | pose proof (roomy_positive _ Hst); lra]. }
  assert (Hroom : roomy ((1 + / 10000000) * (s * s))) by (unfold roomy in *; pose proof (roomy_positive _ Hst); lra).
  destruct (lacking _ (hi a) (hi a) Hroom Hab) as [Hr Er].
  replace (u * ((1 + / 10000000) * (s * s))) with ((1 + / 10000000) * (u * (s * s))) in * by ring.
  replace (u * ((1 + / 10000000) * (u * (s * s)))) with ((1 + / 10000000) * (u * (u * (s * s)))) in * by ring.
  set (top := rnd (hi a * hi a)) in *; set (r := rnd (hi a * hi a - top)) in *.
  change (Formas.Powers.square a) with (Twofold top (rnd (r + rnd (rnd (rnd (2 * hi a) + lo a) * lo a)))).
  rewrite (rnd_double (hi a) Fh); set (m := rnd (2 * hi a + lo a)).
  assert (F2 : format (2 * hi a)) by (rewrite <- (rnd_double _ Fh); apply format_rnd).
  assert (M0 : Rabs (2 * hi a + lo a) <= (2 + / 10000000) * s).
  { apply Rle_trans with (1 := Rabs_triang _ _); rewrite Rabs_mult, (Rabs_pos_eq 2) by lra; lra. }
  pose proof (lost_of_sum _ _ _ F2 Fl M0) as M1; fold m in M1; pose proof (u_part s ltac:(lra)) as Hus.
  replace (u * ((2 + / 10000000) * s)) with ((2 + / 10000000) * (u * s)) in M1 by ring.
  assert (M2 : Rabs m <= (1 + / 100000000) * ((2 + / 1000000) * s)).
  { replace m with (m - (2 * hi a + lo a) + (2 * hi a + lo a)) by ring; apply Rle_trans with (1 := Rabs_triang _ _); lra. }
  assert (Hst2 : roomy (s * ((2 + / 1000000) * s))) by (unfold roomy in *; pose proof (roomy_positive _ Hst); lra).
  destruct (lesser_product s _ l m (lo a) Hs Hst2 Hl M2 La) as (P1 & P2 & P3 & P4 & P5).
  replace (l * (u * (s * ((2 + / 1000000) * s)))) with ((2 + / 1000000) * (l * (u * (s * s)))) in * by ring.
  set (lU := l * (u * (s * s))) in *; replace (u * ((2 + / 1000000) * lU)) with ((2 + / 1000000) * (u * lU)) in * by ring.
  set (c := rnd (m * lo a)) in *.
  assert (HlW : u * lU <= 100 * (u * (u * (s * s)))).
  { replace (100 * (u * (u * (s * s)))) with (u * (100 * (u * (s * s)))) by ring; apply Rmult_le_compat_l; [apply bpow_ge_0|].
    apply Rmult_le_compat_r; lra. }
  assert (Hm : Rabs ((m - (2 * hi a + lo a)) * lo a) <= (2 + / 1000000) * (u * lU)).
  { rewrite Rabs_mult; unfold lU; replace ((2 + / 1000000) * (u * (l * (u * (s * s))))) with ((2 + / 1000000) * (u * s) * (l * (u * s))) by ring.
    apply Rmult_le_compat; auto using Rabs_pos; lra. }
  assert (C : Rabs c <= (2 + / 100000) * lU + tiny).
  { replace c with (c - m * lo a + m * lo a) by ring; apply Rle_trans with (1 := Rabs_triang _ _); lra. }
  pose proof (u_part tiny ltac:(lra)) as Hz.
  destruct (sum_of_rounded r c _ _ (format_rnd _) (format_rnd _) Hr C) as [S3 S4]; set (low := rnd (r + c)) in *.
  assert (Hprop : Rabs (whole a * whole a - x * x) <= (2 * e + / 100) * (u * (u * (s * s)))).
  { replace (whole a * whole a - x * x) with ((whole a - x) * (whole a + x)) by ring; rewrite Rabs_mult.
    assert (Rabs (whole a + x) <= (2 + / 100000000) * s) by (apply Rle_trans with (1 := Rabs_triang _ _); lra).
    assert (Rabs (whole a - x) * Rabs (whole a + x) <= e * (u * (u * s)) * ((2 + / 100000000) * s))
      by (apply Rmult_le_compat; auto using Rabs_pos).
    assert (e * (u * (u * (s * s))) <= 10000 * (u * (u * (s * s)))) by (apply Rmult_le_compat_r; lra); lra. }
  unfold loose; unfold whole in Hprop |- *; cbn [hi lo].
  split; [exact Hst | split; [apply format_rnd | split; [apply format_rnd | split; [|split]]]].
  - rewrite Rabs_mult; apply Rmult_le_compat; auto using Rabs_pos.
  - replace low with (low - (r + c) + (r + c)) by ring; apply Rle_trans with (1 := Rabs_triang _ _).
    replace ((2 * l + 1 + / 100) * (u * (s * s))) with (2 * lU + (1 + / 100) * (u * (s * s))) by (unfold lU; ring); lra.
  - replace ((2 * e + 6 * l + 2 + / 10) * (u * (u * (s * s)))) with (2 * e * (u * (u * (s * s))) + 6 * (u * lU)
      + (2 + / 10) * (u * (u * (s * s)))) by (unfold lU; ring).
    replace (top + low - x * x) with (((hi a + lo a) * (hi a + lo a) - x * x) + (top + r - hi a * hi a)
      + (m - (2 * hi a + lo a)) * lo a + (c - m * lo a) + (low - (r + c))) by ring.
    apply Rabs_le_inv in Hprop, Er, P2, Hm, S3; apply Rabs_le; lra.
Qed.
