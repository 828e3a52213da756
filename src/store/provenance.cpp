#include "durero/store/provenance.hpp"

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <cstdlib>
#include <ctime>
#include <stdexcept>

#include "durero/text/shown.hpp"

namespace durero::store {
namespace {

void require_one_line(const char* what, const std::string& said) {
  if (text::escaped(said) != said)
    throw std::invalid_argument(fmt::format("{} {}: no line of text; expected characters that a line shows, in UTF-8",
                                            what, text::shown(said)));
}

}  // namespace

std::string author_of_environment() {
  for (const char* const name : {"DURERO_AUTHOR", "LOGNAME", "USER"})
    if (const char* const author = std::getenv(name); author != nullptr && *author != '\0')
      return text::escaped(author);
  return "";
}

std::string time_now() { return fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", fmt::gmtime(std::time(nullptr))); }

void require_provenance(const Provenance& by) {
  require_one_line("author", by.author);
  require_one_line("comment", by.comment);
  if (!is_time(by.time))
    throw std::invalid_argument(
        fmt::format("time {}: no time; expected one of UTC, as 2026-01-31T12:00:00Z", text::shown(by.time)));
}

}  // namespace durero::store
