#pragma once
/// Sizes of pictures in calls: WxH.

#include <fmt/format.h>

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "durero/scene/stage.hpp"
#include "numbers.hpp"

namespace durero::cli {

/// The most pixels of a side, as in scene files.
inline constexpr std::uint32_t greatest_side = 65535;

/// Pixels of a side.
inline std::optional<std::uint32_t> read_side(std::string_view text) {
  const auto value = text::whole_number(text);
  if (!value || *value > greatest_side) return std::nullopt;
  return static_cast<std::uint32_t>(*value);
}

/// The size of a picture; nothing for another text.
inline std::optional<scene::Resolution> read_size(std::string_view text) {
  const auto size = numbers_in<2>(text, 'x', read_side);
  if (!size || (*size)[0] == 0 || (*size)[1] == 0) return std::nullopt;
  return scene::Resolution{(*size)[0], (*size)[1]};
}

/// A check for one.
inline std::string check_size(const std::string& text) {
  if (read_size(text)) return "";
  return fmt::format("{}: no size; expected WxH, two whole numbers from 1 to {}", text, greatest_side);
}

}  // namespace durero::cli
