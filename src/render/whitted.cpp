#include "durero/render/whitted.hpp"

#include <algorithm>
#include <boost/container/vector.hpp>
#include <cmath>
#include <glm/geometric.hpp>
#include <iterator>

#include "durero/model/tipos.hpp"
#include "durero/render/directions.hpp"
#include "durero/surface/normal.hpp"
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
};

/// Where a path meets a surface.
struct Meeting {
  const Path& path;
  const scene::Hit& hit;
  const scene::Material& material;
  glm::dvec3 normal;  ///< the unit normal on the side of the ray
  glm::dvec3 d;       ///< the unit direction of the ray
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

/// S's factor in the local model: what of a light of that unit direction is sent towards the ray.
glm::dvec3 sent(const Meeting& at, const glm::dvec3& l, double cosine) {
  const scene::Material& m = at.material;
  glm::dvec3 sum = m.color * (m.k_a + m.k_d * std::max(0.0, cosine));
  if (m.k_s > 0 && cosine > 0) {
    // r·v, both taken the other way around: l goes on from the mirror as −r, and d is −v.
    const double towards = glm::dot(mirrored(l, at.normal), at.d);
    sum += glm::dvec3(m.k_s * std::pow(std::max(0.0, towards), m.e));
  }
  return sum;
}

/// Colours that wait for the answer whether a light is seen.
class Shadows {
 public:
  void add(std::size_t ray, const glm::dvec3& light, scene::Query query) {
    if (light == glm::dvec3(0)) return;
    lights_.push_back({ray, light});
    queries_.push_back(std::move(query));
  }

  void add_light(const engine::Engine& engine, std::span<glm::dvec3> sums) const {
    boost::container::vector<bool> shadowed(queries_.size());
    engine.occluded_segments(queries_, {shadowed.data(), shadowed.size()});
    for (std::size_t i = 0; i < queries_.size(); ++i)
      if (!shadowed[i]) sums[lights_[i].ray] += lights_[i].light;
  }

 private:
  struct Waiting {
    std::size_t ray;
    glm::dvec3 light;
  };
  std::vector<Waiting> lights_;
  std::vector<scene::Query> queries_;
};

class Tracer {
 public:
  Tracer(const scene::Scene& scene, const engine::Engine& engine, std::uint32_t max_depth, std::span<glm::dvec3> sums)
      : scene_(scene), engine_(engine), max_depth_(max_depth), sums_(sums) {}

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
    if (hit.resultado != model::Resultado::hit) {
      sums_[path.ray] += path.weight * scene_.stage().background.value_or(default_background);
      return;
    }
    const scene::ElementRef element = front(scene_, hit.elementos);
    const auto index = scene_.material(element);
    glm::dvec3 n = surface::normal(scene_, element, hit.punto);
    const glm::dvec3 d = unit(path.query.rayo.v().xyz());
    const bool enters = !(glm::dot(n, d) > 0);
    if (!enters) n = -n;  // the side that the ray sees: cylinders and cones are open
    const Meeting at{path, hit, material_of(scene_, index), n, d};
    sums_[path.ray] += path.weight * (at.material.emission + at.material.ambient);
    ask_lights(at, shadows);
    if (path.depth == max_depth_ || !at.material.sends_rays_on()) return;
    send_on(at, *index, enters);
  }

  void ask_lights(const Meeting& at, Shadows& shadows) const {
    for (const scene::Light& light : scene_.stage().lights) {
      const glm::dvec3 to_light = light.position - at.hit.punto;
      if (to_light == glm::dvec3(0)) continue;  // a light in the very point
      const double length = glm::length(to_light);
      const glm::dvec3 seen = sent(at, to_light / length, glm::dot(to_light, at.normal) / length);
      shadows.add(at.path.ray, at.path.weight * (light.color * seen),
                  {{model::Punto(at.hit.punto), model::Vector(to_light)}, at.hit.elementos});
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
      if (const auto t = refracted(at.d, at.normal, ratio))
        send(at, m.k_t * m.M_T, *t, std::move(beyond));
      else
        mirror += m.k_t * m.M_T;
    }
    send(at, mirror, mirrored(at.d, at.normal), at.path.media);
  }

  void send(const Meeting& at, const glm::dvec3& share, const glm::dvec3& v, Media media) {
    const glm::dvec3 weight = at.path.weight * share;
    if (weight == glm::dvec3(0)) return;
    waiting_[at.path.ray].push_back({at.path.ray,
                                     weight,
                                     at.path.depth + 1,
                                     {{model::Punto(at.hit.punto), model::Vector(v)}, at.hit.elementos},
                                     std::move(media)});
  }

  const scene::Scene& scene_;
  const engine::Engine& engine_;
  const std::uint32_t max_depth_;
  const std::span<glm::dvec3> sums_;
  std::vector<std::vector<Path>> waiting_;  // of each ray, the next ones last
};

}  // namespace

std::uint32_t depth_of(const scene::Stage& stage) {
  if (stage.max_depth) return *stage.max_depth;
  constexpr std::uint32_t most = 15;
  constexpr double half_a_step = 1.0 / 510;
  double share = 0;  // the greatest that one meeting hands on
  for (const scene::Material& m : stage.materials) {
    const glm::dvec3 sent_on = m.k_ps * m.M_PS + m.k_t * m.M_T;
    share = std::max({share, sent_on.x, sent_on.y, sent_on.z});
  }
  std::uint32_t depth = 1;
  for (double weight = share; weight >= half_a_step && depth < most; weight *= share) ++depth;
  return depth;
}

std::vector<glm::dvec3> colors(const scene::Scene& scene, const engine::Engine& engine,
                               std::span<const scene::Query> rays, std::uint32_t max_depth) {
  std::vector<glm::dvec3> sums(rays.size(), glm::dvec3(0));
  if (max_depth == 0) return sums;
  Tracer(scene, engine, max_depth, sums).follow(rays);
  return sums;
}

}  // namespace durero::render
