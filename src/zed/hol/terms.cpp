#include <fmt/format.h>

#include <algorithm>

#include "durero/zed/syntax/defect.hpp"
#include "zed/hol/writer.hpp"

namespace durero::zed::hol {
namespace {

/// A name of the toolkit, and that of its function.
struct ToolkitName {
  const char* z;
  const char* written;
};

constexpr ToolkitName functions_of_two[] = {
    {"_∪_", "z_union"}, {"_∩_", "z_inter"}, {"_∖_", "z_diff"},  {"_⊕_", "z_override"}, {"_◁_", "z_dres"},
    {"_⩤_", "z_ndres"}, {"_▷_", "z_rres"},  {"_⩥_", "z_nrres"}, {"_⨾_", "z_compose"},  {"_∘_", "z_after"},
    {"_‥_", "z_upto"},  {"_+_", "z_plus"},  {"_-_", "z_minus"}, {"_*_", "z_times"},    {"_⦇_⦈", "z_image"},
};
constexpr ToolkitName functions_of_one[] = {{"dom", "z_dom"}, {"ran", "z_ran"}, {"_∼", "z_inverse"}};
constexpr ToolkitName sets_of_sets[] = {
    {"_→_", "z_tfun"},   {"_⇸_", "z_pfun"},  {"_↔_", "z_rel"},     {"_⤔_", "z_pinj"}, {"_↣_", "z_tinj"},
    {"_⤀_", "z_psurj"},  {"_↠_", "z_tsurj"}, {"_⤖_", "z_bij"},     {"_⇻_", "z_ffun"}, {"_⤕_", "z_finj"},
    {"ℙ₁_", "z_power1"}, {"𝔽_", "z_finset"}, {"𝔽₁_", "z_finset1"}, {"seq_", "z_seq"}, {"id_", "z_id"},
};
constexpr ToolkitName constants_of_z[] = {
    {"ℤ", "z_int"}, {"𝔸", "z_int"}, {"ℕ", "z_nat"}, {"ℕ₁", "z_nat1"}, {"∅", "z_empty"}};
constexpr ToolkitName applied_relations[] = {{"#_", "z_card"}, {"min", "z_min"}, {"max", "z_max"}};

template <std::size_t n>
const char* written_as(const ToolkitName (&table)[n], const std::string& name) {
  const auto* at = std::find_if(std::begin(table), std::end(table), [&](const auto& row) { return name == row.z; });
  return at == std::end(table) ? nullptr : at->written;
}

}  // namespace

void not_covered(Place place, const std::string& what) {
  throw ZError(place, what + " has no rule of translation to higher-order logic",
               "expected sets, functions and relations of the toolkit, and integers");
}

std::string HolWriter::tuple(const std::vector<std::string>& parts) const {
  std::string said;
  for (const std::string& part : parts) said += (said.empty() ? "" : ", ") + part;
  return parts.size() == 1 ? said : "(" + said + ")";
}

std::string HolWriter::word(const Name& name, Place place) const {
  std::string out = name.word;
  for (const char c : out)
    if (static_cast<unsigned char>(c) >= 0x80) not_covered(place, "the letters of " + name.text());
  if (out.starts_with("_") || out.ends_with("_")) not_covered(place, "the name " + name.text());
  for (std::size_t i = 0; i < name.strokes.size(); ++i) {
    const char stroke = name.strokes[i];
    if (static_cast<unsigned char>(stroke) >= 0x80) not_covered(place, "the name " + name.text());
    out += stroke == '?' ? "_in" : stroke == '!' ? "_out" : "'";
  }
  static const std::set<std::string> words = {
      "Type", "Prop", "Set",  "fun",    "forall", "exists", "in",  "as",   "at",  "if",    "then", "else", "match",
      "with", "end",  "let",  "return", "fix",    "where",  "of",  "case", "and", "or",    "not",  "True", "False",
      "set",  "int",  "bool", "list",   "Z",      "fst",    "snd", "In",   "nat", "begin", "is",   "for",  "open"};
  return words.contains(out) ? out + "_z" : out;
}

/// The word of a variable; one that is a global name, or another variable in scope, gets an ending.
std::string HolWriter::variable(const Name& name, const Written& scope, Place place) const {
  std::string out = word(name, place);
  const auto taken = [&] {
    return words_.contains(out) || std::any_of(scope.begin(), scope.end(), [&](const auto& entry) {
             return entry.second == out && entry.first != name;
           });
  };
  while (taken()) out += "_v";
  return out;
}

std::string HolWriter::type(const Type& type, Place place) const {
  std::vector<std::string> parts;
  for (const Type& part : type.is(Type::Kind::schema) ? std::vector<Type>() : type.parts())
    parts.push_back(this->type(part, place));
  if (type.is(Type::Kind::power)) return dialect_.set_of(parts[0]);
  if (type.is(Type::Kind::product) && parts.size() == 2) return dialect_.pair_of(parts);
  if (!type.is(Type::Kind::given)) not_covered(place, "the type " + type.text());
  if (type.name().text() == "𝔸") return dialect_.integers();
  return globals_.at(type.name().text());
}

std::string HolWriter::term(const Term& whole, const Written& scope, Applied& applied) {
  const auto part = [&](std::size_t i) { return term(whole->children[i], scope, applied); };
  switch (whole->kind) {
    case Kind::reference:
      return reference(whole, scope, applied);
    case Kind::number:
      return whole->name.word;
    case Kind::set_extension:
      return extension(whole->children, scope, applied);
    case Kind::comprehension:
    case Kind::lambda:
      return comprehension(whole, scope);
    case Kind::tuple:
      if (whole->children.size() != 2) not_covered(whole->place, "a tuple of more than two");
      return tuple({part(0), part(1)});
    case Kind::product:
      if (whole->children.size() != 2) not_covered(whole->place, "a product of more than two");
      return fmt::format("(z_cross {} {})", part(0), part(1));
    case Kind::power:
      return fmt::format("(z_power {})", part(0));
    case Kind::application:
      return application(whole, scope, applied);
    case Kind::conditional:
      return conditional(whole, scope, applied);
    case Kind::selection:
    case Kind::tuple_selection:
    case Kind::binding_extension:
    case Kind::theta:
    case Kind::mu:
    case Kind::let:
    case Kind::schema_text:
    case Kind::decoration:
    case Kind::renaming:
    case Kind::hiding:
    case Kind::composition:
    case Kind::piping:
    case Kind::projection:
    case Kind::precondition:
    case Kind::negation:
    case Kind::conjunction:
    case Kind::disjunction:
    case Kind::implication:
    case Kind::equivalence:
    case Kind::forall:
    case Kind::exists:
    case Kind::exists_one:
    case Kind::truth:
    case Kind::falsity:
    case Kind::relation:
      break;
  }
  not_covered(whole->place, "this expression");
}

std::string HolWriter::reference(const Term& term, const Written& scope, Applied& applied) {
  const std::string name = term->name.text();
  if (const auto local = scope.find(term->name); local != scope.end()) return local->second;
  if (given_.contains(name)) return dialect_.whole(globals_.at(name));
  if (constructors_.contains(name)) not_covered(term->place, "a constructor that is not applied");
  if (const auto known = globals_.find(name); known != globals_.end()) return known->second;
  if (const char* constant = written_as(constants_of_z, name)) return constant;
  const char* of_sets = written_as(sets_of_sets, name);
  if (!of_sets || term->children.empty()) not_covered(term->place, "the name " + name);
  std::string said = of_sets;
  for (const Term& child : term->children) said += " " + this->term(child, scope, applied);
  return "(" + said + ")";
}

std::string HolWriter::extension(const std::vector<Term>& members, const Written& scope, Applied& applied) {
  std::string said = "z_empty";
  for (auto at = members.rbegin(); at != members.rend(); ++at)
    said = fmt::format("(z_insert {} {})", term(*at, scope, applied), said);
  return said;
}

std::string HolWriter::application(const Term& whole, const Written& scope, Applied& applied) {
  const Term &function = whole->children[0], &argument = whole->children[1];
  const bool named = function->kind == Kind::reference && !scope.contains(function->name);
  const std::string own = named ? function->name.text() : "", name = globals_.contains(own) ? "" : own;
  const bool two = argument->kind == Kind::tuple && argument->children.size() == 2;
  if (name == "⟨,,⟩") return term(argument, scope, applied);
  if (name == "_↦_" && two) return term(argument, scope, applied);
  if (const char* written = written_as(functions_of_two, name); written && two)
    return fmt::format("({} {} {})", written, term(argument->children[0], scope, applied),
                       term(argument->children[1], scope, applied));
  if (const char* written = written_as(functions_of_one, name))
    return fmt::format("({} {})", written, term(argument, scope, applied));
  if (name == "-_") return fmt::format("(z_minus 0 {})", term(argument, scope, applied));
  if (constructors_.contains(own)) return fmt::format("({} {})", globals_.at(own), term(argument, scope, applied));
  const char* relation = written_as(applied_relations, name);
  const std::string f = relation ? relation : term(function, scope, applied), x = term(argument, scope, applied);
  const std::string value = fresh();
  applied.emplace_back(value, fmt::format("(z_app {} {} {})", f, x, value));
  return value;
}

/// { D | P • E } has each y for which there are values in D with P and y = E; a λ has the pairs of its arguments and E.
std::string HolWriter::comprehension(const Term& whole, const Written& scope) {
  Written inner = scope;
  Binders variables;
  std::vector<std::string> asked = declare(*whole->text, scope, inner, variables);
  std::vector<std::string> parts;
  for (const auto& [name, type] : variables) parts.push_back(name);
  if (whole->kind != Kind::lambda && whole->children.empty() && parts.size() == 1)
    return fmt::format("(z_collect {})", dialect_.function(parts[0], dialect_.all_of(asked)));
  if (parts.size() > 2 && (whole->children.empty() || whole->kind == Kind::lambda))
    not_covered(whole->place, "a tuple of more than two");
  Applied applied;
  std::string made = tuple(parts);
  if (!whole->children.empty()) {
    const std::string value = term(whole->children[0], inner, applied);
    made = whole->kind == Kind::lambda ? tuple({made, value}) : value;
  }
  const std::string y = fresh();
  asked.push_back(with(applied, fmt::format("({} = {})", y, made)));
  return fmt::format("(z_collect {})", dialect_.function(y, dialect_.some(variables, dialect_.all_of(asked))));
}

std::string HolWriter::conditional(const Term& whole, const Written& scope, Applied& applied) {
  const std::string condition = predicate(whole->children[0], scope), value = fresh();
  Applied of_then, of_else;
  const std::string a = term(whole->children[1], scope, of_then), b = term(whole->children[2], scope, of_else);
  const std::string then = with(of_then, fmt::format("({} = {})", value, a));
  const std::string other = with(of_else, fmt::format("({} = {})", value, b));
  applied.emplace_back(
      value, dialect_.all_of({dialect_.implied(condition, then), dialect_.implied(dialect_.denied(condition), other)}));
  return value;
}

}  // namespace durero::zed::hol
