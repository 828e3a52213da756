#pragma once
/// Checks of the numbers that a call gives. CLI11's own take −1 and 2⁶⁴ for whole numbers, and a NaN for one in range.

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <charconv>
#include <cstdint>
#include <string>

#include "durero/io/number_text.hpp"

namespace durero::cli {

/// A whole number in decimal digits, from least to greatest.
inline CLI::Validator whole_number(std::uint64_t least, std::uint64_t greatest) {
  const auto check = [=](const std::string& text) -> std::string {
    std::uint64_t value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error == std::errc() && end == text.data() + text.size() && least <= value && value <= greatest) return "";
    return fmt::format("{} is no whole number from {} to {}", text, least, greatest);
  };
  return {check, fmt::format("whole number from {} to {}", least, greatest)};
}

/// A number from least to greatest.
inline CLI::Validator number(double least, double greatest) {
  const auto check = [=](const std::string& text) -> std::string {
    const std::optional<double> value = io::read_number(text);
    if (value && least <= *value && *value <= greatest) return "";
    return fmt::format("{} is no number from {} to {}", text, least, greatest);
  };
  return {check, fmt::format("number from {} to {}", least, greatest)};
}

}  // namespace durero::cli
