#pragma once
/// The look of a surface in a Mitsuba scene.

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "durero/scene/stage.hpp"
#include "io/placed/look_losses.hpp"
#include "mitsuba_values.hpp"

namespace durero::io {

/// Makes materials of bsdf, and counts what of them is lost.
class MitsubaLooks {
 public:
  /// `target` is the element that a ref names.
  explicit MitsubaLooks(std::function<const MitsubaNode&(const MitsubaNode&)> target) : target_(std::move(target)) {}

  /// The look of a surface that has no bsdf.
  scene::Material usual() const;
  scene::Material material(const MitsubaNode& bsdf) { return material(bsdf, 1); }
  /// An amount of light: the child of that name, or white of that strength where there is none.
  glm::dvec3 light(const MitsubaNode& node, std::string_view name, double usual);
  void name_losses(std::vector<std::string>& lost) const;

 private:
  scene::Material material(const MitsubaNode& bsdf, int depth);
  scene::Material of_nested(const MitsubaNode& bsdf, int depth);
  double refraction(const MitsubaNode& bsdf);
  glm::dvec3 color(const MitsubaNode& node, std::string_view name, double usual);
  glm::dvec3 color_of(const MitsubaNode& node);

  std::function<const MitsubaNode&(const MitsubaNode&)> target_;
  LookLosses losses_;
  std::map<std::string, std::size_t> simplified_;  ///< bsdf, by type
  std::size_t indices_ = 0;
};

}  // namespace durero::io
