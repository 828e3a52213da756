(** * Search: what the certified search publishes, if its floating-point steps say nothing false, is the first hit

    The model of trace::Search (src/trace/search-inl.hpp), step by step, which tests/proofs/search.sh holds against it:
    elements are taken one by one in any order; of each, the triage, or double-double, or exact numbers tell where it is
    first met; the limit is the least upper end so far; what begins beyond it is dropped; what is left is told apart by
    double-double and then exactly; and the nearest is rounded by the first of three steps that is certain of it. Limits
    are binary64 and compared as such, with their infinities. What is assumed of the floating-point steps is
    [steps_right] and nothing else; Chain.v joins the exact step to the Z text.

    met e, reach_of e      == the parameters at which the ray meets e; the exact first of them
    verdict                == a miss, a hit with its finding, or undecided
    near f t               == the parameter t is within the error of the finding f
    evidence               == what a meeting rests on: a finding by triage or by double-double, or an exact parameter
    low v, high v          == the ends around the parameter
    tells e v t            == v is right evidence, found by its step, that e is first met at t
    meeting e x            == where e is first met, by the first step that can tell; none also beyond the limit x
    take e st              == the state of the search once e has been tested
    published st           == the answer
    printed                == t, x, y and z as they are printed *)
From Coq Require Import ZArith Reals List Permutation Bool Lra Lia.
From Flocq Require Import Core BinarySingleNaN.
From Durero Require Import Toolkit Trazador Interseccion Surd Quadratic Limits.
Import ListNotations.
Local Open Scope R_scope.

Section Search.
Variables E Finding Printed : Type.
Variables (met : E -> set R) (es : list E) (reach_of : E -> reach).
Hypothesis met_positive : forall e t, met e t -> 0 < t.
Hypothesis exact_step : forall e, In e es -> reaches (met e) (reach_of e).

(** What is rounded: a parameter, into what is printed. *)
Variable rounds : Printed -> set R.

(** ** The steps in floating point *)

Inductive verdict := Miss | Hit (f : Finding) | Undecided.
Inductive evidence := By_triage (f : Finding) | By_stable (f : Finding) | By_exact (x : surd).

Variables (in_range : E -> bool) (triage stable : E -> binary64 -> verdict) (improved : E -> Finding -> verdict).
Variables (near : Finding -> set R) (low high : evidence -> binary64).
Variables certainly_less ahead : Finding -> Finding -> bool.
Variables (rounded : E -> Finding -> option Printed) (round_exact : surd -> Printed).

Definition tells (e : E) (v : evidence) (t : R) : Prop :=
  match v with
  | By_triage f => in_range e = true /\ (exists x, triage e x = Hit f) /\ near f t
  | By_stable f => in_range e = true /\ (exists x, stable e x = Hit f) /\ near f t
  | By_exact x => valid x /\ val x = t
  end.

(** A step says a miss only where nothing is met up to the limit, and a hit only with a finding that holds the first
    parameter. *)
Definition decides (step : E -> binary64 -> verdict) : Prop :=
  forall e x, In e es -> in_range e = true ->
  match step e x with
  | Miss => forall t, met e t -> ~ at_least x t
  | Hit f => exists t, is_least (met e) t /\ near f t
  | Undecided => True
  end.

(** What is rounded: a finding of the second step, or of the first, improved. *)
Definition reports (e : E) (f : Finding) : Prop :=
  in_range e = true /\ ((exists x, stable e x = Hit f) \/ exists g x, triage e x = Hit g /\ improved e g = Hit f).

(** All that is assumed of the floating-point steps. *)
Record steps_right : Prop := {
  triage_decides : decides triage;
  stable_decides : decides stable;
  improved_near : forall e f g t, In e es -> in_range e = true -> (exists x, triage e x = Hit f) -> improved e f = Hit g ->
    is_least (met e) t -> near f t -> near g t;
  ends_around : forall e v t, In e es -> is_least (met e) t -> tells e v t -> at_most (low v) t /\ at_least (high v) t;
  certainly_less_is_less : forall f g a b, certainly_less f g = true -> near f a -> near g b -> a < b;
  rounded_is_certain : forall e f out t, In e es -> reports e f -> is_least (met e) t -> rounded e f = Some out -> near f t ->
    rounds out t;
  round_exact_right : forall x, valid x -> rounds (round_exact x) (val x)
}.

(** ** The search *)

Inductive meeting_kind := None_met | Point (v : evidence) | No_minimum_met.

Definition exact_meeting (e : E) : meeting_kind :=
  match reach_of e with Nothing => None_met | NoMinimum => No_minimum_met | At x => Point (By_exact x) end.
Definition meeting (e : E) (x : binary64) : meeting_kind :=
  if in_range e then
    match triage e x with
    | Miss => None_met
    | Hit f => Point (By_triage f)
    | Undecided =>
        match stable e x with
        | Miss => None_met
        | Hit f => Point (By_stable f)
        | Undecided => exact_meeting e
        end
    end
  else exact_meeting e.

Definition candidate := (E * evidence)%type.
Record found := Found { limit : binary64; candidates : list candidate; without_minimum : list E }.
Definition start : found := Found infinite [] [].

Definition within_limit (x : binary64) (c : candidate) : bool := negb (Bltb x (low (snd c))).
Definition take (e : E) (st : found) : found :=
  match meeting e (limit st) with
  | None_met => st
  | No_minimum_met =>
      if Bltb (limit st) zero then st else Found (limit st) (candidates st) (e :: without_minimum st)
  | Point v =>
      if Bltb (limit st) (low v) then st
      else if Bltb (high v) (limit st) then
        Found (high v) (filter (within_limit (high v)) (candidates st ++ [(e, v)])) (without_minimum st)
      else Found (limit st) (candidates st ++ [(e, v)]) (without_minimum st)
  end.

Definition refine (c : candidate) : candidate :=
  match snd c with
  | By_triage _ => match stable (fst c) infinite with Hit g => (fst c, By_stable g) | _ => c end
  | _ => c
  end.
Definition exactly (c : candidate) : candidate :=
  match snd c with
  | By_exact _ => c
  | _ => match reach_of (fst c) with At x => (fst c, By_exact x) | _ => c end
  end.
Definition is_stable (c : candidate) : bool := match snd c with By_stable _ => true | _ => false end.
Definition by_finding (less : Finding -> Finding -> bool) (c d : candidate) : bool :=
  match snd c, snd d with By_stable f, By_stable g => less f g | _, _ => false end.
Definition by_exact (c d : candidate) : bool :=
  match snd c, snd d with By_exact x, By_exact y => (cmp x y <? 0)%Z | _, _ => false end.
Definition nearest_by_stable (l : list candidate) : list candidate :=
  let refined := map refine l in
  if forallb is_stable refined then not_farther (by_finding ahead) (by_finding certainly_less) refined else refined.
Definition nearest_by_exact (l : list candidate) : list candidate := not_farther by_exact by_exact (map exactly l).
Definition nearest (l : list candidate) : list candidate :=
  let l' := if several l then nearest_by_stable l else l in if several l' then nearest_by_exact l' else l'.

Definition attempt (e : E) (v : verdict) : option Printed := match v with Hit f => rounded e f | _ => None end.
Definition round_candidate (c : candidate) : option Printed :=
  let (e, v) := c in
  let last := match v, reach_of e with By_exact x, _ | _, At x => Some (round_exact x) | _, _ => None end in
  let or_else a b := match a with Some out => Some out | None => b end in
  match v with
  | By_triage f => or_else (attempt e (improved e f)) (or_else (attempt e (stable e infinite)) last)
  | By_stable f => or_else (rounded e f) last
  | By_exact _ => last
  end.

Inductive answer := Published_miss | Published_hit (out : option Printed) (l : list E) | Published_no_minimum (l : list E).
Definition published (st : found) : answer :=
  match without_minimum st, nearest (candidates st) with
  | _ :: _, _ => Published_no_minimum (without_minimum st)
  | [], [] => Published_miss
  | [], c :: l => Published_hit (round_candidate c) (map fst (c :: l))
  end.

(** ** It is right *)

Hypothesis right : steps_right.

Lemma no_start e t : is_least (met e) t -> ~ starts_in (met e).
Proof. intros H S. apply (starts_in_no_least (met e) S); [apply met_positive | now exists t]. Qed.

(** What a meeting says of its element. *)
Definition meets_right (e : E) (x : binary64) (m : meeting_kind) : Prop :=
  match m with
  | None_met => forall t, met e t -> ~ at_least x t
  | Point v => exists t, is_least (met e) t /\ tells e v t
  | No_minimum_met => starts_in (met e)
  end.

Lemma meeting_right e x : In e es -> meets_right e x (meeting e x).
Proof.
  intros He.
  assert (X : meets_right e x (exact_meeting e)).
  { pose proof (exact_step e He) as H. unfold exact_meeting. destruct (reach_of e) as [| y |]; cbn in H.
    - intros t Ht. now destruct (H t).
    - destruct H as [Hv [Hy Hl]]. exists (val y). split; [now split | now split].
    - destruct H as [eps [Hpos H]]. exists eps. split; [exact Hpos |]. intros t Ht. apply H. lra. }
  unfold meeting. destruct (in_range e) eqn:Hr; [| exact X].
  pose proof (triage_decides right e x He Hr) as H1. destruct (triage e x) as [| f |] eqn:E1; [exact H1 | |].
  - destruct H1 as [t [Ht Hf]]. exists t. split; [exact Ht | split; [exact Hr | split; [now exists x | exact Hf]]].
  - pose proof (stable_decides right e x He Hr) as H2. destruct (stable e x) as [| f |] eqn:E2; [exact H2 | | exact X].
    destruct H2 as [t [Ht Hf]]. exists t. split; [exact Ht | split; [exact Hr | split; [now exists x | exact Hf]]].
Qed.

(** *** What holds after each element *)

Definition right_candidates (l : list candidate) : Prop :=
  forall e v, In (e, v) l -> In e es /\ exists t, is_least (met e) t /\ tells e v t.

Record invariant (taken : list E) (st : found) : Prop := {
  named_without : forall e, In e (without_minimum st) <-> In e taken /\ starts_in (met e);
  without_once : NoDup (without_minimum st);
  are_right : right_candidates (candidates st);
  were_taken : forall e v, In (e, v) (candidates st) -> In e taken;
  candidates_once : NoDup (map fst (candidates st));
  limit_held : limit st = infinite
    \/ exists e v t, In (e, v) (candidates st) /\ is_least (met e) t /\ at_least (limit st) t;
  kept : forall e t, In e taken -> is_least (met e) t -> at_least (limit st) t ->
    exists v, In (e, v) (candidates st)
}.

Lemma limit_positive taken st : invariant taken st -> exists t, 0 < t /\ at_least (limit st) t.
Proof.
  intros H. destruct (limit_held _ _ H) as [-> | [e [v [t [_ [[Ht _] Hl]]]]]].
  - exists 1. split; [lra | now left].
  - exists t. split; [now apply (met_positive e) | exact Hl].
Qed.
Lemma starts_within taken st e : invariant taken st -> starts_in (met e) ->
  exists t, met e t /\ at_least (limit st) t.
Proof.
  intros H [eps [Hpos Hs]]. destruct (limit_positive _ _ H) as [t [Ht Hl]].
  exists (Rmin t (eps / 2)). pose proof (Rmin_r t (eps / 2)). pose proof (Rmin_glb_lt t (eps / 2) 0 Ht).
  split; [apply Hs; lra |]. apply at_least_below with t; [apply Rmin_l | exact Hl].
Qed.

Lemma start_invariant : invariant [] start.
Proof.
  split; cbn.
  1: intros e; split; [intros [] | intros [[] _]].
  all: [> constructor | intros e v [] | intros e v [] | constructor | now left | intros e t []].
Qed.

(** Nothing to be kept: the element is not first met up to the limit, and does not begin at the origin. *)
Lemma take_nothing e taken st : invariant taken st -> (forall t, is_least (met e) t -> ~ at_least (limit st) t) ->
  ~ starts_in (met e) -> invariant (e :: taken) st.
Proof.
  intros H Hfar Hno. destruct H as [W1 W2 R1 R2 R3 L K]. split; auto.
  - intros x. rewrite W1. cbn. split; [tauto |]. intros [[<- | Hx] S]; [contradiction | now split].
  - intros x v Hx. right. now apply (R2 x v).
  - intros x t [<- | Hx] Ht Hl; [now destruct (Hfar t Ht) | now apply K with t].
Qed.

Lemma take_invariant e taken st : In e es -> ~ In e taken -> invariant taken st -> invariant (e :: taken) (take e st).
Proof.
  intros He Hnew H. pose proof (meeting_right e (limit st) He) as M. unfold meets_right in M. unfold take.
  destruct (meeting e (limit st)) as [| v |].
  - apply take_nothing; [exact H | intros t [Ht _]; now apply M |].
    intros S. destruct (starts_within _ _ e H S) as [t [Ht Hl]]. now apply (M t).
  - destruct M as [t [Ht Hv]]. destruct (ends_around right e v t He Ht Hv) as [Hlow Hhigh].
    destruct (Bltb (limit st) (low v)) eqn:Hfar.
    { apply take_nothing; [exact H | | now apply no_start with t].
      intros u Hu. rewrite (least_unique _ _ _ Hu Ht). now apply less_excludes with (low v). }
    pose proof H as [W1 W2 R1 R2 R3 L K].
    assert (New : forall x w, In (x, w) (candidates st ++ [(e, v)]) <-> In (x, w) (candidates st) \/ (x, w) = (e, v)).
    { intros x w. rewrite in_app_iff. cbn. intuition congruence. }
    assert (A1 : right_candidates (candidates st ++ [(e, v)])).
    { intros x w Hx. apply New in Hx as [Hx | [= -> ->]]; [now apply R1 | split; [exact He | now exists t]]. }
    assert (A2 : forall x w, In (x, w) (candidates st ++ [(e, v)]) -> In x (e :: taken)).
    { intros x w Hx. apply New in Hx as [Hx | [= -> ->]]; [right; now apply (R2 x w) | now left]. }
    assert (A3 : NoDup (map fst (candidates st ++ [(e, v)]))).
    { rewrite map_app. apply (Permutation_NoDup (Permutation_cons_append _ _)). apply once_more with taken;
        [| exact Hnew | exact R3]. intros x Hx. apply in_map_iff in Hx as [[y w] [<- Hy]]. now apply (R2 y w). }
    assert (A4 : forall x, In x (without_minimum st) <-> In x (e :: taken) /\ starts_in (met x)).
    { intros x. rewrite W1. cbn. split; [tauto |]. intros [[<- | Hx] S]; [now destruct (no_start e t Ht) | now split]. }
    assert (A5 : forall x u, In x (e :: taken) -> is_least (met x) u -> at_least (limit st) u ->
      exists w, In (x, w) (candidates st ++ [(e, v)])).
    { intros x u [<- | Hx] Hu Hl; [exists v | destruct (K x u Hx Hu Hl) as [w Hw]; exists w]; apply New; auto. }
    destruct (Bltb (high v) (limit st)) eqn:Hnear; split; try assumption; cbn [limit candidates without_minimum].
    + intros x w Hx. apply filter_In in Hx as [Hx _]. now apply A1.
    + intros x w Hx. apply filter_In in Hx as [Hx _]. now apply (A2 x w).
    + now apply NoDup_filter.
    + right. exists e, v, t. split; [apply filter_In; split; [apply New; now right |] | now split].
      unfold within_limit; cbn. destruct (Bltb (high v) (low v)) eqn:Hlt; [| reflexivity].
      now destruct (less_excludes _ _ t Hlt Hlow).
    + intros x u Hx Hu Hl. destruct (A5 x u Hx Hu) as [w Hw]; [now apply less_at_least with (high v) |].
      exists w. apply filter_In. split; [exact Hw |]. destruct (A1 x w Hw) as [Hxs [u' [Hu' Htell]]].
      rewrite <- (least_unique _ _ _ Hu Hu') in Htell. destruct (ends_around right x w u Hxs Hu Htell) as [Hlo _].
      unfold within_limit; cbn. destruct (Bltb (high v) (low w)) eqn:Hlt; [| reflexivity].
      now destruct (less_excludes _ _ u Hlt Hlo).
    + destruct L as [L | [x [w [u [Hx Hu]]]]]; [now left | right; exists x, w, u; split; [apply New; now left | exact Hu]].
  - destruct (Bltb (limit st) zero) eqn:Hneg.
    { destruct (limit_positive _ _ H) as [t [Ht Hl]]. destruct (less_excludes _ _ t Hneg); [| exact Hl].
      right. split; [reflexivity | cbn; lra]. }
    pose proof H as [W1 W2 R1 R2 R3 L K]. split; cbn [limit candidates without_minimum]; auto.
    + intros x. cbn. rewrite W1. split; [intros [<- | [Hx S]]; tauto |]. intros [[<- | Hx] S]; tauto.
    + apply once_more with taken; [| exact Hnew | exact W2]. intros x Hx. now apply W1.
    + intros x w Hx. right. now apply (R2 x w).
    + intros x t [<- | Hx] Ht Hl; [now destruct (no_start e t Ht) | now apply K with t].
Qed.

Theorem search_invariant taken : NoDup taken -> incl taken es -> invariant taken (fold_right take start taken).
Proof.
  induction taken as [| e taken IH]; intros Hd Hi; [exact start_invariant |]. inversion_clear Hd as [| ? ? Hn Hd'].
  cbn [fold_right]. apply take_invariant; [apply Hi; now left | exact Hn |].
  apply IH; [exact Hd' | intros x Hx; apply Hi; now right].
Qed.

(** *** The nearest of the candidates. m == the least parameter of all *)
Section Nearest.
Variable m : R.
Hypothesis m_least : forall e t, In e es -> met e t -> m <= t.

(** Every candidate is right, those at m are among them, and each is named once. *)
Definition good (l : list candidate) : Prop :=
  right_candidates l /\ (forall e, In e es -> is_least (met e) m -> exists v, In (e, v) l) /\ NoDup (map fst l).

Lemma good_map f l : (forall e v t, In e es -> is_least (met e) t -> tells e v t ->
  fst (f (e, v)) = e /\ tells e (snd (f (e, v))) t) -> good l -> good (map f l).
Proof.
  intros Hf [G1 [G2 G3]].
  assert (N : map fst (map f l) = map fst l).
  { rewrite map_map. apply map_ext_in. intros [e v] Hin. destruct (G1 e v Hin) as [He [t [Ht Hv]]].
    now apply (Hf e v t). }
  split; [| split; [| now rewrite N]].
  - intros e v Hin. apply in_map_iff in Hin as [[e' v'] [Heq Hin]]. destruct (G1 e' v' Hin) as [He [t [Ht Hv]]].
    destruct (Hf e' v' t He Ht Hv) as [E1 E2]. rewrite Heq in E1, E2. cbn in E1, E2. subst e'.
    split; [exact He | now exists t].
  - intros e He Hm. destruct (G2 e He Hm) as [v Hin]. destruct (G1 e v Hin) as [_ [t [Ht Hv]]].
    destruct (Hf e v t He Ht Hv) as [E1 _]. exists (snd (f (e, v))). apply in_map_iff. exists (e, v).
    split; [| exact Hin]. destruct (f (e, v)) as [x w]. cbn in *. now subst x.
Qed.

Lemma good_filter p l : (forall e v t, In (e, v) l -> is_least (met e) t -> tells e v t -> p (e, v) = false -> m < t) ->
  good l -> good (filter p l).
Proof.
  intros Hp [G1 [G2 G3]]. split; [| split; [| now apply NoDup_filter]].
  - intros e v Hin. apply filter_In in Hin as [Hin _]. now apply G1.
  - intros e He Hm. destruct (G2 e He Hm) as [v Hin]. exists v. apply filter_In. split; [exact Hin |].
    destruct (p (e, v)) eqn:Hpe; [reflexivity |]. destruct (G1 e v Hin) as [_ [t [Ht Hv]]].
    pose proof (Hp e v t Hin Ht Hv Hpe). rewrite (least_unique _ _ _ Ht Hm) in *. lra.
Qed.

(** Dropping what is farther than one of the candidates loses none of those at m, if "farther" is so. *)
Lemma good_not_farther first farther l :
  (forall e v t e' v' t', In (e, v) l -> In (e', v') l -> tells e v t -> tells e' v' t' ->
    farther (e, v) (e', v') = true -> t < t') ->
  good l -> good (not_farther first farther l).
Proof.
  intros Hf G. destruct l as [| c l]; [exact G |]. unfold not_farther.
  pose proof (least_by_in first l c) as Hleast. set (d := least_by first c l) in *. destruct d as [e0 v0].
  pose proof G as [G1 _]. destruct (G1 e0 v0 Hleast) as [He0 [t0 [Ht0 Hv0]]].
  apply good_filter; [| exact G]. intros e v t Hin Ht Hv Hp. apply negb_false_iff in Hp.
  pose proof (Hf e0 v0 t0 e v t Hleast Hin Hv0 Hv Hp). pose proof (m_least e0 t0 He0 (proj1 Ht0)). lra.
Qed.

Lemma refine_right e v t : In e es -> is_least (met e) t -> tells e v t ->
  fst (refine (e, v)) = e /\ tells e (snd (refine (e, v))) t.
Proof.
  intros He Ht Hv. unfold refine. cbn [fst snd]. destruct v as [f | f | x]; [| now split | now split].
  pose proof Hv as [Hr _]. pose proof (stable_decides right e infinite He Hr) as D.
  destruct (stable e infinite) as [| g |] eqn:E1; [now split | | now split]. cbn. split; [reflexivity |].
  destruct D as [u [Hu Hg]]. rewrite (least_unique _ _ _ Ht Hu). split; [exact Hr | split; [now exists infinite | exact Hg]].
Qed.
Lemma exactly_right e v t : In e es -> is_least (met e) t -> tells e v t ->
  fst (exactly (e, v)) = e /\ tells e (snd (exactly (e, v))) t /\ exists x, snd (exactly (e, v)) = By_exact x.
Proof.
  intros He Ht Hv. unfold exactly. cbn [fst snd]. pose proof (exact_step e He) as X.
  assert (Y : exists x, reach_of e = At x /\ valid x /\ val x = t).
  { destruct (reach_of e) as [| x |]; cbn in X.
    - now destruct (X t (proj1 Ht)).
    - exists x. destruct X as [X1 [X2 X3]]. split; [reflexivity | split; [exact X1 |]].
      now apply least_unique with (met e).
    - exfalso. apply (no_start e t Ht). destruct X as [eps [Hpos H]]. exists eps. split; [exact Hpos |].
      intros u Hu. apply H. lra. }
  destruct Y as [x [Hx [Hvalid Hval]]]. rewrite Hx.
  destruct v as [f | f | y]; cbn [fst snd]; (split; [reflexivity |]);
    [split; [now split | now exists x].. | split; [exact Hv | now exists y]].
Qed.

(** After the exact step nothing but the candidates at m is left. *)
Lemma exact_leaves_nearest l : good l -> (exists e, In e es /\ is_least (met e) m) ->
  good (nearest_by_exact l) /\ forall e v, In (e, v) (nearest_by_exact l) -> is_least (met e) m.
Proof.
  intros G [e0 [He0 Hm0]]. unfold nearest_by_exact. set (l' := map exactly l).
  assert (G' : good l').
  { apply good_map; [| exact G]. intros e v t He Ht Hv. pose proof (exactly_right e v t He Ht Hv). tauto. }
  assert (X : forall e v, In (e, v) l' -> exists x, v = By_exact x /\ valid x /\ is_least (met e) (val x)).
  { intros e v Hin. apply in_map_iff in Hin as [[e' v'] [Heq Hin]]. destruct G as [G1 _].
    destruct (G1 e' v' Hin) as [He [t [Ht Hv]]]. destruct (exactly_right e' v' t He Ht Hv) as [E1 [E2 [x E3]]].
    rewrite Heq in E1, E2, E3. cbn in E1, E2, E3. subst e' v. exists x. destruct E2 as [E2 <-]. split; [reflexivity | now split]. }
  set (at_ (c : candidate) := match snd c with By_exact x => val x | _ => 0 end).
  assert (C : forall a b, In a l' -> In b l' -> (by_exact a b = true <-> at_ a < at_ b)).
  { intros [a va] [b vb] Ha Hb. destruct (X a va Ha) as [x [-> [Hx _]]], (X b vb Hb) as [y [-> [Hy _]]].
    unfold by_exact, at_. cbn [snd]. rewrite Z.ltb_lt.
    destruct (cmp_correct x y Hx Hy) as [[-> H] | [[-> H] | [-> H]]]; split; intros; try lia; lra. }
  assert (F : good (not_farther by_exact by_exact l')).
  { apply good_not_farther; [| exact G']. intros e v t e' v' t' Hin Hin' Hv Hv' Hless. apply C in Hless; [| assumption..].
    destruct (X e v Hin) as [x [-> _]], (X e' v' Hin') as [y [-> _]]. destruct Hv as [_ <-], Hv' as [_ <-]. exact Hless. }
  split; [exact F |]. intros e v Hin.
  destruct l' as [| c l1] eqn:El; [destruct Hin |]. unfold not_farther in Hin. apply filter_In in Hin as [Hin Hp].
  destruct (X e v Hin) as [x [-> [_ Hx]]].
  destruct G' as [G1 [G2 _]]. destruct (G2 e0 He0 Hm0) as [v0 Hin0]. destruct (X e0 v0 Hin0) as [y [-> [_ Hy]]].
  pose proof (least_by_least by_exact at_ l1 c C _ Hin0) as Hl. cbn [snd] in Hl.
  assert (Eym : val y = m) by now apply least_unique with (met e0).
  assert (Hle : val x <= at_ (least_by by_exact c l1)).
  { apply Rnot_lt_le. intros Hlt. apply negb_true_iff in Hp.
    assert (by_exact (least_by by_exact c l1) (e, By_exact x) = true) by (apply C; [apply least_by_in | exact Hin | exact Hlt]).
    congruence. }
  replace m with (val x); [exact Hx |]. apply Rle_antisym; [| apply (m_least e); [now apply (G1 e (By_exact x)) | apply Hx]].
  apply Rle_trans with (1 := Hle). rewrite <- Eym. exact Hl.
Qed.

Lemma nearest_right l : good l -> (exists e, In e es /\ is_least (met e) m) ->
  good (nearest l) /\ forall e v, In (e, v) (nearest l) -> is_least (met e) m.
Proof.
  intros G Hm.
  assert (Alone : forall k, good k -> several k = false -> forall e v, In (e, v) k -> is_least (met e) m).
  { intros k [K1 [K2 _]] Hs e v Hin. destruct Hm as [e0 [He0 Hm0]]. destruct (K2 e0 He0 Hm0) as [v0 Hin0].
    destruct k as [| a [| b k]]; try discriminate; [destruct Hin |].
    destruct Hin as [-> | []]. destruct Hin0 as [[= -> ->] | []]. exact Hm0. }
  unfold nearest. set (l' := if several l then nearest_by_stable l else l).
  assert (G' : good l').
  { unfold l'. destruct (several l); [| exact G]. unfold nearest_by_stable.
    assert (Gr : good (map refine l)) by (apply good_map; [apply refine_right | exact G]).
    destruct (forallb is_stable (map refine l)); [| exact Gr]. apply good_not_farther; [| exact Gr].
    intros e v t e' v' t' _ _ Hv Hv' Hless. unfold by_finding in Hless. cbn [snd] in Hless.
    destruct v as [f | f | x], v' as [g | g | y]; try discriminate.
    destruct Hv as [_ [_ Hv]], Hv' as [_ [_ Hv']]. now apply (certainly_less_is_less right f g). }
  destruct (several l') eqn:Hs; [now apply exact_leaves_nearest | split; [exact G' | now apply Alone]].
Qed.
End Nearest.

(** What is rounded is right, by whichever step. *)
Lemma round_right e v t : In e es -> is_least (met e) t -> tells e v t ->
  exists out, round_candidate (e, v) = Some out /\ rounds out t.
Proof.
  intros He Ht Hv. destruct (exactly_right e v t He Ht Hv) as [_ [Htell [x Hx]]]. rewrite Hx in Htell.
  destruct Htell as [Hvalid Hval]. pose proof (round_exact_right right x Hvalid) as Rx. rewrite Hval in Rx.
  unfold round_candidate. unfold exactly in Hx. cbn [fst snd] in Hx.
  assert (S : in_range e = true -> forall out, attempt e (stable e infinite) = Some out -> rounds out t).
  { intros Hr out H. pose proof (stable_decides right e infinite He Hr) as D.
    destruct (stable e infinite) as [| g |] eqn:Hs; cbn in H; try discriminate. destruct D as [u [Hu Hg]].
    rewrite <- (least_unique _ _ _ Ht Hu) in Hg.
    exact (rounded_is_certain right e g out t He (conj Hr (or_introl (ex_intro _ _ Hs))) Ht H Hg). }
  destruct v as [f | f | y]; [destruct Hv as [Hr [Hby Hf]] | destruct Hv as [Hr [Hby Hf]] |].
  - assert (Last : reach_of e = At x) by (destruct (reach_of e) as [| z |]; cbn in Hx; congruence). rewrite Last.
    destruct (attempt e (improved e f)) as [out |] eqn:A1.
    + exists out. split; [reflexivity |]. destruct (improved e f) as [| g |] eqn:I; cbn in A1; try discriminate.
      destruct Hby as [b Hb]. apply (rounded_is_certain right e g out t He); auto.
      * split; [exact Hr | right; now exists f, b].
      * apply (improved_near right e f g t); auto. now exists b.
    + destruct (attempt e (stable e infinite)) as [out |] eqn:A2; [exists out; split; [reflexivity | now apply S] |].
      now exists (round_exact x).
  - assert (Last : reach_of e = At x) by (destruct (reach_of e) as [| z |]; cbn in Hx; congruence). rewrite Last.
    destruct (rounded e f) as [out |] eqn:A1; [| now exists (round_exact x)]. exists out.
    split; [reflexivity | exact (rounded_is_certain right e f out t He (conj Hr (or_introl Hby)) Ht A1 Hf)].
  - injection Hx as ->. now exists (round_exact x).
Qed.

(** What an answer has to be. *)
Definition right_answer (a : answer) : Prop :=
  match a with
  | Published_miss => forall e t, In e es -> ~ met e t
  | Published_no_minimum l => l <> [] /\ NoDup l /\ forall e, In e l <-> In e es /\ starts_in (met e)
  | Published_hit out l => l <> [] /\ NoDup l /\ exists t,
      (forall e t', In e es -> met e t' -> t <= t') /\ (forall e, In e l <-> In e es /\ is_least (met e) t)
      /\ exists o, out = Some o /\ rounds o t
  end.

(** The search over any elements, each once, that leaves out only what it does not meet up to its limit. *)
Theorem search_right taken st : st = fold_right take start taken -> NoDup taken -> incl taken es ->
  (forall e t, In e es -> met e t -> In e taken \/ ~ at_least (limit st) t) -> right_answer (published st).
Proof.
  intros Est Hd Hi Hout. pose proof (search_invariant taken Hd Hi) as H. rewrite <- Est in H. clear Est.
  pose proof H as [W1 W2 R1 R2 R3 L K]. unfold published.
  assert (Begun : forall e, In e es -> starts_in (met e) -> In e taken).
  { intros e He S. destruct (starts_within _ _ e H S) as [t [Ht Hl]]. now destruct (Hout e t He Ht). }
  destruct (without_minimum st) as [| e0 without] eqn:Ew.
  2:{ cbn -[In]. split; [discriminate | split; [exact W2 |]]. intros e. rewrite W1. split.
      - intros [He S]. split; [now apply Hi | exact S].
      - intros [He S]. split; [now apply Begun | exact S]. }
  assert (NoStart : forall e, In e es -> ~ starts_in (met e)).
  { intros e He S. destruct (proj2 (W1 e) (conj (Begun e He S) S)). }
  assert (Firsts : forall e, In e es -> (exists t, is_least (met e) t) \/ forall t, ~ met e t).
  { intros e He. pose proof (exact_step e He) as F. destruct (reach_of e) as [| x |]; cbn in F; [now right | |].
    - left. exists (val x). now split.
    - destruct (NoStart e He), F as [eps [Hpos F]]. exists eps. split; [exact Hpos |]. intros t Ht. apply F. lra. }
  destruct (least_of_finite E es met Firsts) as [[m [[e1 [He1 Hm1]] Hm]] | None_].
  - assert (M : forall e t, In e es -> met e t -> m <= t) by (intros e t He Ht; apply Hm; now exists e).
    assert (Hm1' : is_least (met e1) m) by (split; [exact Hm1 | intros t Ht; now apply (M e1)]).
    assert (Lm : at_least (limit st) m).
    { destruct L as [-> | [e [v [t [Hin [Ht Hl]]]]]]; [now left |]. apply at_least_below with t; [| exact Hl].
      apply (M e); [now apply Hi, (R2 e v) | apply Ht]. }
    assert (G : good m (candidates st)).
    { split; [exact R1 | split; [| exact R3]]. intros e He Hem.
      destruct (Hout e m He (proj1 Hem)) as [Htk | N]; [| contradiction]. now apply K with m. }
    destruct (nearest_right m M (candidates st) G (ex_intro _ e1 (conj He1 Hm1'))) as [[N1 [N2 N3]] N4].
    destruct (nearest (candidates st)) as [| [e v] l] eqn:En; [now destruct (N2 e1 He1 Hm1') |].
    cbn -[In map]. split; [discriminate | split; [exact N3 |]]. exists m. split; [exact M | split].
    + intros x. split.
      * intros Hx. apply in_map_iff in Hx as [[y w] [<- Hy]]. split; [now apply (N1 y w) | now apply (N4 y w)].
      * intros [Hx Hxm]. destruct (N2 x Hx Hxm) as [w Hw]. now apply (in_map fst) in Hw.
    + destruct (N1 e v (or_introl eq_refl)) as [He [t [Ht Hv]]].
      rewrite (least_unique _ _ _ (N4 e v (or_introl eq_refl)) Ht). apply round_right; assumption.
  - assert (En : nearest (candidates st) = []).
    { destruct (candidates st) as [| [e v] l] eqn:Ec; [reflexivity |].
      destruct (R1 e v (or_introl eq_refl)) as [He [t [[Ht _] _]]]. now destruct (None_ e t He). }
    rewrite En. cbn. exact None_.
Qed.

End Search.
