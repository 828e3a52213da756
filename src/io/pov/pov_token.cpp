#include "pov_token.hpp"

#include <algorithm>
#include <string>

namespace durero::io {
namespace {

constexpr std::string_view blanks = " \t\v\f\r\n\x1a";
constexpr std::string_view digits = "0123456789";

bool begins_name(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; }
bool is_digit(char c) { return c >= '0' && c <= '9'; }

/// Walks a text token by token.
class PovLexer {
 public:
  explicit PovLexer(const Source& source) : source_(source), text_(source.text()) {}

  PovTokens all() {
    PovTokens tokens;
    for (next_ = behind_comments(0); next_ < text_.size(); next_ = behind_comments(next_)) {
      const std::size_t begin = next_;
      next_ = end_of(begin);
      tokens.push_back({text_.substr(begin, next_ - begin), &source_, begin});
    }
    return tokens;
  }

 private:
  std::size_t behind_comments(std::size_t from) const {
    while (true) {
      from = std::min(text_.find_first_not_of(blanks, from), text_.size());
      const std::size_t behind = behind_comment(from);
      if (behind == from) return from;
      from = behind;
    }
  }

  // Comments between /* and */ may stand in each other.
  std::size_t behind_comment(std::size_t from) const {
    if (text_.substr(from, 2) == "//") return std::min(text_.find_first_of("\r\n", from), text_.size());
    if (text_.substr(from, 2) != "/*") return from;
    std::size_t next = from + 2;
    for (std::size_t open = 1; open > 0;) {
      next = text_.find_first_of("*/", next);
      if (next == text_.npos) source_.fail(from, "a comment that does not end", "expected */");
      const std::string_view two = text_.substr(next, 2);
      if (two == "/*") ++open;
      if (two == "*/") --open;
      next += two == "/*" || two == "*/" ? 2 : 1;
    }
    return next;
  }

  std::size_t end_of(std::size_t from) const {
    const char c = text_[from];
    if (c == '"') return end_of_text(from);
    if (c == '#') return end_of_name(behind_blanks(from + 1));
    if (begins_name(c)) return end_of_name(from);
    if (is_digit(c) || (c == '.' && from + 1 < text_.size() && is_digit(text_[from + 1]))) return end_of_number(from);
    const std::string_view two = text_.substr(from, 2);
    return from + (two == "<=" || two == ">=" || two == "!=" ? 2 : 1);
  }
  std::size_t behind_blanks(std::size_t from) const {
    return std::min(text_.find_first_not_of(" \t", from), text_.size());
  }
  std::size_t end_of_name(std::size_t from) const {
    while (from < text_.size() && (begins_name(text_[from]) || is_digit(text_[from]))) ++from;
    return from;
  }
  std::size_t behind_digits(std::size_t from) const {
    return std::min(text_.find_first_not_of(digits, from), text_.size());
  }
  std::size_t end_of_number(std::size_t from) const {
    std::size_t end = behind_digits(from);
    if (text_.substr(end, 1) == ".") end = behind_digits(end + 1);
    if (end < text_.size() && (text_[end] == 'e' || text_[end] == 'E')) {
      const bool is_signed = end + 1 < text_.size() && (text_[end + 1] == '+' || text_[end + 1] == '-');
      const std::size_t exponent = end + (is_signed ? 2 : 1);
      if (behind_digits(exponent) > exponent) end = behind_digits(exponent);
    }
    return end;
  }
  std::size_t end_of_text(std::size_t from) const {
    std::size_t next = text_.find_first_of("\"\\", from + 1);
    while (next != text_.npos && text_[next] == '\\') next = text_.find_first_of("\"\\", next + 2);
    if (next == text_.npos) source_.fail(from, "a text that does not end", "expected \"");
    return next + 1;
  }

  const Source& source_;
  std::string_view text_;
  std::size_t next_ = 0;
};

}  // namespace

bool PovToken::is_name() const { return !text.empty() && begins_name(text.front()); }
bool PovToken::is_number() const {
  return !text.empty() && (is_digit(text.front()) || (text.front() == '.' && text.size() > 1));
}

PovTokens pov_tokens(const Source& source) { return PovLexer(source).all(); }

std::string unquoted_pov_text(std::string_view quoted) {
  std::string text;
  for (std::size_t i = 1; i + 1 < quoted.size(); ++i) {
    if (quoted[i] == '\\' && i + 2 < quoted.size() && (quoted[i + 1] == '"' || quoted[i + 1] == '\\')) ++i;
    text += quoted[i];
  }
  return text;
}

std::string pov_normal_text(std::string_view text) {
  const Source source("", std::string(text));
  std::string joined;
  for (const PovToken& token : pov_tokens(source)) joined.append(joined.empty() ? "" : " ").append(token.text);
  return joined;
}

}  // namespace durero::io
