#include "durero/text/nearest.hpp"

#include "support/catch.hpp"
#include "support/property.hpp"

using namespace durero;
using text::apart;
using text::expected_of;
using text::nearest;

TEST_CASE("A slip is a character too many, too few, another, or two exchanged") {
  CHECK(apart("trace", "trace") == 0);
  CHECK(apart("enginee", "engine") == 1);
  CHECK(apart("chek", "check") == 1);
  CHECK(apart("tracy", "trace") == 1);
  CHECK(apart("tarce", "trace") == 1);
  CHECK(apart("ab", "ba") == 1);
  CHECK(apart("kitten", "sitting") == 3);
  CHECK(apart("", "abc") == 3);
  CHECK(apart("∅ℝ", "ℝ∅") == 1);
  CHECK(apart("θ", "Δ") == 1);
}

TEST_CASE("The nearest word is near, the least apart, and the first of several") {
  const std::vector<std::string> words{"sampled", "exact", "analytic", "exat"};
  CHECK(nearest("exact", words) == "exact");
  CHECK(nearest("exactt", words) == "exact");
  CHECK(nearest("eaxct", words) == "exact");
  CHECK(nearest("analitycs", words) == std::nullopt);
  CHECK(nearest("analyitcs", words) == "analytic");
  CHECK(nearest("quick", words) == std::nullopt);
  CHECK(nearest("", words) == std::nullopt);
  CHECK(nearest("x", {"o"}) == std::nullopt);
  CHECK(nearest("-x", {"-h", "-o"}) == std::nullopt);
  CHECK(nearest("aca", {"aaa", "aba"}) == "aaa");
  CHECK(nearest("any", {}) == std::nullopt);
}

TEST_CASE("An English word is nearest to the name that it is the English of") {
  CHECK(nearest("radius", {"centro", "radio"}) == "radio");
  CHECK(nearest("sphere", {"cono", "esfera"}) == "esfera");
  CHECK(nearest("Add_Cone", {"Agregar_Elemento", "Agregar_Cono"}) == "Agregar_Cono");
  CHECK(nearest("height", {"centro", "radio"}) == std::nullopt);
  CHECK(nearest("", {"trace"}) == std::nullopt);
  CHECK(expected_of("center", {"centro", "centre"}) == "centro (center)");
  CHECK(expected_of("size", {"id", "centro", "radio"}) == "one of id, centro (center), radio (radius)");
}

TEST_CASE("What is expected is the near word, or all") {
  CHECK(expected_of("exakt", {"sampled", "exact"}) == "exact");
  CHECK(expected_of("quick", {"sampled", "exact"}) == "one of sampled, exact");
  CHECK(expected_of("quick", {"sampled"}) == "one of sampled");
}

TEST_CASE("Apart is symmetric, and no more than the longer text has characters") {
  test::property("apart", [](const std::string& a, const std::string& b) {
    RC_ASSERT(apart(a, b) == apart(b, a));
    RC_ASSERT(apart(a, b) <= std::max(a.size(), b.size()));
    RC_ASSERT((apart(a, b) == 0) == (a == b));
  });
}

TEST_CASE("The nearest word is the one that whole distances give") {
  const auto word = rc::gen::container<std::string>(rc::gen::element('a', 'b', 'c', 'd'));
  test::property("nearest", [&] {
    const std::string asked = *word;
    const auto list = *rc::gen::container<std::vector<std::string>>(word);
    std::optional<std::string> best;
    for (const std::string& each : list) {
      const std::size_t off = apart(asked, each);
      if (off > std::max<std::size_t>(1, each.size() / 3) || 2 * off >= each.size()) continue;
      if (!best || off < apart(asked, *best)) best = each;
    }
    RC_ASSERT(nearest(asked, list) == best);
  });
}
