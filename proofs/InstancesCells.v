(** * InstancesCells: the theorems of acceleration, on the seven shapes

    Each tree splits space between the sphere and the rest, at x = 5, and its test is of one plane: that suffices to be
    conservative, and to skip cells. Each traversal finds the sphere, at the parameter of the oracle.

    box_entry, region_entry == the parameter at which the low x of a box, or the plane that was crossed last, is reached
    volumes, eighths, halves, path == a tree of boxes, an octree, a tree of planes, and the cells of a grid *)
From Coq Require Import Reals List Lra.
From Durero Require Import Toolkit Especificacion Exacto InstanceScene InstanceSearch InstancesHits.
From Durero Require Recorrido Firsts Acceleration MainModels.
Import ListNotations.
Import Acceleration(axis, X, Y, Z).
Local Open Scope R_scope.

(** ** The tests *)

Definition box_entry (b : Acceleration.box) : option first :=
  if Rle_dec (Acceleration.low b X) (- 8) then Some None else Some (Some ((Acceleration.low b X + 8) / 4)).
Lemma box_entry_is_conservative b : Acceleration.conservative first le the_point (Acceleration.inside b) (box_entry b).
Proof.
  intros t H; specialize (H X); unfold box_entry; destruct Rle_dec as [L | L]; [exists None; now split|].
  destruct t as [t |]; cbn in H; unfold over in H; cbn in H; [|lra].
  eexists; split; [reflexivity | apply Firsts.le_some; lra].
Qed.

Notation along q := (Acceleration.normal q X * 4 + Acceleration.normal q Y * (1 / 2) - Acceleration.normal q Z * (1 / 2)).
Definition region_entry (r : Acceleration.region) : option first :=
  match r with
  | (q, true) :: _ =>
      if Rlt_dec 0 (along q) then
        if Rlt_dec (Acceleration.height q (the_point None)) 0 then Some (Some (- Acceleration.height q (the_point None) / along q))
        else Some None
      else Some None
  | _ => Some None
  end.
Lemma region_entry_is_conservative r : Acceleration.conservative first le the_point (Acceleration.in_region r) (region_entry r).
Proof.
  intros t H; unfold region_entry; destruct r as [| [q []] r]; try (exists None; now split).
  do 2 (destruct Rlt_dec; [|exists None; now split]).
  specialize (H q true (or_introl eq_refl)); cbn [Acceleration.side] in H; destruct t as [t |]; [|lra].
  eexists; split; [reflexivity | apply Firsts.le_some].
  apply Rmult_le_reg_r with (along q); [assumption|].
  replace (- Acceleration.height q (the_point None) / along q * along q) with (- Acceleration.height q (the_point None)) by (field; lra).
  assert (E : Acceleration.height q (the_point (Some t)) = Acceleration.height q (the_point None) + t * along q); [|lra].
  unfold Acceleration.height; cbn; unfold over; lra.
Qed.

(** ** The traversals *)

Notation walks cs best := (Recorrido.walks first le nat hit_of (Recorrido.entered_beyond first le nat) (cs, None) ([], best)).
Notation first_hit es best := (Recorrido.first_hit first le nat hit_of es best).
Notation lists_from := (Recorrido.lists_from first nat).
Notation ended cs := (MainModels.every_walk_can_end first le nat hit_of (Recorrido.entered_beyond first le nat) cs None).
Lemma with_the_first es best : incl es elements -> In 1%nat es -> first_hit es best -> first_hit es best /\ found_first best.
Proof. intros All One H; split; [exact H | exact (the_sphere_is_first es best All One H)]. Qed.
Ltac listed := repeat (constructor; [intros e He; cbn in He |- *; tauto|]; intros c Hc; cbn in Hc;
  repeat destruct Hc as [<- | Hc]; try contradiction).

Definition volumes : Acceleration.bvh nat :=
  Acceleration.BvhNode _ around_all [Acceleration.BvhLeaf _ around_the_sphere [1%nat];
    Acceleration.BvhNode _ beyond [Acceleration.BvhLeaf _ around_the_cylinder [2%nat]; Acceleration.BvhLeaf _ around_the_disc [6%nat]]].
Notation volumes_cell := (Acceleration.bvh_cell first nat box_entry volumes).
Lemma volumes_list : lists_from bounded volumes_cell.
Proof. listed. Qed.
Lemma beyond_holds e w : In e [2; 6]%nat -> surface e w -> Acceleration.inside beyond w.
Proof.
  intros He H i; cbn in He; decompose [or] He; subst; try contradiction;
    [pose proof (cylinder_there w H i) | pose proof (disc_there w H i)]; destruct i; cbn in *; lra.
Qed.
Lemma volumes_hold e : In e bounded -> Acceleration.under nat surface e volumes.
Proof.
  intros He; pose proof (fun w => inside_all e w He) as All; cbn in He; decompose [or] He; subst; try contradiction.
  - eapply Acceleration.under_node; [now left | | exact All].
    apply Acceleration.under_leaf; [now left | exact sphere_there].
  - eapply Acceleration.under_node; [right; now left | | exact All].
    eapply Acceleration.under_node; [now left | | intros w; apply beyond_holds; now left].
    apply Acceleration.under_leaf; [now left | exact cylinder_there].
  - eapply Acceleration.under_node; [right; now left | | exact All].
    eapply Acceleration.under_node; [right; now left | | intros w; apply beyond_holds; right; now left].
    apply Acceleration.under_leaf; [now left | exact disc_there].
Qed.
Theorem instance_of_bounding_volumes_find_the_first_hit : exists best, walks [volumes_cell] best /\ first_hit bounded best /\ found_first best.
Proof.
  destruct (ended [volumes_cell]) as [best W].
  exists best; split; [exact W | apply with_the_first; [intros e He; cbn in He |- *; tauto | now left |]].
  exact (MainModels.bounding_volumes_find_the_first_hit first le total trans antisym nat hit_of the_point surface hits_on_surface
    box_entry box_entry_is_conservative bounded volumes best volumes_list volumes_hold W).
Qed.

(** And whatever rule skips cells, here the same, over the same cells. *)
Lemma volumes_lead : Recorrido.reachable first le nat hit_of bounded [volumes_cell].
Proof.
  intros e t He Ht; exists volumes_cell; split; [now left|].
  exact (Acceleration.bvh_leads first le nat hit_of the_point surface hits_on_surface box_entry box_entry_is_conservative e t volumes Ht
    (volumes_hold e He)).
Qed.
Theorem instance_of_every_traversal_finds_the_first_hit : exists best, walks [volumes_cell] best /\ first_hit bounded best /\ found_first best.
Proof.
  destruct (ended [volumes_cell]) as [best W].
  exists best; split; [exact W | apply with_the_first; [intros e He; cbn in He |- *; tauto | now left |]].
  exact (MainModels.every_traversal_finds_the_first_hit first le total trans antisym nat hit_of _ bounded [volumes_cell] best
    (Recorrido.entered_beyond_right first le trans nat hit_of) (Forall_cons _ volumes_list (Forall_nil _)) volumes_lead W).
Qed.

Definition eighths : Acceleration.octree nat :=
  Acceleration.OctNode _ (coordinates (mk_Punto 5 0 0)) (fun x y z => Acceleration.OctLeaf _ (if x then [2; 6]%nat else [1%nat])).
Notation eighths_cell := (Acceleration.oct_cell first nat box_entry around_all eighths).
Lemma eighths_list : lists_from bounded eighths_cell.
Proof. listed. Qed.
Lemma eighths_hold : Acceleration.oct_listed nat surface bounded around_all eighths.
Proof.
  constructor; intros x y z; constructor; intros e w He H In_; specialize (In_ X).
  assert (Flat : In e flat) by (cbn in He |- *; tauto); pose proof (split_at_five e w Flat H) as S.
  cbn in He; decompose [or] He; subst; try contradiction; destruct x; cbn in *; tauto || lra.
Qed.
Theorem instance_of_octrees_find_the_first_hit : exists best, walks [eighths_cell] best /\ first_hit bounded best /\ found_first best.
Proof.
  destruct (ended [eighths_cell]) as [best W].
  exists best; split; [exact W | apply with_the_first; [intros e He; cbn in He |- *; tauto | now left |]].
  exact (MainModels.octrees_find_the_first_hit first le total trans antisym nat hit_of the_point surface hits_on_surface
    box_entry box_entry_is_conservative bounded around_all eighths best eighths_list eighths_hold inside_all W).
Qed.

Definition halves : Acceleration.bsp nat :=
  Acceleration.BspNode _ (Acceleration.Plane (coordinates (mk_Punto 1 0 0)) 5) (Acceleration.BspLeaf _ [1%nat])
    (Acceleration.BspLeaf _ [2; 5; 6]%nat).
Notation halves_cell := (Acceleration.bsp_cell first nat region_entry [] halves).
Lemma halves_list : lists_from flat halves_cell.
Proof. listed. Qed.
Lemma halves_hold : Acceleration.bsp_listed nat surface flat [] halves.
Proof.
  constructor; constructor; intros e w He H In_; specialize (In_ _ _ (or_introl eq_refl));
    pose proof (split_at_five e w He H) as S; unfold Acceleration.side, Acceleration.height in In_;
    cbn in He; decompose [or] He; subst; try contradiction; cbn in *; tauto || lra.
Qed.
Theorem instance_of_bsp_trees_find_the_first_hit : exists best, walks [halves_cell] best /\ first_hit flat best /\ found_first best.
Proof.
  destruct (ended [halves_cell]) as [best W].
  exists best; split; [exact W | apply with_the_first; [intros e He; cbn in He |- *; tauto | now left |]].
  exact (MainModels.bsp_trees_find_the_first_hit first le total trans antisym nat hit_of the_point surface hits_on_surface
    region_entry region_entry_is_conservative flat halves best halves_list halves_hold W).
Qed.

(** Two cells of a grid, one after the other along the ray. *)
Notation stretch := (Recorrido.Stretch first nat).
Definition path : list (Acceleration.box * Recorrido.stretch first nat) := [
  (box (-8) 5 (-50) 50 (-50) 50, stretch None (Some (13 / 4)) [1%nat]);
  (box 5 40 (-50) 50 (-50) 50, stretch (Some (13 / 4)) (Some 12) [2; 5; 6]%nat)].
Lemma path_lists : Forall (fun c => incl (Recorrido.listed first nat c) flat) (map snd path).
Proof. apply Forall_cons; [|apply Forall_cons; [|apply Forall_nil]]; intros e He; cbn in He |- *; tauto. Qed.
Lemma path_in_order : Recorrido.in_order first le nat (map snd path).
Proof.
  cbn -[le]; repeat split; intros; try tauto; try (apply Firsts.le_some; lra).
  destruct H as [<- | []]; apply Firsts.le_some; cbn; lra.
Qed.
Lemma path_holds b c : In (b, c) path -> Acceleration.lists_box first nat surface flat b c.
Proof.
  intros Hc e w He H In_; specialize (In_ X); pose proof (split_at_five e w He H) as S.
  destruct Hc as [[= <- <-] | [[= <- <-] | []]]; cbn in He; decompose [or] He; subst; try contradiction; cbn in *; tauto || lra.
Qed.
Lemma path_covers e t : In e flat -> hit_of e = Some t -> exists b c, In (b, c) path /\ Acceleration.inside b (the_point t) /\
  le (Recorrido.t_in first nat c) t = true /\ le t (Recorrido.t_out first nat c) = true.
Proof.
  intros He Ht; destruct (a_hit e t Ht) as (x & -> & Hpos & On); pose proof (split_at_five e _ He On) as S.
  cbn in S; unfold over in S; cbn in S; destruct (Nat.eqb e 1); do 2 eexists.
  - split; [now left | split; [intros []; cbn; unfold over; lra | split; [reflexivity | apply Firsts.le_some; cbn; lra]]].
  - split; [right; now left | split; [intros []; cbn; unfold over; lra | split; apply Firsts.le_some; cbn; lra]].
Qed.
Definition instance_of_grids_find_the_first_hit :=
  MainModels.grids_find_the_first_hit first le total trans antisym nat hit_of the_point surface hits_on_surface flat path
    path_lists path_in_order path_holds path_covers.
