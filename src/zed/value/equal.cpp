/// Equality is also how an unknown is found: x = e determines x, and a + t * b = e with b ≠ 0 determines t.

#include "durero/zed/value/undecided.hpp"
#include "zed/value/context.hpp"
#include "zed/value/number_sets.hpp"
#include "zed/value/sets.hpp"
#include "zed/value/settled_functions.hpp"

namespace durero::zed {
namespace {

/// A number is constant + slope · unknown + square · unknown², where slope and square are 0 where it is known.
struct UnknownQuadratic {
  Real constant, slope, square;
  std::uint32_t unknown = Context::none;
};

std::optional<UnknownQuadratic> line(const Value& value) {
  if (const auto* real = value.real()) return UnknownQuadratic{*real, Real(), Real(), Context::none};
  if (const auto* unknown = value.get<Unknown>()) return UnknownQuadratic{Real(), Real(1), Real(), unknown->id};
  if (const auto* polynomial = value.get<PolynomialPtr>())
    return UnknownQuadratic{(*polynomial)->constant, (*polynomial)->slope, (*polynomial)->square,
                            (*polynomial)->unknown};
  return std::nullopt;
}

Value value(UnknownQuadratic line) {
  if (sign(line.slope) == 0 && sign(line.square) == 0) return line.constant;
  return std::make_shared<const Polynomial>(
      Polynomial{std::move(line.constant), std::move(line.slope), std::move(line.square), line.unknown});
}

bool known(const UnknownQuadratic& a) { return a.unknown == Context::none; }

template <class Operation>
Value linear(const Value& a, const Value& b, Operation&& operation) {
  if (a.is_undefined() || b.is_undefined()) return {};
  const auto x = line(a), y = line(b);
  if (!x || !y) {
    if (a.is_open() || b.is_open()) return Open{};
    throw EvaluationError("arithmetic on " + (x ? b : a).text() + ", which is no number");
  }
  return operation(*x, *y);
}

std::uint32_t either(const UnknownQuadratic& a, const UnknownQuadratic& b) { return known(a) ? b.unknown : a.unknown; }
bool mixed(const UnknownQuadratic& a, const UnknownQuadratic& b) {
  return !known(a) && !known(b) && a.unknown != b.unknown;
}

/// Notes that the unknown has this value, where what is evaluated must hold and nothing has said its value before.
Truth determine(std::uint32_t unknown, Value is, Context& context) {
  if (unknown >= context.necessary && !context.values_found[unknown]) context.values_found[unknown] = std::move(is);
  return Truth::open;
}

/// A comparison of a with b is one of a − b with 0.
Truth watched(const UnknownQuadratic& a, const UnknownQuadratic& b, Context& context) {
  if (!context.watch) return Truth::open;
  if (mixed(a, b) || either(a, b) != context.watch->unknown) return lost(context);
  context.watch->compared.push_back(
      {a.constant - b.constant, a.slope - b.slope, a.square - b.square, context.watch->unknown});
  return Truth::open;
}

/// x = a + b·t determines x as a polynomial in the parameter t.
Truth along_parameter(const UnknownQuadratic& a, const UnknownQuadratic& b, Context& context) {
  const bool alone = sign(a.constant) == 0 && a.slope == Real(1) && sign(a.square) == 0;
  if (b.unknown == context.parameter && alone) return determine(a.unknown, value(b), context);
  if (a.unknown == context.parameter && b.unknown != context.parameter) return along_parameter(b, a, context);
  return lost(context);
}

Truth equal_lines(const UnknownQuadratic& a, const UnknownQuadratic& b, Context& context) {
  if (known(a) && known(b)) return truth(a.constant == b.constant);
  // Where both of x = y are unknown, nothing is found out yet, but where one of them is the parameter of all others.
  if (mixed(a, b)) return along_parameter(a, b, context);
  return exactly([&] {
    const Real square = a.square - b.square;
    if (sign(square) != 0) return watched(b, a, context);
    const Real slope = a.slope - b.slope, constant = b.constant - a.constant;
    if (sign(slope) == 0) return truth(sign(constant) == 0);
    watched(b, a, context);
    return determine(either(a, b), constant / slope, context);
  });
}

template <class Parts>
Truth equal_parts(const Parts& a, const Parts& b, Context& context) {
  if (a.size() != b.size()) return Truth::no;
  Truth result = Truth::yes;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const Truth part = equal(a[i], b[i], context);
    if (part == Truth::no) return part;
    if (part == Truth::open) result = part;
  }
  return result;
}

/// Says it of infinite sets whose members are known without being listed; nothing of others.
std::optional<Truth> equal_infinite_sets(const Set& a, const Set& b) {
  const auto *f = settled(a), *g = settled(b);
  if (f && g) return truth(compare_settled(*f, *g) == 0);
  const auto *x = integers_from(a), *y = integers_from(b);
  if (x && y) return truth(*x == *y);
  const bool one_is_finite = a.members() || b.members();
  return one_is_finite && (f || g || x || y) ? std::optional(Truth::no) : std::nullopt;
}

/// Says whether two sets of numbers, one of which cannot be listed, have the same members.
std::optional<Truth> equal_numbers(const Value& a, const Value& b, Context& context) {
  if (a.set()->numbers() == Numbers::none || b.set()->numbers() == Numbers::none) return std::nullopt;
  const auto there = numbers_are_among(a, b, context);
  if (there && *there == Truth::no) return there;
  const auto back = numbers_are_among(b, a, context);
  if (back && *back == Truth::no) return back;
  return there ? back : there;
}

Truth equal_sets(const Value& left_set, const Value& right_set, Context& context) {
  const Set &a = *left_set.set(), &b = *right_set.set();
  if (&a == &b) return Truth::yes;
  if (const auto known = equal_infinite_sets(a, b)) return *known;
  const auto *x = a.members(), *y = b.members();
  if (x && y && x->empty() != y->empty()) return Truth::no;
  if (!x || !y || a.family() || b.family()) {
    if (const auto of_numbers = equal_numbers(left_set, right_set, context)) return *of_numbers;
    const std::string left = a.text(), right = b.text();
    if (left == right)
      throw LackingEvaluation(Lack::members, "whether two sets are equal cannot be decided: the members of neither, " +
                                                 left + ", can be enumerated");
    throw LackingEvaluation(Lack::members, "whether " + left + " = " + right + " cannot be decided: the members of " +
                                               (x && !a.family() ? right : left) + " cannot be enumerated");
  }
  if (x->size() != y->size()) return Truth::no;
  for (std::size_t i = 0; i < x->size(); ++i) {
    if (!same((*x)[i], (*y)[i])) return Truth::no;
  }
  return Truth::yes;
}

}  // namespace

Truth compared(const Value& a, const Value& b, Context& context) {
  const auto x = line(a), y = line(b);
  if (!x || !y) return lost(context);
  try {
    return watched(*x, *y, context);
  } catch (const std::domain_error&) {
    return lost(context);
  }
}

Value sum(const Value& a, const Value& b) {
  const auto *x = a.real(), *y = b.real();
  return exactly([&]() -> Value {
    if (x && y) return *x + *y;
    return linear(a, b, [](const UnknownQuadratic& p, const UnknownQuadratic& q) -> Value {
      if (mixed(p, q)) return Open{};
      return value({p.constant + q.constant, p.slope + q.slope, p.square + q.square, either(p, q)});
    });
  });
}

Value difference(const Value& a, const Value& b) {
  const auto *x = a.real(), *y = b.real();
  return exactly([&]() -> Value {
    if (x && y) return *x - *y;
    return linear(a, b, [](const UnknownQuadratic& p, const UnknownQuadratic& q) -> Value {
      if (mixed(p, q)) return Open{};
      return value({p.constant - q.constant, p.slope - q.slope, p.square - q.square, either(p, q)});
    });
  });
}

Value product(const Value& a, const Value& b) {
  const auto *x = a.real(), *y = b.real();
  return exactly([&]() -> Value {
    if (x && y) return *x * *y;
    return linear(a, b, [](const UnknownQuadratic& p, const UnknownQuadratic& q) -> Value {
      const bool linear = sign(p.square) == 0 && sign(q.square) == 0;
      if (mixed(p, q) || (!known(p) && !known(q) && !linear)) return Open{};
      return value({p.constant * q.constant, p.constant * q.slope + p.slope * q.constant,
                    p.constant * q.square + p.square * q.constant + p.slope * q.slope, either(p, q)});
    });
  });
}

Truth equal(const Value& a, const Value& b, Context& context) {
  if (a.is_undefined() || b.is_undefined()) return Truth::no;
  if (a.is_open() || b.is_open()) return lost(context);
  if (const auto *x = a.real(), *y = b.real(); x && y) return truth(*x == *y);
  if (const auto* x = a.get<Unknown>(); x && !line(b))
    return has_open(b) ? lost(context) : determine(x->id, b, context);
  if (const auto* y = b.get<Unknown>(); y && !line(a))
    return has_open(a) ? lost(context) : determine(y->id, a, context);
  const auto x = line(a), y = line(b);
  if (x && y) return equal_lines(*x, *y, context);
  if (const auto *s = a.tuple(), *t = b.tuple(); s && t) return equal_parts(s->parts, t->parts, context);
  if (const auto *s = a.binding(), *t = b.binding(); s && t && *s->names == *t->names) {
    return s == t ? Truth::yes : equal_parts(s->values, t->values, context);
  }
  if (a.set() && b.set()) return equal_sets(a, b, context);
  if (const auto *s = a.get<ConstructedPtr>(), *t = b.get<ConstructedPtr>(); s && t) {
    if (compare((*s)->constructor, (*t)->constructor) != 0) return Truth::no;
    return equal((*s)->argument, (*t)->argument, context);
  }
  return truth(same(a, b));
}

Truth contains_value(const Value& set, const Value& value, Context& context) {
  if (set.is_undefined() || value.is_undefined()) return Truth::no;
  if (const Set* known_set = set.set()) {
    if (known_set->total()) return may_be_undefined(value) ? lost(context) : Truth::yes;
    if (value.is_open() && !known_set->members()) return lost(context);
    return known_set->contains(value, context);
  }
  if (set.is_open() || set.get<Unknown>()) return lost(context);
  throw EvaluationError(set.text() + " is no set");
}

Value resolved(const Value& value, const Context& context) {
  if (const auto* unknown = value.get<Unknown>()) {
    const auto& known = context.values_found[unknown->id];
    return known ? *known : value;
  }
  if (const auto* polynomial = value.get<PolynomialPtr>()) {
    const auto& known = context.values_found[(*polynomial)->unknown];
    if (!known) return value;
    const Value linear = sum((*polynomial)->constant, product((*polynomial)->slope, *known));
    return sum(linear, product((*polynomial)->square, product(*known, *known)));
  }
  if (!has_open(value)) return value;
  if (const auto* tuple = value.tuple()) {
    std::vector<Value> parts;
    for (const Value& part : tuple->parts) parts.push_back(resolved(part, context));
    return Value::tuple(std::move(parts));
  }
  if (const auto* binding = value.binding()) {
    std::vector<Value> parts;
    for (const Value& part : binding->values) parts.push_back(resolved(part, context));
    return Value::binding(binding->names, std::move(parts));
  }
  if (const auto* constructed = value.get<ConstructedPtr>()) {
    return std::make_shared<const Constructed>(
        Constructed{(*constructed)->constructor, resolved((*constructed)->argument, context)});
  }
  return value;
}

}  // namespace durero::zed
