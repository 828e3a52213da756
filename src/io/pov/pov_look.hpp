#pragma once
/// The looks of POV-Ray's objects as materials: pigments of one colour, or of the two of a checker or of stripes, with
/// a finish, averages of such, and an index of refraction. It is pov_texture.hpp, backwards.

#include <optional>
#include <string>
#include <vector>

#include "durero/scene/stage.hpp"
#include "pov_words.hpp"

namespace durero::io {

/// Where a pattern stands: what lays it on a surface, and how far above it (PovCoordinates).
struct PovPlace {
  std::string place{};
  double depth = 1;
  bool operator==(const PovPlace&) const = default;
};

/// A pattern of two colours.
struct PovPattern {
  scene::Texture texture{};  ///< all but its colours and its name
  PovColor second{};
  PovPlace at{};
};

/// A pigment of one colour, or of two, and what a finish makes of it. What a text leaves out is as here, POV-Ray's
/// defaults.
struct PovLayer {
  PovColor pigment{};
  std::optional<PovPattern> pattern{};
  glm::dvec3 ambient{0.1}, emission{0}, reflection{0};
  double diffuse = 0.6, brilliance = 1, phong = 0, phong_size = 40;
};

/// What the attributes of an object say of its look, one after another.
struct PovLook {
  std::optional<std::size_t> at{};  ///< where the first of its texture stands; nothing where it has none
  std::vector<PovLayer> layers{};   ///< that are averaged
  bool is_other = false;            ///< of what is not read
  double index = 1;
};

/// A look as a scene has it.
struct PovMaterial {
  scene::Material material{};
  std::optional<PovPlace> at{};  ///< where its textures stand; nothing where it has none
};

/// Reads looks, and counts what of them is lost.
class PovLooks {
 public:
  explicit PovLooks(PovWords& in) : in_(in) {}

  /// Reads the attribute that stands here into a look. False where none does.
  bool read(PovLook& look);
  /// The material of a whole look; nothing where it has no texture, or one that is not read. Throws InputError where a
  /// number is none that a material can have.
  std::optional<PovMaterial> material(const PovLook& look);
  /// Reads what stands behind #default: the look of what tells of none, and what others begin with.
  void read_default();
  /// The look that #default told of last; nothing where it told of no pigment.
  std::optional<PovMaterial> default_material();
  /// Moves a look that stands on an object that moves.
  static void move(PovLook& look);
  /// Counts a texture that stands elsewhere than one of a scene would.
  void leave_out_texture() { ++textures_; }
  /// The textures that the materials name.
  const std::vector<scene::Texture>& patterns() const { return patterns_; }
  void name_losses(std::vector<std::string>& lost) const;

 private:
  void read_texture(PovLook& look);
  void read_average(PovLook& look);
  bool read_layer(PovLayer& layer, bool& is_other);
  void read_pigment(PovLayer& layer, bool& is_other);
  bool read_pattern(PovLayer& layer);
  bool read_mean(PovLayer& layer);
  bool read_two_colors(PovLayer& layer);
  bool read_place(PovPattern& pattern, double across);
  std::string name_of(const PovLayer& layer, double count);
  void read_finish(PovLayer& layer);
  void read_reflection(PovLayer& layer);
  void read_interior(PovLook& look);
  void leave_out_value();

  PovWords& in_;
  std::vector<scene::Texture> patterns_;
  PovLayer default_{};
  bool has_default_ = false;
  std::size_t textures_ = 0, reliefs_ = 0, values_ = 0, means_ = 0;
};

}  // namespace durero::io
