#include "lsp/edited_text.hpp"

#include <rapidcheck.h>

#include "durero/text/utf8.hpp"
#include "support/catch.hpp"

using namespace durero::lsp;

namespace {

std::string edited(const std::string& text, EditorPosition from, EditorPosition to, const std::string& now,
                   PositionUnit unit = PositionUnit::utf16) {
  EditedText at(text, unit);
  at.edit(from, to, now);
  return at.text();
}

/// A text of UTF-16 units, as an editor in JavaScript has it.
std::u16string units_of(const std::string& text) {
  std::u16string units;
  for (std::string_view rest = text; !rest.empty();) {
    const auto character = durero::text::decode(rest);
    REQUIRE(character);
    rest.remove_prefix(character->length);
    if (character->code < 0x10000) {
      units += static_cast<char16_t>(character->code);
    } else {
      units += static_cast<char16_t>(0xD800 + ((character->code - 0x10000) >> 10U));
      units += static_cast<char16_t>(0xDC00 + ((character->code - 0x10000) & 0x3FFU));
    }
  }
  return units;
}

/// What EditedText keeps of such units: a half that stands alone takes three bytes.
std::string kept(const std::u16string& units) {
  std::string text;
  for (std::size_t i = 0; i < units.size(); ++i) {
    const char32_t unit = units[i];
    const bool high = unit >= 0xD800 && unit < 0xDC00, low = unit >= 0xDC00 && unit < 0xE000;
    if (high && i + 1 < units.size() && units[i + 1] >= 0xDC00 && units[i + 1] < 0xE000) {
      text += durero::text::encode(0x10000 + ((unit - 0xD800) << 10U) + (units[++i] - 0xDC00));
    } else if (high || low) {
      text += {static_cast<char>(0xE0U | (unit >> 12U)), static_cast<char>(0x80U | ((unit >> 6U) & 0x3FU)),
               static_cast<char>(0x80U | (unit & 0x3FU))};
    } else {
      text += durero::text::encode(unit);
    }
  }
  return text;
}

}  // namespace

TEST_CASE("positions count lines, and units within a line") {
  const EditedText text("a𝔽b\nℕx\r\ny\rz");
  CHECK(text.byte_of(EditorPosition{0, 0}) == 0);
  CHECK(text.byte_of(EditorPosition{0, 1}) == 1);
  CHECK(text.byte_of(EditorPosition{0, 2}) == 1);  // within 𝔽
  CHECK(text.byte_of(EditorPosition{0, 3}) == 5);
  CHECK(text.byte_of(EditorPosition{0, 99}) == 6);
  CHECK(text.byte_of(EditorPosition{1, 1}) == 10);
  CHECK(text.byte_of(EditorPosition{1, 9}) == 11);
  CHECK(text.byte_of(EditorPosition{3, 0}) == 15);
  CHECK(text.byte_of(EditorPosition{9, 9}) == text.text().size());
  CHECK(text.position_of(5) == EditorPosition{0, 3});
  CHECK(text.position_of(15) == EditorPosition{3, 0});
  CHECK(EditedText("a𝔽b", PositionUnit::utf8).position_of(5) == EditorPosition{0, 5});
  CHECK(EditedText("a𝔽b", PositionUnit::utf32).position_of(5) == EditorPosition{0, 2});
  CHECK(EditedText("a𝔽b", PositionUnit::utf32).byte_of(EditorPosition{0, 2}) == 5);
}

TEST_CASE("a place counts characters in lines that end at line feeds") {
  const EditedText text("a𝔽b\rc\nℕx\n");
  CHECK(text.byte_of(durero::zed::Place{1, 3}) == 5);
  CHECK(text.byte_of(durero::zed::Place{1, 5}) == 7);
  CHECK(text.byte_of(durero::zed::Place{2, 2}) == 12);
  CHECK(text.byte_of(durero::zed::Place{9, 1}) == text.text().size());
  CHECK(text.byte_of(durero::zed::Place{}) == 0);
}

TEST_CASE("an edit puts a text in the place of a range") {
  CHECK(edited("one\ntwo\n", {0, 1}, {1, 1}, "X") == "oXwo\n");
  CHECK(edited("a𝔽b", {0, 1}, {0, 3}, "ℤ") == "aℤb");
  CHECK(edited("a𝔽b", {0, 1}, {0, 5}, "", PositionUnit::utf8) == "ab");
  CHECK(edited("", {0, 0}, {0, 0}, "new\n") == "new\n");
  CHECK(edited("x", {7, 7}, {8, 0}, "y") == "xy");
}

TEST_CASE("an edit within a character parts it, and its halves meet again") {
  EditedText text("a𝔽b");
  text.edit({0, 2}, {0, 2}, "-");
  CHECK(text.text() ==
        "a\xED\xA0\xB5-\xED\xB4\xBD"
        "b");
  CHECK(text.position_of(text.text().size()) == EditorPosition{0, 5});
  text.edit({0, 2}, {0, 3}, "");
  CHECK(text.text() == "a𝔽b");
  text.edit({0, 2}, {0, 4}, "");  // the second half, and b
  CHECK(text.text() == "a\xED\xA0\xB5");
}

TEST_CASE("edits at any units give the text that an editor of UTF-16 has") {
  const auto agrees = [](const std::string& start, std::vector<std::array<unsigned, 3>> edits) {
    static const std::string pieces[] = {"", "x", "𝔽", "ℕ", "𝔸𝔽", "é"};
    EditedText text(start);
    std::u16string units = units_of(start);
    for (const auto& [from, length, piece] : edits) {
      const std::size_t begin = from % (units.size() + 1);
      const std::size_t end = begin + length % (units.size() - begin + 1);
      const std::string& now = pieces[piece % std::size(pieces)];
      text.edit({0, static_cast<std::uint32_t>(begin)}, {0, static_cast<std::uint32_t>(end)}, now);
      units.replace(begin, end - begin, units_of(now));
      if (text.text() != kept(units)) return false;
    }
    return true;
  };
  CHECK(rc::check("any edits",
                  [&](std::vector<std::array<unsigned, 3>> edits) { RC_ASSERT(agrees("a𝔽ℕ𝔸b𝔽", std::move(edits))); }));
}
