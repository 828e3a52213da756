(** spec/interseccion.tex: when the nearest point exists, what the first hit of a scene is, and which elements it names.

    met s ray en e       == the parameters t > 0 of the points of the ray in alcance of e
    met_scene s ray en   == the same for alcances: those of any element
    equation s ray e f   == f are the coefficients of the element e along the ray
    seen en e f          == f, or f with C = 0 where e is in en: what the ray sees of e
    is_least, is_first, starts_in, reach == as in Trazador.v *)
From Coq Require Import Reals List Lra Classical_Prop.
From Durero Require Import Toolkit Especificacion Tipos Escena Puntos Trazador.
From Durero Require Export Reduccion.
Import ListNotations.
Local Open Scope R_scope.
Local Open Scope zed_scope.

Section Ray.
Variable ray : Rayo.
Hypothesis ray_ok : Rayo_ok ray.
Let p := Rayo_p ray.
Notation parameters := (parameters ray).
Notation reduccion_on_ray := (reduccion_on_ray ray ray_ok).

(** ** What the ray meets of one element *)
Section Scene.
Variable Elemento : Type.
Notation Escena := (Especificacion.Escena Elemento).
Variable s : Escena.
Hypothesis ok : Escena_ok s.
Variable en : set Elemento.

Definition met (e : Elemento) : set R := parameters (alcance s ray en e).
Definition met_scene : set R := parameters (alcances s ray en).

Definition equation (e : Elemento) (f : coefficients) : Prop :=
  (exists c r, is_esfera _ s e c r /\ f = of_esfera ray c r)
  \/ (exists c r d h, is_cilindro _ s e c r d h /\ f = of_cilindro ray c r d h)
  \/ (exists c k d h, is_cono _ s e c k d h /\ f = of_cono ray c k d h)
  \/ (exists c r k d h, is_tronco _ s e c r k d h /\ f = of_tronco ray c r k d h)
  \/ (exists c d, is_plano _ s e c d /\ f = of_plano ray c d)
  \/ (exists c r d, is_disco _ s e c r d /\ f = of_disco ray c r d)
  \/ (exists abc, is_triangulo _ s e abc /\ f = of_triangulo ray abc).
Definition seen (e : Elemento) (f g : coefficients) : Prop := (en e /\ g = launched f) \/ (~ en e /\ g = f).

(** The attributes of an element are those found: rewrites every other name for them. *)
Ltac same_attributes :=
  repeat match goal with
  | H : de_que_tipo s (?e, ?t), H' : de_que_tipo s (?e, ?t') |- _ =>
      pose proof (type_unique _ _ ok _ _ _ H H'); clear H'; try discriminate; subst
  | H : mi_centro s (?e, ?t), H' : mi_centro s (?e, ?t') |- _ =>
      pose proof (centro_unique _ _ ok _ _ _ H H'); clear H'; subst
  | H : mi_radio s (?e, ?t), H' : mi_radio s (?e, ?t') |- _ =>
      pose proof (radio_unique _ _ ok _ _ _ H H'); clear H'; subst
  | H : mi_vector s (?e, ?t), H' : mi_vector s (?e, ?t') |- _ =>
      pose proof (vector_unique _ _ ok _ _ _ H H'); clear H'; subst
  | H : mi_altura s (?e, ?t), H' : mi_altura s (?e, ?t') |- _ =>
      pose proof (altura_unique _ _ ok _ _ _ H H'); clear H'; subst
  | H : mi_proporcion s (?e, ?t), H' : mi_proporcion s (?e, ?t') |- _ =>
      pose proof (proporcion_unique _ _ ok _ _ _ H H'); clear H'; subst
  | H : mi_vertices s (?e, ?t), H' : mi_vertices s (?e, ?t') |- _ =>
      pose proof (vertices_unique _ _ ok _ _ _ H H'); clear H'; subst
  end.

(** The choice by type, where the type is known: one branch is left of what is supposed, and one is to be shown. *)
Ltac chosen := repeat match goal with
  | H : (?t = _ /\ _) \/ _ |- _ => destruct H as [[? H] | [? H]]; [try discriminate | try easy]
  end.
Ltac choose := repeat first [left; split; [reflexivity |] | right; split; [discriminate |]].
Ltac by_type He Ht := split;
  [ let H := fresh in intros [_ [? [? H]]]; same_attributes; chosen; decompose [ex and] H; same_attributes; auto
  | intros ?; split; [exact He |]; eexists; split; [exact Ht |]; choose; eauto 15 ].
(** Of the three conditions of tramo, those of other types than the element's have a premise that is false. *)
Ltac of_another_type Ht :=
  let E := fresh in intros E; exfalso; first
  [ apply (has_altura _ _ ok _ _ Ht) in E; repeat destruct E as [E | E]; discriminate E
  | apply (has_vertices _ _ ok _ _ Ht) in E; discriminate E
  | destruct E as [? [? ?]]; same_attributes; discriminate ].
Ltac bounded := let H := fresh in intros H;
  (destruct H as [? H]; [eexists; first [eassumption | split; [eassumption | reflexivity]] |]);
  decompose [ex and] H; same_attributes; auto.
(** The definitions by cases, for an element with the attributes of H. *)
Ltac of_scene H := let Ht := fresh "Ht" in let He := fresh "He" in
  unfold is_esfera, is_cilindro, is_cono, is_tronco, is_plano, is_disco, is_triangulo in H; pose proof (proj1 H) as Ht;
  pose proof (element_of_type _ _ ok _ _ Ht) as He; decompose [and] H; clear H; split; [| split];
  [ intros ?; by_type He Ht
  | intros ? ?; by_type He Ht
  | intros ?; first
    [ split; [let A := fresh in let D := fresh in let V := fresh in intros [_ [A [D V]]];
        first [revert A; bounded | revert D; bounded | revert V; bounded]
      | intros ?; split; [exact He | split; [| split]]; first [of_another_type Ht | intros _; eauto 10]]
    | split; [exact He | split; [| split]]; of_another_type Ht ] ].

(** The points, the power and the stretch of a sphere of the scene are those of its attributes. *)
Lemma esfera_of_scene e c r : is_esfera _ s e c r ->
  (forall w, puntos_de_elemento s e w <-> puntos_esfera c r w)
  /\ (forall w y, potencia s e w y <-> y = potencia_esfera w c r) /\ (forall w, tramo s e w).
Proof. intros H. of_scene H. Qed.
(** The same of a cylinder. *)
Lemma cilindro_of_scene e c r d h : is_cilindro _ s e c r d h ->
  (forall w, puntos_de_elemento s e w <-> puntos_cilindro c r d h w)
  /\ (forall w y, potencia s e w y <-> y = potencia_cilindro w c r d)
  /\ (forall w, tramo s e w <-> 0 <= avance w c d <= h).
Proof. intros H. of_scene H. Qed.
(** The same of a cone. *)
Lemma cono_of_scene e c k d h : is_cono _ s e c k d h ->
  (forall w, puntos_de_elemento s e w <-> puntos_cono c k d h w)
  /\ (forall w y, potencia s e w y <-> y = potencia_cono w c k d h)
  /\ (forall w, tramo s e w <-> 0 <= avance w c d <= h).
Proof. intros H. of_scene H. Qed.
(** The same of a truncated cone. *)
Lemma tronco_of_scene e c r k d h : is_tronco _ s e c r k d h ->
  (forall w, puntos_de_elemento s e w <-> puntos_tronco c r k d h w)
  /\ (forall w y, potencia s e w y <-> y = potencia_tronco w c r k d h)
  /\ (forall w, tramo s e w <-> 0 <= avance w c d <= h).
Proof. intros H. of_scene H. Qed.
(** The same of a plane. *)
Lemma plano_of_scene e c d : is_plano _ s e c d ->
  (forall w, puntos_de_elemento s e w <-> puntos_plano c d w)
  /\ (forall w y, potencia s e w y <-> y = potencia_plano w c d) /\ (forall w, tramo s e w).
Proof. intros H. of_scene H. Qed.
(** The same of a disc. *)
Lemma disco_of_scene e c r d : is_disco _ s e c r d ->
  (forall w, puntos_de_elemento s e w <-> puntos_disco c r d w)
  /\ (forall w y, potencia s e w y <-> y = potencia_plano w c d)
  /\ (forall w, tramo s e w <-> potencia_esfera w c r <= 0).
Proof. intros H. of_scene H. Qed.
(** The same of a triangle. *)
Lemma triangulo_of_scene e abc : is_triangulo _ s e abc ->
  (forall w, puntos_de_elemento s e w <-> puntos_triangulo abc w)
  /\ (forall w y, potencia s e w y <-> y = potencia_triangulo w abc) /\ (forall w, tramo s e w <-> w ∈ prisma abc).
Proof. intros H. of_scene H. Qed.

Lemma value_launched f t : value (launched f) t = 0 <-> value f t = value f 0.
Proof. unfold value, launched; cbn. split; intros; lra. Qed.

(** The coefficients of an element: its points, its power and its stretch along the ray are theirs. *)
Lemma equation_of_scene e : e ∈ elementos s -> exists f, equation e f /\ proper f
  /\ (forall t, puntos_de_elemento s e (point_at ray t) <-> value f t = 0 /\ within f t)
  /\ (forall t y, potencia s e (point_at ray t) y <-> y = value f t)
  /\ (forall t, tramo s e (point_at ray t) <-> within f t).
Proof.
  intros He. destruct (element_cases _ _ ok e He) as [[c [r [H _]]] | [[c [r [d [h [H _]]]]] | [[c [k [d [h [H _]]]]] |
    [[c [r [k [d [h [H _]]]]]] | [[c [d [H _]]] | [[c [r [d [H _]]]] | [abc [H _]]]]]]]].
  - destruct (esfera_of_scene _ _ _ H) as [Q [P T]]. exists (of_esfera ray c r).
    split; [left; eauto | split; [apply proper_esfera | split; [| split]]]; intros t.
    + rewrite Q, esfera_along. unfold within; cbn. intuition constructor.
    + intros y. now rewrite P, potencia_esfera_along.
    + split; [constructor | auto].
  - destruct (cilindro_of_scene _ _ _ _ _ H) as [Q [P T]]. exists (of_cilindro ray c r d h).
    split; [right; left; eauto 6 | split; [apply proper_cilindro | split; [| split]]]; intros t.
    + rewrite Q. apply cilindro_along.
    + intros y. now rewrite P, (potencia_cilindro_along ray c r d h).
    + rewrite T, avance_along. symmetry. apply between_holds.
  - destruct (cono_of_scene _ _ _ _ _ H) as [Q [P T]]. exists (of_cono ray c k d h).
    split; [do 2 right; left; eauto 6 | split; [apply proper_cono | split; [| split]]]; intros t.
    + rewrite Q. apply cono_along.
    + intros y. now rewrite P, potencia_cono_along.
    + rewrite T, avance_along. symmetry. apply between_holds.
  - destruct (tronco_of_scene _ _ _ _ _ _ H) as [Q [P T]]. exists (of_tronco ray c r k d h).
    split; [do 3 right; left; eauto 7 | split; [apply proper_tronco | split; [| split]]]; intros t.
    + rewrite Q. apply tronco_along.
    + intros y. now rewrite P, potencia_tronco_along.
    + rewrite T, avance_along. symmetry. apply between_holds.
  - destruct (plano_of_scene _ _ _ H) as [Q [P T]]. exists (of_plano ray c d).
    split; [do 4 right; left; eauto | split; [apply proper_plano | split; [| split]]]; intros t.
    + rewrite Q, plano_along. unfold within; cbn. intuition constructor.
    + intros y. now rewrite P, potencia_plano_along.
    + split; [constructor | auto].
  - destruct (disco_of_scene _ _ _ _ H) as [Q [P T]]. exists (of_disco ray c r d).
    split; [do 5 right; left; eauto 6 | split; [apply proper_disco | split; [| split]]]; intros t.
    + rewrite Q. apply disco_along.
    + intros y. now rewrite P, (potencia_disco_along ray c r d).
    + rewrite T. apply ball_along.
  - destruct (triangulo_of_scene _ _ H) as [Q [P T]]. exists (of_triangulo ray abc).
    split; [do 6 right; eauto | split; [apply proper_triangulo | split; [| split]]]; intros t.
    + rewrite Q. apply triangulo_along.
    + intros y. now rewrite P, potencia_triangulo_along.
    + rewrite T. apply prisma_along.
Qed.

(** What a ray meets of an element is where its quadratic vanishes within the clip; where the ray is said to start on
    the element, the constant term is 0. Discharges potencia.def.1, tramo.def.1, puntos_desde.def.1,
    puntos_de_elemento.def.1, interseccion.def.1, alcance.def.1. *)
Theorem met_is_reach e : e ∈ elementos s ->
  exists f g, equation e f /\ seen e f g /\ proper g /\ met e ≡ reach g.
Proof.
  intros He.
  destruct (equation_of_scene e He) as [f [Heq [Hp [K1 [P T]]]]].
  assert (K2 : forall t, puntos_desde s e p (point_at ray t) <-> value f t = value f 0 /\ within f t).
  { intros t. unfold puntos_desde, p. rewrite <- point_at_0, T. split.
    - intros [_ [Hw [y [y' [H1 [H2 E]]]]]]. apply P in H1, H2. split; [congruence | exact Hw].
    - intros [E Hw]. split; [exact He | split; [exact Hw |]]. exists (value f t), (value f 0). now rewrite !P. }
  assert (A : forall t, 0 < t -> (alcance s ray en e (point_at ray t) <->
    (en e /\ puntos_desde s e p (point_at ray t)) \/ (~ en e /\ puntos_de_elemento s e (point_at ray t)))).
  { intros t Ht. unfold alcance, interseccion, inter. split; [tauto |]. intros H. split; [exact He | split; [| exact H]].
    apply puntos_de_rayo_parameter. now exists t. }
  exists f. destruct (classic (en e)) as [Hen | Hen].
  - exists (launched f). split; [exact Heq | split; [now left | split; [exact Hp |]]]. intros t.
    unfold met, parameters, reach. rewrite value_launched. unfold within, launched; cbn. fold (within f t).
    specialize (A t). specialize (K2 t). tauto.
  - exists f. split; [exact Heq | split; [now right | split; [exact Hp |]]]. intros t.
    unfold met, parameters, reach. specialize (A t). specialize (K1 t). tauto.
Qed.

Lemma is_first_equal T T' x : T ≡ T' -> is_first T x -> is_first T' x.
Proof.
  intros E. destruct x; cbn.
  - intros [H L]. split; [now apply E | intros t' H'; now apply L, E].
  - intros H t' H'. now apply (H t'), E.
  - intros [eps [He H]]. exists eps. split; [exact He | intros t Ht; now apply E, H].
Qed.

(** Every element has a first hit, or is missed, or has no nearest point because the ray starts in a segment of it. *)
Lemma met_first e : e ∈ elementos s -> exists x, is_first (met e) x.
Proof.
  intros He. destruct (met_is_reach e He) as [f [g [_ [_ [Hp E]]]]]. exists (first g).
  apply is_first_equal with (reach g); [now apply seteq_sym | now apply first_correct].
Qed.

Lemma met_on_ray e : alcance s ray en e ⊆ puntos_de_rayo ray.
Proof. now intros w [_ [H _]]. Qed.
Lemma alcances_on_ray : alcances s ray en ⊆ puntos_de_rayo ray.
Proof. intros w [e [_ H]]. now apply (met_on_ray e). Qed.
Lemma met_positive e t : met e t -> 0 < t.
Proof. now intros [H _]. Qed.
Lemma in_dom_reduccion ps : ps ⊆ puntos_de_rayo ray -> (dom reduccion (ps, p) <-> exists t, is_least (parameters ps) t).
Proof.
  intros Hps. split.
  - intros [w H]. apply reduccion_on_ray in H as [t [_ H]]; [now exists t | exact Hps].
  - intros [t H]. exists (point_at ray t). apply reduccion_on_ray; [exact Hps | now exists t].
Qed.
Lemma nonempty_parameters ps : ps ⊆ puntos_de_rayo ray -> (~ (ps ≡ ∅) <-> exists t, parameters ps t).
Proof.
  intros Hps. split.
  - intros H. apply NNPP. intros N. apply H. intros w. split; [| intros []]. intros Hw. apply N.
    destruct (proj1 (puntos_de_rayo_parameter _ _) (Hps _ Hw)) as [t [Ht ->]]. exists t. now split.
  - intros [t [_ H]] E. exact (proj1 (E (point_at ray t)) H).
Qed.

(** An element that the ray meets has no nearest point exactly when the ray starts in a segment of it. *)
Theorem no_minimum_iff_starts_in e : e ∈ elementos s ->
  (~ (alcance s ray en e ≡ ∅) /\ (alcance s ray en e, p) ∉ dom reduccion <-> starts_in (met e)).
Proof.
  intros He. rewrite nonempty_parameters, in_dom_reduccion by apply met_on_ray. fold (met e).
  destruct (met_first e He) as [[t | |] H]; cbn in H.
  - split; [intros [_ N]; destruct N; now exists t |]. intros S. destruct (starts_in_no_least _ S (met_positive e)).
    now exists t.
  - split; [intros [[t Ht] _]; now destruct (H t) |]. intros [eps [Hpos S]]. destruct (H (eps / 2)). apply S. lra.
  - split; [intros _; exact H |]. intros S. split; [| now apply starts_in_no_least with (2 := met_positive e)].
    destruct H as [eps [Hpos H]]. exists (eps / 2). apply H. lra.
Qed.

(** An element has one equation, that of its attributes. *)
Lemma equation_unique e f f' : equation e f -> equation e f' -> f = f'.
Proof.
  unfold equation, is_esfera, is_cilindro, is_cono, is_tronco, is_plano, is_disco, is_triangulo. intros H H'.
  decompose [ex and or] H; decompose [ex and or] H'; same_attributes; reflexivity.
Qed.

(** Where the ray starts in a segment of an element, the whole line lies in its unbounded surface, and what the clip
    leaves of the ray is all that it meets. The element is never a sphere; the ray is parallel to a plane, a disc or a
    triangle, and a plane, which has no clip, is met at every parameter. *)
Theorem starts_in_a_generator e : e ∈ elementos s -> starts_in (met e) ->
  exists f g, equation e f /\ seen e f g /\ (forall t, value g t = 0) /\ (forall t, met e t <-> 0 < t /\ within g t)
    /\ (~ exists c r, is_esfera _ s e c r)
    /\ (forall c d, is_plano _ s e c d -> dot (Rayo_v ray) d = 0 /\ forall t, 0 < t -> met e t)
    /\ (forall c r d, is_disco _ s e c r d -> dot (Rayo_v ray) d = 0)
    /\ forall abc, is_triangulo _ s e abc -> dot (Rayo_v ray) (normal abc) = 0.
Proof.
  intros He S. destruct (met_is_reach e He) as [f [g [Hf [Hg [Hp E]]]]]. exists f, g.
  assert (V : forall t, value g t = 0).
  { destruct (two_points_or_a_segment g Hp) as [[t1 [t2 H]] | [H _]]; [exfalso | exact H].
    destruct S as [eps [Hpos S]].
    assert (M : forall k, 0 < k < 1 -> k * eps = t1 \/ k * eps = t2).
    { intros k Hk. apply H, E, S. pose proof (Rmult_lt_0_compat k eps). pose proof (Rmult_lt_compat_r eps k 1). lra. }
    pose proof (M (1 / 2)). pose proof (M (1 / 3)). pose proof (M (1 / 4)). lra. }
  assert (M : forall t, met e t <-> 0 < t /\ within g t) by (intros t; rewrite (E t); unfold reach; rewrite V; tauto).
  assert (S' : cA g = cA f /\ cB g = cB f /\ within g = within f) by now destruct Hg as [[_ ->] | [_ ->]].
  destruct S' as [HA [HB HW]]. generalize (V 0) (V 1) (V (-1)). unfold value at 1 2 3. rewrite HA, HB. intros V0 V1 V2.
  do 4 (split; [assumption |]). split; [| split; [| split]].
  - intros [c [r Hs]]. assert (f = of_esfera ray c r) as -> by (apply (equation_unique e); [exact Hf | left; eauto]).
    cbn in *. pose proof (ray_direction_positive ray ray_ok). lra.
  - intros c d Hs. assert (f = of_plano ray c d) as ->
      by (apply (equation_unique e); [exact Hf | do 4 right; left; eauto]).
    cbn in *. split; [lra |]. intros t Ht. apply M. rewrite HW. split; [exact Ht | constructor].
  - intros c r d Hs. assert (f = of_disco ray c r d) as ->
      by (apply (equation_unique e); [exact Hf | do 5 right; left; eauto 6]).
    cbn in *. lra.
  - intros abc Hs. assert (f = of_triangulo ray abc) as ->
      by (apply (equation_unique e); [exact Hf | do 6 right; eauto]).
    cbn -[normal] in *. lra.
Qed.

(** ** The first hit of the scene *)

Lemma met_scene_is_union t : met_scene t <-> exists e, e ∈ elementos s /\ met e t.
Proof.
  split; [intros [Ht [e [He H]]]; exists e; split; [exact He | now split] |].
  intros [e [He [Ht H]]]. split; [exact Ht |]. now exists e.
Qed.

Lemma least_of_finite (l : list Elemento) (T : Elemento -> set R) :
  (forall e, In e l -> (exists t, is_least (T e) t) \/ forall t, ~ T e t) ->
  (exists t, is_least (fun t => exists e, In e l /\ T e t) t) \/ forall e t, In e l -> ~ T e t.
Proof.
  induction l as [| a l IH]; intros H; [right; intros e t [] |].
  destruct IH as [[m [[e [Hin He]] Hm]] | N]; [intros e He; apply H; now right | |];
    (destruct (H a (or_introl eq_refl)) as [[t [Ht Hl]] | Na]).
  - left. exists (Rmin t m). split.
    + destruct (Rle_dec t m); [rewrite Rmin_left by lra | rewrite Rmin_right by lra]; [exists a | exists e]; cbn; auto.
    + intros t' [e' [[<- | Hin'] H']]; [apply Rle_trans with t | apply Rle_trans with m];
        auto using Rmin_l, Rmin_r. apply Hm. now exists e'.
  - left. exists m. split; [exists e; cbn; auto |]. intros t' [e' [[<- | Hin'] H']]; [now destruct (Na t') |].
    apply Hm. now exists e'.
  - left. exists t. split; [exists a; cbn; auto |]. intros t' [e' [[<- | Hin'] H']]; [auto | now destruct (N e' t')].
  - right. intros e t [<- | Hin]; auto.
Qed.

(** The scene as a whole: a least parameter, none at all, or an element in whose segment the ray starts. *)
Lemma scene_trichotomy :
  (exists t, is_least met_scene t) \/ (forall t, ~ met_scene t) \/ exists e, e ∈ elementos s /\ starts_in (met e).
Proof.
  destruct (classic (exists e, e ∈ elementos s /\ starts_in (met e))) as [H | N]; [auto |].
  destruct (Escena_decl_elementos ok) as [_ [l Hl]].
  destruct (least_of_finite l met) as [[t [[e [Hin He]] Hm]] | Hnone].
  - intros e Hin. apply Hl in Hin. destruct (met_first e Hin) as [[t | |] H]; [left; now exists t | now right |].
    destruct N. now exists e.
  - left. exists t. split; [apply met_scene_is_union; exists e; split; [now apply Hl | exact He] |].
    intros t' H'. apply met_scene_is_union in H' as [e' [Hin' H']]. apply Hm. exists e'. split; [now apply Hl | exact H'].
  - right; left. intros t H. apply met_scene_is_union in H as [e [Hin He]]. apply (Hnone e t); [now apply Hl | exact He].
Qed.

Lemma starts_in_scene e : e ∈ elementos s -> starts_in (met e) -> starts_in met_scene.
Proof.
  intros He [eps [Hpos H]]. exists eps. split; [exact Hpos |]. intros t Ht. apply met_scene_is_union. exists e. auto.
Qed.
Lemma met_scene_positive t : met_scene t -> 0 < t.
Proof. now intros [H _]. Qed.

(** A scene that the ray meets has no nearest point exactly when the ray starts in a segment of one of its elements. *)
Theorem scene_no_minimum_iff :
  ~ (alcances s ray en ≡ ∅) /\ (alcances s ray en, p) ∉ dom reduccion
  <-> exists e, e ∈ elementos s /\ starts_in (met e).
Proof.
  rewrite nonempty_parameters, in_dom_reduccion by apply alcances_on_ray. fold met_scene. split.
  - intros [[t Ht] N]. destruct scene_trichotomy as [H | [H | H]]; [now destruct N | now destruct (H t) | exact H].
  - intros [e [He S]]. apply starts_in_scene in S as S'; [| exact He].
    split; [| now apply starts_in_no_least with (2 := met_scene_positive)].
    destruct S' as [eps [Hpos H]]. exists (eps / 2). apply H. lra.
Qed.

(** The first hit of a scene is the least of the first hits of its elements, given that no element lacks one. *)
Theorem first_hit_is_least_of_first_hits t :
  is_least met_scene t <->
  (forall e, e ∈ elementos s -> ~ starts_in (met e))
  /\ (exists e, e ∈ elementos s /\ is_least (met e) t)
  /\ forall e' t', e' ∈ elementos s -> is_least (met e') t' -> t <= t'.
Proof.
  split.
  - intros [H L]. split; [| split].
    + intros e He S. apply (starts_in_no_least met_scene (starts_in_scene e He S) met_scene_positive).
      exists t. now split.
    + apply met_scene_is_union in H as [e [He H]]. exists e. split; [exact He | split; [exact H |]].
      intros t' H'. apply L, met_scene_is_union. now exists e.
    + intros e' t' He' [H' _]. apply L, met_scene_is_union. now exists e'.
  - intros [N [[e [He [H L]]] M]]. split; [apply met_scene_is_union; now exists e |].
    intros t' H'. apply met_scene_is_union in H' as [e' [He' H']]. destruct (met_first e' He') as [[t2 | |] F]; cbn in F.
    + apply Rle_trans with t2; [now apply (M e') | now apply F].
    + now destruct (F t').
    + now destruct (N e').
Qed.

(** The elements that contain the first hit of the scene are those that have their own first hit there. *)
Theorem elements_of_first_hit t e : is_least met_scene t -> e ∈ elementos s ->
  (point_at ray t ∈ alcance s ray en e <-> is_least (met e) t).
Proof.
  intros [[Ht _] L] He. split.
  - intros H. split; [now split |]. intros t' H'. apply L, met_scene_is_union. now exists e.
  - now intros [[_ H] _].
Qed.

(** ** The outcomes *)
Variable s' : Escena.
Hypothesis same : Xi_Escena s s'.
Hypothesis known : en ⊆ elementos s.

Lemma question resultado els : Pregunta s s' ray en resultado els.
Proof. split; auto; easy. Qed.

(** The outcome is hit exactly where the parameters of the scene have a least one; it names that parameter, its point
    and the elements whose first hit it is. Discharges alcances.def.1, Pregunta.pre.1, Hay_Interseccion.pre.1,
    Hay_Interseccion.post.1, Hay_Interseccion.post.2, Hay_Interseccion.post.3, Hay_Interseccion.post.4. *)
Theorem hit_computed resultado els t w :
  Hay_Interseccion s s' ray en resultado els t w <->
  is_least met_scene t /\ w = point_at ray t /\ els ≡ (fun e => e ∈ elementos s /\ is_least (met e) t)
  /\ resultado = hit.
Proof.
  assert (A : forall t, is_least met_scene t -> (fun e => e ∈ elementos s /\ point_at ray t ∈ alcance s ray en e)
    ≡ (fun e => e ∈ elementos s /\ is_least (met e) t)).
  { intros u L e. split; intros [He H]; (split; [exact He |]); now apply (elements_of_first_hit u e L He). }
  split.
  - intros [_ Ht _ [v [Hv ->]] [Hx [Hy Hz]] Hels ->].
    apply reduccion_on_ray in Hv as [u [-> L]]; [| apply alcances_on_ray].
    assert (u = t) as -> by (apply (point_at_injective ray); [exact ray_ok | unfold point_at at 2; rewrite <- Hx, <- Hy, <- Hz;
      now destruct (point_at ray u)]).
    split; [exact L | split; [reflexivity | split; [| reflexivity]]]. now rewrite <- (A t L).
  - intros [L [-> [Hels ->]]].
    assert (R : ((alcances s ray en, p), point_at ray t) ∈ reduccion).
    { apply reduccion_on_ray; [apply alcances_on_ray | now exists t]. }
    split; [apply question | apply L | now exists (point_at ray t) | now exists (point_at ray t) | auto | | reflexivity].
    now rewrite (A t L).
Qed.

(** The outcome is miss exactly where the ray meets nothing. Discharges No_Hay_Interseccion.pre.1,
    No_Hay_Interseccion.post.1, No_Hay_Interseccion.post.2. *)
Theorem miss_computed resultado els :
  No_Hay_Interseccion s s' ray en resultado els <-> (forall t, ~ met_scene t) /\ els ≡ ∅ /\ resultado = miss.
Proof.
  pose proof (nonempty_parameters _ alcances_on_ray) as N. fold met_scene in N. split.
  - intros [_ E Hels ->]. split; [| now split]. intros t Ht. apply (proj2 N); [now exists t | exact E].
  - intros [H [Hels ->]]. split; [apply question | | exact Hels | reflexivity].
    apply NNPP. rewrite N. intros [t Ht]. now apply (H t).
Qed.

(** The outcome is no_minimum exactly where the ray starts in a segment of some element, and it names those elements.
    Discharges No_Hay_Minimo.pre.1, No_Hay_Minimo.pre.2, No_Hay_Minimo.post.1, No_Hay_Minimo.post.2. *)
Theorem no_minimum_computed resultado els :
  No_Hay_Minimo s s' ray en resultado els <->
  (exists e, e ∈ elementos s /\ starts_in (met e)) /\ els ≡ (fun e => e ∈ elementos s /\ starts_in (met e))
  /\ resultado = no_minimum.
Proof.
  assert (A : (fun e => e ∈ elementos s /\ ~ (alcance s ray en e ≡ ∅) /\ (alcance s ray en e, p) ∉ dom reduccion)
    ≡ (fun e => e ∈ elementos s /\ starts_in (met e))).
  { intros e. split; intros [He H]; (split; [exact He |]); now apply (no_minimum_iff_starts_in e He). }
  split.
  - intros [_ N1 N2 Hels ->]. split; [apply scene_no_minimum_iff; now split | split; [| reflexivity]].
    now rewrite <- A.
  - intros [H [Hels ->]]. apply scene_no_minimum_iff in H as [N1 N2].
    split; [apply question | exact N1 | exact N2 | | reflexivity]. now rewrite Hels, <- A.
Qed.

(** Every question has an answer. Discharges Primera_Interseccion.def.1. *)
Theorem Primera_Interseccion_is_total : exists resultado els t w, Primera_Interseccion s s' ray en resultado els t w.
Proof.
  destruct scene_trichotomy as [[t H] | [H | H]].
  - exists hit, (fun e => e ∈ elementos s /\ is_least (met e) t), t, (point_at ray t). left.
    apply hit_computed. split; [exact H | now split].
  - exists miss, ∅, 0, p. right; left. now apply miss_computed.
  - exists no_minimum, (fun e => e ∈ elementos s /\ starts_in (met e)), 0, p. right; right.
    now apply no_minimum_computed.
Qed.

(** And only one: the same outcome, the same elements and, where there is a hit, the same parameter and point. *)
Theorem Primera_Interseccion_deterministic res1 els1 t1 w1 res2 els2 t2 w2 :
  Primera_Interseccion s s' ray en res1 els1 t1 w1 -> Primera_Interseccion s s' ray en res2 els2 t2 w2 ->
  res1 = res2 /\ els1 ≡ els2 /\ (res1 = hit -> t1 = t2 /\ w1 = w2).
Proof.
  assert (X1 : forall t, is_least met_scene t -> (exists e, e ∈ elementos s /\ starts_in (met e)) -> False).
  { intros t L [e [He S]]. apply (starts_in_no_least met_scene (starts_in_scene e He S) met_scene_positive). now exists t. }
  assert (X2 : (forall t, ~ met_scene t) -> (exists e, e ∈ elementos s /\ starts_in (met e)) -> False).
  { intros N [e [He S]]. destruct (starts_in_scene e He S) as [eps [Hpos H]]. apply (N (eps / 2)), H. lra. }
  intros [H1 | [H1 | H1]];
    [apply hit_computed in H1 | apply miss_computed in H1 | apply no_minimum_computed in H1];
    intros [H2 | [H2 | H2]];
    [apply hit_computed in H2 | apply miss_computed in H2 | apply no_minimum_computed in H2 | apply hit_computed in H2
    | apply miss_computed in H2 | apply no_minimum_computed in H2 | apply hit_computed in H2 | apply miss_computed in H2
    | apply no_minimum_computed in H2].
  - destruct H1 as [L1 [-> [E1 ->]]], H2 as [L2 [-> [E2 ->]]]. pose proof (least_unique _ _ _ L1 L2) as ->.
    split; [reflexivity | split; [now rewrite E1, E2 | now split]].
  - destruct H1 as [[H1 _] _], H2 as [N _]. now destruct (N t1).
  - destruct H1 as [L _], H2 as [S _]. now destruct (X1 t1).
  - destruct H1 as [N _], H2 as [[H2 _] _]. now destruct (N t2).
  - destruct H1 as [_ [E1 ->]], H2 as [_ [E2 ->]]. split; [reflexivity | split; [now rewrite E1, E2 | discriminate]].
  - destruct H1 as [N _], H2 as [S _]. now destruct X2.
  - destruct H1 as [S _], H2 as [L _]. now destruct (X1 t2).
  - destruct H1 as [S _], H2 as [N _]. now destruct X2.
  - destruct H1 as [_ [E1 ->]], H2 as [_ [E2 ->]]. split; [reflexivity | split; [now rewrite E1, E2 | discriminate]].
Qed.

(** A shadow ray is occluded exactly where it meets something. Discharges occluded.def.1, occluded_segment.def.1. *)
Theorem occluded_computed :
  (occluded s ray en <-> exists t, met_scene t) /\ (occluded_segment s ray en <-> exists t, met_scene t /\ t < 1).
Proof.
  split; [apply nonempty_parameters, alcances_on_ray |]. split.
  - intros [t [w [Ht [Hw [H1 [Hx [Hy Hz]]]]]]]. exists t. split; [split; [exact Ht |] | exact H1].
    replace (point_at ray t) with w; [exact Hw |]. unfold point_at. rewrite <- Hx, <- Hy, <- Hz. now destruct w.
  - intros [t [[Ht H] H1]]. exists t, (point_at ray t). repeat split; assumption.
Qed.
End Scene.

(** For a ray that starts on no known element, the elements of a hit are de_que_elemento of its point.
    Discharges de_que_elemento.def.1, puntos_de_escena.def.1. *)
Theorem hit_elements_are_de_que_elemento Elemento (s s' : Escena Elemento) resultado els t w :
  Hay_Interseccion s s' ray ∅ resultado els t w -> els ≡ de_que_elemento s w /\ w ∈ puntos_de_escena s.
Proof.
  intros [_ Ht _ [v [Hv ->]] _ Hels _].
  assert (A : forall e w, w ∈ alcance s ray ∅ e -> w ∈ puntos_de_elemento s e) by (intros e u [_ [_ [[[] _] | [_ H]]]]; exact H).
  destruct Hv as [_ [[[e [He Ha]] _] _]]. split; [| exists e; split; [exact He | now apply A]].
  intros e'. rewrite (Hels e'). split; intros [He' H]; (split; [exact He' |]); [now apply A |].
  split; [exact He' | split; [apply Ha | right; split; [intros [] | exact H]]].
Qed.
End Ray.
