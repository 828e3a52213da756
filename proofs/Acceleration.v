(** * Acceleration: BVH, octree, BSP and grid as instances of Recorrido

    Each structure is a way to cut space into regions. For each: if an element stands in every leaf whose region it
    meets (elements may span leaves), or inside every box above it (BVH), and the test of a region never rejects a ray
    that meets it ([conservative]), then any traversal with pruning finds the first hit of all elements, ties included.

    point                 == a coordinate for each axis
    ray t                 == the point of the ray at the parameter t
    surface e w           == the point w lies on the element e
    region_entry, box_entry == what the test of a region answers: an entry bound, or none when the ray misses it
    conservative region a == the answer a is right: no point of the ray in the region comes before a
    box, inside b w       == a closed box, and its points
    octant b m x y z      == the part of b on the sides x, y, z (true: upper) of the point m
    bvh, octree, bsp      == the trees;  bvh_cell, oct_cell, bsp_cell == the cells of them that Recorrido visits *)
From Coq Require Import Reals List Bool Lra.
From Durero Require Import Recorrido.
Import ListNotations.
Local Open Scope R_scope.

Inductive axis := X | Y | Z.
Definition point := axis -> R.

Record box := Box { low : point; high : point }.
Definition inside (b : box) (w : point) : Prop := forall i, low b i <= w i <= high b i.

Section Acceleration.

Variable T : Type.
Variable le : T -> T -> bool.
Hypothesis le_total : forall a b, le a b = true \/ le b a = true.
Hypothesis le_trans : forall a b c, le a b = true -> le b c = true -> le a c = true.
Hypothesis le_antisym : forall a b, le a b = true -> le b a = true -> a = b.

Variable E : Type.
Variable hit_of : E -> option T.
Variable ray : T -> point.
Variable surface : E -> point -> Prop.
(** A hit is a point of the element. *)
Hypothesis hit_on_surface : forall e t, hit_of e = Some t -> surface e (ray t).

Local Notation cell := (cell T E).
Local Notation Cell := (Cell T E).
Local Notation leads := (leads T le E).
Local Notation walks := (walks T le E hit_of (entered_beyond T le E)).
Local Notation first_hit := (first_hit T le E hit_of).
Local Notation lists_from := (lists_from T E).

Definition conservative (region : point -> Prop) (a : option T) : Prop :=
  forall t, region (ray t) -> exists a', a = Some a' /\ le a' t = true.

Lemma first_hit_of_cell es c best : lists_from es c ->
  (forall e t, In e es -> hit_of e = Some t -> leads c e t) -> walks ([c], None) ([], best) -> first_hit es best.
Proof.
  intros Hl Hc; apply (traversal_first_hit T le le_total le_trans le_antisym E hit_of (entered_beyond T le E));
    [exact (entered_beyond_right T le le_trans E hit_of) | now constructor |].
  intros e t He Ht; exists c; split; [now left | auto].
Qed.

(** ** Bounding volume hierarchies *)

Inductive bvh := BvhLeaf (b : box) (es : list E) | BvhNode (b : box) (children : list bvh).

Variable box_entry : box -> option T.
Hypothesis box_conservative : forall b, conservative (inside b) (box_entry b).

Fixpoint bvh_cell (a : bvh) : cell :=
  match a with
  | BvhLeaf b es => Cell (box_entry b) es []
  | BvhNode b hs => Cell (box_entry b) [] (map bvh_cell hs)
  end.

Inductive under (e : E) : bvh -> Prop :=
| under_leaf b es : In e es -> (forall w, surface e w -> inside b w) -> under e (BvhLeaf b es)
| under_node b h hs : In h hs -> under e h -> (forall w, surface e w -> inside b w) -> under e (BvhNode b hs).

Lemma bvh_leads e t a : hit_of e = Some t -> under e a -> leads (bvh_cell a) e t.
Proof.
  intros Ht; induction 1 as [b es He Hb|b h hs Hh _ IH Hb];
    destruct (box_conservative b t (Hb _ (hit_on_surface e t Ht))) as (a' & Ha & Hle).
  - now apply (leads_here _ _ _ _ a').
  - apply (leads_below _ _ _ _ a' (bvh_cell h)); auto; now apply in_map.
Qed.

(** Every element lies below the root, in boxes that contain it; then any traversal gives the first hit. *)
Theorem bvh_first_hit es a best : lists_from es (bvh_cell a) -> (forall e, In e es -> under e a) ->
  walks ([bvh_cell a], None) ([], best) -> first_hit es best.
Proof. intros Hl He; apply first_hit_of_cell; auto using bvh_leads. Qed.

(** ** Octrees: elements that span leaves stand in each *)

Inductive octree := OctLeaf (es : list E) | OctNode (m : point) (children : bool -> bool -> bool -> octree).

Definition by_axis {A} (x y z : A) (i : axis) : A := match i with X => x | Y => y | Z => z end.

Definition octant (b : box) (m : point) (x y z : bool) : box :=
  {| low := fun i => if by_axis x y z i then m i else low b i;
     high := fun i => if by_axis x y z i then high b i else m i |}.

Fixpoint oct_cell (b : box) (a : octree) : cell :=
  match a with
  | OctLeaf es => Cell (box_entry b) es []
  | OctNode m h =>
      let child x y z := oct_cell (octant b m x y z) (h x y z) in
      Cell (box_entry b) []
        [child false false false; child false false true; child false true false; child false true true;
         child true false false; child true false true; child true true false; child true true true]
  end.

Inductive oct_listed (es : list E) : box -> octree -> Prop :=
| oct_listed_leaf b l : (forall e w, In e es -> surface e w -> inside b w -> In e l) -> oct_listed es b (OctLeaf l)
| oct_listed_node b m h : (forall x y z, oct_listed es (octant b m x y z) (h x y z)) -> oct_listed es b (OctNode m h).

(** The eight closed octants cover the box. *)
Lemma octants_cover b m w : inside b w -> exists x y z, inside (octant b m x y z) w.
Proof.
  intros Hw; exists (if Rle_dec (m X) (w X) then true else false), (if Rle_dec (m Y) (w Y) then true else false),
    (if Rle_dec (m Z) (w Z) then true else false).
  intros i; specialize (Hw i); destruct i; simpl; destruct Rle_dec; lra.
Qed.

Lemma oct_leads es e t a : hit_of e = Some t -> In e es ->
  forall b, oct_listed es b a -> inside b (ray t) -> leads (oct_cell b a) e t.
Proof.
  intros Ht He; induction a as [l|m h IH]; intros b Hb Hin; destruct (box_conservative b t Hin) as (a' & Ha & Hle);
    inversion_clear Hb as [? ? Hl|? ? ? Hh].
  - apply (leads_here _ _ _ _ a'); simpl; eauto.
  - destruct (octants_cover b m (ray t) Hin) as (x & y & z & Hxyz).
    apply (leads_below _ _ _ _ a' (oct_cell (octant b m x y z) (h x y z))); simpl; auto.
    destruct x, y, z; tauto.
Qed.

Theorem octree_first_hit es b a best : lists_from es (oct_cell b a) -> oct_listed es b a ->
  (forall e w, In e es -> surface e w -> inside b w) -> walks ([oct_cell b a], None) ([], best) -> first_hit es best.
Proof. intros Hl Hb Hin; apply first_hit_of_cell; eauto using oct_leads. Qed.

(** ** BSP trees: half-spaces bounded by any planes (axis-aligned ones are k-d trees) *)

Record plane := Plane { normal : point; offset : R }.
Definition height (p : plane) (w : point) : R :=
  normal p X * w X + normal p Y * w Y + normal p Z * w Z - offset p.
(** The closed side of the plane: before it or after it. *)
Definition side (p : plane) (s : bool) (w : point) : Prop := if s then 0 <= height p w else height p w <= 0.
Definition region := list (plane * bool).
Definition in_region (r : region) (w : point) : Prop := forall p s, In (p, s) r -> side p s w.

Inductive bsp := BspLeaf (es : list E) | BspNode (p : plane) (before after : bsp).

Variable region_entry : region -> option T.
Hypothesis region_conservative : forall r, conservative (in_region r) (region_entry r).

Fixpoint bsp_cell (r : region) (a : bsp) : cell :=
  match a with
  | BspLeaf es => Cell (region_entry r) es []
  | BspNode p a0 a1 => Cell (region_entry r) [] [bsp_cell ((p, false) :: r) a0; bsp_cell ((p, true) :: r) a1]
  end.

Inductive bsp_listed (es : list E) : region -> bsp -> Prop :=
| bsp_listed_leaf r l : (forall e w, In e es -> surface e w -> in_region r w -> In e l) -> bsp_listed es r (BspLeaf l)
| bsp_listed_node r p a0 a1 :
    bsp_listed es ((p, false) :: r) a0 -> bsp_listed es ((p, true) :: r) a1 -> bsp_listed es r (BspNode p a0 a1).

Lemma sides_cover r p w : in_region r w -> in_region ((p, false) :: r) w \/ in_region ((p, true) :: r) w.
Proof.
  intros Hr; destruct (Rle_dec (height p w) 0) as [H|H]; [left | right];
    intros q s [[= <- <-]|Hin]; auto; simpl; lra.
Qed.

Lemma bsp_leads es e t a : hit_of e = Some t -> In e es ->
  forall r, bsp_listed es r a -> in_region r (ray t) -> leads (bsp_cell r a) e t.
Proof.
  intros Ht He; induction a as [l|p a0 IH0 a1 IH1]; intros r Hb Hin;
    destruct (region_conservative r t Hin) as (a' & Ha & Hle); inversion_clear Hb as [? ? Hl|? ? ? ? Hb0 Hb1].
  - apply (leads_here _ _ _ _ a'); simpl; eauto.
  - destruct (sides_cover r p (ray t) Hin) as [H|H].
    + apply (leads_below _ _ _ _ a' (bsp_cell ((p, false) :: r) a0)); simpl; auto.
    + apply (leads_below _ _ _ _ a' (bsp_cell ((p, true) :: r) a1)); simpl; auto.
Qed.

Theorem bsp_first_hit es a best : lists_from es (bsp_cell [] a) -> bsp_listed es [] a ->
  walks ([bsp_cell [] a], None) ([], best) -> first_hit es best.
Proof.
  intros Hl Hb; apply first_hit_of_cell; auto; intros e t He Ht; eapply bsp_leads; eauto; intros ? ? [].
Qed.

(** ** Grids, and trees read front to back: a list of cells in the order of the ray

    [path] is what the walk visits: each cell's box with its stretch of the ray and its list. *)

Local Notation stretch := (stretch T E).

Definition lists_box (es : list E) (b : box) (c : stretch) : Prop :=
  forall e w, In e es -> surface e w -> inside b w -> In e (listed T E c).

(** Wherever a hit lies, the walk has a cell whose stretch and whose box hold it: then the walk that stops only when
    its best lies strictly before the end of the cell finds the first hit. *)
Theorem grid_first_hit es (path : list (box * stretch)) :
  let cs := map snd path in
  Forall (fun c => incl (listed T E c) es) cs -> in_order T le E cs ->
  (forall b c, In (b, c) path -> lists_box es b c) ->
  (forall e t, In e es -> hit_of e = Some t -> exists b c, In (b, c) path /\ inside b (ray t) /\
     le (t_in T E c) t = true /\ le t (t_out T E c) = true) ->
  first_hit es (front_to_back T le E hit_of true cs None).
Proof.
  intros cs Hl Ho Hlis Hcub; apply front_to_back_strict; auto.
  intros e t He Ht; destruct (Hcub e t He Ht) as (b & c & Hin & Hw & Hent & Hsal).
  exists c; repeat split; auto; [now apply (in_map snd) in Hin | eapply Hlis; eauto].
Qed.

End Acceleration.
