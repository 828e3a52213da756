#pragma once
/// How tightly operators bind in Spivey's Z, where that is otherwise than in ISO's (The Z Notation, chapter 6; fuzz).
/// Schema operations bind less tightly than connectives: A ∧ B ⧹ (x) is (A ∧ B) ⧹ (x).

#include "zed/syntax/connectives.hpp"
#include "zed/syntax/symbols.hpp"

namespace durero::zed::spivey_binding {

inline constexpr int piping = 1, composition = 2, hiding = 3, projection = 4;
static_assert(binding::weakest < piping && projection < binding::equivalence);

/// A connective with the strength that it has there.
constexpr Connective connective(Connective sign) {
  if (sign.kind == Kind::piping) sign.strength = piping;
  if (sign.kind == Kind::composition) sign.strength = composition;
  if (sign.kind == Kind::projection) sign.strength = projection;
  if (sign.kind == Kind::precondition) sign.strength = binding::negation;
  return sign;
}

/// An infix operator with the precedence that it has there: one of six, from left to right, but for the arrows.
constexpr Operator infix(Operator op) {
  if (op.role != Role::function) return op;
  op.precedence -= op.precedence % 10;
  op.right = false;
  return op;
}

}  // namespace durero::zed::spivey_binding
