#include "durero/zed/syntax/defect.hpp"

#include "support/catch.hpp"

namespace durero::zed {
namespace {

TEST_CASE("a defect is one line: its file, its place, what is wrong and what is expected") {
  const Defect error{"a.tex", {3, 14}, "a stray )", "expected an operator", Defect::Severity::error};
  CHECK(error.text() == "a.tex:3:14: a stray ); expected an operator");
  Defect warning = error;
  warning.severity = Defect::Severity::warning;
  CHECK(warning.text() == "a.tex:3:14: warning: a stray ); expected an operator");
}

TEST_CASE("whatever the text holds, a defect stays one line of visible characters") {
  const Defect defect{"a\n.tex", {1, 1}, "the name \x1b[2J∪\xff", "expected\tanother", {}};
  CHECK(defect.text() == "a\\x0a.tex:1:1: the name \\x1b[2J∪\\xff; expected\\x09another");
}

TEST_CASE("an error that ends a step becomes the defect of a file") {
  const ZError error({2, 7}, "unexpected )", "expected a name");
  CHECK(std::string(error.what()) == "unexpected ); expected a name");
  const Defect defect = error.in("b.tex");
  CHECK(defect.severity == Defect::Severity::error);
  CHECK(defect.place == Place{2, 7});
  CHECK(defect.text() == "b.tex:2:7: unexpected ); expected a name");
}

}  // namespace
}  // namespace durero::zed
