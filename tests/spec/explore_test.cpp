#include "durero/spec/explore.hpp"

#include <algorithm>
#include <fstream>
#include <iterator>
#include <map>
#include <random>
#include <set>
#include <sstream>

#include "support/catch.hpp"
#include "support/tree.hpp"

namespace durero::spec {
namespace {

using Catch::Matchers::Contains;

/// A state and a step as text, by which two explorations are compared.
std::string state_text(const zed::Valuation& state) {
  std::string text;
  for (const auto& [name, value] : state) text += name.text() + " = " + value.text() + "; ";
  return text;
}

std::string text_of_step(const Transition& step) {
  return step.operation + " " + state_text(step.inputs) + state_text(step.outputs) + "→ " + state_text(step.after);
}

/// The states and steps of a machine.
struct SpaceTexts {
  std::set<std::string> states, steps;
  bool whole = true;  // the evaluator says that there are no others
};

/// The evaluator's own search, state by state.
SpaceTexts evaluated_space(const Machine& machine) {
  SpaceTexts found;
  std::vector<zed::Valuation> queue;
  const auto reach = [&](const zed::Valuation& state) {
    if (found.states.insert(state_text(state)).second) queue.push_back(state);
  };
  for (const Transition& step : machine.initial(10'000).transitions) reach(step.after);
  for (std::size_t at = 0; at < queue.size(); ++at)
    for (const MachineOperation& operation : machine.operations()) {
      const zed::Valuation before = queue[at];
      const ReachedTransitions reached = machine.steps(before, operation, {}, 10'000);
      found.whole = found.whole && !reached.undecided && reached.bounded.empty();
      for (const Transition& step : reached.transitions) {
        found.steps.insert(state_text(before) + text_of_step(step));
        reach(step.after);
      }
    }
  return found;
}

/// The planned search; the evaluator judges each step that it finds.
SpaceTexts planned_space(const Machine& machine, StateSpace& space) {
  SpaceTexts found;
  for (std::size_t at = 0; at < space.size(); ++at) {
    found.states.insert(state_text(space.state(at)));
    for (const auto& [step, to] : space.steps_from(at)) {
      found.steps.insert(state_text(space.state(at)) + text_of_step(step));
      CHECK(machine.is_step(space.state(at), step) != zed::Truth::no);
    }
  }
  return found;
}

ExploreBounds plain() {
  ExploreBounds bounds;
  bounds.symmetry = false;
  return bounds;
}

Setup members(std::size_t count) {
  Setup setup;
  setup.members = count;
  setup.inputs = 100'000;
  return setup;
}

/// The texts of one set that the other lacks.
std::vector<std::string> beyond(const std::set<std::string>& some, const std::set<std::string>& others) {
  std::vector<std::string> texts;
  std::set_difference(some.begin(), some.end(), others.begin(), others.end(), std::back_inserter(texts));
  return texts;
}

/// Explores both ways, and checks that these find the same, and that classes of states add up to them. Where the
/// evaluator leaves something open, more may be found than it finds. Returns whether it does not.
bool check_agreement(const std::string& text, const Setup& setup, bool planned = true) {
  const auto read = zed::read_text(text, "machine.tex");
  REQUIRE(read.ok());
  const Machine machine(read, setup);
  StateSpace space(machine, plain());
  const ExploreReport& report = space.explore();
  if (planned)
    for (const OperationCoverage& each : report.operations) {
      INFO(each.name << " is planned");
      CHECK_FALSE(each.evaluated);
    }
  const SpaceTexts expected = evaluated_space(machine), found = planned_space(machine, space);
  const std::vector<std::string> none;
  CHECK(beyond(expected.states, found.states) == none);
  CHECK(beyond(expected.steps, found.steps) == none);
  if (expected.whole) {
    CHECK(beyond(found.states, expected.states) == none);
    CHECK(beyond(found.steps, expected.steps) == none);
  }
  CHECK(report.states == found.states.size());
  CHECK(report.transitions == found.steps.size());
  StateSpace classes(machine, ExploreBounds{});
  const ExploreReport& by_class = classes.explore();
  CHECK(by_class.states == report.states);
  CHECK(by_class.transitions == report.transitions);
  CHECK(by_class.deadlocks == report.deadlocks);
  CHECK(by_class.depth == report.depth);
  for (std::size_t i = 0; i < report.operations.size(); ++i) {
    CHECK(by_class.operations[i].transitions == report.operations[i].transitions);
    CHECK(by_class.operations[i].states == report.operations[i].states);
  }
  return expected.whole;
}

std::string demo_book() {
  std::ostringstream all;
  all << std::ifstream(durero::test::source_dir() + "/demo/birthday_book.tex").rdbuf();
  return all.str();
}

std::string schema(const std::string& name, const std::string& declarations, const std::string& predicates) {
  return "\\begin{schema}{" + name + "} " + declarations + (predicates.empty() ? "" : " \\where " + predicates) +
         " \\end{schema}\n";
}

/// A counter from 0 to `most` that Up counts, and what else is said of it.
std::string counter(const std::string& most, const std::string& more = "") {
  return schema("S", "n : \\nat", "n \\leq " + most) + schema("Init", "S~'", "n' = 0") +
         schema("Up", "\\Delta S", "n' = n + 1") + more;
}

zed::Specification read(const std::string& text) {
  auto specification = zed::read_text(text, "machine.tex");
  REQUIRE(specification.ok());
  return specification;
}

ExploreReport explored(const std::string& text, ExploreBounds bounds = plain(), const Setup& setup = members(2)) {
  const Machine machine(read(text), setup);
  return StateSpace(machine, std::move(bounds)).explore();
}

TEST_CASE("planned operations find the states and steps that the evaluator finds: the birthday book") {
  CHECK(check_agreement(demo_book(), members(2)));
}

/// A mailbox: sets, functions, overriding, sequences, counting, and disjunctions of schemas.
const char* const mailbox_text = R"(
\begin{zed} [MSG, ADDR] \end{zed}
\begin{zed} Flag ::= seen | unseen \end{zed}
\begin{zed} Report ::= fine | full | missing \end{zed}
\begin{axdef} most : \nat \where most = 1 \end{axdef}
\begin{schema}{Box} msgs : \power MSG \\ flag : MSG \pfun Flag \\ from : MSG \pfun ADDR \where
  \dom flag = msgs \\ \dom from = msgs \\ \# msgs \leq most \end{schema}
\begin{schema}{Init} Box~' \where msgs' = \emptyset \\ flag' = \emptyset \\ from' = \emptyset \end{schema}
\begin{schema}{Take} \Delta Box \\ m? : MSG \\ sender? : ADDR \where m? \notin msgs \\ \# msgs < most \\
  msgs' = msgs \cup \{m?\} \\ flag' = flag \cup \{m? \mapsto unseen\} \\ from' = from \cup \{m? \mapsto sender?\} \end{schema}
\begin{schema}{Read} \Delta Box \\ m? : MSG \where m? \in msgs \\ flag(m?) = unseen \\ msgs' = msgs \\ from' = from \\
  flag' = flag \oplus \{m? \mapsto seen\} \end{schema}
\begin{schema}{Drop} \Delta Box \\ m? : MSG \where m? \in msgs \\ msgs' = msgs \setminus \{m?\} \\
  flag' = \{m?\} \ndres flag \\ from' = \{m?\} \ndres from \end{schema}
\begin{schema}{Count} \Xi Box \\ count! : \nat \where count! = \# \{~ m : msgs | flag(m) = unseen ~\} \end{schema}
\begin{schema}{Full} \Xi Box \\ report! : Report \where \# msgs = most \\ report! = full \end{schema}
\begin{zed} TakeAll == (Take \land [~ report! : Report | report! = fine ~]) \lor Full \end{zed}
\begin{zed} DropAll == (Drop \land [~ report! : Report | report! = fine ~]) \lor
  [~ \Xi Box; m? : MSG; report! : Report | m? \notin msgs \land report! = missing ~] \end{zed}
)";

TEST_CASE("planned operations find what the evaluator finds: a mailbox with total operations") {
  check_agreement(mailbox_text, members(2));
}

TEST_CASE("planned operations find what the evaluator finds: sequences, local variables, and what is left loose") {
  check_agreement(R"(
\begin{zed} [X] \end{zed}
\begin{schema}{Q} q : \seq X \\ open : \power X \where \# q \leq 2 \end{schema}
\begin{schema}{Init} Q~' \where q' = \langle \rangle \\ open' = \emptyset \end{schema}
\begin{schema}{Push} \Delta Q \\ x? : X \where q' = q \cat \langle x? \rangle \\ open' = open \end{schema}
\begin{schema}{Pop} \Delta Q \\ x! : X \where q \neq \langle \rangle \\ x! = head(q) \\ q' = tail(q) \\ open' = open \end{schema}
\begin{schema}{Loose} \Delta Q \where q' = q \\ open' \subseteq \ran q \end{schema}
\begin{schema}{Turn} \Delta Q \where \exists a, b : X @ q = \langle a, b \rangle \land q' = \langle b, a \rangle \\ open' = open \end{schema}
\begin{schema}{Take} \Delta Q \\ x! : X \where x! \in open \\ open' = open \setminus \{x!\} \\ q' = q \end{schema}
)",
                  members(2));
}

TEST_CASE("planned operations find what the evaluator finds: a relation that is applied is no function everywhere") {
  CHECK(check_agreement(R"(
\begin{zed} [X] \end{zed}
\begin{schema}{S} r : X \rel 0 \upto 1 \end{schema}
\begin{schema}{Init} S~' \where r' = \emptyset \end{schema}
\begin{schema}{Put} \Delta S \\ x? : X \\ k? : 0 \upto 1 \where r' = r \cup \{x? \mapsto k?\} \end{schema}
\begin{schema}{Get} \Xi S \\ x? : X \\ k! : 0 \upto 1 \where k! = r(x?) \end{schema}
\begin{schema}{Miss} \Xi S \\ x? : X \where \lnot (r(x?) = 0) \end{schema}
)",
                        members(2)));
}

TEST_CASE("planned operations find what the evaluator finds: a promoted operation, bindings and quantifiers") {
  check_agreement(R"(
\begin{zed} [K] \end{zed}
\begin{schema}{Item} v : 0 \upto 2 \\ on : 0 \upto 1 \end{schema}
\begin{schema}{Step} \Delta Item \where v < 2 \\ v' = v + 1 \\ on' = 1 - on \end{schema}
\begin{schema}{All} items : K \pfun Item \where \forall k : \dom items @ (items(k)).v \geq 0 \end{schema}
\begin{schema}{Init} All~' \where items' = \emptyset \end{schema}
\begin{schema}{New} \Delta All \\ k? : K \where k? \notin \dom items \\
  items' = items \cup \{ k? \mapsto (\mu Item | v = 0 \land on = 0) \} \end{schema}
\begin{schema}{One} \Delta All \\ \Delta Item \\ k? : K \where k? \in \dom items \\ \theta Item = items(k?) \\
  items' = items \oplus \{ k? \mapsto \theta Item~' \} \end{schema}
\begin{zed} StepOne == \exists \Delta Item @ One \land Step \end{zed}
)",
                  members(2), false);
}

/// Machines with a set, a function and a number, whose operations are put together at random.
class RandomMachine {
 public:
  explicit RandomMachine(unsigned seed) : random_(seed) {}

  std::string text() {
    std::string all = "\\begin{zed} [X] \\end{zed}\n" +
                      schema("S", "s : \\power X \\\\ f : X \\pfun 0 \\upto 1 \\\\ n : 0 \\upto 2", invariant()) +
                      schema("Init", "S~'", "s' = \\emptyset \\\\ f' = \\emptyset \\\\ n' = 0");
    for (const char* name : {"A", "B", "C"})
      all += schema(name, "\\Delta S \\\\ x? : X \\\\ k? : 0 \\upto 1 \\\\ r! : 0 \\upto 3", operation());
    return all;
  }

 private:
  std::string one_of(std::initializer_list<const char*> texts) {
    return *(texts.begin() + std::uniform_int_distribution<std::size_t>(0, texts.size() - 1)(random_));
  }
  std::string invariant() {
    return one_of({"\\# s \\leq 2", "n \\leq 2 \\\\ \\dom f \\subseteq s", "\\# f \\leq n + 2"});
  }
  std::string fact() {
    return one_of({"x? \\in s", "x? \\notin s", "n < 2", "f(x?) = k?", "f(x?) \\neq k?", "\\# s = n", "x? \\in \\dom f",
                   "\\exists y : s @ y \\neq x?", "\\forall y : s @ y \\in \\dom f", "k? = 0 \\implies x? \\in s",
                   "n \\mod 2 = k?", "\\lnot (x? \\in s \\land n = 0)", "(n = 0 \\iff s = \\emptyset)",
                   "f \\limg \\{x?\\} \\rimg \\subseteq \\{k?\\}", "\\exists_1 y : X @ y \\in s", "0 \\leq n - k? < 2",
                   "\\{~ y : s | y \\in \\dom f @ f(y) ~\\} = \\{k?\\}", "(x?, k?) \\in f \\lor n = k?"});
  }
  std::string after_set() {
    return one_of({"s' = s", "s' = s \\cup \\{x?\\}", "s' = s \\lor s' = \\{x?\\}", "s' = s \\setminus \\{x?\\}",
                   "s' = \\dom f'", "s' \\subseteq s", "s' = \\{~ y : X | y \\notin s ~\\}",
                   "(x? \\in s \\land s' = \\{x?\\}) \\lor (x? \\notin s \\land s' = s)",
                   "s' = \\IF n = 0 \\THEN X \\ELSE s", "\\# s' = k?"});
  }
  std::string after_function() {
    return one_of({"f' = f", "f' = f \\oplus \\{x? \\mapsto k?\\}", "f' = f \\cup \\{x? \\mapsto k?\\}",
                   "f' = \\{x?\\} \\ndres f", "f' = s \\dres f", "f' = (\\lambda y : s @ k?)",
                   "f' = f \\nrres \\{k?\\}", "\\dom f' = \\dom f",
                   "f' = \\{~ y : s; z : 0 \\upto 1 | z = n \\div 2 @ y \\mapsto z ~\\}"});
  }
  std::string after_number() {
    return one_of({"n' = n", "n' = n + 1", "n' + k? = n", "n' > n", "n' \\in \\{0, n\\}", "n' = \\# s'", "n = 2 - n'",
                   "(n' = n \\land k? = 0) \\lor (n' = 0 \\land k? = 1)", "k? = 1 \\implies n' = n"});
  }
  std::string output() {
    return one_of({"r! = n", "r! = \\# s", "r! = f(x?)", "r! = n' + k?", "r! = (\\mu y : 0 \\upto 3 | y = n)", "r! < 1",
                   "r! = max(\\{n, k?\\})"});
  }
  std::string operation() {
    return fact() + " \\\\ " + fact() + " \\\\ " + after_set() + " \\\\ " + after_function() + " \\\\ " +
           after_number() + " \\\\ " + output();
  }

  std::mt19937 random_;
};

TEST_CASE("planned operations find what the evaluator finds: machines put together at random") {
  const char* chosen = std::getenv("DURERO_SEED");
  const unsigned first = chosen ? static_cast<unsigned>(std::stoul(chosen)) : 20261129;
  constexpr unsigned machines = 40;
  unsigned whole = 0;
  for (unsigned seed = first; seed < first + machines; ++seed) {
    RandomMachine random(seed);
    const std::string text = random.text();
    INFO("DURERO_SEED=" << seed << "\n" << text);
    whole += check_agreement(text, members(2)) ? 1 : 0;
  }
  CHECK(whole > machines / 2);
}

TEST_CASE("a state in which nothing can happen is a deadlock, with a shortest way to it") {
  const ExploreReport report = explored(counter("2"));
  CHECK(report.states == 3);
  CHECK(report.transitions == 2);
  CHECK(report.depth == 2);
  CHECK(report.deadlocks == 1);
  REQUIRE(report.deadlock_ways.size() == 1);
  CHECK(report.deadlock_ways[0].size() == 3);
  CHECK_FALSE(report.is_bounded());
  const ExploreReport free = explored(counter("2", schema("Stay", "\\Xi S", "")));
  CHECK(free.deadlocks == 0);
  CHECK(free.deadlock_ways.empty());
}

TEST_CASE("what never happens is told, and so is a predicate that is never true, or never false") {
  const ExploreReport report =
      explored(counter("3", schema("Never", "\\Delta S", "n > 5 \\\\ n' = n") +
                                schema("Some", "\\Xi S \\\\ k? : 0 \\upto 1", "n \\geq 0 \\\\ n + k? < 2")));
  REQUIRE(report.operations.size() == 3);
  const auto& never = report.operations[0];
  CHECK(never.name == "Never");
  CHECK(never.transitions == 0);
  REQUIRE(never.facts.size() == 1);
  CHECK(never.facts[0].predicate == "n > 5");
  CHECK(never.facts[0].yes == 0);
  CHECK(never.facts[0].no == 4);
  const auto& some = report.operations[1];
  CHECK(some.transitions == 3);
  REQUIRE(some.facts.size() == 2);
  CHECK(some.facts[0].no == 0);
  CHECK(some.facts[1].yes == 3);
  CHECK(some.facts[1].no == 5);
}

TEST_CASE("numbers that nothing bounds are tried within bounds, and the report says so") {
  const std::string text = counter("9", schema("Jump", "\\Xi S \\\\ by? : \\nat", "by? \\neq n"));
  ExploreBounds bounds = plain();
  bounds.low = 0;
  bounds.high = 2;
  const ExploreReport report = explored(text, bounds);
  CHECK(report.operations[0].transitions == 10 * 3 - 3);  // all but by? = n in three states
  CHECK(report.bounded == std::vector<std::string>{"Jump: some values of by? were tried: --numbers"});
  bounds.states = 4;
  CHECK(explored(counter("9"), bounds).bounded == std::vector<std::string>{"states: --states"});
  const ExploreReport within = explored(counter("9", schema("Down", "\\Xi S \\\\ by? : \\nat", "by? < n + 2")), bounds);
  CHECK(within.bounded == std::vector<std::string>{"states: --states"});  // n bounds by?
  CHECK(within.operations[0].transitions == 2 + 3 + 4 + 5);
}

TEST_CASE("the numbers of a quantifier are not bounded as those of an operation are") {
  const std::string text = counter("2", schema("All", "\\Xi S", "\\forall k : \\nat @ k < n + 9") +
                                            schema("Some", "\\Xi S", "\\exists k : \\nat @ k * k = n + 48"));
  const ExploreReport report = explored(text);
  CHECK(report.operations[0].transitions == 0);
  CHECK(report.operations[1].transitions == 1);  // 7 * 7 = 1 + 48
}

TEST_CASE("a conjecture that is false somewhere is shown with a shortest way there") {
  const std::string claims =
      "\\begin{zed} \\vdash? \\forall S @ n < 2 \\end{zed}\n\\begin{zed} \\vdash? \\forall Up @ n' > n \\end{zed}\n"
      "\\begin{zed} \\vdash? \\forall Up @ n < 1 \\end{zed}\n";
  ExploreBounds bounds = plain();
  bounds.always = {"n < 3", "n ≤ 3"};
  const std::string down = schema("Down", "\\Delta S", "n' = n - 1");  // of which the claims about Up say nothing
  const ExploreReport report = explored(counter("3", down) + claims, bounds);
  CHECK(report.claims == 5);
  REQUIRE(report.refuted.size() == 3);
  std::map<std::string, std::size_t> lengths;
  for (const FalseClaim& each : report.refuted) lengths[each.claim] = each.way.size();
  CHECK(lengths == std::map<std::string, std::size_t>{{"always n < 3", 4}, {"∀ S • n < 2", 3}, {"∀ Up • n < 1", 3}});
  bounds.always = {"m < 3"};
  CHECK_THROWS_AS(explored(counter("3"), bounds), zed::ZError);
  bounds.always = {"n + 1"};
  CHECK_THROWS_AS(explored(counter("3"), bounds), zed::ZError);
}

TEST_CASE("the way of a report is one that is read back, with members exchanged too") {
  const Machine machine(read(demo_book()), members(3));
  StateSpace space(machine, ExploreBounds{});
  const ExploreReport& report = space.explore();
  CHECK(report.exchanged == std::vector<std::string>{"DATE", "NAME"});
  CHECK(report.states == 64);
  CHECK(report.classes == 7);  // by how many have a birthday, and how many share one
  REQUIRE(report.refuted.size() == 1);
  Animation way(machine);
  for (const Transition& step : report.refuted[0].way) way.take(step);
  Animation again(machine);
  again.replay(way.saved());
  CHECK(again.way().size() == 3);
  for (std::size_t at = 0; at < space.size(); ++at) {
    Animation to(machine), back(machine);
    for (const Transition& step : space.way_to(at)) to.take(step);
    back.replay(to.saved());
  }
}

TEST_CASE("members that a constant or a predicate names are not exchanged") {
  const std::string text = "\\begin{zed} [X] \\end{zed}\n\\begin{axdef} top : X \\end{axdef}\n" +
                           schema("S", "s : \\power X", "") + schema("Init", "S~'", "s' = \\emptyset") +
                           schema("Add", "\\Delta S \\\\ x? : X", "x? \\neq top \\\\ s' = s \\cup \\{x?\\}");
  const ExploreReport report = explored(text, ExploreBounds{}, members(3));
  CHECK(report.exchanged.empty());
  CHECK(report.states == 4);
  ExploreBounds bounds;
  bounds.always = {"NAME1 ∉ known"};
  CHECK(explored(demo_book(), bounds).exchanged == std::vector<std::string>{"DATE"});
}

TEST_CASE("a step that is given whole is judged as the evaluator judges it") {
  const Machine machine(read(demo_book()), members(2));
  StateSpace space(machine, plain());
  space.explore();
  std::size_t yes = 0, no = 0;
  for (std::size_t from = 0; from < space.size(); ++from)
    for (const auto& [step, to] : space.steps_from(from))
      for (std::size_t other = 0; other < space.size(); ++other) {
        Transition moved = step;
        moved.after = space.state(other);
        const bool admitted = space.admits(space.state(from), moved);
        ++(admitted ? yes : no);
        CHECK(admitted == (machine.is_step(space.state(from), moved) == zed::Truth::yes));
      }
  CHECK(yes == 138);
  CHECK(no == 138 * 8);
}

TEST_CASE("an exploration that is stopped says what it found") {
  ExploreBounds bounds = plain();
  bounds.go_on = [](std::size_t, std::size_t done) { return done < 256; };
  const ExploreReport report = explored(counter("1000"), bounds);
  CHECK(report.stopped);
  CHECK(report.states > 256);
  CHECK(report.states < 512);
  CHECK(report.is_bounded());
}

TEST_CASE("a claim that exactly one state of another schema goes with each is asked of the evaluator") {
  const std::string text = schema("S", "n : 0 \\upto 1", "") + schema("Init", "S~'", "") +
                           schema("Stay", "\\Xi S", "") + schema("T", "m : 0 \\upto 1", "") +
                           schema("U", "n, m : 0 \\upto 1", "m = n") + schema("V", "n, m : 0 \\upto 1", "m \\leq n") +
                           "\\begin{zed} \\vdash? \\forall S @ \\exists_1 T @ U \\\\ "
                           "\\vdash? \\forall S @ \\exists_1 T @ V \\end{zed}\n";
  const ExploreReport report = explored(text);
  CHECK(report.claims == 2);
  REQUIRE(report.refuted.size() == 1);
  CHECK_THAT(report.refuted[0].claim, Contains("T • V"));
  CHECK(report.open == 0);
}

/// From one state 10⁶ choices of inputs, of which none is admitted.
const char* const long_step_text = R"(
\begin{schema}{S} n : \nat \end{schema}
\begin{schema}{Init} S~' \where n' = 0 \end{schema}
\begin{schema}{Long} \Delta S \\ a?, b? : 1 \upto 1000 \where a? * a? = 2 * b? * b? \\ n' = n \end{schema}
)";

TEST_CASE("an exploration that is stopped within a state does not say that nothing goes on from there") {
  std::size_t asked = 0;
  ExploreBounds bounds = plain();
  bounds.go_on = [&](std::size_t, std::size_t) { return ++asked < 10; };
  const ExploreReport report = explored(long_step_text, bounds);
  CHECK(report.stopped);
  CHECK(asked == 10);
  CHECK(report.states == 1);
  CHECK(report.initial == 1);
  CHECK(report.deadlocks == 0);
  bounds.go_on = {};
  CHECK(explored(long_step_text, bounds).deadlocks == 1);
}

TEST_CASE("an exploration that is stopped among the initial states knows these as initial") {
  std::size_t asked = 0;
  ExploreBounds bounds = plain();
  bounds.go_on = [&](std::size_t, std::size_t) { return ++asked < 3; };
  const ExploreReport none = explored(schema("S", "a, b : 1 \\upto 300", "") +
                                          schema("Init", "S~'", "a' * a' = 2 * b' * b'") + schema("Stay", "\\Xi S", ""),
                                      bounds);
  CHECK(none.stopped);
  CHECK(none.initial == 0);
  bounds.go_on = [](std::size_t states, std::size_t) { return states < 3; };
  bounds.always = {"\\forall a, b : 1 \\upto 30 @ a + b + n > 0"};
  const ExploreReport some =
      explored(schema("S", "n : 1 \\upto 300", "") + schema("Init", "S~'", "") + schema("Stay", "\\Xi S", ""), bounds);
  CHECK(some.stopped);
  CHECK(some.states == 3);
  CHECK(some.initial == 3);
}

TEST_CASE("an exploration whose time is over says so as a bound") {
  ExploreBounds bounds = plain();
  bounds.states = 1'000'000;
  bounds.seconds = 0.05;
  const ExploreReport report = explored(counter("1000000"), bounds);
  CHECK(report.late);
  CHECK_FALSE(report.stopped);
  CHECK(report.bounded == std::vector<std::string>{"states: --time"});
  CHECK(report.is_bounded());
  CHECK(report.states > 1);
  bounds.seconds = 1e6;
  CHECK_FALSE(explored(counter("3"), bounds).is_bounded());
}

TEST_CASE("an exploration whose time is over while it plans says so, and that it looked for nothing") {
  const Machine machine(read(counter("3")), members(2));
  ExploreBounds bounds = plain();
  bounds.always = {"n > 5"};
  bounds.seconds = 60;
  bounds.begun -= std::chrono::hours(1);
  StateSpace space(machine, bounds);
  const ExploreReport& late = space.explore();
  CHECK(late.late);
  CHECK_FALSE(late.planned);
  CHECK(late.states == 0);
  CHECK(late.initial == 0);
  CHECK(late.refuted.empty());
  CHECK(late.bounded == std::vector<std::string>{"states: --time"});
  REQUIRE(late.operations.size() == 1);
  CHECK(late.operations[0].facts.empty());
  CHECK_FALSE(late.operations[0].evaluated);
  CHECK(space.graph().states.empty());

  bounds.begun = std::chrono::steady_clock::now();
  const ExploreReport whole = StateSpace(machine, bounds).explore();
  CHECK(whole.planned);
  CHECK(whole.refuted.size() == 1);
  CHECK_FALSE(whole.is_bounded());

  bounds.go_on = [](std::size_t, std::size_t) { return false; };
  const ExploreReport stopped = StateSpace(machine, bounds).explore();
  CHECK(stopped.stopped);
  CHECK_FALSE(stopped.planned);
  CHECK(stopped.states == 0);
  CHECK(stopped.bounded.empty());
}

TEST_CASE("of operations that were planned before an exploration was stopped nothing is said") {
  const std::string text = counter(
      "3", schema("Never", "\\Delta S", "n > 5 \\\\ n' = n") + schema("Other", "\\Delta S", "n > 7 \\\\ n' = n"));
  std::size_t stops = 0;
  for (bool planned = false; !planned; ++stops) {
    std::size_t asked = 0;
    ExploreBounds bounds = plain();
    bounds.go_on = [&](std::size_t, std::size_t) { return ++asked <= stops; };
    const ExploreReport report = explored(text, bounds);
    planned = report.planned;
    for (const OperationCoverage& each : report.operations) CHECK((planned || each.facts.empty()));
  }
  CHECK(stops > 5);
}

TEST_CASE("a predicate that is none of a state is refused although the time is over") {
  ExploreBounds bounds = plain();
  bounds.seconds = 1;
  bounds.begun -= std::chrono::hours(1);
  bounds.always = {"m > 5"};
  CHECK_THROWS_AS(explored(counter("3"), bounds), zed::ZError);
}

/// Lights that go round, and may break.
std::string lights(const std::string& more) {
  return "\\begin{zed} L ::= red | green | off \\end{zed}\n" + schema("S", "l : L", "") +
         schema("Init", "S~'", "l' = red") + schema("Go", "\\Delta S", "l = red \\\\ l' = green") +
         schema("Stop", "\\Delta S", "l = green \\\\ l' = red") + more;
}

TEST_CASE("what is to come on every way is refuted by a way that ends, or goes round for ever") {
  ExploreBounds bounds = plain();
  bounds.eventually = {"l = green", "l = off"};
  bounds.leads_to = {{"l = red", "l = green"}, {"l = green", "l = off"}};
  const ExploreReport round = explored(lights(schema("Look", "\\Xi S", "")), bounds);
  REQUIRE(round.refuted.size() == 2);
  CHECK(round.refuted[0].claim == "eventually l = off");
  CHECK(round.refuted[0].loop == std::size_t{0});
  CHECK(round.refuted[0].way.size() == 3);  // red, green, and red again
  CHECK(round.refuted[1].claim == "l = green leads to l = off");
  REQUIRE(round.refuted[1].loop);
  CHECK(*round.refuted[1].loop == 1);

  const std::string breaks = schema("Break", "\\Delta S", "l = green \\\\ l' = off");
  const ExploreReport broken = explored(lights(breaks), bounds);
  CHECK(broken.refuted.size() == 2);  // it may go round, and never break
  bounds.leads_to.clear();
  bounds.fair = true;
  CHECK(explored(lights(breaks), bounds).refuted.size() == 1);  // in red it cannot break: to go round is fair
  const std::string always_breaks = schema("Break", "\\Delta S", "l \\neq off \\\\ l' = off");
  CHECK(explored(lights(always_breaks), bounds).refuted.size() == 1);
  bounds.eventually = {"l = off"};
  CHECK(explored(lights(always_breaks), bounds).refuted.empty());
  bounds.fair = false;
  CHECK(explored(lights(always_breaks), bounds).refuted.size() == 1);
  bounds.eventually = {"l = red"};
  CHECK(explored(lights(always_breaks), bounds).refuted.empty());
}

TEST_CASE("a way that a bound cuts off is no end") {
  ExploreBounds bounds = plain();
  bounds.eventually = {"n = 9"};
  bounds.states = 5;
  CHECK(explored(counter("20"), bounds).refuted.empty());
  bounds.states = 100;
  CHECK(explored(counter("8"), bounds).refuted.size() == 1);
  CHECK(explored(counter("20"), bounds).refuted.empty());
}

}  // namespace
}  // namespace durero::spec
