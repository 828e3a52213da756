(** * Decision: what the tracer decides of a quadratic in binary64, and that it is right

    trace/closed_form-inl.hpp decides, of coefficients with bounds on their errors, whether a ray has a first point on an
    element: Formas.v has its decision in lanes as one term of f, the computed quadratic. Here f is anything within such
    bounds of an exact one, A t² + 2B t + C with B² - AC = F·H; what a shape has to do with it is in other files.

    sound            == f is within its bounds of A, B, C, F and H, and of the magnitudes that the bounds ask for
    is_root t        == t solves the exact quadratic
    S, q, from_A, …  == what is computed on the way, by the names of closed_form-inl.hpp
    decided place    == the decision in lanes, over what decides whether a root is a point of the element
    first_of on t    == t is the least root that is [on] the ray and the element *)
From Coq Require Import Reals ZArith Lra Lia Psatz Bool.
From Flocq Require Import Core.
From Durero Require Import Rounding Quotient Roots.
From Durero Require Formas.
Local Open Scope R_scope.
Local Opaque bpow.

Section Decision.
Variable f : Formas.quadratic R.
Variables A B C F H : R.

Notation A_fl := (Formas.A f).
Notation B_fl := (Formas.B f).
Notation C_fl := (Formas.C f).
Notation F_fl := (Formas.F f).
Notation H_fl := (Formas.H f).
Notation A_error := (Formas.A_error f).
Notation B_error := (Formas.B_error f).
Notation C_error := (Formas.C_error f).

Record sound : Prop := Sound {
  A_near : Rabs (A_fl - A) <= A_error;
  B_near : Rabs (B_fl - B) <= 5 / 6 * B_error;
  C_near : Rabs (C_fl - C) <= C_error;
  F_near : Rabs (F_fl - F) <= 5 / 6 * B_error;
  H_near : Rabs (H_fl - H) <= 5 / 6 * B_error;
  F_times_H : B * B - A * C = F * H;
  F_below : Rabs F <= H;
  F_fl_below : F_fl <= H_fl;
  binary64 : format A_fl /\ format B_fl /\ format A_error /\ format B_error /\ format C_error;
  B_grid : grid (-912) B_fl;
  errors_least : bpow radix2 (-360) <= A_error /\ bpow radix2 (-360) <= B_error /\ bpow radix2 (-360) <= C_error;
  sizes : Rabs A_fl <= bpow radix2 450 /\ Rabs B_fl <= bpow radix2 440 /\ H_fl <= bpow radix2 440;
  A_error_size : A_error <= bpow radix2 450 }.

Hypothesis f_sound : sound.
Let D := B * B - A * C.
Definition is_root (t : R) : Prop := A * t * t + 2 * B * t + C = 0.

(** ** The computed values, and the decision over them *)

Definition root_of_D : Formas.known R := Formas.root_of_discriminant f.
Definition total : Formas.stable R := Formas.stable_sum f root_of_D.
Notation S := (Formas.value root_of_D).
Notation S_error := (Formas.error root_of_D).
Notation q := (Formas.value (Formas.q total)).
Notation q_error := (Formas.error (Formas.q total)).
Definition from_A : Formas.known R := Formas.quotient q q_error A_fl A_error.
Definition from_C : Formas.known R := Formas.quotient C_fl C_error q q_error.
Definition A_root_first : bool := eqb (Rlt_bool 0 A_fl) (Formas.positive total).
Definition choose (b : bool) (x y : Formas.known R) : Formas.known R :=
  Formas.Known (if b then Formas.value x else Formas.value y) (if b then Formas.error x else Formas.error y).
Definition nearer : Formas.known R := choose A_root_first from_A from_C.
Definition farther : Formas.known R := choose A_root_first from_C from_A.
Definition has_roots : bool :=
  andb (andb (Rlt_bool B_error F_fl) (Rlt_bool (rnd (2 * q_error)) (Rabs q))) (Rlt_bool (rnd (2 * A_error)) (Rabs A_fl)).

Definition decided (place : Formas.known R -> Formas.placed) : Formas.in_lanes :=
  let at_near := place nearer in
  let at_far := place farther in
  let far_one := andb (Formas.outside at_near) (Formas.inside at_far) in
  let hit := andb has_roots (orb (Formas.inside at_near) far_one) in
  let miss := orb (Rlt_bool F_fl (- B_error)) (andb (andb has_roots (Formas.outside at_near)) (Formas.outside at_far)) in
  {| Formas.hit := hit;
     Formas.undecided := negb (orb hit miss);
     Formas.root := choose far_one farther nearer;
     Formas.slope := Formas.Known (if eqb A_root_first far_one then Formas.signed_root total
       else - Formas.signed_root total) S_error |}.

(** The recorded terms are this: Qed compares them, with rounding folded, since it doubles a term to unfold it. *)
Local Opaque round.
Theorem free_is_recorded : Formas.first_in_lanes f = decided (Formas.place f).
Proof. exact_no_check (eq_refl (decided (Formas.place f))). Qed.

Theorem axial_is_recorded : Formas.first_in_lanes_axial f = decided (Formas.place_axial f).
Proof. exact_no_check (eq_refl (decided (Formas.place_axial f))). Qed.
Local Transparent round.

(** ** First decision: no root *)

Lemma no_root t : F_fl < - B_error -> ~ is_root t.
Proof.
  intros HF Ht; unfold is_root in Ht; pose proof (F_near f_sound) as Hb; pose proof (F_below f_sound) as Hl.
  destruct (errors_least f_sound) as (_ & He & _); pose proof (bpow_gt_0 radix2 (-360)).
  apply Rabs_le_inv in Hb, Hl; assert (HF0 : F < 0) by lra; assert (HH : 0 < H) by lra.
  assert (D < 0).
  { unfold D; rewrite (F_times_H f_sound); pose proof (Rmult_lt_compat_r H F 0 HH HF0); lra. }
  pose proof (Rle_0_sqr (A * t + B)) as Hs; unfold Rsqr in Hs.
  replace ((A * t + B) * (A * t + B)) with (A * (A * t * t + 2 * B * t + C) + D) in Hs by (unfold D; ring).
  rewrite Ht in Hs; lra.
Qed.

(** ** Second decision: two roots, and S is the root of the discriminant up to S_error *)

(** S as a number: e stands for B_error, X for F_fl·H_fl, eps for the unit roundoff. *)
Lemma root_of_product eps e a h d X P s : 0 < eps <= / 1000000000000 -> 0 < e -> 0 <= d -> e < a -> a <= (1 + / 1000) * h ->
  X = a * h -> Rabs (X - d) <= 237 / 100 * (e * h) -> Rabs (P - X) <= eps * X -> Rabs (s - sqrt P) <= eps * sqrt P ->
  0 < s /\ s <= 2 * h /\ Rabs (s - sqrt d) <= 24 / 10 * (e * h / s) + 3 * eps * s.
Proof.
  intros Heps He Hd Hf Hh HX Hd' HP HS; assert (Hh0 : 0 < h) by lra.
  assert (HX0 : 0 < X) by (rewrite HX; apply Rmult_lt_0_compat; lra); pose proof (sqrt_lt_R0 X HX0) as HsX.
  assert (HuX : 0 <= eps * X <= / 1000000000000 * X) by (split; [apply Rmult_le_pos | apply Rmult_le_compat_r]; lra).
  apply Rabs_le_inv in HP as HP'; assert (HP0 : 0 <= P) by lra.
  assert (H1 : Rabs (sqrt X - sqrt P) <= eps * sqrt X).
  { apply Rle_trans with (1 := sqrt_distance X P HX0 HP0); apply Rmult_le_reg_r with (sqrt X); [assumption|].
    unfold Rdiv; rewrite Rmult_assoc, Rinv_l, Rmult_assoc, sqrt_sqrt, Rabs_minus_sym by lra; lra. }
  pose proof (sqrt_distance X d HX0 Hd) as H2.
  apply Rabs_le_inv in H1, HS; set (x := sqrt X) in *; set (w := sqrt P) in *.
  assert (Hux : 0 <= eps * x <= / 1000000000000 * x) by (split; [apply Rmult_le_pos | apply Rmult_le_compat_r]; lra).
  assert (Huux : eps * (eps * x) <= / 1000000000000 * (eps * x)) by (apply Rmult_le_compat_r; lra).
  assert (Hs : (1 - eps) * x <= w <= (1 + eps) * x) by lra.
  assert (Huw : eps * w <= eps * ((1 + eps) * x)) by (apply Rmult_le_compat_l; lra).
  assert (HSx : (1 - 3 * eps) * x <= s <= (1 + 3 * eps) * x) by lra.
  assert (HS0 : 0 < s) by lra; split; [assumption|].
  assert (Hxh : x <= (1 + / 1000) * h).
  { unfold x; rewrite <- (sqrt_square ((1 + / 1000) * h)) by lra; apply sqrt_le_1_alt; rewrite HX.
    apply Rmult_le_compat; lra. }
  split; [lra|].
  assert (H3 : Rabs (X - d) / x <= 239 / 100 * (e * h / s)).
  { apply Rle_trans with (237 / 100 * (e * h) / x); [apply Rmult_le_compat_r; [apply Rlt_le, Rinv_0_lt_compat|]; assumption|].
    replace (239 / 100 * (e * h / s)) with (e * h * (239 / 100 * / s)) by (unfold Rdiv; ring).
    replace (237 / 100 * (e * h) / x) with (e * h * (237 / 100 * / x)) by (unfold Rdiv; ring).
    apply Rmult_le_compat_l; [apply Rmult_le_pos; lra|]; apply Rmult_le_reg_r with (x * s); [now apply Rmult_lt_0_compat|].
    replace (237 / 100 * / x * (x * s)) with (237 / 100 * s) by (field; lra);
      replace (239 / 100 * / s * (x * s)) with (239 / 100 * x) by (field; lra); lra. }
  assert (0 < e * h / s) by (apply Rdiv_lt_0_compat; [apply Rmult_lt_0_compat; lra | assumption]).
  assert (Hus : eps * x <= (1 + / 1000) * (eps * s)).
  { replace ((1 + / 1000) * (eps * s)) with (eps * ((1 + / 1000) * s)) by ring; apply Rmult_le_compat_l; lra. }
  replace (s - sqrt d) with ((s - x) + (x - sqrt d)) by ring.
  apply Rle_trans with (1 := Rabs_triang _ _); assert (Rabs (s - x) <= 3 * eps * s) by (apply Rabs_le; lra); lra.
Qed.

Lemma meets : B_error < F_fl ->
  0 < D /\ bpow radix2 (-360) <= S /\ Rabs (S - sqrt D) <= 9 / 10 * S_error /\ 0 <= S_error /\ S <= 2 * H_fl.
Proof.
  intros HF; pose proof (F_near f_sound) as HbF; pose proof (H_near f_sound) as HbH; pose proof (F_below f_sound) as HFH.
  pose proof (F_fl_below f_sound) as Hfh; destruct (errors_least f_sound) as (_ & He360 & _).
  pose proof u_bounds; pose proof (bpow_gt_0 radix2 (-360)) as H360.
  apply Rabs_le_inv in HbF, HbH, HFH.
  assert (HF0 : 0 < F) by lra; assert (HH0 : 0 < H) by lra.
  assert (HD : 0 < D) by (unfold D; rewrite (F_times_H f_sound); apply Rmult_lt_0_compat; lra); split; [assumption|].
  assert (HX : Rabs (F_fl * H_fl - D) <= 237 / 100 * (B_error * H_fl)).
  { unfold D; rewrite (F_times_H f_sound).
    replace (F_fl * H_fl - F * H) with (F_fl * (H_fl - H) + H * (F_fl - F)) by ring.
    assert (Hm : forall a b c, 0 <= a -> - c <= b <= c -> - (a * c) <= a * b <= a * c) 
      by (intros a b c Ha [Hl Hu]; split; [rewrite <- Ropp_mult_distr_r_reverse | ]; now apply Rmult_le_compat_l).
    pose proof (Hm F_fl (H_fl - H) (5 / 6 * B_error) ltac:(lra) HbH).
    pose proof (Hm H (F_fl - F) (5 / 6 * B_error) ltac:(lra) HbF).
    assert (F_fl * (5 / 6 * B_error) <= H_fl * (5 / 6 * B_error)) by (apply Rmult_le_compat_r; lra).
    assert (H * (5 / 6 * B_error) <= 11 / 6 * H_fl * (5 / 6 * B_error)) by (apply Rmult_le_compat_r; lra).
    apply Rabs_le; split; lra. }
  assert (Hnormal : forall x, bpow radix2 (-720) <= x -> Rabs (rnd x - x) <= u * x).
  { intros x Hx; pose proof (bpow_gt_0 radix2 (-720)); rewrite <- (Rabs_pos_eq x) at 3 by lra; apply rnd_rel.
    apply (at_least_normal (-720)); [lia | rewrite Rabs_pos_eq; lra]. }
  assert (Hsq : forall x y, bpow radix2 (-360) <= x -> bpow radix2 (-360) <= y -> bpow radix2 (-720) <= x * y).
  { intros x y Hx Hy; change (-720)%Z with (-360 + -360)%Z; rewrite bpow_plus; apply Rmult_le_compat; lra. }
  assert (Hmore : forall x, bpow radix2 (-360) <= x -> bpow radix2 (-720) <= x).
  { intros x Hx; apply Rle_trans with (2 := Hx), bpow_le; lia. }
  pose proof (Hnormal _ (Hsq F_fl H_fl ltac:(lra) ltac:(lra))) as HP.
  assert (HP0 : bpow radix2 (-720) <= rnd (F_fl * H_fl)) by (apply rnd_ge_bpow; [lia | apply Hsq; lra]).
  assert (Hroot : bpow radix2 (-360) <= sqrt (rnd (F_fl * H_fl))).
  { rewrite <- (sqrt_square (bpow radix2 (-360))) by lra; apply sqrt_le_1_alt; now rewrite <- bpow_plus. }
  pose proof (Hnormal _ (Hmore _ Hroot)) as HS.
  destruct (root_of_product u B_error F_fl H_fl D _ _ _ u_bounds ltac:(lra) ltac:(lra) HF ltac:(lra) eq_refl HX HP HS) as (HS0 & HSh & Hb).
  change (rnd (sqrt (rnd (F_fl * H_fl)))) with S in Hroot, HS, HS0, HSh, Hb |- *.
  change S_error with (rnd (rnd (rnd (rnd (3 * B_error) * H_fl) / S) + rnd (bpow radix2 (-51) * S))).
  assert (Hlow : forall x, bpow radix2 (-720) <= x -> (1 - / 1000000) * x <= rnd x).
  { intros a Ha; pose proof (Hnormal a Ha) as Hr; apply Rabs_le_inv in Hr; pose proof (bpow_gt_0 radix2 (-720)).
    assert (u * a <= / 1000000 * a) by (apply Rmult_le_compat_r; lra); lra. }
  pose proof (Hlow (3 * B_error) (Hmore (3 * B_error) ltac:(lra))) as E1; set (e1 := rnd (3 * B_error)) in *.
  assert (Hbig : 2.99 * B_error <= e1) by lra.
  pose proof (Hlow (e1 * H_fl) (Hsq e1 H_fl ltac:(lra) ltac:(lra))) as E2; set (e2 := rnd (e1 * H_fl)) in *.
  assert (Hbig2 : 2.98 * (B_error * H_fl) <= e2).
  { assert (2.99 * B_error * H_fl <= e1 * H_fl) by (apply Rmult_le_compat_r; lra).
    assert (0 < B_error * H_fl) by (apply Rmult_lt_0_compat; lra); lra. }
  assert (HeS : 2.98 * (B_error * H_fl / S) <= e2 / S).
  { unfold Rdiv; rewrite <- !Rmult_assoc; apply Rmult_le_compat_r; [apply Rlt_le, Rinv_0_lt_compat, HS0 | lra]. }
  assert (Hquo : B_error <= 2 * (B_error * H_fl / S)).
  { apply Rmult_le_reg_r with S; [assumption|];
    replace (2 * (B_error * H_fl / S) * S) with (B_error * (2 * H_fl))
      by (field; lra); apply Rmult_le_compat_l; lra. }
  pose proof (Hlow (e2 / S) (Hmore (e2 / S) ltac:(lra))) as E3; set (e3 := rnd (e2 / S)) in *.
  assert (HS360 : bpow radix2 (-360) <= S) by (apply rnd_ge_bpow; [lia | exact Hroot]).
  assert (H51 : bpow radix2 (-51) = 4 * u) by apply multiples_of_u.
  assert (H4u : bpow radix2 (-720) <= bpow radix2 (-51) * S).
  { apply Rle_trans with (bpow radix2 (-51) * bpow radix2 (-360)); [rewrite <- bpow_plus; apply bpow_le; lia|].
    apply Rmult_le_compat_l; [apply bpow_ge_0 | assumption]. }
  pose proof (Hlow _ H4u) as E4; rewrite H51 in E4 at 1; set (e4 := rnd (bpow radix2 (-51) * S)) in *.
  set (y := B_error * H_fl / S) in *.
  assert (0 < u * S) by (apply Rmult_lt_0_compat; lra).
  assert (Hsum : 2.9 * y + 3.9 * (u * S) <= e3 + e4) by lra.
  pose proof (Hlow (e3 + e4) (Hmore (e3 + e4) ltac:(lra))) as E5.
  split; [assumption|]; split; [apply Rle_trans with (1 := Hb)|]; lra.
Qed.

(** ** The roots *)

(** -(B ± √D), with the sign of the computed B. *)
Definition q_exact : R := - (B + if Rle_bool 0 B_fl then sqrt D else - sqrt D).

Lemma q_bound : B_error < F_fl ->
  Rabs (q - q_exact) <= q_error /\ bpow radix2 (-360) <= q_error /\ Rabs q <= bpow radix2 450 /\ format q /\ format q_error /\
  98 / 100 * B_error <= q_error.
Proof.
  intros HF; destruct (meets HF) as (HD & HS360 & HS & HS0 & HSH); pose proof (B_near f_sound) as HB.
  destruct (errors_least f_sound) as (_ & He360 & _), (binary64 f_sound) as (_ & FB & _ & Fe & _).
  destruct (sizes f_sound) as (_ & HB440 & HH440); pose proof u_bounds; pose proof (bpow_gt_0 radix2 (-360)) as H360.
  change q with (- rnd (B_fl + (if Rle_bool 0 B_fl then S else - S))).
  change q_error with (rnd (rnd (B_error + S_error) + rnd (bpow radix2 (-52) *
    Rabs (- rnd (B_fl + (if Rle_bool 0 B_fl then S else - S)))))).
  unfold q_exact; set (s := if Rle_bool 0 B_fl then S else - S) in *.
  assert (FS : format S) by apply format_rnd.
  assert (GS : grid (-912) S).
  { apply (grid_coarser _ (-412)); [lia|]; apply (format_grid (-360)); [lia | assumption | right;
    now rewrite Rabs_pos_eq by lra]. }
  assert (Fs : format s) by (unfold s; destruct Rle_bool; [assumption | now apply generic_format_opp]).
  assert (Gs : grid (-912) s) by (unfold s; destruct Rle_bool; [assumption | now apply grid_opp]).
  assert (Hs2 : Rabs s <= 2 * bpow radix2 440).
  { unfold s; destruct Rle_bool; [|rewrite Rabs_Ropp]; rewrite Rabs_pos_eq; lra. }
  pose proof (rnd_plus B_fl s FB Fs) as Hr.
  assert (Gy : grid (-912) (rnd (B_fl + s))) by (apply grid_rnd; [lia | now apply grid_plus; [apply (B_grid f_sound)|]]).
  rewrite Rabs_Ropp; set (y := B_fl + s) in *.
  assert (Hs : Rabs (s - if Rle_bool 0 B_fl then sqrt D else - sqrt D) <= 9 / 10 * S_error).
  { unfold s; destruct Rle_bool; [assumption|]; replace (- S - - sqrt D) with (- (S - sqrt D)) by ring.
    now rewrite Rabs_Ropp. }
  set (e := if Rle_bool 0 B_fl then sqrt D else - sqrt D) in *.
  pose proof (Rabs_pos (rnd y)) as Hy0; pose proof (Rabs_pos y) as Hy1.
  assert (Huy : u * Rabs y <= / 1000000000000 * Rabs y) by (apply Rmult_le_compat_r; lra).
  assert (Hy : u * Rabs y <= 11 / 10 * (u * Rabs (rnd y))).
  { pose proof (Rabs_triang (rnd y) (- (rnd y - y))) as Ht; rewrite Rabs_Ropp in Ht.
    replace (rnd y + - (rnd y - y)) with y in Ht by ring.
    replace (11 / 10 * (u * Rabs (rnd y))) with (u * (11 / 10 * Rabs (rnd y))) by ring.
    apply Rmult_le_compat_l; lra. }
  assert (Hlow : forall x, 0 <= x -> Rabs (rnd x - x) <= u * Rabs x -> 99 / 100 * x <= rnd x).
  { intros x Hx Hrx; rewrite (Rabs_pos_eq x Hx) in Hrx; apply Rabs_le_inv in Hrx.
    assert (u * x <= / 1000000000000 * x) by (apply Rmult_le_compat_r; lra); lra. }
  assert (H52 : bpow radix2 (-52) = 2 * u) by apply multiples_of_u.
  assert (E1 : 99 / 100 * (2 * u * Rabs (rnd y)) <= rnd (bpow radix2 (-52) * Rabs (rnd y))).
  { rewrite <- H52; apply Hlow; [apply Rmult_le_pos; [apply bpow_ge_0 | assumption]|].
    apply rnd_rel, (grid_normal (-52 + -912)); [lia | apply grid_mult; [exists 1%Z; ring | now apply grid_abs]]. }
  assert (FSe : format S_error) by apply format_rnd.
  pose proof (Hlow (B_error + S_error) ltac:(lra) (rnd_plus _ _ Fe FSe)) as E2.
  assert (E20 : bpow radix2 (-360) <= rnd (B_error + S_error)) by (apply rnd_ge_bpow; [lia | lra]).
  assert (0 <= u * Rabs (rnd y)) by (apply Rmult_le_pos; lra).
  pose proof (Hlow (rnd (B_error + S_error) + rnd (bpow radix2 (-52) * Rabs (rnd y))) ltac:(lra)
    (rnd_plus _ _ (format_rnd _) (format_rnd _))) as E3.
  split; [|split; [|split; [|split; [apply generic_format_opp, format_rnd | split; [apply format_rnd | lra]]]]].
  - apply Rabs_le_inv in HB, Hr, Hs; apply Rabs_le; unfold y in *; lra.
  - apply rnd_ge_bpow; [lia | lra].
  - pose proof (Rabs_triang B_fl s) as Ht; fold y in Ht.
    pose proof (Rabs_triang (rnd y - y) y) as Ht2; replace (rnd y - y + y) with (rnd y) in Ht2 by ring.
    apply Rle_trans with (bpow radix2 10 * bpow radix2 440); [|rewrite <- bpow_plus; apply bpow_le; lia].
    replace (bpow radix2 10) with 1024 by reflexivity; pose proof (bpow_gt_0 radix2 440); lra.
Qed.

(** What is asked of the place of a computed root: where it says so, the exact one is a point, or is none. *)
Definition places (on : R -> Prop) (place : Formas.known R -> Formas.placed) : Prop :=
  forall root t, Rabs (Formas.value root - t) <= Formas.error root -> format (Formas.value root) ->
  format (Formas.error root) -> bpow radix2 (-900) <= Formas.error root ->
  (Formas.outside (place root) = true -> ~ on t) /\ (Formas.inside (place root) = true -> on t).

Definition first_of (on : R -> Prop) (t : R) : Prop :=
  is_root t /\ on t /\ forall t', is_root t' -> on t' -> t <= t'.

Lemma has_roots_spec : has_roots = true -> B_error < F_fl /\ 2 * q_error < Rabs q /\ 2 * A_error < Rabs A_fl.
Proof.
  unfold has_roots; rewrite !andb_true_iff; intros [[HF Hq] HA].
  destruct (Rlt_bool_spec B_error F_fl); [|discriminate]; destruct (binary64 f_sound) as (_ & _ & FA & _).
  destruct (q_bound ltac:(assumption)) as (_ & _ & _ & _ & Fq & _).
  rewrite (rnd_double _ Fq) in Hq; rewrite (rnd_double _ FA) in HA.
  destruct (Rlt_bool_spec (2 * q_error) (Rabs q)); [|discriminate].
  destruct (Rlt_bool_spec (2 * A_error) (Rabs A_fl)); [|discriminate]; tauto.
Qed.

(** Where there are roots, the two computed ones are near the exact ones, in their order. *)
Lemma two_roots_by : has_roots = true -> exists t0 t1, (if A_root_first then A * t0 = q_exact /\ t1 = C / q_exact
   else t0 = C / q_exact /\ A * t1 = q_exact) /\ t0 < t1 /\ (forall t, is_root t <-> t = t0 \/ t = t1) /\
  (forall root t, root = nearer /\ t = t0 \/ root = farther /\ t = t1 -> is_near root t /\
   format (Formas.value root) /\ format (Formas.error root) /\ bpow radix2 (-900) <= Formas.error root).
Proof.
  intros HR; destruct (has_roots_spec HR) as (HF & Hq & HA); destruct (meets HF) as (HD & _).
  destruct (q_bound HF) as (Hqb & Hqe & Hq450 & Fq & Fqe & _); pose proof (sqrt_lt_R0 D HD) as Hs.
  destruct (binary64 f_sound) as (FA & _ & FAe & _ & FCe), (errors_least f_sound) as (HA360 & _ & HC360).
  destruct (sizes f_sound) as (HA450 & _); pose proof (bpow_gt_0 radix2 (-360)); pose proof (A_near f_sound) as HAn.
  destruct (quotient_bound _ _ _ _ _ _ Fqe FA FAe Hqe Hqb HAn (conj HA HA450)) as (HtA & LtA & FtA & FeA).
  destruct (quotient_bound _ _ _ _ _ _ FCe Fq Fqe HC360 (C_near f_sound) Hqb (conj Hq Hq450)) as (HtC & LtC & FtC & FeC).
  fold from_A in HtA, LtA, FtA, FeA; fold from_C in HtC, LtC, FtC, FeC.
  assert (Hqx : q_exact <> 0).
  { intros Z0; rewrite Z0, Rminus_0_r in Hqb; pose proof (Rabs_pos q); lra. }
  apply Rabs_le_inv in HAn as HAn'.
  assert (HA0 : A <> 0) by (intros Z0; rewrite Z0 in *; unfold Rabs in HA; destruct Rcase_abs in HA; lra).
  assert (HAs : Rlt_bool 0 A_fl = Rlt_bool 0 A).
  { unfold Rabs in HA; destruct Rcase_abs in HA; destruct (Rlt_bool_spec 0 A_fl), (Rlt_bool_spec 0 A); trivial; lra. }
  destruct (exact_roots A B C (sqrt D) q_exact (Rle_bool 0 B_fl) (sqrt_sqrt D (Rlt_le _ _ HD)) Hs eq_refl Hqx HA0)
    as [Hboth Horder]; rewrite <- HAs in Horder; change (eqb (Rlt_bool 0 A_fl) (Rle_bool 0 B_fl)) with A_root_first in Horder.
  set (x := q_exact / A) in *; set (y := C / q_exact) in *.
  assert (Hall : forall t, is_root t <-> t = x \/ t = y) by exact Hboth.
  unfold nearer, farther, choose; destruct A_root_first.
  - exists x, y; split; [split; [unfold x; field; exact HA0 | reflexivity]|]; split; [assumption|]; split; [assumption|].
    intros root t [[-> ->]|[-> ->]]; cbn [Formas.value Formas.error]; tauto.
  - exists y, x; split; [split; [reflexivity | unfold x; field; exact HA0]|]; split; [assumption|].
    split; [intros t; rewrite Hall; tauto|].
    intros root t [[-> ->]|[-> ->]]; cbn [Formas.value Formas.error]; tauto.
Qed.

Corollary two_roots : has_roots = true -> exists t0 t1, t0 < t1 /\ (forall t, is_root t <-> t = t0 \/ t = t1) /\
  (forall root t, root = nearer /\ t = t0 \/ root = farther /\ t = t1 -> is_near root t /\
   format (Formas.value root) /\ format (Formas.error root) /\ bpow radix2 (-900) <= Formas.error root).
Proof. intros HR; destruct (two_roots_by HR) as (t0 & t1 & _ & K); now exists t0, t1. Qed.

(** The verdict: a hit is within its error of the first point, and a miss is one. *)
Theorem the_decision_is_right on place : places on place ->
  let d := decided place in
  (Formas.hit d = true ->
   exists t, first_of on t /\ is_near (Formas.root d) t) /\
  (Formas.hit d = false -> Formas.undecided d = false -> forall t, is_root t -> ~ on t).
Proof.
  intros Hplace d; unfold d, decided; cbn [Formas.hit Formas.undecided Formas.root].
  split.
  - rewrite andb_true_iff; intros [HR Hin]; destruct (two_roots HR) as (t0 & t1 & Hlt & Hall & Hnear).
    destruct (Hnear nearer t0 (or_introl (conj eq_refl eq_refl))) as (N0 & F0 & G0 & L0).
    destruct (Hnear farther t1 (or_intror (conj eq_refl eq_refl))) as (N1 & F1 & G1 & L1).
    destruct (Hplace nearer t0 (near_within _ _ N0) F0 G0 L0) as [Out0 In0], (Hplace farther t1 (near_within _ _ N1) F1 G1 L1) as [Out1 In1].
    destruct (Formas.outside (place nearer)) eqn:O, (Formas.inside (place farther)) eqn:I; cbn [andb] in *;
      try (rewrite orb_false_r in Hin; exists t0; split; [|exact N0]; split; [apply Hall; tauto|]; split;
        [now apply In0 | intros t' Ht' _; apply Hall in Ht'; lra]).
    exists t1; split; [|exact N1]; split; [apply Hall; tauto|]; split; [now apply In1|].
    intros t' Ht' Hon; destruct (proj1 (Hall t') Ht') as [E0|E1]; [rewrite E0 in Hon; now elim (Out0 eq_refl) | lra].
  - intros Hhit; rewrite Hhit; cbn [orb]; rewrite negb_false_iff, orb_true_iff, !andb_true_iff.
    intros [Hmiss|[[HR O0] O1]] t Ht.
    + destruct (Rlt_bool_spec F_fl (- B_error)) as [Hlt|]; [|discriminate]; now elim (no_root t Hlt).
    + destruct (two_roots HR) as (t0 & t1 & Hlt & Hall & Hnear).
      destruct (Hnear nearer t0 (or_introl (conj eq_refl eq_refl))) as (N0 & F0 & G0 & L0).
      destruct (Hnear farther t1 (or_intror (conj eq_refl eq_refl))) as (N1 & F1 & G1 & L1).
      destruct (Hplace nearer t0 (near_within _ _ N0) F0 G0 L0) as [Out0 In0], (Hplace farther t1 (near_within _ _ N1) F1 G1 L1) as [Out1 In1].
      destruct (proj1 (Hall t) Ht) as [E0|E1]; [rewrite E0 | rewrite E1]; auto.
Qed.

(** Where the element is all of its surface, as a sphere is, a place is the sign of the parameter. *)
Lemma place_right : places (fun t => 0 < t) (Formas.place f).
Proof.
  intros root t Hb _ _ _; unfold Formas.place; cbn [Formas.outside Formas.inside]; apply Rabs_le_inv in Hb.
  split; intros H0.
  - destruct (Rlt_bool_spec (Formas.value root) (- Formas.error root)); [lra | discriminate].
  - destruct (Rlt_bool_spec (Formas.error root) (Formas.value root)); [lra | discriminate].
Qed.

End Decision.
