#include "durero/text/spanish.hpp"

#include <algorithm>
#include <set>

#include "support/catch.hpp"

using namespace durero;
using text::english_beside;
using text::english_of;
using text::spanish_names;
using text::with_english;

TEST_CASE("A name has its English, and other words have none") {
  CHECK(english_of("radio") == "radius");
  CHECK(english_of("Agregar_Esfera") == "Add_Sphere");
  CHECK(english_of("elementos!") == "elements");
  CHECK(english_of("Radio").empty());
  CHECK(english_of("radius").empty());
  CHECK(english_of("").empty());
}

TEST_CASE("A message shows the English beside the name, once and where it differs") {
  CHECK(with_english("radio") == "radio (radius)");
  CHECK(with_english("radio?") == "radio? (radius)");
  CHECK(with_english("elementos?") == "elementos? (elements)");
  CHECK(with_english("t!") == "t! (parameter)");
  CHECK(with_english("vector") == "vector");
  CHECK(with_english("vector?") == "vector?");
  CHECK(with_english("an element") == "an element");
  CHECK(english_beside("tipo") == " (type)");
  CHECK(english_beside("material").empty());
  CHECK(with_english("material?") == "material?");
}

TEST_CASE("Each name stands once, and its English and its meaning are one line each") {
  std::set<std::string_view> seen;
  for (const auto& [name, english, meaning] : spanish_names()) {
    CAPTURE(name);
    CHECK(seen.insert(name).second);
    const auto in_a_name = [](char c) { return c == '_' || ('a' <= (c | 0x20) && (c | 0x20) <= 'z'); };
    CHECK((!english.empty() && std::ranges::all_of(english, in_a_name)));
    CHECK((!meaning.empty() && meaning.find('\n') == meaning.npos && meaning.back() != '.'));
  }
  CHECK(seen.size() > 200);
}
