#include "durero/text/utf8.hpp"

#include <cstdint>
#include <ios>
#include <string>

#include "support/catch.hpp"

using durero::text::Character;
using durero::text::decode;
using durero::text::encode;
using durero::text::first;
using durero::text::head;
using durero::text::is_scalar;

TEST_CASE("A character is read with its length, at both ends of every length") {
  CHECK(decode("a") == Character{'a', 1});
  CHECK(decode(std::string("\0", 1)) == Character{0, 1});
  CHECK(decode("\x7F") == Character{0x7F, 1});
  CHECK(decode("\u0080") == Character{0x80, 2});
  CHECK(decode("\u07FFx") == Character{0x7FF, 2});
  CHECK(decode("\u0800") == Character{0x800, 3});
  CHECK(decode("\uD7FF") == Character{0xD7FF, 3});
  CHECK(decode("\uE000") == Character{0xE000, 3});
  CHECK(decode("\uFFFF") == Character{0xFFFF, 3});
  CHECK(decode("\U00010000") == Character{0x10000, 4});
  CHECK(decode("\U0010FFFF") == Character{0x10FFFF, 4});
}

TEST_CASE("Bytes that are no UTF-8 are no character") {
  for (const char* bytes : {"", "\x80", "\xBFx", "\xC3", "\xC3(", "\xE2\x88", "\xE2\x88(", "\xF0\x9D\x84", "\xC0\x80",
                            "\xC1\xBF", "\xE0\x9F\xBF", "\xF0\x8F\xBF\xBF",  // overlong
                            "\xED\xA0\x80", "\xED\xBF\xBF",                  // surrogates
                            "\xF4\x90\x80\x80", "\xF8\x88\x80\x80\x80", "\xFF"}) {
    INFO(bytes);
    CHECK(decode(bytes) == std::nullopt);
  }
}

TEST_CASE("Every character is written as the bytes that it is read from") {
  CHECK(encode(0x24) == "$");
  CHECK(encode(0xE9) == "\u00E9");
  CHECK(encode(0x211D) == "ℝ");
  CHECK(encode(0x1D538) == "𝔸");
  char32_t characters = 0;
  for (char32_t code = 0; code <= 0x110000; ++code) {
    if (!is_scalar(code)) continue;
    ++characters;
    const std::string bytes = encode(code);
    if (decode(bytes) != Character{code, bytes.size()}) FAIL_CHECK("U+" << std::hex << std::uint32_t{code});
  }
  CHECK(characters == 0x110000 - 0x800);
}

TEST_CASE("The first of a text is a whole character, or one byte") {
  CHECK(first("∉ x") == "∉");
  CHECK(first("\xE2\x88") == "\xE2");
  CHECK(first("\xC3(") == "\xC3");
  CHECK(first("").empty());
}

TEST_CASE("The head of a text has whole characters") {
  CHECK(head("aé√b", 0) == "");
  CHECK(head("aé√b", 2) == "aé");
  CHECK(head("aé√b", 3) == "aé√");
  CHECK(head("aé√b", 9) == "aé√b");
  CHECK(head("a\xC3", 2) == "a\xC3");
  CHECK(head("", 1) == "");
}
