#include "durero/io/rays/proximities_file.hpp"

#include <limits>

#include "support/catch.hpp"
#include "support/shapes.hpp"

using namespace durero;
using scene::NearestCount;
using scene::Proximity;

TEST_CASE("The answers for points, in JSON and in NumPy's format") {
  scene::Scene scene;
  const auto b = test::add(scene, model::Elemento("b"), scene::Sphere{{0, 0, 0}, 1}),
             a = test::add(scene, model::Elemento("a"), scene::Disc{{0, 0, 1}, 1, {0, 0, 1}});
  const Proximity one{NearestCount::one, 0.1, {0, -0.5, 1}, {b}}, many{NearestCount::many, 2, {-1, 0, 0}, {b, a}};
  CHECK(io::proximity_text(3, one, scene) ==
        R"({"point":3,"count":"one","elementos":["b"],"distance":0.1,"nearest":[0,-0.5,1]})");
  CHECK(io::proximity_text(0, many, scene, -2.0) ==
        R"({"point":0,"count":"many","elementos":["a","b"],"distance":2,"nearest":[-1,0,0],"signed":-2})");
  CHECK(io::proximity_text(1, Proximity{}, scene) == R"({"point":1,"count":"none","elementos":[]})");
  const double infinity = std::numeric_limits<double>::infinity();
  CHECK(io::proximity_text(1, {NearestCount::one, infinity, {0, 0, 0}, {a}}, scene).find(R"("distance":"inf")") !=
        std::string::npos);

  const std::string npy = io::proximities_npy(std::vector{one, many, Proximity{}}, scene);
  CHECK(npy.find("('count', 'S4'), ('distance', '<f8'), ('nearest', '<f8', (3,)), ('elementos', 'S3')") !=
        std::string::npos);
  CHECK(npy.find("'shape': (3,)") != std::string::npos);
  constexpr std::size_t row = 4 + 4 * 8 + 3;
  const std::string rows = npy.substr(npy.size() - 3 * row);
  CHECK(rows.substr(0, 4) == std::string("one\0", 4));
  CHECK(rows.substr(row - 3, 3) == std::string("b\0\0", 3));
  CHECK(rows.substr(row, 4) == "many");
  CHECK(rows.substr(2 * row - 3, 3) == "a,b");
  CHECK(io::word(NearestCount::none) == "none");
}
