// All that is wrong with a scene file is found, with its label, its pointer and its place.
#include "durero/io/json/scene_check.hpp"

#include <fmt/format.h>

#include "durero/io/json/scene_file.hpp"
#include "durero/model/operaciones.hpp"
#include "support/catch.hpp"

using namespace durero;
using io::SceneDefect;

namespace {

std::string sphere(std::string_view id, std::string_view more) {
  return fmt::format(R"({{"id":"{}","tipo":"esfera","centro":[0,0,0],{}}})", id, more);
}
std::string scene_of(const std::string& elements, const std::string& more = "") {
  return "{\"format\":\"durero-scene\",\"version\":1," + more + "\"elementos\":[\n" + elements + "]}";
}

io::SceneCheck check_of(const std::string& text) { return io::check_scene(io::Source("f", text)); }

/// `LABEL POINTER LINE` of each finding.
std::vector<std::string> found_in(const std::string& text) {
  std::vector<std::string> all;
  for (const SceneDefect& finding : check_of(text).findings)
    all.push_back(fmt::format("{} {} {}", finding.broken == nullptr ? "malformed" : finding.broken->label,
                              finding.pointer.value_or("none"), finding.place.line));
  return all;
}

using Found = std::vector<std::string>;

std::string first_error(const std::string& text) {
  try {
    io::read_scene(io::Source("f", text));
  } catch (const io::InputError& error) {
    return error.what();
  }
  return "";
}

}  // namespace

TEST_CASE("A scene that is right has its invariants and no finding") {
  const io::SceneCheck check = check_of(scene_of(sphere("a", R"("radio":1)")));
  CHECK(check.errors.empty());
  CHECK(check.findings.empty());
  CHECK(check.invariants.size() == 9);
  CHECK(check.scene.size() == 1);
  CHECK(check_text(check).starts_with("f: 1 elementos: 1 esfera, 0 cilindro"));
  CHECK(check_json(check).find(R"("ok":true,)") != std::string::npos);
  CHECK(check_json(check).find(R"({"label":"Escena.inv.9","predicate":)") != std::string::npos);
  CHECK(check_sarif(check).find(R"("results":[]})") != std::string::npos);
}

TEST_CASE("Every element that is wrong is found, and the others are read") {
  const std::string text = scene_of(sphere("a", R"("radio":1)") + ",\n" + sphere("b", R"("radio":0)") + ",\n" +
                                    sphere("a", R"("radio":1)") + ",\n" + sphere("c", R"("altura":1,"radio":2)") +
                                    ",\n" + R"({"id":"d","tipo":"esfera","centro":[0,0,0]},)" + "\n7,\n" +
                                    sphere("e/f", R"("radio":1)") + ",\n" + sphere("g", R"("radio":1,"material":"m")") +
                                    ",\n" + sphere("h", R"("radio":3)") + ",\n" + sphere("i", R"("radio":0)"));
  CHECK(found_in(text) == Found{"Rmas.inv.1 /elementos/1/radio 3", "Agregar_Elemento.pre.1 /elementos/2/id 4",
                                "Escena.inv.5 /elementos/3/altura 5", "Escena.inv.3 /elementos/4 6",
                                "malformed /elementos/5 7", "malformed /elementos/6/id 8",
                                "malformed /elementos/7/material 9", "Rmas.inv.1 /elementos/9/radio 11"});
  const io::SceneCheck check = check_of(text);
  CHECK(check.scene.find("a").has_value());
  CHECK(check.scene.find("h").has_value());
  CHECK_FALSE(check.scene.find("b").has_value());
  CHECK(check.invariants.empty());
}

TEST_CASE("Each attribute that is missing or too many breaks the invariant that says who has it") {
  const auto found = [](const std::string& tipo, const std::string& attributes) {
    return found_in(scene_of(fmt::format(R"({{"id":"a","tipo":"{}",{}}})", tipo, attributes))).at(0);
  };
  const std::string c = R"("centro":[0,0,0])", v = R"("vector":[0,1,0])", r = R"("radio":1)", h = R"("altura":1)";
  CHECK(found("esfera", r) == "Escena.inv.2 /elementos/0 2");
  CHECK(found("disco", c + "," + v) == "Escena.inv.3 /elementos/0 2");
  CHECK(found("plano", c) == "Escena.inv.4 /elementos/0 2");
  CHECK(found("cilindro", c + "," + v + "," + r) == "Escena.inv.5 /elementos/0 2");
  CHECK(found("cono", c + "," + v + "," + h) == "Escena.inv.6 /elementos/0 2");
  CHECK(found("triangulo", R"("material":"m")") == "Escena.inv.9 /elementos/0 2");
  CHECK(found("plano", c + R"(,"vector":[0,2,0])") == "Unitario.inv.1 /elementos/0/vector 2");
  CHECK(found("triangulo", R"("vertices":[[0,0,0],[1,1,1],[2,2,2]])") == "Vertices.inv.1 /elementos/0/vertices 2");
}

TEST_CASE("Other members that are wrong are passed over too; a file that cannot be read further has one finding more") {
  CHECK(found_in(scene_of(sphere("a", R"("radio":-1)"), "\"background\":7,\n\"lights\":[{}],")) ==
        Found{"malformed /background 1", "malformed /lights/0 2", "Rmas.inv.1 /elementos/0/radio 3"});
  CHECK(found_in(scene_of(sphere("a", R"("radio":-1)")) + "]") == Found{"malformed none 2"});
  CHECK(found_in("{\"elementos\":[7],\n\"color\":1,\"version\":1}") ==
        Found{"malformed /elementos/0 1", "malformed /color 2"});
  CHECK(found_in("{\"layers\":[],\"elementos\":[7],\n\"version\":2}") == Found{"malformed /version 2"});
  CHECK(found_in("[]") == Found{"malformed  1"});
}

TEST_CASE("Where the materials are wrong, nothing is said of who names them") {
  const std::string wrong = R"("materials":{"m":{"color":[2,0,0]}},)";
  CHECK(found_in(scene_of(sphere("a", R"("radio":1,"material":"m")"), wrong)) ==
        Found{"Material.inv.6 /materials/m/color 1"});
}

TEST_CASE("The first error that is met is the one that reading throws") {
  for (const std::string& text :
       {scene_of(sphere("a", R"("radio":0)") + "," + sphere("a b", R"("radio":0)")), scene_of("7", "\"background\":7,"),
        scene_of(sphere("a", R"("radio":1,"material":"m")") + "," + sphere("b", R"("radio":0)")),
        std::string("{\"elementos\":[7]}"), std::string("{"), std::string("{\"version\":2}")}) {
    const io::SceneCheck check = check_of(text);
    REQUIRE_FALSE(check.errors.empty());
    CHECK(check.errors.front().what() == first_error(text));
  }
}

TEST_CASE("An invariant that does not hold is found at the element that breaks it") {
  const io::Source file("f", scene_of(sphere("a", R"("radio":1)") + ",\n" + sphere("b", R"("radio":1)")));
  model::Escena escena;
  for (const char* id : {"a", "b"}) {
    const model::Elemento e{id};
    escena.elementos.insert(e);
    escena.de_que_tipo.emplace(e, model::Tipo::soy_esfera);
    escena.mi_centro.emplace(e, model::Punto{0, 0, 0});
  }
  escena.mi_radio.emplace(model::Elemento{"a"}, model::Rmas{1});
  escena.tipos.insert(model::Tipo::soy_esfera);
  const std::vector<SceneDefect> findings = broken_invariants(file, escena);
  REQUIRE(findings.size() == 1);
  CHECK(findings[0].broken->label == "Escena.inv.3");
  CHECK(findings[0].pointer == "/elementos/1");
  CHECK(findings[0].place == io::TextPosition{3, 1});
  CHECK(findings[0].message == "element b breaks Escena.inv.3");
}

TEST_CASE("SARIF has a rule for each label, the place as a region, and the file as a URI") {
  const io::Source file("/a b/ñ.json", scene_of(sphere("a", R"("radio":0)") + ",7"));
  const std::string sarif = check_sarif(io::check_scene(file));
  for (const char* part :
       {R"({"id":"Rmas.inv.1","shortDescription":{"text":"r > 0"}})", R"({"id":"Escena.inv.9",)",
        R"({"id":"malformed",)",
        R"({"ruleId":"Rmas.inv.1","level":"error","message":{"text":"radio (radius) is 0; expected r > 0 (Rmas)",
        R"("artifactLocation":{"uri":"file:///a%20b/%C3%B1.json"},"region":{"startLine":2,"startColumn":52})",
        R"("logicalLocations":[{"fullyQualifiedName":"/elementos/0/radio"}])", R"({"ruleId":"malformed",)"})
    CHECK(sarif.find(part) != sarif.npos);
}
