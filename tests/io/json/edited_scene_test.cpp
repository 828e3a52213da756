// Edited scenes of the program's own shapes.
#include "durero/io/json/edited_scene.hpp"

#include "durero/io/json/groups_file.hpp"
#include "io/json/edited_script.hpp"
#include "support/catch.hpp"

namespace durero::io {
namespace {

using test::edit;

TEST_CASE("Whoever removes an element from a group, and adds it again, is told so both times") {
  EditedScene edited;
  CHECK(edit(edited,
             "Agregar_Esfera e?=a centro?=(0,0,0) radio?=1\n"
             "Agregar_Esfera e?=b centro?=(5,0,0) radio?=1\n"
             "group g?=pair elementos?=a,b\n"
             "Eliminar_Esfera e?=a\n"
             "Agregar_Esfera e?=a centro?=(0,0,0) radio?=2\n"
             "Agregar_Esfera e?=a centro?=(0,0,0) radio?=2\n"  // refused
             "Eliminar_Elemento e?=a\n"                        // of no group
             "Agregar_Esfera e?=a centro?=(0,0,0) radio?=2\n"
             "Eliminar_Elemento e?=b\n"
             "ungroup g?=pair\n"
             "Agregar_Esfera e?=b centro?=(0,0,0) radio?=2\n") ==
        "esfera_agregada\nesfera_agregada\ngrouped\n"
        "pair left: esfera_eliminada\n"
        "pair left: esfera_agregada\n"
        "elemento_ya_existe Agregar_Elemento.pre.1: e? ∉ elementos\n"
        "elemento_eliminado\n"
        "esfera_agregada\n"
        "pair left: elemento_eliminado\n"
        "ungrouped\n"
        "esfera_agregada\n");
  // The contracts alone decide as the text of spec/ is held against them.
  EditedScene own;
  edit(own, "Agregar_Esfera e?=a centro?=(0,0,0) radio?=1\ngroup g?=one elementos?=a\n");
  const auto [answer, told] = own.apply_own({model::Eliminar_Esfera{model::Elemento{"a"}}, {}});
  CHECK(answer.r == model::Respuesta::esfera_eliminada);
  CHECK(told.left_group == "one");
}

TEST_CASE("An element is closed by all of its discs, or by none") {
  EditedScene edited;
  CHECK(edit(edited,
             "Agregar_Cilindro e?=can centro?=(0,0,0) radio?=1 vector?=(0,1,0) altura?=2\n"
             "Agregar_Cono e?=hat centro?=(0,0,9) proporcion?=1e200 vector?=(0,1,0) altura?=1e200\n"
             "Agregar_Esfera e?=taken centro?=(5,0,0) radio?=1\n"
             "close e?=can top?=taken\n"
             "close e?=hat\n"
             "close e?=can\n"
             "close e?=can\n"
             "close e?=nothing\n"
             "close e?=taken\n") ==
        "cilindro_agregado\ncono_agregado\nesfera_agregada\n"
        "elemento_ya_existe Agregar_Elemento.pre.1: e? ∉ elementos\n"
        "radio_no_positivo Agregar_Disco.pre.2: radio? ∈ Rmas\n"
        "closed\n"
        "elemento_ya_existe Agregar_Elemento.pre.1: e? ∉ elementos\n"
        "not_closed close.pre.1: e? ∈ elementos\n"
        "not_closed close.pre.2: de_que_tipo(e?) ∈ { soy_cilindro, soy_cono, soy_tronco }\n");
  CHECK(edited.of().scene.size() == 5);  // the base of the first attempt is gone with its top
  CHECK(edited.of().scene.find("can:base").has_value());
}

TEST_CASE("What does not hold is answered, and the scene is as it was") {
  EditedScene edited;
  CHECK(edited.types().empty());
  CHECK(edit(edited, "Agregar_Esfera e?=a centro?=(0,0,0) radio?=0") ==
        "radio_no_positivo Agregar_Esfera.pre.2: radio? ∈ Rmas\n");
  CHECK(edited.of().scene.size() == 0);
  CHECK(edit(edited, "Agregar_Esfera e?=a centro?=(0,0,0) radio?=1\nEliminar_Esfera e?=a") ==
        "esfera_agregada\nesfera_eliminada\n");
  CHECK_THROWS_AS(edit(edited, "Agregar_Toro e?=a centro?=(0,0,0) mayor?=2 menor?=1"), InputError);
}

TEST_CASE("The text of an edited scene has its groups") {
  EditedScene edited;
  edit(edited, "Agregar_Esfera e?=a centro?=(0,0,0) radio?=1\ngroup g?=one elementos?=a\n");
  CHECK(edited.scene_text() == scene_text(edited.of().scene, edited.of().groups));
  CHECK(edited.scene_text().find("\"one\"") != std::string::npos);
}

}  // namespace
}  // namespace durero::io
