#pragma once
/// Numbers as text: read to the nearest binary64, written in the shortest form that reads back.

#include <optional>
#include <string>
#include <string_view>

namespace durero::io {

/// The binary64 nearest to a number written in decimal or in C's hexadecimal (0x1.8p3), with an optional sign: ties to
/// even, so 1e-999 is 0 and 1e999 is ∞. Also reads inf and nan; a caller that wants a finite number asks isfinite.
/// Nothing where the text, as a whole, is no number.
std::optional<double> read_number(std::string_view text);

/// The same where it is finite; nothing otherwise.
std::optional<double> read_finite(std::string_view text);
/// The number of read_finite(), where it is written in decimal; nothing otherwise.
std::optional<double> read_decimal(std::string_view text);

/// Appends the shortest decimal that reads back to the same binary64; integers plain (4, not 4.0); inf, -inf, nan.
void append_number(std::string& out, double value);
/// What append_number() appends.
std::string number_text(double value);

}  // namespace durero::io
