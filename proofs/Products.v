(** * Products: what a product of double-doubles loses

    Formas.Pairs.product, of src/trace/double_double-inl.hpp. The leading parts' product is kept whole; what is lost are
    at most four roundings of each lower part, and the lower parts are together hardly more than 3u of the product. *)
From Coq Require Import Reals ZArith Lra Lia Psatz.
From Flocq Require Import Core.
From Durero Require Import Rounding Twofold.
From Durero Require Formas.
Import Formas.Pairs.
Local Open Scope R_scope.
Local Opaque bpow.

(** Nothing underflows: each partial product is an integer times 2^-969. *)
Definition products_kept (x y : twofold) : Prop :=
  grid (-969) (hi x * hi y) /\ grid (-969) (hi x * lo y) /\ grid (-969) (lo x * hi y) /\ grid (-969) (lo x * lo y).

Lemma near_wider n a x m m' : m <= m' -> near n a x m -> near n a x m'.
Proof.
  intros Hm [H Hx]; split; [|lra]; apply Rle_trans with (1 := H); apply Rmult_le_compat_l; [|exact Hm].
  pose proof (pow_ge_1 n); lra.
Qed.

Lemma near_product a b m : grid (-969) (a * b) -> Rabs a * Rabs b <= m -> near 1 (rnd (a * b)) (a * b) m.
Proof.
  intros G Hm; apply near_wider with (1 := Hm), (near_mult 0 0); [apply near_exact | apply near_exact|].
  apply (grid_normal (-969)); [lia | exact G].
Qed.

Theorem product_near x y : pair x -> pair y -> products_kept x y ->
  pair (product x y) /\ Rabs (whole (product x y) - whole x * whole y) <= bpow radix2 (-102) * Rabs (whole x * whole y).
Proof.
  intros (Fhx & Flx & Lx) (Fhy & Fly & Ly) (G & G1 & G2 & G3); unfold product.
  destruct (product_lacks _ _ Fhx Fhy G) as [Fe He]; rewrite (rnd_format _ Fe).
  set (top := rnd (hi x * hi y)) in *; set (e := hi x * hi y - top) in *.
  set (c1 := rnd (hi x * lo y)); set (c2 := rnd (lo x * hi y)); set (c4 := rnd (lo x * lo y)).
  set (c3 := rnd (c1 + c2)); set (c5 := rnd (c4 + c3)); set (low := rnd (e + c5)).
  pose proof u_bounds as Hu; set (P := Rabs (hi x * hi y)); assert (HP : 0 <= P) by apply Rabs_pos.
  assert (HuP : 0 <= u * P <= / 1000000000000 * P) by (split; [apply Rmult_le_pos | apply Rmult_le_compat_r]; lra).
  assert (HuuP : 0 <= u * (u * P) <= / 1000000000000 * (u * P)) by (split; [apply Rmult_le_pos | apply Rmult_le_compat_r]; lra).
  assert (Htop : Rabs e <= u * P).
  { rewrite <- Rabs_Ropp; replace (- e) with (top - hi x * hi y) by (unfold e; ring).
    apply rnd_rel, (grid_normal (-969)); [lia | exact G]. }
  assert (HPxy : Rabs (hi x) * Rabs (hi y) = P) by (unfold P; now rewrite Rabs_mult).
  assert (B1 : Rabs (hi x) * Rabs (lo y) <= u * P).
  { rewrite <- HPxy; replace (u * (Rabs (hi x) * Rabs (hi y))) with (Rabs (hi x) * (u * Rabs (hi y))) by ring.
    apply Rmult_le_compat_l; [apply Rabs_pos | exact Ly]. }
  assert (B2 : Rabs (lo x) * Rabs (hi y) <= u * P).
  { rewrite <- HPxy, <- Rmult_assoc; apply Rmult_le_compat_r; [apply Rabs_pos | exact Lx]. }
  assert (B3 : Rabs (lo x) * Rabs (lo y) <= u * (u * P)).
  { apply Rle_trans with (u * Rabs (hi x) * Rabs (lo y)); [apply Rmult_le_compat_r; [apply Rabs_pos | exact Lx]|].
    rewrite Rmult_assoc; apply Rmult_le_compat_l; lra. }
  assert (N3 : near 2 c3 (hi x * lo y + lo x * hi y) (u * P + u * P)).
  { apply near_plus; try apply format_rnd; now apply near_product. }
  assert (N5 : near 3 c5 (lo x * lo y + (hi x * lo y + lo x * hi y)) (u * (u * P) + (u * P + u * P))).
  { apply near_plus; try apply format_rnd; [|exact N3]; apply (near_more 1); [lia | now apply near_product]. }
  assert (N : near 4 low (e + (lo x * lo y + (hi x * lo y + lo x * hi y))) (u * P + (u * (u * P) + (u * P + u * P)))).
  { apply near_plus; [|exact N5 | exact Fe | apply format_rnd]; apply (near_more 0); [lia|].
    apply near_wider with (1 := Htop), near_exact. }
  pose proof (pow_bound_near 4 ltac:(lia)) as Hp; simpl INR in Hp; destruct N as [N Nm].
  set (m := u * P + (u * (u * P) + (u * P + u * P))) in *; assert (Hm : 0 <= m <= (3 + / 1000) * (u * P)) by (unfold m; lra).
  assert (Hlost : Rabs (low - (e + (lo x * lo y + (hi x * lo y + lo x * hi y)))) <= 13 * (u * (u * P))).
  { apply Rle_trans with (1 := N); apply Rle_trans with (1001 / 1000 * (1 + 1 + 1 + 1) * u * m); [apply Rmult_le_compat_r; lra|].
    assert (u * m <= u * ((3 + / 1000) * (u * P))) by (apply Rmult_le_compat_l; lra); lra. }
  assert (Htop_large : (1 - / 1000) * P <= Rabs top).
  { assert (P <= Rabs top + Rabs e); [|lra].
    unfold P; replace (hi x * hi y) with (top + e) by (unfold e; ring); apply Rabs_triang. }
  assert (Hlow : Rabs low <= Rabs top).
  { set (exact := e + (lo x * lo y + (hi x * lo y + lo x * hi y))) in *; replace low with ((low - exact) + exact) by ring.
    apply Rle_trans with (1 := Rabs_triang _ _); lra. }
  destruct (fast_two_sum_exact top low (format_rnd _) (format_rnd _) (or_intror Hlow)) as [Hpair Hw].
  unfold fast_two_sum in Hpair, Hw; split; [exact Hpair|]; rewrite Hw.
  replace (top + low - whole x * whole y) with (low - (e + (lo x * lo y + (hi x * lo y + lo x * hi y))))
    by (unfold e, whole; ring); apply Rle_trans with (1 := Hlost).
  assert (Hxy : (1 - / 1000) * P <= Rabs (whole x * whole y)).
  { assert (P <= Rabs (whole x * whole y) + (u * (u * P) + (u * P + u * P))).
    { unfold P at 1; replace (hi x * hi y) with (whole x * whole y + - (lo x * lo y + (hi x * lo y + lo x * hi y)))
        by (unfold whole; ring).
      apply Rle_trans with (1 := Rabs_triang _ _); rewrite Rabs_Ropp; apply Rplus_le_compat_l, (proj2 N5). }
    lra. }
  replace (bpow radix2 (-102)) with (16 * (u * u)) by
    (replace 16 with (bpow radix2 4) by reflexivity; now rewrite <- !bpow_plus).
  assert (u * (u * ((1 - / 1000) * P)) <= u * (u * Rabs (whole x * whole y))).
  { apply Rmult_le_compat_l; [lra|]; apply Rmult_le_compat_l; lra. }
  lra.
Qed.
