#pragma once
/// Whole numbers that are written in decimal digits.

#include <cstdint>
#include <optional>
#include <string_view>

namespace durero::text {

/// The whole number that a text of decimal digits alone is; nothing for another text, and for 2⁶⁴ and more.
std::optional<std::uint64_t> whole_number(std::string_view digits) noexcept;

}  // namespace durero::text
