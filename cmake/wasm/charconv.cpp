// std::from_chars of binary64 numbers. The extent of a number is found by the rule of the standard; its value is by
// strtod of the C library, musl's, which rounds to the nearest.
#include <cctype>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <string>
#include <string_view>

namespace {

const char* behind_digits(const char* at, const char* last, bool hexadecimal) {
  const auto is_digit = [&](char c) {
    const auto byte = static_cast<unsigned char>(c);
    return (hexadecimal ? std::isxdigit(byte) : std::isdigit(byte)) != 0;
  };
  while (at != last && is_digit(*at)) ++at;
  return at;
}

const char* behind_word(const char* at, const char* last, std::string_view word) {
  for (const char letter : word) {
    if (at == last || std::tolower(static_cast<unsigned char>(*at)) != letter) return nullptr;
    ++at;
  }
  return at;
}

// Behind the number without its sign; null where there is none.
const char* behind_number(const char* first, const char* last, std::chars_format format) {
  const bool hexadecimal = format == std::chars_format::hex;
  for (const std::string_view word : {"infinity", "inf", "nan"})
    if (const char* const end = behind_word(first, last, word); end && !hexadecimal) return end;
  const char* const whole = behind_digits(first, last, hexadecimal);
  const char* end = whole;
  std::ptrdiff_t digits = whole - first;
  if (end != last && *end == '.') {
    const char* const fraction = behind_digits(end + 1, last, hexadecimal);
    digits += fraction - (end + 1);
    end = fraction;
  }
  if (digits == 0) return nullptr;
  if (end == last || std::tolower(static_cast<unsigned char>(*end)) != (hexadecimal ? 'p' : 'e')) return end;
  const char* exponent = end + 1;
  if (exponent != last && (*exponent == '+' || *exponent == '-')) ++exponent;
  const char* const behind = behind_digits(exponent, last, false);
  return behind == exponent ? end : behind;
}

}  // namespace

std::from_chars_result std::from_chars(const char* first, const char* last, double& value, std::chars_format format) {
  const bool negative = first != last && *first == '-';
  const char* const digits = negative ? first + 1 : first;
  const char* const end = behind_number(digits, last, format);
  if (!end) return {first, std::errc::invalid_argument};
  const std::string text(digits, end);
  const bool is_infinity = text.front() == 'i' || text.front() == 'I';
  const double magnitude = std::strtod((format == std::chars_format::hex ? "0x" + text : text).c_str(), nullptr);
  if (std::isinf(magnitude) && !is_infinity) return {end, std::errc::result_out_of_range};
  value = negative ? -magnitude : magnitude;  // a number too small is a zero here, as it is for strtod
  return {end, std::errc()};
}
