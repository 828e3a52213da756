#include <algorithm>
#include <cmath>

#include "durero/trace/closed_form-inl.hpp"
#include "durero/trace/steps.hpp"

namespace durero::trace {
namespace {

/// Every number is 0 or of magnitude 2⁻¹⁰⁰ … 2¹⁰⁰; without branches, as it runs for every ray.
template <class... Numbers>
bool in_range(Numbers... numbers) {
  const auto within = [](double x) {
    const double size = std::abs(x);
    return (size >= 0x1p-100 && size <= 0x1p100) | (size == 0);
  };
  return (within(numbers) & ...);
}

double extent(const glm::dvec3& x) { return std::abs(x.x) + std::abs(x.y) + std::abs(x.z); }

}  // namespace

Counts& Counts::operator+=(const Counts& other) {
  for (std::size_t step = 0; step < element.size(); ++step) {
    element[step] += other.element[step];
    order[step] += other.order[step];
    rounding[step] += other.rounding[step];
  }
  return *this;
}

Beam::Beam(const model::Rayo& rayo)
    : p(rayo.p().xyz()),
      v(rayo.v().xyz()),
      speed(extent(v)),
      length_squared((v.x * v.x + v.y * v.y + v.z * v.z) * (1 + 0x1p-47 + 0x1p-50)),
      length(std::sqrt(length_squared)),
      allowance(0x1p-49 * extent(p)),
      ordinary(in_range(p.x, p.y, p.z, v.x, v.y, v.z)) {}

bool ordinary(const scene::Sphere& e) noexcept { return in_range(e.centro.x, e.centro.y, e.centro.z, e.radio); }
bool ordinary(const scene::Cylinder& e) noexcept {
  return in_range(e.centro.x, e.centro.y, e.centro.z, e.radio, e.vector.x, e.vector.y, e.vector.z, e.altura);
}
bool ordinary(const scene::Cone& e) noexcept {
  return in_range(e.centro.x, e.centro.y, e.centro.z, e.proporcion, e.vector.x, e.vector.y, e.vector.z, e.altura);
}

Finding triage(const scene::Sphere& sphere, const Beam& beam, bool on, double limit) {
  return HWY_NAMESPACE::published(HWY_NAMESPACE::closed_form<double>(sphere, beam, on, limit));
}
Finding triage(const scene::Cylinder& cylinder, const Beam& beam, bool on, double limit) {
  return HWY_NAMESPACE::published(HWY_NAMESPACE::closed_form<double>(cylinder, beam, on, limit));
}
Finding triage(const scene::Cone& cone, const Beam& beam, bool on, double limit) {
  return HWY_NAMESPACE::published(HWY_NAMESPACE::closed_form<double>(cone, beam, on, limit));
}

}  // namespace durero::trace
