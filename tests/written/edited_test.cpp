#include "durero/written/edited.hpp"

#include <fstream>

#include "durero/io/json/edit_history.hpp"
#include "durero/io/json/groups_file.hpp"
#include "durero/scene/stage.hpp"
#include "io/json/edited_script.hpp"
#include "support/catch.hpp"
#include "support/folder.hpp"
#include "support/tree.hpp"

namespace durero::written {
namespace {

using test::edit;

const std::string surfaces = test::source_dir() + "/demo/surfaces/";

std::string file_with(const std::string& elements) {
  return R"({"format":"durero-scene","version":1,"materials":{"red":{"color":[1,0,0]}},"elementos":[)" + elements +
         "]}";
}

const std::string ring = R"({"id":"ring","tipo":"toro","centro":[0,0,0],"mayor":2,"menor":0.75,"material":"red"})",
                  ball = R"({"id":"ball","tipo":"esfera","centro":[0,0,0],"radio":1})";

std::shared_ptr<const Text> text_of(const std::string& file) { return std::make_shared<const Text>(file); }

Edited with_tori(const std::string& elements = ring + "," + ball) {
  return {io::Source("scene.json", file_with(elements)), text_of(surfaces + "torus.tex")};
}

double first_t(const Edited& edited) {
  return engine::first_hit(*edited.engine(), {{model::Punto(glm::dvec3(-5, 0, 0)), model::Vector(glm::dvec3(1, 0, 0))}})
      .t;
}

TEST_CASE("Whoever removes such an element from a group, and adds it again, is told so both times") {
  Edited tori = with_tori();
  CHECK(edit(tori,
             "group g?=all elementos?=ring,ball\n"
             "Eliminar_Toro e?=ring\n"
             "Agregar_Toro e?=ring centro?=(0,0,0) mayor?=2 menor?=0.75\n") ==
        "grouped\nall left: elemento_eliminado\nall left: elemento_agregado\n");
}

TEST_CASE("An element of a type of the text is not closed") {
  Edited tori = with_tori();
  CHECK(edit(tori, "close e?=ring\n").starts_with("not_closed close.pre.2"));
}

TEST_CASE("An element of a type of the text is added, met, removed and written back") {
  Edited edited = with_tori();
  CHECK(first_t(edited) == 2.25);
  CHECK(edit(edited,
             "Agregar_Toro e?=wide centro?=(0,0,0) mayor?=3 menor?=0.5 material?=red\n"
             R"({"op":"Agregar_Toro","e":"thin","centro":[0,9,0],"mayor":1,"menor":0.25})") ==
        "elemento_agregado\nelemento_agregado\n");
  CHECK(first_t(edited) == 1.5);
  REQUIRE(edited.written("wide") != nullptr);
  CHECK(std::get<double>(edited.written("wide")->values[1]) == 3);
  CHECK(edited.of().scene.material(edited.of().scene.find("wide").value()) == 0U);

  const std::string text = edited.scene_text();
  CHECK(text.find(R"({"id":"wide","tipo":"toro","centro":[0,0,0],"mayor":3,"menor":0.5,"material":"red"})") !=
        std::string::npos);
  CHECK(text.find(ball) != std::string::npos);
  const Edited again(io::Source("again.json", text), text_of(surfaces + "torus.tex"));
  CHECK(again.scene_text() == text);
  CHECK(first_t(again) == 1.5);

  CHECK(edit(edited, "Eliminar_Toro e?=wide\nEliminar_Elemento e?=ring") == "elemento_eliminado\nelemento_eliminado\n");
  CHECK(edited.written("wide") == nullptr);
  CHECK(first_t(edited) == 4);
  CHECK(edit(edited, "Agregar_Esfera e?=wide centro?=(0,0,0) radio?=2") == "esfera_agregada\n");
  CHECK(edited.scene_text().find(R"({"id":"wide","tipo":"esfera")") != std::string::npos);
}

TEST_CASE("What the text gives no points is refused with its predicate, and the scene is as it was") {
  Edited edited = with_tori();
  const std::string before = edited.scene_text();
  CHECK(edit(edited, "Agregar_Toro e?=a centro?=(0,0,0) mayor?=1 menor?=1") ==
        "not_in_domain puntos_toro.dom: menor < mayor\n");
  CHECK(edit(edited, "Agregar_Toro e?=a centro?=(0,0,0) mayor?=1 menor?=0") ==
        "not_in_domain puntos_toro.dom: menor ∈ Rmas\n");
  CHECK(edit(edited, "Agregar_Toro e?=ball centro?=(0,0,0) mayor?=2 menor?=1") ==
        "elemento_ya_existe Agregar_Elemento.pre.1: e? ∉ elementos\n");
  CHECK(edit(edited, "Agregar_Toro e?=ring centro?=(0,0,0) mayor?=2 menor?=1") ==
        "elemento_ya_existe Agregar_Elemento.pre.1: e? ∉ elementos\n");
  CHECK(edit(edited, "Agregar_Esfera e?=ring centro?=(0,0,0) radio?=1") ==
        "elemento_ya_existe Agregar_Elemento.pre.1: e? ∉ elementos\n");
  CHECK(edited.written("ring") != nullptr);
  CHECK(edited.scene_text() == before);
}

TEST_CASE("A removal that means another type is refused: no torus is a sphere, no sphere a torus") {
  Edited edited = with_tori();
  const std::string before = edited.scene_text();
  CHECK(edit(edited, "Eliminar_Esfera e?=ring") ==
        "tipo_incorrecto Eliminar_Esfera.pre.1: de_que_tipo(e?) = soy_esfera\n");
  CHECK(edit(edited, "Eliminar_Cono e?=ring") == "tipo_incorrecto Eliminar_Cono.pre.1: de_que_tipo(e?) = soy_cono\n");
  CHECK(edit(edited, "Eliminar_Toro e?=ball") == "tipo_incorrecto Eliminar_Toro.pre.1: de_que_tipo(e?) = soy_toro\n");
  CHECK(edit(edited, "Eliminar_Toro e?=none") == "elemento_no_existe Eliminar_Elemento.pre.1: e? ∈ elementos\n");
  CHECK(edited.scene_text() == before);
}

TEST_CASE("A shape of the program's own is asked of the text too: where that gives it no points, it is refused") {
  const test::Folder folder;
  std::ofstream(folder.file("small.tex"))
      << "\\begin{zsection}\n  \\SECTION small \\parents tipos\n\\end{zsection}\n\\begin{axdef}\n"
         "  puntos\\_esfera : Punto \\cross Rmas \\pfun \\power Punto\n\\where\n"
         "  \\forall centro : Punto; radio : Rmas | radio < 2 @ puntos\\_esfera(centro, radio) = \\{~ w : Punto |\n"
         "  w.x * w.x + w.y * w.y + w.z * w.z = radio * radio ~\\}\n\\end{axdef}\n";
  Edited edited(io::Source("scene.json", file_with(ball)), text_of(folder.file("small.tex")));
  const std::string before = edited.scene_text();
  CHECK(edit(edited, "Agregar_Esfera e?=c centro?=(0,0,0) radio?=3") == "not_in_domain puntos_esfera.dom: radio < 2\n");
  CHECK(edited.scene_text() == before);
  CHECK(edit(edited, "Agregar_Esfera e?=c centro?=(0,0,0) radio?=1.5") == "esfera_agregada\n");
  CHECK(edit(edited, "Cambiar_Radio e?=c radio?=5") == "not_in_domain puntos_esfera.dom: radio < 2\n");
  CHECK(edit(edited, "Cambiar_Radio e?=c radio?=0") == "radio_no_positivo Cambiar_Radio.pre.2: radio? ∈ Rmas\n");
  CHECK(edit(edited, "Cambiar_Radio e?=c radio?=1.25") == "elemento_cambiado\n");
  const std::string after = edited.scene_text();
  CHECK(after.find("\"radio\":1.25") != std::string::npos);
  CHECK_THROWS_AS(edit(edited, "Agregar_Plano e?=p centro?=(0,0,0) vector?=(0,1,0)"), io::InputError);
  CHECK(edited.scene_text() == after);
}

TEST_CASE("A torus has no radius of a sphere to change, and its edits are undone") {
  Edited edited = with_tori();
  CHECK(edit(edited, "Cambiar_Radio e?=ring radio?=2") == "tipo_incorrecto Cambiar_Radio.pre.1: e? ∈ dom mi_radio\n");
  CHECK(edit(edited, "Cambiar_Radio_Esfera e?=ring radio?=2") ==
        "tipo_incorrecto Es_Esfera.pre.1: e? ↦ soy_esfera ∈ de_que_tipo\n");
  io::EditHistory history;
  const auto apply = [&](const std::string& operation) {
    return history.apply_total(edited, io::read_script(io::Source("op", operation), edited.stage(), edited.types())[0])
        .ok();
  };
  const std::string before = edited.scene_text();
  CHECK(apply("Eliminar_Toro e?=ring"));
  CHECK(apply("Agregar_Toro e?=new centro?=(0,0,0) mayor?=3 menor?=1"));
  const std::string after = edited.scene_text();
  CHECK(history.undo(edited));
  CHECK(edited.written("new") == nullptr);
  CHECK(history.undo(edited));
  CHECK(edited.written("ring") != nullptr);
  CHECK(edited.scene_text() == before);
  CHECK(history.redo(edited));
  CHECK(history.redo(edited));
  CHECK(edited.scene_text() == after);
}

TEST_CASE("Groups hold such elements, and a copy is edited alone") {
  Edited edited = with_tori();
  CHECK(edit(edited, "group g?=pair elementos?=ring,ball") == "grouped\n");
  Edited copy = edited;
  CHECK(edit(copy, "Eliminar_Toro e?=ring") == "pair left: elemento_eliminado\n");
  CHECK(copy.of().groups.table().at("pair").elementos == scene::Names{"ball"});
  CHECK(edited.of().groups.table().at("pair").elementos == scene::Names{"ball", "ring"});
  CHECK(edited.written("ring") != nullptr);
  const Edited again(io::Source("again.json", edited.scene_text()), text_of(surfaces + "torus.tex"));
  CHECK(again.of().groups == edited.of().groups);
}

TEST_CASE("Without a text, edits are those of the scene") {
  Edited edited;
  CHECK(edited.text() == nullptr);
  CHECK(edited.types().empty());
  CHECK(edit(edited, "Agregar_Esfera e?=a centro?=(0,0,0) radio?=0") ==
        "radio_no_positivo Agregar_Esfera.pre.2: radio? ∈ Rmas\n");
  CHECK(edit(edited, "Agregar_Esfera e?=a centro?=(0,0,0) radio?=1\nEliminar_Esfera e?=a") ==
        "esfera_agregada\nesfera_eliminada\n");
  CHECK_THROWS_AS(edit(edited, "Agregar_Toro e?=a centro?=(0,0,0) mayor?=2 menor?=1"), io::InputError);
}

TEST_CASE("A malformed operation on such a type is told at its place") {
  Edited edited = with_tori();
  const auto error = [&](const std::string& script) {
    try {
      edit(edited, script);
    } catch (const io::InputError& wrong) {
      return std::string(wrong.what());
    }
    return std::string();
  };
  CHECK(error("Agregar_Toro e?=a centro?=(0,0,0) mayor?=2") == "script:1:1: Agregar_Toro lacks menor?; expected it");
  CHECK(error("Agregar_Toro e?=a centro?=1 mayor?=2 menor?=1")
            .starts_with("script:1:27: centro? (center) is no triple; "));
  CHECK(error("Agregar_Toro e?=a centro?=(0,0,0) mayor?=x menor?=1")
            .starts_with("script:1:42: mayor? (greater) is \"x\"; "));
  CHECK(error("Agregar_Toro e?=a radio?=1").starts_with("script:1:19: unknown input \"radio\" of Agregar_Toro; "));
  CHECK(error("Eliminar_Toro e?=a mayor?=1").starts_with("script:1:20: unknown input \"mayor\" of Eliminar_Toro; "));
  CHECK(error("Agregar_Tora e?=a").find("; expected Agregar_Toro, or one of Agregar_Esfera, ") != std::string::npos);
  CHECK(error("Mover e?=a").find("Agregar_Toro, Eliminar_Toro") != std::string::npos);
}

TEST_CASE("A material with textures is for no element of such a type") {
  scene::Stage stage;
  stage.materials = {{"red", {1, 0, 0}}};
  stage.materials[0].textures.names[0] = "wood";
  const std::vector<io::WrittenType> types{{"toro", {{"mayor", io::WrittenKind::number}}}};
  CHECK_THROWS_AS(io::read_script(io::Source("s", "Agregar_Toro e?=a mayor?=1 material?=red"), stage, types),
                  io::InputError);
  stage.materials[0].textures = {};
  CHECK(io::read_script(io::Source("s", "Agregar_Toro e?=a mayor?=1 material?=red"), stage, types).size() == 1);
}

}  // namespace
}  // namespace durero::written
