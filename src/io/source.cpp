#include "durero/io/source.hpp"

#include <fmt/format.h>

#include <array>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>

#include "durero/io/lines.hpp"
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
  const auto refuse = [&](int error) -> FileError {
    return {name, fmt::format("cannot be read: {}", std::strerror(error)), "expected a readable file"};
  };
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(standard ? stdin : std::fopen(path.c_str(), "rb"),
                                                             [](std::FILE* f) { return f == stdin ? 0 : fclose(f); });
  if (!file) throw refuse(errno);
  std::string text;
  std::array<char, 1U << 16U> block;
  errno = 0;
  while (const std::size_t n = std::fread(block.data(), 1, block.size(), file.get())) text.append(block.data(), n);
  if (std::ferror(file.get()) != 0) throw refuse(errno);
  return {name, std::move(text)};
}

}  // namespace durero::io
