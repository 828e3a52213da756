#include "durero/written/surface.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace durero::written {

using algebra::Root;
using number::DyadicSurd;

namespace {

/// The pieces whose union the condition is, each with an equation; nothing where some part has none. They are no more
/// than its parts.
std::optional<std::vector<Condition>> pieces_of(const Condition& of);

std::optional<std::vector<Condition>> pieces_of_each(const std::vector<Condition>& sides) {
  std::vector<Condition> all;
  for (const Condition& side : sides) {
    const auto pieces = pieces_of(side);
    if (!pieces) return std::nullopt;
    all.insert(all.end(), pieces->begin(), pieces->end());
  }
  return all;
}

/// (p ∨ q) ∧ r is p ∧ r ∨ q ∧ r, for the first ∨ each of whose sides has an equation.
std::optional<std::vector<Condition>> distributed(const std::vector<Condition>& conjuncts) {
  for (std::size_t i = 0; i < conjuncts.size(); ++i) {
    if (conjuncts[i].kind != Condition::Kind::any) continue;
    auto pieces = pieces_of(conjuncts[i]);
    if (!pieces) continue;
    for (Condition& piece : *pieces)
      for (std::size_t j = 0; j < conjuncts.size(); ++j)
        if (j != i) piece = both(std::move(piece), conjuncts[j]);
    return pieces;
  }
  return std::nullopt;
}

std::optional<std::vector<Condition>> pieces_of(const Condition& of) {
  switch (of.kind) {
    case Condition::Kind::constant:
      return of.truth ? std::nullopt : std::optional(std::vector{of});
    case Condition::Kind::comparison:
      return of.is_equation() ? std::optional(std::vector{of}) : std::nullopt;
    case Condition::Kind::all:
      return std::ranges::any_of(of.parts, &Condition::is_equation) ? std::optional(std::vector{of})
                                                                    : distributed(of.parts);
    case Condition::Kind::any:
      return pieces_of_each(of.parts);
  }
  __builtin_unreachable();  // a kind is one of its enumerators
}

/// xⁿ, rounded once: the power of a library of C is near that, and another on another machine. A square is one product.
double rounded_power(double x, unsigned n) {
  if (!std::isfinite(x)) return std::pow(x, n);
  if (n < 3) return n == 0 ? 1 : n == 1 ? x : x * x;
  const number::Dyadic base = x;
  number::Dyadic product = base;
  for (unsigned i = 1; i < n; ++i) product *= base;
  return number::round_to_binary64(product);
}

double value_at(const Formula& formula, const glm::dvec3& w) {
  double sum = 0;
  for (const auto& [exponents, coefficient] : formula.terms())
    sum += number::round_to_binary64(coefficient) * rounded_power(w.x, exponents[0]) *
           rounded_power(w.y, exponents[1]) * rounded_power(w.z, exponents[2]);
  return sum;
}

glm::dvec3 gradient_at(const Piece& piece, const glm::dvec3& w) {
  const auto& gradient = piece.gradient();
  return {value_at(gradient[0], w), value_at(gradient[1], w), value_at(gradient[2], w)};
}

/// The distance of a point from the piece, to the first order and to some digits.
double distance_from(const Piece& piece, const glm::dvec3& w) {
  const double distance = std::abs(value_at(piece.equation(), w)) / glm::length(gradient_at(piece, w));
  return std::isnan(distance) ? HUGE_VAL : distance;
}

/// The value at a point, exact but for its last rounding.
double value_at(const Formula& formula, const std::array<number::Dyadic, 3>& w) {
  number::Rational sum(0);
  for (const auto& [exponents, coefficient] : formula.terms()) {
    number::Dyadic product(1);
    for (std::size_t axis = 0; axis < w.size(); ++axis)
      for (int i = 0; i < exponents[axis]; ++i) product *= w[axis];
    sum += coefficient * product.rational();
  }
  return number::round_to_binary64(sum);
}

/// Whether the first meeting a is before b. At one t a point is before a stretch that begins there, as the stretch does
/// not contain it.
bool is_before(const First& a, const First& b) {
  const auto* const root_a = std::get_if<Root>(&a);
  const auto* const root_b = std::get_if<Root>(&b);
  const auto* const from_a = std::get_if<After>(&a);
  const auto* const from_b = std::get_if<After>(&b);
  if (!root_a && !from_a) return false;
  if (!root_b && !from_b) return true;
  if (from_a && !from_a->t) return true;
  if (from_b && !from_b->t) return false;
  const auto order = algebra::compare(root_a ? *root_a : *from_a->t, root_b ? *root_b : *from_b->t);
  return order < 0 || (order == 0 && root_a && from_b);
}

/// Whether there is a point at some 0 < t < 1.
bool is_before_one(const First& first) {
  const Root one = DyadicSurd{1};
  if (const auto* const at = std::get_if<Root>(&first)) return algebra::compare(*at, one) < 0;
  const auto* const after = std::get_if<After>(&first);
  return after != nullptr && (!after->t || algebra::compare(*after->t, one) < 0);
}

}  // namespace

std::size_t Surface::pieces(const Condition& of) {
  const auto pieces = pieces_of(of);
  return pieces ? pieces->size() : 0;
}

Surface::Surface(const Condition& of) {
  const std::vector<Condition> pieces = pieces_of(of).value();
  for (const Condition& piece : pieces) pieces_.emplace_back(piece);
}

bool Surface::starts_here(const Piece& piece, const model::Rayo& rayo, bool starts_on) const {
  return starts_on && (pieces_.size() == 1 || piece.may_hold_near(rayo.p().xyz()));
}

First Surface::first(const model::Rayo& rayo, bool starts_on) const {
  First nearest;
  for (const Piece& piece : pieces_) {
    const bool on = starts_here(piece, rayo, starts_on);
    if (!piece.may_meet(rayo, on, RayPart::whole)) continue;
    First here = piece.first(rayo, on);
    if (is_before(here, nearest)) nearest = std::move(here);
  }
  return nearest;
}

bool Surface::hides(const model::Rayo& rayo, bool starts_on) const {
  return std::ranges::any_of(pieces_, [&](const Piece& piece) {
    const bool on = starts_here(piece, rayo, starts_on);
    return piece.may_meet(rayo, on, RayPart::to_one) && is_before_one(piece.first(rayo, on));
  });
}

std::optional<std::vector<Root>> Surface::parameters(const model::Rayo& rayo, bool starts_on, RayPart part) const {
  std::vector<Root> met;
  for (const Piece& piece : pieces_) {
    const bool on = starts_here(piece, rayo, starts_on);
    if (!piece.may_meet(rayo, on, part)) continue;
    auto here = piece.all(rayo, on, part);
    if (!here) return std::nullopt;
    std::ranges::move(*here, std::back_inserter(met));
  }
  std::ranges::sort(met, [](const Root& a, const Root& b) { return algebra::compare(a, b) < 0; });
  const auto again = std::ranges::unique(met, [](const Root& a, const Root& b) { return algebra::compare(a, b) == 0; });
  met.erase(again.begin(), again.end());
  return met;
}

std::size_t Surface::degree() const {
  std::size_t sum = 0;
  for (const Piece& piece : pieces_) sum += static_cast<std::size_t>(piece.equation().degree());
  return sum;
}

double Surface::distance(const std::array<number::Dyadic, 3>& w) const {
  const auto rounded = [](const number::Dyadic& x) { return number::round_to_binary64(x); };
  const glm::dvec3 near(rounded(w[0]), rounded(w[1]), rounded(w[2]));
  double least = HUGE_VAL;
  for (const Piece& piece : pieces_) {
    const double value = value_at(piece.equation(), w), slope = glm::length(gradient_at(piece, near));
    least = std::min(least, value == 0 ? 0 : std::abs(value) / slope);
  }
  return least;
}

glm::dvec3 Surface::normal(const glm::dvec3& w) const {
  const auto nearest =
      std::ranges::min_element(pieces_, {}, [&](const Piece& piece) { return distance_from(piece, w); });
  const glm::dvec3 gradient = gradient_at(*nearest, w);
  const double length = glm::length(gradient);
  return length > 0 && std::isfinite(length) ? gradient / length : glm::dvec3(0);
}

}  // namespace durero::written
