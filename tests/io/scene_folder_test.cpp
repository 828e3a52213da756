#include "io/scene_folder.hpp"

#include <filesystem>

#include "durero/io/output_file.hpp"
#include "support/catch.hpp"
#include "support/folder.hpp"

using namespace durero;
namespace fs = std::filesystem;

namespace {

/// A folder `sets` with a file, and in it the folder `room` of a scene, which has a folder `meshes`.
struct Sets {
  Sets() {
    fs::create_directories(folder.file("sets/room/meshes"));
    for (const char* name : {"outer", "sets/common", "sets/room/own", "sets/room/meshes/part", "sets/room/meshes/own"})
      io::write_file(folder.file(name), name);
  }
  io::Source scene(const std::string& root = "") const {
    io::Source source(folder.file("sets/room/scene.xml"), "");
    source.set_root(root.empty() ? "" : folder.file(root));
    return source;
  }
  test::Folder folder;
};

}  // namespace

TEST_CASE("A scene names the files below its folder") {
  const Sets sets;
  const io::Source scene = sets.scene();
  const io::SceneFolder folder(scene);
  CHECK(folder.holds_scene());
  CHECK(folder.find(scene, "own") == sets.folder.file("sets/room/own"));
  CHECK(folder.find(scene, "meshes/part") == sets.folder.file("sets/room/meshes/part"));
  CHECK(folder.find(scene, "meshes/../own") == sets.folder.file("sets/room/own"));
  CHECK_FALSE(folder.find(scene, "part"));
  CHECK_FALSE(folder.find(scene, "../common"));
  CHECK_FALSE(folder.find(scene, "meshes/../../common"));
  CHECK_FALSE(folder.find(scene, sets.folder.file("sets/room/own")));
  CHECK_FALSE(folder.find(scene, ""));
  CHECK_FALSE(folder.find(scene, "meshes"));
  CHECK_FALSE(folder.find(scene, std::string("own\0.obj", 8)));
  CHECK(folder.path(scene, "none") == sets.folder.file("sets/room/none"));
  CHECK_FALSE(folder.path(scene, "../none"));
  CHECK(folder.expected() == "expected a file in the folder of the scene or beneath it");
}

TEST_CASE("A file is searched beside the one that names it, in added folders, and beside the scene") {
  const Sets sets;
  const io::Source scene = sets.scene(), part(sets.folder.file("sets/room/meshes/part"), "");
  io::SceneFolder folder(scene);
  CHECK(folder.find(part, "own") == sets.folder.file("sets/room/meshes/own"));
  CHECK(folder.find(part, "scene.xml") == std::nullopt);
  CHECK(folder.find(part, "meshes/part") == sets.folder.file("sets/room/meshes/part"));
  CHECK(folder.add(scene, "meshes"));
  CHECK(folder.find(scene, "part") == sets.folder.file("sets/room/meshes/part"));
  CHECK(folder.find(scene, "own") == sets.folder.file("sets/room/own"));
  CHECK_FALSE(folder.add(scene, ".."));
  CHECK_FALSE(folder.find(scene, "common"));
}

TEST_CASE("A root above the scene's folder bounds the files that it names") {
  const Sets sets;
  const io::Source scene = sets.scene("sets");
  io::SceneFolder folder(scene);
  CHECK(folder.holds_scene());
  CHECK(folder.find(scene, "../common") == sets.folder.file("sets/common"));
  CHECK(folder.find(scene, "own") == sets.folder.file("sets/room/own"));
  CHECK_FALSE(folder.find(scene, "common"));
  CHECK_FALSE(folder.find(scene, "../../outer"));
  CHECK(folder.add(scene, ".."));
  CHECK(folder.find(scene, "common") == sets.folder.file("sets/common"));
  CHECK(folder.expected() == "expected a file in \"" + sets.folder.file("sets") + "\" or beneath it");
  CHECK_FALSE(io::SceneFolder(sets.scene("sets/room/meshes")).holds_scene());
}

TEST_CASE("A folder of a scene may be told from where the program runs") {
  const io::Source scene("scene.pov", "");
  const io::SceneFolder folder(scene);
  CHECK(folder.path(scene, "a/b.inc") == "a/b.inc");
  CHECK_FALSE(folder.path(scene, "../b.inc"));
  io::Source within("a/scene.pov", "");
  within.set_root(".");
  CHECK(io::SceneFolder(within).path(within, "../b.inc") == "b.inc");
  CHECK_FALSE(io::SceneFolder(within).path(within, "../../b.inc"));
}

TEST_CASE("A folder has the files below it") {
  const Sets sets;
  CHECK(io::file_below(sets.folder.file("sets"), "room/own") == sets.folder.file("sets/room/own"));
  CHECK_FALSE(io::file_below(sets.folder.file("sets/room"), "../common"));
}
