// POV-Ray's surfaces that are the zeros of a polynomial, as elements of types that a Z text declares.
#include "durero/io/pov/algebraic.hpp"

#include <algorithm>

#include "durero/io/pov/pov.hpp"
#include "support/catch.hpp"

using namespace durero;

namespace {

io::Imported import_text(const std::string& text) {
  io::Source source("f", text + "\n#version 3.7;");
  source.set_keeps_surfaces(true);
  return io::read_pov(source);
}

const io::WrittenElement& only_surface(const io::Imported& read) {
  REQUIRE(read.surfaces.size() == 1);
  REQUIRE(read.scene.find(read.surfaces.begin()->first));
  return read.surfaces.begin()->second;
}

/// The value of the attribute of that word.
template <class Value>
Value value_of(const io::WrittenElement& element, const std::string& word) {
  const auto& attributes = io::algebraic_types()[element.type].attributes;
  const auto at = std::ranges::find(attributes, word, &io::WrittenAttribute::word);
  REQUIRE(at != attributes.end());
  return std::get<Value>(element.values.at(static_cast<std::size_t>(at - attributes.begin())));
}

using Triple = glm::dvec3;

}  // namespace

TEST_CASE("A torus has its radii, and the place that its transformations give it") {
  const io::Imported read = import_text("torus { 2, 0.5 scale <1, 2, -1> translate <4, 5, 6> pigment { rgb 1 } }");
  const io::WrittenElement& ring = only_surface(read);
  CHECK(ring.type == io::moved_torus);
  CHECK(value_of<double>(ring, "mayor") == 2);
  CHECK(value_of<double>(ring, "menor") == 0.5);
  CHECK(value_of<Triple>(ring, "centro") == Triple(4, 5, 6));
  CHECK(value_of<Triple>(ring, "x") == Triple(1, 0, 0));
  CHECK(value_of<Triple>(ring, "y") == Triple(0, 2, 0));
  CHECK(value_of<Triple>(ring, "z") == Triple(0, 0, -1));
  CHECK(read.scene.material(*read.scene.find(ring.id)));
}

TEST_CASE("The coefficients of each degree stand where a quartic has them") {
  std::string numbers = "1";
  for (int i = 2; i <= 35; ++i) numbers += ", " + std::to_string(i);
  for (const std::string& text : {"quartic { <" + numbers + "> sturm }", "poly { 4, <" + numbers + "> }"}) {
    const io::Imported read = import_text(text);
    const io::WrittenElement& surface = only_surface(read);
    CHECK(surface.type == io::quartic);
    CHECK(value_of<double>(surface, "xxxx") == 1);
    CHECK(value_of<Triple>(surface, "xxx") == Triple(2, 3, 4));
    CHECK(value_of<Triple>(surface, "xx_2") == Triple(8, 9, 10));
    CHECK(value_of<Triple>(surface, "x_1") == Triple(11, 12, 13));
    CHECK(value_of<double>(surface, "x_4") == 20);
    CHECK(value_of<Triple>(surface, "c_1") == Triple(21, 22, 23));
    CHECK(value_of<Triple>(surface, "c_5") == Triple(33, 34, 35));
  }
  // x³ is the fourth of the 35, and y·z² the twenty-eighth: y³z⁰ and what follows stand behind y⁴.
  const io::Imported cubic = import_text("cubic { <1,0,0,0,0,0,0,0,0,0, 0,0,0,7,0,0,0,0,0,9> }");
  CHECK(value_of<Triple>(only_surface(cubic), "xxx") == Triple(0, 0, 1));
  CHECK(value_of<Triple>(only_surface(cubic), "c_3") == Triple(0, 7, 0));
  CHECK(value_of<Triple>(only_surface(cubic), "c_5") == Triple(0, 0, 9));
  const io::Imported quadric = import_text("quadric { <1, 2, 3>, <4, 5, 6>, <7, 8, 9>, 10 }");
  const io::WrittenElement& of_two = only_surface(quadric);
  CHECK(value_of<Triple>(of_two, "xx_2") == Triple(0, 0, 1));  // x²
  CHECK(value_of<Triple>(of_two, "x_2") == Triple(0, 0, 4));   // x·y
  CHECK(value_of<Triple>(of_two, "x_3") == Triple(0, 0, 5));   // x·z
  CHECK(value_of<double>(of_two, "x_4") == 7);                 // x
  CHECK(value_of<Triple>(of_two, "c_2") == Triple(0, 0, 2));   // y²
  CHECK(value_of<Triple>(of_two, "c_3") == Triple(0, 0, 6));   // y·z
  CHECK(value_of<Triple>(of_two, "c_4") == Triple(8, 0, 0));   // y
  CHECK(value_of<Triple>(of_two, "c_5") == Triple(3, 9, 10));  // z², z and one
}

TEST_CASE("Surfaces stand in groups, but in no solid, and above degree four in no scene") {
  const io::Imported read = import_text(
      "union { torus { 1, 0.25 } sphere { 0, 1 } } difference { sphere { 0, 1 } torus { 1, 0.5 } }\n"
      "poly { 2, <1,0,0,0,1,0,0,1,0,-1> }");
  CHECK(read.surfaces.size() == 2);
  CHECK(read.groups.table().contains("u1"));
  CHECK(std::ranges::count(read.lost, "1 solid left out: a part of it bounds nothing that a scene has") == 1);
}

TEST_CASE("Of a torus that passes through itself all parts are kept, or none") {
  for (const std::string& all : {"union", "difference", ""})
    CHECK(import_text("torus { 0.5, 1 " + all + " pigment { rgb 1 } }").surfaces.size() == 1);
  for (const std::string& part : {"merge", "intersection"}) {
    const io::Imported read =
        import_text("torus { 0.5, 1 " + part + " pigment { rgb 1 } } torus { 1, 0.5 " + part + " }");
    CHECK(read.surfaces.size() == 1);
    CHECK(std::ranges::count(read.lost, "1 torus that passes through itself, in part, left out: a scene has none") ==
          1);
  }
}
