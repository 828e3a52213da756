#include "durero/io/rays/npy.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <charconv>
#include <cstdint>
#include <optional>

#include "durero/text/shown.hpp"
#include "io/byte_order.hpp"

namespace durero::io {
namespace {

constexpr std::string_view magic = "\x93NUMPY";

/// How many bytes the dictionary of a head has at most. NumPy writes 118 where the numbers are binary64, and reads no
/// more than 10 000 unless it is told otherwise.
constexpr std::size_t longest_dictionary = std::size_t{1} << 20U;

constexpr std::size_t rows_at_once = std::size_t{1} << 14U;

double binary64(std::string_view bytes, bool is_big_endian) {
  return std::bit_cast<double>(is_big_endian ? big_endian(bytes) : little_endian(bytes));
}

[[noreturn]] void refuse(const Source& source, const std::string& wrong, const std::string& expected) {
  source.fail(0, wrong, expected);
}

// Where the data start, and the Python dictionary before them.
struct NpyHeader {
  std::string_view dictionary;
  std::size_t data;
};

// Versions 1, 2 and 3 differ in how many bytes the length of the dictionary takes; 0: there is no such version.
std::size_t width_of_length(std::size_t version) {
  if (version < 1 || version > 3) return 0;
  return version == 1 ? 2 : 4;
}

// How many bytes tell all that the head has, as far as these tell it, or that it is too long.
std::size_t head_size(std::string_view text) {
  if (text.size() < 7) return 7;
  const std::size_t width = width_of_length(static_cast<unsigned char>(text[6]));
  if (width == 0 || text.size() < 8 + width) return 8 + width;
  return 8 + width + std::min<std::size_t>(little_endian(text.substr(8, width)), longest_dictionary);
}

NpyHeader read_head(const Source& source) {
  const std::string_view text = source.text();
  if (!is_npy(text)) refuse(source, "no NumPy file", "expected one that starts with \\x93NUMPY");
  const std::size_t version = text.size() > 6 ? static_cast<unsigned char>(text[6]) : 0;
  const std::size_t width = width_of_length(version);
  if (width == 0) refuse(source, fmt::format(".npy version {}", version), "expected 1, 2 or 3");
  const std::size_t start = 8 + width;
  const std::size_t length = text.size() < start ? 0 : little_endian(text.substr(8, width));
  if (length > longest_dictionary)
    refuse(source, fmt::format("a head of {} bytes", length), fmt::format("expected at most {}", longest_dictionary));
  if (text.size() < start || length > text.size() - start)
    refuse(source, "the head is cut", "expected a whole .npy file");
  return {text.substr(start, length), start + length};
}

// The text of a value in the dictionary, from behind its key's colon.
std::string_view value_of(const Source& source, std::string_view dictionary, std::string_view key) {
  for (const char quote : {'\'', '"'}) {
    const std::size_t at = dictionary.find(fmt::format("{0}{1}{0}", quote, key));
    if (at == dictionary.npos) continue;
    const std::size_t colon = dictionary.find(':', at);
    const std::size_t first = colon == dictionary.npos ? colon : dictionary.find_first_not_of(" \t", colon + 1);
    if (first != dictionary.npos) return dictionary.substr(first);
  }
  refuse(source, fmt::format("the head has no {}", key), "expected descr, fortran_order and shape");
}

// The two numbers of a shape `(n, m)`; of `(n,)` the second is 1.
std::optional<std::pair<std::size_t, std::size_t>> read_shape(std::string_view text) {
  std::size_t shape[2] = {0, 1};
  const char* next = text.data();
  const char* const end = text.data() + text.size();
  const auto skip = [&](char separator) {
    while (next != end && (*next == ' ' || *next == separator)) ++next;
  };
  for (int i = 0; i < 2; ++i) {
    skip(i == 0 ? '(' : ',');
    if (i == 1 && next != end && *next == ')') break;
    const auto [behind, error] = std::from_chars(next, end, shape[i]);
    if (error != std::errc()) return std::nullopt;
    next = behind;
  }
  skip(',');
  if (next == end || *next != ')') return std::nullopt;
  return std::pair{shape[0], shape[1]};
}

std::pair<std::size_t, std::size_t> shape_of(const Source& source, const NpyHeader& head) {
  const auto shape = read_shape(value_of(source, head.dictionary, "shape"));
  if (!shape) refuse(source, "another shape", "expected (n,) or (n, m)");
  return *shape;
}

// Whether the numbers of a table are big-endian.
bool read_byte_order(const Source& source, const NpyHeader& head) {
  const std::string_view descr = value_of(source, head.dictionary, "descr");
  const bool big = descr.starts_with("'>f8'") || descr.starts_with("\">f8\"");
  if (!big && !descr.starts_with("'<f8'") && !descr.starts_with("\"<f8\"")) {
    refuse(source, fmt::format("dtype {}", text::shown(descr.substr(0, descr.find(',')))),
           "expected float64 ('<f8' or '>f8')");
  }
  return big;
}

}  // namespace

bool is_npy(std::string_view text) noexcept { return text.starts_with(magic); }

bool is_npy(Input& input) {
  while (input.waiting().size() < magic.size() && magic.starts_with(input.waiting()) && input.read()) {
  }
  return is_npy(input.waiting());
}

std::size_t npy_columns(const Source& source) { return shape_of(source, read_head(source)).second; }

NpyReader::NpyReader(Input& input, std::size_t columns) : input_(input), columns_(columns) {
  while (is_npy(input) && input.waiting().size() < head_size(input.waiting()) && input.read()) {
  }
  const Source source(input.name(), std::string(input.waiting().substr(0, head_size(input.waiting()))));
  const NpyHeader head = read_head(source);
  is_big_endian_ = read_byte_order(source, head);
  is_fortran_ = value_of(source, head.dictionary, "fortran_order").starts_with("True");
  const auto shape = shape_of(source, head);
  if (shape.second != columns) refuse(source, "another shape", fmt::format("expected (n, {})", columns));
  rows_ = shape.first;
  input.take(head.data);
  // In Fortran order the first row has its last number near the end.
  while (is_fortran_ && !input.left() && input.waiting().size() / width() <= rows_ && input.read()) {
  }
  const auto bytes = input.left();
  if (is_fortran_ && !bytes) refuse_data(input.waiting().size());
  if (bytes && (*bytes % width() != 0 || *bytes / width() != rows_)) refuse_data(*bytes);
}

void NpyReader::refuse_data(std::uint64_t bytes) const {
  throw InputError(input_.name(), {1, 1}, fmt::format("{} bytes of data", bytes),
                   fmt::format("expected {} rows of {} float64", rows_, columns_));
}

bool NpyReader::next(std::vector<double>& values) {
  if (at_end()) return false;
  values.clear();
  if (is_fortran_) {
    gathered(values);
  } else {
    in_order(values);
  }
  done_ += values.size() / columns_;
  return true;
}

// At the end of the table so is the input, and before it the input has a row more.
bool NpyReader::at_end() {
  if (is_fortran_) return done_ == rows_;
  const std::uint64_t before = done_ * width();
  if (done_ < rows_) {
    while (input_.waiting().size() < width() && input_.read()) {
    }
    if (input_.waiting().size() < width()) refuse_data(before + input_.waiting().size());
    return false;
  }
  std::uint64_t behind = 0;
  do {
    behind += input_.waiting().size();
    input_.take(input_.waiting().size());
  } while (input_.read());
  if (behind > 0) refuse_data(before + behind);
  return true;
}

void NpyReader::in_order(std::vector<double>& values) {
  const std::size_t count = std::min({input_.waiting().size() / width(), rows_ - done_, rows_at_once}) * columns_;
  const std::string_view bytes = input_.waiting();
  values.reserve(count);
  for (std::size_t i = 0; i < count; ++i) values.push_back(binary64(bytes.substr(8 * i, 8), is_big_endian_));
  input_.take(8 * count);
}

// In Fortran order a column stands whole before the next.
void NpyReader::gathered(std::vector<double>& values) {
  const std::size_t count = std::min(rows_ - done_, rows_at_once);
  values.resize(count * columns_);
  std::string bytes(8 * count, '\0');
  for (std::size_t column = 0; column < columns_; ++column) {
    input_.look(8 * (column * rows_ + done_), bytes);
    for (std::size_t row = 0; row < count; ++row)
      values[row * columns_ + column] = binary64(std::string_view(bytes).substr(8 * row, 8), is_big_endian_);
  }
}

std::vector<double> read_npy(const Source& source, std::size_t columns) {
  Input input(source);
  NpyReader table(input, columns);
  std::vector<double> all, rows;
  while (table.next(rows)) all.insert(all.end(), rows.begin(), rows.end());
  return all;
}

std::string npy_head(std::string_view descr, std::string_view shape) {
  std::string dictionary = fmt::format("{{'descr': {}, 'fortran_order': False, 'shape': {}, }}", descr, shape);
  // The data start at a multiple of 64 bytes: 6 of magic, 2 of version, 4 of length, the dictionary and a line end.
  constexpr std::size_t before = 12;
  dictionary.append((64 - (before + dictionary.size() + 1) % 64) % 64, ' ').push_back('\n');
  std::string out(magic);
  out.append("\x02\x00", 2);
  for (unsigned i = 0; i < 4; ++i) out.push_back(static_cast<char>(dictionary.size() >> (8 * i) & 0xFFU));
  return out + dictionary;
}

void append_binary64(std::string& out, double value) {
  const auto bits = std::bit_cast<std::uint64_t>(value);
  for (unsigned i = 0; i < 8; ++i) out.push_back(static_cast<char>(bits >> (8 * i) & 0xFFU));
}

}  // namespace durero::io
