#pragma once
/// Scattering: how a surface sends light on, as a mixture of lobes, of which a path follows one.

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "encounter.hpp"

namespace durero::render {

/// The lobes of a surface at a meeting, each with its colour and with its chance of being followed. The even part and
/// the highlight are those of the local model, whose light of the brightness S has the irradiance πS; k_a and ambient,
/// which stand there for light that came by way of other things, are not part of it.
class Scattering {
 public:
  /// The lobes there. `through` is the refracted direction, where there is one: else its share goes the mirrored way.
  Scattering(const Encounter& at, bool goes_through);

  /// Whether anything is sent on.
  bool is_black() const { return sum_ == 0; }
  /// Whether some lobe has a density, so that light from any direction counts.
  bool is_smooth() const { return even_ + highlight_ + (has_gloss_ ? mirror_ : 0) > 0; }

  /// The share of light from a unit direction that all smooth lobes send on, times the cosine, by solid angle.
  glm::dvec3 sent(const glm::dvec3& l) const;
  /// The share of a light of the stage in that direction that is sent on, of the brightness 1: by the local model,
  /// without its gloss.
  glm::dvec3 of_light(const glm::dvec3& l) const;
  /// The density with which the followed lobe gives that direction, by solid angle.
  double density(const glm::dvec3& l) const;

  /// The lobes that a path may follow.
  enum class Lobe { smooth, mirror, beyond };
  /// A lobe, by a number in (0, 1).
  Lobe chosen(double choice) const;
  /// A direction of the smooth lobes, by the same number and a pair.
  glm::dvec3 direction(double choice, const glm::dvec2& pair) const;
  /// @{ The colour of a sharp lobe over its chance.
  glm::dvec3 of_mirror() const { return mirror_color_ * (sum_ / mirror_); }
  glm::dvec3 of_beyond() const { return beyond_color_ * (sum_ / beyond_); }
  /// @}
  /// The mirrored direction, a unit vector.
  const glm::dvec3& mirrored() const { return mirrored_; }

 private:
  double gloss_density(const glm::dvec3& l) const;
  glm::dvec3 of_local_model(const glm::dvec3& l) const;

  const Encounter& at_;
  glm::dvec3 mirrored_, mirror_color_, beyond_color_{0};
  bool has_gloss_;
  double even_, highlight_, mirror_, beyond_ = 0, sum_;  ///< chances, but for their sum
};

}  // namespace durero::render
