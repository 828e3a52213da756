#pragma once
/// Pixels of a picture, of as many rays each as are asked for.

#include <cstdint>
#include <span>
#include <vector>

#include "durero/render/sampling.hpp"
#include "durero/render/whitted.hpp"
#include "durero/scene/camera.hpp"
#include "view.hpp"

namespace durero::render {

/// What the rays of each pixel of a row, or of a tile, brought.
struct Row {
  std::vector<Brought> pixels;  ///< color and left_out are the means of its rays, rays all that were followed for it
  std::uint64_t samples = 0;    ///< rays from the eye, of all pixels
  std::uint64_t in_doubt = 0;   ///< pixels whose mean is not known within the width that was asked for
};

/// Adds what one more ray of a pixel brought.
void add(Brought& sum, const Brought& more);
/// Makes sums of so many rays their means. Of one they stay as they are.
void divide(Brought& sum, std::uint32_t rays);

/// These pixels of the crop by a grid or stratified. Precondition: not statistical.
Row sampled(const View& view, const Samples& samples, std::span<const scene::Pixel> pixels);

}  // namespace durero::render
