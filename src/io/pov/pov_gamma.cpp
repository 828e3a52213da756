#include "pov_gamma.hpp"

#include <algorithm>
#include <cmath>

#include "durero/scene/srgb.hpp"
#include "durero/scene/stage.hpp"

namespace durero::io {
namespace {

/// Replaces numbers, and counts.
class ColorLinearizer {
 public:
  explicit ColorLinearizer(const PovGamma& gamma) : gamma_(gamma) {}

  std::optional<std::size_t> changed() const { return is_finite_ ? std::optional(changed_) : std::nullopt; }

  void make(double& share) {
    const double light = gamma_.light(share);
    count(light != share, std::isfinite(light));
    share = light;
  }
  void make(glm::dvec3& color) {
    const glm::dvec3 light(gamma_.light(color.x), gamma_.light(color.y), gamma_.light(color.z));
    count(light != color, std::isfinite(light.x) && std::isfinite(light.y) && std::isfinite(light.z));
    color = light;
  }
  void make(scene::Material& m) {
    for (double* const share : {&m.k_a, &m.k_d, &m.k_s, &m.k_t}) make(*share);
    for (glm::dvec3* const color : {&m.color, &m.M_T, &m.emission, &m.ambient}) make(*color);
    if (m.k_ps == 0) return;
    glm::dvec3 mirror = m.k_ps * m.M_PS;  // the language has one colour for both
    make(mirror);
    m.k_ps = std::max({mirror.x, mirror.y, mirror.z});
    m.M_PS = m.k_ps == 0 ? glm::dvec3(1) : mirror / m.k_ps;
  }

 private:
  void count(bool is_changed, bool is_finite) {
    if (is_changed) ++changed_;
    is_finite_ &= is_finite;
  }

  const PovGamma& gamma_;
  std::size_t changed_ = 0;
  bool is_finite_ = true;
};

}  // namespace

double PovGamma::light(double number) const {
  if (power) return *power == 1 ? number : std::pow(number, *power);
  return scene::linear_of_srgb(number);
}

PovGamma default_gamma(std::optional<double> version) {
  return version && *version >= 3.7 ? PovGamma{.power = 1} : PovGamma{};
}

std::optional<std::size_t> make_linear(const PovGamma& gamma, scene::Stage& stage) {
  ColorLinearizer linear(gamma);
  if (stage.background) linear.make(*stage.background);
  if (stage.environment)
    for (glm::dvec3& color : stage.environment->colors) linear.make(color);
  for (scene::Light& light : stage.lights) linear.make(light.color);
  for (scene::DirectionalLight& light : stage.directional_lights) linear.make(light.color);
  for (scene::Material& material : stage.materials) linear.make(material);
  for (scene::Texture& texture : stage.textures)
    for (glm::dvec3& color : texture.colors) linear.make(color);
  return linear.changed();
}

}  // namespace durero::io
