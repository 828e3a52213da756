#pragma once
/// Whole numbers, as JSON and tables of binary64 hold them.

#include <cstdint>
#include <string>
#include <string_view>

#include "durero/io/json/json.hpp"

namespace durero::io {

/// True where the number is whole, and from `least` to `most`.
bool is_whole(double value, double least, double most) noexcept;

namespace json {

/// The most that a whole number of a file may be: up to here each is a binary64.
inline constexpr std::int64_t most_whole = std::int64_t{1} << 53U;

/// Reads a whole number from `least` to `most`. `what` names it in messages, and `expected` says what it may be. Throws
/// InputError. Precondition: −most_whole ≤ least ≤ most ≤ most_whole.
std::int64_t whole_number(Reader& in, std::string_view what, std::int64_t least, std::int64_t most,
                          const std::string& expected);
/// Reads a whole number from 0 to most_whole.
std::uint64_t whole_number(Reader& in, std::string_view what);

}  // namespace json
}  // namespace durero::io
