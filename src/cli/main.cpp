#include "command_line.hpp"

int main(int argc, char* argv[]) { return durero::cli::command_line(argc, argv); }
