/// Translates expressions.
#include <algorithm>

#include "search_plan.hpp"
#include "toolkit_operators.hpp"
#include "translator.hpp"

namespace durero::spec {

using zed::Kind;
using zed::Name;
using zed::Node;
using zed::Term;

namespace {

/// The arguments of an operator that stands on its operands; nothing where the application is another.
const Node* operator_name(const Node& application) {
  const Term& function = application.children[0];
  return function->kind == Kind::reference && function->children.empty() ? function.get() : nullptr;
}

}  // namespace

std::optional<unsigned> FrameScope::find(const Name& name) const {
  for (const FrameScope* here = this; here; here = here->outer)
    if (const auto at = here->places.find(name); at != here->places.end()) return at->second;
  return std::nullopt;
}

TermTranslator::Translated<IdCode> TermTranslator::expression_read(const Term& term, const FrameScope& scope) {
  return with_reads([&] { return expression(term, scope); });
}

/// An expression that is not translated, or cannot be computed here, is the evaluator's.
IdCode TermTranslator::expression(const Term& term, const FrameScope& scope) {
  IdCode code;
  try {
    code = translated(term, scope);
  } catch (const std::runtime_error&) {  // it is not served here, or a name in it has no value
    return asked_value(term, scope);
  }
  if (term->kind == Kind::reference || term->kind == Kind::number) return code;
  IdCode asked = asked_value(term, scope);
  return [code = std::move(code), asked = std::move(asked)](IdFrame frame) {
    try {
      return code(frame);
    } catch (const NotInterned&) {
      return asked(frame);
    }
  };
}

IdCode TermTranslator::translated(const Term& term, const FrameScope& scope) {
  const Node& node = *term;
  switch (node.kind) {
    case Kind::reference:
      return reference(node, scope);
    case Kind::number: {
      constexpr std::size_t most_digits = 18;  // so many decimal digits are below 2⁶³ in any case
      if (node.name.word.size() > most_digits) throw NotInterned("a number is not small");
      return [id = values_.number(std::stoll(node.name.word))](IdFrame) { return id; };
    }
    case Kind::set_extension:
      return each_part(node, scope, InternedForm::set);
    case Kind::tuple:
      return each_part(node, scope, InternedForm::tuple);
    case Kind::comprehension:
    case Kind::lambda:
      return comprehension(node, scope);
    case Kind::mu:
      return definite(node, scope);
    case Kind::let:
      return let_value(node, scope);
    case Kind::application:
      return application(term, scope);
    case Kind::binding_extension:
      return binding_of(node, scope);
    case Kind::theta:
      return theta(node, scope);
    case Kind::selection:
    case Kind::tuple_selection:
      return selection(node, scope);
    case Kind::conditional:
      return [test = predicate(node.children[0], scope), yes = expression(node.children[1], scope),
              no = expression(node.children[2], scope)](IdFrame frame) { return test(frame) ? yes(frame) : no(frame); };
    case Kind::product:
    case Kind::power:
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
  throw NotInterned("this notation is the evaluator's");
}

IdCode TermTranslator::reference(const Node& node, const FrameScope& scope) {
  if (const auto place = scope.find(node.name)) {
    reads_.insert(*place);
    return [at = *place](IdFrame frame) { return frame[at]; };
  }
  if (is_global(node.name) && node.children.empty()) return [id = global(node.name)](IdFrame) { return id; };
  if (node.name.word == "∅" && !is_global(node.name))
    return [id = values_.sorted_set(std::span<const ValueId>())](IdFrame) { return id; };
  throw NotInterned("a name is the evaluator's");
}

IdCode TermTranslator::application(const Term& term, const FrameScope& scope) {
  const Term &function = term->children[0], &argument = term->children[1];
  const Node* name = operator_name(*term);
  if (name && !scope.find(name->name) && !is_global(name->name)) {
    const std::string word = name->name.text();
    if (const BinaryOperator compute = binary_operator(word); compute && argument->kind == Kind::tuple)
      return [&values = values_, compute, a = expression(argument->children[0], scope),
              b = expression(argument->children[1], scope)](IdFrame frame) -> ValueId {
        const ValueId left = a(frame), right = b(frame);
        return left == 0 || right == 0 ? 0 : compute(values, left, right);
      };
    if (const UnaryOperator compute = unary_operator(word))
      return [&values = values_, compute, a = expression(argument, scope)](IdFrame frame) -> ValueId {
        const ValueId of = a(frame);
        return of == 0 ? 0 : compute(values, of);
      };
    throw NotInterned(word + " is the evaluator's");
  }
  return [this, f = expression(function, scope), x = expression(argument, scope)](IdFrame frame) -> ValueId {
    const ValueId left = f(frame), right = x(frame);
    return left == 0 || right == 0 ? 0 : applied(left, right);
  };
}

IdCode TermTranslator::each_part(const Node& node, const FrameScope& scope, InternedForm form) {
  std::vector<IdCode> parts;
  for (const Term& child : node.children) parts.push_back(expression(child, scope));
  const bool is_set = form == InternedForm::set;
  return [&values = values_, parts = std::move(parts), is_set](IdFrame frame) {
    ValueList ids;
    for (const IdCode& part : parts) ids.push_back(part(frame));
    return is_set ? values.set(ids) : values.tuple({ids.data(), ids.size()});
  };
}

/// The characteristic tuple of declared names.
IdCode TermTranslator::characteristic(const zed::SchemaText& text, const SoughtNames& sought) {
  for (const zed::Declaration& declaration : text.declarations)
    if (declaration.form == zed::Declaration::Form::included) throw NotInterned("the tuple of an included schema");
  std::vector<unsigned> places;
  for (const auto& [name, place] : sought.names) places.push_back(place);
  if (places.size() == 1) return [at = places[0]](IdFrame frame) { return frame[at]; };
  return [&values = values_, places](IdFrame frame) {
    std::vector<ValueId> parts;
    for (const unsigned at : places) parts.push_back(frame[at]);
    return values.tuple(parts);
  };
}

IdCode TermTranslator::comprehension(const Node& node, const FrameScope& scope) {
  const SoughtNames sought = this->sought(*node.text, scope);
  const auto plan = planned_search(*this, sought);
  IdCode value =
      node.children.empty() ? characteristic(*node.text, sought) : expression(node.children[0], sought.scope);
  if (node.kind == Kind::lambda)
    value = [&values = values_, argument = characteristic(*node.text, sought), value](IdFrame frame) {
      return values.pair(argument(frame), value(frame));
    };
  return [&values = values_, plan, value](IdFrame frame) {
    ValueList members;
    plan->each(frame, [&] {
      members.push_back(value(frame));
      // The evaluator knows which set has an undefined member.
      if (members.back() == 0) throw NotInterned("a member is undefined");
      return true;
    });
    return values.set(members);
  };
}

IdCode TermTranslator::definite(const Node& node, const FrameScope& scope) {
  const SoughtNames sought = this->sought(*node.text, scope);
  const auto plan = planned_search(*this, sought);
  const IdCode value =
      node.children.empty() ? characteristic(*node.text, sought) : expression(node.children[0], sought.scope);
  return [plan, value](IdFrame frame) -> ValueId {
    ValueId only = 0;
    bool several = false, some = false;
    plan->each(frame, [&] {
      const ValueId here = value(frame);
      several = some && here != only;
      some = true;
      only = here;
      return !several;
    });
    return several ? 0 : only;
  };
}

IdCode TermTranslator::let_value(const Node& node, const FrameScope& scope) {
  FrameScope inner{&scope};
  std::vector<std::pair<unsigned, IdCode>> given;
  for (const zed::Declaration& declaration : node.text->declarations) {
    given.emplace_back(place(), expression(declaration.term, scope));
    inner.places[declaration.names.at(0)] = given.back().first;
  }
  return [given, value = expression(node.children[0], inner)](IdFrame frame) {
    for (const auto& [at, code] : given) frame[at] = code(frame);
    return value(frame);
  };
}

IdCode TermTranslator::binding_of(const Node& node, const FrameScope& scope) {
  std::vector<std::pair<Name, IdCode>> parts;
  for (std::size_t i = 0; i < node.names.size(); ++i)
    parts.emplace_back(node.names[i], expression(node.children[i], scope));
  std::sort(parts.begin(), parts.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<Name> names;
  for (const auto& [name, code] : parts) names.push_back(name);
  return [&values = values_, parts, of = values_.signature(names)](IdFrame frame) {
    std::vector<ValueId> ids;
    for (const auto& [name, code] : parts) ids.push_back(code(frame));
    return values.binding(of, ids);
  };
}

IdCode TermTranslator::theta(const Node& node, const FrameScope& scope) {
  const auto text = flat(node.children[0]);
  if (!text) throw NotInterned("θ of a schema that is not written out");
  std::vector<Name> names;
  for (const zed::Declaration& declaration : text->declarations)
    names.insert(names.end(), declaration.names.begin(), declaration.names.end());
  std::sort(names.begin(), names.end());
  std::vector<unsigned> places;
  for (const Name& name : names) {
    const auto at = scope.find({name.word, name.strokes + node.name.strokes});
    if (!at) throw NotInterned("a component is not in scope");
    reads_.insert(*at);
    places.push_back(*at);
  }
  return [&values = values_, places, of = values_.signature(names)](IdFrame frame) {
    std::vector<ValueId> ids;
    for (const unsigned at : places) ids.push_back(frame[at]);
    return values.binding(of, ids);
  };
}

IdCode TermTranslator::selection(const Node& node, const FrameScope& scope) {
  const IdCode of = expression(node.children[0], scope);
  if (node.kind == Kind::tuple_selection)
    return [&values = values_, of, at = std::stoul(node.name.word) - 1](IdFrame frame) -> ValueId {
      const ValueId tuple = of(frame);
      return tuple == 0 ? 0 : values.parts(tuple)[at];
    };
  return [&values = values_, of, name = node.name](IdFrame frame) -> ValueId {
    const ValueId binding = of(frame);
    if (binding == 0) return 0;
    const auto& names = values.names(binding);
    return values.parts(binding)[static_cast<std::size_t>(std::find(names.begin(), names.end(), name) - names.begin())];
  };
}

}  // namespace durero::spec
