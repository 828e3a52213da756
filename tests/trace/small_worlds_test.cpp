// The closed forms in floating formats so small that every input of a plane can be tried: the same templates that run
// in binary64 and double-double, each verdict held to the exact points. Random samples do not meet the ties, the
// tangents, the rims and the limits that stand here side by side.
//
// An input has two to seven bits of significand and an exponent from −1 to 1. What is computed of it has 12 to 24, or
// is the sum of two numbers of 8 to 14: with fewer, 64ε is no small part of 1 and hardly anything is decided. Bounds
// are binary64, as they are of double-double.
#include <fmt/core.h>

#include <array>
#include <cmath>
#include <string>
#include <tuple>
#include <type_traits>
#include <vector>

#include "durero/model/operaciones.hpp"
#include "durero/surface/exact_element.hpp"
#include "support/catch.hpp"
#include "support/shapes.hpp"
#include "trace/closed_form-inl.hpp"
#include "trace/small.hpp"

using namespace durero;
namespace exact = surface::exact;

namespace {

namespace steps = trace::HWY_NAMESPACE;
using test::Doubled, test::Small;
using trace::Decision;

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
  std::array<std::size_t, 3> of{};  ///< by Decision
  void note(Decision verdict) { ++of[static_cast<std::size_t>(verdict)]; }
  std::size_t at(Decision verdict) const { return of[static_cast<std::size_t>(verdict)]; }
};

/// What is exactly so of a ray and an element.
struct Truth {
  exact::Reach reach;
  bool on;

  bool within(double error, const number::Dyadic& at) const {
    const number::Dyadic off(error);
    return exact::Parameter{at - off} <= reach.first() && reach.first() <= exact::Parameter{at + off};
  }
  bool none_up_to(double limit) const {
    return reach.empty() || (!reach.segment && limit != trace::no_limit && reach.first() > exact::Parameter{limit});
  }
};

/// Whether what a step says is true.
template <class Root>
bool holds(Decision verdict, const Root& root, const Truth& truth, double limit) {
  switch (verdict) {
    case Decision::undecided:
      return true;
    case Decision::miss:
      return truth.none_up_to(limit);
    case Decision::hit:
      return !truth.reach.empty() && !truth.reach.segment && truth.within(root.error, whole(root.t));
  }
  return false;
}

template <class T, class Shape>
bool alone_holds(const Shape& shape, const trace::Ray& ray, const Truth& truth, double limit, Said& said) {
  const auto found = steps::closed_form<T>(shape, ray, truth.on, limit);
  said.note(found.verdict);
  return holds(found.verdict, found.root, truth, limit);
}

/// What a lane says, of rays that do not start on the element.
template <class T, class Shape>
bool in_lanes_holds(const Shape& shape, const trace::Ray& ray, const Truth& truth, Said& said) {
  if (truth.on) return true;
  const auto found = steps::found_in_lanes<Shape::tipo>(steps::quadratic<T>(shape, ray));
  const Decision verdict = found.hit ? Decision::hit : found.undecided ? Decision::undecided : Decision::miss;
  said.note(verdict);
  return holds(verdict, found.root, truth, trace::no_limit);
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

template <int digits>
std::string name(std::type_identity<Small<digits>>) {
  return fmt::format("{} bits", digits);
}
template <int digits>
std::string name(std::type_identity<Doubled<digits>>) {
  return fmt::format("twice {} bits", digits);
}

/// Whether lanes are made of it: not of what is summed of two.
template <class T>
constexpr bool in_lanes = requires { T() > T(); };

/// How often each format decided, over a world.
template <class T>
struct SaidIn : Said {};
template <class... T>
using Counts = std::tuple<SaidIn<T>...>;

template <class T, class Shape>
bool format_holds(const Shape& shape, const trace::Ray& ray, const Truth& truth, double limit, Said& said) {
  if (!alone_holds<T>(shape, ray, truth, limit, said)) return false;
  if constexpr (in_lanes<T>) return in_lanes_holds<T>(shape, ray, truth, said);
  return true;
}

template <class Shape, class... T>
std::size_t wrong_in(const World& world, const Shape& shape, Counts<T...>& said) {
  std::size_t wrong = 0;
  for (const glm::dvec3& p : world.origins)
    for (const glm::dvec3& v : world.directions) {
      const model::Rayo rayo = test::ray(p, v);
      const exact::Coefficients f = exact::coefficients(shape, rayo);
      const bool on = number::sign(f.C) == 0 && exact::within_clip(f, exact::Parameter{});
      const Truth truth{exact::reach(shape, rayo, on), on};
      const trace::Ray ray(rayo);
      for (const double limit : {trace::no_limit, 1.0, 0.5}) {
        if ((format_holds<T>(shape, ray, truth, limit, std::get<SaidIn<T>>(said)) && ...)) continue;
        if (++wrong > 3) continue;
        fmt::print("wrong: p = ({}, {}, {}), v = ({}, {}, {}), limit {}\n", p.x, p.y, p.z, v.x, v.y, v.z, limit);
      }
    }
  return wrong;
}

/// Of 64ε little is lost where ε is 2⁻²⁴.
template <class Shape, class T>
void check_decided(const Said& said) {
  const std::size_t hits = said.at(Decision::hit), misses = said.at(Decision::miss);
  const std::size_t undecided = said.at(Decision::undecided);
  fmt::print("{:17} in {:13}: {:8} hits, {:8} misses, {:8} undecided\n", Shape::Addition::schema,
             name(std::type_identity<T>()), hits, misses, undecided);
  CHECK(hits > 0);
  CHECK(misses > 0);
  if (steps::Numbers<T>::roundoff <= 0x1p-24) CHECK(hits + misses > 2 * undecided);
}

template <class Shape, class... T>
void try_all(const World& world) {
  Counts<T...> said;
  std::size_t wrong = 0;
  for (const Shape& shape : elements<Shape>()) {
    REQUIRE(trace::ordinary(scene::ShapeView(shape)));
    wrong += wrong_in<Shape, T...>(world, shape, said);
  }
  CHECK(wrong == 0);
  (check_decided<Shape, T>(std::get<SaidIn<T>>(said)), ...);
}

void try_every_shape(const World& world) {
  scene::for_each_shape([&]<class Shape>(std::type_identity<Shape>) {
    try_all<Shape, Small<12>, Small<14>, Small<24>, Doubled<8>, Doubled<9>, Doubled<14>>(world);
  });
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

TEST_CASE("A number of two small ones has twice their bits") {
  const Doubled<8> three(3), third = Doubled<8>(1) / three, root = sqrt(three);
  const number::Dyadic one(1), unit(16 * 0x1p-16);
  const auto size = [](const number::Dyadic& a) { return number::sign(a) < 0 ? -a : a; };
  CHECK(size(whole(third) * whole(three) - one) <= unit);
  CHECK(size(number::square(whole(root)) - whole(three)) <= whole(three) * (unit + unit));
  CHECK(whole(Doubled<8>(1) + Doubled<8>(0x1p-12)) == one + number::Dyadic(0x1p-12));
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
