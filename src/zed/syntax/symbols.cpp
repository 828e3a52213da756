#include "durero/zed/syntax/symbols.hpp"

#include <algorithm>
#include <array>
#include <unordered_map>
#include <unordered_set>

namespace durero::zed {
namespace {

struct Spelling {
  std::string_view command, unicode;
};

// The commands of ISO/IEC 13568, A.2, that this reader knows. Of two commands for one symbol the first is printed.
constexpr Spelling spellings[] = {
    {"arithmos", "𝔸"},
    {"nat", "ℕ"},
    {"num", "ℤ"},
    {"power", "ℙ"},
    {"finset", "𝔽"},
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
    {"land", "∧"},
    {"lor", "∨"},
    {"lnot", "¬"},
    {"implies", "⇒"},
    {"iff", "⇔"},
    {"forall", "∀"},
    {"exists", "∃"},
    {"cross", "×"},
    {"in", "∈"},
    {"notin", "∉"},
    {"hide", "⧹"},
    {"project", "⨡"},
    {"semi", "⨟"},
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
    {"rel", "↔"},
    {"fun", "→"},
    {"pfun", "⇸"},
    {"pinj", "⤔"},
    {"inj", "↣"},
    {"psurj", "⤀"},
    {"surj", "↠"},
    {"bij", "⤖"},
    {"ffun", "⇻"},
    {"finj", "⤕"},
    {"neq", "≠"},
    {"emptyset", "∅"},
    {"subseteq", "⊆"},
    {"subset", "⊂"},
    {"cup", "∪"},
    {"cap", "∩"},
    {"setminus", "∖"},
    {"symdiff", "⊖"},
    {"bigcup", "⋃"},
    {"bigcap", "⋂"},
    {"mapsto", "↦"},
    {"dom", "dom"},
    {"ran", "ran"},
    {"id", "id"},
    {"comp", "⨾"},
    {"circ", "∘"},
    {"dres", "◁"},
    {"rres", "▷"},
    {"ndres", "⩤"},
    {"nrres", "⩥"},
    {"inv", "∼"},
    {"limg", "⦇"},
    {"rimg", "⦈"},
    {"oplus", "⊕"},
    {"plus", "⁺"},
    {"star", "∗"},
    {"disjoint", "disjoint"},
    {"partition", "partition"},
    {"negate", "-"},
    {"leq", "≤"},
    {"geq", "≥"},
    {"div", "div"},
    {"mod", "mod"},
    {"upto", "‥"},
    {"#", "#"},
    {"seq", "seq"},
    {"iseq", "iseq"},
    {"langle", "⟨"},
    {"rangle", "⟩"},
    {"cat", "⁀"},
    {"extract", "↿"},
    {"filter", "↾"},
    {"prefix", "prefix"},
    {"suffix", "suffix"},
    {"infix", "infix"},
    {"dcat", "⁀/"},
    {"vdash?", "⊢?"},
    {"min", "min"},
    {"max", "max"},
    {"mid", "|"},
    {"{", "{"},
    {"}", "}"},
    {"_", "_"},
    {"SECTION", "section"},
    {"parents", "parents"},
    {"function", "function"},
    {"generic", "generic"},
    {"relation", "relation"},
};

constexpr auto prefix = Fixity::prefix, infix = Fixity::infix, postfix = Fixity::postfix;
constexpr auto function = Role::function, generic = Role::generic, rel = Role::relation;

// The operator templates of the standard toolkit (ISO/IEC 13568, annex B), with ∈ and = of the language itself.
constexpr Operator operators[] = {
    {"↔", infix, generic, 5, true},
    {"→", infix, generic, 5, true},
    {"⇸", infix, generic, 5, true},
    {"⤔", infix, generic, 5, true},
    {"↣", infix, generic, 5, true},
    {"⤀", infix, generic, 5, true},
    {"↠", infix, generic, 5, true},
    {"⤖", infix, generic, 5, true},
    {"⇻", infix, generic, 5, true},
    {"⤕", infix, generic, 5, true},
    {"ℙ₁", prefix, generic},
    {"𝔽", prefix, generic},
    {"𝔽₁", prefix, generic},
    {"id", prefix, generic},
    {"seq", prefix, generic},
    {"seq₁", prefix, generic},
    {"iseq", prefix, generic},
    {"↦", infix, function, 10},
    {"‥", infix, function, 20},
    {"⊖", infix, function, 25},
    {"∪", infix, function, 30},
    {"∖", infix, function, 30},
    {"+", infix, function, 30},
    {"-", infix, function, 30},
    {"⁀", infix, function, 30},
    {"∩", infix, function, 40},
    {"*", infix, function, 40},
    {"div", infix, function, 40},
    {"mod", infix, function, 40},
    {"⨾", infix, function, 40},
    {"∘", infix, function, 40},
    {"↾", infix, function, 40},
    {"↿", infix, function, 45, true},
    {"⊕", infix, function, 50},
    {"▷", infix, function, 60},
    {"⩥", infix, function, 60},
    {"◁", infix, function, 65, true},
    {"⩤", infix, function, 65, true},
    {"-", prefix, function},
    {"#", prefix, function},
    {"∼", postfix, function},
    {"⁺", postfix, function},
    {"∗", postfix, function},
    {"=", infix, rel},
    {"∈", infix, rel},
    {"≠", infix, rel},
    {"∉", infix, rel},
    {"⊆", infix, rel},
    {"⊂", infix, rel},
    {"<", infix, rel},
    {"≤", infix, rel},
    {"≥", infix, rel},
    {">", infix, rel},
    {"partition", infix, rel},
    {"prefix", infix, rel},
    {"suffix", infix, rel},
    {"infix", infix, rel},
    {"disjoint", prefix, rel},
};

constexpr std::string_view reserved[] = {"if",        "then",       "else",    "let",      "pre",     "true",
                                         "false",     "section",    "parents", "function", "generic", "relation",
                                         "leftassoc", "rightassoc", "ℙ",       "θ",        "λ",       "μ"};

const auto& by_command() {
  static const auto table = [] {
    std::unordered_map<std::string_view, std::string_view> made;
    for (const Spelling& one : spellings) made.emplace(one.command, one.unicode);
    return made;
  }();
  return table;
}

}  // namespace

std::optional<std::string_view> unicode_of_command(std::string_view command) {
  const auto found = by_command().find(command);
  if (found == by_command().end()) return std::nullopt;
  return found->second;
}

std::optional<std::string_view> latex_of(std::string_view unicode) {
  static const auto table = [] {
    std::unordered_map<std::string_view, std::string> made;
    for (const Spelling& one : spellings) made.emplace(one.unicode, "\\" + std::string(one.command));
    made["|"] = "|";
    made["•"] = "@";
    return made;
  }();
  const auto found = table.find(unicode);
  if (found == table.end()) return std::nullopt;
  return found->second;
}

bool is_letter_symbol(std::string_view unicode) {
  static constexpr std::string_view letters[] = {"Δ", "Ξ", "α", "β", "γ", "δ", "ϵ", "ρ", "σ", "τ", "ϕ", "ω"};
  return std::find(std::begin(letters), std::end(letters), unicode) != std::end(letters);
}

std::string Operator::name() const {
  std::string made(fixity == Fixity::prefix ? "" : "_");
  made += symbol;
  if (fixity != Fixity::postfix) made += "_";
  return made;
}

const Operator* find_operator(std::string_view symbol, Fixity fixity) {
  static const auto table = [] {
    std::array<std::unordered_map<std::string_view, const Operator*>, 3> made;
    for (const Operator& one : operators) made[static_cast<std::size_t>(one.fixity)].emplace(one.symbol, &one);
    return made;
  }();
  const auto& these = table[static_cast<std::size_t>(fixity)];
  const auto found = these.find(symbol);
  return found == these.end() ? nullptr : found->second;
}

const Operator* operator_of_name(std::string_view name) {
  if (name.find('_') == name.npos) return nullptr;
  static const auto table = [] {
    std::unordered_map<std::string, const Operator*> made;
    for (const Operator& one : operators) made.emplace(one.name(), &one);
    return made;
  }();
  const auto found = table.find(std::string(name));
  return found == table.end() ? nullptr : found->second;
}

bool is_operator_name(std::string_view name) { return name == "_⦇_⦈" || operator_of_name(name) != nullptr; }

bool is_reserved(std::string_view word) {
  static const std::unordered_set<std::string_view> table(std::begin(reserved), std::end(reserved));
  return table.contains(word);
}

}  // namespace durero::zed
