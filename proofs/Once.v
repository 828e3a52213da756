(** * Once: what the tracer rounds and calls certain is the exact number, rounded once

    The terms are Formas.Pairs.round_once, coordinate, round_coordinate and round_point, of src/trace/rounding-inl.hpp. A
    parameter t is known to an error; both ends of what it may be round to one binary64; rounding is monotone, so the
    parameter rounds to it. Of a coordinate p + t·v the same, once its own error is bounded. *)
From Coq Require Import Reals ZArith Lra Lia Psatz Bool.
From Flocq Require Import Core.
From Flocq Require BinarySingleNaN.
From Durero Require Import Rounding Quotient Vectors Flotante Twofold.
From Durero Require Formas Especificacion Puntos Limits Chain.
Import Formas.Pairs.
Local Open Scope R_scope.
Local Opaque bpow.

Notation e12 := (/ 1000000000000).
(** What is lost in computing an error is a part of it that the tracer's factor 1.0000001 pays for. *)
Notation slack := (1 + / 1000000000).

Lemma widening : 1 + / 16777216 <= 4503600077730459 * bpow radix2 (-52).
Proof. replace (bpow radix2 (-52)) with (/ 4503599627370496) by reflexivity; lra. Qed.

Lemma two_u : bpow radix2 (-52) = 2 * u.
Proof. apply multiples_of_u. Qed.

Lemma sixteen_u_u : bpow radix2 (-102) = 16 * (u * u).
Proof. replace 16 with (bpow radix2 4) by reflexivity; now rewrite <- !bpow_plus. Qed.

(** u of a number is far less than it. *)
Lemma u_part x : 0 <= x -> 0 <= u * x <= e12 * x.
Proof.
  intros Hx; pose proof u_bounds; split; [apply Rmult_le_pos; lra | apply Rmult_le_compat_r; [exact Hx | apply u_bounds]].
Qed.

(** The width that both ends are taken at is more than the error and what is lost of the lower part beside it. *)
Lemma wide_enough lo error : format error -> bpow radix2 (-1000) <= error ->
  let wide := rnd (rnd (4503600077730459 * bpow radix2 (-52) * error) + rnd (bpow radix2 (-52) * Rabs lo)) in
  slack * error + u * Rabs lo <= (1 - e12) * wide.
Proof.
  intros Fe He wide; pose proof widening as Hc; set (c := 4503600077730459 * _) in *.
  pose proof (bpow_gt_0 radix2 (-1000)); pose proof (Rabs_pos lo) as HL; set (L := Rabs lo) in *.
  pose proof (least_below (-1000) error ltac:(lia) He) as Hz; pose proof (u_part L HL) as HuL.
  assert (Hce : (1 + / 16777216) * error <= c * error) by (apply Rmult_le_compat_r; lra).
  assert (E1 : (1 - e12) * (c * error) <= rnd (c * error)).
  { apply rnd_low; [lra|]; apply (at_least_normal (-1000)); [lia|]; rewrite Rabs_pos_eq; lra. }
  pose proof (rnd_low_any (bpow radix2 (-52) * L) ltac:(rewrite two_u; lra)) as E2; rewrite two_u in E2 at 1.
  pose proof (rnd_nonneg (bpow radix2 (-52) * L) ltac:(rewrite two_u; lra)) as E20.
  pose proof (rnd_nonneg (c * error) ltac:(lra)) as E10.
  pose proof (rnd_low_sum (rnd (c * error)) (rnd (bpow radix2 (-52) * L)) (format_rnd _) (format_rnd _) ltac:(lra)) as E3.
  fold wide in E3; lra.
Qed.

(** Every number within the error of the pair rounds to what is certain. *)
Theorem round_once_right t error x : format (lo t) -> format error -> bpow radix2 (-1000) <= error ->
  Rabs (x - whole t) <= slack * error -> certain (round_once t error) = true ->
  rounded (round_once t error) = rnd x /\ Rabs (rnd x) < bpow radix2 900.
Proof.
  intros Fl Fe He Hx; unfold round_once; cbn [certain rounded].
  set (wide := rnd (rnd (_ * error) + _)); pose proof (wide_enough (lo t) error Fe He : _ <= (1 - e12) * wide) as Hw.
  rewrite !andb_true_iff; intros [[Heq _] Hsize].
  assert (Hlow_high : rnd (hi t + rnd (lo t - wide)) = rnd (hi t + rnd (lo t + wide))).
  { destruct (Req_bool_spec (rnd (hi t + rnd (lo t - wide))) (rnd (hi t + rnd (lo t + wide)))); [assumption | discriminate]. }
  assert (Hlt : Rabs (rnd (hi t + rnd (lo t - wide))) < bpow radix2 900).
  { destruct (Rlt_bool_spec (Rabs (rnd (hi t + rnd (lo t - wide)))) (bpow radix2 900)); [assumption | discriminate]. }
  pose proof (bpow_gt_0 radix2 (-1000)); pose proof (u_part _ (Rabs_pos (lo t))) as HuL.
  assert (Hwide : 0 <= wide) by lra; pose proof (u_part _ Hwide) as Huw.
  assert (Fw : format wide) by apply format_rnd; unfold whole in Hx; apply Rabs_le_inv in Hx.
  assert (Hsum : forall a, Rabs a = wide -> format a -> Rabs (rnd (lo t + a) - (lo t + a)) <= u * Rabs (lo t) + u * wide).
  { intros a Ha Fa; apply Rle_trans with (1 := rnd_plus (lo t) a Fl Fa); rewrite <- Rmult_plus_distr_l, <- Ha.
    apply Rmult_le_compat_l; [apply bpow_ge_0 | apply Rabs_triang]. }
  pose proof (Hsum wide (Rabs_pos_eq _ Hwide) Fw) as Hup.
  pose proof (Hsum (- wide) ltac:(now rewrite Rabs_Ropp, Rabs_pos_eq) (generic_format_opp _ _ _ Fw)) as Hdown.
  fold (lo t - wide) in Hdown; apply Rabs_le_inv in Hup, Hdown.
  enough (rnd (hi t + rnd (lo t - wide)) = rnd x) as <- by now split.
  apply Rle_antisym; [|rewrite Hlow_high]; apply rnd_le; lra.
Qed.

(** ** A coordinate: what is lost is roundings of lower parts *)

Section Coordinate.
Variables (p v : R) (t : twofold) (error T : R).
Hypothesis p_binary64 : format p.
Hypothesis v_size : bpow radix2 (-100) <= Rabs v.
Hypothesis t_pair : pair t.
Hypothesis error_least : bpow radix2 (-900) <= error.
Hypothesis t_near : Rabs (T - whole t) <= error.

Let way := rnd (hi t * v).
Let left_of_way := rnd (hi t * v - way).
Let lower := rnd (lo t * v).
Let of_way := rnd (left_of_way + lower).
Let at_p := rnd (way + p).
Let left_of_sum := way + p - at_p.
Let low := rnd (left_of_sum + of_way).

Lemma coordinate_is : coordinate p v t error = Formas.Known (Twofold at_p low)
  (rnd (rnd (Rabs v * error) + rnd (bpow radix2 (-102) * rnd (Rabs way + Rabs p)))).
Proof.
  unfold coordinate; fold way left_of_way lower at_p; rewrite Rplus_0_r, (rnd_format (rnd _)) by apply format_rnd.
  fold of_way; destruct (two_sum_exact way p (format_rnd _) p_binary64) as [_ E].
  unfold whole, two_sum in E; cbn [hi lo] in E; fold at_p in E; unfold low, left_of_sum.
  replace (way + p - at_p) with (rnd (rnd (way - rnd (at_p - rnd (at_p - way))) + rnd (p - rnd (at_p - way)))) by lra.
  reflexivity.
Qed.

(** The error of one rounding, where a is a bound of what is rounded. *)
Lemma lost_of_sum x y a : format x -> format y -> Rabs (x + y) <= a -> Rabs (rnd (x + y) - (x + y)) <= u * a.
Proof.
  intros Fx Fy Ha; apply Rle_trans with (1 := rnd_plus x y Fx Fy); apply Rmult_le_compat_l; [apply bpow_ge_0 | exact Ha].
Qed.
Lemma lost_of_any x a : Rabs x <= a -> Rabs (rnd x - x) <= u * a + tiny.
Proof.
  intros Ha; apply Rle_trans with (1 := rnd_any x); apply Rplus_le_compat_r, Rmult_le_compat_l; [apply bpow_ge_0 | exact Ha].
Qed.
Lemma size_after x y a b : Rabs (x - y) <= a -> Rabs y <= b -> Rabs x <= a + b.
Proof. intros Ha Hb; replace x with ((x - y) + y) by ring; apply Rle_trans with (1 := Rabs_triang _ _); lra. Qed.

(** All that is lost beside the error of the parameter. *)
Lemma coordinate_lost : Rabs (p + whole t * v - whole (Twofold at_p low))
  <= 10 * (u * (u * (Rabs way + Rabs p))) + 4 * tiny.
Proof.
  pose proof (bpow_gt_0 radix2 (-1074)) as Hz; pose proof u_bounds as Hu; set (z := tiny) in *.
  destruct t_pair as (Fh & Fl & Hl); set (h := hi t * v) in *; set (l := lo t * v) in *.
  set (a := Rabs way); set (b := Rabs p); assert (Ha : 0 <= a) by apply Rabs_pos; assert (Hb : 0 <= b) by apply Rabs_pos.
  pose proof (u_part a Ha) as Hua; pose proof (u_part b Hb) as Hub.
  pose proof (u_part _ (proj1 Hua)) as Huua; pose proof (u_part _ (proj1 Hub)) as Huub.
  pose proof (u_part _ (proj1 Huua)) as Huuua; pose proof (u_part _ (proj1 Huub)) as Huuub.
  pose proof (u_part z (Rlt_le _ _ Hz)) as Huz.
  assert (Hh : Rabs h <= (1 + 2 * e12) * a + 2 * z).
  { pose proof (rnd_any h) as Hr; fold way z in Hr; rewrite Rabs_minus_sym in Hr.
    pose proof (size_after h way _ a Hr (Rle_refl _)) as Hs; pose proof (u_part _ (Rabs_pos h)); lra. }
  assert (Hleft : Rabs (h - way) <= u * ((1 + 2 * e12) * a + 2 * z) + z).
  { rewrite Rabs_minus_sym; now apply lost_of_any. }
  assert (Hl' : Rabs l <= u * ((1 + 2 * e12) * a + 2 * z)).
  { unfold l; rewrite Rabs_mult; apply Rle_trans with (u * Rabs (hi t) * Rabs v).
    - apply Rmult_le_compat_r; [apply Rabs_pos | exact Hl].
    - rewrite Rmult_assoc, <- Rabs_mult; apply Rmult_le_compat_l; [lra | exact Hh]. }
  set (g := u * ((1 + 2 * e12) * a + 2 * z)) in *.
  assert (Hg : 0 <= g <= (1 + / 1000) * (u * a) + / 1000 * z) by (unfold g; lra).
  pose proof (u_part g (proj1 Hg)) as Hug.
  assert (Hug' : u * g <= (1 + / 1000) * (u * (u * a)) + / 1000 * z).
  { assert (u * g <= u * ((1 + / 1000) * (u * a) + / 1000 * z)) by (apply Rmult_le_compat_l; lra); lra. }
  pose proof (lost_of_any (h - way) _ Hleft) as E1; fold left_of_way z in E1.
  pose proof (size_after _ _ _ _ E1 Hleft) as S1.
  pose proof (lost_of_any l _ Hl') as E2; fold lower z in E2; pose proof (size_after _ _ _ _ E2 Hl') as S2.
  assert (S3 : Rabs (left_of_way + lower) <= 2 * g + 3 * (u * g) + 4 * z).
  { apply Rle_trans with (1 := Rabs_triang _ _); lra. }
  pose proof (lost_of_sum left_of_way lower _ (format_rnd _) (format_rnd _) S3) as E3; fold of_way in E3.
  pose proof (size_after _ _ _ _ E3 S3) as S4.
  destruct (sum_lacks way p (format_rnd _) p_binary64) as [Fr Hr]; fold at_p in Fr, Hr; fold left_of_sum in Fr, Hr.
  assert (Hat : Rabs at_p <= (1 + e12) * (a + b)).
  { assert (Hab : Rabs (way + p) <= a + b) by apply Rabs_triang.
    pose proof (size_after _ _ _ _ (lost_of_sum way p _ (format_rnd _) p_binary64 Hab) Hab) as Hs; fold at_p in Hs; lra. }
  assert (Hr' : Rabs left_of_sum <= (1 + / 1000) * (u * a) + (1 + / 1000) * (u * b)).
  { apply Rle_trans with (1 := Hr); assert (u * Rabs at_p <= u * ((1 + e12) * (a + b))) by (apply Rmult_le_compat_l; lra); lra. }
  assert (S5 : Rabs (left_of_sum + of_way) <= 4 * (u * a) + 2 * (u * b) + 5 * z).
  { apply Rle_trans with (1 := Rabs_triang _ _).
    assert (u * (2 * g + 3 * (u * g) + 4 * z) <= e12 * (2 * g + 3 * (u * g) + 4 * z)) by (apply Rmult_le_compat_r; lra); lra. }
  pose proof (lost_of_sum left_of_sum of_way _ Fr (format_rnd _) S5) as E5; fold low in E5.
  assert (E3' : u * (2 * g + 3 * (u * g) + 4 * z) <= (2 + / 100) * (u * (u * a)) + / 100 * z).
  { assert (u * (3 * (u * g) + 4 * z) <= e12 * (3 * (u * g) + 4 * z)) by (apply Rmult_le_compat_r; lra); lra. }
  unfold whole at 2; cbn [hi lo].
  replace (p + whole t * v - (at_p + low)) with ((left_of_sum + of_way - low) + (left_of_way + lower - of_way)
    + (h - way - left_of_way) + (l - lower)) by (unfold left_of_sum, whole, h, l; ring).
  apply Rabs_le_inv in E1, E2, E3, E5; apply Rabs_le; lra.
Qed.

Theorem coordinate_near : let c := coordinate p v t error in
  Rabs (p + T * v - whole (Formas.value c)) <= slack * Formas.error c /\ bpow radix2 (-1000) <= Formas.error c
  /\ format (lo (Formas.value c)) /\ format (Formas.error c).
Proof.
  intros c; unfold c; rewrite coordinate_is; cbn [Formas.value Formas.error lo].
  pose proof coordinate_lost as Hlost; pose proof (bpow_gt_0 radix2 (-1000)); pose proof (bpow_gt_0 radix2 (-900)).
  pose proof (bpow_gt_0 radix2 (-1074)) as Hz; set (z := tiny) in *.
  assert (HE : bpow radix2 (-1000) <= Rabs v * error).
  { change (-1000)%Z with (-100 + -900)%Z; rewrite bpow_plus; apply Rmult_le_compat; auto using bpow_ge_0. }
  pose proof (least_below (-1000) _ ltac:(lia) HE) as HzE; fold z in HzE; set (E := Rabs v * error) in *.
  assert (HT : Rabs ((T - whole t) * v) <= E).
  { rewrite Rabs_mult, Rmult_comm; apply Rmult_le_compat_l; [apply Rabs_pos | exact t_near]. }
  assert (E1 : (1 - e12) * E <= rnd E).
  { apply rnd_low; [lra|]; apply (at_least_normal (-1000)); [lia|]; rewrite Rabs_pos_eq; lra. }
  set (s := Rabs way + Rabs p) in *; assert (Hs : 0 <= s) by (unfold s; pose proof (Rabs_pos way); pose proof (Rabs_pos p); lra).
  pose proof (rnd_low_sum (Rabs way) (Rabs p) (generic_format_abs _ _ _ (format_rnd _)) (generic_format_abs _ _ _ p_binary64) Hs)
    as E2; fold s in E2; pose proof (rnd_nonneg s Hs) as Hs'.
  pose proof (u_part _ Hs') as H1; pose proof (u_part _ (proj1 H1)) as H2; pose proof (u_part _ Hs) as H3.
  pose proof (u_part _ (proj1 H3)) as H4.
  assert (E3 : (1 - e12) * (u * (u * s)) <= u * (u * rnd s)).
  { replace ((1 - e12) * (u * (u * s))) with (u * (u * ((1 - e12) * s))) by ring; pose proof u_bounds.
    apply Rmult_le_compat_l; [lra|]; apply Rmult_le_compat_l; lra. }
  assert (H16 : bpow radix2 (-102) * rnd s = 16 * (u * (u * rnd s))) by (rewrite sixteen_u_u; ring).
  pose proof (rnd_low_any (bpow radix2 (-102) * rnd s) ltac:(lra)) as E4; fold z in E4; rewrite H16 in E4 at 1.
  pose proof (rnd_nonneg (bpow radix2 (-102) * rnd s) ltac:(lra)) as H5; pose proof (rnd_nonneg E ltac:(lra)) as H6.
  pose proof (rnd_low_sum (rnd E) (rnd (bpow radix2 (-102) * rnd s)) (format_rnd _) (format_rnd _) ltac:(lra)) as E5.
  split; [|split; [|split; apply format_rnd]].
  - replace (p + T * v - whole (Twofold at_p low)) with ((T - whole t) * v + (p + whole t * v - whole (Twofold at_p low)))
      by ring; apply Rle_trans with (1 := Rabs_triang _ _); lra.
  - apply rnd_ge_bpow; [lia|]; pose proof (rnd_ge_bpow (-1000) E ltac:(lia) HE); lra.
Qed.
End Coordinate.

(** ** A coordinate, and the point, rounded once *)

Theorem round_coordinate_right p v t error T : ordinary p -> ordinary v -> pair t ->
  bpow radix2 (-900) <= error -> Rabs (T - whole t) <= error -> certain (round_coordinate p v t error) = true ->
  rounded (round_coordinate p v t error) = rnd (p + T * v) /\ Rabs (rnd (p + T * v)) < bpow radix2 900.
Proof.
  intros Hp Hv Ht He HT; pose proof (ordinary_size p Hp) as Sp; destruct Hp as [Fp _], Hv as [_ Hv].
  change (round_coordinate p v t error) with (let c := coordinate p v t error in
    let x := round_once (Formas.value c) (Formas.error c) in
    Once (if Req_bool v 0 then rnd (p + 0) else rounded x) (orb (Req_bool v 0) (certain x))); cbv zeta; cbn [certain rounded].
  destruct (Req_bool_spec v 0) as [->|N]; cbn [orb].
  - intros _; rewrite Rmult_0_r, Rplus_0_r, (rnd_format p Fp); split; [reflexivity|].
    apply Rle_lt_trans with (1 := Sp), bpow_lt; lia.
  - destruct Hv as [Z0|[Hv _]]; [contradiction|].
    destruct (coordinate_near p v t error T Fp Hv Ht He HT) as (Hn & Hl & Flo & Fer); now apply round_once_right.
Qed.

(** The recorded point is these. *)
Theorem round_point_is p v t error : let at_t := round_once t error in
  let at_x := round_coordinate (cx p) (cx v) t error in let at_y := round_coordinate (cy p) (cy v) t error in
  let at_z := round_coordinate (cz p) (cz v) t error in
  round_point p v t error = Once_point (rounded at_t) (rounded at_x) (rounded at_y) (rounded at_z)
    (andb (andb (andb (certain at_t) (certain at_x)) (certain at_y)) (certain at_z)).
Proof. reflexivity. Qed.

(** What is stored, as binary64, of the point. *)
Definition stored (x : Limits.binary64) (r : R) : Prop := BinarySingleNaN.is_finite x = true /\ BinarySingleNaN.B2R x = r.
Definition stores (out : Chain.printed) (o : once_point) : Prop :=
  stored (Chain.printed_t out) (of_t o) /\ stored (Chain.printed_x out) (of_x o) /\ stored (Chain.printed_y out) (of_y o)
  /\ stored (Chain.printed_z out) (of_z o).

Lemma stored_once x r s : stored x s -> s = rnd r /\ Rabs (rnd r) < bpow radix2 900 -> Limits.rounded_once x r.
Proof.
  intros [Fx Hx] [-> Hs]; unfold Limits.rounded_once; rewrite Rlt_bool_true; [now split|].
  apply Rlt_trans with (1 := Hs), bpow_lt; lia.
Qed.

(** What is certain is rounded right: the parameter and the point. *)
Theorem certain_is_rounded_right p v t error T out : ordinary_vec p -> ordinary_vec v -> pair t -> format error ->
  bpow radix2 (-900) <= error -> Rabs (T - whole t) <= error -> all_certain (round_point p v t error) = true ->
  stores out (round_point p v t error) ->
  Chain.rounds (Especificacion.mk_Rayo (Especificacion.mk_Punto (cx p) (cy p) (cz p))
    (Especificacion.mk_Vector (cx v) (cy v) (cz v))) out T.
Proof.
  intros (Px & Py & Pz) (Vx & Vy & Vz) Ht Fe He HT; rewrite round_point_is; cbn [all_certain]; rewrite !andb_true_iff.
  intros [[[Ct Cx] Cy] Cz] (St & Sx & Sy & Sz); cbn [of_t of_x of_y of_z] in *.
  pose proof (bpow_gt_0 radix2 (-900)); split; [|split; [|split]].
  - apply (stored_once _ _ _ St), round_once_right; [apply Ht | exact Fe | | lra | exact Ct].
    apply Rle_trans with (2 := He), bpow_le; lia.
  - apply (stored_once _ _ _ Sx); now apply round_coordinate_right.
  - apply (stored_once _ _ _ Sy); now apply round_coordinate_right.
  - apply (stored_once _ _ _ Sz); now apply round_coordinate_right.
Qed.
