#include "printer.hpp"

#include <algorithm>

#include "durero/zed/symbols.hpp"
#include "term_parser.hpp"
#include "utf8.hpp"

namespace durero::zed {
namespace {

/// The operator that an application or a reference is printed with, or null where it is printed as such.
const Operator* operator_of(const Node& node) {
  const bool application = node.kind == Kind::application;
  const Node& named = application ? *node.children[0] : node;
  if (named.kind != Kind::reference || !named.name.strokes.empty()) return nullptr;
  const Operator* op = operator_of_name(named.name.word);
  if (!op || (op->role == Role::generic) == application || op->role == Role::relation) return nullptr;
  if (application && !named.children.empty()) return nullptr;
  const std::size_t operands = op->fixity == Fixity::infix ? 2 : 1;
  if (!application) return node.children.size() == operands ? op : nullptr;
  if (operands == 1) return op;
  const Node& argument = *node.children[1];
  return argument.kind == Kind::tuple && argument.children.size() == 2 ? op : nullptr;
}

bool is_image(const Node& node) {
  return node.kind == Kind::application && node.children[0]->kind == Kind::reference &&
         node.children[0]->name == Name{"_⦇_⦈", {}} && node.children[0]->children.empty() &&
         node.children[1]->kind == Kind::tuple && node.children[1]->children.size() == 2;
}

struct Sign {
  Kind kind;
  std::string_view symbol;
  int strength, left, right;  // of the node, and at least of its operands
};

constexpr Sign signs[] = {
    {Kind::equivalence, "⇔", binding::equivalence, binding::equivalence, binding::equivalence + 1},
    {Kind::implication, "⇒", binding::implication, binding::implication + 1, binding::implication},
    {Kind::disjunction, "∨", binding::disjunction, binding::disjunction, binding::disjunction + 1},
    {Kind::conjunction, "∧", binding::conjunction, binding::conjunction, binding::conjunction + 1},
    {Kind::composition, "⨟", binding::composition, binding::composition, binding::composition + 1},
    {Kind::piping, "⨠", binding::piping, binding::piping, binding::piping + 1},
    {Kind::projection, "⨡", binding::projection, binding::projection, binding::projection + 1},
    {Kind::negation, "¬", binding::negation, 0, binding::negation},
    {Kind::precondition, "pre", binding::precondition, 0, binding::precondition},
    {Kind::power, "ℙ", binding::prefix, 0, binding::prefix},
};

const Sign* sign_of(Kind kind) {
  const auto* found =
      std::find_if(std::begin(signs), std::end(signs), [kind](const Sign& s) { return s.kind == kind; });
  return found == std::end(signs) ? nullptr : found;
}

bool is_quantifier(Kind kind) {
  return kind == Kind::forall || kind == Kind::exists || kind == Kind::exists_one || kind == Kind::lambda ||
         kind == Kind::mu || kind == Kind::let;
}

int operator_strength(const Operator& op) {
  if (op.fixity == Fixity::prefix) return binding::prefix;
  if (op.fixity == Fixity::postfix) return binding::postfix;
  return binding::infix + op.precedence;
}

}  // namespace

const Node* sequence_of(const Node& application) {
  if (application.kind != Kind::application || application.children[0]->kind != Kind::reference) return nullptr;
  if (application.children[0]->name.word != "⟨,,⟩") return nullptr;
  const Node& pairs = *application.children[1];
  return pairs.kind == Kind::set_extension ? &pairs : nullptr;
}

int strength(const Node& node) {
  if (const Sign* sign = sign_of(node.kind)) return sign->strength;
  if (is_quantifier(node.kind)) return binding::weakest;
  if (const Operator* op = operator_of(node)) return operator_strength(*op);
  switch (node.kind) {
    case Kind::relation:
      return binding::relation;
    case Kind::conditional:
      return binding::conditional;
    case Kind::hiding:
      return binding::hiding;
    case Kind::product:
      return binding::infix + product_precedence;
    case Kind::application:
      if (sequence_of(node)) return binding::primary;
      return is_image(node) ? binding::postfix : binding::application;
    case Kind::schema_text:  // behind a name, its bracket would begin generic actuals
      return binding::application;
    default:
      return binding::primary;
  }
}

Printer::Printer(const Markup* markup) : latex_(markup != nullptr) {
  if (!markup) return;
  for (const auto& [command, meaning] : *markup) own_.emplace(meaning, "\\" + command);
}

void Printer::space() {
  if (out_.empty() || out_.back() == ' ' || out_.back() == '\n') return;
  for (const std::string_view open : {"(", "[", "{", "⟨"})
    if (out_.ends_with(open)) return;
  out_ += ' ';
}

std::string Printer::letters(std::string_view word) const {
  std::string made;
  while (!word.empty()) {
    const std::string_view one = utf8::first(word);
    word.remove_prefix(one.size());
    if (one == "_") {
      made += "\\_";
    } else if (const auto own = own_.find(one); own != own_.end()) {
      made += own->second + " ";
    } else if (is_letter_symbol(one)) {
      made += std::string(*latex_of(one)) + " ";
    } else {
      made += one;
    }
  }
  while (made.ends_with(' ')) made.pop_back();
  return made;
}

std::string Printer::spelled(std::string_view unicode) const {
  if (!latex_) return std::string(unicode);
  std::string_view base = unicode;
  std::string index;
  if (unicode.size() > 3 && unicode.ends_with("₁")) {
    base.remove_suffix(std::string_view("₁").size());
    index = "_1";
  }
  if (const auto own = own_.find(base); own != own_.end()) return own->second + index;
  if (unicode == "+" || unicode == "-" || unicode == "*") return std::string(unicode);
  if (const auto known = latex_of(base)) return std::string(*known) + index;
  return letters(base) + index;
}

void Printer::symbol(std::string_view unicode) {
  space();
  tight(unicode);
}

void Printer::tight(std::string_view unicode) { out_ += spelled(unicode); }

void Printer::name(const Name& name) {
  if (is_operator_name(name.word)) {
    space();
    out_ += '(';
    std::string_view rest = name.word;
    while (!rest.empty()) {
      const bool hole = rest[0] == '_';
      const std::string_view part = hole ? rest.substr(0, 1) : rest.substr(0, rest.find('_'));
      symbol(part);
      rest.remove_prefix(part.size());
    }
    out_ += ')';
    return;
  }
  symbol(name.word);
  std::string_view rest = name.strokes;
  while (!rest.empty()) {
    const std::string_view one = utf8::first(rest);
    rest.remove_prefix(one.size());
    if (latex_ && one.size() > 1) {
      out_ += "_";
      out_ += static_cast<char>('0' + (static_cast<unsigned char>(one.back()) & 0x0F));  // ₀ is U+2080
    } else {
      out_ += one;
    }
  }
}

void Printer::names(const std::vector<Name>& all) {
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (i > 0) out_ += ',';
    name(all[i]);
  }
}

void Printer::term(const Term& term, int least, bool last) {
  const Node& node = *term;
  bool parentheses = strength(node) < least;
  if (is_quantifier(node.kind)) {
    const bool logical = node.kind == Kind::forall || node.kind == Kind::exists || node.kind == Kind::exists_one;
    parentheses = !last || least > (logical ? binding::negation : binding::weakest);
  }
  if (node.kind == Kind::mu && node.children.empty()) parentheses = true;
  if (!parentheses) return bare(node, last);
  space();
  out_ += '(';
  bare(node, true);
  out_ += ')';
}

void Printer::bare(const Node& node, bool last) {
  if (is_quantifier(node.kind)) return quantified(node, last);
  if (const Sign* sign = sign_of(node.kind)) {
    if (node.children.size() == 2) return infix(node, sign->symbol, sign->left, sign->right, last);
    symbol(sign->symbol);
    return term(node.children[0], sign->right, last);
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

void Printer::quantified(const Node& node, bool last) {
  static constexpr std::pair<Kind, std::string_view> leads[] = {{Kind::forall, "∀"},      {Kind::exists, "∃"},
                                                                {Kind::exists_one, "∃₁"}, {Kind::lambda, "λ"},
                                                                {Kind::mu, "μ"},          {Kind::let, "let"}};
  for (const auto& [kind, lead] : leads)
    if (node.kind == kind) symbol(lead);
  schema_text(*node.text);
  if (node.children.empty()) return;
  symbol("•");
  term(node.children[0], binding::weakest, last);
}

void Printer::infix(const Node& node, std::string_view sign, int left, int right, bool last) {
  term(node.children[0], left, false);
  symbol(sign);
  term(node.children[1], right, last);
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
  if (is_image(node)) {
    term(node.children[1]->children[0], binding::postfix, false);
    symbol("⦇");
    term(node.children[1]->children[1], binding::weakest);
    return symbol("⦈");
  }
  term(node.children[0], binding::application, false);
  term(node.children[1], binding::primary, false);
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
  if (schema.kind == Kind::reference && schema.name.strokes.empty() && !is_operator_name(schema.name.word)) {
    if (schema.children.empty()) return name({schema.name.word, node.name.strokes});
    bare(schema, false);
  } else {
    space();
    out_ += '(';
    bare(schema, true);
    out_ += ')';
  }
  if (!node.name.strokes.empty()) name({"", node.name.strokes});
}

/// What stands behind a primary: selections, decoration, renaming, hiding.
void Printer::suffixed(const Node& node) {
  const Term& of = node.children[0];
  if (node.kind == Kind::hiding) {
    term(of, binding::hiding, false);
    symbol("⧹");
    symbol("(");
    names(node.names);
    return tight(")");
  }
  const bool would_take = of->kind == Kind::theta && node.kind != Kind::selection && node.kind != Kind::tuple_selection;
  term(of, would_take ? binding::primary + 1 : binding::primary, false);
  if (node.kind == Kind::decoration) {
    out_ += ' ';
    return name({"", node.name.strokes});
  }
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

void Printer::declaration(const Declaration& one) {
  if (one.form != Declaration::Form::included) {
    names(one.names);
    symbol(one.form == Declaration::Form::defined ? "==" : ":");
  }
  term(one.term, binding::weakest);
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
