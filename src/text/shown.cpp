#include "durero/text/shown.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "durero/text/utf8.hpp"

namespace durero::text {
namespace {

struct Codes {
  char32_t first, last;
};

constexpr Codes not_shown[] = {{0x00, 0x1F},     {0x7F, 0x9F},       // C0, DEL and C1
                               {0x200E, 0x200F}, {0x2028, 0x202E},   // marks of direction; line ends and embeddings
                               {0x2066, 0x2069}, {0xFEFF, 0xFEFF}};  // isolates; the byte order mark

bool is_shown(const Character& character) {
  return std::ranges::none_of(
      not_shown, [&](const Codes& codes) { return codes.first <= character.code && character.code <= codes.last; });
}

// Appends the bytes of one character, or one byte that belongs to none.
void append_escaped(std::string& out, std::string_view bytes) {
  const auto character = decode(bytes);
  if (character && is_shown(*character)) {
    out += bytes;
    return;
  }
  for (const char byte : bytes) {
    fmt::format_to(std::back_inserter(out), "\\x{:02x}", static_cast<unsigned char>(byte));
  }
}

}  // namespace

std::string escaped(std::string_view text) {
  std::string out;
  while (!text.empty()) {
    const std::string_view bytes = first(text);
    append_escaped(out, bytes);
    text.remove_prefix(bytes.size());
  }
  return out;
}

std::string shown(std::string_view text) {
  constexpr std::size_t longest = 40;
  std::size_t kept = 0;
  for (std::size_t count = 0; count < longest && kept < text.size(); ++count) kept += first(text.substr(kept)).size();
  return '"' + escaped(text.substr(0, kept)) + (kept < text.size() ? "…\"" : "\"");
}

}  // namespace durero::text
