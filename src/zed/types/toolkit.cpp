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

/// Returns the names with the types of their rows. Many rows have one type, which is read once.
std::unordered_map<Name, Scheme> schemes(const std::vector<std::string_view>& names) {
  std::unordered_map<Name, Scheme> typed;
  std::unordered_map<std::string_view, Type> types;
  for (const std::string_view name : names) {
    const OperatorRow& row = *operator_row(name);
    const auto [type, is_new] = types.try_emplace(row.type, Type::unknown());
    if (is_new) type->second = element_type(parse_unicode(row.type));
    typed.emplace(Name{std::string(name), {}}, Scheme{names_of(row.formals), type->second});
  }
  return typed;
}

}  // namespace

const Type& arithmos() {
  static const Type type = Type::given({"𝔸", {}});
  return type;
}

const std::unordered_map<Name, Scheme>& prelude() {
  static const auto table = schemes({"𝔸", "ℕ", "_+_"});
  return table;
}

const std::unordered_map<Name, Scheme>& calculator() {
  static const auto table = schemes({"_/_", "√_"});
  return table;
}

const std::unordered_map<Name, Scheme>& toolkit() {
  static const auto table = [] {
    std::vector<std::string_view> names;
    for (const OperatorRow& row : operator_rows())
      if (!row.type.empty() && !calculator().contains(Name{std::string(row.name), {}})) names.push_back(row.name);
    return schemes(names);
  }();
  return table;
}

}  // namespace durero::zed
