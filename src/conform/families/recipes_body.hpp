#pragma once
/// A recipe of a family of bodies makes the bodies of a scene, or a ray for them.

#include <span>

#include "conform/families/drawn_ray.hpp"
#include "durero/conform/families/asked_body.hpp"

namespace durero::conform::recipes {

using AskedBodies = std::vector<AskedBody>;
using BodySpan = std::span<const AskedBody>;

AskedBodies bodies(Draws& random, int count);
DrawnRay bodies(Draws& random, int, BodySpan all);
AskedBodies some_bodies(Draws& random, int);
DrawnRay bodies_far(Draws& random, int log2_distance, BodySpan all);
AskedBodies bodies_scale(Draws& random, int log2_scale);
DrawnRay bodies_scale(Draws& random, int log2_scale, BodySpan all);
AskedBodies bodies_thin(Draws& random, int log2_ratio);
DrawnRay bodies_edge(Draws& random, int log2_distance, BodySpan all);
DrawnRay bodies_inside(Draws& random, int eighths, BodySpan all);
DrawnRay bodies_axis(Draws& random, int log2_distance, BodySpan all);
DrawnRay bodies_margin(Draws& random, int minus_log2_margin, BodySpan all);
DrawnRay bodies_surface(Draws& random, int minus_log2_step, BodySpan all);

}  // namespace durero::conform::recipes
