/// Parses what binds tightest: applications, and the terms between brackets.

#include <algorithm>
#include <array>
#include <utility>

#include "zed/syntax/term_parser.hpp"

namespace durero::zed {
namespace {

/// Says whether a word is the last of an operator that stands behind its one operand, as a function.
bool is_own_postfix(const Token& token) {
  return token.own && token.own->of->role == Role::function && token.own->of->has_left() && token.own->first() &&
         token.own->last() && !token.own->of->has_right();
}

/// Says whether a word begins an operator that encloses its operands, as ⟨ does in the toolkit.
bool begins_enclosing(const Token& token) {
  return token.own && token.own->of->role == Role::function && token.own->first() && !token.own->of->has_left() &&
         !token.own->of->has_right();
}

}  // namespace

bool TermParser::begins_primary(std::size_t ahead) const {
  const Token& token = in_.peek(ahead);
  if (token.type == Token::Type::numeral || TokenStream::is_name(token)) return true;
  if (token.own) return begins_enclosing(token);
  if (token.type == Token::Type::word) return token.is("true") || token.is("false") || token.is("θ");
  static constexpr std::array<std::string_view, 6> signs = {"(", "{", "⟨", "⦉", "[", "θ"};
  return std::ranges::any_of(signs, [&token](std::string_view sign) { return token.is(sign); });
}

/// In f a b ∼ ⦇ S ⦈ ↗ n ↙ the applications associate to the left, then come the postfix operators. In Spivey's Z these
/// belong to what stands before them alone: f a ∼ is f (a∼).
Term TermParser::application() { return applied(primary()); }

Term TermParser::applied(Term function) {
  while (begins_primary()) {
    Term argument = primary();
    const Place place = function->place;
    function = checked(apply(std::move(function), std::move(argument), place));
  }
  while (postfix(function) || image(function)) {
  }
  return function;
}

bool TermParser::image(Term& so_far) {
  if (!in_.sees("⦇") || in_.peek().own) return false;
  so_far = enclosing("_⦇_⦈", std::move(so_far));
  return true;
}

bool TermParser::postfix(Term& so_far) {
  const Token& token = in_.peek();
  const Operator* const op = token.type == Token::Type::symbol ? token.symbol->postfix : nullptr;
  if (token.own || (!op && !token.is("↗"))) return false;
  if (!op) {
    so_far = enclosing("_↗_↙", std::move(so_far));
    return true;
  }
  in_.next();
  const Place place = so_far->place;
  so_far = checked(operation(op->name(), {std::move(so_far)}, place));
  return true;
}

/// Takes the rest of R ⦇ S ⦈ or R ↗ n ↙, whose name ends in the closing sign.
Term TermParser::enclosing(std::string_view name, Term left) {
  in_.next();
  Term inside = term();
  in_.expect(name.substr(name.rfind('_') + 1));
  const Place place = left->place;
  return checked(operation(std::string(name), {std::move(left), std::move(inside)}, place));
}

Term TermParser::primary() {
  Term term = plain_primary();
  while (suffix(term)) {
  }
  return term;
}

bool TermParser::suffix(Term& so_far) {
  const Place place = so_far->place;
  if (in_.sees(".")) {
    in_.next();
    Node node{.kind = Kind::selection, .place = place, .name = {}, .children = {so_far}, .names = {}, .text = {}};
    if (in_.sees(Token::Type::numeral)) {
      node.kind = Kind::tuple_selection;
      node.name.word = in_.next().text;
    } else {
      node.name = in_.name();
    }
    so_far = checked(make(std::move(node)));
  } else if (in_.sees(Token::Type::stroke)) {
    Node tree{.kind = Kind::decoration, .place = place, .name = {}, .children = {so_far}, .names = {}, .text = {}};
    tree.name.strokes = in_.next().text;
    so_far = checked(make(std::move(tree)));
  } else if (in_.sees("[") && !holds_schema_text()) {
    so_far = actuals_or_renaming(so_far);
  } else if (in_.is_spivey() && is_own_postfix(in_.peek())) {
    so_far = own_operation({so_far});
  } else {
    return in_.is_spivey() && postfix(so_far);
  }
  return true;
}

/// Between these brackets stand declarations, so that they are an argument: f [x : A], and f [S; T] (ISO/IEC
/// 13568, 8.4). The declarations of a quantifier, up to its •, are its own: f[let a == 0; b == 0 • a] has an actual.
bool TermParser::holds_schema_text() const {
  std::size_t ahead = 1;
  while (TokenStream::is_name(in_.peek(ahead)) && in_.peek(ahead + 1).is(",")) ahead += 2;
  if (TokenStream::is_name(in_.peek(ahead)) && in_.peek(ahead + 1).is(":")) return true;
  const auto is_quantifier = [](const Token& token) {
    return std::any_of(std::begin(quantifiers), std::end(quantifiers),
                       [&](const Quantifier& quantifier) { return token.is(quantifier.symbol); });
  };
  int depth = 1, quantified = 0;
  for (ahead = 1; depth > 0; ++ahead) {
    const Token& token = in_.peek(ahead);
    if (token.type == Token::Type::end || token.type == Token::Type::error) return false;
    if (depth == 1 && is_quantifier(token)) ++quantified;
    if (depth == 1 && quantified > 0 && token.is("•")) --quantified;
    if (depth == 1 && quantified == 0 && token.is(";")) return true;
    if (token.is("[") || token.is("(") || token.is("{") || token.is("⦉")) ++depth;
    if (token.is("]") || token.is(")") || token.is("}") || token.is("⦊")) --depth;
  }
  return false;
}

Term TermParser::actuals_or_renaming(Term of) {
  const Place place = of->place;
  in_.next();
  if (in_.sees_name() && in_.peek(1).is("/")) {
    Node node{.kind = Kind::renaming, .place = place, .name = {}, .children = {of}, .names = {}, .text = {}};
    do {
      node.names.push_back(in_.name());
      in_.expect("/");
      node.names.push_back(in_.name());
    } while (in_.accept(","));
    in_.expect("]");
    return checked(make(std::move(node)));
  }
  std::vector<Term> actuals = terms("]");
  if (of->kind != Kind::reference || !of->children.empty())
    throw ZError(place, "only a name takes generic actuals", "expected a name before [");
  return checked(reference(of->name, std::move(actuals), place));
}

std::vector<Term> TermParser::terms(std::string_view closing) {
  std::vector<Term> terms;
  do {
    terms.push_back(term());
  } while (in_.accept(","));
  in_.expect(closing);
  return terms;
}

Term TermParser::plain_primary() {
  const Token& token = in_.peek();
  if (token.type == Token::Type::numeral) return numeral();
  if (TokenStream::is_name(token)) return reference(in_.name(), {}, token.place);
  if (token.is("true") || token.is("false"))
    return node(in_.next().is("true") ? Kind::truth : Kind::falsity, {}, token.place);
  if (token.is("θ")) return theta();
  if (token.is("(")) return parenthesis();
  if (token.is("{")) return braces();
  if (token.is("[")) return brackets();
  if (begins_enclosing(token)) return own_operation({});
  if (token.is("⟨")) return sequence();
  if (token.is("⦉")) return binding_extension();
  in_.fail("expected an expression or a predicate");
}

/// Reads a natural number; 0.25 is read as 25 / 100.
Term TermParser::numeral() {
  const Token& token = in_.next();
  std::string digits = token.text;
  const std::size_t point = digits.find('.');
  if (point == digits.npos) return number(std::move(digits), token.place);
  std::string power = "1" + std::string(digits.size() - point - 1, '0');
  digits.erase(point, 1);
  digits.erase(0, std::min(digits.find_first_not_of('0'), digits.size() - 1));
  return checked(
      operation("_/_", {number(std::move(digits), token.place), number(std::move(power), token.place)}, token.place));
}

Term TermParser::theta() {
  const Place place = in_.next().place;
  Node node{.kind = Kind::theta, .place = place, .name = {}, .children = {}, .names = {}, .text = {}};
  if (in_.sees_name()) {
    const Token& token = in_.next();
    const Term schema = reference({token.text, token.strokes}, {}, token.place);
    node.children.push_back(in_.sees("[") ? actuals_or_renaming(schema) : schema);
  } else if (in_.sees("(")) {
    node.children.push_back(parenthesis());
  } else if (in_.sees("[")) {
    node.children.push_back(brackets());
  } else {
    in_.fail("expected a schema after θ");
  }
  while (in_.sees(Token::Type::stroke))
    node.name.strokes += in_.next().text;  // they are those of θ: x is taken from x'
  return checked(make(std::move(node)));
}

Term TermParser::parenthesis() {
  const Place place = in_.next().place;
  std::vector<Name> operands;
  if (const auto own = operator_ahead(0, nullptr) > 0 ? operator_name(operands) : std::nullopt) {
    in_.expect(")");
    return reference(*own, {}, place);
  }
  const bool prefix = is_prefix_word(in_.peek().text) || find_operator(in_.peek().text, Fixity::prefix);
  if (in_.sees("_") || (in_.peek(1).is("_") && prefix)) return word_or_operator();
  const bool mu = in_.sees("μ");
  std::vector<Term> parts = {mu ? quantifier(Kind::mu, false) : term()};
  while (in_.accept(Token::Type::newline) || in_.accept(";"))  // a new line is ∧ (ISO/IEC 13568, 8.3)
    parts[0] = checked(node(Kind::conjunction, {parts[0], term()}, parts[0]->place));
  const bool alone = mu && parts[0]->children.empty();
  while (!alone && in_.accept(",")) parts.push_back(term());
  in_.expect(")");
  if (parts.size() == 1) return parts[0];
  return checked(node(Kind::tuple, std::move(parts), place));
}

/// Reads an operator as a name: (_ ∪ _), (# _), (_ ∼), (_ ⦇ _ ⦈), (_ ↗ _ ↙).
Term TermParser::word_or_operator() {
  std::string name;
  const Place place = in_.peek().place;
  while (!in_.sees(")")) {
    if (!in_.sees(Token::Type::symbol) && !in_.sees(Token::Type::word)) in_.fail("expected )");
    name += in_.next().text;
  }
  in_.next();
  if (name.ends_with('_') && is_prefix_word(name.substr(0, name.size() - 1))) name.pop_back();
  if (!is_prefix_word(name) && !is_operator_name(name))
    throw ZError(place, "unknown operator " + name,
                 "expected an operator of the standard toolkit, or of a template above");
  return reference({name, {}}, {}, place);
}

Term TermParser::braces() {
  const Place place = in_.next().place;
  if (in_.accept("}")) return node(Kind::set_extension, {}, place);
  if (!in_.sees("|") && !in_.sees("•") && !begins_declaration()) {
    std::vector<Term> elements = {term()};
    if (in_.sees(",") || in_.sees("}")) {
      while (in_.accept(",")) elements.push_back(term());
      in_.expect("}");
      return checked(node(Kind::set_extension, std::move(elements), place));
    }
    SchemaText text;  // it was the inclusion of a schema
    const Place first = elements[0]->place;
    text.declarations.push_back({Declaration::Form::included, {}, {}, elements[0], first});
    while (in_.accept(";") || in_.accept(Token::Type::newline)) text.declarations.push_back(declaration());
    if (in_.accept("|")) text.predicates = predicates(false);
    std::vector<Term> value;
    if (in_.accept("•")) value.push_back(term());
    in_.expect("}");
    return checked(quantified(Kind::comprehension, std::move(text), std::move(value), place));
  }
  SchemaText text = schema_text();
  std::vector<Term> value;
  if (in_.accept("•")) value.push_back(term());
  in_.expect("}");
  return checked(quantified(Kind::comprehension, std::move(text), std::move(value), place));
}

Term TermParser::brackets() {
  const Place place = in_.next().place;
  SchemaText text;
  if (!in_.sees("]")) text = schema_text();
  in_.expect("]");
  return checked(quantified(Kind::schema_text, std::move(text), {}, place));
}

/// ⟨a, b⟩ is the function ⟨,,⟩ of {(1, a), (2, b)} (ISO/IEC 13568, 12.2).
Term TermParser::sequence() {
  const Place place = in_.next().place;
  return sequence_of(in_.accept("⟩") ? std::vector<Term>() : terms("⟩"), place);
}

Term TermParser::sequence_of(std::vector<Term> elements, Place place) const {
  std::size_t position = 0;
  for (Term& term : elements)
    term = node(Kind::tuple, {number(std::to_string(++position), term->place), term}, term->place);
  return checked(operation("⟨,,⟩", {node(Kind::set_extension, std::move(elements), place)}, place));
}

Term TermParser::binding_extension() {
  const Place place = in_.next().place;
  Node node{.kind = Kind::binding_extension, .place = place, .name = {}, .children = {}, .names = {}, .text = {}};
  while (!in_.sees("⦊")) {
    if (!node.names.empty()) in_.expect(",");
    node.names.push_back(in_.name());
    in_.expect("==");
    node.children.push_back(term());
  }
  in_.next();
  return checked(make(std::move(node)));
}

}  // namespace durero::zed
