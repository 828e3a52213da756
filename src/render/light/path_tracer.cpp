#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <iterator>
#include <limits>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "durero/contract/contract.hpp"
#include "durero/render/light/extent.hpp"
#include "durero/scene/stage.hpp"
#include "emitters.hpp"
#include "encounter.hpp"
#include "media.hpp"
#include "scattering.hpp"
#include "shadows.hpp"
#include "tracer.hpp"

namespace durero::render {
namespace {

/// The density of a direction that nothing else draws: of the eye's, and of those of mirrors and glass.
constexpr double sharp = std::numeric_limits<double>::infinity();

/// @{ The numbers of a meeting, from of_meeting() on.
constexpr std::uint64_t of_direction = 0, of_choices = 1, of_emitter = 2, of_roulette = 3, of_first_light = 16;
/// @}

/// The meetings before Russian roulette begins: short paths count most, and end by themselves.
constexpr std::uint32_t before_roulette = 4;

/// A path on its way.
struct PathWalk {
  std::uint32_t ray = 0;
  glm::dvec3 weight{1};
  std::uint32_t depth = 1;
  Media media{};
  double way = 0;
  double density = sharp;  ///< of its direction, by solid angle
};

/// Light of an emitter that waits for the answer whether the point sees it.
struct WaitingLight {
  std::uint32_t ray;
  glm::dvec3 weight;  ///< of the emission
  EmitterDraw draw;
};

/// Lights that wait, with a query each.
struct WaitingLights {
  void push(WaitingLight light, scene::Query query) {
    waiting.push_back(std::move(light));
    queries.push_back(std::move(query));
  }
  void clear() {
    waiting.clear();
    queries.clear();
  }

  std::vector<WaitingLight> waiting{};
  std::vector<scene::Query> queries{};
};

/// The path tracer (Kajiya, *The rendering equation*, 1986): at each meeting, light of the emitters is drawn by points
/// of them and by the next direction, each with the weight of Veach's balance heuristic (1995), whose sum is one
/// (repartida.def.1 of spec/distribuida.tex); and a path ends by Russian roulette (ruleta.def.1).
class PathTracer : public Tracer {
 public:
  explicit PathTracer(const TracingContext& context)
      : context_(context),
        stage_(context.scene.stage()),
        emitters_(context.scene, context.engine),
        looks_(context),
        shadows_(context) {}

  void follow(std::span<const scene::Query> rays, std::span<const SampleSource> samples,
              std::span<PathRadiance> sums) override {
    sums_ = sums;
    samples_ = samples;
    walks_.assign(rays.size(), {});
    for (std::uint32_t i = 0; i < rays.size(); ++i) walks_[i].ray = i;
    queries_.assign(rays.begin(), rays.end());
    while (!walks_.empty()) meet_all();
  }

 private:
  void meet_all() {
    hits_.resize(queries_.size());
    context_.engine.first_hits(queries_, hits_);
    std::vector<PathWalk> now = std::exchange(walks_, {});
    const std::vector<scene::Query> asked = std::exchange(queries_, {});
    for (std::size_t i = 0; i < now.size(); ++i) meet(now[i], asked[i], hits_[i]);
    shadows_.add_light(context_.engine, sums_);
    add_emitters();
  }

  void meet(PathWalk& walk, const scene::Query& query, const scene::Hit& hit) {
    PathRadiance& sum = sums_[walk.ray];
    ++sum.rays;
    sum.depth = std::max(sum.depth, walk.depth);
    if (hit.resultado != model::Resultado::hit) {
      sum.color += walk.weight * from_nowhere(stage_, query.rayo.v().xyz());
      return;
    }
    const Encounter at = encounter_of(context_, query, hit, walk.way, looks_);
    if (at.look.emission != glm::dvec3(0)) sum.color += walk.weight * at.look.emission * weight_of_direction(walk, at);
    const FarSide behind = far_side(walk, at);
    const Scattering scattering(at, behind.way.has_value());
    if (scattering.is_black()) return;
    const std::uint64_t dimension = of_meeting(walk.depth);
    if (scattering.is_smooth()) ask_lights(walk, at, scattering, dimension);
    if (walk.depth == context_.limits.max_depth) return;  // emitters are met by the next ray of the row
    const glm::dvec2 choices = samples_[walk.ray].pair(dimension + of_choices);
    if (scattering.is_smooth()) ask_emitters(walk, at, scattering, choices.x, dimension);
    send_on(walk, at, scattering, choices.y, behind);
  }

  /// The far side of a surface, where light may go on.
  struct FarSide {
    Media media{};
    std::optional<glm::dvec3> way{};  ///< the refracted direction
    bool is_straight = false;         ///< whether the same ray goes on, behind a sheet that does not bend it
  };

  FarSide far_side(const PathWalk& walk, const Encounter& at) const {
    if (!(at.look.k_t > 0)) return {};
    auto [media, ratio] = beyond_of(at, walk.media, stage_);
    return {std::move(media), through(at, ratio), ratio == 1 && is_sheet(at)};
  }

  /// Sends a path on along one lobe of the surface.
  void send_on(const PathWalk& walk, const Encounter& at, const Scattering& scattering, double choice,
               const FarSide& behind) {
    PathWalk next = walk;
    next.depth = walk.depth + 1;
    next.way = at.way;
    next.density = sharp;
    glm::dvec3 v = scattering.mirrored();
    switch (scattering.chosen(choice)) {
      case Scattering::Lobe::smooth:
        v = scattering.direction(choice, samples_[walk.ray].pair(of_meeting(walk.depth) + of_direction));
        next.density = scattering.density(v);
        next.weight = next.density > 0 ? next.weight * scattering.sent(v) / next.density : glm::dvec3(0);
        break;
      case Scattering::Lobe::mirror:
        next.weight *= scattering.of_mirror();
        break;
      case Scattering::Lobe::beyond:
        next.weight *= scattering.of_beyond();
        next.media = behind.media;
        v = *behind.way;
        // Behind a sheet its density is that of a sharp lobe too: the sheet hides the points that are drawn.
        if (behind.is_straight) return go_on(std::move(next), at, walk.way);
        break;
    }
    go(std::move(next), {{model::Punto(at.hit.punto), model::Vector(v)}, at.hit.elementos});
  }

  /// The weight of the emission that a direction leads to, beside points of the emitter that might have been drawn.
  double weight_of_direction(const PathWalk& walk, const Encounter& at) const {
    if (walk.density == sharp || context_.limits.light_sampling == LightSampling::directions) return 1;
    const double other = emitters_.density(at.query.rayo.p().xyz(), at.query.en, at.element, at.hit.punto, at.normal);
    if (context_.limits.light_sampling == LightSampling::lights) return other > 0 ? 0 : 1;
    return walk.density / (walk.density + other);
  }

  void ask_lights(const PathWalk& walk, const Encounter& at, const Scattering& scattering, std::uint64_t dimension) {
    const auto seen = [&](const glm::dvec3& color, const glm::dvec3& l) {
      return walk.weight * color * scattering.of_light(l);
    };
    const ShadowStart from{walk.ray, at.hit, at.way};
    for (std::size_t i = 0; i < stage_.lights.size(); ++i) {
      const scene::Light& light = stage_.lights[i];
      const glm::dvec3 to = point_of(light, samples_[walk.ray].pair(dimension + of_first_light + i)) - at.hit.punto;
      if (to == glm::dvec3(0)) continue;
      const glm::dvec3 l = unit(to);
      shadows_.points.add(i, from, seen(light.color * context_.cones.share(i, l), l), to);
    }
    for (std::size_t i = 0; i < stage_.directional_lights.size(); ++i) {
      const scene::DirectionalLight& light = stage_.directional_lights[i];
      const glm::dvec3 l = -unit(light.direction);
      shadows_.directions.add(i, from, seen(light.color, l), -light.direction);
    }
  }

  void ask_emitters(const PathWalk& walk, const Encounter& at, const Scattering& scattering, double choice,
                    std::uint64_t dimension) {
    if (emitters_.empty() || context_.limits.light_sampling == LightSampling::directions) return;
    const glm::dvec3& from = at.hit.punto;
    const EmitterDraw draw =
        emitters_.draw(from, at.hit.elementos, choice, samples_[walk.ray].pair(dimension + of_emitter));
    if (!(draw.density > 0)) return;
    const glm::dvec3 l = unit(draw.way), sent = scattering.sent(l);
    if (sent == glm::dvec3(0)) return;
    const bool is_alone = context_.limits.light_sampling == LightSampling::lights;
    const double share = 1 / (draw.density + (is_alone ? 0 : scattering.density(l)));
    // What is flat and shines alike everywhere is met from the side that it was drawn on, and needs no point.
    const bool is_even = surface::is_flat(draw.element.tipo) && context_.look_of(draw.element).is_bare();
    (is_even ? even_ : pointed_)
        .push({walk.ray, walk.weight * sent * share, draw},
              {{model::Punto(from), model::Vector(draw.way)}, at.hit.elementos});
  }

  /// Adds the light of the emitters that are seen: that their ray meets first, where it was drawn.
  void add_emitters() {
    add_even_emitters();
    light_hits_.resize(pointed_.queries.size());
    context_.engine.first_hits(pointed_.queries, light_hits_);
    for (std::size_t i = 0; i < pointed_.waiting.size(); ++i) {
      const scene::Hit& hit = light_hits_[i];
      const WaitingLight& light = pointed_.waiting[i];
      if (hit.resultado != model::Resultado::hit || front(context_.scene, hit.elementos) != light.draw.element)
        continue;
      const Encounter there = encounter_of(context_, pointed_.queries[i], hit, 0, looks_);
      if (light.draw.is_sided && there.enters == light.draw.leaves) continue;
      sums_[light.ray].color += light.weight * there.look.emission;
    }
    pointed_.clear();
  }

  /// Adds the light of those that need no point. Where several elements are met, the point may have another look.
  void add_even_emitters() {
    light_elements_.resize(even_.queries.size());
    context_.engine.first_elements(even_.queries, light_elements_);
    for (std::size_t i = 0; i < even_.waiting.size(); ++i) {
      const trace::FirstElement& met = light_elements_[i];
      WaitingLight& light = even_.waiting[i];
      if (met.resultado != model::Resultado::hit) continue;
      if (met.count > 1) {
        pointed_.push(std::move(light), std::move(even_.queries[i]));
      } else if (met.least == light.draw.element) {
        sums_[light.ray].color += light.weight * context_.look_of(light.draw.element).plain.emission;
      }
    }
    even_.clear();
  }

  /// Continues the same ray behind a sheet that does not bend it, as Whitted's algorithm does.
  void go_on(PathWalk next, const Encounter& at, double way) {
    scene::ElementSet on;
    std::ranges::set_union(at.query.en, at.hit.elementos, std::back_inserter(on));
    next.way = way;
    go(std::move(next), {at.query.rayo, std::move(on)});
  }

  /// Sends a path on, or ends it by Russian roulette, with a chance that is no less than its weight.
  void go(PathWalk next, scene::Query query) {
    double chance = std::max({next.weight.x, next.weight.y, next.weight.z});
    if (!(chance > 0)) return;
    if (next.depth > before_roulette && chance < 1) {
      if (samples_[next.ray].pair(of_meeting(next.depth - 1) + of_roulette).x >= chance) return;
      next.weight /= chance;
    }
    walks_.push_back(std::move(next));
    queries_.push_back(std::move(query));
  }

  const TracingContext& context_;
  const scene::Stage& stage_;
  const Emitters emitters_;
  std::span<PathRadiance> sums_;
  std::span<const SampleSource> samples_;
  std::vector<PathWalk> walks_;
  std::vector<scene::Query> queries_;
  WaitingLights even_, pointed_;  // that need no point of the emitter, and that do
  std::vector<scene::Hit> hits_, light_hits_;
  std::vector<trace::FirstElement> light_elements_;
  ElementLooks looks_;
  Shadows shadows_;
};

}  // namespace

std::unique_ptr<Tracer> path_tracer(const TracingContext& context) { return std::make_unique<PathTracer>(context); }

}  // namespace durero::render
