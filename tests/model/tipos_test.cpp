#include "durero/model/tipos.hpp"

#include <boost/multiprecision/gmp.hpp>
#include <cmath>
#include <limits>
#include <set>
#include <stdexcept>

#include "support/catch.hpp"
#include "support/clauses.hpp"
#include "support/model_gen.hpp"
#include "support/property.hpp"

using namespace durero;
using namespace durero::model;
using durero::test::violated;

namespace {

constexpr double inf = std::numeric_limits<double>::infinity();
constexpr double no_number = std::numeric_limits<double>::quiet_NaN();

/// Unitario.inv.1 as it is written, in rational arithmetic.
bool in_unitario(const Vector& d) {
  using rational = boost::multiprecision::mpq_rational;
  const rational x(d.x()), y(d.y()), z(d.z()), tolerance(tolerancia_unidad);
  const rational n = x * x + y * y + z * z;
  return 1 - tolerance <= n && n <= 1 + tolerance;
}

}  // namespace

TEST_CASE("Rmas.inv.1: a length is a strictly positive real") {
  for (const double wrong : {0.0, -0.0, -1.0, -5e-324, inf, -inf, no_number}) {
    CHECK(violated([&] { Rmas{wrong}; }) == "Rmas.inv.1");
    CHECK_FALSE(Rmas::contains(wrong));
  }
  for (const double right : {5e-324, 1.0, std::numeric_limits<double>::max()}) CHECK(Rmas(right).value() == right);
}

TEST_CASE("Rayo.inv.1: a ray has a direction") {
  const Punto p(1, 2, 3);
  CHECK(violated([&] { Rayo(p, Vector(0, 0, 0)); }) == "Rayo.inv.1");
  CHECK(violated([&] { Rayo(p, Vector(0, -0.0, 0)); }) == "Rayo.inv.1");
  for (const Vector& v : {Vector(5e-324, 0, 0), Vector(0, 1e300, 0), Vector(0, 0, -1)}) CHECK(Rayo(p, v).v() == v);
}

TEST_CASE("Vertices.inv.1: three points that do not lie on one line") {
  const Punto a(0, 0, 0), b(1, 2, 3), c(3, 6, 9);
  for (const Terna& wrong :
       {Terna{a, b, c}, Terna{b, a, c}, Terna{a, a, b}, Terna{a, b, b}, Terna{b, a, b}, Terna{c, c, c}}) {
    CHECK(violated([&] { Vertices{wrong}; }) == "Vertices.inv.1");
    CHECK_FALSE(Vertices::contains(wrong));
  }
  const Terna right{a, b, Punto(3, 6, 8)};
  CHECK(Vertices(right).terna() == right);
  // By so little that a rounding hides it, by numbers whose products vanish or overflow, and beside one line in each of
  // the three coordinate planes.
  const double huge = 1e300, tiny = 5e-324;
  for (const Terna& near :
       {Terna{Punto(0, 0, 0), Punto(1, 1, 1), Punto(2, 2, 2 + 0x1p-51)},
        Terna{Punto(0, 0, 0), Punto(tiny, 0, 0), Punto(0, tiny, 0)},
        Terna{Punto(0, 0, 0), Punto(huge, huge, 0), Punto(huge, 0, 0)},
        Terna{Punto(-huge, 0, 0), Punto(huge, 0, 0), Punto(0, 0, tiny)},
        Terna{Punto(7, 0, 0), Punto(7, 1, 0), Punto(7, 0, 1)}, Terna{Punto(0, 7, 0), Punto(1, 7, 0), Punto(0, 7, 1)},
        Terna{Punto(0, 0, 7), Punto(1, 0, 7), Punto(0, 1, 7)}})
    CHECK(Vertices::contains(near));
  CHECK_FALSE(Vertices::contains({Punto(-huge, 0, 0), Punto(huge, 0, 0), Punto(tiny, 0, 0)}));
  // On one line, though their differences are rounded, and the products of these differ.
  CHECK_FALSE(Vertices::contains({Punto(0x3p-55, 0xfp-55, 0), Punto(1.8125, 9.0625, 0), Punto(0.921875, 4.609375, 0)}));
  // As they are stored, 0.1 · 2.1 is not 0.3 · 0.7.
  CHECK(Vertices::contains({Punto(0, 0, 0), Punto(0.1, 0.3, 0), Punto(0.7, 2.1, 0)}));
  CHECK_FALSE(Vertices::contains({Punto(0, 0, 0), Punto(0.1, 0.2, 0.4), Punto(0.2, 0.4, 0.8)}));

  test::property("as rational arithmetic says", [] {
    using rational = boost::multiprecision::mpq_rational;
    const Terna v = *test::any_terna();
    const auto of = [&](const Punto& p, int i) -> rational { return rational(p.xyz()[i]) - rational(v.a.xyz()[i]); };
    bool aligned = true;
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < i; ++j) aligned = aligned && of(v.b, i) * of(v.c, j) == of(v.b, j) * of(v.c, i);
    RC_ASSERT(Vertices::contains(v) == !aligned);
  });
}

TEST_CASE("Unitario.inv.1: an axis misses length one by the tolerance at most") {
  for (const Vector& wrong : {Vector(0, 0, 0), Vector(1, 1, 0), Vector(0.7, 0.7, 0), Vector(1e300, 1e300, 0),
                              Vector(1 + 0x1p-50, 0, 0), Vector(1 - 0x1p-50, 0, 0)})
    CHECK(violated([&] { Unitario{wrong}; }) == "Unitario.inv.1");
  for (const Vector& right : {Vector(1, 0, 0), Vector(0, -1, 0), Vector(0.6, 0, 0.8), Vector(1 + 0x1p-52, 0, 0)})
    CHECK(Unitario(right).vector() == right);
}

TEST_CASE("Unitario.inv.1 is decided exactly at the tolerance") {
  // (1 + 2⁻⁵¹)² = 1 + 2⁻⁵⁰ + 2⁻¹⁰² is out by less than any rounding of its square can show; a step below it is in.
  CHECK_FALSE(Unitario::contains(Vector(1 + 0x1p-51, 0, 0)));
  CHECK(Unitario::contains(Vector(1 + 0x1p-52, 0, 0)));
  // (1 − 2⁻⁵¹)² = 1 − 2⁻⁵⁰ + 2⁻¹⁰² is in; a step below it is out.
  CHECK(Unitario::contains(Vector(1 - 0x1p-51, 0, 0)));
  CHECK_FALSE(Unitario::contains(Vector(1 - 0x1p-51 - 0x1p-53, 0, 0)));
  // 1 + 2⁻⁵⁰ itself: 1² + (2⁻²⁵)² is the last that is in, and one more 2⁻¹⁰⁷⁴² is out.
  CHECK(Unitario::contains(Vector(1, 0x1p-25, 0)));
  CHECK_FALSE(Unitario::contains(Vector(1, 0x1p-25, 5e-324)));
  CHECK_FALSE(Unitario::contains(Vector(1, std::nextafter(0x1p-25, 1), 0)));

  test::property("near the tolerance, as rational arithmetic says", [] {
    const Vector d = *test::any_axis();
    const double scale = 1 + *rc::gen::inRange(-24, 25) * 0x1p-53;
    const Vector near(d.x() * scale, d.y() * scale, d.z() * scale);
    RC_ASSERT(Unitario::contains(near) == in_unitario(near));
  });
}

TEST_CASE("tolerancia_unidad.def.1") { CHECK(tolerancia_unidad * 1125899906842624.0 == 1); }

TEST_CASE("a vector divided by its length is an axis") {
  test::property("in Unitario", [] {
    const Vector v = *rc::gen::suchThat(test::any_vector(), [](const Vector& u) { return u != Vector(0, 0, 0); });
    RC_ASSERT(Unitario::contains(test::normalised(v)));
  });
}

TEST_CASE("points and vectors are of real numbers") {
  for (const double wrong : {inf, -inf, no_number}) {
    CHECK_THROWS_AS(Punto(wrong, 0, 0), std::domain_error);
    CHECK_THROWS_AS(Punto(0, wrong, 0), std::domain_error);
    CHECK_THROWS_AS(Vector(0, wrong, 0), std::domain_error);
    CHECK_THROWS_AS(Vector(0, 0, wrong), std::domain_error);
  }
  CHECK(Punto(0, 0, 0) == Punto(-0.0, 0, 0));  // both zeros denote 0
}

TEST_CASE("an element's name is 1 to 128 of A-Z a-z 0-9 _ . : -") {
  for (const char* right : {"a", "Z9", "_.:-", "x.y:z-0"}) CHECK(Elemento(right).name() == right);
  for (const char* wrong : {"", " ", "a b", "é", "a\n", "a/b"}) CHECK_THROWS_AS(Elemento(wrong), std::invalid_argument);
  CHECK(Elemento::is_name(std::string(128, 'a')));
  CHECK_FALSE(Elemento::is_name(std::string(129, 'a')));
  CHECK_FALSE(Elemento::is_name(std::string("a\0b", 3)));
}

TEST_CASE("each type and each answer has its name") {
  CHECK(name(Tipo::soy_esfera) == "soy_esfera");
  CHECK(name(Tipo::soy_cilindro) == "soy_cilindro");
  CHECK(name(Tipo::soy_cono) == "soy_cono");
  CHECK(name(Tipo::soy_tronco) == "soy_tronco");
  CHECK(name(Tipo::soy_plano) == "soy_plano");
  CHECK(name(Tipo::soy_disco) == "soy_disco");
  CHECK(name(Tipo::soy_triangulo) == "soy_triangulo");
  std::set<std::string_view> names;
  for (std::size_t i = 0; i < respuesta_names.size(); ++i) names.insert(name(static_cast<Respuesta>(i)));
  CHECK(names.size() == respuesta_names.size());
  CHECK(name(Respuesta::tronco_agregado) == "tronco_agregado");
  CHECK(name(Respuesta::elemento_agregado) == "elemento_agregado");
  CHECK(name(Respuesta::cono_eliminado) == "cono_eliminado");
  CHECK(name(Respuesta::tipo_incorrecto) == "tipo_incorrecto");
  CHECK(name(Respuesta::proporcion_no_positiva) == "proporcion_no_positiva");
  CHECK(name(Respuesta::vertices_alineados) == "vertices_alineados");
  CHECK(name(Respuesta::malla_agregada) == "malla_agregada");
  CHECK(name(Respuesta::es_de_malla) == "es_de_malla");
  CHECK(name(Respuesta::elemento_cambiado) == "elemento_cambiado");
  CHECK(name(Respuesta::nada_que_rehacer) == "nada_que_rehacer");
}
