#include "durero/zed/syntax/operators.hpp"

#include "durero/zed/print/print.hpp"
#include "durero/zed/syntax/defect.hpp"
#include "durero/zed/syntax/parser.hpp"
#include "durero/zed/syntax/reader.hpp"
#include "support/catch.hpp"

using namespace durero::zed;

namespace {

Operators with(std::vector<OperatorTemplate> templates) {
  Operators operators;
  for (OperatorTemplate& each : templates)
    REQUIRE(add_operator(operators, std::move(each), ToolkitSections::all()).empty());
  return operators;
}

const OperatorTemplate plus{Role::function, {"_", "plus", "_"}, 30, false};
const OperatorTemplate to{Role::function, {"_", "to", "_"}, 40, true};
const OperatorTemplate below{Role::relation, {"_", "below", "_"}, 0, false};
const OperatorTemplate even{Role::relation, {"even", "_"}, 0, false};
const OperatorTemplate twice{Role::function, {"_", "twice"}, 0, false};
const OperatorTemplate onto{Role::generic, {"_", "onto", "_"}, 5, true};
const OperatorTemplate bag{Role::function, {"bag", ",,", "end"}, 0, false};

}  // namespace

TEST_CASE("a generic operator is defined by its name with formals in brackets, or in the places of operands") {
  const Specification read = read_text(
      "\\begin{zed} \\relation (finite~\\_) \\\\ \\relation (\\_~like~\\_) \\\\\n"
      " finite~\\_ [X] == \\finset X \\\\ \\_~like~\\_ [X] == X \\cross X \\end{zed}",
      "t.tex");
  REQUIRE(read.ok());
  const auto& paragraphs = read.sections.back().paragraphs;
  REQUIRE(paragraphs.size() == 2);
  const Operators operators =
      with({{Role::relation, {"finite", "_"}, 0, false}, {Role::relation, {"_", "like", "_"}, 0, false}});
  for (const Paragraph& each : paragraphs) {
    const std::string text = to_unicode(each);
    INFO(text);
    CHECK(std::get<Definition>(each.form).formals == std::vector<Name>{{"X", ""}});
    CHECK(parse_unicode_paragraph(text, operators) == each);
  }
  CHECK(parse_unicode_paragraph("finite X == 𝔽 X", operators) == paragraphs[0]);
}

TEST_CASE("the words of a template know where they stand, and have one meaning") {
  Operators operators = with({bag, plus});
  CHECK(operators.size() == 3);
  CHECK(operators.at("bag").first());
  CHECK_FALSE(operators.at("bag").last());
  CHECK(operators.at("end").last());
  CHECK(operators.at("plus").first());
  CHECK(operators.at("plus").last());
  CHECK(bag.name() == "bag ,, end");
  CHECK(is_template_name(plus.name()));
  CHECK_FALSE(is_template_name("_+_"));
  for (const OperatorTemplate& taken : {plus, OperatorTemplate{Role::relation, {"_", "end"}, 0, false},
                                        OperatorTemplate{Role::relation, {"_", "div", "_"}, 0, false},
                                        OperatorTemplate{Role::relation, {"_", "if", "_"}, 0, false},
                                        OperatorTemplate{Role::function, {"x", "_", "x"}, 0, false}}) {
    CHECK_FALSE(add_operator(operators, taken, ToolkitSections::all()).empty());
    CHECK(operators.size() == 3);
  }
}

TEST_CASE("operators of templates bind by their precedence, beside those of the toolkit") {
  const Operators operators = with({plus, to, below, even, twice, onto, bag});
  for (const auto& [brief, full] : std::initializer_list<std::pair<const char*, const char*>>{
           {"a plus b plus c", "(a plus b) plus c"},
           {"a to b to c", "a to (b to c)"},
           {"a plus b * c", "a plus (b * c)"},
           {"a * b plus c", "(a * b) plus c"},
           {"a ∪ b plus c", "(a ∪ b) plus c"},
           {"a plus b to c", "a plus (b to c)"},
           {"even a plus b", "even (a plus b)"},
           {"a plus b twice", "a plus (b twice)"},
           {"f x twice", "(f x) twice"},
           {"a below b ∧ c below d", "(a below b) ∧ (c below d)"},
           {"a below b = c", "a below b ∧ b = c"},
           {"a ≤ b below c", "a ≤ b ∧ b below c"},
           {"a below b below c", "a below b ∧ b below c"},
           {"a ≤ b below c < d", "a ≤ b ∧ b below c ∧ c < d"},
           {"A onto B onto C", "A onto (B onto C)"},
           {"a below b", "(a, b) ∈ (_ below _)"},
           {"even a", "a ∈ (even _)"},
           {"a plus b", "(_ plus _)(a, b)"},
           {"A onto B", "(_ onto _)[A, B]"},
           {"bag a, b end", "(bag ,, end) ⟨a, b⟩"},
           {"f bag a, b end", "f (bag a, b end)"},
           {"f bag end ∪ A", "(f (bag end)) ∪ A"},
           {"bag a end b", "(bag a end) b"},
           {"bag bag a end end ∼", "(bag (bag a end) end) ∼"},
           {"bag end", "(bag ,, end) ⟨⟩"}}) {
    CAPTURE(brief, full);
    const Term term = parse_unicode(brief, operators);
    CHECK(term == parse_unicode(full, operators));
    CHECK(parse_unicode(to_unicode(term), operators) == term);
    CHECK(parse_latex(to_latex(term), {}, operators) == term);
  }
  for (const char* text :
       {"plus", "a plus", "plus a", "bag a", "a below", "twice", "a even", "{plus}", "bag a b, end end"}) {
    CAPTURE(text);
    CHECK_THROWS_AS(parse_unicode(text, operators), ZError);
  }
  CHECK_NOTHROW(parse_unicode("plus"));  // without the template it is a name
}

TEST_CASE("what a template names is declared and printed in its own form") {
  const Operators operators = with({plus, onto, even});
  for (const char* text : {"┌─\n│ _ plus _, c : A\n│ even _ : B\n└─\n", "X onto Y == {f : X → Y | ran f = Y}\n",
                           "_ plus _ == {}\n", "[X, Y] ⊢? X = Y\n"}) {
    const Paragraph paragraph = parse_unicode_paragraph(text, operators);
    CAPTURE(text, to_unicode(paragraph));
    CHECK(parse_unicode_paragraph(to_unicode(paragraph), operators) == paragraph);
  }
  const Paragraph generic = parse_unicode_paragraph("X onto Y == X", operators);
  CHECK(std::get<Definition>(generic.form).formals.size() == 2);
}

TEST_CASE("a word of the toolkit's operators is free where the section that gives it is not seen") {
  const auto taken = [](const std::string& word, const char* section) {
    Operators operators;
    return add_operator(operators, {Role::relation, {word, "_"}, 0, false}, *ToolkitSections::of(section)) == word;
  };
  for (const auto& [word, section] :
       {std::pair("∪", "set_toolkit"), std::pair("⦇", "relation_toolkit"), std::pair("disjoint", "function_toolkit"),
        std::pair("-", "number_toolkit"), std::pair("⟩", "sequence_toolkit"), std::pair("seq", "sequence_toolkit")}) {
    CAPTURE(word);
    CHECK(taken(word, section));
    CHECK_FALSE(taken(word, "prelude"));
  }
  for (const char* word : {"+", "=", "∈", "/", "ℙ", "if"}) {
    CAPTURE(word);
    CHECK(taken(word, "prelude"));
  }
  CHECK_FALSE(taken("eq", "standard_toolkit"));  // it is a part of seq alone
}

TEST_CASE("an operator with a word of the toolkit is the template's, and not the toolkit's") {
  Operators operators;
  const auto add = [&operators](OperatorTemplate added) {
    REQUIRE(add_operator(operators, std::move(added), ToolkitSections()).empty());
  };
  add({Role::relation, {"_", "∪", "_"}, 0, false});
  add({Role::function, {"⟨", "_", "⟩"}, 0, false});
  add({Role::function, {"_", "⦇", "_", "⦈"}, 0, false});
  add({Role::function, {"_", "∼"}, 0, false});
  add({Role::function, {"#", "_", "end"}, 0, false});
  const auto same = [&operators](const char* brief, const char* full) {
    CAPTURE(brief, full);
    CHECK(parse_unicode(brief, operators) == parse_unicode(full, operators));
  };
  same("a + b ∪ c", "(a + b, c) ∈ (_ ∪ _)");
  same("f ⟨a⟩", "f ((⟨ _ ⟩) a)");
  same("a ⦇ b ⦈", "(_ ⦇ _ ⦈) (a, b)");
  same("a ∼", "(_ ∼) a");
  same("# a end", "(# _ end) a");
  CHECK(word_of_toolkit(operators, ToolkitSections()).empty());
  CHECK(word_of_toolkit(operators, *ToolkitSections::of("set_toolkit")) == "∪");
}
