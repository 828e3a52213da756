#include "durero/written/surface.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <glm/geometric.hpp>

namespace durero::written {

using algebra::Polynomial;
using algebra::Root;
using number::Dyadic;
using number::DyadicSurd;

namespace {

bool is_equation(const Condition& condition) {
  return condition.kind == Condition::Kind::comparison && condition.signs == Signs{false, true, false};
}

/// The conjuncts of a condition.
std::vector<Condition> conjuncts(const Condition& of) {
  return of.kind == Condition::Kind::all ? of.parts : std::vector{of};
}

Formula first_equation(const Condition& of) {
  const std::vector<Condition> all = conjuncts(of);
  const auto found = std::ranges::find_if(all, is_equation);
  return found == all.end() ? Formula() : found->formula;
}

/// p·(m + n·t) + q
Polynomial horner_step(const Polynomial& p, const Dyadic& m, const Dyadic& n, const Polynomial& q) {
  Polynomial result(std::max(p.empty() ? 0 : p.size() + 1, q.size()));
  std::ranges::copy(q, result.begin());
  for (std::size_t i = 0; i < p.size(); ++i) {
    result[i] += p[i] * m;
    result[i + 1] += p[i] * n;
  }
  return result;
}

double value_at(const Formula& formula, const glm::dvec3& w) {
  double sum = 0;
  for (const auto& [exponents, coefficient] : formula.terms())
    sum += number::round_to_binary64(coefficient) * std::pow(w.x, exponents[0]) * std::pow(w.y, exponents[1]) *
           std::pow(w.z, exponents[2]);
  return sum;
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
}

Polynomial AlongRays::along(const model::Rayo& rayo) const {
  const std::array<Dyadic, 3> p{rayo.p().x(), rayo.p().y(), rayo.p().z()}, v{rayo.v().x(), rayo.v().y(), rayo.v().z()};
  Polynomial whole;
  for (std::size_t i = coefficients_.size(); i-- > 0;) {
    Polynomial in_y;
    for (std::size_t j = coefficients_[i].size(); j-- > 0;) {
      Polynomial in_z;
      const InZ& row = coefficients_[i][j];
      for (std::size_t k = row.size(); k-- > 0;) in_z = horner_step(in_z, p[2], v[2], {row[k]});
      in_y = horner_step(in_y, p[1], v[1], in_z);
    }
    whole = horner_step(whole, p[0], v[0], in_y);
  }
  algebra::normalise(whole);
  return whole;
}

bool Surface::has_equation(const Condition& of) {
  return of.is(false) || std::ranges::any_of(conjuncts(of), is_equation);
}

Surface::Surface(const Condition& of) {
  Condition rest = always(true);
  for (const Condition& conjunct : conjuncts(of)) {
    if (is_equation(conjunct)) {
      equations_.emplace_back(conjunct.formula);
    } else {
      rest = both(std::move(rest), conjunct);
    }
  }
  clips_ = clip_of(rest);
  for (std::size_t axis = 0; axis < gradient_.size(); ++axis) gradient_[axis] = first_equation(of).derivative(axis);
}

Surface::Clip Surface::clip_of(const Condition& condition) {
  Clip clip{condition.kind, condition.truth, comparisons_.size(), {}};
  if (condition.kind == Condition::Kind::comparison)
    comparisons_.push_back({AlongRays(condition.formula), condition.signs});
  for (const Condition& part : condition.parts) clip.parts.push_back(clip_of(part));
  return clip;
}

glm::dvec3 Surface::normal(const glm::dvec3& w) const {
  const glm::dvec3 gradient(value_at(gradient_[0], w), value_at(gradient_[1], w), value_at(gradient_[2], w));
  const double length = glm::length(gradient);
  return length > 0 && std::isfinite(length) ? gradient / length : glm::dvec3(0);
}

/// The polynomials of a surface on one ray, each made when it is first asked for.
class RayOnSurface {
 public:
  RayOnSurface(const Surface& surface, const model::Rayo& rayo, bool starts_on)
      : surface_(surface), rayo_(rayo), comparisons_(surface.comparisons_.size()) {
    for (const AlongRays& equation : surface.equations_) {
      Polynomial p = equation.along(rayo);
      if (starts_on && !p.empty()) {
        p[0] = 0;
        algebra::normalise(p);
      }
      if (!p.empty()) equations_.push_back(std::move(p));
    }
    std::ranges::sort(equations_, {}, &Polynomial::size);
  }

  First first() {
    if (is_nowhere()) return {};
    if (equations_.empty()) return first_of_stretches();
    for (Root& root : algebra::positive_roots(equations_[0]))
      if (is_on(root)) return std::move(root);
    return {};
  }

 private:
  bool is_nowhere() const { return surface_.clips_.kind == Condition::Kind::constant && !surface_.clips_.truth; }

  bool is_on(const Root& root) {
    const auto is_zero = [&](const Polynomial& p) { return algebra::sign_at(p, root) == 0; };
    return std::all_of(equations_.begin() + 1, equations_.end(), is_zero) &&
           holds(surface_.clips_, [&](const Polynomial& p) { return algebra::sign_at(p, root); });
  }

  /// Root by root, and what is before it first.
  First first_of_stretches() {
    const std::vector<Root> ends = ends_of_clips();
    const auto holds_at = [&](const auto& t) {
      return holds(surface_.clips_, [&](const Polynomial& p) { return algebra::sign_at(p, t); });
    };
    for (std::size_t i = 0; i < ends.size(); ++i) {
      const bool is_first = i == 0;
      if (holds_at(is_first ? algebra::below(ends[0]) : algebra::between(ends[i - 1], ends[i])))
        return After{is_first ? std::nullopt : std::optional(ends[i - 1])};
      if (holds_at(ends[i])) return ends[i];
    }
    if (!holds_at(ends.empty() ? Dyadic(1) : algebra::above(ends.back()))) return {};
    return After{ends.empty() ? std::nullopt : std::optional(ends.back())};
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
    if (!comparisons_[i]) comparisons_[i] = surface_.comparisons_[i].polynomial.along(rayo_);
    return *comparisons_[i];
  }

  bool holds(const Surface::Clip& clip, const std::function<int(const Polynomial&)>& sign) {
    const auto part_holds = [&](const Surface::Clip& part) { return holds(part, sign); };
    switch (clip.kind) {
      case Condition::Kind::constant:
        return clip.truth;
      case Condition::Kind::comparison:
        return surface_.comparisons_[clip.comparison].signs.contains(sign(comparison(clip.comparison)));
      case Condition::Kind::all:
        return std::ranges::all_of(clip.parts, part_holds);
      case Condition::Kind::any:
        return std::ranges::any_of(clip.parts, part_holds);
    }
    __builtin_unreachable();  // a kind is one of its enumerators
  }

  const Surface& surface_;
  const model::Rayo& rayo_;
  std::vector<Polynomial> equations_;  // those that are not 0 = 0, the lowest degree first
  std::vector<std::optional<Polynomial>> comparisons_;
};

First Surface::first(const model::Rayo& rayo, bool starts_on) const {
  return RayOnSurface(*this, rayo, starts_on).first();
}

bool Surface::hides(const model::Rayo& rayo, bool starts_on) const {
  const First first = this->first(rayo, starts_on);
  const Root one = DyadicSurd{1};
  if (const auto* const at = std::get_if<Root>(&first)) return algebra::compare(*at, one) < 0;
  const auto* const after = std::get_if<After>(&first);
  return after != nullptr && (!after->t || algebra::compare(*after->t, one) < 0);
}

}  // namespace durero::written
