#pragma once
/// Sampling chooses the points of a pixel that rays are sent through. The pixel's colour is the mean of what they
/// bring.

#include <array>
#include <cstdint>
#include <string_view>

namespace durero::render {

/// The way of choosing the points. They depend on the pixel's place in the whole
/// picture and on the seed, and on nothing else.
enum class Sampling {
  grid,         ///< the centres of equal squares; one point is the centre of the pixel
  stratified,   ///< a random point in each of equal squares
  net,          ///< the points of a scrambled net, one after the other
  allotted,     ///< of such points as many as the colours of the pixels around ask for
  independent,  ///< random points anywhere, each by itself
  statistical   ///< as many points as it takes to know the mean within a width, with a confidence
};

/// Their names, in the order of Sampling.
inline constexpr std::array<std::string_view, 6> sampling_names{"grid",     "stratified",  "net",
                                                                "allotted", "independent", "statistical"};

/// The points of each pixel.
struct Samples {
  Sampling sampling = Sampling::grid;  ///< the way of choosing them
  /// The number of points, a square number for grid and stratified; the greatest number for allotted and statistical,
  /// at least least_samples.
  std::uint32_t most = 1;
  double width = 0.05;  ///< statistical: the greatest half of the confidence interval of each linear component, above 0
  double confidence = 0.95;  ///< statistical: the confidence for the three components together, above 0 and below 1
  std::uint32_t seed = 0;    ///< chooses among the random numbers
};

/// The least number of points of a pixel that is sampled as it needs.
inline constexpr std::uint32_t least_samples = 4;
/// Statistical sampling parts the points of a pixel into blocks, whose means tell how far apart they are: one a point,
/// until there are so many.
inline constexpr std::uint32_t most_blocks = 16;

/// The greatest number of points of a pixel.
inline constexpr std::uint32_t greatest_samples = 65536;

/// The half width of the confidence interval of an estimated mean, in units of the standard deviation of the means of
/// its blocks: Student's t of their degrees of freedom over √blocks. The doubt 1 − confidence is shared out evenly over
/// three components and `looks`, the times that the question is asked, so that by the union bound it holds for all of
/// them together where the means of blocks are normal. Preconditions: 0 < confidence < 1, looks ≥ 1, blocks ≥ 2.
double half_width_factor(double confidence, std::uint32_t looks, std::uint32_t blocks);

/// The part of the width that so many points of a pixel must keep to: 1 from 128 on, before that √(points/128). The
/// more points a pixel has, the more of them a further step takes for the error that it takes away; in this proportion
/// the squared error left of all pixels is least for their number (docs/rendering-reference.md).
double part_of_width(std::uint32_t points);

}  // namespace durero::render
