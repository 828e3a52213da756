#include "durero/io/number_text.hpp"

#include <fmt/format.h>

#include <bit>
#include <cmath>
#include <limits>

#include "support/catch.hpp"
#include "support/doubles.hpp"
#include "support/property.hpp"

using namespace durero;
using io::number_text;
using io::read_number;

namespace {

bool same(double a, double b) { return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b); }

}  // namespace

TEST_CASE("A number reads back from its shortest text, and from C's hexadecimal") {
  test::property("decimal", [] {
    const double x = *test::anyFinite();
    RC_ASSERT(same(read_number(number_text(x)).value(), x));
  });
  test::property("hexadecimal", [] {
    const double x = *test::anyFinite();
    RC_ASSERT(same(read_number(fmt::format("{:a}", x)).value(), x));
  });
  test::property("seventeen digits and an explicit sign", [] {
    const double x = *test::anyFinite();
    RC_ASSERT(same(read_number(fmt::format("{:+.17e}", x)).value(), x));
  });
}

TEST_CASE("No shorter text reads back") {
  test::property("one digit less is another number", [] {
    const double x = *test::anyFinite();
    const std::string text = fmt::format("{:e}", x);
    const std::string digits = number_text(std::abs(x));
    const auto significant = [](std::string s) {
      s = s.substr(0, s.find('e'));
      std::erase(s, '.');
      s.erase(0, std::min(s.find_first_not_of('0'), s.size()));
      while (s.ends_with('0')) s.pop_back();
      return s.size();
    };
    const auto count = static_cast<int>(significant(digits));
    RC_PRE(count > 1);
    RC_ASSERT(!same(read_number(fmt::format("{:.{}e}", x, count - 2)).value(), x));
  });
}

TEST_CASE("Numbers are rounded to nearest, ties to even, at both ends of the range") {
  CHECK(read_number("1e-999").value() == 0);
  CHECK(std::signbit(read_number("-1e-999").value()));
  CHECK(read_number("1e999").value() == std::numeric_limits<double>::infinity());
  CHECK(read_number("-1e999").value() == -std::numeric_limits<double>::infinity());
  CHECK(read_number("4.9e-324").value() == std::numeric_limits<double>::denorm_min());
  CHECK(read_number("2.4703282292062327e-324").value() == 0);  // below half the least
  CHECK(read_number("2.4703282292062328e-324").value() == std::numeric_limits<double>::denorm_min());
  CHECK(read_number("9007199254740993").value() == 9007199254740992);  // a tie, to even
  CHECK(read_number("9007199254740995").value() == 9007199254740996);
  CHECK(read_number("1.7976931348623158e308").value() == std::numeric_limits<double>::max());
  CHECK(std::isinf(read_number("1.7976931348623159e308").value()));
  CHECK(read_number("0x1.00000000000008p0").value() == 1);  // a tie, to even
  CHECK(read_number("0x1.000000000000081p0").value() == 1 + 0x1p-52);
  CHECK(read_number("0x1p-1074").value() == std::numeric_limits<double>::denorm_min());
}

TEST_CASE("Integers are written plain") {
  CHECK(number_text(4) == "4");
  CHECK(number_text(-0.0) == "-0");
  CHECK(number_text(100000) == "100000");
  CHECK(number_text(0.1) == "0.1");
  CHECK(number_text(1e300) == "1e+300");
}

TEST_CASE("What is no number is none") {
  for (const char* text :
       {"", "+", "-", ".", "1x", "1 ", " 1", "--1", "+-1", "0x", "1e", "1,5", "e5", "0xg", "1_000"}) {
    INFO(text);
    CHECK_FALSE(read_number(text).has_value());
  }
}

TEST_CASE("A decimal number is finite and not in hexadecimal") {
  CHECK(io::read_decimal("-1.5e3") == -1500);
  CHECK(io::read_decimal("+.5") == 0.5);
  for (const char* const text : {"0x1p3", "-0X1", "1e999", "inf", "nan", "", "1x", "1,5", " 1"})
    CHECK_FALSE(io::read_decimal(text).has_value());
}
