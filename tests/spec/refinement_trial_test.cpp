#include "durero/spec/refinement_trial.hpp"

#include <algorithm>
#include <fstream>
#include <sstream>

#include "support/catch.hpp"
#include "support/tree.hpp"

namespace durero::spec {
namespace {

using Catch::Matchers::Contains;

std::string source_of(const std::string& name) {
  std::ostringstream all;
  all << std::ifstream(durero::test::source_dir() + "/demo/" + name).rdbuf();
  return all.str();
}

/// A text and what stands instead of it.
using Change = std::pair<std::string, std::string>;

/// A demo's text with changes.
zed::Specification changed(const std::string& name, const std::vector<Change>& changes) {
  std::string text = source_of(name);
  for (const auto& [part, instead] : changes) {
    REQUIRE(text.find(part) != text.npos);
    text.replace(text.find(part), part.size(), instead);
  }
  auto read = zed::read_sources({{"birthday_book.tex", source_of("birthday_book.tex")}, {name, text}});
  if (!read.ok()) FAIL(read.defects.front().text());
  REQUIRE(zed::check(read).ok());
  return read;
}

zed::Specification changed(const std::string& name, const std::string& part, const std::string& instead) {
  return changed(name, {{part, instead}});
}
zed::Specification changed(const std::string& name) { return changed(name, std::vector<Change>()); }

const RefinementCall by_arrays{"BirthdayBook", "BirthdayBook1", "Abs"}, by_late_coin{"Coin", "Coin1", "AbsCoin"};

struct Tried {
  zed::Specification text;
  Refinement refinement;
  RefinementBounds bounds;
  RefinementTrial trial;

  std::string answer() const { return refinement_answer(text, refinement, bounds, trial); }
  const ObligationTrial& of(const std::string& label) const {
    const auto at = std::ranges::find_if(trial.all, [&](const auto& each) { return each.obligation.label == label; });
    REQUIRE(at != trial.all.end());
    return *at;
  }
  bool holds_but(const std::vector<std::string>& labels) const {
    return std::ranges::all_of(trial.all, [&](const ObligationTrial& each) {
      const bool excepted = std::ranges::find(labels, each.obligation.label) != labels.end();
      return excepted == each.counterexample.has_value() && (excepted || (each.held > 0 && each.open == 0));
    });
  }
};

Tried tried(zed::Specification text, const RefinementCall& call, std::size_t scope = 2) {
  Tried all{std::move(text), {}, {}, {}};
  all.refinement = refinement_of(all.text, zed::check(all.text), call);
  all.bounds.scope = scope;
  all.trial = try_refinement(all.text, all.refinement, all.bounds);
  return all;
}

RefinementCall backward(RefinementCall call) {
  call.backward = true;
  return call;
}

}  // namespace

TEST_CASE("the book's arrays refine the book, in every case of the scope") {
  const Tried arrays = tried(changed("birthday_book_arrays.tex"), by_arrays);
  CAPTURE(arrays.answer());
  CHECK(arrays.trial.functional);
  CHECK(arrays.trial.holds());
  CHECK(arrays.holds_but({}));
  // Of a scope of 1 there are hwm = 0 and 1; of 2, for each row of names and of dates, 8 of each: hwm = 0 and 1, and
  // hwm = 2 where the first two names differ: 64 + 64 + 4 · 8.
  CHECK(arrays.of("Abs.conj.1").held == 2 + 160);
  CHECK(arrays.of("InitBirthdayBook1.conj.1").held == 1 + 64);
  CHECK(arrays.trial.bounds[1] ==
        "scope 2: 160 pairs of states reached, all that these inputs lead to, 0 states listed, all of this scope");
}

TEST_CASE("a wrong index is found, and shown as a pair of traces") {
  const Tried wrong = tried(changed("birthday_book_wrong_index.tex"), by_arrays);
  CAPTURE(wrong.answer());
  CHECK(
      wrong.holds_but({"AddBirthday1.conj.1", "AddBirthday1.conj.2", "RAddBirthday1.conj.1", "RAddBirthday1.conj.2"}));
  CHECK_FALSE(wrong.trial.holds());
  const RefinementCounterexample& first = *wrong.of("AddBirthday1.conj.1").counterexample;
  CHECK(first.scope == 1);
  CHECK(first.reached);
  CHECK(first.abstract.size() == 2);
  CHECK(first.concrete.size() == 1);
  CHECK_THAT(wrong.answer(), Contains("AddBirthday1 may not follow: no state after satisfies it"));
  const RefinementCounterexample& second = *wrong.of("AddBirthday1.conj.2").counterexample;
  CHECK(second.scope == 2);
  CHECK_THAT(wrong.answer(), Contains("false is birthday' = birthday ∪ {name? ↦ date?}"));
}

TEST_CASE("an index that is wrong from the second name on is found by two steps from the beginning") {
  const Tried wrong =
      tried(changed("birthday_book_arrays.tex", "\\{ hwm' \\mapsto date?", "\\{ 1 \\mapsto date?"), by_arrays);
  CHECK(wrong.holds_but({"AddBirthday1.conj.2", "RAddBirthday1.conj.2"}));
  const RefinementCounterexample& found = *wrong.of("AddBirthday1.conj.2").counterexample;
  CHECK(found.reached);
  REQUIRE(found.concrete.size() == 3);
  CHECK(found.concrete[1].operation == "AddBirthday1");
  CHECK(found.abstract.back().operation == "(related by Abs)");
}

TEST_CASE("each planted fault falsifies the obligation that it is a fault of") {
  struct Fault {
    const char *part, *instead;
    std::vector<std::string> labels;
  };
  const std::vector<Fault> faults{
      {"hwm' = 0", "hwm' = 1", {"InitBirthdayBook1.conj.1"}},
      {"hwm' = hwm + 1", "hwm' = hwm + 1 \\land hwm < 1", {"AddBirthday1.conj.1", "RAddBirthday1.conj.1"}},
      {"name? = names(i) \\land date! = dates(i)",
       "name? = names(i) \\land date! = dates(1)",
       {"FindBirthday1.conj.2", "RFindBirthday1.conj.2"}},
      {"1 \\upto hwm | dates(i) = today?", "0 \\upto hwm | dates(i) = today? \\land i < hwm", {"Remind1.conj.2"}},
      {"result! = not\\_known  % NotKnown1",
       "result! = ok  % NotKnown1",
       {"NotKnown1.conj.2", "RFindBirthday1.conj.2"}},
  };
  for (const Fault& fault : faults) {
    const Tried wrong = tried(changed("birthday_book_arrays.tex", fault.part, fault.instead), by_arrays);
    CAPTURE(fault.part, wrong.answer());
    CHECK(wrong.holds_but(fault.labels));
  }
}

TEST_CASE("a retrieve schema that is no function is tried by the rules of a relation") {
  // No name of the book need be the one at its place: several books are related to the arrays.
  const Tried loose =
      tried(changed("birthday_book_arrays.tex", "\\forall i : 1 \\upto hwm @ birthday(names(i)) = dates(i)",
                    "\\ran birthday = \\{~ i : 1 \\upto hwm @ dates(i) ~\\}"),
            by_arrays);
  CAPTURE(loose.answer());
  CHECK_FALSE(loose.trial.functional);
  CHECK(loose.trial.all.front().obligation.kind == ObligationKind::initialisation);
  CHECK(loose.of("FindBirthday1.conj.2").counterexample);
  CHECK(loose.of("AddBirthday1.conj.1").held > 0);
}

TEST_CASE("the late coin is no forward simulation, and is a backward one") {
  const Tried forward = tried(changed("coin.tex"), by_late_coin);
  CAPTURE(forward.answer());
  CHECK(forward.holds_but({"Look1.conj.2"}));
  REQUIRE(forward.of("Look1.conj.2").counterexample);
  CHECK(forward.of("Look1.conj.2").counterexample->reached);
  CHECK(forward.of("Look1.conj.2").counterexample->concrete.size() == 3);
  const Tried back = tried(changed("coin.tex"), backward(by_late_coin));
  CAPTURE(back.answer());
  CHECK(back.trial.holds());
  CHECK(back.trial.all.front().obligation.kind == ObligationKind::total);
}

TEST_CASE("faults of a backward simulation are found") {
  struct Fault {
    const char *part, *instead, *label;
  };
  for (const Fault& fault : {
           Fault{"tossed' = no  % Look1.post.1", "tossed' = yes  % Look1.post.1", "Look1.conj.2"},
           Fault{"tossed = no \\iff hand = empty", "tossed = no \\land hand = empty", "AbsCoin.conj.1"},
           Fault{"tossed' = no  % InitCoin1.post.1", "tossed' = yes  % InitCoin1.post.1", "InitCoin1.conj.1"},
           Fault{"tossed = yes  % Look1.pre.1", "tossed = yes \\land tossed = no  % Look1.pre.1", "Look1.conj.1"},
           Fault{"tossed = no  % Toss1.pre.1", "true  % Toss1.pre.1", "none"},
       }) {
    const Tried wrong = tried(changed("coin.tex", fault.part, fault.instead), backward(by_late_coin));
    CAPTURE(fault.part, wrong.answer());
    if (fault.label == std::string("none")) {
      CHECK(wrong.trial.holds());  // where Toss may not happen, Toss1 may do anything
    } else {
      CHECK(wrong.of(fault.label).counterexample);
    }
  }
}

TEST_CASE("a coin that is drawn anew at each look is no refinement of one that stays") {
  const Tried wrong = tried(changed("coin.tex", {{"hand' = empty  % Look.post.2", "hand' = hand  % Look.post.2"},
                                                 {"tossed' = no  % Look1.post.1", "tossed' = yes  % Look1.post.1"}}),
                            backward(by_late_coin));
  CAPTURE(wrong.answer());
  CHECK(wrong.holds_but({"Look1.conj.2"}));
}

TEST_CASE("an obligation without a case, or that is not decided, is no obligation that holds") {
  const Tried never =
      tried(changed("coin.tex", "tossed' = yes  % Toss1", "tossed' = yes \\land tossed = yes  % Toss1"), by_late_coin);
  CHECK_FALSE(never.trial.holds());
  CHECK(never.of("Toss1.conj.2").held == 0);
  CHECK_THAT(never.answer(), Contains("NOT TRIED: no case of it was found"));
  // Whether some number of all ℕ satisfies the abstract operation is not known where none of the scope does.
  const Tried open = tried(changed("coin.tex", "hand' = empty  % Look.post.2",
                                   "hand' = empty \\\\ \\exists n : \\nat @ n * n * n = n + 60  % Look.post.2"),
                           by_late_coin);
  CAPTURE(open.answer());
  CHECK_FALSE(open.trial.holds());
}

TEST_CASE("a scope in which the constants of the text have no values says nothing") {
  // With one member of NAME there are no two, and only there does Go1 refuse
  // nothing that Go admits.
  auto text = zed::read_text(R"(
\begin{zed} [NAME] \end{zed}
\begin{axdef} a, b : NAME \where a \neq b \end{axdef}
\begin{schema}{S} x : NAME \end{schema}
\begin{schema}{InitS} S~' \end{schema}
\begin{schema}{Go} \Delta S \where x' = x \end{schema}
\begin{schema}{S1} y : NAME \end{schema}
\begin{schema}{R} S; S1 \where x = y \end{schema}
\begin{schema}{InitS1} S1~' \end{schema}
\begin{schema}{Go1} \Delta S1 \where y' = y \land (\forall z : NAME @ z = y) \end{schema}
)",
                             "two.tex");
  REQUIRE(text.ok());
  const Tried one = tried(text, {"S", "S1", "R"}, 1);
  CAPTURE(one.answer());
  CHECK(one.trial.bounds[0] == "scope 1: the constants of the text have no values in it");
  CHECK_FALSE(one.trial.holds());
  CHECK(std::ranges::all_of(one.trial.all, [](const auto& each) { return each.held == 0 && !each.counterexample; }));
  const Tried two = tried(text, {"S", "S1", "R"});
  REQUIRE(two.of("Go1.conj.1").counterexample);
  CHECK(two.of("Go1.conj.1").counterexample->scope == 2);
}

TEST_CASE("what only a value outside of the scope would make true is not decided") {
  auto text = zed::read_text(R"(
\begin{schema}{S} n : \nat \end{schema}
\begin{schema}{InitS} S~' \where n' = 0 \end{schema}
\begin{schema}{Jump} \Delta S \where n' * n' * n' = n' + 999900 \end{schema}
\begin{schema}{S1} m : \nat \end{schema}
\begin{schema}{R} S; S1 \where n = m \end{schema}
\begin{schema}{InitS1} S1~' \where m' = 0 \end{schema}
\begin{schema}{Jump1} \Delta S1 \where m' = 100 \end{schema}
)",
                             "far.tex");
  REQUIRE(text.ok());
  const Tried far = tried(text, {"S", "S1", "R"});
  CAPTURE(far.answer());
  CHECK(far.of("Jump1.conj.1").open > 0);
  CHECK(far.of("Jump1.conj.1").held == 0);
  CHECK_FALSE(far.of("Jump1.conj.1").counterexample);
  CHECK_THAT(far.answer(), Contains("not decided: the values of n' do not end with the scope"));
}

}  // namespace durero::spec
