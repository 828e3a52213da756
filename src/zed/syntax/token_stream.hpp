#pragma once
/// The parsers of terms and of paragraphs share a position in the tokens, and errors that say where.

#include <string>
#include <string_view>
#include <vector>

#include "durero/zed/syntax/defect.hpp"
#include "zed/syntax/token.hpp"

namespace durero::zed {

class TokenStream {
 public:
  /// Whether they are `spivey`s is for the parsers, who bind operators by it.
  explicit TokenStream(const std::vector<Token>& tokens, bool spivey = false) : tokens_(tokens), spivey_(spivey) {}

  /// Says whether the tokens are read as Spivey's Z.
  bool is_spivey() const { return spivey_; }

  /// Returns the token `ahead` places on; at the end, the last one.
  const Token& peek(std::size_t ahead = 0) const {
    const std::size_t at = at_ + ahead;
    return at < tokens_.size() ? tokens_[at] : tokens_.back();
  }
  /// Returns the token `back` places before here. Precondition: there are so many.
  const Token& before(std::size_t back) const { return tokens_[at_ - back]; }
  const Token& next() {
    const Token& token = peek();
    if (at_ + 1 < tokens_.size()) ++at_;
    return token;
  }
  bool at_end() const { return peek().type == Token::Type::end; }
  bool sees(std::string_view symbol) const { return peek().is(symbol); }
  bool sees(Token::Type type) const { return peek().type == type; }
  bool accept(std::string_view symbol) {
    if (!sees(symbol)) return false;
    next();
    return true;
  }
  bool accept(Token::Type type) {
    if (!sees(type)) return false;
    next();
    return true;
  }
  void expect(std::string_view symbol) {
    if (!accept(symbol)) fail("expected " + std::string(symbol));
  }

  std::size_t position() const { return at_; }

  /// Says whether a token can be a name: it is a word, but no keyword and no operator.
  static bool is_name(const Token& token) {
    return !token.own && token.type == Token::Type::word && token.symbol->may_be_name();
  }
  bool sees_name() const { return is_name(peek()); }
  Name name() {
    if (!sees_name()) fail("expected a name");
    const Token& token = next();
    return {token.text, token.strokes};
  }

  /// Returns the label on the tokens from `from` to here; two of them are an error.
  std::string label_since(std::size_t from) const {
    std::string label;
    for (std::size_t i = from; i < at_; ++i) {
      if (tokens_[i].label.empty()) continue;
      if (!label.empty())
        throw ZError(tokens_[i].place, "the labels " + label + " and " + tokens_[i].label + " stand on one predicate",
                     "expected one label a predicate");
      label = tokens_[i].label;
    }
    return label;
  }

  /// Refuses the token `ahead` places on.
  [[noreturn]] void fail(const std::string& expected, std::size_t ahead = 0) const {
    const Token& token = peek(ahead);
    if (token.type == Token::Type::error) throw ZError(token.place, token.text, token.label);
    std::string seen = "unexpected " + token.text + token.strokes;
    if (token.type == Token::Type::end) seen = "the text ends too early";
    if (token.type == Token::Type::newline) seen = "unexpected new line";
    throw ZError(token.place, seen, expected);
  }

 private:
  const std::vector<Token>& tokens_;
  bool spivey_;
  std::size_t at_ = 0;
};

}  // namespace durero::zed
