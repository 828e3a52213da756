// Every clause that does not hold, with its values; held against the answers of the operations themselves.
#include "durero/io/json/why_not.hpp"

#include <fmt/format.h>

#include <map>
#include <set>

#include "durero/io/json/groups_file.hpp"
#include "io/json/edited_script.hpp"
#include "support/catch.hpp"
#include "support/scenes.hpp"

namespace durero::io {
namespace {

std::string told(const EditedScene& edited, const std::string& operation) {
  const std::vector<ScriptStep> steps = read_script(Source("script", operation), edited.of().scene.stage());
  REQUIRE(steps.size() == 1);
  return why_not_text(1, why_not(edited, steps.front()));
}

std::string clause(const char* label, const char* predicate, const std::string& values) {
  return fmt::format(R"j({{"label":"{}","predicate":"{}","values":{{{}}}}})j", label, predicate, values);
}
std::string refusal(const char* r, const std::string& clauses) {
  return fmt::format(R"j({{"line":1,"ok":false,"r":"{}","broken":[{}]}})j", r, clauses);
}

TEST_CASE("every clause of an operation that does not hold is told, with the values of what it names") {
  EditedScene edited;
  test::edit(edited,
             "Agregar_Esfera e?=a centro?=(0,0,0) radio?=1\n"
             "Agregar_Malla m?=tent puntos?=((0,0,0),(1,0,0),(0,1,0)) caras?=((0,1,2))\n");
  const std::string before = edited.scene_text();
  CHECK(told(edited, "Agregar_Cono e?=a centro?=(0,0,0) proporcion?=0 vector?=(0,3,4) altura?=-2") ==
        refusal("elemento_ya_existe", clause("Agregar_Elemento.pre.1", "e? ∉ elementos", R"j("e?":"a")j") + "," +
                                          clause("Agregar_Cono.pre.2", "proporcion? ∈ Rmas", R"j("proporcion?":0)j") +
                                          "," +
                                          clause("Agregar_Cono.pre.3", "vector? ∈ Unitario", R"j("vector?":[0,3,4])j") +
                                          "," + clause("Agregar_Cono.pre.4", "altura? ∈ Rmas", R"j("altura?":-2)j")));
  CHECK(told(edited, "Eliminar_Cono e?=a") ==
        refusal("tipo_incorrecto", clause("Eliminar_Cono.pre.1", "de_que_tipo(e?) = soy_cono",
                                          R"j("e?":"a","de_que_tipo(e?)":"soy_esfera")j")));
  CHECK(told(edited, "Eliminar_Esfera e?=a") == R"j({"line":1,"ok":true,"r":"esfera_eliminada","broken":[]})j");
  CHECK(told(edited, "Agregar_Elemento e?=b t?=soy_triangulo vertices?=((0,0,0),(1,0,0),(2,0,0))") ==
        refusal("vertices_alineados", clause("Agregar_Triangulo.pre.2", "vertices? ∈ Vertices",
                                             R"j("vertices?":[[0,0,0],[1,0,0],[2,0,0]])j")));
  CHECK(told(edited, "Agregar_Union e?=b de?=a,x") ==  // e? is no part of de?
        refusal("elemento_no_existe", clause("Agregar_Solido.pre.2", "ran de? ⊆ elementos", R"j("de?":["a","x"])j")));
  CHECK(told(edited, "Eliminar_Elemento e?=tent:0") ==
        refusal("es_de_malla", clause("Fuera_De_Malla.pre.1", "e? ∉ de_malla(θMallas)", R"j("e?":"tent:0")j")));
  const std::string red = R"j("red?":"2 puntos, 1 caras, caras 0 = (0,1,2)")j", both = R"j("m?":"tent",)j" + red;
  CHECK(told(edited, "Agregar_Malla m?=tent puntos?=((0,0,0),(1,0,0)) caras?=((0,1,2))") ==
        refusal("malla_ya_existe", clause("Agregar_Malla.pre.1", "m? ∉ dom mallas", R"j("m?":"tent")j") + "," +
                                       clause("Agregar_Malla.pre.2", "red? ∈ Completa", red) + "," +
                                       clause("Agregar_Malla.pre.3", "red? ∈ Malla", red) + "," +
                                       clause("Agregar_Malla.pre.4", "(m?, red?) ∈ dom familia", both) + "," +
                                       clause("Agregar_Malla.pre.5", "dom (familia(m?, red?)) ∩ elementos = ∅", both)));
  CHECK(edited.scene_text() == before);
}

/// Operations about few names, with inputs that are often refused.
class RandomOperations {
 public:
  std::string next() {
    switch (random_.below(9)) {
      case 0:
        return fmt::format("Agregar_Esfera e={} centro=(0,0,{}) radio={}", name(), random_.below(9), length());
      case 1:
        return fmt::format("Agregar_Cilindro e={} centro=(0,0,0) radio={} vector={} altura={}", name(), length(),
                           axis(), length());
      case 2:
        return fmt::format("Agregar_Elemento e={} t=soy_disco centro=(0,0,0) radio={} vector={}", name(), length(),
                           axis());
      case 3:
        return fmt::format("Eliminar_{} e={}", random_.below(2) == 0 ? "Cilindro" : "Esfera", name());
      case 4:
        return fmt::format("Eliminar_{} e={}", random_.below(2) == 0 ? "Elemento" : "Instancia", name());
      case 5:
        return fmt::format("close e={} base={} top={}", name(), name(), name());
      case 6:
        return fmt::format("group g={} elementos={}", name(), two_names());
      case 7:
        return fmt::format("Agregar_{} e={} de={}", random_.below(2) == 0 ? "Union" : "Diferencia", name(),
                           two_names());
      default:
        return fmt::format("Agregar_Instancia e={} de={} centro=(0,0,0) x=({},0,0) y=(0,1,0) z=(0,0,1)", name(), name(),
                           random_.below(3));
    }
  }

 private:
  std::string name() { return fmt::format("e{}", random_.below(6)); }
  std::string two_names() {
    const std::uint64_t one = random_.below(6);
    return fmt::format("e{},e{}", one, (one + 1 + random_.below(5)) % 6);
  }
  int length() { return static_cast<int>(random_.below(5)) - 1; }
  std::string axis() { return random_.below(3) == 0 ? "(0,0,2)" : "(0,0,1)"; }

  test::Random random_{20261130};
};

TEST_CASE("an operation is refused where clauses do not hold, by the first of them, over random operations") {
  RandomOperations operations;
  EditedScene edited;
  std::map<std::size_t, std::size_t> refusals;  // by the number of clauses
  for (int i = 0; i < 4000; ++i) {
    const std::string operation = operations.next();
    CAPTURE(operation);
    const ScriptStep step = read_script(Source("script", operation), edited.of().scene.stage()).front();
    const WhyNot why = why_not(edited, step);
    const EditAnswer answer = edited.apply_total(step);
    CHECK(why.is_whole);
    CHECK(why.answer.r == answer.r);
    CHECK(why.broken.empty() == answer.ok());
    std::set<std::string> labels;
    for (const BrokenClause& clause : why.broken) labels.insert(clause.label);
    CHECK(labels.size() == why.broken.size());
    if (!answer.ok()) {
      // Only of a body, which stands as a sphere, is the refusal none of the clauses over the state, and the last then.
      CHECK((why.broken.front().label == answer.violated || why.broken.back().label == answer.violated));
      ++refusals[why.broken.size()];
    }
  }
  CHECK(refusals[1] > 100);
  CHECK(refusals[2] > 100);
  CHECK(refusals[3] > 10);
}

}  // namespace
}  // namespace durero::io
