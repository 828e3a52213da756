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

std::string in_colour(int number, std::string_view text, int file) {
  return has_colour(file) ? fmt::format("\033[1;{}m{}\033[0m", number, text) : std::string(text);
}

}  // namespace

std::string in_red(std::string_view text, int file) { return in_colour(31, text, file); }

std::string in_green(std::string_view text, int file) { return in_colour(32, text, file); }

}  // namespace durero::cli
