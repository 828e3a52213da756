#pragma once
/// The solver that is asked in tests of random predicates.

#include <unistd.h>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "durero/zed/smt/smt.hpp"

namespace durero::zed::test {

/// z3 on a script in a file; nothing where there is no z3.
class Z3 {
 public:
  Z3() : file_(std::filesystem::temp_directory_path() / ("durero-" + std::to_string(::getpid()) + ".smt2")) {}
  ~Z3() { std::filesystem::remove(file_); }
  Z3(const Z3&) = delete;
  Z3& operator=(const Z3&) = delete;
  static bool is_installed() { return std::system("z3 --version >/dev/null 2>&1") == 0; }

  SmtReply ask(const std::string& script) const {
    std::ofstream(file_) << script;
    std::FILE* const pipe = ::popen(("z3 -smt2 -T:5 " + file_.string()).c_str(), "r");
    if (!pipe) return {"", "does not start"};
    std::string output;
    std::array<char, 4096> some{};
    for (std::size_t count = 0; (count = std::fread(some.data(), 1, some.size(), pipe)) > 0;)
      output.append(some.data(), count);
    ::pclose(pipe);
    return output.starts_with("timeout") ? SmtReply{"", "gives no answer"} : SmtReply{output};
  }

 private:
  std::filesystem::path file_;
};

}  // namespace durero::zed::test
