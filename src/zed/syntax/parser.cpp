#include "durero/zed/syntax/parser.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "zed/syntax/block_parser.hpp"
#include "zed/syntax/lexer.hpp"
#include "zed/syntax/term_parser.hpp"

namespace durero::zed {
namespace {

bool begins_template(const Token& token) { return token.is("function") || token.is("generic") || token.is("relation"); }

class ParagraphParser {
 public:
  explicit ParagraphParser(const std::vector<Token>& tokens, bool spivey = false, IsoGrouping* regrouping = nullptr)
      : in_(tokens, spivey), terms_(in_, regrouping) {}

  /// Parses the tokens of a block of that environment.
  std::vector<Paragraph> block(std::string_view environment) {
    if (environment == "zed") return lines();
    std::vector<Paragraph> paragraphs;
    paragraphs.push_back(environment == "schema" ? schema() : axiomatic(environment == "gendef"));
    return paragraphs;
  }

  std::vector<ZError> mended;

  /// Parses the paragraphs of a `zed` environment, which are one a line.
  std::vector<Paragraph> lines() {
    std::vector<Paragraph> paragraphs;
    do {
      const Place place = in_.peek().place;
      line(paragraphs, place);
    } while (in_.accept(Token::Type::newline));
    finish();
    return paragraphs;
  }

  Paragraph schema() {
    const Place place = in_.peek().place;
    Schema schema;
    schema.name = in_.name();
    if (in_.peek().place.line == place.line) schema.formals = formals();  // a schema text may begin the next line
    schema.text = body();
    return {place, std::move(schema)};
  }

  Paragraph axiomatic(bool generic) {
    const Place place = in_.peek().place;
    Axiomatic box;
    if (generic) box.formals = formals();
    if (generic && box.formals.empty()) in_.fail("expected generic formals in [ ]");
    box.text = body();
    return {place, std::move(box)};
  }

  SectionHeader header() {
    SectionHeader header;
    in_.expect("section");
    header.name = in_.name().text();
    if (in_.accept("parents") && in_.sees_name())
      for (const Name& parent : terms_.names()) header.parents.push_back(parent.text());
    finish();
    return header;
  }

  /// Takes \relation (\_ below \_), \function 30 \leftassoc (\_ plus \_) and their kin.
  OperatorTemplate operator_template() {
    OperatorTemplate read;
    const std::string kind = in_.next().text;
    read.role = kind == "function" ? Role::function : kind == "generic" ? Role::generic : Role::relation;
    const bool binds = read.role != Role::relation && in_.sees(Token::Type::numeral);
    if (binds) read.precedence = precedence();
    if (binds && !(in_.sees("leftassoc") || in_.sees("rightassoc"))) in_.fail("expected \\leftassoc or \\rightassoc");
    if (binds) read.right = in_.next().text == "rightassoc";
    in_.expect("(");
    while (!in_.sees(")")) read.parts.push_back(part());
    const bool infix = read.is_infix();
    if (read.role != Role::relation && binds != infix)
      in_.fail(infix ? "expected a precedence before the infix operator" : "expected an infix operator, as it has one");
    if (!is_alternating(read.parts)) in_.fail("expected words and operands by turns in the template");
    in_.next();
    return read;
  }

  Term only_term() {
    Term term = terms_.term();
    finish();
    return term;
  }

 private:
  int precedence() {
    const std::string digits = in_.peek().text;
    if (digits.size() > 2) in_.fail("expected a precedence from 0 to 99");
    in_.next();
    return std::stoi(digits);
  }

  /// Takes an operand's place, a list's, or a word of a template.
  std::string part() {
    const Token& token = in_.peek();
    if (in_.accept(",")) {
      in_.expect(",");
      return ",,";
    }
    const bool word = (token.type == Token::Type::word && token.strokes.empty()) || is_sign_of_toolkit(token);
    if (!word && !token.is("_") && !token.is(",,")) in_.fail("expected _, ,, or a word of the operator");
    return in_.next().text;
  }

  /// Says whether this is a sign of the toolkit's operators, which is free where the section does not see them.
  static bool is_sign_of_toolkit(const Token& token) {
    static constexpr std::array<std::string_view, 6> enclosing = {"⟨", "⟩", "⦇", "⦈", "↗", "↙"};
    return token.type == Token::Type::symbol &&
           (token.own || token.symbol->prefix || token.symbol->infix || token.symbol->postfix ||
            std::ranges::find(enclosing, token.text.text()) != enclosing.end());
  }

  /// Words and operands take turns, and lists stand between two words.
  static bool is_alternating(const std::vector<std::string>& parts) {
    const auto is_slot = [](const std::string& part) { return part == "_" || part == ",,"; };
    if (parts.empty() || parts.front() == ",," || parts.back() == ",,") return false;
    for (std::size_t i = 1; i < parts.size(); ++i)
      if (is_slot(parts[i]) && is_slot(parts[i - 1])) return false;
    return parts.size() > 1 || !is_slot(parts[0]);
  }

  void line(std::vector<Paragraph>& paragraphs, Place place) {
    if (begins_template(in_.peek())) {
      operator_template();
    } else if (claims_generically()) {
      std::vector<Name> generic = formals();
      in_.next();
      conjecture(paragraphs, place, std::move(generic));
    } else if (in_.accept("[")) {
      paragraphs.push_back({place, given()});
    } else if (in_.accept("⊢?")) {
      conjecture(paragraphs, place, {});
    } else if (in_.is_spivey() && !defines()) {
      paragraphs.push_back({place, constraint(place)});
    } else {
      named(paragraphs, place);
    }
  }

  /// Says whether a sign of definition stands in this line outside of brackets.
  bool defines() const {
    int depth = 0;
    for (std::size_t ahead = 0;; ++ahead) {
      const Token& token = in_.peek(ahead);
      if (token.type == Token::Type::newline || token.type == Token::Type::end || token.type == Token::Type::error)
        return token.type == Token::Type::error;
      if (token.is("(") || token.is("[") || token.is("{") || token.is("⦉")) ++depth;
      if (token.is(")") || token.is("]") || token.is("}") || token.is("⦊")) --depth;
      if (token.is("let")) return false;
      if (depth == 0 && (token.is("==") || token.is("::="))) return true;
    }
  }

  Axiomatic constraint(Place place) {
    const std::size_t from = in_.position();
    Predicate predicate{terms_.term(), {}, place};
    predicate.label = in_.label_since(from);
    Axiomatic box;
    box.text.predicates.push_back(std::move(predicate));
    return box;
  }

  void conjecture(std::vector<Paragraph>& paragraphs, Place place, std::vector<Name> generic) {
    const std::size_t from = in_.position();
    Conjecture claim{{terms_.term(), {}, place}, std::move(generic)};
    claim.claim.label = in_.label_since(from);
    paragraphs.push_back({place, std::move(claim)});
  }

  /// Says whether [X, Y] ⊢? stands here.
  bool claims_generically() const {
    std::size_t ahead = 1;
    while (in_.sees("[") && TokenStream::is_name(in_.peek(ahead)) && in_.peek(ahead + 1).is(",")) ahead += 2;
    return in_.sees("[") && in_.peek(ahead + 1).is("]") && in_.peek(ahead + 2).is("⊢?");
  }

  GivenTypes given() {
    GivenTypes given;
    do {
      given.places.push_back(in_.peek().place);
      given.names.push_back(in_.name());
    } while (in_.accept(","));
    in_.expect("]");
    return given;
  }

  void named(std::vector<Paragraph>& paragraphs, Place place) {
    const std::size_t from = in_.position();
    std::vector<Name> operands;
    if (std::optional<Name> op = terms_.operator_name(operands)) {
      if (operands.empty()) operands = formals();
      in_.expect("==");
      Definition definition{std::move(*op), std::move(operands), terms_.term(), {}};
      definition.label = in_.label_since(from);
      paragraphs.push_back({place, std::move(definition)});
      return;
    }
    Name name = in_.name();
    const bool set = in_.sees("::=") && in_.peek(1).is("{");
    if (in_.sees("::=") && !set) return free_types(paragraphs, std::move(name), place);
    Definition definition{std::move(name), formals(), {}, {}};
    if (set) {
      mended.emplace_back(in_.peek(1).place, "a set stands where a free type has its constants and constructors",
                          "expected == before a set, or a name after ::=");
      in_.next();
    } else {
      in_.expect("==");
    }
    definition.value = terms_.term();
    definition.label = in_.label_since(from);
    paragraphs.push_back({place, std::move(definition)});
  }

  void free_types(std::vector<Paragraph>& paragraphs, Name name, Place place) {
    for (bool joined = false;; joined = true) {
      paragraphs.push_back({place, free_type(std::move(name), joined)});
      if (!in_.accept("&")) return;
      place = in_.peek().place;
      name = in_.name();
    }
  }

  FreeType free_type(Name name, bool joined) {
    in_.expect("::=");
    FreeType type{std::move(name), {}, joined};
    do {
      Branch branch;
      branch.place = in_.peek().place;
      if (!in_.sees_name()) in_.fail("expected the name of a constant or constructor");
      branch.name = in_.name();
      if (in_.accept("⟪")) {
        branch.argument = terms_.term();
        in_.expect("⟫");
      }
      type.branches.push_back(std::move(branch));
    } while (in_.accept("|"));
    return type;
  }

  /// Takes the formals [X, Y], if they stand here.
  std::vector<Name> formals() {
    if (!in_.sees("[") || !TokenStream::is_name(in_.peek(1)) || !(in_.peek(2).is(",") || in_.peek(2).is("]")))
      return {};
    in_.next();
    std::vector<Name> names = terms_.names();
    in_.expect("]");
    return names;
  }

  SchemaText body() {
    in_.accept(Token::Type::newline);
    if (in_.at_end()) return {};
    SchemaText text = terms_.schema_text(true);
    finish();
    return text;
  }

  void finish() {
    if (in_.at_end()) return;
    const bool declares = in_.sees(":") && in_.position() > 1 && TokenStream::is_name(in_.before(1));
    if (declares)
      throw ZError(in_.before(1).place,
                   in_.before(2).place.line < in_.before(1).place.line ? "a declaration goes on the line before it"
                                                                       : "a declaration goes on the one before it",
                   "expected a new line \\\\ between the two");
    in_.fail("expected the end of the paragraph, or an operator");
  }

  TokenStream in_;
  TermParser terms_;
};

}  // namespace

std::vector<ReadTemplate> templates_in(const std::vector<Token>& tokens) {
  std::vector<ReadTemplate> found;
  for (std::size_t i = 0; i < tokens.size(); ++i) {
    if (i > 0 && tokens[i - 1].type != Token::Type::newline) continue;
    if (!begins_template(tokens[i])) continue;
    const auto next = std::find_if(tokens.begin() + static_cast<std::ptrdiff_t>(i), tokens.end(),
                                   [](const Token& token) { return token.type == Token::Type::newline; });
    std::vector<Token> line(tokens.begin() + static_cast<std::ptrdiff_t>(i), next);
    line.push_back({Token::Type::end, {}, {}, line.back().place, {}, nullptr, false});
    ParagraphParser parser(line);
    try {
      OperatorTemplate read = parser.operator_template();
      found.push_back({std::move(read), line[0].place, line});
    } catch (const ZError&) {  // it is reported where the block is parsed
    }
  }
  return found;
}

SectionHeader parse_header(const std::vector<Token>& tokens) { return ParagraphParser(tokens).header(); }

std::vector<Paragraph> parse_block(std::string_view environment, const std::vector<Token>& tokens,
                                   std::vector<ZError>& mended, bool spivey) {
  ParagraphParser parser(tokens, spivey);
  std::vector<Paragraph> paragraphs = parser.block(environment);
  mended = std::move(parser.mended);
  return paragraphs;
}

IsoGrouping regrouping_of(std::string_view environment, const std::vector<Token>& tokens) {
  IsoGrouping found;
  ParagraphParser(tokens, true, &found).block(environment);
  return found;
}

std::vector<Name> names_declared(std::string_view environment, const std::vector<Token>& tokens) {
  std::vector<Name> names;
  if (environment == "schema") {
    if (!tokens.empty() && TokenStream::is_name(tokens[0])) names.push_back({tokens[0].text, tokens[0].strokes});
    return names;
  }
  bool branches = false;
  for (std::size_t i = 0; i + 1 < tokens.size(); ++i) {
    const Token& after = tokens[i + 1];
    if (environment == "axdef" && tokens[i].is("|")) break;  // this is \where
    if (tokens[i].is("::=")) branches = true;
    if (tokens[i].type == Token::Type::newline) branches = false;
    const bool declares = after.is(":") || after.is("==") || after.is("::=") || after.is(",");
    if (TokenStream::is_name(tokens[i]) && (branches || declares)) names.push_back({tokens[i].text, tokens[i].strokes});
  }
  return names;
}

Term parse_unicode(std::string_view text, const Operators& operators) {
  const std::vector<Token> tokens = lex_unicode(text, operators);
  return ParagraphParser(tokens).only_term();
}

Paragraph parse_unicode_paragraph(std::string_view text, const Operators& operators) {
  static constexpr std::string_view top = "┌─", bottom = "└─";
  std::string environment = "zed", plain;
  while (!text.empty()) {
    std::string_view line = text.substr(0, text.find('\n'));
    text.remove_prefix(std::min(line.size() + 1, text.size()));
    if (line.starts_with(top)) {
      line.remove_prefix(top.size());
      const std::size_t title = line.find_first_not_of(' ');
      environment = title == line.npos ? "axdef" : line[title] == '[' ? "gendef" : "schema";
    } else if (line.starts_with(bottom)) {
      line = "";
    }
    plain += std::string(line) + "\n";
  }
  const std::vector<Token> tokens = lex_unicode(plain, operators);
  std::vector<ZError> mended;
  std::vector<Paragraph> paragraphs = parse_block(environment, tokens, mended);
  if (!mended.empty()) throw mended[0];
  if (paragraphs.size() != 1) throw ZError(paragraphs[1].place, "more than one paragraph", "expected one");
  return std::move(paragraphs[0]);
}

Term parse_latex(std::string_view text, const Markup& markup, const Operators& operators) {
  Block block;
  block.environment = "zed";
  block.body = text;
  block.place = {1, 1};
  const std::vector<Token> tokens = lex_latex(block, markup, operators);
  return ParagraphParser(tokens).only_term();
}

}  // namespace durero::zed
