#pragma once
/// The random stream that cases are drawn from; it knows the format of the numbers and the types of elements asked for.

#include <limits>
#include <vector>

#include "durero/conform/families/families.hpp"
#include "durero/scene/shapes.hpp"

namespace durero::conform {

class Draws : public Random {
 public:
  explicit Draws(std::uint64_t seed, CaseOptions options = {}) : Random(seed), options_(std::move(options)) {}

  const CaseOptions& options() const { return options_; }
  bool allows(model::Tipo tipo) const;
  /// Whether some kind of bodies is asked for.
  bool allows_bodies() const;
  /// One of the kinds of bodies that are asked for; any where none is named.
  BodyKind any_body_kind();
  /// Whether meshes that are grids are asked about as such: height fields are asked for, and triangles are not.
  bool asks_grids() const;
  /// One of the types, each as often; where some are asked for, one of those.
  model::Tipo any_type_of(const std::vector<model::Tipo>& types);

  /// The number of the format nearest to x: ±∞ beyond its range.
  double rounded(double x) const;
  glm::dvec3 rounded(const glm::dvec3& v) const;
  scene::Corners rounded(const scene::Corners& vertices) const;
  /// The number of the format that follows the nearest one, upwards or downwards.
  double next(double x, double way) const;

  // The format's numbers are multiples of 2^least_exponent below 2^end_of_exponents, of this many digits.
  int least_exponent() const { return is_binary32() ? -149 : -1074; }
  int end_of_exponents() const { return is_binary32() ? 128 : 1024; }
  int digits() const { return is_binary32() ? 24 : 53; }

 private:
  bool is_binary32() const { return options_.numbers == NumberFormat::binary32; }

  CaseOptions options_;
};

}  // namespace durero::conform
