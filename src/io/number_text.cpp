#include "durero/io/number_text.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <cstdlib>

namespace durero::io {

std::optional<double> read_number(std::string_view text) {
  std::string_view digits = text;
  const bool negative = digits.starts_with('-');
  if (negative || digits.starts_with('+')) digits.remove_prefix(1);
  if (digits.empty() || digits.front() == '-' || digits.front() == '+') return std::nullopt;
  const bool hexadecimal = digits.starts_with("0x") || digits.starts_with("0X");
  if (hexadecimal) digits.remove_prefix(2);

  double value = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value,
                                            hexadecimal ? std::chars_format::hex : std::chars_format::general);
  if (error == std::errc::invalid_argument || end != digits.data() + digits.size()) return std::nullopt;
  // from_chars leaves the value alone both above the range and below it; strtod rounds, to ∞ or towards 0.
  if (error == std::errc::result_out_of_range) return std::strtod(std::string(text).c_str(), nullptr);
  return negative ? -value : value;
}

std::optional<double> read_finite(std::string_view text) {
  const auto value = read_number(text);
  return value && std::isfinite(*value) ? value : std::nullopt;
}

std::optional<double> read_decimal(std::string_view text) {
  return text.find_first_of("xX") == text.npos ? read_finite(text) : std::nullopt;
}

void append_number(std::string& out, double value) { fmt::format_to(std::back_inserter(out), "{}", value); }

std::string number_text(double value) { return fmt::format("{}", value); }

}  // namespace durero::io
