#include "durero/render/texture/coordinates.hpp"

#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <utility>

#include "durero/model/operaciones.hpp"
#include "durero/surface/normal.hpp"
#include "support/catch.hpp"
#include "support/property.hpp"

using namespace durero;
using render::TextureCoordinates;

namespace {

const glm::dvec3 tilted{0.36, 0.48, -0.8};

/// One of each surface, none of them at the origin nor along an axis of space.
scene::Scene one_of_each() {
  using model::Elemento;
  scene::Scene scene;
  scene.apply(model::Agregar_Esfera{Elemento("esfera"), {1, 2, 3}, 2.5});
  scene.apply(model::Agregar_Cilindro{Elemento("cilindro"), {1, 2, 3}, 0.75, model::Vector(tilted), 3});
  scene.apply(model::Agregar_Cono{Elemento("cono"), {1, -2, 3}, 0.5, model::Vector(tilted), 2});
  scene.apply(model::Agregar_Tronco{Elemento("tronco"), {-1, 2, 3}, 0.5, 0.25, model::Vector(tilted), 2});
  scene.apply(model::Agregar_Plano{Elemento("plano"), {1, 2, -3}, model::Vector(tilted)});
  scene.apply(model::Agregar_Disco{Elemento("disco"), {1, 2, 3}, 1.5, model::Vector(tilted)});
  scene.apply(model::Agregar_Triangulo{Elemento("triangulo"), {{1, 0, 0}, {3, 1, 0.5}, {0.5, 2, -1}}});
  return scene;
}

/// Away from seams and poles, of a disc within the rim and of a triangle within it.
TextureCoordinates any_coordinates() {
  const double u = *rc::gen::inRange(5, 60) / 128.0, v = *rc::gen::inRange(5, 60) / 128.0;
  return {u + 0.1, v};
}

}  // namespace

TEST_CASE("(u, v) to the point and back, on every surface, to 10^-12") {
  const scene::Scene scene = one_of_each();
  test::property("and the point lies on the surface", [&] {
    const TextureCoordinates at = any_coordinates();
    scene.for_each([&](scene::ElementRef element, const auto&) {
      const TextureCoordinates back = render::coordinates(scene, element, render::point_at(scene, element, at));
      RC_ASSERT(std::abs(back.u - at.u) < 1e-12);
      RC_ASSERT(std::abs(back.v - at.v) < 1e-12);
    });
  });
}

TEST_CASE("tangents are the slopes of f_p to 10^-8, and their product lies on the outer side") {
  const scene::Scene scene = one_of_each();
  test::property("central differences of 2^-17", [&] {
    const TextureCoordinates at = any_coordinates();
    scene.for_each([&](scene::ElementRef element, const auto&) {
      // Their error is h²/6 of a third derivative, at most (2π)³·2.5/6 of 2⁻³⁴, and of rounding 2⁻⁵⁰/h.
      constexpr double h = 0x1p-17;
      const auto p = [&](double u, double v) { return render::point_at(scene, element, {u, v}); };
      const auto [t_u, t_v] = render::tangents(scene, element, at);
      RC_ASSERT(glm::distance(t_u, (p(at.u + h, at.v) - p(at.u - h, at.v)) / (2 * h)) < 1e-8);
      RC_ASSERT(glm::distance(t_v, (p(at.u, at.v + h) - p(at.u, at.v - h)) / (2 * h)) < 1e-8);
      const glm::dvec3 n = surface::normal(scene, element, p(at.u, at.v));
      RC_ASSERT(glm::dot(glm::normalize(glm::cross(t_u, t_v)), n) > 1 - 1e-12);
    });
  });
}

TEST_CASE("at a pole u is 0 and the tangents have no product") {
  scene::Scene scene;
  scene.apply(model::Agregar_Esfera{model::Elemento("s"), {1, 2, 3}, 2});
  scene.apply(model::Agregar_Cono{model::Elemento("k"), {0, 0, 0}, 0.5, {0, 1, 0}, 2});
  const auto pole = [&](const char* name, const glm::dvec3& p, double v) {
    const scene::ElementRef element = *scene.find(name);
    const TextureCoordinates at = render::coordinates(scene, element, p);
    CHECK(at == TextureCoordinates{0, v});
    const auto t = render::tangents(scene, element, at);
    CHECK(glm::cross(t.u, t.v) == glm::dvec3(0));
  };
  pole("s", {1, 4, 3}, 1);
  pole("s", {1, 0, 3}, 0);
  pole("k", {0, 2, 0}, 1);
}

TEST_CASE("the seam is at angle 0: u is 0 there, and below 1 just before it") {
  scene::Scene scene;
  scene.apply(model::Agregar_Cilindro{model::Elemento("c"), {0, 0, 0}, 1, {0, 1, 0}, 2});
  const auto u = [&](double x, double z) { return render::coordinates(scene, *scene.find("c"), {x, 1, z}).u; };
  CHECK(u(1, 0) == 0);
  CHECK(u(0, -1) == 0.25);
  CHECK(u(-1, 0) == 0.5);
  CHECK(u(0, 1) == 0.75);
  CHECK(u(1, 1e-9) < 1);
  CHECK(u(1, 1e-9) > 0.999);
  CHECK(u(1, 1e-300) == 0);  // its angle rounds to a whole turn
}

namespace {

const std::array<glm::dvec2, 3> some_uv{{{0.25, 1}, {1.5, 0.75}, {0.5, -2}}};

/// The triangle of one_of_each with coordinates of its vertices.
scene::ElementRef wrapped(scene::Scene& scene, const scene::Wrap& wrap) {
  const scene::ElementRef element = *scene.find("triangulo");
  scene.set_wrap(element, wrap);
  return element;
}

}  // namespace

TEST_CASE("a triangle whose vertices have (u, v) has those there, and what is linear between them") {
  scene::Scene scene = one_of_each();
  const scene::ElementRef element = wrapped(scene, {some_uv});
  const auto& [a, b, c] = scene.shapes<scene::Triangle>()[element.index].vertices;
  const auto at = [&](const glm::dvec3& p) {
    const TextureCoordinates found = render::coordinates(scene, element, p);
    return glm::dvec2(found.u, found.v);
  };
  CHECK(glm::distance(at(a), some_uv[0]) < 1e-14);
  CHECK(glm::distance(at(b), some_uv[1]) < 1e-14);
  CHECK(glm::distance(at(c), some_uv[2]) < 1e-14);
  CHECK(glm::distance(at((a + 2.0 * b + 5.0 * c) / 8.0), (some_uv[0] + 2.0 * some_uv[1] + 5.0 * some_uv[2]) / 8.0) <
        1e-14);
  const glm::dvec3 p = render::point_at(scene, element, {0.75, 0});
  CHECK(glm::distance(at(p), glm::dvec2(0.75, 0)) < 1e-14);
}

TEST_CASE("its tangents are the slopes of that, one for the whole triangle, and turned over where (u, v) are") {
  for (const bool mirrored : {false, true}) {
    scene::Scene scene = one_of_each();
    std::array<glm::dvec2, 3> uv = some_uv;
    if (mirrored) std::swap(uv[1], uv[2]);
    const scene::ElementRef element = wrapped(scene, {uv});
    const auto p = [&](double u, double v) { return render::point_at(scene, element, {u, v}); };
    const auto [t_u, t_v] = render::tangents(scene, element, {0.7, 0.1});
    CHECK(glm::distance(t_u, p(1, 0) - p(0, 0)) < 1e-13);
    CHECK(glm::distance(t_v, p(0, 1) - p(0, 0)) < 1e-13);
    // some_uv go round clockwise: determinant 1.25·(−3) + 0.25·0.25 < 0.
    CHECK((glm::dot(glm::cross(t_u, t_v), surface::normal(scene, element, p(0, 0))) > 0) == mirrored);
  }
}

TEST_CASE("tangents of vertices are theirs there, linear in between, and none leaves the plane") {
  scene::Scene scene = one_of_each();
  const scene::ElementRef element = *scene.find("triangulo");
  const auto [e, f] = render::tangents(scene, element, {0, 0});
  const glm::dvec3 n = surface::normal(scene, element, {1, 0, 0});
  const std::array<scene::VertexTangents, 3> tangents{{{e, f}, {2.0 * e + f, f - 3.0 * n}, {e + 7.0 * n, 0.5 * f}}};
  scene.set_wrap(element, {some_uv, tangents});
  const auto at = [&](const glm::dvec3& weights) {
    const glm::dvec2 uv = weights.x * some_uv[0] + weights.y * some_uv[1] + weights.z * some_uv[2];
    return render::tangents(scene, element, {uv.x, uv.y});
  };
  CHECK(glm::distance(at({1, 0, 0}).u, e) < 1e-13);
  CHECK(glm::distance(at({0, 1, 0}).u, 2.0 * e + f) < 1e-13);
  CHECK(glm::distance(at({0, 1, 0}).v, f) < 1e-13);
  CHECK(glm::distance(at({0, 0, 1}).u, e) < 1e-13);
  CHECK(glm::distance(at({0.25, 0.25, 0.5}).u, 1.25 * e + 0.25 * f) < 1e-13);
  CHECK(glm::distance(at({0.25, 0.25, 0.5}).v, 0.75 * f) < 1e-13);
}

TEST_CASE("where the (u, v) of a triangle have no area it has no tangents") {
  scene::Scene scene = one_of_each();
  for (const auto& uv : {std::array<glm::dvec2, 3>{{{1, 2}, {1, 2}, {1, 2}}},
                         {{{0, 0}, {1, 2}, {2, 4}}},
                         {{{0, 0}, {1e300, 0}, {0, 1e300}}}}) {
    const scene::ElementRef element = wrapped(scene, {uv, std::array<scene::VertexTangents, 3>{}});
    const auto t = render::tangents(scene, element, {1, 2});
    CHECK(t.u == glm::dvec3(0));
    CHECK(t.v == glm::dvec3(0));
  }
}
