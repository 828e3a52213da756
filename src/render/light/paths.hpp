#pragma once
/// A path is a ray on its way through a scene.

#include <cstdint>
#include <glm/vec3.hpp>
#include <utility>
#include <vector>

#include "durero/scene/query.hpp"
#include "media.hpp"

namespace durero::render {

/// A ray that is followed for one of the rays asked for: its colour, times a weight, is added to that ray's.
struct Path {
  std::uint32_t ray;
  glm::dvec3 weight;
  std::uint32_t depth = 1;
  Media media{};
  double way = 0;            ///< the length from the eye to the start of this ray
  std::uint64_t branch = 1;  ///< the turns that led here, in binary: 0 for a mirror, 1 for what lies behind
};

/// Paths with a query each.
struct Paths {
  std::vector<Path> paths;
  std::vector<scene::Query> queries;  ///< one for each path, but none for the rays asked for

  /// Adds a path, and its query or the query's parts.
  template <class... Of>
  void push(Path path, Of&&... query) {
    paths.push_back(std::move(path));
    queries.emplace_back(std::forward<Of>(query)...);
  }
  void clear() {
    paths.clear();
    queries.clear();
  }
  void shorten(std::size_t size) {
    paths.erase(paths.begin() + static_cast<std::ptrdiff_t>(size), paths.end());
    queries.erase(queries.begin() + static_cast<std::ptrdiff_t>(size), queries.end());
  }
  /// Whether some ray has more than `count` paths. Precondition: the paths of a ray stand together.
  bool has_more_of_a_ray_than(std::size_t count) const {
    for (std::size_t i = count; i < paths.size(); ++i)
      if (paths[i].ray == paths[i - count].ray) return true;
    return false;
  }
};

}  // namespace durero::render
