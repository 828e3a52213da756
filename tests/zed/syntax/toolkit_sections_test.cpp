#include "durero/zed/syntax/toolkit_sections.hpp"

#include <string>

#include "support/catch.hpp"

using namespace durero::zed;

namespace {

/// Returns what a section of the toolkit gives, in the order of ToolkitSection: a letter for each that is given.
std::string given_by(std::string_view name) {
  const auto given = ToolkitSections::of(name);
  if (!given) return "no section of the toolkit";
  std::string letters;
  for (unsigned i = 0; i < 6; ++i) letters += given->has(static_cast<ToolkitSection>(i)) ? "psrfnq"[i] : '-';
  return letters;
}

}  // namespace

TEST_CASE("a section of the toolkit gives itself and its ancestors") {
  CHECK(given_by("prelude") == "p-----");
  CHECK(given_by("set_toolkit") == "ps----");
  CHECK(given_by("relation_toolkit") == "psr---");
  CHECK(given_by("function_toolkit") == "psrf--");
  CHECK(given_by("number_toolkit") == "p---n-");
  CHECK(given_by("sequence_toolkit") == "psrfnq");
  CHECK(given_by("standard_toolkit") == "psrfnq");
  CHECK(given_by("bag_toolkit") == "no section of the toolkit");
}

TEST_CASE("sections of the toolkit are joined, with the prelude always among them") {
  ToolkitSections seen;
  CHECK(seen == ToolkitSections::of("prelude"));
  seen |= *ToolkitSections::of("set_toolkit");
  seen |= *ToolkitSections::of("number_toolkit");
  CHECK(seen.has(ToolkitSection::set));
  CHECK(seen.has(ToolkitSection::number));
  CHECK_FALSE(seen.has(ToolkitSection::relation));
  CHECK(ToolkitSections::all() == ToolkitSections::of("standard_toolkit"));
}

TEST_CASE("each section that declares names has the name that the standard gives it") {
  for (unsigned i = 0; i < 6; ++i) {
    const auto section = static_cast<ToolkitSection>(i);
    CAPTURE(i);
    REQUIRE(ToolkitSections::of(name_of(section)));
    CHECK(ToolkitSections::of(name_of(section))->has(section));
  }
  CHECK(name_of(ToolkitSection::sequence) == "sequence_toolkit");
}
