#pragma once
/// A number type that computes nothing: it writes down what a template of the tracer asks of it, as terms of Coq. Equal
/// terms are one node, so that what a template computes once stands once in what is written.

#include <string>
#include <utility>
#include <vector>

#include "trace/closed_form-inl.hpp"

namespace durero::trace::HWY_NAMESPACE {

/// How tightly a term of Coq holds together: a name; an application; anything else.
enum class Tightness { name, application, other };

/// A term of Coq: `form` with the operands in place of %0, %1, …, in brackets where they are looser than `takes`.
struct Form {
  std::string text;
  Tightness is, takes = Tightness::name;
};

/// A name, or what it is of: `f`, `A f`.
inline Form called(const std::string& name) {
  return {name, name.find(' ') == std::string::npos ? Tightness::name : Tightness::application};
}

/// The place of a term among all that were recorded.
using Node = std::size_t;
Node record(const Form& form, std::vector<Node> operands = {});
/// A binary64 as the real number that it is.
Node record(double constant);
/// a·b of two that are constants, if that is a binary64; else the product, rounded.
Node record_product(Node a, Node b);

/// The pair of both, which are the parts of one if they are.
Node record_pair(Node hi, Node lo);

/// A real number that is computed, or a name of one.
struct Term {
  Node node = record(0.0);

  Term() = default;
  Term(double constant) : node(record(constant)) {}
  Term(int constant) : node(record(static_cast<double>(constant))) {}
  explicit Term(const std::string& name) : node(record(called(name))) {}
  /// By a form; see Form.
  Term(const Form& form, std::vector<Node> operands) : node(record(form, std::move(operands))) {}
};

/// Asked for a truth that the path through the program has not settled.
struct Unsettled {
  Node condition;
};

/// Whether it holds, of a term of type bool, on the path at hand. Throws Unsettled.
bool settled(Node condition);

/// A condition that is computed. Where a program branches on it, it is either.
struct Condition {
  Node node = record({"false", Tightness::name});

  Condition() = default;
  Condition(const Form& form, std::vector<Node> operands) : node(record(form, std::move(operands))) {}
  explicit operator bool() const { return settled(node); }

  friend Condition operator&(Condition a, Condition b) {
    return {{"andb %0 %1", Tightness::application}, {a.node, b.node}};
  }
  friend Condition operator|(Condition a, Condition b) {
    return {{"orb %0 %1", Tightness::application}, {a.node, b.node}};
  }
  friend Condition operator!(Condition a) { return {{"negb %0", Tightness::application}, {a.node}}; }
  friend Condition operator==(Condition a, Condition b) {
    return {{"eqb %0 %1", Tightness::application}, {a.node, b.node}};
  }
};

/// Each operation rounds once.
inline Term rounded(Term a, const char* operation, Term b) {
  return {{std::string("rnd (%0 ") + operation + " %1)", Tightness::application, Tightness::application},
          {a.node, b.node}};
}
inline Term operator+(Term a, Term b) { return rounded(a, "+", b); }
inline Term operator-(Term a, Term b) { return rounded(a, "-", b); }
inline Term operator/(Term a, Term b) { return rounded(a, "/", b); }
inline Term operator*(Term a, Term b) {
  Term product;
  product.node = record_product(a.node, b.node);
  return product;
}
inline Term operator-(Term a) { return {{"- %0", Tightness::other, Tightness::application}, {a.node}}; }
inline Term abs(Term a) { return {{"Rabs %0", Tightness::application}, {a.node}}; }
inline Term sqrt(Term a) { return {{"rnd (sqrt %0)", Tightness::application}, {a.node}}; }
inline Condition operator<(Term a, Term b) { return {{"Rlt_bool %0 %1", Tightness::application}, {a.node, b.node}}; }
inline Condition operator<=(Term a, Term b) { return {{"Rle_bool %0 %1", Tightness::application}, {a.node, b.node}}; }
inline Condition operator==(Term a, Term b) { return {{"Req_bool %0 %1", Tightness::application}, {a.node, b.node}}; }
inline Condition operator>(Term a, Term b) { return b < a; }
inline Condition operator>=(Term a, Term b) { return b <= a; }
inline Node choice(Condition condition, Node yes, Node no) {
  return record({"if %0 then %1 else %2", Tightness::other, Tightness::other}, {condition.node, yes, no});
}
inline Term choose(Condition condition, Term yes, Term no) {
  Term chosen;
  chosen.node = choice(condition, yes.node, no.node);
  return chosen;
}

template <>
struct Numbers<Term> : Binary64<Term> {};

/// a·b and what it lacks, as where the hardware multiplies and subtracts in one.
template <>
inline Twofold<Term> two_prod(Term a, Term b) {
  const Term product = a * b;
  return {product,
          {{"rnd (%0 * %1 - %2)", Tightness::application, Tightness::application}, {a.node, b.node, product.node}}};
}

/// A double-double that is computed: each operation is named, and recorded by itself over Twofold<Term>.
struct PairTerm {
  Node node = record({"exactly %0", Tightness::application}, {record(0.0)});

  PairTerm() = default;
  PairTerm(Term value) : PairTerm({"exactly %0", Tightness::application}, {value.node}) {}
  PairTerm(double value) : PairTerm(Term(value)) {}
  /// By a form; see Form.
  PairTerm(const Form& form, std::vector<Node> operands) : node(record(form, std::move(operands))) {}

  friend PairTerm operator+(PairTerm a, PairTerm b) {
    return {{"sum %0 %1", Tightness::application}, {a.node, b.node}};
  }
  friend PairTerm operator-(PairTerm a) { return {{"opposite %0", Tightness::application}, {a.node}}; }
  friend PairTerm operator-(PairTerm a, PairTerm b) {
    return {{"difference %0 %1", Tightness::application}, {a.node, b.node}};
  }
  friend PairTerm operator*(PairTerm a, PairTerm b) {
    return {{"product %0 %1", Tightness::application}, {a.node, b.node}};
  }
  friend PairTerm operator/(PairTerm a, PairTerm b) {
    return {{"ratio %0 %1", Tightness::application}, {a.node, b.node}};
  }
  friend PairTerm sqrt(PairTerm a) { return {{"root_of %0", Tightness::application}, {a.node}}; }
  friend PairTerm choose(Condition condition, PairTerm yes, PairTerm no) {
    PairTerm chosen;
    chosen.node = choice(condition, yes.node, no.node);
    return chosen;
  }
};

template <>
struct Numbers<PairTerm> {
  using Bound = Term;
  static constexpr double roundoff = Numbers<DoubleDouble>::roundoff;
  static Term leading(PairTerm a) { return {{"hi %0", Tightness::application}, {a.node}}; }
  static PairTerm difference(Term a, Term b) {
    return {{"two_sum %0 %1", Tightness::application}, {a.node, (-b).node}};
  }
};

}  // namespace durero::trace::HWY_NAMESPACE
