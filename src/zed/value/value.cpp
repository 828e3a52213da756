#include "durero/zed/value/value.hpp"

#include <algorithm>

#include "durero/zed/value/undecided.hpp"
#include "zed/value/context.hpp"
#include "zed/value/growing_function.hpp"
#include "zed/value/sets.hpp"
#include "zed/value/settled_functions.hpp"

namespace durero::zed {

Signature signature(std::vector<Name> names) {
  std::sort(names.begin(), names.end());
  return std::make_shared<const std::vector<Name>>(std::move(names));
}

Value Value::atom(std::string type, std::string text, std::uint32_t order) {
  std::uint64_t head = 0;
  for (std::size_t i = 0; i < 8; ++i) head = head << 8 | (i < text.size() ? static_cast<unsigned char>(text[i]) : 0U);
  return std::make_shared<const AtomName>(AtomName{std::move(type), std::move(text), order, head});
}

namespace {

bool has_set(const Value& value) {
  if (value.set()) return true;
  if (const auto* tuple = value.tuple()) return tuple->marks.sets;
  if (const auto* binding = value.binding()) return binding->marks.sets;
  const auto* constructed = value.get<ConstructedPtr>();
  return constructed && has_set((*constructed)->argument);
}

template <class Parts>
PartMarks marks_of(const Parts& parts) {
  PartMarks marks;
  for (const Value& part : parts) {
    marks.open = marks.open || has_open(part);
    marks.sets = marks.sets || has_set(part);
  }
  return marks;
}

}  // namespace

TupleValue::TupleValue(std::span<Value> p)
    : parts(std::make_move_iterator(p.begin()), std::make_move_iterator(p.end())), marks(marks_of(parts)) {}

BindingValue::BindingValue(Signature n, std::span<Value> v)
    : names(std::move(n)),
      values(std::make_move_iterator(v.begin()), std::make_move_iterator(v.end())),
      marks(marks_of(values)) {}

Value Value::tuple(std::vector<Value> parts) {
  for (const Value& part : parts) {
    if (part.is_undefined()) return {};
  }
  return TuplePtr(std::make_shared<const TupleValue>(std::span(parts)));
}

Value Value::pair(Value first, Value second) {
  if (first.is_undefined() || second.is_undefined()) return {};
  Value parts[] = {std::move(first), std::move(second)};
  return TuplePtr(std::make_shared<const TupleValue>(std::span(parts)));
}

Value Value::binding(Signature names, std::vector<Value> values) {
  for (const Value& part : values) {
    if (part.is_undefined()) return {};
  }
  return BindingPtr(std::make_shared<const BindingValue>(std::move(names), std::span(values)));
}

Value Value::point(const Signature& names, Real x, Real y, Real z) {
  Value values[] = {std::move(x), std::move(y), std::move(z)};
  return BindingPtr(std::make_shared<const BindingValue>(names, std::span(values)));
}

Value Value::line(Real constant, Real slope, Unknown unknown) {
  if (sign(slope) == 0) return constant;
  return std::make_shared<const Polynomial>(Polynomial{std::move(constant), std::move(slope), Real(), unknown.id});
}

Value Value::set(std::vector<Value> members) {
  for (const Value& member : members) {
    if (member.is_undefined()) return {};
  }
  if (std::any_of(members.begin(), members.end(), has_open)) return Open{};
  if (!std::is_sorted(members.begin(), members.end(), precedes)) std::sort(members.begin(), members.end(), precedes);
  members.erase(std::unique(members.begin(), members.end(), same), members.end());
  return finite(std::move(members));
}

const TupleValue* Value::tuple() const {
  const auto* shared = get<TuplePtr>();
  return shared ? shared->get() : nullptr;
}

const BindingValue* Value::binding() const {
  const auto* shared = get<BindingPtr>();
  return shared ? shared->get() : nullptr;
}

const Set* Value::set() const {
  const auto* shared = get<SetPtr>();
  return shared ? shared->get() : nullptr;
}

const Value* BindingValue::component(const Name& name) const {
  const auto at = std::lower_bound(names->begin(), names->end(), name);
  if (at == names->end() || *at != name) return nullptr;
  return &values[static_cast<std::size_t>(at - names->begin())];
}

namespace {

template <class Parts>
std::strong_ordering compare_parts(const Parts& a, const Parts& b) {
  if (a.size() != b.size()) return a.size() <=> b.size();
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (const auto order = zed::compare(a[i], b[i]); order != 0) return order;
  }
  return std::strong_ordering::equal;
}

struct Order {
  std::strong_ordering operator()(const Real& a, const Real& b) const { return a <=> b; }
  std::strong_ordering operator()(const Atom& a, const Atom& b) const {
    if (a == b) return std::strong_ordering::equal;
    if (a->order != b->order) return a->order <=> b->order;
    if (a->head != b->head) return a->head <=> b->head;
    if (a->text.size() <= 8 && b->text.size() <= 8) return a->text.size() <=> b->text.size();
    return a->text.compare(b->text) <=> 0;
  }
  std::strong_ordering operator()(const TuplePtr& a, const TuplePtr& b) const {
    return a == b ? std::strong_ordering::equal : compare_parts(a->parts, b->parts);
  }
  std::strong_ordering operator()(const BindingPtr& a, const BindingPtr& b) const {
    if (a == b) return std::strong_ordering::equal;
    if (a->names != b->names && *a->names != *b->names) throw EvaluationError("bindings of two types are compared");
    return compare_parts(a->values, b->values);
  }
  std::strong_ordering operator()(const ConstructedPtr& a, const ConstructedPtr& b) const {
    const auto order = (*this)(a->constructor, b->constructor);
    return order != 0 ? order : zed::compare(a->argument, b->argument);
  }
  std::strong_ordering operator()(const SetPtr& a, const SetPtr& b) const {
    if (a == b) return std::strong_ordering::equal;
    const auto *x = a->members(), *y = b->members();
    if (x && y) return compare_parts(*x, *y);
    if (x || y) return x ? std::strong_ordering::less : std::strong_ordering::greater;
    const auto *f = settled(*a), *g = settled(*b);
    if (f && g) return compare_settled(*f, *g);
    if (f || g) return f ? std::strong_ordering::less : std::strong_ordering::greater;
    // Sets that cannot be listed stand in the order of their words, so that runs agree. With the same words they may
    // yet be two sets, which an answer does not tell apart.
    if (const int by_text = a->text().compare(b->text()); by_text != 0) return by_text <=> 0;
    return std::compare_three_way()(a.get(), b.get());
  }
  std::strong_ordering operator()(const Unknown& a, const Unknown& b) const { return a.id <=> b.id; }
  template <class A, class B>
  std::strong_ordering operator()(const A&, const B&) const {
    return std::strong_ordering::equal;
  }
};

template <class Test>
bool any_part(const Value& value, Test&& test) {
  if (const auto* tuple = value.tuple()) return std::any_of(tuple->parts.begin(), tuple->parts.end(), test);
  if (const auto* binding = value.binding()) return std::any_of(binding->values.begin(), binding->values.end(), test);
  if (const auto* constructed = value.get<ConstructedPtr>()) return test((*constructed)->argument);
  return false;
}

}  // namespace

std::strong_ordering compare(const Value& a, const Value& b) {
  if (const auto *x = a.get<Atom>(), *y = b.get<Atom>(); x && y) return Order()(*x, *y);
  if (const auto *x = a.get<TuplePtr>(), *y = b.get<TuplePtr>(); x && y) return Order()(*x, *y);
  if (a.form().index() != b.form().index()) return a.form().index() <=> b.form().index();
  return std::visit(Order(), a.form(), b.form());
}

bool has_open(const Value& value) {
  if (const auto* tuple = value.tuple()) return tuple->marks.open;
  if (const auto* binding = value.binding()) return binding->marks.open;
  if (const auto* constructed = value.get<ConstructedPtr>()) return has_open((*constructed)->argument);
  return value.is_open() || value.get<Unknown>() || value.get<PolynomialPtr>();
}

bool may_be_undefined(const Value& value) {
  if (value.is_undefined() || value.is_open()) return true;
  return has_open(value) && any_part(value, may_be_undefined);
}

bool has_intensional(const Value& value) {
  if (const Set* set = value.set()) {
    if (set->members()) return set->family();
    const SettledFunction* function = settled(*set);
    return !function || has_intensional(function->range());
  }
  return has_set(value) && any_part(value, has_intensional);
}

bool closed(const Value& value) {
  if (const Set* set = value.set()) return set->closed();
  return !has_open(value) && !(has_set(value) && any_part(value, [](const Value& part) { return !closed(part); }));
}

std::optional<Curve> Set::curve(Context&) const { return std::nullopt; }

Value Set::unknown(Context& context) const { return Unknown{context.fresh()}; }

Value Set::apply(const Value& argument, Context& context) const {
  if (has_open(argument)) return Open{};
  const auto values = partners(argument, 0, context);
  if (!values) throw EvaluationError(text() + " cannot be applied");
  if (values->size() == 1) return values->front();
  if (std::any_of(values->begin(), values->end(), has_intensional))
    throw LackingEvaluation(Lack::members,
                            "whether " + text() + " has one value at " + argument.text() +
                                " cannot be decided: it depends on sets whose members cannot be enumerated");
  return {};
}

std::optional<Value> Set::image(const Value&, Context&) const { return std::nullopt; }

Truth Set::in_domain(const Value& argument, Context& context) const { return has_partner(argument, 0, context); }

std::optional<Real> Set::size() const {
  const auto* listed = family() ? nullptr : members();
  return listed ? std::optional(Real(static_cast<double>(listed->size()))) : std::nullopt;
}

std::vector<Value> Set::some_members(const SmallScope& scope, Context&) const {
  const auto* all = members();
  if (!all) return {};
  return {all->begin(), all->begin() + static_cast<std::ptrdiff_t>(std::min(all->size(), scope.most))};
}

std::optional<Value> Set::members_up_to(std::size_t, Context&) const { return std::nullopt; }

std::vector<FunctionSpace> Set::function_spaces(const SmallScope&, Context&) const { return {}; }

std::optional<std::vector<Value>> Set::partners(const Value& known, std::size_t part, Context& context) const {
  const auto* pairs = members();
  if (!pairs || family() || has_intensional(known)) return std::nullopt;
  context.steps.take(1 + pairs->size() / 8);
  std::vector<Value> others;
  for (const Value& pair : *pairs) {
    const TupleValue* tuple = pair.tuple();
    if (!tuple || tuple->parts.size() != 2) throw EvaluationError(text() + " is no relation");
    if (same(tuple->parts[part], known)) others.push_back(tuple->parts[1 - part]);
  }
  return others;
}

Truth Set::has_partner(const Value& known, std::size_t part, Context& context) const {
  if (has_open(known)) return lost(context);
  const auto others = partners(known, part, context);
  if (!others)
    throw LackingEvaluation(Lack::members,
                            std::string("the ") + (part == 0 ? "domain" : "range") + " of " + text() + " is not known");
  return truth(!others->empty());
}

Truth Set::some_contains(const Value& value, Context& context) const {
  const auto* sets = members();
  if (!sets) throw LackingEvaluation(Lack::members, text() + " cannot be enumerated");
  Truth some = Truth::no;
  const Necessary only(context, sets->size() == 1);
  for (const Value& member : *sets) {
    const Truth in = contains_value(member, value, context);
    if (in == Truth::yes) return in;
    if (in == Truth::open) some = in;
  }
  return some;
}

}  // namespace durero::zed
