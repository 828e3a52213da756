#include "durero/scene/scene.hpp"

#include <bit>
#include <cmath>
#include <stdexcept>
#include <string>
#include <tuple>
#include <utility>

#include "durero/model/cambio.hpp"
#include "durero/model/operaciones_clauses.hpp"
#include "durero/scene/attributes.hpp"
#include "durero/scene/groups.hpp"
#include "durero/scene/retrieve.hpp"
#include "durero/scene/stage.hpp"
#include "support/catch.hpp"
#include "support/clauses.hpp"
#include "support/failing_new.hpp"
#include "support/model_gen.hpp"
#include "support/property.hpp"

using namespace durero;
using namespace durero::model;
using namespace durero::test;
using contract::cost;
using contract::evaluation_semantic;
using contract::scoped_semantic;
using scene::ElementRef;
using scene::GroupEdit;
using scene::Grouping;
using scene::Groups;
using scene::Scene;
using scene::Ungrouping;

namespace {

const Punto origin(0, 0, 0);
const Vector axis(0, 0, 1);

/// Everything that can be seen of a scene, row by row.
auto picture(const Scene& scene) {
  std::vector<std::tuple<ElementRef, std::string, std::vector<double>, std::optional<std::uint32_t>>> rows;
  scene.for_each([&]<class Shape>(ElementRef element, const Shape& shape) {
    std::vector<double> numbers;
    const auto add = [&](const auto& value) {
      if constexpr (requires { value.x; })
        numbers.insert(numbers.end(), {value.x, value.y, value.z});
      else if constexpr (requires { value.size(); })
        for (const glm::dvec3& point : value) numbers.insert(numbers.end(), {point.x, point.y, point.z});
      else
        numbers.push_back(value);
    };
    durero::scene::for_each_attribute<Shape>([&](const auto& attribute) { add(shape.*attribute.field); });
    rows.emplace_back(element, scene.name(element).name(), std::move(numbers), scene.material(element));
  });
  return rows;
}

/// Whether the index finds every row by its name, and no other name.
bool index_is_sound(const Scene& scene) {
  const auto rows = picture(scene);
  for (const auto& [element, name, numbers, material] : rows)
    if (scene.find(name) != element) return false;
  return scene.size() == rows.size() && !scene.find("no-such-name") && !scene.find("");
}

Scene scene_after(const std::vector<Operation>& operations) {
  Scene scene;
  for (const Operation& operation : operations) scene.apply_total(operation);
  return scene;
}

/// Lets a broken precondition pass, so that the operation goes on to break its postcondition.
void throw_at_postconditions(const contract::contract_violation& violation) {
  if (violation.kind() == contract::kind::postcondition) throw contract::contract_violation(violation);
}

/// Two elements of each type, the first of each with a material.
Scene two_of_each() {
  Scene scene;
  scene.stage().materials = {{"blue", {0, 0, 1}}, {"red", {1, 0, 0}}};
  for (const std::string suffix : {"1", "2"}) {
    scene.apply(Agregar_Esfera{Elemento("esfera" + suffix), origin, 1});
    scene.apply(Agregar_Cilindro{Elemento("cilindro" + suffix), origin, 1, axis, 3});
    scene.apply(Agregar_Cono{Elemento("cono-of-a-longer-name" + suffix), origin, 0.5, axis, 3});
    scene.apply(Agregar_Tronco{Elemento("tronco" + suffix), origin, 1, 0.5, axis, 3});
    scene.apply(Agregar_Plano{Elemento("plano" + suffix), origin, axis});
    scene.apply(Agregar_Disco{Elemento("disco" + suffix), origin, 1, axis});
    scene.apply(Agregar_Triangulo{Elemento("triangulo" + suffix), {origin, {1, 0, 0}, {0, 1, 0}}});
  }
  for (std::size_t t = 0; t < durero::scene::shape_count; ++t) scene.set_material({Tipo(t), 0}, 1);
  return scene;
}

}  // namespace

TEST_CASE("an element is added, found, and removed") {
  Scene scene;
  CHECK(scene.apply(Agregar_Esfera{Elemento("a"), Punto(0, 0, 5), 1}) == Respuesta::esfera_agregada);
  CHECK(scene.apply(Agregar_Cilindro{Elemento("b"), Punto(0, 0, 5), 1, axis, 2}) == Respuesta::cilindro_agregado);
  CHECK(scene.apply(Agregar_Esfera{Elemento("c"), Punto(1, 0, 5), 2}) == Respuesta::esfera_agregada);
  CHECK(scene.size() == 3);
  REQUIRE(scene.find("c"));
  CHECK(scene.name(*scene.find("c")) == Elemento("c"));
  CHECK_FALSE(scene.find("d"));

  CHECK(scene.apply_total(Eliminar_Elemento{Elemento("a")}).r == Respuesta::elemento_eliminado);
  REQUIRE(scene.find("c"));
  CHECK(scene.shapes<scene::Sphere>()[scene.find("c")->index].radio == 2);
  const Answer refused = scene.apply_total(Eliminar_Esfera{Elemento("b")});
  CHECK(refused.r == Respuesta::tipo_incorrecto);
  REQUIRE(refused.violated);
  CHECK(refused.violated->label == "Eliminar_Esfera.pre.1");
}

TEST_CASE("a material stays with its element") {
  Scene scene = two_of_each();
  CHECK(scene.material(*scene.find("esfera1")) == 1);
  CHECK(scene.material(*scene.find("esfera2")) == std::nullopt);
  scene.set_material(*scene.find("esfera2"), 0);
  scene.apply(Eliminar_Esfera{Elemento("esfera1")});
  CHECK(scene.material(*scene.find("esfera2")) == 0);
  scene.set_material(*scene.find("esfera2"), std::nullopt);
  CHECK(scene.material(*scene.find("esfera2")) == std::nullopt);
  CHECK_THROWS_AS(scene.set_material(*scene.find("esfera2"), 2), std::out_of_range);

  scene.apply(Eliminar_Cono{Elemento("cono-of-a-longer-name1")});
  scene.apply(Agregar_Cono{Elemento("cono-of-a-longer-name1"), origin, 1, axis, 1});
  CHECK(scene.material(*scene.find("cono-of-a-longer-name1")) == std::nullopt);
}

TEST_CASE("every operation commutes with the model's") {
  for (const auto audit : {evaluation_semantic::ignore, evaluation_semantic::enforce}) {
    const scoped_semantic scope(cost::audit, audit);
    const std::string how = audit == evaluation_semantic::enforce ? ", audited" : "";

    property("total operations: the same answer, the same clause, the same scene" + how, [] {
      Escena escena = Init();
      Scene scene;
      for (const Operation& operation : *any_operations()) {
        const Answer expected = model::apply_total(escena, operation);
        const Answer answer = scene.apply_total(operation);
        RC_ASSERT(answer == expected);
        RC_ASSERT(retrieve(scene) == escena);
      }
      RC_ASSERT(index_is_sound(scene));
    });

    property("partial operations: the same answer or the same violation, the same scene" + how, [] {
      Escena escena = Init();
      Scene scene;
      for (const Operation& operation : *any_operations()) {
        std::optional<Respuesta> expected, answer;
        const std::string label = violated([&] { expected = model::apply(escena, operation); });
        RC_ASSERT(violated([&] { answer = scene.apply(operation); }) == label);
        RC_ASSERT(answer == expected);
        RC_ASSERT(retrieve(scene) == escena);
      }
      RC_ASSERT(index_is_sound(scene));
    });
  }
}

TEST_CASE("every change of an attribute commutes with the model's") {
  for (const auto audit : {evaluation_semantic::ignore, evaluation_semantic::enforce}) {
    const scoped_semantic scope(cost::audit, audit);
    const std::string how = audit == evaluation_semantic::enforce ? ", audited" : "";
    property("partial and total: the same answer or violation, the same scene, the same rows" + how, [] {
      Scene scene = scene_after(*any_operations());
      for (int i = 0; i < 4; ++i) {
        const Elemento e = *any_element();
        const auto of_type =
            *rc::gen::element<std::optional<Tipo>>(std::nullopt, std::nullopt, Tipo::soy_esfera, Tipo::soy_tronco);
        const double number = *any_real();
        const AttributeChange change = *rc::gen::element<AttributeChange>(
            Cambiar_Centro{e, Punto(1, 2, 3), of_type}, Cambiar_Radio{e, number, of_type},
            Cambiar_Vector{e, *any_vector(), of_type}, Cambiar_Vector{e, *any_axis(), of_type},
            Cambiar_Altura{e, number, of_type}, Cambiar_Proporcion{e, number, of_type},
            Cambiar_Vertices{e, *any_terna(), of_type});
        Escena escena = retrieve(scene), partial = escena;
        Scene other = scene;
        const Answer expected = model::apply_total(escena, change);
        const std::string label = violated([&] { model::apply(partial, change); });
        RC_ASSERT(scene.change_total(change) == expected);
        RC_ASSERT(violated([&] { other.change(change); }) == label);
        RC_ASSERT(retrieve(scene) == escena);
        RC_ASSERT(picture(scene) == picture(other));
        RC_CLASSIFY(expected.ok(), "done");
      }
      RC_ASSERT(index_is_sound(scene));
    });
  }
}

TEST_CASE("an element that is changed keeps its row, its name and its material") {
  Scene scene = two_of_each();
  const ElementRef place = *scene.find("disco1");
  CHECK(scene.change(Cambiar_Radio{Elemento("disco1"), 4, Tipo::soy_disco}) == Respuesta::elemento_cambiado);
  CHECK(scene.find("disco1") == place);
  CHECK(scene.material(place) == 1);
  CHECK(scene.shapes<durero::scene::Disc>()[place.index].radio == 4);
}

TEST_CASE("a change that is refused, or whose postcondition is broken, leaves every row as it was") {
  Scene scene = two_of_each();
  const auto before = picture(scene);
  CHECK(scene.change_total(Cambiar_Altura{Elemento("cono-of-a-longer-name1"), 0}).violated == &Cambiar_Altura_pre_2);
  CHECK(violated([&] { scene.change(Cambiar_Radio{Elemento("plano1"), 2}); }) == "Cambiar_Radio.pre.1");
  CHECK(picture(scene) == before);

  const auto handler = contract::set_violation_handler(throw_at_postconditions);
  const scoped_semantic observed(cost::normal, evaluation_semantic::observe);
  CHECK(violated([&] { scene.change(Cambiar_Radio{Elemento("esfera1"), NAN}); }) == "Cambiar_Radio.post.1");
  contract::set_violation_handler(handler);
  const scoped_semantic ignored(cost::normal, evaluation_semantic::ignore);
  const scoped_semantic audited(cost::audit, evaluation_semantic::enforce);
  CHECK(violated([&] { scene.change(Cambiar_Radio{Elemento("esfera1"), -1}); }) == "Rmas.inv.1");
  CHECK(violated([&] { scene.change(Cambiar_Radio{Elemento("nobody"), 1}); }) == "Cambiar_Elemento.pre.1");
  CHECK(picture(scene) == before);
}

TEST_CASE("the type that an addition is given is looked at by the partial operation alone") {
  const Operation wrong = Agregar_Esfera{Elemento("a"), origin, 1, Tipo::soy_cono};
  Scene scene;
  CHECK(violated([&] { scene.apply(wrong); }) == "Agregar_Esfera.pre.1");
  CHECK(scene.size() == 0);
  CHECK(scene.apply_total(wrong).ok());
  CHECK(scene.find("a") == ElementRef{Tipo::soy_esfera, 0});
}

TEST_CASE("an attribute that the type has and that is absent is no operation") {
  Scene scene;
  CHECK_THROWS_AS(scene.apply(Agregar_Elemento{Elemento("a"), Tipo::soy_esfera, origin}), std::invalid_argument);
  CHECK_THROWS_AS(scene.apply_total(Agregar_Elemento{Elemento("a"), Tipo::soy_cono, origin}), std::invalid_argument);
  CHECK(scene.size() == 0);
}

TEST_CASE("a refused operation leaves every row where it was") {
  property("rows, names, materials", [] {
    Scene scene = scene_after(*any_operations());
    const auto before = picture(scene);
    const Operation operation = *any_operation();
    RC_PRE(violated([&] { scene.apply(operation); }) != "none");
    RC_ASSERT(picture(scene) == before);
    const bool done = scene.apply_total(operation).ok();  // where only t? was wrong
    RC_ASSERT((picture(scene) != before) == done);
    RC_ASSERT(index_is_sound(scene));
  });
}

TEST_CASE("a broken postcondition undoes the edit, row by row") {
  const auto handler = contract::set_violation_handler(throw_at_postconditions);
  const auto seen = [](cost price, const Operation& operation) {
    const scoped_semantic pre_observed(cost::normal, evaluation_semantic::observe);
    const scoped_semantic audit(cost::audit,
                                price == cost::audit ? evaluation_semantic::observe : evaluation_semantic::ignore);
    Scene scene = two_of_each();
    const auto before = picture(scene);
    const std::string label = violated([&] { scene.apply(operation); });
    CHECK(picture(scene) == before);
    CHECK(index_is_sound(scene));
    return label;
  };
  // NaN is stored, and is not equal to what was asked for.
  CHECK(seen(cost::normal, Agregar_Esfera{Elemento("new"), origin, NAN}) == "Agregar_Esfera.post.2");
  CHECK(seen(cost::normal, Agregar_Cilindro{Elemento("new"), origin, NAN, axis, 1}) == "Agregar_Cilindro.post.2");
  CHECK(seen(cost::normal, Agregar_Cono{Elemento("new"), origin, 1, axis, NAN}) == "Agregar_Cono.post.4");
  // A name that is there already: the index goes on finding the old row.
  CHECK(seen(cost::normal, Agregar_Esfera{Elemento("cilindro1"), origin, 1}) == "Agregar_Elemento.post.1");
  // The wrong type: it is the cylinders that lose an element, first of them or last.
  CHECK(seen(cost::normal, Eliminar_Esfera{Elemento("cilindro1")}) == "Eliminar_Esfera.post.3");
  CHECK(seen(cost::normal, Eliminar_Esfera{Elemento("cilindro2")}) == "Eliminar_Esfera.post.3");
  CHECK(seen(cost::normal, Eliminar_Cono{Elemento("esfera1")}) == "Eliminar_Cono.post.2");
  CHECK(seen(cost::normal, Eliminar_Cilindro{Elemento("cono-of-a-longer-name1")}) == "Eliminar_Cilindro.post.2");
  contract::set_violation_handler(handler);
}

TEST_CASE("an audit that fails undoes the edit") {
  // The whole predicates need a scene: a radius outside Rmas has none, so retrieving the after-state throws.
  const scoped_semantic ignored(cost::normal, evaluation_semantic::ignore);
  const scoped_semantic audited(cost::audit, evaluation_semantic::enforce);
  Scene scene = two_of_each();
  const auto before = picture(scene);
  CHECK(violated([&] { scene.apply(Agregar_Esfera{Elemento("new"), origin, -1}); }) == "Rmas.inv.1");
  CHECK(violated([&] { scene.apply(Agregar_Cono{Elemento("new"), origin, 1, Vector(0, 1, 1), 1}); }) == "Escena.inv.8");
  CHECK(violated([&] { scene.apply(Eliminar_Esfera{Elemento("cilindro1")}); }) == "Eliminar_Esfera.post.3");
  CHECK(violated([&] { scene.apply(Eliminar_Esfera{Elemento("nobody")}); }) == "Eliminar_Elemento.pre.1");
  CHECK(picture(scene) == before);
  CHECK(index_is_sound(scene));
}

TEST_CASE("an edit for which memory runs out changes nothing") {
  Scene full;  // of exactly as many rows as fit, so that the next makes every table and the index grow
  for (int i = 0; i < 16; ++i) {
    const std::string number = std::to_string(i);
    full.apply(Agregar_Esfera{Elemento("s" + number), origin, 1});
    full.apply(Agregar_Cilindro{Elemento("c" + number), origin, 1, axis, 1});
    full.apply(Agregar_Cono{Elemento("a-cone-of-a-long-name-" + number), origin, 1, axis, 1});
  }
  for (int i = 16; full.size() < 64; ++i) full.apply(Agregar_Esfera{Elemento("s" + std::to_string(i)), origin, 1});
  const Elemento nuevo("an-element-of-a-long-name");
  for (const auto semantic : {evaluation_semantic::ignore, evaluation_semantic::enforce}) {
    const scoped_semantic audited(cost::audit, semantic);
    for (const Operation& operation :
         {Operation(Agregar_Esfera{nuevo, origin, 2}), Operation(Agregar_Cilindro{nuevo, origin, 2, axis, 5}),
          Operation(Agregar_Cono{nuevo, origin, 2, axis, 5}), Operation(Agregar_Tronco{nuevo, origin, 3, 2, axis, 5}),
          Operation(Agregar_Elemento{nuevo, Tipo::soy_cilindro, origin, 2, axis, 5}),
          Operation(Eliminar_Esfera{Elemento("s0")}), Operation(Eliminar_Elemento{Elemento("c15")}),
          Operation(Eliminar_Cono{Elemento("a-cone-of-a-long-name-3")})}) {
      Scene scene = full, expected = full;
      const auto before = picture(scene);
      const bool removes = operation.index() > tipo_count;
      REQUIRE(expected.apply_total(operation).ok());
      const long allocations = fail_every_allocation([&] { scene.apply(operation); },
                                                     [&] {
                                                       REQUIRE(picture(scene) == before);
                                                       REQUIRE(index_is_sound(scene));
                                                     });
      CHECK((allocations > 0) == (!removes || semantic == evaluation_semantic::enforce));
      CHECK(picture(scene) == picture(expected));
      CHECK(index_is_sound(scene));
    }
  }
}

TEST_CASE("an edit of the groups for which memory runs out changes nothing") {
  Scene scene;
  for (const char* name : {"a-long-name-of-an-element", "another-name-of-an-element", "c"})
    scene.apply(Agregar_Esfera{Elemento(name), origin, 1});
  const Grouping inner{"a-long-name-of-an-inner-group", {{"a-long-name-of-an-element", "c"}, {}}};
  const Grouping outer{"a-long-name-of-an-outer-group", {{"another-name-of-an-element"}, {inner.g}}};
  const auto check = [&](const Groups& from, const GroupEdit& edit) {
    Groups groups = from, expected = from;
    REQUIRE(expected.apply_total(edit, scene).ok());
    CHECK(fail_every_allocation([&] { groups.apply_total(edit, scene); }, [&] { REQUIRE(groups == from); }) > 0);
    CHECK(groups == expected);
    return expected;
  };
  check(check(check({}, inner), outer), Ungrouping{inner.g});
}

TEST_CASE("a copy of a scene is a scene of its own") {
  Scene scene = two_of_each();
  Scene copy = scene;
  copy.apply(Eliminar_Esfera{Elemento("esfera1")});
  CHECK(scene.find("esfera1"));
  CHECK_FALSE(copy.find("esfera1"));
  CHECK(index_is_sound(scene));
  CHECK(index_is_sound(copy));
}

namespace {

/// Adds so many spheres of long names, one after the other.
void add_spheres(Scene& scene, int count) {
  for (int i = 0; i < count; ++i)
    scene.apply(Agregar_Esfera{Elemento("a-sphere-of-a-long-name-" + std::to_string(i)), origin, 1});
}

}  // namespace

// What an audit costs is counted in allocations: retrieving a scene of n elements makes some multiple of n of them, and
// the whole predicates make none.

TEST_CASE("an audited edit retrieves one state: the state before is what the audit before saw") {
  Scene scene;
  add_spheres(scene, 500);
  const long retrieval = allocations_of([&] { (void)retrieve(scene); });
  REQUIRE(retrieval > 500);
  const scoped_semantic audited(cost::audit, evaluation_semantic::enforce);
  const auto edit = [&] {
    scene.apply(Agregar_Cono{Elemento("new"), origin, 1, axis, 1});
    scene.apply(Eliminar_Cono{Elemento("new")});
  };
  edit();
  CHECK(allocations_of(edit) < 2 * retrieval + retrieval / 2);
  {
    const scoped_semantic ignored(cost::audit, evaluation_semantic::ignore);
    scene.apply(Agregar_Esfera{Elemento("unseen"), origin, 1});
  }
  // The state that the last audit saw is not the one before this edit, which is retrieved.
  CHECK(violated([&] { edit(); }) == "none");
  CHECK(violated([&] { scene.apply(Eliminar_Esfera{Elemento("unseen")}); }) == "none");
}

TEST_CASE("an audited edit of twice as many elements costs twice as much, and one that is not audited no more") {
  const auto allocations = [](int elements) {
    Scene scene;
    add_spheres(scene, elements);
    const auto remove = [&](const char* number) {
      scene.apply(Eliminar_Esfera{Elemento(std::string("a-sphere-of-a-long-name-") + number)});
    };
    const long plain = allocations_of([&] { remove("7"); });
    const scoped_semantic audited(cost::audit, evaluation_semantic::enforce);
    remove("8");
    return std::pair{plain, allocations_of([&] { remove("9"); })};
  };
  const auto [plain, audited] = allocations(400);
  const auto [plain_twice, audited_twice] = allocations(800);
  CHECK(plain_twice == plain);
  CHECK(double(audited_twice) / double(audited) > 1.8);
  CHECK(double(audited_twice) / double(audited) < 2.2);
}

TEST_CASE("audits that are put off are one audit") {
  const auto read = [](Scene& scene) {
    scene.put_off_audits();
    add_spheres(scene, 500);
    scene.audit();
  };
  Scene plain, scene;
  const long additions = allocations_of([&] { read(plain); });
  const long retrieval = allocations_of([&] { (void)retrieve(plain); });
  const scoped_semantic audited(cost::audit, evaluation_semantic::enforce);
  CHECK(allocations_of([&] { read(scene); }) < additions + 2 * retrieval);
  CHECK(retrieve(scene) == retrieve(plain));
}

TEST_CASE("the audit at the end sees what the additions let pass, and edits after it are audited") {
  const scoped_semantic ignored(cost::normal, evaluation_semantic::ignore);
  const scoped_semantic audited(cost::audit, evaluation_semantic::enforce);
  const Operation wrong = Agregar_Cono{Elemento("new"), origin, 1, Vector(0, 1, 1), 1};
  Scene scene;
  scene.put_off_audits();
  CHECK(violated([&] { scene.apply(wrong); }) == "none");
  CHECK(violated([&] { scene.audit(); }) == "Escena.inv.8");
  Scene other = two_of_each();
  other.put_off_audits();
  other.audit();
  CHECK(violated([&] { other.apply(wrong); }) == "Escena.inv.8");
}
