// Each operation on double-doubles errs by no more than the comment of the header says: random operands, and from the
// worst of them by climbing to worse ones.
#include <fmt/core.h>

#include <cmath>

#include "durero/conform/random.hpp"
#include "support/catch.hpp"
#include "support/exact_ratio.hpp"
#include "trace/double_double-inl.hpp"
#include "trace/numbers-inl.hpp"

using namespace durero;
using namespace durero::test;
namespace steps = trace::HWY_NAMESPACE;
using conform::Random;
using steps::DoubleDouble;

namespace {

struct Operands {
  DoubleDouble a, b;
};

Dyadic exact(const DoubleDouble& x) { return Dyadic(x.hi) + Dyadic(x.lo); }

/// hi + lo with |lo| ≤ ulp(hi)/2, most often close to it.
DoubleDouble any(Random& random) {
  const double hi = random.number(-2, 2), part = random.uniform(-1, 1);
  return steps::two_sum(hi, std::ldexp(hi * part, random.chance(1, 2) ? -53 : -90));
}

/// One number a little or much changed.
DoubleDouble changed(Random& random, const DoubleDouble& x) {
  const double hi = x.hi * (1 + random.signed_power(-52, -1));
  const double lo = x.lo + x.hi * random.signed_power(-106, -53);
  switch (random.below(3)) {
    case 0:
      return steps::two_sum(hi, x.lo);
    case 1:
      return steps::two_sum(x.hi, lo);
    case 2:
      return steps::two_sum(hi, lo);
  }
  return x;
}

/// |computed − meant|/(u²·|meant|), u = 2⁻⁵³, of one operation.
struct Operation {
  const char* name;
  double most;  ///< as the header has it
  double (*error)(const Operands&);
};

double in_units(const DoubleDouble& computed, const Fraction& meant) {
  if (number::sign(meant.n) == 0) return 0;
  return ratio(exact(computed) * meant.w - meant.n, magnitude(meant.n)) * 0x1p106;
}

const Operation operations[] = {
    {"sum", 3,
     [](const Operands& x) {
       return in_units(x.a + x.b, {exact(x.a) + exact(x.b), 1});
     }},
    {"product", 8,
     [](const Operands& x) {
       return in_units(x.a * x.b, {exact(x.a) * exact(x.b), 1});
     }},
    {"product by a double", 8,
     [](const Operands& x) {
       return in_units(x.a * x.b.hi, {exact(x.a) * Dyadic(x.b.hi), 1});
     }},
    {"quotient", 13,
     [](const Operands& x) {
       return in_units(x.a / x.b, {exact(x.a), exact(x.b)});
     }},
    {"square root", 6,
     [](const Operands& x) {
       const DoubleDouble a = x.a.hi < 0 ? -x.a : x.a;
       return in_units(steps::sqrt(a), {root(exact(a)), 1});
     }},
};

/// The worst error found.
double worst(const Operation& operation, Random& random) {
  double highest = 0;
  Operands at;
  const auto try_out = [&](const Operands& x) {
    if (const double error = operation.error(x); error >= highest) highest = error, at = x;
  };
  for (int i = 0; i < 20000; ++i) {
    const DoubleDouble a = any(random);
    try_out({a, any(random)});
  }
  for (int i = 0; i < 40000; ++i) {
    const DoubleDouble a = changed(random, at.a);
    try_out({a, random.chance(1, 2) ? at.b : changed(random, at.b)});
  }
  return highest;
}

}  // namespace

TEST_CASE("each operation on double-doubles errs by no more than its units") {
  for (const Operation& operation : operations) {
    Random random(1);
    const double found = worst(operation, random);
    fmt::print("double-double {:20} errs by {:.3f} units of u^2 at worst, of {}\n", operation.name, found,
               operation.most);
    INFO(operation.name);
    CHECK(found <= operation.most);
    CHECK(operation.most * 0x1p-106 <= steps::Numbers<DoubleDouble>::roundoff);
  }
}
