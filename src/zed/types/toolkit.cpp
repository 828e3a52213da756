#include "durero/zed/types/toolkit.hpp"

#include <stdexcept>

#include "durero/zed/syntax/parser.hpp"

namespace durero::zed {
namespace {

struct Entry {
  std::string_view name, formals, set;  // name : set; formals one letter each
};

// X ↔ Y stands for ℙ (X × Y), and so does every arrow: for types they are one.
constexpr Entry entries[] = {
    {"ℤ", "", "ℙ 𝔸"},
    {"ℕ₁", "", "ℙ 𝔸"},
    {"succ", "", "𝔸 ↔ 𝔸"},
    {"-_", "", "𝔸 ↔ 𝔸"},
    {"_-_", "", "𝔸 × 𝔸 ↔ 𝔸"},
    {"_*_", "", "𝔸 × 𝔸 ↔ 𝔸"},
    {"_div_", "", "𝔸 × 𝔸 ↔ 𝔸"},
    {"_mod_", "", "𝔸 × 𝔸 ↔ 𝔸"},
    {"_<_", "", "𝔸 ↔ 𝔸"},
    {"_≤_", "", "𝔸 ↔ 𝔸"},
    {"_≥_", "", "𝔸 ↔ 𝔸"},
    {"_>_", "", "𝔸 ↔ 𝔸"},
    {"_‥_", "", "𝔸 × 𝔸 ↔ ℙ 𝔸"},
    {"min", "", "ℙ 𝔸 ↔ 𝔸"},
    {"max", "", "ℙ 𝔸 ↔ 𝔸"},
    {"#_", "X", "ℙ X ↔ 𝔸"},
    {"_↔_", "XY", "ℙ (X ↔ Y)"},
    {"_→_", "XY", "ℙ (X ↔ Y)"},
    {"_⇸_", "XY", "ℙ (X ↔ Y)"},
    {"_⤔_", "XY", "ℙ (X ↔ Y)"},
    {"_↣_", "XY", "ℙ (X ↔ Y)"},
    {"_⤀_", "XY", "ℙ (X ↔ Y)"},
    {"_↠_", "XY", "ℙ (X ↔ Y)"},
    {"_⤖_", "XY", "ℙ (X ↔ Y)"},
    {"_⇻_", "XY", "ℙ (X ↔ Y)"},
    {"_⤕_", "XY", "ℙ (X ↔ Y)"},
    {"_≠_", "X", "X ↔ X"},
    {"_∉_", "X", "X ↔ ℙ X"},
    {"∅", "X", "ℙ X"},
    {"_⊆_", "X", "ℙ X ↔ ℙ X"},
    {"_⊂_", "X", "ℙ X ↔ ℙ X"},
    {"ℙ₁_", "X", "ℙ ℙ X"},
    {"𝔽_", "X", "ℙ ℙ X"},
    {"𝔽₁_", "X", "ℙ ℙ X"},
    {"_∪_", "X", "ℙ X × ℙ X ↔ ℙ X"},
    {"_∩_", "X", "ℙ X × ℙ X ↔ ℙ X"},
    {"_∖_", "X", "ℙ X × ℙ X ↔ ℙ X"},
    {"_⊖_", "X", "ℙ X × ℙ X ↔ ℙ X"},
    {"⋃", "X", "ℙ ℙ X ↔ ℙ X"},
    {"⋂", "X", "ℙ ℙ X ↔ ℙ X"},
    {"first", "XY", "X × Y ↔ X"},
    {"second", "XY", "X × Y ↔ Y"},
    {"_↦_", "XY", "X × Y ↔ X × Y"},
    {"dom", "XY", "(X ↔ Y) ↔ ℙ X"},
    {"ran", "XY", "(X ↔ Y) ↔ ℙ Y"},
    {"id_", "X", "X ↔ X"},
    {"_⨾_", "XYZ", "(X ↔ Y) × (Y ↔ Z) ↔ (X ↔ Z)"},
    {"_∘_", "XYZ", "(Y ↔ Z) × (X ↔ Y) ↔ (X ↔ Z)"},
    {"_◁_", "XY", "ℙ X × (X ↔ Y) ↔ (X ↔ Y)"},
    {"_⩤_", "XY", "ℙ X × (X ↔ Y) ↔ (X ↔ Y)"},
    {"_▷_", "XY", "(X ↔ Y) × ℙ Y ↔ (X ↔ Y)"},
    {"_⩥_", "XY", "(X ↔ Y) × ℙ Y ↔ (X ↔ Y)"},
    {"_∼", "XY", "(X ↔ Y) ↔ (Y ↔ X)"},
    {"_⦇_⦈", "XY", "(X ↔ Y) × ℙ X ↔ ℙ Y"},
    {"_⊕_", "XY", "(X ↔ Y) × (X ↔ Y) ↔ (X ↔ Y)"},
    {"_⁺", "X", "(X ↔ X) ↔ (X ↔ X)"},
    {"_∗", "X", "(X ↔ X) ↔ (X ↔ X)"},
    {"disjoint_", "LX", "ℙ (L ↔ ℙ X)"},
    {"_partition_", "LX", "(L ↔ ℙ X) ↔ ℙ X"},
    {"seq_", "X", "ℙ (𝔸 ↔ X)"},
    {"seq₁_", "X", "ℙ (𝔸 ↔ X)"},
    {"iseq_", "X", "ℙ (𝔸 ↔ X)"},
    {"⟨,,⟩", "X", "(𝔸 ↔ X) ↔ (𝔸 ↔ X)"},
    {"_⁀_", "X", "(𝔸 ↔ X) × (𝔸 ↔ X) ↔ (𝔸 ↔ X)"},
    {"⁀/", "X", "(𝔸 ↔ (𝔸 ↔ X)) ↔ (𝔸 ↔ X)"},
    {"rev", "X", "(𝔸 ↔ X) ↔ (𝔸 ↔ X)"},
    {"head", "X", "(𝔸 ↔ X) ↔ X"},
    {"last", "X", "(𝔸 ↔ X) ↔ X"},
    {"tail", "X", "(𝔸 ↔ X) ↔ (𝔸 ↔ X)"},
    {"front", "X", "(𝔸 ↔ X) ↔ (𝔸 ↔ X)"},
    {"squash", "X", "(𝔸 ↔ X) ↔ (𝔸 ↔ X)"},
    {"_↿_", "X", "ℙ 𝔸 × (𝔸 ↔ X) ↔ (𝔸 ↔ X)"},
    {"_↾_", "X", "(𝔸 ↔ X) × ℙ X ↔ (𝔸 ↔ X)"},
    {"_prefix_", "X", "(𝔸 ↔ X) ↔ (𝔸 ↔ X)"},
    {"_suffix_", "X", "(𝔸 ↔ X) ↔ (𝔸 ↔ X)"},
    {"_infix_", "X", "(𝔸 ↔ X) ↔ (𝔸 ↔ X)"},
};

/// The type of the elements of a set that is written with 𝔸, formals, ℙ, × and ↔ only.
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

Scheme scheme(std::string_view formals, std::string_view set) {
  std::vector<Name> names;
  for (const char letter : formals) names.push_back({std::string(1, letter), {}});
  return {std::move(names), element_type(parse_unicode(set))};
}

}  // namespace

const Type& arithmos() {
  static const Type type = Type::given({"𝔸", {}});
  return type;
}

const std::unordered_map<Name, Scheme>& prelude() {
  static const std::unordered_map<Name, Scheme> table = {
      {{"𝔸", {}}, scheme("", "ℙ 𝔸")}, {{"ℕ", {}}, scheme("", "ℙ 𝔸")}, {{"_+_", {}}, scheme("", "𝔸 × 𝔸 ↔ 𝔸")}};
  return table;
}

const std::unordered_map<Name, Scheme>& toolkit() {
  static const auto table = [] {
    std::unordered_map<Name, Scheme> made = prelude();
    for (const Entry& one : entries) made.emplace(Name{std::string(one.name), {}}, scheme(one.formals, one.set));
    return made;
  }();
  return table;
}

}  // namespace durero::zed
