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
From Durero Require Slab Boxes Wide Walk Limits Search Chain Occlusion Whole Triage Running Recorded Flotante Vectors Formas
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
