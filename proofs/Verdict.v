(** * Verdict: what is decided of one ray and one element, up to a limit, and of a ray that starts on its element

    Decision.v has the decision in lanes on a quadratic with two roots; here are the others of trace/closed_form-inl.hpp,
    each shown to be the recorded term of Formas.v: for one ray alone and up to a limit (the nearer root first, and where
    A may be 0 only the root that does not depend on it, the other being beyond what matters), for a ray that starts on
    the element, so that C is 0, and where the quadratic is linear. What a root's place and the coefficients' bounds have
    to be is asked here and shown in other files, of each shape.

    right_in_lanes T d   == d says hit only within its error of the least of T, and miss only where T is empty
    right_up_to A B T x a == the answer a says so as well, where a miss is one up to x; of a hit also the slope
    graded A B t s a     == the slope A·t + B at t and the curvature A are within their errors, s and a
    turn, single         == what is decided of one root, and of one ray *)
From Coq Require Import Reals ZArith Lra Lia Psatz Bool.
From Flocq Require Import Core.
From Durero Require Import Trazador.
From Durero Require Import Rounding Quotient Roots Decision.
From Durero Require Formas.
Local Open Scope R_scope.
Local Opaque bpow.

Definition right_in_lanes (T : R -> Prop) (d : Formas.in_lanes) : Prop :=
  (Formas.hit d = true -> exists t, is_least T t /\ is_near (Formas.root d) t) /\
  (Formas.hit d = false -> Formas.undecided d = false -> forall t, ~ T t).

Definition graded (A B t : R) (slope curvature : Formas.known R) : Prop :=
  Rabs (A * t + B - Formas.value slope) <= Formas.error slope /\ Rabs (A - Formas.value curvature) <= Formas.error curvature /\
  (format (Formas.value slope) /\ format (Formas.error slope)) /\
  (format (Formas.value curvature) /\ format (Formas.error curvature)) /\ bpow radix2 (-900) <= Formas.error slope.

Definition right_up_to (A B : R) (T : R -> Prop) (limit : R) (a : Formas.answer R) : Prop :=
  match a with
  | Formas.Miss => forall t, T t -> limit < t
  | Formas.Undecided => True
  | Formas.Hit root slope curvature => exists t, is_least T t /\ is_near root t /\ graded A B t slope curvature
  end.

Lemma right_in_lanes_equal T T' d : (forall t, T t <-> T' t) -> right_in_lanes T d -> right_in_lanes T' d.
Proof.
  intros E [Hh Hm]; split.
  - intros H; destruct (Hh H) as (t & [Ht Hl] & N); exists t; split; [split; [now apply E | intros t' H';
    now apply Hl, E] | exact N].
  - intros H U t Ht; now apply (Hm H U t), E.
Qed.

Lemma right_up_to_equal A B T T' limit a : (forall t, T t <-> T' t) -> right_up_to A B T limit a -> right_up_to A B T' limit a.
Proof.
  intros E; destruct a as [| | root slope curvature]; cbn [right_up_to]; [intros Hm t Ht; now apply Hm, E | auto |].
  intros (t & [Ht Hl] & N); exists t; split; [split; [now apply E | intros t' H'; now apply Hl, E] | exact N].
Qed.

(** ** One root *)

Lemma beyond_right root limit t : is_near root t -> format (Formas.error root) -> Formas.beyond root limit = true ->
  limit < t.
Proof.
  unfold Formas.beyond; intros N%near_within Fe H; destruct (Rlt_bool_spec (Formas.error root) (rnd (Formas.value root -
    limit)))
    as [Hlt|]; [|discriminate].
  assert (Formas.error root < Formas.value root - limit).
  { apply Rnot_le_lt; intros Hle; apply rnd_le in Hle; rewrite (rnd_format _ Fe) in Hle; lra. }
  apply Rabs_le_inv in N; lra.
Qed.

Section Turn.
Variable place : Formas.known R -> Formas.placed.
Variables (A B limit : R) (curvature : Formas.known R).

Definition turn (root slope : Formas.known R) (next : Formas.answer R) : Formas.answer R :=
  if Formas.beyond root limit then Formas.Miss
  else if Formas.inside (place root) then Formas.Hit root slope curvature
  else if Formas.outside (place root) then next
  else Formas.Undecided.

Lemma turn_right (T on : R -> Prop) root slope next t : is_near root t -> format (Formas.error root) ->
  (Formas.outside (place root) = true -> ~ on t) -> (Formas.inside (place root) = true -> on t) ->
  graded A B t slope curvature -> (on t -> is_least T t) -> (limit < t -> forall t', T t' -> limit < t') ->
  (~ on t -> right_up_to A B T limit next) -> right_up_to A B T limit (turn root slope next).
Proof.
  intros N Fe Hout Hin G Hleast Hbeyond Hnext; unfold turn.
  destruct (Formas.beyond root limit) eqn:E; [cbn; now apply Hbeyond, (beyond_right root)|].
  destruct (Formas.inside (place root)); [cbn; exists t; split; [now apply Hleast, Hin | now split]|].
  destruct (Formas.outside (place root)); [now apply Hnext, Hout | exact I].
Qed.
End Turn.

(** The one root in lanes. *)
Definition alone_in_lanes (known : bool) (at_root : Formas.placed) (root slope : Formas.known R) : Formas.in_lanes :=
  {| Formas.hit := andb known (Formas.inside at_root);
     Formas.undecided := negb (orb (andb known (Formas.inside at_root)) (andb known (Formas.outside at_root)));
     Formas.root := root;
     Formas.slope := slope |}.

Lemma alone_right (T on : R -> Prop) known at_root root slope :
  (known = true -> exists t, is_near root t /\ (Formas.outside at_root = true -> ~ on t) /\
   (Formas.inside at_root = true -> on t) /\ (forall t', T t' <-> t' = t /\ on t')) ->
  right_in_lanes T (alone_in_lanes known at_root root slope).
Proof.
  intros H; unfold alone_in_lanes; split; cbn [Formas.hit Formas.undecided Formas.root].
  - rewrite andb_true_iff; intros [K I]; destruct (H K) as (t & N & _ & Hin & HT); exists t; split; [|exact N].
    split; [apply HT; auto | intros t' Ht'; apply HT in Ht' as [-> _]; lra].
  - intros Hh; rewrite Hh; cbn [orb]; rewrite negb_false_iff, andb_true_iff; intros [K O].
    destruct (H K) as (t & _ & Hout & _ & HT); intros t' Ht'; apply HT in Ht' as [-> On]; now apply Hout.
Qed.

(** ** Two roots, one ray *)

Section Single.
Variable f : Formas.quadratic R.
Variables A B C F H : R.
Hypothesis f_sound : sound f A B C F H.

Notation A_fl := (Formas.A f).
Notation B_fl := (Formas.B f).
Notation F_fl := (Formas.F f).
Notation A_error := (Formas.A_error f).
Notation B_error := (Formas.B_error f).
Notation S_error := (Formas.error (root_of_D f)).
Notation q := (Formas.value (Formas.q (total f))).
Notation q_error := (Formas.error (Formas.q (total f))).
Notation S := (Formas.signed_root (total f)).
Notation x := (q_exact f A B C).
Notation root := (is_root A B C).

Definition least_of_A : R :=
  rnd (rnd ((9007198354021067 * bpow radix2 (-53)) * rnd (Rabs q - q_error)) / rnd (Rabs A_fl + A_error)).

Section Deciding.
Variable place : Formas.known R -> Formas.placed.
Variable past : Formas.answer R -> Formas.answer R.
Variable limit : R.
Notation turn := (turn place limit (Formas.Known A_fl A_error)).
Definition by_A (next : Formas.answer R) : Formas.answer R := turn (from_A f) (Formas.Known (- S) S_error) next.
Definition by_C (next : Formas.answer R) : Formas.answer R := turn (from_C f) (Formas.Known S S_error) next.
Definition single : Formas.answer R :=
  if Rlt_bool F_fl (- B_error) then Formas.Miss
  else if Rlt_bool B_error F_fl then
    if Rlt_bool (rnd (2 * q_error)) (Rabs q) then
      if Rlt_bool (rnd (2 * A_error)) (Rabs A_fl) then
        if A_root_first f then by_A (by_C Formas.Miss) else by_C (by_A Formas.Miss)
      else past (if A_root_first f then by_C Formas.Miss else by_C Formas.Miss)
    else Formas.Undecided
  else Formas.Undecided.
End Deciding.

(** Where A may be 0: the root q/A is beyond the limit, or beyond the stretch. *)
Definition past_limit (limit : R) (only : Formas.answer R) : Formas.answer R :=
  if Rlt_bool limit least_of_A then only else Formas.Undecided.
Definition past_stretch (limit : R) (only : Formas.answer R) : Formas.answer R :=
  if Rlt_bool limit least_of_A then only
  else if Rlt_bool (rnd (2 * Formas.reach f))
    (rnd (least_of_A * rnd (Rabs (Formas.s1 f) - rnd (bpow radix2 (-51) * Formas.speed f)))) then only
  else Formas.Undecided.

(** The recorded terms are this: Qed compares them, with rounding folded, since it doubles a term to unfold it. *)
Local Opaque round.
Theorem single_is_recorded limit :
  Formas.first_of_curved f limit = single (Formas.place f) (past_limit limit) limit.
Proof. exact_no_check (eq_refl (single (Formas.place f) (past_limit limit) limit)). Qed.

Theorem single_axial_is_recorded limit :
  Formas.first_of_curved_axial f limit = single (Formas.place_axial f) (past_stretch limit) limit.
Proof. exact_no_check (eq_refl (single (Formas.place_axial f) (past_stretch limit) limit)). Qed.
Local Transparent round.

Lemma q_exact_facts : B_error < F_fl -> 2 * q_error < Rabs q ->
  x <> 0 /\ x * x + 2 * B * x + A * C = 0 /\ (if Rle_bool 0 B_fl then x < 0 /\ 0 < - (x + B) else 0 < x /\ 0 < x + B).
Proof.
  intros HF Hq; destruct (meets f A B C F H f_sound HF) as (HD & _);
    destruct (q_bound f A B C F H f_sound HF) as (Hx & _ & _ & _ & _ & Hl).
  pose proof (sqrt_lt_R0 _ HD) as Hs; pose proof (sqrt_sqrt _ (Rlt_le _ _ HD)) as Hss;
    pose proof (B_near f A B C F H f_sound) as HB.
  destruct (errors_least f A B C F H f_sound) as (_ & He & _); pose proof (bpow_gt_0 radix2 (-360)).
  unfold q_exact in *; set (r := sqrt (B * B - A * C)) in *; apply Rabs_le_inv in HB, Hx.
  assert (Hbig : q < - (2 * q_error) \/ 2 * q_error < q) by (unfold Rabs in Hq; destruct Rcase_abs in Hq; lra).
  destruct (Rle_bool_spec 0 B_fl); (split; [lra|]); (split; [|lra]).
  - replace (- (B + r) * - (B + r) + 2 * B * - (B + r) + A * C) with (r * r - (B * B - A * C)) by ring; lra.
  - replace (- (B + - r) * - (B + - r) + 2 * B * - (B + - r) + A * C) with (r * r - (B * B - A * C)) by ring; lra.
Qed.

(** The roots are q/A, where A is not 0, and C/q. *)
Lemma roots_of t : B_error < F_fl -> x <> 0 -> (root t <-> A * t = x \/ t = C / x).
Proof.
  intros HF Hx; destruct (meets f A B C F H f_sound HF) as (HD & _).
  exact (roots_are A B C _ x (Rle_bool 0 B_fl) (sqrt_sqrt _ (Rlt_le _ _ HD)) eq_refl Hx t).
Qed.

Lemma least_of_A_right t : B_error < F_fl -> 2 * q_error < Rabs q -> A * t = x -> 0 <= least_of_A <= Rabs t.
Proof.
  intros HF Hq Ht; destruct (q_bound f A B C F H f_sound HF) as (Hx & He & Hq450 & Fq & Fqe & _).
  destruct (binary64 f A B C F H f_sound) as (FA & _ & FAe & _), (errors_least f A B C F H f_sound) as (HAe & _).
  destruct (sizes f A B C F H f_sound) as (HA450 & _); pose proof (A_near f A B C F H f_sound) as HA.
  pose proof (A_error_size f A B C F H f_sound) as HAe450; pose proof (bpow_gt_0 radix2 (-360)).
  apply (computed_least q q_error A_fl A_error x A t); auto.
  - pose proof (Rabs_triang_inv q (q - x)) as Htr; replace (q - (q - x)) with x in Htr by ring; lra.
  - pose proof (Rabs_triang A_fl (- (A_fl - A))) as Htr; rewrite Rabs_Ropp in Htr.
    replace (A_fl + - (A_fl - A)) with A in Htr by ring; pose proof (Rabs_pos A_fl); lra.
Qed.

Definition points (on : R -> Prop) (t : R) : Prop := root t /\ on t.

(** The slope at each root is √D or its opposite, with the sign of B. *)
Lemma graded_root t s : B_error < F_fl -> Rabs (A * t + B - s) <= S_error -> s = S \/ s = - S ->
  graded A B t (Formas.Known s S_error) (Formas.Known A_fl A_error).
Proof.
  intros HF N Hs; destruct (meets f A B C F H f_sound HF) as (HD & S360 & _ & _ & SH).
  destruct (binary64 f A B C F H f_sound) as (FA & _ & FAe & _).
  assert (Fs : format s).
  { assert (F0 : format (Formas.value (root_of_D f))) by apply format_rnd.
    change S with (if Rle_bool 0 B_fl then Formas.value (root_of_D f) else - Formas.value (root_of_D f)) in Hs.
    destruct (Rle_bool 0 B_fl), Hs as [-> | ->]; repeat apply generic_format_opp; exact F0. }
  unfold graded; cbn [Formas.value Formas.error].
  split; [exact N|]; split; [rewrite Rabs_minus_sym; exact (A_near f A B C F H f_sound)|].
  split; [split; [exact Fs | apply format_rnd]|]; split; [now split|].
  assert (Low : bpow radix2 (-411) <= bpow radix2 (-51) * Formas.value (root_of_D f)).
  { change (-411)%Z with (-51 + -360)%Z; rewrite bpow_plus; apply Rmult_le_compat_l; [apply bpow_ge_0 | exact S360]. }
  apply Rle_trans with (bpow radix2 (-411)); [apply bpow_le; lia|]; apply rnd_ge_bpow; [lia|].
  apply rnd_ge_bpow in Low; [|lia]; set (bound := rnd (bpow radix2 (-51) * _)) in *.
  change (bpow radix2 (-411) <= rnd (rnd (rnd (3 * B_error) * Formas.H f) / Formas.value (root_of_D f)) + bound).
  destruct (errors_least f A B C F H f_sound) as (_ & He & _); pose proof (bpow_gt_0 radix2 (-360)).
  assert (0 <= Formas.H f) by lra; enough (0 <= rnd (rnd (rnd (3 * B_error) * Formas.H f) / Formas.value (root_of_D f))) by lra.
  apply rnd_nonneg, Rmult_le_pos; [|apply Rlt_le, Rinv_0_lt_compat; lra].
  apply rnd_nonneg, Rmult_le_pos; [apply rnd_nonneg; lra | assumption].
Qed.

Lemma graded_by_A t : B_error < F_fl -> A * t = x -> graded A B t (Formas.Known (- S) S_error) (Formas.Known A_fl A_error).
Proof.
  intros HF Ht; apply graded_root; auto; destruct (meets f A B C F H f_sound HF) as (_ & _ & HS & HS0 & _).
  change S with (if Rle_bool 0 B_fl then Formas.value (root_of_D f) else - Formas.value (root_of_D f)).
  rewrite Ht; unfold q_exact; apply Rabs_le_inv in HS; destruct (Rle_bool 0 B_fl); apply Rabs_le; lra.
Qed.

Lemma graded_by_C t : B_error < F_fl -> 2 * q_error < Rabs q -> t = C / x ->
  graded A B t (Formas.Known S S_error) (Formas.Known A_fl A_error).
Proof.
  intros HF Hq ->; apply graded_root; auto; destruct (meets f A B C F H f_sound HF) as (_ & _ & HS & HS0 & _).
  destruct (q_exact_facts HF Hq) as (Hx & E & _).
  change S with (if Rle_bool 0 B_fl then Formas.value (root_of_D f) else - Formas.value (root_of_D f)).
  replace (A * (C / x) + B) with (- (x + B)) by (apply Rmult_eq_reg_r with x; [field_simplify; lra | exact Hx]).
  unfold q_exact; apply Rabs_le_inv in HS; destruct (Rle_bool 0 B_fl); apply Rabs_le; lra.
Qed.

Theorem single_right (on : R -> Prop) place past limit : places on place -> (forall t, on t -> 0 < t) ->
  (B_error < F_fl -> 2 * q_error < Rabs q -> forall only,
   past only = Formas.Undecided \/ past only = only /\ forall t, A * t = x -> on t -> limit < t) ->
  right_up_to A B (points on) limit (single place past limit).
Proof.
  intros Hplace Hon Hpast; unfold single.
  destruct (Rlt_bool_spec F_fl (- B_error)) as [Hmiss|_].
  { intros t [Ht _]; now elim (no_root f A B C F H f_sound t Hmiss). }
  destruct (Rlt_bool_spec B_error F_fl) as [HF|_]; [|exact I].
  destruct (binary64 f A B C F H f_sound) as (FA & _ & FAe & _ & FCe).
  destruct (q_bound f A B C F H f_sound HF) as (Hqb & Hqe & Hq450 & Fq & Fqe & _).
  destruct (Rlt_bool (rnd (2 * q_error)) (Rabs q)) eqn:Eq; [|exact I].
  destruct (Rlt_bool (rnd (2 * A_error)) (Rabs A_fl)) eqn:EA.
  - assert (HR : has_roots f = true) by (unfold has_roots; rewrite Eq, EA, Rlt_bool_true by exact HF; reflexivity).
    destruct (has_roots_spec f A B C F H f_sound HR) as (_ & Hq & _).
    destruct (two_roots_by f A B C F H f_sound HR) as (t0 & t1 & Hby & Hlt & Hall & Hnear).
    destruct (Hnear (nearer f) t0 (or_introl (conj eq_refl eq_refl))) as (N0 & F0 & G0 & L0).
    destruct (Hnear (farther f) t1 (or_intror (conj eq_refl eq_refl))) as (N1 & F1 & G1 & L1).
    assert (Hturns : forall s0 s1, graded A B t0 s0 (Formas.Known A_fl A_error) ->
      graded A B t1 s1 (Formas.Known A_fl A_error) -> right_up_to A B (points on) limit (turn place limit (Formas.Known A_fl A_error) (nearer f) s0
      (turn place limit (Formas.Known A_fl A_error) (farther f) s1 Formas.Miss))).
    { intros s0 s1 Gr0 Gr1; destruct (Hplace (nearer f) t0 (near_within _ _ N0) F0 G0 L0) as [Out0 In0].
      destruct (Hplace (farther f) t1 (near_within _ _ N1) F1 G1 L1) as [Out1 In1].
      apply (turn_right place A B limit _ (points on) on _ _ _ t0 N0 G0 Out0 In0 Gr0).
      - intros On; split; [split; [apply Hall; tauto | exact On] | intros t' [Ht' _]; apply Hall in Ht'; lra].
      - intros Hb t' [Ht' _]; apply Hall in Ht'; lra.
      - intros Off0; assert (Honly : forall t', points on t' -> t' = t1).
        { intros t' [Ht' On]; destruct (proj1 (Hall t') Ht') as [-> | ->]; [now elim Off0 | reflexivity]. }
        apply (turn_right place A B limit _ (points on) on _ _ _ t1 N1 G1 Out1 In1 Gr1).
        + intros On; split; [split; [apply Hall; tauto | exact On] | intros t' Ht'; rewrite (Honly t' Ht'); lra].
        + intros Hb t' Ht'; now rewrite (Honly t' Ht').
        + intros Off1 t' Ht'; pose proof (Honly t' Ht') as E; destruct Ht' as [_ On]; subst t'; now elim Off1. }
    unfold by_A, by_C; unfold nearer, farther, choose in Hturns.
    destruct (A_root_first f), Hby as [H0 H1]; apply Hturns; auto using graded_by_A, graded_by_C.
  - rewrite (rnd_double _ Fqe) in Eq; destruct (Rlt_bool_spec (2 * q_error) (Rabs q)) as [Hq|]; [|discriminate].
    destruct (q_exact_facts HF Hq) as (Hx0 & HxE & Hsign).
    replace (if A_root_first f then by_C place limit Formas.Miss else by_C place limit Formas.Miss)
      with (by_C place limit Formas.Miss) by now destruct (A_root_first f).
    destruct (Hpast HF Hq (by_C place limit Formas.Miss)) as [-> | [-> Hfar]]; [exact I|].
    destruct (errors_least f A B C F H f_sound) as (_ & _ & HC360).
    destruct (quotient_bound _ _ _ _ _ _ FCe Fq Fqe HC360 (C_near f A B C F H f_sound) Hqb (conj Hq Hq450)) as (N & L &
      Ft & Fe).
    fold (from_C f) in N, L, Ft, Fe; destruct (Hplace (from_C f) (C / x) (near_within _ _ N) Ft Fe L) as [Out In].
    assert (Hcase : forall t, points on t -> t = C / x \/ (A * t = x /\ on t)).
    { intros t [Ht On]; apply (roots_of t HF Hx0) in Ht as [Ht|Ht]; auto. }
    apply (turn_right place A B limit _ (points on) on _ _ _ (C / x) N Fe Out In (graded_by_C _ HF Hq eq_refl)).
    + intros On; split; [split; [apply (roots_of _ HF Hx0); now right | exact On]|].
      intros t' Ht'; destruct (Hcase t' Ht') as [-> | [HA On']]; [lra|]; pose proof (Hon t' On') as Hpos.
      destruct (meets f A B C F H f_sound HF) as (HD & _).
      apply (root_of_C_first A B C _ x (Rle_bool 0 B_fl) (sqrt_sqrt _ (Rlt_le _ _ HD)) (sqrt_lt_R0 _ HD) eq_refl Hx0 t'); auto.
      destruct (Rle_bool 0 B_fl); lra.
    + intros Hb t' Ht'; destruct (Hcase t' Ht') as [-> | [HA On']]; [exact Hb | now apply Hfar].
    + intros Off t' Ht'; destruct (Hcase t' Ht') as [E | [HA On']]; [|now apply Hfar].
      destruct Ht' as [_ On]; rewrite E in On; now elim Off.
Qed.

Lemma past_limit_right (on : R -> Prop) limit : (forall t, on t -> 0 < t) -> B_error < F_fl -> 2 * q_error < Rabs q ->
  forall only,
  past_limit limit only = Formas.Undecided \/ past_limit limit only = only /\ forall t, A * t = x -> on t -> limit < t.
Proof.
  intros Hon HF Hq only; unfold past_limit; destruct (Rlt_bool_spec limit least_of_A) as [Hl|]; [right | now left].
  split; [reflexivity|]; intros t Ht On; destruct (least_of_A_right t HF Hq Ht) as [_ Hle]; pose proof (Hon t On).
  rewrite Rabs_pos_eq in Hle by lra; lra.
Qed.

Lemma lanes_right (on : R -> Prop) place : places on place -> right_in_lanes (points on) (decided f place).
Proof.
  intros Hplace; destruct (the_decision_is_right f A B C F H f_sound on place Hplace) as [Hh Hm]; split.
  - intros E; destruct (Hh E) as (t & (Hr & On & Hl) & N); exists t; split; [|exact N].
    split; [now split | intros t' [Hr' On']; now apply Hl].
  - intros E U t [Hr On]; now apply (Hm E U t).
Qed.

(** ** The ray starts on the element: C is 0, and so is one root *)

Definition points_from (on : R -> Prop) (t : R) : Prop := is_root A B 0 t /\ on t.
Definition from_start : Formas.known R :=
  Formas.quotient (- rnd (B_fl + B_fl)) (rnd (2 * B_error)) A_fl A_error.
Definition single_from (place : Formas.known R -> Formas.placed) (limit : R) : Formas.answer R :=
  if Rlt_bool (rnd (2 * A_error)) (Rabs A_fl) then
    turn place limit (Formas.Known A_fl A_error) from_start (Formas.Known (- B_fl) B_error) Formas.Miss
  else Formas.Undecided.
Definition lanes_from (place : Formas.known R -> Formas.placed) : Formas.in_lanes :=
  alone_in_lanes (Rlt_bool (rnd (2 * A_error)) (Rabs A_fl)) (place from_start) from_start (Formas.Known (- B_fl) B_error).

Theorem from_is_recorded limit :
  Formas.first_of_curved_on f limit = single_from (Formas.place f) limit /\
  Formas.first_of_curved_on_axial f limit = single_from (Formas.place_axial f) limit /\
  Formas.first_in_lanes_on f = lanes_from (Formas.place f) /\
  Formas.first_in_lanes_on_axial f = lanes_from (Formas.place_axial f).
Proof. repeat split. Qed.

Lemma from_start_near (on : R -> Prop) : (forall t, on t -> 0 < t) -> Rlt_bool (rnd (2 * A_error)) (Rabs A_fl) = true ->
  exists t, A * t = - (2 * B) /\ is_near from_start t /\ format (Formas.value from_start) /\ format (Formas.error from_start) /\
  bpow radix2 (-900) <= Formas.error from_start /\ forall t', points_from on t' <-> t' = t /\ on t'.
Proof.
  intros Hon HA; destruct (binary64 f A B C F H f_sound) as (FA & FB & FAe & FBe & _); pose proof (bpow_gt_0 radix2 (-360)).
  destruct (errors_least f A B C F H f_sound) as (HAe & HBe & _), (sizes f A B C F H f_sound) as (HA450 & _).
  rewrite (rnd_double _ FAe) in HA; destruct (Rlt_bool_spec (2 * A_error) (Rabs A_fl)) as [HA2|]; [|discriminate].
  pose proof (A_near f A B C F H f_sound) as NA; pose proof (B_near f A B C F H f_sound) as NB.
  assert (E2 : - rnd (B_fl + B_fl) = - (2 * B_fl)) by (replace (B_fl + B_fl) with (2 * B_fl) by ring;
    now rewrite rnd_double).
  assert (NB2 : Rabs (- rnd (B_fl + B_fl) - - (2 * B)) <= rnd (2 * B_error)).
  { rewrite E2, (rnd_double _ FBe); apply Rabs_le_inv in NB; apply Rabs_le; lra. }
  destruct (quotient_bound (- (2 * B)) (- rnd (B_fl + B_fl)) (rnd (2 * B_error)) A A_fl A_error (format_rnd _) FA FAe
    ltac:(rewrite (rnd_double _ FBe); lra) NB2 NA (conj HA2 HA450)) as (N & L & Ft & Fe).
  assert (HA0 : A <> 0).
  { intros Z0; rewrite Z0, Rminus_0_r in NA; lra. }
  exists (- (2 * B) / A); split; [field; exact HA0|]; split; [exact N|]; split; [exact Ft|]; split; [exact Fe|]; split; [exact L|].
  intros t'; unfold points_from, is_root; split.
  - intros [Hr On]; split; [|exact On]; pose proof (Hon t' On).
    replace (A * t' * t' + 2 * B * t' + 0) with (t' * (A * t' + 2 * B)) in Hr by ring.
    apply Rmult_integral in Hr as [Hr|Hr]; [lra|]; apply Rmult_eq_reg_l with A; [field_simplify; lra | exact HA0].
  - intros [-> On]; split; [field; exact HA0 | exact On].
Qed.

Theorem lanes_from_right (on : R -> Prop) place : places on place -> (forall t, on t -> 0 < t) ->
  right_in_lanes (points_from on) (lanes_from place).
Proof.
  intros Hplace Hon; apply (alone_right _ on); intros HA; destruct (from_start_near on Hon HA) as (t & At & N & Ft & Fe & L & HT).
  destruct (Hplace from_start t (near_within _ _ N) Ft Fe L) as [Out In]; exists t; auto.
Qed.

Theorem single_from_right (on : R -> Prop) place limit : places on place -> (forall t, on t -> 0 < t) ->
  right_up_to A B (points_from on) limit (single_from place limit).
Proof.
  intros Hplace Hon; unfold single_from; destruct (Rlt_bool (rnd (2 * A_error)) (Rabs A_fl)) eqn:HA; [|exact I].
  destruct (from_start_near on Hon HA) as (t & At & N & Ft & Fe & L & HT), (Hplace from_start t (near_within _ _ N) Ft Fe L) as [Out In].
  assert (G : graded A B t (Formas.Known (- B_fl) B_error) (Formas.Known A_fl A_error)).
  { destruct (binary64 f A B C F H f_sound) as (FA & FB & FAe & FBe & _).
    destruct (errors_least f A B C F H f_sound) as (_ & HBe & _); pose proof (bpow_gt_0 radix2 (-360)).
    pose proof (B_near f A B C F H f_sound) as NB; unfold graded; cbn [Formas.value Formas.error].
    split; [rewrite At; apply Rabs_le_inv in NB; apply Rabs_le; lra|].
    split; [rewrite Rabs_minus_sym; exact (A_near f A B C F H f_sound)|].
    split; [split; [now apply generic_format_opp | exact FBe]|]; split; [now split|].
    apply Rle_trans with (2 := HBe), bpow_le; lia. }
  apply (turn_right place A B limit _ _ on _ _ _ t N Fe Out In G).
  - intros On; split; [now apply HT | intros t' Ht'; apply HT in Ht' as [-> _]; lra].
  - intros Hb t' Ht'; apply HT in Ht' as [-> _]; exact Hb.
  - intros Off t' Ht'; apply HT in Ht' as [-> On]; now elim Off.
Qed.
End Single.
