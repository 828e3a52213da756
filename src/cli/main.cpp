// The `durero` command: one subcommand, one exit status, and at most one line of error.
#include <fmt/format.h>

#include <cstdio>
#include <exception>
#include <new>
#include <string>

#include "commands.hpp"
#include "durero/number/memory.hpp"
#include "durero/text/shown.hpp"

namespace {

constexpr int bad_input = 2;

// An error is one line that a terminal prints and does not obey, whatever it quotes.
int refuse(const std::string& what) {
  fmt::print(stderr, "durero: {}\n", durero::text::escaped(what));
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
  durero::cli::add_engines(app, status);
  durero::cli::add_agree(app, status);
  durero::cli::add_conform(app, status);
  durero::cli::add_import(app, status);
  durero::cli::add_export(app, status);
  durero::cli::add_spec(app, status);
  durero::number::throw_when_numbers_outgrow_memory();
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
