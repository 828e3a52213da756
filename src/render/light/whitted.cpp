#include "durero/render/light/whitted.hpp"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <iterator>
#include <memory>
#include <optional>

#include "durero/model/tipos.hpp"
#include "durero/render/bundle/caustics.hpp"
#include "durero/render/light/directions.hpp"
#include "durero/render/light/extent.hpp"
#include "durero/render/sample/maps.hpp"
#include "durero/render/sample/sampling.hpp"
#include "durero/scene/stage.hpp"
#include "encounter.hpp"
#include "followed.hpp"
#include "local_model.hpp"
#include "paths.hpp"
#include "shadows.hpp"
#include "tracer.hpp"

namespace durero::render {
namespace {

/// A meeting of a path with a surface.
struct PathVertex : Encounter {
  const Path& path;
};

/// The tracer of Whitted's algorithm.
class WhittedTracer : public Tracer {
 public:
  explicit WhittedTracer(const TracingContext& followed)
      : followed_(followed),
        scene_(followed.scene),
        engine_(followed.engine),
        limits_(followed.limits),
        shadows_(followed) {}

  /// Adds what each ray brings to its sum.
  void follow(std::span<const scene::Query> rays, std::span<const SampleSource> samples,
              std::span<PathRadiance> sums) override {
    sums_ = sums;
    samples_ = samples;
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
      sum.color += path.weight * from_nowhere(scene_.stage(), query.rayo.v().xyz());
      return;
    }
    const PathVertex at{encounter_of(followed_, query, hit, path.way, varied_), path};
    sum.color += path.weight * (at.look.emission + at.look.ambient);
    if (followed_.caustics)
      sum.color += path.weight * (at.look.k_d * at.look.color * followed_.caustics->irradiance(at.element, hit.punto));
    ask_lights(at);
    if (path.depth == limits_.max_depth || !at.look.sends_rays_on()) return;
    send_on(at);
  }

  /// flatten compiles into this function and send() all that they call: a ray whose numbers pass through memory on
  /// their way to where it waits is stalled there (the mirrors of demo/ took 5 % longer).
  [[gnu::flatten]] void ask_lights(const PathVertex& at) {
    const scene::Stage& stage = scene_.stage();
    const ShadowStart from{at.path.ray, at.hit, at.way};
    for (std::size_t i = 0; i < stage.lights.size(); ++i) {
      const scene::Light& light = stage.lights[i];
      const glm::dvec3 to_light = place_of(light, i, at) - at.hit.punto;
      if (to_light == glm::dvec3(0)) continue;  // the light is at the point itself
      const double length = glm::length(to_light);
      const glm::dvec3 l = to_light / length;
      const glm::dvec3 seen = sent(at, l, glm::dot(to_light, at.facing) / length);
      shadows_.points.add(i, from, at.path.weight * (light.color * followed_.cones.share(i, l) * seen), to_light);
    }
    for (std::size_t i = 0; i < stage.directional_lights.size(); ++i) {
      const scene::DirectionalLight& light = stage.directional_lights[i];
      const glm::dvec3 l = -unit(light.direction);
      shadows_.directions.add(i, from, at.path.weight * (light.color * sent(at, l, glm::dot(l, at.facing))),
                              -light.direction);
    }
  }

  /// The place of light i, as this sample of the ray sees it from there.
  glm::dvec3 place_of(const scene::Light& light, std::size_t i, const PathVertex& at) const {
    if (light.extent.is_point()) return light.position;
    return point_of(light, samples_[at.path.ray].pair(of_meeting(at.path.branch) + 1 + i));
  }

  /// The mirrored direction, or one of its lobe: what would lead through the surface is mirrored once more, in it.
  glm::dvec3 glossy_way(const PathVertex& at) const {
    const glm::dvec3 way = mirrored_way(at);
    if (std::isinf(at.look.gloss)) return way;
    const glm::dvec3 turned = in_lobe(samples_[at.path.ray].pair(of_meeting(at.path.branch)), unit(way), at.look.gloss);
    return glm::dot(turned, at.normal) > 0 ? turned : mirrored(turned, at.normal);
  }

  void send_on(const PathVertex& at) {
    const Look& m = at.look;
    glm::dvec3 mirror = m.k_ps * m.M_PS;
    if (m.k_t > 0) {
      auto [media, ratio] = beyond_of(at, at.path.media, scene_.stage());
      if (ratio == 1 && is_sheet(at))
        go_on(at, m.k_t * m.M_T, std::move(media));
      else if (const auto t = through(at, ratio))
        send(at, m.k_t * m.M_T, *t, std::move(media), 1);
      else
        mirror += m.k_t * m.M_T;
    }
    send(at, mirror, glossy_way(at), at.path.media, 0);
  }

  /// Continues the same ray behind a sheet that does not bend it. Its query names the sheet as an origin too, and so it
  /// meets the sheet no more (puntos_desde.def.1); since no new start is rounded, it meets the elements behind as if
  /// there were no sheet.
  void go_on(const PathVertex& at, const glm::dvec3& share, Media media) {
    scene::ElementSet on;
    std::ranges::set_union(at.query.en, at.hit.elementos, std::back_inserter(on));
    send(at, share, at.query.rayo, on, std::move(media), at.path.way, 1);
  }

  /// Sends a ray in a direction from the point of the meeting.
  [[gnu::flatten]] void send(const PathVertex& at, const glm::dvec3& share, const glm::dvec3& v, Media media,
                             std::uint64_t turn) {
    send(at, share, {model::Punto(at.hit.punto), model::Vector(v)}, at.hit.elementos, std::move(media), at.way, turn);
  }
  void send(const PathVertex& at, const glm::dvec3& share, const model::Rayo& ray, const scene::ElementSet& en,
            Media media, double way, std::uint64_t turn) {
    const glm::dvec3 weight = at.path.weight * share;
    if (weight == glm::dvec3(0)) return;
    if (std::max({weight.x, weight.y, weight.z}) < limits_.min_weight) {
      sums_[at.path.ray].left_out += weight * followed_.most[limits_.max_depth - at.path.depth];
      return;
    }
    born_.push({at.path.ray, weight, at.path.depth + 1, std::move(media), way, 2 * at.path.branch + turn}, ray, en);
  }

  const TracingContext& followed_;
  const scene::Scene& scene_;
  const engine::Engine& engine_;
  const PathLimits limits_;
  std::span<PathRadiance> sums_;
  std::span<const SampleSource> samples_;  ///< one for each ray that is asked for
  Paths now_, born_;                       ///< the paths that are followed, and the paths that these send on
  std::vector<Paths> waiting_;             ///< the waiting paths of each ray, the next ones last
  std::size_t held_ = 0;                   ///< the number of waiting paths
  std::vector<scene::Hit> hits_;
  std::optional<Look> varied_;  ///< the look of the last meeting, where its material has textures
  Shadows shadows_;
};

}  // namespace

std::unique_ptr<Tracer> whitted_tracer(const TracingContext& context) {
  return std::make_unique<WhittedTracer>(context);
}

}  // namespace durero::render
