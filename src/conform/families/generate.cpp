#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>

#include "conform/families/family_table.hpp"
#include "durero/conform/families/families.hpp"
#include "durero/contract/contract.hpp"
#include "durero/model/operaciones.hpp"
#include "durero/scene/mesh_edit.hpp"

namespace durero::conform {
namespace {

using recipes::FramedShapes;

/// The seed of the random stream that each pair of family and seed has for itself.
std::uint64_t seed_of(const Family& family, std::uint64_t seed) {
  std::uint64_t hash = 0xcbf29ce484222325;  // FNV-1a
  for (const char c : family.name) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3;
  return hash ^ (seed * 0x9e3779b97f4a7c15);
}

/// A solid under construction: the place of an element with an axis, and the places of the discs that close it.
struct FramedSolid {
  std::size_t wall;
  std::vector<std::size_t> discs;
};

/// A scene under construction: its elements and their names.
struct FramedScene {
  FramedShapes shapes;  ///< the elements of the recipe, then the discs that close them
  std::vector<std::string> names{};
  std::vector<FramedSolid> solids{};
  std::size_t of_recipe = 0;  ///< the number of elements of the recipe
};

bool is_same_disc(const FramedShape& a, const FramedShape& b) {
  return a.tipo == model::Tipo::soy_disco && b.tipo == a.tipo && a.centro == b.centro && a.radio == b.radio &&
         (a.d == b.d || a.d == -b.d);
}

/// Whether the shape is a disc that closes a solid.
bool closes(const FramedScene& scene, std::size_t place) {
  return std::any_of(scene.solids.begin(), scene.solids.end(), [&](const FramedSolid& solid) {
    return std::find(solid.discs.begin(), solid.discs.end(), place) != solid.discs.end();
  });
}

/// The place of the disc in the scene, to which it is added unless the recipe has it already. A disc that closes
/// another solid is not shared: two solids that end in one place have a disc each, for a point there belongs to both.
std::size_t placed(FramedScene& scene, const FramedShape& disc, const std::string& name) {
  for (std::size_t i = 0; i < scene.shapes.size(); ++i) {
    if (is_same_disc(scene.shapes[i], disc) && !closes(scene, i)) return i;
  }
  scene.shapes.push_back(disc);
  scene.names.push_back(name);
  return scene.shapes.size() - 1;
}

/// Adds discs for every element with an axis; false where one of them is not valid. The discs are of binary64 in either
/// format: no system is told of them, since it closes a solid itself, and a disc of binary32 numbers could lie beside
/// the solid's end by more than a system may be off.
bool close(FramedScene& scene) {
  for (std::size_t i = 0, count = scene.shapes.size(); i < count; ++i) {
    const FramedShape wall = scene.shapes[i];
    if (!is_axial(wall.tipo)) continue;
    FramedSolid solid{i, {}};
    for (const bool at_base : {true, false}) {
      if (!at_base && has_apex(wall.tipo)) continue;
      const FramedShape disc = closing_disc(wall, at_base);
      if (!(disc.radio > 0) || !std::isfinite(disc.radio)) return false;
      solid.discs.push_back(placed(scene, disc, scene.names[i] + (at_base ? ".base" : ".top")));
    }
    scene.solids.push_back(solid);
  }
  return true;
}

/// Whether every shape, except discs that close solids, is of the types asked for.
bool is_allowed(const Draws& random, const FramedScene& scene) {
  for (std::size_t i = 0; i < scene.shapes.size(); ++i) {
    if (!random.allows(scene.shapes[i].tipo) && !closes(scene, i)) return false;
  }
  return true;
}

/// The shapes as elements in numbers of the format; nothing where these are not valid, or not of the types asked for.
std::optional<FramedScene> framed_scene(const Draws& random, const FramedShapes& shapes) {
  FramedScene scene;
  for (const FramedShape& shape : shapes) {
    const auto element = in_format(random, shape);
    if (!element) return std::nullopt;
    scene.names.push_back("e" + std::to_string(scene.shapes.size()));
    scene.shapes.push_back(*element);
  }
  scene.of_recipe = scene.shapes.size();
  if (random.options().caps == Caps::solid && !close(scene)) return std::nullopt;
  if (!is_allowed(random, scene)) return std::nullopt;
  return scene;
}

/// A scene of the recipe that is allowed; nothing where there is none. Scenes are drawn until one is allowed. Where
/// some are, more than one in ten is, and so a long series without one shows that there is none.
std::optional<FramedScene> drawn_scene(Draws& random, const Recipe& recipe, int parameter) {
  constexpr int attempts = 500;
  for (int i = 0; i < attempts; ++i) {
    if (auto scene = framed_scene(random, recipe.scene(random, parameter))) return scene;
  }
  return std::nullopt;
}

DrawnRay rounded(const Draws& random, DrawnRay ray) {
  ray.p = random.rounded(ray.p);
  ray.v = random.rounded(ray.v);
  return ray;
}

bool is_ray(const DrawnRay& ray) {
  const auto finite = [](const glm::dvec3& x) {
    return std::isfinite(x.x) && std::isfinite(x.y) && std::isfinite(x.z);
  };
  return finite(ray.p) && finite(ray.v) && ray.v != glm::dvec3(0);
}

DrawnRay drawn_ray(Draws& random, const Recipe& recipe, int parameter, const FramedScene& scene) {
  if (scene.solids.empty() || !random.chance(1, 3))
    return recipe.ray(random, parameter, recipes::ShapeSpan(scene.shapes).first(scene.of_recipe));
  const FramedSolid& solid = random.any_of(scene.solids);
  FramedShapes shapes{scene.shapes[solid.wall]};
  for (const std::size_t disc : solid.discs) shapes.push_back(scene.shapes[disc]);
  return recipes::solid(random, shapes);
}

/// Adds the elements in ascending order of their names, as a scene file lists them: a reader of the file has every
/// element in the same place.
void add_by_name(scene::Scene& scene, const FramedScene& framed) {
  std::vector<std::size_t> order(framed.shapes.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(),
            [&](std::size_t i, std::size_t j) { return framed.names[i] < framed.names[j]; });
  for (const std::size_t i : order) scene.apply(framed.shapes[i].addition(model::Elemento(framed.names[i])));
}

/// The mesh in numbers of the format, without faces whose vertices these put on one line.
scene::Mesh mesh_in_format(const Draws& random, const DrawnMesh& drawn) {
  scene::Mesh mesh{.m = model::Elemento("m"), .caras = drawn.faces};
  for (const glm::dvec3& point : drawn.points) mesh.puntos.push_back(random.rounded(point));
  std::erase_if(mesh.caras, [&](const model::Cara& face) {
    return !are_corners({mesh.puntos[face.i], mesh.puntos[face.j], mesh.puntos[face.k]});
  });
  return mesh;
}

/// Draws rays until there are so many; element(place) is that of a place of the recipe.
template <class Draw, class Element>
void draw_rays(const Draws& random, std::vector<scene::Query>& queries, std::size_t rays, Draw draw, Element element) {
  while (queries.size() < rays) {
    const DrawnRay ray = rounded(random, draw());
    if (!is_ray(ray)) continue;
    scene::Query& query = queries.emplace_back(scene::Query{{model::Punto(ray.p), model::Vector(ray.v)}, {}});
    for (const std::size_t place : ray.on) query.en.push_back(element(place));
    std::sort(query.en.begin(), query.en.end());
  }
}

bool allows_mesh(const Draws& random, const MeshRecipe& recipe) {
  return random.allows(model::Tipo::soy_triangulo) || (recipe.is_grid && random.asks_grids());
}

std::optional<DrawnCase> generate_mesh(const MeshRecipe& recipe, Draws& random, DrawnCase drawn, std::size_t rays) {
  if (!allows_mesh(random, recipe)) return std::nullopt;
  const DrawnMesh mesh = recipe.mesh(random, drawn.parameter, random.options().faces);
  drawn.the_case.scene.apply_total(scene::MeshAddition{mesh_in_format(random, mesh)});
  const auto draw = [&] { return recipe.ray(random, drawn.parameter, mesh); };
  draw_rays(random, drawn.the_case.rays, rays, draw, [](std::size_t) -> scene::ElementRef { contract::unreachable(); });
  return drawn;
}

/// Names of bodies of one digit are in ascending order, as a scene file lists them.
std::optional<DrawnCase> generate_bodies(const BodyRecipe& recipe, Draws& random, DrawnCase drawn, std::size_t rays) {
  if (!random.allows_bodies()) return std::nullopt;
  const std::vector<AskedBody> bodies = recipe.scene(random, drawn.parameter);
  scene::Scene& scene = drawn.the_case.scene;
  for (const AskedBody& body : bodies) {
    const model::Elemento name("e" + std::to_string(drawn.bodies.size()));
    if (!add_body(scene, name, body)) contract::unreachable();
    drawn.bodies.push_back({scene.find(name.name()).value(), body});
  }
  const auto draw = [&] { return recipe.ray(random, drawn.parameter, bodies); };
  draw_rays(random, drawn.the_case.rays, rays, draw, [](std::size_t) -> scene::ElementRef { contract::unreachable(); });
  return drawn;
}

}  // namespace

std::optional<DrawnCase> generate(const Family& family, std::uint64_t seed, std::size_t rays,
                                  const CaseOptions& options) {
  const FamilyRow& row = row_of(family);
  const Range range = conform::parameter(family, options.numbers);
  Draws random(seed_of(family, seed), options);
  DrawnCase drawn{{}, random.integer(range.least, range.greatest)};
  if (const auto* of_mesh = std::get_if<MeshRecipe>(&row.recipe)) return generate_mesh(*of_mesh, random, drawn, rays);
  if (const auto* of_bodies = std::get_if<BodyRecipe>(&row.recipe))
    return generate_bodies(*of_bodies, random, drawn, rays);
  const Recipe& recipe = std::get<Recipe>(row.recipe);
  const std::optional<FramedScene> framed = drawn_scene(random, recipe, drawn.parameter);
  if (!framed) return std::nullopt;
  auto& [scene, queries] = drawn.the_case;
  add_by_name(scene, *framed);
  const auto element = [&](std::size_t place) { return *scene.find(framed->names[place]); };
  for (const FramedSolid& of : framed->solids) {
    Solid& solid = drawn.solids.emplace_back(Solid{element(of.wall), {}});
    for (const std::size_t disc : of.discs) solid.discs.push_back(element(disc));
  }
  draw_rays(
      random, queries, rays, [&] { return drawn_ray(random, recipe, drawn.parameter, *framed); }, element);
  return drawn;
}

bool asks_grids(const std::vector<model::Tipo>& tipos, const std::vector<BodyKind>& kinds) {
  return std::ranges::find(kinds, BodyKind::campo) != kinds.end() &&
         std::ranges::find(tipos, model::Tipo::soy_triangulo) == tipos.end();
}

bool has_scenes(const Family& family, std::uint64_t seed, const CaseOptions& options) {
  const auto* const of_mesh = std::get_if<MeshRecipe>(&row_of(family).recipe);
  return of_mesh ? allows_mesh(Draws(seed, options), *of_mesh) : generate(family, seed, 0, options).has_value();
}

Case generate(const Family& family, std::uint64_t seed, std::size_t rays) {
  return generate(family, seed, rays, {})->the_case;
}

}  // namespace durero::conform
