#include "durero/io/json/asked_parts.hpp"

#include "durero/scene/edit.hpp"
#include "support/catch.hpp"

namespace durero::io {
namespace {

using Catch::Matchers::Message;

/// A scene of the spheres a and b.
scene::Scene spheres() {
  scene::Scene scene;
  for (const char* name : {"a", "b"}) scene.add(model::Elemento(name), scene::Sphere{{0, 0, 0}, 1});
  return scene;
}

template <class Read>
auto reading(const std::string& text, Read read) {
  const Source source("q", text);
  const json::Document document(source);
  json::Reader in(document);
  return read(in, source);
}

std::string script(const std::string& text) {
  return reading(text, [](json::Reader& in, const Source& source) { return read_json_script(in, source); });
}

std::vector<scene::Query> rays(const std::string& text) {
  const scene::Scene scene = spheres();
  return reading(text, [&](json::Reader& in, const Source&) { return read_json_rays(in, scene); });
}

TEST_CASE("operations are lines, and an object becomes one") {
  CHECK(script("[]").empty());
  CHECK(script("[\"group g=x\",{\"op\":\n \"ungroup\",\"g\":\"}\"} , \"x\"]") ==
        "group g=x\n{\"op\":  \"ungroup\",\"g\":\"}\"}\nx\n");
  CHECK_THROWS_MATCHES(script("[\"a\\nb\"]"), InputError,
                       Message("q:1:2: an operation has a line end; expected one line"));
  CHECK_THROWS_MATCHES(script("[1]"), InputError, Message("q:1:2: an operation is a number; expected a string"));
}

TEST_CASE("an object is taken as it is written") {
  reading("[ {\"a\":{}}\n, 1]", [](json::Reader& in, const Source& source) {
    in.array("it", [&] {
      if (in.kind() == json::TokenKind::object)
        CHECK(object_text(in, source) == "{\"a\":{}}");
      else
        in.skip();
    });
    return 0;
  });
}

TEST_CASE("rays are six numbers, perhaps with the elements that they start on, each once and ascending") {
  const auto read = rays("[[0,1,2,3,4,5],{\"on\":[\"b\",\"a\",\"b\"],\"ray\":[0,0,0,1,0,0]}]");
  REQUIRE(read.size() == 2);
  CHECK(read[0].rayo.p().xyz() == glm::dvec3(0, 1, 2));
  CHECK(read[0].rayo.v().xyz() == glm::dvec3(3, 4, 5));
  CHECK(read[0].en.empty());
  REQUIRE(read[1].en.size() == 2);
  CHECK(read[1].en[0].index < read[1].en[1].index);
}

TEST_CASE("rays that are none are refused at their place") {
  CHECK_THROWS_MATCHES(rays("[[1,2,3]]"), InputError, Message("q:1:2: a ray has 3 numbers; expected six"));
  CHECK_THROWS_MATCHES(rays("[[1,2,3,0,0,0]]"), InputError,
                       Message("q:1:2: the direction of a ray is 0; expected another one"));
  CHECK_THROWS_MATCHES(rays("[{\"ray\":[1,2,3,0,0,1],\"on\":[\"c\"]}]"), InputError,
                       Message("q:1:29: no element is called \"c\"; expected an element of the scene"));
  CHECK_THROWS_MATCHES(rays("[{\"on\":[]}]"), InputError,
                       Message("q:1:2: key \"ray\" is missing in a ray; expected it"));
}

TEST_CASE("a direction is three numbers, not all of them 0") {
  const auto direction = [](const std::string& text) {
    return reading(text, [](json::Reader& in, const Source&) { return read_json_direction(in); });
  };
  CHECK(direction("[0,0,-2]") == glm::dvec3(0, 0, -2));
  CHECK_THROWS_MATCHES(direction("[0,-0.0,0]"), InputError,
                       Message("q:1:1: the direction of a ray is 0; expected another one"));
}

}  // namespace
}  // namespace durero::io
