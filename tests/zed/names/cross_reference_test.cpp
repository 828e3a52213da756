#include "durero/zed/names/cross_reference.hpp"

#include "support/catch.hpp"
#include "zed/lines.hpp"
#include "zed/names/marked.hpp"

using namespace durero::zed;
using namespace durero::zed::test;
using Places = std::set<std::string>;

TEST_CASE("a variable's names end with its scope, and a name inside hides the one outside") {
  CHECK(places_of_marked("┌ A\nx, y : ℕ\n├\n‸x = 1\n∀ x : ℕ • x > y\n└\n") == Places{"2:1*", "4:1"});
  CHECK(places_of_marked("┌ A\nx, y : ℕ\n├\nx = 1\n∀ x : ℕ • ‸x > y\n└\n") == Places{"5:3*", "5:11"});
  CHECK(places_of_marked("─\nf == λ n : {n : ℕ | n > 1} • ‸n + 1\n└\n") == Places{"2:8*", "2:30"});
}

TEST_CASE("a component is one through inclusion, decoration, Δ, Ξ, θ and selection") {
  const std::string text =
      "┌ S\nknown : ℙ ℕ\n└\n"                                          // 1..3
      "┌ Op\nΔS\nn? : ℕ\n├\nknown' = known ∪ {n?}\n└\n"                // 4..9
      "┌ Look\nΞS\nr! : ℙ ℕ\n├\nr! = ‸known\n└\n"                      // 10..15
      "─\nT == {S | known = ∅ • θ S}\n⊢? ∀ s : T • s.known = ∅\n└\n";  // 16..19
  CHECK(places_of_marked(text) == Places{"2:1*", "8:1", "8:10", "14:6", "17:11", "18:16"});
}

TEST_CASE("a schema is named by Δ, Ξ and decorations of it") {
  CHECK(places_of_marked("┌ S\nx : ℕ\n└\n┌ Op\nΔ‸S; Ξ"
                         "S\n├\nS '\n└\n") == Places{"1:3*", "5:1", "5:5", "7:1"});
}

TEST_CASE("a renaming of a schema declares the new name, and hiding names a component") {
  const std::string text = "┌ S\nx, y : ℕ\n└\n─\nT == S[z/‸x]\nU == T ⧹ (y)\nV == {U | z = 1 • z}\n└\n";
  CHECK(places_of_marked(text) == Places{"2:1*", "5:10"});
  std::string other = text;
  other.erase(other.find("‸"), std::string("‸").size());
  other.insert(other.rfind("z}"), "‸");
  CHECK(places_of_marked(other) == Places{"5:8*", "7:11", "7:19"});
}

TEST_CASE("schemas as predicates and bindings tie the names of the scope") {
  CHECK(places_of_marked("┌ S\n‸x : ℕ\n└\n─\n⊢? ∀ x : ℕ • S ⇒ x = x\n└\n") == Places{"2:1*", "5:6*", "5:18", "5:22"});
  CHECK(places_of_marked("┌ S\n‸x : ℕ\n└\n─\nT == {⦉x == 1⦊} ∪ S\nn == (μ s : T • s.x)\n└\n") ==
        Places{"2:1*", "5:8", "6:19"});
}

TEST_CASE("schemas of one signature share the components of their bindings, once a binding is used") {
  const std::string two = "┌ P\n‸x, y : ℕ\n└\n┌ Q\nx, y : ℕ\n└\n";
  CHECK(places_of_marked(two) == Places{"2:1*"});
  CHECK(places_of_marked(two + "─\n⊢? ∀ q : Q • q.x > 1\n└\n") == Places{"2:1*", "5:1*", "8:16"});
}

TEST_CASE("joined schemas meet in the state between, and quantified ones in what is bound") {
  CHECK(places_of_marked("┌ S\n‸x : ℕ\n└\n─\nA == [ΔS | x' = x + 1]\nB == A ⨟ A\nC == ∃ x : ℕ • S\n└\n") ==
        Places{"2:1*", "5:12", "5:17", "7:8*"});
}

TEST_CASE("formals, branches and names of boxes") {
  CHECK(places_of_marked("─\n[X, Y]\nP[‸X, Y] == X × Y\nQ == P[X, Y]\n└\n") == Places{"3:3*", "3:12"});
  CHECK(places_of_marked("─\nT ::= leaf | ‸node⟪T⟫\nn == node leaf\n└\n") == Places{"2:14*", "3:6"});
  CHECK(places_of_marked("╷\nf, ‸g : ℕ\n├\nf = g + 1\n└\n─\nh == g\n└\n") == Places{"2:4*", "4:5", "7:6"});
}

TEST_CASE("the mark-up of LaTeX names the same") {
  CHECK(places_of_marked(
            "\\begin{schema}{S}\n  mi\\_‸x : \\nat\n\\end{schema}\n\\begin{schema}{Op}\n  \\Delta S\n\\where\n"
            "  mi\\_x' = mi\\_x\n\\end{schema}\n") == Places{"2:3*", "7:3", "7:12"});
}

TEST_CASE("an operator's words are occurrences of its name") {
  const MarkedText mark("─\nrelation (_ below _)\n└\n╷\n_ below _ : ℕ ↔ ℕ\n├\n∀ a, b : ℕ • a ‸below b ⇔ a < b\n└\n");
  const CheckedTexts of = checked({{marked_file, mark.text}});
  const CrossReference names = cross_reference(of);
  CHECK(names.complete);
  const Occurrence* word = names.at(marked_file, mark.at);
  REQUIRE(word);
  CHECK(word->is_operator);
  CHECK(names.referents[*word->referent].name.word == "_ below _");
  std::vector<std::uint32_t> declarations;
  for (const Occurrence& each : names.files.at(marked_file))
    if (each.declares && each.is_operator) declarations.push_back(each.place.line);
  CHECK(declarations == std::vector<std::uint32_t>{5});
}

TEST_CASE("a minus before its operand is another name than one between two") {
  const CrossReference names = cross_reference(checked({{"m", "─\na == 1 - -(2)\n└\n"}}));
  std::vector<std::string> signs;
  for (const Occurrence& each : names.files.at("m"))
    if (each.is_operator) signs.push_back(each.name.word);
  CHECK(signs == std::vector<std::string>{"_-_", "-_"});
}

TEST_CASE("a paragraph that cannot be read still names its globals, and the reference is not complete") {
  const MarkedText mark("─\nA == ℕ\n└\n┌ S\nx : ‸A\n├\nx = (\n└\n");
  const CrossReference names = cross_reference(checked({{marked_file, mark.text}}));
  CHECK_FALSE(names.complete);
  const Occurrence* use = names.at(marked_file, mark.at);
  REQUIRE(use);
  REQUIRE(use->referent);
  CHECK(names.referents[*use->referent].form == Referent::Form::global);
}

TEST_CASE("every name of the Z texts at hand is found, and has a referent") {
  std::size_t occurrences = 0;
  for (const char* folder : {"tests/zed/corpus/right", "spec/impresa", "demo"})
    for (const std::string& file : files_in(folder)) {
      const CheckedTexts of = checked({{file, contents(file)}});
      if (!of.ok()) continue;
      INFO(file);
      bool own = true;  // parents that stand beside the file are not among the texts
      for (const Section& section : of.read.sections) own = own && section.file == file;
      if (!own) continue;
      const CrossReference names = cross_reference(of);
      CHECK(names.complete);
      for (const auto& [name, all] : names.files)
        for (const Occurrence& each : all) {
          ++occurrences;
          INFO(each.name.text() << " " << each.place.line << ":" << each.place.column);
          CHECK(each.referent.has_value());
        }
    }
  CHECK(occurrences > 2000);
}

TEST_CASE("spec/ is one text of many files, in which each name has a referent") {
  std::map<std::string, std::string> texts;
  for (const std::string& file : files_in("spec")) texts[file] = contents(file);
  const CheckedTexts of = checked(texts);
  REQUIRE(of.ok());
  const CrossReference names = cross_reference(of);
  CHECK(names.complete);
  std::size_t missing = 0;
  for (const auto& [name, all] : names.files)
    for (const Occurrence& each : all) missing += each.referent ? 0 : 1;
  CHECK(missing == 0);
}
