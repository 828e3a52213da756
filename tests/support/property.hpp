#pragma once
/// property(name, testable): a RapidCheck property inside a Catch2 test case.
/// A failure prints the smallest counterexample and the RC_PARAMS line that replays it.
#include <rapidcheck.h>

#include <sstream>
#include <string>
#include <utility>

#include "support/catch.hpp"

namespace durero::test {

template <class Testable>
void property(const std::string& name, Testable&& testable) {
  SECTION(name) {
    const auto result = rc::detail::checkTestable(std::forward<Testable>(testable));
    std::ostringstream said;
    rc::detail::printResultMessage(result, said);
    INFO(said.str());
    CHECK(result.template is<rc::detail::SuccessResult>());
  }
}

}  // namespace durero::test
