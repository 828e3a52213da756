(** * Quadratic: the least t > 0 with A t² + 2 B t + C = 0 and 0 <= s0 + t s1 <= h, in every case

    quadratic             == A, B, C and the clip s0, s1, h, all integers
    solves q t            == t > 0 satisfies the quadratic and its clip
    reach                 == what a ray has of an element: Nothing, its nearest point At t, or NoMinimum
    reaches P r           == r describes the set P of parameters
    from_origin P         == P holds on a segment that begins at 0: it has no least parameter
    within q x            == x is positive and passes the clip
    first q               == the reach of the quadratic q *)
From Coq Require Import ZArith Reals List Lia Lra Bool.
From Durero Require Import Surd.
Import ListNotations.
Local Open Scope Z_scope.

Record quadratic := Quadratic { qA : Z; qB : Z; qC : Z; s0 : Z; s1 : Z; h : Z }.

Definition within (q : quadratic) (x : surd) : bool :=
  (0 <? sign_affine 0 1 x) && (0 <=? sign_affine (s0 q) (s1 q) x) && (sign_affine (s0 q - h q) (s1 q) x <=? 0).

Inductive reach := Nothing | At (t : surd) | NoMinimum.

Fixpoint pick (q : quadratic) (xs : list surd) : reach :=
  match xs with
  | [] => Nothing
  | x :: xs' => if within q x then At x else pick q xs'
  end.

(** The whole line satisfies the equation: what the clip leaves of it, between lo/w and hi/w. *)
Definition line (q : quadratic) : reach :=
  if s1 q =? 0 then if (0 <=? s0 q) && (s0 q <=? h q) then NoMinimum else Nothing
  else
    let '(lo, hi, w) := if 0 <? s1 q then (- s0 q, h q - s0 q, s1 q) else (s0 q - h q, s0 q, - s1 q) in
    if hi <? lo then Nothing
    else if 0 <? lo then At (Surd lo 0 0 w) else if 0 <? hi then NoMinimum else Nothing.

Definition first (q : quadratic) : reach :=
  if qA q =? 0 then
    if qB q =? 0 then if qC q =? 0 then line q else Nothing
    else pick q [if 0 <? qB q then Surd (- qC q) 0 0 (2 * qB q) else Surd (qC q) 0 0 (- (2 * qB q))]
  else
    let D := qB q * qB q - qA q * qC q in
    if D <? 0 then Nothing
    else
      let (n, d) := if 0 <? qA q then (- qB q, qA q) else (qB q, - qA q) in
      pick q [Surd n (-1) D d; Surd n 1 D d].

(** ** What it means, over R *)

Local Open Scope R_scope.

Definition solves (q : quadratic) (t : R) : Prop :=
  0 < t /\ IZR (qA q) * t * t + 2 * IZR (qB q) * t + IZR (qC q) = 0 /\ 0 <= IZR (s0 q) + t * IZR (s1 q) <= IZR (h q).

(** P holds on a segment of the ray that begins at its origin: no point of it is the nearest. *)
Definition from_origin (P : R -> Prop) : Prop := exists e, 0 < e /\ forall t, 0 < t <= e -> P t.

Definition reaches (P : R -> Prop) (r : reach) : Prop :=
  match r with
  | Nothing => forall t, ~ P t
  | At x => valid x /\ P (val x) /\ forall t, P t -> val x <= t
  | NoMinimum => from_origin P
  end.

Lemma within_correct q x : valid x ->
  (within q x = true <-> 0 < val x /\ 0 <= IZR (s0 q) + val x * IZR (s1 q) <= IZR (h q)).
Proof.
  intros Hx; unfold within; rewrite !andb_true_iff.
  rewrite (is_sign_pos _ _ (sign_affine_correct 0 1 x Hx)),
    (is_sign_nonneg _ _ (sign_affine_correct (s0 q) (s1 q) x Hx)),
    (is_sign_nonpos _ _ (sign_affine_correct (s0 q - h q) (s1 q) x Hx)), minus_IZR; lra.
Qed.

(** The roots in increasing order: the first that passes the clip is the nearest solution. *)
Lemma pick_reaches q xs : Forall valid xs ->
  (forall t, IZR (qA q) * t * t + 2 * IZR (qB q) * t + IZR (qC q) = 0 <-> exists x, In x xs /\ t = val x) ->
  (forall x y ys zs, xs = ys ++ x :: zs -> In y zs -> val x <= val y) -> reaches (solves q) (pick q xs).
Proof.
  intros Hv Hroots Hsorted.
  assert (Hgen : forall before after, xs = before ++ after -> (forall x, In x before -> within q x = false) ->
    reaches (solves q) (pick q after)).
  { intros before after; revert before; induction after as [|x after IH]; intros before -> Hno; simpl.
    - intros t (Ht & Heq & Hclip); apply Hroots in Heq as (x & Hx & ->); rewrite app_nil_r in Hx, Hv.
      rewrite Forall_forall in Hv; enough (within q x = true) by (rewrite Hno in *; congruence).
      apply within_correct; auto.
    - assert (Hx : valid x) by (rewrite Forall_forall in Hv; apply Hv, in_elt).
      destruct (within q x) eqn:Hw.
      + pose proof Hw as Hw'; apply within_correct in Hw' as (Hpos & Hclip); [|assumption].
        repeat split; try (apply Hx); try assumption; try apply Hclip.
        * apply Hroots; exists x; split; [apply in_elt | reflexivity].
        * intros t (Ht & Heq & Ht2); apply Hroots in Heq as (y & Hy & ->).
          apply in_app_iff in Hy as [Hy|[->|Hy]]; [|lra | eapply Hsorted; eauto].
          enough (within q y = true) by (rewrite Hno in *; congruence).
          apply within_correct; [|now split].
          rewrite Forall_forall in Hv; apply Hv, in_app_iff; now left.
      + apply (IH (before ++ [x])); [now rewrite <- app_assoc|].
        intros y Hy; apply in_app_iff in Hy as [Hy|[<-|[]]]; auto. }
  apply (Hgen []); [reflexivity | contradiction].
Qed.

Lemma val_rational n d : val (Surd n 0 0 d) = IZR n / IZR d.
Proof. unfold val; simpl; f_equal; ring. Qed.

Lemma line_reaches q : qA q = 0%Z -> qB q = 0%Z -> qC q = 0%Z -> reaches (solves q) (line q).
Proof.
  intros HA HB HC.
  assert (Hs : forall t, solves q t <-> 0 < t /\ 0 <= IZR (s0 q) + t * IZR (s1 q) <= IZR (h q)).
  { intros t; unfold solves; rewrite HA, HB, HC; split; [tauto|]; intros [Ht Hc]; repeat split; try tauto; ring. }
  unfold line; destruct (Z.eqb_spec (s1 q) 0) as [H1|H1].
  - destruct (_ && _) eqn:Hb; simpl.
    + apply andb_true_iff in Hb as [Ha Hb]; apply Z.leb_le, IZR_le in Ha; apply Z.leb_le, IZR_le in Hb.
      exists 1; split; [lra | intros t Ht; apply Hs; rewrite H1; lra].
    + intros t Ht; apply Hs in Ht; rewrite H1 in Ht; apply andb_false_iff in Hb as [Hb|Hb];
        apply Z.leb_gt, IZR_lt in Hb; lra.
  - destruct (if (0 <? s1 q)%Z then _ else _) as [[lo hi] w] eqn:E.
    assert ((0 < w)%Z /\ forall t, 0 <= IZR (s0 q) + t * IZR (s1 q) <= IZR (h q) <->
      IZR lo <= IZR w * t <= IZR hi) as [Hw Hc].
    { destruct (Z.ltb_spec 0 (s1 q)); injection E as <- <- <-; (split; [lia|]); intros t;
        rewrite ?opp_IZR, ?minus_IZR; split; intros; lra. }
    apply IZR_lt in Hw as HwR.
    destruct (Z.ltb_spec hi lo) as [Hr|Hr]; [|destruct (Z.ltb_spec 0 lo) as [Hl|Hl];
      [|destruct (Z.ltb_spec 0 hi) as [Hh|Hh]]]; cbn [reaches].
    + intros t Ht; apply Hs in Ht as [_ Ht]; apply Hc in Ht; apply IZR_lt in Hr; lra.
    + apply IZR_lt in Hl; apply IZR_le in Hr.
      assert (IZR w * val (Surd lo 0 0 w) = IZR lo) by (rewrite val_rational; field; lra).
      split; [split; simpl; lia|]; split; [apply Hs; rewrite Hc; split; nra|].
      intros t Ht; apply Hs in Ht as [_ Ht]; apply Hc in Ht; nra.
    + apply IZR_le in Hl; apply IZR_lt in Hh; exists (IZR hi / IZR w).
      assert (He : IZR w * (IZR hi / IZR w) = IZR hi) by (field; lra).
      split; [now apply Rdiv_lt_0_compat|]; intros t Ht; apply Hs; rewrite Hc; split; [lra | nra].
    + intros t Ht; apply Hs in Ht as [Ht0 Ht]; apply Hc in Ht; apply IZR_le in Hh; nra.
Qed.

(** d t² - 2 n t + c = 0 with d > 0 and r = √(n² - d c). *)
Lemma roots n d c r t : 0 < d -> r * r = n * n - d * c ->
  (d * t * t - 2 * n * t + c = 0 <-> t = (n + -1 * r) / d \/ t = (n + 1 * r) / d).
Proof.
  intros Hd Hr; split.
  - intros H; assert (Hp : (d * t - n + r) * (d * t - n - r) = 0).
    { replace (_ * _) with (d * (d * t * t - 2 * n * t + c) + (n * n - d * c - r * r)) by ring; rewrite H, Hr; ring. }
    apply Rmult_integral in Hp as [Hp|Hp]; [left | right]; apply (Rmult_eq_reg_l d); try lra; field_simplify; lra.
  - intros H; apply (Rmult_eq_reg_l d); [|lra].
    replace (d * (_ + c)) with ((d * t - n) * (d * t - n) - (n * n - d * c)) by ring.
    destruct H as [->| ->]; rewrite <- Hr; field; lra.
Qed.

(** The procedure for one element is right in every case. *)
Theorem first_reaches q : reaches (solves q) (first q).
Proof.
  unfold first; destruct (Z.eqb_spec (qA q) 0) as [HA|HA].
  - destruct (Z.eqb_spec (qB q) 0) as [HB|HB].
    + destruct (Z.eqb_spec (qC q) 0) as [HC|HC]; [now apply line_reaches|].
      intros t (_ & H & _); rewrite HA, HB in H; apply HC, eq_IZR; lra.
    + match goal with |- context [pick q [?y]] => set (x := y) end.
      assert (valid x /\ val x = - IZR (qC q) / (2 * IZR (qB q))) as [Hx Hval].
      { apply not_0_IZR in HB as HB'.
        unfold x; destruct (Z.ltb_spec 0 (qB q)); (split; [split; cbn [rad den]; lia|]);
          rewrite val_rational, ?opp_IZR, mult_IZR; field; lra. }
      apply not_0_IZR in HB as HB'; apply pick_reaches; [now constructor| |].
      * intros t; rewrite HA; split.
        -- intros H; exists x; split; [now left|]; rewrite Hval; field_simplify_eq; lra.
        -- intros (y & [<-|[]] & ->); rewrite Hval; field; lra.
      * intros y z [|? [|]] zs [= ] Hin; subst; contradiction.
  - set (D := (qB q * qB q - qA q * qC q)%Z).
    assert (HD : IZR D = IZR (qB q) * IZR (qB q) - IZR (qA q) * IZR (qC q)).
    { unfold D; now rewrite minus_IZR, !mult_IZR. }
    apply not_0_IZR in HA as HA'.
    destruct (Z.ltb_spec D 0) as [Hneg|Hpos].
    + intros t (_ & H & _); apply IZR_lt in Hneg.
      pose proof (Rle_0_sqr (IZR (qA q) * t + IZR (qB q))) as Hs; unfold Rsqr in Hs.
      enough ((IZR (qA q) * t + IZR (qB q)) * (IZR (qA q) * t + IZR (qB q)) = IZR D) by lra.
      rewrite HD; replace (_ * _) with (IZR (qA q) * (IZR (qA q) * t * t + 2 * IZR (qB q) * t + IZR (qC q))
        + (IZR (qB q) * IZR (qB q) - IZR (qA q) * IZR (qC q))) by ring; rewrite H; ring.
    + destruct (if (0 <? qA q)%Z then _ else _) as [n d] eqn:E.
      assert ((0 < d)%Z /\ exists c, IZR D = IZR n * IZR n - IZR d * c /\ forall t,
        (IZR (qA q) * t * t + 2 * IZR (qB q) * t + IZR (qC q) = 0 <-> IZR d * t * t - 2 * IZR n * t + c = 0))
        as (Hd & c & Hc & Heq).
      { destruct (Z.ltb_spec 0 (qA q)); injection E as <- <-; (split; [lia|]);
          [exists (IZR (qC q)) | exists (- IZR (qC q))]; rewrite ?opp_IZR; split; try (rewrite HD; ring);
          intros t; split; intros; lra. }
      apply IZR_lt in Hd as HdR; pose proof (sqrt_square D Hpos) as Hr; rewrite Hc in Hr at 3.
      apply pick_reaches; [repeat constructor; simpl; assumption| |].
      * intros t; rewrite Heq, (roots (IZR n) (IZR d) c (sqrt (IZR D)) t HdR Hr); simpl; split.
        -- intros [->| ->]; [exists (Surd n (-1) D d) | exists (Surd n 1 D d)]; auto.
        -- intros (x & [<-|[<-|[]]] & ->); [left | right]; reflexivity.
      * intros y z [|? [|? [|]]] zs [= ] Hin; subst; try contradiction.
        destruct Hin as [<-|[]]; unfold val; simpl; apply Rmult_le_compat_r; [|pose proof (sqrt_pos (IZR D)); lra].
        now apply Rlt_le, Rinv_0_lt_compat.
Qed.

Lemma reaches_ext (P Q : R -> Prop) r : (forall t, P t <-> Q t) -> reaches P r -> reaches Q r.
Proof.
  intros H; destruct r; simpl.
  - intros HP t HQ; apply (HP t), H, HQ.
  - intros (Hv & HP & Hmin); repeat split; try (apply Hv); [now apply H | intros; now apply Hmin, H].
  - intros (e & He & Hp); exists e; split; [assumption | intros; now apply H, Hp].
Qed.

Lemma from_origin_no_least (P : R -> Prop) t : from_origin P -> 0 < t -> exists t', P t' /\ t' < t.
Proof.
  intros (e & He & HP) Ht; exists (Rmin e (t / 2)); unfold Rmin; destruct Rle_dec; split; try apply HP; lra.
Qed.

(** What [reaches] says of a set, told apart: the three answers exclude each other. *)
Lemma reaches_from_origin (P : R -> Prop) r :
  (forall t, P t -> 0 < t) -> reaches P r -> (from_origin P <-> r = NoMinimum).
Proof.
  intros Hpos; destruct r as [|x|]; cbn [reaches]; intros H; split; try discriminate; try tauto.
  - intros (e & He & HP); destruct (H e); apply HP; lra.
  - destruct H as (Hv & HP & Hmin); intros Ho.
    destruct (from_origin_no_least P (val x) Ho (Hpos _ HP)) as (t & Ht & Hlt); specialize (Hmin t Ht); lra.
Qed.
