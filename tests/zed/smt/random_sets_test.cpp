/// Random predicates of sets, functions and sequences are translated, and z3 is asked: what it says is the evaluator's
/// enumeration. The same variables are declared from small sets, and from infinite ones with a condition.
#include <cstdlib>
#include <map>

#include "durero/zed/smt/smt.hpp"
#include "durero/zed/syntax/parser.hpp"
#include "support/catch.hpp"
#include "zed/evaluate/random_cases.hpp"
#include "zed/smt/z3.hpp"

namespace durero::zed::test {
namespace {

/// A variable with its small set, and a wider one in which `within` makes the same of it.
struct SetVariable {
  std::string name, kind, small, wide, within;
};

const std::vector<SetVariable>& set_variables() {
  static const std::vector<SetVariable> all = {
      {"s", "set", "ℙ (0 ‥ 2)", "ℙ ℤ", "s ⊆ 0 ‥ 2"},
      {"t", "set", "𝔽₁ (0 ‥ 1)", "ℙ₁ ℕ", "t ⊆ 0 ‥ 1"},
      {"f", "relation", "0 ‥ 1 ⇸ 0 ‥ 2", "ℤ ⇸ ℤ", "dom f ⊆ 0 ‥ 1 ∧ ran f ⊆ 0 ‥ 2"},
      {"g", "relation", "0 ‥ 1 → 0 ‥ 1", "ℕ ⇻ 0 ‥ 1", "dom g = 0 ‥ 1"},
      {"h", "relation", "0 ‥ 2 ⤔ 0 ‥ 1", "ℤ ⤔ ℕ", "h ∈ 0 ‥ 2 ⇸ 0 ‥ 1"},
      {"r", "relation", "0 ‥ 1 ↔ 0 ‥ 1", "ℤ ↔ ℤ", "r ⊆ (0 ‥ 1) × (0 ‥ 1)"},
      {"q", "sequence", "{⟨⟩, ⟨0⟩, ⟨1⟩, ⟨0, 0⟩, ⟨0, 1⟩, ⟨1, 0⟩, ⟨1, 1⟩}", "seq (0 ‥ 1)", "# q ≤ 2"},
      {"p", "sequence", "iseq (0 ‥ 1)", "seq ℤ", "p ∈ iseq (0 ‥ 1)"},
      {"u", "family", "ℙ (ℙ (0 ‥ 1))", "ℙ (ℙ ℤ)", "⋃ u ⊆ 0 ‥ 1"},
      {"k", "table", "{0} × (0 ‥ 1) ⇸ 0 ‥ 1", "ℤ × ℤ ⇸ ℤ", "dom k ⊆ {0} × (0 ‥ 1) ∧ ran k ⊆ 0 ‥ 1"},
      {"x", "number", "0 ‥ 2", "ℤ", "x ∈ 0 ‥ 2"}};
  return all;
}

/// The forms of each sort of term. A capital letter is an operand: S a set, R a relation, Q a sequence, U a family, T a
/// table of pairs, N a number, B a name or numeral, P a predicate; and V a predicate, W a number, of the variable `$`.
const std::vector<std::string>& set_forms() {
  static const std::vector<std::string> all = {"S ∪ S",
                                               "S ∩ S",
                                               "S ∖ S",
                                               "S ⊖ S",
                                               "dom R",
                                               "ran R",
                                               "R ⦇ S ⦈",
                                               "B ‥ B",
                                               "{N, N}",
                                               "⋃ U",
                                               "ran Q",
                                               "ran T",
                                               "if P then S else S",
                                               "{$ : S • W}",
                                               "{$ : S | V}",
                                               "ℕ ∩ S",
                                               "S ∖ ℕ₁",
                                               "let $ == N • {$}",
                                               "⋃ {S, S}"};
  return all;
}

const std::vector<std::string>& relation_forms() {
  static const std::vector<std::string> all = {"R ∪ R",
                                               "R ⊕ R",
                                               "S ◁ R",
                                               "S ⩤ R",
                                               "R ▷ S",
                                               "R ⩥ S",
                                               "R ∼",
                                               "R ⨾ R",
                                               "R ∘ R",
                                               "{0, 1} ◁ (λ $ : S • W)",
                                               "id S",
                                               "S × S",
                                               "{N ↦ N, N ↦ N}",
                                               "Q",
                                               "ℕ₁ ◁ R",
                                               "if P then R else R",
                                               "R ∖ R",
                                               "dom T",
                                               "{$ : S | V • $ ↦ 1}"};
  return all;
}

const std::vector<std::string>& sequence_forms() {
  static const std::vector<std::string> all = {"⟨N⟩",      "⟨N, N⟩", "Q ⁀ Q", "rev Q", "tail Q", "front Q",
                                               "squash R", "Q ↾ S",  "S ↿ Q", "Q ⊕ Q", "rev R"};
  return all;
}

const std::vector<std::string>& number_forms() {
  static const std::vector<std::string> all = {
      "# S",   "# R",   "min S", "max S", "R (N)",    "(R ∪ R) (N)",        "head Q", "last Q",
      "N + N", "N - N", "# Q",   "Q (N)", "T (N, N)", "if P then N else N", "B"};
  return all;
}

const std::vector<std::string>& predicate_forms() {
  static const std::vector<std::string> all = {"S = S",
                                               "S ≠ S",
                                               "S ⊆ S",
                                               "S ⊂ S",
                                               "N ∈ S",
                                               "N ∉ S",
                                               "N ↦ N ∈ R",
                                               "R = R",
                                               "Q = Q",
                                               "Q ≠ R",
                                               "Q prefix Q",
                                               "R prefix Q",
                                               "disjoint ⟨S, S⟩",
                                               "⟨S, S⟩ partition S",
                                               "R ∈ 0 ‥ 2 ⇸ 0 ‥ 2",
                                               "R ∈ ℤ ⇸ ℕ",
                                               "R ∈ 0 ‥ 1 → ℤ",
                                               "R ∈ 0 ‥ 2 ⤔ ℤ",
                                               "R ∈ ℤ ⤀ 0 ‥ 1",
                                               "R ∈ S ⤖ S",
                                               "R ∈ S ↔ S",
                                               "R ∈ S → S",
                                               "Q ∈ seq ℕ",
                                               "Q ∈ seq₁ (0 ‥ 1)",
                                               "R ∈ iseq ℤ",
                                               "S ∈ ℙ (0 ‥ 1)",
                                               "S ∈ 𝔽₁ ℕ",
                                               "S ∈ U",
                                               "S ∈ ℙ S",
                                               "∀ $ : S • V",
                                               "∃ $ : S • V",
                                               "∃₁ $ : S • V",
                                               "∀ $ : 0 ‥ 2 | $ ∈ S • V",
                                               "∃ $ : ℕ | $ < 3 • V",
                                               "P ∧ P",
                                               "P ∨ P",
                                               "¬ P",
                                               "P ⇒ P",
                                               "P ⇔ P",
                                               "N = N",
                                               "N ≤ N",
                                               "{$ : S | V} = ∅",
                                               "U ≠ U",
                                               "S × S ⊆ R",
                                               "∀ y : U • y ⊆ S"};
  return all;
}

/// Writes predicates of sets, and counts the operations in them.
class SetWriter {
 public:
  SetWriter(Random& random, std::map<std::string, std::size_t>& counts) : random_(random), counts_(counts) {}

  /// An ∃ of some variables over their small sets, and the same over wider ones.
  std::pair<std::string, std::string> question() {
    std::string small, wide, within;
    for (std::size_t count = 2; count > 0; --count) {
      const SetVariable& one = random_.one_of(set_variables());
      bool again = false;
      for (const auto& [name, kind] : scope_) again = again || name == one.name;
      if (again) continue;
      const bool is_wide = random_.below(2) == 0;
      small += (small.empty() ? "" : "; ") + one.name + " : " + one.small;
      wide += (wide.empty() ? "" : "; ") + one.name + " : " + (is_wide ? one.wide : one.small);
      if (is_wide) within += (within.empty() ? " | " : " ∧ ") + one.within;
      scope_.emplace_back(one.name, one.kind);
    }
    const std::string body = predicate(2);
    return {"∃ " + small + " • " + body, "∃ " + wide + within + " • " + body};
  }

 private:
  std::string one_of(const std::vector<std::string>& forms, int depth) {
    const std::string form = random_.one_of(forms);
    ++counts_[form];
    std::string text;
    for (const char c : form) text += operand(c, depth);
    return "(" + text + ")";
  }

  std::string operand(char c, int depth) {
    switch (c) {
      case '$':
        return fresh();
      case 'S':
        return set(depth - 1);
      case 'R':
        return relation(depth - 1);
      case 'Q':
        return sequence(depth - 1);
      case 'U':
        return named("family", {"{{0}, {1}}", "{∅, {0, 1}}", "{{2}}"});
      case 'T':
        return named("table", {"{(0, 1) ↦ 1, (1, 0) ↦ 0}", "{(0, 0) ↦ 1}"});
      case 'N':
        return number(depth - 1);
      case 'B':
        return number(0);
      case 'P':
        return predicate(depth - 1);
      case 'V':
        return scoped(depth);
      case 'W':
        return scoped_number(depth);
      default:
        return {c};
    }
  }

  std::string scoped(int depth) {
    return with_variable([&] { return predicate(depth - 1); });
  }
  std::string scoped_number(int depth) {
    return with_variable([&] { return number(depth - 1); });
  }

  std::string fresh() const { return std::string("n") + static_cast<char>('a' + scope_.size()); }

  template <class Body>
  std::string with_variable(Body&& body) {
    scope_.emplace_back(fresh(), "number");
    std::string text = body();
    scope_.pop_back();
    return text;
  }

  /// A variable of a kind, or a constant.
  std::string named(const std::string& kind, std::vector<std::string> constants) {
    for (const auto& [name, of] : scope_)
      if (of == kind) constants.insert(constants.end(), 6, name);
    return random_.one_of(constants);
  }

  std::string set(int depth) {
    if (depth <= 0) return named("set", {"{0, 1}", "{2}", "∅", "(1 ‥ 2)"});
    return one_of(set_forms(), depth);
  }

  std::string relation(int depth) {
    if (depth <= 0) return named("relation", {"{0 ↦ 1, 1 ↦ 0}", "{1 ↦ 1}", "{0 ↦ 0, 0 ↦ 2}"});
    return one_of(relation_forms(), depth);
  }

  std::string sequence(int depth) {
    if (depth <= 0) return named("sequence", {"⟨0, 1⟩", "⟨⟩", "⟨1⟩", "⟨2, 2, 0⟩"});
    return one_of(sequence_forms(), depth);
  }

  std::string number(int depth) {
    if (depth <= 0) return named("number", {"0", "1", "2", "(- 1)"});
    return one_of(number_forms(), depth);
  }

  std::string predicate(int depth) {
    if (depth <= 0) return one_of({"B ∈ S", "B = B", "B < B", "B ↦ B ∈ R", "S ⊆ S"}, 0);
    return one_of(predicate_forms(), depth);
  }

  Random& random_;
  std::map<std::string, std::size_t>& counts_;
  std::vector<std::pair<std::string, std::string>> scope_{};
};

/// The outcomes of so many predicates of sets.
struct SetAgreement {
  std::size_t yes = 0, no = 0, open = 0;
};

void ask_of_sets(const std::pair<std::string, std::string>& question, const Specification& read, const Z3& z3,
                 SetAgreement& counts) {
  INFO(question.first);
  INFO(question.second);
  const Evaluator evaluator(read.sections);
  const Truth right = evaluator.holds(parse_unicode(question.first));
  REQUIRE(right != Truth::open);
  std::string script;
  const SmtProgram program{"z3", [&](const std::string& asked) { return z3.ask(script = asked); }};
  const SmtFinding found = ask_program(program, parse_unicode(question.second), read.sections, evaluator);
  INFO(script.substr(0, 20'000));
  INFO(found.said);
  CHECK(found.said.find("does not hold") == std::string::npos);
  CHECK(found.said.find("understood") == std::string::npos);
  const bool none = found.said.starts_with("z3 finds no witness");
  if (found.truth == Truth::open && !none) {
    UNSCOPED_INFO(found.said);
    ++counts.open;
    return;
  }
  CHECK(found.truth == (right == Truth::yes ? Truth::yes : Truth::open));  // it is an ∃
  ++(right == Truth::yes ? counts.yes : counts.no);
}

/// Puts variables in the place of a form's operands, each time the next one of its sort, and says which it uses.
class FilledForm {
 public:
  explicit FilledForm(const std::string& form) {
    for (const char c : form) text_ += operand(c);
  }

  const std::string& text() const { return text_; }
  /// The declarations of the variables.
  std::string declared() const {
    std::string all;
    for (const auto& [name, set] : used_) all += (all.empty() ? "" : "; ") + name + " : " + set;
    return all;
  }
  /// The variables as one tuple, which `last` ends where there is one.
  std::string tuple(const std::string& last) const {
    std::string all;
    for (const auto& [name, set] : used_) all += (all.empty() ? "" : ", ") + name;
    return used_.size() == 1 && last.empty() ? all : "(" + all + (last.empty() ? "" : ", " + last) + ")";
  }

 private:
  std::string operand(char c) {
    switch (c) {
      case 'S':
        return variable(sets_++ % 2 == 0 ? "s" : "t", "ℙ (0 ‥ 1)");
      case 'R':
        return relations_++ % 2 == 0 ? variable("f", "0 ‥ 1 ⇸ 0 ‥ 2") : variable("r", "0 ‥ 1 ↔ 0 ‥ 1");
      case 'Q':
        return sequences_++ % 2 == 0 ? variable("q", "{⟨⟩, ⟨0⟩, ⟨1⟩, ⟨0, 0⟩, ⟨0, 1⟩, ⟨1, 0⟩, ⟨1, 1⟩}")
                                     : variable("p", "iseq (0 ‥ 1)");
      case 'U':
        return variable("u", "ℙ (ℙ (0 ‥ 1))");
      case 'T':
        return variable("k", "{0} × (0 ‥ 1) ⇸ 0 ‥ 1");
      case 'N':
      case 'B':
        return variable(numbers_++ % 2 == 0 ? "x" : "y", "0 ‥ 2");
      case 'P':
        return "(1 ∈ " + variable("s", "ℙ (0 ‥ 1)") + ")";
      case 'V':
        return "(z ∈ " + variable("t", "ℙ (0 ‥ 1)") + ")";
      case 'W':
        return "(" + variable("f", "0 ‥ 1 ⇸ 0 ‥ 2") + " z)";
      case '$':
        return "z";
      default:
        return {c};
    }
  }

  std::string variable(const std::string& name, const std::string& set) {
    used_[name] = set;
    return name;
  }

  std::string text_;
  std::map<std::string, std::string> used_;
  std::size_t sets_ = 0, relations_ = 0, sequences_ = 0, numbers_ = 0;
};

/// Asks z3 for values of the variables with which a fact is not as the evaluator's list says. There are none.
void ask_for_a_difference(const FilledForm& form, const std::string& fact, const Valuation& lists, const Z3& z3) {
  static const Specification read = read_text("\\begin{zed} [NAME] \\end{zed}\n", "forms");
  const Evaluator evaluator(read.sections);
  const std::string question = "∃ " + form.declared() + " • ¬ (" + fact + ")";
  INFO(question);
  std::string script;
  const SmtProgram program{"z3", [&](const std::string& asked) { return z3.ask(script = asked); }};
  const SmtFinding found = ask_program(program, parse_unicode(question), read.sections, evaluator, lists);
  INFO(script.substr(0, 20'000));
  CHECK(found.said.starts_with("z3 finds no witness"));
}

/// A term has the value that the evaluator lists for each choice of its variables, and has one for no other.
void check_form(const std::string& form, bool is_predicate, const Evaluator& evaluator, const Z3& z3) {
  const FilledForm filled(form);
  const auto list = [&](const std::string& set) { return evaluator.value(parse_unicode(set)); };
  const Name listed{"listed", ""}, valued{"valued", ""};
  const std::string here = filled.tuple(""), term = "(" + filled.text() + ")";
  if (is_predicate) {
    const Value all = list("{" + filled.declared() + " | " + term + " • " + here + "}");
    return ask_for_a_difference(filled, term + " ⇔ " + here + " ∈ listed", {{listed, all}}, z3);
  }
  const Value all = list("{" + filled.declared() + " | " + term + " = " + term + " • " + filled.tuple(term) + "}");
  const Value some = list("{" + filled.declared() + " | " + term + " = " + term + " • " + here + "}");
  const std::string has_value = here + " ∈ valued";
  ask_for_a_difference(
      filled,
      "(" + filled.tuple(term) + " ∈ listed ⇔ " + has_value + ") ∧ (" + term + " = " + term + " ⇔ " + has_value + ")",
      {{listed, all}, {valued, some}}, z3);
}

}  // namespace

TEST_CASE("each operation on sets has the value of the toolkit, wherever it has one") {
  if (!Z3::is_installed()) {
    WARN("z3 is not installed: its answers are not compared");
    return;
  }
  const Specification read = read_text("\\begin{zed} [NAME] \\end{zed}\n", "forms");
  const Evaluator evaluator(read.sections);
  const Z3 z3;
  for (const auto& forms : {set_forms(), relation_forms(), sequence_forms(), number_forms()})
    for (const std::string& form : forms) check_form(form, false, evaluator, z3);
  for (const std::string& form : predicate_forms()) check_form(form, true, evaluator, z3);
}

TEST_CASE("z3 says of random predicates of sets as enumeration says") {
  if (!Z3::is_installed()) {
    WARN("z3 is not installed: its answers are not compared");
    return;
  }
  const Specification read = read_text("\\begin{zed} [NAME] \\end{zed}\n", "random");
  REQUIRE(read.ok());
  const char* const given = std::getenv("DURERO_SEED");
  const std::uint64_t seed = given ? std::strtoull(given, nullptr, 10) : 20261130;
  INFO("DURERO_SEED=" << seed);
  Random random(seed);
  const Z3 z3;
  SetAgreement counts;
  std::map<std::string, std::size_t> forms;
  constexpr int predicates = 400;
  for (int i = 0; i < predicates; ++i) ask_of_sets(SetWriter(random, forms).question(), read, z3, counts);
  CAPTURE(counts.yes, counts.no, counts.open);
  CHECK(counts.yes > 40);
  CHECK(counts.no > 40);
  CHECK(counts.open < predicates / 10);
  const std::size_t all = set_forms().size() + relation_forms().size() + sequence_forms().size() +
                          number_forms().size() + predicate_forms().size();
  CHECK(forms.size() > all / 10 * 9);  // the other test case reaches each
}

}  // namespace durero::zed::test
