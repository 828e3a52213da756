#include "zed/operators.hpp"

#include <unordered_map>

#include "zed/coq/level.hpp"
#include "zed/value/sets.hpp"
#include "zed/value/toolkit_functions.hpp"

namespace durero::zed {
namespace {

using In = ToolkitSection;

// X ↔ Y stands for ℙ (X × Y) in the types, and so does every arrow: for types they are one. The relations = and ∈
// belong to the language itself, and have no type here; / and √ are no section's.
constexpr OperatorRow rows[] = {
    {"_↔_", "rel", {Role::generic, 5, true}, In::set, "XY", "ℙ (X ↔ Y)", {}, {}, {}, Arrow{.function = false}},
    {"_→_",
     "fun",
     {Role::generic, 5, true},
     In::set,
     "XY",
     "ℙ (X ↔ Y)",
     {},
     {"⟶", coq::plus + 5},
     {},
     Arrow{.total = true}},
    {"_⇸_", "pfun", {Role::generic, 5, true}, In::function, "XY", "ℙ (X ↔ Y)", {}, {"⇸", coq::plus + 5}, {}, Arrow{}},
    {"_⤔_", "pinj", {Role::generic, 5, true}, In::function, "XY", "ℙ (X ↔ Y)", {}, {}, {}, Arrow{.injective = true}},
    {"_↣_",
     "inj",
     {Role::generic, 5, true},
     In::function,
     "XY",
     "ℙ (X ↔ Y)",
     {},
     {},
     {},
     Arrow{.total = true, .injective = true}},
    {"_⤀_", "psurj", {Role::generic, 5, true}, In::function, "XY", "ℙ (X ↔ Y)", {}, {}, {}, Arrow{.surjective = true}},
    {"_↠_",
     "surj",
     {Role::generic, 5, true},
     In::function,
     "XY",
     "ℙ (X ↔ Y)",
     {},
     {},
     {},
     Arrow{.total = true, .surjective = true}},
    {"_⤖_",
     "bij",
     {Role::generic, 5, true},
     In::function,
     "XY",
     "ℙ (X ↔ Y)",
     {},
     {},
     {},
     Arrow{.total = true, .injective = true, .surjective = true}},
    {"_⇻_", "ffun", {Role::generic, 5, true}, In::function, "XY", "ℙ (X ↔ Y)", {}, {}, {}, Arrow{.finite = true}},
    {"_⤕_",
     "finj",
     {Role::generic, 5, true},
     In::function,
     "XY",
     "ℙ (X ↔ Y)",
     {},
     {},
     {},
     Arrow{.injective = true, .finite = true}},
    {"ℙ₁_", "", {Role::generic}, In::set, "X", "ℙ ℙ X", functions::nonempty_subsets},
    {"𝔽_", "finset", {Role::generic}, In::set, "X", "ℙ ℙ X", functions::finite_subsets, {"𝔽", coq::applied + 20}},
    {"𝔽₁_", "", {Role::generic}, In::set, "X", "ℙ ℙ X", functions::nonempty_finite_subsets},
    {"id_", "id", {Role::generic}, In::relation, "X", "X ↔ X", functions::identity},
    {"seq_", "seq", {Role::generic}, In::sequence, "X", "ℙ (𝔸 ↔ X)", functions::sequences},
    {"seq₁_", "", {Role::generic}, In::sequence, "X", "ℙ (𝔸 ↔ X)", functions::nonempty_sequences},
    {"iseq_", "iseq", {Role::generic}, In::sequence, "X", "ℙ (𝔸 ↔ X)", functions::injective_sequences},
    {"_↦_", "mapsto", {Role::function, 10}, In::relation, "XY", "X × Y ↔ X × Y", functions::maplet},
    {"_‥_", "upto", {Role::function, 20}, In::sequence, "", "𝔸 × 𝔸 ↔ ℙ 𝔸", functions::interval},
    {"_⊖_", "symdiff", {Role::function, 25}, In::set, "X", "ℙ X × ℙ X ↔ ℙ X", functions::symmetric_difference},
    {"_∪_", "cup", {Role::function, 30}, In::set, "X", "ℙ X × ℙ X ↔ ℙ X", set_union, {"∪", coq::plus}},
    {"_∖_", "setminus", {Role::function, 30}, In::set, "X", "ℙ X × ℙ X ↔ ℙ X", set_difference, {"∖", coq::plus}},
    {"_+_", "", {Role::function, 30}, In::prelude, "", "𝔸 × 𝔸 ↔ 𝔸", functions::addition, {"+", coq::plus, {}, "Rplus"}},
    {"_-_",
     "",
     {Role::function, 30},
     In::number,
     "",
     "𝔸 × 𝔸 ↔ 𝔸",
     functions::subtraction,
     {"-", coq::plus, {}, "Rminus"}},
    {"_⁀_", "cat", {Role::function, 30}, In::sequence, "X", "(𝔸 ↔ X) × (𝔸 ↔ X) ↔ (𝔸 ↔ X)", functions::concatenation},
    {"_∩_", "cap", {Role::function, 40}, In::set, "X", "ℙ X × ℙ X ↔ ℙ X", intersection, {"∩", coq::times}},
    {"_*_",
     "",
     {Role::function, 40},
     In::number,
     "",
     "𝔸 × 𝔸 ↔ 𝔸",
     functions::multiplication,
     {"*", coq::times, {}, "Rmult"}},
    {"_/_", "", {Role::function, 40}, {}, "", "𝔸 × 𝔸 ↔ 𝔸", functions::fraction},
    {"_div_", "div", {Role::function, 40}, In::number, "", "𝔸 × 𝔸 ↔ 𝔸", functions::quotient},
    {"_mod_", "mod", {Role::function, 40}, In::number, "", "𝔸 × 𝔸 ↔ 𝔸", functions::remainder},
    {"_⨾_",
     "comp",
     {Role::function, 40},
     In::relation,
     "XYZ",
     "(X ↔ Y) × (Y ↔ Z) ↔ (X ↔ Z)",
     functions::forward_composition},
    {"_∘_",
     "circ",
     {Role::function, 40},
     In::relation,
     "XYZ",
     "(Y ↔ Z) × (X ↔ Y) ↔ (X ↔ Z)",
     functions::backward_composition},
    {"_↾_", "filter", {Role::function, 40}, In::sequence, "X", "(𝔸 ↔ X) × ℙ X ↔ (𝔸 ↔ X)", functions::filtering},
    {"_↿_", "extract", {Role::function, 45, true}, In::sequence, "X", "ℙ 𝔸 × (𝔸 ↔ X) ↔ (𝔸 ↔ X)", functions::extraction},
    {"_⊕_", "oplus", {Role::function, 50}, In::relation, "XY", "(X ↔ Y) × (X ↔ Y) ↔ (X ↔ Y)", functions::overriding},
    {"_▷_", "rres", {Role::function, 60}, In::relation, "XY", "(X ↔ Y) × ℙ Y ↔ (X ↔ Y)", functions::range_restriction},
    {"_⩥_", "nrres", {Role::function, 60}, In::relation, "XY", "(X ↔ Y) × ℙ Y ↔ (X ↔ Y)", functions::range_subtraction},
    {"_◁_",
     "dres",
     {Role::function, 65, true},
     In::relation,
     "XY",
     "ℙ X × (X ↔ Y) ↔ (X ↔ Y)",
     functions::domain_restriction,
     {"dres"}},
    {"_⩤_",
     "ndres",
     {Role::function, 65, true},
     In::relation,
     "XY",
     "ℙ X × (X ↔ Y) ↔ (X ↔ Y)",
     functions::domain_subtraction,
     {"ndres"}},
    {"-_", "negate", {Role::function}, In::number, "", "𝔸 ↔ 𝔸", functions::negation},
    {"√_", "sqrt", {Role::function}, {}, "", "𝔸 ↔ 𝔸", functions::root},
    {"#_", "#", {Role::function}, In::sequence, "X", "ℙ X ↔ 𝔸", functions::cardinality},
    {"_∼", "inv", {Role::function}, In::relation, "XY", "(X ↔ Y) ↔ (Y ↔ X)", functions::inverse, {"inverse"}},
    {"_⁺", "plus", {Role::function}, In::relation, "X", "(X ↔ X) ↔ (X ↔ X)", functions::closure},
    {"_∗", "star", {Role::function}, In::relation, "X", "(X ↔ X) ↔ (X ↔ X)", functions::reflexive_closure},
    {"_=_", "", {Role::relation}, {}, "", "", equal, {"=", coq::related, "≡"}, "_≠_"},
    {"_∈_", "in", {Role::relation}, {}, "", "", relations::element_of, {"∈", coq::related}, "_∉_"},
    {"_≠_", "neq", {Role::relation}, In::set, "X", "X ↔ X", relations::unequal, {"<>", coq::related}, "_=_"},
    {"_∉_", "notin", {Role::relation}, In::set, "X", "X ↔ ℙ X", relations::no_element_of, {"∉", coq::related}, "_∈_"},
    {"_⊆_", "subseteq", {Role::relation}, In::set, "X", "ℙ X ↔ ℙ X", subset, {"⊆", coq::related}},
    {"_⊂_", "subset", {Role::relation}, In::set, "X", "ℙ X ↔ ℙ X", relations::proper_subset},
    {"_<_", "", {Role::relation}, In::number, "", "𝔸 ↔ 𝔸", relations::less, {"<", coq::related}, "_≥_"},
    {"_≤_", "leq", {Role::relation}, In::number, "", "𝔸 ↔ 𝔸", relations::at_most, {"<=", coq::related}, "_>_"},
    {"_≥_", "geq", {Role::relation}, In::number, "", "𝔸 ↔ 𝔸", relations::at_least, {">=", coq::related}, "_<_"},
    {"_>_", "", {Role::relation}, In::number, "", "𝔸 ↔ 𝔸", relations::greater, {">", coq::related}, "_≤_"},
    {"_partition_", "partition", {Role::relation}, In::function, "LX", "(L ↔ ℙ X) ↔ ℙ X", relations::is_partition},
    {"_prefix_", "prefix", {Role::relation}, In::sequence, "X", "(𝔸 ↔ X) ↔ (𝔸 ↔ X)", relations::is_prefix},
    {"_suffix_", "suffix", {Role::relation}, In::sequence, "X", "(𝔸 ↔ X) ↔ (𝔸 ↔ X)", relations::is_suffix},
    {"_infix_", "infix", {Role::relation}, In::sequence, "X", "(𝔸 ↔ X) ↔ (𝔸 ↔ X)", relations::is_infix},
    {"disjoint_", "disjoint", {Role::relation}, In::function, "LX", "ℙ (L ↔ ℙ X)", relations::is_disjoint},
    {"ℤ", "num", {}, In::number, "", "ℙ 𝔸", functions::all_integers},
    {"ℕ₁", "", {}, In::number, "", "ℙ 𝔸", functions::positive_naturals},
    {"ℤ₁", "", {}, In::number, "", "ℙ 𝔸", functions::nonzero_integers},
    {"succ", "", {}, In::number, "", "𝔸 ↔ 𝔸", functions::successor},
    {"min", "min", {}, In::sequence, "", "ℙ 𝔸 ↔ 𝔸", functions::minimum},
    {"max", "max", {}, In::sequence, "", "ℙ 𝔸 ↔ 𝔸", functions::maximum},
    {"∅", "emptyset", {}, In::set, "X", "ℙ X", functions::nothing},
    {"⋃", "bigcup", {}, In::set, "X", "ℙ ℙ X ↔ ℙ X", big_union},
    {"⋂", "bigcap", {}, In::set, "X", "ℙ ℙ X ↔ ℙ X", big_intersection},
    {"first", "", {}, In::relation, "XY", "X × Y ↔ X", functions::first_of},
    {"second", "", {}, In::relation, "XY", "X × Y ↔ Y", functions::second_of},
    {"dom", "dom", {}, In::relation, "XY", "(X ↔ Y) ↔ ℙ X", domain, {"dom"}},
    {"ran", "ran", {}, In::relation, "XY", "(X ↔ Y) ↔ ℙ Y", functions::range, {"ran"}},
    {"_⦇_⦈", "", {}, In::relation, "XY", "(X ↔ Y) × ℙ X ↔ ℙ Y", functions::image, {"image"}},
    {"iter", "", {}, In::sequence, "X", "𝔸 ↔ ((X ↔ X) ↔ (X ↔ X))", functions::iteration},
    {"_↗_↙", "", {}, In::sequence, "X", "(X ↔ X) × 𝔸 ↔ (X ↔ X)", functions::iterated},
    {"⟨,,⟩", "", {}, In::sequence, "X", "(𝔸 ↔ X) ↔ (𝔸 ↔ X)", functions::sequence_of_pairs},
    {"⁀/", "dcat", {}, In::sequence, "X", "(𝔸 ↔ (𝔸 ↔ X)) ↔ (𝔸 ↔ X)", functions::distributed_concatenation},
    {"rev", "", {}, In::sequence, "X", "(𝔸 ↔ X) ↔ (𝔸 ↔ X)", functions::reversed},
    {"head", "", {}, In::sequence, "X", "(𝔸 ↔ X) ↔ X", functions::head},
    {"last", "", {}, In::sequence, "X", "(𝔸 ↔ X) ↔ X", functions::last},
    {"tail", "", {}, In::sequence, "X", "(𝔸 ↔ X) ↔ (𝔸 ↔ X)", functions::tail},
    {"front", "", {}, In::sequence, "X", "(𝔸 ↔ X) ↔ (𝔸 ↔ X)", functions::front},
    {"squash", "", {}, In::sequence, "X", "(𝔸 ↔ X) ↔ (𝔸 ↔ X)", functions::squashed},
    {"𝔸", "arithmos", {}, In::prelude, "", "ℙ 𝔸", functions::all_numbers},
    {"ℕ", "nat", {}, In::prelude, "", "ℙ 𝔸", functions::naturals},
};

}  // namespace

std::string_view OperatorRow::symbol() const {
  std::string_view text = name;
  if (text.starts_with('_')) text.remove_prefix(1);
  if (text.ends_with('_')) text.remove_suffix(1);
  return text;
}

std::optional<Fixity> OperatorRow::fixity() const {
  if (!binding.role) return std::nullopt;
  if (!name.starts_with('_')) return Fixity::prefix;
  return name.ends_with('_') ? Fixity::infix : Fixity::postfix;
}

std::span<const OperatorRow> operator_rows() { return rows; }

const OperatorRow* operator_row(std::string_view name) {
  static const auto by_name = [] {
    std::unordered_map<std::string_view, const OperatorRow*> table;
    for (const OperatorRow& row : rows) table.emplace(row.name, &row);
    return table;
  }();
  const auto at = by_name.find(name);
  return at == by_name.end() ? nullptr : at->second;
}

std::optional<ToolkitSection> toolkit_section_of(std::string_view name) {
  const OperatorRow* row = operator_row(name);
  return row ? row->section : std::nullopt;
}

}  // namespace durero::zed
