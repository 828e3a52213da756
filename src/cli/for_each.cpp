#include "for_each.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <string_view>

#include "durero/io/number_text.hpp"
#include "durero/io/source.hpp"
#include "durero/scene/attributes.hpp"
#include "durero/text/shown.hpp"

namespace durero::cli {
namespace {

/// @{ A value as a line of a script has it.
std::string input_text(double number) {
  std::string text;
  io::append_number(text, number);
  return text;
}
std::string input_text(const glm::dvec3& v) {
  return fmt::format("({},{},{})", input_text(v.x), input_text(v.y), input_text(v.z));
}
std::string input_text(const scene::Corners& v) {
  return fmt::format("({},{},{})", input_text(v[0]), input_text(v[1]), input_text(v[2]));
}
/// @}

/// Nothing where the element has no such attribute; a body stands in no table, and has none.
std::optional<std::string> attribute_text(const scene::Scene& scene, const std::string& name, std::string_view word) {
  const scene::ElementRef element = scene.find(name).value();
  if (scene.body(element) != nullptr) return std::nullopt;
  return scene.visit(element, [&]<class Shape>(const Shape& shape) {
    std::optional<std::string> text;
    scene::for_each_attribute<Shape>([&](const auto& attribute) {
      if (attribute.word == word) text = input_text(shape.*attribute.field);
    });
    return text;
  });
}

/// A word between braces: letters alone, so that no object of JSON is taken for one.
bool is_place(std::string_view between) {
  return std::ranges::all_of(between, [](char c) { return 'a' <= c && c <= 'z'; });
}

/// The operation without places; its line is that of messages.
std::string filled(const std::string& operation, std::size_t line, const scene::Scene& scene, const std::string& name) {
  std::string text;
  for (std::size_t at = 0; at < operation.size();) {
    const std::size_t end = operation[at] == '{' ? operation.find('}', at) : operation.npos;
    const std::string_view between =
        end == operation.npos ? std::string_view("{") : std::string_view(operation).substr(at + 1, end - at - 1);
    if (!is_place(between)) {
      text += operation[at++];
      continue;
    }
    const auto value = between.empty() ? std::optional(name) : attribute_text(scene, name, between);
    if (!value)
      throw io::InputError("--op", {line, at + 1}, fmt::format("{} has no {}", name, text::shown(between)),
                           "expected {}, its name, or the word of one of its attributes");
    text += *value;
    at = end + 1;
  }
  return text;
}

}  // namespace

std::vector<RepeatedOperation> repeated(const std::vector<std::string>& operations, const scene::Scene& scene,
                                        const std::vector<std::string>& elements) {
  std::vector<RepeatedOperation> all;
  for (const std::string& element : elements)
    for (std::size_t i = 0; i < operations.size(); ++i)
      all.push_back({element, filled(operations[i], i + 1, scene, element)});
  return all;
}

}  // namespace durero::cli
