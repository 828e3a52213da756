#pragma once
/// The tiles of a picture, shared among threads.

#include <algorithm>
#include <vector>

#include "by_rows.hpp"
#include "durero/scene/camera.hpp"
#include "durero/scene/stage.hpp"

namespace durero::render {

/// The pixels of one tile, square by square: rays that go the same way are answered together.
inline std::vector<scene::Pixel> pixels_of_tile(scene::Resolution picture, scene::Pixel tile, std::uint32_t side) {
  constexpr std::uint32_t square = 8;
  std::vector<scene::Pixel> pixels;
  pixels.reserve(std::size_t(side) * side);
  for (std::uint32_t i = 0; i < side * side; ++i) {
    const std::uint32_t in_square = i % (square * square), number = i / (square * square);
    const std::uint32_t x = tile.x * side + number % (side / square) * square + in_square % square;
    const std::uint32_t y = tile.y * side + number / (side / square) * square + in_square / square;
    if (x < picture.width && y < picture.height) pixels.push_back({x, y});
  }
  return pixels;
}

/// The number of tiles of that side.
constexpr std::uint32_t tiles(std::uint32_t side, scene::Resolution picture) {
  return ((picture.width + side - 1) / side) * ((picture.height + side - 1) / side);
}

/// The side of a tile of a scene with so many elements. The data of 256 rays fit the nearer caches. Among many elements
/// more rays gain more, since rays to one light come closer together; but some tiles are left to each thread.
constexpr std::uint32_t side_of_tile(std::size_t elements, scene::Resolution picture) {
  constexpr std::uint32_t enough = 48;
  if (elements <= 64) return 16;
  std::uint32_t side = 128;
  while (side > 32 && tiles(side, picture) < enough) side /= 2;
  return side;
}

/// Calls draw(pixels) for each tile of that side, as by_rows does for rows.
template <class Draw>
void by_tiles(scene::Resolution picture, std::uint32_t side, const Progress& progress, Draw&& draw) {
  const std::uint32_t across = (picture.width + side - 1) / side;
  by_rows(tiles(side, picture), progress, [&](std::uint32_t i) {
    draw(pixels_of_tile(picture, {i % across, i / across}, side));
  });
}

}  // namespace durero::render
