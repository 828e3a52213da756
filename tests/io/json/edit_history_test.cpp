#include "durero/io/json/edit_history.hpp"

#include "durero/io/json/groups_file.hpp"
#include "support/catch.hpp"
#include "support/property.hpp"

namespace durero::io {
namespace {

const char* const first_scene = R"({"format":"durero-scene","version":1,
"materials":{"blue":{"color":[0,0,1]},"red":{"color":[1,0,0]}},
"elementos":[
{"id":"can","tipo":"cilindro","centro":[0,0,0],"radio":1,"vector":[0,1,0],"altura":2},
{"id":"s","tipo":"esfera","centro":[0,0,5],"radio":1,"material":"red"},
{"id":"t","tipo":"triangulo","vertices":[[0,0,0],[1,0,0],[0,1,0]]}],
"groups":{"pair":{"elementos":["s","t"]}}})";

/// Edits of every kind, which may be done or refused on what the others leave.
const std::vector<std::string> operations{
    "Cambiar_Radio e?=s radio?=3",
    "Cambiar_Radio_Cilindro e?=can radio?=4",
    "Cambiar_Vertices e?=t vertices?=((0,0,0),(2,0,0),(0,2,0))",
    "Cambiar_Altura e?=can altura?=0",
    "Cambiar_Material e?=s material?=blue",
    "Quitar_Material e?=s",
    "Cambiar_Material e?=can material?=red",
    "group g?=all elementos?=can groups?=pair",
    "Cambiar_Grupo e?=can g?=pair",
    "Quitar_Grupo e?=t",
    "close e?=can",
    "Agregar_Instancia e?=copy de?=s centro?=(0,0,9) x?=(2,0,0) y?=(0,1,0) z?=(0,0,1)",
    "Agregar_Union e?=both de?=s,can",
    "Agregar_Malla m?=tent puntos?=((0,0,0),(1,0,0),(0,1,0)) caras?=((0,1,2))",
    "group g?=faces elementos?=tent:0",
    "Mover_Vertice m?=tent n?=2 punto?=(0,3,0)",
    "Reemplazar_Malla m?=tent puntos?=((0,0,0),(1,0,0),(0,1,0),(1,1,1)) caras?=((0,1,2),(1,3,2)) material?=red",
    "ungroup g?=pair",
    "Eliminar_Instancia e?=copy",
    "Eliminar_Solido e?=both",
    "Eliminar_Malla m?=tent",
    "Agregar_Esfera e?=new centro?=(1,2,3) radio?=2 material?=blue",
    "Eliminar_Elemento e?=s",
    "Agregar_Esfera e?=s centro?=(1,2,3) radio?=2",
    "Eliminar_Triangulo e?=t",
};

/// A scene with its history, which one operation at a time edits.
struct Session {
  EditedScene scene{read_grouped_scene(Source("first", first_scene), Bodies::read)};
  EditHistory history{};

  bool operator()(const std::string& operation) {
    const auto script = read_script(Source("op", operation), scene.of().scene.stage());
    return history.apply_total(scene, script.front()).ok();
  }
};

TEST_CASE("Every kind of edit is undone, byte for byte, and done again") {
  test::property("over random edits", [] {
    Session of;
    std::vector<std::string> texts{of.scene.scene_text()};
    for (int i = 0; i < 12; ++i)
      if (of(*rc::gen::elementOf(operations))) texts.push_back(of.scene.scene_text());
    RC_ASSERT(of.history.done().size() + 1 == texts.size());
    for (std::size_t i = texts.size(); i-- > 1;) {
      RC_ASSERT(of.scene.scene_text() == texts[i]);
      RC_ASSERT(of.history.undo(of.scene));
    }
    RC_ASSERT(of.scene.scene_text() == texts.front());
    RC_ASSERT(!of.history.undo(of.scene));
    for (std::size_t i = 1; i < texts.size(); ++i) {
      RC_ASSERT(of.history.redo(of.scene));
      RC_ASSERT(of.scene.scene_text() == texts[i]);
    }
    RC_ASSERT(!of.history.redo(of.scene));
  });
}

TEST_CASE("Each operation of the list is done on some scene") {
  Session of;
  std::set<std::string> done;
  for (const std::string& operation : operations)
    if (of(operation)) done.insert(operation);
  CHECK(done.size() == operations.size() - 1);  // but a height of 0
}

TEST_CASE("A transaction is one step, or nothing") {
  Session of;
  const std::string before = of.scene.scene_text();
  of.history.begin();
  CHECK(of.history.is_open());
  CHECK(of("Cambiar_Radio e?=s radio?=3"));
  CHECK(!of("Cambiar_Radio e?=nobody radio?=3"));
  CHECK(of("Cambiar_Radio e?=s radio?=4"));  // undone first
  CHECK(of("Eliminar_Elemento e?=can"));
  of.history.commit();
  CHECK(!of.history.is_open());
  REQUIRE(of.history.done().size() == 1);
  CHECK(of.history.done().front().edits.size() == 3);
  CHECK(of.history.undo(of.scene));
  CHECK(of.scene.scene_text() == before);

  of.history.begin();
  CHECK(of("Quitar_Material e?=s"));
  CHECK(of("Eliminar_Elemento e?=s"));
  CHECK(of("ungroup g?=pair"));
  of.history.roll_back(of.scene);
  CHECK(of.scene.scene_text() == before);
  CHECK(of.history.undone().size() == 1);  // nothing was done, so what was undone can still be done again
  of.history.begin();
  of.history.commit();
  CHECK(of.history.done().empty());
}

TEST_CASE("All edits of a list are done, or none, within a transaction too") {
  Session of;
  const std::string before = of.scene.scene_text();
  const auto all = [&](const std::string& script) {
    return of.history.apply_all(of.scene, read_script(Source("script", script), of.scene.of().scene.stage()));
  };
  const std::string refused = "Cambiar_Radio e?=s radio?=3\nEliminar_Elemento e?=can\nCambiar_Radio e?=s radio?=0\n";
  const auto answers = all(refused);
  REQUIRE(answers.size() == 3);
  CHECK(!answers.back().ok());
  CHECK(of.scene.scene_text() == before);
  CHECK(of.history.done().empty());
  CHECK(!of.history.is_open());

  of.history.begin();
  CHECK(of("Cambiar_Radio e?=s radio?=5"));
  const std::string within = of.scene.scene_text();
  all(refused);
  CHECK(of.scene.scene_text() == within);
  CHECK(of.history.is_open());
  CHECK(all("Cambiar_Radio e?=can radio?=3\nEliminar_Elemento e?=t\n").size() == 2);
  of.history.commit();
  CHECK(of.history.done().size() == 1);
  of.history.undo(of.scene);
  CHECK(of.scene.scene_text() == before);
}

TEST_CASE("A history of few steps forgets the first") {
  Session of;
  of.history = EditHistory(2);
  for (const char* radius : {"2", "3", "4"}) of(std::string("Cambiar_Radio e?=s radio?=") + radius);
  CHECK(of.history.done().size() == 2);
  CHECK(of.history.undo(of.scene));
  CHECK(of.history.undo(of.scene));
  CHECK(!of.history.undo(of.scene));
  CHECK(of.scene.scene_text().find("\"radio\":2") != std::string::npos);
}

TEST_CASE("An edit that is done forgets what was undone; one that is refused does not") {
  Session of;
  of("Cambiar_Radio e?=s radio?=3");
  of.history.undo(of.scene);
  CHECK(!of("Cambiar_Radio e?=s radio?=0"));
  CHECK(of.history.undone().size() == 1);
  CHECK(of("Cambiar_Radio e?=s radio?=4"));
  CHECK(of.history.undone().empty());
  of.history.clear();
  CHECK(!of.history.undo(of.scene));
}

}  // namespace
}  // namespace durero::io
