// A pointer says which value stands at a byte.
#include "durero/io/json/json_pointer.hpp"

#include "support/catch.hpp"

using namespace durero;
using namespace durero::io::json;

namespace {

/// The pointers to the bytes that ^ marks.
std::vector<std::string> at_marks(std::string text) {
  std::vector<std::size_t> offsets;
  for (std::size_t at = 0; (at = text.find('^', at)) != text.npos; text.erase(at, 1)) offsets.push_back(at);
  const io::Source source("f", text);
  return pointers(Document(source), offsets);
}

using Pointers = std::vector<std::string>;

}  // namespace

TEST_CASE("Values and keys of objects and arrays, nested") {
  CHECK(
      at_marks(R"(^{"a":^1,^"b":^[^7,^{^"c":^null},^[^[^"x"]]^],"d":{},"e":[],"f":^2^})") ==
      Pointers{"", "/a", "/b", "/b", "/b/0", "/b/1", "/b/1/c", "/b/1/c", "/b/2", "/b/2/0", "/b/2/0/0", "/b", "/f", ""});
  CHECK(at_marks("^7") == Pointers{""});
  CHECK(at_marks("[1,^[]]") == Pointers{"/1"});
}

TEST_CASE("What a pointer escapes, and a key that is written with escapes") {
  CHECK(at_marks(R"({"a/b":{"~":^1},"":^2,"\u00f1":^3,"\"":{"m~n":[0,^4]}})") ==
        Pointers{"/a~1b/~0", "/", "/ñ", "/\"/m~0n/1"});
}

TEST_CASE("A byte between two values belongs to the one before; one may be asked for twice") {
  CHECK(at_marks(R"({"a": 1^2 ^^, "b":[3^ ]})") == Pointers{"/a", "/a", "/a", "/b/0"});
  CHECK(at_marks(R"({"a":1})").empty());
}

TEST_CASE("Errors are put into the order of the text, those of one place as they were") {
  const io::Source text("f", R"({"a":[1,2],"b":3})");
  std::vector<io::InputError> errors;
  const auto note = [&](std::size_t offset, const char* wrong) {
    try {
      text.fail(offset, wrong, "expected another");
    } catch (const io::InputError& error) {
      errors.push_back(error);
    }
  };
  note(15, "third");
  note(8, "first");
  note(8, "second");
  CHECK(pointers_in_order(text, errors) == Pointers{"/a/1", "/a/1", "/b"});
  for (std::size_t i = 0; i < errors.size(); ++i)
    CHECK(std::string(errors[i].message()).starts_with(std::vector{"first", "second", "third"}[i]));

  const io::Source broken("f", "[1,");
  CHECK_THROWS_AS(pointers_in_order(broken, errors), io::InputError);
}
