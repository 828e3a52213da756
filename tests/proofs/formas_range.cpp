/// The part of proofs/Formas.v about range.hpp: the speed of a ray, and whether its numbers and those of an element are
/// in range.
#include "proofs/written.hpp"
#include "trace/range.hpp"

namespace durero::trace {
namespace HWY_NAMESPACE {
namespace {

/// Two terms side by side, as DoublePairs has two numbers.
struct TermPairs {
  struct Truths {
    Condition first, second;

    friend Truths operator&(Truths a, Truths b) { return {a.first & b.first, a.second & b.second}; }
    friend Truths operator|(Truths a, Truths b) { return {a.first | b.first, a.second | b.second}; }
  };
  struct Pair {
    Term first, second;

    friend Truths operator>=(Pair a, double b) { return {a.first >= b, a.second >= b}; }
    friend Truths operator<=(Pair a, double b) { return {a.first <= b, a.second <= b}; }
    friend Truths operator==(Pair a, double b) { return {a.first == b, a.second == b}; }
  };

  static Pair magnitudes(Pair x) { return {abs(x.first), abs(x.second)}; }
  static Condition both(Truths truths) { return truths.first & truths.second; }
};

/// The same, by the name of what is asked of each.
struct NamedPairs : TermPairs {};

/// What a shape is stored as, by its names.
Term named(std::string_view word, double) { return real(std::string(word)); }
Vec<Term> named(std::string_view word, const glm::dvec3&) { return vector(std::string(word)); }
std::array<Vec<Term>, 3> named(std::string_view, const scene::Corners&) {
  return {vector("a"), vector("b"), vector("c")};
}

}  // namespace
}  // namespace HWY_NAMESPACE

/// Recorded by itself, of each of a pair: in_range.
template <>
inline HWY_NAMESPACE::TermPairs::Truths pair_in_range<HWY_NAMESPACE::NamedPairs>(HWY_NAMESPACE::TermPairs::Pair x) {
  const auto of = [](HWY_NAMESPACE::Term a) {
    return HWY_NAMESPACE::Condition({"in_range %0", HWY_NAMESPACE::Tightness::application}, {a.node});
  };
  return {of(x.first), of(x.second)};
}

namespace HWY_NAMESPACE {

void write_range() {
  define("How fast a ray is at most, and whether its numbers and those of an element are in range.",
         "speed_of (v : vec) : R", [] {
           return Built{"", {speed_of(vector("v")).node}};
         });
  define("", "in_range (x : R) : bool", [] {
    const Term x = real("x");
    return Built{"", {pair_in_range<TermPairs>({x, x}).first.node}};
  });
  define("", "ray_in_range (p v : vec) : bool", [] {
    return Built{"", {ray_in_range<NamedPairs>(vector("p"), vector("v")).node}};
  });
  scene::for_each_shape([]<class Shape>(std::type_identity<Shape>) {
    define("", std::string(Shape::word) + "_in_range" + attributes<Shape>() + " : bool", [] {
      const bool all = shape_in_range<NamedPairs, Shape>(
          [](const auto& attribute) { return named(attribute.word, Shape().*attribute.field); });
      return Built{all ? "true" : "false", {}};
    });
  });
}

}  // namespace HWY_NAMESPACE
}  // namespace durero::trace
