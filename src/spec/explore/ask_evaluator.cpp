/// Asks the evaluator what the translated code does not serve, and keeps its answers.
#include "durero/zed/print/print.hpp"
#include "durero/zed/syntax/paragraphs.hpp"
#include "toolkit_operators.hpp"
#include "translator.hpp"

namespace durero::spec {

using zed::Kind;
using zed::Name;
using zed::Term;

TermTranslator::TermTranslator(const Machine::Parts& parts, InternedValues& values, NumberBounds numbers)
    : parts_(parts), values_(values), numbers_(numbers), unfolder_(parts.specification.sections) {
  for (const zed::Section& section : parts.specification.sections)
    for (const zed::Paragraph& paragraph : section.paragraphs) {
      for (const Name& name : zed::names_of(paragraph)) globals_.emplace(name, &paragraph);
      if (const auto* free = std::get_if<zed::FreeType>(&paragraph.form))
        for (const zed::Branch& branch : free->branches) globals_.emplace(branch.name, &paragraph);
    }
}

/// Runs a question of the evaluator; what it cannot decide is undecided.
template <class Question>
static auto asked_of(const Machine::Parts& parts, const Term& term, Question&& question) {
  try {
    parts.begin_question();
    return question();
  } catch (const zed::EvaluationError& error) {
    throw Undecided(zed::to_unicode(term) + ": " + error.what());
  } catch (const zed::StepsSpent&) {
    throw Undecided(zed::to_unicode(term) + ": --steps did not do");
  }
}

ValueId TermTranslator::global(const Name& name) {
  if (const auto at = global_values_.find(name); at != global_values_.end()) return at->second;
  const zed::Value value = asked_of(parts_, zed::reference(name), [&] { return parts_.evaluator->value(name); });
  if (value.is_open()) throw NotInterned("a name is open");
  ValueId id = 0;
  try {
    id = values_.of(value);
  } catch (const std::runtime_error&) {  // it is known by membership, or has more members than are listed
    id = values_.whole(value);
  }
  global_values_.emplace(name, id);
  return id;
}

ValueId TermTranslator::applied(ValueId function, ValueId argument) {
  if (values_.form(function) == InternedForm::set) return applied_pairs(values_, function, argument);
  const auto at = applications_.find({function, argument});
  if (at != applications_.end()) return at->second;
  const ValueId result = asked_of(parts_, zed::node(Kind::truth, {}), [&] {
    return values_.of(parts_.evaluator->apply(values_.value(function), values_.value(argument)));
  });
  applications_.emplace(std::pair(function, argument), result);
  return result;
}

bool TermTranslator::contained(ValueId set, ValueId value) {
  if (values_.form(set) == InternedForm::set) return values_.has(set, value);
  const auto at = memberships_.find({set, value});
  if (at != memberships_.end()) return at->second;
  const zed::Truth truth = asked_of(parts_, zed::node(Kind::truth, {}), [&] {
    return parts_.evaluator->contains(values_.value(set), values_.value(value));
  });
  if (truth == zed::Truth::open) throw Undecided("a membership is open");
  memberships_.emplace(std::pair(set, value), truth == zed::Truth::yes);
  return truth == zed::Truth::yes;
}

void TermTranslator::collect(const Term& term, const FrameScope& scope, std::map<Name, unsigned>& into) {
  const auto add = [&](const Name& name) {
    if (const auto at = scope.find(name)) into.emplace(name, *at);
  };
  if (term->kind == Kind::reference) add(term->name);
  const bool schema = term->kind == Kind::reference || term->kind == Kind::theta || term->kind == Kind::decoration ||
                      term->kind == Kind::renaming;
  if (schema && !(term->kind == Kind::reference && scope.find(term->name)))
    if (const auto text = flat(term->kind == Kind::theta ? term->children[0] : term))
      for (const zed::Declaration& declaration : text->declarations)
        for (const Name& name : declaration.names)
          add({name.word, name.strokes + (term->kind == Kind::theta ? term->name.strokes : "")});
  for (const Term& child : term->children) collect(child, scope, into);
  if (!term->text) return;
  for (const zed::Declaration& declaration : term->text->declarations) collect(declaration.term, scope, into);
  for (const zed::Predicate& predicate : term->text->predicates) collect(predicate.term, scope, into);
}

std::vector<std::pair<Name, unsigned>> TermTranslator::locals_in(const Term& term, const FrameScope& scope) {
  std::map<Name, unsigned> found;
  collect(term, scope, found);
  for (const auto& [name, at] : found) reads_.insert(at);
  return {found.begin(), found.end()};
}

zed::Valuation TermTranslator::valuation(const std::vector<std::pair<Name, unsigned>>& locals, IdFrame frame) const {
  zed::Valuation all;
  for (const auto& [name, at] : locals) all.emplace_back(name, values_.value(frame[at]));
  return all;
}

namespace {

template <class Answer>
using AnswerTable = std::map<std::vector<ValueId>, Answer>;

std::vector<ValueId> ids_of(const std::vector<std::pair<Name, unsigned>>& locals, IdFrame frame) {
  std::vector<ValueId> ids;
  ids.reserve(locals.size());
  for (const auto& [name, at] : locals) ids.push_back(frame[at]);
  return ids;
}

}  // namespace

IdCode TermTranslator::asked_value(const Term& term, const FrameScope& scope) {
  return
      [this, term, locals = locals_in(term, scope), known = std::make_shared<AnswerTable<ValueId>>()](IdFrame frame) {
        std::vector<ValueId> key = ids_of(locals, frame);
        if (const auto at = known->find(key); at != known->end()) return at->second;
        const ValueId id = asked_of(parts_, term, [&] {
          const zed::Value value = parts_.evaluator->value(term, valuation(locals, frame));
          if (value.is_open()) throw Undecided(zed::to_unicode(term) + " is open");
          return locals.empty() && value.set() && !value.set()->members() ? values_.whole(value) : values_.of(value);
        });
        known->emplace(std::move(key), id);
        return id;
      };
}

IdTest TermTranslator::asked_truth(const Term& term, const FrameScope& scope) {
  return [this, term, locals = locals_in(term, scope), known = std::make_shared<AnswerTable<bool>>()](IdFrame frame) {
    std::vector<ValueId> key = ids_of(locals, frame);
    if (const auto at = known->find(key); at != known->end()) return at->second;
    const zed::Truth truth =
        asked_of(parts_, term, [&] { return parts_.evaluator->holds(term, valuation(locals, frame)); });
    if (truth == zed::Truth::open) throw Undecided(zed::to_unicode(term) + " is open");
    known->emplace(std::move(key), truth == zed::Truth::yes);
    return truth == zed::Truth::yes;
  };
}

}  // namespace durero::spec
