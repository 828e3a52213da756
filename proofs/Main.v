(** What is proved of the program, and nothing else: each statement in full, each proof a reference to where it is done. It
    goes on from MainText.v, which has the names, MainModels.v, MainMeshes.v and MainHistory.v; the five hold the final statements.

    Walk.walks, Walk.leads == a traversal as it runs; a path of cells, each of which holds the parameter, to an element
    Search.published st  == what the search publishes; Chain.says a == it is the text's answer, each number rounded once *)
From Coq Require Import Reals List.
From Flocq Require Raux Zaux Generic_fmt FLT.
From Durero Require Import Toolkit Especificacion.
From Durero Require MainText MainModels MainMeshes MainHistory Moments.
From Durero Require Escena Operaciones Edits Totals Errata Puntos Trazador Flat Interseccion Printed Retrieve Iluminacion
  Surd Exacto ExactoEscena Rounding Vectors Formas Decision Flotante Certified Twofold Sums Products
  Words Quick Once Newton Verdict Steps Triage Doubled Second AtRoot AtRootText Levels Running Walk Limits Search Boxes Lattice
  Grid Chain Line Crossings Trees Leaves Wide Occlusion Whole Recorded.
Import Escena Operaciones Edits Totals Errata Puntos Trazador Flat Interseccion Printed Retrieve Iluminacion.
Local Open Scope R_scope.
Local Open Scope zed_scope.

(** * 9. Floating point *)

(** What the certified tracer decides on a sphere, in binary64. Formas.v has what its C++ templates compute, written by
    them: recorded is the quadratic of the ray and the sphere, first_in_lanes the decision for rays in a batch. *)
Section Sphere.
Variables (p v centro : Vectors.vec) (r : R).
Hypothesis p_ordinary : Flotante.ordinary_vec p.
Hypothesis v_ordinary : Flotante.ordinary_vec v.
Hypothesis centro_ordinary : Flotante.ordinary_vec centro.
Hypothesis r_ordinary : Flotante.ordinary r.
Hypothesis r_positive : 0 < r.
Hypothesis v_not_zero : 0 < Vectors.norm v.
Let point (a : Vectors.vec) := mk_Punto (Vectors.cx a) (Vectors.cy a) (Vectors.cz a).
Let direction (a : Vectors.vec) := mk_Vector (Vectors.cx a) (Vectors.cy a) (Vectors.cz a).
Let ray := mk_Rayo (point p) (direction v).
Let f := of_esfera ray (point centro) r.
Let recorded := Formas.esfera p v (Formas.speed_of v) centro r.

(** A certified miss is one: no point of the line lies on the sphere. *)
Theorem a_certified_miss_is_a_miss t : Formas.F recorded < - Formas.B_error recorded ->
  point_at ray t ∉ puntos_esfera (point centro) r.
Proof. now apply Certified.certified_miss. Qed.

(** A certified pair of points is one, and the computed root of the discriminant is within its bound. *)
Theorem a_certified_root_of_the_discriminant : Formas.B_error recorded < Formas.F recorded ->
  let S := Formas.root_of_discriminant recorded in
  0 < discriminant f /\ Rabs (Formas.value S - sqrt (discriminant f)) <= Formas.error S.
Proof. now apply Certified.certified_discriminant. Qed.

(** Where both roots are computed, they are the two there are, in their order, each within its bound. *)
Theorem certified_roots : Decision.has_roots recorded = true ->
  exists t0 t1, t0 < t1 /\ (forall t, value f t = 0 <-> t = t0 \/ t = t1)
  /\ Rabs (Formas.value (Decision.nearer recorded) - t0) <= Formas.error (Decision.nearer recorded)
  /\ Rabs (Formas.value (Decision.farther recorded) - t1) <= Formas.error (Decision.farther recorded).
Proof. now apply Certified.certified_roots. Qed.

(** The whole decision: a hit is within its error of the least parameter of a point, and a miss is one. *)
Theorem the_decision_on_a_sphere_is_right :
  let met t := 0 < t /\ point_at ray t ∈ puntos_esfera (point centro) r in
  let d := Formas.first_in_lanes recorded in
  (Formas.hit d = true ->
   exists t, is_least met t /\ Rabs (Formas.value (Formas.root d) - t) <= Formas.error (Formas.root d))
  /\ (Formas.hit d = false -> Formas.undecided d = false -> forall t, ~ met t).
Proof. now apply Certified.decision_in_lanes. Qed.
End Sphere.

(** The same of a cylinder, up to its clip: recorded is the quadratic of the ray and its unbounded surface. *)
Section Cylinder.
Variables (p v centro d : Vectors.vec) (r h : R).
Hypothesis p_ordinary : Flotante.ordinary_vec p.
Hypothesis v_ordinary : Flotante.ordinary_vec v.
Hypothesis centro_ordinary : Flotante.ordinary_vec centro.
Hypothesis d_ordinary : Flotante.ordinary_vec d.
Hypothesis r_ordinary : Flotante.ordinary r.
Hypothesis r_positive : 0 < r.
Hypothesis v_not_zero : 0 < Vectors.norm v.
Let point (a : Vectors.vec) := mk_Punto (Vectors.cx a) (Vectors.cy a) (Vectors.cz a).
Let direction (a : Vectors.vec) := mk_Vector (Vectors.cx a) (Vectors.cy a) (Vectors.cz a).
Hypothesis d_unit : direction d ∈ Unitario.
Let ray := mk_Rayo (point p) (direction v).
Let f := of_cilindro ray (point centro) r (direction d) h.
Let recorded := Formas.cilindro p v (Formas.speed_of v) centro r d h.

(** A certified miss is one: no point of the line lies on the surface. *)
Theorem a_certified_miss_of_a_cylinder_is_a_miss t : Formas.F recorded < - Formas.B_error recorded ->
  potencia_cilindro (point_at ray t) (point centro) r (direction d) <> 0.
Proof. now apply Certified.cylinder_miss. Qed.

(** Where both roots are computed, they are the two there are, in their order, each within its bound. *)
Theorem certified_roots_of_a_cylinder : Decision.has_roots recorded = true ->
  exists t0 t1, t0 < t1 /\ (forall t, value f t = 0 <-> t = t0 \/ t = t1)
  /\ Rabs (Formas.value (Decision.nearer recorded) - t0) <= Formas.error (Decision.nearer recorded)
  /\ Rabs (Formas.value (Decision.farther recorded) - t1) <= Formas.error (Decision.farther recorded).
Proof. now apply Certified.cylinder_roots. Qed.
End Cylinder.

(** The numbers of 53 bits, from 2^-1074 up. *)
Notation format := (Generic_fmt.generic_format Zaux.radix2 (FLT.FLT_exp (-1074) 53)).

(** What double-double keeps whole: a sum, and a product that does not underflow, with a fused operation or without. *)
Theorem double_double_keeps_sums_and_products_whole a b : format a -> format b ->
  Twofold.whole (Formas.Pairs.two_sum a b) = a + b
  /\ (a = 0 \/ Rabs b <= Rabs a -> Twofold.whole (Formas.Pairs.fast_two_sum a b) = a + b)
  /\ (Rounding.grid (-969) (a * b) -> Twofold.whole (Formas.Pairs.two_prod a b) = a * b
     /\ Formas.Pairs.two_prod_of_halves a b = Formas.Pairs.two_prod a b).
Proof. exact (Twofold.sums_and_products_whole a b). Qed.

(** What a sum, a difference, a product, a quotient and a square root of double-doubles lose: less than 2^-102 of it. Each
    is a double-double whose first part is the whole, rounded once. A sum never underflows; a product, where the leading
    parts' product is 0 or not below 2^-960; a quotient and a root, where they and what is divided are not below 2^-900. *)
Theorem double_doubles_are_within_their_bounds x y : Sums.double_word x -> Sums.double_word y ->
  Words.within_bound (Formas.Pairs.sum x y) (Twofold.whole x + Twofold.whole y)
  /\ Words.within_bound (Formas.Pairs.difference x y) (Twofold.whole x - Twofold.whole y)
  /\ (Products.worthy (Formas.Pairs.hi x * Formas.Pairs.hi y) ->
     Words.within_bound (Formas.Pairs.product x y) (Twofold.whole x * Twofold.whole y))
  /\ (Raux.bpow Zaux.radix2 (-900) <= Rabs (Formas.Pairs.hi x) -> Formas.Pairs.hi y <> 0 ->
     Raux.bpow Zaux.radix2 (-900) <= Rabs (Formas.Pairs.hi x / Formas.Pairs.hi y) ->
     Words.within_bound (Formas.Pairs.ratio x y) (Twofold.whole x / Twofold.whole y))
  /\ (Raux.bpow Zaux.radix2 (-900) <= Formas.Pairs.hi x ->
     Words.within_bound (Formas.Pairs.root_of x) (sqrt (Twofold.whole x))).
Proof. exact (Words.operations_near x y). Qed.

(** Two crossings of planes across the axes are compared as their exact moments are: by the computed parameters where these
    are far enough apart, and else by exact numbers. And what is entered beyond the limit lies beyond it. *)
Theorem crossings_are_in_the_order_of_their_moments p v : Crossings.ordinary p v ->
  forall a b A B, Crossings.stands64 p v a A -> Crossings.stands64 p v b B ->
  match Crossings.order64 p v a b with
  | Lt => Moments.sooner A B
  | Eq => ~ Moments.sooner A B /\ ~ Moments.sooner B A
  | Gt => Moments.sooner B A
  end.
Proof.
  intros H a b A B Ha Hb. pose proof (Crossings.order64_right p v H a b A B Ha Hb) as K.
  destruct (Crossings.order64 p v a b); [exact (conj (proj2 K) (proj1 K)) | exact K | exact K].
Qed.
Theorem what_is_entered_beyond_the_limit_lies_beyond p v : Crossings.ordinary p v ->
  forall c m limit t, Crossings.stands64 p v c (Moments.At m) -> 0 <= fst m -> Crossings.beyond64 c limit = true -> fst m <= t ->
  ~ Limits.at_least limit t.
Proof. exact (Crossings.beyond64_right p v). Qed.

(** A root that a step of Newton's improved is within the error that is computed with it. *)
Theorem an_improved_root_is_within_its_error t slope a at_t A B C T : Newton.binary64s t slope a at_t ->
  A * T * T + 2 * B * T + C = 0 -> Rabs (T - Formas.value t) <= Formas.error t ->
  Rabs (A * T + B - Formas.value slope) <= Formas.error slope -> Rabs (A - Formas.value a) <= Formas.error a ->
  Rabs (A * Formas.value t * Formas.value t + 2 * B * Formas.value t + C - Twofold.whole (Formas.value at_t))
    <= Formas.error at_t ->
  let n := Formas.Pairs.newton t slope a at_t in Formas.Pairs.known_slope n = true ->
  Rabs (T - Twofold.whole (Formas.Pairs.better n)) <= Formas.Pairs.better_error n /\ Twofold.pair (Formas.Pairs.better n)
  /\ format (Formas.Pairs.better_error n) /\ Raux.bpow Zaux.radix2 (-900) <= Formas.Pairs.better_error n.
Proof. intros binary root. exact (Newton.newton_near t slope a at_t binary A B C T root). Qed.

(** What is certain is rounded right: where a pair is within its error of the parameter, and the program calls its rounding
    certain, what it stores are the parameter and the point, rounded once. *)
Theorem what_is_certain_is_rounded_right p v t error T out : Flotante.ordinary_vec p -> Flotante.ordinary_vec v ->
  Twofold.pair t -> format error -> Raux.bpow Zaux.radix2 (-900) <= error ->
  Rabs (T - Twofold.whole t) <= error ->
  let once := Formas.Pairs.round_point p v t error in Formas.Pairs.all_certain once = true -> Once.stores out once ->
  Chain.rounds (mk_Rayo (mk_Punto (Vectors.cx p) (Vectors.cy p) (Vectors.cz p))
    (mk_Vector (Vectors.cx v) (Vectors.cy v) (Vectors.cz v))) out T.
Proof. exact (Once.certain_is_rounded_right p v t error T out). Qed.

(** The exact rounding in integers of 128 bits: where it says anything, it is what the number (x + y√delta)/w rounds to, under
    any rounding that does not decrease. Quick.v has number/quick_round step by step. *)
Theorem the_quick_rounding_says_nothing_false round mx ex my ey md ed mw ew out :
  (forall a b, a <= b -> round a <= round b) -> BinInt.Z.le 0 md -> mw <> 0%Z -> ((my = 0 \/ md = 0)%Z -> mx <> 0%Z) ->
  Quick.quick round mx ex my ey md ed mw ew = Some out ->
  out = round ((Quick.dyadic mx ex + Quick.dyadic my ey * sqrt (Quick.dyadic md ed)) / Quick.dyadic mw ew).
Proof. exact (Quick.quick_is_right round mx ex my ey md ed mw ew out). Qed.

(** * 10. What the tracer decides of one element, in binary64

    Triage.shape has the numbers of an element, Triage.stands s e sh that e has them in s. The decisions are the recorded
    terms of Formas.v: Triage.lanes_of for rays in a batch, Triage.alone_of for one ray up to a limit, each for a ray that
    starts on the element (on) or does not. *)

(** They are for numbers within bounds. The program asks for that, by the recorded test, of numbers that are binary64. *)
Theorem the_range_that_is_asked_is_that_of_the_bounds p v sh : Triage.binary64s p v sh ->
  Triage.asked_in_range p v sh = true <-> Triage.in_bounds p v sh.
Proof. exact (Triage.asked_in_range_in_bounds p v sh). Qed.

Section Decisions.
Variable Elemento : Type.
Variables (s : Escena Elemento) (en : set Elemento) (p v : Vectors.vec).
Notation ray := (Steps.ray_of p v).
Hypothesis ok : Escena_ok s.
Hypothesis ray_ok : Rayo_ok ray.
Hypothesis ray_ordinary : Flotante.ordinary_ray p v.
Notation met := (met ray Elemento s en).

(** In lanes: a hit is within its error of the least parameter at which the ray meets the element, and a miss is one. *)
Theorem the_decisions_in_lanes_are_right e sh on :
  Triage.stands Elemento s e sh -> Triage.ordinary_shape sh -> (on = true <-> en e) ->
  let d := Triage.lanes_of p v sh on in
  (Formas.hit d = true ->
   exists t, is_least (met e) t /\ Rabs (Formas.value (Formas.root d) - t) <= Formas.error (Formas.root d))
  /\ (Formas.hit d = false -> Formas.undecided d = false -> forall t, ~ met e t).
Proof. exact (Triage.lanes_within Elemento s ok en p v ray_ok ray_ordinary e sh on). Qed.

(** For one ray: as well, where a miss is one up to the limit. *)
Theorem the_decisions_up_to_a_limit_are_right e sh on limit :
  Triage.stands Elemento s e sh -> Triage.ordinary_shape sh -> (on = true <-> en e) ->
  match Triage.alone_of p v sh on limit with
  | Formas.Miss => forall t, met e t -> limit < t
  | Formas.Undecided => True
  | Formas.Hit root _ _ => exists t, is_least (met e) t /\ Rabs (Formas.value root - t) <= Formas.error root
  end.
Proof. exact (Triage.alone_within Elemento s ok en p v ray_ok ray_ordinary e sh on limit). Qed.

(** So the triage of the search is right: the first sentence of [Search.steps_right], where what is in range has
    ordinary numbers, the ray's and the element's, and the triage of an element is that decision up to the limit. *)
Theorem the_triage_says_nothing_false elements (shape_of : Elemento -> Triage.shape) on in_range triage :
  (forall e, In e elements -> Triage.stands Elemento s e (shape_of e) /\ (on e = true <-> en e)) ->
  (forall e, In e elements -> in_range e = true -> Triage.in_bounds p v (shape_of e)) ->
  (forall e x, In e elements -> in_range e = true ->
   exists a, Triage.answered (Triage.alone_of p v (shape_of e) (on e)) x a /\ triage e x = Triage.verdict_of a) ->
  Search.decides Elemento (Formas.known R) met elements in_range Quotient.is_near triage.
Proof.
  intros described range computed.
  exact (Triage.triage_decides Elemento s ok en p v ray_ok elements shape_of on in_range described range
    triage computed).
Qed.

(** The second step, in double-double, on every shape: the same of the parameter; and where the rounding of what it finds is
    certain, what is stored are the parameter and the point of the text, each rounded once. *)
Theorem the_second_step_is_right e sh on limit :
  Triage.stands Elemento s e sh -> Triage.ordinary_shape sh -> (on = true <-> en e) -> format limit ->
  match Second.second_of p v sh on limit with
  | Formas.Miss => forall t, met e t -> limit < t
  | Formas.Undecided => True
  | Formas.Hit root _ _ => exists t, is_least (met e) t
      /\ Rabs (t - Twofold.whole (Formas.value root)) <= Formas.error root
      /\ forall out, let once := Formas.Pairs.round_point p v (Formas.value root) (Formas.error root) in
        Formas.Pairs.all_certain once = true -> Once.stores out once -> Chain.rounds ray out t
  end.
Proof.
  exact (Second.second_right Elemento s en p v ok ray_ok ray_ordinary e sh on limit).
Qed.

(** The quadratic that a step of Newton's asks, at a root T with a slope: at any parameter t, what is computed of it is within
    its bound, beside which nothing that follows underflows. *)
Theorem the_quadratic_at_a_root_is_within_its_error e sh (on : bool) t T :
  Triage.stands Elemento s e sh -> Triage.ordinary_shape sh -> format t ->
  let f := if on then Puntos.launched (Triage.text_of p v sh) else Triage.text_of p v sh in
  0 < T -> value f T = 0 -> cA f * T + cB f <> 0 ->
  let q := AtRootText.at_root p v sh on t in
  AtRoot.within_error q (value f t) /\ Raux.bpow Zaux.radix2 (-900) <= Formas.error q
  /\ Raux.bpow Zaux.radix2 (-900) * (4 * Rabs (cA f * T + cB f)) <= Formas.error q.
Proof. exact (AtRootText.at_root_right Elemento s ok p v ray_ordinary e sh on t T). Qed.

(** What is rounded of a hit of an element: where its plane stands at a right angle to an axis, the coordinate that all its
    points have, and else as above. *)
Theorem what_is_certain_on_an_element_is_rounded_right e sh t error T out :
  Triage.stands Elemento s e sh -> Triage.ordinary_shape sh ->
  (Levels.is_flat sh = true -> value (Triage.text_of p v sh) T = 0) ->
  Twofold.pair t -> format error -> Raux.bpow Zaux.radix2 (-900) <= error -> Rabs (T - Twofold.whole t) <= error ->
  let once := Levels.round_on p v sh t error in
  Formas.Pairs.all_certain once = true -> Once.stores out once -> Chain.rounds ray out T.
Proof. exact (Levels.round_on_right Elemento s p v e sh t error T out ok ray_ordinary). Qed.

(** So the steps of the search as they run are right, [Search.steps_right]: of Running.steps_run, which says that its triage,
    its second step, the ends around a parameter, the Newton step, what is certainly less and its rounding are the recorded
    terms, and its exact rounding ExactHit.rounding of the exact parameter and of the point there. *)
Theorem the_steps_that_run_are_right elements (shape_of : Elemento -> Triage.shape) on in_range triage stable improved
  low high certainly_less rounded round_exact :
  (forall e, In e elements -> Triage.stands Elemento s e (shape_of e) /\ (on e = true <-> en e)) ->
  (forall e, In e elements -> in_range e = true -> Triage.in_bounds p v (shape_of e)) ->
  Running.steps_run Elemento p v elements shape_of on in_range triage stable improved low high certainly_less
    rounded round_exact ->
  Search.steps_right Elemento Running.finding Chain.printed met elements (Chain.rounds ray) in_range triage stable improved
    Running.near low high certainly_less rounded round_exact.
Proof.
  intros described range.
  exact (Running.steps_are_right Elemento s en p v ok ray_ok elements shape_of on in_range described range triage stable
    improved low high certainly_less rounded round_exact).
Qed.
End Decisions.

(** * 11. From the Z text to what is printed: the search as it runs *)
Section Chain.
Variable Elemento : Type.
Hypothesis Elemento_dec : forall e e' : Elemento, {e = e'} + {e <> e'}.
Notation Escena := (Escena Elemento).

(** The scene, its numbers integers over S; the question; and the elements, each with its shape and whether the ray is said
    to start on it. *)
Variables (S : BinNums.Z) (s s' : Escena) (en : set Elemento) (p v : Exacto.vec3).
Notation ray := (ExactoEscena.the_ray S p v).
Hypothesis S_positive : (0 < S)%Z.
Hypothesis ok : Escena_ok s.
Hypothesis ray_ok : Rayo_ok ray.
Hypothesis same : Xi_Escena s s'.
Hypothesis known : en ⊆ elementos s.
Variables (elements : list Elemento) (shape_of : Elemento -> Exacto.shape) (on : Elemento -> bool).
Hypothesis described : ExactoEscena.describes Elemento S s en (map (fun e => (e, shape_of e, on e)) elements).
Notation met := (met ray Elemento s en).

Notation reach_of := (Chain.reach_of Elemento S p v shape_of on).
Notation says := (Chain.says Elemento s s' ray en).

Section Steps.
(** The steps in floating point, of which nothing is assumed but [Search.steps_right]: a miss is one, a hit has the first
    parameter within its error, the ends lie around it, and what is certain is rounded. *)
Variables (Finding : Type) (in_range : Elemento -> bool)
  (triage stable : Elemento -> Limits.binary64 -> Search.verdict Finding)
  (improved : Elemento -> Finding -> Search.verdict Finding) (near : Finding -> set R)
  (low high : Search.evidence Finding -> Limits.binary64) (certainly_less ahead : Finding -> Finding -> bool)
  (rounded : Elemento -> Finding -> option Chain.printed) (round_exact : Surd.surd -> Chain.printed).
Hypothesis right : Search.steps_right Elemento Finding Chain.printed met elements (Chain.rounds ray) in_range triage stable
  improved near low high certainly_less rounded round_exact.

Notation found := (Search.found Elemento Finding).
Notation limit := (Search.limit Elemento Finding).
Notation take := (Search.take Elemento Finding reach_of in_range triage stable low high).
Notation start := (Search.start Elemento Finding).
Notation published := (Search.published Elemento Finding Chain.printed reach_of stable improved certainly_less ahead rounded
  round_exact).
Notation blocks := (Occlusion.blocks Elemento Finding reach_of in_range triage stable).
Notation blocks_segment := (Occlusion.blocks_segment Elemento Finding reach_of in_range triage stable low high).

(** Whatever walks over the elements: cells passed over by any rule that passes over nothing that the ray meets up to the
    limit, in any order; some elements apart. What is published at the end is Primera_Interseccion: outcome, elements, and
    the parameter and the point rounded once. *)
Theorem the_printed_hit_is_the_texts_hit (prunable : found -> Walk.cell Elemento -> Prop) apart cs taken st :
  (forall st c, prunable st c -> forall e t, Walk.leads c e t -> met e t -> ~ Limits.at_least (limit st) t) ->
  incl apart elements -> Forall (Walk.lists_from elements) cs ->
  (forall e t, In e elements -> ~ In e apart -> met e t -> exists c, In c cs /\ Walk.leads c e t) ->
  Walk.walks Elemento found Elemento_dec take prunable (Walk.plan apart cs, (nil, start)) (nil, (taken, st)) ->
  says (published st).
Proof. intros. eapply Chain.search_is_Primera_Interseccion; eassumption. Qed.

(** In a tree of boxes under the tests of Slab.v, in IEEE 754 arithmetic: the elements that the ray starts on are tested
    apart, and of each of the others the boxes above it contain its points. *)
Theorem bounding_volumes_as_they_run r apart a taken st : Boxes.of_beam r = ray ->
  incl apart elements -> (forall e, In e elements -> en e -> In e apart) ->
  Walk.lists_from elements (Boxes.cell_of Elemento r a) ->
  (forall e, In e elements -> ~ In e apart -> Boxes.under Elemento (puntos_de_elemento s) e a) ->
  Walk.walks Elemento found Elemento_dec take (Boxes.prunable Elemento found limit r)
    (Walk.plan apart (Boxes.cell_of Elemento r a :: nil), (nil, start)) (nil, (taken, st)) ->
  says (published st).
Proof. intros. eapply Chain.boxes_find_Primera_Interseccion; eassumption. Qed.

(** In a hierarchy of eight boxes a node, in binary32: the box of each element is its bounds, rounded outwards, and each box is
    within those above it. The planes are taken back to binary64, exactly, where the same tests ask of them, in any order. *)
Theorem eight_wide_nodes_as_they_run r bounds apart places taken st : Boxes.of_beam r = ray -> Wide.asked r ->
  incl apart elements -> (forall e, In e elements -> en e -> In e apart) ->
  Forall (Walk.lists_from elements) (Wide.cells_of Elemento r places) ->
  (forall e, In e elements -> ~ In e apart ->
   (forall w, puntos_de_elemento s e w -> Boxes.holds (bounds e) w) /\ Wide.lies_in Elemento e (Wide.Node Elemento places)) ->
  (forall c a, In (c, a) places -> Wide.nested Elemento bounds c a) ->
  Walk.walks Elemento found Elemento_dec take (Wide.prunable Elemento found limit r)
    (Walk.plan apart (Wide.cells_of Elemento r places), (nil, start)) (nil, (taken, st)) ->
  says (published st).
Proof.
  intros Hr Hin Ha Hen Hl He Hn Hw.
  destruct (Wide.places_are_well_walked Elemento s en elements apart found limit bounds r places Hin Hen He Hn) as [P L].
  rewrite Hr in L. eapply the_printed_hit_is_the_texts_hit; eauto.
Qed.

(** In a grid: what is walked are the cells that hold a point of the ray, each with its entry, by crossings that are ordered
    exactly; what is passed over lies beyond the limit, or outside the box of all. These are the premises above, where every
    cube lists what has a point in it. *)
Theorem grids_as_they_run corner h count lists (whole : set R) apart m c l :
  let p i := Chain.along (Rayo_p ray) i in let v i := Chain.component (Rayo_v ray) i in
  0 < h -> (forall e, In e elements -> en e -> In e apart) ->
  (forall e t, In e elements -> ~ In e apart -> puntos_de_elemento s e (point_at ray t) ->
   whole t /\ Lattice.in_box p v corner h count (t, false)
   /\ forall d, Lattice.in_range count d -> Grid.in_cube p v corner h d t -> In e (lists d)) ->
  Lattice.way_in p v corner h count m -> Lattice.in_cell p v corner h c m -> Lattice.in_range count c ->
  Lattice.path p v corner h count m c l ->
  (forall st k, Grid.prunable p v corner h Elemento found limit whole lists st k ->
   forall e t, Walk.leads k e t -> met e t -> ~ Limits.at_least (limit st) t)
  /\ forall e t, In e elements -> ~ In e apart -> met e t ->
     exists k, In k (map (Grid.cell_of p v corner h Elemento whole lists) l) /\ Walk.leads k e t.
Proof. exact (Chain.grid_is_walked Elemento s ray en elements found limit corner h count lists whole apart m c l). Qed.

(** In an octree, and in a tree of planes, by the walks of the headers in binary64: each leaf lists what has a point in it,
    closed; what is passed over is all, where the box of all is rejected, or what comes from a leaf on that is entered
    beyond the limit. The same premises again. *)
Theorem octrees_as_they_run r (in_order : Crossings.ordinary (Leaves.p_of r) (Leaves.v_of r)) Leaf lists all corner far
  apart a :
  Boxes.of_beam r = ray -> (forall i, Crossings.usable64 (corner i)) -> (forall i, Crossings.usable64 (far i)) ->
  Trees.middles_usable _ _ _ _ a -> (forall e, In e elements -> en e -> In e apart) ->
  (forall e, In e elements -> ~ In e apart -> Leaves.listed_by Elemento s Leaf lists all corner far
     (fun w n => Leaves.eighth_holds r in_order Leaf w n a) e) ->
  let walked := Leaves.tree_walk r in_order Leaf corner far (Trees.walk_eighths _ _ _ Leaf a) in
  (forall st k, Leaves.passed_over r Leaf Elemento found limit lists all walked st k ->
   forall e t, Walk.leads k e t -> met e t -> ~ Limits.at_least (limit st) t)
  /\ forall e t, In e elements -> ~ In e apart -> met e t ->
     exists k, In k (map (Leaves.cell_of r Leaf Elemento lists all) walked) /\ Walk.leads k e t.
Proof. intros <- **. now apply Leaves.eighths_are_well_walked. Qed.
Theorem bsp_trees_as_they_run r (in_order : Crossings.ordinary (Leaves.p_of r) (Leaves.v_of r)) Leaf lists all corner far
  apart a :
  Boxes.of_beam r = ray -> (forall i, Crossings.usable64 (corner i)) -> (forall i, Crossings.usable64 (far i)) ->
  Trees.planes_usable _ _ _ _ a -> (forall e, In e elements -> en e -> In e apart) ->
  (forall e, In e elements -> ~ In e apart -> Leaves.listed_by Elemento s Leaf lists all corner far
     (fun w n => Leaves.half_holds r in_order Leaf w n a) e) ->
  let walked := Leaves.tree_walk r in_order Leaf corner far (Trees.walk_halves _ _ _ Leaf a) in
  (forall st k, Leaves.passed_over r Leaf Elemento found limit lists all walked st k ->
   forall e t, Walk.leads k e t -> met e t -> ~ Limits.at_least (limit st) t)
  /\ forall e t, In e elements -> ~ In e apart -> met e t ->
     exists k, In k (map (Leaves.cell_of r Leaf Elemento lists all) walked) /\ Walk.leads k e t.
Proof. intros <- **. now apply Leaves.halves_are_well_walked. Qed.

(** A shadow ray: over a walk that may end once something blocks, or pass over what is met at or beyond the other end. *)
Theorem the_answer_to_a_shadow_ray_is_the_texts (prunable prunable1 : bool -> Walk.cell Elemento -> Prop) apart cs taken st
  taken1 st1 :
  (forall c e t, prunable false c -> Walk.leads c e t -> ~ met e t) ->
  (forall c e t, prunable1 false c -> Walk.leads c e t -> met e t -> 1 <= t) ->
  incl apart elements -> Forall (Walk.lists_from elements) cs ->
  (forall e t, In e elements -> ~ In e apart -> met e t -> exists c, In c cs /\ Walk.leads c e t) ->
  (Walk.walks Elemento bool Elemento_dec (Occlusion.take Elemento blocks) prunable (Walk.plan apart cs, (nil, false))
     (nil, (taken, st)) -> st = true <-> occluded s ray en)
  /\ (Walk.walks Elemento bool Elemento_dec (Occlusion.take Elemento blocks_segment) prunable1
     (Walk.plan apart cs, (nil, false)) (nil, (taken1, st1)) -> st1 = true <-> occluded_segment s ray en).
Proof.
  intros right0 right1 Ha Hl Hr. split.
  - now eapply Occlusion.blocked_is_occluded; eauto.
  - now eapply Occlusion.blocked_segment_is_occluded; eauto.
Qed.
End Steps.

Notation finding := Running.finding. Notation real := (Whole.vec_over S). Notation real_shape e := (Whole.shape_over S (shape_of e)).

(** There are steps of which all that is asked of steps that run holds: the terms as they are recorded. *)
Theorem the_recorded_terms_are_steps_that_run in_range : (exists k, (0 <= k)%Z /\ S = (2 ^ k)%Z) ->
  (forall e, In e elements -> in_range e = true -> Triage.in_bounds (real p) (real v) (real_shape e)) ->
  let shapes e := real_shape e in
  Running.steps_run Elemento (real p) (real v) elements shapes on in_range (Recorded.triage Elemento S p v shapes on)
    (Recorded.stable Elemento S p v shapes on) (Recorded.improved Elemento S p v shapes on) (Recorded.low S p v)
    (Recorded.high S p v) Recorded.less (Recorded.rounded Elemento S p v shapes) (Recorded.round_exact S p v).
Proof.
  intros power. exact (Recorded.steps_by_the_recorded_terms_run Elemento S p v _ on power s en elements in_range ok ray_ok
    (Whole.described_over Elemento S s en elements shape_of on described)).
Qed.

(** The whole, from the text to what is published: the same, of the steps that run. Of these nothing is assumed but what they
    compute, as in section 10, over the reals that the integers stand for; that these are binary64; and that floating point is
    asked only where the recorded test finds them in range. Where it does not, exact numbers answer. *)
Variables (in_range : Elemento -> bool) (triage stable : Elemento -> Limits.binary64 -> Search.verdict finding)
  (improved : Elemento -> finding -> Search.verdict finding) (low high : Search.evidence finding -> Limits.binary64)
  (certainly_less ahead : finding -> finding -> bool) (rounded : Elemento -> finding -> option Chain.printed)
  (round_exact : Surd.surd -> Chain.printed).
Hypothesis numbers : forall e, In e elements -> Triage.binary64s (real p) (real v) (real_shape e).
Hypothesis asked : forall e, In e elements -> in_range e = true ->
  Triage.asked_in_range (real p) (real v) (real_shape e) = true.
Notation ordinary := (fun e He asks => proj1 (the_range_that_is_asked_is_that_of_the_bounds (real p) (real v) (real_shape e)
  (numbers e He)) (asked e He asks)).
Hypothesis run : Running.steps_run Elemento (real p) (real v) elements (fun e => real_shape e) on in_range triage stable
  improved low high certainly_less rounded round_exact.
Notation right := (Whole.steps_are_right Elemento S s en p v ok ray_ok elements shape_of on in_range described ordinary triage
  stable improved low high certainly_less rounded round_exact run).
Notation found := (Search.found Elemento finding).
Notation take := (Search.take Elemento finding reach_of in_range triage stable low high).
Notation published := (Search.published Elemento finding Chain.printed reach_of stable improved certainly_less ahead rounded
  round_exact).

Theorem the_search_that_runs_publishes_the_texts_hit (prunable : found -> Walk.cell Elemento -> Prop) apart cs taken st :
  (forall st c, prunable st c -> forall e t, Walk.leads c e t -> met e t -> ~ Limits.at_least (Search.limit _ _ st) t) ->
  incl apart elements -> Forall (Walk.lists_from elements) cs ->
  (forall e t, In e elements -> ~ In e apart -> met e t -> exists c, In c cs /\ Walk.leads c e t) ->
  Walk.walks Elemento found Elemento_dec take prunable (Walk.plan apart cs, (nil, Search.start _ _)) (nil, (taken, st)) ->
  says (published st).
Proof.
  exact (the_printed_hit_is_the_texts_hit finding in_range triage stable improved Running.near low high certainly_less ahead
    rounded round_exact right prunable apart cs taken st).
Qed.

(** And so it answers a shadow ray. *)
Notation blocks := (Occlusion.blocks Elemento finding reach_of in_range triage stable).
Notation blocks_segment := (Occlusion.blocks_segment Elemento finding reach_of in_range triage stable low high).
Theorem the_search_that_runs_answers_shadow_rays_as_the_text (prunable prunable1 : bool -> Walk.cell Elemento -> Prop) apart cs
  taken st taken1 st1 :
  (forall c e t, prunable false c -> Walk.leads c e t -> ~ met e t) ->
  (forall c e t, prunable1 false c -> Walk.leads c e t -> met e t -> 1 <= t) ->
  incl apart elements -> Forall (Walk.lists_from elements) cs ->
  (forall e t, In e elements -> ~ In e apart -> met e t -> exists c, In c cs /\ Walk.leads c e t) ->
  (Walk.walks Elemento bool Elemento_dec (Occlusion.take Elemento blocks) prunable (Walk.plan apart cs, (nil, false))
     (nil, (taken, st)) -> st = true <-> occluded s ray en)
  /\ (Walk.walks Elemento bool Elemento_dec (Occlusion.take Elemento blocks_segment) prunable1
     (Walk.plan apart cs, (nil, false)) (nil, (taken1, st1)) -> st1 = true <-> occluded_segment s ray en).
Proof.
  exact (the_answer_to_a_shadow_ray_is_the_texts finding in_range triage stable improved Running.near low high certainly_less
    rounded round_exact right prunable prunable1 apart cs taken st taken1 st1).
Qed.
End Chain.
