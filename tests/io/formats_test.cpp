#include "durero/io/formats.hpp"

#include <filesystem>
#include <set>

#include "durero/io/output_file.hpp"
#include "durero/model/operaciones.hpp"
#include "durero/scene/stage.hpp"
#include "random_scene.hpp"
#include "support/catch.hpp"
#include "support/folder.hpp"

using namespace durero;

TEST_CASE("A file's name tells its format") {
  CHECK(io::format_to_read("a.json").ending == ".json");
  CHECK(io::format_to_read("folder.json/a.nff").ending == ".nff");
  CHECK(io::format_to_write("a.nff").ending == ".nff");
  CHECK(io::format_to_read("a.ply").ending == ".ply");
  CHECK_THROWS_WITH(io::format_to_read("a.nff.step"),
                    "a.nff.step: a format that is not known by this name; expected one that ends in .glb or .gltf or "
                    ".json or .nff or .obj or .pbrt or .ply or .pov or .rad or .stl or .xml");
  CHECK(io::format_to_read("A.GLB").ending == ".glb");
  CHECK(io::format_to_write_bytes("a.Stl").ending == ".stl");
  CHECK_THROWS_WITH(io::format_to_write_bytes("a.obj"),
                    "a.obj: no format with a binary form by this name; expected one that ends in .glb or .ply or .stl");
  CHECK(io::format_to_write("a.gltf").ending == ".gltf");
  CHECK_THROWS_AS(io::format_to_read("json"), io::FileError);
  CHECK(io::format_to_read("a.pov").ending == ".pov");
  CHECK(io::format_to_read("folder/A.POV").ending == ".pov");
  CHECK(io::format_to_write("A.Nff").ending == ".nff");
  CHECK(io::format_to_write("a.pov").ending == ".pov");
  CHECK_THROWS_WITH(io::format_to_write("a.npy"),
                    "a.npy: a format that is not known by this name; expected one that ends in .glb or .gltf or "
                    ".json or .nff or .obj or .pbrt or .ply or .pov or .rad or .stl or .xml");
}

TEST_CASE("A file is read with the files below its folder, or below a root") {
  const test::Folder folder;
  std::filesystem::create_directories(folder.file("a/b"));
  io::write_file(folder.file("a/set.inc"), "#declare R = 2;");
  io::write_file(folder.file("a/b/ball.pov"), "#include \"../set.inc\" sphere { 0, R }");
  const std::string ball = folder.file("a/b/ball.pov");
  CHECK_THROWS_WITH(io::read_any_format(ball), Catch::Matchers::Contains("no file \"../set.inc\""));
  CHECK(io::read_any_format(ball, {folder.file("a")}).scene.size() == 1);
  CHECK_THROWS_WITH(io::read_any_format(ball, {folder.file("c")}), folder.file("c") + ": no folder; expected one");
  CHECK_THROWS_WITH(io::read_any_format(folder.file("a/set.pov"), {folder.file("a")}),
                    Catch::Matchers::Contains("No such file"));
  std::filesystem::create_directory(folder.file("c"));
  CHECK_THROWS_WITH(io::read_any_format(ball, {folder.file("c")}),
                    ball + ": lies elsewhere; expected a file in \"" + folder.file("c") + "\" or beneath it");
}

TEST_CASE("Each format has an ending of its own, and where it is written reads the elements that it writes") {
  scene::Scene scene;
  scene.apply(model::Agregar_Esfera{model::Elemento{"s1"}, model::Punto{1, 2, 3}, 4});
  scene.stage().materials = {{"f1", glm::dvec3(0.8)}};
  scene.set_material(*scene.find("s1"), 0);
  scene::Scene mesh;
  mesh.apply(model::Agregar_Triangulo{model::Elemento{"f:1"}, {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}});
  std::set<std::string_view> endings;
  std::size_t written = 0;
  for (const io::Format& format : io::formats()) {
    INFO(format.ending);
    CHECK(endings.insert(format.ending).second);
    if (format.write == nullptr && format.write_with_files == nullptr) continue;
    ++written;
    REQUIRE(format.read != nullptr);
    const bool is_of_meshes = format.ending == ".obj" || format.ending == ".ply" || format.ending == ".stl" ||
                              format.ending == ".gltf" || format.ending == ".glb";
    const scene::Scene& some = is_of_meshes ? mesh : scene;
    const io::Imported back =
        format.read(io::Source("f", io::exported_scene("f" + std::string(format.ending), some, {}).text));
    CHECK(test::described(back.scene) == test::described(some));
    // An STL must have normals, and pbrt's sphere is put in its place.
    CHECK(back.lost.empty() == (format.ending != ".stl" && format.ending != ".pbrt"));
  }
  CHECK(written == 11);
}
