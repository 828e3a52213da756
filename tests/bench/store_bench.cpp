// Stores: durable edits, each beside a sync of the same disk in turn; histories carried out again; scenes opened from
// their snapshots, beside their scene files. Times are of the clock. DURERO_STORE_EVENTS and DURERO_STORE_ELEMENTS say
// how long the history and how large the scene is: without them 10⁵ and 10⁶. DURERO_STORE_SERVER is the URI of a
// PostgreSQL server, on which the stores are made then.

#include <benchmark/benchmark.h>
#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <string>
#include <vector>

#include "durero/io/json/groups_file.hpp"
#include "durero/store/verification.hpp"
#include "support/folder.hpp"
#include "support/scenes.hpp"

using namespace durero;

namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point begin) { return std::chrono::duration<double>(Clock::now() - begin).count(); }

std::size_t asked_for(const char* name, std::size_t otherwise) {
  const char* const said = std::getenv(name);
  return said == nullptr ? otherwise : std::strtoul(said, nullptr, 10);
}

/// The path of a new store.
std::string new_store(const test::Folder& folder) {
  const char* const server = std::getenv("DURERO_STORE_SERVER");
  if (server == nullptr) return folder.file("a.store");
  static int count = 0;
  return fmt::format("{}&options=-csearch_path%3Dbench_{}_{}", server, ::getpid(), ++count);
}

/// Additions that nobody has made yet.
std::string additions(std::size_t count) {
  static std::size_t number = 0;
  std::string script;
  for (; count > 0; --count) script += fmt::format("Agregar_Esfera e?=s{} centro?=(0.25,1.5,-3) radio?=1\n", number++);
  return script;
}

void edit(store::Store& of, const std::string& script) {
  const io::Source lines("script", script);
  of.edit({lines, 0, {"ann", "2026-01-31T12:00:00Z", ""}, false, store::carry_out});
}

/// A page that is written behind a file and synced: what the disk takes for the least that is durable.
class Disk {
 public:
  explicit Disk(const std::string& path) : file_(::open(path.c_str(), O_WRONLY | O_CREAT, 0600)) {}
  ~Disk() { ::close(file_); }
  Disk(const Disk&) = delete;
  Disk& operator=(const Disk&) = delete;

  double sync() {
    const Clock::time_point begin = Clock::now();
    if (::write(file_, page_.data(), page_.size()) < 0 || ::fdatasync(file_) != 0) std::abort();
    return seconds_since(begin);
  }

 private:
  int file_;
  std::string page_ = std::string(4096, 'x');
};

double median(std::vector<double> of) {
  std::ranges::nth_element(of, of.begin() + static_cast<std::ptrdiff_t>(of.size() / 2));
  return of[of.size() / 2];
}

/// Transactions of so many edits, each in turn with a sync: `syncs` is the median of one over that of the other.
void edits(benchmark::State& state) {
  const test::Folder folder;
  const std::string path = new_store(folder);
  store::Store::create(path, {}, "", {});
  store::Store of(path, store::StoreAccess::write);
  Disk disk(folder.file("disk"));
  const auto count = static_cast<std::size_t>(state.range(0));
  std::vector<double> own, syncs;
  for (auto _ : state) {
    const std::string script = additions(count);
    syncs.push_back(disk.sync());
    const Clock::time_point begin = Clock::now();
    edit(of, script);
    own.push_back(seconds_since(begin));
    state.SetIterationTime(own.back());
  }
  state.SetItemsProcessed(state.iterations() * state.range(0));
  state.counters["syncs"] = median(own) / median(syncs);
}

/// All of a history carried out again and checked.
void replay(benchmark::State& state) {
  const test::Folder folder;
  const std::string path = new_store(folder);
  store::Store::create(path, {}, "", {});
  const std::size_t count = asked_for("DURERO_STORE_EVENTS", 100'000);
  {
    store::Store of(path, store::StoreAccess::write);
    for (std::size_t done = 0; done < count; done += 1000) edit(of, additions(1000));
  }
  for (auto _ : state) {
    store::Store of(path, store::StoreAccess::read);
    if (!store::verify(of).is_whole()) std::abort();
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(count));
}

/// A store is opened and its scene is there; `files` is that time over the one that its scene file takes.
void open(benchmark::State& state) {
  const test::Folder folder;
  const std::string path = new_store(folder);
  test::Random random(1);
  const scene::GroupedScene scene{test::random_scene(random, asked_for("DURERO_STORE_ELEMENTS", 1'000'000)), {}};
  store::Store::create(path, scene, "", {});
  const io::Source file("scene.json", io::scene_text(scene.scene, scene.groups));
  const Clock::time_point begin = Clock::now();
  benchmark::DoNotOptimize(io::read_grouped_scene(file));
  const double of_file = seconds_since(begin);
  std::vector<double> own;
  for (auto _ : state) {
    const Clock::time_point opened = Clock::now();
    store::Store of(path, store::StoreAccess::read);
    benchmark::DoNotOptimize(of.state(of.head().event).scene.size());
    own.push_back(seconds_since(opened));
    state.SetIterationTime(own.back());
  }
  state.counters["files"] = median(own) / of_file;
}

}  // namespace

int main(int argc, char** argv) {
  benchmark::RegisterBenchmark("edits", edits)->Arg(1)->Arg(100)->UseManualTime()->Unit(benchmark::kMillisecond);
  benchmark::RegisterBenchmark("replay", replay)->UseRealTime()->Unit(benchmark::kMillisecond);
  benchmark::RegisterBenchmark("open", open)->UseManualTime()->Unit(benchmark::kMillisecond);
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
