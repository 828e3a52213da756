#include "durero/io/source.hpp"

#include <fmt/format.h>

#include <cstdio>
#include <cstring>
#include <system_error>

#include "durero/io/lines.hpp"
#include "durero/text/file.hpp"
#include "durero/text/shown.hpp"
#include "durero/text/utf8.hpp"

namespace durero::io {

InputError::InputError(const std::string& file, Place place, const std::string& wrong, const std::string& expected)
    : std::runtime_error(
          text::escaped(fmt::format("{}:{}:{}: {}; {}", file, place.line, place.column, wrong, expected))),
      place_(place) {}

FileError::FileError(const std::string& file, const std::string& wrong, const std::string& expected)
    : std::runtime_error(text::escaped(fmt::format("{}: {}; {}", file, wrong, expected))) {}

Place Source::place(std::size_t offset) const noexcept {
  Place place{1, 1};
  for (std::size_t i = 0; i < offset; ++i) {
    if (ends_line(text_, i)) {
      ++place.line;
      place.column = 1;
    } else if (!text::continues(text_[i])) {
      ++place.column;
    }
  }
  return place;
}

void Source::fail(std::size_t offset, const std::string& wrong, const std::string& expected) const {
  throw InputError(name_, place(offset), wrong, expected);
}

Source read_source(const std::string& path) {
  const bool standard = path == "-";
  const std::string name = standard ? "<stdin>" : path;
  try {
    return {name, standard ? text::read_rest(*stdin) : text::read_file(path)};
  } catch (const std::system_error& error) {
    throw FileError(name, fmt::format("cannot be read: {}", std::strerror(error.code().value())),
                    "expected a readable file");
  }
}

}  // namespace durero::io
