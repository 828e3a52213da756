#include "durero/render/light/whitted.hpp"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <iterator>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "durero/model/tipos.hpp"
#include "durero/render/bundle/caustics.hpp"
#include "durero/render/light/directions.hpp"
#include "durero/render/light/extent.hpp"
#include "durero/render/sample/maps.hpp"
#include "durero/render/sample/sampling.hpp"
#include "durero/scene/stage.hpp"
#include "element_looks.hpp"
#include "encounter.hpp"
#include "followed.hpp"
#include "local_model.hpp"
#include "nestings.hpp"
#include "paths.hpp"
#include "shadows.hpp"
#include "tracer.hpp"

namespace durero::render {
namespace {

/// The tracer of Whitted's algorithm.
class WhittedTracer : public Tracer {
 public:
  explicit WhittedTracer(const TracingContext& followed)
      : followed_(followed),
        stage_(followed.scene.stage()),
        limits_(followed.limits),
        nestings_(stage_),
        looks_(followed),
        shadows_(followed) {}

  /// Adds what each ray brings to its sum.
  void follow(std::span<const scene::Query> rays, std::span<const SampleSource> samples,
              std::span<PathRadiance> sums) override {
    sums_ = sums;
    samples_ = samples;
    nestings_.begin();
    now_.clear();
    for (std::uint32_t i = 0; i < rays.size(); ++i) now_.paths.push_back({.ray = i});
    meet_all(rays);
    while (next_paths()) meet_all(now_.queries.all());
  }

 private:
  /// The number of paths of each ray that are followed at once. The summands of its colour and their order depend on no
  /// other ray; and since the latest paths come first, no more paths wait than this number times the depth.
  static constexpr std::size_t at_once = 16;

  /// Takes the latest of the new and the waiting paths of each ray, ray by ray. Returns whether there are any.
  bool next_paths() {
    if (held_ > 0 || born_.has_more_of_a_ray_than(at_once))
      take_latest();
    else
      std::swap(now_, born_);
    born_.clear();
    return !now_.paths.empty();
  }

  void take_latest() {
    now_.clear();
    waiting_.resize(sums_.size());
    std::size_t begin = 0;
    for (std::uint32_t ray = 0; ray < waiting_.size(); ++ray) {
      const std::size_t end = born_.end_of(ray, begin);
      take_latest(waiting_[ray], begin, end);
      begin = end;
    }
  }
  /// Takes the latest paths of one ray, of which those begin … end are new. The others wait.
  void take_latest(Paths& waiting, std::size_t begin, std::size_t end) {
    const std::size_t some = std::min(at_once, end - begin), more = std::min(at_once - some, waiting.paths.size());
    const std::size_t left = waiting.paths.size() - more;
    now_.push(waiting, left, waiting.paths.size());
    waiting.shorten(left);
    waiting.push(born_, begin, end - some);
    now_.push(born_, end - some, end);
    held_ += end - some - begin;
    held_ -= more;
  }

  void meet_all(std::span<const scene::Query> queries) {
    hits_.resize(queries.size());
    followed_.engine.first_hits(queries, hits_);
    for (std::size_t i = 0; i < queries.size(); ++i) meet(now_.paths[i], queries[i], hits_[i]);
    shadows_.add_light(followed_.engine, sums_);
  }

  void meet(const Path& path, const scene::Query& query, const scene::Hit& hit) {
    PathRadiance& sum = sums_[path.ray];
    ++sum.rays;
    sum.depth = std::max(sum.depth, path.depth);
    if (hit.resultado != model::Resultado::hit) {
      sum.color += path.weight * from_nowhere(stage_, query.rayo.v().xyz());
      return;
    }
    const Encounter at = encounter_of(followed_, query, hit, path.way, looks_);
    sum.color += path.weight * (at.look.emission + at.look.ambient);
    if (followed_.caustics)
      sum.color += path.weight * (at.look.k_d * at.look.color * followed_.caustics->irradiance(at.element, hit.punto));
    if (at.look.sends_light()) ask_lights(path, at);
    if (path.depth == limits_.max_depth || !at.look.sends_rays_on()) return;
    send_on(path, at);
  }

  /// flatten compiles into this function and send() all that they call: a ray whose numbers pass through memory on
  /// their way to where it waits is stalled there (the mirrors of demo/ took 5 % longer).
  [[gnu::flatten]] void ask_lights(const Path& path, const Encounter& at) {
    const ShadowStart from{path.ray, at.hit, at.way};
    const std::span<const scene::Light> lights(stage_.lights);
    for (std::size_t i = 0; i < lights.size(); ++i) {
      const scene::Light& light = lights[i];
      const glm::dvec3 to_light = place_of(light, i, path) - at.hit.punto;
      if (to_light == glm::dvec3(0)) continue;  // the light is at the point itself
      const double length = glm::length(to_light);
      const glm::dvec3 l = to_light / length;
      const glm::dvec3 seen = sent(at, l, glm::dot(to_light, at.facing) / length);
      shadows_.points.add(i, from, path.weight * (light.color * followed_.cones.share(i, l) * seen), to_light);
    }
    for (std::size_t i = 0; i < stage_.directional_lights.size(); ++i) {
      const scene::DirectionalLight& light = stage_.directional_lights[i];
      const glm::dvec3 l = -unit(light.direction);
      shadows_.directions.add(i, from, path.weight * (light.color * sent(at, l, glm::dot(l, at.facing))),
                              -light.direction);
    }
  }

  /// The place of light i, as this sample of the ray sees it from there.
  glm::dvec3 place_of(const scene::Light& light, std::size_t i, const Path& path) const {
    if (light.extent.is_point()) return light.position;
    return point_of(light, samples_[path.ray].pair(of_meeting(path.branch) + 1 + i));
  }

  /// The mirrored direction, or one of its lobe: what would lead through the surface is mirrored once more, in it.
  glm::dvec3 glossy_way(const Path& path, const Encounter& at) const {
    const glm::dvec3 way = mirrored_way(at);
    if (std::isinf(at.look.gloss)) return way;
    const glm::dvec3 turned = in_lobe(samples_[path.ray].pair(of_meeting(path.branch)), unit(way), at.look.gloss);
    return glm::dot(turned, at.normal) > 0 ? turned : mirrored(turned, at.normal);
  }

  void send_on(const Path& path, const Encounter& at) {
    const Look& m = at.look;
    glm::dvec3 mirror = m.k_ps * m.M_PS;
    if (m.k_t > 0) {
      const auto [beyond, ratio] = nestings_.cross(path.media, at.enters, *at.material);
      const PathTurn turn{path, m.k_t * m.M_T, beyond, 1};
      if (ratio == 1 && is_sheet(at))
        go_on(turn, at);
      else if (const auto t = through(at, ratio))
        send(turn, at, *t);
      else
        mirror += m.k_t * m.M_T;
    }
    send({path, mirror, path.media, 0}, at, glossy_way(path, at));
  }

  /// A turn that a path takes at a surface.
  struct PathTurn {
    const Path& path;
    glm::dvec3 share;     ///< of the weight
    std::uint32_t media;  ///< the nesting beyond
    std::uint64_t turn;   ///< 0 for a mirror, 1 for what lies behind
  };

  /// Continues the same ray behind a sheet that does not bend it. Its query names the sheet as an origin too, and so it
  /// meets the sheet no more (puntos_desde.def.1); since no new start is rounded, it meets the elements behind as if
  /// there were no sheet.
  void go_on(const PathTurn& turn, const Encounter& at) {
    scene::ElementSet on;
    std::ranges::set_union(at.query.en, at.hit.elementos, std::back_inserter(on));
    send(turn, at.query.rayo, on, turn.path.way);
  }

  /// Sends a ray in a direction from the point of the meeting.
  [[gnu::flatten]] void send(const PathTurn& turn, const Encounter& at, const glm::dvec3& v) {
    send(turn, {model::Punto(at.hit.punto), model::Vector(v)}, at.hit.elementos, at.way);
  }
  void send(const PathTurn& turn, const model::Rayo& ray, const scene::ElementSet& en, double way) {
    const Path& path = turn.path;
    const glm::dvec3 weight = path.weight * turn.share;
    if (weight == glm::dvec3(0)) return;
    if (std::max({weight.x, weight.y, weight.z}) < limits_.min_weight) {
      sums_[path.ray].left_out += weight * followed_.most[limits_.max_depth - path.depth];
      return;
    }
    born_.push({path.ray, path.depth + 1, turn.media, weight, way, 2 * path.branch + turn.turn}, ray, en);
  }

  const TracingContext& followed_;
  const scene::Stage& stage_;
  const PathLimits limits_;
  std::span<PathRadiance> sums_;
  std::span<const SampleSource> samples_;  ///< one for each ray that is asked for
  Nestings nestings_;                      ///< of the media of all paths
  Paths now_, born_;                       ///< the paths that are followed, and the paths that these send on
  std::vector<Paths> waiting_;             ///< the waiting paths of each ray, the next ones last
  std::size_t held_ = 0;                   ///< the number of waiting paths
  std::vector<scene::Hit> hits_;
  ElementLooks looks_;
  Shadows shadows_;
};

}  // namespace

std::unique_ptr<Tracer> whitted_tracer(const TracingContext& context) {
  return std::make_unique<WhittedTracer>(context);
}

}  // namespace durero::render
