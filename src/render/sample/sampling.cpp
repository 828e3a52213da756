#include "durero/render/sample/sampling.hpp"

#include <algorithm>
#include <boost/math/distributions/students_t.hpp>
#include <cmath>

namespace durero::render {

double half_width_factor(double confidence, std::uint32_t looks, std::uint32_t blocks) {
  constexpr double components = 3;
  const double each_tail = (1 - confidence) / (2 * components * looks);
  const boost::math::students_t_distribution<double> t(blocks - 1);
  return boost::math::quantile(boost::math::complement(t, each_tail)) / std::sqrt(double(blocks));
}

double part_of_width(std::uint32_t points) {
  constexpr double of_the_whole = 128;
  return std::min(1.0, std::sqrt(points / of_the_whole));
}

}  // namespace durero::render
