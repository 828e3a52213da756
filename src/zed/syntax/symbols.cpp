#include "zed/syntax/symbols.hpp"

#include <algorithm>
#include <array>
#include <unordered_map>
#include <unordered_set>
#include <vector>

#include "zed/operators.hpp"
#include "zed/syntax/connectives.hpp"

namespace durero::zed {
namespace {

struct SymbolSpelling {
  std::string_view command, unicode;
};

// These are the commands of ISO/IEC 13568, A.2, for what is no operator: letters, brackets, connectives and keywords.
// The commands of operators stand in their rows (operators.hpp).
constexpr SymbolSpelling spellings[] = {
    {"power", "ℙ"},
    {"Delta", "Δ"},
    {"Xi", "Ξ"},
    {"theta", "θ"},
    {"lambda", "λ"},
    {"mu", "μ"},
    {"alpha", "α"},
    {"beta", "β"},
    {"gamma", "γ"},
    {"delta", "δ"},
    {"epsilon", "ϵ"},
    {"rho", "ρ"},
    {"sigma", "σ"},
    {"tau", "τ"},
    {"phi", "ϕ"},
    {"omega", "ω"},
    {"zeta", "ζ"},
    {"eta", "η"},
    {"iota", "ι"},
    {"kappa", "κ"},
    {"nu", "ν"},
    {"xi", "ξ"},
    {"pi", "π"},
    {"upsilon", "υ"},
    {"chi", "χ"},
    {"psi", "ψ"},
    {"Gamma", "Γ"},
    {"Theta", "Θ"},
    {"Lambda", "Λ"},
    {"Pi", "Π"},
    {"Sigma", "Σ"},
    {"Upsilon", "Υ"},
    {"Phi", "Φ"},
    {"Psi", "Ψ"},
    {"Omega", "Ω"},
    {"land", "∧"},
    {"lor", "∨"},
    {"lnot", "¬"},
    {"implies", "⇒"},
    {"iff", "⇔"},
    {"forall", "∀"},
    {"exists", "∃"},
    {"cross", "×"},
    {"hide", "⧹"},
    {"project", "⨡"},
    {"semi", "⨟"},
    {"spot", "•"},
    {"pipe", "⨠"},
    {"pre", "pre"},
    {"IF", "if"},
    {"THEN", "then"},
    {"ELSE", "else"},
    {"LET", "let"},
    {"lblot", "⦉"},
    {"rblot", "⦊"},
    {"ldata", "⟪"},
    {"rdata", "⟫"},
    {"limg", "⦇"},
    {"rimg", "⦈"},
    {"langle", "⟨"},
    {"rangle", "⟩"},
    {"vdash?", "⊢?"},
    {"mid", "|"},
    {"{", "{"},
    {"}", "}"},
    {"_", "_"},
    {"SECTION", "section"},
    {"parents", "parents"},
    {"function", "function"},
    {"generic", "generic"},
    {"relation", "relation"},
    {"leftassoc", "leftassoc"},
    {"rightassoc", "rightassoc"},
    {"varg", "_"},
    {"listarg", ",,"},
};

constexpr std::string_view reserved[] = {"if",        "then",       "else",    "let",      "pre",     "true",
                                         "false",     "section",    "parents", "function", "generic", "relation",
                                         "leftassoc", "rightassoc", "ℙ",       "θ",        "λ",       "μ"};

/// Calls `visit` with each command and the Unicode text that it stands for.
template <class Visit>
void each_spelling(Visit&& visit) {
  for (const OperatorRow& row : operator_rows())
    if (!row.command.empty()) visit(row.command, row.symbol());
  for (const SymbolSpelling& spelling : spellings) visit(spelling.command, spelling.unicode);
}

/// Returns the operators, from their rows.
const std::vector<Operator>& operators() {
  static const auto table = [] {
    std::vector<Operator> with_role;
    for (const OperatorRow& row : operator_rows()) {
      const Binding& binding = row.binding;
      if (!binding.role) continue;
      with_role.push_back({row.symbol(), *row.fixity(), *binding.role, binding.precedence, binding.right});
    }
    return with_role;
  }();
  return table;
}

}  // namespace

std::optional<std::string_view> unicode_of_command(std::string_view command) {
  static const auto table = [] {
    std::unordered_map<std::string_view, std::string_view> by_command;
    each_spelling([&](std::string_view word, std::string_view unicode) { by_command.emplace(word, unicode); });
    return by_command;
  }();
  const auto at = table.find(command);
  if (at == table.end()) return std::nullopt;
  return at->second;
}

std::optional<std::string_view> latex_of(std::string_view unicode) {
  static const auto table = [] {
    std::unordered_map<std::string_view, std::string> by_symbol;
    each_spelling(
        [&](std::string_view word, std::string_view symbol) { by_symbol.emplace(symbol, "\\" + std::string(word)); });
    by_symbol["|"] = "|";
    by_symbol["•"] = "@";
    return by_symbol;
  }();
  const auto at = table.find(unicode);
  if (at == table.end()) return std::nullopt;
  return at->second;
}

std::vector<std::pair<std::string_view, std::string_view>> command_spellings() {
  std::vector<std::pair<std::string_view, std::string_view>> all;
  each_spelling([&](std::string_view command, std::string_view unicode) { all.emplace_back(command, unicode); });
  return all;
}

bool is_letter_symbol(std::string_view unicode) {
  if (!unicode.starts_with('\xCE') && !unicode.starts_with('\xCF')) return false;  // all are Greek
  static constexpr std::string_view letters[] = {"Δ", "Ξ", "Γ", "Θ", "Λ", "Π", "Σ", "Υ", "Φ", "Ψ", "Ω",
                                                 "α", "β", "γ", "δ", "ϵ", "ζ", "η", "ι", "κ", "ν", "ξ",
                                                 "π", "ρ", "σ", "τ", "υ", "ϕ", "χ", "ψ", "ω"};
  return std::find(std::begin(letters), std::end(letters), unicode) != std::end(letters);
}

std::string Operator::name() const {
  std::string text(fixity == Fixity::prefix ? "" : "_");
  text += symbol;
  if (fixity != Fixity::postfix) text += "_";
  return text;
}

namespace {

constexpr const Operator* Symbol::*of_fixity(Fixity fixity) {
  return fixity == Fixity::prefix ? &Symbol::prefix : fixity == Fixity::infix ? &Symbol::infix : &Symbol::postfix;
}

}  // namespace

const Symbol& symbol_of(std::string_view text) {
  static const auto table = [] {
    std::unordered_map<std::string_view, Symbol> symbols;
    for (const Operator& op : operators()) symbols[op.symbol].*of_fixity(op.fixity) = &op;
    for (const Connective& sign : connectives) symbols[sign.symbol].connective = &sign;
    for (const Quantifier& sign : quantifiers) symbols[sign.symbol].quantifier = &sign;
    for (const std::string_view word : reserved) symbols[word].reserved = true;
    for (const OperatorRow& row : operator_rows())
      if (!row.binding.role && static_cast<unsigned char>(row.name[0]) >= 0x80) symbols[row.name].named = true;
    return symbols;
  }();
  const auto at = table.find(text);
  return at == table.end() ? no_symbol : at->second;
}

const Operator* find_operator(std::string_view symbol, Fixity fixity) { return symbol_of(symbol).*of_fixity(fixity); }

const Operator* operator_of_name(std::string_view name) {
  if (name.find('_') == name.npos) return nullptr;
  static const auto table = [] {
    std::unordered_map<std::string, const Operator*> by_name;
    for (const Operator& op : operators()) by_name.emplace(op.name(), &op);
    return by_name;
  }();
  const auto at = table.find(std::string(name));
  return at == table.end() ? nullptr : at->second;
}

bool has_indexed(std::string_view word) {
  static const auto table = [] {
    static constexpr std::string_view index = "₁";
    std::unordered_set<std::string_view> words = {"∃"};  // ∃₁ is no operator
    for (const OperatorRow& row : operator_rows())
      if (row.symbol().ends_with(index)) words.insert(row.symbol().substr(0, row.symbol().size() - index.size()));
    return words;
  }();
  return table.contains(word);
}

bool is_operator_name(std::string_view name) {
  return name == "_⦇_⦈" || name == "_↗_↙" || is_template_name(name) || operator_of_name(name);
}

}  // namespace durero::zed
