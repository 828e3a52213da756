#include "durero/io/json/whole_number.hpp"

#include <fmt/format.h>

#include <cmath>

namespace durero::io {

bool is_whole(double value, double least, double most) noexcept {
  return value >= least && value <= most && std::trunc(value) == value;
}

namespace json {

std::int64_t whole_number(Reader& in, std::string_view what, std::int64_t least, std::int64_t most,
                          const std::string& expected) {
  const std::size_t at = in.offset();
  const double value = in.number(what);
  if (!is_whole(value, static_cast<double>(least), static_cast<double>(most)))
    in.fail(at, fmt::format("{} is {}", what, value), "expected " + expected);
  return static_cast<std::int64_t>(value);
}

std::uint64_t whole_number(Reader& in, std::string_view what) {
  return static_cast<std::uint64_t>(whole_number(in, what, 0, most_whole, "a whole number up to 2^53"));
}

}  // namespace json
}  // namespace durero::io
