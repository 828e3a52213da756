#include "conform/families/framed_shape.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <set>

#include "conform/families/surface_point.hpp"
#include "durero/model/operaciones.hpp"
#include "durero/scene/scene.hpp"
#include "durero/surface/surfaces.hpp"
#include "support/catch.hpp"

using namespace durero;
using namespace durero::conform;
using model::Tipo;

namespace {

/// visit(shape) for many shapes of each type, some of them tilted.
template <class Visit>
void for_shapes(Visit visit) {
  Draws random(2026);
  for (std::size_t type = 0; type < scene::shape_count; ++type) {
    for (int i = 0; i < 100; ++i) visit(random, any_shape(random, static_cast<Tipo>(type)));
  }
}

/// potencia at a point of space, and avance where the shape has an axis.
struct ClaimedPoint {
  double potencia, avance = 0;
};

ClaimedPoint place(const FramedShape& framed, const glm::dvec3& w) {
  scene::Scene scene;
  scene.apply(framed.addition(model::Elemento("e")));
  return scene.visit(*scene.find("e"), [&]<class Shape>(const Shape& shape) -> ClaimedPoint {
    const surface::Point<double> point{w.x, w.y, w.z};
    if constexpr (surface::Axial<Shape>)
      return {potencia(shape, point), avance(shape, point)};
    else
      return {potencia(shape, point)};
  });
}

}  // namespace

TEST_CASE("the points of a lattice shape lie on it exactly, those of a tilted one nearly") {
  for_shapes([](Draws& random, const FramedShape& shape) {
    const double size = glm::length(shape.centro) + shape.radius() + shape.altura;
    // The potencia of a triangle is a volume.
    const double scale = shape.tipo == Tipo::soy_triangulo ? 1000 * size * size : size * size;
    for (const FramedPoint& at : {surface_point(random, shape), rim_point(random, shape)}) {
      const double power = place(shape, at.position).potencia;
      if (shape.lattice) CHECK(power == 0);
      CHECK(std::abs(power) <= 0x1p-40 * scale);
    }
  });
}

TEST_CASE("a rim point is at an end of the axis, and a surface point between the ends") {
  for_shapes([](Draws& random, const FramedShape& shape) {
    if (!is_axial(shape.tipo) || !shape.lattice) return;
    const double at_rim = place(shape, rim_point(random, shape).position).avance;
    CHECK((at_rim == 0 || (at_rim == shape.altura && !has_apex(shape.tipo))));
    const FramedPoint at = surface_point(random, shape);
    const double between = place(shape, at.position).avance;
    CHECK((between > 0 && between < shape.altura));
    const glm::dvec3 along = whole_generator(shape, at);
    CHECK(place(shape, at.position + along).avance == between + shape.altura);
    CHECK(place(shape, at.position + along).potencia == 0);
  });
}

TEST_CASE("a rim point of a disc is at its rim, and a surface point within") {
  Draws random(1);
  for (int i = 0; i < 200; ++i) {
    const FramedShape disc = lattice_shape(random, Tipo::soy_disco);
    const glm::dvec3 rim = rim_point(random, disc).position, within = surface_point(random, disc).position;
    CHECK(glm::dot(rim - disc.centro, rim - disc.centro) == disc.radio * disc.radio);
    CHECK(glm::dot(within - disc.centro, within - disc.centro) < disc.radio * disc.radio);
  }
}

TEST_CASE("a rim point of a triangle is a vertex or at an edge, and a surface point within") {
  Draws random(1);
  std::size_t at_vertices = 0;
  for (int i = 0; i < 200; ++i) {
    const FramedShape shape = lattice_shape(random, Tipo::soy_triangulo);
    const auto least_lado = [&](const glm::dvec3& w) {
      double least = HUGE_VAL;
      for (std::size_t k = 0; k < 3; ++k) {
        const glm::dvec3 &a = shape.vertices[k], &b = shape.vertices[(k + 1) % 3];
        least = std::min(least, glm::dot(glm::cross(b - a, w - a), shape.d));
      }
      return least;
    };
    const glm::dvec3 rim = rim_point(random, shape).position;
    CHECK(least_lado(rim) == 0);
    CHECK(least_lado(surface_point(random, shape).position) > 0);
    at_vertices += std::find(shape.vertices.begin(), shape.vertices.end(), rim) != shape.vertices.end();
  }
  CHECK(at_vertices > 10);
  CHECK(at_vertices < 60);
}

TEST_CASE("across a flat shape's normal, exactly") {
  for_shapes([](Draws& random, const FramedShape& shape) {
    if (!is_flat(shape.tipo) || (shape.tipo == Tipo::soy_triangulo && !shape.lattice)) return;
    const glm::dvec3 w = perpendicular_vector(random, shape);
    CHECK(w != glm::dvec3(0));
    CHECK(glm::dot(w, shape.d) == 0);
  });
}

TEST_CASE("a tangent touches to first order: the power does not change its sign there") {
  for_shapes([](Draws& random, const FramedShape& shape) {
    if (!shape.lattice) return;
    const FramedPoint at = surface_point(random, shape);
    const glm::dvec3 u = tangent_vector(random, at);
    const double before = place(shape, at.position - u).potencia, after = place(shape, at.position + u).potencia;
    CHECK(before == after);  // A·t², the same at t = −1 and 1
    CHECK((after != 0) == !is_flat(shape.tipo));
  });
}

TEST_CASE("inwards leads into the shape, from every point where the two tangents span a plane") {
  std::size_t compared = 0;
  for_shapes([&](Draws& random, const FramedShape& shape) {
    if (!shape.lattice) return;
    const FramedPoint at = surface_point(random, shape);
    const glm::dvec3 w = inwards(any_vector(random, shape), at);
    if (glm::dot(w, glm::cross(at.around, at.along)) == 0) return;  // w is tangent, or there is no plane
    CHECK(inwards(-w, at) == w);
    const double step = 0x1p-12;
    CHECK(place(shape, at.position + step * w).potencia < place(shape, at.position - step * w).potencia);
    ++compared;
  });
  CHECK(compared > 100);
}

TEST_CASE("any type is drawn, and any that has an axis") {
  Draws random(1);
  std::set<Tipo> types, axial;
  for (int i = 0; i < 100; ++i) types.insert(any_type(random)), axial.insert(any_axial_type(random));
  CHECK(types == std::set{Tipo::soy_esfera, Tipo::soy_cilindro, Tipo::soy_cono, Tipo::soy_tronco});
  CHECK(axial == std::set{Tipo::soy_cilindro, Tipo::soy_cono, Tipo::soy_tronco});
  CHECK_FALSE(is_axial(Tipo::soy_esfera));
  CHECK_FALSE(is_axial(Tipo::soy_plano));
  for (const Tipo flat : {Tipo::soy_plano, Tipo::soy_disco, Tipo::soy_triangulo}) CHECK(is_flat(flat));
  CHECK_FALSE(is_flat(Tipo::soy_cilindro));
  CHECK(any_unbounded_type(random) == Tipo::soy_plano);
}

TEST_CASE("a scaled shape is the same one at another scale") {
  for_shapes([](Draws&, const FramedShape& shape) {
    const FramedShape large = scaled(shape, 40), again = scaled(large, -40);
    CHECK(large.radius() == std::ldexp(shape.radius(), 40));
    CHECK(large.has_exact_radius() == shape.has_exact_radius());
    CHECK(again.centro == shape.centro);
    CHECK(again.radius() == shape.radius());
    CHECK(again.altura == shape.altura);
    CHECK(again.vertices == shape.vertices);
  });
}
