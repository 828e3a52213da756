// A JSON Patch: what it reads, writes and does to a text.
#include "durero/io/json/file_patch.hpp"

#include "support/catch.hpp"

namespace durero::io::json {
namespace {

std::string after(const std::string& text, const std::string& patch) {
  const Source source("p", patch);
  std::string changed = patched(Source("f", text), source, read_patch(source));
  std::erase(changed, '\n');
  return changed;
}

std::string error_of(const std::string& text, const std::string& patch) {
  try {
    after(text, patch);
  } catch (const InputError& error) {
    return error.what();
  }
  return "none";
}

TEST_CASE("values are replaced and removed by their pointers, one operation after the other") {
  const std::string text = R"({"a/b":[1,2.50,{"~":"x\u00f1"}],"c":null,"d":{}})";
  CHECK(after(text, "[]") == text);
  CHECK(after(text, R"([{"op":"remove","path":"/a~1b/0"}])") == R"({"a/b":[2.50,{"~":"x\u00f1"}],"c":null,"d":{}})");
  CHECK(after(text,
              R"([{"op":"remove","path":"/a~1b/0"},{"op":"remove","path":"/a~1b/0"},{"path":"/c","op":"remove"}])") ==
        R"({"a/b":[{"~":"x\u00f1"}],"d":{}})");
  CHECK(after(text, R"([{"op":"replace","path":"/a~1b/2/~0","value":{"y":[7]}, "reason":"why"},)"
                    R"({"op":"replace","path":"/a~1b/2/~0/y/0","value":"\"z"}])") ==
        R"({"a/b":[1,2.50,{"~":{"y":["\"z"]}}],"c":null,"d":{}})");
  CHECK(after(text, R"([{"op":"replace","path":"","value":7}])") == "7");
}

TEST_CASE("a patch is written as it is read") {
  const std::string text =
      "[\n{\"op\":\"replace\",\"path\":\"/a\",\"reason\":\"its length\",\"value\":[0,1]},\n"
      "{\"op\":\"remove\",\"path\":\"/b/\\\"c\"}\n]\n";
  const std::vector<PatchProposal> patch{{PatchProposal::Kind::replace, "/a", "[0,1]", "its length"},
                                         {PatchProposal::Kind::remove, "/b/\"c"}};
  CHECK(patch_text(patch) == text);
  const std::vector<PatchProposal> read = read_patch(Source("p", text));
  REQUIRE(read.size() == 2);
  CHECK(read[0].reason == "its length");
  CHECK(read[0].offset == 2);
  CHECK(read[1].path == "/b/\"c");
  CHECK(is_patch(Source("p", " \n\t[")));
  CHECK_FALSE(is_patch(Source("p", "Eliminar_Esfera e?=a\n[")));
  CHECK_FALSE(is_patch(Source("p", "")));
}

TEST_CASE("what is no patch, or names nothing, is refused with its place") {
  const std::string text = R"({"a":[1,2]})";
  for (const char* path : {"/b", "/a/2", "/a/-1", "/a/01", "/a/", "/a/x", "a", "/a/0/0"}) {
    CAPTURE(path);
    CHECK(error_of(text, std::string("[\n{\"op\":\"remove\",\"path\":\"") + path + "\"}]").starts_with("p:2:1: \""));
  }
  CHECK(error_of(text, R"([{"op":"remove","path":""}])").starts_with("p:1:2: \"\" names nothing; "));
  CHECK(error_of(text, R"([{"op":"move","path":"/a","from":"/b"}])").starts_with("p:1:8: op is \"move\"; "));
  CHECK(error_of(text, R"([{"op":"replace","path":"/a"}])").starts_with("p:1:2: replace has no value; "));
  CHECK(error_of(text, R"([{"op":"remove","path":"/a","value":1}])").starts_with("p:1:2: remove has a value; "));
  CHECK(error_of(text, R"([{"op":"remove"}])").starts_with("p:1:2: "));
  CHECK(error_of(text, "[7]").starts_with("p:1:2: "));
  CHECK(error_of(text, "[").starts_with("p:1:2: "));
  CHECK(error_of("{", R"([{"op":"remove","path":"/a"}])").starts_with("f:1:2: "));
  CHECK(error_of(std::string(101, '[') + std::string(101, ']'), "[]").starts_with("f:1:101: 101 brackets stand "));
  CHECK(error_of(std::string(100, '[') + std::string(100, ']'), "[]") == "none");
}

}  // namespace
}  // namespace durero::io::json
