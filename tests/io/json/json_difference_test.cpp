// The JSON Patch between two values.
#include "io/json/json_difference.hpp"

#include "io/json/json_patch.hpp"
#include "support/catch.hpp"

namespace durero::io::json {
namespace {

JsonValue value(const std::string& text) {
  const Source source("v", text);
  const Document document(source);
  Reader in(document);
  return read_value(source, in);
}

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

std::string between(const std::string& a, const std::string& b) {
  const std::string patch = patch_between(value(a), value(b));
  CHECK(are_equal(value(patched(a, patch)), value(b)));
  return patch;
}

TEST_CASE("A patch between values says what differs") {
  CHECK(between(R"({"a":1})", R"({"a":1})") == "[]\n");
  CHECK(between(R"({"a":1})", R"({"a":1.0})") == "[\n{\"op\":\"replace\",\"path\":\"/a\",\"value\":1.0}\n]\n");
  CHECK(between(R"({"a":0})", R"({"a":-0})") == "[\n{\"op\":\"replace\",\"path\":\"/a\",\"value\":-0}\n]\n");
  CHECK(between(R"({"a":1,"b/~":2})", R"({"c":[3],"a":1})") ==
        "[\n{\"op\":\"remove\",\"path\":\"/b~1~0\"},\n{\"op\":\"add\",\"path\":\"/c\",\"value\":[3]}\n]\n");
  const std::string long_text = "\"" + std::string(99, 'x') + "\"";
  CHECK(between(R"({"a":{"b":[1,)" + long_text + "]}}", R"({"a":{"b":[2,)" + long_text + "]}}") ==
        "[\n{\"op\":\"replace\",\"path\":\"/a/b/0\",\"value\":2}\n]\n");
  CHECK(between(R"({"a":[1,2]})", R"({"a":[1,2,3]})") ==
        "[\n{\"op\":\"replace\",\"path\":\"/a\",\"value\":[1,2,3]}\n]\n");
  CHECK(between(R"({"a":{"b":1,"c":2}})", R"({"a":{"b":3,"c":4}})") ==
        "[\n{\"op\":\"replace\",\"path\":\"/a\",\"value\":{\"b\":3,\"c\":4}}\n]\n");
}

TEST_CASE("Items with an id are told apart by it") {
  const auto list = [](const std::string& items) { return R"({"elementos":[)" + items + "]}"; };
  const std::string a = R"({"id":"a","radio":1})", b = R"({"id":"b","radio":1})", c = R"({"id":"c","radio":1})";
  CHECK(between(list(a + "," + c), list(a + "," + b + "," + c)) ==
        "[\n{\"op\":\"add\",\"path\":\"/elementos/1\",\"value\":" + b + "}\n]\n");
  CHECK(between(list(a + "," + b), list(b)) ==
        "[\n{\"op\":\"test\",\"path\":\"/elementos/0/id\",\"value\":\"a\"},\n"
        "{\"op\":\"remove\",\"path\":\"/elementos/0\"}\n]\n");
  CHECK(between(list(""), list(a + "," + b)) == "[\n{\"op\":\"add\",\"path\":\"/elementos/0\",\"value\":" + b + "},\n" +
                                                    "{\"op\":\"add\",\"path\":\"/elementos/0\",\"value\":" + a +
                                                    "}\n]\n");
  const std::string grown = R"({"id":"b","radio":2,"centro":[0,0,0],"vector":[0,0,1]})";
  const std::string small = R"({"id":"b","radio":1,"centro":[0,0,0],"vector":[0,0,1]})";
  CHECK(between(list(a + "," + small), list(a + "," + grown)) ==
        "[\n{\"op\":\"test\",\"path\":\"/elementos/1/id\",\"value\":\"b\"},\n"
        "{\"op\":\"replace\",\"path\":\"/elementos/1/radio\",\"value\":2}\n]\n");
  CHECK(between(list(R"({"id":"b","tipo":"x","centro":[0,0,0],"vector":[0,0,1]})"),
                list(R"({"id":"b","tipo":"y","centro":[0,0,0],"vector":[0,0,1]})")) ==
        "[\n{\"op\":\"test\",\"path\":\"/elementos/0/id\",\"value\":\"b\"},\n{\"op\":\"replace\",\"path\":"
        "\"/elementos/0\",\"value\":{\"id\":\"b\",\"tipo\":\"y\",\"centro\":[0,0,0],\"vector\":[0,0,1]}}\n]\n");
}

}  // namespace
}  // namespace durero::io::json
