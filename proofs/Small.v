(** * Small: products, quotients and square roots of double-doubles where parts of them underflow

    Across an axis, and of lengths there, so much may cancel that squares of what is left underflow. What is returned is a
    double-double all the same, its first part the whole rounded once, and so small that the bounds do not notice.

    norm2_any == the computed length of any vector of double-doubles *)
From Coq Require Import Reals ZArith Lra Lia Psatz.
From Flocq Require Import Core.
From Durero Require Import Rounding Vectors Twofold Sums Products Ratios Words.
From Durero Require Formas.
Import Formas.Pairs.
Local Open Scope R_scope.
Local Opaque bpow.

Local Instance prec53 : Prec_gt_0 53 := eq_refl.
Notation least_normal := (bpow radix2 (-1022)).

(** ** What is left of a rounding there *)

Lemma half_of_tiny : bpow radix2 (-1075) = / 2 * tiny.
Proof. change (-1075)%Z with (-1 + -1074)%Z; rewrite bpow_plus; reflexivity. Qed.

Lemma rnd_vanishes x : Rabs x <= bpow radix2 (-1075) -> rnd x = 0.
Proof.
  assert (Pos : forall y, 0 <= y <= bpow radix2 (-1075) -> rnd y = 0).
  { intros y Hy; pose proof half_of_tiny as Half; pose proof (bpow_gt_0 radix2 (-1074)) as Hz.
    destruct (Req_dec y 0) as [->|N]; [apply rnd_0|].
    assert (Hm : (mag radix2 y <= -1074)%Z) by (apply mag_le_bpow; [exact N | rewrite Rabs_pos_eq; lra]).
    assert (Hc : cexp radix2 fexp y = (-1074)%Z) by (unfold cexp, FLT_exp; lia).
    unfold round, F2R, scaled_mantissa; cbn [Fnum Fexp]; rewrite Hc; change (- (-1074))%Z with 1074%Z.
    assert (Hs : 0 <= y * bpow radix2 1074 <= / 2).
    { split; [apply Rmult_le_pos; [lra | apply bpow_ge_0]|].
      replace (/ 2) with (bpow radix2 (-1075) * bpow radix2 1074) by (rewrite <- bpow_plus; reflexivity).
      apply Rmult_le_compat_r; [apply bpow_ge_0 | lra]. }
    set (m := y * bpow radix2 1074) in *; replace (ZnearestE m) with 0%Z; [ring|]; symmetry.
    assert (Hf : Zfloor m = 0%Z) by (apply Zfloor_imp; simpl; lra).
    unfold Znearest; rewrite Hf, Rminus_0_r; destruct (Rcompare_spec m (/ 2)); [reflexivity | reflexivity | lra]. }
  intros Hx; apply Rabs_le_inv in Hx; destruct (Rle_lt_dec 0 x) as [H|H]; [apply Pos; lra|].
  replace x with (- - x) by ring; rewrite rnd_opp, (Pos (- x)) by lra; ring.
Qed.

Lemma rnd_below e x : (-1074 <= e)%Z -> Rabs x <= bpow radix2 e -> Rabs (rnd x) <= bpow radix2 e.
Proof.
  intros He Hx; pose proof (rnd_format _ (format_bpow e He)) as Hf; apply Rabs_le_inv in Hx; apply Rabs_le.
  split; [rewrite <- Hf, <- rnd_opp | rewrite <- Hf]; apply rnd_le; lra.
Qed.

Lemma rnd_within x a : format a -> Rabs x <= Rabs a -> Rabs (rnd x) <= Rabs a.
Proof.
  intros Fa Hx; pose proof (rnd_format _ (generic_format_abs _ _ _ Fa)) as Hf; apply Rabs_le_inv in Hx; apply Rabs_le.
  split; [rewrite <- Hf, <- rnd_opp | rewrite <- Hf]; apply rnd_le; lra.
Qed.

(** The error of a rounding: half of the least number below the normal ones, and u above. *)
Lemma lost_below x : Rabs x < least_normal -> Rabs (rnd x - x) <= bpow radix2 (-1075).
Proof.
  intros Hx; pose proof (error_le_half_ulp radix2 fexp (fun n => negb (Z.even n)) x) as H; rewrite half_of_tiny.
  rewrite ulp_FLT_small in H; [exact H | exact eq_refl|].
  apply Rlt_le_trans with (1 := Hx), bpow_le; lia.
Qed.

Lemma tiny_in x : least_normal <= x -> tiny <= 2 * (u * x).
Proof.
  intros Hx; replace tiny with (2 * (u * least_normal)).
  - pose proof u_bounds; repeat (apply Rmult_le_compat_l; [lra|]); exact Hx.
  - replace 2 with (bpow radix2 1) by reflexivity; now rewrite <- !bpow_plus.
Qed.

(** ** Products *)

Lemma product_small x y : double_word x -> double_word y -> Rabs (hi x * hi y) < bpow radix2 (-960) ->
  double_word (product x y) /\ Rabs (whole (product x y)) <= bpow radix2 (-959).
Proof.
  intros Wx Wy HP; destruct (double_word_is_pair x Wx) as (Fhx & Flx & Lx), (double_word_is_pair y Wy) as (Fhy & Fly & Ly).
  set (P := Rabs (hi x * hi y)) in *; set (top := rnd (hi x * hi y)).
  set (c1 := rnd (hi x * lo y)); set (c2 := rnd (lo x * hi y)); set (c4 := rnd (lo x * lo y)); set (c3 := rnd (c1 + c2)).
  set (rest := rnd (hi x * hi y - top)); set (c5 := rnd (c4 + c3)); set (low := rnd (rest + c5)).
  change (product x y) with (fast_two_sum top low); pose proof u_bounds as Hu.
  assert (HPxy : Rabs (hi x) * Rabs (hi y) = P) by (unfold P; now rewrite Rabs_mult).
  assert (B1 : Rabs (hi x * lo y) <= u * P).
  { rewrite Rabs_mult, <- HPxy; replace (u * (Rabs (hi x) * Rabs (hi y))) with (Rabs (hi x) * (u * Rabs (hi y))) by ring.
    apply Rmult_le_compat_l; [apply Rabs_pos | exact Ly]. }
  assert (B2 : Rabs (lo x * hi y) <= u * P).
  { rewrite Rabs_mult, <- HPxy, <- Rmult_assoc; apply Rmult_le_compat_r; [apply Rabs_pos | exact Lx]. }
  assert (HP0 : 0 <= P) by apply Rabs_pos; pose proof (u_part P HP0) as HuP.
  assert (B4 : Rabs (lo x * lo y) <= u * P).
  { rewrite Rabs_mult, <- HPxy, <- Rmult_assoc; apply Rmult_le_compat; [apply Rabs_pos | apply Rabs_pos | exact Lx|].
    pose proof (u_part _ (Rabs_pos (hi y))); lra. }
  assert (Htop : Rabs top <= bpow radix2 (-960)) by (apply rnd_below; [lia | fold P; lra]).
  assert (Hlow : Rabs low <= Rabs top \/ top = 0 /\ Rabs low <= tiny).
  { destruct (Rlt_le_dec P least_normal) as [Hs|Hn].
    - assert (HuP' : u * P <= bpow radix2 (-1075)).
      { change (-1075)%Z with (-53 + -1022)%Z; rewrite bpow_plus; apply Rmult_le_compat_l; lra. }
      assert (Z1 : c1 = 0) by (apply rnd_vanishes; lra); assert (Z2 : c2 = 0) by (apply rnd_vanishes; lra).
      assert (Z4 : c4 = 0) by (apply rnd_vanishes; lra).
      assert (Zr : rest = 0) by (apply rnd_vanishes; rewrite Rabs_minus_sym; now apply lost_below).
      left; unfold low, c5, c3; rewrite Z1, Z2, Z4, Zr; repeat (rewrite ?Rplus_0_r, ?rnd_0); rewrite Rabs_R0;
        apply Rabs_pos.
    - left; pose proof (tiny_in P Hn) as Hz; set (z := tiny) in *; pose proof (bpow_gt_0 radix2 (-1074) : 0 < z) as Hz0.
      assert (Any : forall t m, Rabs t <= m * (u * P) -> 0 <= m <= 1000 -> Rabs (rnd t) <= (m + 3) * (u * P)).
      { intros t m Ht Hm; pose proof (rnd_any t) as Hr; fold z in Hr; pose proof (u_part _ (Rabs_pos t)).
        pose proof (size_near _ _ _ _ Hr (Rle_refl _)).
        assert (m * (u * P) <= 1000 * (u * P)) by (apply Rmult_le_compat_r; lra); lra. }
      assert (Both : forall s t m n, Rabs s <= m * (u * P) -> Rabs t <= n * (u * P) -> Rabs (s + t) <= (m + n) * (u * P)).
      { intros s t m n Hs Ht; apply Rle_trans with (1 := Rabs_triang _ _); lra. }
      pose proof (Any _ 1 ltac:(rewrite Rmult_1_l; exact B1) ltac:(lra)) as S1; fold c1 in S1.
      pose proof (Any _ 1 ltac:(rewrite Rmult_1_l; exact B2) ltac:(lra)) as S2; fold c2 in S2.
      pose proof (Any _ 1 ltac:(rewrite Rmult_1_l; exact B4) ltac:(lra)) as S4; fold c4 in S4.
      pose proof (Any _ _ (Both _ _ _ _ S1 S2) ltac:(lra)) as S3; fold c3 in S3.
      pose proof (Any _ _ (Both _ _ _ _ S4 S3) ltac:(lra)) as S5; fold c5 in S5.
      assert (Hr0 : Rabs (top - hi x * hi y) <= u * P) by (apply rnd_rel; right; exact Hn).
      pose proof (Any (hi x * hi y - top) 1 ltac:(rewrite Rmult_1_l, Rabs_minus_sym; exact Hr0) ltac:(lra)) as Sr;
        fold rest in Sr.
      pose proof (Any _ _ (Both _ _ _ _ Sr S5) ltac:(lra)) as S6; fold low in S6.
      pose proof (size_least top (hi x * hi y)) as Hl; fold P in Hl; lra. }
  assert (Hroom : top = 0 \/ Rabs low <= Rabs top) by tauto.
  destruct (fast_two_sum_exact top low (format_rnd _) (format_rnd _) Hroom) as [_ Hw].
  split; [now apply (fast_two_sum_word top low (format_rnd _) (format_rnd _))|]; rewrite Hw.
  assert (Hz : tiny <= bpow radix2 (-960)) by (apply bpow_le; lia).
  apply Rle_trans with (1 := Rabs_triang _ _); change (-959)%Z with (1 + -960)%Z; rewrite bpow_plus.
  replace (bpow radix2 1) with 2 by reflexivity; destruct Hlow as [H|[_ H]]; lra.
Qed.

(** A product, whatever underflows. *)
Lemma product_any x y : double_word x -> double_word y -> double_word (product x y) /\
  Rabs (whole (product x y) - whole x * whole y) <= uu * Rabs (whole x * whole y) + bpow radix2 (-957).
Proof.
  intros Wx Wy; pose proof uu_bounds; pose proof (Rmult_le_pos uu _ ltac:(lra) (Rabs_pos (whole x * whole y))).
  destruct (Rlt_le_dec (Rabs (hi x * hi y)) (bpow radix2 (-960))) as [Hs|Hb].
  - destruct (product_small x y Wx Wy Hs) as [W H1]; split; [exact W|].
    assert (Hxy : Rabs (whole x * whole y) <= bpow radix2 (-959)).
    { change (-959)%Z with (1 + -960)%Z; rewrite bpow_plus; replace (bpow radix2 1) with 2 by reflexivity.
      apply Rle_trans with (2 * Rabs (hi x * hi y)); [|lra]; rewrite !Rabs_mult.
      destruct (word_near x Wx) as [_ Nx], (word_near y Wy) as [_ Ny].
      pose proof (u_part _ (Rabs_pos (hi x))); pose proof (u_part _ (Rabs_pos (hi y))).
      rewrite Rabs_minus_sym in Nx, Ny; pose proof (size_near _ _ _ _ Nx (Rle_refl _)).
      pose proof (size_near _ _ _ _ Ny (Rle_refl _)); pose proof (Rabs_pos (hi x)); pose proof (Rabs_pos (hi y)).
      apply Rle_trans with (14 / 10 * Rabs (hi x) * (14 / 10 * Rabs (hi y))).
      - apply Rmult_le_compat; try apply Rabs_pos; lra.
      - pose proof (Rmult_le_pos _ _ (Rabs_pos (hi x)) (Rabs_pos (hi y))); lra. }
    assert (bpow radix2 (-957) = 4 * bpow radix2 (-959)).
    { replace 4 with (bpow radix2 2) by reflexivity; now rewrite <- bpow_plus. }
    apply Rabs_le_inv in H1, Hxy; pose proof (bpow_gt_0 radix2 (-959)); apply Rle_trans with (bpow radix2 (-957)); [|lra].
    apply Rabs_le; lra.
  - destruct (product_near x y Wx Wy (or_intror Hb)) as [W Hn]; split; [exact W|]; pose proof (bpow_ge_0 radix2 (-957));
    lra.
Qed.

(** ** Quotients *)

Lemma ratio_any x y : double_word x -> double_word y -> bpow radix2 (-912) <= Rabs (hi x) -> hi y <> 0 ->
  double_word (ratio x y) /\ Rabs (whole (ratio x y)) <= 4 * Rabs (hi x / hi y) + 4 * tiny.
Proof.
  intros Wx Wy Hx Hy; destruct (double_word_is_pair x Wx) as (Fhx & Flx & Lx), (double_word_is_pair y Wy) as
    (Fhy & Fly & Ly).
  rewrite ratio_is; set (high := rnd (hi x / hi y)); set (rest := difference x (product_by y high)).
  set (low := rnd (hi rest / hi y)); set (Q := Rabs (hi x / hi y)); set (X := Rabs (hi x)) in *.
  pose proof (Rabs_pos_lt _ Hy) as Hy0; pose proof (bpow_gt_0 radix2 (-1074)) as Hz.
  assert (HQ0 : 0 <= Q) by apply Rabs_pos; assert (HX0 : 0 <= X) by apply Rabs_pos; pose proof (u_part X HX0) as HuX.
  pose proof (u_part Q HQ0) as HuQ; pose proof (rnd_any (hi x / hi y)) as Hhigh; fold high Q in Hhigh.
  apply (fun H => size_near _ _ _ Q H (Rle_refl _)) in Hhigh.
  assert (By : forall z a, Rabs z <= a * Rabs (hi y) -> Rabs (z / hi y) <= a).
  { intros z a Hza; unfold Rdiv; rewrite Rabs_mult, Rabs_inv; apply Rmult_le_reg_r with (Rabs (hi y)); [exact Hy0|].
    rewrite Rmult_assoc, Rinv_l, Rmult_1_r by lra; exact Hza. }
  assert (HXy : X = Q * Rabs (hi y)) by (unfold X, Q; rewrite <- Rabs_mult; f_equal; field; exact Hy).
  assert (Hdone : high = 0 \/ Rabs low <= Rabs high -> Rabs low <= 2 * Q + 2 * tiny ->
    double_word (fast_two_sum high low) /\ Rabs (whole (fast_two_sum high low)) <= 4 * Q + 4 * tiny).
  { intros Hroom Hl; destruct (fast_two_sum_exact high low (format_rnd _) (format_rnd _) Hroom) as [_ Hw].
    split; [now apply (fast_two_sum_word high low (format_rnd _) (format_rnd _))|]; rewrite Hw.
    apply Rle_trans with (1 := Rabs_triang _ _); lra. }
  destruct (Req_dec high 0) as [Z0|N].
  - apply Hdone; [now left|]; assert (Em : product_by y high = Twofold 0 0).
    { rewrite Z0; unfold product_by, two_prod; cbn [hi lo].
      repeat (rewrite ?Rmult_0_r, ?Rplus_0_r, ?Rminus_0_r, ?rnd_0); exact fast_of_zeros. }
    assert (W0 : double_word (Twofold 0 0) /\ whole (Twofold 0 0) = 0) by now apply exactly_word, generic_format_0.
    destruct W0 as [W0 E0]; destruct (difference_near x (Twofold 0 0) Wx W0) as [Wr Hr].
    rewrite <- Em in Wr, Hr at 1; rewrite E0, Rminus_0_r in Hr; fold rest in Wr, Hr; apply six_in_uu in Hr;
      pose proof uu_bounds.
    destruct (word_near x Wx) as [_ Nx], (word_near _ Wr) as [Nr _]; rewrite Rabs_minus_sym in Nx; fold X in Nx.
    pose proof (size_near _ _ _ X Nx (Rle_refl _)) as Sx; pose proof (Rabs_pos (whole x)) as Hwx.
    assert (uu * Rabs (whole x) <= e30 * Rabs (whole x)) by (apply Rmult_le_compat_r; lra).
    pose proof (size_near _ _ _ _ Hr (Rle_refl _)); pose proof (u_part _ (Rabs_pos (whole rest))).
    pose proof (size_near _ _ _ _ Nr (Rle_refl _)); assert (Hrest : Rabs (hi rest / hi y) <= (1 + / 100) * Q) by (apply By;
      lra).
    pose proof (rnd_any (hi rest / hi y)) as Hl; fold low in Hl; pose proof (u_part _ (Rabs_pos (hi rest / hi y))).
    pose proof (size_near _ _ _ _ Hl (Rle_refl _)); lra.
  - assert (Hq : Rabs (high - hi x / hi y) <= / 2 * Rabs high).
    { destruct (Rlt_le_dec Q least_normal) as [Hs|Hn].
      - apply Rle_trans with (1 := lost_below _ Hs); rewrite half_of_tiny; apply Rmult_le_compat_l; [lra|].
        destruct (own_grid high (format_rnd _)) as [G He]; apply grid_at_least; [|exact N].
        exact (grid_coarser _ _ _ He G).
      - pose proof (rnd_rel _ (or_intror Hn)) as Hr; fold high Q in Hr; pose proof (size_least high (hi x / hi y)) as Hl.
        fold Q in Hl; lra. }
    set (P := hi y * high); assert (HP : Rabs (P - hi x) <= / 2 * Rabs P).
    { replace (P - hi x) with (hi y * (high - hi x / hi y)) by (unfold P; field; exact Hy).
      unfold P; rewrite !Rabs_mult; replace (/ 2 * (Rabs (hi y) * Rabs high)) with (Rabs (hi y) * (/ 2 * Rabs high))
        by ring.
      apply Rmult_le_compat_l; [lra | exact Hq]. }
    assert (HPX : X <= 3 / 2 * Rabs P) by (pose proof (size_least P (hi x)) as Hl; fold X in Hl; lra).
    assert (Hworthy : bpow radix2 (-960) <= Rabs P).
    { apply Rle_trans with (/ 2 * bpow radix2 (-912)); [|lra].
      replace (/ 2) with (bpow radix2 (-1)) by reflexivity; rewrite <- bpow_plus; apply bpow_le; lia. }
    destruct (product_by_near y high Wy (format_rnd _) Hworthy) as [Wm Hm]; fold P in Hm.
    destruct (difference_near x _ Wx Wm) as [Wr Hr]; fold rest in Wr, Hr; apply six_in_uu in Hr;
      pose proof uu_bounds as Huu.
    pose proof (u_part _ (Rabs_pos P)) as HuP; pose proof (u_part _ (proj1 HuP)) as HuuP.
    assert (Hly : Rabs (lo y * high) <= u * Rabs P).
    { unfold P; rewrite !Rabs_mult, <- Rmult_assoc; apply Rmult_le_compat_r; [apply Rabs_pos | exact Ly]. }
    fold X in Lx; set (m := product_by y high) in *; set (R := whole x - whole m) in *.
    assert (HR : Rabs R <= (/ 2 + / 1000) * Rabs P).
    { replace R with ((lo x - lo y * high) - (P - hi x) - (whole m - whole y * high)) by (unfold R, P, whole; ring).
      apply Rabs_le_inv in Hly, Lx, HP, Hm; apply Rabs_le; lra. }
    assert (HuuR : uu * Rabs R <= e30 * Rabs R) by (apply Rmult_le_compat_r; [apply Rabs_pos | lra]).
    pose proof (size_near _ _ _ _ Hr HR); destruct (word_near rest Wr) as [Nr _].
    pose proof (u_part _ (Rabs_pos (whole rest))); pose proof (size_near _ _ _ _ Nr (Rle_refl _)).
    assert (Hlow : Rabs low <= Rabs high).
    { apply rnd_within; [apply format_rnd|]; apply By; rewrite Rmult_comm, <- Rabs_mult; fold P; lra. }
    apply Hdone; [now right | lra].
Qed.

(** ** Square roots *)

(** The leading part of a sum, of which only the sizes are known: a factor for each rounding. *)
Lemma sum_size x y a : format (hi x) -> format (lo x) -> format (hi y) -> format (lo y) ->
  Rabs (hi x + hi y) <= a -> Rabs (lo x + lo y) <= a -> Rabs (hi (sum x y)) <= 600 * a.
Proof.
  intros Fhx Flx Fhy Fly Hh Hl; pose proof (Rabs_pos (hi x + hi y)) as Ha.
  assert (Two : forall s t m, format s -> format t -> Rabs (s + t) <= m -> Rabs (rnd (s + t)) <= 2 * m).
  { intros s t m Fs Ft Hm; pose proof (lost_of_sum s t m Fs Ft Hm) as H1; pose proof (size_near _ _ _ _ H1 Hm).
    pose proof (Rabs_pos (s + t)); pose proof (u_part m ltac:(lra)); lra. }
  assert (Plus : forall s t m n, Rabs s <= m -> Rabs t <= n -> Rabs (s + t) <= m + n).
  { intros s t m n Hs Ht; apply Rle_trans with (1 := Rabs_triang _ _); lra. }
  assert (Minus : forall s t m n, Rabs s <= m -> Rabs t <= n -> Rabs (s - t) <= m + n).
  { intros s t m n Hs Ht; unfold Rminus; apply Plus; [exact Hs | now rewrite Rabs_Ropp]. }
  assert (Fm : forall s t, format t -> format s -> Rabs (rnd (s - t)) <= 2 * (Rabs s + Rabs t)).
  { intros s t Ft Fs; apply Two; auto using generic_format_opp; apply Minus; apply Rle_refl. }
  change (sum x y) with (let high := two_sum (hi x) (hi y) in let low := two_sum (lo x) (lo y) in
    let z := fast_two_sum (hi high) (rnd (lo high + hi low)) in fast_two_sum (hi z) (rnd (lo low + lo z))).
  rewrite !two_sum_is by assumption; cbv zeta; cbn [hi lo]; unfold fast_two_sum; cbn [hi lo].
  destruct (sum_lacks _ _ Fhx Fhy) as [Fs_lost _], (sum_lacks _ _ Flx Fly) as [Ft_lost _].
  pose proof (Two _ _ _ Fhx Fhy Hh) as Ss; pose proof (Two _ _ _ Flx Fly Hl) as St.
  pose proof (Minus _ _ _ _ Hh Ss) as Ss_lost; pose proof (Minus _ _ _ _ Hl St) as St_lost.
  set (s := rnd (hi x + hi y)) in *; set (t := rnd (lo x + lo y)) in *.
  set (s_lost := hi x + hi y - s) in *; set (t_lost := lo x + lo y - t) in *.
  assert (Fs : format s) by apply format_rnd; assert (Ft : format t) by apply format_rnd.
  pose proof (Two _ _ _ Fs_lost Ft (Plus _ _ _ _ Ss_lost St)) as Sc; set (c := rnd (s_lost + t)) in *.
  assert (Fc : format c) by apply format_rnd; pose proof (Two _ _ _ Fs Fc (Plus _ _ _ _ Ss Sc)) as Sv.
  set (v := rnd (s + c)) in *; assert (Fv : format v) by apply format_rnd; pose proof (Fm v s Fs Fv) as Sd.
  set (d := rnd (v - s)) in *; assert (Fd : format d) by apply format_rnd; pose proof (Fm c d Fd Fc) as Se.
  set (e := rnd (c - d)) in *; assert (Fe : format e) by apply format_rnd.
  pose proof (Two _ _ _ Ft_lost Fe (Plus _ _ _ _ St_lost (Rle_refl _))) as Sw; set (w := rnd (t_lost + e)) in *.
  assert (Fw : format w) by apply format_rnd; pose proof (Two _ _ _ Fv Fw (Plus _ _ _ _ Sv (Rle_refl _))); lra.
Qed.

Local Opaque round.
Lemma root_of_is x : let high := rnd (sqrt (hi x)) in
  root_of x = if Rle_bool (hi x) 0 then Twofold 0 0
    else fast_two_sum high (rnd (hi (difference x (two_prod high high)) / rnd (2 * high))).
Proof. reflexivity. Qed.
Local Transparent round.

Lemma root_small x : double_word x -> hi x < bpow radix2 (-920) ->
  double_word (root_of x) /\ 0 <= whole (root_of x) <= bpow radix2 (-458).
Proof.
  intros Wx Hx; destruct (double_word_is_pair x Wx) as (Fhx & Flx & Lx).
  set (high := rnd (sqrt (hi x))); set (m := two_prod high high); set (low := rnd (hi (difference x m) / rnd (2 * high))).
  rewrite root_of_is; fold high; fold m; fold low.
  destruct (Rle_bool_spec (hi x) 0) as [_|Hpos].
  { destruct (exactly_word 0 (generic_format_0 _ _)) as [W0 E0]; unfold exactly in W0, E0; split; [exact W0|].
    rewrite E0; split; [apply Rle_refl | apply bpow_ge_0]. }
  assert (Hleast : tiny <= hi x).
  { destruct (own_grid _ Fhx) as [G He]; pose proof (grid_at_least _ _ (grid_coarser _ _ _ He G) ltac:(lra)) as H.
    rewrite Rabs_pos_eq in H; lra. }
  set (alpha := hi x) in *; set (s := sqrt alpha); rewrite (Rabs_pos_eq alpha) in Lx by lra.
  assert (Hss : s * s = alpha) by (apply sqrt_sqrt; lra).
  assert (Root : forall e y, bpow radix2 (e + e) <= y -> bpow radix2 e <= sqrt y).
  { intros e y Hy; rewrite <- (sqrt_square (bpow radix2 e)) by apply bpow_ge_0; apply sqrt_le_1_alt.
    now rewrite <- bpow_plus. }
  pose proof (Root (-537)%Z alpha Hleast) as Hs0; fold s in Hs0; pose proof (bpow_gt_0 radix2 (-537)) as H537.
  assert (Hs1 : s <= bpow radix2 (-460)).
  { unfold s; rewrite <- (sqrt_square (bpow radix2 (-460))) by apply bpow_ge_0; apply sqrt_le_1_alt.
    rewrite <- bpow_plus; apply Rlt_le, Hx. }
  assert (Hh : Rabs (high - s) <= u * s).
  { rewrite <- (Rabs_pos_eq s) at 2 by lra; apply rnd_rel; right; rewrite Rabs_pos_eq by (fold s; lra).
    apply Rle_trans with (2 := Hs0), bpow_le; lia. }
  assert (Hh537 : bpow radix2 (-537) <= high) by (apply rnd_ge_bpow; [lia | exact Hs0]).
  pose proof (u_part s ltac:(lra)) as HU; apply Rabs_le_inv in Hh; set (P := high * high).
  pose proof (u_part alpha ltac:(lra)) as HuA; pose proof u_bounds as Hu.
  assert (HP : Rabs (P - alpha) <= (2 + / 1000) * (u * alpha)).
  { rewrite <- Hss; unfold P; replace (high * high - s * s) with ((high - s) * (high + s)) by ring.
    rewrite Rabs_mult, (Rabs_pos_eq (high + s)) by lra.
    apply Rle_trans with (u * s * ((2 + / 1000) * s)); [|right; ring].
    apply Rmult_le_compat; [apply Rabs_pos | lra | apply Rabs_le; lra | lra]. }
  assert (HPleast : tiny <= P).
  { change (-1074)%Z with (-537 + -537)%Z; rewrite bpow_plus; apply Rmult_le_compat; lra. }
  enough (Hrest : Rabs (hi (difference x m)) <= 2 * P).
  { assert (Hlow : Rabs low <= Rabs high).
    { apply rnd_within; [apply format_rnd|]; rewrite (rnd_double high) by apply format_rnd.
      unfold Rdiv; rewrite Rabs_mult, Rabs_inv, !(Rabs_pos_eq high), (Rabs_pos_eq (2 * high)) by lra.
      apply Rmult_le_reg_r with (2 * high); [lra|]; rewrite Rmult_assoc, Rinv_l by lra; unfold P in Hrest; lra. }
    destruct (fast_two_sum_exact high low (format_rnd _) (format_rnd _) (or_intror Hlow)) as [_ Hw].
    split; [now apply (fast_two_sum_word high low (format_rnd _) (format_rnd _))|]; rewrite Hw.
    change (-458)%Z with (2 + -460)%Z; rewrite bpow_plus; replace (bpow radix2 2) with 4 by reflexivity.
    rewrite (Rabs_pos_eq high) in Hlow by lra; apply Rabs_le_inv in Hlow; lra. }
  assert (Ha : alpha <= (1 + / 1000) * P) by (apply Rabs_le_inv in HP; lra).
  destruct (Rlt_le_dec P least_normal) as [Hs|Hn].
  - assert (Hlost : Rabs (rnd P - P) <= bpow radix2 (-1075)) by (apply lost_below; rewrite Rabs_pos_eq; lra).
    assert (Em : m = exactly (rnd P)).
    { unfold m, two_prod, exactly; fold P; f_equal; apply rnd_vanishes; now rewrite Rabs_minus_sym. }
    destruct (exactly_word (rnd P) (format_rnd _)) as [Wm Hm]; rewrite Em.
    destruct (difference_near x _ Wx Wm) as [Wr Hr]; apply six_in_uu in Hr; rewrite Hm in Hr.
    set (R := whole x - rnd P) in *; destruct (word_near _ Wr) as [Nr _]; rewrite half_of_tiny in Hlost.
    assert (HR : Rabs R <= (/ 2 + / 100) * tiny + 4 * (u * alpha)).
    { replace R with (lo x - (P - alpha) - (rnd P - P)) by (unfold R, whole; fold alpha; ring).
      pose proof (bpow_gt_0 radix2 (-1074)); apply Rabs_le_inv in Lx, HP, Hlost; apply Rabs_le; lra. }
    pose proof uu_bounds; assert (uu * Rabs R <= e30 * Rabs R) by (apply Rmult_le_compat_r; [apply Rabs_pos | lra]).
    pose proof (size_near _ _ _ _ Hr HR); pose proof (u_part _ (Rabs_pos (whole (difference x (exactly (rnd P)))))).
    pose proof (size_near _ _ _ _ Nr (Rle_refl _)); lra.
  - rewrite difference_is; apply Rle_trans with (600 * (10 * (u * P))).
    + assert (Hr : Rabs (rnd P - P) <= u * P).
      { rewrite <- (Rabs_pos_eq P) at 3 by lra; apply rnd_rel; right; rewrite Rabs_pos_eq; lra. }
      assert (HuP : u * alpha <= u * ((1 + / 1000) * P)) by (apply Rmult_le_compat_l; lra).
      pose proof (u_part P ltac:(lra)) as HuP'; pose proof (u_part _ (proj1 HuP')); pose proof (tiny_in P Hn) as Hz.
      pose proof (rnd_any (P - rnd P)) as Hl; pose proof (u_part _ (Rabs_pos (P - rnd P))).
      rewrite Rabs_minus_sym in Hr; pose proof (size_near _ _ _ _ Hl Hr) as Hlow.
      assert (Fm : format (hi m) /\ format (lo m)) by (split; apply format_rnd).
      destruct Fm; apply sum_size; cbn [hi lo opposite]; auto using generic_format_opp.
      * fold alpha; change (hi m) with (rnd P); apply Rabs_le_inv in HP, Hr; apply Rabs_le; lra.
      * change (lo m) with (rnd (P - rnd P)); apply Rabs_le_inv in Lx, Hlow; apply Rabs_le; lra.
    + pose proof (u_part P ltac:(lra)); lra.
Qed.

(** ** The length of any vector *)

Lemma dot2_any a : double_word (dx a) -> double_word (dy a) -> double_word (dz a) -> let s := norm (wholes a) in
  double_word (dot2 a a) /\ Rabs (whole (dot2 a a) - s * s) <= 302 / 100 * (uu * (s * s)) + bpow radix2 (-954).
Proof.
  intros Wx Wy Wz s; unfold dot2; pose proof uu_bounds as Hu.
  destruct (product_any _ _ Wx Wx) as [Px Hx], (product_any _ _ Wy Wy) as [Py Hy], (product_any _ _ Wz Wz) as [Pz Hz].
  set (X := product (dx a) (dx a)) in *; set (Y := product (dy a) (dy a)) in *; set (Z := product (dz a) (dz a)) in *.
  destruct (sum_near X Y Px Py) as [Ws Hs]; apply six_in_uu in Hs.
  destruct (sum_near (sum X Y) Z Ws Pz) as [Wd Hd]; apply six_in_uu in Hd; split; [exact Wd|].
  assert (Sq : forall t, Rabs (t * t) = t * t) by (intros t; apply Rabs_pos_eq, Rle_0_sqr); rewrite Sq in Hx, Hy, Hz.
  set (x := whole (dx a) * whole (dx a)) in *; set (y := whole (dy a) * whole (dy a)) in *.
  set (z := whole (dz a) * whole (dz a)) in *; unfold s; rewrite norm_square;
    change (dot (wholes a) (wholes a)) with (x + y + z).
  assert (Hx0 : 0 <= x) by apply Rle_0_sqr; assert (Hy0 : 0 <= y) by apply Rle_0_sqr;
    assert (Hz0 : 0 <= z) by apply Rle_0_sqr.
  assert (H954 : bpow radix2 (-954) = 8 * bpow radix2 (-957)).
  { replace 8 with (bpow radix2 3) by reflexivity; now rewrite <- bpow_plus. }
  rewrite H954; pose proof (bpow_gt_0 radix2 (-957)) as H957; set (l := bpow radix2 (-957)) in *.
  assert (P : forall t, 0 <= t -> 0 <= uu * t <= e30 * t).
  { intros t Ht; split; [apply Rmult_le_pos | apply Rmult_le_compat_r]; lra. }
  pose proof (P x Hx0); pose proof (P y Hy0); pose proof (P z Hz0); apply Rabs_le_inv in Hx, Hy, Hz.
  assert (Hxy : uu * Rabs (whole X + whole Y) <= uu * ((1 + / 1000) * (x + y) + 2 * l)).
  { apply Rmult_le_compat_l; [lra|]; apply Rabs_le; lra. }
  pose proof (P l ltac:(lra)); apply Rabs_le_inv in Hs.
  assert (Hxyz : uu * Rabs (whole (sum X Y) + whole Z) <= uu * ((1 + / 500) * (x + y + z) + 4 * l)).
  { apply Rmult_le_compat_l; [lra|]; apply Rabs_le; lra. }
  apply Rabs_le_inv in Hd; apply Rabs_le; lra.
Qed.

Lemma norm2_any a : double_word (dx a) -> double_word (dy a) -> double_word (dz a) -> let s := norm (wholes a) in
  double_word (norm2 a) /\ Rabs (whole (norm2 a) - s) <= 8 * uu * s + bpow radix2 (-450) /\ 0 <= whole (norm2 a).
Proof.
  intros Wx Wy Wz s; destruct (dot2_any a Wx Wy Wz) as [W H]; fold s in H; unfold norm2; set (P := dot2 a a) in *.
  pose proof (norm_nonneg (wholes a) : 0 <= s) as Hs; pose proof uu_bounds as Hu;
    pose proof (Rmult_le_pos s s Hs Hs) as Hss.
  assert (Hus : 0 <= uu * (s * s) <= e30 * (s * s)) by (split; [apply Rmult_le_pos | apply Rmult_le_compat_r]; lra).
  assert (Hus1 : 0 <= uu * s <= e30 * s) by (split; [apply Rmult_le_pos | apply Rmult_le_compat_r]; lra).
  assert (Lift : forall k j, (k <= j)%Z -> bpow radix2 k <= bpow radix2 j) by (intros; now apply bpow_le).
  pose proof (bpow_gt_0 radix2 (-450)) as H450; apply Rabs_le_inv in H.
  destruct (Rlt_le_dec (hi P) (bpow radix2 (-920))) as [Hsmall|Hbig].
  - destruct (root_small P W Hsmall) as [Wr Hr].
    assert (H448 : 2 * bpow radix2 (-451) = bpow radix2 (-450)).
    { replace 2 with (bpow radix2 1) by reflexivity; now rewrite <- bpow_plus. }
    pose proof (Lift (-458)%Z (-451)%Z ltac:(lia)).
    assert (Hs451 : s <= bpow radix2 (-451)).
    { unfold s; apply Rnot_lt_le; fold s; intros Hlt.
      assert (Hsq : bpow radix2 (-902) <= s * s).
      { change (-902)%Z with (-451 + -451)%Z; rewrite bpow_plus; pose proof (bpow_gt_0 radix2 (-451)).
        apply Rmult_le_compat; lra. }
      pose proof (Lift (-954)%Z (-904)%Z ltac:(lia)); pose proof (Lift (-920)%Z (-904)%Z ltac:(lia)).
      assert (H902 : bpow radix2 (-902) = 4 * bpow radix2 (-904)).
      { replace 4 with (bpow radix2 2) by reflexivity; now rewrite <- bpow_plus. }
      pose proof (bpow_gt_0 radix2 (-904)); destruct (word_near P W) as [Nw _];
        rewrite (Rabs_pos_eq (whole P)) in Nw by lra.
      pose proof (u_part (whole P) ltac:(lra)); apply Rabs_le_inv in Nw; lra. }
    split; [exact Wr|]; split; [apply Rabs_le|]; lra.
  - destruct (root_near P W Hbig) as [Wr Hr]; split; [exact Wr|]; pose proof (bpow_gt_0 radix2 (-920)) as H920.
    assert (Hw : / 2 * bpow radix2 (-920) <= whole P).
    { destruct (word_near P W) as [_ Nw]; rewrite (Rabs_pos_eq (hi P)) in Nw by lra; pose proof (u_part (hi P) ltac:(lra)).
      apply Rabs_le_inv in Nw; lra. }
    pose proof (Lift (-954)%Z (-924)%Z ltac:(lia)) as H954.
    assert (H920' : bpow radix2 (-920) = 16 * bpow radix2 (-924)).
    { replace 16 with (bpow radix2 4) by reflexivity; now rewrite <- bpow_plus. }
    assert (Hs0 : bpow radix2 (-462) <= s).
    { rewrite <- (sqrt_square s Hs), <- (sqrt_square (bpow radix2 (-462))) by apply bpow_ge_0; apply sqrt_le_1_alt.
      rewrite <- bpow_plus; pose proof (bpow_gt_0 radix2 (-924)); change (-462 + -462)%Z with (-924)%Z; lra. }
    pose proof (bpow_gt_0 radix2 (-462)) as H462.
    assert (Hsmall : bpow radix2 (-954) <= bpow radix2 (-460) * s).
    { apply Rle_trans with (bpow radix2 (-460) * bpow radix2 (-462)); [rewrite <- bpow_plus; apply bpow_le; lia|].
      apply Rmult_le_compat_l; [apply bpow_ge_0 | exact Hs0]. }
    assert (Hd : Rabs (sqrt (whole P) - s) <= 303 / 100 * (uu * s) + bpow radix2 (-460)).
    { replace s with (sqrt (s * s)) at 1 by (apply sqrt_square; lra); rewrite Rabs_minus_sym.
      apply Rle_trans with (1 := sqrt_distance (s * s) (whole P) ltac:(apply Rmult_lt_0_compat; lra) ltac:(lra)).
      rewrite (sqrt_square s) by lra; apply Rmult_le_reg_r with s; [lra|]; unfold Rdiv;
        rewrite Rmult_assoc, Rinv_l, Rmult_1_r by lra.
      apply Rabs_le; lra. }
    pose proof (Lift (-460)%Z (-453)%Z ltac:(lia)) as H460; pose proof (bpow_gt_0 radix2 (-460)).
    assert (H450' : bpow radix2 (-450) = 8 * bpow radix2 (-453)).
    { replace 8 with (bpow radix2 3) by reflexivity; now rewrite <- bpow_plus. }
    apply Rabs_le_inv in Hd; assert (uu * sqrt (whole P) <= uu * ((1 + / 1000) * s + bpow radix2 (-460))) by
      (apply Rmult_le_compat_l; lra).
    assert (uu * bpow radix2 (-460) <= e30 * bpow radix2 (-460)) by (apply Rmult_le_compat_r; lra).
    pose proof (bpow_gt_0 radix2 (-453)).
    assert (uu * sqrt (whole P) <= e30 * sqrt (whole P)) by (apply Rmult_le_compat_r; [apply sqrt_pos | lra]).
    pose proof (sqrt_pos (whole P)); apply Rabs_le_inv in Hr; split; [apply Rabs_le|]; lra.
Qed.

(** What underflows is nothing beside the bounds: x is a number of the element, W a product of two bounds. *)
Lemma nothing_beside x W : Rabs x <= bpow radix2 100 -> bpow radix2 (-200) <= W ->
  (1 + x) * bpow radix2 (-450) <= / 1000 * (uu * W) /\ bpow radix2 (-957) <= / 1000 * (uu * W).
Proof.
  intros Hx HW; apply Rabs_le_inv in Hx.
  assert (Hs : bpow radix2 (-320) <= / 1000 * (uu * W)).
  { apply Rle_trans with (bpow radix2 (-18) * (uu * bpow radix2 (-200))); [rewrite <- !bpow_plus; apply bpow_le; lia|].
    pose proof uu_bounds; apply Rmult_le_compat; try apply bpow_ge_0.
    - apply Rmult_le_pos; [lra | apply bpow_ge_0].
    - replace (bpow radix2 (-18)) with (/ 262144) by reflexivity; lra.
    - apply Rmult_le_compat_l; lra. }
  split; apply Rle_trans with (2 := Hs); [|apply bpow_le; lia].
  apply Rle_trans with (bpow radix2 101 * bpow radix2 (-450)); [|rewrite <- bpow_plus; apply bpow_le; lia].
  apply Rmult_le_compat_r; [apply bpow_ge_0|]; change 101%Z with (1 + 100)%Z; rewrite bpow_plus.
  replace (bpow radix2 1) with 2 by reflexivity; assert (1 <= bpow radix2 100); [|lra].
  replace 1 with (bpow radix2 0) by reflexivity; apply bpow_le; lia.
Qed.
