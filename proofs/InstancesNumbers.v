(** * InstancesNumbers: instances of the theorems about computed numbers

    It goes on from Instances.v, and tests/proofs/audit.sh reads it in the same way. What is computed of the numbers is computed
    by InstanceDyadic.v, each operation rounded as binary64 is.

    sphere y, cylinder y == the quadratic of the ray from (-3, y, 0) along x, and the sphere or the upright cylinder around the
                            origin, of radius 1 *)
From Coq Require Import ZArith Reals List Bool Lia Lra.
From Flocq Require Import Core BinarySingleNaN.
From Durero Require Import Toolkit Especificacion Rounding Vectors InstanceDyadic.
From Durero Require Exacto Flotante Formas Decision Sums InstanceSearch Main Instances.
Local Open Scope R_scope.
Local Open Scope zed_scope.

(** ** Rays, a sphere and a cylinder *)

Definition from (y : Z) : vec := Vec (IZR (-3)) (IZR y) (IZR 0).
Definition along_x : vec := Vec (IZR 1) (IZR 0) (IZR 0).
Definition origin : vec := Vec (IZR 0) (IZR 0) (IZR 0).
Definition along_z : vec := Vec (IZR 0) (IZR 0) (IZR 1).
Lemma integer_is_ordinary n : (Z.abs n <=? 16)%Z = true -> Flotante.ordinary (IZR n).
Proof.
  intros H; replace (IZR n) with (Exacto.over 2 (2 * n)) by (unfold Exacto.over; rewrite mult_IZR; lra).
  apply InstanceSearch.small_is_ordinary; unfold InstanceSearch.small; apply Z.leb_le in H; apply Z.leb_le; lia.
Qed.
Lemma from_is_ordinary y : (Z.abs y <=? 16)%Z = true -> Flotante.ordinary_vec (from y).
Proof. intros H; split; [|split]; now apply integer_is_ordinary. Qed.
Lemma along_x_is_ordinary : Flotante.ordinary_vec along_x.
Proof. split; [|split]; now apply integer_is_ordinary. Qed.
Lemma along_z_is_ordinary : Flotante.ordinary_vec along_z.
Proof. split; [|split]; now apply integer_is_ordinary. Qed.
Lemma origin_is_ordinary : Flotante.ordinary_vec origin.
Proof. split; [|split]; now apply integer_is_ordinary. Qed.
Lemma along_x_is_a_direction : 0 < norm along_x.
Proof. apply sqrt_lt_R0; unfold dot, along_x; cbn; lra. Qed.

Notation speed := (Formas.speed_of along_x).
Notation sphere y := (Formas.esfera (from y) along_x speed origin (IZR 1)).
Notation cylinder y := (Formas.cilindro (from y) along_x speed origin (IZR 1) along_z (IZR 2)).
Lemma speed_is : speed = D (2 ^ 52) (-52).
Proof. cbv beta delta [Formas.speed_of along_x]; projected; computes. Qed.

Ltac as_computed f := eassert (f = _) as -> by (rewrite speed_is;
  cbv beta delta [Formas.esfera Formas.cilindro from along_x along_z origin]; projected; computes).
Ltac has_both f := as_computed f; unfold Decision.has_roots; match goal with |- context [Decision.total ?q] =>
  eassert (Decision.total q = _) as -> by (refine (of_call (Formas.stable_sum q) _ _ _ _ _);
    [cbv beta delta [Decision.root_of_D Formas.root_of_discriminant] | cbv beta delta [Formas.stable_sum]]; projected; computes) end;
  projected; computes.
Lemma four_passes : Formas.F (sphere 4) < - Formas.B_error (sphere 4).
Proof. as_computed (sphere 4); projected; apply less; computes. Qed.
Lemma zero_meets : Formas.B_error (sphere 0) < Formas.F (sphere 0).
Proof. as_computed (sphere 0); projected; apply less; computes. Qed.
Lemma zero_meets_twice : Decision.has_roots (sphere 0) = true.
Proof. has_both (sphere 0). Qed.
Lemma four_passes_the_cylinder : Formas.F (cylinder 4) < - Formas.B_error (cylinder 4).
Proof. as_computed (cylinder 4); projected; apply less; computes. Qed.
Lemma zero_meets_the_cylinder_twice : Decision.has_roots (cylinder 0) = true.
Proof. has_both (cylinder 0). Qed.

Notation of_the_sphere theorem y := (theorem (from y) along_x origin (IZR 1) (from_is_ordinary y eq_refl) along_x_is_ordinary
  origin_is_ordinary (integer_is_ordinary 1 eq_refl) (IZR_lt 0 1 eq_refl) along_x_is_a_direction) (only parsing).
Definition instance_of_a_certified_miss_is_a_miss := of_the_sphere Main.a_certified_miss_is_a_miss 4%Z 3 four_passes.
Definition instance_of_a_certified_root_of_the_discriminant := of_the_sphere Main.a_certified_root_of_the_discriminant 0%Z zero_meets.
Definition instance_of_certified_roots := of_the_sphere Main.certified_roots 0%Z zero_meets_twice.
Definition instance_of_the_decision_on_a_sphere_is_right := of_the_sphere Main.the_decision_on_a_sphere_is_right 0%Z.

Lemma along_z_is_unit : mk_Vector (cx along_z) (cy along_z) (cz along_z) ∈ Unitario.
Proof. unfold Unitario, tolerancia_unidad, along_z; cbn; split; lra. Qed.
Notation of_the_cylinder theorem y := (theorem (from y) along_x origin along_z (IZR 1) (IZR 2) (from_is_ordinary y eq_refl)
  along_x_is_ordinary origin_is_ordinary along_z_is_ordinary (integer_is_ordinary 1 eq_refl) (IZR_lt 0 1 eq_refl)
  along_x_is_a_direction along_z_is_unit) (only parsing).
Definition instance_of_a_certified_miss_of_a_cylinder_is_a_miss :=
  of_the_cylinder Main.a_certified_miss_of_a_cylinder_is_a_miss 4%Z 3 four_passes_the_cylinder.
Definition instance_of_certified_roots_of_a_cylinder :=
  of_the_cylinder Main.certified_roots_of_a_cylinder 0%Z zero_meets_the_cylinder_twice.

(** ** Double-double *)

Lemma five_is_a_word : Sums.double_word (Formas.Pairs.exactly 5).
Proof. exact (proj1 (Sums.exactly_word 5 Instances.five_is_binary64)). Qed.
Definition instance_of_double_doubles_are_within_their_bounds :=
  Main.double_doubles_are_within_their_bounds _ _ five_is_a_word five_is_a_word.
