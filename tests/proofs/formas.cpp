/// Writes proofs/Formas.v: what the templates of the tracer compute, as terms of Coq. It is compiled from the same
/// headers as the tracer, over a number type that records (recorded.hpp).
///   formas >proofs/Formas.v
#include <cstdio>
#include <string>

#include "durero/scene/attributes.hpp"
#include "durero/scene/shapes.hpp"
#include "proofs/written.hpp"
#include "trace/ends.hpp"
#include "trace/rounding-inl.hpp"

namespace durero::trace::HWY_NAMESPACE {
namespace {

constexpr const char* head = R"((** * Formas: the formulas of the tracer, as its C++ templates compute them

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
)";

/// Any quadratic of that kind, its parts by their names.
enum class Kind { free, axial, edged };
template <class T>
BoundedQuadratic<T> any_quadratic(Kind kind) {
  const auto of = [](const char* name) { return variable<T>(std::string(name) + " f"); };
  const auto bound = [](const char* name) { return real(std::string(name) + " f"); };
  BoundedQuadratic<T> f;
  f.A = of("A"), f.B = of("B"), f.C = of("C"), f.F = of("F"), f.H = of("H"), f.s0 = of("s0"), f.s1 = of("s1");
  f.A_error = bound("A_error"), f.B_error = bound("B_error"), f.C_error = bound("C_error");
  f.altura = bound("altura"), f.reach = bound("reach"), f.speed = bound("speed");
  f.margin = bound("margin"), f.margin_error = bound("margin_error");
  f.bounded = kind == Kind::axial, f.edged = kind == Kind::edged;
  return f;
}
std::string suffix(Kind kind) {
  switch (kind) {
    case Kind::free:
      return "";
    case Kind::axial:
      return "_axial";
    case Kind::edged:
      return "_edged";
  }
  __builtin_unreachable();
}

template <class T>
Built of_quadratic(const BoundedQuadratic<T>& f) {
  return {"Quadratic",
          {f.A.node, f.B.node, f.C.node, f.F.node, f.H.node, f.A_error.node, f.B_error.node, f.C_error.node, f.s0.node,
           f.s1.node, f.altura.node, f.reach.node, f.speed.node, f.margin.node, f.margin_error.node},
          {"A", "B", "C", "F", "H", "A_error", "B_error", "C_error", "s0", "s1", "altura", "reach", "speed", "margin",
           "margin_error"}};
}

Built of_lanes(const LanesFound<Term>& found) {
  return {"In_lanes",
          {found.hit.node, found.undecided.node, known(found.root.t, found.root.error),
           known(found.slope, found.slope_error)},
          {"hit", "undecided", "root", "slope"}};
}

template <class T>
Built of_found(const FirstRoot<T>& found) {
  switch (found.verdict) {
    case Decision::miss:
      return {"Miss", {}};
    case Decision::undecided:
      return {"Undecided", {}};
    case Decision::hit:
      return {"Hit",
              {known(found.root.t, found.root.error), known(found.slope, found.slope_error),
               known(found.A, found.A_error)}};
  }
  __builtin_unreachable();
}

/// The quadratic of each shape.
template <class T>
void of_shapes(const std::string& type) {
  scene::for_each_shape([&]<class Shape>(std::type_identity<Shape>) {
    define("", std::string(Shape::word) + " (p v : vec) (speed : R)" + attributes<Shape>() + " : quadratic " + type,
           [&] { return of_quadratic(quadratic<T>(element<Shape::tipo>(), ray())); });
  });
}

/// What the decisions are made of, over T.
template <class T>
void steps(const std::string& type) {
  const auto f = any_quadratic<T>(Kind::free);
  const std::string of_f = " (f : quadratic " + type + ")";
  const std::string result = " : known " + type;
  const Approximation<T> D{variable<T>("value D"), real("error D")};
  const Root<T> root{variable<T>("value t"), real("error t")};
  define("", "root_of_discriminant" + of_f + result, [&] {
    const auto found = root_of_discriminant(f);
    return Built{"Known", {found.value.node, found.error.node}};
  });
  define("", "stable_sum" + of_f + " (D : known " + type + ") : stable " + type, [&] {
    const auto [positive, S, sum] = stable_sum(f, D);
    return Built{"Stable", {positive.node, S.node, known(sum.value, sum.error)}};
  });
  define("", "quotient (x : " + type + ") (x_error : R) (y : " + type + ") (y_error : R)" + result, [&] {
    const auto found = quotient(variable<T>("x"), real("x_error"), variable<T>("y"), real("y_error"));
    return Built{"Known", {found.t.node, found.error.node}};
  });
  define("", "advance" + of_f + " (t : known " + type + ")" + result, [&] {
    const auto found = advance(f, root);
    return Built{"Known", {found.value.node, found.error.node}};
  });
  define("", "beyond (t : known " + type + ") (limit : R) : bool", [&] {
    return Built{"", {beyond(root, real("limit")).node}};
  });
  for (const Kind kind : {Kind::free, Kind::axial, Kind::edged}) {
    define("", "place" + suffix(kind) + of_f + " (t : known " + type + ") : placed", [&] {
      const auto [outside, inside] = place(any_quadratic<T>(kind), root);
      return Built{"Placed", {outside.node, inside.node}};
    });
  }
}

/// The decisions in lanes, whole.
void in_lanes() {
  const auto decision = [](const std::string& name, Kind kind, const auto& decide) {
    define("", name + suffix(kind) + " (f : quadratic R) : in_lanes",
           [&] { return of_lanes(decide(any_quadratic<Term>(kind))); });
  };
  for (const Kind kind : {Kind::free, Kind::axial}) {
    decision("first_in_lanes", kind, [](const auto& f) { return first_in_lanes(f); });
    decision("first_in_lanes_on", kind, [](const auto& f) { return first_from_surface_in_lanes(f); });
  }
  for (const Kind kind : {Kind::free, Kind::edged}) {
    decision("linear_in_lanes", kind, [](const auto& f) { return first_of_linear_in_lanes(f); });
  }
  decision("linear_in_lanes_on", Kind::free, [](const auto& f) { return first_of_linear_from_surface_in_lanes(f); });
}

/// The decisions for one ray, whole.
template <class T>
void for_one_ray(const std::string& type) {
  const auto decision = [&](const std::string& name, Kind kind, const auto& decide) {
    define("", name + suffix(kind) + " (f : quadratic " + type + ") (limit : R) : answer " + type,
           [&] { return of_found(decide(any_quadratic<T>(kind), real("limit"))); });
  };
  for (const Kind kind : {Kind::free, Kind::axial}) {
    decision("first_of_curved", kind, [](const auto& f, Term limit) { return first_of_curved<T>(f, false, limit); });
    decision("first_of_curved_on", kind, [](const auto& f, Term limit) { return first_of_curved<T>(f, true, limit); });
  }
  for (const Kind kind : {Kind::free, Kind::edged}) {
    decision("first_of_linear", kind, [](const auto& f, Term limit) { return first_of_linear<T>(f, false, limit); });
  }
  decision("first_of_linear_on", Kind::free,
           [](const auto& f, Term limit) { return first_of_linear<T>(f, true, limit); });
}

/// Double-double: its operations, over binary64.
void twofold() {
  const Twofold<Term> x = pair_of("x"), y = pair_of("y");
  const Term a = real("a"), b = real("b");
  std::printf("\n(** * Double-double *)\n\nModule Pairs.\n\nRecord twofold := Twofold { hi : R; lo : R }.\n");
  define("", "exactly (a : R) : twofold", [&] { return built_pair(a); });
  define("", "two_sum (a b : R) : twofold", [&] { return built_pair(two_sum(a, b)); });
  define("", "fast_two_sum (a b : R) : twofold", [&] { return built_pair(fast_two_sum(a, b)); });
  define("A product and what it lacks: where the hardware multiplies and subtracts in one, and where not.",
         "two_prod (a b : R) : twofold", [&] { return built_pair(two_prod(a, b)); });
  define("", "two_prod_of_halves (a b : R) : twofold", [&] { return built_pair(two_prod_of_halves(a, b)); });
  define("", "opposite (x : twofold) : twofold", [&] { return built_pair(-x); });
  define("", "sum (x y : twofold) : twofold", [&] { return built_pair(x + y); });
  define("", "difference (x y : twofold) : twofold", [&] { return built_pair(x - y); });
  define("", "product (x y : twofold) : twofold", [&] { return built_pair(x * y); });
  define("", "ratio (x y : twofold) : twofold", [&] { return built_pair(x / y); });
  define("", "root_of (x : twofold) : twofold", [&] { return built_pair(sqrt(x)); });
}

/// The ends around a root, and which root is certainly less.
Built of_ends(const ParameterBounds<Term>& at) { return {"Ends", {at.low.node, at.high.node}}; }
void order() {
  struct Root {
    Term hi, lo, error;
  };
  const Root a{real("hi (value a)"), real("lo (value a)"), real("error a")};
  const Root b{real("hi (value b)"), real("lo (value b)"), real("error b")};
  define("", "ends_of (a : known twofold) : ends", [&] { return of_ends(ends_of_pair(a.hi, a.error)); });
  define("", "certainly_less (a b : known twofold) : bool", [&] { return Built{"", {certainly_less(a, b).node}}; });
}

/// A root improved, and what is rounded once.
void once() {
  const Twofold<Term> t = pair_of("t"), at = pair_of("(value f)");
  const Term p = real("p"), v = real("v"), error = real("error");
  std::printf(
      "\nRecord improved := Improved { known_slope : bool; better : twofold; better_error : R }.\n"
      "Record once := Once { rounded : R; certain : bool }.\n"
      "Record once_point := Once_point { of_t : R; of_x : R; of_y : R; of_z : R; all_certain : bool }.\n");
  define("", "newton (t slope A : known R) (f : known twofold) : improved", [&] {
    const RefinedRoot<Term> found =
        newton<Term>({real("value t"), real("error t")}, {real("value slope"), real("error slope")},
                     {real("value A"), real("error A")}, {at, real("error f")});
    return Built{"Improved", {found.known.node, node_of(found.t), found.error.node}};
  });
  define("", "round_once (t : twofold) (error : R) : once", [&] {
    const RoundedNumber<Term> found = round_once(t, error);
    return Built{"Once", {found.value.node, found.certain.node}};
  });
  define("", "coordinate (p v : R) (t : twofold) (error : R) : known twofold", [&] {
    const Coordinate<Term> found = coordinate(p, v, t, error);
    return Built{"Known", {node_of(found.value), found.error.node}};
  });
  define("", "round_coordinate (p v : R) (t : twofold) (error : R) : once", [&] {
    const RoundedNumber<Term> found = round_coordinate(p, v, t, error);
    return Built{"Once", {found.value.node, found.certain.node}};
  });
  const auto whole = [](const OncePoint<Term>& found) {
    return Built{"Once_point", {found.t.node, found.x.node, found.y.node, found.z.node, found.certain.node}};
  };
  const std::string of_ray = " (p v : vec) (t : twofold) (error : R)", result = " : once_point";
  define("", "round_point" + of_ray + result, [&] { return whole(round_point(ray(), t, error)); });
  scene::for_each_shape([&]<class Shape>(std::type_identity<Shape>) {
    if constexpr (is_linear(Shape::tipo)) {
      define("", "round_" + std::string(Shape::word) + of_ray + attributes<Shape>() + result,
             [&] { return whole(round_point_on(element<Shape::tipo>(), ray(), t, error)); });
    }
  });
}

void write() {
  std::fputs(head, stdout);
  std::printf("\n(** * Binary64 *)\n");
  write_range();
  of_shapes<Term>("R");
  steps<Term>("R");
  in_lanes();
  for_one_ray<Term>("R");
  define("", "ends_of (t : known R) : ends", [] { return of_ends(ends_of(real("value t"), real("error t"))); });
  twofold();
  of_shapes<PairTerm>("twofold");
  steps<PairTerm>("twofold");
  for_one_ray<PairTerm>("twofold");
  order();
  once();
  std::printf("\nEnd Pairs.\n");
  write_powers();
}

}  // namespace
}  // namespace durero::trace::HWY_NAMESPACE

int main() { durero::trace::HWY_NAMESPACE::write(); }
