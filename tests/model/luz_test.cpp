#include "durero/model/luz.hpp"

#include <stdexcept>

#include "durero/model/puntos.hpp"
#include "escenas.hpp"
#include "support/catch.hpp"

using namespace durero;
using namespace durero::model;
using namespace durero::test;

namespace {

Rational part(std::int64_t n, std::int64_t d) { return Rational(n) / Rational(d); }

/// Matt red, of which each test changes something.
Material matt() {
  Material m{};
  m.k_d = 1;
  m.C = part(3, 4);
  m.M_PS = m.M_T = m.indice = m.e = 1;
  return m;
}

/// The labels that do not hold.
std::vector<std::string_view> broken(const Judgements& judgements) {
  std::vector<std::string_view> labels;
  for (const Judgement& each : judgements)
    if (!each.holds) labels.push_back(each.what->label);
  return labels;
}

std::vector<std::string_view> broken_by(Rational Material::*component, const Rational& value) {
  Material m = matt();
  m.*component = value;
  return broken(inv(m));
}

const ExactDirection up{0, 0, 1}, slanted{part(3, 5), 0, part(4, 5)}, mirrored{part(-3, 5), 0, part(4, 5)};
const Rational little = part(1, 1000000007);

}  // namespace

TEST_CASE("Parte.inv.1 and Cantidad.inv.1: both ends are in") {
  for (const Rational& k : {Rational(0), part(1, 2), Rational(1)}) CHECK(Parte::contains(k).holds);
  CHECK_FALSE(Parte::contains(-little).holds);
  CHECK_FALSE(Parte::contains(1 + little).holds);
  CHECK(Cantidad::contains(0).holds);
  CHECK(Cantidad::contains(1000).holds);
  CHECK_FALSE(Cantidad::contains(-little).holds);
}

TEST_CASE("Material.inv.1 to Material.inv.12: each is broken alone") {
  using Labels = std::vector<std::string_view>;
  CHECK(broken(inv(matt())).empty());
  const std::pair<Rational Material::*, const char*> shares[] = {
      {&Material::k_a, "Material.inv.1"},  {&Material::k_d, "Material.inv.2"}, {&Material::k_s, "Material.inv.3"},
      {&Material::k_ps, "Material.inv.4"}, {&Material::k_t, "Material.inv.5"}, {&Material::C, "Material.inv.6"},
      {&Material::M_PS, "Material.inv.7"}, {&Material::M_T, "Material.inv.8"}};
  for (const auto& [component, label] : shares) {
    CHECK(broken_by(component, -little) == Labels{label});
    CHECK(broken_by(component, 1 + little) == Labels{label});
    CHECK(broken_by(component, 1).empty());
  }
  const std::pair<Rational Material::*, const char*> amounts[] = {{&Material::emisividad, "Material.inv.9"},
                                                                  {&Material::A_G, "Material.inv.10"},
                                                                  {&Material::e, "Material.inv.11"}};
  for (const auto& [component, label] : amounts) {
    CHECK(broken_by(component, -little) == Labels{label});
    CHECK(broken_by(component, 0).empty());
    CHECK(broken_by(component, 1000).empty());
  }
  CHECK(broken_by(&Material::indice, 0) == Labels{"Material.inv.12"});
  CHECK(broken_by(&Material::indice, little).empty());
}

TEST_CASE("conserva.def.1: a sheet sends on no more than it receives") {
  Material m = matt();
  m.k_ps = part(1, 2);
  m.k_t = part(3, 4);
  CHECK_FALSE(conserva(m));
  m.M_T = part(2, 3);
  CHECK(conserva(m));
  m.M_T = part(2, 3) + little;
  CHECK_FALSE(conserva(m));
}

TEST_CASE("Fuente.inv.1 and Fuente.inv.2") {
  using Labels = std::vector<std::string_view>;
  CHECK(broken(inv(Fuente{up, 3, 0})).empty());
  CHECK(broken(inv(Fuente{up, -little, 1})) == Labels{"Fuente.inv.1"});
  CHECK(broken(inv(Fuente{up, 3, part(1, 2)})) == Labels{"Fuente.inv.2"});
}

TEST_CASE("mayor.def.1") {
  CHECK(mayor(0, Surd(-1)) == 0);
  CHECK(mayor(Surd(0, 1, 2), Surd(part(7, 5))) == Surd(0, 1, 2));
  CHECK(mayor(2, 2) == 2);
}

TEST_CASE("elevado.def.1, elevado.def.2, elevado.def.3: the laws, at whole exponents") {
  const Surd bases[] = {0, Surd(part(1, 3)), Surd(1), Surd(0, 1, 2), 7};
  for (const Surd& x : bases) {
    CHECK(elevado(x, 0) == 1);
    CHECK(elevado(x, 1) == x);
    for (const int a : {0, 1, 2, 5, 13})
      for (const int b : {0, 1, 3, 8}) CHECK(elevado(x, a + b) == elevado(x, a) * elevado(x, b));
  }
  for (std::size_t i = 1; i < std::size(bases); ++i)
    for (const int a : {0, 1, 2, 9}) CHECK(elevado(bases[i - 1], a) <= elevado(bases[i], a));
  CHECK(elevado(1, part(1, 3)) == 1);
  CHECK(elevado(Surd(part(1, 2)), 5) == Surd(part(1, 32)));  // five meetings at a half: below a twentieth
  CHECK_THROWS_AS(elevado(2, part(1, 3)), std::domain_error);
  CHECK_THROWS_AS(elevado(2, -1), std::domain_error);
  CHECK_THROWS_AS(elevado(Surd(-2), 2), std::domain_error);
  CHECK_THROWS_AS(elevado(2, (1 << 20) + 1), std::domain_error);
}

TEST_CASE("visible.def.1: what stands beyond the light hides nothing; the elements it starts on do not either") {
  Escena escena = Init();
  apply(escena, Agregar_Esfera{esfera, {0, 0, 5}, 1});
  CHECK(visible(escena, {0, 0, 0}, {0, 0, 3}, {}));
  CHECK_FALSE(visible(escena, {0, 0, 0}, {0, 0, 7}, {}));
  CHECK_FALSE(visible(escena, {0, 0, 0}, {0, 0, 4.5}, {}));
  CHECK(visible(escena, {0, 0, 4}, {0, 0, 1}, {esfera}));
  CHECK_FALSE(visible(escena, {0, 0, 4}, {0, 0, 9}, {esfera}));
  CHECK_FALSE(visible(escena, {0, 0, 0}, {0, 0, 0}, {}));  // a light in the very point has no direction
  CHECK_THROWS_AS(visible(escena, {0x1p-80, 0, 0}, {1, 0, 0}, {}), std::domain_error);
}

TEST_CASE("visible_lejos.def.1: of a light without end, an element at any distance hides it") {
  Escena escena = Init();
  apply(escena, Agregar_Esfera{esfera, {0, 0, 0x1p200}, 1});
  CHECK_FALSE(visible_lejos(escena, {0, 0, 0}, {0, 0, 1}, {}));
  CHECK(visible_lejos(escena, {0, 0, 0}, {0, 0, -1}, {}));
  CHECK(visible_lejos(escena, {0, 2, 0}, {0, 0, 1}, {}));
  CHECK(visible(escena, {0, 0, 0}, {0, 0, 1}, {}));
}

TEST_CASE("ante.def.1 and ante_lejos.def.1: an element stands between in each of its points before the light") {
  Escena escena = Init();
  apply(escena, Agregar_Esfera{esfera, {0, 0, 5}, 1});
  const Rayo beyond({0, 0, 0}, {0, 0, 7}), within({0, 0, 0}, {0, 0, 5}), at({0, 0, 0}, {0, 0, 4});
  const ExactPoint near{0, 0, 4}, far{0, 0, 6};
  CHECK(ante(escena, beyond, {}, esfera, near));
  CHECK(ante(escena, beyond, {}, esfera, far));
  CHECK(ante(escena, within, {}, esfera, near));
  CHECK_FALSE(ante(escena, within, {}, esfera, far));
  CHECK_FALSE(ante(escena, at, {}, esfera, near));  // the light is in the very point
  CHECK(ante_lejos(escena, at, {}, esfera, near));
  CHECK(ante_lejos(escena, at, {}, esfera, far));
  CHECK_FALSE(ante_lejos(escena, at, {}, esfera, {0, 0, 5}));
  CHECK_FALSE(ante_lejos(escena, at, {}, Elemento("other"), near));
}

TEST_CASE("enumerado.def.1: each point once, from a start on an element its other one, and none along a surface") {
  Escena escena = Init();
  apply(escena, Agregar_Esfera{esfera, {0, 0, 5}, 1});
  apply(escena, Agregar_Plano{Elemento("wall"), {0, 0, 6}, {0, 0, 1}});
  const Rayo rayo({0, 0, 0}, {0, 0, 7});
  const auto all = enumerado(escena, rayo, {}, true);
  REQUIRE(all);
  REQUIRE(all->size() == 3);
  for (const Encuentro& each : *all) CHECK(ante(escena, rayo, {}, each.e, each.punto));
  CHECK(enumerado(escena, {{0, 0, 0}, {0, 0, 6}}, {}, true).value().size() == 1);
  CHECK(enumerado(escena, {{0, 0, 0}, {0, 0, 6}}, {}, false).value().size() == 3);
  CHECK(enumerado(escena, {{0, 0, 4}, {0, 0, 9}}, {esfera}, true).value().size() == 2);
  CHECK_FALSE(enumerado(escena, {{0, 0, 6}, {1, 0, 0}}, {}, true));
  Escena tall = Init();
  apply(tall, Agregar_Cilindro{Elemento("tube"), {0, 0, 5}, 1, {0, 0, 1}, 2});
  CHECK(enumerado(tall, {{1, 0, 0}, {0, 0, 5}}, {}, true).value().empty());  // it runs along the tube beyond the light
  CHECK_FALSE(enumerado(tall, {{1, 0, 0}, {0, 0, 6}}, {}, true));
  CHECK_FALSE(enumerado(tall, {{1, 0, 0}, {0, 0, 5}}, {}, false));
}

TEST_CASE("atenuado.def.1 and transmitido.def.1: all that stands between takes its share, in any order") {
  const std::vector<Rational> shares{part(1, 2), part(2, 3), part(3, 4)};
  CHECK(atenuado(shares) == std::vector<Rational>{1, part(1, 2), part(1, 3), part(1, 4)});
  CHECK(atenuado({}) == std::vector<Rational>{1});
  Escena escena = Init();
  apply(escena, Agregar_Esfera{esfera, {0, 0, 5}, 1});
  apply(escena, Agregar_Plano{Elemento("wall"), {0, 0, 8}, {0, 0, 1}});
  const auto passes = [&](const Encuentro& each) { return each.e == esfera ? part(2, 3) : part(1, 5); };
  CHECK(transmitido(*enumerado(escena, {{0, 0, 0}, {0, 0, 9}}, {}, true), passes) == part(4, 45));
  CHECK(transmitido(*enumerado(escena, {{0, 0, 0}, {0, 0, 7}}, {}, true), passes) == part(4, 9));
  CHECK(transmitido(*enumerado(escena, {{0, 0, 0}, {0, 0, 5}}, {}, true), passes) == part(2, 3));
  CHECK(transmitido({}, passes) == 1);
}

TEST_CASE("menguada.def.1: the share of a light, from the same direction") {
  const Fuente left = menguada({slanted, 3, 1}, part(1, 4));
  CHECK(left.l == slanted);
  CHECK(left.S == part(3, 4));
  CHECK(left.V == 1);
}

TEST_CASE("Cono_de_Luz.inv.1, Cono_de_Luz.inv.2, Cono_de_Luz.inv.3: each is broken alone") {
  using Labels = std::vector<std::string_view>;
  const Cono_de_Luz cone{up, part(4, 5), part(3, 5), 2};
  const auto with = [&](auto component, auto value) {
    Cono_de_Luz other = cone;
    other.*component = value;
    return broken(inv(other));
  };
  CHECK(broken(inv(cone)).empty());
  CHECK(with(&Cono_de_Luz::eje, ExactDirection{0, 0, 2}) == Labels{"Cono_de_Luz.inv.1"});
  CHECK(with(&Cono_de_Luz::pleno, part(3, 5)).empty());
  CHECK(with(&Cono_de_Luz::pleno, Rational(1)).empty());
  CHECK(with(&Cono_de_Luz::pleno, Rational(1 + little)) == Labels{"Cono_de_Luz.inv.2"});
  CHECK(with(&Cono_de_Luz::pleno, part(3, 5) - little) == Labels{"Cono_de_Luz.inv.2"});
  CHECK(with(&Cono_de_Luz::borde, Rational(0)) == Labels{"Cono_de_Luz.inv.2"});
  CHECK(with(&Cono_de_Luz::estrechez, Rational(0)).empty());
  CHECK(with(&Cono_de_Luz::estrechez, Rational(-little)) == Labels{"Cono_de_Luz.inv.3"});
}

TEST_CASE("intensidad.def.1: full within, nothing without, smooth between, and narrowed by a power") {
  const Cono_de_Luz cone{up, part(9, 10), part(3, 5), 0}, narrowed{up, part(9, 10), part(3, 5), 2};
  CHECK(intensidad(cone, up) == 1);
  CHECK(intensidad(cone, {part(3, 5), part(4, 5), 0}) == 0);
  CHECK(intensidad(cone, {part(4, 5), 0, part(3, 5)}) == 0);
  // x = (4/5 − 3/5)/(9/10 − 3/5) = 2/3, and x²(3 − 2x) = 20/27
  CHECK(intensidad(cone, slanted) == Surd(part(20, 27)));
  CHECK(intensidad(narrowed, slanted) == Surd(part(16, 25) * part(20, 27)));
  const Cono_de_Luz sharp{up, part(4, 5), part(4, 5), 3};
  CHECK(intensidad(sharp, slanted) == Surd(part(64, 125)));  // without a way between, it is full at the edge
  CHECK(intensidad(sharp, {part(4, 5), 0, part(3, 5)}) == 0);
}

TEST_CASE("normal_suave.def.1: the corner's own at a corner, and between them the shares of each") {
  const ExactDirection a{1, 0, 2}, b{0, 3, 1}, c{part(1, 2), part(-1, 2), 4};
  CHECK(normal_suave(a, b, c, 0, 0) == a);
  CHECK(normal_suave(a, b, c, 1, 0) == b);
  CHECK(normal_suave(a, b, c, 0, 1) == c);
  CHECK(normal_suave(a, b, c, part(1, 2), part(1, 4)) == ExactDirection{part(3, 8), part(11, 8), 2});
}

TEST_CASE("especular.def.1 is the product with the mirrored light, whichever of the two is mirrored") {
  for (const ExactDirection& l : {up, slanted, mirrored, ExactDirection{part(2, 3), part(-1, 3), part(2, 3)}})
    for (const ExactDirection& v : {up, slanted, ExactDirection{part(-2, 7), part(3, 7), part(6, 7)}}) {
      CHECK(especular(l, up, v) == producto(reflected(l, up), v));
      CHECK(especular(l, slanted, v) == producto(l, reflected(v, slanted)));
    }
}

TEST_CASE("directa.def.1: each term alone") {
  Material m = matt();
  CHECK(directa(m, up, up, slanted) == Surd(part(3, 5)));  // 3/4 · 4/5
  CHECK(directa(m, up, up, {part(3, 5), 0, part(-4, 5)}) == 0);
  m.k_a = part(1, 3);
  CHECK(directa(m, up, up, {1, 0, 0}) == Surd(part(1, 4)));
  CHECK(directa(m, up, up, {0, 0, -1}) == Surd(part(1, 4)));
  m = matt();
  m.C = 0;
  m.k_s = part(1, 2);
  m.e = 3;
  CHECK(directa(m, up, mirrored, slanted) == Surd(part(1, 2)));
  CHECK(directa(m, up, up, slanted) == Surd(part(32, 125)));            // ½ · (4/5)³
  CHECK(directa(m, up, slanted, slanted) == Surd(part(343, 31250)));    // ½ · (7/25)³
  CHECK(directa(m, up, {part(-4, 5), 0, part(3, 5)}, {1, 0, 0}) == 0);  // along the surface there is no highlight
  m.e = 0;
  CHECK(directa(m, up, {1, 0, 0}, slanted) == Surd(part(1, 2)));  // a power of zero is one, behind the mirror too
}

TEST_CASE("aportacion.def.1, acumulado.def.1, radiancia.def.1, indirecta.def.1: what counts how often") {
  Material m = matt();
  m.k_d = 0;
  m.k_a = part(1, 3);
  m.emisividad = 2;
  m.A_G = part(1, 7);
  const auto lit = [&](const std::vector<Fuente>& lights) {
    std::vector<Surd> given;
    for (const Fuente& f : lights) given.push_back(aportacion(m, up, up, f));
    return radiancia(m, acumulado(given).back(), 0, 0);
  };
  const Surd own(Rational(2) + part(1, 7));
  CHECK(lit({}) == own);
  CHECK(lit({{up, 1, 1}}) == own + Surd(part(1, 4)));
  CHECK(lit({{up, 1, 1}, {slanted, 3, 1}}) == own + Surd(1));  // k_a·C for each light that is seen
  CHECK(lit({{up, 1, 1}, {slanted, 3, 0}}) == own + Surd(part(1, 4)));
  m.k_ps = part(1, 2);
  m.M_PS = part(1, 5);
  m.k_t = part(1, 4);
  m.M_T = part(1, 3);
  CHECK(indirecta(m, 10, 24) == Surd(part(1, 7)) + 1 + 2);
  CHECK(radiancia(m, 5, 10, 24) == own + 1 + 2 + 5);
}

TEST_CASE("trazador.def.1: black beyond the greatest depth; mirror facing mirror; what meets nothing") {
  // Way 0 and way 1 lead to mirrors of a half that face each other, of which the first shines; way 2 meets nothing.
  Material mirror = matt();
  mirror.k_ps = part(1, 2);
  Trazado t{{{true, 0, mirror, 0, 1, 1}, {true, 0, mirror, 0, 0, 2}, {false, 6, {}, 0, 2, 2}}};
  t.caminos[0].material.emisividad = 1;
  t.caminos[1].material.k_t = part(1, 3);
  const auto at = [&](std::int64_t maximo) { return trazador(t, maximo, 1); };
  CHECK(at(0) == std::vector<Surd>{0, 0, 0});
  CHECK(at(1) == std::vector<Surd>{1, 0, 6});
  CHECK(at(2) == std::vector<Surd>{1, Surd(part(1, 2)) + 2, 6});
  CHECK(at(3) == std::vector<Surd>{Surd(part(9, 4)), Surd(part(1, 2)) + 2, 6});
  CHECK(trazador(t, 3, 3) == at(1));  // what counts is how many are left
  CHECK(trazador(t, 3, 4) == at(0));
  // The sum of what comes and goes: with the depth it approaches 1 + (½·2 + ½·½·1 + …), and never passes it.
  const Surd limit = Surd(Rational(2)) / Surd(part(3, 4));
  Surd before = 0;
  for (const std::int64_t depth : {1, 2, 3, 10, 40}) {
    const Surd here = at(depth)[0];
    CHECK(before <= here);
    CHECK(here < limit);
    before = here;
  }
  CHECK(limit - before < Surd(part(1, 1 << 30)));
}

TEST_CASE("Ventana.inv.1, Ventana.inv.2, centro_de_pixel.def.1 and rayo_de_pixel.def.1: half a pixel from its corner") {
  using Labels = std::vector<std::string_view>;
  Ventana w{{0, 0, -3}, {-2, 1, 0}, {4, 0, 0}, {0, -2, 0}, 4, 2};
  CHECK(broken(inv(w)).empty());
  CHECK(centro_de_pixel(w, 0, 0) == ExactPoint{Surd(part(-3, 2)), Surd(part(1, 2)), 0});
  CHECK(centro_de_pixel(w, 3, 1) == ExactPoint{Surd(part(3, 2)), Surd(part(-1, 2)), 0});
  CHECK(rayo_de_pixel(w, 0, 0, {{0, 0, -3}, {-1.5, 0.5, 3}}));
  CHECK(rayo_de_pixel(w, 0, 0, {{0, 0, -3}, {-3, 1, 6}}));  // of any length
  CHECK_FALSE(rayo_de_pixel(w, 0, 0, {{0, 0, -3}, {1.5, -0.5, -3}}));
  CHECK_FALSE(rayo_de_pixel(w, 1, 0, {{0, 0, -3}, {-1.5, 0.5, 3}}));
  CHECK_FALSE(rayo_de_pixel(w, 0, 0, {{0, 0, -6}, {-1.5, 0.5, 6}}));
  CHECK_FALSE(rayo_de_pixel(w, 4, 0, {{0, 0, -3}, {2.5, 0.5, 3}}));
  CHECK_FALSE(rayo_de_pixel(w, -1, 0, {{0, 0, -3}, {-2.5, 0.5, 3}}));
  w.H = 0;
  CHECK(broken(inv(w)) == Labels{"Ventana.inv.1"});
  w.H = 1;
  w.V = 0;
  CHECK(broken(inv(w)) == Labels{"Ventana.inv.2"});
}
