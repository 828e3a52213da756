#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "durero/io/mesh/ply.hpp"
#include "durero/text/shown.hpp"
#include "io/cursor.hpp"
#include "io/losses.hpp"
#include "mesh_scene.hpp"
#include "ply_header.hpp"

namespace durero::io {
namespace {

constexpr std::string_view blanks = " \t\v\f\r\n";

/// Looks at what the library has read: it stops without a word, and takes any number for a vertex.
class PlyCheck {
 public:
  PlyCheck(const Source& source, const PlyHeader& header, const PolygonSoup& soup)
      : source_(source), header_(header), soup_(soup) {}

  /// Throws InputError.
  void check() const {
    if (!soup_.whole) fail_where_it_stopped();
    for (std::size_t i = 0; i < soup_.vertices.size(); ++i) {
      const glm::dvec3& v = soup_.vertices[i];
      if (!std::isfinite(v.x) || !std::isfinite(v.y) || !std::isfinite(v.z))
        source_.fail(vertex().at, fmt::format("vertex {} is ({}, {}, {})", i, v.x, v.y, v.z),
                     "expected finite numbers");
    }
    for (std::size_t i = 0; i < soup_.faces.size(); ++i) check_face(i);
    const std::size_t more = header_.is_text ? source_.text().find_first_not_of(blanks, soup_.end) : soup_.end;
    if (more < source_.text().size())
      source_.fail(header_.is_text ? more : face().at, "data behind the last element",
                   "expected as many as the header tells of");
  }

 private:
  const PlyElement& vertex() const { return header_.elements[header_.vertex]; }
  const PlyElement& face() const { return header_.elements[header_.face]; }

  [[noreturn]] void fail_where_it_stopped() const {
    const std::string read = fmt::format("after {} vertices and {} faces", soup_.vertices.size(), soup_.faces.size());
    const std::string expected = fmt::format("expected {} vertices and {} faces", vertex().items, face().items);
    const std::size_t at = header_.is_text ? begin_of_word(soup_.end) : source_.text().size();
    const std::string_view rest = source_.text().substr(at);
    if (rest.empty()) source_.fail(header_.is_text ? at : face().at, "the data end " + read, expected);
    source_.fail(at, fmt::format("{} {}", text::shown(rest.substr(0, rest.find_first_of(blanks))), read), expected);
  }

  /// Where the word begins that the library read last, or would read next: its stream stops within the word that it
  /// does not understand, or before it.
  std::size_t begin_of_word(std::size_t at) const {
    const std::string_view text = source_.text();
    if (at == text.size()) return at;
    if (blanks.find(text[at]) != blanks.npos) at = text.find_last_not_of(blanks, at);
    return text.find_last_of(blanks, at) + 1;
  }

  void check_face(std::size_t i) const {
    const Face& corners = soup_.faces[i];
    if (corners.size() < 3)
      source_.fail(place(i), fmt::format("face {} has {} vertices", i, corners.size()), "expected 3 or more");
    for (const std::int64_t corner : corners) {
      if (corner < 0 || static_cast<std::size_t>(corner) >= soup_.vertices.size()) {
        source_.fail(place(i), fmt::format("face {} names vertex {}", i, corner),
                     fmt::format("expected one of {}, counted from 0", soup_.vertices.size()));
      }
    }
  }

  /// Of a face: the line on which its last number stands.
  std::size_t place(std::size_t i) const {
    if (!header_.is_text) return face().at;
    const std::size_t line_end = source_.text().find_last_of("\r\n", soup_.face_ends[i] - 1);
    return source_.text().find_first_not_of(blanks, line_end);
  }

  const Source& source_;
  const PlyHeader& header_;
  const PolygonSoup& soup_;
};

std::vector<std::string> losses_of(const PlyHeader& header) {
  std::vector<std::string> lost;
  for (const PlyElement& element : header.elements) {
    const bool is_vertex = &element == &header.elements[header.vertex],
               is_face = &element == &header.elements[header.face];
    if (!is_vertex && !is_face) {
      add_loss(lost, element.items, fmt::format("item of element {}", text::shown(element.name)),
               fmt::format("items of element {}", text::shown(element.name)), "left out: a scene has none");
      continue;
    }
    const std::size_t kept = is_vertex ? 3 : 1;
    add_loss(lost, element.properties.size() - kept, fmt::format("property of element {}", element.name),
             fmt::format("properties of element {}", element.name), "left out: a triangle has its vertices alone");
  }
  return lost;
}

}  // namespace

Imported read_ply(const Source& source) {
  const PlyHeader header = read_ply_header(source);
  std::string plain;
  plain.reserve(source.text().size());
  const std::size_t text_end = header.is_text ? source.text().size() : header.end;
  append_plain(plain, source.text().substr(0, text_end));
  plain += source.text().substr(text_end);
  const PolygonSoup soup = ply_soup(plain);
  PlyCheck(source, header, soup).check();
  return mesh_scene(source, soup, losses_of(header));
}

}  // namespace durero::io
