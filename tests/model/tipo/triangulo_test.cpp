#include "durero/model/tipo/triangulo.hpp"

#include "durero/model/puntos.hpp"
#include "model/escenas.hpp"
#include "model/places.hpp"
#include "support/catch.hpp"
#include "support/points_gen.hpp"
#include "support/property.hpp"

using namespace durero;
using namespace durero::model;
using namespace durero::test;

namespace {

rc::Gen<Terna> any_vertices() { return rc::gen::suchThat(any_terna(), Vertices::contains); }

/// p + x·(b − a) + y·(c − a)
ExactPoint moved(const ExactPoint& p, const Terna& v, const Surd& x, const Surd& y) {
  const ExactPoint a = v.a, b = v.b, c = v.c;
  return {p.x + x * (b.x - a.x) + y * (c.x - a.x), p.y + x * (b.y - a.y) + y * (c.y - a.y),
          p.z + x * (b.z - a.z) + y * (c.z - a.z)};
}

}  // namespace

TEST_CASE("potencia_triangulo.def.1: the volume over the edges, positive where they turn to the left") {
  CHECK(potencia_triangulo(Punto(7, 8, 2), corners) == 32);
  CHECK(potencia_triangulo(Punto(7, 8, -2), corners) == -32);
  CHECK(potencia_triangulo(Punto(7, 8, 0), corners) == 0);
  CHECK(potencia_triangulo(Punto(7, 8, 2), {corners.a, corners.c, corners.b}) == -32);
}

TEST_CASE("escalar.def.1") {
  CHECK(escalar(Punto(1, 2, 3), Punto(2, 4, 6), Punto(0, 0, 0), Punto(4, 5, 6)) == 4 + 10 + 18);
  CHECK(escalar(Punto(1, 2, 3), Punto(1, 2, 3), Punto(0, 0, 0), Punto(4, 5, 6)) == 0);
}

TEST_CASE("lado.def.1: positive where the third vertex lies") {
  const auto [a, b, c] = corners;
  CHECK(lado(c, a, b, c) == 256);  // the square of the product of the edges
  CHECK(lado(Punto(9, 0, 0), a, b, c) == 0);
  CHECK(lado(Punto(9, 0, 5), a, b, c) == 0);
  CHECK(lado(Punto(9, -1, 0), a, b, c) == -64);
}

TEST_CASE("prisma.def.1: without end on either side") {
  const Puntos prism = prisma(corners);
  CHECK(prism.contains(Punto(1, 1, 1e300)));
  CHECK(prism.contains(Punto(2, 2, -1e300)));
  CHECK_FALSE(prism.contains(Punto(2, 2 + 0x1p-51, 0)));
  CHECK_FALSE(prism.contains(Punto(-1, 1, 0)));
  CHECK_FALSE(prism.contains(Punto(1, -1, 0)));
}

TEST_CASE("puntos_triangulo.def.1: with its edges and its vertices") {
  const Puntos points = puntos_triangulo(corners);
  for (const Punto& w : {corners.a, corners.b, corners.c, Punto(2, 2, 0), Punto(0, 1, 0), Punto(1, 1, 0)})
    CHECK(points.contains(w));
  CHECK(points.contains({Surd(0, 1, 2), Surd(4) - Surd(0, 1, 2), Surd(0)}));
  CHECK_FALSE(points.contains(Punto(1, 1, 0x1p-1000)));
  CHECK_FALSE(points.contains(Punto(4 + 0x1p-50, 0, 0)));
  property("sampled points are members; beside the plane and beyond the edges they are not", [] {
    const Terna v = *any_vertices();
    const Puntos points = puntos_triangulo(v);
    Random random = *any_random();
    const auto w = points.sample(random);
    RC_ASSERT(w.has_value());
    RC_ASSERT(points.contains(*w));
    const Surd little(0x1p-200);
    const ExactPoint beside{w->x + little, w->y, w->z};
    RC_ASSERT(points.contains(beside) == (potencia_triangulo(beside, v) == 0 && prisma(v).contains(beside)));
    // From an edge, outwards.
    const Surd share(Rational(static_cast<int>(random() % 1025), 1024));
    RC_ASSERT(points.contains(moved(v.a, v, share, Surd(0))));
    RC_ASSERT(!points.contains(moved(v.a, v, share, -little)));
    RC_ASSERT(points.contains(moved(v.a, v, Surd(0), share)));
    RC_ASSERT(!points.contains(moved(v.a, v, -little, share)));
    RC_ASSERT(points.contains(moved(v.a, v, share, Surd(1) - share)));
    RC_ASSERT(!points.contains(moved(v.a, v, share, Surd(1) - share + little)));
  });
  property("the order of the vertices does not matter", [] {
    const Terna v = *any_vertices();
    Random random = *any_random();
    const ExactPoint w = *puntos_triangulo(v).sample(random);
    for (const Terna& other :
         {Terna{v.a, v.c, v.b}, Terna{v.b, v.a, v.c}, Terna{v.b, v.c, v.a}, Terna{v.c, v.a, v.b}, Terna{v.c, v.b, v.a}})
      RC_ASSERT(puntos_triangulo(other).contains(w));
  });
  property("two triangles with an edge in common share its points", [] {
    const Terna v = *any_vertices();
    const Terna other{v.b, *any_point(), v.a};
    RC_PRE(Vertices::contains(other));
    Random random = *any_random();
    const ExactPoint w = moved(v.a, v, Surd(Rational(static_cast<int>(random() % 1025), 1024)), Surd(0));
    RC_ASSERT(puntos_triangulo(v).contains(w));
    RC_ASSERT(puntos_triangulo(other).contains(w));
  });
}
