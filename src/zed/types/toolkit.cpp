#include "zed/types/toolkit.hpp"

#include <stdexcept>
#include <string_view>
#include <vector>

#include "durero/zed/syntax/parser.hpp"
#include "zed/operators.hpp"

namespace durero::zed {
namespace {

/// Returns the type of the elements of a set that is written with 𝔸, formals, ℙ, × and ↔ only.
Type element_type(const Term& set) {
  std::vector<Type> parts;
  for (const Term& child : set->children) parts.push_back(element_type(child));
  if (set->kind == Kind::power) return Type::power(parts[0]);
  if (set->kind == Kind::product) return Type::product(std::move(parts));
  if (set->kind == Kind::reference && set->name.word == "_↔_") return Type::power(Type::product(std::move(parts)));
  if (set->kind == Kind::reference && set->name.word == "𝔸") return arithmos();
  if (set->kind == Kind::reference && parts.empty()) return Type::formal(set->name);
  throw std::logic_error("a set of the toolkit's table is not in its notation");
}

std::vector<Name> names_of(std::string_view formals) {
  std::vector<Name> names;
  for (const char letter : formals) names.push_back({std::string(1, letter), {}});
  return names;
}

/// Reads the types of rows. Many rows have one type, which is read once.
class RowTypes {
 public:
  Scheme scheme(const OperatorRow& row) {
    const auto [type, is_new] = types_.try_emplace(row.type, Type::unknown());
    if (is_new) type->second = element_type(parse_unicode(row.type));
    return {names_of(row.formals), type->second};
  }

 private:
  std::unordered_map<std::string_view, Type> types_;
};

}  // namespace

const Type& arithmos() {
  static const Type type = Type::given({"𝔸", {}});
  return type;
}

const std::unordered_map<Name, Scheme>& calculator() {
  static const auto table = [] {
    std::unordered_map<Name, Scheme> typed;
    for (const char* name : {"_/_", "√_"}) typed.emplace(Name{name, {}}, RowTypes().scheme(*operator_row(name)));
    return typed;
  }();
  return table;
}

const std::unordered_map<Name, ToolkitEntry>& toolkit() {
  static const auto table = [] {
    RowTypes types;
    std::unordered_map<Name, ToolkitEntry> typed;
    for (const OperatorRow& row : operator_rows())
      if (row.section) typed.emplace(Name{std::string(row.name), {}}, ToolkitEntry{*row.section, types.scheme(row)});
    return typed;
  }();
  return table;
}

const Scheme* toolkit_scheme(const Name& name, ToolkitSections seen) {
  const auto at = toolkit().find(name);
  return at != toolkit().end() && seen.has(at->second.section) ? &at->second.scheme : nullptr;
}

}  // namespace durero::zed
