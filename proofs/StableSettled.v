(** * StableSettled: beyond a great limit the second step answers one thing, and what it finds is far below 2^1024

    As Settled.v, in double-double.

    modest2 f == what is divided of a quadratic with two roots is below 2^590 *)
From Coq Require Import Reals ZArith Lra Lia.
From Flocq Require Import Core.
From Durero Require Import Rounding Quotient Roots Decision Twofold Sums Ratios Words Small Doubled Stable StableFlat Sizes Settled.
From Durero Require Formas StableAdvance.
Import Formas.Pairs.
Local Open Scope R_scope.
Local Opaque bpow.

Lemma turn_settles2 place curvature root slope next : sized2 root ->
  (forall limit, format limit -> far <= limit -> beyond root limit = false) -> settles2 next ->
  settles2 (fun limit => turn place limit curvature root slope (next limit)).
Proof.
  intros S No Hn; unfold turn; apply settles_past; [apply format_far | exact No | apply settles_miss |].
  apply settles_if; intros _; [now apply settles_hit|]; apply settles_if; intros _; [exact Hn | apply settles_undecided].
Qed.

Lemma near_not_beyond root t limit : sized2 root -> near_pair root t -> format limit -> far <= limit -> beyond root limit = false.
Proof.
  intros [[_ Sv] [_ Se]] [N _] Fl Hl; destruct (beyond root limit) eqn:E; [exfalso | reflexivity].
  apply (beyond_pair root limit t N Fl) in E; destruct N as (N & W & _ & Le); destruct (double_word_is_pair _ W) as (_ & _ & L).
  pose proof u_bounds; pose proof (bpow_gt_0 radix2 (-900)); apply Rabs_le_inv in N, Sv; unfold whole in N.
  assert (Hu : u * Rabs (hi (Formas.value root)) <= 1 * Rabs (hi (Formas.value root))) by (apply Rmult_le_compat_r; [apply Rabs_pos | lra]).
  assert (Rabs (hi (Formas.value root)) <= bpow radix2 1010) by (now apply Rabs_le).
  assert (Hlo : Rabs (lo (Formas.value root)) <= bpow radix2 1010) by lra; apply Rabs_le_inv in Hlo, Se.
  assert (4 * bpow radix2 1010 <= far).
  { replace 4 with (bpow radix2 2) by reflexivity; rewrite <- bpow_plus; apply bpow_le; lia. }
  lra.
Qed.

Lemma zero_not_beyond root limit : Formas.value root = Twofold 0 0 -> Formas.error root = 0 -> format limit -> far <= limit ->
  beyond root limit = false.
Proof.
  intros Ev Ee Fl Hl; unfold beyond; rewrite Ev, Ee; apply Rlt_bool_false, Rnot_lt_le; intros Hlt.
  assert (Wz : double_word (Twofold 0 0)).
  { unfold double_word, whole; cbn [hi lo]; rewrite Rplus_0_r, rnd_0; repeat split; apply generic_format_0. }
  destruct (exactly_word limit Fl) as [We Ee']; destruct (difference_near _ _ Wz We) as [Wd Hd].
  apply (word_above _ _ Wd (generic_format_0 _ _)) in Hlt; rewrite Ee' in Hd; pose proof (bpow_gt_0 radix2 1020).
  unfold whole at 2 3 in Hd; cbn [hi lo] in Hd; replace (0 + 0 - limit) with (- limit) in Hd by ring.
  rewrite Rabs_Ropp, (Rabs_pos_eq limit) in Hd by lra; pose proof (u_part limit ltac:(lra)) as Hu; pose proof (u_part _ (proj1 Hu)).
  apply Rabs_le_inv in Hd; lra.
Qed.

Record modest2 (f : Formas.quadratic twofold) : Prop := Modest2 {
  B_below2 : below2 590 (Formas.B f); B_error_below2 : below 590 (Formas.B_error f);
  C_below2 : below2 590 (Formas.C f); C_error_below2 : below 590 (Formas.C_error f) }.

Section Curved.
Variable f : Formas.quadratic twofold.
Variables A B C F H : R.
Hypothesis f_sound : sound2 f A B C F H.
Hypothesis f_modest : modest2 f.
Notation A_w := (Formas.A f).
Notation B_w := (Formas.B f).
Notation A_error := (Formas.A_error f).
Notation B_error := (Formas.B_error f).
Notation q := (Formas.value (Formas.q (total f))).
Notation q_error := (Formas.error (Formas.q (total f))).

Lemma q_sized2 : B_error < hi (Formas.F f) -> 2 * q_error < Rabs (hi q) ->
  below2 600 q /\ below 600 q_error /\ bpow radix2 (-360) <= q_error /\ format q_error /\ Rabs (hi q) <= bpow radix2 450 /\ double_word q.
Proof.
  intros HF Hq; destruct (q_bound f A B C F H f_sound HF) as (_ & He & H450 & W & Fe & _); pose proof (bpow_gt_0 radix2 (-360)).
  assert (bpow radix2 450 <= bpow radix2 600) by (apply bpow_le; lia); destruct (double_word_is_pair _ W) as (_ & _ & L).
  pose proof u_bounds; assert (u * Rabs (hi q) <= 1 * Rabs (hi q)) by (apply Rmult_le_compat_r; [apply Rabs_pos | lra]).
  split; [split; (split; [lia | lra])|]; split; [split; [lia | rewrite Rabs_pos_eq; lra]|]; repeat split; auto; apply W.
Qed.

Lemma A_error_known2 : bpow radix2 (-360) <= A_error /\ format A_error /\ Rabs (hi A_w) <= bpow radix2 450 /\ double_word A_w.
Proof.
  destruct (errors_least _ _ _ _ _ _ f_sound) as ([L _] & _), (errors_binary64 _ _ _ _ _ _ f_sound) as (FA & _).
  destruct (sizes _ _ _ _ _ _ f_sound) as (S & _), (words _ _ _ _ _ _ f_sound) as (W & _); auto.
Qed.

Lemma single_settles2 place past : (forall only, settles2 only -> B_error < hi (Formas.F f) -> 2 * q_error < Rabs (hi q) ->
   settles2 (fun limit => past limit (only limit))) -> settles2 (fun limit => single f place (past limit) limit).
Proof.
  intros Past; unfold single; apply settles_if; intros _; [apply settles_miss|]; apply settles_if; intros HF; [|apply settles_undecided].
  apply settles_if; intros Hq; [|apply settles_undecided]; revert HF Hq.
  destruct (Rlt_bool_spec B_error (hi (Formas.F f))) as [HF|]; [intros _ | discriminate]; intros Hq.
  destruct (q_bound f A B C F H f_sound HF) as (_ & _ & _ & _ & Fqe & _); rewrite (rnd_double _ Fqe) in Hq; revert Hq.
  destruct (Rlt_bool_spec (2 * q_error) (Rabs (hi q))) as [Hq|]; [intros _ | discriminate].
  destruct (q_sized2 HF Hq) as (Sq & Sqe & Lq & _ & Hq450 & Wq), A_error_known2 as (LA & FA & HA450 & WA).
  pose proof (bpow_gt_0 radix2 (-360)); assert (Big : bpow radix2 450 <= bpow radix2 1000) by (apply bpow_le; lia).
  assert (SC : sized2 (from_C f)).
  { apply (quotient_sized2 600 360); auto; try lia; try lra.
    - apply (below2_more 590); [apply f_modest | lia].
    - apply (below_more 590); [apply f_modest | lia].
    - pose proof (proj2 (proj2 (errors_least _ _ _ _ _ _ f_sound))); lra. }
  assert (ByC : forall next, settles2 next -> settles2 (fun limit => by_C f place limit (next limit))).
  { intros next; apply turn_settles2; [exact SC|]; intros limit; eapply near_not_beyond; [exact SC|].
    exact (from_C_near f A B C F H f_sound HF Hq). }
  apply settles_if; intros HA.
  - rewrite (rnd_double _ FA) in HA; revert HA; destruct (Rlt_bool_spec (2 * A_error) (Rabs (hi A_w))) as [HA|]; [intros _ | discriminate].
    assert (SA : sized2 (from_A f)) by (apply (quotient_sized2 600 360); auto; try lia; lra).
    assert (ByA : forall next, settles2 next -> settles2 (fun limit => by_A f place limit (next limit))).
    { intros next; apply turn_settles2; [exact SA|]; intros limit; eapply near_not_beyond; [exact SA|].
      exact (from_A_near f A B C F H f_sound HF Hq HA). }
    destruct (A_root_first f); [apply ByA, ByC | apply ByC, ByA]; apply settles_miss.
  - apply (Past (fun limit => if A_root_first f then by_C f place limit Formas.Miss else by_C f place limit Formas.Miss)); auto.
    destruct (A_root_first f); apply ByC, settles_miss.
Qed.

Lemma past_limit_settles2 only : settles2 only -> B_error < hi (Formas.F f) -> 2 * q_error < Rabs (hi q) ->
  settles2 (fun limit => past_limit f limit (only limit)).
Proof.
  intros Ho HF Hq; destruct (q_sized2 HF Hq) as (_ & _ & Lq & _ & Hq450 & _), A_error_known2 as [LA _].
  pose proof (bpow_gt_0 radix2 (-360)); unfold past_limit.
  apply settles_past; [apply format_far | | exact Ho | apply settles_undecided]; intros limit _; apply least_below; auto; lra.
Qed.

Lemma past_stretch_settles2 only : settles2 only -> B_error < hi (Formas.F f) -> 2 * q_error < Rabs (hi q) ->
  settles2 (fun limit => StableAdvance.past_stretch f limit (only limit)).
Proof.
  intros Ho HF Hq; destruct (q_sized2 HF Hq) as (_ & _ & Lq & _ & Hq450 & _), A_error_known2 as [LA _].
  pose proof (bpow_gt_0 radix2 (-360)); unfold StableAdvance.past_stretch.
  apply settles_past; [apply format_far | | exact Ho | apply settles_if; auto using settles_undecided].
  intros limit _; apply least_below; auto; lra.
Qed.

Lemma from_settles2 place : settles2 (fun limit => single_from f place limit).
Proof.
  destruct A_error_known2 as (LA & FA & HA450 & WA); pose proof (bpow_gt_0 radix2 (-360)); unfold single_from; apply settles_if;
    intros HA; [|apply settles_undecided].
  rewrite (rnd_double _ FA) in HA; revert HA; destruct (Rlt_bool_spec (2 * A_error) (Rabs (hi A_w))) as [HA|]; [intros _ | discriminate].
  destruct (errors_binary64 _ _ _ _ _ _ f_sound) as (_ & FBe & _), (words _ _ _ _ _ _ f_sound) as (_ & WB & _).
  destruct (errors_least _ _ _ _ _ _ f_sound) as (_ & HBe & _); pose proof (B_near _ _ _ _ _ _ f_sound) as NB.
  destruct (sizeable_B_C _ _ _ _ _ _ f_sound) as [SB _]; destruct (sum_near _ _ WB WB) as [Wsum _].
  destruct (opposite_word _ Wsum) as [Wq Eq]; assert (Big : bpow radix2 450 <= bpow radix2 1000) by (apply bpow_le; lia).
  assert (S : sized2 (from_start f)).
  { pose proof (B_below2 f f_modest); pose proof (B_error_below2 f f_modest); apply (quotient_sized2 604 360); auto; try lia; try lra.
    - eapply below2_more; [size2 | vm_compute; discriminate].
    - eapply below_more; [size | vm_compute; discriminate].
    - apply rnd_nonneg; lra. }
  apply turn_settles2; [exact S | | apply settles_miss]; intros limit; apply (near_not_beyond _ (- (2 * B) / A)); [exact S|].
  pose proof (sum_of_self _ WB) as Es; apply quotient_near; auto using format_rnd.
  - rewrite (rnd_double _ FBe); lra.
  - rewrite Es; destruct SB as [Z0|SB]; [left; cbn; rewrite Z0; ring | right; cbn [hi opposite]].
    rewrite Rabs_Ropp, Rabs_mult, (Rabs_pos_eq 2) by lra; pose proof (Rabs_pos (hi B_w)); lra.
  - rewrite Eq, Es, (rnd_double _ FBe); unfold whole in *; cbn [hi lo]; apply Rabs_le_inv in NB; apply Rabs_le; lra.
  - apply (A_near _ _ _ _ _ _ f_sound).
Qed.

Theorem curved_settles2 : settles2 (first_of_curved f) /\ settles2 (first_of_curved_on f).
Proof.
  split; eapply settles_equal.
  - intros limit; apply single_is_recorded.
  - apply (single_settles2 (place f) (past_limit f)), past_limit_settles2.
  - intros limit; apply (from_is_recorded f limit).
  - apply from_settles2.
Qed.

Theorem axial_settles2 : settles2 (first_of_curved_axial f) /\ settles2 (first_of_curved_on_axial f).
Proof.
  split; eapply settles_equal.
  - intros limit; apply StableAdvance.axial_is_recorded.
  - apply (single_settles2 (place_axial f) (StableAdvance.past_stretch f)), past_stretch_settles2.
  - intros limit; apply (StableAdvance.axial_from_is_recorded f limit).
  - apply from_settles2.
Qed.
End Curved.

Section Flat.
Variable f : Formas.quadratic twofold.
Variables B C : R.
Hypothesis f_sound : sound_flat2 f B C.
Hypothesis B_flat : below2 600 (Formas.B f).
Hypothesis C_flat : below2 410 (Formas.C f).
Hypothesis C_error_flat : below 410 (Formas.C_error f).
Hypothesis B_error_flat : flat_known f = true -> bpow radix2 (-560) <= Formas.B_error f.

Lemma alone_settles2 place : settles2 (flat_alone f place).
Proof.
  pose proof f_sound as [[WB WC] _ NC (FBe & _) _ _]; unfold flat_alone; apply settles_if; intros K; [|apply settles_undecided].
  pose proof (B_error_flat K) as Low; destruct (known_means f B C f_sound K) as [Hbig _]; pose proof (bpow_gt_0 radix2 (-560)).
  destruct (sum_near _ _ WB WB) as [Wsum _]; pose proof (sum_of_self _ WB) as Es.
  assert (Eh : Rabs (hi (sum (Formas.B f) (Formas.B f))) = 2 * Rabs (hi (Formas.B f))).
  { rewrite Es; cbn [hi]; rewrite Rabs_mult, (Rabs_pos_eq 2); lra. }
  assert (S : sized2 (only_root f)).
  { apply (quotient_sized2 410 560); auto; try lia; rewrite ?(rnd_double _ FBe), ?Eh.
    - now apply below2_opposite.
    - apply Rle_trans with (2 := NC), Rabs_pos.
    - destruct B_flat as [[_ HB] _]; assert (2 * bpow radix2 600 <= bpow radix2 1000).
      { replace 2 with (bpow radix2 1) by reflexivity; rewrite <- bpow_plus; apply bpow_le; lia. }
      lra.
    - rewrite <- (rnd_double _ FBe); apply format_rnd.
    - change (- (560))%Z with (-560)%Z; lra.
    - lra. }
  apply turn_settles2; [exact S | | apply settles_miss]; intros limit.
  destruct (Req_dec (Formas.C_error f) 0) as [Z0|N]; [|exact (near_not_beyond _ _ limit S (only_root_near f B C f_sound K N))].
  destruct (only_root_zero f B C f_sound Z0) as (HC & _ & He); apply zero_not_beyond; [|exact He].
  unfold only_root, quotient; cbn [Formas.value]; destruct (opposite_word _ WC) as [Wo _]; apply ratio_of_zero; [exact Wo|].
  rewrite Z0, HC in NC; cbn; rewrite (word_of_zero _ WC NC); ring.
Qed.

Theorem linear_settles2 : settles2 (first_of_linear f) /\ settles2 (first_of_linear_edged f).
Proof.
  split; eapply settles_equal; [| apply (alone_settles2 (place f)) | | apply (alone_settles2 (place_edged f))];
    intros limit; apply (flat_is_recorded f limit).
Qed.

Lemma linear_on_settles2 : settles2 (first_of_linear_on f).
Proof. unfold first_of_linear_on; apply settles_if; intros _; [apply settles_miss | apply settles_undecided]. Qed.
End Flat.
