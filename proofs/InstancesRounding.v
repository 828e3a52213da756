(** * InstancesRounding: instances of the theorems about what is rounded once

    It goes on from Instances.v, and tests/proofs/audit.sh reads it in the same way.

    silver, tie == (1 + √2)/3, which is 0.804…, and 1 + √(2^-106), which is as near to 1 as to the next binary64
    near n      == a double-double of which n is within 2^-59;  printed t x y z == the binary64s of these integers *)
From Coq Require Import ZArith Reals List Bool Lia Lra.
From Flocq Require Import Core BinarySingleNaN.
From Durero Require Import Toolkit Especificacion Rounding Vectors Exacto InstanceScene InstanceSearch InstanceDyadic.
From Durero Require Quick Exactly Twofold Formas Once Levels Puntos Tipos Triage Whole Chain Main MainModels Instances.
Local Open Scope R_scope.
Local Open Scope zed_scope.

(** ** Exact numbers *)

Lemma extended_is x m e : rnd x = D m e -> (Z.abs m <? 2 ^ 53)%Z && (e <=? 900)%Z = true -> Exactly.extended x = D m e.
Proof.
  rewrite andb_true_iff, Z.ltb_lt, Z.leb_le; intros E [M K]; unfold Exactly.extended; rewrite E.
  assert (L : Rabs (D m e) <= bpow radix2 1024).
  { unfold D; rewrite Rabs_mult, (Rabs_pos_eq (bpow radix2 e)), <- abs_IZR by apply bpow_ge_0.
    apply Rle_trans with (bpow radix2 53 * bpow radix2 e); [|rewrite <- bpow_plus; apply bpow_le; lia].
    apply Rmult_le_compat_r; [apply bpow_ge_0|]; change (bpow radix2 53) with (IZR (2 ^ 53)); apply IZR_le; lia. }
  apply Rabs_le_inv in L; rewrite Rmin_right, Rmax_right by lra; reflexivity.
Qed.
Ltac decided := repeat match goal with
  | |- context [if ?b then _ else _] => lazymatch b with Req_bool _ _ => fail | _ =>
      let c := eval vm_compute in b in replace b with c by (vm_compute; reflexivity); cbv iota beta end end.
Ltac extended_all := repeat match goal with |- context [Exactly.extended ?x] => lazymatch x with Rmult _ _ =>
  eassert (Exactly.extended x = _) as -> by (eapply extended_is; [computes | vm_cast_no_check (eq_refl true)]) end end.
Ltac quickly := unfold Quick.quick, Quick.ends; cbv zeta; decided; extended_all.

Lemma silver : Quick.quick Exactly.extended 1 0 1 0 2 0 3 0 = Some (D 7248434199930846 (-53)).
Proof. quickly; rewrite Req_bool_true by reflexivity; reflexivity. Qed.
Definition instance_of_the_quick_rounding_says_nothing_false := Main.the_quick_rounding_says_nothing_false Exactly.extended 1 0 1 0 2 0 3 0 _
  Exactly.extended_le (Zle_bool_imp_le 0 2 eq_refl) (fun H => ltac:(discriminate H)) (fun _ H => ltac:(discriminate H)) silver.

Lemma not_quickly : Quick.quick Exactly.extended 1 0 1 0 1 (-106) 1 0 = None.
Proof. quickly; rewrite Req_bool_false; [reflexivity | apply Rlt_not_eq, D_lt; reflexivity]. Qed.
Lemma cut_whole x y w value c p :
  Exactly.attempt x y w value (Exactly.Root_cut c p true) = Some (Exactly.extended ((x + y * (IZR c * bpow radix2 p)) / w)).
Proof. reflexivity. Qed.
Lemma tie : Exactly.exactly 1 1 0 1 0 1 (-106) 1 0 = Some (D (2 ^ 52) (-52)).
Proof.
  unfold Exactly.exactly; rewrite not_quickly; cbn [Z.eqb orb andb Exactly.attempts].
  replace (Exactly.cut_root 1 (-106) 128) with (Exactly.Root_cut (2 ^ 128) (-181) true) by (vm_compute; reflexivity).
  rewrite cut_whole; cbv iota; f_equal; apply extended_is; [|reflexivity].
  unfold Quick.dyadic; change (bpow radix2 0) with 1; unfold Rdiv; rewrite !Rmult_1_l, Rinv_1, Rmult_1_r; computes.
Qed.
Lemma stored_exactly n e : exact n e = true -> Exactly.stored (float_of n e) (D n e).
Proof.
  intros X; apply exact_float in X as [F V]; unfold Exactly.stored; rewrite <- V, Rlt_bool_true; [now split|].
  exact (abs_B2R_lt_emax 53 1024 (float_of n e)).
Qed.
Definition instance_of_the_exact_rounding_says_nothing_false := MainModels.the_exact_rounding_says_nothing_false 1 1 0 1 0 1 (-106) 1 0 _
  (float_of (2 ^ 52) (-52)) (Zle_bool_imp_le 0 1 eq_refl) (fun H => ltac:(discriminate H)) tie (stored_exactly (2 ^ 52) (-52) eq_refl).

(** ** What is certain: from (-3, 1, 1/2) along (1, 1/2, -1), of a parameter near 2 *)

Notation real := (Whole.vec_over 2).
Notation p := (real (v3 (-6) 2 1)).
Notation v := (real (v3 2 1 (-2))).
Ltac reals := cbv beta iota delta [Whole.vec_over vx vy vz]; projected.
Lemma a_pair n e m f : exact n e && exact m f && (sign_of (Z.abs m) f (Z.abs n) (e - 53) <=? 0)%Z = true ->
  Twofold.pair (Formas.Pairs.Twofold (D n e) (D m f)).
Proof.
  rewrite !andb_true_iff; intros [[N M] L]; split; [|split]; cbn [Formas.Pairs.hi Formas.Pairs.lo]; try now apply exact_format.
  rewrite !(D_abs _ _ _ eq_refl), power, (D_mult _ _ _ _ (Z.abs n) (e - 53)) by lia; now apply D_le.
Qed.
Notation near n := (Formas.Pairs.Twofold (D n 0) (D 1 (-60))).
Lemma at_two : Formas.Pairs.round_point p v (near 2) (D 1 (-59)) =
  Formas.Pairs.Once_point (D (2 ^ 52) (-51)) (D (- 2 ^ 52) (-52)) (D (2 ^ 52) (-51)) (D (-3 * 2 ^ 51) (-52)) true.
Proof. cbv beta delta [Formas.Pairs.round_point]; reals; computes. Qed.
Lemma is_near n : Rabs (IZR n - Twofold.whole (near n)) <= D 1 (-59).
Proof.
  unfold Twofold.whole; projected; rewrite <- integer; replace (IZR n - (IZR n + D 1 (-60))) with (- D 1 (-60)) by ring.
  apply at_most; computes.
Qed.
Lemma error_is_not_least : bpow radix2 (-900) <= D 1 (-59).
Proof. apply at_most; computes. Qed.
Definition printed (t x y z : Z * Z) : Chain.printed := Chain.Printed (float_of (fst t) (snd t)) (float_of (fst x) (snd x))
  (float_of (fst y) (snd y)) (float_of (fst z) (snd z)).
Lemma is_stored (t x y z : Z * Z) c :
  exact (fst t) (snd t) && exact (fst x) (snd x) && exact (fst y) (snd y) && exact (fst z) (snd z) = true ->
  Once.stores (printed t x y z) (Formas.Pairs.Once_point (D (fst t) (snd t)) (D (fst x) (snd x)) (D (fst y) (snd y)) (D (fst z) (snd z)) c).
Proof. rewrite !andb_true_iff; intros [[[T X] Y] Z0]; repeat split; now apply exact_float. Qed.
Definition instance_of_what_is_certain_is_rounded_right := Main.what_is_certain_is_rounded_right p v (near 2) (D 1 (-59)) 2
  (printed (2 ^ 52, -51) (- 2 ^ 52, -52) (2 ^ 52, -51) (-3 * 2 ^ 51, -52))%Z
  (small_vec_is_ordinary (v3 (-6) 2 1) eq_refl) (small_vec_is_ordinary (v3 2 1 (-2)) eq_refl)
  (a_pair 2 0 1 (-60) eq_refl) (exact_format 1 (-59) eq_refl) error_is_not_least (is_near 2) (f_equal _ at_two) (eq_ind_r (Once.stores _) 
  (is_stored (2 ^ 52, -51) (- 2 ^ 52, -52) (2 ^ 52, -51) (-3 * 2 ^ 51, -52) true eq_refl)%Z at_two).

(** On the plane x = 40 of the seven shapes, by the ray of Instances.v, near 12: all points of the plane have that x. *)
Notation the_ray theorem := (theorem nat (scene_of 2 seven) (real (v3 (-16) 2 1)) (real (v3 8 1 (-1))) the_seven_are_a_scene)
  (only parsing).
Notation the_plane := (Whole.shape_over 2 (shape_at 5)).
Definition plane_is_there : In 5%nat elements := in_map fst seven _ (ltac:(cbn; tauto) : In (5%nat, shape_at 5) seven).
Lemma twelve_is_there : Puntos.value (Triage.text_of (real (v3 (-16) 2 1)) (real (v3 8 1 (-1))) the_plane) 12 = 0.
Proof. unfold Puntos.value; cbn; unfold Tipos.dot; cbn; unfold over; lra. Qed.
Lemma at_twelve : Levels.round_on (real (v3 (-16) 2 1)) (real (v3 8 1 (-1))) the_plane (near 12) (D 1 (-59)) =
  Formas.Pairs.Once_point (D (3 * 2 ^ 51) (-49)) (D (5 * 2 ^ 50) (-47)) (D (7 * 2 ^ 50) (-50)) (D (-11 * 2 ^ 49) (-50)) true.
Proof.
  change the_plane with (Triage.Plane (real (v3 80 0 0)) (real (v3 2 0 0))); cbv beta iota delta [Levels.round_on Formas.Pairs.round_plano]; reals.
  computes.
Qed.
Definition instance_of_what_is_certain_on_an_element_is_rounded_right :=
  the_ray Main.what_is_certain_on_an_element_is_rounded_right (proj1 Instances.in_bounds) 5%nat the_plane (near 12) (D 1 (-59)) 12
  (printed (3 * 2 ^ 51, -49) (5 * 2 ^ 50, -47) (7 * 2 ^ 50, -50) (-11 * 2 ^ 49, -50))%Z
  (proj1 (over_two Instances.nowhere 5 plane_is_there)) (seven_are_ordinary 5 plane_is_there) (fun _ => twelve_is_there)
  (a_pair 12 0 1 (-60) eq_refl) (exact_format 1 (-59) eq_refl) error_is_not_least (is_near 12) (f_equal _ at_twelve)
  (eq_ind_r (Once.stores _)
    (is_stored (3 * 2 ^ 51, -49) (5 * 2 ^ 50, -47) (7 * 2 ^ 50, -50) (-11 * 2 ^ 49, -50) true eq_refl)%Z at_twelve).
