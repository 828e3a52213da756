#include "durero/render/bundle/caustics.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <optional>
#include <stdexcept>
#include <utility>
#include <vector>

#include "durero/render/bundle/pencil.hpp"
#include "durero/render/light/directions.hpp"
#include "durero/render/light/light_cones.hpp"
#include "durero/scene/axes_across.hpp"
#include "durero/scene/motion.hpp"
#include "durero/surface/curvature.hpp"
#include "durero/surface/surfaces.hpp"
#include "render/light/front.hpp"
#include "render/light/media.hpp"

namespace durero::render {
namespace {

/// The pencils across the square about an element, before any is divided.
constexpr int pencils_across = 48;
/// How often a cell is divided.
constexpr int divisions = 3;
/// The tolerance, and the blur of a spot, as parts of the radius of the element that gathers the light.
constexpr double tolerance = 1.0 / 48, blur = 1.0 / 96;
/// A pencil that carries less of its light is not followed, and one that carries less is not divided for its sake.
constexpr double least_share = 1.0 / 32, least_judged = 1.0 / 8;
/// A spot whose light is below this part of the light's is not left.
constexpr double least_density = 1.0 / 4096;

/// A square of rays towards an element: from a point, or along a direction.
struct LightWindow {
  scene::ElementRef target;
  glm::dvec3 color;
  glm::dvec3 from;  ///< the light, or the middle of the square before the element
  glm::dvec3 axis, first, second;
  double half;    ///< of the side of the square
  double radius;  ///< of the element's ball
  bool far;       ///< whether the light shines along a direction
  std::optional<CosineCone> cone{};

  glm::dvec3 origin(double u, double v) const { return far ? from + u * first + v * second : from; }
  glm::dvec3 towards(double u, double v) const { return far ? axis : axis + u * first + v * second; }
  /// The change of the unit direction with u or v, which `side` is the direction of.
  glm::dvec3 leaning(double u, double v, const glm::dvec3& side) const {
    const glm::dvec3 d = towards(u, v);
    const double length = glm::length(d);
    return far ? glm::dvec3(0) : (side - d * (glm::dot(d, side) / (length * length))) / length;
  }
  /// The flux through a unit of the square, for a light whose brightness at the first surface, `way` away, is 1.
  double flux(double u, double v, double way) const {
    if (far) return 1;
    const glm::dvec3 d = towards(u, v);
    const double length = glm::length(d);
    return way * way / std::pow(length, 3) * (cone ? intensity(*cone, d / length) : 1);
  }
};

double greatest(const glm::dvec3& color) { return std::max({color.x, color.y, color.z}); }

/// A cell of the square: its middle, and its side.
struct LightCell {
  double u, v, side;
};

}  // namespace

/// Traces the pencils of one scene.
class CausticTracer {
 public:
  CausticTracer(const scene::Scene& scene, const engine::Engine& engine, std::uint32_t max_depth, Caustics& to)
      : scene_(scene), engine_(engine), max_depth_(max_depth), to_(to) {}

  void trace(const LightWindow& window) {
    window_ = &window;
    const double side = 2 * window.half / pencils_across;
    for (int i = 0; i < pencils_across; ++i)
      for (int k = 0; k < pencils_across; ++k)
        trace(LightCell{(i + 0.5) * side - window.half, (k + 0.5) * side - window.half, side}, divisions);
  }

 private:
  /// A ray on its way, by its next query.
  struct Way {
    scene::Query query{model::Rayo(model::Punto(0, 0, 0), model::Vector(1, 0, 0))};
    Media media{};
  };
  /// The pencil on one of its ways.
  struct PencilPath {
    Pencil pencil;
    Way axis;
    std::array<Way, 3> probes;  ///< exact rays of the cell, at `places`
    bool told = true;           ///< whether all of them went the way of the axis
    glm::dvec3 share{1};
    std::uint32_t depth = 1;
  };
  /// The places of the probes, in sides of the cell from its middle.
  static constexpr std::array<glm::dvec2, 3> places{{{0.5, 0}, {0, 0.5}, {0.5, 0.5}}};
  /// A meeting of a way with an element.
  struct Met {
    scene::Hit hit;
    scene::ElementRef element;
    glm::dvec3 normal;  ///< on the side of the ray
    bool enters;
  };

  void trace(const LightCell& cell, int divisions_left) {
    ++to_.pencils_;
    const LightWindow& w = *window_;
    const auto ray = [&](double u, double v) {
      return Way{{model::Rayo(model::Punto(w.origin(u, v)), model::Vector(unit(w.towards(u, v))))}};
    };
    const Way axis = ray(cell.u, cell.v);
    const Pencil pencil(axis.query.rayo.p().xyz(), axis.query.rayo.v().xyz());
    const auto deviation = [&](const glm::dvec3& side) {
      const glm::dvec3 off = cell.side * (w.far ? side : glm::dvec3(0)),
                       lean = cell.side * w.leaning(cell.u, cell.v, side);
      return Deviation(glm::dot(off, pencil.first()), glm::dot(off, pencil.second()), glm::dot(lean, pencil.first()),
                       glm::dot(lean, pencil.second()));
    };
    sides_[0] = deviation(w.first);
    sides_[1] = deviation(w.second);
    cell_ = &cell;
    left_.clear();
    error_ = reached_ = flux_ = 0;
    PencilPath path{pencil, axis, {}};
    for (std::size_t i = 0; i < places.size(); ++i)
      path.probes[i] = ray(cell.u + cell.side * places[i].x, cell.v + cell.side * places[i].y);
    follow(std::move(path));
    if (divisions_left > 0 && error_ > tolerance * w.radius) {
      const double part = cell.side / 4;
      const LightCell whole = cell;
      for (const auto& [u, v] : {std::pair(-part, -part), {part, -part}, {-part, part}, {part, part}})
        trace(LightCell{whole.u + u, whole.v + v, whole.side / 2}, divisions_left - 1);
      return;
    }
    to_.aimed_ += reached_;
    if (std::isinf(error_)) {
      to_.lost_ += reached_;
      return;
    }
    for (const LightSpot& spot : left_) to_.spots_.add(spot);
  }

  /// The meeting of a way; nothing where it leads nowhere.
  std::optional<Met> meeting(const Way& way) const {
    scene::Hit hit = engine::first_hit(engine_, way.query);
    if (hit.resultado != model::Resultado::hit) return std::nullopt;
    const scene::ElementRef element = front(scene_, hit.elementos);
    glm::dvec3 n = engine_.normal(scene_, element, hit.punto);
    const bool enters = !(glm::dot(n, way.query.rayo.v().xyz()) > 0);
    if (!enters) n = -n;
    return Met{std::move(hit), element, n, enters};
  }

  /// Whether the pencil's first meeting is with the element that it is aimed at, and nothing is before it.
  bool is_lit(const Met& met) const {
    if (met.element != window_->target) return false;
    const model::Rayo back(model::Punto(met.hit.punto), model::Vector(-window_->axis));
    return !window_->far || engine::first_hit(engine_, {back, met.hit.elementos}).resultado == model::Resultado::miss;
  }

  using ProbesMet = std::array<Met, 3>;

  /// The meetings of the probes; the path is told no more where one of them is with something else.
  ProbesMet probes_of(PencilPath& path, const Met& met) const {
    ProbesMet all;
    for (std::size_t i = 0; i < all.size() && path.told; ++i) {
      std::optional<Met> one = meeting(path.probes[i]);
      if (one && one->hit.elementos == met.hit.elementos && one->enters == met.enters)
        all[i] = std::move(*one);
      else
        path.told = false;
    }
    return all;
  }

  void follow(PencilPath path) {
    const auto met = meeting(path.axis);
    if (!met || (path.depth == 1 && !is_lit(*met))) return;
    const ProbesMet probes = probes_of(path, *met);
    path.pencil.transfer(met->hit.punto);
    const auto material = scene_.material(met->element);
    if (path.depth == 1) {
      const double way = glm::distance(path.axis.query.rayo.p().xyz(), met->hit.punto);
      flux_ = window_->flux(cell_->u, cell_->v, way) * cell_->side * cell_->side;
      reached_ = flux_;
    } else {
      leave(path, *met, probes);
    }
    if (material && path.depth < max_depth_)
      send_on(path, *met, probes, scene_.stage().materials[*material], *material);
  }

  /// Leaves a spot on a matt surface, and judges it by the probes.
  void leave(const PencilPath& path, const Met& met, const ProbesMet& probes) {
    const auto material = scene_.material(met.element);
    if (material && !(scene_.stage().materials[*material].k_d > 0)) return;
    const glm::dvec3 a = path.pencil.on_plane(sides_[0], met.normal), b = path.pencil.on_plane(sides_[1], met.normal);
    const auto off = [&](std::size_t i) {
      return probes[i].hit.punto - met.hit.punto - (places[i].x * a + places[i].y * b);
    };
    const double error = path.told ? second_order(off(0), off(1), off(2)) : std::numeric_limits<double>::infinity();
    if (greatest(path.share) >= least_judged) error_ = std::max(error_, error);
    if (!path.told) return;
    const LightSpot spot = spot_of(met.element, met.hit.punto, met.normal, a, b, blur * window_->radius,
                                   flux_ * window_->color * path.share);
    if (greatest(spot.peak) > least_density * greatest(window_->color)) left_.push_back(spot);
  }

  void send_on(const PencilPath& path, const Met& met, const ProbesMet& probes, const scene::Material& m,
               std::uint32_t material) {
    glm::dvec3 mirror = m.k_ps * m.M_PS;
    const glm::dmat3 turned = (met.enters ? 1.0 : -1.0) * surface::curvature(scene_, met.element, met.hit.punto);
    if (m.k_t > 0) {
      PencilPath beyond = path;
      const double ratio = beyond.axis.media.cross(met.enters, material, scene_.stage());
      if (beyond.pencil.refract(met.normal, turned, ratio)) {
        beyond.share *= m.k_t * m.M_T;
        go_on(std::move(beyond), met, probes,
              [&](const glm::dvec3& d, const glm::dvec3& n) { return refracted(d, n, ratio); });
      } else {
        mirror += m.k_t * m.M_T;
      }
    }
    PencilPath back = path;
    back.pencil.reflect(met.normal, turned);
    back.share *= mirror;
    go_on(std::move(back), met, probes,
          [](const glm::dvec3& d, const glm::dvec3& n) { return std::optional(mirrored(d, n)); });
  }

  /// Follows the path in its new direction; turned(d, n) is that of a probe, if it has one.
  template <class Turned>
  void go_on(PencilPath path, const Met& met, const ProbesMet& probes, Turned&& turned) {
    if (greatest(path.share) < least_share) return;
    path.axis.query = from(met, path.pencil.direction());
    for (std::size_t i = 0; i < probes.size() && path.told; ++i) {
      const std::optional<glm::dvec3> d = turned(path.probes[i].query.rayo.v().xyz(), probes[i].normal);
      path.told = d.has_value();
      if (d) path.probes[i].query = from(probes[i], *d);
    }
    ++path.depth;
    follow(std::move(path));
  }

  static scene::Query from(const Met& met, const glm::dvec3& direction) {
    return {model::Rayo(model::Punto(met.hit.punto), model::Vector(direction)), met.hit.elementos};
  }

  const scene::Scene& scene_;
  const engine::Engine& engine_;
  const std::uint32_t max_depth_;
  Caustics& to_;
  const LightWindow* window_ = nullptr;
  // Of the cell that is traced.
  const LightCell* cell_ = nullptr;
  Deviation sides_[2];
  std::vector<LightSpot> left_{};
  double error_ = 0, reached_ = 0, flux_ = 0;
};

namespace {

/// The squares about the elements that gather light, from each light.
std::vector<LightWindow> windows_of(const scene::Scene& scene) {
  std::vector<LightWindow> windows;
  const scene::Stage& stage = scene.stage();
  scene.for_each([&](scene::ElementRef e, const auto& shape) {
    const auto material = scene.material(e);
    const surface::Ball ball = surface::ball(shape);
    if (!material || !stage.materials[*material].sends_rays_on() || std::isinf(ball.radius)) return;
    const auto add = [&](const glm::dvec3& color, const glm::dvec3& from, const glm::dvec3& axis, double half,
                         bool far) {
      const scene::AxesAcross axes = scene::axes_across(axis);
      windows.push_back({e, color, from, axis, axes.first, axes.second, half, ball.radius, far});
    };
    for (const scene::Light& light : stage.lights) {
      const glm::dvec3 to = ball.centre - light.position;
      const double distance = glm::length(to);
      if (!(distance > ball.radius)) continue;
      add(light.color, light.position, to / distance, std::tan(std::asin(ball.radius / distance)), false);
      if (light.cone) windows.back().cone = cosine_cone(*light.cone, light.position);
    }
    for (const scene::DirectionalLight& light : stage.directional_lights) {
      const glm::dvec3 axis = unit(light.direction);
      add(light.color, ball.centre - 2 * ball.radius * axis, axis, ball.radius, true);
    }
  });
  return windows;
}

}  // namespace

Caustics::Caustics(const scene::Scene& scene, const engine::Engine& engine, std::uint32_t max_depth) {
  if (scene::moves(scene)) throw std::domain_error("something moves; expected a scene at rest with pencils");
  if (!std::ranges::all_of(scene.stage().lights, [](const auto& l) { return l.extent.is_point(); }))
    throw std::domain_error("a light has a size; expected points and directions with pencils");
  const std::vector<LightWindow> windows = windows_of(scene);
  if (windows.empty())
    throw std::domain_error("no light shines on a finite element with k_ps or k_t; expected both with pencils");
  CausticTracer tracer(scene, engine, max_depth, *this);
  for (const LightWindow& window : windows) tracer.trace(window);
}

}  // namespace durero::render
