// Pictures of 1280 × 720 by the shader of demo/gallery/shader.json, ten balls on a floor of p6m with one light, drawn
// by software without a window (target: 30 a second): as it is, with its glass as a mirror alone, and the answers with
// their certificates. The program's name for what draws stands in the label.
#include <benchmark/benchmark.h>

#include "durero/io/json/scene_file.hpp"
#include "durero/io/source.hpp"
#include "durero/scene/stage.hpp"
#include "shader/offscreen.hpp"

using namespace durero;

namespace {

scene::Scene ten_balls(bool has_glass) {
  scene::Scene scene = io::read_scene(io::read_source(DURERO_SOURCE_DIR "/demo/gallery/shader.json"));
  if (!has_glass)
    for (scene::Material& m : scene.stage().materials) m.k_t = 0;
  return scene;
}

void draw(benchmark::State& state, bool has_glass, shader::ShaderOutput output) {
  const scene::Scene scene = ten_balls(has_glass);
  const scene::PrimaryRays rays(*scene.stage().camera, {1280, 720});
  const test::Offscreen offscreen;
  test::DrawnShader shader(shader::fragment_shader(scene, output), output == shader::ShaderOutput::answer);
  shader.draw(rays);  // compiles to the end
  for (auto _ : state) shader.draw(rays);
  state.counters["pictures/s"] =
      benchmark::Counter(static_cast<double>(state.iterations()), benchmark::Counter::kIsRate);
  state.SetLabel(offscreen.renderer());
}

void ten_balls_with_glass(benchmark::State& state) { draw(state, true, shader::ShaderOutput::color); }
void ten_balls_without_glass(benchmark::State& state) { draw(state, false, shader::ShaderOutput::color); }
void answers(benchmark::State& state) { draw(state, true, shader::ShaderOutput::answer); }
BENCHMARK(ten_balls_with_glass)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime()->UseRealTime();
BENCHMARK(ten_balls_without_glass)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime()->UseRealTime();
BENCHMARK(answers)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime()->UseRealTime();

}  // namespace

BENCHMARK_MAIN();
