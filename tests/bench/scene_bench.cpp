// Checked edits of a scene: pairs of one removal and one addition, in scenes of 10³ and of 10⁶ elements, with contracts
// at their default and ignored. A pair takes away an element drawn at random and puts it back.
//
// DURERO_PAIRS=N runs each benchmark for N pairs exactly; tests/bench/instructions.sh counts with it.

#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <map>
#include <numeric>
#include <random>
#include <vector>

#include "durero/scene/scene.hpp"

using namespace durero;
using contract::evaluation_semantic;

namespace {

struct Pair {
  model::Operation removal, addition;
};

/// The element of this number: a third each of spheres, cylinders and cones, with names of one length.
Pair pair_of(int i) {
  const model::Elemento e(fmt::format("element-{:07}", i));
  const model::Punto centro(i % 1000, i / 1000, 0);
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

Workload& workload(int n) {
  static std::map<int, Workload> kept;
  Workload& w = kept[n];
  if (w.scene.size() != 0) return w;
  for (int i = 0; i < n; ++i) w.scene.apply(pair_of(i).addition);
  std::mt19937 random(1);
  std::uniform_int_distribution<int> any(0, n - 1);
  for (int i = 0; i < 1 << 16; ++i) w.pairs.push_back(pair_of(any(random)));
  return w;
}

/// What is counted. Never inlined, so that callgrind finds it by name.
[[gnu::noinline]] void edit_pair(scene::Scene& scene, const Pair& pair) {
  scene.apply(pair.removal);
  scene.apply(pair.addition);
}

void pairs(benchmark::State& state, evaluation_semantic contracts) {
  Workload& w = workload(static_cast<int>(state.range(0)));
  const contract::scoped_semantic scope(contract::cost::normal, contracts);
  std::size_t i = 0;
  for (auto _ : state) {
    edit_pair(w.scene, w.pairs[i]);
    i = (i + 1) % w.pairs.size();
  }
  state.SetItemsProcessed(state.iterations());
}

void add(const char* name, evaluation_semantic contracts) {
  auto* bench = benchmark::RegisterBenchmark(name, pairs, contracts)->Arg(1000)->Arg(1000000);
  if (const char* exactly = std::getenv("DURERO_PAIRS")) bench->Iterations(std::atol(exactly));
}

}  // namespace

int main(int argc, char** argv) {
  add("pairs/checked", evaluation_semantic::enforce);
  add("pairs/ignored", evaluation_semantic::ignore);
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
