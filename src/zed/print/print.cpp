#include "durero/zed/print/print.hpp"

#include <functional>

#include "durero/zed/syntax/operators.hpp"
#include "zed/print/printer.hpp"

namespace durero::zed {
namespace {

std::string labelled(const std::string& label) { return label.empty() ? "" : "  % " + label; }

/// Prints a line of a box. Parentheses keep a line that begins with the sign from being read as going on from the line
/// before.
std::string line(const Markup* markup, const std::function<void(Printer&)>& print) {
  Printer printer(markup);
  print(printer);
  const std::string text = printer.take();
  return text.starts_with(markup ? "\\negate" : "-") ? "(" + text + ")" : text;
}

std::string header(const Name& name, const std::vector<Name>& formals, const Markup* markup) {
  Printer printer(markup);
  if (!name.empty() && markup) printer.raw("{");
  if (!name.empty()) printer.name(name);
  if (!name.empty() && markup) printer.raw("}");
  if (!formals.empty()) {
    printer.raw("[");
    printer.names(formals);
    printer.raw("]");
  }
  return printer.take();
}

/// A frame says how the lines of a box are joined.
struct BoxLayout {
  std::string open, decl_end, where, pred_end, close, margin;
};

std::string box(const SchemaText& text, const Markup* markup, const BoxLayout& frame) {
  std::string lines = frame.open;
  const std::size_t declarations = text.declarations.size(), predicates = text.predicates.size();
  for (std::size_t i = 0; i < declarations; ++i) {
    lines += frame.margin + line(markup, [&](Printer& to) { to.declaration(text.declarations[i]); });
    lines += i + 1 < declarations ? frame.decl_end : "\n";
  }
  for (std::size_t i = 0; i < predicates; ++i) {
    lines += i == 0 ? frame.where : frame.pred_end;
    lines += frame.margin + line(markup, [&](Printer& to) { to.term(text.predicates[i].term, 0); });
    lines += labelled(text.predicates[i].label) + "\n";
  }
  return lines + frame.close;
}

class ParagraphPrinter {
 public:
  explicit ParagraphPrinter(const Markup* markup) : markup_(markup) {}

  std::string operator()(const GivenTypes& given) const {
    Printer printer(markup_);
    printer.raw("[");
    printer.names(given.names);
    printer.raw("]");
    return zed(printer.take());
  }
  std::string operator()(const FreeType& type) const {
    Printer printer(markup_);
    printer.name(type.name);
    std::string_view between = "::=";
    for (const Branch& branch : type.branches) {
      printer.symbol(between);
      between = "|";
      printer.name(branch.name);
      if (!branch.argument) continue;
      printer.symbol("⟪");
      printer.term(branch.argument, 0);
      printer.symbol("⟫");
    }
    return zed(printer.take());
  }
  /// Says whether formals can stand for the operands of an operator: as many, or none.
  static bool has_operands(std::string_view op, std::size_t formals) {
    std::size_t operands = 0;
    for (const char c : op) operands += c == '_' ? 1 : 0;
    return formals == 0 || formals == operands;
  }
  std::string operator()(const Definition& definition) const {
    Printer printer(markup_);
    if (is_template_name(definition.name.word) && has_operands(definition.name.word, definition.formals.size())) {
      printer.declared(definition.name, definition.formals);
    } else {
      printer.declared(definition.name);
      printer.raw(header({}, definition.formals, markup_));
    }
    printer.symbol("==");
    printer.term(definition.value, 0);
    return zed(printer.take() + labelled(definition.label));
  }
  std::string operator()(const Axiomatic& box) const {
    return boxed(box.formals.empty() ? "axdef" : "gendef", {}, box.formals, box.text);
  }
  std::string operator()(const Schema& schema) const {
    return boxed("schema", schema.name, schema.formals, schema.text);
  }
  std::string operator()(const Conjecture& conjecture) const {
    Printer printer(markup_);
    printer.raw(header({}, conjecture.formals, markup_));
    printer.symbol("⊢?");
    printer.term(conjecture.claim.term, 0);
    return zed(printer.take() + labelled(conjecture.claim.label));
  }

 private:
  std::string zed(const std::string& text) const {
    return markup_ ? "\\begin{zed}\n  " + text + "\n\\end{zed}\n" : text + "\n";
  }
  std::string boxed(const std::string& environment, const Name& name, const std::vector<Name>& formals,
                    const SchemaText& text) const {
    const std::string title = header(name, formals, markup_);
    if (markup_)
      return box(text, markup_,
                 {"\\begin{" + environment + "}" + title + "\n", " \\\\\n", "\\where\n", "\\also\n",
                  "\\end{" + environment + "}\n", "  "});
    return box(text, markup_, {"┌─ " + title + "\n", "\n", "├─\n", "", "└─\n", "│ "});
  }

  const Markup* markup_;
};

}  // namespace

std::string to_unicode(const Term& term) {
  Printer printer(nullptr);
  printer.term(term, 0);
  return printer.take();
}

std::string to_latex(const Term& term, const Markup& markup) {
  Printer printer(&markup);
  printer.term(term, 0);
  return printer.take();
}

std::string to_unicode(const Paragraph& paragraph) { return std::visit(ParagraphPrinter(nullptr), paragraph.form); }

std::string to_latex(const Paragraph& paragraph, const Markup& markup) {
  return std::visit(ParagraphPrinter(&markup), paragraph.form);
}

}  // namespace durero::zed
