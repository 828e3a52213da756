(** * Limits: binary64 as the ends of what is known of a real, and the least of a list

    at_most x t, at_least x t == the binary64 x is -∞, or a number ≤ t;  +∞, or a number ≥ t
    rounded_once x r       == x is the real r rounded to the nearest binary64, ties to even, +∞ or -∞ beyond the largest:
                              all but the sign of a zero
    less_excludes, less_at_least == what x < y, with its infinities, says of the reals that they are ends of
    least_by less x l      == the least of x and l, as std::min_element finds it
    several l              == l has two or more *)
From Coq Require Import ZArith Reals List Bool Lra.
From Flocq Require Import Core BinarySingleNaN.
Import ListNotations.
Local Open Scope R_scope.

(** ** The numbers *)

Notation binary64 := (binary_float 53 1024).
Notation rnd64 := (round radix2 (FLT_exp (-1074) 53) ZnearestE).

Definition at_most (x : binary64) (t : R) : Prop := x = B754_infinity true \/ is_finite x = true /\ B2R x <= t.
Definition at_least (x : binary64) (t : R) : Prop := x = B754_infinity false \/ is_finite x = true /\ t <= B2R x.
Definition rounded_once (x : binary64) (r : R) : Prop :=
  if Rlt_bool (Rabs (rnd64 r)) (bpow radix2 1024) then is_finite x = true /\ B2R x = rnd64 r
  else x = B754_infinity (Rlt_bool r 0).

(** x < y, as the processor compares: nothing that y is not more than is at most x. *)
Lemma less_excludes (x y : binary64) t : Bltb x y = true -> at_most y t -> ~ at_least x t.
Proof.
  intros Hlt [-> | [Fy Hy]] [-> | [Fx Hx]].
  - discriminate Hlt.
  - destruct x as [s | s | | s m e H]; try discriminate Fx; discriminate Hlt.
  - destruct y as [s | s | | s m e H]; try discriminate Fy; discriminate Hlt.
  - rewrite Bltb_correct in Hlt by assumption. destruct (Rlt_bool_spec (B2R x) (B2R y)); [lra | discriminate].
Qed.
Lemma less_at_least (x y : binary64) t : Bltb x y = true -> at_least x t -> at_least y t.
Proof.
  intros Hlt [-> | [Fx Hx]]; [destruct y as [s | [|] | | [|] m e H]; discriminate Hlt |].
  destruct (is_finite y) eqn:Fy.
  - rewrite Bltb_correct in Hlt by assumption. destruct (Rlt_bool_spec (B2R x) (B2R y)); [| discriminate].
    right. split; [exact Fy | lra].
  - left. destruct y as [s' | [|] | | s' m' e' H']; try discriminate Fy; [| reflexivity |];
      destruct x as [s | s | | s m e H]; try discriminate Fx; destruct s; discriminate Hlt.
Qed.
Lemma at_least_below x t t' : t' <= t -> at_least x t -> at_least x t'.
Proof. intros H [-> | [F Hx]]; [now left | right; split; [exact F | lra]]. Qed.

Definition infinite : binary64 := B754_infinity false.
Definition zero : binary64 := B754_zero false.

(** ** Least elements of a list *)

Definition least_by {A} (less : A -> A -> bool) (x : A) (l : list A) : A :=
  fold_left (fun m y => if less y m then y else m) l x.

Lemma least_by_in {A} (less : A -> A -> bool) l x : In (least_by less x l) (x :: l).
Proof.
  revert x. induction l as [| y l IH]; intros x; [now left |]. unfold least_by. cbn [fold_left].
  destruct (IH (if less y x then y else x)) as [H | H]; [| right; right; exact H].
  unfold least_by in H. rewrite <- H. destruct (less y x); [right; now left | now left].
Qed.
(** Where the comparison is that of a number that each has, it has the least. *)
Lemma least_by_least {A} (less : A -> A -> bool) (f : A -> R) l x :
  (forall a b, In a (x :: l) -> In b (x :: l) -> (less a b = true <-> f a < f b)) ->
  forall a, In a (x :: l) -> f (least_by less x l) <= f a.
Proof.
  revert x. induction l as [| y l IH]; intros x H a Ha; [destruct Ha as [<- | []]; cbn; lra |].
  change (least_by less x (y :: l)) with (least_by less (if less y x then y else x) l).
  assert (Hm : let m := if less y x then y else x in In m [x; y] /\ f m <= f x /\ f m <= f y).
  { destruct (less y x) eqn:E.
    - apply H in E; [| right; now left | now left]. cbn; split; [tauto | lra].
    - assert (~ f y < f x) by (intros N; apply (H y x) in N; [congruence | right; now left | now left]).
      cbn; split; [tauto | lra]. }
  revert Hm. generalize (if less y x then y else x). intros m [Hin [Hx Hy]].
  assert (Sub : forall c, In c (m :: l) -> In c (x :: y :: l)).
  { intros c [<- | Hc]; [destruct Hin as [-> | [-> | []]]; [now left | right; now left] | right; now right]. }
  assert (K : forall c, In c (m :: l) -> f (least_by less m l) <= f c).
  { apply IH. intros b c Hb Hc. apply H; now apply Sub. }
  pose proof (K m (or_introl eq_refl)) as Km.
  destruct Ha as [<- | [<- | Ha]]; [lra | lra | apply K; now right].
Qed.

(** Those that are not farther than the nearest, by two comparisons: of what comes first, and of what is farther. *)
Definition not_farther {A} (first farther : A -> A -> bool) (l : list A) : list A :=
  match l with
  | [] => []
  | c :: l' => filter (fun d => negb (farther (least_by first c l') d)) l
  end.
Definition several {A} (l : list A) : bool := match l with _ :: _ :: _ => true | _ => false end.

(** ** Lists that name each once *)

Lemma once_more {A} (e : A) (l taken : list A) : (forall x, In x l -> In x taken) -> ~ In e taken -> NoDup l ->
  NoDup (e :: l).
Proof. intros H N D. constructor; [intros Hl; now apply N, H | exact D]. Qed.
Lemma NoDup_filter {A B} (f : A -> B) p l : NoDup (map f l) -> NoDup (map f (filter p l)).
Proof.
  induction l as [| x l IH]; intros H; [constructor |]. cbn in *. inversion_clear H as [| ? ? Hn Hd].
  destruct (p x); [cbn; constructor | now apply IH]; [| now apply IH].
  intros Hin. apply Hn. apply in_map_iff in Hin as [y [<- Hy]]. apply filter_In in Hy as [Hy _]. now apply in_map.
Qed.
