#pragma once
/// The points of a pixel are given from its centre: each coordinate is in [−1/2, 1/2). A key chooses among the random
/// ones.

#include <cstdint>
#include <glm/vec2.hpp>

namespace durero::render {

/// A key for pixel (x, y) of the whole picture, and for one of its sets of points.
std::uint64_t key_of(std::uint32_t x, std::uint32_t y, std::uint32_t set);

/// The centre of part i of side × side equal squares. The one of side 1 is the centre, exactly.
glm::dvec2 in_grid(std::uint32_t side, std::uint32_t i);

/// A point anywhere in part i of side × side equal squares.
glm::dvec2 in_strata(std::uint32_t side, std::uint32_t i, std::uint64_t key);

/// Point i of a (0, 2)-sequence in base 2, scrambled as Owen does: each point is anywhere in the pixel with equal
/// probability, and of the first 2ᵐ one lies in each rectangle of 2^−a by 2^−b with a + b = m. Precondition: i < 2¹⁶.
glm::dvec2 in_net(std::uint32_t i, std::uint64_t key);

}  // namespace durero::render
