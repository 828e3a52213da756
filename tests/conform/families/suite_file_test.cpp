#include "durero/conform/families/suite_file.hpp"

#include <filesystem>
#include <fstream>
#include <map>
#include <set>
#include <sstream>

#include "conform/families/suite_text.hpp"
#include "conform/hits.hpp"
#include "durero/io/source.hpp"
#include "support/catch.hpp"
#include "support/threads.hpp"

using namespace durero;
using namespace durero::test;
using namespace durero::conform;
namespace fs = std::filesystem;

namespace {

/// A folder that goes with the test.
class Folder {
 public:
  Folder() {
    std::string name = (fs::temp_directory_path() / "durero_suite_XXXXXX").string();
    REQUIRE(::mkdtemp(name.data()) != nullptr);
    path_ = name;
  }
  ~Folder() { fs::remove_all(path_); }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  std::string operator/(const std::string& name) const { return (path_ / name).string(); }
  const fs::path& path() const { return path_; }

 private:
  fs::path path_;
};

std::string content(const fs::path& path) {
  std::ifstream in(path, std::ios::binary);
  REQUIRE(in);
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

/// Every file, by its path in the directory.
std::map<std::string, std::string> contents(const fs::path& directory) {
  std::map<std::string, std::string> all;
  for (const auto& entry : fs::recursive_directory_iterator(directory)) {
    if (entry.is_regular_file()) all[fs::relative(entry.path(), directory).string()] = content(entry.path());
  }
  return all;
}

SuiteOptions small() {
  return {.families = {find_family("rim"), find_family("vertex"), find_family("in_surface")}, .seed = 3, .rays = 22};
}

/// Puts another text in place of the first place of one.
void alter(const fs::path& path, const std::string& from, const std::string& to) {
  std::string text = content(path);
  const std::size_t at = text.find(from);
  REQUIRE(at != text.npos);
  std::ofstream(path, std::ios::binary) << text.replace(at, from.size(), to);
}

/// What is said of the suite.
std::string complaint(const std::string& directory) {
  try {
    read_suite(directory);
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "";
}

}  // namespace

TEST_CASE("a suite that was written reads back to the same cases, answers and solids") {
  const Folder folder;
  for (const Caps caps : {Caps::open, Caps::solid}) {
    SuiteOptions options = small();
    options.caps = caps;
    const std::string directory = folder / (caps == Caps::open ? "open" : "solid");
    const std::vector<FamilySummary> families = write_suite(directory, options);
    REQUIRE(families.size() == 3);
    const Suite suite = read_suite(directory);
    REQUIRE(suite.cases.size() == 6);
    CHECK(suite.options.seed == 3);
    CHECK(suite.options.caps == caps);
    CHECK(suite.options.numbers == NumberFormat::binary32);
    std::size_t rays = 0;
    for (const SuiteCase& read : suite.cases) {
      SuiteCase drawn = suite_case(options, *read.family, read.number);
      answer(drawn);
      INFO(read.name());
      CHECK(read.the_case.rays == drawn.the_case.rays);
      CHECK(read.parameter == drawn.parameter);
      REQUIRE(read.truths.size() == drawn.truths.size());
      for (std::size_t i = 0; i < read.truths.size(); ++i) {
        CHECK(identical(read.truths[i].hit, drawn.truths[i].hit));
        CHECK(read.truths[i].permissible == drawn.truths[i].permissible);
      }
      REQUIRE(read.solids.size() == drawn.solids.size());
      for (std::size_t i = 0; i < read.solids.size(); ++i) {
        CHECK(read.solids[i].wall == drawn.solids[i].wall);
        CHECK(read.solids[i].discs == drawn.solids[i].discs);
      }
      rays += read.truths.size();
    }
    CHECK(rays == 3 * 22);
    std::size_t counted = 0;
    for (const FamilySummary& family : families) {
      CHECK(family.cases == 2);
      CHECK(family.count.rays == 22);
      CHECK(family.count.members > 11);
      for (const std::size_t rays_of_class : family.ambiguities) counted += rays_of_class;
    }
    CHECK(counted == rays);
  }
}

TEST_CASE("the same options give the same bytes on any number of threads, and another seed gives others") {
  const Folder folder;
  for (const int threads : {1, 2, 3})
    on_threads(threads, [&] { return write_suite(folder / std::to_string(threads), small()); });
  const auto one = contents(folder.path() / "1");
  CHECK(one.size() == 1 + 6 * 6);
  CHECK(contents(folder.path() / "2") == one);
  CHECK(contents(folder.path() / "3") == one);
  SuiteOptions other = small();
  other.seed = 4;
  write_suite(folder / "other", other);
  CHECK(contents(folder.path() / "other") != one);
}

TEST_CASE("the files of a case are the scene, the rays, the answers and what there is to know of them") {
  const Folder folder;
  write_suite(folder / "suite", small());
  const auto all = contents(folder.path() / "suite");
  std::set<std::string> endings;
  for (const auto& [name, text] : all)
    if (name.starts_with("rim/0001")) endings.insert(name.substr(8));
  CHECK(endings ==
        std::set<std::string>{".scene.json", ".rays.txt", ".rays.npy", ".hits.jsonl", ".hits.npy", ".case.json"});
  const std::string& sidecar = all.at("rim/0001.case.json");
  CHECK(sidecar.starts_with("{\"format\":\"durero-case\",\"version\":1,\"family\":\"rim\",\"kind\":\"through a rim, "));
  CHECK(sidecar.find("\"number\":1,\"parameter\":{\"name\":\"log2 of the distance\",\"value\":") != sidecar.npos);
  CHECK(sidecar.find("\"rays\":6,\"members\":") != sidecar.npos);
  CHECK(all.at("rim/0000.case.json").find("\"ambiguity\":\"rim\",\"permissible\":[{\"outcome\":") != sidecar.npos);
  CHECK(all.at("suite.json")
            .starts_with("{\"format\":\"durero-suite\",\"version\":2,\"seed\":3,\"rays\":22,\"numbers\":\"binary32\","
                         "\"caps\":\"open\",\"tipos\":[\"esfera\",\"cilindro\",\"cono\","));
}

TEST_CASE("a family without scenes of the types has no cases, and is listed so") {
  const Folder folder;
  SuiteOptions options = small();
  options.tipos = {model::Tipo::soy_cono};
  const auto families = write_suite(folder / "suite", options);
  CHECK(families[0].cases == 2);
  CHECK(families[2].cases == 0);
  CHECK(content(folder / "suite/suite.json").find("\"cases\":0,\"rays\":0") != std::string::npos);
  CHECK_FALSE(fs::exists(folder / "suite/vertex"));
  CHECK(read_suite(folder / "suite").cases.size() == 4);
}

TEST_CASE("a directory appears whole or not at all, and one that holds something is refused") {
  const Folder folder;
  fs::create_directory(folder / "empty");
  write_suite(folder / "empty/", small());
  CHECK(fs::exists(folder / "empty/suite.json"));
  const auto before = contents(folder.path());
  CHECK_THROWS_WITH(write_suite(folder / "empty", small()),
                    Catch::Contains("it is there already, and is no empty directory; expected a directory that can"));
  CHECK_THROWS_AS(write_suite(folder / "empty/suite.json", small()), io::FileError);
  CHECK_THROWS_AS(write_suite(folder / "none/suite", small()), io::FileError);
  CHECK(contents(folder.path()) == before);
  CHECK(std::distance(fs::directory_iterator(folder.path()), fs::directory_iterator()) == 1);
}

TEST_CASE("whatever a file says that does not follow is an error at its place") {
  const Folder folder;
  const std::string suite = folder / "suite";
  write_suite(suite, small());
  const auto fails = [&](const std::string& file, const std::string& from, const std::string& to,
                         const std::string& place) {
    const std::string path = suite + "/" + file, kept = content(path);
    alter(path, from, to);
    const std::string said = complaint(suite);
    INFO(file << ": " << from << " -> " << to << ": " << said);
    CHECK(said.find(file + ":" + place) != said.npos);
    CHECK(said.find("; expected ") != said.npos);
    std::ofstream(path, std::ios::binary) << kept;
  };
  CHECK(complaint(suite).empty());
  // A wrong answer, whichever file says it.
  fails("rim/0000.hits.jsonl", "\"outcome\":\"hit\"", "\"outcome\":\"miss\"", "");
  fails("rim/0000.hits.npy", "hit", "mis", "");
  fails("rim/0000.case.json", "\"ambiguity\":\"rim\"", "\"ambiguity\":\"none\"", "");
  fails("rim/0000.case.json", "\"members\":", "\"members\":1", "2:");
  fails("rim/0000.case.json", "\"value\":", "\"value\":0.5", "2:");
  fails("rim/0000.case.json", "\"solids\":[]", "\"solids\":[{\"wall\":\"x\",\"discs\":[]}]", "3:");
  fails("rim/0000.rays.npy", "descr", "desc_", "1:");
  fails("rim/0000.rays.txt", "\n", "\n1 2 3 4 5 6\n", "");
  fails("rim/0000.rays.txt", " ", " x", "1:");
  fails("rim/0000.scene.json", "\"version\":1", "\"version\":2", "1:");
  fails("suite.json", "durero-suite", "durero-scene", "1:11");
  fails("suite.json", "\"version\":2", "\"version\":3", "1:");
  fails("suite.json", "\"seed\":3", "\"seed\":-3", "1:");
  fails("suite.json", "binary32", "binary16", "1:");
  fails("suite.json", "\"open\"", "\"shut\"", "1:");
  fails("suite.json", "\"esfera\"", "\"cubo\"", "1:");
  fails("suite.json", "\"family\":\"rim\"", "\"family\":\"rin\"", "3:");
  fails("suite.json", "\"exact\":", "\"exact\":1", "");
  fails("suite.json", "through a rim", "through the rim", "3:");
  // More, or less, at the end of a file.
  const std::string hits = suite + "/rim/0000.hits.jsonl", kept = content(hits);
  std::ofstream(hits, std::ios::binary) << kept << "{}\n";
  CHECK(complaint(suite).find("0000.hits.jsonl:17:1: \"{}\\x0a\"; expected the end") != std::string::npos);
  std::ofstream(hits, std::ios::binary) << kept.substr(0, kept.size() - 1);
  CHECK(complaint(suite).find("the end; expected \"\\x0a\"") != std::string::npos);
  std::ofstream(hits, std::ios::binary) << kept;
  CHECK(complaint(suite).empty());
  fs::remove(suite + "/rim/0001.hits.npy");
  CHECK(complaint(suite).find("0001.hits.npy") != std::string::npos);
}

TEST_CASE("the files are the same bytes in every build") {
  // Where the meaning of the bytes changes (a family, a format), this number is a new one.
  std::uint64_t all = 0xcbf29ce484222325;  // FNV-1a
  for (const Caps caps : {Caps::open, Caps::solid}) {
    const SuiteOptions options{.seed = 11, .rays = 64, .caps = caps};
    for (const Family& family : families_of_few()) {
      for (std::uint64_t number = 0; number < cases(options, family); ++number) {
        SuiteCase of = suite_case(options, family, number);
        answer(of);
        for (const File& file : case_files(of, summary(of).count))
          for (const char c : file.text) all = (all ^ static_cast<unsigned char>(c)) * 0x100000001b3;
      }
    }
  }
  CHECK(all == 0xda28956c1e6419c1);
}
