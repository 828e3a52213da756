/// Prints what operators make: applications, references and relations.

#include "zed/print/printer.hpp"
#include "zed/print/strength.hpp"
#include "zed/syntax/connectives.hpp"

namespace durero::zed {

void Printer::infix(const Node& node, std::string_view sign, int left, int right, bool last) {
  term(node.children[0], left, false);
  symbol(sign);
  term(node.children[1], right, last);
}

/// In LaTeX ↗ would be the index of a name before it, were it not for the ~ around.
void Printer::enclosing(std::string_view sign) {
  const bool raised = latex_ && (sign == "↗" || sign == "↙");
  if (raised) out_ += '~';
  symbol(sign);
  if (raised && sign == "↗") out_ += '~';
}

void Printer::application(const Node& node, bool last) {
  if (const Node* pairs = sequence_of(node)) {
    symbol("⟨");
    for (std::size_t i = 0; i < pairs->children.size(); ++i) {
      if (i > 0) out_ += ',';
      term(pairs->children[i]->children[1], binding::weakest);
    }
    return latex_ ? symbol("⟩") : tight("⟩");
  }
  const Operator* op = operator_of(node);
  if (op && op->fixity == Fixity::infix) {
    const int mine = operator_strength(*op);
    return infix(*node.children[1], op->symbol, op->right ? mine + 1 : mine, op->right ? mine : mine + 1, last);
  }
  if (op && op->fixity == Fixity::prefix) {
    if (latex_ && op->symbol == "-") {
      space();
      out_ += "\\negate";
    } else {
      symbol(op->symbol);
    }
    return term(node.children[1], binding::prefix, last);
  }
  if (op) {
    term(node.children[1], binding::postfix, false);
    return symbol(op->symbol);
  }
  if (const auto [open, close] = enclosing_signs(node); !open.empty()) {
    term(node.children[1]->children[0], binding::postfix, false);
    enclosing(open);
    term(node.children[1]->children[1], binding::weakest);
    return enclosing(close);
  }
  term(node.children[0], binding::application, false);
  const std::size_t behind = out_.size();
  term(node.children[1], binding::primary, false);
  // A blank is no space in LaTeX: f a would be one name.
  if (latex_ && out_[behind] == ' ' && out_[behind + 1] != '(') out_[behind] = '~';
}

void Printer::reference(const Node& node, bool last) {
  if (const Operator* op = operator_of(node)) {
    const int mine = operator_strength(*op);
    if (op->fixity == Fixity::infix)
      return infix(node, op->symbol, op->right ? mine + 1 : mine, op->right ? mine : mine + 1, last);
    symbol(op->symbol);
    return term(node.children[0], mine, last);
  }
  name(node.name);
  if (node.children.empty()) return;
  out_ += '[';
  for (std::size_t i = 0; i < node.children.size(); ++i) {
    if (i > 0) out_ += ',';
    term(node.children[i], binding::weakest);
  }
  out_ += ']';
}

void Printer::relation(const Node& node, bool last) {
  const auto sign = [&node](std::size_t i) {
    const Operator* op = operator_of_name(node.names[i].word);
    return op ? op->symbol : std::string_view(node.names[i].word);
  };
  if (node.children.size() == 1) symbol(sign(0));
  for (std::size_t i = 0; i < node.children.size(); ++i) {
    if (i > 0) symbol(sign(i - 1));
    term(node.children[i], binding::relation + 1, last && i + 1 == node.children.size());
  }
}

}  // namespace durero::zed
