#pragma once
/// Through which points of a pixel rays are sent. Its colour is the mean of what they bring.

#include <array>
#include <cstdint>
#include <string_view>

namespace durero::render {

/// How the points are chosen. They depend on the pixel's place in the whole picture and on nothing else.
enum class Sampling {
  grid,        ///< the centres of equal squares, of one the centre of the pixel
  stratified,  ///< one in each of equal squares, at a place of its own
  statistical  ///< as many as it takes until the mean is known within a width, with a confidence
};

/// Their names, in the order of Sampling.
inline constexpr std::array<std::string_view, 3> sampling_names{"grid", "stratified", "statistical"};

/// The points of each pixel.
struct Samples {
  Sampling sampling = Sampling::grid;  ///< how they are chosen
  /// How many: a square number for grid and stratified; for statistical the most, at least least_samples.
  std::uint32_t most = 1;
  double width = 0.05;  ///< statistical: the most of half the confidence interval of each linear component, above 0
  double confidence = 0.95;  ///< statistical: that the three components are within it, above 0 and below 1
};

/// @{ Statistical sampling parts the points of a pixel into so many blocks, whose means tell how far apart they are:
/// one a point at first, `least_samples` of them, and `most_blocks` from so many points on.
inline constexpr std::uint32_t least_samples = 4;
inline constexpr std::uint32_t most_blocks = 16;
/// @}

/// The greatest number of points of a pixel.
inline constexpr std::uint32_t greatest_samples = 65536;

/// What an estimate of the mean is in doubt by, above and below, in units of the standard deviation of the means of its
/// blocks: Student's t of their degrees of freedom over √blocks. The doubt 1 − confidence is shared out evenly over
/// three components and `looks`, the times that the question is asked, so that by the union bound it holds for all of
/// them together where the means of blocks are normal. Preconditions: 0 < confidence < 1, looks ≥ 1, blocks ≥ 2.
double half_width_factor(double confidence, std::uint32_t looks, std::uint32_t blocks);

/// The part of the width that so many points of a pixel are held to: 1 from 128 on, before that √(points/128). The more
/// points a pixel has, the more of them a further step takes for the error that it takes away; in this proportion what
/// is left of the squared error of all pixels is least for their number (docs/rendering.md).
double part_of_width(std::uint32_t points);

}  // namespace durero::render
