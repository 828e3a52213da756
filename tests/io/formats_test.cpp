#include "durero/io/formats.hpp"

#include <set>

#include "random_scene.hpp"
#include "support/catch.hpp"

using namespace durero;

TEST_CASE("A file's name tells its format") {
  CHECK(io::format_of("a.json").ending == ".json");
  CHECK(io::format_of("folder.json/a.nff").ending == ".nff");
  CHECK_THROWS_WITH(io::format_of("a.nff.obj"),
                    "a.nff.obj: a format that is not known by this name; expected one that ends in .json or .nff");
  CHECK_THROWS_AS(io::format_of("json"), io::FileError);
  CHECK(io::format_endings() == ".json or .nff");
}

TEST_CASE("Each format has an ending of its own, and reads the elements that it writes") {
  scene::Scene scene;
  scene.apply(model::Agregar_Esfera{model::Elemento{"s1"}, model::Punto{1, 2, 3}, 4});
  std::set<std::string_view> endings;
  for (const io::Format& format : io::formats()) {
    INFO(format.ending);
    CHECK(endings.insert(format.ending).second);
    const io::Imported back = format.read(io::Source("f", format.write(scene).text));
    CHECK(test::described(back.scene) == test::described(scene));
    CHECK(back.lost.empty());
  }
}
