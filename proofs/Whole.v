(** * Whole: the search whose steps are those that run publishes what the text says

    Running.v takes the numbers of an element and the ray as the reals that they are, Chain.v as integers over one S. Here
    both are the same numbers, and what either says of the search is joined: nothing is assumed of a step but what it
    computes ([Running.steps_run]).

    vec_over S a, shape_over S sh == the reals that the integers of a and of sh stand for *)
From Coq Require Import ZArith Reals List.
From Durero Require Import Toolkit Especificacion Escena Interseccion.
From Durero Require Vectors Exacto ExactoEscena Chain Search Limits Surd Triage Running.

Definition vec_over (S : Z) (a : Exacto.vec3) : Vectors.vec :=
  Vectors.Vec (Exacto.over S (Exacto.vx a)) (Exacto.over S (Exacto.vy a)) (Exacto.over S (Exacto.vz a)).
Definition shape_over (S : Z) (sh : Exacto.shape) : Triage.shape :=
  let n := Exacto.over S in let a := vec_over S in
  match sh with
  | Exacto.Sphere c r => Triage.Sphere (a c) (n r)
  | Exacto.Cylinder c r d h => Triage.Cylinder (a c) (n r) (a d) (n h)
  | Exacto.Cone c k d h => Triage.Cone (a c) (n k) (a d) (n h)
  | Exacto.TruncatedCone c r k d h => Triage.Truncated (a c) (n r) (n k) (a d) (n h)
  | Exacto.Plane c d => Triage.Plane (a c) (a d)
  | Exacto.Disc c r d => Triage.Disc (a c) (n r) (a d)
  | Exacto.Triangle b c d => Triage.Triangle (a b) (a c) (a d)
  end.

Section Whole.
Variable Elemento : Type.
Variables (S : Z) (s : Especificacion.Escena Elemento) (en : set Elemento) (p v : Exacto.vec3).
Hypothesis ok : Escena_ok s.
Notation ray := (ExactoEscena.the_ray S p v).
Hypothesis ray_ok : Rayo_ok ray.
Variables (elements : list Elemento) (shape_of : Elemento -> Exacto.shape) (on in_range : Elemento -> bool).
Hypothesis described : ExactoEscena.describes Elemento S s en (map (fun e => (e, shape_of e, on e)) elements).

Lemma stands_over e sh : ExactoEscena.has_shape Elemento S s e sh -> Triage.stands Elemento s e (shape_over S sh).
Proof. now destruct sh. Qed.

Lemma described_over e : In e elements -> Triage.stands Elemento s e (shape_over S (shape_of e)) /\ (on e = true <-> en e).
Proof.
  intros He; destruct described as [_ H]; destruct (H e (shape_of e) (on e)) as [Hs Hon].
  - apply in_map_iff; now exists e.
  - split; [now apply stands_over | exact Hon].
Qed.

Hypothesis ordinary : forall e, In e elements -> in_range e = true ->
  Triage.in_bounds (vec_over S p) (vec_over S v) (shape_over S (shape_of e)).

Theorem steps_are_right triage stable improved low high certainly_less rounded round_exact :
  Running.steps_run Elemento (vec_over S p) (vec_over S v) elements (fun e => shape_over S (shape_of e)) on in_range triage stable
    improved low high certainly_less rounded round_exact ->
  Search.steps_right Elemento Running.finding Chain.printed (met ray Elemento s en) elements (Chain.rounds ray) in_range triage
    stable improved Running.near low high certainly_less rounded round_exact.
Proof.
  exact (Running.steps_are_right Elemento s en (vec_over S p) (vec_over S v) ok ray_ok elements
    (fun e => shape_over S (shape_of e)) on in_range described_over ordinary triage stable improved low high certainly_less rounded
    round_exact).
Qed.
End Whole.
