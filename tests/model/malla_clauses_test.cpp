#include "durero/model/malla_clauses.hpp"

#include <fstream>
#include <iterator>
#include <regex>

#include "mallas.hpp"
#include "support/catch.hpp"
#include "support/clauses.hpp"
#include "support/tree.hpp"

// Each operation and each error hands over the predicates of its schema, all of them, in the order of the text. What an
// error says is tried on states where it is so and where it is not.

using namespace durero;
using namespace durero::model;
using namespace durero::test;
using Labels = std::vector<std::string>;

namespace {

/// The labels of one schema in spec/malla.tex, in its order, of one kind.
Labels labels_in_text(const std::string& schema, const std::string& kind) {
  std::ifstream file(source_dir() + "/spec/malla.tex");
  const std::string all{std::istreambuf_iterator<char>(file), {}};
  const std::regex label("% (" + schema + "\\." + kind + "\\.[0-9]+)\n");
  Labels labels;
  for (std::sregex_iterator at(all.begin(), all.end(), label), end; at != end; ++at) labels.push_back((*at)[1]);
  return labels;
}

Labels labels_handed_over(const Judgements& judgements) {
  Labels labels;
  for (const Judgement& judgement : judgements) labels.emplace_back(judgement.what->label);
  return labels;
}

void follows(const MeshOperation& operation, const std::string& schema) {
  const Mallas before = with_square();
  Mallas after = before;
  const Respuesta r = model::apply(after, operation);
  Judgements preconditions_alone;
  for (const MeshPrecondition& each : preconditions(before, operation)) preconditions_alone.push_back(each.judged);
  CHECK(labels_handed_over(preconditions_alone) == labels_in_text(schema, "pre"));
  Labels posts = labels_in_text("Solo_Triangulos", "post");
  for (const std::string& label : labels_in_text(schema, "post")) posts.push_back(label);
  CHECK(labels_handed_over(post(before, operation, after, r)) == posts);
}

using Broken = std::set<std::string>;

/// What of an error does not hold of with_square().
Broken denied(const MeshError& error) {
  return broken(judgements(with_square(), error, std::visit([](const auto& in) { return in.answer; }, error)));
}

}  // namespace

TEST_CASE("an operation on meshes says what its schema and the one it includes say, in their order") {
  CHECK(labels_in_text("Agregar_Malla", "pre").size() == 5);
  follows(Agregar_Malla{fresh_mesh, square()}, "Agregar_Malla");
  follows(Eliminar_Malla{square_mesh}, "Eliminar_Malla");
  follows(Reemplazar_Malla{square_mesh, half_square()}, "Reemplazar_Malla");
  follows(Mover_Vertice{square_mesh, 0, Punto(1, 0, 0)}, "Mover_Vertice");
}

TEST_CASE("an error of meshes says what its schema says, in its order") {
  const auto follows_text = [](const MeshError& error, const std::string& wrong_answer) {
    const std::string schema = wrong_answer.substr(0, wrong_answer.find('.'));
    const Judgements all = judgements(with_square(), error, Respuesta::tipo_incorrecto);
    CHECK(labels_handed_over(all) == labels_in_text(schema, "(?:pre|post)"));
    CHECK(broken(all).contains(wrong_answer));
  };
  follows_text(Malla_Ya_Existe{square_mesh}, "Malla_Ya_Existe.post.1");
  follows_text(Malla_No_Existe{fresh_mesh}, "Malla_No_Existe.post.1");
  follows_text(Cara_Incompleta{incomplete_face()}, "Cara_Incompleta.post.1");
  follows_text(Caras_Alineadas{flat_face()}, "Caras_Alineadas.post.1");
  follows_text(Cara_Sin_Nombre{endless, square()}, "Cara_Sin_Nombre.post.1");
  follows_text(Cara_Ya_Existe{square_mesh, square()}, "Cara_Ya_Existe.post.1");
  follows_text(Vertice_No_Existe{square_mesh, 9}, "Vertice_No_Existe.post.1");
  follows_text(Vertice_Alineado{square_mesh, 0, square_points[1]}, "Vertice_Alineado.post.1");
  follows_text(Es_De_Malla{face_zero}, "Es_De_Malla.post.1");
}

TEST_CASE("an error of meshes holds where what it says is so, and nowhere else") {
  CHECK(denied(Malla_Ya_Existe{square_mesh}).empty());
  CHECK(denied(Malla_Ya_Existe{fresh_mesh}) == Broken{"Malla_Ya_Existe.pre.1"});
  CHECK(denied(Malla_No_Existe{fresh_mesh}).empty());
  CHECK(denied(Malla_No_Existe{square_mesh}) == Broken{"Malla_No_Existe.pre.1"});
  CHECK(denied(Cara_Incompleta{incomplete_face()}).empty());
  CHECK(denied(Cara_Incompleta{flat_face()}) == Broken{"Cara_Incompleta.pre.1"});
  CHECK(denied(Caras_Alineadas{flat_face()}).empty());
  CHECK(denied(Caras_Alineadas{incomplete_face()}) == Broken{"Caras_Alineadas.pre.1"});
  CHECK(denied(Caras_Alineadas{square()}) == Broken{"Caras_Alineadas.pre.2"});
  CHECK(denied(Cara_Sin_Nombre{endless, square()}).empty());
  CHECK(denied(Cara_Sin_Nombre{endless, flat_face()}) == Broken{"Cara_Sin_Nombre.pre.1"});
  CHECK(denied(Cara_Sin_Nombre{fresh_mesh, square()}) == Broken{"Cara_Sin_Nombre.pre.2"});
  CHECK(denied(Cara_Ya_Existe{endless, square()}).contains("Cara_Ya_Existe.pre.1"));
  CHECK(denied(Cara_Ya_Existe{square_mesh, square()}) == Broken{"Cara_Ya_Existe.pre.2"});  // they are its own
  CHECK(denied(Cara_Ya_Existe{fresh_mesh, square()}) == Broken{"Cara_Ya_Existe.pre.2"});
  Mallas s = with_square();
  apply_total(s, Agregar_Esfera{fresh_face, square_points[0], 1});
  CHECK(all_hold(judgements(s, Cara_Ya_Existe{fresh_mesh, square()}, Respuesta::elemento_ya_existe)));
  CHECK(denied(Vertice_No_Existe{square_mesh, 4}).empty());
  CHECK(denied(Vertice_No_Existe{fresh_mesh, 4}).contains("Vertice_No_Existe.pre.1"));
  CHECK(denied(Vertice_No_Existe{square_mesh, 3}) == Broken{"Vertice_No_Existe.pre.2"});
  CHECK(denied(Vertice_Alineado{square_mesh, 3, square_points[0]}).empty());
  CHECK(denied(Vertice_Alineado{fresh_mesh, 3, square_points[0]}).contains("Vertice_Alineado.pre.1"));
  CHECK(denied(Vertice_Alineado{square_mesh, 9, square_points[0]}).contains("Vertice_Alineado.pre.2"));
  CHECK(denied(Vertice_Alineado{square_mesh, 3, Punto(0, 9, 0)}) == Broken{"Vertice_Alineado.pre.3"});
  CHECK(denied(Es_De_Malla{face_one}).empty());
  CHECK(denied(Es_De_Malla{single_sphere}) == Broken{"Es_De_Malla.pre.1"});
}
