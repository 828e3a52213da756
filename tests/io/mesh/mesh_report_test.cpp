#include "durero/io/mesh/mesh_report.hpp"

#include "support/catch.hpp"

using namespace durero;
using namespace durero::io;

namespace {

MeshCheck told(std::vector<MeshDefect> findings) {
  return {"m n", 4, 5, 1, "4/3", std::nullopt, std::move(findings), {{"a", 4, "4/3"}}, {}};
}

const MeshDefect junction{"uniones_en_t", {"a", "b"}, {{1, 0, 0}, {0.5, 0, 0}}, "a vertex", {"one", "two"}};

}  // namespace

TEST_CASE("a mesh without a finding is one line, and one object") {
  CHECK(mesh_check_text(told({})) == "m n: 4 triangles, 5 vertices, 1 piece, volume 4/3\n");
  CHECK(mesh_check_json(told({})) ==
        "{\"format\":\"durero-mesh-check\",\"version\":1,\"file\":\"m n\",\"ok\":true,\"triangles\":4,\"vertices\":5,"
        "\"pieces\":1,\"volume\":\"4/3\",\"each_piece\":[{\"first\":\"a\",\"triangles\":4,\"volume\":\"4/3\"}],"
        "\"findings\":[]}\n");
}

TEST_CASE("several pieces have a line each, and those that are not listed are counted") {
  MeshCheck check = told({});
  check.pieces = 4;
  check.listed_pieces = {{"a", 4, "4/3"}, {"e", 1, std::nullopt}};
  CHECK(mesh_check_text(check) ==
        "m n: 4 triangles, 5 vertices, 4 pieces, volume 4/3\n"
        "piece of a: 4 triangles, volume 4/3\n"
        "piece of e: 1 triangle, volume none, as they bound none\n"
        "pieces: 2 more\n");
  CHECK(mesh_check_json(check).find("\"each_piece\":[{\"first\":\"a\",\"triangles\":4,\"volume\":\"4/3\"},"
                                    "{\"first\":\"e\",\"triangles\":1}]") != std::string::npos);
}

TEST_CASE("findings that are not listed are counted in each format") {
  MeshCheck check = told({junction});
  check.unlisted = {{"uniones_en_t", 7}};
  CHECK(mesh_check_text(check).ends_with("two\nuniones_en_t: 7 more\n"));
  CHECK(mesh_check_json(check).ends_with("}],\"unlisted\":{\"uniones_en_t\":7}}\n"));
  CHECK(mesh_check_sarif(check).find(
            "{\"ruleId\":\"uniones_en_t\",\"level\":\"error\",\"message\":{\"text\":\"7 more\"}}") !=
        std::string::npos);
}

TEST_CASE("a finding is told with its faces, its places and what mends it") {
  CHECK(mesh_check_text(told({junction})) ==
        "m n: 4 triangles, 5 vertices, 1 piece, volume 4/3\n"
        "uniones_en_t: a, b: (1,0,0) (0.5,0,0): a vertex; mended by one, then two\n");
  CHECK(mesh_check_json(told({junction}))
            .find("\n{\"kind\":\"uniones_en_t\",\"faces\":[\"a\",\"b\"],\"places\":[[1,0,0],"
                  "[0.5,0,0]],\"message\":\"a vertex\",\"mended\":[\"one\",\"two\"]}]}") != std::string::npos);
}

TEST_CASE("a finding is a result of SARIF") {
  CHECK(
      mesh_check_sarif(told({junction}))
          .find(
              R"({"ruleId":"uniones_en_t","level":"error","message":{"text":)"
              R"("(1,0,0) (0.5,0,0): a vertex; mended by one, then two"},"locations":[{"physicalLocation":{"artifactLocation":)"
              R"({"uri":"m%20n"}},"logicalLocations":[{"fullyQualifiedName":"a"},{"fullyQualifiedName":"b"}]}]})") !=
      std::string::npos);
}

TEST_CASE("a point is told with its side") {
  MeshCheck check = told({});
  const auto line = [&](const std::string& side) {
    check.point = {{1, 2, 3}, side};
    const std::string text = mesh_check_text(check);
    return text.substr(text.find('\n') + 1);
  };
  CHECK(line("inside") == "(1,2,3): inside\n");
  CHECK(line("surface") == "(1,2,3): on the surface\n");
  CHECK(line("none") == "(1,2,3): on no side, as the triangles bound nothing\n");
}
