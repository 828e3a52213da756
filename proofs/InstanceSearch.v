(** * InstanceSearch: the search of the recorded steps, asked on the scene of all seven shapes

    The theorems of Main.v about the search that runs, with all that they ask of the scene, the ray, the steps and the walk:
    the steps are those of Recorded.v, with every element in range, and the walk opens one cell that lists them all. Of the
    text's answer the procedure over integers then says which it is, so that what the search publishes is known: the elements
    and the bits. How far a step in floating point decides itself, and what it leaves to the next, is not said here.

    shape_at, elements  == the seven, by their names
    asked p v on        == the ray's numbers are small, it has a direction, and on says on which of the seven it starts
    publishes p v on a  == the search of the recorded steps comes to an end over the walk, and publishes a
    blocked p v on b b1 == it comes to an end for a shadow ray, and answers b; and b1 for a segment *)
From Coq Require Import ZArith Reals List Bool Relations Lia Lra.
From Flocq Require Import Core BinarySingleNaN.
From Durero Require Import Toolkit Especificacion Escena Trazador Interseccion Exacto InstanceScene.
From Durero Require Surd ExactoEscena Walk Limits Search Chain Occlusion Whole Triage Running Recorded Flotante Vectors Rounding Steps
  Nearest Main.
Import ListNotations.
Local Open Scope R_scope.
Local Open Scope zed_scope.
Local Instance prec53 : Prec_gt_0 53 := eq_refl.

Definition elements : list nat := map fst seven.
Definition shape_at (e : nat) : shape :=
  match find (fun a => Nat.eqb (fst a) e) seven with Some a => snd a | None => Sphere (v3 0 0 0) 2 end.
Notation s := (scene_of 2 seven).
Notation real := (Whole.vec_over 2).
Notation real_shape e := (Whole.shape_over 2 (shape_at e)).

(** ** Small numbers are ordinary *)

Definition small (n : Z) : bool := (Z.abs n <=? 2 ^ 50)%Z.

Lemma small_is_ordinary n : small n = true -> Flotante.ordinary (over 2 n).
Proof.
  unfold small; rewrite Z.leb_le; intros H; assert (E : over 2 n = F2R (Float radix2 n (-1))).
  { unfold over, F2R; cbn [Fnum Fexp]; replace (bpow radix2 (-1)) with (/ 2) by reflexivity; reflexivity. }
  split.
  - rewrite E; apply generic_format_FLT; exists (Float radix2 n (-1)); [reflexivity | | cbn; lia].
    cbn [Fnum]; change (Zpower radix2 53) with (2 ^ 53)%Z; assert (2 ^ 50 < 2 ^ 53)%Z by reflexivity; lia.
  - destruct (Z.eq_dec n 0) as [-> | N]; [left; unfold over; cbn; lra | right].
    assert (A : Rabs (over 2 n) = IZR (Z.abs n) * / 2) by (unfold over, Rdiv; rewrite Rabs_mult, abs_IZR, (Rabs_pos_eq (/ 2)); lra).
    rewrite A; assert (L : (1 <= Z.abs n)%Z) by lia; apply IZR_le in L, H; change (2 ^ 50)%Z with 1125899906842624%Z in H.
    assert (bpow radix2 (-100) <= bpow radix2 (-1)) by (apply bpow_le; lia).
    assert (bpow radix2 50 <= bpow radix2 100) by (apply bpow_le; lia).
    replace (bpow radix2 (-1)) with (/ 2) in * by reflexivity; replace (bpow radix2 50) with 1125899906842624 in * by reflexivity; lra.
Qed.

Definition small_vec (a : vec3) : bool := small (vx a) && small (vy a) && small (vz a).
Lemma small_vec_is_ordinary a : small_vec a = true -> Flotante.ordinary_vec (real a).
Proof.
  unfold small_vec; rewrite !andb_true_iff; intros [[X Y] Z0]; split; [|split]; now apply small_is_ordinary.
Qed.

Lemma seven_are_ordinary e : In e elements -> Triage.ordinary_shape (real_shape e).
Proof.
  intros He; cbn in He; decompose [or] He; subst; try contradiction; cbn; repeat split;
    first [now apply small_is_ordinary | apply small_is_ordinary; reflexivity].
Qed.

(** ** A walk over one cell *)

Definition all_of : Walk.cell nat := Walk.Cell univ elements [].

Lemma some_walk State (take : nat -> State -> State) (prunable : State -> Walk.cell nat -> Prop) start :
  exists taken st, Walk.walks nat State Nat.eq_dec take prunable (Walk.plan [] [all_of], ([], start)) ([], (taken, st)).
Proof.
  destruct (fold_left (Walk.visit nat State Nat.eq_dec take) elements ([], start)) as [taken st] eqn:E; exists taken, st.
  unfold Walk.walks; eapply Relation_Operators.rt1n_trans; [exact (Walk.open _ _ _ _ _ [] (Walk.Cell univ [] []) [all_of] _)|].
  eapply Relation_Operators.rt1n_trans; [exact (Walk.open _ _ _ _ _ [] all_of [] _)|].
  cbn [app Walk.children all_of]; change (Walk.elements nat all_of) with elements; cbn [Walk.elements fold_left]; rewrite E.
  apply Relation_Operators.rt1n_refl.
Qed.

Lemma cells_list : Forall (Walk.lists_from elements) [all_of].
Proof. constructor; [|constructor]; constructor; [apply incl_refl | intros c []]. Qed.
Lemma cells_lead (e : nat) (t : R) : In e elements -> exists c, In c [all_of] /\ Walk.leads c e t.
Proof. intros He; exists all_of; split; [now left | now apply Walk.leads_here]. Qed.

Lemma same_scene : Xi_Escena s s.
Proof. split; [split; exact the_seven_are_a_scene | apply Escena_eq_refl]. Qed.

(** What is rounded once is one binary64, but for a zero. *)
Lemma rounded_once_same (x y : Limits.binary64) r : is_finite_strict y = true -> Limits.rounded_once x r -> Limits.rounded_once y r -> x = y.
Proof.
  intros Fy; unfold Limits.rounded_once; destruct (Rlt_bool _ _); [|intros _ ->; discriminate Fy].
  intros [Fx Ex] [_ Ey]; apply B2R_inj; [|exact Fy | now rewrite Ex, Ey].
  destruct x as [sx | | | ] eqn:Dx; try discriminate Fx; [|reflexivity]; exfalso; cbn in Ex; rewrite <- Ey in Ex.
  destruct y as [| | | sy m e H]; try discriminate Fy; cbn in Ex; symmetry in Ex; apply eq_0_F2R in Ex; now destruct sy.
Qed.

Definition all_strict (out : Chain.printed) : bool :=
  is_finite_strict (Chain.printed_t out) && is_finite_strict (Chain.printed_x out) && is_finite_strict (Chain.printed_y out)
  && is_finite_strict (Chain.printed_z out).
Lemma rounds_same ray (out out' : Chain.printed) t : all_strict out' = true -> Chain.rounds ray out t -> Chain.rounds ray out' t ->
  out = out'.
Proof.
  unfold all_strict; rewrite !andb_true_iff; intros [[[T X] Y] Z0] (T1 & X1 & Y1 & Z1) (T2 & X2 & Y2 & Z2).
  destruct out, out'; cbn in *; f_equal; eapply rounded_once_same; eauto.
Qed.

(** The bits of the parameter and of the point. *)
Definition bits_of (out : Chain.printed) : list Z :=
  map Nearest.bits [Chain.printed_t out; Chain.printed_x out; Chain.printed_y out; Chain.printed_z out].

Section Asked.
Variables p v : vec3.
Variable on : nat -> bool.
Let en : set nat := fun e => on e = true.
Notation ray := (ExactoEscena.the_ray 2 p v).

Record asked : Prop := Asked {
  is_small : small_vec p && small_vec v = true;
  has_direction : ~ (vx v = 0 /\ vy v = 0 /\ vz v = 0)%Z;
  on_the_seven : forall e, on e = true -> In e elements }.
Hypothesis right : asked.

Lemma is_ray : Rayo_ok ray.
Proof.
  constructor; cbn; unfold over; intros (X & Y & Z0); apply (has_direction right).
  assert (Zero : forall n, IZR n / 2 = 0 -> n = 0%Z) by (intros n H; apply eq_IZR; lra); auto.
Qed.

Lemma is_known : en ⊆ elementos s.
Proof.
  intros e He; apply (on_the_seven right) in He; apply in_map_iff in He as ([e' sh] & <- & Hin); exists (row_of 2 sh).
  apply rows_of; now exists sh.
Qed.

Lemma is_described : ExactoEscena.describes nat 2 s en (map (fun e => (e, shape_at e, on e)) elements).
Proof. exact (described 2 seven en on (fun e _ _ => conj (fun H => H) (fun H => H))). Qed.

Lemma all_in_range e : In e elements -> true = true -> Triage.in_bounds (real p) (real v) (real_shape e).
Proof.
  intros He _; pose proof (is_small right) as Small; apply andb_true_iff in Small as [Sp Sv]; split;
    [split; now apply small_vec_is_ordinary | now apply seven_are_ordinary].
Qed.

Lemma all_are_binary64 e : In e elements -> Triage.binary64s (real p) (real v) (real_shape e).
Proof. intros He; exact (Triage.bounds_are_of_binary64 _ _ _ (all_in_range e He eq_refl)). Qed.
Lemma all_are_asked e : In e elements -> true = true -> Triage.asked_in_range (real p) (real v) (real_shape e) = true.
Proof. intros He _; exact (proj2 (Triage.asked_in_range_in_bounds _ _ _ (all_are_binary64 e He)) (all_in_range e He eq_refl)). Qed.

Notation shapes := (fun e => real_shape e).
Notation triage := (Recorded.triage nat 2 p v shapes on).
Notation stable := (Recorded.stable nat 2 p v shapes on).
Notation improved := (Recorded.improved nat 2 p v shapes on).
Notation low := (Recorded.low 2 p v).
Notation high := (Recorded.high 2 p v).
Notation rounded := (Recorded.rounded nat 2 p v shapes).
Notation round_exact := (Recorded.round_exact 2 p v).
Notation in_range := (fun _ : nat => true).

Lemma they_run : Running.steps_run nat (real p) (real v) elements shapes on in_range triage stable improved low high Recorded.less
  rounded round_exact.
Proof.
  apply (Main.the_recorded_terms_are_steps_that_run nat 2 s en p v the_seven_are_a_scene is_ray elements shape_at on is_described).
  - exists 1%Z; split; [lia | reflexivity].
  - exact all_in_range.
Qed.

Lemma over_two e : In e elements -> Triage.stands nat s e (real_shape e) /\ (on e = true <-> en e).
Proof. exact (Whole.described_over nat 2 s en elements shape_at on is_described e). Qed.

Definition they_are_right := Main.the_steps_that_run_are_right nat s en (real p) (real v) the_seven_are_a_scene is_ray elements shapes on
  in_range triage stable improved low high Recorded.less rounded round_exact over_two all_in_range they_run.

Notation reach_of := (Chain.reach_of nat 2 p v shape_at on).
Notation take := (Search.take nat Running.finding reach_of in_range triage stable low high).
Notation published := (Search.published nat Running.finding Chain.printed reach_of stable improved Recorded.less Recorded.less rounded
  round_exact).
Notation nothing_passed := (fun (_ : Search.found nat Running.finding) (_ : Walk.cell nat) => False).

(** The theorem of Main.v, with all that it asks. *)
Theorem the_search_is_right : exists taken st,
  Walk.walks nat _ Nat.eq_dec take nothing_passed (Walk.plan [] [all_of], ([], Search.start _ _)) ([], (taken, st)) /\
  Chain.says nat s s ray en (published st).
Proof.
  destruct (some_walk _ take nothing_passed (Search.start nat Running.finding)) as (taken & st & W); exists taken, st; split; [exact W|].
  refine (Main.the_search_that_runs_publishes_the_texts_hit nat Nat.eq_dec 2 s s en p v eq_refl the_seven_are_a_scene is_ray same_scene
    is_known elements shape_at on is_described in_range triage stable improved low high Recorded.less Recorded.less rounded round_exact
    all_are_binary64 all_are_asked they_run nothing_passed [] [all_of] taken st _ _ cells_list _ W).
  - intros ? ? [].
  - intros e [].
  - intros e t He _ _; exact (cells_lead e t He).
Qed.

(** And the one before it, of steps that are right. *)
Theorem the_search_of_right_steps_is_right : exists taken st,
  Walk.walks nat _ Nat.eq_dec take nothing_passed (Walk.plan [] [all_of], ([], Search.start _ _)) ([], (taken, st)) /\
  Chain.says nat s s ray en (published st).
Proof.
  destruct (some_walk _ take nothing_passed (Search.start nat Running.finding)) as (taken & st & W); exists taken, st; split; [exact W|].
  refine (Main.the_printed_hit_is_the_texts_hit nat Nat.eq_dec 2 s s en p v eq_refl the_seven_are_a_scene is_ray same_scene is_known
    elements shape_at on is_described Running.finding in_range triage stable improved Running.near low high Recorded.less Recorded.less
    rounded round_exact they_are_right nothing_passed [] [all_of] taken st _ _ cells_list _ W).
  - intros ? ? [].
  - intros e [].
  - intros e t He _ _; exact (cells_lead e t He).
Qed.

(** ** Which it is *)

Definition asked_of : list (nat * shape * bool) := map (fun e => (e, shape_at e, on e)) elements.

Lemma first_is_least x l : first_hit 2 p v asked_of = Exacto.Hit x l -> is_least (met_scene ray nat s en) (Surd.val x).
Proof.
  intros E; pose proof (ExactoEscena.first_hit_is_Primera_Interseccion nat 2 eq_refl s the_seven_are_a_scene en p v asked_of is_ray
    is_described s same_scene is_known) as H; rewrite E in H.
  apply hit_computed in H; [exact (proj1 H) | exact is_ray | exact same_scene | exact is_known].
Qed.

Definition publishes (a : Search.answer nat Chain.printed) : Prop := exists taken st,
  Walk.walks nat _ Nat.eq_dec take nothing_passed (Walk.plan [] [all_of], ([], Search.start _ _)) ([], (taken, st)) /\
  published st = a.

Theorem the_search_publishes x e : first_hit 2 p v asked_of = Exacto.Hit x [e] -> all_strict (round_exact x) = true ->
  publishes (Search.Published_hit _ _ (Some (round_exact x)) [e]).
Proof.
  intros E Strict; destruct the_search_is_right as (taken & st & W & Says); exists taken, st; split; [exact W|].
  pose proof (ExactoEscena.first_hit_is_Primera_Interseccion nat 2 eq_refl s the_seven_are_a_scene en p v asked_of is_ray is_described
    s same_scene is_known) as H; rewrite E in H.
  assert (One : forall r els t w, Primera_Interseccion s s ray en r els t w -> r = hit /\ els ≡ (fun k => In k [e]) /\ (r = hit -> t = Surd.val x)).
  { intros r els t w K; destruct (Primera_Interseccion_deterministic ray is_ray nat s the_seven_are_a_scene en s same_scene is_known
      _ _ _ _ _ _ _ _ K (or_introl H)) as (-> & Els & T); split; [reflexivity | split; [exact Els | intros _; now apply T]]. }
  destruct (published st) as [| out l | l]; cbn [Chain.says] in Says.
  - destruct (One _ _ 0 (Rayo_p ray) (or_intror (or_introl Says))) as [N _]; discriminate N.
  - destruct Says as (Once & t & o & -> & Rounds & Hay); destruct (One _ _ _ _ (or_introl Hay)) as (_ & Els & T).
    rewrite (T eq_refl) in Rounds.
    assert (Valid : Surd.valid x).
    { pose proof (first_hit_correct 2 p v asked_of eq_refl) as C; rewrite E in C; apply C. }
    rewrite (rounds_same ray o (round_exact x) _ Strict Rounds
      (Chain.exactly_printed_is_rounded_once Z.sqrt 0 0 0 0 2 p v x eq_refl Valid)); f_equal.
    destruct l as [| a [| b l]].
    + destruct (proj2 (Els e) (or_introl eq_refl)).
    + destruct (proj1 (Els a) (or_introl eq_refl)) as [-> | []]; reflexivity.
    + exfalso; inversion_clear Once as [| ? ? N _]; apply N; left.
      destruct (proj1 (Els a) (or_introl eq_refl)) as [<- | []], (proj1 (Els b) (or_intror (or_introl eq_refl))) as [<- | []]; reflexivity.
  - destruct Says as [_ Says]; destruct (One _ _ 0 (Rayo_p ray) (or_intror (or_intror Says))) as [N _]; discriminate N.
Qed.

(** ** Shadow rays *)

Notation blocks := (Occlusion.blocks nat Running.finding reach_of in_range triage stable).
Notation blocks_segment := (Occlusion.blocks_segment nat Running.finding reach_of in_range triage stable low high).
Notation none_passed := (fun (_ : bool) (_ : Walk.cell nat) => False).
Notation start_of_all := (Walk.plan [] [all_of], ([], false)).

Definition blocked (b b1 : bool) : Prop := exists taken taken1,
  Walk.walks nat bool Nat.eq_dec (Occlusion.take nat blocks) none_passed start_of_all ([], (taken, b)) /\
  Walk.walks nat bool Nat.eq_dec (Occlusion.take nat blocks_segment) none_passed start_of_all ([], (taken1, b1)).

Lemma before_the_end x : Surd.valid x -> (Surd.val x < 1 <-> (Surd.cmp x (Surd.Surd 1 0 0 1) <? 0)%Z = true).
Proof.
  intros Hx; assert (V1 : Surd.valid (Surd.Surd 1 0 0 1)) by (split; cbn; lia); pose proof (Surd.cmp_correct x _ Hx V1) as C.
  replace (Surd.val (Surd.Surd 1 0 0 1)) with 1 in C by (unfold Surd.val; cbn; field); rewrite Z.ltb_lt.
  destruct C as [[-> H] | [[-> H] | [-> H]]]; split; intros; lia || lra.
Qed.

Theorem the_search_answers x l b1 : first_hit 2 p v asked_of = Exacto.Hit x l ->
  (Surd.cmp x (Surd.Surd 1 0 0 1) <? 0)%Z = b1 -> blocked true b1.
Proof.
  enough (K : first_hit 2 p v asked_of = Exacto.Hit x l -> exists taken taken1 st1,
    Walk.walks nat bool Nat.eq_dec (Occlusion.take nat blocks) none_passed start_of_all ([], (taken, true)) /\
    Walk.walks nat bool Nat.eq_dec (Occlusion.take nat blocks_segment) none_passed start_of_all ([], (taken1, st1)) /\
    (st1 = true <-> Surd.val x < 1)).
  { intros E <-; destruct (K E) as (taken & taken1 & st1 & W & W1 & H); exists taken, taken1; split; [exact W|].
    pose proof (first_hit_correct 2 p v asked_of eq_refl) as C; rewrite E in C; rewrite (before_the_end x) in H by apply C.
    replace (Surd.cmp x (Surd.Surd 1 0 0 1) <? 0)%Z with st1; [exact W1|].
    destruct st1, (Surd.cmp x (Surd.Surd 1 0 0 1) <? 0)%Z; try reflexivity; destruct H as [H H']; [now rewrite H | now rewrite H']. }
  intros E; pose proof (first_is_least x l E) as [Hit Least]; destruct (occluded_computed ray nat s en) as [O O1].
  destruct (some_walk bool (Occlusion.take nat blocks) none_passed false) as (taken & st & W).
  destruct (some_walk bool (Occlusion.take nat blocks_segment) none_passed false) as (taken1 & st1 & W1).
  exists taken, taken1, st1.
  destruct (Main.the_search_that_runs_answers_shadow_rays_as_the_text nat Nat.eq_dec 2 s en p v eq_refl the_seven_are_a_scene is_ray
    elements shape_at on is_described in_range triage stable improved low high Recorded.less rounded round_exact all_are_binary64
    all_are_asked they_run none_passed none_passed [] [all_of] taken st taken1 st1) as [A A1].
  1-5: try exact cells_list; try (now intros ? ? ? []); try (now intros ? []); intros; now apply cells_lead.
  assert (Yes : st = true) by (apply (A W), O; now exists (Surd.val x)); rewrite Yes in W.
  split; [exact W | split; [exact W1|]]; rewrite (A1 W1), O1; split.
  - intros (t & Ht & Lt); apply Rle_lt_trans with (2 := Lt); now apply Least.
  - intros Lt; now exists (Surd.val x).
Qed.
End Asked.
