#include "durero/spec/refinement.hpp"

#include <fstream>
#include <sstream>

#include "durero/zed/print/print.hpp"
#include "support/catch.hpp"
#include "support/tree.hpp"

namespace durero::spec {
namespace {

using Catch::Matchers::Contains;

std::string demo_file(const std::string& name) { return durero::test::source_dir() + "/demo/" + name; }

zed::Specification read_demo(const std::string& name) {
  auto read = zed::read_files({demo_file(name)});
  REQUIRE(read.ok());
  return read;
}

/// The text of the coin, with something else in the place of a part of it.
zed::Specification coin_text(const std::string& part = "", const std::string& instead = "") {
  std::ostringstream all;
  all << std::ifstream(demo_file("coin.tex")).rdbuf();
  std::string text = all.str();
  if (!part.empty()) {
    REQUIRE(text.find(part) != text.npos);
    text.replace(text.find(part), part.size(), instead);
  }
  auto read = zed::read_text(text, "coin.tex");
  REQUIRE(read.ok());
  return read;
}

Refinement found(const zed::Specification& text, const RefinementCall& call) {
  const zed::Typing typing = zed::check(text);
  REQUIRE(typing.ok());
  return refinement_of(text, typing, call);
}

const RefinementCall arrays{"BirthdayBook", "BirthdayBook1", "Abs"}, coin{"Coin", "Coin1", "AbsCoin"};

std::vector<std::string> claims(const Refinement& refinement, bool functional) {
  std::vector<std::string> texts;
  for (const Obligation& each : obligations(refinement, functional))
    texts.push_back(each.label + ": " + zed::to_unicode(each.claim));
  return texts;
}

std::string refusal_of(const zed::Specification& text, const RefinementCall& call) {
  const zed::Typing typing = zed::check(text);
  try {
    refinement_of(text, typing, call);
  } catch (const RefinementError& error) {
    return error.what();
  }
  return "none";
}

}  // namespace

TEST_CASE("partners are found by their names, and have one signature") {
  const Refinement refinement = found(read_demo("birthday_book_arrays.tex"), arrays);
  CHECK(refinement.abstract_init == "InitBirthdayBook");
  CHECK(refinement.concrete_init == "InitBirthdayBook1");
  CHECK(refinement.alone.empty());
  std::string pairs;
  for (const OperationPair& pair : refinement.operations) pairs += pair.abstract + "=" + pair.concrete + " ";
  CHECK(pairs ==
        "AddBirthday=AddBirthday1 AlreadyKnown=AlreadyKnown1 FindBirthday=FindBirthday1 NotKnown=NotKnown1 "
        "RAddBirthday=RAddBirthday1 RFindBirthday=RFindBirthday1 Remind=Remind1 ");
  CHECK(refinement.operations[0].inputs.size() == 2);
  CHECK(refinement.operations[2].outputs == std::vector<zed::Name>{{"date", "!"}});
}

TEST_CASE("the obligations of a forward simulation") {
  Refinement refinement = found(coin_text(), coin);
  CHECK(claims(refinement, false) == std::vector<std::string>{
                                         "InitCoin1.conj.1: ∀ InitCoin1 • ∃ Coin ' • InitCoin ∧ AbsCoin '",
                                         "Look1.conj.1: ∀ AbsCoin; pre Look • pre Look1",
                                         "Look1.conj.2: ∀ AbsCoin; Look1 | pre Look • ∃ Coin ' • AbsCoin ' ∧ Look",
                                         "Toss1.conj.1: ∀ AbsCoin; pre Toss • pre Toss1",
                                         "Toss1.conj.2: ∀ AbsCoin; Toss1 | pre Toss • ∃ Coin ' • AbsCoin ' ∧ Toss",
                                     });
  CHECK(claims(refinement, true)[0] == "AbsCoin.conj.1: ∀ Coin1 • ∃₁ Coin • AbsCoin");
  CHECK(claims(refinement, true)[1] == "InitCoin1.conj.1: ∀ InitCoin1; AbsCoin ' • InitCoin");
  CHECK(claims(refinement, true)[3] == "Look1.conj.2: ∀ AbsCoin; AbsCoin '; Look1 | pre Look • Look");
}

TEST_CASE("the obligations of a backward simulation") {
  RefinementCall call{"BirthdayBook", "BirthdayBook1", "Abs"};
  call.backward = true;
  const auto all = claims(found(read_demo("birthday_book_arrays.tex"), call), true);
  CHECK(all[0] == "Abs.conj.1: ∀ BirthdayBook1 • ∃ BirthdayBook • Abs");
  CHECK(all[1] == "InitBirthdayBook1.conj.1: ∀ InitBirthdayBook1; Abs ' • InitBirthdayBook");
  CHECK(all[2] ==
        "AddBirthday1.conj.1: ∀ BirthdayBook1; date? : DATE; name? : NAME | ∀ BirthdayBook | Abs • pre AddBirthday • "
        "pre AddBirthday1");
  CHECK(all[3] ==
        "AddBirthday1.conj.2: ∀ AddBirthday1; Abs ' | ∀ BirthdayBook | Abs • pre AddBirthday • ∃ BirthdayBook • Abs ∧ "
        "AddBirthday");
}

TEST_CASE("initial schemas may be of the state itself") {
  const auto text = coin_text("Coin1~'\n\\where\n  tossed' = no", "Coin1\n\\where\n  tossed = no");
  const Refinement refinement = found(text, coin);
  CHECK_FALSE(refinement.concrete_primed);
  CHECK(claims(refinement, false)[0] == "InitCoin1.conj.1: ∀ InitCoin1 ' • ∃ Coin ' • InitCoin ∧ AbsCoin '");
}

TEST_CASE("the obligations are read back, well-typed, in both mark-ups") {
  for (const bool backward : {false, true})
    for (const bool latex : {false, true}) {
      RefinementCall call = arrays;
      call.backward = backward;
      const zed::Specification text = read_demo("birthday_book_arrays.tex");
      const Refinement refinement = found(text, call);
      const std::vector<Obligation> all = obligations(refinement, true);
      const std::string written = obligations_text(text, refinement, all, latex);
      CAPTURE(written);
      std::ostringstream book, of_arrays;
      book << std::ifstream(demo_file("birthday_book.tex")).rdbuf();
      of_arrays << std::ifstream(demo_file("birthday_book_arrays.tex")).rdbuf();
      const auto read = zed::read_sources({{"birthday_book.tex", book.str()},
                                           {"birthday_book_arrays.tex", of_arrays.str()},
                                           {latex ? "obligations.tex" : "obligations.zed", written}});
      REQUIRE(read.ok());
      CHECK(zed::check(read).ok());
      const zed::Section* section = read.find("obligations");
      REQUIRE(section);
      REQUIRE(section->paragraphs.size() == all.size());
      for (std::size_t i = 0; i < all.size(); ++i) {
        const auto* conjecture = std::get_if<zed::Conjecture>(&section->paragraphs[i].form);
        REQUIRE(conjecture);
        CHECK(conjecture->claim.term == all[i].claim);
        CHECK(conjecture->claim.label == all[i].label);
      }
    }
}

TEST_CASE("what is no refinement is refused in one line") {
  const zed::Specification text = coin_text();
  CHECK(refusal_of(text, {"Coim", "Coin1", "AbsCoin"}) == "the text has no schema Coim; expected Coin");
  CHECK(refusal_of(text, {"Coin", "Coin", "AbsCoin"}) ==
        "Coin and Coin share hand; expected states without a common component");
  CHECK(refusal_of(text, {"Coin", "Coin1", "Toss"}) ==
        "Toss has the components hand, hand'; expected those of Coin and Coin1, and no others");
  RefinementCall call = coin;
  call.pairs = {{"Toss", "Coin1"}};
  CHECK_THAT(refusal_of(text, call), Contains("Coin1 is no operation on Coin1; expected the components of"));
  call.pairs = {{"Toss", "Look1"}};
  CHECK_THAT(refusal_of(text, call), Contains("the outputs of Look1: face!; expected those of Toss: none"));
  call.pairs = {{"Look", "Toss1"}};
  CHECK_THAT(refusal_of(text, call), Contains("expected"));
  CHECK_THAT(refusal_of(coin_text("{Look1}\n  \\Delta Coin1 \\\\\n  face! : FACE",
                                  "{Look1}\n  \\Delta Coin1 \\\\\n  face! : HAND"),
                        coin),
             Contains("face! of Look1 has the type HAND; expected FACE, as in Look"));
  CHECK_THAT(refusal_of(coin_text("{InitCoin1}", "{Begin}"), coin),
             Contains("Coin1 has no initial schema; expected InitCoin1, or --pair AINIT=CINIT"));
}

TEST_CASE("an operation without a partner is named, and a pair that is given is taken") {
  const zed::Specification text = coin_text("{Toss1}", "{Throw}");
  CHECK(found(text, coin).alone == std::vector<std::string>{"Toss", "Throw"});
  RefinementCall call = coin;
  call.pairs = {{"Toss", "Throw"}};
  CHECK(found(text, call).alone.empty());
  const zed::Specification begun = coin_text("{InitCoin1}", "{Begin}");
  call.pairs = {{"InitCoin", "Begin"}};
  CHECK(found(begun, call).concrete_init == "Begin");
  const zed::Specification named = coin_text("{Toss1}", "{Toss\\_late}");
  CHECK(found(named, coin).alone.empty());  // the only operation whose name begins so
}

}  // namespace durero::spec
