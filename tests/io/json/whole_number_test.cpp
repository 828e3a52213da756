// Whole numbers: those of the range and no others, each error at its place.
#include "durero/io/json/whole_number.hpp"

#include <limits>

#include "io/malformed.hpp"
#include "support/catch.hpp"

using namespace durero;
using namespace durero::io;

namespace {

std::int64_t read(const Source& source, std::int64_t least, std::int64_t most) {
  const json::Document document(source);
  json::Reader in(document);
  return json::whole_number(in, "n", least, most, "one that fits");
}
std::int64_t value(const std::string& text, std::int64_t least, std::int64_t most) {
  return read(Source("f", text), least, most);
}
std::string error_at(const std::string& with_mark, std::int64_t least, std::int64_t most) {
  return test::error_at_mark(with_mark, [&](const Source& source) { return read(source, least, most); });
}

}  // namespace

TEST_CASE("A whole number of the range is one") {
  for (const double value : {-3., -0., 0., 1., 4.}) CHECK(is_whole(value, -3, 4));
  CHECK(is_whole(0x1p53, 0, 0x1p53));
  const double infinity = std::numeric_limits<double>::infinity(), nan = std::numeric_limits<double>::quiet_NaN();
  for (const double value : {-4., 5., 0.5, -2.5, 0x1p-1074, infinity, -infinity, nan})
    CHECK_FALSE(is_whole(value, -3, 4));
  CHECK_FALSE(is_whole(0, 0, -1));
}

TEST_CASE("A whole number of a file is read, or refused at its place") {
  CHECK(value("7", 0, 7) == 7);
  CHECK(value(" -7.0", -7, 7) == -7);
  CHECK(value("9.007199254740992e15", 0, json::most_whole) == json::most_whole);
  CHECK(value("-9007199254740992", -json::most_whole, 0) == -json::most_whole);
  CHECK(error_at(" ^8", 0, 7) == "n is 8; expected one that fits");
  CHECK(error_at("^-1", 0, 7) == "n is -1; expected one that fits");
  CHECK(error_at("^0.5", 0, 7) == "n is 0.5; expected one that fits");
  CHECK(error_at("^9007199254740994", 0, json::most_whole) == "n is 9007199254740994; expected one that fits");
  CHECK(error_at("^\"7\"", 0, 7) == "n is a string; expected a number");
}

TEST_CASE("A whole number without a range of its own is one from 0 to the most") {
  const auto read_counted = [](const Source& source) {
    const json::Document document(source);
    json::Reader in(document);
    return json::whole_number(in, "n");
  };
  CHECK(read_counted(Source("f", "0")) == 0);
  CHECK(read_counted(Source("f", "9007199254740992")) == std::uint64_t{1} << 53U);
  CHECK(test::error_at_mark("^-1", read_counted) == "n is -1; expected a whole number up to 2^53");
  CHECK(test::error_at_mark("^9007199254740994", read_counted) ==
        "n is 9007199254740994; expected a whole number up to 2^53");
}
