#pragma once
/// Faults that tracers were seen to have, or that their authors fear: each is one branch of tracer.hpp, and here has a
/// name and the families that must see it.

#include <span>
#include <string_view>
#include <vector>

namespace durero::test {

enum class Fault {
  none,
  binary32_arithmetic,
  t_rounded_to_binary32,
  unstable_quadratic,
  smaller_roots_by_difference,
  normal_by_difference,
  least_t_1e_3,
  least_t_1e_4,
  least_t_1e_6,
  least_t_of_size,
  greatest_t_1e_6,
  greatest_t_1e_15,
  negative_t,
  absolute_t,
  near_root_skipped,
  near_root_outside_clip_ends,
  both_nappes,
  linear_case_forgotten,
  b_of_zero_is_a_miss,
  b_not_halved,
  parallel_to_axis_by_epsilon,
  discriminant_by_epsilon,
  nan_for_a_miss,
  unit_v_assumed,
  v_normalised_alone,
  origin_ignored,
  axis_flipped,
  axis_is_z,
  altura_halved,
  clip_lower_end_missing,
  clip_upper_end_missing,
  clip_of_t,
  clip_narrowed,
  caps_added,
  discs_left_out,
  radius_squared_twice,
  proportion_inverted,
  radius_at_other_end,
  apex_removed,
  inside_is_a_miss,
  inside_is_at_origin,
  parallel_to_plane_by_epsilon,
  plane_one_sided,
  triangle_one_sided,
  determinant_by_epsilon,
  triangle_edges_narrowed,
  disc_is_its_square,
  t_by_quotient_of_x,
  sphere_too_small_around,
  first_in_order,
  last_in_distance,
  squares_of_binary32,
  small_numbers_vanish,
};

struct FaultRow {
  Fault fault;
  std::string_view name;
  std::vector<std::string_view> seen_by;  ///< families that must catch it
};

inline const std::vector<FaultRow>& faults() {
  using enum Fault;
  static const std::vector<FaultRow> table{
      {binary32_arithmetic, "binary32 arithmetic", {"generic", "far_origin", "large_offset"}},
      {t_rounded_to_binary32, "t rounded to binary32", {"generic", "distance_limit"}},
      {unstable_quadratic, "discriminant by difference", {"far_origin", "huge_ratio"}},
      {smaller_roots_by_difference, "smaller root by difference", {"near_generator"}},
      {normal_by_difference, "normal of a triangle by difference", {"sliver"}},
      {least_t_1e_3, "t at least 1e-3", {"near_origin", "tiny", "direction_scale"}},
      {least_t_1e_4, "t at least 1e-4", {"near_origin", "tiny"}},
      {least_t_1e_6, "t at least 1e-6", {"near_origin", "tiny"}},
      {least_t_of_size, "t at least 1e-6 of the size", {"near_origin"}},
      {greatest_t_1e_6, "t at most 1e6", {"direction_scale", "distance_limit", "flat"}},
      {greatest_t_1e_15, "t at most 1e15", {"direction_scale"}},
      {negative_t, "behind the origin", {"inside", "generic"}},
      {absolute_t, "magnitude of t", {"inside", "generic"}},
      {near_root_skipped, "far root always", {"generic"}},
      {near_root_outside_clip_ends, "near root outside the clip ends it", {"generic", "second_nappe"}},
      {both_nappes, "both nappes", {"second_nappe"}},
      {linear_case_forgotten, "A = 0 forgotten", {"near_generator"}},
      {b_of_zero_is_a_miss, "B = 0 a miss", {"zero_b"}},
      {b_not_halved, "B not halved", {"generic"}},
      {parallel_to_axis_by_epsilon, "parallel to an axis by 1e-6", {"near_axial"}},
      {discriminant_by_epsilon, "discriminant above 1e-4", {"tiny"}},
      {nan_for_a_miss, "NaN for a miss", {"generic"}},
      {unit_v_assumed, "unit v assumed", {"generic", "direction_scale"}},
      {v_normalised_alone, "v normalised and t not", {"generic", "direction_scale"}},
      {origin_ignored, "origin ignored", {"generic"}},
      {axis_flipped, "axis the other way", {"generic"}},
      {axis_is_z, "axis not rotated", {"generic"}},
      {altura_halved, "altura halved", {"generic"}},
      {clip_lower_end_missing, "no lower end", {"generic"}},
      {clip_upper_end_missing, "no upper end", {"generic"}},
      {clip_of_t, "ends compared with t", {"generic"}},
      {clip_narrowed, "ends narrowed by 1e-4", {"rim"}},
      {caps_added, "caps added", {"generic", "inside"}},
      {discs_left_out, "caps missing", {"cap", "disc"}},
      {radius_squared_twice, "radius squared twice", {"generic"}},
      {proportion_inverted, "proportion inverted", {"generic"}},
      {radius_at_other_end, "radius at the other end", {"generic"}},
      {apex_removed, "apex removed", {"near_generator"}},
      {inside_is_a_miss, "inside a miss", {"inside"}},
      {inside_is_at_origin, "inside t = 0", {"inside"}},
      {parallel_to_plane_by_epsilon, "parallel to a plane by 1e-6", {"grazing"}},
      {plane_one_sided, "plane one-sided", {"flat"}},
      {triangle_one_sided, "triangle one-sided", {"edge"}},
      {determinant_by_epsilon, "determinant above 1e-6", {"sliver"}},
      {triangle_edges_narrowed, "triangle narrowed by 1e-2", {"edge"}},
      {disc_is_its_square, "disc its square", {"disc"}},
      {t_by_quotient_of_x, "t as (x − p.x)/v.x", {"axis_parallel"}},
      {sphere_too_small_around, "sphere of altura/2 around", {"generic"}},
      {first_in_order, "first element in order", {"generic"}},
      {last_in_distance, "furthest element", {"generic"}},
      {squares_of_binary32, "squares overflow binary32", {"distance_limit"}},
      {small_numbers_vanish, "sizes below 1e-20 vanish", {"tiny"}},
  };
  return table;
}

}  // namespace durero::test
