#include "placed_surface.hpp"

#include <glm/geometric.hpp>

namespace durero::oracle {

PlacedSurface::PlacedSurface(const Parametrisation& original, const Placement& by, double off)
    : original_(original), by_(by), off_(off) {}

double PlacedSurface::around_within(double u, double way) const {
  return by_.most() * original_.around_within(u, way / by_.least());
}

// A path in the original becomes at least `least` times as long, so the edge is that far. Along a path with the unit
// velocity x' and the acceleration x'' the copy has the normal curvature n·x''/(|m⁻ᵀn|·|m·x'|²), with |m⁻ᵀn| ≥ 1/most.
SurfacePoint PlacedSurface::at(double u, double v) const {
  const SurfacePoint there = original_.at(u, v);
  const double least = by_.least();
  return {by_.point(there.point), by_.normal(there.normal), least * there.edge,
          there.curvature * (by_.most() / least) / least};
}

/// The map's own rounding, beside that of the original.
double PlacedSurface::moved_rounding() const noexcept {
  return by_.most() * off_ + by_.rounding(glm::length(original_.center()) + original_.size());
}

double PlacedSurface::rounding() const noexcept { return by_.most() * original_.rounding() + moved_rounding(); }

bool PlacedSurface::goes_on_at(const glm::dvec3& point, double slack) const {
  return original_.is_patch() &&
         glm::length(by_.original(point) - original_.center()) + slack / by_.least() > original_.widest();
}

void PlacedSurface::place(BallNode& ball) const {
  ball.center = by_.point(ball.center);
  ball.radius = by_.most() * ball.radius + moved_rounding();
}

CoverPlan PlacedSurface::outline(double fineness) const {
  CoverPlan plan = oracle::outline(original_, fineness);
  place(plan.ball);
  plan.delta = by_.most() * plan.delta + moved_rounding();
  return plan;
}

Cover PlacedSurface::cover(double fineness) const {
  Cover cover = oracle::cover(original_, fineness);
  for (glm::dvec3& sample : cover.samples) sample = by_.point(sample);
  for (BallNode& ball : cover.balls) place(ball);
  cover.delta = by_.most() * cover.delta + moved_rounding();
  return cover;
}

}  // namespace durero::oracle
