#include "durero/model/operaciones_clauses.hpp"

#include <fstream>
#include <iterator>
#include <regex>
#include <string>
#include <vector>

#include "escenas.hpp"
#include "support/catch.hpp"
#include "support/tree.hpp"

// Each operation and each error hands over the predicates of its schema, all of them, in the order of the text.
// What the predicates say is tested beside the operations (operaciones_test, operaciones_errors_test).

using namespace durero;
using namespace durero::model;
using namespace durero::test;
using contract::cost;
using Labels = std::vector<std::string>;

namespace {

/// The labels of one schema in spec/operaciones.tex, in its order, of one kind.
Labels text(const std::string& schema, const std::string& kind) {
  std::ifstream file(source_dir() + "/spec/operaciones.tex");
  const std::string all{std::istreambuf_iterator<char>(file), {}};
  const std::regex label("% (" + schema + "\\." + kind + "\\.[0-9]+)\n");
  Labels labels;
  for (std::sregex_iterator at(all.begin(), all.end(), label), end; at != end; ++at) labels.push_back((*at)[1]);
  return labels;
}

/// The labels of several schemas, one after another.
Labels texts(const std::vector<std::string>& schemas, const std::string& kind) {
  Labels labels;
  for (const std::string& schema : schemas)
    for (std::string& label : text(schema, kind)) labels.push_back(std::move(label));
  return labels;
}

Labels labels_of(const Judgements& judgements) {
  Labels labels;
  for (const Judgement& judgement : judgements) labels.emplace_back(judgement.what->label);
  return labels;
}

/// An operation that can be done on one_of_each(), and the schemas that it includes, the last of them its own.
void follows(const Operation& operation, const std::vector<std::string>& schemas) {
  const Escena before = one_of_each();
  Escena after = before;
  const Respuesta r = model::apply(after, operation);
  CHECK(labels_of(pre(before, operation)) == texts(schemas, "pre"));
  for (const cost price : {cost::normal, cost::audit})
    CHECK(labels_of(post(before, operation, after, r, price)) == texts(schemas, "post"));
}

}  // namespace

TEST_CASE("an addition says what its schema and the one it includes say, in their order") {
  CHECK(text("Agregar_Cono", "post").size() == 7);
  follows(agregar_esfera, {"Agregar_Elemento", "Agregar_Esfera"});
  follows(agregar_cilindro, {"Agregar_Elemento", "Agregar_Cilindro"});
  follows(agregar_cono, {"Agregar_Elemento", "Agregar_Cono"});
  follows(agregar_tronco, {"Agregar_Elemento", "Agregar_Tronco"});
  follows(agregar_plano, {"Agregar_Elemento", "Agregar_Plano"});
  follows(agregar_disco, {"Agregar_Elemento", "Agregar_Disco"});
  follows(agregar_triangulo, {"Agregar_Elemento", "Agregar_Triangulo"});
  follows(Agregar_Elemento{nuevo, Tipo::soy_esfera, far, 2},
          {"Agregar_Elemento", "Agregar_Esfera", "Elemento_Agregado"});
  follows(Agregar_Elemento{nuevo, Tipo::soy_cono, far, {}, axis, 5, 2},
          {"Agregar_Elemento", "Agregar_Cono", "Elemento_Agregado"});
}

TEST_CASE("a removal says what its schema and the one it includes say, in their order") {
  follows(Eliminar_Esfera{esfera}, {"Eliminar_Elemento", "Eliminar_Esfera"});
  follows(Eliminar_Cilindro{cilindro}, {"Eliminar_Elemento", "Eliminar_Cilindro"});
  follows(Eliminar_Cono{cono}, {"Eliminar_Elemento", "Eliminar_Cono"});
  follows(Eliminar_Tronco{tronco}, {"Eliminar_Elemento", "Eliminar_Tronco"});
  follows(Eliminar_Plano{plano}, {"Eliminar_Elemento", "Eliminar_Plano"});
  follows(Eliminar_Disco{disco}, {"Eliminar_Elemento", "Eliminar_Disco"});
  follows(Eliminar_Triangulo{triangulo}, {"Eliminar_Elemento", "Eliminar_Triangulo"});
}

TEST_CASE("the general removal says what the removal of the type says; that the type is its own holds by choice") {
  const Escena before = one_of_each();
  Escena after = before;
  const Operation operation = Eliminar_Elemento{cilindro};
  const Respuesta r = model::apply(after, operation);
  CHECK(labels_of(pre(before, operation)) == text("Eliminar_Elemento", "pre"));
  CHECK(labels_of(post(before, operation, after, r, cost::normal)) ==
        texts({"Eliminar_Elemento", "Eliminar_Cilindro", "Elemento_Eliminado"}, "post"));
}

TEST_CASE("an error says what its schema says, in its order") {
  const auto follows_text = [](const Error& error, const std::string& schema) {
    CHECK(labels_of(judgements(one_of_each(), error, Respuesta::tipo_incorrecto)) == text(schema, "(?:pre|post)"));
  };
  follows_text(Elemento_Ya_Existe{esfera}, "Elemento_Ya_Existe");
  follows_text(Elemento_No_Existe{nuevo}, "Elemento_No_Existe");
  follows_text(Radio_No_Positivo{0}, "Radio_No_Positivo");
  follows_text(Vector_No_Unitario{not_unit}, "Vector_No_Unitario");
  follows_text(Altura_No_Positiva{0}, "Altura_No_Positiva");
  follows_text(Proporcion_No_Positiva{0}, "Proporcion_No_Positiva");
  follows_text(Vertices_Alineados{aligned}, "Vertices_Alineados");
  follows_text(No_Es_Esfera{cono}, "No_Es_Esfera");
  follows_text(No_Es_Cilindro{cono}, "No_Es_Cilindro");
  follows_text(No_Es_Cono{esfera}, "No_Es_Cono");
  follows_text(No_Es_Tronco{esfera}, "No_Es_Tronco");
  follows_text(No_Es_Plano{esfera}, "No_Es_Plano");
  follows_text(No_Es_Disco{plano}, "No_Es_Disco");
  follows_text(No_Es_Triangulo{plano}, "No_Es_Triangulo");
}
