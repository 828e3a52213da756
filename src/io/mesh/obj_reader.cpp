#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>

#include "durero/io/mesh/obj.hpp"
#include "durero/io/number_text.hpp"
#include "durero/text/nearest.hpp"
#include "durero/text/shown.hpp"
#include "io/cursor.hpp"
#include "io/losses.hpp"
#include "mesh_scene.hpp"
#include "obj_corners.hpp"
#include "obj_words.hpp"

namespace durero::io {
namespace {

/// Reads a mesh line by line. A face may name a vertex that stands below it.
class ObjLines {
 public:
  /// The lines are of the joined text.
  ObjLines(const Source& source, std::string_view joined)
      : source_(source), joined_(joined), vertex_count_(obj_vertex_count(joined)) {}

  /// @{ The mesh, the groups of its faces, and their looks, after read().
  const PolygonSoup& soup() const { return soup_; }
  const FaceGroups& groups() const { return groups_; }
  FaceLooks looks() { return {textures_.take(), normals_.take()}; }
  /// @}

  /// What is lost. Throws InputError.
  std::vector<std::string> read() {
    Lines lines(joined_);
    while (const auto line = lines.next()) {
      WordCursor in(source_, joined_, *line);
      if (!in.done()) read_statement(in);
    }
    if (soup_.vertices.empty() || soup_.faces.empty())
      source_.fail(source_.text().size(), "no mesh", "expected vertices (v) and faces (f)");
    textures_.end();
    normals_.end();
    return losses();
  }

 private:
  void read_statement(WordCursor& in) {
    const std::size_t at = in.offset();
    const std::string_view statement = in.word("#");
    in.skip_blanks();
    const ObjWord* const row = obj_word(statement);
    if (row == nullptr) fail_unknown(in, at, statement);
    switch (row->kind) {
      case ObjKind::vertex:
        return read_vertex(in);
      case ObjKind::face:
        return read_face(in, at);
      case ObjKind::normal:
        return read_normal(in);
      case ObjKind::texture_coordinate:
        return read_texture_coordinate(in);
      case ObjKind::group:
        return read_group(in);
      case ObjKind::material:
        ++materials_;
        return;
      case ObjKind::other:
        ++others_;
        return;
    }
  }

  [[noreturn]] static void fail_unknown(const WordCursor& in, std::size_t at, std::string_view statement) {
    std::vector<std::string> known;
    for (const ObjWord& row : obj_words) known.emplace_back(row.word);
    in.fail(at, fmt::format("unknown statement {}", text::shown(statement)),
            "expected " + text::expected_of(statement, known));
  }

  // x y z, and perhaps a weight or a colour or both.
  void read_vertex(WordCursor& in) {
    glm::dvec3& vertex = soup_.vertices.emplace_back();
    for (int i = 0; i < 3; ++i) {
      const std::size_t at = in.offset();
      const std::string_view digits = in.word("#");
      const auto value = read_decimal(digits);
      if (!value) in.fail(at, fmt::format("{} in v", text::shown(digits)), "expected a finite decimal number");
      vertex[i] = *value;
      in.skip_blanks();
    }
    if (in.done()) return;
    ++weighted_;
    for (int more = 0; !in.done(); ++more) {
      if (more == 4) in.fail(in.offset(), "an eighth number in v", "expected x y z, a weight and a colour at most");
      read_any(in, "v");
    }
  }

  // A number that may be none of binary64: inf, nan.
  static double read_any(WordCursor& in, std::string_view statement) {
    const std::size_t at = in.offset();
    const std::string_view digits = in.word("#");
    const auto number = read_number(digits);
    if (!number) in.fail(at, fmt::format("{} in {}", text::shown(digits), statement), "expected a number");
    in.skip_blanks();
    return *number;
  }

  // x y z, which may be none of binary64: a face with such a normal is flat.
  void read_normal(WordCursor& in) {
    glm::dvec3 normal{};
    for (int i = 0; i < 3; ++i) normal[i] = read_any(in, "vn");
    if (!in.done()) in.fail(in.offset(), "a fourth number in vn", "expected x y z");
    normals_.add(normal);
  }

  // u, and perhaps v and a third, which a surface has no use for.
  void read_texture_coordinate(WordCursor& in) {
    std::array<double, 3> numbers{};
    std::size_t count = 0;
    do {
      if (count == numbers.size()) in.fail(in.offset(), "a fourth number in vt", "expected u, v and a third at most");
      numbers[count++] = in.number("#", "vt");
      in.skip_blanks();
    } while (!in.done());
    textures_.add({numbers[0], numbers[1]});
  }

  // The faces that follow are in the group of the first name, whatever was named before; in none where there is none,
  // or none that a group can have.
  void read_group(WordCursor& in) {
    group_ = FaceGroups::none;
    for (bool first = true; !in.done(); first = false) {
      const std::string_view name = in.word("#");
      in.skip_blanks();
      if (!first)
        ++further_names_;
      else if (model::Elemento::is_name(std::string(name)))
        group_ = groups_.group(name);
      else
        ++no_names_;
    }
  }

  void read_face(WordCursor& in, std::size_t at) {
    Face face;
    while (!in.done()) {
      const std::size_t corner_at = in.offset();
      const std::string_view word = in.word("#");
      const auto corner = corner_of(word);
      if (!corner)
        in.fail(corner_at, fmt::format("{} in f", text::shown(word)),
                "expected v, v/vt, v//vn or v/vt/vn, of whole numbers other than 0");
      check_vertex(in, corner_at, word, corner->vertex);
      face.push_back(corner->vertex);
      if (corner->texture) textures_.name(corner_at, word, *corner->texture);
      if (corner->normal) normals_.name(corner_at, word, *corner->normal);
      check_comment(in, at);
      in.skip_blanks();
    }
    if (face.size() < 3) in.fail(at, fmt::format("a face of {} vertices", face.size()), "expected 3 or more");
    groups_.of_face.push_back(group_);
    textures_.end_face(face.size());
    normals_.end_face(face.size());
    soup_.faces.push_back(std::move(face));
  }

  /// Fails where a comment begins behind a corner without a blank, and a corner seems to follow in it. Others stand
  /// there as they may.
  static void check_comment(WordCursor in, std::size_t face_at) {
    if (!in.at('#')) return;
    in.word("");
    in.skip_blanks();
    if (!in.done() && read_number(in.word("/")))
      in.fail(face_at, "f with numbers in a comment", "expected spaces before a comment");
  }

  void check_vertex(const WordCursor& in, std::size_t at, std::string_view corner, std::int64_t vertex) const {
    if (vertex < 0 || static_cast<std::size_t>(vertex) >= vertex_count_)
      in.fail(at, fmt::format("{} names no vertex", text::shown(corner)), expected_number(vertex_count_, "v"));
  }

  /// The numbers, from 0, of what a corner of a face names.
  struct Corner {
    std::int64_t vertex = 0;
    std::optional<std::int64_t> texture{}, normal{};
  };
  /// A negative number counts back from the last one above; behind a / there may be none. Nothing where it is no
  /// corner.
  std::optional<Corner> corner_of(std::string_view word) const {
    Corner corner;
    for (int part = 0; part < 3; ++part) {
      const std::size_t length = std::min(word.find('/'), word.size());
      std::int32_t number = 0;
      const auto [end, error] = std::from_chars(word.data(), word.data() + length, number);
      const bool left_out = part > 0 && length == 0;
      if (!left_out && (error != std::errc() || end != word.data() + length || number == 0)) return std::nullopt;
      const auto from_0 = [&](std::size_t above) {
        return number > 0 ? number - 1 : static_cast<std::int64_t>(above) + number;
      };
      if (part == 0) corner.vertex = from_0(soup_.vertices.size());
      if (part == 1 && !left_out) corner.texture = from_0(textures_.count());
      if (part == 2 && !left_out) corner.normal = from_0(normals_.count());
      if (length == word.size()) return corner;
      word.remove_prefix(length + 1);
    }
    return std::nullopt;
  }

  std::vector<std::string> losses() const {
    std::vector<std::string> lost;
    add_loss(lost, normals_.unused(), "normal", "normals", "left out: no face has them at all of its corners");
    add_loss(lost, textures_.unused(), "texture coordinate", "texture coordinates",
             "left out: no face has them at all of its corners");
    add_loss(lost, weighted_, "weight or colour of a vertex", "weights or colours of vertices",
             "left out: a scene has none");
    add_loss(lost, materials_, "use of a material", "uses of materials", "left out: OBJ keeps them in another file");
    add_loss(lost, no_names_, "name of a group", "names of groups",
             "left out: expected 1 to 128 of A-Z a-z 0-9 _ . : -");
    add_loss(lost, further_names_, "further name of a group", "further names of groups",
             "left out: a triangle is in one group");
    add_loss(lost, others_, "other statement", "other statements", "left out: no vertex, no face");
    return lost;
  }

  const Source& source_;
  const std::string_view joined_;
  const std::size_t vertex_count_;  // of the whole text
  PolygonSoup soup_;
  std::size_t weighted_ = 0, materials_ = 0, others_ = 0;
  std::size_t no_names_ = 0, further_names_ = 0;  // of groups
  ObjCorners<glm::dvec2> textures_{source_, "vt", "texture coordinate"};
  ObjCorners<glm::dvec3> normals_{source_, "vn", "normal"};
  FaceGroups groups_;
  FaceGroups::Number group_{FaceGroups::none};  // of the faces that follow
};

}  // namespace

Imported read_obj(const Source& source) {
  const std::string joined = obj_joined(source.text());
  ObjLines lines(source, joined);
  std::vector<std::string> lost = lines.read();
  return mesh_scene(source, lines.soup(), std::move(lost), lines.groups(), lines.looks());
}

}  // namespace durero::io
