#pragma once
/// A ray in the numbers that the tracer's steps use, and the range of numbers within which their bounds hold.

#include <cmath>
#include <cstdint>
#include <glm/vec3.hpp>
#include <limits>

#include "durero/model/tipos.hpp"
#include "durero/scene/element_ref.hpp"
#include "durero/scene/shape_view.hpp"

namespace durero::trace {

/// The name of no element.
inline constexpr scene::ElementRef nothing{{}, std::numeric_limits<std::uint32_t>::max()};

/// The numbers of a ray that its tests use.
struct RayNumbers {
  glm::dvec3 p, v;  ///< origin and direction, as stored
  double speed;     ///< V ≥ |v|
};

/// A ray, the quantities that every test of it needs, and the element that it starts on, in one cache line.
struct alignas(64) Ray : RayNumbers {
  /// Makes the ray of the specification's; it starts on nothing.
  explicit Ray(const model::Rayo& rayo) : Ray(rayo.p().xyz(), rayo.v().xyz()) {}
  /// Makes the ray from p along v, which is not 0; it starts on nothing.
  Ray(const glm::dvec3& from, const glm::dvec3& along);

  /// |v|², greater by 60u to 80u (u = 2⁻⁵³).
  double length_squared() const { return (v.x * v.x + v.y * v.y + v.z * v.z) * (1 + 0x1p-47 + 0x1p-50); }
  /// |v|, greater by 30u to 40u.
  double length() const { return std::sqrt(length_squared()); }
  /// 16u·(|p.x| + |p.y| + |p.z|), for the filter (trace/filter.hpp).
  double allowance() const { return 0x1p-49 * (std::abs(p.x) + std::abs(p.y) + std::abs(p.z)); }

  bool ordinary;  ///< every component is 0 or of magnitude 2⁻¹⁰⁰ … 2¹⁰⁰

  /// @{ The element that the ray starts on, by the name that a source of candidates has for it; `nothing` unless told.
  scene::ElementRef start() const { return {start_tipo_, start_index_}; }
  void start_on(scene::ElementRef own) { start_tipo_ = own.tipo, start_index_ = own.index; }
  /// @}

 private:
  // Two members, because together they would not fit into the line.
  model::Tipo start_tipo_ = nothing.tipo;
  std::uint32_t start_index_ = nothing.index;
};
static_assert(sizeof(Ray) == 64);

/// Whether every number of the element is 0 or of magnitude 2⁻¹⁰⁰ … 2¹⁰⁰. The steps' bounds hold then, and nothing
/// overflows or underflows.
bool ordinary(scene::ShapeView element);

}  // namespace durero::trace
