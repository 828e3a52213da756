#include "durero/io/json/json.hpp"

#include <limits>

#include "durero/io/json/json_writer.hpp"
#include "durero/io/number_text.hpp"
#include "support/catch.hpp"
#include "support/doubles.hpp"
#include "support/property.hpp"

using namespace durero;
using io::InputError;
using io::Source;
using io::json::Document;
using io::json::Reader;
using io::json::TokenKind;
using io::json::Writer;

namespace {

std::string error_of(const std::string& text) {
  const Source source("f", text);
  try {
    const Document document(source);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

}  // namespace

TEST_CASE("Each token has its kind and its offset") {
  const std::string text = R"( {"a":[1,-2.5e3, "s","\"\\",""],"é\n":{"n":null,"t":true,"f":false},"e":[],"o":{}} )";
  const Source source("f", text);
  const Document document(source);
  std::vector<std::pair<TokenKind, std::string>> seen;
  for (const auto token : document.tokens()) seen.emplace_back(token.kind, text.substr(token.offset, 1));
  using K = TokenKind;
  const std::vector<std::pair<TokenKind, std::string>> expected = {
      {K::object, "{"},    {K::key, "\""},    {K::array, "["},      {K::number, "1"},     {K::number, "-"},
      {K::string, "\""},   {K::string, "\""}, {K::string, "\""},    {K::end_array, "]"},  {K::key, "\""},
      {K::object, "{"},    {K::key, "\""},    {K::null, "n"},       {K::key, "\""},       {K::boolean, "t"},
      {K::key, "\""},      {K::boolean, "f"}, {K::end_object, "}"}, {K::key, "\""},       {K::array, "["},
      {K::end_array, "]"}, {K::key, "\""},    {K::object, "{"},     {K::end_object, "}"}, {K::end_object, "}"},
      {K::end, ""}};
  CHECK(seen == expected);
  const auto& tokens = document.tokens();
  CHECK(document.number_text(tokens[4]) == "-2.5e3");
  CHECK(document.string_value(tokens[5]) == "s");
  CHECK(document.string_value(tokens[6]) == "\"\\");
  CHECK(document.string_value(tokens[7]).empty());
  CHECK(document.string_value(tokens[9]) == "é\n");
}

TEST_CASE("A string reads back from its text, at its offset") {
  test::property("any bytes that JSON takes", [] {
    const auto piece = rc::gen::element<std::string>("a", "\"", "\\", "\n", "\x01", "é", "☃", "𝄞", "n", "u0041", " ");
    const auto pieces = *rc::gen::container<std::vector<std::string>>(piece);
    std::string value;
    for (const auto& p : pieces) value += p;
    std::string text;
    Writer(text).begin_array().value(value).end_array();
    const Source source("f", text);
    const Document document(source);
    RC_ASSERT(document.tokens().size() == 4U);
    RC_ASSERT(document.tokens()[1].offset == 1U);
    RC_ASSERT(document.string_value(document.tokens()[1]) == value);
  });
}

TEST_CASE("Numbers read to the nearest binary64") {
  test::property("as triples", [] {
    const glm::dvec3 v{*test::anyFinite(), *test::anyFinite(), *test::anyFinite()};
    std::string text;
    Writer(text).value(v);
    const Source source("f", text);
    const Document document(source);
    Reader in(document);
    RC_ASSERT(in.vec3("v") == v);
  });
  const Source source("f", "[2.2250738585072011e-308, 9007199254740993, 1e-400]");
  const Document document(source);
  Reader in(document);
  CHECK(in.vec3("v") == glm::dvec3(0x0.fffffffffffffp-1022, 9007199254740992.0, 0));
}

TEST_CASE("A number may have any number of digits and any exponent: its value decides") {
  const auto number = [](const std::string& text) {
    const Source source("f", text);
    const Document document(source);
    return Reader(document).number("n");
  };
  const std::string zeros(400, '0');
  CHECK(number("1" + zeros + "e-400") == 1);
  CHECK(number("-0." + zeros + "1e401") == -1);
  CHECK(number("0e999") == 0);
  CHECK(number("1e-999999999999") == 0);
  CHECK(number("17976931348623157" + std::string(292, '9')) == std::numeric_limits<double>::max());
  CHECK(number("9007199254740993." + zeros + "1") == 9007199254740994);  // just above the tie
  CHECK_THROWS_WITH(number("1" + zeros), Catch::Contains("f:1:1: n is \"1000") && Catch::Contains("beyond binary64"));
  CHECK_THROWS_WITH(number("-1e999"), "f:1:1: n is \"-1e999\", beyond binary64; expected a finite number");
  test::property("read as every other reader reads it", [&] {
    const auto digits = [](int most) {
      std::string text;
      for (int n = *rc::gen::inRange(1, most); n > 0; --n) text += static_cast<char>('0' + *rc::gen::inRange(0, 10));
      return text;
    };
    const std::string text = *rc::gen::element<std::string>("", "-") + std::to_string(*rc::gen::inRange(1, 10)) +
                             digits(400) + "." + digits(400) + "e-" + digits(4);
    const auto value = io::read_finite(text);
    if (value) RC_ASSERT(number(text) == *value);
  });
}

TEST_CASE("A quote or a number inside a string is no token") {
  const std::string text = R"(["1\"2\\",3,"\\\"-4e5","5"])";
  const Source source("f", text);
  const Document document(source);
  Reader in(document);
  std::vector<std::string> items;
  in.array("a", [&] {
    items.push_back(in.kind() == TokenKind::number ? io::number_text(in.number("n")) : std::string(in.string("s")));
  });
  CHECK(items == std::vector<std::string>{"1\"2\\", "3", "\\\"-4e5", "5"});
}

TEST_CASE("A string that ends with a backslash ends there: the number behind it is a token of any length") {
  const std::string text = R"(["\\",1)" + std::string(400, '0') + "e-400]";
  const Source source("f", text);
  const Document document(source);
  Reader in(document);
  in.array("a", [&] {
    const bool right = in.kind() == TokenKind::number ? in.number("n") == 1 : in.string("s") == "\\";
    CHECK(right);
  });
}

TEST_CASE("True and false are read as such, and nothing else is") {
  const Source source("f", "[true,false,1]");
  const Document document(source);
  Reader in(document);
  std::vector<bool> items;
  const auto read = [&] { in.array("a", [&] { items.push_back(in.boolean("b")); }); };
  CHECK_THROWS_WITH(read(), "f:1:13: b is a number; expected true or false");
  CHECK(items == std::vector<bool>{true, false});
}

TEST_CASE("A value is passed whole, whatever it is") {
  const Source source("f", R"({"a":[1,{"b":[]},"]"],"c":"{","d":{"e":{}},"f":7})");
  const Document document(source);
  Reader in(document);
  double f = 0;
  in.members("an object", [&](const io::json::Key& key) {
    if (key.name == "f")
      f = in.number("f");
    else
      in.skip();
  });
  CHECK(f == 7);
}

TEST_CASE("Errors of syntax have their place") {
  CHECK(error_of("") == "f:1:1: the text is empty; expected a JSON value");
  CHECK(error_of(" \n ") == "f:2:2: the text is empty; expected a JSON value");
  CHECK(error_of("\xEF\xBB\xBF{}") == "f:1:1: a byte order mark; expected UTF-8 without one");
  CHECK(error_of("{}\n x") == "f:2:2: \"x\" stands here after the value; expected the end of the text");
  CHECK(error_of("{\"a\":\n  NaN}").starts_with("f:2:3: \"N\" stands here; expected a JSON value"));
  CHECK(error_of("[1,2").starts_with("f:1:5: the text ends; expected , or ]"));
  CHECK(error_of("{\"a\"}").starts_with("f:1:5: \"}\" stands here; expected :"));
  CHECK(error_of("{a:1}").starts_with("f:1:2: \"a\" stands here; expected a key"));
  CHECK(error_of("[1,]").starts_with("f:1:4: "));
  CHECK(error_of("[01]").starts_with("f:1:3: "));
  CHECK(error_of("[\"\xC3\x28\"]").starts_with("f:1:3: \"\\xc3\" stands here inside a string; expected UTF-8"));
  CHECK(error_of("[\"\xED\xA0\x80\"]").starts_with("f:1:3: "));  // a surrogate
  CHECK(error_of("[\"\xC0\x80\"]").starts_with("f:1:3: "));      // an overlong NUL
  CHECK(error_of("[\"a\nb\"]").starts_with("f:1:4: "));
  CHECK(error_of("[1.]") == "f:1:4: \"]\" stands here in a number; expected a digit");
  CHECK(error_of("[1e+]") == "f:1:5: \"]\" stands here in a number; expected a digit");
  CHECK(error_of("[1.5.5]") == "f:1:5: \".\" stands here; expected , or ] after an item");
  CHECK(error_of("[1e--5]") == "f:1:5: \"-\" stands here in a number; expected a digit");
  CHECK(error_of("[1e5e5]") == "f:1:5: \"e\" stands here; expected , or ] after an item");
  CHECK(error_of("[-]").starts_with("f:1:3: \"]\" stands here; expected a JSON value"));
  CHECK(error_of("[+1]").starts_with("f:1:2: \"+\" stands here; expected a JSON value"));
  CHECK(error_of("[-01]") == "f:1:4: \"1\" stands here; expected , or ] after an item");
  CHECK(error_of("[true1]") == "f:1:6: \"1\" stands here; expected , or ] after an item");
  CHECK(error_of("[\"\\\"1]") == "f:1:7: the text ends inside a string; expected its closing quote");
  CHECK(error_of(std::string("{}\0", 3)).starts_with("f:1:3: a NUL byte"));
  CHECK(error_of(std::string("[1,\0 2]", 7)).starts_with("f:1:4: "));
}

TEST_CASE("Nesting a million deep is an error, not a crash") {
  CHECK(error_of(std::string(1000000, '[')).starts_with("f:1:1000001: the text ends"));
  const std::string balanced = std::string(1000000, '[') + std::string(1000000, ']');
  CHECK(error_of(balanced).empty());
  std::string objects;
  for (int i = 0; i < 200000; ++i) objects += "{\"a\":";
  CHECK(error_of(objects).starts_with("f:1:1000001: the text ends"));
}

TEST_CASE("A reader's errors stand at the value or the key") {
  const auto error = [](const std::string& text, auto read) {
    const Source source("f", text);
    const Document document(source);
    Reader in(document);
    try {
      read(in);
    } catch (const InputError& e) {
      return std::string(e.what());
    }
    return std::string();
  };
  constexpr std::string_view keys[] = {"a", "b"};
  const auto object = [&](Reader& in) { in.object("o", keys, 1, [&](std::size_t) { in.number("n"); }); };
  CHECK(error("{\"a\":1}", object).empty());
  CHECK(error("{\"a\":\"1\"}", object) == "f:1:6: n is a string; expected a number");
  CHECK(error("{\"a\":1,\n\"c\":2}", object) == "f:2:1: unknown key \"c\" in o; expected one of a, b");
  CHECK(error("{\"a\":1,\"a\":2}", object) == "f:1:8: key \"a\" stands twice; expected it once");
  CHECK(error(" {\"b\":1}", object) == "f:1:2: key \"a\" is missing in o; expected it");
  CHECK(error("[]", object) == "f:1:1: o is an array; expected an object");
  const auto triple = [](Reader& in) { in.vec3("v"); };
  CHECK(error("[1,2]", triple) == "f:1:1: v has 2 items; expected three numbers");
  CHECK(error("[1,2,3,4]", triple) == "f:1:8: v has a fourth item; expected three numbers");
  CHECK(error("[1,null,3]", triple) == "f:1:4: v is null; expected a number");
  CHECK(error("[1,{},3]", triple) == "f:1:4: v is an object; expected a number");
  CHECK(error("1.7976931348623159e308", [](Reader& in) { in.number("n"); }) ==
        "f:1:1: n is \"1.7976931348623159e308\", beyond binary64; expected a finite number");
}
