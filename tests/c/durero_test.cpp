#include "durero/c/durero.h"

#include <fmt/format.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <limits>
#include <memory>
#include <sstream>
#include <string>
#include <vector>

#include "support/catch.hpp"
#include "support/tree.hpp"

namespace {

using Scene = std::unique_ptr<durero_scene, decltype(&durero_scene_free)>;
using Engine = std::unique_ptr<durero_engine, decltype(&durero_engine_free)>;

Scene two_spheres() {
  Scene scene(durero_scene_new(), durero_scene_free);
  REQUIRE(durero_apply(scene.get(), "Agregar_Esfera e?=near centro?=(0,0,5) radio?=1") == DURERO_DONE);
  REQUIRE(durero_apply(scene.get(), "Agregar_Esfera e?=same centro?=(0,0,5) radio?=1") == DURERO_DONE);
  return scene;
}

Engine engine_of(const Scene& scene, const char* name = nullptr) {
  return {durero_engine_new(scene.get(), name), durero_engine_free};
}

const durero_ray ahead{{0, 0, 0}, {0, 0, 2}}, aside{{0, 0, 0}, {0, 1, 0}};

}  // namespace

TEST_CASE("a scene is edited under contract, and a refusal names the clause") {
  const Scene scene = two_spheres();
  CHECK(durero_apply(scene.get(), "Agregar_Esfera e?=near centro?=(0,0,9) radio?=1") == DURERO_REFUSED);
  CHECK(std::string(durero_error()) == "Agregar_Elemento.pre.1: e? ∉ elementos");
  CHECK(durero_apply(scene.get(), "Agregar_Esfera e?=flat centro?=(0,0,9) radio?=0") == DURERO_REFUSED);
  CHECK(durero_scene_size(scene.get()) == 2);
  CHECK(durero_apply(scene.get(), "Agregar_Esfera e?=") == DURERO_FAILED);
  CHECK(std::string(durero_error()).starts_with("operation:1:"));
  CHECK(durero_apply(scene.get(), "") == DURERO_FAILED);
  CHECK(durero_apply(scene.get(), "Eliminar_Esfera e?=same\nEliminar_Esfera e?=near") == DURERO_FAILED);
  CHECK(durero_apply(scene.get(), "Eliminar_Esfera e?=same") == DURERO_DONE);
  CHECK(durero_scene_size(scene.get()) == 1);
}

TEST_CASE("what was done is undone, and done again; a transaction is one step") {
  const Scene scene = two_spheres();
  CHECK(durero_apply(scene.get(), "Cambiar_Radio e?=near radio?=2") == DURERO_DONE);
  CHECK(durero_apply(scene.get(), "Cambiar_Radio e?=near radio?=0") == DURERO_REFUSED);
  const auto t_of_first = [&] {
    const Engine engine = engine_of(scene);
    durero_hit hit{};
    REQUIRE(durero_first_hits(engine.get(), &ahead, 1, &hit) == DURERO_DONE);
    return hit.t;
  };
  CHECK(t_of_first() == 1.5);
  CHECK(durero_undo(scene.get()) == DURERO_DONE);
  CHECK(t_of_first() == 2);
  CHECK(durero_redo(scene.get()) == DURERO_DONE);
  CHECK(t_of_first() == 1.5);
  CHECK(durero_redo(scene.get()) == DURERO_REFUSED);
  CHECK(std::string(durero_error()) == "Rehacer.pre.1: deshechas ≠ ⟨⟩");

  CHECK(durero_begin(scene.get()) == DURERO_DONE);
  CHECK(durero_begin(scene.get()) == DURERO_FAILED);
  CHECK(durero_undo(scene.get()) == DURERO_FAILED);
  CHECK(std::string(durero_error()) == "a transaction is open; expected durero_commit() or durero_roll_back() before");
  CHECK(durero_apply(scene.get(), "Eliminar_Esfera e?=near") == DURERO_DONE);
  CHECK(durero_apply(scene.get(), "Eliminar_Esfera e?=same") == DURERO_DONE);
  CHECK(durero_roll_back(scene.get()) == DURERO_DONE);
  CHECK(durero_scene_size(scene.get()) == 2);
  CHECK(durero_commit(scene.get()) == DURERO_FAILED);
  CHECK(durero_roll_back(scene.get()) == DURERO_FAILED);

  durero_begin(scene.get());
  CHECK(durero_apply(scene.get(), "Eliminar_Esfera e?=near") == DURERO_DONE);
  const std::vector<double> points{0, 0, 0, 1, 0, 0, 0, 1, 0};
  const std::vector<std::uint32_t> faces{0, 1, 2};
  const durero_mesh mesh{points.data(), 3, faces.data(), 1};
  CHECK(durero_add_mesh(scene.get(), "tent", &mesh) == DURERO_DONE);
  CHECK(durero_commit(scene.get()) == DURERO_DONE);
  CHECK(durero_scene_size(scene.get()) == 2);
  CHECK(durero_undo(scene.get()) == DURERO_DONE);
  CHECK(t_of_first() == 1.5);
  for (int i = 0; i < 3; ++i) CHECK(durero_undo(scene.get()) == DURERO_DONE);
  CHECK(durero_scene_size(scene.get()) == 0);
  CHECK(durero_undo(scene.get()) == DURERO_REFUSED);
  CHECK(std::string(durero_error()) == "Deshacer.pre.1: hechas ≠ ⟨⟩");
}

TEST_CASE("groups are edited under contract, written and read") {
  const Scene scene = two_spheres();
  CHECK(durero_apply(scene.get(), "group g?=pair elementos?=near,same") == DURERO_DONE);
  CHECK(durero_apply(scene.get(), "group g?=pair elementos?=") == DURERO_FAILED);
  CHECK(durero_apply(scene.get(), "group g?=pair groups?=pair") == DURERO_REFUSED);
  CHECK(std::string(durero_error()) == "group.pre.1: g? ∉ dom groups");
  CHECK(std::string(durero_left_group(scene.get())).empty());
  CHECK(durero_apply(scene.get(), "Eliminar_Esfera e?=same") == DURERO_DONE);
  CHECK(std::string(durero_left_group(scene.get())) == "pair");
  CHECK(durero_apply(scene.get(), "Eliminar_Esfera e?=same") == DURERO_REFUSED);
  CHECK(std::string(durero_left_group(scene.get())).empty());
  const std::string path = std::filesystem::temp_directory_path() / fmt::format("durero_test_{}.json", getpid());
  REQUIRE(durero_scene_write(scene.get(), path.c_str()) == DURERO_DONE);
  const Scene again(durero_scene_read(path.c_str()), durero_scene_free);
  std::filesystem::remove(path);
  REQUIRE(again);
  CHECK(durero_scene_size(again.get()) == 1);
  CHECK(durero_apply(again.get(), "group g?=new elementos?=near") == DURERO_REFUSED);
  CHECK(std::string(durero_error()).starts_with("group.pre.4: "));
  CHECK(durero_apply(again.get(), "ungroup g?=pair") == DURERO_DONE);
  CHECK(durero_apply(again.get(), "group g?=new elementos?=near") == DURERO_DONE);
  CHECK(durero_scene_write(again.get(), "no/such/folder/scene.json") == DURERO_FAILED);
  CHECK(std::string(durero_error()).starts_with("no/such/folder/scene.json: "));
}

TEST_CASE("a scene that is written into another folder names its pictures from there") {
  const auto folder = std::filesystem::temp_directory_path() / fmt::format("durero_test_{}", getpid());
  std::filesystem::create_directories(folder / "one");
  std::filesystem::create_directories(folder / "other");
  std::filesystem::copy_file(durero::test::source_dir() + "/docs/mirrors.png", folder / "one" / "wood.png");
  const auto first = (folder / "one" / "scene.json").string(), second = (folder / "other" / "scene.json").string();
  std::ofstream(first)
      << R"({"format":"durero-scene","version":1,"textures":{"wood":{"image":"wood.png"}},"elementos":[]})";
  const auto names = [](const std::string& path) {
    std::ostringstream text;
    text << std::ifstream(path).rdbuf();
    return text.str();
  };
  const Scene scene(durero_scene_read(first.c_str()), durero_scene_free);
  REQUIRE(scene);
  CHECK(durero_scene_write(scene.get(), second.c_str()) == DURERO_DONE);
  CHECK(names(second).find(R"("../one/wood.png")") != std::string::npos);
  CHECK(durero_scene_write(scene.get(), first.c_str()) == DURERO_DONE);  // nothing of the scene itself has changed
  CHECK(names(first).find(R"("wood.png")") != std::string::npos);
  const Scene again(durero_scene_read(second.c_str()), durero_scene_free);
  CHECK(again);
  std::filesystem::remove_all(folder);
}

TEST_CASE("an engine that follows groups searches by them, and no other does") {
  const Scene scene = two_spheres();
  REQUIRE(durero_apply(scene.get(), "Agregar_Esfera e?=far centro?=(0,0,9) radio?=1") == DURERO_DONE);
  REQUIRE(durero_apply(scene.get(), "group g?=pair elementos?=near,far") == DURERO_DONE);
  const Engine by_hand(durero_engine_new_by_hand(scene.get(), "bvh"), durero_engine_free);
  REQUIRE(by_hand);
  durero_hit hit;
  REQUIRE(durero_first_hits(by_hand.get(), &ahead, 1, &hit) == DURERO_DONE);
  CHECK(hit.t == 2);
  CHECK(hit.elements == 2);
  CHECK(durero_engine_new_by_hand(scene.get(), "fast") == nullptr);
  CHECK(std::string(durero_error()) == "hierarchy hand: fast follows no groups; expected engine bvh");
  CHECK(durero_engine_new_by_hand(scene.get(), "none") == nullptr);
  CHECK(std::string(durero_error()) == "no engine none");
}

TEST_CASE("rays are answered in order, with every element at the first point") {
  const Scene scene = two_spheres();
  for (const char* name : {static_cast<const char*>(nullptr), "exact", "analytic", "fast"}) {
    const Engine engine = engine_of(scene, name);
    REQUIRE(engine);
    const std::vector<durero_ray> rays{ahead, aside};
    std::vector<durero_hit> hits(2);
    REQUIRE(durero_first_hits(engine.get(), rays.data(), rays.size(), hits.data()) == DURERO_DONE);
    CHECK(hits[0].outcome == DURERO_HIT);
    CHECK(hits[0].t == 2);
    CHECK(hits[0].point[2] == 4);
    CHECK(hits[0].elements == 2);
    CHECK(hits[1].outcome == DURERO_MISS);
    CHECK(hits[1].elements == 0);
    char names[16]{};
    CHECK(durero_elements(engine.get(), &ahead, names, sizeof names) == 2);
    CHECK(std::string(names, 10) == std::string("near\0same\0", 10));
    char small[5]{};
    CHECK(durero_elements(engine.get(), &ahead, small, sizeof small) == 2);
    CHECK(std::string(small) == "near");
  }
}

TEST_CASE("what is no ray, no engine or no file fails with a line, and writes nothing") {
  const Scene scene = two_spheres();
  const Engine engine = engine_of(scene);
  const durero_ray nan{{0, 0, std::numeric_limits<double>::quiet_NaN()}, {0, 0, 1}}, still{{0, 0, 0}, {0, 0, 0}};
  for (const durero_ray& none : {nan, still}) {
    const durero_ray rays[]{ahead, none};
    durero_hit hits[2]{{DURERO_MISS, 7, 7, {}}, {DURERO_MISS, 7, 7, {}}};
    CHECK(durero_first_hits(engine.get(), rays, 2, hits) == DURERO_FAILED);
    CHECK(std::string(durero_error()) == "ray 1: no ray; expected finite numbers and v other than 0");
    CHECK(hits[0].elements == 7);
    CHECK(durero_elements(engine.get(), &none, nullptr, 0) == -1);
  }
  CHECK(engine_of(scene, "none") == nullptr);
  CHECK(std::string(durero_error()) == "no engine none");
  CHECK(durero_scene_read("no/such/file") == nullptr);
  CHECK(std::string(durero_error()).starts_with("no/such/file: "));
}

TEST_CASE("a scene that is read by a Z text is answered by the text, edited under it and written") {
  const std::string surfaces = durero::test::source_dir() + "/demo/surfaces/";
  const auto read = [&](const std::string& scene, const std::string& text) {
    return Scene(durero_scene_read_with((surfaces + scene).c_str(), text.c_str()), durero_scene_free);
  };
  const Scene scene = read("torus.json", surfaces + "torus.tex");
  REQUIRE(scene);
  const Engine engine = engine_of(scene);
  REQUIRE(engine);
  const durero_ray ray{{0, 0, 0}, {1, 0, 0}};
  durero_hit hit;
  REQUIRE(durero_first_hits(engine.get(), &ray, 1, &hit) == DURERO_DONE);
  CHECK(hit.outcome == DURERO_HIT);
  CHECK(durero_apply(scene.get(), "Agregar_Toro e?=wide centro?=(0,0,0) mayor?=1 menor?=2") == DURERO_REFUSED);
  CHECK(std::string(durero_error()) == "puntos_toro.dom: menor < mayor");
  CHECK(durero_apply(scene.get(), "Agregar_Toro e?=thin centro?=(0,0,0) mayor?=1 menor?=0.375") == DURERO_DONE);
  const Engine edited = engine_of(scene);
  REQUIRE(durero_first_hits(edited.get(), &ray, 1, &hit) == DURERO_DONE);
  CHECK(hit.t == 0.625);  // before the ball, which the ray leaves beyond 0.7
  const std::string path = std::filesystem::temp_directory_path() / fmt::format("durero_torus_{}.json", getpid());
  REQUIRE(durero_scene_write(scene.get(), path.c_str()) == DURERO_DONE);
  const Scene again(durero_scene_read_with(path.c_str(), (surfaces + "torus.tex").c_str()), durero_scene_free);
  std::filesystem::remove(path);
  REQUIRE(again);
  CHECK(durero_scene_size(again.get()) == durero_scene_size(scene.get()));
  CHECK_FALSE(engine_of(scene, "exact"));
  CHECK(durero_engine_new_by_hand(scene.get(), "bvh") == nullptr);
  CHECK_FALSE(read("torus.json", durero::test::source_dir() + "/spec/puntos.tex"));
  CHECK(std::string(durero_error()).find("torus.json:") != std::string::npos);
  CHECK_FALSE(read("torus.json", "none.tex"));
}
