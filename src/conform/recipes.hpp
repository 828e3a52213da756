#pragma once
/// How the scenes and the rays of each family are made; the table in families.cpp names them.

#include "bodies.hpp"

namespace durero::conform::recipes {

using Bodies = std::vector<Body>;
using Given = std::span<const Body>;

const Body& any_of(Random& random, Given bodies);

// Scenes of one to three elements.
Bodies some(Random& random, int);
Bodies some_axial(Random& random, int);
Bodies some_cylinders(Random& random, int);
Bodies some_cones(Random& random, int);

// Of scale (recipes_scale.cpp).
Bodies as_many(Random& random, int count);
Shot generic(Random& random, int, Given bodies);
Shot far_origin(Random& random, int log2_distance, Given bodies);
Bodies large_offset(Random& random, int log2_offset);
Bodies scaled_up(Random& random, int log2_scale);
Bodies huge_ratio(Random& random, int log2_ratio);
Shot near_small(Random& random, int, Given bodies);
Shot direction_scale(Random& random, int log2_scale, Given bodies);
Bodies degenerate_numbers(Random& random, int log2_scale);
Shot degenerate_numbers(Random& random, int log2_scale, Given bodies);
Bodies long_thin(Random& random, int log2_ratio);
Shot long_thin(Random& random, int log2_ratio, Given bodies);
Shot near_origin(Random& random, int minus_log2_distance, Given bodies);
Bodies grid(Random& random, int count);
Shot grid(Random& random, int, Given bodies);

// Of direction (recipes_direction.cpp).
Bodies near_axial(Random& random, int);
Shot near_axial(Random& random, int minus_log2_slope, Given bodies);
Shot perpendicular(Random& random, int log2_distance, Given bodies);
Shot near_generator(Random& random, int minus_log2_angle, Given bodies);
Shot second_nappe(Random& random, int eighths, Given bodies);
Shot axis_parallel(Random& random, int log2_distance, Given bodies);
Shot in_surface(Random& random, int eighths, Given bodies);

// Of the place of the point (recipes_place.cpp).
Shot apex(Random& random, int log2_distance, Given bodies);
Bodies rim(Random& random, int);
Shot rim(Random& random, int log2_distance, Given bodies);
Shot inside(Random& random, int quarters, Given bodies);
Bodies with_twin(Random& random, int);
Shot on_surface(Random& random, int percent, Given bodies);
Bodies tangent(Random& random, int);
Shot tangent(Random& random, int log2_distance, Given bodies);
Shot zero_b(Random& random, int percent, Given bodies);
Bodies tie(Random& random, int);
Shot tie(Random& random, int log2_distance, Given bodies);

}  // namespace durero::conform::recipes
