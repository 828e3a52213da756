#pragma once
/// property(name, testable): a RapidCheck property inside a Catch2 test case.
/// A failure prints the smallest counterexample and the RC_PARAMS line that replays it. Under the sanitizers a tenth of
/// the cases are tried.
#include <rapidcheck.h>

#include <sstream>
#include <string>
#include <utility>

#include "support/catch.hpp"
#include "support/sanitized.hpp"

namespace durero::test {

template <class Testable>
void property(const std::string& name, Testable&& testable) {
  SECTION(name) {
    rc::detail::TestParams params = rc::detail::configuration().testParams;
    params.maxSuccess = static_cast<int>(fewer_when_sanitized(static_cast<std::size_t>(params.maxSuccess)));
    const auto result = rc::detail::checkTestable(std::forward<Testable>(testable), rc::detail::TestMetadata(), params);
    std::ostringstream said;
    rc::detail::printResultMessage(result, said);
    INFO(said.str());
    CHECK(result.template is<rc::detail::SuccessResult>());
  }
}

}  // namespace durero::test
