#include "zed/print/spivey_grammar.hpp"

#include <algorithm>
#include <array>

#include "durero/zed/syntax/defect.hpp"
#include "zed/syntax/bag_toolkit.hpp"
#include "zed/syntax/symbols.hpp"

namespace durero::zed {
namespace {

/// The names that ISO's toolkit has, or this program's, and Spivey's has not.
constexpr std::array<std::string_view, 5> beyond = {"_⊖_", "𝔸", "ℤ₁", "_/_", "√_"};

[[noreturn]] void refuse_in_spivey(const std::string& what, Place place, const std::string& expected) {
  throw ZError(place, what + " cannot be written in Spivey's Z", "expected " + expected);
}

/// A name without the Δ or Ξ that stands before a schema's.
std::string_view without_greek(std::string_view word) {
  for (const std::string_view letter : {"Δ", "Ξ"})
    if (word.starts_with(letter)) return word.substr(letter.size());
  return word;
}

bool is_schema_name(const Name& name, const SchemaNames& known) {
  return name.strokes.empty() && known.contains(without_greek(name.word));
}

/// Walks over a paragraph with what may stand where.
class SpiveyGrammar {
 public:
  SpiveyGrammar(const SchemaNames& known, Place place) : known_(known), place_(place) {}

  void operator()(const GivenTypes& given) const {
    for (std::size_t i = 0; i < given.names.size(); ++i) declares(given.names[i], given.places[i]);
  }
  void operator()(const FreeType& type) const {
    declares(type.name, place_);
    for (const Branch& branch : type.branches) {
      declares(branch.name, branch.place);
      if (type.joined) refuse_in_spivey("& between free types", type.branches.front().place, "them one after another");
      if (branch.argument) expression(branch.argument);
    }
  }
  void operator()(const Definition& definition) const {
    declares(definition.name, place_);
    if (is_operator_name(definition.name.word) && definition.formals.empty())
      refuse_in_spivey("a definition of an operator by _", definition.value->place, "an axdef, or names as operands");
    defines_schema(definition, known_) ? logic(definition.value) : expression(definition.value);
  }
  void operator()(const Axiomatic& box) const {
    const bool is_constraint = box.formals.empty() && box.text.predicates.size() == 1;
    if (box.text.declarations.empty() && !is_constraint)
      refuse_in_spivey("a box without a declaration", place_, "one or more, or one predicate without formals");
    for (const Declaration& each : box.text.declarations)
      for (std::size_t i = 0; i < each.names.size(); ++i) declares(each.names[i], each.places[i]);
    body(box.text);
  }
  void operator()(const Schema& box) const {
    declares(box.name, place_);
    schema_text(box.text, place_);
  }
  void operator()(const Conjecture& conjecture) const { logic(conjecture.claim.term); }

 private:
  /// Spivey's Z declares bags itself. Another name in the place of theirs would be no command of LaTeX, and would leave
  /// the prose behind.
  void declares(const Name& name, Place at) const {
    if (name.strokes.empty() && std::ranges::find(bag_names, name.word.text()) != bag_names.end())
      refuse_in_spivey(name.text() + ", which Spivey's toolkit declares for bags,", at, "another name");
  }

  void body(const SchemaText& text) const {
    for (const Declaration& each : text.declarations) declaration(each);
    for (const Predicate& each : text.predicates) logic(each.term);
  }

  void schema_text(const SchemaText& text, Place at) const {
    if (text.declarations.empty()) refuse_in_spivey("a schema text without a declaration", at, "one or more");
    body(text);
  }

  void declaration(const Declaration& each) const {
    switch (each.form) {
      case Declaration::Form::typed:
        for (std::size_t i = 0; i < each.names.size(); ++i)
          if (known_.contains(each.names[i].text()))
            refuse_in_spivey("the name " + each.names[i].text() + " of a schema for another", each.places[i],
                             "a name of its own");
        return expression(each.term);
      case Declaration::Form::defined:
        refuse_in_spivey("a declaration by ==", each.place, "NAME : SET, and an equation");
      case Declaration::Form::included:
        return schema_reference(each.term);
    }
  }

  void definitions(const SchemaText& text) const {
    for (const Declaration& each : text.declarations) expression(each.term);
  }

  void each_expression(const std::vector<Term>& terms) const {
    for (const Term& each : terms) expression(each);
  }

  void name(const Name& used, Place at) const {
    if (std::ranges::find(beyond, used.word.text()) != beyond.end())
      refuse_in_spivey(used.text(), at, "what Spivey's toolkit has");
  }

  /// A schema reference is a name with strokes, then generic actuals, then a renaming.
  void schema_reference(const Term& term) const {
    const Node* node = term.get();
    if (node->kind == Kind::renaming) node = node->children.front().get();
    if (node->kind == Kind::decoration) {
      node = node->children.front().get();
      if (!node->children.empty() || !is_schema_name(node->name, known_) ||
          node->name.word != without_greek(node->name.word))
        refuse_in_spivey("a decoration of more than a schema's name", node->place, "the name of a schema");
    }
    if (node->kind != Kind::reference)
      refuse_in_spivey("this schema", node->place, "a schema's name, defined by \\defs");
    name(node->name, node->place);
    each_expression(node->children);
  }

  /// Predicates and schema expressions have one grammar.
  void logic(const Term& term) const {
    switch (term->kind) {
      case Kind::forall:
      case Kind::exists:
      case Kind::exists_one:
        schema_text(*term->text, term->place);
        return logic(term->children.front());
      case Kind::let:
        definitions(*term->text);
        return logic(term->children.front());
      case Kind::schema_text:
        return schema_text(*term->text, term->place);
      case Kind::relation:
        for (const Name& each : term->names) name(each, term->place);
        return each_expression(term->children);
      case Kind::truth:
      case Kind::falsity:
        return;
      case Kind::hiding:
      case Kind::composition:
      case Kind::piping:
      case Kind::projection:
      case Kind::precondition:
      case Kind::negation:
      case Kind::conjunction:
      case Kind::disjunction:
      case Kind::implication:
      case Kind::equivalence:
        for (const Term& each : term->children) logic(each);
        return;
      case Kind::reference:
      case Kind::decoration:
      case Kind::renaming:
        return schema_reference(term);
      case Kind::number:
      case Kind::set_extension:
      case Kind::comprehension:
      case Kind::tuple:
      case Kind::product:
      case Kind::power:
      case Kind::selection:
      case Kind::tuple_selection:
      case Kind::binding_extension:
      case Kind::theta:
      case Kind::application:
      case Kind::lambda:
      case Kind::mu:
      case Kind::conditional:
        refuse_in_spivey("an expression in the place of a schema", term->place, "a schema's name, defined by \\defs");
    }
  }

  /// The functions whose signs stand before operands alone in Spivey's Z.
  static bool is_sign(const Term& term) {
    return term->kind == Kind::reference && (term->name.word == "#_" || term->name.word == "-_");
  }

  void expression(const Term& term) const {
    switch (term->kind) {
      case Kind::reference:
        if (is_sign(term))
          refuse_in_spivey("the function (" + term->name.word.substr(0, 1) + " _)", term->place,
                           "it before an operand");
        name(term->name, term->place);
        return each_expression(term->children);
      case Kind::number:
        return;
      case Kind::application:
        if (!is_sign(term->children[0]) || !term->children[0]->children.empty()) expression(term->children[0]);
        return expression(term->children[1]);
      case Kind::set_extension:
      case Kind::tuple:
      case Kind::product:
      case Kind::power:
      case Kind::selection:
        return each_expression(term->children);
      case Kind::comprehension:
      case Kind::lambda:
      case Kind::mu:
        schema_text(*term->text, term->place);
        return each_expression(term->children);
      case Kind::let:
        definitions(*term->text);
        return each_expression(term->children);
      case Kind::conditional:
        logic(term->children[0]);
        expression(term->children[1]);
        return expression(term->children[2]);
      case Kind::theta:
        if (term->children.front()->kind == Kind::reference && term->children.front()->children.empty()) return;
        refuse_in_spivey("θ of more than a schema's name", term->place, "the name of a schema");
      case Kind::decoration:
      case Kind::renaming:
        return schema_reference(term);
      case Kind::tuple_selection:
        refuse_in_spivey("." + term->name.word + " of a tuple", term->place, "first or second, or a function");
      case Kind::binding_extension:
        refuse_in_spivey("a binding ⦉ … ⦊", term->place, "(μ S | x = e • θS)");
      case Kind::schema_text:
      case Kind::hiding:
      case Kind::composition:
      case Kind::piping:
      case Kind::projection:
      case Kind::precondition:
      case Kind::negation:
      case Kind::conjunction:
      case Kind::disjunction:
      case Kind::implication:
      case Kind::equivalence:
      case Kind::forall:
      case Kind::exists:
      case Kind::exists_one:
      case Kind::truth:
      case Kind::falsity:
      case Kind::relation:
        refuse_in_spivey("a schema within an expression", term->place, "a schema's name, defined by \\defs");
    }
  }

  const SchemaNames& known_;
  Place place_;  // that of the paragraph
};

bool is_schema(const Term& term, const SchemaNames& known) {
  switch (term->kind) {
    case Kind::reference:
      return is_schema_name(term->name, known);
    case Kind::let:
      return is_schema(term->children.front(), known);
    case Kind::schema_text:
    case Kind::decoration:
    case Kind::renaming:
    case Kind::hiding:
    case Kind::composition:
    case Kind::piping:
    case Kind::projection:
    case Kind::precondition:
    case Kind::negation:
    case Kind::conjunction:
    case Kind::disjunction:
    case Kind::implication:
    case Kind::equivalence:
    case Kind::forall:
    case Kind::exists:
    case Kind::exists_one:
      return true;
    case Kind::number:
    case Kind::set_extension:
    case Kind::comprehension:
    case Kind::tuple:
    case Kind::product:
    case Kind::power:
    case Kind::selection:
    case Kind::tuple_selection:
    case Kind::binding_extension:
    case Kind::theta:
    case Kind::application:
    case Kind::lambda:
    case Kind::mu:
    case Kind::conditional:
    case Kind::truth:
    case Kind::falsity:
    case Kind::relation:
      return false;
  }
  return false;
}

}  // namespace

bool defines_schema(const Definition& definition, const SchemaNames& known) {
  return !is_operator_name(definition.name.word) && is_schema(definition.value, known);
}

void add_schema_name(const Paragraph& paragraph, SchemaNames& known) {
  if (const auto* const box = std::get_if<Schema>(&paragraph.form)) known.insert(box->name.text());
  const auto* const definition = std::get_if<Definition>(&paragraph.form);
  if (definition != nullptr && defines_schema(*definition, known)) known.insert(definition->name.text());
}

void require_spivey(const Paragraph& paragraph, const SchemaNames& known) {
  std::visit(SpiveyGrammar(known, paragraph.place), paragraph.form);
}

std::string spivey_directive_of(const OperatorTemplate& op, std::string_view word, Place place) {
  const auto written = [&](std::string_view kind) { return "%%" + std::string(kind) + " " + std::string(word); };
  const bool one_word = op.parts.size() == (op.has_left() ? 1U : 0U) + (op.has_right() ? 1U : 0U) + 1U;
  const bool infix = op.has_left() && op.has_right(), prefix = !op.has_left() && op.has_right();
  if (one_word && op.role == Role::relation && (infix || prefix)) return written(infix ? "inrel" : "prerel");
  // fuzz has one priority for all infix generics, which associate to the right, as the arrows do.
  const bool is_arrow = infix && op.right && op.precedence == 5;
  if (one_word && op.role == Role::generic && (is_arrow || prefix)) return written(infix ? "ingen" : "pregen");
  if (one_word && op.role == Role::function && op.has_left() && !op.has_right()) return written("postop");
  const bool has_priority = op.precedence >= 10 && op.precedence <= 60 && op.precedence % 10 == 0 && !op.right;
  if (one_word && op.role == Role::function && infix && has_priority)
    return written("inop") + " " + std::to_string(op.precedence / 10);
  refuse_in_spivey("this operator", place, "one word, and of an infix function a precedence 10, 20, … 60 leftassoc");
}

}  // namespace durero::zed
