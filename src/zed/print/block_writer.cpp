#include "zed/print/block_writer.hpp"

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

#include "zed/print/layout.hpp"
#include "zed/print/spelling.hpp"
#include "zed/syntax/lexer.hpp"
#include "zed/syntax/lexer_base.hpp"

namespace durero::zed {
namespace {

std::vector<Token> without_line_ends(const std::vector<Token>& tokens) {
  std::vector<Token> kept;
  for (const Token& token : tokens)
    if (token.type != Token::Type::newline && token.type != Token::Type::end) kept.push_back(token);
  return kept;
}

/// Writes one paragraph in the other mark-up.
class BlockWriter {
 public:
  BlockWriter(const Block& block, const Dialect& dialect)
      : block_(block),
        tokens_(without_line_ends(lex(block, dialect.markup, dialect.operators))),
        spelling_(dialect.markup),
        title_(in_title(block, tokens_)),
        where_(where()) {}

  std::string text() {
    begin();
    for (std::size_t i = 0; i < tokens_.size(); ++i) {
      if (i > 0 || title_ == 0) gap(i);
      out_ += spelled(i);
      if (i == 0 && block_.environment == "schema" && to_latex()) out_ += '}';
    }
    end();
    return std::move(out_);
  }

 private:
  bool to_latex() const { return block_.unicode; }

  void begin() {
    const std::string& form = block_.environment;
    if (to_latex()) {
      out_ = "\\begin{" + form + "}" + (form == "schema" ? "{" : "");
      return;
    }
    const bool generic = form == "gendef" || (form == "schema" && title_ > 1);
    out_ = form == "schema" ? "┌" : form == "axdef" || form == "gendef" ? "╷" : "─";
    if (generic) out_ += "═";
    if (form == "schema" || form == "zsection") out_ += ' ';
  }

  void end() {
    Layout last = between(tokens_.empty() ? 0 : tokens_.back().to, block_.body.size());
    formal(last);
    last.back().indent = 0;
    out_ += written(last, Break::formal);
    if (to_latex()) out_.erase(out_.find_last_not_of(' ') + 1);
    out_ += to_latex() ? "\\end{" + block_.environment + "}" : "└";
  }

  Layout between(std::size_t from, std::size_t to) const {
    const std::string_view text = block_.body.substr(from, to - from);
    return to_latex() ? layout_of_unicode(text) : layout_of_latex(text);
  }
  std::string written(const Layout& layout, Break kind) const {
    return to_latex() ? in_latex(layout, kind) : in_unicode(layout);
  }

  /// A line ends here, whether or not the text says it.
  static void formal(Layout& layout) {
    if (layout.size() == 1) layout.emplace_back();
  }

  /// Writes what stands before a token.
  void gap(std::size_t i) {
    Layout layout = between(i == 0 ? 0 : tokens_[i - 1].to, tokens_[i].from);
    const bool is_bare = layout.size() == 1 && layout.front().comment.empty();
    if (i == 0 && is_bare && block_.environment == "zsection" && !to_latex()) return;
    const bool is_formal = i == title_ || i == where_ || (where_ && i == *where_ + 1);
    if (is_formal) formal(layout);
    if (i == where_) layout.back().indent = 0;
    if (layout.size() == 1 && i > 0) {
      out_ += beside(i, i < title_ ? 0 : layout.front().blanks);
      return;
    }
    out_ += written(layout, is_formal ? Break::formal : Break::marked);
    if (to_latex() && i == where_) out_.erase(out_.find_last_not_of(' ') + 1);
  }

  /// Writes the blanks between a token and the one before it on its line; there are more where it needs them.
  std::string beside(std::size_t i, std::size_t blanks) const {
    const Token &left = tokens_[i - 1], &right = tokens_[i];
    if (blanks == 0 && spelling_.separates(left, right, !takes_operand(i - 1))) blanks = 1;
    std::string text(blanks, ' ');
    if (!to_latex() || blanks == 0) return text;
    if (spelling_.joins(left, right) || (blanks > 1 && lexing::among(left.text, lexing::opening))) text.front() = '~';
    if (blanks > 1 && lexing::among(right.text, lexing::closing)) text.back() = '~';  // TeX drops other blanks
    return text;
  }

  /// Says whether an operand stands before a token, so that its `-` is the difference.
  bool takes_operand(std::size_t i) const { return i > 0 && (lexing::ends(tokens_[i - 1]) || tokens_[i - 1].is("_")); }

  std::string spelled(std::size_t i) const {
    if (i == where_) return to_latex() ? "\\where" : "|";
    return to_latex() ? spelling_.latex(tokens_[i], takes_operand(i)) : Spelling::unicode(tokens_[i]);
  }

  /// The token between declarations and predicates of a box that has a line for itself: `\where`, ├, or the first `|`
  /// outside of brackets that is alone on its line.
  std::optional<std::size_t> where() const {
    if (block_.environment == "zed" || block_.environment == "zsection") return {};
    int depth = 0;
    for (std::size_t i = title_; i < tokens_.size(); ++i) {
      const Token& token = tokens_[i];
      if (token.is("(") || token.is("[") || token.is("{")) ++depth;
      if (token.is(")") || token.is("]") || token.is("}")) --depth;
      if (!token.is("|") || depth > 0) continue;
      const std::string_view source = block_.body.substr(token.from, token.to - token.from);
      if (source == "\\where" || source == "├" || (block_.unicode && is_alone(i))) return i;
      return {};
    }
    return {};
  }
  bool is_alone(std::size_t i) const {
    const unsigned line = tokens_[i].place.line;
    return (i == 0 || tokens_[i - 1].place.line < line) &&
           (i + 1 == tokens_.size() || tokens_[i + 1].place.line > line);
  }

  const Block& block_;
  std::vector<Token> tokens_;
  Spelling spelling_;
  std::size_t title_;
  std::optional<std::size_t> where_;
  std::string out_;
};

}  // namespace

std::size_t in_title(const Block& block, const std::vector<Token>& tokens) {
  const std::size_t named = block.environment == "schema" ? 1 : 0;
  if (named == 0 && block.environment != "gendef") return 0;
  if (tokens.size() <= named || !tokens[named].is("[") || tokens[named].place.line != tokens[0].place.line)
    return std::min(named, tokens.size());
  std::size_t at = named + 1;
  while (at + 1 < tokens.size() && tokens[at].type == Token::Type::word && tokens[at + 1].is(",")) at += 2;
  return at + 1 < tokens.size() && tokens[at].type == Token::Type::word && tokens[at + 1].is("]") ? at + 2 : named;
}

std::string in_other_form(const Block& block, const Dialect& dialect) { return BlockWriter(block, dialect).text(); }

}  // namespace durero::zed
