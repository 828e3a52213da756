#pragma once
/// A path is a ray on its way through a scene.

#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

#include "durero/model/tipos.hpp"
#include "durero/scene/element_ref.hpp"
#include "nestings.hpp"
#include "query_pool.hpp"

namespace durero::render {

/// A ray that is followed for one of the rays asked for: its colour, times a weight, is added to that ray's.
struct Path {
  std::uint32_t ray;
  std::uint32_t depth = 1;
  std::uint32_t media = Nestings::open;  ///< the nesting that it is in
  glm::dvec3 weight{1};
  double way = 0;            ///< the length from the eye to the start of this ray
  std::uint64_t branch = 1;  ///< the turns that led here, in binary: 0 for a mirror, 1 for what lies behind
};

/// Paths with a query each. The paths of a ray stand together, and the rays ascend.
struct Paths {
  std::vector<Path> paths;
  QueryPool queries;  ///< one for each path, but none for the rays asked for

  /// Adds a path and its query.
  void push(const Path& path, const model::Rayo& ray, const scene::ElementSet& en) {
    paths.push_back(path);
    queries.push(ray, en);
  }
  /// Adds the paths begin … end of others.
  void push(const Paths& others, std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) push(others.paths[i], others.queries[i].rayo, others.queries[i].en);
  }
  void clear() { shorten(0); }
  void shorten(std::size_t size) {
    paths.erase(paths.begin() + static_cast<std::ptrdiff_t>(size), paths.end());
    queries.shorten(size);
  }
  /// The end of the paths of a ray, which begin there.
  std::size_t end_of(std::uint32_t ray, std::size_t begin) const {
    while (begin < paths.size() && paths[begin].ray == ray) ++begin;
    return begin;
  }
  /// Whether some ray has more than `count` paths.
  bool has_more_of_a_ray_than(std::size_t count) const {
    for (std::size_t i = count; i < paths.size(); ++i)
      if (paths[i].ray == paths[i - count].ray) return true;
    return false;
  }
};

}  // namespace durero::render
