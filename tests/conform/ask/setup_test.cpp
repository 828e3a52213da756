#include "durero/conform/ask/setup.hpp"

#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>

#include "durero/io/output_file.hpp"
#include "durero/io/source.hpp"
#include "support/catch.hpp"

using namespace durero;
using namespace durero::conform;
namespace fs = std::filesystem;

namespace {

const std::atomic<bool> never = false;

/// A folder with programs of its own on the PATH: each writes its name and arguments into the file `calls`.
class Machine {
 public:
  Machine() {
    fs::create_directories(path + "/bin");
    ::setenv("PATH", (path + "/bin:" + before).c_str(), 1);
    system.name = "s";
    system.title = "S 1";
    system.setup = path + "/setups/s";
    system.ask = {"sh"};
  }
  ~Machine() {
    ::setenv("PATH", before.c_str(), 1);
    fs::remove_all(path);
  }
  Machine(const Machine&) = delete;
  Machine& operator=(const Machine&) = delete;

  void has_program(const std::string& name, const std::string& and_does = "") {
    const std::string file = path + "/bin/" + name;
    io::write_file(file, "#!/bin/sh\necho " + name + " \"$@\" >>" + path + "/calls\n" + and_does + "\n");
    ::chmod(file.c_str(), 0755);
  }
  std::string calls() const {
    const std::string file = path + "/calls";
    return fs::exists(file) ? std::string(io::read_source(file).text()) : "";
  }
  void set_up() const {
    conform::set_up(
        system, [](std::string_view) {}, never);
  }
  std::string failure() const {
    try {
      set_up();
    } catch (const std::runtime_error& error) {
      return error.what();
    }
    return "nothing is wrong";
  }

  const std::string path = fs::temp_directory_path() / ("setup_test." + std::to_string(::getpid()));
  const std::string before = std::getenv("PATH");
  System system;
};

}  // namespace

TEST_CASE("a system that needs nothing is there when its program is") {
  Machine machine;
  CHECK(why_absent(machine.system).empty());
  machine.system.ask = {"no-such-program"};
  CHECK(why_absent(machine.system) == "there is no program no-such-program");
  machine.system.ask = {machine.path + "/bin"};
  machine.has_program("mine");
  machine.system.ask = {"mine"};
  CHECK(why_absent(machine.system).empty());
}

TEST_CASE("what a system needs is installed into its folder, and then what asks it is built") {
  Machine machine;
  for (const char* const program : {"python3", "npm", "c++"}) machine.has_program(program);
  machine.has_program("python3", "case $2 in venv) mkdir -p \"$3/bin\" && cp \"$0\" \"$3/bin/python\" ;; esac");
  machine.system.packages = {{"pypi", {"a==1", "b"}}, {"npm", {"c@2"}}, {"crates", {"d@3"}}};
  machine.system.build = {"c++", "x.cpp"};
  CHECK(why_absent(machine.system) == "it is not set up");
  machine.set_up();
  const std::string setup = machine.system.setup;
  CHECK(machine.calls() == "npm install --no-audit --no-fund --prefix " + setup + " c@2\n" +  //
                               "python3 -m venv " + setup + "/venv\n" +
                               "python3 -m pip install --quiet --disable-pip-version-check a==1 b\n" +  //
                               "c++ x.cpp\n");
  CHECK(why_absent(machine.system).empty());
}

TEST_CASE("Debian's packages are installed where they are missing, by root") {
  Machine machine;
  machine.has_program("dpkg-query", "[ \"$3\" = here ] && echo install ok installed");
  machine.has_program("apt-get");
  machine.system.packages = {{"debian", {"here"}}};
  machine.set_up();
  CHECK(machine.calls().find("apt-get") == std::string::npos);
  machine.system.packages = {{"debian", {"here", "gone"}}};
  if (::geteuid() == 0) {
    machine.set_up();
    CHECK(machine.calls().ends_with("apt-get -qq update\napt-get -qq install -y --no-install-recommends gone\n"));
  } else {
    CHECK(machine.failure() == "missing packages gone; expected root to have installed them: apt-get install gone");
    CHECK(machine.calls().find("apt-get") == std::string::npos);
  }
}

TEST_CASE("a setup that fails says why, and leaves nothing") {
  Machine machine;
  machine.has_program("npm", "mkdir -p \"$5\" && touch \"$5/half\"; echo no such package >&2; exit 4");
  machine.system.packages = {{"npm", {"c@2"}}};
  CHECK(machine.failure() == "npm failed: no such package\\x0a; expected it to end well");
  CHECK_FALSE(fs::exists(machine.system.setup));
  machine.has_program("npm");
  machine.set_up();
  CHECK(fs::exists(machine.system.setup));
  machine.has_program("npm", "exit 1");
  CHECK(machine.failure().starts_with("npm failed"));
  CHECK(why_absent(machine.system) == "it is not set up");  // what was there before is gone too
}

TEST_CASE("a setup that is interrupted leaves nothing") {
  Machine machine;
  machine.system.build = {"sleep", "60"};
  const std::atomic<bool> stop = true;
  CHECK_THROWS_WITH(set_up(
                        machine.system, [](std::string_view) {}, stop),
                    "interrupted; expected to go on");
  CHECK_FALSE(fs::exists(machine.system.setup));
}

TEST_CASE("each step is said before it is done") {
  Machine machine;
  machine.has_program("c++");
  machine.system.build = {"c++", "-o", "x"};
  std::vector<std::string> said;
  set_up(
      machine.system, [&](std::string_view line) { said.emplace_back(line); }, never);
  CHECK(said == std::vector<std::string>{"  c++ -o x"});
}
