#pragma once
/// What a POV-Ray text says beside its objects: camera, lights, background and settings.

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "durero/scene/stage.hpp"
#include "pov_words.hpp"

namespace durero::io {

/// A camera as the language has it.
struct PovCamera {
  glm::dvec3 location{0}, direction{0, 0, 1}, right{4.0 / 3, 0, 0}, up{0, 1, 0}, sky{0, 1, 0};
  std::optional<glm::dvec3> look_at{};
  bool is_turned = false;  ///< by look_at or angle
};

/// Reads a stage, and counts what of it is lost.
class PovStage {
 public:
  PovStage(PovWords& in, scene::Stage& stage) : in_(in), stage_(stage) {}

  /// The statements that it reads.
  static constexpr std::array<std::string_view, 8> statements{
      "camera", "light_source", "background", "global_settings", "sky_sphere", "#version", "#declare", "#local"};
  /// Reads the statement that stands here. False where it is none of the above.
  bool read();
  void name_losses(std::vector<std::string>& lost) const;

 private:
  void read_camera();
  void read_camera_part(PovCamera& camera);
  static void look_at(PovCamera& camera);
  void take_camera(std::size_t at, const PovCamera& camera);
  void read_light();
  void read_background();
  void read_settings();
  void read_setting();
  void read_version();
  void read_declaration();
  void read_sky();

  PovWords& in_;
  scene::Stage& stage_;
  bool camera_changed_ = false;
  std::size_t parallels_ = 0, settings_ = 0, versions_ = 0, declarations_ = 0, skies_ = 0;
};

/// The size that the first line of the text tells, where it is a comment with the call of POV-Ray: // … +W640 +H360.
std::optional<scene::Resolution> pov_size(const Source& source);

}  // namespace durero::io
