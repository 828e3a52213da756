#include "durero/scene/picture.hpp"

#include "durero/scene/stage.hpp"
#include "support/catch.hpp"

using namespace durero::scene;

namespace {

/// 2ⁿ × 2ⁿ texels of eighths of bytes, so that the sums below are exact; all different from their neighbours.
TexelImage exact(std::uint32_t side) {
  TexelImage picture{side, side};
  for (std::uint32_t i = 0; i < side * side; ++i)
    picture.texels.emplace_back((i * 37 % 256) / 256.0, (i * 101 % 256) / 256.0, i % 2);
  return picture;
}

/// Exact: fewer than 2²⁰ numbers of 8 bits, or means of them by powers of four.
glm::dvec3 sum(const TexelImage& picture) {
  glm::dvec3 all(0);
  for (const glm::dvec3& texel : picture.texels) all += texel;
  return all;
}

}  // namespace

TEST_CASE("M_n is the mean of M_0, every level has that mean, and there are (4^(n+1) - 1)/3 texels") {
  for (std::uint32_t n = 0, side = 1; n <= 8; ++n, side *= 2) {
    const TexelImage original = exact(side);
    const std::vector<TexelImage> levels = mipmap(original);
    REQUIRE(levels.size() == n + 1);
    CHECK(levels[0] == original);
    const glm::dvec3 mean = sum(original) / double(side * side);
    std::size_t texels = 0;
    for (std::uint32_t i = 0; i <= n; ++i) {
      CHECK(levels[i].width == side >> i);
      CHECK(levels[i].height == side >> i);
      CHECK(sum(levels[i]) / double(levels[i].texels.size()) == mean);
      texels += levels[i].texels.size();
    }
    CHECK(levels[n].texels == std::vector{mean});
    CHECK(texels == ((std::size_t{4} << (2 * n)) - 1) / 3);
  }
}

TEST_CASE("a texel of the next level is the mean of the four of its place") {
  const TexelImage m = exact(4);
  const TexelImage half = mipmap(m)[1];
  for (std::uint32_t k : {0U, 1U})
    for (std::uint32_t j : {0U, 1U})
      CHECK(half.at(j, k) ==
            (m.at(2 * j, 2 * k) + m.at(2 * j + 1, 2 * k) + m.at(2 * j, 2 * k + 1) + m.at(2 * j + 1, 2 * k + 1)) / 4.0);
}

TEST_CASE("a checker of single texels is one half from the first level on") {
  TexelImage checker{8, 8};
  for (std::uint32_t k = 0; k < 8; ++k)
    for (std::uint32_t j = 0; j < 8; ++j) checker.texels.emplace_back((j + k) % 2);
  const std::vector<TexelImage> levels = mipmap(checker);
  for (std::size_t i = 1; i < levels.size(); ++i)
    for (const glm::dvec3& texel : levels[i].texels) CHECK(texel == glm::dvec3(0.5));
}

TEST_CASE("only 2^n by 2^n texels have a mipmap") {
  for (const auto& [width, height] : {std::pair{3U, 3U}, {4U, 2U}, {2U, 4U}, {0U, 0U}, {6U, 6U}}) {
    TexelImage picture{width, height};
    picture.texels.resize(std::size_t{width} * height);
    CHECK_FALSE(has_mipmap(picture));
    CHECK_THROWS_AS(mipmap(picture), std::invalid_argument);
  }
  CHECK(has_mipmap(exact(16)));
}

TEST_CASE("picture files are equal by their names, read or not") {
  const auto levels = std::make_shared<const std::vector<TexelImage>>(1, exact(1));
  CHECK(PictureFile{"a.png", levels} == PictureFile{"a.png"});
  CHECK_FALSE(PictureFile{"a.png"} == PictureFile{"b.png"});
}
