#include "durero/io/exported_files.hpp"

#include <filesystem>
#include <fstream>
#include <sstream>

#include "support/catch.hpp"
#include "support/folder.hpp"

using namespace durero;

namespace {

std::string contents_of(const std::string& path) {
  std::stringstream text;
  text << std::ifstream(path).rdbuf();
  return text.str();
}

}  // namespace

TEST_CASE("A text and the files beside it appear in its folder, and others stay as they are") {
  const test::Folder folder;
  io::write_file(folder.file("a.json"), "scene");
  io::ExportedFiles out(folder.file("a.xml"), folder.file("a.json"));
  CHECK_FALSE(std::filesystem::exists(folder.file("a.xml")));
  out.write({"text", {}, {{"a.mesh1.ply", "one"}, {"a.mesh2.ply", "two"}}});
  CHECK(contents_of(folder.file("a.xml")) == "text");
  CHECK(contents_of(folder.file("a.mesh1.ply")) == "one");
  CHECK(contents_of(folder.file("a.mesh2.ply")) == "two");
  CHECK(contents_of(folder.file("a.json")) == "scene");
  CHECK(folder.files() == 4);
}

TEST_CASE("Where one file cannot be written, or would be in the place of the scene, none is") {
  const test::Folder folder;
  io::write_file(folder.file("a.mesh2.ply"), "scene");
  std::filesystem::create_directories(folder.file("b.mesh2.ply"));
  std::filesystem::create_symlink("a.mesh2.ply", folder.file("link.ply"));
  const auto before = folder.files();
  const auto write = [&](const std::string& name, const std::string& from) {
    io::ExportedFiles(folder.file(name + ".xml"), folder.file(from))
        .write({"text", {}, {{name + ".mesh1.ply", "one"}, {name + ".mesh2.ply", "two"}}});
  };
  const std::string in_place =
      ": the scene itself is in the place of a file that goes with its export; expected another "
      "name to export to";
  CHECK_THROWS_WITH(write("a", "a.mesh2.ply"), folder.file("a.mesh2.ply") + in_place);
  CHECK_THROWS_WITH(write("a", "link.ply"), folder.file("a.mesh2.ply") + in_place);
  CHECK_THROWS_AS(write("b", "a.mesh2.ply"), io::FileError);
  CHECK(folder.files() == before);
  CHECK(contents_of(folder.file("a.mesh2.ply")) == "scene");
}
