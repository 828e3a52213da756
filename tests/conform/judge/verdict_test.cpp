#include "durero/conform/judge/verdict.hpp"

#include <set>

#include "support/catch.hpp"

using namespace durero::conform;

TEST_CASE("every verdict has a name of its own, and those that change the picture are gross") {
  std::set<std::string_view> names;
  int gross = 0;
  for (int i = 0; i < verdict_count; ++i) {
    const auto verdict = static_cast<Verdict>(i);
    CHECK(names.insert(name(verdict)).second);
    gross += is_gross(verdict);
  }
  CHECK(name(Verdict::exact) == "exact");
  CHECK(name(Verdict::skipped) == "skipped");
  CHECK(gross == 15);
  for (const Verdict verdict : {Verdict::exact, Verdict::right, Verdict::off, Verdict::skipped})
    CHECK_FALSE(is_gross(verdict));
}
