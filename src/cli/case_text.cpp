// The tests of a text, for people and as JSON.
#include <fmt/format.h>

#include <algorithm>

#include "durero/io/json/json_writer.hpp"
#include "durero/spec/animation_text.hpp"
#include "explore_text.hpp"
#include "spec_cases.hpp"

namespace durero::cli {

using io::json::Writer;
using spec::Machine;
using spec::OperationCase;
using spec::OperationCases;

namespace {

std::string case_name(const OperationCase& each) {
  std::string sides;
  for (const std::string& side : each.disjuncts) sides += (sides.empty() ? "" : "; ") + side;
  return each.operation + (sides.empty() ? "" : ": " + sides);
}

void write_components(Writer& out, const Machine& machine, const zed::Valuation& values) {
  out.begin_object();
  for (const auto& [name, value] : values) out.member(name.text(), std::string_view(machine.written(name, value)));
  out.end_object();
}

void write_example(Writer& out, const Machine& machine, const OperationCase& each) {
  out.key("before");
  write_components(out, machine, each.way.back().after);
  out.key("inputs");
  write_components(out, machine, each.inputs);
  out.key("admitted").begin_array();
  for (const spec::Transition& step : each.admitted) {
    out.begin_object().key("outputs");
    write_components(out, machine, step.outputs);
    out.key("after");
    write_components(out, machine, step.after);
    out.end_object();
  }
  out.end_array().key("way").begin_array();
  for (const spec::Transition& step : each.way) out.value(std::string_view(spec::step_line(machine, step)));
  out.end_array();
}

void write_case_list(Writer& out, const char* key, const std::vector<std::string>& texts) {
  out.key(key).begin_array();
  for (const std::string& text : texts) out.value(std::string_view(text));
  out.end_array();
}

}  // namespace

std::string cases_text(const Machine& machine, const OperationCases& cases) {
  const auto found =
      std::count_if(cases.cases.begin(), cases.cases.end(), [](const auto& each) { return each.is_found; });
  std::string said = fmt::format("{} of {}, {} with an example\n", number_of(cases.cases.size(), "case"),
                                 number_of(machine.operations().size(), "operation"), found);
  for (const std::string& carrier : machine.carriers()) said += "  " + carrier + "\n";
  for (const std::string& bound : cases.bounded) said += "  bounded: " + bound + "\n";
  for (const std::string& whole : cases.whole) said += "  not taken apart: " + whole + "\n";
  for (const OperationCase& each : cases.cases) {
    said += (each.is_found ? "case        " : "infeasible  ") + case_name(each) + "\n";
    if (!each.is_found) continue;
    said += spec::step_line(machine, each.admitted.front()) + "\n" +
            spec::state_table(machine, &each.way.back().after, each.admitted.front().after);
    if (each.admitted.size() > 1) said += "  or " + number_of(each.admitted.size() - 1, "other answer") + "\n";
  }
  return said;
}

std::string cases_json(const Machine& machine, const OperationCases& cases) {
  std::string text;
  Writer out(text);
  out.begin_object().member("format", "durero-spec-tests").member("version", std::uint64_t{1});
  out.member("state", std::string_view(machine.state()));
  write_case_list(out, "given", machine.carriers());
  write_case_list(out, "bounded", cases.bounded);
  write_case_list(out, "whole", cases.whole);
  out.key("cases").begin_array();
  for (const OperationCase& each : cases.cases) {
    out.new_line().begin_object().member("operation", std::string_view(each.operation));
    write_case_list(out, "disjuncts", each.disjuncts);
    out.member("feasible", each.is_found);
    if (each.is_found) write_example(out, machine, each);
    out.end_object();
  }
  out.end_array().new_line().end_object();
  return text + "\n";
}

}  // namespace durero::cli
