// What a finding promises: the exact parameter lies within its error, whatever step found it.
#include "durero/trace/finding.hpp"

#include "durero/number/quotient.hpp"
#include "durero/surface/exact.hpp"
#include "support/catch.hpp"
#include "support/elements.hpp"
#include "support/property.hpp"
#include "support/sanitized.hpp"
#include "support/shapes.hpp"
#include "trace/steps.hpp"
#include "trace/triage.hpp"

using namespace durero;
using namespace durero::test;
using trace::Decision;
using trace::RootEstimate;

namespace {

/// x, which only the exact arithmetic below looks at.
surface::exact::Parameter exactly(const number::Dyadic& x) { return {.x = x}; }

/// hi + lo ± error lie on both sides of the parameter t, or at it.
bool holds(const RootEstimate& finding, const surface::exact::Parameter& t) {
  const number::Dyadic middle = number::Dyadic(finding.hi) + number::Dyadic(finding.lo), error(finding.error);
  return surface::exact::order(exactly(middle - error), t) <= 0 &&
         surface::exact::order(t, exactly(middle + error)) <= 0;
}

template <class Shape>
void check_steps(const Shape& shape, const model::Rayo& rayo, int& hits) {
  const trace::Ray traced(rayo);
  if (!traced.ordinary || !trace::ordinary(shape)) return;
  const auto reach = surface::exact::reach(surface::exact::coefficients(shape, rayo, false));
  for (const RootEstimate& finding : {triage(shape, traced, false), stable(shape, traced, false)}) {
    if (finding.verdict == Decision::undecided) continue;
    RC_ASSERT((finding.verdict == Decision::hit) == (!reach.empty() && !reach.no_minimum()));
    if (finding.verdict == Decision::miss) continue;
    RC_ASSERT(holds(finding, reach.first()));
    ++hits;
  }
  const RootEstimate first = triage(shape, traced, false);
  if (first.verdict != Decision::hit) return;
  const RootEstimate better = improved(shape, traced, false, first);
  if (better.verdict == Decision::hit) RC_ASSERT(holds(better, reach.first()));
}

void check_shapes(const Reals& numbers, int& hits) {
  const model::Rayo rayo = *rays(numbers);
  for_one_of_each(numbers, [&](const auto& shape) { check_steps(shape, rayo, hits); });
}

}  // namespace

TEST_CASE("the exact parameter lies within the error of a finding") {
  int hits = 0;
  property("ordinary numbers", [&] { check_shapes(moderate(), hits); });
  property("grids", [&] { check_shapes(dyadicGrid(), hits); });
  CHECK(hits > (sanitized ? 0 : 20));
}
