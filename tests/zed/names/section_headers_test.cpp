#include "durero/zed/names/section_headers.hpp"

#include "support/catch.hpp"

using durero::zed::section_headers;
using Headers = std::vector<std::pair<std::string, std::vector<std::string>>>;

TEST_CASE("the headers of a text are read in both mark-ups, and a broken one is left out") {
  CHECK(section_headers("\\begin{zsection}\n\\SECTION a\\_b \\parents c, standard\\_toolkit\n\\end{zsection}\n") ==
        Headers{{"a_b", {"c", "standard_toolkit"}}});
  CHECK(section_headers("─ section a parents b\n└\n─ section c\n└\n") == Headers{{"a", {"b"}}, {"c", {}}});
  CHECK(section_headers("\\begin{zsection}\n\\parents c\n\\end{zsection}\n").empty());
  CHECK(section_headers("┌ S\nx : ℕ\n└\n").empty());
}
