#include "obj_words.hpp"

#include <algorithm>

#include "durero/io/lines.hpp"

namespace durero::io {
namespace {

constexpr std::string_view obj_blanks = " \t\v\f", obj_word_ends = " \t\v\f#";

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

std::size_t obj_vertex_count(std::string_view joined) {
  std::size_t count = 0;
  Lines lines(joined);
  while (const auto line = lines.next()) {
    std::string_view bytes = joined.substr(line->begin, line->end - line->begin);
    bytes.remove_prefix(std::min(bytes.find_first_not_of(obj_blanks), bytes.size()));
    const ObjWord* const row = obj_word(bytes.substr(0, bytes.find_first_of(obj_word_ends)));
    count += row != nullptr && row->kind == ObjKind::vertex ? 1 : 0;
  }
  return count;
}

}  // namespace durero::io
