// The version of a format is looked at before all else, wherever it stands.
#include "durero/io/json/format_version.hpp"

#include "io/malformed.hpp"
#include "support/catch.hpp"

using namespace durero;
using namespace durero::io::json;

namespace {

constexpr FormatVersion third{"durero-x", 3};

std::string error_at(const std::string& with_mark) {
  return test::error_at_mark(with_mark, [](const io::Source& source) {
    const Document document(source);
    require_version(Reader(document), third);
  });
}
std::string error_of(const std::string& text) {
  return test::error_of(text, [](const io::Source& source) {
    const Document document(source);
    require_version(Reader(document), third);
  });
}

}  // namespace

TEST_CASE("The format and its version are those that are read") {
  CHECK(error_of(R"({"format":"durero-x","version":3})").empty());
  CHECK(error_of(R"({"new":{"version":4,"format":"y"},"version":3.0,"format":"durero-x"})").empty());
  CHECK(error_at(R"({"format":^"durero-y","version":4})") == "format is \"durero-y\"; expected \"durero-x\"");
  CHECK(error_at(R"({"format":^7})") == "format is a number; expected a string");
  CHECK(error_at(R"({"version":^2})") == "version is 2; expected 3");
  CHECK(error_at(R"({"version":^-4})") == "version is -4; expected 3");
  CHECK(error_at(R"({"version":^3.5})") == "version is 3.5; expected 3");
  CHECK(error_at(R"({"version":^null})") == "version is null; expected a number");
}

TEST_CASE("A newer version is named as one, whatever else is new") {
  const std::string newer = "version 4 of durero-x; expected 3 (written by a newer durero?)";
  CHECK(error_at(R"({"format":"durero-x","version":^4})") == newer);
  CHECK(error_at(R"({"layers":[{"version":3}],"version":^4,"format":"durero-x","version":3})") == newer);
}

TEST_CASE("Whether there is a format and a version, and an object at all, the reader of the object says") {
  for (const char* text : {"{}", "[]", "7", R"("version")", R"([{"version":9}])"}) CHECK(error_of(text).empty());
}

TEST_CASE("Both keys are written first") {
  std::string text;
  Writer out(text);
  write_version(out.begin_object(), third);
  out.member("a", true).end_object();
  CHECK(text == R"({"format":"durero-x","version":3,"a":true})");
}
