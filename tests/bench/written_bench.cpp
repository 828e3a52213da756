// Rays by a Z text: three spheres by the text of spec/ (target 10 000 rays/s), three tori by demo/surfaces/torus.tex
// (target 1 000 rays/s), each ray asked of all three, on one thread.
#include <benchmark/benchmark.h>

#include "durero/written/engine.hpp"
#include "support/scenes.hpp"

using namespace durero;

namespace {

constexpr std::string_view head = R"({"format":"durero-scene","version":1,"elementos":[)";

/// Half of them meet some element.
std::vector<scene::Query> rays() {
  test::Random random(1);
  std::vector<scene::Query> rays;
  for (int i = 0; i < 1000; ++i) {
    const glm::dvec3 aim = random.in_cube(1);
    rays.push_back({{model::Punto(random.in_cube(1)), model::Vector(glm::dvec3(0.4 * aim.x, 0.4 * aim.y, 1))}});
  }
  return rays;
}

void trace(benchmark::State& state, const std::string& elements, const std::string& text) {
  const io::Source source("scene.json", std::string(head) + elements + "]}");
  const written::Written written = written::read(source, written::Text(DURERO_SOURCE_DIR + text));
  const std::vector<scene::Query> all = rays();
  std::size_t hits = 0, next = 0;
  for (auto _ : state) {
    const scene::Hit hit = engine::first_hit(*written.engine, all[next++ % all.size()]);
    hits += hit.resultado == model::Resultado::hit ? 1 : 0;
  }
  state.SetItemsProcessed(state.iterations());
  state.counters["hits"] = static_cast<double>(hits) / static_cast<double>(next);
}

void spheres(benchmark::State& state) {
  trace(state, R"({"id":"a","tipo":"esfera","centro":[0,0,5],"radio":1.3},
                  {"id":"b","tipo":"esfera","centro":[1.7,0.4,6.1],"radio":1.1},
                  {"id":"c","tipo":"esfera","centro":[-1.1,-0.7,4.3],"radio":0.9})",
        "/spec/puntos.tex");
}
BENCHMARK(spheres)->Unit(benchmark::kMicrosecond);

void tori(benchmark::State& state) {
  trace(state, R"({"id":"a","tipo":"toro","centro":[0,0,5],"mayor":1.3,"menor":0.4},
                  {"id":"b","tipo":"toro","centro":[1.7,0.4,6.1],"mayor":1.1,"menor":0.3},
                  {"id":"c","tipo":"toro","centro":[-1.1,-0.7,4.3],"mayor":0.9,"menor":0.2})",
        "/demo/surfaces/torus.tex");
}
BENCHMARK(tori)->Unit(benchmark::kMicrosecond);

}  // namespace

BENCHMARK_MAIN();
