(** * Flotante: the bounds by which the certified tracer decides on a sphere, in binary64

    trace/quadratic-inl.hpp and closed_form-inl.hpp compute, each operation rounded once, with q = p - centro:
      A = v·v,  B = q·v,  C = q·q - r²,  F, H = r|v| ∓ |q × v|  (√(v·v) for |v|),  S = √(F·H)
      V = |v.x| + |v.y| + |v.z|,  E = |q.x| + |q.y| + |q.z| + r
      A_error = 2^-47·V·V,  B_error = 2^-47·V·E,  C_error = 2^-47·E·E,  S_error = 3·B_error·H/S + 2^-51·S
    and decides: F < -B_error: the line misses; F > B_error: it meets the sphere twice, √(B² - AC) is S up to S_error,
    and the roots are q/A and C/q for q = -(B ± S), each up to the bound of its quotient. Here each bound is proved for
    numbers that are 0 or at least 2^-100 in magnitude: then nothing underflows. The tracer takes none above 2^100, so no
    value exceeds 2^900, nothing overflows, and [rnd] is the rounding.
    The slab test is in Slab.v.

    vec, dot, cross, norm == exact vectors;  dot_fl, cross_fl, norm_fl, extent_fl == the same, computed
    ordinary x            == x is a binary64, 0 or at least 2^-100
    X_fl, X_error         == the computed X and its computed bound, for the names above *)
From Coq Require Import Reals ZArith Lra Lia Psatz.
From Flocq Require Import Core.
From Durero Require Import Rounding.
Local Open Scope R_scope.
Local Opaque bpow.

Record vec := Vec { cx : R; cy : R; cz : R }.

Definition dot (a b : vec) : R := cx a * cx b + cy a * cy b + cz a * cz b.
Definition cross (a b : vec) : vec :=
  Vec (cy a * cz b - cz a * cy b) (cz a * cx b - cx a * cz b) (cx a * cy b - cy a * cx b).
Definition norm (a : vec) : R := sqrt (dot a a).
Definition extent (a : vec) : R := Rabs (cx a) + Rabs (cy a) + Rabs (cz a).
Definition minus (a b : vec) : vec := Vec (cx a - cx b) (cy a - cy b) (cz a - cz b).

Definition dot_fl (a b : vec) : R := rnd (rnd (rnd (cx a * cx b) + rnd (cy a * cy b)) + rnd (cz a * cz b)).
Definition cross_fl (a b : vec) : vec :=
  Vec (rnd (rnd (cy a * cz b) - rnd (cz a * cy b))) (rnd (rnd (cz a * cx b) - rnd (cx a * cz b)))
    (rnd (rnd (cx a * cy b) - rnd (cy a * cx b))).
Definition norm_fl (a : vec) : R := rnd (sqrt (dot_fl a a)).
Definition extent_fl (a : vec) : R := rnd (rnd (Rabs (cx a) + Rabs (cy a)) + Rabs (cz a)).
Definition minus_fl (a b : vec) : vec := Vec (rnd (cx a - cx b)) (rnd (cy a - cy b)) (rnd (cz a - cz b)).

(** ** Vectors *)

Definition on_grid (k : Z) (a : vec) : Prop :=
  format (cx a) /\ format (cy a) /\ format (cz a) /\ grid k (cx a) /\ grid k (cy a) /\ grid k (cz a).

(** Each component is computed, relative to the exact one's size. *)
Definition close (n : nat) (k : Z) (a x : vec) : Prop :=
  computed n k (cx a) (cx x) (Rabs (cx x)) /\ computed n k (cy a) (cy x) (Rabs (cy x)) /\
  computed n k (cz a) (cz x) (Rabs (cz x)).

Lemma close_exact k a : on_grid k a -> close 0 k a a.
Proof. intros (? & ? & ? & ? & ? & ?); repeat split; try assumption; apply near_exact. Qed.

(** The dot product of the magnitudes. *)
Definition size_of_dot (a b : vec) : R :=
  Rabs (cx a) * Rabs (cx b) + Rabs (cy a) * Rabs (cy b) + Rabs (cz a) * Rabs (cz b).

Lemma dot_computed i j k l a b x y : (-1022 <= k + l)%Z -> close i k a x -> close j l b y ->
  computed (S (S (S (i + j)))) (k + l) (dot_fl a b) (dot x y) (size_of_dot x y).
Proof.
  intros Hk (Ax & Ay & Az) (Bx & By & Bz); apply computed_plus; [assumption | |].
  - apply computed_plus; [assumption | |]; now apply computed_mult.
  - apply (computed_more (S (i + j))); [lia|]; now apply computed_mult.
Qed.

Lemma extent_computed n k a x : (-1022 <= k)%Z -> close n k a x ->
  computed (S (S n)) k (extent_fl a) (extent x) (extent x).
Proof.
  intros Hk (Ax & Ay & Az); apply computed_plus; [assumption | |].
  - apply computed_plus; [assumption | |]; now apply computed_abs.
  - apply (computed_more n); [lia|]; now apply computed_abs.
Qed.

Lemma abs_sum_squares x y z : 0 <= x * x + y * y + z * z.
Proof. nra. Qed.

Lemma norm_nonneg a : 0 <= norm a. Proof. apply sqrt_pos. Qed.
Lemma norm_square a : norm a * norm a = dot a a. Proof. apply sqrt_sqrt, abs_sum_squares. Qed.

Lemma extent_nonneg a : 0 <= extent a.
Proof. unfold extent; pose proof (Rabs_pos (cx a)); pose proof (Rabs_pos (cy a)); pose proof (Rabs_pos (cz a));
  lra. Qed.

(** The norm moves no more than the components do. *)
Lemma norm_lipschitz a b : Rabs (norm a - norm b) <= extent (minus a b).
Proof.
  destruct a as [x y z], b as [x' y' z']; unfold norm, dot, extent, minus; simpl.
  pose proof (sqrt_lipschitz x x' (y * y + z * z) ltac:(nra)) as H1.
  pose proof (sqrt_lipschitz y y' (x' * x' + z * z) ltac:(nra)) as H2.
  pose proof (sqrt_lipschitz z z' (x' * x' + y' * y') ltac:(nra)) as H3.
  replace (x * x + (y * y + z * z)) with (x * x + y * y + z * z) in H1 by ring.
  replace (y * y + (x' * x' + z * z)) with (x' * x' + (y * y + z * z)) in H2 by ring.
  replace (y' * y' + (x' * x' + z * z)) with (z * z + (x' * x' + y' * y')) in H2 by ring.
  replace (z' * z' + (x' * x' + y' * y')) with (x' * x' + y' * y' + z' * z') in H3 by ring.
  apply Rabs_le_inv in H1, H2, H3; apply Rabs_le; lra.
Qed.

Lemma norm_le_extent a : norm a <= extent a.
Proof.
  pose proof (norm_lipschitz a (Vec 0 0 0)) as H; unfold norm at 2, dot in H; simpl in H.
  replace (0 * 0 + 0 * 0 + 0 * 0) with 0 in H by ring; rewrite sqrt_0 in H.
  unfold extent, minus in *; simpl in H; rewrite !Rminus_0_r in H; apply Rabs_le_inv in H; lra.
Qed.

Lemma size_of_dot_le a b : size_of_dot a b <= extent a * extent b.
Proof.
  unfold size_of_dot, extent; pose proof (Rabs_pos (cx a)); pose proof (Rabs_pos (cy a)); pose proof (Rabs_pos (cz a)).
  pose proof (Rabs_pos (cx b)); pose proof (Rabs_pos (cy b)); pose proof (Rabs_pos (cz b)); nra.
Qed.

(** Eight units for a computed length: six for the square's three roundings, one for the root's, one to spare. *)
Lemma norm_computed k a : (-511 <= k)%Z -> on_grid k a ->
  Rabs (norm_fl a - norm a) <= 8 * u * norm a /\ (norm_fl a = 0 \/ bpow radix2 k <= norm_fl a).
Proof.
  intros Hk Ha; pose proof u_bounds; pose proof (norm_nonneg a) as Hn.
  pose proof (dot_computed 0 0 k k a a a a ltac:(lia) (close_exact k a Ha) (close_exact k a Ha)) as Hc.
  replace (size_of_dot a a) with (norm a * norm a) in Hc.
  2: { rewrite norm_square; unfold size_of_dot, dot; rewrite <- !Rabs_mult, !Rabs_pos_eq; [reflexivity | nra..]. }
  pose proof (computed_error 3 _ _ _ _ ltac:(lia) Hc) as He; rewrite <- norm_square in He; simpl INR in He.
  destruct Hc as (_ & _ & HG); unfold norm_fl; set (G := dot_fl a a) in *.
  assert (HG0 : 0 <= G) by (apply Rabs_le_inv in He; nra).
  assert (HGk : G = 0 \/ bpow radix2 k * bpow radix2 k <= G).
  { destruct HG as [m Hm]; rewrite <- bpow_plus; destruct (Z_lt_le_dec 0 m) as [Hp|Hp]; [right | left].
    - rewrite Hm; rewrite <- (Rmult_1_l (bpow radix2 (k + k))) at 1.
      apply Rmult_le_compat_r; [apply bpow_ge_0 | apply IZR_le; lia].
    - apply IZR_le in Hp; pose proof (bpow_gt_0 radix2 (k + k)); nra. }
  assert (Hroot : sqrt G = 0 \/ bpow radix2 k <= sqrt G).
  { destruct HGk as [->|HGk]; [left; apply sqrt_0 | right].
    rewrite <- (sqrt_square (bpow radix2 k)) by apply bpow_ge_0; now apply sqrt_le_1_alt. }
  split.
  - assert (Hd : Rabs (sqrt G - norm a) <= 6 * u * norm a).
    { destruct (Req_dec (norm a) 0) as [Z0|N0].
      - rewrite Z0 in *; assert (G = 0) as -> by (apply Rabs_le_inv in He; nra).
        rewrite sqrt_0, Rminus_0_r, Rabs_R0; lra.
      - rewrite Rabs_minus_sym; unfold norm at 1.
        apply Rle_trans with (1 := sqrt_distance (dot a a) G ltac:(rewrite <- norm_square; nra) HG0).
        fold (norm a); rewrite Rabs_minus_sym, <- norm_square; apply Rmult_le_reg_r with (norm a); [lra|].
        unfold Rdiv; rewrite Rmult_assoc, Rinv_l by lra; lra. }
    assert (Hr : Rabs (rnd (sqrt G) - sqrt G) <= u * Rabs (sqrt G)).
    { apply rnd_rel; destruct Hroot as [->|Hroot]; [now left | right].
      rewrite Rabs_pos_eq by apply sqrt_pos; apply Rle_trans with (2 := Hroot), bpow_le; lia. }
    rewrite (Rabs_pos_eq (sqrt G)) in Hr by apply sqrt_pos.
    apply Rabs_le_inv in Hd, Hr; apply Rabs_le; nra.
  - destruct Hroot as [->|Hroot]; [left; apply rnd_0 | right].
    replace (bpow radix2 k) with (rnd (bpow radix2 k)); [now apply rnd_le|].
    apply round_generic; [auto with typeclass_instances | apply generic_format_bpow; unfold FLT_exp; lia].
Qed.

(** ** The sphere *)

Definition ordinary (x : R) : Prop := format x /\ (x = 0 \/ bpow radix2 (-100) <= Rabs x).
Definition ordinary_vec (a : vec) : Prop := ordinary (cx a) /\ ordinary (cy a) /\ ordinary (cz a).

(** S as a number: e stands for B_error, X for F_fl·H_fl. *)
Lemma root_of_product e f h d X P S : 0 < e -> 0 <= d -> e < f -> f <= h ->
  X = f * h -> Rabs (X - d) <= e * h -> Rabs (P - X) <= u * X -> Rabs (S - sqrt P) <= u * sqrt P ->
  0 < S /\ S <= 2 * h /\ Rabs (S - sqrt d) <= 2 * (e * h / S) + 3 * u * S.
Proof.
  intros He Hd Hf Hh HX Hd' HP HS; pose proof u_bounds.
  assert (HX0 : 0 < X) by (rewrite HX; apply Rmult_lt_0_compat; lra); pose proof (sqrt_lt_R0 X HX0) as HsX.
  apply Rabs_le_inv in HP as HP'; assert (HP0 : 0 <= P) by nra.
  assert (H1 : Rabs (sqrt X - sqrt P) <= u * sqrt X).
  { apply Rle_trans with (1 := sqrt_distance X P HX0 HP0); apply Rmult_le_reg_r with (sqrt X); [assumption|].
    unfold Rdiv; rewrite Rmult_assoc, Rinv_l, Rmult_assoc, sqrt_sqrt, Rabs_minus_sym by lra; lra. }
  pose proof (sqrt_distance X d HX0 Hd) as H2.
  apply Rabs_le_inv in H1, HS; set (x := sqrt X) in *; set (s := sqrt P) in *.
  assert (Hs : (1 - u) * x <= s <= (1 + u) * x) by lra.
  assert (HSx : (1 - 3 * u) * x <= S <= (1 + 3 * u) * x) by (split; nra).
  assert (HS0 : 0 < S) by nra; split; [assumption|].
  assert (Hxh : x <= h) by (unfold x; rewrite <- (sqrt_square h) by lra; apply sqrt_le_1_alt; nra).
  split; [nra|].
  assert (H3 : Rabs (X - d) / x <= 3 / 2 * (e * h / S)).
  { apply Rle_trans with (e * h / x); [apply Rmult_le_compat_r; [apply Rlt_le, Rinv_0_lt_compat|]; assumption|].
    replace (3 / 2 * (e * h / S)) with (e * h * (3 / 2 * / S)) by (unfold Rdiv; ring).
    apply Rmult_le_compat_l; [nra|]; apply Rmult_le_reg_r with (x * S); [nra|].
    replace (/ x * (x * S)) with S by (field; lra); replace (3 / 2 * / S * (x * S)) with (3 / 2 * x) by (field; lra);
      nra. }
  assert (0 < e * h / S) by (apply Rdiv_lt_0_compat; [nra | assumption]).
  replace (S - sqrt d) with ((S - x) + (x - sqrt d)) by ring.
  apply Rle_trans with (1 := Rabs_triang _ _); assert (Rabs (S - x) <= 3 * u * S) by (apply Rabs_le; nra); lra.
Qed.

(** A quotient of two numbers known to their errors, as a root is computed: within [quotient_error] of the exact one, if
    nothing underflows. The factor widen is 1.0000001 in the code. *)
Definition quotient_error (widen x_error y y_error t : R) : R :=
  rnd (rnd (rnd (rnd (x_error + rnd (Rabs t * y_error)) / rnd (Rabs y - y_error)) * widen)
       + rnd (bpow radix2 (-51) * Rabs t)).

Definition quotient_normal (widen x_fl x_error y_fl y_error : R) : Prop :=
  let t := rnd (x_fl / y_fl) in
  let top := rnd (x_error + rnd (Rabs t * y_error)) in
  let bottom := rnd (Rabs y_fl - y_error) in
  normal (x_fl / y_fl) /\ normal (Rabs t * y_error) /\ normal (top / bottom) /\ normal (rnd (top / bottom) * widen) /\
  normal (bpow radix2 (-51) * Rabs t).

Theorem quotient_bound widen x x_fl x_error y y_fl y_error :
  1 + bpow radix2 (-24) <= widen <= 2 -> format x_error -> format y_fl -> format y_error ->
  Rabs (x_fl - x) <= x_error -> Rabs (y_fl - y) <= y_error -> 2 * y_error < Rabs y_fl ->
  quotient_normal widen x_fl x_error y_fl y_error ->
  Rabs (rnd (x_fl / y_fl) - x / y) <= quotient_error widen x_error y_fl y_error (rnd (x_fl / y_fl)).
Proof.
  intros Hw Fx Fy Fye Hx Hy Hbig; unfold quotient_normal; set (t := rnd (x_fl / y_fl)).
  set (top := rnd (x_error + rnd (Rabs t * y_error))); set (bottom := rnd (Rabs y_fl - y_error)).
  intros (N1 & N2 & N3 & N4 & N5); pose proof u_bounds as Hu.
  assert (Hx0 : 0 <= x_error) by (apply Rle_trans with (2 := Hx), Rabs_pos).
  assert (Hy0 : 0 <= y_error) by (apply Rle_trans with (2 := Hy), Rabs_pos).
  assert (Hw24 : 1 + / 16777216 <= widen) by (replace (/ 16777216) with (bpow radix2 (-24)) by reflexivity; lra).
  set (T := x_fl / y_fl) in *; set (g := Rabs y_fl - y_error) in *; pose proof (Rabs_pos t); pose proof (Rabs_pos T).
  assert (Hy_fl : y_fl <> 0) by (intros Z0; rewrite Z0, Rabs_R0 in Hbig; lra).
  assert (Hgy : g <= Rabs y) by (unfold g; pose proof (Rabs_triang_inv y_fl (y_fl - y)) as Ht;
    replace (y_fl - (y_fl - y)) with y in Ht by ring; lra).
  assert (Hg : 0 < g) by (unfold g; lra).
  assert (Hy1 : y <> 0) by (intros Z0; rewrite Z0, Rabs_R0 in Hgy; lra).
  pose proof (rnd_rel T N1) as Ht; fold t in Ht; apply Rabs_le_inv in Ht as Ht'.
  assert (HuT : u * Rabs T <= / 1000000000000 * Rabs T) by (apply Rmult_le_compat_r; lra).
  assert (HT : Rabs T <= (1 + 2 / 1000000000000) * Rabs t).
  { replace T with (t - (t - T)) at 1 by ring; pose proof (Rabs_triang t (- (t - T))) as Htr.
    rewrite Rabs_Ropp in Htr; replace (t + - (t - T)) with T in Htr by ring; replace (t - (t - T)) with T by ring;
      lra. }
  (* The exact error of the quotient. *)
  set (W := (x_error + Rabs t * y_error) / g).
  assert (HW0 : 0 <= W).
  { apply Rmult_le_pos; [|now apply Rlt_le, Rinv_0_lt_compat];
    pose proof (Rmult_le_pos (Rabs t) y_error ltac:(lra) Hy0); lra. }
  assert (Hexact : Rabs (T - x / y) <= (1 + 2 / 1000000000000) * W).
  { replace (T - x / y) with (((x_fl - x) + T * (y - y_fl)) / y) by (unfold T; field; auto).
    unfold Rdiv at 1; rewrite Rabs_mult, Rabs_inv.
    assert (Hn : Rabs (x_fl - x + T * (y - y_fl)) <= (1 + 2 / 1000000000000) * (x_error + Rabs t * y_error)).
    { apply Rle_trans with (1 := Rabs_triang _ _); rewrite Rabs_mult, (Rabs_minus_sym y y_fl).
      assert (Rabs T * Rabs (y_fl - y) <= (1 + 2 / 1000000000000) * Rabs t * y_error)
        by (apply Rmult_le_compat; auto using Rabs_pos); lra. }
    apply Rle_trans with ((1 + 2 / 1000000000000) * (x_error + Rabs t * y_error) * / g); [|unfold W; right;
      unfold Rdiv; ring].
    apply Rmult_le_compat; auto using Rabs_pos; [apply Rlt_le, Rinv_0_lt_compat; lra | apply Rinv_le; lra]. }
  (* The computed one is no less. *)
  assert (Hlow : forall z, 0 <= z -> Rabs (rnd z - z) <= u * Rabs z -> (1 - / 1000000000000) * z <= rnd z).
  { intros z Hz Hrz; rewrite (Rabs_pos_eq z Hz) in Hrz; apply Rabs_le_inv in Hrz.
    assert (u * z <= / 1000000000000 * z) by (apply Rmult_le_compat_r; lra); lra. }
  assert (Hty : 0 <= Rabs t * y_error) by (apply Rmult_le_pos; lra).
  pose proof (Hlow _ Hty (rnd_rel _ N2)) as E1.
  pose proof (Hlow (x_error + rnd (Rabs t * y_error)) ltac:(lra) (rnd_plus _ _ Fx (format_rnd _))) as E2;
    fold top in E2.
  pose proof (rnd_plus (Rabs y_fl) (- y_error) (generic_format_abs _ _ _ Fy) (generic_format_opp _ _ _ Fye)) as E3.
  fold g in E3; fold (Rabs y_fl - y_error) in E3; fold g bottom in E3; rewrite (Rabs_pos_eq g) in E3 by lra.
  apply Rabs_le_inv in E3; assert (Hug : u * g <= / 1000000000000 * g) by (apply Rmult_le_compat_r; lra).
  assert (Hbottom : 0 < bottom <= (1 + / 1000000000000) * g) by lra.
  assert (Htop : (1 - 2 / 1000000000000) * (x_error + Rabs t * y_error) <= top) by lra.
  assert (Hdiv : (1 - 4 / 1000000000000) * W <= top / bottom).
  { apply Rmult_le_reg_r with bottom; [lra|]; replace (top / bottom * bottom) with top by (field; lra).
    apply Rle_trans with (2 := Htop).
    apply Rle_trans with ((1 - 4 / 1000000000000) * W * ((1 + / 1000000000000) * g)); [apply Rmult_le_compat_l; lra|].
    assert (HWg : W * g = x_error + Rabs t * y_error) by (unfold W; field; lra).
    replace ((1 - 4 / 1000000000000) * W * ((1 + / 1000000000000) * g))
      with ((1 - 4 / 1000000000000) * (1 + / 1000000000000) * (W * g)) by ring; rewrite HWg; lra. }
  pose proof (Hlow (top / bottom) ltac:(lra) (rnd_rel _ N3)) as E4.
  assert (Hwide : (1 + / 16777216) * ((1 - 6 / 1000000000000) * W) <= rnd (top / bottom) * widen).
  { rewrite (Rmult_comm (1 + / 16777216)); apply Rmult_le_compat; lra. }
  pose proof (Hlow (rnd (top / bottom) * widen) ltac:(lra) (rnd_rel _ N4)) as E5.
  assert (H51 : bpow radix2 (-51) = 4 * u) by (replace 4 with (bpow radix2 2) by reflexivity; now rewrite <- bpow_plus).
  assert (0 <= u * Rabs t) by (apply Rmult_le_pos; lra).
  pose proof (Hlow (bpow radix2 (-51) * Rabs t) ltac:(rewrite H51; lra) (rnd_rel _ N5)) as E6; rewrite H51 in E6 at 1.
  unfold quotient_error; fold top; fold g; fold bottom.
  pose proof (Hlow (rnd (rnd (top / bottom) * widen) + rnd (bpow radix2 (-51) * Rabs t)) ltac:(lra)
    (rnd_plus _ _ (format_rnd _) (format_rnd _))) as E7.
  apply Rle_trans with (2 := E7); replace (t - x / y) with ((t - T) + (T - x / y)) by ring.
  apply Rle_trans with (1 := Rabs_triang _ _).
  assert (u * Rabs T <= u * ((1 + 2 / 1000000000000) * Rabs t)) by (apply Rmult_le_compat_l; lra); lra.
Qed.

Section Sphere.

Variables p v centro : vec.
Variable r : R.
Hypothesis p_ordinary : ordinary_vec p.
Hypothesis v_ordinary : ordinary_vec v.
Hypothesis centro_ordinary : ordinary_vec centro.
Hypothesis r_ordinary : ordinary r.
Hypothesis r_positive : 0 < r.
Hypothesis v_not_zero : 0 < norm v.

Let q := minus p centro.
Let A := dot v v.
Let B := dot q v.
Let C := dot q q - r * r.
Let D := B * B - A * C.
Let F := r * norm v - norm (cross q v).
Let H := r * norm v + norm (cross q v).
Let V := extent v.
Let E := extent q + r.

Definition q_fl : vec := minus_fl p centro.
Definition A_fl : R := dot_fl v v.
Definition B_fl : R := dot_fl q_fl v.
Definition C_fl : R := rnd (dot_fl q_fl q_fl - rnd (r * r)).
Definition of_surface : R := rnd (r * norm_fl v).
Definition of_line : R := norm_fl (cross_fl q_fl v).
Definition F_fl : R := rnd (of_surface - of_line).
Definition H_fl : R := rnd (of_surface + of_line).
Definition V_fl : R := extent_fl v.
Definition E_fl : R := rnd (extent_fl q_fl + r).
Definition A_error : R := rnd (rnd (bpow radix2 (-47) * V_fl) * V_fl).
Definition B_error : R := rnd (rnd (bpow radix2 (-47) * V_fl) * E_fl).
Definition C_error : R := rnd (rnd (bpow radix2 (-47) * E_fl) * E_fl).

Lemma ordinary_grid x : ordinary x -> format x /\ grid (-152) x.
Proof. intros [Fx Hx]; split; [assumption | now apply (format_grid (-100))]. Qed.

Lemma ordinary_on_grid a : ordinary_vec a -> on_grid (-152) a.
Proof. intros (X & Y & Z); apply ordinary_grid in X, Y, Z; unfold on_grid; tauto. Qed.

Lemma q_close : close 1 (-152) q_fl q.
Proof.
  pose proof (ordinary_on_grid _ p_ordinary) as (? & ? & ? & ? & ? & ?).
  pose proof (ordinary_on_grid _ centro_ordinary) as (? & ? & ? & ? & ? & ?).
  split; [|split]; apply computed_difference; auto; lia.
Qed.

Lemma v_close : close 0 (-152) v v.
Proof. now apply close_exact, ordinary_on_grid. Qed.

Lemma r_computed : computed 0 (-152) r r r.
Proof.
  destruct (ordinary_grid r r_ordinary) as [Fr Gr]; rewrite <- (Rabs_pos_eq r) at 3 by lra; now apply computed_exact.
Qed.

Lemma V_positive : 0 < V.
Proof. apply Rlt_le_trans with (1 := v_not_zero), norm_le_extent. Qed.

Lemma E_positive : r <= E.
Proof. unfold E; pose proof (extent_nonneg q); lra. Qed.

Lemma V_computed : computed 2 (-152) V_fl V V.
Proof. apply (extent_computed 0); [lia | exact v_close]. Qed.

Lemma E_computed : computed 4 (-152) E_fl E E.
Proof.
  apply computed_plus; [lia | apply (extent_computed 1); [lia | exact q_close] | apply (computed_more 0);
    [lia | exact r_computed]].
Qed.

Lemma unit_computed : computed 0 (-47) (bpow radix2 (-47)) (64 * u) (64 * u).
Proof.
  replace (64 * u) with (bpow radix2 (-47)) by (replace 64 with (bpow radix2 6) by reflexivity;
    now rewrite <- bpow_plus).
  rewrite <- (Rabs_pos_eq (bpow radix2 (-47))) at 3 by apply bpow_ge_0; apply computed_exact.
  - apply generic_format_bpow; unfold FLT_exp; lia.
  - exists 1%Z; ring.
Qed.

(** The computed bounds are at least 63 of their 64 units. *)
Lemma error_bound m k x x_fl y y_fl : computed 4 (-152) x_fl x x -> computed 4 (-152) y_fl y y -> 0 <= x -> 0 <= y ->
  m = rnd (rnd (bpow radix2 (-47) * x_fl) * y_fl) -> k = 64 * u * x * y ->
  63 / 64 * k <= m /\ computed 10 (-351) m k k.
Proof.
  intros Hx Hy Hx0 Hy0 -> ->.
  assert (Hc : computed 10 (-351) (rnd (rnd (bpow radix2 (-47) * x_fl) * y_fl)) (64 * u * x * y) (64 * u * x * y)).
  { apply (computed_mult 5 4 (-199) (-152)); [lia | | assumption].
    apply (computed_mult 0 4 (-47) (-152)); [lia | exact unit_computed | assumption]. }
  split; [|exact Hc]; pose proof (computed_error 10 _ _ _ _ ltac:(lia) Hc) as He; simpl INR in He.
  apply Rabs_le_inv in He; pose proof u_bounds.
  assert (0 <= 64 * u * x * y) by (repeat apply Rmult_le_pos; lra); nra.
Qed.

(** ** A, B and C *)

Theorem A_bound : Rabs (A_fl - A) <= A_error.
Proof.
  pose proof V_positive; pose proof u_bounds.
  destruct (error_bound A_error (64 * u * V * V) V V_fl V V_fl) as [Hm _]; auto; try lra;
    try (apply (computed_more 2); [lia | exact V_computed]).
  pose proof (dot_computed 0 0 (-152) (-152) v v v v ltac:(lia) v_close v_close) as Hc.
  pose proof (computed_error 3 _ _ _ _ ltac:(lia) Hc) as He; simpl INR in He.
  apply Rle_trans with (1 := He); pose proof (size_of_dot_le v v : _ <= V * V).
  assert (0 <= u * (V * V)) by (repeat apply Rmult_le_pos; lra).
  assert (u * size_of_dot v v <= u * (V * V)) by (apply Rmult_le_compat_l; lra); lra.
Qed.

Theorem B_bound : Rabs (B_fl - B) <= 8 * u * (V * E) <= B_error.
Proof.
  pose proof V_positive; pose proof E_positive; pose proof u_bounds; pose proof (extent_nonneg q).
  destruct (error_bound B_error (64 * u * V * E) V V_fl E E_fl) as [Hm _]; auto; try lra;
    try (apply (computed_more 2); [lia | exact V_computed]); try exact E_computed.
  pose proof (dot_computed 1 0 (-152) (-152) q_fl v q v ltac:(lia) q_close v_close) as Hc.
  pose proof (computed_error 4 _ _ _ _ ltac:(lia) Hc) as He; simpl INR in He;
    pose proof (size_of_dot_le q v : _ <= extent q * V).
  assert (size_of_dot q v <= V * E) by (unfold E; nra).
  assert (0 <= u * (V * E)) by (repeat apply Rmult_le_pos; lra).
  assert (u * size_of_dot q v <= u * (V * E)) by (apply Rmult_le_compat_l; lra).
  split; [apply Rle_trans with (1 := He) |]; lra.
Qed.

Theorem C_bound : Rabs (C_fl - C) <= C_error.
Proof.
  pose proof E_positive; pose proof u_bounds; pose proof (extent_nonneg q).
  destruct (error_bound C_error (64 * u * E * E) E E_fl E E_fl) as [Hm _]; auto; try lra; try exact E_computed.
  pose proof (dot_computed 1 1 (-152) (-152) q_fl q_fl q q ltac:(lia) q_close q_close) as Hc.
  pose proof (computed_mult 0 0 (-152) (-152) _ _ _ _ _ _ ltac:(lia) r_computed r_computed) as Hr.
  pose proof (computed_minus 5 (-304) _ _ _ _ _ _ ltac:(lia) Hc (computed_more 1 5 (-304) _ _ _ ltac:(lia) Hr)) as Hd.
  pose proof (computed_error 6 _ _ _ _ ltac:(lia) Hd) as He; simpl INR in He.
  apply Rle_trans with (1 := He); pose proof (size_of_dot_le q q).
  assert (size_of_dot q q + r * r <= E * E) by (unfold E; nra).
  assert (0 <= u * (E * E)) by (repeat apply Rmult_le_pos; lra).
  assert (u * (size_of_dot q q + r * r) <= u * (E * E)) by (apply Rmult_le_compat_l; lra); lra.
Qed.

(** ** The discriminant *)

Lemma cross_computed : on_grid (-304) (cross_fl q_fl v) /\
  extent (minus (cross_fl q_fl v) (cross q v)) <= 6 * u * (extent q * V).
Proof.
  destruct q_close as (Qx & Qy & Qz), v_close as (Vx & Vy & Vz); pose proof u_bounds.
  assert (Hone : forall a b a' b' x y x' y' m n m' n',
    computed 1 (-152) a x m -> computed 0 (-152) b y n -> computed 1 (-152) a' x' m' -> computed 0 (-152) b' y' n' ->
    computed 3 (-304) (rnd (rnd (a * b) - rnd (a' * b'))) (x * y - x' * y') (m * n + m' * n')).
  { intros; apply (computed_minus 2 (-304)); [lia | |]; apply (computed_mult 1 0 (-152) (-152)); auto; lia. }
  pose proof (Hone _ _ _ _ _ _ _ _ _ _ _ _ Qy Vz Qz Vy) as X.
  pose proof (Hone _ _ _ _ _ _ _ _ _ _ _ _ Qz Vx Qx Vz) as Y.
  pose proof (Hone _ _ _ _ _ _ _ _ _ _ _ _ Qx Vy Qy Vx) as Z.
  split; [destruct X as (_ & ? & ?), Y as (_ & ? & ?), Z as (_ & ? & ?); repeat split; assumption|].
  apply (computed_error 3 _ _ _ _ ltac:(lia)) in X, Y, Z; simpl INR in X, Y, Z.
  unfold extent at 1, minus; simpl; apply Rle_trans with (1 := Rplus_le_compat _ _ _ _ (Rplus_le_compat _ _ _ _ X Y) Z).
  unfold V, extent; pose proof (Rabs_pos (cx q)); pose proof (Rabs_pos (cy q)); pose proof (Rabs_pos (cz q)).
  pose proof (Rabs_pos (cx v)); pose proof (Rabs_pos (cy v)); pose proof (Rabs_pos (cz v)).
  match goal with |- ?a <= 6 * u * ?b => replace a with (6 * u * (b - Rabs (cx q) * Rabs (cx v)
    - Rabs (cy q) * Rabs (cy v) - Rabs (cz q) * Rabs (cz v))) by ring end.
  apply Rmult_le_compat_l; [lra | nra].
Qed.

Lemma cross_norm : norm (cross q v) <= extent q * V.
Proof.
  assert (norm (cross q v) * norm (cross q v) <= (norm q * norm v) * (norm q * norm v)).
  { replace (norm q * norm v * (norm q * norm v)) with (norm q * norm q * (norm v * norm v)) by ring.
    rewrite !norm_square; replace (dot q q * dot v v) with (dot (cross q v) (cross q v) + dot q v * dot q v)
      by (unfold dot, cross; simpl; ring).
    pose proof (Rle_0_sqr (dot q v)) as Hs; unfold Rsqr in Hs; lra. }
  apply Rle_trans with (norm q * norm v).
  - apply Rnot_lt_le; intros Hlt.
    pose proof (Rmult_le_pos _ _ (norm_nonneg q) (norm_nonneg v)); nra.
  - apply Rmult_le_compat; try apply norm_nonneg; apply norm_le_extent.
Qed.

(** What F and H are the difference and the sum of: the distances of the surface and of the line, times |v|. *)
Lemma of_line_bound : Rabs (of_line - norm (cross q v)) <= 15 * u * (extent q * V) /\
  (of_line = 0 \/ bpow radix2 (-304) <= of_line).
Proof.
  destruct cross_computed as [HG He]; pose proof u_bounds; pose proof cross_norm as Hn.
  destruct (norm_computed (-304) _ ltac:(lia) HG) as [Hl Hlow]; fold of_line in *; split; [|assumption].
  pose proof (norm_lipschitz (cross_fl q_fl v) (cross q v)) as Hd; pose proof (norm_nonneg (cross_fl q_fl v)).
  pose proof (Rmult_le_pos _ _ (extent_nonneg q) (Rlt_le _ _ V_positive)) as HQV.
  assert (u * (extent q * V) <= / 1000000 * (extent q * V)) by (apply Rmult_le_compat_r; lra).
  apply Rabs_le_inv in Hd; assert (norm (cross_fl q_fl v) <= (1 + 6 * / 1000000) * (extent q * V)) by lra.
  assert (u * norm (cross_fl q_fl v) <= u * ((1 + 6 * / 1000000) * (extent q * V))) by (apply Rmult_le_compat_l; lra).
  apply Rabs_le_inv in Hl; apply Rabs_le; lra.
Qed.

Lemma r_least : bpow radix2 (-100) <= r.
Proof. destruct r_ordinary as [_ [H0|H0]]; [lra | now rewrite Rabs_pos_eq in H0 by lra]. Qed.

Lemma of_surface_bound : Rabs (of_surface - r * norm v) <= 10 * u * (r * V) /\
  (of_surface = 0 \/ bpow radix2 (-404) <= of_surface) /\ 0 < of_surface.
Proof.
  pose proof u_bounds; pose proof r_least as Hr; pose proof (norm_le_extent v : _ <= V) as Hv.
  destruct (norm_computed (-152) v ltac:(lia) (ordinary_on_grid v v_ordinary)) as [Hl Hlow].
  assert (Hpos : bpow radix2 (-152) <= norm_fl v).
  { destruct Hlow as [Z0|?]; [exfalso; rewrite Z0 in Hl; apply Rabs_le_inv in Hl; nra | assumption]. }
  pose proof (bpow_gt_0 radix2 (-152)); pose proof (bpow_gt_0 radix2 (-100)).
  assert (Hprod : bpow radix2 (-252) <= r * norm_fl v).
  { change (-252)%Z with (-100 + -152)%Z; rewrite bpow_plus; apply Rmult_le_compat; lra. }
  pose proof (bpow_gt_0 radix2 (-252)).
  assert (Hrnd : Rabs (of_surface - r * norm_fl v) <= u * (r * norm_fl v)).
  { rewrite <- (Rabs_pos_eq (r * norm_fl v)) at 2 by lra; apply rnd_rel; right; rewrite Rabs_pos_eq by lra.
    apply Rle_trans with (2 := Hprod), bpow_le; lia. }
  assert (Hlow404 : bpow radix2 (-404) <= of_surface).
  { replace (bpow radix2 (-404)) with (rnd (bpow radix2 (-404))).
    - apply rnd_le, Rle_trans with (2 := Hprod), bpow_le; lia.
    - apply round_generic; [auto with typeclass_instances | apply generic_format_bpow; unfold FLT_exp; lia]. }
  split; [|split; [now right | pose proof (bpow_gt_0 radix2 (-404)); lra]].
  assert (Hl2 : Rabs (r * norm_fl v - r * norm v) <= r * (8 * u * norm v)).
  { rewrite <- Rmult_minus_distr_l, Rabs_mult, (Rabs_pos_eq r) by lra; apply Rmult_le_compat_l; lra. }
  pose proof (Rmult_le_compat_l r _ _ (Rlt_le _ _ r_positive) Hv) as Hrv; pose proof V_positive.
  apply Rabs_le_inv in Hrnd, Hl2; pose proof (Rmult_le_pos r (norm v) ltac:(lra) (norm_nonneg v)).
  assert (r * (8 * u * norm v) <= 8 * u * (r * V)) by nra.
  assert (u * (r * norm_fl v) <= u * (2 * (r * V))) by (apply Rmult_le_compat_l; [lra | nra]).
  apply Rabs_le; lra.
Qed.

Lemma F_H_bound : Rabs (F_fl - F) <= 18 * u * (V * E) /\ Rabs (H_fl - H) <= 18 * u * (V * E).
Proof.
  destruct of_line_bound as [Hl _], of_surface_bound as [Hs _]; pose proof u_bounds; pose proof V_positive.
  pose proof (extent_nonneg q); pose proof cross_norm; pose proof (norm_nonneg (cross q v)).
  pose proof (Rmult_le_compat_l r _ _ (Rlt_le _ _ r_positive) (norm_le_extent v : _ <= V)) as Hrv.
  assert (0 <= r * norm v) by (apply Rmult_le_pos; lra).
  assert (HVE : V * E = r * V + extent q * V) by (unfold E; ring); set (W := V * E) in *.
  assert (0 <= r * V) by (apply Rmult_le_pos; lra); assert (0 <= extent q * V) by (apply Rmult_le_pos; lra).
  assert (u * W <= / 1000000 * W) by (apply Rmult_le_compat_r; lra).
  assert (Hf1 : format of_surface) by apply format_rnd; assert (Hf2 : format of_line) by apply format_rnd.
  pose proof (rnd_plus of_surface (- of_line) Hf1 (generic_format_opp _ _ _ Hf2)) as HF.
  pose proof (rnd_plus of_surface of_line Hf1 Hf2) as HH; fold H_fl in HH; fold (of_surface - of_line) in HF;
    fold F_fl in HF.
  assert (Hsize : forall x, - (2 * W) <= x <= 2 * W -> u * Rabs x <= 2 * u * W).
  { intros x Hx; replace (2 * u * W) with (u * (2 * W)) by ring; apply Rmult_le_compat_l; [lra | now apply Rabs_le]. }
  apply Rabs_le_inv in Hl, Hs.
  pose proof (Hsize (of_surface - of_line) ltac:(split; nra)); pose proof (Hsize (of_surface + of_line) ltac:(split;
    nra)).
  apply Rabs_le_inv in HF, HH; unfold F, H; split; apply Rabs_le; nra.
Qed.

(** Lagrange's identity. *)
Lemma D_product : D = F * H.
Proof.
  unfold D, F, H, A, B, C; replace ((r * norm v - norm (cross q v)) * (r * norm v + norm (cross q v)))
    with (r * r * (norm v * norm v) - norm (cross q v) * norm (cross q v)) by ring.
  rewrite !norm_square; unfold dot, cross; simpl; ring.
Qed.

Lemma H_positive : 0 < H.
Proof. unfold H; pose proof (norm_nonneg (cross q v)); assert (0 < r * norm v) by (apply Rmult_lt_0_compat; lra);
  lra. Qed.

(** 63 of the 64 units of B_error, of which F and H use 18. *)
Lemma B_error_bound : 63 * u * (V * E) <= B_error /\ 0 < u * (V * E) /\ format B_error /\ grid (-351) B_error.
Proof.
  pose proof V_positive; pose proof E_positive; pose proof u_bounds.
  destruct (error_bound B_error (64 * u * V * E) V V_fl E E_fl) as (Hm & _ & ? & ?); auto; try lra;
    try (apply (computed_more 2); [lia | exact V_computed]); try exact E_computed.
  split; [lra | split; [|now split]]; apply Rmult_lt_0_compat; [lra | apply Rmult_lt_0_compat; lra].
Qed.

(** First decision: the line misses the sphere. *)
Theorem triage_miss t : F_fl < - B_error -> A * t * t + 2 * B * t + C <> 0.
Proof.
  intros HF Ht; destruct F_H_bound as [Hb _], B_error_bound as (He & Hp & _); apply Rabs_le_inv in Hb.
  pose proof H_positive; assert (D < 0) by (rewrite D_product; nra).
  pose proof (Rle_0_sqr (A * t + B)) as Hs; unfold Rsqr in Hs.
  replace ((A * t + B) * (A * t + B)) with (A * (A * t * t + 2 * B * t + C) + D) in Hs by (unfold D; ring).
  rewrite Ht in Hs; lra.
Qed.

Definition S_fl : R := rnd (sqrt (rnd (F_fl * H_fl))).
Definition S_error : R :=
  rnd (rnd (rnd (rnd (3 * B_error) * H_fl) / S_fl) + rnd (bpow radix2 (-51) * S_fl)).

(** Second decision: the line meets the sphere twice, and S is the root of the discriminant up to S_error. *)
Theorem triage_meets : B_error < F_fl ->
  0 < D /\ bpow radix2 (-351) <= S_fl /\ Rabs (S_fl - sqrt D) <= 9 / 10 * S_error /\ 0 <= S_error.
Proof.
  intros HF; destruct F_H_bound as [HbF HbH], B_error_bound as (He & Hp & Fe & Ge); pose proof H_positive;
    pose proof u_bounds.
  apply Rabs_le_inv in HbF, HbH; destruct of_line_bound as [_ Hline].
  assert (HFH : F_fl <= H_fl).
  { apply rnd_le; pose proof (bpow_gt_0 radix2 (-304)); destruct Hline as [->|]; lra. }
  assert (HD : 0 < D) by (rewrite D_product; apply Rmult_lt_0_compat; lra); split; [assumption|].
  assert (HX : Rabs (F_fl * H_fl - D) <= B_error * H_fl).
  { rewrite D_product; replace (F_fl * H_fl - F * H) with (F_fl * (H_fl - H) + H * (F_fl - F)) by ring.
    assert (Hm : forall a b c, 0 <= a -> - c <= b <= c -> - (a * c) <= a * b <= a * c) by (intros; split; nra).
    pose proof (Hm F_fl (H_fl - H) (18 * u * (V * E)) ltac:(lra) HbH).
    pose proof (Hm H (F_fl - F) (18 * u * (V * E)) ltac:(lra) HbF).
    assert (F_fl * (18 * u * (V * E)) <= H_fl * (18 * u * (V * E))) by (apply Rmult_le_compat_r; lra).
    assert (H * (18 * u * (V * E)) <= 2 * H_fl * (18 * u * (V * E))) by (apply Rmult_le_compat_r; lra).
    assert (63 * u * (V * E) * H_fl <= B_error * H_fl) by (apply Rmult_le_compat_r; lra).
    apply Rabs_le; split; lra. }
  assert (He351 : bpow radix2 (-351) <= B_error).
  { destruct Ge as [m Hm]; rewrite Hm, <- (Rmult_1_l (bpow radix2 (-351))) at 1.
    apply Rmult_le_compat_r; [apply bpow_ge_0 | apply IZR_le].
    enough (0 < m)%Z by lia; apply lt_IZR; pose proof (bpow_gt_0 radix2 (-351)); nra. }
  pose proof (bpow_gt_0 radix2 (-351)) as H351.
  assert (Hnormal : forall x, bpow radix2 (-702) <= x -> Rabs (rnd x - x) <= u * x).
  { intros x Hx; pose proof (bpow_gt_0 radix2 (-702)); rewrite <- (Rabs_pos_eq x) at 3 by lra; apply rnd_rel; right.
    rewrite Rabs_pos_eq by lra; apply Rle_trans with (2 := Hx), bpow_le; lia. }
  assert (Hsq : forall x y, bpow radix2 (-351) <= x -> bpow radix2 (-351) <= y -> bpow radix2 (-702) <= x * y).
  { intros x y Hx Hy; change (-702)%Z with (-351 + -351)%Z; rewrite bpow_plus; apply Rmult_le_compat; lra. }
  assert (Hmore : forall x, bpow radix2 (-351) <= x -> bpow radix2 (-702) <= x).
  { intros x Hx; apply Rle_trans with (2 := Hx), bpow_le; lia. }
  pose proof (Hnormal _ (Hsq F_fl H_fl ltac:(lra) ltac:(lra))) as HP.
  assert (HP0 : bpow radix2 (-702) <= rnd (F_fl * H_fl)).
  { replace (bpow radix2 (-702)) with (rnd (bpow radix2 (-702))); [apply rnd_le, Hsq; lra|].
    apply round_generic; [auto with typeclass_instances | apply generic_format_bpow; unfold FLT_exp; lia]. }
  assert (Hroot : bpow radix2 (-351) <= sqrt (rnd (F_fl * H_fl))).
  { rewrite <- (sqrt_square (bpow radix2 (-351))) by lra; apply sqrt_le_1_alt; now rewrite <- bpow_plus. }
  pose proof (Hnormal _ (Hmore _ Hroot)) as HS.
  destruct (root_of_product B_error F_fl H_fl D _ _ _ ltac:(lra) ltac:(lra) HF HFH eq_refl HX HP HS) as (HS0 & HSh & Hb).
  fold S_fl in *.
  assert (Hlow : forall x, bpow radix2 (-702) <= x -> (1 - / 1000000) * x <= rnd x).
  { intros x Hx; pose proof (Hnormal x Hx) as Hr; apply Rabs_le_inv in Hr; pose proof (bpow_gt_0 radix2 (-702)).
    assert (u * x <= / 1000000 * x) by (apply Rmult_le_compat_r; lra); lra. }
  unfold S_error.
  pose proof (Hlow (3 * B_error) (Hmore (3 * B_error) ltac:(lra))) as E1; set (e1 := rnd (3 * B_error)) in *.
  assert (Hbig : 2.9 * B_error <= e1) by lra.
  pose proof (Hlow (e1 * H_fl) (Hsq e1 H_fl ltac:(lra) ltac:(lra))) as E2; set (e2 := rnd (e1 * H_fl)) in *.
  assert (Hbig2 : 2.8 * (B_error * H_fl) <= e2).
  { assert (2.9 * B_error * H_fl <= e1 * H_fl) by (apply Rmult_le_compat_r; lra).
    assert (0 < B_error * H_fl) by (apply Rmult_lt_0_compat; lra); lra. }
  assert (HeS : 2.8 * (B_error * H_fl / S_fl) <= e2 / S_fl).
  { unfold Rdiv; rewrite <- !Rmult_assoc; apply Rmult_le_compat_r; [apply Rlt_le, Rinv_0_lt_compat, HS0 | lra]. }
  assert (Hquo : B_error <= 2 * (B_error * H_fl / S_fl)).
  { apply Rmult_le_reg_r with S_fl; [assumption|];
    replace (2 * (B_error * H_fl / S_fl) * S_fl) with (B_error * (2 * H_fl))
      by (field; lra); apply Rmult_le_compat_l; lra. }
  pose proof (Hlow (e2 / S_fl) (Hmore (e2 / S_fl) ltac:(lra))) as E3; set (e3 := rnd (e2 / S_fl)) in *.
  assert (HS351 : bpow radix2 (-351) <= S_fl).
  { replace (bpow radix2 (-351)) with (rnd (bpow radix2 (-351))); [now apply rnd_le|].
    apply round_generic; [auto with typeclass_instances | apply generic_format_bpow; unfold FLT_exp; lia]. }
  assert (H51 : bpow radix2 (-51) = 4 * u) by (replace 4 with (bpow radix2 2) by reflexivity; now rewrite <- bpow_plus).
  assert (H4u : bpow radix2 (-702) <= bpow radix2 (-51) * S_fl).
  { apply Rle_trans with (bpow radix2 (-51) * bpow radix2 (-351)); [rewrite <- bpow_plus; apply bpow_le; lia|].
    apply Rmult_le_compat_l; [apply bpow_ge_0 | assumption]. }
  pose proof (Hlow _ H4u) as E4; rewrite H51 in E4 at 1; set (e4 := rnd (bpow radix2 (-51) * S_fl)) in *.
  set (y := B_error * H_fl / S_fl) in *.
  assert (0 < u * S_fl) by (apply Rmult_lt_0_compat; lra).
  assert (Hsum : 2.5 * y + 3.9 * (u * S_fl) <= e3 + e4) by lra.
  pose proof (Hlow (e3 + e4) (Hmore (e3 + e4) ltac:(lra))) as E5.
  split; [assumption|]; split; [apply Rle_trans with (1 := Hb)|]; lra.
Qed.

(** ** The roots *)

Definition q_num : R := - rnd (B_fl + if Rle_dec 0 B_fl then S_fl else - S_fl).
Definition q_error : R := rnd (rnd (B_error + S_error) + rnd (bpow radix2 (-52) * Rabs q_num)).

(** -(B ± √D), with the sign of the computed B. *)
Definition q_exact : R := - (B + if Rle_dec 0 B_fl then sqrt D else - sqrt D).

Theorem q_bound : B_error < F_fl -> Rabs (q_num - q_exact) <= q_error.
Proof.
  intros HF; destruct (triage_meets HF) as (HD & HS351 & HS & HS0), B_bound as [HB _].
  destruct B_error_bound as (He & Hp & Fe & Ge); pose proof u_bounds; pose proof (bpow_gt_0 radix2 (-351)).
  set (s := if Rle_dec 0 B_fl then S_fl else - S_fl) in *.
  assert (FS : format S_fl) by apply format_rnd.
  assert (GS : grid (-403) S_fl) by (apply (format_grid (-351)); [lia | assumption | right;
    now rewrite Rabs_pos_eq by lra]).
  assert (Fs : format s) by (unfold s; destruct Rle_dec; [assumption | now apply generic_format_opp]).
  assert (Gs : grid (-403) s) by (unfold s; destruct Rle_dec; [assumption | now apply grid_opp]).
  destruct (dot_computed 1 0 (-152) (-152) q_fl v q v ltac:(lia) q_close v_close) as (_ & FB & GB).
  fold B_fl in FB, GB; pose proof (rnd_plus B_fl s FB Fs) as Hr.
  assert (Gy : grid (-403) (rnd (B_fl + s))).
  { apply grid_rnd; [lia | apply grid_plus; [now apply (grid_coarser _ (-304)) | assumption]]. }
  unfold q_error, q_num, q_exact; fold s; rewrite Rabs_Ropp; set (y := B_fl + s) in *.
  assert (Hs : Rabs (s - if Rle_dec 0 B_fl then sqrt D else - sqrt D) <= 9 / 10 * S_error).
  { unfold s; destruct Rle_dec; [assumption|]; replace (- S_fl - - sqrt D) with (- (S_fl - sqrt D)) by ring.
    now rewrite Rabs_Ropp. }
  set (e := if Rle_dec 0 B_fl then sqrt D else - sqrt D) in *.
  assert (Hy : u * Rabs y <= 11 / 10 * (u * Rabs (rnd y))).
  { replace y with (rnd y - (rnd y - y)) at 1 by ring; pose proof (Rabs_triang (rnd y) (- (rnd y - y))) as Ht.
    rewrite Rabs_Ropp in Ht; assert (u * Rabs y <= / 1000000000000 * Rabs y) by (apply Rmult_le_compat_r;
      [apply Rabs_pos | lra]).
    pose proof (Rabs_pos y).
    replace (11 / 10 * (u * Rabs (rnd y))) with (u * (11 / 10 * Rabs (rnd y))) by ring; apply Rmult_le_compat_l; [lra|].
    replace (rnd y - (rnd y - y)) with y by ring; replace (rnd y + - (rnd y - y)) with y in Ht by ring; lra. }
  assert (Hlow : forall x, 0 <= x -> Rabs (rnd x - x) <= u * Rabs x -> 99 / 100 * x <= rnd x).
  { intros x Hx Hrx; rewrite (Rabs_pos_eq x Hx) in Hrx; apply Rabs_le_inv in Hrx.
    assert (u * x <= / 1000000000000 * x) by (apply Rmult_le_compat_r; lra); lra. }
  pose proof (Rabs_pos (rnd y)) as Hy0.
  assert (H52 : bpow radix2 (-52) = 2 * u) by (replace 2 with (bpow radix2 1) by reflexivity; now rewrite <- bpow_plus).
  assert (E1 : 99 / 100 * (2 * u * Rabs (rnd y)) <= rnd (bpow radix2 (-52) * Rabs (rnd y))).
  { rewrite <- H52; apply Hlow; [apply Rmult_le_pos; [apply bpow_ge_0 | assumption]|].
    apply rnd_rel, (grid_normal (-52 + -403)); [lia | apply grid_mult; [exists 1%Z; ring | now apply grid_abs]]. }
  assert (FSe : format S_error) by apply format_rnd.
  pose proof (Hlow (B_error + S_error) ltac:(lra) (rnd_plus _ _ Fe FSe)) as E2.
  assert (0 <= u * Rabs (rnd y)) by (apply Rmult_le_pos; lra).
  pose proof (Hlow (rnd (B_error + S_error) + rnd (bpow radix2 (-52) * Rabs (rnd y))) ltac:(lra)
    (rnd_plus _ _ (format_rnd _) (format_rnd _))) as E3.
  apply Rabs_le_inv in HB, Hr, Hs; apply Rabs_le; unfold y in *; lra.
Qed.

(** The exact numerator gives both roots. *)
Theorem q_exact_roots : 0 <= D -> q_exact <> 0 -> 0 < A ->
  (forall t, t = q_exact / A \/ t = C / q_exact -> A * t * t + 2 * B * t + C = 0).
Proof.
  intros HD Hq HA; assert (Hz : q_exact * q_exact + 2 * B * q_exact + A * C = 0).
  { pose proof (sqrt_sqrt D HD) as Hs; unfold q_exact; set (r0 := sqrt D) in *.
    assert (r0 * r0 = B * B - A * C) by (rewrite Hs; reflexivity); destruct Rle_dec; lra. }
  intros t [->| ->].
  - apply Rmult_eq_reg_r with A; [|lra]; rewrite Rmult_0_l, <- Hz; field; lra.
  - apply Rmult_eq_reg_r with (q_exact * q_exact); [|now apply Rmult_integral_contrapositive].
    rewrite Rmult_0_l, <- (Rmult_0_r C), <- Hz; field; assumption.
Qed.

Lemma A_positive : 0 < A.
Proof. unfold A; rewrite <- norm_square; now apply Rmult_lt_0_compat. Qed.

(** Both roots as the triage computes them, each with a bound: from A where A is known not to be small, and from C. *)
Theorem triage_roots widen : 1 + bpow radix2 (-24) <= widen <= 2 -> B_error < F_fl -> 2 * q_error < Rabs q_num ->
  (2 * A_error < Rabs A_fl -> quotient_normal widen q_num q_error A_fl A_error ->
   exists t, A * t * t + 2 * B * t + C = 0 /\
   Rabs (rnd (q_num / A_fl) - t) <= quotient_error widen q_error A_fl A_error (rnd (q_num / A_fl))) /\
  (quotient_normal widen C_fl C_error q_num q_error ->
   exists t, A * t * t + 2 * B * t + C = 0 /\
   Rabs (rnd (C_fl / q_num) - t) <= quotient_error widen C_error q_num q_error (rnd (C_fl / q_num))).
Proof.
  intros Hw HF Hq; pose proof (q_bound HF) as Hqb; destruct (triage_meets HF) as (HD & _).
  assert (Hq0 : q_exact <> 0).
  { intros Z0; rewrite Z0, Rminus_0_r in Hqb; pose proof (Rabs_pos q_num); lra. }
  pose proof (q_exact_roots (Rlt_le _ _ HD) Hq0 A_positive) as Hroots.
  assert (Fq : format q_num) by apply generic_format_opp, format_rnd.
  split; [intros HA Hn; exists (q_exact / A) | intros Hn; exists (C / q_exact)]; (split; [apply Hroots; auto|]);
    apply quotient_bound; first [assumption | apply format_rnd | apply A_bound | apply C_bound].
Qed.

End Sphere.
