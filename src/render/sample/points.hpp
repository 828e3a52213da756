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

/// Point i of a (0, 2)-sequence in base 2, scrambled so that pairs of points go together as by Owen's scrambling: each
/// point is anywhere in the pixel with equal probability, and of the first 2ᵐ one lies in each rectangle of 2^−a by
/// 2^−b with a + b = m.
glm::dvec2 in_net(std::uint32_t i, std::uint64_t key);

/// A sample of a pixel gives pairs of random numbers, as many as are asked for. The pairs of one dimension, over the
/// numbers of the samples, are a net of their own, scrambled by the pixel's key and the dimension, and in an order of
/// its own: nested shuffling keeps each block of 2ᵐ consecutive samples a net (Burley, *Practical Hash-based Owen
/// Scrambling*, 2020). The dimensions:
///
///   0                the place in the pixel, by in_net in the order of the numbers, or by another sampling
///   1                the place on the lens
///   of_meeting(b)    of Whitted's way b: the direction of a lobe; then the place on each light
///   of_meeting(n)    of meeting n of a path: the direction; its choices; the place on an emitter; roulette; and from
///                    the 17th on the place on each light
struct SampleSource {
  std::uint64_t key = 0;     ///< of the pixel and the seed
  std::uint32_t number = 0;  ///< of the sample, below 2¹⁶
  bool independent = false;  ///< whether each pair is drawn by itself, without a net

  /// The pair of that dimension: each number is in (0, 1), anywhere with equal probability.
  glm::dvec2 pair(std::uint64_t dimension) const;
};

/// The dimension of the place on the lens.
inline constexpr std::uint64_t of_lens = 1;
/// The first dimension of a meeting: meetings are told apart by the turns that led to them, as branches of a tree.
std::uint64_t of_meeting(std::uint64_t branch);

/// The time of the samples of that number, in (0, 1): the same for all pixels. Each block of 2ᵐ of them has one in each
/// of as many equal parts, in an order that does not go with the places in the pixel.
double time_of(std::uint32_t number, std::uint64_t seed);

}  // namespace durero::render
