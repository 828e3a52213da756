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

TEST_CASE("An element changes, and keeps its name, its material and its group") {
  EditedScene edited(
      read_grouped_scene(Source("scene", R"({"format":"durero-scene","version":1,"materials":{"red":{"color":[1,0,0]},
"brick":{"color":[1,0,0],"textures":{"color":"checks"}}},"textures":{"checks":{"checker":[[1,1,1],[0.2,0.2,0.2]]}},
"elementos":[{"id":"s","tipo":"esfera","centro":[0,0,5],"radio":1,"material":"red"},
{"id":"can","tipo":"cilindro","centro":[0,0,0],"radio":1,"vector":[0,1,0],"altura":2}],
"mallas":[{"id":"tent","puntos":[[0,0,0],[1,0,0],[0,1,0]],"caras":[[0,1,2]]}],
"groups":{"pair":{"elementos":["s"]},"rest":{"elementos":["tent:0"]}}})"),
                         Bodies::read));
  CHECK(edit(edited,
             "Cambiar_Radio_Esfera e?=s radio?=2\n"
             "Cambiar_Centro e?=s centro?=(1,2,3)\n"
             "{\"op\":\"Cambiar_Vector_Cilindro\",\"e\":\"can\",\"vector\":[1,0,0]}\n"
             "Cambiar_Altura e?=can altura?=0\n"
             "Cambiar_Radio_Tronco e?=can radio?=1\n"
             "Cambiar_Vertices e?=tent:0 vertices?=((0,0,0),(1,0,0),(0,1,0))\n"
             "Cambiar_Material e?=can material?=red\n"
             "Cambiar_Material e?=can material?=blue\n"
             "Cambiar_Material e?=tent:0 material?=red\n"
             "Quitar_Material e?=s\n"
             "Cambiar_Grupo e?=can g?=pair\n"
             "Cambiar_Grupo e?=tent:0 g?=pair\n"
             "Cambiar_Grupo e?=s g?=none\n"
             "Cambiar_Grupo e?=nobody g?=pair\n"
             "Quitar_Grupo e?=s\n"
             "Quitar_Grupo e?=s\n") ==
        "elemento_cambiado\nelemento_cambiado\nelemento_cambiado\n"
        "altura_no_positiva Cambiar_Altura.pre.2: altura? ∈ Rmas\n"
        "tipo_incorrecto Es_Tronco.pre.1: e? ↦ soy_tronco ∈ de_que_tipo\n"
        "es_de_malla Fuera_De_Malla.pre.1: e? ∉ de_malla(θMallas)\n"
        "elemento_cambiado\n"
        "material_no_existe Cambiar_Material.pre.2: material? ∈ materiales\n"
        "es_de_malla Fuera_De_Malla.pre.1: e? ∉ de_malla(θMallas)\n"
        "elemento_cambiado\nelemento_cambiado\nelemento_cambiado\n"
        "grupo_no_existe Cambiar_Grupo.pre.2: g? ∈ grupos\n"
        "elemento_no_existe Cambiar_Grupo.pre.1: e? ∈ elementos\n"
        "elemento_cambiado\nelemento_cambiado\n");
  const scene::Groups& groups = edited.of().groups;
  CHECK(groups.table().at("pair").elementos == scene::Names{"can", "tent:0"});
  CHECK(groups.table().at("rest").elementos.empty());
  const auto s = edited.of().scene.find("s").value(), can = edited.of().scene.find("can").value();
  CHECK(!edited.of().scene.material(s));
  CHECK(edited.of().scene.material(can).has_value());
}

TEST_CASE("A body has no attributes of its own, and no coordinates") {
  EditedScene edited(read_grouped_scene(Source("scene", R"({"format":"durero-scene","version":1,
"materials":{"brick":{"color":[1,0,0],"textures":{"color":"checks"}}},
"textures":{"checks":{"checker":[[1,1,1],[0.2,0.2,0.2]]}},
"elementos":[{"id":"s","tipo":"esfera","centro":[0,0,5],"radio":1}]})"),
                                        Bodies::read));
  CHECK(edit(edited,
             "Agregar_Instancia e?=copy de?=s centro?=(0,0,9) x?=(2,0,0) y?=(0,1,0) z?=(0,0,1)\n"
             "Cambiar_Radio e?=copy radio?=2\n"
             "Cambiar_Radio_Esfera e?=copy radio?=2\n"
             "Cambiar_Material e?=s material?=brick\n") ==
        "instancia_agregada\n"
        "tipo_incorrecto Cambiar_Radio.pre.1: e? ∈ dom mi_radio\n"
        "tipo_incorrecto Es_Esfera.pre.1: e? ↦ soy_esfera ∈ de_que_tipo\n"
        "elemento_cambiado\n");
  CHECK_THROWS_AS(edit(edited, "Cambiar_Material e?=copy material?=brick"), std::domain_error);
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
