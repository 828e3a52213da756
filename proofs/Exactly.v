(** * Exactly: the exact rounding where its quick path is not sure

    round_to_binary64 of src/number/dyadic_surd.cpp, step by step after Quick.v: of (x + y√delta)/w the root is cut to
    more and more bits, until both ends of what that leaves round alike, or to neighbours, between whose middle and the
    number an exact comparison decides. What it says, if it ends, is the number rounded once.

    extended x         == x rounded to the nearest binary64, ties to even, an infinity as ±2^1024
    cut_root m e count == ⌊√(m 2^e)⌋ at some place, of so many bits:  the place, and whether nothing was cut
    nearer             == as there: the nearer of two neighbours, or the even one
    attempt, attempts, exactly == one turn of the loop, the loop up to so many turns, and round_to_binary64 *)
From Coq Require Import Reals ZArith Lra Lia Bool.
From Flocq Require Import Core BinarySingleNaN.
From Durero Require Import Rounding Limits Quick.
Local Open Scope R_scope.

Local Instance prec53 : Prec_gt_0 53 := eq_refl.
Notation beyond := (bpow radix2 1024).
Definition extended (x : R) : R := Rmax (- beyond) (Rmin beyond (rnd x)).

Record root_cut := Root_cut { cut : Z; place : Z; whole : bool }.
Definition cut_root (m e count : Z) : root_cut :=
  let fit := (2 * count - (Z.log2 m + 1))%Z in
  let shift := if Z.odd (e - fit) then (fit + 1)%Z else fit in
  let n := if (0 <=? shift)%Z then (m * 2 ^ shift)%Z else (m / 2 ^ (- shift))%Z in
  let kept := if (0 <=? shift)%Z then true else (m mod 2 ^ (- shift) =? 0)%Z in
  let r := Z.sqrt n in
  Root_cut r ((e - shift) / 2) (kept && (r * r =? n)%Z).

Definition nearer (value low high : R) : R :=
  let middle := (low + high) / 2 in
  match Rcompare value middle with Eq => extended middle | Lt => low | Gt => high end.

Definition attempt (x y w value : R) (root : root_cut) : option R :=
  let first := x + y * (IZR (cut root) * pw (place root)) in
  if whole root then Some (extended (first / w))
  else
    let last := first + y * pw (place root) in
    if Rle_bool (first * last) 0 then None
    else
      let one := extended (first / w) in
      let other := extended (last / w) in
      if Req_bool one other then Some one
      else
        let low := Rmin one other in
        let high := Rmax one other in
        if Req_bool (succ radix2 fexp low) high then Some (nearer value low high) else None.

Fixpoint attempts (turns : nat) (count : Z) (x y w : R) (m e : Z) : option R :=
  match turns with
  | O => None
  | S more =>
      match attempt x y w ((x + y * sqrt (dyadic m e)) / w) (cut_root m e count) with
      | Some out => Some out
      | None => attempts more (2 * count) x y w m e
      end
  end.

Definition exactly (turns : nat) (mx ex my ey md ed mw ew : Z) : option R :=
  let rational := ((my =? 0) || (md =? 0))%Z%bool in
  if rational && (mx =? 0)%Z then Some 0
  else
    match quick extended mx ex my ey md ed mw ew with
    | Some out => Some out
    | None =>
        if rational then Some (extended (dyadic mx ex / dyadic mw ew))
        else attempts turns 128 (dyadic mx ex) (dyadic my ey) (dyadic mw ew) md ed
    end.

(** ** Rounding, infinities included *)

Lemma extended_le a b : a <= b -> extended a <= extended b.
Proof. intros H; apply Rle_max_compat_l, Rle_min_compat_l; now apply rnd_le. Qed.

Lemma format_beyond : format beyond. Proof. now apply format_bpow. Qed.

Lemma extended_range x : - beyond <= extended x <= beyond.
Proof.
  pose proof (bpow_gt_0 radix2 1024); unfold extended; split; [apply Rmax_l|].
  apply Rmax_lub; [lra | apply Rmin_l].
Qed.

Lemma extended_format x : format (extended x).
Proof.
  unfold extended, Rmax, Rmin; repeat destruct Rle_dec; auto using format_rnd, format_beyond, generic_format_opp.
Qed.

Lemma extended_of_bound x c : - beyond <= c <= beyond -> (rnd x <= c -> extended x <= c) /\ (c <= rnd x -> c <= extended x).
Proof. intros H; unfold extended, Rmax, Rmin; repeat destruct Rle_dec; split; lra. Qed.

Lemma nearer_right value low high : format low -> high = succ radix2 fexp low -> - beyond <= low -> high <= beyond ->
  low <= high -> low <= extended value <= high -> nearer value low high = extended value.
Proof.
  intros Fl -> Hl Hh Hlh Hv; assert (Fh : format (succ radix2 fexp low)) by (apply generic_format_succ; auto with typeclass_instances).
  unfold nearer; destruct (Rcompare_spec value ((low + succ radix2 fexp low) / 2)) as [L|E|G].
  - apply Rle_antisym; [apply Hv|]; apply extended_of_bound; [lra|]; apply round_N_le_midp; auto with typeclass_instances.
  - now rewrite <- E.
  - apply Rle_antisym; [|apply Hv]; apply extended_of_bound; [lra|]; apply round_N_ge_midp; auto with typeclass_instances.
    rewrite pred_succ by auto with typeclass_instances; lra.
Qed.

(** ** The root *)

Lemma cut_root_spans m e count : (0 < m)%Z -> let r := cut_root m e count in let d := sqrt (dyadic m e) in
  IZR (cut r) * pw (place r) <= d <= IZR (cut r) * pw (place r) + pw (place r) /\
  (whole r = true -> d = IZR (cut r) * pw (place r)).
Proof.
  intros Hm; unfold cut_root; set (fit := (2 * count - _)%Z); set (shift := if Z.odd (e - fit) then _ else _).
  assert (Hh : exists h, (e - shift = h + h)%Z).
  { unfold shift; destruct (Z.odd (e - fit)) eqn:Od.
    - apply Z.odd_spec in Od as [j Ej]; exists j; lia.
    - assert (Ev : Z.even (e - fit) = true) by (rewrite <- Z.negb_odd, Od; reflexivity).
      apply Z.even_spec in Ev as [j Ej]; exists j; lia. }
  destruct Hh as [h Eh]; replace ((e - shift) / 2)%Z with h by (rewrite Eh; apply Z.div_unique with 0%Z; lia).
  clearbody shift; clear fit; set (n := if (0 <=? shift)%Z then _ else _); set (kept := if (0 <=? shift)%Z then true else _).
  cbv zeta; cbn [cut place whole]; pose proof (bpow_gt_0 radix2 h) as Ph; set (X := IZR m * pw shift).
  assert (HX : 0 < X) by (apply Rmult_lt_0_compat; [now apply IZR_lt | apply bpow_gt_0]).
  assert (Ed : sqrt (dyadic m e) = sqrt X * pw h).
  { unfold dyadic; replace e with (shift + (h + h))%Z by lia; rewrite !bpow_plus, <- Rmult_assoc; fold X.
    rewrite sqrt_mult by first [lra | apply Rmult_le_pos; lra]; now rewrite sqrt_square by lra. }
  assert (Hn : (0 <= n)%Z /\ IZR n <= X < IZR n + 1 /\ (kept = true -> X = IZR n)).
  { unfold n, kept, X; destruct (Z.leb_spec 0 shift) as [Hs|Hs].
    - rewrite mult_IZR, IZR_pow by lia; split; [apply Z.mul_nonneg_nonneg; [lia | apply Z.pow_nonneg; lia]|].
      split; [lra | reflexivity].
    - assert (Hp : (0 < 2 ^ (- shift))%Z) by (apply Z.pow_pos_nonneg; lia); pose proof (divided m _ Hp) as Hd.
      assert (E : IZR m / IZR (2 ^ (- shift)) = IZR m * pw shift).
      { rewrite IZR_pow by lia; unfold Rdiv; now rewrite <- bpow_opp, Z.opp_involutive. }
      rewrite E in Hd; split; [apply Z.div_pos; lia | split; [exact Hd|]]; intros K; apply Z.eqb_eq in K.
      rewrite <- E, (Z_div_exact_full_2 m (2 ^ (- shift))) at 1 by lia; rewrite mult_IZR; field.
      apply IZR_lt in Hp; lra. }
  destruct Hn as (Hn0 & Hn & Hk); pose proof (Z.sqrt_spec n Hn0) as Hr; pose proof (Z.sqrt_nonneg n) as Hr0.
  cbv zeta in Hr; set (r := Z.sqrt n) in *; apply IZR_le in Hr0 as Hr1; rewrite Ed.
  assert (Hlow : IZR r <= sqrt X).
  { rewrite <- (sqrt_square (IZR r)) by lra; apply sqrt_le_1_alt; rewrite <- mult_IZR.
    apply Rle_trans with (2 := proj1 Hn), IZR_le; lia. }
  assert (Hup : sqrt X <= IZR r + 1).
  { rewrite <- (sqrt_square (IZR r + 1)) by lra; apply sqrt_le_1_alt; rewrite <- plus_IZR, <- mult_IZR.
    apply Rle_trans with (IZR (n + 1)); [rewrite plus_IZR; lra | apply IZR_le; lia]. }
  split.
  - split; [apply Rmult_le_compat_r; lra|]; replace (IZR r * pw h + pw h) with ((IZR r + 1) * pw h) by ring.
    apply Rmult_le_compat_r; lra.
  - intros K; apply andb_true_iff in K as [K1 K2]; apply Z.eqb_eq in K2; rewrite (Hk K1), <- K2, mult_IZR, sqrt_square; lra.
Qed.

(** ** One turn, and all of them *)

Lemma quotient_between a b c w : w <> 0 -> a <= c <= b \/ b <= c <= a -> a / w <= c / w <= b / w \/ b / w <= c / w <= a / w.
Proof.
  intros Hw H; unfold Rdiv; destruct (Rlt_or_le 0 w) as [Hp|Hn].
  - pose proof (Rinv_0_lt_compat w Hp); destruct H; [left | right]; split; apply Rmult_le_compat_r; lra.
  - assert (Hi : / w < 0) by (apply Rinv_lt_0_compat; lra).
    rewrite !(Rmult_comm _ (/ w)); destruct H; [right | left]; split; apply Rmult_le_compat_neg_l; lra.
Qed.

Lemma attempt_right x y w d root out : w <> 0 -> (whole root = true -> d = IZR (cut root) * pw (place root)) ->
  IZR (cut root) * pw (place root) <= d <= IZR (cut root) * pw (place root) + pw (place root) ->
  attempt x y w ((x + y * d) / w) root = Some out -> out = extended ((x + y * d) / w).
Proof.
  intros Hw Hwhole Hd; unfold attempt; set (c := IZR (cut root) * pw (place root)) in *; set (unit := pw (place root)) in *.
  destruct (whole root); [intros [= <-]; now rewrite Hwhole|]; destruct Rle_bool; [discriminate|].
  set (value := (x + y * d) / w) in *; set (one := extended ((x + y * c) / w)); set (other := extended ((x + y * c + y * unit) / w)).
  assert (Hv : (x + y * c) / w <= value <= (x + y * c + y * unit) / w \/ (x + y * c + y * unit) / w <= value <= (x + y * c) / w).
  { apply quotient_between; [exact Hw|]; destruct (Rle_or_lt 0 y) as [Hy|Hy].
    - left; assert (y * c <= y * d <= y * (c + unit)) by (split; apply Rmult_le_compat_l; lra); lra.
    - right; assert (y * (c + unit) <= y * d <= y * c) by (split; apply Rmult_le_compat_neg_l; lra); lra. }
  assert (Hr : Rmin one other <= extended value <= Rmax one other).
  { destruct Hv as [[H1 H2]|[H1 H2]]; apply extended_le in H1, H2; fold one other in H1, H2; unfold Rmin, Rmax;
      destruct Rle_dec; lra. }
  destruct (Req_bool_spec one other) as [E|N].
  - intros [= <-]; rewrite <- E, Rmin_left, Rmax_left in Hr; lra.
  - destruct (Req_bool_spec (succ radix2 fexp (Rmin one other)) (Rmax one other)) as [E|]; [|discriminate]; intros [= <-].
    pose proof (extended_range ((x + y * c) / w)) as R1; pose proof (extended_range ((x + y * c + y * unit) / w)) as R2.
    fold one in R1; fold other in R2.
    assert (Fl : format (Rmin one other)) by (unfold Rmin; destruct Rle_dec; apply extended_format).
    apply nearer_right; auto; unfold Rmin, Rmax in *; destruct Rle_dec; lra.
Qed.

Lemma attempts_right x y w m e out : w <> 0 -> (0 < m)%Z -> forall turns count, attempts turns count x y w m e = Some out ->
  out = extended ((x + y * sqrt (dyadic m e)) / w).
Proof.
  intros Hw Hm; induction turns as [|turns IH]; intros count; cbn [attempts]; [discriminate|].
  destruct (cut_root_spans m e count Hm) as [Hd Hwhole].
  destruct (attempt x y w _ (cut_root m e count)) as [found|] eqn:E; [intros [= <-] | apply IH].
  now apply (attempt_right x y w (sqrt (dyadic m e)) (cut_root m e count)).
Qed.

Theorem exactly_is_right turns mx ex my ey md ed mw ew out : (0 <= md)%Z -> mw <> 0%Z ->
  exactly turns mx ex my ey md ed mw ew = Some out ->
  out = extended ((dyadic mx ex + dyadic my ey * sqrt (dyadic md ed)) / dyadic mw ew).
Proof.
  intros Hmd Hmw; unfold exactly; set (rational := ((my =? 0) || (md =? 0))%Z%bool).
  assert (Hw : dyadic mw ew <> 0).
  { unfold dyadic; apply Rmult_integral_contrapositive; split; [now apply not_0_IZR | apply Rgt_not_eq, bpow_gt_0]. }
  assert (Hflat : rational = true -> dyadic mx ex + dyadic my ey * sqrt (dyadic md ed) = dyadic mx ex).
  { intros F; apply orb_true_iff in F as [E|E]; apply Z.eqb_eq in E; rewrite E; unfold dyadic; [ring|].
    rewrite Rmult_0_l, sqrt_0; ring. }
  destruct (rational && (mx =? 0)%Z) eqn:Zero.
  - apply andb_true_iff in Zero as [F E]; apply Z.eqb_eq in E; intros [= <-]; rewrite (Hflat F), E; unfold dyadic, Rdiv.
    rewrite !Rmult_0_l; symmetry; unfold extended; rewrite rnd_0; pose proof (bpow_gt_0 radix2 1024).
    rewrite Rmin_right, Rmax_right; lra.
  - assert (Hmx : (my = 0 \/ md = 0)%Z -> mx <> 0%Z).
    { intros F E; rewrite E, Z.eqb_refl, andb_true_r in Zero; unfold rational in Zero; apply orb_false_iff in Zero as [Z1 Z2].
      apply Z.eqb_neq in Z1, Z2; lia. }
    destruct (quick extended mx ex my ey md ed mw ew) as [found|] eqn:Q.
    + intros [= <-]; apply (quick_is_right extended mx ex my ey md ed mw ew); auto using extended_le.
    + destruct rational eqn:F; [intros [= <-]; now rewrite Hflat|]; apply attempts_right; [exact Hw|].
      apply orb_false_iff in F as [_ F]; apply Z.eqb_neq in F; lia.
Qed.

(** ** As it is stored: an infinity is that of its sign *)

Definition stored (x : binary64) (out : R) : Prop :=
  if Rlt_bool (Rabs out) beyond then is_finite x = true /\ B2R x = out else x = B754_infinity (Rlt_bool out 0).

Theorem stored_is_rounded_once x r : stored x (extended r) -> rounded_once x r.
Proof.
  unfold stored, rounded_once; change (rnd64 r) with (rnd r); pose proof (bpow_gt_0 radix2 1024) as Hb.
  destruct (Rlt_bool_spec (Rabs (rnd r)) beyond) as [H|H].
  - apply Rabs_lt_inv in H; assert (E : extended r = rnd r) by (unfold extended; rewrite Rmin_right, Rmax_right; lra).
    rewrite E, Rlt_bool_true by (apply Rabs_lt; lra); auto.
  - assert (Hs : Rlt_bool (extended r) 0 = Rlt_bool r 0 /\ beyond <= Rabs (extended r)); [|destruct Hs as [<- Hs]; now rewrite Rlt_bool_false].
    destruct (Rle_or_lt 0 r) as [Hr|Hr].
    + pose proof (rnd_nonneg r Hr) as H0; rewrite Rabs_pos_eq in H by exact H0.
      unfold extended; rewrite Rmin_left, Rmax_right, !Rlt_bool_false, Rabs_pos_eq by lra; split; [reflexivity | lra].
    + pose proof (rnd_le r 0 ltac:(lra)) as H0; rewrite rnd_0 in H0; rewrite Rabs_left1 in H by exact H0.
      unfold extended; rewrite Rmin_right, Rmax_left, !Rlt_bool_true, Rabs_Ropp, Rabs_pos_eq by lra; split; [reflexivity | lra].
Qed.

Theorem exact_rounding_right turns mx ex my ey md ed mw ew out x : (0 <= md)%Z -> mw <> 0%Z ->
  exactly turns mx ex my ey md ed mw ew = Some out -> stored x out ->
  rounded_once x ((dyadic mx ex + dyadic my ey * sqrt (dyadic md ed)) / dyadic mw ew).
Proof.
  intros Hmd Hmw E S; apply stored_is_rounded_once; rewrite <- (exactly_is_right turns mx ex my ey md ed mw ew out); assumption.
Qed.
