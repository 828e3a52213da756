#include "durero/zed/syntax/parser.hpp"

#include <algorithm>
#include <utility>

#include "zed/syntax/block_parser.hpp"
#include "zed/syntax/lexer.hpp"
#include "zed/syntax/term_parser.hpp"

namespace durero::zed {
namespace {

class ParagraphParser {
 public:
  explicit ParagraphParser(const std::vector<Token>& tokens) : in_(tokens), terms_(in_) {}

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

  Term only_term() {
    Term term = terms_.term();
    finish();
    return term;
  }

 private:
  void line(std::vector<Paragraph>& paragraphs, Place place) {
    for (const std::string_view keyword : {"function", "generic", "relation"})
      if (in_.sees(keyword))
        in_.fail("expected no operator template: those of the standard toolkit are built in, and no others are read");
    if (in_.accept("[")) {
      paragraphs.push_back({place, given()});
    } else if (in_.accept("⊢?")) {
      const std::size_t from = in_.position();
      Conjecture claim{{terms_.term(), {}, place}};
      claim.claim.label = in_.label_since(from);
      paragraphs.push_back({place, std::move(claim)});
    } else {
      named(paragraphs, place);
    }
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
    if (!in_.at_end()) in_.fail("expected the end of the paragraph, or an operator");
  }

  TokenStream in_;
  TermParser terms_;
};

}  // namespace

SectionHeader parse_header(const std::vector<Token>& tokens) { return ParagraphParser(tokens).header(); }

std::vector<Paragraph> parse_block(std::string_view environment, const std::vector<Token>& tokens,
                                   std::vector<ZError>& mended) {
  ParagraphParser parser(tokens);
  std::vector<Paragraph> paragraphs;
  if (environment == "zed") {
    paragraphs = parser.lines();
  } else if (environment == "schema") {
    paragraphs.push_back(parser.schema());
  } else {
    paragraphs.push_back(parser.axiomatic(environment == "gendef"));
  }
  mended = std::move(parser.mended);
  return paragraphs;
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

Term parse_unicode(std::string_view text) {
  const std::vector<Token> tokens = lex_unicode(text);
  return ParagraphParser(tokens).only_term();
}

Paragraph parse_unicode_paragraph(std::string_view text) {
  static constexpr std::string_view top = "┌─", side = "│", middle = "├─", bottom = "└─";
  std::string environment = "zed", plain;
  while (!text.empty()) {
    std::string_view line = text.substr(0, text.find('\n'));
    text.remove_prefix(std::min(line.size() + 1, text.size()));
    if (line.starts_with(top)) {
      line.remove_prefix(top.size());
      const std::size_t title = line.find_first_not_of(' ');
      environment = title == line.npos ? "axdef" : line[title] == '[' ? "gendef" : "schema";
    } else if (line.starts_with(side)) {
      line.remove_prefix(side.size());
    } else if (line.starts_with(middle) || line.starts_with(bottom)) {
      line = line.starts_with(middle) ? "|" : "";
    }
    plain += std::string(line) + "\n";
  }
  const std::vector<Token> tokens = lex_unicode(plain);
  std::vector<ZError> mended;
  std::vector<Paragraph> paragraphs = parse_block(environment, tokens, mended);
  if (!mended.empty()) throw mended[0];
  if (paragraphs.size() != 1) throw ZError(paragraphs[1].place, "more than one paragraph", "expected one");
  return std::move(paragraphs[0]);
}

Term parse_latex(std::string_view text, const Markup& markup) {
  Block block;
  block.environment = "zed";
  block.body = text;
  block.place = {1, 1};
  const std::vector<Token> tokens = lex_latex(block, markup);
  return ParagraphParser(tokens).only_term();
}

}  // namespace durero::zed
