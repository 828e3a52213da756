#include "durero/scene/closing.hpp"

#include <cmath>
#include <utility>

#include "durero/model/operaciones.hpp"
#include "durero/number/rational.hpp"
#include "durero/scene/addition.hpp"

namespace durero::scene {
namespace {

/// a + b·c rounded once, and whether it is that.
struct RoundedSum {
  double value;
  bool exact;
};
RoundedSum sum(double a, double b, double c) {
  const number::Rational sum = number::exact(a) + number::exact(b) * number::exact(c);
  const double value = number::round_to_binary64(sum);
  return {value, std::isfinite(value) && number::exact(value) == sum};
}

class Closed {
 public:
  Closed(const Closing& in, std::optional<std::uint32_t> material) : in_(in), material_(material) {}

  Lids lids(const Cylinder& c) {
    add(in_.base, c.centro, {c.radio, true}, -c.vector);
    return with_top(c, c.radio);
  }
  Lids lids(const Cone& c) {
    add(in_.base, c.centro, sum(0, c.proporcion, c.altura), -c.vector);
    return std::move(lids_);
  }
  Lids lids(const TruncatedCone& c) {
    add(in_.base, c.centro, sum(c.radio, c.proporcion, c.altura), -c.vector);
    return with_top(c, c.radio);
  }
  template <class Other>
  Lids lids(const Other&) {
    return {.violated = &close_pre_2};
  }

 private:
  template <class Shape>
  Lids with_top(const Shape& c, double radio) {
    if (in_.base == in_.top) return {.violated = &close_pre_3};
    glm::dvec3 centro;
    for (int i = 0; i < 3; ++i) {
      const auto [value, exact] = sum(c.centro[i], c.altura, c.vector[i]);
      if (!std::isfinite(value)) return {.violated = &close_pre_4};
      centro[i] = value;
      lids_.exact &= exact;
    }
    add(in_.top, centro, {radio, true}, c.vector);
    return std::move(lids_);
  }
  void add(const std::string& name, const glm::dvec3& centro, const RoundedSum& radio, const glm::dvec3& vector) {
    lids_.exact &= radio.exact;
    lids_.additions.push_back({addition(model::Elemento{name}, Disc{centro, radio.value, vector}), material_});
  }

  const Closing& in_;
  std::optional<std::uint32_t> material_;
  Lids lids_;
};

}  // namespace

Lids lids(const Scene& scene, const Closing& in) {
  const auto element = scene.find(in.e);
  if (!element) return {.violated = &close_pre_1};
  return scene.visit(*element, [&](const auto& shape) { return Closed(in, scene.material(*element)).lids(shape); });
}

}  // namespace durero::scene
