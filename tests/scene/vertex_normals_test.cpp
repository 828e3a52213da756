#include "durero/scene/vertex_normals.hpp"

#include <limits>
#include <stdexcept>

#include "durero/model/operaciones.hpp"
#include "durero/scene/scene.hpp"
#include "support/catch.hpp"

using namespace durero;

namespace {

scene::Scene two_triangles() {
  scene::Scene scene;
  for (const char* name : {"first", "second"})
    scene.apply(model::Agregar_Triangulo{model::Elemento(name), {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}});
  return scene;
}

const scene::VertexNormals normals{{{0, 0, 1}, {0.5, 0, 2}, {0, -1, 1}}};

}  // namespace

TEST_CASE("a triangle keeps the normals of its vertices beside its texture, and while others come and go") {
  scene::Scene scene = two_triangles();
  const scene::Wrap wrap{{{{0, 1}, {2, 3}, {4, 5}}}};
  scene.set_vertex_normals(*scene.find("second"), normals);
  CHECK_FALSE(scene.wrap(*scene.find("second")));
  scene.set_wrap(*scene.find("second"), wrap);
  scene.apply(model::Eliminar_Triangulo{model::Elemento("first")});
  REQUIRE(scene.vertex_normals(*scene.find("second")));
  CHECK(*scene.vertex_normals(*scene.find("second")) == normals);
  CHECK(*scene.wrap(*scene.find("second")) == wrap);
  scene.apply(model::Eliminar_Triangulo{model::Elemento("second")});
  scene.apply(model::Agregar_Triangulo{model::Elemento("second"), {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}});
  CHECK_FALSE(scene.vertex_normals(*scene.find("second")));
}

TEST_CASE("no other shape has normals at vertices, and none of them is null or infinite") {
  scene::Scene scene = two_triangles();
  scene.apply(model::Agregar_Esfera{model::Elemento("ball"), {0, 0, 0}, 1});
  CHECK_THROWS_AS(scene.set_vertex_normals(*scene.find("ball"), normals), std::domain_error);
  for (const double wrong : {0.0, std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN()}) {
    scene::VertexNormals bad = normals;
    bad[2] = {0, wrong, 0};
    CHECK_FALSE(scene::have_directions(bad));
    CHECK_THROWS_AS(scene.set_vertex_normals(*scene.find("first"), bad), std::domain_error);
    CHECK_FALSE(scene.vertex_normals(*scene.find("first")));
  }
}
