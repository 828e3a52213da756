#pragma once
/// Words and their strokes are made of these classes of ASCII characters.

namespace durero::zed {

constexpr bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }
constexpr bool is_digit(char c) { return c >= '0' && c <= '9'; }
constexpr bool is_space(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r' || c == '\f'; }
constexpr bool is_stroke(char c) { return c == '\'' || c == '!' || c == '?'; }

}  // namespace durero::zed
