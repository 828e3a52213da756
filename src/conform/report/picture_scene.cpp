#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <glm/geometric.hpp>
#include <limits>
#include <numbers>

#include "conform/report/picture.hpp"
#include "durero/oracle/parametrisation.hpp"

namespace durero::conform {
namespace {

using scene::ElementRef;

constexpr double scene_width = 420, scene_height = 320;

struct PlanePoint {
  double x, y;
};

/// The oblique projection of a point from above, in which no coordinate axis shrinks to a point.
PlanePoint projected(const glm::dvec3& p) { return {0.8 * p.x - 0.6 * p.y, p.z * 0.9 + 0.26 * p.x + 0.35 * p.y}; }

/// The frame of a drawing: a rectangle around the points to show.
class Viewport {
 public:
  void include(const glm::dvec3& p) {
    const PlanePoint at = projected(p);
    if (!std::isfinite(at.x) || !std::isfinite(at.y)) return;
    low_ = {std::min(low_.x, at.x), std::min(low_.y, at.y)};
    high_ = {std::max(high_.x, at.x), std::max(high_.y, at.y)};
  }
  double size() const { return std::max({high_.x - low_.x, high_.y - low_.y, std::numeric_limits<double>::min()}); }
  /// A place on the picture; far outside it where the point is.
  PlanePoint place(const glm::dvec3& p) const {
    const PlanePoint at = projected(p);
    const double scale = 0.8 * std::min(scene_width, scene_height) / size();
    const auto clamped = [](double x) { return std::clamp(x, -10 * scene_width, 10 * scene_width); };
    return {clamped(scene_width / 2 + (at.x - (low_.x + high_.x) / 2) * scale),
            clamped(scene_height / 2 - (at.y - (low_.y + high_.y) / 2) * scale)};
  }

 private:
  static constexpr double infinity = std::numeric_limits<double>::infinity();
  PlanePoint low_{infinity, infinity}, high_{-infinity, -infinity};
};

/// A surface as points by u and v from 0 to 1.
struct DrawnSurface {
  std::function<glm::dvec3(double u, double v)> point;
  glm::dvec3 center;
  bool is_patch;
};

/// The point of a body in a direction of the unit ball that its sides span.
glm::dvec3 body_point(const AskedBody& body, const glm::dvec3& direction) {
  const auto at = [&](const glm::dvec3& w) {
    return body.centro + w.x * body.sides[0] + w.y * body.sides[1] + w.z * body.sides[2];
  };
  switch (body.kind) {
    case BodyKind::caja:
    case BodyKind::copia_caja:
      return at(direction / std::max({std::abs(direction.x), std::abs(direction.y), std::abs(direction.z)}));
    case BodyKind::campo:
      break;
    case BodyKind::toro: {  // around the ring by u and v alike
      const double ratio = body.radio / length_of(body.sides[0]), turn = std::numbers::pi * direction.y;
      const double wide = 1 + ratio * std::cos(turn);
      const double high = body.radio * std::sin(turn) / length_of(body.sides[1]);
      return at({wide * direction.x, high, wide * direction.z});
    }
    case BodyKind::caja_redonda: {  // the point of the box, and farther out by the radius
      const glm::dvec3 out = direction.x / length_of(body.sides[0]) * body.sides[0] +
                             direction.y / length_of(body.sides[1]) * body.sides[1] +
                             direction.z / length_of(body.sides[2]) * body.sides[2];
      return at(direction / std::max({std::abs(direction.x), std::abs(direction.y), std::abs(direction.z)})) +
             body.radio * out;
    }
    case BodyKind::elipsoide:
    case BodyKind::copia_esfera:
      return at(direction);
    case BodyKind::capsula: {
      const double ratio = length_of(body.sides[0]) / length_of(body.sides[1]);
      const double along = direction.y == 0 ? 0 : std::copysign(1, direction.y);
      return at({direction.x, along + ratio * direction.y, direction.z});
    }
  }
  contract::unreachable();
}

DrawnSurface surface_of(const SuiteCase& of, ElementRef e) {
  if (const AskedBody* const body = find_body(of.bodies, e)) {
    const auto point = [body = *body](double u, double v) {
      const double turn = 2 * std::numbers::pi * v, height = 2 * u - 1;
      const double wide = body.kind == BodyKind::toro ? 1 : std::sqrt(1 - height * height);  // a ring has no poles
      return body_point(body, {wide * std::cos(turn), height, wide * std::sin(turn)});
    };
    return {point, body->centro, false};
  }
  return of.the_case.scene.visit(e, [](const auto& shape) -> DrawnSurface {
    const oracle::Parametrisation surface(shape);
    return {[surface](double u, double v) { return surface.point(u, v); }, surface.center(), surface.is_patch()};
  });
}

/// A line of equal u or v of a surface, as points.
template <class Point>
std::string line_svg(const Viewport& frame, Point point) {
  constexpr int pieces = 48;
  std::string points;
  for (int i = 0; i <= pieces; ++i) {
    const PlanePoint at = frame.place(point(double(i) / pieces));
    points += fmt::format("{:.1f},{:.1f} ", at.x, at.y);
  }
  points.pop_back();
  return fmt::format("<polyline class=\"element\" points=\"{}\"/>\n", points);
}

std::string element_svg(const Viewport& frame, const DrawnSurface& surface) {
  std::string svg;
  for (const double u : {0.0, 0.25, 0.5, 0.75, 1.0})
    svg += line_svg(frame, [&](double v) { return surface.point(u, v); });
  for (int i = 0; i < 8; ++i) svg += line_svg(frame, [&](double u) { return surface.point(u, i / 8.0); });
  return svg;
}

/// The elements that a failing ray hits or is claimed to hit; all where there is none.
std::vector<ElementRef> elements_shown(const JudgedCase& judged) {
  std::vector<ElementRef> shown;
  for (std::size_t ray = 0; ray < judged.claims.size(); ++ray) {
    if (!is_failure(judged.judgements[ray].verdict)) continue;
    const scene::ElementSet& hit = judged.of.truths[ray].hit.elementos;
    shown.insert(shown.end(), hit.begin(), hit.end());
    if (judged.claims[ray].element) shown.push_back(*judged.claims[ray].element);
  }
  if (shown.empty()) judged.of.the_case.scene.for_each([&](ElementRef e, const auto&) { shown.push_back(e); });
  return shown;
}

Viewport frame_of(const JudgedCase& judged) {
  Viewport frame;
  for (const ElementRef e : elements_shown(judged)) {
    const DrawnSurface surface = surface_of(judged.of, e);
    if (surface.is_patch) continue;
    for (const double u : {0.0, 0.5, 1.0})
      for (int i = 0; i < 8; ++i) frame.include(surface.point(u, i / 8.0));
  }
  for (std::size_t ray = 0; ray < judged.claims.size(); ++ray) {
    const scene::Hit& hit = judged.of.truths[ray].hit;
    if (is_failure(judged.judgements[ray].verdict) && hit.resultado == model::Resultado::hit) frame.include(hit.punto);
  }
  return frame;
}

/// The point at which a ray should hit; without a hit, the point where it passes nearest to the middle of the frame.
glm::dvec3 shown_point(const scene::Query& ray, const scene::Hit& hit, const glm::dvec3& middle) {
  if (hit.resultado == model::Resultado::hit) return hit.punto;
  const glm::dvec3 p = ray.rayo.p().xyz(), v = glm::normalize(ray.rayo.v().xyz());
  return p + std::max(0.0, glm::dot(middle - p, v)) * v;
}

std::string ray_svg(const Viewport& frame, const scene::Query& ray, const glm::dvec3& point, Verdict verdict) {
  std::string svg;
  const PlanePoint at = frame.place(point);
  if (is_failure(verdict)) {
    const glm::dvec3 p = ray.rayo.p().xyz(), way = point - p;
    const double length = glm::length(way), shown = std::min(length, frame.size() / 3);
    const PlanePoint from = frame.place(length > 0 ? point - way * (shown / length) : p);
    svg += fmt::format("<line class=\"ray\" x1=\"{:.1f}\" y1=\"{:.1f}\" x2=\"{:.1f}\" y2=\"{:.1f}\" stroke=\"{}\"/>\n",
                       from.x, from.y, at.x, at.y, colour(verdict));
  }
  return svg +
         fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"2.5\" fill=\"{}\"/>\n", at.x, at.y, colour(verdict));
}

}  // namespace

std::string scene_svg(const JudgedCase& judged) {
  const scene::Scene& scene = judged.of.the_case.scene;
  const Viewport frame = frame_of(judged);
  std::string svg = fmt::format("<svg viewBox=\"0 0 {} {}\" role=\"img\">\n", scene_width, scene_height);
  const std::vector<ElementRef> shown = elements_shown(judged);
  // Of a mesh, which would cover the page, only what the failing rays are about.
  constexpr std::size_t most_drawn = 200;
  if (scene.size() > most_drawn) {
    for (const ElementRef e : std::span(shown).first(std::min(most_drawn, shown.size())))
      svg += element_svg(frame, surface_of(judged.of, e));
  } else {
    scene.for_each([&](ElementRef e, const auto&) { svg += element_svg(frame, surface_of(judged.of, e)); });
  }
  const glm::dvec3 middle = surface_of(judged.of, shown.front()).center;
  for (const bool failing : {false, true}) {  // failing rays are drawn over the others
    for (std::size_t ray = 0; ray < judged.claims.size(); ++ray) {
      const Verdict verdict = judged.judgements[ray].verdict;
      if (is_failure(verdict) != failing || verdict == Verdict::skipped) continue;
      const scene::Query& query = judged.of.the_case.rays[ray];
      svg += ray_svg(frame, query, shown_point(query, judged.of.truths[ray].hit, middle), verdict);
    }
  }
  return svg + "</svg>\n";
}

}  // namespace durero::conform
