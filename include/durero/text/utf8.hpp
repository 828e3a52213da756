#pragma once
/// The little of UTF-8 that places and messages need.

#include <cstddef>
#include <optional>
#include <string_view>

namespace durero::text {

/// True for a byte that continues a character and so begins none.
constexpr bool continues(char byte) noexcept { return (static_cast<unsigned char>(byte) & 0xC0U) == 0x80U; }

/// A character and the number of bytes that it takes.
struct Character {
  char32_t code;
  std::size_t length;
  bool operator==(const Character&) const = default;
};

/// The character that a text starts with. Nothing where the text is empty or starts with bytes that are no UTF-8: a
/// stray or missing continuation, an overlong form, a surrogate, a number above 10FFFF (Unicode 15, table 3-7).
std::optional<Character> decode(std::string_view text) noexcept;

/// The bytes of the character that a text starts with, or its first byte where they are no UTF-8. Empty for an empty
/// text.
std::string_view first(std::string_view text) noexcept;

}  // namespace durero::text
