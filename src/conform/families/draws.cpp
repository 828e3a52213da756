#include "conform/families/draws.hpp"

#include <algorithm>
#include <cmath>

namespace durero::conform {
namespace {

/// The nearest binary32 number, ties to even; a cast is defined only where the result is finite.
double rounded_to_binary32(double x) {
  constexpr double rounds_to_infinity = 0x1.ffffffp127;
  if (std::abs(x) >= rounds_to_infinity) return std::copysign(HUGE_VAL, x);
  return static_cast<double>(static_cast<float>(x));
}

/// The kinds of bodies that are asked for.
std::vector<BodyKind> bodies_of(const CaseOptions& options) {
  std::vector<BodyKind> all = options.bodies;
  std::erase(all, BodyKind::campo);
  return all;
}

}  // namespace

bool Draws::allows(model::Tipo tipo) const {
  const std::vector<model::Tipo>& asked = options_.tipos;
  const bool are_all = asked.empty() && options_.bodies.empty();
  return are_all || std::find(asked.begin(), asked.end(), tipo) != asked.end();
}

bool Draws::allows_bodies() const {
  const bool are_all = options_.bodies.empty() && options_.tipos.empty();
  return options_.has_bodies && (are_all || !bodies_of(options_).empty());
}

BodyKind Draws::any_body_kind() {
  return options_.bodies.empty() ? static_cast<BodyKind>(below(body_count)) : any_of(bodies_of(options_));
}

bool Draws::asks_grids() const { return conform::asks_grids(options_.tipos, options_.bodies); }

model::Tipo Draws::any_type_of(const std::vector<model::Tipo>& types) {
  std::vector<model::Tipo> allowed;
  for (const model::Tipo tipo : types) {
    if (allows(tipo)) allowed.push_back(tipo);
  }
  return any_of(allowed.empty() ? types : allowed);
}

double Draws::rounded(double x) const { return is_binary32() ? rounded_to_binary32(x) : x; }

glm::dvec3 Draws::rounded(const glm::dvec3& v) const { return {rounded(v.x), rounded(v.y), rounded(v.z)}; }

scene::Corners Draws::rounded(const scene::Corners& vertices) const {
  return {rounded(vertices[0]), rounded(vertices[1]), rounded(vertices[2])};
}

double Draws::next(double x, double way) const {
  if (!is_binary32()) return std::nextafter(x, way * HUGE_VAL);
  return std::nextafter(static_cast<float>(rounded(x)), static_cast<float>(way) * HUGE_VALF);
}

}  // namespace durero::conform
