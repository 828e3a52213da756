(** * Words: the calculus of Rounding.v over double-double

    uu              == the bound of one operation of double-double, relative to its result
    near2 n a x m   == the pair a is computed for x, |x| <= m, with at most n operations
    worded n k a x m == so it is, a is what an operation returns, and both its parts are integers times 2^k
    dot2, norm2, …  == vectors of pairs, as src/trace/numbers-inl.hpp computes them *)
From Coq Require Import Reals ZArith Lra Lia Psatz.
From Flocq Require Import Core.
From Durero Require Import Rounding Vectors Twofold Sums Products Ratios.
From Durero Require Formas.
Import Formas.Pairs.
Local Open Scope R_scope.
Local Opaque bpow.

Notation uu := (bpow radix2 (-102)).
Notation e30 := (/ 1000000000000000000000000000000).

Lemma uu_bounds : 0 < uu <= e30.
Proof.
  split; [apply bpow_gt_0|]; replace (bpow radix2 (-102)) with (/ 5070602400912917605986812821504) by reflexivity; lra.
Qed.

Lemma uu_part x : 0 <= x -> 0 <= uu * x <= e30 * x.
Proof. intros Hx; pose proof uu_bounds; split; [apply Rmult_le_pos | apply Rmult_le_compat_r]; lra. Qed.

(** A bound in units of u², in those of uu. *)
Lemma in_uu k x : 0 <= x -> k * (u * (u * x)) = k / 16 * (uu * x).
Proof. intros _; rewrite sixteen_u_u; field. Qed.

Definition near2 (n : nat) (a : twofold) (x m : R) : Prop := Rabs (whole a - x) <= ((1 + uu) ^ n - 1) * m /\ Rabs x <= m.
Definition parts_on (k : Z) (a : twofold) : Prop := grid k (hi a) /\ grid k (lo a).
Definition worded (n : nat) (k : Z) (a : twofold) (x m : R) : Prop := near2 n a x m /\ double_word a /\ parts_on k a.

Lemma pow2_ge_1 n : 1 <= (1 + uu) ^ n.
Proof. apply pow_R1_Rle; pose proof uu_bounds; lra. Qed.

Lemma pow2_bound n : (n <= 64)%nat -> (1 + uu) ^ n - 1 <= 1001 / 1000 * INR n * uu.
Proof.
  pose proof uu_bounds; induction n as [|n IH]; intros Hn; [simpl; lra|].
  rewrite S_INR; simpl pow; specialize (IH ltac:(lia)); assert (0 <= INR n <= 64).
  { split; [apply pos_INR | replace 64 with (INR 64) by (simpl; lra); apply le_INR; lia]. }
  assert (INR n * uu <= 64 * / 1000000000000) by (apply Rmult_le_compat; lra).
  assert (1001 / 1000 * (INR n * uu) * uu <= / 1000 * uu) by (apply Rmult_le_compat_r; lra).
  assert ((1 + uu) * (1 + uu) ^ n <= (1 + uu) * (1 + 1001 / 1000 * INR n * uu)) by (apply Rmult_le_compat_l; lra); lra.
Qed.

Lemma near2_more n n' a x m : (n <= n')%nat -> near2 n a x m -> near2 n' a x m.
Proof.
  intros Hn [H Hm]; split; [|assumption]; apply Rle_trans with (1 := H); apply Rmult_le_compat_r.
  - apply Rle_trans with (2 := Hm), Rabs_pos.
  - pose proof uu_bounds; assert ((1 + uu) ^ n <= (1 + uu) ^ n') by (apply Rle_pow; lra || lia); lra.
Qed.

Lemma near2_size n a x m : near2 n a x m -> Rabs (whole a) <= (1 + uu) ^ n * m.
Proof.
  intros [H Hm]; replace (whole a) with ((whole a - x) + x) by ring; apply Rle_trans with (1 := Rabs_triang _ _); lra.
Qed.

(** One more operation, of the exact result y. *)
Lemma near2_step n a y x m : Rabs (y - x) <= ((1 + uu) ^ n - 1) * m -> Rabs x <= m ->
  Rabs (whole a - y) <= uu * Rabs y -> near2 (S n) a x m.
Proof.
  intros H Hm Hr; split; [|assumption].
  assert (Hs : Rabs y <= (1 + uu) ^ n * m).
  { replace y with ((y - x) + x) by ring; apply Rle_trans with (1 := Rabs_triang _ _); lra. }
  replace (whole a - x) with ((whole a - y) + (y - x)) by ring; apply Rle_trans with (1 := Rabs_triang _ _).
  pose proof uu_bounds; assert (uu * Rabs y <= uu * ((1 + uu) ^ n * m)) by (apply Rmult_le_compat_l; lra); simpl pow; lra.
Qed.

(** ** Grids *)

Lemma parts_two_sum k a b : (-1074 <= k)%Z -> format a -> format b -> grid k a -> grid k b -> parts_on k (two_sum a b).
Proof.
  intros Hk Fa Fb Ga Gb; rewrite two_sum_is by assumption; pose proof (grid_plus _ _ _ Ga Gb) as G.
  pose proof (grid_rnd k _ Hk G) as Gr; split; cbn [hi lo]; [exact Gr | now apply grid_plus, grid_opp].
Qed.

Lemma parts_fast k a b : (-1074 <= k)%Z -> grid k a -> grid k b -> parts_on k (fast_two_sum a b).
Proof.
  intros Hk Ga Gb; pose proof (grid_rnd k _ Hk (grid_plus _ _ _ Ga Gb)) as Gs; split; cbn [hi lo fast_two_sum]; [exact Gs|].
  apply grid_rnd; [exact Hk|]; apply grid_plus; [exact Gb|]; apply grid_opp, grid_rnd; [exact Hk|].
  now apply grid_plus, grid_opp.
Qed.

Lemma parts_opposite k x : parts_on k x -> parts_on k (opposite x).
Proof. intros [Gh Gl]; split; now apply grid_opp. Qed.

Lemma parts_sum k x y : (-1074 <= k)%Z -> double_word x -> double_word y -> parts_on k x -> parts_on k y ->
  parts_on k (sum x y).
Proof.
  intros Hk (Fx & Flx & _) (Fy & Fly & _) [Gx Glx] [Gy Gly].
  change (sum x y) with (let high := two_sum (hi x) (hi y) in let low := two_sum (lo x) (lo y) in
    let z := fast_two_sum (hi high) (rnd (lo high + hi low)) in fast_two_sum (hi z) (rnd (lo low + lo z))); cbv zeta.
  destruct (parts_two_sum k _ _ Hk Fx Fy Gx Gy) as [G1 G2], (parts_two_sum k _ _ Hk Flx Fly Glx Gly) as [G3 G4].
  destruct (parts_fast k _ (rnd (lo (two_sum (hi x) (hi y)) + hi (two_sum (lo x) (lo y)))) Hk G1
    (grid_rnd k _ Hk (grid_plus _ _ _ G2 G3))) as [G5 G6].
  apply parts_fast; [exact Hk | exact G5 | apply grid_rnd; [exact Hk | now apply grid_plus]].
Qed.

Lemma parts_product j k x y : (-960 <= j + k)%Z -> parts_on j x -> parts_on k y -> parts_on (j + k) (product x y).
Proof.
  intros Hk [Gx Glx] [Gy Gly]; assert (Hk' : (-1074 <= j + k)%Z) by lia.
  change (product x y) with (fast_two_sum (rnd (hi x * hi y)) (rnd (rnd (hi x * hi y - rnd (hi x * hi y)) +
    rnd (rnd (lo x * lo y) + rnd (rnd (hi x * lo y) + rnd (lo x * hi y)))))).
  pose proof (grid_rnd _ _ Hk' (grid_mult _ _ _ _ Gx Gy)) as G0.
  apply parts_fast; [exact Hk' | exact G0|]; apply grid_rnd; [exact Hk'|]; apply grid_plus.
  - apply grid_rnd; [exact Hk'|]; apply grid_plus; [now apply grid_mult | now apply grid_opp].
  - repeat (apply grid_rnd; [exact Hk'|]; try apply grid_plus); now apply grid_mult.
Qed.

Lemma grid_worthy k x : (-960 <= k)%Z -> grid k x -> worthy x.
Proof.
  intros Hk G; destruct (Req_dec x 0) as [Z0|N]; [now left | right].
  apply Rle_trans with (2 := grid_at_least _ _ G N); now apply bpow_le.
Qed.

(** ** Everything at once *)

Lemma worded_exactly k a : format a -> grid k a -> worded 0 k (exactly a) a (Rabs a).
Proof.
  intros Fa Ga; destruct (exactly_word a Fa) as [W E]; split; [|split; [exact W | split; [exact Ga | exists 0%Z; cbn; ring]]].
  unfold near2; rewrite E; simpl; rewrite Rminus_diag_eq, Rabs_R0 by reflexivity; split; [lra | apply Rle_refl].
Qed.

Lemma worded_difference_of k a b : (-1074 <= k)%Z -> format a -> format b -> grid k a -> grid k b ->
  worded 0 k (two_sum a (- b)) (a - b) (Rabs (a - b)).
Proof.
  intros Hk Fa Fb Ga Gb; pose proof (generic_format_opp _ _ _ Fb) as Fb'; destruct (two_sum_word a (- b) Fa Fb') as [W E].
  split; [|split; [exact W | apply parts_two_sum; auto; now apply grid_opp]].
  unfold near2; rewrite E; fold (a - b); simpl; rewrite Rminus_diag_eq, Rabs_R0 by reflexivity; split; [lra | apply Rle_refl].
Qed.

Lemma worded_more n n' k a x m : (n <= n')%nat -> worded n k a x m -> worded n' k a x m.
Proof. intros Hn (N & W); split; [now apply (near2_more n) | exact W]. Qed.

Lemma worded_coarser n j k a x m : (j <= k)%Z -> worded n k a x m -> worded n j a x m.
Proof. intros Hj (N & W & Gh & Gl); split; [exact N | split; [exact W | split; now apply (grid_coarser j k)]]. Qed.

Lemma worded_mult i j k l a b x y m m' : (-960 <= k + l)%Z -> worded i k a x m -> worded j l b y m' ->
  worded (S (i + j)) (k + l) (product a b) (x * y) (m * m').
Proof.
  intros Hk (Na & Wa & Pa) (Nb & Wb & Pb).
  destruct (product_near a b Wa Wb) as [W H]; [apply (grid_worthy (k + l)); [exact Hk | apply grid_mult; [apply Pa | apply Pb]]|].
  split; [|split; [exact W | now apply parts_product]]; apply near2_step with (3 := H).
  - pose proof (near2_size _ _ _ _ Nb) as Hbs; destruct Na as [Ha Hm], Nb as [Hb Hl].
    replace (whole a * whole b - x * y) with ((whole a - x) * whole b + x * (whole b - y)) by ring.
    apply Rle_trans with (1 := Rabs_triang _ _).
    rewrite !Rabs_mult, pow_add; pose proof (pow2_ge_1 i); pose proof (pow2_ge_1 j).
    pose proof (Rabs_pos x); pose proof (Rabs_pos y).
    assert (Rabs (whole a - x) * Rabs (whole b) <= ((1 + uu) ^ i - 1) * m * ((1 + uu) ^ j * m'))
      by (apply Rmult_le_compat; auto using Rabs_pos).
    assert (Rabs x * Rabs (whole b - y) <= m * (((1 + uu) ^ j - 1) * m')) by (apply Rmult_le_compat; auto using Rabs_pos).
    lra.
  - destruct Na as [_ Hm], Nb as [_ Hl]; rewrite Rabs_mult; apply Rmult_le_compat; auto using Rabs_pos.
Qed.

Lemma six_in_uu x y : Rabs (x - y) <= 6 * (u * (u * Rabs y)) -> Rabs (x - y) <= uu * Rabs y.
Proof.
  intros H; rewrite (in_uu 6) in H by apply Rabs_pos; pose proof uu_bounds.
  pose proof (Rmult_le_pos uu _ ltac:(lra) (Rabs_pos y)); lra.
Qed.

Lemma worded_plus n k a b x y m m' : (-1074 <= k)%Z -> worded n k a x m -> worded n k b y m' ->
  worded (S n) k (sum a b) (x + y) (m + m').
Proof.
  intros Hk ([Ha Hm] & Wa & Pa) ([Hb Hl] & Wb & Pb); destruct (sum_near a b Wa Wb) as [W H].
  split; [|split; [exact W | now apply parts_sum]]; apply six_in_uu in H; apply near2_step with (3 := H).
  - replace (whole a + whole b - (x + y)) with ((whole a - x) + (whole b - y)) by ring.
    apply Rle_trans with (1 := Rabs_triang _ _); lra.
  - apply Rle_trans with (1 := Rabs_triang _ _); lra.
Qed.

Lemma worded_opposite n k a x m : worded n k a x m -> worded n k (opposite a) (- x) m.
Proof.
  intros ([H Hm] & W & P); destruct (opposite_word a W) as [W' E]; split; [|split; [exact W' | now apply parts_opposite]].
  split; [|now rewrite Rabs_Ropp]; rewrite E; replace (- whole a - - x) with (- (whole a - x)) by ring; now rewrite Rabs_Ropp.
Qed.

Lemma worded_minus n k a b x y m m' : (-1074 <= k)%Z -> worded n k a x m -> worded n k b y m' ->
  worded (S n) k (difference a b) (x - y) (m + m').
Proof. intros Hk Ha Hb; rewrite difference_is; now apply worded_plus, worded_opposite. Qed.

Lemma worded_error n k a x m : (n <= 64)%nat -> worded n k a x m -> Rabs (whole a - x) <= 1001 / 1000 * INR n * uu * m.
Proof.
  intros Hn ((H & Hm) & _); apply Rle_trans with (1 := H); apply Rmult_le_compat_r; [|now apply pow2_bound].
  apply Rle_trans with (2 := Hm), Rabs_pos.
Qed.

Lemma worded_size n k a x m : (n <= 64)%nat -> worded n k a x m -> Rabs (hi a) <= 2 * m.
Proof.
  intros Hn (H & W & _); pose proof (near2_size _ _ _ _ H) as Hs; destruct H as [_ Hm].
  pose proof (pow2_bound n Hn) as Hp; pose proof uu_bounds; assert (0 <= INR n <= 64).
  { split; [apply pos_INR|]; replace 64 with (INR 64) by (simpl; lra); now apply le_INR. }
  assert (INR n * uu <= 64 * / 1000000000000) by (apply Rmult_le_compat; lra).
  assert (Hm0 : 0 <= m) by (apply Rle_trans with (2 := Hm), Rabs_pos).
  assert ((1 + uu) ^ n * m <= (1 + / 1000) * m) by (apply Rmult_le_compat_r; lra).
  destruct (word_near a W) as [Hn' _]; pose proof (u_part _ (Rabs_pos (whole a))) as Hu.
  replace (hi a) with (whole a + (hi a - whole a)) by ring; apply Rle_trans with (1 := Rabs_triang _ _); lra.
Qed.

(** ** Vectors of pairs *)

Record vec2 := Vec2 { dx : twofold; dy : twofold; dz : twofold }.
Definition dot2 (a b : vec2) : twofold := sum (sum (product (dx a) (dx b)) (product (dy a) (dy b))) (product (dz a) (dz b)).
Definition cross2 (a b : vec2) : vec2 :=
  Vec2 (difference (product (dy a) (dz b)) (product (dz a) (dy b)))
    (difference (product (dz a) (dx b)) (product (dx a) (dz b))) (difference (product (dx a) (dy b)) (product (dy a) (dx b))).
Definition norm2 (a : vec2) : twofold := root_of (dot2 a a).
Definition exactly2 (a : vec) : vec2 := Vec2 (exactly (cx a)) (exactly (cy a)) (exactly (cz a)).
Definition minus2 (a b : vec) : vec2 := Vec2 (two_sum (cx a) (- cx b)) (two_sum (cy a) (- cy b)) (two_sum (cz a) (- cz b)).
Definition wholes (a : vec2) : vec := Vec (whole (dx a)) (whole (dy a)) (whole (dz a)).

Definition words_close (n : nat) (k : Z) (a : vec2) (x : vec) : Prop :=
  worded n k (dx a) (cx x) (Rabs (cx x)) /\ worded n k (dy a) (cy x) (Rabs (cy x)) /\ worded n k (dz a) (cz x) (Rabs (cz x)).
Definition words_on (k : Z) (a : vec2) : Prop :=
  (double_word (dx a) /\ parts_on k (dx a)) /\ (double_word (dy a) /\ parts_on k (dy a)) /\ (double_word (dz a) /\ parts_on k (dz a)).

Lemma on_words k a : words_on k a -> double_word (dx a) /\ double_word (dy a) /\ double_word (dz a).
Proof. intros ((X & _) & (Y & _) & (Z & _)); tauto. Qed.

Lemma worded_self k w : double_word w -> parts_on k w -> worded 0 k w (whole w) (Rabs (whole w)).
Proof.
  intros W P; split; [|now split]; unfold near2; simpl; rewrite Rminus_diag_eq, Rabs_R0 by reflexivity; split;
    [lra | apply Rle_refl].
Qed.

Lemma words_close_self k a : words_on k a -> words_close 0 k a (wholes a).
Proof. intros ([? ?] & [? ?] & [? ?]); split; [|split]; now apply worded_self. Qed.

Lemma words_exactly k a : on_grid k a -> words_close 0 k (exactly2 a) a.
Proof. intros (? & ? & ? & ? & ? & ?); split; [|split]; now apply worded_exactly. Qed.

Lemma words_minus k a b : (-1074 <= k)%Z -> on_grid k a -> on_grid k b -> words_close 0 k (minus2 a b) (minus a b).
Proof. intros Hk (? & ? & ? & ? & ? & ?) (? & ? & ? & ? & ? & ?); split; [|split]; now apply worded_difference_of. Qed.

Lemma dot2_worded i j k l a b x y : (-960 <= k + l)%Z -> words_close i k a x -> words_close j l b y ->
  worded (S (S (S (i + j)))) (k + l) (dot2 a b) (dot x y) (size_of_dot x y).
Proof.
  intros Hk (Ax & Ay & Az) (Bx & By & Bz); apply worded_plus; [lia | |].
  - apply worded_plus; [lia | |]; now apply worded_mult.
  - apply (worded_more (S (i + j))); [lia|]; now apply worded_mult.
Qed.

(** ** Every operation is within the bound beside its definition *)

Definition within_bound (x : twofold) (r : R) : Prop := double_word x /\ Rabs (whole x - r) <= uu * Rabs r.

Theorem operations_near x y : double_word x -> double_word y ->
  within_bound (sum x y) (whole x + whole y) /\ within_bound (difference x y) (whole x - whole y) /\
  (worthy (hi x * hi y) -> within_bound (product x y) (whole x * whole y)) /\
  (bpow radix2 (-900) <= Rabs (hi x) -> hi y <> 0 -> bpow radix2 (-900) <= Rabs (hi x / hi y) ->
   within_bound (ratio x y) (whole x / whole y)) /\
  (bpow radix2 (-900) <= hi x -> within_bound (root_of x) (sqrt (whole x))).
Proof.
  intros Wx Wy; destruct (sum_near x y Wx Wy) as [W1 H1], (difference_near x y Wx Wy) as [W2 H2].
  split; [split; [exact W1 | exact (six_in_uu _ _ H1)]|]; split; [split; [exact W2 | exact (six_in_uu _ _ H2)]|].
  split; [exact (product_near x y Wx Wy)|]; split; [exact (ratio_near x y Wx Wy)|].
  intros Hx; unfold within_bound; rewrite (Rabs_pos_eq (sqrt (whole x))) by apply sqrt_pos.
  apply root_near; [exact Wx | apply Rle_trans with (2 := Hx), bpow_le; lia].
Qed.
