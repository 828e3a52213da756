#include "durero/text/shown.hpp"

#include <algorithm>

#include "durero/text/utf8.hpp"
#include "support/catch.hpp"
#include "support/property.hpp"

using namespace durero;
using text::escaped;
using text::shown;

TEST_CASE("What a terminal would obey is escaped, and nothing else") {
  CHECK(escaped("a b ñ ∉ 𝄞 \\x \"") == "a b ñ ∉ 𝄞 \\x \"");
  CHECK(escaped("\x1B[31m\t\n\x7F") == "\\x1b[31m\\x09\\x0a\\x7f");
  CHECK(escaped(std::string("\0", 1)) == "\\x00");
  CHECK(escaped("\u0085\u009F\u00A0") == "\\xc2\\x85\\xc2\\x9f\u00A0");
  CHECK(escaped("\u200D\u200E\u200F\u2010") == "\u200D\\xe2\\x80\\x8e\\xe2\\x80\\x8f\u2010");
  CHECK(escaped("\u2027\u2028\u202E\u202F") == "\u2027\\xe2\\x80\\xa8\\xe2\\x80\\xae\u202F");
  CHECK(escaped("\u2065\u2066\u2069\u206A") == "\u2065\\xe2\\x81\\xa6\\xe2\\x81\\xa9\u206A");
  CHECK(escaped("\uFEFF") == "\\xef\\xbb\\xbf");
  CHECK(escaped("\xFFñ\xE2\x88 ") == "\\xffñ\\xe2\\x88 ");
  CHECK(escaped("").empty());
}

TEST_CASE(
    "Whatever the bytes, what is escaped is UTF-8 without control characters, and escaping it again is the same") {
  test::property("any bytes", [] {
    const auto piece =
        rc::gen::element<std::string>("a", "\\", "\x1B", "\n", "\xFF", "\x80", "ñ", "∉", "\xE2", "\u202E");
    std::string bytes;
    for (const auto& p : *rc::gen::container<std::vector<std::string>>(piece)) bytes += p;
    const std::string safe = escaped(bytes);
    RC_ASSERT(escaped(safe) == safe);
    RC_ASSERT(std::ranges::none_of(safe, [](unsigned char c) { return c < 0x20 || c == 0x7F; }));
    for (std::string_view rest = safe; !rest.empty(); rest.remove_prefix(text::first(rest).size())) {
      RC_ASSERT(text::decode(rest).has_value());
    }
  });
}

TEST_CASE("Input is shown in quotes, on one line, cut after 40 characters") {
  CHECK(shown("a b") == "\"a b\"");
  CHECK(shown("") == "\"\"");
  CHECK(shown("\n\x80ñ") == "\"\\x0a\\x80ñ\"");
  CHECK(shown(std::string(40, 'x')) == '"' + std::string(40, 'x') + '"');
  CHECK(shown(std::string(41, 'x')) == '"' + std::string(40, 'x') + "…\"");
  std::string accents;
  for (int i = 0; i < 40; ++i) accents += "ñ";
  CHECK(shown(accents) == '"' + accents + '"');
  CHECK(shown(accents + "é") == '"' + accents + "…\"");
}
