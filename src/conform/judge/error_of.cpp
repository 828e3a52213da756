#include "conform/judge/error_of.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "conform/judge/body_space.hpp"
#include "conform/judge/shell.hpp"
#include "conform/judge/text_space.hpp"
#include "durero/number/quotient.hpp"
#include "durero/surface/normal.hpp"
#include "durero/surface/surfaces.hpp"

namespace durero::conform {
namespace {

using surface::Point;

constexpr double infinity = std::numeric_limits<double>::infinity();

Point<Dyadic> exactly_at(const glm::dvec3& a) { return {a.x, a.y, a.z}; }

/// The square of a shape's size; the square of the way to it stands for that of a plane, which has none.
template <class Shape>
Dyadic squared_size(const Shape& shape, const Dyadic& squared_way) {
  if constexpr (std::is_same_v<Shape, scene::Plane>) {
    return squared_way;
  } else if constexpr (std::is_same_v<Shape, scene::Triangle>) {
    const auto& [a, b, c] = shape.vertices;
    const auto edge = [](const glm::dvec3& x, const glm::dvec3& y) { return squared_length(from(x, exactly_at(y))); };
    return std::max({edge(a, b), edge(b, c), edge(c, a)});
  } else if constexpr (surface::Axial<Shape>) {
    return std::max(square(Dyadic(shape.altura)), square(radius_at_centre(shape)));
  } else {
    return square(Dyadic(shape.radio));
  }
}

Dyadic squared_size(const AskedBody& body, const Dyadic&) { return squared_size_of_body(body); }
double distance(const AskedBody& body, const Point<Dyadic>& w, const Dyadic& M) { return distance_of_body(body, w, M); }

/// The square of the way to a surface of a text stands for that of its size, which nobody says.
Dyadic squared_size(const AskedSurface&, const Dyadic& squared_way) { return squared_way; }
double distance(const AskedSurface& surface, const Point<Dyadic>& w, const Dyadic& M) {
  return distance_of_surface(surface, w, M);
}

/// Whether a distance, given by its square, is at most 0.001 of the shape's size.
template <class Shape>
bool is_small(const Dyadic& squared, const Shape& shape, const Dyadic& squared_way) {
  return squared * Dyadic(1e6) <= squared_size(shape, squared_way);
}

/// The quotient a/b, rounded once to binary64.
double ratio(const Dyadic& a, const Dyadic& b) { return number::round_quotient(a, b); }

// The functions below return the distance of a point from a surface in units of M, up to a few roundings of binary64:
// the potencia before them is exact.

/// The difference | √a² − b | in units of M, from a difference of squares and so without cancellation.
double apart(const Dyadic& squared_a, const Dyadic& b, const Dyadic& M) {
  const double difference = ratio(squared_a - square(b), square(M));
  const double sum = std::sqrt(ratio(squared_a, square(M))) + std::abs(ratio(b, M));
  return sum == 0 ? 0 : std::abs(difference) / sum;
}

double distance(const scene::Sphere& e, const Point<Dyadic>& w, const Dyadic& M) {
  return apart(squared_length(from(e.centro, w)), e.radio, M);
}

/// The distance of a point from a shape with an axis: from the surface itself, or from the end that the point is
/// beyond.
template <surface::Axial Shape>
double distance(const Shape& e, const Point<Dyadic>& w, const Dyadic& M) {
  const Dyadic s = avance(e, w), k(proportion(e));
  const double across = apart(alejamiento(e, w), radius_at_centre(e) - k * s, M) / std::hypot(1, proportion(e));
  return std::max({across, ratio(-s, M), ratio(s - Dyadic(e.altura), M)});
}

double distance(const scene::Plane& e, const Point<Dyadic>& w, const Dyadic& M) {
  return std::abs(ratio(potencia(e, w), M));
}

double distance(const scene::Disc& e, const Point<Dyadic>& w, const Dyadic& M) {
  const Dyadic squared = squared_length(from(e.centro, w)), value = potencia(e, w);
  const bool is_beyond = squared - square(value) > square(Dyadic(e.radio));
  return std::max(std::abs(ratio(value, M)), is_beyond ? apart(squared - square(value), e.radio, M) : 0);
}

/// The distance of a point from a triangle: from its plane, or from the line of the edge that the point is furthest
/// beyond.
double distance(const scene::Triangle& e, const Point<Dyadic>& w, const Dyadic& M) {
  const auto& [a, b, c] = e.vertices;
  const Point<Dyadic> normal = cross(surface::between<Dyadic>(a, b), surface::between<Dyadic>(a, c));
  const auto along = [&](const glm::dvec3& begin, const Point<Dyadic>& n) {
    return ratio(dot(from(begin, w), n), M * length_above(n));
  };
  double furthest = std::abs(along(a, normal));
  for (const auto& [begin, end] : {std::pair(a, b), std::pair(b, c), std::pair(c, a)})
    furthest = std::max(furthest, along(begin, cross(surface::between<Dyadic>(begin, end), normal)));
  return furthest;
}

/// The distance from a number of the format to the next, away from 0.
double last_place(double x, NumberFormat format) {
  const double magnitude = std::abs(x);
  if (format == NumberFormat::binary64) return std::nextafter(magnitude, infinity) - magnitude;
  const auto narrow = static_cast<float>(magnitude);
  return static_cast<double>(std::nextafter(narrow, std::numeric_limits<float>::infinity())) -
         static_cast<double>(narrow);
}

}  // namespace

bool is_far(const ClaimContext& trial, const ClaimedPoint& place) {
  const model::Rayo& rayo = trial.ray.rayo;
  const scene::Hit& hit = trial.truth.hit;
  if (!std::isfinite(hit.t)) return true;
  const Dyadic t = hit.t;
  const glm::dvec3 &p = rayo.p().xyz(), &v = rayo.v().xyz();
  const auto coordinate = [&](double from, double step) { return Dyadic(from) + t * Dyadic(step); };
  const Point<Dyadic> right{coordinate(p.x, v.x), coordinate(p.y, v.y), coordinate(p.z, v.z)}, &w = place.punto;
  const Dyadic squared = squared_length(Point<Dyadic>{w.x - right.x, w.y - right.y, w.z - right.z});
  const Dyadic squared_way = square(t) * squared_length(exactly_at(v));
  return std::none_of(hit.elementos.begin(), hit.elementos.end(), [&](scene::ElementRef element) {
    return trial.elements().visit_plain(element,
                                        [&](const auto& shape) { return is_small(squared, shape, squared_way); });
  });
}

bool is_near_surface(const ClaimContext& trial, const ClaimedPoint& place, scene::ElementRef element) {
  const Dyadic squared_way = square(place.way);
  return trial.elements().visit_plain(element, [&](const auto& shape) {
    const Dyadic M = magnitude(shape, trial.ray.rayo, place.way);
    const double apart = number::sign(M) == 0 ? 0 : distance(shape, place.punto, M);
    return std::isfinite(apart) && is_small(square(Dyadic(apart) * M), shape, squared_way);
  });
}

bool is_near_origin(const ClaimContext& trial, const ClaimedPoint& place, scene::ElementRef element) {
  const Dyadic squared = squared_length(from(trial.ray.rayo.p().xyz(), place.punto)), squared_way = square(place.way);
  return trial.elements().visit_plain(element,
                                      [&](const auto& shape) { return is_small(squared, shape, squared_way); });
}

double error_in_ulps(double claimed, double right, NumberFormat format) {
  right = rounded(right, format);
  return std::isfinite(right) ? std::abs(claimed - right) / last_place(right, format) : infinity;
}

double ulps(const ClaimContext& trial, const Claim& claim, const ClaimedPoint& place) {
  if (!trial.has_hit()) return 0;
  const NumberFormat format = trial.profile.format;
  if (!place.given) {
    const glm::dvec3& right = trial.truth.hit.punto;
    return largest(*claim.punto - right) / last_place(largest(right), format);
  }
  return error_in_ulps(*claim.t, number_of_truth(trial), format);
}

double backward_error(const ClaimContext& trial, const Claim& claim, const ClaimedPoint& place) {
  double least_distance = infinity;
  trial.any_named(claim, [&](scene::ElementRef element) {
    trial.elements().visit_plain(element, [&](const auto& shape) {
      const Dyadic M = magnitude(shape, trial.ray.rayo, place.way);
      if (number::sign(M) != 0) least_distance = std::min(least_distance, distance(shape, place.punto, M));
    });
    return false;
  });
  return least_distance / unit(trial.profile.format);
}

double backward_error_near_truth(const ClaimContext& trial, const Claim& claim, const ClaimedPoint& place) {
  const scene::Hit& hit = trial.truth.hit;
  const glm::dvec3 &p = trial.ray.rayo.p().xyz(), &v = trial.ray.rayo.v().xyz();
  const glm::dvec3 way = place.given ? (*place.given - hit.t) * v : *claim.punto - hit.punto;
  const auto element = std::find_if(hit.elementos.begin(), hit.elementos.end(),
                                    [&](scene::ElementRef candidate) { return trial.names(claim, candidate); });
  if (trial.elements().body(*element) || trial.elements().surface(*element)) return backward_error(trial, claim, place);
  const double length = trial.scene.visit(*element, [](const auto& shape) { return largest_length(shape); });
  const double M = std::max({length, largest(p), hit.t * largest(v)});
  const double across = std::abs(glm::dot(way, surface::normal(trial.scene, *element, hit.punto))) / M;
  return std::isfinite(across) ? across / unit(trial.profile.format) : backward_error(trial, claim, place);
}

}  // namespace durero::conform
