#pragma once
/// The report of an exploration, as text and as JSON, and its graph as pictures.

#include "durero/spec/explore.hpp"

namespace durero::cli {

/// A number of things: `1 state`, `2 states`.
std::string number_of(std::uint64_t count, const std::string& thing);
/// Lines for people: the counts, the operations, deadlocks, what never happened, and each claim that is false.
std::string explore_text(const spec::Machine& machine, const spec::ExploreReport& report);
/// One JSON object (docs/formats/explore.md). `graph` may be null.
std::string explore_json(const spec::Machine& machine, const spec::ExploreReport& report,
                         const spec::StateGraph* graph);
/// The states and steps in the language of Graphviz.
std::string graph_dot(const spec::Machine& machine, const spec::StateGraph& graph);
/// A drawing of the states in layers by their distance from the initial ones, as SVG.
std::string graph_svg(const spec::Machine& machine, const spec::StateGraph& graph);

}  // namespace durero::cli
