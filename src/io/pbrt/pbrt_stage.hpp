#pragma once
/// The camera, the film and the lights of a pbrt scene.

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "durero/scene/stage.hpp"
#include "io/placed/placement.hpp"
#include "pbrt_look.hpp"

namespace durero::io {

/// Reads what a picture needs beside shapes into a stage, and counts what is lost.
class PbrtStage {
 public:
  PbrtStage(scene::Stage& stage, PbrtLooks& looks) : stage_(stage), looks_(looks) {}

  void read_film(const PbrtParameters& parameters);
  /// `frame` puts the camera into the world; nothing where it has no way back.
  void read_camera(const std::string& type, const PbrtParameters& parameters, std::optional<AffinePlacement> frame);
  void read_light(const std::string& type, const PbrtParameters& parameters, const AffinePlacement& by);
  /// Once the film and the camera have been read: the one needs the size of the other.
  void finish();
  void name_losses(std::vector<std::string>& lost) const;

 private:
  void add_spot(const PbrtParameters& parameters, const AffinePlacement& by);

  scene::Stage& stage_;
  PbrtLooks& looks_;
  std::optional<scene::Resolution> size_;
  std::optional<AffinePlacement> frame_;
  double fov_ = 90, aperture_ = 0, focus_ = 0;
  std::vector<double> window_;
  std::size_t cameras_ = 0, faded_ = 0;
  std::map<std::string, std::size_t> left_out_;
};

}  // namespace durero::io
