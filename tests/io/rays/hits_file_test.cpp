#include "durero/io/rays/hits_file.hpp"

#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <limits>

#include "durero/model/operaciones.hpp"
#include "io/malformed.hpp"
#include "io/random_scene.hpp"
#include "support/catch.hpp"
#include "support/folder.hpp"
#include "support/property.hpp"

using namespace durero;
using model::Resultado;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

// a, B and c: a sphere, a cylinder and a cone, so that the order of names is not that of the tables.
scene::Scene three_elements() {
  scene::Scene scene;
  scene.apply(model::Agregar_Esfera{model::Elemento{"c"}, model::Punto{0, 0, 0}, 1});
  scene.apply(model::Agregar_Cilindro{model::Elemento{"B"}, model::Punto{0, 0, 0}, 1, model::Vector{0, 0, 1}, 1});
  scene.apply(model::Agregar_Cono{model::Elemento{"a"}, model::Punto{0, 0, 0}, 1, model::Vector{0, 0, 1}, 1});
  return scene;
}

scene::ElementSet elements(const scene::Scene& scene, std::initializer_list<const char*> names) {
  scene::ElementSet all;
  for (const char* name : names) all.push_back(scene.find(name).value());
  std::sort(all.begin(), all.end());
  return all;
}

const auto reading = [](const io::Source& s) { return io::read_hits(s, three_elements()); };
std::string error_at(const std::string& with_mark) { return test::error_at_mark(with_mark, reading); }

double any_rounded() {
  return *rc::gen::weightedOneOf<double>({{4, test::anyFinite()}, {1, rc::gen::element(infinity, -infinity)}});
}

}  // namespace

TEST_CASE("A hit is written as the format says") {
  const scene::Scene scene = three_elements();
  CHECK(io::hit_text(0, {Resultado::hit, 4, {0, -0.0, 4}, elements(scene, {"a"})}, scene) ==
        R"({"ray":0,"outcome":"hit","elementos":["a"],"t":4,"point":[0,-0,4]})");
  CHECK(io::hit_text(7, {Resultado::hit, infinity, {-infinity, 0.1, 1e300}, elements(scene, {"a", "B", "c"})}, scene) ==
        R"({"ray":7,"outcome":"hit","elementos":["B","a","c"],"t":"inf","point":["-inf",0.1,1e+300]})");
  CHECK(io::hit_text(1, {}, scene) == R"({"ray":1,"outcome":"miss","elementos":[]})");
  CHECK(io::hit_text(2, {Resultado::no_minimum, 0, {}, elements(scene, {"c"})}, scene) ==
        R"({"ray":2,"outcome":"no_minimum","elementos":["c"]})");
}

TEST_CASE("A hit reads back from its text") {
  test::property("any hit", [] {
    const scene::Scene scene = three_elements();
    scene::Hit hit;
    hit.resultado = *rc::gen::element(Resultado::hit, Resultado::miss, Resultado::no_minimum);
    if (hit.resultado != Resultado::miss) {
      hit.elementos = *rc::gen::arbitrary<bool>() ? elements(scene, {"a", "c"}) : elements(scene, {"B"});
    }
    if (hit.resultado == Resultado::hit) {
      hit.t = any_rounded();
      hit.punto = {any_rounded(), any_rounded(), any_rounded()};
    }
    const auto ray = *rc::gen::inRange<std::size_t>(0, 1000000);
    const auto back = io::read_hits(io::Source("f", io::hit_text(ray, hit, scene) + "\n"), scene);
    RC_ASSERT(back.size() == 1U);
    RC_ASSERT(back[0].ray == ray);
    RC_ASSERT(back[0].hit == hit);
  });
}

TEST_CASE("Hits as .npy are one record a ray") {
  const scene::Scene scene = three_elements();
  const scene::Hit hits[] = {{Resultado::hit, 4, {1, 2, 3}, elements(scene, {"a", "B"})}, {}};
  const std::string text = io::hits_npy(hits, scene);
  CHECK(text.find("'descr': [('outcome', 'S10'), ('t', '<f8'), ('point', '<f8', (3,)), ('elementos', 'S3')]") !=
        text.npos);
  CHECK(text.find("'shape': (2,)") != text.npos);
  constexpr std::size_t record = 10 + 4 * 8 + 3;
  REQUIRE(text.size() % 64 == 2 * record % 64);
  const std::string data = text.substr(text.size() - 2 * record);
  CHECK(data.substr(0, 10) == std::string("hit\0\0\0\0\0\0\0", 10));
  const auto number = [&](std::size_t at) {
    double x = 0;
    std::memcpy(&x, data.data() + at, sizeof x);  // this test's machine is little-endian
    return x;
  };
  CHECK(number(10) == 4);
  CHECK(number(34) == 3);
  CHECK(data.substr(42, 3) == "B,a");
  CHECK(data.substr(record, 4) == "miss");
  CHECK(std::isnan(number(record + 10)));
  CHECK(data.substr(record + 42, 3) == std::string(3, '\0'));
}

TEST_CASE("Hits stand one a line, however the lines end") {
  const scene::Scene scene = three_elements();
  const std::string miss = R"({"ray":0,"outcome":"miss","elementos":[]})";
  const std::string other = R"({"ray":1,"outcome":"miss","elementos":[]})";
  for (const char* end : {"\n", "\r\n", "\r"}) {
    const auto hits = io::read_hits(io::Source("f", miss + end + " \t" + end + other + end), scene);
    REQUIRE(hits.size() == 2);
    CHECK(hits[1].ray == 1);
  }
  CHECK(error_at(miss + "\r" + R"({"ray":^-1,"outcome":"miss","elementos":[]})") ==
        "ray is -1; expected the number of a ray, from 0");
}

TEST_CASE("Hits are written in the format that the file's name tells, in whatever parts they come") {
  test::property("any hits, any parts", [] {
    const scene::Scene scene = three_elements();
    const scene::Hit some[] = {{Resultado::hit, 4, {1, 2, 3}, elements(scene, {"a", "B"})},
                               {},
                               {Resultado::no_minimum, 0, {}, elements(scene, {"c"})},
                               {Resultado::hit, infinity, {-0.0, 2, 3}, elements(scene, {"B"})}};
    std::vector<scene::Hit> hits;
    std::string text;
    const test::Folder folder;
    io::HitWriter npy(folder.file("hits.npy")), lines(folder.file("hits.jsonl"));
    for (int part = *rc::gen::inRange(0, 4); part > 0; --part) {
      std::vector<scene::Hit> more(*rc::gen::inRange<std::size_t>(0, 5));
      for (scene::Hit& hit : more) hit = some[*rc::gen::inRange<std::size_t>(0, 4)];
      npy.write(more, scene);
      lines.write(more, scene);
      for (const scene::Hit& hit : more) {
        text += io::hit_text(hits.size(), hit, scene) + "\n";
        hits.push_back(hit);
      }
    }
    RC_ASSERT_FALSE(std::filesystem::exists(folder.file("hits.npy")));
    RC_ASSERT_FALSE(std::filesystem::exists(folder.file("hits.jsonl")));
    npy.commit();
    lines.commit();
    RC_ASSERT(folder.files() == 2);
    RC_ASSERT(io::read_source(folder.file("hits.npy")).text() == io::hits_npy(hits, scene));
    RC_ASSERT(io::read_source(folder.file("hits.jsonl")).text() == text);
  });
}

TEST_CASE("Many rows of .npy are written as few are") {
  const scene::Scene scene = three_elements();
  const test::Folder folder;
  std::vector<scene::Hit> hits(70'000);  // more than is read of the rows, and written, at once
  for (std::size_t i = 0; i < hits.size(); i += 3)
    hits[i] = {Resultado::hit, double(i), {1, 2, 3}, elements(scene, {"a"})};
  hits[69'000].elementos = elements(scene, {"a", "B", "c"});
  hits[69'000].resultado = Resultado::no_minimum;
  io::HitWriter npy(folder.file("hits.npy"));
  npy.write(hits, scene);
  npy.commit();
  CHECK(io::read_source(folder.file("hits.npy")).text() == io::hits_npy(hits, scene));
}

TEST_CASE("A malformed hit is an error with its place") {
  using Case = std::pair<std::string, std::string>;
  const Case cases[] = {
      {R"({"ray":^-1,"outcome":"miss","elementos":[]})", "ray is -1; expected the number of a ray, from 0"},
      {R"({"ray":^0.5,"outcome":"miss","elementos":[]})", "ray is 0.5; expected the number of a ray, from 0"},
      {R"({"ray":0,"outcome":^"none","elementos":[]})", "outcome is \"none\"; expected hit, miss or no_minimum"},
      {R"({"ray":0,"outcome":"miss","elementos":[^"d"]})", "no element \"d\"; expected an element of the scene"},
      {R"({"ray":0,"outcome":"miss","elementos":["a",^"a"]})", "element \"a\" stands twice; expected it once"},
      {R"(^{"ray":0,"outcome":"miss","elementos":["a"]})",
       "outcome miss with 1 elements; expected none where it is miss, and some otherwise"},
      {R"(^{"ray":0,"outcome":"hit","elementos":["a"],"t":1})",
       "outcome hit without t and point; expected both where it is hit, and neither otherwise"},
      {R"(^{"ray":0,"outcome":"miss","elementos":[],"t":1})",
       "outcome miss with t and point; expected both where it is hit, and neither otherwise"},
      {R"({"ray":0,"outcome":"hit","elementos":["a"],"t":^"nan"})",
       "t is \"nan\"; expected a number, \"inf\" or \"-inf\""},
      {R"({"ray":0,"outcome":"hit","elementos":["a"],"t":1,"point":^[1,2]})",
       "point has 2 items; expected three numbers"},
      {R"({"ray":0,"outcome":"hit","elementos":["a"],"t":1,"point":[1,2,3,^4]})",
       "point has a fourth item; expected three numbers"},
      {"\n\n^[]", "a hit is an array; expected an object"},
      {"{\"ray\":0,\"outcome\":\"miss\",\"elementos\":[]}\n^{\"ray\":1,\"outcome\":\"no_minimum\",\"elementos\":[]}",
       "outcome no_minimum with 0 elements; expected none where it is miss, and some otherwise"},
      {R"({"ray":^1e17,"outcome":"miss","elementos":[]})", "ray is 1e+17; expected the number of a ray, from 0"},
      {R"({"ray":0,"outcome":"hit","elementos":["a"],"t":1,"point":[1,^"x",3]})",
       "point is \"x\"; expected a number, \"inf\" or \"-inf\""},
  };
  for (const auto& [text, expected] : cases) {
    INFO(text);
    CHECK(error_at(text) == expected);
  }
}

TEST_CASE("The hits of rays: one for each ray, in any order, none where the file has none") {
  const scene::Scene scene = three_elements();
  const std::string first = R"({"ray":0,"outcome":"no_minimum","elementos":["c"]})",
                    last = R"({"ray":2,"outcome":"miss","elementos":[]})";
  const auto hits = io::read_hits_of_rays(io::Source("f", last + "\n" + first), scene, 3);
  REQUIRE(hits.size() == 3);
  CHECK(hits[0] == scene::Hit{Resultado::no_minimum, 0, {}, elements(scene, {"c"})});
  CHECK_FALSE(hits[1]);
  CHECK(hits[2] == scene::Hit{});
  const auto of_two = [&](const io::Source& s) { return io::read_hits_of_rays(s, scene, 2); };
  CHECK(test::error_at_mark(first + "\n" + R"({"ray":^2,"outcome":"miss","elementos":[]})", of_two) ==
        "ray 2 of 2; expected a ray of the ray file, from 0");
  CHECK(test::error_at_mark(first + "\n" + R"({"ray":^0,"outcome":"miss","elementos":[]})", of_two) ==
        "ray 0 has a hit already; expected one a ray");
}

TEST_CASE("No damage to hits does worse than an error") {
  const std::string text = R"({"ray":0,"outcome":"hit","elementos":["a","c"],"t":"inf","point":[0,-1.5e3,"-inf"]})"
                           "\n"
                           R"({"ray":1,"outcome":"miss","elementos":[]})"
                           "\n";
  CHECK(test::refused_after_damage(text, 20000, reading) > 10000);
}
