(** * StableFlat: the second step on a plane, a disc and a triangle

    Of what is flat the quadratic is 2B t + C, with one root: the decision of Linear.v over pairs. Of a disc and a triangle
    a margin besides, whose sign tells on which side of the edge the line crosses the plane.

    sound_flat2 == the computed B and C are pairs within their bounds of the exact ones *)
From Coq Require Import Reals ZArith Lra Lia Psatz Bool.
From Flocq Require Import Core.
From Durero Require Import Toolkit Especificacion Puntos Trazador.
From Durero Require Import Rounding Vectors Across Decision Flotante Verdict Linear Steps Twofold Sums Products Ratios Words
  Doubled.
From Durero Require Formas.
Import Formas.Pairs.
Local Open Scope R_scope.
Local Open Scope bool_scope.
Local Opaque bpow.

Section Flat.
Variable f : Formas.quadratic twofold.
Variables B C : R.
Notation B_w := (Formas.B f).
Notation C_w := (Formas.C f).
Notation B_error := (Formas.B_error f).
Notation C_error := (Formas.C_error f).

Record sound_flat2 : Prop := Sound_flat2 {
  flat_words : double_word B_w /\ double_word C_w;
  flat_B_near : Rabs (whole B_w - B) <= B_error;
  flat_C_near : Rabs (whole C_w - C) <= C_error;
  flat_binary64 : format B_error /\ format C_error;
  flat_least : C_error = 0 /\ C = 0 \/ bpow radix2 (-900) <= C_error /\ bpow radix2 (-900) * Rabs (2 * hi B_w) <= C_error;
  flat_sizeable : hi C_w = 0 \/
    bpow radix2 (-900) <= Rabs (hi C_w) /\ bpow radix2 (-900) * Rabs (2 * hi B_w) <= Rabs (hi C_w) }.
Hypothesis f_sound : sound_flat2.

Definition only_root : Formas.known twofold := quotient (opposite C_w) C_error (sum B_w B_w) (rnd (2 * B_error)).
Definition flat_known : bool := Rlt_bool (rnd (2 * B_error)) (Rabs (hi B_w)).
Definition flat_alone (place : Formas.known twofold -> Formas.placed) (limit : R) : Formas.answer twofold :=
  if flat_known then
    turn place limit (Formas.Known (hi (Formas.A f)) (Formas.A_error f)) only_root (Formas.Known (hi B_w) B_error) Formas.Miss
  else Formas.Undecided.

Local Opaque sum difference product ratio root_of opposite exactly.
Theorem flat_is_recorded limit : first_of_linear f limit = flat_alone (place f) limit /\
  first_of_linear_edged f limit = flat_alone (place_edged f) limit.
Proof. split; reflexivity. Qed.
Local Transparent sum difference product ratio root_of opposite exactly.

Lemma known_means : flat_known = true -> 2 * B_error < Rabs (hi B_w) /\ B <> 0.
Proof.
  destruct f_sound as [[WB _] NB _ (Fe & _) _ _]; unfold flat_known; rewrite (rnd_double _ Fe); intros K.
  destruct (Rlt_bool_spec (2 * B_error) (Rabs (hi B_w))) as [Hlt|]; [|discriminate]; split; [exact Hlt|].
  intros Z0; rewrite Z0, Rminus_0_r in NB; destruct (word_near _ WB) as [_ Hh]; pose proof (Rabs_pos (whole B_w)).
  pose proof (u_part _ (Rabs_pos (hi B_w))); pose proof (size_least (whole B_w) (hi B_w)) as Hs.
  pose proof (size_least (hi B_w) (whole B_w)); rewrite (Rabs_minus_sym (whole B_w)) in Hs; lra.
Qed.

(** A pair within nothing of 0 is 0. *)
Lemma word_of_zero x : double_word x -> Rabs (whole x - 0) <= 0 -> hi x = 0.
Proof.
  intros (_ & _ & E) H; rewrite E; replace (whole x) with 0; [apply rnd_0|].
  rewrite Rminus_0_r in H; pose proof (Rabs_pos (whole x)); destruct (Req_dec (whole x) 0) as [|N]; [auto|].
  pose proof (Rabs_pos_lt _ N); lra.
Qed.

Lemma only_root_near : flat_known = true -> C_error <> 0 -> near_pair only_root (- C / (2 * B)).
Proof.
  intros K HC; destruct (known_means K) as [Hbig HB]; destruct f_sound as [[WB WC] NB NC (FBe & FCe) L S].
  destruct (sum_near _ _ WB WB) as [Wsum _]; destruct (opposite_word _ WC) as [Wo Eo]; pose proof (sum_of_self _ WB) as Es.
  destruct L as [Z0|[L1 L2]]; [now elim HC|].
  assert (Eh : hi (sum B_w B_w) = 2 * hi B_w) by now rewrite Es.
  apply quotient_near_any; rewrite ?Eh, ?(rnd_double _ FBe); auto.
  - rewrite <- (rnd_double _ FBe); apply format_rnd.
  - destruct S as [Z0|S]; [left; cbn; rewrite Z0; ring | right; cbn [hi opposite]; rewrite Rabs_Ropp; exact S].
  - rewrite Eo; replace (- whole C_w - - C) with (- (whole C_w - C)) by ring; now rewrite Rabs_Ropp.
  - rewrite Es; replace (whole (Twofold (2 * hi B_w) (2 * lo B_w)) - 2 * B) with (2 * (whole B_w - B))
      by (unfold whole; cbn [hi lo]; ring).
    rewrite Rabs_mult, (Rabs_pos_eq 2) by lra; lra.
  - rewrite Rabs_mult, (Rabs_pos_eq 2) by lra; lra.
Qed.

(** Where the plane goes through the origin of the ray exactly, the root is known to be 0. *)
Lemma only_root_zero : C_error = 0 -> C = 0 /\ hi (Formas.value only_root) = 0 /\ Formas.error only_root = 0.
Proof.
  intros Z0; destruct f_sound as [[_ WC] _ NC _ L _].
  assert (HC : C = 0) by (destruct L as [[_ HC]|[L _]]; [exact HC | pose proof (bpow_gt_0 radix2 (-900)); lra]).
  split; [exact HC|]; rewrite Z0, HC in NC; pose proof (word_of_zero _ WC NC) as Zh.
  destruct (opposite_word _ WC) as [Wo _]; unfold only_root, quotient; cbn [Formas.value Formas.error].
  rewrite ratio_of_zero by (auto; cbn; rewrite Zh; ring); cbn [hi]; split; [reflexivity|].
  rewrite Z0, Rabs_R0, Rmult_0_l, Rmult_0_r, rnd_0, Rplus_0_l, rnd_0; unfold Rdiv.
  now rewrite Rmult_0_l, rnd_0, Rmult_0_l, rnd_0, Rplus_0_l, rnd_0.
Qed.

Section Deciding.
Variable inside : R -> Prop.
Variable place : Formas.known twofold -> Formas.placed.
Notation on := (fun t => 0 < t /\ inside t).
Hypothesis ahead : forall root, Formas.inside (place root) = true -> Formas.error root < hi (Formas.value root).
Hypothesis placed : forall t, flat_known = true -> 2 * B * t + C = 0 -> near_word only_root t ->
  (Formas.outside (place only_root) = true -> ~ on t) /\ (Formas.inside (place only_root) = true -> on t).

Theorem flat_alone_right limit : format limit -> right_pair (flat_points B C on) limit (flat_alone place limit).
Proof.
  intros Fl; unfold flat_alone; case_eq flat_known; intros K; [|exact I]; destruct (known_means K) as [_ HB].
  assert (Honly : forall t, 2 * B * t + C = 0 <-> t = - C / (2 * B)).
  { intros t; split; [intros Ht; apply Rmult_eq_reg_l with (2 * B); [field_simplify|]; lra | intros ->; field; exact HB]. }
  destruct (Req_dec C_error 0) as [Z0|N].
  - destruct (only_root_zero Z0) as (HC & Hv & He); unfold turn.
    assert (None : forall t, ~ flat_points B C on t).
    { intros t [Ht [Pos _]]; apply Honly in Ht; rewrite HC in Ht; unfold Rdiv in Ht; lra. }
    destruct (beyond only_root limit); [intros t Ht; now elim (None t)|].
    destruct (Formas.inside (place only_root)) eqn:I0; [apply ahead in I0; lra|].
    destruct (Formas.outside (place only_root)); [intros t Ht; now elim (None t) | exact I].
  - pose proof (only_root_near K N) as Near; destruct (placed _ K (proj2 (Honly _) eq_refl) (proj1 Near)) as [Out In].
    apply (turn_right place limit _ Fl _ on _ _ _ _ Near Out In).
    + intros On; split; [split; [now apply Honly | exact On] | intros t' [Ht' _]; apply Honly in Ht' as ->; lra].
    + intros Hb t' [Ht' _]; apply Honly in Ht' as ->; exact Hb.
    + intros Off t' [Ht' On]; apply Honly in Ht'; subst t'; now elim Off.
Qed.
End Deciding.

(** A ray that starts on it: the only root is 0, which is no point of the ray. *)
Theorem flat_from_right (inside : R -> Prop) limit :
  right_pair (flat_points_from B (fun t => 0 < t /\ inside t)) limit (first_of_linear_on f limit).
Proof.
  unfold first_of_linear_on; fold flat_known; case_eq flat_known; intros K; [|exact I].
  intros t [Ht [Pos _]]; destruct (known_means K) as [_ HB]; assert (E : 2 * B * t = 0) by lra.
  apply Rmult_integral in E; lra.
Qed.

(** The place of a root within an edge, where the margin is the leading part of a pair within its bound of one of which
    the sign tells. *)
Lemma edged_placed (inside : R -> Prop) m t : (Formas.margin f < - Formas.margin_error f -> m < 0) ->
  (Formas.margin_error f < Formas.margin f -> 0 < m) -> (0 <= m <-> inside t) -> near_word only_root t ->
  (Formas.outside (place_edged f only_root) = true -> ~ (0 < t /\ inside t)) /\
  (Formas.inside (place_edged f only_root) = true -> 0 < t /\ inside t).
Proof.
  intros Low High Tells N; destruct (place_right f _ _ N) as [Out In]; unfold place_edged; unfold place in Out, In.
  cbn [Formas.outside Formas.inside] in *; split.
  - rewrite orb_true_iff; intros [O|O] [Ht I]; [now apply Out|].
    destruct (Rlt_bool_spec (Formas.margin f) (- Formas.margin_error f)) as [Hl|]; [|discriminate].
    apply Low in Hl; apply Tells in I; lra.
  - rewrite andb_true_iff; intros [I1 I2]; split; [now apply In|]; apply Tells.
    destruct (Rlt_bool_spec (Formas.margin_error f) (Formas.margin f)) as [Hl|]; [|discriminate]; apply High in Hl; lra.
Qed.

Lemma ahead_of_edged root : Formas.inside (place_edged f root) = true -> Formas.error root < hi (Formas.value root).
Proof.
  unfold place_edged; cbn [Formas.inside]; rewrite andb_true_iff; intros [I _].
  now destruct (Rlt_bool_spec (Formas.error root) (hi (Formas.value root))).
Qed.

Lemma ahead_of_free root : Formas.inside (place f root) = true -> Formas.error root < hi (Formas.value root).
Proof.
  unfold place; cbn [Formas.inside]; intros I; now destruct (Rlt_bool_spec (Formas.error root) (hi (Formas.value root))).
Qed.

(** ** What the text says *)

Variable text : coefficients.
Hypothesis same : forall t, 2 * B * t + C = value text t.
Hypothesis same_from : forall t, 2 * B * t + 0 = value (launched text) t.

Lemma flat_pair limit : format limit -> (forall t, within text t) ->
  right_pair (reach text) limit (first_of_linear f limit) /\
  right_pair (reach (launched text)) limit (first_of_linear_on f limit).
Proof.
  intros Fl W; split.
  - rewrite (proj1 (flat_is_recorded limit)); apply (right_pair_equal _ _ _ _ (flat_is_reached _ _ _ same)).
    apply (flat_alone_right _ _ ahead_of_free); [|exact Fl]; intros t _ _ N; destruct (place_right f _ _ N) as [Out In].
    split; [intros O [Ht _]; now apply Out | intros I; split; [now apply In | apply W]].
  - apply (right_pair_equal _ _ _ _ (flat_from_is_reached _ _ same_from)), flat_from_right.
Qed.

Lemma edged_pair limit m : format limit -> (Formas.margin f < - Formas.margin_error f -> m < 0) ->
  (Formas.margin_error f < Formas.margin f -> 0 < m) ->
  (flat_known = true -> forall t, 2 * B * t + C = 0 -> (0 <= m <-> within text t)) ->
  right_pair (reach text) limit (first_of_linear_edged f limit) /\
  right_pair (reach (launched text)) limit (first_of_linear_on f limit).
Proof.
  intros Fl Low High Tells; split.
  - rewrite (proj2 (flat_is_recorded limit)); apply (right_pair_equal _ _ _ _ (flat_is_reached _ _ _ same)).
    apply (flat_alone_right _ _ ahead_of_edged); [|exact Fl]; intros t K E N.
    exact (edged_placed _ m t Low High (Tells K t E) N).
  - apply (right_pair_equal _ _ _ _ (flat_from_is_reached _ _ same_from)), flat_from_right.
Qed.
End Flat.
