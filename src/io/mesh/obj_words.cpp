#include "obj_words.hpp"

#include <algorithm>

#include "durero/io/lines.hpp"
#include "polygon_soup.hpp"

namespace durero::io {
namespace {

constexpr std::string_view obj_blanks = " \t\v\f";

/// Whether a comment begins in the line: a # at the beginning of a word.
bool has_comment(std::string_view line) {
  for (std::size_t at = line.find('#'); at != line.npos; at = line.find('#', at + 1))
    if (at == 0 || obj_blanks.find(line[at - 1]) != obj_blanks.npos) return true;
  return false;
}

}  // namespace

const ObjWord* obj_word(std::string_view word) noexcept {
  const auto* const found = std::ranges::find(obj_words, word, &ObjWord::word);
  return found == obj_words.end() ? nullptr : found;
}

std::string obj_joined(std::string_view text) {
  std::string joined(text);
  Lines lines(text);
  while (const auto line = lines.next()) {
    const std::string_view bytes = text.substr(line->begin, line->end - line->begin);
    if (line->end == text.size() || !bytes.ends_with('\\') || has_comment(bytes)) continue;
    const std::size_t length = text.substr(line->end, 2) == "\r\n" ? 3 : 2;
    std::fill_n(joined.begin() + static_cast<std::ptrdiff_t>(line->end) - 1, length, ' ');
  }
  return joined;
}

std::string obj_meshes(std::string_view joined) {
  std::string plain;
  plain.reserve(joined.size());
  append_plain(plain, joined);
  for (std::size_t begin = 0, end = 0; begin < plain.size(); begin = end + 1) {
    end = std::min(plain.find('\n', begin), plain.size());
    const std::size_t word = std::min(plain.find_first_not_of(' ', begin), end);
    const std::size_t behind = std::min(plain.find(' ', word), end);
    const ObjWord* const row = obj_word(std::string_view(plain).substr(word, behind - word));
    const bool is_mesh = row != nullptr && (row->kind == ObjKind::vertex || row->kind == ObjKind::face);
    const std::size_t from = is_mesh ? word + 1 : begin, to = is_mesh ? behind : end;
    std::fill(plain.begin() + static_cast<std::ptrdiff_t>(from), plain.begin() + static_cast<std::ptrdiff_t>(to), ' ');
  }
  return plain;
}

}  // namespace durero::io
