// surface::exact refines model::Primera_Interseccion: over the retrieved scene the model gives the same outcome, the
// same elements, and numbers that round to the same binary64.

#include "durero/surface/exact.hpp"

#include "durero/model/interseccion.hpp"
#include "durero/model/luz.hpp"
#include "durero/model/operaciones.hpp"
#include "durero/scene/retrieve.hpp"
#include "support/catch.hpp"
#include "support/points_gen.hpp"
#include "support/property.hpp"

using namespace durero;
using namespace durero::test;
using model::Elemento;

namespace {

std::set<Elemento> names(const scene::Scene& scene, const scene::ElementSet& elements) {
  std::set<Elemento> those;
  for (const scene::ElementRef element : elements) those.insert(scene.name(element));
  return those;
}

scene::Scene random_scene() {
  scene::Scene scene;
  for (const model::Operation& operation : *any_operations()) scene.apply_total(operation);
  return scene;
}

/// The elements that a ray is told to start on: few of those that there are.
scene::ElementSet random_origin(const scene::Scene& scene) {
  scene::ElementSet en;
  const auto maybe = [&](model::Tipo t, std::size_t count) {
    for (std::uint32_t i = 0; i < count; ++i)
      if (*rc::gen::element(0, 0, 0, 1)) en.push_back({t, i});
  };
  maybe(model::Tipo::soy_esfera, scene.shapes<scene::Sphere>().size());
  maybe(model::Tipo::soy_cilindro, scene.shapes<scene::Cylinder>().size());
  maybe(model::Tipo::soy_cono, scene.shapes<scene::Cone>().size());
  return en;
}

void same_answer(const scene::Scene& scene, const model::Rayo& rayo, const scene::ElementSet& en) {
  const model::Escena escena = retrieve(scene);
  const auto expected = model::Primera_Interseccion(escena, {rayo, names(scene, en)});
  const surface::exact::Origin origin(en);
  const scene::Hit hit = surface::exact::first_hit(scene, rayo, origin);
  RC_CLASSIFY(hit.resultado == model::Resultado::hit, "hit");
  RC_CLASSIFY(hit.resultado == model::Resultado::no_minimum, "no_minimum");
  std::visit(
      [&](const auto& out) {
        RC_ASSERT(hit.resultado == out.resultado);
        RC_ASSERT(names(scene, hit.elementos) == out.elementos);
      },
      expected);
  if (const auto* out = std::get_if<model::Hay_Interseccion>(&expected)) {
    RC_ASSERT(hit.t == number::round_to_binary64(out->t));
    RC_ASSERT(hit.punto.x == number::round_to_binary64(out->punto.x));
    RC_ASSERT(hit.punto.y == number::round_to_binary64(out->punto.y));
    RC_ASSERT(hit.punto.z == number::round_to_binary64(out->punto.z));
  }
  RC_ASSERT(surface::exact::occluded(scene, rayo, origin) == model::occluded(escena, rayo, names(scene, en)));
  RC_ASSERT(surface::exact::occluded_segment(scene, rayo, origin) ==
            model::occluded_segment(escena, rayo, names(scene, en)));
  for (const bool segment : {true, false}) {
    const auto expected = model::enumerado(escena, rayo, names(scene, en), segment);
    const auto points = surface::exact::points_between(
        scene, rayo, origin, segment ? surface::exact::RayStretch::segment : surface::exact::RayStretch::whole,
        [](scene::ElementRef) { return true; });
    RC_ASSERT(points.has_value() == expected.has_value());
    if (!points) continue;
    RC_ASSERT(points->size() == expected->size());
    for (std::size_t i = 0; i < points->size(); ++i) {  // the text's set of names is ordered, too
      RC_ASSERT(scene.name((*points)[i].element) == (*expected)[i].e);
      RC_ASSERT((*points)[i].point.x == number::round_to_binary64((*expected)[i].punto.x));
      RC_ASSERT((*points)[i].point.y == number::round_to_binary64((*expected)[i].punto.y));
      RC_ASSERT((*points)[i].point.z == number::round_to_binary64((*expected)[i].punto.z));
    }
  }
}

}  // namespace

TEST_CASE("the exact oracle answers what the model answers") {
  property("a random ray", [] {
    const scene::Scene scene = random_scene();
    same_answer(scene, *any_ray(), random_origin(scene));
  });

  property("a ray along a generator of a cylinder or a cone", [] {
    scene::Scene scene = random_scene();
    const model::Punto base = *any_point();
    const double radio = *any_length(), altura = *any_length();
    const Elemento e("generator");
    const double along = *rc::gen::element(-1.0, 1.0), from = *any_coordinate();
    if (*rc::gen::arbitrary<bool>()) {
      scene.apply(model::Agregar_Cilindro{e, base, radio, {0, 0, 1}, altura});
      RC_PRE(std::isfinite(base.x() + radio));
      same_answer(scene, {{base.x() + radio, base.y(), base.z() + from}, {0, 0, along}}, random_origin(scene));
    } else {
      // Of proportion 1 the generators are diagonals; the apex is at (x, y, z + altura).
      scene.apply(model::Agregar_Cono{e, base, 1, {0, 0, 1}, altura});
      const model::Punto p(base.x() + from, base.y(), base.z() + (altura - from));
      same_answer(scene, {p, {-along, 0, along}}, random_origin(scene));
    }
  });
}

TEST_CASE(
    "points_between: by name and along the ray; nothing where an element passes no light, or the ray runs along one") {
  using surface::exact::RayStretch;
  scene::Scene scene;
  scene.apply(model::Agregar_Plano{model::Elemento("pane"), {0, 0, 3}, {0, 0, 1}});
  scene.apply(model::Agregar_Esfera{model::Elemento("ball"), {0, 0, 5}, 1});
  const scene::ElementRef pane = *scene.find("pane"), ball = *scene.find("ball");
  const auto all = [](scene::ElementRef) { return true; };
  const auto no_pane = [&](scene::ElementRef e) { return e != pane; };
  using Points = std::vector<surface::exact::ElementPoint>;
  const model::Rayo through({0, 0, 0}, {0, 0, 8}), into({0, 0, 0}, {0, 0, 5}), edge({0, 0, 0}, {0, 0, 3});
  const auto between = [&](const model::Rayo& rayo, RayStretch stretch, const surface::exact::Passes& passes) {
    return surface::exact::points_between(scene, rayo, {}, stretch, passes);
  };
  CHECK(between(through, RayStretch::segment, all) == Points{{ball, {0, 0, 4}}, {ball, {0, 0, 6}}, {pane, {0, 0, 3}}});
  CHECK(between(into, RayStretch::segment, all) == Points{{ball, {0, 0, 4}}, {pane, {0, 0, 3}}});
  CHECK(between(edge, RayStretch::segment, no_pane) == Points{});
  CHECK(between(edge, RayStretch::whole, all)->size() == 3);
  CHECK_FALSE(between(into, RayStretch::segment, no_pane));
  CHECK_FALSE(between({{0, 0, 3}, {1, 0, 0}}, RayStretch::segment, all));
  CHECK(surface::exact::points_of(scene, {ball}, into, {}, RayStretch::whole)->size() == 2);
}
