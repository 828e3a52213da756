#pragma once
/// The contract facility, in the words of C++26 contracts: a clause is a precondition, a postcondition, an invariant
/// or an assertion; it is evaluated under one of four semantics; a broken one makes a contract_violation, which the
/// violation handler receives.
///
/// Why not macros: a predicate is a lambda, so it is type-checked in every build, costs nothing when it is ignored,
/// and an editor can follow its names. Why a semantic chosen at run time: the cost of contracts is then measured, and
/// their effect tested, inside one program; it costs one relaxed load and one predictable branch a clause.

#include <atomic>
#include <exception>
#include <memory>
#include <optional>
#include <source_location>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>

namespace durero::contract {

/// What a clause speaks of: the state before an operation, the state after, every state, or a place in the code.
enum class kind { precondition, postcondition, invariant, assertion };

/// What a clause may cost: `normal` O(1) or O(log n), only what changed; `audit` the whole Z predicate.
enum class cost { normal, audit };

/// ignore: not evaluated. observe: a violation reaches the handler, then the program goes on.
/// enforce: a violation reaches the handler, which must not return (the default one throws).
/// quick_enforce: a violation ends the program at once, without a handler.
enum class evaluation_semantic { ignore, observe, enforce, quick_enforce };

/// One predicate of the Z text. The label, `SCHEMA.KIND.NUMBER` (KIND one of pre, post, inv, assert), is its name in
/// the Z text, the clause, the test that violates it and the theorem that uses it.
struct clause {
  std::string_view label;      ///< such as Agregar_Esfera.pre.2
  std::string_view predicate;  ///< the Z text, in Unicode

  /// What the label says of itself; an assertion where it says none of the others.
  constexpr contract::kind kind() const {
    if (label.find(".pre.") != label.npos) return kind::precondition;
    if (label.find(".post.") != label.npos) return kind::postcondition;
    if (label.find(".inv.") != label.npos) return kind::invariant;
    return kind::assertion;
  }
};

/// A clause that did not hold: which, on what values, where, and under which semantic.
class contract_violation : public std::exception {
 public:
  /// Of that clause, with the values that `values` prints.
  contract_violation(const clause& broken, std::string values, std::source_location where,
                     evaluation_semantic semantic);

  /// @{ Of the clause that did not hold.
  std::string_view label() const noexcept { return broken_.label; }
  std::string_view predicate() const noexcept { return broken_.predicate; }
  contract::kind kind() const noexcept { return broken_.kind(); }
  /// @}
  evaluation_semantic semantic() const noexcept { return semantic_; }         ///< under which it was evaluated
  const std::string& values() const noexcept { return text_->values; }        ///< `name = value, …`, or empty
  const std::source_location& where() const noexcept { return where_; }       ///< where it was evaluated
  const char* what() const noexcept override { return text_->what.c_str(); }  ///< all of this in a line

 private:
  struct text {
    std::string values, what;
  };
  clause broken_;
  std::source_location where_;
  evaluation_semantic semantic_;
  std::shared_ptr<const text> text_;  // shared, so that copying an exception cannot throw
};

/// What hears of a violation. Under `enforce` it must not return.
using violation_handler = void (*)(const contract_violation&);

/// Installs a handler and returns the one before. The default throws the violation under `enforce` and prints
/// one line on stderr under `observe`. Null restores the default.
violation_handler set_violation_handler(violation_handler handler) noexcept;

namespace detail {
inline constinit std::atomic<evaluation_semantic> semantics[2] = {evaluation_semantic::enforce,
                                                                  evaluation_semantic::ignore};
}  // namespace detail

/// The semantic under which clauses of this cost are evaluated: `enforce` for normal and `ignore` for audit, until set.
inline evaluation_semantic semantic(cost what) noexcept {
  return detail::semantics[static_cast<int>(what)].load(std::memory_order_relaxed);
}
/// Sets it, for every thread.
inline void set_semantic(cost what, evaluation_semantic semantic) noexcept {
  detail::semantics[static_cast<int>(what)].store(semantic, std::memory_order_relaxed);
}

/// True when clauses of this cost are evaluated at all.
inline bool evaluated(cost what) noexcept { return semantic(what) != evaluation_semantic::ignore; }

/// Sets a semantic for a scope, and puts the one before back.
class scoped_semantic {
 public:
  /// Sets `now` for clauses of this cost.
  scoped_semantic(cost what, evaluation_semantic now) noexcept : what_(what), before_(semantic(what)) {
    set_semantic(what, now);
  }
  /// Puts back what was.
  ~scoped_semantic() { set_semantic(what_, before_); }
  scoped_semantic(const scoped_semantic&) = delete;
  scoped_semantic& operator=(const scoped_semantic&) = delete;

 private:
  cost what_;
  evaluation_semantic before_;
};

/// Reports a broken clause under the given semantic (never `ignore`). Returns only under `observe`.
[[gnu::cold]] void report(const clause& broken, std::string values, std::source_location where,
                          evaluation_semantic semantic);

/// For a clause that needs no values to be understood.
inline constexpr auto no_values = [] { return std::string(); };

/// Evaluates a clause under a semantic that was read before, for clauses that are evaluated together.
template <class Predicate, class Values = decltype(no_values)&>
void check_under(evaluation_semantic now, const clause& what, Predicate&& holds, Values&& values = no_values,
                 std::source_location where = std::source_location::current()) {
  if (now == evaluation_semantic::ignore || holds()) [[likely]]
    return;
  report(what, std::forward<Values>(values)(), where, now);
}

/// Evaluates a clause: `holds()` is its predicate, without side effect; `values()` prints what it speaks of, and runs
/// only when it is broken.
template <class Predicate, class Values = decltype(no_values)&>
void check(const clause& what, Predicate&& holds, Values&& values = no_values, cost price = cost::normal,
           std::source_location where = std::source_location::current()) {
  check_under(semantic(price), what, std::forward<Predicate>(holds), std::forward<Values>(values), where);
}

/// Evaluates the invariant of a value type under every semantic, and reports a broken one as under `enforce`: a value
/// outside its type has no meaning, so it cannot be built, whatever the semantic of the clauses.
template <class Values = decltype(no_values)&>
void require(const clause& what, bool holds, Values&& values = no_values,
             std::source_location where = std::source_location::current()) {
  if (!holds) [[unlikely]]
    report(what, std::forward<Values>(values)(), where, evaluation_semantic::enforce);
}

/// The old value of a state, `state()`: taken only when audit clauses are evaluated; empty otherwise.
template <class State>
std::optional<std::invoke_result_t<State>> old_value(State&& state) {
  if (!evaluated(cost::audit)) return std::nullopt;
  return std::forward<State>(state)();
}

/// Stands after a switch that names every value of a closed set: there is no other value.
[[noreturn]] inline void unreachable() noexcept { __builtin_unreachable(); }

}  // namespace durero::contract
