(** * Formas: the formulas of the tracer, as its C++ templates compute them

    Written from src/trace by tests/proofs/formas.cpp, and not by hand; the test trace/formas fails where it is not what
    that writes. Each operation that the program rounds is a [rnd]; what the program computes once stands once. The names
    are those of the headers quadratic-inl.hpp, closed_form-inl.hpp, double_double-inl.hpp and of the words in files.

    quadratic T        == what is computed of a ray and an element, over the numbers T: R is binary64, twofold is Pairs
    X_axial, X_edged   == X where the element is bounded by a stretch of its axis, by the edge of a part of a plane
    X_in_lanes         == the decision for many rays, without branches; first_of_X: for one ray, up to a limit
    X_on               == X of a ray that starts on the element
    ends_of            == the ends between which a root lies, of ends.hpp
    speed_of, X_in_range == of range.hpp: how fast a ray is at most, and whether every number of X lies in range
    Pairs              == the same over double-double, the second step, and its operations over binary64
    Powers             == potencia at the parameter t of a ray, and a bound on its error *)
From Coq Require Import Reals ZArith Bool.
From Flocq Require Import Core.
From Durero Require Import Rounding Vectors.
Local Open Scope R_scope.

Record quadratic (T : Type) := Quadratic { A : T; B : T; C : T; F : T; H : T; A_error : R; B_error : R; C_error : R;
  s0 : T; s1 : T; altura : R; reach : R; speed : R; margin : R; margin_error : R }.
Arguments Quadratic {T}. Arguments A {T}. Arguments B {T}. Arguments C {T}. Arguments F {T}. Arguments H {T}.
Arguments A_error {T}. Arguments B_error {T}. Arguments C_error {T}. Arguments s0 {T}. Arguments s1 {T}.
Arguments altura {T}. Arguments reach {T}. Arguments speed {T}. Arguments margin {T}. Arguments margin_error {T}.
Record known (T : Type) := Known { value : T; error : R }.
Arguments Known {T}. Arguments value {T}. Arguments error {T}.
Record stable (T : Type) := Stable { positive : bool; signed_root : T; q : known T }.
Arguments Stable {T}. Arguments positive {T}. Arguments signed_root {T}. Arguments q {T}.
Record placed := Placed { outside : bool; inside : bool }.
Record ends := Ends { low : R; high : R }.
Record in_lanes := In_lanes { hit : bool; undecided : bool; root : known R; slope : known R }.
Inductive answer (T : Type) := Miss | Undecided | Hit (root : known T) (slope : known R) (curvature : known R).
Arguments Miss {T}. Arguments Undecided {T}. Arguments Hit {T}.

(** * Binary64 *)

(** How fast a ray is at most, and whether its numbers and those of an element are in range. *)
Definition speed_of (v : vec) : R :=
  (rnd (rnd (Rabs (cx v) + Rabs (cy v)) + Rabs (cz v))).

Definition in_range (x : R) : bool :=
  let x1 := Rabs x in
  (orb (andb (Rle_bool (bpow radix2 (-100)) x1) (Rle_bool x1 (bpow radix2 100))) (Req_bool x1 0)).

Definition ray_in_range (p v : vec) : bool :=
  (andb (andb (andb (in_range (cx p)) (in_range (cz p))) (in_range (cy v))) (andb (andb (in_range (cy p)) (in_range (cx
      v))) (in_range (cz v)))).

Definition esfera_in_range (centro : vec) (radio : R) : bool :=
  let x1 := in_range (cz centro) in
  let x2 := in_range radio in
  if andb (andb (in_range (cx centro)) x1) (andb (in_range (cy centro)) x1) then
    if andb x2 x2 then
      true
    else false
  else false.

Definition cilindro_in_range (centro : vec) (radio : R) (vector : vec) (altura : R) : bool :=
  let x1 := in_range (cz centro) in
  let x2 := in_range radio in
  let x3 := in_range (cz vector) in
  let x4 := in_range altura in
  if andb (andb (in_range (cx centro)) x1) (andb (in_range (cy centro)) x1) then
    if andb x2 x2 then
      if andb (andb (in_range (cx vector)) x3) (andb (in_range (cy vector)) x3) then
        if andb x4 x4 then
          true
        else false
      else false
    else false
  else false.

Definition cono_in_range (centro : vec) (proporcion : R) (vector : vec) (altura : R) : bool :=
  let x1 := in_range (cz centro) in
  let x2 := in_range proporcion in
  let x3 := in_range (cz vector) in
  let x4 := in_range altura in
  if andb (andb (in_range (cx centro)) x1) (andb (in_range (cy centro)) x1) then
    if andb x2 x2 then
      if andb (andb (in_range (cx vector)) x3) (andb (in_range (cy vector)) x3) then
        if andb x4 x4 then
          true
        else false
      else false
    else false
  else false.

Definition tronco_in_range (centro : vec) (radio : R) (proporcion : R) (vector : vec) (altura : R) : bool :=
  let x1 := in_range (cz centro) in
  let x2 := in_range radio in
  let x3 := in_range proporcion in
  let x4 := in_range (cz vector) in
  let x5 := in_range altura in
  if andb (andb (in_range (cx centro)) x1) (andb (in_range (cy centro)) x1) then
    if andb x2 x2 then
      if andb x3 x3 then
        if andb (andb (in_range (cx vector)) x4) (andb (in_range (cy vector)) x4) then
          if andb x5 x5 then
            true
          else false
        else false
      else false
    else false
  else false.

Definition plano_in_range (centro : vec) (vector : vec) : bool :=
  let x1 := in_range (cz centro) in
  let x2 := in_range (cz vector) in
  if andb (andb (in_range (cx centro)) x1) (andb (in_range (cy centro)) x1) then
    if andb (andb (in_range (cx vector)) x2) (andb (in_range (cy vector)) x2) then
      true
    else false
  else false.

Definition disco_in_range (centro : vec) (radio : R) (vector : vec) : bool :=
  let x1 := in_range (cz centro) in
  let x2 := in_range radio in
  let x3 := in_range (cz vector) in
  if andb (andb (in_range (cx centro)) x1) (andb (in_range (cy centro)) x1) then
    if andb x2 x2 then
      if andb (andb (in_range (cx vector)) x3) (andb (in_range (cy vector)) x3) then
        true
      else false
    else false
  else false.

Definition triangulo_in_range (a b c : vec) : bool :=
  let x1 := in_range (cz a) in
  let x2 := in_range (cz b) in
  let x3 := in_range (cz c) in
  if andb (andb (in_range (cx a)) x1) (andb (in_range (cy a)) x1) then
    if andb (andb (in_range (cx b)) x2) (andb (in_range (cy b)) x2) then
      if andb (andb (in_range (cx c)) x3) (andb (in_range (cy c)) x3) then
        true
      else false
    else false
  else false.

Definition esfera (p v : vec) (speed : R) (centro : vec) (radio : R) : quadratic R :=
  let x1 := rnd (rnd (rnd (cx v * cx v) + rnd (cy v * cy v)) + rnd (cz v * cz v)) in
  let x2 := rnd (cx p - cx centro) in
  let x3 := rnd (cy p - cy centro) in
  let x4 := rnd (cz p - cz centro) in
  let x5 := rnd (radio * rnd (sqrt x1)) in
  let x6 := rnd (rnd (x3 * cz v) - rnd (x4 * cy v)) in
  let x7 := rnd (rnd (x4 * cx v) - rnd (x2 * cz v)) in
  let x8 := rnd (rnd (x2 * cy v) - rnd (x3 * cx v)) in
  let x9 := rnd (sqrt (rnd (rnd (rnd (x6 * x6) + rnd (x7 * x7)) + rnd (x8 * x8)))) in
  let x10 := rnd (bpow radix2 (-47) * speed) in
  let x11 := rnd (rnd (rnd (Rabs x2 + Rabs x3) + Rabs x4) + radio) in
  {| A := x1;
     B := rnd (rnd (rnd (x2 * cx v) + rnd (x3 * cy v)) + rnd (x4 * cz v));
     C := rnd (rnd (rnd (rnd (x2 * x2) + rnd (x3 * x3)) + rnd (x4 * x4)) - rnd (radio * radio));
     F := rnd (x5 - x9);
     H := rnd (x5 + x9);
     A_error := rnd (x10 * speed);
     B_error := rnd (x10 * x11);
     C_error := rnd (rnd (bpow radix2 (-47) * x11) * x11);
     s0 := 0;
     s1 := 0;
     altura := 0;
     reach := 0;
     speed := 0;
     margin := 0;
     margin_error := 0 |}.

Definition cilindro (p v : vec) (speed : R) (centro : vec) (radio : R) (vector : vec) (altura : R) : quadratic R :=
  let x1 := rnd (rnd (rnd (cx v * cx vector) + rnd (cy v * cy vector)) + rnd (cz v * cz vector)) in
  let x2 := rnd (cx v - rnd (x1 * cx vector)) in
  let x3 := rnd (cy v - rnd (x1 * cy vector)) in
  let x4 := rnd (cz v - rnd (x1 * cz vector)) in
  let x5 := rnd (rnd (rnd (x2 * x2) + rnd (x3 * x3)) + rnd (x4 * x4)) in
  let x6 := rnd (cx p - cx centro) in
  let x7 := rnd (cy p - cy centro) in
  let x8 := rnd (cz p - cz centro) in
  let x9 := rnd (rnd (rnd (x6 * cx vector) + rnd (x7 * cy vector)) + rnd (x8 * cz vector)) in
  let x10 := rnd (x6 - rnd (x9 * cx vector)) in
  let x11 := rnd (x7 - rnd (x9 * cy vector)) in
  let x12 := rnd (x8 - rnd (x9 * cz vector)) in
  let x13 := rnd (radio * rnd (sqrt x5)) in
  let x14 := rnd (rnd (x11 * x4) - rnd (x12 * x3)) in
  let x15 := rnd (rnd (x12 * x2) - rnd (x10 * x4)) in
  let x16 := rnd (rnd (x10 * x3) - rnd (x11 * x2)) in
  let x17 := rnd (sqrt (rnd (rnd (rnd (x14 * x14) + rnd (x15 * x15)) + rnd (x16 * x16)))) in
  let x18 := rnd (bpow radix2 (-47) * speed) in
  let x19 := rnd (rnd (Rabs x6 + Rabs x7) + Rabs x8) in
  let x20 := rnd (x19 + radio) in
  {| A := x5;
     B := rnd (rnd (rnd (x10 * x2) + rnd (x11 * x3)) + rnd (x12 * x4));
     C := rnd (rnd (rnd (rnd (x10 * x10) + rnd (x11 * x11)) + rnd (x12 * x12)) - rnd (radio * radio));
     F := rnd (x13 - x17);
     H := rnd (x13 + x17);
     A_error := rnd (x18 * speed);
     B_error := rnd (x18 * x20);
     C_error := rnd (rnd (bpow radix2 (-47) * x20) * x20);
     s0 := x9;
     s1 := x1;
     altura := altura;
     reach := rnd (x19 + altura);
     speed := speed;
     margin := 0;
     margin_error := 0 |}.

Definition cono (p v : vec) (speed : R) (centro : vec) (proporcion : R) (vector : vec) (altura : R) : quadratic R :=
  let x1 := rnd (rnd (rnd (cx v * cx vector) + rnd (cy v * cy vector)) + rnd (cz v * cz vector)) in
  let x2 := rnd (cx v - rnd (x1 * cx vector)) in
  let x3 := rnd (cy v - rnd (x1 * cy vector)) in
  let x4 := rnd (cz v - rnd (x1 * cz vector)) in
  let x5 := rnd (proporcion * proporcion) in
  let x6 := rnd (cx p - cx centro) in
  let x7 := rnd (cy p - cy centro) in
  let x8 := rnd (cz p - cz centro) in
  let x9 := rnd (rnd (rnd (x6 * cx vector) + rnd (x7 * cy vector)) + rnd (x8 * cz vector)) in
  let x10 := rnd (x6 - rnd (x9 * cx vector)) in
  let x11 := rnd (x7 - rnd (x9 * cy vector)) in
  let x12 := rnd (x8 - rnd (x9 * cz vector)) in
  let x13 := rnd (altura - x9) in
  let x14 := rnd (rnd (x13 * x2) + rnd (x1 * x10)) in
  let x15 := rnd (rnd (x13 * x3) + rnd (x1 * x11)) in
  let x16 := rnd (rnd (x13 * x4) + rnd (x1 * x12)) in
  let x17 := rnd (proporcion * rnd (sqrt (rnd (rnd (rnd (x14 * x14) + rnd (x15 * x15)) + rnd (x16 * x16))))) in
  let x18 := rnd (rnd (x11 * x4) - rnd (x12 * x3)) in
  let x19 := rnd (rnd (x12 * x2) - rnd (x10 * x4)) in
  let x20 := rnd (rnd (x10 * x3) - rnd (x11 * x2)) in
  let x21 := rnd (sqrt (rnd (rnd (rnd (x18 * x18) + rnd (x19 * x19)) + rnd (x20 * x20)))) in
  let x22 := rnd (bpow radix2 (-47) * rnd (1 + x5)) in
  let x23 := rnd (x22 * speed) in
  let x24 := rnd (rnd (rnd (Rabs x6 + Rabs x7) + Rabs x8) + altura) in
  {| A := rnd (rnd (rnd (rnd (x2 * x2) + rnd (x3 * x3)) + rnd (x4 * x4)) - rnd (x5 * rnd (x1 * x1)));
     B := rnd (rnd (rnd (rnd (x10 * x2) + rnd (x11 * x3)) + rnd (x12 * x4)) + rnd (x5 * rnd (x13 * x1)));
     C := rnd (rnd (rnd (rnd (x10 * x10) + rnd (x11 * x11)) + rnd (x12 * x12)) - rnd (x5 * rnd (x13 * x13)));
     F := rnd (x17 - x21);
     H := rnd (x17 + x21);
     A_error := rnd (x23 * speed);
     B_error := rnd (x23 * x24);
     C_error := rnd (rnd (x22 * x24) * x24);
     s0 := x9;
     s1 := x1;
     altura := altura;
     reach := x24;
     speed := speed;
     margin := 0;
     margin_error := 0 |}.

Definition tronco (p v : vec) (speed : R) (centro : vec) (radio : R) (proporcion : R) (vector : vec) (altura : R) :
    quadratic R :=
  let x1 := rnd (rnd (rnd (cx v * cx vector) + rnd (cy v * cy vector)) + rnd (cz v * cz vector)) in
  let x2 := rnd (cx v - rnd (x1 * cx vector)) in
  let x3 := rnd (cy v - rnd (x1 * cy vector)) in
  let x4 := rnd (cz v - rnd (x1 * cz vector)) in
  let x5 := rnd (proporcion * x1) in
  let x6 := rnd (cx p - cx centro) in
  let x7 := rnd (cy p - cy centro) in
  let x8 := rnd (cz p - cz centro) in
  let x9 := rnd (rnd (rnd (x6 * cx vector) + rnd (x7 * cy vector)) + rnd (x8 * cz vector)) in
  let x10 := rnd (x6 - rnd (x9 * cx vector)) in
  let x11 := rnd (x7 - rnd (x9 * cy vector)) in
  let x12 := rnd (x8 - rnd (x9 * cz vector)) in
  let x13 := rnd (radio + rnd (proporcion * rnd (altura - x9))) in
  let x14 := rnd (rnd (x13 * x2) + rnd (x5 * x10)) in
  let x15 := rnd (rnd (x13 * x3) + rnd (x5 * x11)) in
  let x16 := rnd (rnd (x13 * x4) + rnd (x5 * x12)) in
  let x17 := rnd (sqrt (rnd (rnd (rnd (x14 * x14) + rnd (x15 * x15)) + rnd (x16 * x16)))) in
  let x18 := rnd (rnd (x11 * x4) - rnd (x12 * x3)) in
  let x19 := rnd (rnd (x12 * x2) - rnd (x10 * x4)) in
  let x20 := rnd (rnd (x10 * x3) - rnd (x11 * x2)) in
  let x21 := rnd (sqrt (rnd (rnd (rnd (x18 * x18) + rnd (x19 * x19)) + rnd (x20 * x20)))) in
  let x22 := rnd (bpow radix2 (-47) * rnd (1 + rnd (proporcion * proporcion))) in
  let x23 := rnd (x22 * speed) in
  let x24 := rnd (rnd (rnd (Rabs x6 + Rabs x7) + Rabs x8) + altura) in
  let x25 := rnd (x24 + radio) in
  {| A := rnd (rnd (rnd (rnd (x2 * x2) + rnd (x3 * x3)) + rnd (x4 * x4)) - rnd (x5 * x5));
     B := rnd (rnd (rnd (rnd (x10 * x2) + rnd (x11 * x3)) + rnd (x12 * x4)) + rnd (x13 * x5));
     C := rnd (rnd (rnd (rnd (x10 * x10) + rnd (x11 * x11)) + rnd (x12 * x12)) - rnd (x13 * x13));
     F := rnd (x17 - x21);
     H := rnd (x17 + x21);
     A_error := rnd (x23 * speed);
     B_error := rnd (x23 * x25);
     C_error := rnd (rnd (x22 * x25) * x25);
     s0 := x9;
     s1 := x1;
     altura := altura;
     reach := x24;
     speed := speed;
     margin := 0;
     margin_error := 0 |}.

Definition plano (p v : vec) (speed : R) (centro : vec) (vector : vec) : quadratic R :=
  let x1 := rnd (cx p - cx centro) in
  let x2 := rnd (cy p - cy centro) in
  let x3 := rnd (cz p - cz centro) in
  {| A := 0;
     B := rnd (rnd (rnd (rnd (cx v * cx vector) + rnd (cy v * cy vector)) + rnd (cz v * cz vector)) * bpow radix2 (-1));
     C := rnd (rnd (rnd (x1 * cx vector) + rnd (x2 * cy vector)) + rnd (x3 * cz vector));
     F := 0;
     H := 0;
     A_error := 0;
     B_error := rnd ((3 * bpow radix2 (-53)) * speed);
     C_error := rnd (bpow radix2 (-50) * rnd (rnd (Rabs x1 + Rabs x2) + Rabs x3));
     s0 := 0;
     s1 := 0;
     altura := 0;
     reach := 0;
     speed := 0;
     margin := 0;
     margin_error := 0 |}.

Definition disco (p v : vec) (speed : R) (centro : vec) (radio : R) (vector : vec) : quadratic R :=
  let x1 := rnd (rnd (rnd (rnd (cx v * cx vector) + rnd (cy v * cy vector)) + rnd (cz v * cz vector)) * bpow radix2
      (-1)) in
  let x2 := rnd (cx p - cx centro) in
  let x3 := rnd (cy p - cy centro) in
  let x4 := rnd (cz p - cz centro) in
  let x5 := rnd (rnd (rnd (x2 * cx vector) + rnd (x3 * cy vector)) + rnd (x4 * cz vector)) in
  let x6 := rnd (rnd (Rabs x2 + Rabs x3) + Rabs x4) in
  let x7 := rnd (x1 + x1) in
  let x8 := rnd (radio * x7) in
  let x9 := - x5 in
  let x10 := rnd (rnd (x7 * x2) + rnd (x9 * cx v)) in
  let x11 := rnd (rnd (x7 * x3) + rnd (x9 * cy v)) in
  let x12 := rnd (rnd (x7 * x4) + rnd (x9 * cz v)) in
  {| A := 0;
     B := x1;
     C := x5;
     F := 0;
     H := 0;
     A_error := 0;
     B_error := rnd ((3 * bpow radix2 (-53)) * speed);
     C_error := rnd (bpow radix2 (-50) * x6);
     s0 := 0;
     s1 := 0;
     altura := 0;
     reach := 0;
     speed := 0;
     margin := rnd ((if Rlt_bool x7 0 then - x8 else x8) - rnd (sqrt (rnd (rnd (rnd (x10 * x10) + rnd (x11 * x11)) + rnd
         (x12 * x12)))));
     margin_error := rnd (rnd (bpow radix2 (-48) * speed) * rnd (x6 + radio)) |}.

Definition triangulo (p v : vec) (speed : R) (a b c : vec) : quadratic R :=
  let x1 := rnd (cx b - cx a) in
  let x2 := rnd (cz c - cz a) in
  let x3 := rnd (cy c - cy a) in
  let x4 := rnd (rnd (cy v * x2) - rnd (cz v * x3)) in
  let x5 := rnd (cy b - cy a) in
  let x6 := rnd (cx c - cx a) in
  let x7 := rnd (rnd (cz v * x6) - rnd (cx v * x2)) in
  let x8 := rnd (cz b - cz a) in
  let x9 := rnd (rnd (cx v * x3) - rnd (cy v * x6)) in
  let x10 := rnd (rnd (rnd (x1 * x4) + rnd (x5 * x7)) + rnd (x8 * x9)) in
  let x11 := rnd (cy p - cy a) in
  let x12 := rnd (cz p - cz a) in
  let x13 := rnd (rnd (x11 * x8) - rnd (x12 * x5)) in
  let x14 := rnd (cx p - cx a) in
  let x15 := rnd (rnd (x12 * x1) - rnd (x14 * x8)) in
  let x16 := rnd (rnd (x14 * x5) - rnd (x11 * x1)) in
  let x17 := rnd (rnd (Rabs x1 + Rabs x5) + Rabs x8) in
  let x18 := rnd (rnd (Rabs x6 + Rabs x3) + Rabs x2) in
  let x19 := rnd (rnd (Rabs x14 + Rabs x11) + Rabs x12) in
  let x20 := Rlt_bool x10 0 in
  let x21 := rnd (rnd (rnd (cx v * x13) + rnd (cy v * x15)) + rnd (cz v * x16)) in
  let x22 := if x20 then - x21 else x21 in
  let x23 := rnd (rnd (rnd (x14 * x4) + rnd (x11 * x7)) + rnd (x12 * x9)) in
  let x24 := rnd (rnd (x10 - x23) - x21) in
  let x25 := if x20 then - x24 else x24 in
  let x26 := if Rlt_bool x22 x25 then x22 else x25 in
  let x27 := if x20 then - x23 else x23 in
  {| A := 0;
     B := rnd (x10 * (- bpow radix2 (-1)));
     C := rnd (rnd (rnd (x6 * x13) + rnd (x3 * x15)) + rnd (x2 * x16));
     F := 0;
     H := 0;
     A_error := 0;
     B_error := rnd (rnd (rnd (bpow radix2 (-50) * speed) * x17) * x18);
     C_error := rnd (rnd (rnd (bpow radix2 (-49) * x19) * x17) * x18);
     s0 := 0;
     s1 := 0;
     altura := 0;
     reach := 0;
     speed := 0;
     margin := if Rlt_bool x26 x27 then x26 else x27;
     margin_error := rnd (rnd ((9 * bpow radix2 (-52)) * speed) * rnd (rnd (x17 * x18) + rnd (x19 * rnd (x17 + x18))))
         |}.

Definition root_of_discriminant (f : quadratic R) : known R :=
  let x1 := rnd (sqrt (rnd (F f * H f))) in
  Known x1 (rnd (rnd (rnd (rnd (3 * B_error f) * H f) / x1) + rnd (bpow radix2 (-51) * x1))).

Definition stable_sum (f : quadratic R) (D : known R) : stable R :=
  let x1 := Rle_bool 0 (B f) in
  let x2 := if x1 then value D else - value D in
  let x3 := - rnd (B f + x2) in
  Stable x1 x2 (Known x3 (rnd (rnd (B_error f + error D) + rnd (bpow radix2 (-52) * Rabs x3)))).

Definition quotient (x : R) (x_error : R) (y : R) (y_error : R) : known R :=
  let x1 := rnd (x / y) in
  let x2 := Rabs x1 in
  Known x1 (rnd (rnd (rnd (rnd (x_error + rnd (x2 * y_error)) / rnd (Rabs y - y_error)) * (4503600077730459 * bpow
      radix2 (-52))) + rnd (bpow radix2 (-51) * x2))).

Definition advance (f : quadratic R) (t : known R) : known R :=
  Known (rnd (s0 f + rnd (value t * s1 f))) (rnd (rnd (bpow radix2 (-49) * rnd (reach f + rnd (rnd (Rabs (value t) +
      error t) * speed f))) + rnd (rnd (Rabs (s1 f) * (4503600077730459 * bpow radix2 (-52))) * error t))).

Definition beyond (t : known R) (limit : R) : bool :=
  (Rlt_bool (error t) (rnd (value t - limit))).

Definition place (f : quadratic R) (t : known R) : placed :=
  Placed (Rlt_bool (value t) (- error t)) (Rlt_bool (error t) (value t)).

Definition place_axial (f : quadratic R) (t : known R) : placed :=
  let x1 := rnd (s0 f + rnd (value t * s1 f)) in
  let x2 := rnd (rnd (bpow radix2 (-49) * rnd (reach f + rnd (rnd (Rabs (value t) + error t) * speed f))) + rnd (rnd
      (Rabs (s1 f) * (4503600077730459 * bpow radix2 (-52))) * error t)) in
  let x3 := - x2 in
  let x4 := rnd (altura f - x1) in
  Placed (orb (orb (Rlt_bool (value t) (- error t)) (Rlt_bool x1 x3)) (Rlt_bool x4 x3)) (andb (andb (Rlt_bool (error t)
      (value t)) (Rlt_bool x2 x1)) (Rlt_bool x2 x4)).

Definition place_edged (f : quadratic R) (t : known R) : placed :=
  Placed (orb (Rlt_bool (value t) (- error t)) (Rlt_bool (margin f) (- margin_error f))) (andb (Rlt_bool (error t)
      (value t)) (Rlt_bool (margin_error f) (margin f))).

Definition first_in_lanes (f : quadratic R) : in_lanes :=
  let x1 := rnd (sqrt (rnd (F f * H f))) in
  let x2 := rnd (rnd (rnd (rnd (3 * B_error f) * H f) / x1) + rnd (bpow radix2 (-51) * x1)) in
  let x3 := Rle_bool 0 (B f) in
  let x4 := if x3 then x1 else - x1 in
  let x5 := - rnd (B f + x4) in
  let x6 := Rabs x5 in
  let x7 := rnd (rnd (B_error f + x2) + rnd (bpow radix2 (-52) * x6)) in
  let x8 := Rabs (A f) in
  let x9 := andb (andb (Rlt_bool (B_error f) (F f)) (Rlt_bool (rnd (2 * x7)) x6)) (Rlt_bool (rnd (2 * A_error f)) x8) in
  let x10 := eqb (Rlt_bool 0 (A f)) x3 in
  let x11 := rnd (x5 / A f) in
  let x12 := Rabs x11 in
  let x13 := rnd (rnd (rnd (rnd (x7 + rnd (x12 * A_error f)) / rnd (x8 - A_error f)) * (4503600077730459 * bpow radix2
      (-52))) + rnd (bpow radix2 (-51) * x12)) in
  let x14 := rnd (C f / x5) in
  let x15 := Rabs x14 in
  let x16 := rnd (rnd (rnd (rnd (C_error f + rnd (x15 * x7)) / rnd (x6 - x7)) * (4503600077730459 * bpow radix2 (-52)))
      + rnd (bpow radix2 (-51) * x15)) in
  let x17 := if x10 then x13 else x16 in
  let x18 := if x10 then x11 else x14 in
  let x19 := Rlt_bool x18 (- x17) in
  let x20 := if x10 then x16 else x13 in
  let x21 := if x10 then x14 else x11 in
  let x22 := andb x19 (Rlt_bool x20 x21) in
  let x23 := andb x9 (orb (Rlt_bool x17 x18) x22) in
  {| hit := x23;
     undecided := negb (orb x23 (orb (Rlt_bool (F f) (- B_error f)) (andb (andb x9 x19) (Rlt_bool x21 (- x20)))));
     root := Known (if x22 then x21 else x18) (if x22 then x20 else x17);
     slope := Known (if eqb x10 x22 then x4 else - x4) x2 |}.

Definition first_in_lanes_on (f : quadratic R) : in_lanes :=
  let x1 := Rabs (A f) in
  let x2 := Rlt_bool (rnd (2 * A_error f)) x1 in
  let x3 := rnd ((- rnd (B f + B f)) / A f) in
  let x4 := Rabs x3 in
  let x5 := rnd (rnd (rnd (rnd (rnd (2 * B_error f) + rnd (x4 * A_error f)) / rnd (x1 - A_error f)) * (4503600077730459
      * bpow radix2 (-52))) + rnd (bpow radix2 (-51) * x4)) in
  let x6 := andb x2 (Rlt_bool x5 x3) in
  {| hit := x6;
     undecided := negb (orb x6 (andb x2 (Rlt_bool x3 (- x5))));
     root := Known x3 x5;
     slope := Known (- B f) (B_error f) |}.

Definition first_in_lanes_axial (f : quadratic R) : in_lanes :=
  let x1 := rnd (sqrt (rnd (F f * H f))) in
  let x2 := rnd (rnd (rnd (rnd (3 * B_error f) * H f) / x1) + rnd (bpow radix2 (-51) * x1)) in
  let x3 := Rle_bool 0 (B f) in
  let x4 := if x3 then x1 else - x1 in
  let x5 := - rnd (B f + x4) in
  let x6 := Rabs x5 in
  let x7 := rnd (rnd (B_error f + x2) + rnd (bpow radix2 (-52) * x6)) in
  let x8 := Rabs (A f) in
  let x9 := andb (andb (Rlt_bool (B_error f) (F f)) (Rlt_bool (rnd (2 * x7)) x6)) (Rlt_bool (rnd (2 * A_error f)) x8) in
  let x10 := eqb (Rlt_bool 0 (A f)) x3 in
  let x11 := rnd (x5 / A f) in
  let x12 := Rabs x11 in
  let x13 := rnd (rnd (rnd (rnd (x7 + rnd (x12 * A_error f)) / rnd (x8 - A_error f)) * (4503600077730459 * bpow radix2
      (-52))) + rnd (bpow radix2 (-51) * x12)) in
  let x14 := rnd (C f / x5) in
  let x15 := Rabs x14 in
  let x16 := rnd (rnd (rnd (rnd (C_error f + rnd (x15 * x7)) / rnd (x6 - x7)) * (4503600077730459 * bpow radix2 (-52)))
      + rnd (bpow radix2 (-51) * x15)) in
  let x17 := if x10 then x13 else x16 in
  let x18 := if x10 then x11 else x14 in
  let x19 := rnd (Rabs (s1 f) * (4503600077730459 * bpow radix2 (-52))) in
  let x20 := rnd (rnd (bpow radix2 (-49) * rnd (reach f + rnd (rnd (Rabs x18 + x17) * speed f))) + rnd (x19 * x17)) in
  let x21 := rnd (s0 f + rnd (x18 * s1 f)) in
  let x22 := rnd (altura f - x21) in
  let x23 := - x20 in
  let x24 := orb (orb (Rlt_bool x18 (- x17)) (Rlt_bool x21 x23)) (Rlt_bool x22 x23) in
  let x25 := if x10 then x16 else x13 in
  let x26 := if x10 then x14 else x11 in
  let x27 := rnd (rnd (bpow radix2 (-49) * rnd (reach f + rnd (rnd (Rabs x26 + x25) * speed f))) + rnd (x19 * x25)) in
  let x28 := rnd (s0 f + rnd (x26 * s1 f)) in
  let x29 := rnd (altura f - x28) in
  let x30 := andb x24 (andb (andb (Rlt_bool x25 x26) (Rlt_bool x27 x28)) (Rlt_bool x27 x29)) in
  let x31 := andb x9 (orb (andb (andb (Rlt_bool x17 x18) (Rlt_bool x20 x21)) (Rlt_bool x20 x22)) x30) in
  let x32 := - x27 in
  {| hit := x31;
     undecided := negb (orb x31 (orb (Rlt_bool (F f) (- B_error f)) (andb (andb x9 x24) (orb (orb (Rlt_bool x26 (- x25))
         (Rlt_bool x28 x32)) (Rlt_bool x29 x32)))));
     root := Known (if x30 then x26 else x18) (if x30 then x25 else x17);
     slope := Known (if eqb x10 x30 then x4 else - x4) x2 |}.

Definition first_in_lanes_on_axial (f : quadratic R) : in_lanes :=
  let x1 := Rabs (A f) in
  let x2 := Rlt_bool (rnd (2 * A_error f)) x1 in
  let x3 := rnd ((- rnd (B f + B f)) / A f) in
  let x4 := Rabs x3 in
  let x5 := rnd (rnd (rnd (rnd (rnd (2 * B_error f) + rnd (x4 * A_error f)) / rnd (x1 - A_error f)) * (4503600077730459
      * bpow radix2 (-52))) + rnd (bpow radix2 (-51) * x4)) in
  let x6 := rnd (rnd (bpow radix2 (-49) * rnd (reach f + rnd (rnd (x4 + x5) * speed f))) + rnd (rnd (Rabs (s1 f) *
      (4503600077730459 * bpow radix2 (-52))) * x5)) in
  let x7 := rnd (s0 f + rnd (x3 * s1 f)) in
  let x8 := rnd (altura f - x7) in
  let x9 := andb x2 (andb (andb (Rlt_bool x5 x3) (Rlt_bool x6 x7)) (Rlt_bool x6 x8)) in
  let x10 := - x6 in
  {| hit := x9;
     undecided := negb (orb x9 (andb x2 (orb (orb (Rlt_bool x3 (- x5)) (Rlt_bool x7 x10)) (Rlt_bool x8 x10))));
     root := Known x3 x5;
     slope := Known (- B f) (B_error f) |}.

Definition linear_in_lanes (f : quadratic R) : in_lanes :=
  let x1 := rnd (2 * B_error f) in
  let x2 := Rlt_bool x1 (Rabs (B f)) in
  let x3 := rnd (B f + B f) in
  let x4 := rnd ((- C f) / x3) in
  let x5 := Rabs x4 in
  let x6 := rnd (rnd (rnd (rnd (C_error f + rnd (x5 * x1)) / rnd (Rabs x3 - x1)) * (4503600077730459 * bpow radix2
      (-52))) + rnd (bpow radix2 (-51) * x5)) in
  let x7 := andb x2 (Rlt_bool x6 x4) in
  {| hit := x7;
     undecided := negb (orb x7 (andb x2 (Rlt_bool x4 (- x6))));
     root := Known x4 x6;
     slope := Known (B f) (B_error f) |}.

Definition linear_in_lanes_edged (f : quadratic R) : in_lanes :=
  let x1 := rnd (2 * B_error f) in
  let x2 := Rlt_bool x1 (Rabs (B f)) in
  let x3 := rnd (B f + B f) in
  let x4 := rnd ((- C f) / x3) in
  let x5 := Rabs x4 in
  let x6 := rnd (rnd (rnd (rnd (C_error f + rnd (x5 * x1)) / rnd (Rabs x3 - x1)) * (4503600077730459 * bpow radix2
      (-52))) + rnd (bpow radix2 (-51) * x5)) in
  let x7 := andb x2 (andb (Rlt_bool x6 x4) (Rlt_bool (margin_error f) (margin f))) in
  {| hit := x7;
     undecided := negb (orb x7 (andb x2 (orb (Rlt_bool x4 (- x6)) (Rlt_bool (margin f) (- margin_error f)))));
     root := Known x4 x6;
     slope := Known (B f) (B_error f) |}.

Definition linear_in_lanes_on (f : quadratic R) : in_lanes :=
  let x1 := Rlt_bool (rnd (2 * B_error f)) (Rabs (B f)) in
  let x2 := negb x1 in
  {| hit := andb x1 x2;
     undecided := x2;
     root := Known 0 0;
     slope := Known (B f) (B_error f) |}.

Definition first_of_curved (f : quadratic R) (limit : R) : answer R :=
  let x1 := rnd (sqrt (rnd (F f * H f))) in
  let x2 := rnd (rnd (rnd (rnd (3 * B_error f) * H f) / x1) + rnd (bpow radix2 (-51) * x1)) in
  let x3 := Rle_bool 0 (B f) in
  let x4 := if x3 then x1 else - x1 in
  let x5 := - rnd (B f + x4) in
  let x6 := Rabs x5 in
  let x7 := rnd (rnd (B_error f + x2) + rnd (bpow radix2 (-52) * x6)) in
  let x8 := Rabs (A f) in
  let x9 := eqb (Rlt_bool 0 (A f)) x3 in
  let x10 := rnd (x5 / A f) in
  let x11 := Rabs x10 in
  let x12 := rnd (rnd (rnd (rnd (x7 + rnd (x11 * A_error f)) / rnd (x8 - A_error f)) * (4503600077730459 * bpow radix2
      (-52))) + rnd (bpow radix2 (-51) * x11)) in
  let x13 := Rlt_bool x12 (rnd (x10 - limit)) in
  let x14 := Rlt_bool x12 x10 in
  let x15 := Known x10 x12 in
  let x16 := Known (- x4) x2 in
  let x17 := Known (A f) (A_error f) in
  let x18 := Rlt_bool x10 (- x12) in
  let x19 := rnd (C f / x5) in
  let x20 := Rabs x19 in
  let x21 := rnd (x6 - x7) in
  let x22 := rnd (rnd (rnd (rnd (C_error f + rnd (x20 * x7)) / x21) * (4503600077730459 * bpow radix2 (-52))) + rnd
      (bpow radix2 (-51) * x20)) in
  let x23 := Rlt_bool x22 (rnd (x19 - limit)) in
  let x24 := Rlt_bool x22 x19 in
  let x25 := Known x19 x22 in
  let x26 := Known x4 x2 in
  let x27 := Rlt_bool x19 (- x22) in
  if Rlt_bool (F f) (- B_error f) then
    Miss
  else if Rlt_bool (B_error f) (F f) then
    if Rlt_bool (rnd (2 * x7)) x6 then
      if Rlt_bool (rnd (2 * A_error f)) x8 then
        if x9 then
          if x13 then
            Miss
          else if x14 then
            Hit x15 x16 x17
          else if x18 then
            if x23 then
              Miss
            else if x24 then
              Hit x25 x26 x17
            else if x27 then
              Miss
            else Undecided
          else Undecided
        else if x23 then
          Miss
        else if x24 then
          Hit x25 x26 x17
        else if x27 then
          if x13 then
            Miss
          else if x14 then
            Hit x15 x16 x17
          else if x18 then
            Miss
          else Undecided
        else Undecided
      else if Rlt_bool limit (rnd (rnd ((9007198354021067 * bpow radix2 (-53)) * x21) / rnd (x8 + A_error f))) then
        if x9 then
          if x23 then
            Miss
          else if x24 then
            Hit x25 x26 x17
          else if x27 then
            Miss
          else Undecided
        else if x23 then
          Miss
        else if x24 then
          Hit x25 x26 x17
        else if x27 then
          Miss
        else Undecided
      else Undecided
    else Undecided
  else Undecided.

Definition first_of_curved_on (f : quadratic R) (limit : R) : answer R :=
  let x1 := Rabs (A f) in
  let x2 := rnd ((- rnd (B f + B f)) / A f) in
  let x3 := Rabs x2 in
  let x4 := rnd (rnd (rnd (rnd (rnd (2 * B_error f) + rnd (x3 * A_error f)) / rnd (x1 - A_error f)) * (4503600077730459
      * bpow radix2 (-52))) + rnd (bpow radix2 (-51) * x3)) in
  if Rlt_bool (rnd (2 * A_error f)) x1 then
    if Rlt_bool x4 (rnd (x2 - limit)) then
      Miss
    else if Rlt_bool x4 x2 then
      Hit (Known x2 x4) (Known (- B f) (B_error f)) (Known (A f) (A_error f))
    else if Rlt_bool x2 (- x4) then
      Miss
    else Undecided
  else Undecided.

Definition first_of_curved_axial (f : quadratic R) (limit : R) : answer R :=
  let x1 := rnd (sqrt (rnd (F f * H f))) in
  let x2 := rnd (rnd (rnd (rnd (3 * B_error f) * H f) / x1) + rnd (bpow radix2 (-51) * x1)) in
  let x3 := Rle_bool 0 (B f) in
  let x4 := if x3 then x1 else - x1 in
  let x5 := - rnd (B f + x4) in
  let x6 := Rabs x5 in
  let x7 := rnd (rnd (B_error f + x2) + rnd (bpow radix2 (-52) * x6)) in
  let x8 := Rabs (A f) in
  let x9 := eqb (Rlt_bool 0 (A f)) x3 in
  let x10 := rnd (x5 / A f) in
  let x11 := Rabs x10 in
  let x12 := rnd (rnd (rnd (rnd (x7 + rnd (x11 * A_error f)) / rnd (x8 - A_error f)) * (4503600077730459 * bpow radix2
      (-52))) + rnd (bpow radix2 (-51) * x11)) in
  let x13 := Rlt_bool x12 (rnd (x10 - limit)) in
  let x14 := Rabs (s1 f) in
  let x15 := rnd (x14 * (4503600077730459 * bpow radix2 (-52))) in
  let x16 := rnd (rnd (bpow radix2 (-49) * rnd (reach f + rnd (rnd (x11 + x12) * speed f))) + rnd (x15 * x12)) in
  let x17 := rnd (s0 f + rnd (x10 * s1 f)) in
  let x18 := rnd (altura f - x17) in
  let x19 := andb (andb (Rlt_bool x12 x10) (Rlt_bool x16 x17)) (Rlt_bool x16 x18) in
  let x20 := Known x10 x12 in
  let x21 := Known (- x4) x2 in
  let x22 := Known (A f) (A_error f) in
  let x23 := - x16 in
  let x24 := orb (orb (Rlt_bool x10 (- x12)) (Rlt_bool x17 x23)) (Rlt_bool x18 x23) in
  let x25 := rnd (C f / x5) in
  let x26 := Rabs x25 in
  let x27 := rnd (x6 - x7) in
  let x28 := rnd (rnd (rnd (rnd (C_error f + rnd (x26 * x7)) / x27) * (4503600077730459 * bpow radix2 (-52))) + rnd
      (bpow radix2 (-51) * x26)) in
  let x29 := Rlt_bool x28 (rnd (x25 - limit)) in
  let x30 := rnd (rnd (bpow radix2 (-49) * rnd (reach f + rnd (rnd (x26 + x28) * speed f))) + rnd (x15 * x28)) in
  let x31 := rnd (s0 f + rnd (x25 * s1 f)) in
  let x32 := rnd (altura f - x31) in
  let x33 := andb (andb (Rlt_bool x28 x25) (Rlt_bool x30 x31)) (Rlt_bool x30 x32) in
  let x34 := Known x25 x28 in
  let x35 := Known x4 x2 in
  let x36 := - x30 in
  let x37 := orb (orb (Rlt_bool x25 (- x28)) (Rlt_bool x31 x36)) (Rlt_bool x32 x36) in
  let x38 := rnd (rnd ((9007198354021067 * bpow radix2 (-53)) * x27) / rnd (x8 + A_error f)) in
  if Rlt_bool (F f) (- B_error f) then
    Miss
  else if Rlt_bool (B_error f) (F f) then
    if Rlt_bool (rnd (2 * x7)) x6 then
      if Rlt_bool (rnd (2 * A_error f)) x8 then
        if x9 then
          if x13 then
            Miss
          else if x19 then
            Hit x20 x21 x22
          else if x24 then
            if x29 then
              Miss
            else if x33 then
              Hit x34 x35 x22
            else if x37 then
              Miss
            else Undecided
          else Undecided
        else if x29 then
          Miss
        else if x33 then
          Hit x34 x35 x22
        else if x37 then
          if x13 then
            Miss
          else if x19 then
            Hit x20 x21 x22
          else if x24 then
            Miss
          else Undecided
        else Undecided
      else if Rlt_bool limit x38 then
        if x9 then
          if x29 then
            Miss
          else if x33 then
            Hit x34 x35 x22
          else if x37 then
            Miss
          else Undecided
        else if x29 then
          Miss
        else if x33 then
          Hit x34 x35 x22
        else if x37 then
          Miss
        else Undecided
      else if Rlt_bool (rnd (2 * reach f)) (rnd (x38 * rnd (x14 - rnd (bpow radix2 (-51) * speed f)))) then
        if x9 then
          if x29 then
            Miss
          else if x33 then
            Hit x34 x35 x22
          else if x37 then
            Miss
          else Undecided
        else if x29 then
          Miss
        else if x33 then
          Hit x34 x35 x22
        else if x37 then
          Miss
        else Undecided
      else Undecided
    else Undecided
  else Undecided.

Definition first_of_curved_on_axial (f : quadratic R) (limit : R) : answer R :=
  let x1 := Rabs (A f) in
  let x2 := rnd ((- rnd (B f + B f)) / A f) in
  let x3 := Rabs x2 in
  let x4 := rnd (rnd (rnd (rnd (rnd (2 * B_error f) + rnd (x3 * A_error f)) / rnd (x1 - A_error f)) * (4503600077730459
      * bpow radix2 (-52))) + rnd (bpow radix2 (-51) * x3)) in
  let x5 := rnd (rnd (bpow radix2 (-49) * rnd (reach f + rnd (rnd (x3 + x4) * speed f))) + rnd (rnd (Rabs (s1 f) *
      (4503600077730459 * bpow radix2 (-52))) * x4)) in
  let x6 := rnd (s0 f + rnd (x2 * s1 f)) in
  let x7 := rnd (altura f - x6) in
  let x8 := - x5 in
  if Rlt_bool (rnd (2 * A_error f)) x1 then
    if Rlt_bool x4 (rnd (x2 - limit)) then
      Miss
    else if andb (andb (Rlt_bool x4 x2) (Rlt_bool x5 x6)) (Rlt_bool x5 x7) then
      Hit (Known x2 x4) (Known (- B f) (B_error f)) (Known (A f) (A_error f))
    else if orb (orb (Rlt_bool x2 (- x4)) (Rlt_bool x6 x8)) (Rlt_bool x7 x8) then
      Miss
    else Undecided
  else Undecided.

Definition first_of_linear (f : quadratic R) (limit : R) : answer R :=
  let x1 := rnd (2 * B_error f) in
  let x2 := rnd (B f + B f) in
  let x3 := rnd ((- C f) / x2) in
  let x4 := Rabs x3 in
  let x5 := rnd (rnd (rnd (rnd (C_error f + rnd (x4 * x1)) / rnd (Rabs x2 - x1)) * (4503600077730459 * bpow radix2
      (-52))) + rnd (bpow radix2 (-51) * x4)) in
  if Rlt_bool x1 (Rabs (B f)) then
    if Rlt_bool x5 (rnd (x3 - limit)) then
      Miss
    else if Rlt_bool x5 x3 then
      Hit (Known x3 x5) (Known (B f) (B_error f)) (Known (A f) (A_error f))
    else if Rlt_bool x3 (- x5) then
      Miss
    else Undecided
  else Undecided.

Definition first_of_linear_edged (f : quadratic R) (limit : R) : answer R :=
  let x1 := rnd (2 * B_error f) in
  let x2 := rnd (B f + B f) in
  let x3 := rnd ((- C f) / x2) in
  let x4 := Rabs x3 in
  let x5 := rnd (rnd (rnd (rnd (C_error f + rnd (x4 * x1)) / rnd (Rabs x2 - x1)) * (4503600077730459 * bpow radix2
      (-52))) + rnd (bpow radix2 (-51) * x4)) in
  if Rlt_bool x1 (Rabs (B f)) then
    if Rlt_bool x5 (rnd (x3 - limit)) then
      Miss
    else if andb (Rlt_bool x5 x3) (Rlt_bool (margin_error f) (margin f)) then
      Hit (Known x3 x5) (Known (B f) (B_error f)) (Known (A f) (A_error f))
    else if orb (Rlt_bool x3 (- x5)) (Rlt_bool (margin f) (- margin_error f)) then
      Miss
    else Undecided
  else Undecided.

Definition first_of_linear_on (f : quadratic R) (limit : R) : answer R :=
  if Rlt_bool (rnd (2 * B_error f)) (Rabs (B f)) then
    Miss
  else Undecided.

Definition ends_of (t : known R) : ends :=
  Ends (rnd (value t - error t)) (rnd (value t + error t)).

(** * Double-double *)

Module Pairs.

Record twofold := Twofold { hi : R; lo : R }.

Definition exactly (a : R) : twofold :=
  Twofold a 0.

Definition two_sum (a b : R) : twofold :=
  let x1 := rnd (a + b) in
  let x2 := rnd (x1 - a) in
  Twofold x1 (rnd (rnd (a - rnd (x1 - x2)) + rnd (b - x2))).

Definition fast_two_sum (a b : R) : twofold :=
  let x1 := rnd (a + b) in
  Twofold x1 (rnd (b - rnd (x1 - a))).

(** A product and what it lacks: where the hardware multiplies and subtracts in one, and where not. *)
Definition two_prod (a b : R) : twofold :=
  let x1 := rnd (a * b) in
  Twofold x1 (rnd (a * b - x1)).

Definition two_prod_of_halves (a b : R) : twofold :=
  let x1 := rnd (a * b) in
  let x2 := rnd ((134217729 * bpow radix2 0) * a) in
  let x3 := rnd (x2 - rnd (x2 - a)) in
  let x4 := rnd ((134217729 * bpow radix2 0) * b) in
  let x5 := rnd (x4 - rnd (x4 - b)) in
  let x6 := rnd (b - x5) in
  let x7 := rnd (a - x3) in
  Twofold x1 (rnd (rnd (rnd (rnd (rnd (x3 * x5) - x1) + rnd (x3 * x6)) + rnd (x7 * x5)) + rnd (x7 * x6))).

Definition opposite (x : twofold) : twofold :=
  Twofold (- hi x) (- lo x).

Definition sum (x y : twofold) : twofold :=
  let x1 := rnd (hi x + hi y) in
  let x2 := rnd (x1 - hi x) in
  let x3 := rnd (lo x + lo y) in
  let x4 := rnd (rnd (rnd (hi x - rnd (x1 - x2)) + rnd (hi y - x2)) + x3) in
  let x5 := rnd (x1 + x4) in
  let x6 := rnd (x3 - lo x) in
  let x7 := rnd (rnd (rnd (lo x - rnd (x3 - x6)) + rnd (lo y - x6)) + rnd (x4 - rnd (x5 - x1))) in
  let x8 := rnd (x5 + x7) in
  Twofold x8 (rnd (x7 - rnd (x8 - x5))).

Definition difference (x y : twofold) : twofold :=
  let x1 := - hi y in
  let x2 := rnd (hi x + x1) in
  let x3 := rnd (x2 - hi x) in
  let x4 := - lo y in
  let x5 := rnd (lo x + x4) in
  let x6 := rnd (rnd (rnd (hi x - rnd (x2 - x3)) + rnd (x1 - x3)) + x5) in
  let x7 := rnd (x2 + x6) in
  let x8 := rnd (x5 - lo x) in
  let x9 := rnd (rnd (rnd (lo x - rnd (x5 - x8)) + rnd (x4 - x8)) + rnd (x6 - rnd (x7 - x2))) in
  let x10 := rnd (x7 + x9) in
  Twofold x10 (rnd (x9 - rnd (x10 - x7))).

Definition product (x y : twofold) : twofold :=
  let x1 := rnd (hi x * hi y) in
  let x2 := rnd (rnd (hi x * hi y - x1) + rnd (rnd (lo x * lo y) + rnd (rnd (hi x * lo y) + rnd (lo x * hi y)))) in
  let x3 := rnd (x1 + x2) in
  Twofold x3 (rnd (x2 - rnd (x3 - x1))).

Definition ratio (x y : twofold) : twofold :=
  let x1 := rnd (hi x / hi y) in
  let x2 := rnd (hi y * x1) in
  let x3 := rnd (rnd (hi y * x1 - x2) + rnd (lo y * x1)) in
  let x4 := rnd (x2 + x3) in
  let x5 := - x4 in
  let x6 := rnd (hi x + x5) in
  let x7 := rnd (x6 - hi x) in
  let x8 := - rnd (x3 - rnd (x4 - x2)) in
  let x9 := rnd (lo x + x8) in
  let x10 := rnd (rnd (rnd (hi x - rnd (x6 - x7)) + rnd (x5 - x7)) + x9) in
  let x11 := rnd (x6 + x10) in
  let x12 := rnd (x9 - lo x) in
  let x13 := rnd (rnd (x11 + rnd (rnd (rnd (lo x - rnd (x9 - x12)) + rnd (x8 - x12)) + rnd (x10 - rnd (x11 - x6)))) / hi
      y) in
  let x14 := rnd (x1 + x13) in
  Twofold x14 (rnd (x13 - rnd (x14 - x1))).

Definition root_of (x : twofold) : twofold :=
  let x1 := rnd (sqrt (hi x)) in
  let x2 := rnd (x1 * x1) in
  let x3 := - x2 in
  let x4 := rnd (hi x + x3) in
  let x5 := rnd (x4 - hi x) in
  let x6 := - rnd (x1 * x1 - x2) in
  let x7 := rnd (lo x + x6) in
  let x8 := rnd (rnd (rnd (hi x - rnd (x4 - x5)) + rnd (x3 - x5)) + x7) in
  let x9 := rnd (x4 + x8) in
  let x10 := rnd (x7 - lo x) in
  let x11 := rnd (rnd (x9 + rnd (rnd (rnd (lo x - rnd (x7 - x10)) + rnd (x6 - x10)) + rnd (x8 - rnd (x9 - x4)))) / rnd
      (2 * x1)) in
  let x12 := rnd (x1 + x11) in
  if Rle_bool (hi x) 0 then
    Twofold 0 0
  else Twofold x12 (rnd (x11 - rnd (x12 - x1))).

Definition esfera (p v : vec) (speed : R) (centro : vec) (radio : R) : quadratic twofold :=
  let x1 := exactly (cx v) in
  let x2 := exactly (cy v) in
  let x3 := exactly (cz v) in
  let x4 := sum (sum (product x1 x1) (product x2 x2)) (product x3 x3) in
  let x5 := two_sum (cx p) (- cx centro) in
  let x6 := two_sum (cy p) (- cy centro) in
  let x7 := two_sum (cz p) (- cz centro) in
  let x8 := exactly radio in
  let x9 := product x8 (root_of x4) in
  let x10 := difference (product x6 x3) (product x7 x2) in
  let x11 := difference (product x7 x1) (product x5 x3) in
  let x12 := difference (product x5 x2) (product x6 x1) in
  let x13 := root_of (sum (sum (product x10 x10) (product x11 x11)) (product x12 x12)) in
  let x14 := rnd (bpow radix2 (-96) * speed) in
  let x15 := rnd (rnd (rnd (Rabs (hi x5) + Rabs (hi x6)) + Rabs (hi x7)) + radio) in
  let x16 := exactly 0 in
  {| A := x4;
     B := sum (sum (product x5 x1) (product x6 x2)) (product x7 x3);
     C := difference (sum (sum (product x5 x5) (product x6 x6)) (product x7 x7)) (product x8 x8);
     F := difference x9 x13;
     H := sum x9 x13;
     A_error := rnd (x14 * speed);
     B_error := rnd (x14 * x15);
     C_error := rnd (rnd (bpow radix2 (-96) * x15) * x15);
     s0 := x16;
     s1 := x16;
     altura := 0;
     reach := 0;
     speed := 0;
     margin := 0;
     margin_error := 0 |}.

Definition cilindro (p v : vec) (speed : R) (centro : vec) (radio : R) (vector : vec) (altura : R) : quadratic twofold
    :=
  let x1 := exactly (cx v) in
  let x2 := exactly (cx vector) in
  let x3 := exactly (cy v) in
  let x4 := exactly (cy vector) in
  let x5 := exactly (cz v) in
  let x6 := exactly (cz vector) in
  let x7 := sum (sum (product x1 x2) (product x3 x4)) (product x5 x6) in
  let x8 := difference x1 (product x7 x2) in
  let x9 := difference x3 (product x7 x4) in
  let x10 := difference x5 (product x7 x6) in
  let x11 := sum (sum (product x8 x8) (product x9 x9)) (product x10 x10) in
  let x12 := two_sum (cx p) (- cx centro) in
  let x13 := two_sum (cy p) (- cy centro) in
  let x14 := two_sum (cz p) (- cz centro) in
  let x15 := sum (sum (product x12 x2) (product x13 x4)) (product x14 x6) in
  let x16 := difference x12 (product x15 x2) in
  let x17 := difference x13 (product x15 x4) in
  let x18 := difference x14 (product x15 x6) in
  let x19 := exactly radio in
  let x20 := product x19 (root_of x11) in
  let x21 := difference (product x17 x10) (product x18 x9) in
  let x22 := difference (product x18 x8) (product x16 x10) in
  let x23 := difference (product x16 x9) (product x17 x8) in
  let x24 := root_of (sum (sum (product x21 x21) (product x22 x22)) (product x23 x23)) in
  let x25 := rnd (bpow radix2 (-96) * speed) in
  let x26 := rnd (rnd (Rabs (hi x12) + Rabs (hi x13)) + Rabs (hi x14)) in
  let x27 := rnd (x26 + radio) in
  {| A := x11;
     B := sum (sum (product x16 x8) (product x17 x9)) (product x18 x10);
     C := difference (sum (sum (product x16 x16) (product x17 x17)) (product x18 x18)) (product x19 x19);
     F := difference x20 x24;
     H := sum x20 x24;
     A_error := rnd (x25 * speed);
     B_error := rnd (x25 * x27);
     C_error := rnd (rnd (bpow radix2 (-96) * x27) * x27);
     s0 := x15;
     s1 := x7;
     altura := altura;
     reach := rnd (x26 + altura);
     speed := speed;
     margin := 0;
     margin_error := 0 |}.

Definition cono (p v : vec) (speed : R) (centro : vec) (proporcion : R) (vector : vec) (altura : R) : quadratic twofold
    :=
  let x1 := exactly (cx v) in
  let x2 := exactly (cx vector) in
  let x3 := exactly (cy v) in
  let x4 := exactly (cy vector) in
  let x5 := exactly (cz v) in
  let x6 := exactly (cz vector) in
  let x7 := sum (sum (product x1 x2) (product x3 x4)) (product x5 x6) in
  let x8 := difference x1 (product x7 x2) in
  let x9 := difference x3 (product x7 x4) in
  let x10 := difference x5 (product x7 x6) in
  let x11 := exactly proporcion in
  let x12 := product x11 x11 in
  let x13 := two_sum (cx p) (- cx centro) in
  let x14 := two_sum (cy p) (- cy centro) in
  let x15 := two_sum (cz p) (- cz centro) in
  let x16 := sum (sum (product x13 x2) (product x14 x4)) (product x15 x6) in
  let x17 := difference x13 (product x16 x2) in
  let x18 := difference x14 (product x16 x4) in
  let x19 := difference x15 (product x16 x6) in
  let x20 := difference (exactly altura) x16 in
  let x21 := sum (product x20 x8) (product x7 x17) in
  let x22 := sum (product x20 x9) (product x7 x18) in
  let x23 := sum (product x20 x10) (product x7 x19) in
  let x24 := product x11 (root_of (sum (sum (product x21 x21) (product x22 x22)) (product x23 x23))) in
  let x25 := difference (product x18 x10) (product x19 x9) in
  let x26 := difference (product x19 x8) (product x17 x10) in
  let x27 := difference (product x17 x9) (product x18 x8) in
  let x28 := root_of (sum (sum (product x25 x25) (product x26 x26)) (product x27 x27)) in
  let x29 := rnd (bpow radix2 (-96) * rnd (1 + rnd (proporcion * proporcion))) in
  let x30 := rnd (x29 * speed) in
  let x31 := rnd (rnd (rnd (Rabs (hi x13) + Rabs (hi x14)) + Rabs (hi x15)) + altura) in
  {| A := difference (sum (sum (product x8 x8) (product x9 x9)) (product x10 x10)) (product x12 (product x7 x7));
     B := sum (sum (sum (product x17 x8) (product x18 x9)) (product x19 x10)) (product x12 (product x20 x7));
     C := difference (sum (sum (product x17 x17) (product x18 x18)) (product x19 x19)) (product x12 (product x20 x20));
     F := difference x24 x28;
     H := sum x24 x28;
     A_error := rnd (x30 * speed);
     B_error := rnd (x30 * x31);
     C_error := rnd (rnd (x29 * x31) * x31);
     s0 := x16;
     s1 := x7;
     altura := altura;
     reach := x31;
     speed := speed;
     margin := 0;
     margin_error := 0 |}.

Definition tronco (p v : vec) (speed : R) (centro : vec) (radio : R) (proporcion : R) (vector : vec) (altura : R) :
    quadratic twofold :=
  let x1 := exactly (cx v) in
  let x2 := exactly (cx vector) in
  let x3 := exactly (cy v) in
  let x4 := exactly (cy vector) in
  let x5 := exactly (cz v) in
  let x6 := exactly (cz vector) in
  let x7 := sum (sum (product x1 x2) (product x3 x4)) (product x5 x6) in
  let x8 := difference x1 (product x7 x2) in
  let x9 := difference x3 (product x7 x4) in
  let x10 := difference x5 (product x7 x6) in
  let x11 := exactly proporcion in
  let x12 := product x11 x7 in
  let x13 := two_sum (cx p) (- cx centro) in
  let x14 := two_sum (cy p) (- cy centro) in
  let x15 := two_sum (cz p) (- cz centro) in
  let x16 := sum (sum (product x13 x2) (product x14 x4)) (product x15 x6) in
  let x17 := difference x13 (product x16 x2) in
  let x18 := difference x14 (product x16 x4) in
  let x19 := difference x15 (product x16 x6) in
  let x20 := sum (exactly radio) (product x11 (difference (exactly altura) x16)) in
  let x21 := sum (product x20 x8) (product x12 x17) in
  let x22 := sum (product x20 x9) (product x12 x18) in
  let x23 := sum (product x20 x10) (product x12 x19) in
  let x24 := root_of (sum (sum (product x21 x21) (product x22 x22)) (product x23 x23)) in
  let x25 := difference (product x18 x10) (product x19 x9) in
  let x26 := difference (product x19 x8) (product x17 x10) in
  let x27 := difference (product x17 x9) (product x18 x8) in
  let x28 := root_of (sum (sum (product x25 x25) (product x26 x26)) (product x27 x27)) in
  let x29 := rnd (bpow radix2 (-96) * rnd (1 + rnd (proporcion * proporcion))) in
  let x30 := rnd (x29 * speed) in
  let x31 := rnd (rnd (rnd (Rabs (hi x13) + Rabs (hi x14)) + Rabs (hi x15)) + altura) in
  let x32 := rnd (x31 + radio) in
  {| A := difference (sum (sum (product x8 x8) (product x9 x9)) (product x10 x10)) (product x12 x12);
     B := sum (sum (sum (product x17 x8) (product x18 x9)) (product x19 x10)) (product x20 x12);
     C := difference (sum (sum (product x17 x17) (product x18 x18)) (product x19 x19)) (product x20 x20);
     F := difference x24 x28;
     H := sum x24 x28;
     A_error := rnd (x30 * speed);
     B_error := rnd (x30 * x32);
     C_error := rnd (rnd (x29 * x32) * x32);
     s0 := x16;
     s1 := x7;
     altura := altura;
     reach := x31;
     speed := speed;
     margin := 0;
     margin_error := 0 |}.

Definition plano (p v : vec) (speed : R) (centro : vec) (vector : vec) : quadratic twofold :=
  let x1 := exactly 0 in
  let x2 := exactly (cx vector) in
  let x3 := exactly (cy vector) in
  let x4 := exactly (cz vector) in
  let x5 := two_sum (cx p) (- cx centro) in
  let x6 := two_sum (cy p) (- cy centro) in
  let x7 := two_sum (cz p) (- cz centro) in
  {| A := x1;
     B := product (sum (sum (product (exactly (cx v)) x2) (product (exactly (cy v)) x3)) (product (exactly (cz v)) x4))
         (exactly (bpow radix2 (-1)));
     C := sum (sum (product x5 x2) (product x6 x3)) (product x7 x4);
     F := x1;
     H := x1;
     A_error := 0;
     B_error := rnd ((3 * bpow radix2 (-102)) * speed);
     C_error := rnd (bpow radix2 (-99) * rnd (rnd (Rabs (hi x5) + Rabs (hi x6)) + Rabs (hi x7)));
     s0 := x1;
     s1 := x1;
     altura := 0;
     reach := 0;
     speed := 0;
     margin := 0;
     margin_error := 0 |}.

Definition disco (p v : vec) (speed : R) (centro : vec) (radio : R) (vector : vec) : quadratic twofold :=
  let x1 := exactly 0 in
  let x2 := exactly (cx v) in
  let x3 := exactly (cx vector) in
  let x4 := exactly (cy v) in
  let x5 := exactly (cy vector) in
  let x6 := exactly (cz v) in
  let x7 := exactly (cz vector) in
  let x8 := product (sum (sum (product x2 x3) (product x4 x5)) (product x6 x7)) (exactly (bpow radix2 (-1))) in
  let x9 := two_sum (cx p) (- cx centro) in
  let x10 := two_sum (cy p) (- cy centro) in
  let x11 := two_sum (cz p) (- cz centro) in
  let x12 := sum (sum (product x9 x3) (product x10 x5)) (product x11 x7) in
  let x13 := rnd (rnd (Rabs (hi x9) + Rabs (hi x10)) + Rabs (hi x11)) in
  let x14 := sum x8 x8 in
  let x15 := product (exactly radio) x14 in
  let x16 := opposite x12 in
  let x17 := sum (product x14 x9) (product x16 x2) in
  let x18 := sum (product x14 x10) (product x16 x4) in
  let x19 := sum (product x14 x11) (product x16 x6) in
  {| A := x1;
     B := x8;
     C := x12;
     F := x1;
     H := x1;
     A_error := 0;
     B_error := rnd ((3 * bpow radix2 (-102)) * speed);
     C_error := rnd (bpow radix2 (-99) * x13);
     s0 := x1;
     s1 := x1;
     altura := 0;
     reach := 0;
     speed := 0;
     margin := hi (difference (if Rlt_bool (hi x14) 0 then opposite x15 else x15) (root_of (sum (sum (product x17 x17)
         (product x18 x18)) (product x19 x19))));
     margin_error := rnd (rnd (bpow radix2 (-97) * speed) * rnd (x13 + radio)) |}.

Definition triangulo (p v : vec) (speed : R) (a b c : vec) : quadratic twofold :=
  let x1 := exactly 0 in
  let x2 := - cx a in
  let x3 := two_sum (cx b) x2 in
  let x4 := exactly (cy v) in
  let x5 := - cz a in
  let x6 := two_sum (cz c) x5 in
  let x7 := exactly (cz v) in
  let x8 := - cy a in
  let x9 := two_sum (cy c) x8 in
  let x10 := difference (product x4 x6) (product x7 x9) in
  let x11 := two_sum (cy b) x8 in
  let x12 := two_sum (cx c) x2 in
  let x13 := exactly (cx v) in
  let x14 := difference (product x7 x12) (product x13 x6) in
  let x15 := two_sum (cz b) x5 in
  let x16 := difference (product x13 x9) (product x4 x12) in
  let x17 := sum (sum (product x3 x10) (product x11 x14)) (product x15 x16) in
  let x18 := two_sum (cy p) x8 in
  let x19 := two_sum (cz p) x5 in
  let x20 := difference (product x18 x15) (product x19 x11) in
  let x21 := two_sum (cx p) x2 in
  let x22 := difference (product x19 x3) (product x21 x15) in
  let x23 := difference (product x21 x11) (product x18 x3) in
  let x24 := rnd (rnd (Rabs (hi x3) + Rabs (hi x11)) + Rabs (hi x15)) in
  let x25 := rnd (rnd (Rabs (hi x12) + Rabs (hi x9)) + Rabs (hi x6)) in
  let x26 := rnd (rnd (Rabs (hi x21) + Rabs (hi x18)) + Rabs (hi x19)) in
  let x27 := Rlt_bool (hi x17) 0 in
  let x28 := sum (sum (product x13 x20) (product x4 x22)) (product x7 x23) in
  let x29 := hi x28 in
  let x30 := if x27 then - x29 else x29 in
  let x31 := sum (sum (product x21 x10) (product x18 x14)) (product x19 x16) in
  let x32 := hi (difference (difference x17 x31) x28) in
  let x33 := if x27 then - x32 else x32 in
  let x34 := if Rlt_bool x30 x33 then x30 else x33 in
  let x35 := hi x31 in
  let x36 := if x27 then - x35 else x35 in
  {| A := x1;
     B := product x17 (exactly (- bpow radix2 (-1)));
     C := sum (sum (product x12 x20) (product x9 x22)) (product x6 x23);
     F := x1;
     H := x1;
     A_error := 0;
     B_error := rnd (rnd (rnd (bpow radix2 (-99) * speed) * x24) * x25);
     C_error := rnd (rnd (rnd (bpow radix2 (-98) * x26) * x24) * x25);
     s0 := x1;
     s1 := x1;
     altura := 0;
     reach := 0;
     speed := 0;
     margin := if Rlt_bool x34 x36 then x34 else x36;
     margin_error := rnd (rnd ((9 * bpow radix2 (-101)) * speed) * rnd (rnd (x24 * x25) + rnd (x26 * rnd (x24 + x25))))
         |}.

Definition root_of_discriminant (f : quadratic twofold) : known twofold :=
  let x1 := root_of (product (F f) (H f)) in
  let x2 := hi x1 in
  Known x1 (rnd (rnd (rnd (rnd (3 * B_error f) * hi (H f)) / x2) + rnd (bpow radix2 (-100) * x2))).

Definition stable_sum (f : quadratic twofold) (D : known twofold) : stable twofold :=
  let x1 := Rle_bool 0 (hi (B f)) in
  let x2 := if x1 then value D else opposite (value D) in
  let x3 := opposite (sum (B f) x2) in
  Stable x1 x2 (Known x3 (rnd (rnd (B_error f + error D) + rnd (bpow radix2 (-101) * Rabs (hi x3))))).

Definition quotient (x : twofold) (x_error : R) (y : twofold) (y_error : R) : known twofold :=
  let x1 := ratio x y in
  let x2 := Rabs (hi x1) in
  Known x1 (rnd (rnd (rnd (rnd (x_error + rnd (x2 * y_error)) / rnd (Rabs (hi y) - y_error)) * (4503600077730459 * bpow
      radix2 (-52))) + rnd (bpow radix2 (-100) * x2))).

Definition advance (f : quadratic twofold) (t : known twofold) : known twofold :=
  Known (sum (s0 f) (product (value t) (s1 f))) (rnd (rnd (bpow radix2 (-98) * rnd (reach f + rnd (rnd (Rabs (hi (value
      t)) + error t) * speed f))) + rnd (rnd (Rabs (hi (s1 f)) * (4503600077730459 * bpow radix2 (-52))) * error t))).

Definition beyond (t : known twofold) (limit : R) : bool :=
  (Rlt_bool (error t) (hi (difference (value t) (exactly limit)))).

Definition place (f : quadratic twofold) (t : known twofold) : placed :=
  let x1 := hi (value t) in
  Placed (Rlt_bool x1 (- error t)) (Rlt_bool (error t) x1).

Definition place_axial (f : quadratic twofold) (t : known twofold) : placed :=
  let x1 := hi (value t) in
  let x2 := sum (s0 f) (product (value t) (s1 f)) in
  let x3 := hi x2 in
  let x4 := rnd (rnd (bpow radix2 (-98) * rnd (reach f + rnd (rnd (Rabs x1 + error t) * speed f))) + rnd (rnd (Rabs (hi
      (s1 f)) * (4503600077730459 * bpow radix2 (-52))) * error t)) in
  let x5 := - x4 in
  let x6 := hi (difference (exactly (altura f)) x2) in
  Placed (orb (orb (Rlt_bool x1 (- error t)) (Rlt_bool x3 x5)) (Rlt_bool x6 x5)) (andb (andb (Rlt_bool (error t) x1)
      (Rlt_bool x4 x3)) (Rlt_bool x4 x6)).

Definition place_edged (f : quadratic twofold) (t : known twofold) : placed :=
  let x1 := hi (value t) in
  Placed (orb (Rlt_bool x1 (- error t)) (Rlt_bool (margin f) (- margin_error f))) (andb (Rlt_bool (error t) x1)
      (Rlt_bool (margin_error f) (margin f))).

Definition first_of_curved (f : quadratic twofold) (limit : R) : answer twofold :=
  let x1 := hi (F f) in
  let x2 := root_of (product (F f) (H f)) in
  let x3 := hi x2 in
  let x4 := rnd (rnd (rnd (rnd (3 * B_error f) * hi (H f)) / x3) + rnd (bpow radix2 (-100) * x3)) in
  let x5 := Rle_bool 0 (hi (B f)) in
  let x6 := if x5 then x2 else opposite x2 in
  let x7 := opposite (sum (B f) x6) in
  let x8 := Rabs (hi x7) in
  let x9 := rnd (rnd (B_error f + x4) + rnd (bpow radix2 (-101) * x8)) in
  let x10 := hi (A f) in
  let x11 := Rabs x10 in
  let x12 := eqb (Rlt_bool 0 x10) x5 in
  let x13 := ratio x7 (A f) in
  let x14 := hi x13 in
  let x15 := Rabs x14 in
  let x16 := rnd (rnd (rnd (rnd (x9 + rnd (x15 * A_error f)) / rnd (x11 - A_error f)) * (4503600077730459 * bpow radix2
      (-52))) + rnd (bpow radix2 (-100) * x15)) in
  let x17 := exactly limit in
  let x18 := Rlt_bool x16 (hi (difference x13 x17)) in
  let x19 := Rlt_bool x16 x14 in
  let x20 := Known x13 x16 in
  let x21 := Known (hi (opposite x6)) x4 in
  let x22 := Known x10 (A_error f) in
  let x23 := Rlt_bool x14 (- x16) in
  let x24 := ratio (C f) x7 in
  let x25 := hi x24 in
  let x26 := Rabs x25 in
  let x27 := rnd (x8 - x9) in
  let x28 := rnd (rnd (rnd (rnd (C_error f + rnd (x26 * x9)) / x27) * (4503600077730459 * bpow radix2 (-52))) + rnd
      (bpow radix2 (-100) * x26)) in
  let x29 := Rlt_bool x28 (hi (difference x24 x17)) in
  let x30 := Rlt_bool x28 x25 in
  let x31 := Known x24 x28 in
  let x32 := Known (hi x6) x4 in
  let x33 := Rlt_bool x25 (- x28) in
  if Rlt_bool x1 (- B_error f) then
    Miss
  else if Rlt_bool (B_error f) x1 then
    if Rlt_bool (rnd (2 * x9)) x8 then
      if Rlt_bool (rnd (2 * A_error f)) x11 then
        if x12 then
          if x18 then
            Miss
          else if x19 then
            Hit x20 x21 x22
          else if x23 then
            if x29 then
              Miss
            else if x30 then
              Hit x31 x32 x22
            else if x33 then
              Miss
            else Undecided
          else Undecided
        else if x29 then
          Miss
        else if x30 then
          Hit x31 x32 x22
        else if x33 then
          if x18 then
            Miss
          else if x19 then
            Hit x20 x21 x22
          else if x23 then
            Miss
          else Undecided
        else Undecided
      else if Rlt_bool limit (rnd (rnd ((9007198354021067 * bpow radix2 (-53)) * x27) / rnd (x11 + A_error f))) then
        if x12 then
          if x29 then
            Miss
          else if x30 then
            Hit x31 x32 x22
          else if x33 then
            Miss
          else Undecided
        else if x29 then
          Miss
        else if x30 then
          Hit x31 x32 x22
        else if x33 then
          Miss
        else Undecided
      else Undecided
    else Undecided
  else Undecided.

Definition first_of_curved_on (f : quadratic twofold) (limit : R) : answer twofold :=
  let x1 := hi (A f) in
  let x2 := Rabs x1 in
  let x3 := ratio (opposite (sum (B f) (B f))) (A f) in
  let x4 := hi x3 in
  let x5 := Rabs x4 in
  let x6 := rnd (rnd (rnd (rnd (rnd (2 * B_error f) + rnd (x5 * A_error f)) / rnd (x2 - A_error f)) * (4503600077730459
      * bpow radix2 (-52))) + rnd (bpow radix2 (-100) * x5)) in
  if Rlt_bool (rnd (2 * A_error f)) x2 then
    if Rlt_bool x6 (hi (difference x3 (exactly limit))) then
      Miss
    else if Rlt_bool x6 x4 then
      Hit (Known x3 x6) (Known (hi (opposite (B f))) (B_error f)) (Known x1 (A_error f))
    else if Rlt_bool x4 (- x6) then
      Miss
    else Undecided
  else Undecided.

Definition first_of_curved_axial (f : quadratic twofold) (limit : R) : answer twofold :=
  let x1 := hi (F f) in
  let x2 := root_of (product (F f) (H f)) in
  let x3 := hi x2 in
  let x4 := rnd (rnd (rnd (rnd (3 * B_error f) * hi (H f)) / x3) + rnd (bpow radix2 (-100) * x3)) in
  let x5 := Rle_bool 0 (hi (B f)) in
  let x6 := if x5 then x2 else opposite x2 in
  let x7 := opposite (sum (B f) x6) in
  let x8 := Rabs (hi x7) in
  let x9 := rnd (rnd (B_error f + x4) + rnd (bpow radix2 (-101) * x8)) in
  let x10 := hi (A f) in
  let x11 := Rabs x10 in
  let x12 := eqb (Rlt_bool 0 x10) x5 in
  let x13 := ratio x7 (A f) in
  let x14 := hi x13 in
  let x15 := Rabs x14 in
  let x16 := rnd (rnd (rnd (rnd (x9 + rnd (x15 * A_error f)) / rnd (x11 - A_error f)) * (4503600077730459 * bpow radix2
      (-52))) + rnd (bpow radix2 (-100) * x15)) in
  let x17 := exactly limit in
  let x18 := Rlt_bool x16 (hi (difference x13 x17)) in
  let x19 := Rabs (hi (s1 f)) in
  let x20 := rnd (x19 * (4503600077730459 * bpow radix2 (-52))) in
  let x21 := rnd (rnd (bpow radix2 (-98) * rnd (reach f + rnd (rnd (x15 + x16) * speed f))) + rnd (x20 * x16)) in
  let x22 := sum (s0 f) (product x13 (s1 f)) in
  let x23 := hi x22 in
  let x24 := exactly (altura f) in
  let x25 := hi (difference x24 x22) in
  let x26 := andb (andb (Rlt_bool x16 x14) (Rlt_bool x21 x23)) (Rlt_bool x21 x25) in
  let x27 := Known x13 x16 in
  let x28 := Known (hi (opposite x6)) x4 in
  let x29 := Known x10 (A_error f) in
  let x30 := - x21 in
  let x31 := orb (orb (Rlt_bool x14 (- x16)) (Rlt_bool x23 x30)) (Rlt_bool x25 x30) in
  let x32 := ratio (C f) x7 in
  let x33 := hi x32 in
  let x34 := Rabs x33 in
  let x35 := rnd (x8 - x9) in
  let x36 := rnd (rnd (rnd (rnd (C_error f + rnd (x34 * x9)) / x35) * (4503600077730459 * bpow radix2 (-52))) + rnd
      (bpow radix2 (-100) * x34)) in
  let x37 := Rlt_bool x36 (hi (difference x32 x17)) in
  let x38 := rnd (rnd (bpow radix2 (-98) * rnd (reach f + rnd (rnd (x34 + x36) * speed f))) + rnd (x20 * x36)) in
  let x39 := sum (s0 f) (product x32 (s1 f)) in
  let x40 := hi x39 in
  let x41 := hi (difference x24 x39) in
  let x42 := andb (andb (Rlt_bool x36 x33) (Rlt_bool x38 x40)) (Rlt_bool x38 x41) in
  let x43 := Known x32 x36 in
  let x44 := Known (hi x6) x4 in
  let x45 := - x38 in
  let x46 := orb (orb (Rlt_bool x33 (- x36)) (Rlt_bool x40 x45)) (Rlt_bool x41 x45) in
  let x47 := rnd (rnd ((9007198354021067 * bpow radix2 (-53)) * x35) / rnd (x11 + A_error f)) in
  if Rlt_bool x1 (- B_error f) then
    Miss
  else if Rlt_bool (B_error f) x1 then
    if Rlt_bool (rnd (2 * x9)) x8 then
      if Rlt_bool (rnd (2 * A_error f)) x11 then
        if x12 then
          if x18 then
            Miss
          else if x26 then
            Hit x27 x28 x29
          else if x31 then
            if x37 then
              Miss
            else if x42 then
              Hit x43 x44 x29
            else if x46 then
              Miss
            else Undecided
          else Undecided
        else if x37 then
          Miss
        else if x42 then
          Hit x43 x44 x29
        else if x46 then
          if x18 then
            Miss
          else if x26 then
            Hit x27 x28 x29
          else if x31 then
            Miss
          else Undecided
        else Undecided
      else if Rlt_bool limit x47 then
        if x12 then
          if x37 then
            Miss
          else if x42 then
            Hit x43 x44 x29
          else if x46 then
            Miss
          else Undecided
        else if x37 then
          Miss
        else if x42 then
          Hit x43 x44 x29
        else if x46 then
          Miss
        else Undecided
      else if Rlt_bool (rnd (2 * reach f)) (rnd (x47 * rnd (x19 - rnd (bpow radix2 (-100) * speed f)))) then
        if x12 then
          if x37 then
            Miss
          else if x42 then
            Hit x43 x44 x29
          else if x46 then
            Miss
          else Undecided
        else if x37 then
          Miss
        else if x42 then
          Hit x43 x44 x29
        else if x46 then
          Miss
        else Undecided
      else Undecided
    else Undecided
  else Undecided.

Definition first_of_curved_on_axial (f : quadratic twofold) (limit : R) : answer twofold :=
  let x1 := hi (A f) in
  let x2 := Rabs x1 in
  let x3 := ratio (opposite (sum (B f) (B f))) (A f) in
  let x4 := hi x3 in
  let x5 := Rabs x4 in
  let x6 := rnd (rnd (rnd (rnd (rnd (2 * B_error f) + rnd (x5 * A_error f)) / rnd (x2 - A_error f)) * (4503600077730459
      * bpow radix2 (-52))) + rnd (bpow radix2 (-100) * x5)) in
  let x7 := rnd (rnd (bpow radix2 (-98) * rnd (reach f + rnd (rnd (x5 + x6) * speed f))) + rnd (rnd (Rabs (hi (s1 f)) *
      (4503600077730459 * bpow radix2 (-52))) * x6)) in
  let x8 := sum (s0 f) (product x3 (s1 f)) in
  let x9 := hi x8 in
  let x10 := hi (difference (exactly (altura f)) x8) in
  let x11 := - x7 in
  if Rlt_bool (rnd (2 * A_error f)) x2 then
    if Rlt_bool x6 (hi (difference x3 (exactly limit))) then
      Miss
    else if andb (andb (Rlt_bool x6 x4) (Rlt_bool x7 x9)) (Rlt_bool x7 x10) then
      Hit (Known x3 x6) (Known (hi (opposite (B f))) (B_error f)) (Known x1 (A_error f))
    else if orb (orb (Rlt_bool x4 (- x6)) (Rlt_bool x9 x11)) (Rlt_bool x10 x11) then
      Miss
    else Undecided
  else Undecided.

Definition first_of_linear (f : quadratic twofold) (limit : R) : answer twofold :=
  let x1 := rnd (2 * B_error f) in
  let x2 := hi (B f) in
  let x3 := sum (B f) (B f) in
  let x4 := ratio (opposite (C f)) x3 in
  let x5 := hi x4 in
  let x6 := Rabs x5 in
  let x7 := rnd (rnd (rnd (rnd (C_error f + rnd (x6 * x1)) / rnd (Rabs (hi x3) - x1)) * (4503600077730459 * bpow radix2
      (-52))) + rnd (bpow radix2 (-100) * x6)) in
  if Rlt_bool x1 (Rabs x2) then
    if Rlt_bool x7 (hi (difference x4 (exactly limit))) then
      Miss
    else if Rlt_bool x7 x5 then
      Hit (Known x4 x7) (Known x2 (B_error f)) (Known (hi (A f)) (A_error f))
    else if Rlt_bool x5 (- x7) then
      Miss
    else Undecided
  else Undecided.

Definition first_of_linear_edged (f : quadratic twofold) (limit : R) : answer twofold :=
  let x1 := rnd (2 * B_error f) in
  let x2 := hi (B f) in
  let x3 := sum (B f) (B f) in
  let x4 := ratio (opposite (C f)) x3 in
  let x5 := hi x4 in
  let x6 := Rabs x5 in
  let x7 := rnd (rnd (rnd (rnd (C_error f + rnd (x6 * x1)) / rnd (Rabs (hi x3) - x1)) * (4503600077730459 * bpow radix2
      (-52))) + rnd (bpow radix2 (-100) * x6)) in
  if Rlt_bool x1 (Rabs x2) then
    if Rlt_bool x7 (hi (difference x4 (exactly limit))) then
      Miss
    else if andb (Rlt_bool x7 x5) (Rlt_bool (margin_error f) (margin f)) then
      Hit (Known x4 x7) (Known x2 (B_error f)) (Known (hi (A f)) (A_error f))
    else if orb (Rlt_bool x5 (- x7)) (Rlt_bool (margin f) (- margin_error f)) then
      Miss
    else Undecided
  else Undecided.

Definition first_of_linear_on (f : quadratic twofold) (limit : R) : answer twofold :=
  if Rlt_bool (rnd (2 * B_error f)) (Rabs (hi (B f))) then
    Miss
  else Undecided.

Definition ends_of (a : known twofold) : ends :=
  let x1 := rnd (error a + rnd (bpow radix2 (-51) * Rabs (hi (value a)))) in
  Ends (rnd (hi (value a) - x1)) (rnd (hi (value a) + x1)).

Definition certainly_less (a b : known twofold) : bool :=
  (Rlt_bool (rnd ((4503600077730459 * bpow radix2 (-52)) * rnd (error a + error b))) (rnd (rnd (hi (value b) - hi (value
      a)) + rnd (lo (value b) - lo (value a))))).

Record improved := Improved { known_slope : bool; better : twofold; better_error : R }.
Record once := Once { rounded : R; certain : bool }.
Record once_point := Once_point { of_t : R; of_x : R; of_y : R; of_z : R; all_certain : bool }.

Definition newton (t slope A : known R) (f : known twofold) : improved :=
  let x1 := rnd ((4503600077730459 * bpow radix2 (-52)) * rnd (rnd (2 * error slope) + rnd (rnd (Rabs (value A) + error
      A) * error t))) in
  let x2 := rnd (2 * value slope) in
  let x3 := Rabs x2 in
  let x4 := rnd (hi (value f) + lo (value f)) in
  let x5 := rnd ((- x4) / x2) in
  let x6 := rnd (value t + x5) in
  let x7 := rnd (x6 - value t) in
  let x8 := Rabs x5 in
  Improved (Rlt_bool (rnd (2 * x1)) x3) (Twofold x6 (rnd (rnd (value t - rnd (x6 - x7)) + rnd (x5 - x7)))) (rnd (rnd
      (rnd (rnd (rnd (error f + rnd (bpow radix2 (-52) * Rabs x4)) + rnd (x8 * x1)) / rnd (x3 - x1)) * (4503600077730459
      * bpow radix2 (-52))) + rnd (bpow radix2 (-51) * x8))).

Definition round_once (t : twofold) (error : R) : once :=
  let x1 := rnd (rnd ((4503600077730459 * bpow radix2 (-52)) * error) + rnd (bpow radix2 (-52) * Rabs (lo t))) in
  let x2 := rnd (hi t + rnd (lo t - x1)) in
  let x3 := Rabs x2 in
  Once x2 (andb (andb (Req_bool x2 (rnd (hi t + rnd (lo t + x1)))) (Rlt_bool (bpow radix2 (-900)) x3)) (Rlt_bool x3
      (bpow radix2 900))).

Definition coordinate (p v : R) (t : twofold) (error : R) : known twofold :=
  let x1 := rnd (hi t * v) in
  let x2 := rnd (x1 + p) in
  let x3 := rnd (x2 - x1) in
  Known (Twofold x2 (rnd (rnd (rnd (x1 - rnd (x2 - x3)) + rnd (p - x3)) + rnd (rnd (rnd (hi t * v - x1) + rnd (lo t *
      v)) + 0)))) (rnd (rnd (Rabs v * error) + rnd (bpow radix2 (-102) * rnd (Rabs x1 + Rabs p)))).

Definition round_coordinate (p v : R) (t : twofold) (error : R) : once :=
  let x1 := Req_bool v 0 in
  let x2 := rnd (hi t * v) in
  let x3 := rnd (x2 + p) in
  let x4 := rnd (x3 - x2) in
  let x5 := rnd (rnd (rnd (x2 - rnd (x3 - x4)) + rnd (p - x4)) + rnd (rnd (rnd (hi t * v - x2) + rnd (lo t * v)) + 0))
      in
  let x6 := rnd (rnd ((4503600077730459 * bpow radix2 (-52)) * rnd (rnd (Rabs v * error) + rnd (bpow radix2 (-102) * rnd
      (Rabs x2 + Rabs p)))) + rnd (bpow radix2 (-52) * Rabs x5)) in
  let x7 := rnd (x3 + rnd (x5 - x6)) in
  let x8 := Rabs x7 in
  Once (if x1 then rnd (p + 0) else x7) (orb x1 (andb (andb (Req_bool x7 (rnd (x3 + rnd (x5 + x6)))) (Rlt_bool (bpow
      radix2 (-900)) x8)) (Rlt_bool x8 (bpow radix2 900)))).

Definition round_point (p v : vec) (t : twofold) (error : R) : once_point :=
  let x1 := rnd (rnd ((4503600077730459 * bpow radix2 (-52)) * error) + rnd (bpow radix2 (-52) * Rabs (lo t))) in
  let x2 := rnd (hi t + rnd (lo t - x1)) in
  let x3 := Req_bool (cx v) 0 in
  let x4 := rnd (hi t * cx v) in
  let x5 := rnd (x4 + cx p) in
  let x6 := rnd (x5 - x4) in
  let x7 := rnd (rnd (rnd (x4 - rnd (x5 - x6)) + rnd (cx p - x6)) + rnd (rnd (rnd (hi t * cx v - x4) + rnd (lo t * cx
      v)) + 0)) in
  let x8 := rnd (rnd ((4503600077730459 * bpow radix2 (-52)) * rnd (rnd (Rabs (cx v) * error) + rnd (bpow radix2 (-102)
      * rnd (Rabs x4 + Rabs (cx p))))) + rnd (bpow radix2 (-52) * Rabs x7)) in
  let x9 := rnd (x5 + rnd (x7 - x8)) in
  let x10 := Req_bool (cy v) 0 in
  let x11 := rnd (hi t * cy v) in
  let x12 := rnd (x11 + cy p) in
  let x13 := rnd (x12 - x11) in
  let x14 := rnd (rnd (rnd (x11 - rnd (x12 - x13)) + rnd (cy p - x13)) + rnd (rnd (rnd (hi t * cy v - x11) + rnd (lo t *
      cy v)) + 0)) in
  let x15 := rnd (rnd ((4503600077730459 * bpow radix2 (-52)) * rnd (rnd (Rabs (cy v) * error) + rnd (bpow radix2 (-102)
      * rnd (Rabs x11 + Rabs (cy p))))) + rnd (bpow radix2 (-52) * Rabs x14)) in
  let x16 := rnd (x12 + rnd (x14 - x15)) in
  let x17 := Req_bool (cz v) 0 in
  let x18 := rnd (hi t * cz v) in
  let x19 := rnd (x18 + cz p) in
  let x20 := rnd (x19 - x18) in
  let x21 := rnd (rnd (rnd (x18 - rnd (x19 - x20)) + rnd (cz p - x20)) + rnd (rnd (rnd (hi t * cz v - x18) + rnd (lo t *
      cz v)) + 0)) in
  let x22 := rnd (rnd ((4503600077730459 * bpow radix2 (-52)) * rnd (rnd (Rabs (cz v) * error) + rnd (bpow radix2 (-102)
      * rnd (Rabs x18 + Rabs (cz p))))) + rnd (bpow radix2 (-52) * Rabs x21)) in
  let x23 := rnd (x19 + rnd (x21 - x22)) in
  let x24 := Rabs x2 in
  let x25 := Rabs x9 in
  let x26 := Rabs x16 in
  let x27 := Rabs x23 in
  Once_point x2 (if x3 then rnd (cx p + 0) else x9) (if x10 then rnd (cy p + 0) else x16) (if x17 then rnd (cz p + 0)
      else x23) (andb (andb (andb (andb (andb (Req_bool x2 (rnd (hi t + rnd (lo t + x1)))) (Rlt_bool (bpow radix2
      (-900)) x24)) (Rlt_bool x24 (bpow radix2 900))) (orb x3 (andb (andb (Req_bool x9 (rnd (x5 + rnd (x7 + x8))))
      (Rlt_bool (bpow radix2 (-900)) x25)) (Rlt_bool x25 (bpow radix2 900))))) (orb x10 (andb (andb (Req_bool x16 (rnd
      (x12 + rnd (x14 + x15)))) (Rlt_bool (bpow radix2 (-900)) x26)) (Rlt_bool x26 (bpow radix2 900))))) (orb x17 (andb
      (andb (Req_bool x23 (rnd (x19 + rnd (x21 + x22)))) (Rlt_bool (bpow radix2 (-900)) x27)) (Rlt_bool x27 (bpow radix2
      900))))).

Definition round_plano (p v : vec) (t : twofold) (error : R) (centro : vec) (vector : vec) : once_point :=
  let x1 := rnd (rnd ((4503600077730459 * bpow radix2 (-52)) * error) + rnd (bpow radix2 (-52) * Rabs (lo t))) in
  let x2 := rnd (hi t + rnd (lo t - x1)) in
  let x3 := Req_bool (cy vector) 0 in
  let x4 := Req_bool (cz vector) 0 in
  let x5 := andb x3 x4 in
  let x6 := Req_bool (cx v) 0 in
  let x7 := rnd (hi t * cx v) in
  let x8 := rnd (x7 + cx p) in
  let x9 := rnd (x8 - x7) in
  let x10 := rnd (rnd (rnd (x7 - rnd (x8 - x9)) + rnd (cx p - x9)) + rnd (rnd (rnd (hi t * cx v - x7) + rnd (lo t * cx
      v)) + 0)) in
  let x11 := rnd (rnd ((4503600077730459 * bpow radix2 (-52)) * rnd (rnd (Rabs (cx v) * error) + rnd (bpow radix2 (-102)
      * rnd (Rabs x7 + Rabs (cx p))))) + rnd (bpow radix2 (-52) * Rabs x10)) in
  let x12 := rnd (x8 + rnd (x10 - x11)) in
  let x13 := Req_bool (cx vector) 0 in
  let x14 := andb x4 x13 in
  let x15 := Req_bool (cy v) 0 in
  let x16 := rnd (hi t * cy v) in
  let x17 := rnd (x16 + cy p) in
  let x18 := rnd (x17 - x16) in
  let x19 := rnd (rnd (rnd (x16 - rnd (x17 - x18)) + rnd (cy p - x18)) + rnd (rnd (rnd (hi t * cy v - x16) + rnd (lo t *
      cy v)) + 0)) in
  let x20 := rnd (rnd ((4503600077730459 * bpow radix2 (-52)) * rnd (rnd (Rabs (cy v) * error) + rnd (bpow radix2 (-102)
      * rnd (Rabs x16 + Rabs (cy p))))) + rnd (bpow radix2 (-52) * Rabs x19)) in
  let x21 := rnd (x17 + rnd (x19 - x20)) in
  let x22 := andb x13 x3 in
  let x23 := Req_bool (cz v) 0 in
  let x24 := rnd (hi t * cz v) in
  let x25 := rnd (x24 + cz p) in
  let x26 := rnd (x25 - x24) in
  let x27 := rnd (rnd (rnd (x24 - rnd (x25 - x26)) + rnd (cz p - x26)) + rnd (rnd (rnd (hi t * cz v - x24) + rnd (lo t *
      cz v)) + 0)) in
  let x28 := rnd (rnd ((4503600077730459 * bpow radix2 (-52)) * rnd (rnd (Rabs (cz v) * error) + rnd (bpow radix2 (-102)
      * rnd (Rabs x24 + Rabs (cz p))))) + rnd (bpow radix2 (-52) * Rabs x27)) in
  let x29 := rnd (x25 + rnd (x27 - x28)) in
  let x30 := Rabs x2 in
  let x31 := Rabs x12 in
  let x32 := Rabs x21 in
  let x33 := Rabs x29 in
  Once_point x2 (if x5 then rnd (cx centro + 0) else if x6 then rnd (cx p + 0) else x12) (if x14 then rnd (cy centro +
      0) else if x15 then rnd (cy p + 0) else x21) (if x22 then rnd (cz centro + 0) else if x23 then rnd (cz p + 0) else
      x29) (andb (andb (andb (andb (andb (Req_bool x2 (rnd (hi t + rnd (lo t + x1)))) (Rlt_bool (bpow radix2 (-900))
      x30)) (Rlt_bool x30 (bpow radix2 900))) (orb x5 (orb x6 (andb (andb (Req_bool x12 (rnd (x8 + rnd (x10 + x11))))
      (Rlt_bool (bpow radix2 (-900)) x31)) (Rlt_bool x31 (bpow radix2 900)))))) (orb x14 (orb x15 (andb (andb (Req_bool
      x21 (rnd (x17 + rnd (x19 + x20)))) (Rlt_bool (bpow radix2 (-900)) x32)) (Rlt_bool x32 (bpow radix2 900)))))) (orb
      x22 (orb x23 (andb (andb (Req_bool x29 (rnd (x25 + rnd (x27 + x28)))) (Rlt_bool (bpow radix2 (-900)) x33))
      (Rlt_bool x33 (bpow radix2 900)))))).

Definition round_disco (p v : vec) (t : twofold) (error : R) (centro : vec) (radio : R) (vector : vec) : once_point :=
  round_plano p v t error centro vector.

Definition round_triangulo (p v : vec) (t : twofold) (error : R) (a b c : vec) : once_point :=
  let x1 := rnd (rnd ((4503600077730459 * bpow radix2 (-52)) * error) + rnd (bpow radix2 (-52) * Rabs (lo t))) in
  let x2 := rnd (hi t + rnd (lo t - x1)) in
  let x3 := andb (Req_bool (cx a) (cx b)) (Req_bool (cx a) (cx c)) in
  let x4 := Req_bool (cx v) 0 in
  let x5 := rnd (hi t * cx v) in
  let x6 := rnd (x5 + cx p) in
  let x7 := rnd (x6 - x5) in
  let x8 := rnd (rnd (rnd (x5 - rnd (x6 - x7)) + rnd (cx p - x7)) + rnd (rnd (rnd (hi t * cx v - x5) + rnd (lo t * cx
      v)) + 0)) in
  let x9 := rnd (rnd ((4503600077730459 * bpow radix2 (-52)) * rnd (rnd (Rabs (cx v) * error) + rnd (bpow radix2 (-102)
      * rnd (Rabs x5 + Rabs (cx p))))) + rnd (bpow radix2 (-52) * Rabs x8)) in
  let x10 := rnd (x6 + rnd (x8 - x9)) in
  let x11 := andb (Req_bool (cy a) (cy b)) (Req_bool (cy a) (cy c)) in
  let x12 := Req_bool (cy v) 0 in
  let x13 := rnd (hi t * cy v) in
  let x14 := rnd (x13 + cy p) in
  let x15 := rnd (x14 - x13) in
  let x16 := rnd (rnd (rnd (x13 - rnd (x14 - x15)) + rnd (cy p - x15)) + rnd (rnd (rnd (hi t * cy v - x13) + rnd (lo t *
      cy v)) + 0)) in
  let x17 := rnd (rnd ((4503600077730459 * bpow radix2 (-52)) * rnd (rnd (Rabs (cy v) * error) + rnd (bpow radix2 (-102)
      * rnd (Rabs x13 + Rabs (cy p))))) + rnd (bpow radix2 (-52) * Rabs x16)) in
  let x18 := rnd (x14 + rnd (x16 - x17)) in
  let x19 := andb (Req_bool (cz a) (cz b)) (Req_bool (cz a) (cz c)) in
  let x20 := Req_bool (cz v) 0 in
  let x21 := rnd (hi t * cz v) in
  let x22 := rnd (x21 + cz p) in
  let x23 := rnd (x22 - x21) in
  let x24 := rnd (rnd (rnd (x21 - rnd (x22 - x23)) + rnd (cz p - x23)) + rnd (rnd (rnd (hi t * cz v - x21) + rnd (lo t *
      cz v)) + 0)) in
  let x25 := rnd (rnd ((4503600077730459 * bpow radix2 (-52)) * rnd (rnd (Rabs (cz v) * error) + rnd (bpow radix2 (-102)
      * rnd (Rabs x21 + Rabs (cz p))))) + rnd (bpow radix2 (-52) * Rabs x24)) in
  let x26 := rnd (x22 + rnd (x24 - x25)) in
  let x27 := Rabs x2 in
  let x28 := Rabs x10 in
  let x29 := Rabs x18 in
  let x30 := Rabs x26 in
  Once_point x2 (if x3 then rnd (cx a + 0) else if x4 then rnd (cx p + 0) else x10) (if x11 then rnd (cy a + 0) else if
      x12 then rnd (cy p + 0) else x18) (if x19 then rnd (cz a + 0) else if x20 then rnd (cz p + 0) else x26) (andb
      (andb (andb (andb (andb (Req_bool x2 (rnd (hi t + rnd (lo t + x1)))) (Rlt_bool (bpow radix2 (-900)) x27))
      (Rlt_bool x27 (bpow radix2 900))) (orb x3 (orb x4 (andb (andb (Req_bool x10 (rnd (x6 + rnd (x8 + x9)))) (Rlt_bool
      (bpow radix2 (-900)) x28)) (Rlt_bool x28 (bpow radix2 900)))))) (orb x11 (orb x12 (andb (andb (Req_bool x18 (rnd
      (x14 + rnd (x16 + x17)))) (Rlt_bool (bpow radix2 (-900)) x29)) (Rlt_bool x29 (bpow radix2 900)))))) (orb x19 (orb
      x20 (andb (andb (Req_bool x26 (rnd (x22 + rnd (x24 + x25)))) (Rlt_bool (bpow radix2 (-900)) x30)) (Rlt_bool x30
      (bpow radix2 900)))))).

End Pairs.

(** * Potencia at a point of a ray, in pairs that need not be normalised *)

Module Powers.
Import Pairs.

Definition square (x : twofold) : twofold :=
  let x1 := rnd (hi x * hi x) in
  Twofold x1 (rnd (rnd (hi x * hi x - x1) + rnd (rnd (rnd (2 * hi x) + lo x) * lo x))).

Definition sum (x y : twofold) : twofold :=
  let x1 := rnd (hi x + hi y) in
  let x2 := rnd (x1 - hi x) in
  Twofold x1 (rnd (rnd (rnd (hi x - rnd (x1 - x2)) + rnd (hi y - x2)) + rnd (lo x + lo y))).

Definition difference (x y : twofold) : twofold :=
  let x1 := - hi y in
  let x2 := rnd (hi x + x1) in
  let x3 := rnd (x2 - hi x) in
  Twofold x2 (rnd (rnd (rnd (hi x - rnd (x2 - x3)) + rnd (x1 - x3)) + rnd (lo x + (- lo y)))).

Definition product (x y : twofold) : twofold :=
  let x1 := rnd (hi x * hi y) in
  Twofold x1 (rnd (rnd (hi x * hi y - x1) + rnd (rnd (hi x * lo y) + rnd (lo x * hi y)))).

Definition product_by (x : twofold) (a : R) : twofold :=
  let x1 := rnd (hi x * a) in
  Twofold x1 (rnd (rnd (hi x * a - x1) + rnd (lo x * a))).

Definition esfera (t : R) (p v : vec) (speed : R) (centro : vec) (radio : R) : known twofold :=
  let x1 := two_sum (cx p) (- cx centro) in
  let x2 := two_sum (cy p) (- cy centro) in
  let x3 := two_sum (cz p) (- cz centro) in
  let x4 := rnd (rnd (rnd (rnd (Rabs (hi x1) + Rabs (hi x2)) + Rabs (hi x3)) + rnd (Rabs t * speed)) + radio) in
  Known (difference (sum (sum (square (sum x1 (two_prod t (cx v)))) (square (sum x2 (two_prod t (cy v))))) (square (sum
      x3 (two_prod t (cz v))))) (two_prod radio radio)) (rnd (rnd (bpow radix2 (-95) * x4) * x4)).

Definition cilindro (t : R) (p v : vec) (speed : R) (centro : vec) (radio : R) (vector : vec) (altura : R) : known
    twofold :=
  let x1 := two_sum (cx p) (- cx centro) in
  let x2 := sum x1 (two_prod t (cx v)) in
  let x3 := two_sum (cy p) (- cy centro) in
  let x4 := sum x3 (two_prod t (cy v)) in
  let x5 := two_sum (cz p) (- cz centro) in
  let x6 := sum x5 (two_prod t (cz v)) in
  let x7 := sum (sum (product_by x2 (cx vector)) (product_by x4 (cy vector))) (product_by x6 (cz vector)) in
  let x8 := difference (sum (sum (square x2) (square x4)) (square x6)) (square x7) in
  let x9 := sum (sum (two_prod (cx vector) (cx vector)) (two_prod (cy vector) (cy vector))) (two_prod (cz vector) (cz
      vector)) in
  let x10 := hi x7 in
  let x11 := rnd (rnd (rnd (rnd (Rabs (hi x1) + Rabs (hi x3)) + Rabs (hi x5)) + rnd (Rabs t * speed)) + radio) in
  Known (difference (Twofold (hi x8) (rnd (lo x8 + rnd (rnd (rnd (hi x9 - 1) + lo x9) * rnd (x10 * x10))))) (two_prod
      radio radio)) (rnd (rnd (bpow radix2 (-95) * x11) * x11)).

Definition cono (t : R) (p v : vec) (speed : R) (centro : vec) (proporcion : R) (vector : vec) (altura : R) : known
    twofold :=
  let x1 := two_sum (cx p) (- cx centro) in
  let x2 := sum x1 (two_prod t (cx v)) in
  let x3 := two_sum (cy p) (- cy centro) in
  let x4 := sum x3 (two_prod t (cy v)) in
  let x5 := two_sum (cz p) (- cz centro) in
  let x6 := sum x5 (two_prod t (cz v)) in
  let x7 := sum (sum (product_by x2 (cx vector)) (product_by x4 (cy vector))) (product_by x6 (cz vector)) in
  let x8 := difference (sum (sum (square x2) (square x4)) (square x6)) (square x7) in
  let x9 := sum (sum (two_prod (cx vector) (cx vector)) (two_prod (cy vector) (cy vector))) (two_prod (cz vector) (cz
      vector)) in
  let x10 := hi x7 in
  let x11 := rnd (rnd (rnd (rnd (Rabs (hi x1) + Rabs (hi x3)) + Rabs (hi x5)) + rnd (Rabs t * speed)) + altura) in
  Known (difference (Twofold (hi x8) (rnd (lo x8 + rnd (rnd (rnd (hi x9 - 1) + lo x9) * rnd (x10 * x10))))) (square
      (product_by (difference (Twofold altura 0) x7) proporcion))) (rnd (rnd (rnd (bpow radix2 (-95) * rnd (1 + rnd
      (proporcion * proporcion))) * x11) * x11)).

Definition tronco (t : R) (p v : vec) (speed : R) (centro : vec) (radio : R) (proporcion : R) (vector : vec) (altura :
    R) : known twofold :=
  let x1 := two_sum (cx p) (- cx centro) in
  let x2 := sum x1 (two_prod t (cx v)) in
  let x3 := two_sum (cy p) (- cy centro) in
  let x4 := sum x3 (two_prod t (cy v)) in
  let x5 := two_sum (cz p) (- cz centro) in
  let x6 := sum x5 (two_prod t (cz v)) in
  let x7 := sum (sum (product_by x2 (cx vector)) (product_by x4 (cy vector))) (product_by x6 (cz vector)) in
  let x8 := difference (sum (sum (square x2) (square x4)) (square x6)) (square x7) in
  let x9 := sum (sum (two_prod (cx vector) (cx vector)) (two_prod (cy vector) (cy vector))) (two_prod (cz vector) (cz
      vector)) in
  let x10 := hi x7 in
  let x11 := rnd (rnd (rnd (rnd (rnd (Rabs (hi x1) + Rabs (hi x3)) + Rabs (hi x5)) + rnd (Rabs t * speed)) + altura) +
      radio) in
  Known (difference (Twofold (hi x8) (rnd (lo x8 + rnd (rnd (rnd (hi x9 - 1) + lo x9) * rnd (x10 * x10))))) (square (sum
      (product_by (difference (Twofold altura 0) x7) proporcion) (Twofold radio 0)))) (rnd (rnd (rnd (bpow radix2 (-95)
      * rnd (1 + rnd (proporcion * proporcion))) * x11) * x11)).

Definition plano (t : R) (p v : vec) (speed : R) (centro : vec) (vector : vec) : known twofold :=
  let x1 := two_sum (cx p) (- cx centro) in
  let x2 := two_sum (cy p) (- cy centro) in
  let x3 := two_sum (cz p) (- cz centro) in
  Known (sum (sum (product_by (sum x1 (two_prod t (cx v))) (cx vector)) (product_by (sum x2 (two_prod t (cy v))) (cy
      vector))) (product_by (sum x3 (two_prod t (cz v))) (cz vector))) (rnd (bpow radix2 (-95) * rnd (rnd (rnd (Rabs (hi
      x1) + Rabs (hi x2)) + Rabs (hi x3)) + rnd (Rabs t * speed)))).

Definition disco (t : R) (p v : vec) (speed : R) (centro : vec) (radio : R) (vector : vec) : known twofold :=
  plano t p v speed centro vector.

Definition triangulo (t : R) (p v : vec) (speed : R) (a b c : vec) : known twofold :=
  let x1 := - cx a in
  let x2 := two_sum (cx p) x1 in
  let x3 := - cy a in
  let x4 := two_sum (cy b) x3 in
  let x5 := - cz a in
  let x6 := two_sum (cz c) x5 in
  let x7 := two_sum (cz b) x5 in
  let x8 := two_sum (cy c) x3 in
  let x9 := two_sum (cy p) x3 in
  let x10 := two_sum (cx c) x1 in
  let x11 := two_sum (cx b) x1 in
  let x12 := two_sum (cz p) x5 in
  Known (sum (sum (product (sum x2 (two_prod t (cx v))) (difference (product x4 x6) (product x7 x8))) (product (sum x9
      (two_prod t (cy v))) (difference (product x7 x10) (product x11 x6)))) (product (sum x12 (two_prod t (cz v)))
      (difference (product x11 x8) (product x4 x10)))) (rnd (rnd (rnd (bpow radix2 (-95) * rnd (rnd (rnd (Rabs (hi x2) +
      Rabs (hi x9)) + Rabs (hi x12)) + rnd (Rabs t * speed))) * rnd (rnd (Rabs (hi x11) + Rabs (hi x4)) + Rabs (hi x7)))
      * rnd (rnd (Rabs (hi x10) + Rabs (hi x8)) + Rabs (hi x6)))).

Definition launched (there here : known twofold) : known twofold :=
  Known (difference (value there) (value here)) (rnd (error there + rnd (2 * error here))).

End Powers.
