#include "zed/value/integer_lines.hpp"

#include <utility>

#include "zed/value/sets.hpp"
#include "zed/value/settled_functions.hpp"

namespace durero::zed {
namespace {

using Known = std::optional<Truth>;

std::string line_domain_text(std::optional<int> least) {
  if (!least) return "ℤ";
  if (*least == 0) return "ℕ";
  if (*least == 1) return "ℕ₁";
  return "{n : ℤ | n ≥ " + std::to_string(*least) + "}";
}

/// A line as a function.
class LineFunction : public Set, public LineSource {
 public:
  explicit LineFunction(IntegerLine line) : line_(std::move(line)) {}

  std::optional<IntegerLine> line(Context&) const override { return line_; }
  Value apply(const Value& argument, Context&) const override {
    if (argument.is_undefined()) return {};
    const Real* number = argument.real();
    if (!number) return Open{};
    if (!has(*number)) return {};
    return line_.slope * *number + line_.constant;
  }
  Truth in_domain(const Value& argument, Context& context) const override {
    return argument.real() ? truth(has(*argument.real())) : lost(context);
  }
  Truth contains(const Value& pair, Context& context) const override {
    if (!pair.tuple()) return lost(context);
    return equal(apply(pair.tuple()->parts[0], context), pair.tuple()->parts[1], context);
  }
  std::optional<std::vector<Value>> partners(const Value& known, std::size_t part, Context& context) const override {
    if (part != 0 || !known.real()) return Set::partners(known, part, context);
    const Value value = apply(known, context);
    return value.is_undefined() ? std::vector<Value>() : std::vector<Value>{value};
  }
  std::string spelled(Wording) const override {
    const std::string product = line_.slope == Real(1) ? "n" : line_.slope.text() + " * n";
    const std::string sum = sign(line_.constant) == 0  ? product
                            : sign(line_.constant) < 0 ? product + " - " + (-line_.constant).text()
                                                       : product + " + " + line_.constant.text();
    return "(λ n : " + line_domain_text(line_.least) + " • " + sum + ")";
  }

 private:
  bool has(const Real& number) const { return number.is_integer() && (!line_.least || number >= Real(*line_.least)); }
  IntegerLine line_;
};

Known both_known(const Known& a, const Known& b) {
  if (a == Truth::no || b == Truth::no) return Truth::no;
  return a && b ? Known(both(*a, *b)) : std::nullopt;
}

/// Whether each number with a value is in the set. A set that is listed has too few members.
Known domain_is_among(const IntegerLine& line, const Value& from) {
  if (from.set()->total()) return Truth::yes;
  if (const auto* least = integers_from(*from.set())) return truth(!*least || (line.least && *line.least >= **least));
  return from.set()->members() ? Known(Truth::no) : std::nullopt;
}

/// Whether each member of the set has a value. A type of numbers has members that are not whole.
Known is_defined_on(const IntegerLine& line, const Value& from) {
  if (from.set()->total()) return Truth::no;
  if (const auto* least = integers_from(*from.set())) return truth(!line.least || (*least && *line.least <= **least));
  return std::nullopt;
}

/// Whether each value is in the set.
Known range_is_among(const IntegerLine& line, const Value& to, Context& context) {
  if (to.set()->total()) return Truth::yes;
  if (sign(line.slope) == 0) {
    const Truth here = contains_value(to, line.constant, context);
    return here == Truth::open ? std::nullopt : Known(here);
  }
  if (to.set()->members()) return Truth::no;
  const auto* least = integers_from(*to.set());
  if (!least) return std::nullopt;
  if (!*least) return Truth::yes;
  if (sign(line.slope) < 0 || !line.least) return Truth::no;  // its values have no least one
  return truth(line.slope * Real(*line.least) + line.constant >= Real(**least));
}

/// Whether each member of the set is a value; of the set it is known that each value is a member of it.
Known is_onto(const IntegerLine& line, const Value& to) {
  if (const auto* members = to.set()->members(); members && !to.set()->family())
    return sign(line.slope) == 0 ? Known(truth(members->size() == 1)) : std::nullopt;
  const auto* least = integers_from(*to.set());
  if (!least) return to.set()->total() ? Known(Truth::no) : std::nullopt;
  if (!line.least) return truth(!*least && (line.slope == Real(1) || line.slope == Real(-1)));
  return truth(*least && line.slope == Real(1) && Real(*line.least) + line.constant == Real(**least));
}

}  // namespace

std::optional<IntegerLine> integer_line(const Value& value, Context& context) {
  if (const SettledFunction* constant = settled(value)) {
    const Real* rest = constant->rest().real();
    if (!rest || !rest->is_integer() || !constant->pairs().empty()) return std::nullopt;
    return IntegerLine{constant->least(), Real(), *rest};
  }
  const auto* source = dynamic_cast<const LineSource*>(value.set());
  return source ? source->line(context) : std::nullopt;
}

std::optional<IntegerLine> line_through(const Value& at_unknown, Unknown unknown, std::optional<int> least) {
  IntegerLine line{least, Real(), Real()};
  if (const Real* constant = at_unknown.real()) {
    line.constant = *constant;
  } else if (const auto* same_number = at_unknown.get<Unknown>()) {
    if (same_number->id != unknown.id) return std::nullopt;
    line.slope = Real(1);
  } else if (const auto* shared = at_unknown.get<PolynomialPtr>()) {
    const Polynomial& polynomial = **shared;
    if (polynomial.unknown != unknown.id || sign(polynomial.square) != 0) return std::nullopt;
    line.slope = polynomial.slope;
    line.constant = polynomial.constant;
  } else {
    return std::nullopt;
  }
  return line.slope.is_integer() && line.constant.is_integer() ? std::optional(line) : std::nullopt;
}

std::optional<Truth> line_is_in(const IntegerLine& line, const Value& from, const Value& to, const Arrow& arrow,
                                Context& context) {
  if (arrow.finite || (arrow.injective && sign(line.slope) == 0)) return Truth::no;
  Known inside = both_known(domain_is_among(line, from), range_is_among(line, to, context));
  if (arrow.total) inside = both_known(inside, is_defined_on(line, from));
  if (arrow.surjective && inside == Truth::yes) inside = is_onto(line, to);
  return inside;
}

Value line_function(const IntegerLine& line) { return SetPtr(std::make_shared<const LineFunction>(line)); }

std::vector<IntegerLine> small_lines(std::optional<int> least) {
  std::vector<IntegerLine> lines;
  for (const auto& [slope, constant] : std::initializer_list<std::pair<int, int>>{
           {1, 0}, {1, 1}, {1, -1}, {2, 0}, {1, 2}, {-1, 0}, {2, 1}, {1, 3}, {3, 0}, {-1, 1}})
    lines.push_back({least, Real(slope), Real(constant)});
  return lines;
}

}  // namespace durero::zed
