(** * InstancesRunning: instances of the theorems about what runs, in floating point

    It goes on from Instances.v, and tests/proofs/audit.sh reads it in the same way. The scene is that of all seven shapes,
    the ray comes from (-8, 1, 0.5) along (4, 0.5, -0.5); of the sphere the structures hold the box, and the other elements
    are tested apart.

    half n            == the binary64 n/2;  beam_of p v == the ray of these numbers, in binary64
    around_the_sphere == the box of the sphere, in binary64
    the_others        == the elements but the sphere *)
From Coq Require Import ZArith Reals List Bool Relations Lia Lra.
From Flocq Require Import Core BinarySingleNaN.
From Durero Require Import Toolkit Especificacion Escena Exacto InstanceScene InstanceSearch.
From Durero Require Reached Acceleration Moments Lattice Grid Crossings Trees Leaves Puntos Slab Boxes Wide Walk Limits Search Chain Occlusion Whole Triage Running Recorded Flotante Vectors Formas
  ExactoEscena Main MainModels Instances.
Import ListNotations.
Local Open Scope R_scope.
Local Open Scope zed_scope.
Local Instance prec53 : Prec_gt_0 53 := eq_refl.

Notation s := (scene_of 2 seven).
Notation p := (v3 (-16) 2 1).
Notation v := (v3 8 1 (-1)).
Notation ray := (ExactoEscena.the_ray 2 p v).
Notation real := (Whole.vec_over 2).
Notation on := Instances.nowhere.
Notation en := (fun e => on e = true).
Notation right := Instances.from_outside.

(** ** Numbers *)

Definition half (n : Z) : Limits.binary64 := binary_normalize 53 1024 Slab.prec64 Slab.less64 mode_NE n (-1) false.

Lemma half_is n : small n = true -> is_finite (half n) = true /\ B2R (half n) = over 2 n.
Proof.
  intros H; pose proof (small_is_ordinary n H) as [F O].
  pose proof (binary_normalize_correct 53 1024 Slab.prec64 Slab.less64 mode_NE n (-1) false) as C; cbv zeta in C.
  assert (E : F2R (Float radix2 n (-1)) = over 2 n).
  { unfold over, F2R; cbn [Fnum Fexp]; replace (bpow radix2 (-1)) with (/ 2) by reflexivity; reflexivity. }
  rewrite E in C; change (round_mode mode_NE) with ZnearestE in C; change (SpecFloat.emin 53 1024) with (-1074)%Z in C.
  rewrite round_generic in C by (auto with typeclass_instances; exact F).
  rewrite Rlt_bool_true in C; [destruct C as (V & Fin & _); split; [exact Fin | exact V]|].
  destruct O as [-> | [_ O]]; [rewrite Rabs_R0; apply bpow_gt_0 | apply Rle_lt_trans with (1 := O); now apply bpow_lt].
Qed.

Definition beam_of (a b : vec3) : Boxes.beam :=
  Boxes.Beam (half (vx a)) (half (vy a)) (half (vz a)) (half (vx b)) (half (vy b)) (half (vz b)).
Notation beam := (beam_of p v).
Lemma beam_is_the_ray : Boxes.of_beam beam = ray.
Proof.
  unfold Boxes.of_beam, beam_of; cbn [Boxes.p_x Boxes.p_y Boxes.p_z Boxes.v_x Boxes.v_y Boxes.v_z vx vy vz].
  rewrite !(fun n H => proj2 (half_is n H)) by reflexivity; reflexivity.
Qed.

Lemma beam_is_asked : Wide.asked beam.
Proof.
  unfold Wide.asked, beam_of; cbn [Boxes.p_x Boxes.p_y Boxes.p_z Boxes.v_x Boxes.v_y Boxes.v_z vx vy vz].
  repeat (split; [now apply half_is|]); rewrite !(fun n H => proj2 (half_is n H)) by reflexivity.
  apply Flotante.ray_in_range_ordinary; try (apply small_is_ordinary; reflexivity).
  split; repeat split; now apply small_is_ordinary.
Qed.

(** ** The sphere in its box, the others apart *)

Definition the_others : list nat := tl elements.
Lemma the_others_are : incl the_others elements.
Proof. intros e He; now right. Qed.
Lemma the_sphere_is e : In e elements -> ~ In e the_others -> e = 1%nat.
Proof. intros [<- | He] N; [reflexivity | contradiction]. Qed.
Lemma none_starts (e : nat) : In e elements -> en e -> In e the_others.
Proof. intros _ H; discriminate H. Qed.

Definition around_the_sphere : Boxes.box64 := Boxes.Box64 (half (-6)) (half 6) (half (-6)) (half 6) (half (-6)) (half 6).
Lemma the_sphere_is_in_its_box w : puntos_de_elemento s 1%nat w -> Boxes.holds around_the_sphere w.
Proof.
  intros H; apply (ExactoEscena.shape_of_scene nat 2 s the_seven_are_a_scene 1%nat (Sphere (v3 0 0 0) 6)) in H.
  - destruct H as [H _]; unfold Boxes.holds, around_the_sphere.
    cbn [Boxes.low_x Boxes.high_x Boxes.low_y Boxes.high_y Boxes.low_z Boxes.high_z].
    rewrite !(fun n H => proj2 (half_is n H)) by reflexivity; destruct w as [x y z].
    assert (E : x * x + y * y + z * z = 3 * 3).
    { unfold power, potencia_esfera, cuadrado in H; cbn in H; unfold over in H; lra. }
    assert (Side : forall a, a * a <= 3 * 3 -> over 2 (-6) <= a <= over 2 6).
    { intros a Ha; replace (over 2 (-6)) with (- (3)) by (unfold over; lra); replace (over 2 6) with 3 by (unfold over; lra).
      split; [apply Rsqr_neg_pos_le_0 | apply Rsqr_incr_0_var]; (exact Ha || lra). }
    cbn; pose proof (Rle_0_sqr x); pose proof (Rle_0_sqr y); pose proof (Rle_0_sqr z); unfold Rsqr in *.
    split; [|split]; apply Side; lra.
  - exact (shape_in_scene 2 seven 1%nat _ (or_introl eq_refl)).
Qed.

(** ** A walk that opens every cell *)

Section Walks.
Variables (State : Type) (take : nat -> State -> State) (prunable : State -> Walk.cell nat -> Prop).
Notation walks := (Walk.walks nat State Nat.eq_dec take prunable).

Lemma walks_on a b c : walks a b -> walks b c -> walks a c.
Proof. intros H H'; apply clos_rt_rt1n, rt_trans with b; now apply clos_rt1n_rt. Qed.

Lemma opens_one : forall c cs st, exists st', walks (c :: cs, st) (cs, st').
Proof.
  fix IH 1; intros [T es l] cs st.
  assert (L : forall st, exists st', walks (l ++ cs, st) (cs, st')).
  { induction l as [| c l IHl]; intros st0; [exists st0; apply Relation_Operators.rt1n_refl|].
    destruct (IH c (l ++ cs) st0) as [st1 H1]; destruct (IHl st1) as [st2 H2]; exists st2; exact (walks_on _ _ _ H1 H2). }
  destruct (L (fold_left (Walk.visit nat State Nat.eq_dec take) es st)) as [st' H']; exists st'.
  eapply Relation_Operators.rt1n_trans; [exact (Walk.open _ _ _ _ _ [] (Walk.Cell T es l) cs st) | exact H'].
Qed.

Lemma opens_all cs : forall st, exists taken st', walks (cs, st) ([], (taken, st')).
Proof.
  induction cs as [| c cs IH]; intros st; [destruct st as [taken st]; exists taken, st; apply Relation_Operators.rt1n_refl|].
  destruct (opens_one c cs st) as [st1 H1]; destruct (IH st1) as (taken & st2 & H2); exists taken, st2.
  exact (walks_on _ _ _ H1 H2).
Qed.
End Walks.

(** ** The search over structures *)

Notation shapes := (fun e => Whole.shape_over 2 (shape_at e)).
Notation reach_of := (Chain.reach_of nat 2 p v shape_at on).
Notation triage := (Recorded.triage nat 2 p v shapes on).
Notation stable := (Recorded.stable nat 2 p v shapes on).
Notation improved := (Recorded.improved nat 2 p v shapes on).
Notation low := (Recorded.low 2 p v).
Notation high := (Recorded.high 2 p v).
Notation rounded := (Recorded.rounded nat 2 p v shapes).
Notation round_exact := (Recorded.round_exact 2 p v).
Notation in_range := (fun _ : nat => true).
Notation found := (Search.found nat Running.finding).
Notation limit := (Search.limit nat Running.finding).
Notation take := (Search.take nat Running.finding reach_of in_range triage stable low high).
Notation start := (Search.start nat Running.finding).
Notation published := (Search.published nat Running.finding Chain.printed reach_of stable improved Recorded.less Recorded.less
  rounded round_exact).
Notation walks := (Walk.walks nat found Nat.eq_dec take).
Notation says := (Chain.says nat s s ray en).
Notation of_the_search theorem := (theorem nat Nat.eq_dec 2%Z s s en p v eq_refl the_seven_are_a_scene Instances.is_a_ray same_scene
  Instances.are_known elements shape_at on (is_described on) Running.finding in_range triage stable improved Running.near low high
  Recorded.less Recorded.less rounded round_exact (they_are_right _ _ _ right)) (only parsing).

(** A box of which the only leaf lists the sphere. *)
Definition a_tree : Boxes.boxed nat := Boxes.Node nat around_the_sphere [Boxes.Leaf nat [1%nat]].
Theorem instance_of_bounding_volumes_as_they_run : exists taken st,
  walks (Boxes.prunable nat found limit beam) (Walk.plan the_others [Boxes.cell_of nat beam a_tree], ([], start)) ([], (taken, st))
  /\ says (published st).
Proof.
  destruct (opens_all _ take (Boxes.prunable nat found limit beam)
    (Walk.plan the_others [Boxes.cell_of nat beam a_tree]) ([], start)) as (taken & st & W); exists taken, st; split; [exact W|].
  refine (of_the_search Main.bounding_volumes_as_they_run beam the_others a_tree taken st beam_is_the_ray the_others_are none_starts
    _ _ W).
  - constructor; [intros e [] | intros c [<- | []]]; constructor; [intros e [<- | []]; now left | intros c []].
  - intros e He N; rewrite (the_sphere_is e He N).
    apply Boxes.under_node with (Boxes.Leaf nat [1%nat]); [now left | constructor; now left | exact the_sphere_is_in_its_box].
Qed.

(** A node with a node below it, in which the sphere and an empty place are. *)
Notation the_box := (Wide.outwards around_the_sphere).
Definition places : list (Wide.box32 * Wide.wide nat) :=
  [(the_box, Wide.Node nat [(the_box, Wide.Element nat 1%nat); (the_box, Wide.Nothing nat)])].
Lemma the_box_is_finite : Wide.finite the_box.
Proof. repeat split; vm_compute; reflexivity. Qed.
Theorem instance_of_eight_wide_nodes_as_they_run : exists taken st,
  walks (Wide.prunable nat found limit beam) (Walk.plan the_others (Wide.cells_of nat beam places), ([], start)) ([], (taken, st))
  /\ says (published st).
Proof.
  destruct (opens_all _ take (Wide.prunable nat found limit beam)
    (Walk.plan the_others (Wide.cells_of nat beam places)) ([], start)) as (taken & st & W); exists taken, st; split; [exact W|].
  refine (of_the_search Main.eight_wide_nodes_as_they_run beam (fun _ => around_the_sphere) the_others places taken st beam_is_the_ray
    beam_is_asked the_others_are none_starts _ _ _ W).
  - apply Forall_cons; [|apply Forall_nil]; apply Walk.lists_from_cell; [intros e [] | intros c [<- | [<- | []]]];
      apply Walk.lists_from_cell; solve [intros c [] | intros e [<- | []]; now left].
  - intros e He N; rewrite (the_sphere_is e He N); split; [exact the_sphere_is_in_its_box|].
    eapply Wide.lies_below; [now left|]; eapply Wide.lies_below; [now left | constructor].
  - intros c a [[= <- <-] | []]; constructor; [exact the_box_is_finite|]; intros d b [[= <- <-] | [[= <- <-] | []]].
    + split; [exact (Wide.nested_element nat (fun _ => around_the_sphere) 1%nat the_box_is_finite)|]; intros _; repeat split; apply Rle_refl.
    + split; [constructor | intros N; now destruct N].
Qed.

(** A shadow ray, in the same tree: the walk ends when something blocks. *)
Notation blocks := (Occlusion.blocks nat Running.finding reach_of in_range triage stable).
Notation blocks_segment := (Occlusion.blocks_segment nat Running.finding reach_of in_range triage stable low high).
Definition once_blocked (b : bool) (c : Walk.cell nat) : Prop := b = true.
Notation shadow take b := (exists taken, Walk.walks nat bool Nat.eq_dec (Occlusion.take nat take) once_blocked
  (Walk.plan the_others [Boxes.cell_of nat beam a_tree], ([], false)) ([], (taken, b))).
Theorem instance_of_the_answer_to_a_shadow_ray_is_the_texts : exists b b1,
  shadow blocks b /\ shadow blocks_segment b1 /\ (b = true <-> occluded s ray en) /\ (b1 = true <-> occluded_segment s ray en).
Proof.
  destruct (opens_all _ (Occlusion.take nat blocks) once_blocked (Walk.plan the_others [Boxes.cell_of nat beam a_tree]) ([], false))
    as (taken & b & W).
  destruct (opens_all _ (Occlusion.take nat blocks_segment) once_blocked (Walk.plan the_others [Boxes.cell_of nat beam a_tree])
    ([], false)) as (taken1 & b1 & W1).
  destruct (Main.the_answer_to_a_shadow_ray_is_the_texts nat Nat.eq_dec 2%Z s en p v eq_refl the_seven_are_a_scene elements shape_at on
    (is_described on) Running.finding in_range triage stable improved Running.near low high Recorded.less rounded round_exact
    (they_are_right _ _ _ right) once_blocked once_blocked the_others [Boxes.cell_of nat beam a_tree] taken b taken1 b1) as [A A1].
  1-2: intros c e t N; discriminate N.
  - exact the_others_are.
  - apply Forall_cons; [|apply Forall_nil]; apply Walk.lists_from_cell; [intros e [] | intros c [<- | []]];
      apply Walk.lists_from_cell; solve [intros c [] | intros e [<- | []]; now left].
  - intros e t He N M; rewrite (the_sphere_is e He N) in *; eexists; split; [now left|].
    apply (Chain.met_of_another nat s ray en 1%nat t) in M; [destruct M as [Pos M] | intros K; discriminate K].
    rewrite <- beam_is_the_ray in M; apply (Boxes.under_leads nat beam (puntos_de_elemento s)); [|exact Pos | exact M].
    apply Boxes.under_node with (Boxes.Leaf nat [1%nat]); [now left | constructor; now left | exact the_sphere_is_in_its_box].
  - exists b, b1; split; [now exists taken | split; [now exists taken1 | split; [exact (A W) | exact (A1 W1)]]].
Qed.

(** ** Trees and a grid *)

Lemma half_in_range low n : (-150 <= low <= -100)%Z -> small n = true -> Crossings.in_range low (- low) (half n).
Proof.
  intros L H; split; [now apply half_is|]; rewrite (proj2 (half_is n H)).
  destruct (small_is_ordinary n H) as [_ [Z0 | [A B]]]; [now left | right; split].
  - apply Rle_trans with (2 := A), bpow_le; lia.
  - apply Rle_trans with (1 := B), bpow_le; lia.
Qed.
Lemma half_usable n : small n = true -> Crossings.usable64 (half n).
Proof. intros H; apply (half_in_range (-150)); [lia | exact H]. Qed.

Lemma beam_in_order : Crossings.ordinary (Leaves.p_of beam) (Leaves.v_of beam).
Proof. intros []; split; (apply (half_in_range (-150)) || apply (half_in_range (-100))); (lia || reflexivity). Qed.

Notation corner := (fun _ : Acceleration.axis => half (-6)).
Notation far := (fun _ : Acceleration.axis => half 7).
Notation lists := (fun _ : nat => [1%nat]).
Lemma the_sphere_is_listed holds e : In e elements -> ~ In e the_others ->
  Leaves.listed_by nat s nat lists around_the_sphere corner far holds e.
Proof.
  intros He N w Hw; rewrite (the_sphere_is e He N) in *; apply the_sphere_is_in_its_box in Hw; split; [exact Hw|].
  split; [|intros n _; now left]; destruct Hw as (X & Y & Z0); revert X Y Z0; unfold around_the_sphere.
  cbn [Boxes.low_x Boxes.high_x Boxes.low_y Boxes.high_y Boxes.low_z Boxes.high_z].
  rewrite !(fun n H => proj2 (half_is n H)) by reflexivity; unfold over; intros X Y Z0 []; cbn [Chain.along]; lra.
Qed.

Notation line := (Crossings.line64 (Leaves.p_of beam) (Leaves.v_of beam) beam_in_order).
Definition an_octree : Trees.eighths _ _ line nat :=
  Trees.Node _ _ line nat (fun _ => half 0) (fun _ _ _ => Trees.Eighth _ _ line nat 0%nat).
Definition instance_of_octrees_as_they_run := Main.octrees_as_they_run nat 2 s en p v elements Running.finding beam beam_in_order nat lists
  around_the_sphere corner far the_others an_octree beam_is_the_ray (fun _ => half_usable (-6) eq_refl) (fun _ => half_usable 7 eq_refl)
  (conj (fun _ => half_usable 0 eq_refl) (fun _ _ _ => I)) none_starts (the_sphere_is_listed _).
Definition a_tree_of_planes : Trees.halved _ _ line nat :=
  Trees.Halved _ _ line nat Acceleration.X (half 0) (Trees.Whole _ _ line nat 0%nat) (Trees.Whole _ _ line nat 1%nat).
Definition instance_of_bsp_trees_as_they_run := Main.bsp_trees_as_they_run nat 2 s en p v elements Running.finding beam beam_in_order nat
  lists around_the_sphere corner far the_others a_tree_of_planes beam_is_the_ray (fun _ => half_usable (-6) eq_refl)
  (fun _ => half_usable 7 eq_refl) (conj (half_usable 0 eq_refl) (conj I I)) none_starts (the_sphere_is_listed _).

(** One cube, from -4 to 4 along each axis. *)
Notation least := (fun _ : Acceleration.axis => -4).
Notation one_cube := (fun _ : Acceleration.axis => 1%Z).
Notation first_cube := (fun _ : Acceleration.axis => 0%Z).
Ltac by_axis := unfold Lattice.out, Lattice.backwards, Moments.crossing, Lattice.plane; cbn; unfold over; cbn;
  repeat match goal with
  | |- context [Rlt_dec ?a ?b] => destruct (Rlt_dec a b); try (exfalso; lra)
  | |- context [Req_EM_T ?a ?b] => destruct (Req_EM_T a b); try (exfalso; lra)
  end.

Notation gp := (fun i => Chain.along (Rayo_p ray) i).
Notation gv := (fun i => Chain.component (Rayo_v ray) i).
Lemma enters_the_cube : Lattice.way_in gp gv least 8 one_cube (1, false).
Proof.
  assert (Start : forall i, i <> Acceleration.X -> Moments.between gp gv (fun j => Lattice.plane least 8 j 0)
    (fun j => Lattice.plane least 8 j 1) i Moments.start).
  { intros [] N; [now destruct N | |]; unfold Moments.between, Moments.above, Moments.at_; split; by_axis; lra. }
  assert (Enters : Moments.enters gp gv (fun j => Lattice.plane least 8 j 0) (fun j => Lattice.plane least 8 j 1) Acceleration.X (1, false)).
  { right; left; split; [unfold Moments.above, Moments.at_; by_axis; lra | by_axis; do 2 f_equal; lra]. }
  split; [|split; [right; exists Acceleration.X; exact Enters|]].
  - intros []; [exists (1, false); split; [exact Enters|] | |]; try (exists Moments.start; split; [left; split; [now apply Start | reflexivity]|]);
      unfold Moments.before; cbn; intros [K | (K & N & N1)]; (lra || discriminate).
  - unfold Moments.before; cbn; intros [K | (K & N & N1)]; (lra || discriminate).
Qed.
Lemma is_in_the_cube : Lattice.in_cell gp gv least 8 first_cube (1, false).
Proof. intros []; unfold Lattice.in_place, Moments.above, Moments.at_; split; by_axis; lra. Qed.
Lemma leaves_the_cube : Lattice.path gp gv least 8 one_cube (1, false) first_cube [((1, false), first_cube)].
Proof.
  assert (Out : Lattice.out gp gv least 8 Acceleration.X 0 = Some (3, false)) by (by_axis; do 2 f_equal; lra).
  apply Lattice.path_ends with (3, false) Acceleration.X; [split; [exists Acceleration.X; exact Out|] | exact Out|].
  - intros [] o; by_axis; intros [= <-]; unfold Moments.before; cbn; intros [K | (K & N & N1)]; (lra || discriminate).
  - unfold Lattice.on, Lattice.backwards; by_axis; lia.
Qed.
Definition in_the_box (t : R) : Prop := Boxes.holds around_the_sphere (Puntos.point_at ray t).
Lemma the_cube_holds_the_sphere e t : In e elements -> ~ In e the_others -> puntos_de_elemento s e (Puntos.point_at ray t) ->
  in_the_box t /\ Lattice.in_box gp gv least 8 one_cube (t, false)
  /\ forall d, Lattice.in_range one_cube d -> Grid.in_cube gp gv least 8 d t -> In e [1%nat].
Proof.
  intros He N Hw; rewrite (the_sphere_is e He N) in *; apply the_sphere_is_in_its_box in Hw; split; [exact Hw|].
  split; [|intros; now left]; revert Hw; unfold Boxes.holds, around_the_sphere.
  cbn [Boxes.low_x Boxes.high_x Boxes.low_y Boxes.high_y Boxes.low_z Boxes.high_z].
  rewrite !(fun n H => proj2 (half_is n H)) by reflexivity; cbn; unfold over; intros (X & Y & Z0).
  intros []; unfold Moments.between, Moments.above, Moments.at_; split; by_axis; lra.
Qed.
Definition instance_of_grids_as_they_run := Main.grids_as_they_run nat 2 s en p v elements Running.finding least 8 one_cube
  (fun _ => [1%nat]) in_the_box the_others (1, false) first_cube [((1, false), first_cube)] (IZR_lt 0 8 eq_refl) none_starts
  the_cube_holds_the_sphere enters_the_cube is_in_the_cube (fun _ => conj (Z.le_refl 0) eq_refl) leaves_the_cube.

(** ** The triage *)

Definition triage_of (e : nat) (x : Limits.binary64) : Search.verdict (Formas.known R) :=
  Triage.verdict_of (Recorded.answer_up_to (Triage.alone_of (real p) (real v) (shapes e) (on e)) x).
Lemma the_triage_is_that e x : In e elements -> true = true ->
  exists a, Triage.answered (Triage.alone_of (real p) (real v) (shapes e) (on e)) x a /\ triage_of e x = Triage.verdict_of a.
Proof.
  intros He _; eexists; split; [|reflexivity]; apply Recorded.answered_up_to; pose proof (all_in_range _ _ _ right e He eq_refl) as [O Sh].
  apply Reached.steps_settle.
  - exact (Triage.ray_fits (real p) (real v) Instances.is_a_ray O).
  - exact (Triage.stands_fit nat s the_seven_are_a_scene e _ (proj1 (over_two on e He)) Sh).
Qed.
Definition instance_of_the_triage_says_nothing_false := Main.the_triage_says_nothing_false nat s en (real p) (real v) the_seven_are_a_scene
  Instances.is_a_ray elements shapes on in_range triage_of (over_two on) (all_in_range _ _ _ right) the_triage_is_that.
