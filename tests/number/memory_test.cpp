#include "durero/number/memory.hpp"

#include <new>

#include "durero/number/rational.hpp"
#include "support/catch.hpp"

using namespace durero::number;

TEST_CASE("a number that outgrows memory is an exception, and what is computed afterwards is right") {
  throw_when_numbers_outgrow_memory();
  Integer power = 3;
  const auto square = [&power] { power *= power; };
  const auto grow = [&] {
    for (int i = 0; i < 40; ++i) square();  // 3^(2^40) has some 2^41 bits
  };
  CHECK_THROWS_AS(grow(), std::bad_alloc);
  CHECK_THROWS_AS(Integer(1) << (8 * largest_number + 64), std::bad_alloc);
  CHECK(Rational(1, 3) + Rational(1, 6) == Rational(1, 2));
}
