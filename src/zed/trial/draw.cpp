#include "zed/trial/draw.hpp"

#include <algorithm>
#include <utility>

namespace durero::zed {
namespace {

constexpr std::size_t members_of_a_set = 3;

Value pick(const std::vector<Value>& from, Chances& chances) { return from[chances.below(from.size())]; }

/// The constants of a free type.
std::vector<Value> constants(const FreeType& form) {
  std::vector<Value> found;
  for (std::size_t i = 0; i < form.branches.size(); ++i)
    if (!form.branches[i].argument)
      found.push_back(Value::atom(form.name.text(), form.branches[i].name.text(), static_cast<std::uint32_t>(i)));
  return found;
}

/// The members that the evaluator has for the given set, or names that are made up for it.
std::vector<Value> members(const Name& given, const Evaluator& evaluator) {
  const Value known = evaluator.value(given);
  if (const auto* listed = known.set() ? known.set()->members() : nullptr) return {listed->begin(), listed->end()};
  std::vector<Value> found;
  for (std::size_t i = 1; i <= names_of_a_given_set; ++i)
    found.push_back(Value::atom(given.text(), given.text() + "_" + std::to_string(i)));
  return found;
}

}  // namespace

// Steele, Lea and Flood, Fast splittable pseudorandom number generators (2014).
std::size_t Chances::below(std::size_t end) {
  if (std::exchange(first_, false)) return draw_ % end;
  std::uint64_t z = state_ += 0x9E3779B97F4A7C15U;
  z = (z ^ (z >> 30U)) * 0xBF58476D1CE4E5B9U;
  z = (z ^ (z >> 27U)) * 0x94D049BB133111EBU;
  return (z ^ (z >> 31U)) % end;
}

Draw::Draw(const Specification& specification, const Typing& typing, const Samples& samples, const Evaluator& evaluator,
           const std::optional<std::pair<std::int64_t, std::int64_t>>& numbers)
    : evaluator_(evaluator), numbers_(numbers), samples_(samples) {
  for (const Section& section : specification.sections)
    for (const Paragraph& paragraph : section.paragraphs) {
      if (const auto* form = std::get_if<FreeType>(&paragraph.form)) add(*form, typing);
      if (const auto* form = std::get_if<GivenTypes>(&paragraph.form))
        for (const Name& name : form->names)
          if (!samples_.contains(name.text())) samples_.emplace(name.text(), members(name, evaluator));
      if (const auto* form = std::get_if<Schema>(&paragraph.form)) texts_[form->name.text()] = &form->text;
      if (const auto* form = std::get_if<Definition>(&paragraph.form); form && form->value->kind == Kind::schema_text)
        texts_[form->name.text()] = form->value->text.get();
    }
}

void Draw::add(const FreeType& form, const Typing& typing) {
  Free free{constants(form), {}};
  for (const Branch& branch : form.branches) {
    const auto set = branch.argument ? typing.type_of(branch.argument) : std::nullopt;
    if (set && set->is(Type::Kind::power)) free.constructors.push_back({branch.name, set->settled().parts()[0]});
  }
  if (free.constructors.empty())
    samples_.try_emplace(form.name.text(), std::move(free.constants));
  else
    free_.try_emplace(form.name.text(), std::move(free));
}

const std::string* Draw::samples_of(const Term& set) const {
  if (set->kind == Kind::decoration) return samples_of(set->children[0]);
  const auto known = set->kind == Kind::reference ? samples_.find(set->name.text()) : samples_.end();
  return known == samples_.end() || known->second.empty() ? nullptr : &known->first;
}

std::optional<std::vector<Value>> Draw::names_in(const Name& set) const {
  const auto known = samples_.find(set.text());
  const auto is_name = [](const Value& each) { return each.get<Atom>() != nullptr; };
  if (known == samples_.end() || !std::all_of(known->second.begin(), known->second.end(), is_name)) return std::nullopt;
  return known->second;
}

const SchemaText* Draw::text(const Term& schema) const {
  const auto found = schema->kind == Kind::reference ? texts_.find(schema->name.text()) : texts_.end();
  return found == texts_.end() ? nullptr : found->second;
}

Value Draw::number(Chances& chances) const {
  static const std::vector<Value> small = {Real(0), Real(1), Real(2), Real(3), Real(-1), Real(0.5)};
  if (!numbers_) return pick(small, chances);
  const auto [low, high] = *numbers_;
  const auto above = static_cast<std::int64_t>(chances.below(static_cast<std::size_t>(high - low + 1)));
  return Real(static_cast<double>(low + above));
}

Value Draw::of(const Type& type, Chances& chances, unsigned nested) const {
  switch (type.kind()) {
    case Type::Kind::given: {
      const auto known = samples_.find(type.name().text());
      if (known != samples_.end() && !known->second.empty()) return pick(known->second, chances);
      if (type.name().text() == "𝔸") return number(chances);
      if (const auto free = free_.find(type.name().text()); free != free_.end())
        return of_free(free->first, free->second, chances, nested);
      throw EvaluationError("no member of " + type.text() + " is known to try it on");
    }
    case Type::Kind::power:
      return of_set(type.parts()[0], chances, nested);
    case Type::Kind::product: {
      std::vector<Value> parts;
      for (const Type& part : type.parts()) parts.push_back(of(part, chances, nested));
      return Value::tuple(std::move(parts));
    }
    case Type::Kind::schema: {
      std::vector<Value> parts;
      for (const Type& part : type.parts()) parts.push_back(of(part, chances, nested));
      return Value::binding(signature(type.fields()), std::move(parts));
    }
    case Type::Kind::formal:
    case Type::Kind::variable:
    case Type::Kind::unknown:
      throw EvaluationError("values of the type " + type.text() + " are not known");
  }
  throw EvaluationError("values of the type " + type.text() + " are not known");
}

// A constructor is for members of a set that need not be all of its type: of arguments that are none it has no value.
Value Draw::of_free(const std::string& name, const Free& free, Chances& chances, unsigned nested) const {
  constexpr int attempts = 8;
  for (int i = 0; i < attempts && nested > 0; ++i) {
    const std::size_t branch = chances.below(free.constants.size() + free.constructors.size());
    if (branch < free.constants.size()) return free.constants[branch];
    const Constructor& constructor = free.constructors[branch - free.constants.size()];
    const Value made =
        evaluator_.apply(evaluator_.value(constructor.name), of(constructor.argument, chances, nested - 1));
    if (!made.is_undefined()) return made;
  }
  if (free.constants.empty()) throw EvaluationError("no member of " + name + " is found to try it on");
  return pick(free.constants, chances);
}

Value Draw::of_set(const Type& element, Chances& chances, unsigned nested) const {
  std::vector<Value> members;
  for (std::size_t count = chances.below(members_of_a_set + 1); count != 0; --count)
    members.push_back(of(element, chances, nested));
  return Value::set(std::move(members));
}

}  // namespace durero::zed
