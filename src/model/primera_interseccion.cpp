// The closest intersection, with its clauses.

#include <algorithm>

#include "durero/model/escena.hpp"
#include "durero/model/interseccion.hpp"

namespace durero::model {
namespace {

using Reaches = std::map<Elemento, Alcance>;

bool is_empty(const Reaches& all) {
  return std::all_of(all.begin(), all.end(), [](const auto& reach) { return reach.second.parameters.is_empty(); });
}

/// { e : elementos | punto! ∈ alcance(θEscena, rayo?, en?, e) }
std::set<Elemento> those_that_contain(const Reaches& all, const ExactPoint& punto) {
  std::set<Elemento> those;
  for (const auto& [e, reach] : all)
    if (reach.puntos.contains(punto)) those.insert(e);
  return those;
}

/// { e : elementos | alcance(…, e) ≠ ∅ ∧ (alcance(…, e), rayo?.p) ∉ dom reduccion }
std::set<Elemento> those_without_minimum(const Reaches& all) {
  std::set<Elemento> those;
  for (const auto& [e, reach] : all)
    if (!reach.parameters.is_empty() && !reach.parameters.minimum()) those.insert(e);
  return those;
}

Reaches reaches(const Escena& escena, const Pregunta& in) { return alcances(escena, in.rayo, in.en); }

}  // namespace

Judgements pre(const Escena& escena, const Pregunta& in) {
  const auto& all = escena.elementos;
  return {{&Pregunta_pre_1, std::includes(all.begin(), all.end(), in.en.begin(), in.en.end())}};
}

template <>
Judgements pre<Hay_Interseccion>(const Escena& escena, const Pregunta& in) {
  return {{&Hay_Interseccion_pre_1, reduccion(reaches(escena, in)).has_value()}};
}

template <>
Judgements pre<No_Hay_Interseccion>(const Escena& escena, const Pregunta& in) {
  return {{&No_Hay_Interseccion_pre_1, is_empty(reaches(escena, in))}};
}

template <>
Judgements pre<No_Hay_Minimo>(const Escena& escena, const Pregunta& in) {
  const Reaches all = reaches(escena, in);
  return {{&No_Hay_Minimo_pre_1, !is_empty(all)}, {&No_Hay_Minimo_pre_2, !reduccion(all)}};
}

Judgements post(const Escena& escena, const Pregunta& in, const Hay_Interseccion& out) {
  const Reaches all = reaches(escena, in);
  const auto nearest = reduccion(all);
  const ExactVector v(in.rayo.v());
  return {{&Hay_Interseccion_post_1, nearest && out.punto == along(in.rayo.p(), v, *nearest)},
          {&Hay_Interseccion_post_2, out.t > 0 && out.punto == along(in.rayo.p(), v, out.t)},  // t! : Rmas
          {&Hay_Interseccion_post_3, out.elementos == those_that_contain(all, out.punto)},
          {&Hay_Interseccion_post_4, out.resultado == Resultado::hit}};
}

Judgements post(const Escena&, const Pregunta&, const No_Hay_Interseccion& out) {
  return {{&No_Hay_Interseccion_post_1, out.elementos.empty()},
          {&No_Hay_Interseccion_post_2, out.resultado == Resultado::miss}};
}

Judgements post(const Escena& escena, const Pregunta& in, const No_Hay_Minimo& out) {
  return {{&No_Hay_Minimo_post_1, out.elementos == those_without_minimum(reaches(escena, in))},
          {&No_Hay_Minimo_post_2, out.resultado == Resultado::no_minimum}};
}

std::variant<Hay_Interseccion, No_Hay_Interseccion, No_Hay_Minimo> Primera_Interseccion(const Escena& escena,
                                                                                        const Pregunta& in) {
  const auto checked = [&](auto out) {
    if (contract::evaluated(contract::cost::normal)) check(post(escena, in, out), contract::cost::normal);
    return out;
  };
  if (contract::evaluated(contract::cost::normal)) check(pre(escena, in), contract::cost::normal);

  const Reaches all = reaches(escena, in);
  if (const auto t = reduccion(all)) {
    const ExactPoint punto = along(in.rayo.p(), in.rayo.v(), *t);
    std::set<Elemento> those;
    for (const auto& [e, reach] : all)
      if (reach.parameters.contains(*t)) those.insert(e);
    return checked(Hay_Interseccion{Resultado::hit, std::move(those), *t, punto});
  }
  if (is_empty(all)) return checked(No_Hay_Interseccion{Resultado::miss, {}});
  return checked(No_Hay_Minimo{Resultado::no_minimum, those_without_minimum(all)});
}

}  // namespace durero::model
