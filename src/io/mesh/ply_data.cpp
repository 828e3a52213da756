#include "ply_data.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <optional>

#include "durero/io/number_text.hpp"
#include "durero/text/shown.hpp"
#include "io/byte_order.hpp"

namespace durero::io {
namespace {

constexpr std::string_view ply_blanks = " \t\v\f\r\n";

/// A whole number of a type that has these bounds.
template <class Number>
std::optional<double> ply_number(std::string_view word) {
  if (word.starts_with('+') && !word.starts_with("+-")) word.remove_prefix(1);
  std::int64_t number = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), number);
  const bool is_whole = error == std::errc() && end == word.data() + word.size();
  if (!is_whole || number < std::numeric_limits<Number>::min() || number > std::numeric_limits<Number>::max())
    return std::nullopt;
  return static_cast<double>(number);
}

template <>
std::optional<double> ply_number<double>(std::string_view word) {
  return read_decimal(word);
}

/// The nearest binary32, not that of the nearest binary64.
template <>
std::optional<double> ply_number<float>(std::string_view word) {
  if (!read_decimal(word)) return std::nullopt;
  if (word.starts_with('+')) word.remove_prefix(1);
  float value = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  // std::from_chars leaves the value alone beyond either end of the range, as in read_number().
  if (error == std::errc::result_out_of_range) value = std::strtof(std::string(word).c_str(), nullptr);
  return std::isfinite(value) ? std::optional<double>(value) : std::nullopt;
}

/// The number that the low bytes of a word are.
template <class Number>
double ply_value(std::uint64_t bytes) {
  if constexpr (std::is_same_v<Number, double>)
    return std::bit_cast<double>(bytes);
  else if constexpr (std::is_same_v<Number, float>)
    return std::bit_cast<float>(static_cast<std::uint32_t>(bytes));
  else
    return static_cast<Number>(bytes);
}

struct PlyType {
  std::string_view name, other_name;
  std::size_t size;
  std::optional<double> (*read)(std::string_view word);
  double (*value)(std::uint64_t bytes);
};

template <class Number>
constexpr PlyType ply_type(std::string_view name, std::string_view other_name) {
  return {name, other_name, sizeof(Number), &ply_number<Number>, &ply_value<Number>};
}

constexpr std::array ply_number_types{
    ply_type<std::int8_t>("char", "int8"),    ply_type<std::uint8_t>("uchar", "uint8"),
    ply_type<std::int16_t>("short", "int16"), ply_type<std::uint16_t>("ushort", "uint16"),
    ply_type<std::int32_t>("int", "int32"),   ply_type<std::uint32_t>("uint", "uint32"),
    ply_type<float>("float", "float32"),      ply_type<double>("double", "float64"),
};

/// Precondition: the header knows the type.
const PlyType& type_named(std::string_view name) {
  return *std::ranges::find_if(ply_number_types,
                               [&](const PlyType& t) { return t.name == name || t.other_name == name; });
}

class PlyDataReader {
 public:
  PlyDataReader(const Source& source, const PlyHeader& header) : source_(source), header_(header), next_(header.end) {}

  PolygonSoup read() {
    for (const PlyElement& element : header_.elements) read(element);
    skip_blanks();
    if (next_ < source_.text().size())
      source_.fail(header_.is_text ? next_ : face().at, "data behind the last element",
                   "expected as many as the header tells of");
    return std::move(soup_);
  }

 private:
  const PlyElement& vertex() const { return header_.elements[header_.vertex]; }
  const PlyElement& face() const { return header_.elements[header_.face]; }

  /// A property: a number of its type, or a list of them, which one of another type counts.
  struct Column {
    const PlyType* type;
    const PlyType* counted_by;
  };

  void read(const PlyElement& element) {
    element_ = &element;
    std::vector<Column> columns;
    for (const PlyProperty& p : element.properties)
      columns.push_back({&type_named(p.type), p.counted_by.empty() ? nullptr : &type_named(p.counted_by)});
    for (std::uint64_t i = 0; i < element.items; ++i) {
      skip_blanks();
      item_at_ = header_.is_text ? next_ : element.at;
      if (&element == &vertex())
        read_vertex(columns);
      else if (&element == &face())
        read_face(columns);
      else
        for (const Column& column : columns) pass(column);
    }
  }

  void read_vertex(const std::vector<Column>& columns) {
    glm::dvec3 v{}, n{};
    for (std::size_t i = 0; i < columns.size(); ++i) {
      double* const kept = coordinate(i, v, n);
      if (kept == nullptr)
        pass(columns[i]);
      else
        *kept = number(*columns[i].type);
    }
    if (!std::isfinite(v.x) || !std::isfinite(v.y) || !std::isfinite(v.z))
      source_.fail(item_at_, fmt::format("vertex {} is ({}, {}, {})", soup_.vertices.size(), v.x, v.y, v.z),
                   "expected finite numbers");
    soup_.vertices.push_back(v);
    if (header_.normals) soup_.normals.push_back(n);
  }

  /// The coordinate of the vertex, or of its normal, that a property is; null where it is none.
  double* coordinate(std::size_t property, glm::dvec3& vertex, glm::dvec3& normal) const {
    const auto among = [&](const std::array<std::size_t, 3>& axes, glm::dvec3& of) -> double* {
      const auto axis = std::ranges::find(axes, property);
      return axis == axes.end() ? nullptr : &of[static_cast<int>(axis - axes.begin())];
    };
    double* const own = among(header_.axes, vertex);
    return own == nullptr && header_.normals ? among(*header_.normals, normal) : own;
  }

  void read_face(const std::vector<Column>& columns) {
    Face corners;
    for (std::size_t i = 0; i < columns.size(); ++i) {
      if (i != header_.corners) {
        pass(columns[i]);
        continue;
      }
      for (auto count = static_cast<std::size_t>(number(*columns[i].counted_by)); count > 0; --count)
        corners.push_back(static_cast<std::int64_t>(number(*columns[i].type)));
    }
    check(corners);
    soup_.faces.push_back(std::move(corners));
  }

  void check(const Face& corners) const {
    if (corners.size() < 3)
      source_.fail(item_at_, fmt::format("face {} has {} vertices", soup_.faces.size(), corners.size()),
                   "expected 3 or more");
    for (const std::int64_t corner : corners) {
      if (corner < 0 || static_cast<std::uint64_t>(corner) >= vertex().items)
        source_.fail(item_at_, fmt::format("face {} names vertex {}", soup_.faces.size(), corner),
                     fmt::format("expected one of {}, counted from 0", vertex().items));
    }
  }

  void pass(const Column& column) {
    if (column.counted_by == nullptr)
      number(*column.type);
    else
      for (auto count = static_cast<std::size_t>(number(*column.counted_by)); count > 0; --count) number(*column.type);
  }

  double number(const PlyType& type) { return header_.is_text ? written(type) : stored(type); }

  double written(const PlyType& type) {
    skip_blanks();
    const std::string_view rest = source_.text().substr(next_);
    const std::string_view word = rest.substr(0, rest.find_first_of(ply_blanks));
    const auto value = type.read(word);
    if (!value) fail_here(next_, word.empty() ? "the data end" : text::shown(word));
    next_ += word.size();
    return *value;
  }

  double stored(const PlyType& type) {
    const std::string_view bytes = source_.text().substr(next_, type.size);
    if (bytes.size() < type.size) fail_here(element_->at, "the data end");
    next_ += type.size;
    return type.value(header_.is_little ? little_endian(bytes) : big_endian(bytes));
  }

  [[noreturn]] void fail_here(std::size_t at, const std::string& wrong) const {
    source_.fail(at, fmt::format("{} after {} vertices and {} faces", wrong, soup_.vertices.size(), soup_.faces.size()),
                 fmt::format("expected {} vertices and {} faces", vertex().items, face().items));
  }

  void skip_blanks() {
    if (header_.is_text) next_ = std::min(source_.text().find_first_not_of(ply_blanks, next_), source_.text().size());
  }

  const Source& source_;
  const PlyHeader& header_;
  std::size_t next_;                     // the byte
  const PlyElement* element_ = nullptr;  // that is read
  std::size_t item_at_ = 0;              // the place of what is read
  PolygonSoup soup_;
};

}  // namespace

PolygonSoup read_ply_data(const Source& source, const PlyHeader& header) {
  return PlyDataReader(source, header).read();
}

}  // namespace durero::io
