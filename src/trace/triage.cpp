#include <algorithm>
#include <cmath>

#include "durero/trace/closed_form-inl.hpp"
#include "durero/trace/steps.hpp"

namespace durero::trace {
namespace {

bool in_range(double x) { return x == 0 || (std::abs(x) >= 0x1p-100 && std::abs(x) <= 0x1p100); }
bool in_range(const glm::dvec3& x) { return in_range(x.x) && in_range(x.y) && in_range(x.z); }

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
      speed(std::abs(v.x) + std::abs(v.y) + std::abs(v.z)),
      length_squared((v.x * v.x + v.y * v.y + v.z * v.z) * (1 + 0x1p-47 + 0x1p-50)),
      length(std::sqrt(length_squared)),
      ordinary(in_range(p) && in_range(v)) {}

bool ordinary(const scene::Sphere& e) noexcept { return in_range(e.centro) && in_range(e.radio); }
bool ordinary(const scene::Cylinder& e) noexcept {
  return in_range(e.centro) && in_range(e.vector) && in_range(e.radio) && in_range(e.altura);
}
bool ordinary(const scene::Cone& e) noexcept {
  return in_range(e.centro) && in_range(e.vector) && in_range(e.proporcion) && in_range(e.altura);
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
