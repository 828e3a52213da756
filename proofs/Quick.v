(** * Quick: the exact rounding in integers of 128 bits says nothing false

    src/number/quick_round.cpp, step by step, over integers: a number (x + y√delta)/w, its parts integers times powers of
    two, is bounded by two integers of 128 bits times one power of two; where both ends round alike, it rounds so. Rounding
    is any function that does not decrease, so overflow is included.

    bits, expo       == a magnitude is its bits times 2^expo
    spans k m x      == x is in [bits, bits + k) times 2^expo
    leading, root, product, numerator, quick == as there: leading_128, root_128, high_product, numerator, quick_round *)
From Coq Require Import Reals ZArith Lra Lia Bool.
From Flocq Require Import Core.
Local Open Scope R_scope.

Record magnitude := Mag { bits : Z; expo : Z }.
Notation pw := (bpow radix2).
Definition spans (k : Z) (m : magnitude) (x : R) : Prop := IZR (bits m) * pw (expo m) <= x < IZR (bits m + k) * pw (expo m).
Definition full (m : magnitude) : Prop := (2 ^ 127 <= bits m < 2 ^ 128)%Z.

(** A dyadic: m·2^e. *)
Definition dyadic (m e : Z) : R := IZR m * pw e.

Definition leading (m e : Z) : magnitude :=
  let shift := (127 - Z.log2 (Z.abs m))%Z in
  Mag (if (0 <=? shift)%Z then Z.abs m * 2 ^ shift else Z.abs m / 2 ^ (- shift)) (e - shift).
Definition root (m : magnitude) : magnitude :=
  let k := if Z.even (expo m) then 128%Z else 127%Z in Mag (Z.sqrt (bits m * 2 ^ k)) ((expo m - k) / 2).
Definition product (a b : magnitude) : magnitude := Mag (bits a * bits b / 2 ^ 128) (expo a + expo b + 128).
Definition shifted_down (value shift : Z) : Z := if (shift <? 128)%Z then value / 2 ^ shift else 0.
Definition numerator (mx ex my ey md ed : Z) : magnitude :=
  if ((my =? 0) || (md =? 0))%Z%bool then let x := leading mx ex in Mag (Z.sgn mx * (bits x / 4)) (expo x + 2)
  else
    let term := product (leading my ey) (root (leading md ed)) in
    let x := if (mx =? 0)%Z then Mag 0 (expo term) else leading mx ex in
    let e := (Z.max (expo x) (expo term) + 2)%Z in
    Mag (Z.sgn mx * shifted_down (bits x) (e - expo x) + Z.sgn my * shifted_down (bits term) (e - expo term)) e.

(** The ends, signed, between which the value lies; none where they would be too far apart. *)
Definition ends (n : magnitude) (mw ew : Z) : option (R * R) :=
  let size := Z.abs (bits n) in
  if (size <? 2 ^ 70)%Z then None
  else
    let w := leading mw ew in
    let q := (size * 2 ^ 128 / bits w)%Z in
    let e := (expo n - expo w - 128)%Z in
    let sign := if xorb (bits n <? 0)%Z (mw <? 0)%Z then (-1) else 1 in
    if (2 ^ 128 - 1 - 10 <? q)%Z then None else Some (sign * (IZR (q - 10) * pw e), sign * (IZR (q + 10) * pw e)).

Definition quick (round : R -> R) (mx ex my ey md ed mw ew : Z) : option R :=
  match ends (numerator mx ex my ey md ed) mw ew with
  | Some (one, other) => if Req_bool (round one) (round other) then Some (round one) else None
  | None => None
  end.

(** ** Each step *)

Lemma IZR_pow k : (0 <= k)%Z -> IZR (2 ^ k) = pw k.
Proof. exact (IZR_Zpower radix2 k). Qed.

Lemma divided a b : (0 < b)%Z -> IZR (a / b) <= IZR a / IZR b < IZR (a / b) + 1.
Proof.
  intros Hb; pose proof (IZR_lt _ _ Hb) as Hb'; pose proof (Z.mul_div_le a b Hb) as H1; pose proof (Z.mul_succ_div_gt a b Hb) as H2.
  apply IZR_le in H1; apply IZR_lt in H2; rewrite mult_IZR in H1, H2; unfold Z.succ in H2; rewrite plus_IZR in H2.
  split; [apply Rmult_le_reg_r with (IZR b) | apply Rmult_lt_reg_r with (IZR b)]; auto; unfold Rdiv; rewrite ?Rmult_assoc, ?Rinv_l; lra.
Qed.

Lemma leading_spans m e : m <> 0%Z -> full (leading m e) /\ spans 1 (leading m e) (Rabs (dyadic m e)).
Proof.
  intros Hm; set (a := Z.abs m); assert (Ha : (0 < a)%Z) by (unfold a; lia); pose proof (Z.log2_spec a Ha) as Hl.
  pose proof (Z.log2_nonneg a) as Hn; unfold leading; fold a; set (n := Z.log2 a) in *; unfold full, spans; cbn [bits expo].
  assert (Ed : Rabs (dyadic m e) = IZR a * pw e).
  { unfold dyadic; rewrite Rabs_mult, (Rabs_pos_eq (pw e)) by apply bpow_ge_0; unfold a; now rewrite abs_IZR. }
  rewrite Ed; destruct (Z.leb_spec 0 (127 - n)) as [Hs|Hs].
  - assert (E1 : (2 ^ 127 = 2 ^ n * 2 ^ (127 - n))%Z) by (rewrite <- Z.pow_add_r by lia; f_equal; lia).
    assert (E2 : (2 ^ 128 = 2 ^ Z.succ n * 2 ^ (127 - n))%Z) by (rewrite <- Z.pow_add_r by lia; f_equal; lia).
    pose proof (Z.pow_pos_nonneg 2 (127 - n) ltac:(lia) Hs) as Hp; split; [rewrite E1, E2; split; [apply Z.mul_le_mono_nonneg_r | apply Z.mul_lt_mono_pos_r]; lia|].
    rewrite plus_IZR, mult_IZR, IZR_pow by lia; pose proof (bpow_gt_0 radix2 (e - (127 - n))).
    replace (IZR a * pw e) with (IZR a * pw (127 - n) * pw (e - (127 - n))); [lra|].
    rewrite Rmult_assoc, <- bpow_plus; do 2 f_equal; lia.
  - set (k := (- (127 - n))%Z) in *; assert (Hk : (0 < k)%Z) by lia; pose proof (Z.pow_pos_nonneg 2 k ltac:(lia) ltac:(lia)) as Hp.
    assert (E1 : (2 ^ n = 2 ^ 127 * 2 ^ k)%Z) by (rewrite <- Z.pow_add_r by lia; f_equal; lia).
    assert (E2 : (2 ^ Z.succ n = 2 ^ 128 * 2 ^ k)%Z) by (rewrite <- Z.pow_add_r by lia; f_equal; lia).
    split; [split; [apply Z.div_le_lower_bound; lia | apply Z.div_lt_upper_bound; lia]|].
    pose proof (divided a (2 ^ k) Hp) as Hd; rewrite IZR_pow in Hd by lia; rewrite plus_IZR.
    replace (e - (127 - n))%Z with (k + e)%Z by lia; pose proof (bpow_gt_0 radix2 (k + e)); pose proof (bpow_gt_0 radix2 k).
    replace (IZR a * pw e) with (IZR a / pw k * pw (k + e)) by (rewrite bpow_plus; field; lra).
    split; [apply Rmult_le_compat_r | apply Rmult_lt_compat_r]; lra.
Qed.

Lemma root_spans m x : full m -> spans 1 m x -> 0 <= x -> full (root m) /\ spans 2 (root m) (sqrt x).
Proof.
  unfold full, spans, root; intros Hf Hx Hx0; cbn [bits expo]; set (k := if Z.even (expo m) then 128%Z else 127%Z) in *.
  assert (Hk : k = 127%Z \/ k = 128%Z) by (unfold k; destruct Z.even; auto).
  assert (Hh : exists h, (expo m - k = h + h)%Z).
  { unfold k; destruct (Z.even (expo m)) eqn:Ev; [apply Z.even_spec in Ev as [j Ej]; exists (j - 64)%Z; lia|].
    assert (Od : Z.odd (expo m) = true) by (rewrite <- Z.negb_even, Ev; reflexivity).
    apply Z.odd_spec in Od as [j Ej]; exists (j - 63)%Z; lia. }
  destruct Hh as [h Eh]; replace ((expo m - k) / 2)%Z with h by (rewrite Eh; apply Z.div_unique with 0%Z; lia).
  set (b := bits m) in *; set (N := (b * 2 ^ k)%Z); set (r := Z.sqrt N).
  assert (Hp : (2 ^ 127 <= 2 ^ k <= 2 ^ 128)%Z) by (destruct Hk as [-> | ->]; lia).
  assert (HN : (2 ^ 127 * 2 ^ 127 <= N < 2 ^ 128 * 2 ^ 128)%Z).
  { unfold N; split; [apply Z.mul_le_mono_nonneg; lia|].
    apply Z.le_lt_trans with (b * 2 ^ 128)%Z; [apply Z.mul_le_mono_nonneg_l; lia | apply Z.mul_lt_mono_pos_r; lia]. }
  pose proof (Z.sqrt_spec N ltac:(lia)) as Hr; fold r in Hr; cbv zeta in Hr; pose proof (Z.sqrt_nonneg N) as Hr0; fold r in Hr0.
  assert (Hfull : (2 ^ 127 <= r < 2 ^ 128)%Z).
  { split; [apply Z.sqrt_le_square; lia | apply Z.sqrt_lt_square; lia]. }
  split; [exact Hfull|].
  assert (EX : x = (x / pw (expo m) * pw k) * (pw h * pw h)).
  { rewrite <- bpow_plus; replace (h + h)%Z with (expo m - k)%Z by lia; unfold Zminus; rewrite bpow_plus, bpow_opp.
    pose proof (bpow_gt_0 radix2 (expo m)); pose proof (bpow_gt_0 radix2 k); field; lra. }
  pose proof (bpow_gt_0 radix2 (expo m)) as He; set (y := x / pw (expo m)) in *.
  assert (Hy : IZR b <= y < IZR b + 1).
  { rewrite plus_IZR in Hx; unfold y; split; [apply Rmult_le_reg_r with (pw (expo m)) | apply Rmult_lt_reg_r with (pw (expo m))];
      auto; unfold Rdiv; rewrite ?Rmult_assoc, ?Rinv_l; lra. }
  assert (Hb : IZR (2 ^ 127) <= IZR b) by (apply IZR_le; lia).
  assert (Es : sqrt x = sqrt (y * pw k) * pw h).
  { rewrite EX at 1; rewrite sqrt_mult, sqrt_square by (try apply bpow_ge_0; apply Rmult_le_pos; (lra || apply bpow_ge_0)).
    reflexivity. }
  rewrite Es; pose proof (bpow_gt_0 radix2 h) as Hh0; rewrite plus_IZR.
  assert (Hrr : IZR r * IZR r <= y * pw k < (IZR r + 2) * (IZR r + 2)).
  { rewrite <- IZR_pow by lia; assert (HP : IZR (2 ^ k) <= IZR (2 ^ 128)) by (apply IZR_le; lia).
    assert (HP0 : 0 < IZR (2 ^ k)) by (apply IZR_lt; lia).
    assert (H1 : IZR r * IZR r <= IZR b * IZR (2 ^ k)) by (rewrite <- !mult_IZR; apply IZR_le; exact (proj1 Hr)).
    assert (H2 : IZR b * IZR (2 ^ k) + IZR (2 ^ k) <= (IZR r + 2) * (IZR r + 2)).
    { rewrite <- !plus_IZR, <- !mult_IZR, <- plus_IZR; apply IZR_le; change (N + 2 ^ k <= (r + 2) * (r + 2))%Z.
      replace ((r + 2) * (r + 2))%Z with (r * r + 4 * r + 4)%Z by ring.
      replace (Z.succ r * Z.succ r)%Z with (r * r + 2 * r + 1)%Z in Hr by (unfold Z.succ; ring).
      assert (Hle : (2 ^ k <= 2 * r)%Z) by (change (2 ^ 128)%Z with (2 * 2 ^ 127)%Z in Hp; lia); clear - Hr Hle; lia. }
    assert (H3 : IZR b * IZR (2 ^ k) <= y * IZR (2 ^ k)) by (apply Rmult_le_compat_r; lra).
    assert (H4 : y * IZR (2 ^ k) < (IZR b + 1) * IZR (2 ^ k)) by (apply Rmult_lt_compat_r; lra); lra. }
  assert (Hr1 : 0 <= IZR r) by (apply IZR_le; lia).
  split; [apply Rmult_le_compat_r | apply Rmult_lt_compat_r]; try lra.
  - rewrite <- (sqrt_square (IZR r)) by lra; apply sqrt_le_1_alt; lra.
  - rewrite <- (sqrt_square (IZR r + 2)) by lra; apply sqrt_lt_1_alt; split; [|lra].
    pose proof (Rle_0_sqr (IZR r)) as Hsq; unfold Rsqr in Hsq; lra.
Qed.

Lemma product_spans a b x y : full a -> full b -> spans 1 a x -> spans 2 b y ->
  (0 <= bits (product a b) < 2 ^ 128)%Z /\ spans 5 (product a b) (x * y).
Proof.
  unfold full, spans, product; intros Ha Hb Hx Hy; cbn [bits expo]; set (c := bits a) in *; set (d := bits b) in *.
  pose proof (divided (c * d) (2 ^ 128) ltac:(lia)) as Hd; rewrite mult_IZR in Hd; set (q := (c * d / 2 ^ 128)%Z) in *.
  split.
  { split; [apply Z.div_pos; [apply Z.mul_nonneg_nonneg|]; lia | apply Z.div_lt_upper_bound; [lia|]].
    apply Z.le_lt_trans with (c * 2 ^ 128)%Z; [apply Z.mul_le_mono_nonneg_l; lia | apply Z.mul_lt_mono_pos_r; lia]. }
  rewrite plus_IZR in *; rewrite !bpow_plus, <- (IZR_pow 128) by lia.
  assert (HM : 0 < IZR (2 ^ 128)) by (apply IZR_lt; lia); set (M := IZR (2 ^ 128)) in *.
  assert (Hc : 0 < IZR c < M) by (unfold M; split; apply IZR_lt; lia).
  assert (Hd0 : 0 < IZR d < M) by (unfold M; split; apply IZR_lt; lia).
  pose proof (bpow_gt_0 radix2 (expo a)); pose proof (bpow_gt_0 radix2 (expo b)); set (p := pw (expo a)) in *; set (s := pw (expo b)) in *.
  assert (Hps : 0 < p * s) by now apply Rmult_lt_0_compat.
  assert (Hq : IZR q * M <= IZR c * IZR d < (IZR q + 1) * M).
  { replace (IZR c * IZR d) with (IZR c * IZR d / M * M) by (field; lra).
    split; [apply Rmult_le_compat_r | apply Rmult_lt_compat_r]; lra. }
  split.
  - apply Rle_trans with ((IZR c * p) * (IZR d * s)).
    + replace (IZR q * (p * s * M)) with (IZR q * M * (p * s)) by ring.
      replace (IZR c * p * (IZR d * s)) with (IZR c * IZR d * (p * s)) by ring; apply Rmult_le_compat_r; lra.
    + apply Rmult_le_compat; try lra; apply Rlt_le, Rmult_lt_0_compat; lra.
  - apply Rlt_le_trans with ((IZR c + 1) * p * ((IZR d + 2) * s)).
    + assert (0 < IZR c * p) by (apply Rmult_lt_0_compat; lra); assert (0 < IZR d * s) by (apply Rmult_lt_0_compat; lra).
      apply Rmult_gt_0_lt_compat; try lra; apply Rmult_lt_0_compat; lra.
    + replace ((IZR c + 1) * p * ((IZR d + 2) * s)) with ((IZR c * IZR d + 2 * IZR c + IZR d + 2) * (p * s)) by ring.
      replace ((IZR q + 5) * (p * s * M)) with ((IZR q + 5) * M * (p * s)) by ring; apply Rmult_le_compat_r; [lra|].
      assert (2 <= M) by (unfold M; apply IZR_le; lia); lra.
Qed.

(** A part at least two places lower: its sign, and the cut. *)
Lemma part_near k m s x v e : (k = 1 \/ k = 5)%Z -> (0 <= bits m < 2 ^ 128)%Z -> (expo m + 2 <= e)%Z -> spans k m (Rabs x) ->
  (s = Z.sgn v)%Z -> (v <> 0)%Z -> (0 < IZR v -> 0 <= x) -> (IZR v < 0 -> x <= 0) ->
  let c := shifted_down (bits m) (e - expo m) in
  (0 <= c < 2 ^ 126)%Z /\ Rabs (x - IZR (s * c) * pw e) <= (if (k =? 1)%Z then 5 / 4 else 9 / 4) * pw e.
Proof.
  intros Hk Hb He Hx -> Hv Hpos Hneg c; set (d := (e - expo m)%Z) in *; assert (Hd : (2 <= d)%Z) by lia.
  assert (Ec : c = (bits m / 2 ^ d)%Z).
  { unfold c, shifted_down; destruct (Z.ltb_spec d 128); [reflexivity|]; symmetry; apply Z.div_small.
    pose proof (Z.pow_le_mono_r 2 128 d ltac:(lia) ltac:(lia)); lia. }
  pose proof (Z.pow_le_mono_r 2 2 d ltac:(lia) Hd) as H4; pose proof (divided (bits m) (2 ^ d) ltac:(lia)) as Hq; rewrite <- Ec in Hq.
  assert (Hc : (0 <= c < 2 ^ 126)%Z).
  { rewrite Ec; split; [apply Z.div_pos; lia | apply Z.div_lt_upper_bound; [lia|]].
    assert (2 ^ 2 * 2 ^ 126 <= 2 ^ d * 2 ^ 126)%Z by (apply Z.mul_le_mono_nonneg_r; lia); lia. }
  split; [exact Hc|]; unfold spans in Hx; rewrite plus_IZR in Hx; rewrite IZR_pow in Hq by lia.
  pose proof (bpow_gt_0 radix2 d) as Hpd; pose proof (bpow_gt_0 radix2 (expo m)) as Hpm; apply IZR_le in H4; rewrite (IZR_pow d) in H4 by lia.
  replace e with (d + expo m)%Z by (unfold d; lia); rewrite bpow_plus; set (D := pw d) in *; set (P := pw (expo m)) in *.
  assert (Hq' : IZR c * D <= IZR (bits m) < (IZR c + 1) * D).
  { replace (IZR (bits m)) with (IZR (bits m) / D * D) by (field; lra).
    split; [apply Rmult_le_compat_r | apply Rmult_lt_compat_r]; lra. }
  set (lost := if (k =? 1)%Z then 5 / 4 else 9 / 4).
  assert (Hk' : IZR k <= (lost - 1) * D).
  { change (IZR (2 ^ 2)) with 4 in H4; unfold lost; destruct Hk as [-> | ->]; cbn; lra. }
  assert (HcP : IZR c * D * P <= IZR (bits m) * P) by (apply Rmult_le_compat_r; lra).
  assert (HcP2 : (IZR (bits m) + IZR k) * P <= (IZR c + lost) * D * P) by (apply Rmult_le_compat_r; lra).
  assert (Habs : 0 <= Rabs x - IZR c * (D * P) <= lost * (D * P)) by lra.
  destruct (Z.lt_trichotomy v 0) as [Hlt|[E|Hgt]]; [|contradiction|].
  - apply IZR_lt in Hlt as Hlt'; specialize (Hneg Hlt'); rewrite Rabs_left1 in Habs by lra; rewrite Z.sgn_neg by lia.
    rewrite mult_IZR; apply Rabs_le; lra.
  - apply IZR_lt in Hgt as Hgt'; specialize (Hpos Hgt'); rewrite Rabs_pos_eq in Habs by lra; rewrite Z.sgn_pos by lia.
    rewrite mult_IZR; apply Rabs_le; lra.
Qed.

(** The whole numerator: within 4, and of less than 127 bits. *)
Lemma numerator_near mx ex my ey md ed : (0 <= md)%Z -> ((my = 0 \/ md = 0)%Z -> mx <> 0%Z) ->
  let n := numerator mx ex my ey md ed in
  (Z.abs (bits n) < 2 ^ 127)%Z /\
  Rabs (dyadic mx ex + dyadic my ey * sqrt (dyadic md ed) - IZR (bits n) * pw (expo n)) <= 4 * pw (expo n).
Proof.
  intros Hmd Hmx n; pose proof (bpow_gt_0 radix2 (expo n)) as Hp; unfold n in *; clear n; revert Hp; unfold numerator.
  assert (Hsign : forall m e, (0 < IZR m -> 0 <= dyadic m e) /\ (IZR m < 0 -> dyadic m e <= 0)).
  { intros m e; pose proof (bpow_ge_0 radix2 e); unfold dyadic; split; intros Hm.
    - apply Rmult_le_pos; lra.
    - rewrite <- (Rmult_0_l (pw e)); apply Rmult_le_compat_r; lra. }
  destruct ((my =? 0) || (md =? 0))%Z%bool eqn:Eflat; cbv zeta; cbn [bits expo]; intros Hp.
  - assert (Hz : (my = 0 \/ md = 0)%Z).
    { apply orb_true_iff in Eflat as [E|E]; apply Z.eqb_eq in E; auto. }
    specialize (Hmx Hz); destruct (leading_spans mx ex Hmx) as [Hf Hs]; unfold full in Hf; destruct (Hsign mx ex) as [Sp Sn].
    destruct (part_near 1 (leading mx ex) (Z.sgn mx) (dyadic mx ex) mx (expo (leading mx ex) + 2) ltac:(auto) ltac:(lia) ltac:(lia)
      Hs eq_refl Hmx Sp Sn) as [Hc Hn]; replace (expo (leading mx ex) + 2 - expo (leading mx ex))%Z with 2%Z in * by lia.
    change (shifted_down (bits (leading mx ex)) 2) with (bits (leading mx ex) / 4)%Z in *.
    split; [destruct (Z.sgn_spec mx) as [[_ ->]|[[_ ->]|[_ ->]]]; lia|].
    replace (dyadic my ey * sqrt (dyadic md ed)) with 0.
    + rewrite Rplus_0_r; apply Rle_trans with (1 := Hn); change (1 =? 1)%Z with true; cbv iota; lra.
    + unfold dyadic; destruct Hz as [-> | ->]; [ring | rewrite Rmult_0_l, sqrt_0; ring].
  - apply orb_false_iff in Eflat as [Hmy Hmd']; apply Z.eqb_neq in Hmy, Hmd'.
    assert (Hd0 : 0 <= dyadic md ed) by (unfold dyadic; apply Rmult_le_pos; [apply IZR_le; lia | apply bpow_ge_0]).
    destruct (leading_spans my ey Hmy) as [Fy Sy], (leading_spans md ed Hmd') as [Fd Sd]; rewrite (Rabs_pos_eq _ Hd0) in Sd.
    destruct (root_spans _ _ Fd Sd Hd0) as [Fr Sr], (product_spans _ _ _ _ Fy Fr Sy Sr) as [Ft St].
    set (term := product (leading my ey) (root (leading md ed))) in *; set (d := sqrt (dyadic md ed)) in *.
    assert (Hd1 : 0 <= d) by apply sqrt_pos.
    set (x := if (mx =? 0)%Z then Mag 0 (expo term) else leading mx ex) in *; set (e := (Z.max (expo x) (expo term) + 2)%Z) in *.
    replace (Rabs (dyadic my ey) * d) with (Rabs (dyadic my ey * d)) in St by (rewrite Rabs_mult, (Rabs_pos_eq d) by exact Hd1; reflexivity).
    destruct (Hsign my ey) as [Sp Sn].
    destruct (part_near 5 term (Z.sgn my) (dyadic my ey * d) my e ltac:(auto) Ft ltac:(unfold e; lia) St eq_refl Hmy) as [Hct Hnt].
    { intros H0; apply Rmult_le_pos; auto. }
    { intros H0; specialize (Sn H0); rewrite <- (Rmult_0_l d); apply Rmult_le_compat_r; auto. }
    set (ct := shifted_down (bits term) (e - expo term)) in *; change (5 =? 1)%Z with false in Hnt; cbv iota in Hnt.
    assert (Hx : (0 <= shifted_down (bits x) (e - expo x) < 2 ^ 126)%Z /\
      Rabs (dyadic mx ex - IZR (Z.sgn mx * shifted_down (bits x) (e - expo x)) * pw e) <= 5 / 4 * pw e).
    { unfold x in *; destruct (Z.eqb_spec mx 0) as [E|N].
      - cbn [bits expo] in *; replace (shifted_down 0 (e - expo term)) with 0%Z.
        + split; [lia|]; rewrite E; unfold dyadic; rewrite Z.mul_0_r, !Rmult_0_l, Rminus_0_r, Rabs_R0; lra.
        + unfold shifted_down; destruct (_ <? 128)%Z; [rewrite Z.div_0_l; [reflexivity | apply Z.pow_nonzero; unfold e; cbn [expo]; lia] | reflexivity].
      - destruct (leading_spans mx ex N) as [Fx Sx]; unfold full in Fx; destruct (Hsign mx ex) as [Xp Xn].
        exact (part_near 1 (leading mx ex) (Z.sgn mx) (dyadic mx ex) mx e ltac:(auto) ltac:(lia) ltac:(unfold e; lia) Sx eq_refl N Xp Xn). }
    destruct Hx as [Hcx Hnx]; set (cx := shifted_down (bits x) (e - expo x)) in *; split.
    + destruct (Z.sgn_spec mx) as [[_ ->]|[[_ ->]|[_ ->]]], (Z.sgn_spec my) as [[_ ->]|[[_ ->]|[_ ->]]]; lia.
    + rewrite plus_IZR; replace (dyadic mx ex + dyadic my ey * d - (IZR (Z.sgn mx * cx) + IZR (Z.sgn my * ct)) * pw e)
        with ((dyadic mx ex - IZR (Z.sgn mx * cx) * pw e) + (dyadic my ey * d - IZR (Z.sgn my * ct) * pw e)) by ring.
      apply Rle_trans with (1 := Rabs_triang _ _); lra.
Qed.

(** The ends are around the value. *)
Lemma ends_around n mw ew N one other : mw <> 0%Z -> (Z.abs (bits n) < 2 ^ 127)%Z ->
  Rabs (N - IZR (bits n) * pw (expo n)) <= 4 * pw (expo n) -> ends n mw ew = Some (one, other) ->
  Rmin one other <= N / dyadic mw ew <= Rmax one other.
Proof.
  intros Hmw Hsize HN; unfold ends; set (size := Z.abs (bits n)) in *; destruct (Z.ltb_spec size (2 ^ 70)) as [|Hbig]; [discriminate|].
  destruct (leading_spans mw ew Hmw) as [Fw Sw]; unfold full in Fw; set (w := leading mw ew) in *; set (b := bits w) in *.
  set (q := (size * 2 ^ 128 / b)%Z); set (e := (expo n - expo w - 128)%Z).
  destruct (2 ^ 128 - 1 - 10 <? q)%Z; [discriminate|]; intros [= <- <-].
  pose proof (divided (size * 2 ^ 128) b ltac:(lia)) as Hq; fold q in Hq; rewrite mult_IZR in Hq.
  unfold spans in Sw; fold b in Sw; rewrite plus_IZR in Sw; set (W := Rabs (dyadic mw ew)) in *.
  pose proof (bpow_gt_0 radix2 (expo n)) as Hpn; pose proof (bpow_gt_0 radix2 (expo w)) as Hpw.
  set (P := pw (expo n)) in *; set (Pw := pw (expo w)) in *.
  assert (HM : IZR (2 ^ 128) = 2 * IZR (2 ^ 127)) by (rewrite <- mult_IZR; reflexivity).
  assert (HM1 : 1 <= IZR (2 ^ 127)) by (apply IZR_le; lia); set (M := IZR (2 ^ 127)) in *; rewrite HM in Hq.
  assert (Hb : M <= IZR b) by (apply IZR_le; lia); assert (Hs : 0 <= IZR size <= M) by (unfold M; split; apply IZR_le; lia).
  assert (Hs70 : 4 < IZR size) by (apply IZR_lt; lia).
  assert (HW : 0 < W) by (assert (0 < IZR b * Pw) by (apply Rmult_lt_0_compat; lra); lra).
  assert (Ee : pw e = P / (2 * M * Pw)).
  { unfold e, Zminus; rewrite !bpow_plus, !bpow_opp; fold P Pw; replace (pw 128) with (2 * M) by (rewrite <- HM; apply IZR_pow; lia).
    field; split; lra. }
  assert (HA : (IZR size - 4) * P <= Rabs N <= (IZR size + 4) * P).
  { assert (Hn : Rabs (IZR (bits n) * P) = IZR size * P) by (rewrite Rabs_mult, (Rabs_pos_eq P), <- abs_IZR by lra; reflexivity).
    pose proof (Rabs_triang_inv (IZR (bits n) * P) N) as H1; pose proof (Rabs_triang_inv N (IZR (bits n) * P)) as H2.
    rewrite (Rabs_minus_sym (IZR (bits n) * P)) in H1; rewrite Hn in *; lra. }
  set (T := IZR size * (2 * M) / IZR b) in *.
  assert (HT : T * IZR b = IZR size * (2 * M)) by (unfold T; field; lra).
  assert (HT2 : 0 <= T <= 2 * M).
  { split; [apply Rmult_le_pos; [apply Rmult_le_pos; lra | apply Rlt_le, Rinv_0_lt_compat; lra]|].
    apply Rmult_le_reg_r with (IZR b); [lra|]; rewrite HT, Rmult_comm; apply Rmult_le_compat_l; lra. }
  assert (Habs : IZR (q - 10) * pw e <= Rabs N / W <= IZR (q + 10) * pw e).
  { rewrite minus_IZR, plus_IZR, Ee; split; apply Rmult_le_reg_r with W; auto.
    - replace (Rabs N / W * W) with (Rabs N) by (field; lra); apply Rle_trans with (2 := proj1 HA).
      destruct (Rle_or_lt (IZR q - 10) 0) as [Hneg|Hpos].
      + apply Rle_trans with 0; [|apply Rmult_le_pos; lra].
        assert (0 <= P / (2 * M * Pw) * W).
        { apply Rmult_le_pos; [apply Rmult_le_pos; [lra | apply Rlt_le, Rinv_0_lt_compat, Rmult_lt_0_compat; lra] | lra]. }
        rewrite Rmult_assoc, <- (Rmult_0_l (P / (2 * M * Pw) * W)); apply Rmult_le_compat_r; lra.
      + apply Rle_trans with ((IZR q - 10) * (P / (2 * M * Pw)) * ((IZR b + 1) * Pw)).
        * apply Rmult_le_compat_l; [|lra]; apply Rmult_le_pos; [lra|].
          apply Rmult_le_pos; [lra | apply Rlt_le, Rinv_0_lt_compat, Rmult_lt_0_compat; lra].
        * replace ((IZR q - 10) * (P / (2 * M * Pw)) * ((IZR b + 1) * Pw)) with ((IZR q - 10) * (IZR b + 1) / (2 * M) * P)
            by (field; split; lra); apply Rmult_le_compat_r; [lra|].
          apply Rmult_le_reg_r with (2 * M); [lra|]; unfold Rdiv; rewrite Rmult_assoc, Rinv_l, Rmult_1_r by lra.
          apply Rle_trans with ((T - 10) * (IZR b + 1)); [apply Rmult_le_compat_r; lra|]; lra.
    - replace (Rabs N / W * W) with (Rabs N) by (field; lra); apply Rle_trans with (1 := proj2 HA).
      apply Rle_trans with ((IZR q + 10) * (P / (2 * M * Pw)) * (IZR b * Pw)).
      + replace ((IZR q + 10) * (P / (2 * M * Pw)) * (IZR b * Pw)) with ((IZR q + 10) * IZR b / (2 * M) * P) by (field; split; lra).
        apply Rmult_le_compat_r; [lra|]; apply Rmult_le_reg_r with (2 * M); [lra|]; unfold Rdiv.
        rewrite (Rmult_assoc _ (/ (2 * M))), Rinv_l, Rmult_1_r by lra.
        apply Rle_trans with ((T + 9) * IZR b); [lra | apply Rmult_le_compat_r; lra].
      + apply Rmult_le_compat_l; [|lra]; apply Rmult_le_pos; [lra|].
        apply Rmult_le_pos; [lra | apply Rlt_le, Rinv_0_lt_compat, Rmult_lt_0_compat; lra]. }
  (* The sign. *)
  assert (HNs : if (bits n <? 0)%Z then N < 0 else 0 < N).
  { destruct (Z.ltb_spec (bits n) 0) as [Hlt|Hge].
    - assert (E : IZR (bits n) = - IZR size) by (rewrite <- opp_IZR; f_equal; unfold size; lia); rewrite E in HN.
      apply Rabs_le_inv in HN; assert (4 * P < IZR size * P) by (apply Rmult_lt_compat_r; lra); lra.
    - assert (E : IZR (bits n) = IZR size) by (f_equal; unfold size; lia); rewrite E in HN.
      apply Rabs_le_inv in HN; assert (4 * P < IZR size * P) by (apply Rmult_lt_compat_r; lra); lra. }
  assert (HWs : if (mw <? 0)%Z then dyadic mw ew < 0 else 0 < dyadic mw ew).
  { pose proof (bpow_gt_0 radix2 ew); unfold dyadic; destruct (Z.ltb_spec mw 0) as [Hlt|Hge].
    - apply IZR_lt in Hlt; rewrite <- (Rmult_0_l (pw ew)); apply Rmult_lt_compat_r; lra.
    - assert (0 < IZR mw) by (apply IZR_lt; lia); apply Rmult_lt_0_compat; lra. }
  assert (Hv : N / dyadic mw ew = (if xorb (bits n <? 0)%Z (mw <? 0)%Z then -1 else 1) * (Rabs N / W)).
  { unfold W; destruct (bits n <? 0)%Z, (mw <? 0)%Z; cbn [xorb]; unfold Rabs; repeat destruct Rcase_abs; try lra; field; lra. }
  rewrite Hv; set (lo := IZR (q - 10) * pw e) in *; set (hi := IZR (q + 10) * pw e) in *.
  destruct xorb; unfold Rmin, Rmax; repeat destruct Rle_dec; lra.
Qed.

(** What the quick path says is what every value between the ends rounds to. *)
Theorem quick_is_right round mx ex my ey md ed mw ew out : (forall a b, a <= b -> round a <= round b) -> (0 <= md)%Z -> mw <> 0%Z ->
  ((my = 0 \/ md = 0)%Z -> mx <> 0%Z) -> quick round mx ex my ey md ed mw ew = Some out ->
  out = round ((dyadic mx ex + dyadic my ey * sqrt (dyadic md ed)) / dyadic mw ew).
Proof.
  intros Hmono Hmd Hmw Hmx; unfold quick; destruct (numerator_near mx ex my ey md ed Hmd Hmx) as [Hsize HN].
  destruct (ends _ mw ew) as [[one other]|] eqn:Ee; [|discriminate].
  destruct (Req_bool_spec (round one) (round other)) as [E|]; [|discriminate]; intros [= <-].
  destruct (ends_around _ mw ew _ one other Hmw Hsize HN Ee) as [Hlo Hhi]; apply Hmono in Hlo, Hhi.
  assert (Hmin : round (Rmin one other) = round one) by (unfold Rmin; destruct Rle_dec; auto).
  assert (Hmax : round (Rmax one other) = round one) by (unfold Rmax; destruct Rle_dec; auto).
  rewrite Hmin in Hlo; rewrite Hmax in Hhi; lra.
Qed.
