#include "lsp/edited_text.hpp"

#include <algorithm>
#include <utility>

#include "durero/text/utf8.hpp"

namespace durero::lsp {
namespace {

constexpr unsigned first_high = 0xD800, first_low = 0xDC00, last_low = 0xDFFF;

/// The three bytes of half a character, by the scheme of UTF-8.
std::string half(unsigned code) {
  return {static_cast<char>(0xE0U | (code >> 12U)), static_cast<char>(0x80U | ((code >> 6U) & 0x3FU)),
          static_cast<char>(0x80U | (code & 0x3FU))};
}

/// The half that begins at a byte; 0 where none does.
unsigned half_at(std::string_view text, std::size_t byte) {
  if (byte + 3 > text.size() || static_cast<unsigned char>(text[byte]) != 0xED) return 0;
  if (!text::continues(text[byte + 1]) || !text::continues(text[byte + 2])) return 0;
  const auto bits = [&](std::size_t at) { return static_cast<unsigned>(static_cast<unsigned char>(text[at])) & 0x3FU; };
  const unsigned code = 0xD000U | (bits(byte + 1) << 6U) | bits(byte + 2);
  return code >= first_high && code <= last_low ? code : 0;
}

/// The bytes of the character at the start of a text: half a one counts as such.
std::string_view character_of(std::string_view text) {
  return half_at(text, 0) != 0 ? text.substr(0, 3) : text::first(text);
}

}  // namespace

EditedText::EditedText(std::string text, PositionUnit unit) : text_(std::move(text)), unit_(unit) { index(); }

void EditedText::index() {
  lines_.assign(1, 0);
  z_lines_.assign(1, 0);
  for (std::size_t at = text_.find_first_of("\r\n"); at != text_.npos; at = text_.find_first_of("\r\n", at + 1)) {
    if (text_[at] == '\n') z_lines_.push_back(at + 1);
    const bool goes_on = text_[at] == '\r' && at + 1 < text_.size() && text_[at + 1] == '\n';
    if (!goes_on) lines_.push_back(at + 1);
  }
}

/// The characters of a line, without its end.
std::string_view EditedText::line_at(std::size_t line) const {
  const std::size_t end = line + 1 < lines_.size() ? lines_[line + 1] : text_.size();
  std::string_view all = std::string_view(text_).substr(lines_[line], end - lines_[line]);
  while (line + 1 < lines_.size() && !all.empty() && (all.back() == '\n' || all.back() == '\r')) all.remove_suffix(1);
  return all;
}

std::size_t EditedText::units_of(std::string_view character) const {
  switch (unit_) {
    case PositionUnit::utf8:
      return character.size();
    case PositionUnit::utf16:
      return character.size() == 4 ? 2 : 1;
    case PositionUnit::utf32:
      return 1;
  }
  return 1;
}

std::size_t EditedText::byte_of(EditorPosition position) const {
  if (position.line >= lines_.size()) return text_.size();
  const std::string_view line = line_at(position.line);
  if (unit_ == PositionUnit::utf8)
    return lines_[position.line] + std::min<std::size_t>(position.character, line.size());
  std::size_t at = 0, left = position.character;
  while (at < line.size() && left > 0) {
    const std::string_view character = character_of(line.substr(at));
    if (units_of(character) > left) break;
    left -= units_of(character);
    at += character.size();
  }
  return lines_[position.line] + at;
}

EditorPosition EditedText::position_of(std::size_t byte) const {
  byte = std::min(byte, text_.size());
  const auto behind = std::ranges::upper_bound(lines_, byte);
  const auto line = static_cast<std::size_t>(behind - lines_.begin()) - 1;
  const std::string_view before = std::string_view(text_).substr(lines_[line], byte - lines_[line]);
  std::size_t units = 0;
  for (std::size_t at = 0; at < before.size();) {
    const std::string_view character = character_of(before.substr(at));
    units += units_of(character);
    at += character.size();
  }
  return {static_cast<std::uint32_t>(line), static_cast<std::uint32_t>(units)};
}

std::size_t EditedText::byte_of(zed::Place place) const {
  if (place.line == 0) return 0;
  if (place.line > z_lines_.size()) return text_.size();
  std::size_t at = z_lines_[place.line - 1];
  for (std::uint32_t column = 1; column < place.column && at < text_.size() && text_[at] != '\n'; ++column) {
    ++at;
    while (at < text_.size() && text::continues(text_[at])) ++at;
  }
  return at;
}

std::size_t EditedText::part(EditorPosition position) {
  const std::size_t at = byte_of(position);
  if (unit_ != PositionUnit::utf16 || position.line >= lines_.size()) return at;
  const std::string_view character = character_of(std::string_view(text_).substr(at));
  const std::size_t end = lines_[position.line] + line_at(position.line).size();
  if (at >= end || character.size() != 4 || position_of(at).character == position.character) return at;
  const unsigned code = static_cast<unsigned>(text::decode(character)->code) - 0x10000U;
  text_.replace(at, 4, half(first_high + (code >> 10U)) + half(first_low + (code & 0x3FFU)));
  index();
  return at + 3;
}

/// Makes two halves that meet at a byte the character that they are of.
void EditedText::join(std::size_t byte) {
  if (byte < 3) return;
  const unsigned high = half_at(text_, byte - 3), low = half_at(text_, byte);
  if (high < first_high || high >= first_low || low < first_low) return;
  const unsigned code = 0x10000U + ((high - first_high) << 10U) + (low - first_low);
  text_.replace(byte - 3, 6, text::encode(code));
}

void EditedText::edit(EditorPosition from, EditorPosition to, std::string_view now) {
  part(to);  // the first position stays where it is: what is parted stands behind it, or is the same character
  const std::size_t begin = part(from), end = std::max(begin, byte_of(to));
  text_.replace(begin, end - begin, now);
  join(begin);  // what was put in has no halves
  index();
}

}  // namespace durero::lsp
