// durero spec eval EXPR [--scene SCENE] [--steps N] [--memory MIB]: the value of an expression, or whether a predicate
// holds.
#include <fmt/format.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <new>
#include <optional>

#include "durero/io/json/scene_file.hpp"
#include "durero/io/standard_output.hpp"
#include "durero/model/escena.hpp"
#include "durero/number/memory.hpp"
#include "durero/scene/retrieve.hpp"
#include "durero/spec/calculator.hpp"
#include "durero/spec/refusal.hpp"
#include "progress.hpp"
#include "spec.hpp"

namespace durero::cli {
namespace {

constexpr const char* file_name = "EXPR";
constexpr std::uint64_t mib = std::uint64_t{1} << 20U;

/// The bytes that the program's data take now (proc(5): the sixth number of statm, in pages); 0 where it is not known.
std::uint64_t data_now() {
  std::ifstream statm("/proc/self/statm");
  std::uint64_t pages = 0;
  for (int field = 1; field <= 6 && statm; ++field) statm >> pages;
  return statm ? pages * static_cast<std::uint64_t>(sysconf(_SC_PAGESIZE)) : 0;
}

spec::Calculator calculator_of(const EvalCall& call) {
  if (!call.files.empty()) return spec::Calculator(specification_of(call.files));
  if (call.scene.empty()) return {};
  return spec::Calculator(scene::retrieve(io::read_scene(io::read_source(call.scene))));
}

spec::Calculator calculator(const EvalCall& call) {
  spec::Calculator text = calculator_of(call);
  with_constants([&] { text.let(call.let); });
  try {
    note_taken(text.scope(call.scope));
  } catch (const spec::ConstantError& error) {
    throw io::InputError("--scope", {error.place.line, error.place.column}, error.what_is_wrong, error.expected);
  }
  return text;
}

/// The expectation of an error about an undeclared name: a state gives components of Escena their values.
std::string expected_name(const zed::ZError& error, const EvalCall& call) {
  const std::string name = error.what_is_wrong.substr(0, error.what_is_wrong.find(" is not declared"));
  if (!call.files.empty() || !call.scene.empty()) return error.expected;
  for (const auto& [component, value] : spec::components(model::Init()))
    if (component.text() == name) return fmt::format("expected --scene FILE, whose state has {}", name);
  return error.expected;
}

[[noreturn]] void give_up(const char* what, std::uint64_t most, const char* unit, std::uint64_t taken) {
  throw io::InputError(file_name, {1, 1},
                       fmt::format("{} {}{} did not do: stopped after {} steps", what, most, unit, taken),
                       fmt::format("expected a smaller expression, or a greater {}", what));
}

}  // namespace

std::uint64_t default_memory() {
  const auto pages = sysconf(_SC_PHYS_PAGES), size = sysconf(_SC_PAGESIZE);
  if (pages <= 0 || size <= 0) return 4096;
  return std::min<std::uint64_t>(4096, static_cast<std::uint64_t>(pages) * static_cast<std::uint64_t>(size) / mib / 2);
}

void bound_memory(std::uint64_t mebibytes) {
  const std::uint64_t bytes = (mebibytes == 0 ? default_memory() : mebibytes) * mib;
  number::throw_when_numbers_outgrow_memory(bytes / 128);
  rlimit limit{};
  getrlimit(RLIMIT_DATA, &limit);
  limit.rlim_cur = std::min<rlim_t>(limit.rlim_max, data_now() + bytes);
  setrlimit(RLIMIT_DATA, &limit);
}

int spec_eval(const EvalCall& call) {
  if (!call.files.empty() && !call.scene.empty())
    throw io::InputError("--scene", {1, 1}, "a scene is a state of the program's own text",
                         "expected no FILES beside it");
  const std::uint64_t memory = call.memory == 0 ? default_memory() : call.memory;
  zed::Steps steps(call.steps);
  try {
    const spec::Calculator text = calculator(call);
    std::optional<Progress> progress(std::in_place, call.quiet, "spec eval");
    bound_memory(memory);
    const std::string tree = call.explain ? text.explain(call.expression, steps) : "";
    std::optional<zed::SmtProgram> solver;
    if (!call.solver.program.empty()) solver = solver_program(call.solver);
    const auto result = text.evaluate(call.expression, steps, {}, solver ? &*solver : nullptr);
    progress.reset();
    note_taken(spec::taken_lines(result.taken));
    if (!result.solved.empty()) note_taken({result.solved});
    io::print(call.explain ? tree : result.text + "\n");
    return result.yes ? 0 : 1;
  } catch (const zed::ZError& error) {
    throw io::InputError(file_name, {error.place.line, error.place.column}, error.what_is_wrong,
                         expected_name(error, call));
  } catch (const zed::EvaluationError& error) {
    const auto [wrong, expected] = spec::refusal_of(error);
    throw io::InputError(file_name, {1, 1}, wrong, expected);
  } catch (const zed::StepsSpent&) {
    give_up("--steps", steps.most(), "", steps.most());
  } catch (const std::bad_alloc&) {
    give_up("--memory", memory, " MiB", steps.taken());
  }
}

}  // namespace durero::cli
