#include "durero/scene/texture.hpp"

#include "durero/scene/stage.hpp"
#include "support/catch.hpp"

using namespace durero::scene;

TEST_CASE("words are in step with what they name") {
  CHECK(pattern_words[static_cast<std::size_t>(Pattern::waves)] == "waves");
  CHECK(pattern_words[static_cast<std::size_t>(Pattern::image)] == "image");
  CHECK(filter_words[static_cast<std::size_t>(Filter::mipmap)] == "mipmap");
  CHECK(edges_words[static_cast<std::size_t>(Edges::clamp)] == "clamp");
  CHECK(curve_words[static_cast<std::size_t>(TransferFunction::linear)] == "linear");
  CHECK(coefficient_words[static_cast<std::size_t>(Coefficient::k_ps)] == "k_ps");
  CHECK(coefficient_words[static_cast<std::size_t>(Coefficient::ambient)] == "ambient");
}

TEST_CASE("a material has textures where one of its coefficients has") {
  TextureUses uses;
  CHECK_FALSE(uses.any());
  uses.names[static_cast<std::size_t>(Coefficient::k_t)] = "holes";
  CHECK(uses.any());
  CHECK(uses.of(Coefficient::k_t) == "holes");
  CHECK(uses.of(Coefficient::color).empty());
}

TEST_CASE("textures are equal where all that a file says of them is") {
  const Texture plain{.name = "a"};
  Texture other = plain;
  CHECK(other == plain);
  other.near = 1;
  CHECK_FALSE(other == plain);
}
