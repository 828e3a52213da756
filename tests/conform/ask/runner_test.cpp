#include "durero/conform/ask/runner.hpp"

#include <fmt/format.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <filesystem>
#include <set>

#include "durero/conform/ask/question.hpp"
#include "durero/io/output_file.hpp"
#include "durero/io/source.hpp"
#include "durero/model/operaciones.hpp"
#include "support/catch.hpp"
#include "support/tree.hpp"

using namespace durero;
using namespace durero::conform;
using Outcome = Claim::Outcome;
namespace fs = std::filesystem;

namespace {

System fake(const std::string& how) {
  System system;
  system.name = "fake";
  const std::string quick_to_start = "/usr/bin/python3";  // Debian's; another may be a script around one
  system.ask = {fs::exists(quick_to_start) ? quick_to_start : "python3", "-S", "-E",
                test::source_dir() + "/tests/conform/fake_system.py", how};
  return system;
}

/// What fake_system.py goes by: the x of the ray.
using Number = double (*)(std::size_t ray_of_all);

constexpr std::size_t rays_a_case = 32;

double plain(std::size_t ray) { return static_cast<double>(ray) - 10; }
/// One ray of a hundred crashes the system, and one of a thousand lets it hang.
double faulty(std::size_t ray) {
  const auto x = static_cast<double>(ray);
  return ray % 1000 == 333 ? 2000 : ray % 100 == 50 ? 1000 : x / 1024;
}

RunCases cases(std::size_t count, Number number) {
  RunCases made;
  made.count = count;
  made.outside = [](const SuiteCase& of) { return std::vector<std::string>(of.the_case.rays.size()); };
  made.make = [number](std::size_t place) {
    SuiteCase of;
    of.family = find_family("generic");
    of.number = place;
    of.the_case.scene.apply(model::Agregar_Esfera{model::Elemento("e0"), {0, 0, 5}, 1});
    for (std::size_t ray = 0; ray < rays_a_case; ++ray)
      of.the_case.rays.push_back({{{number(place * rays_a_case + ray), 0, 0}, {0, 0, 1}}});
    return of;
  };
  return made;
}

RunOptions quick(std::size_t jobs = 1) {
  RunOptions options;
  options.ask.time = std::chrono::duration<double>(0.5);
  options.ask.time_to_start = std::chrono::duration<double>(20);
  options.jobs = jobs;
  return options;
}

/// What was handed on, a line a ray; and whether it came in order.
struct Seen {
  std::vector<std::string> lines;
  std::vector<Claim> claims;
  ClaimSink sink() {
    return [this](const SuiteCase& of, std::span<const Claim> its_claims) {
      CHECK(of.number * rays_a_case == claims.size());
      for (const Claim& claim : its_claims) {
        claims.push_back(claim);
        lines.push_back(claim_text(claim, of.the_case.scene));
      }
    };
  }
};

const std::atomic<bool> never = false;

struct Result {
  Seen seen;
  RunEnd end;
};

Result run(const std::string& how, const RunCases& of, const RunOptions& options = quick()) {
  Result result;
  result.end = run_system(fake(how), of, options, result.seen.sink(), never);
  return result;
}

Claim right_claim(double x) { return x < 0 ? Claim{.outcome = Outcome::miss} : Claim{.outcome = Outcome::hit, .t = x}; }

/// Every ray but these has its own answer.
void check_right(const Seen& seen, std::size_t count, Number number, const std::set<std::size_t>& but = {}) {
  REQUIRE(seen.claims.size() == count * rays_a_case);
  std::size_t wrong = 0;
  for (std::size_t ray = 0; ray < seen.claims.size(); ++ray)
    wrong += !but.contains(ray) && seen.claims[ray] != right_claim(number(ray));
  CHECK(wrong == 0);
}

std::string failure(const std::string& how, std::size_t count = 3) {
  try {
    run(how, cases(count, plain));
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "nothing is wrong";
}

struct Folder {
  Folder() { fs::create_directories(path); }
  ~Folder() { fs::remove_all(path); }
  std::string path = fs::temp_directory_path() / ("runner_test." + std::to_string(::getpid()));
  std::string claims = path + "/claims.jsonl";
};

bool no_child_is_left() { return ::waitpid(-1, nullptr, WNOHANG) == -1 && errno == ECHILD; }

}  // namespace

TEST_CASE("each ray has the answer that the system gave to it, in order, whatever the number of jobs") {
  const Result alone = run("right", cases(20, plain));
  CHECK(alone.end.cases == 20);
  CHECK_FALSE(alone.end.stopped);
  CHECK(alone.end.says == "fake 1.0 right");
  CHECK(alone.end.deaths == 0);
  check_right(alone.seen, 20, plain);
  for (const std::size_t jobs : {2U, 5U})
    CHECK(run("right", cases(20, plain), quick(jobs)).seen.lines == alone.seen.lines);
  CHECK(run("right", cases(0, plain)).end.cases == 0);
  CHECK(no_child_is_left());
}

TEST_CASE("a crash or a hang costs its ray alone, also where answers come late") {
  std::set<std::size_t> deadly;
  for (std::size_t ray = 0; ray < 40 * rays_a_case; ++ray) {
    if (faulty(ray) >= 1000) deadly.insert(ray);
  }
  REQUIRE(deadly.size() == 14);
  for (const std::string how : {"noisy", "buffered"}) {
    const Result result = run(how, cases(40, faulty), quick(3));
    check_right(result.seen, 40, faulty, deadly);
    for (const std::size_t ray : deadly) {
      INFO(how << ", ray " << ray);
      CHECK(result.seen.lines[ray] ==
            (faulty(ray) == 2000 ? "hung no answer in 0.5 s" : "crashed signal 11 (Segmentation fault)"));
    }
    CHECK(result.end.deaths >= 2 * deadly.size());
    if (how == "noisy") CHECK(result.end.last_words == "assertion failed\n");
  }
  CHECK(no_child_is_left());
}

TEST_CASE("a scene that ends the system costs its own rays") {
  const Result result = run("scene", cases(3, plain));
  std::set<std::size_t> of_scene;
  for (std::size_t ray = rays_a_case; ray < 2 * rays_a_case; ++ray) of_scene.insert(ray);
  check_right(result.seen, 3, plain, of_scene);
  for (const std::size_t ray : of_scene) CHECK(result.seen.lines[ray] == "crashed signal 6 (Aborted)");
}

TEST_CASE("of a scene that hangs, not every ray is waited for") {
  const auto all_hang = [](std::size_t) { return 2000.0; };
  RunOptions options = quick();
  options.ask.time = std::chrono::duration<double>(0.1);
  const Result result = run("right", cases(1, all_hang), options);
  for (std::size_t ray = 0; ray < rays_a_case; ++ray)
    CHECK(result.seen.claims[ray].outcome == (ray < 3 ? Outcome::hung : Outcome::unanswered));
  CHECK(result.seen.claims.back().why == "not asked: other rays of the scene hung");
}

TEST_CASE("what a hanging system started ends with it") {
  const auto second_hangs = [](std::size_t ray) { return ray == 1 ? 2000.0 : 1; };
  const auto before = std::chrono::steady_clock::now();
  const Result result = run("forks", cases(1, second_hangs));
  CHECK(result.seen.claims[1].outcome == Outcome::hung);
  CHECK(std::chrono::steady_clock::now() - before < std::chrono::seconds(30));
}

TEST_CASE("a malformed answer is none, and the others stand") {
  const Result result = run("garbage", cases(12, plain));
  std::set<std::size_t> garbled;
  for (std::size_t ray = 310; ray < 320; ++ray) garbled.insert(ray);
  check_right(result.seen, 12, plain, garbled);
  for (const std::size_t ray : garbled) {
    CHECK(result.seen.claims[ray].outcome == Outcome::unanswered);
    CHECK(result.seen.claims[ray].why.starts_with("malformed answer \"Segmentation fault? no, \\x1b"));
  }
  const Result of_long_line = run("long", cases(4, plain));
  check_right(of_long_line.seen, 4, plain, {80, 95});
  CHECK(of_long_line.seen.claims[80].why.size() < 5000);
}

TEST_CASE("of a system that answers more than it is asked nothing is believed") {
  const Folder folder;
  RunOptions options = quick(2);
  options.claims = folder.claims;
  for (const std::string how : {"more", "farewell", "endless"}) {
    INFO(how);
    CHECK_THROWS_WITH(run(how, cases(3, plain), options),
                      Catch::Contains("expected one a ray, so none can be believed"));
    CHECK_FALSE(fs::exists(folder.claims));
  }
}

TEST_CASE("an answer without an end costs its own ray") {
  const Result result = run("drones", cases(4, plain));
  check_right(result.seen, 4, plain, {80});
  CHECK(result.seen.claims[80].outcome == Outcome::unanswered);
}

TEST_CASE("an answer that is left out is waited for") {
  const Result result = run("less", cases(4, plain));
  check_right(result.seen, 4, plain, {80});
  CHECK(result.seen.claims[80].outcome == Outcome::hung);
}

TEST_CASE("a system that does not start, or never answers, is an error that says why") {
  CHECK(failure("preamble") == "nothing is wrong");
  CHECK(failure("silent") == "fake: it does not start, exit status 3; expected a line: system NAME VERSION");
  CHECK(failure("complains") ==
        "fake: it does not start, exit status 1, no licence found; expected a line: system NAME VERSION");
  System absent = fake("right");
  absent.ask = {"/no/such/program"};
  Seen seen;
  CHECK_THROWS_WITH(run_system(absent, cases(1, plain), quick(), seen.sink(), never),
                    "/no/such/program: No such file or directory; expected a program");
  RunOptions options = quick();
  options.ask.time = std::chrono::duration<double>(0.1);
  options.ask.time_to_start = std::chrono::duration<double>(2);
  CHECK_THROWS_WITH(run("unflushed", cases(1, plain), options),
                    "fake: it does not start, no such line in 2 s, though one that was not flushed may wait in its "
                    "buffer; expected a line: system NAME VERSION");
  options.ask.time_to_start = std::chrono::duration<double>(20);
  options.ask.silent_cases = 2;
  CHECK_THROWS_WITH(run("deaf", cases(5, plain), options),
                    "fake: no answer to any ray of 2 scenes in a row, the last generic/0001; expected some");
  options.ask.silent_cases = 1;
  CHECK_THROWS_WITH(run("closes", cases(5, plain), options),
                    "fake: no answer to any ray of 1 scenes in a row, the last generic/0000; expected some");
  CHECK(no_child_is_left());
}

TEST_CASE("a system that takes more memory than it may is ended by it") {
  RunOptions options = quick();
  options.ask.memory = 256 << 20;
  options.ask.time = std::chrono::duration<double>(10);
  const auto greedy_third = [](std::size_t ray) { return ray == 2 ? 501.0 : 1; };
  const Result bounded = run("greedy", cases(1, greedy_third), options);
  CHECK(bounded.seen.lines[2] == "crashed exit status 1");
  CHECK(bounded.seen.lines[3] == "hit - 1");
  CHECK(bounded.end.last_words.find("MemoryError") != std::string::npos);
  options.ask.memory = 0;
  CHECK(run("greedy", cases(1, greedy_third), options).seen.lines[2] == "hit - 501");
}

TEST_CASE("a system works in its own folder, where it has one") {
  const Folder folder;
  System system = fake("where");
  Seen seen;
  CHECK(run_system(system, cases(1, plain), quick(), seen.sink(), never).says ==
        "fake 1.0 " + fs::current_path().string());
  system.setup = fs::canonical(folder.path);
  Seen again;
  CHECK(run_system(system, cases(1, plain), quick(), again.sink(), never).says == "fake 1.0 " + system.setup);
}

TEST_CASE("a ray outside the profile is not asked") {
  RunCases of = cases(2, faulty);
  of.outside = [](const SuiteCase& its_case) {
    std::vector<std::string> clauses;
    for (const scene::Query& ray : its_case.the_case.rays)
      clauses.emplace_back(ray.rayo.p().x() >= 1000 ? "greatest_coordinate" : "");
    return clauses;
  };
  const Result result = run("right", of);
  CHECK(result.end.deaths == 0);
  CHECK(result.seen.lines[50] == "unanswered greatest_coordinate");
  check_right(result.seen, 2, faulty, {50});
}

TEST_CASE("a run that was stopped goes on to the same claims") {
  const Folder folder;
  const RunCases of = cases(12, faulty);
  RunOptions options = quick(2);
  options.claims = folder.claims;
  options.identity = "seed 1";
  const Result whole = run("right", of, options);
  const std::string all(io::read_source(folder.claims).text());
  fs::remove(folder.claims);

  std::atomic<bool> stop = false;
  Seen first;
  const ClaimSink sink = first.sink();
  const RunEnd end = run_system(
      fake("right"), of, options,
      [&](const SuiteCase& its_case, std::span<const Claim> claims) {
        sink(its_case, claims);
        stop = its_case.number >= 4;
      },
      stop);
  CHECK(end.stopped);
  CHECK(end.cases >= 5);
  CHECK(end.cases < 12);

  const std::string part(io::read_source(folder.claims).text());
  CHECK(all.starts_with(part));
  io::write_file(folder.claims, part.substr(0, part.size() - 7));  // the last line is cut off
  options.goes_on = true;
  CHECK(run("right", of, options).seen.lines == whole.seen.lines);
  CHECK(io::read_source(folder.claims).text() == all);
  CHECK(run("complains", of, options).seen.lines == whole.seen.lines);  // nothing is left to ask
}

TEST_CASE("a run goes on only with claims of its own") {
  const Folder folder;
  RunOptions options = quick();
  options.claims = folder.claims;
  options.identity = "seed 1";
  run("right", cases(2, plain), options);
  CHECK_THROWS_AS(run("right", cases(2, plain), options), io::FileError);
  options.goes_on = true;
  options.identity = "seed 2";
  CHECK_THROWS_WITH(run("right", cases(2, plain), options), Catch::Contains("run is \"seed 1\"; expected \"seed 2\""));
  options.identity = "seed 1";
  CHECK_THROWS_WITH(run("buffered", cases(3, plain), options),
                    Catch::Contains("the run was begun with fake 1.0 right"));
  const std::string kept(io::read_source(folder.claims).text());
  std::string changed = kept;
  changed.replace(changed.find("miss"), 4, "mist");
  io::write_file(folder.claims, changed);
  CHECK_THROWS_AS(run("right", cases(2, plain), options), io::InputError);
  changed = kept;
  changed.replace(changed.find("0001"), 4, "0002");
  io::write_file(folder.claims, changed);
  CHECK_THROWS_AS(run("right", cases(2, plain), options), io::InputError);
}
