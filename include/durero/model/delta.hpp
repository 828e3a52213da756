#pragma once
/// Both states of an operation (Δ Escena), and the forms of predicate in which the text relates them.

#include <algorithm>

#include "durero/model/escena.hpp"

namespace durero::model {

/// The states before and after an operation on e?. Each member is one form of predicate of spec/operaciones.tex, at
/// the price asked for: the whole predicate in O(n) without a copy, or what changed of it in O(log n), which is the
/// size of a component and its value at e?. It refers to the states and does not hold them.
class Delta {
 public:
  /// The states before and after, and the price at which they are compared. It outlives none of them.
  Delta(const Escena& before, const Elemento& e, const Escena& after, contract::cost price)
      : before_(before), e_(e), after_(after), whole_(price == contract::cost::audit) {}

  /// The state before.
  const Escena& before() const { return before_; }

  /// elementos' = elementos ∪ { e? }
  bool added() const;

  /// elementos' = elementos ∖ { e? }
  bool removed() const;

  /// elementos' = elementos
  bool same_names() const;

  /// c' = c ∪ { e? ↦ x }; false where x is no value of c's, and where c has another value at e?: the union is then no
  /// function, as c' is.
  template <class T, class X>
  bool with(std::map<Elemento, T> Escena::*c, const X& x) const {
    if (!maps(after_.*c, x)) return false;
    if (!whole_) return grown(c);
    return same_elsewhere(c) && (!(before_.*c).contains(e_) || maps(before_.*c, x));
  }

  /// c' = c ⊕ { e? ↦ x }; false where x is no value of c's.
  template <class T, class X>
  bool replaced(std::map<Elemento, T> Escena::*c, const X& x) const {
    return maps(after_.*c, x) && (whole_ ? same_elsewhere(c) : grown(c));
  }

  /// c' = { e? } ⩤ c
  template <class T>
  bool without(std::map<Elemento, T> Escena::*c) const {
    return !(after_.*c).contains(e_) && (whole_ ? same_elsewhere(c) : shrunk(c));
  }

  /// c' = c
  template <class T>
  bool same(std::map<Elemento, T> Escena::*c) const {
    if (whole_) return after_.*c == before_.*c;
    return (after_.*c).size() == (before_.*c).size() && (after_.*c).contains(e_) == (before_.*c).contains(e_);
  }

 private:
  /// { e? } ⩤ c' = { e? } ⩤ c: the entries before e? are the same, and those after it are.
  template <class C>
  bool same_elsewhere(C Escena::*c) const {
    const C &a = before_.*c, &b = after_.*c;
    return std::equal(a.begin(), a.lower_bound(e_), b.begin(), b.lower_bound(e_)) &&
           std::equal(a.upper_bound(e_), a.end(), b.upper_bound(e_), b.end());
  }
  template <class C>
  bool grown(C Escena::*c) const {
    return (after_.*c).size() == (before_.*c).size() + !(before_.*c).contains(e_);
  }
  template <class C>
  bool shrunk(C Escena::*c) const {
    return (after_.*c).size() + (before_.*c).contains(e_) == (before_.*c).size();
  }

  bool maps(const std::map<Elemento, Rmas>& c, double x) const {
    const auto maplet = c.find(e_);
    return maplet != c.end() && maplet->second.value() == x;
  }
  bool maps(const std::map<Elemento, Vertices>& c, const Terna& x) const {
    const auto maplet = c.find(e_);
    return maplet != c.end() && maplet->second.terna() == x;
  }
  template <class T>
  bool maps(const std::map<Elemento, T>& c, const T& x) const {
    const auto maplet = c.find(e_);
    return maplet != c.end() && maplet->second == x;
  }

  const Escena& before_;
  const Elemento& e_;
  const Escena& after_;
  bool whole_;
};

}  // namespace durero::model
