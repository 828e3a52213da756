#include "durero/accel/large_pages.hpp"

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <numeric>
#include <sstream>
#include <string>
#include <vector>

#include "support/catch.hpp"
#include "support/sanitized.hpp"

using namespace durero;
using accel::LargePages;

namespace {

/// What Linux says of the mapping in which an address lies; empty where it says nothing.
std::string flags_of(const void* address) {
  std::ifstream maps("/proc/self/smaps");
  const auto at = reinterpret_cast<std::uintptr_t>(address);
  bool is_within = false;
  for (std::string line; std::getline(maps, line);) {
    std::istringstream in(line);
    std::uintptr_t low = 0, high = 0;
    char dash = 0;
    if (in >> std::hex >> low >> dash >> high && dash == '-') is_within = low <= at && at < high;
    if (is_within && line.starts_with("VmFlags:")) return line + ' ';
  }
  return {};
}

}  // namespace

TEST_CASE("an array keeps what is in it while it grows from small pages to large ones") {
  std::vector<std::uint64_t, LargePages<std::uint64_t>> numbers;
  for (std::uint64_t i = 0; i < 1'000'000; ++i) numbers.push_back(i);
  CHECK(std::accumulate(numbers.begin(), numbers.end(), std::uint64_t{0}) == 499'999'500'000u);
  const auto copy = numbers;
  CHECK(copy == numbers);
  numbers.resize(3);
  numbers.shrink_to_fit();
  CHECK(numbers == decltype(numbers){0, 1, 2});
}

TEST_CASE("a long array begins on a large page, and the system is asked for such") {
  const std::vector<char, LargePages<char>> array(3 * accel::large_page);
  CHECK(reinterpret_cast<std::uintptr_t>(array.data()) % accel::large_page == 0);
  // Of a kernel that knows no large pages nothing can be asked; the sanitizers map memory as they like.
  if (!test::sanitized && std::filesystem::exists("/sys/kernel/mm/transparent_hugepage/enabled"))
    CHECK(flags_of(array.data() + accel::large_page).find(" hg ") != std::string::npos);
}
