#include "zed/print/spivey_tokens.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "durero/zed/syntax/defect.hpp"
#include "zed/print/spelling.hpp"
#include "zed/syntax/characters.hpp"
#include "zed/syntax/connectives.hpp"
#include "zed/syntax/lexer_base.hpp"
#include "zed/syntax/token_stream.hpp"

namespace durero::zed {
namespace {

/// Looks through the tokens of a piece for what Spivey's Z writes otherwise.
class MarkSearch {
 public:
  MarkSearch(const std::vector<Token>& tokens, const SchemaNames& known) : known_(known) {
    for (const Token& token : tokens) {
      if (token.type == Token::Type::newline) breaks_.push_back(tokens_.size());
      if (token.type != Token::Type::newline && token.type != Token::Type::end) tokens_.push_back(&token);
    }
  }

  SpiveyMarks run(const BlockPiece& piece) {
    for (const Paragraph& paragraph : piece.paragraphs)
      if (const auto* const definition = std::get_if<Definition>(&paragraph.form))
        if (defines_schema(*definition, known_)) mark_definition(paragraph.place);
    for (std::size_t i = 0; i < tokens_.size(); ++i)
      if (tokens_[i]->symbol->quantifier != nullptr) enclose(i);
    mark_breaks();
    return std::move(marks_);
  }

 private:
  bool is_break(std::size_t before) const { return std::ranges::binary_search(breaks_, before); }
  static bool opens(const Token& token) { return lexing::among(token.text, lexing::opening) || token.is("⦇"); }
  static bool closes(const Token& token) { return lexing::among(token.text, lexing::closing) || token.is("⦈"); }

  /// The first == outside of brackets behind the beginning of a definition is its sign.
  void mark_definition(Place place) {
    const auto begin = std::ranges::find(tokens_, place, [](const Token* token) { return token->place; });
    int depth = 0;
    for (auto i = static_cast<std::size_t>(begin - tokens_.begin()); i < tokens_.size(); ++i) {
      if (opens(*tokens_[i])) ++depth;
      if (closes(*tokens_[i])) --depth;
      if (depth > 0 || !tokens_[i]->is("==")) continue;
      marks_.instead[i] = "\\defs";
      return;
    }
  }

  /// Says whether a quantifier may stand behind a token without parentheses: where a predicate begins.
  bool begins_predicate(std::size_t i) const {
    static constexpr std::array<std::string_view, 8> signs = {"|", ";", "•", "(", "⊢?", "if", "==", "["};
    return i == 0 || is_break(i) || lexing::among(tokens_[i - 1]->text, signs);
  }

  void enclose(std::size_t i) {
    const std::size_t end = end_of_body(i);
    const bool fills =
        i > 0 && end < tokens_.size() && (tokens_[i - 1]->is("(") || tokens_[i - 1]->is("⦇")) && closes(*tokens_[end]);
    if (fills || (tokens_[i]->symbol->quantifier->logical && begins_predicate(i))) return;
    marks_.before[i] += "(";
    marks_.behind[end - 1] += ")";
  }

  static bool relates(const Token& token) {
    if (token.own) return token.own->of->role == Role::relation;
    return token.symbol->infix && token.symbol->infix->role == Role::relation;
  }

  /// Returns where the body of a quantifier ends: as far to the right as brackets and separators let it, and before a
  /// relation where it is an expression. Those between a quantifier and its • are of its schema text.
  std::size_t end_of_body(std::size_t from) const {
    static constexpr std::array<std::string_view, 8> separators = {",", ";", "|", "•", "then", "else", "⟫", "&"};
    const bool is_value = tokens_[from]->is("λ") || tokens_[from]->is("μ");
    int depth = 0, open = 0;
    for (std::size_t i = from; i < tokens_.size(); ++i) {
      const Token& token = *tokens_[i];
      const bool ends = is_break(i) || lexing::among(token.text, separators) || (is_value && relates(token));
      if (depth == 0 && open == 0 && i > from && ends) return i;
      if (opens(token)) ++depth;
      if (closes(token) && --depth < 0) return i;
      if (depth > 0) continue;
      if (token.symbol->quantifier != nullptr) ++open;
      if (token.is("•")) --open;
    }
    return tokens_.size();
  }

  /// A line end inside of parentheses is ∧, and between other brackets a semicolon.
  void mark_breaks() {
    std::vector<const Token*> open;
    for (std::size_t i = 0; i < tokens_.size(); ++i) {
      if (is_break(i) && !open.empty()) marks_.behind[i - 1] += open.back()->is("(") ? " \\land" : ";";
      if (opens(*tokens_[i])) open.push_back(tokens_[i]);
      if (closes(*tokens_[i]) && !open.empty()) open.pop_back();
    }
  }

  const SchemaNames& known_;
  std::vector<const Token*> tokens_;
  std::vector<std::size_t> breaks_;  // line ends stand before these
  SpiveyMarks marks_;
};

/// Says whether a spelling is a name's: letters, digits and \_, or one command, with strokes.
bool is_spivey_name(std::string_view text) {
  for (const std::string_view greek : {"\\Delta ", "\\Xi "})
    if (text.starts_with(greek)) text.remove_prefix(greek.size());
  const bool is_command = text.starts_with('\\');
  if (is_command) text.remove_prefix(1);
  if (text.empty() || !is_letter(text.front())) return false;
  while (!text.empty()) {
    const bool is_underscore = !is_command && text.starts_with("\\_");
    if (!is_underscore && !is_letter(text.front()) && (is_command || !is_digit(text.front()))) break;
    text.remove_prefix(is_underscore ? 2 : 1);
  }
  while (!text.empty()) {
    const bool is_subscript = text.front() == '_' && text.size() > 1 && is_digit(text[1]);
    if (!is_subscript && !is_stroke(text.front())) return false;
    text.remove_prefix(is_subscript ? 2 : 1);
  }
  return true;
}

/// Says whether a spelling ends in a command's letters, which TeX would read on over a letter.
bool ends_in_command(std::string_view text) {
  const std::size_t backslash = text.rfind('\\');
  return backslash != text.npos && backslash + 1 < text.size() &&
         std::all_of(text.begin() + static_cast<std::ptrdiff_t>(backslash) + 1, text.end(), is_letter);
}

}  // namespace

SpiveyMarks spivey_marks(const std::vector<Token>& tokens, const BlockPiece& piece, const SchemaNames& known) {
  return MarkSearch(tokens, known).run(piece);
}

std::string in_spivey(const Token& token, const Markup& markup) {
  static constexpr std::array<std::pair<std::string_view, std::string_view>, 5> own = {
      {{"↗", "\\bsup"}, {"↙", "\\esup"}, {"infix", "\\inseq"}, {"min", "min"}, {"max", "max"}}};
  const auto found =
      std::ranges::find(own, std::string_view(token.text), &std::pair<std::string_view, std::string_view>::first);
  if (token.strokes.empty() && found != own.end()) return std::string(found->second);
  std::string text = Spelling(markup).latex(token, true);
  if (TokenStream::is_name(token) && !is_spivey_name(text))
    throw ZError(token.place, "the name " + Spelling::unicode(token) + " cannot be written in Spivey's Z",
                 "expected letters, digits and _, or one command");
  return text;
}

std::string gap_in_spivey(const Token& left, const std::string& left_text, const Token& right,
                          const std::string& right_text, std::size_t blanks) {
  using Type = Token::Type;
  if (right.type == Type::stroke) return "";
  const bool is_plain = left.type == Type::numeral || (left.type == Type::word && !left_text.starts_with('\\'));
  const bool goes_on = right.type == Type::numeral || (right.type == Type::word && !right_text.starts_with('\\'));
  if (is_plain && goes_on) return "~" + std::string(blanks > 1 ? blanks - 1 : 0, ' ');
  const bool joins = ends_in_command(left_text) && (is_letter(right_text.front()) || is_digit(right_text.front()));
  return std::string(joins ? std::max<std::size_t>(blanks, 1) : blanks, ' ');
}

}  // namespace durero::zed
