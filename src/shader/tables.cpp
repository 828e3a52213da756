#include "tables.hpp"

#include <fmt/ranges.h>

#include <array>
#include <glm/geometric.hpp>
#include <map>
#include <string_view>
#include <vector>

#include "durero/number/rational.hpp"

namespace durero::shader {
namespace {

using number::Rational;

/// e × f, each component rounded twice: exact up to binary64, however slender the triangle of e and f is.
glm::dvec3 normal_of(const scene::Triangle& t) {
  const auto difference = [&](std::size_t to, std::size_t from, int i) {
    return Rational(t.vertices[to][i]) - Rational(t.vertices[from][i]);
  };
  const auto component = [&](int i, int j) {
    return static_cast<double>(
        Rational(difference(1, 0, i) * difference(2, 0, j) - difference(1, 0, j) * difference(2, 0, i)));
  };
  return {component(1, 2), component(2, 0), component(0, 1)};
}

/// The arrays of a shader's elements: rows are added in step.
class ElementTables {
 public:
  void add(const scene::Sphere& s) { row("SPHERES", {{"vec4 SPHERE", numbers(s.centro, s.radio)}}); }
  void add(const scene::Cylinder& c) { add_round(c, 0, 0, c.radio * c.radio); }
  void add(const scene::Cone& c) { add_round(c, c.altura, c.proporcion * c.proporcion, 0); }
  void add(const scene::TruncatedCone& c) {
    add_round(c, c.altura + c.radio / c.proporcion, c.proporcion * c.proporcion, 0);
  }
  void add(const scene::Plane& p) {
    row("PLANES", {{"vec3 PLANE_AT", numbers(p.centro)}, {"vec3 PLANE_NORMAL", numbers(p.vector)}});
  }
  void add(const scene::Disc& d) {
    row("DISCS", {{"vec4 DISC", numbers(d.centro, d.radio)}, {"vec3 DISC_NORMAL", numbers(d.vector)}});
  }
  void add(const scene::Triangle& t) {
    const auto& [a, b, c] = t.vertices;
    row("TRIANGLES", {{"vec3 CORNER_A", numbers(a)},
                      {"vec3 CORNER_B", numbers(b)},
                      {"vec3 CORNER_C", numbers(c)},
                      {"vec3 EDGE_A", numbers(b - a)},
                      {"vec3 EDGE_B", numbers(c - b)},
                      {"vec3 EDGE_C", numbers(a - c)},
                      {"vec3 TRIANGLE_NORMAL", numbers(normal_of(t))}});
  }

  /// The numbers of the kinds, and the arrays.
  std::string text() const {
    std::string text;
    for (const std::string_view kind : {"SPHERES", "ROUNDS", "PLANES", "DISCS", "TRIANGLES"}) {
      const auto found = counts_.find(kind);
      text += fmt::format("#define {} {}\n", kind, found == counts_.end() ? 0 : found->second);
    }
    text +=
        "const int FIRST_PLANE = SPHERES + ROUNDS, FIRST_DISC = FIRST_PLANE + PLANES, "
        "FIRST_TRIANGLE = FIRST_DISC + DISCS;\n";
    for (const auto& [name, rows] : arrays_)
      text += array(name.substr(0, name.find(' ')), name.substr(name.find(' ') + 1), rows);
    return text;
  }

 private:
  /// A cylinder, or a cone by the advance of its apex and the square of its slope.
  template <class Shape>
  void add_round(const Shape& c, double apex, double slope, double square) {
    row("ROUNDS", {{"vec4 ROUND_BASE", numbers(c.centro, c.altura)},
                   {"vec4 ROUND_AXIS", numbers(c.vector, apex)},
                   {"vec2 ROUND_FORM", numbers(glm::dvec2(slope, square))}});
  }

  void row(std::string_view kind, std::initializer_list<std::pair<std::string_view, std::string>> entries) {
    ++counts_[kind];
    for (const auto& [name, entry] : entries) arrays_[name].push_back(entry);
  }

  std::map<std::string_view, int> counts_;
  std::map<std::string_view, std::vector<std::string>> arrays_;
};

}  // namespace

std::string array(std::string_view type, std::string_view name, const std::vector<std::string>& entries) {
  return fmt::format("const {0} {1}[{2}] = {0}[{2}](\n    {3});\n", type, name, entries.size(),
                     fmt::join(entries, ",\n    "));
}

std::string element_tables(const scene::Scene& scene) {
  ElementTables tables;
  scene.for_each([&](scene::ElementRef, const auto& shape) { tables.add(shape); });
  return tables.text();
}

}  // namespace durero::shader
