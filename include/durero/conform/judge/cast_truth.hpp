#pragma once
/// The exact answers to balls that are cast: the first t ≥ 0 at which some point of an element is within R of p + t·v.

#include <span>
#include <vector>

#include "durero/conform/judge/truth.hpp"

namespace durero::conform {

/// The first touch of each ray's ball, in order, by as many threads as the calling one may use: a hit of the elements
/// that are touched at that t, 0 where the ball touches before it moves; its point is the *middle of the ball*, p +
/// t·v. Each number is rounded once. Several elements are a tie. The way across an axis is measured from the line along
/// its vector. Preconditions: the rays are of the scene, which has no bodies; there is a range for each, with a radius.
std::vector<ExactAnswer> truths_of_casts(const scene::Scene& scene, std::span<const scene::Query> rays,
                                         std::span<const AskedRange> ranges);

/// About the place of contact: the point of the element that is nearest to the middle of a ball, with the way across an
/// axis measured as above, and rounded to a few units of the last place of the largest number. Precondition: the
/// element is of the scene, and no body.
glm::dvec3 contact_of(const scene::Scene& scene, scene::ElementRef element, const glm::dvec3& middle);

}  // namespace durero::conform
