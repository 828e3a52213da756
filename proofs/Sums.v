(** * Sums: what a sum of double-doubles loses

    Formas.Pairs.sum and difference, of src/trace/double_double-inl.hpp. Both halves are added exactly; what is lost are two
    roundings of lower parts. Where the leading parts all but cancel they do so exactly, and nothing is lost of what is
    left but one rounding that is small beside it: so the loss is at most 6u² of the sum, however much is cancelled.

    double_word x  == x is a pair of binary64 whose first part is the whole, rounded once: what each operation returns *)
From Coq Require Import Reals ZArith Lra Lia Psatz.
From Flocq Require Import Core Sterbenz.
From Durero Require Import Rounding Twofold.
From Durero Require Formas.
Import Formas.Pairs.
Local Open Scope R_scope.
Local Opaque bpow.

Notation e12 := (/ 1000000000000).
Local Instance prec53 : Prec_gt_0 53 := eq_refl.

Definition double_word (x : twofold) : Prop := format (hi x) /\ format (lo x) /\ hi x = rnd (whole x).

Lemma u_part x : 0 <= x -> 0 <= u * x <= e12 * x.
Proof.
  intros Hx; pose proof u_bounds; split; [apply Rmult_le_pos; lra | apply Rmult_le_compat_r; [exact Hx | apply u_bounds]].
Qed.

(** The error of one rounding, where a is a bound of what is rounded. *)
Lemma lost_of_sum x y a : format x -> format y -> Rabs (x + y) <= a -> Rabs (rnd (x + y) - (x + y)) <= u * a.
Proof.
  intros Fx Fy Ha; apply Rle_trans with (1 := rnd_plus x y Fx Fy); apply Rmult_le_compat_l; [apply bpow_ge_0 | exact Ha].
Qed.

Lemma double_word_is_pair x : double_word x -> pair x.
Proof.
  intros (Fh & Fl & E); destruct (sum_lacks _ _ Fh Fl) as [_ L]; split; [exact Fh | split; [exact Fl|]].
  fold (whole x) in L; rewrite <- E in L; replace (lo x) with (whole x - hi x) by (unfold whole; ring); exact L.
Qed.

Lemma double_word_of_sum a b x : format a -> format b -> hi x = rnd (a + b) -> format (lo x) -> whole x = a + b ->
  double_word x.
Proof. intros Fa Fb Eh Fl Ew; split; [rewrite Eh; apply format_rnd | split; [exact Fl | now rewrite Ew]]. Qed.

Lemma exactly_word a : format a -> double_word (exactly a) /\ whole (exactly a) = a.
Proof.
  intros Fa; unfold double_word, whole, exactly; cbn [hi lo]; rewrite Rplus_0_r.
  split; [split; [exact Fa | split; [apply generic_format_0 | symmetry; now apply rnd_format]] | reflexivity].
Qed.

Lemma opposite_word x : double_word x -> double_word (opposite x) /\ whole (opposite x) = - whole x.
Proof.
  intros (Fh & Fl & E); assert (Ew : whole (opposite x) = - whole x) by (unfold whole, opposite; cbn [hi lo]; ring).
  split; [|exact Ew]; split; [now apply generic_format_opp | split; [now apply generic_format_opp|]].
  rewrite Ew, rnd_opp, <- E; reflexivity.
Qed.

Lemma two_sum_word a b : format a -> format b -> double_word (two_sum a b) /\ whole (two_sum a b) = a + b.
Proof.
  intros Fa Fb; destruct (two_sum_exact a b Fa Fb) as [(_ & Fl & _) E]; split; [|exact E].
  now apply (double_word_of_sum a b).
Qed.

Lemma two_sum_is a b : format a -> format b -> two_sum a b = Twofold (rnd (a + b)) (a + b - rnd (a + b)).
Proof.
  intros Fa Fb; destruct (two_sum_exact a b Fa Fb) as [_ E]; unfold whole in E.
  change (Twofold (rnd (a + b)) (lo (two_sum a b)) = Twofold (rnd (a + b)) (a + b - rnd (a + b))).
  change (hi (two_sum a b)) with (rnd (a + b)) in E; f_equal; lra.
Qed.

Lemma fast_two_sum_word a b : format a -> format b -> whole (fast_two_sum a b) = a + b -> double_word (fast_two_sum a b).
Proof. intros Fa Fb E; apply (double_word_of_sum a b); auto; apply format_rnd. Qed.

(** What the sign of the first part says, beside a binary64, it says of the whole. *)
Lemma word_above x a : double_word x -> format a -> a < hi x -> a < whole x.
Proof.
  intros (_ & _ & E) Fa H; rewrite E in H; apply Rnot_le_lt; intros Hle; apply rnd_le in Hle.
  rewrite (rnd_format a Fa) in Hle; lra.
Qed.

Lemma word_below x a : double_word x -> format a -> hi x < a -> whole x < a.
Proof.
  intros (_ & _ & E) Fa H; rewrite E in H; apply Rnot_le_lt; intros Hle; apply rnd_le in Hle.
  rewrite (rnd_format a Fa) in Hle; lra.
Qed.

Lemma word_near x : double_word x -> Rabs (hi x - whole x) <= u * Rabs (whole x) /\ Rabs (hi x - whole x) <= u * Rabs (hi x).
Proof.
  intros W; pose proof (double_word_is_pair x W) as (_ & _ & L); destruct W as (Fh & Fl & E); split.
  - rewrite E; apply (rnd_plus (hi x) (lo x) Fh Fl).
  - replace (hi x - whole x) with (- lo x) by (unfold whole; ring); now rewrite Rabs_Ropp.
Qed.

(** ** Sums of binary64 that are exact *)

(** A sum that is rounded is not much less than what it is of (Sterbenz). *)
Lemma apart a b : format a -> format b -> a + b - rnd (a + b) <> 0 -> Rabs a + Rabs b <= 3 * Rabs (a + b).
Proof.
  intros Fa Fb N; apply Rnot_lt_le; intros H; apply N; rewrite rnd_format; [ring|].
  assert (S : forall x y, format x -> format y -> y / 2 <= x <= 2 * y -> format (x - y)).
  { intros x y Fx Fy; apply sterbenz; auto with typeclass_instances. }
  unfold Rabs in H; destruct (Rcase_abs a), (Rcase_abs b), (Rcase_abs (a + b)); try lra.
  - replace (a + b) with (b - - a) by ring; apply S; auto using generic_format_opp; lra.
  - replace (a + b) with (b - - a) by ring; apply S; auto using generic_format_opp; lra.
  - replace (a + b) with (a - - b) by ring; apply S; auto using generic_format_opp; lra.
  - replace (a + b) with (a - - b) by ring; apply S; auto using generic_format_opp; lra.
Qed.

Lemma own_grid x : format x -> grid (cexp radix2 fexp x) x /\ (-1074 <= cexp radix2 fexp x)%Z.
Proof.
  intros F; split; [exists (Ztrunc (scaled_mantissa radix2 fexp x)); exact F | unfold cexp, FLT_exp; lia].
Qed.

Lemma format_of_grid e x : (-1074 <= e)%Z -> grid e x -> Rabs x <= bpow radix2 (53 + e) -> format x.
Proof.
  intros He [n Hn] Hx; destruct (Rle_lt_or_eq_dec _ _ Hx) as [Hlt|Heq].
  - rewrite Hn; apply (generic_format_F2R radix2 fexp n e); intros Hn0; unfold F2R; cbn [Fnum Fexp]; rewrite <- Hn.
    assert (Hx0 : x <> 0) by (rewrite Hn; apply Rmult_integral_contrapositive_currified;
      [now apply not_0_IZR | apply Rgt_not_eq, bpow_gt_0]).
    unfold cexp, FLT_exp; pose proof (mag_le_bpow radix2 x (53 + e) Hx0 Hlt); lia.
  - assert (Fb : format (bpow radix2 (53 + e))) by (apply format_bpow; lia).
    unfold Rabs in Heq; destruct Rcase_abs; [|now rewrite Heq].
    replace x with (- bpow radix2 (53 + e)) by lra; now apply generic_format_opp.
Qed.

(** Dekker's sum of two in the other order of their sizes, where the lesser is an integer times the last place of the
    greater. *)
Lemma fast_two_sum_on_grid a b : format a -> format b -> Rabs a <= Rabs b -> grid (cexp radix2 fexp b) a ->
  whole (fast_two_sum a b) = a + b.
Proof.
  intros Fa Fb Hab Ga; destruct (own_grid b Fb) as [Gb He]; set (e := cexp radix2 fexp b) in *.
  destruct (sum_lacks a b Fa Fb) as [Fl _]; set (s := rnd (a + b)) in *.
  assert (Gs : grid e (s - a)) by (apply grid_plus; [apply grid_rnd; [exact He | now apply grid_plus] | now apply grid_opp]).
  enough (Fd : format (s - a)).
  { unfold fast_two_sum, whole; cbn [hi lo]; fold s; rewrite (rnd_format (s - a) Fd).
    replace (b - (s - a)) with (a + b - s) by ring; rewrite (rnd_format _ Fl); ring. }
  destruct (Req_dec b 0) as [Z0|Hb].
  { rewrite Z0, Rabs_R0 in Hab; assert (a = 0) as -> by (unfold Rabs in Hab; destruct Rcase_abs; lra).
    rewrite Rminus_0_r; apply format_rnd. }
  destruct (Req_dec (a + b) 0) as [Z0|Hs].
  { unfold s; rewrite Z0, rnd_0; replace (0 - a) with (- a) by ring; now apply generic_format_opp. }
  apply (format_of_grid e); [exact He | exact Gs|].
  assert (Herr : Rabs (s - (a + b)) <= bpow radix2 e).
  { pose proof (error_le_half_ulp radix2 fexp (fun n => negb (Z.even n)) (a + b)) as H; fold s in H.
    rewrite ulp_neq_0 in H by exact Hs; apply Rle_trans with (1 := H).
    apply Rle_trans with (/ 2 * bpow radix2 (e + 1)).
    - apply Rmult_le_compat_l; [lra|]; apply bpow_le; unfold e, cexp, FLT_exp.
      enough (mag radix2 (a + b) <= mag radix2 b + 1)%Z by lia; rewrite <- (mag_mult_bpow radix2 b 1 Hb).
      apply mag_le_abs; [exact Hs|]; rewrite Rabs_mult, (Rabs_pos_eq (bpow _ _)) by apply bpow_ge_0.
      replace (bpow radix2 1) with 2 by reflexivity; apply Rle_trans with (1 := Rabs_triang _ _); lra.
    - rewrite bpow_plus; replace (bpow radix2 1) with 2 by reflexivity; lra. }
  assert (Hbig : Rabs b <= bpow radix2 (53 + e) - bpow radix2 e).
  { destruct Gb as [n Hn]; rewrite Hn, Rabs_mult, (Rabs_pos_eq (bpow _ _)) by apply bpow_ge_0.
    assert (Hlt : Rabs b < bpow radix2 (53 + e)).
    { apply Rlt_le_trans with (1 := bpow_mag_gt radix2 b), bpow_le; unfold e, cexp, FLT_exp; lia. }
    rewrite Hn, Rabs_mult, (Rabs_pos_eq (bpow _ _)), bpow_plus in Hlt by apply bpow_ge_0.
    apply Rmult_lt_reg_r in Hlt; [|apply bpow_gt_0]; rewrite bpow_plus.
    replace (bpow radix2 53 * bpow radix2 e - bpow radix2 e) with ((bpow radix2 53 - 1) * bpow radix2 e) by ring.
    apply Rmult_le_compat_r; [apply bpow_ge_0|]; replace (bpow radix2 53) with (IZR (2 ^ 53)) in * by reflexivity.
    rewrite <- abs_IZR in *; rewrite <- minus_IZR; apply IZR_le; apply lt_IZR in Hlt; lia. }
  replace (s - a) with ((s - (a + b)) + b) by ring; apply Rle_trans with (1 := Rabs_triang _ _); lra.
Qed.

(** ** The sum of two *)

Section Sum.
Variables x y : twofold.
Hypothesis x_word : double_word x.
Hypothesis y_word : double_word y.

Let s := rnd (hi x + hi y).
Let s_lost := hi x + hi y - s.
Let t := rnd (lo x + lo y).
Let t_lost := lo x + lo y - t.
Let c := rnd (s_lost + t).
Let v := rnd (s + c).
Let v_lost := s + c - v.
Let w := rnd (t_lost + v_lost).
Let exact := whole x + whole y.

Lemma formats : format s /\ format s_lost /\ format t /\ format t_lost /\ format c /\ format v /\ format w.
Proof.
  destruct x_word as (? & ? & _), y_word as (? & ? & _); repeat split; try apply format_rnd; now apply sum_lacks.
Qed.

Lemma sum_is : whole (fast_two_sum s c) = s + c -> sum x y = fast_two_sum v w.
Proof.
  intros E; destruct x_word as (? & ? & _), y_word as (? & ? & _).
  change (sum x y) with (let high := two_sum (hi x) (hi y) in let low := two_sum (lo x) (lo y) in
    let z := fast_two_sum (hi high) (rnd (lo high + hi low)) in fast_two_sum (hi z) (rnd (lo low + lo z))).
  rewrite !two_sum_is by assumption; cbv zeta; cbn [hi lo]; fold s t s_lost t_lost c.
  replace (lo (fast_two_sum s c)) with v_lost; [reflexivity|].
  unfold whole in E; unfold v_lost; change (hi (fast_two_sum s c)) with v in E; lra.
Qed.

Definition summed : Prop :=
  double_word (sum x y) /\ Rabs (whole (sum x y) - exact) <= 6 * (u * (u * Rabs exact)).

(** Both sums of two, and what is left of the lower parts, in one bound. *)
Lemma summed_if lost : whole (fast_two_sum s c) = s + c -> v = 0 \/ Rabs w <= Rabs v ->
  Rabs (c - (s_lost + t)) + Rabs (w - (t_lost + v_lost)) <= lost -> lost <= 6 * (u * (u * Rabs exact)) -> summed.
Proof.
  intros E Hw Hl Hexact; destruct formats as (_ & _ & _ & _ & _ & Fv & Fw); unfold summed; rewrite (sum_is E).
  destruct (fast_two_sum_exact v w Fv Fw Hw) as [_ Ew]; split; [now apply fast_two_sum_word|]; rewrite Ew.
  apply Rle_trans with (2 := Hexact), Rle_trans with (2 := Hl).
  replace (v + w - exact) with ((c - (s_lost + t)) + (w - (t_lost + v_lost)))
    by (unfold exact, whole, v_lost, t_lost, s_lost; ring); apply Rabs_triang.
Qed.

Lemma parts_small : Rabs (lo x) <= u * Rabs (hi x) /\ Rabs (lo y) <= u * Rabs (hi y).
Proof. split; [apply (double_word_is_pair x x_word) | apply (double_word_is_pair y y_word)]. Qed.

(** The leading parts do not cancel: the lower ones are small beside their sum. *)
Lemma sum_of_apart : Rabs (hi x) + Rabs (hi y) <= 3 * Rabs (hi x + hi y) -> summed.
Proof.
  intros Hapart; destruct formats as (Fs & Fsl & Ft & Ftl & Fc & Fv & Fw), parts_small as [Lx Ly].
  destruct x_word as (Fhx & Flx & _), y_word as (Fhy & Fly & _); set (S := Rabs (hi x + hi y)) in *.
  assert (HS : 0 <= S) by apply Rabs_pos; pose proof (u_part S HS) as HU; pose proof (u_part _ (proj1 HU)) as HUU.
  assert (Hlow : Rabs (lo x) + Rabs (lo y) <= 3 * (u * S)).
  { assert (u * (Rabs (hi x) + Rabs (hi y)) <= u * (3 * S)) by (apply Rmult_le_compat_l; [apply bpow_ge_0 | exact Hapart]); lra. }
  assert (Hs : Rabs s_lost <= u * S).
  { unfold s_lost; rewrite <- Rabs_Ropp; replace (- (hi x + hi y - s)) with (s - (hi x + hi y)) by ring.
    apply lost_of_sum; auto; apply Rle_refl. }
  assert (Ht : Rabs t_lost <= 3 * (u * (u * S))).
  { unfold t_lost; rewrite <- Rabs_Ropp; replace (- (lo x + lo y - t)) with (t - (lo x + lo y)) by ring.
    replace (3 * (u * (u * S))) with (u * (3 * (u * S))) by ring; apply lost_of_sum; auto.
    apply Rle_trans with (1 := Rabs_triang _ _); exact Hlow. }
  assert (Ht' : Rabs t <= (3 + / 1000) * (u * S)).
  { replace t with ((lo x + lo y) - t_lost) by (unfold t_lost; ring); unfold Rminus.
    apply Rle_trans with (1 := Rabs_triang _ _); rewrite Rabs_Ropp.
    pose proof (Rabs_triang (lo x) (lo y)); lra. }
  assert (Hc0 : Rabs (s_lost + t) <= (4 + / 1000) * (u * S)) by (apply Rle_trans with (1 := Rabs_triang _ _); lra).
  pose proof (lost_of_sum _ _ _ Fsl Ft Hc0) as Hc; fold c in Hc.
  assert (Hc' : Rabs c <= 5 * (u * S)).
  { replace c with ((c - (s_lost + t)) + (s_lost + t)) by ring; apply Rle_trans with (1 := Rabs_triang _ _); lra. }
  assert (Hs' : (1 - / 1000) * S <= Rabs s).
  { assert (S <= Rabs s + Rabs s_lost); [|lra].
    unfold S; replace (hi x + hi y) with (s + s_lost) by (unfold s_lost; ring); apply Rabs_triang. }
  assert (Hroom_c : Rabs c <= Rabs s) by lra.
  destruct (fast_two_sum_exact s c Fs Fc (or_intror Hroom_c)) as [_ E].
  assert (Hsc : Rabs (s + c) <= (1 + / 100) * S).
  { replace (s + c) with ((hi x + hi y) + (c - s_lost)) by (unfold s_lost; ring).
    apply Rle_trans with (1 := Rabs_triang _ _); fold S; unfold Rminus at 1.
    pose proof (Rabs_triang c (- s_lost)) as Htr; rewrite Rabs_Ropp in Htr; lra. }
  assert (Hv : Rabs v_lost <= (1 + / 100) * (u * S)).
  { unfold v_lost; rewrite <- Rabs_Ropp; replace (- (s + c - v)) with (v - (s + c)) by ring.
    replace ((1 + / 100) * (u * S)) with (u * ((1 + / 100) * S)) by ring; now apply lost_of_sum. }
  assert (Fvl : format v_lost) by now apply sum_lacks.
  assert (Hw0 : Rabs (t_lost + v_lost) <= (1 + / 50) * (u * S)) by (apply Rle_trans with (1 := Rabs_triang _ _); lra).
  pose proof (lost_of_sum _ _ _ Ftl Fvl Hw0) as Hw; fold w in Hw.
  assert (Hv' : (1 - / 10) * S <= Rabs v).
  { assert (Rabs s <= Rabs v + (Rabs v_lost + Rabs c)); [|lra].
    replace s with (v + (v_lost - c)) by (unfold v_lost; ring); apply Rle_trans with (1 := Rabs_triang _ _).
    apply Rplus_le_compat_l; unfold Rminus; apply Rle_trans with (1 := Rabs_triang _ _); rewrite Rabs_Ropp; lra. }
  assert (Hexact : (1 - / 1000) * S <= Rabs exact).
  { assert (S <= Rabs exact + (Rabs (lo x) + Rabs (lo y))); [|lra].
    unfold S; replace (hi x + hi y) with (exact + - (lo x + lo y)) by (unfold exact, whole; ring).
    apply Rle_trans with (1 := Rabs_triang _ _); rewrite Rabs_Ropp; apply Rplus_le_compat_l, Rabs_triang. }
  assert (Huu : u * (u * ((1 - / 1000) * S)) <= u * (u * Rabs exact)).
  { pose proof u_bounds; apply Rmult_le_compat_l; [lra|]; apply Rmult_le_compat_l; lra. }
  apply (summed_if (u * ((4 + / 1000) * (u * S)) + u * ((1 + / 50) * (u * S))) E); [right | lra | lra].
  replace w with ((w - (t_lost + v_lost)) + (t_lost + v_lost)) by ring; apply Rle_trans with (1 := Rabs_triang _ _); lra.
Qed.

(** The leading parts are of one size and their sum is exact: it is an integer times the last place of t. *)
Lemma sum_of_close : s_lost = 0 -> Rabs (hi x) <= 4 * Rabs (hi y) -> Rabs (hi y) <= 4 * Rabs (hi x) -> summed.
Proof.
  intros Es Hxy Hyx; destruct formats as (Fs & Fsl & Ft & Ftl & Fc & Fv & Fw), parts_small as [Lx Ly].
  destruct x_word as (Fhx & Flx & _), y_word as (Fhy & Fly & _).
  assert (Ec : c = t) by (unfold c; rewrite Es, Rplus_0_l; now apply rnd_format).
  assert (Esx : s = hi x + hi y) by (unfold s_lost in Es; lra).
  assert (Hlost : Rabs (c - (s_lost + t)) = 0) by (rewrite Ec, Es, Rplus_0_l, Rminus_diag_eq, Rabs_R0; reflexivity).
  assert (Hexact : exact = s + t + t_lost) by (rewrite Esx; unfold exact, whole, t_lost; ring).
  destruct (sum_lacks _ _ Flx Fly) as [_ Ht]; fold t in Ht; fold t_lost in Ht.
  assert (Gt : t <> 0 -> grid (cexp radix2 fexp t) s).
  { intros Nt; assert (Hfine : forall z, Rabs t <= bpow radix2 (-50) * Rabs z -> format z -> grid (cexp radix2 fexp t) z).
    { intros z Hz Fz; assert (Nz : z <> 0).
      { intros Z0; rewrite Z0, Rabs_R0, Rmult_0_r in Hz; pose proof (Rabs_pos_lt t Nt); lra. }
      apply (grid_coarser _ (cexp radix2 fexp z)); [|now apply own_grid]; unfold cexp, FLT_exp.
      enough (mag radix2 t <= mag radix2 z + -50)%Z by lia; rewrite <- (mag_mult_bpow radix2 z (-50) Nz).
      apply mag_le_abs; [exact Nt|]; rewrite Rabs_mult, (Rabs_pos_eq (bpow _ _)) by apply bpow_ge_0; lra. }
    assert (H50 : bpow radix2 (-50) = 8 * u) by apply multiples_of_u.
    assert (Hts : Rabs t <= (1 + / 100) * (Rabs (lo x) + Rabs (lo y))).
    { assert (Rabs t <= Rabs (lo x + lo y) + Rabs t_lost).
      { replace t with ((lo x + lo y) + - t_lost) by (unfold t_lost; ring).
        apply Rle_trans with (1 := Rabs_triang _ _); rewrite Rabs_Ropp; lra. }
      pose proof (Rabs_triang (lo x) (lo y)); pose proof (u_part _ (Rabs_pos t)); lra. }
    pose proof u_bounds; assert (Hux : u * Rabs (hi x) <= u * (4 * Rabs (hi y))) by (apply Rmult_le_compat_l; lra).
    assert (Huy : u * Rabs (hi y) <= u * (4 * Rabs (hi x))) by (apply Rmult_le_compat_l; lra).
    pose proof (Rmult_le_pos u _ ltac:(lra) (Rabs_pos (hi x))); pose proof (Rmult_le_pos u _ ltac:(lra) (Rabs_pos (hi y))).
    rewrite Esx; apply grid_plus; apply Hfine; auto; rewrite H50; lra. }
  assert (E : whole (fast_two_sum s c) = s + c).
  { rewrite Ec; destruct (Rle_or_lt (Rabs t) (Rabs s)) as [Hle|Hlt].
    - now apply fast_two_sum_exact; [| | right].
    - apply fast_two_sum_on_grid; auto; [lra|]; apply Gt; intros Z0; rewrite Z0, Rabs_R0 in Hlt.
      pose proof (Rabs_pos s); lra. }
  destruct (Req_dec v_lost 0) as [Z0|N].
  - assert (Ew : w = t_lost) by (unfold w; rewrite Z0, Rplus_0_r; now apply rnd_format).
    assert (Ev : v = s + t) by (unfold v_lost in Z0; rewrite Ec in Z0; lra).
    assert (Hl0 : Rabs (w - (t_lost + v_lost)) = 0) by (rewrite Ew, Z0, Rplus_0_r, Rminus_diag_eq, Rabs_R0; reflexivity).
    apply (summed_if 0 E); [|lra|].
    + rewrite Ew; destruct (Req_dec t 0) as [Zt|Nt].
      { right; rewrite Zt, Rabs_R0, Rmult_0_r in Ht; pose proof (Rabs_pos v); lra. }
      destruct (Req_dec v 0) as [Zv|Nv]; [now left | right].
      assert (Gv : grid (cexp radix2 fexp t) v) by (rewrite Ev; apply grid_plus; [now apply Gt | now apply own_grid]).
      pose proof (error_le_half_ulp_round radix2 fexp (fun n => negb (Z.even n)) (lo x + lo y)) as Hh; fold t in Hh.
      rewrite ulp_neq_0 in Hh by exact Nt; rewrite Rabs_minus_sym in Hh; fold t_lost in Hh.
      pose proof (grid_at_least _ _ Gv Nv); pose proof (bpow_gt_0 radix2 (cexp radix2 fexp t)); lra.
    + pose proof (u_part _ (Rabs_pos exact)) as HU; pose proof (u_part _ (proj1 HU)); lra.
  - unfold v_lost, v in N; rewrite Ec in N; pose proof (apart s t Fs Ft N) as Hapart.
    set (S := Rabs (s + t)) in *; assert (HS : 0 <= S) by apply Rabs_pos.
    pose proof (u_part S HS) as HU; pose proof (u_part _ (proj1 HU)) as HUU; pose proof (Rabs_pos s).
    assert (Hv : Rabs v_lost <= u * S).
    { unfold v_lost; rewrite <- Rabs_Ropp, Ec; replace (- (s + t - v)) with (v - (s + t)) by ring; unfold v; rewrite Ec.
      apply lost_of_sum; auto; apply Rle_refl. }
    assert (Ht' : Rabs t_lost <= 3 * (u * S)).
    { apply Rle_trans with (1 := Ht); replace (3 * (u * S)) with (u * (3 * S)) by ring.
      apply Rmult_le_compat_l; [apply bpow_ge_0 | lra]. }
    assert (Fvl : format v_lost) by (unfold v_lost, v; rewrite Ec; now apply sum_lacks).
    assert (Hw0 : Rabs (t_lost + v_lost) <= 4 * (u * S)) by (apply Rle_trans with (1 := Rabs_triang _ _); lra).
    pose proof (lost_of_sum _ _ _ Ftl Fvl Hw0) as Hw; fold w in Hw.
    assert (Hv' : (1 - / 1000) * S <= Rabs v).
    { assert (S <= Rabs v + Rabs v_lost); [|lra].
      unfold S; replace (s + t) with (v + v_lost) by (unfold v_lost; rewrite Ec; ring); apply Rabs_triang. }
    assert (He : (1 - / 1000) * S <= Rabs exact).
    { assert (S <= Rabs exact + Rabs t_lost); [|lra].
      unfold S; replace (s + t) with (exact + - t_lost) by (rewrite Hexact; ring).
      apply Rle_trans with (1 := Rabs_triang _ _); rewrite Rabs_Ropp; lra. }
    assert (Huu : u * (u * ((1 - / 1000) * S)) <= u * (u * Rabs exact)).
    { pose proof u_bounds; apply Rmult_le_compat_l; [lra|]; apply Rmult_le_compat_l; lra. }
    apply (summed_if (u * (4 * (u * S))) E); [right | lra | lra].
    replace w with ((w - (t_lost + v_lost)) + (t_lost + v_lost)) by ring; apply Rle_trans with (1 := Rabs_triang _ _); lra.
Qed.

Theorem sum_near : summed.
Proof.
  destruct (Req_dec s_lost 0) as [Z0|N].
  - destruct (Rle_or_lt (Rabs (hi x)) (4 * Rabs (hi y))) as [Hxy|Hxy], (Rle_or_lt (Rabs (hi y)) (4 * Rabs (hi x))) as [Hyx|Hyx];
      [now apply sum_of_close | apply sum_of_apart.. ];
      pose proof (Rabs_triang_inv (hi x) (- hi y)) as H1; pose proof (Rabs_triang_inv (hi y) (- hi x)) as H2;
      rewrite Rabs_Ropp in H1, H2; replace (hi x - - hi y) with (hi x + hi y) in H1 by ring;
      replace (hi y - - hi x) with (hi x + hi y) in H2 by ring; pose proof (Rabs_pos (hi x)); pose proof (Rabs_pos (hi y)); lra.
  - apply sum_of_apart, apart; [apply x_word | apply y_word | exact N].
Qed.
End Sum.

Lemma difference_is x y : difference x y = sum x (opposite y).
Proof. reflexivity. Qed.

Theorem difference_near x y : double_word x -> double_word y -> double_word (difference x y) /\
  Rabs (whole (difference x y) - (whole x - whole y)) <= 6 * (u * (u * Rabs (whole x - whole y))).
Proof.
  intros Hx Hy; rewrite difference_is; destruct (opposite_word y Hy) as [Wy Ey].
  pose proof (sum_near x _ Hx Wy) as H; unfold summed in H; rewrite Ey in H; exact H.
Qed.
