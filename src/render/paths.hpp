#pragma once
/// Rays on their way through a scene.

#include <cstdint>
#include <glm/vec3.hpp>
#include <utility>
#include <vector>

#include "durero/scene/query.hpp"
#include "media.hpp"

namespace durero::render {

/// A ray that is followed for one of the asked ones, whose colour its own is added to by a weight.
struct Path {
  std::uint32_t ray;
  glm::dvec3 weight;
  std::uint32_t depth = 1;
  Media media{};
  double way = 0;  ///< how long it is from the eye to where this ray starts
};

/// Paths, and the query of each.
struct Paths {
  std::vector<Path> paths;
  std::vector<scene::Query> queries;  ///< in their order; none of the first ones, which are asked

  /// Of a path, and its query or what that is made of.
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
  /// Precondition: those of a ray stand together.
  bool has_more_of_a_ray_than(std::size_t count) const {
    for (std::size_t i = count; i < paths.size(); ++i)
      if (paths[i].ray == paths[i - count].ray) return true;
    return false;
  }
};

}  // namespace durero::render
