#include "zed/print/printer.hpp"

#include "zed/print/strength.hpp"
#include "zed/syntax/connectives.hpp"
#include "zed/syntax/symbols.hpp"

namespace durero::zed {

Printer::Printer(const Markup* markup) : latex_(markup != nullptr) {
  if (!markup) return;
  for (const auto& [command, meaning] : *markup) own_.emplace(meaning, "\\" + command);
}

void Printer::term(const Term& term, int least, bool last) {
  const Node& node = *term;
  bool parentheses = strength(node) < least;
  if (const Quantifier* sign = quantifier_of(node.kind)) {
    parentheses = !last || least > (sign->logical ? binding::negation : binding::weakest);
  }
  if (node.kind == Kind::mu && node.children.empty()) parentheses = true;
  if (!parentheses) return bare(node, last);
  space();
  out_ += '(';
  bare(node, true);
  out_ += ')';
}

void Printer::bare(const Node& node, bool last) {
  if (const Quantifier* sign = quantifier_of(node.kind)) return quantified(node, sign->symbol, last);
  if (const Connective* sign = connective_of(node.kind)) {
    if (!sign->prefix) return infix(node, sign->symbol, sign->left_strength(), sign->right_strength(), last);
    symbol(sign->symbol);
    return term(node.children[0], sign->right_strength(), last);
  }
  switch (node.kind) {
    case Kind::reference:
      return reference(node, last);
    case Kind::number:
      return symbol(node.name.word);
    case Kind::set_extension:
      return list("{", node.children, "}");
    case Kind::comprehension:
      return braces(node);
    case Kind::tuple:
      return list("(", node.children, ")");
    case Kind::product:
      for (std::size_t i = 0; i < node.children.size(); ++i) {
        if (i > 0) symbol("×");
        term(node.children[i], binding::infix + product_precedence + 1, last && i + 1 == node.children.size());
      }
      return;
    case Kind::theta:
      return theta(node);
    case Kind::application:
      return application(node, last);
    case Kind::conditional:
      return conditional(node, last);
    case Kind::schema_text:
      symbol("[");
      schema_text(*node.text);
      return tight("]");
    case Kind::truth:
      return symbol("true");
    case Kind::falsity:
      return symbol("false");
    case Kind::relation:
      return relation(node, last);
    case Kind::binding_extension:
      symbol("⦉");
      for (std::size_t i = 0; i < node.children.size(); ++i) {
        if (i > 0) out_ += ',';
        name(node.names[i]);
        symbol("==");
        term(node.children[i], binding::weakest);
      }
      return symbol("⦊");
    default:
      return suffixed(node);
  }
}

void Printer::list(std::string_view open, const std::vector<Term>& terms, std::string_view close) {
  symbol(open);
  for (std::size_t i = 0; i < terms.size(); ++i) {
    if (i > 0) out_ += ',';
    term(terms[i], binding::weakest);
  }
  tight(close);
}

void Printer::quantified(const Node& node, std::string_view sign, bool last) {
  symbol(sign);
  schema_text(*node.text);
  if (node.children.empty()) return;
  symbol("•");
  const bool is_value = node.kind == Kind::lambda || node.kind == Kind::mu;
  const bool parentheses = is_value && shows_relation(*node.children[0]);
  if (parentheses) symbol("(");
  term(node.children[0], binding::weakest, last || parentheses);
  if (parentheses) tight(")");
}

void Printer::conditional(const Node& node, bool last) {
  symbol("if");
  term(node.children[0], binding::weakest);
  symbol("then");
  term(node.children[1], binding::weakest);
  symbol("else");
  term(node.children[2], binding::conditional, last);
}

void Printer::theta(const Node& node) {
  symbol("θ");
  const Node& schema = *node.children[0];
  if (schema.kind == Kind::reference && !is_operator_name(schema.name.word)) {
    bare(schema, false);
  } else {
    space();
    out_ += '(';
    bare(schema, true);
    out_ += ')';
  }
  if (!node.name.strokes.empty()) decoration(node.name.strokes);
}

/// The strokes of a schema have a space before them, without which they would be part of its name.
void Printer::decoration(const std::string& strokes) {
  out_ += latex_ ? '~' : ' ';
  name({"", strokes});
}

/// Prints what stands behind a primary: selections, decoration, renaming, hiding.
void Printer::suffixed(const Node& node) {
  const Term& of = node.children[0];
  if (node.kind == Kind::hiding) {
    term(of, binding::hiding, false);
    symbol("⧹");
    symbol("(");
    names(node.names);
    return tight(")");
  }
  const bool selects = node.kind == Kind::selection || node.kind == Kind::tuple_selection;
  // A stroke or bracket would belong to θ; a point behind a number, before another, would make it decimal.
  const bool would_take =
      (of->kind == Kind::theta && !selects) || (of->kind == Kind::number && node.kind == Kind::tuple_selection);
  term(of, would_take ? binding::primary + 1 : binding::primary, false);
  if (node.kind == Kind::decoration) return decoration(node.name.strokes);
  if (node.kind == Kind::renaming) {
    out_ += '[';
    for (std::size_t i = 0; i + 1 < node.names.size(); i += 2) {
      if (i > 0) out_ += ',';
      name(node.names[i]);
      symbol("/");
      name(node.names[i + 1]);
    }
    out_ += ']';
    return;
  }
  out_ += '.';
  const std::string before = std::move(out_);
  out_.clear();
  name(node.name);
  out_ = before + out_;
}

void Printer::braces(const Node& node) {
  symbol("{");
  out_ += ' ';
  schema_text(*node.text);
  if (!node.children.empty()) {
    symbol("•");
    term(node.children[0], binding::weakest);
  }
  symbol("}");
}

void Printer::declaration(const Declaration& declaration) {
  if (declaration.form != Declaration::Form::included) {
    names(declaration.names);
    symbol(declaration.form == Declaration::Form::defined ? "==" : ":");
  }
  term(declaration.term, binding::weakest);
}

void Printer::schema_text(const SchemaText& text) {
  for (std::size_t i = 0; i < text.declarations.size(); ++i) {
    if (i > 0) out_ += ';';
    declaration(text.declarations[i]);
  }
  for (std::size_t i = 0; i < text.predicates.size(); ++i) {
    if (i == 0) {
      symbol("|");
    } else {
      out_ += ';';
    }
    term(text.predicates[i].term, binding::weakest);
  }
}

}  // namespace durero::zed
