#pragma once
/// A row is a set of pixels of a picture, each with its samples.

#include <cstdint>
#include <span>
#include <vector>

#include "durero/render/light/whitted.hpp"
#include "durero/render/sample/sampling.hpp"
#include "durero/scene/camera.hpp"
#include "view.hpp"

namespace durero::render {

/// The colours and counts of the pixels of a row or of a tile.
struct PixelRow {
  std::vector<PathRadiance> pixels;  ///< color and left_out are means over its samples, rays is a sum
  std::uint64_t samples = 0;         ///< rays from the eye, of all pixels
  std::uint64_t in_doubt = 0;        ///< pixels whose mean is not known within the width asked for
};

/// Adds the result of one more ray of a pixel.
void add(PathRadiance& sum, const PathRadiance& more);
/// Turns the sums over so many rays into means. Sums over one ray stay as they are.
void divide(PathRadiance& sum, std::uint32_t rays);

/// The row of these pixels of the crop, each by as many samples. Precondition: they are neither allotted nor
/// statistical.
PixelRow sampled(const View& view, const Samples& samples, std::span<const scene::Pixel> pixels);

}  // namespace durero::render
