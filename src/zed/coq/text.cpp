/// Puts Coq text together: connectives, binders and identifiers.
#include <fmt/format.h>

#include <algorithm>

#include "zed/coq/terms.hpp"

namespace durero::zed::coq {
namespace {

Expr joined(const std::vector<Expr>& parts, std::string_view by, int level, const char* none) {
  if (parts.empty()) return {none, atomic, {}};
  if (parts.size() == 1) return parts[0];
  Expr out{"", level, {}};
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const bool last = i + 1 == parts.size();
    // A quantifier at the end takes in nothing that it should not.
    const bool open = last && parts[i].level == binder;
    out.text +=
        (i == 0 ? "" : fmt::format(" {} ", by)) + (open ? parts[i].text : parts[i].at(last ? level : level - 1));
    if (open) out.level = binder;
  }
  return out;
}

}  // namespace

void flatten(Kind kind, const Term& term, std::vector<Term>& to) {
  if (term->kind != kind) return to.push_back(term);
  for (const Term& child : term->children) flatten(kind, child, to);
}

std::vector<Term> split(const Term& argument, std::size_t arity) {
  if (arity > 1 && argument->kind == Kind::tuple) return argument->children;
  return {argument};
}

Expr all_of(const std::vector<Expr>& conjuncts) { return joined(conjuncts, "/\\", both, "True"); }
Expr any_of(const std::vector<Expr>& disjuncts) { return joined(disjuncts, "\\/", either, "False"); }

Expr framed(const Frame& frame, const Expr& body) {
  if (frame.empty()) return body;
  std::string variables;
  std::vector<Expr> conjuncts;
  for (const auto& [v, asked] : frame) {
    variables += " " + v;
    conjuncts.push_back({asked, related, {}});
  }
  conjuncts.push_back(body);
  return {fmt::format("exists{}, {}", variables, all_of(conjuncts).text), binder, {}};
}

std::string variable(const Name& name) {
  std::string out = name.word;
  for (const char stroke : name.strokes) out += stroke == '?' ? "_in" : stroke == '!' ? "_out" : std::string(1, stroke);
  return out;
}

std::string identifier(std::string label) {
  std::replace(label.begin(), label.end(), '.', '_');
  return label;
}

std::string binders(const Signature& slots, bool bare) {
  std::string out;
  std::size_t groups = 0;
  for (std::size_t i = 0; i < slots.size();) {
    const std::string type = slots[i].type.text();
    std::string group;
    for (; i < slots.size() && slots[i].type.text() == type; ++i)
      group += (group.empty() ? "" : " ") + slots[i].variable;
    group += " : " + type;
    if (bare && groups == 0 && i == slots.size()) return group;
    out += (out.empty() ? "(" : " (") + group + ")";
    ++groups;
  }
  return out;
}

}  // namespace durero::zed::coq
