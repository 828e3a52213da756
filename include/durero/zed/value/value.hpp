#pragma once
/// The evaluator computes with the values of Z: exact reals, names of given sets and of free types, tuples, bindings
/// and sets. A function is its set of pairs.
///
/// A set is *finite*, its members at hand and sorted, or *intensional*: it answers whether a value is a member, and to
/// enumerate it is an error that says so. Values are immutable and share their parts, so copying is cheap.

#include <atomic>
#include <boost/container/small_vector.hpp>
#include <compare>
#include <cstdint>
#include <functional>
#include <iterator>
#include <memory>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <variant>
#include <vector>

#include "durero/zed/syntax/ast.hpp"
#include "durero/zed/types/types.hpp"
#include "durero/zed/value/real.hpp"

namespace durero::zed {

/// The error of an evaluation that cannot or must not go on; it names the term in Z notation.
class EvaluationError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The error of a finite set with more members than are ever listed, whatever steps and memory there are.
class TooManyMembers : public EvaluationError {
 public:
  /// The set, as a message names it.
  explicit TooManyMembers(const std::string& set) : EvaluationError(set + " has more members than can be listed") {}
};

/// The error of a constant that nothing in the text gives a value.
class Undetermined : public EvaluationError {
 public:
  /// The constant, as it is written.
  explicit Undetermined(std::string constant)
      : EvaluationError("no equation gives " + constant + " a value"), constant_(std::move(constant)) {}
  /// Its name.
  const std::string& constant() const { return constant_; }

 private:
  std::string constant_;
};

/// The error of constants for which the facts of the text cannot all be true.
class Unsatisfied : public EvaluationError {
 public:
  using EvaluationError::EvaluationError;
};

/// The truth of a predicate is `open` where it depends on a value that is not given.
enum class Truth : std::uint8_t { no, yes, open };

/// Returns the truth of a decided predicate: yes or no, never open.
constexpr Truth truth(bool value) { return value ? Truth::yes : Truth::no; }

class Value;
class Set;
struct Polynomial;
struct TupleValue;
struct BindingValue;
struct Constructed;

/// An expression that has no value is undefined: an application of a function outside its domain, and any expression
/// with an undefined part. The predicate that it stands in directly is false.
struct Undefined {};
/// A value is open where it depends on a value that is not given.
struct Open {};
/// An unknown is a variable whose value is looked for.
struct Unknown {
  std::uint32_t id;  ///< it counts the unknowns of a context, from 0
};

/// A member of a given set, or a constant of a free type, is known by its type and its name. `order` is the place among
/// the constants of a free type, and 0 in a given set, whose members are in the order of their names.
struct AtomName {
  std::string type, text;   ///< the name of its type, and its own
  std::uint32_t order = 0;  ///< compare() asks for it first
  std::uint64_t head = 0;   ///< it is the first eight bytes of the text, as a number in the order of texts
};
/// A value shares its name with its copies.
using Atom = std::shared_ptr<const AtomName>;

/// @{ A value shares its parts with its copies, and nobody changes them.
using TuplePtr = std::shared_ptr<const TupleValue>;
using BindingPtr = std::shared_ptr<const BindingValue>;
using ConstructedPtr = std::shared_ptr<const Constructed>;
using SetPtr = std::shared_ptr<const Set>;
using PolynomialPtr = std::shared_ptr<const Polynomial>;
/// @}

/// A signature has the names of a binding's components, sorted.
using Signature = std::shared_ptr<const std::vector<Name>>;
/// Makes a signature: sorts the names.
Signature signature(std::vector<Name> names);

/// A value of Z, or a mark in its place: undefined, open or unknown.
class Value {
 public:
  /// The forms of a value; a number that depends on an unknown is a polynomial.
  using Form =
      std::variant<Undefined, Open, Unknown, PolynomialPtr, Real, Atom, TuplePtr, BindingPtr, ConstructedPtr, SetPtr>;
  Value() = default;  ///< it is undefined
  /// @{ Makes a value of this form. Precondition: no pointer is null.
  Value(Open) : form_(Open{}) {}
  Value(Unknown unknown) : form_(unknown) {}
  Value(Real real) : form_(std::move(real)) {}
  Value(Atom atom) : form_(std::move(atom)) {}
  Value(PolynomialPtr polynomial) : form_(std::move(polynomial)) {}
  Value(TuplePtr tuple) : form_(std::move(tuple)) {}
  Value(BindingPtr binding) : form_(std::move(binding)) {}
  Value(ConstructedPtr constructed) : form_(std::move(constructed)) {}
  Value(SetPtr set) : form_(std::move(set)) {}
  /// @}

  /// Makes a member of a given set, or a constant of a free type, where it has this place in the order.
  static Value atom(std::string type, std::string text, std::uint32_t order = 0);
  /// @{ Makes a tuple of the parts in this order. It is undefined where one of them is.
  static Value tuple(std::vector<Value> parts);
  static Value pair(Value first, Value second);
  /// @}
  /// Makes a binding. The names are sorted, and the values stand in their order.
  static Value binding(Signature names, std::vector<Value> values);
  static Value point(const Signature& names, Real x, Real y, Real z);  ///< it has three components
  /// Makes the number constant + slope · unknown.
  static Value line(Real constant, Real slope, Unknown unknown);
  /// Makes a finite set: sorts the members and drops repetitions. A set of open values is open, and one of undefined
  /// values undefined.
  static Value set(std::vector<Value> members);

  /// Returns the value as a variant, for std::visit.
  const Form& form() const { return form_; }
  /// Says whether the expression has no value.
  bool is_undefined() const { return form_.index() == 0; }
  /// Says whether it is open as a whole; has_open() asks for its parts too.
  bool is_open() const { return form_.index() == 1; }
  /// Returns the value as one of this form, or null where it has another.
  template <class T>
  const T* get() const {
    return std::get_if<T>(&form_);
  }
  /// @{ Returns the contents of the value, or null where it has another form; valid as long as the value.
  const Real* real() const { return get<Real>(); }
  const TupleValue* tuple() const;
  const BindingValue* binding() const;
  const Set* set() const;
  /// @}

  /// A spelling says how a member of a given set, or a constant, is written.
  using Spelling = std::function<std::string(const AtomName&)>;
  /// Writes the value in Z notation, in Unicode; a member of a given set, or a constant, as its own text. A set that is
  /// known by membership only is written as a message would name it.
  std::string text() const;
  /// Writes it so with this spelling, and each empty set with the type of its members where that is known, `∅[𝔸]`, so
  /// that it can be read back alone. Precondition: the value is of this type, which is settled.
  std::string text(const Type& type, const Spelling& spelling) const;

 private:
  Form form_;
};

/// The marks of a tuple or of a binding say what is among its parts and theirs, but for the members of sets. They are
/// taken when it is made, as a transition asks for them many times.
struct PartMarks {
  bool open = false;  ///< a part is open, unknown or a polynomial
  bool sets = false;  ///< a part is a set
};

/// The parts of a tuple. Most tuples are pairs and most bindings are points, so they need no heap for their parts.
struct TupleValue {
  /// Moves the parts out of p. Precondition: none is undefined.
  explicit TupleValue(std::span<Value> p);
  boost::container::small_vector<Value, 2> parts;  ///< none is undefined
  PartMarks marks;                                 ///< of the parts
};

/// The contents of a binding.
struct BindingValue {
  /// Moves the values out of v. Precondition: they are as many as the names, in their order, and none is undefined.
  BindingValue(Signature n, std::span<Value> v);
  Signature names;                                  ///< those of its type
  boost::container::small_vector<Value, 3> values;  ///< they are in step with names
  PartMarks marks;                                  ///< of the values
  /// Returns the value of that component, or null where there is none.
  const Value* component(const Name& name) const;
  /// The closed schema that the binding was last found to satisfy: a binding never changes, nor does a schema.
  mutable std::atomic<const void*> satisfies{nullptr};
};

/// A value that a constructor of a free type makes.
struct Constructed {
  Atom constructor;  ///< its name
  Value argument;    ///< the constructor was applied to it
};

/// A polynomial is constant + slope · unknown + square · unknown², with slope ≠ 0 or square ≠ 0.
struct Polynomial {
  Real constant, slope, square;  ///< the coefficients
  std::uint32_t unknown;         ///< the id of the unknown
};

/// The context holds the findings of an evaluation in progress (Solver).
struct Context;

/// The points of a curve, by the number t that leads to each (Set::curve).
struct Curve {
  Unknown t;     ///< it ranges over the reals
  Value member;  ///< the point at t, where there is one
  /// Says whether there is a point at this t, which is a number or the unknown itself.
  std::function<Truth(const Value& t, const Value& member, Context& context)> admits;
};

/// The kind of numbers that contains all members of a set.
enum class Numbers : std::uint8_t {
  none,      ///< no numbers, or it is not known which
  integers,  ///< whole numbers
  reals      ///< real numbers
};

/// The small values that a search for a witness tries.
struct SmallScope {
  std::vector<Real> numbers;  ///< in the order in which they are tried
  std::size_t most = 64;      ///< no set gives more members than these
  unsigned depth = 3;         ///< constructors of free types are nested so deep
  std::size_t given = 0;      ///< a given set `X` has so many members: X_1, X_2, …
};

struct FunctionSpace;

/// The questions that every set answers, whatever its form.
class Set {
 public:
  /// The wording of a set: as a message names it, or as a term without free names.
  enum class Wording : std::uint8_t {
    message,  ///< short, in the words of the text
    closed    ///< the names of the text that are bound elsewhere stand in a `let` before it, with their values
  };
  virtual ~Set() = default;
  /// Says whether the value is a member. Throws EvaluationError where that cannot be decided.
  virtual Truth contains(const Value& value, Context& context) const = 0;
  /// Returns the members of a finite set, sorted, each once. It is null where the set is intensional.
  virtual const std::vector<Value>* members() const { return nullptr; }
  /// Says whether it was made as a sequence, and is written as one; it equals the same set of pairs made otherwise.
  virtual bool is_sequence() const { return false; }
  /// Says whether sequences are among its members, or among their parts, by its form: `seq X`, `A ⇸ seq X`.
  virtual bool declares_sequences() const { return false; }
  /// Returns the member as what is declared from this set is written: a member of `seq X` as a sequence.
  virtual Value as_declared(const Value& member) const { return member; }
  /// Returns the number of members of a finite set, where nobody need list them; nothing where it is not known.
  virtual std::optional<Real> size() const;
  /// Returns some members, small ones first: a search tries them, and they say nothing of other members. Each is one as
  /// far as is known.
  virtual std::vector<Value> some_members(const SmallScope& scope, Context& context) const;
  /// Returns every member that is a set of so many members at most, as a finite set. Nothing where they cannot be
  /// listed.
  virtual std::optional<Value> members_up_to(std::size_t size, Context& context) const;
  /// Returns spaces of functions that are members, for a search that gives them their values one by one; none where the
  /// set is of another kind.
  virtual std::vector<FunctionSpace> function_spaces(const SmallScope& scope, Context& context) const;
  /// Returns the other parts of all pairs of the relation whose part `part`, 0 or 1, is this value, each once. Nothing
  /// where they cannot be listed.
  virtual std::optional<std::vector<Value>> partners(const Value& known, std::size_t part, Context& context) const;
  /// Says whether some pair of the relation has this part.
  virtual Truth has_partner(const Value& known, std::size_t part, Context& context) const;
  /// Returns the number of members that the set has listed so far: a set may be listed when it is first asked for its
  /// members.
  virtual std::size_t listed() const { return 0; }
  /// Says whether every value of the type is known to be a member.
  virtual bool total() const { return false; }
  /// Says whether this is a finite set of intensional sets: members may then repeat, as nobody can compare them.
  virtual bool family() const { return false; }
  /// Returns the kind of numbers that every member is.
  virtual Numbers numbers() const { return Numbers::none; }
  /// Says whether nothing in the set depends on an unknown that is looked for.
  virtual bool closed() const { return true; }
  /// Returns the curve of a set of sets that one real number t tells apart, each with one member at most: that member
  /// for an unknown t. Nothing where the set is of another kind, or it is not known.
  virtual std::optional<Curve> curve(Context& context) const;
  /// Makes a member with every part unknown.
  virtual Value unknown(Context& context) const;
  /// Applies the set as a function. Throws EvaluationError where it is not known what it relates to the argument.
  virtual Value apply(const Value& argument, Context& context) const;
  /// Returns the image of a set through the relation, R ⦇ S ⦈, where the relation is known by its images alone; nothing
  /// where its pairs, or the values that it has, give the image.
  virtual std::optional<Value> image(const Value& set, Context& context) const;
  /// Says whether the set as a function is defined there.
  virtual Truth in_domain(const Value& argument, Context& context) const;
  /// Says whether some member of this set of sets contains the value.
  virtual Truth some_contains(const Value& value, Context& context) const;
  /// Names the set, for printing.
  virtual std::string spelled(Wording wording) const = 0;
  /// Names the set, for messages.
  std::string text() const { return spelled(Wording::message); }
};

/// Orders values of one type by their structure, totally on those without unknown parts. Intensional sets are in an
/// arbitrary order, by identity.
std::strong_ordering compare(const Value& a, const Value& b);
/// Says whether compare() puts neither before the other, as of two open values or two polynomials, whatever they are.
inline bool same(const Value& a, const Value& b) { return compare(a, b) == 0; }

/// Says whether the value is, or has a part that is, open, unknown or a polynomial. A set has no parts here.
bool has_open(const Value& value);
/// Says whether nothing in the value, and in the sets that it holds, depends on an unknown.
bool closed(const Value& value);
/// Says whether the value is, or has a part that is, an intensional set or a family of such.
bool has_intensional(const Value& value);

}  // namespace durero::zed
