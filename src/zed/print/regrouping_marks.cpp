#include "zed/print/regrouping_marks.hpp"

#include <algorithm>
#include <string>

namespace durero::zed {
namespace {

/// Signs around a run of tokens.
struct SignedRun {
  std::size_t from, to;
  std::string close;
};

}  // namespace

SpiveyMarks regrouping_marks(const std::vector<Token>& tokens, const IsoGrouping& regrouping, const Spelling& spelling,
                             bool latex) {
  std::vector<std::size_t> counted;  // without line ends
  for (std::size_t i = 0, seen = 0; i < tokens.size(); ++i) {
    counted.push_back(seen);
    if (tokens[i].type != Token::Type::newline) ++seen;
  }
  SpiveyMarks marks;
  std::vector<SignedRun> runs;
  for (const auto& each : regrouping.memberships) {
    const Token& name = tokens[each.sign + 1];
    runs.push_back(
        {each.left, each.end, latex ? ") \\in " + spelling.latex(name, true) : ") ∈ " + Spelling::unicode(name)});
    marks.instead[counted[each.sign]] = ",";
    marks.instead[counted[each.sign + 1]] = "";
  }
  for (const auto& [from, to] : regrouping.groups) runs.push_back({from, to, ")"});
  // Of runs that end together, the inner one closes first.
  std::ranges::stable_sort(runs, [](const SignedRun& a, const SignedRun& b) { return a.from > b.from; });
  for (const SignedRun& run : runs) {
    marks.before[counted[run.from]] += "(";
    marks.behind[counted[run.to - 1]] += run.close;
  }
  return marks;
}

}  // namespace durero::zed
