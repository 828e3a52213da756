(** * ExactHit: the exact parameter and the point there, as they are rounded

    surface::exact::rounded_hit of src/surface/exact.cpp, over the numbers of src/number/dyadic_surd.cpp, rounded as in
    Exactly.v, of which the turns are proved here to end.

    number, amount      == a dyadic m·2^e; what it is
    surd_of, denotes    == (x + y√delta)/w of dyadics; what it is
    linear m n s        == m + n·s, as there
    rounding turns s    == what round_to_binary64 says of s after at most so many turns
    rounded_into s f    == f is what is stored of what it says when it ends
    hit_into p v t out  == out is what is stored of t and of p + t·v *)
From Coq Require Import Reals ZArith Znumtheory Lra Lia Bool.
From Flocq Require Import Core BinarySingleNaN.
From Durero Require Import Rounding Vectors Limits Quick Exactly.
From Durero Require Especificacion Chain.
Local Open Scope R_scope.

Local Instance prec53 : Prec_gt_0 53 := eq_refl.

(** ** The turns end *)

(** What is between two of the binary64 that are not neighbours lies at least the least of them apart. *)
Lemma apart f g : format f -> format g -> f < g -> f + tiny <= g.
Proof.
  assert (G : forall x, format x -> exists n, x = IZR n * tiny).
  { intros x Fx; apply generic_format_FIX_FLT, FIX_format_generic in Fx as [[m e] -> E]; cbn in E; subst e; now exists m. }
  intros Ff Fg L; destruct (G f Ff) as [n ->], (G g Fg) as [k ->]; pose proof (bpow_gt_0 radix2 (-1074)) as Ht.
  apply Rmult_lt_reg_r, lt_IZR in L; [|exact Ht]; rewrite <- (Rmult_1_l tiny) at 2; rewrite <- Rmult_plus_distr_r, <- plus_IZR.
  apply Rmult_le_compat_r; [lra | apply IZR_le; lia].
Qed.

Lemma neighbours a b : b - a < tiny -> extended a < extended b -> succ radix2 fexp (extended a) = extended b.
Proof.
  intros Hab L; pose proof (extended_format a) as Fa; pose proof (extended_format b) as Fb.
  destruct (succ_le_lt radix2 fexp _ _ Fa Fb L) as [Hs|E]; [exfalso | exact E].
  set (f := succ radix2 fexp (extended a)) in *; assert (Ff : format f) by (apply generic_format_succ; auto with typeclass_instances).
  pose proof (extended_range a) as Ra; pose proof (extended_range b) as Rb.
  assert (Hf : extended a < f).
  { destruct (Req_dec (extended a) 0) as [Z0|N]; [|now apply succ_gt_id].
    unfold f; rewrite Z0, succ_0, ulp_FLT_0 by exact eq_refl; apply bpow_gt_0. }
  assert (La : a <= (f + pred radix2 fexp f) / 2).
  { apply Rnot_lt_le; intros N; apply round_N_ge_midp with (choice := fun n => negb (Z.even n)) in N; auto with typeclass_instances.
    assert (f <= extended a) by (apply extended_of_bound; [lra | exact N]); lra. }
  assert (Lb : (f + succ radix2 fexp f) / 2 <= b).
  { apply Rnot_lt_le; intros N; apply round_N_le_midp with (choice := fun n => negb (Z.even n)) in N; auto with typeclass_instances.
    assert (extended b <= f) by (apply extended_of_bound; [lra | exact N]); lra. }
  assert (Fp : format (pred radix2 fexp f)) by (apply generic_format_pred; auto with typeclass_instances).
  assert (Fs : format (succ radix2 fexp f)) by (apply generic_format_succ; auto with typeclass_instances).
  assert (Hsp : pred radix2 fexp f + tiny <= f /\ f + tiny <= succ radix2 fexp f).
  { destruct (Req_dec f 0) as [Z0|N0].
    - rewrite Z0, pred_0, succ_0, ulp_FLT_0 by auto with typeclass_instances; lra.
    - split; apply apart; auto; [apply pred_lt_id | apply succ_gt_id]; exact N0. }
  lra.
Qed.

Lemma attempt_ends x y w d value root : w <> 0 -> Rabs y * pw (place root) < Rabs (x + y * d) ->
  Rabs y * pw (place root) < tiny * Rabs w ->
  IZR (cut root) * pw (place root) <= d <= IZR (cut root) * pw (place root) + pw (place root) ->
  exists out, attempt x y w value root = Some out.
Proof.
  intros Hw Hone Hnear Hd; unfold attempt; set (c := IZR (cut root) * pw (place root)) in *; set (unit := pw (place root)) in *.
  destruct (whole root); [eauto|]; set (first := x + y * c); set (last := first + y * unit).
  assert (Hu : 0 < unit) by apply bpow_gt_0; assert (Hyu : Rabs (y * unit) = Rabs y * unit).
  { now rewrite Rabs_mult, (Rabs_pos_eq unit) by lra. }
  assert (Hside : 0 < first * last).
  { assert (E : first = (x + y * d) - y * (d - c) /\ last = (x + y * d) + y * (c + unit - d)) by (unfold last, first; split; ring).
    assert (Hlow : Rabs (y * (d - c)) <= Rabs y * unit).
    { rewrite Rabs_mult; apply Rmult_le_compat_l; [apply Rabs_pos | rewrite Rabs_pos_eq; lra]. }
    assert (Hup : Rabs (y * (c + unit - d)) <= Rabs y * unit).
    { rewrite Rabs_mult; apply Rmult_le_compat_l; [apply Rabs_pos | rewrite Rabs_pos_eq; lra]. }
    destruct E as [-> ->]; set (N := x + y * d) in *; apply Rabs_le_inv in Hlow, Hup.
    destruct (Rle_or_lt 0 N) as [Hp|Hn]; [rewrite (Rabs_pos_eq N) in Hone by lra | rewrite (Rabs_left N) in Hone by lra].
    - apply Rmult_lt_0_compat; lra.
    - replace ((N - y * (d - c)) * (N + y * (c + unit - d))) with (- (N - y * (d - c)) * - (N + y * (c + unit - d))) by ring.
      apply Rmult_lt_0_compat; lra. }
  rewrite Rle_bool_false by exact Hside; destruct (Req_bool_spec (extended (first / w)) (extended (last / w))) as [E|N]; [eauto|].
  assert (Hd2 : Rabs (last / w - first / w) < tiny).
  { replace (last / w - first / w) with (y * unit / w) by (unfold last; field; exact Hw); unfold Rdiv.
    rewrite Rabs_mult, Hyu, Rabs_inv; pose proof (Rabs_pos_lt w Hw).
    apply Rmult_lt_reg_r with (Rabs w); [lra|]; rewrite Rmult_assoc, Rinv_l, Rmult_1_r; lra. }
  apply Rabs_lt_inv in Hd2.
  assert (S : succ radix2 fexp (Rmin (extended (first / w)) (extended (last / w))) = Rmax (extended (first / w)) (extended (last / w))).
  { destruct (Rdichotomy _ _ N); [rewrite Rmin_left, Rmax_right by lra | rewrite Rmin_right, Rmax_left by lra];
      apply neighbours; lra. }
  rewrite Req_bool_true by exact S; eauto.
Qed.

(** The places of what is cut fall without end. *)
Lemma place_falls m e count : (place (cut_root m e count) <= Z.abs e + Z.log2 m + 1 - count)%Z.
Proof.
  unfold cut_root; cbn [place]; pose proof (Z.log2_nonneg m).
  destruct Z.odd; (apply Z.le_trans with ((2 * (Z.abs e + Z.log2 m + 1 - count)) / 2)%Z; [apply Z.div_le_mono; lia|]);
    rewrite Z.mul_comm, Z.div_mul; lia.
Qed.

(** An integer of which the root is a quotient is a square. *)
Lemma square_of_quotient n p q : (0 <= n)%Z -> q <> 0%Z -> (p * p = n * (q * q))%Z -> (Z.sqrt n * Z.sqrt n = n)%Z.
Proof.
  intros Hn Hq E; set (g := Z.gcd p q); assert (Hg : (0 < g)%Z).
  { pose proof (Z.gcd_nonneg p q); assert (g <> 0)%Z by (intros Z0; apply Z.gcd_eq_0_r in Z0; lia); lia. }
  destruct (Z.gcd_divide_l p q) as [a Ea], (Z.gcd_divide_r p q) as [b Eb]; fold g in Ea, Eb.
  assert (Hab : Z.gcd a b = 1%Z).
  { replace a with (p / g)%Z by (rewrite Ea at 1; apply Z.div_mul; lia); replace b with (q / g)%Z by (rewrite Eb at 1; apply Z.div_mul; lia).
    apply Z.gcd_div_gcd; [lia | reflexivity]. }
  assert (E1 : (a * a = n * (b * b))%Z).
  { apply Z.mul_reg_r with (g * g)%Z; [lia|]; transitivity (p * p)%Z; [rewrite Ea; ring | rewrite E, Eb; ring]. }
  assert (Hb : (b | 1)%Z).
  { rewrite Z.gcd_comm in Hab; apply Z.gauss with a; [|exact Hab]; rewrite Z.mul_1_r; apply Z.gauss with a; [|exact Hab].
    exists (n * b)%Z; rewrite E1; ring. }
  assert (Hbb : (b * b = 1)%Z) by (apply Z.divide_1_r in Hb as [-> | ->]; reflexivity).
  rewrite Hbb, Z.mul_1_r in E1; rewrite <- E1; destruct (Z.abs_spec a) as [[_ A]|[_ A]]; 
    [rewrite Z.sqrt_square by lia; reflexivity | replace (a * a)%Z with (- a * - a)%Z by ring; rewrite Z.sqrt_square by lia; ring].
Qed.

Lemma even_shift m e count : let fit := (2 * count - (Z.log2 m + 1))%Z in
  exists h, (e - (if Z.odd (e - fit) then fit + 1 else fit) = h + h)%Z.
Proof.
  intros fit; destruct (Z.odd (e - fit)) eqn:Od.
  - apply Z.odd_spec in Od as [j Ej]; exists j; lia.
  - assert (Ev : Z.even (e - fit) = true) by (rewrite <- Z.negb_odd, Od; reflexivity).
    apply Z.even_spec in Ev as [j Ej]; exists j; lia.
Qed.

(** Where the number is 0 the root is one of a square, and in the end nothing is cut. *)
Lemma whole_in_the_end mx ex my ey m e count : (0 < m)%Z -> (my <> 0)%Z -> (Z.log2 m + 1 <= 2 * count)%Z ->
  dyadic mx ex + dyadic my ey * sqrt (dyadic m e) = 0 -> whole (cut_root m e count) = true.
Proof.
  intros Hm Hy Hc E; unfold cut_root; destruct (even_shift m e count) as [h Eh]; cbv zeta in Eh.
  set (fit := (2 * count - _)%Z) in *; set (shift := if Z.odd (e - fit) then _ else _) in *.
  assert (Hs : (0 <= shift)%Z) by (unfold shift, fit; destruct Z.odd; lia); clearbody shift.
  rewrite (proj2 (Z.leb_le 0 shift) Hs); cbn [whole andb]; set (n := (m * 2 ^ shift)%Z).
  assert (Hn : (0 <= n)%Z) by (apply Z.mul_nonneg_nonneg; [lia | apply Z.pow_nonneg; lia]); apply Z.eqb_eq.
  assert (En : dyadic m e = IZR n * (pw h * pw h)).
  { unfold n, dyadic; rewrite mult_IZR, IZR_pow, Rmult_assoc, <- !bpow_plus by exact Hs; do 2 f_equal; lia. }
  assert (E2 : IZR n * (IZR my * IZR my) * (pw (h + ey) * pw (h + ey)) = IZR mx * IZR mx * (pw ex * pw ex)).
  { assert (Hd : 0 <= dyadic m e) by (apply Rmult_le_pos; [apply IZR_le; lia | apply bpow_ge_0]).
    rewrite bpow_plus; transitivity (dyadic my ey * sqrt (dyadic m e) * (dyadic my ey * sqrt (dyadic m e))).
    - replace (dyadic my ey * sqrt (dyadic m e) * (dyadic my ey * sqrt (dyadic m e)))
        with (dyadic my ey * dyadic my ey * (sqrt (dyadic m e) * sqrt (dyadic m e))) by ring.
      rewrite sqrt_sqrt by exact Hd; rewrite En; unfold dyadic; ring.
    - replace (dyadic my ey * sqrt (dyadic m e)) with (- dyadic mx ex) by lra; unfold dyadic; ring. }
  pose proof (bpow_gt_0 radix2 ex) as Px; pose proof (bpow_gt_0 radix2 (h + ey)) as Py.
  assert (Pos : forall j, (0 <= j)%Z -> (2 ^ j <> 0)%Z) by (intros j Hj; apply Z.pow_nonzero; lia).
  destruct (Z.le_ge_cases ex (h + ey)) as [Hk|Hk].
  - set (k := (h + ey - ex)%Z); apply (square_of_quotient n mx (my * 2 ^ k)); [exact Hn | apply Z.neq_mul_0; split; [exact Hy | apply Pos; lia]|].
    apply eq_IZR; rewrite !mult_IZR, IZR_pow by lia; apply Rmult_eq_reg_r with (pw ex * pw ex); [|apply Rgt_not_eq, Rmult_lt_0_compat; lra].
    rewrite <- E2; replace (h + ey)%Z with (k + ex)%Z by lia; rewrite (bpow_plus radix2 k); ring.
  - set (k := (ex - (h + ey))%Z); apply (square_of_quotient n (mx * 2 ^ k) my); [exact Hn | exact Hy|].
    apply eq_IZR; rewrite !mult_IZR, IZR_pow by lia; apply Rmult_eq_reg_r with (pw (h + ey) * pw (h + ey)); [|apply Rgt_not_eq, Rmult_lt_0_compat; lra].
    rewrite E2; replace ex with (k + (h + ey))%Z by lia; rewrite (bpow_plus radix2 k); ring.
Qed.

Lemma attempts_end x y w m e N : (forall count, (N <= count)%Z -> exists out,
   attempt x y w ((x + y * sqrt (dyadic m e)) / w) (cut_root m e count) = Some out) ->
  forall k count, (0 < count)%Z -> (N <= count + Z.of_nat k)%Z -> exists turns out, attempts turns count x y w m e = Some out.
Proof.
  intros H; induction k as [|k IH]; intros count Hc HN.
  - destruct (H count ltac:(lia)) as [out E]; exists 1%nat, out; cbn [attempts]; now rewrite E.
  - destruct (IH (2 * count)%Z ltac:(lia) ltac:(lia)) as (turns & out & E).
    destruct (attempt x y w ((x + y * sqrt (dyadic m e)) / w) (cut_root m e count)) as [found|] eqn:Ea;
      [exists 1%nat, found | exists (S turns), out]; cbn [attempts]; now rewrite Ea.
Qed.

Theorem exactly_ends mx ex my ey md ed mw ew : (0 <= md)%Z -> mw <> 0%Z ->
  exists turns out, exactly turns mx ex my ey md ed mw ew = Some out.
Proof.
  intros Hmd Hmw; unfold exactly; set (rational := ((my =? 0) || (md =? 0))%Z%bool).
  destruct (rational && (mx =? 0)%Z); [exists O; eauto|]; destruct (quick extended mx ex my ey md ed mw ew); [exists O; eauto|].
  destruct rational eqn:F; [exists O; eauto|]; apply orb_false_iff in F as [Fy Fd]; apply Z.eqb_neq in Fy, Fd.
  assert (Hm : (0 < md)%Z) by lia; set (x := dyadic mx ex); set (y := dyadic my ey); set (w := dyadic mw ew).
  assert (Not0 : forall a b, a <> 0%Z -> dyadic a b <> 0).
  { intros a b Ha; apply Rmult_integral_contrapositive; split; [now apply not_0_IZR | apply Rgt_not_eq, bpow_gt_0]. }
  assert (Hw : w <> 0) by now apply Not0.
  assert (Hy : 0 < Rabs y) by (apply Rabs_pos_lt; now apply Not0); set (d := sqrt (dyadic md ed)).
  assert (Ends : exists N, forall count, (N <= count)%Z -> exists out, attempt x y w ((x + y * d) / w) (cut_root md ed count) = Some out).
  { destruct (Req_dec (x + y * d) 0) as [Z0|N0].
    - exists (Z.log2 md + 1)%Z; intros count Hc; pose proof (Z.log2_nonneg md).
      unfold attempt; rewrite (whole_in_the_end mx ex my ey md ed count Hm Fy ltac:(lia) Z0); eauto.
    - set (r := Rmin (Rabs (x + y * d)) (tiny * Rabs w) / Rabs y).
      assert (Hr : 0 < r).
      { apply Rdiv_lt_0_compat; [|exact Hy]; apply Rmin_glb_lt; [now apply Rabs_pos_lt|].
        apply Rmult_lt_0_compat; [apply bpow_gt_0 | now apply Rabs_pos_lt]. }
      exists (Z.abs ed + Z.log2 md + 2 - mag radix2 r + 1)%Z; intros count Hc.
      pose proof (place_falls md ed count) as Hp; destruct (cut_root_spans md ed count Hm) as [Hd _].
      assert (Hu : Rabs y * pw (place (cut_root md ed count)) < Rmin (Rabs (x + y * d)) (tiny * Rabs w)).
      { replace (Rmin _ _) with (Rabs y * r) by (unfold r; field; lra); apply Rmult_lt_compat_l; [exact Hy|].
        apply Rlt_le_trans with (pw (mag radix2 r - 1)); [apply bpow_lt; lia|].
        apply Rle_trans with (Rabs r); [apply bpow_mag_le | rewrite Rabs_pos_eq]; lra. }
      pose proof (Rmin_l (Rabs (x + y * d)) (tiny * Rabs w)); pose proof (Rmin_r (Rabs (x + y * d)) (tiny * Rabs w)).
      apply attempt_ends with d; auto; lra. }
  destruct Ends as [N Ends]; apply (attempts_end x y w md ed N Ends (Z.to_nat (Z.max 0 N))); lia.
Qed.

(** ** The numbers that are rounded *)

Record number := Number { significand : Z; exponent : Z }.
Definition amount (a : number) : R := dyadic (significand a) (exponent a).
Definition plus (a b : number) : number :=
  let e := Z.min (exponent a) (exponent b) in
  Number (significand a * 2 ^ (exponent a - e) + significand b * 2 ^ (exponent b - e)) e.
Definition times (a b : number) : number := Number (significand a * significand b) (exponent a + exponent b).

Record surd_of := Surd_of { sx : number; sy : number; sdelta : number; sw : number }.
Definition denotes (s : surd_of) : R := (amount (sx s) + amount (sy s) * sqrt (amount (sdelta s))) / amount (sw s).
Definition sound (s : surd_of) : Prop := (0 <= significand (sdelta s))%Z /\ significand (sw s) <> 0%Z.
Definition linear (m n : number) (s : surd_of) : surd_of :=
  Surd_of (plus (times m (sw s)) (times n (sx s))) (times n (sy s)) (sdelta s) (sw s).

Definition rounding (turns : nat) (s : surd_of) : option R :=
  exactly turns (significand (sx s)) (exponent (sx s)) (significand (sy s)) (exponent (sy s)) (significand (sdelta s))
    (exponent (sdelta s)) (significand (sw s)) (exponent (sw s)).
Definition rounded_into (s : surd_of) (x : binary64) : Prop := forall turns out, rounding turns s = Some out -> stored x out.

Lemma amount_times a b : amount (times a b) = amount a * amount b.
Proof. unfold amount, times, dyadic; cbn; rewrite mult_IZR, bpow_plus; ring. Qed.

Lemma amount_plus a b : amount (plus a b) = amount a + amount b.
Proof.
  assert (E : forall c e, (e <= exponent c)%Z -> IZR (significand c * 2 ^ (exponent c - e)) * pw e = amount c).
  { intros c e He; unfold amount, dyadic; rewrite mult_IZR, IZR_pow, Rmult_assoc, <- bpow_plus by lia; do 2 f_equal; lia. }
  unfold plus; set (e := Z.min _ _); unfold amount at 1, dyadic; cbn [significand exponent].
  rewrite plus_IZR, Rmult_plus_distr_r; unfold e; rewrite !E by lia; reflexivity.
Qed.

Lemma linear_right m n s : sound s -> sound (linear m n s) /\ denotes (linear m n s) = amount m + amount n * denotes s.
Proof.
  intros [Hd Hw]; split; [now split|]; unfold denotes, linear; cbn [sx sy sdelta sw]; rewrite amount_plus, !amount_times.
  assert (amount (sw s) <> 0).
  { apply Rmult_integral_contrapositive; split; [now apply not_0_IZR | apply Rgt_not_eq, bpow_gt_0]. }
  field; assumption.
Qed.

Theorem rounded_into_is_rounded_once s x : sound s -> rounded_into s x -> rounded_once x (denotes s).
Proof.
  intros [Hd Hw] H; destruct (exactly_ends (significand (sx s)) (exponent (sx s)) (significand (sy s)) (exponent (sy s))
    (significand (sdelta s)) (exponent (sdelta s)) (significand (sw s)) (exponent (sw s)) Hd Hw) as (turns & out & E).
  exact (exact_rounding_right turns _ _ _ _ _ _ _ _ out x Hd Hw E (H turns out E)).
Qed.

Definition axis_into (p v : R) (t : surd_of) (x : binary64) : Prop :=
  exists m n, amount m = p /\ amount n = v /\ rounded_into (linear m n t) x.
Definition hit_into (p v : vec) (t : surd_of) (out : Chain.printed) : Prop :=
  rounded_into t (Chain.printed_t out) /\ axis_into (cx p) (cx v) t (Chain.printed_x out) /\
  axis_into (cy p) (cy v) t (Chain.printed_y out) /\ axis_into (cz p) (cz v) t (Chain.printed_z out).

(** So the exact parameter and the point there are stored as they are, each rounded once. *)
Theorem hit_is_rounded_once p v t out : sound t -> hit_into p v t out ->
  Chain.rounds (Especificacion.mk_Rayo (Especificacion.mk_Punto (cx p) (cy p) (cz p))
    (Especificacion.mk_Vector (cx v) (cy v) (cz v))) out (denotes t).
Proof.
  intros Ht (H & X & Y & Z0).
  assert (Axis : forall a b x, axis_into a b t x -> rounded_once x (a + denotes t * b)).
  { intros a b x (m & n & <- & <- & Hx); destruct (linear_right m n t Ht) as [Hl E].
    rewrite (Rmult_comm (denotes t)), <- E; now apply rounded_into_is_rounded_once. }
  split; [now apply rounded_into_is_rounded_once | split; [now apply Axis | split; now apply Axis]].
Qed.
