#include "durero/render/bundle/beam_tree.hpp"

#include <map>
#include <stdexcept>

#include "durero/engine/engine.hpp"
#include "render/bundle/located.hpp"
#include "render/bundle/triangle_scene.hpp"
#include "support/catch.hpp"

using namespace durero;
using namespace durero::test;
using polygon::Rational;

namespace {

struct TreeOf {
  explicit TreeOf(const scene::Scene& scene, std::uint32_t max_depth = 4)
      : rays(*scene.stage().camera, *scene.stage().resolution),
        outline(render::outline_of({0, 0}, rays.resolution())),
        tree(render::beam_tree(scene, rays, outline, max_depth)) {}
  scene::PrimaryRays rays;
  polygon::Polygon outline;
  render::BeamTree tree;
};

/// The half-planes whose intersection is an outline.
std::vector<polygon::PlaneSide> around(const polygon::Polygon& outline) {
  std::vector<polygon::PlaneSide> sides;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const auto &p = outline[i], &q = outline[(i + 1) % outline.size()], &r = outline[(i + 2) % outline.size()];
    polygon::PlaneSide side{{p.y - q.y, q.x - p.x, 0}, 0};
    side.offset = polygon::dot(side.normal, p);
    sides.push_back(side.depth(r) < 0 ? polygon::opposite(side) : side);
  }
  return sides;
}

/// The first fault of the parts of one outline: a gap, an overlap, or what lies outside.
std::string fault_of(const std::vector<const render::BeamRegion*>& parts, const polygon::Polygon& whole) {
  Rational sum = 0;
  for (const auto* part : parts) {
    sum += render::area(part->outline);
    if (render::area(polygon::clipped(part->outline, around(whole))) != render::area(part->outline))
      return "a part lies outside";
  }
  if (sum != render::area(whole)) return "the areas do not add up";
  for (std::size_t i = 0; i < parts.size(); ++i)
    for (std::size_t k = 0; k < i; ++k)
      if (!polygon::clipped(parts[i]->outline, around(parts[k]->outline)).empty()) return "two parts overlap";
  return "";
}

std::string fault_of(const TreeOf& of) {
  std::map<std::uint32_t, std::vector<const render::BeamRegion*>> parts;
  for (const render::BeamRegion& region : of.tree) parts[region.parent].push_back(&region);
  for (const auto& [parent, regions] : parts) {
    const std::string fault =
        fault_of(regions, parent == render::without_parent ? of.outline : of.tree[parent].outline);
    if (!fault.empty()) return fault;
  }
  return "";
}

}  // namespace

TEST_CASE("the regions divide the picture, and the image in each mirror, without a gap or an overlap") {
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    CAPTURE(seed);
    Random random(seed);
    const TreeOf of(random_triangles(random, 5), 3);
    CHECK(of.tree.size() > 10);
    CHECK(of.tree.back().depth == 3);
    CHECK(fault_of(of) == "");
  }
}

TEST_CASE("a whole picture that meets nothing is one region of its area") {
  const TreeOf of(triangle_stage());
  REQUIRE(of.tree.size() == 1);
  CHECK(render::area(of.tree[0].outline) == 40 * 30);
  CHECK(of.tree[0].elementos.empty());
  CHECK(of.tree[0].parent == render::without_parent);
}

TEST_CASE("each pixel's ray meets what its region says, by the exact engine") {
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    Random random(100 + seed);
    const scene::Scene scene = random_triangles(random, 12);
    const TreeOf of(scene, 1);
    const auto exact = engine::find("exact")->prepare(scene);
    const std::vector<std::uint32_t> regions = render::located(of.tree, of.rays, {0, 0, {40, 30}});
    std::size_t wrong = 0, none = 0;
    for (std::uint32_t i = 0; i < regions.size(); ++i) {
      if (regions[i] == render::without_parent)
        ++none;
      else
        wrong += engine::first_hit(*exact, {of.rays.ray(i % 40, i / 40)}).elementos != of.tree[regions[i]].elementos;
    }
    CAPTURE(seed);
    CHECK(wrong == 0);
    CHECK(none == 0);
  }
}

TEST_CASE("1/t of a region is that of the exact hit") {
  Random random(7);
  const scene::Scene scene = random_triangles(random, 5);
  const TreeOf of(scene, 1);
  const auto exact = engine::find("exact")->prepare(scene);
  const std::vector<std::uint32_t> regions = render::located(of.tree, of.rays, {0, 0, {40, 30}});
  for (std::uint32_t i = 0; i < regions.size(); i += 17) {
    const render::BeamRegion& region = of.tree[regions[i]];
    if (region.elementos.empty()) continue;
    const scene::Hit hit = engine::first_hit(*exact, {of.rays.ray(i % 40, i / 40)});
    const double nearness = number::round_to_binary64(region.nearness.depth({i % 40, i / 40, 0}));
    CHECK(nearness * hit.t == Approx(1).epsilon(1e-12));
  }
}

TEST_CASE("elements of one plane are met together where they overlap, and pierce each other where they cross") {
  scene::Scene scene = triangle_stage();
  add_triangle(scene, "a", {-2, -2, 0}, {2, -2, 0}, {0, 2, 0});
  add_triangle(scene, "b", {-2, 2, 0}, {2, 2, 0}, {0, -2, 0});
  const TreeOf together(scene);
  CHECK(fault_of(together) == "");
  const auto with = [](const render::BeamTree& tree, std::size_t elements) {
    return std::ranges::count_if(tree, [&](const render::BeamRegion& r) { return r.elementos.size() == elements; });
  };
  CHECK(with(together.tree, 2) > 0);
  add_triangle(scene, "c", {-2, 0, -1}, {2, 0, -1}, {0, 0, 3});
  const TreeOf pierced(scene);
  CHECK(fault_of(pierced) == "");
  CHECK(std::ranges::any_of(pierced.tree, [](const render::BeamRegion& r) {
    return !r.elementos.empty() && r.elementos.front().index == 2;
  }));
}

TEST_CASE("a mirror shows what is before it, from the mirrored eye, and nothing of what is behind it") {
  scene::Scene scene = triangle_stage();
  add_plane(scene, "mirror", {0, 0, 2}, {0, 0, 1}, 1);
  add_triangle(scene, "behind", {-1, -1, 3}, {1, -1, 3}, {0, 1, 3});
  add_triangle(scene, "over", {-1, -1, -5}, {1, -1, -5}, {0, 1, -5});
  const TreeOf of(scene, 2);
  REQUIRE(of.tree.size() > 2);
  CHECK(of.tree[0].elementos.front().tipo == model::Tipo::soy_plano);
  std::size_t over = 0;
  for (const render::BeamRegion& region : of.tree) {
    if (region.depth == 1) continue;
    CHECK(region.parent == 0);
    if (region.elementos.empty()) continue;
    CHECK(scene.name(region.elementos.front()).name() == "over");
    ++over;
  }
  CHECK(over == 1);
  CHECK(TreeOf(scene, 1).tree.size() == 1);
}

TEST_CASE("an element that is seen edge-on has no region") {
  scene::Scene scene = triangle_stage();
  add_triangle(scene, "edge", {0.3, 0.4, 0}, {1.3, 0.4, 0}, {0.3, 1.4, 0});
  CHECK(TreeOf(scene).tree.size() > 1);
  scene::Scene flat = triangle_stage();
  add_triangle(flat, "edge", {0.3, -1, 0}, {0.3, 1, 0}, {0.3, 0, 4});  // in the plane x = 0.3, where the eye is
  CHECK(TreeOf(flat).tree.size() == 1);
}

TEST_CASE("what beams do not follow is refused by name") {
  const auto said = [](const scene::Scene& scene) {
    try {
      TreeOf of(scene);
      return std::string();
    } catch (const std::domain_error& error) {
      return std::string(error.what());
    }
  };
  scene::Scene round = triangle_stage();
  round.apply(model::Agregar_Esfera{model::Elemento("ball"), {0, 0, 0}, 1});
  CHECK(said(round).starts_with("element ball is neither a triangle nor a plane"));
  scene::Scene glass = triangle_stage();
  glass.stage().materials[0].k_t = 0.5;
  CHECK(said(glass).starts_with("material matt lets light through"));
  scene::Scene waves = triangle_stage();
  waves.stage().materials[1].bump = scene::Bump{};
  CHECK(said(waves).starts_with("material mirror is a mirror with a relief"));
  scene::Scene dull = triangle_stage();
  dull.stage().materials[1].gloss = 50;
  CHECK(said(dull).starts_with("material mirror is a dull mirror"));
}

TEST_CASE("the drawing has a polygon for each region") {
  Random random(3);
  const scene::Scene scene = random_triangles(random, 3);
  const TreeOf of(scene, 2);
  const std::string text = render::svg(of.tree, scene, {40, 30});
  std::size_t polygons = 0;
  for (std::size_t at = text.find("<polygon"); at != text.npos; at = text.find("<polygon", at + 1)) ++polygons;
  CHECK(polygons == of.tree.size());
  CHECK(text.starts_with("<svg "));
  CHECK(text.ends_with("</svg>\n"));
}
