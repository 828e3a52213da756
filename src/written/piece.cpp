#include <algorithm>
#include <functional>

#include "durero/written/surface.hpp"
#include "rough_roots.hpp"

namespace durero::written {

using algebra::Polynomial;
using algebra::Root;
using number::Dyadic;
using number::RealBall;

namespace {

/// The conjuncts of a condition.
std::vector<Condition> conjuncts(const Condition& of) {
  return of.kind == Condition::Kind::all ? of.parts : std::vector{of};
}

Formula first_equation(const Condition& of) {
  const std::vector<Condition> all = conjuncts(of);
  const auto found = std::ranges::find_if(all, &Condition::is_equation);
  return found == all.end() ? Formula() : found->formula;
}

/// The polynomial p·(m + n·t) + q.
template <class N>
std::vector<N> horner_step(const std::vector<N>& p, const N& m, const N& n, const std::vector<N>& q) {
  std::vector<N> result(std::max(p.empty() ? 0 : p.size() + 1, q.size()), N(0.0));
  std::ranges::copy(q, result.begin());
  for (std::size_t i = 0; i < p.size(); ++i) {
    result[i] = brought_back(result[i] + p[i] * m);
    result[i + 1] = brought_back(result[i + 1] + p[i] * n);
  }
  return result;
}

/// The polynomial in t along a ray, of coefficients [i][j][k] of xⁱ·yʲ·zᵏ.
template <class N>
std::vector<N> restricted(const std::vector<std::vector<std::vector<N>>>& coefficients, const model::Rayo& rayo) {
  const std::array<N, 3> p{N(rayo.p().x()), N(rayo.p().y()), N(rayo.p().z())},
      v{N(rayo.v().x()), N(rayo.v().y()), N(rayo.v().z())};
  std::vector<N> whole;
  for (std::size_t i = coefficients.size(); i-- > 0;) {
    std::vector<N> in_y;
    for (std::size_t j = coefficients[i].size(); j-- > 0;) {
      std::vector<N> in_z;
      const std::vector<N>& row = coefficients[i][j];
      for (std::size_t k = row.size(); k-- > 0;) in_z = horner_step(in_z, p[2], v[2], {row[k]});
      in_y = horner_step(in_y, p[1], v[1], in_z);
    }
    whole = horner_step(whole, p[0], v[0], in_y);
  }
  return whole;
}

/// The formula with the magnitude of each coefficient.
Formula magnitude_of(const Formula& formula) {
  Formula sum;
  for (const auto& [exponents, coefficient] : formula.terms()) {
    Formula term(number::Rational(abs(coefficient)));
    for (std::size_t axis = 0; axis < exponents.size(); ++axis)
      for (int i = 0; i < exponents[axis]; ++i) term = term * Formula::coordinate(axis);
    sum = sum + term;
  }
  return sum;
}

Dyadic magnitude_of(const Dyadic& value) { return sign(value) < 0 ? -value : value; }

/// An upper bound on the distance of a number from its rounding to binary64: half an ulp is 2⁻⁵³ of the number at most
/// where it is normal, and 2⁻¹⁰⁷⁵ where it is not.
Dyadic rounding_of(const Dyadic& value) {
  return number::shifted(magnitude_of(value), -53) + Dyadic(number::Integer(1), -1075);
}

}  // namespace

AlongRays::AlongRays(const Formula& formula) {
  number::Integer common = 1;
  for (const auto& [exponents, coefficient] : formula.terms()) common = lcm(common, denominator(coefficient));
  for (const auto& [exponents, coefficient] : formula.terms()) {
    const auto [i, j, k] = exponents;
    if (coefficients_.size() <= i) coefficients_.resize(i + 1U);
    if (coefficients_[i].size() <= j) coefficients_[i].resize(j + 1U);
    InZ& row = coefficients_[i][j];
    if (row.size() <= k) row.resize(k + 1U);
    row[k] = Dyadic(number::Integer(numerator(coefficient) * (common / denominator(coefficient))), 0);
  }
  for (const auto& in_y : coefficients_) {
    rough_.emplace_back();
    for (const InZ& row : in_y) rough_.back().emplace_back(row.begin(), row.end());
  }
}

Dyadic AlongRays::at(const std::array<Dyadic, 3>& w) const {
  Dyadic whole;
  for (std::size_t i = coefficients_.size(); i-- > 0;) {
    Dyadic in_y;
    for (std::size_t j = coefficients_[i].size(); j-- > 0;) {
      Dyadic in_z;
      const InZ& row = coefficients_[i][j];
      for (std::size_t k = row.size(); k-- > 0;) in_z = in_z * w[2] + row[k];
      in_y = in_y * w[1] + in_z;
    }
    whole = whole * w[0] + in_y;
  }
  return whole;
}

Polynomial AlongRays::along(const model::Rayo& rayo) const {
  Polynomial whole = restricted(coefficients_, rayo);
  algebra::normalise(whole);
  return whole;
}

std::vector<RealBall> AlongRays::roughly_along(const model::Rayo& rayo) const { return restricted(rough_, rayo); }

Piece::Piece(const Condition& of) {
  Condition rest = always(true);
  for (const Condition& conjunct : conjuncts(of)) {
    if (conjunct.is_equation()) {
      equations_.emplace_back(conjunct.formula);
      magnitudes_.emplace_back(magnitude_of(conjunct.formula));
    } else {
      rest = both(std::move(rest), conjunct);
    }
  }
  clips_ = clip_of(rest);
  equation_ = first_equation(of);
  for (std::size_t axis = 0; axis < gradient_.size(); ++axis) gradient_[axis] = equation_.derivative(axis);
}

Piece::Clip Piece::clip_of(const Condition& condition) {
  Clip clip{condition.kind, condition.truth, comparisons_.size(), {}};
  if (condition.kind == Condition::Kind::comparison)
    comparisons_.push_back({AlongRays(condition.formula), condition.signs});
  for (const Condition& part : condition.parts) clip.parts.push_back(clip_of(part));
  return clip;
}

// For p = Σ c·w₁^e₁·w₂^e₂·w₃^e₃ and |dᵢ| ≤ δᵢ, |p(w + d) − p(w)| ≤ P(|w| + δ) − P(|w|) where P has the magnitudes of
// the coefficients: multiplied out, each product that p(w + d) has and p(w) has not stands in the difference with its
// magnitude or more.
bool Piece::may_hold_near(const glm::dvec3& rounded) const {
  std::array<Dyadic, 3> w, size, beyond;
  for (int i = 0; i < 3; ++i) {
    const auto axis = static_cast<std::size_t>(i);
    w[axis] = rounded[i];
    size[axis] = magnitude_of(w[axis]);
    beyond[axis] = size[axis] + rounding_of(w[axis]);
  }
  for (std::size_t i = 0; i < equations_.size(); ++i)
    if (magnitude_of(equations_[i].at(w)) > magnitudes_[i].at(beyond) - magnitudes_[i].at(size)) return false;
  return true;
}

/// The polynomials of a piece on one ray, each made when it is first asked for.
class RayOnPiece {
 public:
  RayOnPiece(const Piece& piece, const model::Rayo& rayo, bool starts_on)
      : piece_(piece), rayo_(rayo), comparisons_(piece.comparisons_.size()) {
    for (const AlongRays& equation : piece.equations_) {
      Polynomial p = equation.along(rayo);
      if (starts_on && !p.empty()) {
        p[0] = 0;
        algebra::normalise(p);
      }
      if (!p.empty()) equations_.push_back(std::move(p));
    }
    std::ranges::sort(equations_, {}, &Polynomial::size);
  }

  std::optional<std::vector<Root>> all(RayPart part) {
    if (is_nowhere()) return std::vector<Root>();
    if (equations_.empty()) return all_of_stretches(part);
    std::vector<Root> roots = algebra::positive_roots(equations_[0]);
    std::erase_if(roots, [&](const Root& root) { return !lies_on(part, root) || !is_on(root); });
    return roots;
  }

  First first() {
    if (is_nowhere()) return {};
    if (equations_.empty()) return first_of_stretches();
    for (Root& root : algebra::positive_roots(equations_[0]))
      if (is_on(root)) return std::move(root);
    return {};
  }

 private:
  bool is_nowhere() const { return piece_.clips_.kind == Condition::Kind::constant && !piece_.clips_.truth; }

  bool is_on(const Root& root) {
    const auto is_zero = [&](const Polynomial& p) { return algebra::sign_at(p, root) == 0; };
    return std::all_of(equations_.begin() + 1, equations_.end(), is_zero) &&
           holds(piece_.clips_, [&](const Polynomial& p) { return algebra::sign_at(p, root); });
  }

  static bool lies_on(RayPart part, const Root& t) {
    return part == RayPart::whole || algebra::compare(t, Root(number::DyadicSurd{1})) < 0;
  }

  template <class T>
  bool holds_at(const T& t) {
    return holds(piece_.clips_, [&](const Polynomial& p) { return algebra::sign_at(p, t); });
  }
  /// Whether the clips hold before the end of that number, or behind the last.
  bool holds_before(const std::vector<Root>& ends, std::size_t i) {
    if (ends.empty()) return holds_at(Dyadic(1));
    if (i == ends.size()) return holds_at(algebra::above(ends.back()));
    return holds_at(i == 0 ? algebra::below(ends[0]) : algebra::between(ends[i - 1], ends[i]));
  }

  /// The first meeting with the piece: at each root in turn, the stretch before it first.
  First first_of_stretches() {
    const std::vector<Root> ends = ends_of_clips();
    for (std::size_t i = 0; i <= ends.size(); ++i) {
      if (holds_before(ends, i)) return After{i == 0 ? std::nullopt : std::optional(ends[i - 1])};
      if (i < ends.size() && holds_at(ends[i])) return ends[i];
    }
    return {};
  }

  /// The points that stand alone on a part of the ray; nothing where a stretch does.
  std::optional<std::vector<Root>> all_of_stretches(RayPart part) {
    const std::vector<Root> ends = ends_of_clips();
    std::vector<Root> alone;
    for (std::size_t i = 0; i <= ends.size(); ++i) {
      if (i > 0 && !lies_on(part, ends[i - 1])) break;
      if (holds_before(ends, i)) return std::nullopt;
      if (i < ends.size() && lies_on(part, ends[i]) && holds_at(ends[i])) alone.push_back(ends[i]);
    }
    return alone;
  }

  std::vector<Root> ends_of_clips() {
    std::vector<Root> ends;
    for (std::size_t i = 0; i < comparisons_.size(); ++i)
      if (const Polynomial& p = comparison(i); !p.empty())
        std::ranges::move(algebra::positive_roots(p), std::back_inserter(ends));
    std::ranges::sort(ends, [](const Root& a, const Root& b) { return algebra::compare(a, b) < 0; });
    const auto repeated =
        std::ranges::unique(ends, [](const Root& a, const Root& b) { return algebra::compare(a, b) == 0; });
    ends.erase(repeated.begin(), repeated.end());
    return ends;
  }

  const Polynomial& comparison(std::size_t i) {
    if (!comparisons_[i]) comparisons_[i] = piece_.comparisons_[i].polynomial.along(rayo_);
    return *comparisons_[i];
  }

  bool holds(const Piece::Clip& clip, const std::function<int(const Polynomial&)>& sign) {
    const auto part_holds = [&](const Piece::Clip& part) { return holds(part, sign); };
    switch (clip.kind) {
      case Condition::Kind::constant:
        return clip.truth;
      case Condition::Kind::comparison:
        return piece_.comparisons_[clip.comparison].signs.contains(sign(comparison(clip.comparison)));
      case Condition::Kind::all:
        return std::ranges::all_of(clip.parts, part_holds);
      case Condition::Kind::any:
        return std::ranges::any_of(clip.parts, part_holds);
    }
    __builtin_unreachable();  // a kind is one of its enumerators
  }

  const Piece& piece_;
  const model::Rayo& rayo_;
  std::vector<Polynomial> equations_;  // the equations other than 0 = 0, the lowest degree first
  std::vector<std::optional<Polynomial>> comparisons_;
};

bool Piece::may_meet(const model::Rayo& rayo, bool starts_on, RayPart part) const {
  return std::ranges::all_of(equations_, [&](const AlongRays& equation) {
    RoughPolynomial polynomial = equation.roughly_along(rayo);
    if (starts_on && !polynomial.empty()) polynomial.erase(polynomial.begin());  // its first coefficient is 0 there
    return may_have_root(polynomial, part);
  });
}

First Piece::first(const model::Rayo& rayo, bool starts_on) const { return RayOnPiece(*this, rayo, starts_on).first(); }

std::optional<std::vector<Root>> Piece::all(const model::Rayo& rayo, bool starts_on, RayPart part) const {
  return RayOnPiece(*this, rayo, starts_on).all(part);
}

}  // namespace durero::written
