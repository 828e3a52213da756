#include <fmt/core.h>

#include <set>

#include "durero/zed/review/review.hpp"
#include "durero/zed/types/typecheck.hpp"
#include "support/catch.hpp"
#include "zed/lines.hpp"

/// The corpus: small Z texts, each with one construct (right/) or one defect (wrong/, on the line that ends in
/// `% here`). tests/spec/corpus.sh has CZT judge the same files.

using namespace durero::zed;
using namespace durero::zed::test;

namespace {

std::vector<Defect> judged(const std::string& file) {
  const Specification read = read_files({file});
  std::vector<Defect> defects = read.defects;
  for (Defect& defect : check(read).defects) defects.push_back(std::move(defect));
  return defects;
}

}  // namespace

TEST_CASE("every right text of the corpus is accepted") {
  const std::vector<std::string> files = files_in("tests/zed/corpus/right");
  CHECK(files.size() >= 80);
  for (const std::string& file : files)
    for (const Defect& defect : judged(file)) FAIL_CHECK(defect.text());
}

TEST_CASE("what is no error of types is an opinion or a warning, and refuses no right text") {
  for (const std::string& file : files_in("tests/zed/corpus/right"))
    for (const Defect& defect : review(read_files({file})))
      if (defect.severity == Defect::Severity::error) FAIL_CHECK(defect.text());
}

TEST_CASE("every wrong text of the corpus is refused, at its marked line and nowhere else") {
  const std::vector<std::string> files = files_in("tests/zed/corpus/wrong");
  CHECK(files.size() >= 80);
  for (const std::string& file : files) {
    Lines marked;
    marks(
        file, [](const std::string& word) { return word == "here"; }, marked);
    std::set<unsigned> wanted, lines;
    for (const auto& [line, what] : marked[file]) wanted.insert(line);
    std::string all;
    for (const Defect& defect : judged(file)) {
      lines.insert(defect.place.line);
      all += defect.text() + "\n";
    }
    CAPTURE(file, all);
    CHECK(wanted.size() == 1);
    CHECK(lines == wanted);
  }
}
