// JSON Patch: the examples of RFC 6902, appendix A, and its errors.
#include "io/json/json_patch.hpp"

#include "io/malformed.hpp"
#include "support/catch.hpp"

namespace durero::io::json {
namespace {

JsonValue value(const std::string& text) { return read_whole(Source("v", text)); }

std::string text_of(const JsonValue& of) {
  std::string text;
  append_value(text, of);
  return text;
}

std::string patched(const std::string& text, const std::string& patch) {
  JsonValue of = value(text);
  apply_patch(Source("p", patch), of);
  return text_of(of);
}

/// The error of a patch, without the place.
std::string error(const std::string& text, const std::string& patch) {
  try {
    return "none: " + patched(text, patch);
  } catch (const InputError& refused) {
    return std::string(refused.message());
  }
}

TEST_CASE("The operations do as RFC 6902 has it") {
  // A.1 to A.7
  CHECK(patched(R"({"foo":"bar"})", R"([{"op":"add","path":"/baz","value":"qux"}])") == R"({"foo":"bar","baz":"qux"})");
  CHECK(patched(R"({"foo":["bar","baz"]})", R"([{"op":"add","path":"/foo/1","value":"qux"}])") ==
        R"({"foo":["bar","qux","baz"]})");
  CHECK(patched(R"({"baz":"qux","foo":"bar"})", R"([{"op":"remove","path":"/baz"}])") == R"({"foo":"bar"})");
  CHECK(patched(R"({"foo":["bar","qux","baz"]})", R"([{"op":"remove","path":"/foo/1"}])") ==
        R"({"foo":["bar","baz"]})");
  CHECK(patched(R"({"baz":"qux","foo":"bar"})", R"([{"op":"replace","path":"/baz","value":"boo"}])") ==
        R"({"baz":"boo","foo":"bar"})");
  CHECK(patched(R"({"foo":{"bar":"baz","waldo":"fred"},"qux":{"corge":"grault"}})",
                R"([{"op":"move","from":"/foo/waldo","path":"/qux/thud"}])") ==
        R"({"foo":{"bar":"baz"},"qux":{"corge":"grault","thud":"fred"}})");
  CHECK(patched(R"({"foo":["all","grass","cows","eat"]})", R"([{"op":"move","from":"/foo/1","path":"/foo/3"}])") ==
        R"({"foo":["all","cows","eat","grass"]})");
  // A.8, A.10, A.11, A.14, A.16
  CHECK(patched(R"({"baz":"qux","foo":["a",2,"c"]})",
                R"([{"op":"test","path":"/baz","value":"qux"},{"op":"test","path":"/foo/1","value":2}])") ==
        R"({"baz":"qux","foo":["a",2,"c"]})");
  CHECK(patched(R"({"foo":"bar"})", R"([{"op":"add","path":"/child","value":{"grandchild":{}}}])") ==
        R"({"foo":"bar","child":{"grandchild":{}}})");
  CHECK(patched(R"({"foo":"bar"})", R"([{"op":"add","path":"/baz","value":"qux","xyz":123}])") ==
        R"({"foo":"bar","baz":"qux"})");
  CHECK(patched(R"({"/":9,"~1":10})", R"([{"op":"test","path":"/~01","value":10}])") == R"({"/":9,"~1":10})");
  CHECK(patched(R"({"foo":["bar"]})", R"([{"op":"add","path":"/foo/-","value":["abc","def"]}])") ==
        R"({"foo":["bar",["abc","def"]]})");
  // Copies, the whole, and members in any order.
  CHECK(patched(R"({"a":[1],"b":2})", R"([{"path":"/a/0","op":"copy","from":"/b"}])") == R"({"a":[2,1],"b":2})");
  CHECK(patched(R"({"a":1})", R"([{"op":"replace","path":"","value":[]},{"op":"add","path":"/0","value":null}])") ==
        "[null]");
  CHECK(patched(R"({"a":1})", R"([{"op":"add","path":"","value":7}])") == "7");
  CHECK(patched(R"({"a":1})", R"([{"op":"add","path":"/a","value":2}])") == R"({"a":2})");
  CHECK(patched(R"({"a":{"b":1}})", R"([{"op":"move","from":"/a","path":"/a"}])") == R"({"a":{"b":1}})");
  CHECK(patched(R"({"ab":1,"a":2})", R"([{"op":"move","from":"/a","path":"/ab"}])") == R"({"ab":2})");
  CHECK(patched(R"({"a":1.50,"b":12345678901234567890123})", "[]") == R"({"a":1.50,"b":12345678901234567890123})");
}

TEST_CASE("A test compares values, and no texts") {
  const auto test = [](const std::string& a, const std::string& b) {
    return error(R"({"a":)" + a + "}", R"([{"op":"test","path":"/a","value":)" + b + "}]").starts_with("none");
  };
  CHECK(test("1", "1.0"));
  CHECK(test("100", "1e2"));
  CHECK(test("0", "-0"));
  CHECK(test("0.1", "0.1000000000000000055511151231257827"));
  CHECK_FALSE(test("0.1", "0.10000000000000002"));
  CHECK(test(R"({"x":1,"y":[2]})", R"({"y":[2],"x":1})"));
  CHECK_FALSE(test(R"({"x":1,"y":[2]})", R"({"x":1})"));
  CHECK_FALSE(test("[1,2]", "[2,1]"));
  CHECK_FALSE(test("1", R"("1")"));
  CHECK(test(R"("\u0041")", R"("A")"));
  CHECK_FALSE(test("null", "false"));
  CHECK(test("null", "null"));
  CHECK_FALSE(test("1e400", "1e401"));
}

TEST_CASE("A pointer that leads nowhere is refused, and so is a patch that is none") {
  const std::string nowhere = " is not there; expected a pointer to what the document has";
  const std::string document = R"({"a":[1,2],"b":{"c":3}})";
  const auto on = [&](const std::string& operation) { return error(document, "[" + operation + "]"); };
  for (const std::string path : {"/x", "/a/2", "/a/01", "/a/-", "/b/c/d", "/a/x", "/a/1e0", "/"})
    CHECK(on(R"({"op":"remove","path":")" + path + "\"}") == "\"" + path + "\"" + nowhere);
  for (const std::string path : {"/a/3", "/x/y", "/b/c/d", "/a/01"})
    CHECK(on(R"({"op":"add","path":")" + path + "\",\"value\":1}") == "\"" + path + "\"" + nowhere);
  CHECK(on(R"({"op":"copy","path":"/a/0","from":"/x"})") == "\"/x\"" + nowhere);
  CHECK(on(R"({"op":"replace","path":"/b/x","value":1})") == "\"/b/x\"" + nowhere);
  CHECK(on(R"({"op":"test","path":"/b/c","value":4})") == R"("/b/c" has another value; expected that of the test)");
  CHECK(on(R"({"op":"move","path":"/b/c","from":"/b"})") ==
        R"("/b/c" lies in what is moved; expected a place outside it)");
  CHECK(on(R"({"op":"remove","path":""})") == R"("" is the whole document; expected a pointer to a part of it)");
  CHECK(on(R"({"op":"remove","path":"a"})") == R"(path is "a"; expected a JSON pointer, such as /elementos/0)");
  CHECK(on(R"({"op":"remove","path":"#/a"})") == R"(path is "#/a"; expected a JSON pointer, such as /elementos/0)");
  CHECK(on(R"({"op":"remove","path":"/~2"})") == R"(path is "/~2"; expected a JSON pointer, such as /elementos/0)");
  CHECK(on(R"({"op":"delete","path":"/a"})") ==
        R"(op is "delete"; expected one of add, remove, replace, move, copy, test)");
  CHECK(on(R"({"path":"/a"})") == R"(key "op" is missing in an operation of a patch; expected it)");
  CHECK(on(R"({"op":"remove"})") == R"(key "path" is missing in an operation of a patch; expected it)");
  CHECK(on(R"({"op":"add","path":"/x"})") == R"(key "value" is missing in an operation of a patch; expected it)");
  CHECK(on(R"({"op":"move","path":"/x"})") == R"(key "from" is missing in an operation of a patch; expected it)");
  CHECK(on(R"({"op":"test","op":"add","path":"/x"})") == R"(key "op" stands twice; expected it once)");
  CHECK(error(document, "{}") == "a patch is an object; expected an array");
}

TEST_CASE("A patch is read whole before any of it is done, and its place is that of what is wrong") {
  CHECK(test::error_at_mark("[{\"op\":\"add\",\"path\":\"/a\",\"value\":1},\n{\"op\":\"remove\",\"path\":^\"/b\"}]",
                            [](const Source& source) {
                              JsonValue of = value("{}");
                              apply_patch(source, of);
                            }) == "\"/b\" is not there; expected a pointer to what the document has");
}

TEST_CASE("A replaced value keeps its place in the text, and a pointer finds it") {
  JsonValue of = value(R"({"a":[1,{"b/c":2}]})");
  const std::vector<std::size_t> operations =
      apply_patch(Source("p", R"([{"op":"replace","path":"/a/1/b~1c","value":3}])"), of);
  CHECK(operations == std::vector<std::size_t>{1});
  const JsonValue* const found = find(of, "/a/1/b~1c");
  REQUIRE(found != nullptr);
  CHECK(found->offset == 15);
  CHECK(text_of(*found) == "3");
  CHECK(find(of, "") == &of);
  for (const char* nothing : {"/b", "/a/2", "/a/01", "/a/-", "a", "/a/0/x", "/~2"}) CHECK(find(of, nothing) == nullptr);
}

TEST_CASE("Brackets and copies have bounds") {
  const auto nested = [](std::size_t depth) { return std::string(depth, '[') + std::string(depth, ']'); };
  const auto put = [&](std::size_t depth) {
    return error(R"({"a":{}})", R"([{"op":"add","path":"/a/b","value":)" + nested(depth) + "}]");
  };
  CHECK(put(deepest_brackets - 2).starts_with("none"));
  CHECK(put(deepest_brackets - 1) == R"("/a/b" would stand too deep; expected no more brackets than a scene has)");
  CHECK(put(deepest_brackets + 1) == "brackets stand too deep in each other; expected no more than a scene has");
  // The array has 2ⁿ values before the copy of line n, and those of the lines up to n are 2ⁿ⁺¹ − 2: more than 2²² first
  // at line 22.
  std::string doubling = "[";
  for (int i = 0; i < 40; ++i)
    doubling += std::string(i == 0 ? "" : ",\n") + R"({"op":"copy","from":"/a","path":"/a/-"})";
  JsonValue array = value(R"({"a":[0]})");
  try {
    apply_patch(Source("p", doubling + "]"), array);
    FAIL("nothing is refused");
  } catch (const InputError& refused) {
    CHECK(refused.message() == R"("/a/-" would be too much; expected 4194304 copied values in all)");
    CHECK(refused.place().line == 22);
  }
}

}  // namespace
}  // namespace durero::io::json
