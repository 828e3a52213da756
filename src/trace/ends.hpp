#pragma once
/// Between which ends the parameter of a finding lies, and whether one is certainly less than another: over double, and
/// over what writes proofs/Formas.v. That it is so is proved, proofs/Ends.v.

#include <cmath>

namespace durero::trace {

/// No more than a parameter, and no less.
template <class R>
struct Ends {
  R low, high;
};

/// Of a root by the triage, whose error is more than three roundings of t more than needed (`quotient`): so the ends
/// may be rounded.
template <class R>
Ends<R> ends_of(R t, R error) {
  return {t - error, t + error};
}

/// Of a root hi + lo in double-double: |lo| ≤ ulp(hi)/2, and the last term pays.
template <class R>
Ends<R> ends_of_pair(R hi, R error) {
  using std::abs;
  return ends_of<R>(hi, error + 0x1p-51 * abs(hi));
}

/// The root a in double-double is certainly less than b. The leading parts' difference is exact where it matters, where
/// they are close; both errors are more than a rounding of the lower parts more than needed.
template <class Root>
auto certainly_less(const Root& a, const Root& b) {
  return (b.hi - a.hi) + (b.lo - a.lo) > 1.0000001 * (a.error + b.error);
}

}  // namespace durero::trace
