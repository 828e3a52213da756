#include "durero/contract/contract.hpp"

#include <sys/wait.h>
#include <unistd.h>

#include <exception>
#include <optional>
#include <string>
#include <vector>

#include "support/catch.hpp"

using namespace durero;
using contract::cost;
using contract::evaluation_semantic;
using contract::scoped_semantic;

namespace {

constexpr contract::clause pre{"Test.pre.1", "x > 0"};
constexpr contract::clause post{"Test.post.1", "x' = x"};
constexpr contract::clause inv{"Test.inv.1", "x ≥ 0"};
constexpr contract::clause assertion{"Test.assert.1", "x ≠ 1"};

std::vector<std::string> handled;
void remember(const contract::contract_violation& violation) { handled.emplace_back(violation.label()); }
void throw_label(const contract::contract_violation& violation) { throw std::string(violation.label()); }

/// Installs a handler for a scope.
class scoped_handler {
 public:
  explicit scoped_handler(contract::violation_handler now) : before_(contract::set_violation_handler(now)) {
    handled.clear();
  }
  ~scoped_handler() { contract::set_violation_handler(before_); }

 private:
  contract::violation_handler before_;
};

}  // namespace

TEST_CASE("the label tells the kind of a clause") {
  CHECK(pre.kind() == contract::kind::precondition);
  CHECK(post.kind() == contract::kind::postcondition);
  CHECK(inv.kind() == contract::kind::invariant);
  CHECK(assertion.kind() == contract::kind::assertion);
}

TEST_CASE("enforce throws a violation that carries label, Z text, values and place") {
  const unsigned line = __LINE__ + 2;
  try {
    contract::check(
        pre, [] { return false; }, [] { return std::string("x = 0"); });
    FAIL("not thrown");
  } catch (const contract::contract_violation& violation) {
    CHECK(violation.label() == "Test.pre.1");
    CHECK(violation.predicate() == "x > 0");
    CHECK(violation.kind() == contract::kind::precondition);
    CHECK(violation.semantic() == evaluation_semantic::enforce);
    CHECK(violation.values() == "x = 0");
    CHECK(violation.where().line() == line);
    CHECK(std::string(violation.where().file_name()).find("contract_test.cpp") != std::string::npos);
    CHECK(std::string(violation.what()) == "precondition Test.pre.1 broken: x > 0 [x = 0]");
  }
}

TEST_CASE("a clause that holds costs no values, and a broken one may have none") {
  int printed = 0;
  contract::check(
      pre, [] { return true; }, [&] { return ++printed, std::string(); });
  CHECK(printed == 0);
  try {
    contract::check(post, [] { return false; });
    FAIL("not thrown");
  } catch (const contract::contract_violation& violation) {
    CHECK(std::string(violation.what()) == "postcondition Test.post.1 broken: x' = x");
  }
}

TEST_CASE("ignore does not evaluate the predicate") {
  const scoped_semantic ignored(cost::normal, evaluation_semantic::ignore);
  bool evaluated = false;
  contract::check(pre, [&] { return evaluated = true, false; });
  CHECK_FALSE(evaluated);
  CHECK_FALSE(contract::evaluated(cost::normal));
}

TEST_CASE("observe reports and goes on") {
  const scoped_handler handler(remember);
  const scoped_semantic observed(cost::normal, evaluation_semantic::observe);
  contract::check(inv, [] { return false; });
  contract::check(assertion, [] { return false; });
  CHECK(handled == std::vector<std::string>{"Test.inv.1", "Test.assert.1"});
}

TEST_CASE("a handler may throw what it likes, and null restores the default") {
  const scoped_handler handler(throw_label);
  CHECK_THROWS_AS(contract::check(pre, [] { return false; }), std::string);
  contract::set_violation_handler(nullptr);
  CHECK_THROWS_AS(contract::check(pre, [] { return false; }), contract::contract_violation);
}

TEST_CASE("audit clauses are ignored until they are asked for") {
  bool evaluated = false;
  const auto look = [&] { return evaluated = true, false; };
  contract::check(inv, look, contract::no_values, cost::audit);
  CHECK_FALSE(evaluated);
  CHECK_FALSE(contract::old_value([] { return 1; }));

  const scoped_semantic audited(cost::audit, evaluation_semantic::enforce);
  CHECK_THROWS_AS(contract::check(inv, look, contract::no_values, cost::audit), contract::contract_violation);
  CHECK(evaluated);
  CHECK(contract::old_value([] { return 1; }) == 1);
}

TEST_CASE("a scope puts the semantic before back") {
  {
    const scoped_semantic outer(cost::normal, evaluation_semantic::observe);
    {
      const scoped_semantic inner(cost::normal, evaluation_semantic::ignore);
      CHECK(contract::semantic(cost::normal) == evaluation_semantic::ignore);
    }
    CHECK(contract::semantic(cost::normal) == evaluation_semantic::observe);
  }
  CHECK(contract::semantic(cost::normal) == evaluation_semantic::enforce);
  CHECK(contract::semantic(cost::audit) == evaluation_semantic::ignore);
}

TEST_CASE("a type refuses a value outside it under every semantic") {
  for (const auto semantic :
       {evaluation_semantic::ignore, evaluation_semantic::observe, evaluation_semantic::enforce}) {
    const scoped_semantic scope(cost::normal, semantic);
    CHECK_NOTHROW(contract::require(inv, true));
    CHECK_THROWS_AS(contract::require(inv, false), contract::contract_violation);
  }
}

TEST_CASE("a copy of a violation keeps its words") {
  const contract::contract_violation first(pre, "x = 0", std::source_location::current(), evaluation_semantic::observe);
  const contract::contract_violation second = first;
  CHECK(std::string(second.what()) == first.what());
  CHECK(second.values() == "x = 0");
  CHECK(std::is_nothrow_copy_constructible_v<contract::contract_violation>);
}

namespace {

/// Runs the action in a child process. Answers how many violations the handler saw before std::terminate ended it, or
/// nothing where it was not ended so.
template <class Action>
std::optional<int> violations_until_terminate(Action&& action) {
  constexpr int terminated = 100;
  const pid_t child = fork();
  if (child == 0) {
    std::set_terminate([] { _exit(terminated + static_cast<int>(handled.size())); });
    action();
    _exit(0);
  }
  int status = 0;
  waitpid(child, &status, 0);
  if (!WIFEXITED(status) || WEXITSTATUS(status) < terminated) return std::nullopt;
  return WEXITSTATUS(status) - terminated;
}

}  // namespace

TEST_CASE("quick_enforce ends the program at once, without a handler") {
  const scoped_handler handler(remember);
  const scoped_semantic quick(cost::normal, evaluation_semantic::quick_enforce);
  CHECK(violations_until_terminate([] { contract::check(pre, [] { return false; }); }) == 0);
}

TEST_CASE("under enforce the program does not go on where the handler returns") {
  const scoped_handler handler(remember);
  CHECK(violations_until_terminate([] { contract::check(pre, [] { return false; }); }) == 1);
  CHECK(violations_until_terminate([] { contract::check(pre, [] { return true; }); }) == std::nullopt);
}
