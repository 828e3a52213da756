#include "durero/render/light/directions.hpp"

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>
#include <limits>
#include <random>

#include "durero/model/iluminacion.hpp"
#include "support/catch.hpp"

using namespace durero;

namespace {

const glm::dvec3 up{0, 0, 1};

model::ExactDirection exact(const glm::dvec3& v) { return {model::Surd(v.x), model::Surd(v.y), model::Surd(v.z)}; }

/// The greatest of the differences of the components.
double distance(const glm::dvec3& a, const glm::dvec3& b) {
  return std::max({std::abs(a.x - b.x), std::abs(a.y - b.y), std::abs(a.z - b.z)});
}

glm::dvec3 rounded(const model::ExactDirection& v) {
  return {number::round_to_binary64(v.x), number::round_to_binary64(v.y), number::round_to_binary64(v.z)};
}

}  // namespace

TEST_CASE("unit: also of what has no square in binary64; the same for every scale by a power of two") {
  CHECK(render::unit({3, 0, -4}) == glm::dvec3(0.6, 0, -0.8));
  for (const int k : {-1070, -600, -1, 1, 600, 1000})
    CHECK(render::unit({std::scalbn(3.0, k), 0, std::scalbn(-4.0, k)}) == glm::dvec3(0.6, 0, -0.8));
  CHECK(render::unit({5e-324, 0, 0}) == glm::dvec3(1, 0, 0));
}

TEST_CASE("unit: the squares alone give the bits that a scale by a power of two gives") {
  std::mt19937_64 bits(1);
  std::uniform_real_distribution<double> number(-1, 1);
  for (int k = -1030; k <= 1000; k += 10)
    for (int i = 0; i < 20; ++i) {
      const auto drawn = [&](int apart) { return std::scalbn(number(bits), k - apart * (i % 4)); };
      const double x = drawn(0), y = drawn(60), z = drawn(300);
      for (const glm::dvec3& v : {glm::dvec3(x, y, z), glm::dvec3(y, z, x), glm::dvec3(z, x, y)})
        CHECK(render::unit(v) == render::unit_of_any_length(v));
    }
}

TEST_CASE("refraccion.def.1 in binary64: 28.1255° at 45° into 1.5, and back") {
  const double half_root = std::sqrt(0.5);
  const glm::dvec3 t = render::refracted({half_root, 0, -half_root}, up, 1 / 1.5).value();
  CHECK(t.x == Approx(0.47140452).epsilon(1e-8));
  CHECK(t.z == Approx(-0.88191710).epsilon(1e-8));
  CHECK(std::atan2(t.x, -t.z) * 180 / glm::pi<double>() == Approx(28.1255).epsilon(1e-6));
  CHECK(distance(-render::refracted(-t, -up, 1.5).value(), {half_root, 0, -half_root}) < 4e-16);
}

TEST_CASE("reflexion_total.def.1 in binary64: the greatest angles, 41.8103° from 1.5 and 48.7535° from 1.33") {
  const auto at = [](double degrees) {
    const double angle = degrees * glm::pi<double>() / 180;
    return glm::dvec3(std::sin(angle), 0, -std::cos(angle));
  };
  CHECK(render::refracted(at(41.8103), up, 1.5));
  CHECK_FALSE(render::refracted(at(41.8104), up, 1.5));
  CHECK(render::refracted(at(48.7534), up, 1.33));
  CHECK_FALSE(render::refracted(at(48.7535), up, 1.33));
}

TEST_CASE("equal media leave a direction as it is, to the last bit") {
  const glm::dvec3 d = render::unit({0.1, 0.7, -0.3});
  CHECK(render::refracted(d, up, 1) == d);
}

// With |d| and |n| within 2⁻⁵² of one, each of the products, sums and the quotient of these formulas adds at most an
// ulp of what is at most 2: eight of them for a mirror. Where the root is at least 2⁻¹⁰ what it magnifies is 2¹⁰ of
// these.
TEST_CASE("both directions are those of the text but for rounding") {
  std::mt19937_64 random(7);
  std::normal_distribution<double> normal;
  const auto any_unit = [&] {
    const double x = normal(random), y = normal(random), z = normal(random);
    return render::unit({x, y, z});
  };
  for (int k = 0; k < 2000; ++k) {
    const glm::dvec3 n = any_unit();
    glm::dvec3 d = any_unit();
    if (glm::dot(d, n) > 0) d = -d;
    const glm::dvec3 r = rounded(model::reflected(exact(-d), exact(n)));
    CHECK(distance(render::mirrored(d, n), r) < 0x1p-49);
    const double ratio = 0.5 + k / 1000.0;
    const auto t = render::refracted(d, n, ratio);
    const double cosine = -glm::dot(d, n), squared = 1 - ratio * ratio * (1 - cosine * cosine);
    if (std::abs(squared) < 0x1p-20) continue;
    REQUIRE(t.has_value() == (squared > 0));
    if (!t) continue;
    CHECK(std::abs(glm::dot(*t, *t) - 1) < 0x1p-38);
    CHECK(glm::dot(*t, n) < 0);
    CHECK(std::abs(glm::dot(*t, glm::cross(d, n))) < 0x1p-48);
    CHECK(std::abs(glm::length(glm::cross(*t, n)) - ratio * glm::length(glm::cross(d, n))) < 0x1p-48);
  }
}
