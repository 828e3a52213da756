#pragma once
/// The materials of a text of Radiance, and what a scene holds of them.

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "durero/scene/stage.hpp"
#include "io/mesh/numbered_materials.hpp"
#include "rad_text.hpp"

namespace durero::io {

class RadLooks {
 public:
  explicit RadLooks(scene::Scene& scene) : materials_(scene) {}

  /// Keeps what is no surface, for those that follow.
  void define(const RadPrimitive& primitive);
  /// The number of the material of a surface, if a scene has such; what is not kept of it is counted.
  std::optional<std::uint32_t> of(const RadPrimitive& surface);
  /// The light that the material of a surface sends out; nothing where it sends none, or where it changes from point to
  /// point.
  std::optional<glm::dvec3> light_of(const RadPrimitive& surface) const;
  /// Once no surface follows.
  void finish() { materials_.finish(); }
  void name_losses(std::vector<std::string>& lost) const;

 private:
  /// A material, under the patterns and textures that change it.
  struct MaterialSearch {
    const RadPrimitive* material = nullptr;
    bool is_changed = false;
    bool is_mixed = false;
  };

  MaterialSearch find(const std::string& modifier) const;
  std::optional<scene::Material> look(const RadPrimitive& material);

  std::map<std::string, RadPrimitive, std::less<>> defined_;
  NumberedMaterials materials_;
  std::size_t changed_ = 0, mixed_ = 0, absent_ = 0, bright_ = 0, rough_ = 0, dyed_ = 0;
  std::map<std::string, std::size_t, std::less<>> others_;
};

}  // namespace durero::io
