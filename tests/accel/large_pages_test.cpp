// What is told apart here: an array keeps what it is given, where its memory is aligned to a large page and where not.
#include "durero/accel/large_pages.hpp"

#include <cstdint>
#include <limits>
#include <numeric>

#include "support/catch.hpp"

using namespace durero;

TEST_CASE("arrays below a large page, of one, and of more keep their numbers while they grow") {
  constexpr std::size_t page = std::size_t{1} << 21;
  for (const std::size_t bytes : {std::size_t{64}, page - 4, page, 3 * page + 4}) {
    accel::LargeVector<std::uint32_t> numbers(bytes / 4);
    std::iota(numbers.begin(), numbers.end(), 0U);
    numbers.push_back(7);
    CHECK(numbers[bytes / 8] == bytes / 8);
    CHECK(numbers.back() == 7);
    const accel::LargeVector<std::uint32_t> copy = numbers;
    CHECK(copy == numbers);
    const bool on_a_page = reinterpret_cast<std::uintptr_t>(numbers.data()) % page == 0;
    CHECK((on_a_page || numbers.capacity() * 4 < page));
  }
}

TEST_CASE("more than memory can hold is refused") {
  accel::LargePages<std::uint64_t> pages;
  CHECK_THROWS_AS(pages.allocate(std::numeric_limits<std::size_t>::max() / 8 + 2), std::bad_alloc);
}
