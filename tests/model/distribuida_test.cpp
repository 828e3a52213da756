#include "durero/model/distribuida.hpp"

#include "durero/model/puntos.hpp"
#include "support/catch.hpp"

using namespace durero;
using namespace durero::model;

namespace {

Rational fraction(std::int64_t n, std::int64_t d) { return Rational(n) / Rational(d); }

using LabelList = std::vector<std::string_view>;

LabelList broken_labels(const Judgements& judgements) {
  LabelList labels;
  for (const Judgement& each : judgements)
    if (!each.holds) labels.push_back(each.what->label);
  return labels;
}

const Rational tiny = fraction(1, 1000000007);
const Sorteo coin{{fraction(1, 2), fraction(1, 2)}}, die{{fraction(1, 6), fraction(1, 3), fraction(1, 2)}};

/// A lens of the diameter 1 that looks along a unit vector with rational components, and is in focus at 4.
Lente lens() { return {{1, 2, 3}, {Surd(fraction(2, 3)), Surd(fraction(-1, 3)), Surd(fraction(2, 3))}, 1, 4}; }

ExactPoint from_lens(const Lente& l, const Surd& along, const ExactDirection& across) {
  return {l.ojo.x + along * l.eje.x + across.x, l.ojo.y + along * l.eje.y + across.y,
          l.ojo.z + along * l.eje.z + across.z};
}

Surd squared_distance(const ExactPoint& a, const ExactPoint& b) {
  const ExactDirection d{a.x - b.x, a.y - b.y, a.z - b.z};
  return producto(d, d);
}

}  // namespace

TEST_CASE("Sorteo.inv.1, Sorteo.inv.2, Sorteo.inv.3: chances add to one") {
  CHECK(broken_labels(inv(coin)).empty());
  CHECK(broken_labels(inv(die)).empty());
  CHECK(broken_labels(inv(Sorteo{{1}})).empty());
  CHECK(broken_labels(inv(Sorteo{{0, 1}})).empty());
  CHECK(broken_labels(inv(Sorteo{})) == LabelList{"Sorteo.inv.1", "Sorteo.inv.3"});
  CHECK(broken_labels(inv(Sorteo{{-tiny, 1 + tiny}})) == LabelList{"Sorteo.inv.2"});
  CHECK(broken_labels(inv(Sorteo{{fraction(1, 2), fraction(1, 2) + tiny}})) == LabelList{"Sorteo.inv.3"});
}

TEST_CASE("media.def.1: each as often as it comes") {
  CHECK(media(coin, std::vector<Surd>{3, 4}) == Surd(fraction(7, 2)));
  CHECK(media(die, std::vector<Surd>{6, 3, 2}) == 3);
  CHECK(media(die, std::vector<Surd>{5, 5, 5}) == 5);
  CHECK(media(coin, std::vector<Surd>{Surd(0, 1, 2), Surd(0, 3, 2)}) == Surd(0, 2, 2));
}

TEST_CASE("de_luz_extensa.def.1: the part of a light that is seen gives its part") {
  Material m{};
  m.k_d = m.C = m.M_PS = m.M_T = m.indice = m.e = 1;
  const ExactDirection up{0, 0, 1}, slanted{Surd(fraction(3, 5)), 0, Surd(fraction(4, 5))};
  const Fuente seen{up, 10, 1}, hidden{up, 10, 0}, aside{slanted, 10, 1};
  const auto of = [&](const Sorteo& s, const std::vector<Fuente>& points) {
    return de_luz_extensa(m, up, up, s, points);
  };
  CHECK(of(coin, {seen, seen}) == 10);
  CHECK(of(coin, {seen, hidden}) == 5);
  CHECK(of(coin, {hidden, hidden}) == 0);
  CHECK(of(coin, {seen, aside}) == 9);
  CHECK(of(die, {seen, hidden, aside}) == Surd(fraction(10, 6)) + 4);
}

TEST_CASE("Lente.inv.1, Lente.inv.2, Lente.inv.3: each is broken alone") {
  CHECK(broken_labels(inv(lens())).empty());
  Lente l = lens();
  l.abertura = 0;
  CHECK(broken_labels(inv(l)).empty());
  l.abertura = -tiny;
  CHECK(broken_labels(inv(l)) == LabelList{"Lente.inv.2"});
  l = lens();
  l.foco = 0;
  CHECK(broken_labels(inv(l)) == LabelList{"Lente.inv.3"});
  l = lens();
  l.eje.x = Surd(1);
  CHECK(broken_labels(inv(l)) == LabelList{"Lente.inv.1"});
}

TEST_CASE("puntos_de_lente.def.1: a disc across the view, its rim included") {
  const Lente l = lens();
  const ExactDirection across{Surd(fraction(1, 3)), Surd(fraction(2, 3)), 0};  // at right angles to the axis
  REQUIRE(producto(across, l.eje) == 0);
  const Surd half = Surd(fraction(1, 2)) / Surd(0, fraction(1, 3), 5);  // across has the length √5/3
  const auto at = [&](const Surd& k, const Surd& along) {
    return puntos_de_lente(l, from_lens(l, along, {k * across.x, k * across.y, 0}));
  };
  CHECK(at(0, 0));
  CHECK(at(half, 0));
  CHECK(at(-half, 0));
  CHECK_FALSE(at(half + Surd(tiny), 0));
  CHECK_FALSE(at(0, Surd(tiny)));
}

TEST_CASE("punto_en_foco.def.1 and rayo_de_lente.def.1: every point of the lens aims at one point") {
  const Lente l{{0, 0, 0}, {0, 0, 1}, 2, 4};
  const ExactDirection v{1, 0, 2};
  const auto f = punto_en_foco(l, v);
  REQUIRE(f);
  CHECK(*f == ExactPoint{2, 0, 4});
  CHECK_FALSE(punto_en_foco(l, {1, 0, 0}));
  CHECK_FALSE(punto_en_foco(l, {0, 0, -1}));
  CHECK(rayo_de_lente(l, v, {{0, 0, 0}, {1, 0, 2}}));
  CHECK(rayo_de_lente(l, v, {{1, 0, 0}, {1, 0, 4}}));
  CHECK(rayo_de_lente(l, v, {{0, -1, 0}, {0.5, 0.25, 1}}));  // of any length
  CHECK_FALSE(rayo_de_lente(l, v, {{1, 0, 0}, {1, 0, 2}}));  // parallel to it: not in focus
  CHECK_FALSE(rayo_de_lente(l, v, {{1.5, 0, 0}, {0.5, 0, 4}}));
  CHECK_FALSE(rayo_de_lente(l, v, {{1, 0, 0}, {-1, 0, -4}}));
  CHECK_FALSE(rayo_de_lente(l, {0, 0, -1}, {{0, 0, 0}, {0, 0, -1}}));
}

TEST_CASE("visto_en_foco.def.1 and circulo_de_confusion.def.1: the rim of the lens draws the circle") {
  const Lente l = lens();
  const ExactDirection across{Surd(fraction(1, 3)), Surd(fraction(2, 3)), 0};
  const Surd half = Surd(fraction(1, 2)) / Surd(0, fraction(1, 3), 5);
  const ExactPoint rim = from_lens(l, 0, {half * across.x, half * across.y, 0});
  for (const Rational& z : {fraction(1, 2), Rational(3), Rational(4), Rational(100)}) {
    const ExactPoint w =
        from_lens(l, Surd(z), {Surd(fraction(1, 7)), 0, Surd(fraction(-1, 7))});  // at right angles too
    const auto u = visto_en_foco(l, rim, w), k = visto_en_foco(l, l.ojo, w);
    REQUIRE((u && k));
    const Surd c = circulo_de_confusion(l, Surd(z));
    CHECK(Surd(4) * squared_distance(*u, *k) == c * c);
    CHECK(c == Surd(z < 4 ? Rational(4 / z - 1) : Rational(1 - 4 / z)));
  }
  CHECK_FALSE(visto_en_foco(l, l.ojo, l.ojo));
}

TEST_CASE("desplazado.def.1: at the time 0 where it is, at 1 a whole step on") {
  const ExactPoint p{1, 2, 3};
  const ExactDirection v{4, 0, -2};
  CHECK(desplazado(p, v, 0) == p);
  CHECK(desplazado(p, v, 1) == ExactPoint{5, 2, 1});
  CHECK(desplazado(p, v, fraction(1, 4)) == ExactPoint{2, 2, Surd(fraction(5, 2))});
}

TEST_CASE("repartida.def.1: the means of two draws add to the sum, whatever the weights") {
  // Weights as the chances stand to each other, and the third outcome left to the first draw alone.
  Repartida r{.p = die,
              .q = {{fraction(1, 2), fraction(1, 2), 0}},
              .w = {},
              .o = {},
              .f = {3, fraction(1, 7), 5},
              .x = {},
              .y = {}};
  for (std::size_t i = 0; i < 3; ++i) {
    r.w.push_back(r.p.p[i] / (r.p.p[i] + r.q.p[i]));
    r.o.push_back(1 - r.w[i]);
    r.x.push_back(r.w[i] * r.f[i] / r.p.p[i]);
    r.y.push_back(r.q.p[i] == 0 ? Rational(9) : r.o[i] * r.f[i] / r.q.p[i]);  // what never comes counts nothing
  }
  REQUIRE(repartida(r));
  const std::vector<Surd> x(r.x.begin(), r.x.end()), y(r.y.begin(), r.y.end());
  CHECK(media(r.p, x) + media(r.q, y) == Surd(Rational(8) + fraction(1, 7)));
  Repartida other = r;
  other.o[0] += tiny;
  CHECK_FALSE(repartida(other));
  other.y[0] = other.o[0] * other.f[0] / other.q.p[0];  // weights that add to more than one
  CHECK_FALSE(repartida(other));
  other = r;
  other.x[2] += tiny;
  CHECK_FALSE(repartida(other));
  other = r;
  other.y[1] += tiny;
  CHECK_FALSE(repartida(other));
  other = r;
  other.q = coin;
  CHECK_FALSE(repartida(other));
}

TEST_CASE("ruleta.def.1: a survivor counts for those that are gone") {
  CHECK(ruleta(1, 7) == Rational(7));
  CHECK(ruleta(fraction(1, 4), 7) == Rational(28));
  CHECK(ruleta(fraction(1, 4), 0) == Rational(0));
  CHECK_FALSE(ruleta(0, 7));
  for (const Rational& c : {fraction(1, 4), fraction(9, 10)}) {
    const Sorteo on{{c, 1 - c}};
    CHECK(media(on, std::vector<Surd>{Surd(*ruleta(c, 7)), 0}) == 7);
  }
}
