// The Z text at work: reading and type-checking it whole (spec check, target 0.2 s), and deciding transitions of a
// scene of ten elements (target 20 000/s), with and without making the text's values of the program's.
#include <benchmark/benchmark.h>

#include "durero/model/operaciones.hpp"
#include "durero/scene/retrieve.hpp"
#include "durero/spec/explore.hpp"
#include "durero/spec/spec.hpp"
#include "durero/zed/types/typecheck.hpp"
#include "support/scenes.hpp"

using namespace durero;

namespace {

/// The birthday book with six names and four dates: 15,625 states (target 50,000 states a second).
spec::Setup book_of_six() {
  spec::Setup setup;
  setup.given["NAME"] = {"ann", "bob", "cyd", "dan", "eve", "fay"};
  setup.members = 4;
  return setup;
}

void explore(benchmark::State& state) {
  const spec::Machine machine(zed::read_files({DURERO_BOOK}), book_of_six());
  spec::ExploreBounds bounds;
  bounds.symmetry = state.range(0) != 0;
  std::uint64_t states = 0;
  for (auto _ : state) {
    spec::StateSpace space(machine, bounds);
    states += space.explore().states;
  }
  state.SetItemsProcessed(static_cast<std::int64_t>(states));
}
BENCHMARK(explore)->ArgName("symmetry")->Arg(0)->Arg(1)->Unit(benchmark::kMillisecond);

/// Steps of the book that are given whole (target 50,000 a second).
void admit(benchmark::State& state) {
  const spec::Machine machine(zed::read_files({DURERO_BOOK}), book_of_six());
  spec::ExploreBounds bounds;
  bounds.states = 1000;
  spec::StateSpace space(machine, bounds);
  space.explore();
  const auto before = space.state(space.size() / 2);
  const auto steps = space.steps_from(space.size() / 2);
  for (auto _ : state)
    for (const auto& [step, to] : steps)
      if (!space.admits(before, step)) state.SkipWithError("the text refuses a step that it gave");
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(steps.size()));
}
BENCHMARK(admit);

void check_text(benchmark::State& state) {
  for (auto _ : state) {
    const zed::Specification read = zed::read_texts(spec::files());
    benchmark::DoNotOptimize(zed::check(read).ok());
  }
}
BENCHMARK(check_text)->Unit(benchmark::kMillisecond);

struct Transition {
  model::Escena before, after;
  model::Operation operation;
  model::Respuesta r;
  spec::OperationStep step() const { return {before, operation, r, after}; }
};

Transition addition_to_ten() {
  test::Random random(1);
  const model::Escena before = scene::retrieve(test::random_scene(random, 10));
  const model::Operation operation = test::random_addition(random, "e10");
  model::Escena after = before;
  const model::Respuesta r = model::apply(after, operation);
  return {before, after, operation, r};
}

void transition(benchmark::State& state) {
  const Transition one = addition_to_ten();
  const spec::Judge judge;
  for (auto _ : state) {
    if (!judge.holds(one.step())) state.SkipWithError("the text refuses a right transition");
  }
  state.SetItemsProcessed(state.iterations());
}
BENCHMARK(transition);

void transition_of_values(benchmark::State& state) {
  const Transition one = addition_to_ten();
  const spec::Judge judge;
  const zed::SchemaCheck schema = judge.evaluator().schema({spec::schema_name(one.operation), ""});
  const auto values = spec::in_order(schema.components(), spec::named(one.step()));
  for (auto _ : state) benchmark::DoNotOptimize(schema.holds(values));
  state.SetItemsProcessed(state.iterations());
}
BENCHMARK(transition_of_values);

void total_transition(benchmark::State& state) {
  const Transition one = addition_to_ten();
  const spec::Judge judge;
  for (auto _ : state) benchmark::DoNotOptimize(judge.holds_total(one.step()));
  state.SetItemsProcessed(state.iterations());
}
BENCHMARK(total_transition);

void point_of_cone(benchmark::State& state) {
  const spec::Judge judge;
  const zed::Value cone =
      judge.evaluator().apply(judge.evaluator().value(zed::Name{"puntos_cono", ""}),
                              zed::Value::tuple({spec::value(model::Punto(0.1, 0.2, 0.3)), zed::Real(0.5),
                                                 spec::value(model::Vector(0, 0, 1)), zed::Real(1)}));
  const zed::Value point = spec::value(model::Punto(0.6, 0.2, 0.3));
  for (auto _ : state) benchmark::DoNotOptimize(judge.evaluator().contains(cone, point));
  state.SetItemsProcessed(state.iterations());
}
BENCHMARK(point_of_cone);

}  // namespace

BENCHMARK_MAIN();
