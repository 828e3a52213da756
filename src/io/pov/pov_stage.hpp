#pragma once
/// What a POV-Ray text says beside its objects: camera, lights, background and settings.

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "durero/scene/stage.hpp"
#include "pov_camera.hpp"
#include "pov_gamma.hpp"
#include "pov_light.hpp"
#include "pov_words.hpp"

namespace durero::io {

/// Reads a stage, and counts what of it is lost.
class PovStage {
 public:
  /// `size` is what the text tells of the picture's.
  PovStage(PovWords& in, scene::Stage& stage, std::optional<scene::Resolution> size)
      : in_(in), stage_(stage), told_size_(size) {
    stage_.resolution = size;
  }

  /// The statements that it reads.
  static constexpr std::array<std::string_view, 6> statements{"camera",          "light_source", "background",
                                                              "global_settings", "sky_sphere",   "#version"};
  /// Reads the statement that stands here. False where it is none of the above.
  bool read();
  /// Adds a light that stands in an object, which is moved.
  void add(PovLight light, const PovTransform& by);
  /// Once the whole text is read, and its materials are the stage's: makes their light linear, by the gamma that holds.
  void make_linear();
  void name_losses(std::vector<std::string>& lost) const;

 private:
  void read_camera();
  void read_light();
  void read_background();
  void read_settings();
  void read_setting();
  void read_gamma(std::size_t at);
  void read_version();
  void read_sky();
  std::optional<scene::Environment> read_gradient();

  PovWords& in_;
  scene::Stage& stage_;
  const std::optional<scene::Resolution> told_size_;
  bool camera_changed_ = false;
  std::optional<double> version_{};
  std::optional<PovGamma> gamma_{};
  std::size_t gamma_at_ = 0;  // where the text tells of it; its beginning where it does not
  std::size_t numbers_ = 0;   // that were made linear
  std::size_t cameras_ = 0, lights_ = 0, parallels_ = 0, areas_ = 0, settings_ = 0, versions_ = 0, skies_ = 0;
};

/// The size that the first line of the text tells, where it is a comment with the call of POV-Ray: // … +W640 +H360.
std::optional<scene::Resolution> pov_size(const Source& source);

}  // namespace durero::io
