(** * InstanceDyadic: what is computed of dyadic numbers, step by step

    The terms of Formas.v, of numbers: each operation is exact here, and a rounding is computed as binary64 does. A term is
    computed from inside, and what a let names once: a proof is as long as the computation.

    D n e         == the number n*2^e;  float_of n e == it, rounded to binary64;  parts x == the integers of a finite x
    exact         == what needs no rounding;  added, sign_of == of a sum, the integer, and the sign of a difference
    less, at_most == a comparison of reals, by one that is computed
    computes      == the tactic: it proves t = ?r, for a term t of numbers, booleans or records of both, and finds r *)
From Coq Require Import ZArith Reals List Bool Lia Lra.
From Flocq Require Import Core BinarySingleNaN.
From Durero Require Import Rounding Vectors.
From Durero Require Exacto Formas.
Local Open Scope R_scope.
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

Lemma less x y : Rlt_bool x y = true -> x < y.
Proof. intros H; destruct (Rlt_bool_spec x y); [assumption | discriminate]. Qed.
Lemma at_most x y : Rle_bool x y = true -> x <= y.
Proof. intros H; destruct (Rle_bool_spec x y); [assumption | discriminate]. Qed.

(** ** A term, from inside

    Its functions are unfolded by cbv beta delta before: unfold would put what a let names wherever it is used. *)

Lemma integer n : IZR n = D n 0.
Proof. unfold D; cbn; ring. Qed.
Lemma power e : bpow radix2 e = D 1 e.
Proof. unfold D; ring. Qed.
Lemma half n : Exacto.over 2 n = D n (-1).
Proof. reflexivity. Qed.

Lemma of_rnd x n e m f : x = D n e -> parts (float_of n e) = Some (m, f) -> rnd x = D m f.
Proof. intros ->; apply rounded. Qed.
Lemma of_root x n e m f : x = D n e -> exact n e && (0 <=? n)%Z = true -> parts (Bsqrt mode_NE (float_of n e)) = Some (m, f) ->
  rnd (sqrt x) = D m f.
Proof. intros -> H; apply andb_true_iff in H as [H K]; now apply rooted. Qed.
Lemma of_ratio x y n e m f k l : x = D n e -> y = D m f -> exact n e && exact m f && negb (m =? 0)%Z = true ->
  parts (Bdiv mode_NE (float_of n e) (float_of m f)) = Some (k, l) -> rnd (x / y) = D k l.
Proof. intros -> -> H; rewrite !andb_true_iff, negb_true_iff in H; destruct H as [[H K] N]; now apply divided. Qed.
Lemma of_sum x y n e m f k l : x = D n e -> y = D m f -> added n e m f = k -> Z.min e f = l -> x + y = D k l.
Proof. intros -> ->; apply D_plus. Qed.
Lemma of_difference x y n e m f k l : x = D n e -> y = D m f -> added n e (- m) f = k -> Z.min e f = l -> x - y = D k l.
Proof. intros -> ->; apply D_minus. Qed.
Lemma of_product x y n e m f k l : x = D n e -> y = D m f -> (n * m)%Z = k -> (e + f)%Z = l -> x * y = D k l.
Proof. intros -> ->; apply D_mult. Qed.
Lemma of_opposite x n e m : x = D n e -> (- n)%Z = m -> - x = D m e.
Proof. intros ->; apply D_opp. Qed.
Lemma of_size x n e m : x = D n e -> Z.abs n = m -> Rabs x = D m e.
Proof. intros ->; apply D_abs. Qed.
Lemma of_less x y n e m f b : x = D n e -> y = D m f -> (sign_of n e m f <? 0)%Z = b -> Rlt_bool x y = b.
Proof. intros -> ->; apply D_ltb. Qed.
Lemma of_at_most x y n e m f b : x = D n e -> y = D m f -> (sign_of n e m f <=? 0)%Z = b -> Rle_bool x y = b.
Proof. intros -> ->; apply D_leb. Qed.
Lemma of_equal x y n e m f b : x = D n e -> y = D m f -> (sign_of n e m f =? 0)%Z = b -> Req_bool x y = b.
Proof. intros -> ->; apply D_eqb. Qed.
Lemma of_if {T} (c d : bool) (x y r : T) : c = d -> (if d then x else y) = r -> (if c then x else y) = r.
Proof. now intros ->. Qed.
Lemma of_let {S T} (x y : S) (f : S -> T) r : x = y -> f y = r -> (let z := x in f z) = r.
Proof. now intros ->. Qed.
Lemma of_call {S T} (f : S -> T) x y r : x = y -> f y = r -> f x = r.
Proof. now intros ->. Qed.
Lemma of_call2 {S S' T} (f : S -> S' -> T) x y x' y' r : x = x' -> y = y' -> f x' y' = r -> f x y = r.
Proof. now intros -> ->. Qed.
Lemma of_quadratic {T} (A A' B B' C C' F F' H H' : T) A_error A_error' B_error B_error' C_error C_error' s0 s0' s1 s1' h h' r r' v v' m m' e e' :
  A = A' -> B = B' -> C = C' -> F = F' -> H = H' -> A_error = A_error' -> B_error = B_error' -> C_error = C_error' -> s0 = s0' ->
  s1 = s1' -> h = h' -> r = r' -> v = v' -> m = m' -> e = e' ->
  Formas.Quadratic A B C F H A_error B_error C_error s0 s1 h r v m e =
  Formas.Quadratic A' B' C' F' H' A_error' B_error' C_error' s0' s1' h' r' v' m' e'.
Proof. now intros -> -> -> -> -> -> -> -> -> -> -> -> -> -> ->. Qed.
Lemma of_stable {T} b b' (x x' : T) q q' : b = b' -> x = x' -> q = q' -> Formas.Stable b x q = Formas.Stable b' x' q'.
Proof. now intros -> -> ->. Qed.
Lemma of_point t x y z c t' x' y' z' c' : t = t' -> x = x' -> y = y' -> z = z' -> c = c' ->
  Formas.Pairs.Once_point t x y z c = Formas.Pairs.Once_point t' x' y' z' c'.
Proof. now intros -> -> -> -> ->. Qed.

Ltac valued := lazymatch goal with |- ?a = ?r => let v := eval vm_compute in a in unify r v; vm_cast_no_check (eq_refl v) end.
Ltac projected := cbv beta iota delta [cx cy cz Formas.A Formas.B Formas.C Formas.F Formas.H Formas.A_error Formas.B_error Formas.C_error
  Formas.value Formas.error Formas.positive Formas.signed_root Formas.q Formas.Pairs.hi Formas.Pairs.lo].
Ltac computes := lazymatch goal with
  | |- (let x := ?a in @?f x) = _ => refine (of_let a _ f _ _ _); [computes | cbv beta; computes]
  | |- rnd (sqrt _) = _ => eapply of_root; [computes | vm_cast_no_check (eq_refl true) | valued]
  | |- rnd (_ / _) = _ => eapply of_ratio; [computes | computes | vm_cast_no_check (eq_refl true) | valued]
  | |- rnd _ = _ => eapply of_rnd; [computes | valued]
  | |- D _ _ = _ => reflexivity
  | |- IZR _ = _ => apply integer
  | |- bpow radix2 _ = _ => apply power
  | |- Exacto.over 2 _ = _ => apply half
  | |- _ + _ = _ => eapply of_sum; [computes | computes | valued | valued]
  | |- _ - _ = _ => eapply of_difference; [computes | computes | valued | valued]
  | |- _ * _ = _ => eapply of_product; [computes | computes | valued | valued]
  | |- - _ = _ => eapply of_opposite; [computes | valued]
  | |- Rabs _ = _ => eapply of_size; [computes | valued]
  | |- Rlt_bool _ _ = _ => eapply of_less; [computes | computes | valued]
  | |- Rle_bool _ _ = _ => eapply of_at_most; [computes | computes | valued]
  | |- Req_bool _ _ = _ => eapply of_equal; [computes | computes | valued]
  | |- (if _ then _ else _) = _ => eapply of_if; [computes | cbv iota; computes]
  | |- true = _ => reflexivity
  | |- false = _ => reflexivity
  | |- andb _ _ = _ => eapply of_call2; [computes | computes | cbv beta iota delta [andb]; reflexivity]
  | |- orb _ _ = _ => eapply of_call2; [computes | computes | cbv beta iota delta [orb]; reflexivity]
  | |- eqb _ _ = _ => eapply of_call2; [computes | computes | cbv beta iota delta [eqb]; reflexivity]
  | |- negb _ = _ => eapply of_call; [computes | cbv beta iota delta [negb]; reflexivity]
  | |- Formas.Pairs.Twofold _ _ = _ => eapply of_call2; [computes | computes | reflexivity]
  | |- Formas.Quadratic _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ = _ => apply of_quadratic; computes
  | |- Formas.Stable _ _ _ = _ => apply of_stable; computes
  | |- Formas.Pairs.Once_point _ _ _ _ _ = _ => apply of_point; computes
  | |- Formas.Known _ _ = _ => eapply of_call2; [computes | computes | reflexivity]
  end.
