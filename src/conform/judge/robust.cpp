#include "conform/judge/robust.hpp"

#include <cmath>

#include "durero/trace/search.hpp"

namespace durero::conform {
namespace {

using number::sign;

bool has_zero_bound(const ElementQuadratic& c) {
  return std::any_of(c.f.bounds.begin(), c.f.bounds.end(), [](const auto& bound) { return sign(bound.C) == 0; });
}

}  // namespace

Ambiguity weakness(const ElementQuadratic& c, const Parameter& t) {
  const bool is_everywhere_zero = sign(c.f.A) == 0 && sign(c.f.B) == 0 && sign(c.f.C) == 0;
  if (is_everywhere_zero) return Ambiguity::in_surface;
  if (c.is_at_end(t)) return has_apex(c.e.tipo) && c.sign_beyond(t) == 0 ? Ambiguity::apex : Ambiguity::rim;
  if (has_zero_bound(c)) return c.e.tipo == model::Tipo::soy_triangulo ? Ambiguity::edge : Ambiguity::rim;
  return !c.is_flat() && sign(c.f.A) != 0 && sign(c.discriminant()) == 0 ? Ambiguity::tangent : Ambiguity::none;
}

double rounded_up(const Parameter& t) { return std::nextafter(number::round_to_binary64(t), trace::no_limit); }

}  // namespace durero::conform
