// The part of a SARIF log that is the same whatever it tells of.
#include "durero/io/json/sarif.hpp"

#include <array>

#include "support/catch.hpp"

using namespace durero;

TEST_CASE("A log has its version, a run, the tool and its rules, then what the caller adds") {
  std::string text;
  io::json::Writer out(text);
  const std::array<io::SarifRule, 2> rules{{{"a", "the \"first\""}, {"b", "the second"}}};
  io::begin_sarif(out, "durero x", rules);
  out.key("results").begin_array();
  io::end_sarif(out);
  CHECK(text == R"({"$schema":"https://json.schemastore.org/sarif-2.1.0.json","version":"2.1.0",
"runs":[{"tool":{"driver":{"name":"durero x","rules":[
{"id":"a","shortDescription":{"text":"the \"first\""}},
{"id":"b","shortDescription":{"text":"the second"}}]}},
"results":[]}]})");
}

TEST_CASE("A file's name is a reference, of which other bytes than letters and digits are escaped") {
  CHECK(io::sarif_uri("a/b-1.obj") == "a/b-1.obj");
  CHECK(io::sarif_uri("/a b/ñ") == "file:///a%20b/%C3%B1");
}
