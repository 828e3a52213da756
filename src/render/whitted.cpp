#include "durero/render/whitted.hpp"

#include <algorithm>
#include <boost/container/vector.hpp>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <iterator>

#include "durero/model/tipos.hpp"
#include "durero/render/directions.hpp"
#include "durero/render/environment.hpp"
#include "looks.hpp"
#include "media.hpp"

namespace durero::render {
namespace {

/// A ray that is followed for one of the asked ones, whose colour its own is added to by a weight.
struct Path {
  std::size_t ray;
  glm::dvec3 weight;
  std::uint32_t depth;
  scene::Query query;
  Media media;
  double way = 0;  ///< how long it is from the eye to where this ray starts
};

/// Where a path meets a surface.
struct Meeting {
  const Path& path;
  const scene::Hit& hit;
  const scene::Material& material;
  glm::dvec3 normal;  ///< the unit normal on the side of the ray
  glm::dvec3 facing;  ///< the same, as a relief turns it
  glm::dvec3 d;       ///< the unit direction of the ray
  double way;         ///< how long it is from the eye to here
};

/// The element whose look a point has: the first by name.
scene::ElementRef front(const scene::Scene& scene, const scene::ElementSet& elements) {
  return *std::min_element(elements.begin(), elements.end(),
                           [&](auto a, auto b) { return scene.name(a) < scene.name(b); });
}

const scene::Material& material_of(const scene::Scene& scene, std::optional<std::uint32_t> index) {
  static const scene::Material plain{.color = default_color};
  return index ? scene.stage().materials[*index] : plain;
}

/// S's factor in the local model: what of a light of that unit direction is sent towards the ray. No relief sees a
/// light that the surface has its back to.
glm::dvec3 sent(const Meeting& at, const glm::dvec3& l, double cosine) {
  const scene::Material& m = at.material;
  if (!(glm::dot(l, at.normal) > 0)) cosine = 0;
  glm::dvec3 sum = m.color * (m.k_a + m.k_d * std::max(0.0, cosine));
  if (m.k_s > 0 && cosine > 0) {
    // r·v, both taken the other way around: l goes on from the mirror as −r, and d is −v.
    const double towards = glm::dot(mirrored(l, at.facing), at.d);
    sum += glm::dvec3(m.k_s * std::pow(std::max(0.0, towards), m.e));
  }
  return sum;
}

/// Colours that wait for the answer whether a light is seen: a point light at the end of a segment, a directional one
/// along the whole ray.
class Shadows {
 public:
  enum class Way { segment, ray };

  void add(std::size_t ray, const glm::dvec3& light, scene::Query query, Way way) {
    if (light == glm::dvec3(0)) return;
    Asked& asked = way == Way::segment ? segments_ : rays_;
    asked.lights.push_back({ray, light});
    asked.queries.push_back(std::move(query));
  }

  void add_light(const engine::Engine& engine, std::span<Brought> sums) const {
    boost::container::vector<bool> shadowed(segments_.queries.size());
    engine.occluded_segments(segments_.queries, {shadowed.data(), shadowed.size()});
    for (std::size_t i = 0; i < shadowed.size(); ++i)
      if (!shadowed[i]) sums[segments_.lights[i].ray].color += segments_.lights[i].light;
    // occluded.def.1: something is met, be there a nearest point of it or not.
    std::vector<trace::FirstElement> met(rays_.queries.size());
    engine.first_elements(rays_.queries, met);
    for (std::size_t i = 0; i < met.size(); ++i)
      if (met[i].resultado == model::Resultado::miss) sums[rays_.lights[i].ray].color += rays_.lights[i].light;
  }

 private:
  struct Waiting {
    std::size_t ray;
    glm::dvec3 light;
  };
  struct Asked {
    std::vector<Waiting> lights;
    std::vector<scene::Query> queries;
  };
  Asked segments_, rays_;
};

/// The shares of what comes from beyond that a material sends on, at most.
glm::dvec3 sent_on(const scene::Material& m) { return m.k_ps * m.M_PS + m.k_t * m.M_T; }

/// What a ray brings at most that may have so many in a row, itself the first. No cosine is above one: where it meets a
/// surface, the sum of the terms of its material with all lights seen, and what is sent on of as much as a shorter row
/// brings. Both that and the colour are sums of numbers that are not negative, of fewer than 2²⁰ terms, so that the
/// rounding of each is below 2⁻³² of it: 2⁻³⁰ more than the sum is above what is computed.
std::vector<glm::dvec3> most_brought(const scene::Stage& stage, const Limits& limits) {
  glm::dvec3 lights(0), own = default_color, on(0);
  for (const scene::Light& light : stage.lights) lights += light.color;
  for (const scene::DirectionalLight& light : stage.directional_lights) lights += light.color;
  own *= lights;
  for (const scene::Material& m : stage.materials) {
    own = glm::max(own, m.emission + m.ambient + lights * (m.color * (m.k_a + m.k_d) + m.k_s));
    on = glm::max(on, sent_on(m));
  }
  const glm::dvec3 background =
      stage.environment ? most_of(*stage.environment) : stage.background.value_or(default_background);
  std::vector<glm::dvec3> most{glm::dvec3(0)};
  while (most.size() <= limits.max_depth) most.push_back((1 + 0x1p-30) * glm::max(background, own + on * most.back()));
  return most;
}

class Tracer {
 public:
  Tracer(const scene::Scene& scene, const engine::Engine& engine, const Limits& limits, std::span<Brought> sums)
      : scene_(scene),
        engine_(engine),
        limits_(limits),
        looks_(scene.stage()),
        most_(most_brought(scene.stage(), limits)),
        sums_(sums) {}

  void follow(std::span<const scene::Query> rays) {
    waiting_.resize(rays.size());
    for (std::size_t i = 0; i < rays.size(); ++i) waiting_[i].push_back({i, glm::dvec3(1), 1, rays[i], {}});
    for (std::vector<Path> paths = next_paths(); !paths.empty(); paths = next_paths()) follow_batch(paths);
  }

 private:
  /// Of each ray so many paths at once. What is added to its colour, and in which order, depends on no other ray; and
  /// since the latest come first, those that wait are no more than these times the depth.
  static constexpr std::size_t at_once = 16;

  std::vector<Path> next_paths() {
    std::vector<Path> paths;
    for (std::vector<Path>& all : waiting_) {
      const auto begin = all.end() - static_cast<std::ptrdiff_t>(std::min(at_once, all.size()));
      std::move(begin, all.end(), std::back_inserter(paths));
      all.erase(begin, all.end());
    }
    return paths;
  }

  void follow_batch(const std::vector<Path>& paths) {
    std::vector<scene::Query> queries;
    queries.reserve(paths.size());
    for (const Path& path : paths) queries.push_back(path.query);
    const std::vector<scene::Hit> hits = engine::first_hits(engine_, queries);
    Shadows shadows;
    for (std::size_t i = 0; i < paths.size(); ++i) meet(paths[i], hits[i], shadows);
    shadows.add_light(engine_, sums_);
  }

  void meet(const Path& path, const scene::Hit& hit, Shadows& shadows) {
    Brought& sum = sums_[path.ray];
    ++sum.rays;
    sum.depth = std::max(sum.depth, path.depth);
    if (hit.resultado != model::Resultado::hit) {
      sum.color += path.weight * from_nowhere(path.query.rayo.v().xyz());
      return;
    }
    const scene::ElementRef element = front(scene_, hit.elementos);
    const auto index = scene_.material(element);
    glm::dvec3 n = engine_.normal(scene_, element, hit.punto);
    const glm::dvec3 d = unit(path.query.rayo.v().xyz());
    const bool enters = !(glm::dot(n, d) > 0);
    const double way = path.way + glm::distance(path.query.rayo.p().xyz(), hit.punto);
    std::optional<scene::Material> look;
    glm::dvec3 facing = n;
    if (const Worn* worn = looks_.of(index)) {
      const Coordinates coordinates = render::coordinates(scene_, element, hit.punto);
      look = worn->look(coordinates, way);
      facing = worn->normal(tangents(scene_, element, coordinates), n, coordinates);
    }
    if (!enters) n = -n, facing = -facing;       // the side that the ray sees: cylinders and cones are open
    if (!(glm::dot(facing, d) < 0)) facing = n;  // a slope that is turned away is not seen
    const Meeting at{path, hit, look ? *look : material_of(scene_, index), n, facing, d, way};
    sum.color += path.weight * (at.material.emission + at.material.ambient);
    ask_lights(at, shadows);
    if (path.depth == limits_.max_depth || !at.material.sends_rays_on()) return;
    send_on(at, *index, enters);
  }

  glm::dvec3 from_nowhere(const glm::dvec3& v) const {
    const scene::Stage& stage = scene_.stage();
    return stage.environment ? environment_at(*stage.environment, v) : stage.background.value_or(default_background);
  }

  void ask_lights(const Meeting& at, Shadows& shadows) const {
    for (const scene::Light& light : scene_.stage().lights) {
      const glm::dvec3 to_light = light.position - at.hit.punto;
      if (to_light == glm::dvec3(0)) continue;  // a light in the very point
      const double length = glm::length(to_light);
      const glm::dvec3 seen = sent(at, to_light / length, glm::dot(to_light, at.facing) / length);
      shadows.add(at.path.ray, at.path.weight * (light.color * seen),
                  {{model::Punto(at.hit.punto), model::Vector(to_light)}, at.hit.elementos}, Shadows::Way::segment);
    }
    for (const scene::DirectionalLight& light : scene_.stage().directional_lights) {
      const glm::dvec3 l = -unit(light.direction);
      shadows.add(at.path.ray, at.path.weight * (light.color * sent(at, l, glm::dot(l, at.facing))),
                  {{model::Punto(at.hit.punto), model::Vector(-light.direction)}, at.hit.elementos}, Shadows::Way::ray);
    }
  }

  void send_on(const Meeting& at, std::uint32_t material, bool enters) {
    const scene::Material& m = at.material;
    glm::dvec3 mirror = m.k_ps * m.M_PS;
    if (m.k_t > 0) {
      Media beyond = at.path.media;
      const double here = beyond.index(scene_.stage());
      const bool was_in = enters || beyond.leave(material);
      if (enters) beyond.enter(material);
      const double ratio = (was_in ? here : m.index) / beyond.index(scene_.stage());
      if (const auto t = through(at, ratio))
        send(at, m.k_t * m.M_T, *t, std::move(beyond));
      else
        mirror += m.k_t * m.M_T;
    }
    const glm::dvec3 r = mirrored(at.d, at.facing);
    send(at, mirror, glm::dot(r, at.normal) > 0 ? r : mirrored(at.d, at.normal), at.path.media);
  }

  /// The refracted direction. Where a relief sends it back through the surface, as the surface alone has it; likewise
  /// the mirrored one.
  static std::optional<glm::dvec3> through(const Meeting& at, double ratio) {
    const auto t = refracted(at.d, at.facing, ratio);
    return t && !(glm::dot(*t, at.normal) < 0) ? refracted(at.d, at.normal, ratio) : t;
  }

  void send(const Meeting& at, const glm::dvec3& share, const glm::dvec3& v, Media media) {
    const glm::dvec3 weight = at.path.weight * share;
    if (weight == glm::dvec3(0)) return;
    if (std::max({weight.x, weight.y, weight.z}) < limits_.min_weight) {
      sums_[at.path.ray].left_out += weight * most_[limits_.max_depth - at.path.depth];
      return;
    }
    waiting_[at.path.ray].push_back({at.path.ray,
                                     weight,
                                     at.path.depth + 1,
                                     {{model::Punto(at.hit.punto), model::Vector(v)}, at.hit.elementos},
                                     std::move(media),
                                     at.way});
  }

  const scene::Scene& scene_;
  const engine::Engine& engine_;
  const Limits limits_;
  const Looks looks_;
  const std::vector<glm::dvec3> most_;  // that a ray brings, by how many it may still have in a row
  const std::span<Brought> sums_;
  std::vector<std::vector<Path>> waiting_;  // of each ray, the next ones last
};

}  // namespace

std::uint32_t depth_of(const scene::Stage& stage) {
  if (stage.max_depth) return *stage.max_depth;
  constexpr std::uint32_t most = 15;
  constexpr double half_a_step = 1.0 / 510;
  double share = 0;  // the greatest that one meeting hands on
  for (const scene::Material& m : stage.materials) {
    const glm::dvec3 on = sent_on(m);
    share = std::max({share, on.x, on.y, on.z});
  }
  std::uint32_t depth = 1;
  for (double weight = share; weight >= half_a_step && depth < most; weight *= share) ++depth;
  return depth;
}

std::vector<Brought> brought(const scene::Scene& scene, const engine::Engine& engine,
                             std::span<const scene::Query> rays, const Limits& limits) {
  std::vector<Brought> sums(rays.size());
  if (limits.max_depth > 0) Tracer(scene, engine, limits, sums).follow(rays);
  return sums;
}

}  // namespace durero::render
