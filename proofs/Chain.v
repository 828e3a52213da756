(** * Chain: from the Z text to what is printed

    The exact step of the search is that of Exacto.v, on a scene of which every number is an integer over one S; the
    elements come to it by any walk that passes over nothing that the ray meets up to the limit (Walk.v); its other
    steps say nothing false ([Search.steps_right]). Then what it publishes is Primera_Interseccion, rounded once.

    reach_of e             == the exact first hit of an element
    rounds ray out t       == out is t and the point at t, each number rounded once
    says s s' ray en a     == the answer a is the text's
    exactly_printed S p v x == the exact parameter x and the point there, each the nearest binary64 *)
From Durero Require Acceleration Moments Lattice Grid.
From Coq Require Import ZArith Reals List Bool Lra.
From Flocq Require Import Core BinarySingleNaN.
From Durero Require Import Toolkit Especificacion Escena Puntos Trazador Interseccion Surd Quadratic Exacto ExactoEscena
  Walk Limits Search Boxes Nearest.
Import ListNotations.
Local Open Scope R_scope.
Local Open Scope zed_scope.

(** ** An answer that is right is the text's *)

Record printed := Printed { printed_t : binary64; printed_x : binary64; printed_y : binary64; printed_z : binary64 }.

Definition rounds (ray : Rayo) (out : printed) (t : R) : Prop :=
  let w := point_at ray t in
  rounded_once (printed_t out) t /\ rounded_once (printed_x out) (Punto_x w)
  /\ rounded_once (printed_y out) (Punto_y w) /\ rounded_once (printed_z out) (Punto_z w).

(** What is printed of an exact parameter: an executable function, with hints that change nothing. *)
Definition exactly_printed (guess : Z -> Z) (at_t at_x at_y at_z : Z) (S : Z) (p v : vec3) (x : surd) : printed :=
  Printed (nearest guess at_t x) (nearest guess at_x (coordinate S (vx p) (vx v) x))
    (nearest guess at_y (coordinate S (vy p) (vy v) x)) (nearest guess at_z (coordinate S (vz p) (vz v) x)).

Theorem exactly_printed_is_rounded_once guess at_t at_x at_y at_z S p v x : (0 < S)%Z -> valid x ->
  rounds (the_ray S p v) (exactly_printed guess at_t at_x at_y at_z S p v x) (val x).
Proof.
  intros HS Hx.
  assert (Hc : forall at_c a b, rounded_once (nearest guess at_c (coordinate S a b x)) (over S a + val x * over S b)).
  { intros at_c a b. destruct (coordinate_correct S a b x HS Hx) as [Hv <-]. now apply nearest_is_rounded_once. }
  split; [now apply nearest_is_rounded_once |]. exact (conj (Hc _ _ _) (conj (Hc _ _ _) (Hc _ _ _))).
Qed.

(** So where an answer has the bits of these, its parameter and its point are the text's, rounded once. *)
Theorem judged_bytes_are_the_texts Elemento (s s' : Especificacion.Escena Elemento) S en p v es guess at_t at_x at_y at_z :
  (0 < S)%Z -> Escena_ok s -> Rayo_ok (the_ray S p v) -> describes Elemento S s en es -> Xi_Escena s s' ->
  en ⊆ elementos s -> forall x l, first_hit S p v es = Exacto.Hit x l ->
  exists t, Hay_Interseccion s s' (the_ray S p v) en hit (fun e => In e l) t (point_at (the_ray S p v) t)
  /\ rounds (the_ray S p v) (exactly_printed guess at_t at_x at_y at_z S p v x) t.
Proof.
  intros HS ok ray_ok Hd same known x l E. exists (val x). split.
  - pose proof (first_hit_is_Primera_Interseccion Elemento S HS s ok en p v es ray_ok Hd s' same known) as H.
    now rewrite E in H.
  - apply exactly_printed_is_rounded_once; [exact HS |]. pose proof (first_hit_correct S p v es HS) as H.
    rewrite E in H. apply H.
Qed.

Section Text.
Variable Elemento : Type.
Notation Escena := (Especificacion.Escena Elemento).
Variables s s' : Escena.
Variable ray : Rayo.
Variable en : set Elemento.
Hypothesis ok : Escena_ok s.
Hypothesis ray_ok : Rayo_ok ray.
Hypothesis same : Xi_Escena s s'.
Hypothesis known : en ⊆ elementos s.
Notation met := (met ray Elemento s en).
Notation met_scene := (met_scene ray Elemento s en).

Definition says (a : answer Elemento printed) : Prop :=
  match a with
  | Published_miss _ _ => No_Hay_Interseccion s s' ray en miss ∅
  | Published_no_minimum _ _ l => NoDup l /\ No_Hay_Minimo s s' ray en no_minimum (fun e => In e l)
  | Published_hit _ _ out l => NoDup l /\ exists t o, out = Some o /\ rounds ray o t
      /\ Hay_Interseccion s s' ray en hit (fun e => In e l) t (point_at ray t)
  end.

Variable elements : list Elemento.
Hypothesis all : forall e, In e elements <-> e ∈ elementos s.

Lemma right_answer_says a : right_answer Elemento printed met elements (rounds ray) a -> says a.
Proof.
  destruct a as [| out l | l]; cbn [right_answer says].
  - intros H. apply miss_computed; auto. split; [| now split].
    intros t Ht. apply met_scene_is_union in Ht as [e [He Ht]]. apply all in He. now apply (H e t).
  - intros [Hne [Hd [t [Hl [Hin [o [Ho Hr]]]]]]]. split; [exact Hd |]. exists t, o.
    split; [exact Ho | split; [exact Hr |]]. apply hit_computed; auto. split; [split |].
    + destruct l as [| e l]; [contradiction |]. destruct (proj1 (Hin e) (or_introl eq_refl)) as [He [Ht _]].
      apply met_scene_is_union. exists e. split; [now apply all | exact Ht].
    + intros t' Ht'. apply met_scene_is_union in Ht' as [e [He Ht']]. apply (Hl e); [now apply all | exact Ht'].
    + split; [reflexivity | split; [| reflexivity]]. intros e. rewrite (Hin e). now rewrite (all e).
  - intros [Hne [Hd Hin]]. split; [exact Hd |]. apply no_minimum_computed; auto.
    assert (E : (fun e => In e l) ≡ (fun e => e ∈ elementos s /\ starts_in (met e))).
    { intros e. rewrite (Hin e). now rewrite (all e). }
    split; [| split; [exact E | reflexivity]].
    destruct l as [| e l]; [contradiction |]. exists e. apply (E e). now left.
Qed.
End Text.

(** What is met of an element that the ray does not start on is a point of the element. *)
Lemma met_of_another Elemento (s : Especificacion.Escena Elemento) ray en e t : ~ en e -> met ray Elemento s en e t ->
  0 < t /\ puntos_de_elemento s e (point_at ray t).
Proof. intros Hen [Ht [_ [_ [[H _] | [_ H]]]]]; [contradiction | now split]. Qed.

(** So a grid whose cubes list what has a point in them leads to each. *)
Definition along (w : Punto) (i : Acceleration.axis) : R :=
  match i with Acceleration.X => Punto_x w | Acceleration.Y => Punto_y w | Acceleration.Z => Punto_z w end.
Definition component (v : Vector) (i : Acceleration.axis) : R :=
  match i with Acceleration.X => Vector_x v | Acceleration.Y => Vector_y v | Acceleration.Z => Vector_z v end.

Theorem grid_is_walked Elemento (s : Especificacion.Escena Elemento) ray en elements State (limit_of : State -> binary64)
  corner h count lists (whole : set R) apart m c l :
  let p i := along (Rayo_p ray) i in let v i := component (Rayo_v ray) i in let met := met ray Elemento s en in
  0 < h -> (forall e, In e elements -> en e -> In e apart) ->
  (forall e t, In e elements -> ~ In e apart -> puntos_de_elemento s e (point_at ray t) ->
   whole t /\ Lattice.in_box p v corner h count (t, false)
   /\ forall d, Lattice.in_range count d -> Grid.in_cube p v corner h d t -> In e (lists d)) ->
  Lattice.way_in p v corner h count m -> Lattice.in_cell p v corner h c m -> Lattice.in_range count c ->
  Lattice.path p v corner h count m c l ->
  (forall st k, Grid.prunable p v corner h Elemento State limit_of whole lists st k ->
   forall e t, leads k e t -> met e t -> ~ at_least (limit_of st) t)
  /\ forall e t, In e elements -> ~ In e apart -> met e t ->
     exists k, In k (map (Grid.cell_of p v corner h Elemento whole lists) l) /\ leads k e t.
Proof.
  intros p v met' Hh Hen Hlisted Hw Hc Hr Hp. split.
  - exact (Grid.prunable_right p v corner h Elemento State limit_of met' whole lists).
  - intros e t He Ha Ht. destruct (met_of_another Elemento s ray en e t (fun N => Ha (Hen e He N)) Ht) as [Hpos Hpoint].
    destruct (Hlisted e t He Ha Hpoint) as [Hwhole [Hbox Hlists]].
    exact (Grid.walk_leads p v corner h count Hh Elemento whole lists m c l e t Hw Hc Hr Hp Hpos Hbox Hwhole Hlists).
Qed.

(** ** The search over a scene of integers over S *)
Section Chain.
Variable Elemento : Type.
Hypothesis Elemento_dec : forall e e' : Elemento, {e = e'} + {e <> e'}.
Notation Escena := (Especificacion.Escena Elemento).
Variable S : Z.
Hypothesis S_positive : (0 < S)%Z.
Variables s s' : Escena.
Hypothesis ok : Escena_ok s.
Hypothesis same : Xi_Escena s s'.
Variable en : set Elemento.
Hypothesis known : en ⊆ elementos s.
Variables p v : vec3.
Notation ray := (the_ray S p v).
Hypothesis ray_ok : Rayo_ok ray.
Variable elements : list Elemento.
Variables (shape_of : Elemento -> shape) (on : Elemento -> bool).
Hypothesis described : describes Elemento S s en (map (fun e => (e, shape_of e, on e)) elements).
Notation met := (met ray Elemento s en).

Definition reach_of (e : Elemento) : reach := Quadratic.first (quad S (shape_of e) (on e) p v).

Lemma elements_are_the_scenes e : In e elements <-> e ∈ elementos s.
Proof.
  destruct described as [H _]. rewrite (H e). split.
  - intros He. exists (shape_of e), (on e). apply in_map_iff. now exists e.
  - intros [sh [o Hin]]. apply in_map_iff in Hin as [x [[= <- _ _] Hx]]. exact Hx.
Qed.

(** The exact step finds the first of the parameters at which the text has the ray meet the element. *)
Lemma exact_step e : In e elements -> reaches (met e) (reach_of e).
Proof.
  intros He. apply (reaches_ext (meets S (shape_of e) (on e) p v)).
  - intros t. eapply meets_met; [exact ok | exact described |]. apply in_map_iff. now exists e.
  - now apply first_of_shape.
Qed.

Variable Finding : Type.
Variable in_range : Elemento -> bool.
Variables triage stable : Elemento -> binary64 -> verdict Finding.
Variable improved : Elemento -> Finding -> verdict Finding.
Variable near : Finding -> set R.
Variables low high : evidence Finding -> binary64.
Variables certainly_less ahead : Finding -> Finding -> bool.
Variable rounded : Elemento -> Finding -> option printed.
Variable round_exact : surd -> printed.
Hypothesis right : steps_right Elemento Finding printed met elements (rounds ray) in_range triage stable improved near
  low high certainly_less rounded round_exact.

Notation take := (take Elemento Finding reach_of in_range triage stable low high).
Notation published := (published Elemento Finding printed reach_of stable improved certainly_less ahead rounded round_exact).
Definition beyond (st : found Elemento Finding) (t : R) : Prop := ~ at_least (limit _ _ st) t.

(** The limit only falls. *)
Lemma beyond_stays st e t : beyond st t -> beyond (take e st) t.
Proof.
  unfold beyond, take. destruct (meeting _ _ _ _ _ _ e (limit _ _ st)) as [| w |]; [auto | |].
  - destruct (Bltb (limit _ _ st) (low w)); [auto |].
    destruct (Bltb (high w) (limit _ _ st)) eqn:E; [| auto]. intros H N. apply H. now apply less_at_least with (high w).
  - destruct (Bltb (limit _ _ st) zero); auto.
Qed.

Section Walking.
Variable prunable : found Elemento Finding -> cell Elemento -> Prop.
Hypothesis prunable_right : forall st c, prunable st c -> forall e t, leads c e t -> met e t -> beyond st t.
Notation walks := (walks Elemento (found Elemento Finding) Elemento_dec take prunable).

Theorem search_is_Primera_Interseccion apart cs taken st :
  incl apart elements -> Forall (lists_from elements) cs ->
  (forall e t, In e elements -> ~ In e apart -> met e t -> exists c, In c cs /\ leads c e t) ->
  walks (plan apart cs, ([], start Elemento Finding)) ([], (taken, st)) ->
  says Elemento s s' ray en (published st).
Proof.
  intros Ha Hl Hr Hw.
  destruct (walk_settles Elemento _ Elemento_dec met take beyond beyond_stays prunable prunable_right elements _ _ _ _
    (plan_lists _ _ _ _ Ha Hl) (plan_reachable _ Elemento_dec _ _ _ _ Hr) Hw) as [Hst [Hd [Hi Hsettled]]].
  apply (right_answer_says _ _ _ _ _ ok ray_ok same known elements elements_are_the_scenes).
  eapply search_right; eauto using exact_step. intros e t [Ht _]. exact Ht.
Qed.
End Walking.

(** So in a tree of boxes: what the ray starts on is tested apart. *)
Theorem boxes_find_Primera_Interseccion r apart a taken st : of_beam r = ray ->
  incl apart elements -> (forall e, In e elements -> en e -> In e apart) ->
  lists_from elements (cell_of Elemento r a) ->
  (forall e, In e elements -> ~ In e apart -> under Elemento (puntos_de_elemento s) e a) ->
  walks Elemento (found Elemento Finding) Elemento_dec take (prunable Elemento _ (limit Elemento Finding) r)
    (plan apart [cell_of Elemento r a], ([], start Elemento Finding)) ([], (taken, st)) ->
  says Elemento s s' ray en (published st).
Proof.
  intros Hr Ha Hen Hl Hu Hw.
  assert (On : forall e t, In e elements -> ~ In e apart -> met e t ->
    0 < t /\ puntos_de_elemento s e (point_at (of_beam r) t)).
  { intros e t He Hn Ht. rewrite Hr. apply met_of_another with en; [| exact Ht]. intros N. now apply Hn, Hen. }
  refine (search_is_Primera_Interseccion _ _ apart [cell_of Elemento r a] taken st Ha _ _ Hw).
  - intros st' c Hp e t. exact (Boxes.prunable_right _ _ _ _ _ st' c Hp e t).
  - constructor; [exact Hl | constructor].
  - intros e t He Hn Ht. exists (cell_of Elemento r a). split; [now left |]. destruct (On e t He Hn Ht) as [Hpos Hpoint].
    exact (under_leads Elemento r (puntos_de_elemento s) e a t (Hu e He Hn) Hpos Hpoint).
Qed.
End Chain.

