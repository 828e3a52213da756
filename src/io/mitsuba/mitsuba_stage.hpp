#pragma once
/// The sensors and the emitters of a Mitsuba scene.

#include <map>
#include <string>
#include <vector>

#include "durero/scene/stage.hpp"
#include "mitsuba_look.hpp"

namespace durero::io {

/// Reads what a picture needs beside shapes into a stage, and counts what is lost.
class MitsubaStage {
 public:
  MitsubaStage(scene::Stage& stage, MitsubaLooks& looks) : stage_(stage), looks_(looks) {}

  void read_sensor(const MitsubaNode& sensor);
  void read_emitter(const MitsubaNode& emitter);
  void name_losses(std::vector<std::string>& lost) const;

 private:
  struct Film;

  Film film_of(const MitsubaNode& sensor);
  void add_point(const MitsubaNode& emitter);
  void add_spot(const MitsubaNode& emitter);
  void add_directional(const MitsubaNode& emitter);

  scene::Stage& stage_;
  MitsubaLooks& looks_;
  bool has_sensor_ = false;
  std::size_t sensors_ = 0, cameras_ = 0, settings_ = 0, faded_ = 0;
  std::map<std::string, std::size_t> left_out_;
};

}  // namespace durero::io
