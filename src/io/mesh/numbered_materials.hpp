#pragma once
/// The materials of a format that has no names for them: f1, f2, … in the order in which a file names them.

#include <array>
#include <cstdint>
#include <map>
#include <utility>

#include "durero/scene/scene.hpp"
#include "durero/scene/stage.hpp"

namespace durero::io {

class NumberedMaterials {
 public:
  explicit NumberedMaterials(scene::Scene& scene) : scene_(scene) {}

  /// The number, from 0, of the material that looks so: one look is one material, whatever its name. It has no relief.
  std::uint32_t number(scene::Material look);
  /// Once no material follows: a stage's materials ascend by name; until here they are in the order of the file.
  void finish();

 private:
  using Numbers = std::array<double, 22>;
  using Looks = std::pair<Numbers, decltype(scene::TextureUses::names)>;  ///< all that it has but for its name

  static Numbers numbers_of(const scene::Material& look);

  scene::Scene& scene_;
  std::map<Looks, std::uint32_t> known_;
};

}  // namespace durero::io
