#include "zed/names/term_at.hpp"

#include <algorithm>
#include <utility>

#include "zed/syntax/connectives.hpp"
#include "zed/syntax/symbols.hpp"

namespace durero::zed {
namespace {

std::pair<std::uint32_t, std::uint32_t> in_order(Place place) { return {place.line, place.column}; }

bool stands_between(Place place, const Term& left, const Term& right) {
  return in_order(left->place) <= in_order(place) && in_order(place) < in_order(right->place);
}

/// The operator of a node that stands between two operands, or before one, with these operands; null for another node.
const Operator* operator_with(const Node& node, std::vector<Term>& operands) {
  const Operator* op = nullptr;
  if (node.kind == Kind::reference) {
    op = operator_of_name(node.name.word);
    operands = node.children;
  } else if (node.kind == Kind::application && node.children[0]->kind == Kind::reference) {
    op = operator_of_name(node.children[0]->name.word);
    operands = {node.children[1]};
    if (op && op->fixity == Fixity::infix && node.children[1]->kind == Kind::tuple)
      operands = node.children[1]->children;
  }
  return op;
}

bool is_made_by_operator(const Token& token, const Node& node) {
  std::vector<Term> operands;
  const Operator* op = operator_with(node, operands);
  if (!op || !token.is(op->symbol)) return false;
  if (op->fixity == Fixity::infix) return operands.size() == 2 && stands_between(token.place, operands[0], operands[1]);
  return op->fixity == Fixity::prefix && operands.size() == 1 && node.place == token.place;
}

bool is_made_by_relation(const Token& token, const Node& node) {
  for (std::size_t i = 0; i < node.names.size(); ++i) {
    const Operator* op = operator_of_name(node.names[i].word);
    if (!op || !token.is(op->symbol)) continue;
    if (node.children.size() == 1) return node.place == token.place;
    if (stands_between(token.place, node.children[i], node.children[i + 1])) return true;
  }
  return false;
}

/// The sign that a term of a kind begins with; empty where it begins with an operand.
std::string_view first_sign(const Node& node) {
  if (const Quantifier* quantifier = quantifier_of(node.kind)) return quantifier->symbol;
  if (const Connective* connective = connective_of(node.kind)) return connective->prefix ? connective->symbol : "";
  if (node.kind == Kind::conditional) return "if";
  if (node.kind == Kind::theta) return "θ";
  if (node.kind == Kind::tuple) return "(";
  if (node.kind == Kind::set_extension || node.kind == Kind::comprehension) return "{";
  if (node.kind == Kind::binding_extension) return "⦉";
  if (node.kind == Kind::schema_text) return "[";
  if (node.kind == Kind::truth) return "true";
  if (node.kind == Kind::falsity) return "false";
  const bool sequence = node.kind == Kind::application && node.children[0]->name.word == "⟨,,⟩";
  return sequence ? "⟨" : "";
}

}  // namespace

bool is_made_by(const Token& token, const Node& node) {
  if (token.own) return false;
  if (node.kind == Kind::number) return token.type == Token::Type::numeral && node.place == token.place;
  if (node.kind == Kind::reference && node.name == Name{token.text, token.strokes} && node.place == token.place)
    return true;
  if (node.kind == Kind::relation) return is_made_by_relation(token, node);
  if (const std::string_view sign = first_sign(node); !sign.empty()) return token.is(sign) && node.place == token.place;
  if (const Connective* connective = connective_of(node.kind))
    return token.is(connective->symbol) && stands_between(token.place, node.children[0], node.children[1]);
  if (node.kind == Kind::product)
    return token.is("×") && stands_between(token.place, node.children.front(), node.children.back());
  return is_made_by_operator(token, node);
}

namespace {

/// Looks for names that a term mentions free and some scope has.
class FreeMention {
 public:
  FreeMention(const Typing& typing, const std::vector<NameScope>& scopes) : typing_(typing) {
    for (const NameScope& scope : scopes)
      for (const ScopedName& each : scope) local_.insert(each.name);
  }

  bool in(const Term& term) {
    if (term->kind == Kind::reference && is_local(term->name)) return true;
    const Word strokes = term->kind == Kind::theta ? term->name.strokes : Word();
    const Term& schema = term->kind == Kind::theta ? term->children[0] : term;
    for (const Name& field : fields_of(schema))
      if (is_local({field.word, field.strokes + strokes})) return true;
    if (!term->text) return std::ranges::any_of(term->children, [this](const Term& child) { return in(child); });
    return in(*term->text, term->children);
  }

 private:
  bool is_local(const Name& name) const { return local_.contains(name) && !bound_.contains(name); }
  std::vector<Name> fields_of(const Term& schema) const {
    const auto type = typing_.type_of(schema);
    return type && type->is_schema_set() ? type->parts()[0].fields() : std::vector<Name>();
  }
  bool in(const SchemaText& text, const std::vector<Term>& children) {
    std::vector<Name> binds;
    for (const Declaration& declaration : text.declarations) {
      const bool included = declaration.form == Declaration::Form::included;
      if (included ? in_included(declaration.term) : in(declaration.term)) return true;
      const std::vector<Name> names = included ? fields_of(declaration.term) : declaration.names;
      binds.insert(binds.end(), names.begin(), names.end());
    }
    for (const Name& name : binds) bound_.insert(name);
    const bool found = std::ranges::any_of(text.predicates, [this](const Predicate& each) { return in(each.term); }) ||
                       std::ranges::any_of(children, [this](const Term& child) { return in(child); });
    for (const Name& name : binds) bound_.erase(bound_.find(name));
    return found;
  }
  /// An included schema mentions its name alone; one that is an expression, all that is in it.
  bool in_included(const Term& schema) { return schema->kind == Kind::reference ? is_local(schema->name) : in(schema); }

  const Typing& typing_;
  std::set<Name> local_;
  std::multiset<Name> bound_;
};

}  // namespace

bool is_closed(const Term& term, const Typing& typing, const std::vector<NameScope>& scopes) {
  return !FreeMention(typing, scopes).in(term);
}

}  // namespace durero::zed
