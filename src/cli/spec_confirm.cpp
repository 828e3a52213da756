// durero spec confirm SCENE RAYS HITS: the Z text decides whether hits are right. It knows the points of a ray by
// membership, not by enumeration; but where along a ray its predicate can change from true to false it says itself
// (oracle::spec::alcance). So which points they are, that a miss is one, and that no point is nearest, is its word too.
#include <fmt/format.h>

#include "durero/io/hits_file.hpp"
#include "durero/io/output_file.hpp"
#include "durero/io/rays_file.hpp"
#include "durero/io/scene_file.hpp"
#include "durero/oracle/spec_ray.hpp"
#include "durero/scene/retrieve.hpp"
#include "spec.hpp"

namespace durero::cli {
namespace {

using model::ExactPoint;
using number::Surd;
using oracle::spec::Extent;

/// Why a hit is not confirmed: the predicate, or the rounding. Empty where it is.
using Verdict = std::string;

/// What the text finds of the ray on one element.
struct Met {
  model::Elemento e;
  Extent extent;
};

class Confirmation {
 public:
  explicit Confirmation(const scene::Scene& scene) : scene_(scene) {}

  Verdict of(const io::Ray& ray, const scene::Hit& hit) const {
    std::vector<Met> all;
    all.reserve(escena_.elementos.size());
    for (const model::Elemento& e : escena_.elementos) {
      all.push_back({e, oracle::spec::alcance(judge_, theta_, ray.rayo, names(ray.en), e)});
    }
    switch (hit.resultado) {
      case model::Resultado::hit:
        return of_hit(ray, hit, all);
      case model::Resultado::miss:
        return of_miss(all);
      case model::Resultado::no_minimum:
        return of_no_minimum(hit, all);
    }
    return {};
  }

 private:
  using Names = std::set<model::Elemento>;

  template <class Elements>
  Names names(const Elements& elements) const {
    Names made;
    for (const scene::ElementRef one : elements) made.insert(scene_.name(one));
    return made;
  }

  static ExactPoint at(const io::Ray& ray, const Surd& t) { return model::along(ray.rayo.p(), ray.rayo.v(), t); }

  // t and the point, each number rounded once, are those of the hit.
  static bool rounds_to(const Surd& t, const ExactPoint& p, const scene::Hit& hit) {
    using number::round_to_binary64;
    return round_to_binary64(t) == hit.t &&
           glm::dvec3(round_to_binary64(p.x), round_to_binary64(p.y), round_to_binary64(p.z)) == hit.punto;
  }

  static Verdict of_miss(const std::vector<Met>& all) {
    for (const Met& one : all) {
      if (!one.extent.empty()) return "No_Hay_Interseccion.pre.1: a point of the ray lies on " + one.e.name();
    }
    return {};
  }

  Verdict of_hit(const io::Ray& ray, const scene::Hit& hit, const std::vector<Met>& all) const {
    std::vector<ExactPoint> points;
    std::optional<ExactPoint> named;
    for (const Met& one : all) {
      if (one.extent.no_minimum()) return "Hay_Interseccion.pre.1: no point is nearest on " + one.e.name();
      for (std::size_t i = 0; i < one.extent.at.size(); ++i) {
        if (!one.extent.on[i]) continue;
        points.push_back(at(ray, one.extent.at[i]));
        if (!named && rounds_to(one.extent.at[i], points.back(), hit)) named = points.back();
      }
    }
    if (points.empty()) return "Hay_Interseccion.pre.1: no point of the ray lies on an element";
    if (!named) return "no intersection has t and point that round to those of the hit";
    if (!judge_.in_puntos_de_rayo(*named, ray.rayo)) return "punto! ∉ puntos_de_rayo(rayo?)";
    if (ray.en.empty() && !judge_.in_puntos_de_escena(*named, theta_)) return "punto! ∉ puntos_de_escena(θEscena)";
    if (elements(*named, ray) != names(hit.elementos)) return "Hay_Interseccion.post.3: elementos! are others";
    // A stretch behind its first point is farther than that point, which is among these.
    const auto reduced = judge_.reduccion(points, ray.rayo.p());
    if (!reduced || !zed::same(*reduced, oracle::spec::value(*named)))
      return "Hay_Interseccion.post.1: another is nearer";
    return {};
  }

  Names elements(const ExactPoint& p, const io::Ray& ray) const {
    if (ray.en.empty()) return judge_.de_que_elemento(theta_, p);
    Names found;
    for (const model::Elemento& e : escena_.elementos) {
      if (judge_.in_alcance(p, theta_, ray.rayo, names(ray.en), e)) found.insert(e);
    }
    return found;
  }

  // What has no nearest point starts at t → 0⁺, so where one element has none, all of them together have none.
  Verdict of_no_minimum(const scene::Hit& hit, const std::vector<Met>& all) const {
    Names without, with;
    for (const Met& one : all) {
      if (!one.extent.empty()) (one.extent.no_minimum() ? without : with).insert(one.e);
    }
    if (without.empty() && with.empty()) return "No_Hay_Minimo.pre.1: no point of the ray lies on an element";
    if (without.empty()) return "No_Hay_Minimo.pre.2: a nearest point exists";
    if (without != names(hit.elementos)) return "No_Hay_Minimo.post.1: elementos! are others";
    return {};
  }

  const scene::Scene& scene_;
  const model::Escena escena_ = scene::retrieve(scene_);
  const zed::Value theta_ = oracle::spec::value(escena_);
  const oracle::spec::Judge judge_{};
};

}  // namespace

int spec_confirm(const std::string& scene_path, const std::string& rays_path, const std::string& hits_path) {
  const scene::Scene scene = io::read_scene(io::read_source(scene_path));
  const std::vector<io::Ray> rays = io::read_rays(io::read_source(rays_path), scene);
  const io::Source source = io::read_source(hits_path);
  const Confirmation confirmation(scene);
  int status = 0;
  std::string lines;
  for (const io::RayHit& one : io::read_hits(source, scene)) {
    if (one.ray >= rays.size()) {
      throw io::FileError(source.name(), fmt::format("it names ray {} of {}", one.ray, rays.size()),
                          "expected hits of the rays of the ray file");
    }
    const Verdict why = confirmation.of(rays[one.ray], one.hit);
    lines += fmt::format(R"({{"ray":{},"confirmed":{}{}}})", one.ray, why.empty(),
                         why.empty() ? "" : fmt::format(R"(,"predicate":"{}")", why)) +
             "\n";
    if (!why.empty()) status = 1;
  }
  io::write_file("-", lines);
  return status;
}

}  // namespace durero::cli
