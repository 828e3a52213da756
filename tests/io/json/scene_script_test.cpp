// The script that makes one scene of another.
#include "durero/io/json/scene_script.hpp"

#include "durero/io/json/groups_file.hpp"
#include "durero/io/json/operation_text.hpp"
#include "durero/io/json/scene_changes.hpp"
#include "io/json/any_edit.hpp"
#include "io/json/edited_script.hpp"
#include "io/json/regrouping.hpp"
#include "support/catch.hpp"
#include "support/property.hpp"

namespace durero::io {
namespace {

std::string text_of(const scene::GroupedScene& of) { return scene_text(of.scene, of.groups); }

scene::GroupedScene scene_of(const std::string& members) {
  return read_grouped_scene(Source("f", R"({"format":"durero-scene","version":1,)" + members + "}"), Bodies::read);
}

/// What a script that is read makes of a scene; every line must be done.
std::string made_by(const scene::GroupedScene& from, const std::string& script) {
  EditedScene edited(from);
  for (const ScriptStep& step : read_script(Source("script", script), edited.stage()))
    RC_ASSERT(edited.apply_total(step).ok());
  return edited.scene_text();
}

/// The script between scenes of these elements and the rest; `beyond` where there is something.
std::string script_of(const std::string& from, const std::string& to) {
  const scene::GroupedScene a = scene_of(from), b = scene_of(to);
  const SceneScript script = script_between(a, b);
  if (script.beyond.empty()) {
    CHECK(made_by(a, script_text(script, a.scene.stage())) == text_of(b));
    return script_text(script, a.scene.stage());
  }
  CHECK(script.steps.empty());
  std::string beyond = "beyond";
  for (const std::string& part : script.beyond) beyond += " " + part;
  return beyond;
}

std::string elements(const std::string& items) { return "\"elementos\":[" + items + "]"; }

const std::string ball = R"({"id":"ball","tipo":"esfera","centro":[0,1,0],"radio":1})";
const std::string disc = R"({"id":"disc","tipo":"disco","centro":[0,1,0],"radio":1,"vector":[0,1,0]})";

TEST_CASE("An element that is the same is in no line") {
  CHECK(script_of(elements(ball), elements(ball)) == "");
  CHECK(script_of(elements(ball), elements(disc + "," + ball)) ==
        "Agregar_Disco e?=disc centro?=(0,1,0) radio?=1 vector?=(0,1,0)\n");
  CHECK(script_of(elements(disc + "," + ball), elements(disc)) == "Eliminar_Esfera e?=ball\n");
  CHECK(script_of(elements(ball), elements(R"({"id":"ball","tipo":"esfera","centro":[0,-0.0,0],"radio":1})")) ==
        "Cambiar_Centro_Esfera e?=ball centro?=(0,-0,0)\n");
}

TEST_CASE("An element gets another material, the first, or none") {
  const std::string materials = R"("materials":{"blue":{"color":[0,0,1]},"red":{"color":[1,0,0]}},)";
  const auto of = [&](const std::string& material) {
    return materials + elements(R"({"id":"ball","tipo":"esfera","centro":[0,1,0],"radio":1)" + material + "}");
  };
  const std::string red = R"(,"material":"red")", blue = R"(,"material":"blue")";
  CHECK(script_of(of(red), of(blue)) == "Cambiar_Material e?=ball material?=blue\n");
  CHECK(script_of(of(""), of(red)) == "Cambiar_Material e?=ball material?=red\n");
  CHECK(script_of(of(red), of("")) == "Quitar_Material e?=ball\n");
}

TEST_CASE("A mesh that differs in a vertex is moved there, and else replaced") {
  const auto mesh = [](const std::string& last, const std::string& faces, const std::string& rest = "") {
    return R"("elementos":[],"mallas":[{"id":"m","puntos":[[0,0,0],[1,0,0],)" + last + R"(],"caras":[)" + faces + "]" +
           rest + "}]";
  };
  CHECK(script_of(mesh("[0,1,0]", "[0,1,2]"), mesh("[0,2,0]", "[0,1,2]")) ==
        "Mover_Vertice m?=m n?=2 punto?=(0,2,0)\n");
  CHECK(script_of(mesh("[0,1,0]", "[0,1,2]"), mesh("[0,2,-0.0]", "[0,1,2]")) ==
        "Mover_Vertice m?=m n?=2 punto?=(0,2,-0)\n");
  CHECK(script_of(mesh("[0,1,0]", "[0,1,2]"), mesh("[0,1,0]", "[1,2,0]")) ==
        "Reemplazar_Malla m?=m puntos?=((0,0,0),(1,0,0),(0,1,0)) caras?=((1,2,0))\n");
  CHECK(script_of(mesh("[0,1,0]", "[0,1,2]"), mesh("[0,1,-0.0]", "[0,1,2]")) ==
        "Mover_Vertice m?=m n?=2 punto?=(0,1,-0)\n");
  CHECK(script_of(mesh("[0,1,0]", "[0,1,2]"), mesh("[0,2,0]", "[1,2,0]")) ==
        "Reemplazar_Malla m?=m puntos?=((0,0,0),(1,0,0),(0,2,0)) caras?=((1,2,0))\n");
  CHECK(script_of(mesh("[0,1,0]", "[0,1,2]"), elements("")) == "Eliminar_Malla m?=m\n");
  CHECK(script_of(elements(""), mesh("[0,1,0]", "[0,1,2]")) ==
        "Agregar_Malla m?=m puntos?=((0,0,0),(1,0,0),(0,1,0)) caras?=((0,1,2))\n");
  const std::string uv = R"(,"uv":[[0,0],[1,0],[0,1]])";
  CHECK(script_of(mesh("[0,1,0]", "[0,1,2]", uv), mesh("[0,2,0]", "[0,1,2]", uv)) ==
        "Mover_Vertice m?=m n?=2 punto?=(0,2,0)\n");
  CHECK(script_of(mesh("[0,1,0]", "[0,1,2]"), mesh("[0,1,0]", "[0,1,2]", uv)) == "beyond /mallas/m");
  CHECK(script_of(mesh("[0,1,0]", "[0,1,2]", uv), mesh("[0,2,0]", "[0,1,2]", R"(,"uv":[[0,0],[1,0],[-0.0,1]])")) ==
        "beyond /mallas/m");
  CHECK(script_of(mesh("[0,1,0]", "[0,1,2]", uv), mesh("[0,2,0]", "[1,2,0]", uv)) == "beyond /mallas/m");
}

TEST_CASE("A name that changes its owner is free before it is taken") {
  const std::string face = R"({"id":"m:0","tipo":"esfera","centro":[0,1,0],"radio":1})";
  const std::string mesh = R"(,"mallas":[{"id":"m","puntos":[[0,0,0],[1,0,0],[0,1,0]],"caras":[[0,1,2]]}])";
  const std::string mesh_script = "Agregar_Malla m?=m puntos?=((0,0,0),(1,0,0),(0,1,0)) caras?=((0,1,2))\n";
  CHECK(script_of(elements(face), elements("") + mesh) == "Eliminar_Esfera e?=m:0\n" + mesh_script);
  CHECK(script_of(elements("") + mesh, elements(face)) ==
        "Eliminar_Malla m?=m\nAgregar_Esfera e?=m:0 centro?=(0,1,0) radio?=1\n");
}

TEST_CASE("An instance is copied from an element of its shape, or from a part that is made for it") {
  const std::string copy = R"({"id":"copy","tipo":"instancia","de":{"tipo":"esfera","centro":[0,1,0],"radio":1},)"
                           R"("mapa":[[2,0,0,5],[0,1,0,0],[0,0,1,0]]})";
  const std::string line = "Agregar_Instancia e?=copy de?=ball centro?=(5,0,0) x?=(2,0,0) y?=(0,1,0) z?=(0,0,1)\n";
  CHECK(script_of(elements(ball), elements(ball + "," + copy)) == line);
  CHECK(script_of(elements(""), elements(ball + "," + copy)) ==
        "Agregar_Esfera e?=ball centro?=(0,1,0) radio?=1\n" + line);
  CHECK(script_of(elements(ball), elements(copy)) ==
        "Eliminar_Esfera e?=ball\n"
        "Agregar_Esfera e?=part:1 centro?=(0,1,0) radio?=1\n"
        "Agregar_Instancia e?=copy de?=part:1 centro?=(5,0,0) x?=(2,0,0) y?=(0,1,0) z?=(0,0,1)\n"
        "Eliminar_Esfera e?=part:1\n");
  CHECK(script_of(elements(copy), elements("")) == "Eliminar_Instancia e?=copy\n");
  // A part serves all bodies, and is removed behind the last.
  std::string again = copy;
  again.replace(again.find("copy"), 4, "part:1");
  CHECK(script_of(elements(""), elements(copy + "," + again)) ==
        "Agregar_Esfera e?=part:2 centro?=(0,1,0) radio?=1\n"
        "Agregar_Instancia e?=copy de?=part:2 centro?=(5,0,0) x?=(2,0,0) y?=(0,1,0) z?=(0,0,1)\n"
        "Agregar_Instancia e?=part:1 de?=part:2 centro?=(5,0,0) x?=(2,0,0) y?=(0,1,0) z?=(0,0,1)\n"
        "Eliminar_Esfera e?=part:2\n");
  // No part has the name of an element of either scene.
  const std::string second = R"({"id":"part:2","tipo":"esfera","centro":[0,0,0],"radio":1})";
  const std::string first = R"({"id":"part:1","tipo":"esfera","centro":[0,0,0],"radio":1})";
  CHECK(script_of(elements(first), elements(second + "," + copy)) ==
        "Eliminar_Esfera e?=part:1\n"
        "Agregar_Esfera e?=part:2 centro?=(0,0,0) radio?=1\n"
        "Agregar_Esfera e?=part:3 centro?=(0,1,0) radio?=1\n"
        "Agregar_Instancia e?=copy de?=part:3 centro?=(5,0,0) x?=(2,0,0) y?=(0,1,0) z?=(0,0,1)\n"
        "Eliminar_Esfera e?=part:3\n");
  const std::string third = R"({"id":"copy","tipo":"instancia","de":{"tipo":"esfera","centro":[0,1,0],"radio":1},)"
                            R"("mapa":[["1/3",0,0,5],[0,1,0,0],[0,0,1,0]]})";
  CHECK(script_of(elements(ball), elements(ball + "," + third)) == "beyond /elementos/copy");
  CHECK(script_of(elements(third), elements("")) == "Eliminar_Instancia e?=copy\n");
}

TEST_CASE("A solid is made of elements, and of parts that are gone behind it") {
  const std::string two = R"({"id":"two","tipo":"union","de":[{"tipo":"esfera","centro":[0,1,0],"radio":1},)"
                          R"({"tipo":"esfera","centro":[0,1,0],"radio":1}]})";
  CHECK(script_of(elements(ball), elements(ball + "," + two)) ==
        "Agregar_Esfera e?=part:1 centro?=(0,1,0) radio?=1\n"
        "Agregar_Union e?=two de?=ball,part:1\n"
        "Eliminar_Esfera e?=part:1\n");
  const std::string nested =
      R"({"id":"cup","tipo":"diferencia","de":[{"tipo":"plano","centro":[0,0,0],"vector":[0,1,0]},)"
      R"({"tipo":"interseccion","de":[{"tipo":"esfera","centro":[0,1,0],"radio":1},)"
      R"({"tipo":"plano","centro":[0,0,0],"vector":[0,1,0]}]}]})";
  CHECK(script_of(elements(ball), elements(ball + "," + nested)) ==
        "Agregar_Plano e?=part:1 centro?=(0,0,0) vector?=(0,1,0)\n"
        "Agregar_Interseccion e?=part:2 de?=ball,part:1\n"
        "Agregar_Diferencia e?=cup de?=part:1,part:2\n"
        "Eliminar_Solido e?=part:2\n"
        "Eliminar_Plano e?=part:1\n");
}

TEST_CASE("A difference that no operation makes is named") {
  CHECK(script_of(R"("max_depth":3,)" + elements(""), elements(ball)) == "beyond /max_depth");
  CHECK(script_of(elements(""), R"("materials":{"red":{"color":[1,0,0]}},)" + elements("")) == "beyond /materials/red");
  CHECK(script_of(R"("background":[0,0,0],)" + elements(""), R"("background":[0,0,1],)" + elements("")) ==
        "beyond /background");
  CHECK(script_of(elements(""),
                  R"("materials":{"red":{"color":[1,0,0]}},)" +
                      elements(R"({"id":"a","tipo":"esfera","centro":[0,1,0],"radio":1,"material":"red"})")) ==
        "beyond /materials/red");
  const std::string moving = R"({"id":"ball","tipo":"esfera","centro":[0,1,0],"radio":1,"motion":[1,0,0]})";
  CHECK(script_of(elements(ball), elements(moving)) == "beyond /elementos/ball");
  CHECK(script_of(elements(moving), elements("")) == "Eliminar_Esfera e?=ball\n");
}

TEST_CASE("Groups change by the fewest edits") {
  const auto script = [&](const std::string& from, const std::string& to) {
    const std::string both = "," + elements(ball + "," + disc);
    return script_of("\"groups\":{" + from + "}" + both, "\"groups\":{" + to + "}" + both);
  };
  const std::string pair = R"("pair":{"elementos":["ball","disc"]})";
  CHECK(script("", pair) == "group g?=pair elementos?=ball,disc\n");
  CHECK(script(pair, "") == "ungroup g?=pair\n");
  CHECK(script(pair, pair + R"(,"all":{"groups":["pair"]})") == "group g?=all groups?=pair\n");
  CHECK(script(R"("a":{"groups":["b"]},"b":{"elementos":["ball"]})", R"("a":{"elementos":["ball"]})") ==
        "ungroup g?=b\n");
  CHECK(script(R"("a":{"elementos":["disc"],"groups":["b"]},"b":{"elementos":["ball"]})",
               R"("a":{"elementos":["disc"],"groups":["b"]},"b":{})") == "Quitar_Grupo e?=ball\n");
  CHECK(script(R"("a":{"elementos":["ball"]})", R"("a":{"elementos":["disc"]})") ==
        "ungroup g?=a\ngroup g?=a elementos?=disc\n");
  // The group above stays, and what it held goes to it and is made anew beside it.
  CHECK(script(R"("h":{"groups":["c"]},"c":{"elementos":["ball","disc"]})",
               R"("h":{"elementos":["ball","disc"]},"c":{})") == "ungroup g?=c\ngroup g?=c\n");
  CHECK(script(R"("h":{"elementos":["ball"],"groups":["x"]},"x":{})", R"("h":{"elementos":["ball"]},"x":{})") ==
        "ungroup g?=x\ngroup g?=x\n");
  // Two that would be made anew cost as much as the group that they were in.
  CHECK(script(R"("h":{"elementos":["ball"],"groups":["x","y"]},"x":{},"y":{})",
               R"("h":{"elementos":["ball"]},"x":{},"y":{})") == "ungroup g?=h\ngroup g?=h elementos?=ball\n");
}

/// Makes and dissolves groups: a new one holds any of what is in none.
void regroup(scene::GroupedScene& of, int edits) {
  for (; edits > 0; --edits) {
    if (test::below(3) == 0) {
      of.apply_total(scene::GroupEdit(scene::Ungrouping{test::any_group_name()}));
      continue;
    }
    scene::Grouping made{test::any_group_name(), {}};
    for (const char* e : {"a", "b", "ball", "c"})
      if (of.groups.of_element(e).empty() && test::flip()) made.of.elementos.insert(e);
    for (const auto& [g, group] : of.groups.table())
      if (of.groups.of_group(g).empty() && test::flip()) made.of.groups.insert(g);
    of.apply_total(scene::GroupEdit(made));
  }
}

/// The fewest edits, by trying every set of groups to dissolve.
std::size_t fewest(const scene::Groups& from, const scene::Groups& to, const scene::Scene& scene) {
  std::vector<std::string> names;
  for (const auto& [name, group] : from.table()) names.push_back(name);
  std::size_t best = ~std::size_t{0};
  for (std::size_t set = 0; set < std::size_t{1} << names.size(); ++set) {
    scene::Groups now = from;
    std::size_t edits = 0;
    for (std::size_t i = 0; i < names.size(); ++i)
      if ((set >> i & 1U) != 0) edits += now.apply_total(scene::Ungrouping{names[i]}, scene).ok();
    for (const std::string_view g : to.bottom_up())
      if (!now.table().contains(g))
        edits += now.apply_total(scene::Grouping{std::string(g), to.table().find(g)->second}, scene).ok();
    if (now == to) best = std::min(best, edits);
  }
  return best;
}

TEST_CASE("No shorter way leads from groups to groups") {
  test::property("any two forests of groups", [] {
    scene::GroupedScene a = scene_of(elements(ball));
    for (const char* name : {"a", "b", "c"})
      a.scene.apply_total(scene::Edit{model::Agregar_Esfera{model::Elemento(name), model::Punto(0, 0, 0), 1}, {}});
    regroup(a, 12);
    scene::GroupedScene b = a;
    regroup(b, test::below(12));
    const std::vector<scene::GroupEdit> edits = regrouping(a.groups, b.groups);
    scene::Groups now = a.groups;
    for (const scene::GroupEdit& edit : edits) RC_ASSERT(now.apply_total(edit, a.scene).ok());
    RC_ASSERT(now == b.groups);
    RC_ASSERT(edits.size() == fewest(a.groups, b.groups, a.scene));
  });
}

/// The part that a step is about.
PartKey part_of(const ScriptStep& step) {
  return std::visit(
      []<class Edit>(const Edit& edit) -> PartKey {
        if constexpr (std::is_same_v<Edit, scene::Edit>)
          return {PartKind::elementos, scene::name_of(edit.operation).name()};
        else if constexpr (std::is_same_v<Edit, scene::GroupEdit>)
          return {PartKind::groups, std::visit([](const auto& in) { return in.g; }, edit)};
        else if constexpr (std::is_same_v<Edit, scene::MeshEdit>)
          return {PartKind::mallas, std::visit(
                                        []<class In>(const In& in) {
                                          if constexpr (requires { in.mesh; })
                                            return in.mesh.m.name();
                                          else
                                            return in.m.name();
                                        },
                                        edit)};
        else if constexpr (std::is_same_v<Edit, model::AttributeChange>)
          return {PartKind::elementos, model::name_of(edit).name()};
        else if constexpr (std::is_same_v<Edit, model::LookChange>)
          return std::visit(
              []<class In>(const In& in) -> PartKey {
                constexpr bool is_of_group =
                    std::is_same_v<In, model::Cambiar_Grupo> || std::is_same_v<In, model::Quitar_Grupo>;
                return {is_of_group ? PartKind::groups : PartKind::elementos, in.e.name()};
              },
              edit);
        else if constexpr (requires { edit.e; })
          return {PartKind::elementos, edit.e};
        else
          return {PartKind::camera, "a step of another kind"};
      },
      step.edit);
}

/// How many steps a part may take that differs: an element in a group is not put into it again, and one that has what
/// no operation gives is changed in any number of attributes.
std::size_t most_steps(const PartChange& change, const scene::GroupedScene& a) {
  if (!change.from || !change.to) return 1;
  if (change.part.kind != PartKind::elementos) return 2;
  const auto element = a.scene.find(change.part.name).value();
  if (a.scene.motion(element) != nullptr || a.scene.vertex_normals(element)) return 7;
  return a.groups.of_element(change.part.name).empty() ? 2 : 3;
}

/// Steps are about parts that differ, each once or twice, or about parts of solids, which neither scene has; groups may
/// be dissolved for others.
bool touches_what_differs(const SceneScript& script, const scene::GroupedScene& a, const scene::GroupedScene& b) {
  std::map<PartKey, std::size_t> most;
  for (const PartChange& change : part_changes(a, b)) most[change.part] = most_steps(change, a);
  for (const ScriptStep& step : script.steps) {
    const PartKey part = part_of(step);
    const bool is_made = part.kind == PartKind::elementos && !a.scene.find(part.name) && !b.scene.find(part.name);
    if (part.kind == PartKind::groups || is_made) continue;
    const auto left = most.find(part);
    if (left == most.end() || left->second == 0) return false;
    --left->second;
  }
  return true;
}

TEST_CASE("A script makes of one scene the other, byte for byte") {
  test::property("any two scenes with a common past", [] {
    scene::GroupedScene a = test::any_grouped_scene();
    scene::GroupedScene b = a;
    test::edit_at_random(a, 20);
    test::edit_at_random(b, 30);
    if (test::below(4) == 0) test::look_at_random(b.scene);
    const SceneScript script = script_between(a, b);
    RC_TAG(script.beyond.empty() ? "by operations" : "beyond");
    if (!script.beyond.empty()) return;
    RC_ASSERT(made_by(a, script_text(script, a.scene.stage())) == text_of(b));
    RC_ASSERT(script.steps.empty() == (text_of(a) == text_of(b)));
    RC_ASSERT(touches_what_differs(script, a, b));
    RC_ASSERT(script_between(b, b).steps.empty());
  });
}

}  // namespace
}  // namespace durero::io
