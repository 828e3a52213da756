#pragma once
/// A context goes through an evaluation: it has the unknowns that are looked for, and whether what is evaluated must
/// hold.

#include <concepts>
#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <type_traits>
#include <vector>

#include "durero/zed/value/steps.hpp"
#include "durero/zed/value/undecided.hpp"
#include "durero/zed/value/value.hpp"

namespace durero::zed {

/// Collects what an evaluation compares with 0 as polynomials in one unknown, for every value of it at once.
struct Watch {
  std::uint32_t unknown = 0;
  Numbers numbers = Numbers::reals;    ///< the unknown is among these
  std::vector<Polynomial> compared{};  ///< the evaluation has compared these with 0
  bool lost = false;                   ///< something depends on the unknown in another way
};

struct Context {
  explicit Context(Steps& counted) : steps(counted) {}

  Steps& steps;
  /// Each unknown has the value that it was found to have, by the unknown's id.
  std::vector<std::optional<Value>> values_found;
  /// Equations that are evaluated now must hold for the unknowns of this id or a greater one, and so determine them.
  std::uint32_t necessary = none;
  int depth = 0;           ///< applications nest so deep
  Watch* watch = nullptr;  ///< it is null but where somebody asks on what a truth depends
  /// Where an equation has this unknown, any other in it is determined as a polynomial in this one.
  std::uint32_t parameter = none;

  static constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

  std::uint32_t fresh() {
    values_found.emplace_back();
    return static_cast<std::uint32_t>(values_found.size() - 1);
  }
};

/// Says for a scope whether what is evaluated must hold. Where `keep` is false it need not, as under ¬, ∨ and ∀.
class Necessary {
 public:
  Necessary(Context& context, bool keep) : context_(context), before_(context.necessary) {
    if (!keep) context_.necessary = Context::none;
  }
  /// The unknowns from this id on are determined by what is evaluated.
  Necessary(Context& context, std::uint32_t from) : context_(context), before_(context.necessary) {
    context_.necessary = from;
  }
  ~Necessary() { context_.necessary = before_; }
  Necessary(const Necessary&) = delete;
  Necessary& operator=(const Necessary&) = delete;

 private:
  Context& context_;
  std::uint32_t before_;
};

/// Says for a scope that a value is computed: what it depends on need not be so, and nothing is found out by it of what
/// is not known.
class Computing : public Necessary {
 public:
  explicit Computing(Context& context) : Necessary(context, false) {}
};

/// Bounds the depth of applications, for definitions that use themselves without end.
class ApplicationDepth {
 public:
  explicit ApplicationDepth(Context& context) : context_(context) {
    if (++context_.depth > limit) {
      --context_.depth;
      throw LackingEvaluation(Lack::end, "applications are nested deeper than " + std::to_string(limit));
    }
  }
  ~ApplicationDepth() { --context_.depth; }
  ApplicationDepth(const ApplicationDepth&) = delete;
  ApplicationDepth& operator=(const ApplicationDepth&) = delete;
  static constexpr int limit = 500;

 private:
  Context& context_;
};

/// A frame has the slots of the local names of one unit of code: a paragraph's predicate, a function's body, a set's.
struct Frame {
  Frame(std::size_t size, Context& c) : slots(size), context(c) {}
  boost::container::small_vector<Value, 8> slots;
  Context& context;
};

/// The code of an expression computes its value, or knows where the value is at hand.
class Code {
 public:
  Code() = default;  ///< it is of no expression
  /// Computes the value each time.
  template <class Compute>
    requires(std::is_invocable_r_v<Value, Compute&, Frame&> && !std::same_as<Compute, Code>)
  Code(Compute compute) : compute_(std::move(compute)) {}  // NOLINT: what computes a value is code

  /// Makes the code of a local name, which has the value in its slot.
  static Code of_slot(unsigned slot) {
    Code code;
    code.slot_ = slot;
    return code;
  }
  /// Makes the code of an expression that has one value: it is computed when it is first asked for, and kept in a place
  /// that outlives the code.
  static Code once(Code compute, Value& place) {
    compute.kept_ = &place;
    return compute;
  }

  /// Returns the value. Precondition: it is of an expression.
  Value operator()(Frame& frame) const {
    if (const Value* value = at_hand(frame)) return *value;
    if (!kept_) return compute_(frame);
    Value value = compute_(frame);
    *kept_ = value;
    return value;
  }
  /// Returns the value where nothing needs to be computed for it, or else null. It stays there while other code of the
  /// scope is run, as that writes only to slots and places of its own.
  const Value* at_hand(const Frame& frame) const {
    if (slot_) return &frame.slots[*slot_];
    return kept_ && !kept_->is_undefined() ? kept_ : nullptr;
  }
  /// Says whether it is of an expression.
  explicit operator bool() const { return slot_ || compute_; }

 private:
  std::function<Value(Frame&)> compute_;
  std::optional<unsigned> slot_;
  Value* kept_ = nullptr;
};

/// A held value is computed, or refers to the value where that is at hand.
class HeldValue {
 public:
  /// Computes the value where it is not at hand. Precondition: the code is of an expression.
  HeldValue(const Code& code, Frame& frame) : value_(code.at_hand(frame)) {
    if (!value_) value_ = &computed_.emplace(Computed{code, frame});
  }
  HeldValue(const HeldValue&) = delete;
  HeldValue& operator=(const HeldValue&) = delete;
  /// Returns the value, as long as this lives.
  const Value& operator*() const { return *value_; }

 private:
  /// Computes a value in its place, so that it is not moved there.
  struct Computed {
    const Code& code;
    Frame& frame;
    operator Value() const { return code(frame); }  // NOLINT: it is a value
  };
  std::optional<Value> computed_;
  const Value* value_;
};

using Test = std::function<Truth(Frame&)>;

/// Returns that the truth is open, where no comparison of numbers says on what it depends.
inline Truth lost(Context& context) {
  if (context.watch) context.watch->lost = true;
  return Truth::open;
}
/// Returns that the truth of a comparison is open, since one of the numbers is not known; the watch learns what was
/// compared.
Truth compared(const Value& a, const Value& b, Context& context);

/// Says whether a = b. Where it must hold and one side is an unknown, the unknown is found.
Truth equal(const Value& a, const Value& b, Context& context);
/// Says whether value ∈ set.
Truth contains_value(const Value& set, const Value& value, Context& context);
/// Returns the value with every unknown that has been found in its place.
Value resolved(const Value& value, const Context& context);

/// Computes a + b, a − b, a * b of numbers, with one unknown in them at most; undefined and open values come out as
/// such.
Value sum(const Value& a, const Value& b);
Value difference(const Value& a, const Value& b);
Value product(const Value& a, const Value& b);

/// Says whether it may be that there is no value: what an application comes to that nobody can tell yet may have none,
/// and then nothing that is made of it has one. An unknown is a value.
bool may_be_undefined(const Value& value);

/// Says whether a number, or a value of another type as a whole, is not known.
inline bool waiting(const Value& a) { return a.is_open() || a.get<Unknown>() || a.get<PolynomialPtr>(); }

/// Returns the steps that an operator may take for what is large in its operand, beyond the one that it is.
inline std::uint64_t steps_for(const Value& operand) {
  if (const Real* real = operand.real()) return 8 * real->words();
  const Set* set = operand.set();
  return set ? set->listed() / 8 : 0;
}

/// Runs an operation on reals. Where its result has no exact form (Real), an EvaluationError says so.
template <class Operation>
auto exactly(Operation&& operation) -> decltype(operation()) {
  try {
    return operation();
  } catch (const std::domain_error& impossible) {
    throw LackingEvaluation(Lack::number, impossible.what());
  }
}

/// Returns the truth of a conjunction.
inline Truth both(Truth a, Truth b) {
  if (a == Truth::no || b == Truth::no) return Truth::no;
  return a == Truth::open ? a : b;
}

inline Truth operator!(Truth t) { return t == Truth::open ? t : truth(t == Truth::no); }

}  // namespace durero::zed
