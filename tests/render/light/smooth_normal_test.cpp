#include "render/light/smooth_normal.hpp"

#include <cmath>
#include <glm/geometric.hpp>

#include "durero/model/operaciones.hpp"
#include "durero/render/light/directions.hpp"
#include "durero/render/light/whitted.hpp"
#include "durero/render/render.hpp"
#include "durero/scene/stage.hpp"
#include "support/catch.hpp"

using namespace durero;

namespace {

const glm::dvec3 up{0, 0, 1};

/// The triangle (0, 0, 0), (1, 0, 0), (0, 1, 0), whose own normal is +z.
scene::Scene triangle_of(const std::optional<scene::VertexNormals>& normals = {}) {
  scene::Scene scene;
  scene.apply(model::Agregar_Triangulo{model::Elemento("t"), {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}});
  if (normals) scene.set_vertex_normals(*scene.find("t"), *normals);
  return scene;
}

glm::dvec3 normal_at(const scene::Scene& scene, double u, double v) {
  return render::smooth_normal(scene, *scene.find("t"), {u, v, 0}, up);
}

/// A ball of radius 1 as triangles, `rows` by twice as many, each vertex with the normal of the ball, if it is smooth.
scene::Scene ball_of_triangles(int rows, bool is_smooth) {
  scene::Scene scene;
  const auto at = [&](int row, int column) {
    const double latitude = M_PI * row / rows, longitude = M_PI * column / rows;
    return glm::dvec3(std::sin(latitude) * std::cos(longitude), std::sin(latitude) * std::sin(longitude),
                      std::cos(latitude));
  };
  int number = 0;
  const auto add = [&](const scene::Corners& corners) {
    const auto name = model::Elemento("t" + std::to_string(++number));
    if (!scene.add(name, scene::Triangle{corners}).ok()) return;  // at a pole
    if (is_smooth) scene.set_vertex_normals(*scene.find(name.name()), corners);
  };
  for (int row = 0; row < rows; ++row)
    for (int column = 0; column < 2 * rows; ++column) {
      const glm::dvec3 a = at(row, column), b = at(row + 1, column), c = at(row + 1, column + 1),
                       d = at(row, column + 1);
      add({a, b, c});
      add({a, c, d});
    }
  return scene;
}

/// The picture of a scene by one light from above and before.
render::Picture picture(scene::Scene scene) {
  scene.stage().camera = scene::Camera{{0, -4, 0}, {0, 0, 0}, {0, 0, 1}, 20};
  scene.stage().resolution = scene::Resolution{48, 48};
  scene.stage().directional_lights.push_back({{0.3, 1, -0.8}, {1, 1, 1}});
  return render::render(scene, *engine::find("fast")->prepare(scene));
}

/// The greatest difference of two pictures where the second one is bright: off the rim, and off the edge of shadow.
double greatest_difference(const render::Picture& one, const render::Picture& other) {
  double greatest = 0;
  for (std::size_t i = 0; i < other.rgb.size(); ++i)
    if (other.rgb[i].x > 0.3) greatest = std::max(greatest, std::abs(one.rgb[i].x - other.rgb[i].x));
  return greatest;
}

}  // namespace

TEST_CASE("without normals at the vertices the normal stays as it is, to the last bit") {
  CHECK(normal_at(triangle_of(), 0.25, 0.25) == up);
}

TEST_CASE("at a vertex the normal is the vertex's, of length 1, and between them the shares of each") {
  const scene::Scene scene = triangle_of(scene::VertexNormals{{{0, 0, 5}, {3, 0, 4}, {0, -0x1p-600, 0x1p-600}}});
  CHECK(normal_at(scene, 0, 0) == up);
  CHECK(normal_at(scene, 1, 0) == glm::dvec3(0.6, 0, 0.8));
  CHECK(glm::distance(normal_at(scene, 0, 1), glm::normalize(glm::dvec3(0, -1, 1))) < 1e-15);
  CHECK(glm::distance(normal_at(scene, 0.5, 0), glm::normalize(glm::dvec3(1.5, 0, 4.5))) < 1e-15);
}

TEST_CASE("normals that point to the other side mean the same surface, and those that cancel out none") {
  const scene::VertexNormals tilted{{{1, 0, 3}, {0, 1, 3}, {0, 0, 1}}};
  scene::VertexNormals turned = tilted;
  for (glm::dvec3& n : turned) n = -n;
  CHECK(normal_at(triangle_of(tilted), 0.25, 0.5) == normal_at(triangle_of(turned), 0.25, 0.5));
  CHECK(normal_at(triangle_of(scene::VertexNormals{{{0, 0, 1}, {0, 0, -1}, {0, 0, 1}}}), 0.5, 0.25) == up);
}

// The direction between normals that are an angle h apart is off by h²/8 of the ball's at most, and its point too: so
// the difference falls with the square of the triangles' size, where that of flat triangles falls with the size.
TEST_CASE("a ball of triangles that are smooth looks as a ball, the more so the finer they are") {
  scene::Scene ball;
  ball.apply(model::Agregar_Esfera{model::Elemento("ball"), {0, 0, 0}, 1});
  const render::Picture round = picture(ball);
  const double coarse = greatest_difference(picture(ball_of_triangles(10, true)), round);
  const double fine = greatest_difference(picture(ball_of_triangles(20, true)), round);
  const double flat = greatest_difference(picture(ball_of_triangles(20, false)), round);
  CAPTURE(coarse, fine, flat);
  CHECK(fine < 0.01);
  CHECK(fine < coarse / 3);
  CHECK(flat > 5 * fine);
}

TEST_CASE("an outline, a depth and a shadow are those of the flat triangles") {
  const scene::Scene smooth = ball_of_triangles(6, true), flat = ball_of_triangles(6, false);
  const render::Picture one = picture(smooth), other = picture(flat);
  std::size_t seen = 0;
  for (std::size_t i = 0; i < one.rgb.size(); ++i) {
    CHECK((one.rgb[i] == render::default_background) == (other.rgb[i] == render::default_background));
    seen += one.rgb[i] != other.rgb[i] ? 1 : 0;
  }
  CHECK(seen > 500);
}
