#include "number/quick_round.hpp"

#include "durero/number/rational.hpp"
#include "support/catch.hpp"
#include "surds.hpp"

namespace durero::number {
namespace {

using test::SurdParts;

TEST_CASE("128 bits round what is not close, and decline the rest") {
  test::property("ordinary roots are rounded", [] {
    const SurdParts s = *test::surdsOf(test::moderate());
    RC_PRE(s.y != 0 && s.delta != 0);
    const auto rounded = quick_round(s.surd());
    RC_ASSERT(rounded.has_value());
    RC_ASSERT(*rounded == round_to_binary64(s.surd()));
  });
  // 1 + 2⁻⁵³ + 2⁻²⁰⁰ and (1 − √(1 + 2⁻²⁰⁰))
  const Dyadic nudge = shifted(Dyadic(1), -200);
  CHECK_FALSE(quick_round({.x = Dyadic(0x1p-53), .y = 1, .delta = 1 + nudge}));
  CHECK_FALSE(quick_round({.x = 1, .y = -1, .delta = 1 + nudge}));
}

TEST_CASE("what is rounded from 128 bits is the number that all bits give") {
  test::property("over the whole range, and where x and y√delta cancel", [] {
    const SurdParts s = *test::anySurd();
    RC_PRE(s.y != 0 && s.delta != 0);
    const auto rounded = quick_round(s.surd());
    RC_CLASSIFY(rounded.has_value(), "rounded");
    if (rounded) RC_ASSERT(*rounded == round_to_binary64(s.surd()));
  });
}

TEST_CASE("a rational number is rounded from 128 bits as GMP's quotient is") {
  test::property("over the whole range, with a root of 0 or a factor of 0", [] {
    const SurdParts s = *test::anySurd();
    RC_PRE(s.x != 0);
    const Dyadic x = Dyadic(s.x) * Dyadic(s.delta + 1), w = Dyadic(s.w) * Dyadic(s.w);
    const double right = round_to_binary64(Rational(x.rational() / w.rational()));
    for (const DyadicSurd& value : {DyadicSurd{x, 0, s.delta, w}, DyadicSurd{x, s.y, 0, w}}) {
      const auto rounded = quick_round(value);
      RC_CLASSIFY(rounded.has_value(), "rounded");
      if (rounded) RC_ASSERT(*rounded == right && std::signbit(*rounded) == std::signbit(right));
      RC_ASSERT(round_to_binary64(value) == right);
    }
  });
  CHECK(quick_round({.x = 8, .w = 2}) == 4.0);
  CHECK_FALSE(quick_round({.x = Dyadic(1) + Dyadic(0x1p-53)}));  // the middle of 1 and the next
}

TEST_CASE("overflow, and the sign of what vanishes") {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  CHECK(quick_round({.y = 1, .delta = shifted(Dyadic(2), 5000)}) == infinity);
  CHECK(quick_round({.y = 1, .delta = shifted(Dyadic(2), 5000), .w = -1}) == -infinity);
  const auto tiny = quick_round({.y = -1, .delta = shifted(Dyadic(2), -5000)});
  REQUIRE(tiny);
  CHECK(*tiny == 0);
  CHECK(std::signbit(*tiny));
}

}  // namespace
}  // namespace durero::number
