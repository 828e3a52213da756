(** * Running: the steps of the search, as they run, say nothing false

    The record Search.steps_right, of the steps that are proved: the triage and the second step on every element, the ends
    around a parameter, the Newton step, what is certainly less, and the rounding of what is found, or of an exact parameter.

    finding          == what a step has found: in binary64, in double-double, or by improving the first
    near f t         == t is within its error, with the room that its ends and comparisons ask for
    close root t     == the pair root is within its error of t, which is no less than what rounding asks
    answered_pair    == as Triage.answered, of the second step: limits are binary64
    found_by e w     == what w rests on was found of e, by a step that was asked of it
    steps_run        == what the steps compute; Instances.v has steps of which it holds *)
From Coq Require Import Reals List Lra Lia ZArith.
From Flocq Require Import Core BinarySingleNaN.
From Durero Require Import Toolkit Especificacion Escena Puntos Trazador Interseccion.
From Durero Require Search Limits Chain Formas Once Newton Ends ExactHit.
From Durero Require Import Rounding Vectors Quotient Flotante Verdict Steps Triage Twofold Sums Doubled Second AtRoot AtRootText Levels.
Import Formas.Pairs.
Local Open Scope R_scope.
Local Open Scope zed_scope.
Local Opaque bpow.

Inductive finding :=
  | Single (root slope curvature : Formas.known R)
  | Double (root : Formas.known twofold)
  | Improved (root : Formas.known twofold).
Definition close (root : Formas.known twofold) (t : R) : Prop :=
  Rabs (whole (Formas.value root) - t) <= Formas.error root /\ pair (Formas.value root) /\
  format (Formas.error root) /\ bpow radix2 (-900) <= Formas.error root.
Definition near (f : finding) (t : R) : Prop :=
  match f with
  | Single root _ _ => is_near root t
  | Double root => near_pair root t
  | Improved root => close root t
  end.

Lemma near_pair_close root t : near_pair root t -> close root t.
Proof.
  intros [(H & W & Fe & He) _]; pose proof (bpow_gt_0 radix2 (-900)); split; [lra|].
  split; [now apply double_word_is_pair | now split].
Qed.

Definition found_single (a : Formas.answer R) : Search.verdict finding :=
  match a with
  | Formas.Miss => Search.Miss _
  | Formas.Undecided => Search.Undecided _
  | Formas.Hit root slope curvature => Search.Hit _ (Single root slope curvature)
  end.
Definition found_double (a : Formas.answer twofold) : Search.verdict finding :=
  match a with
  | Formas.Miss => Search.Miss _
  | Formas.Undecided => Search.Undecided _
  | Formas.Hit root _ _ => Search.Hit _ (Double root)
  end.

Definition answered_pair (step : R -> Formas.answer twofold) (x : Limits.binary64) (a : Formas.answer twofold) : Prop :=
  if is_finite x then a = step (B2R x) else exists low, forall limit, format limit -> low <= limit -> a = step limit.

(** What a step may say of one element up to x. *)
Definition says_right (T : R -> Prop) (x : Limits.binary64) (a : Search.verdict finding) : Prop :=
  match a with
  | Search.Miss => forall t, T t -> ~ Limits.at_least x t
  | Search.Hit f => exists t, is_least T t /\ near f t
  | Search.Undecided => True
  end.

Lemma format_above low : exists limit, format limit /\ low <= limit.
Proof.
  exists (bpow radix2 (Z.max 0 (mag radix2 low))); split; [apply format_bpow; lia|].
  apply Rle_trans with (1 := Rle_abs low), Rlt_le, Rlt_le_trans with (1 := bpow_mag_gt radix2 low), bpow_le; lia.
Qed.

Lemma double_says_right T step x a : (forall limit, format limit -> right_pair T limit (step limit)) -> answered_pair step x a ->
  says_right T x (found_double a).
Proof.
  intros R0 Ha; unfold answered_pair in Ha.
  destruct (is_finite x) eqn:Fx.
  - specialize (R0 (B2R x) (generic_format_B2R 53 1024 x)); rewrite <- Ha in R0; destruct a; cbn in *; auto.
    intros t Ht [-> | [_ Hle]]; [discriminate Fx | specialize (R0 t Ht); lra].
  - destruct Ha as (low & Ha); destruct (format_above low) as (l0 & F0 & H0); pose proof (R0 l0 F0) as R1.
    rewrite <- (Ha l0 F0 H0) in R1; destruct a; cbn in *; auto.
    intros t Ht _; destruct (format_above (Rmax low t)) as (l & Fl & Hl).
    pose proof (Rmax_l low t); pose proof (Rmax_r low t); pose proof (R0 l Fl) as R2; rewrite <- (Ha l Fl) in R2 by lra.
    cbn in R2; specialize (R2 t Ht); lra.
Qed.

Section Running.
Variable Elemento : Type.
Variable s : Especificacion.Escena Elemento.
Variable en : set Elemento.
Variables p v : vec.
Notation ray := (ray_of p v).
Notation met := (met ray Elemento s en).
Hypothesis ok : Escena_ok s.
Hypothesis ray_ok : Rayo_ok ray.

Variable elements : list Elemento.
Variables (shape_of : Elemento -> shape) (on in_range : Elemento -> bool).
Hypothesis described : forall e, In e elements -> stands Elemento s e (shape_of e) /\ (on e = true <-> en e).
Hypothesis range : forall e, In e elements -> in_range e = true -> in_bounds p v (shape_of e).

Variables triage stable : Elemento -> Limits.binary64 -> Search.verdict finding.
Variable improved : Elemento -> finding -> Search.verdict finding.
Variables low high : Search.evidence finding -> Limits.binary64.
Variables less : finding -> finding -> bool.
Variable rounded : Elemento -> finding -> option Chain.printed.
Variable round_exact : Surd.surd -> Chain.printed.

(** The text's quadratic along the ray; where the ray starts on the element, without its constant term. *)
Definition quadratic_of (e : Elemento) : coefficients :=
  if on e then launched (text_of p v (shape_of e)) else text_of p v (shape_of e).

(** The evidence w was found of e, by its step: only of such are the ends asked, since no binary64 is an end of every real. *)
Definition found_by (e : Elemento) (w : Search.evidence finding) : Prop :=
  match w with
  | Search.By_triage f => in_range e = true /\ exists x, triage e x = Search.Hit _ f
  | Search.By_stable f => in_range e = true /\ exists x, stable e x = Search.Hit _ f
  | Search.By_exact x => Surd.valid x
  end.

(** What the steps compute. *)
Record steps_run : Prop := {
  triage_runs : forall e x, In e elements -> in_range e = true ->
    exists a, answered (alone_of p v (shape_of e) (on e)) x a /\ triage e x = found_single a;
  stable_runs : forall e x, In e elements -> in_range e = true ->
    exists a, answered_pair (second_of p v (shape_of e) (on e)) x a /\ stable e x = found_double a;
  ends_run : forall e w, In e elements -> found_by e w ->
    match w with
    | Search.By_triage (Single root _ _) =>
        Once.stored (low w) (Formas.low (Formas.ends_of root)) /\ Once.stored (high w) (Formas.high (Formas.ends_of root))
    | Search.By_stable (Double root) =>
        Once.stored (low w) (Formas.low (ends_of root)) /\ Once.stored (high w) (Formas.high (ends_of root))
    | Search.By_exact x => let nearest := Chain.printed_t (round_exact x) in
        low w = Ends.next_below nearest /\ high w = Ends.next_above nearest
    | _ => True
    end;
  improved_runs : forall e root slope curvature g, In e elements -> in_range e = true ->
    improved e (Single root slope curvature) = Search.Hit _ g ->
    let better_root := newton root slope curvature (at_root p v (shape_of e) (on e) (Formas.value root)) in
    known_slope better_root = true /\ g = Improved (Formas.Known (better better_root) (better_error better_root));
  less_runs : forall f g, less f g = true -> exists a b, f = Double a /\ g = Double b /\ certainly_less a b = true;
  rounding_runs : forall e f out, In e elements -> rounded e f = Some out -> exists root, (f = Double root \/ f = Improved root) /\
    let once := round_on p v (shape_of e) (Formas.value root) (Formas.error root) in
    all_certain once = true /\ Once.stores out once;
  exact_runs : forall x, Surd.valid x -> exists t, ExactHit.sound t /\ ExactHit.denotes t = Surd.val x /\
    ExactHit.hit_into p v t (round_exact x) }.

Lemma exact_is_rounded x : steps_run -> Surd.valid x -> Chain.rounds ray (round_exact x) (Surd.val x).
Proof.
  intros Runs Hx; destruct (exact_runs Runs x Hx) as (t & Ht & <- & Hit); exact (ExactHit.hit_is_rounded_once p v t _ Ht Hit).
Qed.

Lemma triage_finds e x : steps_run -> In e elements -> in_range e = true -> exists a, triage e x = found_single a /\
  match a with
  | Formas.Miss => forall t, met e t -> ~ Limits.at_least x t
  | Formas.Undecided => True
  | Formas.Hit root slope curvature => exists t, is_least (met e) t /\ is_near root t /\
      graded (cA (quadratic_of e)) (cB (quadratic_of e)) t slope curvature
  end.
Proof.
  intros Runs He Hr; destruct (described e He) as [Hs Hon], (range e He Hr) as [Ray Ho].
  destruct (triage_runs Runs e x He Hr) as (a & Ha & E); exists a; split; [exact E|]; unfold answered in Ha.
  replace (cA (quadratic_of e)) with (cA (text_of p v (shape_of e))) by (unfold quadratic_of; now destruct (on e)).
  replace (cB (quadratic_of e)) with (cB (text_of p v (shape_of e))) by (unfold quadratic_of; now destruct (on e)).
  pose proof (fun limit => alone_is_right Elemento s ok en p v ray_ok Ray e _ (on e) limit Hs Ho Hon) as R1.
  destruct (is_finite x) eqn:Fx.
  - specialize (R1 (B2R x)); rewrite <- Ha in R1; destruct a; cbn in *; auto.
    intros t Ht [-> | [_ Hle]]; [discriminate Fx | specialize (R1 t Ht); lra].
  - destruct Ha as (l & Ha); pose proof (R1 l) as R0; rewrite <- (Ha l) in R0 by lra; destruct a; cbn in *; auto.
    intros t Ht _; specialize (R1 (Rmax l t)); rewrite <- (Ha (Rmax l t)) in R1 by apply Rmax_l; cbn in R1.
    specialize (R1 t Ht); pose proof (Rmax_r l t); lra.
Qed.

(** A step of Newton's from what the triage has found. *)
Lemma improved_is_close e x f g t : steps_run -> In e elements -> in_range e = true ->
  triage e x = Search.Hit _ f -> improved e f = Search.Hit _ g -> is_least (met e) t -> near g t.
Proof.
  intros Runs He Hr Hx Hg Ht; destruct (triage_finds e x Runs He Hr) as (a & Ea & Ra); rewrite Ea in Hx.
  destruct a as [| | root slope curvature]; try discriminate; injection Hx as <-.
  destruct Ra as (t' & Ht' & N & Gs & Gc & Fs & Fc & Ls); rewrite (least_unique _ _ _ Ht' Ht) in *.
  destruct (improved_runs Runs e root slope curvature g He Hr Hg) as [Known ->].
  destruct (described e He) as [Hs Hon], (range e He Hr) as [Ray Ho].
  assert (Root : 0 < t /\ value (quadratic_of e) t = 0).
  { destruct Ht as [Ht _]; apply (met_of_shape Elemento s ok en p v e _ (on e) Hs Hon) in Ht.
    split; [exact (proj1 Ht) | exact (proj1 (proj2 Ht))]. }
  destruct Root as [Pos Root].
  assert (Ec : 0 <= Formas.error curvature) by (apply Rle_trans with (2 := Gc), Rabs_pos).
  assert (Et : 0 <= Formas.error root) by (apply Rle_trans with (2 := near_within _ _ N), Rabs_pos).
  pose proof (Newton.known_slope_steep _ _ _ _ (proj1 Fs) (proj2 Fs) Ls Ec Et Known) as Steep; pose proof (bpow_gt_0 radix2 (-900)).
  assert (Near : Rabs (Formas.value slope) <= 2 * Rabs (cA (quadratic_of e) * t + cB (quadratic_of e))).
  { rewrite Rabs_minus_sym in Gs; pose proof (Rabs_triang_inv (Formas.value slope) (cA (quadratic_of e) * t + cB (quadratic_of e))); lra. }
  assert (Slope : cA (quadratic_of e) * t + cB (quadratic_of e) <> 0) by (intros Z0; rewrite Z0, Rabs_R0 in Near; lra).
  destruct (at_root_right Elemento s ok p v Ray e (shape_of e) (on e) (Formas.value root) t Hs Ho (proj1 N) Pos Root Slope)
    as ((Na & Fa) & La & Sa); fold (quadratic_of e) in Na, Sa.
  assert (Binary : Newton.binary64s root slope curvature (at_root p v (shape_of e) (on e) (Formas.value root))).
  { constructor; auto; [apply N | repeat split; auto]; apply Rle_trans with (2 := Sa), Rmult_le_compat_l; [lra|].
    rewrite Rabs_mult, (Rabs_pos_eq 2); lra. }
  unfold value in Root, Na; cbn [near]; unfold close; cbn [Formas.value Formas.error].
  destruct (Newton.newton_near root slope curvature _ Binary (cA (quadratic_of e))
    (cB (quadratic_of e)) (cC (quadratic_of e)) t) as (Close & P & Fe & Le); auto.
  - rewrite <- Root; ring.
  - rewrite Rabs_minus_sym; exact (near_within _ _ N).
  - replace (cA (quadratic_of e) * Formas.value root * Formas.value root) with
      (cA (quadratic_of e) * (Formas.value root * Formas.value root)) by ring; exact Na.
  - rewrite Rabs_minus_sym; auto.
Qed.

(** Of a flat surface nothing is found by a ray that starts on it. *)
Lemma flat_never_found sh limit : is_flat sh = true ->
  (forall root slope curvature, alone_of p v sh true limit <> Formas.Hit root slope curvature) /\
  (forall root slope curvature, second_of p v sh true limit <> Formas.Hit root slope curvature).
Proof.
  intros Flat.
  assert (A : exists q, alone_of p v sh true limit = Formas.first_of_linear_on q limit) by (destruct sh; try discriminate; eexists; reflexivity).
  assert (B : exists q, second_of p v sh true limit = first_of_linear_on q limit) by (destruct sh; try discriminate; eexists; reflexivity).
  destruct A as [q ->], B as [q' ->]; unfold Formas.first_of_linear_on, first_of_linear_on; do 2 destruct Rlt_bool; split; discriminate.
Qed.

Lemma reports_off_flat e f : steps_run -> In e elements -> Search.reports Elemento finding in_range triage stable improved e f ->
  in_range e = true /\ (is_flat (shape_of e) = true -> on e = false).
Proof.
  intros Runs He [Hr Hf]; split; [exact Hr|]; intros Flat; destruct (on e) eqn:On; [exfalso | reflexivity].
  destruct Hf as [[x Hx] | (g & x & Hx & _)].
  - destruct (stable_runs Runs e x He Hr) as (a & Ha & E); rewrite On in Ha; rewrite Hx in E; unfold answered_pair in Ha.
    destruct a as [| | root slope curvature]; try discriminate; destruct (is_finite x).
    + exact (proj2 (flat_never_found (shape_of e) (B2R x) Flat) _ _ _ (eq_sym Ha)).
    + destruct Ha as (low0 & Ha); destruct (format_above low0) as (l & Fl & Hl).
      exact (proj2 (flat_never_found (shape_of e) l Flat) _ _ _ (eq_sym (Ha l Fl Hl))).
  - destruct (triage_runs Runs e x He Hr) as (a & Ha & E); rewrite On in Ha; rewrite Hx in E; unfold answered in Ha.
    destruct a as [| | root slope curvature]; try discriminate; destruct (is_finite x).
    + exact (proj1 (flat_never_found (shape_of e) (B2R x) Flat) _ _ _ (eq_sym Ha)).
    + destruct Ha as (low0 & Ha); exact (proj1 (flat_never_found (shape_of e) low0 Flat) _ _ _ (eq_sym (Ha low0 (Rle_refl _)))).
Qed.

Theorem steps_are_right : steps_run ->
  Search.steps_right Elemento finding Chain.printed met elements (Chain.rounds ray) in_range triage stable improved near low high
    less rounded round_exact.
Proof.
  intros Runs; constructor.
  - intros e x He Hr; destruct (triage_finds e x Runs He Hr) as (a & -> & Ra); destruct a; cbn in *; auto.
    destruct Ra as (t & Ht & N & _); now exists t.
  - intros e x He Hr; destruct (described e He) as [Hs Hon], (range e He Hr) as [Ray Ho].
    destruct (stable_runs Runs e x He Hr) as (a & Ha & ->).
    refine (double_says_right _ _ _ _ _ Ha); intros limit Fl.
    exact (second_pair Elemento s en p v ok ray_ok Ray e _ (on e) limit Hs Ho Hon Fl).
  - intros e f g t He Hr [x Hx] Hg Ht _; exact (improved_is_close e x f g t Runs He Hr Hx Hg Ht).
  - intros e w t He _ Hv; assert (E : found_by e w) by (destruct w; cbn in *; tauto).
    apply (ends_run Runs e w He) in E; destruct w as [f | f | x].
    + destruct Hv as (Hr & [x Hx] & Hn); destruct (triage_runs Runs e x He Hr) as (a & _ & Ea); rewrite Ea in Hx.
      destruct a as [| | root slope curvature]; try discriminate; injection Hx as <-; destruct E as [El Eh].
      exact (Ends.stored_between _ _ _ t (Ends.ends_of_near root t Hn) El Eh).
    + destruct Hv as (Hr & [x Hx] & Hn); destruct (stable_runs Runs e x He Hr) as (a & _ & Ea); rewrite Ea in Hx.
      destruct a as [| | root slope curvature]; try discriminate; injection Hx as <-; destruct E as [El Eh].
      exact (Ends.stored_between _ _ _ t (Ends.ends_of_near_word root t (proj1 Hn)) El Eh).
    + destruct Hv as [Hx <-], E as [-> ->]; apply Ends.nearest_between, (exact_is_rounded x Runs Hx).
  - intros f g a b Hless Ha Hb; destruct (less_runs Runs f g Hless) as (x & y & -> & -> & Hxy).
    exact (Ends.certainly_less_near x y a b Ha Hb Hxy).
  - intros e f out t He Hrep Ht Hf Hn; destruct (rounding_runs Runs e f out He Hf) as (root & Hroot & Hc & Hst).
    assert (Hclose : close root t) by (destruct Hroot as [-> | ->]; [now apply near_pair_close | exact Hn]).
    destruct Hclose as (H & P & Fe & Le), (described e He) as [Hs Hon], (reports_off_flat e f Runs He Hrep) as [Hr Off].
    destruct (range e He Hr) as [Ray Ho].
    apply (round_on_right Elemento s p v e (shape_of e) (Formas.value root) (Formas.error root)); auto.
    + intros Flat; destruct Ht as [Ht _]; apply (met_of_shape Elemento s ok en p v e _ (on e) Hs Hon) in Ht.
      rewrite (Off Flat) in Ht; exact (proj1 (proj2 Ht)).
    + now rewrite Rabs_minus_sym.
  - intros x Hx; exact (exact_is_rounded x Runs Hx).
Qed.
End Running.
