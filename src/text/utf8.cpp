#include "durero/text/utf8.hpp"

#include <algorithm>

namespace durero::text {
namespace {

// What a lead byte says: how many bytes the character takes, the bits of its number that the lead byte carries, and
// the least number that needs so many bytes.
struct Lead {
  std::size_t length;
  char32_t bits;
  char32_t least;
};

std::optional<Lead> lead(unsigned char byte) noexcept {
  if (byte < 0x80) return Lead{1, byte, 0};
  if (byte >= 0xC0 && byte < 0xE0) return Lead{2, byte & 0x1FU, 0x80};
  if (byte >= 0xE0 && byte < 0xF0) return Lead{3, byte & 0x0FU, 0x800};
  if (byte >= 0xF0 && byte < 0xF8) return Lead{4, byte & 0x07U, 0x10000};
  return std::nullopt;
}

}  // namespace

std::optional<Character> decode(std::string_view text) noexcept {
  if (text.empty()) return std::nullopt;
  const auto start = lead(static_cast<unsigned char>(text.front()));
  if (!start || text.size() < start->length) return std::nullopt;
  const std::string_view rest = text.substr(1, start->length - 1);
  if (!std::ranges::all_of(rest, continues)) return std::nullopt;
  char32_t code = start->bits;
  for (const char byte : rest) code = code << 6U | (static_cast<unsigned char>(byte) & 0x3FU);
  if (code < start->least || !is_scalar(code)) return std::nullopt;
  return Character{code, start->length};
}

std::string_view first(std::string_view text) noexcept {
  const auto character = decode(text);
  return text.substr(0, character ? character->length : 1);
}

std::string_view head(std::string_view text, std::size_t characters) noexcept {
  std::size_t end = 0;
  for (; characters > 0 && end < text.size(); --characters) end += first(text.substr(end)).size();
  return text.substr(0, end);
}

std::string encode(char32_t code) {
  const auto byte = [](char32_t value) { return static_cast<char>(static_cast<unsigned char>(value)); };
  const auto continuation = [&](unsigned shift) { return byte(0x80U | ((code >> shift) & 0x3FU)); };
  if (code < 0x80) return {byte(code)};
  if (code < 0x800) return {byte(0xC0U | (code >> 6U)), continuation(0)};
  if (code < 0x10000) return {byte(0xE0U | (code >> 12U)), continuation(6), continuation(0)};
  return {byte(0xF0U | (code >> 18U)), continuation(12), continuation(6), continuation(0)};
}

}  // namespace durero::text
