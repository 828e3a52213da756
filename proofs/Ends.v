(** * Ends: the ends between which a parameter lies, and what is certainly less

    Formas.ends_of, Formas.Pairs.ends_of and certainly_less, of src/trace/ends.hpp. What a finding's error has beside what
    is needed (Quotient.is_near, Doubled.near_pair) pays for the roundings of the ends and of the comparison. An exact
    parameter, rounded to the nearest binary64, lies between the two beside that. *)
From Coq Require Import ZArith Reals Lra Lia Psatz.
From Flocq Require Import Core BinarySingleNaN.
From Durero Require Import Rounding Quotient Decision Twofold Sums Words Doubled Once.
From Durero Require Limits Formas.
Import Formas.Pairs.
Local Open Scope R_scope.
Local Opaque bpow.

Definition between (at_ : Formas.ends) (t : R) : Prop := Formas.low at_ <= t <= Formas.high at_.

(** What is stored of the ends. *)
Lemma stored_between low high at_ t : between at_ t -> stored low (Formas.low at_) -> stored high (Formas.high at_) ->
  Limits.at_most low t /\ Limits.at_least high t.
Proof. intros [L H] [Fl El] [Fh Eh]; split; right; (split; [assumption | lra]). Qed.

Lemma u_small : u <= e12 / 1000.
Proof. replace (bpow radix2 (-53)) with (/ 9007199254740992) by reflexivity; lra. Qed.

Lemma between_sizes x t : - Rabs (x - t) <= x - t <= Rabs (x - t).
Proof. apply Rabs_le_inv, Rle_refl. Qed.

Theorem ends_of_near root t : is_near root t -> between (Formas.ends_of root) t.
Proof.
  intros N; pose proof (near_within _ _ N) as W; destruct N as (Fv & Fe & N); unfold between, Formas.ends_of.
  cbn [Formas.low Formas.high]; set (v := Formas.value root) in *; set (e := Formas.error root) in *.
  pose proof u_bounds; assert (He : 0 <= e) by (apply Rle_trans with (2 := W), Rabs_pos).
  assert (Hend : forall x, Rabs x <= e -> format x -> Rabs (rnd (v + x) - (v + x)) <= u * (Rabs v + e)).
  { intros x Hx Fx; apply Rle_trans with (1 := rnd_plus v x Fv Fx), Rmult_le_compat_l; [lra|].
    apply Rle_trans with (1 := Rabs_triang _ _); lra. }
  pose proof (Hend (- e) ltac:(rewrite Rabs_Ropp, Rabs_pos_eq; lra) (generic_format_opp _ _ _ Fe)) as L.
  pose proof (Hend e ltac:(rewrite Rabs_pos_eq; lra) Fe) as Hh; fold (v - e) in L.
  pose proof (between_sizes v t); apply Rabs_le_inv in L, Hh; lra.
Qed.

Theorem ends_of_near_word root t : near_word root t -> between (ends_of root) t.
Proof.
  intros (N & W & Fe & He); destruct (double_word_is_pair _ W) as (Fv & _ & Hl); unfold between, ends_of.
  cbn [Formas.low Formas.high]; unfold whole in N; set (v := hi (Formas.value root)) in *.
  set (l := lo (Formas.value root)) in *; set (e := Formas.error root) in *; set (m := rnd (bpow radix2 (-51) * Rabs v)).
  set (w := rnd (e + m)); pose proof u_bounds as Hu; pose proof u_small as Hs; pose proof (bpow_gt_0 radix2 (-900)).
  pose proof (Rabs_pos v) as Hv; pose proof (least_below (-900) e ltac:(lia) He) as Hz.
  assert (Huv : 0 <= u * Rabs v) by (apply Rmult_le_pos; lra).
  assert (H51 : bpow radix2 (-51) = 4 * u) by (replace 4 with (bpow radix2 2) by reflexivity; now rewrite <- bpow_plus).
  pose proof (rnd_low_any (bpow radix2 (-51) * Rabs v) ltac:(rewrite H51; lra)) as Lm; fold m in Lm; rewrite H51 in Lm.
  assert (Hm : 0 <= m) by (apply rnd_nonneg; rewrite H51; lra).
  pose proof (rnd_plus e m Fe (format_rnd _)) as Hw; fold w in Hw; rewrite (Rabs_pos_eq (e + m)) in Hw by lra.
  apply Rabs_le_inv in Hw; assert (Hue : 0 <= u * e <= e12 / 1000 * e) by (split; [apply Rmult_le_pos | apply Rmult_le_compat_r]; lra).
  assert (Hum : 0 <= u * m <= e12 / 1000 * m) by (split; [apply Rmult_le_pos | apply Rmult_le_compat_r]; lra).
  assert (Hw0 : 0 <= w) by lra; assert (Huw : 0 <= u * w <= e12 / 1000 * w) by (split; [apply Rmult_le_pos | apply Rmult_le_compat_r]; lra).
  assert (Hend : forall x, Rabs x <= w -> format x -> Rabs (rnd (v + x) - (v + x)) <= u * Rabs v + u * w).
  { intros x Hx Fx; apply Rle_trans with (1 := rnd_plus v x Fv Fx); rewrite <- Rmult_plus_distr_l.
    apply Rmult_le_compat_l; [lra|]; apply Rle_trans with (1 := Rabs_triang _ _); lra. }
  pose proof (Hend (- w) ltac:(rewrite Rabs_Ropp, Rabs_pos_eq; lra) (generic_format_opp _ _ _ (format_rnd _))) as L.
  pose proof (Hend w ltac:(rewrite Rabs_pos_eq; lra) (format_rnd _)) as H'; fold (v - w) in L.
  apply Rabs_le_inv in L, H', N, Hl; assert (u * w <= u * (2 * (e + m))) by (apply Rmult_le_compat_l; lra); lra.
Qed.

(** The comparison: what is lost of the difference is u of it, and less than uu of both roots, of which their errors have
    room. *)
Theorem certainly_less_near a b s t : near_pair a s -> near_pair b t -> certainly_less a b = true -> s < t.
Proof.
  intros [(_ & Wa & Fea & Lea) Na] [(_ & Wb & Feb & Leb) Nb]; unfold certainly_less.
  destruct (double_word_is_pair _ Wa) as (Fah & Fal & Ha), (double_word_is_pair _ Wb) as (Fbh & Fbl & Hb).
  unfold whole in Na, Nb; set (ah := hi (Formas.value a)) in *; set (al := lo (Formas.value a)) in *.
  set (bh := hi (Formas.value b)) in *; set (bl := lo (Formas.value b)) in *; set (ea := Formas.error a) in *.
  set (eb := Formas.error b) in *; pose proof u_bounds as Hu; pose proof u_small as Hs; pose proof widening as Hc.
  set (c := 4503600077730459 * _) in *; pose proof (bpow_gt_0 radix2 (-900)).
  intros Hless; destruct (Rlt_bool_spec (rnd (c * rnd (ea + eb))) (rnd (rnd (bh - ah) + rnd (bl - al)))) as [Hlt|];
    [clear Hless | discriminate].
  (* The bound. *)
  set (e := ea + eb) in *; assert (Le : bpow radix2 (-900) <= e) by (unfold e; lra).
  pose proof (least_below (-900) e ltac:(lia) Le) as Hz; pose proof (rnd_low_sum ea eb Fea Feb ltac:(lra)) as E1; fold e in E1.
  assert (E2 : (1 + / 16777216) * rnd e <= c * rnd e) by (apply Rmult_le_compat_r; lra).
  pose proof (rnd_low_any (c * rnd e) ltac:(lra)) as E3.
  assert (Hbound : (1 + / 20000000) * e <= rnd (c * rnd e)) by lra.
  (* What is computed of the difference. *)
  set (m := Rabs ah + Rabs bh); assert (Hm : 0 <= m) by (unfold m; pose proof (Rabs_pos ah); pose proof (Rabs_pos bh); lra).
  set (d := bl - al) in *; assert (Hd : Rabs d <= u * m).
  { unfold d, Rminus; apply Rle_trans with (1 := Rabs_triang _ _); rewrite Rabs_Ropp; unfold m; lra. }
  pose proof (rnd_plus bl (- al) Fbl (generic_format_opp _ _ _ Fal)) as Hy; fold (bl - al) in Hy; fold d in Hy.
  pose proof (rnd_plus bh (- ah) Fbh (generic_format_opp _ _ _ Fah)) as Hx; fold (bh - ah) in Hx; set (D := bh - ah) in *.
  pose proof (rnd_plus _ _ (format_rnd D) (format_rnd d)) as Hsum; set (x := rnd D) in *; set (y := rnd d) in *.
  pose proof (u_part m Hm) as Hum; assert (Hud : u * Rabs d <= u * (u * m)) by (apply Rmult_le_compat_l; lra).
  pose proof (u_part (u * m) (proj1 Hum)) as Huum; pose proof (u_part _ (Rabs_pos D)) as HuD.
  assert (Hpos : 0 < x + y).
  { apply Rnot_le_lt; intros Hle; rewrite (Rabs_left1 (x + y)) in Hsum by lra; pose proof (u_part (- (x + y)) ltac:(lra)).
    apply Rabs_le_inv in Hsum; lra. }
  rewrite (Rabs_pos_eq (x + y)) in Hsum by lra; pose proof (u_part (x + y) ltac:(lra)) as Hus.
  assert (HD : Rabs D <= 2 * (x + y) + 4 * (u * m)).
  { pose proof (Rabs_triang (D - x) x) as T1; replace (D - x + x) with D in T1 by ring; rewrite Rabs_minus_sym in T1.
    pose proof (Rabs_triang (x + y) (- y)) as T2; replace (x + y + - y) with x in T2 by ring.
    rewrite Rabs_Ropp, (Rabs_pos_eq (x + y)) in T2 by lra; pose proof (Rabs_triang (y - d) d) as T3.
    replace (y - d + d) with y in T3 by ring; lra. }
  assert (HuD' : u * Rabs D <= u * (2 * (x + y) + 4 * (u * m))) by (apply Rmult_le_compat_l; lra).
  assert (Hu2 : u * (x + y) <= e12 / 1000 * (x + y)) by (apply Rmult_le_compat_r; lra).
  apply Rabs_le_inv in Hsum, Hx, Hy; assert (Hxy : (1 + / 30000000) * e <= x + y) by lra.
  assert (Hdiff : e - 5 * (u * (u * m)) < D + d) by lra.
  (* Both errors have room. *)
  rewrite sixteen_u_u in Na, Nb; pose proof (between_sizes (ah + al) s); pose proof (between_sizes (bh + bl) t).
  assert (Room : 16 * (u * u) * Rabs ah + 16 * (u * u) * Rabs bh = 16 * (u * (u * m))) by (unfold m; ring).
  unfold D, d, e in *; lra.
Qed.

(** ** Exact parameters *)

Lemma of_infinity (x : Limits.binary64) s : B2SF x = SpecFloat.S754_infinity s -> x = B754_infinity s.
Proof. destruct x; intros E; try discriminate E; injection E as ->; reflexivity. Qed.

Local Instance prec53 : Prec_gt_0 53 := eq_refl.
Local Instance below1024 : Prec_lt_emax 53 1024 := eq_refl.

(** The binary64 next to one, as std::nextafter finds it. *)
Definition next_below (x : Limits.binary64) : Limits.binary64 := Bpred x.
Definition next_above (x : Limits.binary64) : Limits.binary64 := Bsucc x.

(** The largest number, beyond which all that is rounded to infinity lies. *)
Notation largest := (@Bmax_float 53 1024 _ _).
Lemma largest_below t : bpow radix2 1024 <= Rabs (rnd t) -> B2R largest <= Rabs t.
Proof.
  intros Hr; apply Rnot_lt_le; intros Hlt; set (b := largest) in *.
  pose proof (abs_B2R_lt_emax 53 1024 b) as Hb; pose proof (Rle_abs (B2R b)).
  pose proof (rnd_le _ _ (Rlt_le _ _ Hlt)) as Hle; rewrite (rnd_format (B2R b) (generic_format_B2R 53 1024 b)) in Hle.
  unfold Rabs in Hr, Hle; destruct (Rcase_abs t) as [Hneg|Hneg].
  - rewrite rnd_opp in Hle; pose proof (rnd_le t 0 ltac:(lra)) as Hr0; rewrite rnd_0 in Hr0.
    destruct (Rcase_abs (rnd t)); lra.
  - pose proof (rnd_nonneg t ltac:(lra)); destruct (Rcase_abs (rnd t)); lra.
Qed.

Theorem nearest_between x t : Limits.rounded_once x t ->
  Limits.at_most (next_below x) t /\ Limits.at_least (next_above x) t.
Proof.
  unfold next_below, next_above, Limits.rounded_once; destruct (Rlt_bool_spec (Rabs (rnd t)) (bpow radix2 1024)) as [_|Hbig].
  - intros [Fx Ex]; split.
    + pose proof (Bpred_correct 53 1024 _ _ x Fx) as H; destruct (Rlt_bool _ _).
      * destruct H as (Ep & Fp & _); right; split; [exact Fp|]; rewrite Ep, Ex; apply pred_round_le_id; auto with typeclass_instances.
      * left; now apply of_infinity.
    + pose proof (Bsucc_correct 53 1024 _ _ x Fx) as H; destruct (Rlt_bool _ _).
      * destruct H as (Ep & Fp & _); right; split; [exact Fp|]; rewrite Ep, Ex; apply succ_round_ge_id; auto with typeclass_instances.
      * left; now apply of_infinity.
  - intros ->; apply largest_below in Hbig; destruct (Rlt_bool_spec t 0) as [Hneg|Hpos].
    + split; [now left | right; split; [reflexivity|]]; rewrite Rabs_left in Hbig by exact Hneg.
      change (Bsucc (B754_infinity true)) with (Bopp largest); rewrite B2R_Bopp; lra.
    + split; [right; split; [reflexivity|] | now left]; rewrite Rabs_pos_eq in Hbig by exact Hpos.
      change (Bpred (B754_infinity false)) with (Bopp (Bopp largest)); rewrite !B2R_Bopp; lra.
Qed.
