#include "scoped_values.hpp"

#include <algorithm>

#include "durero/zed/evaluate/unfold.hpp"
#include "durero/zed/syntax/parser.hpp"
#include "durero/zed/value/settled_function.hpp"

namespace durero::spec {

using zed::Kind;
using zed::Name;
using zed::Term;
using zed::Type;
using zed::Value;

namespace {

/// The most members of one set that are listed: the 3 · 3 choices of two arrays' entries with their numbers are
/// fewer.
constexpr std::size_t most_members = 1000;

using Pairs = std::vector<std::vector<Value>>;

/// Every way to give each argument one of the results, or none where that is allowed.
Pairs tables(const std::vector<Value>& arguments, const std::vector<Value>& results, bool total) {
  Pairs all{{}};
  for (const Value& argument : arguments) {
    Pairs longer;
    for (const auto& pairs : all) {
      if (!total && longer.size() < most_members) longer.push_back(pairs);
      for (const Value& result : results) {
        if (longer.size() >= most_members) break;
        longer.push_back(pairs);
        longer.back().push_back(Value::pair(argument, result));
      }
    }
    all = std::move(longer);
  }
  return all;
}

ScopedMembers finite_tables(const std::vector<Value>& arguments, const std::vector<Value>& results, bool total) {
  ScopedMembers members;
  for (auto& pairs : tables(arguments, results, total)) members.values.push_back(Value::set(std::move(pairs)));
  return members;
}

/// The tables from `least` on that are constant behind so many places.
ScopedMembers infinite_tables(int least, int places, const std::vector<Value>& results) {
  std::vector<Value> arguments;
  for (int i = 0; i < places; ++i) arguments.emplace_back(zed::Real(least + i));
  ScopedMembers members;
  for (const Value& rest : results)
    for (auto& pairs : tables(arguments, results, true))
      members.values.push_back(zed::settled_function(least, std::move(pairs), rest));
  return members;
}

ScopedMembers some_subsets_of(const std::vector<Value>& of) {
  ScopedMembers members{{Value::set({})}, false};
  std::vector<std::vector<Value>> sets{{}};
  for (const Value& member : of)
    for (std::size_t i = 0, end = sets.size(); i < end && sets.size() < most_members; ++i) {
      sets.push_back(sets[i]);
      sets.back().push_back(member);
      members.values.push_back(Value::set(sets.back()));
    }
  return members;
}

ScopedMembers sequences_of(const std::vector<Value>& items, int most_length) {
  ScopedMembers members;
  std::vector<Value> places;
  for (int length = 0; length <= most_length; ++length) {
    if (length > 0) places.emplace_back(zed::Real(length));
    for (auto& pairs : tables(places, items, true))
      if (members.values.size() < most_members) members.values.push_back(Value::set(std::move(pairs)));
  }
  return members;
}

std::vector<std::vector<Value>> rows_of(const std::vector<std::vector<Value>>& parts) {
  std::vector<std::vector<Value>> rows{{}};
  for (const auto& values : parts) {
    std::vector<std::vector<Value>> longer;
    for (const auto& row : rows)
      for (const Value& value : values) {
        if (longer.size() >= most_members) break;
        longer.push_back(row);
        longer.back().push_back(value);
      }
    rows = std::move(longer);
  }
  return rows;
}

std::vector<Value> small_integers(int most) {
  std::vector<Value> numbers{zed::Real(0)};
  for (int n = 1; n <= most; ++n) numbers.emplace_back(zed::Real(n));
  for (int n = 1; n <= most; ++n) numbers.emplace_back(zed::Real(-n));
  return numbers;
}

bool is_one_of(const std::string& word, std::initializer_list<const char*> words) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

/// The least number of ℕ or ℕ₁.
std::optional<int> least_of(const Term& set) {
  const std::string name = set->kind == Kind::reference && set->children.empty() ? set->name.text() : "";
  if (name == "ℕ") return 0;
  return name == "ℕ₁" ? std::optional(1) : std::nullopt;
}

}  // namespace

const ScopedMembers& ScopedValues::of(const std::string& schema, const Name& component) {
  const std::pair key{schema, component};
  const auto at = known_.find(key);
  if (at != known_.end()) return at->second;
  const Type& binding = parts_.typing.find(Machine::Parts::section_name, {schema, ""})->scheme.type.parts()[0];
  const Type element = binding.field(component)->settled();
  const std::optional<Term> set = declared_set(schema, component);
  return known_.emplace(key, set ? of_set(*set, element) : of_type(element)).first->second;
}

std::optional<Term> ScopedValues::declared_set(const std::string& schema, const Name& component) {
  const Type& binding = parts_.typing.find(Machine::Parts::section_name, {schema, ""})->scheme.type.parts()[0];
  const auto carrier = [&](const Name& name) {
    const Type* type = binding.field(name);
    return type && type->is_known() ? zed::parse_unicode(type->settled().text(Type::max_size)) : Term();
  };
  if (!texts_.contains(schema))
    texts_[schema] = zed::unfolded(zed::reference({schema, ""}), parts_.specification.sections, carrier);
  const std::optional<Term>& text = texts_[schema];
  if (!text) return std::nullopt;
  for (const zed::Declaration& declaration : (*text)->text->declarations)
    if (declaration.form == zed::Declaration::Form::typed &&
        std::find(declaration.names.begin(), declaration.names.end(), component) != declaration.names.end())
      return declaration.term;
  return std::nullopt;
}

// A value that is listed is a member, as the text's evaluator says.
ScopedMembers ScopedValues::of_set(const Term& set, const Type& element) const {
  std::optional<Value> whole;
  try {
    parts_.begin_question();
    whole = parts_.evaluator->value(set);
    const auto* members = whole->set() ? whole->set()->members() : nullptr;
    if (members && members->size() <= most_members) return {*members, true};
  } catch (const zed::EvaluationError&) {  // the type says what there may be
  } catch (const zed::StepsSpent&) {
  }
  ScopedMembers listed = by_form(set, element);
  const auto is_member = [&](const Value& value) {
    if (!whole) return true;
    try {
      parts_.begin_question();
      return parts_.evaluator->contains(*whole, value) != zed::Truth::no;
    } catch (const zed::EvaluationError&) {
      return true;  // the schema is asked again
    }
  };
  std::erase_if(listed.values, [&](const Value& value) { return !is_member(value); });
  const auto before = [](const Value& a, const Value& b) { return zed::compare(a, b) < 0; };
  std::stable_sort(listed.values.begin(), listed.values.end(), before);
  listed.values.erase(std::unique(listed.values.begin(), listed.values.end(), zed::same), listed.values.end());
  return listed;
}

ScopedMembers ScopedValues::by_form(const Term& set, const Type& element) const {
  const bool operation = set->kind == Kind::reference && !set->children.empty();
  const std::string word = operation ? set->name.text() : "";
  if (is_one_of(word, {"_→_", "_↣_", "_↠_", "_⤖_"})) return functions(set, element, true);
  if (is_one_of(word, {"_⇸_", "_⤔_", "_⤀_", "_⇻_", "_⤕_"})) return functions(set, element, false);
  if (is_one_of(word, {"seq_", "seq₁_", "iseq_"}))
    return sequences_of(of_set(set->children[0], element.parts()[0].parts()[1]).values, size_);
  if (set->kind == Kind::power || is_one_of(word, {"𝔽_", "𝔽₁_", "ℙ₁_"}))
    return some_subsets_of(of_set(set->children[0], element.parts()[0]).values);
  if (set->kind == Kind::product) {
    std::vector<std::vector<Value>> parts;
    for (std::size_t i = 0; i < set->children.size(); ++i)
      parts.push_back(of_set(set->children[i], element.parts()[i]).values);
    ScopedMembers members;
    for (auto& row : rows_of(parts)) members.values.push_back(Value::tuple(std::move(row)));
    return members;
  }
  return of_type(element);
}

ScopedMembers ScopedValues::functions(const Term& set, const Type& element, bool total) const {
  const Type& pair = element.parts()[0];
  const ScopedMembers to = of_set(set->children[1], pair.parts()[1]);
  if (const auto least = least_of(set->children[0]); least && total) return infinite_tables(*least, size_, to.values);
  return finite_tables(of_set(set->children[0], pair.parts()[0]).values, to.values, total);
}

ScopedMembers ScopedValues::of_type(const Type& type) const {
  if (type.is(Type::Kind::power)) return some_subsets_of(of_type(type.parts()[0]).values);
  if (type.is(Type::Kind::product) || type.is(Type::Kind::schema)) {
    std::vector<std::vector<Value>> parts;
    for (const Type& part : type.parts()) parts.push_back(of_type(part).values);
    ScopedMembers members;
    for (auto& row : rows_of(parts))
      members.values.push_back(type.is(Type::Kind::product)
                                   ? Value::tuple(std::move(row))
                                   : Value::binding(zed::signature(type.fields()), std::move(row)));
    return members;
  }
  if (!type.is(Type::Kind::given)) return {};
  return type.name().text() == "𝔸" ? ScopedMembers{small_integers(size_), false} : of_given(type.name());
}

/// A given set has the members that the scope gives it; a free type has its constants, and what its constructors make.
ScopedMembers ScopedValues::of_given(const Name& name) const {
  for (const zed::Section& section : parts_.specification.sections)
    for (const zed::Paragraph& paragraph : section.paragraphs)
      if (const auto* form = std::get_if<zed::FreeType>(&paragraph.form); form && form->name == name)
        return of_free_type(*form);
  try {
    const Value whole = parts_.evaluator->value(name);
    const auto* members = whole.set() ? whole.set()->members() : nullptr;
    if (members) return {*members, true};
  } catch (const zed::EvaluationError&) {  // nothing of it is known
  }
  return {};
}

/// Adds what a constructor makes of the members of its argument's set.
void ScopedValues::add_constructed(const zed::Branch& branch, ScopedMembers& to) const {
  to.all = to.all && nested_ < size_;
  const auto type = parts_.typing.type_of(branch.argument);
  if (nested_ == size_ || !type || !type->is(Type::Kind::power)) return;
  ++nested_;
  const ScopedMembers arguments = of_set(branch.argument, type->settled().parts()[0]);
  --nested_;
  to.all = to.all && arguments.all && to.values.size() + arguments.values.size() <= most_members;
  const Value constructor = parts_.evaluator->value(branch.name);
  for (const Value& argument : arguments.values)
    if (to.values.size() < most_members) to.values.push_back(parts_.evaluator->apply(constructor, argument));
}

ScopedMembers ScopedValues::of_free_type(const zed::FreeType& form) const {
  ScopedMembers made{{}, true};
  for (const zed::Branch& branch : form.branches)
    if (branch.argument)
      add_constructed(branch, made);
    else
      made.values.push_back(parts_.evaluator->value(branch.name));
  return made;
}

}  // namespace durero::spec
