#include "pov_polynomial.hpp"

#include <algorithm>

namespace durero::io {

using number::Rational;

std::vector<PovPowers> pov_powers_up_to(int degree) {
  std::vector<PovPowers> all;
  for (int x = degree; x >= 0; --x)
    for (int y = degree - x; y >= 0; --y)
      for (int z = degree - x - y; z >= 0; --z) all.push_back({x, y, z});
  return all;
}

PovPolynomial PovPolynomial::coordinate(std::size_t axis) {
  PovPolynomial made;
  PovPowers powers{};
  powers.at(axis) = 1;
  made.add(powers, 1);
  return made;
}

Rational PovPolynomial::coefficient(const PovPowers& powers) const {
  const auto found = terms_.find(powers);
  return found == terms_.end() ? Rational(0) : found->second;
}

int PovPolynomial::degree() const {
  int greatest = 0;
  for (const auto& [powers, coefficient] : terms_) greatest = std::max(greatest, powers[0] + powers[1] + powers[2]);
  return greatest;
}

void PovPolynomial::add(const PovPowers& powers, const Rational& coefficient) {
  const auto at = terms_.try_emplace(powers, 0).first;
  at->second += coefficient;
  if (at->second == 0) terms_.erase(at);
}

PovPolynomial operator+(const PovPolynomial& a, const PovPolynomial& b) {
  PovPolynomial sum(a);
  for (const auto& [powers, coefficient] : b.terms_) sum.add(powers, coefficient);
  return sum;
}

PovPolynomial operator-(const PovPolynomial& a, const PovPolynomial& b) {
  PovPolynomial difference(a);
  for (const auto& [powers, coefficient] : b.terms_) difference.add(powers, -coefficient);
  return difference;
}

PovPolynomial operator*(const PovPolynomial& a, const PovPolynomial& b) {
  PovPolynomial product;
  for (const auto& [left, factor] : a.terms_)
    for (const auto& [right, other] : b.terms_)
      product.add({left[0] + right[0], left[1] + right[1], left[2] + right[2]}, factor * other);
  return product;
}

PovPolynomial power(const PovPolynomial& base, int exponent) {
  PovPolynomial product(1.0);
  for (int i = 0; i < exponent; ++i) product = product * base;
  return product;
}

namespace {

/// Exact entries of the linear part, by row and column, of which each is the neighbour of the last one.
struct ExactMatrix {
  const glm::dmat3& of;
  Rational entry(int row, int column) const { return number::exact(of[column % 3][row % 3]); }
  /// The cofactor: a minor of cyclic neighbours has its sign.
  Rational cofactor(int row, int column) const {
    return entry(row + 1, column + 1) * entry(row + 2, column + 2) -
           entry(row + 1, column + 2) * entry(row + 2, column + 1);
  }
  Rational determinant() const {
    return entry(0, 0) * cofactor(0, 0) + entry(0, 1) * cofactor(0, 1) + entry(0, 2) * cofactor(0, 2);
  }
};

}  // namespace

bool has_way_back(const PovTransform& by) { return ExactMatrix{by.linear}.determinant() != 0; }

// The point m goes to w = L·m + s, so that m is adj(L)·(w − s) / det(L) by Cramer's rule.
PovPolynomial moved(const PovPolynomial& polynomial, const PovTransform& by) {
  const ExactMatrix matrix{by.linear};
  const Rational determinant = matrix.determinant();
  std::array<PovPolynomial, 3> back;
  for (int axis = 0; axis < 3; ++axis)
    for (int row = 0; row < 3; ++row) {
      PovPolynomial& into = back.at(static_cast<std::size_t>(axis));
      const PovPolynomial way = PovPolynomial::coordinate(static_cast<std::size_t>(row)) - by.shift[row];
      into = into + PovPolynomial(Rational(matrix.cofactor(row, axis) / determinant)) * way;
    }
  PovPolynomial sum;
  for (const auto& [powers, coefficient] : polynomial.terms()) {
    PovPolynomial term(coefficient);
    for (std::size_t axis = 0; axis < back.size(); ++axis) term = term * power(back[axis], powers[axis]);
    sum = sum + term;
  }
  return sum;
}

}  // namespace durero::io
