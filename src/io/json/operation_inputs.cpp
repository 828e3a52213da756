#include "operation_inputs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <ranges>

#include "durero/io/json/whole_number.hpp"
#include "durero/io/number_text.hpp"
#include "durero/scene/shapes.hpp"
#include "durero/text/nearest.hpp"
#include "durero/text/shown.hpp"
#include "durero/text/spanish.hpp"

namespace durero::io {
namespace {

/// The input as messages name it: `radio? (radius)`.
std::string input_named(std::string_view name) { return text::with_english(fmt::format("{}?", name)); }

}  // namespace

Inputs::Inputs(const Source& source, const Call& call, const Signature& signature) : source_(source), call_(call) {
  for (const CallInput& input : call.inputs) check_known(input, signature);
  for (const std::string_view name : signature.required) require(name);
}

void Inputs::check_known(const CallInput& input, const Signature& signature) const {
  std::vector<std::string_view> known = signature.required;
  known.insert(known.end(), signature.optional.begin(), signature.optional.end());
  if (std::ranges::find(known, input.name) == known.end()) {
    source_.fail(input.name_offset, fmt::format("unknown input {} of {}", text::shown(input.name), signature.name),
                 "expected " + text::expected_of(input.name, {known.begin(), known.end()}));
  }
  if (find(input.name) != &input) {
    source_.fail(input.name_offset, input_named(input.name) + " stands twice", "expected it once");
  }
}

// The first of that name: of two, the second is refused.
const CallInput* Inputs::find(std::string_view name) const {
  const auto found = std::ranges::find(call_.inputs, name, &CallInput::name);
  return found == call_.inputs.end() ? nullptr : &*found;
}

void Inputs::require(std::string_view name) const {
  if (!has(name))
    source_.fail(call_.offset, fmt::format("{} lacks {}", call_.schema, input_named(name)), "expected it");
}

model::Elemento Inputs::element() const { return model::Elemento{name("e")}; }

void Inputs::check_name(std::string_view input, const std::string& name) const {
  if (!model::Elemento::is_name(name))
    fail(input, fmt::format("{} is {}", input_named(input), text::shown(name)),
         "expected a name, 1 to 128 of A-Z a-z 0-9 _ . : -");
}

const std::string& Inputs::name(std::string_view input) const {
  const std::string& name = word(input);
  check_name(input, name);
  return name;
}

std::vector<std::string> Inputs::names(std::string_view input) const {
  const auto& written = find(input)->value;
  std::vector<std::string> names;
  if (const auto* list = std::get_if<std::vector<std::string>>(&written)) {
    names = *list;
  } else if (const auto* text = std::get_if<BareWord>(&written)) {
    for (const auto part : std::views::split(text->text, ',')) names.emplace_back(part.begin(), part.end());
  } else {
    fail(input, input_named(input) + " is no list of names", "expected a,b,… or, in JSON, [\"a\",\"b\",…]");
  }
  for (std::size_t i = 0; i < names.size(); ++i) {
    check_name(input, names[i]);
    if (std::find(names.begin(), names.begin() + static_cast<std::ptrdiff_t>(i), names[i]) !=
        names.begin() + static_cast<std::ptrdiff_t>(i))
      fail(input, fmt::format("{} stands twice in {}", text::shown(names[i]), input_named(input)), "expected it once");
  }
  return names;
}

model::Tipo Inputs::tipo() const {
  std::optional<model::Tipo> known;
  std::vector<std::string_view> names;
  scene::for_each_shape([&]<class Shape>(std::type_identity<Shape>) {
    names.push_back(model::name(Shape::tipo));
    if (word("t") == names.back()) known = Shape::tipo;
  });
  if (!known) {
    fail("t", fmt::format("{} is {}", input_named("t"), text::shown(word("t"))),
         "expected " + text::expected_of(word("t"), {names.begin(), names.end()}));
  }
  return *known;
}

void Inputs::read(std::string_view name, double& value) const {
  const auto& written = find(name)->value;
  if (const auto* number = std::get_if<double>(&written)) {
    value = *number;
    return;
  }
  const auto* digits = std::get_if<BareWord>(&written);
  if (digits == nullptr) fail(name, input_named(name) + " is no number", "expected a finite number");
  const auto number = read_finite(digits->text);
  if (!number)
    fail(name, fmt::format("{} is {}", input_named(name), text::shown(digits->text)), "expected a finite number");
  value = *number;
}

void Inputs::read(std::string_view name, glm::dvec3& value) const {
  const auto* triple = std::get_if<glm::dvec3>(&find(name)->value);
  if (triple == nullptr) fail(name, input_named(name) + " is no triple", "expected (x,y,z), or [x,y,z] in JSON");
  value = *triple;
}

void Inputs::read(std::string_view name, std::array<glm::dvec3, 3>& value) const {
  const auto* triples = std::get_if<std::array<glm::dvec3, 3>>(&find(name)->value);
  if (triples == nullptr) {
    fail(name, input_named(name) + " is no triple of points",
         "expected ((x,y,z),(x,y,z),(x,y,z)), or [[x,y,z],[x,y,z],[x,y,z]] in JSON");
  }
  value = *triples;
}

model::Ordinal Inputs::ordinal(std::string_view input, double value) const {
  constexpr double most = std::numeric_limits<model::Ordinal>::max();
  if (!is_whole(value, 0, most))
    fail(input, fmt::format("{} in {}", value, input_named(input)), "expected the number of a point, from 0");
  return static_cast<model::Ordinal>(value);
}

void Inputs::read(std::string_view name, model::Ordinal& value) const {
  double number{};
  read(name, number);
  value = ordinal(name, number);
}

void Inputs::read(std::string_view name, std::vector<glm::dvec3>& value) const {
  const auto* triples = std::get_if<std::vector<glm::dvec3>>(&find(name)->value);
  if (triples == nullptr)
    fail(name, input_named(name) + " is no list of triples", "expected ((x,y,z),…), or [[x,y,z],…] in JSON");
  value = *triples;
}

void Inputs::read(std::string_view name, std::vector<model::Cara>& value) const {
  std::vector<glm::dvec3> triples;
  read(name, triples);
  for (const glm::dvec3& c : triples) value.push_back({ordinal(name, c.x), ordinal(name, c.y), ordinal(name, c.z)});
}

const std::string& Inputs::word(std::string_view name) const {
  const auto& written = find(name)->value;
  if (const auto* text = std::get_if<std::string>(&written)) return *text;
  if (const auto* text = std::get_if<BareWord>(&written)) return text->text;
  fail(name, input_named(name) + " is no name", "expected a name");
}

void Inputs::fail(std::string_view name, const std::string& wrong, const std::string& expected) const {
  source_.fail(find(name)->value_offset, wrong, expected);
}

}  // namespace durero::io
