// Solids in files: scene files, scripts and POV-Ray's language.
#include <fmt/format.h>

#include "durero/io/json/edited_scene.hpp"
#include "durero/io/json/groups_file.hpp"
#include "durero/io/json/scene_file.hpp"
#include "durero/io/pov/pov.hpp"
#include "durero/scene/body.hpp"
#include "durero/scene/stage.hpp"
#include "io/malformed.hpp"
#include "support/catch.hpp"

using namespace durero;
using Operation = scene::Compound::Operation;

namespace {

std::string file(const std::string& elements, const std::string& rest = "") {
  return fmt::format(R"({{"format":"durero-scene","version":1,{}"elementos":[{}]}})", rest, elements);
}
std::string solid(const std::string& parts) { return file(R"({"id":"s","tipo":"union","de":[)" + parts + "]}"); }

const auto reading = [](const io::Source& s) { return io::read_grouped_scene(s, io::Bodies::read); };
scene::GroupedScene read(const std::string& text) { return reading(io::Source("f", text)); }
std::string text_of(const scene::GroupedScene& of) { return io::scene_text(of.scene, of.groups); }
std::string error_at(const std::string& with_mark) { return test::error_at_mark(with_mark, reading); }

const scene::Compound& solid_named(const scene::GroupedScene& of, const char* name) {
  return std::get<scene::Compound>(of.scene.body(of.scene.find(name).value())->form);
}

const std::string ball = R"({"tipo":"esfera","centro":[0,0,0],"radio":1})",
                  half = R"({"tipo":"plano","centro":[0,0,0],"vector":[0,0,1]})",
                  can = R"({"tipo":"cilindro","centro":[0,0,0],"radio":1,"vector":[0,0,1],"altura":2})";

}  // namespace

TEST_CASE("Solids are read with their parts in order, and written as they are read") {
  const std::string elements = R"({"id":"a","tipo":"diferencia","de":[)" + can + "," + ball +
                               R"(,{"tipo":"interseccion","de":[)" + half + "," + ball + R"(]}],"material":"red"})";
  const std::string text = file(elements, R"("materials":{"red":{"color":[1,0,0]}},)");
  const scene::GroupedScene scene = read(text);
  const scene::Compound& a = solid_named(scene, "a");
  CHECK(a.operation == Operation::subtracted);
  REQUIRE(a.parts.size() == 3);
  CHECK(std::holds_alternative<scene::Cylinder>(std::get<scene::Instance>(a.parts[0].form).shape));
  CHECK(std::get<scene::Compound>(a.parts[2].form).operation == Operation::intersected);
  CHECK(scene.scene.material(scene.scene.find("a").value()) == 0);
  const std::string written = text_of(scene);
  CHECK(written.find(elements.substr(0, 60)) != std::string::npos);
  CHECK(text_of(read(written)) == written);
}

TEST_CASE("Parts are named, above or below; boxes and instances are parts, and solids have copies") {
  const scene::GroupedScene scene =
      read(file(R"({"id":"s","tipo":"union","de":["b","box"]},{"id":"b","tipo":"esfera","centro":[1,2,3],"radio":4},)"
                R"({"id":"box","tipo":"caja","esquinas":[[1,1,1],[0,0,0]]},)"
                R"({"id":"copy","tipo":"instancia","de":"s","mapa":[[1,0,0,5],[0,1,0,0],[0,0,1,0]]})"));
  const scene::Compound& s = solid_named(scene, "s");
  CHECK(std::get<scene::Sphere>(std::get<scene::Instance>(s.parts[0].form).shape).radio == 4);
  CHECK(std::get<scene::Compound>(s.parts[1].form).parts.size() == 6);
  const auto& moved = std::get<scene::Instance>(solid_named(scene, "copy").parts[0].form);
  CHECK(moved.mapa.centro.x == 5);
  const std::string written = text_of(scene);
  CHECK(written.find(R"({"id":"copy","tipo":"union","de":[{"tipo":"instancia","de":{"tipo":"esfera")") !=
        std::string::npos);
  CHECK(text_of(read(written)) == written);
}

TEST_CASE("A malformed solid is an error with its place") {
  CHECK(error_at(solid(ball).insert(solid(ball).find("[{\"tipo\":\"esf"), "^")) ==
        "de has fewer than two parts; expected two or more");
  CHECK(error_at(solid(ball + R"(,^{"tipo":"disco","centro":[0,0,0],"radio":1,"vector":[0,0,1]})")) ==
        "a disc or a triangle bounds no solid; expected a sphere, cylinder, cone, truncated cone, plane or solid");
  CHECK(error_at(solid(ball + R"(,^"nobody")")).starts_with("\"nobody\" is no element"));
  CHECK(error_at(solid(ball + R"(,^"s")")).starts_with("\"s\" is made of itself"));
  CHECK(error_at(solid(ball + R"(,{"tipo":"esfera","centro":[0,0,0],"radio":^0})")).starts_with("radio (radius) is 0"));
  CHECK(error_at(file(R"({"id":"s","tipo":"caja","esquinas":^[[0,0,0],[1,1,0]]})")) ==
        "the corners lie in one plane across an axis; expected two that differ in x, y and z");
  CHECK(error_at(file(R"({"id":"s","tipo":"caja","esquinas":^[[0,0,0]]})")) == "esquinas has 1 corners; expected two");
  std::string many = ball;
  for (int i = 0; i < 999; ++i) many += "," + ball;
  CHECK(read(solid(many)).scene.size() == 1);
  CHECK(error_at(solid(many + ",^" + ball)) == "a solid has more than 1000 shapes; expected fewer");
}

TEST_CASE("Scripts join elements, and remove what is joined") {
  io::EditedScene edited(read(file(R"({"id":"a",)" + ball.substr(1) + R"(,{"id":"c",)" + can.substr(1) +
                                   R"(,{"id":"d","tipo":"disco","centro":[0,0,0],"radio":1,"vector":[0,0,1]})")));
  const std::string script =
      "Agregar_Diferencia e?=s de?=c,a\n"
      R"({"op":"Agregar_Union","e":"t","de":["s","a"]})"
      "\nAgregar_Interseccion e?=u de?=a,d\nAgregar_Union e?=a de?=a,c\nEliminar_Esfera e?=s\nEliminar_Solido e?=a\n"
      "Eliminar_Solido e?=s\n";
  std::string answers;
  for (const io::ScriptStep& step : io::read_script(io::Source("f", script), edited.stage()))
    answers += io::answer_text(step.line, edited.apply_total(step)) + "\n";
  CHECK(answers ==
        R"({"line":1,"ok":true,"r":"solido_agregado"}
{"line":2,"ok":true,"r":"solido_agregado"}
{"line":3,"ok":false,"r":"no_es_solido","violated":"Agregar_Solido.pre.3","predicate":"ran de? ∩ (discos ∪ triangulos) = ∅"}
{"line":4,"ok":false,"r":"elemento_ya_existe","violated":"Agregar_Solido.pre.1","predicate":"e? ∉ elementos"}
{"line":5,"ok":false,"r":"tipo_incorrecto","violated":"Eliminar_Esfera.pre.1","predicate":"de_que_tipo(e?) = soy_esfera"}
{"line":6,"ok":false,"r":"tipo_incorrecto","violated":"Eliminar_Solido.pre.2","predicate":"e? ∈ solidos"}
{"line":7,"ok":true,"r":"solido_eliminado"}
)");
  CHECK(edited.of().scene.size() == 4);
  CHECK(solid_named(edited.of(), "t").parts.size() == 2);
  const auto refused = [&](const std::string& line) {
    return test::error_at_mark(line, [&](const io::Source& s) { return io::read_script(s, edited.stage()); });
  };
  CHECK(refused("Agregar_Union e?=v de?=^a").ends_with("de has fewer than two parts; expected two or more"));
}

TEST_CASE("POV-Ray has solids, closed ones, and gives them back") {
  const scene::GroupedScene scene =
      read(file(R"({"id":"s","tipo":"diferencia","de":[)" + can + R"(,{"tipo":"union","de":[)" + ball + "," + half +
                    R"(]}],"material":"red"})",
                R"("materials":{"red":{"color":[1,0,0]}},)"));
  const io::Exported exported = io::pov_text(scene.scene, scene.groups);
  CHECK(exported.text.find("difference { cylinder { <0, 0, 0>, <0, 0, 2>, 1 } merge { sphere { <0, 0, 0>, 1 } plane") !=
        std::string::npos);
  const io::Imported back = io::read_pov(io::Source("f", exported.text));
  const auto element = back.scene.find("b1");
  REQUIRE(element);
  const auto& solid = std::get<scene::Compound>(back.scene.body(*element)->form);
  CHECK(solid.operation == Operation::subtracted);
  CHECK(std::get<scene::Compound>(solid.parts[1].form).operation == Operation::united);
  CHECK(back.scene.material(*element).has_value());
}

TEST_CASE("POV-Ray's boxes and unions in solids; the look of a solid is its own, or the first of its parts") {
  const io::Imported imported =
      io::read_pov(io::Source("f",
                              "#version 3.7;\n"
                              "difference { box { <1, 1, 1>, 0 pigment { rgb 1 } }\n"
                              "  union { sphere { 0, 1 } sphere { 1, 1 pigment { rgb 0 } } } }\n"
                              "box { 0, 2 pigment { rgb <1, 0, 0> } }\n"
                              "intersection { }\nmerge { object { sphere { 0, 1 } } }"));
  REQUIRE(imported.scene.find("b3"));
  const auto& whole = std::get<scene::Compound>(imported.scene.body(*imported.scene.find("b1"))->form);
  CHECK(whole.operation == Operation::subtracted);
  CHECK(std::get<scene::Compound>(whole.parts[0].form).parts.size() == 6);
  CHECK(std::get<scene::Compound>(whole.parts[1].form).operation == Operation::united);
  CHECK(imported.scene.material(*imported.scene.find("b1")).has_value());
  CHECK(std::holds_alternative<scene::Instance>(imported.scene.body(*imported.scene.find("b3"))->form));
  CHECK(std::ranges::find(imported.lost, "1 part of a solid without its own texture: a solid has one") !=
        imported.lost.end());
}
