#pragma once
/// Bounds of the parameter of a finding, and whether one parameter is certainly less than another
/// (proofs/ParameterBounds.v). The functions are templates over double and over the symbolic numbers that write
/// proofs/Formas.v.

#include <cmath>

namespace durero::trace {

/// A lower and an upper bound of a parameter.
template <class R>
struct ParameterBounds {
  R low, high;
};

/// The bounds of a root by the triage. They may be rounded, because the triage's error exceeds its need by three
/// roundings of t (`quotient`).
template <class R>
ParameterBounds<R> ends_of(R t, R error) {
  return {t - error, t + error};
}

/// The bounds of a root hi + lo in double-double: |lo| ≤ ulp(hi)/2, for which the last term pays.
template <class R>
ParameterBounds<R> ends_of_pair(R hi, R error) {
  using std::abs;
  return ends_of<R>(hi, error + 0x1p-51 * abs(hi));
}

/// Whether the root a is certainly less than b, both in double-double. The difference of the leading parts is exact
/// where they are close, which is where it matters; both errors exceed their need by more than a rounding of the lower
/// parts.
template <class Root>
auto certainly_less(const Root& a, const Root& b) {
  return (b.hi - a.hi) + (b.lo - a.lo) > 1.0000001 * (a.error + b.error);
}

}  // namespace durero::trace
