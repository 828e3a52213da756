#pragma once
/// What a right tracer meets on a ray: its data, and every crossing of them, by exact arithmetic.

#include <array>
#include <glm/geometric.hpp>
#include <map>

#include "durero/composed/figure.hpp"
#include "durero/number/quotient.hpp"
#include "right_torus.hpp"
#include "right_tracers.hpp"

namespace durero::test {

/// One ray of a case for one tracer. Draws what it moves from the stream.
class RightTrace {
 public:
  RightTrace(const RightTracer& tracer, const conform::SuiteCase& of, std::size_t ray, conform::Random& random)
      : tracer_(&tracer),
        of_(&of),
        rayo_(of.the_case.rays[ray].rayo),
        mover_(random, tracer.profile.format, tracer.draw, tracer.profile.thickness, tracer.profile.error) {}

  /// In no order; nothing where a draw left no element or ray.
  std::optional<std::vector<Met>> all_met() {
    if (moves_meshes()) move_mesh();
    of_->the_case.scene.for_each([&](scene::ElementRef e, const auto& shape) {
      if (!is_whole_ || is_left_out(e)) return;
      const conform::AskedBody* const body = conform::find_body(of_->bodies, e);
      if (body)
        meet_body(e, *body);
      else
        meet(e, shape);
    });
    return is_whole_ ? std::optional(std::move(all_)) : std::nullopt;
  }

 private:
  template <class Shape>
  struct Computed {
    Shape shape;
    model::Rayo rayo;
  };

  bool has_solids() const { return tracer_->profile.caps == conform::Caps::solid; }
  bool moves_meshes() const { return tracer_->profile.watertight && tracer_->data == Data::moved; }

  /// A disc that closes a solid is none of the question's.
  bool is_left_out(scene::ElementRef e) const {
    return has_solids() && std::any_of(of_->solids.begin(), of_->solids.end(), [&](const conform::Solid& solid) {
             return std::find(solid.discs.begin(), solid.discs.end(), e) != solid.discs.end();
           });
  }

  void meet_body(scene::ElementRef e, const conform::AskedBody& body) {
    if (body.kind == conform::BodyKind::toro) {
      const auto all = torus_crossings(body, rayo_);
      return meet_near(e, body, all.empty() ? 0 : 0.99 * number::round_to_binary64(all.front()));
    }
    const auto given = composed::figure(conform::exact_body(body))->first(rayo_, false).t;
    meet_near(e, body, given ? 0.99 * number::round_to_binary64(*given) : 0);
  }

  template <class Shape>
  void meet(scene::ElementRef e, const Shape& shape) {
    if constexpr (std::is_same_v<Shape, scene::Triangle>) {
      if (moves_meshes()) return take(e, Computed<Shape>{triangle_of_mesh(shape), rayo_of_mesh_.value()});
    }
    const surface::exact::Reach given = surface::exact::reach(shape, rayo_);
    meet_near(e, shape, given.empty() || given.no_minimum() ? 0 : 0.99 * number::round_to_binary64(given.first()));
  }

  /// Where the ray of the data given meets it a little behind t.
  template <class Shape>
  void meet_near(scene::ElementRef e, const Shape& shape, double t) {
    const std::size_t before = all_.size();
    take(e, computed(shape, std::isfinite(t) ? t : 0));
    // M was of that distance: an answer before it may be off by less.
    const bool is_before = std::any_of(all_.begin() + static_cast<std::ptrdiff_t>(before), all_.end(),
                                       [&](const Met& met) { return met.parameter() < t; });
    if (!is_before || tracer_->data != Data::moved) return;
    all_.erase(all_.begin() + static_cast<std::ptrdiff_t>(before), all_.end());
    take(e, computed(shape, 0));
  }

  /// What the tracer computes with, where t·v may be as far as that.
  template <class Shape>
  Computed<Shape> computed(const Shape& shape, double t) {
    const glm::dvec3 &p = rayo_.p().xyz(), &v = rayo_.v().xyz();
    const double M = std::max({longest(shape), longest(p), t * longest(v)});
    switch (tracer_->data) {
      case Data::given:
        return checked(shape, p, direction());
      case Data::rounded:
        return checked(rounded(shape), rounded(p), direction());
      case Data::ends:
        return checked(by_ends(shape, M), rounded(p), direction());
      case Data::moved: {
        const Shape moved = mover_.moved(shape, M);
        const glm::dvec3 from = mover_.moved_point(p, M);
        return checked(moved, from, mover_.moved_direction(v));
      }
    }
    throw std::logic_error("no such data");
  }

  template <class Shape>
  Computed<Shape> checked(const Shape& shape, const glm::dvec3& p, const glm::dvec3& v) {
    is_whole_ = is_whole_ && is_shape(shape) && is_ray(p, v);
    return is_whole_ ? Computed<Shape>{shape, ray(p, v)} : Computed<Shape>{shape, rayo_};
  }

  static bool is_ray(const glm::dvec3& p, const glm::dvec3& v) {
    return std::isfinite(longest(p)) && std::isfinite(longest(v)) && v != glm::dvec3(0);
  }

  template <class T>
  T rounded(const T& x) const {
    return narrowed(x, tracer_->profile.format);
  }

  /// v, or v/|v| times |v|, with the roundings of both.
  glm::dvec3 direction() const {
    const glm::dvec3 v = tracer_->data == Data::given ? rayo_.v().xyz() : rounded(rayo_.v().xyz());
    const double length = rounded(length_of(1, v));
    const bool is_possible = tracer_->makes_unit && length > 0 && std::isfinite(length);
    return is_possible ? rounded(v / length) * length : v;
  }

  /// Where the ends are so far apart that their roundings are small against the unit vector.
  template <class Shape>
  Shape by_ends(const Shape& shape, double M) const {
    const Shape plain = rounded(shape);
    if constexpr (requires { shape.altura; }) {
      const double most = 0.875 * (tracer_->profile.format == conform::NumberFormat::binary32 ? 0x1p-20 : 0x1p-49);
      Shape result = plain;
      const glm::dvec3 along = rounded(shape.centro + shape.altura * shape.vector) - result.centro;
      result.altura = length_of(1, along);
      result.vector = along / result.altura;
      const bool is_near = std::abs(result.altura - shape.altura) <= most * M &&
                           longest(result.vector - shape.vector) <= most && result.altura > 0;
      return is_near ? result : plain;
    }
    return plain;
  }

  using Key = std::array<double, 3>;
  static Key key(const glm::dvec3& vertex) { return {vertex.x, vertex.y, vertex.z}; }

  /// Vertices that triangles share move together, as far as each of its triangles allows; the ray is one for all.
  void move_mesh() {
    const glm::dvec3 &p = rayo_.p().xyz(), &v = rayo_.v().xyz();
    std::map<Key, double> allowed;
    double least = std::numeric_limits<double>::infinity();
    for (const scene::Triangle& triangle : of_->the_case.scene.shapes<scene::Triangle>()) {
      const double M = std::max(longest(triangle), longest(p));
      least = std::min(least, M);
      for (const glm::dvec3& vertex : triangle.vertices) {
        double& most = allowed.try_emplace(key(vertex), M).first->second;
        most = std::min(most, M);
      }
    }
    for (const auto& [vertex, M] : allowed)
      vertices_[vertex] = mover_.moved_point({vertex[0], vertex[1], vertex[2]}, M);
    if (allowed.empty()) return;
    const glm::dvec3 from = mover_.moved_point(p, least), along = mover_.moved_direction(v);
    is_whole_ = is_whole_ && is_ray(from, along);
    rayo_of_mesh_ = is_whole_ ? ray(from, along) : rayo_;
  }
  scene::Triangle triangle_of_mesh(const scene::Triangle& given) {
    const auto& [a, b, c] = given.vertices;
    const scene::Triangle moved{{vertices_.at(key(a)), vertices_.at(key(b)), vertices_.at(key(c))}};
    is_whole_ = is_whole_ && is_shape(moved);
    return is_whole_ ? moved : given;
  }

  template <class Shape>
  void take(scene::ElementRef e, const Computed<Shape>& of) {
    if (!is_whole_) return;
    const bool is_half_space = std::is_same_v<Shape, scene::Plane> && tracer_->profile.half_spaces;
    const bool has_inside = std::is_same_v<Shape, scene::Sphere> || is_half_space || is_closed(*tracer_, *of_, e);
    if (has_inside && starts_inside(of)) {
      const conform::Inside inside = tracer_->profile.inside;
      if (inside == conform::Inside::nothing) return;
      if (inside == conform::Inside::origin) all_.push_back({e, of.rayo, {}});
    }
    add(e, of.shape, of.rayo);
    if constexpr (requires { of.shape.altura; }) {
      if (is_closed(*tracer_, *of_, e)) add_discs(e, of);
    }
  }

  /// A body is met where its surface is, which is closed.
  void take(scene::ElementRef e, const Computed<conform::AskedBody>& of) {
    if (!is_whole_) return;
    if (of.shape.kind == conform::BodyKind::toro) return take_torus(e, of);
    const auto figure = composed::figure(conform::exact_body(of.shape));
    const auto whole = surface::exact::RayStretch::whole;
    const auto ahead = figure->parameters(of.rayo, false, whole);
    const auto behind = figure->parameters({of.rayo.p(), model::Vector(-of.rayo.v().xyz())}, false, whole);
    const bool is_inside = ahead && behind && ahead->size() == 1 && behind->size() == 1;
    const conform::Inside inside = tracer_->profile.inside;
    if (is_inside && inside == conform::Inside::nothing) return;
    if (is_inside && inside == conform::Inside::origin) all_.push_back({e, of.rayo, {}});
    if (ahead) {
      for (const Parameter& t : *ahead) all_.push_back({e, of.rayo, t});
    } else {
      all_.push_back({e, of.rayo, figure->first(of.rayo, false).t});
    }
  }

  void take_torus(scene::ElementRef e, const Computed<conform::AskedBody>& of) {
    const glm::dvec3& p = of.rayo.p().xyz();
    const bool is_inside =
        number::sign(torus_power(of.shape, {number::Dyadic(p.x), number::Dyadic(p.y), number::Dyadic(p.z)})) < 0;
    const conform::Inside inside = tracer_->profile.inside;
    if (is_inside && inside == conform::Inside::nothing) return;
    if (is_inside && inside == conform::Inside::origin) all_.push_back({e, of.rayo, {}});
    for (const Parameter& t : torus_crossings(of.shape, of.rayo)) all_.push_back({e, of.rayo, t});
  }

  template <class Shape>
  static bool starts_inside(const Computed<Shape>& of) {
    const auto f = surface::exact::coefficients(of.shape, of.rayo);
    const bool is_between = !f.altura || (number::sign(f.s0) >= 0 && f.s0 <= *f.altura);
    return number::sign(f.C) < 0 && is_between;
  }

  template <class Shape>
  void add_discs(scene::ElementRef e, const Computed<Shape>& of) {
    const Shape& wall = of.shape;
    double top = 0, base = 0;
    if constexpr (requires { wall.radio; }) base = top = wall.radio;
    if constexpr (requires { wall.proporcion; }) base += wall.proporcion * wall.altura;
    const auto close = [&](const glm::dvec3& centro, double radio, double outwards) {
      const scene::Disc disc{centro, radio, wall.vector};
      is_whole_ = is_whole_ && is_shape(disc);
      if (is_whole_) add(e, disc, of.rayo, outwards);
    };
    close(wall.centro, base, -1);
    if (top > 0) close(wall.centro + wall.altura * wall.vector, top, 1);
  }

  using Wide = glm::vec<3, long double>;

  template <class Shape>
  static Wide outward_of(const Shape& shape, const Wide& w) {
    if constexpr (requires { shape.vertices; }) {
      const Wide a(shape.vertices[0]);
      return glm::cross(Wide(shape.vertices[1]) - a, Wide(shape.vertices[2]) - a);
    } else if constexpr (requires { shape.altura; }) {
      const Wide d(shape.vector), q = w - Wide(shape.centro), across = q - glm::dot(q, d) * d;
      long double slope = 0;
      if constexpr (requires { shape.proporcion; }) slope = shape.proporcion;
      return across / glm::length(across) + slope * d;
    } else if constexpr (requires { shape.vector; }) {
      return Wide(shape.vector);
    } else {
      return w - Wide(shape.centro);
    }
  }

  /// By areas, exact and then rounded once: of a needle other arithmetic leaves no digit.
  static glm::dvec2 uv_of(const scene::Triangle& triangle, const glm::dvec3& w) {
    using number::Dyadic;
    using Row = std::array<Dyadic, 3>;
    const auto way = [&](const glm::dvec3& to) {
      const glm::dvec3& a = triangle.vertices[0];
      return Row{Dyadic(to.x) - Dyadic(a.x), Dyadic(to.y) - Dyadic(a.y), Dyadic(to.z) - Dyadic(a.z)};
    };
    const auto area = [](const Row& a, const Row& b) {
      return Row{a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
    };
    const auto product = [](const Row& a, const Row& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; };
    const Row ab = way(triangle.vertices[1]), ac = way(triangle.vertices[2]), q = way(w), whole = area(ab, ac);
    return {number::round_quotient(product(area(q, ac), whole), product(whole, whole)),
            number::round_quotient(product(area(ab, q), whole), product(whole, whole))};
  }

  /// What may be said of a point of its own data besides; a disc that closes a solid has its own outward side.
  template <class Shape>
  Besides besides(const Shape& shape, const model::Rayo& rayo, const Parameter& t, double outwards) const {
    const Wide w(surface::exact::rounded_hit(rayo, t, {}).punto);
    const Wide outward = static_cast<long double>(outwards) * outward_of(shape, w);
    const long double length = glm::length(outward);
    Besides says;
    if (!(length > 0) || !std::isfinite(length)) return says;
    says.outward = rounded(glm::dvec3(outward / length));
    says.against = static_cast<double>(
        glm::dot(Wide(rayo.v().xyz()) / static_cast<long double>(longest(rayo.v().xyz())), outward / length));
    if constexpr (requires { shape.vertices; }) {
      const glm::dvec2 of = uv_of(shape, surface::exact::rounded_hit(rayo, t, {}).punto);
      says.uv = glm::dvec2(rounded(of.x), rounded(of.y));
    }
    return says;
  }

  template <class Shape>
  void add(scene::ElementRef e, const Shape& shape, const model::Rayo& rayo, double outwards = 1) {
    const surface::exact::Reach reach = surface::exact::reach(shape, rayo);
    for (const Parameter& t : reach.points()) all_.push_back({e, rayo, t, besides(shape, rayo, t, outwards)});
    if (reach.segment) {
      all_.push_back({e, rayo, reach.segment->begin});
      if (reach.segment->end) all_.push_back({e, rayo, reach.segment->end});
    } else if (tracer_->counts_origin) {
      const auto f = surface::exact::coefficients(shape, rayo);
      if (number::sign(f.C) == 0 && within_clip(f, Parameter{})) all_.push_back({e, rayo, {}});
    }
  }

  const RightTracer* tracer_;
  const conform::SuiteCase* of_;
  model::Rayo rayo_;
  Mover mover_;
  std::map<Key, glm::dvec3> vertices_{};
  std::optional<model::Rayo> rayo_of_mesh_{};
  bool is_whole_ = true;
  std::vector<Met> all_{};
};

}  // namespace durero::test
