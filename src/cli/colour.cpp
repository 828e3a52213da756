#include "colour.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdlib>

namespace durero::cli {
namespace {

bool has_colour(int file) {
  const char* const none = std::getenv("NO_COLOR");
  const char* const terminal = std::getenv("TERM");
  return ::isatty(file) == 1 && (none == nullptr || *none == '\0') &&
         (terminal == nullptr || std::string_view(terminal) != "dumb");
}

}  // namespace

std::string in_red(std::string_view text, int file) {
  return has_colour(file) ? fmt::format("\033[1;31m{}\033[0m", text) : std::string(text);
}

}  // namespace durero::cli
