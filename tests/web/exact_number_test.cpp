#include "web/exact_number.hpp"

#include <fmt/format.h>

#include "durero/number/surd.hpp"
#include "support/catch.hpp"
#include "support/property.hpp"

namespace durero::web {
namespace {

using number::Dyadic;
using number::DyadicSurd;

DyadicSurd number_of(double x, double y = 0, double delta = 0, double w = 1) {
  return {Dyadic(x), Dyadic(y), Dyadic(delta), Dyadic(w)};
}

TEST_CASE("digits are forty, truncated, and marked where others follow") {
  CHECK(digits_of(number_of(0)) == "0");
  CHECK(digits_of(number_of(4)) == "4");
  CHECK(digits_of(number_of(-1200)) == "-1200");
  CHECK(digits_of(number_of(0.1)) == "0.1000000000000000055511151231257827021181…");
  CHECK(digits_of(number_of(1, 0, 0, 3)) == "0." + std::string(40, '3') + "…");
  CHECK(digits_of(number_of(-2, 0, 0, 3)) == "-0." + std::string(40, '6') + "…");
  CHECK(digits_of(number_of(0, 1, 2)) == "1.414213562373095048801688724209698078569…");
  CHECK(digits_of(number_of(1, -1, 2)) == "-0.4142135623730950488016887242096980785696…");
  CHECK(digits_of(number_of(2, -1, 2)) == "0.5857864376269049511983112757903019214303…");
  CHECK(digits_of(number_of(0, 1, 4)) == "2");
}

TEST_CASE("digits far from one have an exponent") {
  CHECK(digits_of(number_of(0x1p-20)) == "0.00000095367431640625");
  CHECK(digits_of(number_of(0x1p-30)) == "9.31322574615478515625e-10");
  CHECK(digits_of(number_of(1e22)) == "10000000000000000000000");
  CHECK(digits_of(number_of(0x1p-1074)) == "4.940656458412465441765687928682213723650…e-324");
  CHECK(digits_of(number_of(0x1p-1074, 0, 0, 0x1p1000)).ends_with("…e-625"));
  CHECK(digits_of(number_of(-0x1.fffffffffffffp1023)) == "-1.797693134862315708145274237317043567980…e308");
  CHECK(digits_of({.x = Dyadic(0x1p1000), .w = Dyadic(0x1p-1000)}).ends_with("…e602"));
}

TEST_CASE("an exact number is told whole, with the binary64 that it rounds to and those beside it") {
  CHECK(exact_number(number_of(1, -1, 2, 4)) ==
        R"({"x":"1/4","y":"-1/4","delta":"2","digits":"-0.1035533905932737622004221810524245196424…",)"
        R"("binary64":-0.10355339059327376,"hex":"-0x1.a827999fcef32p-4","below":-0.10355339059327377,)"
        R"("above":-0.10355339059327374})");
  CHECK(exact_number(number_of(0, 1, 9, 2)) ==
        R"({"x":"3/2","y":"0","delta":"0","digits":"1.5","binary64":1.5,"hex":"0x1.8p+0","below":1.4999999999999998,)"
        R"("above":1.5000000000000002})");
  CHECK(exact_number({.x = Dyadic(0x1p1000), .w = Dyadic(0x1p-1000)}).find(R"("binary64":"inf","hex":"inf")") !=
        std::string::npos);
}

TEST_CASE("the distance of two numbers is theirs, however near they are") {
  CHECK(distance_between(number_of(1), number_of(1)) == 0);
  CHECK(distance_between(number_of(1), number_of(3.5)) == 2.5);
  CHECK(distance_between(number_of(0, 1, 4), number_of(2)) == 0);
  const double near = distance_between(number_of(1), {.x = Dyadic(1) + Dyadic(0x1p-700)});
  CHECK(std::abs(near / 0x1p-700 - 1) < 1e-10);
}

/// The told digits bound the number on both sides by one unit of the last digit.
void digits_bound_the_number() {
  const auto some = [] { return *rc::gen::resize(100, rc::gen::inRange<std::int64_t>(-1'000'000, 1'000'000)); };
  const DyadicSurd value = number_of(static_cast<double>(some()), static_cast<double>(some()),
                                     static_cast<double>(std::abs(some())), static_cast<double>(std::abs(some()) + 1));
  const number::Surd exact(value);
  std::string digits = digits_of(value);
  const bool goes_on = digits.ends_with("…");
  if (goes_on) digits.resize(digits.size() - std::string("…").size());
  if (digits.find('e') != digits.npos) return;
  const bool negative = digits.front() == '-';
  if (negative) digits.erase(0, 1);
  const std::size_t point = digits.find('.');
  const std::size_t behind = point == digits.npos ? 0 : digits.size() - point - 1;
  std::erase(digits, '.');
  const number::Rational unit = number::Rational(1) / number::Rational(boost::multiprecision::pow(
                                                          number::Integer(10), static_cast<unsigned>(behind)));
  digits.erase(0, std::min(digits.find_first_not_of('0'), digits.size() - 1));
  const number::Surd least(number::Rational(number::Integer(digits)) * unit);
  const number::Surd magnitude = negative ? -exact : exact;
  if (goes_on) {
    const bool below = least<magnitude, within = number::Surd(number::Rational(least.x + unit))> magnitude;
    RC_ASSERT(below);
    RC_ASSERT(within);
  } else {
    const bool equal = least == magnitude;
    RC_ASSERT(equal);
  }
}

TEST_CASE("told digits bound the number within one of the last of them") {
  test::property("of numbers x + y√delta over w", digits_bound_the_number);
}

}  // namespace
}  // namespace durero::web
