#include "durero/oracle/exact.hpp"

#include <algorithm>
#include <utility>

namespace durero::oracle::exact {
namespace {

using model::Resultado;
using model::Tipo;

/// visit(element) for every element of the scene, ascending, until it answers true. Whether it did.
template <class Visit>
bool any_element(const scene::Scene& scene, Visit visit) {
  const std::pair<Tipo, std::size_t> tables[] = {{Tipo::soy_esfera, scene.spheres().size()},
                                                 {Tipo::soy_cilindro, scene.cylinders().size()},
                                                 {Tipo::soy_cono, scene.cones().size()}};
  for (const auto& [tipo, size] : tables) {
    for (std::uint32_t i = 0; i < size; ++i) {
      if (visit(scene::ElementRef{tipo, i})) return true;
    }
  }
  return false;
}

/// The nearest point so far and the elements it lies on; the elements that have no nearest point.
struct Nearest {
  std::optional<Parameter> t;
  scene::ElementSet elementos, sin_minimo;

  void take(scene::ElementRef e, const Reach& found) {
    if (found.empty()) return;
    if (found.no_minimum()) {
      sin_minimo.push_back(e);
      return;
    }
    const auto against = t ? order(found.first(), *t) : std::strong_ordering::less;
    if (against > 0) return;
    if (against < 0) {
      t = found.first();
      elementos.clear();
    }
    elementos.push_back(e);
  }
};

/// Absent begins stand for t → 0⁺, before every parameter.
bool earlier(const Crossing& a, const Crossing& b) {
  if (!a.segment.begin || !b.segment.begin) {
    return std::pair(a.segment.begin.has_value(), a.elemento) < std::pair(b.segment.begin.has_value(), b.elemento);
  }
  const auto by_begin = order(*a.segment.begin, *b.segment.begin);
  return by_begin != 0 ? by_begin < 0 : a.elemento < b.elemento;
}

}  // namespace

Reach reach(const scene::Scene& scene, scene::ElementRef e, const model::Rayo& rayo, Origin en) {
  const bool on = std::find(en.begin(), en.end(), e) != en.end();
  switch (e.tipo) {
    case Tipo::soy_esfera:
      return reach(coefficients(scene.spheres()[e.index], rayo, on));
    case Tipo::soy_cilindro:
      return reach(coefficients(scene.cylinders()[e.index], rayo, on));
    case Tipo::soy_cono:
      return reach(coefficients(scene.cones()[e.index], rayo, on));
  }
  return {};
}

scene::Hit rounded_hit(const model::Rayo& rayo, const Parameter& t, scene::ElementSet elementos) {
  const auto coordinate = [&](double p, double v) { return number::round_to_binary64(number::linear(p, v, t)); };
  const glm::dvec3& p = rayo.p().xyz();
  const glm::dvec3& v = rayo.v().xyz();
  return {Resultado::hit,
          number::round_to_binary64(t),
          {coordinate(p.x, v.x), coordinate(p.y, v.y), coordinate(p.z, v.z)},
          std::move(elementos)};
}

scene::Hit first_hit(const scene::Scene& scene, const model::Rayo& rayo, Origin en) {
  Nearest nearest;
  any_element(scene, [&](scene::ElementRef e) {
    nearest.take(e, reach(scene, e, rayo, en));
    return false;
  });
  if (!nearest.sin_minimo.empty()) return {.resultado = Resultado::no_minimum, .elementos = nearest.sin_minimo};
  if (!nearest.t) return {};
  return rounded_hit(rayo, *nearest.t, std::move(nearest.elementos));
}

bool occluded(const scene::Scene& scene, const model::Rayo& rayo, Origin en) {
  return any_element(scene, [&](scene::ElementRef e) { return !reach(scene, e, rayo, en).empty(); });
}

bool occluded_segment(const scene::Scene& scene, const model::Rayo& rayo, Origin en) {
  const Parameter one{.x = 1};
  return any_element(scene, [&](scene::ElementRef e) {
    const Reach found = reach(scene, e, rayo, en);
    return found.no_minimum() || (!found.empty() && order(found.first(), one) < 0);
  });
}

std::vector<Crossing> all_hits(const scene::Scene& scene, const model::Rayo& rayo, Origin en) {
  std::vector<Crossing> crossings;
  any_element(scene, [&](scene::ElementRef e) {
    const Reach found = reach(scene, e, rayo, en);
    for (const Parameter& t : found.points()) crossings.push_back({e, {t, t}});
    if (found.segment) crossings.push_back({e, *found.segment});
    return false;
  });
  std::stable_sort(crossings.begin(), crossings.end(), earlier);
  return crossings;
}

}  // namespace durero::oracle::exact
