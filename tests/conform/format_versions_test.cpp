#include "durero/conform/format_versions.hpp"

#include <set>
#include <string>

#include "support/catch.hpp"

namespace durero {

TEST_CASE("each format has one name of its own and a version") {
  std::set<std::string> names;
  for (const auto& [format, version] : conform::format_versions) {
    CHECK(format.starts_with("durero-"));
    CHECK(version >= 1);
    CHECK(names.emplace(format).second);
  }
}

}  // namespace durero
