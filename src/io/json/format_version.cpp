#include "durero/io/json/format_version.hpp"

#include <fmt/format.h>

#include <cmath>

#include "durero/text/shown.hpp"

namespace durero::io::json {

void require_version(const Reader& in, const FormatVersion& expected) {
  if (auto format = in.member("format")) {
    const std::size_t at = format->offset();
    const std::string_view name = format->string("format");
    if (name != expected.format)
      in.fail(at, fmt::format("format is {}", text::shown(name)), fmt::format("expected \"{}\"", expected.format));
  }
  if (auto version = in.member("version")) {
    const std::size_t at = version->offset();
    const double number = version->number("version"), known = static_cast<double>(expected.version);
    if (number > known && std::trunc(number) == number)
      in.fail(at, fmt::format("version {} of {}", number, expected.format),
              fmt::format("expected {} (written by a newer durero?)", expected.version));
    if (number != known)
      in.fail(at, fmt::format("version is {}", number), fmt::format("expected {}", expected.version));
  }
}

void write_version(Writer& out, const FormatVersion& of) {
  out.member("format", of.format).member("version", of.version);
}

}  // namespace durero::io::json
