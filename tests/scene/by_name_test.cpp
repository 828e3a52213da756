// The elements of a scene by name: faces of meshes are among all of them, and not among those by themselves.
#include "durero/scene/by_name.hpp"

#include <string>
#include <vector>

#include "durero/model/operaciones.hpp"
#include "durero/scene/mesh_edit.hpp"
#include "support/catch.hpp"

using namespace durero;
using namespace durero::model;
using scene::MeshAddition;
using scene::MeshEdit;
using scene::Scene;

namespace {

/// Spheres `sphere` and `a`, and a mesh `m` of two faces, in this order or in the other.
Scene scene_of(bool spheres_first) {
  Scene scene;
  const auto spheres = [&] {
    scene.apply(Agregar_Esfera{Elemento("sphere"), Punto(0, 0, 9), 1});
    scene.apply(Agregar_Esfera{Elemento("a"), Punto(0, 0, 5), 1});
  };
  if (spheres_first) spheres();
  const scene::Mesh mesh{Elemento("m"), {{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}}, {{0, 1, 2}, {0, 2, 3}}};
  REQUIRE(scene.apply_total(MeshEdit(MeshAddition{mesh})).ok());
  if (!spheres_first) spheres();
  return scene;
}

std::vector<std::string> names(const Scene& scene, const std::vector<scene::ElementRef>& elements) {
  std::vector<std::string> all;
  for (const scene::ElementRef element : elements) all.push_back(scene.name(element).name());
  return all;
}

}  // namespace

TEST_CASE("elements by name ascend by the bytes of their names, whatever the order of the edits") {
  for (const bool spheres_first : {true, false}) {
    const Scene scene = scene_of(spheres_first);
    CHECK(names(scene, scene::elements_by_name(scene)) == std::vector<std::string>{"a", "m:0", "m:1", "sphere"});
    CHECK(names(scene, scene::singles_by_name(scene)) == std::vector<std::string>{"a", "sphere"});
  }
}
