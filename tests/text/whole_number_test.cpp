// Whole numbers in decimal digits.
#include "durero/text/whole_number.hpp"

#include "support/catch.hpp"

namespace durero::text {
namespace {

TEST_CASE("digits alone are a whole number") {
  CHECK(whole_number("0") == 0);
  CHECK(whole_number("007") == 7);
  CHECK(whole_number("18446744073709551615") == UINT64_MAX);
  for (const char* other : {"", "-1", "+1", " 1", "1 ", "1.0", "1e2", "0x10", "18446744073709551616", "one"}) {
    CAPTURE(other);
    CHECK_FALSE(whole_number(other));
  }
}

}  // namespace
}  // namespace durero::text
