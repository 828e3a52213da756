// Rays: first hits in the lines of `durero trace`, every crossing exactly, and the rays to the lights.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <type_traits>

#include "calls.hpp"
#include "crossings.hpp"
#include "durero/io/json/asked_parts.hpp"
#include "durero/io/rays/hits_file.hpp"
#include "durero/io/rays/rays_file.hpp"
#include "durero/scene/body.hpp"
#include "durero/scene/shapes.hpp"
#include "durero/scene/stage.hpp"
#include "durero/trace/candidates.hpp"
#include "exact_number.hpp"
#include "held_scene.hpp"
#include "json_text.hpp"

namespace durero::web {
namespace {

using number::Dyadic;

constexpr std::array<std::string_view, 3> trace_keys{"scene", "rays", "with"};
constexpr std::array<std::string_view, 4> ray_keys{"scene", "p", "v", "on"};

std::vector<scene::Query> rays_of(const AskedCall& asked, const scene::Scene& scene) {
  io::json::Reader in = asked.at("rays");
  if (in.kind() == io::json::TokenKind::string) return io::read_rays(asked.part("rays"), scene);
  return io::read_json_rays(in, scene);
}

scene::Query query_of(const AskedCall& asked, const scene::Scene& scene) {
  io::json::Reader p = asked.at("p"), v = asked.at("v");
  scene::Query query{model::Rayo(model::Punto(p.vec3("p")), model::Vector(io::read_json_direction(v))), {}};
  if (asked.has("on")) {
    io::json::Reader on = asked.at("on");
    query.en = io::read_json_elements(on, scene);
  }
  return query;
}

std::string_view word_of_step(trace::Step step) {
  constexpr std::array<std::string_view, 3> words{"triage", "stable", "exact"};
  return words[static_cast<std::size_t>(step)];
}

std::string_view type_word(scene::ElementRef element) {
  return scene::with_shape(element.tipo, []<class Shape>(std::type_identity<Shape>) { return Shape::word; });
}

std::string_view word_of_kind(ElementCrossing::Kind kind) {
  constexpr std::array<std::string_view, 3> words{"point", "segment", "along"};
  return words[static_cast<std::size_t>(kind)];
}

/// The point p + t·v, each coordinate exact.
std::string exact_point(const model::Rayo& rayo, const Parameter& t) {
  ArrayText point;
  for (int axis = 0; axis < 3; ++axis)
    point.raw(exact_number(number::linear(Dyadic(rayo.p().xyz()[axis]), Dyadic(rayo.v().xyz()[axis]), t)));
  return point.text();
}

glm::dvec3 rounded_point(const model::Rayo& rayo, const Parameter& t) {
  return surface::exact::rounded_hit(rayo, t, {}).punto;
}

/// Of an element of the tables: the quadratic A·t² + 2B·t + C along the ray, and its discriminant B² − A·C.
std::string quadratic(const scene::Scene& scene, scene::ElementRef element, const scene::Query& query) {
  const bool on = scene::Origin(query.en).contains(element);
  const auto f =
      scene.visit(element, [&](const auto& shape) { return surface::exact::coefficients(shape, query.rayo, on); });
  return ObjectText()
      .member("A", fraction(f.A))
      .member("B", fraction(f.B))
      .member("C", fraction(f.C))
      .member("discriminant", fraction(f.B * f.B - f.A * f.C))
      .text();
}

std::string crossing_text(const scene::Scene& scene, const scene::Query& query, const ElementCrossing& crossing,
                          bool is_first) {
  const scene::Body* const body = scene.body(crossing.element);
  ObjectText text;
  text.member("elemento", name_of(scene, crossing.element))
      .member("tipo", body != nullptr ? word_of(*body) : type_word(crossing.element))
      .member("kind", word_of_kind(crossing.kind))
      .member("first", is_first);
  if (crossing.t) {
    text.raw("t", exact_number(*crossing.t)).raw("point", exact_point(query.rayo, *crossing.t));
    const glm::dvec3 point = rounded_point(query.rayo, *crossing.t);
    const bool is_finite = std::isfinite(point.x) && std::isfinite(point.y) && std::isfinite(point.z);
    text.member("normal", is_finite ? normal_of(scene, crossing.element, point) : glm::dvec3(0));
  }
  if (crossing.kind == ElementCrossing::Kind::segment && crossing.end) text.raw("end", exact_number(*crossing.end));
  if (body == nullptr) text.raw("quadratic", quadratic(scene, crossing.element, query));
  return text.text();
}

bool is_of(const scene::Hit& hit, scene::ElementRef element) {
  return std::ranges::find(hit.elementos, element) != hit.elementos.end();
}

/// Whether a crossing is where the first hit is: the least of its element, which is of the hit.
bool is_first(const Crossings& found, const scene::Hit& hit, std::size_t at) {
  const ElementCrossing& crossing = found.all[at];
  const auto same = [&](const ElementCrossing& other) { return other.element == crossing.element; };
  return is_of(hit, crossing.element) &&
         std::find_if(found.all.begin(), found.all.end(), same) - found.all.begin() == static_cast<std::ptrdiff_t>(at);
}

std::string decision_text(const scene::Scene& scene, const ElementDecision& decision) {
  const trace::Meeting& met = decision.met;
  ObjectText text;
  text.member("elemento", name_of(scene, decision.element)).member("step", word_of_step(met.step));
  if (met.kind == trace::Meeting::Kind::point) {
    if (met.step != trace::Step::exact)
      text.member("t", met.finding.hi).member("rest", met.finding.lo).member("bound", met.finding.error);
    text.member("low", met.low).member("high", met.high);
  }
  return text.text();
}

/// The step of a count that stands in one place alone; empty where none does.
std::string_view counted_step(const trace::Counts::Steps& counts) {
  for (std::size_t i = 0; i < counts.size(); ++i)
    if (counts[i] != 0) return word_of_step(static_cast<trace::Step>(i));
  return "";
}

/// The steps of the tracer that found the first hit of a scene without bodies: the one that ordered the candidates, and
/// the one that rounded.
void add_steps(ObjectText& to, const scene::Scene& scene, const scene::Query& query) {
  trace::Counts counts;
  trace::Search search(scene, query.rayo, scene::Origin(query.en), counts);
  trace::first_hit_of(search, [&](auto visit) { trace::any_element(scene, visit); });
  if (const std::string_view step = counted_step(counts.order); !step.empty()) to.member("order", step);
  if (const std::string_view step = counted_step(counts.rounding); !step.empty()) to.member("rounding", step);
}

/// How far the next crossing is behind the first one; nothing where there is none at another parameter.
std::optional<double> margin_of(const Crossings& found) {
  if (found.all.empty() || !found.all.front().t) return std::nullopt;
  for (const ElementCrossing& crossing : found.all)
    if (surface::exact::order(*found.all.front().t, *crossing.t) < 0)
      return distance_between(*found.all.front().t, *crossing.t);
  return std::nullopt;
}

std::string decided_text(const scene::Scene& scene, const scene::Query& query, const scene::Hit& hit,
                         const Crossings& found) {
  ArrayText first, hard;
  std::array<std::uint64_t, 3> steps{};
  for (const ElementDecision& decision : found.decisions) {
    ++steps[static_cast<std::size_t>(decision.met.step)];
    if (is_of(hit, decision.element)) first.raw(decision_text(scene, decision));
    if (decision.met.step != trace::Step::triage) hard.raw(decision_text(scene, decision));
  }
  ObjectText text;
  text.raw("first", first.text()).raw("hard", hard.text());
  text.raw("steps", fmt::format(R"({{"triage":{},"stable":{},"exact":{}}})", steps[0], steps[1], steps[2]));
  if (!scene.has_bodies()) add_steps(text, scene, query);
  const std::optional<double> margin = margin_of(found);
  return text.raw("margin", margin ? json_of(*margin) : "null").text();
}

std::string crossings_text(const scene::Scene& scene, const scene::Query& query, const scene::Hit& hit,
                           const Crossings& found) {
  ArrayText crossings;
  for (std::size_t i = 0; i < found.all.size(); ++i)
    crossings.raw(crossing_text(scene, query, found.all[i], is_first(found, hit, i)));
  return crossings.text();
}

/// The names of the elements that a ray meets, each once: at some 0 < t < 1 or, with `whole`, anywhere.
std::vector<std::string> met_on(const scene::Scene& scene, const Crossings& found, bool whole) {
  std::vector<std::string> names;
  for (const ElementCrossing& crossing : found.all)
    if (whole || !crossing.t || surface::exact::order(*crossing.t, Parameter{.x = 1}) < 0)
      names.push_back(name_of(scene, crossing.element));
  std::ranges::sort(names);
  names.erase(std::unique(names.begin(), names.end()), names.end());
  return names;
}

/// The ray from a hit along v to a light, and what stands in its way.
std::string shadow_text(const scene::Scene& scene, const scene::Hit& hit, const glm::dvec3& v, ObjectText of_light,
                        bool whole) {
  of_light.member("p", hit.punto).member("v", v);
  if (v == glm::dvec3(0)) return of_light.member("visible", true).raw("blocked_by", "[]").raw("crossings", "[]").text();
  const scene::Query query{model::Rayo(model::Punto(hit.punto), model::Vector(v)), hit.elementos};
  const Crossings found = crossings_of(scene, query);
  const std::vector<std::string> blocking = met_on(scene, found, whole);
  return of_light.member("visible", blocking.empty())
      .raw("blocked_by", array_of_texts(blocking))
      .raw("crossings", crossings_text(scene, query, {}, found))
      .text();
}

std::string lights_text(const scene::Scene& scene, const scene::Hit& hit) {
  ArrayText lights;
  const scene::Stage& stage = scene.stage();
  for (std::size_t i = 0; i < stage.lights.size(); ++i) {
    ObjectText light;
    light.member("light", std::uint64_t{i}).member("position", stage.lights[i].position);
    lights.raw(shadow_text(scene, hit, stage.lights[i].position - hit.punto, std::move(light), false));
  }
  for (std::size_t i = 0; i < stage.directional_lights.size(); ++i) {
    ObjectText light;
    light.member("directional_light", std::uint64_t{i}).member("direction", stage.directional_lights[i].direction);
    lights.raw(shadow_text(scene, hit, -stage.directional_lights[i].direction, std::move(light), true));
  }
  return lights.text();
}

bool is_finite_hit(const scene::Hit& hit) {
  return hit.resultado == model::Resultado::hit && std::isfinite(hit.punto.x) && std::isfinite(hit.punto.y) &&
         std::isfinite(hit.punto.z);
}

}  // namespace

std::string answer_trace(const AskedCall& asked) {
  asked.require(trace_keys, 2);
  const auto held = scene_of(asked);
  const std::vector<scene::Query> rays = rays_of(asked, held->scene());
  const std::vector<scene::Hit> hits = engine::first_hits(held->engine(), rays);
  ArrayText lines;
  for (std::size_t i = 0; i < hits.size(); ++i) lines.raw(io::hit_text(i, hits[i], held->scene()));
  return ObjectText().raw("hits", lines.text()).text();
}

std::string answer_ray(const AskedCall& asked) {
  asked.require(ray_keys, 3);
  const auto held = scene_of(asked);
  const scene::Scene& scene = held->scene();
  const scene::Query query = query_of(asked, scene);
  const scene::Hit hit = engine::first_hit(held->engine(), query);
  const Crossings found = crossings_of(scene, query);
  return ObjectText()
      .raw("hit", io::hit_text(0, hit, scene))
      .raw("decided", decided_text(scene, query, hit, found))
      .raw("crossings", crossings_text(scene, query, hit, found))
      .text();
}

std::string answer_light(const AskedCall& asked) {
  asked.require(ray_keys, 3);
  const auto held = scene_of(asked);
  const scene::Scene& scene = held->scene();
  const scene::Hit hit = engine::first_hit(held->engine(), query_of(asked, scene));
  ObjectText answer;
  answer.raw("hit", io::hit_text(0, hit, scene));
  if (!is_finite_hit(hit)) return answer.raw("lights", "[]").text();
  return answer.member("normal", normal_of(scene, hit.elementos.front(), hit.punto))
      .raw("lights", lights_text(scene, hit))
      .text();
}

}  // namespace durero::web
