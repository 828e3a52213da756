#include "zed/types/known_names.hpp"

#include <algorithm>

#include "durero/text/nearest.hpp"
#include "support/catch.hpp"
#include "support/property.hpp"

using namespace durero;
using zed::KnownNames;

TEST_CASE("a name is looked for in two lists as in one") {
  const auto name = rc::gen::container<std::string>(rc::gen::element('a', 'b', 'c', '\''));
  test::property("nearest of two lists", [&] {
    const auto a = *rc::gen::container<std::vector<std::string>>(name);
    const auto b = *rc::gen::container<std::vector<std::string>>(name);
    const std::string word = *name;
    std::vector<std::string> both = a;
    both.insert(both.end(), b.begin(), b.end());
    const KnownNames first(a), second(b), all(both), none({});
    std::ranges::sort(both);
    RC_ASSERT(nearest(word, first, second) == text::nearest(word, both));
    RC_ASSERT(nearest(word, first, second) == nearest(word, second, first));
    RC_ASSERT(with_strokes(word, first, second) == with_strokes(word, all, none));
    if (!word.empty()) RC_ASSERT(taken_apart(word, first, second) == taken_apart(word, all, none));
  });
}

TEST_CASE("a name with strokes is a name of the word, and a longer word is none") {
  const KnownNames names({"x", "x'", "x?", "xy'", "x12"}), none({});
  CHECK(with_strokes("x", names, none) == "x'");
  CHECK(with_strokes("xy", none, names) == "xy'");
  CHECK(with_strokes("x", KnownNames({"x?"}), KnownNames({"x'"})) == "x'");
  CHECK_FALSE(with_strokes("x'", names, none));
  CHECK_FALSE(with_strokes("y", names, none));
}

TEST_CASE("a word is taken apart at the words of names") {
  const KnownNames names({"dom", "f", "_ + _"}), more({"ran"});
  CHECK(taken_apart("domf", names, more) == "dom f");
  CHECK(taken_apart("domranf", names, more) == "dom ran f");
  CHECK(taken_apart("+12", more, names) == "+ 12");
  CHECK(taken_apart("domg", names, more).empty());
  CHECK(taken_apart("f12", names, more).empty());
}
