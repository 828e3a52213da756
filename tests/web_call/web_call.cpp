// web_call: a call a line from the standard input, its answer a line on the standard output.
#include <iostream>
#include <string>

#include "durero/web/call.hpp"

int main() {
  std::ios::sync_with_stdio(false);
  for (std::string line; std::getline(std::cin, line);) std::cout << durero::web::call(line) << '\n' << std::flush;
}
