#pragma once
/// Generators of surds, and their values to 8000 bits.
#include <boost/multiprecision/cpp_bin_float.hpp>

#include "durero/number/dyadic_surd.hpp"
#include "support/doubles.hpp"
#include "support/property.hpp"

namespace durero::test {

/// A binary floating-point number of 8000 bits, which shares no code with the exact arithmetic under test.
using Real = boost::multiprecision::number<
    boost::multiprecision::cpp_bin_float<8000, boost::multiprecision::digit_base_2, void, std::int64_t>,
    boost::multiprecision::et_off>;

/// (x + y√delta)/w from four binary64.
struct SurdParts {
  double x, y, delta, w;

  number::DyadicSurd surd() const { return {.x = x, .y = y, .delta = delta, .w = w}; }
  Real real() const { return (Real(x) + Real(y) * sqrt(Real(delta))) / Real(w); }
  /// A size that |value| would have without cancellation: what a rounding error of `real` is relative to.
  Real size() const { return (abs(Real(x)) + abs(Real(y)) * sqrt(Real(delta))) / abs(Real(w)); }
};

inline std::ostream& operator<<(std::ostream& out, const SurdParts& s) {
  return out << std::hexfloat << "(" << s.x << " + " << s.y << " sqrt(" << s.delta << "))/" << s.w;
}

inline rc::Gen<SurdParts> surdsOf(const rc::Gen<double>& number) {
  return rc::gen::apply(
      [](double x, double y, double delta, double w) {
        return SurdParts{x, y, std::abs(delta), w};
      },
      number, number, number, nonZero(number));
}

/// x ≈ −y√delta to all the bits that a binary64 has: the sum is tiny, or 0.
inline rc::Gen<SurdParts> cancellingSurds(const rc::Gen<double>& number) {
  return rc::gen::map(surdsOf(number), [](SurdParts s) {
    const double x = -s.y * std::sqrt(s.delta);
    return std::isfinite(x) ? SurdParts{x, s.y, s.delta, s.w} : s;
  });
}

inline rc::Gen<SurdParts> anySurd() {
  return rc::gen::oneOf(surdsOf(anyFinite()), surdsOf(moderate()), surdsOf(dyadicGrid()), cancellingSurds(anyFinite()),
                        cancellingSurds(moderate()), cancellingSurds(dyadicGrid()));
}

/// The sign of `value`, a sum of numbers of up to `size`. Each of the few operations errs by 2⁻⁷⁹⁹⁹ of its result, so a
/// value beyond 2⁻⁷⁸⁰⁰ of the size has the right sign. What is nearer to 0 is taken for 0: with operands from 2⁻¹⁰⁷⁴ to
/// 2¹⁰²⁴ sizes reach 2³⁶³² and single terms go down to 2⁻²⁶³⁴, two such terms cancel to 2⁻⁶⁰⁰ of themselves at most,
/// and 3632 + 2634 + 600 < 7800.
inline int sign_of(const Real& value, const Real& size) { return abs(value) <= ldexp(size, -7800) ? 0 : value.sign(); }

}  // namespace durero::test
