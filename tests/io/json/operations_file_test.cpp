#include "durero/io/json/operations_file.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "durero/model/operaciones.hpp"
#include "durero/scene/stage.hpp"
#include "io/malformed.hpp"
#include "io/random_scene.hpp"
#include "support/catch.hpp"
#include "support/property.hpp"

using namespace durero;

namespace {

scene::Stage stage_with_red() {
  scene::Stage stage;
  stage.materials = {{"blue", {0, 0, 1}}, {"red", {1, 0, 0}}};
  return stage;
}

const auto reading = [](const io::Source& source) { return io::read_script(source, stage_with_red()); };
std::string error_at(const std::string& with_mark) { return test::error_at_mark(with_mark, reading); }

const model::Operation& operation(const io::ScriptStep& step) { return std::get<scene::Edit>(step.edit).operation; }

// The answers of a script, one a line.
std::string answers(scene::Scene& scene, const std::string& script) {
  std::string all;
  for (const auto& [line, edit] : io::read_script(io::Source("f", script), scene.stage())) {
    all += io::answer_text(line, io::edit_answer(scene.apply_total(std::get<scene::Edit>(edit)))) + "\n";
  }
  return all;
}

}  // namespace

TEST_CASE("Every operation, in both syntaxes, is answered") {
  scene::Scene scene;
  CHECK(answers(scene, R"(# a script
Agregar_Esfera e?=s1 centro?=(0,0,5) radio?=1

  Agregar_Cilindro e=c1 centro=( 0 , 0x1p-1 , -5e0 ) radio=1 vector=(0,1,0) altura=2 # the ? is optional
{"op":"Agregar_Cono","e":"k1","centro":[0,0,5],"proporcion":1,"vector":[0,1,0],"altura":2}
Agregar_Elemento e?=s2 t?=soy_esfera centro?=(0,0,5) radio?=1
{"e?":"k2","op":"Agregar_Elemento","t":"soy_cono","centro":[0,0,5],"proporcion":1,"vector":[0,1,0],"altura":2,"radio":-1}
Eliminar_Esfera e?=s1
Eliminar_Cilindro e?=c1
{"op":"Eliminar_Cono","e":"k1"}
Eliminar_Elemento e?=k2)") ==
        R"({"line":2,"ok":true,"r":"esfera_agregada"}
{"line":4,"ok":true,"r":"cilindro_agregado"}
{"line":5,"ok":true,"r":"cono_agregado"}
{"line":6,"ok":true,"r":"elemento_agregado"}
{"line":7,"ok":true,"r":"elemento_agregado"}
{"line":8,"ok":true,"r":"esfera_eliminada"}
{"line":9,"ok":true,"r":"cilindro_eliminado"}
{"line":10,"ok":true,"r":"cono_eliminado"}
{"line":11,"ok":true,"r":"elemento_eliminado"}
)");
  CHECK(scene.size() == 1);
}

TEST_CASE("A script may close elements, and names what closes them where it does not") {
  const auto steps = io::read_script(io::Source("f",
                                                "close e?=can\nclose e=can base=bottom top?=lid\n"
                                                R"({"op":"close","e":"hat","base":"b"})"),
                                     {});
  REQUIRE(steps.size() == 3);
  const auto closing = [&](std::size_t i) {
    const auto& [e, base, top] = std::get<scene::Closing>(steps[i].edit);
    return std::array{e, base, top};
  };
  CHECK(closing(0) == std::array<std::string, 3>{"can", "can:base", "can:top"});
  CHECK(closing(1) == std::array<std::string, 3>{"can", "bottom", "lid"});
  CHECK(closing(2) == std::array<std::string, 3>{"hat", "b", "hat:top"});
  const std::string longest(128, 'a');
  CHECK_THROWS_AS(io::read_script(io::Source("f", "close e?=" + longest), {}), io::InputError);
  CHECK(io::read_script(io::Source("f", "close e?=" + longest + " base?=b top?=t"), {}).size() == 1);
}

TEST_CASE("A script may edit groups too, in both syntaxes") {
  const std::string script = R"(group g?=pair elementos?=s1,s2
group g=row groups=pair,other elementos=s3
{"op":"group","g?":"none","elementos":[]}
ungroup g?=pair
{"op":"ungroup","g":"row"}
Eliminar_Esfera e?=s1)";
  const auto steps = io::read_script(io::Source("f", script), {});
  REQUIRE(steps.size() == 6);
  const auto grouping = [&](std::size_t i) {
    return std::get<scene::Grouping>(std::get<scene::GroupEdit>(steps[i].edit));
  };
  CHECK(grouping(0).g == "pair");
  CHECK((grouping(0).of == scene::Group{{"s1", "s2"}, {}}));
  CHECK((grouping(1).of == scene::Group{{"s3"}, {"other", "pair"}}));
  CHECK((grouping(2).of == scene::Group{}));
  CHECK(std::get<scene::Ungrouping>(std::get<scene::GroupEdit>(steps[3].edit)).g == "pair");
  CHECK(std::get<scene::Ungrouping>(std::get<scene::GroupEdit>(steps[4].edit)).g == "row");
  CHECK(std::holds_alternative<scene::Edit>(steps[5].edit));
  CHECK(steps[5].line == 6);
  const auto wrong = [](const std::string& text) {
    return test::error_of(text, [](const io::Source& source) { return io::read_script(source, {}); });
  };
  CHECK(wrong("group g=a elementos=b,a/b").find("elementos? (elements) is \"a/b\"; expected a name") !=
        std::string::npos);
  CHECK(wrong("group g=a elementos=b,").find("elementos? (elements) is \"\"; expected a name") != std::string::npos);
  CHECK(wrong("group g=a elementos=b,c,b").find("\"b\" stands twice in elementos? (elements)") != std::string::npos);
  CHECK(wrong("group g=a elementos=(1,2,3)").find("elementos? (elements) is no list of names") != std::string::npos);
  CHECK(wrong("group g=\"\"").find("expected a name") != std::string::npos);
  CHECK(wrong("ungroup g=a groups=b").find("unknown input") != std::string::npos);
  CHECK(io::answer_text(3, io::edit_answer(scene::Outcome{"no_such_group", &scene::ungroup_pre_1})) ==
        R"({"line":3,"ok":false,"r":"no_such_group","violated":"ungroup.pre.1","predicate":"g? ∈ dom groups"})");
}

TEST_CASE("A refused operation is an answer: what was violated, and its predicate") {
  scene::Scene scene;
  CHECK(answers(scene, R"(Agregar_Esfera e?=s1 centro?=(0,0,5) radio?=1
Agregar_Esfera e?=s1 centro?=(0,0,5) radio?=1
Agregar_Esfera e?=s2 centro?=(0,0,5) radio?=0
Agregar_Cilindro e?=c1 centro?=(0,0,5) radio?=1 vector?=(0,2,0) altura?=1
Eliminar_Cono e?=s1
Eliminar_Elemento e?=s3
)") == R"({"line":1,"ok":true,"r":"esfera_agregada"}
{"line":2,"ok":false,"r":"elemento_ya_existe","violated":"Agregar_Elemento.pre.1","predicate":"e? ∉ elementos"}
{"line":3,"ok":false,"r":"radio_no_positivo","violated":"Agregar_Esfera.pre.2","predicate":"radio? ∈ Rmas"}
{"line":4,"ok":false,"r":"vector_no_unitario","violated":"Agregar_Cilindro.pre.3","predicate":"vector? ∈ Unitario"}
{"line":5,"ok":false,"r":"tipo_incorrecto","violated":"Eliminar_Cono.pre.1","predicate":"de_que_tipo(e?) = soy_cono"}
{"line":6,"ok":false,"r":"elemento_no_existe","violated":"Eliminar_Elemento.pre.1","predicate":"e? ∈ elementos"}
)");
  CHECK(scene.size() == 1);
}

TEST_CASE("Operations stand one a line, however the lines end") {
  const std::string script =
      "# a script|Agregar_Esfera e=a centro=(0,0,0) radio=1 # a||{\"op\":\"Eliminar_Esfera\",\"e\":\"a\"}|";
  for (const char* end : {"\n", "\r\n", "\r"}) {
    std::string text;
    for (const char c : script) text += c == '|' ? end : std::string(1, c);
    scene::Scene scene;
    CHECK(answers(scene, text) ==
          "{\"line\":2,\"ok\":true,\"r\":\"esfera_agregada\"}\n{\"line\":4,\"ok\":true,\"r\":\"esfera_eliminada\"}\n");
  }
  CHECK(error_at("# a\r^Mover e=a").starts_with("unknown operation \"Mover\""));
}

TEST_CASE("An addition takes a material of the scene") {
  scene::Scene scene;
  scene.stage() = stage_with_red();
  answers(scene,
          "Agregar_Esfera e=a centro=(0,0,0) radio=1 material?=red\nAgregar_Esfera e=b centro=(0,0,0) radio=1\n"
          R"({"op":"Agregar_Elemento","e":"c","t":"soy_esfera","centro":[0,0,0],"radio":1,"material":"blue"})"
          "\nAgregar_Esfera e=a centro=(0,0,0) radio=1 material=blue");  // refused: a keeps its material
  CHECK(scene.material(scene.find("a").value()) == 1U);
  CHECK(scene.material(scene.find("b").value()) == std::nullopt);
  CHECK(scene.material(scene.find("c").value()) == 0U);
}

TEST_CASE("An addition as text reads back with the same numbers") {
  test::property("any sphere, as text and as JSON", [] {
    const glm::dvec3 c = test::any_triple();
    const double r = *test::anyFinite();
    for (const std::string& text :
         {fmt::format("Agregar_Esfera e?=a centro?=({},{},{}) radio?={}", c.x, c.y, c.z, r),
          fmt::format("Agregar_Esfera e=a centro=({:a}, {:a}, {:a}) radio={:a}", c.x, c.y, c.z, r),
          fmt::format(R"({{"op":"Agregar_Esfera","e":"a","centro":[{},{},{}],"radio":{}}})", c.x, c.y, c.z, r)}) {
      const auto edits = io::read_script(io::Source("f", text), {});
      RC_ASSERT(edits.size() == 1U);
      const auto& read = std::get<model::Agregar_Esfera>(operation(edits[0]));
      RC_ASSERT(read.centro.xyz() == c);
      RC_ASSERT(read.radio == r);
    }
  });
}

TEST_CASE("Three points are read in either syntax") {
  const glm::dvec3 a{1, -2, 0.5}, b{3, 0, 0}, c{0, 0, 1e-300};
  for (const std::string text :
       {"Agregar_Triangulo e?=t vertices?=((1,-2,0.5),(3,0,0),(0,0,1e-300))",
        "Agregar_Triangulo e=t vertices=( ( 1 , -2 ,0.5) , (3,0,0) ,(0,0,1e-300) )",
        R"({"op":"Agregar_Triangulo","e":"t","vertices":[[1,-2,0.5],[3,0,0],[0,0,1e-300]]})"}) {
    const auto edits = io::read_script(io::Source("f", text), {});
    REQUIRE(edits.size() == 1U);
    const auto& read = std::get<model::Agregar_Triangulo>(operation(edits[0]));
    CHECK(read.vertices == model::Terna{model::Punto(a), model::Punto(b), model::Punto(c)});
  }
  const auto edits = io::read_script(
      io::Source("f", "Agregar_Elemento e?=t t?=soy_triangulo vertices?=((0,0,0),(1,0,0),(0,1,0))"), {});
  const auto& general = std::get<model::Agregar_Elemento>(operation(edits[0]));
  CHECK_FALSE(general.centro);
  CHECK(general.vertices->b == model::Punto(1, 0, 0));
}

TEST_CASE("A malformed operation is an error with its place") {
  using Case = std::pair<std::string, std::string>;
  const std::string operations =
      "one of Agregar_Esfera, Agregar_Cilindro, Agregar_Cono, Agregar_Tronco, Agregar_Plano, Agregar_Disco, "
      "Agregar_Triangulo, Agregar_Elemento, Eliminar_Esfera, Eliminar_Cilindro, Eliminar_Cono, Eliminar_Tronco, "
      "Eliminar_Plano, Eliminar_Disco, Eliminar_Triangulo, Eliminar_Elemento, Cambiar_Centro, Cambiar_Radio, "
      "Cambiar_Vector, Cambiar_Altura, Cambiar_Proporcion, Cambiar_Vertices, Cambiar_Material, Quitar_Material, "
      "Cambiar_Grupo, Quitar_Grupo, Agregar_Instancia, Eliminar_Instancia, Agregar_Union, Agregar_Interseccion, "
      "Agregar_Diferencia, Eliminar_Solido, "
      "Agregar_Malla, Eliminar_Malla, Reemplazar_Malla, Mover_Vertice, group, ungroup, close";
  const Case cases[] = {
      {"\n ^Agregar e?=a", "unknown operation \"Agregar\"; expected " + operations},
      {"^Agregar_Sphere e?=a",
       "unknown operation \"Agregar_Sphere\"; expected Agregar_Esfera (Add_Sphere), or " + operations},
      {"^Agregar_Esfera e?=a radio?=1", "Agregar_Esfera lacks centro? (center); expected it"},
      {"Eliminar_Esfera e?=a ^radio?=1", "unknown input \"radio\" of Eliminar_Esfera; expected one of e"},
      {"Agregar_Esfera e?=a ^t?=soy_esfera centro?=(0,0,0) radio?=1",
       "unknown input \"t\" of Agregar_Esfera; expected one of e, centro (center), radio (radius), material"},
      {"Eliminar_Esfera e?=a ^e=b", "e? (element) stands twice; expected it once"},
      {"Eliminar_Esfera e?=^a/b", "e? (element) is \"a/b\"; expected a name, 1 to 128 of A-Z a-z 0-9 _ . : -"},
      {"Eliminar_Esfera e?^ =a", "\" \" stands here; expected = after the name of an input"},
      {"Eliminar_Esfera e?=^", "e has no value; expected one after ="},
      {"Eliminar_Esfera ^?=a", "\"?\" stands here; expected an input, name?=value"},
      {"Eliminar_Esfera e?=^(0,0,0)", "e? (element) is no name; expected a name"},
      {"Agregar_Esfera e?=a centro?=^5 radio?=1",
       "centro? (center) is no triple; expected (x,y,z), or [x,y,z] in JSON"},
      {"Agregar_Esfera e?=a centro?=(0,0^) radio?=1", "\")\" stands here; expected , in (x,y,z)"},
      {"Agregar_Esfera e?=a centro?=(0,0,0^,0) radio?=1", "\",\" stands here; expected ) after (x,y,z"},
      {"Agregar_Esfera e?=a centro?=(0,^nan,0) radio?=1", "\"nan\" in a triple; expected a finite number"},
      {"Agregar_Esfera e?=a centro?=(0,0,^1e999) radio?=1", "\"1e999\" in a triple; expected a finite number"},
      {"Agregar_Esfera e?=a centro?=(0,0,0)^radio?=1", "\"r\" stands here; expected a space after an input"},
      {"Agregar_Esfera e?=a centro?=(0,0,0^", "the line ends; expected ) after (x,y,z"},
      {"Agregar_Esfera e?=a centro?=(0,0,0) radio?=^uno", "radio? (radius) is \"uno\"; expected a finite number"},
      {"Agregar_Esfera e?=a centro?=(0,0,0) radio?=^inf", "radio? (radius) is \"inf\"; expected a finite number"},
      {"Agregar_Esfera e?=a centro?=(0,0,0) radio?=^(1,1,1)", "radio? (radius) is no number; expected a finite number"},
      {"Agregar_Esfera e?=a centro?=(0,0,0) radio?=1 material?=^green",
       "unknown material \"green\"; expected one of the scene's materials"},
      {"^Agregar_Elemento e?=a t?=soy_cono centro?=(0,0,0) radio?=1",
       "Agregar_Elemento lacks proporcion? (proportion); expected it"},
      {"Agregar_Elemento e?=a t?=^cono centro?=(0,0,0) radio?=1",
       "t? (type) is \"cono\"; expected one of soy_esfera (is_sphere), soy_cilindro (is_cylinder), soy_cono (is_cone), "
       "soy_tronco (is_truncated_cone), soy_plano (is_plane), soy_disco (is_disc), "
       "soy_triangulo (is_triangle)"},
      {"Agregar_Triangulo e?=a vertices?=^(0,0,0)",
       "vertices? is no triple of points; expected ((x,y,z),(x,y,z),(x,y,z)), or [[x,y,z],[x,y,z],[x,y,z]] in JSON"},
      {"Agregar_Triangulo e?=a vertices?=((0,0,0),(1,0,0)^)",
       "\")\" stands here; expected , in ((x,y,z),(x,y,z),(x,y,z))"},
      {"Agregar_Triangulo e?=a vertices?=((0,0,0),(1,0,0),(0,1,0)^,(1,1,1))",
       "\",\" stands here; expected ) after ((x,y,z),(x,y,z),(x,y,z)"},
      {"Agregar_Triangulo e?=a vertices?=((0,0,0),^1,(0,1,0))",
       "\"1\" stands here; expected ( in ((x,y,z),(x,y,z),(x,y,z))"},
      {"Agregar_Esfera e?=a centro?=^((0,0,0),(1,0,0),(0,1,0)) radio?=1",
       "centro? (center) is no triple; expected (x,y,z), or [x,y,z] in JSON"},
      {"^Agregar_Elemento e?=a t?=soy_triangulo centro?=(0,0,0)", "Agregar_Elemento lacks vertices?; expected it"},
      {R"({"op":"Agregar_Triangulo","e":"a","vertices":[[0,0,0],[1,0,0],^3]})",
       "vertices is a number; expected an array"},
      {R"({"op":"Agregar_Triangulo","e":"a","vertices":^[[0,0,0],[1,0,0]]})",
       "vertices has 2 items; expected three points"},
      {R"({"op":"Agregar_Triangulo","e":"a","vertices":[[0,0,0],[1,0,0],[0,1,0],^[2,2,2]]})",
       "vertices has a fourth item; expected three points"},
      {"^{\"e\":\"a\"}", "key \"op\" is missing; expected the name of an operation"},
      {"{\"op\":^3}", "op is a number; expected a string"},
      {"{\"op\":\"Eliminar_Esfera\",^\"op\":\"Eliminar_Esfera\"}", "key \"op\" stands twice; expected it once"},
      {"\n{\"op\":\"Eliminar_Esfera\",\"e\":^true}", "e is true or false; expected a string"},
      {"{\"op\":\"Eliminar_Esfera\",\"e\":^3}", "e? (element) is no name; expected a name"},
      {"{\"op\":\"Eliminar_Esfera\",\"e\":\"a\"^\n}", "the text ends; expected , or } after a member"},
      {R"({"op":"Agregar_Esfera","e":"a","centro":[0,0,0],"radio":^"1"})",
       "radio? (radius) is no number; expected a finite number"},
      {"Eliminar_Esfera e?=a\n{\"op\":\"Eliminar_Esfera\",\"e\":\"a\"} ^x",
       "\"x\" stands here after the value; expected the end of the text"},
  };
  for (const auto& [text, expected] : cases) {
    INFO(text);
    CHECK(error_at(text) == expected);
  }
  CHECK(test::error_of(std::string(1000000, '(') + "\n", reading).starts_with("f:1:1: unknown operation"));
  CHECK_FALSE(test::error_of("{\"op\":" + std::string(1000000, '['), reading).empty());
}

TEST_CASE("No damage to a script does worse than an error") {
  const std::string script =
      "Agregar_Cono e?=k1 centro?=(0,0x1p-2,5e-1) proporcion?=1 vector?=(0,1,0) altura?=2 material?=red # c\n"
      R"({"op":"Agregar_Elemento","e":"s","t":"soy_esfera","centro":[0,0,5],"radio":1})"
      "\n";
  const std::size_t refused = test::refused_after_damage(script, 20000, reading);
  CHECK(refused > 8000);
  CHECK(refused < 20000);
}

TEST_CASE("Every operation and each of its inputs has a word, and the reader knows them") {
  const std::vector<io::WrittenType> types{{"toro", {{"mayor", io::WrittenKind::number}}}};
  const std::vector<io::OperationWords> all = io::operation_words(types);
  std::string listed;  // by the reader, where a word is none of them
  std::ptrdiff_t named = 0;
  try {
    io::read_script(io::Source("f", "xyz a=b"), {}, types);
  } catch (const io::InputError& error) {
    listed = std::string(error.what()) + ",";
  }
  for (const io::OperationWords& words : all) {
    CAPTURE(words.name);
    std::string call = words.name;
    for (const std::string& input : words.inputs) call += " " + input + "=(";  // no value of any input
    try {
      io::read_script(io::Source("f", call), {}, types);
      FAIL("a value is taken that is none");
    } catch (const io::InputError& error) {
      CHECK(std::string(error.what()).find("unknown") == std::string::npos);
    }
    // With all but the last of those that it needs, that one is missing.
    call = words.name;
    for (std::size_t i = 0; i + 1 < words.required; ++i) call += " " + words.inputs[i] + "=0";
    try {
      io::read_script(io::Source("f", call), {}, types);
      FAIL("an input is needed, and may be left out");
    } catch (const io::InputError& error) {
      CHECK(std::string(error.what()).find("lacks " + words.inputs[words.required - 1] + "?") != std::string::npos);
    }
    // The change of an attribute stands for those that name a type, too.
    const bool names_type = words.name.starts_with("Cambiar_") && std::ranges::count(words.name, '_') == 2;
    named += names_type ? 0 : 1;
    CHECK((listed.find(" " + words.name + ",") != std::string::npos) == !names_type);
  }
  CHECK(std::ranges::count(listed, ',') == named);
  CHECK(all.front().name == "Agregar_Esfera");
  CHECK(all.front().inputs == std::vector<std::string>{"e", "centro", "radio", "material"});
  CHECK(all[all.size() - 2].inputs == std::vector<std::string>{"e", "mayor", "material"});
  CHECK(all.back().name == "Eliminar_Toro");
}
