// The `durero` command: one subcommand, one exit status, and at most one line of error.
#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <exception>
#include <new>
#include <string>

#include "commands.hpp"

namespace {

constexpr int bad_input = 2;

// An error is one line, whatever it quotes.
int refuse(std::string what) {
  std::ranges::replace_if(
      what, [](char c) { return static_cast<unsigned char>(c) < 0x20; }, ' ');
  fmt::print(stderr, "durero: {}\n", what);
  return bad_input;
}

}  // namespace

int main(int argc, char* argv[]) {
  CLI::App app("Ray and object intersection, formally specified and checked by contract", "durero");
  app.set_version_flag("--version", std::string("durero ") + DURERO_VERSION);
  int status = 0;
  durero::cli::add_check(app, status);
  durero::cli::add_edit(app, status);
  durero::cli::add_trace(app, status);
  durero::cli::add_render(app, status);
  durero::cli::add_agree(app, status);
  durero::cli::add_import(app, status);
  durero::cli::add_export(app, status);
  durero::cli::add_spec(app, status);
  try {
    app.parse(argc, argv);
    if (app.get_subcommands().empty()) return refuse("no subcommand; expected one that durero --help shows");
    return status;
  } catch (const CLI::Success& asked) {  // --help, --version
    return app.exit(asked);
  } catch (const CLI::ParseError& error) {
    return refuse(fmt::format("{}; expected what durero --help shows", error.what()));
  } catch (const std::bad_alloc&) {
    return refuse("memory ran out; expected a smaller input");
  } catch (const std::exception& error) {
    return refuse(error.what());
  }
}
