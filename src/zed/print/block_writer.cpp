#include "zed/print/block_writer.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "zed/print/layout.hpp"
#include "zed/print/regrouping_marks.hpp"
#include "zed/print/spelling.hpp"
#include "zed/print/spivey_tokens.hpp"
#include "zed/syntax/block_parser.hpp"
#include "zed/syntax/connectives.hpp"
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

/// The environment that a piece has in another mark-up. A conjecture, of which fuzz knows nothing, is a theorem in
/// Spivey's Z; a predicate by itself is a box without declarations in ISO's.
std::string environment_in(Form to, const BlockPiece& piece) {
  const std::string& now = piece.block.environment;
  if (to != Form::spivey) return piece.share == Share::constraint ? "axdef" : now;
  if (piece.share == Share::claim) return "theorem";
  const auto* const box = std::get_if<Axiomatic>(&piece.paragraphs.front().form);
  return now == "axdef" && box != nullptr && box->text.declarations.empty() ? "zed" : now;
}

/// Writes one piece in another mark-up.
class BlockWriter {
 public:
  BlockWriter(const BlockPiece& piece, Form to, const Dialect& dialect, const SchemaNames& known, bool regrouped)
      : BlockWriter(piece, to, dialect, lex(piece.block, dialect.markup, dialect.operators), known, regrouped) {}

  std::string text() {
    begin();
    for (std::size_t i = first_; i < tokens_.size(); ++i) {
      if (is_left_out(i)) continue;
      if (i > 0 || title_ == 0) is_left_out(i - 1) ? void(out_ += ' ') : gap(i);
      out_ += spelled(i);
      if (i == 0 && environment_ == "schema" && to_latex()) out_ += '}';
    }
    end();
    return std::move(out_);
  }

 private:
  BlockWriter(const BlockPiece& piece, Form to, const Dialect& dialect, const std::vector<Token>& tokens,
              const SchemaNames& known, bool regrouped)
      : block_(piece.block),
        to_(to),
        environment_(environment_in(to, piece)),
        markup_(dialect.markup),
        tokens_(without_line_ends(tokens)),
        spelling_(dialect.markup),
        title_(in_title(block_, tokens_)),
        where_(where()) {
    if (to_ == Form::spivey) marks_ = spivey_marks(tokens, piece, known);
    if (regrouped) marks_ = regrouping_marks(tokens, regrouping_of(block_.environment, tokens), spelling_, to_latex());
    for (std::size_t i = 0, seen = 0; i < tokens.size(); ++i)
      tokens[i].type == Token::Type::newline ? void(separated_.insert(seen)) : void(++seen);
    first_ = block_.environment == "axdef" && environment_ == "zed" ? 1 : 0;
  }

  bool to_latex() const { return to_ != Form::unicode; }

  void begin() {
    const std::string& form = environment_;
    if (to_latex()) {
      out_ = "\\begin{" + form + "}" + (form == "schema" ? "{" : form == "theorem" ? "{}" : "");
    } else {
      const bool generic = form == "gendef" || (form == "schema" && title_ > 1);
      out_ = form == "schema" ? "┌" : form == "axdef" || form == "gendef" ? "╷" : "─";
      if (generic) out_ += "═";
      if (form == "schema" || form == "zsection") out_ += ' ';
    }
    if (form == "axdef" && block_.environment == "zed") out_ += to_latex() ? "\n\\where" : "\n|";
  }

  void end() {
    Layout last = between(tokens_.empty() ? 0 : tokens_.back().to, block_.body.size());
    formal(last);
    last.back().indent = 0;
    out_ += written(last, Break::formal);
    if (to_latex()) out_.erase(out_.find_last_not_of(' ') + 1);
    out_ += to_latex() ? "\\end{" + environment_ + "}" : "└";
  }

  Layout between(std::size_t from, std::size_t to) const {
    const std::string_view text = block_.body.substr(from, to - from);
    return block_.unicode ? layout_of_unicode(text) : layout_of_latex(text);
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
    if (is_bare && mark(marks_.instead, i) == ",") return;
    if (i == 0 && is_bare && block_.environment == "zsection" && !to_latex()) return;
    const bool is_formal = i == title_ || i == where_ || (where_ && i == *where_ + 1);
    if (is_formal) formal(layout);
    if (i == where_ || (to_ == Form::spivey && i == title_ && i > 0)) layout.back().indent = 0;  // fuzz has no \t there
    if (layout.size() == 1 && i > 0) {
      out_ += beside(i, i < title_ ? 0 : layout.front().blanks);
      return;
    }
    if (to_ == Form::spivey && !is_formal && !separated_.contains(i) && !is_infix(tokens_[i - 1]))
      return unmarked_break(layout);
    out_ += written(layout, is_formal ? Break::formal : Break::marked);
    if (to_latex() && i == where_) out_.erase(out_.find_last_not_of(' ') + 1);
  }

  /// Writes the line end before a token where it separates nothing. fuzz takes \\ there for a separator, but behind an
  /// infix sign, and \t only behind \\.
  void unmarked_break(const Layout& layout) {
    Layout kept = {layout.front()};
    for (std::size_t i = 1; i + 1 < layout.size(); ++i)
      if (!layout[i].comment.empty()) kept.push_back(layout[i]);
    kept.emplace_back();
    out_ += written(kept, Break::formal);
  }
  static bool is_infix(const Token& token) {
    static constexpr std::array<std::string_view, 12> signs = {
        ";", ":", ",", "|", "•", "==", "×", "&", "::=", "then", "else", "⧹"};
    if (token.own != nullptr) return token.own->of->has_left() && token.own->of->has_right();
    const Connective* const sign = token.symbol->connective;
    return lexing::among(token.text, signs) || token.symbol->infix != nullptr || (sign != nullptr && !sign->prefix);
  }

  /// Writes the blanks between a token and the one before it on its line; there are more where it needs them.
  std::string beside(std::size_t i, std::size_t blanks) const {
    const Token &left = tokens_[i - 1], &right = tokens_[i];
    if (to_ == Form::spivey) return gap_in_spivey(left, core(i - 1), right, core(i), blanks);
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
    return mark(marks_.before, i) + core(i) + mark(marks_.behind, i);
  }
  /// Says whether a token is not written: something else says it.
  bool is_left_out(std::size_t i) const {
    const auto found = marks_.instead.find(i);
    return found != marks_.instead.end() && found->second.empty();
  }

  /// Spells a token without the signs that are added.
  std::string core(std::size_t i) const {
    const auto found = marks_.instead.find(i);
    if (found != marks_.instead.end()) return found->second;
    if (to_ == Form::spivey) return in_spivey(tokens_[i], markup_);
    return to_latex() ? spelling_.latex(tokens_[i], takes_operand(i)) : Spelling::unicode(tokens_[i]);
  }
  static std::string mark(const std::map<std::size_t, std::string>& marks, std::size_t i) {
    const auto found = marks.find(i);
    return found == marks.end() ? "" : found->second;
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
  Form to_;
  std::string environment_;
  const Markup& markup_;
  std::vector<Token> tokens_;
  Spelling spelling_;
  std::size_t title_;
  std::optional<std::size_t> where_;
  SpiveyMarks marks_;
  std::set<std::size_t> separated_;  // a line end that separates stands before these tokens
  std::size_t first_ = 0;            // the tokens before are not written
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

std::string in_other_form(const BlockPiece& piece, Form to, const Dialect& dialect, const SchemaNames& known,
                          bool regrouped) {
  return BlockWriter(piece, to, dialect, known, regrouped).text();
}

}  // namespace durero::zed
