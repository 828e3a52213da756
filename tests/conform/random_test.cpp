#include "durero/conform/random.hpp"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vector_relational.hpp>
#include <map>
#include <vector>

#include "support/catch.hpp"

using namespace durero;
using conform::Random;

namespace {

constexpr int draws = 4000;

}  // namespace

TEST_CASE("a seed names one stream, on every platform") {
  Random random(2026), again(2026), other(2027);
  const std::uint64_t first = random.bits();
  CHECK(first == 5856769961467801901U);  // std::mt19937_64, which the standard fixes
  CHECK(again.bits() == first);
  CHECK(other.bits() != first);
}

TEST_CASE("integers are of their range, its ends among them") {
  Random random(1);
  std::map<int, int> integers;
  std::map<std::uint64_t, int> below;
  for (int i = 0; i < draws; ++i) {
    ++integers[random.integer(-2, 3)];
    ++below[random.below(5)];
  }
  CHECK(integers.size() == 6);
  CHECK(integers.begin()->first == -2);
  CHECK(integers.rbegin()->first == 3);
  CHECK(below.size() == 5);
  CHECK(below.rbegin()->first == 4);
  for (const auto& [value, times] : integers) CHECK(times > draws / 12);
  CHECK(random.integer(7, 7) == 7);
}

TEST_CASE("a chance is yes in its part of the cases, and a sign in half") {
  Random random(2);
  int yes = 0, plus = 0;
  for (int i = 0; i < draws; ++i) {
    yes += random.chance(1, 4);
    const double sign = random.sign();
    REQUIRE(std::abs(sign) == 1);
    plus += sign > 0;
  }
  CHECK(std::abs(yes - draws / 4) < draws / 20);
  CHECK(std::abs(plus - draws / 2) < draws / 20);
  CHECK(random.chance(3, 3));
  CHECK_FALSE(random.chance(0, 3));
}

TEST_CASE("powers and numbers keep to their exponents") {
  Random random(3);
  std::map<int, int> exponents;
  for (int i = 0; i < draws; ++i) {
    int exponent = 0;
    const double power = random.signed_power(-3, 3);
    CHECK(std::abs(std::frexp(power, &exponent)) == 0.5);
    ++exponents[exponent - 1];
    const double number = std::abs(random.number(-3, 3));
    CHECK((number >= 0x1p-3 && number < 0x1p4));
  }
  CHECK(exponents.size() == 7);
  CHECK(exponents.begin()->first == -3);
  CHECK(exponents.rbegin()->first == 3);
}

TEST_CASE("uniform takes in its lower end and all between, and not its upper end") {
  Random random(4);
  double least = 8, greatest = 5, sum = 0;
  for (int i = 0; i < draws; ++i) {
    const double x = random.uniform(5, 8);
    REQUIRE((x >= 5 && x < 8));
    least = std::min(least, x);
    greatest = std::max(greatest, x);
    sum += x;
  }
  CHECK(least < 5.01);
  CHECK(greatest > 7.99);
  CHECK(std::abs(sum / draws - 6.5) < 0.1);
}

TEST_CASE("vectors: in a cube, on a lattice and never 0, of length 1") {
  Random random(5);
  for (int i = 0; i < draws; ++i) {
    const glm::dvec3 in_cube = random.in_cube(3), lattice = random.lattice_vector(1), direction = random.direction();
    REQUIRE(glm::all(glm::lessThanEqual(glm::abs(in_cube), glm::dvec3(3))));
    REQUIRE(lattice != glm::dvec3(0));
    REQUIRE(glm::all(glm::lessThanEqual(glm::abs(lattice), glm::dvec3(1))));
    REQUIRE(lattice == glm::floor(lattice));
    REQUIRE(std::abs(glm::length(direction) - 1) < 0x1p-50);
  }
}

TEST_CASE("any_of draws each of a list") {
  Random random(6);
  const std::vector<char> letters{'a', 'b', 'c'};
  std::map<char, int> times;
  for (int i = 0; i < draws; ++i) ++times[random.any_of(letters)];
  CHECK(times.size() == 3);
  for (const auto& [letter, number] : times) CHECK(number > draws / 6);
  const std::vector<char> one{'x'};
  CHECK(&random.any_of(one) == one.data());  // an element of the list, and no copy
}
