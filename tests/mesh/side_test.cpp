#include "durero/mesh/side.hpp"

#include <stdexcept>

#include "durero/model/auditoria.hpp"
#include "support/catch.hpp"
#include "support/mallas_gen.hpp"
#include "support/property.hpp"

// The side of a point is what model says by the definitions of the text.

using namespace durero;
using namespace durero::mesh;

namespace {

std::optional<Side> side_in(const model::Red& red, const model::Punto& w) {
  std::vector<glm::dvec3> vertices;
  for (const auto& [n, p] : red.puntos()) vertices.emplace_back(p.x(), p.y(), p.z());
  std::vector<CornerNumbers> faces;
  for (const auto& [n, c] : red.caras()) faces.push_back({c.i, c.j, c.k});
  return side_of(vertices, faces, {w.x(), w.y(), w.z()});
}

std::optional<Side> side_by_text(const model::Red& red, const model::Punto& w) {
  if (model::is_in_piel(red, w)) return Side::on_surface;
  if (!model::is_even(red)) return std::nullopt;
  return model::is_enclosed(red, w) ? Side::inside : Side::outside;
}

/// Tetrahedra about seven points, flat ones too, which may overlap, and sometimes one face less.
model::Red tetrahedra(const std::vector<double>& coordinates) {
  const auto coordinate = rc::gen::elementOf(coordinates);
  std::vector<model::Punto> points;
  for (int n = 0; n < 7; ++n) {
    const double x = *coordinate, y = *coordinate, z = *coordinate;
    points.emplace_back(x, y, z);
  }
  std::vector<model::Cara> faces;
  for (int n = 0; n < 3; ++n) {
    const auto v =
        *rc::gen::unique<std::vector<model::Ordinal>>(4, rc::gen::element<model::Ordinal>(0, 1, 2, 3, 4, 5, 6));
    for (const model::Cara& face :
         {model::Cara{v[0], v[1], v[2]}, {v[0], v[1], v[3]}, {v[3], v[1], v[2]}, {v[2], v[0], v[3]}})
      faces.push_back(face);
  }
  if (*rc::gen::element(0, 0, 0, 1) == 1) faces.pop_back();
  return model::Red::of(points, faces);
}

}  // namespace

TEST_CASE("the side of any point is that of the text") {
  const auto holds = [](const std::vector<double>& corners, const std::vector<double>& coordinates) {
    const model::Red red = tetrahedra(corners);
    std::set<std::optional<Side>> sides;
    const auto coordinate = rc::gen::elementOf(coordinates);
    for (int n = 0; n < 5; ++n) {
      const double x = *coordinate, y = *coordinate, z = *coordinate;
      const std::optional<Side> side = side_in(red, {x, y, z});
      sides.insert(side);
      RC_ASSERT(side == side_by_text(red, {x, y, z}));
    }
    RC_CLASSIFY(sides.contains(Side::inside), "some inside");
    RC_CLASSIFY(sides.contains(Side::on_surface), "some on the surface");
    RC_CLASSIFY(sides.contains(std::nullopt), "of no side");
  };
  const std::vector<double> grid{0, 1, 2, 4, 7}, between{0, 1, 1.5, 2, 3, 4};
  const std::vector<double> nearly{0, 0.1, 0.2, 0.3, 0.1 + 0.2, 0.4, 0.7};
  test::property("on a grid", [&] { holds(grid, between); });
  test::property("nearly on a grid", [&] { holds(nearly, nearly); });
}

TEST_CASE("a point is inside, outside or on the surface by one unit in the last place") {
  const model::Red red =
      model::Red::of({{0, 0, 0}, {3, 0, 0}, {0, 3, 0}, {0, 0, 3}}, {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}});
  CHECK(side_in(red, {1, 1, 1}) == Side::on_surface);
  CHECK(side_in(red, {1 - 0x1p-53, 1, 1}) == Side::inside);
  CHECK(side_in(red, {1 + 0x1p-52, 1, 1}) == Side::outside);
  CHECK(side_in(red, {0, 1, 1}) == Side::on_surface);
  CHECK(side_in(red, {-0x1p-1074, 1, 1}) == Side::outside);
  CHECK(side_in(red, {0x1p-1074, 0.5, 1}) == Side::inside);
  CHECK(side_in(red, {0x1p-1074, 0x1p-1074, 0x1p-1074}) == Side::inside);
  CHECK(side_in(red, {3, 0, 0}) == Side::on_surface);
  CHECK(side_in(red, {4, 0, 0}) == Side::outside);
  CHECK(side_in(red, {-1, 0, 0}) == Side::outside);  // its ray to the right meets a corner and an edge
}

TEST_CASE("an open mesh has points, and no side") {
  const model::Red red =
      model::Red::of({{0, 0, 0}, {3, 0, 0}, {0, 3, 0}, {0, 0, 3}}, {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}});
  CHECK(side_in(red, {0.5, 0.5, 0.5}) == std::nullopt);
  CHECK(side_in(red, {1, 1, 0}) == Side::on_surface);
}

TEST_CASE("a side of faces whose corner is no vertex is refused") {
  const std::vector<glm::dvec3> vertices(3);
  const std::vector<CornerNumbers> faces{{0, 1, 3}};
  CHECK_THROWS_AS(side_of(vertices, faces, {0, 0, 0}), std::out_of_range);
}
