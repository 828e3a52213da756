#pragma once
/// What the samples of one element say of a ray and of a point.

#include <glm/vec3.hpp>
#include <limits>
#include <optional>

#include "durero/oracle/cover.hpp"
#include "line.hpp"

namespace durero::oracle::sampled {

/// The first candidate of one element: distance of its foot from the origin, and the sample.
struct SampledCandidate {
  double distance;
  glm::dvec3 sample;
};

/// False where no sample of the ball, of a cover with that δ, is a candidate whose foot is less than `foot` from the
/// origin.
bool may_hold_candidate(const BallNode& ball, double delta, const ScaledRay& line,
                        double foot = std::numeric_limits<double>::infinity());

/// The sample within δ of the ray whose foot is nearest to the origin.
std::optional<SampledCandidate> nearest(const Cover& cover, const ScaledRay& line);

/// True when some sample lies within δ of the point. `slack` is for the rounding of the point.
bool near_sample(const Cover& cover, const glm::dvec3& point, double slack, std::uint32_t index = 0);

}  // namespace durero::oracle::sampled
