#include <array>
#include <limits>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "durero/c/durero.h"
#include "support/catch.hpp"

namespace {

using Scene = std::unique_ptr<durero_scene, decltype(&durero_scene_free)>;
using Engine = std::unique_ptr<durero_engine, decltype(&durero_engine_free)>;

Scene scene_of(const std::vector<const char*>& operations) {
  Scene scene(durero_scene_new(), durero_scene_free);
  for (const char* operation : operations) REQUIRE(durero_apply(scene.get(), operation) == DURERO_DONE);
  return scene;
}

Engine engine_of(const Scene& scene, const char* name = nullptr) {
  return {durero_engine_new(scene.get(), name), durero_engine_free};
}

/// A disc in the plane z = 3 behind a ball of radius 1 about (0,0,0), which touches a triangle at (0,0,1).
Scene some_scene() {
  return scene_of({"Agregar_Triangulo e?=touching vertices?=((-1,-1,1),(1,-1,1),(0,1,1))",
                   "Agregar_Esfera e?=ball centro?=(0,0,0) radio?=1",
                   "Agregar_Disco e?=behind centro?=(0,0,3) radio?=9 vector?=(0,0,1)"});
}

/// Along z from z = 5, each at its x, downwards; so many that they are answered at more than one time.
struct Rays {
  explicit Rays(std::size_t count) : zero(count), five(count, 5), down(count, -2), x(count) {
    for (std::size_t i = 0; i < count; ++i) x[i] = static_cast<double>(i % 3);
  }
  durero_ray_arrays arrays() const {
    return {{x.data(), zero.data(), five.data()}, {zero.data(), zero.data(), down.data()}, nullptr};
  }
  std::vector<double> zero, five, down, x;
};

struct Hits {
  explicit Hits(std::size_t count)
      : outcome(count, 9), elements(count, 9), element(count, 9), t(count, 9), point{t, t, t} {}
  durero_hit_arrays arrays() {
    return {
        outcome.data(), elements.data(), element.data(), t.data(), {point[0].data(), point[1].data(), point[2].data()}};
  }
  std::vector<std::uint8_t> outcome;
  std::vector<std::uint32_t> elements, element;
  std::vector<double> t;
  std::array<std::vector<double>, 3> point;
};

}  // namespace

TEST_CASE("elements have numbers, type by type, and names by them") {
  const Scene scene = some_scene();
  const Engine engine = engine_of(scene);
  const std::array<std::string, 3> names{"ball", "behind", "touching"};
  for (std::uint32_t number = 0; number < names.size(); ++number) {
    REQUIRE(durero_element_name(engine.get(), number) != nullptr);
    CHECK(durero_element_name(engine.get(), number) == names[number]);
    CHECK(durero_element_number(engine.get(), names[number].c_str()) == number);
  }
  CHECK(durero_element_name(engine.get(), 3) == nullptr);
  CHECK(durero_element_name(engine.get(), DURERO_NO_ELEMENT) == nullptr);
  CHECK(durero_element_number(engine.get(), "none") == DURERO_NO_ELEMENT);
}

TEST_CASE("arrays are answered as rays one by one are, also where they are more than are answered at a time") {
  const Scene scene = some_scene();
  for (const char* name : {static_cast<const char*>(nullptr), "exact"}) {
    const Engine engine = engine_of(scene, name);
    const std::size_t count = name == nullptr ? (std::size_t{1} << 17) + 5 : 5;
    const Rays rays(count);
    const durero_ray_arrays asked = rays.arrays();
    Hits hits(count);
    const durero_hit_arrays to = hits.arrays();
    REQUIRE(durero_first_hits_of_arrays(engine.get(), &asked, count, &to) == DURERO_DONE);
    std::vector<durero_ray> one_by_one;
    for (std::size_t i = 0; i < count; ++i) one_by_one.push_back({{rays.x[i], 0, 5}, {0, 0, -2}});
    std::vector<durero_hit> same(count);
    REQUIRE(durero_first_hits(engine.get(), one_by_one.data(), count, same.data()) == DURERO_DONE);
    std::size_t alike = 0;
    for (std::size_t i = 0; i < count; ++i)
      alike += hits.outcome[i] == same[i].outcome && hits.elements[i] == same[i].elements && hits.t[i] == same[i].t &&
               hits.point[0][i] == same[i].point[0] && hits.point[1][i] == same[i].point[1] &&
               hits.point[2][i] == same[i].point[2] && hits.element[i] == durero_element_number(engine.get(), "behind");
    CHECK(alike == count);
    CHECK(hits.t[0] == 1);
    CHECK(hits.point[0][2] == 2);
  }
}

TEST_CASE("of several elements at the first point the least is named, and of a miss none") {
  const Scene scene = some_scene();
  const Engine engine = engine_of(scene);
  const std::array<double, 2> x{0, 40}, zero{}, two{2, 2}, down{-1, -1};
  const durero_ray_arrays rays{{x.data(), zero.data(), two.data()}, {zero.data(), zero.data(), down.data()}, nullptr};
  Hits hits(2);
  const durero_hit_arrays to = hits.arrays();
  REQUIRE(durero_first_hits_of_arrays(engine.get(), &rays, 2, &to) == DURERO_DONE);
  CHECK(hits.elements == std::vector<std::uint32_t>{2, 0});
  CHECK(hits.element == std::vector<std::uint32_t>{0, DURERO_NO_ELEMENT});
  CHECK(hits.outcome == std::vector<std::uint8_t>{DURERO_HIT, DURERO_MISS});
  CHECK(hits.t == std::vector<double>{1, 0});
}

TEST_CASE("arrays that are not there are not written, and t and the point of none but these") {
  const Scene scene = some_scene();
  const Engine engine = engine_of(scene);
  const Rays rays(3);
  const durero_ray_arrays asked = rays.arrays();
  Hits whole(3);
  const durero_hit_arrays all = whole.arrays();
  REQUIRE(durero_first_hits_of_arrays(engine.get(), &asked, 3, &all) == DURERO_DONE);
  Hits some(3);
  const durero_hit_arrays elements{nullptr, nullptr, some.element.data(), nullptr, {}};
  REQUIRE(durero_first_hits_of_arrays(engine.get(), &asked, 3, &elements) == DURERO_DONE);
  CHECK(some.element == whole.element);
  const durero_hit_arrays height{nullptr, nullptr, nullptr, nullptr, {nullptr, nullptr, some.point[2].data()}};
  REQUIRE(durero_first_hits_of_arrays(engine.get(), &asked, 3, &height) == DURERO_DONE);
  CHECK(some.point[2] == whole.point[2]);
  const durero_hit_arrays when{nullptr, nullptr, nullptr, some.t.data(), {}};
  REQUIRE(durero_first_hits_of_arrays(engine.get(), &asked, 3, &when) == DURERO_DONE);
  CHECK(some.t == whole.t);
}

TEST_CASE("a ray that starts on an element leaves it, and what is on its way to a light hides that") {
  const Scene scene = some_scene();
  const Engine engine = engine_of(scene);
  // From the lowest point of the disc's axis downwards, to before the ball, into it, and from the ball's own top.
  const std::array<double, 3> zero{}, z{3, 3, 1}, v{-1, -4, 1};
  const std::uint32_t on_disc = durero_element_number(engine.get(), "behind");
  const std::array<std::uint32_t, 3> start{on_disc, on_disc, DURERO_NO_ELEMENT};
  const durero_ray_arrays rays{
      {zero.data(), zero.data(), z.data()}, {zero.data(), zero.data(), v.data()}, start.data()};
  std::array<std::uint8_t, 3> occluded{9, 9, 9};
  REQUIRE(durero_occluded_segments(engine.get(), &rays, 3, occluded.data()) == DURERO_DONE);
  CHECK(occluded == std::array<std::uint8_t, 3>{0, 1, 0});
  Hits hits(3);
  const durero_hit_arrays to = hits.arrays();
  REQUIRE(durero_first_hits_of_arrays(engine.get(), &rays, 3, &to) == DURERO_DONE);
  CHECK(hits.t == std::vector<double>{2, 0.5, 2});
}

TEST_CASE("what is no ray in arrays fails with a line, and writes nothing") {
  const Scene scene = some_scene();
  const Engine engine = engine_of(scene);
  Rays rays(3);
  std::array<std::uint32_t, 3> start{0, 2, 3};
  const auto refused = [&](const durero_ray_arrays& asked, const std::string& why) {
    Hits hits(3);
    const durero_hit_arrays to = hits.arrays();
    CHECK(durero_first_hits_of_arrays(engine.get(), &asked, 3, &to) == DURERO_FAILED);
    CHECK(durero_error() == why);
    CHECK(hits.outcome == std::vector<std::uint8_t>(3, 9));
    CHECK(hits.t == std::vector<double>(3, 9));
    std::array<std::uint8_t, 3> occluded{9, 9, 9};
    CHECK(durero_occluded_segments(engine.get(), &asked, 3, occluded.data()) == DURERO_FAILED);
    CHECK(occluded == std::array<std::uint8_t, 3>{9, 9, 9});
  };
  durero_ray_arrays with_start = rays.arrays();
  with_start.start = start.data();
  refused(with_start, "ray 2: start is 3, the number of no element; expected one, or DURERO_NO_ELEMENT");
  rays.down[1] = 0;
  refused(rays.arrays(), "ray 1: no ray; expected finite numbers and v other than 0");
  rays.down[1] = -1;
  rays.x[0] = std::numeric_limits<double>::infinity();
  refused(rays.arrays(), "ray 0: no ray; expected finite numbers and v other than 0");
}

TEST_CASE("distances: the nearest point, ties, and an empty scene") {
  const Scene scene = some_scene();
  const Engine engine = engine_of(scene);
  const std::vector<double> xyz{0, 0, 5, 0, 0, -4, 0, 0, 1};
  std::vector<durero_proximity> near(3);
  REQUIRE(durero_distances(scene.get(), xyz.data(), 3, near.data()) == DURERO_DONE);
  CHECK(near[0].count == DURERO_ONE);
  CHECK(near[0].distance == 2);
  CHECK(std::vector<double>(near[0].point, near[0].point + 3) == std::vector<double>{0, 0, 3});
  CHECK(near[0].element == durero_element_number(engine.get(), "behind"));
  CHECK(near[1].distance == 3);
  CHECK(near[1].elements == 1);
  CHECK(near[2].distance == 0);
  CHECK(near[2].elements == 2);
  CHECK(near[2].element == durero_element_number(engine.get(), "ball"));

  const Scene empty = scene_of({});
  REQUIRE(durero_distances(empty.get(), xyz.data(), 1, near.data()) == DURERO_DONE);
  CHECK(near[0].count == DURERO_NONE);
  CHECK(near[0].element == DURERO_NO_ELEMENT);

  const std::vector<double> wrong{0, 0, std::numeric_limits<double>::infinity()};
  near[0].distance = 7;
  CHECK(durero_distances(scene.get(), wrong.data(), 1, near.data()) == DURERO_FAILED);
  CHECK(std::string(durero_error()) == "point 0: no point; expected finite numbers");
  CHECK(near[0].distance == 7);
}

TEST_CASE("a mesh of plain arrays is added whole or refused, and its faces are known by number") {
  std::vector<double> vertices{0, 0, 0, 3, 0, 0, 0, 3, 0, 0, 0, 3};
  std::vector<std::uint32_t> faces{0, 2, 1, 0, 1, 3, 1, 2, 3, 0, 3, 2};
  const durero_mesh mesh{vertices.data(), 4, faces.data(), 4};
  const Scene scene = scene_of({"Agregar_Triangulo e?=alone vertices?=((0,0,9),(1,0,9),(0,1,9))"});
  REQUIRE(durero_add_mesh(scene.get(), "tent", &mesh) == DURERO_DONE);
  CHECK(durero_scene_size(scene.get()) == 5);

  const auto first = [&] {
    const Engine engine = engine_of(scene);
    const std::array<double, 6> ray{0.5, 0.5, 7, 0, 0, -1};
    const auto of = [&](std::size_t at) { return &ray[at]; };
    const durero_ray_arrays rays{{of(0), of(1), of(2)}, {of(3), of(4), of(5)}, nullptr};
    Hits hits(1);
    const durero_hit_arrays answers = hits.arrays();
    REQUIRE(durero_first_hits_of_arrays(engine.get(), &rays, 1, &answers) == DURERO_DONE);
    const char* name = nullptr;
    const std::uint32_t face = durero_face_number(engine.get(), hits.element[0], &name);
    CHECK(durero_face_number(engine.get(), hits.element[0], nullptr) == face);
    REQUIRE(name != nullptr);
    CHECK(durero_element_name(engine.get(), hits.element[0]) == name + (":" + std::to_string(face)));
    return std::pair(face, hits.point[2][0]);
  };
  CHECK(first() == std::pair(2U, 2.0));
  {
    const Engine engine = engine_of(scene);
    const char* name = "unset";
    CHECK(durero_face_number(engine.get(), durero_element_number(engine.get(), "alone"), &name) == DURERO_NO_ELEMENT);
    CHECK(name == nullptr);
    CHECK(durero_face_number(engine.get(), 5, nullptr) == DURERO_NO_ELEMENT);
  }

  CHECK(durero_add_mesh(scene.get(), "tent", &mesh) == DURERO_REFUSED);
  CHECK(std::string(durero_error()).starts_with("Agregar_Malla.pre.1: "));
  vertices[11] = 4;
  CHECK(durero_replace_mesh(scene.get(), "other", &mesh) == DURERO_REFUSED);
  CHECK(durero_replace_mesh(scene.get(), "tent", &mesh) == DURERO_DONE);
  CHECK(first() == std::pair(2U, 8.0 / 3));
  faces[4] = 4;
  CHECK(durero_add_mesh(scene.get(), "torn", &mesh) == DURERO_REFUSED);
  CHECK(durero_add_mesh(scene.get(), "no name", &mesh) == DURERO_FAILED);
  CHECK(std::string(durero_error()) == "no name: no name; expected 1 to 128 of A-Z a-z 0-9 _ . : -");
  vertices[4] = std::numeric_limits<double>::infinity();
  CHECK(durero_replace_mesh(scene.get(), "tent", &mesh) == DURERO_FAILED);
  CHECK(std::string(durero_error()) == "vertex 1: no point; expected finite numbers");
  CHECK(durero_scene_size(scene.get()) == 5);
}
