(** * Recorded: steps that are the recorded terms, and all that is asked of steps that run holds of them

    [Running.steps_run] says what the steps of the search compute. Here are steps that do, over the reals, for any scene and
    any ray, its numbers integers over a power of two: the triage, the second step, the ends, the Newton step, the comparison
    and the rounding are the terms of Formas.v, each rounded once as binary64 is, and what is exact is rounded by the
    executable function of Nearest.v. They are functions and need no choice. So the record is not empty, and what is said of
    the steps that run is said of something.

    to64 r              == the binary64 r, where it is one
    answer_up_to step x == the answer of a step up to x, where x is infinite up to far
    triage, stable, …   == the steps *)
From Coq Require Import Reals ZArith List Bool Lra Lia.
From Flocq Require Import Core BinarySingleNaN.
From Durero Require Import Toolkit Especificacion Escena Interseccion.
From Durero Require Search Limits Chain Formas Once Ends Exacto ExactoEscena ExactHit Exactly Surd Quick Nearest.
From Durero Require Import Rounding Vectors Flotante Steps Triage Second Twofold AtRootText Levels Running Sizes Settled StableSettled
  Reached Whole.
Import Formas.Pairs.
Local Open Scope R_scope.
Local Open Scope zed_scope.
Local Opaque bpow.
Local Instance prec53 : Prec_gt_0 53 := eq_refl.
Local Instance below1024 : Prec_lt_emax 53 1024 := eq_refl.

(** ** A real as it is stored *)

Definition to64 (r : R) : Limits.binary64 :=
  binary_normalize 53 1024 _ _ mode_NE (Ztrunc (scaled_mantissa radix2 fexp r)) (cexp radix2 fexp r) false.

Lemma to64_stored r : format r -> Rabs r < bpow radix2 1024 -> Once.stored (to64 r) r.
Proof.
  intros Fr Hr; pose proof (binary_normalize_correct 53 1024 _ _ mode_NE (Ztrunc (scaled_mantissa radix2 fexp r))
    (cexp radix2 fexp r) false) as H.
  assert (E : F2R (Float radix2 (Ztrunc (scaled_mantissa radix2 fexp r)) (cexp radix2 fexp r)) = r) by (symmetry; exact Fr).
  cbv zeta in H; rewrite E in H; change (round radix2 (SpecFloat.fexp 53 1024) (round_mode mode_NE) r) with (rnd r) in H.
  rewrite (rnd_format r Fr), Rlt_bool_true in H by exact Hr; destruct H as (HB & HF & _); now split.
Qed.

Definition is_stored (r : R) : bool := is_finite (to64 r) && Req_bool (B2R (to64 r)) r.
Lemma is_stored_right r : is_stored r = true -> Once.stored (to64 r) r.
Proof.
  unfold is_stored; rewrite andb_true_iff; intros [F E]; split; [exact F|]; revert E; now case Req_bool_spec.
Qed.

Lemma ends_stored root : sized root -> Once.stored (to64 (Formas.low (Formas.ends_of root))) (Formas.low (Formas.ends_of root)) /\
  Once.stored (to64 (Formas.high (Formas.ends_of root))) (Formas.high (Formas.ends_of root)).
Proof.
  intros [Sv Se]; unfold Formas.ends_of; cbn [Formas.low Formas.high].
  assert (Small : forall x, below 1011 x -> Rabs x < bpow radix2 1024).
  { intros x [_ H]; apply Rle_lt_trans with (1 := H), bpow_lt; lia. }
  split; (apply to64_stored; [apply format_rnd | apply Small]); (eapply below_more; [size | lia]).
Qed.

Lemma ends_stored2 root : sized2 root -> Once.stored (to64 (Formas.low (ends_of root))) (Formas.low (ends_of root)) /\
  Once.stored (to64 (Formas.high (ends_of root))) (Formas.high (ends_of root)).
Proof.
  destruct root as [[h l] e]; intros [Sv Se]; cbn [Formas.value Formas.error hi] in Sv, Se; unfold ends_of; cbn [Formas.low Formas.high
    Formas.value Formas.error hi].
  assert (Small : forall x, below 1013 x -> Rabs x < bpow radix2 1024).
  { intros x [_ H]; apply Rle_lt_trans with (1 := H), bpow_lt; lia. }
  split; (apply to64_stored; [apply format_rnd | apply Small]); (eapply below_more; [size | vm_compute; discriminate]).
Qed.

(** An answer rounded once is what is stored of the exact rounding. *)
Lemma rounded_is_stored x r : Limits.rounded_once x r -> Exactly.stored x (Exactly.extended r).
Proof.
  unfold Limits.rounded_once, Exactly.stored; change (Limits.rnd64 r) with (rnd r); pose proof (bpow_gt_0 radix2 1024) as Hb.
  destruct (Rlt_bool_spec (Rabs (rnd r)) (bpow radix2 1024)) as [H|H].
  - apply Rabs_lt_inv in H; assert (E : Exactly.extended r = rnd r) by (unfold Exactly.extended; rewrite Rmin_right, Rmax_right; lra).
    rewrite E, Rlt_bool_true by (apply Rabs_lt; lra); auto.
  - intros ->; destruct (Rle_or_lt 0 r) as [Hr|Hr].
    + pose proof (rnd_nonneg r Hr) as H0; rewrite Rabs_pos_eq in H by exact H0.
      unfold Exactly.extended; rewrite Rmin_left, Rmax_right, !Rlt_bool_false, ?Rabs_pos_eq by (try rewrite Rabs_pos_eq; lra); reflexivity.
    + pose proof (rnd_le r 0 ltac:(lra)) as H0; rewrite rnd_0 in H0; rewrite Rabs_left1 in H by exact H0.
      unfold Exactly.extended; rewrite Rmin_right, Rmax_left by lra.
      rewrite (Rlt_bool_false (Rabs (- bpow radix2 1024))) by (rewrite Rabs_Ropp, Rabs_pos_eq; lra).
      now rewrite !Rlt_bool_true by lra.
Qed.

(** ** The steps *)

Definition answer_up_to {T} (step : R -> Formas.answer T) (x : Limits.binary64) : Formas.answer T :=
  step (if is_finite x then B2R x else far).

Lemma answered_up_to step x : settles step -> answered step x (answer_up_to step x).
Proof.
  intros [S _]; unfold answered, answer_up_to; destruct (is_finite x); [reflexivity|]; exists far; intros limit Hl; symmetry; now apply S.
Qed.

Lemma answered_pair_up_to step x : settles2 step -> answered_pair step x (answer_up_to step x).
Proof.
  intros [S _]; unfold answered_pair, answer_up_to; destruct (is_finite x); [reflexivity|]; exists far; intros limit Fl Hl; symmetry.
  now apply S.
Qed.

Section Steps.
Variable Elemento : Type.
Variable S : Z.
Variables origin way : Exacto.vec3.
Notation p := (vec_over S origin).
Notation v := (vec_over S way).
Variables (shape_of : Elemento -> shape) (on : Elemento -> bool).

Definition triage (e : Elemento) (x : Limits.binary64) : Search.verdict finding :=
  found_single (answer_up_to (alone_of p v (shape_of e) (on e)) x).
Definition stable (e : Elemento) (x : Limits.binary64) : Search.verdict finding :=
  found_double (answer_up_to (second_of p v (shape_of e) (on e)) x).
Definition improved (e : Elemento) (f : finding) : Search.verdict finding :=
  match f with
  | Single root slope curvature =>
      let n := newton root slope curvature (at_root p v (shape_of e) (on e) (Formas.value root)) in
      if known_slope n then Search.Hit _ (Running.Improved (Formas.Known (better n) (better_error n))) else Search.Undecided _
  | _ => Search.Undecided _
  end.
Definition round_exact (x : Surd.surd) : Chain.printed := Chain.exactly_printed Z.sqrt 0 0 0 0 S origin way x.
Definition low (w : Search.evidence finding) : Limits.binary64 :=
  match w with
  | Search.By_triage (Single root _ _) => to64 (Formas.low (Formas.ends_of root))
  | Search.By_stable (Double root) => to64 (Formas.low (ends_of root))
  | Search.By_exact x => Ends.next_below (Chain.printed_t (round_exact x))
  | _ => Limits.zero
  end.
Definition high (w : Search.evidence finding) : Limits.binary64 :=
  match w with
  | Search.By_triage (Single root _ _) => to64 (Formas.high (Formas.ends_of root))
  | Search.By_stable (Double root) => to64 (Formas.high (ends_of root))
  | Search.By_exact x => Ends.next_above (Chain.printed_t (round_exact x))
  | _ => Limits.zero
  end.
Definition less (f g : finding) : bool := match f, g with Double a, Double b => certainly_less a b | _, _ => false end.

(** Rounded where it is certain; and where it is a binary64 that the machine has, of which all but what is beyond the largest
    number is. *)
Definition rounded_of (e : Elemento) (root : Formas.known twofold) : option Chain.printed :=
  let once := round_on p v (shape_of e) (Formas.value root) (Formas.error root) in
  if all_certain once && (is_stored (of_t once) && is_stored (of_x once) && is_stored (of_y once) && is_stored (of_z once))
  then Some (Chain.Printed (to64 (of_t once)) (to64 (of_x once)) (to64 (of_y once)) (to64 (of_z once)))
  else None.
Definition rounded (e : Elemento) (f : finding) : option Chain.printed :=
  match f with Double root | Running.Improved root => rounded_of e root | Single _ _ _ => None end.

Lemma rounded_of_runs e root out : rounded_of e root = Some out ->
  let once := round_on p v (shape_of e) (Formas.value root) (Formas.error root) in
  all_certain once = true /\ Once.stores out once.
Proof.
  unfold rounded_of; cbv zeta; set (once := round_on _ _ _ _ _); intros H.
  destruct (all_certain once); [|discriminate]; split; [reflexivity|]; cbn [andb] in H.
  destruct (is_stored (of_t once) && is_stored (of_x once) && is_stored (of_y once) && is_stored (of_z once)) eqn:E; [|discriminate].
  injection H as <-; rewrite !andb_true_iff in E; destruct E as [[[Et Ex] Ey] Ez].
  unfold Once.stores; cbn [Chain.printed_t Chain.printed_x Chain.printed_y Chain.printed_z]; auto using is_stored_right.
Qed.

(** ** The exact rounding *)

Hypothesis power_of_two : exists k, (0 <= k)%Z /\ S = (2 ^ k)%Z.

Definition of_surd (x : Surd.surd) : ExactHit.surd_of :=
  ExactHit.Surd_of (ExactHit.Number (Surd.num x) 0) (ExactHit.Number (Surd.coef x) 0) (ExactHit.Number (Surd.rad x) 0)
    (ExactHit.Number (Surd.den x) 0).

Lemma integer n : ExactHit.amount (ExactHit.Number n 0) = IZR n.
Proof. unfold ExactHit.amount, Quick.dyadic; cbn [ExactHit.significand ExactHit.exponent]; change (bpow radix2 0) with 1; ring. Qed.

Lemma of_surd_right x : Surd.valid x -> ExactHit.sound (of_surd x) /\ ExactHit.denotes (of_surd x) = Surd.val x.
Proof.
  intros [Hr Hd]; split; [split; cbn; lia|]; unfold ExactHit.denotes, Surd.val, of_surd; cbn [ExactHit.sx ExactHit.sy ExactHit.sdelta
    ExactHit.sw]; now rewrite !integer.
Qed.

Lemma stored_into s x : ExactHit.sound s -> Limits.rounded_once x (ExactHit.denotes s) -> ExactHit.rounded_into s x.
Proof.
  intros [Hd Hw] Hx turns out E; unfold ExactHit.rounding in E; apply Exactly.exactly_is_right in E; auto; rewrite E.
  now apply rounded_is_stored.
Qed.

Lemma exact_runs x : Surd.valid x -> exists t, ExactHit.sound t /\ ExactHit.denotes t = Surd.val x /\
  ExactHit.hit_into p v t (round_exact x).
Proof.
  intros Hx; destruct power_of_two as (k & Hk & ES), (of_surd_right x Hx) as [Hs Hv].
  assert (HS : (0 < S)%Z) by (rewrite ES; now apply Z.pow_pos_nonneg).
  exists (of_surd x); split; [exact Hs | split; [exact Hv|]].
  destruct (Chain.exactly_printed_is_rounded_once Z.sqrt 0 0 0 0 S origin way x HS Hx) as (Ht & X & Y & Z0).
  assert (Over : forall n, ExactHit.amount (ExactHit.Number n (- k)) = Exacto.over S n).
  { intros n; unfold ExactHit.amount, Quick.dyadic, Exacto.over; cbn [ExactHit.significand ExactHit.exponent].
    now rewrite ES, bpow_opp, (IZR_Zpower radix2) by exact Hk. }
  assert (Axis : forall a b y, Limits.rounded_once y (Exacto.over S a + Surd.val x * Exacto.over S b) ->
    ExactHit.axis_into (Exacto.over S a) (Exacto.over S b) (of_surd x) y).
  { intros a b y Hy; exists (ExactHit.Number a (- k)), (ExactHit.Number b (- k)); split; [apply Over | split; [apply Over|]].
    destruct (ExactHit.linear_right (ExactHit.Number a (- k)) (ExactHit.Number b (- k)) _ Hs) as [Hl El].
    apply stored_into; [exact Hl|]; rewrite El, !Over, Hv, Rmult_comm; exact Hy. }
  split; [apply stored_into; [exact Hs | now rewrite Hv] | split; [now apply Axis | split; now apply Axis]].
Qed.

(** ** They run *)

Variables (s : Especificacion.Escena Elemento) (en : set Elemento) (elements : list Elemento) (in_range : Elemento -> bool).
Hypothesis ok : Escena_ok s.
Hypothesis ray_ok : Rayo_ok (ray_of p v).
Hypothesis described : forall e, In e elements -> stands Elemento s e (shape_of e) /\ (on e = true <-> en e).
Hypothesis range : forall e, In e elements -> in_range e = true -> in_bounds p v (shape_of e).

Lemma steps_in_range e : In e elements -> in_range e = true ->
  settles (alone_of p v (shape_of e) (on e)) /\ settles2 (second_of p v (shape_of e) (on e)).
Proof.
  intros He Hr; destruct (described e He) as [Hs _], (range e He Hr) as [Hray Ho].
  apply steps_settle; [exact (ray_fits p v ray_ok Hray) | exact (stands_fit Elemento s ok e _ Hs Ho)].
Qed.

Theorem steps_by_the_recorded_terms_run :
  steps_run Elemento p v elements shape_of on in_range triage stable improved low high less rounded round_exact.
Proof.
  constructor.
  - intros e x He Hr; destruct (steps_in_range e He Hr) as [H _]; eexists; split; [apply answered_up_to, H | reflexivity].
  - intros e x He Hr; destruct (steps_in_range e He Hr) as [_ H]; eexists; split; [apply answered_pair_up_to, H | reflexivity].
  - intros e w He Hw; destruct w as [f | f | x].
    + destruct Hw as (Hr & x & E), (steps_in_range e He Hr) as [[_ Found] _]; unfold triage in E.
      destruct (answer_up_to _ x) as [| | root slope curvature] eqn:A; try discriminate; injection E as <-.
      exact (ends_stored root (Found _ _ _ _ A)).
    + destruct Hw as (Hr & x & E), (steps_in_range e He Hr) as [_ [_ Found]]; unfold stable in E.
      destruct (answer_up_to _ x) as [| | root slope curvature] eqn:A; try discriminate; injection E as <-.
      exact (ends_stored2 root (Found _ _ _ _ A)).
    + now split.
  - intros e root slope curvature g He Hr; unfold improved; cbv zeta; set (n := newton _ _ _ _).
    destruct (known_slope n); [intros [= <-]; now split | discriminate].
  - intros f g; destruct f as [| a |], g as [| b |]; try discriminate; intros H; now exists a, b.
  - intros e f out He H; destruct f as [| root | root]; [discriminate | |]; exists root; (split; [auto | now apply rounded_of_runs]).
  - exact exact_runs.
Qed.
End Steps.
