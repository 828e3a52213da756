#pragma once
/// alcance along a ray, as the Z text itself decides it, an infinite set though it is.
///
/// A point of the ray is p + t·v, t > 0 (puntos_de_rayo.def.1). Evaluated with a t that is not given, the text's
/// predicate compares polynomials in t with 0, and nothing else that depends on t. Between two neighbouring roots none
/// of them changes its sign, so there the predicate is true throughout or false throughout. Whether the text holds at
/// each root, and at one point between each two, therefore says where on the ray it holds.

#include <vector>

#include "durero/spec/spec.hpp"

namespace durero::spec {

/// A set of parameters t > 0: single ones, and open stretches between them.
struct Extent {
  std::vector<number::Surd> at;  ///< ascending: the ends of the stretches
  std::vector<bool> on;          ///< in step: whether at[i] is in the set
  std::vector<bool> between;     ///< one more: the stretches before at[0] (from 0 on), …, and behind the last

  /// Whether it has no member.
  bool empty() const;
  /// The least member; null where there is none.
  const number::Surd* first() const;
  /// True where the set has members and no least one.
  bool no_minimum() const { return !empty() && !first(); }
  /// True where some member is less than the limit.
  bool any_below(const number::Surd& limit) const;
};

/// The t with p + t·v ∈ alcance(θEscena, rayo, en, e). Throws zed::EvaluationError where the text does not let itself
/// be followed so: not for the text of spec/.
Extent alcance(const Judge& judge, const zed::Value& escena, const model::Rayo& rayo,
               const std::set<model::Elemento>& en, const model::Elemento& e);

}  // namespace durero::spec
