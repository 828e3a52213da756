#include "ply_header.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <optional>
#include <span>
#include <string>

#include "durero/text/shown.hpp"
#include "io/cursor.hpp"

namespace durero::io {
namespace {

using Words = std::span<const std::string_view>;

constexpr std::string_view ply_beginning[] = {"ply"}, ply_first_statement[] = {"format"}, ply_versions[] = {"1.0"};
constexpr std::string_view ply_encodings[] = {"ascii", "binary_little_endian", "binary_big_endian"};
constexpr std::string_view ply_statements[] = {"comment", "obj_info", "element", "property", "end_header"};
constexpr std::string_view ply_counts[] = {"uchar", "uint8", "ushort", "uint16"};
constexpr std::string_view ply_list_or_types[] = {"list",   "char",   "int8",    "uchar",  "uint8",  "short",
                                                  "int16",  "ushort", "uint16",  "int",    "int32",  "uint",
                                                  "uint32", "float",  "float32", "double", "float64"};
constexpr Words ply_types = Words(ply_list_or_types).subspan(1);
constexpr std::string_view ply_vertices[] = {"vertex", "vertices"}, ply_faces[] = {"face", "faces"},
                           ply_axes[] = {"x", "y", "z"};
constexpr std::string_view ply_coordinates[] = {"float", "float32", "double", "float64"};
constexpr std::string_view ply_numbers[] = {"int", "int32", "uint", "uint32"};
constexpr std::string_view ply_lists[] = {"vertex_indices", "vertex_index"};

bool among(std::string_view word, Words words) { return std::ranges::find(words, word) != words.end(); }

std::string one_of_words(Words words) { return fmt::format("one of {}", fmt::join(words, ", ")); }

class HeaderReader {
 public:
  explicit HeaderReader(const Source& source) : source_(source), lines_(source.text()) {}

  PlyHeader read() {
    next_line();
    word(ply_beginning, "expected ply: no PLY file begins otherwise");
    end_line();
    next_line();
    word(ply_first_statement, "expected format");
    const std::string_view encoding = word(ply_encodings, "expected " + one_of_words(ply_encodings));
    header_.is_text = encoding == "ascii";
    header_.is_little = encoding == "binary_little_endian";
    word(ply_versions, "expected 1.0");
    end_line();
    while (read_statement()) {
    }
    header_.vertex = element_named(ply_vertices);
    header_.face = element_named(ply_faces);
    for (const PlyElement& element : header_.elements) check_repetition(element);
    find_axes(header_.elements[header_.vertex]);
    find_corners(header_.elements[header_.face]);
    return std::move(header_);
  }

 private:
  bool read_statement() {
    next_line();
    const std::string_view statement = word(ply_statements, "expected " + one_of_words(ply_statements));
    if (statement == "element") {
      read_element();
    } else if (statement == "property") {
      read_property();
    } else if (statement == "end_header") {
      end_line();
      return false;
    }
    return true;
  }

  void read_element() {
    PlyElement element;
    element.at = begin_;
    element.name = word();
    const std::size_t at = line_->offset();
    const std::string_view digits = word();
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), element.items);
    if (error != std::errc() || end != digits.data() + digits.size())
      source_.fail(at, fmt::format("{} in element", text::shown(digits)), "expected how many there are");
    end_line();
    header_.elements.push_back(std::move(element));
  }

  void read_property() {
    if (header_.elements.empty()) source_.fail(begin_, "a property of no element", "expected element before it");
    PlyProperty property;
    property.type = type_of(ply_list_or_types);
    if (property.type == "list") {
      property.counted_by = word(ply_counts, fmt::format("expected {}, which count a list", one_of_words(ply_counts)));
      property.type = type_of(ply_types);
    }
    const std::size_t at = line_->offset();
    property.name = word();
    if (property.name.empty()) source_.fail(at, line_->here(), "expected the name of a property");
    end_line();
    header_.elements.back().properties.push_back(property);
  }

  std::string_view type_of(Words known) {
    const std::size_t at = line_->offset();
    const std::string_view type = word();
    if (!among(type, known))
      source_.fail(at, fmt::format("unknown type {}", text::shown(type)), "expected " + one_of_words(known));
    return type;
  }

  /// Which element has one of these names. There must be one.
  std::size_t element_named(Words names) const {
    std::optional<std::size_t> which;
    for (std::size_t i = 0; i < header_.elements.size(); ++i) {
      if (!among(header_.elements[i].name, names)) continue;
      if (which) source_.fail(header_.elements[i].at, fmt::format("a second element {}", names[0]), "expected one");
      which = i;
    }
    if (!which)
      source_.fail(begin_, fmt::format("no element {} in the header", names[0]), "expected " + one_of_words(names));
    return *which;
  }

  void check_repetition(const PlyElement& element) const {
    for (auto p = element.properties.begin(); p != element.properties.end(); ++p) {
      if (std::ranges::find(p + 1, element.properties.end(), p->name, &PlyProperty::name) != element.properties.end())
        source_.fail(element.at, fmt::format("two properties {}", text::shown(p->name)), "expected names of their own");
    }
    // Nothing stands in the data for such items, however many there are.
    if (element.properties.empty() && element.items > 0)
      source_.fail(element.at, fmt::format("element {} without a property", text::shown(element.name)),
                   "expected some");
  }

  /// The number of the property that is a coordinate of that name; nothing where there is none.
  static std::optional<std::size_t> coordinate(const PlyElement& vertex, std::string_view name) {
    const auto p = std::ranges::find(vertex.properties, name, &PlyProperty::name);
    if (p == vertex.properties.end() || !p->counted_by.empty() || !among(p->type, ply_coordinates)) return std::nullopt;
    return static_cast<std::size_t>(p - vertex.properties.begin());
  }

  void find_axes(const PlyElement& vertex) {
    for (std::size_t i = 0; i < header_.axes.size(); ++i) {
      const auto found = coordinate(vertex, ply_axes[i]);
      if (!found)
        source_.fail(vertex.at, fmt::format("a vertex without a coordinate {}", ply_axes[i]),
                     "expected x, y and z, each " + one_of_words(ply_coordinates));
      header_.axes[i] = *found;
    }
    const auto x = coordinate(vertex, "nx"), y = coordinate(vertex, "ny"), z = coordinate(vertex, "nz");
    if (x && y && z) header_.normals = {*x, *y, *z};
  }

  void find_corners(const PlyElement& face) {
    const auto is_list_of_vertices = [](const PlyProperty& p) {
      return among(p.name, ply_lists) && !p.counted_by.empty() && among(p.type, ply_numbers);
    };
    if (std::ranges::count_if(face.properties, is_list_of_vertices) != 1)
      source_.fail(face.at, "a face without a list of vertices",
                   fmt::format("expected {}, a list of {}", one_of_words(ply_lists), one_of_words(ply_numbers)));
    const auto list = std::ranges::find_if(face.properties, is_list_of_vertices);
    header_.corners = static_cast<std::size_t>(list - face.properties.begin());
  }

  void next_line() {
    const auto line = lines_.next();
    if (!line) source_.fail(source_.text().size(), "the text ends in its header", "expected end_header");
    line_.emplace(source_, *line);
    begin_ = line_->offset();
    header_.end = line->end;
  }

  std::string_view word() {
    const std::string_view word = line_->word("");
    line_->skip_blanks();
    return word;
  }

  std::string_view word(Words expected, const std::string& sentence) {
    const std::size_t at = line_->offset();
    const std::string_view word = this->word();
    if (!among(word, expected)) source_.fail(at, fmt::format("{} stands here", text::shown(word)), sentence);
    return word;
  }

  void end_line() const {
    if (!line_->done()) source_.fail(line_->offset(), line_->here(), "expected the end of the line");
  }

  const Source& source_;
  Lines lines_;
  std::optional<WordCursor> line_;
  std::size_t begin_ = 0;  // of the line's first word
  PlyHeader header_;
};

}  // namespace

PlyHeader read_ply_header(const Source& source) {
  PlyHeader header = HeaderReader(source).read();
  const std::string_view rest = source.text().substr(header.end);
  header.end += rest.starts_with("\r\n") ? 2 : rest.empty() ? 0 : 1;
  return header;
}

}  // namespace durero::io
