#include "command_line.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <csignal>
#include <exception>
#include <new>
#include <sstream>
#include <string>
#include <vector>

#include "call_error.hpp"
#include "colour.hpp"
#include "commands.hpp"
#include "description.hpp"
#include "durero/io/standard_output.hpp"
#include "durero/io/temporary.hpp"
#include "durero/number/memory.hpp"
#include "durero/text/shown.hpp"
#include "help.hpp"

namespace durero::cli {
namespace {

constexpr int bad_input = 2;

// An error is one line that a terminal prints and does not obey, whatever it quotes.
int refuse(const std::string& what) {
  io::complain(fmt::format("{} {}\n", in_red("durero:", STDERR_FILENO), text::escaped(what)));
  return bad_input;
}

// Prints the text that was asked for: --help, --version. Throws CLI::ExtrasError where help is asked of no command.
int print_asked(const CLI::App& app, const CLI::Success& asked) {
  if (dynamic_cast<const CLI::CallForHelp*>(&asked) != nullptr) {
    const CLI::App& command = called(app);
    const std::vector<std::string> words = command.remaining();
    if (!words.empty() && !subcommands(command).empty()) throw CLI::ExtrasError(command.get_name(), words);
    io::print(command.help());
    return 0;
  }
  std::ostringstream said;
  const int status = app.exit(asked, said, said);
  io::print(said.str());
  return status;
}

void add_commands(CLI::App& app, int& status) {
  for (const auto& [title, commands] : command_groups()) {
    for (const auto add : commands) {
      add(app, status);
      app.get_subcommands([](CLI::App*) { return true; }).back()->group(title);
    }
  }
}

/// A flag is given or not: `--json=no` is no way to say so.
void let_flags_have_no_values(CLI::App& command) {
  for (CLI::Option* option : command.get_options())
    if (option->get_items_expected_max() == 0) option->disable_flag_override();
  for (CLI::App* below : command.get_subcommands([](CLI::App*) { return true; })) let_flags_have_no_values(*below);
}

// Takes the numbers of closed standard files, which stay useless: no file that is opened gets such a number, for the
// output of the program would go there.
void take_numbers_of_closed_files() {
  for (const int file : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
    if (::fcntl(file, F_GETFD) < 0) ::open("/dev/null", file == STDIN_FILENO ? O_WRONLY : O_RDONLY);
  }
}

}  // namespace

int command_line(int argc, char* argv[]) {
  take_numbers_of_closed_files();
  std::signal(SIGPIPE, SIG_IGN);  // a closed pipe is an error like any other
  io::remove_temporaries_at_signals();
  CLI::App app("Ray and object intersection, formally specified and checked by contract", "durero");
  app.formatter(std::make_shared<Help>());
  app.set_help_flag("-h,--help", "Print this, and nothing else");
  app.set_version_flag("--version", std::string("durero ") + DURERO_VERSION, "Print the version, and nothing else");
  app.require_subcommand(1);
  int status = 0;
  add_commands(app, status);
  app.footer(exit_status("yes, or done", "the answer is no", "the call or the input is bad") +
             examples({"check demo/still-life.json", "trace demo/still-life.json demo/rays.txt",
                       "render demo/still-life.json -o still-life.png", "trace --help"}));
  let_flags_have_no_values(app);
  number::throw_when_numbers_outgrow_memory();
  try {
    io::require_standard_output();
    try {
      app.parse(argc, argv);
      return status;
    } catch (const CLI::Success& asked) {
      return print_asked(app, asked);
    }
  } catch (const CLI::ParseError& error) {
    return refuse(call_error(app, error));
  } catch (const std::bad_alloc&) {
    return refuse("memory ran out; expected a smaller input");
  } catch (const std::exception& error) {
    return refuse(error.what());
  }
}

}  // namespace durero::cli
