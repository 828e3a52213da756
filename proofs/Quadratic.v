(** * Quadratic: the least t > 0 with A t² + 2 B t + C = 0 within bounds a t² + 2 b t + c <= 0, in every case

    bound                 == a, b, c of a condition a t² + 2 b t + c <= 0, all integers
    quadratic             == A, B, C, and the bounds that clip it
    proper q              == the bounds are convex: no a is negative
    solves q t            == t > 0 satisfies the quadratic and its bounds
    reach                 == what a ray has of an element: Nothing, its nearest point At t, or NoMinimum
    reaches P r           == r describes the set P of parameters
    from_origin P         == P holds on a segment that begins at 0: it has no least parameter
    within q x            == x is positive and the bounds hold there
    roots a b c           == the roots of a t² + 2 b t + c, increasing
    starts g              == the bound g holds on a segment that begins at 0
    entries g             == where g begins to hold, if it does so at a positive parameter
    first q               == the reach of the quadratic q *)
From Coq Require Import ZArith Reals List Lia Lra Bool.
From Durero Require Import Surd.
From Durero Require Puntos Trazador.
Import ListNotations.
Local Open Scope Z_scope.

Record bound := Bound { gA : Z; gB : Z; gC : Z }.
Record quadratic := Quadratic { qA : Z; qB : Z; qC : Z; bounds : list bound }.

Definition holds (x : surd) (g : bound) : bool := sign_square (gA g) (gB g) (gC g) x <=? 0.
Definition within (q : quadratic) (x : surd) : bool := (0 <? sign_square 0 1 0 x) && forallb (holds x) (bounds q).

Inductive reach := Nothing | At (t : surd) | NoMinimum.

Fixpoint pick (q : quadratic) (xs : list surd) : reach :=
  match xs with
  | [] => Nothing
  | x :: xs' => if within q x then At x else pick q xs'
  end.

(** A polynomial that is 0 everywhere has no root in the list. *)
Definition roots (a b c : Z) : list surd :=
  if a =? 0 then
    if b =? 0 then [] else [if 0 <? b then Surd (- c) 0 0 (2 * b) else Surd c 0 0 (- (2 * b))]
  else
    let D := b * b - a * c in
    if D <? 0 then []
    else
      let (n, d) := if 0 <? a then (- b, a) else (b, - a) in
      [Surd n (-1) D d; Surd n 1 D d].

Definition starts (g : bound) : bool :=
  (gC g <? 0) || ((gC g =? 0) && ((gB g <? 0) || ((gB g =? 0) && (gA g =? 0)))).
(** The lesser root, where the bound falls. *)
Definition entries (g : bound) : list surd :=
  if gB g <? 0 then match roots (gA g) (gB g) (gC g) with x :: _ => [x] | [] => [] end else [].

(** The whole line satisfies the equation: what convex bounds leave of it begins at 0, or where one of them begins. *)
Definition line (q : quadratic) : reach :=
  if forallb starts (bounds q) then NoMinimum else pick q (flat_map entries (bounds q)).

Definition first (q : quadratic) : reach :=
  if (qA q =? 0) && (qB q =? 0) && (qC q =? 0) then line q else pick q (roots (qA q) (qB q) (qC q)).

(** ** What it means, over R *)

Local Open Scope R_scope.

Definition over_R (g : bound) : Puntos.bound := Puntos.mk_bound (IZR (gA g)) (IZR (gB g)) (IZR (gC g)).
Definition inside (gs : list bound) (t : R) : Prop :=
  Forall (fun g => Puntos.excess g t <= 0) (map over_R gs).
Definition solves (q : quadratic) (t : R) : Prop :=
  0 < t /\ IZR (qA q) * t * t + 2 * IZR (qB q) * t + IZR (qC q) = 0 /\ inside (bounds q) t.
Definition proper (q : quadratic) : Prop := Forall (fun g => (0 <= gA g)%Z) (bounds q).

(** P holds on a segment of the ray that begins at its origin: no point of it is the nearest. *)
Definition from_origin (P : R -> Prop) : Prop := exists e, 0 < e /\ forall t, 0 < t <= e -> P t.

Definition reaches (P : R -> Prop) (r : reach) : Prop :=
  match r with
  | Nothing => forall t, ~ P t
  | At x => valid x /\ P (val x) /\ forall t, P t -> val x <= t
  | NoMinimum => from_origin P
  end.

Lemma holds_correct x g : valid x -> (holds x g = true <-> Puntos.excess (over_R g) (val x) <= 0).
Proof. intros Hx; exact (is_sign_nonpos _ _ (sign_square_correct (gA g) (gB g) (gC g) x Hx)). Qed.

Lemma within_correct q x : valid x -> (within q x = true <-> 0 < val x /\ inside (bounds q) (val x)).
Proof.
  intros Hx; unfold within, inside; rewrite andb_true_iff, (is_sign_pos _ _ (sign_square_correct 0 1 0 x Hx)).
  rewrite forallb_forall, Forall_map, Forall_forall; setoid_rewrite (holds_correct x _ Hx); split; intros [H1 H2];
    (split; [lra | exact H2]).
Qed.

(** What is picked passes the bounds; where nothing is, nothing of the list does. *)
Lemma pick_passes q xs :
  match pick q xs with
  | At x => In x xs /\ within q x = true
  | Nothing => forall x, In x xs -> within q x = false
  | NoMinimum => False
  end.
Proof.
  induction xs as [|x xs IH]; simpl; [easy|]; destruct (within q x) eqn:Hw; [auto|].
  destruct (pick q xs) as [|y|]; [|destruct IH; auto | exact IH].
  intros y [<-|Hy]; auto.
Qed.

(** The roots in increasing order: the first that passes the bounds is the nearest solution. *)
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

(** d t² - 2 n t + c = 0 with d > 0 and r = √(n² - d c). *)
Lemma two_roots n d c r t : 0 < d -> r * r = n * n - d * c ->
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

(** The list is that of the roots, in increasing order. *)
Lemma roots_correct a b c : ~ (a = 0 /\ b = 0 /\ c = 0)%Z ->
  Forall valid (roots a b c)
  /\ (forall t, IZR a * t * t + 2 * IZR b * t + IZR c = 0 <-> exists x, In x (roots a b c) /\ t = val x)
  /\ (forall x y ys zs, roots a b c = ys ++ x :: zs -> In y zs -> val x <= val y).
Proof.
  intros H0; unfold roots; destruct (Z.eqb_spec a 0) as [HA|HA].
  - destruct (Z.eqb_spec b 0) as [HB|HB].
    + split; [constructor|]; split; [|now intros ? ? []].
      intros t; split; [|now intros (x & [] & _)].
      intros H; rewrite HA, HB in H; exfalso; apply H0; repeat split; try assumption; apply eq_IZR; lra.
    + match goal with |- context [[?y]] => set (x := y) end.
      assert (valid x /\ val x = - IZR c / (2 * IZR b)) as [Hx Hval].
      { apply not_0_IZR in HB as HB'.
        unfold x; destruct (Z.ltb_spec 0 b); (split; [split; cbn [rad den]; lia|]);
          rewrite val_rational, ?opp_IZR, mult_IZR; field; lra. }
      apply not_0_IZR in HB as HB'; split; [now constructor|]; split.
      * intros t; rewrite HA; split.
        -- intros H; exists x; split; [now left|]; rewrite Hval; field_simplify_eq; lra.
        -- intros (y & [<-|[]] & ->); rewrite Hval; field; lra.
      * intros y z [|? [|]] zs [= ] Hin; subst; contradiction.
  - set (D := (b * b - a * c)%Z).
    assert (HD : IZR D = IZR b * IZR b - IZR a * IZR c).
    { unfold D; now rewrite minus_IZR, !mult_IZR. }
    apply not_0_IZR in HA as HA'.
    destruct (Z.ltb_spec D 0) as [Hneg|Hpos].
    + split; [constructor|]; split; [|now intros ? ? []].
      intros t; split; [|now intros (x & [] & _)].
      intros H; exfalso; apply IZR_lt in Hneg.
      pose proof (Rle_0_sqr (IZR a * t + IZR b)) as Hs; unfold Rsqr in Hs.
      enough ((IZR a * t + IZR b) * (IZR a * t + IZR b) = IZR D) by lra.
      rewrite HD; replace (_ * _) with (IZR a * (IZR a * t * t + 2 * IZR b * t + IZR c)
        + (IZR b * IZR b - IZR a * IZR c)) by ring; rewrite H; ring.
    + destruct (if (0 <? a)%Z then _ else _) as [n d] eqn:E.
      assert ((0 < d)%Z /\ exists k, IZR D = IZR n * IZR n - IZR d * k /\ forall t,
        (IZR a * t * t + 2 * IZR b * t + IZR c = 0 <-> IZR d * t * t - 2 * IZR n * t + k = 0))
        as (Hd & k & Hk & Heq).
      { destruct (Z.ltb_spec 0 a); injection E as <- <-; (split; [lia|]);
          [exists (IZR c) | exists (- IZR c)]; rewrite ?opp_IZR; split; try (rewrite HD; ring);
          intros t; split; intros; lra. }
      apply IZR_lt in Hd as HdR; pose proof (sqrt_square D Hpos) as Hr; rewrite Hk in Hr at 3.
      split; [repeat constructor; simpl; assumption|]; split.
      * intros t; rewrite Heq, (two_roots (IZR n) (IZR d) k (sqrt (IZR D)) t HdR Hr); simpl; split.
        -- intros [->| ->]; [exists (Surd n (-1) D d) | exists (Surd n 1 D d)]; auto.
        -- intros (x & [<-|[<-|[]]] & ->); [left | right]; reflexivity.
      * intros y z [|? [|? [|]]] zs [= ] Hin; subst; try contradiction.
        destruct Hin as [<-|[]]; unfold val; simpl; apply Rmult_le_compat_r; [|pose proof (sqrt_pos (IZR D)); lra].
        now apply Rlt_le, Rinv_0_lt_compat.
Qed.

(** ** The line in the surface *)

Lemma starts_over_R g : starts g = true <-> Trazador.starts (over_R g).
Proof.
  unfold starts, Trazador.starts; simpl; rewrite orb_true_iff, andb_true_iff, orb_true_iff, andb_true_iff,
    !Z.ltb_lt, !Z.eqb_eq.
  assert (L : forall n, (n < 0)%Z <-> IZR n < 0) by (intros n; split; [apply IZR_lt | apply lt_IZR]).
  assert (E : forall n, n = 0%Z <-> IZR n = 0) by (intros n; split; [now intros -> | apply eq_IZR]).
  now rewrite !L, !E.
Qed.

Lemma proper_over_R q : proper q -> Forall (fun g => 0 <= Puntos.bA g) (map over_R (bounds q)).
Proof. intros H; rewrite Forall_map; eapply Forall_impl; [|exact H]; intros g Hg; now apply IZR_le. Qed.

(** Nothing that the bound holds at lies before its entry. *)
Lemma entries_correct g x t : (0 <= gA g)%Z -> In x (entries g) ->
  valid x /\ (Puntos.excess (over_R g) t <= 0 -> val x <= t).
Proof.
  intros HA; unfold entries; destruct (Z.ltb_spec (gB g) 0) as [HB|]; [|contradiction]; intros Hx.
  assert (Hnot : ~ (gA g = 0 /\ gB g = 0 /\ gC g = 0)%Z) by lia.
  pose proof (roots_correct _ _ _ Hnot) as (Hv & Hroots & _).
  assert (Hin : In x (roots (gA g) (gB g) (gC g))) by (destruct (roots _ _ _) as [|y ys]; [contradiction | destruct Hx as [->|[]]; now left]).
  split; [rewrite Forall_forall in Hv; now apply Hv|]; unfold Puntos.excess; simpl; intros He.
  unfold roots in Hx; apply IZR_lt in HB as HBR; destruct (Z.eqb_spec (gA g) 0) as [HA0|HA0].
  - destruct (Z.eqb_spec (gB g) 0); [lia|]; destruct (Z.ltb_spec 0 (gB g)); [lia|]; destruct Hx as [<-|[]].
    rewrite HA0 in He; rewrite val_rational, opp_IZR, mult_IZR; apply Rmult_le_reg_r with (- (2 * IZR (gB g))); [lra|].
    unfold Rdiv; rewrite Rmult_assoc, Rinv_l by lra; lra.
  - destruct (Z.ltb_spec (gB g * gB g - gA g * gC g) 0) as [|HD]; [contradiction|].
    destruct (Z.ltb_spec 0 (gA g)) as [HA'|]; [|lia]; destruct Hx as [<-|[]]; apply IZR_lt in HA'.
    pose proof (sqrt_square _ HD) as Hr; pose proof (sqrt_pos (IZR (gB g * gB g - gA g * gC g))) as Hr0.
    unfold val; simpl; set (r := sqrt _) in *; rewrite minus_IZR, !mult_IZR in Hr.
    rewrite opp_IZR; apply Rmult_le_reg_r with (IZR (gA g)); [lra|].
    unfold Rdiv; rewrite Rmult_assoc, Rinv_l by lra.
    apply Rnot_lt_le; intros Hlt; assert (Hp : 0 < - (t * IZR (gA g) + IZR (gB g)) - r) by lra.
    pose proof (Rmult_lt_0_compat _ _ Hp Hp); pose proof (Rmult_le_pos r _ Hr0 (Rlt_le _ _ Hp)).
    assert (IZR (gA g) * (IZR (gA g) * (t * t) + 2 * IZR (gB g) * t + IZR (gC g)) <= 0)
      by (apply Trazador.nonpositive_product; lra).
    lra.
Qed.

(** A bound that falls to 0 at a positive parameter has its entry in the list. *)
Lemma entry_listed g : (0 <= gA g)%Z -> IZR (gB g) < 0 -> 0 <= IZR (gB g) * IZR (gB g) - IZR (gA g) * IZR (gC g) ->
  exists x, In x (entries g) /\ val x = Trazador.entry (over_R g).
Proof.
  intros HA HB HD; unfold entries, roots, Trazador.entry, over_R; cbn [Puntos.bA Puntos.bB Puntos.bC];
    apply lt_IZR in HB as HBZ.
  destruct (Z.ltb_spec (gB g) 0); [|lia]; destruct (Z.eqb_spec (gA g) 0) as [HA0|HA0].
  - destruct (Z.eqb_spec (gB g) 0); [lia|]; destruct (Z.ltb_spec 0 (gB g)); [lia|].
    eexists; split; [now left|]; rewrite val_rational, opp_IZR, mult_IZR, HA0.
    replace (IZR (gB g) * IZR (gB g) - 0 * IZR (gC g)) with ((- IZR (gB g)) * (- IZR (gB g))) by ring.
    rewrite R_sqrt.sqrt_square by lra; field; lra.
  - assert (IZR (gB g * gB g - gA g * gC g) = IZR (gB g) * IZR (gB g) - IZR (gA g) * IZR (gC g)) as E
      by now rewrite minus_IZR, !mult_IZR.
    destruct (Z.ltb_spec (gB g * gB g - gA g * gC g) 0) as [Hneg|_]; [apply IZR_lt in Hneg; lra|].
    destruct (Z.ltb_spec 0 (gA g)) as [HA'|]; [|lia]; apply IZR_lt in HA'.
    eexists; split; [now left|]; unfold val; cbn [num coef rad den]; rewrite E, opp_IZR; clear E.
    pose proof (sqrt_sqrt _ HD) as Hr; pose proof (sqrt_pos (IZR (gB g) * IZR (gB g) - IZR (gA g) * IZR (gC g))).
    set (r := sqrt _) in *; apply (Rmult_eq_reg_r (IZR (gA g) * (r - IZR (gB g)))); [|apply Rgt_not_eq; nra].
    transitivity ((- IZR (gB g) - r) * (r - IZR (gB g))); [field; lra|].
    transitivity (IZR (gC g) * IZR (gA g)); [lra | field; lra].
Qed.

Lemma line_reaches q : proper q -> qA q = 0%Z -> qB q = 0%Z -> qC q = 0%Z -> reaches (solves q) (line q).
Proof.
  intros Hp HA HB HC; pose proof (proper_over_R q Hp) as HpR.
  assert (Hs : forall t, solves q t <-> 0 < t /\ inside (bounds q) t).
  { intros t; unfold solves; rewrite HA, HB, HC; split; [tauto|]; intros [Ht Hc]; repeat split; try tauto; ring. }
  unfold line; destruct (forallb starts (bounds q)) eqn:Hst.
  - rewrite forallb_forall in Hst; destruct (Trazador.bounds_start (map over_R (bounds q)) HpR) as (e & He & Hin).
    { rewrite Forall_map, Forall_forall; intros g Hg; now apply starts_over_R, Hst. }
    exists (e / 2); split; [lra|]; intros t Ht; apply Hs, Hin; lra.
  - assert (Hval : forall x, In x (flat_map entries (bounds q)) ->
      valid x /\ forall t, inside (bounds q) t -> val x <= t).
    { intros x Hx; apply in_flat_map in Hx as (g & Hg & Hx); unfold proper in Hp; rewrite Forall_forall in Hp.
      split; [now apply (entries_correct g x 0 (Hp g Hg))|]; intros t Ht.
      unfold inside in Ht; rewrite Forall_map, Forall_forall in Ht; now apply (entries_correct g x t (Hp g Hg)), Ht. }
    pose proof (pick_passes q (flat_map entries (bounds q))) as H; destruct (pick q _) as [|x|]; cbn [reaches].
    + intros t Ht; apply Hs in Ht as [Ht Hin].
      destruct (Trazador.bounds_begin _ t HpR Ht Hin) as [Hall|(gR & HgR & Sg & He & Hall & _)].
      * rewrite Forall_map, Forall_forall in Hall; enough (forallb starts (bounds q) = true) by congruence.
        apply forallb_forall; intros g Hg; now apply starts_over_R, Hall.
      * apply in_map_iff in HgR as (g & <- & Hg).
        unfold inside in Hin; rewrite Forall_map, Forall_forall in Hin.
        unfold proper in Hp; rewrite Forall_forall in Hp; pose proof (IZR_le _ _ (Hp g Hg)) as HgA.
        destruct (Trazador.entry_correct (over_R g) t Sg HgA Ht (Hin g Hg)) as (_ & _ & HgB & HgD).
        destruct (entry_listed g (Hp g Hg) HgB HgD) as (x & Hx & E).
        assert (Hx' : In x (flat_map entries (bounds q))) by (apply in_flat_map; now exists g).
        destruct (Hval x Hx') as [Hv _]; enough (within q x = true) by (rewrite H in *; congruence).
        apply within_correct; [exact Hv|]; rewrite E; split; [apply He | exact Hall].
    + destruct H as [Hx Hw]; destruct (Hval x Hx) as [Hv Hleast]; apply within_correct in Hw; [|exact Hv].
      split; [exact Hv | split; [now apply Hs|]]; intros t Ht; apply Hleast; now apply Hs in Ht.
    + contradiction.
Qed.

(** The procedure for one element is right in every case. *)
Theorem first_reaches q : proper q -> reaches (solves q) (first q).
Proof.
  intros Hp; unfold first; destruct (_ && _) eqn:E.
  - apply andb_true_iff in E as [E HC]; apply andb_true_iff in E as [HA HB]; apply Z.eqb_eq in HA, HB, HC.
    now apply line_reaches.
  - destruct (roots_correct (qA q) (qB q) (qC q)) as (Hv & Hroots & Hsorted); [|now apply pick_reaches].
    intros (HA & HB & HC); rewrite HA, HB, HC in E; discriminate.
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
