#include "zed/evaluate/intensional.hpp"

#include <algorithm>

#include "durero/zed/value/settled_function.hpp"
#include "durero/zed/value/undecided.hpp"
#include "zed/evaluate/describe.hpp"
#include "zed/value/functions.hpp"
#include "zed/value/integer_lines.hpp"
#include "zed/value/sets.hpp"

namespace durero::zed {
namespace {

/// Returns the other parts of all pairs that a head makes whose part `part` is this value, each once. Nothing where
/// they cannot be listed.
std::optional<std::vector<Value>> other_parts(Frame& frame, const std::function<Value(Frame&)>& pair,
                                              const Value& known, std::size_t part, const CompiledSchemaText& head,
                                              Context& context) {
  std::vector<Value> others;
  const Necessary no(context, false);
  const Truth some = head.search->each(
      frame,
      [&](Frame& inside) {
        others.push_back(pair(inside).tuple()->parts[1 - part]);
        return true;
      },
      [&](Frame& inside) {
        const Value here = pair(inside);
        if (!here.tuple()) return here.is_undefined() ? Truth::no : lost(context);
        return equal(here.tuple()->parts[part], known, context);
      });
  const Value all = some == Truth::open ? Value(Open{}) : Value::set(std::move(others));
  const bool listed = all.set() && (!all.set()->family() || all.set()->members()->size() <= 1);
  return listed ? std::optional(*all.set()->members()) : std::nullopt;
}

/// Returns the line of the values of a term, where the only variable of the closure is declared from whole numbers and
/// nothing else is said of it. `value` gives the second part of a pair whose first part is the variable.
std::optional<IntegerLine> line_of(const Closure& closure, Context& context,
                                   const std::function<Value(Frame&)>& value) {
  const Solver& search = *closure.head.search;
  const auto& variables = search.variables();
  const bool is_plain = closure.closed() && closure.head.groups.size() == 1 && !closure.head.groups[0].names &&
                        variables.size() == 1 && variables[0].set && !variables[0].value && search.goal().parts.empty();
  if (!is_plain || search.goal().kind != Property::Kind::all) return std::nullopt;
  const ApplicationDepth deeper(context);
  const Computing nothing_is_found(context);
  Frame frame = closure.frame(context);
  const Value set = variables[0].set(frame);
  const auto* least = set.set() ? integers_from(*set.set()) : nullptr;
  if (!least) return std::nullopt;
  const Unknown number{context.fresh()};
  frame.slots[variables[0].slot] = number;
  return line_through(value(frame), number, *least);
}

class Comprehension : public Set, public LineSource {
 public:
  Comprehension(Closure closure, Steps& steps) : closure_(std::move(closure)), steps_(steps) {}

  // The pairs (x, e) are a function of x.
  std::optional<IntegerLine> line(Context& context) const override {
    if (!closure_.term) return std::nullopt;
    return line_of(closure_, context, [this](Frame& inside) -> Value {
      const Value here = closure_.term(inside);
      if (!here.tuple() || here.tuple()->parts.size() != 2) return {};
      const auto* first = here.tuple()->parts[0].get<Unknown>();
      const auto* variable = inside.slots[closure_.head.search->variables()[0].slot].get<Unknown>();
      return first && variable && first->id == variable->id ? here.tuple()->parts[1] : Value();
    });
  }

  Truth contains(const Value& value, Context& context) const override {
    const ApplicationDepth deeper(context);
    Frame frame = closure_.frame(context);
    if (!closure_.term) {
      if (value.get<Unknown>() && closure_.head.groups.size() + closure_.head.groups[0].components.size() > 1)
        return lost(context);
      assign(frame, closure_.head.groups, value);
      return closure_.head.search->holds(frame);
    }
    return closure_.head.search->exists(frame,
                                        [&](Frame& inside) { return equal(closure_.term(inside), value, context); });
  }

  // value ∈ ⋃ { D | P • E } is ∃ D | P • value ∈ E.
  Truth some_contains(const Value& value, Context& context) const override {
    const ApplicationDepth deeper(context);
    Frame frame = closure_.frame(context);
    return closure_.head.search->exists(frame, [&](Frame& inside) {
      return contains_value(closure_.term ? closure_.term(inside) : characteristic(inside, closure_.head.groups), value,
                            context);
    });
  }

  Value unknown(Context& context) const override {
    if (closure_.term) return Set::unknown(context);
    Frame frame = closure_.frame(context);
    return unknown_characteristic(frame, closure_.head);
  }

  bool declares_sequences() const override {
    const Value set = declared_from();
    return set.set() && set.set()->declares_sequences();
  }
  Value as_declared(const Value& member) const override {
    const Value set = declared_from();
    return set.set() ? set.set()->as_declared(member) : member;
  }

  bool total() const override {
    if (!total_) {
      Context context(steps_);
      Frame frame = closure_.frame(context);
      total_ = !closure_.term && closed() && closure_.head.search->total(frame);
    }
    return *total_;
  }

  Numbers numbers() const override {
    if (!numbers_) {
      Context context(steps_);
      Frame frame = closure_.frame(context);
      const bool one = !closure_.term && closure_.head.groups.size() == 1 && !closure_.head.groups[0].names;
      numbers_ = one ? closure_.head.search->numbers(frame) : Numbers::none;
    }
    return *numbers_;
  }

  std::vector<Value> some_members(const SmallScope& scope, Context& context) const override {
    if (members()) return Set::some_members(scope, context);
    const Value set = declared_from();
    std::vector<Value> some = set.set() ? set.set()->some_members(scope, context) : std::vector<Value>();
    std::erase_if(some, [&](const Value& each) { return contains(each, context) != Truth::yes; });
    return some;
  }

  std::optional<std::vector<Value>> partners(const Value& known, std::size_t part, Context& context) const override {
    const ApplicationDepth deeper(context);
    Frame frame = closure_.frame(context);
    return other_parts(
        frame, [&](Frame& inside) { return pair(inside); }, known, part, closure_.head, context);
  }

  Truth has_partner(const Value& known, std::size_t part, Context& context) const override {
    const ApplicationDepth deeper(context);
    Frame frame = closure_.frame(context);
    return closure_.head.search->exists(frame, [&](Frame& inside) {
      const Value here = pair(inside);
      if (!here.tuple()) return here.is_undefined() ? Truth::no : lost(context);
      return equal(here.tuple()->parts[part], known, context);
    });
  }

  bool closed() const override { return closure_.closed(); }
  std::size_t listed() const override { return members_ ? members_->set()->listed() : 0; }

  // The set is finite where its predicate bounds numbers, even if the sets of its declarations are not.
  const std::vector<Value>* members() const override {
    if (!listed_) {
      listed_ = true;
      if (closed()) list();
    }
    return members_ ? members_->set()->members() : nullptr;
  }

  std::optional<Curve> curve(Context& context) const override;

  std::string spelled(Wording wording) const override { return closure_.spelled(wording); }

 private:
  void list() const;
  /// The set from which the only variable is declared, where the members are its values.
  Value declared_from() const {
    const auto& variables = closure_.head.search->variables();
    if (closure_.term || variables.size() != 1 || closure_.head.groups[0].names || !variables[0].set) return {};
    Context context(steps_);
    Frame frame = closure_.frame(context);
    return variables[0].set(frame);
  }
  Value pair(Frame& inside) const {
    return closure_.term ? closure_.term(inside) : characteristic(inside, closure_.head.groups);
  }

  Closure closure_;
  Steps& steps_;
  mutable std::optional<bool> total_;
  mutable std::optional<Numbers> numbers_;
  mutable bool listed_ = false;
  mutable std::optional<Value> members_;
};

void Comprehension::list() const {
  Context context(steps_);
  Frame frame = closure_.frame(context);
  if (!closure_.head.search->may_be_listed(frame)) return;
  try {
    std::vector<Value> values;
    const Truth some = closure_.head.search->each(frame, [&](Frame& inside) {
      values.push_back(closure_.term ? closure_.term(inside) : characteristic(inside, closure_.head.groups));
      return true;
    });
    Value set = some == Truth::open ? Value() : Value::set(std::move(values));
    if (set.set()) members_ = std::move(set);
  } catch (const EvaluationError&) {  // the set stays intensional
  }
}

/// Returns the curve of a set { t : T | P • S } where T is of reals and equations in S determine each part of its
/// member by t.
std::optional<Curve> Comprehension::curve(Context& context) const {
  const Solver& search = *closure_.head.search;
  Frame frame = closure_.frame(context);
  if (!closure_.term || search.variables().size() != 1 || search.numbers(frame) != Numbers::reals) return std::nullopt;
  const Unknown t{context.fresh()};
  const Code& term = closure_.term;
  const unsigned slot = search.variables()[0].slot;
  frame.slots[slot] = t;
  const Value at_t = term(frame);
  if (!at_t.set()) return std::nullopt;
  const Value member = at_t.set()->unknown(context);
  const Necessary must(context, t.id + 1);
  context.parameter = t.id;
  const Truth some = contains_value(at_t, member, context);
  context.parameter = Context::none;
  if (some == Truth::no) return std::nullopt;
  const auto admits = [this, slot](const Value& number, const Value& point, Context& inside) {
    Frame here = closure_.frame(inside);
    here.slots[slot] = number;
    const Truth in_head = closure_.head.search->holds(here);
    return in_head == Truth::no ? in_head : both(in_head, contains_value(closure_.term(here), point, inside));
  };
  return Curve{t, resolved(member, context), admits};
}

/// Returns the value at an argument that the head admits; undefined at others.
Value applied(const Closure& closure, const Value& argument, Context& context, Truth* admitted) {
  Frame frame = closure.frame(context);
  assign(frame, closure.head.groups, argument);
  *admitted = closure.head.search->holds(frame);
  if (*admitted == Truth::no) return {};
  if (*admitted == Truth::open) return Open{};
  return closure.term ? closure.term(frame) : characteristic(frame, closure.head.groups);
}

Truth admits(const Closure& closure, const Value& argument, Context& context) {
  Frame frame = closure.frame(context);
  assign(frame, closure.head.groups, argument);
  return closure.head.search->holds(frame);
}

bool whole_unknown(const Value& argument, const std::vector<TupleComponent>& groups) {
  return (argument.is_open() || argument.get<Unknown>()) && (groups.size() > 1 || groups[0].names);
}

class Lambda : public Set, public LineSource {
 public:
  Lambda(Closure closure, Steps& steps) : closure_(std::move(closure)), steps_(steps) {}

  std::optional<IntegerLine> line(Context& context) const override { return line_of(closure_, context, closure_.term); }

  Value apply(const Value& argument, Context& context) const override {
    if (whole_unknown(argument, closure_.head.groups)) return Open{};
    const ApplicationDepth deeper(context);
    const Computing value_of_f(context);
    Truth admitted = Truth::no;
    return applied(closure_, argument, context, &admitted);
  }

  Truth in_domain(const Value& argument, Context& context) const override {
    if (whole_unknown(argument, closure_.head.groups)) return lost(context);
    return admits(closure_, argument, context);
  }

  Truth contains(const Value& pair, Context& context) const override {
    if (!pair.tuple()) return lost(context);
    return equal(apply(pair.tuple()->parts[0], context), pair.tuple()->parts[1], context);
  }

  std::optional<std::vector<Value>> partners(const Value& known, std::size_t part, Context& context) const override {
    if (part == 0) return value_at(*this, known, context);
    const ApplicationDepth deeper(context);
    Frame frame = closure_.frame(context);
    return other_parts(
        frame, [&](Frame& inside) { return maplet(inside); }, known, part, closure_.head, context);
  }
  Truth has_partner(const Value& known, std::size_t part, Context& context) const override {
    if (part == 0) return in_domain(known, context);
    const ApplicationDepth deeper(context);
    Frame frame = closure_.frame(context);
    return closure_.head.search->exists(frame,
                                        [&](Frame& inside) { return equal(closure_.term(inside), known, context); });
  }

  std::size_t listed() const override { return pairs_ ? pairs_->set()->listed() : 0; }

  // Over finite sets a λ is a finite function.
  const std::vector<Value>* members() const override {
    if (!enumerated_) {
      enumerated_ = true;
      if (closed()) list();
    }
    return pairs_ ? pairs_->set()->members() : nullptr;
  }

  bool closed() const override { return closure_.closed(); }
  std::string spelled(Wording wording) const override { return closure_.spelled(wording); }

 private:
  Value maplet(Frame& inside) const {
    return Value::pair(characteristic(inside, closure_.head.groups), closure_.term(inside));
  }
  void list() const {
    Context context(steps_);
    Frame frame = closure_.frame(context);
    if (!closure_.head.search->enumerable(frame)) return;
    std::vector<Value> pairs;
    const Truth some = closure_.head.search->each(frame, [&](Frame& inside) {
      pairs.push_back(maplet(inside));
      return true;
    });
    Value function = Value::set(std::move(pairs));
    if (some != Truth::open && function.set()) pairs_ = std::move(function);
  }

  Closure closure_;
  Steps& steps_;
  mutable bool enumerated_ = false;
  mutable std::optional<Value> pairs_;
};

class AxiomaticFunction : public Set {
 public:
  AxiomaticFunction(std::string name, std::function<Clauses(Context&)> compile)
      : name_(std::move(name)), compile_(std::move(compile)) {}

  // The choice of the clause for the argument is a question, and states no fact.
  Value apply(const Value& argument, Context& context) const override {
    const ApplicationDepth deeper(context);
    const Computing value_of_f(context);
    for (const Closure& clause : clauses(context).clauses) {
      if (whole_unknown(argument, clause.head.groups)) return Open{};
      Truth admitted = Truth::no;
      Value value = applied(clause, argument, context, &admitted);
      if (admitted != Truth::no) return value;
    }
    refuse_unsaid(argument, context);
    return {};
  }

  Truth in_domain(const Value& argument, Context& context) const override {
    const Clauses& known = clauses(context);
    if (known.domain) return contains_value(*known.domain, argument, context);
    const Necessary one_of_several(context, false);
    for (const Closure& clause : known.clauses) {
      if (whole_unknown(argument, clause.head.groups)) return lost(context);
      const Truth here = admits(clause, argument, context);
      if (here != Truth::no) return here;
    }
    return known.source ? contains_value(*known.source, argument, context) : Truth::no;
  }

  Truth contains(const Value& pair, Context& context) const override {
    if (!pair.tuple()) return lost(context);
    return equal(apply(pair.tuple()->parts[0], context), pair.tuple()->parts[1], context);
  }

  std::optional<std::vector<Value>> partners(const Value& known, std::size_t part, Context& context) const override {
    return part == 0 ? value_at(*this, known, context) : std::nullopt;
  }

  std::string spelled(Wording) const override { return name_; }

 private:
  const Clauses& clauses(Context& context) const {
    if (!clauses_) clauses_ = compile_(context);
    return *clauses_;
  }

  // Throws EvaluationError where no clause gives a value but there may still be one: for a total function, and where
  // the box states more.
  void refuse_unsaid(const Value& argument, Context& context) const {
    const Clauses& known = clauses(context);
    const bool outside = known.source ? contains_value(*known.source, argument, context) == Truth::no : known.all_said;
    if (!outside)
      throw LackingEvaluation(Lack::equation, "no equation gives " + name_ + " a value at " + argument.text());
  }
  std::string name_;
  std::function<Clauses(Context&)> compile_;
  mutable std::optional<Clauses> clauses_;
};

/// The least member of ℕ or ℕ₁, where the λ is over that set alone and nothing restricts it.
std::optional<int> all_naturals_from(const Node& lambda) {
  const SchemaText& text = *lambda.text;
  if (text.declarations.size() != 1 || !text.predicates.empty()) return std::nullopt;
  const Declaration& declared = text.declarations[0];
  if (declared.form != Declaration::Form::typed || declared.names.size() != 1) return std::nullopt;
  if (declared.term->kind != Kind::reference) return std::nullopt;
  const std::string set = declared.term->name.text();
  if (set == "ℕ") return 0;
  return set == "ℕ₁" ? std::optional(1) : std::nullopt;
}

/// The λ as a settled function, where its value depends on nothing that is not known.
std::optional<Value> settled_lambda(const Closure& closure, Steps& steps) {
  const auto least = all_naturals_from(*closure.written);
  if (!least) return std::nullopt;
  Context context(steps);
  Frame frame = closure.frame(context);
  frame.slots[closure.head.groups[0].slot] = Open{};
  try {
    Value value = closure.term(frame);
    const bool known = !value.is_undefined() && !has_open(value) && closed(value) && !has_intensional(value);
    return known ? std::optional(settled_function(*least, {}, std::move(value))) : std::nullopt;
  } catch (const EvaluationError&) {
    return std::nullopt;
  }
}

/// A set by clauses of a function that is 1 at its members, and 0 elsewhere.
class AxiomaticSet : public Set {
 public:
  AxiomaticSet(std::string name, std::function<Clauses(Context&)> compile)
      : truth_of_(std::move(name), [compile = std::move(compile)](Context& context) {
          Clauses clauses = compile(context);
          clauses.all_said = false;  // a value without a clause may be a member
          return clauses;
        }) {}

  Truth contains(const Value& value, Context& context) const override {
    const Value one = truth_of_.apply(value, context);
    return one.real() ? truth(sign(*one.real()) != 0) : lost(context);
  }
  std::string spelled(Wording wording) const override { return truth_of_.spelled(wording); }

 private:
  AxiomaticFunction truth_of_;
};

}  // namespace

Frame Closure::frame(Context& context) const {
  context.steps.take();
  Frame frame(unit->size, context);
  std::copy(captured.begin(), captured.end(), frame.slots.begin());
  return frame;
}

bool Closure::closed() const {
  return std::all_of(free.begin(), free.end(), [this](const auto& each) { return zed::closed(captured[each.second]); });
}

std::string Closure::spelled(Set::Wording wording) const {
  std::string text = describe(*written);
  if (wording == Set::Wording::message || free.empty()) return text;
  std::string values;
  for (const auto& [name, slot] : free) values += (values.empty() ? "" : "; ") + name + " == " + captured[slot].text();
  return "(let " + values + " • " + text + ")";
}

std::vector<Value> captured(const Frame& frame, unsigned count) {
  return {frame.slots.begin(), frame.slots.begin() + static_cast<std::ptrdiff_t>(count)};
}

Value intensional_set(Closure closure, Steps& steps) {
  return SetPtr(std::make_shared<const Comprehension>(std::move(closure), steps));
}

Value lambda_function(Closure closure, Steps& steps) {
  if (auto settled = settled_lambda(closure, steps)) return *std::move(settled);
  return SetPtr(std::make_shared<const Lambda>(std::move(closure), steps));
}

Value axiomatic_function(std::string name, std::function<Clauses(Context&)> compile) {
  return SetPtr(std::make_shared<const AxiomaticFunction>(std::move(name), std::move(compile)));
}

Value axiomatic_set(std::string name, std::function<Clauses(Context&)> compile) {
  return SetPtr(std::make_shared<const AxiomaticSet>(std::move(name), std::move(compile)));
}

}  // namespace durero::zed
