#include "durero/spec/animation.hpp"

#include <fstream>
#include <set>
#include <sstream>

#include "durero/spec/spec.hpp"
#include "support/catch.hpp"
#include "support/tree.hpp"

namespace durero::spec {
namespace {

using Catch::Matchers::Contains;
using zed::Truth;

std::string book_text() {
  std::ostringstream all;
  all << std::ifstream(durero::test::source_dir() + "/demo/birthday_book.tex").rdbuf();
  return all.str();
}

zed::Specification book() {
  auto read = zed::read_text(book_text(), "birthday_book.tex");
  REQUIRE(read.ok());
  return read;
}

Setup two_people() {
  Setup setup;
  setup.given["NAME"] = {"ann", "bob"};
  setup.members = 2;
  return setup;
}

zed::Valuation input(const Machine& machine, const std::string& name, const std::string& value) {
  const zed::Name of{name, "?"};
  return {{of, machine.typed(value, of)}};
}

std::string component(const Machine& machine, const zed::Valuation& state, const std::string& name) {
  for (const auto& [of, value] : state)
    if (of.text() == name) return machine.written(of, value);
  return "nothing";
}

TEST_CASE("a text is a machine by its conventions") {
  const Machine machine(book(), two_people());
  CHECK(machine.state() == "BirthdayBook");
  CHECK(machine.init() == "InitBirthdayBook");
  CHECK(machine.components() == std::vector<zed::Name>{{"known", ""}, {"birthday", ""}});
  std::string names;
  for (const auto& operation : machine.operations()) names += operation.name + " ";
  CHECK(names == "AddBirthday AlreadyKnown FindBirthday NotKnown RAddBirthday RFindBirthday Remind ");
  CHECK(machine.find("AddBirthday")->inputs == std::vector<zed::Name>{{"date", "?"}, {"name", "?"}});
  CHECK(machine.find("Nobody") == nullptr);
  CHECK(machine.carriers() == std::vector<std::string>{"DATE == {DATE1, DATE2}", "NAME == {ann, bob}"});
}

TEST_CASE("an operation goes on by its text, and finds the inputs that are not given") {
  const Machine machine(book(), two_people());
  const ReachedTransitions first = machine.initial(5);
  REQUIRE(first.transitions.size() == 1);
  CHECK_FALSE(first.undecided);
  const zed::Valuation empty = first.transitions[0].after;
  CHECK(component(machine, empty, "birthday") == "∅[NAME × DATE]");
  const auto& add = *machine.find("AddBirthday");
  const ReachedTransitions all = machine.steps(empty, add, {}, 10);
  CHECK(all.transitions.size() == 4);  // two people, two dates
  CHECK(all.bounded.empty());
  const ReachedTransitions of_ann = machine.steps(empty, add, input(machine, "name", "ann"), 10);
  REQUIRE(of_ann.transitions.size() == 2);
  const zed::Valuation after = of_ann.transitions[0].after;
  CHECK(component(machine, after, "birthday") == "{ann ↦ DATE1}");
  CHECK(component(machine, after, "known") == "{ann}");
  CHECK(machine.steps(after, add, input(machine, "name", "ann"), 10).transitions.empty());
  const ReachedTransitions found = machine.steps(after, *machine.find("FindBirthday"), {}, 10);
  REQUIRE(found.transitions.size() == 1);
  CHECK(machine.written({"date", "!"}, found.transitions[0].outputs[0].second) == "DATE1");
  CHECK(found.transitions[0].after[1].first.text() == "birthday");
  CHECK(machine.steps(empty, add, {}, 3).bounded == "--choices");
}

/// A counter whose operation leaves the number after it open, and may say a number too.
zed::Specification loose(const std::string& predicates) {
  const std::string schema = "\\begin{schema}";
  auto read =
      zed::read_text(schema + "{S} x : \\num \\end{schema}\n" + schema + "{Init} S~' \\where x' = 10 \\end{schema}\n" +
                         schema + "{Op} \\Delta S \\\\ n! : \\nat \\where " + predicates + "\\end{schema}\n",
                     "loose.tex");
  REQUIRE(read.ok());
  return read;
}

TEST_CASE("what equations leave open is tried near the state before, and judged by the text") {
  const Machine machine(loose("x' > x \\land n! = x'"), {});
  const zed::Valuation ten = machine.initial(1).transitions[0].after;
  const ReachedTransitions found = machine.steps(ten, *machine.find("Op"), {}, 9);
  CHECK(found.undecided);  // there are 13, 14 and so on
  CHECK(name_list(found.tried) == "x'");
  REQUIRE(found.transitions.size() == 2);
  for (const Transition& step : found.transitions) CHECK(machine.is_step(ten, step) == Truth::yes);
  CHECK(component(machine, found.transitions[1].after, "x") == "12");
  CHECK(machine.steps(ten, *machine.find("Op"), {}, 1).bounded == "--choices");
  const Machine none(loose("x' > x + 2 \\land n! = x'"), {});
  CHECK(none.steps(ten, *none.find("Op"), {}, 9).transitions.empty());
  Setup further;
  further.numbers = 3;
  const Machine some(loose("x' > x + 2 \\land n! = x'"), further);
  CHECK(some.steps(ten, *some.find("Op"), {}, 9).transitions.size() == 1);
}

TEST_CASE("an input from a finite set of numbers has all of them") {
  const std::string schema = "\\begin{schema}";
  auto read =
      zed::read_text(schema + "{S} x : \\num \\end{schema}\n" + schema + "{Init} S~' \\where x' = 0 \\end{schema}\n" +
                         schema + "{Op} \\Delta S \\\\ n? : 5 \\upto 8 \\where x' = n? \\end{schema}\n",
                     "finite.tex");
  REQUIRE(read.ok());
  const Machine machine(read, {});
  const ReachedTransitions found = machine.steps(machine.initial(1).transitions[0].after, *machine.find("Op"), {}, 9);
  CHECK(found.transitions.size() == 4);
  CHECK(found.bounded.empty());
}

TEST_CASE("of what is left open no name is tried that an equation gives") {
  const std::string schema = "\\begin{schema}";
  auto read = zed::read_text(schema + "{S} given, left, other : \\num \\end{schema}\n" + schema +
                                 "{Init} S~' \\where given' = left' = other' = 0 \\end{schema}\n" + schema +
                                 "{Op} \\Delta S \\where given' = 1000 \\land left' > left \\land other' < other "
                                 "\\end{schema}\n",
                             "loose.tex");
  REQUIRE(read.ok());
  const Machine machine(read, {});
  const zed::Valuation begun = machine.initial(1).transitions[0].after;
  const ReachedTransitions found = machine.steps(begun, *machine.find("Op"), {}, 9);
  CHECK(name_list(found.tried) == "left', other'");
  REQUIRE(found.transitions.size() == 4);
  for (const Transition& step : found.transitions) CHECK(component(machine, step.after, "given") == "1000");
}

TEST_CASE("what is tried of a loose operation is bounded") {
  Setup few;
  few.inputs = 3;
  const Machine machine(loose("x' > x \\land n! < x'"), few);
  const zed::Valuation ten = machine.initial(1).transitions[0].after;
  const ReachedTransitions found = machine.steps(ten, *machine.find("Op"), {}, 1000);
  CHECK(found.bounded == "--inputs");
  few.inputs = 1000;
  few.steps = 40;
  const Machine short_of_steps(loose("x' > x \\land n! < x'"), few);
  CHECK(short_of_steps.steps(ten, *short_of_steps.find("Op"), {}, 1000).bounded == "--steps");
}

TEST_CASE("a total operation goes on by whichever side of the disjunction holds") {
  const Machine machine(book(), two_people());
  const zed::Valuation empty = machine.initial(1).transitions[0].after;
  const auto& find = *machine.find("RFindBirthday");
  const ReachedTransitions none = machine.steps(empty, find, input(machine, "name", "bob"), 10);
  REQUIRE_FALSE(none.transitions.empty());
  for (const Transition& step : none.transitions) {
    CHECK(machine.is_step(empty, step) == Truth::yes);
    CHECK(machine.written({"result", "!"}, step.outputs.back().second) == "not_known");
  }
}

TEST_CASE("each predicate says its truth, and a wrong step is none") {
  const Machine machine(book(), two_people());
  const zed::Valuation empty = machine.initial(1).transitions[0].after;
  for (const zed::ConjunctTruth& finding : machine.invariant(empty)) CHECK(finding.truth == Truth::yes);
  const auto findings = machine.preconditions(empty, *machine.find("FindBirthday"), input(machine, "name", "ann"));
  const auto refused = std::find_if(findings.begin(), findings.end(),
                                    [](const auto& finding) { return finding.label == "FindBirthday.pre.1"; });
  REQUIRE(refused != findings.end());
  CHECK(refused->truth == Truth::no);
  Transition step = machine.steps(empty, *machine.find("AddBirthday"), {}, 1).transitions[0];
  CHECK(machine.is_step(empty, step) == Truth::yes);
  step.after = empty;
  CHECK(machine.is_step(empty, step) == Truth::no);
}

TEST_CASE("a way is saved as text and replayed, and any change of it is refused at its place") {
  const Machine machine(book(), two_people());
  Animation way(machine);
  way.take(machine.initial(1).transitions[0]);
  way.take(machine.steps(*way.now(), *machine.find("AddBirthday"), {}, 1).transitions[0]);
  way.take(machine.steps(*way.now(), *machine.find("FindBirthday"), {}, 1).transitions[0]);
  const std::string text = way.saved();
  Animation again(machine);
  again.replay(text);
  CHECK(again.way() == way.way());
  CHECK(again.saved() == text);
  CHECK(again.back());
  CHECK(again.back());
  CHECK_FALSE(again.back());
  CHECK(again.way().size() == 1);
  for (const auto& [old, now, place, words] : std::vector<std::tuple<std::string, std::string, unsigned, std::string>>{
           {"durero-trace 1", "durero-trace 2", 1, "another version"},
           {"NAME == {ann, bob}", "NAME == {ann}", 3, "another text"},
           {"step AddBirthday", "step Add", 8, "Add is no operation"},
           {"known' == {ann}", "known' == {bob}", 8, "AddBirthday does not allow this step"},
           {"known' == {ann}", "known' == {eve}", 11, "eve is not declared"},
           {"known' == {ann}", "known' == 3", 11, "between"},
           {"  known' == {ann}\n", "", 8, "the step says no known'"},
           {"name? == ann", "nome? == ann", 10, "AddBirthday has no nome?"},
       }) {
    CAPTURE(old, now);
    std::string changed = text;
    REQUIRE(changed.find(old) != changed.npos);
    changed.replace(changed.find(old), old.size(), now);
    try {
      again.replay(changed);
      FAIL("it is replayed");
    } catch (const zed::ZError& error) {
      CHECK(error.place.line == place);
      CHECK_THAT(error.what_is_wrong, Contains(words));
    }
    CHECK(again.way().size() == 1);
  }
}

TEST_CASE("a damaged trace is refused or is another way that the text allows") {
  const Machine machine(book(), two_people());
  Animation way(machine);
  way.take(machine.initial(1).transitions[0]);
  way.take(machine.steps(*way.now(), *machine.find("AddBirthday"), {}, 1).transitions[0]);
  const std::string text = way.saved();
  std::size_t refused = 0;
  for (std::size_t at = 0; at < text.size(); ++at)
    for (const char* instead : {"", "x", "\n", "{"}) {
      std::string damaged = text;
      damaged.replace(at, 1, instead);
      Animation again(machine);
      try {
        again.replay(damaged);
        for (std::size_t i = 1; i < again.way().size(); ++i)
          CHECK(machine.is_step(again.way()[i - 1].after, again.way()[i]) == Truth::yes);
      } catch (const zed::ZError& error) {
        ++refused;
        CHECK(error.place.line >= 1);
        CHECK(again.way().empty());
      }
    }
  CHECK(refused > 3 * text.size());
}

TEST_CASE("all states are explored, and a false conjecture is shown with the way to it") {
  const Machine machine(book(), two_people());
  const Exploration exploration = explore(machine, {}, 100);
  REQUIRE(exploration.refuted);
  CHECK_THAT(exploration.refuted->claim, Contains("NAME ⤔ DATE"));
  REQUIRE(exploration.way.size() == 3);  // nobody, one person, another with the same birthday
  CHECK(component(machine, exploration.way[2].after, "known") == "{ann, bob}");

  std::string without = book_text();
  const std::size_t last = without.rfind("\\begin{zed}");
  const auto read = zed::read_text(without.substr(0, last), "book.tex");
  const Machine sound(read, two_people());
  const Exploration whole = explore(sound, {}, 100);
  CHECK_FALSE(whole.refuted);
  CHECK(whole.states == 9);  // each of two people has no birthday, or one of two
  CHECK(whole.bounded.empty());
  CHECK(whole.open == 0);
  CHECK(whole.claims > 9);
  const Exploration few = explore(sound, {}, 4);
  CHECK(few.states == 4);
  CHECK(few.bounded == std::vector<std::string>{"states: --states"});
}

TEST_CASE("an exploration is a graph of states, each once, and of the transitions between them") {
  std::string without = book_text();
  const auto read = zed::read_text(without.substr(0, without.rfind("\\begin{zed}")), "book.tex");
  const Machine machine(read, two_people());
  StateGraph graph;
  const Exploration whole = explore(machine, {}, 100, &graph);
  CHECK(graph.states.size() == 9);
  CHECK(graph.initial == 1);
  CHECK(component(machine, graph.states[0], "known") == "∅[NAME]");
  CHECK(graph.steps.size() == whole.transitions);
  std::set<std::size_t> reached{0};
  for (const StateGraph::Edge& edge : graph.steps) {
    REQUIRE(edge.from < 9);
    REQUIRE(edge.to < 9);
    reached.insert(edge.to);
    CHECK(machine.is_step(graph.states[edge.from], edge.step) == Truth::yes);
    for (std::size_t i = 0; i < edge.step.after.size(); ++i)
      CHECK(zed::same(edge.step.after[i].second, graph.states[edge.to][i].second));
  }
  CHECK(reached.size() == 9);
  StateGraph few;
  explore(machine, {}, 4, &few);
  CHECK(few.states.size() == 4);
  for (const StateGraph::Edge& edge : few.steps) CHECK(edge.to < 4);
  CHECK(machine.type_text({"known", ""}) == "ℙ NAME");
  CHECK(machine.type_text({"date", "?"}) == "DATE");
}

TEST_CASE("a conjecture of a state and of more is tried in the state, for all that the more may be") {
  const auto claims = [](const std::string& text, std::uint64_t steps) {
    Setup setup = two_people();
    setup.steps = steps;
    const Machine machine(zed::read_text(book_text() + "\\begin{zed} " + text + " \\end{zed}\n", "book.tex"), setup);
    Animation way(machine);
    way.take(machine.initial(1).transitions[0]);
    way.take(machine.steps(*way.now(), *machine.find("AddBirthday"), {}, 1).transitions[0]);
    return machine.conjectures(*way.before(), way.way().back());
  };
  for (const auto& [claim, truth] :
       {std::pair("\\vdash? \\forall BirthdayBook; n, m : NAME | n \\in known @ m \\in known \\lor n \\neq m",
                  Truth::yes),
        std::pair("\\vdash? \\forall BirthdayBook; n : NAME @ n \\in known", Truth::no),
        std::pair("\\vdash? \\forall BirthdayBook; k : \\nat @ k * k * k \\geq k", Truth::open)}) {
    INFO(claim);
    const ConjectureResult last = claims(claim, 1000000).back();
    CHECK(last.of_states);
    CHECK(last.truth == truth);
  }
  const std::string all_of_many = "\\vdash? \\forall BirthdayBook; i, j, k : 1 \\upto 50 @ i + j + k \\geq 3";
  CHECK(claims(all_of_many, 1000000).back().truth == Truth::yes);
  CHECK(claims(all_of_many, 10000).back().truth == Truth::open);
}

TEST_CASE("the program's own text is a machine too") {
  Setup setup;
  setup.given["Elemento"] = {"bola"};
  setup.numbers = 1;
  setup.state = "Escena";  // without it, Mallas, which has a component more
  const Machine machine(text(), setup);
  CHECK(machine.state() == "Escena");
  const ReachedTransitions first = machine.initial(5);
  REQUIRE(first.transitions.size() == 1);
  const zed::Valuation empty = first.transitions[0].after;
  CHECK(component(machine, empty, "mi_centro") == "∅[Elemento × [x : 𝔸; y : 𝔸; z : 𝔸]]");
  const ReachedTransitions ball =
      machine.steps(empty, *machine.find("Agregar_Esfera"), input(machine, "radio", "1"), 3);
  REQUIRE(ball.transitions.size() == 3);
  CHECK(ball.bounded == "--choices");
  CHECK(component(machine, ball.transitions[0].after, "mi_radio") == "{bola ↦ 1}");
  CHECK(machine.is_step(empty, ball.transitions[0]) == Truth::yes);
}

TEST_CASE("what is no machine is refused") {
  const auto only_state = zed::read_text("\\begin{schema}{S}\n  x : \\nat\n\\end{schema}\n", "s.tex");
  CHECK_THROWS_WITH(Machine(only_state, {}), Contains("the text has no state"));
  Setup setup;
  setup.state = "Nada";
  CHECK_THROWS_WITH(Machine(book(), setup), Contains("no schema Nada"));
  setup = {};
  setup.init = "AddBirthday";
  CHECK_THROWS_WITH(Machine(book(), setup), Contains("AddBirthday is no initial schema"));
  setup = {};
  setup.given["NADIE"] = {"a"};
  CHECK_THROWS_WITH(Machine(book(), setup), Contains("no given set NADIE"));
  setup = {};
  setup.given["NAME"] = {"known", "dom"};
  CHECK_THROWS_WITH(Machine(book(), setup), Contains("dom cannot name a member of NAME"));
}

}  // namespace
}  // namespace durero::spec
