#include "durero/io/source.hpp"

#include <fmt/format.h>

#include <cstdio>
#include <mutex>
#include <system_error>
#include <utility>
#include <vector>

#include "descriptor.hpp"
#include "durero/io/input.hpp"
#include "durero/io/lines.hpp"
#include "durero/io/rays/npy.hpp"
#include "durero/text/file.hpp"
#include "durero/text/shown.hpp"
#include "durero/text/utf8.hpp"

namespace durero::io {

namespace {

std::string head_of(const std::string& file, TextPosition place) {
  return text::escaped(fmt::format("{}:{}:{}: ", file, place.line, place.column));
}

}  // namespace

InputError::InputError(const std::string& file, TextPosition place, const std::string& wrong,
                       const std::string& expected, const contract::clause* broken)
    : std::runtime_error(head_of(file, place) + text::escaped(fmt::format("{}; {}", wrong, expected))),
      place_(place),
      message_at_(head_of(file, place).size()),
      broken_(broken) {}

FileError::FileError(const std::string& file, const std::string& wrong, const std::string& expected)
    : std::runtime_error(text::escaped(fmt::format("{}: {}; {}", file, wrong, expected))) {}

/// The places of every 4096th byte, as far as they have been asked for.
struct Source::Counted {
  static constexpr std::size_t stride = 4096;
  std::mutex mutex;
  std::vector<TextPosition> places;
};

Source::Source(std::string name, std::string text, std::size_t lines_before)
    : name_(std::move(name)), text_(std::move(text)), counted_(std::make_shared<Counted>()) {
  counted_->places.push_back({lines_before + 1, 1});
}

TextPosition Source::place(std::size_t offset) const {
  constexpr std::size_t stride = Counted::stride;
  const auto count = [&](TextPosition& place, std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i) {
      if (ends_line(text_, i)) {
        ++place.line;
        place.column = 1;
      } else if (!text::continues(text_[i])) {
        ++place.column;
      }
    }
  };
  const std::lock_guard lock(counted_->mutex);
  std::vector<TextPosition>& places = counted_->places;
  while (places.size() * stride <= offset) {
    TextPosition next = places.back();
    count(next, (places.size() - 1) * stride, places.size() * stride);
    places.push_back(next);
  }
  TextPosition place = places[offset / stride];
  count(place, offset / stride * stride, offset);
  return place;
}

void Source::fail(std::size_t offset, const std::string& wrong, const std::string& expected,
                  const contract::clause* broken) const {
  InputError error(name_, place(offset), wrong, expected, broken);
  error.offset_ = offset;
  throw error;
}

Source read_source(const std::string& path) {
  const bool standard = path == "-";
  const std::string name = standard ? "<stdin>" : path;
  try {
    return {name, standard ? text::read_rest(*stdin) : text::read_file(path)};
  } catch (const std::system_error& error) {
    refuse_to_read(name, error.code().value());
  }
}

Source read_lines(const std::string& path) {
  Input input(path);
  const bool has_lines = !is_npy(input);
  std::string text;
  LineLengths lengths;
  do {
    const std::string_view more = input.waiting();
    const auto too_many = has_lines ? lengths.pass(more) : std::nullopt;
    text.append(more);
    input.take(more.size());
    if (too_many) refuse_long_line({input.name(), std::move(text)}, *too_many - longest_line);
  } while (input.read());
  return {input.name(), std::move(text)};
}

void refuse_long_line(const Source& source, std::size_t begin) {
  source.fail(begin + longest_line, fmt::format("a line of more than {} bytes", longest_line),
              "expected a shorter one: no line that means something is so long");
}

}  // namespace durero::io
