#include "durero/conform/ask/system_file.hpp"

#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <limits>
#include <optional>

#include "durero/io/output_file.hpp"
#include "support/catch.hpp"

using namespace durero;
using namespace durero::conform;
namespace fs = std::filesystem;

namespace {

const std::string least = R"({"format":"durero-system","version":1,"system":"s","title":"S 1",
"ask":["{python}","{here}/ask.py"],
"profile":{"format":"binary32","tipos":["esfera","disco"],"caps":"open","measure":"parameter","directions":"any",
"inside":"exit_point","names_elements":true}})";

const std::string whole = R"({"format":"durero-system","version":1,"system":"s","title":"S 1",
"install":{"debian":["a","b"],"pypi":["c==1"]},
"build":["c++","-o","{out}","{here}/ask.cpp","-L{setup}/lib"],
"ask":["{python}","{out}"],
"profile":{"format":"binary64","tipos":["cilindro"],"caps":"solid","measure":"length","directions":"unchecked",
"inside":"nothing","names_elements":false,"least_t":0.5,"greatest_t":1e10,"least_size":1e-3,"greatest_size":1e3,
"greatest_coordinate":1e7,"thickness":1e-9,"watertight":true},
"sources":[{"claim":"directions","sentence":"The direction is of unit length.","place":"manual, 2"}]})";

System read(const std::string& text) { return read_system({"/systems/folder/s.json", text}, "/cache"); }

std::string replaced(std::string text, const std::string& what, const std::string& with) {
  REQUIRE(text.find(what) != text.npos);
  return text.replace(text.find(what), what.size(), with);
}

std::string refusal(const std::string& what, const std::string& with) {
  try {
    read(replaced(whole, what, with));
  } catch (const io::InputError& error) {
    return error.what();
  }
  return "nothing is wrong";
}

struct Folder {
  Folder() { fs::create_directories(path + "/a"); }
  ~Folder() { fs::remove_all(path); }
  std::string path = fs::temp_directory_path() / ("system_file_test." + std::to_string(::getpid()));
};

/// A variable of the environment, which is again what it was when this ends.
class Variable {
 public:
  explicit Variable(const char* name) : name_(name) {
    if (const char* const value = std::getenv(name)) value_ = value;
  }
  ~Variable() {
    if (value_)
      ::setenv(name_, value_->c_str(), 1);
    else
      ::unsetenv(name_);
  }
  Variable(const Variable&) = delete;
  Variable& operator=(const Variable&) = delete;

 private:
  const char* name_;
  std::optional<std::string> value_;
};

}  // namespace

TEST_CASE("a system is read with its places filled in") {
  const System system = read(whole);
  CHECK(system.name == "s");
  CHECK(system.title == "S 1");
  CHECK(system.packages.at("debian") == std::vector<std::string>{"a", "b"});
  CHECK(system.packages.at("pypi") == std::vector<std::string>{"c==1"});
  CHECK(system.build == Command{"c++", "-o", "/cache/s/ask", "/systems/folder/ask.cpp", "-L/cache/s/lib"});
  CHECK(system.ask == Command{"/cache/s/venv/bin/python", "/cache/s/ask"});
  const Profile& profile = system.profile;
  CHECK(profile.system == "s");
  CHECK(profile.format == NumberFormat::binary64);
  CHECK(profile.tipos == std::vector{model::Tipo::soy_cilindro});
  CHECK(profile.caps == Caps::solid);
  CHECK(profile.measure == Measure::length);
  CHECK(profile.directions == Directions::unchecked);
  CHECK(profile.inside == Inside::nothing);
  CHECK_FALSE(profile.names_elements);
  CHECK(profile.least_t == 0.5);
  CHECK(profile.greatest_t == 1e10);
  CHECK(profile.least_size == 1e-3);
  CHECK(profile.greatest_size == 1e3);
  CHECK(profile.greatest_coordinate == 1e7);
  CHECK(profile.thickness == 1e-9);
  CHECK(profile.watertight);
  CHECK_FALSE(read(least).profile.watertight);
  REQUIRE(profile.sources.size() == 1);
  CHECK(profile.sources[0].claim == "directions");
  CHECK(profile.sources[0].sentence == "The direction is of unit length.");
  CHECK(profile.sources[0].place == "manual, 2");
}

TEST_CASE("a system that says the least has no limits, and the python of the machine") {
  const System system = read(least);
  CHECK(system.ask == Command{"python3", "/systems/folder/ask.py"});
  CHECK(system.build.empty());
  CHECK(system.packages.empty());
  CHECK(system.profile.format == NumberFormat::binary32);
  CHECK(system.profile.tipos == std::vector{model::Tipo::soy_esfera, model::Tipo::soy_disco});
  CHECK(system.profile.greatest_t == std::numeric_limits<double>::infinity());
  CHECK(system.profile.least_t == 0);
  CHECK(system.profile.sources.empty());
}

TEST_CASE("what is wrong in a system's file is said at its place") {
  const std::string file = "/systems/folder/s.json:";
  CHECK(refusal("S 1", "S 2") == "nothing is wrong");
  CHECK(refusal("durero-system", "durero-scene") ==
        file + "1:11: format is \"durero-scene\"; expected \"durero-system\"");
  CHECK(refusal("\"version\":1", "\"version\":2") ==
        file + "1:37: version 2 of durero-system; expected 1 (written by a newer durero?)");
  CHECK(refusal("\"s\"", "\"t\"") == file + "1:48: system is \"t\"; expected \"s\"");
  CHECK(refusal("debian", "cpan").starts_with(file + "2:12: unknown key \"cpan\" in install; expected one of debian"));
  CHECK(refusal("[\"c==1\"]", "[]") == file + "2:38: pypi is empty; expected one string at least");
  CHECK(refusal("binary64", "binary16") == file + "5:21: format is \"binary16\"; expected one of binary32, binary64");
  CHECK(refusal("cilindro", "cubo").starts_with(file + "5:41: a tipo is \"cubo\"; expected one of esfera, cilindro"));
  CHECK(refusal("[\"cilindro\"]", "[]").starts_with(file + "5:40: tipos is empty"));
  CHECK(refusal("solid", "round").starts_with(file + "5:60: caps is \"round\"; expected one of open, solid"));
  CHECK(refusal("length\"", "metre\"").starts_with(file + "5:78: measure is"));
  CHECK(refusal("unchecked", "none").starts_with(file + "5:100: directions is"));
  CHECK(refusal("nothing", "all").starts_with(file + "6:10: inside is"));
  CHECK(refusal("false", "0").starts_with(file + "6:37: names_elements is a number"));
  CHECK(refusal("0.5", "-0.5") == file + "6:53: least_t is -0.5; expected a number that is not negative");
  CHECK(refusal("claim\":\"directions", "claim\":\"speed").starts_with(file + "8:21: claim is \"speed\""));
  CHECK(refusal("manual, 2", "").starts_with(file + "8:"));
  CHECK(refusal("\"inside\":\"nothing\",", "").find("inside") != std::string::npos);
}

TEST_CASE("systems are found by name in the folders of a folder") {
  const Folder folder;
  io::write_file(folder.path + "/a/s.json", least);
  io::write_file(folder.path + "/a/package.json", "{}");
  io::write_file(folder.path + "/notes.json", "not looked at");
  CHECK(system_files(folder.path) == std::map<std::string, std::string>{{"s", folder.path + "/a/s.json"}});
  CHECK(find_system("s", folder.path, "/cache").ask[1] == folder.path + "/a/ask.py");
  CHECK_THROWS_WITH(find_system("t", folder.path, "/cache"), "no system \"t\"; expected one of s");
  CHECK_THROWS_WITH(system_files(folder.path + "/b"), folder.path + "/b: no folder; expected one with systems in it");
  fs::create_directories(folder.path + "/b");
  io::write_file(folder.path + "/b/s.json", least);
  CHECK_THROWS_WITH(system_files(folder.path), Catch::Contains("its name is also that of"));
}

TEST_CASE("a profile is that of a system, or a file alone") {
  const Folder folder;
  io::write_file(folder.path + "/a/s.json", whole);
  CHECK(read_profile("s", folder.path).caps == Caps::solid);
  CHECK(read_profile(folder.path + "/a/s.json", folder.path).caps == Caps::solid);
  const std::string members = whole.substr(whole.find("\"profile\""));
  const std::string head = R"({"format":"durero-profile","version":1,"system":"mine",)";
  io::write_file(folder.path + "/mine.json", head + members);
  const Profile mine = read_profile(folder.path + "/mine.json", folder.path);
  CHECK(mine.system == "mine");
  CHECK(mine.caps == Caps::solid);
  CHECK(mine.sources.size() == 1);
  io::write_file(folder.path + "/mine.json", replaced(head, "profile", "hits") + members);
  CHECK_THROWS_AS(read_profile(folder.path + "/mine.json", folder.path), io::InputError);
}

TEST_CASE("setups are kept where the user's caches are") {
  const Variable cache("XDG_CACHE_HOME"), home("HOME");
  ::setenv("XDG_CACHE_HOME", "/c", 1);
  ::setenv("HOME", "/h", 1);
  CHECK(default_setups() == "/c/durero/systems");
  ::setenv("XDG_CACHE_HOME", "relative", 1);
  CHECK(default_setups() == "/h/.cache/durero/systems");
  ::unsetenv("XDG_CACHE_HOME");
  CHECK(default_setups() == "/h/.cache/durero/systems");
  ::unsetenv("HOME");
  CHECK_THROWS_WITH(default_setups(), Catch::Contains("expected a folder for systems"));
}

TEST_CASE("how a failure is reproduced and what is known to fail are read, places filled in") {
  const std::string more = R"(,"reproduce":{"program":"reproduce.py.in","words":{"variant":"scalar"},
"run":[["cc","-o","{built}","{program}"],["{python}","{setup}"]]},
"known":[{"verdicts":["missed"],"cause":"why"},{"verdicts":["off"],"types":["cono"],"families":["tiny"],"cause":"x"}]})";
  const System system = read(whole.substr(0, whole.rfind('}')) + more);
  CHECK(system.reproducer.program == "/systems/folder/reproduce.py.in");
  CHECK(system.reproducer.words.at("variant") == "scalar");
  CHECK(system.reproducer.run ==
        std::vector<Command>{{"cc", "-o", "{built}", "{program}"}, {"/cache/s/venv/bin/python", "/cache/s"}});
  REQUIRE(system.known.size() == 2);
  CHECK(system.known[0].cause == "why");
  CHECK(system.known[0].tipos.empty());
  CHECK(system.known[1].tipos == std::vector<std::string>{"cono"});
  CHECK(system.known[1].families == std::vector<std::string>{"tiny"});
  CHECK(read(whole).reproducer.program.empty());
  const std::string no_cause = whole.substr(0, whole.rfind('}')) + R"(,"known":[{"verdicts":["missed"]}]})";
  CHECK_THROWS_AS(read(no_cause), io::InputError);
  const std::string no_run = whole.substr(0, whole.rfind('}')) + R"(,"reproduce":{"program":"x"}})";
  CHECK_THROWS_AS(read(no_run), io::InputError);
}
