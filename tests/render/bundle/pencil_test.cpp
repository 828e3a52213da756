#include "durero/render/bundle/pencil.hpp"

#include <array>
#include <cmath>
#include <functional>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "durero/engine/engine.hpp"
#include "durero/model/haces.hpp"
#include "durero/model/operaciones.hpp"
#include "durero/render/light/directions.hpp"
#include "durero/scene/axes_across.hpp"
#include "durero/surface/curvature.hpp"
#include "durero/surface/normal.hpp"
#include "support/catch.hpp"
#include "support/scenes.hpp"

using namespace durero;
using namespace durero::test;

namespace {

/// What a ray does at each element that it meets, in turn.
struct Meeting {
  scene::ElementRef element;
  double ratio = 0;  ///< of indices; 0 where it is mirrored
};

/// A ray at its last meeting.
struct Ray {
  glm::dvec3 point, direction;
};

/// Follows a ray to the last of the meetings, at which it stays.
Ray followed(const scene::Scene& scene, const engine::Engine& exact, Ray ray, const std::vector<Meeting>& way) {
  scene::ElementSet en;
  for (std::size_t i = 0; i < way.size(); ++i) {
    const scene::Hit hit = engine::first_hit(exact, {{model::Punto(ray.point), model::Vector(ray.direction)}, en});
    REQUIRE(hit.elementos == scene::ElementSet{way[i].element});
    ray.point = hit.punto;
    en = hit.elementos;
    if (i + 1 == way.size()) break;
    glm::dvec3 n = surface::normal(scene, way[i].element, hit.punto);
    if (glm::dot(n, ray.direction) > 0) n = -n;
    ray.direction = way[i].ratio > 0 ? render::refracted(ray.direction, n, way[i].ratio).value()
                                     : render::mirrored(ray.direction, n);
  }
  return ray;
}

/// The pencil about that ray, at the last meeting.
render::Pencil pencil_of(const scene::Scene& scene, const engine::Engine& exact, const Ray& axis,
                         const std::vector<Meeting>& way) {
  render::Pencil pencil(axis.point, axis.direction);
  for (std::size_t i = 0; i < way.size(); ++i) {
    pencil.transfer(followed(scene, exact, axis, {way.begin(), way.begin() + std::ptrdiff_t(i) + 1}).point);
    if (i + 1 == way.size()) break;
    glm::dvec3 n = surface::normal(scene, way[i].element, pencil.point());
    glm::dmat3 curvature = surface::curvature(scene, way[i].element, pencil.point());
    if (glm::dot(n, pencil.direction()) > 0) n = -n, curvature = -curvature;
    if (way[i].ratio > 0)
      REQUIRE(pencil.refract(n, curvature, way[i].ratio));
    else
      pencil.reflect(n, curvature);
  }
  return pencil;
}

/// How far a ray that deviates by δ times a direction of deviation ends from where the matrix says: point and
/// direction.
double error_of(const scene::Scene& scene, const engine::Engine& exact, const Ray& axis,
                const std::vector<Meeting>& way, const render::Deviation& off) {
  const auto [first, second] = scene::axes_across(axis.direction);
  const Ray beside{axis.point + off.x * first + off.y * second,
                   glm::normalize(axis.direction + off.z * first + off.w * second)};
  const Ray there = followed(scene, exact, beside, way);
  const render::Pencil pencil = pencil_of(scene, exact, axis, way);
  const glm::dvec3 n = surface::normal(scene, way.back().element, pencil.point());
  const glm::dvec3 point = pencil.point() + pencil.on_plane(off, n);
  return glm::distance(there.point, point) + glm::distance(there.direction, glm::normalize(pencil.leaning(off)));
}

const scene::ElementRef ball{model::Tipo::soy_esfera, 0}, pearl{model::Tipo::soy_esfera, 1},
    wall{model::Tipo::soy_plano, 0}, back{model::Tipo::soy_plano, 1}, tube{model::Tipo::soy_cilindro, 0},
    cone{model::Tipo::soy_cono, 0};

/// A ball, a smaller one, a cylinder and a cone between two walls.
scene::Scene optical_bench() {
  scene::Scene scene;
  scene.apply(model::Agregar_Esfera{model::Elemento("ball"), {0, 0, 0}, 1});
  scene.apply(model::Agregar_Esfera{model::Elemento("pearl"), {0.3, 2.5, 0}, 0.5});
  scene.apply(model::Agregar_Cilindro{model::Elemento("tube"), {4, -2, 0}, 0.8, {0, 1, 0}, 4});
  scene.apply(model::Agregar_Cono{model::Elemento("cone"), {0, -5, 0}, 0.5, {0, 1, 0}, 3});
  scene.apply(model::Agregar_Plano{model::Elemento("wall"), {0, 0, 6}, {0, 0, -1}});
  scene.apply(model::Agregar_Plano{model::Elemento("back"), {0, 0, -9}, {0, 0, 1}});
  return scene;
}

Ray towards(const glm::dvec3& from, const glm::dvec3& to) { return {from, glm::normalize(to - from)}; }

/// The least slope of the error, in powers of δ, over random deviations.
double slope_of(const scene::Scene& scene, const Ray& axis, const std::vector<Meeting>& way) {
  const auto exact = engine::find("exact")->prepare(scene);
  Random random(5);
  double least = 10;
  for (int i = 0; i < 10; ++i) {
    const glm::dvec3 a = random.in_cube(1), b = random.in_cube(1);
    const render::Deviation off(a.x, a.y, b.x, b.y);
    const double coarse = error_of(scene, *exact, axis, way, 0x1p-10 * off);
    const double fine = error_of(scene, *exact, axis, way, 0x1p-15 * off);
    CHECK(coarse < 0x1p-4);
    least = std::min(least, std::log2(coarse / fine) / 5);
  }
  return least;
}

}  // namespace

TEST_CASE("the matrix of transfer, refraction and reflection is what traced rays tell, to the second order") {
  const scene::Scene scene = optical_bench();
  const std::pair<Ray, std::vector<Meeting>> ways[] = {
      {towards({-3, 0.2, -5}, {-2, 1, 6}), {{wall}}},                                     // transfer alone
      {towards({0.4, 0.3, -5}, {0.4, 0.3, -1}), {{ball, 1 / 1.5}, {ball, 1.5}, {wall}}},  // through glass
      {towards({0.4, 0.3, -5}, {0.4, 0.3, -1}), {{ball, 1 / 1.5}, {ball, 0}, {ball, 1.5}, {back}}},
      {towards({3, 4, 2}, {0.3, 2.8, 0.4}), {{pearl, 0}, {wall}}},                     // off a ball
      {towards({1, 0.2, -5}, {3.5, 0.5, 0}), {{tube, 1 / 1.3}, {tube, 1.3}, {wall}}},  // through a cylinder
      {towards({2, -3.5, 4.5}, {0.1, -4, 0.1}), {{cone, 0}, {wall}}},                  // off a cone
  };
  for (std::size_t i = 0; i < std::size(ways); ++i) {
    CAPTURE(i);
    const double slope = slope_of(scene, ways[i].first, ways[i].second);
    CHECK(slope > 1.9);
  }
}

TEST_CASE("no ray of a cell ends farther from where the matrix says than the three probes tell") {
  const scene::Scene scene = optical_bench();
  const auto exact = engine::find("exact")->prepare(scene);
  const Ray axis = towards({0.4, 0.3, -5}, {0.4, 0.3, -1});
  const std::vector<Meeting> way{{ball, 1 / 1.5}, {ball, 1.5}, {wall}};
  const render::Pencil pencil = pencil_of(scene, *exact, axis, way);
  Random random(9);
  for (int cell = 0; cell < 6; ++cell) {
    const glm::dvec3 a = random.in_cube(1), b = random.in_cube(1), c = random.in_cube(1), d = random.in_cube(1);
    const render::Deviation first = 0x1p-9 * render::Deviation(a.x, a.y, b.x, b.y),
                            second = 0x1p-9 * render::Deviation(c.x, c.y, d.x, d.y);
    const auto off = [&](double s, double t) {
      const render::Deviation at = s * first + t * second;
      const auto [across, other] = scene::axes_across(axis.direction);
      const Ray beside{axis.point + at.x * across + at.y * other,
                       glm::normalize(axis.direction + at.z * across + at.w * other)};
      return followed(scene, *exact, beside, way).point - pencil.point() - pencil.on_plane(at, {0, 0, -1});
    };
    const double bound = render::second_order(off(0.5, 0), off(0, 0.5), off(0.5, 0.5));
    CHECK(bound < 1e-3);
    double most = 0;
    for (int i = 0; i < 60; ++i) {
      const double s = random.uniform(-0.5, 0.5), t = random.uniform(-0.5, 0.5);
      most = std::max(most, glm::length(off(s, t)));
    }
    CHECK(most <= bound);
    CHECK(most > 0.05 * bound);
  }
}

TEST_CASE("the matrices of a ball head on are those of the text") {
  const double r = 2, n = 1.5, k = 1 / n;
  render::Pencil pencil({0, 0, -7}, {0, 0, 1});
  pencil.transfer({0, 0, -r});
  REQUIRE(
      pencil.refract({0, 0, -1}, (glm::dmat3(1) - glm::outerProduct(glm::dvec3(0, 0, 1), glm::dvec3(0, 0, 1))) / r, k));
  pencil.transfer({0, 0, r});
  REQUIRE(pencil.refract({0, 0, -1}, (glm::dmat3(1) - glm::outerProduct(glm::dvec3(0, 0, 1), glm::dvec3(0, 0, 1))) / -r,
                         n));
  const model::Desvio in{1, 3, model::Rational(1) / 4, model::Rational(-1) / 2};
  using model::refraccion_paraxial, model::traslado;
  const model::Rational exact_k = model::Rational(2) / 3, exact_n = model::Rational(3) / 2;
  const model::Desvio out =
      refraccion_paraxial(-2, exact_n, traslado(4, refraccion_paraxial(2, exact_k, traslado(5, in))));
  const render::Deviation here = pencil.matrix() * render::Deviation(1, 3, 0.25, -0.5);
  CHECK(here.x == Approx(number::round_to_binary64(out.x)));
  CHECK(here.y == Approx(number::round_to_binary64(out.y)));
  CHECK(here.z == Approx(number::round_to_binary64(out.u)));
  CHECK(here.w == Approx(number::round_to_binary64(out.v)));
  // What comes along the axis meets it at n·r/2(n − 1) from the centre.
  pencil.transfer({0, 0, n * r / (2 * (n - 1))});
  CHECK(glm::length(pencil.offset({1, 3, 0, 0})) < 1e-14);
}

TEST_CASE("in total reflection a pencil stays as it is") {
  render::Pencil pencil({0, 0, 0}, glm::normalize(glm::dvec3(3, 0, 1)));
  pencil.transfer(3.0 * pencil.direction());
  const glm::dmat4 before = pencil.matrix();
  CHECK_FALSE(pencil.refract({0, 0, -1}, glm::dmat3(0), 1.5));
  CHECK(pencil.matrix() == before);
  CHECK(pencil.direction() == glm::normalize(glm::dvec3(3, 0, 1)));
}
