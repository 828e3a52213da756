#include "durero/raster/difference.hpp"

#include <algorithm>
#include <cstdlib>
#include <stdexcept>

namespace durero::raster {

PictureDifference difference(const render::Image& one, const render::Image& other) {
  if (one.resolution != other.resolution) throw std::invalid_argument("pictures of two sizes; expected one size");
  PictureDifference apart{render::Image(one.resolution)};
  for (std::size_t i = 0; i < one.rgb.size(); i += 3) {
    int most = 0;
    for (std::size_t j = i; j < i + 3; ++j) {
      const int bytes = std::abs(int{one.rgb[j]} - int{other.rgb[j]});
      apart.image.rgb[j] = static_cast<std::uint8_t>(bytes);
      most = std::max(most, bytes);
    }
    apart.pixels += most > 0 ? 1 : 0;
    apart.greatest = std::max(apart.greatest, most);
  }
  return apart;
}

}  // namespace durero::raster
