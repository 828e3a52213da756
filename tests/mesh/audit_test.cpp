#include "durero/mesh/audit.hpp"

#include <stdexcept>

#include "durero/model/auditoria.hpp"
#include "support/catch.hpp"
#include "support/mallas_gen.hpp"
#include "support/property.hpp"

// The audit says what model says by the definitions of the text.

using namespace durero;
using namespace durero::mesh;

namespace {

template <class Found>
std::set<model::Arista> as_set(const std::vector<Found>& edges) {
  std::set<model::Arista> all;
  for (const auto& [i, j] : edges) all.emplace(i, j);
  return all;
}

std::set<model::Ordinal> as_set(const std::vector<std::uint32_t>& numbers) { return {numbers.begin(), numbers.end()}; }

std::set<std::array<model::Ordinal, 3>> as_set(const std::vector<TJunction>& junctions) {
  std::set<std::array<model::Ordinal, 3>> all;
  for (const TJunction& each : junctions) all.insert({each.vertex, each.edge[0], each.edge[1]});
  return all;
}

std::set<std::set<model::Ordinal>> as_pieces(const std::vector<std::uint32_t>& piece_of) {
  std::map<std::uint32_t, std::set<model::Ordinal>> pieces;
  for (std::uint32_t n = 0; n < piece_of.size(); ++n) pieces[piece_of[n]].insert(n);
  std::set<std::set<model::Ordinal>> all;
  for (const auto& [least, piece] : pieces) {
    RC_ASSERT(least == *piece.begin());
    all.insert(piece);
  }
  return all;
}

MeshAudit audited(const model::Red& red) {
  std::vector<glm::dvec3> vertices;
  for (const auto& [n, p] : red.puntos()) vertices.emplace_back(p.x(), p.y(), p.z());
  std::vector<CornerNumbers> faces;
  for (const auto& [n, c] : red.caras()) faces.push_back({c.i, c.j, c.k});
  return mesh::audited(vertices, faces);
}

/// Faces of a few points of a small grid, where most of what may be wrong is often so.
model::Red crowded() {
  const auto points = *rc::gen::container<std::vector<model::Punto>>(7, test::any_grid_point());
  const auto number = rc::gen::map(rc::gen::inRange(0, 7), [](int n) { return static_cast<model::Ordinal>(n); });
  std::vector<model::Cara> faces(*rc::gen::inRange<std::size_t>(0, 9));
  for (model::Cara& face : faces) face = {*number, *number, *number};
  return model::Red::of(points, faces);
}

}  // namespace

TEST_CASE("the audit of any mesh is that of the text") {
  test::property("of crowded meshes", [] {
    const model::Red red = crowded();
    const MeshAudit audit = audited(red);
    RC_CLASSIFY(!audit.t_junctions.empty(), "with T-junctions");
    RC_CLASSIFY(!audit.repeated.empty(), "with repeated faces");
    RC_ASSERT(as_set(audit.open) == model::abiertas(red));
    RC_ASSERT(as_set(audit.multiple) == model::multiples(red));
    RC_ASSERT(as_set(audit.discordant) == model::discordes(red));
    RC_ASSERT(as_set(audit.repeated) == model::repetidas(red));
    RC_ASSERT(as_set(audit.degenerate) == model::degeneradas(red));
    RC_ASSERT(as_set(audit.t_junctions) == model::uniones_en_t(red));
    RC_ASSERT(as_pieces(audit.piece_of) == model::piezas(red));
    RC_ASSERT(audit.volume == model::volumen(red));
    RC_ASSERT(std::ranges::is_sorted(audit.open) && std::ranges::is_sorted(audit.discordant));
    RC_ASSERT(std::ranges::is_sorted(audit.t_junctions));
  });
}

TEST_CASE("a vertex beside an edge by one unit in the last place is no T-junction") {
  const std::vector<CornerNumbers> faces{{0, 1, 2}, {3, 4, 2}};
  const auto junctions = [&](double y) {
    const std::vector<glm::dvec3> vertices{{0, 0, 0}, {3, 3, 0}, {0, 0, 1}, {1, y, 0}, {1, 5, 0}};
    return mesh::audited(vertices, faces).t_junctions;
  };
  CHECK(junctions(1) == std::vector<TJunction>{{3, {0, 1}}});
  CHECK(junctions(1 + 0x1p-52).empty());
  CHECK(junctions(1 - 0x1p-53).empty());
}

TEST_CASE("every vertex on an edge is found, where many have one coordinate") {
  std::vector<glm::dvec3> vertices{{0, 0, 0}, {0, 9, 0}, {20, 0, 0}};
  std::vector<CornerNumbers> faces{{0, 1, 2}};
  std::vector<TJunction> expected;
  for (std::uint32_t n = 3; n < 11; ++n) {
    vertices.emplace_back(0, n - 2.0, 0);
    faces.push_back({n, n, 2});
    expected.push_back({n, {0, 1}});
  }
  CHECK(mesh::audited(vertices, faces).t_junctions == expected);
}

TEST_CASE("what is far or small is audited as the rest") {
  for (const double scale : {0x1p-1000, 0x1p+1000}) {
    const std::vector<glm::dvec3> vertices{{0, 0, 0}, {2 * scale, 0, 0}, {0, scale, 0}, {scale, 0, 0}, {0, 0, scale}};
    const std::vector<CornerNumbers> faces{{0, 1, 2}, {0, 1, 3}, {3, 4, 2}};
    const MeshAudit audit = mesh::audited(vertices, faces);
    CHECK(audit.degenerate == std::vector<std::uint32_t>{1});
    CHECK(audit.t_junctions == std::vector<TJunction>{{3, {0, 1}}});
  }
}

TEST_CASE("a corner that is no vertex is refused") {
  const std::vector<glm::dvec3> vertices(3);
  const std::vector<CornerNumbers> faces{{0, 1, 3}};
  CHECK_THROWS_AS(mesh::audited(vertices, faces), std::out_of_range);
}
