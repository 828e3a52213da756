(** * InstanceScene: lists of named shapes as scenes, and one with all seven shapes

    Numbers are integers over S. The scene of the tests of Instances.v, and of tests/proofs/instances.json, is over 2.

    row_of S sh     == the shape as a row of the tables of Retrieve.v
    tables_of S l   == the tables of the named shapes l, each added in turn;  scene_of S l == the scene that they stand for
    seven           == one of each, along the x axis *)
From Coq Require Import ZArith Reals List Lia Lra.
From Durero Require Import Toolkit Especificacion Escena.
From Durero Require Exacto ExactoEscena Retrieve.
Import ListNotations.
Import Exacto.
Local Open Scope R_scope.
Local Open Scope zed_scope.

Section Scenes.
Variable S : Z.
Notation named := (list (nat * shape)).

Definition row_of (sh : shape) : Retrieve.Shape :=
  let n := over S in let a := point S in let d := direction S in
  match sh with
  | Sphere c r => Retrieve.Sphere (a c) (n r)
  | Cylinder c r v h => Retrieve.Cylinder (a c) (n r) (d v) (n h)
  | Cone c k v h => Retrieve.Cone (a c) (n k) (d v) (n h)
  | TruncatedCone c r k v h => Retrieve.TruncatedCone (a c) (n r) (n k) (d v) (n h)
  | Plane c v => Retrieve.Plane (a c) (d v)
  | Disc c r v => Retrieve.Disc (a c) (n r) (d v)
  | Triangle p q r => Retrieve.Triangle (vertices S p q r)
  end.

Fixpoint tables_of (l : named) : Retrieve.Tables nat :=
  match l with
  | [] => Retrieve.empty_tables nat
  | (e, sh) :: l' => Retrieve.add nat Nat.eq_dec (tables_of l') e (row_of sh)
  end.
Definition scene_of (l : named) : Escena nat := Retrieve.retrieve nat (tables_of l).

Lemma rows_of l : forall e x, Retrieve.row nat (tables_of l) e x <-> exists sh, In (e, sh) l /\ x = row_of sh.
Proof.
  induction l as [| [e' sh'] l IH]; intros e x; cbn [tables_of].
  - split; [intros (t & i & H); now destruct i | now intros (sh & [] & _)].
  - rewrite Retrieve.row_add, IH; split.
    + intros [(sh & H & ->) | [-> ->]]; [exists sh; now split; [right|] | exists sh'; now split; [left|]].
    + intros (sh & [[= -> ->] | H] & ->); [now right | left; now exists sh].
Qed.

Lemma tables_are_right l : NoDup (map fst l) -> Forall (fun a => Retrieve.valid (row_of (snd a))) l ->
  Retrieve.tables_ok nat (tables_of l).
Proof.
  induction l as [| [e sh] l IH]; intros D V; [apply Retrieve.empty_tables_Init|]; cbn [tables_of].
  inversion_clear D as [| ? ? N D']; inversion_clear V as [| ? ? Vsh Vl]; specialize (IH D' Vl).
  apply Retrieve.add_ok; [exact IH | | exact Vsh].
  destruct (Retrieve.index nat (tables_of l) e) as [[t i] |] eqn:E; [exfalso | reflexivity].
  apply (Retrieve.index_exact _ _ IH) in E as [x Hx]; assert (Hr : Retrieve.row nat (tables_of l) e x) by (now exists t, i).
  apply rows_of in Hr as (sh' & Hin & _); apply N; apply (in_map fst) in Hin; exact Hin.
Qed.

Lemma shape_in_scene l e sh : In (e, sh) l -> ExactoEscena.has_shape nat S (scene_of l) e sh.
Proof.
  intros H; assert (R0 : Retrieve.row nat (tables_of l) e (row_of sh)) by (apply rows_of; now exists sh).
  destruct sh; match type of R0 with Retrieve.row _ _ _ ?x => repeat split; exists x; (split; [exact R0 | reflexivity]) end.
Qed.

Theorem described l (en : set nat) on : (forall e sh, In (e, sh) l -> (on e = true <-> en e)) ->
  ExactoEscena.describes nat S (scene_of l) en (map (fun a => (fst a, snd a, on (fst a))) l).
Proof.
  intros Hon; split.
  - intros e; split.
    + intros [x Hx]; apply rows_of in Hx as (sh & Hin & _); exists sh, (on e); apply in_map_iff; now exists (e, sh).
    + intros (sh & o & Hin); apply in_map_iff in Hin as ([e' sh'] & [= -> -> _] & Hin); exists (row_of sh); apply rows_of; now exists sh.
  - intros e sh o Hin; apply in_map_iff in Hin as ([e' sh'] & [= -> -> <-] & Hin); split; [now apply shape_in_scene | now apply (Hon e sh)].
Qed.
End Scenes.

(** ** One of each, numbers over 2: a sphere at the origin, and the others one after the other along x *)

Notation v3 := Exacto.Vec.
Definition along_z := v3 0 0 2.
Definition along_x := v3 2 0 0.
Definition seven : list (nat * shape) := [
  (1%nat, Sphere (v3 0 0 0) 6);
  (2%nat, Cylinder (v3 16 0 (-4)) 4 along_z 8);
  (3%nat, Cone (v3 32 0 (-4)) 2 along_z 8);
  (4%nat, TruncatedCone (v3 48 0 (-4)) 2 1 along_z 8);
  (5%nat, Plane (v3 80 0 0) along_x);
  (6%nat, Disc (v3 64 0 0) 8 along_x);
  (7%nat, Triangle (v3 72 (-8) (-8)) (v3 72 8 (-8)) (v3 72 0 8)) ].

Lemma seven_once : NoDup (map fst seven).
Proof. repeat constructor; cbn; intuition discriminate. Qed.

Lemma seven_valid : Forall (fun a => Retrieve.valid (row_of 2 (snd a))) seven.
Proof.
  unfold seven, along_x, along_z; repeat (apply Forall_cons || apply Forall_nil); cbn [snd row_of Retrieve.valid];
    unfold Rmas, Unitario, Vertices, tolerancia_unidad; cbn; unfold over; repeat split; try lra; intros (? & ? & ?); lra.
Qed.

Theorem the_seven_are_a_scene : Escena_ok (scene_of 2 seven).
Proof. apply Retrieve.retrieve_ok, tables_are_right; [exact seven_once | exact seven_valid]. Qed.
