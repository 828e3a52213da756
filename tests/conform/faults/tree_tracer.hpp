#pragma once
/// A tracer of triangles by a tree of boxes, as a careful author writes it: the test of a box rounds nothing away. A
/// right one meets the triangles in a style and in numbers; one with a fault by Möller and Trumbore's test in long
/// double.

#include <algorithm>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <map>
#include <numeric>
#include <set>
#include <vector>

#include "conform/faults/triangle_meeting.hpp"
#include "durero/conform/ask/claim.hpp"
#include "durero/scene/scene.hpp"
#include "durero/surface/bounds.hpp"
#include "durero/surface/surfaces.hpp"

namespace durero::test {

class TreeTracer {
 public:
  TreeTracer(const scene::Scene& scene, TreeFault fault) : fault_(fault) { build(scene); }
  TreeTracer(const scene::Scene& scene, TriangleStyle style, TriangleNumbers numbers)
      : fault_(TreeFault::none), style_(style), numbers_(numbers) {
    build(scene);
  }

  /// Rays are asked in order: some faults remember the ray before.
  conform::Claim first_hit(const model::Rayo& rayo) {
    using Outcome = conform::Claim::Outcome;
    nearest_ = {};
    begin(rayo);
    if (root_ != nowhere && !is_kept()) walk();
    ++asked_;
    last_hit_ = nearest_.place;
    if (nearest_.place == nowhere) return {.outcome = Outcome::miss};
    const auto t = static_cast<double>(is(TreeFault::t_as_a_length) ? nearest_.t * glm::length(ray_.v) : nearest_.t);
    return {.outcome = Outcome::hit, .element = scene::ElementRef{scene::Triangle::tipo, number()}, .t = t};
  }

 private:
  static constexpr std::uint32_t nowhere = std::numeric_limits<std::uint32_t>::max();
  static constexpr double infinity = std::numeric_limits<double>::infinity();

  struct Node {
    surface::Box box{};
    std::uint32_t left = nowhere, right = nowhere;  // of an inner node
    std::size_t begin = 0, end = 0, level = 0;      // of a leaf, in order_
    int axis = 0;
  };
  struct Nearest {
    long double t = std::numeric_limits<long double>::infinity();
    std::uint32_t place = nowhere;  // in order_
  };
  /// The stretch of a ray in a box.
  struct Stretch {
    double entry, exit;
  };

  bool is(TreeFault fault) const { return fault_ == fault; }

  // The building.

  void build(const scene::Scene& scene) {
    for (const scene::Triangle triangle : scene.shapes<scene::Triangle>()) triangles_.push_back(triangle.vertices);
    order_.resize(triangles_.size());
    std::iota(order_.begin(), order_.end(), std::uint32_t{0});
    if (order_.empty()) return;
    measure();
    change_triangles();
    if (!order_.empty()) root_ = build(0, order_.size(), 0);
  }

  void measure() {
    surface::Box all = surface::box(scene::Triangle{triangles_[0]});
    for (const scene::Corners& at : triangles_) all = around(all, surface::box(scene::Triangle{at}));
    extent_.middle = 0.5 * (all.low + all.high);
    extent_.size = glm::length(all.high - all.low);
  }
  static surface::Box around(const surface::Box& a, const surface::Box& b) {
    return {glm::min(a.low, b.low), glm::max(a.high, b.high)};
  }

  void change_triangles() {
    using enum TreeFault;
    if (is(small_areas_dropped)) {
      std::erase_if(order_, [&](std::uint32_t i) {
        const scene::Corners& at = triangles_[i];
        return glm::length(glm::cross(at[1] - at[0], at[2] - at[0])) < 2e-10;
      });
    }
    if (is(duplicates_dropped_with_neighbours)) {
      std::set<std::array<double, 6>> seen;
      std::erase_if(order_, [&](std::uint32_t i) {
        const auto& [a, b, c] = triangles_[i];
        return !seen.insert({a.x, a.y, a.z, b.x, b.y, b.z}).second;
      });
    }
    if (!is(vertices_welded_1e_4) && !is(vertices_welded_relatively)) return;
    const double cell = is(vertices_welded_1e_4) ? 1e-4 : 1e-5 * extent_.size;
    for (scene::Corners& at : triangles_) {
      for (glm::dvec3& vertex : at) vertex = cell * glm::round(vertex / cell);
    }
  }

  glm::dvec3 centroid(std::uint32_t triangle) const {
    const auto& [a, b, c] = triangles_[triangle];
    return (a + b + c) / 3.0;
  }

  surface::Box box_of(std::uint32_t triangle) const {
    const auto& [a, b, c] = triangles_[triangle];
    if (is(TreeFault::box_of_centroids)) return {centroid(triangle), centroid(triangle)};
    if (is(TreeFault::box_of_two_vertices)) return {glm::min(a, b), glm::max(a, b)};
    return surface::box(scene::Triangle{triangles_[triangle]});
  }

  /// Of eleven digits, whatever their exponents.
  static glm::dvec3 in_binary16(glm::dvec3 v) {
    for (int i = 0; i < 3; ++i) {
      if (v[i] == 0) continue;
      const int places = 10 - std::ilogb(v[i]);
      v[i] = std::ldexp(std::nearbyint(std::ldexp(v[i], places)), -places);
    }
    return v;
  }

  surface::Box stored(surface::Box box, const surface::Box& of_parent) const {
    const glm::dvec3 size = box.high - box.low;
    if (is(TreeFault::box_shrunk_1e_6)) return {box.low + 1e-6 * size, box.high - 1e-6 * size};
    if (is(TreeFault::box_in_binary16_to_nearest)) return {in_binary16(box.low), in_binary16(box.high)};
    if (is(TreeFault::box_quantised_to_nearest)) {
      const glm::dvec3 step = (of_parent.high - of_parent.low) / 255.0;
      for (int i = 0; i < 3; ++i) {
        if (step[i] == 0) continue;
        box.low[i] = of_parent.low[i] + step[i] * std::round((box.low[i] - of_parent.low[i]) / step[i]);
        box.high[i] = of_parent.low[i] + step[i] * std::round((box.high[i] - of_parent.low[i]) / step[i]);
      }
    }
    return box;
  }

  std::uint32_t build(std::size_t begin, std::size_t end, std::size_t level) {
    using enum TreeFault;
    Node node{.begin = begin, .end = end, .level = level};
    node.box = box_of(order_[begin]);
    surface::Box centroids{centroid(order_[begin]), centroid(order_[begin])};
    for (std::size_t i = begin; i < end; ++i) {
      if (!(is(box_without_the_last) && i + 1 == end)) node.box = around(node.box, box_of(order_[i]));
      centroids = around(centroids, {centroid(order_[i]), centroid(order_[i])});
    }
    const std::uint32_t number = static_cast<std::uint32_t>(nodes_.size());
    nodes_.push_back(node);
    const bool is_cut = is(depth_of_12_then_first_four) && level == 12;
    if (end - begin > most_in_leaf && !is_cut) split(number, centroids);
    return number;
  }

  void split(std::uint32_t number, const surface::Box& centroids) {
    using enum TreeFault;
    const Node node = nodes_[number];
    const glm::dvec3 size = centroids.high - centroids.low;
    const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    const double middle = 0.5 * (centroids.low[axis] + centroids.high[axis]);
    const auto first = order_.begin() + static_cast<std::ptrdiff_t>(node.begin);
    const auto last = order_.begin() + static_cast<std::ptrdiff_t>(node.end);
    auto cut = std::stable_partition(first, last, [&](std::uint32_t i) { return centroid(i)[axis] < middle; });
    std::size_t begin_right = static_cast<std::size_t>(cut - order_.begin());
    const bool is_parted = cut != first && cut != last;
    if (!is_parted && is(leaf_of_8_at_most)) {
      nodes_[number].end = std::min(node.end, node.begin + 8);
      return;
    }
    if (!is_parted) begin_right = node.begin + (node.end - node.begin) / 2;
    const std::size_t end_left = begin_right;
    if (is(centroid_on_the_split_is_lost) && is_parted) {
      while (begin_right + 1 < node.end && centroid(order_[begin_right])[axis] == middle) ++begin_right;
    }
    const std::uint32_t left = build(node.begin, end_left, node.level + 1);
    const std::uint32_t right = build(begin_right, node.end, node.level + 1);
    if (is(box_not_enlarged_for_the_right) && node.level > 2) nodes_[number].box = nodes_[left].box;
    nodes_[number].left = left, nodes_[number].right = right, nodes_[number].axis = axis;
    for (const std::uint32_t child : {left, right}) nodes_[child].box = stored(nodes_[child].box, nodes_[number].box);
  }

  // The walk down the tree.

  void begin(const model::Rayo& rayo) {
    const glm::dvec3 &p = rayo.p().xyz(), &v = rayo.v().xyz();
    p_ = p, v_ = v;
    ray_ = {glm::vec<3, long double>(p), glm::vec<3, long double>(v)};
    for (int i = 0; i < 3; ++i) {
      inverse_[i] = 1 / v[i];
      if (v[i] == 0 && is(TreeFault::box_inverse_of_zero_is_zero)) inverse_[i] = 0;
      if (v[i] == 0 && is(TreeFault::box_inverse_of_zero_is_large)) inverse_[i] = 1e8;
      if (is(TreeFault::box_inverse_is_positive)) inverse_[i] = std::abs(inverse_[i]);
    }
    if (!is(TreeFault::octant_of_the_first_ray) || asked_ % 4 == 0) octant_ = v;
    if (is(TreeFault::tested_for_the_ray_before) && asked_ % 2 == 0) tested_.clear();
  }

  /// Whether the hit is that of the triangle that the ray before hit.
  bool is_kept() {
    if (!is(TreeFault::last_hit_is_kept) || last_hit_ == nowhere) return false;
    test(last_hit_);
    return nearest_.place != nowhere;
  }

  std::optional<Stretch> stretch(const surface::Box& box) const {
    using enum TreeFault;
    if (is(box_flat_is_empty) && (box.low.x == box.high.x || box.low.y == box.high.y || box.low.z == box.high.z))
      return std::nullopt;
    if (is(box_by_products_in_binary32)) return stretch_in_binary32(box);
    Stretch within{0, infinity};
    for (int i = 0; i < 3; ++i) {
      const bool is_parallel = v_[i] == 0 || (is(box_parallel_by_epsilon) && std::abs(v_[i]) < 1e-6 * glm::length(v_));
      if (is_parallel && !computes_with_zeros()) {
        if (p_[i] < box.low[i] || p_[i] > box.high[i] || (is(box_parallel_by_epsilon) && v_[i] != 0))
          return std::nullopt;
        continue;
      }
      double from = (box.low[i] - p_[i]) * inverse_[i], to = (box.high[i] - p_[i]) * inverse_[i];
      if (is(box_nan_is_a_miss) && (std::isnan(from) || std::isnan(to))) return std::nullopt;
      const bool is_negative = is(box_swapped_by_less_than_zero) ? v_[i] < 0
                               : is(octant_of_the_first_ray)     ? std::signbit(octant_[i])
                                                                 : std::signbit(v_[i]);
      if (is_negative && !is(box_unswapped) && !is(box_inverse_is_positive)) std::swap(from, to);
      // A NaN of 0·∞ passes by both.
      if (from > within.entry) within.entry = from;
      if (to < within.exit) within.exit = to;
    }
    const double padded = within.exit * (1 + 0x1p-49);
    const bool is_met = is(box_strict) ? within.entry < within.exit : within.entry <= padded;
    if (!is_met || (is(box_around_origin_is_a_miss) && within.entry <= 0)) return std::nullopt;
    return Stretch{within.entry, padded};
  }
  bool computes_with_zeros() const {
    using enum TreeFault;
    return is(box_nan_is_a_miss) || is(box_swapped_by_less_than_zero) || is(box_inverse_of_zero_is_zero) ||
           is(box_inverse_of_zero_is_large);
  }

  std::optional<Stretch> stretch_in_binary32(const surface::Box& box) const {
    float entry = 0, exit = std::numeric_limits<float>::infinity();
    const glm::vec3 p(p_), v(v_), low(box.low), high(box.high);
    for (int i = 0; i < 3; ++i) {
      if (v[i] == 0) {
        if (p[i] < low[i] || p[i] > high[i]) return std::nullopt;
        continue;
      }
      const float inverse = 1 / v[i];
      float from = low[i] * inverse - p[i] * inverse, to = high[i] * inverse - p[i] * inverse;
      if (v[i] < 0) std::swap(from, to);
      entry = std::max(entry, from), exit = std::min(exit, to);
    }
    if (!(entry <= exit)) return std::nullopt;
    return Stretch{entry, exit};
  }

  bool is_pruned(const Stretch& within) const {
    using enum TreeFault;
    auto limit = static_cast<double>(nearest_.t);
    if (is(box_entry_in_lengths)) limit *= glm::length(v_);
    if (is(box_pruned_by_its_exit)) return within.exit > limit;
    if (is(pruned_before_the_limit)) return within.entry > (1 - 1e-4) * limit;
    return within.entry * (1 - 0x1p-49) > limit;
  }

  std::size_t most_waiting() const {
    using enum TreeFault;
    return is(stack_of_8) ? 8 : is(stack_of_32) ? 32 : is(stack_of_64) ? 64 : triangles_.size() + 1;
  }

  void walk() {
    using enum TreeFault;
    struct Waiting {
      std::uint32_t node;
      Stretch within;
    };
    std::vector<Waiting> waiting;
    if (const auto within = stretch(nodes_[root_].box)) waiting.push_back({root_, *within});
    while (!waiting.empty()) {
      const auto [number, within] = waiting.back();
      waiting.pop_back();
      if (is(last_child_skipped) && waiting.empty() && number != root_ && nearest_.place != nowhere) return;
      if (is_pruned(within)) continue;
      const Node& node = nodes_[number];
      if (is(depth_of_24) && node.level > 24) continue;
      if (node.left == nowhere) {
        if (leaf(node)) return;
        continue;
      }
      auto near = std::pair(node.left, stretch(nodes_[node.left].box));
      auto far = std::pair(node.right, stretch(nodes_[node.right].box));
      if (is(left_child_by_direction_alone) && near.second && far.second && v_[node.axis] > 0) far.second.reset();
      if (near.second && far.second && far.second->entry < near.second->entry) std::swap(near, far);
      if (is(near_child_alone) && near.second && far.second && far.second->entry < near.second->exit)
        far.second.reset();
      if (is(far_child_first_ends_it)) std::swap(near, far);
      for (const auto& [child, stretch_of] : {far, near}) {
        if (stretch_of && waiting.size() < most_waiting()) waiting.push_back({child, *stretch_of});
      }
    }
  }

  /// Tests the triangles of a leaf. Whether the walk is over.
  bool leaf(const Node& node) {
    using enum TreeFault;
    std::size_t end = node.end;
    if (is(leaf_drops_its_last) && end - node.begin > 1) --end;
    if (is(leaf_of_one_is_empty) && end - node.begin == 1) return false;
    if (is(depth_of_12_then_first_four)) end = std::min(end, node.begin + most_in_leaf);
    const Nearest before = nearest_;
    if (is(t_of_the_last_in_a_leaf)) nearest_ = {};
    for (std::size_t i = node.begin; i < end; ++i) test(static_cast<std::uint32_t>(i));
    if (is(t_of_the_last_in_a_leaf) && nearest_.place == nowhere) nearest_ = before;
    const bool is_new = nearest_.place != before.place;
    return is_new && (is(first_leaf_hit_ends_it) || is(far_child_first_ends_it));
  }

  void test(std::uint32_t place) {
    using enum TreeFault;
    const std::uint32_t triangle = order_[place];
    if (is(tested_for_the_ray_before) && !tested_.insert(triangle).second) return;
    const scene::Corners& at = triangles_[triangle];
    std::optional<long double> t;
    if (is(TreeFault::none)) {
      if (const auto met = right_meeting(style_, numbers_, p_, v_, at)) t = *met;
    } else {
      t = meeting(fault_, ray_, at, extent_);
    }
    if (is(limit_of_a_plane_hit)) {
      const long double plane = barycentric(ray_, plain<long double>(at)).t;
      if (!t && plane > 0 && plane < nearest_.t && nearest_.place != nowhere) nearest_.t = plane;
    }
    if (!t) return;
    if (std::isnan(*t)) nearest_ = {*t, place};
    const bool is_nearer = *t < nearest_.t || (is(t_of_the_last_in_a_leaf) && *t > 0);
    if (*t > 0 && is_nearer) nearest_ = {*t, place};
  }

  std::uint32_t number() const {
    using enum TreeFault;
    const std::uint32_t right = order_[nearest_.place];
    if (is(number_in_the_leaves_order)) return nearest_.place;
    if (is(number_after_by_one)) return order_[(nearest_.place + 1) % order_.size()];
    return is(number_in_8_bits) ? right & 0xffU : right;
  }

  static constexpr std::size_t most_in_leaf = 4;

  TreeFault fault_;
  TriangleStyle style_ = TriangleStyle::moller_trumbore;
  TriangleNumbers numbers_ = TriangleNumbers::exact;
  std::vector<scene::Corners> triangles_{};
  std::vector<std::uint32_t> order_{};
  std::vector<Node> nodes_{};
  SceneExtent extent_{};
  std::uint32_t root_ = nowhere;

  glm::dvec3 p_{}, v_{}, inverse_{}, octant_{};
  PlainRay<long double> ray_{};
  Nearest nearest_{};
  std::size_t asked_ = 0;
  std::uint32_t last_hit_ = nowhere;
  std::set<std::uint32_t> tested_{};
};

}  // namespace durero::test
