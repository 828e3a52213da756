// Who does something and when: the environment and the clock say so, and no text breaks a line of the log.
#include "durero/store/provenance.hpp"

#include <stdlib.h>

#include <stdexcept>

#include "support/catch.hpp"

using namespace durero;

TEST_CASE("the environment names the author, by the first of three names that says something") {
  ::setenv("DURERO_AUTHOR", "ann", 1);
  ::setenv("LOGNAME", "bob", 1);
  ::setenv("USER", "eve", 1);
  CHECK(store::author_of_environment() == "ann");
  ::setenv("DURERO_AUTHOR", "", 1);
  CHECK(store::author_of_environment() == "bob");
  ::unsetenv("LOGNAME");
  CHECK(store::author_of_environment() == "eve");
  ::setenv("USER", "e\nve", 1);
  CHECK(store::author_of_environment() == "e\\x0ave");
  ::unsetenv("USER");
  CHECK(store::author_of_environment().empty());
}

TEST_CASE("the time now is one, and does not go back") {
  const std::string before = store::time_now(), after = store::time_now();
  CHECK(store::is_time(before));
  CHECK(before <= after);
  CHECK(before > "2026-01-01T00:00:00Z");
}

TEST_CASE("an author, a comment and a time are refused that no log could show") {
  const auto is_refused = [](const store::Provenance& by) {
    try {
      store::require_provenance(by);
    } catch (const std::invalid_argument& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  const std::string noon = "2026-01-31T12:00:00Z";
  CHECK(is_refused({"ann", noon, "a reason"}).empty());
  CHECK(is_refused({"", noon, ""}).empty());
  CHECK(is_refused({"a\nb", noon, ""}).starts_with("author \"a\\x0ab\": no line of text; expected"));
  CHECK(is_refused({"", noon, "a\x1b"}).starts_with("comment \"a\\x1b\": no line of text; expected"));
  CHECK(is_refused({"", "2026-02-31T12:00:00Z", ""}).starts_with("time \"2026-02-31T12:00:00Z\": no time; expected"));
  CHECK(is_refused({"", "", ""}).starts_with("time "));
}
