// Checked edits of a scene: pairs of one removal and one addition, in scenes of 10³ and of 10⁶ elements, with contracts
// at their default and ignored. A pair takes away an element drawn at random and puts it back; or, where the hierarchy
// `bvh` follows, puts it anywhere else, so that the hierarchy is ever less the one that was built. Items are edits, two
// a pair, and their rate is by the processor's time.
//
// DURERO_PAIRS=N runs each benchmark for N pairs exactly; tests/bench/instructions.sh counts with it.

#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <ctime>
#include <map>
#include <numeric>
#include <random>
#include <utility>
#include <vector>

#include "durero/accel/bvh.hpp"
#include "durero/scene/edit.hpp"
#include "durero/scene/scene.hpp"

using namespace durero;
using contract::evaluation_semantic;

namespace {

struct Pair {
  model::Operation removal, addition;
};

/// The element of this number: a third each of spheres, cylinders and cones, with names of one length. It is put back
/// at the place of that number.
Pair pair_of(int i, int at) {
  const model::Elemento e(fmt::format("element-{:07}", i));
  const model::Punto centro(at % 1000, at / 1000, 0);
  const model::Vector axis(0, 0.6, 0.8);
  switch (i % 3) {
    case 0:
      return {model::Eliminar_Esfera{e}, model::Agregar_Esfera{e, centro, 0.5}};
    case 1:
      return {model::Eliminar_Cilindro{e}, model::Agregar_Cilindro{e, centro, 0.5, axis, 2}};
    default:
      return {model::Eliminar_Cono{e}, model::Agregar_Cono{e, centro, 0.25, axis, 2}};
  }
}

/// A scene of n elements and an order in which to take them away, kept for all runs.
struct Workload {
  scene::Scene scene;
  std::vector<Pair> pairs;
};

Workload& workload(int n, bool elsewhere) {
  static std::map<std::pair<int, bool>, Workload> kept;
  Workload& w = kept[{n, elsewhere}];
  if (w.scene.size() != 0) return w;
  for (int i = 0; i < n; ++i) w.scene.apply(pair_of(i, i).addition);
  std::mt19937 random(1);
  std::uniform_int_distribution<int> any(0, n - 1);
  for (int i = 0; i < 1 << 16; ++i) {
    const int number = any(random);
    w.pairs.push_back(pair_of(number, elsewhere ? any(random) : number));
  }
  return w;
}

/// What is counted. Never inlined, so that callgrind finds it by name.
[[gnu::noinline]] void edit_pair(scene::Scene& scene, const Pair& pair) {
  scene.apply(pair.removal);
  scene.apply(pair.addition);
}

void pairs(benchmark::State& state, evaluation_semantic contracts) {
  Workload& w = workload(static_cast<int>(state.range(0)), false);
  const contract::scoped_semantic scope(contract::cost::normal, contracts);
  std::size_t i = 0;
  for (auto _ : state) {
    edit_pair(w.scene, w.pairs[i]);
    i = (i + 1) % w.pairs.size();
  }
  state.SetItemsProcessed(2 * state.iterations());
}

scene::ElementRef place(const scene::Scene& scene, const model::Operation& operation) {
  return *scene.find(scene::name_of(operation).name());
}

/// Of the processor, for one edit of a scene that nothing follows.
double seconds_alone(Workload& w) {
  const std::clock_t start = std::clock();
  for (const Pair& pair : w.pairs) edit_pair(w.scene, pair);
  return double(std::clock() - start) / CLOCKS_PER_SEC / double(2 * w.pairs.size());
}

/// With the bytes an element that the hierarchy takes at the end, how much its cost has grown, and how many times what
/// the edits alone take they take where it follows.
void followed(benchmark::State& state) {
  Workload& w = workload(static_cast<int>(state.range(0)), true);
  const double alone = seconds_alone(w);
  accel::Bvh bvh(w.scene);
  const double cost = accel::weight<double>(bvh.hierarchy());
  std::size_t i = 0;
  const std::clock_t start = std::clock();
  for (auto _ : state) {
    const auto& [removal, addition] = w.pairs[i];
    const scene::ElementRef gone = place(w.scene, removal);
    w.scene.apply(removal);
    bvh.removed(gone);
    w.scene.apply(addition);
    bvh.added(place(w.scene, addition));
    i = (i + 1) % w.pairs.size();
  }
  const double edits = 2 * double(state.iterations());
  state.counters["ratio"] = double(std::clock() - start) / CLOCKS_PER_SEC / edits / alone;
  state.SetItemsProcessed(2 * state.iterations());
  state.counters["bytes"] = static_cast<double>(bvh.size().bytes) / static_cast<double>(w.scene.size());
  state.counters["cost"] = accel::weight<double>(bvh.hierarchy()) / cost;
}

template <class... Arguments>
void add(const char* name, Arguments... of) {
  auto* bench = benchmark::RegisterBenchmark(name, of...)->Arg(1000)->Arg(1000000);
  if (const char* exactly = std::getenv("DURERO_PAIRS")) bench->Iterations(std::atol(exactly));
}

}  // namespace

int main(int argc, char** argv) {
  add("pairs/checked", pairs, evaluation_semantic::enforce);
  add("pairs/ignored", pairs, evaluation_semantic::ignore);
  add("pairs/followed", followed);
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
