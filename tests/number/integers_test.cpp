#include "number/integers.hpp"

#include <vector>

#include "support/catch.hpp"
#include "support/property.hpp"

namespace durero::number {
namespace {

TEST_CASE("an integer goes to the other library and back, of any size and sign") {
  test::property("of up to 300 limbs", [] {
    const auto limbs =
        *rc::gen::container<std::vector<std::uint64_t>>(*rc::gen::resize(100, rc::gen::inRange<std::size_t>(1, 300)),
                                                        rc::gen::resize(100, rc::gen::arbitrary<std::uint64_t>()));
    Integer a = 0;
    Dyadic::Significand b = 0;
    for (const std::uint64_t limb : limbs) a = (a << 64) + limb, b = (b << 64) + limb;
    RC_ASSERT(to_significand(a) == b);
    RC_ASSERT(to_integer(b) == a);
    RC_ASSERT(to_significand(Integer(-a)) == Dyadic::Significand(-b));
    RC_ASSERT(to_integer(Dyadic::Significand(-b)) == -a);
  });
}

TEST_CASE("0, and what is on the edge of one limb") {
  CHECK(to_significand(Integer(0)).is_zero());
  CHECK(to_integer(Dyadic::Significand(0)).is_zero());
  const Integer limb = Integer(1) << 64;
  for (const Integer& value : {Integer(1), Integer(-1), Integer(limb - 1), limb, Integer(-limb)}) {
    CHECK(to_integer(to_significand(value)) == value);
    CHECK(to_significand(value).str() == value.str());
  }
}

}  // namespace
}  // namespace durero::number
