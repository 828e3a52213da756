/// Writes the module Powers of proofs/Formas.v: potencia at a point of a ray, of power-inl.hpp and shape/. Each
/// operation on a sum of two binary64 is named, and recorded by itself.
#include <cstdio>

#include "proofs/written.hpp"
#include "trace/shapes-inl.hpp"

namespace durero::trace::HWY_NAMESPACE {
namespace {

/// A number of which pairs are computed by operations that are named.
struct Named : Term {
  using Term::Term;
  Named() = default;
  Named(Term term) : Term(term) {}
};

/// The pair that an operation computes of others, by its form.
Twofold<Named> pair(const std::string& operation, std::vector<Node> operands) {
  const Node node = record({operation, Tightness::application}, std::move(operands));
  const auto part = [&](const char* of) { return Named(Term({of, Tightness::application}, {node})); };
  return {part("hi %0"), part("lo %0")};
}

}  // namespace

template <>
Twofold<Named> two_sum(Named a, Named b) {
  return pair("two_sum %0 %1", {a.node, b.node});
}
template <>
Twofold<Named> two_prod(Named a, Named b) {
  return pair("two_prod %0 %1", {a.node, b.node});
}
template <>
Twofold<Named> square(const Twofold<Named>& a) {
  return pair("square %0", {node_of(a)});
}
template <>
Twofold<Named> sum(const Twofold<Named>& a, const Twofold<Named>& b) {
  return pair("sum %0 %1", {node_of(a), node_of(b)});
}
template <>
Twofold<Named> difference(const Twofold<Named>& a, const Twofold<Named>& b) {
  return pair("difference %0 %1", {node_of(a), node_of(b)});
}
template <>
Twofold<Named> product(const Twofold<Named>& a, Named b) {
  return pair("product_by %0 %1", {node_of(a), b.node});
}
template <>
Twofold<Named> product(const Twofold<Named>& a, const Twofold<Named>& b) {
  return pair("product %0 %1", {node_of(a), node_of(b)});
}

namespace {

Built of_power(const Power<Named>& f) { return {"Known", {node_of(f.value), f.error.node}}; }
Power<Named> power(const std::string& name) {
  const auto part = [&](const char* of) {
    return Named(Term({of, Tightness::application}, {record(called("value " + name))}));
  };
  return {{part("hi %0"), part("lo %0")}, Named(real("error " + name))};
}

}  // namespace

void write_powers() {
  const Twofold<Term> x = pair_of("x"), y = pair_of("y");
  std::printf("\n(** * Potencia at a point of a ray, in pairs that need not be normalised *)\n");
  std::printf("\nModule Powers.\nImport Pairs.\n");
  define("", "square (x : twofold) : twofold", [&] { return built_pair(square(x)); });
  define("", "sum (x y : twofold) : twofold", [&] { return built_pair(sum(x, y)); });
  define("", "difference (x y : twofold) : twofold", [&] { return built_pair(difference(x, y)); });
  define("", "product (x y : twofold) : twofold", [&] { return built_pair(product(x, y)); });
  define("", "product_by (x : twofold) (a : R) : twofold", [&] { return built_pair(product(x, real("a"))); });
  scene::for_each_shape([&]<class Shape>(std::type_identity<Shape>) {
    define("", std::string(Shape::word) + " (t : R) (p v : vec) (speed : R)" + attributes<Shape>() + " : known twofold",
           [&] { return of_power(power_at(Named(real("t")), element<Shape::tipo, Named>(), ray<Named>())); });
  });
  define("", "launched (there here : known twofold) : known twofold",
         [&] { return of_power(launched(power("there"), power("here"))); });
  std::printf("\nEnd Powers.\n");
}

}  // namespace durero::trace::HWY_NAMESPACE
