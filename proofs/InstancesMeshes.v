(** * InstancesMeshes: the theorems about meshes, on two triangles that share an edge and on a tetrahedron

    An element is a list of numbers here, and the name of a face its number before the mesh's name: no two faces have one.

    names               == that function
    two_faces           == the mesh of the unit square, cut along a diagonal *)
From Coq Require Import Reals List Lia Lra.
From Durero Require Import Toolkit Especificacion Escena Malla.
From Durero Require Auditoria VolumeOfMesh Pieces Meshes MeshClaims MainMeshes.
Import ListNotations.
Local Open Scope R_scope.
Local Open Scope zed_scope.

Definition names : rel (list nat * nat) (list nat) := fun p => snd p = snd (fst p) :: fst (fst p).
Lemma names_are_of_one_face : nombre_cara_def_1 (list nat) names.
Proof.
  split.
  - intros [m n] e e' H H'. unfold names in *. cbn in *. congruence.
  - intros e [m n] [m' n'] H H'. unfold names, inverse in *. cbn in *. congruence.
Qed.

Definition two_faces : Red :=
  mk_Red [mk_Punto 0 0 0; mk_Punto 1 0 0; mk_Punto 1 1 0; mk_Punto 0 1 0] [mk_Cara 0 1 2; mk_Cara 0 2 3].

Lemma face_of_two c : c ∈ ran (numbered (caras two_faces)) -> c = mk_Cara 0 1 2 \/ c = mk_Cara 0 2 3.
Proof.
  intros [n H]. unfold numbered in H. cbn in H. destruct n as [| [| n]]; cbn in H; [left; congruence | right; congruence |].
  destruct n; discriminate.
Qed.
Lemma two_faces_are_a_mesh : two_faces ∈ Malla.
Proof.
  split.
  - intros c H i Hi. apply dom_numbered. unfold below. cbn.
    apply face_of_two in H as [-> | ->]; destruct Hi as [[-> | ->] | ->]; cbn; lia.
  - intros c H. apply face_of_two in H as [-> | ->].
    + exists (mk_Terna (mk_Punto 0 0 0) (mk_Punto 1 0 0) (mk_Punto 1 1 0)). split; [now split |].
      unfold Vertices; cbn. lra.
    + exists (mk_Terna (mk_Punto 0 0 0) (mk_Punto 1 1 0) (mk_Punto 0 1 0)). split; [now split |].
      unfold Vertices; cbn. lra.
Qed.
Lemma two_faces_have_names : nameable (list nat) names [] two_faces.
Proof. split; [exact two_faces_are_a_mesh |]. intros n _. now exists [n]. Qed.

(** Beside the first scene there is one with these two triangles. *)
Lemma two_faces_are_added : exists S S', Init_Mallas (list nat) names S
  /\ Agregar_Malla (list nat) names S S' [] two_faces malla_agregada /\ exists abc, ([0%nat], abc) ∈ mi_vertices (escena _ S').
Proof.
  destruct (MeshClaims.a_first_scene_with_meshes_exists (list nat) names) as [S I].
  exists S, (Meshes.replaced (list nat) names S [] two_faces). split; [exact I |]. split.
  - apply (Meshes.Agregar_Malla_computed (list nat) names names_are_of_one_face).
    split; [| split; [apply Meshes.Mallas_eq_refl | reflexivity]].
    split; [apply I |]. split.
    + intros [r Hr]. now apply (Init_Mallas_post_1 _ _ _ I) in Hr.
    + split; [exact two_faces_have_names |]. intros e. split; [| intros []]. intros [_ He].
      apply (Init_post_1 (Init_Mallas_Init _ _ _ I)) in He. exact He.
  - exists (mk_Terna (mk_Punto 0 0 0) (mk_Punto 1 0 0) (mk_Punto 1 1 0)). right.
    exists 0%nat, (mk_Cara 0 1 2). now split.
Qed.

Definition instance_of_the_conjectures_of_meshes_hold :=
  conj two_faces_are_added (MainMeshes.the_conjectures_of_meshes_hold (list nat) names names_are_of_one_face).

(** No element of these two scenes stands apart from the meshes, before the mesh is added and after. *)
Theorem instance_of_meshes_stand_apart_from_the_other_elements : exists S S', Init_Mallas (list nat) names S
  /\ Agregar_Malla (list nat) names S S' [] two_faces malla_agregada
  /\ Especificacion.Escena_ok (sueltas (list nat) names S')
  /\ Escena_eq (sueltas (list nat) names S) (sueltas (list nat) names S').
Proof.
  destruct two_faces_are_added as [S [S' [I [A _]]]].
  destruct (MainMeshes.meshes_stand_apart_from_the_other_elements (list nat) names names_are_of_one_face)
    as (scene & _ & _ & added & _).
  exists S, S'. split; [exact I | split; [exact A | split]].
  - apply scene. apply A.
  - exact (added _ _ _ _ _ A).
Qed.

(** The plane x = y has the one triangle on the one side, and the other on the other; their common edge lies on it. *)
Lemma the_first_lies_before i p : i ∈ Auditoria.esquinas (mk_Cara 0 1 2) -> (i, p) ∈ numbered (puntos two_faces) ->
  Auditoria.along (mk_Punto (-1) 1 0) p <= 0 /\
  (i ∉ Auditoria.esquinas (mk_Cara 0 2 3) -> Auditoria.along (mk_Punto (-1) 1 0) p < 0).
Proof.
  intros [[-> | ->] | ->] H; injection H as <-; unfold Auditoria.along; cbn; (split; [lra |]); intros N.
  - destruct N. now left; left.
  - lra.
  - destruct N. now left; right.
Qed.
Lemma the_second_lies_behind i p : i ∈ Auditoria.esquinas (mk_Cara 0 2 3) -> (i, p) ∈ numbered (puntos two_faces) ->
  0 <= Auditoria.along (mk_Punto (-1) 1 0) p.
Proof. intros [[-> | ->] | ->] H; injection H as <-; unfold Auditoria.along; cbn; lra. Qed.

Definition instance_of_faces_that_a_plane_parts_do_not_cross :=
  MainMeshes.faces_that_a_plane_parts_do_not_cross two_faces 0 1 (mk_Cara 0 1 2) (mk_Cara 0 2 3) (mk_Punto (-1) 1 0) 0
    eq_refl eq_refl the_first_lies_before the_second_lies_behind.

(** The tetrahedron between the origin and the three unit points is closed, and its volume is a sixth, wherever it is. *)
Definition tetrahedron : Red :=
  mk_Red [mk_Punto 0 0 0; mk_Punto 1 0 0; mk_Punto 0 1 0; mk_Punto 0 0 1]
    [mk_Cara 0 2 1; mk_Cara 0 1 3; mk_Cara 1 2 3; mk_Cara 0 3 2].
Notation walks := (VolumeOfMesh.walks tetrahedron).

Definition ways : list (nat * nat * nat) :=
  [(0, 0, 2); (0, 2, 1); (0, 1, 0); (1, 0, 1); (1, 1, 3); (1, 3, 0); (2, 1, 2); (2, 2, 3); (2, 3, 1); (3, 0, 3); (3, 3, 2); (3, 2, 0)]%nat.
Lemma ways_of_faces n i j : walks n i j <-> In (n, i, j) ways.
Proof.
  split.
  - intros [c [N [E | [E | E]]]]; unfold numbered in N; cbn in N;
      (destruct n as [| [| [| [| n]]]]; cbn in N; [injection N as <- .. | destruct n; discriminate]);
      cbn in E; injection E as -> ->; cbn; tauto.
  - cbn. intros H. repeat destruct H as [H | H]; try contradiction; injection H as <- <- <-;
      (eexists; split; [reflexivity |]); unfold Auditoria.aristas; cbn; tauto.
Qed.
Lemma one_way_once m n i j : walks m i j -> walks n i j -> m = n.
Proof.
  rewrite !ways_of_faces. cbn. intros H H'.
  repeat destruct H as [H | H]; try contradiction; injection H as <- <- <-;
    repeat destruct H' as [H' | H']; try contradiction; congruence.
Qed.
Lemma each_way_back n i j : walks n i j -> exists m, m <> n /\ walks m j i.
Proof.
  rewrite ways_of_faces. cbn. intros H.
  repeat destruct H as [H | H]; try contradiction; injection H as <- <- <-;
    first [now exists 0%nat; split; [discriminate | apply ways_of_faces; cbn; tauto]
          | now exists 1%nat; split; [discriminate | apply ways_of_faces; cbn; tauto]
          | now exists 2%nat; split; [discriminate | apply ways_of_faces; cbn; tauto]
          | now exists 3%nat; split; [discriminate | apply ways_of_faces; cbn; tauto]].
Qed.
Lemma the_tetrahedron_is_closed : VolumeOfMesh.abiertas tetrahedron ≡ ∅.
Proof.
  intros [i j]. split; [| intros []]. intros [_ [n H]]. cbn in H.
  destruct (proj2 (H n) eq_refl) as [W | W]; destruct (each_way_back _ _ _ W) as [m [D B]];
    apply D, H; [now right | now left].
Qed.
Lemma the_tetrahedron_agrees : VolumeOfMesh.discordes tetrahedron ≡ ∅.
Proof.
  intros [i j]. split; [| intros []]. intros [_ [m [n [D [W W']]]]]. exact (D (one_way_once _ _ _ _ W W')).
Qed.
Lemma the_tetrahedron_has_all_its_points : tetrahedron ∈ Completa.
Proof.
  intros c [n H] i Hi. apply dom_numbered. unfold below; cbn. unfold numbered in H; cbn in H.
  destruct n as [| [| [| [| n]]]]; cbn in H; [injection H as <- .. | destruct n; discriminate];
    destruct Hi as [[-> | ->] | ->]; cbn; lia.
Qed.
Lemma the_volume_is_a_sixth : VolumeOfMesh.volumen tetrahedron (1 / 6).
Proof.
  apply VolumeOfMesh.volumen_is_total. split.
  - exact the_tetrahedron_has_all_its_points.
  - cbn. unfold VolumeOfMesh.det_of, VolumeOfMesh.det, Auditoria.determinante; cbn. lra.
Qed.

Definition instance_of_a_closed_mesh_has_one_volume :=
  MainMeshes.a_closed_mesh_has_one_volume (mk_Punto 1 2 3) tetrahedron (1 / 6) the_tetrahedron_is_closed
    the_tetrahedron_agrees the_volume_is_a_sixth.

(** Each edge of the tetrahedron has two faces, so that it bounds something; none of the two faces of the square is
    degenerate. *)
Lemma the_tetrahedron_is_a_mesh : tetrahedron ∈ Malla.
Proof.
  split; [exact the_tetrahedron_has_all_its_points |]. intros c [n H]; unfold numbered in H; cbn in H.
  - assert (T : forall i j k p q t, nth_error (puntos tetrahedron) i = Some p -> nth_error (puntos tetrahedron) j = Some q ->
      nth_error (puntos tetrahedron) k = Some t -> terna tetrahedron (mk_Cara i j k) (mk_Terna p q t)) by (intros; now split).
    destruct n as [| [| [| [| n]]]]; cbn in H; [injection H as <- .. | destruct n; discriminate];
      (eexists; split; [apply T; reflexivity |]); unfold Vertices; cbn; lra.
Qed.
Lemma no_edge_of_it_is_multiple : Pieces.multiples tetrahedron ≡ ∅.
Proof.
  intros [i j]. split; [| intros []]. cbn. intros [_ (l & m & n & D & D' & D'' & L & M & N)].
  destruct L as [L | L], M as [M | M], N as [N | N];
    first [exact (D (one_way_once _ _ _ _ L M)) | exact (D' (one_way_once _ _ _ _ M N)) | exact (D'' (one_way_once _ _ _ _ N L))].
Qed.
Definition instance_of_what_has_neither_open_nor_multiple_edges_bounds :=
  MainMeshes.what_has_neither_open_nor_multiple_edges_bounds tetrahedron the_tetrahedron_is_a_mesh the_tetrahedron_is_closed
    no_edge_of_it_is_multiple.
Definition instance_of_a_mesh_has_no_degenerate_face :=
  MainMeshes.a_mesh_has_no_degenerate_face two_faces (proj1 two_faces_are_a_mesh).

(** The tetrahedron encloses the point whose coordinates are all a quarter. *)
Ltac is_a_corner := first [left; left; reflexivity | left; right; reflexivity | right; reflexivity].
Ltac is_no_corner H := destruct H as [[H | H] | H]; discriminate H.
Lemma no_face_of_it_stands_twice : Pieces.repetidas tetrahedron ≡ ∅.
Proof.
  intros n. split; [| intros []]. intros (m & c & d & L & C & D & E). unfold Pieces.face, numbered in C, D. cbn in C, D.
  assert (K : forall v, v ∈ Auditoria.esquinas c -> v ∈ Auditoria.esquinas d) by (intros v; apply E). clear E.
  destruct n as [| [| [| [| n]]]]; cbn in C; [injection C as <- .. | destruct n; discriminate];
    destruct m as [| [| [| m]]]; cbn in D; try lia; injection D as <-;
    first [assert (H := K 0%nat ltac:(is_a_corner)); is_no_corner H | assert (H := K 2%nat ltac:(is_a_corner)); is_no_corner H
          | assert (H := K 3%nat ltac:(is_a_corner)); is_no_corner H].
Qed.
Lemma planes_bear_the_tetrahedron n : n ∈ Pieces.faces tetrahedron -> exists d level, Enclosed.bears tetrahedron n d level
  /\ Auditoria.along d (mk_Punto (1 / 4) (1 / 4) (1 / 4)) < level.
Proof.
  intros [c C]. pose proof C as N. unfold numbered in N. cbn in N.
  destruct n as [| [| [| [| n]]]]; cbn in N; [injection N as <- .. | destruct n; discriminate];
    [exists (mk_Punto 0 0 (-1)), 0 | exists (mk_Punto 0 (-1) 0), 0 | exists (mk_Punto 1 1 1), 1 | exists (mk_Punto (-1) 0 0), 0];
    (split; [eexists; split; [exact C |] | unfold Auditoria.along; cbn; lra]);
    intros i p P; unfold numbered in P; cbn in P;
    (destruct i as [| [| [| [| i]]]]; cbn in P; [injection P as <- .. | destruct i; discriminate]);
    unfold Auditoria.along; cbn; (split; intros H; [first [lra | is_no_corner H] | first [lra | exfalso; apply H; is_a_corner]]).
Qed.
Definition instance_of_a_convex_mesh_encloses_what_lies_within :=
  MainMeshes.a_convex_mesh_encloses_what_lies_within tetrahedron (mk_Punto (1 / 4) (1 / 4) (1 / 4))
    (MainMeshes.what_has_neither_open_nor_multiple_edges_bounds tetrahedron the_tetrahedron_is_a_mesh the_tetrahedron_is_closed
      no_edge_of_it_is_multiple) no_face_of_it_stands_twice
    (ex_intro _ 0%nat (ex_intro _ (mk_Cara 0 2 1) eq_refl)) planes_bear_the_tetrahedron.

(** A face that stands twice, once each way round. *)
Definition both_ways : Red := mk_Red (puntos two_faces) [mk_Cara 0 1 2; mk_Cara 1 0 2].
Lemma both_ways_are_a_mesh : both_ways ∈ Malla.
Proof.
  assert (H : forall c, c ∈ ran (numbered (caras both_ways)) -> c = mk_Cara 0 1 2 \/ c = mk_Cara 1 0 2).
  { intros c [n H]. unfold numbered in H. cbn in H. destruct n as [| [| n]]; cbn in H; [left; congruence | right; congruence |].
    destruct n; discriminate. }
  split; intros c C; apply H in C as [-> | ->].
  1, 2: intros i Hi; apply dom_numbered; unfold below; cbn; destruct Hi as [[-> | ->] | ->]; cbn; lia.
  - exists (mk_Terna (mk_Punto 0 0 0) (mk_Punto 1 0 0) (mk_Punto 1 1 0)). split; [now split |]. unfold Vertices; cbn. lra.
  - exists (mk_Terna (mk_Punto 1 0 0) (mk_Punto 0 0 0) (mk_Punto 1 1 0)). split; [now split |]. unfold Vertices; cbn. lra.
Qed.
Lemma the_second_stands_twice : 1%nat ∈ Pieces.repetidas both_ways.
Proof.
  exists 0%nat, (mk_Cara 1 0 2), (mk_Cara 0 1 2). split; [lia |]. split; [reflexivity |]. split; [reflexivity |].
  intros i. cbn. unfold Auditoria.esquinas, corners_of, union, single; cbn. tauto.
Qed.
Definition instance_of_a_face_that_stands_twice_shares_its_edges :=
  MainMeshes.a_face_that_stands_twice_shares_its_edges both_ways 1 both_ways_are_a_mesh the_second_stands_twice.

(** The middle of a side of one face is a corner of another. *)
Definition junction : Red := mk_Red [mk_Punto 0 0 0; mk_Punto 2 0 0; mk_Punto 0 1 0; mk_Punto 1 0 0; mk_Punto 1 (-1) 0]
  [mk_Cara 0 1 2; mk_Cara 0 3 4].
Lemma the_middle_of_a_side_is_a_junction : (3%nat, 0%nat, 1%nat) ∈ Pieces.uniones_en_t junction.
Proof.
  split; [lia |]. split; [exists 0%nat; left; exists (mk_Cara 0 1 2); split; [reflexivity | now left] |].
  split; [exists 1%nat, (mk_Cara 0 3 4); split; [reflexivity | left; now right] |].
  exists (mk_Punto 0 0 0), (mk_Punto 2 0 0), (mk_Punto 1 0 0). repeat (split; [reflexivity |]).
  split; [intros [= H]; lra |]. exists (1 / 2). unfold Rmas; cbn. repeat split; lra.
Qed.
Definition instance_of_a_junction_lies_on_a_face_of_its_edge :=
  MainMeshes.a_junction_lies_on_a_face_of_its_edge junction 3 0 1 the_middle_of_a_side_is_a_junction.
