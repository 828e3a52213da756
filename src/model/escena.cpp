#include "durero/model/escena.hpp"

#include <algorithm>
#include <initializer_list>

namespace durero::model {
namespace {

template <class Map>
std::set<Elemento> dom(const Map& f) {
  std::set<Elemento> names;
  for (const auto& [e, value] : f) names.insert(names.end(), e);
  return names;
}

std::set<Tipo> ran(const std::map<Elemento, Tipo>& f) {
  std::set<Tipo> types;
  for (const auto& [e, t] : f) types.insert(t);
  return types;
}

bool among(Tipo t, std::initializer_list<Tipo> types) {
  return std::find(types.begin(), types.end(), t) != types.end();
}

/// de_que_tipo ∼ ⦇ types ⦈: the elements of these types.
std::set<Elemento> of_types(const Escena& escena, std::initializer_list<Tipo> types) {
  std::set<Elemento> names;
  for (const auto& [e, t] : escena.de_que_tipo)
    if (among(t, types)) names.insert(names.end(), e);
  return names;
}

constexpr auto soy_esfera = Tipo::soy_esfera;
constexpr auto soy_cilindro = Tipo::soy_cilindro;
constexpr auto soy_cono = Tipo::soy_cono;

}  // namespace

Judgements Init_post(const Escena& after) { return {{&Init_post_1, after.elementos.empty()}}; }

Escena Init() {
  Escena after;
  if (contract::evaluated(contract::cost::normal)) {
    check(inv(after), contract::cost::normal);
    check(Init_post(after), contract::cost::normal);
  }
  return after;
}

Judgements inv(const Escena& s) {
  const bool axes = std::all_of(s.mi_vector.begin(), s.mi_vector.end(),
                                [](const auto& maplet) { return Unitario::contains(maplet.second); });
  return {{&Escena_inv_1, s.elementos == dom(s.de_que_tipo)},
          {&Escena_inv_2, s.elementos == dom(s.mi_centro)},
          {&Escena_inv_3, dom(s.mi_radio) == of_types(s, {soy_esfera, soy_cilindro})},
          {&Escena_inv_4, dom(s.mi_vector) == of_types(s, {soy_cilindro, soy_cono})},
          {&Escena_inv_5, dom(s.mi_altura) == of_types(s, {soy_cilindro, soy_cono})},
          {&Escena_inv_6, dom(s.mi_proporcion) == of_types(s, {soy_cono})},
          {&Escena_inv_7, s.tipos == ran(s.de_que_tipo)},
          {&Escena_inv_8, axes}};
}

Judgements inv_at(const Escena& s, const Elemento& e) {
  const auto type = s.de_que_tipo.find(e);
  const bool typed = type != s.de_que_tipo.end();
  const auto has_type = [&](std::initializer_list<Tipo> types) { return typed && among(type->second, types); };
  const auto axis = s.mi_vector.find(e);
  return {{&Escena_inv_1, s.elementos.contains(e) == typed},
          {&Escena_inv_2, s.elementos.contains(e) == s.mi_centro.contains(e)},
          {&Escena_inv_3, s.mi_radio.contains(e) == has_type({soy_esfera, soy_cilindro})},
          {&Escena_inv_4, s.mi_vector.contains(e) == has_type({soy_cilindro, soy_cono})},
          {&Escena_inv_5, s.mi_altura.contains(e) == has_type({soy_cilindro, soy_cono})},
          {&Escena_inv_6, s.mi_proporcion.contains(e) == has_type({soy_cono})},
          {&Escena_inv_7, !typed || s.tipos.contains(type->second)},
          {&Escena_inv_8, axis == s.mi_vector.end() || Unitario::contains(axis->second)}};
}

void check(const Judgements& judgements, contract::cost price, const std::string& about) {
  for (const Judgement& judgement : judgements)
    contract::check(
        *judgement.what, [&] { return judgement.holds; }, [&] { return about; }, price);
}

bool all_hold(const Judgements& judgements) noexcept {
  return std::all_of(judgements.begin(), judgements.end(), [](const Judgement& j) { return j.holds; });
}

}  // namespace durero::model
