#include "durero/spec/confirmation.hpp"

#include <algorithm>
#include <bit>
#include <cstdint>

#include "durero/scene/retrieve.hpp"

namespace durero::spec {
namespace {

using model::ExactPoint;
using number::Surd;
using Elements = std::set<model::Elemento>;
using Objection = std::optional<std::string>;

/// A point of the ray, and its parameter.
struct PointOfRay {
  Surd t;
  ExactPoint point;
};

/// +0 and −0 are two results: the value that is rounded tells which of them is right.
bool same_bits(double a, double b) { return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b); }

/// t and each coordinate of the point, rounded once, are those of the hit.
bool rounds_to(const PointOfRay& exact, const scene::Hit& hit) {
  const auto rounds = [](const Surd& value, double to) { return same_bits(number::round_to_binary64(value), to); };
  return rounds(exact.t, hit.t) && rounds(exact.point.x, hit.punto.x) && rounds(exact.point.y, hit.punto.y) &&
         rounds(exact.point.z, hit.punto.z);
}

/// The point that is reduccion(points, ojo); null outside the domain of reduccion.
const PointOfRay* reduction(const Judge& judge, const std::vector<PointOfRay>& points, const model::Punto& ojo) {
  std::vector<ExactPoint> places;
  places.reserve(points.size());
  for (const PointOfRay& p : points) places.push_back(p.point);
  const std::optional<zed::Value> reduced = judge.reduccion(places, ojo);
  if (!reduced) return nullptr;
  return &*std::ranges::find_if(points, [&](const PointOfRay& p) { return zed::same(*reduced, value(p.point)); });
}

}  // namespace

struct Confirmation::Question {
  struct OnElement {
    model::Elemento e;
    Extent extent;
  };

  const model::Rayo& rayo;
  Elements en;
  std::vector<OnElement> on_elements;

  /// The points of the ray that stand alone or begin or end a stretch, on any element. A stretch behind its first point
  /// is farther than that point, so the reduction of the ray's points is that of these.
  std::vector<PointOfRay> points() const {
    std::vector<PointOfRay> points;
    for (const auto& [e, extent] : on_elements) {
      for (std::size_t i = 0; i < extent.at.size(); ++i) {
        if (extent.on[i]) points.push_back({extent.at[i], model::along(rayo.p(), rayo.v(), extent.at[i])});
      }
    }
    return points;
  }
};

Confirmation::Confirmation(const scene::Scene& scene)
    : scene_(scene), escena_(scene::retrieve(scene)), theta_(value(escena_)) {}

Elements Confirmation::names(const scene::ElementSet& elements) const {
  Elements names;
  for (const scene::ElementRef e : elements) names.insert(scene_.name(e));
  return names;
}

Objection Confirmation::objection(const scene::Query& query, const scene::Hit& hit) const {
  Question question{query.rayo, names(query.en), {}};
  for (const model::Elemento& e : escena_.elementos) {
    question.on_elements.push_back({e, alcance(judge_, theta_, query.rayo, question.en, e)});
  }
  switch (hit.resultado) {
    case model::Resultado::hit:
      return objection_to_hit(question, hit);
    case model::Resultado::miss:
      return objection_to_miss(question, hit);
    case model::Resultado::no_minimum:
      return objection_to_no_minimum(question, hit);
  }
  return "Primera_Interseccion: resultado! is none of its three";
}

Objection Confirmation::objection_to_miss(const Question& question, const scene::Hit& hit) {
  for (const auto& [e, extent] : question.on_elements) {
    if (!extent.empty()) return "No_Hay_Interseccion.pre.1: a point of the ray lies on " + e.name();
  }
  if (!hit.elementos.empty()) return "No_Hay_Interseccion.post.1: elementos! are others";
  return std::nullopt;
}

Objection Confirmation::objection_to_hit(const Question& question, const scene::Hit& hit) const {
  for (const auto& [e, extent] : question.on_elements) {
    if (extent.no_minimum()) return "Hay_Interseccion.pre.1: no point is nearest on " + e.name();
  }
  const std::vector<PointOfRay> points = question.points();
  // The reduction is taken among exact points, and only then rounded: a farther point may round to the same numbers.
  const PointOfRay* nearest = reduction(judge_, points, question.rayo.p());
  if (!nearest) return "Hay_Interseccion.pre.1: no point of the ray lies on an element";
  if (!rounds_to(*nearest, hit)) {
    return std::ranges::any_of(points, [&](const PointOfRay& p) { return rounds_to(p, hit); })
               ? "Hay_Interseccion.post.1: another is nearer"
               : "no intersection has t and point that round to those of the hit";
  }
  if (!judge_.in_puntos_de_rayo(nearest->point, question.rayo)) return "punto! ∉ puntos_de_rayo(rayo?)";
  if (question.en.empty() && !judge_.in_puntos_de_escena(nearest->point, theta_)) {
    return "punto! ∉ puntos_de_escena(θEscena)";
  }
  if (elements_at(nearest->point, question) != names(hit.elementos)) {
    return "Hay_Interseccion.post.3: elementos! are others";
  }
  return std::nullopt;
}

Elements Confirmation::elements_at(const ExactPoint& point, const Question& question) const {
  if (question.en.empty()) return judge_.de_que_elemento(theta_, point);
  Elements elements;
  for (const model::Elemento& e : escena_.elementos) {
    if (judge_.in_alcance(point, theta_, question.rayo, question.en, e)) elements.insert(e);
  }
  return elements;
}

// What has no nearest point starts at t → 0⁺, so where one element has none, all of them together have none.
Objection Confirmation::objection_to_no_minimum(const Question& question, const scene::Hit& hit) const {
  Elements with, without;
  for (const auto& [e, extent] : question.on_elements) {
    if (!extent.empty()) (extent.no_minimum() ? without : with).insert(e);
  }
  if (without.empty() && with.empty()) return "No_Hay_Minimo.pre.1: no point of the ray lies on an element";
  if (without.empty()) return "No_Hay_Minimo.pre.2: a nearest point exists";
  if (without != names(hit.elementos)) return "No_Hay_Minimo.post.1: elementos! are others";
  return std::nullopt;
}

}  // namespace durero::spec
