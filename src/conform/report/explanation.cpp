#include "durero/conform/report/explanation.hpp"

#include <fmt/format.h>

#include <array>

#include "conform/judge/ball.hpp"
#include "conform/report/report_parts.hpp"
#include "durero/conform/ask/question.hpp"
#include "durero/number/decimal.hpp"
#include "durero/surface/exact.hpp"

namespace durero::conform {
namespace {

using number::Surd;

std::string parameter_lines(std::string_view what, const surface::exact::Parameter& t) {
  const Surd value(t);
  return fmt::format("  {} = {}\n    = {}\n", what, number::decimal_text(value, shown_digits), surd_text(value));
}

std::string crossing_text(const SuiteCase& of, const surface::exact::Crossing& crossing) {
  const auto& [begin, end] = crossing.segment;
  const std::string title = fmt::format("{}:\n", of.the_case.scene.name(crossing.elemento).name());
  const AskedBody* const body = find_body(of.bodies, crossing.elemento);
  if (body && body->kind == BodyKind::toro)
    return title + fmt::format("  t = {}\n", number::decimal_text(Surd(begin.value()), shown_digits));
  if (begin && end && *begin == *end) return title + parameter_lines("t", *begin);
  const std::string from = begin ? parameter_lines("in its surface from t", *begin) : "  in its surface from t → 0\n";
  return title + from + (end ? parameter_lines("to t", *end) : "  without end\n");
}

/// The point p + t·v, a line for each coordinate.
std::string point_text(std::string_view what, const model::Rayo& rayo, const Surd& t) {
  const glm::dvec3 p = rayo.p().xyz(), v = rayo.v().xyz();
  std::string text = fmt::format("{}:\n", what);
  for (int i = 0; i < 3; ++i)
    text += fmt::format("  {} = {}\n", "xyz"[i], number::decimal_text(Surd(p[i]) + Surd(v[i]) * t, shown_digits));
  return text;
}

/// The first touch of a ball, for each element that it touches then. A root of a quartic is known by its digits alone.
std::string touch_text(const SuiteCase& of, std::size_t ray) {
  std::string text;
  const model::Rayo& rayo = of.the_case.rays[ray].rayo;
  std::optional<Surd> t;
  for (const scene::ElementRef element : of.truths[ray].hit.elementos) {
    const auto touch = first_touch(AskedElements(of.the_case.scene), element, rayo, of.ranges[ray].radio);
    if (!touch) continue;
    const bool is_surd = !touch->root || std::holds_alternative<number::DyadicSurd>(*touch->root);
    t = Surd(touch->low());
    text += fmt::format("{}:\n", of.the_case.scene.name(element).name());
    text += is_surd ? parameter_lines("t", touch->low())
                    : fmt::format("  t = {}\n", number::decimal_text(*t, shown_digits));
  }
  return t ? text + point_text("the middle of the ball", rayo, *t) : text;
}

std::string answer_text(const scene::Scene& scene, const scene::Hit& hit) {
  if (hit.resultado == model::Resultado::miss) return "a miss";
  if (hit.resultado == model::Resultado::no_minimum)
    return element_names(hit.elementos, scene) + ", without a nearest point";
  return fmt::format("{} at t = {}", element_names(hit.elementos, scene), hit.t);
}

}  // namespace

std::string exact_answer(const SuiteCase& of, std::size_t ray) {
  const scene::Scene& scene = of.the_case.scene;
  const scene::Query& query = of.the_case.rays[ray];
  const ExactAnswer& truth = of.truths[ray];
  std::string text = fmt::format("the exact answer: {}\n", answer_text(scene, truth.hit));
  if (of.question == QuestionKind::cast) return text + touch_text(of, ray);
  const auto crossings = all_crossings(scene, query, of.bodies);
  for (const surface::exact::Crossing& crossing : crossings) text += crossing_text(of, crossing);
  if (truth.hit.resultado == model::Resultado::hit)
    text += point_text("the first point", query.rayo, Surd(crossings.front().segment.begin.value()));
  if (truth.ambiguity != Ambiguity::none) text += fmt::format("ambiguous: {}\n", name(truth.ambiguity));
  for (const scene::Hit& hit : truth.permissible) text += fmt::format("as good: {}\n", answer_text(scene, hit));
  return text;
}

std::string explanation(const SuiteCase& of, std::size_t ray) {
  const scene::Query& query = of.the_case.rays[ray];
  std::string text = fmt::format("{}, ray {}: {} ({}: {})\n", of.name(), ray, of.family->kind,
                                 of.family->parameter.name, of.parameter);
  const std::array<std::size_t, 1> only{ray};
  text += question_text(of, Caps::open, only);
  if (!query.en.empty()) text += fmt::format("it starts on {}\n", element_names(query.en, of.the_case.scene));
  return text + exact_answer(of, ray);
}

}  // namespace durero::conform
