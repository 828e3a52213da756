#include "unit.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <map>
#include <type_traits>

#include "durero/scene/attributes.hpp"
#include "durero/surface/exact.hpp"
#include "durero/trace/ray.hpp"

namespace durero::engine {
namespace {

using scene::Scene;

/// Whether the attribute is measured in the unit of length. A direction and a slope are not.
template <class Attribute>
constexpr bool is_length(const Attribute& attribute) {
  using Component = std::remove_const_t<decltype(attribute.component)>;
  if constexpr (std::is_same_v<Component, decltype(&scene::AnyEscena::mi_vector)>) return false;
  if constexpr (std::is_same_v<Component, decltype(&scene::AnyEscena::mi_proporcion)>)
    return attribute.component != &scene::AnyEscena::mi_proporcion;
  return true;
}

template <class Use>
void for_each_number(double& x, Use use) {
  use(x);
}
template <class Use>
void for_each_number(glm::dvec3& x, Use use) {
  use(x.x), use(x.y), use(x.z);
}
template <class Use>
void for_each_number(scene::Corners& x, Use use) {
  for (glm::dvec3& corner : x) for_each_number(corner, use);
}

/// Calls use(number, whether it is a length) for each number of a shape.
template <class Shape, class Use>
void for_each_number_of(Shape& shape, Use use) {
  scene::for_each_attribute<Shape>([&](const auto& attribute) {
    for_each_number(shape.*attribute.field, [&](double& x) { use(x, is_length(attribute)); });
  });
}

/// Multiplies by 2^exponent. Whether the product is exact, and so multiplies back to x.
bool multiply(double& x, int exponent) {
  const double before = x;
  x = std::ldexp(x, exponent);
  return std::isfinite(x) && std::ldexp(x, -exponent) == before;
}
bool multiply(glm::dvec3& x, int exponent) {
  bool exact = true;
  for_each_number(x, [&](double& number) { exact = multiply(number, exponent) && exact; });
  return exact;
}

template <class Shape>
bool multiply_lengths(Shape& shape, int unit) {
  bool exact = true;
  for_each_number_of(shape, [&](double& x, bool length) { exact = (!length || multiply(x, unit)) && exact; });
  return exact;
}

/// The units that make an element ordinary: a range, empty where first > last.
struct Units {
  int first, last;
};
constexpr int range = 100;  // of trace::ordinary, in powers of two

template <class Shape>
Units units_of(Shape shape) {
  Units units{-2 * 1100, 2 * 1100};  // any, where every length is 0
  bool others = true;
  for_each_number_of(shape, [&](double x, bool length) {
    if (x == 0) return;
    const int exponent = std::ilogb(x);  // 2^exponent ≤ |x| < 2^(exponent + 1)
    if (length) {
      units = {std::max(units.first, -range - exponent), std::min(units.last, range - 1 - exponent)};
    } else {
      others = others && -range <= exponent && exponent < range;
    }
  });
  return others ? units : Units{0, -1};
}

/// The number of elements that a unit makes ordinary, as changes: each key holds the difference to the unit before it.
std::map<int, std::int64_t> changes(const Scene& scene) {
  std::map<int, std::int64_t> at;
  scene.for_each([&](scene::ElementRef, const auto& shape) {
    const Units units = units_of(shape);
    if (units.first > units.last) return;
    ++at[units.first], --at[units.last + 1];
  });
  return at;
}

}  // namespace

std::optional<int> unit_of(const Scene& scene) {
  std::int64_t here = 0, best = 0, as_it_is = 0;
  int unit = 0;
  const auto at = changes(scene);
  for (auto change = at.begin(); change != at.end(); ++change) {
    here += change->second;
    const auto next = std::next(change);
    if (next == at.end()) break;
    if (change->first <= 0 && 0 < next->first) as_it_is = here;
    if (here > best) best = here, unit = (change->first + next->first - 1) / 2;
  }
  if (best == as_it_is) return {};
  const bool inexact = scene.any_of([&](scene::ElementRef, auto shape) { return !multiply_lengths(shape, unit); });
  return inexact ? std::nullopt : std::optional(unit);
}

Scene in_unit(const Scene& scene, int unit) {
  Scene scaled;
  scaled.put_off_audits();
  scene.for_each([&](scene::ElementRef e, auto shape) {
    multiply_lengths(shape, unit);
    scaled.add(scene.name(e), shape);
  });
  return scaled;
}

std::optional<RayInUnit> in_unit(const model::Rayo& rayo, int unit) {
  glm::dvec3 p = rayo.p().xyz(), v = rayo.v().xyz();
  const double greatest = std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
  const int exponent = std::ilogb(greatest), of_direction = std::abs(exponent) < range / 2 ? 0 : -exponent;
  if (!multiply(p, unit) || !multiply(v, of_direction)) return {};
  // p·2^unit + t'·v·2^of_direction = (p + t·v)·2^unit
  return RayInUnit{{model::Punto(p), model::Vector(v)}, of_direction - unit};
}

std::optional<model::Rayo> segment_in_unit(const model::Rayo& rayo, int unit) {
  glm::dvec3 p = rayo.p().xyz(), v = rayo.v().xyz();
  if (!multiply(p, unit) || !multiply(v, unit)) return {};
  return model::Rayo{model::Punto(p), model::Vector(v)};
}

scene::Hit out_of_unit(const Scene& scene, const scene::Query& query, scene::Hit hit, int unit, int of_parameter) {
  if (hit.resultado != model::Resultado::hit) return hit;
  const glm::dvec3 &p = query.rayo.p().xyz(), &v = query.rayo.v().xyz();
  bool exact = true;
  const auto multiply_back = [&](double& x, int exponent) {
    // A result of the least normal magnitude may have been rounded from a subnormal.
    const bool of_all_bits = std::isfinite(x) && std::abs(x) > std::numeric_limits<double>::min();
    x = std::ldexp(x, exponent);
    exact = exact && of_all_bits && std::isnormal(x);
  };
  multiply_back(hit.t, of_parameter);
  for (int i = 0; i < 3; ++i)
    if (p[i] != 0 || v[i] != 0) multiply_back(hit.punto[i], -unit);  // else it is 0 in each unit
  if (exact) return hit;
  const auto reach = surface::exact::reach(scene, hit.elementos[0], query.rayo, query.en);
  return surface::exact::rounded_hit(query.rayo, reach.first(), std::move(hit.elementos));
}

}  // namespace durero::engine
