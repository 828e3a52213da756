(** * Linear: what the tracer decides of a ray and something flat, and that the bounds of a plane and a disc hold

    Of a plane, a disc and a triangle the quadratic is 2B t + C, with one root. trace/closed_form-inl.hpp decides of it
    what Verdict.v has for one of two; a disc and a triangle have a margin besides, whose sign tells on which side of the
    edge the line crosses the plane.

    sound_flat == the computed B and C are within their bounds of the exact ones
    crosses    == the root is a point of the ray, within the edge *)
From Coq Require Import Reals ZArith Lra Lia Psatz Bool.
From Flocq Require Import Core.
From Durero Require Import Trazador.
From Durero Require Import Rounding Vectors Across Quotient Decision Flotante Verdict Advance.
From Durero Require Formas.
Local Open Scope R_scope.
Local Open Scope bool_scope.
Local Opaque bpow.

Section Linear.
Variable f : Formas.quadratic R.
Variables B C : R.
Notation B_fl := (Formas.B f).
Notation C_fl := (Formas.C f).
Notation B_error := (Formas.B_error f).
Notation C_error := (Formas.C_error f).

Record sound_flat : Prop := Sound_flat {
  flat_B_near : Rabs (B_fl - B) <= B_error;
  flat_C_near : Rabs (C_fl - C) <= C_error;
  flat_binary64 : format B_fl /\ format C_fl /\ format B_error /\ format C_error;
  flat_slope : Formas.A f = 0 /\ Formas.A_error f = 0 /\ (B_fl = 0 \/ bpow radix2 (-900) <= B_error);
  flat_least : C_error = 0 /\ C_fl = 0 \/ bpow radix2 (-900) <= C_error /\ bpow radix2 (-900) * Rabs (2 * B_fl) <= C_error }.
Hypothesis f_sound : sound_flat.

Definition only_root : Formas.known R := Formas.quotient (- C_fl) C_error (rnd (B_fl + B_fl)) (rnd (2 * B_error)).
Definition flat_known : bool := Rlt_bool (rnd (2 * B_error)) (Rabs B_fl).
Definition flat_alone (place : Formas.known R -> Formas.placed) (limit : R) : Formas.answer R :=
  if flat_known then
    turn place limit (Formas.Known (Formas.A f) (Formas.A_error f)) only_root (Formas.Known B_fl B_error) Formas.Miss
  else Formas.Undecided.
Definition flat_in_lanes (place : Formas.known R -> Formas.placed) : Formas.in_lanes :=
  alone_in_lanes flat_known (place only_root) only_root (Formas.Known B_fl B_error).

Theorem flat_is_recorded limit :
  Formas.linear_in_lanes f = flat_in_lanes (Formas.place f) /\
  Formas.linear_in_lanes_edged f = flat_in_lanes (Formas.place_edged f) /\
  Formas.first_of_linear f limit = flat_alone (Formas.place f) limit /\
  Formas.first_of_linear_edged f limit = flat_alone (Formas.place_edged f) limit.
Proof. repeat split. Qed.

Definition flat_points (on : R -> Prop) (t : R) : Prop := 2 * B * t + C = 0 /\ on t.
Definition flat_points_from (on : R -> Prop) (t : R) : Prop := 2 * B * t + 0 = 0 /\ on t.

Lemma known_means : flat_known = true -> 2 * B_error < Rabs B_fl /\ B <> 0.
Proof.
  destruct f_sound as [NB _ (_ & _ & Fe & _) _ _]; unfold flat_known; rewrite (rnd_double _ Fe); intros K.
  destruct (Rlt_bool_spec (2 * B_error) (Rabs B_fl)) as [Hlt|]; [|discriminate]; split; [exact Hlt|].
  intros Z0; rewrite Z0, Rminus_0_r in NB; pose proof (Rabs_pos B_fl); lra.
Qed.

Lemma flat_graded t : flat_known = true ->
  graded 0 B t (Formas.Known B_fl B_error) (Formas.Known (Formas.A f) (Formas.A_error f)).
Proof.
  intros K; destruct (known_means K) as [Hbig _], f_sound as [NB _ (FB & _ & FBe & _) (EA & EAe & Least) _].
  unfold graded; cbn [Formas.value Formas.error]; rewrite EA, EAe, Rmult_0_l, Rplus_0_l, Rminus_0_r, Rabs_R0, Rabs_minus_sym.
  repeat split; auto using generic_format_0; [apply Rle_refl|].
  destruct Least as [Z0|Least]; [|exact Least]; rewrite Z0, Rabs_R0 in Hbig.
  apply Rabs_le_inv in NB; lra.
Qed.

Lemma only_root_near : flat_known = true -> is_near only_root (- C / (2 * B)) /\ format (Formas.error only_root).
Proof.
  intros K; destruct (known_means K) as [Hbig HB]; destruct f_sound as [NB NC (FB & FC & FBe & FCe) _ L].
  split; [|apply format_rnd].
  assert (E2 : rnd (B_fl + B_fl) = 2 * B_fl) by (replace (B_fl + B_fl) with (2 * B_fl) by ring; now apply rnd_double).
  destruct L as [[Z0 ZC]|[L1 L2]].
  - assert (HC : C = 0) by (rewrite Z0, ZC in NC; apply Rabs_le_inv in NC; lra).
    assert (Ev : Formas.value only_root = 0 /\ Formas.error only_root = 0).
    { unfold only_root, Formas.quotient; rewrite E2, Z0, ZC; cbn [Formas.value Formas.error].
      replace (rnd (- 0 / (2 * B_fl))) with 0 by (unfold Rdiv; rewrite Ropp_0, Rmult_0_l; symmetry; apply rnd_0).
      split; [reflexivity|]; rewrite Rabs_R0, !Rmult_0_l, !Rmult_0_r, rnd_0, Rplus_0_l, rnd_0; unfold Rdiv.
      now rewrite Rmult_0_l, rnd_0, Rmult_0_l, rnd_0, Rplus_0_l, rnd_0. }
    destruct Ev as [Ev Ee]; unfold is_near, Rdiv; split; [apply format_rnd | split; [apply format_rnd|]].
    rewrite Ev, Ee, HC, Ropp_0, Rmult_0_l, Rminus_0_r, Rplus_0_r, Rabs_R0, Rmult_0_r; lra.
  - unfold only_root; rewrite E2; apply quotient_bound_any; rewrite ?(rnd_double _ FBe); auto.
    + rewrite <- (rnd_double _ FB); apply format_rnd.
    + rewrite <- (rnd_double _ FBe); apply format_rnd.
    + replace (- C_fl - - C) with (- (C_fl - C)) by ring; now rewrite Rabs_Ropp.
    + replace (2 * B_fl - 2 * B) with (2 * (B_fl - B)) by ring; rewrite Rabs_mult, (Rabs_pos_eq 2) by lra; lra.
    + rewrite Rabs_mult, (Rabs_pos_eq 2) by lra; lra.
Qed.

Section Deciding.
Variable on : R -> Prop.
Variable place : Formas.known R -> Formas.placed.
Hypothesis placed : forall t, flat_known = true -> 2 * B * t + C = 0 -> is_near only_root t ->
  (Formas.outside (place only_root) = true -> ~ on t) /\ (Formas.inside (place only_root) = true -> on t).

Lemma flat_root : flat_known = true -> exists t, is_near only_root t /\ format (Formas.error only_root) /\
  (Formas.outside (place only_root) = true -> ~ on t) /\ (Formas.inside (place only_root) = true -> on t) /\
  forall t', flat_points on t' <-> t' = t /\ on t'.
Proof.
  intros K; destruct (only_root_near K) as [N Fe], (known_means K) as [_ HB]; exists (- C / (2 * B)).
  assert (E : 2 * B * (- C / (2 * B)) + C = 0) by (field; exact HB).
  destruct (placed _ K E N) as [Out In]; split; [exact N|]; split; [exact Fe|]; split; [exact Out|]; split; [exact In|].
  intros t'; unfold flat_points; split; [intros [Ht On] | intros [-> On]]; [|now split]; split; [|exact On].
  apply Rmult_eq_reg_l with (2 * B); [field_simplify; lra | lra].
Qed.

Theorem flat_in_lanes_right : right_in_lanes (flat_points on) (flat_in_lanes place).
Proof.
  apply (alone_right _ on); intros K; destruct (flat_root K) as (t & N & _ & Out & In & HT); exists t; auto.
Qed.

Theorem flat_alone_right limit : right_up_to 0 B (flat_points on) limit (flat_alone place limit).
Proof.
  unfold flat_alone; case_eq flat_known; intros K; [|exact I]; destruct (flat_root K) as (t & N & Fe & Out & In & HT).
  apply (turn_right place 0 B limit _ _ on _ _ _ t N Fe Out In (flat_graded t K)).
  - intros On; split; [now apply HT | intros t' Ht'; apply HT in Ht' as [-> _]; lra].
  - intros Hb t' Ht'; apply HT in Ht' as [-> _]; exact Hb.
  - intros Off t' Ht'; apply HT in Ht' as [-> On]; now elim Off.
Qed.
End Deciding.

(** A ray that starts on it: the only root is 0, which is no point of the ray. *)
Theorem flat_from_right (on : R -> Prop) limit : (forall t, on t -> 0 < t) ->
  right_in_lanes (flat_points_from on) (Formas.linear_in_lanes_on f) /\
  right_up_to 0 B (flat_points_from on) limit (Formas.first_of_linear_on f limit).
Proof.
  intros Pos; assert (None : flat_known = true -> forall t, ~ flat_points_from on t).
  { intros K t [Ht On]; destruct (known_means K) as [_ HB]; pose proof (Pos t On).
    assert (E : 2 * B * t = 0) by lra; apply Rmult_integral in E; lra. }
  split.
  - unfold right_in_lanes, Formas.linear_in_lanes_on; cbn [Formas.hit Formas.undecided Formas.root]; fold flat_known.
    case_eq flat_known; intros K; (split; [discriminate|]); [intros _ _; now apply None | discriminate].
  - unfold Formas.first_of_linear_on; fold flat_known; case_eq flat_known; intros K; [|exact I].
    intros t Ht; now elim (None K t).
Qed.

(** The place of a root within an edge, where the margin is within its bound of one of which the sign tells. *)
Lemma edged_placed (inside : R -> Prop) m t : Rabs (Formas.margin f - m) <= Formas.margin_error f -> (0 <= m <-> inside t) ->
  is_near only_root t ->
  (Formas.outside (Formas.place_edged f only_root) = true -> ~ (0 < t /\ inside t)) /\
  (Formas.inside (Formas.place_edged f only_root) = true -> 0 < t /\ inside t).
Proof.
  unfold Formas.place_edged; intros Hm Hin N%near_within; apply Rabs_le_inv in Hm, N; cbn [Formas.outside Formas.inside]; split.
  - rewrite orb_true_iff; intros [O|O] [Ht I]; apply Hin in I;
      match type of O with Rlt_bool ?a ?b = true => destruct (Rlt_bool_spec a b); [lra | discriminate] end.
  - rewrite andb_true_iff; intros [I1 I2]; rewrite <- Hin.
    destruct (Rlt_bool_spec (Formas.error only_root) (Formas.value only_root)); [|discriminate].
    destruct (Rlt_bool_spec (Formas.margin_error f) (Formas.margin f)); [lra | discriminate].
Qed.

Lemma free_placed t : is_near only_root t -> (Formas.outside (Formas.place f only_root) = true -> ~ 0 < t) /\
  (Formas.inside (Formas.place f only_root) = true -> 0 < t).
Proof.
  unfold Formas.place; intros N%near_within; apply Rabs_le_inv in N; cbn [Formas.outside Formas.inside]; split; intros O;
    match type of O with Rlt_bool ?a ?b = true => destruct (Rlt_bool_spec a b); [lra | discriminate] end.
Qed.
End Linear.
