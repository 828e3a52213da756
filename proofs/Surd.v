(** * Surd: the numbers (x + y√a) / w, compared with products of integers only

    surd, val x           == the number (num + coef √rad) / den, and its value in R
    valid x               == rad >= 0 and den > 0: what [val] needs to mean that number
    sign1 x y a, sign2 x y a z b == the sign of x + y√a, of x + y√a + z√b
    cmp x y               == the order of two surds
    sign_square a b c x   == the sign of a x² + 2 b x + c
    is_sign s r           == s is 1, 0, -1 as r is positive, zero, negative *)
From Coq Require Import ZArith Reals Lia Lra Bool.
Local Open Scope Z_scope.

Record surd := Surd { num : Z; coef : Z; rad : Z; den : Z }.

Definition sign1 (x y a : Z) : Z :=
  let s := Z.sgn x in
  let t := Z.sgn y * Z.sgn a in
  if s =? 0 then t else if (t =? 0) || (s =? t) then s else s * Z.sgn (x * x - y * y * a).

Definition sign2 (x y a z b : Z) : Z :=
  let s := sign1 x y a in
  let t := Z.sgn z * Z.sgn b in
  if s =? 0 then t else if (t =? 0) || (s =? t) then s
  else s * sign1 (x * x + y * y * a - z * z * b) (2 * (x * y)) a.

Definition cmp (x y : surd) : Z :=
  sign2 (num x * den y - num y * den x) (coef x * den y) (rad x) (- (coef y * den x)) (rad y).

(** The sign of a x² + 2 b x + c, that of its product with the square of x's denominator. *)
Definition sign_square (a b c : Z) (x : surd) : Z :=
  let n := num x in
  let m := coef x in
  let w := den x in
  sign1 (a * (n * n + m * m * rad x) + 2 * (b * (n * w)) + c * (w * w)) (2 * (m * (a * n + b * w))) (rad x).

(** ** What it means, over R *)

Local Open Scope R_scope.

Definition valid (x : surd) : Prop := (0 <= rad x)%Z /\ (0 < den x)%Z.
Definition val (x : surd) : R := (IZR (num x) + IZR (coef x) * sqrt (IZR (rad x))) / IZR (den x).

Definition is_sign (s : Z) (r : R) : Prop :=
  s = 1%Z /\ 0 < r \/ s = 0%Z /\ r = 0 \/ s = (-1)%Z /\ r < 0.

Lemma is_sign_sgn n : is_sign (Z.sgn n) (IZR n).
Proof.
  destruct n; [right; left | left | right; right]; simpl; split; auto; apply IZR_lt; reflexivity.
Qed.

(** The sign of X + Y from those of X, Y and, when they differ, of X² - Y². *)
Lemma is_sign_plus s t d X Y : is_sign s X -> is_sign t Y -> is_sign d (X * X - Y * Y) ->
  is_sign (if s =? 0 then t else if (t =? 0) || (s =? t) then s else s * d)%Z (X + Y).
Proof.
  unfold is_sign; intros [[-> HX]|[[-> HX]|[-> HX]]] [[-> HY]|[[-> HY]|[-> HY]]] [[-> Hd]|[[-> Hd]|[-> Hd]]];
    simpl; try (left; split; [reflexivity | nra]); try (right; left; split; [reflexivity | nra]);
    (right; right; split; [reflexivity | nra]).
Qed.

Lemma is_sign_times s t X Y : is_sign s X -> is_sign t Y -> is_sign (s * t) (X * Y).
Proof.
  unfold is_sign; intros [[-> HX]|[[-> HX]|[-> HX]]] [[-> HY]|[[-> HY]|[-> HY]]]; simpl;
    try (left; split; [reflexivity | nra]); try (right; left; split; [reflexivity | nra]);
    (right; right; split; [reflexivity | nra]).
Qed.

Lemma is_sign_sqrt a : (0 <= a)%Z -> is_sign (Z.sgn a) (sqrt (IZR a)).
Proof.
  intros Ha; apply IZR_le in Ha; destruct (is_sign_sgn a) as [[-> H]|[[-> H]|[_ H]]]; [left | right; left | lra].
  - split; [reflexivity | now apply sqrt_lt_R0].
  - rewrite H; split; [reflexivity | apply sqrt_0].
Qed.

Lemma sqrt_square a : (0 <= a)%Z -> sqrt (IZR a) * sqrt (IZR a) = IZR a.
Proof. intros Ha; apply sqrt_sqrt; now apply IZR_le. Qed.

Theorem sign1_correct x y a : (0 <= a)%Z -> is_sign (sign1 x y a) (IZR x + IZR y * sqrt (IZR a)).
Proof.
  intros Ha; apply is_sign_plus;
    [apply is_sign_sgn | apply is_sign_times; [apply is_sign_sgn | now apply is_sign_sqrt] |].
  replace (IZR x * IZR x - _) with (IZR (x * x - y * y * a)); [apply is_sign_sgn|].
  rewrite minus_IZR, !mult_IZR, <- (sqrt_square a Ha) at 1; ring.
Qed.

Theorem sign2_correct x y a z b : (0 <= a)%Z -> (0 <= b)%Z ->
  is_sign (sign2 x y a z b) (IZR x + IZR y * sqrt (IZR a) + IZR z * sqrt (IZR b)).
Proof.
  intros Ha Hb; apply is_sign_plus;
    [now apply sign1_correct | apply is_sign_times; [apply is_sign_sgn | now apply is_sign_sqrt] |].
  pose proof (sign1_correct (x * x + y * y * a - z * z * b) (2 * (x * y)) a Ha) as H.
  rewrite minus_IZR, plus_IZR, !mult_IZR in H; rewrite <- (sqrt_square a Ha), <- (sqrt_square b Hb) in H at 1.
  match type of H with is_sign _ ?e => match goal with |- is_sign _ ?f => replace f with e by ring end end; exact H.
Qed.

Lemma is_sign_scale s d r : 0 < d -> is_sign s (d * r) -> is_sign s r.
Proof.
  unfold is_sign; intros Hd [[-> H]|[[-> H]|[-> H]]]; [left | right; left | right; right]; split; auto;
    [apply (Rmult_lt_reg_l d) | apply (Rmult_eq_reg_l d) | apply (Rmult_lt_reg_l d)]; lra.
Qed.

Lemma den_pos x : valid x -> 0 < IZR (den x).
Proof. intros [_ H]; now apply IZR_lt. Qed.

Lemma val_den x : valid x -> IZR (den x) * val x = IZR (num x) + IZR (coef x) * sqrt (IZR (rad x)).
Proof. intros H; pose proof (den_pos x H); unfold val; field; lra. Qed.

Theorem cmp_correct x y : valid x -> valid y -> is_sign (cmp x y) (val x - val y).
Proof.
  intros Hx Hy; pose proof (den_pos x Hx); pose proof (den_pos y Hy).
  apply (is_sign_scale _ (IZR (den x) * IZR (den y))); [now apply Rmult_lt_0_compat|].
  pose proof (sign2_correct (num x * den y - num y * den x) (coef x * den y) (rad x) (- (coef y * den x)) (rad y)
    (proj1 Hx) (proj1 Hy)) as H1.
  rewrite minus_IZR, opp_IZR, !mult_IZR in H1.
  match goal with |- is_sign _ ?f => replace f with
    (IZR (den y) * (IZR (den x) * val x) - IZR (den x) * (IZR (den y) * val y)) by ring end.
  rewrite !val_den by assumption.
  match type of H1 with is_sign _ ?e => match goal with |- is_sign _ ?f => replace f with e by ring end end; exact H1.
Qed.

Lemma sign_square_correct a b c x : valid x ->
  is_sign (sign_square a b c x) (IZR a * (val x * val x) + 2 * IZR b * val x + IZR c).
Proof.
  intros Hx; pose proof (den_pos x Hx); apply (is_sign_scale _ (IZR (den x) * IZR (den x))); [now apply Rmult_lt_0_compat|].
  unfold sign_square; match goal with |- is_sign (sign1 ?p ?q ?r) _ =>
    pose proof (sign1_correct p q r (proj1 Hx)) as H1 end.
  repeat rewrite ?plus_IZR, ?mult_IZR in H1; rewrite <- (sqrt_square (rad x) (proj1 Hx)) in H1 at 1.
  replace (IZR (den x) * IZR (den x) * _) with (IZR a * ((IZR (den x) * val x) * (IZR (den x) * val x))
    + 2 * IZR b * (IZR (den x) * val x) * IZR (den x) + IZR c * (IZR (den x) * IZR (den x))) by ring.
  rewrite val_den by assumption.
  match type of H1 with is_sign _ ?e => match goal with |- is_sign _ ?f => replace f with e by ring end end; exact H1.
Qed.

Lemma is_sign_pos s r : is_sign s r -> ((0 <? s)%Z = true <-> 0 < r).
Proof. rewrite Z.ltb_lt; intros [[-> H]|[[-> H]|[-> H]]]; split; intros; try lia; try lra. Qed.

Lemma is_sign_nonneg s r : is_sign s r -> ((0 <=? s)%Z = true <-> 0 <= r).
Proof. rewrite Z.leb_le; intros [[-> H]|[[-> H]|[-> H]]]; split; intros; try lia; try lra. Qed.

Lemma is_sign_nonpos s r : is_sign s r -> ((s <=? 0)%Z = true <-> r <= 0).
Proof. rewrite Z.leb_le; intros [[-> H]|[[-> H]|[-> H]]]; split; intros; try lia; try lra. Qed.
