#pragma once
/// Means of a few points by weights that are not negative and sum to one, exactly.

#include <array>
#include <vector>

#include "durero/model/tipos.hpp"

namespace durero::model {

/// Whether w is a mean of the corners. Of none there is no mean.
bool is_mean(const std::vector<Punto>& corners, const Punto& w);

/// Whether some mean of a and of b is no mean of `common`. Precondition: `common` has two points at most.
bool have_mean_outside(const std::vector<Punto>& a, const std::vector<Punto>& b, const std::vector<Punto>& common);

/// Whether the ray from a point in a direction of integers meets a mean of the corners.
bool meets_mean(const Punto& from, const std::array<int, 3>& direction, const std::vector<Punto>& corners);

}  // namespace durero::model
