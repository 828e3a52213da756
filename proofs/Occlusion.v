(** * Occlusion: what the certified search says of a shadow ray is occluded, and occluded_segment

    The model of Search::blocks and Search::blocks_segment over a walk that may end as soon as one element blocks: from
    then on nothing matters, so that it may pass over whatever is left.

    blocks e               == the ray meets e at some t > 0
    blocks_segment e       == at some 0 < t < 1; near 1 the exact parameter decides
    take block e b         == whether something blocks, once e has been tested *)
From Coq Require Import ZArith Reals List Bool Lra Lia.
From Flocq Require Import Core BinarySingleNaN.
From Durero Require Import Toolkit Especificacion Trazador Interseccion Surd Quadratic Exacto ExactoEscena Walk Limits Search
  Chain.
Import ListNotations.
Local Open Scope R_scope.
Local Open Scope zed_scope.

Definition one : binary64 := @B754_finite 53 1024 false (2 ^ 52) (-52) eq_refl.
Lemma one_value : is_finite one = true /\ B2R one = 1.
Proof. split; [reflexivity |]. unfold one, B2R, F2R. cbn. lra. Qed.

Section Occlusion.
Variables E Finding : Type.
Variable met : E -> set R.
Variable es : list E.
Variable reach_of : E -> reach.
Hypothesis met_positive : forall e t, met e t -> 0 < t.
Hypothesis exact_step : forall e, In e es -> reaches (met e) (reach_of e).
Variable in_range : E -> bool.
Variables triage stable : E -> binary64 -> verdict Finding.
Variables low high : evidence Finding -> binary64.
Variable near : Finding -> set R.
Notation meeting := (meeting E Finding reach_of in_range triage stable).
Hypothesis meets_right : forall e x, In e es ->
  match meeting e x with
  | None_met _ => forall t, met e t -> ~ at_least x t
  | Point _ v => exists t, is_least (met e) t /\ at_most (low v) t /\ at_least (high v) t
  | No_minimum_met _ => starts_in (met e)
  end.

Definition blocks (e : E) : bool := match meeting e infinite with None_met _ => false | _ => true end.
Definition blocks_segment (e : E) : bool :=
  match meeting e one with
  | None_met _ => false
  | No_minimum_met _ => true
  | Point _ v =>
      if Bltb (high v) one then true
      else if Bltb one (low v) then false
      else match reach_of e with At x => (cmp x (Surd 1 0 0 1) <? 0)%Z | _ => false end
  end.

Lemma blocks_right e : In e es -> (blocks e = true <-> exists t, met e t).
Proof.
  intros He. pose proof (meets_right e infinite He) as M. unfold blocks.
  destruct (meeting e infinite) as [| v |].
  - split; [discriminate |]. intros [t Ht]. destruct (M t Ht). now left.
  - split; [| reflexivity]. intros _. destruct M as [t [[Ht _] _]]. now exists t.
  - split; [| reflexivity]. intros _. destruct M as [eps [Hpos H]]. exists (eps / 2). apply H. lra.
Qed.

Lemma blocks_segment_right e : In e es -> (blocks_segment e = true <-> exists t, met e t /\ t < 1).
Proof.
  intros He. pose proof (meets_right e one He) as M. unfold blocks_segment. destruct one_value as [F1 V1].
  destruct (meeting e one) as [| v |].
  - split; [discriminate |]. intros [t [Ht H1]]. destruct (M t Ht). right. split; [exact F1 | lra].
  - destruct M as [t [[Ht Hl] [Hlow Hhigh]]].
    assert (First : (exists u, met e u /\ u < 1) <-> t < 1).
    { split; [intros [u [Hu H1]]; specialize (Hl u Hu); lra | intros H1; now exists t]. }
    rewrite First. destruct (Bltb (high v) one) eqn:E1; [| destruct (Bltb one (low v)) eqn:E2].
    + split; [| reflexivity]. intros _. apply Rnot_le_lt. intros N.
      apply (less_excludes (high v) one t E1); [right; split; [exact F1 | lra] | exact Hhigh].
    + split; [discriminate |]. intros H1. destruct (less_excludes one (low v) t E2 Hlow). right. split; [exact F1 | lra].
    + pose proof (exact_step e He) as X. destruct (reach_of e) as [| x |]; cbn in X.
      * now destruct (X t Ht).
      * destruct X as [Hv [Hx Hm]]. assert (Ex : val x = t) by (apply Rle_antisym; auto).
        assert (V : valid (Surd 1 0 0 1)) by (split; cbn; lia).
        assert (W : val (Surd 1 0 0 1) = 1) by (unfold val; cbn; field).
        pose proof (cmp_correct x (Surd 1 0 0 1) Hv V) as C. rewrite W, Ex in C. rewrite Z.ltb_lt.
        destruct C as [[-> H] | [[-> H] | [-> H]]]; split; intros; try lia; lra.
      * split; [discriminate |]. destruct X as [eps [Hpos X]]. intros _. exfalso.
        pose proof (met_positive e t Ht) as Hpos'. pose proof (Rmin_l t eps). pose proof (Rmin_r t eps).
        pose proof (Rmin_glb_lt t eps 0 Hpos' Hpos). assert (Hm : met e (Rmin t eps / 2)) by (apply X; lra).
        specialize (Hl _ Hm). lra.
  - split; [| reflexivity]. intros _. destruct M as [eps [Hpos H]]. exists (Rmin eps 1 / 2).
    pose proof (Rmin_l eps 1). pose proof (Rmin_r eps 1). pose proof (Rmin_glb_lt eps 1 0 Hpos). split; [apply H |]; lra.
Qed.

(** Some element blocks, over elements each taken once or left out where nothing matters. *)
Definition take (block : E -> bool) (e : E) (b : bool) : bool := b || block e.

Lemma some_blocks (block : E -> bool) (P : R -> Prop) taken st :
  (forall e, In e es -> (block e = true <-> exists t, met e t /\ P t)) ->
  st = fold_right (take block) false taken -> incl taken es ->
  (forall e t, In e es -> met e t -> In e taken \/ st = true \/ ~ P t) ->
  (st = true <-> exists e t, In e es /\ met e t /\ P t).
Proof.
  intros Hb Hst Hi Hout.
  assert (F : st = true <-> exists e, In e taken /\ block e = true).
  { rewrite Hst. clear. induction taken as [| x l IH]; [split; [discriminate | intros [e [[] _]]] |].
    cbn [fold_right]. unfold take at 1. rewrite orb_true_iff, IH. split.
    - intros [[e [He H]] | H]; [exists e; split; [now right | exact H] | exists x; split; [now left | exact H]].
    - intros [e [[<- | He] H]]; [now right | left; now exists e]. }
  split.
  - intros H. apply F in H as [e [He H]]. apply Hi in He. apply (Hb e He) in H as [t Ht]. now exists e, t.
  - intros [e [t [He [Ht HP]]]]. destruct (Hout e t He Ht) as [H | [H | H]]; [| exact H | contradiction].
    apply F. exists e. split; [exact H |]. apply (Hb e He). now exists t.
Qed.
End Occlusion.

(** ** Over a walk, and the text *)
Section Text.
Variable Elemento : Type.
Hypothesis Elemento_dec : forall e e' : Elemento, {e = e'} + {e <> e'}.
Variable S : Z.
Hypothesis S_positive : (0 < S)%Z.
Variable s : Especificacion.Escena Elemento.
Hypothesis ok : Escena_ok s.
Variable en : set Elemento.
Variables p v : vec3.
Notation ray := (the_ray S p v).
Variable elements : list Elemento.
Variables (shape_of : Elemento -> shape) (on : Elemento -> bool).
Hypothesis described : describes Elemento S s en (map (fun e => (e, shape_of e, on e)) elements).
Notation met := (met ray Elemento s en).
Variables (Finding : Type) (in_range : Elemento -> bool) (triage stable : Elemento -> binary64 -> verdict Finding)
  (improved : Elemento -> Finding -> verdict Finding) (near : Finding -> set R) (low high : evidence Finding -> binary64)
  (certainly_less : Finding -> Finding -> bool) (rounded : Elemento -> Finding -> option printed) (round_exact : surd -> printed).
Hypothesis right : steps_right Elemento Finding printed met elements (rounds ray) in_range triage stable improved near
  low high certainly_less rounded round_exact.
Notation reach_of := (reach_of Elemento S p v shape_of on).
Notation blocks := (blocks Elemento Finding reach_of in_range triage stable).
Notation blocks_segment := (blocks_segment Elemento Finding reach_of in_range triage stable low high).

Lemma right_meetings e x : In e elements ->
  match meeting Elemento Finding reach_of in_range triage stable e x with
  | None_met _ => forall t, met e t -> ~ at_least x t
  | Point _ v => exists t, is_least (met e) t /\ at_most (low v) t /\ at_least (high v) t
  | No_minimum_met _ => starts_in (met e)
  end.
Proof.
  intros He. assert (M := meeting_right Elemento Finding printed met elements reach_of
    (exact_step Elemento S S_positive s ok en p v elements shape_of on described) (rounds ray) in_range triage stable
    improved near low high certainly_less rounded round_exact right e x He).
  destruct (meeting _ _ _ _ _ _ e x) as [| w |]; [exact M | | exact M].
  destruct M as [t [Ht Hw]]. exists t. split; [exact Ht |]. now apply (ends_around _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ right e).
Qed.

Section Walking.
Variable P : set R.
Variable block : Elemento -> bool.
Hypothesis block_right : forall e, In e elements -> (block e = true <-> exists t, met e t /\ P t).
Variable prunable : bool -> cell Elemento -> Prop.
Hypothesis prunable_right : forall st c, prunable st c -> forall e t, leads c e t -> met e t -> st = true \/ ~ P t.

Lemma walk_tells apart cs taken st :
  incl apart elements -> Forall (lists_from elements) cs ->
  (forall e t, In e elements -> ~ In e apart -> met e t -> exists c, In c cs /\ leads c e t) ->
  walks Elemento bool Elemento_dec (take Elemento block) prunable (plan apart cs, ([], false)) ([], (taken, st)) ->
  (st = true <-> exists t, met_scene ray Elemento s en t /\ P t).
Proof.
  intros Ha Hl Hr Hw.
  assert (Stays : forall st e t, st = true \/ ~ P t -> take Elemento block e st = true \/ ~ P t).
  { intros b e t [-> | H]; [now left | now right]. }
  destruct (walk_settles Elemento bool Elemento_dec met (take Elemento block) (fun st t => st = true \/ ~ P t) Stays prunable
    prunable_right elements _ _ _ _ (plan_lists _ _ _ _ Ha Hl) (plan_reachable _ Elemento_dec _ _ _ _ Hr) Hw)
    as [Hst [_ [Hi Hsettled]]].
  rewrite (some_blocks Elemento met elements block P taken st block_right Hst Hi Hsettled).
  pose proof (elements_are_the_scenes Elemento S s en elements shape_of on described) as All. split.
  - intros [e [t [He [Ht HP]]]]. exists t. split; [| exact HP]. apply met_scene_is_union. exists e.
    split; [now apply All | exact Ht].
  - intros [t [Ht HP]]. apply met_scene_is_union in Ht as [e [He Ht]]. exists e, t.
    split; [now apply All | now split].
Qed.
End Walking.

Lemma positive e t : met e t -> 0 < t.
Proof. now intros [H _]. Qed.

(** A walk that looks for anything that the ray meets answers the text's occluded. *)
Theorem blocked_is_occluded (prunable : bool -> cell Elemento -> Prop) apart cs taken st :
  (forall c e t, prunable false c -> leads c e t -> ~ met e t) ->
  incl apart elements -> Forall (lists_from elements) cs ->
  (forall e t, In e elements -> ~ In e apart -> met e t -> exists c, In c cs /\ leads c e t) ->
  walks Elemento bool Elemento_dec (take Elemento blocks) prunable (plan apart cs, ([], false)) ([], (taken, st)) ->
  (st = true <-> occluded s ray en).
Proof.
  intros Hp Ha Hl Hr Hw. destruct (occluded_computed ray Elemento s en) as [-> _].
  rewrite (walk_tells univ blocks) with (3 := Ha) (4 := Hl) (5 := Hr) (6 := Hw).
  - split; intros [t H]; exists t; [apply H | now split].
  - intros e He. rewrite (blocks_right Elemento Finding met elements reach_of in_range triage stable low high
      right_meetings e He). split; intros [t H]; exists t; [now split | apply H].
  - intros [|] c H e t Hlead Ht; [now left | now destruct (Hp c e t H Hlead)].
Qed.

(** And one that looks for what the ray meets before the other end of a segment, occluded_segment. *)
Theorem blocked_segment_is_occluded (prunable : bool -> cell Elemento -> Prop) apart cs taken st :
  (forall c e t, prunable false c -> leads c e t -> met e t -> 1 <= t) ->
  incl apart elements -> Forall (lists_from elements) cs ->
  (forall e t, In e elements -> ~ In e apart -> met e t -> exists c, In c cs /\ leads c e t) ->
  walks Elemento bool Elemento_dec (take Elemento blocks_segment) prunable (plan apart cs, ([], false)) ([], (taken, st)) ->
  (st = true <-> occluded_segment s ray en).
Proof.
  intros Hp Ha Hl Hr Hw. destruct (occluded_computed ray Elemento s en) as [_ ->].
  apply (walk_tells (fun t => t < 1) blocks_segment) with (3 := Ha) (4 := Hl) (5 := Hr) (6 := Hw).
  - exact (blocks_segment_right Elemento Finding met elements reach_of positive
      (exact_step Elemento S S_positive s ok en p v elements shape_of on described) in_range triage stable low high
      right_meetings).
  - intros [|] c H e t Hlead Ht; [now left | right; pose proof (Hp c e t H Hlead Ht); lra].
Qed.
End Text.
