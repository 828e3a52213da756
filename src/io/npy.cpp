#include "durero/io/npy.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <charconv>
#include <cstdint>
#include <optional>

#include "durero/text/shown.hpp"

namespace durero::io {
namespace {

constexpr std::string_view magic = "\x93NUMPY";

std::uint64_t little_endian(std::string_view bytes) {
  std::uint64_t value = 0;
  for (std::size_t i = bytes.size(); i-- > 0;) value = value << 8U | static_cast<unsigned char>(bytes[i]);
  return value;
}

std::uint64_t big_endian(std::string_view bytes) {
  std::uint64_t value = 0;
  for (const char c : bytes) value = value << 8U | static_cast<unsigned char>(c);
  return value;
}

[[noreturn]] void refuse(const Source& source, const std::string& wrong, const std::string& expected) {
  source.fail(0, wrong, expected);
}

// Where the data start, and the Python dictionary before them. Versions 1, 2 and 3 differ in the width of its length.
struct Head {
  std::string_view dictionary;
  std::size_t data;
};

Head read_head(const Source& source) {
  const std::string_view text = source.text();
  if (!is_npy(text)) refuse(source, "no NumPy file", "expected one that starts with \\x93NUMPY");
  const std::size_t version = text.size() > 6 ? static_cast<unsigned char>(text[6]) : 0;
  if (version < 1 || version > 3) refuse(source, fmt::format(".npy version {}", version), "expected 1, 2 or 3");
  const std::size_t width = version == 1 ? 2 : 4;
  const std::size_t start = 8 + width;
  const std::size_t length = text.size() < start ? 0 : little_endian(text.substr(8, width));
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

std::pair<std::size_t, std::size_t> shape_of(const Source& source, const Head& head) {
  const auto shape = read_shape(value_of(source, head.dictionary, "shape"));
  if (!shape) refuse(source, "another shape", "expected (n,) or (n, m)");
  return *shape;
}

}  // namespace

bool is_npy(std::string_view text) noexcept { return text.starts_with(magic); }

std::size_t npy_columns(const Source& source) { return shape_of(source, read_head(source)).second; }

std::vector<double> read_npy(const Source& source, std::size_t columns) {
  const Head head = read_head(source);
  const std::string_view descr = value_of(source, head.dictionary, "descr");
  const bool big = descr.starts_with("'>f8'") || descr.starts_with("\">f8\"");
  if (!big && !descr.starts_with("'<f8'") && !descr.starts_with("\"<f8\"")) {
    refuse(source, fmt::format("dtype {}", text::shown(descr.substr(0, descr.find(',')))),
           "expected float64 ('<f8' or '>f8')");
  }
  const bool fortran = value_of(source, head.dictionary, "fortran_order").starts_with("True");
  const auto shape = shape_of(source, head);
  if (shape.second != columns) refuse(source, "another shape", fmt::format("expected (n, {})", columns));
  const std::string_view data = source.text().substr(head.data);
  const std::size_t rows = shape.first;
  if (data.size() % (8 * columns) != 0 || data.size() / (8 * columns) != rows) {
    refuse(source, fmt::format("{} bytes of data", data.size()),
           fmt::format("expected {} rows of {} float64", rows, columns));
  }
  std::vector<double> values(rows * columns);
  for (std::size_t i = 0; i < values.size(); ++i) {
    const std::size_t place = fortran ? i % rows * columns + i / rows : i;
    const std::string_view bytes = data.substr(8 * i, 8);
    values[place] = std::bit_cast<double>(big ? big_endian(bytes) : little_endian(bytes));
  }
  return values;
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
