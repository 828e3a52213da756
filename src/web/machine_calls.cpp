// Z texts stepped through as machines, as `durero spec run` does.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>

#include "asked_machine.hpp"
#include "calls.hpp"
#include "durero/spec/animation_text.hpp"
#include "durero/text/shown.hpp"
#include "machine_text.hpp"

namespace durero::web {
namespace {

using spec::Machine;
using spec::MachineOperation;
using spec::ReachedTransitions;
using spec::Transition;

constexpr std::array<std::string_view, 6> run_keys{"text", "name", "setup", "way", "step", "look"};
constexpr std::array<std::string_view, 5> graph_keys{"text", "name", "setup", "way", "most"};
constexpr std::array<std::string_view, 2> step_keys{"operation", "inputs"};

/// The step that a call asks for.
struct AskedStep {
  const MachineOperation* operation = nullptr;
  zed::Valuation inputs{};
};

zed::Valuation inputs_of(io::json::Reader& in, const Machine& machine, const MachineOperation& operation) {
  zed::Valuation inputs;
  in.members("inputs", [&](const io::json::Key& key) {
    const auto input =
        std::ranges::find_if(operation.inputs, [&](const zed::Name& name) { return name.text() == key.name; });
    if (input == operation.inputs.end())
      in.fail(key.offset, fmt::format("{} is no input of {}", text::shown(key.name), operation.name),
              "expected x? and a value for an input x?");
    const std::size_t at = in.offset();
    try {
      inputs.emplace_back(*input, asking([&] { return machine.typed(std::string(in.string("an input")), *input); }));
    } catch (const zed::ZError& error) {
      in.fail(at, fmt::format("{}: {}", input->text(), error.what_is_wrong), error.expected);
    }
  });
  return inputs;
}

AskedStep step_of(const AskedCall& asked, const Machine& machine) {
  AskedStep step;
  io::json::Reader in = asked.at("step");
  in.object("step", step_keys, 1, [&](std::size_t key) {
    if (key == 0) {
      const std::size_t at = in.offset();
      const std::string name(in.string("operation"));
      step.operation = machine.find(name);
      if (step.operation == nullptr)
        in.fail(at, fmt::format("no operation is called {}", text::shown(name)), "expected one of the text");
    }
    if (key == 1) {
      if (step.operation == nullptr)
        in.fail(in.offset(), "the inputs stand before the operation", "expected them behind it");
      step.inputs = inputs_of(in, machine, *step.operation);
    }
  });
  return step;
}

/// The ways to go on that a question has found.
struct FoundWays {
  std::optional<ReachedTransitions> reached{};  ///< nothing where none was asked for
  std::string refused{};                        ///< the operation, or the initial schema, that leads nowhere
};

FoundWays ways_on(const AskedCall& asked, const Machine& machine, const spec::Animation& way, std::size_t choices) {
  FoundWays found;
  if (way.now() == nullptr) {
    if (asked.has("step"))
      asked.source().fail(asked.at("step").offset(), "there is no state yet", "expected way beside step");
    found.reached = asking([&] { return machine.initial(choices); });
    if (found.reached->transitions.empty()) found.refused = "no initial state is found";
  } else if (asked.has("step")) {
    const AskedStep step = step_of(asked, machine);
    found.reached = asking([&] { return machine.steps(*way.now(), *step.operation, step.inputs, choices); });
    if (found.reached->transitions.empty()) found.refused = step.operation->name + " cannot go on here";
  }
  return found;
}

/// The note on ways that were left out, in the words of `durero spec run`.
std::string left_out(const std::optional<ReachedTransitions>& ways) {
  if (!ways) return "";
  if (!ways->bounded.empty()) return "more may be found with a greater " + ways->bounded;
  if (!ways->undecided) return "";
  if (ways->tried.empty()) return "there may be other ways: equations do not give them";
  return fmt::format("there may be other ways: some values of {} were tried, as --numbers bounds them",
                     spec::name_list(ways->tried));
}

}  // namespace

std::string answer_zed_run(const AskedCall& asked) {
  asked.require(run_keys, 0);
  const auto [machine, choices] = machine_of(asked);
  spec::Animation way(*machine);
  go_way(asked, way);
  FoundWays found = ways_on(asked, *machine, way, choices);
  if (found.reached && found.reached->transitions.size() == 1) {
    way.take(found.reached->transitions.front());
    found.reached->transitions.clear();
  }
  ObjectText answer;
  add_machine(answer, *machine);
  answer.raw("operations", operations_text(*machine, way.now(), asked.flag("look", asked.has("text"))))
      .member("way", way.now() == nullptr ? "" : way.saved())
      .raw("states", states_text(*machine, way))
      .raw("invariant", way.now() == nullptr ? "[]" : invariant_text(*machine, *way.now()))
      .raw("ways", !found.reached ? "[]"
                                  : array_of(found.reached->transitions,
                                             [&](const Transition& step) { return way_on_text(*machine, way, step); }))
      .raw("refused", found.refused.empty() ? "null" : json_of(found.refused))
      .member("left_open", left_out(found.reached));
  return answer.raw("conjectures", way.now() == nullptr ? "[]" : claims_text(*machine, way)).text();
}

std::string answer_zed_graph(const AskedCall& asked) {
  asked.require(graph_keys, 0);
  const auto [machine, choices] = machine_of(asked);
  spec::Animation way(*machine);
  go_way(asked, way);
  spec::StateGraph graph;
  const spec::Exploration found =
      asking([&] { return spec::explore(*machine, way.way(), asked.whole("most", 1, 10'000, 100), &graph); });
  ArrayText states;
  for (std::size_t i = 0; i < graph.states.size(); ++i)
    states.raw(
        ObjectText().member("initial", i < graph.initial).raw("values", values_text(*machine, graph.states[i])).text());
  const auto edge_text = [&](const spec::StateGraph::Edge& edge) {
    return ObjectText()
        .member("from", std::uint64_t{edge.from})
        .member("to", std::uint64_t{edge.to})
        .member("operation", edge.step.operation)
        .member("line", spec::step_line(*machine, edge.step))
        .text();
  };
  ObjectText answer;
  add_machine(answer, *machine);
  return answer.raw("states", states.text())
      .raw("steps", array_of(graph.steps, edge_text))
      .raw("bounded", array_of_texts(found.bounded))
      .member("tried", std::uint64_t{found.claims})
      .member("open", std::uint64_t{found.open})
      .raw("refuted", found.refuted ? json_of(found.refuted->claim) : "null")
      .raw("way",
           !found.refuted
               ? "[]"
               : array_of(found.way, [&](const Transition& step) { return json_of(spec::step_line(*machine, step)); }))
      .text();
}

}  // namespace durero::web
