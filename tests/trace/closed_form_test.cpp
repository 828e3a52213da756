// The bounds with which the steps pass errors on, measured where they are tightest: every operand is off by the whole
// of its own error, this way or that. tests/conform/bounds_test.cpp measures them on rays, where errors are far from
// that.
#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>

#include "durero/conform/random.hpp"
#include "support/catch.hpp"
#include "support/exact_ratio.hpp"
#include "trace/closed_form-inl.hpp"
#include "trace/rounding-inl.hpp"

using namespace durero;
using namespace durero::test;
namespace steps = trace::HWY_NAMESPACE;
using conform::Random;
using steps::DoubleDouble;
using trace::Decision;

namespace {

Dyadic exact(double x) { return x; }
Dyadic exact(const DoubleDouble& x) { return Dyadic(x.hi) + Dyadic(x.lo); }

/// Any number of that type, of magnitude 1/16 to 16, all its bits in use.
template <class T>
T any(Random& random) {
  const double hi = random.number(-4, 3);
  if constexpr (std::is_same_v<T, double>) {
    return hi;
  } else {
    return steps::two_sum(hi, hi * random.uniform(-0x1p-54, 0x1p-54));
  }
}

/// An error: none, or a part of the size.
double any_error(Random& random, double size) { return random.chance(1, 4) ? 0 : size * random.signed_power(-40, -3); }

/// The worst ratios by name.
class Worst_Ratios {
 public:
  void note(const std::string& name, double ratio) { worst_[name] = std::max(worst_[name], ratio); }
  void check() const {
    for (const auto& [name, ratio] : worst_) {
      fmt::print("worst |computed − exact|/bound, operands off by their whole errors: {:32} {:.4f}\n", name, ratio);
      INFO(name);
      CHECK(ratio <= 1);
    }
  }

 private:
  std::map<std::string, double> worst_;
};

template <class T>
void measure_quotient(Random& random, const std::string& step, Worst_Ratios& worst) {
  const T x = any<T>(random), y = any<T>(random);
  const double off_x = any_error(random, steps::leading(x)), off_y = any_error(random, steps::leading(y));
  const auto root = steps::quotient(x, std::abs(off_x), y, std::abs(off_y));
  const Fraction meant{exact(x) + Dyadic(off_x), exact(y) + Dyadic(off_y)};
  const double ratio = meant.ratio(exact(root.t), root.error);
  worst.note(step + (off_x == 0 && off_y == 0 ? " quotient, rounding alone" : " quotient"), ratio);
}

/// D = F·H, where both are off by B_error.
template <class T>
void measure_root(Random& random, const std::string& step, Worst_Ratios& worst) {
  steps::BoundedQuadratic<T> f;
  f.F = any<T>(random);
  f.H = any<T>(random);
  if (steps::leading(f.F) < 0) f.F = -f.F;
  if (steps::leading(f.H) < 0) f.H = -f.H;
  if (steps::leading(f.F) > steps::leading(f.H)) std::swap(f.F, f.H);
  f.B_error = random.chance(1, 4) ? 0 : steps::leading(f.F) * random.uniform(0, 1);
  if (random.chance(1, 2)) f.B_error *= random.signed_power(-40, 0);
  f.B_error = std::abs(f.B_error);
  const Dyadic off(random.sign() * f.B_error);
  const Dyadic D = (exact(f.F) + off) * (exact(f.H) + off);
  if (number::sign(D) < 0) return;
  const auto S = steps::root_of_discriminant(f);
  worst.note(step + (f.B_error == 0 ? " root of D, rounding alone" : " root of D"),
             ratio(exact(S.value) - root(D), S.error));
}

template <class T>
void measure_sum(Random& random, const std::string& step, Worst_Ratios& worst) {
  steps::BoundedQuadratic<T> f;
  f.B = any<T>(random);
  const T S = any<T>(random);
  const steps::Approximation<T> root_of_D{steps::leading(S) < 0 ? T(-S) : S, std::abs(any_error(random, 1))};
  const double off = any_error(random, 1);
  f.B_error = std::abs(off);
  const auto sum = steps::stable_sum(f, root_of_D);
  const Dyadic off_S = exact(off < 0 ? -root_of_D.error : root_of_D.error);
  const Dyadic q =
      -(exact(f.B) + Dyadic(off)) - (sum.positive ? exact(root_of_D.value) + off_S : -(exact(root_of_D.value) + off_S));
  worst.note(step + (off == 0 && root_of_D.error == 0 ? " B + S, rounding alone" : " B + S"),
             ratio(exact(sum.q.value) - q, sum.q.error));
}

/// The ray starts on the element: the root −2B/A, and the slope −B there.
template <class T>
void measure_from_surface(Random& random, const std::string& step, Worst_Ratios& worst) {
  steps::BoundedQuadratic<T> f;
  f.A = any<T>(random);
  f.B = any<T>(random);
  const double off_A = any_error(random, steps::leading(f.A)), off_B = any_error(random, steps::leading(f.B));
  f.A_error = std::abs(off_A);
  f.B_error = std::abs(off_B);
  const auto found = steps::first_from_surface(f, trace::no_limit);
  if (found.verdict != Decision::hit) return;
  const Dyadic A = exact(f.A) + Dyadic(off_A), B = exact(f.B) + Dyadic(off_B);
  worst.note(step + " root from the surface", Fraction{shifted(-B, 1), A}.ratio(exact(found.root.t), found.root.error));
  if constexpr (std::is_same_v<T, double>) {
    worst.note(step + " slope from the surface", ratio(Dyadic(found.slope) + B, Dyadic(found.slope_error)));
  }
}

template <class T>
void measure_advance(Random& random, const std::string& step, Worst_Ratios& worst) {
  steps::BoundedQuadratic<T> f;
  f.s0 = any<T>(random);
  f.s1 = any<T>(random);
  f.speed = steps::magnitude(f.s1);
  f.reach = steps::magnitude(f.s0);
  const T t = any<T>(random);
  const double off = any_error(random, 1);
  const auto s = steps::advance(f, steps::Root<T>{t, std::abs(off)});
  const Dyadic meant = exact(f.s0) + exact(f.s1) * (exact(t) + Dyadic(off));
  worst.note(step + " advance", ratio(exact(s.value) - meant, s.error));
}

/// A·t² + 2B·t + C with a root at t + δ, where A·(t + δ) + B = σ: its value at t is −2σδ + Aδ².
void measure_newton(Random& random, Worst_Ratios& worst) {
  const double sigma = any<double>(random), A = any<double>(random), t = any<double>(random);
  const double delta = any_error(random, t), off_A = any_error(random, A), off_sigma = any_error(random, sigma);
  const double off_f = any_error(random, delta == 0 ? 1 : delta);
  const Dyadic meant_sigma = Dyadic(sigma) + Dyadic(off_sigma), meant_A = Dyadic(A) + Dyadic(off_A);
  const Dyadic value = shifted(-(meant_sigma * Dyadic(delta)), 1) + meant_A * square(Dyadic(delta)) + Dyadic(off_f);
  const double hi = number::round_to_binary64(value), lo = number::round_to_binary64(value - Dyadic(hi));
  const Dyadic lost = magnitude(value - Dyadic(hi) - Dyadic(lo));
  const double error = std::abs(off_f) + 2 * number::round_to_binary64(lost);
  const auto better = steps::newton<double>({t, std::abs(delta)}, {sigma, std::abs(off_sigma)}, {A, std::abs(off_A)},
                                            {{hi, lo}, error});
  if (!better.known) return;
  worst.note("improved root", ratio(exact(better.t) - Dyadic(t) - Dyadic(delta), better.error));
}

/// p + t·v, where t is off by its whole error, or where its error is none.
void measure_coordinate(Random& random, Worst_Ratios& worst) {
  const double p = random.number(-34, 33), v = any<double>(random);
  const DoubleDouble t = any<DoubleDouble>(random);
  const double off = any_error(random, t.hi);
  const auto at = steps::coordinate<double>(p, v, t, std::abs(off));
  worst.note(off == 0 ? "coordinate, rounding alone" : "coordinate",
             ratio(exact(at.value) - Dyadic(p) - Dyadic(v) * (exact(t) + Dyadic(off)), at.error));
}

/// Rounding is certain up to an error e, found by halving; truly so up to d, the way to the nearest middle. Of what it
/// keeps back beyond the error, 10⁻⁷e + 2⁻⁵²|lo|, the part that it may not do without.
void measure_rounding(Random& random, Worst_Ratios& worst) {
  const double hi = random.uniform(1, 2) + 1, half = 0x1p-52;  // half an ulp, of numbers in [2, 4)
  const double short_by = std::abs(random.number(-52, -1));
  const double lo = random.sign() * half * (1 - short_by);
  const auto certain = [&](double error) { return steps::round_once<double>({hi, lo}, error).certain; };
  double low = 0, high = half;
  if (!certain(low)) return;
  while (std::nextafter(low, high) < high) {
    const double middle = low + (high - low) / 2;
    (certain(middle) ? low : high) = middle;
  }
  const Dyadic kept = Dyadic(0.0000001) * Dyadic(low) + Dyadic(0x1p-52) * Dyadic(std::abs(lo));
  const Dyadic d = Dyadic(half) - Dyadic(std::abs(lo));
  worst.note("rounding", 1 - ratio(d - Dyadic(low), kept) * (d < Dyadic(low) ? -1 : 1));
}

}  // namespace

TEST_CASE("errors passed on are bounded, where every operand is off by its whole error") {
  Random random(1);
  Worst_Ratios worst;
  for (int i = 0; i < 20000; ++i) {
    measure_quotient<double>(random, "triage", worst);
    measure_quotient<DoubleDouble>(random, "stable", worst);
    measure_root<double>(random, "triage", worst);
    measure_root<DoubleDouble>(random, "stable", worst);
    measure_sum<double>(random, "triage", worst);
    measure_sum<DoubleDouble>(random, "stable", worst);
    measure_from_surface<double>(random, "triage", worst);
    measure_from_surface<DoubleDouble>(random, "stable", worst);
    measure_advance<double>(random, "triage", worst);
    measure_advance<DoubleDouble>(random, "stable", worst);
    measure_newton(random, worst);
    measure_coordinate(random, worst);
    measure_rounding(random, worst);
  }
  worst.check();
}

TEST_CASE("constants that no measurement comes near are no less than what is derived beside them") {
  CHECK(steps::coefficient_units >= 40);         // F and H, the greatest
  CHECK(steps::advance_units >= 6);              // of |q| and of |t|V
  CHECK(steps::quotient_units >= 1 + 3);         // a rounding, and three for the caller
  CHECK(steps::power_error >= 1452 * 0x1p-106);  // 1200u² and 2·(6 + 12·10)u²
}
