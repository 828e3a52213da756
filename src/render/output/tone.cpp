#include "durero/render/output/tone.hpp"

#include <algorithm>
#include <cmath>

#include "durero/contract/contract.hpp"
#include "render/sample/by_rows.hpp"

namespace durero::render {
namespace {

/// The greatest finite component of the picture; 0 where none is above it.
double greatest(const Picture& picture) {
  double greatest = 0;
  for (const glm::dvec3& color : picture.rgb)
    for (int i = 0; i < 3; ++i)
      if (std::isfinite(color[i])) greatest = std::max(greatest, color[i]);
  return greatest;
}

template <class Map>
Image mapped(const Picture& picture, Map&& map) {
  Image image(picture.resolution);
  by_rows(picture.resolution.height, {}, [&](std::uint32_t y) {
    for (std::uint32_t x = 0; x < picture.resolution.width; ++x)
      image.set(x, y, map(picture.rgb[std::size_t(y) * picture.resolution.width + x]));
  });
  return image;
}

}  // namespace

Image toned(const Picture& picture, Tone tone) {
  switch (tone) {
    case Tone::clamp:
      return mapped(picture, [](const glm::dvec3& c) { return c; });
    case Tone::max: {
      const double most = greatest(picture);
      return mapped(picture, [=](const glm::dvec3& c) { return most > 0 ? c / most : c; });
    }
    case Tone::reinhard:
      return mapped(picture, [](const glm::dvec3& c) { return 1.0 - 1.0 / (1.0 + c); });
  }
  contract::unreachable();
}

}  // namespace durero::render
