#include "durero/io/json/json_writer.hpp"

#include <limits>

#include "support/catch.hpp"

using namespace durero;
using io::json::Writer;

namespace {

template <class Write>
std::string written(Write&& write) {
  std::string text;
  Writer out(text);
  write(out);
  return text;
}

}  // namespace

TEST_CASE("Commas stand between members and between items, and nowhere else") {
  CHECK(written([](Writer& out) {
          out.begin_object().member("a", 1.5).key("b").begin_array().value("x").begin_array().end_array();
          out.begin_object().end_object().value(true).end_array().member("c", std::uint64_t{7}).end_object();
        }) == R"({"a":1.5,"b":["x",[],{},true],"c":7})");
  CHECK(written([](Writer& out) { out.begin_array().end_array(); }) == "[]");
}

TEST_CASE("A new line stands before a member, an item or an end, behind the comma") {
  CHECK(written([](Writer& out) {
          out.begin_object().new_line().member("a", false).new_line().key("b").begin_array().new_line().value(1.0);
          out.new_line().value(2.0).new_line().end_array().end_object();
        }) == "{\n\"a\":false,\n\"b\":[\n1,\n2\n]}");
}

TEST_CASE("Strings are escaped, as keys and as values") {
  CHECK(written([](Writer& out) { out.begin_object().member("\"k\n", "\\ \x01\x1F\x7F ñ").end_object(); }) ==
        "{\"\\\"k\\u000a\":\"\\\\ \\u0001\\u001f\x7F ñ\"}");
}

TEST_CASE("Numbers are the shortest that read back; an infinity is a string") {
  const double infinity = std::numeric_limits<double>::infinity();
  CHECK(written([&](Writer& out) {
          out.begin_array().value(0.1).value(-0.0).value(4.0).value(infinity).value(-infinity).end_array();
        }) == R"([0.1,-0,4,"inf","-inf"])");
  CHECK(written([](Writer& out) { out.value(std::numeric_limits<std::uint64_t>::max()); }) == "18446744073709551615");
  CHECK(written([&](Writer& out) { out.value(std::numeric_limits<double>::quiet_NaN()); }) == R"("nan")");
  CHECK(written([&](Writer& out) { out.value(glm::dvec3(1, 2.5, -infinity)); }) == R"([1,2.5,"-inf"])");
}
