#pragma once
/// The looks of surfaces in a pbrt scene: textures, materials, and the colours of lights.

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "durero/scene/stage.hpp"
#include "io/placed/look_losses.hpp"
#include "pbrt_words.hpp"

namespace durero::io {

/// Makes materials of those of pbrt, and counts what of them is lost.
class PbrtLooks {
 public:
  /// The look of a surface without a material.
  scene::Material usual() const { return {.color = glm::dvec3(0.5)}; }
  /// The look of a Material of that type, or of a MakeNamedMaterial.
  scene::Material material(const std::string& type, const PbrtParameters& parameters);
  /// Remembers a texture.
  void add_texture(const std::string& name, const std::string& kind, const PbrtParameters& parameters);
  /// An amount of light, times its scale.
  glm::dvec3 light(const PbrtParameters& parameters, std::string_view name, double usual);
  void name_losses(std::vector<std::string>& lost) const;

 private:
  glm::dvec3 color(const PbrtParameters& parameters, std::string_view name, double usual);
  std::optional<glm::dvec3> value(const PbrtParameter& told);
  double refraction(const PbrtParameters& parameters);

  std::map<std::string, std::optional<glm::dvec3>> textures_;  ///< nothing of those that are read by no rule
  LookLosses losses_;
  std::map<std::string, std::size_t> simplified_;
};

}  // namespace durero::io
