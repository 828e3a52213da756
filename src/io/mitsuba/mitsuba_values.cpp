#include "mitsuba_values.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>

#include "durero/io/number_text.hpp"
#include "durero/scene/srgb.hpp"
#include "durero/text/nearest.hpp"
#include "durero/text/shown.hpp"

namespace durero::io {
namespace {

constexpr std::string_view value_separators = " \t\r\n,";

/// The words of a text, without what stands between them.
std::vector<std::string_view> value_words(std::string_view text) {
  std::vector<std::string_view> words;
  for (std::size_t at; (at = text.find_first_not_of(value_separators)) != std::string_view::npos;) {
    text.remove_prefix(at);
    words.push_back(text.substr(0, text.find_first_of(value_separators)));
    text.remove_prefix(words.back().size());
  }
  return words;
}

double value_number(const MitsubaNode& node, std::string_view attribute, std::string_view word) {
  const auto number = read_finite(word);
  if (!number) node.fail(fmt::format("{} in {}", text::shown(word), node.tag), "expected a finite number", attribute);
  return *number;
}

glm::dvec3 value_triple(const MitsubaNode& node, std::string_view attribute, bool may_be_one) {
  const std::vector<double> numbers = mitsuba_numbers(node, attribute);
  if (numbers.size() == 1 && may_be_one) return glm::dvec3(numbers[0]);
  if (numbers.size() != 3)
    node.fail(fmt::format("{} numbers in {}", numbers.size(), node.tag),
              may_be_one ? "expected three, or one for all" : "expected three", attribute);
  return {numbers[0], numbers[1], numbers[2]};
}

/// A colour behind #, of two hexadecimal digits each; they are on the sRGB curve.
glm::dvec3 hexadecimal_color(const MitsubaNode& node, std::string_view digits) {
  glm::dvec3 color;
  for (int k = 0; k < 3; ++k) {
    const auto byte = digits.size() == 6
                          ? read_number("0x" + std::string(digits.substr(2 * static_cast<std::size_t>(k), 2)))
                          : std::nullopt;
    if (!byte) node.fail(fmt::format("{} in {}", text::shown(digits), node.tag), "expected #rrggbb", "value");
    color[k] = scene::linear_of_srgb(*byte / 255);
  }
  return color;
}

/// The mean of a spectrum that a text gives by wavelengths and values, λ:v.
MitsubaColor mean_of_spectrum(const MitsubaNode& node, const std::vector<std::string_view>& words) {
  double sum = 0;
  for (const std::string_view word : words) {
    const std::size_t colon = std::min(word.find(':'), word.size());
    value_number(node, "value", word.substr(0, colon));
    sum += value_number(node, "value", word.substr(std::min(colon + 1, word.size())));
  }
  return {glm::dvec3(sum / static_cast<double>(words.size())), true};
}

AffinePlacement mitsuba_looking(const MitsubaNode& node) {
  const glm::dvec3 from = value_triple(node, "origin", false), at = value_triple(node, "target", false),
                   up = value_triple(node, "up", false);
  const auto made = AffinePlacement::looking(from, at, up);
  if (!made) node.fail("lookat gives no direction", "expected two points, and up across the way between them");
  return *made;
}

/// The sixteen numbers of a matrix, or the nine of its upper left part, row by row.
AffinePlacement mitsuba_matrix(const MitsubaNode& node) {
  const std::vector<double> rows = mitsuba_numbers(node, "value");
  const std::size_t side = rows.size() == 9 ? 3 : 4;
  if (rows.size() != side * side)
    node.fail(fmt::format("a matrix of {} numbers", rows.size()), "expected 16, or 9", "value");
  std::array<double, 16> columns{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
  for (std::size_t row = 0; row < side; ++row)
    for (std::size_t column = 0; column < side; ++column) columns[4 * column + row] = rows[side * row + column];
  if (columns[3] != 0 || columns[7] != 0 || columns[11] != 0 || !(columns[15] > 0))
    node.fail("a matrix whose last row is another", "expected 0 0 0 1", "value");
  return AffinePlacement::of_matrix(columns);
}

AffinePlacement mitsuba_rotation(const MitsubaNode& node) {
  const auto angle = mitsuba_numbers(node, "angle");
  if (angle.size() != 1) node.fail("rotate without one angle", "expected degrees", "angle");
  const glm::dvec3 axis = mitsuba_triple(node);
  constexpr double as_written = 1e-4;  // of unit vectors that a text gives with some digits
  if (std::abs(glm::dot(axis, axis) - 1) > as_written) return AffinePlacement::turn_unscaled(axis, angle.front());
  return *AffinePlacement::rotation(axis, angle.front());
}

AffinePlacement mitsuba_move(const MitsubaNode& node) {
  if (node.tag == "translate") return AffinePlacement::translation(mitsuba_triple(node));
  if (node.tag == "scale") return AffinePlacement::scaling(mitsuba_triple(node, 1));
  if (node.tag == "rotate") return mitsuba_rotation(node);
  if (node.tag == "lookat" || node.tag == "lookAt") return mitsuba_looking(node);
  if (node.tag == "matrix") return mitsuba_matrix(node);
  node.fail(fmt::format("{} in a transform", text::shown(node.tag)),
            "expected " + text::expected_of(node.tag, {"translate", "rotate", "scale", "lookat", "matrix"}));
}

}  // namespace

std::vector<double> mitsuba_numbers(const MitsubaNode& node, std::string_view attribute) {
  std::vector<double> numbers;
  for (const std::string_view word : value_words(node.required(attribute)))
    numbers.push_back(value_number(node, attribute, word));
  return numbers;
}

double mitsuba_number(const MitsubaNode& node) {
  const std::vector<double> numbers = mitsuba_numbers(node, "value");
  if (numbers.size() != 1)
    node.fail(fmt::format("{} numbers in {}", numbers.size(), node.tag), "expected one", "value");
  return numbers.front();
}

bool mitsuba_boolean(const MitsubaNode& node) {
  const std::string_view value = node.required("value");
  if (value != "true" && value != "false")
    node.fail(fmt::format("{} in {}", text::shown(value), node.tag), "expected true or false", "value");
  return value == "true";
}

glm::dvec3 mitsuba_triple(const MitsubaNode& node, double missing) {
  if (node.attributes.contains("value")) return value_triple(node, "value", true);
  glm::dvec3 made(missing);
  static constexpr std::array<std::string_view, 3> axes{"x", "y", "z"};
  for (std::size_t axis = 0; axis < 3; ++axis)
    if (node.attributes.contains(axes[axis]))
      made[static_cast<int>(axis)] = value_number(node, axes[axis], node.value_of(axes[axis]));
  return made;
}

std::optional<MitsubaColor> mitsuba_color(const MitsubaNode& node) {
  if (node.tag == "float" || node.tag == "integer") return MitsubaColor{glm::dvec3(mitsuba_number(node))};
  if (node.tag != "rgb" && node.tag != "srgb" && node.tag != "spectrum") return std::nullopt;
  if (!node.attributes.contains("value")) return std::nullopt;
  const std::string_view value = node.value_of("value");
  if (value.starts_with('#')) return MitsubaColor{hexadecimal_color(node, value.substr(1))};
  const std::vector<std::string_view> words = value_words(value);
  if (node.tag == "spectrum" && !words.empty() && value.find(':') != std::string_view::npos)
    return mean_of_spectrum(node, words);
  glm::dvec3 color = value_triple(node, "value", true);
  if (node.tag == "srgb")
    for (int k = 0; k < 3; ++k) color[k] = scene::linear_of_srgb(color[k]);
  return MitsubaColor{color};
}

AffinePlacement mitsuba_placement(const MitsubaNode& transform) {
  AffinePlacement all;
  for (const MitsubaNode& part : transform.children) {
    all = mitsuba_move(part).after(all);
    if (all.steps > AffinePlacement::most_steps)
      part.fail(fmt::format("more than {} transformations one after another", AffinePlacement::most_steps),
                "expected fewer");
  }
  return all;
}

}  // namespace durero::io
