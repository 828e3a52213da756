// Rays from inside closed meshes at vertices, at edges and at faces. All coordinates lie on a grid, so that each ray
// meets its target exactly at t = 1, and the faces that it meets first are those around the target: the answers are
// known without any engine. No ray leaves a closed mesh.
#include <boost/container/vector.hpp>
#include <cmath>
#include <glm/geometric.hpp>
#include <map>

#include "durero/engine/engine.hpp"
#include "support/catch.hpp"
#include "support/sanitized.hpp"
#include "support/scenes.hpp"
#include "support/shapes.hpp"

using namespace durero;
using namespace durero::test;

namespace {

using Face = std::array<std::size_t, 3>;

/// A closed mesh around the origin, which sees every point of it; its coordinates are multiples of 2⁻²² of at most 1.
struct ClosedMesh {
  std::vector<glm::dvec3> vertices;
  std::vector<Face> faces;
};

double on_grid(double x) { return std::round(x * 0x1p22) * 0x1p-22; }
glm::dvec3 on_grid(const glm::dvec3& x) { return {on_grid(x.x), on_grid(x.y), on_grid(x.z)}; }

/// The mesh with each face cut into four; `moved` says where a midpoint of an edge goes.
template <class Moved>
ClosedMesh cut_in_four(const ClosedMesh& mesh, Moved moved) {
  ClosedMesh finer{mesh.vertices, {}};
  std::map<std::pair<std::size_t, std::size_t>, std::size_t> middles;
  const auto middle = [&](std::size_t a, std::size_t b) {
    const auto [place, is_new] = middles.try_emplace(std::minmax(a, b), finer.vertices.size());
    if (is_new) finer.vertices.push_back(on_grid(moved((mesh.vertices[a] + mesh.vertices[b]) / 2.0)));
    return place->second;
  };
  for (const auto& [a, b, c] : mesh.faces) {
    const std::size_t ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
    for (const Face& face : {Face{a, ab, ca}, Face{ab, b, bc}, Face{ca, bc, c}, Face{ab, bc, ca}})
      finer.faces.push_back(face);
  }
  return finer;
}

ClosedMesh octahedron() {
  return {{{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}},
          {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}}};
}

/// A ball of 8·4^cuts faces.
ClosedMesh ball(int cuts) {
  ClosedMesh mesh = octahedron();
  for (int i = 0; i < cuts; ++i) mesh = cut_in_four(mesh, [](const glm::dvec3& x) { return glm::normalize(x); });
  return mesh;
}

/// An octahedron whose faces are cut within their planes: many coplanar faces.
ClosedMesh coplanar(int cuts) {
  ClosedMesh mesh = octahedron();
  for (int i = 0; i < cuts; ++i) mesh = cut_in_four(mesh, [](const glm::dvec3& x) { return x; });
  return mesh;
}

/// The mesh, flat along z: its faces near the equator are slivers. Scaling by a power of two keeps the grid's steps.
ClosedMesh flattened(ClosedMesh mesh, double scale) {
  for (glm::dvec3& vertex : mesh.vertices) vertex.z *= scale;
  return mesh;
}

/// The same points and faces, with each coordinate moved off binary32 by a power of two below its last place.
ClosedMesh of_binary64(ClosedMesh mesh) {
  for (glm::dvec3& vertex : mesh.vertices) vertex += glm::dvec3(0x1p-30, 0x1p-31, 0x1p-32);
  return mesh;
}

/// A ray, and the faces that it meets first.
struct KnownRay {
  scene::Query query;
  std::vector<std::size_t> faces;
  glm::dvec3 target;
};

/// The mesh as a scene, and rays with known answers.
class Attack {
 public:
  explicit Attack(const ClosedMesh& mesh, double height = 1)
      : mesh_(mesh), height_(height), around_(mesh.vertices.size()) {
    for (std::size_t n = 0; n < mesh.faces.size(); ++n) {
      const auto& [a, b, c] = mesh.faces[n];
      elements_.push_back(
          add(scene_, scene::Triangle{std::array{mesh.vertices[a], mesh.vertices[b], mesh.vertices[c]}}));
      for (const std::size_t vertex : mesh.faces[n]) around_[vertex].push_back(n);
    }
  }
  const scene::Scene& scene() const { return scene_; }

  KnownRay some_ray(Random& random) const {
    const std::size_t n = random.below(mesh_.faces.size());
    const Face& face = mesh_.faces[n];
    const std::size_t corner = random.below(3);
    const std::size_t a = face[corner], b = face[(corner + 1) % 3], c = face[(corner + 2) % 3];
    const glm::dvec3 &A = mesh_.vertices[a], &B = mesh_.vertices[b], &C = mesh_.vertices[c];
    glm::dvec3 target;
    std::vector<std::size_t> faces;
    switch (random.below(3)) {
      case 0:
        target = A, faces = around_[a];
        break;
      case 1:
        target = (A + B) / 2.0;
        std::ranges::set_intersection(around_[a], around_[b], std::back_inserter(faces));
        break;
      default:
        target = (A + B) / 4.0 + C / 2.0, faces = {n};
    }
    const glm::dvec3 from = on_grid(random.in_cube(0.2)) * glm::dvec3(1, 1, height_);
    return {{ray(from, target - from)}, faces, target};
  }
  /// Whether a hit is the known one, number for number.
  bool is_right(const KnownRay& known, const scene::Hit& hit) const {
    scene::ElementSet elements;
    for (const std::size_t n : known.faces) elements.push_back(elements_[n]);
    return hit.resultado == model::Resultado::hit && hit.t == 1 && hit.punto == known.target &&
           hit.elementos == elements;
  }

 private:
  const ClosedMesh& mesh_;
  double height_;
  scene::Scene scene_;
  std::vector<scene::ElementRef> elements_;
  std::vector<std::vector<std::size_t>> around_;
};

/// So many rays, in parts that fit the memory, each part in the order of its targets and at random.
void attack(const engine::Engine& engine, const Attack& attack, std::size_t rays, std::uint64_t seed) {
  Random random(seed);
  constexpr std::size_t at_once = 100000;
  for (std::size_t done = 0; done < rays; done += at_once) {
    std::vector<KnownRay> known;
    std::vector<scene::Query> queries, segments;
    while (known.size() < std::min(at_once, rays - done)) known.push_back(attack.some_ray(random));
    if (done / at_once % 2 == 0)
      std::ranges::sort(known, {}, [](const KnownRay& each) { return std::pair(each.target.x, each.target.y); });
    for (const KnownRay& each : known) {
      queries.push_back(each.query);
      const glm::dvec3 &p = each.query.rayo.p().xyz(), &v = each.query.rayo.v().xyz();
      segments.push_back(queries.size() % 2 == 0 ? each.query : scene::Query{ray(p, 2.0 * v)});
    }
    const std::vector<scene::Hit> hits = engine::first_hits(engine, queries);
    boost::container::vector<bool> occluded(segments.size());
    engine.occluded_segments(segments, {occluded.data(), occluded.size()});
    std::size_t wrong = 0, wrongly_occluded = 0;
    for (std::size_t i = 0; i < known.size(); ++i) {
      wrong += !attack.is_right(known[i], hits[i]);
      wrongly_occluded += occluded[i] != (i % 2 == 0);
    }
    INFO("seed " << seed << ", rays from " << done);
    CHECK(wrong == 0);
    CHECK(wrongly_occluded == 0);
  }
}

/// Each of these meshes, of some 8·4^cuts faces, by the engine of a name.
void attack_all(std::string_view name, int cuts, std::size_t rays) {
  const ClosedMesh round = ball(cuts), flat = flattened(round, 0x1p-10), folded = coplanar(cuts),
                   wide = of_binary64(round);
  std::uint64_t seed = 0;
  for (const auto& [mesh, height] :
       {std::pair(&round, 1.0), std::pair(&flat, 0x1p-10), std::pair(&folded, 1.0), std::pair(&wide, 1.0)}) {
    const Attack made(*mesh, height);
    INFO(name << ", mesh " << seed << " of " << mesh->faces.size() << " faces");
    attack(*engine::find(name)->prepare(made.scene()), made, rays, ++seed);
  }
}

}  // namespace

TEST_CASE("no ray leaves a closed mesh, and each hits the faces around its target, by every engine") {
  for (const engine::EngineRow& row : engine::engines())
    if (row.exact_bytes) attack_all(row.name, 2, fewer_when_sanitized(row.name == "exact" ? 100 : 1000));
}

TEST_CASE("the fast engine hits what it is aimed at in a mesh of thousands of faces") {
  attack_all("fast", 5, fewer_when_sanitized(50000));
}

TEST_CASE("the fast engine hits what it is aimed at, ten million times", "[long]") {
  attack_all("fast", 4, 1'000'000);
  attack_all("fast", 6, 1'000'000);
  attack_all("fast", 8, 600'000);
}
