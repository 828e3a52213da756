#include "conform/judge/text_space.hpp"

#include <algorithm>
#include <cmath>

#include "conform/judge/torus.hpp"
#include "durero/contract/contract.hpp"
#include "durero/io/source.hpp"

namespace durero::conform {
namespace {

using number::Rational;
using surface::exact::order;
using surface::exact::Parameter;
using written::MovedPoints;
using written::MovedStretch;

using Coordinates = std::array<Rational, 3>;

Coordinates coordinates_of(const glm::dvec3& w) { return {number::exact(w.x), number::exact(w.y), number::exact(w.z)}; }

/// A surface and a ray, whose numbers are off.
class MovedRay {
 public:
  MovedRay(const AskedSurface& surface, const model::Rayo& rayo, const Precision& precision)
      : surface_(&surface), rayo_(&rayo), precision_(precision) {
    const Rational least = Allowance(precision, {}, rayo).delta.rational() - number::exact(precision.thickness);
    errors_ = {u(), least};
  }

  /// The points that the ray of some data may have, where s is t − from; nothing where the text does not say.
  std::optional<MovedPoints> from(const Rational& t) const {
    const Coordinates p = coordinates_of(rayo_->p().xyz()), v = coordinates_of(rayo_->v().xyz());
    Coordinates at;
    for (std::size_t axis = 0; axis < at.size(); ++axis) at[axis] = p[axis] + t * v[axis];
    return near(at, v, t);
  }
  /// The points that a place may be, which does not move: s is 0.
  std::optional<MovedPoints> at(const ClaimedPoint& place) const {
    const auto& [x, y, z] = place.punto;
    const Dyadic longest(largest(rayo_->v().xyz()));
    return near({x.rational(), y.rational(), z.rational()}, {}, place.way.rational() / longest.rational());
  }

 private:
  Rational u() const { return number::exact(precision_.error) * number::exact(unit(precision_.format)); }

  /// Errors of a coordinate are 5/4·u·(|p| + t·L), for which t + s stands for t, and the thickness.
  std::optional<MovedPoints> near(const Coordinates& at, const Coordinates& step, const Rational& t) const {
    const Rational share = Rational(5, 4) * u();
    const Rational longest = number::exact(largest(rayo_->v().xyz())), from = number::exact(largest(rayo_->p().xyz()));
    const Rational off = share * (from + t * longest) + number::exact(precision_.thickness) + errors_.least * 2;
    try {
      return surface_->text->moved_points(surface_->type, surface_->values, errors_, {at, step, off, share * longest});
    } catch (const io::InputError&) {
      return std::nullopt;  // which polynomial it is, depends on errors
    }
  }

  const AskedSurface* surface_;
  const model::Rayo* rayo_;
  Precision precision_;
  written::AttributeErrors errors_;
};

/// The parts of a ray that the surface of some data may be met in, found by halving. An answer takes no more than so
/// many evaluations of the text; stretches that it has not halved by then stay whole.
class MeetingSearch {
 public:
  explicit MeetingSearch(const MovedRay& ray, int evaluations) : ray_(&ray), left_(evaluations) {}

  /// visit(stretch) of parts of begin ≤ t ≤ end, ascending, until it returns false; whether none did.
  template <class Visit>
  bool within(const MovedStretch& stretch, int halvings, const Visit& visit) {
    const auto& [begin, end] = stretch;
    const Rational middle = (begin + end) / 2;
    if (left_ > 0) {
      --left_;
      const auto points = ray_->from(middle);
      if (points && !points->may_be_within({begin - middle, end - middle})) return true;
    }
    if (halvings == 0 || left_ <= 0) return visit(stretch);
    return within({begin, middle}, halvings - 1, visit) && within({middle, end}, halvings - 1, visit);
  }

 private:
  const MovedRay* ray_;
  int left_;
};

constexpr int most_evaluations = 400;
/// Halvings that part neighbouring crossings, and those that find the first one.
constexpr int coarse_halvings = 24, fine_halvings = 56;

/// A power of two behind which the surface may not be met, if some tries find one.
struct FarEnd {
  Rational t;
  bool is_certain;
};

double largest_value(const io::WrittenValue& value) {
  if (const auto* const x = std::get_if<double>(&value)) return std::abs(*x);
  if (const auto* const v = std::get_if<glm::dvec3>(&value)) return largest(*v);
  return largest(std::get<scene::Corners>(value));
}

FarEnd far_end(const MovedRay& ray, const AskedSurface& surface, const model::Rayo& rayo) {
  const double size = std::max(largest(rayo.p().xyz()), largest_length(surface));
  int places = 0;
  std::frexp(size == 0 ? 1 : size, &places);
  int way = 0;
  std::frexp(largest(rayo.v().xyz()), &way);
  const auto points = ray.from(0);
  constexpr int tries = 12, step = 4;
  Dyadic t = number::shifted(Dyadic(1), places - way + 2);
  for (int i = 0; i < tries; ++i, t = number::shifted(t, step))
    if (points && !points->may_be_from(t.rational())) return {t.rational(), true};
  return {t.rational(), false};
}

Parameter parameter_of(const Rational& t) {
  // Ends are sums of binary fractions.
  const number::Integer below = denominator(t);
  return {.x = Dyadic(numerator(t), -static_cast<std::int64_t>(msb(below)))};
}

/// A number of binary64 that is no greater than t, nor negative.
Rational below(const Parameter& t) {
  const double rounded = number::round_to_binary64(t);
  return rounded > 0 ? number::exact(std::nextafter(rounded, 0.0)) : Rational(0);
}

/// The zone around a crossing, of which the nearest neighbours are so far away: the ends move apart until all data
/// have a crossing between them.
std::optional<MovedStretch> certain_stretch(const MovedRay& ray, const Rational& t, const Rational& room) {
  const auto points = ray.from(t);
  if (!points) return std::nullopt;
  const double rough = points->rough_reach();
  constexpr int doublings = 40;
  Rational reach = rough > 0 && std::isfinite(rough) ? number::exact(rough) * 2 : Rational(room / 1099511627776);
  for (int i = 0; i < doublings && reach < room; ++i, reach *= 2)
    if (points->is_certain_within({-reach, reach})) return MovedStretch{t - reach, t + reach};
  return std::nullopt;
}

}  // namespace

double largest_length(const AskedSurface& surface) {
  double most = 0;
  for (const io::WrittenValue& value : surface.values) most = std::max(most, largest_value(value));
  return most;
}

Dyadic magnitude(const AskedSurface&, const model::Rayo& rayo, const Dyadic& way) {
  return std::max(Dyadic(largest(rayo.p().xyz())), way);
}

bool may_lie_on(const AskedSurface& surface, const ClaimedPoint& place, const model::Rayo& rayo,
                const Precision& precision) {
  const auto points = MovedRay(surface, rayo, precision).at(place);
  return !points || points->may_be_within({0, 0});
}

std::vector<Zone> zones_of(scene::ElementRef element, const AskedSurface& surface, const model::Rayo& rayo,
                           const Precision& precision) {
  const auto roots = surface.points.parameters(rayo, false, written::RayPart::whole);
  if (!roots) return {};
  const MovedRay ray(surface, rayo, precision);
  std::vector<double> all;
  for (const algebra::Root& root : *roots) all.push_back(number::round_to_binary64(crossing_at(root)));
  std::vector<Zone> found;
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (!(all[i] > 0) || !std::isfinite(all[i])) continue;
    const Rational t = number::exact(all[i]);
    Rational room = t / 2;
    if (i > 0) room = std::min<Rational>(room, (t - number::exact(all[i - 1])) / 2);
    if (i + 1 < all.size() && std::isfinite(all[i + 1]))
      room = std::min<Rational>(room, (number::exact(all[i + 1]) - t) / 2);
    const auto stretch = certain_stretch(ray, t, room);
    if (!stretch) continue;
    const Parameter end = parameter_of(stretch->end);
    const Dyadic M = magnitude(surface, rayo, end.x * Dyadic(largest(rayo.v().xyz())));
    found.push_back({element, parameter_of(stretch->begin), end, Allowance(precision, M, rayo).delta});
  }
  return found;
}

std::vector<ShellStretch> stretches_of(const AskedSurface& surface, const model::Rayo& rayo,
                                       const Precision& precision) {
  const MovedRay ray(surface, rayo, precision);
  const FarEnd far = far_end(ray, surface, rayo);
  std::vector<MovedStretch> parts;
  MeetingSearch(ray, most_evaluations).within({0, far.t}, coarse_halvings, [&](const MovedStretch& part) {
    if (!parts.empty() && parts.back().end == part.begin)
      parts.back().end = part.end;
    else
      parts.push_back(part);
    return true;
  });
  std::vector<ShellStretch> all;
  for (const auto& [begin, end] : parts) {
    const Rational middle = (begin + end) / 2;
    const auto points = ray.from(middle);
    const std::size_t most = points ? points->most_within({begin - middle, end - middle}) : most_meetings_of(surface);
    all.push_back({parameter_of(begin), parameter_of(end), most});
  }
  if (!far.is_certain) all.push_back({parameter_of(far.t), std::nullopt, most_meetings_of(surface)});
  return all;
}

std::optional<Parameter> earliest_of(const AskedSurface& surface, const model::Rayo& rayo, const Precision& precision,
                                     const Parameter& from) {
  const MovedRay ray(surface, rayo, precision);
  const FarEnd far = far_end(ray, surface, rayo);
  const Rational begin = below(from);
  std::optional<Rational> first;
  if (begin < far.t)
    MeetingSearch(ray, most_evaluations).within({begin, far.t}, fine_halvings, [&](const MovedStretch& part) {
      first = part.begin;
      return false;
    });
  if (!first && far.is_certain) return std::nullopt;
  const Parameter t = parameter_of(first ? *first : std::max(begin, far.t));
  return order(t, from) < 0 ? from : t;
}

std::size_t most_meetings_of(const AskedSurface& surface) { return surface.points.degree(); }

double distance_of_surface(const AskedSurface& surface, const Point<Dyadic>& w, const Dyadic& M) {
  return surface.points.distance({w.x, w.y, w.z}) / number::round_to_binary64(M);
}

}  // namespace durero::conform
