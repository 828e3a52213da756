(** * Doubled: what the tracer decides of a quadratic in double-double, and that it is right

    The second step of trace/closed_form-inl.hpp: the decision of Verdict.v over pairs. Formas.Pairs has it as one term of
    f, the computed quadratic; f is within its bounds of an exact one, A t² + 2B t + C with B² - AC = F·H. A leading part is
    its pair rounded once, so that where it is beside a binary64, the whole is there too; the rest is as in binary64, with
    uu in place of u.

    sound2           == f is within its bounds of A, B, C, F and H, and of the magnitudes that the bounds ask for
    near_word r t    == the root r, a pair, is within its error of t
    near_pair r t    == so it is, with room for what is lost where two such are compared
    right_pair T x a == the answer a is right of the parameters T: as Verdict.right_up_to *)
From Coq Require Import Reals ZArith Lra Lia Psatz Bool.
From Flocq Require Import Core Plus_error.
From Durero Require Import Trazador.
From Durero Require Import Rounding Quotient Roots Decision Twofold Sums Products Ratios Words Small.
From Durero Require Formas.
Import Formas.Pairs.
Local Open Scope R_scope.
Local Opaque bpow.

Definition near_word (root : Formas.known twofold) (t : R) : Prop :=
  Rabs (whole (Formas.value root) - t) <= (1 - e12) * Formas.error root /\ double_word (Formas.value root) /\
  format (Formas.error root) /\ bpow radix2 (-900) <= Formas.error root.

Definition near_pair (root : Formas.known twofold) (t : R) : Prop := near_word root t /\
  Rabs (whole (Formas.value root) - t) + uu * Rabs (hi (Formas.value root)) <= (1 - e12) * Formas.error root.

Definition right_pair (T : R -> Prop) (limit : R) (a : Formas.answer twofold) : Prop :=
  match a with
  | Formas.Miss => forall t, T t -> limit < t
  | Formas.Undecided => True
  | Formas.Hit root _ _ => exists t, is_least T t /\ near_pair root t
  end.

Lemma right_pair_equal T T' limit a : (forall t, T t <-> T' t) -> right_pair T limit a -> right_pair T' limit a.
Proof.
  intros E; destruct a as [| | root slope curvature]; cbn [right_pair]; [intros Hm t Ht; now apply Hm, E | auto |].
  intros (t & [Ht Hl] & N); exists t; split; [split; [now apply E | intros t' H'; now apply Hl, E] | exact N].
Qed.

(** ** A quotient of two, each within its error *)

(** What is lost of the quotient itself is slack, besides what is counted, where that is nothing beside x's error. *)
Lemma quotient_near_if slack x X x_error y Y y_error : double_word x -> double_word y -> format x_error -> format y_error ->
  bpow radix2 (-900) <= x_error -> bpow radix2 (-900) * Rabs (hi y) <= x_error ->
  0 <= slack -> slack * Rabs (hi y) <= e12 * x_error ->
  double_word (ratio x y) /\ Rabs (whole (ratio x y) - whole x / whole y) <= uu * Rabs (whole x / whole y) + slack ->
  Rabs (whole x - X) <= x_error -> Rabs (whole y - Y) <= y_error -> 2 * y_error < Rabs (hi y) ->
  near_pair (quotient x x_error y y_error) (X / Y).
Proof.
  intros Wx Wy Fx Fy Hleast Hratio Hslack Hsmall Ht Hx Hy Hbig; unfold near_pair, near_word, quotient.
  cbn [Formas.value Formas.error].
  assert (Hy0 : 0 <= y_error) by (apply Rle_trans with (2 := Hy), Rabs_pos); pose proof uu_bounds as Huu.
  assert (Hy_fl : hi y <> 0) by (intros Z0; rewrite Z0, Rabs_R0 in Hbig; lra).
  set (t := ratio x y) in *; set (T := whole x / whole y) in *; destruct Ht as [Wt Ht].
  destruct (computed_quotient_error (Rabs (hi t)) (bpow radix2 (-100)) x_error (hi y) y_error Fx (proj1 Wy) Fy (Rabs_pos _)
    (bpow_ge_0 _ _) Hleast Hratio Hy0 Hbig) as [HW Hbound].
  set (W := (x_error + Rabs (hi t) * y_error) / _) in *; set (error := rnd (_ + rnd (bpow radix2 (-100) * Rabs (hi t)))) in *.
  pose proof (bpow_gt_0 radix2 (-900)); set (e := e12) in *; assert (He : 0 < e < / 1000000) by (unfold e; lra).
  replace (bpow radix2 (-100)) with (4 * uu) in Hbound by (replace 4 with (bpow radix2 2) by reflexivity; now rewrite <- bpow_plus).
  (* The size of the quotient, and of the exact divisor. *)
  pose proof (Rabs_pos T) as HT0; pose proof (Rabs_pos (hi t)) as Ht0.
  assert (HuT : uu * Rabs T <= e30 * Rabs T) by (apply Rmult_le_compat_r; lra).
  assert (HT : Rabs T <= (1 + 2 * e) * (Rabs (hi t) + slack)).
  { destruct (word_near t Wt) as [_ Hh]; pose proof (u_part _ Ht0) as Hu; fold e in Hu.
    pose proof (size_least (whole t) T); pose proof (size_least (hi t) (whole t)); unfold e in *; lra. }
  set (g := Rabs (hi y) - y_error) in *; assert (Hg : 0 < g) by (unfold g; lra).
  assert (HgY : (1 - 2 * e) * g <= Rabs Y).
  { destruct (word_near y Wy) as [_ Hh]; pose proof (u_part _ (Rabs_pos (hi y))) as Hu; fold e in Hu.
    pose proof (size_least Y (whole y)) as Hl; rewrite Rabs_minus_sym in Hl.
    pose proof (size_least (whole y) (hi y)) as Hl'; rewrite Rabs_minus_sym in Hl'.
    assert (e * Rabs (hi y) <= e * (2 * g)) by (apply Rmult_le_compat_l; unfold g; lra); unfold g in *; lra. }
  assert (HY0 : 0 < Rabs Y) by (assert (0 < (1 - 2 * e) * g) by (apply Rmult_lt_0_compat; lra); lra).
  assert (HY : Y <> 0) by (intros Z0; rewrite Z0, Rabs_R0 in HY0; lra).
  assert (Hwy : whole y <> 0).
  { intros Z0; destruct (word_near y Wy) as [Hh _]; rewrite Z0, Rabs_R0, Rmult_0_r, Rminus_0_r in Hh.
    pose proof (Rabs_pos_lt _ Hy_fl); lra. }
  assert (HWg : W * g = x_error + Rabs (hi t) * y_error) by (unfold W; field; lra).
  assert (HW0 : 0 < W) by lra; assert (HW1 : 0 < W * g) by (apply Rmult_lt_0_compat; lra).
  assert (Hslack_g : slack * g <= e * (W * g)).
  { rewrite HWg; assert (slack * g <= slack * Rabs (hi y)) by (apply Rmult_le_compat_l; unfold g; lra).
    assert (0 <= e * (Rabs (hi t) * y_error)) by (repeat apply Rmult_le_pos; lra); unfold e in *; lra. }
  assert (Hslack_W : slack <= e * W).
  { apply Rmult_le_reg_r with g; [exact Hg|]; now rewrite Rmult_assoc. }
  assert (Hexact : Rabs (T - X / Y) <= (1 + 7 * e) * W).
  { apply Rmult_le_reg_r with ((1 - 2 * e) * g); [apply Rmult_lt_0_compat; lra|].
    apply Rle_trans with (Rabs (T - X / Y) * Rabs Y); [apply Rmult_le_compat_l; [apply Rabs_pos | exact HgY]|].
    rewrite <- Rabs_mult; replace ((T - X / Y) * Y) with ((whole x - X) + T * (Y - whole y)) by (unfold T; field; auto).
    apply Rle_trans with (1 := Rabs_triang _ _); rewrite Rabs_mult, (Rabs_minus_sym Y).
    assert (Rabs T * Rabs (whole y - Y) <= (1 + 2 * e) * (Rabs (hi t) + slack) * y_error)
      by (apply Rmult_le_compat; auto using Rabs_pos).
    assert (slack * y_error <= slack * g) by (apply Rmult_le_compat_l; unfold g; lra).
    apply Rle_trans with ((1 + 2 * e) * (1 + e) * (W * g)).
    - apply Rle_trans with ((1 + 2 * e) * (W * g + slack * g)); [|rewrite Rmult_assoc; apply Rmult_le_compat_l; lra].
      rewrite HWg; assert (0 <= e * x_error) by (apply Rmult_le_pos; [lra | pose proof (bpow_gt_0 radix2 (-900)); lra]).
      assert (0 <= (1 + 2 * e) * (slack * g - slack * y_error)) by (apply Rmult_le_pos; lra); lra.
    - replace ((1 + 7 * e) * W * ((1 - 2 * e) * g)) with ((1 + 7 * e) * (1 - 2 * e) * (W * g)) by ring.
      apply Rmult_le_compat_r; [lra | unfold e; lra]. }
  assert (Hut : 0 <= uu * Rabs (hi t)) by (apply Rmult_le_pos; lra).
  assert (HuT2 : uu * Rabs T <= uu * ((1 + 2 * e) * (Rabs (hi t) + slack))) by (apply Rmult_le_compat_l; lra).
  assert (Hus : uu * slack <= e30 * slack) by (apply Rmult_le_compat_r; lra).
  assert (Heu : e * (uu * Rabs (hi t)) <= / 1000000 * (uu * Rabs (hi t))) by (apply Rmult_le_compat_r; lra).
  enough (Room : Rabs (whole t - X / Y) + uu * Rabs (hi t) <= (1 - e) * error).
  { split; [split; [lra | split; [exact Wt | split; [apply format_rnd | lra]]] | exact Room]. }
  apply Rle_trans with ((1 - e) * ((1 + / 33554432) * W + 3 / 4 * (4 * uu * Rabs (hi t)))); [|apply Rmult_le_compat_l; lra].
  apply Rle_trans with (Rabs (whole t - T) + Rabs (T - X / Y) + uu * Rabs (hi t)); [apply Rplus_le_compat_r|].
  { replace (whole t - X / Y) with ((whole t - T) + (T - X / Y)) by ring; apply Rabs_triang. }
  unfold e in *; lra.
Qed.

Lemma ratio_of_nothing x y : double_word x -> hi x = 0 ->
  double_word (ratio x y) /\ Rabs (whole (ratio x y) - whole x / whole y) <= uu * Rabs (whole x / whole y) + 0.
Proof.
  intros Wx Z0; rewrite (ratio_of_zero x y Wx Z0); destruct (double_word_is_pair x Wx) as (_ & _ & L).
  rewrite Z0, Rabs_R0, Rmult_0_r in L; pose proof uu_bounds; assert (ZT : whole x / whole y = 0).
  { unfold Rdiv, whole at 1; rewrite Z0; destruct (Req_dec (lo x) 0) as [->|Nl]; [ring | pose proof (Rabs_pos_lt _ Nl); lra]. }
  rewrite ZT; unfold double_word, whole; cbn [hi lo]; rewrite Rplus_0_r, rnd_0, Rminus_0_r, Rabs_R0.
  repeat split; try apply generic_format_0; lra.
Qed.

Theorem quotient_near_any x X x_error y Y y_error : double_word x -> double_word y -> format x_error -> format y_error ->
  bpow radix2 (-900) <= x_error -> bpow radix2 (-900) * Rabs (hi y) <= x_error ->
  hi x = 0 \/ bpow radix2 (-900) <= Rabs (hi x) /\ bpow radix2 (-900) * Rabs (hi y) <= Rabs (hi x) ->
  Rabs (whole x - X) <= x_error -> Rabs (whole y - Y) <= y_error -> 2 * y_error < Rabs (hi y) ->
  near_pair (quotient x x_error y y_error) (X / Y).
Proof.
  intros Wx Wy Fx Fy Hleast Hratio Sx Hx Hy Hbig; assert (Hy0 : 0 <= y_error) by (apply Rle_trans with (2 := Hy), Rabs_pos).
  assert (Hy_fl : hi y <> 0) by (intros Z0; rewrite Z0, Rabs_R0 in Hbig; lra).
  pose proof (bpow_gt_0 radix2 (-900)); apply (quotient_near_if 0); auto; [lra | lra|].
  destruct Sx as [Z0|[Sx1 Sx2]]; [now apply ratio_of_nothing|]; rewrite Rplus_0_r; apply ratio_near; auto.
  pose proof (Rabs_pos_lt _ Hy_fl); unfold Rdiv; rewrite Rabs_mult, Rabs_inv.
  apply Rmult_le_reg_r with (Rabs (hi y)); [lra|]; rewrite Rmult_assoc, Rinv_l, Rmult_1_r by lra; exact Sx2.
Qed.

(** Whatever underflows in the quotient. *)
Definition sizeable (x : twofold) : Prop := hi x = 0 \/ bpow radix2 (-912) <= Rabs (hi x).

Lemma sizeable_on_grid k x : (-912 <= k)%Z -> parts_on k x -> sizeable x.
Proof.
  intros Hk [G _]; destruct (Req_dec (hi x) 0) as [Z0|N]; [now left | right].
  apply Rle_trans with (2 := grid_at_least _ _ G N); now apply bpow_le.
Qed.

Theorem quotient_near x X x_error y Y y_error : double_word x -> double_word y -> format x_error -> format y_error ->
  bpow radix2 (-360) <= x_error -> sizeable x -> Rabs (whole x - X) <= x_error -> Rabs (whole y - Y) <= y_error ->
  2 * y_error < Rabs (hi y) <= bpow radix2 450 -> near_pair (quotient x x_error y y_error) (X / Y).
Proof.
  intros Wx Wy Fx Fy Hleast Sx Hx Hy [Hbig Hlarge].
  assert (Hy450 : bpow radix2 (-900) * Rabs (hi y) <= bpow radix2 (-450)).
  { change (-450)%Z with (-900 + 450)%Z; rewrite bpow_plus; apply Rmult_le_compat_l; [apply bpow_ge_0 | exact Hlarge]. }
  assert (Hx900 : bpow radix2 (-900) <= x_error) by (apply Rle_trans with (2 := Hleast), bpow_le; lia).
  assert (Hxy900 : bpow radix2 (-900) * Rabs (hi y) <= x_error).
  { apply Rle_trans with (1 := Hy450), Rle_trans with (2 := Hleast), bpow_le; lia. }
  destruct Sx as [Z0|Sx]; [apply quotient_near_any; auto|].
  destruct (Rle_lt_dec (bpow radix2 (-450)) (Rabs (hi x))) as [Hbig_x|Hsmall_x].
  { apply quotient_near_any; auto; right; split; apply Rle_trans with (2 := Hbig_x); [apply bpow_le; lia|].
    apply Rle_trans with (1 := Hy450), bpow_le; lia. }
  assert (Hy0 : 0 <= y_error) by (apply Rle_trans with (2 := Hy), Rabs_pos).
  assert (Hy_fl : hi y <> 0) by (intros N; rewrite N, Rabs_R0 in Hbig; lra); pose proof (Rabs_pos_lt _ Hy_fl) as Hyp.
  destruct (ratio_any x y Wx Wy Sx Hy_fl) as [Wt St]; set (Q := Rabs (hi x / hi y)) in *; pose proof uu_bounds as Huu.
  assert (EQ : Q * Rabs (hi y) = Rabs (hi x)) by (unfold Q; rewrite <- Rabs_mult; f_equal; field; exact Hy_fl).
  pose proof (bpow_gt_0 radix2 (-1074)) as Hz; assert (HQ0 : 0 <= Q) by apply Rabs_pos.
  assert (HT : Rabs (whole x / whole y) <= 2 * Q).
  { destruct (word_near x Wx) as [_ Nx], (word_near y Wy) as [_ Ny]; pose proof (u_part _ (Rabs_pos (hi x))).
    pose proof (u_part _ (Rabs_pos (hi y))); rewrite Rabs_minus_sym in Nx; pose proof (size_near _ _ _ _ Nx (Rle_refl _)).
    pose proof (size_least (whole y) (hi y)); rewrite Rabs_minus_sym in Ny; assert (Hwy : 0 < Rabs (whole y)) by lra.
    unfold Rdiv; rewrite Rabs_mult, Rabs_inv; apply Rmult_le_reg_r with (Rabs (whole y)); [exact Hwy|].
    rewrite Rmult_assoc, Rinv_l, Rmult_1_r by lra.
    assert (Q * ((1 - / 1000) * Rabs (hi y)) <= Q * Rabs (whole y)) by (apply Rmult_le_compat_l; lra); lra. }
  apply (quotient_near_if (6 * Q + 4 * tiny)); auto; [lra | | split; [exact Wt|]].
  - rewrite Rmult_plus_distr_r, !Rmult_assoc, EQ.
    assert (Hz450 : tiny * Rabs (hi y) <= bpow radix2 (-624)).
    { change (-624)%Z with (-1074 + 450)%Z; rewrite bpow_plus; apply Rmult_le_compat_l; [apply bpow_ge_0 | exact Hlarge]. }
    assert (H624 : bpow radix2 (-624) <= bpow radix2 (-450)) by (apply bpow_le; lia).
    assert (H450 : 10 * bpow radix2 (-450) <= e12 * bpow radix2 (-360)).
    { pose proof (bpow_gt_0 radix2 (-360)); change (-450)%Z with (-90 + -360)%Z; rewrite bpow_plus.
      replace (bpow radix2 (-90)) with (/ 1237940039285380274899124224) by reflexivity; lra. }
    lra.
  - pose proof (Rabs_triang (whole (ratio x y)) (- (whole x / whole y))) as Ht; rewrite Rabs_Ropp in Ht.
    fold (whole (ratio x y) - whole x / whole y) in Ht.
    pose proof (Rmult_le_pos uu _ ltac:(lra) (Rabs_pos (whole x / whole y))); lra.
Qed.

(** A pair beyond a limit. *)
Lemma beyond_pair root limit t : near_word root t -> format limit -> beyond root limit = true -> limit < t.
Proof.
  intros (N & W & Fe & Hl) Fl; unfold beyond; destruct (exactly_word limit Fl) as [We Ee].
  destruct (difference_near _ _ W We) as [Wd Hd]; rewrite Ee in Hd; set (d := difference _ _) in *.
  set (gap := whole (Formas.value root) - limit) in *.
  destruct (Rlt_bool_spec (Formas.error root) (hi d)) as [Hlt|]; [intros _ | discriminate].
  apply (word_above d _ Wd Fe) in Hlt; pose proof (bpow_gt_0 radix2 (-900)).
  pose proof (u_part _ (Rabs_pos gap)) as Hu; pose proof (u_part _ (proj1 Hu)) as Huu.
  assert (Hgap : 0 < gap).
  { apply Rnot_le_lt; intros Hle; rewrite (Rabs_left1 gap) in Hd, Hu, Huu by lra; apply Rabs_le_inv in Hd; lra. }
  rewrite (Rabs_pos_eq gap) in Hd, Hu, Huu by lra; apply Rabs_le_inv in Hd, N; unfold gap in *; lra.
Qed.

Section Turn.
Variable place : Formas.known twofold -> Formas.placed.
Variables (limit : R) (curvature : Formas.known R).
Hypothesis limit_binary64 : format limit.

Definition turn (root : Formas.known twofold) (slope : Formas.known R) (next : Formas.answer twofold) : Formas.answer twofold :=
  if beyond root limit then Formas.Miss
  else if Formas.inside (place root) then Formas.Hit root slope curvature
  else if Formas.outside (place root) then next
  else Formas.Undecided.

Lemma turn_right (T on : R -> Prop) root slope next t : near_pair root t ->
  (Formas.outside (place root) = true -> ~ on t) -> (Formas.inside (place root) = true -> on t) ->
  (on t -> is_least T t) -> (limit < t -> forall t', T t' -> limit < t') -> (~ on t -> right_pair T limit next) ->
  right_pair T limit (turn root slope next).
Proof.
  intros N Hout Hin Hleast Hbeyond Hnext; unfold turn.
  destruct (beyond root limit) eqn:E; [cbn; now apply Hbeyond, (beyond_pair root _ _ (proj1 N))|].
  destruct (Formas.inside (place root)); [cbn; exists t; split; [now apply Hleast, Hin | exact N]|].
  destruct (Formas.outside (place root)); [now apply Hnext, Hout | exact I].
Qed.
End Turn.

(** Where the element is all of its surface, a place is the sign of the parameter. *)
Definition places (on : R -> Prop) (place : Formas.known twofold -> Formas.placed) : Prop :=
  forall root t, near_word root t ->
  (Formas.outside (place root) = true -> ~ on t) /\ (Formas.inside (place root) = true -> on t).

Lemma place_right f : places (fun t => 0 < t) (place f).
Proof.
  intros root t (N & W & Fe & Hl); unfold place; cbn [Formas.outside Formas.inside]; apply Rabs_le_inv in N.
  pose proof (bpow_gt_0 radix2 (-900)); split; intros H0.
  - destruct (Rlt_bool_spec (hi (Formas.value root)) (- Formas.error root)) as [Hlt|]; [|discriminate].
    apply (word_below _ _ W (generic_format_opp _ _ _ Fe)) in Hlt; lra.
  - destruct (Rlt_bool_spec (Formas.error root) (hi (Formas.value root))) as [Hlt|]; [|discriminate].
    apply (word_above _ _ W Fe) in Hlt; lra.
Qed.

(** Twice a sum is rounded to twice what it is rounded to. *)
Lemma rnd_twice a b : format a -> format b -> rnd (2 * (a + b)) = 2 * rnd (a + b).
Proof.
  intros Fa Fb; destruct (Req_dec (rnd (a + b)) (a + b)) as [E|N].
  { rewrite E; apply rnd_double; rewrite <- E; apply format_rnd. }
  assert (Hbig : bpow radix2 (-1021) < Rabs (a + b)).
  { apply Rnot_le_lt; intros H; apply N, rnd_format, FLT_format_plus_small; auto with typeclass_instances; reflexivity. }
  set (w := a + b) in *; assert (Nw : w <> 0).
  { intros Z0; rewrite Z0, Rabs_R0 in Hbig; pose proof (bpow_gt_0 radix2 (-1021)); lra. }
  assert (Hm : (-1020 <= mag radix2 w)%Z).
  { pose proof (mag_ge_bpow radix2 w (-1020)) as H; change (-1020 - 1)%Z with (-1021)%Z in H; apply H; lra. }
  assert (Hc : cexp radix2 fexp (w * bpow radix2 1) = (cexp radix2 fexp w + 1)%Z).
  { unfold cexp, FLT_exp; rewrite mag_mult_bpow by exact Nw; lia. }
  replace (2 * w) with (w * bpow radix2 1) by (replace (bpow radix2 1) with 2 by reflexivity; ring).
  unfold round, F2R; cbn [Fnum Fexp]; unfold scaled_mantissa; rewrite Hc.
  replace (w * bpow radix2 1 * bpow radix2 (- (cexp radix2 fexp w + 1))) with (w * bpow radix2 (- cexp radix2 fexp w)).
  - rewrite bpow_plus; replace (bpow radix2 1) with 2 by reflexivity; ring.
  - rewrite Rmult_assoc, <- bpow_plus; do 2 f_equal; ring.
Qed.

Lemma sum_of_self x : double_word x -> sum x x = Twofold (2 * hi x) (2 * lo x).
Proof.
  intros (Fh & Fl & E); assert (E2 : forall a, format a -> two_sum a a = Twofold (2 * a) 0).
  { intros a Fa; rewrite two_sum_is by assumption; replace (a + a) with (2 * a) by ring; rewrite rnd_double by assumption.
    f_equal; ring. }
  change (sum x x) with (let high := two_sum (hi x) (hi x) in let low := two_sum (lo x) (lo x) in
    let z := fast_two_sum (hi high) (rnd (lo high + hi low)) in fast_two_sum (hi z) (rnd (lo low + lo z))).
  rewrite !E2 by assumption; cbv zeta; cbn [hi lo]; rewrite Rplus_0_l.
  assert (F2 : forall a, format a -> format (2 * a)) by (intros a Fa; rewrite <- (rnd_double a Fa); apply format_rnd).
  assert (Ef : fast_two_sum (2 * hi x) (2 * lo x) = Twofold (2 * hi x) (2 * lo x)).
  { assert (Es : rnd (2 * hi x + 2 * lo x) = 2 * hi x).
    { rewrite <- Rmult_plus_distr_l, (rnd_twice _ _ Fh Fl); f_equal; symmetry; exact E. }
    unfold fast_two_sum; rewrite Es; replace (2 * hi x - 2 * hi x) with 0 by ring.
    now rewrite rnd_0, Rminus_0_r, (rnd_format (2 * lo x)) by auto. }
  rewrite (rnd_format (2 * lo x)) by auto; rewrite Ef; cbn [hi lo]; rewrite Rplus_0_l, (rnd_format (2 * lo x)) by auto; exact Ef.
Qed.
