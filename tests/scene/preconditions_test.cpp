// All preconditions of an edit, held against its total edit, which tells the first that does not hold.
#include "durero/scene/preconditions.hpp"

#include <algorithm>
#include <set>

#include "durero/model/operaciones.hpp"
#include "durero/model/tipos.hpp"
#include "durero/scene/stage.hpp"
#include "support/catch.hpp"
#include "support/scenes.hpp"

namespace durero::scene {
namespace {

using contract::clause;

/// The first that does not hold; null where all hold.
const clause* first_broken(const model::Judgements& all) {
  const auto broken = std::ranges::find(all, false, &model::Judgement::holds);
  return broken == all.end() ? nullptr : broken->what;
}

std::vector<std::string_view> labels_of_broken(const model::Judgements& all) {
  std::vector<std::string_view> labels;
  for (const auto& [what, holds] : all)
    if (!holds) labels.push_back(what->label);
  return labels;
}

/// Of a scene that it changes.
const clause* violated_by(GroupedScene& of, const GroupEdit& in) { return of.apply_total(in).violated; }
const clause* violated_by(GroupedScene& of, const MeshEdit& in) { return of.apply_total(in).violated; }
const clause* violated_by(GroupedScene& of, const Closing& in) {
  const Lids lids = scene::lids(of.scene, in);
  if (lids.violated != nullptr) return lids.violated;
  const GroupedScene before = of;
  for (const Edit& lid : lids.additions)
    if (const model::Answer answer = of.apply_total(lid); !answer.ok()) {
      of = before;
      return answer.violated;
    }
  return nullptr;
}
template <class In>
const clause* violated_by(GroupedScene& of, const In& in) {
  return apply_total(of.scene, in).violated;
}

class RandomEdits {
 public:
  void grouping() { hold(GroupEdit(Grouping{name(), {names(2), names(2)}})); }
  void ungrouping() { hold(GroupEdit(Ungrouping{name()})); }
  void copying() {
    const auto axis = [&] { return model::ExactVector(model::Vector(random_.below(4) == 0 ? glm::dvec3(0) : cube())); };
    hold(Copying{name(), name(), {axis(), axis(), axis(), axis()}, {}});
  }
  void copy_removal() { hold(CopyRemoval{name()}); }
  void joining() { hold(Joining{Compound::Operation::united, name(), {name(), name()}, {}}); }
  void solid_removal() { hold(SolidRemoval{name()}); }
  void closing() {
    hold(Closing{name(), name(), name()});
    if (random_.below(20) == 0) add({model::Agregar_Cono{model::Elemento(name()), {0, 0, 0}, 1e200, {0, 1, 0}, 1e200}});
    if (random_.below(20) == 0)
      add({model::Agregar_Cilindro{model::Elemento(name()), {0, 1.7e308, 0}, 1, {0, 1, 0}, 1.7e308}});
  }
  void mesh() {
    Mesh mesh{model::Elemento("m" + std::to_string(random_.below(3)))};
    mesh.puntos = {cube(), cube(), cube(), cube()};
    const auto corner = [&] { return random_.below(24) == 0 ? 4U : static_cast<model::Ordinal>(random_.below(4)); };
    mesh.caras = {{0, 1, 2}, {corner(), corner(), corner()}};
    switch (random_.below(4)) {
      case 0:
        return hold(MeshEdit(MeshAddition{mesh}));
      case 1:
        return hold(MeshEdit(MeshRemoval{mesh.m}));
      case 2:
        return hold(MeshEdit(MeshReplacement{mesh}));
      default:
        return hold(MeshEdit(
            VertexMove{mesh.m, corner(), random_.below(3) == 0 ? model::Punto(mesh.puntos[0]) : model::Punto(cube())}));
    }
  }
  void addition() { add({test::random_addition(random_, name())}); }
  void removal() { add({model::Eliminar_Elemento{model::Elemento(name())}}); }

  const std::set<std::string>& seen() const { return seen_; }

 private:
  /// e0 … e5, and at times the name of a face.
  std::string name() {
    return random_.below(12) == 0 ? "m" + std::to_string(random_.below(3)) + ":1"
                                  : "e" + std::to_string(random_.below(6));
  }
  Names names(std::uint64_t most) {
    Names some;
    for (std::uint64_t n = random_.below(most + 1); n > 0; --n) some.insert(name());
    return some;
  }
  glm::dvec3 cube() { return random_.in_cube(2); }
  void add(const Edit& edit) { of_.apply_total(edit); }

  template <class In>
  void hold(const In& in) {
    const model::Judgements all = pre(of_, in);
    const clause* const first = violated_by(of_, in);
    CHECK((first == nullptr ? "" : first->label) == (first_broken(all) == nullptr ? "" : first_broken(all)->label));
    for (const auto& [what, holds] : all) seen_.insert(std::string(what->label) + (holds ? "" : " not"));
  }

  test::Random random_{20261129};
  GroupedScene of_{};
  std::set<std::string> seen_{};
};

TEST_CASE("the first precondition that does not hold is the one that each total edit tells, over random edits") {
  RandomEdits edits;
  for (int i = 0; i < 1500; ++i) {
    edits.addition();
    edits.grouping();
    edits.copying();
    edits.joining();
    edits.closing();
    edits.mesh();
    edits.removal();
    edits.copy_removal();
    edits.solid_removal();
    edits.ungrouping();
  }
  for (const char* label : {"group.pre.1",
                            "group.pre.2",
                            "group.pre.3",
                            "group.pre.4",
                            "group.pre.5",
                            "ungroup.pre.1",
                            "Agregar_Instancia.pre.1",
                            "Agregar_Instancia.pre.2",
                            "Mapa.inv.1",
                            "Eliminar_Instancia.pre.1",
                            "Eliminar_Instancia.pre.2",
                            "Agregar_Solido.pre.1",
                            "Agregar_Solido.pre.2",
                            "Agregar_Solido.pre.3",
                            "Eliminar_Solido.pre.1",
                            "Eliminar_Solido.pre.2",
                            "close.pre.1",
                            "close.pre.2",
                            "close.pre.3",
                            "close.pre.4",
                            "Agregar_Malla.pre.1",
                            "Agregar_Malla.pre.2",
                            "Agregar_Malla.pre.3",
                            "Agregar_Malla.pre.5",
                            "Mover_Vertice.pre.2",
                            "Mover_Vertice.pre.3",
                            "Reemplazar_Malla.pre.1",
                            "Eliminar_Malla.pre.1"}) {
    CAPTURE(label);
    CHECK(edits.seen().contains(label));
    CHECK(edits.seen().contains(std::string(label) + " not"));
  }
}

TEST_CASE("every precondition that does not hold is told, not only the first") {
  GroupedScene of;
  of.apply_total(Edit{model::Agregar_Disco{model::Elemento("d"), {0, 0, 0}, 1, {0, 0, 1}}, {}});
  of.apply_total(GroupEdit(Grouping{"g", {{"d"}, {}}}));
  using Labels = std::vector<std::string_view>;
  CHECK(labels_of_broken(pre(of, GroupEdit(Grouping{"g", {{"d", "x"}, {"h"}}}))) ==
        Labels{"group.pre.1", "group.pre.2", "group.pre.3", "group.pre.4"});
  CHECK(labels_of_broken(pre(of, Joining{Compound::Operation::united, "d", {"d", "x"}, {}})) ==
        Labels{"Agregar_Solido.pre.1", "Agregar_Solido.pre.2", "Agregar_Solido.pre.3"});
  const model::ExactVector zero(model::Vector(0, 0, 0));
  CHECK(labels_of_broken(pre(of, Copying{"d", "x", {zero, zero, zero, zero}, {}})) ==
        Labels{"Agregar_Instancia.pre.1", "Agregar_Instancia.pre.2", "Mapa.inv.1"});
  CHECK(labels_of_broken(pre(of, CopyRemoval{"x"})) == Labels{"Eliminar_Instancia.pre.1", "Eliminar_Instancia.pre.2"});
  CHECK(labels_of_broken(pre(of, SolidRemoval{"x"})) == Labels{"Eliminar_Solido.pre.1", "Eliminar_Solido.pre.2"});
  CHECK(labels_of_broken(pre(of, Closing{"d", "a", "a"})) == Labels{"close.pre.2", "close.pre.3", "close.pre.4"});
  CHECK(labels_of_broken(pre(of, MeshEdit(VertexMove{model::Elemento("m"), 0, {0, 0, 0}}))) ==
        Labels{"Mover_Vertice.pre.1", "Mover_Vertice.pre.2", "Mover_Vertice.pre.3"});
}

}  // namespace
}  // namespace durero::scene
