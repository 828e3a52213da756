#pragma once
/// The little of UTF-8 that places, messages and the names of characters need.

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace durero::text {

/// True for a byte that continues a character and so begins none.
constexpr bool continues(char byte) noexcept { return (static_cast<unsigned char>(byte) & 0xC0U) == 0x80U; }

/// Says whether a number is that of a character: it is no surrogate and at most 10FFFF (Unicode 15, D76).
constexpr bool is_scalar(char32_t code) noexcept { return code <= 0x10FFFF && !(code >= 0xD800 && code <= 0xDFFF); }

/// A character and the number of bytes that it takes.
struct Character {
  char32_t code;       ///< its number in Unicode
  std::size_t length;  ///< in bytes
  bool operator==(const Character&) const = default;
};

/// The character that a text starts with. Nothing where the text is empty or starts with bytes that are no UTF-8: a
/// stray or missing continuation, an overlong form, a surrogate, a number above 10FFFF (Unicode 15, table 3-7).
std::optional<Character> decode(std::string_view text) noexcept;

/// The bytes of the character that a text starts with, or its first byte where they are no UTF-8. Empty for an empty
/// text.
std::string_view first(std::string_view text) noexcept;

/// The first characters of a text, so many at most. A byte that begins no character counts as one.
std::string_view head(std::string_view text, std::size_t characters) noexcept;

/// Writes a character as its bytes, so that decode() reads it back. Precondition: is_scalar(code).
std::string encode(char32_t code);

}  // namespace durero::text
