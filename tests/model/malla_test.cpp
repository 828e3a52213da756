#include "durero/model/malla.hpp"

#include <limits>

#include "durero/model/malla_clauses.hpp"
#include "durero/model/tipo/triangulo.hpp"
#include "mallas.hpp"
#include "support/catch.hpp"
#include "support/clauses.hpp"
#include "support/mallas_gen.hpp"
#include "support/property.hpp"

// A test case a schema: each precondition broken by an input, each postcondition by a spoiled after-state.

using namespace durero;
using namespace durero::model;
using namespace durero::test;

namespace {

/// The label that the operation violates on with_square(), which must stay as it was.
std::string refused(const MeshOperation& operation) {
  Mallas s = with_square();
  const std::string label = violated([&] { model::apply(s, operation); });
  CHECK(s == with_square());
  return label;
}

/// The label that sees that the after-state, or the answer, of an operation on with_square() was spoiled.
std::string spoiled(const MeshOperation& operation, const std::function<void(Mallas&, Respuesta&)>& spoil) {
  const Mallas before = with_square();
  Mallas after = before;
  Respuesta r = model::apply(after, operation);
  CHECK(broken(post(before, operation, after, r)).empty());
  spoil(after, r);
  const std::set<std::string> labels = broken(post(before, operation, after, r));
  CHECK(labels.size() == 1);
  return labels.empty() ? "none" : *labels.begin();
}

std::string answer(const MeshOperation& operation) {
  Mallas s = with_square();
  const Answer given = model::apply_total(s, operation);
  CHECK(given.ok() == (s != with_square()));
  return std::string(name(given.r)) + (given.ok() ? "" : " " + std::string(given.violated->label));
}

using Points = Red::Points;
using Faces = Red::Faces;
const Punto corner(0, 0, 0);

}  // namespace

#define SPOILED(op, change)                         \
  spoiled(op, [](Mallas& after, Respuesta& r) {     \
    static_cast<void>(after), static_cast<void>(r); \
    change;                                         \
  })

TEST_CASE("Red: points and faces are numbered from zero, without a gap") {
  CHECK(violated([] { Red(Points{{1, corner}}, Faces{}); }) == "Red.inv.1");
  CHECK(violated([] { Red(Points{{0, corner}, {2, corner}}, Faces{}); }) == "Red.inv.1");
  CHECK(violated([] { Red(Points{}, Faces{{1, {0, 0, 0}}}); }) == "Red.inv.2");
  CHECK(Red::of({corner, corner}, {{0, 1, 7}}).caras().at(0) == Cara{0, 1, 7});
  CHECK(Red(Points{}, Faces{}) == Red::of({}, {}));
}

TEST_CASE("terna.def.1: the points of a face in its order, where it names points") {
  CHECK(*terna(square(), {2, 0, 1}) == Terna{square_points[2], square_points[0], square_points[1]});
  for (const Cara& c : {Cara{4, 0, 1}, Cara{0, 4, 1}, Cara{0, 1, 4}}) CHECK_FALSE(terna(square(), c));
}

TEST_CASE("Malla: each face names points that there are, and not on one line") {
  CHECK(violated([] { Malla{incomplete_face()}; }) == "Completa.inv.1");
  CHECK(violated([] { Malla{flat_face()}; }) == "Malla.inv.1");
  CHECK(violated([] { Malla(Red::of({corner, Punto(1, 2, 3), Punto(-2, -4, -6)}, {{0, 1, 2}})); }) == "Malla.inv.1");
  CHECK(Malla(square()).red() == square());
  CHECK(Malla::contains(Red::of({}, {})));
  CHECK_FALSE(Malla::contains(incomplete_face()));
  CHECK_FALSE(is_complete(Red::of(square_points, {{0, 1, 2}, {4, 0, 1}})));
  CHECK(is_complete(flat_face()));
}

TEST_CASE("nombre_cara.def.1: no two faces have one name, and a name is no longer than a name may be") {
  CHECK(nombre_cara(square_mesh, 0) == face_zero);
  CHECK(nombre_cara(Elemento("a:1"), 2) == Elemento("a:1:2"));
  CHECK(nombre_cara(Elemento("a"), std::numeric_limits<Ordinal>::max()) == Elemento("a:4294967295"));
  const Elemento just(std::string(126, 'l'));
  CHECK(nombre_cara(just, 9)->name().size() == 128);
  CHECK_FALSE(nombre_cara(just, 10));
  CHECK_FALSE(nombre_cara(endless, 0));
  property("the name tells the mesh and the number", [] {
    const auto name = rc::gen::element(Elemento("a"), Elemento("a:1"), Elemento("a:1:1"), Elemento("a:11"));
    const auto number = rc::gen::inRange<Ordinal>(0, 12);
    const Elemento m = *name, w = *name;
    const Ordinal n = *number, k = *number;
    RC_ASSERT((nombre_cara(m, n) == nombre_cara(w, k)) == (m == w && n == k));
  });
}

TEST_CASE("familia.def.1: a triangle for each face, where the faces are those of a mesh and have names") {
  const Family family = familia(square_mesh, square()).value();
  CHECK(family.size() == 2);
  CHECK(family.at(face_one).terna() == Terna{square_points[0], square_points[2], square_points[3]});
  CHECK_FALSE(familia(square_mesh, flat_face()));
  CHECK_FALSE(familia(square_mesh, incomplete_face()));
  CHECK_FALSE(familia(endless, square()));
  CHECK(familia(endless, Red::of(square_points, {}))->empty());
}

TEST_CASE("movida.def.1: one point elsewhere, and the others and the faces as they were") {
  const Red red = movida(square(), 3, Punto(0, 4, 1)).value();
  CHECK(red.puntos().at(3) == Punto(0, 4, 1));
  CHECK(red.puntos().at(2) == square_points[2]);
  CHECK(red.caras() == square().caras());
  CHECK(red.puntos().size() == 4);
  CHECK_FALSE(movida(square(), 4, corner));
}

TEST_CASE("Mallas: the triangles of a mesh are elements") {
  const auto after = [](auto&& change) {
    Mallas s = with_square();
    change(s);
    return broken(inv(s));
  };
  using Labels = std::set<std::string>;
  CHECK(after([](Mallas&) {}).empty());
  CHECK(after([](Mallas& s) { s.mallas.emplace(endless, Malla(square())); }).contains("Mallas.inv.1"));
  CHECK(after([](Mallas& s) { s.mallas.emplace(fresh_mesh, Malla(square())); }) == Labels{"Mallas.inv.2"});
  CHECK(after([](Mallas& s) { s.escena.mi_vertices.at(face_one) = s.escena.mi_vertices.at(face_zero); }) ==
        Labels{"Mallas.inv.2"});
  CHECK(after([](Mallas& s) { s.escena.tipos.clear(); }) == Labels{"Escena.inv.7"});
  CHECK(after([](Mallas& s) { s.mallas.clear(); }).empty());
}

TEST_CASE("suyos.def.1 and de_malla.def.1: whose triangles they are") {
  Mallas s = with_square();
  CHECK(suyos(s, square_mesh) == std::set{face_zero, face_one});
  CHECK(suyos(s, loose_points).empty());
  CHECK(suyos(s, fresh_mesh).empty());
  apply(s, Agregar_Malla{fresh_mesh, half_square()});
  CHECK(de_malla(s) == std::set{face_zero, face_one, fresh_face});
}

TEST_CASE("Init_Mallas: no element and no mesh") {
  const Mallas s = Init_Mallas();
  CHECK(broken(Init_Mallas_post(s)).empty());
  CHECK(s.escena == Init());
  Mallas other = s;
  other.mallas.emplace(loose_points, Malla(Red::of({}, {})));
  CHECK(broken(Init_Mallas_post(other)) == std::set<std::string>{"Init_Mallas.post.1"});
}

TEST_CASE("Solo_Triangulos, the part of every operation on meshes") {
  const Elemento& e = face_zero;
  for (const MeshOperation& operation : std::vector<MeshOperation>{
           Agregar_Malla{fresh_mesh, square()}, Eliminar_Malla{square_mesh},
           Reemplazar_Malla{square_mesh, half_square()}, Mover_Vertice{square_mesh, 3, Punto(0, 4, 1)}}) {
    CHECK(SPOILED(operation, after.escena.mi_centro.erase(single_sphere)) == "Solo_Triangulos.post.1");
    CHECK(SPOILED(operation, after.escena.mi_radio.at(single_sphere) = Rmas(9)) == "Solo_Triangulos.post.2");
    CHECK(SPOILED(operation, after.escena.mi_vector.emplace(e, Vector(0, 0, 1))) == "Solo_Triangulos.post.3");
    CHECK(SPOILED(operation, after.escena.mi_altura.emplace(e, 1)) == "Solo_Triangulos.post.4");
    CHECK(SPOILED(operation, after.escena.mi_proporcion.emplace(e, 1)) == "Solo_Triangulos.post.5");
  }
}

TEST_CASE("Agregar_Malla") {
  const MeshOperation in = Agregar_Malla{fresh_mesh, half_square()};
  CHECK(refused(Agregar_Malla{square_mesh, half_square()}) == "Agregar_Malla.pre.1");
  CHECK(refused(Agregar_Malla{fresh_mesh, incomplete_face()}) == "Agregar_Malla.pre.2");
  CHECK(refused(Agregar_Malla{fresh_mesh, flat_face()}) == "Agregar_Malla.pre.3");
  CHECK(refused(Agregar_Malla{endless, square()}) == "Agregar_Malla.pre.4");
  Mallas s = with_square();
  apply_total(s, Agregar_Esfera{fresh_face, corner, 1});
  CHECK(violated([&] { apply(s, in); }) == "Agregar_Malla.pre.5");
  CHECK(SPOILED(in, after.escena.elementos.erase(fresh_face)) == "Agregar_Malla.post.1");
  CHECK(SPOILED(in, after.escena.elementos.erase(face_zero)) == "Agregar_Malla.post.1");
  CHECK(SPOILED(in, after.escena.de_que_tipo.at(fresh_face) = Tipo::soy_plano) == "Agregar_Malla.post.2");
  CHECK(SPOILED(in, after.escena.de_que_tipo.erase(single_sphere)) == "Agregar_Malla.post.2");
  CHECK(SPOILED(in, after.escena.de_que_tipo.emplace(endless, Tipo::soy_plano)) == "Agregar_Malla.post.2");
  CHECK(SPOILED(in, after.escena.mi_vertices.at(fresh_face) = after.escena.mi_vertices.at(face_one)) ==
        "Agregar_Malla.post.3");
  CHECK(SPOILED(in, after.escena.mi_vertices.erase(face_zero)) == "Agregar_Malla.post.3");
  CHECK(SPOILED(in, after.mallas.erase(fresh_mesh)) == "Agregar_Malla.post.4");
  CHECK(SPOILED(in, after.mallas.at(fresh_mesh) = Malla(square())) == "Agregar_Malla.post.4");
  CHECK(SPOILED(in, after.mallas.erase(loose_points)) == "Agregar_Malla.post.4");
  CHECK(SPOILED(in, r = Respuesta::malla_eliminada) == "Agregar_Malla.post.5");
}

TEST_CASE("Eliminar_Malla") {
  const MeshOperation in = Eliminar_Malla{square_mesh};
  CHECK(refused(Eliminar_Malla{fresh_mesh}) == "Eliminar_Malla.pre.1");
  CHECK(SPOILED(in, after.escena.elementos.insert(face_one)) == "Eliminar_Malla.post.1");
  CHECK(SPOILED(in, after.escena.elementos.erase(single_sphere)) == "Eliminar_Malla.post.1");
  CHECK(SPOILED(in, after.escena.de_que_tipo.emplace(face_one, Tipo::soy_triangulo)) == "Eliminar_Malla.post.2");
  CHECK(SPOILED(in, after.escena.de_que_tipo.clear()) == "Eliminar_Malla.post.2");
  CHECK(SPOILED(in, after.escena.mi_vertices.emplace(face_one, Terna{square_points[0], square_points[1],
                                                                     square_points[2]})) == "Eliminar_Malla.post.3");
  CHECK(SPOILED(in, after.mallas.emplace(square_mesh, Malla(square()))) == "Eliminar_Malla.post.4");
  CHECK(SPOILED(in, after.mallas.clear()) == "Eliminar_Malla.post.4");
  CHECK(SPOILED(in, r = Respuesta::elemento_eliminado) == "Eliminar_Malla.post.5");
}

TEST_CASE("Reemplazar_Malla") {
  const MeshOperation in = Reemplazar_Malla{square_mesh, half_square()};
  CHECK(refused(Reemplazar_Malla{fresh_mesh, square()}) == "Reemplazar_Malla.pre.1");
  CHECK(refused(Reemplazar_Malla{square_mesh, incomplete_face()}) == "Reemplazar_Malla.pre.2");
  CHECK(refused(Reemplazar_Malla{square_mesh, flat_face()}) == "Reemplazar_Malla.pre.3");
  Mallas s = with_square();
  apply(s, Agregar_Malla{endless, Red::of({}, {})});
  CHECK(violated([&] { apply(s, Reemplazar_Malla{endless, square()}); }) == "Reemplazar_Malla.pre.4");
  // The name of a face that the mesh does not have yet is in use.
  apply_total(s, Agregar_Esfera{Elemento("w:1"), corner, 1});
  CHECK(violated([&] { apply(s, Reemplazar_Malla{loose_points, square()}); }) == "Reemplazar_Malla.pre.5");
  CHECK(apply(s, Reemplazar_Malla{loose_points, half_square()}) == Respuesta::malla_reemplazada);
  CHECK(SPOILED(in, after.escena.elementos.insert(face_one)) == "Reemplazar_Malla.post.1");
  CHECK(SPOILED(in, after.escena.elementos.erase(face_zero)) == "Reemplazar_Malla.post.1");
  CHECK(SPOILED(in, after.escena.de_que_tipo.emplace(face_one, Tipo::soy_triangulo)) == "Reemplazar_Malla.post.2");
  CHECK(SPOILED(in, after.escena.de_que_tipo.at(face_zero) = Tipo::soy_plano) == "Reemplazar_Malla.post.2");
  CHECK(SPOILED(in, after.escena.mi_vertices.erase(face_zero)) == "Reemplazar_Malla.post.3");
  CHECK(SPOILED(in, after.mallas.at(square_mesh) = Malla(square())) == "Reemplazar_Malla.post.4");
  CHECK(SPOILED(in, after.mallas.erase(loose_points)) == "Reemplazar_Malla.post.4");
  CHECK(SPOILED(in, r = Respuesta::malla_agregada) == "Reemplazar_Malla.post.5");
}

TEST_CASE("Mover_Vertice: every face that has the vertex follows it") {
  const MeshOperation in = Mover_Vertice{square_mesh, 2, Punto(5, 5, 1)};
  CHECK(refused(Mover_Vertice{fresh_mesh, 2, corner}) == "Mover_Vertice.pre.1");
  CHECK(refused(Mover_Vertice{square_mesh, 4, corner}) == "Mover_Vertice.pre.2");
  CHECK(refused(Mover_Vertice{square_mesh, 2, Punto(2, 0, 0)}) == "Mover_Vertice.pre.3");
  CHECK(SPOILED(in, after.escena.elementos.erase(face_zero)) == "Mover_Vertice.post.1");
  CHECK(SPOILED(in, after.escena.de_que_tipo.erase(face_zero)) == "Mover_Vertice.post.2");
  CHECK(SPOILED(in, after.escena.mi_vertices = with_square().escena.mi_vertices) == "Mover_Vertice.post.3");
  CHECK(SPOILED(in, after.mallas.at(square_mesh) = Malla(square())) == "Mover_Vertice.post.4");
  CHECK(SPOILED(in, after.mallas.erase(loose_points)) == "Mover_Vertice.post.4");
  CHECK(SPOILED(in, r = Respuesta::malla_reemplazada) == "Mover_Vertice.post.5");
  Mallas s = with_square();
  apply(s, in);
  for (const Elemento& e : {face_zero, face_one}) {
    const Terna& v = s.escena.mi_vertices.at(e).terna();
    CHECK((v.b == Punto(5, 5, 1) || v.c == Punto(5, 5, 1)));
    CHECK(v.a == corner);
  }
}

TEST_CASE("the total operations answer the first error of the text") {
  // Agregar_Malla_Total.def.1
  CHECK(answer(Agregar_Malla{fresh_mesh, square()}) == "malla_agregada");
  CHECK(answer(Agregar_Malla{square_mesh, incomplete_face()}) == "malla_ya_existe Agregar_Malla.pre.1");
  CHECK(answer(Agregar_Malla{endless, incomplete_face()}) == "cara_incompleta Agregar_Malla.pre.2");
  CHECK(answer(Agregar_Malla{endless, flat_face()}) == "vertices_alineados Agregar_Malla.pre.3");
  CHECK(answer(Agregar_Malla{endless, square()}) == "cara_sin_nombre Agregar_Malla.pre.4");
  Mallas s = with_square();
  apply_total(s, Agregar_Esfera{fresh_face, corner, 1});
  CHECK(apply_total(s, Agregar_Malla{fresh_mesh, square()}).r == Respuesta::elemento_ya_existe);
  // Eliminar_Malla_Total.def.1
  CHECK(answer(Eliminar_Malla{square_mesh}) == "malla_eliminada");
  CHECK(answer(Eliminar_Malla{fresh_mesh}) == "malla_no_existe Eliminar_Malla.pre.1");
  // Reemplazar_Malla_Total.def.1
  CHECK(answer(Reemplazar_Malla{square_mesh, half_square()}) == "malla_reemplazada");
  CHECK(answer(Reemplazar_Malla{fresh_mesh, incomplete_face()}) == "malla_no_existe Reemplazar_Malla.pre.1");
  CHECK(answer(Reemplazar_Malla{square_mesh, incomplete_face()}) == "cara_incompleta Reemplazar_Malla.pre.2");
  CHECK(answer(Reemplazar_Malla{square_mesh, flat_face()}) == "vertices_alineados Reemplazar_Malla.pre.3");
  apply(s, Agregar_Malla{endless, Red::of({}, {})});
  CHECK(apply_total(s, Reemplazar_Malla{endless, square()}).r == Respuesta::cara_sin_nombre);
  apply_total(s, Agregar_Esfera{Elemento("w:0"), corner, 1});
  CHECK(apply_total(s, Reemplazar_Malla{loose_points, square()}).violated->label == "Reemplazar_Malla.pre.5");
  // Mover_Vertice_Total.def.1
  CHECK(answer(Mover_Vertice{square_mesh, 3, Punto(0, 9, 0)}) == "vertice_movido");
  CHECK(answer(Mover_Vertice{fresh_mesh, 9, corner}) == "malla_no_existe Mover_Vertice.pre.1");
  CHECK(answer(Mover_Vertice{square_mesh, 9, corner}) == "vertice_no_existe Mover_Vertice.pre.2");
  CHECK(answer(Mover_Vertice{square_mesh, 3, corner}) == "vertices_alineados Mover_Vertice.pre.3");
}

TEST_CASE("single elements are edited beside meshes, and no triangle of a mesh is removed alone") {
  const Elemento other("other");
  const Vector up(0, 0, 1);
  const Terna corners{corner, Punto(1, 0, 0), Punto(0, 1, 0)};
  const std::vector<std::pair<std::string, Operation>> additions{
      {"Agregar_Esfera_Mallas.def.1", Agregar_Esfera{other, corner, 1}},
      {"Agregar_Cilindro_Mallas.def.1", Agregar_Cilindro{other, corner, 1, up, 2}},
      {"Agregar_Cono_Mallas.def.1", Agregar_Cono{other, corner, 1, up, 2}},
      {"Agregar_Tronco_Mallas.def.1", Agregar_Tronco{other, corner, 1, 2, up, 2}},
      {"Agregar_Plano_Mallas.def.1", Agregar_Plano{other, corner, up}},
      {"Agregar_Disco_Mallas.def.1", Agregar_Disco{other, corner, 1, up}},
      {"Agregar_Triangulo_Mallas.def.1", Agregar_Triangulo{other, corners}},
      {"Agregar_Elemento_Mallas.def.1", Agregar_Elemento{other, Tipo::soy_esfera, corner, 1}}};
  const auto removals = [](const Elemento& e) {
    return std::vector<std::pair<std::string, Operation>>{{"Eliminar_Esfera_Mallas.def.1", Eliminar_Esfera{e}},
                                                          {"Eliminar_Cilindro_Mallas.def.1", Eliminar_Cilindro{e}},
                                                          {"Eliminar_Cono_Mallas.def.1", Eliminar_Cono{e}},
                                                          {"Eliminar_Tronco_Mallas.def.1", Eliminar_Tronco{e}},
                                                          {"Eliminar_Plano_Mallas.def.1", Eliminar_Plano{e}},
                                                          {"Eliminar_Disco_Mallas.def.1", Eliminar_Disco{e}},
                                                          {"Eliminar_Triangulo_Mallas.def.1", Eliminar_Triangulo{e}},
                                                          {"Eliminar_Elemento_Mallas.def.1", Eliminar_Elemento{e}}};
  };
  for (const auto& [label, operation] : additions) {
    INFO(label);
    Mallas s = with_square();
    Escena alone = s.escena;
    CHECK(apply_total(s, operation) == apply_total(alone, operation));
    CHECK(s.escena == alone);
    CHECK(s.mallas == with_square().mallas);  // Mismas_Mallas.post.1
    for (const auto& [other_label, removal] : removals(other)) {
      INFO(other_label);
      Mallas less = s;
      Escena less_alone = alone;
      CHECK(apply_total(less, removal) == apply_total(less_alone, removal));
      CHECK(less.escena == less_alone);
    }
  }
  for (const auto& [label, removal] : removals(face_zero)) {
    INFO(label);
    Mallas s = with_square();
    const Answer answer = apply_total(s, removal);
    CHECK(answer.r == Respuesta::es_de_malla);
    CHECK(answer.violated->label == "Fuera_De_Malla.pre.1");
    CHECK(s == with_square());
  }
  // A face that the mesh no longer has is an element like another.
  Mallas s = with_square();
  apply(s, Eliminar_Malla{square_mesh});
  CHECK(apply_total(s, Agregar_Triangulo{face_zero, corners}).ok());
  CHECK(apply_total(s, Eliminar_Triangulo{face_zero}).ok());
}

TEST_CASE("meshes in random scenes") {
  property("every state that is reached satisfies the invariant", [] {
    const Mallas s = any_scene_with_meshes();
    RC_CLASSIFY(!de_malla(s).empty(), "with triangles");
    RC_ASSERT(broken(inv(s)).empty());
  });
  property("a total operation does what the partial one does, and answers the clause that it breaks", [] {
    Mallas s = any_scene_with_meshes(), t = s;
    const Mallas before = s;
    const MeshOperation operation = *any_mesh_operation();
    const Answer answer = apply_total(s, operation);
    const std::string label = violated([&] { apply(t, operation); });
    RC_CLASSIFY(answer.ok(), "done");
    RC_ASSERT(label == (answer.ok() ? "none" : std::string(answer.violated->label)));
    RC_ASSERT(s == t);
    if (!answer.ok()) RC_ASSERT(s == before);
  });
  property("triangles of different meshes have different names, and each is a triangle: suyos and de_malla", [] {
    const Mallas s = any_scene_with_meshes();
    std::size_t count = 0;
    for (const auto& [m, malla] : s.mallas) count += suyos(s, m).size();
    RC_ASSERT(count == de_malla(s).size());
    for (const Elemento& e : de_malla(s)) RC_ASSERT(is_of_type(s.escena, e, Tipo::soy_triangulo));
  });
  property("a mesh that was added and removed leaves the scene as it was", [] {
    Mallas s = any_scene_with_meshes();
    const Mallas before = s;
    const Elemento m = *any_mesh_name();
    RC_PRE(apply_total(s, Agregar_Malla{m, *any_mesh()}).ok());
    RC_ASSERT(apply(s, Eliminar_Malla{m}) == Respuesta::malla_eliminada);
    RC_ASSERT(s == before);
  });
  property("to replace a mesh is to remove it and to add the other", [] {
    Mallas s = any_scene_with_meshes(), t = s;
    const Elemento m = *any_mesh_name();
    const Red red = *any_mesh();
    const bool done = apply_total(s, Reemplazar_Malla{m, red}).ok();
    RC_ASSERT(done == (apply_total(t, Eliminar_Malla{m}).ok() && apply_total(t, Agregar_Malla{m, red}).ok()));
    if (done) RC_ASSERT(s == t);
  });
  property("to move a vertex is to replace the mesh by the moved one", [] {
    Mallas s = any_scene_with_meshes();
    apply_total(s, Agregar_Malla{Elemento("k"), *any_mesh()});
    Mallas t = s;
    const auto [m, malla] = *s.mallas.begin();
    const Ordinal n = *rc::gen::inRange<Ordinal>(0, 5);
    const Punto p = *any_grid_point();
    const auto red = movida(malla.red(), n, p);
    RC_PRE(red.has_value());
    RC_ASSERT(apply_total(s, Mover_Vertice{m, n, p}).ok() == apply_total(t, Reemplazar_Malla{m, *red}).ok());
    RC_ASSERT(s == t);
  });
}

TEST_CASE("sueltas.def.1: the elements that are of no mesh") {
  const Mallas s = with_square();
  CHECK(sueltas(s).elementos == std::set{single_sphere});
  CHECK(sueltas(s).tipos == std::set{Tipo::soy_esfera});
  CHECK(sueltas(s).mi_vertices.empty());
  property("they are a scene, which no operation on meshes changes", [] {
    Mallas t = any_scene_with_meshes();
    const Escena before = sueltas(t);
    RC_ASSERT(broken(inv(before)).empty());
    apply_total(t, *any_mesh_operation());
    RC_ASSERT(sueltas(t) == before);
  });
}

TEST_CASE("giro.def.1, cruce.def.1 and recta.def.1: numbers that one can see") {
  const Rayo up(Punto(0, 0, -5), Vector(0, 0, 1));
  CHECK(giro(up, Punto(1, 0, 0), Punto(1, 1, 0)) == Surd(1));
  CHECK(giro(up, Punto(1, 1, 0), Punto(1, 0, 0)) == Surd(-1));
  CHECK(giro(up, Punto(1, 0, 3), Punto(2, 0, 7)) == Surd(0));
  const Terna v{Punto(-1, -1, 0), Punto(3, -1, 2), Punto(-1, 3, 1)};
  CHECK(cruce(up, v) == Surd(16));
  CHECK(cruce(Rayo(Punto(0, 0, 1), Vector(2, 0, 1)), v) == Surd(0));
  CHECK(recta(up).contains(ExactPoint(Punto(0, 0, -7))));
  CHECK(recta(up).contains(ExactPoint(Punto(0, 0, -5))));
  CHECK_FALSE(recta(up).contains(ExactPoint(Punto(0, 1, 0))));
}

namespace {

/// Whether the line of a ray meets a triangle that it is not parallel to, by the points of the text.
bool line_meets(const Rayo& rayo, const Terna& v) {
  const Surd from = potencia_triangulo(rayo.p(), v);
  const Surd slope = potencia_triangulo(along(rayo.p(), rayo.v(), 1), v) - from;
  return puntos_triangulo(v).contains(along(rayo.p(), rayo.v(), -from / slope));
}

bool all_of_one_sign(const Rayo& rayo, const Terna& v) {
  const Surd ab = giro(rayo, v.a, v.b), bc = giro(rayo, v.b, v.c), ca = giro(rayo, v.c, v.a);
  return (ab >= 0 && bc >= 0 && ca >= 0) || (ab <= 0 && bc <= 0 && ca <= 0);
}

/// A ray from one point of the grid towards another, from outside or from among them.
Rayo grid_ray() {
  const Punto p = *any_grid_point(), q = *any_grid_point();
  const double back = *rc::gen::element(0.0, 1.0, 3.0);
  RC_PRE(!(p == q));
  const Vector v(q.xyz() - p.xyz());
  return {Punto(p.xyz() - back * v.xyz()), v};
}

Terna grid_triangle(const Punto& a, const Punto& b) {
  Terna v{a, b, *any_grid_point()};
  RC_PRE(Vertices::contains(v));
  return v;
}

}  // namespace

TEST_CASE("Vecinos.def.1: two triangles, whose first edge is one and goes the other way") {
  const Terna v{Punto(0, 0, 0), Punto(4, 0, 0), Punto(4, 4, 0)}, w{Punto(4, 0, 0), Punto(0, 0, 0), Punto(0, -4, 0)};
  CHECK(are_neighbours(v, w));
  CHECK(are_neighbours(w, v));
  CHECK_FALSE(are_neighbours(v, v));
  CHECK_FALSE(are_neighbours(v, {w.a, w.b, Punto(2, 0, 0)}));
  CHECK_FALSE(are_neighbours({v.a, v.b, Punto(2, 0, 0)}, w));
  CHECK_FALSE(are_neighbours(v, {w.a, w.c, w.b}));
  CHECK_FALSE(are_neighbours(v, {w.c, w.b, w.a}));
}

TEST_CASE("three signs decide, and no line passes between two triangles that share an edge") {
  property("for triangles and rays of the grid", [] {
    const Punto a = *any_grid_point(), b = *any_grid_point();
    const Terna v = grid_triangle(a, b), w = grid_triangle(b, a);
    const Rayo rayo = grid_ray();
    RC_ASSERT(are_neighbours(v, w));
    RC_PRE(cruce(rayo, v) != 0 && cruce(rayo, w) != 0);
    RC_ASSERT(giro(rayo, a, b) + giro(rayo, b, a) == Surd(0));
    const bool first = line_meets(rayo, v), second = line_meets(rayo, w);
    RC_ASSERT(first == all_of_one_sign(rayo, v));
    RC_ASSERT(second == all_of_one_sign(rayo, w));
    const Surd bc = giro(rayo, v.b, v.c), ca = giro(rayo, v.c, v.a), ad = giro(rayo, w.b, w.c),
               db = giro(rayo, w.c, w.a);
    const bool inside = (bc >= 0 && ca >= 0 && ad >= 0 && db >= 0) || (bc <= 0 && ca <= 0 && ad <= 0 && db <= 0);
    RC_CLASSIFY(inside, "between the outer edges");
    if (inside) RC_ASSERT(first || second);
    RC_CLASSIFY(first && giro(rayo, a, b) == 0, "on the common edge");
    if (first && giro(rayo, a, b) == 0) RC_ASSERT(second);
  });
}
