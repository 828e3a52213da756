(** * Products: what a product of double-doubles loses

    Formas.Pairs.product, of src/trace/double_double-inl.hpp. The leading parts' product is kept whole; what is lost are
    at most four roundings of each lower part, and the lower parts are together hardly more than 3u of the product.

    worthy x      == x is 0, or not so small that what is lost of it underflows
    product_by    == the product with a binary64, as a quotient and a square root ask for it *)
From Coq Require Import Reals ZArith Lra Lia Psatz.
From Flocq Require Import Core Mult_error.
From Durero Require Import Rounding Twofold Sums.
From Durero Require Formas.
Import Formas.Pairs.
Local Open Scope R_scope.
Local Opaque bpow.

Definition worthy (x : R) : Prop := x = 0 \/ bpow radix2 (-960) <= Rabs x.

Lemma sixteen_u_u : bpow radix2 (-102) = 16 * (u * u).
Proof. replace 16 with (bpow radix2 4) by reflexivity; now rewrite <- !bpow_plus. Qed.

(** The least of all binary64 is little beside u² of what is worthy. *)
Lemma tiny_part x : bpow radix2 (-960) <= x -> 0 <= tiny <= / 200 * (u * (u * x)).
Proof.
  intros Hx; split; [apply bpow_ge_0|]; apply Rle_trans with (/ 200 * (u * (u * bpow radix2 (-960)))).
  - rewrite <- !bpow_plus; replace (-53 + (-53 + -960))%Z with (8 + -1074)%Z by reflexivity; rewrite bpow_plus.
    replace (bpow radix2 8) with 256 by reflexivity; pose proof (bpow_gt_0 radix2 (-1074)); lra.
  - pose proof u_bounds; apply Rmult_le_compat_l; [lra|]; do 2 (apply Rmult_le_compat_l; [lra|]); exact Hx.
Qed.

Lemma worthy_kept a b : format a -> format b -> worthy (a * b) -> let p := rnd (a * b) in
  format (a * b - p) /\ Rabs (a * b - p) <= u * Rabs (a * b) /\ rnd (a * b - p) = a * b - p.
Proof.
  intros Fa Fb W p; assert (F : format (a * b - p)).
  { replace (a * b - p) with (- (p - a * b)) by ring; apply generic_format_opp, mult_error_FLT; auto with typeclass_instances.
    - reflexivity.
    - intros N; destruct W as [Z0|W]; [contradiction|]; apply Rle_trans with (2 := W), bpow_le; lia. }
  split; [exact F | split; [|now apply rnd_format]]; rewrite Rabs_minus_sym; apply rnd_rel.
  destruct W as [Z0|W]; [now left | right]; apply Rle_trans with (2 := W), bpow_le; lia.
Qed.

(** A rounded product of which only the size is known. *)
Lemma lost_of_product a b m : Rabs a * Rabs b <= m -> Rabs (rnd (a * b) - a * b) <= u * m + tiny.
Proof.
  intros Hm; apply Rle_trans with (1 := rnd_any _); rewrite Rabs_mult; apply Rplus_le_compat_r.
  apply Rmult_le_compat_l; [apply bpow_ge_0 | exact Hm].
Qed.

Section Product.
Variables x y : twofold.
Hypothesis x_word : double_word x.
Hypothesis y_word : double_word y.
Hypothesis kept : worthy (hi x * hi y).

Let P := Rabs (hi x * hi y).
Let top := rnd (hi x * hi y).
Let rest := hi x * hi y - top.
Let c1 := rnd (hi x * lo y).
Let c2 := rnd (lo x * hi y).
Let c3 := rnd (c1 + c2).
Let c4 := rnd (lo x * lo y).
Let c5 := rnd (c4 + c3).
Let low := rnd (rest + c5).

Lemma product_is : product x y = fast_two_sum top low.
Proof.
  destruct x_word as (Fx & _), y_word as (Fy & _), (worthy_kept _ _ Fx Fy kept) as (_ & _ & E); fold top in E.
  unfold product; fold top c1 c2 c3 c4 c5; rewrite E; reflexivity.
Qed.

Lemma product_of_zero : hi x * hi y = 0 -> double_word (product x y) /\ whole (product x y) = 0 /\ whole x * whole y = 0.
Proof.
  intros Z0; destruct (double_word_is_pair x x_word) as (Fx & Flx & Lx), (double_word_is_pair y y_word) as (Fy & Fly & Ly).
  assert (Hlow : forall a b, Rabs b <= u * Rabs a -> a = 0 -> b = 0).
  { intros a b Hb Za; rewrite Za, Rabs_R0, Rmult_0_r in Hb; pose proof (Rabs_pos b).
    destruct (Req_dec b 0) as [|N]; [assumption | pose proof (Rabs_pos_lt b N); lra]. }
  assert (Hc : lo x * hi y = 0 /\ hi x * lo y = 0 /\ lo x * lo y = 0).
  { apply Rmult_integral in Z0 as [Zx|Zy]; [rewrite (Hlow _ _ Lx Zx), Zx | rewrite (Hlow _ _ Ly Zy), Zy]; repeat split; ring. }
  destruct Hc as (Z1 & Z2 & Z3); rewrite product_is.
  assert (Et : top = 0) by (unfold top; now rewrite Z0, rnd_0).
  assert (El : low = 0).
  { unfold low, rest, c5, c4, c3, c2, c1; rewrite Et, Z0, Z1, Z2, Z3.
    repeat (rewrite ?rnd_0, ?Rplus_0_r, ?Rminus_0_r); reflexivity. }
  rewrite Et, El; destruct (fast_two_sum_exact 0 0 (generic_format_0 _ _) (generic_format_0 _ _) (or_introl eq_refl)) as [_ E].
  split; [apply fast_two_sum_word; auto using generic_format_0 | split; [lra|]].
  unfold whole; replace ((hi x + lo x) * (hi y + lo y)) with (hi x * hi y + hi x * lo y + lo x * hi y + lo x * lo y) by ring; lra.
Qed.

Theorem product_kept : double_word (product x y) /\
  Rabs (whole (product x y) - whole x * whole y) <= 14 * (u * (u * Rabs (whole x * whole y))).
Proof.
  destruct kept as [Z0|HP]; [destruct (product_of_zero Z0) as (W & -> & ->); split; [exact W|];
    rewrite Rminus_0_r, Rabs_R0, !Rmult_0_r; lra|].
  destruct (double_word_is_pair x x_word) as (Fhx & Flx & Lx), (double_word_is_pair y y_word) as (Fhy & Fly & Ly).
  destruct (worthy_kept _ _ Fhx Fhy kept) as (Fe & He & _); fold top rest P in Fe, He; fold P in HP.
  assert (HP0 : 0 <= P) by apply Rabs_pos; pose proof (u_part P HP0) as HU; pose proof (u_part _ (proj1 HU)) as HUU.
  pose proof (u_part _ (proj1 HUU)) as HUUU; pose proof (tiny_part P HP) as Hz; set (z := tiny) in *.
  assert (HPxy : Rabs (hi x) * Rabs (hi y) = P) by (unfold P; now rewrite Rabs_mult).
  assert (B1 : Rabs (hi x) * Rabs (lo y) <= u * P).
  { rewrite <- HPxy; replace (u * (Rabs (hi x) * Rabs (hi y))) with (Rabs (hi x) * (u * Rabs (hi y))) by ring.
    apply Rmult_le_compat_l; [apply Rabs_pos | exact Ly]. }
  assert (B2 : Rabs (lo x) * Rabs (hi y) <= u * P).
  { rewrite <- HPxy, <- Rmult_assoc; apply Rmult_le_compat_r; [apply Rabs_pos | exact Lx]. }
  assert (B4 : Rabs (lo x) * Rabs (lo y) <= u * (u * P)).
  { apply Rle_trans with (u * Rabs (hi x) * Rabs (lo y)); [apply Rmult_le_compat_r; [apply Rabs_pos | exact Lx]|].
    rewrite Rmult_assoc; apply Rmult_le_compat_l; [apply bpow_ge_0 | exact B1]. }
  pose proof (lost_of_product _ _ _ B1) as E1; pose proof (lost_of_product _ _ _ B2) as E2.
  pose proof (lost_of_product _ _ _ B4) as E4; fold c1 z in E1; fold c2 z in E2; fold c4 z in E4.
  rewrite <- Rabs_mult in B1, B2, B4.
  assert (Hsize : forall a b e m, Rabs (a - b) <= e -> Rabs b <= m -> Rabs a <= m + e).
  { intros a b e m Ha Hb; replace a with (b + (a - b)) by ring; apply Rle_trans with (1 := Rabs_triang _ _); lra. }
  pose proof (Hsize _ _ _ _ E1 B1) as S1; pose proof (Hsize _ _ _ _ E2 B2) as S2; pose proof (Hsize _ _ _ _ E4 B4) as S4.
  assert (B3 : Rabs (c1 + c2) <= (2 + / 1000) * (u * P)) by (apply Rle_trans with (1 := Rabs_triang _ _); lra).
  pose proof (lost_of_sum c1 c2 _ (format_rnd _) (format_rnd _) B3) as E3; fold c3 in E3.
  pose proof (Hsize _ _ _ _ E3 B3) as S3.
  assert (B5 : Rabs (c4 + c3) <= (2 + / 500) * (u * P)) by (apply Rle_trans with (1 := Rabs_triang _ _); lra).
  pose proof (lost_of_sum c4 c3 _ (format_rnd _) (format_rnd _) B5) as E5; fold c5 in E5.
  pose proof (Hsize _ _ _ _ E5 B5) as S5.
  assert (B6 : Rabs (rest + c5) <= (3 + / 250) * (u * P)) by (apply Rle_trans with (1 := Rabs_triang _ _); lra).
  pose proof (lost_of_sum rest c5 _ Fe (format_rnd _) B6) as E6; fold low in E6.
  pose proof (Hsize _ _ _ _ E6 B6) as S6.
  assert (Htop : (1 - / 1000) * P <= Rabs top).
  { assert (P <= Rabs top + Rabs rest); [|lra].
    unfold P; replace (hi x * hi y) with (top + rest) by (unfold rest; ring); apply Rabs_triang. }
  assert (Hroom_low : Rabs low <= Rabs top) by lra.
  destruct (fast_two_sum_exact top low (format_rnd _) (format_rnd _) (or_intror Hroom_low)) as [_ Hw].
  rewrite product_is, Hw; split; [now apply (fast_two_sum_word top low (format_rnd _) (format_rnd _))|].
  assert (Hxy : (1 - / 1000) * P <= Rabs (whole x * whole y)).
  { assert (P <= Rabs (whole x * whole y) + (Rabs (lo x * lo y) + Rabs (hi x * lo y) + Rabs (lo x * hi y))); [|lra].
    unfold P; replace (hi x * hi y) with (whole x * whole y + - (lo x * lo y + hi x * lo y + lo x * hi y))
      by (unfold whole; ring); apply Rle_trans with (1 := Rabs_triang _ _); rewrite Rabs_Ropp; apply Rplus_le_compat_l.
    apply Rle_trans with (1 := Rabs_triang _ _); apply Rplus_le_compat_r, Rabs_triang. }
  assert (Huu : u * (u * ((1 - / 1000) * P)) <= u * (u * Rabs (whole x * whole y))).
  { pose proof u_bounds; apply Rmult_le_compat_l; [lra|]; apply Rmult_le_compat_l; lra. }
  apply Rle_trans with (Rabs (low - (rest + c5)) + (Rabs (c5 - (c4 + c3)) + (Rabs (c4 - lo x * lo y) +
    (Rabs (c3 - (c1 + c2)) + (Rabs (c1 - hi x * lo y) + Rabs (c2 - lo x * hi y)))))); [|lra].
  replace (top + low - whole x * whole y) with ((low - (rest + c5)) + ((c5 - (c4 + c3)) + ((c4 - lo x * lo y) +
    ((c3 - (c1 + c2)) + ((c1 - hi x * lo y) + (c2 - lo x * hi y)))))) by (unfold rest, whole; ring).
  repeat (apply Rle_trans with (1 := Rabs_triang _ _); apply Rplus_le_compat_l); lra.
Qed.
End Product.

(** Where nothing underflows. *)
Theorem product_near x y : double_word x -> double_word y -> worthy (hi x * hi y) -> double_word (product x y) /\
  Rabs (whole (product x y) - whole x * whole y) <= bpow radix2 (-102) * Rabs (whole x * whole y).
Proof.
  intros Hx Hy W; destruct (product_kept x y Hx Hy W) as [Hd Hn]; split; [exact Hd|]; rewrite sixteen_u_u, Rmult_assoc.
  pose proof (u_part _ (Rabs_pos (whole x * whole y))) as HU; pose proof (u_part _ (proj1 HU)); lra.
Qed.

(** ** A product with a binary64 *)

Definition product_by (y : twofold) (a : R) : twofold :=
  let high := two_prod (hi y) a in fast_two_sum (hi high) (rnd (lo high + rnd (lo y * a))).

Theorem product_by_near y a : double_word y -> format a -> bpow radix2 (-960) <= Rabs (hi y * a) ->
  double_word (product_by y a) /\ Rabs (whole (product_by y a) - whole y * a) <= (3 + / 10) * (u * (u * Rabs (hi y * a))).
Proof.
  intros Wy Fa HP; destruct (double_word_is_pair y Wy) as (Fh & Fl & L); set (P := Rabs (hi y * a)) in *.
  destruct (worthy_kept _ _ Fh Fa (or_intror HP)) as (Fe & He & E); fold P in He.
  unfold product_by, two_prod; cbn [hi lo]; rewrite E; set (top := rnd (hi y * a)) in *; set (rest := hi y * a - top) in *.
  assert (HP0 : 0 <= P) by apply Rabs_pos; pose proof (u_part P HP0) as HU; pose proof (u_part _ (proj1 HU)) as HUU.
  pose proof (tiny_part P HP) as Hz; assert (B1 : Rabs (lo y) * Rabs a <= u * P).
  { unfold P; rewrite Rabs_mult, <- Rmult_assoc; apply Rmult_le_compat_r; [apply Rabs_pos | exact L]. }
  pose proof (lost_of_product _ _ _ B1) as E1; rewrite <- Rabs_mult in B1; set (c := rnd (lo y * a)) in *; set (z := tiny) in *.
  assert (S1 : Rabs c <= (1 + / 1000) * (u * P)).
  { replace c with (lo y * a + (c - lo y * a)) by ring; apply Rle_trans with (1 := Rabs_triang _ _); lra. }
  assert (B2 : Rabs (rest + c) <= (2 + / 1000) * (u * P)) by (apply Rle_trans with (1 := Rabs_triang _ _); lra).
  pose proof (lost_of_sum rest c _ Fe (format_rnd _) B2) as E2; set (low := rnd (rest + c)) in *.
  assert (S2 : Rabs low <= 3 * (u * P)).
  { replace low with ((rest + c) + (low - (rest + c))) by ring; apply Rle_trans with (1 := Rabs_triang _ _); lra. }
  assert (Htop : (1 - / 1000) * P <= Rabs top).
  { assert (P <= Rabs top + Rabs rest); [|lra].
    unfold P; replace (hi y * a) with (top + rest) by (unfold rest; ring); apply Rabs_triang. }
  assert (Hroom_low : Rabs low <= Rabs top) by lra.
  destruct (fast_two_sum_exact top low (format_rnd _) (format_rnd _) (or_intror Hroom_low)) as [_ Hw].
  split; [apply fast_two_sum_word; [apply format_rnd | apply format_rnd | exact Hw]|]; rewrite Hw.
  replace (top + low - whole y * a) with ((low - (rest + c)) + (c - lo y * a)) by (unfold rest, whole; ring).
  apply Rle_trans with (1 := Rabs_triang _ _); lra.
Qed.
