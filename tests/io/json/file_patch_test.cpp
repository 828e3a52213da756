// A JSON Patch of a file: what it does to the text. What the operations mean is tried by json_patch_test.cpp.
#include "durero/io/json/file_patch.hpp"

#include "support/catch.hpp"

namespace durero::io::json {
namespace {

std::string after(const std::string& text, const std::string& patch) {
  return patched_file(Source("f", text), Source("p", patch)).text;
}

std::string error_of(const std::string& text, const std::string& patch) {
  try {
    after(text, patch);
  } catch (const InputError& error) {
    return error.what();
  }
  return "none";
}

TEST_CASE("numbers that a patch does not touch keep their digits, and the outer parts stand on lines") {
  const std::string text = R"({"a/b":[1,2.50,{"~":[1e0,"x"]}],"c":null,"d":{}})";
  CHECK(after(text, "[]") == "{\n\"a/b\":[\n1,\n2.50,\n{\"~\":[1e0,\"x\"]}],\n\"c\":null,\n\"d\":{}}\n");
  CHECK(after(text, R"([{"op":"remove","path":"/a~1b/0"},{"op":"move","from":"/a~1b/1/~0/0","path":"/c"}])") ==
        "{\n\"a/b\":[\n2.50,\n{\"~\":[\"x\"]}],\n\"c\":1e0,\n\"d\":{}}\n");
  CHECK(after(text, R"([{"op":"replace","path":"","value":7.0}])") == "7.0\n");
}

TEST_CASE("each operation is told where it begins in the patch") {
  const Source patch("p",
                     "[ {\"op\":\"add\",\"path\":\"/a\",\"value\":1, \"reason\":\"why\"},\n"
                     "{\"op\":\"test\",\"path\":\"/a\",\"value\":1.0}]");
  const PatchedFile patched = patched_file(Source("f", "{}"), patch);
  CHECK(patched.text == "{\n\"a\":1}\n");
  REQUIRE(patched.operations.size() == 2);
  CHECK(patched.operations[0] == 2);
  CHECK(patch.place(patched.operations[1]) == TextPosition{2, 1});
}

TEST_CASE("a patch begins with a bracket, and a script of operations does not") {
  CHECK(is_patch(Source("p", " \n\t[")));
  CHECK_FALSE(is_patch(Source("p", "Eliminar_Esfera e?=a\n[")));
  CHECK_FALSE(is_patch(Source("p", "")));
}

TEST_CASE("an error is told of the file or of the patch, wherever it is") {
  CHECK(error_of("{", R"([{"op":"remove","path":"/a"}])").starts_with("f:1:2: "));
  CHECK(error_of("{} {}", "[]").starts_with("f:1:4: "));
  CHECK(error_of("{}", "[\n{\"op\":\"remove\",\"path\":\"/a\"}]").starts_with("p:2:23: \"/a\" is not there; "));
  CHECK(error_of("{}", "[7]").starts_with("p:1:2: "));
  CHECK(error_of("{}", "[").starts_with("p:1:2: "));
}

}  // namespace
}  // namespace durero::io::json
