/// What is searched for against what is gone through: any condition of x : ℕ with x ≤ n holds of the same numbers as of
/// x : 0‥n. Definitions and conditions are random; their meaning is told apart from the evaluator's (random_cases.hpp).

#include <fmt/format.h>

#include <cstdlib>
#include <map>

#include "durero/zed/evaluate/evaluate.hpp"
#include "durero/zed/syntax/parser.hpp"
#include "durero/zed/types/typecheck.hpp"
#include "support/catch.hpp"
#include "support/sanitized.hpp"
#include "zed/evaluate/random_cases.hpp"

namespace durero::zed::test {
namespace {

constexpr Number last = 4;
constexpr std::uint64_t most_steps = 200'000;

/// What came of questions, by their form.
struct Counts {
  std::size_t asked = 0, open = 0;
};
using Tally = std::map<std::string, Counts>;

/// A question, what the evaluator says, and what is right; nothing where it is not decided.
struct Answer {
  std::string form, z, said, right;
};

const char* said(bool truth) { return truth ? "true" : "false"; }

std::string of_truth(Truth truth) {
  if (truth == Truth::open) throw EvaluationError("open");
  return said(truth == Truth::yes);
}

/// The evaluator of one world, and what is so of x in it.
class Asked {
 public:
  explicit Asked(const std::string& text) : steps_(most_steps), evaluator_(sections(text), {}, &steps_) {}

  std::string truth(const std::string& predicate) {
    return decided([&] { return of_truth(evaluator_.holds(parse_unicode(predicate))); });
  }

  /// The members of a set of numbers; of one that is known by membership, those in 0‥last + 1.
  std::string members(const std::string& expression) {
    return decided([&] {
      const Value set = evaluator_.value(parse_unicode(expression));
      if (!set.set()) throw EvaluationError("open");
      if (set.set()->members()) return set.text();
      std::vector<Value> found;
      for (Number n = 0; n <= last + 1; ++n)
        if (of_truth(evaluator_.contains(set, Real(static_cast<double>(n)))) == said(true))
          found.emplace_back(Real(static_cast<double>(n)));
      return Value::set(std::move(found)).text();
    });
  }

  std::string value(const std::string& expression) {
    return decided([&] {
      const Value value = evaluator_.value(parse_unicode(expression));
      if (value.is_open() || (value.set() && !value.set()->members())) throw EvaluationError("open");
      return value.text();
    });
  }

 private:
  static std::vector<Section> sections(const std::string& text) {
    const Specification read = read_text(text, "random");
    INFO(text);
    REQUIRE(read.defects.empty());
    return read.sections;
  }

  template <class Ask>
  std::string decided(Ask&& ask) {
    steps_ = Steps(most_steps);
    try {
      return ask();
    } catch (const EvaluationError&) {
      return {};
    } catch (const StepsSpent&) {
      return {};
    }
  }

  Steps steps_;
  Evaluator evaluator_;
};

/// Those numbers of 0‥last of which it is so, with y = 0.
std::vector<Number> numbers(const Condition& is_so) {
  std::vector<Number> found;
  for (Number n = 0; n <= last; ++n)
    if (is_so.means({n})) found.push_back(n);
  return found;
}

std::string set_text(const std::vector<Number>& found) {
  std::vector<Value> values;
  for (const Number n : found) values.emplace_back(Real(static_cast<double>(n)));
  return Value::set(std::move(values)).text();
}

/// Ways to say that x ≤ 4 of a natural number.
const std::vector<std::string>& bounds() {
  static const std::vector<std::string> all = {"x ≤ 4",
                                               "¬ x > 4",
                                               "2 * x < 10",
                                               "x ∈ 0 ‥ 4",
                                               "x ∈ {k : ℕ | k ≤ 4}",
                                               "(∃ k : 0 ‥ 4 • x = k)",
                                               "(x ≤ 2 ∨ x = 3 ∨ x = 4)",
                                               "(∃ k : ℕ • x + k = 4)",
                                               "(x, 0) ∈ {k, l : ℕ | k ≤ 4 ∧ l = 0}"};
  return all;
}

/// Of one unknown number.
Answer of_one(Asked& asked, const Condition& is_so, Random& random) {
  const std::vector<Number> right = numbers(is_so);
  const std::string& p = is_so.z;
  const std::string& bound = random.one_of(bounds());
  const auto ask = [&](const char* form, const std::string& z, const std::string& expected, auto&& by) {
    return Answer{form, z, by(z), expected};
  };
  const auto truth = [&](const std::string& z) { return asked.truth(z); };
  const auto members = [&](const std::string& z) { return asked.members(z); };
  const auto value = [&](const std::string& z) { return asked.value(z); };
  switch (random.below(8)) {
    case 0:
      return ask("∃ bound first", fmt::format("∃ x : ℕ • {} ∧ ({})", bound, p), said(!right.empty()), truth);
    case 1:
      return ask("∃ bound last", fmt::format("∃ x : ℕ | {} • {}", p, bound), said(!right.empty()), truth);
    case 2:
      return ask("∀", fmt::format("∀ x : ℕ | {} • {}", bound, p), said(right.size() == last + 1), truth);
    case 3:
      return ask("∃₁", fmt::format("∃₁ x : ℕ • ({}) ∧ {}", p, bound), said(right.size() == 1), truth);
    case 4:
      return ask("{ }", fmt::format("{{x : ℕ | {} ∧ ({})}}", bound, p), set_text(right), members);
    case 5:
      return ask("{ } without a bound", fmt::format("{{x : ℕ | {}}} ∩ (0 ‥ {})", p, last), set_text(right), members);
    case 6:
      return ask("μ", fmt::format("(μ x : ℕ | ({}) ∧ {})", p, bound),
                 right.size() == 1 ? std::to_string(right.front()) : "undefined", value);
    default: {
      Answer answer = ask("∃ without a bound", fmt::format("∃ x : ℕ • {}", p), said(true), truth);
      if (right.empty()) answer.said = answer.right;  // there may be one further on
      return answer;
    }
  }
}

/// Of an unknown number beside one of a finite set, in both orders.
Answer of_two(Asked& asked, const Condition& is_so, Random& random) {
  std::vector<Value> right;
  for (Number x = 0; x <= last; ++x)
    for (Number y = 0; y <= 2; ++y)
      if (is_so.means({x, y})) right.push_back(Value::pair(Real(static_cast<double>(x)), Real(static_cast<double>(y))));
  const bool some = !right.empty();
  const std::string& p = is_so.z;
  const std::string& bound = random.one_of(bounds());
  switch (random.below(3)) {
    case 0: {
      const std::string z = fmt::format("∃ x : ℕ; y : 0 ‥ 2 • ({}) ∧ {}", p, bound);
      return {"∃ of two", z, asked.truth(z), said(some)};
    }
    case 1: {
      const std::string z = fmt::format("∃ x, y : ℕ • {} ∧ y ≤ 2 ∧ ({})", bound, p);
      return {"∃ of two unknowns", z, asked.truth(z), said(some)};
    }
    default: {
      const std::string z = fmt::format("{{x : ℕ; y : 0 ‥ 2 | {} ∧ ({})}}", bound, p);
      return {"{ } of two", z, asked.value(z), Value::set(std::move(right)).text()};
    }
  }
}

/// Asks so many questions of the worlds of a seed, a world for each forty.
void ask(std::uint64_t seed, std::size_t questions, Tally& tally) {
  for (std::size_t asked = 0; asked < questions; ++seed) {
    Random random(seed);
    const World world = random_world(random);
    Asked evaluator(world.text);
    for (int i = 0; i < 40 && asked < questions; ++i) {
      const bool two = random.below(4) == 0;
      Maker maker(world, random);
      const Condition is_so = maker.condition(1 + static_cast<int>(random.below(3)), two ? 2 : 1);
      try {
        const Answer answer = two ? of_two(evaluator, is_so, random) : of_one(evaluator, is_so, random);
        ++asked;
        Counts& counts = tally[answer.form];
        ++counts.asked;
        counts.open += answer.said.empty() ? 1 : 0;
        if (answer.said.empty() || answer.said == answer.right) continue;
        FAIL_CHECK(world.text << answer.z << "\n  is " << answer.right << " and not " << answer.said
                              << "\nDURERO_SEED=" << seed << " runs this again");
        return;
      } catch (const TooFar&) {
        continue;
      }
    }
  }
}

std::uint64_t chosen_seed() {
  const char* seed = std::getenv("DURERO_SEED");
  return seed ? std::strtoull(seed, nullptr, 10) : 1;
}

/// Asks, and says how many in a thousand are not decided.
std::size_t undecided(std::size_t questions) {
  Tally tally;
  ask(chosen_seed(), questions, tally);
  Counts all;
  std::string table;
  for (const auto& [form, counts] : tally) {
    table += fmt::format("{:>8} of {:>8} not decided: {}\n", counts.open, counts.asked, form);
    all.asked += counts.asked;
    all.open += counts.open;
  }
  WARN(table);
  return all.asked == 0 ? 0 : 1000 * all.open / all.asked;
}

// In a thousand: measured of a million, and it may only fall. Of the few that the sanitizers try it says nothing.
constexpr std::size_t most_undecided = 26;

TEST_CASE("what is searched for is what is found by going through") {
  const std::size_t open = undecided(durero::test::fewer_when_sanitized(4000));
  CHECK((open <= most_undecided || durero::test::sanitized));
}

TEST_CASE("what is searched for is what is found by going through, a million times", "[long]") {
  const std::size_t open = undecided(durero::test::fewer_when_sanitized(1'000'000));
  CHECK((open <= most_undecided || durero::test::sanitized));
}

}  // namespace
}  // namespace durero::zed::test
