#include "durero/spec/partition.hpp"

#include <algorithm>
#include <fstream>
#include <map>
#include <sstream>

#include "support/catch.hpp"
#include "support/tree.hpp"

namespace durero::spec {
namespace {

OperationCases cases_of(const std::string& text, const Machine& machine) {
  CHECK_FALSE(text.empty());
  ExploreBounds bounds;
  OperationCases found = operation_cases(machine, bounds);
  for (const OperationCase& each : found.cases) {
    if (!each.is_found) continue;
    REQUIRE_FALSE(each.way.empty());
    REQUIRE_FALSE(each.admitted.empty());
    for (const Transition& step : each.admitted)  // the evaluator judges each answer
      CHECK(machine.is_step(each.way.back().after, step) == zed::Truth::yes);
    Animation way(machine), again(machine);
    for (const Transition& step : each.way) way.take(step);
    again.replay(way.saved());
  }
  return found;
}

const char* const account_text = R"(
\begin{zed} Answer ::= done | refused \end{zed}
\begin{schema}{Account} owed : \nat \\ most : \nat \where owed \leq most \\ most \leq 3 \end{schema}
\begin{schema}{Init} Account~' \where owed' = 0 \\ most' = 2 \end{schema}
\begin{schema}{Take} \Delta Account \\ n? : 0 \upto 3 \\ answer! : Answer \where
  most' = most \\
  (owed + n? \leq most \land owed' = owed + n? \land answer! = done) \lor
  (owed + n? > most \land owed' = owed \land answer! = refused) \lor
  (owed > 3 \land owed' = 0 \land answer! = refused) \end{schema}
\begin{schema}{Pay} \Delta Account \\ n? : 0 \upto 3 \where
  most' = most \\ owed' < owed \\ n? = 0 \implies owed' = 0 \end{schema}
)";

TEST_CASE("each disjunct of an operation is a case with an example, and one without is infeasible") {
  const auto read = zed::read_text(account_text, "account.tex");
  REQUIRE(read.ok());
  const Machine machine(read, Setup{});
  const OperationCases found = cases_of(account_text, machine);
  CHECK(found.whole.empty());
  CHECK(found.bounded.empty());
  std::map<std::string, std::pair<int, int>> counts;  // of an operation: its cases with an example, and without
  for (const OperationCase& each : found.cases)
    ++(each.is_found ? counts[each.operation].first : counts[each.operation].second);
  CHECK(counts == std::map<std::string, std::pair<int, int>>{{"Pay", {2, 0}}, {"Take", {2, 1}}});
  for (const OperationCase& each : found.cases) {
    if (!each.is_found) CHECK(each.disjuncts == std::vector<std::string>{"owed > 3 ∧ owed' = 0 ∧ answer! = refused"});
    // A value that is left open has each answer that the text admits: from 2, with n? not 0, owed may become 0 or 1.
    if (each.operation == "Pay" && each.disjuncts == std::vector<std::string>{"¬ n? = 0"})
      CHECK(each.admitted.size() == static_cast<std::size_t>(std::stoi(each.way.back().after[0].second.text())));
  }
}

TEST_CASE("an operation without a disjunction is one case") {
  std::ostringstream all;
  all << std::ifstream(durero::test::source_dir() + "/demo/birthday_book.tex").rdbuf();
  Setup setup;
  setup.members = 2;
  const Machine machine(zed::read_text(all.str(), "book.tex"), setup);
  const OperationCases found = cases_of(all.str(), machine);
  CHECK(found.cases.size() == 9);  // two of seven operations are disjunctions of two
  CHECK(std::all_of(found.cases.begin(), found.cases.end(), [](const OperationCase& each) { return each.is_found; }));
  for (const OperationCase& each : found.cases)
    if (each.operation == "NotKnown") {  // any date will do
      REQUIRE(each.admitted.size() == 2);
      CHECK_FALSE(each.admitted[0] == each.admitted[1]);
    }
}

}  // namespace
}  // namespace durero::spec
