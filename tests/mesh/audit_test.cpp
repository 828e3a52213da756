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

std::set<std::pair<model::Ordinal, model::Ordinal>> as_set(const std::vector<CrossingFaces>& crossings) {
  std::set<std::pair<model::Ordinal, model::Ordinal>> all;
  for (const CrossingFaces& each : crossings) all.emplace(each.faces[0], each.faces[1]);
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

/// The faces of a piece alone, by the numbers of the whole; its points are all of them.
model::Red piece_alone(const model::Red& red, const std::vector<std::uint32_t>& piece_of, std::uint32_t first) {
  std::vector<model::Punto> points;
  std::vector<model::Cara> faces;
  for (const auto& [n, p] : red.puntos()) points.push_back(p);
  for (const auto& [n, c] : red.caras())
    if (piece_of[n] == first) faces.push_back(c);
  return model::Red::of(points, faces);
}

/// Each piece has the volume that the text gives its faces alone, where none of their edges is open or discordant.
void check_pieces(const model::Red& red, const MeshAudit& audit) {
  std::uint32_t faces = 0;
  for (const MeshPiece& piece : audit.pieces) {
    const model::Red alone = piece_alone(red, audit.piece_of, piece.first);
    RC_ASSERT(piece.faces == alone.caras().size());
    RC_ASSERT(piece.volume.has_value() == (model::abiertas(alone).empty() && model::discordes(alone).empty()));
    RC_CLASSIFY(piece.volume && *piece.volume != number::Rational(0), "with a piece that encloses a volume");
    if (piece.volume) RC_ASSERT(*piece.volume == model::volumen(alone));
    faces += static_cast<std::uint32_t>(piece.faces);
  }
  RC_ASSERT(faces == red.caras().size());
  RC_ASSERT(std::ranges::is_sorted(audit.pieces, {}, &MeshPiece::first));
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

/// Four faces of seven points.
model::Red four_faces(const std::vector<model::Punto>& points) {
  const auto number = rc::gen::element<model::Ordinal>(0, 1, 2, 3, 4, 5, 6);
  std::vector<model::Cara> faces(4);
  for (model::Cara& face : faces) {
    face.i = *number;
    face.j = *number;
    face.k = *number;
  }
  return model::Red::of(points, faces);
}

/// Points whose coordinates are of these few numbers.
std::vector<model::Punto> points_of(const std::vector<double>& coordinates) {
  const auto coordinate = rc::gen::elementOf(coordinates);
  std::vector<model::Punto> points;
  for (int n = 0; n < 7; ++n) {
    const double x = *coordinate, y = *coordinate, z = *coordinate;
    points.emplace_back(x, y, z);
  }
  return points;
}

/// An integer of so many bits, as many for a small test as for a large one.
double any_integer(int bits) {
  return static_cast<double>(
      *rc::gen::resize(rc::kNominalSize, rc::gen::inRange<std::int64_t>(0, std::int64_t{1} << bits)));
}

/// Faces in one upright plane, which have one edge in common, of points whose differences have more bits than a
/// binary64.
model::Red upright_faces() {
  const double x = 0x1p+47 + any_integer(47), y = 0x1p+47 + any_integer(47);
  std::vector<model::Punto> points;
  for (int n = 0; n < 7; ++n) {
    const int times = *rc::gen::element(-31, -30, -29, -28, 28, 29, 30, 31);
    points.emplace_back(times * x, times * y, any_integer(53));
  }
  return model::Red::of(points, {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}, {5, 0, 1}, {1, 6, 0}});
}

/// A face whose first corner is in the midst of an edge of another, or of its area. The products have more bits than a
/// binary64.
model::Red touching_faces() {
  std::vector<model::Punto> points;
  for (int n = 0; n < 5; ++n) {
    const double x = 4 * any_integer(50), y = 4 * any_integer(50), z = 4 * any_integer(50);
    points.emplace_back(x, y, z);
  }
  const double third = *rc::gen::element(0.0, 0.5);
  const auto mean = [&](double (model::Punto::*of)() const) {
    return ((points[0].*of)() / 2 + (points[1].*of)() / 2) * (1 - third) + (points[2].*of)() * third;
  };
  points.emplace_back(mean(&model::Punto::x), mean(&model::Punto::y), mean(&model::Punto::z));
  return model::Red::of(points, {{0, 1, 2}, {5, 3, 4}});
}

std::vector<CrossingFaces> crossings_of(const std::vector<glm::dvec3>& vertices,
                                        const std::vector<CornerNumbers>& faces) {
  return mesh::audited(vertices, faces).crossings;
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
    RC_CLASSIFY(!audit.crossings.empty(), "with crossings");
    RC_ASSERT(as_set(audit.crossings) == model::cruzadas(red));
    RC_ASSERT(std::ranges::is_sorted(audit.crossings, {}, &CrossingFaces::faces));
    std::vector<std::uint32_t> singular;
    for (const SingularVertex& each : audit.singular) singular.push_back(each.vertex);
    RC_CLASSIFY(!singular.empty(), "with singular vertices");
    RC_ASSERT(as_set(singular) == model::singulares(red));
    RC_ASSERT(std::ranges::is_sorted(singular));
    RC_ASSERT(as_pieces(audit.piece_of) == model::piezas(red));
    RC_ASSERT(audit.volume == model::volumen(red));
    check_pieces(red, audit);
    RC_ASSERT(std::ranges::is_sorted(audit.open) && std::ranges::is_sorted(audit.discordant));
    RC_ASSERT(std::ranges::is_sorted(audit.t_junctions));
  });
}

TEST_CASE("each piece has a volume of its own, if it is closed") {
  // Two tetrahedra apart, the second turned inside out, and one without its last face.
  const std::array<CornerNumbers, 4> closed{{{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}}};
  std::vector<glm::dvec3> vertices;
  std::vector<CornerNumbers> faces;
  for (std::uint32_t at = 0; at < 3; ++at) {
    for (const glm::dvec3& corner :
         {glm::dvec3(0, 0, 0), glm::dvec3(3, 0, 0), glm::dvec3(0, 3, 0), glm::dvec3(0, 0, 3)})
      vertices.push_back(corner + 10.0 * at);
    for (std::uint32_t n = 0; n < (at == 2 ? 3 : 4); ++n) {
      CornerNumbers face = closed[n];
      if (at == 1) std::swap(face[0], face[1]);
      for (std::uint32_t& corner : face) corner += 4 * at;
      faces.push_back(face);
    }
  }
  const MeshAudit audit = mesh::audited(vertices, faces);
  REQUIRE(audit.pieces.size() == 3);
  CHECK(audit.pieces[0].volume == number::Rational(9) / 2);
  CHECK(audit.pieces[1].volume == number::Rational(-9) / 2);
  CHECK(audit.pieces[1].first == 4);
  CHECK_FALSE(audit.pieces[2].volume);
  CHECK(audit.pieces[2].faces == 3);
}

TEST_CASE("the faces that cross are those of the text") {
  const auto holds = [](const model::Red& red) {
    const auto found = as_set(audited(red).crossings);
    RC_CLASSIFY(!found.empty(), "some cross");
    RC_ASSERT(found == model::cruzadas(red));
  };
  const std::vector<double> grid{0, 1, 2, 3}, nearly{0, 0.1, 0.2, 0.3, 0.1 + 0.2, 0.4, 0.5};
  const std::vector<double> far{0, 0x1p-1074, 0x1p-300, 1, 3, 0x1p+1000};
  test::property("on a grid", [&] { holds(four_faces(points_of(grid))); });
  test::property("nearly on a grid", [&] { holds(four_faces(points_of(nearly))); });
  test::property("of far and of small coordinates", [&] { holds(four_faces(points_of(far))); });
  test::property("in an upright plane", [&] { holds(upright_faces()); });
  test::property("that touch", [&] {
    for (int n = 0; n < 10; ++n) holds(touching_faces());  // a sum is off in few of them
  });
}

TEST_CASE("faces cross where they cut, touch or overlap, and the place of it is told") {
  const std::vector<glm::dvec3> vertices{{0, 0, 0}, {3, 0, 0}, {0, 3, 0},  {1, 1, -1}, {1, 1, 2},
                                         {9, 9, 1}, {1, 1, 0}, {1, 1, -9}, {-1, 5, 0}, {-1, -1, 0}};
  const CornerNumbers face{0, 1, 2};
  const auto place = [&](const CornerNumbers& other) {
    const std::vector<CrossingFaces> found = crossings_of(vertices, {face, other});
    REQUIRE(found.size() == 1);
    CHECK(found[0].faces == std::array<std::uint32_t, 2>{0, 1});
    return found[0].place;
  };
  CHECK(place({3, 4, 5}) == glm::dvec3(1, 1, 0));  // cuts
  CHECK(place({6, 4, 5}) == glm::dvec3(1, 1, 0));  // touches
  CHECK(place({6, 7, 4}) == glm::dvec3(1, 1, 0));  // is on one line
  CHECK(place({0, 4, 7}) == glm::dvec3(1, 1, 0));  // at a common corner
  CHECK(place({1, 2, 9}) == glm::dvec3(0, 0, 0));  // on one side of a common edge
  CHECK(place({1, 2, 6}) == glm::dvec3(1, 1, 0));  // within
  CHECK(crossings_of(vertices, {face, {1, 2, 5}}).empty());
  CHECK(crossings_of(vertices, {face, {2, 0, 8}}).empty());
  CHECK(crossings_of(vertices, {face, {0, 9, 7}}).empty());
  CHECK(crossings_of(vertices, {face, {2, 1, 0}}).empty());  // the same corners are those of a repeated face
}

TEST_CASE("faces that one unit in the last place parts do not cross, and their place is rounded once") {
  const std::vector<CornerNumbers> faces{{0, 1, 2}, {3, 4, 5}};
  const auto found = [&](double z) {
    return crossings_of({{0, 0, 0}, {1, 0, 3}, {0, 1, 3}, {1.0 / 3, 1.0 / 3, z}, {0.3, 0.3, 5}, {0.4, 0.3, 5}}, faces);
  };
  CHECK(found(2.0).empty());
  CHECK(found(2 - 0x1p-52).size() == 1);
  const std::vector<CrossingFaces> third =
      crossings_of({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, -1}, {1, 1, 2}, {9, 8, 2}}, faces);
  REQUIRE(third.size() == 1);
  CHECK(third[0].place == glm::dvec3(1.0 / 3, 1.0 / 3, 0));
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

TEST_CASE("a singular vertex is told with the least face of each fan") {
  const std::vector<glm::dvec3> vertices(8);
  const std::vector<CornerNumbers> faces{{0, 1, 2}, {3, 4, 0}, {5, 0, 6}, {2, 3, 0}, {6, 0, 7}, {7, 7, 7}};
  const std::vector<SingularVertex> found = mesh::audited(vertices, faces).singular;
  REQUIRE(found.size() == 2);
  CHECK(found[0].vertex == 0);
  CHECK(found[0].fans == std::vector<std::uint32_t>{0, 2});
  CHECK(found[1].vertex == 7);
  CHECK(found[1].fans == std::vector<std::uint32_t>{4, 5});
}

TEST_CASE("every vertex on an edge is found, where many stand above one another") {
  std::vector<glm::dvec3> vertices{{0, 0, 0}};
  std::vector<CornerNumbers> faces;
  std::vector<TJunction> expected;
  for (std::uint32_t n = 1; n < 60; n += 2) {
    vertices.emplace_back(1000, n, 0);
    vertices.emplace_back(2000, 2.0 * n, 0);
    faces.push_back({0, n, n + 1});
    expected.push_back({n, {0, n + 1}});
  }
  CHECK(mesh::audited(vertices, faces).t_junctions == expected);
}

TEST_CASE("every vertex on an edge is found whose ends are farther apart than any number") {
  const double far = 0x1.8p+1023;
  std::vector<glm::dvec3> vertices{{-1, -far, 0}, {1, far, 0}, {-1, far, 0}, {1, -far, 0}, {0, 0, 9}};
  std::vector<CornerNumbers> faces{{0, 1, 4}, {2, 3, 4}};
  for (std::uint32_t n = 5; n < 36; ++n) {
    for (const double y : {-far / 2, 0.0, far / 2}) vertices.emplace_back((n - 20.0) / 16, y, 0);
    faces.push_back({3 * n - 10, 3 * n - 9, 3 * n - 8});
  }
  const std::vector<TJunction> found = mesh::audited(vertices, faces).t_junctions;
  for (const TJunction& each :
       {TJunction{26, {0, 1}}, {51, {0, 1}}, {76, {0, 1}}, {28, {2, 3}}, {51, {2, 3}}, {74, {2, 3}}})
    CHECK(std::ranges::count(found, each) == 1);
}

TEST_CASE("every vertex on a long edge is found, however it lies") {
  test::property("of edges with 16 vertices side by side, among others", [] {
    const double scale = *rc::gen::element(1.0, 0x1p-1074, 0x1p+970);
    const auto step = [] { return *rc::gen::element(-7.0, -3.0, -1.0, 0.0, 1.0, 2.0, 5.0); };
    const double x = step(), y = step(), before = any_integer(50);
    const glm::dvec3 from(any_integer(9), any_integer(9), any_integer(9)), way(x, y, 1 + any_integer(2));
    std::vector<glm::dvec3> vertices{from * scale, (from + 0x1p+50 * way) * scale, {0, 0, 0}};
    std::vector<CornerNumbers> faces{{0, 1, 2}};
    for (std::uint32_t n = 3; n < 35; n += 2) {
      vertices.push_back((from + (before + n) * way) * scale);
      vertices.push_back((from + (before + n + 1) * way + glm::dvec3(any_integer(3), 0, 1)) * scale);
      faces.push_back({n, n + 1, 2});
    }
    const std::vector<TJunction> found = mesh::audited(vertices, faces).t_junctions;
    for (std::uint32_t n = 3; n < 35; n += 2) RC_ASSERT(std::ranges::count(found, TJunction{n, {0, 1}}) == 1);
  });
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
