// A store over HTTP: edits of one operation, each durable when it is answered, from 1 and from 50 clients at a time,
// beside syncs of the same disk. DURERO_SERVE_SECONDS says how long each takes: without it 5.

#include <benchmark/benchmark.h>
#include <fcntl.h>
#include <fmt/format.h>
#include <httplib.h>
#include <unistd.h>

#include <atomic>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <thread>
#include <vector>

#include "durero/serve/server.hpp"
#include "durero/store/store.hpp"
#include "support/folder.hpp"

using namespace durero;

namespace {

using Clock = std::chrono::steady_clock;

double seconds_of_each() {
  const char* const said = std::getenv("DURERO_SERVE_SECONDS");
  return said == nullptr ? 5 : std::strtod(said, nullptr);
}

/// How many pages are synced in a second, one behind the other.
double syncs_per_second(const std::string& path) {
  const int file = ::open(path.c_str(), O_WRONLY | O_CREAT, 0600);
  const std::string page(4096, 'x');
  constexpr int count = 100;
  const Clock::time_point begin = Clock::now();
  for (int i = 0; i < count; ++i)
    if (::write(file, page.data(), page.size()) < 0 || ::fdatasync(file) != 0) std::abort();
  ::close(file);
  return count / std::chrono::duration<double>(Clock::now() - begin).count();
}

/// Edits of so many clients; `lost` is what was accepted and is not in the store behind the server.
void edits(benchmark::State& state) {
  const test::Folder folder;
  const std::string path = folder.file("a.store");
  for (auto _ : state) {
    std::filesystem::remove(path);
    store::Store::create(path, {}, "", {});
    serve::Server server(path, {});
    std::thread running([&] { server.run(); });
    std::atomic<std::int64_t> accepted = 0;
    const Clock::time_point begin = Clock::now();
    std::vector<std::thread> clients;
    for (std::int64_t c = 0; c < state.range(0); ++c)
      clients.emplace_back([&, c] {
        httplib::Client client("127.0.0.1", server.port());
        client.set_keep_alive(true);
        client.set_tcp_nodelay(true);
        for (int i = 0; std::chrono::duration<double>(Clock::now() - begin).count() < seconds_of_each(); ++i) {
          const std::string body =
              fmt::format(R"({{"operations":["Agregar_Esfera e?=c{}-{} centro?=(0,0,5) radio?=1"]}})", c, i);
          const auto answer = client.Post("/edits", body, "application/json");
          if (answer && answer->body.find("\"ok\":true") != std::string::npos) ++accepted;
        }
      });
    for (std::thread& client : clients) client.join();
    const double seconds = std::chrono::duration<double>(Clock::now() - begin).count();
    server.stop();
    running.join();
    store::Store of(path, store::StoreAccess::read);
    state.SetIterationTime(seconds);
    state.counters["edits/s"] = static_cast<double>(accepted) / seconds;
    state.counters["lost"] =
        static_cast<double>(accepted) - static_cast<double>(of.state(of.head().event).scene.size());
    state.counters["syncs/s"] = syncs_per_second(folder.file("disk"));
  }
}

}  // namespace

int main(int argc, char** argv) {
  benchmark::RegisterBenchmark("edits", edits)
      ->Arg(1)
      ->Arg(50)
      ->Iterations(1)
      ->UseManualTime()
      ->Unit(benchmark::kSecond);
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
