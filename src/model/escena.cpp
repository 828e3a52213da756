#include "durero/model/escena.hpp"

#include <algorithm>
#include <ranges>

namespace durero::model {
namespace {

/// dom f, in ascending order.
constexpr auto dom = std::views::keys;

/// Both are ascending and without repetition, so they are the same sets where they are the same sequences.
constexpr auto same = std::ranges::equal;

std::set<Tipo> ran(const std::map<Elemento, Tipo>& f) {
  std::set<Tipo> types;
  for (const auto& [e, t] : f) types.insert(t);
  return types;
}

/// de_que_tipo ∼ ⦇ types ⦈: the elements of these types, in ascending order.
auto of_types(const Escena& s, Tipos types) {
  return s.de_que_tipo | std::views::filter([types](const auto& maplet) { return types.contains(maplet.second); }) |
         dom;
}

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

bool is_of_type(const Escena& s, const Elemento& e, Tipo t) {
  const auto maplet = s.de_que_tipo.find(e);
  return maplet != s.de_que_tipo.end() && maplet->second == t;
}

Judgements inv(const Escena& s) {
  Judgements all{{&Escena_inv_1, same(s.elementos, dom(s.de_que_tipo))}};
  for_each_attribute([&](const auto& attribute) {
    all.push_back({attribute.domain, same(dom(s.*attribute.component), of_types(s, attribute.types))});
  });
  all.push_back({&Escena_inv_7, s.tipos == ran(s.de_que_tipo)});
  all.push_back({&Escena_inv_8, std::ranges::all_of(s.mi_vector | std::views::values, Unitario::contains)});
  return all;
}

Judgements inv_at(const Escena& s, const Elemento& e) {
  const auto type = s.de_que_tipo.find(e);
  const bool typed = type != s.de_que_tipo.end();
  const auto axis = s.mi_vector.find(e);
  Judgements all{{&Escena_inv_1, s.elementos.contains(e) == typed}};
  for_each_attribute([&](const auto& attribute) {
    const bool has_type = typed && attribute.types.contains(type->second);
    all.push_back({attribute.domain, (s.*attribute.component).contains(e) == has_type});
  });
  all.push_back({&Escena_inv_7, !typed || s.tipos.contains(type->second)});
  all.push_back({&Escena_inv_8, axis == s.mi_vector.end() || Unitario::contains(axis->second)});
  return all;
}

}  // namespace durero::model
