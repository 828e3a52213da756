// durero spec confirm SCENE RAYS HITS: the Z text decides whether hits are right. The text knows the points of a ray by
// membership, not by enumeration; the exact oracle says which points they are, and the text then decides each of them,
// the set of elements, and the reduction over all of them.
#include <fmt/format.h>

#include "durero/io/hits_file.hpp"
#include "durero/io/output_file.hpp"
#include "durero/io/rays_file.hpp"
#include "durero/io/scene_file.hpp"
#include "durero/oracle/exact.hpp"
#include "durero/oracle/spec.hpp"
#include "durero/scene/retrieve.hpp"
#include "spec.hpp"

namespace durero::cli {
namespace {

using model::ExactPoint;
using oracle::exact::Crossing;

/// Why a hit is not confirmed: the predicate, or the rounding. Empty where it is.
using Verdict = std::string;

struct Confirmation {
  const scene::Scene& scene;
  const zed::Value theta = oracle::spec::value(scene::retrieve(scene));
  const oracle::spec::Judge judge{};

  std::set<model::Elemento> names(const scene::ElementSet& elements) const {
    std::set<model::Elemento> made;
    for (const scene::ElementRef one : elements) made.insert(scene.name(one));
    return made;
  }

  Verdict of(const io::Ray& ray, const scene::Hit& hit) const {
    const auto crossings = oracle::exact::all_hits(scene, ray.rayo, {ray.en.data(), ray.en.size()});
    switch (hit.resultado) {
      case model::Resultado::hit:
        return of_hit(ray, hit, crossings);
      case model::Resultado::miss:
        return crossings.empty() ? "" : "No_Hay_Interseccion.pre.1: " + within(ray, crossings);
      case model::Resultado::no_minimum:
        return of_no_minimum(ray, hit, crossings);
    }
    return {};
  }

 private:
  static ExactPoint at(const io::Ray& ray, const number::Surd& t) {
    return model::along(ray.rayo.p(), ray.rayo.v(), t);
  }
  static ExactPoint at(const io::Ray& ray, const oracle::exact::Parameter& t) { return at(ray, number::Surd(t)); }

  bool on(const ExactPoint& p, const io::Ray& ray, scene::ElementRef element) const {
    return judge.in_alcance(p, theta, ray.rayo, names(ray.en), scene.name(element));
  }

  // A crossing's point that is nearest to the origin; where there is none, one near to it.
  static ExactPoint nearest(const io::Ray& ray, const Crossing& one) {
    if (one.segment.begin) return at(ray, *one.segment.begin);
    const number::Surd end = one.segment.end ? number::Surd(*one.segment.end) : number::Surd(1);
    return at(ray, end * number::Surd(0x1p-60));
  }

  // Where a miss is claimed: a point that the text finds on an element.
  std::string within(const io::Ray& ray, const std::vector<Crossing>& crossings) const {
    const Crossing& one = crossings.front();
    const char* says =
        on(nearest(ray, one), ray, one.elemento) ? "the text has a point of the ray on " : "the oracle meets ";
    return says + scene.name(one.elemento).name();
  }

  Verdict of_hit(const io::Ray& ray, const scene::Hit& hit, const std::vector<Crossing>& crossings) const {
    std::vector<ExactPoint> points;
    std::optional<ExactPoint> named;
    for (const Crossing& one : crossings) {
      if (!one.segment.begin)
        return "Hay_Interseccion.pre.1: no point is nearest on " + scene.name(one.elemento).name();
      points.push_back(nearest(ray, one));
      const scene::Hit rounded = oracle::exact::rounded_hit(ray.rayo, *one.segment.begin, hit.elementos);
      if (!named && rounded == hit) named = points.back();
    }
    if (!named) return "no intersection has t and point that round to those of the hit";
    if (!judge.in_puntos_de_rayo(*named, ray.rayo)) return "punto! ∉ puntos_de_rayo(rayo?)";
    if (ray.en.empty() && !judge.in_puntos_de_escena(*named, theta)) return "punto! ∉ puntos_de_escena(θEscena)";
    if (elements(*named, ray) != names(hit.elementos)) return "Hay_Interseccion.post.3: elementos! are others";
    const auto reduced = judge.reduccion(points, ray.rayo.p());
    if (!reduced || !zed::same(*reduced, oracle::spec::value(*named)))
      return "Hay_Interseccion.post.1: another is nearer";
    return {};
  }

  std::set<model::Elemento> elements(const ExactPoint& p, const io::Ray& ray) const {
    if (ray.en.empty()) return judge.de_que_elemento(theta, p);
    std::set<model::Elemento> found;
    for (const model::Elemento& e : scene::retrieve(scene).elementos) {
      if (judge.in_alcance(p, theta, ray.rayo, names(ray.en), e)) found.insert(e);
    }
    return found;
  }

  // The elements named are those that the ray runs in from its origin on: points ever nearer to it lie on them.
  Verdict of_no_minimum(const io::Ray& ray, const scene::Hit& hit, const std::vector<Crossing>& crossings) const {
    scene::ElementSet inside;
    for (const Crossing& one : crossings) {
      if (one.segment.begin) continue;
      inside.push_back(one.elemento);
      const number::Surd end = one.segment.end ? number::Surd(*one.segment.end) : number::Surd(1);
      for (const double part : {1.0, 0.5, 0x1p-30, 0x1p-60}) {
        if (!on(at(ray, end * number::Surd(part)), ray, one.elemento)) return "a point is not on the surface";
      }
    }
    if (inside.empty()) return "No_Hay_Minimo.pre.2: the nearest point exists, or none at all";
    if (names(inside) != names(hit.elementos)) return "No_Hay_Minimo.post.1: elementos! are others";
    return {};
  }
};

}  // namespace

int spec_confirm(const std::string& scene_path, const std::string& rays_path, const std::string& hits_path) {
  const scene::Scene scene = io::read_scene(io::read_source(scene_path));
  const std::vector<io::Ray> rays = io::read_rays(io::read_source(rays_path), scene);
  const io::Source source = io::read_source(hits_path);
  const Confirmation confirmation{scene};
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
