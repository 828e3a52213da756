// Snapshots: whatever a scene holds, its snapshot gives it back, and each cut or longer one is refused.
#include "store/snapshot.hpp"

#include <filesystem>

#include "durero/io/source.hpp"
#include "kept.hpp"
#include "support/catch.hpp"
#include "support/scenes.hpp"
#include "support/tree.hpp"

using namespace durero;
using test::text_of;

namespace {

scene::GroupedScene again(const scene::GroupedScene& of) {
  const std::string snapshot = store::snapshot_of(of);
  scene::GroupedScene read = store::scene_of(snapshot, "s");
  CHECK(store::snapshot_of(read) == snapshot);
  return read;
}

}  // namespace

TEST_CASE("Every scene of the demonstration comes back from its snapshot") {
  int count = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(test::source_dir() + "/demo")) {
    if (entry.path().extension() != ".json" || entry.path().parent_path().filename() == "surfaces") continue;
    INFO(entry.path());
    const scene::GroupedScene of = io::read_grouped_scene(io::read_source(entry.path()), io::Bodies::read);
    CHECK(text_of(again(of)) == text_of(of));
    ++count;
  }
  CHECK(count > 20);
}

TEST_CASE("Random scenes of all shapes come back from their snapshots, with groups and meshes") {
  test::Random random(7);
  for (std::size_t size : {0, 1, 2, 40, 500}) {
    scene::GroupedScene of{test::random_scene(random, size), {}};
    if (size > 1) of.apply_total(scene::Grouping{"pair", {{"e0", "e1"}, {}}});
    of.apply_total(scene::MeshEdit(scene::MeshAddition{
        {model::Elemento("m"), std::vector<glm::dvec3>{{0, 0, 9}, {1, 0, 9}, {0, 1, 9}}, {{0, 1, 2}}}}));
    CHECK(text_of(again(of)) == text_of(of));
  }
}

TEST_CASE("A snapshot that is cut, longer or changed where it says how many is refused") {
  test::Random random(8);
  const std::string whole = store::snapshot_of({test::random_scene(random, 12), {}});
  for (std::size_t size = 0; size < whole.size(); ++size)
    CHECK_THROWS_AS(store::scene_of(whole.substr(0, size), "s"), std::runtime_error);
  CHECK_THROWS_AS(store::scene_of(whole + '\0', "s"), io::FileError);
  std::string longer = whole;
  longer[0] = static_cast<char>(longer[0] + 1);
  CHECK_THROWS_AS(store::scene_of(longer, "s"), std::runtime_error);
}
