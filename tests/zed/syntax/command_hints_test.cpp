// Commands of LaTeX that Z has not, and what is meant by them.
#include "zed/syntax/command_hints.hpp"

#include "support/catch.hpp"
#include "zed/syntax/symbols.hpp"

namespace durero::zed {
namespace {

TEST_CASE("a command of LaTeX or of another style is told in Z's, and a slip too") {
  CHECK(expected_command("rightarrow", {}) == "expected \\fun, as Z writes it");
  CHECK(expected_command("spot", {}) == "expected @, as Z writes it");
  CHECK(expected_command("Nat", {}) == "expected a command of ISO Z or of a %%Z directive; did you mean \\nat?");
  CHECK(expected_command("surjj", {}) == "expected a command of ISO Z or of a %%Z directive; did you mean \\surj?");
  CHECK(expected_command("rreal", {{"real", "ℝ"}}) ==
        "expected a command of ISO Z or of a %%Z directive; did you mean \\real?");
  CHECK(expected_command("draschema", {}) == "expected a command of ISO Z or of a %%Z directive");
}

TEST_CASE("each command that is told is one of Z, and none for itself") {
  for (const char* const other : {"to",         "leftrightarrow",
                                  "Rightarrow", "Leftrightarrow",
                                  "times",      "wedge",
                                  "vee",        "neg",
                                  "lhd",        "rhd",
                                  "sim",        "ne",
                                  "le",         "ge",
                                  "empty",      "varnothing",
                                  "ints",       "pset",
                                  "fset",       "frown",
                                  "rsub",       "dsub",
                                  "fovr"}) {
    CAPTURE(other);
    CHECK_FALSE(unicode_of_command(other));
    const std::string told = expected_command(other, {});
    CHECK(unicode_of_command(told.substr(10, told.find(',') - 10)));
  }
}

}  // namespace
}  // namespace durero::zed
