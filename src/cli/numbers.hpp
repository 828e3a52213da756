#pragma once
/// Checks of the values of a call. CLI11's own accept −1 and 2⁶⁴ as whole numbers, and a NaN as in range. The message
/// of a check begins with the value, and its description with the text that help shows.

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "durero/io/number_text.hpp"
#include "durero/text/nearest.hpp"
#include "durero/text/whole_number.hpp"

namespace durero::cli {

/// The `count` numbers of a text with separators between them, each read by read(text); nothing for another text.
template <std::size_t count, class Read>
auto numbers_in(std::string_view text, char separator, const Read& read) {
  using Number = typename decltype(read(text))::value_type;
  std::optional<std::array<Number, count>> numbers(std::in_place);
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t end = i + 1 == count ? text.size() : text.find(separator);
    const std::optional<Number> number = read(text.substr(0, end));
    if (end == text.npos || !number) return decltype(numbers)();
    (*numbers)[i] = *number;
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return numbers;
}

/// A check for a whole number in decimal digits, from least to greatest.
inline CLI::Validator whole_number(std::uint64_t least, std::uint64_t greatest) {
  const auto check = [=](const std::string& given) -> std::string {
    const auto value = text::whole_number(given);
    if (value && least <= *value && *value <= greatest) return "";
    return fmt::format("{}: no whole number from {} to {}; expected one, in decimal digits", given, least, greatest);
  };
  return {check, fmt::format("{} to {}", least, greatest)};
}

/// A check for a number from least to greatest.
inline CLI::Validator number(double least, double greatest) {
  const auto check = [=](const std::string& text) -> std::string {
    const std::optional<double> value = io::read_number(text);
    if (value && least <= *value && *value <= greatest) return "";
    return fmt::format("{}: no number from {} to {}; expected one", text, least, greatest);
  };
  return {check, fmt::format("{} to {}", least, greatest)};
}

/// A check for one of the words, of a kind that `what` names: `engine`.
inline CLI::Validator one_of(std::string what, std::vector<std::string> words) {
  std::string description = fmt::format("{{{}}}", fmt::join(words, ","));
  const auto check = [what = std::move(what), words = std::move(words)](const std::string& text) -> std::string {
    if (std::find(words.begin(), words.end(), text) != words.end()) return "";
    return fmt::format("{}: no such {}; expected {}", text, what, text::expected_of(text, words));
  };
  return {check, std::move(description)};
}

/// Three finite numbers, with commas between them.
inline std::optional<glm::dvec3> point_in(std::string_view text) {
  const auto numbers = numbers_in<3>(text, ',', io::read_finite);
  if (!numbers) return std::nullopt;
  return glm::dvec3((*numbers)[0], (*numbers)[1], (*numbers)[2]);
}

inline std::string check_point(const std::string& text) {
  if (point_in(text)) return "";
  return fmt::format("{}: no point; expected X,Y,Z, three finite numbers", text);
}

}  // namespace durero::cli
