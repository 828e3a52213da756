#include "durero/zed/syntax/word.hpp"

#include <algorithm>
#include <array>
#include <set>
#include <thread>
#include <unordered_set>
#include <vector>

#include "support/catch.hpp"
#include "support/property.hpp"
#include "zed/syntax/symbols.hpp"

using namespace durero;
using zed::Word;

TEST_CASE("all words of one text share it, whatever they are made of") {
  const std::string text = "mi_centro";
  const Word word = text;
  CHECK(&word.text() == &Word("mi_centro").text());
  CHECK(&word.text() == &Word(std::string_view("mi_centro, and more").substr(0, 9)).text());
  CHECK(&word.text() != &text);
  CHECK(word == "mi_centro");
  CHECK(word == text);
  CHECK_FALSE(word == Word("mi_radio"));
  CHECK_FALSE(word == "mi_centr");
}

TEST_CASE("the empty word is no text, however it is made") {
  CHECK(Word().empty());
  CHECK(Word() == Word(""));
  CHECK(&Word().text() == &Word(std::string()).text());
  CHECK(Word().hash() == Word("").hash());
  CHECK(Word().symbol().may_be_name());
}

TEST_CASE("a word becomes another by what is put behind it, and the first stays") {
  Word word = "x";
  const Word before = word;
  word += "'";
  CHECK(word == "x'");
  CHECK(before == "x");
  word += "";
  CHECK(word == "x'");
  CHECK(word + "!" == "x'!");
  CHECK("Δ" + word == "Δx'");
  CHECK(word + before == "x'x");
}

TEST_CASE("a word knows what the language has of it") {
  CHECK(Word("_").symbol().infix == nullptr);
  CHECK(Word("∪").symbol().infix != nullptr);
  CHECK(Word("θ").symbol().reserved);
  CHECK(Word("mi_centro").symbol().may_be_name());
}

TEST_CASE("words are ordered, joined and found as texts are") {
  test::property("of two texts the words say what the texts do", [](const std::string& a, const std::string& b) {
    const Word first = a, second = b;
    RC_ASSERT(first.text() == a);
    RC_ASSERT((first == second) == (a == b));
    RC_ASSERT((first <=> second) == (a <=> b));
    RC_ASSERT(first + second == a + b);
    RC_ASSERT(first.starts_with(b) == a.starts_with(b));
    RC_ASSERT(first.find(b) == a.find(b));
    RC_ASSERT((Word(a).hash() == Word(a).hash()));
  });
}

TEST_CASE("several threads make the same words at once") {
  constexpr std::size_t words = 2000;
  std::array<std::vector<const std::string*>, 4> seen;
  {
    std::vector<std::jthread> threads;
    for (auto& mine : seen)
      threads.emplace_back([&mine] {
        for (std::size_t i = 0; i < words; ++i) mine.push_back(&Word("threaded" + std::to_string(i)).text());
      });
  }
  for (const auto& mine : seen) CHECK(mine == seen[0]);
  CHECK(std::set(seen[0].begin(), seen[0].end()).size() == words);
}
