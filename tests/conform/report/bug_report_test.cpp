#include "durero/conform/report/bug_report.hpp"

#include "conform/drafted.hpp"
#include "conform/judged.hpp"
#include "support/catch.hpp"

using namespace durero;
using namespace durero::conform;

namespace {

BugReport sphere_bug() {
  BugReport bug{.version = "Tracer 1.0", .asker = "durero 7", .call = "durero conform bug tracer generic/0000 --ray 3"};
  bug.system.title = "Tracer (trace)";
  bug.system.profile = test::profile_of_all();
  const Finding finding =
      test::finding_of(test::sphere_case({0.5, 0, 0}, {0, 0, 1}), test::hit_at(5), bug.system.profile);
  bug.least = {finding, explaining_data(finding, bug.system.profile)};
  bug.variations = {{"With v/|v| for v", finding}};
  return bug;
}

bool has(const std::string& text, std::string_view part) { return text.find(part) != text.npos; }

}  // namespace

TEST_CASE("a report says what, expected, got, versions, the question, the exact answer and data that explain it") {
  const std::string text = bug_text(sphere_bug(), false);
  CHECK(text.starts_with("# Tracer 1.0: misplaced\n\nExpected e0 at t = 3.133974596215561, point "));
  CHECK(has(text, "; got a hit at t = 5. The cause is not known.\n"));
  CHECK(has(text, "- With v/|v| for v it is misplaced as well.\n"));
  CHECK(
      has(text, "Tracer (trace), asked by durero 7: `durero conform bug tracer generic/0000 --ray 3`, made smaller."));
  CHECK(has(text, "```question\nscene generic/0000\nesfera e0 0 0 4 1\nrays 1\n0.5 0 0 0 0 1\n```\n"));
  CHECK(has(text, "esfera e0 0x0p+0 0x0p+0 0x1p+2 0x1p+0\nrays 1\n0x1p-1 "));
  CHECK(has(text, "```got\nhit - 5\n```\n"));
  CHECK(has(text, "```exact\ne0 at t = 3.133974596215561\n"));
  CHECK(has(text, "  t = 3.133974596215561353236276829247063816529\n    = 4 − "));
  CHECK(has(text, "have that answer: proved."));
  CHECK(!has(text, "## Reproducer"));
}

TEST_CASE("a cause is said where all that it is known by holds") {
  BugReport bug = sphere_bug();
  const auto cause = [&](const KnownCause& known) {
    bug.system.known = {known};
    return known_cause(bug);
  };
  CHECK(cause({{"missed", "misplaced"}, {}, {}, "why"}) == "why");
  CHECK(cause({{"missed"}, {}, {}, "why"}).empty());
  CHECK(cause({{"misplaced"}, {"cono", "esfera"}, {}, "why"}) == "why");
  CHECK(cause({{"misplaced"}, {"cono"}, {}, "why"}).empty());
  CHECK(cause({{"misplaced"}, {}, {"generic"}, "why"}) == "why");
  CHECK(cause({{"misplaced"}, {}, {"tiny"}, "why"}).empty());
  CHECK(has(about_bug(bug), "t = 3.1339745962155613"));
}

TEST_CASE("the reproducer stands in the report or beside it, with what it wrote, and one that shows nothing is said") {
  BugReport bug = sphere_bug();
  bug.file = "it.py";
  bug.program = "print(1)\n";
  bug.reproduction = {.output = "got: hit - 5\n", .verdict = Verdict::misplaced, .words = "exit status 0: "};
  CHECK(has(bug_text(bug, false),
            "It was run, and wrote:\n\n```reproduced\ngot: hit - 5\n```\n\n```py\nprint(1)\n```\n"));
  CHECK(has(bug_text(bug, true), "[it.py](it.py) stands alone"));
  CHECK(!has(bug_text(bug, true), "print(1)"));
  bug.reproduction.verdict = Verdict::right;
  CHECK(has(bug_text(bug, true), "It was run and does not show the failure (exit status 0: )"));
}
