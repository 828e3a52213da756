#include "durero/render/texture/texture.hpp"

#include <array>
#include <cmath>
#include <numbers>
#include <random>

#include "durero/model/operaciones.hpp"
#include "durero/render/light/whitted.hpp"
#include "durero/render/render.hpp"
#include "durero/scene/stage.hpp"
#include "support/catch.hpp"

using namespace durero;
using render::texture_at;
using render::WrapModes;
using scene::Edges;
using scene::Filter;
using scene::Pattern;
using scene::TexelImage;
using scene::Texture;

namespace {

const glm::dvec3 white(1);
const glm::dvec3 black(0);

/// Texel (j, k) is (j, k, 0)/8.
TexelImage numbered(std::uint32_t width, std::uint32_t height) {
  TexelImage picture{width, height};
  for (std::uint32_t k = 0; k < height; ++k)
    for (std::uint32_t j = 0; j < width; ++j) picture.texels.emplace_back(j / 8.0, k / 8.0, 0);
  return picture;
}

/// Squares of so many texels, black and white.
TexelImage checker(std::uint32_t side, std::uint32_t square) {
  TexelImage picture{side, side};
  for (std::uint32_t k = 0; k < side; ++k)
    for (std::uint32_t j = 0; j < side; ++j) picture.texels.emplace_back((j / square + k / square) % 2);
  return picture;
}

Texture image(const TexelImage& picture, Filter filter, double near = 1) {
  Texture texture{.pattern = Pattern::image, .filter = filter};
  texture.image.levels = std::make_shared<const std::vector<TexelImage>>(
      filter == Filter::mipmap ? scene::mipmap(picture) : std::vector<TexelImage>{picture});
  if (filter == Filter::mipmap) texture.near = near;
  return texture;
}

Texture rule(Pattern pattern) { return {.pattern = pattern, .colors = {white, black}}; }

}  // namespace

TEST_CASE("the nearest texel: (0, 0) of the unit square is the lower left corner, and edges repeat or hold") {
  const TexelImage picture = numbered(4, 2);
  const auto at = [&](double x, double y, Edges edges) {
    return render::nearest_texel(picture, {x, y}, {edges, edges});
  };
  CHECK(at(0, 0, Edges::repeat) == picture.at(0, 1));
  CHECK(at(0.99, 0.99, Edges::repeat) == picture.at(3, 0));
  CHECK(at(1.01, 0.25, Edges::repeat) == picture.at(0, 1));
  CHECK(at(-0.01, 0.25, Edges::repeat) == picture.at(3, 1));
  CHECK(at(1e300, 0.25, Edges::repeat) == picture.at(0, 1));
  CHECK(at(1.01, 7, Edges::clamp) == picture.at(3, 0));
  CHECK(at(-5, -7, Edges::clamp) == picture.at(0, 1));
}

TEST_CASE("between the centres of texels it is linear, and at a centre the texel itself") {
  const TexelImage picture = numbered(4, 2);
  const auto at = [&](double x, double y, Edges edges) {
    return render::linear_texels(picture, {x, y}, {edges, edges});
  };
  for (std::uint32_t k : {0U, 1U})
    for (std::uint32_t j = 0; j < 4; ++j)
      CHECK(at((j + 0.5) / 4, 1 - (k + 0.5) / 2, Edges::repeat) == picture.at(j, k));
  CHECK(at(0.5, 0.75, Edges::repeat) == (picture.at(1, 0) + picture.at(2, 0)) / 2.0);
  CHECK(at(0.125, 0.5, Edges::repeat) == (picture.at(0, 0) + picture.at(0, 1)) / 2.0);
  CHECK(at(0, 0.75, Edges::repeat) == (picture.at(3, 0) + picture.at(0, 0)) / 2.0);
  CHECK(at(0, 0.75, Edges::clamp) == picture.at(0, 0));
}

TEST_CASE("the level is one more at twice the distance, from 0 to n") {
  CHECK(render::mipmap_level(0.5, 2, 5) == 0);
  CHECK(render::mipmap_level(2, 2, 5) == 0);
  for (double d = 2; d < 32; d *= 1.25) {
    if (2 * d > 64) break;
    CHECK(render::mipmap_level(2 * d, 2, 5) == Approx(render::mipmap_level(d, 2, 5) + 1).epsilon(1e-14));
  }
  CHECK(render::mipmap_level(8, 2, 5) == 2);
  CHECK(render::mipmap_level(64, 2, 5) == 5);
  CHECK(render::mipmap_level(1e9, 2, 5) == 5);
  CHECK(render::mipmap_level(INFINITY, 2, 5) == 5);
  CHECK(render::mipmap_level(100, 2, 0) == 0);
}

TEST_CASE("at a whole level that level alone is shown, and up to `near` the picture itself") {
  const TexelImage picture = numbered(8, 8);
  const Texture texture = image(picture, Filter::mipmap, 3), plain = image(picture, Filter::linear);
  const std::vector<TexelImage>& levels = *texture.image.levels;
  const render::TextureCoordinates at{0.3, 0.7};
  for (std::size_t i = 0; i < levels.size(); ++i)
    CHECK(texture_at(texture, at, 3 * std::exp2(i)) == render::linear_texels(levels[i], {at.u, at.v}, {}));
  for (const double d : {0.0, 1.0, 3.0}) CHECK(texture_at(texture, at, d) == texture_at(plain, at, d));
}

TEST_CASE("what a receding plane shows changes by no jump, which whole levels alone would") {
  const Texture texture = image(checker(64, 1), Filter::mipmap);
  const std::vector<TexelImage>& levels = *texture.image.levels;
  const render::TextureCoordinates at{0.3 / 64, 0.4 / 64};
  double greatest = 0, jump = 0;
  for (double d = 0.5; d < 200; d *= 1.0003) {
    const double next = d * (1 + 1e-6);
    greatest = std::max(greatest, std::abs(texture_at(texture, at, d).x - texture_at(texture, at, next).x));
    const auto whole = [&](double distance) {
      const double level = render::mipmap_level(distance, 1, levels.size() - 1);
      return render::linear_texels(levels[static_cast<std::size_t>(std::lround(level))], {at.u, at.v}, {}).x;
    };
    jump = std::max(jump, std::abs(whole(d) - whole(d * 1.0003)));
  }
  CHECK(greatest <= 1e-5);
  CHECK(greatest > 0);
  CHECK(jump > 0.1);
}

TEST_CASE("checkers and stripes, as often as they are repeated") {
  Texture texture = rule(Pattern::checker);
  CHECK(texture_at(texture, {0.5, 0.5}, 0) == white);
  CHECK(texture_at(texture, {1.5, 0.5}, 0) == black);
  CHECK(texture_at(texture, {-0.5, 0.5}, 0) == black);
  CHECK(texture_at(texture, {-0.5, -0.5}, 0) == white);
  texture.repeat = {4, 2};
  CHECK(texture_at(texture, {0.3, 0.3}, 0) == black);
  CHECK(texture_at(texture, {0.3, 0.6}, 0) == white);
  CHECK(texture_at(rule(Pattern::stripes), {2.5, 77.3}, 0) == white);
  CHECK(texture_at(rule(Pattern::stripes), {-0.5, 0.5}, 0) == black);
}

TEST_CASE("p6m is kept by its generators: the turn by 60 degrees, the mirrors, the translations, at 10^5 points") {
  std::mt19937_64 draw;  // the same points each time
  const auto number = [&] { return std::ldexp(static_cast<double>(draw() >> 11), -50) - 4; };
  const double root = std::numbers::sqrt3 / 2;
  const Texture texture = rule(Pattern::p6m);
  int first = 0, apart = 0;
  for (int i = 0; i < 100000; ++i) {
    const double x = number(), y = number();
    const glm::dvec2 p(x, y);
    const glm::dvec2 images[] = {{0.5 * p.x - root * p.y, root * p.x + 0.5 * p.y},
                                 {p.x, -p.y},
                                 {-p.x, p.y},
                                 {p.x + 1, p.y},
                                 {p.x + 0.5, p.y + root}};
    const glm::dvec2 representative = render::p6m_representative(p);
    if (!(representative.y >= 0 && representative.y <= representative.x / std::numbers::sqrt3 + 1e-15 &&
          representative.x <= 0.5 + 1e-15))
      FAIL("not in the triangle: " << p.x << ' ' << p.y);
    for (const glm::dvec2& q : images) {
      const glm::dvec2 other = render::p6m_representative(q);
      if (std::abs(other.x - representative.x) > 1e-13 || std::abs(other.y - representative.y) > 1e-13) ++apart;
      // Where an edge of the pattern runs closer than the rounding, the two may lie on its two sides.
      const bool is_at_edge = std::abs(representative.x + 1.5 * representative.y - 0.38) < 1e-12 ||
                              std::abs(representative.x - 0.46) < 1e-12;
      if (!is_at_edge) REQUIRE(texture_at(texture, {p.x, p.y}, 0) == texture_at(texture, {q.x, q.y}, 0));
    }
    first += texture_at(texture, {p.x, p.y}, 0) == white;
  }
  CHECK(apart == 0);
  CHECK(first > 20000);
  CHECK(first < 80000);
}

TEST_CASE("p6m is kept by no other motion: a quarter or a twelfth of a turn, half a translation") {
  std::mt19937_64 draw;
  const auto number = [&] { return std::ldexp(static_cast<double>(draw() >> 11), -50) - 4; };
  const double root = std::numbers::sqrt3 / 2;
  const Texture texture = rule(Pattern::p6m);
  std::array<int, 4> changed{};
  for (int i = 0; i < 10000; ++i) {
    const double x = number(), y = number();
    const glm::dvec2 images[] = {
        {-y, x}, {root * x - 0.5 * y, 0.5 * x + root * y}, {x + 0.5, y}, {x + 0.25, y + root / 2}};
    for (std::size_t k = 0; k < changed.size(); ++k)
      changed[k] += texture_at(texture, {x, y}, 0) != texture_at(texture, {images[k].x, images[k].y}, 0);
  }
  for (const int count : changed) CHECK(count > 1000);
}

TEST_CASE("slopes of waves are exact, and differences come nearer by four when their step is halved") {
  Texture texture = rule(Pattern::waves);
  texture.repeat = {3, 2};
  const render::TextureCoordinates at{0.11, 0.17};
  const glm::dvec2 exact = render::slopes(texture, at, {});
  const auto error = [&](double delta) {
    const glm::dvec2 off = render::slopes(texture, at, delta) - exact;
    return std::max(std::abs(off.x), std::abs(off.y));
  };
  for (const double delta : {1.0 / 32, 1.0 / 64, 1.0 / 128})
    CHECK(error(delta) / error(delta / 2) == Approx(4).epsilon(0.02));
  CHECK(error(1.0 / 4096) < 1e-4);
}

TEST_CASE("slopes of an image: by one texel, over its edges, and none where all is level") {
  TexelImage ramp{8, 1};
  for (int i = 0; i < 8; ++i) ramp.texels.emplace_back(i / 8.0);
  const Texture texture = image(ramp, Filter::linear);
  CHECK(render::slopes(texture, {3.5 / 8, 0.5}, {}) == glm::dvec2(1, 0));
  CHECK(render::slopes(texture, {0.5 / 8, 0.5}, {}) == glm::dvec2(-3, 0));  // from 7/8 to 1/8 in a quarter
  Texture held = texture;
  held.edges = Edges::clamp;
  CHECK(render::slopes(held, {0.5 / 8, 0.5}, {}) == glm::dvec2(0.5, 0));
  Texture often = texture;
  often.repeat = {4, 1};
  CHECK(render::slopes(often, {3.5 / 32, 0.5}, {}) == glm::dvec2(4, 0));
  Texture level = rule(Pattern::checker);
  level.colors = {white, white};
  CHECK(render::slopes(level, {0.4, 0.3}, {}) == glm::dvec2(0));
}

TEST_CASE("a picture that has not been read is asked for") {
  const Texture texture{.pattern = Pattern::image};
  CHECK_THROWS_AS(texture_at(texture, {0, 0}, 0), std::domain_error);
  CHECK_THROWS_AS(render::slopes(texture, {0, 0}, {}), std::domain_error);
}

TEST_CASE("grey is the mean, and of one value that value") {
  CHECK(render::grey({0.25, 0.5, 0.75}) == 0.5);
  for (int i = 0; i <= 255; ++i) CHECK(render::grey(glm::dvec3(i / 255.0)) == i / 255.0);
}

namespace {

/// A checker plane to the horizon, one square of the checker a unit, as the slide on mipmaps shows it.
scene::Scene receding(const Texture& texture) {
  scene::Scene scene;
  scene::Stage& stage = scene.stage();
  stage.camera = {{0.3, 2, 0.1}, {0.3, 1, 10}, {0, 1, 0}, 50};
  stage.resolution = {120, 90};
  stage.background = glm::dvec3(0);
  stage.materials = {{.name = "floor", .color = {0, 0, 0}, .emission = {1, 1, 1}}};
  stage.materials[0].textures.names[static_cast<std::size_t>(scene::Coefficient::emission)] = "t";
  stage.textures = {texture};
  stage.textures[0].name = "t";
  scene.apply(model::Agregar_Plano{model::Elemento("floor"), {0, 0, 0}, {0, 1, 0}});
  scene.set_material(*scene.find("floor"), 0);
  return scene;
}

/// The variance of the linear colours of rows of the picture.
double variance(const std::vector<double>& values) {
  double mean = 0, square = 0;
  for (const double x : values) mean += x / static_cast<double>(values.size());
  for (const double x : values) square += (x - mean) * (x - mean) / static_cast<double>(values.size());
  return square;
}

std::vector<double> rows(const scene::Scene& scene, std::uint32_t first, std::uint32_t count) {
  const auto engine = engine::find("analytic")->prepare(scene);
  const scene::PrimaryRays rays(*scene.stage().camera, *scene.stage().resolution);
  std::vector<scene::Query> queries;
  for (std::uint32_t y = first; y < first + count; ++y)
    for (std::uint32_t x = 0; x < scene.stage().resolution->width; ++x) queries.push_back({rays.ray(x, y)});
  std::vector<double> colors;
  for (const render::PathRadiance& ray : render::brought(scene, *engine, queries, {1})) colors.push_back(ray.color.x);
  return colors;
}

}  // namespace

TEST_CASE("a checker to the horizon: mipmaps calm what is far, tenfold, and leave what is near as it is") {
  Texture with = image(checker(8, 4), Filter::mipmap, 6), without = image(checker(8, 4), Filter::linear);
  with.repeat = without.repeat = {0.5, 0.5};
  const scene::Scene calm = receding(with), rough = receding(without);
  // The horizon is at row 35: the next ones are farther than 8·6, the lowest nearer than 6.
  CHECK(variance(rows(rough, 36, 3)) > 10 * variance(rows(calm, 36, 3)));
  CHECK(variance(rows(rough, 36, 3)) > 0.1);
  CHECK(rows(rough, 85, 5) == rows(calm, 85, 5));
  CHECK(rows(rough, 60, 5) != rows(calm, 60, 5));
}

TEST_CASE("many rays a pixel say the same of what is far, for sixty-four times the work") {
  Texture with = image(checker(8, 4), Filter::mipmap, 6), without = image(checker(8, 4), Filter::linear);
  with.repeat = without.repeat = {0.5, 0.5};
  const scene::Scene calm = receding(with);
  scene::Scene rough = receding(without);
  rough.stage().resolution = {960, 720};
  const std::vector<double> few = rows(calm, 36, 3), many = rows(rough, 36 * 8, 3 * 8);
  double square = 0;
  for (std::size_t i = 0; i < few.size(); ++i) {
    const std::size_t x = i % 120, y = i / 120;
    double mean = 0;
    for (std::size_t k = 0; k < 64; ++k) mean += many[(8 * y + k / 8) * 960 + 8 * x + k % 8] / 64;
    square += (mean - few[i]) * (mean - few[i]) / static_cast<double>(few.size());
  }
  const double one_ray = variance(rows(receding(without), 36, 3));
  CAPTURE(square, one_ray);
  CHECK(square < one_ray / 10);
}
