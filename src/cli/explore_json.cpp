#include "durero/conform/format_versions.hpp"
#include "durero/io/json/json_writer.hpp"
#include "explore_text.hpp"

namespace durero::cli {

using io::json::Writer;
using spec::ExploreReport;
using spec::Machine;
using spec::Transition;

namespace {

void write_values(Writer& out, const Machine& machine, const zed::Valuation& values) {
  out.begin_object();
  for (const auto& [name, value] : values) out.member(name.text(), std::string_view(machine.written(name, value)));
  out.end_object();
}

void write_step(Writer& out, const Machine& machine, const Transition& step) {
  out.begin_object().member("operation", std::string_view(step.operation)).key("inputs");
  write_values(out, machine, step.inputs);
  out.key("outputs");
  write_values(out, machine, step.outputs);
  out.key("after");
  write_values(out, machine, step.after);
  out.end_object();
}

void write_way(Writer& out, const Machine& machine, const std::vector<Transition>& way) {
  out.begin_array();
  for (const Transition& step : way) write_step(out, machine, step);
  out.end_array();
}

void write_texts(Writer& out, const char* key, const std::vector<std::string>& texts) {
  out.key(key).begin_array();
  for (const std::string& text : texts) out.value(std::string_view(text));
  out.end_array();
}

void write_operations(Writer& out, const ExploreReport& report) {
  out.key("operations").begin_array();
  for (const spec::OperationCoverage& each : report.operations) {
    out.new_line().begin_object().member("name", std::string_view(each.name));
    out.member("transitions", each.transitions).member("states", each.states).member("evaluated", each.evaluated);
    out.key("predicates").begin_array();
    for (const spec::FactCoverage& fact : each.facts)
      out.begin_object()
          .member("predicate", std::string_view(fact.predicate))
          .member("line", std::uint64_t{fact.place.line})
          .member("true", fact.yes)
          .member("false", fact.no)
          .end_object();
    out.end_array().end_object();
  }
  out.end_array();
}

void write_refuted(Writer& out, const Machine& machine, const ExploreReport& report) {
  out.key("refuted").begin_array();
  for (const spec::FalseClaim& each : report.refuted) {
    out.new_line().begin_object().member("claim", std::string_view(each.claim));
    out.member("place", std::string_view(each.place)).key("way");
    write_way(out, machine, each.way);
    if (each.loop) out.member("loop", std::uint64_t{*each.loop});
    out.end_object();
  }
  out.end_array();
}

void write_graph(Writer& out, const Machine& machine, const spec::StateGraph& graph) {
  out.new_line()
      .key("graph")
      .begin_object()
      .member("initial", std::uint64_t{graph.initial})
      .key("states")
      .begin_array();
  for (const zed::Valuation& state : graph.states) {
    out.new_line();
    write_values(out, machine, state);
  }
  out.end_array().key("steps").begin_array();
  for (const spec::StateGraph::Edge& edge : graph.steps) {
    out.new_line().begin_object().member("from", std::uint64_t{edge.from}).member("to", std::uint64_t{edge.to});
    out.member("operation", std::string_view(edge.step.operation)).key("inputs");
    write_values(out, machine, edge.step.inputs);
    out.key("outputs");
    write_values(out, machine, edge.step.outputs);
    out.end_object();
  }
  out.end_array().end_object();
}

}  // namespace

std::string explore_json(const Machine& machine, const ExploreReport& report, const spec::StateGraph* graph) {
  std::string text;
  Writer out(text);
  write_version(out.begin_object(), conform::explore_format);
  out.member("state", std::string_view(machine.state())).member("init", std::string_view(machine.init()));
  write_texts(out, "given", machine.carriers());
  out.member("states", report.states).member("transitions", report.transitions).member("initial", report.initial);
  out.member("depth", std::uint64_t{report.depth}).member("classes", report.classes);
  write_texts(out, "exchanged", report.exchanged);
  out.member("planned", report.planned).member("stopped", report.stopped);
  write_texts(out, "bounded", report.bounded);
  out.new_line().member("deadlocks", report.deadlocks).key("deadlock_ways").begin_array();
  for (const auto& way : report.deadlock_ways) {
    out.new_line();
    write_way(out, machine, way);
  }
  out.end_array().new_line();
  write_operations(out, report);
  out.new_line().member("claims", report.claims).member("open", report.open);
  write_refuted(out, machine, report);
  if (graph) write_graph(out, machine, *graph);
  out.new_line().end_object();
  return text + "\n";
}

}  // namespace durero::cli
