#pragma once
/// Profiles drawn at random for right tracers: every clause but the limits on the distance, with sizes and coordinates
/// at, or beside, those of the scene.

#include <cmath>
#include <limits>
#include <set>
#include <vector>

#include "durero/conform/families/suite.hpp"
#include "mover.hpp"

namespace durero::test {

/// A number of some kind, or its neighbour in one of the formats.
inline double near_number(conform::Random& random, double x) {
  const double to = random.sign() * std::numeric_limits<double>::infinity();
  switch (random.below(4)) {
    case 0:
      return x;
    case 1:
      return std::nextafter(x, to);
    case 2:
      return static_cast<double>(std::nextafter(static_cast<float>(x), static_cast<float>(to)));
    default:
      return x * (1 + random.signed_power(-52, -1));
  }
}

/// The sizes and coordinates of the elements.
inline std::vector<double> sizes(const conform::SuiteCase& of) {
  std::vector<double> all;
  for (const conform::NamedBody& body : of.bodies)
    all.insert(all.end(), {longest(body.body), conform::length_of(body.body.sides[0])});
  if (!all.empty()) return all;
  of.the_case.scene.for_each([&](scene::ElementRef, const auto& shape) {
    all.push_back(longest(shape));
    if constexpr (requires { shape.radio; }) all.push_back(shape.radio);
  });
  return all;
}

inline std::vector<model::Tipo> tipos_of(const scene::Scene& scene, bool all) {
  std::set<model::Tipo> tipos;
  for (std::size_t i = 0; i < model::tipo_count && all; ++i) tipos.insert(static_cast<model::Tipo>(i));
  scene.for_each([&](scene::ElementRef e, const auto&) { tipos.insert(e.tipo); });
  return {tipos.begin(), tipos.end()};
}

inline std::vector<conform::BodyKind> bodies_of(const conform::SuiteCase& of, bool all) {
  std::set<conform::BodyKind> kinds;
  for (std::size_t i = 0; i < conform::body_count && all; ++i) kinds.insert(static_cast<conform::BodyKind>(i));
  for (const conform::NamedBody& body : of.bodies) kinds.insert(body.body.kind);
  return {kinds.begin(), kinds.end()};
}

/// Each clause of a profile is drawn, but for the limits on the distance.
inline conform::Profile drawn_profile(conform::Random& random, const conform::SuiteCase& of) {
  const scene::Scene& scene = of.the_case.scene;
  const std::vector<double> lengths = sizes(of);
  conform::Profile profile{.system = "right"};
  profile.format = static_cast<conform::NumberFormat>(random.below(2));
  profile.tipos = tipos_of(scene, random.chance(1, 2));
  profile.bodies = bodies_of(of, random.chance(1, 2));
  profile.caps = random.chance(7, 8) == !of.solids.empty() ? conform::Caps::solid : conform::Caps::open;
  profile.measure = static_cast<conform::Measure>(random.below(3));
  profile.directions = static_cast<conform::Directions>(random.below(3));
  profile.inside = static_cast<conform::Inside>(random.below(4));
  const double length = random.any_of(lengths);
  if (random.chance(1, 4)) profile.error = std::ldexp(1, random.integer(5, 12));
  profile.half_spaces = random.chance(1, 4);
  profile.back_faces = static_cast<conform::BackFaces>(random.chance(1, 4));
  if (random.chance(1, 4)) profile.thickness = std::ldexp(length, -random.integer(8, 40));
  if (random.chance(1, 10)) profile.least_size = near_number(random, random.any_of(lengths));
  if (random.chance(1, 10)) profile.greatest_size = near_number(random, random.any_of(lengths));
  if (random.chance(1, 10)) profile.greatest_coordinate = near_number(random, random.any_of(lengths));
  profile.names_elements = random.chance(5, 6);
  profile.watertight = random.chance(1, 2);
  profile.normal = static_cast<conform::NormalSide>(random.below(conform::normal_words.size()));
  profile.normal_length = static_cast<conform::NormalLength>(random.below(2));
  profile.faces = random.chance(1, 2);
  profile.uv = random.chance(1, 2);
  profile.touching = static_cast<conform::Touching>(random.chance(7, 8));
  return profile;
}

}  // namespace durero::test
