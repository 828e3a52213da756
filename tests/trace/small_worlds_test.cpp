// The closed forms in floating formats so small that every input of a plane can be tried: the same templates that run
// in binary64 and double-double, each verdict held to the exact points. Random samples do not meet the ties, the
// tangents, the rims and the limits that stand here side by side.
//
// An input has two to seven bits of significand and an exponent from −1 to 1. What is computed of it has 12 to 24: with
// fewer, 64ε is no small part of 1 and hardly anything is decided. Bounds are binary64, as they are of double-double.
#include <fmt/core.h>

#include <array>
#include <bit>
#include <cmath>
#include <map>
#include <vector>

#include "durero/model/operaciones.hpp"
#include "durero/surface/exact_element.hpp"
#include "support/catch.hpp"
#include "support/shapes.hpp"
#include "trace/closed_form-inl.hpp"

using namespace durero;
namespace exact = surface::exact;

namespace {

/// A number of so many bits of significand, and of any exponent. Each operation is binary64's, rounded to these bits:
/// that is their own correct rounding, as 53 ≥ 2·24 + 2 (Figueroa, 1995).
template <int digits>
struct Small {
  static_assert(53 >= 2 * digits + 2);
  double value = 0;

  Small() = default;
  Small(double x) : value(rounded(x)) {}

  // To nearest, ties to even: adding the half below the last bit kept carries into it where that is right.
  static double rounded(double x) {
    if (x == 0 || !std::isfinite(x)) return x;
    constexpr int dropped = 53 - digits;
    const auto bits = std::bit_cast<std::uint64_t>(x);
    const std::uint64_t even = bits >> dropped & 1, below = (std::uint64_t{1} << (dropped - 1)) - 1;
    return std::bit_cast<double>((bits + below + even) >> dropped << dropped);
  }

  friend Small operator+(Small a, Small b) { return a.value + b.value; }
  friend Small operator-(Small a, Small b) { return a.value - b.value; }
  friend Small operator*(Small a, Small b) { return a.value * b.value; }
  friend Small operator/(Small a, Small b) { return a.value / b.value; }
  friend Small operator-(Small a) { return -a.value; }
  friend Small sqrt(Small a) { return std::sqrt(a.value); }
  friend Small abs(Small a) { return std::abs(a.value); }
  friend bool operator<(Small a, Small b) { return a.value < b.value; }
  friend bool operator>(Small a, Small b) { return a.value > b.value; }
};

}  // namespace

namespace durero::trace::HWY_NAMESPACE {

template <int digits>
struct Numbers<Small<digits>> {
  using Bound = double;
  static constexpr double roundoff = 1.0 / (1 << digits);
  static double leading(Small<digits> a) { return a.value; }
  static Small<digits> difference(double a, double b) { return a - b; }
};

}  // namespace durero::trace::HWY_NAMESPACE

namespace {

namespace steps = trace::HWY_NAMESPACE;
using trace::Verdict;

/// 0 and every ±m·2^e of so many bits, 1/2 ≤ |x| < 4.
std::vector<double> numbers(int bits) {
  std::vector<double> all{0};
  for (int e = -1; e <= 1; ++e)
    for (int m = 1 << (bits - 1); m < 1 << bits; ++m)
      for (const int sign : {1, -1}) all.push_back(sign * std::ldexp(m, e - bits + 1));
  return all;
}

/// How often a step said what.
struct Said {
  std::array<std::size_t, 3> of{};  ///< by Verdict
  void note(Verdict verdict) { ++of[static_cast<std::size_t>(verdict)]; }
  std::size_t at(Verdict verdict) const { return of[static_cast<std::size_t>(verdict)]; }
};

/// What is exactly so of a ray and an element.
struct Truth {
  exact::Reach reach;
  bool on;

  bool within(double error, double t) const {
    const number::Dyadic at(t), off(error);
    return exact::Parameter{at - off} <= reach.first() && reach.first() <= exact::Parameter{at + off};
  }
  bool none_up_to(double limit) const {
    return reach.empty() || (!reach.segment && limit != trace::no_limit && reach.first() > exact::Parameter{limit});
  }
};

/// Whether what a step says is true.
bool holds(Verdict verdict, double t, double error, const Truth& truth, double limit) {
  switch (verdict) {
    case Verdict::undecided:
      return true;
    case Verdict::miss:
      return truth.none_up_to(limit);
    case Verdict::hit:
      return !truth.reach.empty() && !truth.reach.segment && truth.within(error, t);
  }
  return false;
}

template <int digits, class Shape>
bool alone_holds(const Shape& shape, const trace::Ray& ray, const Truth& truth, double limit, Said& said) {
  const auto found = steps::closed_form<Small<digits>>(shape, ray, truth.on, limit);
  said.note(found.verdict);
  return holds(found.verdict, found.root.t.value, found.root.error, truth, limit);
}

/// What a lane says, of rays that do not start on the element.
template <int digits, class Shape>
bool in_lanes_holds(const Shape& shape, const trace::Ray& ray, const Truth& truth, Said& said) {
  if (truth.on) return true;
  const auto found = steps::found_in_lanes<Shape::tipo>(steps::quadratic<Small<digits>>(shape, ray));
  const Verdict verdict = found.hit ? Verdict::hit : found.undecided ? Verdict::undecided : Verdict::miss;
  said.note(verdict);
  return holds(verdict, found.root.t.value, found.root.error, truth, trace::no_limit);
}

/// The elements of the worlds: rays in the plane z = 0 or z = 1/2 see each from the side, along its axis, or edge on.
template <class Shape>
std::vector<Shape> elements();
constexpr glm::dvec3 o{0}, up{0, 1, 0}, out{0, 0, 1};
template <>
std::vector<scene::Sphere> elements() {
  return {{o, 1}, {{1, 0.5, 0}, 1.5}};
}
template <>
std::vector<scene::Cylinder> elements() {
  return {{o, 1, up, 1.5}, {{0.5, 0, -1}, 1.5, out, 1.5}};
}
template <>
std::vector<scene::Cone> elements() {
  return {{o, 1, up, 2}, {{0.5, 0, -1}, 0.5, out, 3}};
}
template <>
std::vector<scene::TruncatedCone> elements() {
  return {{o, 1, 0.5, up, 1}, {{0, 0.5, -1}, 0.5, 1, out, 1.5}};
}
template <>
std::vector<scene::Plane> elements() {
  return {{o, up}, {{0.5, 0, 0}, {1, 0, 0}}};
}
template <>
std::vector<scene::Disc> elements() {
  return {{o, 1, up}, {{0.5, 1, 0}, 2, {1, 0, 0}}};
}
template <>
std::vector<scene::Triangle> elements() {
  using scene::Corners, scene::Triangle;
  return {Triangle{Corners{{{-1, 0, -1}, {2, 0, -1}, {0, 1, 1}}}},
          Triangle{Corners{{{0.5, -1, -1}, {0.5, 2, 0}, {0.5, -1, 1}}}}};
}

/// Origins, and the directions to take from each.
struct World {
  std::vector<glm::dvec3> origins, directions;
};

/// Every origin with coordinates of so many bits in a plane z = const.
std::vector<glm::dvec3> plane(int bits, double z) {
  std::vector<glm::dvec3> all;
  for (const double x : numbers(bits))
    for (const double y : numbers(bits)) all.push_back({x, y, z});
  return all;
}

/// Rays in planes: every direction there of so many bits. Most of what is computed of them is exact, so that tangents,
/// rims and limits are met as they are.
World flat(int bits, double z) {
  World world{plane(bits, z), plane(bits, 0)};
  std::erase(world.directions, o);
  return world;
}

/// Rays out of a plane, in directions of five bits: nothing computed of them is exact in twelve.
World oblique(int bits) {
  World world{plane(bits, 0.8125), {}};
  for (const glm::dvec3 v : {glm::dvec3{21, -13, 19}, {-17, 29, 23}, {31, 11, -25}, {-27, -15, -29}})
    for (int turn = 0; turn < 3; ++turn)
      world.directions.push_back(glm::dvec3(v[turn], v[(turn + 1) % 3], v[(turn + 2) % 3]) / 16.0);
  return world;
}

/// How often each format decided, over a world.
using Counts = std::map<int, Said>;

template <class Shape, int... digits>
std::size_t wrong_in(const World& world, const Shape& shape, Counts& said) {
  std::size_t wrong = 0;
  for (const glm::dvec3& p : world.origins)
    for (const glm::dvec3& v : world.directions) {
      const model::Rayo rayo = test::ray(p, v);
      const exact::Coefficients f = exact::coefficients(shape, rayo);
      const bool on = number::sign(f.C) == 0 && exact::within_clip(f, exact::Parameter{});
      const Truth truth{exact::reach(shape, rayo, on), on};
      const trace::Ray ray(rayo);
      for (const double limit : {trace::no_limit, 1.0, 0.5}) {
        const bool alone = (alone_holds<digits>(shape, ray, truth, limit, said[digits]) && ...);
        const bool in_lanes = (in_lanes_holds<digits>(shape, ray, truth, said[digits]) && ...);
        if (alone && in_lanes) continue;
        if (++wrong > 3) continue;
        fmt::print("wrong: p = ({}, {}, {}), v = ({}, {}, {}), limit {}\n", p.x, p.y, p.z, v.x, v.y, v.z, limit);
      }
    }
  return wrong;
}

template <class Shape, int... digits>
void try_all(const World& world) {
  Counts said;
  std::size_t wrong = 0;
  for (const Shape& shape : elements<Shape>()) {
    REQUIRE(trace::ordinary(scene::ShapeView(shape)));
    wrong += wrong_in<Shape, digits...>(world, shape, said);
  }
  CHECK(wrong == 0);
  for (const auto& [of, counts] : said) {
    const std::size_t hits = counts.at(Verdict::hit), misses = counts.at(Verdict::miss);
    const std::size_t undecided = counts.at(Verdict::undecided);
    fmt::print("{:17} in {} bits: {:8} hits, {:8} misses, {:8} undecided\n", Shape::Addition::schema, of, hits, misses,
               undecided);
    CHECK(hits > 0);
    CHECK(misses > 0);
    if (of == 24) CHECK(hits + misses > 2 * undecided);
  }
}

void try_every_shape(const World& world) {
  scene::for_each_shape([&]<class Shape>(std::type_identity<Shape>) { try_all<Shape, 12, 14, 24>(world); });
}

}  // namespace

TEST_CASE("Small numbers are rounded to nearest, ties to even") {
  using Four = Small<4>;
  CHECK(Four(1 + 0x1p-4).value == 1);
  CHECK(Four(1 + 3 * 0x1p-4).value == 1 + 0x1p-2);
  CHECK(Four(-(1 + 0x1p-4 + 0x1p-52)).value == -(1 + 0x1p-3));
  CHECK(Four(2 - 0x1p-4).value == 2);
  CHECK((Four(1) / Four(3)).value == 0x1.6p-2);
  CHECK(sqrt(Four(2)).value == 1.375);
}

TEST_CASE("What the closed forms decide is so of every flat ray of two bits") {
  try_every_shape(flat(2, 0));
  try_every_shape(flat(2, 0.5));
}

TEST_CASE("What the closed forms decide is so of oblique rays from every origin of four bits") {
  try_every_shape(oblique(4));
}

TEST_CASE("The same of flat rays of three bits, and of oblique ones from origins of seven", "[long]") {
  try_every_shape(flat(3, 0.5));
  try_every_shape(oblique(7));
}
