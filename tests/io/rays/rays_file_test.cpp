#include "durero/io/rays/rays_file.hpp"

#include <fmt/format.h>

#include <limits>

#include "durero/io/lines.hpp"
#include "durero/io/rays/npy.hpp"
#include "durero/model/operaciones.hpp"
#include "io/arriving.hpp"
#include "io/malformed.hpp"
#include "io/random_scene.hpp"
#include "support/catch.hpp"
#include "support/property.hpp"

using namespace durero;

namespace {

scene::Scene three_spheres() {
  scene::Scene scene;
  for (const char* name : {"a", "b", "c"}) {
    scene.apply(model::Agregar_Esfera{model::Elemento{name}, model::Punto{0, 0, 0}, 1});
  }
  return scene;
}

std::vector<io::Ray> read(const std::string& text) { return io::read_rays(io::Source("f", text), three_spheres()); }
std::string error_at(const std::string& with_mark) {
  return test::error_at_mark(with_mark, [](const io::Source& s) { return io::read_rays(s, three_spheres()); });
}

io::Ray any_ray(const scene::Scene& scene) {
  glm::dvec3 v = test::any_triple();
  if (v == glm::dvec3{}) v.z = 1;
  io::Ray ray{{model::Punto{test::any_triple()}, model::Vector{v}}};
  for (const char* name : {"a", "b", "c"}) {
    if (*rc::gen::arbitrary<bool>()) ray.en.push_back(scene.find(name).value());
  }
  std::sort(ray.en.begin(), ray.en.end());
  return ray;
}

// The rays of an input as they come, and what ends it where that is an error.
struct Arrived {
  std::vector<io::Ray> rays;
  std::string error;
};

Arrived arrived(io::Input& input, const scene::Scene& scene) {
  Arrived all;
  std::vector<io::Ray> rays;
  try {
    io::RayReader reader(input, scene);
    while (reader.next(rays)) all.rays.insert(all.rays.end(), rays.begin(), rays.end());
  } catch (const io::InputError& error) {
    all.error = error.what();
  }
  return all;
}

}  // namespace

TEST_CASE("Rays read back from their text and from .npy") {
  test::property("any rays", [] {
    const scene::Scene scene = three_spheres();
    std::vector<io::Ray> rays;
    for (int n = *rc::gen::inRange(0, 5); n > 0; --n) rays.push_back(any_ray(scene));
    RC_ASSERT(io::read_rays(io::Source("f", io::rays_text(rays, scene)), scene) == rays);
    for (io::Ray& ray : rays) ray.en.clear();
    RC_ASSERT(io::read_rays(io::Source("f.npy", io::rays_npy(rays)), scene) == rays);
  });
}

TEST_CASE("Numbers are decimal or hexadecimal; comments, blank lines and repeated names mean nothing") {
  const auto rays = read("# rays\n\n 1 -2.5 +3e1\t0x1p-1 -0X1.8P+1 .5 # right\r\n0 0 0 1 0 0 @b @a @b");
  REQUIRE(rays.size() == 2);
  CHECK(rays[0].rayo == model::Rayo({1, -2.5, 30}, {0.5, -3, 0.5}));
  CHECK(rays[0].en.empty());
  CHECK(rays[1].en == scene::ElementSet{{model::Tipo::soy_esfera, 0}, {model::Tipo::soy_esfera, 1}});
  CHECK(read("").empty());
}

TEST_CASE("Rays stand one a line, however the lines end") {
  const auto rays = read("# rays\n0 0 0 1 0 0\n\n0 0 0 0 1 0 # up\n0 0 0 0 0 1\n");
  CHECK(rays.size() == 3);
  CHECK(read("# rays\r0 0 0 1 0 0\r\r0 0 0 0 1 0 # up\r0 0 0 0 0 1\r") == rays);
  CHECK(read("# rays\r\n0 0 0 1 0 0\r\n\r\n0 0 0 0 1 0 # up\r\n0 0 0 0 0 1") == rays);
  CHECK(error_at("# a\r0 0 0 1 0 0\r\n0 0 ^x 1 0 0") == "\"x\" in a ray; expected a finite number");
}

TEST_CASE("A malformed ray is an error with its place") {
  using Case = std::pair<std::string, std::string>;
  const Case cases[] = {
      {"0 0 0 ^0 -0 0", "v is (0, 0, 0); expected ¬ (v.x = 0 ∧ v.y = 0 ∧ v.z = 0) (Rayo.inv.1)"},
      {"0 0 0 0 0 1\n0 ^nan 0 0 0 1", "\"nan\" in a ray; expected a finite number"},
      {"0 0 0 0 0 ^-inf", "\"-inf\" in a ray; expected a finite number"},
      {"0 0 ^1e999 0 0 1", "\"1e999\" in a ray; expected a finite number"},
      {"0 0 0 1 0^", "the ray ends after 5 numbers; expected px py pz vx vy vz"},
      {"0 0 0 1 0 ^# 0", "the ray ends after 5 numbers; expected px py pz vx vy vz"},
      {"0 0 0 1 0 ^@a", "\"@a\" in a ray; expected a finite number"},
      {"0 0 0 1 0 0 ^7", "\"7\" after six numbers; expected @name"},
      {"0 0 0 1 0 0 @a ^@d", "no element \"d\"; expected an element of the scene"},
      {"0 0 0 1 0 0 ^@", "no element \"\"; expected an element of the scene"},
  };
  for (const auto& [text, expected] : cases) {
    INFO(text);
    CHECK(error_at(text) == expected);
  }
  CHECK(error_at("^0,0,0,1,0,0") == "\"0,0,0,1,0,0\" in a ray; expected a finite number");
}

TEST_CASE("A wrong ray of a .npy file is named by its row and number") {
  const auto error = [](std::vector<double> values) {
    std::string text = io::npy_head("'<f8'", fmt::format("({}, 6)", values.size() / 6));
    for (const double x : values) io::append_binary64(text, x);
    return test::error_of(text, [](const io::Source& s) { return io::read_rays(s, three_spheres()); });
  };
  const double nan = std::numeric_limits<double>::quiet_NaN();
  CHECK(error({0, 0, 0, 1, 0, 0}).empty());
  CHECK(error({0, 0, 0, 1, 0, 0, 0, 0, nan, 1, 0, 0}) == "f:2:3: nan; expected a finite number");
  CHECK(error({0, 0, 0, 0, 0, 0}).starts_with("f:1:4: v is (0, 0, 0); expected "));
  CHECK_THROWS_WITH(io::read_rays(io::Source("rays.npy", "0 0 0 1 0 0"), three_spheres()),
                    Catch::Contains("rays.npy:1:1: no NumPy file"));
}

TEST_CASE(
    "A direction that is null breaks a clause of the text, which the error names; what is malformed breaks none") {
  const auto broken = [](const std::string& name, const std::string& text) -> const contract::clause* {
    try {
      io::read_rays(io::Source(name, text), three_spheres());
    } catch (const io::InputError& error) {
      return error.broken();
    }
    throw std::logic_error("nothing is wrong with " + text);
  };
  std::string table = io::npy_head("'<f8'", "(1, 6)");
  for (int i = 0; i < 6; ++i) io::append_binary64(table, 0);
  CHECK(broken("f", "0 0 0 0 0 0") == &model::Rayo_inv_1);
  CHECK(broken("f.npy", table) == &model::Rayo_inv_1);
  CHECK(broken("f", "0 0 0 1 0") == nullptr);
  CHECK(broken("f.npy", table.substr(1)) == nullptr);
}

TEST_CASE("A file of rays is known by its beginning, so that no one takes it for a scene") {
  const auto begins = [](const std::string& text) { return io::begins_as_rays(io::Source("f", text)); };
  CHECK(begins("0 0 0 0 0 1\n"));
  CHECK(begins("# rays\n\n  -0x1p3 0 0 0 0 1\n"));
  CHECK(begins("1e3#"));
  CHECK(begins(io::rays_npy({})));
  for (const char* const text : {"", "\n", "# 1 2 3", "{\"format\":1}", " \n{", "[1]", "x 1", "\xEF\xBB\xBF{}"}) {
    CAPTURE(text);
    CHECK_FALSE(begins(text));
  }
}

TEST_CASE("No damage to rays does worse than an error") {
  const auto reading = [](const io::Source& s) { return io::read_rays(s, three_spheres()); };
  const std::string text = "# rays\n0 1.5 -2e3 0x1.8p3 0 1 @a @b\n1 2 3 4 5 6\n";
  CHECK(test::refused_after_damage(text, 20000, reading) > 5000);
  const scene::Scene scene = three_spheres();
  const std::string npy = io::rays_npy(read(text));
  CHECK(test::refused_after_damage(npy, 20000, reading) > 5000);
}

TEST_CASE("Rays that arrive in blocks are the rays, and an error keeps its place and its words") {
  test::property("any lines, any blocks", [] {
    const scene::Scene scene = three_spheres();
    const auto line = rc::gen::element<std::string>("0 0 0 1 0 0", "-2.5 0x1p3 1e3 0 1 0 @b @a", "# ñandú ∉", "", " \t",
                                                    "1 2 3 4 5 6 # ∉", "0 0 0 1 0", "0 0 0 0 0 0", "ñ 0 0 1 0 0");
    const auto end = rc::gen::element<std::string>("\n", "\r\n", "\r");
    std::string text;
    for (const auto& [l, e] :
         *rc::gen::container<std::vector<std::pair<std::string, std::string>>>(rc::gen::pair(line, end)))
      text += l + e;
    if (*rc::gen::arbitrary<bool>()) text += *line;
    std::vector<io::Ray> whole;
    const std::string error =
        test::error_of(text, [&](const io::Source& source) { whole = io::read_rays(source, scene); });
    io::Input input("f", test::file_of(text), *rc::gen::inRange<std::size_t>(1, 40)), at_once("f", test::file_of(text));
    const Arrived all = arrived(input, scene);
    RC_ASSERT(all.error == error);
    RC_ASSERT(all.rays == arrived(at_once, scene).rays);
    if (error.empty()) RC_ASSERT(all.rays == whole);
  });
}

TEST_CASE("The rays before a bad one are given, and then the error") {
  const scene::Scene scene = three_spheres();
  const std::string good = "0 0 0 1 0 0\n# two\n1 0 0 1 0 0\n";
  io::Input input("f", test::file_of(good + "x\n2 0 0 1 0 0\n"));
  const Arrived all = arrived(input, scene);
  CHECK(all.rays == read(good));
  CHECK(all.error == "f:4:1: \"x\" in a ray; expected a finite number");
}

TEST_CASE("Rays of .npy that arrive in blocks are the rays, and an error keeps its place") {
  const scene::Scene scene = three_spheres();
  std::string npy = io::rays_npy(read("0 0 0 1 0 0\n1 2 3 4 5 6\n0 1 0 0 0 1\n"));
  const auto whole = io::read_rays(io::Source("f.npy", npy), scene);
  std::string wrong = npy.substr(0, npy.size() - 8);
  io::append_binary64(wrong, std::numeric_limits<double>::infinity());
  for (const std::size_t block : {1U, 7U, 8U, 48U, 50U, 1000U}) {
    io::Input input("f.npy", test::file_of(npy), block);
    CHECK(arrived(input, scene).rays == whole);
    io::Input bad("f.npy", test::file_of(wrong), block);
    const Arrived all = arrived(bad, scene);
    CHECK(all.rays == std::vector<io::Ray>(whole.begin(), whole.begin() + 2));
    CHECK(all.error == "f.npy:3:6: inf; expected a finite number");
  }
}

TEST_CASE("A ray is read when its line has come, whatever ends the line") {
  const scene::Scene scene = three_spheres();
  test::Pipe pipe;
  io::Input input("p", pipe.out());
  pipe.write("0 0 0 1 0 0\n1 0 ");
  io::RayReader reader(input, scene);
  std::vector<io::Ray> rays;
  REQUIRE(reader.next(rays));
  CHECK(rays == read("0 0 0 1 0 0"));
  pipe.write("0 0 0 1\r");
  REQUIRE(reader.next(rays));
  CHECK(rays == read("1 0 0 0 0 1"));
  pipe.write("\n2 0 0 0 0 1 @a\r");
  do {
    REQUIRE(reader.next(rays));
  } while (rays.empty());
  CHECK(rays == read("2 0 0 0 0 1 @a"));
  pipe.write("3 0 0 0 0 x\r\n");
  CHECK_THROWS_WITH(reader.next(rays), "p:4:11: \"x\" in a ray; expected a finite number");
}

TEST_CASE("Of a line that does not end no more is read than a line may have") {
  const scene::Scene scene = three_spheres();
  test::Blanks endless("0 0 0 1 0 0\n");
  {
    io::Input input("p", endless.out());
    const Arrived all = arrived(input, scene);
    CHECK(all.rays == read("0 0 0 1 0 0"));
    CHECK_THAT(all.error, Catch::StartsWith("p:2:16777217: a line of more than 16777216 bytes; expected"));
  }
  CHECK(endless.count() < io::longest_line + 2 * io::Input::usual_block);
}
