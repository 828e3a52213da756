#pragma once
/// The points between a few corners, exactly.

#include <array>
#include <glm/vec3.hpp>
#include <optional>
#include <vector>

#include "durero/number/dyadic.hpp"
#include "few_points.hpp"
#include "space_step.hpp"

namespace durero::mesh {

/// The point (x/w, y/w, z/w), exactly; w > 0.
struct RatioPoint {
  number::Dyadic x, y, z, w;

  RatioPoint(number::Dyadic x0, number::Dyadic y0, number::Dyadic z0, number::Dyadic w0)
      : x(std::move(x0)), y(std::move(y0)), z(std::move(z0)), w(std::move(w0)) {}
  /// A point of binary64.
  RatioPoint(const glm::dvec3& p) : x(p.x), y(p.y), z(p.z), w(1) {}

  /// Whether it stands before another by x, then y, then z.
  bool is_before(const RatioPoint& other) const;
  /// Each coordinate rounded to the nearest binary64.
  glm::dvec3 rounded() const;
};

/// The least convex set that has a few points: a triangle, a segment, a point, or nothing. It is what some half-spaces
/// have in common.
class Hull {
 public:
  explicit Hull(FewPoints corners);

  bool contains(const RatioPoint& p) const;
  /// The ends of the part of a segment that is in it; nothing where none is.
  std::optional<std::array<RatioPoint, 2>> part_of(const glm::dvec3& from, const glm::dvec3& to) const;

 private:
  using Step = SpaceStep<number::Dyadic>;
  /// The points p with normal · (p − border) ≥ 0.
  struct HalfSpace {
    Step normal;
    glm::dvec3 border;
  };

  void bound(const Step& normal, const glm::dvec3& border) { bounds_.push_back({normal, border}); }
  void bound_both(const Step& normal, const glm::dvec3& border);
  void bound_point(const glm::dvec3& p);
  void bound_segment(const glm::dvec3& p, const glm::dvec3& q);
  void bound_triangle(const FewPoints& corners);

  bool is_empty_;
  std::vector<HalfSpace> bounds_;
};

}  // namespace durero::mesh
