#pragma once
/// The ending of a file's name tells its format, in letters of either case.

#include <array>
#include <span>
#include <string>
#include <string_view>

namespace durero::io {

/// @{ The endings of what is written as JSON, and as PNG.
inline constexpr std::array<std::string_view, 1> json_endings{".json"}, png_endings{".png"};
/// @}

/// Whether a name ends so. An ending is a dot and small letters of ASCII or digits; the name's may be great ones.
bool ends_in(std::string_view path, std::string_view ending) noexcept;

/// The ending of a file's name: from its last dot on, which is neither the first byte of the name nor the last one.
/// Empty where there is none: of `-`, of a folder's own dots.
std::string_view ending_of(std::string_view path) noexcept;

/// Throws FileError where the name of a file that is to be written has an ending, and none of these: its name would say
/// of it what it is not. `what` names what it holds.
void require_ending(const std::string& path, std::span<const std::string_view> endings, std::string_view what);

}  // namespace durero::io
