#include "durero/conform/ask/profile.hpp"

#include <limits>

#include "support/catch.hpp"

using namespace durero::conform;

TEST_CASE("each word of a profile stands at the place of its enumerator") {
  CHECK(word(NumberFormat::binary32) == "binary32");
  CHECK(word(NumberFormat::binary64) == "binary64");
  CHECK(word(Caps::open) == "open");
  CHECK(word(Caps::solid) == "solid");
  CHECK(word(Measure::parameter) == "parameter");
  CHECK(word(Measure::length) == "length");
  CHECK(word(Measure::point) == "point");
  CHECK(word(Directions::any) == "any");
  CHECK(word(Directions::unit) == "unit");
  CHECK(word(Directions::unchecked) == "unchecked");
  CHECK(word(Inside::exit_point) == "exit_point");
  CHECK(word(Inside::nothing) == "nothing");
  CHECK(word(Inside::origin) == "origin");
  CHECK(word(Inside::undefined) == "undefined");
  CHECK(word(QuestionKind::first) == "first");
  CHECK(word(QuestionKind::shadow) == "shadow");
  CHECK(word(QuestionKind::range) == "range");
  CHECK_FALSE(has_range(QuestionKind::first));
  CHECK(has_range(QuestionKind::range));
  CHECK_FALSE(has_range(QuestionKind::all));
  CHECK(is_about_all(QuestionKind::count));
  CHECK_FALSE(is_about_all(QuestionKind::range));
  CHECK(word(QuestionKind::all) == "all");
  CHECK(word(QuestionKind::count) == "count");
}

TEST_CASE("a profile that claims no limit has none") {
  const Profile profile;
  const double infinity = std::numeric_limits<double>::infinity();
  CHECK(profile.least_t == 0);
  CHECK(profile.greatest_t == infinity);
  CHECK(profile.least_size == 0);
  CHECK(profile.greatest_size == infinity);
  CHECK(profile.greatest_coordinate == infinity);
  CHECK(profile.names_elements);
  CHECK(profile.questions == std::vector{QuestionKind::first});
}
