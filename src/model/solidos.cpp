#include "durero/model/solidos.hpp"

#include <algorithm>

#include "durero/model/tipo/cilindro.hpp"
#include "durero/model/tipo/cono.hpp"
#include "durero/model/tipo/esfera.hpp"
#include "durero/model/tipo/plano.hpp"
#include "durero/model/tipo/tronco.hpp"

namespace durero::model {
namespace {

/// The quadric whose value is this everywhere, by the values at ten points. Precondition: there is one.
template <class Potencia>
Cuadrica cuadrica_of(Potencia&& potencia) {
  const auto at = [&](int x, int y, int z) { return potencia(ExactPoint{Surd(x), Surd(y), Surd(z)}).x; };
  const Rational o = at(0, 0, 0), x = at(1, 0, 0), y = at(0, 1, 0), z = at(0, 0, 1);
  const Rational mx = at(-1, 0, 0), my = at(0, -1, 0), mz = at(0, 0, -1);
  return Cuadrica({(x + mx) / 2 - o, (y + my) / 2 - o, (z + mz) / 2 - o, at(0, 1, 1) - y - z + o,
                   at(1, 0, 1) - z - x + o, at(1, 1, 0) - x - y + o, (x - mx) / 2, (y - my) / 2, (z - mz) / 2, o});
}

/// The allotments with this quadric in them.
Solido inside_of(const Cuadrica& c) {
  return {{c}, [c](const Cuadricas& l) { return l.contains(c); }};
}

Cuadricas both(const Cuadricas& a, const Cuadricas& b) {
  Cuadricas all = a;
  all.insert(b.begin(), b.end());
  return all;
}

/// Whether multiples go together, as far as cs knows of l.
bool go_together(const Cuadricas& cs, const Cuadricas& l) {
  for (const Cuadrica& a : cs)
    for (const Cuadrica& b : cs)
      if (const std::optional<Rational> k = multiplo(a, b); k && (l.contains(a) == l.contains(b)) != (*k > 0))
        return false;
  return true;
}

/// Every set between `in` and `in` with all of `free`.
std::vector<Cuadricas> sets_between(const Cuadricas& in, const std::vector<Cuadrica>& free) {
  std::vector<Cuadricas> all{in};
  for (const Cuadrica& c : free) {
    for (std::size_t i = all.size(); i-- > 0;) {
      all.push_back(all[i]);
      all.back().insert(c);
    }
  }
  return all;
}

/// The allotments for a point, as far as the quadrics of s.
std::vector<Cuadricas> repartos_at(const Solido& s, const ExactPoint& w) {
  return repartos(s.cuadricas, dentro(s.cuadricas, w), fuera(s.cuadricas, w));
}

template <class Side>
Cuadricas those(const Cuadricas& cs, Side&& is_among) {
  Cuadricas some;
  std::ranges::copy_if(cs, std::inserter(some, some.end()), is_among);
  return some;
}

/// The value that a ray from p sees of a quadric at w.
Surd value_from(const Cuadrica& c, const Punto& p, const Cuadricas& en, const ExactPoint& w) {
  return en.contains(c) ? valor(c, w) - valor(c, p) : valor(c, w);
}

}  // namespace

Cuadrica::Cuadrica(Coefficients coefficients) : coefficients_(std::move(coefficients)) {
  contract::require(Cuadrica_inv_1, std::ranges::any_of(coefficients_, [](const Rational& c) { return c != 0; }));
}

Surd valor(const Cuadrica& c, const ExactPoint& w) {
  const std::array<Surd, Cuadrica::size> products{cuadrado(w.x), cuadrado(w.y), cuadrado(w.z), w.y * w.z, w.z * w.x,
                                                  w.x * w.y,     w.x,           w.y,           w.z,       1};
  Surd sum = 0;
  for (std::size_t i = 0; i < products.size(); ++i) sum = sum + Surd(c.coefficients()[i]) * products[i];
  return sum;
}

std::optional<Rational> multiplo(const Cuadrica& a, const Cuadrica& b) {
  const auto& numerators = a.coefficients();
  const auto& denominators = b.coefficients();
  const auto first = std::ranges::find_if(denominators, [](const Rational& c) { return c != 0; });
  const Rational k = numerators[static_cast<std::size_t>(first - denominators.begin())] / *first;
  if (k == 0) return std::nullopt;
  for (std::size_t i = 0; i < Cuadrica::size; ++i)
    if (numerators[i] != k * denominators[i]) return std::nullopt;
  return k;
}

Cuadricas dentro(const Cuadricas& cs, const ExactPoint& w) {
  return those(cs, [&](const Cuadrica& c) { return valor(c, w) < 0; });
}

Cuadricas fuera(const Cuadricas& cs, const ExactPoint& w) {
  return those(cs, [&](const Cuadrica& c) { return valor(c, w) > 0; });
}

// Whatever of cs goes together is a part of an allotment of all quadrics: for each multiple of one of cs as that one is
// counted, and any other on its side, or on the quadric by the sign of its first coefficient other than 0.
std::vector<Cuadricas> repartos(const Cuadricas& cs, const Cuadricas& ds, const Cuadricas& fs) {
  std::vector<Cuadrica> free;
  std::ranges::copy_if(cs, std::back_inserter(free),
                       [&](const Cuadrica& c) { return !ds.contains(c) && !fs.contains(c); });
  std::vector<Cuadricas> all = sets_between(ds, free);
  std::erase_if(all, [&](const Cuadricas& l) { return !go_together(cs, l); });
  return all;
}

Solido solido_union(const Solido& s, const Solido& t) {
  return {both(s.cuadricas, t.cuadricas), [s, t](const Cuadricas& l) { return s.contains(l) || t.contains(l); }};
}

Solido solido_interseccion(const Solido& s, const Solido& t) {
  return {both(s.cuadricas, t.cuadricas), [s, t](const Cuadricas& l) { return s.contains(l) && t.contains(l); }};
}

Solido solido_diferencia(const Solido& s, const Solido& t) { return s & complemento(t); }

Solido complemento(const Solido& s) {
  return {s.cuadricas, [s](const Cuadricas& l) { return !s.contains(l); }};
}

Solido solido_esfera(const Punto& centro, const Rmas& radio) {
  return inside_of(cuadrica_of([&](const ExactPoint& w) { return potencia_esfera(w, centro, radio); }));
}

Solido solido_plano(const Punto& centro, const Unitario& dir) {
  return inside_of(cuadrica_of([&](const ExactPoint& w) { return potencia_plano(w, centro, dir.vector()); }));
}

Solido solido_tramo(const Punto& centro, const Unitario& dir, const Rmas& h) {
  const auto advance = [&](const ExactPoint& w) { return avance(w, centro, dir.vector()); };
  return inside_of(cuadrica_of([&](const ExactPoint& w) { return -advance(w); })) &
         inside_of(cuadrica_of([&](const ExactPoint& w) { return advance(w) - Surd(h.value()); }));
}

Solido solido_cilindro(const Punto& centro, const Rmas& radio, const Unitario& dir, const Rmas& h) {
  return solido_tramo(centro, dir, h) &
         inside_of(cuadrica_of([&](const ExactPoint& w) { return potencia_cilindro(w, centro, radio, dir.vector()); }));
}

Solido solido_cono(const Punto& centro, const Rmas& prop, const Unitario& dir, const Rmas& h) {
  return solido_tramo(centro, dir, h) &
         inside_of(cuadrica_of([&](const ExactPoint& w) { return potencia_cono(w, centro, prop, dir.vector(), h); }));
}

Solido solido_tronco(const Punto& centro, const Rmas& radio, const Rmas& prop, const Unitario& dir, const Rmas& h) {
  return solido_tramo(centro, dir, h) & inside_of(cuadrica_of([&](const ExactPoint& w) {
           return potencia_tronco(w, centro, radio, prop, dir.vector(), h);
         }));
}

Puntos cuerpo(const Solido& s) {
  return Puntos([s](const ExactPoint& w) { return std::ranges::any_of(repartos_at(s, w), s.contains); });
}

Puntos interior(const Solido& s) {
  return Puntos([s](const ExactPoint& w) { return std::ranges::all_of(repartos_at(s, w), s.contains); });
}

Puntos superficie(const Solido& s) {
  return Puntos([s](const ExactPoint& w) { return cuerpo(s).contains(w) && !interior(s).contains(w); });
}

bool con_multiplos(const Cuadricas& cs, const Cuadricas& en) {
  return std::ranges::all_of(cs, [&](const Cuadrica& a) {
    return std::ranges::all_of(cs,
                               [&](const Cuadrica& b) { return !multiplo(a, b) || en.contains(a) == en.contains(b); });
  });
}

Cuadricas dentro_desde(const Cuadricas& cs, const Punto& p, const Cuadricas& en, const ExactPoint& w) {
  return those(cs, [&](const Cuadrica& c) { return value_from(c, p, en, w) < 0; });
}

Cuadricas fuera_desde(const Cuadricas& cs, const Punto& p, const Cuadricas& en, const ExactPoint& w) {
  return those(cs, [&](const Cuadrica& c) { return value_from(c, p, en, w) > 0; });
}

bool superficie_desde(const Solido& s, const Rayo& rayo, const Cuadricas& en, const ExactPoint& w) {
  const auto all =
      repartos(s.cuadricas, dentro_desde(s.cuadricas, rayo.p(), en, w), fuera_desde(s.cuadricas, rayo.p(), en, w));
  return parameter(rayo, w).value_or(0) > 0 && std::ranges::any_of(all, s.contains) &&
         !std::ranges::all_of(all, s.contains);
}

ExactPoint en_parametro(const Rayo& rayo, const Surd& t) { return along(rayo.p(), rayo.v(), t); }

bool hecho_de(const Solido& s, const Cuadricas& cs) {
  const std::vector<Cuadrica> all(s.cuadricas.begin(), s.cuadricas.end());
  const auto of_cs = [&](const Cuadricas& l) { return those(l, [&](const Cuadrica& c) { return cs.contains(c); }); };
  std::map<Cuadricas, bool> told;
  return std::ranges::all_of(sets_between({}, all), [&](const Cuadricas& l) {
    const bool is_in = s.contains(l);
    return told.emplace(of_cs(l), is_in).first->second == is_in;
  });
}

}  // namespace durero::model
