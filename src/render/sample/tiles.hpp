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

/// The side of a tile of a scene with so many elements. The data of 256 rays fit the nearer caches; among many elements
/// four times as many rays gain more, since more of them stay together.
constexpr std::uint32_t side_of_tile(std::size_t elements) { return elements > 64 ? 32 : 16; }

/// Calls draw(pixels) for each tile of that side, as by_rows does for rows.
template <class Draw>
void by_tiles(scene::Resolution picture, std::uint32_t side, const Progress& progress, Draw&& draw) {
  const std::uint32_t across = (picture.width + side - 1) / side, down = (picture.height + side - 1) / side;
  by_rows(across * down, progress, [&](std::uint32_t i) {
    draw(pixels_of_tile(picture, {i % across, i / across}, side));
  });
}

}  // namespace durero::render
