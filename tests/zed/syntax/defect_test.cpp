#include "durero/zed/syntax/defect.hpp"

#include "support/catch.hpp"

namespace durero::zed {
namespace {

TEST_CASE("a defect says file, line, column, what is wrong and what is expected") {
  const Defect error{"a.tex", {3, 14}, "x is not declared", "expected a declared name", Defect::Severity::error};
  CHECK(error.text() == "a.tex:3:14: x is not declared; expected a declared name");
  Defect warning = error;
  warning.severity = Defect::Severity::warning;
  CHECK(warning.text() == "a.tex:3:14: warning: x is not declared; expected a declared name");
}

TEST_CASE("its text is one line of visible characters, whatever the text holds") {
  const Defect defect{"a\n.tex", {1, 1}, "\x1b[2J ∪", "\xff", Defect::Severity::error};
  CHECK(defect.text() == "a\\x0a.tex:1:1: \\x1b[2J ∪; \\xff");
}

TEST_CASE("what is thrown becomes a defect of a file, which is an error") {
  const ZError thrown({2, 5}, "a number", "expected a name");
  CHECK(std::string(thrown.what()) == "a number; expected a name");
  const Defect defect = thrown.in("b.tex");
  CHECK(defect.file == "b.tex");
  CHECK(defect.place == Place{2, 5});
  CHECK(defect.what == "a number");
  CHECK(defect.expected == "expected a name");
  CHECK(defect.severity == Defect::Severity::error);
}

}  // namespace
}  // namespace durero::zed
