// What the program draws, held to the reals of spec/iluminacion.tex and spec/luz.tex: the text itself is evaluated on
// samples, exactly, and the program's binary64 is within a bound that is derived here. u is 2⁻⁵³, the rounding of one
// operation.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <random>

#include "durero/model/luz.hpp"
#include "durero/model/operaciones.hpp"
#include "durero/render/light/directions.hpp"
#include "durero/render/light/light_cones.hpp"
#include "durero/render/light/whitted.hpp"
#include "durero/scene/camera.hpp"
#include "durero/scene/retrieve.hpp"
#include "durero/scene/stage.hpp"
#include "durero/spec/calculator.hpp"
#include "render/light/smooth_normal.hpp"
#include "support/catch.hpp"

using namespace durero;
using number::Rational;

namespace {

constexpr double u = 0x1p-53;

const spec::Calculator& text() {
  static const spec::Calculator calculator;
  return calculator;
}

/// An exact number as one types it.
std::string typed(const Rational& r) { return fmt::format("({})", r.str()); }
std::string typed(double value) { return typed(number::exact(value)); }

std::string vector(const Rational& x, const Rational& y, const Rational& z) {
  return fmt::format("⦉x == {}, y == {}, z == {}⦊", typed(x), typed(y), typed(z));
}

bool so(const std::string& predicate) { return text().evaluate(predicate).yes; }

/// A whole number of `of` parts.
double share(std::mt19937_64& random, int of = 64) { return double(random() % std::uint64_t(of + 1)) / of; }

/// Whole components of a vector whose length is whole.
struct Whole {
  int x, y, z, length;
  std::string unit() const { return vector(part(x), part(y), part(z)); }
  Rational part(int component) const { return Rational(component) / Rational(length); }
  glm::dvec3 stored() const { return {x, y, z}; }
  glm::dvec3 stored_unit() const { return stored() / double(length); }
};

Whole any_whole(std::mt19937_64& random) {
  static constexpr int quadruples[][4] = {{1, 2, 2, 3},  {2, 3, 6, 7},  {1, 4, 8, 9},   {4, 4, 7, 9},
                                          {2, 6, 9, 11}, {6, 6, 7, 11}, {3, 4, 12, 13}, {2, 5, 14, 15}};
  const auto& of = quadruples[random() % std::size(quadruples)];
  int parts[] = {of[0], of[1], of[2]};
  for (int i = 2; i > 0; --i) std::swap(parts[i], parts[random() % std::uint64_t(i + 1)]);
  for (int& part : parts) part = random() % 2 == 0 ? part : -part;
  return {parts[0], parts[1], parts[2], of[3]};
}

/// The components of a material, as the text's binding.
std::string material(const scene::Material& m) {
  return fmt::format(
      "⦉k_a == {}, k_d == {}, k_s == {}, k_ps == {}, k_t == {}, C == {}, M_PS == {}, M_T == {}, emisividad == {}, A_G "
      "== "
      "{}, e == {}, indice == {}⦊",
      typed(m.k_a), typed(m.k_d), typed(m.k_s), typed(m.k_ps), typed(m.k_t), typed(m.color.x), typed(m.M_PS.x),
      typed(m.M_T.x), typed(m.emission.x), typed(m.ambient.x), typed(m.e), typed(m.index));
}

/// Says whether the expression of the text is within `bound` of the value.
bool within(const std::string& expression, double value, double bound) {
  return so(fmt::format("∃ real : ℝ | real = {} • {} ≤ real ∧ real ≤ {}", expression,
                        typed(number::exact(value) - number::exact(bound)),
                        typed(number::exact(value) + number::exact(bound))));
}

}  // namespace

// The floor has the normal (0, 0, 1), without error; the rays and the lights have directions of whole length. So unit()
// has no error but that of its last division: u of each component, relatively. The cosine n·l is a component of l. The
// mirrored l turns one sign, so that r·v is three products of relative error 3u, and two sums: 6u at most, as the sum
// of what is added is at most 1 by Cauchy and Schwarz. A power of a cosine c that is off by 6u is off by e·6u·(1 +
// 6u)ᵉ, below 7e·u, and pow() by less than one unit in the last place, 2u. Of the sums, each of at most 5, and of the
// products there are fewer than six roundings behind it: 30u. In all it is below (7e + 32)·u.
TEST_CASE("radiancia.def.1: with one light, over materials, directions and whole exponents") {
  std::mt19937_64 random(20251124);
  scene::Scene scene;
  scene.apply(model::Agregar_Plano{model::Elemento("floor"), {0, 0, 0}, {0, 0, 1}});
  const auto material_index = std::uint32_t{0};
  scene.stage().materials.emplace_back();
  scene.set_material(*scene.find("floor"), material_index);
  scene.stage().directional_lights.emplace_back();
  const auto exact = engine::find("exact")->prepare(scene);
  int highlights = 0;
  for (int sample = 0; sample < 60; ++sample) {
    CAPTURE(sample);
    Whole v = any_whole(random), l = any_whole(random);
    v.z = std::abs(v.z);
    if (sample % 3 == 0) l = {-v.x, -v.y, v.z, v.length};  // in the middle of the highlight
    if (sample % 3 == 1) l.z = std::abs(l.z);
    scene::Material& m = scene.stage().materials[material_index];
    m = {.name = "m", .color = glm::dvec3(share(random)), .emission = glm::dvec3(share(random))};
    m.k_a = share(random), m.k_d = share(random), m.k_s = share(random);
    m.ambient = glm::dvec3(share(random));
    m.e = double(random() % 40);
    const double brightness = share(random);
    scene.stage().directional_lights[0] = {-l.stored(), glm::dvec3(brightness)};
    const scene::Query query{{model::Punto(v.stored()), model::Vector(-v.stored())}};
    const double seen = render::brought(scene, *exact, {&query, 1}, {1}).at(0).color.x;
    const bool lit = l.z > 0;
    highlights += lit && m.k_s > 0 ? 1 : 0;
    // From below nothing stands before the light but the floor that the ray starts on: it is visible, and k_a counts.
    const std::string fuente = fmt::format("⦉l == {}, S == {}, V == 1⦊", l.unit(), typed(brightness));
    const std::string expression = fmt::format("radiancia({0}, aportacion({0}, {1}, {2}, {3}), 0, 0)", material(m),
                                               vector(0, 0, 1), v.unit(), fuente);
    CHECK(within(expression, seen, (7 * m.e + 32) * u));
  }
  CHECK(highlights >= 30);
}

// Each component of d and n is stored within u, relatively. So d·n is within 6u, as r·v above; twice that times a
// component of n, which is at most 1, within 2·(6u + u + u); the difference rounds once more, of at most 3, and d has
// its own u: below 24u.
TEST_CASE("reflexion.def.1: the mirrored direction is near the one that the text has") {
  std::mt19937_64 random(20251125);
  for (int sample = 0; sample < 30; ++sample) {
    const Whole v = any_whole(random), n = any_whole(random);
    const glm::dvec3 seen = render::mirrored(-v.stored_unit(), n.stored_unit());
    const model::ExactDirection r =
        model::reflected({v.part(v.x), v.part(v.y), v.part(v.z)}, {n.part(n.x), n.part(n.y), n.part(n.z)});
    CHECK(so(fmt::format("({}, {}, {}) ∈ reflexion", v.unit(), n.unit(), vector(r.x.x, r.y.x, r.z.x))));
    for (const auto& [one, other] : {std::pair{seen.x, r.x}, std::pair{seen.y, r.y}, std::pair{seen.z, r.z}})
      CHECK(std::abs(one - number::round_to_binary64(other)) <= 24 * u);
  }
}

// The cosine c = i·n is within 6u, as above; 1 − c² within 14u; the square of the ratio, at most 2, is within 12u, and
// its product with 1 − c² within 4·14u + 12u + 4u: the square of the cosine beyond within 73u. Where that cosine is at
// least 1/8 its root is within 4·73u and its own rounding: 293u. The rest adds 2·6u + 2·2u and four roundings of at
// most 3: below 330u.
TEST_CASE("refraccion.def.1: the refracted direction is near the one that the text has, and is not where it has none") {
  std::mt19937_64 random(20251126);
  int bent = 0, total = 0;
  for (int sample = 0; sample < 60; ++sample) {
    const Whole i = any_whole(random);
    Whole n = any_whole(random);
    if (i.x * n.x + i.y * n.y + i.z * n.z < 0) n = {-n.x, -n.y, -n.z, n.length};
    const int near = 2 + int(random() % 4), far = 2 + int(random() % 4);
    if (near > 2 * far) continue;
    const Rational ratio = Rational(near) / Rational(far);
    const model::ExactDirection i_exact{i.part(i.x), i.part(i.y), i.part(i.z)},
        n_exact{n.part(n.x), n.part(n.y), n.part(n.z)};
    const std::string of = fmt::format("{}, {}, {}", i.unit(), n.unit(), typed(ratio));
    const auto seen = render::refracted(-i.stored_unit(), n.stored_unit(), double(near) / far);
    const Rational squared = model::coseno_cuadrado(i_exact, n_exact, ratio).x;
    if (so(fmt::format("({}) ∈ reflexion_total", of))) {
      ++total;
      CHECK((!seen || squared > -number::exact(73 * u)));
      continue;
    }
    if (squared * 64 < 1) continue;
    ++bent;
    REQUIRE(seen);
    const model::ExactDirection t = model::refracted(i_exact, n_exact, ratio).value();
    const auto surd = [](const number::Surd& s) {
      return fmt::format("({} + {} * √ {})", typed(s.x), typed(s.y), typed(s.delta));
    };
    CHECK(so(fmt::format("({}, ⦉x == {}, y == {}, z == {}⦊) ∈ refraccion", of, surd(t.x), surd(t.y), surd(t.z))));
    const double ends[][2] = {{seen->x, number::round_to_binary64(t.x)},
                              {seen->y, number::round_to_binary64(t.y)},
                              {seen->z, number::round_to_binary64(t.z)}};
    for (const auto& [one, other] : ends) CHECK(std::abs(one - other) <= 330 * u);
  }
  CHECK(bent >= 20);
  CHECK(total >= 3);
}

// The camera looks along an axis, and its steps are counted by −1, 0 and 1, so that every ray is stored without error:
// the window is that of the stored steps, and each ray leads through the very centre.
TEST_CASE("rayo_de_pixel.def.1: the rays of a dyadic camera are those of the text") {
  const scene::Camera camera{{1, -2, 0.5}, {1, -2, 8}, {0, 1, 0}, 90};
  const scene::PrimaryRays rays(camera, {3, 3});
  const auto exact = [](double value) { return number::exact(value); };
  const model::Rayo middle = rays.ray(1, 1), right = rays.ray(2, 1), below = rays.ray(1, 2);
  const Rational step_x = exact(right.v().x()) - exact(middle.v().x()),
                 step_y = exact(below.v().y()) - exact(middle.v().y()), ahead = exact(middle.v().z());
  const std::string window =
      fmt::format("⦉ojo == {}, esquina == {}, ancho == {}, alto == {}, H == 3, V == 3⦊", vector(1, -2, exact(0.5)),
                  vector(1 - 3 * step_x / 2, -2 - 3 * step_y / 2, exact(0.5) + ahead), vector(3 * step_x, 0, 0),
                  vector(0, 3 * step_y, 0));
  CHECK(so(window + " ∈ Ventana"));
  for (std::uint32_t x = 0; x < 3; ++x)
    for (std::uint32_t y = 0; y < 3; ++y) {
      const model::Rayo ray = rays.ray(x, y);
      const std::string typed_ray = fmt::format("⦉p == {}, v == {}⦊", vector(1, -2, exact(0.5)),
                                                vector(exact(ray.v().x()), exact(ray.v().y()), exact(ray.v().z())));
      const std::string centre =
          vector(1 + exact(ray.v().x()), -2 + exact(ray.v().y()), exact(0.5) + exact(ray.v().z()));
      CHECK(so(fmt::format("({}, {}, {}, {}) ∈ centro_de_pixel", window, x, y, centre)));
      CHECK_FALSE(so(fmt::format("({}, {}, {}, {}) ∈ centro_de_pixel", window, (x + 1) % 3, y, centre)));
      CHECK(so(fmt::format("{} ∈ puntos_de_rayo({})", centre, typed_ray)));
    }
}

// The triangle's corners are (0, 0, 0), (1, 0, 0) and (0, 1, 0), so that u and v are the point's own coordinates,
// without error, and 1 − u − v of 64ths too. Each component is three products and two sums of terms of at most 2: 5u·2
// and less; the length divides it, which is at least 1/2 here, with four roundings more: below 32u.
TEST_CASE("normal_suave.def.1: the smooth normal is along the direction that the text has") {
  std::mt19937_64 random(20261127);
  for (int sample = 0; sample < 30; ++sample) {
    const double first = share(random) / 2, second = share(random) / 2;
    scene::Scene scene;
    scene.apply(model::Agregar_Triangulo{model::Elemento("t"), {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}});
    const auto normal = [&] { return glm::dvec3{share(random) - 0.5, share(random) - 0.5, 1}; };
    const scene::VertexNormals of{normal(), normal(), normal()};
    scene.set_vertex_normals(*scene.find("t"), of);
    const glm::dvec3 seen = render::smooth_normal(scene, *scene.find("t"), {first, second, 0}, {0, 0, 1});
    const auto exact = [](const glm::dvec3& v) { return model::ExactDirection{v.x, v.y, v.z}; };
    const model::ExactDirection n = model::normal_suave(exact(of[0]), exact(of[1]), exact(of[2]), first, second);
    const auto typed_vector = [](const glm::dvec3& v) {
      return vector(number::exact(v.x), number::exact(v.y), number::exact(v.z));
    };
    CHECK(so(fmt::format("({}, {}, {}, {}, {}, {}) ∈ normal_suave", typed_vector(of[0]), typed_vector(of[1]),
                         typed_vector(of[2]), typed(first), typed(second), vector(n.x.x, n.y.x, n.z.x))));
    const glm::dvec3 along{number::round_to_binary64(n.x), number::round_to_binary64(n.y),
                           number::round_to_binary64(n.z)};
    CHECK(glm::distance(seen, glm::normalize(along)) <= 32 * u);
  }
}

// The cosine is a component of w here, without error. The quotient x rounds two differences, of at most 1, and itself:
// it is within 3u of the exact one, relatively, as the differences of these 64ths are exact. x²(3 − 2x) has a slope of
// at most 3/2 and five roundings of at most 3; a whole power up to 8 of a cosine up to 1 and pow() add 2u: in all below
// 24u.
TEST_CASE("intensidad.def.1: the share of a cone of light is near the one that the text has") {
  std::mt19937_64 random(20261128);
  int between = 0;
  for (int sample = 0; sample < 90; ++sample) {
    const Whole w = any_whole(random);
    const double edge = double(1 + random() % 60) / 64, full = std::min(1.0, edge + double(random() % 32) / 64);
    const double tightness = double(random() % 9);
    const double seen = render::intensity({{0, 0, 1}, full, edge, tightness}, w.stored_unit());
    const double cosine = double(w.z) / w.length;
    if (cosine == edge || cosine == full) continue;
    between += cosine > edge && cosine < full ? 1 : 0;
    const std::string cone = fmt::format("⦉eje == {}, pleno == {}, borde == {}, estrechez == {}⦊", vector(0, 0, 1),
                                         typed(full), typed(edge), typed(tightness));
    const model::Cono_de_Luz exact{{0, 0, 1}, number::exact(full), number::exact(edge), number::exact(tightness)};
    const model::ExactDirection way{w.part(w.x), w.part(w.y), w.part(w.z)};
    const number::Surd share = model::intensidad(exact, way);
    CHECK(so(fmt::format("({}, {}, {}) ∈ intensidad", cone, w.unit(), typed(share.x))));
    CHECK_FALSE(so(fmt::format("({}, {}, {}) ∈ intensidad", cone, w.unit(), typed(share.x + Rational(1)))));
    CHECK(std::abs(seen - number::round_to_binary64(share)) <= 24 * u);
  }
  CHECK(between >= 8);
}

// The points between a surface and a light, counted by the text of a scene: each that the program counts is one of
// ante.
TEST_CASE("ante.def.1 and transmitido.def.1: a picture takes the shares that the model takes") {
  scene::Scene scene;
  scene.apply(model::Agregar_Plano{model::Elemento("floor"), {0, 0, 0}, {0, 1, 0}});
  scene.apply(model::Agregar_Esfera{model::Elemento("ball"), {0, 4, 0}, 1});
  scene.apply(model::Agregar_Disco{model::Elemento("pane"), {0, 6, 0}, 2, {0, 1, 0}});
  scene.stage().materials = {{.name = "ball", .color = glm::dvec3(0), .k_d = 0, .k_t = 0.5, .M_T = glm::dvec3(0.75)},
                             {.name = "floor", .color = glm::dvec3(1)},
                             {.name = "pane", .color = glm::dvec3(0), .k_d = 0, .k_t = 0.25}};
  scene.set_material(*scene.find("ball"), 0);
  scene.set_material(*scene.find("floor"), 1);
  scene.set_material(*scene.find("pane"), 2);
  scene.stage().lights = {{{0, 8, 0}, glm::dvec3(1)}};
  const model::Escena escena = scene::retrieve(scene);
  const model::Rayo shadow{{0, 0, 0}, {0, 8, 0}};
  const auto all = model::enumerado(escena, shadow, {model::Elemento("floor")}, true);
  REQUIRE(all);
  const Rational share = model::transmitido(*all, [](const model::Encuentro& each) {
    return each.e == model::Elemento("pane") ? Rational(1) / 4 : Rational(3) / 8;
  });
  CHECK(share == Rational(9) / 256);
  const scene::Query query{{{3, 0.5, 0}, {-3, -0.5, 0}}};
  const glm::dvec3 seen = render::brought(scene, *engine::find("exact")->prepare(scene), {&query, 1},
                                          {.max_depth = 1, .shadows = render::ShadowRule::coloured})
                              .at(0)
                              .color;
  CHECK(number::exact(seen.x) == share);
}
