#include "durero/conform/ask/question.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "conform/ask/answer_line.hpp"
#include "conform/ask/words.hpp"
#include "conform/families/solids.hpp"
#include "durero/conform/families/asked_grid.hpp"
#include "durero/io/number_text.hpp"
#include "durero/scene/attributes.hpp"
#include "durero/text/shown.hpp"

namespace durero::conform {
namespace {

void append(std::string& line, double number) {
  line += ' ';
  io::append_number(line, number);
}
void append(std::string& line, const glm::dvec3& v) {
  for (const double number : {v.x, v.y, v.z}) append(line, number);
}
void append(std::string& line, const scene::Corners& corners) {
  for (const glm::dvec3& corner : corners) append(line, corner);
}

/// Whether the question leaves the element out.
bool is_left_out(const SuiteCase& of, Caps caps, scene::ElementRef element) {
  return caps == Caps::solid && solid_closed_by(of.solids, element) != nullptr;
}

template <class Shape>
std::string element_line(const model::Elemento& name, const Shape& shape) {
  std::string line = fmt::format("{} {}", Shape::word, name.name());
  for (const bool are_lengths : {false, true}) {
    scene::for_each_attribute<Shape>([&]<class Row>(const Row& attribute) {
      if (std::is_same_v<typename Row::Stored, double> == are_lengths) append(line, shape.*attribute.field);
    });
  }
  return line + '\n';
}

std::string body_line(const model::Elemento& name, const AskedBody& body) {
  std::string line = fmt::format("{} {}", word(body.kind), name.name());
  append(line, body.centro);
  for (const glm::dvec3& side : body.sides) append(line, side);
  if (has_radius(body.kind)) append(line, body.radio);
  return line + '\n';
}

std::string grid_line(const AskedGrid& grid) {
  std::string line = fmt::format("{} {} {} {}", word(BodyKind::campo), grid.name, grid.columns, grid.rows);
  for (const double number : {grid.x, grid.y, grid.dx, grid.dy}) append(line, number);
  for (const double height : grid.heights) append(line, height);
  return line + '\n';
}

/// A line for each element.
std::string element_lines(const SuiteCase& of, Caps caps) {
  const scene::Scene& scene = of.the_case.scene;
  if (of.is_grid) return grid_line(grid_of(scene).value());
  std::string text;
  scene.for_each([&](scene::ElementRef element, const auto& shape) {
    if (is_left_out(of, caps, element)) return;
    const AskedBody* const body = find_body(of.bodies, element);
    text += body ? body_line(scene.name(element), *body) : element_line(scene.name(element), shape);
  });
  return text;
}

/// The claim, where it answers what was asked; a miss is a count of none.
Claim as_asked(Claim claim, std::string_view line, QuestionKind question) {
  if (!claim.behind.empty() && question != QuestionKind::all) return malformed(line, "one hit was asked for");
  if (question == QuestionKind::count) {
    if (claim.outcome == Claim::Outcome::miss) claim.count = 0;
    if (claim.outcome == Claim::Outcome::hit && !claim.count) return malformed(line, "a count was asked for");
  } else if (claim.count) {
    return malformed(line, "no count was asked for");
  }
  return claim;
}

}  // namespace

std::string question_text(const SuiteCase& of, Caps caps, std::span<const std::size_t> rays) {
  std::string text = fmt::format("scene {}\n", of.name()) + element_lines(of, caps);
  text += fmt::format("{} {}\n", heads_of_rays[static_cast<std::size_t>(of.question)], rays.size());
  for (const std::size_t ray : rays) {
    const model::Rayo& rayo = of.the_case.rays[ray].rayo;
    std::string line;
    append(line, rayo.p().xyz());
    if (of.question != QuestionKind::closest) append(line, rayo.v().xyz());
    if (of.question == QuestionKind::range) append(line, of.ranges[ray].begin);
    if (has_range(of.question)) append(line, of.ranges[ray].end);
    if (of.question == QuestionKind::cast) append(line, of.ranges[ray].radio);
    text.append(line, 1).append("\n");
  }
  return text;
}

std::optional<std::string> read_system_line(std::string_view line) {
  const std::vector<std::string_view> words = words_of(line);
  if (words.size() < 2 || words.front() != "system") return std::nullopt;
  return text::escaped(fmt::format("{}", fmt::join(std::span(words).subspan(1), " ")));
}

Claim read_answer(std::string_view line, const SuiteCase& of, Caps caps) {
  if (of.question == QuestionKind::shadow && line == "hit") return {.outcome = Claim::Outcome::hit};
  Claim claim = read_answer_line(line, of.the_case.scene, of.is_grid);
  const auto is_none_of_it = [&](const Claim& hit) { return hit.element && is_left_out(of, caps, *hit.element); };
  if (is_none_of_it(claim) || std::ranges::any_of(claim.behind, is_none_of_it))
    return malformed(line, "the question has no such element");
  return as_asked(std::move(claim), line, of.question);
}

}  // namespace durero::conform
