(** * Settled: beyond a great limit a step answers one thing, and what it finds is far below 2^1024

    A step compares what it computes with the limit and nothing else. All that it computes of numbers in range is below
    2^1010 (Sizes.v), so that its answer up to 2^1020 is that up to any greater limit: so it is also that up to infinity.

    far                 == 2^1020
    settles_for good small step == the step answers up to far what it answers up to any greater limit that is good, and what
                           it finds is small
    settles step        == so it is in binary64, of every limit;  settles2 step == in double-double, of binary64 limits
    modest f            == what is divided of a quadratic with two roots is below 2^540;  modest_flat: of one that is flat *)
From Coq Require Import Reals ZArith Lra Lia.
From Flocq Require Import Core.
From Durero Require Import Rounding Vectors Quotient Decision Verdict Linear Twofold Sums Sizes.
From Durero Require Formas Doubled Stable StableAdvance StableFlat.
Import Formas.Pairs.
Local Open Scope R_scope.
Local Opaque bpow.

Notation far := (bpow radix2 1020).

Section Settling.
Variable T : Type.
Variables (good : R -> Prop) (small : Formas.known T -> Prop).
Definition settles_for (step : R -> Formas.answer T) : Prop :=
  (forall limit, good limit -> far <= limit -> step limit = step far) /\
  forall limit root slope curvature, step limit = Formas.Hit root slope curvature -> small root.

Lemma settles_miss : settles_for (fun _ => Formas.Miss).
Proof. split; [reflexivity | discriminate]. Qed.
Lemma settles_undecided : settles_for (fun _ => Formas.Undecided).
Proof. split; [reflexivity | discriminate]. Qed.

Lemma settles_hit root slope curvature : small root -> settles_for (fun _ => Formas.Hit root slope curvature).
Proof. intros S; split; [reflexivity | intros _ root' s c [= <- _ _]; exact S]. Qed.

Lemma settles_equal step step' : (forall limit, step limit = step' limit) -> settles_for step' -> settles_for step.
Proof. intros E [A B]; split; [intros limit G H; rewrite !E; auto | intros limit root s c; rewrite E; apply B]. Qed.

Lemma settles_if (b : bool) f g : (b = true -> settles_for f) -> (b = false -> settles_for g) ->
  settles_for (fun limit => if b then f limit else g limit).
Proof. intros F G; destruct b; [apply (settles_equal _ f) | apply (settles_equal _ g)]; auto. Qed.

(** What is asked of the limit itself. *)
Lemma settles_past (test : R -> bool) f g : good far -> (forall limit, good limit -> far <= limit -> test limit = false) ->
  settles_for f -> settles_for g -> settles_for (fun limit => if test limit then f limit else g limit).
Proof.
  intros G0 No [A B] [C D]; split.
  - intros limit G H; rewrite !No; auto; apply Rle_refl.
  - intros limit root s c; destruct (test limit); [apply B | apply D].
Qed.
End Settling.

Definition settles : (R -> Formas.answer R) -> Prop := settles_for R (fun _ => True) sized.
Definition settles2 : (R -> Formas.answer twofold) -> Prop := settles_for twofold (fun limit => format limit) sized2.

Lemma format_far : format far.
Proof. now apply format_bpow. Qed.

(** The least that a root beside A can be. *)
Lemma least_below q q_error A_fl A_error limit : Rabs q <= bpow radix2 450 -> 2 * q_error < Rabs q -> 0 <= q_error ->
  bpow radix2 (-360) <= A_error -> far <= limit ->
  Rlt_bool limit (rnd (rnd ((9007198354021067 * bpow radix2 (-53)) * rnd (Rabs q - q_error)) / rnd (Rabs A_fl + A_error))) = false.
Proof.
  intros Hq Hqe He HA Hl; apply Rlt_bool_false; pose proof (bpow_gt_0 radix2 (-360)); pose proof (Rabs_pos A_fl).
  assert (Q : below 450 q) by (split; [lia | exact Hq]).
  assert (E : below 450 q_error) by (split; [lia | rewrite Rabs_pos_eq; lra]).
  assert (M : below 1 (9007198354021067 * bpow radix2 (-53))).
  { split; [lia|]; replace (bpow radix2 (-53)) with (/ 9007199254740992) by reflexivity; replace (bpow radix2 1) with 2 by reflexivity.
    rewrite Rabs_pos_eq; lra. }
  assert (D : bpow radix2 (- 360) <= Rabs (rnd (Rabs A_fl + A_error))).
  { apply Rle_trans with (2 := Rle_abs _), rnd_ge_bpow; [lia | change (- (360))%Z with (-360)%Z; lra]. }
  assert (B : below 1020 (rnd (rnd ((9007198354021067 * bpow radix2 (-53)) * rnd (Rabs q - q_error)) / rnd (Rabs A_fl + A_error)))).
  { apply below_rnd, (below_more (452 + 360)); [|lia]; apply divided; [lia | | exact D].
    apply below_rnd; change 452%Z with (1 + (Z.max 450 450 + 1))%Z; apply below_mult; [exact M|].
    apply below_rnd, below_minus; [apply below_abs, Q | exact E]. }
  apply Rle_trans with (2 := Hl), Rle_trans with (2 := proj2 B), Rle_abs.
Qed.

(** ** In binary64 *)

Lemma turn_settles place curvature root slope next : sized root -> format (Formas.error root) -> settles next ->
  settles (fun limit => turn place limit curvature root slope (next limit)).
Proof.
  intros [Sv Se] Fe Hn; unfold turn; apply settles_past; [exact I | | apply settles_miss|].
  - intros limit _ Hl; unfold Formas.beyond; apply Rlt_bool_false; rewrite <- (rnd_format _ Fe); apply rnd_le.
    destruct Sv as [_ Sv], Se as [_ Se]; apply Rabs_le_inv in Sv, Se.
    assert (2 * bpow radix2 1010 <= far).
    { replace 2 with (bpow radix2 1) by reflexivity; rewrite <- bpow_plus; apply bpow_le; lia. }
    lra.
  - apply settles_if; intros _; [now apply settles_hit|]; apply settles_if; intros _; [exact Hn | apply settles_undecided].
Qed.

Record modest (f : Formas.quadratic R) : Prop := Modest {
  B_below : below 540 (Formas.B f); B_error_below : below 540 (Formas.B_error f);
  C_below : below 540 (Formas.C f); C_error_below : below 540 (Formas.C_error f) }.

Section Curved.
Variable f : Formas.quadratic R.
Variables A B C F H : R.
Hypothesis f_sound : sound f A B C F H.
Hypothesis f_modest : modest f.
Notation A_fl := (Formas.A f).
Notation A_error := (Formas.A_error f).
Notation B_error := (Formas.B_error f).
Notation q := (Formas.value (Formas.q (total f))).
Notation q_error := (Formas.error (Formas.q (total f))).

Lemma q_sized : B_error < Formas.F f -> 2 * q_error < Rabs q ->
  below 540 q /\ below 540 q_error /\ bpow radix2 (-360) <= q_error /\ format q_error /\ Rabs q <= bpow radix2 450.
Proof.
  intros HF Hq; destruct (q_bound f A B C F H f_sound HF) as (_ & He & H450 & _ & Fe & _); pose proof (bpow_gt_0 radix2 (-360)).
  assert (bpow radix2 450 <= bpow radix2 540) by (apply bpow_le; lia).
  repeat split; auto; try lia; [lra|]; rewrite Rabs_pos_eq; lra.
Qed.

Lemma A_error_known : bpow radix2 (-360) <= A_error /\ format A_error.
Proof. exact (conj (proj1 (errors_least f A B C F H f_sound)) (proj1 (proj2 (proj2 (binary64 f A B C F H f_sound))))). Qed.

Lemma single_settles place past : (forall only, settles only -> B_error < Formas.F f -> 2 * q_error < Rabs q ->
   settles (fun limit => past limit (only limit))) -> settles (fun limit => single f place (past limit) limit).
Proof.
  intros Past; unfold single; apply settles_if; intros _; [apply settles_miss|]; apply settles_if; intros HF; [|apply settles_undecided].
  apply settles_if; intros Hq; [|apply settles_undecided]; revert HF Hq.
  destruct (Rlt_bool_spec B_error (Formas.F f)) as [HF|]; [intros _ | discriminate]; intros Hq.
  destruct (q_bound f A B C F H f_sound HF) as (_ & _ & _ & _ & Fqe & _); rewrite (rnd_double _ Fqe) in Hq; revert Hq.
  destruct (Rlt_bool_spec (2 * q_error) (Rabs q)) as [Hq|]; [intros _ | discriminate].
  destruct (q_sized HF Hq) as (Sq & Sqe & Lq & _ & _), A_error_known as [LA FA]; pose proof (bpow_gt_0 radix2 (-360)).
  assert (SC : sized (from_C f)).
  { apply (quotient_sized 540 360); auto; try lia; try apply f_modest.
    pose proof (proj2 (proj2 (errors_least f A B C F H f_sound))); lra. }
  assert (ByC : forall next, settles next -> settles (fun limit => by_C f place limit (next limit))).
  { intros next; apply turn_settles; [exact SC | apply format_rnd]. }
  apply settles_if; intros HA.
  - rewrite (rnd_double _ FA) in HA; revert HA; destruct (Rlt_bool_spec (2 * A_error) (Rabs A_fl)) as [HA|]; [intros _ | discriminate].
    assert (SA : sized (from_A f)) by (apply (quotient_sized 540 360); auto; try lia; lra).
    assert (ByA : forall next, settles next -> settles (fun limit => by_A f place limit (next limit))).
    { intros next; apply turn_settles; [exact SA | apply format_rnd]. }
    destruct (A_root_first f); [apply ByA, ByC | apply ByC, ByA]; apply settles_miss.
  - apply (Past (fun limit => if A_root_first f then by_C f place limit Formas.Miss else by_C f place limit Formas.Miss)); auto.
    destruct (A_root_first f); apply ByC, settles_miss.
Qed.

Lemma past_limit_settles only : settles only -> B_error < Formas.F f -> 2 * q_error < Rabs q ->
  settles (fun limit => past_limit f limit (only limit)).
Proof.
  intros Ho HF Hq; destruct (q_sized HF Hq) as (_ & _ & Lq & _ & Hq450), A_error_known as [LA _]; pose proof (bpow_gt_0 radix2 (-360)).
  unfold past_limit; apply settles_past; [exact I | | exact Ho | apply settles_undecided].
  intros limit _; apply least_below; auto; lra.
Qed.

Lemma past_stretch_settles only : settles only -> B_error < Formas.F f -> 2 * q_error < Rabs q ->
  settles (fun limit => past_stretch f limit (only limit)).
Proof.
  intros Ho HF Hq; destruct (q_sized HF Hq) as (_ & _ & Lq & _ & Hq450), A_error_known as [LA _]; pose proof (bpow_gt_0 radix2 (-360)).
  unfold past_stretch; apply settles_past; [exact I | | exact Ho | apply settles_if; auto using settles_undecided].
  intros limit _; apply least_below; auto; lra.
Qed.

Lemma from_settles place : settles (fun limit => single_from f place limit).
Proof.
  destruct A_error_known as [LA FA]; pose proof (bpow_gt_0 radix2 (-360)); unfold single_from; apply settles_if; intros HA;
    [|apply settles_undecided].
  rewrite (rnd_double _ FA) in HA; revert HA; destruct (Rlt_bool_spec (2 * A_error) (Rabs A_fl)) as [HA|]; [intros _ | discriminate].
  apply turn_settles; [| apply format_rnd | apply settles_miss]; pose proof (B_below f f_modest); pose proof (B_error_below f f_modest).
  apply (quotient_sized 542 360); auto; try lia.
  - eapply below_more; [size | vm_compute; discriminate].
  - eapply below_more; [size | vm_compute; discriminate].
  - apply rnd_nonneg; pose proof (proj1 (proj2 (errors_least f A B C F H f_sound))); lra.
Qed.

Theorem curved_settles : settles (Formas.first_of_curved f) /\ settles (Formas.first_of_curved_on f).
Proof.
  split; eapply settles_equal.
  - intros limit; apply single_is_recorded.
  - apply (single_settles (Formas.place f) (past_limit f)), past_limit_settles.
  - intros limit; apply (from_is_recorded f limit).
  - apply from_settles.
Qed.

Theorem axial_settles : settles (Formas.first_of_curved_axial f) /\ settles (Formas.first_of_curved_on_axial f).
Proof.
  split; eapply settles_equal.
  - intros limit; apply single_axial_is_recorded.
  - apply (single_settles (Formas.place_axial f) (past_stretch f)), past_stretch_settles.
  - intros limit; apply (from_is_recorded f limit).
  - apply from_settles.
Qed.
End Curved.

Section Flat.
Variable f : Formas.quadratic R.
Variables B C : R.
Hypothesis f_sound : sound_flat f B C.
Hypothesis C_flat : below 430 (Formas.C f).
Hypothesis C_error_flat : below 430 (Formas.C_error f).
Hypothesis B_error_flat : flat_known f = true -> bpow radix2 (-520) <= Formas.B_error f.

Lemma alone_settles place : settles (flat_alone f place).
Proof.
  pose proof f_sound as [_ NC (FB & _ & Fe & _) _ _]; unfold flat_alone; apply settles_if; intros K; [|apply settles_undecided].
  pose proof (B_error_flat K) as Low; destruct (known_means f B C f_sound K) as [Hbig _]; pose proof (bpow_gt_0 radix2 (-520)).
  apply turn_settles; [| apply format_rnd | apply settles_miss]; unfold only_root.
  replace (Formas.B f + Formas.B f) with (2 * Formas.B f) by ring; rewrite !rnd_double by assumption.
  apply (quotient_sized 430 520); auto; try lia.
  - now apply below_opp.
  - apply Rle_trans with (2 := NC), Rabs_pos.
  - rewrite <- (rnd_double _ Fe); apply format_rnd.
  - change (- (520))%Z with (-520)%Z; lra.
  - rewrite Rabs_mult, (Rabs_pos_eq 2); lra.
Qed.

Theorem linear_settles : settles (Formas.first_of_linear f) /\ settles (Formas.first_of_linear_edged f).
Proof.
  split; eapply settles_equal; [| apply (alone_settles (Formas.place f)) | | apply (alone_settles (Formas.place_edged f))];
    intros limit; apply (flat_is_recorded f limit).
Qed.

Lemma linear_on_settles : settles (Formas.first_of_linear_on f).
Proof. unfold Formas.first_of_linear_on; apply settles_if; intros _; [apply settles_miss | apply settles_undecided]. Qed.
End Flat.
