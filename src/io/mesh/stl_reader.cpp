#include <fmt/format.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <optional>

#include "durero/io/mesh/stl.hpp"
#include "durero/io/number_text.hpp"
#include "durero/text/shown.hpp"
#include "io/byte_order.hpp"
#include "io/cursor.hpp"
#include "io/losses.hpp"
#include "mesh_scene.hpp"

namespace durero::io {
namespace {

/// The mesh of a file of either kind.
struct StlMesh {
  PolygonSoup soup;
  FaceGroups groups;
  std::size_t normals = 0, attributes = 0, unfit_names = 0;  ///< that no scene keeps

  void add_facet(const std::array<glm::dvec3, 3>& vertices) {
    Face face;
    for (const glm::dvec3& vertex : vertices) {
      face.push_back(static_cast<std::int64_t>(soup.vertices.size()));
      soup.vertices.push_back(vertex);
    }
    soup.faces.push_back(std::move(face));
  }

  std::vector<std::string> losses() const {
    std::vector<std::string> lost;
    add_loss(lost, normals, "normal of a facet", "normals of facets",
             "left out: a triangle's follows from its vertices");
    add_loss(lost, attributes, "attribute of a facet", "attributes of facets", "left out: a scene has none");
    add_loss(lost, unfit_names, "name of a solid", "names of solids",
             "left out: expected 1 to 128 of A-Z a-z 0-9 _ . : -");
    return lost;
  }
};

/// The bytes of a binary file: a header, the number of facets, and the facets.
class StlBytes {
 public:
  explicit StlBytes(const Source& source) : source_(source), bytes_(source.text()) {}

  /// Whether the file is as long as its number of facets says.
  bool fits() const { return bytes_.size() >= head && bytes_.size() == head + facet_size * count(); }

  StlMesh read() const {
    StlMesh mesh;
    for (std::size_t n = 0; n < count(); ++n) {
      const std::size_t at = head + facet_size * n;
      mesh.normals += vector(at, n) != glm::dvec3(0);
      mesh.add_facet({vector(at + 12, n), vector(at + 24, n), vector(at + 36, n)});
      mesh.attributes += number(at + 48, 2) != 0;
    }
    return mesh;
  }

 private:
  static constexpr std::size_t title = 80, head = title + 4, facet_size = 50;

  std::size_t count() const { return number(title, 4); }
  /// A whole number of four bytes at most.
  std::uint32_t number(std::size_t at, std::size_t size) const {
    return static_cast<std::uint32_t>(little_endian(bytes_.substr(at, size)));
  }
  glm::dvec3 vector(std::size_t at, std::size_t facet) const {
    glm::dvec3 vector;
    for (int i = 0; i < 3; ++i) {
      const auto x = std::bit_cast<float>(number(at + 4 * static_cast<std::size_t>(i), 4));
      if (!std::isfinite(x))
        source_.fail(0, fmt::format("facet {}, counted from 1, has a number that is not finite", facet + 1),
                     "expected three finite numbers of its normal and of each vertex");
      vector[i] = static_cast<double>(x);
    }
    return vector;
  }

  const Source& source_;
  std::string_view bytes_;
};

/// The words of a text, which may stand on any lines; a solid's name goes to the end of its line.
class StlText {
 public:
  explicit StlText(const Source& source) : source_(source), lines_(source.text()) {}

  StlMesh read() {
    std::string_view word = next();
    if (!is(word, "solid"))
      fail(word, "expected solid, or a binary file: 80 bytes, a number n, and 50 bytes for each of n facets");
    for (; is(word, "solid"); word = next()) read_solid();
    if (!word.empty()) fail(word, "expected solid, or the end");
    if (mesh_.soup.faces.empty()) source_.fail(source_.text().size(), "no mesh", "expected facets");
    return std::move(mesh_);
  }

 private:
  void read_solid() {
    const std::string name(rest_of_line());
    FaceGroups::Number group = FaceGroups::none;
    if (model::Elemento::is_name(name)) {
      group = mesh_.groups.group(name);
    } else {
      mesh_.unfit_names += !name.empty();
    }
    for (std::string_view word = next(); !is(word, "endsolid"); word = next()) {
      if (!is(word, "facet")) fail(word, "expected facet or endsolid");
      read_facet();
      mesh_.groups.of_face.push_back(group);
    }
    rest_of_line();
  }

  void read_facet() {
    expect("normal");
    mesh_.normals += vector("normal") != glm::dvec3(0);
    expect("outer"), expect("loop");
    std::array<glm::dvec3, 3> vertices;
    for (glm::dvec3& vertex : vertices) expect("vertex"), vertex = vector("vertex");
    expect("endloop"), expect("endfacet");
    mesh_.add_facet(vertices);
  }

  glm::dvec3 vector(std::string_view what) {
    glm::dvec3 vector;
    for (int i = 0; i < 3; ++i) {
      const std::string_view word = next();
      const auto value = read_decimal(word);
      if (!value)
        source_.fail(at_, fmt::format("{} in {}", text::shown(word), what), "expected a finite decimal number");
      vector[i] = *value;
    }
    return vector;
  }

  /// The next word; empty behind the last.
  std::string_view next() {
    while (!cursor_ || cursor_->offset() == line_.end) {
      const auto line = lines_.next();
      at_ = source_.text().size();
      if (!line) return {};
      cursor_.emplace(source_, line_ = *line);
    }
    at_ = cursor_->offset();
    const std::string_view word = cursor_->word("");
    cursor_->skip_blanks();
    return word;
  }
  /// The rest of the last word's line, without blanks at the end.
  std::string_view rest_of_line() {
    const std::size_t begin = cursor_->offset();
    cursor_.reset();
    const std::string_view rest = source_.text().substr(begin, line_.end - begin);
    return rest.substr(0, rest.find_last_not_of(" \t\v\f") + 1);
  }

  /// Whether a word is that one, in letters of either case.
  static bool is(std::string_view word, std::string_view expected) {
    return std::ranges::equal(word, expected, {}, [](char c) { return 'A' <= c && c <= 'Z' ? char(c + 32) : c; });
  }
  void expect(std::string_view expected) {
    const std::string_view word = next();
    if (!is(word, expected)) fail(word, fmt::format("expected {}", expected));
  }
  [[noreturn]] void fail(std::string_view word, const std::string& expected) const {
    source_.fail(at_, word.empty() ? "the text ends" : fmt::format("{} stands here", text::shown(word)), expected);
  }

  const Source& source_;
  Lines lines_;
  TextLine line_{};
  std::optional<WordCursor> cursor_;
  std::size_t at_ = 0;  // where the last word stands
  StlMesh mesh_;
};

}  // namespace

Imported read_stl(const Source& source) {
  const StlBytes bytes(source);
  const StlMesh mesh = bytes.fits() ? bytes.read() : StlText(source).read();
  return mesh_scene(source, mesh.soup, mesh.losses(), mesh.groups);
}

}  // namespace durero::io
