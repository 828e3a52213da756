(** * InstancesNumbers: instances of the theorems about computed numbers

    It goes on from Instances.v, and tests/proofs/audit.sh reads it in the same way. The numbers are dyadic; what is computed of
    them is computed here, each operation rounded as binary64 is.

    D n e        == the number n*2^e
    rounded n e  == it, rounded, where it is one of binary64's range; root n e, ratio n e m f, of its root and of a quotient *)
From Coq Require Import ZArith Reals List Bool Lia Lra.
From Flocq Require Import Core BinarySingleNaN.
From Durero Require Import Toolkit Especificacion Rounding Vectors.
From Durero Require Slab Limits Flotante Formas Decision Twofold Sums Words Quick Exactly Beams Main MainModels Instances.
Import ListNotations.
Local Open Scope R_scope.
Local Open Scope zed_scope.
Local Instance prec53 : Prec_gt_0 53 := eq_refl.
Local Instance below1024 : Prec_lt_emax 53 1024 := eq_refl.

Definition D (n e : Z) : R := IZR n * bpow radix2 e.

Notation binary64 := (binary_float 53 1024).
Definition float_of (n e : Z) : binary64 := binary_normalize 53 1024 _ _ mode_NE n e false.
Definition parts {prec emax} (x : binary_float prec emax) : option (Z * Z) :=
  match x with
  | B754_zero _ => Some (0, 0)%Z
  | B754_finite sign m e _ => Some (cond_Zopp sign (Zpos m), e)
  | _ => None
  end.

Lemma parts_are {prec emax} (x : binary_float prec emax) n e : parts x = Some (n, e) -> is_finite x = true /\ B2R x = D n e.
Proof.
  destruct x as [| | | sign m e' H]; try discriminate; cbn [parts]; intros [= <- <-]; split; try reflexivity; unfold D; cbn [B2R].
  ring.
Qed.

Lemma rounded n e m f : parts (float_of n e) = Some (m, f) -> rnd (D n e) = D m f.
Proof.
  intros H; apply parts_are in H as [F E]; pose proof (binary_normalize_correct 53 1024 _ _ mode_NE n e false) as C; cbv zeta in C.
  change (F2R (Float radix2 n e)) with (D n e) in C; fold (float_of n e) in C.
  change (round radix2 (SpecFloat.fexp 53 1024) (round_mode mode_NE) (D n e)) with (rnd (D n e)) in C.
  destruct (Rlt_bool _ _); [rewrite <- E; symmetry; apply C|]; exfalso; unfold binary_overflow in C; cbn in C.
  destruct (float_of n e); discriminate.
Qed.

(** What is one already: the sides of a test say so. *)
Definition exact (n e : Z) : bool := (Z.abs n <? 2 ^ 53)%Z && (-1074 <=? e)%Z && (e <=? 900)%Z.
Lemma exact_format n e : exact n e = true -> format (D n e).
Proof.
  unfold exact; rewrite !andb_true_iff, Z.ltb_lt, !Z.leb_le; intros [[A B] _]; apply generic_format_FLT.
  exists (Float radix2 n e); [reflexivity | exact A | exact B].
Qed.
Lemma exact_float n e : exact n e = true -> is_finite (float_of n e) = true /\ B2R (float_of n e) = D n e.
Proof.
  intros H; pose proof (exact_format n e H) as F; revert H; unfold exact; rewrite !andb_true_iff, Z.ltb_lt, !Z.leb_le; intros [[A B] K].
  pose proof (binary_normalize_correct 53 1024 _ _ mode_NE n e false) as C; cbv zeta in C.
  change (F2R (Float radix2 n e)) with (D n e) in C; fold (float_of n e) in C.
  change (round radix2 (SpecFloat.fexp 53 1024) (round_mode mode_NE) (D n e)) with (rnd (D n e)) in C.
  rewrite (round_generic radix2 fexp ZnearestE) in C by (auto with typeclass_instances).
  rewrite Rlt_bool_true in C; [tauto|]; unfold D; rewrite Rabs_mult, (Rabs_pos_eq (bpow radix2 e)) by apply bpow_ge_0; rewrite <- abs_IZR.
  apply IZR_lt in A; change (2 ^ 53)%Z with (Zpower radix2 53) in A; rewrite IZR_Zpower in A by lia.
  apply Rlt_le_trans with (bpow radix2 53 * bpow radix2 e); [apply Rmult_lt_compat_r; [apply bpow_gt_0 | exact A]|].
  rewrite <- bpow_plus; apply bpow_le; lia.
Qed.

Lemma rooted n e m f : exact n e = true -> (0 <=? n)%Z = true -> parts (Bsqrt mode_NE (float_of n e)) = Some (m, f) ->
  rnd (sqrt (D n e)) = D m f.
Proof.
  intros X _ H; apply parts_are in H as [_ E]; apply exact_float in X as [_ X].
  pose proof (Bsqrt_correct 53 1024 _ _ mode_NE (float_of n e)) as [C _]; rewrite X, E in C; symmetry; exact C.
Qed.
Lemma divided n e m f k l : exact n e = true -> exact m f = true -> (m =? 0)%Z = false ->
  parts (Bdiv mode_NE (float_of n e) (float_of m f)) = Some (k, l) -> rnd (D n e / D m f) = D k l.
Proof.
  intros X Y N H; apply parts_are in H as [F E]; apply exact_float in X as [_ X], Y as [_ Y]; apply Z.eqb_neq in N.
  assert (Z0 : B2R (float_of m f) <> 0).
  { rewrite Y; unfold D; apply Rmult_integral_contrapositive; split; [apply not_0_IZR, N | apply Rgt_not_eq, bpow_gt_0]. }
  pose proof (Bdiv_correct 53 1024 _ _ mode_NE (float_of n e) (float_of m f) Z0) as C; rewrite X, Y in C.
  change (round radix2 (SpecFloat.fexp 53 1024) (round_mode mode_NE) (D n e / D m f)) with (rnd (D n e / D m f)) in C.
  destruct (Rlt_bool _ _); [rewrite <- E; symmetry; apply C|]; exfalso; unfold binary_overflow in C; cbn in C.
  destruct (Bdiv mode_NE (float_of n e) (float_of m f)); discriminate.
Qed.

(** ** Exact operations, and comparisons *)

Definition lowered (n e k : Z) : Z := (n * 2 ^ (e - k))%Z.
Lemma lowered_is n e k : (k <= e)%Z -> D n e = D (lowered n e k) k.
Proof.
  intros H; unfold D, lowered; rewrite mult_IZR; change (2 ^ (e - k))%Z with (Zpower radix2 (e - k)); rewrite IZR_Zpower by lia.
  rewrite Rmult_assoc, <- bpow_plus; do 2 f_equal; lia.
Qed.
Definition added (n e m f : Z) : Z := let k := Z.min e f in (lowered n e k + lowered m f k)%Z.
Lemma D_plus n e m f k l : added n e m f = k -> Z.min e f = l -> D n e + D m f = D k l.
Proof.
  intros <- <-; rewrite (lowered_is n e (Z.min e f)), (lowered_is m f (Z.min e f)) by lia; unfold D, added; rewrite plus_IZR; ring.
Qed.
Lemma D_opp n e m : (- n)%Z = m -> - D n e = D m e.
Proof. intros <-; unfold D; rewrite opp_IZR; ring. Qed.
Lemma D_minus n e m f k l : added n e (- m) f = k -> Z.min e f = l -> D n e - D m f = D k l.
Proof. intros H K; unfold Rminus; rewrite (D_opp m f _ eq_refl); now apply D_plus. Qed.
Lemma D_mult n e m f k l : (n * m)%Z = k -> (e + f)%Z = l -> D n e * D m f = D k l.
Proof. intros <- <-; unfold D; rewrite mult_IZR, bpow_plus; ring. Qed.
Lemma D_abs n e m : Z.abs n = m -> Rabs (D n e) = D m e.
Proof. intros <-; unfold D; rewrite Rabs_mult, (Rabs_pos_eq (bpow radix2 e)), abs_IZR by apply bpow_ge_0; reflexivity. Qed.

Definition sign_of (n e m f : Z) : Z := added n e (- m) f.
Lemma sign_is n e m f : D n e - D m f = IZR (sign_of n e m f) * bpow radix2 (Z.min e f).
Proof. exact (D_minus n e m f _ _ eq_refl eq_refl). Qed.
Lemma D_lt n e m f : (sign_of n e m f <? 0)%Z = true -> D n e < D m f.
Proof.
  rewrite Z.ltb_lt; intros H; apply IZR_lt in H; pose proof (sign_is n e m f) as E; pose proof (bpow_gt_0 radix2 (Z.min e f)) as P.
  assert (IZR (sign_of n e m f) * bpow radix2 (Z.min e f) < 0 * bpow radix2 (Z.min e f)) by now apply Rmult_lt_compat_r. lra.
Qed.
Lemma D_le n e m f : (sign_of n e m f <=? 0)%Z = true -> D n e <= D m f.
Proof.
  rewrite Z.leb_le; intros H; apply IZR_le in H; pose proof (sign_is n e m f) as E; pose proof (bpow_gt_0 radix2 (Z.min e f)) as P.
  assert (IZR (sign_of n e m f) * bpow radix2 (Z.min e f) <= 0 * bpow radix2 (Z.min e f)) by (apply Rmult_le_compat_r; lra). lra.
Qed.

Lemma D_ltb n e m f b : (sign_of n e m f <? 0)%Z = b -> Rlt_bool (D n e) (D m f) = b.
Proof.
  intros <-; destruct (Z.ltb_spec (sign_of n e m f) 0) as [H|H]; [apply Rlt_bool_true, D_lt; now apply Z.ltb_lt|].
  apply Rlt_bool_false; apply IZR_le in H; pose proof (sign_is n e m f) as E.
  pose proof (Rmult_le_pos _ _ H (bpow_ge_0 radix2 (Z.min e f))). lra.
Qed.
Lemma D_leb n e m f b : (sign_of n e m f <=? 0)%Z = b -> Rle_bool (D n e) (D m f) = b.
Proof.
  intros <-; destruct (Z.leb_spec (sign_of n e m f) 0) as [H|H]; [apply Rle_bool_true, D_le; now apply Z.leb_le|].
  apply Rle_bool_false; apply IZR_lt in H; pose proof (sign_is n e m f) as E.
  pose proof (Rmult_lt_0_compat _ _ H (bpow_gt_0 radix2 (Z.min e f))). lra.
Qed.
Lemma D_eqb n e m f b : (sign_of n e m f =? 0)%Z = b -> Req_bool (D n e) (D m f) = b.
Proof.
  intros <-; pose proof (sign_is n e m f) as E; destruct (Z.eqb_spec (sign_of n e m f) 0) as [H|H].
  - apply Req_bool_true; rewrite H, Rmult_0_l in E; lra.
  - apply Req_bool_false; intros K; rewrite K, Rminus_eq_0 in E; symmetry in E; apply Rmult_integral in E as [E|E].
    + now apply eq_IZR in E.
    + pose proof (bpow_gt_0 radix2 (Z.min e f)); lra.
Qed.

(** One step of a computation: what is innermost is replaced by its value. *)
Ltac value t := eval vm_compute in t.
Ltac rounded_step n e := let w := value (parts (float_of n e)) in
  match w with Some (?m, ?f) => rewrite (rounded n e m f) by (vm_compute; reflexivity) end.
Ltac compute_step := match goal with
  | |- context [rnd (D ?n ?e)] => rounded_step n e
  | |- context [rnd (sqrt (D ?n ?e))] => let w := value (parts (Bsqrt mode_NE (float_of n e))) in
      match w with Some (?m, ?f) => rewrite (rooted n e m f) by (vm_compute; reflexivity) end
  | |- context [rnd (D ?n ?e / D ?m ?f)] => let w := value (parts (Bdiv mode_NE (float_of n e) (float_of m f))) in
      match w with Some (?k, ?l) => rewrite (divided n e m f k l) by (vm_compute; reflexivity) end
  | |- context [D ?n ?e + D ?m ?f] => let k := value (added n e m f) in let l := value (Z.min e f) in rewrite (D_plus n e m f k l eq_refl eq_refl)
  | |- context [D ?n ?e - D ?m ?f] =>
      let k := value (added n e (- m) f) in let l := value (Z.min e f) in rewrite (D_minus n e m f k l eq_refl eq_refl)
  | |- context [D ?n ?e * D ?m ?f] => let k := value (n * m)%Z in let l := value (e + f)%Z in rewrite (D_mult n e m f k l eq_refl eq_refl)
  | |- context [- D ?n ?e] => let m := value (- n)%Z in rewrite (D_opp n e m eq_refl)
  | |- context [Rabs (D ?n ?e)] => let m := value (Z.abs n) in rewrite (D_abs n e m eq_refl)
  | |- context [Rlt_bool (D ?n ?e) (D ?m ?f)] => let b := value (sign_of n e m f <? 0)%Z in rewrite (D_ltb n e m f b eq_refl)
  | |- context [Rle_bool (D ?n ?e) (D ?m ?f)] => let b := value (sign_of n e m f <=? 0)%Z in rewrite (D_leb n e m f b eq_refl)
  | |- context [Req_bool (D ?n ?e) (D ?m ?f)] => let b := value (sign_of n e m f =? 0)%Z in rewrite (D_eqb n e m f b eq_refl)
  end.
Lemma integer n : IZR n = D n 0.
Proof. unfold D; cbn; ring. Qed.
Lemma power e : bpow radix2 e = D 1 e.
Proof. unfold D; ring. Qed.
Ltac as_dyadic := rewrite ?power; repeat match goal with |- context [IZR ?n] => rewrite (integer n) end.
Ltac computed := as_dyadic; repeat (compute_step; cbn [andb orb eqb negb]).

(** ** Rays and a sphere: from (-3, y, 0) along x, around the origin, of radius 1 *)

Definition from (y : Z) : vec := Vec (IZR (-3)) (IZR y) (IZR 0).
Definition along_x : vec := Vec (IZR 1) (IZR 0) (IZR 0).
Definition origin : vec := Vec (IZR 0) (IZR 0) (IZR 0).
Lemma integer_is_ordinary n : (Z.abs n <=? 16)%Z = true -> Flotante.ordinary (IZR n).
Proof.
  intros H; replace (IZR n) with (Exacto.over 2 (2 * n)) by (unfold Exacto.over; rewrite mult_IZR; lra).
  apply InstanceSearch.small_is_ordinary; unfold InstanceSearch.small; apply Z.leb_le in H; apply Z.leb_le; lia.
Qed.
Lemma from_is_ordinary y : (Z.abs y <=? 16)%Z = true -> Flotante.ordinary_vec (from y).
Proof. intros H; split; [|split]; now apply integer_is_ordinary. Qed.
Lemma along_x_is_ordinary : Flotante.ordinary_vec along_x.
Proof. split; [|split]; now apply integer_is_ordinary. Qed.
Lemma origin_is_ordinary : Flotante.ordinary_vec origin.
Proof. split; [|split]; now apply integer_is_ordinary. Qed.
Lemma along_x_is_a_direction : 0 < norm along_x.
Proof. apply sqrt_lt_R0; unfold dot, along_x; cbn; lra. Qed.
Notation speed := (Formas.speed_of along_x).
Notation sphere y := (Formas.esfera (from y) along_x speed origin (IZR 1)).
Ltac of_a_quadratic := unfold Decision.has_roots, Decision.total, Decision.root_of_D, Formas.stable_sum, Formas.root_of_discriminant,
  Formas.esfera, Formas.speed_of, from, along_x, origin; cbv zeta;
  cbn [Formas.A Formas.B Formas.C Formas.F Formas.H Formas.A_error Formas.B_error Formas.C_error Formas.q Formas.value Formas.error
    Formas.positive Formas.signed_root cx cy cz]; computed.
Lemma four_passes : Formas.F (sphere 4) < - Formas.B_error (sphere 4).
Proof. of_a_quadratic; apply D_lt; vm_compute; reflexivity. Qed.
Lemma zero_meets : Formas.B_error (sphere 0) < Formas.F (sphere 0).
Proof. of_a_quadratic; apply D_lt; vm_compute; reflexivity. Qed.
Notation of_the_sphere theorem y := (theorem (from y) along_x origin (IZR 1) (from_is_ordinary y eq_refl) along_x_is_ordinary
  origin_is_ordinary (integer_is_ordinary 1 eq_refl) (IZR_lt 0 1 eq_refl) along_x_is_a_direction) (only parsing).
Definition instance_of_a_certified_miss_is_a_miss := of_the_sphere Main.a_certified_miss_is_a_miss 4%Z 3 four_passes.
Definition instance_of_a_certified_root_of_the_discriminant := of_the_sphere Main.a_certified_root_of_the_discriminant 0%Z zero_meets.
Definition instance_of_the_decision_on_a_sphere_is_right := of_the_sphere Main.the_decision_on_a_sphere_is_right 0%Z.

(** ** Double-double *)

Lemma five_is_a_word : Sums.double_word (Formas.Pairs.exactly 5).
Proof. exact (proj1 (Sums.exactly_word 5 Instances.five_is_binary64)). Qed.
Definition instance_of_double_doubles_are_within_their_bounds :=
  Main.double_doubles_are_within_their_bounds _ _ five_is_a_word five_is_a_word.
