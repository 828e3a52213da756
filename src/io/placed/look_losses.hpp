#pragma once
/// Colours of other programs' looks, as those of a scene.

#include <cstddef>
#include <glm/common.hpp>
#include <glm/vec3.hpp>
#include <string>
#include <vector>

#include "io/json/stage_fields.hpp"
#include "io/losses.hpp"

namespace durero::io {

/// Counts what of colours is changed.
struct LookLosses {
  std::size_t spectra = 0;   ///< kept as a grey of their mean
  std::size_t patterns = 0;  ///< pictures, patterns and files, of which none is read
  std::size_t beyond = 0;    ///< shares of light below 0 or above 1

  /// The share of light nearest to a colour.
  glm::dvec3 share_of(const glm::dvec3& color) {
    if (!is_share(color)) ++beyond;
    return glm::clamp(color, glm::dvec3(0), glm::dvec3(1));
  }
  /// The nearest amount of light that a scene has: from 0.
  glm::dvec3 light_of(const glm::dvec3& color) {
    if (!is_color(color)) ++beyond;
    return glm::max(color, glm::dvec3(0));
  }
  void name_losses(std::vector<std::string>& lost) const {
    add_loss(lost, spectra, "spectrum", "spectra", "kept as a grey of its mean");
    add_loss(lost, patterns, "texture or file of a colour", "textures or files of colours",
             "left out: a grey of one half stands for it, or the mean of a pattern of two");
    add_loss(lost, beyond, "colour", "colours", "out of its range: the nearest in it stands for it");
  }
};

}  // namespace durero::io
