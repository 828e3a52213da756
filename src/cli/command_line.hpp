#pragma once
/// The `durero` command: one subcommand, one exit status, and at most one line of error.

namespace durero::cli {

/// The exit status of the command that was called by these words, the first of which is the program's name. It prints
/// what the command answers, or one line of what is wrong. A signal that ends the process removes its temporary files.
int command_line(int argc, char* argv[]);

}  // namespace durero::cli
