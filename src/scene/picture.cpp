#include "durero/scene/picture.hpp"

#include <bit>
#include <stdexcept>
#include <utility>

#include "durero/scene/stage.hpp"

namespace durero::scene {
namespace {

TexelImage halved(const TexelImage& m) {
  TexelImage half{m.width / 2, m.height / 2};
  half.texels.reserve(std::size_t{half.width} * half.height);
  for (std::uint32_t k = 0; k < half.height; ++k)
    for (std::uint32_t j = 0; j < half.width; ++j)
      half.texels.push_back(
          (m.at(2 * j, 2 * k) + m.at(2 * j + 1, 2 * k) + m.at(2 * j, 2 * k + 1) + m.at(2 * j + 1, 2 * k + 1)) * 0.25);
  return half;
}

}  // namespace

bool has_mipmap(const TexelImage& picture) noexcept {
  return picture.width == picture.height && std::has_single_bit(picture.width);
}

std::vector<TexelImage> mipmap(TexelImage picture) {
  if (!has_mipmap(picture)) throw std::invalid_argument("a mipmap is made of 2ⁿ × 2ⁿ texels");
  std::vector<TexelImage> levels{std::move(picture)};
  while (levels.back().width > 1) levels.push_back(halved(levels.back()));
  return levels;
}

}  // namespace durero::scene
