#include "durero/conform/ask/ranges_file.hpp"

#include "support/catch.hpp"

using namespace durero;
using namespace durero::conform;

namespace {

std::vector<AskedRange> read(const std::string& text, QuestionKind question, std::size_t rays) {
  return read_ranges(io::Source("f", text), question, rays);
}

}  // namespace

TEST_CASE("a range is a line of one end or of two, as the question has it") {
  CHECK(read("2.5\n\n# none\n 1e3 # far\n", QuestionKind::shadow, 2) == std::vector<AskedRange>{{0, 2.5}, {0, 1000}});
  CHECK(read("0 4\n3\t2", QuestionKind::range, 2) == std::vector<AskedRange>{{0, 4}, {3, 2}});
  CHECK(read("", QuestionKind::range, 0).empty());
  CHECK(ranges_text(QuestionKind::range, read("0 4\n3\t2", QuestionKind::range, 2)) == "0 4\n3 2\n");
  CHECK(ranges_text(QuestionKind::shadow, read("2.5", QuestionKind::shadow, 1)) == "2.5\n");
}

TEST_CASE("what is no range of the rays is refused at its place") {
  CHECK_THROWS_WITH(read("1 2\n", QuestionKind::shadow, 1), "f:1:1: 2 numbers; expected T, the end of a ray");
  CHECK_THROWS_WITH(read("1 2\n1\n", QuestionKind::range, 2), "f:2:1: 1 numbers; expected T0 T1, the ends of a ray");
  CHECK_THROWS_WITH(read("1 -2\n", QuestionKind::range, 1), "f:1:3: \"-2\"; expected a number that is not negative");
  CHECK_THROWS_WITH(read("1 inf\n", QuestionKind::range, 1), "f:1:3: \"inf\"; expected a number that is not negative");
  CHECK_THROWS_WITH(read("1\n", QuestionKind::shadow, 2), "f:2:1: 1 ranges; expected 2, one a ray");
}
