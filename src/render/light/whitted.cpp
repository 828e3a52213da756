#include "durero/render/light/whitted.hpp"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <iterator>
#include <memory>
#include <mutex>
#include <optional>

#include "durero/model/tipos.hpp"
#include "durero/render/light/directions.hpp"
#include "durero/render/light/environment.hpp"
#include "durero/scene/stage.hpp"
#include "durero/surface/surfaces.hpp"
#include "followed.hpp"
#include "follower.hpp"
#include "front.hpp"
#include "paths.hpp"
#include "shadows.hpp"
#include "smooth_normal.hpp"

namespace durero::render {
namespace {

/// A meeting of a path with a surface.
struct PathVertex {
  const Path& path;
  const scene::Query& query;
  const scene::Hit& hit;
  const Look& look;
  glm::dvec3 normal;  ///< the unit normal on the side of the ray
  glm::dvec3 facing;  ///< that normal as the vertices and the relief turn it
  glm::dvec3 d;       ///< the unit direction of the ray
  double way;         ///< the length from the eye to here
};

/// The tangents without their parts along a unit normal.
Tangents across(const Tangents& t, const glm::dvec3& n) {
  return {t.u - glm::dot(t.u, n) * n, t.v - glm::dot(t.v, n) * n};
}

/// The factor of S in the local model: the share of a light from that unit direction that is sent towards the ray, by
/// Lambert's law (k_d) and Phong's highlight (k_s, e). A relief sees no light that the surface has its back to.
glm::dvec3 sent(const PathVertex& at, const glm::dvec3& l, double cosine) {
  const Look& m = at.look;
  if (!(glm::dot(l, at.normal) > 0)) cosine = 0;
  glm::dvec3 sum = m.color * (m.k_a + m.k_d * std::max(0.0, cosine));
  if (m.k_s > 0 && cosine > 0) {
    // r·v, both taken the other way around: l goes on from the mirror as −r, and d is −v.
    const double towards = glm::dot(mirrored(l, at.facing), at.d);
    sum += glm::dvec3(m.k_s * std::pow(std::max(0.0, towards), m.e));
  }
  return sum;
}

/// A tracer follows rays, some at a time, and keeps its memory from one call to the next.
class Tracer {
 public:
  explicit Tracer(const TracingContext& followed)
      : followed_(followed),
        scene_(followed.scene),
        engine_(followed.engine),
        limits_(followed.limits),
        shadows_(followed.scene.stage()) {}

  /// Adds what each ray brings to its sum.
  void follow(std::span<const scene::Query> rays, std::span<PathRadiance> sums) {
    sums_ = sums;
    now_.clear();
    for (std::uint32_t i = 0; i < rays.size(); ++i) now_.paths.push_back({.ray = i, .weight = glm::dvec3(1)});
    meet_all(rays);
    while (next_paths()) meet_all(now_.queries);
  }

 private:
  /// The number of paths of each ray that are followed at once. The summands of its colour and their order depend on no
  /// other ray; and since the latest paths come first, no more paths wait than this number times the depth.
  static constexpr std::size_t at_once = 16;

  /// Takes the latest waiting paths of each ray, ray by ray. Returns whether there are any.
  bool next_paths() {
    if (held_ > 0 || born_.has_more_of_a_ray_than(at_once)) {
      hold();
      take_latest();
    } else {
      std::swap(now_, born_);
    }
    born_.clear();
    return !now_.paths.empty();
  }

  /// Makes all new paths wait with their ray.
  void hold() {
    waiting_.resize(sums_.size());
    for (std::size_t i = 0; i < born_.paths.size(); ++i) {
      const std::uint32_t ray = born_.paths[i].ray;
      waiting_[ray].push(std::move(born_.paths[i]), std::move(born_.queries[i]));
    }
    held_ += born_.paths.size();
  }
  void take_latest() {
    now_.clear();
    for (Paths& all : waiting_) {
      const std::size_t left = all.paths.size() - std::min(at_once, all.paths.size());
      for (std::size_t i = left; i < all.paths.size(); ++i)
        now_.push(std::move(all.paths[i]), std::move(all.queries[i]));
      all.shorten(left);
    }
    held_ -= now_.paths.size();
  }

  void meet_all(std::span<const scene::Query> queries) {
    hits_.resize(queries.size());
    engine_.first_hits(queries, hits_);
    for (std::size_t i = 0; i < queries.size(); ++i) meet(now_.paths[i], queries[i], hits_[i]);
    shadows_.add_light(engine_, sums_);
  }

  void meet(const Path& path, const scene::Query& query, const scene::Hit& hit) {
    PathRadiance& sum = sums_[path.ray];
    ++sum.rays;
    sum.depth = std::max(sum.depth, path.depth);
    if (hit.resultado != model::Resultado::hit) {
      sum.color += path.weight * from_nowhere(query.rayo.v().xyz());
      return;
    }
    const scene::ElementRef element = front(scene_, hit.elementos);
    const auto index = scene_.material(element);
    glm::dvec3 n = engine_.normal(scene_, element, hit.punto);
    const glm::dvec3 d = unit(query.rayo.v().xyz());
    const bool enters = !(glm::dot(n, d) > 0);
    const double way = path.way + glm::distance(query.rayo.p().xyz(), hit.punto);
    const TexturedMaterial& worn = followed_.looks.of(index);
    const Look* look = &worn.plain;
    glm::dvec3 facing = smooth_normal(scene_, element, hit.punto, n);
    if (!worn.is_bare()) {
      const TextureCoordinates coordinates = render::coordinates(scene_, element, hit.punto);
      if (worn.varies) look = &varied_.emplace(worn.look(coordinates, way));
      if (worn.relief) {
        Tangents along = tangents(scene_, element, coordinates);
        if (facing != n) along = across(along, facing);
        facing = worn.normal(along, facing, coordinates);
      }
    }
    if (!enters) n = -n, facing = -facing;       // the side that the ray sees: cylinders and cones are open
    if (!(glm::dot(facing, d) < 0)) facing = n;  // a slope that is turned away is not seen
    const PathVertex at{path, query, hit, *look, n, facing, d, way};
    sum.color += path.weight * (at.look.emission + at.look.ambient);
    ask_lights(at);
    if (path.depth == limits_.max_depth || !at.look.sends_rays_on()) return;
    send_on(at, *index, enters);
  }

  glm::dvec3 from_nowhere(const glm::dvec3& v) const {
    const scene::Stage& stage = scene_.stage();
    return stage.environment ? environment_at(*stage.environment, v) : stage.background.value_or(default_background);
  }

  /// flatten compiles into this function and send() all that they call: a ray whose numbers pass through memory on
  /// their way to where it waits is stalled there (the mirrors of demo/ took 5 % longer).
  [[gnu::flatten]] void ask_lights(const PathVertex& at) {
    const scene::Stage& stage = scene_.stage();
    for (std::size_t i = 0; i < stage.lights.size(); ++i) {
      const scene::Light& light = stage.lights[i];
      const glm::dvec3 to_light = light.position - at.hit.punto;
      if (to_light == glm::dvec3(0)) continue;  // the light is at the point itself
      const double length = glm::length(to_light);
      const glm::dvec3 seen = sent(at, to_light / length, glm::dot(to_light, at.facing) / length);
      shadows_.points.add(i, at.path.ray, at.path.weight * (light.color * seen), at.hit, to_light);
    }
    for (std::size_t i = 0; i < stage.directional_lights.size(); ++i) {
      const scene::DirectionalLight& light = stage.directional_lights[i];
      const glm::dvec3 l = -unit(light.direction);
      shadows_.directions.add(i, at.path.ray, at.path.weight * (light.color * sent(at, l, glm::dot(l, at.facing))),
                              at.hit, -light.direction);
    }
  }

  void send_on(const PathVertex& at, std::uint32_t material, bool enters) {
    const Look& m = at.look;
    glm::dvec3 mirror = m.k_ps * m.M_PS;
    if (m.k_t > 0) {
      Media beyond = at.path.media;
      const double here = beyond.index(scene_.stage());
      const bool was_in = enters || beyond.leave(material);
      if (enters) beyond.enter(material);
      const double ratio = (was_in ? here : m.index) / beyond.index(scene_.stage());
      if (ratio == 1 && is_sheet(at))
        go_on(at, m.k_t * m.M_T, std::move(beyond));
      else if (const auto t = through(at, ratio))
        send(at, m.k_t * m.M_T, *t, std::move(beyond));
      else
        mirror += m.k_t * m.M_T;
    }
    const glm::dvec3 r = mirrored(at.d, at.facing);
    send(at, mirror, glm::dot(r, at.normal) > 0 ? r : mirrored(at.d, at.normal), at.path.media);
  }

  /// Whether all elements met are flat, and met for the first time.
  static bool is_sheet(const PathVertex& at) {
    const scene::Origin start(at.query.en);
    return std::ranges::all_of(at.hit.elementos,
                               [&](scene::ElementRef e) { return surface::is_flat(e.tipo) && !start.contains(e); });
  }

  /// Continues the same ray behind a sheet that does not bend it. Its query names the sheet as an origin too, and so it
  /// meets the sheet no more (puntos_desde.def.1); since no new start is rounded, it meets the elements behind as if
  /// there were no sheet.
  void go_on(const PathVertex& at, const glm::dvec3& share, Media media) {
    scene::ElementSet on;
    std::ranges::set_union(at.query.en, at.hit.elementos, std::back_inserter(on));
    send(at, share, at.query.rayo, on, std::move(media), at.path.way);
  }

  /// The refracted direction. Where a relief would send it back through the surface, the direction that the surface
  /// alone gives; likewise for the mirrored one.
  static std::optional<glm::dvec3> through(const PathVertex& at, double ratio) {
    const auto t = refracted(at.d, at.facing, ratio);
    return t && !(glm::dot(*t, at.normal) < 0) ? refracted(at.d, at.normal, ratio) : t;
  }

  /// Sends a ray in a direction from the point of the meeting.
  [[gnu::flatten]] void send(const PathVertex& at, const glm::dvec3& share, const glm::dvec3& v, Media media) {
    send(at, share, {model::Punto(at.hit.punto), model::Vector(v)}, at.hit.elementos, std::move(media), at.way);
  }
  void send(const PathVertex& at, const glm::dvec3& share, const model::Rayo& ray, const scene::ElementSet& en,
            Media media, double way) {
    const glm::dvec3 weight = at.path.weight * share;
    if (weight == glm::dvec3(0)) return;
    if (std::max({weight.x, weight.y, weight.z}) < limits_.min_weight) {
      sums_[at.path.ray].left_out += weight * followed_.most[limits_.max_depth - at.path.depth];
      return;
    }
    born_.push({at.path.ray, weight, at.path.depth + 1, std::move(media), way}, ray, en);
  }

  const TracingContext& followed_;
  const scene::Scene& scene_;
  const engine::Engine& engine_;
  const PathLimits limits_;
  std::span<PathRadiance> sums_;
  Paths now_, born_;            ///< the paths that are followed, and the paths that these send on
  std::vector<Paths> waiting_;  ///< the waiting paths of each ray, the next ones last
  std::size_t held_ = 0;        ///< the number of waiting paths
  std::vector<scene::Hit> hits_;
  std::optional<Look> varied_;  ///< the look of the last meeting, where its material has textures
  Shadows shadows_;
};

}  // namespace

/// The data of a follower.
struct Follower::Held {
  TracingContext followed;
  std::mutex mutex{};
  std::vector<std::unique_ptr<Tracer>> idle{};  ///< tracers whose memory is used again

  /// A tracer that no other call uses: a thread that waits within one call may begin another.
  std::unique_ptr<Tracer> taken() {
    const std::lock_guard lock(mutex);
    if (idle.empty()) return std::make_unique<Tracer>(followed);
    std::unique_ptr<Tracer> one = std::move(idle.back());
    idle.pop_back();
    return one;
  }
  void give_back(std::unique_ptr<Tracer> one) {
    const std::lock_guard lock(mutex);
    idle.push_back(std::move(one));
  }
};

Follower::Follower(const scene::Scene& scene, const engine::Engine& engine, const PathLimits& limits) {
  if (limits.max_depth > 0) held_.reset(new Held{.followed{scene, engine, limits}});
}

Follower::~Follower() = default;

std::vector<PathRadiance> Follower::brought(std::span<const scene::Query> rays) const {
  std::vector<PathRadiance> sums(rays.size());
  if (!held_) return sums;
  std::unique_ptr<Tracer> tracer = held_->taken();
  tracer->follow(rays, sums);
  held_->give_back(std::move(tracer));
  return sums;
}

std::vector<PathRadiance> brought(const scene::Scene& scene, const engine::Engine& engine,
                                  std::span<const scene::Query> rays, const PathLimits& limits) {
  return Follower(scene, engine, limits).brought(rays);
}

}  // namespace durero::render
