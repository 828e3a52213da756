#include "durero/io/json/written_elements.hpp"

#include "durero/io/json/scene_file.hpp"
#include "io/malformed.hpp"
#include "support/catch.hpp"

using namespace durero;

namespace {

const std::vector<io::WrittenType> types{
    {"toro", {{"centro", io::WrittenKind::triple}, {"mayor", io::WrittenKind::number}}},
    {"prisma", {{"base", io::WrittenKind::three_points}}}};

scene::Scene read(const io::Source& source) {
  std::vector<io::WrittenElement> elements;
  return io::read_scene(source, types, elements);
}

std::string with(const std::string& elements) {
  return "{\"format\":\"durero-scene\",\"version\":1,\n\"elementos\":[" + elements + "]}";
}
std::string error_at(const std::string& elements) { return test::error_at_mark(with(elements), read); }

TEST_CASE("Elements of other types are read with their attributes, and stand in the scene by name and material") {
  const io::Source source("scene.json", R"({"format":"durero-scene","version":1,"materials":{"red":{"color":[1,0,0]}},
"elementos":[{"id":"a","tipo":"esfera","centro":[0,0,0],"radio":1},
{"mayor":2.5,"tipo":"toro","material":"red","id":"t","centro":[1,2,3]},
{"id":"p","tipo":"prisma","base":[[0,0,0],[1,0,0],[0,1,0]]}]})");
  std::vector<io::WrittenElement> elements;
  const scene::Scene scene = io::read_scene(source, types, elements);
  CHECK(scene.size() == 3);
  REQUIRE(elements.size() == 2);
  CHECK(elements[0].id == "t");
  CHECK(elements[0].type == 0);
  CHECK(std::get<glm::dvec3>(elements[0].values[0]) == glm::dvec3(1, 2, 3));
  CHECK(std::get<double>(elements[0].values[1]) == 2.5);
  CHECK(source.text().substr(elements[0].offsets[1], 3) == "2.5");
  CHECK(std::get<scene::Corners>(elements[1].values[0])[1] == glm::dvec3(1, 0, 0));
  CHECK(scene.material(*scene.find("t")) == 0U);
  CHECK_FALSE(scene.material(*scene.find("p")));
}

TEST_CASE("What is wrong in such an element is told at its place") {
  CHECK(error_at(R"(^{"id":"t","tipo":"toro","centro":[1,2,3]})") ==
        "key \"mayor\" (greater) is missing in an element of tipo toro; expected it");
  CHECK(error_at(R"({"id":"t","tipo":"toro","centro":[1,2,3],"mayor":1,^"radio":2})")
            .starts_with("unknown key \"radio\" in an element of tipo toro; expected "));
  CHECK(error_at(R"({"id":"t","tipo":"toro","centro":^7,"mayor":1})")
            .starts_with("centro (center) is a number; expected "));
  CHECK(error_at(R"({"id":^"a b","tipo":"toro","centro":[1,2,3],"mayor":1})").starts_with("id is \"a b\"; expected"));
  CHECK(error_at(R"({"id":"t","tipo":"prisma","base":[[0,0,0],[1,0,0],[0,1,0]]},
                    {"id":^"t","tipo":"toro","centro":[1,2,3],"mayor":1})")
            .starts_with("id is \"t\": elemento_ya_existe (element_already_exists); expected e? ∉ elementos"));
  CHECK(error_at(R"({"id":"t","tipo":^"tora","centro":[1,2,3],"mayor":1})") ==
        "tipo (type) is \"tora\"; expected toro");
  CHECK(error_at(R"({"id":"t","tipo":^"donut","centro":[1,2,3],"mayor":1})") ==
        "tipo (type) is \"donut\"; expected one of esfera (sphere), cilindro (cylinder), cono (cone), tronco "
        "(truncated_cone), plano (plane), disco (disc), triangulo (triangle), toro, prisma (prism)");
  CHECK(error_at(R"({"id":"t","tipo":"toro","centro":[1,2,3],"mayor":1,"material":^"blue"})") ==
        "unknown material \"blue\"; expected one of the scene's materials");
}

}  // namespace
